/* SPDX-License-Identifier: MIT */
/* Which numbers of a case are looked at. */
#ifndef TR_STUDY_CONVERGE_NUMBERS_H
#define TR_STUDY_CONVERGE_NUMBERS_H

#include "study/converge_data.h"

/* Those of options->of, or the usual ones of the kind. TR_BAD_CASE: there is no such number; all that are there are
 * listed. */
bool tr_converge_choose(tr_converge *c, tr_status *st);

/* The size of a number, by which rounding is judged: a speed that should be 0 is small beside the others. */
double tr_converge_scale(const tr_converge *c, int number, double value);

/* What a search leaves open, whatever the settings: a slope from which a disk moves [rad]. Else 0. */
double tr_converge_grain(const tr_converge *c, int number);

#endif
