/* SPDX-License-Identifier: MIT */
/* Where the contact point is on a rim: seen from the centre of a it is in the direction of n, from that of b of -n, and
 * a disk has turned by its angle. Along rim a it moves by -da/R1, along b by -db/R2: see draw/arc.h. On a wall it is
 * the place along (n_y, -n_x). */
#include "study/marks.h"

#include "draw/show_lamp.h"

#include "base/math.h"
#include <math.h>
#include <string.h>

static double place_of(const tr_world *world, const tr_record *r, int end) {
    int body = end ? r->b : r->a;
    if (body >= 0)
        return tr_atan2(end ? -r->ny : r->ny, end ? -r->nx : r->nx) - world->disks.pos[tr_body(body) + TR_TURN];
    const tr_wall *w = &world->wall[-1 - body];
    return (r->x - w->x) * w->ny - (r->y - w->y) * w->nx;
}

/* How far the point has moved along the surface since the last instant. */
static double way_of(const tr_contact_marks *c, const tr_world *world, const tr_record *r, int end) {
    if (end) return -(r->db - c->last.db) / r->R2;
    return r->a >= 0 ? -(r->da - c->last.da) / r->R1 : place_of(world, r, 0) - c->at[0];
}

static void rub(tr_contact_marks *c, const tr_record *r, const double to[2]) {
    if (!c->rubs && c->n_rubs == TR_MARKS_RUBS) { /* the oldest goes */
        memmove(c->rub[0], c->rub[1], sizeof c->rub - sizeof *c->rub);
        c->n_rubs--;
    }
    for (int end = 0; end < 2; end++) {
        if (!c->rubs) c->rub[c->n_rubs][end] = (tr_rim_mark){end ? r->b : r->a, c->at[end], c->at[end], 0, 0};
        tr_rim_mark *m = &c->rub[c->n_rubs - c->rubs][end];
        m->from = fmin(m->from, to[end]), m->to = fmax(m->to, to[end]);
    }
    c->n_rubs += !c->rubs;
    c->rubs = true;
}

/* Ticks where the way rolled so far is a multiple of the distance. */
static void roll(tr_contact_marks *c, const tr_record *r, const double to[2]) {
    double smaller = r->R1 > 0 ? fmin(r->R1, r->R2) : r->R2, apart = 2 * M_PI * smaller / (TR_MARKS_TICKS + 1);
    double way = fabs(r->db - c->last.db), end = c->rolled + way;
    double first = fmax(floor(c->rolled / apart), floor(end / apart) - TR_MARKS_TICKS) + 1; /* the last ones will do */
    for (double k = first; k * apart <= end && way > 0; k++) {
        double part = (k * apart - c->rolled) / way;
        if (c->n_ticks == TR_MARKS_TICKS) {
            memmove(c->tick[0], c->tick[1], sizeof c->tick - sizeof *c->tick);
            c->n_ticks--;
        }
        for (int b = 0; b < 2; b++) {
            double at = c->at[b] + part * (to[b] - c->at[b]);
            c->tick[c->n_ticks][b] = (tr_rim_mark){b ? r->b : r->a, at, at, (int)k, apart};
        }
        c->n_ticks++;
    }
    c->rolled = end;
}

static void follow(tr_contact_marks *c, const tr_world *world, const tr_record *r, double range) {
    double to[2];
    for (int end = 0; end < 2; end++) to[end] = c->at[end] + way_of(c, world, r, end);
    tr_lamp before = tr_lamp_of(world, &c->last, range), now = tr_lamp_of(world, r, range);
    if (before & TR_LAMP_SLIDES)
        rub(c, r, to);
    else
        c->rubs = false;
    if (before == TR_LAMP_ROLLS && now == TR_LAMP_ROLLS) roll(c, r, to);
    c->at[0] = to[0], c->at[1] = to[1];
}

void tr_marks_take(tr_marks *marks, const tr_world *world, const tr_record *record, int n) {
    bool seen[TR_MARKS_CONTACTS] = {false};
    for (int i = 0; i < n && marks->range > 0; i++) {
        const tr_record *r = &record[i];
        int k = 0;
        while (k < TR_MARKS_CONTACTS && marks->contact[k].met &&
               (marks->contact[k].last.a != r->a || marks->contact[k].last.b != r->b))
            k++;
        if (k == TR_MARKS_CONTACTS) continue;
        tr_contact_marks *c = &marks->contact[k];
        if (c->touches) {
            follow(c, world, r, marks->range);
        } else { /* its arcs begin anew */
            for (int end = 0; end < 2; end++) c->at[end] = place_of(world, r, end);
            c->rubs = false;
        }
        c->met = c->touches = seen[k] = true;
        c->last = *r;
    }
    for (int k = 0; k < TR_MARKS_CONTACTS; k++) marks->contact[k].touches &= seen[k];
}

int tr_marks_all(const tr_marks *marks, tr_rim_mark all[TR_MARKS_MOST]) {
    int n = 0;
    for (int k = 0; k < TR_MARKS_CONTACTS; k++) {
        const tr_contact_marks *c = &marks->contact[k];
        for (int i = 0; i < 2 * c->n_rubs; i++) all[n++] = c->rub[i / 2][i % 2];
        for (int i = 0; i < 2 * c->n_ticks; i++) all[n++] = c->tick[i / 2][i % 2];
    }
    return n;
}
