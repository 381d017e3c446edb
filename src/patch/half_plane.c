/* SPDX-License-Identifier: MIT */
#include "patch/half_plane.h"
#include "base/math.h"
#include "base/alloc.h"
#include "base/vector.h"
#include "patch/bounded.h"
#include "patch/cut.h"

#include <stdlib.h>
#include <string.h>

struct tr_half_plane {
    tr_patch_pair pair;
    tr_patch_state s;
    tr_bounded problem;
    double *carried;      /* u_{n-1}(x_i - dr), n */
    double *bound, *b;    /* n */
    double *work, *work2; /* n, 2n */
    bool force_before;    /* the last step prescribed Q: its du is a good first guess */
};

tr_half_plane *tr_half_plane_new(const tr_patch_pair *pair, int n, tr_status *st) {
    tr_half_plane *o = tr_alloc(1, sizeof *o, st);
    if (!o) return NULL;
    o->pair = *pair;
    size_t m = (size_t)n;
    if (tr_patch_state_new(&o->s, pair, n, st) && tr_bounded_new(&o->problem, n, st) &&
        (o->carried = tr_alloc(m, sizeof(double), st)) && (o->bound = tr_alloc(m, sizeof(double), st)) &&
        (o->b = tr_alloc(m, sizeof(double), st)) && (o->work = tr_alloc(m, sizeof(double), st)) &&
        (o->work2 = tr_alloc(2 * m, sizeof(double), st)))
        return o;
    tr_half_plane_free(o);
    return NULL;
}

void tr_half_plane_free(tr_half_plane *o) {
    if (!o) return;
    tr_patch_state_free(&o->s), tr_bounded_free(&o->problem);
    free(o->carried), free(o->bound), free(o->b), free(o->work), free(o->work2);
    free(o);
}

const tr_patch_state *tr_half_plane_state(const tr_half_plane *o) {
    return &o->s;
}

/* int -ln|v| dv */
static double primitive(double v) {
    return v != 0 ? v * (1 - tr_log(fabs(v))) : 0;
}

/* u(x) = (2h/(pi E_star)) (sum over the n + 1 edges x_e of (tau_e - tau_{e-1}) primitive((x - x_e)/h) + ln(d/h) sum
 * tau) at x = x_i - dr, x_i on the grid of half-width a, tau on the grid of o->s. On the same grid (x - x_e)/h depends
 * on i - e only. */
TR_VECTOR static void carry(tr_half_plane *o, double a, double dr) {
    const tr_patch_state *s = &o->s;
    int n = s->n;
    double *u = o->carried, sum = 0;
    memset(u, 0, (size_t)n * sizeof *u);
    if (!(s->h > 0)) return;
    bool same = a == s->a;
    double shift = dr / s->h, ratio = a / s->a;
    for (int k = 0; same && k < 2 * n; k++) o->work2[k] = primitive(k - n + 0.5 - shift);
    for (int e = 0; e <= n; e++) {
        double jump = (e < n ? s->tau[e] : 0) - (e > 0 ? s->tau[e - 1] : 0);
        const double *column = same ? o->work2 + n - e : o->work;
        if (jump == 0) continue;
        for (int i = 0; !same && i < n; i++)
            o->work[i] = primitive((i + 0.5 - 0.5 * n) * ratio - (e - 0.5 * n) - shift);
        for (int i = 0; i < n; i++) u[i] += jump * column[i];
    }
    for (int i = 0; i < n; i++) sum += s->tau[i];
    double unit = 2 * s->h / (M_PI * o->pair.E_star), constant = tr_log(o->pair.d / s->h) * sum;
    for (int i = 0; i < n; i++) u[i] = unit * (u[i] + constant);
}

static bool set_grid(tr_half_plane *o, double P, tr_status *st) {
    tr_patch_state *s = &o->s;
    if (P == s->P) return true;
    tr_patch_state_grid(s, &o->pair, P);
    if (!(s->a < o->pair.d))
        return tr_status_fail(st, TR_NUMERICAL, "error: the half-width a = %g of a contact reaches d = %g", s->a,
                              o->pair.d);
    double unit = 2 * s->h / (M_PI * o->pair.E_star), constant = tr_log(o->pair.d / s->h);
    for (int k = 0; k < s->n; k++) {
        o->bound[k] = o->pair.mu * s->p[k];
        o->work[k] = unit * (primitive(k + 0.5) - primitive(k - 0.5) + constant);
    }
    return tr_bounded_matrix(&o->problem, o->work, st);
}

/* Q = NULL: Q and the slope are not wanted. */
static bool respond(void *body, double du, double *Q, double *slope, tr_status *st) {
    tr_half_plane *o = body;
    tr_patch_state *s = &o->s;
    for (int i = 0; i < s->n; i++) o->b[i] = du + o->carried[i];
    if (!tr_bounded_solve(&o->problem, o->bound, o->b, s->side, s->tau, s->slip, st)) return false;
    s->du = du;
    tr_patch_state_sums(s);
    if (!Q) return true;
    *Q = s->Q;
    *slope = s->h * tr_bounded_slope(&o->problem, o->work, o->work2);
    return true;
}

/* The smallest |du| at which all elements slip in the direction of Q. */
static double du_of_full_slip(tr_half_plane *o, double Q) {
    double most = -INFINITY, way = Q < 0 ? -1 : 1;
    for (int i = 0; i < o->s.n; i++) o->work[i] = -way * o->carried[i];
    tr_bounded_add_product(&o->problem, o->bound, o->work);
    for (int i = 0; i < o->s.n; i++) most = fmax(most, o->work[i]);
    return way * most;
}

static bool solve(tr_half_plane *o, const tr_patch_step *step, tr_status *st) {
    const tr_patch_pair *c = &o->pair;
    double full = c->mu * step->P, du = step->du;
    if (!step->by_force) return respond(o, du, NULL, NULL, st);
    if (fabs(step->Q) >= full * (1 - 1e-12)) return respond(o, du_of_full_slip(o, step->Q), NULL, NULL, st);
    du = o->force_before ? o->s.du : 0;
    double stiffest = M_PI * c->E_star / (2 * tr_patch_Lambda(c, step->P));
    return tr_patch_find_du(respond, o, step->Q, full, stiffest, &du, st);
}

bool tr_half_plane_step(tr_half_plane *o, const tr_patch_step *step, tr_status *st) {
    bool ok = tr_patch_step_check(step, &o->pair, st);
    if (ok && step->P > 0) {
        carry(o, tr_patch_a(&o->pair, step->P), step->dr);
        ok = set_grid(o, step->P, st) && solve(o, step, st);
        o->force_before = step->by_force;
    } else {
        tr_patch_state_clear(&o->s);
    }
    if (!ok) tr_patch_state_clear(&o->s);
    return ok;
}

static bool piece(void *body, const tr_patch_step *step, tr_status *st) {
    return tr_half_plane_step(body, step, st);
}

bool tr_half_plane_go(tr_half_plane *o, const tr_patch_step *row, tr_status *st) {
    bool ok = tr_patch_walk(&o->s, &o->pair, row, piece, o, st);
    if (!ok) tr_patch_state_clear(&o->s);
    return ok;
}

void tr_half_plane_checkpoint(tr_half_plane *o, tr_checkpoint *c) {
    tr_patch_state *s = &o->s;
    double P = s->P;
    TR_KEEP(c, &P, 1);
    if (!c->st->code && P > 0) set_grid(o, P, c->st);
    TR_KEEP(c, s->tau, s->n);
    TR_KEEP(c, s->slip, s->n);
    TR_KEEP(c, s->side, s->n);
    for (int k = 0; k < s->n; k++) tr_checkpoint_check(c, s->side[k] >= -1 && s->side[k] <= 1, "a side");
    TR_KEEP(c, &s->Q, 1);
    TR_KEEP(c, &s->du, 1);
    TR_KEEP(c, &s->dissipated, 1);
    TR_KEEP(c, &o->force_before, 1);
}
