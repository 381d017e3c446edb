/* SPDX-License-Identifier: MIT */
/* What a case IS: plain structs in SI units, filled from a YAML file through the rows of tables.c.
 *
 * Everything a run depends on is in tr_scene; nothing else is read later. A disk is a cylinder per metre of length. */
#ifndef TR_SCENE_DATA_H
#define TR_SCENE_DATA_H

#include "base/param.h"
#include "base/status.h"
#include <stddef.h>
#include <stdint.h>

/* In the order of the choices of `kind:`. */
typedef enum tr_kind { TR_KIND_BIAXIAL, TR_KIND_BODIES, TR_KIND_CONTACT, TR_KIND_PATCH } tr_kind;

typedef enum tr_color {
    TR_COLOR_MOBILISATION,
    TR_COLOR_SLIDING,
    TR_COLOR_ROLLING,
    TR_COLOR_SLIP,
    TR_COLOR_SPIN,
    TR_COLOR_MOTION
} tr_color;

enum { TR_MAX_LAWS = 32 };   /* items of `laws:` */
enum { TR_MAX_CHECKS = 32 }; /* and of `checks:` */
enum { TR_LAW_PAR = 16 };  /* room for one law's parameter struct, in doubles */

/* A law of one slot: its row in the catalog, and its parameters as the struct that its own table describes. */
typedef struct tr_scene_law {
    int law;
    double par[TR_LAW_PAR];
} tr_scene_law;

typedef struct tr_scene_contact {
    tr_scene_law normal, friction, rolling;
    int rolling_velocity; /* index into the catalog's rolling_velocities */
    int arms;             /* index into the catalog's arms; kind: contact has no overlap in its kinematics */
} tr_scene_contact;

typedef enum tr_boundary { TR_WALLS, TR_PERIODIC } tr_boundary; /* in the order of the choices of `boundary:` */
typedef enum tr_hold { TR_HOLD_LATERAL, TR_HOLD_MEAN } tr_hold; /* and of `hold:` */

typedef struct tr_scene_sample {
    int disks;
    double r_min, r_max; /* [m] radii uniform between */
    double density;      /* [kg/m^3] */
    /* A packing to begin with */
    char file[256];       /* whose disks these are; "": thrown */
    uint64_t file_hash;   /* of what is in it; 0: not known */
    double width, height; /* of its box [m]; 0: that of the file, or around the disks */
    double *place;        /* disks*4: x y . R in the box from 0 to side; owned by the scene; NULL: not read */
    double side[2];       /* [m] */
} tr_scene_sample;

typedef struct tr_scene_compaction {
    double pressure;        /* [Pa] on all four walls */
    double mu;              /* friction coefficient while compacting [1] */
    double inertial_number; /* largest wall speed, as an inertial number [1] */
    double unbalanced;      /* ends at mean net force / mean contact force below this [1] */
} tr_scene_compaction;

typedef struct tr_scene_shear {
    double lateral_pressure; /* [Pa] on the two lateral walls; of a periodic cell what `hold` says */
    int hold;                /* tr_hold: which stress of a periodic cell that is */
    double inertial_number;  /* I = rate sqrt(mean disk mass per metre / lateral_pressure) [1] */
    double strain_end;       /* axial strain, compression positive [1] */
    int walls;               /* 0 smooth: normal force only; 1 rough: the laws of the disks */
} tr_scene_shear;

typedef struct tr_scene_step {
    double safety;       /* dt = safety * stability bound */
    double dt;           /* [s]; 0: from safety */
    bool allow_unstable; /* run a dt above the bound all the same */
} tr_scene_step;

/* A contact by name: `17-42`, disks a < b; `wall0-3`, a = -1-w of wall w; `most-mobilised`, a = b: the one that uses
 * the largest part of its friction at the end of the run. */
typedef struct tr_contact_id {
    int a, b;
} tr_contact_id;

enum { TR_MAX_CONTACT_IDS = 16, TR_CONTACT_NAME = 32 };

typedef struct tr_contact_ids {
    int n;
    tr_contact_id item[TR_MAX_CONTACT_IDS];
} tr_contact_ids;

typedef struct tr_scene_output {
    int frames;           /* pictures over the run, equally spaced, the last at the end; 0: none */
    int rows;             /* rows of history.csv */
    int contacts;         /* instants at which contacts.csv lists the contacts */
    int color;            /* tr_color: field that colours frames */
    int path_rows;        /* instants of paths.csv, which lists all contacts; 0: none */
    bool energy;          /* keep the energy ledger */
    bool increments;      /* what the contacts did between two rows, as columns of history.csv and contacts.csv */
    bool curves;          /* draw history.csv or contact.csv with gnuplot; not bodies */
    tr_contact_ids paths; /* contacts whose path is written to paths/NAME.csv */
    tr_contact_ids contact; /* bodies: the one contact that the panel and the curve show; none: the first ones */
    int curve;              /* bodies: tr_curve drawn beside the motion */
    double still;         /* bodies: time of still.png [s] */
    int view;             /* bodies: tr_output_view */
} tr_scene_output;

/* Who looks, in the order of the choices of `view:`. */
typedef enum tr_output_view { TR_VIEW_CLASS, TR_VIEW_EXPERT } tr_output_view;

/* What the frames of bodies draw over time, in the order of the choices of `curve:`. */
typedef enum tr_curve {
    TR_CURVE_NONE,       /* only bars */
    TR_CURVE_SPEED,      /* of disk 0 */
    TR_CURVE_VELOCITIES, /* V_s and V_r of output.contact, or the first contact */
    TR_CURVE_CREEPAGE,   /* of the same */
    TR_CURVE_SPIN        /* of the last disk */
} tr_curve;

/* Whose motion is given and whose follows from forces, in the order of the choices of `motion:`. */
typedef enum tr_motion_kind {
    TR_FREE,       /* forces move it */
    TR_PRESCRIBED, /* keeps vx, vy, spin */
    TR_ORBIT,      /* its centre circles about (orbit_x, orbit_y) at the rate `orbit`; keeps its spin */
    TR_PINNED,     /* its centre keeps vx, vy; moments turn it */
    TR_DRIVEN      /* keeps its spin; forces move its centre */
} tr_motion_kind;

/* A thread that is wound on a hub and pulls at an angle with a given force. */
typedef struct tr_scene_pull {
    bool given;
    double force, angle, radius; /* [N/m rad m] radius: of the hub; its moment is force radius, counter-clockwise */
} tr_scene_pull;

typedef struct tr_scene_disk {
    double radius, density, x, y, angle; /* [m kg/m^3 m m rad] */
    double vx, vy, spin;                 /* [m/s m/s rad/s] */
    double torque;                       /* applied, counter-clockwise [N] */
    int motion;                          /* tr_motion_kind */
    double orbit, orbit_x, orbit_y;      /* of TR_ORBIT [rad/s m m] */
    double inertia;                      /* over m radius^2 [1]; 0: of its shape */
    double ring;                         /* thickness of a ring, of which radius is the inside [m]; 0: a disk */
    tr_scene_pull pull;
} tr_scene_disk;

/* A rigid plane through (x, y), or a part of one; (nx, ny) points to the side where the disks are (normalised on
 * reading). */
typedef struct tr_scene_wall {
    double x, y, nx, ny;
    double vx, vy;
    double from, to; /* its ends along t = n x k from (x, y) [m]; none where |.| is TR_ENDLESS, or both are 0 */
    double belt;     /* speed of its surface along t [m/s] */
    bool own;        /* it has laws of its own: */
    tr_scene_contact contact;
} tr_scene_wall;

#define TR_ENDLESS 1e6 /* [m] */

/* Two bodies in contact, of one material. */
typedef struct tr_scene_pair {
    double R1, R2, E, nu;  /* [m m Pa 1] */
    double density;        /* [kg/m^3]; 0: not given, for few laws need it */
    double depth, Lambda;  /* [m 1]; of kind: patch at the root of the case. One of them is NaN: not given */
    double d;              /* of the line contact, however given [m] */
    double E_star, R_star; /* contact modulus [Pa] and 1/(1/R1 + 1/R2) [m]: they follow from the others */
} tr_scene_pair;

/* A stretch of the path of a contact: roll and slide at constant rates, force or overlap linear in time from where it
 * was. */
typedef struct tr_scene_segment {
    double force;       /* normal force at the end [N/m]; the first segment starts at its own. NaN: not given, then */
    double overlap;     /* overlap at the end [m]; NaN: not given */
    double slide, roll; /* over the segment [m]: int Vs dt, -int (s1 + s2)/2 dt */
    double
        tangential; /* kind: patch: Q at the end [N/m], linear from where it was; then slide is NaN. NaN: not given */
    double time;    /* that it takes [s]; 0: not given, for most laws do not care */
    int steps;
} tr_scene_segment;

typedef enum tr_solver { TR_HALF_PLANE, TR_BRUSH, TR_CARTER, TR_CATTANEO } tr_solver; /* order of `solver:` */

/* The inside of one contact. */
typedef struct tr_scene_patch {
    double mu;
    int solver, elements;
    int snapshots, frames; /* instants of patch.csv, pictures */
} tr_scene_patch;

/* What a class is told about a case: text of one line each, empty where it is not given. */
typedef struct tr_scene_lesson {
    char title[64], equation[96], sentence[320], question[320], choices[320], answer[640], happens[640];
    int right; /* of the choices, from 1; 0: none is given */
} tr_scene_lesson;

/* A number that the run measures and compares with a closed form. */
typedef struct tr_scene_check {
    int what; /* of what.h: tr_what of bodies, tr_column along a path */
    /* kind: bodies */
    int disk;               /* of a disk */
    tr_contact_ids contact; /* one, of a contact */
    double at, over;        /* mean over the time `over` that ends `at` [s]; over 0: the instant. Not of events */
    /* kind: contact, patch */
    int law;     /* number in scene->laws */
    int segment; /* of the path, at its end; -1: the last */
    /* all */
    double exact;           /* the closed form; dimension as `what` says */
    double tolerance;       /* largest |measured - exact|, the same dimension */
} tr_scene_check;

typedef struct tr_scene {
    tr_kind kind;
    int language;   /* of the words in pictures, in the order of the choices of `language:` */
    tr_shape shape; /* of all bodies; with spheres forces are in N, masses in kg, stresses and stiffnesses in N/m */
    uint64_t seed;
    tr_scene_contact contact;
    tr_scene_step step;
    tr_scene_output output;
    /* kind: biaxial */
    int boundary; /* tr_boundary */
    tr_scene_sample sample;
    tr_scene_compaction compaction;
    tr_scene_shear shear;
    /* kind: bodies */
    struct tr_scene_gravity {
        double x, y; /* at time 0 [m/s^2] */
        double turn; /* rate at which it turns, counter-clockwise [rad/s] */
    } gravity;
    double time_end;      /* [s] */
    tr_scene_disk *disks; /* owned by the scene */
    tr_scene_wall *walls; /* owned by the scene */
    int n_disks, n_walls;
    /* kind: contact */
    tr_scene_pair pair;
    tr_scene_contact *laws; /* owned by the scene; each runs along the path by itself */
    tr_scene_segment *path; /* owned by the scene */
    char *path_file; /* owned by the scene: a CSV file that holds the path, and path is empty; NULL: path is here */
    int n_laws, n_segments;
    tr_scene_patch patch; /* kind: patch, which has pair and path too */
    /* for the class */
    tr_scene_lesson lesson;
    char label[48];         /* kind: bodies: what tells this document of the file from the others */
    tr_scene_check *checks; /* not kind: biaxial; owned by the scene */
    int n_checks;
    struct tr_scene *more; /* kind: bodies: further documents of the file, shown side by side; owned by the scene. Of
                              them output, lesson, time_end are those of this one; their own more is NULL */
    int n_more;
} tr_scene;

enum { TR_MAX_LANES = 6 }; /* documents of a file */

#endif
