/* SPDX-License-Identifier: MIT */
/* Does the tangential stiffness of a contact of disks fit its E_star and its depth? Before the run, an estimate.
 *
 * A line contact that does not slip yet has the stiffness pi E_star/(2 Lambda), Lambda = ln(2d/a), normally and
 * tangentially. A friction law that takes k_t (or, on a bed under a linear normal law, k_n) and E_star as separate
 * numbers may contradict it: then its sliding and its creep belong to two different contacts. E_star is that of the
 * friction law, else of the normal law; depth that of the normal law, else that of disks between plates.
 *
 * Lambda follows from the force by its logarithm: a force that is off by a factor of two is 0.35 in Lambda, a tenth of
 * the stiffness. So half of TR_FIT is for the estimate of the force. */
#ifndef TR_FIT_H
#define TR_FIT_H

#include "core/biaxial.h"
#include "core/bodies.h"

#define TR_FIT 0.2 /* |k/fits - 1| above this does not fit */

typedef struct tr_fit {
    const char *key; /* of the stiffness in the case: k_t or k_n */
    double k, fits;  /* the given and the fitting value [Pa]; 0: none fits, the contact is wider than deep (a >= 2 d) */
    double P, a, d;  /* at this force [N/m]: half-width, depth [m] */
    int one, two;    /* kind: bodies: the pair, as a and b in tr_resolution */
    int more;        /* further such pairs */
} tr_fit;

/* The contact of two disks, R1 = 0: of a wall and a disk, pressed with P. E_star and d are for laws without their own;
 * 0: not known. True: the stiffness is known and does not fit, or no value fits. */
bool tr_fit_contact(const tr_scene_contact *laws, double R1, double R2, double E_star, double d, double P, tr_fit *fit);

/* Two mean disks of a sample, at the mean force of the shear. */
bool tr_fit_biaxial(const tr_biaxial *b, tr_fit *fit);

/* The pair that fits worst, among those whose force follows from the scene. */
bool tr_fit_bodies(const tr_bodies *b, tr_fit *fit);

#endif
