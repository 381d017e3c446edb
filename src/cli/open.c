/* SPDX-License-Identifier: MIT */
#include "cli/open.h"

#include "out/manifest.h"
#include <string.h>
#include <sys/stat.h>

bool tr_cli_open(tr_file *file, const char *path, const char *input, tr_status *st) {
    struct stat info;
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    if (!*name) return tr_status_fail(st, TR_FILE, "error: -o needs the name of a file, not \"%.200s\"", path);
    /* The file is put in place by renaming, which would replace a device. */
    if (!stat(path, &info) && !S_ISREG(info.st_mode))
        return tr_status_fail(st, TR_FILE, "error: cannot write %.200s: not a regular file", path);
    return tr_manifest_differ(path, input, st) && tr_file_open_path(file, path, st);
}
