/* SPDX-License-Identifier: MIT */
#include "laws/bed.h"

#include <math.h>
#include <stdbool.h>

/* Of mu P: breakpoints that change Q by less are rounding errors of the positions. */
static const double NOTHING = 1e-12;

static void push(tr_bed *b, double s, double e, double P) {
    b->s[b->n] = s, b->P[b->n] = P;
    b->e[b->n] = e + 0.0; /* no -0, which would not outlive e += 0 */
    b->n++;
}

static double force_at(tr_bed *b, int k) {
    if (b->P[k] < 0) b->P[k] = b->data->normal->elastic(b->data->normal_par, b->R1, b->R2, b->s[k]).force;
    return b->P[k];
}

/* By how much kappa Q changes where breakpoint k gives way to the chord over it. */
static double share(tr_bed *b, int k) {
    const double *s = b->s, *e = b->e;
    double left = s[k] - s[k - 1], right = s[k + 1] - s[k];
    double above = e[k] - (e[k - 1] * right + e[k + 1] * left) / (left + right);
    double P = force_at(b, k);
    return fabs(above * ((force_at(b, k + 1) - P) / right - (P - force_at(b, k - 1)) / left));
}

/* Drops what takes no part, and what does not fit: always the least. A second time it finds nothing to do. */
static void thin(tr_bed *b) {
    while (b->n > 2) {
        int least = 1;
        double lost = share(b, 1);
        for (int k = 2; k < b->n - 1; k++) {
            double other = share(b, k);
            if (other < lost) least = k, lost = other;
        }
        if (lost > NOTHING * b->cap * force_at(b, b->n - 1)) {
            if (b->n <= TR_BED_POINTS) return;
            b->merged++;
        }
        b->n--;
        for (int k = least; k < b->n; k++) b->s[k] = b->s[k + 1], b->e[k] = b->e[k + 1], b->P[k] = b->P[k + 1];
    }
}

double tr_bed_force(tr_bed *b) {
    double sum = 0;
    for (int k = 1; k < b->n; k++)
        sum += (b->e[k - 1] - b->e[k]) * ((force_at(b, k) - force_at(b, k - 1)) / (b->s[k] - b->s[k - 1]));
    double Q = sum / b->kappa, most = b->n ? b->mu * b->P[b->n - 1] : 0; /* which rounding may exceed */
    return Q > most ? most : Q < -most ? -most : Q;
}

/* No slope exceeds that of the caps, mu kappa: what slips is all the bed from some s on, up to delta, in one sense. There e
 * becomes the cap, one line to (delta, 0). Values on a cap are always computed as that here, so that e on it is not
 * above it the next time. */
static void move(tr_bed *b, double delta, double P, double du) {
    for (int k = 0; k < b->n; k++) b->e[k] += du;
    if (!b->n) push(b, 0, du, 0);
    double s = 0, e = 0; /* the first point that left or slips */
    bool gone = false;
    while (b->n && (b->s[b->n - 1] >= delta || fabs(b->e[b->n - 1]) > b->cap * (delta - b->s[b->n - 1]))) {
        b->n--, gone = true;
        s = b->s[b->n], e = b->e[b->n];
    }
    if (gone && !b->n)
        push(b, 0, copysign(b->cap * delta, e), 0);
    else if (gone) {
        double s0 = b->s[b->n - 1], e0 = b->e[b->n - 1];
        if (s > delta) e = e0 + (e - e0) * ((delta - s0) / (s - s0)), s = delta;
        double room0 = b->cap * (delta - s0) - (e < 0 ? -e0 : e0), room = b->cap * (delta - s) - fabs(e);
        double at = s0 + (s - s0) * (room0 / (room0 - room));
        if (at > s0 && at < delta) push(b, at, copysign(b->cap * (delta - at), e), -1);
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
    return tr_bed_force(b);
}

double tr_bed_trial(const tr_bed *b, double delta, double P, double du) {
    tr_bed copy = *b;
    move(&copy, delta, P, du);
    return tr_bed_force(&copy);
}

static tr_bed load(const tr_tile *tile, const tr_law_data *data, int i) {
    const tr_bed_par *p = data->par;
    double kappa = data->shape == TR_SHAPE_SPHERE ? (2 - p->nu) / (2 * (1 - p->nu)) : 1;
    tr_bed b = {.data = data, .R1 = tile->R1[i], .R2 = tile->R2[i], .mu = p->mu, .kappa = kappa, .cap = p->mu * kappa};
    int c = tile->first + i;
    b.n = (int)data->hist[0][c], b.merged = (int)data->hist[1][c];
    for (int k = 0; k < b.n; k++) {
        b.s[k] = data->hist[2 + 2 * k][c], b.e[k] = data->hist[3 + 2 * k][c];
        b.P[k] = k ? -1 : 0;
    }
    return b;
}

static void store(const tr_bed *b, int c) {
    double *const *hist = b->data->hist;
    hist[0][c] = b->n, hist[1][c] = b->merged;
    for (int k = 0; k < b->n; k++) hist[2 + 2 * k][c] = b->s[k], hist[3 + 2 * k][c] = b->e[k];
}

void tr_bed_step(tr_tile *tile, const tr_law_data *data, tr_bed_displacement *displacement) {
    for (int i = 0; i < tile->n; i++) {
        int c = tile->first + i;
        tile->f_t[i] = 0;
        if (tile->f_n[i] > 0 && tile->delta[i] > 0) {
            tr_bed b = load(tile, data, i);
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
        tr_elastic at = b->data->normal->elastic(b->data->normal_par, b->R1, b->R2, b->s[k]);
        double m = (b->e[k] - b->e[k - 1]) / (b->s[k] - b->s[k - 1]), Pe = at.force * b->e[k];
        sum += m * (m * (at.energy - W0) - (Pe - Pe0));
        W0 = at.energy, Pe0 = Pe;
    }
    return sum > 0 ? sum / b->kappa : 0; /* rounding */
}

void tr_bed_state(const tr_tile *tile, const tr_law_data *data, double *energy, double *bound) {
    const tr_bed_par *p = data->par;
    for (int i = 0; i < tile->n; i++) {
        tr_bed b = load(tile, data, i);
        energy[i] = energy_of(&b);
        bound[i] = tile->f_n[i] > 0 ? p->mu * tile->f_elastic[i] : 0;
    }
}

/* P'/kappa is the greatest slope of Q over du; kappa is not less than 1. */
tr_stiffness tr_bed_stiffness(const void *par, const tr_pair_bodies *bodies) {
    const tr_bed_par *p = par;
    return (tr_stiffness){.k = p->mu > 0 ? bodies->k_n : 0};
}
