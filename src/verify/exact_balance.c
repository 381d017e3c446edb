/* SPDX-License-Identifier: MIT */
/* Balances of many: linear and angular momentum of free disks that collide, the energy of them and of a sheared
 * packing. */
#include "core/pipeline.h"
#include "verify/exact.h"

#include "base/random.h"
#include "core/biaxial.h"
#include "core/ledger.h"
#include "core/step.h"
#include "core/timestep.h"
#include "laws/law.h"
#include <stdio.h>
#include <string.h>

enum { SIDE = 7 };

/* A lattice of radii 0.6 to 1 cm that flies together and turns; none overlap yet. */
static bool cluster(tr_world *w, tr_status *st) {
    static const char text[] = "kind: bodies\ntime_end: 1\ncontact: {k_n: 1e6, damping_ratio: 0.1, mu: 0.5, k_t: 5e5, "
                               "rolling: wang-spring, mu_r: "
                               "0.3, k_r: 5e5}\ndisks: [{radius: 1, density: 1, x: 0, y: 0}]\n";
    tr_scene scene;
    tr_random r = tr_random_seed(3, 1);
    if (!tr_scene_read(&scene, &(tr_scene_source){"cluster", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_world_init(w, SIDE * SIDE, TR_SHAPE_DISK, st);
    for (int i = 0; ok && i < SIDE * SIDE; i++) {
        int row = i / SIDE, column = i % SIDE;
        double *v = w->disks.vel + tr_body(i), x = 0.0205 * (column - 3), y = 0.0205 * (row - 3);
        tr_world_set_disk(w, i, &(tr_disk_start){x, y, 0, 0.006 + 0.004 * tr_random_uniform(&r), 1000, false});
        v[0] = -10 * x - 5 * y + 0.2 * tr_random_uniform(&r), v[1] = -10 * y + 5 * x + 0.2 * tr_random_uniform(&r);
        v[2] = 40 * (tr_random_uniform(&r) - 0.3);
    }
    ok = ok && tr_world_set_laws(w, &scene.contact, false, TR_SINK_LEDGER, st);
    if (ok) w->dt = 0.3 * tr_timestep_worst(w);
    tr_scene_free(&scene);
    return ok;
}

/* x, y, angular momentum, and sums of their sizes. */
static void momentum(const tr_world *w, double sum[3], double size[3]) {
    memset(sum, 0, 3 * sizeof *sum), memset(size, 0, 3 * sizeof *size);
    for (int i = 0; i < w->disks.n; i++) {
        const double *x = w->disks.pos + tr_body(i), *v = w->disks.vel + tr_body(i), m = w->disks.mass[i];
        double part[3] = {m * v[0], m * v[1], m * (x[0] * v[1] - x[1] * v[0]) + 0.5 * m * x[3] * x[3] * v[2]};
        for (int k = 0; k < 3; k++) sum[k] += part[k], size[k] += fabs(part[k]);
    }
}

typedef struct balance {
    double momentum[3]; /* change over size */
    tr_energy energy;
    double start, steps;
} balance;

static bool collide(int halvings, balance *b, tr_status *st) {
    tr_world w;
    double before[3], after[3], size[3], less[3];
    if (!cluster(&w, st)) return tr_world_free(&w), false;
    int n = 3000 << halvings;
    w.dt /= 1 << halvings;
    bool ok = tr_step_forces(&w, st);
    if (ok) tr_ledger_begin(&w), b->start = w.ledger->start;
    momentum(&w, before, size);
    for (int k = 0; ok && k < n; k++) tr_step_advance(&w), ok = tr_step_forces(&w, st);
    momentum(&w, after, less);
    for (int k = 0; k < 3; k++) b->momentum[k] = (after[k] - before[k]) / size[k];
    b->energy = tr_ledger_read(&w), b->steps = n;
    tr_world_free(&w);
    return ok;
}

bool tr_exact_collision(tr_verify *v, tr_status *st) {
    static const char *const quantity[] = {"change of momentum, x", "change of momentum, y",
                                           "change of angular momentum"};
    balance b[2];
    char said[80];
    if (!collide(1, &b[0], st) || !tr_verify_go_on(v, st) || !collide(2, &b[1], st)) return false;
    for (int k = 0; k < 3; k++)
        if (!tr_verify_add(v,
                           &(tr_verify_row){quantity[k], "1", 0, b[1].momentum[k], 1e-16 * b[1].steps,
                                            "a rounding a step", NAN, NULL},
                           st))
            return false;
    double residual[] = {b[0].energy.residual / b[0].start, b[1].energy.residual / b[1].start};
    const tr_energy *e = &b[1].energy;
    snprintf(said, sizeof said, "%.2g, %.2g, %.2g of the energy", e->damped / b[1].start, e->friction / b[1].start,
             e->rolling / b[1].start);
    return tr_verify_add(v,
                         &(tr_verify_row){"energy that the ledger misses", "1", 0, residual[1], 2e-3,
                                          "first order: contacts begin and end within a step",
                                          log2(fabs(residual[0] / residual[1])), NULL},
                         st) &&
           tr_verify_outcome(v, "damped, friction, rolling take", said,
                             e->damped > 0.01 * b[1].start && e->friction > 0.01 * b[1].start && e->rolling > 0, st);
}

/* ---- a sheared packing */

static bool shear(tr_biaxial *b, tr_energy *e, tr_status *st) {
    double unbalanced;
    bool done = false, ok = true;
    while (ok && !done) ok = tr_biaxial_compact(b, 200, &unbalanced, &done, st);
    ok = ok && tr_biaxial_begin_shear(b, st);
    for (int64_t k = 0; ok && k <= b->shear_steps; k++) {
        if (k) tr_step_advance(&b->world);
        ok = tr_biaxial_forces(b, st);
    }
    if (ok) *e = tr_ledger_read(&b->world);
    return ok;
}

bool tr_exact_packing(tr_verify *v, tr_status *st) {
    static const char text[] = "kind: biaxial\nseed: 3\nsample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm}\n"
                               "contact: {k_n: 160 MPa, mu: 0.5, rolling: wang-spring, mu_r: 0.5}\n"
                               "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"
                               "shear: {inertial_number: 2e-3, strain_end: 0.02}\noutput: {energy: yes}\n";
    tr_energy e = {0};
    tr_scene scene;
    tr_biaxial b;
    if (!tr_scene_read(&scene, &(tr_scene_source){"packing", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_biaxial_init(&b, &scene, st);
    if (ok) ok = shear(&b, &e, st), tr_biaxial_free(&b);
    tr_scene_free(&scene);
    return ok &&
           tr_verify_add(v,
                         &(tr_verify_row){"missed, of the work of the walls", "1", 0, e.residual / e.work, 1e-3,
                                          "contacts begin and end within a step, 0.1 % of the work here", NAN, NULL},
                         st);
}
