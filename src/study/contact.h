/* SPDX-License-Identifier: MIT */
/* One contact, driven along a path: the passes of assemblies, fed with a prescribed motion instead of moving bodies.
 *
 * The line of centres does not move; its length is R1 + R2 (overlaps are small against the radii), so betadot = 0, s1 =
 * R1 w1, s2 = -R2 w2, Vs = s1 - s2. From the rates of a segment, slide' = Vs and roll' = -(s1 + s2)/2 (along t, as the
 * material runs):
 *
 *   w1 = (slide'/2 - roll')/R1,   w2 = (slide'/2 + roll')/R2
 *
 * The normal force or the overlap is prescribed, linear over a segment, and the elastic curve of the item's normal law
 * gives the other. The path begins at those of its first segment, at rest with Q = 0. Step k of n has those of its end,
 * f_n = f_elastic = P(k/n), as a step of an assembly uses the force of the reached positions. A law takes a step as a
 * whole, as in an assembly. A row of a path file is not a step: a law that creeps takes it in steps of an element or
 * less. The half-plane of `friction: exact` cuts both by itself (patch/cut.h). Each item of laws has its own tile with
 * one contact, because a pass takes one set of parameters. */
#ifndef TR_CONTACT_H
#define TR_CONTACT_H

#include "base/status.h"
#include "scene/scene.h"

/* The state of a law after a step. */
typedef struct tr_contact_state {
    int law;                        /* number in scene->laws */
    int64_t step;                   /* from 1, over the whole path */
    int segment;                    /* from 0 */
    double u_slide, u_roll;         /* since the start of the path [m] */
    double P;                       /* normal force [N/m] */
    double overlap;                 /* [m] */
    double a;                       /* half-width of the contact by Hertz, from P and the item's E_star [m] */
    double Q;                       /* friction on body 1 along t, on body 2 the opposite [N/m] */
    double q;                       /* Q/(mu P), -1 to 1, of the sign of Q; 0 where mu P is 0 */
    double moment_1, moment_2, f_r; /* of the rolling law: on the bodies [N]; its force along t, like Q [N/m] */
    int64_t merged;                 /* by a friction law whose history is full, see tr_law */
    /* kind: patch alone (study/inside.h) */
    double p_max;      /* largest pressure [Pa] */
    double stick;      /* width that sticks [m] */
    double creepage;   /* of this step, what it slides over |what it rolls|; NaN: it does not roll */
    double dissipated; /* by friction, since the start of the path [N] (J per metre) */
} tr_contact_state;

/* Of a column of contact.csv (scene/what.h). */
double tr_contact_value(const tr_contact_state *state, int column);

typedef struct tr_contact tr_contact;

/* At the start of the path, histories zero. The scene must stay. NULL: out of memory. */
tr_contact *tr_contact_new(const tr_scene *scene, tr_status *st);
void tr_contact_free(tr_contact *contact);

int64_t tr_contact_steps(const tr_scene *scene); /* of the whole path */

/* One step of all laws; state has room for scene->n_laws. Call it tr_contact_steps times. TR_NUMERICAL: a number that
 * is not finite. */
bool tr_contact_step(tr_contact *contact, tr_contact_state *state, tr_status *st);

#endif
