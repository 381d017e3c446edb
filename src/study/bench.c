/* SPDX-License-Identifier: MIT */
#include "study/bench.h"

#include "base/alloc.h"
#include "core/biaxial.h"
#include "core/step.h"
#include "study/run_internal.h"
#include <stdlib.h>
#include <string.h>

enum { BLOCKS = 40, REPEATS = 15 };

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void nothing(void *context, tr_group *group, tr_tile *tile) {
    (void)context, (void)group, (void)tile;
}

/* Median time of one call over the present state [s]. Nothing moves: the walk uses dt = 0. n_pass < 0: whole force
 * step. */
static double time_walk(tr_world *world, int n_pass, tr_status *st) {
    double time[REPEATS];
    int whole[2] = {world->group[0].n_pass, world->group[1].n_pass}, calls = 2000000 / (world->group[0].n + 100) + 1;
    for (int r = 0; r < REPEATS; r++) {
        double start = tr_run_clock();
        for (int c = 0; c < calls; c++) {
            if (n_pass < 0) {
                world->fresh = true;
                tr_step_forces(world, st);
                continue;
            }
            for (int k = 0; k < 2; k++) {
                world->group[k].n_pass = n_pass < whole[k] ? n_pass : whole[k];
                tr_step_walk(world, &world->group[k], 0, nothing, NULL);
                world->group[k].n_pass = whole[k];
            }
        }
        time[r] = (tr_run_clock() - start) / calls;
    }
    qsort(time, REPEATS, sizeof *time, compare);
    return time[REPEATS / 2];
}

static void add_pass(tr_bench_report *r, const char *name, double seconds, double contacts) {
    snprintf(r->pass[r->n_passes].name, sizeof r->pass[0].name, "%s", name);
    r->pass[r->n_passes++].ns = 1e9 * seconds / contacts;
}

static void time_passes(tr_world *world, tr_bench_report *r, tr_status *st) {
    int64_t before = world->contact_updates;
    tr_step_forces(world, st);
    double contacts = (double)(world->contact_updates - before), so_far = time_walk(world, 0, st);
    add_pass(r, "gather", so_far, contacts);
    for (int k = 0; k < world->group[0].n_pass; k++) {
        double now = time_walk(world, k + 1, st);
        add_pass(r, world->group[0].pass[k].name, now - so_far, contacts);
        so_far = now;
    }
    double forces = time_walk(world, -1, st);
    add_pass(r, "scatter", forces - so_far, contacts);
    add_pass(r, "integration, walls, lists", r->us_per_step * 1e-6 - forces, contacts);
}

static bool shear(tr_biaxial *b, const volatile sig_atomic_t *stop, tr_bench_report *r, tr_status *st) {
    double rate[BLOCKS], step[BLOCKS];
    for (int k = 0; k < BLOCKS; k++) {
        int64_t updates = b->world.contact_updates, steps = b->shear_steps / BLOCKS;
        double start = tr_run_clock();
        for (int64_t s = 0; s < steps; s++) {
            if (!tr_biaxial_forces(b, st)) return false;
            tr_step_advance(&b->world);
        }
        double seconds = tr_run_clock() - start;
        rate[k] = (double)(b->world.contact_updates - updates) / seconds;
        step[k] = 1e6 * seconds / (double)steps;
        r->touching += (double)(b->world.contact_updates - updates) / (double)steps / BLOCKS;
        r->listed += (double)(b->world.group[0].n + b->world.group[1].n) / BLOCKS;
        if (stop && *stop) return tr_status_fail(st, TR_INTERRUPTED, "stopped");
    }
    qsort(rate, BLOCKS, sizeof *rate, compare);
    qsort(step, BLOCKS, sizeof *step, compare);
    r->low = rate[BLOCKS / 4], r->updates_per_s = rate[BLOCKS / 2], r->high = rate[3 * BLOCKS / 4];
    r->us_per_step = step[BLOCKS / 2];
    return true;
}

bool tr_bench(const tr_scene *scene, const volatile sig_atomic_t *stop, tr_bench_report *report, tr_status *st) {
    *report = (tr_bench_report){0};
    tr_biaxial *b = tr_alloc(1, sizeof *b, st);
    if (!b) return false;
    tr_scene quiet = *scene;
    quiet.output.energy = false;
    bool done = false, ok = tr_biaxial_init(b, &quiet, st);
    double unbalanced;
    while (ok && !done) {
        ok = tr_biaxial_compact(b, 200, &unbalanced, &done, st);
        if (ok && stop && *stop) ok = tr_status_fail(st, TR_INTERRUPTED, "stopped");
    }
    ok = ok && tr_biaxial_begin_shear(b, st);
    if (ok && b->shear_steps < BLOCKS)
        ok = tr_status_fail(st, TR_BAD_CASE, "error: bench needs %d steps of shear or more, this case has %lld", BLOCKS,
                            (long long)b->shear_steps);
    ok = ok && shear(b, stop, report, st);
    if (ok) {
        report->bytes_per_disk = (double)tr_world_bytes(&b->world) / b->world.disks.n;
        time_passes(&b->world, report, st);
        ok = st->code == TR_OK;
    }
    tr_biaxial_free(b);
    free(b);
    return ok;
}
