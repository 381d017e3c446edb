/* SPDX-License-Identifier: MIT */
#include "laws/bed.h"

#include <limits.h>
#include <math.h>
#include <stdbool.h>

/* Of mu P: breakpoints that change Q by less are rounding errors of the positions. */
static const double NOTHING = 1e-12;

/* Of s: so near, a tangent of P errs by its square. */
static const double NEAR = 1e-9;

static void push(tr_bed *b, double s, double e, double P) {
    b->s[b->n] = s, b->P[b->n] = P;
    b->e[b->n] = e + 0.0; /* no -0, which would not outlive e += 0 */
    b->n++;
}

static tr_elastic curve(const tr_bed *b, double s) {
    return b->data->normal->elastic(b->data->normal_par, b->R1, b->R2, s);
}

static double slope_of(const tr_bed *b, double s, double P) {
    return b->data->normal->slope(b->data->normal_par, s, P);
}

/* P(s) at the edge of slip. Trials come close to where the step ends. */
static double edge(tr_bed *b, double s) {
    double from = s - b->asked;
    if (fabs(from) <= NEAR * s) return b->asked_P + from * slope_of(b, b->asked, b->asked_P);
    b->asked = s, b->asked_P = curve(b, s).force;
    return b->asked_P;
}

/* By how much kappa Q changes where breakpoint k gives way to the chord over it. */
static double share(const double *s, const double *e, const double *P, int k) {
    double left = s[k] - s[k - 1], right = s[k + 1] - s[k];
    double above = e[k] - (e[k - 1] * right + e[k + 1] * left) / (left + right);
    return fabs(above * ((P[k + 1] - P[k]) / right - (P[k] - P[k - 1]) / left));
}

static void drop(double *of, int k, int n) {
    for (; k < n; k++) of[k] = of[k + 1];
}

/* Drops breakpoints without effect, and those that do not fit, smallest effect first. A second call changes nothing. */
static void thin(tr_bed *b) {
    double lost[TR_BED_POINTS + 1];
    for (int k = 1; k < b->n - 1; k++) lost[k] = share(b->s, b->e, b->P, k);
    while (b->n > 2) {
        int k = 1;
        for (int j = 2; j < b->n - 1; j++)
            if (lost[j] < lost[k]) k = j;
        if (lost[k] > NOTHING * b->cap * b->P[b->n - 1]) {
            if (b->n <= b->most) return;
            b->merged += b->merged < INT_MAX;
        }
        b->n--;
        if (k < b->kept) b->kept = k;
        drop(b->s, k, b->n), drop(b->e, k, b->n), drop(b->P, k, b->n), drop(lost, k, b->n - 1);
        if (k > 1) lost[k - 1] = share(b->s, b->e, b->P, k - 1);
        if (k < b->n - 1) lost[k] = share(b->s, b->e, b->P, k);
    }
}

static double capped(const tr_bed *b, double Q, double P) {
    double most = b->mu * P; /* which rounding may exceed */
    return Q > most ? most : Q < -most ? -most : Q;
}

double tr_bed_force(const tr_bed *b, double *below) {
    double sum = below[0] = 0;
    for (int k = 1; k < b->n; k++) {
        sum += (b->e[k - 1] - b->e[k]) * ((b->P[k] - b->P[k - 1]) / (b->s[k] - b->s[k - 1]));
        below[k] = sum;
    }
    return b->n ? capped(b, sum / b->kappa, b->P[b->n - 1]) : 0;
}

/* No slope exceeds that of the caps, mu kappa. So the slipping part is the bed from some s to delta, in one sense.
 * There e becomes the cap, one line to (delta, 0). Values on a cap are always computed here, so that e is not above the
 * cap the next time. */
static void move(tr_bed *b, double delta, double P, double du) {
    for (int k = 0; k < b->n; k++) b->e[k] += du;
    if (!b->n) push(b, 0, du, 0);
    double s = 0, e = 0; /* the first point that left or slips */
    bool gone = false;
    while (b->n && (b->s[b->n - 1] >= delta || fabs(b->e[b->n - 1]) > b->cap * (delta - b->s[b->n - 1]))) {
        b->n--, gone = true;
        s = b->s[b->n], e = b->e[b->n];
    }
    if (b->n < b->kept) b->kept = b->n;
    if (gone && !b->n)
        push(b, 0, copysign(b->cap * delta, e), 0);
    else if (gone) {
        double s0 = b->s[b->n - 1], e0 = b->e[b->n - 1];
        if (s > delta) e = e0 + (e - e0) * ((delta - s0) / (s - s0)), s = delta;
        double room0 = b->cap * (delta - s0) - (e < 0 ? -e0 : e0), room = b->cap * (delta - s) - fabs(e);
        double at = s0 + (s - s0) * (room0 / (room0 - room));
        if (at > s0 && at < delta) push(b, at, copysign(b->cap * (delta - at), e), edge(b, at));
    }
    for (int k = 0; k < b->n; k++) { /* rounding */
        double most = b->cap * (delta - b->s[k]);
        if (fabs(b->e[k]) > most) b->e[k] = copysign(most, b->e[k]);
    }
    push(b, delta, 0, P);
}

double tr_bed_advance(tr_bed *b, double delta, double P, double du) {
    move(b, delta, P, du);
    thin(b);
    double below[TR_BED_POINTS + 1];
    return tr_bed_force(b, below);
}

/* What tr_bed_advance would give, from sums that a shift of all e leaves as they are. */
double tr_bed_trial(tr_bed *b, const double *below, double delta, double P, double du, double *slope) {
    int k = b->n - 1;
    bool sticks = k < 0 || b->s[k] < delta;
    double s = k < 0 ? 0 : b->s[k], old = k < 0 ? 0 : b->P[k];
    *slope = 0;
    if (tr_bed_slips(b, delta, du, 1)) return b->mu * P;
    if (tr_bed_slips(b, delta, du, -1)) return -b->mu * P;
    if (sticks && !(fabs(du) > b->cap * (delta - s))) { /* so is NaN */
        *slope = (P - old) / (delta - s) / b->kappa;
        return capped(b, (k < 0 ? 0 : below[k] / b->kappa) + du * *slope, P);
    }
    double end = s, e_end = du; /* of the lowest that left or slips */
    for (; k > 0 && (b->s[k] >= delta || fabs(b->e[k] + du) > b->cap * (delta - b->s[k])); k--)
        end = b->s[k], e_end = b->e[k] + du;
    double s0 = b->s[k], e0 = b->e[k] + du;
    if (end > delta) e_end = e0 + (e_end - e0) * ((delta - s0) / (end - s0)), end = delta;
    double sign = e_end < 0 ? -1 : 1;
    double room0 = b->cap * (delta - s0) - sign * e0, room = b->cap * (delta - end) - sign * e_end;
    double at = s0 + (end - s0) * (room0 / (room0 - room));
    if (!(at > s0)) at = s0;
    double P_at = at > s0 ? edge(b, at) : b->P[k];
    double rest = at > s0 ? (e0 - sign * b->cap * (delta - at)) * ((P_at - b->P[k]) / (at - s0)) : 0;
    *slope = at > 0 ? slope_of(b, at, P_at) / b->kappa : 0;
    return capped(b, (below[k] + rest) / b->kappa + sign * b->mu * (P - P_at), P);
}

/* What all contacts share. */
static void begin(tr_bed *b, const tr_law_data *data) {
    const tr_bed_par *p = data->par;
    b->data = data, b->mu = p->mu, b->most = p->breakpoints ? p->breakpoints : TR_BED_POINTS;
    b->kappa = data->shape == TR_SHAPE_SPHERE ? (2 - p->nu) / (2 * (1 - p->nu)) : 1;
    b->cap = b->mu * b->kappa;
}

/* A history from a file may have any values. */
static int count(double n, int most) {
    return n >= 0 && n <= most ? (int)n : 0;
}

/* In place: copying a bed takes as long as moving it. */
static void load(tr_bed *b, const tr_tile *tile, int i) {
    int c = tile->first + i;
    double *const *hist = b->data->hist, *const *point = hist + 2;
    b->R1 = tile->R1[i], b->R2 = tile->R2[i];
    b->n = count(hist[0][c], TR_BED_POINTS), b->merged = count(hist[1][c], INT_MAX);
    for (int k = 0; k < b->n; k++, point += 3) b->s[k] = point[0][c], b->e[k] = point[1][c], b->P[k] = point[2][c];
    b->kept = b->n, b->asked = 0;
}

static void store(const tr_bed *b, int c) {
    double *const *hist = b->data->hist, *const *point = hist + 2;
    hist[0][c] = b->n, hist[1][c] = b->merged;
    for (int k = 0; k < b->n; k++, point += 3) {
        point[1][c] = b->e[k];
        if (k >= b->kept) point[0][c] = b->s[k], point[2][c] = b->P[k];
    }
}

void tr_bed_step(tr_tile *tile, const tr_law_data *data, tr_bed_displacement *displacement) {
    tr_bed b;
    begin(&b, data);
    for (int i = 0; i < tile->n; i++) {
        int c = tile->first + i;
        tile->f_t[i] = 0;
        if (tile->f_n[i] > 0 && tile->delta[i] > 0) {
            load(&b, tile, i);
            double du = displacement(&b, tile, data, i);
            tile->f_t[i] = tr_bed_advance(&b, tile->delta[i], tile->f_elastic[i], du);
            store(&b, c);
        } else if (data->hist[0][c] > 0)
            for (int k = 0; k < TR_BED_HIST; k++) data->hist[k][c] = 0;
    }
}

static double energy_of(const tr_bed *b) {
    double sum = 0, W0 = 0, Pe0 = 0; /* at the start of the piece */
    for (int k = 1; k < b->n; k++) {
        tr_elastic at = curve(b, b->s[k]);
        double m = (b->e[k] - b->e[k - 1]) / (b->s[k] - b->s[k - 1]), Pe = at.force * b->e[k];
        sum += m * (m * (at.energy - W0) - (Pe - Pe0));
        W0 = at.energy, Pe0 = Pe;
    }
    return sum > 0 ? sum / b->kappa : 0; /* rounding */
}

void tr_bed_state(const tr_tile *tile, const tr_law_data *data, double *energy, double *bound) {
    tr_bed b;
    begin(&b, data);
    for (int i = 0; i < tile->n; i++) {
        load(&b, tile, i);
        energy[i] = energy_of(&b);
        bound[i] = tile->f_n[i] > 0 ? b.mu * tile->f_elastic[i] : 0;
    }
}

/* P'/kappa is the largest slope of Q over du; kappa is at least 1. */
tr_stiffness tr_bed_stiffness(const void *par, const tr_pair_bodies *bodies) {
    const tr_bed_par *p = par;
    return (tr_stiffness){.k = p->mu > 0 ? bodies->k_n : 0};
}
