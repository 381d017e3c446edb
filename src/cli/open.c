/* SPDX-License-Identifier: MIT */
#include "cli/cli.h"

#include <string.h>
#include <sys/stat.h>

bool tr_cli_open(tr_file *file, const char *path, tr_status *st) {
    struct stat info;
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    char dir[TR_PATH];
    if (!*name) return tr_status_fail(st, TR_FILE, "error: -o needs the name of a file, not \"%.200s\"", path);
    /* The file is put in place by renaming, which would replace a device. */
    if (!stat(path, &info) && !S_ISREG(info.st_mode))
        return tr_status_fail(st, TR_FILE, "error: cannot write %.200s: not a regular file", path);
    if (snprintf(dir, sizeof dir, "%.*s", slash ? (int)(slash - path) : 1, slash ? path : ".") >= (int)sizeof dir)
        return tr_status_fail(st, TR_FILE, "error: path too long: %.200s...", path);
    return tr_file_open(file, dir, name, st);
}
