/* SPDX-License-Identifier: MIT */
/* What must hold of the directory of any run. Each returns true, or false and what is wrong in `why`. */
#ifndef TR_RANDOM_ORACLES_H
#define TR_RANDOM_ORACLES_H

#include "scene/scene.h"

typedef struct oracle_text {
    char text[1024];
} oracle_text;

/* Every cell of a table and every value of summary.json is a number, but those that may have none. */
bool oracle_numbers(const char *dir, oracle_text *why);

/* No centre is beyond a wall; and what is between four walls has room there. */
bool oracle_inside(const tr_scene *scene, const char *dir, oracle_text *why);

/* The energy ledger of a biaxial test. */
bool oracle_energy(const tr_scene *scene, const char *dir, oracle_text *why);

/* The same files with the same bytes, but timing. failed: both have failed, and checkpoints may differ. */
bool oracle_same(const char *dir, const char *reference, oracle_text *why);

#endif
