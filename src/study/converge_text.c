/* SPDX-License-Identifier: MIT */
#include "study/converge_text.h"

#include "base/gather.h"
#include "base/version.h"
#include "study/converge_cost.h"
#include "study/converge_errors.h"
#include "base/math.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* "0.7028": as many digits as the error leaves, and one more. */
static const char *digits(double value, double error, char text[32]) {
    double size = floor(tr_log10(fabs(value))), small = floor(tr_log10(error));
    int n = isfinite(size) && isfinite(small) ? (int)fmin(fmax(size - small + 2, 2), 15) : 6;
    snprintf(text, 32, "%.*g", n, value);
    return text;
}

/* "0.0031 (order 2)" */
static void put_verdict(FILE *f, const tr_ladder *of) {
    switch (of->verdict) {
    case TR_VERDICT_NONE:
        fputs("not examined", f);
        break;
    case TR_VERDICT_EXACT:
        fprintf(f, of->half > 0 ? "%.1g (unchanged)" : "0", of->half);
        break;
    case TR_VERDICT_ORDER:
        fprintf(f, "%.2g (order %.2f)", of->half, of->order);
        break;
    case TR_VERDICT_SCATTERED:
        fprintf(f, "%.2g (scattered)", of->half);
        break;
    case TR_VERDICT_NOISE:
        fprintf(f, "< %.2g (no change seen)", of->half);
        break;
    case TR_VERDICT_OPEN:
        fprintf(f, "not converged within the range: %.2g", of->seen);
        if (of->seen_half > 0) fprintf(f, " +- %.2g", of->seen_half);
        fputs(" seen", f);
    }
}

/* "0.703 +- 0.02"; where a cause is not known there is no error in all. */
static void put_total(FILE *f, double total, int unknown) {
    if (unknown && !(total > 0))
        fputs("not known", f);
    else if (unknown)
        fprintf(f, "not known (%.2g without %s)", total, unknown > 1 ? "those causes" : "that cause");
    else
        fprintf(f, "+- %.2g", total);
}

static void put_table(FILE *f, const tr_converge *c) {
    fputs("| number | value | error in all |", f);
    for (int i = 0; i < c->n_ladders; i++) fprintf(f, " %s |", c->ladder[i].cause->name);
    fputs(tr_converge_sampled(c) ? " sample |\n|---|---|---|---|" : "\n|---|---|---|", f);
    for (int i = 0; i < c->n_ladders; i++) fputs("---|", f);
    putc('\n', f);
    for (int q = 0; q < c->n_numbers; q++) {
        int unknown;
        char text[32];
        double value = c->own.value[q][0], total = tr_converge_total(c, q, &unknown);
        if (tr_converge_idle(c, q)) continue;
        fprintf(f, "| %s | %s | ", c->number[q].shown, digits(value, total, text));
        put_total(f, total, unknown);
        fputs(" |", f);
        for (int i = 0; i < c->n_ladders; i++) putc(' ', f), put_verdict(f, &c->ladder[i].of[q]), fputs(" |", f);
        if (tr_converge_sampled(c)) fprintf(f, " %.2g |", c->sample[q].one_half);
        putc('\n', f);
    }
    putc('\n', f);
}

/* The cause with the largest known error; -1: the sample. */
static double largest(const tr_converge *c, int q, int *which) {
    double most = tr_converge_sampled(c) && isfinite(c->sample[q].one_half) ? c->sample[q].one_half : 0;
    *which = -1;
    for (int i = 0; i < c->n_ladders; i++)
        if (c->ladder[i].of[q].half > most) most = c->ladder[i].of[q].half, *which = i;
    return most;
}

/* "a step twice as large costs 0.001 and halves the time" */
static void put_coarser(FILE *f, const tr_converge *c, int q) {
    const tr_converge_ladder *l = NULL;
    for (int i = 0; i < c->n_ladders && !l; i++)
        if (!strcmp(c->ladder[i].cause->name, "step")) l = &c->ladder[i];
    if (!l || !l->own || l->level[l->own - 1].state != TR_LEVEL_DONE) return;
    double costs = tr_converge_error(c, l, q, l->own - 1) - tr_converge_error(c, l, q, l->own);
    double moves = tr_converge_value(c, l, q, l->own - 1) - tr_converge_value(c, l, q, l->own);
    double least = 0.2; /* below, what else the machine does counts more than the run [s] */
    double part = l->level[l->own - 1].seconds / l->level[l->own].seconds;
    if (l->of[q].verdict == TR_VERDICT_NOISE || isnan(costs))
        fprintf(f, "; a step twice as large changes it by %.2g", fabs(moves));
    else
        fprintf(f, "; a step twice as large costs %.2g", fmax(costs, 0));
    if (l->level[l->own].seconds > least && part > 0.4 && part < 0.6)
        fputs(" and halves the time", f);
    else if (l->level[l->own].seconds > least && part < 1)
        fprintf(f, " and takes %.0f %% of the time", 100 * part);
}

static void put_sentence(FILE *f, const tr_converge *c, int q) {
    int unknown, which;
    char text[32];
    double value = c->own.value[q][0], total = tr_converge_total(c, q, &unknown), most = largest(c, q, &which);
    if (!isfinite(value)) {
        fprintf(f, "- Your %s has no value: it did not happen.\n", c->number[q].shown);
        return;
    }
    fprintf(f, "- Your %s is %s", c->number[q].shown, digits(value, total, text));
    if (unknown)
        fputs(total > 0 ? "; its error is not known, but for +- " : "; its error is not known", f);
    else
        fputs(total > 0 ? " +- " : ", without an error that these settings make", f);
    if (total > 0) fprintf(f, "%.2g", total);
    const char *from = which < 0 ? "the sample" : c->ladder[which].cause->words;
    const char *part = most > 0.8 * total ? "nearly all of it" : most > 0.5 * total ? "most of it" : "the largest part";
    if (total > 0 && c->n_ladders + tr_converge_sampled(c) > 1) fprintf(f, ", %s from %s", part, from);
    put_coarser(f, c, q);
    fputs(".\n", f);
    for (int i = 0; i < c->n_ladders; i++) {
        const tr_ladder *of = &c->ladder[i].of[q];
        const char *words = c->ladder[i].cause->words;
        if (of->verdict == TR_VERDICT_ORDER)
            fprintf(f, "  Order %.2f is seen in %s: the value without that error is %s +- %.1g.\n", of->order, words,
                    digits(of->limit, of->unsure, text), of->unsure);
        if (of->verdict == TR_VERDICT_OPEN)
            fprintf(f, "  It has not converged in %s within the range%s: other settings move it by %.2g.\n", words,
                    c->ladder[i].dear ? ", which the budget ended" : "", of->seen);
        if (of->verdict == TR_VERDICT_NONE)
            fprintf(f, "  The error from %s was not examined%s.\n", words,
                    c->ladder[i].dear ? ": the budget is too small" : "");
    }
    if (!tr_converge_sampled(c)) return;
    const tr_sample_error *s = &c->sample[q];
    double aim = c->options->to * fabs(value);
    fprintf(f,
            "  Mean of %d seeds: %s +- %.2g (95 %%). One sample deviates by %.2g. A mean within %.2g takes %d seeds. "
            "Two cases that differ by %.2g are told apart by %d seeds each, with a power of 80 %%.\n",
            s->seeds, digits(s->mean, s->half, text), s->half, s->deviation, aim,
            tr_sample_seeds_for(s->deviation, aim), aim, tr_sample_seeds_to_see(s->deviation, aim));
}

static double setting_of(const tr_converge *c, const tr_cause *cause, int item, double times) {
    double x = cause->own(&c->scene, item) * times;
    return cause->whole ? ceil(x - 1e-9) : x;
}

/* "    step:\n      safety: 0.05"; of a list a line of comment. */
static void put_setting(FILE *f, const tr_converge *c, const tr_cause *cause, double times) {
    const char *dot = strrchr(cause->key, '.'), *last = dot ? dot + 1 : cause->key;
    if (!cause->items) {
        if (dot) fprintf(f, "    %.*s:\n  ", (int)(dot - cause->key), cause->key);
        fprintf(f, "    %s: %.3g\n", last, setting_of(c, cause, 0, times));
        return;
    }
    bool first = true;
    fprintf(f, "    # %s of the items of %.*s:", last, (int)strcspn(cause->key, "."), cause->key);
    for (int i = 0; i < tr_cause_keys(cause, &c->scene); i++) {
        double x = setting_of(c, cause, i, times);
        if (isnan(x)) continue;
        fprintf(f, "%s %.0f", first ? "" : ",", x);
        first = false;
    }
    putc('\n', f);
}

static void put_advice(FILE *f, const tr_converge *c) {
    fprintf(f, "\nFor an error of %.3g %% of each number, %s, set\n\n", 100 * c->options->to,
            tr_converge_sampled(c) ? "half of it of the sample and the other causes with equal shares"
                                   : "each cause with an equal share of it");
    for (int i = 0; i < c->n_ladders; i++) {
        const tr_converge_ladder *l = &c->ladder[i];
        double times = tr_converge_wanted(c, l);
        if (isnan(times))
            fprintf(f, "    # %s: no setting that was tried is known to reach it\n", l->cause->key);
        else
            put_setting(f, c, l->cause, times);
    }
    if (!tr_converge_sampled(c)) return;
    int seeds = tr_converge_wanted_seeds(c);
    if (seeds) fprintf(f, "    # and take the mean of %d seeds\n", seeds);
}

static bool nothing_varies(const tr_converge *c) {
    bool varies = false;
    for (int i = 0; i < c->n_ladders; i++)
        for (int q = 0; q < c->n_numbers; q++) varies |= c->ladder[i].of[q].verdict != TR_VERDICT_EXACT;
    return !varies && !tr_converge_sampled(c);
}

static void put_all(FILE *f, const tr_converge *c) {
    fprintf(f, "# Errors of %s (trundle %s)\n\n", c->options->case_file, TR_VERSION);
    put_table(f, c);
    for (int q = 0; q < c->n_numbers; q++)
        if (!tr_converge_idle(c, q)) put_sentence(f, c, q);
    if (nothing_varies(c))
        fputs("\nNo number changes with any setting that was tried: they are exact, or do not depend on the motion. "
              "Other numbers are named with --of.\n",
              f);
    else
        put_advice(f, c);
    if (c->n_notes) fputs("\nNotes\n\n", f);
    for (int i = 0; i < c->n_notes; i++) fprintf(f, "- %s\n", c->note[i]);
}

static void put_comment(FILE *f, const tr_converge *c) {
    fprintf(f, "# --- What the numbers are good to: trundle converge, version %s. Examined:", TR_VERSION);
    for (int i = 0; i < c->n_ladders; i++) fprintf(f, "%s %s", i ? "," : "", c->ladder[i].cause->name);
    if (tr_converge_sampled(c)) fprintf(f, "%s %d seeds", c->n_ladders ? "," : "", c->n_seeds);
    putc('\n', f);
    bool all_idle = true;
    for (int q = 0; q < c->n_numbers; q++) all_idle = all_idle && tr_converge_idle(c, q);
    if (all_idle) fputs("#   all numbers are 0 at every setting\n", f);
    for (int q = 0; q < c->n_numbers; q++) {
        int unknown;
        char text[32];
        double total = tr_converge_total(c, q, &unknown);
        if (tr_converge_idle(c, q)) continue;
        fprintf(f, "#   %s = %s, error ", c->number[q].shown, digits(c->own.value[q][0], total, text));
        put_total(f, total, unknown);
        for (int i = 0; i < c->n_ladders; i++) {
            fputs(i ? ";\n#       " : c->n_ladders > 1 ? ":\n#       " : ": ", f);
            fprintf(f, "%s ", c->ladder[i].cause->name), put_verdict(f, &c->ladder[i].of[q]);
        }
        if (tr_converge_sampled(c)) fprintf(f, ";\n#       sample %.2g", c->sample[q].one_half);
        putc('\n', f);
    }
    fputs("# --- end of trundle converge\n", f);
}

bool tr_converge_write_text(const tr_converge *c, char **text, tr_status *st) {
    tr_gather all, comment;
    if (!tr_gather_begin(&all, st)) return false;
    put_all(all.stream, c);
    if (!(*text = tr_gather_end(&all, st)) || !tr_gather_begin(&comment, st)) return false;
    put_comment(comment.stream, c);
    char *block = tr_gather_end(&comment, st);
    bool ok = block && tr_file_write(c->options->dir, "converge.md", *text, st) &&
              tr_file_write(c->options->dir, "comment.txt", block, st);
    free(block);
    return ok;
}

char *tr_converge_plan(const tr_converge *c, tr_status *st) {
    tr_gather g;
    double sum = tr_converge_wall(c, c->own.seconds, c->n_seeds);
    if (!tr_gather_begin(&g, st)) return NULL;
    FILE *f = g.stream;
    fprintf(f, "%s: numbers", c->options->case_file);
    for (int q = 0; q < c->n_numbers; q++) fprintf(f, "%s %s", q ? "," : "", c->number[q].shown);
    fprintf(f, "\n\n| cause | key | settings, from coarse to fine | runs | about |\n|---|---|---|---|---|\n");
    fprintf(f, "| the case itself | | | %d | %.2g s |\n", c->n_seeds, sum);
    for (int i = 0; i < c->n_ladders; i++) {
        const tr_converge_ladder *l = &c->ladder[i];
        double cost = 0;
        int runs = 0;
        fprintf(f, "| %s | %s |", l->cause->name, l->cause->key);
        for (int k = 0; k < l->n; k++) {
            if (k == l->own || isnan(l->level[k].setting)) continue;
            fprintf(f, "%s %.4g", runs ? "," : "", l->level[k].setting);
            runs += c->n_seeds, cost += tr_converge_cost(c, l, k);
        }
        fprintf(f, " | %d | %.2g s |\n", runs, cost);
        sum += cost;
    }
    fprintf(f,
            "\nAll of it: %.2g s with %d runs at once, to a factor of three. A ladder stops as soon as its answer is "
            "decided, the cheapest level runs first, and nothing runs after %.3g s (--budget).\n",
            sum, c->options->jobs, c->options->budget);
    return tr_gather_end(&g, st);
}
