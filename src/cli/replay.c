/* SPDX-License-Identifier: MIT */
/* trundle replay */
#include "base/threads.h"
#include "cli/number.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "study/replay.h"
#include "study/replay_write.h"
#include <argp.h>
#include <stdio.h>

enum { EVERY = 1000 };

static const struct argp_option options[] = {
    {"output", 'o', "DIR", 0, "directory of the tables (default: directory of the run)", 0},
    {"jobs", 'j', "N", 0, "threads (default: the processors that this process may use); the result is the same", 0},
    {"elements", 'n', "N", 0, "elements across a contact (default: 60)", 0},
    {"every", EVERY, "K", 0, "replay only each K-th contact, and leave out the stress", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state) {
    tr_replay_options *o = state->input;
    if (key == 'o')
        o->dir = value;
    else if (key == 'j')
        o->jobs = tr_cli_whole(value, 1, 4096, "-j", state);
    else if (key == 'n')
        o->elements = tr_cli_whole(value, 3, 4000, "-n", state);
    else if (key == EVERY)
        o->every = tr_cli_whole(value, 1, 1000000000, "--every", state);
    else if (key == ARGP_KEY_ARG && !o->run)
        o->run = value;
    else if (key == ARGP_KEY_ARG)
        argp_error(state, "one run at a time");
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which run?");
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

int tr_cli_replay(int argc, char **argv) {
    static tr_run_report report;
    tr_progress progress = tr_progress_begin();
    tr_replay_options o = {
        .jobs = tr_processors(), .elements = 60, .every = 1, .progress = tr_progress_show, .context = &progress};
    const struct argp argp = {
        options,
        parse,
        "RUN",
        "Takes every contact of a biaxial test that was run with output.path_rows along the path that "
        "it had, through the exact half-plane and through every friction law, and writes how far each "
        "is off: replay.csv, replay-errors.csv, replay-stress.csv. RUN is the directory of the run.",
        0,
        0,
        0};
    argv[0] = "trundle replay";
    tr_cli_parse(&argp, argc, argv, &o);
    o.stop = tr_cli_stop();
    if (!o.dir) o.dir = o.run;
    tr_status st = {0};
    tr_replay r;
    bool ok = tr_replay_run(&r, &o, &report, &st);
    tr_progress_end(&progress);
    ok = ok && tr_replay_write(&r, &o, &report, &st);
    tr_replay_free(&r);
    if (!ok) return tr_cli_fail(&st);
    for (int k = 0; k < report.n_lines; k++) printf("%-28s %s\n", report.line[k].label, report.line[k].value);
    printf("%-28s %s\n", "results", o.dir);
    fflush(stdout);
    for (int k = 0; k < report.n_notes; k++) fprintf(stderr, "note: %s\n", report.note[k]);
    return TR_OK;
}
