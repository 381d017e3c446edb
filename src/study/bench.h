/* SPDX-License-Identifier: MIT */
/* How fast the contact loop is, on a sample that is really sheared: list renewals included, ledger and output off. */
#ifndef TR_BENCH_H
#define TR_BENCH_H

#include "base/status.h"
#include "scene/scene.h"

typedef struct tr_bench_report {
    double updates_per_s, low, high; /* whole steps: median, lower and upper quartile over blocks of the shear [1/s] */
    double us_per_step;              /* median [us] */
    double touching, listed;         /* contacts, mean over the shear; in the list that the step walks */
    double bytes_per_disk;
    int n_passes; /* each: ns per touching contact, on the last state of the shear; differences of interleaved medians */
    struct tr_bench_pass {
        char name[32];
        double ns;
    } pass[16];
} tr_bench_report;

/* Compacts and shears n scenes (kind: biaxial), a block of steps of each in turn, so that what else the machine does falls on all
 * alike. */
bool tr_bench(const tr_scene *const *scenes, int n, tr_bench_report *reports, tr_status *st);

#endif
