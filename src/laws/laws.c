/* SPDX-License-Identifier: MIT */
/* The registry. To add a law, copy law_template.c to a file NAME.c that defines tr_NAME, and add NAME here. The first
 * law of a kind is its default. */
#include "laws/law.h"

#include <stdint.h>
#include <string.h>

#define NORMAL_LAWS(X)                                                                                                 \
    X(normal_linear)                                                                                                   \
    X(normal_hertz_line)                                                                                               \
    X(normal_hertz_sphere)

#define FRICTION_LAWS(X)                                                                                               \
    X(friction_coulomb_spring)                                                                                         \
    X(friction_dahlberg_alfredsson)                                                                                    \
    X(friction_cattaneo_mindlin)                                                                                       \
    X(friction_kuhn_creep)                                                                                             \
    X(friction_vu_quoc_zhang)                                                                                          \
    X(friction_exact)                                                                                                  \
    X(friction_none)

#define ROLLING_LAWS(X)                                                                                                \
    X(rolling_wang_spring)                                                                                             \
    X(rolling_conjugate_spring)                                                                                        \
    X(rolling_passive_spring)                                                                                          \
    X(rolling_star_force_proportional)                                                                                 \
    X(rolling_star_constant_torque)                                                                                    \
    X(rolling_star_displacement_damping)                                                                               \
    X(rolling_none)

#define DECLARE(name) extern const tr_law tr_##name;
#define LAW(name) &tr_##name,
#define TABLE(name) &tr_##name.table,

NORMAL_LAWS(DECLARE)
FRICTION_LAWS(DECLARE)
ROLLING_LAWS(DECLARE)

const tr_law *const tr_laws_normal[] = {NORMAL_LAWS(LAW)};
const tr_law *const tr_laws_friction[] = {FRICTION_LAWS(LAW)};
const tr_law *const tr_laws_rolling[] = {ROLLING_LAWS(LAW)};

/* The scene reader sees parameters, not laws. */
static const tr_param_table *const normal_tables[] = {NORMAL_LAWS(TABLE)};
static const tr_param_table *const friction_tables[] = {FRICTION_LAWS(TABLE)};
static const tr_param_table *const rolling_tables[] = {ROLLING_LAWS(TABLE)};

/* Names that older cases may have. */
static const tr_param_renamed renamed[] = {
    {"rolling", "bagi-kuhn-conjugate", "`rolling: conjugate-spring` with `rolling_velocity: bagi-kuhn`"},
};

#define COUNT(array) (int)(sizeof(array) / sizeof *(array))

const tr_param_catalog *tr_laws_catalog(void) {
    static const tr_param_catalog catalog = {
        normal_tables,
        friction_tables,
        rolling_tables,
        COUNT(normal_tables),
        COUNT(friction_tables),
        COUNT(rolling_tables),
        tr_rolling_velocity_choices + 1,
        tr_arms_choices + 1,
        renamed,
        COUNT(renamed),
    };
    return &catalog;
}

static void *value(const tr_law *law, const double *par, const char *key, tr_type type) {
    for (int k = 0; k < law->table.n; k++)
        if (law->table.params[k].type == type && !strcmp(law->table.params[k].key, key))
            return (char *)(uintptr_t)par + law->table.params[k].offset;
    return NULL;
}

double *tr_law_value(const tr_law *law, const double *par, const char *key) {
    return value(law, par, key, TR_REAL);
}

const int *tr_law_count(const tr_law *law, const double *par, const char *key) {
    return value(law, par, key, TR_COUNT);
}

const int *tr_law_choice(const tr_law *law, const double *par, const char *key) {
    return value(law, par, key, TR_CHOICE);
}
