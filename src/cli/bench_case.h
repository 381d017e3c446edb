/* SPDX-License-Identifier: MIT */
/* Options of trundle bench, and its case. */
#ifndef TR_CLI_BENCH_CASE_H
#define TR_CLI_BENCH_CASE_H

#include "scene/scene.h"

enum { TR_BENCH_SETS = 64 };
typedef struct tr_bench_arguments {
    const char *file, *out, *packing, *set[TR_BENCH_SETS];
    int n_set;
    bool features;
    int threads; /* 0: one */
    int largest; /* of --sizes; 0: not given */
} tr_bench_arguments;

/* Reads its case with these further n settings. */
bool tr_cli_bench_case(const tr_bench_arguments *a, const char *const *more, int n, tr_scene *scene, tr_status *st);

#endif
