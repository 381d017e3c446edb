/* SPDX-License-Identifier: MIT */
/* The same packing in LAMMPS. */
#ifndef TR_BENCH_PACKING_H
#define TR_BENCH_PACKING_H

#include "core/biaxial.h"

enum { TR_BENCH_COMPARED = 1000, TR_BENCH_TIMED = 5000 }; /* steps: up to where states are compared; then, timed */

typedef struct tr_bench_state {
    int touching;
    double kinetic, spinning; /* energy of the disks that are free [N] */
    double xx, yy;            /* sums of force times branch over the contacts: stress times area [N] */
} tr_bench_state;

/* Writes dir/packing.data and dir/packing.lmp for LAMMPS, then takes the steps: the state after either part, and the
 * time of a step of the second [us]. */
bool tr_bench_packing(const tr_scene *scene, int threads, const char *dir, tr_bench_state state[2], double *us,
                      tr_status *st);

#endif
