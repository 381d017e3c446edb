/* SPDX-License-Identifier: MIT */
/* The off-screen picture and its PNG file. libpng is called directly, with little compression and no filters: a fourth
 * of the time of Cairo's own writer. */
#include "base/alloc.h"
#include "draw/draw.h"
#include "base/part.h"
#include "draw/pen.h"
#include <assert.h>
#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

tr_canvas *tr_canvas_create(tr_status *st) {
    tr_canvas *canvas = tr_alloc(1, sizeof *canvas, st);
    if (!canvas) return NULL;
    canvas->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, TR_FRAME_WIDTH, TR_FRAME_HEIGHT);
    canvas->cr = cairo_create(canvas->surface);
    if (cairo_status(canvas->cr) != CAIRO_STATUS_SUCCESS) {
        tr_status_fail(st, TR_FILE, "error: no canvas: %s", cairo_status_to_string(cairo_status(canvas->cr)));
        tr_canvas_free(canvas);
        return NULL;
    }
    assert(cairo_image_surface_get_stride(canvas->surface) == 4 * TR_FRAME_WIDTH);
    cairo_set_antialias(canvas->cr, CAIRO_ANTIALIAS_FAST);
    cairo_set_tolerance(canvas->cr, 0.25);
    /* grey, unhinted text: the user's screen settings must not change the pixels */
    cairo_font_options_t *font = cairo_font_options_create();
    cairo_font_options_set_antialias(font, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(font, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(font, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(canvas->cr, font);
    cairo_font_options_destroy(font);
    return canvas;
}

void tr_canvas_free(tr_canvas *canvas) {
    if (!canvas) return;
    cairo_destroy(canvas->cr);
    cairo_surface_destroy(canvas->surface);
    free(canvas);
}

const unsigned char *tr_canvas_pixels(const tr_canvas *canvas) {
    cairo_surface_flush(canvas->surface);
    return cairo_image_surface_get_data(canvas->surface);
}

/* The file and its first error: libpng would forget errno on its way out. */
typedef struct tr_png_file {
    FILE *file;
    int error;
} tr_png_file;

static void sink_write(png_structp png, png_bytep bytes, size_t n) {
    tr_png_file *sink = png_get_io_ptr(png);
    if (fwrite(bytes, 1, n, sink->file) == n) return;
    sink->error = errno ? errno : EIO;
    png_error(png, "write");
}

static void sink_flush(png_structp png) {
    (void)png;
}

static void png_silent(png_structp png, png_const_charp message) {
    (void)png, (void)message;
}

static void png_leave(png_structp png, png_const_charp message) {
    (void)message;
    png_longjmp(png, 1);
}

static bool encode(png_structp png, png_infop info, const unsigned char *pixels, tr_png_file *sink) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, sink, sink_write, sink_flush);
    png_set_IHDR(png, info, TR_FRAME_WIDTH, TR_FRAME_HEIGHT, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_write_info(png, info);
    png_set_bgr(png);
    png_set_filler(png, 0, PNG_FILLER_AFTER);
    for (int y = 0; y < TR_FRAME_HEIGHT; y++) png_write_row(png, pixels + (size_t)y * 4 * TR_FRAME_WIDTH);
    png_write_end(png, NULL);
    return true;
}

/* Returns 0 or an errno. */
static int write_png(const tr_canvas *canvas, const char *path) {
    tr_png_file sink = {.file = fopen(path, "wbe")};
    if (!sink.file) return errno;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, png_leave, png_silent);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    errno = 0;
    if (!info || !encode(png, info, tr_canvas_pixels(canvas), &sink)) {
        if (!sink.error) sink.error = ENOMEM;
    }
    png_destroy_write_struct(&png, &info);
    if (fclose(sink.file) != 0 && !sink.error) sink.error = errno;
    if (sink.error) remove(path);
    return sink.error;
}

bool tr_canvas_png(const tr_canvas *canvas, const char *path, tr_status *st) {
    cairo_status_t drawn = cairo_status(canvas->cr);
    if (drawn != CAIRO_STATUS_SUCCESS)
        return tr_status_fail(st, TR_FILE, "error: cannot draw %s: %s", path, cairo_status_to_string(drawn));
    char *part = tr_part_name(path, st);
    if (!part) return false;
    int error = write_png(canvas, part);
    bool ok = error ? tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", path, strerror(error))
                    : tr_part_keep(part, path, st);
    free(part);
    return ok;
}

bool tr_canvas_load(tr_canvas *canvas, const char *path, tr_status *st) {
    cairo_surface_t *picture = cairo_image_surface_create_from_png(path);
    cairo_status_t read = cairo_surface_status(picture);
    cairo_save(canvas->cr);
    cairo_identity_matrix(canvas->cr);
    cairo_set_operator(canvas->cr, CAIRO_OPERATOR_SOURCE);
    cairo_set_source_surface(canvas->cr, picture, 0, 0);
    cairo_paint(canvas->cr);
    cairo_restore(canvas->cr);
    cairo_surface_destroy(picture);
    return read == CAIRO_STATUS_SUCCESS ||
           tr_status_fail(st, TR_FILE, "error: cannot read %s: %s", path, cairo_status_to_string(read));
}
