/* SPDX-License-Identifier: MIT */
#include "study/packing.h"

#include "base/alloc.h"
#include "base/checkpoint.h"
#include "base/temporary.h"
#include "core/checkpoint.h"
#include "laws/law.h"
#include "scene/write.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* Increase it when a change of the program makes other packings of the same case. Since 2, packings with friction have
 * histories. */
static const char SMOOTH[] = "packing: 1", ROUGH[] = "packing: 2, with friction histories";

char *tr_packing_text(const tr_scene *scene, tr_status *st) {
    tr_scene compaction = {.kind = scene->kind,
                           .shape = scene->shape,
                           .boundary = scene->boundary,
                           .seed = scene->seed,
                           .sample = scene->sample,
                           .compaction = scene->compaction,
                           .contact = tr_biaxial_compaction_laws(scene)};
    tr_scene_law *friction = &compaction.contact.friction;
    double *mu = tr_law_value(tr_laws_friction[friction->law], friction->par, "mu");
    if (mu) *mu = tr_biaxial_rest_mu(scene);
    char *resolved = tr_scene_write(&compaction, tr_laws_catalog(), st), *text = NULL;
    if (resolved && asprintf(&text, "%s\n%s", scene->compaction.mu > 0 ? ROUGH : SMOOTH, resolved) < 0)
        text = NULL, tr_status_fail(st, TR_FILE, "error: out of memory");
    free(resolved);
    return text;
}

static bool name_file(tr_packing *p, const char *path, tr_status *st) {
    const char *slash = strrchr(path, '/');
    if (!(p->part = tr_temporary_name(path, st))) return false;
    p->dir = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup(".");
    p->name = strdup(slash ? slash + 1 : path);
    return (p->dir && p->name) || tr_status_fail(st, TR_FILE, "error: out of memory");
}

static bool open_packing(tr_checkpoint *c, const tr_packing *p, tr_status *instead, tr_status *st) {
    if (tr_checkpoint_open(c, p->dir, p->name, p->text, instead, st)) return true;
    size_t n = strlen(st->text);
    if (st->code == TR_FILE)
        snprintf(st->text + n, sizeof st->text - n,
                 "; remove it, or give another name, and the run makes its own packing");
    return false;
}

bool tr_packing_check(const tr_scene *scene, const char *path, tr_status *st) {
    tr_packing p = {.lock = -1};
    tr_status instead = {0};
    tr_checkpoint c = {0};
    bool ok = (p.text = tr_packing_text(scene, st)) && name_file(&p, path, st);
    if (ok && !*p.name) ok = tr_status_fail(st, TR_FILE, "error: --sample needs the name of a file, not `%s`", path);
    if (ok && !access(path, F_OK))
        ok = open_packing(&c, &p, &instead, st);
    else if (ok && access(p.dir, W_OK | X_OK))
        ok = tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", path, strerror(errno));
    free(c.bytes);
    tr_packing_close(&p);
    return ok;
}

/* Whether the locked file still has this name, and was not removed after a failure. */
static bool is_part(const tr_packing *p) {
    struct stat ours, there;
    return !fstat(p->lock, &ours) && !stat(p->part, &there) && ours.st_ino == there.st_ino &&
           ours.st_dev == there.st_dev;
}

/* The process with the lock on the part makes the packing. The lock ends with the process in any case. */
static bool wait_for_temporary(tr_packing *p, const char *path, const tr_run_options *options, tr_status *st) {
    p->lock = open(p->part, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (p->lock < 0) return tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", p->part, strerror(errno));
    if (!tr_checkpoint_is_one(p->lock)) {
        close(p->lock), p->lock = -1; /* it is not ours to remove */
        return tr_status_fail(st, TR_FILE, "error: %s has the name of a result; move it away", p->part);
    }
    while (flock(p->lock, LOCK_EX | LOCK_NB) && errno == EWOULDBLOCK) {
        if (options->stop && *options->stop)
            return close(p->lock), p->lock = -1,
                                   tr_status_fail(st, TR_INTERRUPTED, "stopped while another run makes %s", path);
        nanosleep(&(struct timespec){.tv_nsec = 5000000}, NULL);
    }
    if (is_part(p) || !access(path, F_OK)) return true;
    close(p->lock);
    return wait_for_temporary(p, path, options, st);
}

static void keep(tr_biaxial *b, double *unbalanced, tr_checkpoint *c) {
    tr_biaxial_packing(b, c);
    TR_KEEP(c, unbalanced, 1);
}

bool tr_packing_load(tr_packing *p, tr_biaxial *b, const tr_run_options *options, double *unbalanced, bool *there,
                     tr_status *st) {
    tr_checkpoint c;
    const char *path = options->sample;
    *p = (tr_packing){.lock = -1};
    *there = false;
    if (!(p->text = tr_packing_text(b->scene, st)) || !name_file(p, path, st)) return false;
    if (access(path, F_OK) && !wait_for_temporary(p, path, options, st)) return false;
    if (access(path, F_OK)) return true; /* for this run to make */
    if (p->lock >= 0) unlink(p->part);   /* the other run has renamed its part */
    tr_status instead = {0};
    if (!open_packing(&c, p, &instead, st)) return false;
    keep(b, unbalanced, &c);
    *there = tr_checkpoint_close(&c);
    return *there;
}

bool tr_packing_save(tr_packing *p, tr_biaxial *b, double *unbalanced, tr_status *st) {
    tr_checkpoint c;
    tr_checkpoint_begin(&c, p->text, st);
    keep(b, unbalanced, &c);
    return tr_checkpoint_write(&c, p->dir, p->name);
}

void tr_packing_close(tr_packing *p) {
    if (p->lock >= 0 && is_part(p)) unlink(p->part); /* it was not renamed */
    if (p->lock >= 0) close(p->lock);
    free(p->text), free(p->dir), free(p->name), free(p->part);
    *p = (tr_packing){.lock = -1};
}
