/* SPDX-License-Identifier: MIT */
/* A sink that adds up the arcs da = s1 dt, db = -s2 dt which the contact point has run over each rim since the contact
 * formed [m] (Wang's Fig. 1). Students see them in films; no law uses them. */
#ifndef TR_CORE_ARCS_H
#define TR_CORE_ARCS_H

#include "core/world.h"

void tr_arcs_attach(tr_group *group);

/* da, db of a contact; 0 when arcs are not kept. */
double tr_arcs_a(const tr_group *group, int contact);
double tr_arcs_b(const tr_group *group, int contact);

#endif
