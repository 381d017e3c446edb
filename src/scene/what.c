/* SPDX-License-Identifier: MIT */
#include "scene/what.h"

#define ROW(choice, name, dim, unit, whose, when, function) [choice] = {name, unit, whose, when},
const tr_what_row tr_whats[TR_N_WHATS] = {TR_WHATS(ROW)};
