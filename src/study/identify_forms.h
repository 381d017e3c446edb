/* SPDX-License-Identifier: MIT */
/* What a code may have answered: definition x radii x lever x factor. Tables of each, and their values on states. */
#ifndef TR_STUDY_IDENTIFY_FORMS_H
#define TR_STUDY_IDENTIFY_FORMS_H

#include "study/measures.h"

/* What an answer is: which table its definitions are of. */
typedef enum tr_family {
    TR_FAMILY_ROLLING,
    TR_FAMILY_SLIDING,
    TR_FAMILY_ARM_1,
    TR_FAMILY_ARM_2,
    TR_FAMILY_CAP
} tr_family;

/* Radii that a code took for its definition. */
typedef enum tr_radii { TR_RADII, TR_RADII_EXCHANGED, TR_RADII_DIAMETERS, TR_N_RADII } tr_radii;

typedef struct tr_form {
    tr_family family;
    int definition; /* of its family */
    int radii;      /* tr_radii */
    int lever[2];   /* rows of tr_levers; -1: none */
    double factor;  /* with its sign */
} tr_form;

/* Motions, and all that forms need of them. */
typedef struct tr_states {
    int n;
    tr_motion *motion;
    double *length; /* |X21| [m] */
    tr_motion_measures *measures[TR_N_RADII];
} tr_states;

/* Copies n motions. Free it, also after a failure. */
bool tr_states_make(tr_states *s, const tr_motion *motion, int n, tr_status *st);
void tr_states_free(tr_states *s);

/* A length that turns a force into a moment, or an angle into a way. NAN where there is none, as R1 at a wall. */
typedef struct tr_lever {
    const char *name;
    double (*of)(double R1, double R2, double L);
} tr_lever;
extern const tr_lever tr_levers[];
extern const int tr_n_levers;

/* Constants that a code may be off by. */
typedef struct tr_factor {
    double value;
    const char *words;
} tr_factor;
extern const tr_factor tr_factors[], tr_unit_factors[]; /* plain numbers; units that do not fit */
extern const int tr_n_factors, tr_n_unit_factors;

int tr_forms_definitions(tr_family family);
const char *tr_forms_name(tr_family family, int definition);
const char *tr_forms_formula(tr_family family, int definition);
bool tr_forms_is_angle(tr_family family, int definition); /* w1 - w2: it may stand with a lever in a velocity */
bool tr_forms_repeats(tr_family family, int definition);  /* another before it is the same but for a factor */
double tr_forms_value(const tr_form *form, const tr_states *s, int i); /* NAN: has none there */

/* "2 x bagi-kuhn with R1 and R2 exchanged, lever R1R2/(R1+R2)". */
enum { TR_FORM_WORDS = 240 };
const char *tr_forms_words(const tr_form *form, char to[TR_FORM_WORDS]);

#endif
