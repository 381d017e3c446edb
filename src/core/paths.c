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

static void step(tr_tile *tile, const tr_law_data *data) {
    const tr_sink *sink = data->par;
    const tr_group *g = sink->group;
    tr_paths *paths = sink->paths;
    for (int k = 0; k < paths->picks.n; k++) {
        tr_scene_pick pick = paths->picks.item[k];
        if ((pick.a < 0) != g->walls) continue;
        int i = lane_of(g, tile, g->walls ? -1 - pick.a : pick.a, pick.b);
        if (i < 0 || !(tile->delta[i] > 0)) continue;
        tr_path_point *p = &paths->now[k];
        p->u_slide += tile->v_s[i] * tile->dt;
        p->u_roll -= 0.5 * (tile->s1[i] + tile->s2[i]) * tile->dt;
        p->P = tile->f_n[i];
        p->Q = g->slot[TR_FRICTION].law->step ? tile->f_t[i] : 0; /* else the lane may hold the other group's */
    }
}

void tr_paths_attach(tr_world *world, tr_paths *paths) {
    for (int k = 0; k < 2; k++) {
        tr_group *g = &world->group[k];
        g->paths_sink.paths = paths;
        tr_group_attach(g, &g->paths_sink, "paths", step, 0);
    }
}

tr_path_point tr_paths_take(tr_paths *paths, int k) {
    tr_path_point point = paths->now[k];
    paths->now[k].P = paths->now[k].Q = 0; /* a contact that leaves the list is not seen again */
    return point;
}
