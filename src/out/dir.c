/* SPDX-License-Identifier: MIT */
#include "out/dir.h"

#include "base/temporary.h"
#include "base/regular.h"
#include "out/manifest.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static bool make(const char *dir, tr_status *st) {
    char path[TR_PATH];
    if (!*dir || strlen(dir) >= sizeof path)
        return tr_status_fail(st, TR_FILE, "error: bad directory name \"%.200s\"", dir);
    strcpy(path, dir);
    for (char *p = path + 1;; p++) {
        char c = *p;
        if (c != '/' && c != '\0') continue;
        *p = '\0';
        if (mkdir(path, 0777) && errno != EEXIST)
            return tr_status_fail(st, TR_FILE, "error: cannot make directory %s: %s", path, strerror(errno));
        *p = c;
        if (!c) break;
    }
    struct stat info;
    if (stat(path, &info) || !S_ISDIR(info.st_mode))
        return tr_status_fail(st, TR_FILE, "error: %s is not a directory", path);
    return true;
}

bool tr_dir_lock(const char *dir, int *lock, tr_status *st) {
    const struct timespec pause = {.tv_nsec = 20000000};
    if (!make(dir, st)) return false;
    *lock = open(dir, O_RDONLY | O_DIRECTORY); /* not O_CLOEXEC: it is to be inherited */
    for (int k = 0; *lock >= 0 && flock(*lock, LOCK_EX | LOCK_NB); k++) {
        bool held = errno == EWOULDBLOCK || errno == EINTR;
        if (held && k < TR_DIR_WAIT * 50 && (nanosleep(&pause, NULL), true)) continue;
        close(*lock);
        *lock = -1;
        if (held) return tr_status_fail(st, TR_FILE, "error: another run writes into %s", dir);
    }
    return true;
}

bool tr_dir_make(const char *dir, const char *name, tr_status *st) {
    char path[TR_PATH];
    return tr_dir_path(path, dir, name, st) && make(path, st);
}

bool tr_dir_holds(const char *dir, const char *name, const char *text, bool *same, tr_status *st) {
    char path[TR_PATH];
    *same = false;
    if (!tr_dir_path(path, dir, name, st)) return false;
    FILE *file = tr_regular_open(path, st);
    if (!file) return !st->code;
    *same = true;
    while (*same && *text) *same = fgetc(file) == (unsigned char)*text++;
    *same = *same && fgetc(file) == EOF;
    if (ferror(file)) tr_status_fail(st, TR_FILE, "error: cannot read %s: %s", path, strerror(errno));
    fclose(file);
    return !st->code;
}

/* A file that is continued may have a second name, in a copy by hard links. It first gets its own inode. */
static bool unshare(const char *part, tr_status *st) {
    struct stat info;
    char copy[TR_PATH + 8], bytes[1 << 14];
    if (lstat(part, &info) || (S_ISREG(info.st_mode) && info.st_nlink == 1)) return true;
    FILE *from = tr_regular_open(part, st), *to = NULL;
    if (!from) return !st->code;
    snprintf(copy, sizeof copy, "%s.old", part);
    unlink(copy);
    bool ok = (to = fopen(copy, "wbxe")) != NULL;
    for (size_t n; ok && (n = fread(bytes, 1, sizeof bytes, from)) > 0;) ok = fwrite(bytes, 1, n, to) == n;
    ok = ok && !ferror(from) && !fflush(to) && !fsync(fileno(to));
    if (to) ok = !fclose(to) && ok;
    ok = ok && !rename(copy, part);
    if (!ok) tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", copy, strerror(errno));
    fclose(from);
    return ok;
}

static bool open_temporary(tr_file *file, const char *path, const char *mode, tr_status *st) {
    *file = (tr_file){0};
    if (strlen(path) >= sizeof file->path)
        return tr_status_fail(st, TR_FILE, "error: path too long: %.200s...", path);
    strcpy(file->path, path);
    if (!(file->part = tr_temporary_name(file->path, st))) return false;
    if (*mode == 'a' && access(file->part, F_OK)) rename(file->path, file->part);
    if (*mode != 'a' || unshare(file->part, st)) file->stream = fopen(file->part, mode);
    if (file->stream) return true;
    if (errno == EEXIST)
        tr_status_fail(st, TR_FILE, "error: %s has the name of a result; move it away", file->part);
    else
        tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", file->part, strerror(errno));
    free(file->part);
    return false;
}

bool tr_file_open_path(tr_file *file, const char *path, tr_status *st) {
    return open_temporary(file, path, "wx", st); /* a file with the name of the part is the user's */
}

bool tr_file_open(tr_file *file, const char *dir, const char *name, tr_status *st) {
    char path[TR_PATH];
    *file = (tr_file){0};
    return tr_dir_path(path, dir, name, st) && tr_manifest_add(dir, name, st) && open_temporary(file, path, "w", st);
}

bool tr_file_reopen(tr_file *file, const char *dir, const char *name, tr_status *st) {
    char path[TR_PATH];
    *file = (tr_file){0};
    if (!tr_dir_path(path, dir, name, st) || !tr_manifest_add(dir, name, st) || !open_temporary(file, path, "a", st))
        return false;
    fseek(file->stream, 0, SEEK_END);
    file->kept = ftell(file->stream); /* all of it, until the length is known */
    return true;
}

void tr_file_checkpoint(tr_file *file, tr_checkpoint *c) {
    if (!file->stream || c->st->code) return;
    bool ok = c->loading || (!fflush(file->stream) && !fsync(fileno(file->stream)));
    long length = ftell(file->stream);
    TR_KEEP(c, &length, 1);
    if (c->loading && length > file->kept)
        tr_status_fail(c->st, TR_FILE, "error: %s is shorter than the checkpoint says: %ld bytes of %ld", file->part,
                       file->kept, length);
    if (c->st->code) return;
    if (c->loading) ok = !ftruncate(fileno(file->stream), length) && !fseek(file->stream, 0, SEEK_END);
    if (!ok) tr_status_fail(c->st, TR_FILE, "error: cannot write %s: %s", file->path, strerror(errno));
    if (ok) file->kept = length;
}

static void drop(tr_file *file) {
    if (!file->kept || truncate(file->part, file->kept)) unlink(file->part);
    free(file->part);
}

bool tr_file_check(tr_file *file, tr_status *st) {
    if (!fflush(file->stream) && !ferror(file->stream)) return true;
    tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", file->path, strerror(errno));
    tr_file_discard(file);
    return false;
}

bool tr_file_commit(tr_file *file, tr_status *st) {
    if (!tr_file_check(file, st)) return false;
    bool synced = !fsync(fileno(file->stream));
    bool closed = !fclose(file->stream);
    file->stream = NULL;
    bool ok = synced && closed && !rename(file->part, file->path);
    if (ok)
        free(file->part);
    else
        tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", file->path, strerror(errno)), drop(file);
    return ok;
}

void tr_file_discard(tr_file *file) {
    if (!file->stream) return;
    fclose(file->stream);
    file->stream = NULL;
    drop(file);
}

bool tr_file_write(const char *dir, const char *name, const char *text, tr_status *st) {
    tr_file file;
    if (!tr_file_open(&file, dir, name, st)) return false;
    fputs(text, file.stream);
    return tr_file_commit(&file, st);
}
