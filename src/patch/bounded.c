/* SPDX-License-Identifier: MIT */
#include "patch/bounded.h"
#include "base/alloc.h"
#include "base/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool tr_bounded_new(tr_bounded *o, int n, tr_status *st) {
    size_t m = (size_t)n;
    memset(o, 0, sizeof *o);
    o->n = n;
    return (o->kernel = tr_alloc(2 * m - 1, sizeof(double), st)) &&
           (o->inverse = tr_alloc(m * m, sizeof(double), st)) &&
           (o->factor = tr_alloc(m / 2 * (m / 2), sizeof(double), st)) && (o->side = tr_alloc(m, 1, st)) &&
           (o->set = tr_alloc(m, sizeof(int), st)) && (o->rest = tr_alloc(m, sizeof(double), st)) &&
           (o->image = tr_alloc(m, sizeof(double), st)) && (o->part = tr_alloc(m, sizeof(double), st)) &&
           (o->point = tr_alloc(m, sizeof(double), st));
}

void tr_bounded_free(tr_bounded *o) {
    free(o->kernel), free(o->inverse), free(o->factor), free(o->side);
    free(o->set), free(o->rest), free(o->image), free(o->part), free(o->point);
}

/* ---- matrices as columns: a column of A is a window of the kernel */

typedef struct matrix {
    const double *first;
    ptrdiff_t next;
} matrix;

static matrix matrix_A(const tr_bounded *o) {
    return (matrix){o->kernel + o->n - 1, -1};
}
static matrix matrix_B(const tr_bounded *o) {
    return (matrix){o->inverse, o->n};
}

/* y += sign M z; z belongs to the m columns in set, or to all if set is NULL */
TR_VECTOR static void add_product(matrix M, int n, int m, const int *set, const double *restrict z, double sign,
                                  double *restrict y) {
    for (int k = 0; k < m; k++) {
        const double *restrict column = M.first + (set ? set[k] : k) * M.next;
        double factor = sign * z[k];
        for (int i = 0; i < n; i++) y[i] += factor * column[i];
    }
}

void tr_bounded_add_product(const tr_bounded *o, const double *t, double *y) {
    add_product(matrix_A(o), o->n, o->n, NULL, t, 1, y);
}

/* U'U = M on the set; rows of U one after the other in o->factor. */
TR_VECTOR static bool cholesky(tr_bounded *o, matrix M) {
    int m = o->m;
    for (int k = 0; k < m; k++) {
        double *restrict row = o->factor + (size_t)k * (size_t)m;
        const double *column = M.first + o->set[k] * M.next;
        for (int j = k; j < m; j++) row[j] = column[o->set[j]];
        for (int p = 0; p < k; p++) {
            const double *restrict above = o->factor + (size_t)p * (size_t)m;
            double factor = above[k];
            for (int j = k; j < m; j++) row[j] -= factor * above[j];
        }
        if (!(row[k] > 0)) return false;
        double scale = 1 / sqrt(row[k]);
        for (int j = k; j < m; j++) row[j] *= scale;
    }
    return true;
}

/* z := (U'U)^-1 z */
static void substitute(const tr_bounded *o, double *z) {
    int m = o->m;
    for (int k = 0; k < m; k++) {
        const double *row = o->factor + (size_t)k * (size_t)m;
        z[k] /= row[k];
        for (int j = k + 1; j < m; j++) z[j] -= row[j] * z[k];
    }
    for (int k = m - 1; k >= 0; k--) {
        const double *row = o->factor + (size_t)k * (size_t)m;
        for (int j = k + 1; j < m; j++) z[k] -= row[j] * z[j];
        z[k] /= row[k];
    }
}

/* x: first column of A^-1 by Durbin's recursion; y: work. False if a prediction error is not positive. */
static bool first_column(const double *a, int n, double *x, double *y) {
    double error = a[0];
    x[0] = 1;
    for (int k = 1; k < n; k++) {
        if (!(error > 0)) return false;
        double reflection = 0;
        for (int i = 0; i < k; i++) reflection -= x[i] * a[k - i];
        reflection /= error;
        x[k] = 0;
        for (int i = 0; i <= k; i++) y[i] = x[i] + reflection * x[k - i];
        memcpy(x, y, (size_t)(k + 1) * sizeof *x);
        error *= 1 - reflection * reflection;
    }
    for (int i = 0; i < n; i++) x[i] /= error;
    return error > 0;
}

/* [Golub2013 sec. 4.7] (Trench): B_ij = B_{i-1,j-1} + (x_i x_j - x_{n-i} x_{n-j})/x_0, x the first column. */
bool tr_bounded_matrix(tr_bounded *o, const double *column, tr_status *st) {
    int n = o->n;
    double *x = o->rest, *B = o->inverse;
    for (int k = 0; k < n; k++) o->kernel[n - 1 + k] = o->kernel[n - 1 - k] = column[k];
    o->factored = false;
    if (!first_column(column, n, x, o->part))
        return tr_status_fail(st, TR_NUMERICAL, "error: the influence matrix is not positive definite");
    memcpy(B, x, (size_t)n * sizeof *x);
    for (int i = 1; i < n; i++) {
        double *row = B + (size_t)i * (size_t)n, *above = row - n;
        row[0] = x[i];
        for (int j = 1; j < n; j++) row[j] = above[j - 1] + (x[i] * x[j] - x[n - i] * x[n - j]) / x[0];
    }
    return true;
}

/* ---- one guess */

static bool factor(tr_bounded *o, const signed char *side) {
    size_t n = (size_t)o->n;
    if (o->factored && !memcmp(side, o->side, n)) return true;
    int slipping = 0;
    for (int i = 0; i < o->n; i++) slipping += side[i] != 0;
    memcpy(o->side, side, n);
    o->slip_set = 2 * slipping <= o->n, o->m = 0;
    for (int i = 0; i < o->n; i++)
        if ((side[i] != 0) == o->slip_set) o->set[o->m++] = i;
    return o->factored = cholesky(o, o->slip_set ? matrix_B(o) : matrix_A(o));
}

/* Adds to t where it sticks and to s where it slips, so that A t + s grows by o->rest. */
static void increment(tr_bounded *o, double *t, double *s) {
    int n = o->n;
    double *y = o->image, *grows = o->slip_set ? s : t, *follows = o->slip_set ? t : s;
    memset(y, 0, (size_t)n * sizeof *y);
    if (o->slip_set)
        add_product(matrix_B(o), n, n, NULL, o->rest, 1, y);
    else
        memcpy(y, o->rest, (size_t)n * sizeof *y);
    for (int k = 0; k < o->m; k++) o->part[k] = y[o->set[k]];
    substitute(o, o->part);
    add_product(o->slip_set ? matrix_B(o) : matrix_A(o), n, o->m, o->set, o->part, -1, y);
    for (int k = 0; k < o->m; k++) grows[o->set[k]] += o->part[k], y[o->set[k]] = 0;
    for (int i = 0; i < n; i++) follows[i] += y[i];
}

static double largest(int n, const double *v) {
    double most = 0;
    for (int i = 0; i < n; i++) most = fmax(most, fabs(v[i]));
    return most;
}

/* One problem and its answer so far, as tr_bounded_solve has them. */
typedef struct problem {
    const double *bound, *b;
    signed char *side;
    double *t, *s;
    double slack_t, slack_s; /* a condition on t or on s may be passed by this much */
    double left;             /* the largest |b - A t - s| */
} problem;

/* t and s of a guess. The factors are good to about the condition number times rounding: one or two more passes remove
 * that. */
static void guess(tr_bounded *o, problem *p) {
    enum { PASSES = 3 };
    double scale = largest(o->n, p->b);
    p->left = INFINITY;
    if (!factor(o, p->side)) return;
    for (int i = 0; i < o->n; i++) p->t[i] = p->side[i] * p->bound[i], p->s[i] = 0;
    for (int pass = 0;; pass++) {
        for (int i = 0; i < o->n; i++) o->rest[i] = p->b[i] - p->s[i];
        add_product(matrix_A(o), o->n, o->n, NULL, p->t, -1, o->rest);
        p->left = largest(o->n, o->rest);
        if (pass == PASSES || p->left <= 1e-14 * scale) return;
        increment(o, p->t, p->s);
    }
}

double tr_bounded_slope(tr_bounded *o, double *t, double *s) {
    double sum = 0;
    for (int i = 0; i < o->n; i++) o->rest[i] = 1, t[i] = s[i] = 0;
    increment(o, t, s);
    for (int i = 0; i < o->n; i++) sum += t[i];
    return sum;
}

/* Where an i belongs by its t and s. */
static signed char belongs(const problem *p, int i) {
    double t = p->t[i], s = p->s[i];
    signed char side = p->side[i];
    if (side) return side * s < -p->slack_s ? 0 : side;
    return (signed char)((t > p->bound[i] + p->slack_t) - (t < -p->bound[i] - p->slack_t));
}

/* Moves every i that breaks a condition. False when that no longer helps. */
static bool blocks(tr_bounded *o, problem *p) {
    enum { PATIENCE = 4 };
    for (int fewest = o->n + 1, patience = PATIENCE; patience > 0;) {
        int moved = 0;
        guess(o, p);
        for (int i = 0; i < o->n; i++) {
            signed char to = belongs(p, i);
            moved += to != p->side[i], p->side[i] = to;
        }
        if (!moved) return true;
        if (moved < fewest)
            fewest = moved, patience = PATIENCE;
        else
            patience--;
    }
    return false;
}

/* From a point within the bounds straight towards the answer of its guess: to the first bound in the way, which then
 * holds, or the whole way, and then the worst of the slips against traction is released. */
static bool descend(tr_bounded *o, problem *p) {
    const double *bound = p->bound, *t = p->t, *s = p->s;
    signed char *side = p->side;
    double *point = o->point;
    for (int i = 0; i < o->n; i++) {
        point[i] = fmin(fmax(t[i], -bound[i]), bound[i]);
        if (!side[i]) side[i] = (signed char)((t[i] >= bound[i]) - (t[i] <= -bound[i]));
        if (side[i]) point[i] = side[i] * bound[i];
    }
    for (int round = 0; round < 20 * o->n + 100; round++) {
        int met = -1, worst = -1;
        double way = 1;
        guess(o, p);
        for (int i = 0; i < o->n; i++) {
            signed char to = belongs(p, i);
            if (to == side[i]) continue;
            double until = side[i] ? 1 : (to * bound[i] - point[i]) / (t[i] - point[i]);
            if (until < way) met = i, way = until;
            if (side[i] && (worst < 0 || side[i] * s[i] < side[worst] * s[worst])) worst = i;
        }
        for (int i = 0; i < o->n; i++) point[i] += way * (t[i] - point[i]);
        if (met >= 0)
            side[met] = t[met] > 0 ? 1 : -1, point[met] = side[met] * bound[met];
        else if (worst >= 0)
            side[worst] = 0;
        else
            return true;
    }
    return false;
}

bool tr_bounded_solve(tr_bounded *o, const double *bound, const double *b, signed char *side, double *t, double *s,
                      tr_status *st) {
    double b_max = largest(o->n, b);
    problem p = {bound, b, side, t, s, 1e-13 * largest(o->n, bound), 1e-13 * b_max, INFINITY};
    bool found = blocks(o, &p) || descend(o, &p);
    if (found && p.left <= 1e-12 * b_max) return true;
    return tr_status_fail(st, TR_NUMERICAL, "error: %s for %d elements in contact, residual %.1e of %.1e",
                          found ? "inexact tractions" : "no tractions", o->n, p.left, b_max);
}
