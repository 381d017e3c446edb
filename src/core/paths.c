/* SPDX-License-Identifier: MIT */
#include "core/paths.h"

/* Lane of (a, b) in a tile, or -1. The list is sorted. */
static int lane_of(const tr_group *g, const tr_tile *tile, int a, int b) {
    int low = tile->first, end = low + tile->n, high = end;
    while (low < high) {
        int mid = (low + high) / 2;
        if (g->a[mid] < a || (g->a[mid] == a && g->b[mid] < b))
            low = mid + 1;
        else
            high = mid;
    }
    return low < end && g->a[low] == a && g->b[low] == b ? low - tile->first : -1;
}

/* Histories of all. LIFE: 0 is open; below 0: not read yet. */
enum { LIFE, SLIDE, ROLL, FORCE, FRICTION, WHOLE, X, Y, N_HIST };

static double P_of(const tr_group *g, const tr_tile *tile, int i) {
    bool elastic = g->laws[TR_FRICTION].law->needs & TR_ELASTIC_P && tile->f_n[i] > 0;
    return elastic ? tile->f_elastic[i] : tile->f_n[i];
}

static void step_all(tr_tile *tile, const tr_sink *sink) {
    double *h[N_HIST];
    bool rubs = sink->group->laws[TR_FRICTION].law->step; /* else the lane may hold the other group's */
    for (int k = 0; k < N_HIST; k++) h[k] = sink->group->hist[sink->hist + k] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double length = tile->R1[i] + tile->R2[i] - tile->delta[i];
        if (!(tile->delta[i] > 0)) {
            for (int k = 0; k < N_HIST; k++) h[k][i] = 0;
            continue;
        }
        if (h[LIFE][i] == 0) h[LIFE][i] = -(double)++sink->paths->lives;
        h[SLIDE][i] += tile->v_s[i] * tile->dt;
        h[ROLL][i] -= 0.5 * (tile->s1[i] + tile->s2[i]) * tile->dt;
        h[FORCE][i] = P_of(sink->group, tile, i), h[WHOLE][i] = tile->f_n[i];
        h[FRICTION][i] = rubs ? tile->f_t[i] : 0;
        h[X][i] = length * tile->nx[i], h[Y][i] = length * tile->ny[i];
    }
}

bool tr_paths_life(tr_group *g, int i, tr_path_life *life) {
    double **h = g->hist + g->paths_sink.hist;
    if (h[LIFE][i] == 0) return false;
    if (h[LIFE][i] < 0) h[LIFE][i] = -h[LIFE][i], g->paths_sink.paths->taken++;
    *life = (tr_path_life){.a = g->walls ? -1 - g->a[i] : g->a[i],
                           .b = g->b[i],
                           .life = h[LIFE][i],
                           .R1 = g->pair[TR_PAIR_R1][i],
                           .R2 = g->pair[TR_PAIR_R2][i],
                           .slide = h[SLIDE][i],
                           .roll = h[ROLL][i],
                           .P = h[FORCE][i],
                           .Q = h[FRICTION][i],
                           .f_n = h[WHOLE][i],
                           .x = h[X][i],
                           .y = h[Y][i]};
    h[SLIDE][i] = h[ROLL][i] = 0;
    return true;
}

static void step(tr_tile *tile, const tr_law_data *data) {
    const tr_sink *sink = data->par;
    const tr_group *g = sink->group;
    tr_paths *paths = sink->paths;
    if (paths->all) step_all(tile, sink);
    for (int k = 0; k < paths->contacts.n; k++) {
        tr_contact_id pick = paths->contacts.item[k];
        if ((pick.a < 0) != g->walls) continue;
        int i = lane_of(g, tile, g->walls ? -1 - pick.a : pick.a, pick.b);
        if (i < 0 || !(tile->delta[i] > 0)) continue;
        tr_path_point *p = &paths->now[k];
        p->u_slide += tile->v_s[i] * tile->dt;
        p->u_roll -= 0.5 * (tile->s1[i] + tile->s2[i]) * tile->dt;
        p->P = P_of(g, tile, i);
        p->Q = g->laws[TR_FRICTION].law->step ? tile->f_t[i] : 0; /* else the lane may hold the other group's */
    }
}

void tr_paths_attach(tr_world *world, tr_paths *paths) {
    for (int k = 0; k < world->n_groups; k++) {
        tr_group *g = &world->group[k];
        g->paths_sink.paths = paths;
        g->in_order = true;
        tr_group_attach(g, &g->paths_sink, "paths", step, paths->all ? N_HIST : 0);
    }
}

tr_path_point tr_paths_take(tr_paths *paths, int k) {
    tr_path_point point = paths->now[k];
    paths->now[k].P = paths->now[k].Q = 0; /* a contact that leaves the list does not come back */
    return point;
}
