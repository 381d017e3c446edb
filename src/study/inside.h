/* SPDX-License-Identifier: MIT */
/* The inside of one contact, driven along the path of a case by one of the solvers of patch/. It is the reference for
 * the laws of kind: contact on the same path.
 *
 * Rates are constant over a segment, its normal force and, if prescribed, its friction force are linear; step k of n
 * has the values at its end. Q before the first segment is 0. The half-plane and the brush cut a step into as many as
 * they need (patch/cut.h). */
#ifndef TR_STUDY_INSIDE_H
#define TR_STUDY_INSIDE_H

#include "patch/patch.h"
#include "scene/scene.h"
#include "study/contact.h"

typedef struct tr_inside tr_inside;

/* The scene must stay. NULL: out of memory, or a pair that no solver takes. */
tr_inside *tr_inside_new(const tr_scene *scene, tr_status *st);
void tr_inside_free(tr_inside *inside);

tr_patch_pair tr_inside_pair(const tr_scene *scene);

/* One step; *state is like that of kind: contact: law 0, no moments. Call it tr_contact_steps times. */
bool tr_inside_step(tr_inside *inside, tr_contact_state *state, tr_status *st);

/* Tractions after the last step. Closed forms fill in the same elements, with values in their middle. */
const tr_patch_state *tr_inside_patch(const tr_inside *inside);

#endif
