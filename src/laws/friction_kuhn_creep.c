/* SPDX-License-Identifier: MIT */
/* Friction of an elastic contact that rolling relaxes [Kuhn2014 eq. 16]: the bed of sliders moves by the sliding less
 * the creep of steady rolling at the present force.
 *
 *   dQ = C^-1(du_disp - sgn(Q) F(|Q|/(mu P)) |du_roll|),   C^-1: cattaneo-mindlin, see bed.h
 *   spheres [Kalker1967]:  F(q) = F0 (1 - (1 - q)^(1/3)),   F0 = 4 mu a/((1 - nu) C11 R),   a = cbrt(3 P R/(4 E*))
 *   disks   [Carter1926]:  F(q) = F0 (1 - (1 - q)^(1/2)),   F0 = mu a/R,                    a = sqrt(4 P R/(pi E*))
 *
 * 1/R = 1/R1 + 1/R2, C11 linear between Kalker's 3.40, 4.12, 5.20 at nu = 0, 0.25, 0.5, and on below 0. du_roll: Kuhn's
 * mean flow of material (s1 + s2)/2 dt, or V_r dt of Wang.
 *
 * A step solves Q = J(x), where J(x) is the force of the bed after a step by x:
 *
 *   x = du_disp - ((1 - theta) sgn(Q_n) F_n + theta sgn(Q) F) |du_roll|
 *   theta = 1/(1 - e^-z) - 1/z,   z = (dQ/dx) (dF/dQ) |du_roll| at the begin
 *
 * Q_n and F_n are those at the end of the step before, with the P of that time; dQ/dx = the present P'/kappa, the
 * largest. theta
 * -> 1/2 for short steps, of second order, and -> 1 for long ones, backward Euler [Liniger1970]. (1 - theta) z < 1 and
 * F is convex, so the explicit part cannot reverse Q at constant P. If it would because P falls, theta = 1. At the end
 * of full slip F falls like a root of the time: theta = 1, and the order from there is 1 + 1/p, p as below.
 *
 * The unknown is w = 1 - (1 - q)^(1/p), p = 3 or 2, in which creep is linear: mu P (1 - (1 - w)^p) - |J(x(w))| grows
 * with w, and Newton's method finds its only root, usually in two steps from the w before. J and dJ/dx need P and P'
 * only at the edge of slip.
 *
 * du_roll = 0: cattaneo-mindlin, bit for bit. P -> 0: a = 0, Q = 0. Wall: R = R2, material rolls with (Vt - R2 w)/2.
 */
#include "laws/creep.h"
#include "base/math.h"

#include <stdbool.h>

static const tr_param params[] = {TR_CREEP_PARAMS(tr_creep_par)};

static double C11(double nu) {
    return nu < 0.25 ? 3.40 + (4.12 - 3.40) * nu / 0.25 : 4.12 + (5.20 - 4.12) * (nu - 0.25) / 0.25;
}

/* F(1). */
static double greatest_creep(const tr_creep_par *p, tr_shape shape, double R1, double R2, double P) {
    double R = tr_law_R_star(R1, R2), slope = p->bed.mu * tr_law_width(shape, P, R, p->E_star) / R;
    return shape == TR_SHAPE_SPHERE ? 4 / ((1 - p->bed.nu) * C11(p->bed.nu)) * slope : slope;
}

/* The bed before the step, and the displacement x0 - side creep w of a trial. */
typedef struct trial {
    tr_bed *bed;
    double below[TR_BED_POINTS + 1];
    double delta, P, x0, side, creep, most; /* most: mu P */
    bool sphere;
} trial;

/* 1 - (1 - q)^(1/p), all digits. */
static double used(bool sphere, double q) {
    double y = sphere ? tr_cbrt(1 - q) : sqrt(1 - q);
    return q / (1 + y + (sphere ? y * y : 0));
}

static double displaced(const trial *t, double w) {
    return t->x0 - t->side * t->creep * w;
}

static double pushed(const trial *t, double x, double *slope) {
    return tr_bed_trial(t->bed, t->below, t->delta, t->P, x, slope);
}

/* What is left at w, excess = mu P (1 - (1 - w)^p) - side Q, its slope by w, and the second one but for that of J. */
typedef struct attempt {
    double w, Q, excess, slope, bend;
} attempt;

static attempt try(const trial *t, double w) {
    double y = 1 - w, q = t->sphere ? w * (3 - w * (3 - w)) : w * (2 - w), dq = t->sphere ? 3 * y * y : 2 * y, slope;
    double Q = pushed(t, displaced(t, w), &slope);
    return (attempt){w, Q, t->most * q - t->side * Q, t->most * dq + t->creep * slope,
                     -t->most * (t->sphere ? 6 * y : 2)};
}

/* The root of excess in [0, 1], from the first attempt on. J is taken as straight, so that a parabola is left to be
 * solved: each time what is left of the error is its square. What leaves the bracket is halved. As slope > creep dQ/dx,
 * excess bounds the error of Q. From 1e-8 mu P a last step leaves rounding, of disks; a cubic near full slip is not its
 * parabola. */
static double root(const trial *t, attempt now) {
    double a = 0, b = 1;
    if (tr_bed_slips(t->bed, t->delta, displaced(t, 1), t->side)) return 1;
    for (int n = 0; n < 100; n++) {
        double f = now.excess, next = now.w - 2 * f / (now.slope + sqrt(now.slope * now.slope - 2 * now.bend * f));
        if (f < 0)
            a = now.w;
        else
            b = now.w;
        if (fabs(f) <= (t->sphere ? 1e-12 : 1e-8) * t->most) return fmin(fmax(next, a), b);
        double w = next > a && next < b ? next : 0.5 * (a + b);
        if (w <= a || w >= b) return a;
        now = try(t, w);
    }
    return a;
}

/* The weight of the end of the step; next terms are z^5/30240. */
static double weight(double z) {
    return z > 0.05 ? -1 / tr_expm1(-z) - 1 / z : 0.5 + z / 12 * (1 - z * z / 60);
}

static double displacement(tr_bed *bed, const tr_tile *tile, const tr_law_data *data, int i) {
    const tr_creep_par *p = data->par;
    double slide = tile->v_s[i] * tile->dt, roll = tr_creep_roll(p, tile, i), P = tile->f_elastic[i], slope;
    if (!(roll > 0)) return slide;
    bool sphere = data->shape == TR_SHAPE_SPHERE;
    trial t = {.bed = bed, .delta = tile->delta[i], .P = P, .most = p->bed.mu * P, .sphere = sphere};
    double power = sphere ? 3 : 2, before = tr_bed_force(bed, t.below), P_before = bed->n ? bed->P[bed->n - 1] : P;
    double most_before = p->bed.mu * P_before;
    double creep_before = greatest_creep(p, data->shape, bed->R1, bed->R2, P_before) * roll;
    if (!(creep_before > 0 && most_before > 0)) return slide;
    double w = used(sphere, fabs(before) / most_before), y = 1 - w;
    double k = data->normal->slope(data->normal_par, t.delta, P) / bed->kappa;
    double theta = weight(k / most_before * (creep_before / (power * (sphere ? y * y : y))));
    double creep = greatest_creep(p, data->shape, bed->R1, bed->R2, P) * roll;
    t.side = before < 0 ? -1 : 1;
    t.x0 = slide - t.side * (1 - theta) * creep_before * w;
    t.creep = theta * creep;
    attempt now = try(&t, w);
    if (!(t.side * now.Q > 0)) { /* else, as J rises with x, J(x0) has that side too */
        double first = pushed(&t, t.x0, &slope);
        if (first * before < 0) { /* only then creep may turn it over */
            double without = pushed(&t, slide, &slope);
            if (first * without < 0) t.creep = creep, t.x0 = slide, first = without;
        }
        if (first == 0) return t.x0;
        t.side = first < 0 ? -1 : 1;
        now = try(&t, w);
    }
    return displaced(&t, root(&t, now));
}

static void step(tr_tile *tile, const tr_law_data *data) {
    tr_bed_step(tile, data, displacement);
}

static void creep(const tr_tile *tile, const tr_law_data *data, double *u) {
    const tr_creep_par *p = data->par;
    bool sphere = data->shape == TR_SHAPE_SPHERE;
    for (int i = 0; i < tile->n; i++) {
        double P = tile->f_elastic[i], q = P > 0 ? fmin(1, fabs(tile->f_t[i]) / (p->bed.mu * P)) : 0;
        double F = used(sphere, q) * greatest_creep(p, data->shape, tile->R1[i], tile->R2[i], P);
        u[i] = copysign(F * tr_creep_roll(p, tile, i), tile->f_t[i]);
    }
}

const tr_law tr_friction_kuhn_creep = {
    .table = {"kuhn-creep", "cattaneo-mindlin that creeps while the bodies roll", params,
              .n = sizeof params / sizeof *params},
    .source = "[Kuhn2014 eq. 16] [Kalker1967] [Carter1926]",
    .formula = "dQ = C^-1(Vs dt - sgn(Q) F(|Q|/(mu P)) |du_roll|), C^-1: cattaneo-mindlin\n"
               "spheres: F(q) = 4 mu a/((1 - nu) C11 R) (1 - (1 - q)^(1/3)), a = cbrt(3 P R/(4 E_star))\n"
               "disks: F(q) = (mu a/R) (1 - sqrt(1 - q)), a = sqrt(4 P R/(pi E_star)), 1/R = 1/R1 + 1/R2\n"
               "C11 linear between 3.40, 4.12, 5.20 at nu = 0, 0.25, 0.5; steps of second order",
    .differs = "Eqs. 10, 16 and 17 are printed for equal spheres, 1/R = 2/R1. Disks creep by Carter's function.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = TR_BED_HIST,
    .needs = TR_ELASTIC_P,
    .merged = 2,
    .slip = TR_SLIPS_TRAILING,
    .step = step,
    .state = tr_bed_state,
    .creep = creep,
    .stiffness = tr_bed_stiffness,
};
