/* SPDX-License-Identifier: MIT */
/* The bound on the step, 2/w of the stiffest mode, against the largest eigenvalue w^2 of M^-1/2 K M^-1/2: in closed
 * form for a chain of N free disks, w = 2 sqrt(k/m) cos(pi/(2N)), by power iteration for lattices, with K assembled
 * here from the definitions of the contact velocities. Then leapfrog itself, just below and just above. */
#include "core/pipeline.h"
#include "verify/exact.h"

#include "base/alloc.h"
#include "core/step.h"
#include "core/timestep.h"
#include "laws/law.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RADIUS 0.01

typedef struct lattice {
    const char *name, *contact;
    int columns, rows;
    bool hexagonal;
    double k[3]; /* normal, sliding, rolling */
} lattice;

static bool build(tr_world *w, const lattice *l, tr_status *st) {
    const double d = 2 * RADIUS * (1 - 0.5e-4), up = l->hexagonal ? d * sqrt(3) / 2 : d;
    char text[400];
    tr_scene scene;
    snprintf(text, sizeof text,
             "kind: bodies\ntime_end: 1\ncontact: {%s}\ndisks: [{radius: 1, density: 1, x: 0, y: 0}]\n", l->contact);
    if (!tr_scene_read(&scene, &(tr_scene_source){l->name, text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_world_init(w, l->columns * l->rows, TR_SHAPE_DISK, st);
    for (int i = 0; ok && i < l->columns * l->rows; i++) {
        int row = i / l->columns;
        tr_world_set_disk(w, i,
                          &(tr_disk_start){i % l->columns * d + (l->hexagonal && row % 2 ? d / 2 : 0), row * up, 0,
                                           RADIUS, 1000, false});
    }
    if (ok) w->dt = 1e-9;
    ok = ok && tr_world_set_laws(w, &scene.contact, false, 0, st) && tr_step_forces(w, st);
    tr_scene_free(&scene);
    return ok;
}

/* y = M^-1/2 K M^-1/2 x, three numbers a disk (the third R times the angle). */
static void multiply(const tr_world *w, const double k[3], const double *x, double *y) {
    const tr_group *g = &w->group[0];
    const double scale[3] = {1, 1, sqrt(2)}; /* sqrt(m) of each: I = m R^2/2 */
    memset(y, 0, 3 * (size_t)w->disks.n * sizeof *y);
    for (int i = 0; i < g->n; i++) {
        const double *p = w->disks.pos + tr_body(g->a[i]), *q = w->disks.pos + tr_body(g->b[i]);
        double dx = q[0] - p[0], dy = q[1] - p[1], L = hypot(dx, dy), nx = dx / L, ny = dy / L;
        if (L >= 2 * RADIUS) continue;
        const double of_b[3][3] = {{nx, ny, 0}, {ny, -nx, L / (2 * RADIUS)}, {0, 0, -0.5}};
        const double of_a[3][3] = {{-nx, -ny, 0}, {-ny, nx, L / (2 * RADIUS)}, {0, 0, 0.5}};
        for (int mode = 0; mode < 3; mode++) {
            double s = 0;
            for (int c = 0; c < 3; c++)
                s += scale[c] * (of_a[mode][c] * x[3 * g->a[i] + c] + of_b[mode][c] * x[3 * g->b[i] + c]);
            s *= k[mode] / w->disks.mass[0];
            for (int c = 0; c < 3; c++) {
                y[3 * g->a[i] + c] += s * scale[c] * of_a[mode][c];
                y[3 * g->b[i] + c] += s * scale[c] * of_b[mode][c];
            }
        }
    }
}

/* 2/w; power iteration comes from below in w^2. */
static double exact_bound(const tr_world *w, const double k[3], double *x, double *y) {
    size_t n = 3 * (size_t)w->disks.n;
    double largest = 0;
    for (size_t i = 0; i < n; i++) x[i] = sin(1.0 + 3.7 * (double)i);
    for (int it = 0; it < 4000; it++) {
        double xx = 0, xy = 0, yy = 0;
        multiply(w, k, x, y);
        for (size_t i = 0; i < n; i++) xx += x[i] * x[i], xy += x[i] * y[i], yy += y[i] * y[i];
        largest = xy / xx;
        for (size_t i = 0; i < n; i++) x[i] = y[i] / sqrt(yy);
    }
    return 2 / sqrt(largest);
}

static bool compare(tr_verify *v, const lattice *l, tr_status *st) {
    tr_world w;
    bool chain = l->rows == 1;
    double N = l->columns, by_hand = sqrt(M_PI * RADIUS * RADIUS * 1000 / l->k[0]) / cos(M_PI / (2 * N));
    double *work = NULL;
    bool ok = build(&w, l, st) && (work = tr_alloc(6 * (size_t)w.disks.n, sizeof *work, st));
    if (ok) {
        double exact = exact_bound(&w, l->k, work, work + 3 * w.disks.n), bound = tr_timestep_contacts(&w).dt;
        char name[80], said[80];
        snprintf(name, sizeof name, "bound, %s", l->name);
        snprintf(said, sizeof said, "%.4f of the exact %.6g s; asked: 0.68 to 1", bound / exact, exact);
        /* The parts of a mass are equal: 1/sqrt(2) in a lattice of normal springs, somewhat less where it has free
         * edges. */
        ok = tr_verify_outcome(v, name, said, bound > 0.68 * exact && bound <= exact * (1 + 1e-12), st);
        if (chain)
            ok = ok &&
                 tr_verify_add(v,
                               &(tr_verify_row){"exact bound of the chain of 40", "s", by_hand, exact, 1e-4 * by_hand,
                                                "overlaps of 1e-4 R", NAN, NULL},
                               st) &&
                 tr_verify_add(v,
                               &(tr_verify_row){"bound of the chain", "s", by_hand * cos(M_PI / (2 * N)), bound,
                                                1e-4 * by_hand, "exact for an endless chain; overlaps of 1e-4 R", NAN,
                                                NULL},
                               st);
    }
    free(work), tr_world_free(&w);
    return ok;
}

/* Growth of a tiny disturbance of a chain pressed between walls, in 20000 steps. */
static bool growth(double share, double *most, tr_status *st) {
    enum { N = 24 };
    const double lap = 0.01 * RADIUS, tiny = 1e-9;
    const lattice alone = {
        "pressed chain", "k_n: 1e6, damping_ratio: 0.3, friction: none, rolling: none", N, 1, 0, {0}};
    tr_world w;
    if (!build(&w, &alone, st)) return false;
    for (int i = 0; i < N; i++) {
        w.disks.pos[tr_body(i)] = RADIUS - lap + i * (2 * RADIUS - lap);
        w.disks.vel[tr_body(i)] = tiny * sin(1.0 + 3.7 * i);
    }
    w.wall[0] = (tr_wall){.nx = 1},
    w.wall[1] = (tr_wall){.x = 2 * (RADIUS - lap) + (N - 1) * (2 * RADIUS - lap), .nx = -1};
    w.n_walls = 2, w.stale = true, w.allow_unstable = true, *most = 0;
    bool ok = tr_step_forces(&w, st);
    w.dt = share * tr_timestep_contacts(&w).dt;
    for (int k = 0; k < 20000 && ok && *most < 1e6; k++) {
        tr_status broken = {0};
        if (!tr_step_forces(&w, &broken)) break; /* grown beyond all bounds */
        tr_step_advance(&w);
        for (int i = 0; i < N; i++) *most = fmax(*most, fabs(w.disks.vel[tr_body(i)]) / tiny);
    }
    tr_world_free(&w);
    return ok;
}

bool tr_exact_step_bound(tr_verify *v, tr_status *st) {
    static const char normal[] = "k_n: 1e6, damping_ratio: 0, friction: none, rolling: none",
                      all[] =
                          "k_n: 1e6, damping_ratio: 0, mu: 0.5, k_t: 5e5, rolling: wang-spring, mu_r: 0.5, k_r: 5e5",
                      stiff[] =
                          "k_n: 1e5, damping_ratio: 0, mu: 0.5, k_t: 1e5, rolling: wang-spring, mu_r: 0.5, k_r: 1e6";
    static const lattice lattices[] = {{"chain, normal springs", normal, 40, 1, false, {1e6, 0, 0}},
                                       {"square, normal springs", normal, 7, 7, false, {1e6, 0, 0}},
                                       {"hexagonal, normal springs", normal, 7, 7, true, {1e6, 0, 0}},
                                       {"square, all springs", all, 7, 7, false, {1e6, 5e5, 5e5}},
                                       {"hexagonal, all springs", all, 7, 7, true, {1e6, 5e5, 5e5}},
                                       {"hexagonal, stiff rolling", stiff, 7, 7, true, {1e5, 1e5, 1e6}}};
    for (size_t k = 0; k < sizeof lattices / sizeof *lattices; k++)
        if (!tr_verify_go_on(v, st) || !compare(v, &lattices[k], st)) return false;
    double below, above;
    if (!growth(0.99, &below, st) || !growth(1.02, &above, st)) return false;
    char said[2][80];
    snprintf(said[0], 80, "a disturbance of a damped chain grows %.2g times", below);
    snprintf(said[1], 80, "it grows %.2g times or more", above);
    /* Near the bound a mode may swing to 1/sqrt(1 - 0.99^2) = 7 times of where it started, times sqrt(24). */
    return tr_verify_outcome(v, "leapfrog at 0.99 of the bound is stable", said[0], below < 35, st) &&
           tr_verify_outcome(v, "leapfrog at 1.02 of the bound is not", said[1], above > 1e4, st);
}
