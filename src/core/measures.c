/* SPDX-License-Identifier: MIT */
#include "core/measures.h"
#include "base/math.h"

#include <math.h>

tr_measures tr_measures_of(const tr_world *world, const tr_record *records, int n) {
    tr_measures m = {.n_contacts = n};
    double rolled = 0, moved = 0, forces = 0, net = 0, ends = 0;
    int sliding = 0, opposed = 0, pairs = 0; /* pairs of disks */
    for (int i = 0; i < n; i++) {
        const tr_record *c = &records[i];
        bool disks = c->a >= 0;
        pairs += disks;
        ends += disks ? 2 : 1;
        forces += tr_hypot(c->f_n, c->f_t);
        m.mean_f_n += c->f_n / n;
        m.largest_overlap = fmax(m.largest_overlap, c->delta / (disks ? fmin(c->R1, c->R2) : c->R2));
        if (!disks) continue;
        sliding += c->mobilisation >= 1 - 1e-9; /* f_t is clamped to the bound: equal but for rounding */
        opposed += c->s1 * c->s2 < 0;
        m.mobilisation += c->mobilisation;
        rolled += fabs(c->v_r);
        moved += fabs(c->v_r) + fabs(c->v_s);
    }
    int disks = world->disks.n;
    for (int i = 0; i < disks; i++)
        net += tr_hypot(world->disks.force[tr_body(i)], world->disks.force[tr_body(i) + TR_Y]);
    m.coordination = ends / disks;
    if (pairs) {
        m.sliding_fraction = (double)sliding / pairs;
        m.opposed_fraction = (double)opposed / pairs;
        m.mobilisation /= pairs;
    }
    m.rolling_share = moved > 0 ? rolled / moved : 0;
    m.unbalanced = forces > 0 ? (net / disks) / (forces / n) : 0;
    return m;
}

double tr_measures_disk_area(const tr_disks *disks) {
    double area = 0;
    for (int i = 0; i < disks->n; i++)
        area += M_PI * disks->pos[tr_body(i) + TR_RADIUS] * disks->pos[tr_body(i) + TR_RADIUS];
    return area;
}
