/* SPDX-License-Identifier: MIT */
#include "study/bench.h"

#include "base/alloc.h"
#include "base/quantile.h"
#include "core/biaxial.h"
#include "core/step.h"
#include "draw/canvas.h"
#include "draw/frame_biaxial.h"
#include "study/biaxial_view.h"
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { BLOCKS = 100, REPEATS = 25, MAX_STAGES = TR_MAX_PASSES + 2 };

/* Of no certain order, which it changes. */
static double median(double *values, int n) {
    tr_sort(values, n);
    return tr_quantile(values, n, 0.5);
}

tr_quartiles tr_bench_quartiles(const double *values, int n) {
    double sorted[BLOCKS];
    assert(n <= BLOCKS);
    memcpy(sorted, values, (size_t)n * sizeof *sorted);
    tr_sort(sorted, n);
    return (tr_quartiles){tr_quantile(sorted, n, 0.25), tr_quantile(sorted, n, 0.5), tr_quantile(sorted, n, 0.75)};
}

double tr_bench_clock(const tr_world *world) {
    struct timespec t;
    clock_gettime(world->threads ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void nothing(void *context, tr_group *group, tr_tile *tile) {
    (void)context, (void)group, (void)tile;
}

/* Time of one walk over the present state with the first n_pass passes [s]; n_pass < 0: the whole force step. Nothing
 * moves: dt is 0. */
static double time_walk(tr_world *world, int n_pass, tr_status *st) {
    int whole[2] = {world->group[0].n_pass, world->group[1].n_pass}, calls = 300000 / (world->group[0].n + 100) + 1;
    double start = tr_bench_clock(world);
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
    return (tr_bench_clock(world) - start) / calls;
}

/* The time that each pass adds: the walk is cut after each pass in turn, and all of this is repeated. */
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
        double seconds = p < n_pass + 2 ? median(added[p], REPEATS) : r->us_per_step * 1e-6 - median(forces, REPEATS);
        snprintf(r->pass[p].name, sizeof r->pass[p].name, "%s", name);
        r->pass[p].ns = 1e9 * seconds / contacts;
    }
}

typedef struct subject {
    tr_biaxial b;
    tr_view view; /* of its frames */
    char title[TR_RUN_TITLE];
    double ns[BLOCKS], step[BLOCKS], frame[BLOCKS]; /* per contact, per step [s], to draw one [s] */
} subject;

/* Takes the packing of the first scene. Its histories stay: they belong to its own laws. */
static void follow(subject *s, const subject *first) {
    tr_world *to = &s->b.world;
    const tr_world *from = &first->b.world;
    size_t bytes = (size_t)from->disks.n * 4 * sizeof(double);
    memcpy(to->disks.pos, from->disks.pos, bytes), memcpy(to->disks.vel, from->disks.vel, bytes);
    memcpy(to->wall, from->wall, sizeof to->wall);
    to->cell = from->cell;
}

/* first: whose packing it takes; itself: its own. */
static bool prepare(subject *s, const subject *first, const tr_scene *scene, int threads, tr_status *st) {
    bool done = s != first;
    double unbalanced;
    if (!tr_biaxial_init(&s->b, scene, st) || !tr_world_set_threads(&s->b.world, threads, st)) return false;
    if (s != first) follow(s, first);
    while (!done)
        if (!tr_biaxial_compact(&s->b, 200, &unbalanced, &done, st)) return false;
    if (!tr_biaxial_begin_shear(&s->b, st)) return false;
    s->view = tr_run_biaxial_view(&s->b, s->title);
    if (s->b.shear_steps >= 2 * BLOCKS) return true;
    return tr_status_fail(st, TR_BAD_CASE, "error: bench needs %d steps of shear or more, this case has %lld",
                          2 * BLOCKS, (long long)s->b.shear_steps);
}

static bool draw(subject *s, int k, tr_canvas *canvas, tr_status *st) {
    tr_record *records = NULL;
    int capacity = 0;
    double start = tr_bench_clock(&s->b.world);
    s->view.n_records = tr_record_all(&s->b.world, &records, &capacity, st);
    s->view.record = records;
    if (!st->code) tr_draw_biaxial(canvas, &s->view);
    s->frame[k] = tr_bench_clock(&s->b.world) - start;
    free(records);
    return st->code == TR_OK;
}

static bool run_block(subject *s, int k, tr_bench_report *r, tr_status *st) {
    tr_world *world = &s->b.world;
    int64_t updates = 0, steps = s->b.shear_steps / BLOCKS - 1;
    double start = 0;
    world->stale = true;
    for (int64_t n = -1; n < steps; n++) { /* the first step makes a new list for the new packing, and does not count */
        if (n == 0) start = tr_bench_clock(world), updates = world->contact_updates;
        if (!tr_biaxial_forces(&s->b, st)) return false;
        tr_step_advance(world);
    }
    double seconds = tr_bench_clock(world) - start, touched = (double)(world->contact_updates - updates);
    s->ns[k] = 1e9 * seconds / touched;
    s->step[k] = seconds / (double)steps;
    r->touching += touched / (double)steps / BLOCKS;
    r->listed += (double)(world->group[0].n + world->group[1].n) / BLOCKS;
    return true;
}

static void report_subject(const subject *s, const subject *first, tr_bench_report *r) {
    double share[BLOCKS];
    for (int k = 0; k < BLOCKS; k++) share[k] = s->step[k] / first->step[k];
    r->ns = tr_bench_quartiles(s->ns, BLOCKS);
    r->share = tr_bench_quartiles(share, BLOCKS);
    r->us_per_step = 1e6 * tr_bench_quartiles(s->step, BLOCKS).median;
    r->bytes_per_disk = (double)tr_world_bytes(&s->b.world) / s->b.world.disks.n;
    r->histories = tr_world_histories(&s->b.world);
    r->steps = (double)s->b.shear_steps;
    if (s->b.scene->output.frames) r->frame = tr_bench_quartiles(s->frame, BLOCKS);
}

bool tr_bench(const tr_scene *const *scenes, int n, int threads, bool passes, tr_bench_report *reports, tr_status *st) {
    subject *s = tr_alloc((size_t)n, sizeof *s, st);
    tr_canvas *canvas = NULL;
    bool ok = s != NULL;
    for (int i = 0; ok && i < n; i++)
        if (scenes[i]->output.frames && !canvas) ok = (canvas = tr_canvas_create(st)) != NULL;
    for (int i = 0; ok && i < n; i++) {
        reports[i] = (tr_bench_report){0};
        ok = prepare(&s[i], passes ? &s[i] : &s[0], scenes[i], threads, st);
    }
    for (int k = 0; ok && k < BLOCKS; k++) {
        for (int i = 1; i < n && !passes; i++) follow(&s[i], &s[0]);
        for (int i = 0; ok && i < n; i++) ok = run_block(&s[i], k, &reports[i], st);
        for (int i = 0; ok && i < n; i++)
            if (scenes[i]->output.frames) ok = draw(&s[i], k, canvas, st);
    }
    for (int i = 0; ok && i < n; i++) report_subject(&s[i], &s[0], &reports[i]);
    for (int i = 0; ok && passes && i < n; i++) time_passes(&s[i].b.world, &reports[i], st);
    for (int i = 0; s && i < n; i++) tr_biaxial_free(&s[i].b);
    tr_canvas_free(canvas), free(s);
    return ok && st->code == TR_OK;
}
