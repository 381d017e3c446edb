/* SPDX-License-Identifier: MIT */
#include "verify/stability_network.h"

#include "base/alloc.h"
#include "base/random.h"
#include "core/pipeline.h"
#include "core/step.h"
#include <stdio.h>
#include <string.h>

/* Depth, way of a disturbance in a step, and way of sliding rims, as fractions of the smallest radius [m]. Rims are
 * fast enough that no disturbance turns sliding back, up to 1e3 of what it was. */
static const double LAP = 1e-5, TINY = 1e-11, SLIDES = 1e-5, SMALLEST = 1e-3;

static double among(tr_random *r, double low, double high) { /* evenly in the logarithm */
    return low * pow(high / low, tr_random_uniform(r));
}

/* ---- the disks */

static double gap(const tr_world *w, int i, int n) {
    double least = INFINITY;
    const double *p = w->disks.pos + tr_body(i);
    for (int j = 0; j < n; j++) {
        const double *q = w->disks.pos + tr_body(j);
        if (j != i) least = fmin(least, hypot(p[0] - q[0], p[1] - q[1]) - p[3] - q[3]);
    }
    return least;
}

/* Disk i touches disk j, and j2 if they are close enough; false: no room. */
static bool place(tr_world *w, tr_random *r, int i, double R, double density, double lap, bool held) {
    int j = (int)(tr_random_uniform(r) * i), j2 = (int)(tr_random_uniform(r) * i);
    const double *p = w->disks.pos + tr_body(j), *q = w->disks.pos + tr_body(j2);
    double angle = 2 * M_PI * tr_random_uniform(r), d = hypot(q[0] - p[0], q[1] - p[1]);
    double a = p[3] + R - lap, b = q[3] + R - lap, c = (d * d + a * a - b * b) / (2 * a * d);
    if (j != j2 && fabs(c) < 1) angle = atan2(q[1] - p[1], q[0] - p[0]) + acos(c);
    tr_world_set_disk(w, i, &(tr_disk_start){p[0] + a * cos(angle), p[1] + a * sin(angle), 0, R, density, held});
    return gap(w, i, i) > -1.5 * lap; /* no deeper than the two it touches */
}

static bool throw_disks(tr_network *net, tr_random *r, tr_status *st) {
    int n = 2 + (int)(tr_random_uniform(r) * (TR_NETWORK_DISKS - 1)), placed = 1;
    double lap = LAP * SMALLEST, density = among(r, 1e2, 1e4);
    bool held = tr_random_uniform(r) < 0.25;
    if (!tr_world_init(&net->w, n, TR_SHAPE_DISK, st)) return false;
    tr_world_set_disk(&net->w, 0, &(tr_disk_start){0, 0, 0, among(r, SMALLEST, 10 * SMALLEST), density, held});
    while (placed < n)
        placed += place(&net->w, r, placed, among(r, SMALLEST, 10 * SMALLEST), among(r, 1e2, 1e4), lap, false);
    if (tr_random_uniform(r) < 0.5) { /* a floor under the lowest */
        double lowest = INFINITY;
        for (int i = 0; i < n; i++)
            lowest = fmin(lowest, net->w.disks.pos[tr_body(i) + TR_Y] - net->w.disks.pos[tr_body(i) + TR_RADIUS]);
        net->w.wall[net->w.n_walls++] = (tr_wall){.y = lowest + lap, .ny = 1};
    }
    return true;
}

/* ---- the matrices, from the definitions of the velocities */

/* The map of the motion of disks a and b to a velocity, per root of the masses. */
typedef struct row {
    double of[TR_NETWORK_DOF];
} row;

static row row_of(const tr_network *net, int a, const double *ja, int b, const double *jb) {
    const double *inv = net->w.disks.inv;
    row r = {{0}};
    for (int l = 0; l < 3; l++) {
        if (a >= 0) r.of[3 * a + l] = ja[l] * sqrt(inv[tr_body(a) + l]);
        r.of[3 * b + l] = jb[l] * sqrt(inv[tr_body(b) + l]);
    }
    return r;
}

/* A force along `pull` that follows `by`. */
static void add(double X[TR_NETWORK_DOF][TR_NETWORK_DOF], double k, const row *pull, const row *by) {
    for (int i = 0; i < TR_NETWORK_DOF; i++)
        for (int j = 0; j < TR_NETWORK_DOF; j++) X[i][j] += k * pull->of[i] * by->of[j];
}

static int sign_of(double v) {
    return (v > 1e-9) - (v < -1e-9);
}

static double rim_of(const tr_network *net, int a) {
    return a < 0 ? -net->floor : net->rim[a];
}

/* Direction in which the friction spring and the rolling spring of a contact slide; 0: not. u: speeds of the rims, V_s
 * = (u1 + u2) but for the overlap; at the floor Vt = -floor. */
typedef struct slips {
    int friction, rolling;
} slips;

static slips slips_of(const tr_network *net, int a, int b, double R1, double R2) {
    double one = rim_of(net, a), two = net->rim[b], slide = one + two;
    double along = net->conjugate ? (a < 0 ? 0.5 : (R1 - R2) / (2 * (R1 + R2))) : 0;
    double roll = a < 0 ? -two : (R2 * one - R1 * two) / (R1 + R2); /* R_eff (w1 - w2) */
    return (slips){sign_of(slide), sign_of(roll + along * slide)};
}

typedef struct touch {
    double n[2], r1, r2, R1, R2; /* normal from a to b, arms, radii (R1 = 0: the floor) */
} touch;

/* Vn = V21.n, Vs = V21.t + r1 w1 + r2 w2, V_r = R_eff (w1 - w2), for the conjugate law + (R1 - R2)/(2L) Vs. */
static void add_contact(tr_network *net, int a, int b, const touch *c) {
    const double *n = c->n, r1 = c->r1, r2 = c->r2, R1 = c->R1, R2 = c->R2;
    double R_eff = a < 0 ? R2 : R1 * R2 / (R1 + R2),
           along = net->conjugate ? (a < 0 ? 0.5 : (R1 - R2) / (2 * (r1 + r2))) : 0;
    const double *inv = net->w.disks.inv, of = (a < 0 ? 0 : inv[tr_body(a)]) + inv[tr_body(b)], m = of > 0 ? 1 / of : 0;
    double slide[2][3] = {{-n[1], n[0], r1}, {n[1], -n[0], r2}}, roll[2][3];
    for (int l = 0; l < 3; l++) {
        roll[0][l] = along * slide[0][l] + (l == 2 ? R_eff : 0);
        roll[1][l] = along * slide[1][l] - (l == 2 ? R_eff : 0);
    }
    const double apart[2][3] = {{-n[0], -n[1], 0}, {n[0], n[1], 0}};
    const slips way = slips_of(net, a, b, R1, R2);
    const row g = row_of(net, a, apart[0], b, apart[1]), s = row_of(net, a, slide[0], b, slide[1]),
              r = row_of(net, a, roll[0], b, roll[1]);
    row pull = g;
    for (int i = 0; i < TR_NETWORK_DOF; i++)
        pull.of[i] -= net->mu * way.friction * s.of[i] + net->mu_r * way.rolling * r.of[i];
    add(net->K, net->k_n, &pull, &g);
    add(net->C, 2 * net->zeta * sqrt(net->k_n * m), &pull, &g);
    if (!way.friction) add(net->K, net->k_t, &s, &s);
    if (!way.rolling) add(net->K, net->k_r, &r, &r);
}

static void assemble(tr_network *net) {
    const tr_world *w = &net->w;
    memset(net->K, 0, sizeof net->K), memset(net->C, 0, sizeof net->C);
    for (int b = 0; b < w->disks.n; b++) {
        const double *q = w->disks.pos + tr_body(b);
        for (int a = 0; a < b; a++) {
            const double *p = w->disks.pos + tr_body(a);
            double L = hypot(q[0] - p[0], q[1] - p[1]), r1 = p[3] * L / (p[3] + q[3]);
            const touch c = {{(q[0] - p[0]) / L, (q[1] - p[1]) / L}, r1, L - r1, p[3], q[3]};
            if (L < p[3] + q[3]) add_contact(net, a, b, &c);
        }
        if (w->n_walls && q[1] - w->wall[0].y < q[3]) add_contact(net, -1, b, &(touch){{0, 1}, 0, q[3], 0, q[3]});
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

static double spin_of(const tr_network *net, int i) { /* when its rim slides */
    return net->rim[i] * SLIDES * SMALLEST / (net->w.dt * net->w.disks.pos[tr_body(i) + TR_RADIUS]);
}

/* Of the disturbance. */
static double kinetic(const tr_network *net) {
    const tr_disks *d = &net->w.disks;
    double sum = 0;
    for (int k = 0; k < TR_LANES * d->n; k++) {
        double v = d->vel[k] - (k % 4 == 2 ? spin_of(net, k / 4) : 0);
        if (d->inv[k] > 0) sum += 0.5 * v * v / d->inv[k];
    }
    return sum;
}

/* Springs that slide are stretched beyond their bound, the others relaxed. */
static void stretch(tr_network *net) {
    for (int k = 0; k < 2; k++) {
        tr_group *g = &net->w.group[k];
        for (int i = 0; i < g->n; i++) {
            int a = k ? -1 : g->a[i], b = g->b[i];
            slips way = slips_of(net, a, b, k ? 0 : net->w.disks.pos[tr_body(a) + TR_RADIUS],
                                 net->w.disks.pos[tr_body(b) + TR_RADIUS]);
            const double huge = 1e3 * net->k_n * SMALLEST;
            g->hist[g->laws[TR_FRICTION].hist][i] = way.friction * huge;
            g->hist[g->laws[TR_ROLLING].hist][i] = way.rolling * huge;
        }
    }
}

/* At the start the same energy for every motion. */
static void disturb(tr_network *net, double dt) {
    tr_world *w = &net->w;
    tr_random r = tr_random_seed(1, 2);
    double inv = 0;
    for (int i = 0; i < w->disks.n; i++) inv = fmax(inv, w->disks.inv[tr_body(i)]);
    for (int k = 0; k < TR_LANES * w->disks.n; k++)
        w->disks.vel[k] = TINY * SMALLEST / dt * sqrt(w->disks.inv[k] / inv) * (2 * tr_random_uniform(&r) - 1);
    stretch(net);
    w->dt = dt, w->fresh = w->stale = true;
    for (int i = 0; i < w->disks.n; i++) w->disks.vel[tr_body(i) + TR_TURN] += spin_of(net, i);
    w->wall[0].vx = net->floor * SLIDES * SMALLEST / dt;
}

double tr_network_growth(tr_network *net, double dt, int steps, double *a_step, tr_status *st) {
    double pos[tr_body(TR_NETWORK_DISKS)], before = 1, last = 1, most = 1;
    size_t bytes = tr_body(net->w.disks.n) * sizeof(double);
    memcpy(pos, net->w.disks.pos, bytes);
    disturb(net, dt);
    double start = kinetic(net);
    int k = 0;
    while (k < steps && most < 1e6 && tr_step_forces(&net->w, st)) {
        tr_step_advance(&net->w);
        before = last, last = kinetic(net) / start, k++;
        most = fmax(most, last);
    }
    *a_step = most < TR_NETWORK_GROWN ? pow(last, 1.0 / k) : last / before;
    memcpy(net->w.disks.pos, pos, bytes);
    return most;
}

double tr_network_linear(tr_network *net, double dt, int steps) {
    double x[TR_NETWORK_DOF] = {0}, y[TR_NETWORK_DOF], force[TR_NETWORK_DOF], start = 0, most = 1;
    const tr_disks *d = &net->w.disks;
    int n = 3 * d->n;
    disturb(net, dt);
    for (int i = 0; i < n; i++) {
        int lane = TR_LANES * (i / 3) + i % 3;
        double v = d->vel[lane] - (i % 3 == 2 ? spin_of(net, i / 3) : 0);
        y[i] = d->inv[lane] > 0 ? v * dt / sqrt(d->inv[lane]) : 0, start += y[i] * y[i];
    }
    for (int k = 0; k < steps && most < 1e6; k++) {
        double now = 0;
        for (int i = 0; i < n; i++) {
            force[i] = 0;
            for (int j = 0; j < n; j++) force[i] -= dt * dt * net->K[i][j] * x[j] + dt * net->C[i][j] * y[j];
        }
        for (int i = 0; i < n; i++) y[i] += force[i], x[i] += y[i], now += y[i] * y[i];
        most = fmax(most, now / start);
    }
    return most;
}

static bool balance(tr_network *net, tr_status *st) {
    tr_disks *d = &net->w.disks;
    net->w.dt = 1e-15, net->w.allow_unstable = true;
    if (!tr_step_forces(&net->w, st)) return false; /* there are contacts now */
    stretch(net);
    net->w.fresh = true;
    if (!tr_step_forces(&net->w, st) || !(d->load = tr_alloc(tr_body(d->n), sizeof(double), st))) return false;
    for (int k = 0; k < TR_LANES * d->n; k++) d->load[k] = -d->force[k];
    return true;
}

static bool set_laws(tr_network *net, tr_random *r, const char *velocity, bool sliding, tr_status *st) {
    static const char text[] = "kind: bodies\ntime_end: 1 s\ndisks: [{radius: 1, x: 0, y: 0}]\n"
                               "contact: {k_n: 1 MPa, damping_ratio: 0, mu: 100, mu_r: 100}\n";
    double apart = sliding ? 10 : 1e3; /* no disturbance makes a sticking spring slide */
    net->k_n = among(r, 1e5, 1e7), net->k_t = net->k_n * among(r, 1 / apart, apart);
    net->k_r = net->k_n * among(r, 1 / apart, apart);
    net->zeta = tr_random_uniform(r) < 0.5 ? 0 : tr_random_uniform(r);
    net->conjugate = tr_random_uniform(r) < 0.5 && !velocity;
    net->mu = sliding ? among(r, 0.1, 1) : 100, net->mu_r = sliding ? among(r, 0.1, 1) : 100;
    char value[6][60];
    snprintf(value[0], 60, "contact.k_n=%.17g", net->k_n), snprintf(value[1], 60, "contact.k_t=%.17g", net->k_t);
    snprintf(value[2], 60, "contact.k_r=%.17g", net->k_r),
        snprintf(value[3], 60, "contact.damping_ratio=%.17g", net->zeta);
    snprintf(value[4], 60, "contact.mu=%.17g", net->mu), snprintf(value[5], 60, "contact.mu_r=%.17g", net->mu_r);
    char rolling[60];
    snprintf(rolling, sizeof rolling, "contact.rolling_velocity=%s",
             velocity         ? velocity
             : net->conjugate ? "bagi-kuhn"
                              : "wang");
    const char *law = net->conjugate ? "contact.rolling=conjugate-spring" : "contact.rolling=wang-spring";
    const char *sets[] = {value[0], value[1], value[2], value[3], value[4], value[5], rolling, law};
    tr_scene scene;
    if (!tr_scene_read(&scene, &(tr_scene_source){"network", text, strlen(text), sets, 8}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_world_set_laws(&net->w, &scene.contact, false, 0, st);
    tr_scene_free(&scene);
    return ok;
}

static void set_rims(tr_network *net, tr_random *r, bool sliding) {
    for (int i = 0; i < TR_NETWORK_DISKS; i++) net->rim[i] = sliding ? floor(3 * tr_random_uniform(r)) - 1 : 0;
    net->floor = sliding ? floor(3 * tr_random_uniform(r)) - 1 : 0;
}

bool tr_network_throw(tr_network *net, int seed, const char *rolling_velocity, bool sliding, tr_status *st) {
    tr_random r = tr_random_seed((uint64_t)seed, 1);
    if (!throw_disks(net, &r, st) || !set_laws(net, &r, rolling_velocity, sliding, st)) return false;
    set_rims(net, &r, sliding);
    if (!balance(net, st)) return false;
    assemble(net);
    return true;
}

void tr_network_free(tr_network *net) {
    tr_world_free(&net->w);
}
