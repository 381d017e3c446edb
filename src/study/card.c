/* SPDX-License-Identifier: MIT */
#include "study/card.h"

#include <assert.h>
#include <math.h>
#include <string.h>

static const double R_SMALL = 0.01, U = 0.01; /* [m], [m/s] */

/* Spin of the line of centres and of both bodies, times U; L: distance of the centres. */
typedef struct spins {
    const char *name;
    double beta, w1, w2;
} spins;

enum { MOTIONS = 8, FLOORS = 4, OBSERVERS = 3 };
static const char *const observers[OBSERVERS] = {"resting", "moving", "turning"};

static void make_spins(double R1, double R2, double L, spins all[MOTIONS]) {
    const double turn = 1 / L;
    const spins made[MOTIONS] = {
        {"RBR", turn, turn, turn},                  /* rigid rotation */
        {"PR", 0, 1 / R1, -1 / R2},                 /* gears */
        {"PS", 0, turn, turn},                      /* equal spins */
        {"PR + RBR", -1 / R1, 0, -1 / R1 - 1 / R2}, /* rolls over body 1, which rests */
        {"PS + RBR", -turn, 0, 0},                  /* is carried round it without turning */
        {"spin of 1", 0, 1 / R1, 0},
        {"spin of 2", 0, 0, 1 / R2},
        {"mixed", 0, 1 / R1, -2 / R2}, /* both rims run the same way, 2 twice as fast: rolls and slides */
    };
    for (int k = 0; k < MOTIONS; k++) all[k] = made[k];
}

static tr_motion pair_motion(const spins *s, double R1, double R2, double L) {
    static const double nx = 0.6, ny = 0.8;
    const double B = s->beta * U;
    tr_motion m = {.R1 = R1, .R2 = R2, .x1x = 0.02, .x1y = -0.01, .w1 = s->w1 * U, .w2 = s->w2 * U};
    m.x2x = m.x1x + L * nx, m.x2y = m.x1y + L * ny;
    m.v2x = -B * L * ny, m.v2y = B * L * nx;
    return m;
}

/* A disk on a floor: rolling, sliding, spinning in place, rolling with a rim that runs twice as fast. */
static tr_motion floor_motion(int which, double overlap) {
    tr_motion m = {.R1 = INFINITY, .R2 = R_SMALL, .x1x = 0.02, .x1y = -0.01, .x2x = 0.02};
    m.x2y = m.x1y + R_SMALL - overlap;
    static const double v[FLOORS] = {1, 1, 0, 1}, w[FLOORS] = {-1, 0, 1, -2};
    m.v2x = v[which] * U, m.w2 = w[which] * U / R_SMALL;
    return m;
}

/* The same for another observer: all that moves gets a rigid motion, about the origin. */
static tr_motion seen_by(int observer, tr_motion m) {
    double ux = observer == 1 ? 0.03 : 0, uy = observer == 1 ? -0.02 : 0, W = observer == 2 ? 3 : 0;
    m.v1x += ux - W * m.x1y, m.v1y += uy + W * m.x1x, m.w1 += W;
    m.v2x += ux - W * m.x2y, m.v2y += uy + W * m.x2x, m.w2 += W;
    return m;
}

/* A spring whose bound is never reached, and a bound that is reached at once. */
static void add(tr_card_row **next, const char *label, const tr_motion *m, double overlap) {
    const double never = 1e9, stiff = 1e12, soft = 1e5;
    const tr_card_row springs[] = {
        {.experiment = "roll", .k_roll = soft, .mu_r = never},
        {.experiment = "cap", .k_roll = stiff, .mu_r = 0.1},
        {.experiment = "slide", .k_t = soft, .mu = never},
    };
    for (int k = 0; k < 3; k++) {
        tr_card_row *row = (*next)++;
        *row = springs[k];
        row->motion = *m, row->overlap = overlap, row->k_n = 1e6, row->time_s = 1e-5;
        snprintf(row->label, sizeof row->label, "%s", label);
    }
}

static void add_pairs(tr_card_row **next, double ratio, double part) {
    const double R1 = fmax(ratio, 1) * R_SMALL, R2 = fmax(1 / ratio, 1) * R_SMALL, L = (R1 + R2) * (1 - part);
    spins all[MOTIONS];
    make_spins(R1, R2, L, all);
    for (int k = 0; k < MOTIONS; k++)
        for (int o = 0; o < OBSERVERS; o++) {
            char label[sizeof(*next)->label];
            tr_motion m = seen_by(o, pair_motion(&all[k], R1, R2, L));
            snprintf(label, sizeof label, "%s R1/R2=%g overlap=%g%% (%s observer)", all[k].name, ratio, 100 * part,
                     observers[o]);
            add(next, label, &m, R1 + R2 - L);
        }
}

static void add_floors(tr_card_row **next, double part) {
    static const char *const names[FLOORS] = {"rolling", "sliding", "spinning", "mixed"};
    for (int k = 0; k < FLOORS; k++)
        for (int o = 0; o < 2; o++) { /* a floor does not turn */
            char label[sizeof(*next)->label];
            tr_motion m = seen_by(o, floor_motion(k, part * R_SMALL));
            snprintf(label, sizeof label, "floor: %s overlap=%g%% (%s observer)", names[k], 100 * part, observers[o]);
            add(next, label, &m, part * R_SMALL);
        }
}

void tr_card_make(tr_card_row row[TR_CARD_ROWS]) {
    static const double ratios[] = {0.1, 0.5, 1, 2, 10}, parts[] = {0.001, 0.05};
    tr_card_row *next = row;
    for (int p = 0; p < 2; p++) {
        for (int r = 0; r < 5; r++) add_pairs(&next, ratios[r], parts[p]);
        add_floors(&next, parts[p]);
    }
    assert(next == row + TR_CARD_ROWS);
}

void tr_card_write(FILE *out, const tr_card_row row[TR_CARD_ROWS]) {
    fputs("case,experiment", out);
    for (int k = 0; k < TR_MOTION_COLUMNS; k++) fprintf(out, ",%s", tr_motion_columns[k].name);
    fputs(",overlap,k_n,k_t,mu,k_roll,mu_r,time\n", out);
    for (int i = 0; i < TR_CARD_ROWS; i++) {
        const tr_card_row *r = &row[i];
        fprintf(out, "%s,%s", r->label, r->experiment);
        for (int k = 0; k < TR_MOTION_COLUMNS; k++) {
            double v;
            memcpy(&v, (const char *)&r->motion + tr_motion_columns[k].offset, sizeof v);
            fprintf(out, ",%.17g", v + 0.0);
        }
        fprintf(out, ",%.17g,%g,%g,%g,%g,%g,%g\n", r->overlap, r->k_n, r->k_t, r->mu, r->k_roll, r->mu_r, r->time_s);
    }
}
