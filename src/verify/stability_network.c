/* SPDX-License-Identifier: MIT */
#include "verify/stability_network.h"

#include "base/alloc.h"
#include "base/random.h"
#include "core/step.h"
#include <stdio.h>
#include <string.h>

static const double LAP = 1e-5, TINY = 1e-11,
                    SMALLEST = 1e-3; /* depth and way in a step, as shares of the smallest radius [m] */

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

static bool throw_disks(tr_network *net, tr_random *r, tr_status *st) {
    int n = 2 + (int)(tr_random_uniform(r) * (TR_NETWORK_DISKS - 1)), placed = 1;
    double lap = LAP * SMALLEST, density = among(r, 1e2, 1e4);
    bool held = tr_random_uniform(r) < 0.25;
    if (!tr_world_init(&net->w, n, TR_SHAPE_DISK, st)) return false;
    tr_world_set_disk(&net->w, 0, 0, 0, 0, among(r, SMALLEST, 10 * SMALLEST), density, held);
    while (placed < n)
        placed += place(&net->w, r, placed, among(r, SMALLEST, 10 * SMALLEST), among(r, 1e2, 1e4), lap, false);
    if (tr_random_uniform(r) < 0.5) { /* a floor under the lowest */
        double lowest = INFINITY;
        for (int i = 0; i < n; i++) lowest = fmin(lowest, net->w.disks.pos[4 * i + 1] - net->w.disks.pos[4 * i + 3]);
        net->w.wall[net->w.n_walls++] = (tr_wall){.y = lowest + lap, .ny = 1};
    }
    return true;
}

/* ---- the matrices, from the definitions of the velocities */

static void add(tr_network *net, double X[TR_NETWORK_DOF][TR_NETWORK_DOF], double k, int ia, const double *ja, int ib,
                const double *jb) {
    double row[TR_NETWORK_DOF] = {0};
    for (int l = 0; l < 3; l++) {
        if (ia >= 0) row[3 * ia + l] = ja[l] * sqrt(net->w.disks.inv[4 * ia + l]);
        row[3 * ib + l] += jb[l] * sqrt(net->w.disks.inv[4 * ib + l]);
    }
    for (int i = 0; i < TR_NETWORK_DOF; i++)
        for (int j = 0; j < TR_NETWORK_DOF; j++) X[i][j] += k * row[i] * row[j];
}

/* Vn = V21.n, Vs = V21.t + r1 w1 + r2 w2, V_r = R_eff (w1 - w2), for the conjugate law + (R1 - R2)/(2L) Vs. */
static void add_contact(tr_network *net, int a, int b, const double n[2], double r1, double r2, double R1, double R2) {
    double R_eff = a < 0 ? R2 : R1 * R2 / (R1 + R2),
           along = net->conjugate ? (a < 0 ? 0.5 : (R1 - R2) / (2 * (r1 + r2))) : 0;
    const double *inv = net->w.disks.inv, of = (a < 0 ? 0 : inv[4 * a]) + inv[4 * b], m = of > 0 ? 1 / of : 0;
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

static void assemble(tr_network *net) {
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

static bool definite(const tr_network *net, double dt) {
    double A[TR_NETWORK_DOF][TR_NETWORK_DOF];
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

double tr_network_limit(const tr_network *net) {
    double low = 0, high = 1e-9;
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

/* At the start: springs relaxed, the same energy for every motion. */
static void disturb(tr_network *net, double dt) {
    tr_world *w = &net->w;
    tr_random r = tr_random_seed(1, 2);
    double inv = 0;
    for (int i = 0; i < w->disks.n; i++) inv = fmax(inv, w->disks.inv[4 * i]);
    for (int k = 0; k < 4 * w->disks.n; k++)
        w->disks.vel[k] = TINY * SMALLEST / dt * sqrt(w->disks.inv[k] / inv) * (2 * tr_random_uniform(&r) - 1);
    for (int k = 0; k < 2; k++)
        for (int h = 0; h < w->group[k].n_hist && w->group[k].n > 0; h++)
            memset(w->group[k].hist[h], 0, (size_t)w->group[k].n * sizeof(double));
    w->dt = dt, w->fresh = w->stale = true;
}

double tr_network_growth(tr_network *net, double dt, int steps, double *a_step, tr_status *st) {
    double pos[4 * TR_NETWORK_DISKS], before = 1, last = 1, most = 1;
    size_t bytes = 4 * (size_t)net->w.disks.n * sizeof(double);
    memcpy(pos, net->w.disks.pos, bytes);
    disturb(net, dt);
    double start = kinetic(&net->w.disks);
    int k = 0;
    while (k < steps && most < 1e6 && tr_step_forces(&net->w, st)) {
        tr_step_advance(&net->w);
        before = last, last = kinetic(&net->w.disks) / start, k++;
        most = fmax(most, last);
    }
    *a_step = most < TR_NETWORK_GROWN ? pow(last, 1.0 / k) : last / before;
    memcpy(net->w.disks.pos, pos, bytes);
    return most;
}

static bool balance(tr_network *net, tr_status *st) {
    tr_disks *d = &net->w.disks;
    net->w.dt = 1e-15, net->w.allow_unstable = true;
    if (!tr_step_forces(&net->w, st) || !(d->load = tr_alloc(4 * (size_t)d->n, sizeof(double), st))) return false;
    for (int k = 0; k < 4 * d->n; k++) d->load[k] = -d->force[k];
    return true;
}

static bool set_laws(tr_network *net, tr_random *r, const char *velocity, tr_status *st) {
    static const char text[] = "kind: bodies\ntime_end: 1 s\ndisks: [{radius: 1, x: 0, y: 0}]\n"
                               "contact: {k_n: 1 MPa, damping_ratio: 0, mu: 100, mu_r: 100}\n";
    net->k_n = among(r, 1e5, 1e7), net->k_t = net->k_n * among(r, 1e-3, 1e3), net->k_r = net->k_n * among(r, 1e-3, 1e3);
    net->zeta = tr_random_uniform(r) < 0.5 ? 0 : tr_random_uniform(r);
    net->conjugate = tr_random_uniform(r) < 0.5 && !velocity;
    char value[4][60];
    snprintf(value[0], 60, "contact.k_n=%.17g", net->k_n), snprintf(value[1], 60, "contact.k_t=%.17g", net->k_t);
    snprintf(value[2], 60, "contact.k_r=%.17g", net->k_r),
        snprintf(value[3], 60, "contact.damping_ratio=%.17g", net->zeta);
    char rolling[60];
    snprintf(rolling, sizeof rolling, velocity ? "contact.rolling_velocity=%s" : "contact.rolling=%s",
             velocity         ? velocity
             : net->conjugate ? "bagi-kuhn-conjugate"
                              : "wang-spring");
    const char *sets[] = {value[0], value[1], value[2], value[3], rolling};
    tr_scene scene;
    if (!tr_scene_read(&scene, "network", text, strlen(text), sets, 5, tr_laws_catalog(), st)) return false;
    bool ok = tr_world_set_laws(&net->w, &scene.contact, false, 0, st);
    tr_scene_free(&scene);
    return ok;
}

bool tr_network_throw(tr_network *net, int seed, const char *rolling_velocity, tr_status *st) {
    tr_random r = tr_random_seed((uint64_t)seed, 1);
    if (!throw_disks(net, &r, st) || !set_laws(net, &r, rolling_velocity, st) || !balance(net, st)) return false;
    assemble(net);
    return true;
}

void tr_network_free(tr_network *net) {
    tr_world_free(&net->w);
}
