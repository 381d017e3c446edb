/* SPDX-License-Identifier: MIT */
/* Far from the origin, and squeezed from all sides. */
#include "base/alloc.h"
#include "core/pipeline.h"
#include "core/step.h"
#include "verify/stability.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 6, N = SIDE * SIDE + 1, STEPS = 2000 };

/* Disks of radius 1 on a lattice, each 1 % into its neighbours, that fly apart, at (far, far); one stays at the origin,
 * the reference point for single precision in the broad phase. */
static bool burst(tr_verify *v, double far, const tr_broad_finder *finder, double *pos, int64_t *touched,
                  tr_status *st) {
    static const char text[] =
        "kind: bodies\ntime_end: 1 s\ncontact: {k_n: 1 MPa, damping_ratio: 0.1, mu: 0.5, mu_r: 0.1}\n"
        "disks: [{radius: 1, x: 0, y: 0}]\n";
    tr_scene scene;
    tr_world *w = tr_alloc(1, sizeof *w, st);
    if (!w) return false;
    bool ok = tr_scene_read(&scene, &(tr_scene_source){"burst", text, strlen(text), NULL, 0}, tr_laws_catalog(), st);
    if (ok && (ok = tr_world_init(w, N, TR_SHAPE_DISK, st))) {
        tr_world_set_disk(w, 0, &(tr_disk_start){0, 0, 0, 1, 1000, false});
        for (int i = 1; i < N; i++) {
            int row = (i - 1) / SIDE, column = (i - 1) % SIDE;
            tr_world_set_disk(
                w, i, &(tr_disk_start){far + 1.98 * column + 0.5 * (row % 2), far + 1.9 * row, 0, 1, 1000, false});
        }
        w->broad = finder;
        w->dt = 2e-3; /* the limit is 0.02 s */
        ok = tr_world_set_laws(w, &scene.contact, false, 0, st);
        for (int k = 0; ok && k < STEPS && (ok = tr_step_forces(w, st)); k++) tr_step_advance(w);
        for (int k = 4; ok && k < 4 * N; k++) pos[k] = w->disks.pos[k] - (k % 4 < 2 ? far : 0);
        *touched = w->contact_updates;
        tr_world_free(w);
    }
    tr_scene_free(&scene);
    free(w);
    return ok && tr_verify_go_on(v, st);
}

bool tr_stability_far(tr_verify *v, tr_status *st) {
    double here[tr_body(N)], there[tr_body(N)], brute[tr_body(N)], most = 0, differ = 0;
    int64_t touched[3];
    if (!burst(v, 0x1p7, &tr_broad_box2d, here, &touched[0], st) ||
        !burst(v, 0x1p20, &tr_broad_box2d, there, &touched[1], st) ||
        !burst(v, 0x1p20, &tr_broad_brute, brute, &touched[2], st))
        return false;
    for (int k = 4; k < 4 * N; k++) {
        if (k % 4 < 2) most = fmax(most, fabs(there[k] - here[k]));
        differ += there[k] != brute[k];
    }
    const tr_verify_row rows[] = {
        {"positions 1e6 R away, less those here", "m", 0, most, 1e-6,
         "2000 steps of 1e6 eps, times what contacts spread", NAN, NULL},
        {"numbers that differ from brute force there", "1", 0, differ, 0, "a finder gives pairs, no numbers", NAN,
         NULL},
        {"contacts there, less brute force", "1", 0, (double)(touched[1] - touched[2]), 0, "no pair is missed", NAN,
         NULL},
    };
    for (int k = 0; k < 3; k++)
        if (!tr_verify_add(v, &rows[k], st)) return false;
    return true;
}

/* ---- six contacts */

#define AROUND(x_, y_) "{radius: 1, x: " x_ ", y: " y_ ", motion: prescribed}"
static const char six[] =
    "kind: bodies\ntime_end: 5 s\nstep: {dt: 1 ms}\n"
    "contact: {k_n: 1 MPa, damping_ratio: 0.3, friction: none, rolling: none}\n"
    "disks: [{radius: 1, x: 0, y: 0, spin: 1e-5},\n" AROUND("1.99", "0") ", " AROUND("-1.99", "0") ", " AROUND(
        "1.99 m*cos(60 deg)",
        "1.99 m*sin(60 deg)") ", " AROUND("-1.99 m*cos(60 deg)",
                                          "1.99 m*sin(60 deg)") ",\n" AROUND("1.99 m*cos(60 deg)",
                                                                             "-1.99 m*sin(60 deg)") ", " AROUND("-1.99 "
                                                                                                                "m*cos("
                                                                                                                "60 "
                                                                                                                "deg)",
                                                                                                                "-1.99 "
                                                                                                                "m*sin("
                                                                                                                "60 "
                                                                                                                "deg)") "]"
                                                                                                                        "\n";

bool tr_stability_six_contacts(tr_verify *v, tr_status *st) {
    static const char *const laws[] = {"star-force-proportional", "star-constant-torque", "star-displacement-damping"};
    tr_stability_run *run = tr_alloc(1, sizeof *run, st);
    bool ok = run != NULL;
    for (int k = 0; ok && k < 3; k++) {
        char law[60], quantity[80];
        snprintf(law, sizeof law, "contact.rolling=%s", laws[k]),
            snprintf(quantity, sizeof quantity, "largest energy/start, %s", laws[k]);
        const char *sets[] = {law, "contact.mu_r=0.1", k == 2 ? "contact.damping=yes" : "contact.friction=none"};
        double most = 0, now = NAN, start = 0; /* at the half step before: a dashpot has begun */
        ok = tr_stability_open(run, six, sets, 3, st);
        while (ok && run->b.world.steps < run->b.steps && (ok = tr_step_forces(&run->b.world, st))) {
            const double w = run->b.world.disks.vel[2];
            if (start == 0) start = w * w;
            now = w * w / start, most = fmax(most, now);
            tr_bodies_advance(&run->b);
        }
        tr_stability_close(run);
        if (!ok) break;
        ok = tr_verify_add(v, &(tr_verify_row){quantity, "1", 1, most, 1e-9, "a brake brakes", NAN, NULL}, st);
        snprintf(quantity, sizeof quantity, "energy at the end/start, %s", laws[k]);
        ok = ok &&
             tr_verify_add(v, &(tr_verify_row){quantity, "1", 0, now, 1e-12, "a stop, not a chatter", NAN, NULL}, st);
    }
    free(run);
    return ok;
}
