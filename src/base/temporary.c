/* SPDX-License-Identifier: MIT */
/* Part files: see temporary.h. */
#include "base/temporary.h"

#include "base/alloc.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>

char *tr_temporary_name(const char *path, tr_status *st) {
    size_t size = strlen(path) + sizeof ".part";
    char *name = tr_alloc(size, 1, st);
    if (name) snprintf(name, size, "%s.part", path);
    return name;
}

bool tr_temporary_rename(const char *part, const char *path, tr_status *st) {
    if (rename(part, path) == 0) return true;
    int error = errno;
    remove(part);
    return tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", path, strerror(error));
}
