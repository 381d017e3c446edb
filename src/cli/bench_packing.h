/* SPDX-License-Identifier: MIT */
/* A packing for LAMMPS. */
#ifndef TR_CLI_BENCH_PACKING_H
#define TR_CLI_BENCH_PACKING_H

#include "cli/bench_case.h"

bool tr_cli_bench_packing(const tr_bench_arguments *a, tr_status *st);

#endif
