/* SPDX-License-Identifier: MIT */
/* The registry: one row per law. To add a law, write one file like friction_coulomb_spring.c and add its row here. */
#include "laws/law.h"

extern const tr_law tr_normal_linear, tr_friction_coulomb_spring, tr_friction_dahlberg_alfredsson,
    tr_rolling_wang_spring, tr_rolling_star_force_proportional, tr_rolling_star_constant_torque,
    tr_rolling_star_displacement_damping, tr_rolling_bagi_kuhn_conjugate;

enum { ALL_CLAIMS = TR_RATE_INDEPENDENT | TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED };
static const tr_law no_friction = {
    .table = {.name = "none", .doc = "no friction"}, .formula = "Q = 0", .claims = ALL_CLAIMS};
static const tr_law no_rolling = {
    .table = {.name = "none", .doc = "no rolling resistance"}, .formula = "no moments", .claims = ALL_CLAIMS};

const tr_law *const tr_laws_normal[] = {&tr_normal_linear};
const tr_law *const tr_laws_friction[] = {&tr_friction_coulomb_spring, &tr_friction_dahlberg_alfredsson, &no_friction};
const tr_law *const tr_laws_rolling[] = {
    &tr_rolling_wang_spring,          &tr_rolling_bagi_kuhn_conjugate,       &tr_rolling_star_force_proportional,
    &tr_rolling_star_constant_torque, &tr_rolling_star_displacement_damping, &no_rolling};

enum { N_NORMAL = 1, N_FRICTION = 3, N_ROLLING = 6 };
_Static_assert(sizeof tr_laws_normal == N_NORMAL * sizeof(tr_law *), "count of the normal laws");
_Static_assert(sizeof tr_laws_friction == N_FRICTION * sizeof(tr_law *), "count of the friction laws");
_Static_assert(sizeof tr_laws_rolling == N_ROLLING * sizeof(tr_law *), "count of the rolling laws");

/* The scene reader sees parameters, not laws. */
static const tr_param_table *const normal_tables[] = {&tr_normal_linear.table};
static const tr_param_table *const friction_tables[] = {&tr_friction_coulomb_spring.table,
                                                        &tr_friction_dahlberg_alfredsson.table, &no_friction.table};
static const tr_param_table *const rolling_tables[] = {&tr_rolling_wang_spring.table,
                                                       &tr_rolling_bagi_kuhn_conjugate.table,
                                                       &tr_rolling_star_force_proportional.table,
                                                       &tr_rolling_star_constant_torque.table,
                                                       &tr_rolling_star_displacement_damping.table,
                                                       &no_rolling.table};

const tr_param_catalog *tr_laws_catalog(void) {
    static const tr_param_catalog catalog = {
        normal_tables,
        friction_tables,
        rolling_tables,
        N_NORMAL,
        N_FRICTION,
        N_ROLLING,
        "wang|bagi-kuhn|alonso-min|alonso-mean",
    };
    return &catalog;
}
