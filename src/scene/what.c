/* SPDX-License-Identifier: MIT */
#include "scene/what.h"

#define ROW(choice, name, dim, unit, whose, when, function) [choice] = {name, unit, whose, when},
const tr_what_row tr_whats[TR_N_WHATS] = {TR_WHATS(ROW)};

#define COLUMN(name, dim, unit) {#name, unit},
const tr_column_row tr_columns[TR_N_PATCH_COLUMNS] = {TR_COLUMNS(COLUMN) TR_PATCH_COLUMNS(COLUMN)};
