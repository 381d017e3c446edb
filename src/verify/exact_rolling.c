/* SPDX-License-Identifier: MIT */
/* One disk on a floor, against the closed forms of a rigid disk, I = m R^2/2, with friction mu:
 *
 *   slip to roll   thrown with v0 without spin: rolls from t = v0/(3 mu g) on, at 2/3 v0, a third of the energy lost
 *   incline        law by law, see `resistances` */
#include "scene/what.h"
#include "verify/exact.h"

#include "laws/law.h"
#include <stdio.h>
#include <string.h>

/* Plays the scene and gives its checks their names, which end with NULL. order: of the first of them. */
static bool rows(tr_verify *v, const char *text, const char *const *quantity, double order, const char *reason,
                 tr_status *st) {
    enum { MOST = 4 };
    tr_scene scene;
    tr_check_result result[MOST] = {{0}};
    if (!tr_scene_read(&scene, &(tr_scene_source){v->now->name, text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_verify_play(v, &scene, 0, result, st) && tr_verify_go_on(v, st);
    for (int k = 0; ok && k < scene.n_checks && quantity[k]; k++) {
        const tr_scene_check *c = &scene.checks[k];
        char part[TR_BY_SHAPE];
        const char *unit = tr_param_by_shape(tr_whats[c->what].unit, scene.shape, part);
        ok = tr_verify_add(v,
                           &(tr_verify_row){quantity[k], unit, c->exact, result[k].measured, c->tolerance, reason,
                                            k == 0 ? order : NAN, NULL},
                           st);
    }
    tr_scene_free(&scene);
    return ok;
}

/* ---- slip to roll */

static void thrown(char text[1600], double k_n) {
    snprintf(
        text, 1600,
        "kind: bodies\ntime_end: 0.3 s\ngravity: {y: -9.81 m/s^2}\n"
        "contact: {k_n: %g, k_t: k_n, damping_ratio: 0.3, friction: coulomb-spring, mu: 0.3, rolling: none}\n"
        "disks: [{radius: 50 mm, density: 1200, x: 0, y: radius - density*pi*radius^2*9.81 m/s^2/contact.k_n, vx: 1}]\n"
        "walls: [{nx: 0, ny: 1}]\nchecks:\n"
        "  - {what: slip-ends, contact: wall0-0, exact: disks.0.vx/(3*contact.mu*9.81 m/s^2), tolerance: 1e-3*exact}\n"
        "  - {what: speed, over: 0.1 s, exact: 2/3*disks.0.vx, tolerance: 1e-4*exact}\n"
        "  - {what: energy-lost, over: 0.1 s, exact: 1/3, tolerance: 1e-4*exact}\n",
        k_n);
}

/* The contact is a spring: the rigid disk is the limit of k_n to infinity, with its smaller step. */
bool tr_exact_slip_to_roll(tr_verify *v, tr_status *st) {
    static const char *const quantity[] = {"time when slipping ends", "speed then", "share of the energy lost", NULL};
    char text[1600];
    double error[2];
    for (int h = 0; h < 2; h++) {
        tr_scene scene;
        tr_check_result result[3];
        thrown(text, 1e8 * pow(4, h + 1));
        if (!tr_scene_read(&scene, &(tr_scene_source){v->now->name, text, strlen(text), NULL, 0}, tr_laws_catalog(),
                           st))
            return false;
        bool ok = tr_verify_play(v, &scene, 0, result, st);
        if (ok) error[h] = fabs(result[0].measured - scene.checks[0].exact);
        tr_scene_free(&scene);
        if (!ok) return false;
    }
    return rows(v, text, quantity, log2(error[0] / error[1]),
                "friction acts from the second step on; swings of g/w_t average out", st);
}

/* ---- incline */

/* The law is a moment `moment` mu_r N R and a force `force` mu_r N up the slope. Friction F makes the rest of the spin,
 * m R a/2 = F R - moment mu_r N R, m a = m g sin - F - force mu_r N. So, with N = m g cos:
 *   rolls from tan(alpha) = (moment + force) mu_r with (2/3) g (sin - (moment + force) mu_r cos),
 *   slips from tan(alpha) = 3 mu - (2 moment - force) mu_r with g (sin - (mu + force mu_r) cos). */
static const struct resistance {
    const char *law, *more;
    double moment, force; /* of mu_r N R, and of mu_r N up the slope */
} resistances[] = {
    {"none", "", 0, 0},
    {"wang-spring", ", mu_r: 0.1", 1, 0},
    {"conjugate-spring", ", rolling_velocity: bagi-kuhn, mu_r: 0.1", 0.5, 0.5},
    {"star-force-proportional", ", mu_r: 0.1", 1, 0},
    {"star-constant-torque", ", mu_r: 0.1", 2, 0}, /* R_eq = 2 R at a floor, "the harmonic mean" */
    {"star-displacement-damping", ", mu_r: 0.1, theta_max: 0.001 deg, damping: yes, damping_multiplier: 0", 2, 0},
};

static bool on_slope(tr_verify *v, const char *law, double slope, const char *checks, const char *const *quantity,
                     tr_status *st) {
    char text[1600];
    snprintf(text, sizeof text,
             "kind: bodies\ntime_end: 0.3 s\n"
             "contact: {k_n: 100 MPa, k_t: 100 MPa, damping_ratio: 0.3, mu: 0.3, rolling: %s}\n"
             "gravity: {x: 9.81 m/s^2*sin(%.17g), y: -9.81 m/s^2*cos(%.17g)}\n"
             "disks: [{radius: 50 mm, density: 1200, x: 0, y: radius + density*pi*radius^2*gravity.y/contact.k_n}]\n"
             "walls: [{nx: 0, ny: 1}]\nchecks:\n%s",
             law, slope, slope, checks);
    return rows(v, text, quantity, NAN, "angles: bisection to 0.05 degrees; acceleration: swings, 0.1 % of g", st);
}

bool tr_exact_incline(tr_verify *v, tr_status *st) {
    static const char *const rolling[] = {"acceleration, rolling", "slope from which it slips",
                                          "slope from which it rolls", NULL},
                             *const slipping[] = {"acceleration, slipping", NULL};
    const double mu = 0.3, mu_r = 0.1;
    const struct resistance *r =
        tr_exact_find(v, "incline-", resistances, sizeof resistances / sizeof *resistances, sizeof *resistances, st);
    if (!r) return false;
    char law[160], checks[400];
    double rolls = (r->moment + r->force) * mu_r, slips = 3 * mu - (2 * r->moment - r->force) * mu_r;
    double between = atan(0.5 * (rolls + slips)), above = atan(1.2 * slips);
    snprintf(law, sizeof law, "%s%s", r->law, r->more);
    int n = snprintf(checks, sizeof checks,
                     "  - {what: acceleration, exact: %.17g, tolerance: 0.01}\n"
                     "  - {what: slips-from, exact: %.17g, tolerance: 0.05 deg}\n",
                     2.0 / 3 * 9.81 * (sin(between) - rolls * cos(between)), atan(slips));
    if (rolls > 0)
        snprintf(checks + n, sizeof checks - (size_t)n, "  - {what: rolls-from, exact: %.17g, tolerance: 0.05 deg}\n",
                 atan(rolls));
    if (!on_slope(v, law, between, checks, rolling, st)) return false;
    snprintf(checks, sizeof checks, "  - {what: acceleration, exact: %.17g, tolerance: 0.01}\n",
             9.81 * (sin(above) - (mu + r->force * mu_r) * cos(above)));
    return on_slope(v, law, above, checks, slipping, st);
}

bool tr_exact_no_spin(tr_verify *v, tr_status *st) {
    static const char *const quantity[] = {"acceleration", "slope from which it slips", "spin", NULL};
    char checks[400];
    double slope = atan(0.36);
    snprintf(checks, sizeof checks,
             "  - {what: acceleration, exact: %.17g, tolerance: 0.01}\n"
             "  - {what: slips-from, exact: %.17g, tolerance: 0.05 deg}\n"
             "  - {what: spin, over: 0.1 s, exact: 0, tolerance: 0.02}\n", /* swings: g/(w_t R) is 0.03 */
             9.81 * (sin(slope) - 0.3 * cos(slope)), atan(0.3));
    return on_slope(v, "wang-spring, mu_r: 0.6", slope, checks, quantity, st);
}

/* ---- coasting: a moment M brakes with (2/3) M/(m R), v0^2 over twice that is the way */

bool tr_exact_coasting(tr_verify *v, tr_status *st) {
    static const struct brake {
        const char *law, *more, *way; /* beyond 3 v0^2/(4 lever mu_r g) */
        double lever;
    } brakes[] = {
        {"wang-spring", ", k_r: 1 kPa", " + contact.mu_r*disks.0.density*pi*disks.0.radius^2*9.81 m/s^2/contact.k_r/2",
         1},
        {"star-force-proportional", "", "", 1},
        {"star-constant-torque", "", "", 2},
        {"star-displacement-damping", ", theta_max: 0.1", " + disks.0.radius*contact.theta_max/2", 2},
    };
    const struct brake *b = tr_exact_find(v, "coasting-", brakes, sizeof brakes / sizeof *brakes, sizeof *brakes, st);
    if (!b) return false;
    char text[1600];
    snprintf(
        text, sizeof text,
        "kind: bodies\ngravity: {y: -9.81 m/s^2}\ntime_end: 1.65 s\n"
        "contact: {k_n: 100 MPa, k_t: 100 MPa, damping_ratio: 0.3, mu: 0.5, rolling: %s, mu_r: 0.1%s}\n"
        "disks: [{radius: 100 mm, density: 1200, x: 0, y: radius + density*pi*radius^2*gravity.y/contact.k_n, "
        "vx: 1 m/s, spin: -vx/radius}]\nwalls: [{nx: 0, ny: 1}]\nchecks:\n"
        "  - {what: stop-distance, exact: 3/(4*%g)*disks.0.vx^2/(contact.mu_r*9.81 m/s^2)%s, tolerance: 0.002*exact}\n",
        b->law, b->more, b->lever, b->way);
    static const char *const quantity[] = {"way to rest", NULL};
    return rows(v, text, quantity, NAN, "the brake loads friction's spring in a swing, which takes g/w_t, 0.1 % of v0",
                st);
}
