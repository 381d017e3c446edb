/* SPDX-License-Identifier: MIT */
/* Error against time: chains without friction and dashpots, where energy is constant and fourth order may pay.
 *
 *   chain-linear  8 disks between walls, pressed together so that no contact opens; the first one starts with u0 and
 *                 v0. Exact by modes, c = pi/(n + 1): u_j = sum_p (2/(n+1)) sin(jpc) sin(pc) (u0 cos w_p t + (v0/w_p)
 *                 sin w_p t), w_p = 2
 *                 sqrt(k/m) sin(pc/2)
 *   chain-hertz   the same of spheres with P = (4/3) E* sqrt(R*) delta^(3/2), against an integration by Runge and Kutta
 *                 here
 *   impact-chain  8 spheres that just touch, the first one thrown against the others: contacts open and close
 *
 * Energy of leapfrog. With K = (1/2) m v^(n-1/2) v^(n+1/2) a linear chain keeps K + U exactly: it may change by
 * rounding only. A Hertz chain keeps a number close to it: K + U swings by O(dt^2) and must not drift. [Hairer2003]
 */
#include "base/alloc.h"
#include "core/step.h"
#include "verify/precision.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 8, SIZE = 2048 };
static const double RADIUS = 0.01, DENSITY = 1000, SPEED = 0.01, STIFFNESS = 1e6, MODULUS = 1e9, LOAD = 0.5,
                    AWAY = 5e-6;

/* A chain along x. wall, pair: overlaps there and between the bodies [m]; wall 0: without walls. The first body has a
 * speed and is `away` from its place. */
static void write_chain(char *text, const char *head, double wall, double pair, double away) {
    double x = RADIUS - wall;
    int n = snprintf(text, SIZE, "kind: bodies\n%sdisks:\n", head);
    for (int i = 0; i < N; i++, x += 2 * RADIUS - pair)
        n += snprintf(text + n, (size_t)(SIZE - n), "  - {radius: %g, density: %g, x: %.17g, y: 0, vx: %g}\n", RADIUS,
                      DENSITY, i == 0 ? x + away : x, i == 0 ? SPEED : 0);
    if (wall > 0)
        snprintf(text + n, (size_t)(SIZE - n), "walls: [{nx: 1, ny: 0}, {nx: -1, ny: 0, x: %.17g}]\n",
                 x - RADIUS + pair - wall);
}

static void linear_text(char *text) {
    write_chain(text, "contact: {k_n: 1 MPa, damping_ratio: 0, friction: none, rolling: none}\ntime_end: 10 ms\n", 1e-4,
                1e-4, AWAY);
}

/* ---- linear: modes */

static double linear_error(const tr_bodies *b, const void *reference) {
    (void)reference;
    double rate = sqrt(STIFFNESS / b->world.disks.mass[0]), T = b->scene->time_end, error = 0;
    for (int j = 0; j < N; j++) {
        double u = 0, v = 0, c = M_PI / (N + 1);
        for (int p = 1; p <= N; p++) {
            double w = 2 * rate * sin(0.5 * p * c), share = 2.0 / (N + 1) * sin((j + 1) * p * c) * sin(p * c);
            u += share * (AWAY * cos(w * T) + SPEED / w * sin(w * T));
            v += share * (SPEED * cos(w * T) - AWAY * w * sin(w * T));
        }
        double du = b->world.disks.pos[tr_body(j)] - (b->scene->disks[j].x - (j ? 0 : AWAY)) - u,
               dv = b->world.disks.vel[tr_body(j)] - v;
        error += du * du * rate * rate + dv * dv;
    }
    return sqrt(error) / SPEED;
}

/* ---- Hertz: Runge-Kutta of fourth order, written here */

static double hertz(double R_star, double overlap) {
    return overlap > 0 ? 4.0 / 3 * MODULUS * sqrt(R_star) * overlap * sqrt(overlap) : 0;
}

static double hertz_overlap(double R_star, double force) {
    return cbrt(pow(0.75 * force / MODULUS, 2) / R_star);
}

static void slope(double length, double mass, const double *y, double *dy) {
    for (int i = 0; i < N; i++) dy[i] = y[N + i], dy[N + i] = 0;
    for (int i = 0; i + 1 < N; i++) {
        double P = hertz(RADIUS / 2, 2 * RADIUS - (y[i + 1] - y[i]));
        dy[N + i] -= P / mass, dy[N + i + 1] += P / mass;
    }
    if (length == 0) return;
    dy[N] += hertz(RADIUS, RADIUS - y[0]) / mass, dy[2 * N - 1] -= hertz(RADIUS, y[N - 1] + RADIUS - length) / mass;
}

static void *hertz_reference(const tr_scene *scene, tr_status *st) {
    enum { STEPS = 100000 };
    double *y = tr_alloc(2 * N, sizeof *y, st), k[4][2 * N], z[2 * N];
    if (!y) return NULL;
    double h = scene->time_end / STEPS, length = scene->n_walls ? scene->walls[1].x : 0;
    double mass = DENSITY * 4 / 3 * M_PI * RADIUS * RADIUS * RADIUS;
    for (int i = 0; i < N; i++) y[i] = scene->disks[i].x, y[N + i] = scene->disks[i].vx;
    for (int s = 0; s < STEPS; s++) {
        slope(length, mass, y, k[0]);
        for (int q = 1; q < 4; q++) {
            for (int i = 0; i < 2 * N; i++) z[i] = y[i] + (q < 3 ? 0.5 : 1) * h * k[q - 1][i];
            slope(length, mass, z, k[q]);
        }
        for (int i = 0; i < 2 * N; i++) y[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
    }
    return y;
}

static double hertz_error(const tr_bodies *b, const void *reference) {
    const double *y = reference;
    double error = 0;
    for (int i = 0; i < N; i++) error = hypot(error, b->world.disks.vel[tr_body(i)] - y[N + i]);
    return error / SPEED;
}

static void hertz_text(char *text) {
    write_chain(text,
                "shape: sphere\ncontact: {normal: hertz-sphere, E_star: 1 GPa, damping_ratio: 0, friction: none, "
                "rolling: none}\n"
                "time_end: 10 ms\n",
                hertz_overlap(RADIUS, LOAD), hertz_overlap(RADIUS / 2, LOAD), 0);
}

/* ---- energy over many steps */

/* After tr_step_forces. Stored: F delta/2 of a linear spring, 2 F delta/5 of Hertz. */
static double energy(const tr_bodies *b) {
    const tr_disks *d = &b->world.disks;
    bool sphere = b->scene->shape == TR_SHAPE_SPHERE;
    double sum = 0;
    for (int i = 0; i < N; i++)
        sum += 0.5 * d->mass[i] * d->vel[tr_body(i)] *
               (d->vel[tr_body(i)] + b->world.dt * d->force[tr_body(i)] / d->mass[i]);
    for (int i = 0; i <= N; i++) {
        double left = i > 0 ? d->pos[tr_body(i - 1)] + RADIUS : 0,
               right = i < N ? d->pos[tr_body(i)] - RADIUS : b->scene->walls[1].x;
        double delta = left - right, R = i > 0 && i < N ? RADIUS / 2 : RADIUS;
        sum += sphere ? 0.4 * hertz(R, delta) * delta : 0.5 * STIFFNESS * delta * delta;
    }
    return sum;
}

typedef struct drift {
    double swing,
        slope; /* greatest difference from the mean; change over the whole run, by least squares: both of m v0^2/2 */
} drift;

static bool long_run(const char *text, drift *result, tr_status *st) {
    enum { SAMPLES = 1000, EVERY = 1000 };
    double e[SAMPLES] = {0};
    tr_scene scene;
    tr_bodies b;
    if (!tr_scene_read(&scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    if (!tr_bodies_init(&b, &scene, st)) return tr_scene_free(&scene), false;
    bool ok = true;
    double mean = 0, slope_sum = 0, swing = 0, unit = 0.5 * b.world.disks.mass[0] * SPEED * SPEED;
    for (int s = 0; s < SAMPLES && ok; s++) {
        for (int k = 0; k < EVERY + s % 7 && ok; k++) { /* no whole number of swings */
            ok = tr_step_forces(&b.world, st);
            e[s] = k ? e[s] : energy(&b);
            tr_step_advance(&b.world);
        }
        mean += e[s] / SAMPLES;
    }
    for (int s = 0; s < SAMPLES; s++) {
        double x = (s + 0.5) / SAMPLES - 0.5;
        swing = fmax(swing, fabs(e[s] - mean)), slope_sum += 12.0 / SAMPLES * x * (e[s] - mean);
    }
    if (ok) *result = (drift){swing / unit, slope_sum / unit};
    tr_bodies_free(&b);
    tr_scene_free(&scene);
    return ok;
}

static bool refused(tr_verify *v, tr_status *st) {
    static const char text[] =
        "kind: bodies\ntime_end: 1 ms\ncontact: {k_n: 1 MPa, damping_ratio: 0, mu: 0.5, rolling: none}\n"
        "disks: [{radius: 1, density: 1, x: 1, y: 0}]\nwalls: [{nx: 1, ny: 0}]\n";
    tr_scene scene;
    tr_bodies b;
    tr_status said = {0};
    if (!tr_scene_read(&scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_bodies_init(&b, &scene, st);
    if (ok) {
        tr_integrate(&b.world, TR_PEFRL, 1, &said);
        tr_bodies_free(&b);
    }
    tr_scene_free(&scene);
    return ok &&
           tr_verify_outcome(v, "PEFRL with friction", said.code ? "refused" : "ran", said.code == TR_BAD_CASE, st);
}

/* ---- the verifications */

static const tr_sweep_method smooth[] = {
    {"leapfrog", 2, 0.2, "smooth: second order, less where the phase is lost"},
    {"velocity Verlet", 2, 0.2, "smooth: second order, less where the phase is lost"},
    {"Verlet predicted v", 2, 0.2, "no force asks for a velocity: leapfrog"},
    {"Forest-Ruth", 4, 0.3, "smooth: fourth order"},
    {"PEFRL", 4, 0.3, "smooth: fourth order"},
};

static bool add_drift(tr_verify *v, const char *text, bool linear, tr_status *st) {
    drift d = {.swing = NAN, .slope = NAN};
    if (!long_run(text, &d, st) && !tr_precise_failed(st)) return false;
    char said[80];
    snprintf(said, sizeof said, "swing %.2g", d.swing);
    return tr_verify_add(
        v,
        &(tr_verify_row){.quantity = "energy drift in 1e6 steps, over m v0^2/2",
                         .unit = "1",
                         .computed = d.slope,
                         .tolerance = linear ? 1e-8 : 0.2 * d.swing,
                         .reason = linear ? "rounding: 1e-16 of the stored energy, 1e3 as large, each step"
                                          : "three standard errors of a slope through 1000 random swings",
                         .order = NAN,
                         .outcome = said},
        st);
}

bool tr_precision_chain_linear(tr_verify *v, tr_status *st) {
    char text[SIZE];
    linear_text(text);
    const tr_precise c = {text, NULL, 0, 0, 1, linear_error, NULL, 8, 8, 11};
    return tr_precise_add(v, &c, smooth, 5, 0.02, "(w dt)^2/24 of the phase a step, of the fastest mode", st) &&
           add_drift(v, text, true, st) && refused(v, st);
}

bool tr_precision_chain_hertz(tr_verify *v, tr_status *st) {
    char text[SIZE];
    hertz_text(text);
    const tr_precise c = {text, NULL, 0, 0, 1, hertz_error, hertz_reference, 8, 7, 11};
    return tr_precise_add(v, &c, smooth, 5, 0.02, "(w dt)^2/24 of the phase a step, of the fastest mode", st) &&
           add_drift(v, text, false, st);
}

bool tr_precision_impact_chain(tr_verify *v, tr_status *st) {
    static const tr_sweep_method opening[] = {
        {"leapfrog", 2, 0.3, "delta^(3/2) has a slope where a contact opens: second order"},
        {"velocity Verlet", 2, 0.3, "delta^(3/2) has a slope where a contact opens: second order"},
        {"Verlet predicted v", NAN, 0, NULL},
        {"Forest-Ruth", NAN, 0, NULL},
        {"PEFRL", NAN, 0, NULL},
    };
    char text[SIZE];
    write_chain(text,
                "shape: sphere\ncontact: {normal: hertz-sphere, E_star: 1 GPa, damping_ratio: 0, friction: none, "
                "rolling: none}\n"
                "time_end: 2 ms\n",
                0, 0, 0);
    const tr_precise c = {text, NULL, 0, 0, 1, hertz_error, hertz_reference, 8, 8, 11};
    return tr_precise_add(v, &c, opening, 5, 0.02, "some twenty steps a contact, second order", st);
}
