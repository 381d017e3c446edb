/* SPDX-License-Identifier: MIT */
/* trundle verify */
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "verify/groups.h"
#include "verify/verify.h"
#include <argp.h>
#include <stdio.h>
#include <string.h>

enum { LIST = 1000, MAX_NAMES = 64 };

typedef struct arguments {
    const char *dir, *name[MAX_NAMES];
    int n;
    bool list;
} arguments;

static const struct argp_option options[] = {
    {"output", 'o', "DIR", 0, "also write the tables, DIR/verify.csv and DIR/points.csv", 0},
    {"list", LIST, NULL, 0, "only list the verifications", 0},
    {0},
};

/* A name of a verification, or of a group. */
static bool wanted(const arguments *a, const tr_verification *v) {
    if (a->n == 0) return a->list || strcmp(v->group, "exact") == 0;
    for (int k = 0; k < a->n; k++)
        if (strcmp(a->name[k], v->name) == 0 || strcmp(a->name[k], v->group) == 0) return true;
    return false;
}

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    switch (key) {
    case 'o':
        a->dir = value;
        break;
    case LIST:
        a->list = true;
        break;
    case ARGP_KEY_ARG: {
        const arguments one = {.name = {value}, .n = 1};
        bool known = false;
        for (int i = 0; tr_verification_at(i); i++) known |= wanted(&one, tr_verification_at(i));
        if (!known) argp_error(state, "no verification and no group `%s`; see --list", value);
        if (a->n == MAX_NAMES) argp_error(state, "more than %d names", MAX_NAMES);
        a->name[a->n++] = value;
        break;
    }
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static void print_row(const tr_verified *r) {
    const tr_verify_row *row = &r->row;
    printf("  %-6s %-44s", r->ok ? "ok" : "FAILED", r->quantity);
    if (!isnan(row->computed))
        printf(" %.6g, exact %.6g %s, error %.1e, allowed %.1e", row->computed, row->reference,
               strcmp(r->unit, "1") == 0 ? "" : r->unit, row->computed - row->reference, row->tolerance);
    if (!isnan(row->order)) printf(", order %.1f", row->order);
    if (*r->outcome) printf(" %s", r->outcome);
    printf("\n");
}

static bool run_one(tr_verify *v, const tr_verification *which, tr_status *st) {
    int first = v->n;
    printf("%s %s: %s  [%s]\n", which->group, which->name, which->what, which->source);
    fflush(stdout);
    bool ok = tr_verify_run(v, which, st);
    for (int i = first; i < v->n; i++) print_row(&v->row[i]);
    return ok;
}

int tr_cli_verify(int argc, char **argv) {
    arguments a = {0};
    tr_status st = {0};
    tr_verify v = {.stop = tr_cli_stop()};
    const struct argp argp = {options,
                              parse,
                              "[GROUP|NAME...]",
                              "Compares what the code computes with answers from elsewhere. Groups: exact (the "
                              "default), precision (error against run time), stability (stiff and extreme cases).",
                              0,
                              0,
                              0};
    argv[0] = "trundle verify";
    tr_cli_parse(&argp, argc, argv, &a);
    if (a.dir && !a.list) tr_verify_claim(a.dir, &st);
    for (int i = 0; tr_verification_at(i) && !st.code; i++) {
        const tr_verification *which = tr_verification_at(i);
        if (!wanted(&a, which)) continue;
        if (a.list)
            printf("%-10s %-24s %s\n", which->group, which->name, which->what);
        else
            run_one(&v, which, &st);
    }
    if (a.dir && !a.list && !st.code) tr_verify_write(&v, a.dir, &st);
    if (!a.list) printf("%d of %d numbers are right\n", v.n - v.failed, v.n);
    fflush(stdout);
    if (v.failed) tr_status_fail(&st, TR_CHECK_FAILED, "error: %d of the numbers are wrong", v.failed);
    tr_verify_free(&v);
    return st.code ? tr_cli_fail(&st) : TR_OK;
}
