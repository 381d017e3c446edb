/* SPDX-License-Identifier: MIT */
/* Definitions of rolling and sliding under other observers, and errata of the sources: the right number, the number of
 * the code, and in words the number of the printed formula. tests/README.md has the list. */
#include "verify/exact.h"

#include "base/alloc.h"
#include "base/random.h"
#include "laws/law.h"
#include "study/measures.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- observers */

enum { MOTIONS = 64 };

/* Seen by an observer who moves with -V and turns with -W about the origin. */
static tr_motion seen(tr_motion m, double Vx, double Vy, double W) {
    m.v1x += Vx - W * m.x1y, m.v1y += Vy + W * m.x1x, m.w1 += W;
    m.v2x += Vx - W * m.x2y, m.v2y += Vy + W * m.x2x, m.w2 += W;
    return m;
}

static tr_motion any_pair(tr_random *r) {
    double angle = 2 * M_PI * tr_random_uniform(r), R1 = 1 + tr_random_uniform(r), R2 = 1 + 9 * tr_random_uniform(r);
    double L = (R1 + R2) * (1 - 0.1 * tr_random_uniform(r));
    tr_motion m = {
        .R1 = R1, .R2 = R2, .x1x = 0.3, .x1y = -0.2, .x2x = 0.3 + L * cos(angle), .x2y = -0.2 + L * sin(angle)};
    double *velocity[] = {&m.v1x, &m.v1y, &m.v2x, &m.v2y, &m.w1, &m.w2};
    for (int k = 0; k < 6; k++) *velocity[k] = 2 * tr_random_uniform(r) - 1;
    return m;
}

static double change(const tr_motion_measures *m, const char *name) {
    double most = 0;
    for (int i = 0; i < MOTIONS; i++)
        for (int observer = 1; observer < 3; observer++) {
            double gap =
                fabs(tr_measures_of_column(&m[3 * i + observer], name) - tr_measures_of_column(&m[3 * i], name));
            most = gap <= most ? most : gap; /* NaN stays */
        }
    return most;
}

/* Of the definitions that claim to be objective. */
static bool rows_of(tr_verify *v, const tr_motion_measures *m, const tr_velocity_measure *row, int n, tr_status *st) {
    bool ok = true;
    for (int k = 0; ok && k < n; k++) {
        char quantity[80];
        if (!(row[k].claims & TR_DEFINES_OBJECTIVE)) continue;
        snprintf(quantity, sizeof quantity, "change of %s", row[k].column);
        ok = tr_verify_add(v,
                           &(tr_verify_row){quantity, row[k].claims & TR_DEFINES_ANGLE ? "rad/s" : "m/s", 0,
                                            change(m, row[k].column), 1e-12, "rounding of velocities of 100 m/s", NAN,
                                            NULL},
                           st);
    }
    return ok;
}

bool tr_exact_observers(tr_verify *v, tr_status *st) {
    const double W = 7, V = 5;
    tr_motion *motion = tr_alloc(3 * MOTIONS, sizeof *motion, st);
    tr_motion_measures *m = tr_alloc(3 * MOTIONS, sizeof *m, st);
    tr_random r = tr_random_seed(6, 1);
    double slides = 0; /* eq. 12 as printed: overlap times W */
    for (int i = 0; m && motion && i < MOTIONS; i++) {
        tr_motion p = motion[3 * i] = any_pair(&r);
        motion[3 * i + 1] = seen(p, V, -V, 0), motion[3 * i + 2] = seen(p, 0, 0, W);
        slides = fmax(slides, W * (p.R1 + p.R2 - hypot(p.x2x - p.x1x, p.x2y - p.x1y)));
    }
    bool ok = m && motion && tr_measures_motions(motion, 3 * MOTIONS, m, st);
    ok = ok && rows_of(v, m, tr_rolling_velocities, tr_n_rolling_measures, st) &&
         rows_of(v, m, tr_sliding_velocities, tr_n_sliding_measures, st);
    ok = ok && tr_verify_add(v,
                             &(tr_verify_row){"change of Vs_full_radii", "m/s", slides, change(m, "Vs_full_radii"),
                                              1e-12 * slides, "rounding", NAN,
                                              "(not objective: slides by overlap times spin)"},
                             st);
    free(m), free(motion);
    return ok;
}

/* ---- errata */

static bool rotation(tr_verify *v, tr_status *st) {
    const double R1 = 2, R2 = 0.75, w = 0.37, lap = 0.1;
    const tr_motion still = {.R1 = R1, .R2 = R2, .x2x = R1 + R2}, pressed = {.R1 = R1, .R2 = R2, .x2x = R1 + R2 - lap};
    const tr_motion motion[] = {seen(still, 0, 0, w), seen(pressed, 0, 0, w)};
    tr_motion_measures m[2];
    char printed[3][80];
    /* V21 = w L along k x n; the paper's t = n x k turns its sign */
    snprintf(printed[0], 80, "(with the printed t: %.4g)", 0.5 * (R1 * w - R2 * w - (R2 - R1) * w));
    snprintf(printed[1], 80, "(with R1 + R2 for |X21|: %.4g)", 0.5 * (R1 - R2) * w * lap / (R1 + R2));
    snprintf(printed[2], 80, "(with arms R1, R2: %.4g)", R1 * w + R2 * w - w * (R1 + R2 - lap));
    return tr_measures_motions(motion, 2, m, st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"Wang eq. 16, rigid rotation rolls with", "m/s", 0,
                                          tr_measures_of_column(&m[0], "Vr_bagi_kuhn"), 1e-15, "rounding", NAN,
                                          printed[0]},
                         st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"Wang eq. 16, the same with overlap", "m/s", 0,
                                          tr_measures_of_column(&m[1], "Vr_bagi_kuhn"), 1e-15, "rounding", NAN,
                                          printed[1]},
                         st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"Wang eq. 12, with overlap slides with", "m/s", 0,
                                          tr_measures_of_column(&m[1], "Vs_wang"), 1e-15, "rounding", NAN, printed[2]},
                         st);
}

#define PAIR "kind: contact\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3}\n"

/* Rolled on a millionth of a without sliding, from Q = -0.5 mu P: dQ = -k F |du_roll| sgn(Q). */
static bool unsigned_creep(tr_verify *v, tr_status *st) {
    static const char text[] =
        PAIR "laws: [{friction: dahlberg-alfredsson, mu: 0.3, E_star: E_star, k_t: 0.3*E_star}]\n"
             "path:\n  - {force: 1e4, slide: -0.15*P/(0.3*E_star), steps: 1}\n"
             "  - {force: P, roll: 1e-6*a, steps: 1}\n";
    tr_contact_state end[2];
    tr_scene_pair pair;
    if (!tr_exact_path(text, end, 2, &pair, st)) return false;
    double right = 0.3 * pair.E_star * 0.3 * end[0].a / pair.R_star * (1 - sqrt(0.5)) * 1e-6 * end[0].a;
    char printed[80];
    snprintf(printed, sizeof printed, "(as printed, without sgn(Q): %.4g)", -right);
    return tr_verify_add(v,
                         &(tr_verify_row){"Kuhn eq. 11, dQ while rolling, Q < 0", "N/m", right, end[1].Q - end[0].Q,
                                          1e-5 * right, "the step: 1e-6 a; Q rounds at 1e-9 of dQ", NAN, printed},
                         st);
}

static bool star(tr_verify *v, tr_status *st) {
    static const char text[] = PAIR "laws: [{rolling: %s, mu_r: 0.1}]\npath: [{force: 1e4, roll: 1 mm, steps: 1}]\n";
    static const char *const law[] = {"star-force-proportional", "star-constant-torque"},
                             *const quantity[] = {"STAR eq. 3275, moment on 1 (its spin < 0)",
                                                  "STAR eq. 3276, moment on 1"};
    for (int k = 0; k < 2; k++) {
        char full[400], printed[80];
        tr_contact_state end[1];
        double right = 0.1 * 1e4 * (k ? 2 * 0.01 * 0.03 / 0.04 : 0.01);
        snprintf(full, sizeof full, text, law[k]);
        snprintf(printed, sizeof printed, k ? "(R_eq in common use, half: %g)" : "(as printed, without the minus: %g)",
                 k ? right / 2 : -right);
        if (!tr_exact_path(full, end, 1, NULL, st) ||
            !tr_verify_add(
                v, &(tr_verify_row){quantity[k], "N", right, end[0].moment_1, 1e-12 * right, "rounding", NAN, printed},
                st))
            return false;
    }
    return true;
}

bool tr_exact_errata(tr_verify *v, tr_status *st) {
    return rotation(v, st) && unsigned_creep(v, st) && star(v, st);
}
