/* SPDX-License-Identifier: MIT */
/* Error against time: impacts, from slipping to rolling, a rolling spring.
 *
 * The reference is the exact motion of the springs, not of rigid disks: so the error is that of the step. m is the mass
 * of a disk, I = m R^2/2.
 *
 *   impact        spring and dashpot, zeta = sin q, w = sqrt(k_n/m_eff); the force ends when it reaches 0:
 *                 e = exp(-2 zeta (pi/2 - q)/cos q)
 *   oblique       without slip and dashpot: Vs(end)/Vs(0) = cos(pi sqrt(3 k_t/k_n))
 *   slip to roll  Vs = v + R w obeys Vs' = -3 Q/m, u' = Vs, Q = k_t u up to mu N; W = sqrt(3 k_t/m):
 *                 Q = (k_t Vs0/W) sin Wt until it is mu N at t1; Vs = Vs1 - 3 (mu N/m) (t - t1) until 0 at t2; from
 *                 there Q = mu N cos W(t - t2). v' = -Q/m, (R w)' = -2 Q/m
 *   rolling       no bound is reached: with y = R theta, x'' = -(k_t/m) (x + y),
 *   spring        y'' = -(2/m) (k_t (x + y) + k_r y); two modes
 *
 * Leapfrog is of second order, with two exceptions of first order: a contact that ends between two steps lasts a part
 * of a step too long or too short (oblique), and the dashpot takes the velocity of half a step ago (impact).
 */
#include "verify/precision.h"

#include <string.h>

static const char first_order[] = "kinks between two steps: first order, scattered by where they fall";
static const char second_order[] = "second order but for kinks, which fall where they fall";

static const double *velocity(const tr_bodies *b, int i) {
    return b->world.disks.vel + tr_body(i);
}
static const double *position(const tr_bodies *b, int i) {
    return b->world.disks.pos + tr_body(i);
}

static double value(const tr_bodies *b, const tr_law *law, int slot, const char *key) {
    return *tr_law_value(law, b->world.group[b->scene->n_walls > 0].laws[slot].par, key);
}
static double parameter(const tr_bodies *b, int slot, const char *key) {
    return value(b, b->world.group[b->scene->n_walls > 0].laws[slot].law, slot, key);
}

/* ---- impacts */

static const char impact_text[] = "kind: bodies\ntime_end: 3 ms\n"
                                  "contact: {k_n: 1 MPa, damping_ratio: 0.3, friction: none, rolling: none}\n"
                                  "disks:\n"
                                  "  - {radius: 10 mm, density: 1000, x: 0, y: 0, vx: 5 mm/s}\n"
                                  "  - {radius: 10 mm, density: 1000, x: 20.002 mm, y: 0, vx: -5 mm/s}\n";

static double impact_error(const tr_bodies *b, const void *reference) {
    (void)reference;
    double q = asin(parameter(b, TR_NORMAL, "damping_ratio")), e = exp(-2 * tan(q) * (M_PI / 2 - q));
    double before = b->scene->disks[0].vx - b->scene->disks[1].vx, after = velocity(b, 1)[0] - velocity(b, 0)[0];
    return fabs(after / before - e);
}

/* The same motion of leapfrog and of velocity Verlet, to rounding of a few hundred steps. */
static bool same_motion(tr_verify *v, const tr_precise *c, tr_status *st) {
    double state[2][2];
    tr_scene scene;
    if (!tr_scene_read(&scene, &(tr_scene_source){"case", c->text, strlen(c->text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    scene.step.safety /= 16;
    bool ok = true;
    for (int m = 0; m < 2 && ok; m++) {
        tr_bodies b;
        if (!(ok = tr_bodies_init(&b, &scene, st))) break;
        ok = tr_integrate(&b.world, m ? TR_VELOCITY_VERLET : TR_LEAPFROG, b.steps, st);
        state[m][0] = position(&b, 1)[0] / scene.disks[1].x, state[m][1] = velocity(&b, 1)[0] / scene.disks[0].vx;
        tr_bodies_free(&b);
    }
    tr_scene_free(&scene);
    return ok && tr_verify_add(v,
                               &(tr_verify_row){
                                   .quantity = "velocity Verlet is leapfrog: largest difference",
                                   .unit = "1",
                                   .computed = fmax(fabs(state[1][0] - state[0][0]), fabs(state[1][1] - state[0][1])),
                                   .tolerance = 1e-11,
                                   .reason = "rounding of positions, 1e-16 of 0.02 m, is 1e-12 of the overlap",
                                   .order = NAN},
                               st);
}

bool tr_precision_impact(tr_verify *v, tr_status *st) {
    static const tr_sweep_method method[] = {
        {"leapfrog", 1, 0.2, first_order},
        {"velocity Verlet", 1, 0.2, first_order},
        {"Verlet predicted v", NAN, 0, NULL},
    };
    /* the gap closes in 0.2 to 1.2 ms, the contact takes 1.06 ms */
    const tr_precise c = {impact_text, "disks.1.x", 20.002e-3, 20.012e-3, 16, impact_error, NULL, 8, 11, 7};
    return tr_precise_add(v, &c, method, 3, 0.075,
                          "w dt = 0.15, some twenty steps a contact: first order, zeta w dt and more", st) &&
           same_motion(v, &c, st);
}

static const char oblique_text[] =
    "kind: bodies\ntime_end: 3 ms\n"
    "contact: {k_n: 1 MPa, damping_ratio: 0, friction: coulomb-spring, mu: 100, k_t: 0.2*k_n, rolling: none}\n"
    "disks:\n"
    "  - {radius: 10 mm, density: 1000, x: 0, y: 0, vx: 10 um/s, vy: -3 um/s}\n"
    "  - {radius: 10 mm, density: 1000, x: 20.000002 mm, y: 0, vx: -10 um/s, vy: 3 um/s}\n";

static double oblique_error(const tr_bodies *b, const void *reference) {
    (void)reference;
    double ratio = parameter(b, TR_FRICTION, "k_t") / parameter(b, TR_NORMAL, "k_n"), e = cos(M_PI * sqrt(3 * ratio));
    const double *v = velocity(b, 0), *u = velocity(b, 1);
    double before = b->scene->disks[0].vy - b->scene->disks[1].vy; /* Vs = Vt + R (w1 + w2), t = (0, -1) */
    return fabs((v[1] - u[1] + b->scene->disks[0].radius * (v[2] + u[2])) / before - e);
}

bool tr_precision_oblique(tr_verify *v, tr_status *st) {
    static const tr_sweep_method method[] = {
        {"leapfrog", 1, 0.2, first_order},
        {"velocity Verlet", 1, 0.2, first_order},
        {"Verlet predicted v", 1, 0.2, first_order},
    };
    const tr_precise c = {oblique_text, "disks.1.x", 20.000004e-3, 20.000024e-3, 16, oblique_error, NULL, 8, 12, 7};
    return tr_precise_add(v, &c, method, 3, 0.25, "some twenty steps a contact: its end is found to one of them", st);
}

/* ---- on a floor */

#define FLOOR                                                                                                          \
    "kind: bodies\ngravity: {y: -9.81}\nwalls: [{nx: 0, ny: 1}]\n"                                                     \
    "disks:\n  - radius: 50 mm\n    density: 1200\n    x: 0\n"                                                         \
    "    y: radius - density*pi*radius^2*9.81 m/s^2/contact.k_n\n    vx: 1\n"

static const char slip_text[] =
    FLOOR "time_end: 0.25 s\n"
          "contact: {k_n: 1 MPa, damping_ratio: 0.3, friction: coulomb-spring, mu: 0.3, rolling: none}\n";

static double slip_error(const tr_bodies *b, const void *reference) {
    (void)reference;
    const tr_scene_disk *d = b->scene->disks;
    double m = b->world.disks.mass[0], k = parameter(b, TR_FRICTION, "k_t"), W = sqrt(3 * k / m);
    double g = -b->scene->gravity.y, mu = parameter(b, TR_FRICTION, "mu"), v0 = d->vx, T = b->scene->time_end;
    double t1 = asin(mu * m * g * W / (k * v0)) / W, v1 = v0 * cos(W * t1), t2 = t1 + v1 / (3 * mu * g);
    double lost = (v0 - v1) / 3 + mu * g * (t2 - t1) + mu * g / W * sin(W * (T - t2)); /* int Q/m dt */
    return hypot(velocity(b, 0)[0] - (v0 - lost), d->radius * velocity(b, 0)[2] + 2 * lost) / v0;
}

bool tr_precision_thrown_disk(tr_verify *v, tr_status *st) {
    static const tr_sweep_method method[] = {
        {"leapfrog", 2, 0.4, second_order},
        {"velocity Verlet", 2, 0.4, second_order},
        {"Verlet predicted v", NAN, 0, NULL},
    };
    const tr_precise c = {slip_text, "disks.0.vx", 1, 1.2, 8, slip_error, NULL, 8, 9, 7};
    return tr_precise_add(v, &c, method, 3, 1.3e-3,
                          "(w dt)^2/24 of the phase a radian, of a swing of mu g/W = 0.7 % of v0", st);
}

static const char rolling_text[] =
    FLOOR "    spin: -20\ntime_end: 0.3 s\n"
          "contact: {k_n: 1 MPa, friction: coulomb-spring, mu: 100, rolling: wang-spring, mu_r: 100, k_r: 0.01*k_t}\n";

/* Of z'' = -A z with A = M^-1 K of two masses: mode i has w_i^2, eigenvectors in the metric of the masses. */
static double rolling_error(const tr_bodies *b, const void *reference) {
    (void)reference;
    double m = b->world.disks.mass[0], kt = parameter(b, TR_FRICTION, "k_t"), kr = parameter(b, TR_ROLLING, "k_r");
    double R = b->scene->disks[0].radius, v0 = b->scene->disks[0].vx, T = b->scene->time_end;
    /* scaled by the roots of the masses m and m/2: symmetric */
    double a = kt / m, d = 2 * (kt + kr) / m, c = sqrt(2) * kt / m;
    double mean = 0.5 * (a + d), spread = hypot(0.5 * (a - d), c), want[4] = {0};
    for (int i = 0; i < 2; i++) {
        double w2 = mean + (i ? spread : -spread), w = sqrt(w2), norm = hypot(c, w2 - a), ex = c / norm,
               ey = (w2 - a) / norm;
        double amount = v0 * ex + R * b->scene->disks[0].spin / sqrt(2) * ey; /* z = (x, y/sqrt(2)) */
        want[0] += amount * ex * sin(w * T) / w, want[1] += sqrt(2) * amount * ey * sin(w * T) / w;
        want[2] += amount * ex * cos(w * T), want[3] += sqrt(2) * amount * ey * cos(w * T);
    }
    double slow = sqrt(mean - spread), error = 0;
    const double is[4] = {position(b, 0)[0], R * position(b, 0)[2], velocity(b, 0)[0], R * velocity(b, 0)[2]};
    for (int i = 0; i < 4; i++) error = hypot(error, (is[i] - want[i]) * (i < 2 ? slow : 1));
    return error / v0;
}

bool tr_precision_rolling_spring(tr_verify *v, tr_status *st) {
    static const tr_sweep_method method[] = {
        {"leapfrog", 2, 0.15, "smooth: second order, less where the fast phase is lost"},
        {"velocity Verlet", 2, 0.15, "smooth: second order, less where the fast phase is lost"},
        {"Verlet predicted v", 1, 0.2, "a spring that is told the velocity half a step later"},
    };
    const tr_precise c = {rolling_text, NULL, 0, 0, 1, rolling_error, NULL, 8, 9, 15};
    return tr_precise_add(v, &c, method, 3, 1e-3,
                          "(w dt)^2/24 of the phase a radian, of the fast mode's share k_r/k_t = 0.01", st);
}
