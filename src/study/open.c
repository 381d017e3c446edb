/* SPDX-License-Identifier: MIT */
#include "study/open.h"

#include "laws/law.h"
#include "out/dir.h"
#include "out/manifest.h"
#include "scene/write.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

void tr_run_remove_checkpoint(const char *dir, tr_run_report *report) {
    if (tr_checkpoint_remove(dir)) return;
    tr_run_note(report, "the checkpoint of this finished run could not be removed: %s; it is not needed any more",
                strerror(errno));
}

/* For all files that the run reads. */
static bool spare_inputs(const tr_scene *scene, const tr_run_options *o, tr_status *st) {
    return tr_manifest_spare(o->dir, o->case_file, st) && tr_manifest_spare(o->dir, o->sample, st) &&
           tr_manifest_spare(o->dir, scene->path_file, st) &&
           tr_manifest_spare(o->dir, *scene->sample.file ? scene->sample.file : NULL, st);
}

bool tr_run_open(const tr_scene *scene, const tr_run_options *options, tr_checkpoint *c, tr_run_report *report,
                 tr_status *st) {
    tr_checkpoint none;
    tr_status instead = {0};
    char *resolved = tr_scene_write(scene, tr_laws_catalog(), st);
    bool resume = resolved && options->resume &&
                  tr_checkpoint_open(c ? c : &none, options->dir, TR_CHECKPOINT, resolved, &instead, st);
    if (resume &&
        (!tr_manifest_add(options->dir, TR_CHECKPOINT, st) || !tr_manifest_spare(options->dir, options->sample, st))) {
        if (!c) free(none.bytes); /* c is the caller's, who frees its bytes */
        return free(resolved), false;
    }
    if (resume) tr_checkpoint_remove_temporary(options->dir);
    if (resume && instead.code) tr_run_note(report, "continued from the older checkpoint: %.150s", instead.text);
    bool ok = resume || (resolved && !st->code && spare_inputs(scene, options, st) &&
                         tr_manifest_clear(options->dir, options->force, st) &&
                         (!c || tr_manifest_add(options->dir, TR_CHECKPOINT, st)) &&
                         tr_file_write(options->dir, "case.yaml", resolved, st));
    free(resolved);
    return ok;
}
bool tr_run_threads(const tr_run_options *options, tr_world *world, tr_status *st) {
    if (options->share_few) world->alone_to = 0;
    return tr_world_set_threads(world, options->threads, st);
}
