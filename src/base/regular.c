/* SPDX-License-Identifier: MIT */
#include "base/regular.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

FILE *tr_regular_open(const char *path, tr_status *st) {
    struct stat info;
    int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC); /* a pipe without a writer does not wait */
    if (fd < 0 && errno == ENOENT) return NULL;
    if (fd >= 0 && !fstat(fd, &info) && !S_ISREG(info.st_mode)) {
        close(fd);
        return tr_status_fail(st, TR_FILE, "error: cannot read %.300s: not a regular file", path), NULL;
    }
    FILE *file = fd >= 0 ? fdopen(fd, "rb") : NULL;
    if (file) return file;
    tr_status_fail(st, TR_FILE, "error: cannot read %.300s: %s", path, strerror(errno));
    if (fd >= 0) close(fd);
    return NULL;
}
