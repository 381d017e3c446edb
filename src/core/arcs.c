/* SPDX-License-Identifier: MIT */
#include "core/arcs.h"

static void step(tr_tile *tile, const tr_law_data *data) {
    const tr_sink *sink = data->par;
    double *da = sink->group->hist[sink->hist] + tile->first, *db = sink->group->hist[sink->hist + 1] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        da[i] = tile->delta[i] > 0 ? da[i] + tile->s1[i] * tile->dt : 0;
        db[i] = tile->delta[i] > 0 ? db[i] - tile->s2[i] * tile->dt : 0;
    }
}

void tr_arcs_attach(tr_group *group) {
    tr_group_attach(group, &group->arcs_sink, "arcs", step, 2);
}

double tr_arcs_a(const tr_group *group, int contact) {
    return group->arcs_sink.group ? group->hist[group->arcs_sink.hist][contact] : 0;
}

double tr_arcs_b(const tr_group *group, int contact) {
    return group->arcs_sink.group ? group->hist[group->arcs_sink.hist + 1][contact] : 0;
}
