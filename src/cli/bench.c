/* SPDX-License-Identifier: MIT */
/* trundle bench */
#include "base/threads.h"
#include "cli/bench_case.h"
#include "cli/bench_features.h"
#include "cli/bench_packing.h"
#include "cli/bench_sizes.h"
#include "cli/number.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "laws/law.h"
#include "study/bench.h"
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>

enum { SET = 1000, FEATURES, SIZES, PACKING, THREADS };

static const struct argp_option options[] = {
    {"set", SET, "KEY=VALUE", 0, "override a key: --set sample.disks=10000", 0},
    {"features", FEATURES, NULL, 0, "cost of each feature and each law, on the same packing", 0},
    {"sizes", SIZES, "N", 0, "time of a step with 100 to N disks (N from 100 to 1000000)", 0},
    {"packing", PACKING, "DIR", 0, "write a packing for LAMMPS into DIR, and shear it: see tests/bench/peers.sh", 0},
    {"threads", THREADS, "N", 0, "number of threads, for more than 4000 disks (default: 1)", 0},
    {"output", 'o', "OUT.csv", 0, "with --features or --sizes: also write the table to OUT.csv", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state) {
    tr_bench_arguments *a = state->input;
    if (key == SET && a->n_set == TR_BENCH_SETS) argp_error(state, "more than %d overrides", TR_BENCH_SETS);
    if (key == SET)
        a->set[a->n_set++] = value;
    else if (key == FEATURES)
        a->features = true;
    else if (key == THREADS)
        a->threads = tr_cli_whole(value, 1, TR_MOST_THREADS, "--threads", state);
    else if (key == PACKING)
        a->packing = value;
    else if (key == SIZES)
        a->largest = tr_cli_whole(value, 100, 1000000, "--sizes", state);
    else if (key == 'o')
        a->out = value;
    else if (key == ARGP_KEY_ARG && !a->file)
        a->file = value;
    else if (key == ARGP_KEY_ARG)
        tr_cli_second_file(state, a->set, a->n_set, a->file, value);
    else if (key == ARGP_KEY_END && a->out && !a->features && !a->largest)
        argp_error(state, "-o needs --features or --sizes");
    else if (key == ARGP_KEY_END && (a->features) + (a->largest > 0) + (a->packing != NULL) > 1)
        argp_error(state, "only one of --features, --sizes and --packing at a time");
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

static void print_table(const char *title, const tr_bench_report *r) {
    printf("%s: %.1f M/s (quartiles %.1f to %.1f), %.2f us per step, %.0f touching of %.0f listed contacts, %.0f bytes "
           "per disk\n",
           title, 1e3 / r->ns.median, 1e3 / r->ns.high, 1e3 / r->ns.low, r->us_per_step, r->touching, r->listed,
           r->bytes_per_disk);
    for (int k = 0; k < r->n_passes; k++) printf("  %-28s %6.2f ns per contact\n", r->pass[k].name, r->pass[k].ns);
    printf("\n");
}

static bool passes(const tr_bench_arguments *a, tr_status *st) {
    tr_scene scene[2] = {0};
    tr_bench_report report[2];
    bool ok = tr_cli_bench_case(a, NULL, 0, &scene[0], st) &&
              tr_cli_bench_case(a, (const char *const[]){"contact.rolling=none"}, 1, &scene[1], st);
    for (int i = 0; i < 2; i++) scene[i].output.energy = false, scene[i].output.frames = 0;
    ok = ok && tr_bench((const tr_scene *const[]){&scene[0], &scene[1]}, 2, a->threads, true, report, st);
    tr_scene_free(&scene[0]), tr_scene_free(&scene[1]);
    if (!ok) return false;
    print_table("as given", &report[0]);
    print_table("without rolling resistance", &report[1]);
    printf("%.1f M contact updates/s\n", 1e3 / report[0].ns.median);
    return true;
}

int tr_cli_bench(int argc, char **argv) {
    tr_bench_arguments a = {0};
    const struct argp argp = {
        options,
        parse,
        "[CASE.yaml]",
        "Shears a sample (default: that of cases/biaxial.yaml) with all its laws and without rolling resistance, and "
        "prints what a contact costs. A contact update is one touching contact in one whole step. With --features: the "
        "same packing with features added one at a time and laws exchanged one at a time, over the start of the "
        "shear; exit code 1 if what is left out still costs. With --sizes: whole steps of samples from 100 disks up.",
        0,
        0,
        0};
    argv[0] = "trundle bench";
    tr_cli_parse(&argp, argc, argv, &a);
    tr_status st = {0};
    return (a.features  ? tr_cli_bench_features(&a, &st)
            : a.largest ? tr_cli_bench_sizes(&a, &st)
            : a.packing ? tr_cli_bench_packing(&a, &st)
                        : passes(&a, &st))
               ? TR_OK
               : tr_cli_fail(&st);
}
