/* SPDX-License-Identifier: MIT */
#include "study/converge_errors.h"

#include "base/student.h"
#include "base/math.h"
#include <math.h>

double tr_converge_value(const tr_converge *c, const tr_converge_ladder *l, int q, int level) {
    const tr_converge_level *at = &l->level[level];
    if (at->state != TR_LEVEL_DONE) return NAN;
    return tr_converge_sampled(c) ? tr_mean_of(at->value[q], c->n_seeds).mean : at->value[q][0];
}

double tr_converge_error(const tr_converge *c, const tr_converge_ladder *l, int q, int level) {
    const tr_ladder *of = &l->of[q];
    if (level == l->own) return of->half;
    bool known = of->verdict == TR_VERDICT_EXACT || of->verdict == TR_VERDICT_ORDER ||
                 of->verdict == TR_VERDICT_SCATTERED || of->verdict == TR_VERDICT_NOISE;
    return known ? fabs(tr_converge_value(c, l, q, level) - of->limit) + of->unsure : NAN;
}

double tr_converge_total(const tr_converge *c, int q, int *unknown) {
    double sum = 0, noise = 0;
    *unknown = 0;
    for (int i = 0; i < c->n_ladders; i++) {
        const tr_ladder *of = &c->ladder[i].of[q];
        *unknown += isnan(of->half);
        if (of->verdict == TR_VERDICT_NOISE)
            noise = tr_hypot(noise, of->half);
        else if (!isnan(of->half))
            sum += of->half;
    }
    if (!tr_converge_sampled(c)) return sum;
    double half = c->sample[q].one_half;
    *unknown += isnan(half);
    return sum + (isnan(half) ? noise : tr_hypot(noise, half));
}

/* Of what is asked of a number, for one cause. Of a sample the seeds get half. */
static double share(const tr_converge *c, int q) {
    double asked = c->options->to * fabs(c->own.value[q][0]);
    return asked / (tr_converge_sampled(c) ? 2 : 1) / c->n_ladders;
}

/* Of one number. */
static double wanted(const tr_converge *c, const tr_converge_ladder *l, int q) {
    const tr_ladder *of = &l->of[q];
    for (int k = 0; k < l->n; k++)
        if (tr_converge_error(c, l, q, k) <= share(c, q)) return tr_pow(l->cause->finer, k - l->own);
    if (of->verdict != TR_VERDICT_ORDER || !(of->half > 0)) return NAN;
    double times = tr_pow(share(c, q) / of->half, 1 / of->order); /* of the length h */
    return l->cause->finer < 1 ? times : 1 / times;
}

double tr_converge_wanted(const tr_converge *c, const tr_converge_ladder *l) {
    double all = NAN;
    for (int q = 0; q < c->n_numbers; q++) {
        if (tr_converge_idle(c, q) || !isfinite(c->own.value[q][0])) continue;
        double one = wanted(c, l, q);
        if (isnan(one)) return NAN;
        if (isnan(all) || (l->cause->finer < 1 ? one < all : one > all)) all = one;
    }
    return all;
}

int tr_converge_wanted_seeds(const tr_converge *c) {
    int most = 0;
    for (int q = 0; q < c->n_numbers; q++) {
        double s = c->sample[q].deviation, half = 0.5 * c->options->to * fabs(c->own.value[q][0]);
        if (!isfinite(s) || !(half > 0)) return 0;
        int n = tr_sample_seeds_for(s, half);
        if (n > most) most = n;
    }
    return most;
}

bool tr_converge_front(const tr_converge *c, const tr_converge_ladder *l, int q, int level) {
    double error = tr_converge_error(c, l, q, level), seconds = l->level[level].seconds;
    if (isnan(error)) return false;
    for (int k = 0; k < l->n; k++)
        if (l->level[k].state == TR_LEVEL_DONE && l->level[k].seconds < seconds &&
            tr_converge_error(c, l, q, k) <= error)
            return false;
    return true;
}

bool tr_converge_idle(const tr_converge *c, int q) {
    if (!c->number[q].usual || c->own.value[q][0] != 0) return false;
    for (int i = 0; i < c->n_ladders; i++)
        if (c->ladder[i].of[q].verdict != TR_VERDICT_EXACT) return false;
    return true;
}
