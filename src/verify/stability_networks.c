/* SPDX-License-Identifier: MIT */
/* The time step: 1000 small networks of disks, thrown at random, whose contacts neither open nor slip.
 *
 * The leapfrog takes damping at the half step before, M (x'' - 2x' + x) + dt C (x' - x) + dt^2 K x' = 0 for x, x', x'' at
 * three instants. For an eigenvector, (z - 1)^2 m + dt c (z - 1) + dt^2 k z = 0 with m, c, k > 0: the first root to leave
 * the unit circle does so at z = -1, where 4 m = 2 dt c + dt^2 k. So it is stable if and only if
 *
 *   4 M - 2 dt C - dt^2 K   is positive definite                                                     [Irons1971]
 *
 * and the exact limit follows by bisection, each trial by Cholesky's factors: no line of core/timestep.c is in it. Beyond
 * the limit, without damping, the energy of the worst mode grows by (f + sqrt(f^2 - 1))^4 a step, f = dt/limit.
 *
 * Each disk carries a load that balances its contacts, 1e-5 R deep, and gets a velocity that moves it 1e-11 R in a step:
 * forces are those of frozen springs. That the contacts turn under their force adds P/L = 1e-5 k_n at most. */
#include "base/alloc.h"
#include "base/random.h"
#include "core/step.h"
#include "core/timestep.h"
#include "verify/stability.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NETWORKS = 1000, MOST = 12, DOF = 3 * MOST, STEPS = 400 };
static const double LAP = 1e-5, TINY = 1e-11,
                    GROWN =
                        1e3; /* GROWN: of energy; near the limit a stable mode swings to 1/(1 - f^2), 50 at f = 0.99 */

typedef struct network {
    tr_world w;
    double k_n, k_t, k_r, zeta;
    bool conjugate; /* bagi-kuhn-conjugate in the place of wang-spring */
    double K[DOF][DOF], C[DOF][DOF];
} network;

static double among(tr_random *r, double low, double high) { /* evenly in the logarithm */
    return low * pow(high / low, tr_random_uniform(r));
}

/* ---- the disks */

static double gap(const tr_world *w, int i, int n) {
    double least = INFINITY;
    const double *p = w->disks.pos + 4 * (size_t)i;
    for (int j = 0; j < n; j++) {
        const double *q = w->disks.pos + 4 * (size_t)j;
        if (j != i) least = fmin(least, hypot(p[0] - q[0], p[1] - q[1]) - p[3] - q[3]);
    }
    return least;
}

/* Disk i touches disk j, and j2 if they are close enough; false: there is no room there. */
static bool place(tr_world *w, tr_random *r, int i, double R, double density, double lap, bool held) {
    int j = (int)(tr_random_uniform(r) * i), j2 = (int)(tr_random_uniform(r) * i);
    const double *p = w->disks.pos + 4 * (size_t)j, *q = w->disks.pos + 4 * (size_t)j2;
    double angle = 2 * M_PI * tr_random_uniform(r), d = hypot(q[0] - p[0], q[1] - p[1]);
    double a = p[3] + R - lap, b = q[3] + R - lap, c = (d * d + a * a - b * b) / (2 * a * d);
    if (j != j2 && fabs(c) < 1) angle = atan2(q[1] - p[1], q[0] - p[0]) + acos(c);
    tr_world_set_disk(w, i, p[0] + a * cos(angle), p[1] + a * sin(angle), 0, R, density, held);
    return gap(w, i, i) > -1.5 * lap; /* no deeper than the two it touches */
}

static bool throw_disks(network *net, tr_random *r, tr_status *st) {
    int n = 2 + (int)(tr_random_uniform(r) * (MOST - 1)), placed = 1;
    double lap = LAP * 1e-3, density = among(r, 1e2, 1e4);
    bool held = tr_random_uniform(r) < 0.25;
    if (!tr_world_init(&net->w, n, TR_SHAPE_DISK, st)) return false;
    tr_world_set_disk(&net->w, 0, 0, 0, 0, among(r, 1e-3, 1e-2), density, held);
    while (placed < n) placed += place(&net->w, r, placed, among(r, 1e-3, 1e-2), among(r, 1e2, 1e4), lap, false);
    if (tr_random_uniform(r) < 0.5) { /* a floor under the lowest */
        double lowest = INFINITY;
        for (int i = 0; i < n; i++) lowest = fmin(lowest, net->w.disks.pos[4 * i + 1] - net->w.disks.pos[4 * i + 3]);
        net->w.wall[net->w.n_walls++] = (tr_wall){.y = lowest + lap, .ny = 1};
    }
    return true;
}

/* ---- the matrices, M^-1/2 K M^-1/2 and so for C, from the definitions of the velocities */

static void add(network *net, double X[DOF][DOF], double k, int ia, const double *ja, int ib, const double *jb) {
    double row[DOF] = {0};
    for (int l = 0; l < 3; l++) {
        if (ia >= 0) row[3 * ia + l] = ja[l] * sqrt(net->w.disks.inv[4 * ia + l]);
        row[3 * ib + l] += jb[l] * sqrt(net->w.disks.inv[4 * ib + l]);
    }
    for (int i = 0; i < DOF; i++)
        for (int j = 0; j < DOF; j++) X[i][j] += k * row[i] * row[j];
}

/* Vn = V21.n, Vs = V21.t + r1 w1 + r2 w2, V_r = R_eff (w1 - w2), for the conjugate law + (R1 - R2)/(2L) Vs. */
static void add_contact(network *net, int a, int b, const double n[2], double r1, double r2, double R1, double R2) {
    double R_eff = a < 0 ? R2 : R1 * R2 / (R1 + R2),
           along = net->conjugate ? (a < 0 ? 0.5 : (R1 - R2) / (2 * (r1 + r2))) : 0;
    const double *mass = net->w.disks.mass, m = a < 0 ? mass[b] : mass[a] * mass[b] / (mass[a] + mass[b]);
    double slide[2][3] = {{-n[1], n[0], r1}, {n[1], -n[0], r2}}, roll[2][3];
    for (int l = 0; l < 3; l++) {
        roll[0][l] = along * slide[0][l] + (l == 2 ? R_eff : 0);
        roll[1][l] = along * slide[1][l] - (l == 2 ? R_eff : 0);
    }
    const double apart[2][3] = {{-n[0], -n[1], 0}, {n[0], n[1], 0}};
    add(net, net->K, net->k_n, a, apart[0], b, apart[1]);
    add(net, net->C, 2 * net->zeta * sqrt(net->k_n * m), a, apart[0], b, apart[1]);
    add(net, net->K, net->k_t, a, slide[0], b, slide[1]);
    add(net, net->K, net->k_r, a, roll[0], b, roll[1]);
}

static void assemble(network *net) {
    const tr_world *w = &net->w;
    memset(net->K, 0, sizeof net->K), memset(net->C, 0, sizeof net->C);
    for (int b = 0; b < w->disks.n; b++) {
        const double *q = w->disks.pos + 4 * (size_t)b;
        for (int a = 0; a < b; a++) {
            const double *p = w->disks.pos + 4 * (size_t)a;
            double L = hypot(q[0] - p[0], q[1] - p[1]), r1 = p[3] * L / (p[3] + q[3]);
            const double n[2] = {(q[0] - p[0]) / L, (q[1] - p[1]) / L};
            if (L < p[3] + q[3]) add_contact(net, a, b, n, r1, L - r1, p[3], q[3]);
        }
        if (w->n_walls && q[1] - w->wall[0].y < q[3]) add_contact(net, -1, b, (double[]){0, 1}, 0, q[3], 0, q[3]);
    }
}

static bool definite(const network *net, double dt) {
    double A[DOF][DOF];
    int n = 3 * net->w.disks.n;
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) {
            double sum = (i == j ? 4 : 0) - 2 * dt * net->C[i][j] - dt * dt * net->K[i][j];
            for (int k = 0; k < j; k++) sum -= A[i][k] * A[j][k];
            if (i == j && !(sum > 0)) return false;
            A[i][j] = i == j ? sqrt(sum) : sum / A[j][j];
        }
    return true;
}

static double exact_limit(const network *net, double guess) {
    double low = 0, high = guess;
    while (definite(net, high)) low = high, high *= 2;
    for (int k = 0; k < 50; k++) *(definite(net, 0.5 * (low + high)) ? &low : &high) = 0.5 * (low + high);
    return low;
}

/* ---- the leapfrog of the tool */

static double kinetic(const tr_disks *d) {
    double sum = 0;
    for (int k = 0; k < 4 * d->n; k++)
        if (d->inv[k] > 0) sum += 0.5 * d->vel[k] * d->vel[k] / d->inv[k];
    return sum;
}

/* Energy after at most STEPS steps over that at the start; *a_step: of the second half of the steps. */
static double growth(network *net, double dt, uint64_t seed, double *a_step, tr_status *st) {
    tr_world *w = &net->w;
    tr_random r = tr_random_seed(seed, 2);
    size_t bytes = 4 * (size_t)w->disks.n * sizeof(double);
    double *pos = malloc(bytes), start, most = 1, record[STEPS + 1], inv = 0;
    if (!pos) return tr_status_fail(st, TR_FILE, "error: out of memory"), NAN;
    memcpy(pos, w->disks.pos, bytes);
    for (int i = 0; i < w->disks.n; i++) inv = fmax(inv, w->disks.inv[4 * i]);
    for (int k = 0; k < 4 * w->disks.n; k++) /* the same energy for every motion */
        w->disks.vel[k] = TINY * 1e-3 / dt * sqrt(w->disks.inv[k] / inv) * (2 * tr_random_uniform(&r) - 1);
    for (int k = 0; k < 2; k++) /* springs relaxed, as at the start */
        for (int h = 0; h < w->group[k].n_hist; h++)
            memset(w->group[k].hist[h], 0, (size_t)w->group[k].n * sizeof(double));
    w->dt = dt, w->fresh = w->stale = true, w->allow_unstable = true;
    record[0] = start = kinetic(&w->disks);
    int k = 0;
    while (k < STEPS && most < 1e6 && tr_step_forces(w, st)) {
        tr_step_advance(w);
        record[++k] = kinetic(&w->disks);
        most = fmax(most, record[k] / start);
    }
    int half = most < GROWN ? 0 : k / 2;
    *a_step = pow(record[k] / record[half], 1.0 / (k - half));
    memcpy(w->disks.pos, pos, bytes);
    free(pos);
    return most;
}

static bool balance(network *net, tr_status *st) {
    tr_disks *d = &net->w.disks;
    net->w.dt = 1e-15, net->w.allow_unstable = true;
    if (!tr_step_forces(&net->w, st) || !(d->load = tr_alloc(4 * (size_t)d->n, sizeof(double), st))) return false;
    for (int k = 0; k < 4 * d->n; k++) d->load[k] = -d->force[k];
    return true;
}

static bool set_laws(network *net, tr_random *r, tr_status *st) {
    static const char text[] = "kind: bodies\ntime_end: 1 s\ndisks: [{radius: 1, x: 0, y: 0}]\n"
                               "contact: {k_n: 1 MPa, damping_ratio: 0, mu: 100, mu_r: 100}\n";
    net->k_n = among(r, 1e5, 1e7), net->k_t = net->k_n * among(r, 1e-3, 1e3), net->k_r = net->k_n * among(r, 1e-3, 1e3);
    net->zeta = tr_random_uniform(r) < 0.5 ? 0 : tr_random_uniform(r);
    net->conjugate = tr_random_uniform(r) < 0.5;
    char value[4][60];
    snprintf(value[0], 60, "contact.k_n=%.17g", net->k_n), snprintf(value[1], 60, "contact.k_t=%.17g", net->k_t);
    snprintf(value[2], 60, "contact.k_r=%.17g", net->k_r),
        snprintf(value[3], 60, "contact.damping_ratio=%.17g", net->zeta);
    const char *sets[] = {value[0], value[1], value[2], value[3],
                          net->conjugate ? "contact.rolling=bagi-kuhn-conjugate" : "contact.rolling=wang-spring"};
    tr_scene scene;
    if (!tr_scene_read(&scene, "network", text, strlen(text), sets, 5, tr_laws_catalog(), st)) return false;
    bool ok = tr_world_set_laws(&net->w, &scene.contact, false, 0, st);
    tr_scene_free(&scene);
    return ok;
}

/* ---- all of them */

typedef struct tally {
    double factor[NETWORKS],
        worst_share; /* limit/bound; of it in sqrt(z), which is the most it can be without damping */
    int unstable_below, wrong;
} tally;

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool one(tr_verify *v, network *net, tally *t, int i, tr_status *st) {
    tr_random r = tr_random_seed((uint64_t)i + 1, 1);
    if (!throw_disks(net, &r, st) || !set_laws(net, &r, st) || !balance(net, st)) return false;
    assemble(net);
    double bound = tr_timestep_contacts(&net->w).dt, limit = exact_limit(net, bound), a_step, below;
    double f = 0.1 + 1.9 * (i + 0.5) / NETWORKS;
    int z = 1;
    for (int k = 0; k < net->w.disks.n; k++)
        if (net->w.disks.coordination[k] > z) z = net->w.disks.coordination[k];
    t->factor[i] = limit / bound;
    if (net->zeta == 0) t->worst_share = fmax(t->worst_share, t->factor[i] / sqrt(z));
    below = growth(net, 0.99 * bound, (uint64_t)i, &a_step, st);
    t->unstable_below += !(below < GROWN);
    bool grows = !(growth(net, f * limit, (uint64_t)i, &a_step, st) < GROWN);
    if (fabs(f - 1) > 0.02 && grows != (f > 1)) t->wrong++;
    return st->code == TR_OK && tr_verify_point_add(v,
                                                    &(tr_verify_point){net->zeta > 0 ? "damped" : "undamped", f,
                                                                       "dt/limit", a_step, NAN, bound / limit, NAN},
                                                    st);
}

bool tr_stability_networks(tr_verify *v, tr_status *st) {
    network *net = tr_alloc(1, sizeof *net, st);
    tally *t = tr_alloc(1, sizeof *t, st);
    bool ok = net && t;
    for (int i = 0; ok && i < NETWORKS; i++) {
        ok = tr_verify_go_on(v, st) && one(v, net, t, i, st);
        tr_world_free(&net->w);
    }
    if (ok) {
        qsort(t->factor, NETWORKS, sizeof(double), compare);
        double median = 0.5 * (t->factor[NETWORKS / 2 - 1] + t->factor[NETWORKS / 2]);
        const tr_verify_row rows[] = {
            {"networks unstable at 0.99 of the bound", "1", 0, t->unstable_below, 0, "a bound is a bound", NAN, NULL},
            {"networks where leapfrog and Cholesky differ", "1", 0, t->wrong, 0, "dt beyond 2 % of the limit", NAN,
             NULL},
            {"least limit/bound, below 1", "1", 0, fmax(0, 1 - t->factor[0]), 1e-4,
             "contacts turn, LAP P/L, and overlaps round", NAN, NULL},
            {"median limit/bound, above 1", "1", 0, median - 1, 0.5, "wanted: at most 1.5", NAN, NULL},
            {"worst limit/(bound sqrt(contacts of a disk)), above 1", "1", 0, fmax(0, t->worst_share - 1), 1e-4,
             "a share m/z of a mass is m at most", NAN, NULL},
        };
        for (size_t k = 0; ok && k < sizeof rows / sizeof *rows; k++) ok = tr_verify_add(v, &rows[k], st);
        char text[80];
        snprintf(text, sizeof text, "limit/bound: median %.3f, worst %.2f", median, t->factor[NETWORKS - 1]);
        ok = ok && tr_verify_outcome(v, "what the bound gives away", text, true, st);
    }
    free(net), free(t);
    return ok;
}
