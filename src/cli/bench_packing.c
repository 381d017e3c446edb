/* SPDX-License-Identifier: MIT */
/* trundle bench --packing DIR: trundle's half of tests/bench/peers.sh. Its lines have the form of LAMMPS' thermo
 * output. */
#include "cli/bench_packing.h"

#include "cli/bench_case.h"
#include "study/bench.h"
#include "study/bench_packing.h"
#include <stdio.h>

bool tr_cli_bench_packing(const tr_bench_arguments *a, tr_status *st) {
    tr_scene scene = {0};
    tr_bench_state state[2];
    double us;
    bool ok =
        tr_cli_bench_case(a, NULL, 0, &scene, st) && tr_bench_packing(&scene, a->threads, a->packing, state, &us, st);
    int disks = scene.sample.disks;
    tr_scene_free(&scene);
    if (!ok) return false;
    printf("%d disks, %.4f us per step\nstep touching kinetic spinning xx yy\n", disks, us);
    for (int k = 0; k < 2; k++)
        printf("%d %d %.12g %.12g %.12g %.12g\n", TR_BENCH_COMPARED + k * TR_BENCH_TIMED, state[k].touching,
               state[k].kinetic, state[k].spinning, state[k].xx, state[k].yy);
    return true;
}
