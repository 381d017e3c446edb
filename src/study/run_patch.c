/* SPDX-License-Identifier: MIT */
/* The inside of one contact along its path, with its tables, curves, pictures and summary. With pictures it runs twice:
 * the first run writes nothing and finds the largest slip of a step, so that one scale serves the whole film. */
#include "study/run_patch.h"

#include "base/alloc.h"
#include "draw/frame_patch.h"
#include "out/plot.h"
#include "out/summary.h"
#include "study/clock.h"
#include "study/film.h"
#include "study/inside.h"
#include "study/open.h"
#include "study/run_contact.h"
#include "study/schedule.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

typedef struct show {
    const tr_scene *scene;
    const tr_run_options *options;
    tr_inside *inside;
    tr_patch_pair pair;
    int64_t total, done; /* steps */
    tr_file contact, patch;
    tr_film film;
    int64_t rows; /* of contact.csv, and instants of patch.csv, written so far */
    int snapshots;
    double P_max, slip_max;
    bool rehearsal;
    tr_patch_result result;
} show;

static const char *const solver_name[] = {"half-plane", "brush", "carter", "cattaneo"};

static bool write_patch(show *s, tr_status *st) {
    const tr_patch_state *p = tr_inside_patch(s->inside);
    int n = p->P > 0 ? p->n : 0;
    for (int i = 0; i < n; i++) {
        tr_row row = {0};
        tr_row_add(&row, s->snapshots, "snapshot");
        tr_row_add(&row, (double)s->done, "step");
        tr_row_add(&row, p->x[i], "x_m");
        tr_row_add(&row, p->p[i], "p_Pa");
        tr_row_add(&row, p->tau[i] + 0.0, "tau_Pa");
        tr_row_add(&row, p->slip[i] + 0.0, "slip_m");
        tr_row_add(&row, p->side[i] == 0, "stick");
        if (!tr_row_write_exact(&row, &s->patch, st)) return false;
    }
    s->snapshots++;
    return true;
}

/* printf with a true minus, for the panel. */
__attribute__((format(printf, 3, 4))) static void say(char *text, size_t size, const char *format, ...) {
    char plain[40];
    va_list args;
    va_start(args, format);
    vsnprintf(plain, sizeof plain, format, args);
    va_end(args);
    snprintf(text, size, "%s%s", *plain == '-' ? "−" : "", plain + (*plain == '-'));
}

static bool draw(show *s, const tr_contact_state *now, tr_status *st) {
    const tr_patch_state *p = tr_inside_patch(s->inside);
    const tr_scene_segment *g = &s->scene->path[now->segment];
    char text[6][48];
    const tr_view_line lines[] = {{"solver", solver_name[s->scene->patch.solver]},
                                  {"normal force P", text[0]},
                                  {"friction Q", text[1]},
                                  {"Q/μP", text[2]},
                                  {"half-width a", text[3]},
                                  {"slid so far", text[4]},
                                  {"rolled so far", text[5]}};
    say(text[0], sizeof text[0], "%.4g kN/m", now->P / 1e3);
    say(text[1], sizeof text[1], "%.4g kN/m", now->Q / 1e3);
    say(text[2], sizeof text[2], "%.3f", now->q);
    say(text[3], sizeof text[3], "%.4g µm", 1e6 * now->a);
    say(text[4], sizeof text[4], "%.4g µm", 1e6 * now->u_slide);
    say(text[5], sizeof text[5], "%.3g a", now->a > 0 ? now->u_roll / now->a : 0);
    tr_patch_view view = {.pair = &s->pair,
                          .state = p,
                          .v_slide = p->du * g->steps,
                          .v_roll = g->roll,
                          .a_max = tr_patch_a(&s->pair, s->P_max),
                          .p_max = tr_patch_p0(&s->pair, s->P_max),
                          .slip_max = s->slip_max,
                          .progress = (double)s->done / (double)s->total,
                          .title = *s->scene->lesson.title ? s->scene->lesson.title : "Inside the contact",
                          .line = lines,
                          .n_lines = sizeof lines / sizeof *lines};
    tr_draw_patch(s->film.canvas, &view);
    return tr_film_frame(&s->film, st);
}

/* Items asked for, no more than there are steps. */
static int most(int asked, int64_t total) {
    return asked <= total ? asked : (int)total;
}

static bool look(show *s, const tr_contact_state *now, tr_status *st) {
    const tr_patch_state *p = tr_inside_patch(s->inside);
    s->P_max = fmax(s->P_max, now->P);
    for (int i = 0; i < p->n && p->P > 0; i++) s->slip_max = fmax(s->slip_max, fabs(p->slip[i]));
    if (s->rehearsal) return true;
    s->result.Q_end = now->Q, s->result.q_end = now->q, s->result.u_slide_end = now->u_slide;
    s->result.dissipated += p->dissipated;
    tr_row row = {0};
    tr_run_contact_row(&row, now);
    if (!tr_row_write_exact(&row, &s->contact, st)) return false;
    s->rows++;
    const tr_scene_patch *want = &s->scene->patch;
    int64_t k = s->done - 1, end = s->total - 1; /* the first is after the first step */
    if (tr_run_is_due(s->snapshots, most(want->snapshots, s->total), k, end) && !write_patch(s, st)) return false;
    return !tr_run_is_due(s->film.frames, most(want->frames, s->total), k, end) || draw(s, now, st);
}

static bool play(show *s, bool rehearsal, tr_status *st) {
    s->rehearsal = rehearsal;
    if (!(s->inside = tr_inside_new(s->scene, st))) return false;
    tr_contact_state now;
    bool ok = true;
    for (s->done = 0; ok && s->done < s->total;) {
        if (tr_run_stopped(s->options))
            return tr_status_fail(st, TR_INTERRUPTED, "stopped at step %lld of %lld%s", (long long)s->done,
                                  (long long)s->total, rehearsal ? " of the rehearsal for the film" : "");
        if (s->done % 16 == 0)
            tr_run_progress(s->options, rehearsal ? "rehearsal" : "path", (double)s->done / (double)s->total);
        ok = tr_inside_step(s->inside, &now, st);
        s->done++;
        ok = ok && look(s, &now, st);
    }
    if (rehearsal) tr_inside_free(s->inside), s->inside = NULL;
    return ok;
}

/* Files get their names whatever ended the run: their rows are whole. Returns st->code == TR_OK. */
static bool close_files(show *s, tr_status *st) {
    tr_status closing = {0};
    if (!(s->rows && tr_file_commit(&s->contact, &closing))) s->rows = 0, tr_file_discard(&s->contact);
    if (!(s->snapshots && tr_file_commit(&s->patch, &closing))) tr_file_discard(&s->patch);
    bool film = tr_film_close(&s->film, &closing);
    if (closing.code) tr_status_fail(st, closing.code, "%s", closing.text);
    if (!st->code) return true;
    size_t used = strlen(st->text);
    snprintf(st->text + used, sizeof st->text - used,
             "\nkept in %s: %lld rows of contact.csv, %d snapshots, %d frames%s; not finished, no summary.json",
             s->options->dir, (long long)s->rows, s->snapshots, s->film.frames, film ? " and their film" : "");
    return false;
}

static bool plot(const show *s, tr_run_report *report, tr_status *st) {
    if (!s->scene->output.curves) return true;
    if (!tr_plot_available())
        return tr_run_note(report, "no curves: gnuplot is not installed; contact.csv has the numbers"), true;
    const char *label[] = {solver_name[s->scene->patch.solver]};
    int code = 0;
    if (!tr_plot_contact(s->options->dir, label, 1, false, TR_SHAPE_DISK, &code, st)) return false;
    if (code) tr_run_note(report, "no curves: gnuplot failed (%d) on plot.gp; run it there to see why", code);
    return true;
}

static bool run(show *s, tr_run_report *report, tr_status *st) {
    double started = tr_run_clock();
    const tr_scene_patch *want = &s->scene->patch;
    if (!tr_run_open(s->scene, s->options, NULL, report, st)) return false;
    if (want->frames && !play(s, true, st)) return false;
    double playing = tr_run_clock();
    bool ok = tr_file_open(&s->contact, s->options->dir, "contact.csv", st) &&
              (!want->snapshots || tr_file_open(&s->patch, s->options->dir, "patch.csv", st)) &&
              tr_film_open(&s->film, s->options->dir, "patch.mp4", most(want->frames, s->total), report, st) &&
              play(s, false, st);
    if (!close_files(s, st) || !ok) return false;
    tr_timing timing = {tr_run_clock() - started, (double)s->total / (tr_run_clock() - playing)};
    if (!plot(s, report, st)) return false;
    char *text = tr_summary_patch(s->scene, s->total, &s->result, &timing, st);
    ok = text && tr_file_write(s->options->dir, "summary.json", text, st);
    free(text);
    tr_run_say(report, "solver, elements", "%s, %d", solver_name[want->solver], want->elements);
    tr_run_say(report, "segments, steps", "%d, %lld", s->scene->n_segments, (long long)s->total);
    tr_run_say_rows(s->scene, report);
    tr_run_say(report, "at the end", "Q = %.6g N/m, Q/(mu P) = %.4g; slid %.6g m", s->result.Q_end, s->result.q_end,
               s->result.u_slide_end);
    return ok;
}

bool tr_run_patch(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    tr_scene played;
    if (!tr_run_with_path(scene, &played, st)) return false;
    show *s = tr_alloc(1, sizeof *s, st);
    bool ok = false;
    if (s) {
        s->scene = &played, s->options = options, s->pair = tr_inside_pair(&played);
        s->total = tr_contact_steps(&played);
        s->result.solver = solver_name[played.patch.solver];
        ok = run(s, report, st);
        tr_inside_free(s->inside);
        free(s);
    }
    tr_run_drop_path(&played);
    return ok;
}
