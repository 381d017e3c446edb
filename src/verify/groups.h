/* SPDX-License-Identifier: MIT */
/* The registry: one table per group, in a file of its own. */
#ifndef TR_VERIFY_GROUPS_H
#define TR_VERIFY_GROUPS_H

#include "verify/verify.h"

extern const tr_verification tr_verify_exact[], tr_verify_precision[], tr_verify_stability[];
extern const int tr_n_verify_exact, tr_n_verify_precision, tr_n_verify_stability;

/* Number i over all groups; NULL: no more. */
const tr_verification *tr_verification_at(int i);

#endif
