/* SPDX-License-Identifier: MIT */
/* Group `stability`: what its files share. Each case says before it runs how it must end: with the right answer, or
 * with TR_NUMERICAL, a text that says where, and a readable state. Never with NaN, never silently. */
#ifndef TR_VERIFY_STABILITY_H
#define TR_VERIFY_STABILITY_H

#include "core/bodies.h"
#include "verify/verify.h"

/* A scene of bodies that runs step by step: open, then steps, then close. read: the scene was read, so close frees
 * it. */
typedef struct tr_stability_run {
    tr_scene scene;
    tr_bodies b;
    bool open;
} tr_stability_run;

bool tr_stability_open(tr_stability_run *run, const char *text, const char *const *sets, int n_sets, tr_status *st);
bool tr_stability_step(tr_stability_run *run, tr_status *st); /* forces, then advance */
void tr_stability_close(tr_stability_run *run);

/* All positions, velocities, forces and contact records are finite, and no friction is above its bound. */
bool tr_stability_readable(tr_world *world);

/* Kinetic energy, elastic energy of all contacts and that of the load, at the time of the positions, after
 * tr_step_forces [N]. */
double tr_stability_energy(tr_world *world);

#endif
