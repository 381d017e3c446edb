/* SPDX-License-Identifier: MIT */
/* Group `stability`: the registry. */
#include "verify/stability.h"

const tr_verification tr_verify_stability[] = {
    {"stability", "time-step", "1000 random networks from 0.1 to 2 times the exact limit", "[Irons1971]",
     "core/timestep.c: share z/m of a body replaced by 1/m", tr_stability_networks},
    {"stability", "no-answer", "states that must end in a failure that says where", "outcome stated before the run",
     "core/world.c: thin skin not bounded by the smallest radius", tr_stability_failures},
};
const int tr_n_verify_stability = sizeof tr_verify_stability / sizeof *tr_verify_stability;
