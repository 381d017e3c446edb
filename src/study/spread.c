/* SPDX-License-Identifier: MIT */
#include "study/spread.h"
#include "base/math.h"

#include "base/student.h"
#include "laws/law.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct spread {
    int disks;
    double mu_r;
    const char *friction;
    double I;
    int seeds;
    double s[2]; /* of the peak and of the residual of sin phi */
} spread;

/* Measured by `make spread` (figures/spread/spread.sh), version 0.3.0; rows of coulomb-spring were also measured with
 * 0.2.0: the same. */
static const spread rows[] = {
    {100, 0, "coulomb-spring", 1e-3, 64, {0.03621, 0.05756}},
    {100, 0, "coulomb-spring", 3e-3, 64, {0.03981, 0.05040}},
    {100, 0, "dahlberg-alfredsson", 1e-3, 64, {0.03559, 0.06066}},
    {100, 0, "dahlberg-alfredsson", 3e-3, 64, {0.03863, 0.05738}},
    {100, 0.5, "coulomb-spring", 1e-3, 64, {0.03899, 0.08462}},
    {100, 0.5, "coulomb-spring", 3e-3, 64, {0.04017, 0.07774}},
    {100, 0.5, "dahlberg-alfredsson", 1e-3, 64, {0.04051, 0.09869}},
    {100, 0.5, "dahlberg-alfredsson", 3e-3, 64, {0.03761, 0.09288}},
    {400, 0, "coulomb-spring", 1e-3, 32, {0.02510, 0.02116}},
    {400, 0, "coulomb-spring", 3e-3, 32, {0.02220, 0.02626}},
    {400, 0, "dahlberg-alfredsson", 1e-3, 32, {0.02349, 0.02453}},
    {400, 0, "dahlberg-alfredsson", 3e-3, 32, {0.02168, 0.02757}},
    {400, 0.5, "coulomb-spring", 1e-3, 32, {0.02501, 0.04004}},
    {400, 0.5, "coulomb-spring", 3e-3, 32, {0.02552, 0.05684}},
    {400, 0.5, "dahlberg-alfredsson", 1e-3, 32, {0.02631, 0.04836}},
    {400, 0.5, "dahlberg-alfredsson", 3e-3, 32, {0.02475, 0.04545}},
    {1600, 0, "coulomb-spring", 1e-3, 8, {0.01021, 0.01378}},
    {1600, 0, "coulomb-spring", 3e-3, 8, {0.01324, 0.02351}},
    {1600, 0, "dahlberg-alfredsson", 1e-3, 8, {0.01078, 0.01372}},
    {1600, 0, "dahlberg-alfredsson", 3e-3, 8, {0.01282, 0.03491}},
    {1600, 0.5, "coulomb-spring", 1e-3, 8, {0.00945, 0.02029}},
    {1600, 0.5, "coulomb-spring", 3e-3, 8, {0.01431, 0.02632}},
    {1600, 0.5, "dahlberg-alfredsson", 1e-3, 8, {0.01123, 0.03318}},
    {1600, 0.5, "dahlberg-alfredsson", 3e-3, 8, {0.01432, 0.04515}},
};
enum { N_ROWS = sizeof rows / sizeof *rows };

/* The same: sin phi with half the step less that with the step (mean and standard error over the seeds, of 400 disks at
 * I = 3e-3; all four pairs of mu_r and friction are in the mean). */
static const struct {
    int seeds;
    double change, error;
} half_step[2] = {{32, 0.00089, 0.00093}, {32, -0.00043, 0.00386}};

static const double NEAR = 1.1; /* it is not known how far the numbers hold outside of the measured case */

static bool is_near(double value, double measured) {
    return value == measured || (value >= measured / NEAR && value <= measured * NEAR);
}

/* A law of the shear: at first the world has the laws of the compaction. */
typedef struct chosen {
    const tr_law *law;
    const double *par;
} chosen;

static double law_value(const chosen *of, const char *key) {
    const double *value = tr_law_value(of->law, of->par, key);
    return value ? *value : 0;
}

static void choose(const tr_scene *s, chosen slot[TR_N_LAW_KINDS]) {
    slot[TR_NORMAL] = (chosen){tr_laws_normal[s->contact.normal.law], s->contact.normal.par};
    slot[TR_FRICTION] = (chosen){tr_laws_friction[s->contact.friction.law], s->contact.friction.par};
    slot[TR_ROLLING] = (chosen){tr_laws_rolling[s->contact.rolling.law], s->contact.rolling.par};
}

/* A key of the case, its value as a number, and the measured value. */
typedef struct item {
    const char *key;
    double value, measured;
} item;

/* The first key that differs from the measured case; NULL: none. */
static const item *elsewhere(const tr_biaxial *b, item *list) {
    const tr_scene *s = b->scene;
    chosen slot[TR_N_LAW_KINDS];
    choose(s, slot);
    const chosen *normal = &slot[TR_NORMAL], *friction = &slot[TR_FRICTION], *rolling = &slot[TR_ROLLING];
    double k_n = law_value(normal, "k_n"), k_t = law_value(friction, "k_t"), mu_r = law_value(rolling, "mu_r");
    bool linear = !strcmp(normal->law->table.name, "linear"), rolls = mu_r > 0;
    bool spring = !strcmp(rolling->law->table.name, "wang-spring") || rolling->law == &tr_rolling_none;
    bool creeps = tr_law_value(friction->law, friction->par, "E_star");
    const int *creep_roll = tr_law_choice(friction->law, friction->par, "creep_roll");
    const item all[] = {
        {"shape", s->shape, TR_SHAPE_DISK},
        {"boundary", s->boundary, TR_WALLS},
        {"shear.walls", s->shear.walls, 0},
        {"contact.normal", linear, 1},
        {"contact.rolling", spring, 1},
        {"contact.rolling_velocity", rolls ? s->contact.rolling_velocity : 0, 0},
        {"contact.arms", s->contact.arms, 0},
        {"sample.file", *s->sample.file != 0, 0},
        {"contact.creep_roll", creep_roll ? *creep_roll : 1, 1}, /* wang */
        {"sample.r_max/sample.r_min", *s->sample.file ? 2 : s->sample.r_max / s->sample.r_min, 2},
        {"contact.k_n/compaction.pressure", k_n / s->compaction.pressure, 1000},
        {"shear.lateral_pressure/compaction.pressure", s->shear.lateral_pressure / s->compaction.pressure, 1},
        {"contact.damping_ratio", law_value(normal, "damping_ratio"), 0.3},
        {"contact.mu", law_value(friction, "mu"), 0.5},
        {"contact.k_t/contact.k_n", k_t / k_n, creeps ? 1 : 0.5},
        {"contact.k_r/contact.k_n", rolls ? law_value(rolling, "k_r") / k_n : 0.5, 0.5},
        {"contact.E_star/contact.k_n", creeps ? law_value(friction, "E_star") / k_n : 2.3, 2.3},
        {"compaction.mu", s->compaction.mu, 0},
        {"compaction.inertial_number", s->compaction.inertial_number, 1e-2},
        {"compaction.unbalanced", s->compaction.unbalanced, 1e-4},
        {"shear.strain_end", s->shear.strain_end, 0.2},
        {"time step over its bound", b->dt / b->dt_bound, 0.4},
        {"output.rows", fmin(s->output.rows, 200), 200}, /* the peak is a mean over 0.5 % of strain: 5 rows and more */
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (!is_near(all[i].value, all[i].measured)) return *list = all[i], list;
    return NULL;
}

/* The measured row of this law and mu_r that is nearest in log N and log I; NULL: the case is outside of their range.
 * Strict in N: 100 disks are in, 99 are not. */
static const spread *row_of(int disks, double mu_r, const char *friction, double I) {
    const spread *best = NULL;
    double nearest = INFINITY, low = INFINITY, high = 0;
    int few = 0, many = 0;
    for (int i = 0; i < N_ROWS; i++) {
        const spread *r = &rows[i];
        if (strcmp(r->friction, friction) != 0 || !is_near(mu_r, r->mu_r)) continue;
        double off = tr_hypot(tr_log((double)disks / r->disks), tr_log(I / r->I));
        if (off < nearest) nearest = off, best = r;
        low = fmin(low, r->I), high = fmax(high, r->I);
        if (!few || r->disks < few) few = r->disks;
        if (r->disks > many) many = r->disks;
    }
    bool inside = best && disks >= few && disks <= many && I >= low / NEAR && I <= high * NEAR;
    return inside ? best : NULL;
}

double tr_spread_half(double s, int seeds) {
    return tr_student_95(seeds - 1) * s;
}

double tr_spread_aim(double half) {
    double power = tr_pow(10, floor(tr_log10(half / 2))), digit = half / 2 / power;
    return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
}

int tr_spread_seeds(double half, double aim) {
    return (int)ceil(half / aim * (half / aim));
}

tr_accuracy tr_spread_of(const tr_biaxial *b) {
    tr_accuracy a = {0};
    chosen slot[TR_N_LAW_KINDS];
    choose(b->scene, slot);
    const char *friction = slot[TR_FRICTION].law->table.name;
    double mu_r = law_value(&slot[TR_ROLLING], "mu_r"), I = b->scene->shear.inertial_number;
    int disks = b->scene->sample.disks;
    const spread *row = row_of(disks, mu_r, friction, I);
    item other;
    if (!row)
        return snprintf(a.not_examined, sizeof a.not_examined,
                        "the table of spreads has no N = %d, mu_r = %g, %s, I = %g", disks, mu_r, friction, I),
               a;
    if (elsewhere(b, &other))
        return snprintf(a.not_examined, sizeof a.not_examined, "%s is not that of the measured case, to 10 %%",
                        other.key),
               a;
    double scale = sqrt((double)row->disks / disks);
    snprintf(a.row, sizeof a.row, "spread of %d seeds, N = %d%s, mu_r = %g, %s, I = %g", row->seeds, row->disks,
             disks == row->disks ? "" : " (times 1/sqrt(N))", row->mu_r, row->friction, row->I);
    for (int i = 0; i < 2; i++) {
        tr_strength_accuracy *one = &a.strength[i];
        one->half = tr_spread_half(row->s[i] * scale, row->seeds);
        one->aim = tr_spread_aim(one->half);
        one->seeds = tr_spread_seeds(one->half, one->aim);
        one->step = half_step[i].change;
        one->step_half = tr_student_95(half_step[i].seeds - 1) * half_step[i].error;
    }
    return a;
}
