/* SPDX-License-Identifier: MIT */
/* Line contact of disks, with a dashpot that follows the stiffness. Source [Johnson1985 secs. 4.2, 5.6].
 *
 *   a = sqrt(4 P R/(pi E_star)),   delta(P) = (2P/(pi E_star)) (Lambda + 1/2),   Lambda = ln(2d/a),   1/R = 1/R1 + 1/R2
 *   k = dP/ddelta = pi E_star/(2 Lambda),   energy = P^2 (Lambda + 1/4)/(pi E_star)
 *   f_n = max(0, P + c v_n),   c = 2 damping_ratio sqrt(k m_eff)
 *
 * In the plane the approach needs a datum: d is its depth. By default, depth: 0, each disk is
 * pressed between two plates and its centre is the datum: d = 2 sqrt(R1 R2)/e, 2 R2/e at a wall, which then is rigid
 * (ibid. eq. 5.57).
 *
 * P(delta): with z = (a/2d)^2, so P = z pi E_star d^2/R, the second line is z (1 - ln z) = delta R/d^2, and with w = 1
 * - ln z = 1 + 2 Lambda it is w - ln w = L = 1 - ln(delta R/d^2), increasing and convex for w > 1; P = pi E_star
 * delta/w, k = pi E_star/(w - 1). A rational function of L is within 0.001 w of w for all L that a double can have. The
 * w0 of it is right for another L, less D = L - (w0 - ln w0), and Taylor's series of w from there is, with
 * t = D/(w0 - 1)^2,
 *
 *   w = w0 + D w0/(w0 - 1) (1 - t/2 + (2 w0 + 1) t^2/6 - (6 w0^2 + 8 w0 + 1) t^3/24 + ...)
 *
 * of which five terms leave 2e-18 w. Where a would reach d (w < LEAST) there is no such contact any more: P goes on
 * linearly there, so that numbers stay sane until so large an overlap is refused.
 *
 * delta -> 0: k goes to 0 as 1/ln delta, P to 0. delta <= 0: nothing. The force ends when f_n reaches 0.
 */
#include "base/vector.h"
#include "base/math.h"
#include "laws/law.h"
#include "laws/material.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

static const double LEAST = 1 + 2 * M_LN2; /* w at a = d */

typedef struct par {
    double E_star, depth, damping_ratio;
} par;

static const tr_param params[] = {
    TR_ROW_E_STAR(par, E_star),
    TR_ROW_DEPTH(par, depth),
    TR_ROW_DAMPING_RATIO(par, damping_ratio),
};

/* What all formulas need. */
typedef struct line {
    double K;     /* pi E_star [Pa] */
    double scale; /* R/d^2 [1/m] */
} line;

static line line_of(const par *p, double R1, double R2) {
    double d = tr_law_depth(p->depth, R1, R2);
    return (line){M_PI * p->E_star, tr_law_R_star(R1, R2) / (d * d)};
}

static double w_at_force(const line *l, double P) {
    return 1 - tr_log(P * l->scale / l->K);
}

static inline double energy(const line *l, double P, double w) {
    return P * P * (0.5 * w - 0.25) / l->K;
}

/* ln x of a normal x > 0 to 2 ulp, with all its steps in vector lanes; libm's is a call, which prevents vector code: a
 * step of a sheared sample took about three times as long. x = m 2^k, 1/2 <= m^2 < 2, ln m = 2 artanh s = 2 (s + s^3/3
 * + ...), s = (m - 1)/(m + 1): 10 terms leave 3e-17. */
static inline double ln(double x) {
    const uint64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000, two52 = 0x4330000000000000;
    uint64_t bits, number;
    double m, k, tail = 0;
    memcpy(&bits, &x, sizeof bits);
    uint64_t exponent = (bits - root_half + one) >> 52; /* k + 1023 */
    bits = bits - (exponent << 52) + one;
    number = exponent | two52; /* as a double 2^52 + k + 1023 */
    memcpy(&m, &bits, sizeof m), memcpy(&k, &number, sizeof k);
    double s = (m - 1) / (m + 1), z = s * s;
    for (int n = 19; n > 1; n -= 2) tail = (tail + 1.0 / n) * z;
    return (k - (0x1p52 + 1023)) * M_LN2 + (2 * s + 2 * s * tail);
}

/* Past a = d, where z = 1/4 and w = LEAST, on by `more` of overlap at the stiffness there. `logarithm` is ln in vector
 * lanes; for one contact that of libm is quicker. */
static inline tr_elastic at_overlap(const line *l, double delta, double logarithm(double)) {
    double end = 0.25 * LEAST / l->scale, more = delta > end ? delta - end : 0, inside = delta > end ? end : delta;
    double x = l->scale * inside, L = 1 - logarithm(x > DBL_MIN ? x : DBL_MIN);
    double w = (((0.080039 * L + 2.5329) * L + 4.8032) * L - 2.8633) / ((0.079825 * L + 2.1254) * L + 1);
    double D = L - (w - logarithm(w)), u = 1 / (w - 1), t = D * u * u;
    double c2 = (2 * w + 1) * (1.0 / 6), c3 = ((6 * w + 8) * w + 1) * (1.0 / 24);
    double c4 = (((24 * w + 58) * w + 22) * w + 1) * (1.0 / 120);
    w += D * w * u * (1 - t * (0.5 - t * (c2 - t * (c3 - t * c4))));
    double P = l->K * inside / w, k = l->K / (w - 1);
    bool touching = delta > 0;
    return (tr_elastic){.force = touching ? P + k * more : 0,
                        .energy = touching ? energy(l, P, w) + (P + 0.5 * k * more) * more : 0,
                        .stiffness = touching ? k : 0};
}

static void pair(const void *par_, const tr_pair_bodies *b, double *constants) {
    const par *p = par_;
    constants[0] = line_of(p, b->R1, b->R2).scale;
    constants[1] = 2 * p->damping_ratio * sqrt(tr_law_m_eff(b)); /* c = this sqrt(k) */
}

static line line_at(const tr_tile *tile, const tr_law_data *data, int i) {
    const par *p = data->par;
    return (line){M_PI * p->E_star, data->pair[0][tile->first + i]};
}

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const double *restrict scale = data->pair[0] + tile->first, *restrict damp = data->pair[1] + tile->first;
    double K = M_PI * ((const par *)data->par)->E_star;
    for (int i = 0; i < tile->n; i++) {
        tr_elastic e = at_overlap(&(line){K, scale[i]}, tile->delta[i], ln);
        double force = e.force + damp[i] * sqrt(e.stiffness) * tile->v_n[i];
        tile->f_elastic[i] = e.force;
        tile->f_n[i] = force > 0 ? force : 0;
    }
}

/* From the force: no iteration. */
static void state(const tr_tile *tile, const tr_law_data *data, double *stored, double *bound) {
    (void)bound;
    for (int i = 0; i < tile->n; i++) {
        line l = line_at(tile, data, i);
        double P = tile->f_elastic[i], w = w_at_force(&l, P);
        stored[i] = !(P > 0) ? 0 : w < LEAST ? at_overlap(&l, tile->delta[i], tr_log).energy : energy(&l, P, w);
    }
}

static tr_elastic elastic(const void *par, double R1, double R2, double delta) {
    line l = line_of(par, R1, R2);
    return at_overlap(&l, delta, tr_log);
}

static double overlap(const void *par, double R1, double R2, double force) {
    line l = line_of(par, R1, R2);
    if (!(force > 0)) return 0;
    double w = w_at_force(&l, force);
    return w < LEAST ? (force * (LEAST - 1) + 0.25 * l.K / l.scale) / l.K : force * w / l.K;
}

/* On the straight line past a = d, K delta/P is below LEAST. */
static double slope(const void *par_, double delta, double P) {
    double K = M_PI * ((const par *)par_)->E_star;
    return K / (fmax(K * delta / P, LEAST) - 1);
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *b) {
    const par *p = par_;
    double k = elastic(par_, b->R1, b->R2, b->delta).stiffness;
    return (tr_stiffness){.k = k, .c = 2 * p->damping_ratio * sqrt(k * tr_law_m_eff(b))};
}

const tr_law tr_normal_hertz_line = {
    .table = {"hertz-line", "Hertz line contact of disks with the logarithmic approach, and dashpot, no attraction",
              params, .n = sizeof params / sizeof *params, .demands = TR_ONLY_DISKS | TR_NEEDS_TIME},
    .source = "[Johnson1985] [Tsuji1992]",
    .formula = "f_n = max(0, P + c v_n), delta = (2P/(pi E_star)) (ln(2d/a) + 1/2)\n"
               "a = sqrt(4 P R/(pi E_star)), 1/R = 1/R1 + 1/R2, d = depth\n"
               "c = 2 damping_ratio sqrt(k m_eff), k = dP/ddelta, m_eff = m1 m2/(m1 + m2)",
    .differs =
        "Where a would exceed d the force continues linearly. The force of the dashpot never pulls: a contact ends "
        "when f_n reaches 0, not when the overlap does.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_pair = 2,
    .pair = pair,
    .step = step,
    .state = state,
    .stiffness = stiffness,
    .elastic = elastic,
    .overlap = overlap,
    .slope = slope,
};
