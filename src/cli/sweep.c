/* SPDX-License-Identifier: MIT */
/* trundle sweep */
#include "base/threads.h"
#include "cli/name.h"
#include "cli/number.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "study/sweep.h"
#include "study/sweep_collect.h"
#include "study/sweep_read.h"
#include "study/sweep_run.h"
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LIST = 1000, INDEX, COLLECT, YES, MAX_JOBS = 4096 };

typedef struct arguments {
    const char *file, *dir;
    int jobs, index; /* index < 0: all */
    bool list, collect, yes;
    tr_progress progress;
} arguments;

static const struct argp_option options[] = {
    {"output", 'o', "DIR", 0,
     "directory of the points, of points.csv and collect.csv (default: out/ and the name of the sweep)", 0},
    {"jobs", 'j', "N", 0, "runs at once (default: the processors that this process may use)", 0},
    {"list", LIST, NULL, 0, "only list the points: number and directory", 0},
    {"index", INDEX, "K", 0, "run only point K, and collect nothing", 0},
    {"collect", COLLECT, NULL, 0, "only write points.csv and collect.csv, from the points that are finished", 0},
    {"yes", YES, NULL, 0, "allow more than 10000 points", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    switch (key) {
    case 'o':
        a->dir = value;
        break;
    case 'j':
        a->jobs = tr_cli_whole(value, 1, MAX_JOBS, "-j", state);
        break;
    case INDEX:
        a->index = tr_cli_whole(value, 0, 1000000000, "--index", state);
        break;
    case LIST:
        a->list = true;
        break;
    case COLLECT:
        a->collect = true;
        break;
    case YES:
        a->yes = true;
        break;
    case ARGP_KEY_ARG:
        if (a->file) argp_error(state, "one sweep at a time");
        a->file = value;
        break;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "which sweep?");
        break;
    case ARGP_KEY_END:
        if (a->list + a->collect + (a->index >= 0) > 1)
            argp_error(state, "only one of --list, --index, --collect at a time");
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static void say(void *context, const char *line) {
    arguments *a = context;
    tr_progress_end(&a->progress);
    fprintf(stderr, "%s\n", line);
}

static void show(void *context, const char *stage, double fraction) {
    arguments *a = context;
    tr_progress_show(&a->progress, stage, fraction);
}

static bool list(const tr_grid *g, tr_status *st) {
    char name[TR_POINT_NAME];
    if (!tr_grid_scenes(g, st)) return false;
    for (int point = 0; point < g->n; point++) {
        tr_grid_name(g, point, name);
        printf("%d %s\n", point, name);
    }
    return true;
}

static bool collect(const tr_grid *g, const arguments *a, tr_status *st) {
    int missing;
    if (!tr_grid_collect(g, a->dir, &missing, st)) return false;
    printf("%-22s %s/collect.csv\n", "results", a->dir);
    fflush(stdout);
    if (missing) fprintf(stderr, "note: %d of %d points are not finished and left out\n", missing, g->n);
    return true;
}

static bool run(const tr_grid *g, arguments *a, tr_status *st) {
    bool all = a->index < 0;
    tr_grid_options o = {.dir = a->dir,
                         .jobs = a->jobs ? a->jobs : tr_processors(),
                         .first = all ? 0 : a->index,
                         .end = all ? g->n : a->index + 1,
                         .stop = tr_cli_stop(),
                         .progress = show,
                         .say = say,
                         .context = a};
    if (o.end > g->n)
        return tr_status_fail(st, TR_BAD_CASE, "error: --index is %d, allowed is 0 to %d", a->index, g->n - 1);
    tr_grid_report report;
    a->progress = tr_progress_begin();
    tr_grid_run(g, &o, &report, st);
    tr_progress_end(&a->progress);
    bool tried = report.before + report.ran + report.failed == o.end - o.first;
    if (tried)
        printf("%-22s %d: %d finished before, %d run now, %d failed\n", "points", o.end - o.first, report.before,
               report.ran, report.failed);
    tr_status collecting = {0}; /* collect the finished points even if some points failed */
    if (all && tried && !collect(g, a, &collecting))
        tr_status_fail(st, collecting.code, "%s", collecting.text);
    return !st->code;
}

int tr_cli_sweep(int argc, char **argv) {
    arguments a = {.index = -1};
    tr_status st = {0};
    tr_grid grid;
    const struct argp argp = {options,
                              parse,
                              "SWEEP.yaml",
                              "Runs a case for each point of a grid of values and seeds, those that are not "
                              "finished, and collects means over the seeds.",
                              0,
                              0,
                              0};
    argv[0] = "trundle sweep";
    tr_cli_parse(&argp, argc, argv, &a);
    char name[256], dir[300];
    tr_cli_name(a.file, name, sizeof name);
    snprintf(dir, sizeof dir, "out/%s", name);
    if (!a.dir) a.dir = dir;
    if (tr_grid_read(&grid, a.file, a.yes, &st)) {
        if (a.list)
            list(&grid, &st);
        else if (a.collect)
            collect(&grid, &a, &st);
        else
            run(&grid, &a, &st);
    }
    tr_grid_free(&grid);
    return st.code ? tr_cli_fail(&st) : TR_OK;
}
