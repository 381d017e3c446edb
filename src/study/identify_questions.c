/* SPDX-License-Identifier: MIT */
#include "study/identify_questions.h"

#include "base/alloc.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const tr_question questions[TR_ASKS] = {
    [TR_ASK_V_R] = {"V_r", false, TR_CELL_V_R, TR_FAMILY_ROLLING, 1, .moment = false},
    [TR_ASK_M1] = {"M1", false, TR_CELL_M1, TR_FAMILY_ROLLING, -1, .moment = true},
    [TR_ASK_M2] = {"M2", false, TR_CELL_M2, TR_FAMILY_ROLLING, 1, .moment = true},
    [TR_ASK_CAP1] = {"cap 1", false, TR_CELL_M1, TR_FAMILY_CAP, 1, .length = true},
    [TR_ASK_CAP2] = {"cap 2", false, TR_CELL_M2, TR_FAMILY_CAP, 1, .length = true},
    [TR_ASK_V_S] = {"V_s", false, TR_CELL_V_S, TR_FAMILY_SLIDING, 1, .moment = false},
    [TR_ASK_F_T] = {"F_t", false, TR_CELL_F_T, TR_FAMILY_SLIDING, 1, .moment = false},
    [TR_ASK_ARM1] = {"arm 1", false, TR_CELL_T1, TR_FAMILY_ARM_1, 1, .length = true},
    [TR_ASK_ARM2] = {"arm 2", false, TR_CELL_T2, TR_FAMILY_ARM_2, 1, .length = true},
};

static double or_else(double v, double other) {
    return isnan(v) ? other : v;
}

/* What the moments of a row are of. */
typedef enum experiment { ROLLING_SPRING, ROLLING_BOUND, FRICTION, NEITHER, BOTH } experiment;

/* The bound of a spring that would be k_roll R V time by now is mu_r F_n R; which is less, holds. */
static experiment experiment_of(const tr_identify_table *t, const tr_identify_row *r, const tr_motion_measures *m) {
    double k = r->cell[TR_CELL_K_ROLL], mu = r->cell[TR_CELL_MU_R], F_n = r->cell[TR_CELL_F_N];
    bool spring = t->is_there[TR_CELL_K_ROLL] ? k > 0 : isnan(r->cell[TR_CELL_F_T]) && !(mu > 0);
    bool bound = mu > 0;
    if (!spring && !bound) return isnan(r->cell[TR_CELL_F_T]) ? NEITHER : FRICTION;
    if (!bound) return ROLLING_SPRING;
    if (!spring) return ROLLING_BOUND;
    double trial = k * or_else(r->cell[TR_CELL_TIME], 1) * fmax(fabs(m->s1), fabs(m->s2)), limit = mu * F_n;
    if (isnan(limit)) return ROLLING_SPRING; /* without F_n there is nothing to compare */
    return trial < 0.02 * limit ? ROLLING_SPRING : trial > 50 * limit ? ROLLING_BOUND : BOTH;
}

typedef struct maker {
    const tr_identify_table *table;
    const tr_motion_measures *measures;
    tr_questions *q;
    long undecided; /* line of a row whose spring and bound are alike; 0: none */
} maker;

static void add(maker *m, int which, int row, double y) {
    bool wall = isinf(m->table->row[row].motion.R1);
    tr_question *q = &m->q->of[which + (wall ? TR_ASKS : 0)];
    if (isnan(y)) return;
    q->row[q->n] = row, q->y[q->n++] = y;
    q->scale = fmax(q->scale, fabs(y));
}

static void add_moments(maker *m, int i) {
    const tr_identify_row *r = &m->table->row[i];
    const double *c = r->cell, M[2] = {c[TR_CELL_M1], c[TR_CELL_M2]};
    double per = or_else(c[TR_CELL_K_ROLL], 1) * or_else(c[TR_CELL_TIME], 1), bound = c[TR_CELL_MU_R] * c[TR_CELL_F_N];
    if (isnan(M[0]) && isnan(M[1])) return;
    experiment e = experiment_of(m->table, r, &m->measures[i]);
    if (e == BOTH && !m->undecided) m->undecided = r->line;
    for (int k = 0; k < 2; k++) {
        if (e == ROLLING_SPRING) add(m, TR_ASK_M1 + k, i, M[k] / per);
        if (e == ROLLING_BOUND && bound > 0 && M[k] != 0) add(m, TR_ASK_CAP1 + k, i, fabs(M[k]) / bound);
        if (e == FRICTION && isnan(c[TR_CELL_T1 + k]) && c[TR_CELL_F_T] != 0)
            add(m, TR_ASK_ARM1 + k, i, -M[k] / c[TR_CELL_F_T]);
    }
    if ((e != ROLLING_SPRING && e != ROLLING_BOUND) || isnan(M[0] + M[1]) || isinf(r->motion.R1)) return;
    m->q->moment = fmax(m->q->moment, fmax(fabs(M[0]), fabs(M[1])) / per);
    if (fabs(M[0] + M[1]) / per > m->q->sum) m->q->sum = fabs(M[0] + M[1]) / per, m->q->sum_line = r->line;
}

static void add_row(maker *m, int i) {
    const tr_identify_row *r = &m->table->row[i];
    const double *c = r->cell;
    double k_t = or_else(c[TR_CELL_K_T], 1), time = or_else(c[TR_CELL_TIME], 1);
    add(m, TR_ASK_V_R, i, c[TR_CELL_V_R]);
    add(m, TR_ASK_V_S, i, c[TR_CELL_V_S]);
    add(m, TR_ASK_CAP1, i, c[TR_CELL_CAP]);
    if (k_t > 0) add(m, TR_ASK_F_T, i, c[TR_CELL_F_T] / (k_t * time));
    for (int k = 0; k < 2; k++) {
        add(m, TR_ASK_ARM1 + k, i, c[TR_CELL_ARM1 + k]);
        if (c[TR_CELL_F_T] != 0) add(m, TR_ASK_ARM1 + k, i, -c[TR_CELL_T1 + k] / c[TR_CELL_F_T]);
    }
    add_moments(m, i);
}

/* An arm is a quotient: of forces that are nearly 0 it is noise. Caps too: of rows that do not roll. Neither is
 * small beside the radii: 1e-4 of the smaller one is below all levers, and above what such rows leave. */
static void drop_small(tr_question *q, const tr_identify_table *t) {
    double most = 0;
    int kept = 0;
    if (!q->length) return;
    for (int k = 0; k < q->n; k++) {
        double F_t = fabs(t->row[q->row[k]].cell[TR_CELL_F_T]);
        most = fmax(most, isnan(F_t) ? 0 : F_t);
    }
    q->scale = 0;
    for (int k = 0; k < q->n; k++) {
        const tr_motion *m = &t->row[q->row[k]].motion;
        if (fabs(t->row[q->row[k]].cell[TR_CELL_F_T]) < 1e-5 * most) continue;
        if (fabs(q->y[k]) < 1e-4 * fmin(m->R1, m->R2)) continue;
        q->row[kept] = q->row[k], q->y[kept++] = q->y[k];
        q->scale = fmax(q->scale, fabs(q->y[k]));
    }
    q->n = kept;
}

/* Of a velocity or a moment. */
static bool check_varies(const tr_question *q, const tr_identify_table *t, tr_status *st) {
    bool same = q->n > 1;
    if (!q->n || q->length) return true;
    for (int k = 1; k < q->n; k++) same = same && q->y[k] == q->y[0];
    if (q->scale > 0 && !same) return true;
    if (q->scale > 0 && q->n == 1) return true;
    return tr_status_fail(st, TR_BAD_CASE,
                          "%s:%ld: error: column %s is %s in %s (lines %ld to %ld), so nothing can be told; add rows "
                          "that roll and slide, as "
                          "of trundle measures --card: bodies of unequal radii, with overlap, spins and a velocity of "
                          "2 across the line of "
                          "centres",
                          t->path, t->row[q->row[0]].line, tr_identify_name(t, q->cell),
                          q->scale > 0 ? "the same number" : "0", q->n == 1 ? "its only row" : "all its rows",
                          t->row[q->row[0]].line, t->row[q->row[q->n - 1]].line);
}

static bool make_room(tr_questions *q, int n, tr_status *st) {
    for (int k = 0; k < TR_QUESTIONS; k++) {
        q->of[k] = questions[k % TR_ASKS];
        if (k >= TR_ASKS) q->of[k].wall = true, strcat(q->of[k].name, " at wall");
        q->of[k].row = tr_alloc(2 * (size_t)n, sizeof *q->of[k].row, st);
        q->of[k].y = tr_alloc(2 * (size_t)n, sizeof *q->of[k].y, st);
        if (!q->of[k].row || !q->of[k].y) return false;
    }
    return true;
}

bool tr_questions_make(tr_questions *q, const tr_identify_table *t, tr_status *st) {
    *q = (tr_questions){.sum = 0};
    tr_motion_measures *measures = tr_alloc((size_t)t->n, sizeof *measures, st);
    tr_motion *motion = tr_alloc((size_t)t->n, sizeof *motion, st);
    bool ok = measures && motion && make_room(q, t->n, st);
    for (int i = 0; ok && i < t->n; i++) motion[i] = t->row[i].motion;
    ok = ok && tr_measures_motions(motion, t->n, measures, st);
    maker m = {t, measures, q, 0};
    for (int i = 0; ok && i < t->n; i++) add_row(&m, i);
    free(measures), free(motion);
    if (ok && m.undecided)
        ok = tr_status_fail(
            st, TR_BAD_CASE,
            "%s:%ld: error: the spring (k_roll, time) and its bound (mu_r, F_n) are alike here, so M1, M2 "
            "may be of either; make one fifty times the other, or leave mu_r or k_roll empty",
            t->path, m.undecided);
    bool any = false;
    for (int k = 0; ok && k < TR_QUESTIONS; k++) {
        drop_small(&q->of[k], t);
        any |= q->of[k].n > 0;
        ok = check_varies(&q->of[k], t, st);
    }
    if (ok && !any)
        ok = tr_status_fail(
            st, TR_BAD_CASE,
            "%s:%ld: error: no row has an answer that can be explained: M1, M2 need k_roll above 0 or mu_r "
            "with F_n, T1, T2 and arms need F_t",
            t->path, t->row[0].line);
    return ok;
}

void tr_questions_free(tr_questions *q) {
    for (int k = 0; k < TR_QUESTIONS; k++) free(q->of[k].row), free(q->of[k].y);
    *q = (tr_questions){.sum = 0};
}
