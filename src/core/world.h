/* SPDX-License-Identifier: MIT */
/* The state of a scene: disks, walls, contacts, and the pipeline of passes. pipeline.c chooses the passes, step.c walks
 * through them.
 *
 * DATA PICTURE. A disk is four doubles in each of four arrays, so that one disk is one 32-byte load and the integrator
 * is one loop over 4n numbers:
 *
 *     pos   x     y     theta  R         vel   vx    vy    w      0
 *     force fx    fy    torque 0         inv   1/m   1/m   1/I    0
 *
 * Contacts of a group (disk-disk, wall-disk) are structure-of-arrays, sorted by (a, b): ids, pair constants, histories.
 * The broad phase fills `near` (all pairs closer than a wide skin, rare); a refresh prunes it to the list the step
 * walks (a thin skin, more often) and carries the histories over by id. A contact that opens forgets its history, so a
 * pair that leaves the list loses nothing. Rejected: one struct per contact (no vector code), history keyed by hash
 * (pointers, no restart), calling the broad phase every step (three times the cost of the forces at 400 disks).
 *
 * TIME. Leapfrog: at time n*dt positions are x^n and velocities v^(n-1/2). tr_step_forces makes the forces of time n,
 * which is where sinks look; tr_step_advance kicks to v^(n+1/2) and drifts to x^(n+1).
 *
 * PERIODIC CELL. In a cell, disk b of a pair means its nearest image; see cell.h.
 *
 * THREADS share the tiles of a large sample, and no bit depends on their number; see parallel_forces.h.
 *
 * Two worlds may run side by side: there are no globals. A step allocates nothing, except when a refresh finds more
 * contacts than ever before.
 */
#ifndef TR_WORLD_H
#define TR_WORLD_H

#include "base/threads.h"
#include "base/lanes.h"
#include "broad/broad.h"
#include "laws/law.h"
#include "scene/scene.h"
#include "base/math.h"
#include <stdint.h>

enum {
    TR_MAX_PASSES = 9,
    TR_MAX_WALLS = 128,
    TR_MAX_VELOCITY_MEASURES = 8,
    TR_GROUP_HIST = 3 * TR_MAX_HIST + 32, /* laws of three slots, and the sinks, which have 25 in all */
    TR_GROUP_PAIR = 5 + 3 * TR_MAX_PAIR /* R1, R2, g1, the image of b in a periodic cell, and the laws of three slots */
};

#define TR_LARGEST_OVERLAP 0.3 /* of the smaller radius: beyond it contact laws have no meaning */

typedef struct tr_disks {
    int n;
    double *pos, *vel, *force, *inv; /* n*4 each, see above; inv is 0 where the motion is prescribed */
    double *load;                    /* n*4: what acts on a disk besides contacts: weight, torque; NULL: nothing does */
    double *mass;                    /* n [kg/m], by the density, whatever is given of the motion */
    double *inertia;                 /* n [kg m], likewise */
    double *outer;                   /* of each ring its outer radius [m]; NULL: there are none */
    int *coordination;               /* n: touching contacts of each, right after tr_timestep_contacts */
} tr_disks;

/* A rigid plane through (x, y); the disks are on the side of its unit normal. It does not rotate. With ends it is a
 * thin plate, see wall.h. */
typedef struct tr_wall {
    double x, y, nx, ny; /* [m] */
    double vx, vy;       /* [m/s] */
    double mass;         /* [kg/m]; 0: the motion of the wall is prescribed; > 0: a piston along its normal */
    double gain;         /* acceleration along the normal of a wall with prescribed motion [m/s^2] */
    double load;         /* force on a piston along its normal [N/m] */
    double v_max;        /* speed limit of a piston [m/s] */
    double fx, fy;       /* force of the disks on the wall [N/m] */
    double length;       /* [m] stress = force/length; 0: endless */
    bool ends;           /* it ends at `from` and `to` */
    double from, to;     /* along t = n x k from (x, y), infinite where there is no end [m] */
    double belt;         /* speed of its surface along t [m/s] */
} tr_wall;

/* A periodic cell, a rectangle about the origin; index 0 along x, 1 along y. For its pair of edges across an axis it is
 * like tr_wall for a wall. See cell.h. */
typedef struct tr_periodic_cell {
    double side[2];   /* [m]; 0: there is no cell */
    double rate[2];   /* d side/dt [m/s] */
    double mass[2];   /* of the piston [kg/m]; 0: the motion of the side is prescribed */
    double gain[2];   /* d rate/dt of a side with prescribed motion [m/s^2] */
    double load[2];   /* force on the piston inward [N/m] */
    double v_max[2];  /* largest |rate| of a piston [m/s] */
    double virial[2]; /* sum over the contacts of force on b times (b - a), compression positive [N] */
} tr_periodic_cell;

/* The walls of a box, by number. */
enum { TR_BOTTOM_WALL, TR_TOP_WALL, TR_LEFT_WALL, TR_RIGHT_WALL };

/* Middle and sides of the rectangle that the disks are in [m]; see stretch.h. */
typedef struct tr_extent {
    double x[2], side[2];
} tr_extent;

/* A law of a group: its row, its parameters, and the start of its arrays in the group. law->step == NULL: no work. */
typedef struct tr_group_law {
    const tr_law *law;
    double par[TR_LAW_PAR];
    int hist, pair;
} tr_group_law;

typedef struct tr_group tr_group;
typedef struct tr_ledger tr_ledger;
typedef struct tr_paths tr_paths;
typedef struct tr_parallel tr_parallel;

/* A sink reads finished tiles, and may have its own histories, which follow the ids. */
typedef struct tr_sink {
    tr_group *group;
    tr_ledger *ledger; /* NULL for other sinks */
    tr_paths *paths;   /* NULL for other sinks */
    int hist;          /* the first of its arrays in group->hist */
} tr_sink;

/* One loop over a tile, and its data: arrays of its law, or the tr_sink as data.par. */
typedef struct tr_pass {
    const char *name;
    tr_pass_run *run;
    bool sink;
    tr_law_data data;
} tr_pass;

/* The pair constants of every contact. TR_PAIR_G1: R1/(R1+R2), 1 at a wall. In a cell also the image of b along x and
 * y. */
enum {
    TR_PAIR_R1,
    TR_PAIR_R2,
    TR_PAIR_G1,
    TR_PAIR_ALL,
    TR_PAIR_IMAGE_X = TR_PAIR_ALL,
    TR_PAIR_IMAGE_Y,
    TR_PAIR_IN_CELL
};

/* Contacts that share a pipeline. In a group of walls, a is the number of a wall. */
struct tr_group {
    bool walls;
    bool rings; /* body a is a ring around b */
    bool ends; /* of walls that have ends */
    int rolling_velocity; /* index into tr_rolling_velocities */
    tr_shape shape;
    bool spins;    /* friction or rolling: spins are gathered and torques scattered */
    bool shared_arms; /* of friction, too: row 0 of tr_arms_rows */
    bool in_order; /* a sink sums over contacts, or numbers them: one tile after the other, by one thread */
    int n, capacity;
    int *a, *b;
    int n_hist, n_pair;
    double *hist[TR_GROUP_HIST];
    double *pair[TR_GROUP_PAIR]; /* TR_PAIR_R1, ...; then those of the laws */
    tr_group_law laws[TR_N_LAW_KINDS];
    tr_sink ledger_sink, arcs_sink, paths_sink; /* group == NULL: not attached */
    const tr_sink *increments_sink;             /* NULL: not attached */
    tr_pass pass[TR_MAX_PASSES];
    int n_pass;
    /* while a list is renewed, see list.h: the old list, the old place of each contact (-1: none), a spare array */
    int old_n, *old_a, *old_b, *source;
    double *spare;
    double *block; /* that holds hist, pair and spare */
};

/* Energy by mechanism; see ledger.h. */
struct tr_ledger {
    double damped, friction, rolling; /* dissipated [N] (J per metre of length) */
    double made[TR_N_LAW_KINDS];          /* by the normal, the friction and the rolling law [N] */
    double work;                      /* done by the walls or the cell on the disks [N] */
    double start;                     /* energy of the disks and contacts when the ledger began [N] */
    double wall_fx[TR_MAX_WALLS], wall_fy[TR_MAX_WALLS], cell_force[2]; /* of the step before */
};

/* A contact that was pressed too deep for any law: this ends the run. */
typedef struct tr_crush {
    bool found, walls;
    int a, b; /* a: of walls the wall */
    double delta; /* [m] */
} tr_crush;

typedef struct tr_world {
    tr_shape shape;          /* of all bodies */
    double dt;               /* [s]; set by the driver, see timestep.h */
    double sure_dt;          /* stable in all packings of these disks [s]; 0: not known yet. See tr_timestep_sure */
    bool allow_unstable;     /* do not fail when dt is above the bound of the contacts */
    int64_t steps;           /* taken so far; time = steps * dt */
    int64_t contact_updates; /* touching contacts, summed over the steps */
    tr_disks disks;
    tr_wall wall[TR_MAX_WALLS];
    int n_walls;
    int n_rings; /* the first so many disks are rings, with radius -R; set before the laws */
    bool boxed;            /* the walls are those of a box */
    tr_periodic_cell cell; /* set before the laws */
    int rolling_velocity;  /* of two disks; index into tr_rolling_velocities */
    int arms;              /* index into tr_arms_rows */
    const tr_scene_contact **wall_laws;    /* of each wall, see tr_world_set_wall_laws; NULL: none has its own */
    unsigned char wall_kind[TR_MAX_WALLS]; /* wall w is in group[1 + wall_kind[w]] */
    /* disk-disk; wall-disk; then what there is of walls with laws of their own, or with ends; of rings the last. The
     * laws make them anew. */
    tr_group *group;
    int n_groups;
    tr_ledger *ledger;     /* NULL: not kept */
    tr_tile *tile;         /* one, reused; allocated apart because its lanes are aligned */
    tr_threads *threads;   /* threads for the work; NULL: one. See base/threads.h */
    tr_parallel *parallel;     /* data of their shares; NULL: not used yet. See parallel_forces.h */
    /* pair finding */
    const tr_broad_finder *broad;
    void *finder;
    tr_pairs near;
    int *picked, picks;          /* the listed ones of `near`, while they are found; room */
    double wide_skin, thin_skin; /* [m] */
    double r_max;                /* the largest radius [m] */
    double *wide_ref, *thin_ref; /* n*2: centres at the last search, at the last refresh [m] */
    tr_extent wide_extent, thin_extent; /* and the frame of the disks */
    double wall_moved; /* largest motion of a wall, except those of a box, since the last refresh [m] */
    bool spent;        /* tr_step_advance has used the forces, and left 0 */
    bool fresh;        /* laws were just set: nothing has moved since the histories were zero */
    bool stale;        /* the list no longer holds every pair that may touch */
    int alone_to;      /* up to this number of disks one thread works: more would wait longer than they work */
    int64_t searches, refreshes;
    tr_crush crush; /* the cause if tr_step_forces failed, if it was that */
} tr_world;

/* A world of n disks or spheres (numbers 0..n-1), all at rest at 0 with radius and mass 0: the caller sets disks, then
 * walls, then laws (pipeline.h). A world must not be copied or moved once its laws are set: passes point into it.
 * Radii, masses, the prescribed motions and the number of walls may change only before the laws are set again: lists
 * and the bound of the step depend on them. */
bool tr_world_init(tr_world *world, int n, tr_shape shape, tr_status *st);
void tr_world_free(tr_world *world);

/* Centre [m], angle [rad], radius [m], density [kg/m^3]; I = m R^2/2, of a sphere 2 m R^2/5. prescribed: keeps its
 * velocity whatever acts on it. */
typedef struct tr_disk_start {
    double x, y, angle, radius, density;
    bool prescribed;
} tr_disk_start;
void tr_world_set_disk(tr_world *world, int i, const tr_disk_start *start);

/* Wall w gets laws of its own, which must outlive the world; NULL: those of two disks. Before the laws are set. */
bool tr_world_set_wall_laws(tr_world *world, int w, const tr_scene_contact *laws, tr_status *st);

static inline const tr_scene_contact *tr_world_wall_laws(const tr_world *world, int w) {
    return world->wall_laws ? world->wall_laws[w] : NULL;
}

/* A ring, the inside of which other bodies touch, in place of disk i. See n_rings. outer: its outer radius [m]. Of
 * spheres it is a shell. False: memory is short. */
bool tr_world_set_ring(tr_world *world, int i, double radius, double outer, double density, tr_status *st);

/* Another moment of inertia for disk i [kg m], after tr_world_set_disk. */
void tr_world_set_inertia(tr_world *world, int i, double inertia);

/* Adds a sink at the end of a pipeline, with n_hist arrays of its own. */
void tr_group_attach(tr_group *group, tr_sink *sink, const char *name, tr_pass_run *run, int n_hist);

/* Frees the arrays of a group. It then has no pipeline. */
void tr_group_free(tr_group *group);

/* The group of a contact of this body 1; a < 0: wall -1-a. */
static inline const tr_group *tr_world_group(const tr_world *world, int a) {
    if (a < 0) return &world->group[1 + world->wall_kind[-1 - a]];
    return &world->group[a < world->n_rings ? world->n_groups - 1 : 0];
}

/* Gap between two bodies, p and q their x, y, angle, radius [m]; p may be a ring, and then q is inside of it. Infinite
 * where they cannot touch: outside of a ring, and of two rings. */
static inline double tr_world_gap(const double *p, const double *q) {
    double apart = tr_hypot(q[0] - p[0], q[1] - p[1]);
    if (p[3] > 0 && q[3] > 0) return apart - p[3] - q[3];
    return q[3] > 0 && apart < -p[3] ? -p[3] - q[3] - apart : INFINITY;
}

/* The radius that overlaps are measured with: the smaller one, beside a wall (R1 = 0) or in a ring (R1 < 0) that of
 * body 2. */
static inline double tr_world_smaller(double R1, double R2) {
    return R1 > 0 ? fmin(R1, R2) : R2;
}

/* Two bodies of a group (in that of walls: a wall and a disk), infinitely heavy if their motion is prescribed. The
 * caller sets their overlap. */
tr_pair_bodies tr_world_pair(const tr_world *world, const tr_group *group, int a, int b);

/* The data that the law of a slot gets. */
tr_law_data tr_group_data(const tr_group *group, const tr_group_law *slot);

/* The world gets n threads (0: one) for its steps, and keeps them until it is freed or gets others. A new world has one
 * thread. Up to alone_to disks it uses only one; tr_world_init sets this to TR_FEW_DISKS. TR_FILE: the system has no
 * threads or memory left. */
enum { TR_FEW_DISKS = 4000 };
bool tr_world_set_threads(tr_world *world, int n, tr_status *st);
int tr_world_threads(const tr_world *world);

/* Bytes of the world, without those of the pair finder; number of history arrays of both groups. */
size_t tr_world_bytes(const tr_world *world);
int tr_world_histories(const tr_world *world);

#endif
