/* SPDX-License-Identifier: MIT */
/* The biaxial test: a sample thrown loose, compacted between four walls or in a periodic cell, then sheared. Source [Wang2015 Figs. 5-6].
 *
 * Walls: 0 bottom, 1 top (horizontal, moved in the shear), 2 left, 3 right (lateral, held at a pressure).
 *
 * Servo. A wall under pressure is a piston: M dv/dt = p*length - F, with M the mass of a row of disks along it. It
 * needs no gain and is stable at the step of the disks; a steady velocity costs no pressure error (a
 * velocity-proportional servo at I = 1e-3 would be off by tenths), and its work is exact in the energy ledger. The
 * dashpots of the contacts damp it.
 *
 * A periodic cell (`boundary: periodic`, cell.h) takes the place of the walls: both its sides are such pistons in the
 * compaction; in the shear its height changes as that of the walls would, and its width holds the lateral stress, or the
 * mean of both (`hold: mean`), at lateral_pressure. The mean is not what the width does work against: through the lag of
 * the axial stress such a piston feeds its own oscillation. It has a dashpot, 0.15 of critical, against the velocity less
 * its mean over ten periods / 2 pi, so that steady motion costs no stress. Without it the mean of 400 disks swings by 0.4
 * of what is asked, with it by 0.03, as does the lateral stress.
 *
 * Compaction has a weak drag against the frame besides the dashpots, so that it comes to rest; the shear has none.
 *
 * Compaction has a step of its own, so that a packing depends on nothing of the shear: what is compared by seed starts from the
 * same packing, whatever its laws and step.
 *
 * The shear starts from the velocities that compaction leaves and with all contact histories zero.
 */
#ifndef TR_BIAXIAL_H
#define TR_BIAXIAL_H

#include "core/world.h"

typedef struct tr_biaxial {
    tr_world world; /* do not move: see tr_world */
    const tr_scene *scene;
    double mean_mass;                 /* [kg/m] the m of the inertial number */
    double mean_radius;               /* [m] */
    double disk_area;                 /* [m^2] */
    double dt, dt_bound;              /* [s] of the shear, and what it is a share of */
    double drag;                      /* of the compaction: force = -drag * mass * velocity [1/s] */
    double rate;                      /* axial strain rate of the shear [1/s] */
    double height0;                   /* [m] at the start of the shear */
    int64_t shear_start, shear_steps; /* steps before the shear, and in it */
    double stress_sum[4]; /* of each wall, of a cell twice each side, over the steps since the last tr_biaxial_read */
    int64_t stress_steps;
    double slow_rate; /* of the width, in the memory of `hold: mean` [m/s] */
} tr_biaxial;

typedef struct tr_biaxial_state {
    double strain;             /* (H0 - H)/H0, compression positive */
    double time;               /* since the start of the shear [s] */
    double stress_1, stress_2; /* mean over the steps since the last read: horizontal walls, lateral walls [Pa],
                                  compression positive */
    double sin_phi;            /* (s1 - s2)/(s1 + s2); 0 without stress */
    double void_ratio;         /* (box area - disk area)/disk area */
    double height, width;      /* [m] */
} tr_biaxial_state;

/* What contacts do in compaction: the normal law of the scene, friction compaction.mu, no rolling resistance. */
tr_scene_contact tr_biaxial_compaction_laws(const tr_scene *scene);

/* Throws the sample and chooses both steps. A given dt above the bound is refused (TR_BAD_CASE) unless the scene allows it. The
 * scene must outlive *b. */
bool tr_biaxial_init(tr_biaxial *b, const tr_scene *scene, tr_status *st);
void tr_biaxial_free(tr_biaxial *b);

/* Takes up to `steps` steps of compaction; *unbalanced is the unbalanced ratio now, *done when it and the wall
 * pressures are as asked. Fails when it has not come to rest after very many steps. */
bool tr_biaxial_compact(tr_biaxial *b, int steps, double *unbalanced, bool *done, tr_status *st);

/* Turns to the shear: walls, laws, ledger. */
bool tr_biaxial_begin_shear(tr_biaxial *b, tr_status *st);

/* Forces of the present instant, servo loads and averages. Follow it by tr_step_advance(&b->world). */
bool tr_biaxial_forces(tr_biaxial *b, tr_status *st);

/* strain, time, height, width and void ratio of now; the stresses are left as they are. */
void tr_biaxial_shape(const tr_biaxial *b, tr_biaxial_state *state);

/* After tr_biaxial_forces: all of it, and a new interval for the averages begins. */
tr_biaxial_state tr_biaxial_read(tr_biaxial *b);

/* Of an angle of friction there is one only where both stresses press; NaN where sin phi is not between -1 and 1. */
double tr_biaxial_tan_phi(double sin_phi);

/* Elastic normal stiffness of a contact of two mean disks that carries the force 2 R pressure [Pa]. */
double tr_biaxial_stiffness(const tr_biaxial *b, double pressure);

#endif
