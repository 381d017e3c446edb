/* SPDX-License-Identifier: MIT */
#include "verify/exact_tile.h"

#include "laws/kinematics.h"
#include "laws/rolling_conjugate_spring.h"

#include <stdlib.h>
#include <string.h>

/* Laws that follow the curve of the normal force get a curved one. */
static const tr_law *normal_for(const tr_law *law, tr_shape shape) {
    return shape == TR_SHAPE_SPHERE ? &tr_normal_hertz_sphere : law->merged ? &tr_normal_hertz_line : &tr_normal_linear;
}

static void set_parameters(tr_pairs_tile *p, int slot, bool damped) {
    const tr_param_table *table = &p->law[slot]->table;
    for (int i = 0; i < table->n; i++) {
        const tr_param *q = &table->params[i];
        char *end = NULL;
        double value = q->fallback ? strtod(q->fallback, &end) : 0;
        if (q->type != TR_REAL) continue; /* choices and switches: the first one, off */
        if (!end || *end || end == q->fallback) value = q->dim.kg ? 2e6 : 0.3;
        if (!damped && !strcmp(q->key, "damping_ratio")) value = 0;
        memcpy((char *)p->par[slot] + q->offset, &value, sizeof value);
    }
}

static void set_pair(tr_pairs_tile *p, int i) {
    double angle = 0.7 * i, one = 1 + 0.3 * i, two = i < 2 ? one : 3 - 0.25 * i;
    p->R1[i] = one, p->R2[i] = two, p->g1[i] = one / (one + two), p->nx[i] = cos(angle), p->ny[i] = sin(angle);
    bool sphere = p->shape == TR_SHAPE_SPHERE;
    double m1 = 10 * one * one * (sphere ? one : 1), m2 = 10 * two * two * (sphere ? two : 1), of = sphere ? 0.4 : 0.5;
    tr_pair_bodies bodies = {
        .R1 = one, .R2 = two, .m1 = m1, .m2 = m2, .I1 = of * m1 * one * one, .I2 = of * m2 * two * two};
    for (int s = 0; s < 3; s++) {
        double constants[TR_MAX_PAIR];
        if (!p->law[s]->pair) continue;
        p->law[s]->pair(p->par[s], &bodies, constants);
        for (int k = 0; k < p->law[s]->n_pair; k++) p->pair[s][k][i] = constants[k];
    }
}

void tr_pairs_set(tr_pairs_tile *p, int slot, const tr_law *law) {
    memset(p, 0, sizeof *p);
    p->shape = law->table.demands & TR_ONLY_SPHERES ? TR_SHAPE_SPHERE : TR_SHAPE_DISK;
    p->law[0] = slot == TR_NORMAL_SLOT ? law : normal_for(law, p->shape);
    p->law[1] = slot == TR_FRICTION_SLOT ? law : &tr_friction_none;
    p->law[2] = slot == TR_ROLLING_SLOT ? law : &tr_rolling_none;
    p->rolling_velocity = "wang";
    p->tile.n = TR_PAIRS, p->tile.R1 = p->R1, p->tile.R2 = p->R2, p->tile.g1 = p->g1;
    for (int s = 0; s < 3; s++) {
        set_parameters(p, s, slot == TR_NORMAL_SLOT);
        for (int k = 0; k < TR_MAX_HIST; k++) p->hist_at[s][k] = p->hist[s][k];
        for (int k = 0; k < TR_MAX_PAIR; k++) p->pair_at[s][k] = p->pair[s][k];
    }
    for (int i = 0; i < TR_PAIRS; i++) set_pair(p, i);
}

void tr_pairs_drive(tr_pairs_tile *p, int i, tr_pair_motion m) {
    tr_tile *t = &p->tile;
    double L = p->R1[i] + p->R2[i] - m.delta * fmin(p->R1[i], p->R2[i]), Vt = m.Vt - m.W * L;
    t->dx[i] = L * p->nx[i], t->dy[i] = L * p->ny[i];
    t->dvx[i] = -m.v_n * p->nx[i] + Vt * p->ny[i], t->dvy[i] = -m.v_n * p->ny[i] - Vt * p->nx[i];
    t->w1[i] = m.w1 + m.W, t->w2[i] = m.w2 + m.W;
}

void tr_pairs_run(tr_pairs_tile *p, double dt) {
    tr_tile *t = &p->tile;
    t->dt = dt;
    tr_kinematics_pair(t, NULL);
    for (int s = 0; s < 3; s++) {
        tr_law_data d = {.par = p->par[s],
                         .hist = p->hist_at[s],
                         .pair = p->pair_at[s],
                         .normal = p->law[0],
                         .normal_par = p->par[0],
                         .shape = p->shape};
        for (int k = 0; k < tr_n_rolling_velocities && p->law[s]->needs & TR_NEEDS_V_R; k++)
            if (!strcmp(tr_rolling_velocities[k].name, p->rolling_velocity))
                tr_law_rolling_velocity(p->law[s], k)(t, NULL);
        if (p->law[s]->step) p->law[s]->step(t, &d);
    }
    (p->law[2]->needs & TR_GIVES_F_R ? tr_resultant_rolling_force : tr_resultant_full)(t, NULL);
}
