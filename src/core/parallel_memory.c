/* SPDX-License-Identifier: MIT */
#include "core/parallel_memory.h"

#include <stdlib.h>

void tr_parallel_free(tr_parallel *s) {
    if (!s) return;
    for (int k = 0; k < s->threads; k++) free(s->part[k].late);
    free(s->owner), free(s->sums), free(s->part), free(s);
}

size_t tr_parallel_bytes(const tr_parallel *s, int n) {
    if (!s) return 0;
    size_t bytes = sizeof *s + (size_t)n * sizeof *s->owner + (size_t)s->n_sums * sizeof *s->sums;
    for (int k = 0; k < s->threads; k++)
        bytes += sizeof *s->part + (size_t)s->part[k].capacity * sizeof(tr_parallel_deferred);
    return bytes;
}
