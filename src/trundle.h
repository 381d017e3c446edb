/* SPDX-License-Identifier: MIT */
/* libtrundle: 2D disks with contact laws for friction, rolling resistance and creep.
 *
 *     cc mine.c $(pkg-config --cflags --libs trundle)        -lm too, if it uses math.h
 *
 * Units are SI. Disks are cylinders: forces are per metre of length [N/m], moments [N], masses [kg/m]. Spheres that
 * move in the plane (`shape: sphere`) have N, N m and kg. Rotations are positive counter-clockwise.
 *
 * ERRORS. A function that can fail takes an error as its last argument. It may be NULL. Such a function returns
 * TRUNDLE_OK or the code of the error, or, where it makes something, NULL. The text says what is wrong and where.
 * Nothing is printed, and the program is not ended.
 *
 * OWNERSHIP. What a `new` or `read` function returns is yours: give it to the `free` function of its type. free
 * functions take NULL. Strings that a function returns belong to the library and stay valid.
 *
 * LOCALE. Numbers of cases and laws have a point in any locale.
 *
 * THREADS. Nothing is shared between objects. Use one object from one thread at a time. */
#ifndef TRUNDLE_H
#define TRUNDLE_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
#define TRUNDLE_API __attribute__((visibility("default")))

enum {
    TRUNDLE_OK = 0,
    TRUNDLE_BAD_CASE = 2,  /* a case, a law or an argument is wrong */
    TRUNDLE_FILE = 3,      /* a file cannot be read, or memory is short */
    TRUNDLE_NUMERICAL = 4, /* the solution broke down: not finite, overlap too large */
};

typedef struct trundle_error {
    int code;
    char text[1024];
} trundle_error;

/* "0.3.0" */
TRUNDLE_API const char *trundle_version(void);

/* ---- scenes: cases as `trundle run` takes them ---- */

typedef struct trundle_scene trundle_scene;

/* sets: n_sets texts "key=value" that override the file, as --set does; NULL if n_sets is 0. NULL: TRUNDLE_BAD_CASE or
 * TRUNDLE_FILE. */
TRUNDLE_API trundle_scene *trundle_scene_read_file(const char *path, const char *const *sets, int n_sets,
                                                   trundle_error *error);
/* The same from text (NUL at its end). name: what messages call it. */
TRUNDLE_API trundle_scene *trundle_scene_read(const char *name, const char *text, const char *const *sets, int n_sets,
                                              trundle_error *error);
TRUNDLE_API void trundle_scene_free(trundle_scene *scene);

/* ---- worlds: disks and walls that move ---- */

typedef struct trundle_world trundle_world;

typedef struct trundle_disk {
    double x, y, angle;    /* [m, rad] */
    double vx, vy, spin;   /* of the same instant [m/s, rad/s] */
    double fx, fy, torque; /* of contacts, weight and given torque */
    double radius, mass;   /* [m, kg/m]; radius < 0: a ring, and -radius its inside */
} trundle_disk;

typedef struct trundle_touch { /* a touching contact */
    int a, b;                  /* disks; a = -1-w: wall w */
    double x, y, nx, ny;       /* contact point; normal from a to b */
    double overlap, f_n, f_t;  /* f_t: friction; on b it is -f_t (ny, -nx) */
    double moment_a, moment_b; /* of the rolling law */
    double v_s, v_r, s1, s2;   /* sliding and rolling velocity; velocities of the contact point over the rims */
    double mobilisation;       /* |f_t|/(mu f_n), 0 to 1 */
} trundle_touch;

typedef struct trundle_biaxial {
    double strain, stress_1, stress_2, sin_phi,
        void_ratio; /* stresses: means over the steps since the last call; without a step, those of that call [Pa] */
} trundle_biaxial;

/* kind: bodies or biaxial, of one document, else TRUNDLE_BAD_CASE. For kind: biaxial this call places and compacts the
 * sample, which takes seconds. The scene must outlive the world. The world stands at the start of the motion or of the
 * shear, with the forces of that instant. */
TRUNDLE_API trundle_world *trundle_world_new(const trundle_scene *scene, trundle_error *error);
TRUNDLE_API void trundle_world_free(trundle_world *world);

/* Takes n steps, 0 or more. After a failure only reading and freeing are allowed. */
TRUNDLE_API int trundle_world_step(trundle_world *world, int n, trundle_error *error);

/* n threads share the work of more than 4000 disks (1 to 1024). The bits do not depend on n. */
TRUNDLE_API int trundle_world_set_threads(trundle_world *world, int n, trundle_error *error);

TRUNDLE_API double
trundle_world_time(const trundle_world *world);                  /* since the start of the motion or of the shear [s] */
TRUNDLE_API double trundle_world_dt(const trundle_world *world); /* [s] */
TRUNDLE_API int trundle_world_count(const trundle_world *world); /* of disks */

/* i from 0 to count - 1, else TRUNDLE_BAD_CASE. */
TRUNDLE_API int trundle_world_disk(const trundle_world *world, int i, trundle_disk *disk, trundle_error *error);

/* A new velocity of disk i for the step to come; numbers must be finite. A prescribed or pinned disk keeps vx and vy, a
 * prescribed or driven disk its spin. A disk on an orbit stays on it: vx and vy are ignored. */
TRUNDLE_API int trundle_world_set_velocity(trundle_world *world, int i, double vx, double vy, double spin,
                                           trundle_error *error);

/* From the next step on the world follows `contact` of another scene. Contacts keep the histories of a law of friction
 * and of rolling that stays; all others are zero. The length of a step stays: if it is too long for these laws, a step
 * fails. The contacts can be read after the next step. The shape must be the same, else TRUNDLE_BAD_CASE. After
 * TRUNDLE_FILE the world can only be read and freed. */
TRUNDLE_API int trundle_world_change_laws(trundle_world *world, const trundle_scene *scene, trundle_error *error);

/* The touching contacts, those of two disks first, then of walls, then of rings, each sorted by (a, b). Returns how
 * many there are, and writes the first `room` of them. -1: memory is short. touch may be NULL if room is 0. */
TRUNDLE_API int trundle_world_contacts(trundle_world *world, trundle_touch *touch, int room, trundle_error *error);

/* kind: biaxial, else TRUNDLE_BAD_CASE. */
TRUNDLE_API int trundle_world_biaxial(trundle_world *world, trundle_biaxial *state, trundle_error *error);

/* ---- one contact: the laws for a DEM code of your own ---- */

typedef struct trundle_contact trundle_contact;

/* Two disks, or with R1 = 0 a plane (body 1) and a disk, or with R1 < 0 a ring of the inner radius -R1 and a disk in
 * it. Densities give the masses for dashpots [kg/m^3]; m = density pi R^2. Normal of the plane, towards the disk: nx,
 * ny, of length 1; ignored for two disks. Laws for spheres are refused. */
typedef struct trundle_pair {
    double R1, R2, density1, density2, nx, ny;
} trundle_pair;

typedef struct trundle_body {
    double x, y, vx, vy, spin; /* of the plane: any point of it; spin is ignored */
} trundle_body;

typedef struct trundle_force {
    double fx, fy; /* on body 2; on 1 the opposite */
    double torque1,
        torque2; /* about the centres: friction at its arm, and the moments of the rolling law. A plane has none: 0 */
} trundle_force;

/* laws: what stands in `contact: {...}` of a case: "k_n: 1 MPa, friction: dahlberg-alfredsson, mu: 0.3, k_t: 1 MPa,
 * E_star: 2.5 MPa, rolling: none". Without `rolling` the law is wang-spring, which needs mu_r. The contact starts
 * without history. */
TRUNDLE_API trundle_contact *trundle_contact_new(const char *laws, const trundle_pair *pair, trundle_error *error);
TRUNDLE_API void trundle_contact_free(trundle_contact *contact);

/* One step of dt > 0 that ends in this state: history moves on by dt, and the forces are those of the end. Positions
 * and velocities are those that your code has when it computes forces. A contact that is open gives 0 and forgets its
 * history. TRUNDLE_NUMERICAL: a position or a velocity is not finite, or both centres coincide, and the contact stays
 * as it was; or a force is not finite, and the contact has forgotten its history. The force is 0 then. */
TRUNDLE_API int trundle_contact_step(trundle_contact *contact, double dt, const trundle_body *one,
                                     const trundle_body *two, trundle_force *force, trundle_error *error);

/* What the contact did in the last step; all 0 where it is open. a = 0, b = 1; a = -1: the plane. */
TRUNDLE_API int trundle_contact_read(trundle_contact *contact, trundle_touch *touch, trundle_error *error);

/* Forgets the history. */
TRUNDLE_API void trundle_contact_reset(trundle_contact *contact);

/* ---- definitions of the rolling and of the sliding velocity ---- */

typedef enum trundle_velocity { TRUNDLE_ROLLING, TRUNDLE_SLIDING } trundle_velocity;

/* How many there are; the name of number i, 0 to count - 1, else NULL: "wang", "bagi-kuhn", ... */
TRUNDLE_API int trundle_definition_count(trundle_velocity kind);
TRUNDLE_API const char *trundle_definition_name(trundle_velocity kind, int i);

/* Definition i of two disks that move like this [m/s; an angle by author: rad/s]. R1 = INFINITY: body 1 is a plane
 * through (x, y) of one, that turns with its spin; its normal points at the centre of two. R1 < 0: body 1 is a ring of
 * the inner radius -R1 around body 2. NaN if there is no such definition, or the centres coincide. */
TRUNDLE_API double trundle_definition_value(trundle_velocity kind, int i, double R1, double R2, const trundle_body *one,
                                            const trundle_body *two);

#ifdef __cplusplus
}
#endif
#endif
