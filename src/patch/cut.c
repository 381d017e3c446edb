/* SPDX-License-Identifier: MIT */
#include "patch/cut.h"

#include <stdint.h>
#include <string.h>

/* A length that is a whole number of elements gets no extra piece by rounding. */
static double count(double pieces) {
    return fmax(1, ceil(pieces * (1 - 1e-9)));
}

static double element(double a, int n) {
    return 2 * a / n;
}

int tr_patch_pieces(double a_from, double a, int n, double dr) {
    if (!(a > 0)) return 1;
    double loads = fabs(a - a_from) / element(fmax(a, a_from), n);
    return (int)fmin(count(fmax(fabs(dr) / element(a, n), loads)), 1000);
}

/* A step on its way. */
typedef struct walk {
    tr_patch_state *s;
    const tr_patch_pair *pair;
    const tr_patch_step *step;
    tr_patch_piece *piece;
    void *body;
    double du, dissipated; /* so far; the slip in s->slip_sum */
} walk;

static double longest_memory(const tr_patch_pair *c, double P) { /* Lambda */
    return fmax(tr_patch_Lambda(c, P), 1);
}

/* All tractions have changed so little that the steady state is within 1e-2/n. */
static bool is_steady(const walk *w) {
    const tr_patch_state *s = w->s;
    double most = 0, n = s->n, full = w->pair->mu * tr_patch_p0(w->pair, s->P);
    for (int i = 0; i < s->n; i++) most = fmax(most, fabs(s->tau[i] - s->tau_before[i]));
    return most <= 2e-2 / (n * n * longest_memory(w->pair, s->P)) * full;
}

/* The last piece, `times` times. */
static void add(walk *w, double times) {
    tr_patch_state *s = w->s;
    w->du += times * s->du, w->dissipated += times * s->dissipated;
    for (int i = 0; i < s->n; i++) s->slip_sum[i] += times * s->slip[i];
}

/* dr and du: of the whole stair. */
static bool climb(walk *w, tr_patch_step stair, tr_status *st) {
    tr_patch_state *s = w->s;
    const double h = element(tr_patch_a(w->pair, stair.P), s->n), pieces = count(fabs(stair.dr) / h);
    const double most = 20 * longest_memory(w->pair, stair.P) * 0.5 * s->n, dr = stair.dr, du = stair.du;
    double after = pieces - 1; /* whole ones to come */
    stair.dr = dr - copysign(after * h, dr), stair.du = pieces > 1 ? du * (stair.dr / dr) : du;
    for (double taken = 0;; taken++, after--) {
        memcpy(s->tau_before, s->tau, (size_t)s->n * sizeof *s->tau);
        if (!w->piece(w->body, &stair, st)) return false;
        add(w, 1);
        if (after == 0) return true;
        if (taken > 0 && (is_steady(w) || taken >= most)) return add(w, after), true;
        stair.dr = copysign(h, dr), stair.du = du * (stair.dr / dr);
    }
}

static double stairs_of(const walk *w, double a, double Q) {
    const tr_patch_step *t = w->step;
    double to = tr_patch_a(w->pair, t->P), widest = fmax(a, to), n = w->s->n;
    bool moves = t->dr != 0 || (t->by_force ? t->Q != Q : t->du != 0);
    if (!moves) return 1;
    double loads = fabs(to - a) / element(widest, w->s->n), rolls = fabs(t->dr) / element(to, w->s->n);
    double full = w->pair->mu * fmax(t->P, w->s->P), pulls = t->by_force ? 0.5 * n * fabs(t->Q - Q) / full : 0;
    return count(fmax(loads, fmin(rolls, pulls)));
}

static bool go(walk *w, tr_status *st) {
    const tr_patch_step *t = w->step;
    const double P = w->s->P, Q = w->s->Q, a = w->s->a, to = tr_patch_a(w->pair, t->P), n = stairs_of(w, a, Q);
    double before = 0;
    for (int64_t k = 1; (double)k < n; k++) { /* of equal changes of a: P goes by its square */
        double share = (double)k / n, part = share * ((a + share * (to - a)) + a) / (to + a);
        tr_patch_step stair = *t;
        stair.P = P + part * (t->P - P), stair.Q = Q + part * (t->Q - Q);
        stair.dr = (part - before) * t->dr, stair.du = (part - before) * t->du;
        if (!climb(w, stair, st)) return false;
        before = part;
    }
    tr_patch_step last = *t;
    last.dr = (1 - before) * t->dr, last.du = (1 - before) * t->du;
    return climb(w, last, st);
}

bool tr_patch_walk(tr_patch_state *s, const tr_patch_pair *pair, const tr_patch_step *step, tr_patch_piece *piece,
                   void *body, tr_status *st) {
    walk w = {s, pair, step, piece, body, 0, 0};
    if (!tr_patch_step_check(step, pair, st)) return false;
    if (step->P == 0) return piece(body, step, st);
    memset(s->slip_sum, 0, (size_t)s->n * sizeof *s->slip_sum);
    if (!go(&w, st)) return false;
    s->du = w.du, s->dissipated = w.dissipated;
    memcpy(s->slip, s->slip_sum, (size_t)s->n * sizeof *s->slip);
    return true;
}
