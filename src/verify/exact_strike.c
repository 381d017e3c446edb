/* SPDX-License-Identifier: MIT */
#include "verify/exact_strike.h"

#include "core/ledger.h"
#include "core/pipeline.h"
#include "core/step.h"
#include "laws/law.h"
#include <stdio.h>
#include <string.h>

static double kinetic(const tr_world *w, const tr_blow *b) {
    double sum = 0;
    for (int i = 0; i < w->disks.n; i++) {
        const double *v = w->disks.vel + tr_body(i);
        double spin = (b->sphere ? 0.4 : 0.5) * TR_BLOW_RADIUS * TR_BLOW_RADIUS * v[2] * v[2];
        sum += 0.5 * tr_blow_mass(b) * (v[0] * v[0] + v[1] * v[1] + spin);
    }
    return sum;
}

static bool set(tr_world *w, const tr_blow *b, tr_status *st) {
    char text[400];
    snprintf(text, sizeof text,
             "kind: bodies\n%stime_end: 1\ncontact: {%s%s%s}\ndisks: [{radius: 1, density: 1, x: 0, y: 0}]\n",
             b->sphere ? "shape: sphere\n" : "", b->contact, strstr(b->contact, "mu:") ? "" : ", friction: none",
             strstr(b->contact, "rolling:") ? "" : ", rolling: none");
    tr_scene scene; /* reads the laws */
    if (!tr_scene_read(&scene, &(tr_scene_source){"impact", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_world_set_laws(w, &scene.contact, false, TR_SINK_LEDGER, st);
    tr_scene_free(&scene);
    return ok;
}

/* t = n x k = (0, -1). */
bool tr_strike(const tr_blow *b, int n, double phase, tr_rebound *r, tr_status *st) {
    tr_world w;
    int last = b->wall ? 0 : 1, touching = 0;
    if (!tr_world_init(&w, last + 1, b->sphere ? TR_SHAPE_SPHERE : TR_SHAPE_DISK, st)) return false;
    w.dt = b->time / n, w.allow_unstable = true;
    double gap = phase * b->v_n * w.dt, share = b->wall ? 1 : 0.5;
    for (int i = 0; i <= last; i++) {
        double side = i == last ? 1 : -1, *v = w.disks.vel + tr_body(i);
        tr_world_set_disk(&w, i,
                          &(tr_disk_start){b->wall ? TR_BLOW_RADIUS + gap : side * (TR_BLOW_RADIUS + gap / 2), 0, 0,
                                           TR_BLOW_RADIUS, TR_BLOW_DENSITY, false});
        v[0] = -side * share * b->v_n, v[1] = -side * share * b->v_s, v[2] = i == last ? b->spin : 0;
    }
    if (b->wall) w.wall[0] = (tr_wall){.nx = 1}, w.n_walls = 1;
    bool ok = set(&w, b, st);
    double before = kinetic(&w, b);
    *r = (tr_rebound){0};
    for (int k = 0; ok && k < 3 * n; k++) {
        if (!(ok = tr_step_forces(&w, st))) break;
        if (k == 0) tr_ledger_begin(&w);
        double force = w.disks.force[tr_body(last)];
        touching += force != 0, r->peak = fmax(r->peak, force);
        tr_step_advance(&w);
    }
    const double *v = w.disks.vel + tr_body(last), *u = b->wall ? (double[]){0, 0, 0} : w.disks.vel;
    r->e = (v[0] - u[0]) / b->v_n, r->duration = touching * w.dt;
    r->v_t = u[1] - v[1], r->spin = v[2], r->v_s = r->v_t + TR_BLOW_RADIUS * (u[2] + v[2]);
    r->energy = kinetic(&w, b) / before, r->damped = w.ledger ? w.ledger->damped / before : 0;
    tr_world_free(&w);
    return ok;
}

bool tr_strike_farthest(const tr_blow *b, int n, size_t what, double exact, double *value, tr_status *st) {
    double most = -1;
    for (int p = 0; p < 8; p++) {
        tr_rebound r;
        if (!tr_strike(b, n, p / 8.0, &r, st)) return false;
        double now;
        memcpy(&now, (const char *)&r + what, sizeof now);
        if (fabs(now - exact) > most) most = fabs(now - exact), *value = now;
    }
    return true;
}
