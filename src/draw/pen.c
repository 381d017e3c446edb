/* SPDX-License-Identifier: MIT */
/* Strokes and text on a Cairo surface. */
#include "draw/pen.h"

#include "draw/font.h"
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

void tr_pen_rgb(cairo_t *cr, tr_rgb c) {
    cairo_set_source_rgb(cr, c.r, c.g, c.b);
}

void tr_pen_hue(cairo_t *cr, unsigned hue) {
    tr_pen_rgb(cr, tr_palette_hue(hue));
}

/* Bytes of the UTF-8 character at s; 0 if there is none. */
static size_t utf8_bytes(const unsigned char *s) {
    static const unsigned least[] = {0, 0, 0x80, 0x800, 0x10000};
    size_t n = *s < 0x80 ? 1 : *s < 0xC0 ? 0 : *s < 0xE0 ? 2 : *s < 0xF0 ? 3 : *s < 0xF8 ? 4 : 0;
    unsigned code = n > 1 ? *s & (0x7Fu >> n) : 0;
    for (size_t k = 1; k < n; k++) {
        if ((s[k] & 0xC0) != 0x80) return 0;
        code = code << 6 | (s[k] & 0x3Fu);
    }
    bool valid = n < 2 || (code >= least[n] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF));
    return valid ? n : 0;
}

/* A title may be a file name of any bytes. After a string that is not UTF-8, Cairo draws nothing more. */
static void make_utf8(char *text) {
    for (size_t n; *text; text += n) {
        n = utf8_bytes((const unsigned char *)text);
        if (!n) *text = '?', n = 1;
    }
}

static size_t character_bytes(const char *s) {
    size_t n = 1;
    while (((unsigned char)s[n] & 0xC0) == 0x80) n++;
    return n;
}

/* A word of ASCII letters and digits is lowered as a whole, "R_eq"; of what else there is, one character. */
static size_t lowered_bytes(const char *s) {
    size_t n = strspn(s, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789");
    return n ? n : character_bytes(s);
}

typedef enum tr_ink { INK_NONE, INK_RIM, INK_FULL } tr_ink;

/* Walks the runs of plain and lowered text; draws them when asked. Returns the width. */
static double set_text(cairo_t *cr, double x, double y, double size, const char *text, tr_ink ink) {
    const double start = x;
    while (*text) {
        bool low = *text == '_' && text[1];
        if (low) text++;
        size_t n = low ? lowered_bytes(text) : 1 + strcspn(text + 1, "_");
        char run[128];
        if (n >= sizeof run) {
            n = sizeof run - 1;
            while (((unsigned char)text[n] & 0xC0) == 0x80) n--;
        }
        memcpy(run, text, n);
        run[n] = 0;
        text += n;
        cairo_set_font_size(cr, low ? 0.72 * size : size);
        cairo_move_to(cr, x, low ? y + 0.18 * size : y);
        if (ink == INK_FULL) cairo_show_text(cr, run);
        if (ink == INK_RIM) {
            cairo_text_path(cr, run);
            cairo_set_line_width(cr, 0.24 * size);
            cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
            cairo_stroke(cr);
            cairo_set_line_join(cr, CAIRO_LINE_JOIN_MITER);
        }
        cairo_text_extents_t e;
        cairo_text_extents(cr, run, &e);
        x += e.x_advance;
    }
    return x - start;
}

double tr_pen_width(cairo_t *cr, tr_text at, const char *given) {
    char text[512];
    snprintf(text, sizeof text, "%s", given);
    make_utf8(text);
    tr_font_choose(cr, at.bold);
    double width = set_text(cr, 0, 0, at.size, text, INK_NONE);
    cairo_new_path(cr);
    return width;
}

double tr_pen_text(cairo_t *cr, tr_text at, const char *given) {
    char text[512];
    snprintf(text, sizeof text, "%s", given);
    make_utf8(text);
    double width = tr_pen_width(cr, at, text);
    if (at.room > 0 && width > at.room) {
        at.size *= at.room / width;
        width = at.room;
    }
    at.x -= width * at.align / 2;
    if (at.halo) {
        tr_pen_hue(cr, TR_WHITE);
        set_text(cr, at.x, at.y, at.size, text, INK_RIM);
    }
    tr_pen_hue(cr, at.hue ? at.hue : TR_INK);
    set_text(cr, at.x, at.y, at.size, text, INK_FULL);
    cairo_new_path(cr); /* show_text leaves a point behind */
    return width;
}

/* Bytes of text that fit into one line; at least a word. */
static size_t line_bytes(cairo_t *cr, tr_text at, const char *text) {
    char line[512];
    size_t taken = 0;
    for (size_t n = strcspn(text, " ");; n += 1 + strcspn(text + n + 1, " ")) {
        if (n >= sizeof line) return taken ? taken : strlen(text);
        snprintf(line, sizeof line, "%.*s", (int)n, text);
        if (taken && tr_pen_width(cr, at, line) > at.room) return taken;
        taken = n;
        if (!text[n]) return taken;
    }
}

double tr_pen_paragraph(cairo_t *cr, tr_text at, int n_lines, const char *text, bool draw) {
    enum { MOST = 4 };
    size_t start[MOST] = {0}, bytes[MOST] = {0};
    int n = 0;
    for (; at.size > 8; at.size -= 1) {
        size_t done = 0;
        for (n = 0; n < n_lines && n < MOST && text[done]; n++) {
            start[n] = done, bytes[n] = line_bytes(cr, at, text + done);
            done += bytes[n];
            done += strspn(text + done, " ");
        }
        if (!text[done]) break;
    }
    for (int i = 0; i < n && draw; i++) {
        char line[512];
        snprintf(line, sizeof line, "%.*s", (int)bytes[i], text + start[i]);
        tr_pen_text(cr, at, line);
        at.y += 1.25 * at.size;
    }
    return 1.25 * at.size * n;
}

void tr_pen_verdict(cairo_t *cr, tr_point at, double size, bool right) {
    static const double cross[][2] = {{-0.33, -0.05}, {0.33, -0.71}, {-0.33, -0.71}, {0.33, -0.05}},
                        tick[][2] = {{-0.36, -0.35}, {-0.1, -0.06}, {-0.1, -0.06}, {0.36, -0.74}};
    const double(*p)[2] = right ? tick : cross;
    tr_pen_hue(cr, right ? TR_GREEN : TR_INK);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    for (int i = 0; i < 4; i += 2)
        tr_pen_line(cr, (tr_point){at.x + size * p[i][0], at.y + size * p[i][1]},
                    (tr_point){at.x + size * p[i + 1][0], at.y + size * p[i + 1][1]}, 0.2 * size);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
}

void tr_pen_line(cairo_t *cr, tr_point from, tr_point to, double width) {
    cairo_set_line_width(cr, width);
    cairo_move_to(cr, from.x, from.y);
    cairo_line_to(cr, to.x, to.y);
    cairo_stroke(cr);
}

void tr_pen_add_disk(cairo_t *cr, tr_point at, double radius) {
    cairo_new_sub_path(cr);
    cairo_arc(cr, at.x, at.y, radius, 0, 2 * M_PI);
    cairo_close_path(cr);
}

void tr_pen_dot(cairo_t *cr, tr_point at, double radius) {
    tr_pen_add_disk(cr, at, radius);
    cairo_fill(cr);
}

static double head_length(double width) {
    return 3 * width + 4;
}

/* A triangle with its point at `tip`, looking along the unit vector u. */
static void fill_head(cairo_t *cr, tr_point tip, tr_point u, double width) {
    double l = head_length(width), h = 0.5 * l;
    cairo_move_to(cr, tip.x, tip.y);
    cairo_line_to(cr, tip.x - l * u.x - h * u.y, tip.y - l * u.y + h * u.x);
    cairo_line_to(cr, tip.x - l * u.x + h * u.y, tip.y - l * u.y - h * u.x);
    cairo_close_path(cr);
    cairo_fill(cr);
}

void tr_pen_arrow(cairo_t *cr, tr_point from, tr_point to, double width) {
    double dx = to.x - from.x, dy = to.y - from.y, length = hypot(dx, dy), head = head_length(width);
    if (!(length > 0.5 * head)) return;
    tr_point u = {dx / length, dy / length};
    if (length > head) tr_pen_line(cr, from, (tr_point){to.x - 0.9 * head * u.x, to.y - 0.9 * head * u.y}, width);
    fill_head(cr, to, u, width);
}

void tr_pen_arc(cairo_t *cr, tr_point c, double radius, double from, double sweep, double width, bool head) {
    if (!(radius > 0) || sweep == 0) return;
    double sign = sweep > 0 ? 1 : -1;
    if (head) {
        /* the shaft stops inside the head, and the point of the head ends the sweep; an arc shorter than a head is not
         * drawn */
        double back = 0.85 * head_length(width) / radius, a = from + sweep;
        if (fabs(sweep) < back) return;
        sweep -= sign * back;
        double mid = a - 0.5 * sign * back; /* the chord of a bent head looks right, the tangent does not */
        fill_head(cr, (tr_point){c.x + radius * cos(a), c.y - radius * sin(a)},
                  (tr_point){-sign * sin(mid), -sign * cos(mid)}, width);
    }
    cairo_set_line_width(cr, width);
    cairo_new_sub_path(cr);
    /* the picture's y points down, so angles change sign and with them the direction */
    if (sweep > 0)
        cairo_arc_negative(cr, c.x, c.y, radius, -from, -(from + sweep));
    else
        cairo_arc(cr, c.x, c.y, radius, -from, -(from + sweep));
    cairo_stroke(cr);
}
