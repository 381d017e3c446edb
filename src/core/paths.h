/* SPDX-License-Identifier: MIT */
/* A sink that follows chosen contacts wherever they stand in the list: the path that drives their laws,
 *
 *   u_slide += Vs dt,   u_roll += -(s1 + s2)/2 dt    while they touch,    P = f_n
 *
 * with the Vs, s1, s2, dt and f_n that the laws had, so that kind: contact gives the same forces along it. */
#ifndef TR_CORE_PATHS_H
#define TR_CORE_PATHS_H

#include "core/world.h"

typedef struct tr_path_point {
    double u_slide, u_roll; /* [m] since the sink was attached; they stand still while the contact is open */
    double P, Q;            /* normal force and friction [N/m]; 0 while it is open */
} tr_path_point;

struct tr_paths {
    tr_scene_picks picks; /* none of them most-mobilised */
    tr_path_point now[TR_MAX_PICKS];
};

/* Follows paths->picks from here on; *paths must outlive the world's laws. Call it after the laws are set. */
void tr_paths_attach(tr_world *world, tr_paths *paths);

/* After every tr_step_forces: the state of contact k. */
tr_path_point tr_paths_take(tr_paths *paths, int k);

#endif
