/* SPDX-License-Identifier: MIT */
#include "verify/groups.h"

const tr_verification *tr_verification_at(int i) {
    if (i < tr_n_verify_exact) return &tr_verify_exact[i];
    i -= tr_n_verify_exact;
    if (i < tr_n_verify_precision) return &tr_verify_precision[i];
    i -= tr_n_verify_precision;
    return i < tr_n_verify_stability ? &tr_verify_stability[i] : NULL;
}
