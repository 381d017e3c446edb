/* SPDX-License-Identifier: MIT */
/* To add a lever, a factor or a mistake that codes make, add a row. Definitions and arms are those of the tables of
 * laws/, which come first. */
#include "study/identify_forms.h"

#include "base/alloc.h"
#include "laws/kinematics.h"
#include "laws/law.h"
#include "base/math.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- levers: the plainest first, for equal ones go by the first name */

#define LEVER(function, expression)                                                                                    \
    static double function(double R1, double R2, double L) {                                                           \
        bool wall = isinf(R1);                                                                                         \
        (void)R2, (void)L, (void)wall;                                                                                 \
        return expression;                                                                                             \
    }
#define OVERLAP (R1 + R2 - L)
LEVER(reduced, wall ? R2 : R1 *R2 / (R1 + R2))
LEVER(harmonic, wall ? 2 * R2 : 2 * R1 * R2 / (R1 + R2))
LEVER(smaller, fmin(R1, R2))
LEVER(larger, wall ? NAN : fmax(R1, R2))
LEVER(mean, wall ? NAN : (R1 + R2) / 2)
LEVER(product, wall ? NAN : R1 *R2)
LEVER(geometric, wall ? NAN : sqrt(R1 *R2))
LEVER(first, wall ? NAN : R1)
LEVER(second, R2)
LEVER(sum, wall ? NAN : R1 + R2)
LEVER(distance, wall ? NAN : L)
LEVER(middle, wall ? R2 - (R2 - L) : (R1 - OVERLAP / 2) * (R2 - OVERLAP / 2) / L)
LEVER(stretched_at_wall, wall ? R2 *(R2 + L) / (2 * L) : NAN)
LEVER(half_at_wall, wall ? (R2 + L) / 2 : NAN)
LEVER(shared, wall ? NAN : R1 *R2 *L / ((R1 + R2) * (R1 + R2)))

const tr_lever tr_levers[] = {
    {"R_eff = R1R2/(R1+R2)", reduced},
    {"2R1R2/(R1+R2) (harmonic mean)", harmonic},
    {"min(R1,R2)", smaller},
    {"max(R1,R2)", larger},
    {"(R1+R2)/2", mean},
    {"R1R2", product},
    {"sqrt(R1R2)", geometric},
    {"R1", first},
    {"R2", second},
    {"R1+R2", sum},
    {"|X21|", distance},
    {"(R1-overlap/2)(R2-overlap/2)/|X21|", middle},
    {"R1R2|X21|/(R1+R2)^2", shared},
    {"R2 - overlap/2", half_at_wall},
    {"R2 (R2-overlap/2)/|X21|", stretched_at_wall},
};
const int tr_n_levers = sizeof tr_levers / sizeof *tr_levers;

const tr_factor tr_factors[] = {{1, ""}, {2, "factor 2"}, {0.5, "factor 1/2"}, {4, "factor 4"}, {0.25, "factor 1/4"}};
const int tr_n_factors = sizeof tr_factors / sizeof *tr_factors;

const tr_factor tr_unit_factors[] = {
    {1e3, "1000, as of mm"}, {1e-3, "1/1000, as of km"},
    {1e2, "100, as of cm"},  {1e6, "1e6, as of mm^2"},
    {1e-6, "1e-6"},          {180 / M_PI, "180/pi, as of degrees"},
    {M_PI / 180, "pi/180"},  {0.5 / M_PI, "1/(2 pi), as of turns"},
    {2 * M_PI, "2 pi"},      {30 / M_PI, "30/pi, as of turns a minute"},
};
const int tr_n_unit_factors = sizeof tr_unit_factors / sizeof *tr_unit_factors;

/* ---- definitions that are in no author's text: mistakes */

typedef struct seen {
    double R1, R2, w1, w2, Vt, L, s1, s2;
    double lost; /* half the overlap */
} seen;
typedef struct extra {
    const char *name, *formula;
    bool angle;
    double (*of)(const seen *m);      /* of two disks; NULL: not there */
    double (*at_wall)(const seen *m); /* the same */
} extra;

#define EXTRA(function, expression)                                                                                    \
    static double function(const seen *m) {                                                                            \
        return expression;                                                                                             \
    }
EXTRA(rims, 0.5 * (m->R1 * m->w1 - m->R2 * m->w2))
EXTRA(rim_1, m->s1)
EXTRA(rim_2, m->s2)
EXTRA(only_w1, m->w1)
EXTRA(only_w2, -m->w2)
EXTRA(spin_sum, m->w1 + m->w2)
EXTRA(only_Vt, m->Vt)
EXTRA(only_spins, m->R1 * m->w1 + m->R2 * m->w2)
EXTRA(against_spins, m->Vt - m->R1 * m->w1 - m->R2 * m->w2)
EXTRA(unlike_spins, m->Vt + m->R1 * m->w1 - m->R2 * m->w2)
EXTRA(twice_shared, m->Vt + 2 * m->L / (m->R1 + m->R2) * (m->R1 * m->w1 + m->R2 * m->w2))
EXTRA(twice_midpoint, m->Vt + (2 * m->R1 - m->lost) * m->w1 + (2 * m->R2 - m->lost) * m->w2)
EXTRA(wall_half, m->Vt + (m->R2 - m->lost) * m->w2)
EXTRA(wall_half_arm, m->R2 - m->lost)
EXTRA(twice_1, 2 * m->R1 - m->lost)
EXTRA(twice_2, 2 * m->R2 - m->lost)
EXTRA(whole_overlap_1, m->R1 - (m->R1 + m->R2 - m->L))
EXTRA(whole_overlap_2, m->R2 - (m->R1 + m->R2 - m->L))
EXTRA(half_1, m->L / 2)

static const extra rolling_extras[] = {
    {"spins of the rims", "(R1 w1 - R2 w2)/2, without the spin of the line of centres", false, rims, NULL},
    {"rim 1", "s1", false, rim_1, NULL},
    {"rim 2", "s2", false, rim_2, NULL},
    {"w1 alone", "w1", true, only_w1, NULL},
    {"w2 alone", "-w2", true, only_w2, NULL},
    {"w1+w2", "w1+w2", true, spin_sum, NULL},
};
static const extra sliding_extras[] = {
    {"translation alone", "Vt, without the spins", false, only_Vt, NULL},
    {"spins alone", "R1 w1 + R2 w2, without the translation", false, only_spins, NULL},
    {"spins taken off", "Vt - R1 w1 - R2 w2", false, against_spins, NULL},
    {"spins unlike", "Vt + R1 w1 - R2 w2", false, unlike_spins, NULL},
    {"wang, diameters for radii in the arms", "Vt + 2 (r1 w1 + r2 w2)", false, twice_shared, NULL},
    {"midpoint, diameters for radii in the arms", "Vt + (2R1 - overlap/2) w1 + (2R2 - overlap/2) w2", false,
     twice_midpoint, NULL},
    {"half of the overlap", "Vt + (R2 - overlap/2) w2", false, NULL, wall_half},
};
enum { ARM_EXTRAS = 4 };
static const extra arm_extras[2][ARM_EXTRAS] = {
    {{"R_i - overlap", "R_i - overlap", false, whole_overlap_1, NULL},
     {"|X21|/2", "|X21|/2", false, half_1, NULL},
     {"midpoint, diameters for radii", "2R_i - overlap/2", false, twice_1, NULL},
     {"half of the overlap", "R2 - overlap/2", false, NULL, NULL}},
    {{"R_i - overlap", "R_i - overlap", false, whole_overlap_2, NULL},
     {"|X21|/2", "|X21|/2", false, half_1, NULL},
     {"midpoint, diameters for radii", "2R_i - overlap/2", false, twice_2, NULL},
     {"half of the overlap", "R2 - overlap/2", false, NULL, wall_half_arm}},
};
enum { ARMS_ALONE = 3 }; /* rows of tr_arms_rows whose torque arms differ */

static int from_table(tr_family f) {
    return f == TR_FAMILY_ROLLING   ? tr_n_rolling_measures
           : f == TR_FAMILY_SLIDING ? tr_n_sliding_measures
           : f == TR_FAMILY_CAP     ? 0
                                    : ARMS_ALONE;
}

#define COUNT(array) (int)(sizeof(array) / sizeof *(array))
int tr_forms_definitions(tr_family f) {
    static const int extras[] = {COUNT(rolling_extras), COUNT(sliding_extras), ARM_EXTRAS, ARM_EXTRAS, 1};
    return from_table(f) + extras[f];
}

static const extra *extra_of(tr_family f, int k) {
    static const extra one = {"", "", false, NULL, NULL}; /* of a cap, which is its lever */
    k -= from_table(f);
    return f == TR_FAMILY_ROLLING   ? &rolling_extras[k]
           : f == TR_FAMILY_SLIDING ? &sliding_extras[k]
           : f == TR_FAMILY_CAP     ? &one
                                    : &arm_extras[f - TR_FAMILY_ARM_1][k];
}

const char *tr_forms_name(tr_family f, int k) {
    if (k >= from_table(f)) return extra_of(f, k)->name;
    return f == TR_FAMILY_ROLLING   ? tr_rolling_velocities[k].name
           : f == TR_FAMILY_SLIDING ? tr_sliding_velocities[k].name
                                    : tr_arms_rows[k].name;
}

const char *tr_forms_formula(tr_family f, int k) {
    if (k >= from_table(f)) return extra_of(f, k)->formula;
    return f == TR_FAMILY_ROLLING   ? tr_rolling_velocities[k].formula
           : f == TR_FAMILY_SLIDING ? tr_sliding_velocities[k].formula
                                    : tr_arms_rows[k].formula;
}

bool tr_forms_is_angle(tr_family f, int k) {
    if (k >= from_table(f)) return extra_of(f, k)->angle;
    return f == TR_FAMILY_ROLLING && tr_rolling_velocities[k].claims & TR_DEFINES_ANGLE;
}

/* The tables say so in the formula. */
bool tr_forms_repeats(tr_family f, int k) {
    if (k >= from_table(f)) return false;
    const tr_velocity_measure *m = f == TR_FAMILY_ROLLING   ? &tr_rolling_velocities[k]
                                   : f == TR_FAMILY_SLIDING ? &tr_sliding_velocities[k]
                                                            : NULL;
    return m && strstr(m->formula, ": =");
}

/* ---- states */

static tr_motion with_radii(tr_motion m, int radii) {
    double R1 = m.R1;
    if (radii == TR_RADII_EXCHANGED && !isinf(R1)) m.R1 = m.R2, m.R2 = R1;
    if (radii == TR_RADII_DIAMETERS) m.R1 *= 2, m.R2 *= 2;
    return m;
}

bool tr_states_make(tr_states *s, const tr_motion *motion, int n, tr_status *st) {
    *s = (tr_states){.n = n};
    tr_motion *other = tr_alloc((size_t)n, sizeof *other, st);
    s->motion = tr_alloc((size_t)n, sizeof *s->motion, st);
    s->length = tr_alloc((size_t)n, sizeof *s->length, st);
    bool ok = other && s->motion && s->length;
    for (int i = 0; ok && i < n; i++) {
        s->motion[i] = motion[i];
        s->length[i] = tr_hypot(motion[i].x2x - motion[i].x1x, motion[i].x2y - motion[i].x1y);
    }
    for (int k = 0; ok && k < TR_N_RADII; k++) {
        for (int i = 0; i < n; i++) other[i] = with_radii(motion[i], k);
        s->measures[k] = tr_alloc((size_t)n, sizeof *s->measures[k], st);
        ok = s->measures[k] && tr_measures_motions(other, n, s->measures[k], st);
    }
    free(other);
    return ok;
}

void tr_states_free(tr_states *s) {
    free(s->motion), free(s->length);
    for (int k = 0; k < TR_N_RADII; k++) free(s->measures[k]);
    *s = (tr_states){0};
}

static double definition_value(const tr_form *form, const tr_states *s, int i) {
    const tr_motion_measures *m = &s->measures[form->radii][i];
    int k = form->definition;
    if (form->family == TR_FAMILY_CAP) return 1;
    if (k < from_table(form->family))
        return form->family == TR_FAMILY_ROLLING   ? m->rolling[k]
               : form->family == TR_FAMILY_SLIDING ? m->sliding[k]
               : form->family == TR_FAMILY_ARM_1   ? m->arms[k].r1
                                                   : m->arms[k].r2;
    tr_motion of = with_radii(s->motion[i], form->radii);
    const extra *extra = extra_of(form->family, k);
    bool wall = isinf(of.R1);
    if (wall ? !extra->at_wall : !extra->of) return NAN;
    if (wall) of.R1 = 0, of.w2 -= of.w1, of.w1 = 0; /* as the wall sees it */
    double L = s->length[i], lost = 0.5 * ((wall ? 0 : s->motion[i].R1) + s->motion[i].R2 - L);
    const seen seen = {of.R1, of.R2, of.w1, of.w2, m->Vt, L, m->s1, m->s2, lost};
    return (wall ? extra->at_wall : extra->of)(&seen);
}

double tr_forms_value(const tr_form *form, const tr_states *s, int i) {
    double v = form->factor * definition_value(form, s, i);
    for (int k = 0; k < 2; k++)
        if (form->lever[k] >= 0) v *= tr_levers[form->lever[k]].of(s->motion[i].R1, s->motion[i].R2, s->length[i]);
    return v;
}

/* ---- words */

static const char *factor_words(double factor, char *to, size_t size) {
    for (int k = 0; k < tr_n_factors; k++)
        if (factor == tr_factors[k].value) return tr_factors[k].words;
    for (int k = 0; k < tr_n_unit_factors; k++)
        if (fabs(factor / tr_unit_factors[k].value - 1) < 1e-3) {
            snprintf(to, size, "factor %s", tr_unit_factors[k].words);
            return to;
        }
    snprintf(to, size, "factor %.6g", factor);
    return to;
}

const char *tr_forms_words(const tr_form *form, char to[TR_FORM_WORDS]) {
    static const char *const radii[] = {"", " with R1 and R2 exchanged", " with diameters for radii"};
    char number[48];
    const char *factor = factor_words(fabs(form->factor), number, sizeof number);
    const char *name = tr_forms_name(form->family, form->definition),
               *formula = tr_forms_formula(form->family, form->definition);
    bool angle = tr_forms_is_angle(form->family, form->definition), known = form->definition < from_table(form->family);
    size_t n = (size_t)snprintf(to, TR_FORM_WORDS, "%s", name);
    if (angle && known)
        n += (size_t)snprintf(to + n, TR_FORM_WORDS - n, " (%.*s)", (int)strcspn(formula, ":"), formula);
    n += (size_t)snprintf(to + n, TR_FORM_WORDS - n, "%s", radii[form->radii]);
    for (int k = 0; k < 2 && n < TR_FORM_WORDS; k++)
        if (form->lever[k] >= 0)
            n += (size_t)snprintf(to + n, TR_FORM_WORDS - n, "%s%s",
                                  !n  ? ""
                                  : k ? " x "
                                      : ", lever ",
                                  tr_levers[form->lever[k]].name);
    if (*factor && n < TR_FORM_WORDS) n += (size_t)snprintf(to + n, TR_FORM_WORDS - n, ", %s", factor);
    if (form->factor < 0 && n < TR_FORM_WORDS) snprintf(to + n, TR_FORM_WORDS - n, ", sign opposite");
    return to;
}
