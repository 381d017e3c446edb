/* SPDX-License-Identifier: MIT */
/* One row per parameter: what a key of a case file may be, where its value goes, and what it means.
 *
 * The reader, the writer of the resolved case, the help and the documentation all walk these rows, so a parameter is
 * declared once. A struct and its rows stand side by side; `offset` is where the value lives in that struct. */
#ifndef TR_PARAM_H
#define TR_PARAM_H

#include <stddef.h>

/* Powers of kg, m, s. Angles are numbers. */
typedef struct tr_dim {
    signed char kg, m, s;
} tr_dim;

/* A disk is a cylinder per metre of length: forces N/m, masses kg/m, stiffnesses N/m per m = Pa. */
#define TR_DIM_NUMBER                                                                                                  \
    { 0, 0, 0 }
#define TR_DIM_LENGTH                                                                                                  \
    { 0, 1, 0 }
#define TR_DIM_TIME                                                                                                    \
    { 0, 0, 1 }
#define TR_DIM_SPEED                                                                                                   \
    { 0, 1, -1 }
#define TR_DIM_SPIN                                                                                                    \
    { 0, 0, -1 }
#define TR_DIM_ACCELERATION                                                                                            \
    { 0, 1, -2 }
#define TR_DIM_DENSITY                                                                                                 \
    { 1, -3, 0 }
#define TR_DIM_LINE_FORCE                                                                                              \
    { 1, 0, -2 }
#define TR_DIM_PRESSURE                                                                                                \
    { 1, -1, -2 }
#define TR_DIM_STIFFNESS                                                                                               \
    { 1, -1, -2 }

typedef enum tr_type {
    TR_REAL,   /* double: a quantity with dimension dim */
    TR_COUNT,  /* int */
    TR_SEED,   /* uint64_t */
    TR_CHOICE, /* int: index into choices */
    TR_SWITCH, /* bool: yes | no */
} tr_type;

typedef struct tr_param {
    const char *key;
    tr_type type;
    tr_dim dim;           /* of a TR_REAL */
    const char *unit;     /* how dim is printed: "Pa", "m/s", "1" */
    const char *fallback; /* default as a case file would say it, e.g. "0.5*k_n"; NULL: the key must be given */
    double min, max;      /* allowed range, SI, both ends included; a TR_REAL is always finite */
    const char *choices;  /* TR_CHOICE: "a|b|c" */
    size_t offset;        /* of the value in the struct that the row describes */
    const char *doc;      /* one line: meaning, and the source where there is one */
} tr_param;

/* A named set of parameters: a law. n rows. */
typedef struct tr_param_table {
    const char *name;
    const char *doc;
    const tr_param *params;
    int n;
} tr_param_table;

/* What the registry of laws tells the reader of cases, which does not see laws. Name of law i: normal[i]->name. */
typedef struct tr_param_catalog {
    const tr_param_table *const *normal, *const *friction, *const *rolling;
    int n_normal, n_friction, n_rolling;
    const char *rolling_velocities; /* "wang|bagi-kuhn|..." */
} tr_param_catalog;

#endif
