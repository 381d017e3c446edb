/* SPDX-License-Identifier: MIT */
#include "core/stretch.h"

#include <math.h>

tr_extent tr_stretch_extent(const tr_world *world) {
    const tr_wall *w = world->wall;
    const double *side = world->cell.side;
    if (side[0] > 0) return (tr_extent){{0, 0}, {side[0], side[1]}};
    if (!world->boxed) return (tr_extent){{0, 0}, {1, 1}};
    double left = w[TR_LEFT_WALL].x, right = w[TR_RIGHT_WALL].x, bottom = w[TR_BOTTOM_WALL].y, top = w[TR_TOP_WALL].y;
    return (tr_extent){{(left + right) / 2, (bottom + top) / 2}, {right - left, top - bottom}};
}

tr_stretch tr_stretch_of(const tr_extent *from, const tr_extent *to) {
    tr_stretch s = {.most = 0};
    for (int k = 0; k < 2; k++) {
        s.scale[k] = to->side[k] / from->side[k];
        s.offset[k] = to->x[k] - s.scale[k] * from->x[k];
        s.most = fmax(s.most, fabs(s.scale[k] - 1));
    }
    return s;
}

double tr_stretch_reach(const tr_world *world, const tr_stretch *stretch, double skin, double left) {
    return (skin - left - stretch->most * (2 * world->r_max + skin)) / 2;
}
