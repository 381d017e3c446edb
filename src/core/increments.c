/* SPDX-License-Identifier: MIT */
#include "core/increments.h"
#include "base/math.h"

#include "base/alloc.h"
#include "base/quantile.h"
#include <math.h>
#include <stdlib.h>

/* Histories. TOUCHED: 1 as long as the contact has touched since the interval began. RUN: signed; BACK: how far it has
 * rolled back. */
enum { SLIDE, ROLL, CREEP, TOUCHED, RUN, BACK, N_HIST };
static const double TURN = 0.1, PER_DECADE = 20; /* [a]; bins */

static void end_run(struct tr_increments_sums *s, double run) {
    if (run < TURN) return;
    int bin = (int)(PER_DECADE * tr_log10(run / TURN));
    bin = bin < TR_RUN_BINS ? bin : TR_RUN_BINS - 1;
    s->runs[bin]++, s->rolled[bin] += run;
}

/* du: rolled in this step, in units of a. */
static void roll_on(struct tr_increments_sums *s, double *run, double *back, double du) {
    if (du * *run < 0) {
        *back += fabs(du);
        if (*back < TURN) return;
        end_run(s, fabs(*run));
        *run = copysign(*back, du), *back = 0;
        return;
    }
    double ahead = fabs(du) - *back;
    *back = fmax(0, -ahead);
    if (ahead > 0) *run += copysign(ahead, du);
}

static void step(tr_tile *tile, const tr_law_data *data) {
    tr_increments *increments = (tr_increments *)data->par;
    struct tr_increments_sums *s = &increments->since;
    const tr_group *g = increments->sink.group;
    const tr_group_law *friction = &g->laws[TR_FRICTION];
    double *h[N_HIST];
    for (int k = 0; k < N_HIST; k++) h[k] = g->hist[increments->sink.hist + k] + tile->first;
    tr_lane creep = {0};
    if (friction->law->creep) {
        tr_law_data law = tr_group_data(g, friction);
        friction->law->creep(tile, &law, creep);
    }
    for (int i = 0; i < tile->n; i++) {
        if (!(tile->delta[i] > 0)) {
            end_run(s, fabs(h[RUN][i]));
            for (int k = 0; k < N_HIST; k++) h[k][i] = 0;
            continue;
        }
        double roll = -0.5 * (tile->s1[i] + tile->s2[i]) * tile->dt, f_t = friction->law->step ? tile->f_t[i] : 0;
        h[SLIDE][i] += tile->v_s[i] * tile->dt;
        h[ROLL][i] += roll;
        h[CREEP][i] += creep[i];
        s->touching++;
        s->normal += tile->f_n[i] * (tile->ny[i] * tile->dy[i] - tile->nx[i] * tile->dx[i]);
        s->tangential += f_t * (tile->nx[i] * tile->dy[i] + tile->ny[i] * tile->dx[i]); /* on b: -f_t (n_y, -n_x) */
        if (!(increments->E_star > 0 && tile->f_elastic[i] > 0)) continue;
        double R_star = tr_law_R_star(tile->R1[i], tile->R2[i]);
        double a = tr_law_width(g->shape, tile->f_elastic[i], R_star, increments->E_star);
        s->widths += a;
        roll_on(s, &h[RUN][i], &h[BACK][i], roll / a);
    }
    if (tile->first == 0) s->steps++;
}

void tr_increments_attach(tr_world *world, tr_increments *s) {
    tr_group *g = &world->group[0];
    *s = (tr_increments){0};
    for (int k = TR_NORMAL; k <= TR_FRICTION; k++) {
        const double *E_star = tr_law_value(g->laws[k].law, g->laws[k].par, "E_star");
        if (E_star) s->E_star = *E_star;
    }
    g->in_order = true;
    g->increments_sink = &s->sink;
    tr_group_attach(g, &s->sink, "increments", step, N_HIST);
}

tr_increment tr_increments_of(const tr_group *g, int i) {
    if (!g->increments_sink) return (tr_increment){0};
    double *const *h = g->hist + g->increments_sink->hist;
    return (tr_increment){h[SLIDE][i], h[ROLL][i], h[CREEP][i], h[TOUCHED][i] != 0};
}

/* |part|/|slide| of the contacts that touched all the time and slid; x is room for them. */
static tr_spread spread(const double *part, const double *slide, const double *touched, int n, double *x) {
    tr_spread r = {0};
    int kept = 0;
    for (int i = 0; i < n; i++)
        if (touched[i] && slide[i] != 0) r.mean += x[kept++] = fabs(part[i] / slide[i]);
    if (!kept) return r;
    tr_sort(x, kept);
    return (tr_spread){tr_quantile(x, kept, 0.25), tr_quantile(x, kept, 0.5), tr_quantile(x, kept, 0.75),
                       r.mean / kept};
}

/* Half of the content of the bins is above it [a]. */
static double middle(const double *bin) {
    double sum = 0, below = 0;
    for (int k = 0; k < TR_RUN_BINS; k++) sum += bin[k];
    if (!(sum > 0)) return 0;
    int k = 0;
    while (below + bin[k] < 0.5 * sum) below += bin[k++];
    return TURN * tr_pow(10, (k + (0.5 * sum - below) / bin[k]) / PER_DECADE);
}

bool tr_increments_read(tr_increments *increments, tr_increments_state *state, tr_status *st) {
    struct tr_increments_sums *s = &increments->since;
    const tr_group *g = increments->sink.group;
    double *const *h = g->hist + increments->sink.hist;
    double rolled = 0, far = 0, touched = 0;
    double *room = tr_alloc((size_t)(g->n > 0 ? g->n : 1), sizeof *room, st);
    if (!room) return false;
    *state = (tr_increments_state){.run = middle(s->runs), .run_by_length = middle(s->rolled)};
    state->roll = spread(h[ROLL], h[SLIDE], h[TOUCHED], g->n, room);
    state->creep = spread(h[CREEP], h[SLIDE], h[TOUCHED], g->n, room);
    free(room);
    for (int i = 0; i < g->n; i++) touched += h[TOUCHED][i];
    for (int k = 0; k < TR_RUN_BINS; k++) {
        rolled += s->rolled[k];
        if (k >= (int)(PER_DECADE * tr_log10(2 / TURN))) far += s->rolled[k];
    }
    if (s->touching > 0) state->followed = touched * s->steps / s->touching, state->width = s->widths / s->touching;
    if (s->normal + s->tangential != 0) state->tangential = s->tangential / (s->normal + s->tangential);
    if (rolled > 0) state->long_runs = far / rolled;
    for (int i = 0; i < g->n; i++) h[SLIDE][i] = h[ROLL][i] = h[CREEP][i] = 0, h[TOUCHED][i] = 1;
    *s = (struct tr_increments_sums){0};
    return true;
}
