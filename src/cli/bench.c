/* SPDX-License-Identifier: MIT */
/* trundle bench */
#include "cli/cli.h"

#include "laws/law.h"
#include "study/bench.h"
#include <argp.h>
#include <stdio.h>

enum { MAX_SETS = 64, SET = 1000 };

typedef struct arguments {
    const char *file, *set[MAX_SETS + 1];
    int n_set;
} arguments;

static const struct argp_option options[] = {
    {"set", SET, "KEY=VALUE", 0, "override a key: --set sample.disks=10000", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    if (key == SET && a->n_set == MAX_SETS) argp_error(state, "more than %d overrides", MAX_SETS);
    if (key == SET)
        a->set[a->n_set++] = value;
    else if (key == ARGP_KEY_ARG && !a->file)
        a->file = value;
    else if (key == ARGP_KEY_ARG)
        argp_error(state, "one case file at a time");
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

/* The biaxial test of cases/biaxial.yaml: what is not said here is default. */
static const char default_case[] = "kind: biaxial\n"
                                   "sample: {r_min: 0.76 mm, r_max: 1.52 mm}\n"
                                   "contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5}\n"
                                   "compaction: {pressure: 160 kPa}\n";

static bool read_case(const arguments *a, tr_scene *scene, tr_status *st) {
    bool ok = a->file ? tr_scene_read_file(scene, a->file, a->set, a->n_set, tr_laws_catalog(), st)
                      : tr_scene_read(scene, "(default case)", default_case, sizeof default_case - 1, a->set, a->n_set,
                                      tr_laws_catalog(), st);
    if (ok && scene->kind != TR_KIND_BIAXIAL)
        ok = tr_status_fail(st, TR_BAD_CASE, "error: bench needs a case of kind: biaxial");
    return ok;
}

static void print_table(const char *title, const tr_bench_report *r) {
    printf("%s: %.1f M/s (quartiles %.1f to %.1f), %.2f us per step, %.0f touching of %.0f listed contacts, %.0f bytes "
           "per disk\n",
           title, r->updates_per_s / 1e6, r->low / 1e6, r->high / 1e6, r->us_per_step, r->touching, r->listed,
           r->bytes_per_disk);
    for (int k = 0; k < r->n_passes; k++) printf("  %-28s %6.2f ns per contact\n", r->pass[k].name, r->pass[k].ns);
    printf("\n");
}

int tr_cli_bench(int argc, char **argv) {
    arguments a = {0};
    argp_err_exit_status = TR_BAD_CASE;
    const struct argp argp = {
        options,
        parse,
        "[CASE.yaml]",
        "Shears a sample (default: that of cases/biaxial.yaml) with all its laws and without rolling resistance, and "
        "prints what a contact costs. A contact update is one touching contact in one whole step.",
        0,
        0,
        0};
    argv[0] = "trundle bench";
    argp_parse(&argp, argc, argv, 0, NULL, &a);
    tr_status st = {0};
    tr_scene scene[2] = {0};
    tr_bench_report report[2];
    bool ok = read_case(&a, &scene[0], &st);
    a.set[a.n_set++] = "contact.rolling=none";
    ok = ok && read_case(&a, &scene[1], &st) &&
         tr_bench((const tr_scene *const[]){&scene[0], &scene[1]}, 2, report, &st);
    tr_scene_free(&scene[0]), tr_scene_free(&scene[1]);
    if (!ok) return tr_cli_fail(&st);
    print_table("as given", &report[0]);
    print_table("without rolling resistance", &report[1]);
    printf("%.1f M contact updates/s\n", report[0].updates_per_s / 1e6);
    return TR_OK;
}
