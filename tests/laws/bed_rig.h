/* SPDX-License-Identifier: MIT */
/* One contact under one friction law on the bed of sliders, driven by overlap, sliding and rolling; elastic curves P(s)
 * written here, by which the answers are computed. */
#ifndef TR_TEST_BED_RIG_H
#define TR_TEST_BED_RIG_H

#include "assert_close.h"
#include "laws/bed.h"
#include "scene/scene.h"
#include <stdbool.h>
#include <string.h>

static const double E_STAR = 2e9, K_N = 3e8, MU = 0.4, NU = 0.15, DEPTH = 0.004, DELTA = 1e-5;

typedef struct rig {
    tr_tile tile;
    const tr_law *law, *normal;
    double R1, R2, g1, par[TR_LAW_PAR], normal_par[TR_LAW_PAR];
    double hist[TR_BED_HIST + 1][4], *at[TR_BED_HIST + 1];
    tr_law_data data;
} rig;

enum { CONTACT = 2 }; /* its place in the arrays, behind another tile */

static inline void rig_set(const tr_law *law, double *par, const char *key, double value) {
    for (int i = 0; i < law->table.n; i++) {
        const tr_param *p = &law->table.params[i];
        if (strcmp(p->key, key)) continue;
        if (p->type == TR_CHOICE)
            *(int *)(void *)((char *)par + p->offset) = (int)value;
        else
            memcpy((char *)par + p->offset, &value, sizeof value);
    }
}

static inline const tr_law *rig_find(const tr_law *const *laws, int n, const char *name) {
    for (int i = 0; i < n; i++)
        if (!strcmp(laws[i]->table.name, name)) return laws[i];
    fail_msg("no law is called %s", name);
    return NULL;
}

/* ---- elastic curves: force, its integral and slope */

static inline tr_elastic quadratic(const void *par, double R1, double R2, double s) {
    const double c = 5e13;
    (void)par, (void)R1, (void)R2;
    return (tr_elastic){c * s * s, c * s * s * s / 3, 2 * c * s};
}
static inline double quadratic_slope(const void *par, double s, double P) {
    (void)par;
    return 2 * P / s;
}
static const tr_law quadratic_law = {.table = {.name = "quadratic"}, .elastic = quadratic, .slope = quadratic_slope};

static inline double rig_R_star(const rig *r) {
    return r->R1 > 0 ? 1 / (1 / r->R1 + 1 / r->R2) : r->R2;
}

/* P by the law's printed formula; of the line contact, given as delta(P), by bisection. */
static inline tr_elastic curve(const rig *r, double s) {
    const char *name = r->normal->table.name;
    double R = rig_R_star(r);
    if (!strcmp(name, "linear")) return (tr_elastic){K_N * s, K_N * s * s / 2, K_N};
    if (!strcmp(name, "quadratic")) return quadratic(NULL, 0, 0, s);
    if (!strcmp(name, "hertz-sphere")) {
        double k = 2 * E_STAR * sqrt(R * s);
        return (tr_elastic){2.0 / 3 * k * s, 4.0 / 15 * k * s * s, k};
    }
    if (!(s > 0)) return (tr_elastic){0, 0, 0};
    double low = 0, high = M_PI * E_STAR * s, P = 0, logarithm = 0; /* Lambda > 1/2 */
    for (int i = 0; i < 200; i++) {
        P = 0.5 * (low + high);
        logarithm = log(2 * DEPTH / sqrt(4 * P * R / (M_PI * E_STAR)));
        if (2 * P / (M_PI * E_STAR) * (logarithm + 0.5) < s)
            low = P;
        else
            high = P;
    }
    return (tr_elastic){P, P * P * (logarithm + 0.25) / (M_PI * E_STAR), M_PI * E_STAR / (2 * logarithm)};
}

/* ---- the contact */

static inline double rig_kappa(const rig *r) {
    return r->data.shape == TR_SHAPE_SPHERE ? (2 - NU) / (2 * (1 - NU)) : 1;
}

/* R1 = 0: a wall. normal: a name of the registry, or quadratic. */
static inline void rig_init(rig *r, const char *friction, const char *normal, double R1, double R2) {
    memset(r, 0, sizeof *r);
    r->law = rig_find(tr_laws_friction, tr_laws_catalog()->n_friction, friction);
    r->normal =
        !strcmp(normal, "quadratic") ? &quadratic_law : rig_find(tr_laws_normal, tr_laws_catalog()->n_normal, normal);
    rig_set(r->law, r->par, "mu", MU), rig_set(r->law, r->par, "nu", NU), rig_set(r->law, r->par, "E_star", E_STAR);
    rig_set(r->normal, r->normal_par, "k_n", K_N), rig_set(r->normal, r->normal_par, "E_star", E_STAR);
    rig_set(r->normal, r->normal_par, "depth", DEPTH);
    r->R1 = R1, r->R2 = R2, r->g1 = R1 > 0 ? R1 / (R1 + R2) : 1;
    r->tile.n = 1, r->tile.first = CONTACT, r->tile.dt = 1;
    assert_in_range(r->law->n_hist, 1, TR_BED_HIST + 1);
    for (int k = 0; k < r->law->n_hist; k++) r->at[k] = r->hist[k];
    r->data = (tr_law_data){.par = r->par,
                            .normal = r->normal,
                            .normal_par = r->normal_par,
                            .shape = strcmp(normal, "hertz-sphere") ? TR_SHAPE_DISK : TR_SHAPE_SPHERE};
}

/* One step; roll is that of either rim. Returns Q. Whatever the law: |Q| <= mu P, and to look again changes nothing. */
static inline double rig_roll(rig *r, double delta, double slide, double roll) {
    double before[sizeof r->hist / sizeof(double)];
    tr_tile *t = &r->tile;
    r->data.hist = r->at;
    t->R1 = &r->R1, t->R2 = &r->R2, t->g1 = &r->g1, t->delta[0] = delta;
    t->f_n[0] = t->f_elastic[0] = delta > 0 ? r->normal->elastic(r->normal_par, r->R1, r->R2, delta).force : 0;
    t->v_s[0] = slide, t->s1[0] = t->s2[0] = roll;
    r->law->step(t, &r->data);
    double Q = t->f_t[0], mu = ((tr_bed_par *)(void *)r->par)->mu;
    assert_true(isfinite(Q) && fabs(Q) <= mu * t->f_elastic[0]);
    memcpy(before, r->hist, sizeof before);
    t->v_s[0] = t->s1[0] = t->s2[0] = 0;
    r->law->step(t, &r->data);
    assert_memory_equal(before, r->hist, sizeof before);
    assert_true(t->f_t[0] == Q);
    return Q;
}

static inline double rig_slide(rig *r, double delta, double slide) {
    return rig_roll(r, delta, slide, 0);
}

static inline double rig_energy(const rig *r) {
    tr_lane energy, bound;
    r->law->state(&r->tile, &r->data, energy, bound);
    return energy[0];
}

static inline int rig_points(const rig *r) {
    return (int)r->hist[0][CONTACT];
}
static inline int rig_merged(const rig *r) {
    assert_int_equal(r->law->merged, 2);
    return (int)r->hist[1][CONTACT];
}

#endif
