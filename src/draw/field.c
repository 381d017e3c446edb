/* SPDX-License-Identifier: MIT */
#include "draw/field.h"

#include "draw/frame.h"
#include "draw/stick.h"
#include <math.h>

double tr_frame_field(const tr_world *world, const tr_record *r, tr_color color) {
    double stick[2];
    if (color == TR_COLOR_MOBILISATION) return r->mobilisation;
    if (color == TR_COLOR_MOTION) {
        double slides = fabs(r->v_s), rolls = fabs(r->v_r);
        return slides + rolls > 0 ? (rolls - slides) / (rolls + slides) : 0;
    }
    if (color != TR_COLOR_SLIP) return fabs(color == TR_COLOR_SLIDING ? r->v_s : r->v_r);
    tr_frame_stick(world, r, stick);
    return 1 - 0.5 * (stick[1] - stick[0]);
}

void tr_frame_fill(const tr_world *world, const tr_record *record, int n, tr_color color, double *fill, int *ends) {
    int disks = world->disks.n;
    for (int i = 0; i < disks; i++) fill[i] = 0, ends[i] = 0;
    for (int c = 0; c < n; c++) {
        int end[] = {record[c].a, record[c].b};
        for (int k = end[0] < 0; k < 2; k++) fill[end[k]] += tr_frame_field(world, &record[c], color), ends[end[k]]++;
    }
    for (int i = 0; i < disks; i++)
        fill[i] = color == TR_COLOR_SPIN ? world->disks.pos[tr_body(i) + TR_TURN] : fill[i] / (ends[i] ? ends[i] : 1);
}

double tr_frame_range(const tr_record *record, int n, tr_color color) {
    if (color != TR_COLOR_SLIDING && color != TR_COLOR_ROLLING) return 1;
    double max = 0;
    for (int i = 0; i < n; i++) {
        double speed = tr_frame_field(NULL, &record[i], color);
        if (isfinite(speed)) max = fmax(max, speed);
    }
    if (!(max > 1e-100)) return 1;
    for (double range = tr_frame_round_up(max);;) { /* ends: below the smallest speed nothing is covered */
        double next = tr_frame_round_down(0.9 * range);
        int above = 0;
        for (int i = 0; i < n; i++) above += tr_frame_field(NULL, &record[i], color) > next;
        if (above > 0.05 * n || next < 1e-6 * max) return range;
        range = next;
    }
}

double tr_frame_range_bodies(const tr_world *world, const tr_record *record, int n) {
    double max = 0;
    for (int i = 0; i < world->disks.n; i++) {
        const double *v = world->disks.vel + tr_body(i);
        max = fmax(max, fmax(hypot(v[0], v[1]), fabs(v[2] * world->disks.pos[tr_body(i) + TR_RADIUS])));
    }
    for (int i = 0; i < n; i++) max = fmax(max, fmax(fabs(record[i].v_s), fabs(record[i].v_r)));
    /* Bars are cut at the range: a value a hundredth above it, as from a dashpot, must not halve all bars. */
    return max > 1e-100 && isfinite(max) ? tr_frame_round_up(0.98 * max) : 1;
}
