/* SPDX-License-Identifier: MIT */
/* A scene of a few bodies with its outputs. It runs twice: the first run writes nothing and finds the part of the plane
 * and the speeds that the film must hold, so that the picture stands still while the bodies move, and which contact is the
 * most mobilised at the end. */
#include "base/alloc.h"
#include "core/bodies.h"
#include "core/step.h"
#include "out/summary.h"
#include "study/run_internal.h"
#include <math.h>
#include <stdlib.h>

typedef struct show {
    tr_bodies b;
    const tr_scene *scene;
    const tr_run_options *options;
    tr_outputs out;
    tr_view view;
    bool rehearsal;
    tr_scene_pick most; /* contact at the end of the rehearsal */
} show;

static double time_of(const show *s) {
    return (double)s->b.world.steps * s->b.world.dt;
}

static void widen_view(show *s, int n_records) {
    const tr_world *world = &s->b.world;
    tr_view *v = &s->view;
    for (int i = 0; i < world->disks.n; i++) {
        const double *p = world->disks.pos + 4 * (size_t)i;
        v->x0 = fmin(v->x0, p[0] - p[3]), v->x1 = fmax(v->x1, p[0] + p[3]);
        v->y0 = fmin(v->y0, p[1] - p[3]), v->y1 = fmax(v->y1, p[1] + p[3]);
    }
    v->range = fmax(v->range, tr_frame_range_bodies(world, s->out.records, n_records));
}

static bool write_row(show *s, tr_status *st) {
    tr_row row = {.shape = s->scene->shape};
    for (int i = 0; i < s->b.world.disks.n; i++) {
        tr_row_disk(&row, time_of(s), &s->b.world, i);
        if (!tr_row_write(&row, &s->out.history, st)) return false;
    }
    s->out.rows++;
    return true;
}

static bool look(show *s, unsigned due, tr_status *st) {
    double start = tr_run_clock();
    int n = tr_record_all(&s->b.world, &s->out.records, &s->out.capacity, st);
    if (st->code) return false;
    if (s->rehearsal) {
        widen_view(s, n);
        s->out.film.frames++;
        return true;
    }
    if (due & TR_DUE_ROW && !write_row(s, st)) return false;
    if (due & TR_DUE_CONTACTS && !tr_outputs_contacts(&s->out, time_of(s), -1, n, st)) return false;
    if (due & TR_DUE_FRAME) {
        tr_view view = s->view;
        view.record = s->out.records, view.n_records = n, view.time = time_of(s);
        if (!tr_outputs_frame(&s->out, tr_draw_bodies, &view, st)) return false;
    }
    s->out.seconds += tr_run_clock() - start;
    return true;
}

static bool play(show *s, tr_status *st) {
    int64_t total = s->b.steps;
    for (int64_t k = 0;; k++) {
        if (tr_run_stopped(s->options) && s->rehearsal)
            return tr_status_fail(st, TR_INTERRUPTED, "stopped in the rehearsal; %s holds case.yaml only",
                                  s->options->dir);
        if (tr_run_stopped(s->options))
            return tr_status_fail(st, TR_INTERRUPTED, "stopped at time %.4g s of %g s", time_of(s), s->scene->time_end);
        if (!tr_step_forces(&s->b.world, st) || !tr_recorder_step(&s->out.recorder, st)) return false;
        unsigned due = tr_outputs_due(&s->out, k, total) & (s->rehearsal ? TR_DUE_FRAME : ~0u);
        if (due && !look(s, due, st)) return false;
        if (k == total) return true;
        if (k % 256 == 0) tr_run_progress(s->options, s->rehearsal ? "rehearsal" : "run", (double)k / (double)total);
        tr_step_advance(&s->b.world);
    }
}

/* The film's box, from a run without outputs. Where this one breaks down the run will, with what it has written. */
static bool rehearse(show *s, tr_status *st) {
    s->rehearsal = true;
    s->out.scene = s->scene;
    s->view = (tr_view){.world = &s->b.world,
                        .title = s->options->title,
                        .x0 = INFINITY,
                        .y0 = INFINITY,
                        .x1 = -INFINITY,
                        .y1 = -INFINITY};
    bool ok = tr_bodies_init(&s->b, s->scene, st);
    if (ok) s->view.time_end = s->scene->time_end, ok = play(s, st);
    if (ok) s->most = tr_recorder_most(&s->b.world, st), ok = !st->code;
    /* Room for what lies around the disks: hatching of a floor, arcs along it. */
    double margin = 0.08 * fmax(s->view.x1 - s->view.x0, s->view.y1 - s->view.y0);
    s->view.x0 -= margin, s->view.x1 += margin, s->view.y0 -= margin, s->view.y1 += margin;
    tr_bodies_free(&s->b);
    free(s->out.records);
    s->out = (tr_outputs){0};
    s->rehearsal = false;
    if (st->code == TR_NUMERICAL) *st = (tr_status){0}, ok = true;
    return ok;
}

static void report_bodies(const show *s, tr_run_report *r, const tr_timing *timing) {
    tr_run_say(r, "disks, walls", "%d, %d", s->scene->n_disks, s->scene->n_walls);
    tr_run_say(r, "time", "%g s", s->scene->time_end);
    if (isinf(s->b.dt_bound))
        tr_run_say(r, "time step", "%.3g s, no bound: nothing that touches can vibrate", s->b.world.dt);
    else
        tr_run_say(r, "time step", "%.3g s, bound %.3g s", s->b.world.dt, s->b.dt_bound);
    tr_run_say(r, "steps", "%lld", (long long)s->b.steps);
    tr_run_say(r, "wall time", "%.1f s", timing->wall_s);
}

bool tr_run_check_bodies(const tr_scene *scene, tr_status *st) {
    tr_bodies *b = tr_alloc(1, sizeof *b, st);
    bool ok = b && tr_bodies_init(b, scene, st);
    if (ok) tr_bodies_free(b);
    free(b);
    return ok;
}

bool tr_run_bodies(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    show *s = tr_alloc(1, sizeof *s, st);
    if (!s) return false;
    s->scene = scene, s->options = options;
    double started = tr_run_clock();
    bool ok = tr_run_check_bodies(scene, st) && tr_run_open(scene, options, st) &&
              (!(scene->output.frames || tr_recorder_wants_most(scene)) || rehearse(s, st)) &&
              tr_bodies_init(&s->b, scene, st);
    if (ok) {
        double playing = tr_run_clock();
        if (tr_outputs_open(&s->out, scene, options, "bodies.mp4", s->b.steps, report, st) &&
            tr_recorder_open(&s->out.recorder, scene, s->most, &s->b.world, options->dir, report, st))
            play(s, st);
        double stepping = tr_run_clock() - playing - s->out.seconds;
        ok = tr_outputs_close(&s->out, st);
        tr_timing timing = {tr_run_clock() - started, (double)s->b.world.contact_updates / stepping};
        char *text = ok ? tr_summary_bodies(scene, &s->b, &timing, st) : NULL;
        ok = text && tr_file_write(options->dir, "summary.json", text, st);
        free(text);
        if (ok) report_bodies(s, report, &timing);
    }
    tr_bodies_free(&s->b);
    free(s);
    return ok;
}
