/* SPDX-License-Identifier: MIT */
/* Bars across contacts: which part of the width sticks and which slips. A bar is as long as the contact is wide, much
 * enlarged. Widths are Hertz's of the forces: 2a ~ sqrt(f_n R_star), spheres ~ cbrt(f_n R_star). */
#include "draw/frame_slip.h"

#include "draw/say.h"
#include "draw/stick.h"
#include "laws/law.h"
#include <math.h>

static double mean_radius(const tr_world *world) {
    double sum = 0;
    for (int i = 0; i < world->disks.n; i++) sum += world->disks.pos[tr_body(i) + TR_RADIUS];
    return world->disks.n ? sum / world->disks.n : 0;
}

/* Two disks of mean radius pressed with the mean force have a bar as long as their radius. */
static double half_width(const tr_world *world, const tr_record *r, double mean, double R) {
    double R_star = tr_law_R_star(r->R1, r->R2), load = r->f_n / mean * R_star / (0.5 * R);
    return 0.5 * R * fmin(world->shape == TR_SHAPE_SPHERE ? cbrt(load) : sqrt(load), 2.5);
}

/* From and to along t. */
static void add_bar(cairo_t *cr, tr_point p, tr_point t, double from, double to, double thick) {
    double nx = 0.5 * thick * t.y, ny = -0.5 * thick * t.x;
    if (!(to > from)) return;
    cairo_move_to(cr, p.x + from * t.x - nx, p.y + from * t.y - ny);
    cairo_line_to(cr, p.x + to * t.x - nx, p.y + to * t.y - ny);
    cairo_line_to(cr, p.x + to * t.x + nx, p.y + to * t.y + ny);
    cairo_line_to(cr, p.x + from * t.x + nx, p.y + from * t.y + ny);
    cairo_close_path(cr);
}

/* The slipping part, or the sticking part, of all contacts. */
static void add_bars(cairo_t *cr, const tr_view *view, const tr_map *map, double mean, bool slips, double thick) {
    const double R = mean_radius(view->world);
    for (int k = 0; k < tr_frame_images(view) * view->n_records; k++) {
        const tr_record *r = &view->record[k % view->n_records];
        tr_point p = tr_frame_point(map, r->x, r->y), t = {r->ny, r->nx}; /* pixels go down */
        p = tr_frame_image(view, map, p, k / view->n_records);
        double a = half_width(view->world, r, mean, R) * map->scale, stick[2];
        if (!(a > 0) || !isfinite(a) || !isfinite(t.x) || !isfinite(t.y) || !tr_frame_shown(view, map, p, a)) continue;
        tr_frame_stick(view->world, r, stick);
        if (!slips) {
            add_bar(cr, p, t, a * stick[0], a * stick[1], thick);
            continue;
        }
        add_bar(cr, p, t, -a, a * stick[0], thick);
        add_bar(cr, p, t, a * stick[1], a, thick);
    }
}

void tr_frame_slip(cairo_t *cr, const tr_view *view, const tr_map *map, double mean) {
    const double thick = 0.42 * map->scale * mean_radius(view->world);
    for (int slips = 0; slips < 2; slips++) { /* a white edge keeps bars apart */
        add_bars(cr, view, map, mean, slips, thick + 3);
        tr_pen_hue(cr, TR_WHITE);
        cairo_fill(cr);
    }
    for (int slips = 0; slips < 2; slips++) {
        add_bars(cr, view, map, mean, slips, thick);
        tr_pen_hue(cr, slips ? TR_SLIDES : TR_STICKS);
        cairo_fill(cr);
    }
}

const char *tr_frame_slip_limit(cairo_t *cr, const tr_view *view) {
    static const tr_word_key limit[] = {TR_WORD_slip_whole, TR_WORD_slip_cattaneo, TR_WORD_slip_carter};
    const tr_law *law = view->world->group[0].laws[TR_FRICTION].law;
    bool sphere = view->world->shape == TR_SHAPE_SPHERE; /* Carter's contact is a line */
    if (!law || !law->step) return "";
    return tr_say(cr, sphere && law->slip == TR_SLIPS_TRAILING ? TR_WORD_slip_steady : limit[law->slip]);
}

void tr_frame_slip_key(cairo_t *cr, const tr_view *view, double y) {
    static const struct {
        tr_word_key name;
        tr_hue hue;
    } part[] = {{TR_WORD_sticks, TR_STICKS}, {TR_WORD_slips, TR_SLIDES}};
    tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y, .size = 24, .room = TR_PANEL_W}, TR_SAY(cr, slip_width));
    for (int i = 0; i < 2; i++) {
        double x = TR_PANEL_X + i * TR_PANEL_W / 2.0;
        tr_pen_hue(cr, part[i].hue);
        cairo_rectangle(cr, x, y + 16, 48, 20);
        cairo_fill(cr);
        tr_pen_text(cr, (tr_text){.x = x + 60, .y = y + 34, .size = 24}, tr_say(cr, part[i].name));
    }
    tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y + 70, .size = 22, .room = TR_PANEL_W, .hue = TR_FAINT},
                tr_frame_slip_limit(cr, view));
}
