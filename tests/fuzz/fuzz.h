/* SPDX-License-Identifier: MIT */
/* What the fuzz targets share. A target is one file with one LLVMFuzzerTestOneInput. `make fuzz` builds it with clang's
 * libFuzzer; `make test` builds it with replay.c in the place of libFuzzer and feeds it the inputs of corpus/. */
#ifndef FUZZ_H
#define FUZZ_H

#include "out/dir.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A folder in the present one. Who starts the target starts it in a folder of its own, in memory where there is one. */
static inline const char *fuzz_dir(void) {
    static bool made;
    tr_status st = {0};
    if (!made && !tr_dir_make("work", ".", &st)) abort();
    made = true;
    return "work";
}

/* Writes dir/name, without a list of files. */
static inline const char *fuzz_file(const char *name, const void *data, size_t size) {
    static char path[TR_PATH];
    snprintf(path, sizeof path, "%s/%s", fuzz_dir(), name);
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(data, 1, size, file) != size || fclose(file)) abort();
    return path;
}

/* An input holds several parts with a NUL byte between them. Part k, or an empty one. */
static inline size_t fuzz_part(const uint8_t *data, size_t size, int k, const uint8_t **part) {
    const uint8_t *end = data + size;
    for (; k; k--) {
        const uint8_t *nul = data < end ? memchr(data, 0, (size_t)(end - data)) : NULL;
        data = nul ? nul + 1 : end;
    }
    const uint8_t *nul = data < end ? memchr(data, 0, (size_t)(end - data)) : NULL;
    *part = data;
    return (size_t)((nul ? nul : end) - data);
}

#endif
