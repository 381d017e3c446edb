/* SPDX-License-Identifier: MIT */
/* Group `stability`: what its files share. Each case says before it runs how it must end: with the right answer, or with
 * TR_NUMERICAL and a text that says where, and a state that can be read. Never with NaN, never in silence. */
#ifndef TR_VERIFY_STABILITY_H
#define TR_VERIFY_STABILITY_H

#include "core/bodies.h"
#include "verify/verify.h"

bool tr_stability_networks(tr_verify *v, tr_status *st);
bool tr_stability_sliding(tr_verify *v, tr_status *st);
bool tr_stability_not_conjugate(tr_verify *v, tr_status *st);
bool tr_stability_failures(tr_verify *v, tr_status *st);
bool tr_stability_coefficients(tr_verify *v, tr_status *st);
bool tr_stability_thresholds(tr_verify *v, tr_status *st);
bool tr_stability_sizes(tr_verify *v, tr_status *st);
bool tr_stability_far(tr_verify *v, tr_status *st);
bool tr_stability_six_contacts(tr_verify *v, tr_status *st);
bool tr_stability_pure_motions(tr_verify *v, tr_status *st);
bool tr_stability_unloading(tr_verify *v, tr_status *st);
bool tr_stability_full_slip(tr_verify *v, tr_status *st);
bool tr_stability_biaxial(tr_verify *v, tr_status *st);

/* A scene of bodies that runs step by step: open, then steps, then close. read: the scene was read, so close frees it. */
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

/* Kinetic energy, elastic energy of all contacts and that of the load, at the time of the positions, after tr_step_forces [N]. */
double tr_stability_energy(tr_world *world);

#endif
