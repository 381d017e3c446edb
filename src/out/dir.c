/* SPDX-License-Identifier: MIT */
#include "out/dir.h"

#include "base/part.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* All that a run writes, the mark of a finished run first, then what counts on the rest: an interrupted removal leaves an
 * unfinished run that starts afresh. */
static const char *const results[] = {
    "summary.json",     "checkpoint.bin", "checkpoint.bin.old", "history.csv", "contacts.csv", "disks.csv",
    "case.yaml",        "plot.gp",        "biaxial.svg",        "biaxial.png", "biaxial.mp4",  "biaxial.gif",
    "bodies.mp4",       "bodies.gif",     "contact.csv",        "contact.svg", "contact.png",  "patch.csv",
    "patch.mp4",        "patch.gif",      "still.png",          "paths.csv",   "replay.csv",   "replay-errors.csv",
    "replay-stress.csv"};

bool tr_dir_path(char path[TR_PATH], const char *dir, const char *name, tr_status *st) {
    if (snprintf(path, TR_PATH, "%s/%s", dir, name) < TR_PATH) return true;
    return tr_status_fail(st, TR_FILE, "error: path too long: %.200s...", dir);
}

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

static bool remove_old(const char *dir, const char *name, tr_status *st) {
    char path[TR_PATH];
    if (!tr_dir_path(path, dir, name, st)) return false;
    if (!unlink(path) || errno == ENOENT || errno == ENOTDIR) return true;
    return tr_status_fail(st, TR_FILE, "error: cannot remove %s: %s", path, strerror(errno));
}

/* 00012.png, and the part of it that a killed run may have left */
static bool is_frame(const char *name) {
    return strspn(name, "0123456789") == 5 && (!strcmp(name + 5, ".png") || !strcmp(name + 5, ".png.part"));
}

/* 17-42.csv, wall0-3.csv, most-mobilised.csv, and their parts */
static bool is_pick(const char *name) {
    const char *digits = "0123456789", *end = name + (strncmp(name, "wall", 4) ? 0 : 4);
    end += strspn(end, digits);
    end += *end == '-' ? 1 + strspn(end + 1, digits) : 0;
    if (!strncmp(name, "most-mobilised", 14)) end = name + 14;
    return end > name && (!strcmp(end, ".csv") || !strcmp(end, ".csv.part"));
}

/* Of several scenes the names begin with the scene's number: 0-17-42.csv. */
static bool is_path(const char *name) {
    size_t number = strspn(name, "0123456789");
    return is_pick(name) || (number && name[number] == '-' && is_pick(name + number + 1));
}

static bool remove_in(const char *dir, const char *folder, bool is_ours(const char *), tr_status *st) {
    char path[TR_PATH];
    if (!tr_dir_path(path, dir, folder, st)) return false;
    DIR *d = opendir(path);
    bool ok = true;
    for (struct dirent *e; d && ok && (e = readdir(d));)
        if (is_ours(e->d_name)) ok = remove_old(path, e->d_name, st);
    if (d) closedir(d);
    rmdir(path); /* stays if something else is in it */
    return ok;
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

bool tr_dir_clear(const char *dir, bool force, tr_status *st) {
    char summary[TR_PATH];
    if (!tr_dir_path(summary, dir, results[0], st)) return false;
    if (!force && !access(summary, F_OK))
        return tr_status_fail(st, TR_FILE, "error: %s holds a finished run; give another -o, or --force to replace it",
                              dir);
    for (size_t k = 0; k < sizeof results / sizeof *results; k++) {
        char part[32];
        snprintf(part, sizeof part, "%s.part", results[k]);
        if (!remove_old(dir, results[k], st) || !remove_old(dir, part, st)) return false;
    }
    return remove_in(dir, "frames", is_frame, st) && remove_in(dir, "paths", is_path, st);
}

bool tr_dir_make(const char *dir, const char *name, tr_status *st) {
    char path[TR_PATH];
    return tr_dir_path(path, dir, name, st) && make(path, st);
}

static bool open_part(tr_file *file, const char *dir, const char *name, const char *mode, tr_status *st) {
    *file = (tr_file){0};
    if (!tr_dir_path(file->path, dir, name, st) || !(file->part = tr_part_name(file->path, st))) return false;
    if (*mode == 'a' && access(file->part, F_OK)) rename(file->path, file->part);
    file->stream = fopen(file->part, mode);
    if (file->stream) return true;
    tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", file->part, strerror(errno));
    free(file->part);
    return false;
}

bool tr_file_open(tr_file *file, const char *dir, const char *name, tr_status *st) {
    return open_part(file, dir, name, "w", st);
}

bool tr_file_reopen(tr_file *file, const char *dir, const char *name, tr_status *st) {
    if (!open_part(file, dir, name, "a", st)) return false;
    fseek(file->stream, 0, SEEK_END);
    file->kept = ftell(file->stream); /* all of it, until it is known better */
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
