/* SPDX-License-Identifier: MIT */
#include "core/record.h"
#include "core/step.h"
#include "verify/stability.h"
#include <stdlib.h>
#include <string.h>

bool tr_stability_open(tr_stability_run *run, const char *text, const char *const *sets, int n_sets, tr_status *st) {
    *run = (tr_stability_run){0};
    if (!tr_scene_read(&run->scene, &(tr_scene_source){"stability", text, strlen(text), sets, n_sets},
                       tr_laws_catalog(), st))
        return false;
    run->open = tr_bodies_init(&run->b, &run->scene, st);
    if (!run->open) tr_scene_free(&run->scene);
    return run->open;
}

bool tr_stability_step(tr_stability_run *run, tr_status *st) {
    if (!tr_step_forces(&run->b.world, st)) return false;
    tr_bodies_advance(&run->b);
    return true;
}

void tr_stability_close(tr_stability_run *run) {
    if (!run->open) return;
    tr_bodies_free(&run->b);
    tr_scene_free(&run->scene);
    run->open = false;
}

static bool finite_all(const double *x, int n) {
    for (int k = 0; k < n; k++)
        if (!isfinite(x[k])) return false;
    return true;
}

bool tr_stability_readable(tr_world *world) {
    tr_status st = {0};
    tr_record *records = NULL;
    int capacity = 0, n = tr_record_all(world, &records, &capacity, &st), lanes = TR_LANES * world->disks.n;
    bool ok = st.code == TR_OK && finite_all(world->disks.pos, lanes) && finite_all(world->disks.vel, lanes) &&
              finite_all(world->disks.force, lanes);
    for (int i = 0; ok && i < n; i++) {
        const tr_record *r = &records[i];
        ok = finite_all((double[]){r->f_n, r->f_t, r->f_r, r->m1, r->m2, r->v_s, r->v_r, r->mobilisation}, 8) &&
             r->mobilisation <= 1 + 1e-9;
    }
    free(records);
    return ok;
}

static void add_elastic(void *context, tr_group *g, tr_tile *tile) {
    double *sum = context;
    tr_lane energy, bound;
    for (int s = 0; s < TR_N_LAW_KINDS; s++) {
        if (!g->laws[s].law->step) continue;
        tr_law_data data = tr_group_data(g, &g->laws[s]);
        g->laws[s].law->state(tile, &data, energy, bound);
        for (int i = 0; i < tile->n; i++)
            if (tile->delta[i] > 0) *sum += energy[i];
    }
}

double tr_stability_energy(tr_world *world) {
    const tr_disks *d = &world->disks;
    double sum = 0;
    for (int k = 0; k < TR_LANES * d->n; k++) {
        double v = d->vel[k] + 0.5 * world->dt * d->inv[k] * d->force[k];
        if (d->inv[k] > 0) sum += 0.5 * v * v / d->inv[k];
        if (d->inv[k] > 0 && d->load) sum -= d->load[k] * d->pos[k];
    }
    for (int k = 0; k < 2; k++) tr_step_walk(world, &world->group[k], 0, add_elastic, &sum);
    return sum;
}
