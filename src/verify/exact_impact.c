/* SPDX-License-Identifier: MIT */
/* Impacts of two free disks (or spheres), and of one on a wall, against closed forms.
 *
 * Normal, spring and dashpot of ratio z = sin q, w = sqrt(k/m_eff), delta'' = -2 z w delta' - w^2 delta. Here a contact
 * ends when its force reaches 0, t = (pi - 2q)/(w cos q), e = exp(-z w t). The other rule in use, overlap 0, lets the
 * force pull: t = pi/(w cos q), e = exp(-pi tan q).
 * Oblique: along t a contact moves m_eff/3 (1 from translation, 2 from the spins of disks). Without slip or damping V_s
 * turns to cos(pi sqrt(3 k_t/k_n)) of itself; the spring then still holds energy. With slip from the first to the last
 * step the impulse is mu (1 + e) m_eff v_n: V_s changes by 3 mu (1 + e) v_n, of a disk on a wall v_t by mu (1 + e) v_n
 * and the spin by 2/R times that. */
#include "verify/exact.h"
#include "verify/exact_strike.h"

#include <stdio.h>
#include <string.h>

typedef struct wanted {
    const char *quantity, *unit;
    size_t what;
    double exact, tolerance;
    const char *reason, *outcome;
} wanted;

/* With these, two steps cannot show the order of the error. */
static const char whole_steps[] = "a contact lasts a whole number of steps",
                  loading[] =
                      "friction's spring takes a time to its bound, longer where a dashpot makes the bound jump",
                  kinked[] = "second order, and a stiffness that starts from 0 like 1/ln(overlap)";
static const char first_order[] =
    "first order: the dashpot's velocity is half a step old, its force begins with a jump",
                  second_order[] = "second order: leapfrog keeps the energy of a spring but for the kinks at both ends";

/* At 400 steps in the contact; order against 200, if the step is the cause of the error. */
static bool row(tr_verify *v, const tr_blow *b, const wanted *w, tr_status *st) {
    double coarse = NAN, fine = NAN;
    if (!tr_verify_go_on(v, st) || !tr_strike_farthest(b, 200, w->what, w->exact, &coarse, st) ||
        !tr_strike_farthest(b, 400, w->what, w->exact, &fine, st))
        return false;
    const tr_verify_row row = {w->quantity,
                               w->unit,
                               w->exact,
                               fine,
                               w->tolerance,
                               w->reason,
                               w->reason == whole_steps || w->reason == loading || w->reason == kinked
                                   ? NAN
                                   : log2(fabs(coarse - w->exact) / fabs(fine - w->exact)),
                               w->outcome};
    return tr_verify_add(v, &row, st);
}

bool tr_exact_impact(tr_verify *v, tr_status *st) {
    static const double zeta[] = {0, 0.1, 0.3, 0.8};
    for (int z = 0; z < 4; z++) {
        tr_blow b = {.wall = z == 3};
        double q = asin(zeta[z]), w = sqrt(TR_BLOW_K / tr_blow_m_eff(&b)), t = (M_PI - 2 * q) / (w * cos(q)),
               h = 1.0 / 400;
        snprintf(b.contact, sizeof b.contact, "k_n: %g, damping_ratio: %g", TR_BLOW_K, zeta[z]);
        b.time = M_PI / w, b.v_n = tr_blow_small_speed(&b);
        char quantity[2][80], other[2][80];
        snprintf(quantity[0], 80, "restitution, damping ratio %g%s", zeta[z], b.wall ? ", wall" : "");
        snprintf(quantity[1], 80, "duration, damping ratio %g%s", zeta[z], b.wall ? ", wall" : "");
        snprintf(other[0], 80, "(ended at overlap 0: %.4f)", exp(-M_PI * tan(q)));
        snprintf(other[1], 80, "(ended at overlap 0: %.4g s)", M_PI / (w * cos(q)));
        const wanted want[] = {
            {quantity[0], "1", offsetof(tr_rebound, e), exp(-zeta[z] * w * t),
             z ? M_PI * h * (zeta[z] + 0.05) : 0.1 * h * h, z ? first_order : second_order, other[0]},
            {quantity[1], "s", offsetof(tr_rebound, duration), t, 2.5 * h * b.time, whole_steps, other[1]},
        };
        if (!row(v, &b, &want[0], st) || !row(v, &b, &want[1], st)) return false;
    }
    return true;
}

/* The overlap at which a line contact holds the energy E: int P ddelta = P^2 (Lambda + 1/4)/(pi E*), Lambda =
 * ln(2d/a). */
static double line_peak(double E, double E_star, double R_star, double depth) {
    double low = 0, high = M_PI * E_star * depth * depth / R_star; /* Lambda = 0 */
    for (int i = 0; i < 200; i++) {
        double P = 0.5 * (low + high), Lambda = log(2 * depth / sqrt(4 * P * R_star / (M_PI * E_star)));
        if (P * P * (Lambda + 0.25) / (M_PI * E_star) < E)
            low = P;
        else
            high = P;
    }
    return low;
}

/* All of the energy is in the contact: springs v sqrt(k m_eff); spheres [Johnson1985 sec. 11.4] delta = (15 m_eff
 * v^2/(16 E* sqrt(R)))^(2/5), P = (4/3) E* sqrt(R) delta^(3/2). */
bool tr_exact_peak(tr_verify *v, tr_status *st) {
    const double E_star = 1e9, R_star = TR_BLOW_RADIUS / 2, depth = 0.008, h = 1.0 / 400;
    tr_blow spring = {.contact = "k_n: 1e6, damping_ratio: 0"};
    spring.v_n = tr_blow_small_speed(&spring), spring.time = M_PI * sqrt(tr_blow_m_eff(&spring) / TR_BLOW_K);
    tr_blow line = {.contact = "normal: hertz-line, E_star: 1e9, depth: 0.008, damping_ratio: 0", .v_n = 0.01};
    double P = line_peak(0.5 * tr_blow_m_eff(&line) * line.v_n * line.v_n, E_star, R_star, depth);
    line.time = M_PI * tr_blow_m_eff(&line) * line.v_n / P;
    tr_blow ball = {.sphere = true, .contact = "normal: hertz-sphere, E_star: 1e9, damping_ratio: 0", .v_n = 0.01};
    double delta = pow(15 * tr_blow_m_eff(&ball) * ball.v_n * ball.v_n / (16 * E_star * sqrt(R_star)), 0.4);
    ball.time = 2.9432 * delta / ball.v_n;
    static const char reason[] = "second order, and the peak is up to half a step beside a step";
    const wanted want[] = {{"peak force, spring", "N/m", offsetof(tr_rebound, peak),
                            spring.v_n * sqrt(TR_BLOW_K * tr_blow_m_eff(&spring)), 0, reason, NULL},
                           {"peak force, Hertz line contact", "N/m", offsetof(tr_rebound, peak), P, 0, kinked, NULL},
                           {"peak force, Hertz spheres", "N", offsetof(tr_rebound, peak),
                            4.0 / 3 * E_star * sqrt(R_star) * pow(delta, 1.5), 0, reason, NULL},
                           {"duration, Hertz spheres", "s", offsetof(tr_rebound, duration), ball.time,
                            2.5 * h * ball.time, whole_steps, NULL}};
    const tr_blow *blows[] = {&spring, &line, &ball, &ball};
    for (int k = 0; k < 4; k++) {
        wanted one = want[k];
        if (k < 3) one.tolerance = 5 * h * h * one.exact; /* (pi h/2)^2/2 beside the peak, as much for the step */
        if (!row(v, blows[k], &one, st)) return false;
    }
    return true;
}

bool tr_exact_sticking(tr_verify *v, tr_status *st) {
    static const double ratio[] = {0.05, 0.2, 0.5, 1};
    for (int k = 0; k < 4; k++) {
        tr_blow b = {.wall = k % 2};
        char quantity[80];
        snprintf(quantity, sizeof quantity, "V_s after, k_t/k_n = %g%s", ratio[k], b.wall ? ", wall" : "");
        snprintf(b.contact, sizeof b.contact, "k_n: %g, damping_ratio: 0, mu: 100, k_t: %g", TR_BLOW_K,
                 ratio[k] * TR_BLOW_K);
        double w_t = sqrt(3 * ratio[k]);
        b.time = M_PI * sqrt(tr_blow_m_eff(&b) / TR_BLOW_K), b.v_n = tr_blow_small_speed(&b), b.v_s = 0.3 * b.v_n;
        const wanted want = {quantity,
                             "m/s",
                             offsetof(tr_rebound, v_s),
                             cos(M_PI * w_t) * b.v_s,
                             2 * M_PI * w_t / 400 * b.v_s,
                             "first order: Q acts up to a step too long or short at both ends",
                             NULL};
        if (!row(v, &b, &want, st)) return false;
    }
    return true;
}

bool tr_exact_sliding(tr_verify *v, tr_status *st) {
    for (int k = 0; k < 4; k++) {
        double zeta = k % 2 ? 0.3 : 0, mu = 0.2, q = asin(zeta), e = exp(-tan(q) * (M_PI - 2 * q));
        tr_blow b = {.wall = k / 2};
        char quantity[80];
        snprintf(quantity, sizeof quantity, "V_s after, %s, damping ratio %g", b.wall ? "wall" : "two disks", zeta);
        snprintf(b.contact, sizeof b.contact, "k_n: %g, damping_ratio: %g, mu: %g, k_t: %g", TR_BLOW_K, zeta, mu,
                 TR_BLOW_K);
        b.time = M_PI * sqrt(tr_blow_m_eff(&b) / TR_BLOW_K), b.v_n = tr_blow_small_speed(&b),
        b.v_s = (b.wall ? -5 : 5) * b.v_n;
        double change = 3 * mu * (1 + e) * b.v_n;
        const wanted want = {quantity,
                             "m/s",
                             offsetof(tr_rebound, v_s),
                             b.v_s - copysign(change, b.v_s),
                             (zeta > 0 ? 1e-2 : 1e-4) * change,
                             loading,
                             NULL};
        if (!row(v, &b, &want, st)) return false;
    }
    return true;
}

bool tr_exact_spin(tr_verify *v, tr_status *st) {
    tr_blow b = {.wall = true, .contact = "k_n: 1e6, damping_ratio: 0, mu: 0.2, k_t: 1e6"};
    b.time = M_PI * sqrt(tr_blow_m_eff(&b) / TR_BLOW_K), b.v_n = tr_blow_small_speed(&b),
    b.spin = 5 * b.v_n / TR_BLOW_RADIUS;
    double change = 0.2 * 2 * b.v_n;
    const wanted want[] = {
        {"velocity along the wall after", "m/s", offsetof(tr_rebound, v_t), -change, 1e-4 * change, loading, NULL},
        {"spin after", "rad/s", offsetof(tr_rebound, spin), b.spin - 2 * change / TR_BLOW_RADIUS,
         2e-4 * change / TR_BLOW_RADIUS, loading, NULL}};
    return row(v, &b, &want[0], st) && row(v, &b, &want[1], st);
}

bool tr_exact_damped(tr_verify *v, tr_status *st) {
    for (int k = 0; k < 2; k++) {
        double zeta = k ? 0.3 : 0.05, q = asin(zeta), e = exp(-tan(q) * (M_PI - 2 * q));
        tr_blow b = {0};
        char quantity[80];
        snprintf(quantity, sizeof quantity, "share of the energy that is damped, ratio %g", zeta);
        snprintf(b.contact, sizeof b.contact, "k_n: %g, damping_ratio: %g", TR_BLOW_K, zeta);
        b.time = M_PI * sqrt(tr_blow_m_eff(&b) / TR_BLOW_K), b.v_n = tr_blow_small_speed(&b);
        const wanted want = {quantity,    "1", offsetof(tr_rebound, damped), 1 - e * e, 2 * M_PI / 400 * (zeta + 0.05),
                             first_order, NULL};
        if (!row(v, &b, &want, st)) return false;
    }
    return true;
}

/* Undamped, law by law, at angles from steep to grazing and any spin: the largest remaining energy. */
bool tr_exact_grazing(tr_verify *v, tr_status *st) {
    static const char *const law[][2] = {{"coulomb-spring", "k_t: 5e5"},
                                         {"coulomb-spring", "k_t: 1e6, rolling: wang-spring, mu_r: 0.3"},
                                         {"dahlberg-alfredsson", "k_t: 5e5, E_star: 1e7"},
                                         {"cattaneo-mindlin", "nu: 0.3"},
                                         {"kuhn-creep", "E_star: 1e7"},
                                         {"vu-quoc-zhang", "E_star: 1e7"}};
    for (int l = 0; l < 6; l++) {
        double most = 0;
        for (int k = 0; k < 60; k++) {
            tr_rebound r;
            tr_blow b = {.wall = k % 2};
            snprintf(b.contact, sizeof b.contact, "k_n: %g, damping_ratio: 0, mu: 0.3, friction: %s, %s", TR_BLOW_K,
                     law[l][0], law[l][1]);
            b.time = M_PI * sqrt(tr_blow_m_eff(&b) / TR_BLOW_K), b.v_n = tr_blow_small_speed(&b);
            b.v_s = pow(10, k / 15.0 - 2) * b.v_n, b.spin = (k % 3 - 1) * 0.7 * b.v_s / TR_BLOW_RADIUS;
            if (!tr_strike(&b, 400, k / 60.0, &r, st)) return false;
            most = fmax(most, r.energy - 1);
        }
        char quantity[80];
        snprintf(quantity, sizeof quantity, "gain, %s%s", law[l][0],
                 strstr(law[l][1], "rolling") ? ", wang-spring" : "");
        if (!tr_verify_go_on(v, st) ||
            !tr_verify_add(v,
                           &(tr_verify_row){quantity, "1", 0, most, 1e-5,
                                            "second order: (pi/400)^2/10 of the energy of the spring", NAN, NULL},
                           st))
            return false;
    }
    return true;
}
