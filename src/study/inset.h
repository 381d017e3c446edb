/* SPDX-License-Identifier: MIT */
/* The inside of one contact of an assembly, for its frames: the half-plane (patch/half_plane.h) driven by that
 * contact's own path since the start, its P, u_slide and u_roll. Q of the run is not used; the half-plane finds its
 * own.
 *
 * It moves by whole elements h = 2a/n of rolling, which the half-plane carries exactly (patch/cut.h). It also moves
 * when the contact has slid 1/20 of mu a^2/(2 R_star) = 2 mu P/(pi E_star), the scale of Cattaneo's sliding, a has
 * changed by 2/n, or it opens or closes. R_star is that of the two disks, mu and E_star those of the laws, depth that
 * of the normal law or by its default 2 sqrt(R1 R2)/e. */
#ifndef TR_INSET_H
#define TR_INSET_H

#include "core/paths.h"
#include "patch/half_plane.h"

typedef struct tr_inset {
    tr_half_plane *solver; /* NULL: there is no inset */
    tr_patch_pair pair;
    tr_contact_id pick;
    tr_path_point at; /* where the solver stands */
} tr_inset;

/* False: no inset, because this is not a contact of disks with laws that have mu and E_star. */
bool tr_inset_open(tr_inset *inset, const tr_world *world, tr_contact_id pick, tr_status *st);
void tr_inset_close(tr_inset *inset);

/* To load: after tr_inset_open. An inset that has failed since is closed. */
void tr_inset_checkpoint(tr_inset *inset, tr_checkpoint *c);

/* Q/(mu P) by the law of the run; 0 while open. */
double tr_inset_law(const tr_inset *inset, tr_path_point now);

/* The contact has reached `now`; the solver is less than a step behind. */
bool tr_inset_step(tr_inset *inset, tr_path_point now, tr_status *st);

#endif
