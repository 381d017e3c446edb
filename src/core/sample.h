/* SPDX-License-Identifier: MIT */
/* A loose sample: disks at random places in a square box, without overlap. Same seed, same sample, on every machine.
 */
#ifndef TR_SAMPLE_H
#define TR_SAMPLE_H

#include "core/world.h"

/* Fills a fresh world of sample->disks disks at rest, radii uniform in [r_min, r_max], in the box [0, *side]^2, by
 * random sequential addition. The solid fraction of the box is 0.4. It is less if few disks leave no room for one of
 * them: then all start again in a box 1.25 times as wide. Fails only if memory is short. */
bool tr_sample_throw(tr_world *world, const tr_scene_sample *sample, bool periodic, uint64_t seed, double *side,
                     tr_status *st);

/* Disks at rest at sample->place, in the box [0, side[0]] x [0, side[1]], which is that of the sample. */
bool tr_sample_place(tr_world *world, const tr_scene_sample *sample, double side[2], tr_status *st);

/* Disks at rest at pos (n*4: x y . R, in the box [0, side]^2), numbered along a space-filling curve, so that neighbours
 * in place are neighbours in memory: of 40,000 disks a step takes half the time that it takes with random numbers.
 * Small samples keep the order of pos. Numbers do not change during a run; the effect of a long shear on their order is
 * not measured. */
bool tr_sample_number(tr_world *world, const double *pos, double side, double density, tr_status *st);

#endif
