/* SPDX-License-Identifier: MIT */
/* One contact, driven along a path: the passes of assemblies, fed with a prescribed motion instead of moving bodies.
 *
 * The line of centres stands still and the overlap is 0, so betadot = 0, s1 = R1 w1, s2 = -R2 w2, Vs = s1 - s2. From
 * the rates of a segment, slide' = Vs and roll' = -(s1 + s2)/2 (along t, as the material runs):
 *
 *   w1 = (slide'/2 - roll')/R1,   w2 = (slide'/2 + roll')/R2
 *
 * The normal force is prescribed, linear over a segment; step k of n has that of its end, f_n = f_elastic = P(k/n), as
 * a step of an assembly uses the force of the positions that it has reached. Each law has a tile of its own with one
 * contact in it, for a pass takes one set of parameters. */
#ifndef TR_CONTACT_H
#define TR_CONTACT_H

#include "base/status.h"
#include "scene/scene.h"

/* What the law left behind after a step. */
typedef struct tr_contact_state {
    int law;                        /* number in scene->laws */
    int64_t step;                   /* from 1, over the whole path */
    int segment;                    /* from 0 */
    double u_slide, u_roll;         /* since the start of the path [m] */
    double P;                       /* normal force [N/m] */
    double a;                       /* half-width of the contact, sqrt(4 P R_star/(pi E_star)) [m] */
    double Q;                       /* friction on body 1 along t, on body 2 the opposite [N/m] */
    double q;                       /* |Q| over its bound mu P; 0 where that is 0 */
    double moment_1, moment_2, f_r; /* of the rolling law: on the bodies [N]; its force along t, like Q [N/m] */
} tr_contact_state;

typedef struct tr_contact tr_contact;

/* Fails with TR_BAD_CASE where a law needs what the case does not say: a time, a density. */
bool tr_contact_check(const tr_scene *scene, tr_status *st);

/* At the start of the path, histories zero. The scene must stay. NULL: as tr_contact_check, or out of memory. */
tr_contact *tr_contact_new(const tr_scene *scene, tr_status *st);
void tr_contact_free(tr_contact *contact);

int64_t tr_contact_steps(const tr_scene *scene); /* of the whole path */

/* One step of all laws; state has room for scene->n_laws. Call it tr_contact_steps times. TR_NUMERICAL: a number that
 * is not finite. */
bool tr_contact_step(tr_contact *contact, tr_contact_state *state, tr_status *st);

#endif
