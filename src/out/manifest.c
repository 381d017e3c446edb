/* SPDX-License-Identifier: MIT */
#include "out/manifest.h"

#include "base/alloc.h"
#include "base/gather.h"
#include "base/regular.h"
#include "out/path.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/* All results except frames and paths. The mark of a finished run comes first, then the checkpoint, which needs the
 * rest: an interrupted removal leaves an unfinished run. */
static const char *const results[] = {
    "summary.json", "checkpoint.bin", "history.csv", "contacts.csv", "disks.csv",         "case.yaml",
    "plot.gp",      "biaxial.svg",    "biaxial.png", "biaxial.mp4",  "biaxial.gif",       "bodies.mp4",
    "bodies.gif",   "contact.csv",    "contact.svg", "contact.png",  "patch.csv",         "patch.mp4",
    "patch.gif",    "still.png",      "paths.csv",   "replay.csv",   "replay-errors.csv", "replay-stress.csv",
};
enum { N_RESULTS = sizeof results / sizeof *results };

/* A name includes its parts while it is written, and the file that it replaces. */
static const char *const endings[] = {"", ".part", ".old"};
enum { N_ENDINGS = sizeof endings / sizeof *endings };

/* ---- names ---- */

/* 00012.png */
static bool is_frame(const char *name) {
    return strspn(name, "0123456789") == 5 && !strcmp(name + 5, ".png");
}

/* 17-42.csv, wall0-3.csv, most-mobilised.csv */
static bool is_contact_id(const char *name) {
    const char *digits = "0123456789", *end = name + (strncmp(name, "wall", 4) ? 0 : 4);
    end += strspn(end, digits);
    end += *end == '-' ? 1 + strspn(end + 1, digits) : 0;
    if (!strncmp(name, "most-mobilised", 14)) end = name + 14;
    return end > name && !strcmp(end, ".csv");
}

/* Of several scenes the names begin with the scene's number: 0-17-42.csv. */
static bool is_path(const char *name) {
    size_t number = strspn(name, "0123456789");
    return is_contact_id(name) || (number && name[number] == '-' && is_contact_id(name + number + 1));
}

static const struct folder {
    const char *name;
    bool (*is_ours)(const char *);
} folders[] = {{"frames", is_frame}, {"paths", is_path}};
enum { N_FOLDERS = sizeof folders / sizeof *folders };

/* The name without the ending of a file that is being written or was replaced. */
static void strip(const char *name, char *bare, size_t size) {
    snprintf(bare, size, "%s", name);
    for (int e = 1; e < N_ENDINGS; e++) {
        size_t n = strlen(bare), m = strlen(endings[e]);
        if (n > m && !strcmp(bare + n - m, endings[e])) bare[n - m] = '\0';
    }
}

static bool is_result(const char *name) {
    for (int k = 0; k < N_RESULTS; k++)
        if (!strcmp(name, results[k])) return true;
    for (int k = 0; k < N_FOLDERS; k++) {
        size_t n = strlen(folders[k].name);
        if (!strncmp(name, folders[k].name, n) && name[n] == '/' && folders[k].is_ours(name + n + 1)) return true;
    }
    return false;
}

/* ---- the list ---- */

typedef struct list {
    char *text, **name; /* the names point into the text */
    size_t size;
    int n;
} list;

static void list_free(list *l) {
    free(l->text), free(l->name);
    *l = (list){0};
}

/* The first line, by which a list is known. */
static const char title[] = "# files that trundle has written here, - those that it has removed again\n";

/* Whether the text is a list, or the start of its first line that a killed run has left. */
static bool is_list(const char *text, size_t size) {
    size_t n = size < sizeof title - 1 ? size : sizeof title - 1;
    return !memcmp(text, title, n);
}

static bool list_read_text(list *l, const char *path, tr_status *st) {
    FILE *file = tr_regular_open(path, st);
    if (!file) return !st->code;
    size_t room = 0;
    ssize_t n = getdelim(&l->text, &room, '\0', file);
    bool ok = !ferror(file) && (n >= 0 || feof(file));
    if (!ok) tr_status_fail(st, TR_FILE, "error: cannot read %s: %s", path, strerror(errno));
    fclose(file);
    l->size = ok && n > 0 ? strlen(l->text) : 0;
    if (ok && l->size && !is_list(l->text, l->size))
        ok = tr_status_fail(st, TR_FILE, "error: %s was not made by trundle; move it away, or give another -o", path);
    return ok;
}

static int find(const list *l, const char *name) {
    for (int k = 0; k < l->n; k++)
        if (!strcmp(l->name[k], name)) return k;
    return -1;
}

static bool list_read(list *l, const char *dir, tr_status *st) {
    char path[TR_PATH];
    *l = (list){0};
    if (!tr_dir_path(path, dir, TR_MADE_LIST, st) || !list_read_text(l, path, st)) return list_free(l), false;
    int lines = 1;
    for (size_t i = 0; i < l->size; i++) lines += l->text[i] == '\n';
    if (!(l->name = tr_alloc((size_t)lines, sizeof *l->name, st))) return list_free(l), false;
    char *rest = l->text;
    for (char *line; l->size && (line = strsep(&rest, "\n"));) {
        bool removed = *line == '-';
        int k = *line && *line != '#' ? find(l, line + removed) : -1;
        if (removed && k >= 0) l->name[k] = l->name[--l->n];
        if (*line && *line != '#' && !removed && k < 0) l->name[l->n++] = line;
    }
    return true;
}

static bool list_has(const list *l, const char *name) {
    return find(l, name) >= 0;
}

/* The list on the disk, and its entry in the directory. */
static bool sync_list(int fd, const char *dir) {
    int folder = fsync(fd) ? -1 : open(dir, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    bool ok = folder >= 0 && !fsync(folder);
    if (folder >= 0) close(folder);
    return ok;
}

/* At the end of the open list; no other process writes to it now. A line that a killed run has torn is first
 * completed. */
static bool append(int fd, const char *names) {
    struct stat info;
    char last = '\n';
    if (flock(fd, LOCK_EX) || fstat(fd, &info) || !S_ISREG(info.st_mode)) return false;
    bool begun = info.st_size >= (off_t)sizeof title - 1;
    if (!begun && ftruncate(fd, 0)) return false;
    if (begun && pread(fd, &last, 1, info.st_size - 1) != 1) return false;
    return dprintf(fd, "%s%s%s", begun ? "" : title, last == '\n' ? "" : "\n", names) > 0;
}

/* Appends only, so that no name is ever lost. Two runs may list into one folder of a sweep. */
static bool list_append(const char *dir, const char *names, tr_status *st) {
    char path[TR_PATH];
    if (!tr_dir_path(path, dir, TR_MADE_LIST, st)) return false;
    int fd = open(path, O_RDWR | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    bool ok = fd >= 0 && append(fd, names) && sync_list(fd, dir);
    if (!ok) tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", path, strerror(errno));
    if (fd >= 0) close(fd);
    return ok;
}

/* The results of the list are gone. */
static bool list_forget(const list *l, const char *dir, tr_status *st) {
    tr_gather names;
    bool begun = tr_gather_begin(&names, st);
    for (int k = 0; begun && k < l->n; k++)
        if (is_result(l->name[k])) fprintf(names.stream, "-%s\n", l->name[k]);
    char *text = tr_gather_end(&names, st);
    bool ok = text && (!*text || list_append(dir, text, st));
    free(text);
    return ok;
}

/* ---- the files of a directory ---- */

/* Calls visit() for each file that has the name of a result, an ending included; stops at the first false. */
typedef bool visitor(void *context, const char *dir, const char *name, tr_status *st);

static bool each_in(const char *dir, const struct folder *folder, visitor *visit, void *context, tr_status *st) {
    char path[TR_PATH];
    if (!tr_dir_path(path, dir, folder->name, st)) return false;
    DIR *d = opendir(path);
    bool ok = true;
    for (struct dirent *e; d && ok && (e = readdir(d));) {
        char bare[NAME_MAX + 1], name[TR_PATH];
        strip(e->d_name, bare, sizeof bare);
        if (!folder->is_ours(bare)) continue;
        snprintf(name, sizeof name, "%s/%s", folder->name, e->d_name);
        ok = visit(context, dir, name, st);
    }
    if (d) closedir(d);
    return ok;
}

static bool is_there(const char *path) {
    struct stat info;
    return !lstat(path, &info);
}

static bool each_result(const char *dir, visitor *visit, void *context, tr_status *st) {
    char name[64], path[TR_PATH];
    for (int k = 0; k < N_RESULTS; k++)
        for (int e = 0; e < N_ENDINGS; e++) {
            snprintf(name, sizeof name, "%s%s", results[k], endings[e]);
            if (!tr_dir_path(path, dir, name, st)) return false;
            if (is_there(path) && !visit(context, dir, name, st)) return false;
        }
    for (int k = 0; k < N_FOLDERS; k++)
        if (!each_in(dir, &folders[k], visit, context, st)) return false;
    return true;
}

static bool is_link(const char *dir, const char *folder, size_t length, tr_status *st) {
    char path[TR_PATH];
    struct stat info;
    if (snprintf(path, sizeof path, "%s/%.*s", dir, (int)length, folder) >= (int)sizeof path) return false;
    if (lstat(path, &info) || !S_ISLNK(info.st_mode)) return false;
    tr_status_fail(st, TR_FILE, "error: %s is a symbolic link; results are not written through it", path);
    return true;
}

/* ---- listing ---- */

static bool is_foreign(const char *dir, const char *name, tr_status *st) {
    char path[TR_PATH], text[TR_PATH];
    for (int e = 0; e < N_ENDINGS; e++) {
        if (snprintf(text, sizeof text, "%s%s", name, endings[e]) >= (int)sizeof text) continue;
        if (!tr_dir_path(path, dir, text, st)) return true;
        if (!is_there(path)) continue;
        tr_status_fail(st, TR_FILE,
                       "error: %s was not made by trundle (it is not listed in %s/" TR_MADE_LIST
                       "); move it away, or give another -o",
                       path, dir);
        return true;
    }
    return false;
}

/* Adds to `names` unless it is listed. */
static bool want(const list *l, const char *dir, const char *name, FILE *names, tr_status *st) {
    const char *slash = strchr(name, '/');
    if (slash && is_link(dir, name, (size_t)(slash - name), st)) return false;
    if (list_has(l, name)) return true;
    if (is_foreign(dir, name, st)) return false;
    fprintf(names, "%s\n", name);
    return true;
}

static bool add(const char *dir, const char *name, int frames, tr_status *st) {
    list l;
    char frame[32];
    tr_gather names;
    if (!list_read(&l, dir, st)) return false;
    bool ok = tr_gather_begin(&names, st) && (!name || want(&l, dir, name, names.stream, st));
    for (int k = 0; ok && k < frames; k++) {
        snprintf(frame, sizeof frame, "frames/%05d.png", k);
        ok = want(&l, dir, frame, names.stream, st);
    }
    char *text = tr_gather_end(&names, st);
    ok = ok && text && (!*text || list_append(dir, text, st));
    free(text);
    list_free(&l);
    return ok;
}

bool tr_manifest_add(const char *dir, const char *name, tr_status *st) {
    return add(dir, name, 0, st);
}

bool tr_manifest_add_frames(const char *dir, int n, tr_status *st) {
    return add(dir, NULL, n, st);
}

bool tr_manifest_lists(const char *dir, const char *name, bool *listed, tr_status *st) {
    list l;
    *listed = false;
    if (!list_read(&l, dir, st)) return false;
    *listed = list_has(&l, name);
    list_free(&l);
    return true;
}

/* ---- clearing ---- */

typedef struct clearing {
    list made;
    bool force, finished;
} clearing;

static bool is_made(const clearing *c, const char *name) {
    char bare[TR_PATH];
    strip(name, bare, sizeof bare);
    return list_has(&c->made, bare);
}

static bool check(void *context, const char *dir, const char *name, tr_status *st) {
    clearing *c = context;
    c->finished |= !strcmp(name, results[0]);
    if (is_made(c, name) || (c->force && strchr(name, '/'))) return true;
    return tr_status_fail(st, TR_FILE,
                          "error: %s/%s was not made by trundle (it is not listed in %s/" TR_MADE_LIST
                          "); move it away, or give another -o",
                          dir, name, dir);
}

static bool remove_made(void *context, const char *dir, const char *name, tr_status *st) {
    char path[TR_PATH];
    if (!is_made(context, name)) return true;
    if (!tr_dir_path(path, dir, name, st)) return false;
    if (!unlink(path) || errno == ENOENT) return true;
    return tr_status_fail(st, TR_FILE, "error: cannot remove %s: %s", path, strerror(errno));
}

bool tr_manifest_clear(const char *dir, bool force, tr_status *st) {
    clearing c = {.force = force};
    char path[TR_PATH];
    for (int k = 0; k < N_FOLDERS; k++)
        if (is_link(dir, folders[k].name, strlen(folders[k].name), st)) return false;
    if (!list_read(&c.made, dir, st)) return false;
    bool ok = each_result(dir, check, &c, st);
    if (ok && c.finished && !force)
        ok = tr_status_fail(st, TR_FILE, "error: %s holds a finished run; give another -o, or --force to replace it",
                            dir);
    ok = ok && each_result(dir, remove_made, &c, st) && (!c.made.n || list_forget(&c.made, dir, st));
    for (int k = 0; ok && k < N_FOLDERS; k++)
        if (tr_dir_path(path, dir, folders[k].name, st)) rmdir(path); /* it stays if something else is in it */
    list_free(&c.made);
    return ok;
}

/* ---- inputs ---- */

static bool is_same(const struct stat *a, const struct stat *b) {
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

static bool fail_both(const char *output, const char *input, tr_status *st) {
    return tr_status_fail(st, TR_FILE, "error: %s would replace %s, which this command reads; give another -o", output,
                          input);
}

static bool differ(void *context, const char *dir, const char *name, tr_status *st) {
    char path[TR_PATH];
    return tr_dir_path(path, dir, name, st) && tr_manifest_differ(path, context, st);
}

/* An input that does not exist yet must not have the path of a result. */
static bool stands_apart(const char *dir, const char *input, tr_status *st) {
    const char *slash = strrchr(input, '/'), *name = slash ? slash + 1 : input;
    char folder[TR_PATH], place[TR_PATH], bare[TR_PATH];
    struct stat there, ours;
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - input) + 1 : 1, slash ? input : ".");
    if (stat(folder, &there)) return true;
    for (int k = -1; k < N_FOLDERS; k++) {
        if (!tr_dir_path(place, dir, k < 0 ? "." : folders[k].name, st)) return false;
        if (stat(place, &ours) || !is_same(&there, &ours)) continue;
        strip(name, bare, sizeof bare);
        snprintf(place, sizeof place, "%s%s%s", k < 0 ? "" : folders[k].name, k < 0 ? "" : "/", bare);
        if (is_result(place)) return fail_both(place, input, st);
    }
    return true;
}

bool tr_manifest_spare(const char *dir, const char *input, tr_status *st) {
    if (!input) return true;
    if (!is_there(input)) return stands_apart(dir, input, st);
    return each_result(dir, differ, (void *)(uintptr_t)input, st);
}

bool tr_manifest_differ(const char *output, const char *input, tr_status *st) {
    struct stat given, ours;
    if (!input || stat(input, &given) || stat(output, &ours) || !is_same(&given, &ours)) return true;
    return fail_both(output, input, st);
}
