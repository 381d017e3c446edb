/* SPDX-License-Identifier: MIT */
/* How fast the contact loop is, on a sample that is really sheared, list renewals included. Times are those of the thread: what
 * else the machine does is not in them, but for the caches that it takes. */
#ifndef TR_BENCH_H
#define TR_BENCH_H

#include "base/status.h"
#include "core/biaxial.h"
#include "scene/scene.h"

typedef struct tr_quartiles {
    double low, median, high; /* over blocks of the shear */
} tr_quartiles;

tr_quartiles tr_bench_quartiles(const double *values, int n);

/* Time of this thread, so that a busy machine disturbs less [s]; of the wall where threads share the work of the world, for
 * waiting counts. */
double tr_bench_clock(const tr_world *world);

typedef struct tr_bench_report {
    tr_quartiles ns;         /* of a whole step, per touching contact [ns] */
    tr_quartiles share;      /* time of a step over that of the first scene, in the same block [1] */
    tr_quartiles frame;      /* drawing one, where the scene has frames [s] */
    double us_per_step;      /* median [us] */
    double steps;            /* of the shear */
    double touching, listed; /* contacts, mean over the shear; in the list that the step walks */
    double bytes_per_disk;
    int histories; /* arrays */
    int n_passes; /* each: ns per touching contact, on the last state of the shear; differences of interleaved medians */
    struct tr_bench_pass {
        char name[32];
        double ns;
    } pass[16];
} tr_bench_report;

/* Compacts and shears the first scene (kind: biaxial), a block of steps at a time. The others shear the same packing: before
 * each block of the first they take positions and velocities from it, so that contacts differ by no more than one block
 * makes. A block of each in turn, so that what the machine does falls on all alike. The first step of a block, which makes the
 * list anew, does not count. passes: time each pass too. */
bool tr_bench(const tr_scene *const *scenes, int n, int threads, bool passes, tr_bench_report *reports, tr_status *st);

/* ---- cost against the number of disks: bench_sizes.c ---- */

enum { TR_BENCH_CYCLES = 5 }; /* repeats; 3 above 100000 disks */

typedef struct tr_bench_size {
    int disks;
    tr_quartiles us, ns;              /* of a whole step [us]; the same per touching contact [ns]; over the cycles */
    double touching, listed;          /* contacts, mean */
    double steps, refreshes, rebuild; /* of a cycle; lists made in it; the share of its time that they take [1] */
    double bytes_per_disk;
} tr_bench_size;

/* Shears samples of sizes[].disks in turn, a cycle of each: from one search of all pairs to the next, so that a cycle has its
 * share of everything that a long run does. Up to 1000 disks the sample is that of the scene; above, a multiple of 1000, it is
 * tiled, see there. */
bool tr_bench_sizes(const tr_scene *scene, int threads, tr_bench_size *sizes, int n, tr_status *st);

/* Until it is at rest. */
bool tr_bench_compact(tr_biaxial *b, tr_status *st);

/* Replaces a loose sample by columns x rows images of a compacted one, as nearly square as can be: at rest, no laws set. Its size
 * is a multiple of that of the tile. */
bool tr_bench_tile(tr_biaxial *to, const tr_biaxial *tile, tr_status *st);

/* s of y = c x^s, by least squares of the logarithms. */
double tr_bench_slope(const double *x, const double *y, int n);

/* ---- the same packing in LAMMPS: bench_packing.c ---- */

enum { TR_BENCH_COMPARED = 1000, TR_BENCH_TIMED = 5000 }; /* steps: up to where states are compared; then, timed */

typedef struct tr_bench_state {
    int touching;
    double kinetic, spinning; /* energy of the disks that are not held [N] */
    double xx, yy;            /* sums of force times branch over the contacts: stress times area [N] */
} tr_bench_state;

/* Writes dir/packing.data and dir/packing.lmp for LAMMPS, then takes the steps: the state after either part, and the time of a
 * step of the second [us]. */
bool tr_bench_packing(const tr_scene *scene, int threads, const char *dir, tr_bench_state state[2], double *us,
                      tr_status *st);

#endif
