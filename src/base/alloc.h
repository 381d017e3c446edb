/* SPDX-License-Identifier: MIT */
/* Checked allocation: zeroed, aligned to a cache line (64 bytes) so that passes load whole vectors. */
#ifndef TR_ALLOC_H
#define TR_ALLOC_H

#include "base/status.h"
#include <stddef.h>

/* n objects of size bytes, all zero; NULL and TR_FILE in st when memory is short or n*size overflows. n = 0 gives one
 * object, so that NULL always means failure. Free with free(). */
void *tr_alloc(size_t n, size_t size, tr_status *st);

/* Makes *array (old_n objects) hold new_n >= old_n objects; the old ones are kept, the new ones are zero.
 * On failure *array is unchanged. */
bool tr_alloc_grow(void *array, size_t old_n, size_t new_n, size_t size, tr_status *st);

#endif
