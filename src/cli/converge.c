/* SPDX-License-Identifier: MIT */
/* trundle converge */
#include "study/converge.h"

#include "base/threads.h"
#include "cli/name.h"
#include "cli/number.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OF = 1000, TO, PLAN, BUDGET, MAX_JOBS = 4096 };

typedef struct arguments {
    tr_converge_options o;
    bool percent; /* --to had a bare number: `%` may follow */
    tr_progress progress;
} arguments;

static const struct argp_option options[] = {
    {"output", 'o', "DIR", 0, "directory of the results (default: out/ and the name of the case, -converge)", 0},
    {"jobs", 'j', "N", 0, "runs at once (default: the processors that this process may use)", 0},
    {"of", OF, "NAMES", 0,
     "numbers to look at, commas between them: those of summary.json (sin_phi_peak,checks.0.measured), or cells of a "
     "table "
     "(history.sin_phi@0.05, history.DISK.COLUMN@TIME, contact.LAW.COLUMN@SEGMENT, ...@end); default: what the kind is "
     "quoted by",
     0},
    {"to", TO, "ERROR", 0, "error that is asked for: 1 % or 0.01 of each number (default: 1 %)", 0},
    {"plan", PLAN, NULL, 0, "run nothing: tell what would run and about how long it takes", 0},
    {"budget", BUDGET, "TIME", 0, "wall time that this may take: 90 s, 10min, 2 h (default: 10min)", 0},
    {0},
};

static double error_of(const char *text, bool *percent, struct argp_state *state) {
    char *end;
    double x = strtod(text, &end);
    while (*end == ' ') end++;
    bool has_sign = !strcmp(end, "%");
    if (end == text || (*end && !has_sign) || !(x > 0) || !isfinite(x))
        argp_error(state, "--to takes 1 %% or 0.01, not `%.40s`", text);
    *percent = !has_sign;
    return has_sign ? x / 100 : x;
}

static double time_of(const char *text, struct argp_state *state) {
    static const struct {
        const char *name;
        double seconds;
    } units[] = {{"", 1}, {"s", 1}, {"min", 60}, {"h", 3600}};
    char *end;
    double x = strtod(text, &end);
    while (*end == ' ') end++;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (end > text && !strcmp(end, units[i].name) && x > 0 && isfinite(x)) return x * units[i].seconds;
    argp_error(state, "--budget takes a time, 90 s, 10min or 2 h, not `%.40s`", text);
    return 0;
}

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    switch (key) {
    case 'o':
        a->o.dir = value;
        break;
    case 'j':
        a->o.jobs = tr_cli_whole(value, 1, MAX_JOBS, "-j", state);
        break;
    case OF:
        a->o.of = value;
        break;
    case TO:
        a->o.to = error_of(value, &a->percent, state);
        break;
    case PLAN:
        a->o.plan = true;
        break;
    case BUDGET:
        a->o.budget = time_of(value, state);
        break;
    case ARGP_KEY_ARG:
        if (a->percent && !strcmp(value, "%")) {
            a->o.to /= 100, a->percent = false;
            break;
        }
        if (a->o.case_file) argp_error(state, "one case at a time");
        a->o.case_file = value;
        break;
    case ARGP_KEY_END:
        if (!a->o.case_file) argp_error(state, "which case?");
        if (a->o.to >= 1) argp_error(state, "--to is %g times the number; 1 %% is 0.01", a->o.to);
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

int tr_cli_converge(int argc, char **argv) {
    arguments a = {.o = {.to = 0.01, .budget = 600, .stop = tr_cli_stop(), .progress = show, .say = say}};
    const struct argp argp = {
        options,
        parse,
        "CASE.yaml",
        "Tells how wrong the numbers of a case are, and why: runs it with finer and coarser settings, and other "
        "seeds, and writes tables, error against run time, and what to set for the error that is asked.",
        0,
        0,
        0};
    char name[256], dir[300], *text = NULL;
    tr_status st = {0};
    argv[0] = "trundle converge";
    tr_cli_parse(&argp, argc, argv, &a);
    tr_cli_name(a.o.case_file, name, sizeof name);
    snprintf(dir, sizeof dir, "out/%s-converge", name);
    a.o.context = &a;
    if (!a.o.dir) a.o.dir = dir;
    if (!a.o.jobs) a.o.jobs = tr_processors();
    a.progress = tr_progress_begin();
    tr_converge_run(&a.o, &text, &st);
    tr_progress_end(&a.progress);
    if (!st.code) {
        fputs(text, stdout);
        if (!a.o.plan) printf("\n%-22s %s\n", "results", a.o.dir);
    }
    free(text);
    return st.code ? tr_cli_fail(&st) : TR_OK;
}
