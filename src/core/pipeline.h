/* SPDX-License-Identifier: MIT */
/* The choice of the passes and sinks that a scene needs. */
#ifndef TR_PIPELINE_H
#define TR_PIPELINE_H

#include "core/world.h"

/* Which sinks a world keeps. */
typedef enum tr_sinks {
    TR_SINK_LEDGER = 1, /* energy by mechanism */
    TR_SINK_ARCS = 2,   /* da, db of each contact since it formed */
} tr_sinks;

/* Chooses the pipeline: disk-disk contacts get the laws of `contact`, wall-disk contacts too, or only the normal law if
 * smooth_walls. Contact histories start at zero. Call it after the radii are set. */
bool tr_world_set_laws(tr_world *world, const tr_scene_contact *contact, bool smooth_walls, unsigned sinks,
                       tr_status *st);

/* The same, but contacts keep the histories of a law of friction and of rolling that stays. */
bool tr_world_change_laws(tr_world *world, const tr_scene_contact *contact, bool smooth_walls, unsigned sinks,
                          tr_status *st);

#endif
