/* SPDX-License-Identifier: MIT */
/* The residual strength of small samples: does it depend on numbers that are chosen to save computer time: the inertial
 * number I, the stiffness ratio kappa = k_n/pressure and the step? And what does a digit cost?
 *
 * sin phi = (s1 - s2)/(s1 + s2) of the mean stresses over 8 to 15 % of strain; 120 disks, cases/biaxial.yaml otherwise.
 * Each variant shears the same 12 seeds. Differences are paired by seed; intervals are those of Student, 95 %, over the
 * seeds.
 *
 * One seed of 400 disks scatters by 0.045 (one standard deviation, known from trials by another program), one of 120 by
 * sqrt(400/120) times that, 0.082. Three standard errors of a mean over 12 seeds: 0.071; of a difference: 0.10. A
 * difference that is smaller cannot be seen here: these rows find gross dependences only. That program had 0.28 without
 * rolling resistance. The same with creep (cases/biaxial-creep.yaml), against itself with other steps and another k_t.
 * In brief: 4 seeds, for creep only the larger step, and standard errors sqrt(12/4) times as large.
 */
#include "base/student.h"
#include "core/biaxial.h"
#include "core/step.h"
#include "verify/precision.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SEEDS = 12 };

static const char text[] =
    "kind: biaxial\n"
    "sample: {disks: 120, r_min: 0.76 mm, r_max: 1.52 mm, density: 2700}\n"
    "contact: {k_n: 160 MPa, damping_ratio: 0.3, friction: coulomb-spring, mu: 0.5, rolling: wang-spring, mu_r: 0.5}\n"
    "compaction: {pressure: 160 kPa, mu: 0}\n"
    "shear: {lateral_pressure: 160 kPa, inertial_number: 2e-3, strain_end: 0.15}\n"
    "output: {energy: no}\n";

#define CREEP                                                                                                          \
    "contact.friction=dahlberg-alfredsson", "contact.creep_roll=wang", "contact.E_star=2*3.6*k_n/pi",                  \
        "contact.k_r=0.5*k_n"

enum { SETS = 6 };

typedef struct variant {
    const char *name, *set[SETS];
    double sin_phi[SEEDS], seconds[SEEDS];
} variant;

/* ---- one test */

static bool compact(tr_biaxial *b, tr_status *st) {
    double unbalanced;
    bool done = false;
    while (!done)
        if (!tr_biaxial_compact(b, 200, &unbalanced, &done, st)) return false;
    return true;
}

static bool shear(tr_biaxial *b, double *sin_phi, tr_status *st) {
    int64_t from = b->shear_steps * 8 / 15;
    for (int64_t k = 0; k <= b->shear_steps; k++) {
        if (!tr_biaxial_forces(b, st)) return false;
        if (k == from || k == b->shear_steps) *sin_phi = tr_biaxial_read(b).sin_phi;
        tr_step_advance(&b->world);
    }
    return true;
}

static bool test(variant *v, int seed, tr_status *st) {
    tr_scene scene;
    tr_biaxial b;
    double start = tr_sweep_now();
    int n = 0;
    while (n < SETS && v->set[n]) n++;
    if (!tr_scene_read(&scene, &(tr_scene_source){"case", text, strlen(text), v->set, n}, tr_laws_catalog(), st))
        return false;
    scene.seed = (uint64_t)seed + 1;
    bool ok = tr_biaxial_init(&b, &scene, st);
    if (ok) {
        ok = compact(&b, st) && tr_biaxial_begin_shear(&b, st) && shear(&b, &v->sin_phi[seed], st);
        tr_biaxial_free(&b);
    }
    tr_scene_free(&scene);
    v->seconds[seed] = tr_sweep_now() - start;
    return ok;
}

/* ---- statistics */

static const int some[] = {4, 8, SEEDS};

/* Mean of the first n of x - y (y NULL: of x), and the half-width of its interval. */
static void interval(const double *x, const double *y, int which, double *mean, double *half) {
    int n = some[which];
    double sum = 0, square = 0;
    for (int i = 0; i < n; i++) sum += x[i] - (y ? y[i] : 0);
    *mean = sum / n;
    for (int i = 0; i < n; i++) square += pow(x[i] - (y ? y[i] : 0) - *mean, 2);
    *half = tr_student_95(n - 1) * sqrt(square / (n - 1) / n);
}

/* Which of `some` the run is about. */
static int all(const tr_verify *v) {
    return v->brief ? 0 : 2;
}

static bool add_points(tr_verify *v, variant *of, bool base, tr_status *st) {
    int seeds = some[all(v)];
    double median = tr_sweep_median(of->seconds, seeds);
    for (int i = 0; i <= all(v); i++) {
        double mean, half, n = some[i];
        interval(of->sin_phi, NULL, i, &mean, &half);
        if (!tr_verify_point_add(v,
                                 &(tr_verify_point){.series = of->name,
                                                    .step = n,
                                                    .step_name = "seeds",
                                                    .error = half / mean,
                                                    .seconds = n * median,
                                                    .low = n * of->seconds[seeds / 4],
                                                    .high = n * of->seconds[3 * seeds / 4],
                                                    .usual = base && i == all(v)},
                                 st))
            return false;
    }
    return true;
}

/* What the residual sin phi of a variant, or its difference from the base, is compared with. */
typedef struct expected {
    double reference, standard_errors, digit; /* standard_errors: three of them, of 12 seeds */
    const char *reason;
} expected;

static bool add_row(tr_verify *v, const variant *of, const variant *base, expected e, tr_status *st) {
    int seeds = some[all(v)];
    double mean, half;
    char name[80], said[80];
    interval(of->sin_phi, base ? base->sin_phi : NULL, all(v), &mean, &half);
    snprintf(name, sizeof name, base ? "residual sin phi, %s: difference" : "residual sin phi, %s", of->name);
    snprintf(said, sizeof said, "+- %.3f (95 %%, %d seeds)", half, seeds);
    return tr_verify_add(v,
                         &(tr_verify_row){.quantity = name,
                                          .unit = "1",
                                          .reference = e.reference,
                                          .computed = mean,
                                          .tolerance = e.standard_errors * sqrt((double)SEEDS / seeds) + e.digit,
                                          .reason = e.reason,
                                          .order = NAN,
                                          .outcome = said},
                         st);
}

bool tr_precision_biaxial(tr_verify *v, tr_status *st) {
    variant variants[] = {
        {.name = "I 2e-3 kappa 1000 safety 0.4"},
        {.name = "I 5e-4", .set = {"shear.inertial_number=5e-4"}},
        {.name = "I 8e-3", .set = {"shear.inertial_number=8e-3"}},
        {.name = "kappa 250", .set = {"contact.k_n=40 MPa"}},
        {.name = "kappa 4000", .set = {"contact.k_n=640 MPa"}},
        {.name = "safety 0.1", .set = {"step.safety=0.1"}},
        {.name = "safety 0.8", .set = {"step.safety=0.8"}},
        {.name = "mu_r 0", .set = {"contact.mu_r=0"}},
        {.name = "creep", .set = {CREEP, "contact.k_t=k_n"}},
        {.name = "creep safety 0.8", .set = {CREEP, "contact.k_t=k_n", "step.safety=0.8"}},
        {.name = "creep safety 0.1", .set = {CREEP, "contact.k_t=k_n", "step.safety=0.1"}},
        {.name = "creep k_t 0.5 k_n", .set = {CREEP, "contact.k_t=0.5*k_n"}},
        {.name = "creep k_t 2 k_n", .set = {CREEP, "contact.k_t=2*k_n"}},
    };
    enum { ALL = sizeof variants / sizeof *variants, BASE = 0, MU_R_0 = 7, WITH_CREEP = 8 };
    const int N = v->brief ? WITH_CREEP + 2 : ALL;
    for (int seed = 0; seed < some[all(v)]; seed++)
        for (int i = 0; i < N; i++)
            if (!tr_verify_go_on(v, st) || !test(&variants[i], seed, st)) return false;
    bool ok = add_row(v, &variants[MU_R_0], NULL,
                      (expected){0.28, 0.071, 0.009, "three standard errors, and the last digit of 0.28"}, st);
    for (int i = 0; i < N && ok; i++) {
        if (i == BASE || i == MU_R_0 || i == WITH_CREEP) continue;
        const variant *base = &variants[i < WITH_CREEP ? BASE : WITH_CREEP];
        ok = add_row(v, &variants[i], base, (expected){0, 0.10, 0, "three standard errors of a difference"}, st);
    }
    for (int i = 0; i < N && ok; i++) ok = add_points(v, &variants[i], i == BASE, st);
    return ok;
}
