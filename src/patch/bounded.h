/* SPDX-License-Identifier: MIT */
/* The bound-constrained convex quadratic problem of a contact with dry friction [Kalker1990 ch. 4]:
 *
 *   min 1/2 t'A t - t'b,  |t_i| <= g_i;   s = b - A t   (A symmetric Toeplitz, positive definite)
 *
 * Its conditions are the law of friction: s_i = 0 where |t_i| < g_i, s_i of the sign of t_i where |t_i| = g_i. The
 * answer is unique.
 *
 * Block principal pivoting [Judice1994]: guess which i stick (s = 0) and which slip (t = +-g), solve, move every i that
 * breaks a condition, repeat, from the sets of the last answer: a few guesses for a contact. Blocks can cycle: when
 * several moves in a row have not lowered the number of breaches, the active-set method [Nocedal2006 sec. 16.5] takes
 * over, one i at a time. It lowers the function at every step, so no set comes twice.
 *
 * The linear equations of one guess are solved by Cholesky's method on the smaller of the two sets: on the stick set in
 * A; on the slip set in B = A^-1, with the roles of t and s exchanged (t = B b - B s). B is written down in n^2
 * operations [Golub2013 sec. 4.7]. Both ways end with steps of refinement by A itself. */
#ifndef TR_PATCH_BOUNDED_H
#define TR_PATCH_BOUNDED_H

#include "base/status.h"

typedef struct tr_bounded {
    int n;
    double *kernel;    /* A_ij = kernel[n - 1 + i - j], 2n - 1 numbers */
    double *inverse;   /* B, n x n */
    signed char *side; /* of the sets in `factor`: 0 stick, +-1 slip */
    double *factor;    /* upper triangle, m x m, m <= n/2, of the set `set` */
    int *set, m;
    bool slip_set, factored;
    double *rest, *image, *part, *point; /* work, n each */
} tr_bounded;

bool tr_bounded_new(tr_bounded *o, int n, tr_status *st);
void tr_bounded_free(tr_bounded *o);

/* Sets A from its first column, n numbers. False if A is not positive definite. */
bool tr_bounded_matrix(tr_bounded *o, const double *column, tr_status *st);

/* side: first guess and result, n. t and s: n. On return |t_i| = g_i exactly where side, s_i = 0 exactly elsewhere, and
 * |b - A t - s| <= 1e-12 max |b|, else TR_NUMERICAL with that residual. t and s may pass their conditions by 1e-13 of
 * max g and max |b|. */
bool tr_bounded_solve(tr_bounded *o, const double *bound, const double *b, signed char *side, double *t, double *s,
                      tr_status *st);

/* Sum of dt_i/db, b rising by the same amount for all i, the sets as in the last answer. t: work, n. */
double tr_bounded_slope(tr_bounded *o, double *t, double *s);

/* y += A t */
void tr_bounded_add_product(const tr_bounded *o, const double *t, double *y);

#endif
