/* SPDX-License-Identifier: MIT */
#include "study/run_contact.h"

#include "laws/law.h"

static void name(tr_driven *d, int i) {
    const tr_scene_contact *c = &d->scene->laws[i];
    const tr_law *friction = tr_laws_friction[c->friction.law], *rolling = tr_laws_rolling[c->rolling.law];
    tr_path_result *r = &d->result[i];
    *r = (tr_path_result){.friction = friction->table.name, .rolling = rolling->table.name};
    if (rolling->needs & TR_NEEDS_V_R) r->rolling_velocity = tr_rolling_velocities[c->rolling_velocity].name;
    bool some = false;
    for (int k = 0; k < d->n; k++) some |= tr_laws_rolling[d->scene->laws[k].rolling.law]->step != NULL;
    d->rolling = some;
    snprintf(r->label, sizeof r->label, "%d: %s%s%s", i, r->friction, some ? ", " : "", some ? r->rolling : "");
}

static bool start(tr_driven *d, tr_status *st) {
    return (d->own = tr_contact_new(d->scene, st));
}

static bool step(tr_driven *d, tr_status *st) {
    return tr_contact_step(d->own, d->state, st);
}

static void release(tr_driven *d) {
    tr_contact_free(d->own);
}

static void say(tr_driven *d) {
    bool sphere = d->scene->shape == TR_SHAPE_SPHERE;
    tr_run_say(d->report, "E_star, R_star", "%.6g Pa, %.6g m", d->scene->pair.E_star, d->scene->pair.R_star);
    for (int i = 0; i < d->n && i < 16; i++) {
        char label[24];
        snprintf(label, sizeof label, "laws.%d", i);
        tr_run_say(d->report, label,
                   sphere ? "%s, %s: at the end Q = %.6g N, moment_1 = %.6g N m"
                          : "%s, %s: at the end Q = %.6g N/m, moment_1 = %.6g N",
                   d->result[i].friction, d->result[i].rolling, d->result[i].Q_end, d->result[i].moment_1_end);
    }
}

const tr_driven_kind tr_driven_contact = {.name = name, .start = start, .step = step, .free = release, .say = say};
