/* SPDX-License-Identifier: MIT */
/* Cost against the number of disks. */
#ifndef TR_BENCH_SIZES_H
#define TR_BENCH_SIZES_H

#include "study/bench.h"

enum { TR_BENCH_CYCLES = 5 }; /* repeats; 3 above 100000 disks */

typedef struct tr_bench_size {
    int disks;
    tr_quartiles us, ns;              /* of a whole step [us]; the same per touching contact [ns]; over the cycles */
    double touching, listed;          /* contacts, mean */
    double steps, refreshes, rebuild; /* of a cycle; lists made in it; the fraction of its time for them [1] */
    double bytes_per_disk;
} tr_bench_size;

/* Shears samples of sizes[].disks in turn, a cycle of each: from one search of all pairs to the next, so that a cycle
 * has a fair part of everything that a long run does. Up to 1000 disks the sample is that of the scene; above, a
 * multiple of 1000, it is tiled, see there. */
bool tr_bench_sizes(const tr_scene *scene, int threads, tr_bench_size *sizes, int n, tr_status *st);

/* Until it is at rest. */
bool tr_bench_compact(tr_biaxial *b, tr_status *st);

/* Replaces a loose sample by columns x rows images of a compacted one, as square as possible: at rest, no laws set. Its
 * size is a multiple of that of the tile. */
bool tr_bench_tile(tr_biaxial *to, const tr_biaxial *tile, tr_status *st);

/* s of y = c x^s, by least squares of the logarithms. */
double tr_bench_slope(const double *x, const double *y, int n);

#endif
