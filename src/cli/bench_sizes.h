/* SPDX-License-Identifier: MIT */
/* Time of a step against the number of disks. */
#ifndef TR_CLI_BENCH_SIZES_H
#define TR_CLI_BENCH_SIZES_H

#include "cli/bench_case.h"

bool tr_cli_bench_sizes(const tr_bench_arguments *a, tr_status *st);

#endif
