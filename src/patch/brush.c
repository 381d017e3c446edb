/* SPDX-License-Identifier: MIT */
#include "patch/brush.h"
#include "base/alloc.h"
#include "patch/cut.h"

#include <stdlib.h>
#include <string.h>

struct tr_brush {
    tr_patch_pair pair;
    tr_patch_state s;
    double given_k, k;   /* k_w as given; at present */
    double *w, *carried; /* deflection [m]: w_n(x_i), w_{n-1}(x_i - dr) */
    double *share;       /* of the step that the material now at x_i was in contact */
};

tr_brush *tr_brush_new(const tr_patch_pair *pair, int n, double k_w, tr_status *st) {
    tr_brush *o = tr_alloc(1, sizeof *o, st);
    if (!o) return NULL;
    o->pair = *pair, o->given_k = k_w;
    if (!(k_w >= 0 && isfinite(k_w)))
        tr_status_fail(st, TR_BAD_CASE, "error: k_w = %g of a brush must not be negative", k_w);
    else if (tr_patch_state_new(&o->s, pair, n, st) && (o->w = tr_alloc((size_t)n, sizeof *o->w, st)) &&
             (o->carried = tr_alloc((size_t)n, sizeof *o->carried, st)) &&
             (o->share = tr_alloc((size_t)n, sizeof *o->share, st)))
        return o;
    tr_brush_free(o);
    return NULL;
}

void tr_brush_free(tr_brush *o) {
    if (!o) return;
    tr_patch_state_free(&o->s);
    free(o->w), free(o->carried), free(o->share), free(o);
}

const tr_patch_state *tr_brush_state(const tr_brush *o) {
    return &o->s;
}

/* w at x on the present grid: linear between the middles of the elements and the edges, where it is 0. */
static double deflection(const tr_brush *o, double x) {
    const tr_patch_state *s = &o->s;
    double at = (x + s->a) / s->h - 0.5; /* in elements from the first middle */
    if (!(at > -0.5 && at < s->n - 0.5)) return 0;
    if (at < 0) return o->w[0] * (1 + 2 * at);
    if (at > s->n - 1) return o->w[s->n - 1] * (1 - 2 * (at - (s->n - 1)));
    int i = at < s->n - 2 ? (int)at : s->n - 2;
    return o->w[i] + (at - i) * (o->w[i + 1] - o->w[i]);
}

static void carry(tr_brush *o, double a, double dr) {
    int n = o->s.n;
    for (int i = 0; i < n; i++) {
        double x = (i + 0.5 - 0.5 * n) * (2 * a / n), inside = fmax(a, o->s.a) + (dr < 0 ? -x : x);
        o->carried[i] = o->s.h > 0 ? deflection(o, x - dr) : 0;
        o->share[i] = inside < fabs(dr) ? inside / fabs(dr) : 1;
    }
}

static bool respond(void *body, double du, double *Q, double *slope, tr_status *st) {
    tr_brush *o = body;
    tr_patch_state *s = &o->s;
    (void)st;
    *slope = 0;
    for (int i = 0; i < s->n; i++) {
        double w = o->carried[i] + o->share[i] * du, most = o->pair.mu * s->p[i] / o->k;
        s->side[i] = (signed char)((w > most) - (w < -most));
        o->w[i] = s->side[i] ? s->side[i] * most : w;
        s->tau[i] = s->side[i] ? s->side[i] * o->pair.mu * s->p[i] : o->k * w;
        s->slip[i] = w - o->w[i];
        *slope += s->side[i] ? 0 : o->share[i] * o->k * s->h;
    }
    s->du = du;
    tr_patch_state_sums(s);
    *Q = s->Q;
    return true;
}

/* The smallest |du| at which all elements slip in the direction of Q. */
static double du_of_full_slip(const tr_brush *o, double Q) {
    double most = -INFINITY, way = Q < 0 ? -1 : 1;
    for (int i = 0; i < o->s.n; i++)
        most = fmax(most, (o->pair.mu * o->s.p[i] / o->k - way * o->carried[i]) / o->share[i]);
    return way * most;
}

static bool solve(tr_brush *o, const tr_patch_step *step, tr_status *st) {
    double full = o->pair.mu * step->P, Q, slope, du = step->by_force ? 0 : step->du;
    if (step->by_force && fabs(step->Q) < full * (1 - 1e-12))
        return tr_patch_find_du(respond, o, step->Q, full, 2 * o->s.a * o->k, &du, st);
    return respond(o, step->by_force ? du_of_full_slip(o, step->Q) : du, &Q, &slope, st);
}

bool tr_brush_step(tr_brush *o, const tr_patch_step *step, tr_status *st) {
    bool ok = tr_patch_step_check(step, &o->pair, st);
    if (ok && step->P > 0) {
        carry(o, tr_patch_a(&o->pair, step->P), step->dr);
        tr_patch_state_grid(&o->s, &o->pair, step->P);
        o->k = o->given_k > 0 ? o->given_k : M_PI * o->pair.E_star / (4 * o->s.a);
        ok = solve(o, step, st);
    } else {
        tr_patch_state_clear(&o->s);
    }
    if (!ok) tr_patch_state_clear(&o->s);
    return ok;
}

static bool piece(void *body, const tr_patch_step *step, tr_status *st) {
    return tr_brush_step(body, step, st);
}

bool tr_brush_go(tr_brush *o, const tr_patch_step *row, tr_status *st) {
    bool ok = tr_patch_walk(&o->s, &o->pair, row, piece, o, st);
    if (!ok) tr_patch_state_clear(&o->s);
    return ok;
}
