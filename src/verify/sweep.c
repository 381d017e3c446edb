/* SPDX-License-Identifier: MIT */
#include "verify/sweep.h"

#include "base/quantile.h"
#include <math.h>
#include <stdio.h>
#include <time.h>

enum { MOST_REPEATS = 15 };

typedef struct cell {
    tr_sweep_result result;
    double seconds[MOST_REPEATS];
} cell;

double tr_sweep_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double tr_sweep_median(double *values, int n) {
    tr_sort(values, n);
    return tr_quantile(values, n, 0.5);
}

static double slope(const cell *c, int n, double floor) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    int used = 0;
    for (int k = 0; k < n; k++) {
        double x = log(c[k].result.step), y = log(c[k].result.error);
        if (!(c[k].result.error > floor && c[k].result.error < 0.05)) continue;
        sx += x, sy += y, sxx += x * x, sxy += x * y, used++;
    }
    return used > 1 ? (used * sxy - sx * sy) / (used * sxx - sx * sx) : NAN;
}

/* The largest step with errors below 1e-3 for it and all smaller steps; between two steps by a straight line in
 * logarithms. */
static void describe(const cell *c, const tr_sweep *s, char *text, size_t size) {
    int k = s->steps;
    while (k > 0 && c[k - 1].result.error < 1e-3) k--;
    if (k == s->steps) {
        snprintf(text, size, "1e-3 not reached");
    } else if (k == 0) {
        snprintf(text, size, "below 1e-3 at every step, up to %.2g of the default",
                 c[0].result.step / c[s->usual].result.step);
    } else {
        const cell *p = &c[k - 1], *q = &c[k];
        double part = log(p->result.error / 1e-3) / log(p->result.error / q->result.error);
        double step = p->result.step * pow(q->result.step / p->result.step, part);
        double time = p->seconds[s->repeats / 2] * pow(q->seconds[s->repeats / 2] / p->seconds[s->repeats / 2], part);
        snprintf(text, size, "1e-3 at %.3g, %.2g of the default, in %.2g s", step, step / c[s->usual].result.step,
                 time);
    }
}

static bool add_rows(tr_verify *v, const tr_sweep *s, int m, const cell *c, tr_status *st) {
    const tr_sweep_method *method = &s->method[m];
    char name[80], text[160];
    describe(c, s, text, sizeof text);
    double order = slope(c, s->steps, s->floor > 0 ? s->floor : 1e-7);
    if (m == 0) {
        snprintf(name, sizeof name, "%s: error at the default step", method->name);
        if (!tr_verify_add(v,
                           &(tr_verify_row){.quantity = name,
                                            .unit = "1",
                                            .computed = c[s->usual].result.error,
                                            .tolerance = s->goal,
                                            .reason = s->reason,
                                            .order = order,
                                            .outcome = text},
                           st))
            return false;
    }
    if (isnan(method->order)) return true;
    snprintf(name, sizeof name, "%s: order", method->name);
    return tr_verify_add(v,
                         &(tr_verify_row){.quantity = name,
                                          .unit = "1",
                                          .reference = method->order,
                                          .computed = order,
                                          .tolerance = method->tolerance,
                                          .reason = method->reason,
                                          .order = NAN,
                                          .outcome = m ? text : NULL},
                         st);
}

static bool add_points(tr_verify *v, const tr_sweep *s, int m, cell *c, tr_status *st) {
    for (int k = 0; k < s->steps; k++) {
        double *t = c[k].seconds;
        tr_sort(t, s->repeats);
        if (!tr_verify_point_add(v,
                                 &(tr_verify_point){.series = s->method[m].name,
                                                    .step_name = s->step_name,
                                                    .step = c[k].result.step,
                                                    .error = c[k].result.error,
                                                    .seconds = tr_quantile(t, s->repeats, 0.5),
                                                    .low = tr_quantile(t, s->repeats, 0.25),
                                                    .high = tr_quantile(t, s->repeats, 0.75),
                                                    .usual = k == s->usual},
                                 st))
            return false;
    }
    return true;
}

bool tr_sweep_add(tr_verify *v, const tr_sweep *sweep, tr_status *st) {
    tr_sweep own = *sweep, *s = &own;
    if (v->brief) own.repeats = 1;
    cell c[TR_SWEEP_METHODS][TR_SWEEP_STEPS];
    for (int r = 0; r < s->repeats; r++)
        for (int k = 0; k < s->steps; k++)
            for (int m = 0; m < s->methods; m++) {
                if (!tr_verify_go_on(v, st) || !s->run(s->context, m, k, &c[m][k].result, st)) return false;
                c[m][k].seconds[r] = c[m][k].result.seconds;
            }
    for (int m = 0; m < s->methods; m++)
        if (!add_points(v, s, m, c[m], st) || !add_rows(v, s, m, c[m], st)) return false;
    return true;
}
