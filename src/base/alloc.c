/* SPDX-License-Identifier: MIT */
#include "base/alloc.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 64 };

void *tr_alloc(size_t n, size_t size, tr_status *st) {
    if (n == 0) n = 1;
    void *p = NULL;
    if (n <= (SIZE_MAX - LINE) / size) {
        size_t bytes = (n * size + LINE - 1) / LINE * LINE;
        p = aligned_alloc(LINE, bytes);
        if (p) memset(p, 0, bytes);
    }
    if (!p) tr_status_fail(st, TR_FILE, "error: out of memory (%zu objects of %zu bytes)", n, size);
    return p;
}

bool tr_alloc_grow(void *array, size_t old_n, size_t new_n, size_t size, tr_status *st) {
    void *old, *grown = tr_alloc(new_n, size, st);
    if (!grown) return false;
    memcpy(&old, array, sizeof old); /* array is a pointer to some T*: copy it as bytes, T is not known here */
    if (old) memcpy(grown, old, old_n * size);
    free(old);
    memcpy(array, &grown, sizeof grown);
    return true;
}
