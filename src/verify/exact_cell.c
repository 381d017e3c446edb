/* SPDX-License-Identifier: MIT */
/* Periodic cells against closed forms.
 *
 *   gas      Disks that never touch keep their velocities in space. In a cell whose sides L change at constant rates
 *            they are at x0 + v t less a whole number of sides, c = v - (rate/L) x keeps c L, and all kinetic energy
 *            that goes as 1/L^2 is work of the cell.
 *   lattice  All contacts of a lattice follow the flow D: a bond l approaches at -n.D.n l, f = k (2R - l) + c times
 *            that, and the stress is (1/A) sum f l n n [Love1927]; at rest of triangles sqrt(3) k delta/d in all
 *            directions.
 *   drag     The drag of compaction acts against the flow: disks that follow the cell feel nothing and keep x/L, the c
 *            of others falls by (1 - drag dt) L/L' in each step.
 *   hold     The servo holds the wanted stress, lateral or mean. */
#include "core/pipeline.h"
#include "verify/exact.h"

#include "base/random.h"
#include "core/biaxial.h"
#include "core/cell.h"
#include "core/ledger.h"
#include "core/step.h"
#include "core/timestep.h"
#include "laws/law.h"
#include <string.h>

/* ---- a gas */

enum { GAS = 16, STEPS = 4000 };
static const double SIDE[2] = {6, 4}, RATE[2] = {-20, 9}, DT = 1e-5;

typedef struct gas {
    tr_world world;
    double x0[GAS][2], c0[GAS][2], K0[2];
} gas;

/* Half of the disks begin outside of the cell, where their images are not. */
static bool gas_begin(gas *g, tr_status *st) {
    tr_world *w = &g->world;
    tr_random r = tr_random_seed(4, 1);
    if (!tr_world_init(w, GAS, TR_SHAPE_DISK, st)) return false;
    for (int i = 0; i < GAS; i++) {
        tr_world_set_disk(
            w, i,
            &(tr_disk_start){SIDE[0] * tr_random_uniform(&r), SIDE[1] * tr_random_uniform(&r), 0, 1e-3, 1000, false});
        for (int k = 0; k < 2; k++) {
            double c = w->disks.vel[tr_body(i) + k] = tr_random_uniform(&r) - (k ? 0.7 : 0.2);
            g->x0[i][k] = w->disks.pos[tr_body(i) + k], g->c0[i][k] = c, g->K0[k] += 0.5 * w->disks.mass[i] * c * c;
        }
    }
    memcpy(w->cell.side, SIDE, sizeof SIDE);
    return tr_exact_laws(w, "k_n: 1e3, friction: none, rolling: none", TR_SINK_LEDGER, st);
}

static bool gas_run(gas *g, tr_status *st) {
    tr_world *w = &g->world;
    w->dt = DT;
    tr_cell_set_rate(w, 0, RATE[0]), tr_cell_set_rate(w, 1, RATE[1]);
    bool ok = tr_step_forces(w, st);
    if (ok) tr_ledger_begin(w);
    for (int k = 0; k < STEPS && ok; k++) {
        tr_step_advance(w);
        ok = tr_step_forces(w, st);
        if (ok) tr_ledger_walls(w);
    }
    return ok;
}

static bool gas_rows(tr_verify *v, const gas *g, tr_status *st) {
    const tr_world *w = &g->world;
    double place = 0, against = 0, K = 0, K0 = g->K0[0] + g->K0[1];
    for (int k = 0; k < 2; k++) {
        double L = SIDE[k] + RATE[k] * STEPS * DT;
        K += g->K0[k] * pow(SIDE[k] / L, 2);
        for (int i = 0; i < GAS; i++) {
            double x = w->disks.pos[tr_body(i) + k], c = w->disks.vel[tr_body(i) + k] - RATE[k] / L * x;
            double free = g->x0[i][k] + (g->c0[i][k] + RATE[k] / SIDE[k] * g->x0[i][k]) * STEPS * DT;
            place = fmax(place, fabs((x - free) / L - rint((x - free) / L)));
            against = fmax(against, fabs(c * L / SIDE[k] - g->c0[i][k]));
        }
    }
    static const char sums[] = "rounding of 4000 sums";
    tr_energy e = tr_ledger_read(w);
    return tr_verify_add(v,
                         &(tr_verify_row){"gas: place, off x0 + v t and whole sides, largest", "1", 0, place, 1e-11,
                                          sums, NAN, NULL},
                         st) &&
           tr_verify_add(
               v, &(tr_verify_row){"gas: change of c L, largest, over L", "m/s", 0, against, 1e-10, sums, NAN, NULL},
               st) &&
           tr_verify_add(
               v,
               &(tr_verify_row){"gas: kinetic energy against the flow", "N", K, e.kinetic, 1e-11 * K, sums, NAN, NULL},
               st) &&
           tr_verify_add(v, &(tr_verify_row){"gas: work of the cell", "N", K - K0, e.work, 1e-11 * K, sums, NAN, NULL},
                         st);
}

/* ---- a lattice in a homogeneous flow */

enum { ROW = 6, BONDS = 3 };
static const double K_N = 1e9, ZETA = 0.2, D0 = 1.98;

static bool lattice_begin(tr_world *w, tr_status *st) {
    const double rise = D0 * sqrt(3) / 2;
    if (!tr_world_init(w, ROW * ROW, TR_SHAPE_DISK, st)) return false;
    w->cell.side[0] = ROW * D0, w->cell.side[1] = ROW * rise;
    for (int i = 0; i < ROW * ROW; i++) {
        int row = i / ROW;
        tr_world_set_disk(w, i, &(tr_disk_start){(i % ROW + (row % 2 ? 0.5 : 0)) * D0, row * rise, 0, 1, 1000, false});
    }
    bool ok = tr_exact_laws(w, "k_n: 1e9, damping_ratio: 0.2, friction: none, rolling: none", 0, st);
    if (ok) w->dt = 0.2 * tr_timestep_worst(w);
    return ok;
}

/* With sides F times as long as at first, that change at the strain rates D. */
static void lattice_stress(const double F[2], const double D[2], double stress[2]) {
    const double bond[BONDS][2] = {{D0, 0}, {D0 / 2, D0 * sqrt(3) / 2}, {-D0 / 2, D0 * sqrt(3) / 2}};
    double m = 1000 * M_PI, c = 2 * ZETA * sqrt(K_N * m / 2), area = F[0] * D0 * F[1] * D0 * sqrt(3) / 2;
    stress[0] = stress[1] = 0;
    for (int b = 0; b < BONDS; b++) {
        double x = F[0] * bond[b][0], y = F[1] * bond[b][1], l = hypot(x, y);
        double f = K_N * (2 - l) - c * (D[0] * x * x + D[1] * y * y) / l;
        stress[0] += f * x * x / l / area, stress[1] += f * y * y / l / area;
    }
}

static bool lattice_row(tr_verify *v, const tr_world *w, const char *quantity, int axis, double want, tr_status *st) {
    double got = tr_cell_force(&w->cell, axis) / w->cell.side[1 - axis];
    return tr_verify_add(v,
                         &(tr_verify_row){quantity, "Pa", want, got, 1e-9 * fabs(want),
                                          "an overlap of 1 % of lengths that are rounded 200 times", NAN, NULL},
                         st);
}

static bool lattice_rows(tr_verify *v, tr_world *w, tr_status *st) {
    const double side0[2] = {w->cell.side[0], w->cell.side[1]}, at_rest = sqrt(3) * K_N * (2 - D0) / D0;
    double F[2], D[2], stress[2];
    if (!tr_step_forces(w, st) || !lattice_row(v, w, "lattice at rest: stress along x", 0, at_rest, st) ||
        !lattice_row(v, w, "lattice at rest: stress along y", 1, at_rest, st))
        return false;
    tr_cell_set_rate(w, 0, 0.03 * side0[0]), tr_cell_set_rate(w, 1, -0.02 * side0[1]);
    for (int k = 0; k < 200; k++) {
        tr_step_advance(w);
        if (!tr_step_forces(w, st)) return false;
    }
    for (int k = 0; k < 2; k++)
        F[k] = 1 + (k ? -0.02 : 0.03) * 200 * w->dt, D[k] = (k ? -0.02 : 0.03) / F[k]; /* the rates are constant */
    lattice_stress(F, D, stress);
    return lattice_row(v, w, "lattice in a flow: stress along x", 0, stress[0], st) &&
           lattice_row(v, w, "lattice in a flow: stress along y", 1, stress[1], st);
}

bool tr_exact_cell(tr_verify *v, tr_status *st) {
    gas g = {.K0 = {0}};
    bool ok = gas_begin(&g, st) && gas_run(&g, st) && gas_rows(v, &g, st);
    tr_world_free(&g.world);
    tr_world lattice = {0};
    ok = ok && lattice_begin(&lattice, st) && lattice_rows(v, &lattice, st);
    tr_world_free(&lattice);
    return ok;
}

/* ---- compaction's drag, before the first contact */

enum { SAMPLE = 30 };
#define SAMPLE_TEXT                                                                                                    \
    "kind: biaxial\nseed: 3\nboundary: periodic\nsample: {disks: 30, r_min: 0.76 mm, r_max: 1.52 mm}\n"                \
    "contact: {k_n: 160 MPa, mu: 0.5, rolling: wang-spring, mu_r: 0.5}\n"                                              \
    "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"                                        \
    "shear: {inertial_number: 1e-3, strain_end: 0.04, hold: "

/* pushed: the first disk gets its own velocity; *left is its remaining part, *want the expected part; *off: the largest
 * way of another disk against the flow, over the side. */
static bool drag(tr_biaxial *b, double *off, double *left, double *want, tr_status *st) {
    const double pushed = 0.01;
    tr_world *w = &b->world;
    double x0[SAMPLE][2], unbalanced, L0 = w->cell.side[0];
    bool done, ok = true;
    for (int i = 0; i < SAMPLE; i++) memcpy(x0[i], w->disks.pos + tr_body(i), sizeof x0[i]);
    for (int k = 0; k < 2; k++) w->cell.mass[k] = 0, tr_cell_set_rate(w, k, -0.3);
    w->disks.vel[0] += pushed;
    *want = 1;
    for (int n = 0; n < 20 && ok; n++) {
        ok = tr_biaxial_compact(b, 1, &unbalanced, &done, st);
        *want *= 1 - b->drag * w->dt;
    }
    *off = w->contact_updates > 0 ? NAN : 0; /* then another force acts */
    for (int i = 1; i < SAMPLE; i++)
        for (int k = 0; k < 2; k++) {
            double turns = w->disks.pos[tr_body(i) + k] / w->cell.side[k] - x0[i][k] / L0;
            *off = fmax(*off, fabs(turns - rint(turns)));
        }
    *left = (w->disks.vel[0] - tr_cell_strain_rate(&w->cell, 0) * w->disks.pos[0]) / pushed * w->cell.side[0] / L0;
    return ok;
}

bool tr_exact_drag(tr_verify *v, tr_status *st) {
    static const char text[] = SAMPLE_TEXT "lateral}\n", reason[] = "rounding of 20 steps";
    double off = 0, left = 0, want = 0;
    tr_scene scene;
    tr_biaxial b;
    if (!tr_scene_read(&scene, &(tr_scene_source){"drag", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_biaxial_init(&b, &scene, st);
    if (ok) ok = drag(&b, &off, &left, &want, st), tr_biaxial_free(&b);
    tr_scene_free(&scene);
    return ok &&
           tr_verify_add(v,
                         &(tr_verify_row){"way of disks that follow the cell, over its side", "1", 0, off, 1e-13,
                                          reason, NAN, NULL},
                         st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"velocity against the flow, times L, over the first", "1", want, left, 1e-12,
                                          reason, NAN, NULL},
                         st);
}

/* ---- what the servo holds */

static bool held(tr_biaxial *b, double *lateral, double *mean, tr_status *st) {
    double unbalanced;
    bool done = false, ok = true;
    while (ok && !done) ok = tr_biaxial_compact(b, 200, &unbalanced, &done, st);
    ok = ok && tr_biaxial_begin_shear(b, st);
    for (int64_t k = 0; ok && k <= b->shear_steps; k++) {
        if (k) tr_step_advance(&b->world);
        if (k == b->shear_steps / 4) tr_biaxial_read(b); /* from 1 % of strain on */
        ok = tr_biaxial_forces(b, st);
    }
    tr_biaxial_state s = {0};
    if (ok) s = tr_biaxial_read(b);
    *lateral = s.stress_2, *mean = 0.5 * (s.stress_1 + s.stress_2);
    return ok;
}

bool tr_exact_hold(tr_verify *v, tr_status *st) {
    static const char *const text[] = {SAMPLE_TEXT "lateral}\n", SAMPLE_TEXT "mean}\n"},
                             *const quantity[] = {"hold: lateral, lateral stress", "hold: mean, mean stress"};
    bool ok = true;
    for (int k = 0; k < 2 && ok; k++) {
        double stress[2] = {0};
        tr_scene scene;
        tr_biaxial b;
        if (!tr_scene_read(&scene, &(tr_scene_source){"hold", text[k], strlen(text[k]), NULL, 0}, tr_laws_catalog(),
                           st))
            return false;
        ok = tr_biaxial_init(&b, &scene, st);
        if (ok) ok = held(&b, &stress[0], &stress[1], st), tr_biaxial_free(&b);
        tr_scene_free(&scene);
        ok = ok && tr_verify_add(v,
                                 &(tr_verify_row){quantity[k], "Pa", 160e3, stress[k], 0.01 * 160e3,
                                                  "mean of 3 % of strain: a piston that swings about what it holds",
                                                  NAN, NULL},
                                 st);
    }
    return ok;
}
