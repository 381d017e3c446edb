/* SPDX-License-Identifier: MIT */
/* Speed of the contact loop on a sheared sample, including list renewals. Times are those of the thread: other work of
 * the machine does not count, except for the caches that it takes. */
#ifndef TR_BENCH_H
#define TR_BENCH_H

#include "base/status.h"
#include "core/biaxial.h"
#include "scene/scene.h"

typedef struct tr_quartiles {
    double low, median, high; /* over blocks of the shear */
} tr_quartiles;

tr_quartiles tr_bench_quartiles(const double *values, int n);

/* Time of this thread, so that a busy machine disturbs less [s]; wall time if several threads work on the world,
 * because waiting counts. */
double tr_bench_clock(const tr_world *world);

typedef struct tr_bench_report {
    tr_quartiles ns;         /* of a whole step, per touching contact [ns] */
    tr_quartiles share;      /* time of a step over that of the first scene, in the same block [1] */
    tr_quartiles frame;      /* drawing one, if the scene has frames [s] */
    double us_per_step;      /* median [us] */
    double steps;            /* of the shear */
    double touching, listed; /* contacts, mean over the shear; in the list that the step walks */
    double bytes_per_disk;
    int histories; /* arrays */
    int n_passes;  /* each: ns per touching contact, on the last state of the shear; differences of interleaved
                   * medians */
    struct tr_bench_pass {
        char name[32];
        double ns;
    } pass[16];
} tr_bench_report;

/* Compacts and shears the first scene (kind: biaxial), a block of steps at a time. The others shear the same packing:
 * before each block of the first they take its positions and velocities, so that contacts differ by at most one block.
 * Scenes take turns, a block each, so that changes of the machine affect all alike. The first step of a block makes the
 * list again and does not count.
 *
 * passes: time each pass too; every scene has its own sample, as in a run. A scene in the packing of another scene is
 * not at rest: it moves more than in a run, and lists are made more often. */
bool tr_bench(const tr_scene *const *scenes, int n, int threads, bool passes, tr_bench_report *reports, tr_status *st);

#endif
