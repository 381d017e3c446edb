/* SPDX-License-Identifier: MIT */
#include "core/shares_memory.h"

#include <stdlib.h>

void tr_shares_free(tr_shares *s) {
    if (!s) return;
    for (int k = 0; k < s->threads; k++) free(s->part[k].late);
    free(s->owner), free(s->sums), free(s->part), free(s);
}

size_t tr_shares_bytes(const tr_shares *s, int n) {
    if (!s) return 0;
    size_t bytes = sizeof *s + (size_t)n * sizeof *s->owner + (size_t)s->n_sums * sizeof *s->sums;
    for (int k = 0; k < s->threads; k++) bytes += sizeof *s->part + (size_t)s->part[k].capacity * sizeof(tr_share_late);
    return bytes;
}
