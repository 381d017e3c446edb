/* SPDX-License-Identifier: MIT */
/* With pictures it runs twice: the first run writes nothing and finds the largest slip of a step, so that one
 * scale serves the whole film. */
#include "study/run_patch.h"

#include "base/alloc.h"
#include "draw/canvas.h"
#include "draw/frame_patch.h"
#include "out/table.h"
#include "draw/words.h"
#include "study/film.h"
#include "study/inside.h"
#include "study/schedule.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

typedef struct show {
    tr_inside *inside;
    tr_patch_pair pair;
    tr_file patch;
    tr_film film;
    int snapshots; /* instants of patch.csv written so far */
    double P_max, slip_max;
} show;

static const char *const solver_name[] = {"half-plane", "brush", "carter", "cattaneo"};

static void name(tr_driven *d, int i) {
    tr_path_result *r = &d->result[i];
    *r = (tr_path_result){.solver = solver_name[d->scene->patch.solver]};
    snprintf(r->label, sizeof r->label, "%s", r->solver);
}

static bool start(tr_driven *d, tr_status *st) {
    if (!d->own && !(d->own = tr_alloc(1, sizeof(show), st))) return false;
    show *s = d->own;
    s->pair = tr_inside_pair(d->scene);
    tr_inside_free(s->inside);
    return (s->inside = tr_inside_new(d->scene, st));
}

static bool step(tr_driven *d, tr_status *st) {
    return tr_inside_step(((show *)d->own)->inside, d->state, st);
}

static void release(tr_driven *d) {
    if (d->own) tr_inside_free(((show *)d->own)->inside);
    free(d->own);
}

static bool write_patch(const tr_driven *d, tr_status *st) {
    show *s = d->own;
    const tr_patch_state *p = tr_inside_patch(s->inside);
    int n = p->P > 0 ? p->n : 0;
    for (int i = 0; i < n; i++) {
        tr_row row = {0};
        tr_row_add(&row, s->snapshots, "snapshot");
        tr_row_add(&row, (double)d->done, "step");
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
__attribute__((format(printf, 3, 4))) static void put(char *text, size_t size, const char *format, ...) {
    char plain[40];
    va_list args;
    va_start(args, format);
    vsnprintf(plain, sizeof plain, format, args);
    va_end(args);
    snprintf(text, size, "%s%s", *plain == '-' ? "−" : "", plain + (*plain == '-'));
}

static bool draw(const tr_driven *d, tr_status *st) {
    show *s = d->own;
    const tr_contact_state *now = d->state;
    const tr_patch_state *p = tr_inside_patch(s->inside);
    const tr_scene_segment *g = &d->scene->path[now->segment];
    char text[6][48];
    const tr_language language = (tr_language)d->scene->language;
    const tr_view_line lines[] = {{tr_words_of(language, TR_WORD_patch_solver), solver_name[d->scene->patch.solver]},
                                  {tr_words_of(language, TR_WORD_patch_force), text[0]},
                                  {tr_words_of(language, TR_WORD_patch_friction), text[1]},
                                  {"Q/μP", text[2]},
                                  {tr_words_of(language, TR_WORD_patch_a), text[3]},
                                  {tr_words_of(language, TR_WORD_patch_slid), text[4]},
                                  {tr_words_of(language, TR_WORD_patch_rolled), text[5]}};
    put(text[0], sizeof text[0], "%.4g kN/m", now->P / 1e3);
    put(text[1], sizeof text[1], "%.4g kN/m", now->Q / 1e3);
    put(text[2], sizeof text[2], "%.3f", now->q);
    put(text[3], sizeof text[3], "%.4g µm", 1e6 * now->a);
    put(text[4], sizeof text[4], "%.4g µm", 1e6 * now->u_slide);
    put(text[5], sizeof text[5], "%.3g a", now->a > 0 ? now->u_roll / now->a : 0);
    tr_patch_view view = {.pair = &s->pair,
                          .state = p,
                          .v_slide = p->du * g->steps,
                          .v_roll = g->roll,
                          .a_max = tr_patch_a(&s->pair, s->P_max),
                          .p_max = tr_patch_p0(&s->pair, s->P_max),
                          .slip_max = s->slip_max,
                          .progress = (double)d->done / (double)d->total,
                          .title = *d->scene->lesson.title ? d->scene->lesson.title
                                                           : tr_words_of(language, TR_WORD_patch_title),
                          .line = lines,
                          .n_lines = sizeof lines / sizeof *lines};
    tr_canvas_speak(s->film.canvas, d->scene->language);
    tr_draw_patch(s->film.canvas, &view);
    return tr_film_frame(&s->film, st);
}

/* The wanted items, but at most the number of steps. */
static int most(int asked, int64_t total) {
    return asked <= total ? asked : (int)total;
}

static bool rehearses(const tr_driven *d) {
    return d->scene->patch.frames;
}

static void watch(tr_driven *d) {
    show *s = d->own;
    const tr_patch_state *p = tr_inside_patch(s->inside);
    s->P_max = fmax(s->P_max, d->state->P);
    for (int i = 0; i < p->n && p->P > 0; i++) s->slip_max = fmax(s->slip_max, fabs(p->slip[i]));
}

static bool open_files(tr_driven *d, tr_status *st) {
    show *s = d->own;
    const tr_scene_patch *want = &d->scene->patch;
    return (!want->snapshots || tr_file_open(&s->patch, d->options->dir, "patch.csv", st)) &&
           tr_film_open(&s->film, d->options->dir, "patch.mp4", most(want->frames, d->total), d->report, st);
}

static bool keep(tr_driven *d, tr_status *st) {
    show *s = d->own;
    const tr_scene_patch *want = &d->scene->patch;
    int64_t k = d->done - 1, end = d->total - 1; /* the first is after the first step */
    if (tr_run_is_due(s->snapshots, most(want->snapshots, d->total), k, end) && !write_patch(d, st)) return false;
    return !tr_run_is_due(s->film.frames, most(want->frames, d->total), k, end) || draw(d, st);
}

static void close_files(tr_driven *d, char kept[80], tr_status *st) {
    show *s = d->own;
    if (!(s->snapshots && tr_file_commit(&s->patch, st))) tr_file_discard(&s->patch);
    bool film = tr_film_close(&s->film, st);
    snprintf(kept, 80, ", %d snapshots, %d frames%s", s->snapshots, s->film.frames, film ? " and their film" : "");
}

static void say(tr_driven *d) {
    const tr_path_result *r = d->result;
    tr_run_say(d->report, "solver, elements", "%s, %d", r->solver, d->scene->patch.elements);
    tr_run_say(d->report, "at the end", "Q = %.6g N/m, Q/(mu P) = %.4g; slid %.6g m", r->Q_end, r->q_end,
               r->u_slide_end);
}

const tr_driven_kind tr_driven_patch = {.name = name,
                                        .start = start,
                                        .step = step,
                                        .free = release,
                                        .rehearses = rehearses,
                                        .watch = watch,
                                        .open = open_files,
                                        .keep = keep,
                                        .close = close_files,
                                        .say = say};
