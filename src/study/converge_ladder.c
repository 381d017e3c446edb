/* SPDX-License-Identifier: MIT */
#include "study/converge_ladder.h"

#include "base/student.h"
#include "base/math.h"
#include <math.h>

/* Of a run of 1e6 steps, each with an error of 1e-16. */
static const double ROUNDING = 1e-10;
/* Orders that agree: the next term of the error, of an order more, changes p by less once h is some tenth of its
 * range. */
static const double AGREE = 0.3;
static const double LEAST_ORDER = 0.4, LARGEST_ORDER = 8;

static double change(const double *v, int from, int to) {
    double most = 0;
    for (int i = from; i <= to; i++)
        for (int k = i + 1; k <= to; k++) most = fmax(most, fabs(v[k] - v[i]));
    return most;
}

/* p of three neighbours; NaN: they do not go one way, ever less. */
static double order_of(const double *v, double r) {
    double ratio = (v[1] - v[0]) / (v[2] - v[1]), p = ratio > 1 && isfinite(ratio) ? tr_log(ratio) / tr_log(r) : NAN;
    return p >= LEAST_ORDER && p <= LARGEST_ORDER ? p : NAN;
}

static double richardson(const double *v, double p, double r) {
    return v[2] + (v[2] - v[1]) / (tr_pow(r, p) - 1);
}

/* v: levels first ... last without a gap. */
static bool find_order(tr_ladder *l, const double *v, int last, double r) {
    double p[3], low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 3; i++) {
        p[i] = order_of(v + last - 4 + i, r);
        if (isnan(p[i])) return false;
        low = fmin(low, p[i]), high = fmax(high, p[i]);
    }
    if (high - low > AGREE) return false;
    double before = richardson(v + last - 3, p[1], r);
    l->verdict = TR_VERDICT_ORDER, l->order = p[2];
    l->limit = richardson(v + last - 2, p[2], r);
    l->unsure = fabs(l->limit - before);
    return true;
}

/* D_k: the largest change to the next two levels. Least squares of ln D over the level. */
static bool find_scatter(tr_ladder *l, const double *v, int first, int last, double r) {
    enum { LEAST = 3 };
    static const double SLOWEST = 0.6; /* a drift without an end, as ln k, falls slower than that from five levels on */
    static const double TAKEN = 0.75;  /* at most, or a third: a slope of few levels may be steep by chance */
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, top = 0;
    for (int k = first; k < last - 1; k++) {
        double D = tr_log(change(v, k, k + 2)) / tr_log(r);
        if (!isfinite(D)) return false;
        n++, x += k, y += D, xx += (double)k * k, xy += k * D;
    }
    double q = -(n * xy - x * y) / (n * xx - x * x);
    if (n < LEAST || !(q >= SLOWEST)) return false;
    q = fmax(fmin(q, TAKEN), q / 3);
    for (int k = first; k < last - 1; k++) top = fmax(top, change(v, k, k + 2) * tr_pow(r, q * (k - last)));
    l->verdict = TR_VERDICT_SCATTERED;
    l->limit = v[last], l->unsure = 3 * top;
    return true;
}

tr_ladder tr_ladder_of(const double *value, int n, int own, double r, double scale) {
    tr_ladder l = {.limit = NAN, .unsure = NAN, .order = NAN, .half = NAN, .seen = NAN};
    int first = own, last = own;
    while (first > 0 && isfinite(value[first - 1])) first--;
    while (last < n - 1 && isfinite(value[last + 1])) last++;
    if (isnan(value[own]) || (last == own && last - first < 4)) return l;
    l.seen = last == own ? fabs(value[own] - value[own - 1]) : 0;
    for (int k = own + 1; k <= last; k++) l.seen = fmax(l.seen, fabs(value[k] - value[own]));
    double all = change(value, first, last);
    if (all <= ROUNDING * scale) {
        l.verdict = TR_VERDICT_EXACT, l.limit = value[last], l.unsure = 2 * all;
        l.half = l.unsure;
        return l;
    }
    l.verdict = TR_VERDICT_OPEN;
    bool found = last - first >= 4 && find_order(&l, value, last, r);
    if (found || find_scatter(&l, value, first, last, r)) l.half = fabs(value[own] - l.limit) + l.unsure;
    return l;
}

/* ---- samples ---- */

typedef struct difference {
    int n;
    double mean, half; /* half of the 95 % interval; NaN: fewer than two */
} difference;

/* Of level b from level a. Without pairs the smaller number of seeds gives the degrees of freedom: never too few. */
static difference difference_of(const double *a, const double *b, int seeds, bool paired) {
    double x[64];
    if (paired) {
        for (int s = 0; s < seeds; s++) x[s] = b[s] - a[s];
        tr_mean m = tr_mean_of(x, seeds);
        return (difference){m.n, m.mean, m.high - m.mean};
    }
    tr_mean p = tr_mean_of(a, seeds), q = tr_mean_of(b, seeds);
    int n = p.n < q.n ? p.n : q.n;
    double error = tr_hypot(p.error, q.error);
    return (difference){n, q.mean - p.mean, n > 1 ? tr_student_95(n - 1) * error : NAN};
}

static bool is_seen(const difference *d) {
    return fabs(d->mean) > d->half;
}

tr_ladder tr_ladder_of_samples(const double *value, int n, int stride, int seeds, int own, double r, bool paired) {
    tr_ladder l = {.limit = NAN, .unsure = NAN, .order = NAN, .half = NAN, .seen = NAN};
    double mean[TR_LADDER_LEVELS], widest = 0;
    bool noise = true, none = true;
    int last = own;
    for (int k = 0; k < n; k++) mean[k] = tr_mean_of(value + k * stride, seeds).mean;
    for (int k = own + 1; k < n && isfinite(mean[k]); k++) {
        difference d = difference_of(value + own * stride, value + k * stride, seeds, paired);
        if (isnan(d.half)) break;
        if (none || fabs(d.mean) > l.seen) l.seen = fabs(d.mean), l.seen_half = d.half;
        noise = noise && !is_seen(&d), none = false, last = k;
        widest = fmax(widest, fabs(d.mean) + d.half);
    }
    if (none) return l;
    l.verdict = !noise ? TR_VERDICT_OPEN : widest > 0 ? TR_VERDICT_NOISE : TR_VERDICT_EXACT;
    if (noise) l.half = widest, l.limit = mean[own], l.unsure = widest;
    if (noise || last < 3) return l;
    for (int k = last - 2; k <= last; k++) {
        difference d = difference_of(value + (k - 1) * stride, value + k * stride, seeds, paired);
        if (!isfinite(mean[k - 1]) || !is_seen(&d)) return l;
    }
    double p = order_of(mean + last - 2, r), before = order_of(mean + last - 3, r);
    if (isnan(p) || isnan(before) || fabs(p - before) > AGREE) return l;
    difference d = difference_of(value + own * stride, value + last * stride, seeds, paired);
    l.verdict = TR_VERDICT_ORDER, l.order = p;
    l.limit = richardson(mean + last - 2, p, r);
    l.unsure = fabs(l.limit - richardson(mean + last - 3, before, r)) + d.half;
    l.half = fabs(mean[own] - l.limit) + l.unsure;
    return l;
}

/* Each seed against the mean of the others: of normal samples that distance, over its standard error, has Student's
 * t. Divided by the number of seeds, 1 % of all normal sets have one. */
static void find_outlier(tr_sample_error *e, const double *x, int seeds) {
    enum { LEAST = 5 };
    static const double FALSE = 0.01;
    if (e->seeds < LEAST) return;
    for (int i = 0; i < seeds; i++) {
        double others[64];
        for (int s = 0; s < seeds; s++) others[s] = s == i ? NAN : x[s];
        tr_mean m = tr_mean_of(others, seeds);
        double off = fabs(x[i] - m.mean) / (m.error * sqrt(m.n + 1));
        if (off > tr_student_t(m.n - 1, 1 - FALSE / e->seeds) && off > e->off) e->outlier = i, e->off = off;
    }
}

tr_sample_error tr_sample_error_of(const double *x, int seeds) {
    tr_mean all = tr_mean_of(x, seeds), others = tr_mean_of(x + 1, seeds - 1);
    tr_sample_error e = {.seeds = all.n, .mean = all.mean, .half = all.high - all.mean, .outlier = -1};
    e.deviation = others.error * sqrt(others.n); /* that of the case is not among them, so x[0]/s has Student's t */
    e.one_half = others.n > 1 ? tr_student_95(others.n - 1) * e.deviation : NAN;
    find_outlier(&e, x, seeds);
    return e;
}

int tr_sample_seeds_for(double deviation, double half) {
    for (int n = 2; n < 1000; n++)
        if (tr_student_95(n - 1) * deviation <= half * sqrt(n)) return n;
    return (int)ceil(fmin(1.96 * 1.96 * deviation * deviation / (half * half), 1e9));
}

int tr_sample_seeds_to_see(double deviation, double difference) {
    double z = 1.959964 + 0.841621, ratio = deviation / difference; /* normal quantiles of 97.5 % and of 80 % */
    return (int)ceil(fmin(2 * z * z * ratio * ratio + 1, 1e9));     /* + 1: Student's t instead of them, to a quarter */
}
