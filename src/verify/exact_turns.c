/* SPDX-License-Identifier: MIT */
/* Moments, spins and turning gravity, against closed forms.
 *
 *   sign-laws  A spin that the cap allows to stop is stopped within the step, friction's torque of that step included.
 *              Force proportional: I w' = I w + (M - r Q) dt = 0 of each body. Constant torque: the same of w1 - w2.
 *   conjugate  Power of the law on the bodies: -T V_r with V_r = (s1 + s2)/2, s1 = R1 (w1 + Vt/L), s2 = -R2 (w2 +
 *              Vt/L). And the swing of a pair of unequal free disks: V_s and V_r are linear in (y1, y2, w1, w2), g_s =
 *              (-1, 1, r1, r2), g_r = (-e, e, R1/2, -R2/2), e = (R1 - R2)/(2L); the largest eigenvalue of M^-1 (k_t
 *              g_s g_s' + k_r g_r g_r') is w^2, the limit of the step 2/w.
 *   store      A rolling spring holds the work that loads it.
 *   share      Of two contacts that roll and slide: sum |V_r|/sum (|V_r| + |V_s|).
 *   gravity    turns at the rate w from g0: v = (1/w) (sin wt, cos wt - 1; 1 - cos wt, sin wt) g0. */
#include "verify/exact.h"
#include "verify/exact_tile.h"

#include "base/alloc.h"
#include "core/bodies.h"
#include "core/measures.h"
#include "core/record.h"
#include "core/step.h"
#include "core/timestep.h"
#include <stdlib.h>
#include <string.h>

/* ---- sign laws */

/* The largest spin that is left, of each body or relative, over the largest at the start. */
static double spin_left(tr_pairs_tile *p, bool relative) {
    const double w0 = 1e-4, dt = 1e-3;
    tr_tile *t = &p->tile;
    double most = 0;
    for (int i = 0; i < TR_PAIRS; i++) {
        tr_pairs_drive(p, i, (tr_pair_motion){.delta = 0.05, .w1 = i % 3 * w0, .w2 = (1 - i % 2) * w0});
        t->f_t[i] =
            (i % 2 ? 1 : -1) * 0.5 * (1 + i); /* no friction law writes it; the cap of moments is 100 N or more */
    }
    tr_pairs_run(p, dt);
    for (int i = 0; i < TR_PAIRS; i++) {
        double m1 = 10 * p->R1[i] * p->R1[i], m2 = 10 * p->R2[i] * p->R2[i]; /* exact_tile.c */
        double one = t->w1[i] + dt * t->q1[i] / (0.5 * m1 * p->R1[i] * p->R1[i]);
        double two = t->w2[i] + dt * t->q2[i] / (0.5 * m2 * p->R2[i] * p->R2[i]);
        most = fmax(most, relative ? fabs(one - two) : fmax(fabs(one), fabs(two)));
    }
    return most / w0;
}

bool tr_exact_sign_laws(tr_verify *v, tr_status *st) {
    static const tr_law *const law[] = {&tr_rolling_star_force_proportional, &tr_rolling_star_constant_torque};
    static const char *const quantity[] = {"force proportional: spin left", "constant torque: relative spin left"};
    tr_pairs_tile *p = tr_alloc(1, sizeof *p, st);
    bool ok = p;
    for (int k = 0; k < 2 && ok; k++) {
        tr_pairs_set(p, TR_ROLLING_SLOT, law[k]);
        ok = tr_verify_add(
            v,
            &(tr_verify_row){quantity[k], "1", 0, spin_left(p, k), 1e-12, "rounding of torques that cancel", NAN, NULL},
            st);
    }
    free(p);
    return ok;
}

/* ---- the conjugate law */

/* Power on the bodies and -T V_r: the largest difference over the largest power. T is of one step from rest, k_r V_r
 * dt. */
static double power_off(tr_pairs_tile *p) {
    const double k_r = 2e6, dt = 1e-6;
    const tr_tile *t = &p->tile;
    double most = 0, off = 0;
    for (int i = 0; i < TR_PAIRS; i++)
        tr_pairs_drive(p, i, (tr_pair_motion){.delta = 0.05, .Vt = 1 - 0.3 * i, .w1 = 0.2 * i, .w2 = 0.7 - 0.1 * i});
    tr_pairs_run(p, dt);
    for (int i = 0; i < TR_PAIRS; i++) {
        double L = hypot(t->dx[i], t->dy[i]), Vt = 1 - 0.3 * i; /* exact_tile.h: along t = (ny, -nx) */
        double V_r = (p->R1[i] * (t->w1[i] + Vt / L) - p->R2[i] * (t->w2[i] + Vt / L)) / 2, T = k_r * V_r * dt;
        double fx = t->fx[i] - t->f_n[i] * p->nx[i], fy = t->fy[i] - t->f_n[i] * p->ny[i]; /* less the normal force */
        double power = fx * t->dvx[i] + fy * t->dvy[i] + t->q1[i] * t->w1[i] + t->q2[i] * t->w2[i];
        most = fmax(most, fabs(T * V_r)), off = fmax(off, fabs(power + T * V_r));
    }
    return off / most;
}

/* 2/w of two free disks that touch, radii R1 and R2. */
static double pair_limit(double R1, double R2, double delta, double k_t, double k_r) {
    double L = R1 + R2 - delta, r1 = R1 * L / (R1 + R2), e = (R1 - R2) / (2 * L);
    double m1 = 1000 * M_PI * R1 * R1, m2 = 1000 * M_PI * R2 * R2;
    const double inverse[4] = {1 / m1, 1 / m2, 2 / (m1 * R1 * R1), 2 / (m2 * R2 * R2)};
    const double g[2][4] = {{-1, 1, r1, L - r1}, {-e, e, R1 / 2, -R2 / 2}}, k[2] = {k_t, k_r};
    double a[2][2] = {{0}};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            for (int c = 0; c < 4; c++) a[i][j] += sqrt(k[i] * k[j]) * g[i][c] * inverse[c] * g[j][c];
    double mean = 0.5 * (a[0][0] + a[1][1]), spread = hypot(0.5 * (a[0][0] - a[1][1]), a[0][1]);
    return 2 / sqrt(mean + spread);
}

static bool limit_row(tr_verify *v, double R2, tr_status *st) {
    const double R1 = 0.01, delta = 1e-5;
    tr_world w;
    bool ok = tr_world_init(&w, 2, TR_SHAPE_DISK, st);
    for (int i = 0; i < 2 && ok; i++)
        tr_world_set_disk(&w, i, &(tr_disk_start){i * (R1 + R2 - delta), 0, 0, i ? R2 : R1, 1000, false});
    w.dt = 1e-12;
    ok = ok &&
         tr_exact_laws(
             &w, "k_n: 1e3, mu: 1, k_t: 4e6, rolling: conjugate-spring, rolling_velocity: bagi-kuhn, mu_r: 1, k_r: 1e7",
             0, st) &&
         tr_step_forces(&w, st);
    /* The law takes the largest arms, R1 and R2 instead of r1 and r2: delta/L is 3e-4 */
    double want = pair_limit(R1, R2, delta, 4e6, 1e7), got = ok ? tr_timestep_contacts(&w).dt : NAN;
    tr_world_free(&w);
    return ok &&
           tr_verify_add(v,
                         &(tr_verify_row){R2 > R1 ? "limit of the step, R2 = 3 R1" : "limit of the step, R2 = R1/2",
                                          "s", want, got, 1e-3 * want,
                                          "the bound has the radii for the arms: delta/|X21| = 7e-4", NAN, NULL},
                         st);
}

bool tr_exact_conjugate(tr_verify *v, tr_status *st) {
    tr_pairs_tile *p = tr_alloc(1, sizeof *p, st);
    if (p) {
        tr_pairs_set(p, TR_ROLLING_SLOT, &tr_rolling_conjugate_spring);
        p->rolling_velocity = "bagi-kuhn";
    }
    bool ok = p && tr_verify_add(v,
                                 &(tr_verify_row){"power + T V_r, largest, over T V_r", "1", 0, power_off(p), 1e-8,
                                                  "rounding of the normal force that is taken off", NAN, NULL},
                                 st);
    free(p);
    return ok && limit_row(v, 0.03, st) && limit_row(v, 0.005, st);
}

/* ---- what a rolling spring stores */

/* Loaded from rest, below its bound, at constant force: the store over the work of the bodies, less 1, largest. */
static double store_off(tr_pairs_tile *p) {
    const double dt = 1e-6;
    const tr_tile *t = &p->tile;
    double before[TR_PAIRS][2] = {{0}}, work[TR_PAIRS] = {0}, most = 0;
    tr_lane energy, bound;
    for (int step = 0; step < 10; step++) {
        for (int i = 0; i < TR_PAIRS; i++)
            tr_pairs_drive(p, i, (tr_pair_motion){.delta = 0.05, .w1 = 1 + 0.1 * i, .w2 = -0.5 * i});
        tr_pairs_run(p, dt);
        for (int i = 0; i < TR_PAIRS; i++) {
            const double now[2] = {t->q1[i], t->q2[i]}, w[2] = {t->w1[i], t->w2[i]};
            for (int k = 0; k < 2; k++) work[i] -= 0.5 * (before[i][k] + now[k]) * w[k] * dt, before[i][k] = now[k];
        }
    }
    const tr_law_data d = {.par = p->par[TR_ROLLING_SLOT], .hist = p->hist_at[TR_ROLLING_SLOT]};
    p->law[TR_ROLLING_SLOT]->state(t, &d, energy, bound);
    for (int i = 0; i < TR_PAIRS; i++) most = fmax(most, fabs(energy[i] / work[i] - 1));
    return most;
}

bool tr_exact_rolling_store(tr_verify *v, tr_status *st) {
    static const tr_law *const law[] = {&tr_rolling_wang_spring, &tr_rolling_conjugate_spring,
                                        &tr_rolling_star_displacement_damping};
    tr_pairs_tile *p = tr_alloc(1, sizeof *p, st);
    bool ok = p;
    for (int k = 0; k < 3 && ok; k++) {
        tr_pairs_set(p, TR_ROLLING_SLOT, law[k]);
        if (k == 1) p->rolling_velocity = "bagi-kuhn";
        ok = tr_verify_add(v,
                           &(tr_verify_row){law[k]->table.name, "1", 0, store_off(p), 1e-11,
                                            "rounding: the mean of a linear force is exact", NAN, NULL},
                           st);
    }
    free(p);
    return ok;
}

/* ---- measures of two pairs that only touch each other */

bool tr_exact_rolling_share(tr_verify *v, tr_status *st) {
    static const double spin[4] = {3, 1, 5, 2}, R[4] = {0.01, 0.02, 0.015, 0.01}, lap = 1e-4;
    tr_world w;
    tr_record *records = NULL;
    int capacity = 0, n = 0;
    double rolled = 0, slid = 0, place = NAN;
    tr_measures m = {.rolling_share = NAN};
    bool ok = tr_world_init(&w, 4, TR_SHAPE_DISK, st);
    for (int i = 0; i < 4 && ok; i++) {
        tr_world_set_disk(&w, i, &(tr_disk_start){i % 2 ? R[i - 1] + R[i] - lap : 0, i / 2, 0, R[i], 1000, true});
        w.disks.vel[tr_body(i) + TR_TURN] = spin[i];
    }
    w.dt = 1e-6;
    ok = ok && tr_exact_laws(&w, "k_n: 1e6, mu: 0.5, rolling: wang-spring, mu_r: 0.5", 0, st) && tr_step_forces(&w, st);
    if (ok) n = tr_record_all(&w, &records, &capacity, st);
    if (n == 2) m = tr_measures_of(&w, records, n), place = records[0].x;
    for (int i = 0; i < 4; i += 2) {
        double L = R[i] + R[i + 1] - lap, arm = R[i] * L / (R[i] + R[i + 1]);
        rolled += fabs(R[i] * R[i + 1] / (R[i] + R[i + 1]) * (spin[i] - spin[i + 1]));
        slid += fabs(arm * spin[i] + (L - arm) * spin[i + 1]);
    }
    free(records), tr_world_free(&w);
    return ok &&
           tr_verify_add(v,
                         &(tr_verify_row){"|V_r|/(|V_r| + |V_s|) over two contacts", "1", rolled / (rolled + slid),
                                          m.rolling_share, 1e-12, "rounding", NAN, NULL},
                         st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"share whose rims run against each other, s1 s2 < 0", "1", 1,
                                          m.opposed_fraction, 0, "all turn the same way", NAN, NULL},
                         st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"place of a contact, from the first centre", "m",
                                          R[0] * (R[0] + R[1] - lap) / (R[0] + R[1]), place, 1e-16, "rounding", NAN,
                                          NULL},
                         st) &&
           tr_verify_add(
               v, &(tr_verify_row){"coordination number", "1", 1, m.coordination, 0, "one contact each", NAN, NULL},
               st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"unbalanced ratio", "1", 1, m.unbalanced, 1e-15,
                                          "the contact is all that pushes", NAN, NULL},
                         st);
}

/* ---- gravity that turns */

bool tr_exact_turning_gravity(tr_verify *v, tr_status *st) {
    static const char text[] = "kind: bodies\ntime_end: 2 s\ngravity: {x: 1 m/s^2, y: -9 m/s^2, turn: 1.5 rad/s}\n"
                               "contact: {k_n: 1 MPa, friction: none, rolling: none}\n"
                               "disks: [{radius: 10 mm, density: 1000, x: 0, y: 0}]\n";
    const double W = 1.5, T = 2, g[2] = {1, -9}, s = sin(W * T), c = 1 - cos(W * T);
    const double want[2] = {(s * g[0] - c * g[1]) / W, (c * g[0] + s * g[1]) / W};
    double got[3] = {NAN, NAN};
    tr_scene scene;
    tr_bodies b;
    if (!tr_scene_read(&scene, &(tr_scene_source){"gravity", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_bodies_init(&b, &scene, st);
    if (ok) {
        for (int64_t k = 0; k < b.steps && ok; k++) {
            ok = tr_step_forces(&b.world, st);
            tr_bodies_advance(&b);
        }
        ok = ok && tr_step_forces(&b.world, st);
        if (ok) tr_bodies_velocity(&b.world, 0, got);
        tr_bodies_free(&b);
    }
    tr_scene_free(&scene);
    static const char reason[] = "second order: (w dt)^2/12 of g T, 10000 steps";
    return ok &&
           tr_verify_add(
               v, &(tr_verify_row){"velocity to the right", "m/s", want[0], got[0], 1.4e-7, reason, NAN, NULL}, st) &&
           tr_verify_add(v, &(tr_verify_row){"velocity upward", "m/s", want[1], got[1], 1.4e-7, reason, NAN, NULL}, st);
}
