/* SPDX-License-Identifier: MIT */
/* What features cost. */
#ifndef TR_CLI_BENCH_FEATURES_H
#define TR_CLI_BENCH_FEATURES_H

#include "cli/bench_case.h"

bool tr_cli_bench_features(const tr_bench_arguments *a, tr_status *st);

#endif
