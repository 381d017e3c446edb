/* SPDX-License-Identifier: MIT */
/* A periodic cell: a rectangle about the origin; copies of it are its neighbours on all sides.
 *
 * Image (i, j) of a disk is at (x + i Lx, y + j Ly) and moves with (vx + i dLx/dt, vy + j dLy/dt): positions AND
 * velocities follow the cell, so a contact across an edge slides and damps like any other. Only the gather shifts: laws
 * see relative positions and velocities. A disk that leaves the cell continues as its image inside; this happens only
 * at refreshes.
 *
 * No place is special. When the rate of a side changes, by the wanted strain or by the servo, all disks get the
 * homogeneous part at once, dv = (d rate/L) x. A disk and its image x + L then differ by d rate, as they must: a
 * packing that is shifted in the cell moves in the same way. This is the motion in a cell of [Andersen1980], m d2x/dt2
 * = F + m (d2L/dt2 / L) x; without that term each edge would be a wall that pushes.
 *
 * Stress: sigma_k = (1/A) sum over contacts of f_k l_k, f the force on b, l from a to the image of b; compression
 * positive, normal to the sides. The kinetic part (1/A) sum m c_k c_k is left out, c = v - (rate/L) x the velocity
 * relative to the homogeneous flow: in a slow packing it is negligible. The shear stress of the rectangle is free, not
 * controlled.
 *
 * Servo: a piston like that of the walls, M d2L/dt2 = (sigma - wanted) times the other side. All disks follow the flow
 * at once, so only M is its inertia.
 *
 * Energy: the cell does the work -A sigma:D, D = rate/L, with the kinetic part. In the leapfrog this is exact: let K =
 * 1/2 m c(n-1/2) c(n+1/2), both c with x and L of the time n, so that c changes by dt F/m there and keeps c L in
 * between. Then what K and the contacts gain over a step is -rate dt times the mean of sum(f l)/L at its two ends, and
 * for each disk 1/2 m c^2 (1 - (L/L before)^2).
 *
 * Limits: sides above 2 (2 r_max + wide skin), so that only one image of a pair is near, the nearest; a refresh finds
 * it again. Thinner cells are refused.
 */
#ifndef TR_CELL_H
#define TR_CELL_H

#include "core/world.h"

/* Smallest side: no disk is near two images of another disk, or an image of itself [m]. Laws are set. */
double tr_cell_least_side(const tr_world *world);

/* TR_NUMERICAL: a side is shorter. */
bool tr_cell_check(const tr_world *world, tr_status *st);

/* Disks that have left the cell continue as their images inside. */
void tr_cell_wrap(tr_world *world);

/* Gives a side its rate, and all disks their part of the change. */
void tr_cell_set_rate(tr_world *world, int axis, double rate);

/* Before the disks move: pistons, then the sides. */
void tr_cell_advance(tr_world *world);

/* From the disks of a tile to the images that are in contact. */
void tr_cell_shift(const tr_periodic_cell *cell, const tr_group *g, tr_tile *tile);

void tr_cell_add_virial(tr_periodic_cell *cell, const tr_tile *tile);

/* The kinetic part of the cell's work over the last step [N]. */
double tr_cell_kinetic_work(const tr_world *world, int axis);

/* On the edges across an axis, compression positive [N/m]; 0 without a cell. */
static inline double tr_cell_force(const tr_periodic_cell *cell, int axis) {
    return cell->side[axis] > 0 ? cell->virial[axis] / cell->side[axis] : 0;
}

static inline double tr_cell_strain_rate(const tr_periodic_cell *cell, int axis) {
    return cell->side[axis] > 0 ? cell->rate[axis] / cell->side[axis] : 0;
}

/* From b to its image in contact i [m]. */
static inline double tr_cell_offset(const tr_periodic_cell *cell, const tr_group *g, int i, int axis) {
    return cell->side[axis] > 0 && !g->walls ? g->pair[3 + axis][i] * cell->side[axis] : 0;
}

/* From p to the nearest image of q, whose numbers go to image (NULL: not wanted) [m]. */
static inline double tr_cell_distance(const tr_periodic_cell *cell, const double *p, const double *q, double *image) {
    double d[2] = {q[0] - p[0], q[1] - p[1]};
    for (int k = 0; k < 2 && cell->side[k] > 0; k++) {
        double n = tr_broad_image(p[k], q[k], cell->side[k]);
        d[k] += n * cell->side[k];
        if (image) image[k] = n;
    }
    return sqrt(d[0] * d[0] + d[1] * d[1]);
}

#endif
