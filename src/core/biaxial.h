/* SPDX-License-Identifier: MIT */
/* The biaxial test: a loose random sample, compacted between four walls or in a periodic cell, then sheared. Source
 * [Wang2015 Figs. 5-6].
 *
 * Walls: 0 bottom, 1 top (horizontal, moved in the shear), 2 left, 3 right (lateral, held at a pressure).
 *
 * SERVO. A wall under pressure is a piston: M dv/dt = p*length - F. It needs no gain and is stable at the step of the
 * disks; a steady velocity costs no pressure error (a velocity-proportional servo at I = 1e-3 would be off by tenths),
 * and its work is exact in the energy ledger. The dashpots of the contacts damp it.
 *
 * A periodic cell (`boundary: periodic`, cell.h) replaces the walls. In the compaction both its sides are such pistons.
 * In the shear its height changes like that of the walls, and its width holds the lateral stress, or the mean of both
 * (`hold: mean`), at lateral_pressure.
 *
 * How light? In the compaction M is the mass of a row of disks. In the shear it is a sixth of that between walls: each
 * contact along the wall then has the mass of one of six contacts of a disk, so the step need not be shorter. In a cell
 * it is the mass of one disk, because all contacts share it, which adds some 0.8/M to the sum of 1/m of each (bound:
 * timestep.h), and copies of a cell side by side then move like the one.
 *
 * The error of the stress is M d2L/dt2. Of a strain e at constant rate and area that is 2 (M/m) I^2 (1-e)^-4 of the
 * stress: 0.05 for I = 0.1, e = 0.2 in a cell of any size. When contacts give way the width needs some 1/sqrt(k_n/M) to
 * follow; a row of disks swings by 0.15 of the stress from one row of history.csv to the next, these by 0.05 (walls)
 * and 0.02 (cell) at most. And the width does not work against the mean stress: a heavy piston drives its own
 * oscillation through the lag of the axial stress. It needs a dashpot, which must know the steady motion. The contacts
 * damp a piston as light as a disk.
 *
 * A run whose held stress is off by more than 0.2 as a mean over 0.01 of strain fails.
 *
 * Besides the dashpots, compaction has a weak drag against the frame, so that it comes to rest. The shear has none.
 *
 * Compaction has its own step, so that a packing does not depend on the shear: runs with one seed start from the same
 * packing, with any laws and step.
 *
 * START. The shear starts from the velocities that compaction leaves, with the driven sides at rest. They reach their
 * full speed smoothly, as 3 s^2 - 2 s^3, within 1e-3 of strain, or the strain in which sound crosses the sample if that
 * is more (1 % at I = 0.02 and 400 disks), but at most a fifth of strain_end. So there is no jerk in the sample. The
 * lateral stress goes from compaction.pressure to shear.lateral_pressure in the same way. Contacts of disks keep the
 * friction of the compaction; all other histories are zero. If compaction.mu is above the mu of the shear, a second
 * compaction with the mu of the shear follows.
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
    double dt, dt_bound;              /* [s] of the shear, and its bound */
    double row_mass;                  /* of disks side by side, as long as a side [kg/m] */
    double mu;                        /* of the compaction now */
    double drag;                      /* of the compaction: force = -drag * mass * velocity [1/s] */
    double rate;                      /* axial strain rate of the shear [1/s] */
    double height0;                   /* [m] at the start of the shear */
    int64_t shear_start, shear_steps; /* steps before the shear, and in it */
    double start_steps;               /* until the driven sides are at full speed */
    double stress_sum[4];             /* of each wall, or of a cell twice each side, over the steps since the last
                           * tr_biaxial_read */
    int64_t stress_steps;
    double held_sum, held_strain; /* since the last check: strain, and sum of held over asked stress times strain */
} tr_biaxial;

/* Columns of history.csv, field and unit "disk|sphere": a new one is a row here and its line in biaxial.c. */
#define TR_BIAXIAL_STRESSES(ROW)                                                                                       \
    ROW(strain, "1")        /* (H0 - H)/H0, compression positive */                                                    \
    ROW(stress_1, "Pa|N/m") /* mean over the steps since the last read: horizontal walls, */                           \
    ROW(stress_2, "Pa|N/m") /* lateral walls; compression positive */                                                  \
    ROW(sin_phi, "1")       /* (s1 - s2)/(s1 + s2); 0 without stress */                                                \
    ROW(void_ratio, "1")    /* (box area - disk area)/disk area */
#define TR_BIAXIAL_BOX(ROW)                                                                                            \
    ROW(time, "s") /* since the start of the shear */                                                                  \
    ROW(height, "m")                                                                                                   \
    ROW(width, "m")

#define TR_BIAXIAL_FIELD(name, unit) double name;
typedef struct tr_biaxial_state {
    TR_BIAXIAL_STRESSES(TR_BIAXIAL_FIELD)
    TR_BIAXIAL_BOX(TR_BIAXIAL_FIELD)
} tr_biaxial_state;

/* Laws in compaction: the normal law of the scene, friction compaction.mu, no rolling resistance. */
tr_scene_contact tr_biaxial_compaction_laws(const tr_scene *scene);

/* The friction with which the packing comes to rest: compaction.mu, or that of the shear if it is less. */
double tr_biaxial_rest_mu(const tr_scene *scene);

/* Makes the sample and chooses both steps. A given dt above the bound is refused (TR_BAD_CASE) unless the scene allows
 * it. The scene must outlive *b. */
bool tr_biaxial_init(tr_biaxial *b, const tr_scene *scene, tr_status *st);
void tr_biaxial_free(tr_biaxial *b);

/* Takes up to `steps` steps of compaction; *unbalanced is the present unbalanced ratio; *done if it and the wall
 * pressures are as wanted. Fails if it is not at rest after very many steps. */
bool tr_biaxial_compact(tr_biaxial *b, int steps, double *unbalanced, bool *done, tr_status *st);

/* Turns to the shear: walls, laws, ledger. Nothing moves yet. */
bool tr_biaxial_begin_shear(tr_biaxial *b, tr_status *st);

/* Forces of the present instant, servo loads and averages. Follow it by tr_step_advance(&b->world). TR_NUMERICAL: the
 * stress is not held, see above. */
bool tr_biaxial_forces(tr_biaxial *b, tr_status *st);

/* present strain, time, height, width and void ratio; the stresses stay as they are. */
void tr_biaxial_shape(const tr_biaxial *b, tr_biaxial_state *state);

/* After tr_biaxial_forces: everything, and a new interval for the averages begins. */
tr_biaxial_state tr_biaxial_read(tr_biaxial *b);

/* An angle of friction exists only if both stresses press; NaN if sin phi is not between -1 and 1. */
double tr_biaxial_tan_phi(double sin_phi);

/* Elastic normal stiffness of a contact of two mean disks that carries the force 2 R pressure [Pa]. */
double tr_biaxial_stiffness(const tr_biaxial *b, double pressure);

#endif
