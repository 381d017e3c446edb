/* SPDX-License-Identifier: MIT */
#include "study/converge.h"

#include "base/alloc.h"
#include "laws/law.h"
#include "out/manifest.h"
#include "study/clock.h"
#include "study/converge_cost.h"
#include "study/converge_numbers.h"
#include "study/converge_points.h"
#include "study/converge_tables.h"
#include "study/converge_text.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FEWEST_SEEDS = 4, MOST_SEEDS = 10, USUAL_SEEDS = 8 };

/* What a budget is divided by to find the number of seeds: the case, half and twice each setting, and a little more. */
static const double RUNS_OF_A_SEED = 14;

static void add_ladders(tr_converge *c) {
    for (int i = 0; i < tr_n_causes && c->n_ladders < TR_CONVERGE_CAUSES; i++) {
        const tr_cause *cause = &tr_causes[i];
        if (!tr_cause_applies(cause, &c->scene)) continue;
        tr_converge_ladder *l = &c->ladder[c->n_ladders++];
        l->cause = cause;
        l->own = cause->coarser_levels;
        l->n = l->own + 1 + cause->finer_levels;
        for (int k = 0; k < l->n; k++) {
            tr_converge_level *level = &l->level[k];
            bool fits = true;
            level->setting = NAN, level->seconds = NAN;
            for (int item = 0; item < tr_cause_keys(cause, &c->scene); item++) {
                if (isnan(cause->own(&c->scene, item))) continue;
                double x = tr_cause_setting(cause, &c->scene, item, k - l->own);
                fits = fits && !isnan(x);
                if (isnan(level->setting)) level->setting = x;
            }
            if (!fits) level->setting = NAN;
        }
    }
}

/* ---- which level is next ---- */

static double value_of(const tr_converge *c, int q) {
    return c->own.value[q][0];
}

/* All numbers: the answer does not change with more levels, or is good enough. */
static bool decided(const tr_converge *c, const tr_converge_ladder *l) {
    int finer = 0;
    for (int k = l->own + 1; k < l->n; k++) finer += l->level[k].state != TR_LEVEL_OPEN;
    for (int q = 0; q < c->n_numbers; q++) {
        const tr_ladder *of = &l->of[q];
        bool known = of->verdict == TR_VERDICT_ORDER || (of->verdict == TR_VERDICT_EXACT && finer >= 2) ||
                     (of->verdict == TR_VERDICT_NOISE && finer >= 2) ||
                     (of->verdict == TR_VERDICT_SCATTERED && of->unsure <= 0.1 * c->options->to * fabs(value_of(c, q)));
        if (!known && isfinite(value_of(c, q))) return false;
    }
    return true;
}

/* One finer, then the coarser ones, then ever finer; -1: there is none left. A finer level that failed ends the
 * ladder. */
static int next_level(const tr_converge *c, const tr_converge_ladder *l) {
    int fine = l->own + 1;
    while (fine < l->n && l->level[fine].state == TR_LEVEL_DONE) fine++;
    bool more = fine < l->n && l->level[fine].state == TR_LEVEL_OPEN && !isnan(l->level[fine].setting);
    if (more && fine == l->own + 1) return fine;
    for (int k = l->own - 1; k >= 0; k--) {
        if (l->level[k].state == TR_LEVEL_DONE) continue;
        if (l->level[k].state == TR_LEVEL_OPEN && !isnan(l->level[k].setting)) return k;
        break;
    }
    return more && !decided(c, l) ? fine : -1;
}

/* ---- what the levels say ---- */

static void judge(tr_converge *c, tr_converge_ladder *l) {
    double value[TR_LADDER_LEVELS * TR_CONVERGE_SEEDS];
    double r = l->cause->finer < 1 ? 1 / l->cause->finer : l->cause->finer;
    for (int q = 0; q < c->n_numbers; q++) {
        bool sampled = tr_converge_sampled(c);
        int stride = sampled ? TR_CONVERGE_SEEDS : 1;
        for (int k = 0; k < l->n; k++)
            for (int s = 0; s < stride; s++)
                value[k * stride + s] = l->level[k].state == TR_LEVEL_DONE ? l->level[k].value[q][s] : NAN;
        l->of[q] = sampled ? tr_ladder_of_samples(value, l->n, stride, c->n_seeds, l->own, r, l->cause->paired)
                           : tr_ladder_of(value, l->n, l->own, r, tr_converge_scale(c, q, value_of(c, q)));
        l->of[q].half += tr_converge_grain(c, q), l->of[q].unsure += tr_converge_grain(c, q);
    }
}

static void take_own(tr_converge *c) {
    for (int i = 0; i < c->n_ladders; i++) {
        tr_converge_ladder *l = &c->ladder[i];
        double setting = l->level[l->own].setting;
        l->level[l->own] = c->own;
        l->level[l->own].setting = setting;
        judge(c, l);
    }
    for (int q = 0; q < c->n_numbers && tr_converge_sampled(c); q++)
        c->sample[q] = tr_sample_error_of(c->own.value[q], c->n_seeds);
}

/* ---- runs ---- */

static bool run_own(tr_converge *c, tr_status *st) {
    const char *file = c->options->case_file;
    double left = c->until - tr_run_clock();
    if (!tr_converge_level_run(c, NULL, 0, 1, &c->own, st)) return false;
    if (c->own.state == TR_LEVEL_FAILED)
        return tr_status_fail(st, TR_BAD_CASE, "error: %.200s does not run: %.600s", file,
                              c->n_notes ? c->note[0] : "");
    if (c->own.state == TR_LEVEL_OPEN)
        return tr_status_fail(st, TR_BAD_CASE,
                              "error: a budget of %.3g s is too small for one run of %.200s, of which %.3g s are done",
                              c->options->budget, file, left);
    if (!tr_converge_sampled(c)) return true;
    double seeds = (c->until - tr_run_clock()) * c->options->jobs / (RUNS_OF_A_SEED * c->own.seconds);
    c->n_seeds = (int)fmin(fmax(seeds, FEWEST_SEEDS), MOST_SEEDS);
    c->own.state = TR_LEVEL_OPEN;
    if (!tr_converge_level_run(c, NULL, 0, c->n_seeds, &c->own, st)) return false;
    return c->own.state == TR_LEVEL_DONE ||
           tr_status_fail(st, TR_BAD_CASE,
                          "error: a budget of %.3g s is too small for %d seeds of %.200s (%.3g s each)",
                          c->options->budget, c->n_seeds, file, c->own.seconds);
}

static int tried(const tr_converge_ladder *l) {
    int n = 0;
    for (int k = 0; k < l->n; k++) n += l->level[k].state != TR_LEVEL_OPEN;
    return n;
}

/* Whether a ladder with this cost comes before another: each has its first level before one has its second, cheap
 * ones first. */
static bool comes_first(const tr_converge_ladder *l, double cost, const tr_converge_ladder *other, double other_cost) {
    int mine = tried(l), its = other ? tried(other) : 0;
    return !other || mine < its || (mine == its && cost < other_cost);
}

/* A history that was never full has merged nothing: that cause is left out. Bodies do not count. */
static bool drop_merging(tr_converge *c, tr_status *st) {
    char summary[TR_PATH];
    double merged = 0;
    if (c->scene.kind != TR_KIND_CONTACT) return true;
    if (!tr_dir_path(summary, c->options->dir, "points/kind=contact/summary.json", st)) return false;
    for (int i = 0; i < c->scene.n_laws; i++) {
        char name[64];
        double one;
        snprintf(name, sizeof name, "laws.%d.history_merged", i);
        if (!tr_summary_read(summary, name, &one, st)) return false;
        merged += one;
    }
    for (int i = 0; i < c->n_ladders && merged == 0; i++) {
        if (strcmp(c->ladder[i].cause->name, "merging") != 0) continue;
        c->n_ladders--;
        memmove(&c->ladder[i], &c->ladder[i + 1], (size_t)(c->n_ladders - i) * sizeof c->ladder[i]);
        i--;
    }
    return true;
}

/* The next level of all ladders, until each is decided or dear. */
static bool climb(tr_converge *c, tr_status *st) {
    bool ran = false;
    for (;;) {
        tr_converge_ladder *best = NULL;
        int next = -1;
        double least = INFINITY;
        for (int i = 0; i < c->n_ladders; i++) {
            tr_converge_ladder *l = &c->ladder[i];
            int k = l->dear ? -1 : next_level(c, l);
            double cost = k < 0 ? INFINITY : tr_converge_cost(c, l, k);
            if (k >= 0 && comes_first(l, cost, best, least)) best = l, next = k, least = cost;
        }
        if (!best) break;
        bool there = tr_converge_level_there(c, best->cause, next - best->own, c->n_seeds);
        if (!there && tr_run_clock() + least > c->until) {
            best->dear = true;
            continue;
        }
        tr_converge_level *level = &best->level[next];
        if (!tr_converge_level_run(c, best->cause, next - best->own, c->n_seeds, level, st)) return false;
        if (level->state == TR_LEVEL_OPEN) best->dear = true, c->late = false, c->halt = 0;
        ran |= level->state != TR_LEVEL_OPEN;
        judge(c, best);
    }
    bool dear = false;
    for (int i = 0; i < c->n_ladders; i++) dear |= c->ladder[i].dear;
    return ran || !dear ||
           tr_status_fail(st, TR_BAD_CASE,
                          "error: a budget of %.3g s is too small for one level beside the case itself (%.3g s a run)",
                          c->options->budget, c->own.seconds);
}

static void note_outliers(tr_converge *c) {
    for (int q = 0; q < c->n_numbers && tr_converge_sampled(c); q++) {
        const tr_sample_error *e = &c->sample[q];
        if (e->outlier < 0) continue;
        double x = c->own.value[q][e->outlier];
        tr_converge_note(
            c,
            "seed %llu is an outlier: its %s, %.4g, is %.0f deviations from the others. It is in all means; "
            "look at its run",
            (unsigned long long)c->scene.seed + (unsigned long long)e->outlier, c->number[q].name, x, e->off);
    }
}

/* ---- all of it ---- */

static bool open_case(tr_converge *c, tr_status *st) {
    const char *file = c->options->case_file;
    if (!tr_scene_read_file(&c->scene, file, NULL, 0, tr_laws_catalog(), st)) return false;
    c->base = realpath(file, NULL);
    if (!c->base) return tr_status_fail(st, TR_FILE, "error: cannot find %.300s: %s", file, strerror(errno));
    c->n_seeds = 1;
    c->own.seconds = NAN;
    if (!tr_converge_choose(c, st)) return false;
    add_ladders(c);
    if (c->n_ladders || tr_converge_sampled(c)) return true;
    return tr_status_fail(
        st, TR_BAD_CASE,
        "error: %.300s has no setting that an error could come from (a path that is a file has its steps)", file);
}

static bool look_ahead(tr_converge *c, char **text, tr_status *st) {
    if (tr_converge_sampled(c)) c->n_seeds = USUAL_SEEDS;
    c->own.seconds = tr_converge_guess(&c->scene);
    take_own(c);
    for (int i = 0; i < c->n_ladders; i++) c->ladder[i].level[c->ladder[i].own].seconds = c->own.seconds;
    return (*text = tr_converge_plan(c, st));
}

static bool run(tr_converge *c, char **text, tr_status *st) {
    const char *dir = c->options->dir;
    int lock = -1;
    if (c->options->plan) return look_ahead(c, text, st);
    if (!tr_dir_lock(dir, &lock, st)) return false;
    bool ok = tr_manifest_spare(dir, c->options->case_file, st) && run_own(c, st) && drop_merging(c, st);
    if (ok) take_own(c);
    ok = ok && climb(c, st);
    if (ok) note_outliers(c);
    ok = ok && tr_converge_write(c, text, st);
    if (lock >= 0) close(lock);
    return ok;
}

bool tr_converge_run(const tr_converge_options *options, char **text, tr_status *st) {
    /* For stopping the runs, for tables and for pictures, which take a second where nothing else runs: [s], and of
     * the budget. */
    static const double REST = 5, MOST = 0.25;
    tr_converge *c = tr_alloc(1, sizeof *c, st);
    *text = NULL;
    if (!c) return false;
    c->options = options;
    c->until = tr_run_clock() + options->budget - fmin(REST, MOST * options->budget);
    bool ok = open_case(c, st) && run(c, text, st);
    tr_scene_free(&c->scene);
    free(c->base);
    free(c);
    return ok;
}
