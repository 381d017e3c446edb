/* SPDX-License-Identifier: MIT */
/* Worlds filled by hand, so that drawing is tested without the core: a packing that looks sheared, and two disks over a
 * floor. */
#ifndef TR_HAND_MADE_H
#define TR_HAND_MADE_H

#include "base/random.h"
#include "draw/draw.h"
#include <math.h>
#include <stdlib.h>

enum { HAND_DISKS = 400, HAND_RECORDS = 1600 };

typedef struct hand_made {
    tr_world world;
    tr_record record[HAND_RECORDS];
    tr_view view;
    tr_group group[2]; /* without laws */
    double pos[4 * HAND_DISKS], vel[4 * HAND_DISKS];
} hand_made;

static inline void hand_disk(hand_made *h, const double pos[4], const double vel[4]) {
    int n = h->world.disks.n++;
    for (int k = 0; k < 4; k++) h->pos[4 * n + k] = pos[k], h->vel[4 * n + k] = vel[k];
}

static inline hand_made *hand_start(void) {
    hand_made *h = calloc(1, sizeof *h);
    h->world.disks.pos = h->pos;
    h->world.disks.vel = h->vel;
    h->world.group = h->group, h->world.n_groups = 2;
    h->view = (tr_view){.world = &h->world, .record = h->record};
    return h;
}

/* Pushes overlapping disks apart in a box that shrinks; then forces from the overlaps, stronger along y. */
static inline hand_made *hand_packing(int iterations) {
    hand_made *h = hand_start();
    tr_random random = tr_random_seed(7, 1);
    double w = 26.5e-3, *p = h->pos;
    for (int i = 0; i < HAND_DISKS; i++)
        hand_disk(h,
                  (double[]){(i % 20 - 9.5) * 2.6e-3, (i / 20 - 9.5) * 2.6e-3, 6 * tr_random_uniform(&random),
                             0.76e-3 * (1 + tr_random_uniform(&random))},
                  (double[]){0, 0, 0, 0});
    for (int k = 0; k <= iterations; k++) {
        w = 26.5e-3 - 3.2e-3 * fmin(1.25 * k / (iterations + 1), 1);
        h->view.n_records = 0;
        for (int i = 0; i < HAND_DISKS; i++) {
            double *a = p + 4 * i;
            for (int c = 0; c < 2; c++) a[c] = fmin(fmax(a[c], a[3] - w), w - a[3]);
            for (int j = i + 1; j < HAND_DISKS; j++) {
                double *b = p + 4 * j, dx = b[0] - a[0], dy = b[1] - a[1], near = a[3] + b[3];
                if (dx * dx + dy * dy > near * near) continue;
                double d = hypot(dx, dy), nx = dx / d, ny = dy / d, push = 0.5 * (near - d);
                a[0] -= push * nx, a[1] -= push * ny, b[0] += push * nx, b[1] += push * ny;
                if (h->view.n_records == HAND_RECORDS) continue;
                double f = 4e7 * push * (0.3 + 3 * pow(ny, 4)) + 10, u = tr_random_uniform(&random);
                h->record[h->view.n_records++] = (tr_record){.a = i,
                                                             .b = j,
                                                             .nx = nx,
                                                             .ny = ny,
                                                             .f_n = f,
                                                             .R1 = a[3],
                                                             .R2 = b[3],
                                                             .x = a[0] + nx * a[3],
                                                             .y = a[1] + ny * a[3],
                                                             .mobilisation = pow(u, 1.5),
                                                             .v_s = 1e-3 * u * u * u,
                                                             .v_r = -2e-3 * u * u};
            }
        }
    }
    for (int i = 0; i < HAND_DISKS && h->view.n_records < HAND_RECORDS; i++)
        for (int side = 0; side < 4; side++) {
            double *a = p + 4 * i, s = side & 1 ? 1 : -1, nx = side < 2 ? 0 : -s, ny = side < 2 ? -s : 0;
            if (a[3] + s * (side < 2 ? a[1] : a[0]) < w || h->view.n_records == HAND_RECORDS) continue;
            h->record[h->view.n_records++] = (tr_record){.a = -1 - side,
                                                         .b = i,
                                                         .nx = nx,
                                                         .ny = ny,
                                                         .f_n = 200,
                                                         .R2 = a[3],
                                                         .x = a[0] - nx * a[3],
                                                         .y = a[1] - ny * a[3]};
        }
    h->world.n_walls = 4;
    h->world.wall[0] = (tr_wall){.y = -w, .ny = 1, .vy = 1e-4};
    h->world.wall[1] = (tr_wall){.y = w, .ny = -1, .vy = -1e-4};
    h->world.wall[2] = (tr_wall){.x = -w, .nx = 1, .mass = 1};
    h->world.wall[3] = (tr_wall){.x = w, .nx = -1, .mass = 1};
    static const tr_view_line lines[] = {{"axial strain", "12.35 %"}, {"sin φ", "0.452"},   {"void ratio e", "0.231"},
                                         {"contacts", "702"},         {"sliding", "8.3 %"}, {"coordination", "3.51"}};
    h->view.line = lines, h->view.n_lines = 6;
    h->view.x0 = -30e-3, h->view.x1 = 30e-3, h->view.y0 = -27.5e-3, h->view.y1 = 27.5e-3;
    h->view.time = 0.6175, h->view.time_end = 1;
    return h;
}

/* A contact of disks a and b after arcs da, db; v_s, v_s_by and v_r_by made from s1, s2. a < 0: wall -1-a. */
static inline void hand_contact(hand_made *h, int a, int b, double s1, double s2, double da, double db) {
    const double *q = h->pos + 4 * b;
    tr_record r = {.a = a, .b = b, .R2 = q[3], .s1 = s1, .s2 = s2, .v_s = s1 - s2, .f_n = 1, .da = da, .db = db};
    if (a >= 0) {
        const double *p = h->pos + 4 * a;
        double d = hypot(q[0] - p[0], q[1] - p[1]);
        r.nx = (q[0] - p[0]) / d, r.ny = (q[1] - p[1]) / d, r.R1 = p[3];
    } else {
        r.nx = h->world.wall[-1 - a].nx, r.ny = h->world.wall[-1 - a].ny;
    }
    r.x = q[0] - r.nx * r.R2, r.y = q[1] - r.ny * r.R2;
    double g1 = r.R1 > 0 ? r.R1 / (r.R1 + r.R2) : 1, mean = (s1 + s2) / 2;
    r.v_r = (1 - g1) * s1 + g1 * s2;
    r.v_r_by[0] = r.v_r, r.v_r_by[1] = mean;
    r.v_r_by[2] = s1 * s2 > 0 ? (fabs(s1) < fabs(s2) ? s1 : s2) : 0, r.v_r_by[3] = s1 * s2 > 0 ? mean : 0;
    r.v_s_by[0] = r.v_s, r.v_s_by[1] = r.v_s / 2, r.v_s_by[2] = r.v_s;
    h->record[h->view.n_records++] = r;
}

/* The view of two disks of radii R1, R2 side by side, turned by th1, th2 since they touched. */
static inline hand_made *hand_pair(double R1, double R2, double th1, double th2, double w1, double w2) {
    hand_made *h = hand_start();
    hand_disk(h, (double[]){-R1, 0, th1, R1}, (double[]){0, 0, w1, 0});
    hand_disk(h, (double[]){R2, 0, th2, R2}, (double[]){0, 0, w2, 0});
    hand_contact(h, 0, 1, R1 * w1, -R2 * w2, R1 * th1, R2 * th2);
    double big = fmax(R1, R2);
    h->view.x0 = -2.2 * R1, h->view.x1 = 2.2 * R2, h->view.y0 = -1.15 * big, h->view.y1 = 1.15 * big;
    h->view.time = 0.4, h->view.time_end = 2;
    h->view.title = "Pure rolling, unequal radii";
    return h;
}

/* A disk on a floor, moved by x and turned by th. */
static inline hand_made *hand_floor(double R, double x, double th, double v, double w) {
    hand_made *h = hand_start();
    h->world.n_walls = 1;
    h->world.wall[0] = (tr_wall){.ny = 1};
    hand_disk(h, (double[]){x, R, th, R}, (double[]){v, 0, w, 0});
    hand_contact(h, -1, 0, v, -R * w, x, R * th);
    h->view.x0 = -2 * R, h->view.x1 = 5 * R, h->view.y0 = -R, h->view.y1 = 3 * R;
    h->view.time = 0.15, h->view.time_end = 0.5;
    h->view.title = "From slipping to rolling";
    return h;
}

/* The same as one of the lanes of a film, and a film of lanes. */
static inline tr_show_lane hand_lane(const hand_made *h) {
    return (tr_show_lane){.world = &h->world,
                          .record = h->record,
                          .n_records = h->view.n_records,
                          .slope = NAN,
                          .x0 = h->view.x0,
                          .y0 = h->view.y0,
                          .x1 = h->view.x1,
                          .y1 = h->view.y1};
}

static inline tr_show hand_show(const tr_show_lane *lane, int n) {
    return (tr_show){
        .title = "From slipping to rolling", .time = 0.15, .time_end = 0.5, .slower = 1, .lane = lane, .n_lanes = n};
}

#endif
