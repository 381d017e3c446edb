/* SPDX-License-Identifier: MIT */
/* Films of a few bodies: what is drawn lies where geometry says, in its own cell, to one scale; a lamp and marks
 * say what a contact does; nothing that a bad number can break. */
#include "assert_close.h"
#include "draw/canvas.h"
#include "draw/frame_show.h"
#include "draw/hand_made.h"
#include "draw/palette.h"
#include "draw/pen.h"
#include <string.h>
#include <unistd.h>

enum { W = TR_FRAME_WIDTH, H = TR_FRAME_HEIGHT, N_BYTES = 4 * W * H };

static tr_canvas *canvas;

static int set_up(void **state) {
    (void)state;
    tr_status st = {0};
    canvas = tr_canvas_create(&st);
    return canvas ? 0 : -1;
}

static int tear_down(void **state) {
    (void)state;
    tr_canvas_free(canvas);
    return 0;
}

/* 0xRRGGBB */
static unsigned pixel(int x, int y) {
    const unsigned char *p = tr_canvas_pixels(canvas) + 4 * (y * W + x);
    return (unsigned)p[2] << 16 | (unsigned)p[1] << 8 | p[0];
}

typedef struct rect {
    int x0, y0, x1, y1; /* the ends do not belong to it */
} rect;

static const rect all = {0, 0, W, H}, picture = {0, 124, 840, 650}, panel = {845, 66, W, 660};

static int count(rect r, unsigned hue) {
    int n = 0;
    for (int y = r.y0; y < r.y1; y++)
        for (int x = r.x0; x < r.x1; x++) n += pixel(x, y) == hue;
    return n;
}

/* The smallest rectangle that holds every pixel of this colour. */
static rect extent(rect r, unsigned hue) {
    rect e = {W, H, 0, 0};
    for (int y = r.y0; y < r.y1; y++)
        for (int x = r.x0; x < r.x1; x++)
            if (pixel(x, y) == hue) {
                e.x0 = x < e.x0 ? x : e.x0, e.x1 = x >= e.x1 ? x + 1 : e.x1;
                e.y0 = y < e.y0 ? y : e.y0, e.y1 = y >= e.y1 ? y + 1 : e.y1;
            }
    return e;
}

static unsigned char *copy(void) {
    unsigned char *c = malloc(N_BYTES);
    return memcpy(c, tr_canvas_pixels(canvas), N_BYTES);
}

/* Pixels in a rectangle that are off by more than `level` of 255 in a colour. */
static int differ(const unsigned char *before, rect r, int level) {
    const unsigned char *now = tr_canvas_pixels(canvas);
    int n = 0;
    for (int y = r.y0; y < r.y1; y++)
        for (int x = r.x0; x < r.x1; x++) {
            int most = 0;
            for (int c = 0; c < 3; c++) {
                int k = 4 * (y * W + x) + c, d = abs(before[k] - now[k]);
                most = d > most ? d : most;
            }
            n += most > level;
        }
    return n;
}

/* A disk on a sloping floor: only what a tilt shows. */
static hand_made *floor_scene(void) {
    hand_made *h = hand_floor(10e-3, 5e-3, 0, 0.1, 0);
    h->record[0].da = h->record[0].db = 0;
    h->view.x0 = -30e-3, h->view.x1 = 30e-3, h->view.y0 = -15e-3, h->view.y1 = 25e-3;
    return h;
}

/* Middle of the run of this colour in a column; a thick line's. */
static double middle_of(int x, unsigned hue) {
    double sum = 0;
    int n = 0;
    for (int y = picture.y0; y < picture.y1; y++)
        if (pixel(x, y) == hue) sum += y + 0.5, n++;
    return sum / n;
}

static void test_tilted_floor_is_where_geometry_says(void **state) {
    (void)state;
    for (int i = -2; i <= 2; i++) {
        hand_made *h = floor_scene();
        tr_show_lane lane = hand_lane(h);
        tr_show show = hand_show(&lane, 1);
        lane.tilt = 0.15 * i;
        tr_draw_show(canvas, &show);
        /* columns left and right of the disk, which alone has the floor's colour otherwise, in its rim */
        rect disk = extent(picture, TR_DISK);
        int x1 = 60, x2 = 780;
        if (x1 >= disk.x0 || x2 <= disk.x1) fail_msg("the disk is in the way");
        double y1 = middle_of(x1, TR_WALL), y2 = middle_of(x2, TR_WALL), slope = (y1 - y2) / (x2 - x1);
        assert_close(slope, tan(lane.tilt), 0, 2.0 / (x2 - x1)); /* each end to a pixel */
        /* the disk stands on it: R = distance of its centre from the line. Its rim is 3 px, 2 px of the line are pixels
         * of neither pure colour */
        double cx = 0.5 * (disk.x0 + disk.x1), cy = 0.5 * (disk.y0 + disk.y1), R = 0.5 * (disk.x1 - disk.x0) + 3;
        double above = (y1 - slope * (cx - x1) - cy) * cos(lane.tilt);
        assert_close(above, R, 0, 2.5);
        /* and the hatching is on the other side: grey of its own below the line only */
        int over = 0, under = 0;
        for (int x = x1; x < x2; x++)
            for (int y = picture.y0; y < picture.y1; y++)
                if (pixel(x, y) == TR_RIM) y > y1 - slope *(x - x1) ? under++ : over++;
        assert_true(under > 200 && over == 0);
        free(h);
    }
}

/* The world turned by -angle and shown with that tilt is the same picture: points, normals, walls and their hatching,
 * arrows, arcs, ticks, the way of the contacts. Turning rounds: an edge may fall on the other side of Cairo's grid of
 * 1/256 px. */
static void test_turned_world_with_tilt_is_the_same_picture(void **state) {
    (void)state;
    const double angle = 0.4, c = cos(angle), s = -sin(angle);
    hand_made *h = hand_floor(10e-3, 14e-3, -0.6, 0.2, -6);
    hand_disk(h, (double[]){34e-3, 10e-3, 0.3, 10e-3}, (double[]){-0.1, 0.15, 9, 0});
    hand_contact(h, 0, 1, 0.1, -0.05, 8e-3, -5e-3);
    h->world.wall[0].x = 20e-3;
    double trace[] = {0, 0, 14e-3, 0, NAN, NAN, 24e-3, 10e-3, 30e-3, 25e-3};
    tr_show_lane lane = hand_lane(h);
    lane.trace = trace, lane.n_trace = 5, lane.slope = 0;
    tr_show show = hand_show(&lane, 1);
    tr_draw_show(canvas, &show);
    unsigned char *level = copy();
    for (int i = 0; i < 5; i++) {
        double x = trace[2 * i], y = trace[2 * i + 1];
        trace[2 * i] = c * x - s * y, trace[2 * i + 1] = s * x + c * y;
    }
    double *vectors[] = {h->pos, h->pos + 4, h->vel, h->vel + 4, &h->world.wall[0].x, &h->world.wall[0].nx};
    for (int i = 0; i < 6; i++) {
        double x = vectors[i][0], y = vectors[i][1];
        vectors[i][0] = c * x - s * y, vectors[i][1] = s * x + c * y;
    }
    h->pos[2] -= angle, h->pos[6] -= angle;
    for (int i = 0; i < 2; i++) {
        tr_record *r = &h->record[i];
        double x = r->x, y = r->y, nx = r->nx, ny = r->ny;
        r->x = c * x - s * y, r->y = s * x + c * y;
        r->nx = c * nx - s * ny, r->ny = s * nx + c * ny;
    }
    tr_draw_show(canvas, &show);
    assert_true(differ(level, picture, 8) > 10000); /* turned, but not yet with the tilt */
    lane.tilt = angle;
    tr_draw_show(canvas, &show);
    assert_int_equal(differ(level, all, 8), 0);
    free(level);
    free(h);
}

static void test_far_point_of_an_endless_wall_is_as_good(void **state) {
    (void)state;
    hand_made *h = floor_scene();
    tr_show_lane lane = hand_lane(h);
    tr_show show = hand_show(&lane, 1);
    tr_draw_show(canvas, &show);
    int near = count(picture, TR_WALL);
    h->world.wall[0].x = 1e3;
    tr_draw_show(canvas, &show);
    assert_int_equal(count(picture, TR_WALL), near);
    h->world.wall[0].x = 0, h->world.wall[0].length = 20e-3; /* one with ends has them */
    tr_draw_show(canvas, &show);
    assert_true(count(picture, TR_WALL) < near - 1000);
    free(h);
}

/* Below the floor, at its lower end: what the number and its lines change. */
static void test_slope_is_named_at_the_lower_end(void **state) {
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        hand_made *h = floor_scene();
        tr_show_lane lane = hand_lane(h);
        tr_show show = hand_show(&lane, 1);
        lane.tilt = 0.2 * sign;
        tr_draw_show(canvas, &show);
        double y1 = middle_of(40, TR_WALL), y2 = middle_of(790, TR_WALL);
        unsigned char *without = copy();
        lane.slope = 0.2;
        tr_draw_show(canvas, &show);
        int below = 0, above = 0, lower = 0, row[H] = {0}, level = 0, arc = 0;
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++)
                if (differ(without, (rect){x, y, x + 1, y + 1}, 60)) {
                    above += y < y1 + (y2 - y1) * (x - 40) / 750 - 4;
                    below++;
                    row[y]++;
                    lower += sign > 0 ? x < 420 : x > 420;
                }
        assert_true(below > 400);
        assert_int_equal(above, 0);
        assert_int_equal(lower, below);
        /* the angle opens upwards from the level line, its longest row */
        for (int y = 0; y < H; y++) level = row[y] > row[level] ? y : level;
        for (int y = 0; y < level - 3; y++) arc += row[y];
        assert_true(row[level] > 100 && arc > 20);
        free(without);
        free(h);
    }
}

/* Two scenes of different size side by side: as many pixels to the metre. */
static void test_lanes_share_a_scale(void **state) {
    (void)state;
    hand_made *small = hand_start(), *big = hand_start();
    hand_disk(small, (double[]){0, 0, 0, 5e-3}, (double[]){0, 0, 0, 0});
    hand_disk(big, (double[]){0, 0, 0, 20e-3}, (double[]){0, 0, 0, 0});
    small->view.x0 = small->view.y0 = -6e-3, small->view.x1 = small->view.y1 = 6e-3;
    big->view.x0 = big->view.y0 = -25e-3, big->view.x1 = big->view.y1 = 25e-3;
    for (int left = 0; left < 2; left++) { /* the small one */
        tr_show_lane lane[2];
        lane[!left] = hand_lane(small), lane[left] = hand_lane(big);
        tr_show show = hand_show(lane, 2);
        tr_draw_show(canvas, &show);
        rect half[] = {{0, 80, W / 2, 640}, {W / 2, 80, W, 640}};
        rect s = extent(half[!left], TR_DISK), b = extent(half[left], TR_DISK);
        /* with their rims of 3 px at both ends, which are not counted; edges to a pixel each */
        assert_close(b.x1 - b.x0 + 6, 4.0 * (s.x1 - s.x0 + 6), 0, 6);
        assert_true(s.x1 - s.x0 > 60);
    }
    free(small);
    free(big);
}

/* What one lane does is seen in its own cell only: here its bodies, larger than the frame, run out of every side. */
static void test_nothing_leaves_its_cell(void **state) {
    (void)state;
    hand_made *h[2] = {hand_floor(10e-3, 0, 0, 0, 0), hand_floor(10e-3, 0, 0, 0, 0)};
    double trace[] = {-1, -1, 1, 1, 1, -1, -1, 1};
    for (int which = 0; which < 2; which++) {
        tr_show_lane lane[] = {hand_lane(h[0]), hand_lane(h[1])};
        tr_show show = hand_show(lane, 2);
        show.range = 1;
        lane[which].trace = trace, lane[which].n_trace = 1; /* for the legend */
        tr_draw_show(canvas, &show);
        unsigned char *before = copy();
        lane[which].n_trace = 4;
        for (int i = 0; i < 40; i++)
            hand_disk(h[which], (double[]){0.01 * (i % 8 - 4), 0.02 * (i / 8 - 2), i, 20e-3},
                      (double[]){5 - i, i - 2, 30 * i, 0});
        h[which]->world.n_walls = 3;
        h[which]->world.wall[1] = (tr_wall){.x = -0.01, .nx = 1};
        h[which]->world.wall[2] = (tr_wall){.y = 0.02, .nx = -0.6, .ny = -0.8};
        hand_contact(h[which], -2, 1, 1, -2, 0.1, 0.1);
        lane[which].n_records = 1; /* the numbers stay */
        tr_draw_show(canvas, &show);
        rect own = which ? (rect){W / 2, 76, W - 28, 660} : (rect){28, 76, W / 2, 660};
        assert_true(differ(before, own, 8) > 20000);
        assert_int_equal(differ(before, own, 8), differ(before, all, 8));
        free(before);
    }
    free(h[0]);
    free(h[1]);
}

static void test_every_number_of_lanes_has_its_cells(void **state) {
    (void)state;
    hand_made *h = hand_floor(10e-3, 0, 0, 0, 0);
    h->view.n_records = 0;
    tr_show_lane lane[TR_MAX_LANES];
    for (int i = 0; i < TR_MAX_LANES; i++) lane[i] = hand_lane(h);
    tr_chart chart = {.name = {"speed"}, .unit = "m/s", .top = 1};
    for (int n = 1; n <= TR_MAX_LANES; n++)
        for (int with = 0; with < 2; with++) {
            tr_show show = hand_show(lane, n);
            show.chart = with ? &chart : NULL;
            tr_draw_show(canvas, &show);
            rect cells = {0, 66, with ? 830 : W, 662};
            rect e = extent(cells, TR_DISK);
            assert_true(e.x0 > 28 && e.x1 < (with || n == 1 ? 812 : W - 28));
            assert_true(count(cells, TR_DISK) > n * 300); /* of a disk of 20 px across in each */
        }
    free(h);
}

/* No definition is wrong: one that says otherwise than the first is hatched, with more than 1 % of the range between
 * them, and nothing has a tick or a cross. */
static void test_definition_is_hatched_when_and_only_when_it_differs(void **state) {
    (void)state;
    hand_made *h = hand_pair(10e-3, 10e-3, 0, 0, 0, 0);
    tr_record *r = h->record;
    tr_show_lane lane = hand_lane(h);
    tr_show show = hand_show(&lane, 1);
    show.range = 1, show.expert = true;
    for (int k = 0; k < TR_MAX_VELOCITY_MEASURES; k++) r->v_s_by[k] = 0.3, r->v_r_by[k] = -0.2;
    for (int rolling = 0; rolling < 2; rolling++) {
        const unsigned hue = rolling ? TR_ROLLS : TR_SLIDES;
        double *by = rolling ? r->v_r_by : r->v_s_by, same = by[0];
        tr_draw_show(canvas, &show);
        int solid = count(panel, hue);
        for (int k = 1; k < (rolling ? tr_n_rolling_velocities : tr_n_sliding_velocities); k++) {
            for (int sign = -1; sign <= 1; sign += 2) {
                by[k] = same + sign * 0.009;
                tr_draw_show(canvas, &show);
                assert_close(count(panel, hue), solid, 0, 60); /* the bar is 1 px longer or shorter */
                by[k] = same + sign * 0.011;
                tr_draw_show(canvas, &show);
                assert_true(count(panel, hue) < solid - 200);
                assert_int_equal(count(panel, TR_GREEN), 0); /* of a tick */
            }
            by[k] = same;
        }
    }
    free(h);
}

/* What the lamp and the contact say: nothing but an ink frame and dot, one colour, the other, half and half. */
static void test_lamp_says_what_the_contact_does(void **state) {
    (void)state;
    const double speed[] = {0, 0.5};
    for (int slides = 0; slides < 2; slides++)
        for (int rolls = 0; rolls < 2; rolls++) {
            hand_made *h = hand_pair(10e-3, 10e-3, 0, 0, 0, 0);
            h->record[0].v_s_by[0] = speed[slides], h->record[0].v_r_by[0] = -speed[rolls];
            tr_show_lane lane = hand_lane(h);
            tr_show show = hand_show(&lane, 1);
            show.range = 1;
            tr_draw_show(canvas, &show);
            rect lamp = {856, 80, 1248, 116}; /* without its frame */
            int s = count(lamp, TR_SLIDES), r = count(lamp, TR_ROLLS), both = s + r;
            assert_true(slides || rolls ? both > 10000 : both == 0);
            assert_true(slides ? s > 4000 : s == 0);
            assert_true(rolls ? r > 4000 : r == 0);
            /* the dot, and the double arrow of what slides */
            int arrow = count(picture, TR_SLIDES), dot = count(picture, TR_ROLLS);
            assert_true(slides ? arrow > 300 : arrow == 0);
            assert_true(rolls ? dot > 20 : dot == 0);
            free(h);
        }
    /* what is below 1 % of the range is not seen */
    hand_made *h = hand_pair(10e-3, 10e-3, 0, 0, 0, 0);
    h->record[0].v_s_by[0] = 0.0099, h->record[0].v_r_by[0] = 0.0099;
    tr_show_lane lane = hand_lane(h);
    tr_show show = hand_show(&lane, 1);
    show.range = 1;
    tr_draw_show(canvas, &show);
    assert_int_equal(count(picture, TR_SLIDES) + count(picture, TR_ROLLS), 0);
    free(h);
}

/* Each surface its own way: with V_s > 0 the lower surface, of the floor, goes to the left past that of the disk. */
static void test_double_arrow_points_the_ways_of_the_surfaces(void **state) {
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        hand_made *h = hand_floor(10e-3, 0, 0, 0.2 * sign, 0);
        tr_show_lane lane = hand_lane(h);
        tr_show show = hand_show(&lane, 1);
        show.range = 0.2;
        tr_draw_show(canvas, &show);
        double floor = middle_of(60, TR_WALL), sum[2] = {0}, n[2] = {0}; /* heads are where most of the pixels are */
        rect e = extent(picture, TR_SLIDES);
        for (int y = e.y0; y < e.y1; y++)
            for (int x = e.x0; x < e.x1; x++)
                if (pixel(x, y) == TR_SLIDES && fabs(y - floor) > 6) sum[y > floor] += x, n[y > floor]++;
        double up = sum[0] / n[0], down = sum[1] / n[1];
        assert_true(sign > 0 ? up > down + 4 : down > up + 4);
        free(h);
    }
}

/* A rubbed trace lies where it is said to lie, turns with its disk, and a tick too. */
static void test_marks_turn_with_their_disk(void **state) {
    (void)state;
    for (int number = 0; number < 2; number++)
        for (int k = 0; k < 4; k++) {
            hand_made *h = hand_floor(10e-3, 5e-3, k * M_PI / 2, 0, 0);
            h->record[0].da = h->record[0].db = 0;
            h->record[0].v_s_by[0] = h->record[0].v_r_by[0] = 0;
            tr_rim_mark mark = {0, -0.3, 0.3, number, 0.1};
            if (number) mark.from = mark.to = 0;
            tr_show_lane lane = hand_lane(h);
            lane.mark = &mark, lane.n_marks = 1;
            tr_show show = hand_show(&lane, 1);
            show.range = 1;
            tr_draw_show(canvas, &show);
            rect disk = extent(picture, TR_DISK), m = extent(picture, number ? TR_ROLLS : TR_SLIDES);
            double cx = 0.5 * (disk.x0 + disk.x1), cy = 0.5 * (disk.y0 + disk.y1), R = 0.5 * (disk.x1 - disk.x0);
            double x = 0.5 * (m.x0 + m.x1) - cx, y = cy - 0.5 * (m.y0 + m.y1);
            assert_close(remainder(atan2(y, x) - k * M_PI / 2, 2 * M_PI), 0, 0, 0.2); /* its number leans on it */
            assert_true(hypot(x, y) > 0.9 * R);
            free(h);
        }
}

/* On a floor a trace is as long as it was rubbed. */
static void test_rubbed_floor_is_as_long_as_said(void **state) {
    (void)state;
    hand_made *h = hand_floor(10e-3, 5e-3, 0, 0, 0);
    h->record[0].da = h->record[0].db = 0;
    tr_rim_mark mark = {-1, -15e-3, 25e-3, 0, 0};
    tr_show_lane lane = hand_lane(h);
    lane.mark = &mark, lane.n_marks = 1;
    tr_show show = hand_show(&lane, 1);
    show.range = 1;
    tr_draw_show(canvas, &show);
    rect m = extent(picture, TR_SLIDES), disk = extent(picture, TR_DISK);
    double scale = (disk.x1 - disk.x0 + 6) / 20e-3, middle = 0.5 * (disk.x0 + disk.x1); /* rims are 3 px */
    assert_close(m.x0, middle - 20e-3 * scale, 0, 4); /* the disk is at 5 mm; strokes are 3.5 px */
    assert_close(m.x1, middle + 20e-3 * scale, 0, 4);
    free(h);
}

/* Two contacts of other velocities. The panel of one that is chosen is the panel of a world that has no other, but
 * for the note that there is one more; so are the arcs on the rims. One that does not touch has no numbers,
 * whatever else touches. */
static void test_the_panel_shows_the_contact_that_is_chosen(void **state) {
    (void)state;
    hand_made *h = hand_pair(10e-3, 10e-3, 0, 0, 3, 4);
    h->world.n_walls = 1;
    h->world.wall[0] = (tr_wall){.y = -10e-3, .ny = 1};
    hand_contact(h, -1, 1, 0.02, -0.05, 4e-3, 9e-3);
    const rect above = {845, 66, W, 330};
    for (int lanes = 1; lanes <= 2; lanes++)
        for (int k = 0; k < 2; k++) {
            tr_show_lane lane[2] = {hand_lane(h), hand_lane(h)}, alone[2] = {hand_lane(h), hand_lane(h)};
            for (int i = 0; i < 2; i++) {
                lane[i].contact = (tr_contact_id){h->record[k].a, h->record[k].b};
                alone[i].record = &h->record[k], alone[i].n_records = 1;
            }
            tr_show show = hand_show(alone, lanes);
            show.range = 0.1;
            tr_draw_show(canvas, &show);
            unsigned char *want = copy();
            show.lane = lane;
            tr_draw_show(canvas, &show);
            /* the point of the other contact is still there, in the picture; lanes have no note */
            assert_int_equal(differ(want, lanes == 1 ? above : (rect){0, 600, W, 660}, 0), 0);
            lane[0].contact = lane[1].contact = (tr_contact_id){h->record[!k].a, h->record[!k].b};
            tr_draw_show(canvas, &show);
            assert_true(differ(want, lanes == 1 ? above : picture, 20) > 100);
            free(want);
        }
    tr_show_lane lane = hand_lane(h), bare = hand_lane(h);
    lane.contact = (tr_contact_id){-1, 0};
    bare.n_records = 0;
    tr_show show = hand_show(&bare, 1);
    show.range = 0.1;
    tr_draw_show(canvas, &show);
    unsigned char *want = copy();
    show.lane = &lane;
    tr_draw_show(canvas, &show);
    assert_int_equal(differ(want, (rect){845, 110, W, 660}, 0), 0); /* below the line that says so */
    assert_true(differ(want, (rect){845, 66, W, 110}, 20) > 20);    /* and which is meant */
    free(want), free(h);
}

/* Range of the plot from its horizontal grid is not known here; equal steps of value, and of time, are equal on paper.
 */
static void test_chart_is_linear_in_value_and_time(void **state) {
    (void)state;
    enum { LANE = 1 }; /* its curve alone has the colour, its mark alone is faint */
    hand_made *h = floor_scene();
    h->view.n_records = 0;
    tr_show_lane lane[] = {hand_lane(h), hand_lane(h)};
    tr_show show = hand_show(lane, 2);
    double time[2] = {0, 0}, value[2];
    tr_chart chart = {
        .name = {"speed"}, .hue = {TR_SLIDES}, .unit = "m/s", .top = 3, .bottom = -1, .n = 2, .time = time};
    chart.value[LANE][0] = value;
    chart.mark[0] = chart.mark[1] = NAN;
    show.chart = &chart, show.time_end = 4, show.expert = true;
    const rect plot = {900, 200, W, 640};
    double y[5], x[4], mark[4];
    for (int k = 0; k < 5; k++) {
        time[1] = 4, value[0] = value[1] = k - 1;
        tr_draw_show(canvas, &show);
        rect e = extent((rect){930, 150, 1200, 640}, TR_SLIDES);
        y[k] = 0.5 * (e.y0 + e.y1);
        if (k > 0) assert_true(y[k] < y[k - 1] - 40);                /* upwards */
        if (k > 1) assert_close(y[k] - y[k - 1], y[1] - y[0], 0, 2); /* lines to half a pixel at each end */
    }
    for (int k = 0; k < 4; k++) {
        time[1] = k + 0.5, value[0] = value[1] = 1;
        tr_draw_show(canvas, &show);
        x[k] = extent(plot, TR_SLIDES).x1; /* the marker at its end */
        if (k > 1) assert_close(x[k] - x[k - 1], x[1] - x[0], 0, 2);
    }
    assert_true(x[1] > x[0] + 40);
    chart.n = 0;
    const rect beside = {845, 200, W, 640};
    for (int k = 0; k < 4; k++) {
        chart.mark[LANE] = k + 0.5;
        tr_draw_show(canvas, &show);
        rect e = extent(plot, TR_FAINT);
        mark[k] = 0.5 * (e.x0 + e.x1);
        assert_close(x[k] - mark[k], x[0] - mark[0], 0, 2); /* where a curve ends at that time */
        assert_true(e.x1 - e.x0 <= 16 && e.y1 - e.y0 > 200);
    }
    assert_true(x[0] - mark[0] < 10); /* half a marker */
    for (int k = 0; k < 3; k++) {
        chart.mark[LANE] = (double[]){NAN, -0.5, 4.4}[k];
        tr_draw_show(canvas, &show);
        assert_int_equal(count(beside, TR_FAINT), 0);
    }
    free(h);
}

static void test_gap_in_a_curve_stays_a_gap(void **state) {
    (void)state;
    hand_made *h = floor_scene();
    h->view.n_records = 0;
    tr_show_lane lane[] = {hand_lane(h), hand_lane(h)};
    tr_show show = hand_show(lane, 2);
    double time[] = {0, 1, 2, 3, 4}, value[] = {1, 1, NAN, 1, 1};
    tr_chart chart = {.name = {"speed"}, .hue = {TR_SLIDES}, .unit = "m/s", .top = 2, .n = 5, .time = time};
    for (int i = 0; i < TR_MAX_LANES; i++) chart.mark[i] = NAN;
    chart.value[1][0] = value;
    show.chart = &chart, show.time_end = 4, show.expert = true;
    const rect plot = {900, 200, W, 640};
    tr_draw_show(canvas, &show);
    rect e = extent(plot, TR_SLIDES);
    int middle = (e.x0 + e.x1) / 2;
    assert_int_equal(count((rect){middle - 60, 200, middle + 60, 640}, TR_SLIDES), 0);
    assert_true(count((rect){middle - 130, 200, middle - 90, 640}, TR_SLIDES) > 60);
    assert_true(count((rect){middle + 90, 200, middle + 130, 640}, TR_SLIDES) > 60);
    free(h);
}

/* Five equal words where two fit into a line. */
static void test_paragraph_breaks_lines_and_then_shrinks(void **state) {
    (void)state;
    cairo_t *cr = canvas->cr;
    tr_text at = {.size = 20};
    const char *text = "mmm mmm mmm mmm mmm";
    double three = tr_pen_width(cr, at, "mmm mmm mmm");
    at.room = tr_pen_width(cr, at, "mmm mmm") + 1;
    assert_close(tr_pen_paragraph(cr, at, 3, text, false), 3 * 1.25 * 20, 1e-12, 0);
    assert_close(tr_pen_paragraph(cr, at, 4, text, false), 3 * 1.25 * 20, 1e-12, 0);
    /* two lines: three words must fit; the size falls by whole pixels */
    double size = floor(20 * at.room / three);
    assert_close(tr_pen_paragraph(cr, at, 2, text, false), 2 * 1.25 * size, 1e-12, 0);
}

static void test_still_keeps_its_margins_and_verdicts(void **state) {
    (void)state;
    hand_made *h = hand_floor(10e-3, 14e-3, -0.6, 0.2, -6);
    h->record[0].da = h->record[0].db = 0;
    tr_show_lane lane = hand_lane(h);
    tr_show show = hand_show(&lane, 1);
    char caption[321];
    for (int i = 0; i < 320; i++) caption[i] = i % 7 == 6 ? ' ' : 'm'; /* the widest letter */
    caption[320] = 0;
    tr_show_check check[8];
    for (int i = 0; i < 8; i++)
        check[i] = (tr_show_check){"", "final speed of the centre of disk 0", "0.6667 m/s", "0.6667 m/s", true};
    show.caption = caption, show.check = check, show.n_checks = 2, show.expert = true;
    tr_draw_show(canvas, &show);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++)
            if ((x < 20 || x > W - 20 || y < 16 || y > H - 12) && pixel(x, y) != TR_WHITE)
                fail_msg("the margin has ink at (%d, %d)", x, y);
    const rect table = {845, 66, 890, 200};
    int green = count(table, TR_GREEN);
    int ink = count(table, TR_INK);
    assert_true(green > 40);
    check[1].ok = false;
    tr_draw_show(canvas, &show);
    assert_close(count(table, TR_GREEN), green / 2.0, 0, 3); /* two ticks, then one; edges differ by a pixel's place */
    assert_true(count(table, TR_INK) > ink + 20);            /* the cross */
    show.n_checks = 8;                                       /* more than fit: nothing runs over the caption */
    unsigned char *before = copy();
    tr_draw_show(canvas, &show);
    assert_int_equal(differ(before, (rect){0, 580, W, H}, 8), 0);
    free(before);
    free(h);
}

static void test_same_show_same_pixels(void **state) {
    (void)state;
    hand_made *h = hand_floor(10e-3, 14e-3, -0.6, 0.2, -6), *pair = hand_pair(10e-3, 5e-3, 1.2, -2.4, 0.5, -1);
    tr_show_lane lane[] = {hand_lane(h), hand_lane(pair)}, other = hand_lane(pair);
    double time[] = {0, 0.1}, value[] = {0, 1};
    tr_chart chart = {.name = {"V_s", "V_r"}, .unit = "1", .top = 1, .n = 2, .time = time};
    for (int i = 0; i < 2; i++) chart.value[i][0] = chart.value[i][1] = value;
    tr_show show = hand_show(lane, 2), between = hand_show(&other, 1);
    show.chart = &chart;
    tr_draw_show(canvas, &show);
    unsigned char *first = copy();
    tr_draw_show(canvas, &between);
    assert_true(differ(first, all, 0) > 1000);
    tr_draw_show(canvas, &show);
    assert_memory_equal(first, tr_canvas_pixels(canvas), N_BYTES);
    free(first);
    free(h);
    free(pair);
}

/* A film and a still of n lanes with everything in them, of which one number is bad. */
static void draw_bad(int lanes, int which, double bad) {
    hand_made *h = hand_floor(10e-3, 14e-3, -0.6, 0.2, -6);
    tr_record *r = h->record;
    tr_patch_pair pair = {.R_star = 5e-3, .E_star = 1e9, .d = 0.02, .mu = 0.3};
    tr_patch_state inside = {0};
    tr_status st = {0};
    assert_true(tr_patch_state_new(&inside, &pair, 10, &st));
    tr_patch_state_grid(&inside, &pair, 1000);
    double trace[] = {0, 0, 14e-3, 0}, time[] = {0, 0.1}, value[] = {0, 1};
    tr_rim_mark mark[] = {{0, 0.1, 0.9, 0, 0}, {-1, -0.01, 0.01, 3, 0.1}};
    tr_chart chart = {.name = {"V_s", "V_r"}, .unit = "m/s", .top = 1, .n = 2, .time = time};
    tr_show_lane lane[TR_MAX_LANES];
    for (int i = 0; i < TR_MAX_LANES; i++) {
        lane[i] = hand_lane(h);
        lane[i].label = "μ = 0.1, and more words than there is room for", lane[i].slope = 0.1, lane[i].tilt = 0.1;
        lane[i].trace = trace, lane[i].n_trace = 2, lane[i].mark = mark, lane[i].n_marks = 2;
        lane[i].inset = &inside, lane[i].inset_pair = &pair, lane[i].inset_a = -1;
        chart.value[i][0] = chart.value[i][1] = value, chart.mark[i] = 0.1;
    }
    tr_show_check check = {"", "speed", "1 m/s", "1 m/s", true};
    tr_show show = hand_show(lane, lanes);
    show.chart = &chart, show.check = &check, show.range = 1;
    double *const target[] = {&h->pos[0],
                              &h->pos[2],
                              &h->pos[3],
                              &h->vel[0],
                              &h->vel[2],
                              &r->x,
                              &r->nx,
                              &r->R2,
                              &r->v_s_by[0],
                              &r->v_r_by[1],
                              &r->da,
                              &r->db,
                              &h->world.wall[0].x,
                              &h->world.wall[0].ny,
                              &lane[0].tilt,
                              &lane[0].slope,
                              &lane[0].x0,
                              &lane[0].y1,
                              &trace[2],
                              &mark[0].to,
                              &chart.top,
                              &chart.bottom,
                              &time[1],
                              &value[0],
                              &chart.mark[0],
                              &show.time,
                              &show.time_end,
                              &show.slower,
                              &show.range,
                              &inside.P,
                              &h->world.wall[0].length};
    const int n = sizeof target / sizeof *target;
    if (which < n) *target[which] = bad;
    if (which == n) chart.n = 0;
    if (which == n + 1) chart.n = 1;
    if (which == n + 2)
        for (int i = 0; i < TR_MAX_LANES; i++) lane[i].n_records = 0;
    for (int still = 0; still < 2; still++) {
        show.caption = still ? "One sentence." : NULL, show.n_checks = still, show.expert = still == which % 2;
        tr_draw_show(canvas, &show);
        if (pixel(0, 0) != TR_WHITE) fail_msg("%d lanes, number %d = %g, still %d", lanes, which, bad, still);
    }
    tr_patch_state_free(&inside);
    free(h);
}

static void test_bad_numbers_are_left_out(void **state) {
    (void)state;
    const double bad[] = {NAN, INFINITY, 0, -1, 1e300};
    for (int i = 0; i < 5; i++)
        for (int which = 0; which < 34; which++) draw_bad(which % 2 ? 1 : 2, which, bad[i]);
    for (int lanes = -1; lanes <= TR_MAX_LANES + 1; lanes++) draw_bad(lanes, 32, 0);
    hand_made *none = hand_start();
    tr_show_lane lane = hand_lane(none);
    tr_show show = {.lane = &lane, .n_lanes = 1};
    tr_draw_show(canvas, &show);
    free(none);
    char path[] = "/tmp/test_show.XXXXXX";
    tr_status st = {0};
    close(mkstemp(path));
    assert_true(tr_canvas_png(canvas, path, &st)); /* Cairo is still in good health */
    remove(path);
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tilted_floor_is_where_geometry_says),
        cmocka_unit_test(test_turned_world_with_tilt_is_the_same_picture),
        cmocka_unit_test(test_far_point_of_an_endless_wall_is_as_good),
        cmocka_unit_test(test_slope_is_named_at_the_lower_end),
        cmocka_unit_test(test_lanes_share_a_scale),
        cmocka_unit_test(test_nothing_leaves_its_cell),
        cmocka_unit_test(test_every_number_of_lanes_has_its_cells),
        cmocka_unit_test(test_definition_is_hatched_when_and_only_when_it_differs),
        cmocka_unit_test(test_lamp_says_what_the_contact_does),
        cmocka_unit_test(test_double_arrow_points_the_ways_of_the_surfaces),
        cmocka_unit_test(test_marks_turn_with_their_disk),
        cmocka_unit_test(test_rubbed_floor_is_as_long_as_said),
        cmocka_unit_test(test_the_panel_shows_the_contact_that_is_chosen),
        cmocka_unit_test(test_chart_is_linear_in_value_and_time),
        cmocka_unit_test(test_gap_in_a_curve_stays_a_gap),
        cmocka_unit_test(test_paragraph_breaks_lines_and_then_shrinks),
        cmocka_unit_test(test_still_keeps_its_margins_and_verdicts),
        cmocka_unit_test(test_same_show_same_pixels),
        cmocka_unit_test(test_bad_numbers_are_left_out),
    };
    return cmocka_run_group_tests_name("show", tests, set_up, tear_down);
}
