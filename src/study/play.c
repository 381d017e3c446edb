/* SPDX-License-Identifier: MIT */
#include "study/play.h"
#include "base/math.h"

#include "core/step.h"
#include "study/schedule.h"
#include <math.h>
#include <stdlib.h>

bool tr_play_open(tr_play *p, const tr_scene *scene, int curve, tr_status *st) {
    *p = (tr_play){.scene = scene, .curve = curve, .at = -1};
    if (!tr_checks_open(&p->checks, scene, st) || !tr_bodies_init(&p->b, scene, st)) return false;
    p->samples = p->b.steps < TR_PLAY_SAMPLES ? (int)p->b.steps + 1 : TR_PLAY_SAMPLES;
    return true;
}

void tr_play_close(tr_play *p) {
    tr_inset_close(&p->inset);
    tr_checks_free(&p->checks);
    tr_bodies_free(&p->b);
    free(p->records);
    p->records = NULL;
}

double tr_play_time(const tr_play *p) {
    return (double)p->b.world.steps * p->b.world.dt;
}

bool tr_play_observe(tr_play *p, tr_status *st) {
    p->n_records = tr_record_all(&p->b.world, &p->records, &p->capacity, st);
    return !st->code;
}

/* The contact points of the first few contacts; an open contact lifts the pen. */
static void sample_trace(tr_play *p) {
    for (int t = 0; t < TR_PLAY_TRACES; t++) p->point[t][p->n][0] = p->point[t][p->n][1] = NAN;
    for (int i = 0; i < p->n_records; i++) {
        const tr_record *r = &p->records[i];
        int t = 0;
        while (t < TR_PLAY_TRACES && p->traced[t].a != p->traced[t].b &&
               (p->traced[t].a != r->a || p->traced[t].b != r->b))
            t++;
        if (t == TR_PLAY_TRACES) continue;
        p->traced[t] = (tr_contact_id){r->a, r->b};
        p->point[t][p->n][0] = r->x, p->point[t][p->n][1] = r->y;
    }
}

static tr_contact_id shown(const tr_play *p) {
    const tr_contact_ids *picks = &p->scene->output.contact;
    return picks->n ? picks->item[0] : (tr_contact_id){0};
}

static const tr_record *curve_contact(const tr_play *p) {
    tr_contact_id pick = shown(p);
    for (int i = 0; i < p->n_records; i++)
        if (pick.a == pick.b || (p->records[i].a == pick.a && p->records[i].b == pick.b)) return &p->records[i];
    return NULL;
}

static void sample_curve(tr_play *p) {
    const tr_record *r = curve_contact(p);
    double v[3], *first = &p->value[0][p->n], *second = &p->value[1][p->n];
    *first = *second = NAN;
    switch (p->curve) {
    case TR_CURVE_SPEED:
        tr_bodies_velocity(&p->b.world, 0, v);
        *first = tr_hypot(v[0], v[1]);
        break;
    case TR_CURVE_SPIN:
        tr_bodies_velocity(&p->b.world, p->scene->n_disks - 1, v);
        *first = v[2];
        break;
    case TR_CURVE_VELOCITIES:
        if (r) *first = r->v_s, *second = r->v_r;
        break;
    case TR_CURVE_CREEPAGE:
        if (r && r->s1 + r->s2 != 0) *first = fabs(2 * r->v_s / (r->s1 + r->s2));
        if (r && r->mobilisation < 1 - 1e-9) p->creepage = fmax(p->creepage, 1.5 * *first);
        break;
    }
}

static bool sample(tr_play *p, tr_status *st) {
    if (!tr_run_is_due(p->n, p->samples, p->at, p->b.steps)) return true;
    if (!tr_play_observe(p, st)) return false;
    p->time[p->n] = tr_play_time(p);
    sample_trace(p);
    sample_curve(p);
    tr_marks_take(&p->marks, &p->b.world, p->records, p->n_records);
    p->n++;
    return true;
}

static bool check(tr_play *p, tr_status *st) {
    if (!p->scene->n_checks) return true;
    bool contacts = tr_checks_need_contacts(&p->checks, tr_play_time(p), p->b.world.dt);
    if (contacts && !tr_play_observe(p, st)) return false;
    tr_checks_step(&p->checks, &p->b, p->records, contacts ? p->n_records : 0);
    return true;
}

bool tr_play_to(tr_play *p, int64_t step, tr_status *st) {
    while (p->at < step) {
        if (p->at >= 0) tr_bodies_advance(&p->b);
        if (!tr_step_forces(&p->b.world, st)) return false;
        if (p->recorder.paths.contacts.n && !tr_recorder_step(&p->recorder, st)) return false;
        if (p->inset.solver && !tr_inset_step(&p->inset, tr_recorder_now(&p->recorder, 0), st)) return false;
        p->at++;
        if (!sample(p, st) || !check(p, st)) return false;
    }
    return true;
}

double tr_play_tilt(const tr_play *p) {
    double g[2];
    tr_bodies_gravity(&p->b, g);
    return g[0] != 0 || g[1] != 0 ? -tr_atan2(g[0], -g[1]) : 0;
}

/* Of wall 0, downhill; NaN without a wall 0, or if it is level for the whole film. */
static double slope_of(const tr_play *p) {
    double g[2];
    tr_bodies_gravity(&p->b, g);
    if (!p->scene->n_walls || (g[0] == 0 && g[1] == 0)) return NAN;
    const tr_scene_wall *w = &p->scene->walls[0];
    double slope = tr_atan2(g[0] * w->ny - g[1] * w->nx, -(g[0] * w->nx + g[1] * w->ny));
    return fabs(slope) > 1e-9 || p->scene->gravity.turn != 0 ? slope : NAN;
}

static int join_traces(tr_play *p) {
    int n = 0;
    for (int t = 0; t < TR_PLAY_TRACES && p->traced[t].a != p->traced[t].b; t++) {
        for (int k = 0; k < p->n; k++, n++)
            p->trace[2 * n] = p->point[t][k][0], p->trace[2 * n + 1] = p->point[t][k][1];
        p->trace[2 * n] = p->trace[2 * n + 1] = NAN;
        n++;
    }
    return n;
}

tr_show_lane tr_play_lane(tr_play *p) {
    tr_show_lane lane = {.label = *p->scene->label ? p->scene->label : NULL,
                         .world = &p->b.world,
                         .disk = p->scene->disks,
                         .record = p->records,
                         .n_records = p->n_records,
                         .contact = shown(p),
                         .tilt = tr_play_tilt(p),
                         .slope = slope_of(p),
                         .trace = p->trace,
                         .n_trace = join_traces(p),
                         .mark = p->mark,
                         .n_marks = tr_marks_all(&p->marks, p->mark)};
    if (!p->inset.solver) return lane;
    lane.inset = tr_half_plane_state(p->inset.solver), lane.inset_pair = &p->inset.pair;
    lane.inset_a = p->inset.pick.a, lane.inset_b = p->inset.pick.b;
    return lane;
}
