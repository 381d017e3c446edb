/* SPDX-License-Identifier: MIT */
#include "study/identify_fit.h"

#include "base/alloc.h"
#include "base/random.h"
#include "base/math.h"
#include <math.h>
#include <stdlib.h>

static const double FITS = 1e-3;  /* answers of three digits and more; forms differ by the overlap, 1e-3 and more */
static const double SAME = 1e-9;  /* on the probes, which are exact to 1e-13 */
static const double TIE = 10;     /* times the error of the best */
static const double NOISE = 1e-8; /* a difference that rounding of the file may make: digits of a few places */

/* ---- probes */

enum { GEOMETRIES = 16, MOTIONS = 4 };

static double in(tr_random *r, double low, double high) {
    return low + (high - low) * tr_random_uniform(r);
}

static tr_motion probe(tr_random *r, const tr_motion *place) {
    tr_motion m = *place;
    m.v1x = in(r, -1, 1) * m.R2, m.v1y = in(r, -1, 1) * m.R2, m.w1 = isinf(m.R1) ? 0 : in(r, -1, 1);
    m.v2x = in(r, -1, 1) * m.R2, m.v2y = in(r, -1, 1) * m.R2, m.w2 = in(r, -1, 1);
    return m;
}

/* Numbers of few digits: one of them may be printed as a row to add. */
static tr_motion place_of(int k, bool wall) {
    static const double radii[][2] = {{0.01, 0.02}, {0.03, 0.01}, {0.01, 0.08}, {0.01, 0.01}},
                        parts[] = {0.05, 0.01, 0.1, 0.03};
    double R1 = radii[k % 4][0], R2 = radii[k % 4][1], L = (wall ? R2 : R1 + R2) * (1 - parts[k / 4 % 4]);
    tr_motion m = {.R1 = wall ? INFINITY : R1, .R2 = R2, .x1x = 0.02, .x1y = -0.01};
    m.x2x = m.x1x + 0.6 * L, m.x2y = m.x1y + 0.8 * L;
    return m;
}

static tr_motion seen_moving(tr_motion m, double W) {
    m.v1x += 0.03 - W * m.x1y, m.v1y += -0.02 + W * m.x1x, m.w1 += W;
    m.v2x += 0.03 - W * m.x2y, m.v2y += -0.02 + W * m.x2x, m.w2 += W;
    return m;
}

bool tr_probes_make(tr_probes *p, bool pairs, bool walls, tr_status *st) {
    tr_random r = tr_random_seed(24, 1);
    tr_motion motion[4 * GEOMETRIES * MOTIONS];
    int n = 0;
    for (int wall = 0; wall < 2; wall++)
        for (int g = 0; g < GEOMETRIES && (wall ? walls : pairs); g++) {
            tr_motion place = place_of(g, wall);
            for (int k = 0; k < MOTIONS; k++) motion[n++] = probe(&r, &place);
        }
    for (int i = 0; i < n; i++) motion[n + i] = seen_moving(motion[i], isinf(motion[i].R1) ? 0 : 0.7);
    *p = (tr_probes){.n = 2 * n, .fit = FITS};
    return tr_states_make(&p->states, motion, 2 * n, st);
}

void tr_probes_free(tr_probes *p) {
    tr_states_free(&p->states);
}

/* Of lengths and of velocities: relative to the greatest of both. A form that has no value somewhere differs. */
double tr_fit_difference(const tr_form *a, const tr_form *b, bool wall, const tr_probes *probes, int *where) {
    double scale = 0, most = 0;
    *where = 0;
    for (int i = 0; i < probes->n / 2; i++) {
        if (isinf(probes->states.motion[i].R1) != wall) continue;
        double x = tr_forms_value(a, &probes->states, i), y = tr_forms_value(b, &probes->states, i);
        if (isnan(x) && isnan(y)) continue;
        if (isnan(x) || isnan(y)) return 1;
        scale = fmax(scale, fmax(fabs(x), fabs(y)));
        double part = fabs(x - y) / fmax(fmax(fabs(x), fabs(y)), 1e-300);
        if (part > most * (1 + 1e-6) && fabs(x - y) > 1e-9 * scale) most = part, *where = i;
    }
    return most;
}

/* ---- candidates */

typedef struct candidate {
    tr_form form;
    double error;
    bool odd; /* the factor is none of the table */
    int cost; /* how far from the plainest words */
} candidate;

typedef struct search {
    const tr_question *q;
    const tr_states *states;
    double *x; /* room */
    candidate *found;
    int n, capacity;
    tr_status *st;
} search;

static int cost_of(const tr_form *f, bool moment) {
    bool angle = tr_forms_is_angle(f->family, f->definition);
    int cost = f->definition + 30 * f->radii + (int)(25 * fabs(tr_log2(fabs(f->factor)))) + (f->factor < 0 ? 10 : 0);
    for (int k = 0; k < 2; k++) cost += f->lever[k] >= 0 ? 2 * f->lever[k] + 50 * k : 0;
    return cost + (angle && !moment && f->lever[0] >= 0 ? 30 : 0);
}

static double error_of(const search *s, double factor) {
    const tr_question *q = s->q;
    double most = 0;
    for (int k = 0; k < q->n; k++) {
        double off = fabs(q->y[k] - factor * s->x[k]), scale = q->length ? fabs(q->y[k]) : q->scale;
        most = fmax(most, off / scale);
    }
    return most;
}

static bool keep(search *s, tr_form form, double factor, bool odd) {
    if (s->n == s->capacity) {
        if (!tr_alloc_grow(&s->found, (size_t)s->n, 2 * (size_t)s->n + 256, sizeof *s->found, s->st)) return false;
        s->capacity = 2 * s->n + 256;
    }
    double error = error_of(s, factor);
    form.factor = factor; /* plus: the sign of the house */
    s->found[s->n++] = (candidate){form, error, odd, cost_of(&form, s->q->moment)};
    return true;
}

/* The factor of least squares, or that of the table that is meant. */
static bool consider(search *s, tr_form form) {
    const tr_question *q = s->q;
    double xy = 0, xx = 0;
    form.factor = q->sign;
    for (int k = 0; k < q->n; k++) {
        double w = q->length ? 1 / (q->y[k] * q->y[k]) : 1;
        s->x[k] = tr_forms_value(&form, s->states, q->row[k]);
        if (!isfinite(s->x[k])) return true;
        xy += w * s->x[k] * q->y[k], xx += w * s->x[k] * s->x[k];
    }
    if (!(xx > 0) || xy == 0 || !isfinite(xy / xx)) return true;
    double c = xy / xx, near = 1;
    for (int k = 0; k < tr_n_factors; k++)
        if (fabs(tr_log(fabs(c) / tr_factors[k].value)) < fabs(tr_log(fabs(c) / near))) near = tr_factors[k].value;
    bool odd = fabs(fabs(c) / near - 1) >= 0.02;
    return keep(s, form, copysign(near, c), false) && (!odd || keep(s, form, c, true));
}

/* Every lever that may stand with a definition. */
static bool consider_levers(search *s, tr_form form) {
    bool angle = tr_forms_is_angle(form.family, form.definition), cap = form.family == TR_FAMILY_CAP;
    bool ok = cap || consider(s, form);
    if (!cap && !s->q->moment && !angle) return ok;
    if (form.family == TR_FAMILY_SLIDING || form.family == TR_FAMILY_ARM_1 || form.family == TR_FAMILY_ARM_2) return ok;
    for (int a = 0; ok && a < tr_n_levers; a++) {
        form.lever[0] = a, form.lever[1] = -1;
        ok = consider(s, form);
        for (int b = a; ok && angle && s->q->moment && b < tr_n_levers; b++) {
            form.lever[1] = b;
            ok = consider(s, form);
        }
    }
    return ok;
}

static bool consider_all(search *s) {
    tr_family family = s->q->family;
    for (int radii = 0; radii < (family == TR_FAMILY_CAP ? 1 : TR_N_RADII); radii++)
        for (int k = 0; k < tr_forms_definitions(family); k++) {
            tr_form form = {family, k, radii, {-1, -1}, 1};
            if (!tr_forms_repeats(family, k) && !consider_levers(s, form)) return false;
        }
    return true;
}

/* ---- the choice */

static int by_error(const void *a, const void *b) {
    const candidate *x = a, *y = b;
    if (x->error != y->error) return x->error < y->error ? -1 : 1;
    return x->cost - y->cost;
}

/* Candidates are sorted by error. Odd factors count only where no plain one explains. */
static int drop_odd(candidate *c, int n) {
    int i = 0, kept = 0;
    while (i < n && c[i].odd) i++;
    if (i == n || c[i].error > FITS) return n;
    for (i = 0; i < n; i++)
        if (!c[i].odd) c[kept++] = c[i];
    return kept;
}

static bool same_but_radii(const tr_form *a, const tr_form *b) {
    return a->definition == b->definition && a->lever[0] == b->lever[0] && a->lever[1] == b->lever[1] &&
           a->factor == b->factor;
}

static bool is_plain(const tr_form *f) {
    return fabs(f->factor) == 1 && f->radii == TR_RADII && f->lever[0] <= 0 && f->lever[1] < 0;
}

/* Plain words need no others, unless those have but a factor; two reasons for one number are no explanation. */
static bool is_worth(const tr_form *form, const tr_form *best) {
    bool factor = fabs(form->factor) != 1, lever = form->lever[0] >= 0 || form->radii != TR_RADII;
    if (is_plain(best) && lever) return false;
    return !(factor && (form->radii != TR_RADII || form->lever[1] >= 0));
}

static void add_same(tr_fit *fit, const tr_form *form) {
    if (fit->n_same == TR_MOST_SAME || same_but_radii(form, &fit->best) || !is_worth(form, &fit->best)) return;
    for (int k = 0; k < fit->n_same; k++)
        if (same_but_radii(form, &fit->same[k])) return;
    fit->same[fit->n_same++] = *form;
}

static void add_tie(tr_fit *fit, const tr_form *form, const tr_probes *probes) {
    int where;
    for (int k = 0; k < fit->n_ties; k++)
        if (tr_fit_difference(form, &fit->tie[k], fit->question->wall, probes, &where) < SAME) return;
    if (fit->n_ties < TR_MOST_TIES) fit->tie[fit->n_ties++] = *form;
}

/* The plainest of those that fit as well as the best, then the others in the order of their words. */
static void choose(tr_fit *fit, const candidate *c, int n, const tr_probes *probes) {
    double limit = fmax(TIE * c[0].error, NOISE);
    int ties = 0, best = 0, where;
    while (ties < n && c[ties].error <= limit) ties++;
    for (int i = 1; i < ties; i++)
        if (c[i].cost < c[best].cost) best = i;
    fit->best = c[best].form, fit->error = c[best].error, fit->fits = fit->error <= FITS;
    for (int cost = c[best].cost, next; fit->fits; cost = next) { /* by cost */
        next = -1;
        for (int i = 0; i < ties; i++) {
            if (c[i].cost > cost && (next < 0 || c[i].cost < next)) next = c[i].cost;
            if (c[i].cost != cost || i == best) continue;
            if (tr_fit_difference(&c[i].form, &fit->best, fit->question->wall, probes, &where) < SAME)
                add_same(fit, &c[i].form);
            else
                add_tie(fit, &c[i].form, probes);
        }
        if (next < 0) break;
    }
    if (fit->n_ties) tr_fit_difference(&fit->best, &fit->tie[0], fit->question->wall, probes, &fit->apart);
    for (int i = 0; i < n && !fit->has_runner; i++)
        if (tr_fit_difference(&c[i].form, &fit->best, fit->question->wall, probes, &where) >= SAME)
            fit->runner = c[i].form, fit->runner_error = c[i].error, fit->has_runner = true;
}

static bool is_objective(const tr_form *form, bool wall, const tr_probes *probes) {
    double scale = 0, off = 0;
    for (int i = 0; i < probes->n / 2; i++) {
        if (isinf(probes->states.motion[i].R1) != wall) continue;
        double x = tr_forms_value(form, &probes->states, i);
        scale = fmax(scale, fabs(x));
        off = fmax(off, fabs(x - tr_forms_value(form, &probes->states, probes->n / 2 + i)));
    }
    return off <= 1e-9 * scale;
}

/* ---- the same motion, seen by two observers */

typedef struct seen {
    double R1, R2, L, s1, s2, v_n, scale, y;
    long line;
} seen;

static bool alike(double a, double b, double scale) {
    return a == b || fabs(a - b) <= 1e-9 * scale;
}

static int by_motion(const void *a, const void *b) {
    const seen *x = a, *y = b;
    if (!alike(x->R1, y->R1, x->R1)) return x->R1 < y->R1 ? -1 : 1;
    if (!alike(x->R2, y->R2, x->R2)) return x->R2 < y->R2 ? -1 : 1;
    if (!alike(x->L, y->L, x->R2)) return x->L < y->L ? -1 : 1;
    double scale = fmax(x->scale, y->scale);
    if (!alike(x->s1, y->s1, scale)) return x->s1 < y->s1 ? -1 : 1;
    if (!alike(x->s2, y->s2, scale)) return x->s2 < y->s2 ? -1 : 1;
    return 0;
}

static bool compare_observers(tr_fit *fit, const tr_question *q, const tr_identify_table *t, const tr_states *states,
                              tr_status *st) {
    seen *s = tr_alloc((size_t)q->n, sizeof *s, st);
    if (!s) return false;
    for (int k = 0; k < q->n; k++) {
        const tr_identify_row *r = &t->row[q->row[k]];
        const tr_motion_measures *m = &states->measures[0][q->row[k]];
        const tr_motion *v = &r->motion;
        double scale = fabs(v->v1x) + fabs(v->v1y) + fabs(v->v2x) + fabs(v->v2y) + fabs(v->w2) * v->R2 +
                       (isinf(v->R1) ? 0 : fabs(v->w1) * v->R1);
        s[k] = (seen){v->R1, v->R2, r->length, m->s1, m->s2, 0, scale, q->y[k], r->line};
    }
    qsort(s, (size_t)q->n, sizeof *s, by_motion);
    for (int k = 1, first = 0; k < q->n; k++) {
        if (by_motion(&s[first], &s[k]) != 0) first = k;
        fit->pairs += first != k;
        double off = fabs(s[k].y - s[first].y) / (q->length ? fabs(s[first].y) : q->scale);
        if (off <= fmax(fit->differs, fmax(1e-6, fit->fits ? 4 * fit->error : 0))) continue;
        fit->differs = off, fit->line[0] = s[first].line, fit->line[1] = s[k].line;
    }
    free(s);
    return true;
}

bool tr_fit_question(tr_fit *fit, const tr_question *q, const tr_identify_table *table, const tr_states *states,
                     const tr_probes *probes, tr_status *st) {
    *fit = (tr_fit){.question = q};
    search s = {.q = q, .states = states, .st = st};
    s.x = tr_alloc((size_t)q->n, sizeof *s.x, st);
    bool ok = s.x && consider_all(&s);
    if (ok && s.n) {
        qsort(s.found, (size_t)s.n, sizeof *s.found, by_error);
        s.n = drop_odd(s.found, s.n);
        choose(fit, s.found, s.n, probes);
        fit->objective = is_objective(&fit->best, q->wall, probes);
    }
    ok = ok && compare_observers(fit, q, table, states, st);
    free(s.found), free(s.x);
    return ok;
}
