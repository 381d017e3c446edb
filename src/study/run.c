/* SPDX-License-Identifier: MIT */
#include "study/run.h"

#include "base/checkpoint.h"
#include "laws/law.h"
#include "out/dir.h"
#include "out/manifest.h"
#include "out/summary.h"
#include "out/summary_read.h"
#include "scene/write.h"
#include "study/open.h"
#include "study/run_biaxial.h"
#include "study/run_bodies.h"
#include "study/run_path.h"
#include <stdlib.h>
#include <unistd.h>

/* The run to resume is already finished. One of another case is refused. */
static bool finished(const tr_scene *scene, const tr_run_options *options, tr_status *st) {
    char path[TR_PATH];
    char version[TR_SUMMARY_VERSION];
    if (!options->resume || !tr_dir_path(path, options->dir, "summary.json", st)) return false;
    if (!tr_summary_version(path, version, st) || !*version) return false;
    bool same = false;
    char *resolved = tr_scene_write(scene, tr_laws_catalog(), st);
    if (resolved) tr_dir_holds(options->dir, "case.yaml", resolved, &same, st);
    free(resolved);
    if (!same)
        tr_status_fail(st, TR_FILE, "error: %s holds a finished run of another case; give another -o", options->dir);
    return same;
}

static bool run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    if (finished(scene, options, st)) {
        char path[TR_PATH];
        bool ours;
        if (!tr_manifest_lists(options->dir, TR_CHECKPOINT, &ours, st)) return false;
        if (ours) tr_run_remove_checkpoint(options->dir, report); /* if the run was killed right before */
        tr_run_note(report, "nothing to resume: this run is finished");
        return tr_dir_path(path, options->dir, "summary.json", st) && tr_summary_failed(path, &report->failed, st);
    }
    if (st->code) return false;
    switch (scene->kind) {
    case TR_KIND_BIAXIAL:
        return tr_run_biaxial(scene, options, report, st);
    case TR_KIND_BODIES:
        return tr_run_bodies(scene, options, report, st);
    case TR_KIND_CONTACT:
    case TR_KIND_PATCH:
        return tr_run_path(scene, options, report, st);
    }
    return false;
}

static char *check(const tr_scene *scene, tr_run_report *report, tr_status *st) {
    switch (scene->kind) {
    case TR_KIND_BIAXIAL:
        return tr_run_check_biaxial(scene, report, st);
    case TR_KIND_BODIES:
        return tr_run_check_bodies(scene, report, st);
    case TR_KIND_CONTACT:
    case TR_KIND_PATCH:
        return tr_run_check_path(scene, report, st);
    }
    return NULL;
}

bool tr_run_check(const tr_scene *scene, tr_run_report *report, char **summary, tr_status *st) {
    *report = (tr_run_report){0};
    char *text = check(scene, report, st);
    report->n_warnings = report->n_notes;
    bool ok = text;
    if (summary)
        *summary = text;
    else
        free(text);
    return ok;
}

bool tr_run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    int lock = -1;
    bool ok = tr_run_check(scene, report, NULL, st);
    if (ok && options->foretold) options->foretold(report);
    ok = ok && tr_dir_lock(options->dir, &lock, st) && run(scene, options, report, st);
    if (lock >= 0) close(lock);
    return ok;
}
