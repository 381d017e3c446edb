/* SPDX-License-Identifier: MIT */
#include "study/picture.h"
#include "base/math.h"

#include "draw/canvas.h"
#include "draw/field.h"
#include "draw/frame_show.h"
#include "draw/palette.h"
#include "scene/what.h"
#include "study/film.h"
#include "study/shown_check.h"

#include <math.h>
#include <string.h>

tr_view_box tr_picture_empty(void) {
    return (tr_view_box){.x0 = INFINITY, .y0 = INFINITY, .x1 = -INFINITY, .y1 = -INFINITY};
}

static void widen(double *low, double *high, double value) {
    if (value == value) *low = fmin(*low, value), *high = fmax(*high, value);
}

void tr_picture_widen(tr_view_box *v, const tr_play *p) {
    const tr_world *world = &p->b.world;
    double tilt = tr_play_tilt(p), c = tr_cos(tilt), n = tr_sin(tilt);
    for (int i = 0; i < world->disks.n; i++) {
        const double *q = world->disks.pos + tr_body(i);
        double x = q[0] * c - q[1] * n, y = q[0] * n + q[1] * c, R = i < world->n_rings ? world->disks.outer[i] : q[3];
        widen(&v->x0, &v->x1, x - R), widen(&v->x0, &v->x1, x + R);
        widen(&v->y0, &v->y1, y - R), widen(&v->y0, &v->y1, y + R);
    }
    for (int i = 0; i < world->disks.n; i++) { /* a thread is as long as its disk is wide, and a little more */
        const tr_scene_pull *pull = &p->scene->disks[i].pull;
        const double *q = world->disks.pos + tr_body(i), way = (pull->force < 0 ? -2.6 : 2.6) * fabs(q[3]);
        double x = q[0] + way * tr_cos(pull->angle), y = q[1] + way * tr_sin(pull->angle);
        if (!pull->given) continue;
        widen(&v->x0, &v->x1, x * c - y * n), widen(&v->y0, &v->y1, x * n + y * c);
    }
    v->range = fmax(v->range, tr_frame_range_bodies(world, p->records, p->n_records));
}

/* If a closed form gives a time, the curves have a mark. */
static double mark_of(const tr_scene *scene) {
    for (int k = 0; k < scene->n_checks; k++) {
        const tr_what_row *what = &tr_whats[scene->checks[k].what];
        if (what->when == TR_EVENT && strcmp(what->unit, "s") == 0) return scene->checks[k].exact;
    }
    return NAN;
}

static tr_chart chart_of(const tr_cast *s, const tr_view_box *view) {
    static const struct {
        const char *name[2], *unit;
        unsigned hue[2];
    } curve[] = {[TR_CURVE_SPEED] = {{"speed", NULL}, "m/s", {0}},
                 [TR_CURVE_VELOCITIES] = {{"V_s", "V_r"}, "m/s", {TR_SLIDES, TR_ROLLS}},
                 [TR_CURVE_CREEPAGE] = {{"creepage", NULL}, "1", {0}},
                 [TR_CURVE_SPIN] = {{"spin", NULL}, "rad/s", {0}}};
    int k = s->scene->output.curve;
    tr_chart chart = {.name = {curve[k].name[0], curve[k].name[1]},
                      .hue = {curve[k].hue[0], curve[k].hue[1]},
                      .unit = curve[k].unit,
                      .bottom = view->bottom,
                      .top = view->top,
                      .n = s->play[0]->n,
                      .time = s->play[0]->time};
    for (int i = 0; i < s->n; i++) {
        for (int j = 0; j < 2; j++) chart.value[i][j] = curve[k].name[j] ? s->play[i]->value[j] : NULL;
        chart.mark[i] = mark_of(s->play[i]->scene);
        if (s->play[i]->n < chart.n) chart.n = s->play[i]->n;
    }
    return chart;
}

static const char *or_null(const char *text) {
    return *text ? text : NULL;
}

static void settle_curves(tr_view_box *view, const tr_cast *s) {
    view->bottom = view->top = 0;
    for (int i = 0; i < s->n; i++)
        for (int j = 0; j < 2; j++)
            for (int k = 0; k < s->play[i]->n; k++) widen(&view->bottom, &view->top, s->play[i]->value[j][k]);
    if (s->scene->output.curve == TR_CURVE_CREEPAGE) view->top = 0;
    for (int i = 0; i < s->n; i++) view->top = fmax(view->top, s->play[i]->creepage);
    double margin = 0.05 * (view->top - view->bottom);
    view->top += margin, view->bottom -= view->bottom < 0 ? margin : 0;
}

void tr_picture_settle(tr_view_box *view, const tr_cast *s) {
    settle_curves(view, s);
    double margin = 0.08 * fmax(view->x1 - view->x0, view->y1 - view->y0);
    view->x0 -= margin, view->x1 += margin, view->y0 -= margin, view->y1 += margin;
}

void tr_picture_draw(tr_canvas *canvas, const tr_cast *s, const tr_view_box *view, const tr_check_result *result,
                     int n_results) {
    const tr_scene_lesson *lesson = &s->scene->lesson;
    tr_show_lane lane[TR_MAX_LANES];
    for (int i = 0; i < s->n; i++) {
        lane[i] = tr_play_lane(s->play[i]);
        lane[i].x0 = view->x0, lane[i].x1 = view->x1, lane[i].y0 = view->y0, lane[i].y1 = view->y1;
    }
    tr_chart chart = s->scene->output.curve ? chart_of(s, view) : (tr_chart){0};
    tr_show_check check[TR_MAX_LANES * TR_MAX_CHECKS];
    int n_checks = 0;
    for (int i = 0; i < n_results; i++) {
        check[n_checks++] = tr_run_shown_check(&result[i], s->scene, s->n > 1);
    }
    tr_canvas_speak(canvas, s->scene->language);
    const tr_show picture = {.expert = s->scene->output.view == TR_VIEW_EXPERT,
                             .title = *lesson->title ? lesson->title : s->title,
                             .equation = or_null(lesson->equation),
                             .time = tr_play_time(s->play[s->leader]),
                             .time_end = s->scene->time_end,
                             .slower = tr_film_seconds(s->scene->output.frames) / s->scene->time_end,
                             .range = view->range,
                             .lane = lane,
                             .n_lanes = s->n,
                             .chart = s->scene->output.curve ? &chart : NULL,
                             .caption = result ? lesson->sentence : NULL,
                             .check = check,
                             .n_checks = n_checks};
    tr_draw_show(canvas, &picture);
}
