/* SPDX-License-Identifier: MIT */
/* No law: a scene that chooses it has no pass, no history and no pair constant of that kind. */
#include "laws/law.h"

enum { ALL_CLAIMS = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED };

const tr_law tr_friction_none = {
    .table = {.name = "none", .doc = "no friction"},
    .formula = "Q = 0",
    .claims = ALL_CLAIMS,
};

const tr_law tr_rolling_none = {
    .table = {.name = "none", .doc = "no rolling resistance"},
    .formula = "no moments",
    .claims = ALL_CLAIMS,
};
