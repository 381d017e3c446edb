/* SPDX-License-Identifier: MIT */
/* Friction laws along prescribed paths of one contact, against the closed forms of their equations and theories.
 *
 * At constant P and creepage xi from rest, with q = 1 - y^p and al = xi/F0 - 1, creep laws have [Kuhn2014 eqs. 11, 16]
 *   (1 - y) + al ln((y + al)/(1 + al)) = tau
 *   dahlberg-alfredsson   p = 2, tau = k_t F0 u_roll/(2 mu P), F0 = mu a/R_star
 *   kuhn-creep, spheres   p = 3, tau = 4 (u_roll/a)/((2 - nu) C11), F0 = 4 mu a/((1 - nu) C11 R_star) */
#include "verify/exact.h"

#include "patch/cattaneo.h"
#include <stdio.h>

static const double MU = 0.3, FORCE = 1e4;

static double transient(double al, double tau, double p) {
    double low = al < 0 ? -al : 0, high = 1; /* of y: the left side falls */
    for (int i = 0; i < 200; i++) {
        double y = 0.5 * (low + high);
        if (1 - y + al * log((y + al) / (1 + al)) < tau)
            high = y;
        else
            low = y;
    }
    return 1 - pow(high, p);
}

enum { MOST = 5 };
typedef struct leg {
    double slide, roll;
    int steps;
} leg;

/* Pressed first, then along the legs, MOST at most. */
static bool follow(const char *bodies, const char *law, const leg *legs, int n, tr_contact_state *end,
                   tr_scene_pair *pair, tr_status *st) {
    char text[1200];
    int used = snprintf(text, sizeof text,
                        "kind: contact\nbodies: {E: 70 GPa, nu: 0.15, %s}\nlaws: [{friction: %s, mu: %g}]\npath:\n"
                        "  - {force: %g, steps: 1}\n",
                        bodies, law, MU, FORCE);
    for (int k = 0; k < n; k++)
        used +=
            snprintf(text + used, sizeof text - (size_t)used, "  - {force: %g, slide: %.17g, roll: %.17g, steps: %d}\n",
                     FORCE, legs[k].slide, legs[k].roll, legs[k].steps);
    tr_contact_state all[MOST + 1];
    bool ok = tr_exact_path(text, all, n + 1, pair, st);
    for (int k = 0; k < n; k++) end[k] = all[k + 1];
    return ok;
}

static const char rollers[] = "R1: 10 mm, R2: 30 mm, Lambda: 4", balls[] = "R1: 10 mm, R2: 10 mm, shape: sphere";

/* ---- dahlberg-alfredsson */

/* q after L from q0, slid against it with xi = ratio F0. */
static double against(double q0, double ratio, double tau) {
    double z0 = sqrt(1 - q0), beta = 1 + ratio, to_0 = -(1 - z0) - beta * log((beta - 1) / (beta - z0));
    return -transient(ratio - 1, tau - to_0, 2); /* for tau > to_0 */
}

/* Only rolling: w = 1 - sqrt(1 - q), ln w - w falls by tau. */
static double relaxed(double q0, double tau) {
    double w0 = 1 - sqrt(1 - q0), low = 0, high = w0;
    for (int i = 0; i < 200; i++) {
        double w = 0.5 * (low + high);
        if (log(w / w0) - (w - w0) < -tau)
            low = w;
        else
            high = w;
    }
    return low * (2 - low);
}

bool tr_exact_dahlberg(tr_verify *v, tr_status *st) {
    tr_contact_state end[3];
    tr_scene_pair pair;
    leg nothing = {0, 0, 1};
    if (!follow(rollers, "cattaneo-mindlin", &nothing, 1, end, &pair, st)) return false;
    double a = end[0].a, F0 = MU * a / pair.R_star, k_t = 0.35 * pair.E_star, L = 3 * a, full = MU * FORCE;
    double tau = k_t * F0 * L / (2 * full), q1 = transient(-0.5, tau, 2), steady = 1 - 0.25;
    static const char law[] = "dahlberg-alfredsson, E_star: E_star, k_t: 0.35*E_star, step: exact",
                      euler[] = "dahlberg-alfredsson, E_star: E_star, k_t: 0.35*E_star",
                      rounding[] = "exact step: rounding of each";
    const leg reversed[] = {{0.5 * F0 * L, L, 7}, {-0.7 * F0 * 2 * L, -2 * L, 9}, {0, 0.5 * L, 3}};
    const leg fast = {1.5 * F0 * L / 3, L / 3, 5}, forever = {0.5 * F0 * 1e3 * L, 1e3 * L, 2};
    double back = against(q1, 0.7, 2 * tau), error[2];
    bool ok =
        follow(rollers, law, reversed, 3, end, NULL, st) &&
        tr_verify_add(
            v, &(tr_verify_row){"q, creepage 0.5 F0 from rest", "1", q1, end[0].Q / full, 1e-12, rounding, NAN, NULL},
            st) &&
        tr_verify_add(
            v, &(tr_verify_row){"q, turned back at 0.7 F0", "1", back, end[1].Q / full, 1e-12, rounding, NAN, NULL},
            st) &&
        tr_verify_add(v,
                      &(tr_verify_row){"q, rolling alone", "1", -relaxed(-back, tau / 2), end[2].Q / full, 1e-12,
                                       rounding, NAN, NULL},
                      st);
    ok =
        ok && follow(rollers, law, &fast, 1, end, NULL, st) &&
        tr_verify_add(v,
                      &(tr_verify_row){"q, creepage 1.5 F0 from rest", "1", transient(0.5, tau / 3, 2), end[0].Q / full,
                                       1e-12, rounding, NAN, NULL},
                      st) &&
        follow(rollers, law, &forever, 1, end, NULL, st) &&
        tr_verify_add(
            v, &(tr_verify_row){"steady q at 0.5 F0: Carter", "1", steady, end[0].Q / full, 1e-12, rounding, NAN, NULL},
            st);
    for (int h = 0; ok && h < 2; h++) {
        leg stepped[] = {reversed[0], reversed[1]};
        stepped[0].steps = stepped[1].steps = 200 << h;
        ok = follow(rollers, euler, stepped, 2, end, NULL, st);
        error[h] = end[1].Q / full - back;
    }
    return ok && tr_verify_add(v,
                               &(tr_verify_row){"q, turned back, backward Euler", "1", back, end[1].Q / full, 0.01,
                                                "first order: 400 steps of 1 % of the transient",
                                                log2(error[0] / error[1]), NULL},
                               st);
}

/* ---- cattaneo-mindlin */

/* A reversal is the virgin curve at twice its scale (Masing); back at its start the loop is closed and leaves no
 * memory. */
bool tr_exact_cattaneo(tr_verify *v, tr_status *st) {
    static const char *const quantity[] = {"Q/(mu P) loaded", "unloaded, then reversed", "loaded again, not yet closed",
                                           "loop closed", "beyond: the virgin curve"};
    static const double q[] = {0.8, -0.5, 0.4, 0.8, 0.95};
    static const char reason[] = "the law's overlap is found to 1e-12, its pieces keep 1e-12";
    tr_contact_state end[5];
    tr_scene_pair pair;
    leg legs[5] = {{0, 0, 1}};
    if (!follow(rollers, "cattaneo-mindlin", legs, 1, end, &pair, st)) return false;
    const tr_patch_pair c = {pair.R_star, pair.E_star, pair.d, MU};
    double u[5] = {tr_cattaneo_u(&c, FORCE, q[0])};
    u[1] = u[0] + 2 * tr_cattaneo_u(&c, FORCE, (q[1] - q[0]) / 2);
    u[2] = u[1] + 2 * tr_cattaneo_u(&c, FORCE, (q[2] - q[1]) / 2);
    u[3] = u[0], u[4] = tr_cattaneo_u(&c, FORCE, q[4]);
    for (int k = 0; k < 5; k++) legs[k] = (leg){u[k] - (k ? u[k - 1] : 0), 0, 5};
    bool ok = follow(rollers, "cattaneo-mindlin", legs, 5, end, NULL, st);
    for (int k = 0; ok && k < 5; k++)
        ok = tr_verify_add(
            v, &(tr_verify_row){quantity[k], "1", q[k], end[k].Q / (MU * FORCE), 1e-9, reason, NAN, NULL}, st);
    /* spheres: u = 3 (2 - nu) mu P/(8 G a) (1 - (1 - q)^(2/3)), G = (1 - nu) E_star [Johnson1985 sec. 7.2] */
    double sphere = 0.6, G;
    ok = ok && follow(balls, "cattaneo-mindlin, nu: 0.15", &(leg){0, 0, 1}, 1, end, &pair, st);
    G = 0.85 * pair.E_star;
    leg slide = {3 * 1.85 * MU * FORCE / (8 * G * end[0].a) * (1 - cbrt((1 - sphere) * (1 - sphere))), 0, 5};
    return ok && follow(balls, "cattaneo-mindlin, nu: 0.15", &slide, 1, end, NULL, st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"Q/(mu P) loaded, spheres (Mindlin)", "1", sphere, end[0].Q / (MU * FORCE),
                                          1e-9, reason, NAN, NULL},
                         st);
}

/* ---- kuhn-creep, vu-quoc-zhang: spheres */

bool tr_exact_kuhn_creep(tr_verify *v, tr_status *st) {
    static const double ratio[] = {0.2, 0.7, 1.5}, nu = 0.15, C11 = 3.40 + 0.72 * 0.6; /* linear in nu */
    tr_contact_state end[1];
    tr_scene_pair pair;
    if (!follow(balls, "cattaneo-mindlin", &(leg){0, 0, 1}, 1, end, &pair, st)) return false;
    double a = end[0].a, F0 = 4 * MU * a / ((1 - nu) * C11 * pair.R_star), tau = 0.3, L = tau * (2 - nu) * C11 * a / 4;
    for (int k = 0; k < 3; k++) {
        double want = transient(ratio[k] - 1, tau, 3), error[2];
        char quantity[80];
        for (int h = 0; h < 2; h++) {
            leg one = {-ratio[k] * F0 * L, k % 2 ? L : -L, 500 << h};
            if (!follow(balls, "kuhn-creep, nu: 0.15, E_star: E_star", &one, 1, end, NULL, st)) return false;
            error[h] = fabs(-end[0].Q / (MU * FORCE) - want);
        }
        snprintf(quantity, sizeof quantity, "q from rest, creepage %g F0", ratio[k]);
        if (!tr_verify_add(v,
                           &(tr_verify_row){quantity, "1", want, -end[0].Q / (MU * FORCE), 1e-6,
                                            "second order: (1/1000)^2", log2(error[0] / error[1]), NULL},
                           st))
            return false;
    }
    return true;
}

/* u = (pi/2) xi a (1 - exp(-(2/pi) u_roll/a)), and Q is Mindlin's of u. */
bool tr_exact_vu_quoc(tr_verify *v, tr_status *st) {
    tr_contact_state end[1];
    tr_scene_pair pair;
    if (!follow(balls, "cattaneo-mindlin", &(leg){0, 0, 1}, 1, end, &pair, st)) return false;
    double a = end[0].a, full = 3 * 1.85 * MU * FORCE / (8 * 0.85 * pair.E_star * a), xi = 0.4 * full / a;
    for (int k = 0; k < 2; k++) {
        double roll = k ? 100 : 1, u = M_PI / 2 * xi * a * -expm1(-2 / M_PI * roll), y = 1 - u / full;
        leg one = {xi * roll * a, roll * a, 10};
        if (!follow(balls, "vu-quoc-zhang, nu: 0.15, E_star: E_star", &one, 1, end, NULL, st) ||
            !tr_verify_add(v,
                           &(tr_verify_row){k ? "Q/(mu P), steady rolling" : "Q/(mu P) after a roll of a", "1",
                                            1 - y * sqrt(y), end[0].Q / (MU * FORCE), 1e-9,
                                            "exact step; the law's pieces keep 1e-12", NAN, NULL},
                           st))
            return false;
    }
    return true;
}
