/* SPDX-License-Identifier: MIT */
/* One row per parameter: the values that a key of a case file may have, the place of the value, and its meaning.
 *
 * The reader, the writer of the resolved case, the help and the documentation all walk these rows, so a parameter is
 * declared once. A struct and its rows are side by side; `offset` is the place of the value in that struct. */
#ifndef TR_PARAM_H
#define TR_PARAM_H

#include <stddef.h>

/* The bodies of a contact: disks are cylinders per metre of length (forces N/m, masses kg/m, stiffnesses N/m per m =
 * Pa), spheres move in the plane (N, kg, N/m). */
typedef enum tr_shape { TR_SHAPE_DISK, TR_SHAPE_SPHERE } tr_shape;

/* Powers of kg, m, s, those of disks. line: of them per metre of length; spheres have as many metres more. Angles are
 * numbers. */
typedef struct tr_dim {
    signed char kg, m, s, line;
} tr_dim;

static inline tr_dim tr_dim_of(tr_dim dim, tr_shape shape) {
    return (tr_dim){dim.kg, (signed char)(shape == TR_SHAPE_SPHERE ? dim.m + dim.line : dim.m), dim.s, 0};
}

#define TR_DIM_NUMBER                                                                                                  \
    { 0, 0, 0, 0 }
#define TR_DIM_LENGTH                                                                                                  \
    { 0, 1, 0, 0 }
#define TR_DIM_TIME                                                                                                    \
    { 0, 0, 1, 0 }
#define TR_DIM_SPEED                                                                                                   \
    { 0, 1, -1, 0 }
#define TR_DIM_SPIN                                                                                                    \
    { 0, 0, -1, 0 }
#define TR_DIM_ACCELERATION                                                                                            \
    { 0, 1, -2, 0 }
#define TR_DIM_DENSITY                                                                                                 \
    { 1, -3, 0, 0 }
#define TR_DIM_MODULUS                                                                                                 \
    { 1, -1, -2, 0 }
#define TR_DIM_FORCE                                                                                                   \
    { 1, 0, -2, 1 }
#define TR_DIM_MOMENT                                                                                                  \
    { 1, 1, -2, 1 }
#define TR_DIM_POWER                                                                                                   \
    { 1, 1, -3, 1 }
#define TR_DIM_STRESS                                                                                                  \
    { 1, -1, -2, 1 }
#define TR_DIM_STIFFNESS                                                                                               \
    { 1, -1, -2, 1 }

/* Units and defaults that differ by shape are written "disk|sphere". The part for a shape, in buffer if it is not the
 * whole text. */
enum { TR_BY_SHAPE = 80 };
const char *tr_param_by_shape(const char *text, tr_shape shape, char buffer[TR_BY_SHAPE]);

typedef enum tr_type {
    TR_REAL,        /* double: a quantity with dimension dim */
    TR_COUNT,       /* int */
    TR_SEED,        /* uint64_t */
    TR_CHOICE,      /* int: index into choices */
    TR_SWITCH,      /* bool: yes | no */
    TR_CONTACT_IDS, /* tr_contact_ids: a list of at most max contacts by name; empty if none is given */
    TR_TEXT,        /* char[max]: one line of UTF-8, its NUL included */
} tr_type;

typedef struct tr_param {
    const char *key;
    tr_type type;
    tr_dim dim;           /* of a TR_REAL */
    const char *unit;     /* how dim is printed: "m/s", "1", "Pa|N/m" (disks|spheres) */
    const char *fallback; /* default as a case file would say it, e.g. "0.5*k_n"; NULL: the key must be given */
    double min, max;      /* allowed range, SI, both ends included; a TR_REAL is always finite */
    const char *choices;  /* TR_CHOICE: "a|b|c". TR_REAL: the key that may replace this one, which is then NaN; NULL:
                           * none */
    size_t offset;        /* of the value in the struct that the row describes */
    const char *doc;      /* one line: meaning, and the source where there is one */
} tr_param;

/* Requirements of a law on a case. */
typedef enum tr_demands {
    TR_ONLY_DISKS = 1,
    TR_ONLY_SPHERES = 2,
    TR_NEEDS_TIME = 4,    /* the law depends on the rate; a prescribed path must give times (not for normal laws) */
    TR_ONLY_DRIVER = 16,  /* only kind: contact has it */
    TR_NEEDS_DENSITY = 8, /* of the bodies on a prescribed path: the law depends on their inertia */
} tr_demands;

/* A named set of parameters: a law. n rows. */
typedef struct tr_param_table {
    const char *name;
    const char *doc;
    const tr_param *params;
    int n;
    unsigned demands;          /* tr_demands */
    const char *demands_if;    /* TR_NEEDS_* hold only with this TR_SWITCH on, or this TR_REAL > 0; NULL: always */
    const char *driver_choice; /* a choice of one of the parameters that only kind: contact has; NULL: none */
} tr_param_table;

/* The demands of a law with these parameters, a struct as its rows describe it. */
unsigned tr_param_demands(const tr_param_table *table, const void *par);

/* A removed choice `old` of `key`, and its replacement. */
typedef struct tr_param_renamed {
    const char *key, *old, *now;
} tr_param_renamed;

/* The registry of laws for the reader of cases, which does not see laws. Name of law i: normal[i]->name. */
typedef struct tr_param_catalog {
    const tr_param_table *const *normal, *const *friction, *const *rolling;
    int n_normal, n_friction, n_rolling;
    const char *rolling_velocities; /* "wang|bagi-kuhn|..." */
    const char *arms;               /* "shared|midpoint" */
    const tr_param_renamed *renamed;
    int n_renamed;
} tr_param_catalog;

#endif
