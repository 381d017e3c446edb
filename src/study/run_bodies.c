/* SPDX-License-Identifier: MIT */
/* Scenes of a few bodies with their outputs, one or several side by side (documents of a case). They run twice. The
 * first run writes nothing. It finds the part of the plane, the speeds and the curves of the film, so that only the
 * bodies move in the picture; the numbers of the checks, for the still; and the most mobilised contact at the end.
 *
 * Each scene has its own step. The scene with the most steps gives the time; the others follow within a step. */
#include "study/run_bodies.h"

#include "base/alloc.h"
#include "draw/canvas.h"
#include "out/summary.h"
#include "out/manifest.h"
#include "study/clock.h"
#include "study/film.h"
#include "study/open.h"
#include "study/outputs.h"
#include "study/picture.h"
#include "study/play.h"
#include "study/recorder.h"
#include "study/shown_check.h"
#include "study/warn.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct show {
    const tr_scene *scene; /* the first; its outputs apply to all */
    const tr_run_options *options;
    tr_run_report *report;
    tr_outputs out;
    tr_cast cast;
    bool rehearsal, has_still;
    tr_view_box view;
    tr_contact_id most[TR_MAX_LANES];
    tr_check_result result[TR_MAX_LANES * TR_MAX_CHECKS];
    int n_results;
} show;

static const tr_scene *scene_of(const show *s, int i) {
    return i ? &s->scene->more[i - 1] : s->scene;
}

static void close_plays(show *s) {
    for (int i = 0; i < s->cast.n; i++) {
        if (!s->cast.play[i]) continue;
        tr_play_close(s->cast.play[i]);
        free(s->cast.play[i]);
        s->cast.play[i] = NULL;
    }
}

static bool open_plays(show *s, tr_status *st) {
    assert(s->cast.n > 0);
    s->cast.leader = 0;
    for (int i = 0; i < s->cast.n; i++) {
        s->cast.play[i] = tr_alloc(1, sizeof *s->cast.play[i], st);
        if (!s->cast.play[i] || !tr_play_open(s->cast.play[i], scene_of(s, i), s->scene->output.curve, st))
            return false;
        if (!tr_run_threads(s->options, &s->cast.play[i]->b.world, st)) return false;
        if (s->cast.play[i]->b.steps > s->cast.play[s->cast.leader]->b.steps) s->cast.leader = i;
    }
    return true;
}

static bool keep_still(show *s, tr_status *st) {
    char path[TR_PATH];
    s->has_still = true;
    if (!tr_dir_path(path, s->options->dir, "still.png", st) || !tr_manifest_add(s->options->dir, "still.png", st))
        return false;
    tr_canvas *canvas = tr_canvas_create(st);
    if (!canvas) return false;
    tr_picture_draw(canvas, &s->cast, &s->view, s->result, s->n_results);
    bool ok = tr_canvas_png(canvas, path, st);
    tr_canvas_free(canvas);
    return ok;
}

/* ---- the run ---- */

static bool write_rows(show *s, tr_status *st) {
    for (int i = 0; i < s->cast.n; i++) {
        const tr_play *p = s->cast.play[i];
        for (int disk = 0; disk < p->b.world.disks.n; disk++) {
            tr_row row = {.shape = p->scene->shape};
            if (s->cast.n > 1) tr_row_add(&row, i, "scene");
            tr_row_disk(&row, tr_play_time(p), &p->b.world, disk);
            if (!tr_row_write(&row, &s->out.history, st)) return false;
        }
    }
    s->out.rows++;
    return true;
}

static bool write_contacts(show *s, tr_status *st) {
    s->out.instants++;
    for (int i = 0; i < s->cast.n; i++) {
        const tr_play *p = s->cast.play[i];
        if (!tr_outputs_contacts(&s->out, s->cast.n > 1 ? i : -1, tr_play_time(p), -1, p->records, p->n_records, st))
            return false;
    }
    return true;
}

static bool look(show *s, unsigned due, tr_status *st) {
    double start = tr_run_clock();
    for (int i = 0; i < s->cast.n; i++) {
        tr_play *p = s->cast.play[i];
        if (!tr_play_observe(p, st)) return false;
        if (s->rehearsal) tr_picture_widen(&s->view, p);
    }
    if (s->rehearsal) return s->out.film.frames++, true;
    if (due & TR_DUE_ROW && !write_rows(s, st)) return false;
    if (due & TR_DUE_CONTACTS && !write_contacts(s, st)) return false;
    if (due & TR_DUE_FRAME) {
        const tr_play *p = s->cast.play[s->cast.leader];
        if (!s->has_still && tr_play_time(p) > s->scene->output.still - 0.5 * p->b.world.dt && !keep_still(s, st))
            return false;
        tr_picture_draw(s->out.film.canvas, &s->cast, &s->view, NULL, 0);
        if (!tr_film_frame(&s->out.film, st)) return false;
    }
    s->out.seconds += tr_run_clock() - start;
    return true;
}

static bool play(show *s, tr_status *st) {
    int64_t total = s->cast.play[s->cast.leader]->b.steps;
    for (int64_t k = 0; k <= total; k++) {
        double time = tr_play_time(s->cast.play[s->cast.leader]);
        if (tr_run_stopped(s->options) && s->rehearsal)
            return tr_status_fail(st, TR_INTERRUPTED, "stopped in the first pass; %s has only case.yaml",
                                  s->options->dir);
        if (tr_run_stopped(s->options))
            return tr_status_fail(st, TR_INTERRUPTED, "stopped at time %.4g s of %g s", time, s->scene->time_end);
        for (int i = 0; i < s->cast.n; i++)
            if (!tr_play_to(s->cast.play[i], k * s->cast.play[i]->b.steps / total, st)) return false;
        unsigned due = tr_outputs_due(&s->out, k, total) & (s->rehearsal ? TR_DUE_FRAME : ~0u);
        if (due && !look(s, due, st)) return false;
        if (k % 256 == 0) tr_run_progress(s->options, s->rehearsal ? "first pass" : "run", (double)k / (double)total);
    }
    return true;
}

static void take_results(show *s) {
    s->n_results = 0;
    for (int i = 0; i < s->cast.n; i++) {
        tr_checks_results(&s->cast.play[i]->checks, &s->result[s->n_results]);
        s->n_results += s->cast.play[i]->scene->n_checks;
    }
}

/* The film's box, from a run without outputs. If this run breaks down, so will the next, which keeps its outputs. */
static bool rehearse(show *s, tr_status *st) {
    s->rehearsal = true;
    s->out.scene = s->scene;
    s->view = tr_picture_empty();
    bool ok = open_plays(s, st) && play(s, st);
    for (int i = 0; i < s->cast.n && ok; i++)
        s->most[i] = tr_recorder_most(&s->cast.play[i]->b.world, st), ok = !st->code;
    if (ok) tr_picture_settle(&s->view, &s->cast);
    if (st->code == TR_NUMERICAL) *st = (tr_status){0}, ok = true;
    return ok;
}

/* Results from before the run: thresholds in `from`, and the rest from a first pass. */
static bool prepare(show *s, tr_status *st) {
    bool rehearsed = s->scene->output.frames || tr_recorder_wants_most(s->scene);
    if (!(rehearsed ? rehearse(s, st) : open_plays(s, st))) return false;
    for (int i = 0; i < s->cast.n; i++)
        if (!tr_checks_thresholds(&s->cast.play[i]->checks, s->options, st)) return false;
    take_results(s);
    if (!rehearsed) return true;
    tr_checks found[TR_MAX_LANES];
    for (int i = 0; i < s->cast.n; i++) found[i] = s->cast.play[i]->checks, s->cast.play[i]->checks = (tr_checks){0};
    close_plays(s);
    s->out = (tr_outputs){0};
    s->rehearsal = false;
    bool ok = open_plays(s, st);
    for (int i = 0; i < s->cast.n; i++) {
        if (ok) s->cast.play[i]->marks.range = s->view.range;
        if (ok) tr_checks_adopt(&s->cast.play[i]->checks, &found[i]);
        tr_checks_free(&found[i]);
    }
    return ok;
}

static bool open_outputs(show *s, tr_status *st) {
    int64_t total = s->cast.play[s->cast.leader]->b.steps;
    const tr_outputs_wanted wanted = {s->scene, s->options, "bodies.mp4", total, false};
    if (!tr_outputs_open(&s->out, &wanted, s->report, st)) return false;
    for (int i = 0; i < s->cast.n; i++) {
        tr_play *p = s->cast.play[i];
        char prefix[16] = "";
        if (s->cast.n > 1) snprintf(prefix, sizeof prefix, "%d-", i);
        const tr_recording recorded = {s->scene, &p->b.world, s->options->dir, prefix, s->most[i], 0, false};
        if (!tr_recorder_open(&p->recorder, &recorded, s->report, st)) return false;
        tr_status why = {0};
        if (s->scene->output.frames && p->recorder.paths.contacts.n)
            tr_inset_open(&p->inset, &p->b.world, p->recorder.paths.contacts.item[0], &why);
    }
    return true;
}

static void report_bodies(show *s, const tr_timing *timing) {
    tr_run_report *r = s->report;
    for (int i = 0; i < s->cast.n; i++) {
        const tr_play *p = s->cast.play[i];
        if (s->cast.n > 1) tr_run_say(r, "scene", "%s", *p->scene->label ? p->scene->label : "(no label)");
        tr_run_say(r, "disks, walls", "%d, %d", p->scene->n_disks, p->scene->n_walls);
        if (isinf(p->b.dt_bound))
            tr_run_say(r, "time step", "%.3g s, no bound: no contact can vibrate", p->b.world.dt);
        else
            tr_run_say(r, "time step", "%.3g s, bound %.3g s", p->b.world.dt, p->b.dt_bound);
        tr_run_say(r, "steps", "%lld", (long long)p->b.steps);
    }
    tr_run_say(r, "time", "%g s", s->scene->time_end);
    for (int i = 0; i < s->n_results; i++) tr_run_say_check(r, &s->result[i], s->cast.n > 1);
    tr_run_say(r, "accuracy", "%s",
               s->n_results ? "the errors above, which include the step; nothing else is examined"
                            : "not examined: no checks; run again with half of step.safety, and compare");
    tr_run_say(r, "wall time", "%.1f s", timing->wall_s);
}

char *tr_run_check_bodies(const tr_scene *scene, tr_run_report *report, tr_status *st) {
    int n = 1 + scene->n_more, open = 0, results = 0;
    tr_bodies *b = tr_alloc((size_t)n, sizeof *b, st);
    const tr_bodies *each[TR_MAX_LANES];
    tr_check_result result[TR_MAX_LANES * TR_MAX_CHECKS];
    char *summary = NULL;
    for (bool ok = b; ok && open < n; open += ok) {
        const tr_scene *of = open ? &scene->more[open - 1] : scene;
        tr_checks checks = {0};
        each[open] = &b[open];
        ok = tr_bodies_init(&b[open], of, st);
        if (ok) tr_warn_bodies(&b[open], scene->n_more ? of->label : "", report);
        if (!ok || !tr_checks_open(&checks, of, st)) continue;
        tr_checks_results(&checks, &result[results]);
        results += of->n_checks;
        tr_checks_free(&checks);
    }
    if (b && !st->code) summary = tr_summary_bodies(scene, each, result, results, &(tr_timing){0}, st);
    while (open) tr_bodies_free(&b[--open]);
    free(b);
    return summary;
}

static bool summarise(show *s, const tr_timing *timing, tr_status *st) {
    const tr_bodies *b[TR_MAX_LANES];
    for (int i = 0; i < s->cast.n; i++) b[i] = &s->cast.play[i]->b;
    char *text = tr_summary_bodies(s->scene, b, s->result, s->n_results, timing, st);
    bool ok = text && tr_file_write(s->options->dir, "summary.json", text, st);
    free(text);
    return ok;
}

bool tr_run_bodies(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    show *s = tr_alloc(1, sizeof *s, st);
    if (!s) return false;
    s->scene = scene, s->options = options, s->report = report;
    s->cast = (tr_cast){.scene = scene, .title = options->title, .n = 1 + scene->n_more};
    double started = tr_run_clock();
    bool ok = tr_run_open(scene, options, NULL, report, st) && prepare(s, st);
    if (ok) {
        double playing = tr_run_clock(), updates = 0;
        if (open_outputs(s, st)) play(s, st);
        double stepping = tr_run_clock() - playing - s->out.seconds;
        for (int i = 0; i < s->cast.n; i++) {
            tr_recorder_close(&s->cast.play[i]->recorder, st);
            updates += (double)s->cast.play[i]->b.world.contact_updates;
        }
        take_results(s);
        tr_timing timing = {tr_run_clock() - started, updates / stepping};
        ok = tr_outputs_close(&s->out, st) && summarise(s, &timing, st);
        if (ok) report_bodies(s, &timing);
    }
    close_plays(s);
    free(s);
    return ok;
}
