/* SPDX-License-Identifier: MIT */
#include "base/checkpoint.h"

#include "base/alloc.h"
#include "base/hash.h"
#include "base/regular.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char MAGIC[8] = "trundle";
enum { VERSION = 1 };

typedef struct header {
    char magic[8];
    uint64_t version, size;
} header;

typedef struct record {
    char name[48];
    uint64_t size, count;
} record;

/* ---- fields ---- */

static void append(tr_checkpoint *c, const void *data, size_t n) {
    if (c->size + n > c->room) {
        size_t room = 2 * (c->size + n);
        if (!tr_alloc_grow(&c->bytes, c->size, room, 1, c->st)) return;
        c->room = room;
    }
    if (n) memcpy(c->bytes + c->size, data, n);
    c->size += n;
}

static record next(const tr_checkpoint *c) {
    record r = {.name = "nothing"};
    if (c->size - c->at >= sizeof r) memcpy(&r, c->bytes + c->at, sizeof r);
    return r;
}

/* A file with a right checksum may still be wrong. */
static bool are_possible(tr_checkpoint_kind kind, const unsigned char *bytes, size_t n) {
    bool ok = true;
    double number;
    int64_t tally;
    for (size_t i = 0; kind == TR_KEPT_FLAGS && i < n; i++) ok &= bytes[i] <= 1;
    for (size_t i = 0; kind == TR_KEPT_NUMBERS && i < n; i += sizeof number)
        memcpy(&number, bytes + i, sizeof number), ok &= number - number == 0;
    for (size_t i = 0; kind == TR_KEPT_COUNTS && i < n; i += sizeof tally)
        memcpy(&tally, bytes + i, sizeof tally), ok &= tally >= 0 && tally <= INT64_MAX / 4;
    return ok;
}

static void load(tr_checkpoint *c, tr_checkpoint_kind kind, const record *wanted, void *data) {
    record r = next(c);
    size_t n = wanted->size * wanted->count;
    if (strncmp(r.name, wanted->name, sizeof r.name) || r.size != wanted->size || r.count != wanted->count ||
        n > c->size - c->at - sizeof r) {
        tr_status_fail(
            c->st, TR_FILE,
            "error: the checkpoint is of another build: it has %.47s, %llu of %llu bytes, where this one has "
            "%s, %llu of %llu",
            r.name, (unsigned long long)r.count, (unsigned long long)r.size, wanted->name,
            (unsigned long long)wanted->count, (unsigned long long)wanted->size);
        return;
    }
    const unsigned char *bytes = c->bytes + c->at + sizeof r;
    tr_checkpoint_check(c, are_possible(kind, bytes, n), wanted->name);
    if (c->st->code) return;
    if (n) memcpy(data, bytes, n);
    c->at += sizeof r + n;
}

void tr_checkpoint_field(tr_checkpoint *c, tr_checkpoint_kind kind, const char *name, void *data, size_t size,
                         size_t count) {
    if (c->st->code) return;
    record r = {.size = size, .count = count};
    snprintf(r.name, sizeof r.name, "%s", name + (*name == '&'));
    if (c->loading) {
        load(c, kind, &r, data);
    } else {
        append(c, &r, sizeof r);
        append(c, data, size * count);
    }
}

void tr_checkpoint_check(tr_checkpoint *c, bool ok, const char *what) {
    if (c->loading && !ok)
        tr_status_fail(c->st, TR_FILE, "error: the checkpoint is damaged: %s is out of range", what + (*what == '&'));
}

void tr_checkpoint_count(tr_checkpoint *c, const char *name, int *n, size_t size) {
    tr_checkpoint_field(c, TR_KEPT_BYTES, name, n, sizeof *n, 1);
    tr_checkpoint_check(c, *n >= 0 && (size_t)*n <= (c->size - c->at) / size, name);
}

/* ---- saving ---- */

void tr_checkpoint_begin(tr_checkpoint *c, const char *resolved_case, tr_status *st) {
    header h = {.version = VERSION};
    memcpy(h.magic, MAGIC, sizeof h.magic);
    *c = (tr_checkpoint){.st = st};
    append(c, &h, sizeof h);
    tr_checkpoint_field(c, TR_KEPT_BYTES, "case", (void *)(uintptr_t)resolved_case, 1, strlen(resolved_case));
}

static bool write_all(int fd, const unsigned char *bytes, size_t n) {
    while (n) {
        ssize_t written = write(fd, bytes, n);
        if (written < 0 && errno != EINTR) return false;
        if (written > 0) bytes += written, n -= (size_t)written;
    }
    return true;
}

static bool write_file(int dir, const char *part, const unsigned char *bytes, size_t n) {
    int fd = openat(dir, part, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd < 0) return false;
    bool ok = write_all(fd, bytes, n) && !fsync(fd);
    return !close(fd) && ok;
}

bool tr_checkpoint_write(tr_checkpoint *c, const char *dir, const char *name) {
    char part[NAME_MAX], old[NAME_MAX];
    snprintf(part, sizeof part, "%s.part", name);
    snprintf(old, sizeof old, "%s.old", name);
    uint64_t size = c->size + sizeof size;
    int at = -1;
    if (!c->st->code) {
        memcpy(c->bytes + offsetof(header, size), &size, sizeof size);
        uint64_t sum = tr_hash(TR_HASH_BEGIN, c->bytes, c->size);
        append(c, &sum, sizeof sum);
    }
    if (!c->st->code) {
        at = open(dir, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        bool ok = at >= 0 && write_file(at, part, c->bytes, c->size) &&
                  (!renameat(at, name, at, old) || errno == ENOENT) && !renameat(at, part, at, name) && !fsync(at);
        if (!ok) {
            tr_status_fail(c->st, TR_FILE, "error: cannot write %s/%s: %s", dir, name, strerror(errno));
            if (at >= 0) unlinkat(at, part, 0);
        }
    }
    if (at >= 0) close(at);
    free(c->bytes);
    return !c->st->code;
}

bool tr_checkpoint_sync(const char *dir, const char *name, tr_status *st) {
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s", dir, name);
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0 && errno == ENOENT) return true;
    bool ok = fd >= 0 && !fsync(fd);
    if (!ok) tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", path, strerror(errno));
    if (fd >= 0) close(fd);
    return ok;
}

/* ---- loading ---- */

/* st: it is damaged, so the older one may replace it. c->st: it may be right, but could not be read. */
static bool read_file(tr_checkpoint *c, const char *path, bool *there, tr_status *st) {
    struct stat info;
    FILE *file = tr_regular_open(path, c->st);
    *there = file || c->st->code;
    if (!file || fstat(fileno(file), &info)) {
        if (file) tr_status_fail(c->st, TR_FILE, "error: cannot read %s: %s", path, strerror(errno)), fclose(file);
        return false;
    }
    c->size = (size_t)info.st_size;
    bool ok = (c->bytes = tr_alloc(c->size, 1, c->st)) &&
              (fread(c->bytes, 1, c->size, file) == c->size ||
               tr_status_fail(st, TR_FILE, "error: cannot read %s: %s", path, strerror(errno)));
    fclose(file);
    return ok;
}

/* Complete, and of a version that can be read. */
static bool check(tr_checkpoint *c, const char *path, bool *newer, tr_status *st) {
    header h = {0};
    uint64_t sum;
    if (c->size >= sizeof h) memcpy(&h, c->bytes, sizeof h);
    if (c->size >= sizeof h && memcmp(h.magic, MAGIC, sizeof MAGIC))
        return tr_status_fail(st, TR_FILE, "error: %s is not a checkpoint of trundle", path);
    *newer = c->size >= sizeof h && h.version > VERSION;
    if (*newer)
        return tr_status_fail(st, TR_FILE, "error: %s has version %llu, from a newer trundle; this one reads %d", path,
                              (unsigned long long)h.version, VERSION);
    if (c->size < sizeof h + sizeof sum || c->size < h.size)
        return tr_status_fail(st, TR_FILE, "error: %s is cut short: %zu bytes of %llu", path, c->size,
                              (unsigned long long)h.size);
    memcpy(&sum, c->bytes + c->size - sizeof sum, sizeof sum);
    if (c->size != h.size || tr_hash(TR_HASH_BEGIN, c->bytes, c->size - sizeof sum) != sum)
        return tr_status_fail(st, TR_FILE, "error: %s is damaged: its checksum is wrong", path);
    c->size -= sizeof sum;
    c->at = sizeof h;
    return true;
}

/* Length of the line without its comment and the spaces before that. */
static int line_length(const char *text, size_t n) {
    size_t k = 0;
    while (k < n && text[k] && text[k] != '#' && text[k] != '\n') k++;
    while (k && text[k - 1] == ' ') k--;
    return (int)k;
}

/* The first line where they differ. */
static bool check_case(tr_checkpoint *c, const char *path, const char *ours) {
    record r = next(c);
    const char *saved = (const char *)c->bytes + c->at + sizeof r;
    size_t n = (size_t)r.count, same = 0, line = 0;
    if (strncmp(r.name, "case", sizeof r.name) || r.size != 1 || r.count > c->size - c->at - sizeof r)
        return tr_status_fail(c->st, TR_FILE, "error: %s is damaged: it has no case", path);
    for (; same < n && ours[same] && saved[same] == ours[same]; same++)
        if (saved[same] == '\n') line = same + 1;
    if (same == n && !ours[same]) return c->at += sizeof r + n, true;
    int theirs = line_length(saved + line, n - line), other = line_length(ours + line, strlen(ours + line));
    if (theirs == other && !memcmp(saved + line, ours + line, (size_t)other)) /* they differ in a comment */
        return tr_status_fail(c->st, TR_FILE, "error: %s is from another version of trundle", path);
    return tr_status_fail(c->st, TR_FILE, "error: %s is from another case: it has `%.*s`, this case has `%.*s`", path,
                          theirs, saved + line, other, ours + line);
}

bool tr_checkpoint_open(tr_checkpoint *c, const char *dir, const char *name, const char *resolved_case,
                        tr_status *instead, tr_status *st) {
    char path[PATH_MAX], old[PATH_MAX];
    bool there = false, older = false, newer = false;
    snprintf(path, sizeof path, "%s/%s", dir, name);
    snprintf(old, sizeof old, "%s/%s.old", dir, name);
    *c = (tr_checkpoint){.loading = true, .st = st};
    bool ok = read_file(c, path, &there, instead) && check(c, path, &newer, instead);
    if (!ok && !newer && !st->code) {
        free(c->bytes), c->bytes = NULL;
        tr_status why = {0};
        ok = read_file(c, old, &older, &why) && check(c, old, &newer, &why);
        if (ok)
            ok = !rename(old, path) || tr_status_fail(st, TR_FILE, "error: cannot rename %s: %s", old, strerror(errno));
        if (!ok && !there) *instead = why;
    }
    if (ok)
        ok = check_case(c, path, resolved_case);
    else if (instead->code && !st->code)
        *st = *instead;
    if (!ok) free(c->bytes), *c = (tr_checkpoint){0};
    return ok;
}

bool tr_checkpoint_close(tr_checkpoint *c) {
    if (!c->st->code && c->at != c->size)
        tr_status_fail(c->st, TR_FILE, "error: the checkpoint is from another build: it has %.47s, this build does not",
                       next(c).name);
    free(c->bytes), c->bytes = NULL;
    return !c->st->code;
}

bool tr_checkpoint_is_one(int fd) {
    struct stat info;
    char begin[sizeof MAGIC];
    if (fstat(fd, &info) || !S_ISREG(info.st_mode) || info.st_nlink > 1) return false;
    ssize_t n = pread(fd, begin, sizeof begin, 0);
    return n >= 0 && !memcmp(begin, MAGIC, (size_t)n);
}

static bool remove_one(const char *dir, const char *name) {
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s", dir, name);
    return !unlink(path) || errno == ENOENT;
}

void tr_checkpoint_remove_temporary(const char *dir) {
    remove_one(dir, TR_CHECKPOINT ".part");
}

bool tr_checkpoint_remove(const char *dir) {
    static const char *const name[] = {TR_CHECKPOINT, TR_CHECKPOINT ".old", TR_CHECKPOINT ".part"};
    int error = 0;
    for (int k = 0; k < 3; k++)
        if (!remove_one(dir, name[k])) error = errno;
    errno = error;
    return !error;
}
