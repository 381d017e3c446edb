/* SPDX-License-Identifier: MIT */
/* trundle run */
#include "base/threads.h"
#include "base/version.h"
#include "cli/name.h"
#include "cli/number.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "laws/law.h"
#include "scene/keys.h"
#include "study/run.h"
#include "study/sample_file.h"
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SETS = 256, CHECK = 1000, SEED, FRAMES, LANG, SET, FORCE, RESUME, CHECKPOINT, SAMPLE, THREADS, KEYS };

typedef struct arguments {
    const char *file, *dir, *sample;
    const char *set[MAX_SETS];
    int n_set;
    bool force, check, resume, keys; /* keys: file is the kind */
    double checkpoint;
    int threads;
    char *owned[MAX_SETS]; /* texts made of --seed and --frames */
    int n_owned;
} arguments;

static const struct argp_option options[] = {
    {"output", 'o', "DIR", 0, "directory of the results (default: out/ and the name of the case)", 0},
    {"force", FORCE, NULL, 0, "replace a finished run in the output directory", 0},
    {"set", SET, "KEY=VALUE", 0, "override a key of the case: --set shear.inertial_number=1e-4", 0},
    {"seed", SEED, "S", 0, "short for --set seed=S", 0},
    {"frames", FRAMES, "N", 0, "short for --set output.frames=N", 0},
    {"lang", LANG, "en|de", 0, "short for --set language=...: the words in pictures", 0},
    {"resume", RESUME, NULL, 0,
     "continue a stopped run in the output directory, to the same bytes; a finished run stays as it is. Without a "
     "checkpoint a run starts over; only biaxial tests have one",
     0},
    {"checkpoint", CHECKPOINT, "SECONDS", 0, "time between two checkpoints of a biaxial test (default: 60)", 0},
    {"sample", SAMPLE, "FILE", 0,
     "start a biaxial test from the packing in FILE (the result is the same); if FILE does not exist, the run makes it",
     0},
    {"threads", THREADS, "N", 0,
     "number of threads, for more than 4000 disks (default: 1); the results are the same bits", 0},
    {"check", CHECK, NULL, 0, "read and check the case, do not run it", 0},
    {"keys", KEYS, NULL, 0,
     "print all keys of a case of this KIND, or of all kinds, as Markdown tables: key, unit, default, range, meaning",
     0},
    {0},
};

static void add_set(arguments *a, const char *text, struct argp_state *state) {
    if (a->n_set == MAX_SETS) argp_error(state, "more than %d overrides", MAX_SETS);
    a->set[a->n_set++] = text;
}

static void add_short(arguments *a, const char *key, const char *value, struct argp_state *state) {
    char *text = NULL;
    if (asprintf(&text, "%s=%s", key, value) < 0) argp_error(state, "out of memory");
    a->owned[a->n_owned++] = text;
    add_set(a, text, state);
}

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    char *end;
    switch (key) {
    case 'o':
        a->dir = value;
        break;
    case FORCE:
        a->force = true;
        break;
    case RESUME:
        a->resume = true;
        break;
    case CHECKPOINT:
        a->checkpoint = strtod(value, &end);
        if (end == value || *end || !(a->checkpoint >= 0))
            argp_error(state, "--checkpoint takes seconds, not %s", value);
        break;
    case ARGP_KEY_END:
        if (!a->file && !a->keys) argp_error(state, "which case file?");
        if (a->resume && a->force)
            argp_error(state, "--resume keeps the files of the run, --force replaces them: give one of them");
        break;
    case THREADS:
        a->threads = tr_cli_whole(value, 1, TR_MOST_THREADS, "--threads", state);
        break;
    case SAMPLE:
        a->sample = value;
        break;
    case CHECK:
        a->check = true;
        break;
    case KEYS:
        a->keys = true;
        break;
    case SET:
        add_set(a, value, state);
        break;
    case SEED:
        add_short(a, "seed", value, state);
        break;
    case FRAMES:
        add_short(a, "output.frames", value, state);
        break;
    case LANG:
        add_short(a, "language", value, state);
        break;
    case ARGP_KEY_ARG:
        if (a->file && a->keys) argp_error(state, "one kind of case at a time");
        if (a->file) tr_cli_second_file(state, a->set, a->n_set, a->file, value);
        a->file = value;
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

/* From the first one on. */
static void print_notes(const tr_run_report *r, int first) {
    for (int k = first; k < r->n_notes; k++) fprintf(stderr, "note: %s\n", r->note[k]);
}

static void print_warnings(const tr_run_report *r) {
    print_notes(r, 0);
}

static void print_report(const tr_run_report *r, const char *dir) {
    for (int k = 0; k < r->n_lines; k++) printf("%-22s %s\n", r->line[k].label, r->line[k].value);
    printf("%-22s %s\n", "results", dir);
    fflush(stdout);
    print_notes(r, r->n_warnings);
}

static int run(const arguments *a) {
    tr_status st = {0};
    tr_scene scene;
    if (!tr_scene_read_file(&scene, a->file, a->set, a->n_set, tr_laws_catalog(), &st)) return tr_cli_fail(&st);
    if (a->sample && scene.kind != TR_KIND_BIAXIAL) {
        tr_scene_free(&scene);
        tr_status_fail(&st, TR_BAD_CASE, "error: --sample needs a case of kind: biaxial; %s has another kind", a->file);
        return tr_cli_fail(&st);
    }
    if (!tr_sample_file_read(&scene, &st)) return tr_scene_free(&scene), tr_cli_fail(&st);
    char name[256], dir[300];
    tr_cli_name(a->file, name, sizeof name);
    snprintf(dir, sizeof dir, "out/%s", name);
    tr_run_report report;
    if (!a->check) {
        tr_progress progress = tr_progress_begin();
        tr_run_options options = {.dir = a->dir ? a->dir : dir,
                                  .case_file = a->file,
                                  .title = name,
                                  .force = a->force,
                                  .resume = a->resume,
                                  .checkpoint = a->checkpoint,
                                  .sample = a->sample,
                                  .threads = a->threads,
                                  .stop = tr_cli_stop(),
                                  .progress = tr_progress_show,
                                  .context = &progress,
                                  .foretold = print_warnings};
        bool ok = tr_run(&scene, &options, &report, &st);
        tr_progress_end(&progress);
        if (ok) print_report(&report, options.dir);
        if (ok && report.failed)
            tr_status_fail(&st, TR_CHECK_FAILED, "error: %d of the checks of %s failed", report.failed, a->file);
    } else if (tr_run_check(&scene, &report, NULL, &st)) {
        print_warnings(&report);
        printf("%s: ok\n", a->file);
    }
    tr_scene_free(&scene);
    return st.code ? tr_cli_fail(&st) : TR_OK;
}

static int print_keys(const char *kind) {
    tr_status st = {0};
    char *text = tr_scene_keys(kind, tr_laws_catalog(), &st);
    if (!text) return tr_cli_fail(&st);
    fputs(text, stdout);
    free(text);
    return TR_OK;
}

int tr_cli_run(int argc, char **argv) {
    arguments a = {.checkpoint = 60};
    const struct argp argp = {
        options, parse, "CASE.yaml\n--keys [KIND]", "Runs a case file and writes curves, tables, frames and a film.", 0,
        0,       0};
    argv[0] = "trundle run";
    tr_cli_parse(&argp, argc, argv, &a);
    int code = a.keys ? print_keys(a.file) : run(&a);
    for (int k = 0; k < a.n_owned; k++) free(a.owned[k]);
    return code;
}
