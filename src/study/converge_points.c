/* SPDX-License-Identifier: MIT */
#include "study/converge_points.h"

#include "study/clock.h"
#include "study/converge_cell.h"
#include "study/sweep_read.h"
#include "study/sweep_run.h"
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void tr_converge_note(tr_converge *c, const char *format, ...) {
    char line[TR_CONVERGE_NOTE];
    va_list args;
    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    for (int i = 0; i < c->n_notes; i++)
        if (!strcmp(c->note[i], line)) return;
    if (c->n_notes < TR_CONVERGE_NOTES) snprintf(c->note[c->n_notes++], TR_CONVERGE_NOTE, "%s", line);
}

/* What a run of a level leaves out: pictures take time and change no number. */
static const char *const quiet[] = {
    [TR_KIND_BIAXIAL] = "output.frames: 0, output.curves: no",
    [TR_KIND_BODIES] = "output.frames: 0",
    [TR_KIND_CONTACT] = "output.curves: no",
    [TR_KIND_PATCH] = "output.frames: 0, output.curves: no",
};
static const char *const kinds[] = {"biaxial", "bodies", "contact", "patch"}; /* tr_kind */

static void put_quoted(FILE *f, const char *text) {
    putc('"', f);
    for (; *text; text++) {
        if (*text == '"' || *text == '\\') putc('\\', f);
        putc(*text, f);
    }
    putc('"', f);
}

/* The keys of a cause: the first one varies and names the points, the others are set beside it. Items without the
 * setting are left alone. */
static void put_keys(const tr_converge *c, FILE *f, const tr_cause *cause, int finer) {
    char key[64];
    bool first = true;
    if (!cause) fprintf(f, "vary: {kind: [%s]}\nset: {", kinds[c->scene.kind]);
    for (int i = 0; cause && i < tr_cause_keys(cause, &c->scene); i++) {
        if (isnan(cause->own(&c->scene, i))) continue;
        tr_cause_key(cause, i, key, sizeof key);
        double setting = tr_cause_setting(cause, &c->scene, i, finer);
        fprintf(f, first ? "vary: {%s: [%.12g]}\nset: {" : "%s: %.12g, ", key, setting);
        first = false;
    }
    fprintf(f, "%s}\n", quiet[c->scene.kind]);
}

static bool write_sweep(const tr_converge *c, const tr_cause *cause, int finer, int seeds, char path[TR_PATH],
                        tr_status *st) {
    char name[80];
    snprintf(name, sizeof name, "sweeps/%s%s%d.yaml", cause ? cause->name : "own", finer < 0 ? "-" : "", abs(finer));
    tr_file file;
    if (!tr_dir_make(c->options->dir, "sweeps", st) || !tr_file_open(&file, c->options->dir, name, st)) return false;
    FILE *f = file.stream;
    fputs("# SPDX-License-Identifier: MIT\n# Made by trundle converge. To run it: trundle sweep FILE -o DIR/points\n"
          "kind: sweep\nbase: ",
          f);
    put_quoted(f, c->base);
    putc('\n', f);
    if (tr_converge_sampled(c))
        fprintf(f, "seeds: %" PRIu64 "-%" PRIu64 "\n", c->scene.seed, c->scene.seed + (uint64_t)seeds - 1);
    put_keys(c, f, cause, finer);
    fputs("collect: [timing.wall_s", f);
    for (int q = 0; q < c->n_numbers; q++)
        if (!strchr(c->number[q].name, '@')) fprintf(f, ", %s", c->number[q].name);
    fputs("]\n", f);
    return tr_file_commit(&file, st) && tr_dir_path(path, c->options->dir, name, st);
}

/* The budget and the user stop the runs. */
static void progress(void *context, const char *stage, double fraction) {
    tr_converge *c = context;
    const tr_converge_options *o = c->options;
    if (tr_run_clock() > c->until) c->halt = 1, c->late = true;
    if (o->stop && *o->stop) c->halt = 1;
    if (o->progress) o->progress(o->context, stage, fraction);
}

static void say(void *context, const char *line) {
    tr_converge *c = context;
    const char *error = strstr(line, "error: ");
    char text[TR_CONVERGE_NOTE];
    if (error) {
        snprintf(text, sizeof text, "%.*s", (int)strcspn(line, "\n"), line);
        tr_converge_note(c, "%s", text);
    }
    if (c->options->say) c->options->say(c->options->context, line);
}

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* From the directories of the points. */
static bool read_level(const tr_converge *c, const tr_grid *g, const char *points, tr_converge_level *level,
                       tr_status *st) {
    double seconds[TR_CONVERGE_SEEDS];
    int n = 0;
    for (int s = 0; s < g->n && s < TR_CONVERGE_SEEDS; s++) {
        char name[TR_POINT_NAME], dir[TR_PATH], summary[TR_PATH];
        tr_point_state state;
        tr_grid_name(g, s, name);
        if (!tr_grid_state(g, s, points, &state, st)) return false;
        if (state != TR_POINT_FINISHED) continue;
        if (!tr_dir_path(dir, points, name, st) || !tr_dir_path(summary, dir, "summary.json", st) ||
            !tr_summary_read(summary, "timing.wall_s", &seconds[n], st))
            return false;
        for (int q = 0; q < c->n_numbers; q++) {
            const char *what = c->number[q].name;
            bool ok = strchr(what, '@') ? tr_converge_cell(dir, c->scene.kind, what, &level->value[q][s], st)
                                        : tr_summary_read(summary, what, &level->value[q][s], st);
            if (!ok) return false;
        }
        n++;
    }
    qsort(seconds, (size_t)n, sizeof *seconds, compare);
    level->seconds = n ? seconds[n / 2] : NAN;
    return true;
}

static void clear(tr_converge_level *level) {
    level->seconds = NAN;
    for (int q = 0; q < TR_CONVERGE_NUMBERS; q++)
        for (int s = 0; s < TR_CONVERGE_SEEDS; s++) level->value[q][s] = NAN;
}

static bool run_points(tr_converge *c, const tr_grid *g, const char *points, tr_status *inner) {
    const tr_grid_options o = {.dir = points,
                               .jobs = c->options->jobs,
                               .end = g->n,
                               .stop = &c->halt,
                               .progress = progress,
                               .say = say,
                               .context = c};
    tr_grid_report report;
    return tr_grid_run(g, &o, &report, inner);
}

bool tr_converge_level_run(tr_converge *c, const tr_cause *cause, int finer, int seeds, tr_converge_level *level,
                           tr_status *st) {
    char path[TR_PATH], points[TR_PATH];
    tr_grid grid;
    tr_status inner = {0};
    clear(level);
    if (!write_sweep(c, cause, finer, seeds, path, st) || !tr_dir_path(points, c->options->dir, "points", st) ||
        !tr_dir_make(c->options->dir, "points", st))
        return false;
    bool read = tr_grid_read(&grid, path, false, &inner);
    if (read) run_points(c, &grid, points, &inner);
    bool some = strstr(inner.text, "points failed"); /* the others are there; else a case that is refused has none */
    bool ok = inner.code != TR_FILE || some;
    if (read && (some || inner.code != TR_BAD_CASE) && ok) ok = read_level(c, &grid, points, level, st);
    tr_grid_free(&grid);
    if (!ok) return tr_status_fail(st, inner.code, "%s", inner.text);
    if (inner.code == TR_INTERRUPTED)
        return c->late || tr_status_fail(st, TR_INTERRUPTED, "stopped; the same command goes on");
    level->state = isnan(level->seconds) ? TR_LEVEL_FAILED : TR_LEVEL_DONE;
    if (inner.code) {
        char *line = strchr(inner.text, '\n');
        if (line) *line = '\0';
        if (cause)
            tr_converge_note(c, "%s = %.6g: %s", cause->key, level->setting, inner.text);
        else
            tr_converge_note(c, "the case as it is: %s", inner.text);
    }
    return true;
}

bool tr_converge_level_there(tr_converge *c, const tr_cause *cause, int finer, int seeds) {
    char path[TR_PATH], points[TR_PATH];
    tr_status ignored = {0};
    tr_grid grid;
    bool all = true;
    if (!write_sweep(c, cause, finer, seeds, path, &ignored) ||
        !tr_dir_path(points, c->options->dir, "points", &ignored))
        return false;
    all = tr_grid_read(&grid, path, false, &ignored);
    for (int s = 0; all && s < grid.n; s++) {
        tr_point_state state;
        all = tr_grid_state(&grid, s, points, &state, &ignored) && state == TR_POINT_FINISHED;
    }
    tr_grid_free(&grid);
    return all;
}
