/* SPDX-License-Identifier: MIT */
/* A contact law: one file with one loop over a tile of contacts, and one row in laws.c.
 *
 * THE WAY OF A CONTACT. Contacts are in arrays sorted by (a, b), a < b (walls count as a). Each step walks them in
 * tiles of TR_TILE. core/ gathers the relative motion of each pair into a tr_tile; then the passes of this folder run
 * over it:
 *
 *     kinematics -> normal -> friction -> rolling velocity -> rolling -> resultant
 *
 * Every pass is a plain loop over the tile's arrays that a compiler turns into vector code: no branch on options, no
 * call. A scene's pipeline is the list of passes that it needs. core/ then
 * scatters the resultants to the bodies, and sinks (ledger, contact table) may read the finished tile.
 *
 * Body 1 is a, body 2 is b. n points from 1 to 2, t = n x k = (n_y, -n_x), rotations counter-clockwise.
 *
 * Units in brackets are those of disks, cylinders per metre of length. Spheres that move in the plane have one metre
 * more: N for N/m, kg for kg/m, N/m for Pa (Young's moduli stay in Pa).
 */
#ifndef TR_LAW_H
#define TR_LAW_H

#include "base/param.h"
#include "base/math.h"
#include <math.h>
#include <stdbool.h>

enum {
    TR_TILE = 64,     /* contacts in a tile, which then stays in the first-level cache */
    TR_MAX_HIST = 56, /* doubles of history that one law keeps per contact */
    TR_MAX_PAIR = 4,  /* pair constants that one law precomputes */
};

typedef double tr_lane[TR_TILE] __attribute__((aligned(64)));

typedef struct tr_tile {
    double dt;    /* of this step [s] */
    int first;    /* number of the tile's first contact in its group */
    int n;        /* contacts in this tile */
    int touching; /* of them with overlap > 0; counted by kinematics */
    /* gather: x2 - x1 [m], v2 - v1 [m/s], spins of 1 and 2 [rad/s] */
    tr_lane dx, dy, dvx, dvy, w1, w2;
    /* pair constants: radii [m] (R1 = 0 at a wall, which has no arm; R1 < 0 of a ring around body 2);
     * g1 = R1/(R1+R2), 1 at a wall, 0 at a corner of one */
    const double *R1, *R2, *g1;
    /* kinematics */
    tr_lane nx, ny; /* unit normal from 1 to 2 */
    tr_lane delta;  /* overlap [m]; <= 0: not touching; v_s, s1, s2 are valid then, too */
    tr_lane r1, r2; /* arms from the centres to the contact point [m] */
    tr_lane v_n;    /* approach speed, -V21.n [m/s] */
    tr_lane v_s;    /* sliding velocity Vs, of 2 relative to 1 along t [m/s] */
    tr_lane s1,
        s2;      /* objective velocities of the contact point over the rims [m/s] [Wang2015 eqs. 23-24, t reversed] */
    tr_lane v_r; /* rolling velocity by the scene's definition [m/s] */
    /* laws */
    tr_lane f_elastic, f_n; /* elastic part of, and whole normal force, >= 0 [N/m] */
    tr_lane f_t;            /* friction Q: on body 2 it is -Q t [N/m] */
    tr_lane m1, m2;         /* rolling moments on 1 and on 2 [N] */
    tr_lane f_r; /* force at the contact point of a law with TR_GIVES_F_R, like f_t: on body 2 it is -f_r t [N/m]. Its
                    arms are the shared ones, R_i |X21|/(R1+R2) and R2 at a wall, whichever the scene has */
    /* resultant: force on body 2, on 1 the opposite [N/m]; torques on 1 and 2 [N] */
    tr_lane fx, fy, q1, q2;
    /* dV_r/ds1, dV_r/ds2 of the scene's definition: for laws with TR_NEEDS_PARTIALS */
    tr_lane p1, p2;
} tr_tile;

/* |X21| of contact i; of a wall, which has no centre, R2. Any arms of a scene. */
static inline double tr_tile_length(const tr_tile *tile, int i) {
    return tile->g1[i] != 1 ? tile->r1[i] + tile->r2[i] : tile->R2[i];
}

typedef struct tr_law tr_law;

/* The data of the group for a pass, besides the tile. Contact i of the tile is number tile->first + i of these
 * arrays. */
typedef struct tr_law_data {
    const void *par; /* the law's parameter struct */
    double *const *hist, *const *pair;
    /* for friction laws that follow the curve of the normal force [Jaeger2005]: that law, its parameters, the shape */
    const tr_law *normal;
    const void *normal_par;
    tr_shape shape;
} tr_law_data;

typedef void tr_pass_run(tr_tile *tile, const tr_law_data *data);

/* Two bodies that may touch: radii [m] (R1 = 0 at a wall, < 0 of a ring), masses [kg/m] and moments of inertia [kg m].
 * A mass is infinite where the motion of the centre is given, an inertia where the spin is; a wall has both. on_path:
 * the driver of kind: contact gives both spins, whatever the inertias. z: contacts that 1 and 2 may have, 0 counts as
 * 1; for tr_law.pair alone. For tr_law.stiffness of friction and rolling laws also the greatest overlap to expect [m],
 * with the normal force [N/m] and stiffness [Pa] there. p1, p2: for tr_law.stiffness of laws with TR_NEEDS_PARTIALS,
 * dV_r/ds1 and dV_r/ds2. */
typedef struct tr_pair_bodies {
    double R1, R2, m1, m2, I1, I2;
    double delta, f_n, k_n;
    bool on_path;
    int z1, z2;
    double p1, p2;
} tr_pair_bodies;

/* Moment of inertia over m R^2 of a whole body: a disk, a sphere. */
static inline double tr_law_inertia(tr_shape shape) {
    return shape == TR_SHAPE_SPHERE ? 0.4 : 0.5;
}

/* 1/(1/R1 + 1/R2) [m]; of a wall the other's. A ring of inner radius R is a body of radius -R. */
static inline double tr_law_R_star(double R1, double R2) {
    return R1 != 0 ? R1 * R2 / (R1 + R2) : R2;
}
/* The same of two masses, or of two inertias, for a dashpot. If one is infinite: the other. If both are, or there is
 * none (0): forces move nothing, and 0 means no dashpot. */
static inline double tr_law_reduced(double one, double two) {
    if (isinf(one) || isinf(two)) return isinf(one) && isinf(two) ? 0 : fmin(one, two);
    return one + two > 0 ? one * two / (one + two) : 0;
}
static inline double tr_law_m_eff(const tr_pair_bodies *b) {
    return tr_law_reduced(b->m1, b->m2);
}

/* Half-width of the line contact, or radius of the circle, by Hertz [m] [Johnson1985 eqs. 4.45, 4.22]. */
static inline double tr_law_width(tr_shape shape, double P, double R_star, double E_star) {
    return shape == TR_SHAPE_SPHERE ? tr_cbrt(0.75 * P * R_star / E_star) : sqrt(4 / M_PI * P * R_star / E_star);
}
/* The depth d of the approach of a line contact [m]; 0 stands for that of disks pressed between plates, 2 sqrt(R1
 * R2)/e, 2 R2/e at a wall or in a ring. */
static inline double tr_law_depth(double given, double R1, double R2) {
    return given > 0 ? given : 2 / M_E * (R1 > 0 ? sqrt(R1 * R2) : R2);
}

/* The elastic part of a normal law at one overlap. */
typedef struct tr_elastic {
    double force;     /* P(delta) [N/m] */
    double energy;    /* int P ddelta [N] */
    double stiffness; /* dP/ddelta [Pa] */
} tr_elastic;

/* Largest stiffness and damping of a law in its own coordinate (overlap, sliding, rolling distance), for
 * the bound on the step: k [Pa], c [Pa s]. Rolling: V_r = lever1 w1 - lever2 w2 + along Vt; levers [m], along [1]. A
 * law of angles has levers 1, k [N] and c [N s]. */
typedef struct tr_stiffness {
    double k, c, lever1, lever2, along;
} tr_stiffness;

typedef enum tr_needs {
    TR_NEEDS_V_R = 1,       /* the rolling velocity of the scene's definition */
    TR_SOLVED_BY_PATCH = 4, /* step is NULL: the driver of kind: contact solves it */
    TR_ELASTIC_P = 8,       /* a friction law whose P is f_elastic, while f_n > 0; the others take f_n */
    TR_GIVES_F_R = 2, /* a rolling law that also pulls along t: the pipeline ends with tr_resultant_rolling_force */
    TR_NEEDS_Z = 16,  /* its pair constants depend on z1 and z2: they are made again with every list */
    TR_NEEDS_PARTIALS = 32, /* with TR_NEEDS_V_R: the partial derivatives of that definition too */
} tr_needs;

/* What a law claims, at its default options. tests/laws/test_claims.c shows that each claim holds, and that it fails
 * for laws that do not make it. */
typedef enum tr_claims {
    TR_RATE_INDEPENDENT = 1, /* only the path counts, not the speed along it; follows from the table, see
                              * tr_law_claims */
    TR_OBJECTIVE = 2,        /* the same for an observer who moves or turns; nothing in a rigid rotation */
    TR_BALANCED = 4,         /* changes neither momentum nor angular momentum of the two bodies together; m1 = -m2 */
    TR_ENERGY_CLOSED = 8,    /* no closed cycle gains energy from it, at constant or changing normal force */
} tr_claims;

/* The slipping part of a contact at a given Q, for pictures: of 2a the share 1 - sqrt(1 - q), spheres of a 1 - (1 -
 * q)^(1/3), with q = |Q|/(mu P). */
typedef enum tr_slip {
    TR_SLIPS_WHOLE,    /* the law has no width: all of it at q = 1, else nothing */
    TR_SLIPS_AT_ENDS,     /* at both ends, as if loaded from rest [Cattaneo1938] */
    TR_SLIPS_TRAILING, /* where material leaves, as in steady rolling with this Q [Carter1926]; both ends at rest */
} tr_slip;

struct tr_law {
    tr_param_table table; /* name, doc, parameters, demands */
    const char *source;   /* e.g. "[Wang2015 eq. 28]" */
    const char *formula;  /* for `trundle laws NAME`; all lines but the last end in \n */
    const char *differs;  /* differences from the source as printed; NULL: none */
    unsigned claims;      /* tr_claims, but for TR_RATE_INDEPENDENT; read by tr_law_claims */
    /* Doubles of history per contact, all zero when a contact forms; without those that only table.driver_choice needs:
     * kind: contact has room for TR_MAX_HIST. */
    int n_hist;
    int merged;           /* 1 + number of the history that counts lost points; 0: none */
    int n_pair;           /* pair constants per contact */
    unsigned needs;       /* tr_needs */
    tr_slip slip;         /* of friction laws */
    /* Fills the pair constants of one contact; NULL when n_pair is 0. */
    void (*pair)(const void *par, const tr_pair_bodies *bodies, double *constants);
    /* One step over the tile. For bodies that do not touch, all outputs and the history become 0. NULL: law "none". */
    tr_pass_run *step;
    /* For the sinks, after step: energy in the contacts [N], and the bound on |f_t| [N/m] or on the larger of
     * |m1|, |m2| [N] (of a normal law: none). NULL with step. */
    void (*state)(const tr_tile *tile, const tr_law_data *data, double *energy, double *bound);
    /* Friction laws that creep, after step: sgn(Q) F |du_roll|, the part of the sliding of this step that creep takes
     * off [m]. NULL: other laws. */
    void (*creep)(const tr_tile *tile, const tr_law_data *data, double *u);
    tr_stiffness (*stiffness)(const void *par, const tr_pair_bodies *bodies);
    /* Normal laws: the elastic force at an overlap >= 0, and the overlap [m] at an elastic force >= 0, of bodies with
     * these radii (R1 = 0: a wall, R1 < 0: a ring). */
    tr_elastic (*elastic)(const void *par, double R1, double R2, double delta);
    double (*overlap)(const void *par, double R1, double R2, double force);
    /* Normal laws, of any radii: dP/ddelta at an overlap > 0 where the elastic force is P, by plain arithmetic. */
    double (*slope)(const void *par, double delta, double P);
};

/* All claims of a law at its default options: those of its row, and TR_RATE_INDEPENDENT if it does not demand times. */
static inline unsigned tr_law_claims(const tr_law *law) {
    bool by_rate = law->table.demands & TR_NEEDS_TIME && !law->table.demands_if;
    return law->claims | (by_rate ? 0 : TR_RATE_INDEPENDENT);
}

enum { TR_NORMAL, TR_FRICTION, TR_ROLLING, TR_N_LAW_KINDS };

/* The registry. Index = tr_scene_law.law. */
extern const tr_law *const tr_laws_normal[], *const tr_laws_friction[], *const tr_laws_rolling[];
extern const tr_law tr_friction_none, tr_rolling_none; /* their step is NULL */
/* Of others those that something else names. */
extern const tr_law tr_normal_linear, tr_normal_hertz_line, tr_normal_hertz_sphere, tr_friction_cattaneo_mindlin,
    tr_friction_dahlberg_alfredsson, tr_rolling_wang_spring, tr_rolling_conjugate_spring,
    tr_rolling_star_force_proportional, tr_rolling_star_constant_torque, tr_rolling_star_displacement_damping;

/* A real parameter of a law by its key, in its parameter struct at par; NULL: the law has no such parameter. */
double *tr_law_value(const tr_law *law, const double *par, const char *key);
const int *tr_law_count(const tr_law *law, const double *par, const char *key); /* the same for a whole number */
const int *tr_law_choice(const tr_law *law, const double *par, const char *key); /* the same of a choice */

/* What a definition claims. tests/laws/test_definitions.c shows that each claim holds, and that it fails for
 * definitions that do not make it. */
typedef enum tr_definition_claims {
    TR_DEFINES_OBJECTIVE = 1, /* the same for an observer who moves or turns: a function of s1 and s2 */
    TR_DEFINES_ANGLE = 2,     /* in rad/s; the others are in m/s */
} tr_definition_claims;

/* A definition of the rolling or of the sliding velocity: a row of rolling_velocity.c or of sliding_velocity.c. */
typedef struct tr_velocity_measure {
    const char *name;   /* its name for `rolling_velocity` */
    const char *column; /* of the tables of `trundle measures` */
    const char *head;   /* of its column on the card, two lines of six characters; NULL: not on the card, because it
                         * repeats another */
    const char *source, *formula;
    unsigned claims;       /* tr_definition_claims */
    tr_pass_run *step;     /* writes tile->v_r (sliding: tile->v_s) after kinematics */
    tr_pass_run *partials; /* the same and its derivatives by s1 and s2, into tile->p1 and tile->p2 */
} tr_velocity_measure;
/* The first tr_n_..._velocities are recorded for every contact; those of rolling are allowed in scenes. `trundle
 * measures` has all. */
extern const tr_velocity_measure tr_rolling_velocities[], tr_sliding_velocities[];
extern const int tr_n_rolling_velocities, tr_n_sliding_velocities, tr_n_rolling_measures, tr_n_sliding_measures;
extern const char tr_rolling_velocity_choices[]; /* "|wang|bagi-kuhn|..." */
extern const char tr_arms_choices[];             /* "|shared|midpoint": see kinematics.h */

/* The pass that a rolling law needs before its own, for definition number `definition`; or NULL. */
static inline tr_pass_run *tr_law_rolling_velocity(const tr_law *rolling, int definition) {
    const tr_velocity_measure *m = &tr_rolling_velocities[definition];
    return rolling->needs & TR_NEEDS_PARTIALS ? m->partials : rolling->needs & TR_NEEDS_V_R ? m->step : NULL;
}

/* The registry for the scene reader. The catalog lives as long as the program. */
const tr_param_catalog *tr_laws_catalog(void);

#endif
