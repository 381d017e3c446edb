/* SPDX-License-Identifier: MIT */
#include "study/bench.h"

#include "base/alloc.h"
#include "core/biaxial.h"
#include "core/step.h"
#include "study/run_internal.h"
#include <stdlib.h>
#include <string.h>

enum { BLOCKS = 40, REPEATS = 25, MAX_STAGES = TR_MAX_PASSES + 2 };

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double quantile(double *values, int n, double q) {
    qsort(values, (size_t)n, sizeof *values, compare);
    return values[(int)(q * (n - 1) + 0.5)];
}

static void nothing(void *context, tr_group *group, tr_tile *tile) {
    (void)context, (void)group, (void)tile;
}

/* Time of one walk over the present state with the first n_pass passes [s]; n_pass < 0: the whole force step. Nothing moves: dt
 * is 0. */
static double time_walk(tr_world *world, int n_pass, tr_status *st) {
    int whole[2] = {world->group[0].n_pass, world->group[1].n_pass}, calls = 300000 / (world->group[0].n + 100) + 1;
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
    return (tr_run_clock() - start) / calls;
}

/* What each pass adds: the walk is cut after every pass in turn, and the whole is repeated. */
static void time_passes(tr_world *world, tr_bench_report *r, tr_status *st) {
    static const char *const ends[] = {"scatter", "integration, walls, lists"};
    double added[MAX_STAGES][REPEATS];
    int n_pass = world->group[0].n_pass;
    int64_t before = world->contact_updates;
    tr_step_forces(world, st);
    double contacts = (double)(world->contact_updates - before), forces[REPEATS];
    for (int k = 0; k < REPEATS; k++) {
        double so_far = 0;
        for (int p = 0; p <= n_pass + 1; p++) {
            double now = time_walk(world, p <= n_pass ? p : -1, st);
            added[p][k] = now - so_far;
            so_far = now;
        }
        forces[k] = so_far;
    }
    r->n_passes = n_pass + 3;
    for (int p = 0; p < r->n_passes; p++) {
        const char *name = p == 0 ? "gather" : p <= n_pass ? world->group[0].pass[p - 1].name : ends[p - n_pass - 1];
        double seconds =
            p < n_pass + 2 ? quantile(added[p], REPEATS, 0.5) : r->us_per_step * 1e-6 - quantile(forces, REPEATS, 0.5);
        snprintf(r->pass[p].name, sizeof r->pass[p].name, "%s", name);
        r->pass[p].ns = 1e9 * seconds / contacts;
    }
}

typedef struct subject {
    tr_biaxial b;
    double rate[BLOCKS], step[BLOCKS];
} subject;

static bool prepare(subject *s, tr_scene *scene, tr_status *st) {
    bool done = false;
    double unbalanced;
    scene->output.energy = false;
    if (!tr_biaxial_init(&s->b, scene, st)) return false;
    while (!done)
        if (!tr_biaxial_compact(&s->b, 200, &unbalanced, &done, st)) return false;
    if (!tr_biaxial_begin_shear(&s->b, st)) return false;
    if (s->b.shear_steps >= BLOCKS) return true;
    return tr_status_fail(st, TR_BAD_CASE, "error: bench needs %d steps of shear or more, this case has %lld", BLOCKS,
                          (long long)s->b.shear_steps);
}

static bool run_block(subject *s, int k, tr_bench_report *r, tr_status *st) {
    tr_world *world = &s->b.world;
    int64_t updates = world->contact_updates, steps = s->b.shear_steps / BLOCKS;
    double start = tr_run_clock();
    for (int64_t n = 0; n < steps; n++) {
        if (!tr_biaxial_forces(&s->b, st)) return false;
        tr_step_advance(world);
    }
    double seconds = tr_run_clock() - start, touched = (double)(world->contact_updates - updates);
    s->rate[k] = touched / seconds;
    s->step[k] = 1e6 * seconds / (double)steps;
    r->touching += touched / (double)steps / BLOCKS;
    r->listed += (double)(world->group[0].n + world->group[1].n) / BLOCKS;
    return true;
}

static void report_subject(subject *s, tr_bench_report *r, tr_status *st) {
    r->low = quantile(s->rate, BLOCKS, 0.25);
    r->updates_per_s = quantile(s->rate, BLOCKS, 0.5);
    r->high = quantile(s->rate, BLOCKS, 0.75);
    r->us_per_step = quantile(s->step, BLOCKS, 0.5);
    r->bytes_per_disk = (double)tr_world_bytes(&s->b.world) / s->b.world.disks.n;
    time_passes(&s->b.world, r, st);
}

bool tr_bench(const tr_scene *const *scenes, int n, tr_bench_report *reports, tr_status *st) {
    subject *s = tr_alloc((size_t)n, sizeof *s, st);
    tr_scene *quiet = tr_alloc((size_t)n, sizeof *quiet, st); /* ledger off */
    bool ok = s && quiet;
    for (int i = 0; ok && i < n; i++) {
        reports[i] = (tr_bench_report){0};
        quiet[i] = *scenes[i];
        ok = prepare(&s[i], &quiet[i], st);
    }
    for (int k = 0; ok && k < BLOCKS; k++)
        for (int i = 0; ok && i < n; i++) ok = run_block(&s[i], k, &reports[i], st);
    for (int i = 0; ok && i < n; i++) report_subject(&s[i], &reports[i], st);
    for (int i = 0; s && i < n; i++) tr_biaxial_free(&s[i].b);
    free(s), free(quiet);
    return ok && st->code == TR_OK;
}
