/* SPDX-License-Identifier: MIT */
#include "study/packing.h"

#include "base/alloc.h"
#include "base/checkpoint.h"
#include "base/part.h"
#include "core/checkpoint.h"
#include "laws/law.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

char *tr_packing_text(const tr_scene *scene, tr_status *st) {
    tr_scene compaction = {.kind = scene->kind,
                           .shape = scene->shape,
                           .boundary = scene->boundary,
                           .seed = scene->seed,
                           .sample = scene->sample,
                           .compaction = scene->compaction,
                           .contact = tr_biaxial_compaction_laws(scene)};
    return tr_scene_write(&compaction, tr_laws_catalog(), st);
}

static bool name_file(tr_packing *p, const char *path, tr_status *st) {
    const char *slash = strrchr(path, '/');
    if (!(p->part = tr_part_name(path, st))) return false;
    p->dir = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup(".");
    p->name = strdup(slash ? slash + 1 : path);
    return (p->dir && p->name) || tr_status_fail(st, TR_FILE, "error: out of memory");
}

/* Who holds the lock on the part makes the packing. The lock ends with the process, whatever ended it. */
static bool wait_for_part(tr_packing *p, const char *path, const tr_run_options *options, tr_status *st) {
    p->lock = open(p->part, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (p->lock < 0) return tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", p->part, strerror(errno));
    while (flock(p->lock, LOCK_EX | LOCK_NB) && errno == EWOULDBLOCK) {
        if (options->stop && *options->stop)
            return tr_status_fail(st, TR_INTERRUPTED, "stopped while another run makes %s", path);
        nanosleep(&(struct timespec){.tv_nsec = 5000000}, NULL);
    }
    return true;
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
    if (access(path, F_OK) && !wait_for_part(p, path, options, st)) return false;
    if (access(path, F_OK)) return true; /* for this run to make */
    if (p->lock >= 0) unlink(p->part);   /* the run that was waited for has renamed its own */
    tr_status instead = {0};
    if (!tr_checkpoint_open(&c, p->dir, p->name, p->text, &instead, st)) return false;
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
    if (p->lock >= 0) close(p->lock);
    free(p->text), free(p->dir), free(p->name), free(p->part);
    *p = (tr_packing){.lock = -1};
}
