/* SPDX-License-Identifier: MIT */
/* A catalog of laws as the registry would hand it in, made up here so that these tests do not move when the laws do:
 * two normal laws, of which one shares `mu` with friction; friction and rolling with `none`. */
#ifndef TR_FAKE_CATALOG_H
#define TR_FAKE_CATALOG_H

#include "scene/scene.h"
#include <string.h>

typedef struct __attribute__((may_alias)) fake_linear {
    double k_n, damping_ratio;
} fake_linear;
typedef struct __attribute__((may_alias)) fake_sticky {
    double k_n, mu;
    int layers;
    bool wet;
    int model;
} fake_sticky;
typedef struct __attribute__((may_alias)) fake_spring {
    double mu, k_t;
} fake_spring;
typedef struct __attribute__((may_alias)) fake_curve {
    double E_star, depth;
    int step;
} fake_curve;
typedef struct __attribute__((may_alias)) fake_rolling {
    double mu_r, k_r;
} fake_rolling;

#define FAKE_K(type, key, fallback)                                                                                    \
    { #key, TR_REAL, TR_DIM_STIFFNESS, "Pa|N/m", fallback, 0, 1e15, NULL, offsetof(type, key), "stiffness " #key }
#define FAKE_MU(type, key, fallback)                                                                                   \
    { #key, TR_REAL, TR_DIM_NUMBER, "1", fallback, 0, 10, NULL, offsetof(type, key), "coefficient " #key }

static const tr_param fake_linear_rows[] = {FAKE_K(fake_linear, k_n, NULL), FAKE_MU(fake_linear, damping_ratio, "0.3")};
static const tr_param fake_sticky_rows[] = {
    FAKE_K(fake_sticky, k_n, NULL),
    FAKE_MU(fake_sticky, mu, "0.25"),
    {"layers", TR_COUNT, TR_DIM_NUMBER, "", "3", 1, 9, NULL, offsetof(fake_sticky, layers), "layers"},
    {"wet", TR_SWITCH, TR_DIM_NUMBER, "", "no", 0, 0, NULL, offsetof(fake_sticky, wet), "wet"},
    {"model", TR_CHOICE, TR_DIM_NUMBER, "", "jkr", 0, 0, "dmt|jkr", offsetof(fake_sticky, model), "model"},
};
static const tr_param fake_spring_rows[] = {FAKE_MU(fake_spring, mu, "0.5"), FAKE_K(fake_spring, k_t, "0.5*k_n")};
static const tr_param fake_rolling_rows[] = {FAKE_MU(fake_rolling, mu_r, "0.5"), FAKE_K(fake_rolling, k_r, "k_t")};

static const tr_param fake_curve_rows[] = {
    {"E_star", TR_REAL, TR_DIM_MODULUS, "Pa", NULL, 0, 1e15, NULL, offsetof(fake_curve, E_star), "modulus"},
    {"depth", TR_REAL, TR_DIM_LENGTH, "m", "0", 0, 1e6, NULL, offsetof(fake_curve, depth), "depth"},
    {"step", TR_CHOICE, TR_DIM_NUMBER, "", "fast", 0, 0, "fast|exact", offsetof(fake_curve, step), "step"},
};

static const tr_param_table fake_tables[] = {
    {.name = "linear", .params = fake_linear_rows, .n = 2},
    {.name = "sticky", .params = fake_sticky_rows, .n = 5},
    {.name = "coulomb-spring", .params = fake_spring_rows, .n = 2},
    {.name = "none"},
    {.name = "wang-spring", .params = fake_rolling_rows, .n = 2, .demands = TR_NEEDS_TIME | TR_NEEDS_DENSITY},
    {.name = "hertz-line", .params = fake_curve_rows, .n = 3, .demands = TR_ONLY_DISKS, .driver_choice = "exact"},
    {.name = "hertz-sphere", .params = fake_curve_rows, .n = 1, .demands = TR_ONLY_SPHERES},
};
static const tr_param_table *const fake_normal[] = {&fake_tables[0], &fake_tables[1], &fake_tables[5], &fake_tables[6]};
static const tr_param_table *const fake_friction[] = {&fake_tables[2], &fake_tables[3]};
static const tr_param_table *const fake_rolling_laws[] = {&fake_tables[3], &fake_tables[4]};
static const tr_param_renamed fake_renamed[] = {{"rolling", "old-spring", "`rolling: wang-spring`"}};
static const tr_param_catalog fake_catalog = {fake_normal,
                                              fake_friction,
                                              fake_rolling_laws,
                                              4,
                                              2,
                                              2,
                                              "wang|bagi-kuhn|alonso-min|alonso-mean",
                                              "shared|midpoint",
                                              fake_renamed,
                                              1};

static const char biaxial_case[] = "# the biaxial test\n"
                                   "kind: biaxial\n"
                                   "seed: 7\n"
                                   "sample: {disks: 400, r_min: 0.76 mm, r_max: 2*r_min, density: 2.7 g/cm^3}\n"
                                   "contact:\n"
                                   "  normal: linear\n"
                                   "  k_n: 160 MPa\n"
                                   "  damping_ratio: 0.3\n"
                                   "  friction: coulomb-spring\n"
                                   "  mu: 0.5\n"
                                   "  k_t: 0.5*k_n\n"
                                   "  rolling: wang-spring\n"
                                   "  rolling_velocity: bagi-kuhn\n"
                                   "  mu_r: \"0.5\"\n"
                                   "  k_r: k_t\n"
                                   "compaction:\n"
                                   "  pressure: 160 kPa\n"
                                   "shear:\n"
                                   "  inertial_number: 1e-3\n"
                                   "output: {frames: 20, color: mobilisation, energy: no}\n";

static const char bodies_case[] =
    "kind: bodies\n"
    "time_end: 100 ms\n"
    "gravity: {y: -9.81 m/s^2}\n"
    "contact: {k_n: 1 MPa, rolling: none}\n"
    "disks:\n"
    "  - radius: 1 cm\n"
    "    x: 0\n"
    "    y: radius\n"
    "    vx: 1 m/s\n"
    "    spin: -1/3\n"
    "  - {radius: disks.0.radius/3, x: 0.1, y: 1/3 cm, angle: 30 deg, motion: prescribed}\n"
    "walls:\n"
    "  - {nx: 0.3, ny: 0.7, vx: 1 mm/s}\n"
    "  - {nx: -1, ny: 1e-3}\n";

/* Goes on behind bodies_case. */
static const char checks_part[] = "checks:\n"
                                  "  - what: slip-ends\n"
                                  "    contact: wall0-1\n"
                                  "    exact: disks.0.vx/(3*contact.mu*9.81 m/s^2)\n"
                                  "    tolerance: 0.01*exact\n"
                                  "  - {what: creepage, contact: 1-0, over: at/4, exact: 1/3, tolerance: 1e-6}\n"
                                  "  - {what: spin, disk: 1, at: 0.3*time_end, exact: -disks.0.spin, tolerance: 0.1}\n";

/* Goes on behind them. */
static const char documents_part[] =
    "label: first\n"
    "---\n"
    "label: \"second: \\\"b\\\"\"\n"
    "contact: {k_n: 3 MPa, mu: 0.25}\n"
    "---\n"
    "kind: bodies\n"
    "contact: {normal: sticky, layers: 2*3, friction: none, rolling: wang-spring, k_r: k_n/7}\n"
    "gravity: {turn: 1 deg/s}\n"
    "disks:\n"
    "  - {radius: 1/3, x: 0, y: radius, vx: 2 m/s}\n"
    "  - {radius: 1, x: 1, y: radius, motion: driven, spin: 1 rad/s}\n"
    "walls: [{nx: 1, ny: 0.1}]\n"
    "checks:\n";

static const char contact_case[] = "kind: contact\n"
                                   "bodies: {R1: 10 mm, R2: R1/3, E: 70 GPa, nu: 0.3, density: 1 g/cm^3}\n"
                                   "laws:\n"
                                   "  - {friction: coulomb-spring, mu: 0.3, k_t: 0.35*E_star}\n"
                                   "  - {rolling: wang-spring, mu_r: 0.1, k_r: E_star/7, rolling_velocity: bagi-kuhn}\n"
                                   "path:\n"
                                   "  - {force: 10 kN/m, slide: 0.18 um, roll: 3*a, steps: 40, time: 1 s}\n"
                                   "  - {force: 2.25*P, slide: -previous.slide, roll: -2*a, time: 2 s}\n"
                                   "  - {force: 0, roll: a, time: 1 ms}\n";

static inline bool fake_read(tr_scene *scene, const char *text, const char *const *sets, int n_sets, tr_status *st) {
    *st = (tr_status){0};
    return tr_scene_read(scene, &(tr_scene_source){"a.yaml", text, strlen(text), sets, n_sets}, &fake_catalog, st);
}

#endif
