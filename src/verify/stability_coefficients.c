/* SPDX-License-Identifier: MIT */
/* A disk on a slope with coefficients and stiffnesses of any size, and on the very threshold. I = m R^2/2:
 *
 *   rolls freely        a = (2/3) g sin(alpha)                            tan(alpha) < 3 mu
 *   rolls with moment   a = (2/3) g (sin(alpha) - mu_r cos(alpha))        mu_r < tan(alpha) < 3 mu - 2 mu_r
 *   slides, blocked     a = g (sin(alpha) - mu cos(alpha))                mu < tan(alpha), mu < mu_r
 *   rests               a = 0                                             tan(alpha) <= mu, mu_r
 *
 * The acceleration is the change of speed over the run, 0.3 s. The springs yield under the sudden weight and leave a
 * swing of g/sqrt(3 k/m), 2 mm/s at k = 100 MPa, 0.006 m/s^2 over the run; the rows allow three times that. */
#include "verify/stability.h"
#include <stdio.h>

static const char slope[] =
    "kind: bodies\ntime_end: 0.3 s\n"
    "contact: {k_n: 100 MPa, k_t: 100 MPa, damping_ratio: 0.3, friction: coulomb-spring, mu: 0.3, rolling: none}\n"
    "gravity: {x: 9.81 m/s^2*sin(20 deg), y: -9.81 m/s^2*cos(20 deg)}\n"
    "disks: [{radius: 50 mm, density: 1200, x: 0, y: radius + density*pi*radius^2*gravity.y/contact.k_n}]\n"
    "walls: [{nx: 0, ny: 1}]\n"
    "checks: [{what: acceleration, exact: 0, tolerance: 0.02 m/s^2}]\n";
static const char why[] = "three swings of the springs, g sqrt(m/(3 k)), over the run";

typedef struct variant {
    const char *what, *set[6];
} variant;

#define STEEP "gravity.x=9.81 m/s^2*sin(80 deg)", "gravity.y=-9.81 m/s^2*cos(80 deg)"

static const variant coefficients[] = {
    {"mu 0", {"contact.mu=0", "checks.0.exact=gravity.x"}},
    {"mu 10, slope 80 deg", {"contact.mu=10", STEEP, "checks.0.exact=2/3*gravity.x"}},
    {"mu 10, mu_r 100, slope 80 deg", {"contact.mu=10", "contact.rolling=wang-spring", "contact.mu_r=100", STEEP}},
    {"mu 0.3, mu_r 100",
     {"contact.rolling=wang-spring", "contact.mu_r=100", "checks.0.exact=gravity.x + contact.mu*gravity.y"}},
    {"mu_r 0", {"contact.rolling=wang-spring", "contact.mu_r=0", "checks.0.exact=2/3*gravity.x"}},
    {"k_r 1e6 k_n",
     {"contact.rolling=wang-spring", "contact.mu_r=0.1", "contact.k_r=1e6*k_n", "time_end=0.03 s",
      "checks.0.tolerance=0.2 m/s^2", "checks.0.exact=2/3*(gravity.x + contact.mu_r*gravity.y)"}},
    {"k_t 1e6 k_n",
     {"contact.k_t=1e6*k_n", "time_end=0.03 s", "checks.0.tolerance=0.2 m/s^2", "checks.0.exact=2/3*gravity.x"}},
    {"k_t 1e-6 k_n",
     {"contact.k_n=1e14", "contact.k_t=1e-6*k_n", "step.safety=0.9", "time_end=0.03 s", "checks.0.tolerance=0.2 m/s^2",
      "checks.0.exact=2/3*gravity.x"}},
};

#define AT_MU_R "contact.mu_r=0.1", "gravity.x=0.1*9.81 m/s^2", "gravity.y=-9.81 m/s^2"

static const variant thresholds[] = {
    {"tan(alpha) = mu_r, wang-spring", {"contact.rolling=wang-spring", AT_MU_R}},
    {"tan(alpha) = mu_r, conjugate-spring of bagi-kuhn",
     {"contact.rolling=conjugate-spring", "contact.rolling_velocity=bagi-kuhn", AT_MU_R}},
    {"tan(alpha) = mu_r, star-force-proportional", {"contact.rolling=star-force-proportional", AT_MU_R}},
    {"tan(alpha) = mu_r, star-constant-torque", {"contact.rolling=star-constant-torque", "contact.R_eq=half", AT_MU_R}},
    {"tan(alpha) = mu_r, star-displacement-damping",
     {"contact.rolling=star-displacement-damping", "contact.theta_max=1e-4", "contact.R_eq=half", AT_MU_R}},
    {"tan(alpha) = mu, blocked", {"disks.0.motion=driven", "gravity.x=0.3*9.81 m/s^2", "gravity.y=-9.81 m/s^2"}},
};

static bool all(tr_verify *v, const variant *variants, size_t n, tr_status *st) {
    for (size_t i = 0; i < n; i++) {
        int sets = 0, first = v->n;
        while (sets < 6 && variants[i].set[sets]) sets++;
        if (!tr_verify_scene(v, slope, variants[i].set, sets, 0, why, st)) return false;
        for (int k = first; k < v->n; k++)
            snprintf(v->row[k].quantity, sizeof v->row[k].quantity, "acceleration, %s", variants[i].what);
    }
    return true;
}

bool tr_stability_coefficients(tr_verify *v, tr_status *st) {
    return all(v, coefficients, sizeof coefficients / sizeof *coefficients, st);
}

bool tr_stability_thresholds(tr_verify *v, tr_status *st) {
    return all(v, thresholds, sizeof thresholds / sizeof *thresholds, st);
}
