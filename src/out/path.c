/* SPDX-License-Identifier: MIT */
#include "out/path.h"

#include <stdio.h>

bool tr_dir_path(char path[TR_PATH], const char *dir, const char *name, tr_status *st) {
    if (snprintf(path, TR_PATH, "%s/%s", dir, name) < TR_PATH) return true;
    return tr_status_fail(st, TR_FILE, "error: path too long: %.200s...", dir);
}
