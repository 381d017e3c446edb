/* SPDX-License-Identifier: MIT */
/* The off-screen picture, its PNG file, and the recorded strokes of a later picture. A PNG of one IDAT is a zlib stream
 * between a few bytes: ISA-L makes the stream in a fifth of the time of libpng's zlib, because runs of one colour cost
 * nothing, and libpng writes it as a chunk. No filters: they would make edges between flat colours larger. */
#include "draw/canvas.h"

#include "base/alloc.h"
#include "base/temporary.h"
#include "base/vector.h"
#include "draw/font.h"
#include "draw/pen.h"
#include "draw/say.h"
#include <assert.h>
#include <errno.h>
#include <isa-l/igzip_lib.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool sound(const tr_canvas *canvas, tr_status *st) {
    cairo_status_t drawn = cairo_status(canvas->cr);
    return drawn == CAIRO_STATUS_SUCCESS ||
           tr_status_fail(st, TR_FILE, "error: cannot draw a picture: %s", cairo_status_to_string(drawn));
}

/* Takes the surface. */
static tr_canvas *on(cairo_surface_t *surface, const tr_canvas *like, tr_status *st) {
    tr_canvas *canvas = tr_alloc(1, sizeof *canvas, st);
    if (!canvas) return cairo_surface_destroy(surface), NULL;
    canvas->surface = surface;
    canvas->cr = cairo_create(surface);
    cairo_set_antialias(canvas->cr, CAIRO_ANTIALIAS_FAST);
    cairo_set_tolerance(canvas->cr, 0.25);
    /* grey, unhinted text: the user's screen settings must not change the pixels */
    cairo_font_options_t *font = cairo_font_options_create();
    cairo_font_options_set_antialias(font, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(font, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(font, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(canvas->cr, font);
    cairo_font_options_destroy(font);
    if (sound(canvas, st) && tr_font_give(canvas->cr, like ? like->cr : NULL, st)) return canvas;
    tr_canvas_free(canvas);
    return NULL;
}

void tr_canvas_speak(tr_canvas *canvas, int language) {
    tr_say_in(canvas->cr, (tr_language)language);
}

tr_canvas *tr_canvas_create(tr_status *st) {
    tr_canvas *canvas = on(cairo_image_surface_create(CAIRO_FORMAT_RGB24, TR_FRAME_WIDTH, TR_FRAME_HEIGHT), NULL, st);
    if (!canvas) return NULL;
    assert(cairo_image_surface_get_stride(canvas->surface) == 4 * TR_FRAME_WIDTH);
    return canvas;
}

tr_canvas *tr_canvas_record(const tr_canvas *like, tr_status *st) {
    const cairo_rectangle_t whole = {.width = TR_FRAME_WIDTH, .height = TR_FRAME_HEIGHT};
    return on(cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &whole), like, st);
}

void tr_canvas_free(tr_canvas *canvas) {
    if (!canvas) return;
    cairo_destroy(canvas->cr);
    cairo_surface_destroy(canvas->surface);
    free(canvas->png);
    free(canvas);
}

const unsigned char *tr_canvas_pixels(const tr_canvas *canvas) {
    cairo_surface_flush(canvas->surface);
    return cairo_image_surface_get_data(canvas->surface);
}

/* Rows in the form of PNG, each after its filter (0: none). */
enum { ROW = 1 + 3 * TR_FRAME_WIDTH, BYTES = ROW * TR_FRAME_HEIGHT };

TR_VECTOR static void set_rows(unsigned char *restrict to, const unsigned char *restrict pixel) {
    for (int y = 0; y < TR_FRAME_HEIGHT; y++, to += ROW, pixel += 4 * TR_FRAME_WIDTH) {
        to[0] = 0;
        for (int x = 0; x < TR_FRAME_WIDTH; x++)
            to[3 * x + 1] = pixel[4 * x + 2], to[3 * x + 2] = pixel[4 * x + 1], to[3 * x + 3] = pixel[4 * x];
    }
}

/* Buffers for encoding. The zlib stream grows at most by 5 bytes in each 65535, and by its ends. */
struct tr_png {
    struct isal_zstream stream;
    unsigned char rows[BYTES], packed[BYTES + BYTES / 1000 + 100], level[ISAL_DEF_LVL2_DEFAULT];
};

#ifdef __x86_64__
/* ISA-L leaves the upper halves of the vector registers in use. Until they are released, Cairo's SSE code takes a tenth
 * longer. */
__attribute__((target("avx"))) static void give_up_upper_halves(void) {
    __builtin_ia32_vzeroupper();
}
#endif

static bool compress(struct tr_png *png) {
    struct isal_zstream *z = &png->stream;
    isal_deflate_stateless_init(z);
    z->gzip_flag = IGZIP_ZLIB, z->end_of_stream = 1;
    z->level = 2, z->level_buf = png->level, z->level_buf_size = sizeof png->level;
    z->next_in = png->rows, z->avail_in = sizeof png->rows;
    z->next_out = png->packed, z->avail_out = sizeof png->packed;
    int code = isal_deflate_stateless(z);
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx")) give_up_upper_halves();
#endif
    return code == COMP_OK;
}

bool tr_canvas_encode(tr_canvas *canvas, tr_status *st) {
    if (!sound(canvas, st)) return false;
    if (!canvas->png) canvas->png = tr_alloc(1, sizeof *canvas->png, st);
    if (!canvas->png) return false;
    set_rows(canvas->png->rows, tr_canvas_pixels(canvas));
    return compress(canvas->png) || tr_status_fail(st, TR_FILE, "error: cannot compress a picture");
}

static void png_silent(png_structp png, png_const_charp message) {
    (void)png, (void)message;
}

static void png_leave(png_structp png, png_const_charp message) {
    (void)message;
    png_longjmp(png, 1);
}

static bool write_chunks(const tr_canvas *canvas, png_structp png, png_infop info, FILE *to) {
    if (!info || setjmp(png_jmpbuf(png))) return false;
    png_init_io(png, to);
    png_set_IHDR(png, info, TR_FRAME_WIDTH, TR_FRAME_HEIGHT, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
    png_write_info(png, info);
    png_write_chunk(png, (png_const_bytep) "IDAT", canvas->png->packed, canvas->png->stream.total_out);
    png_write_chunk(png, (png_const_bytep) "IEND", NULL, 0);
    return true;
}

/* Returns 0 or an errno. */
static int write_file(const tr_canvas *canvas, const char *path) {
    FILE *file = fopen(path, "wbe");
    if (!file) return errno;
    errno = 0;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, png_leave, png_silent);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    int error = write_chunks(canvas, png, info, file) ? 0 : errno ? errno : EIO;
    png_destroy_write_struct(&png, &info);
    if (fclose(file) != 0 && !error) error = errno;
    if (error) remove(path);
    return error;
}

bool tr_canvas_write(const tr_canvas *canvas, const char *path, tr_status *st) {
    char *part = tr_temporary_name(path, st);
    if (!part) return false;
    int error = write_file(canvas, part);
    bool ok = error ? tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", path, strerror(error))
                    : tr_temporary_rename(part, path, st);
    free(part);
    return ok;
}

bool tr_canvas_png(tr_canvas *canvas, const char *path, tr_status *st) {
    return tr_canvas_encode(canvas, st) && tr_canvas_write(canvas, path, st);
}

/* Replaces every pixel. */
static void put(tr_canvas *canvas, cairo_surface_t *picture) {
    cairo_save(canvas->cr);
    cairo_identity_matrix(canvas->cr);
    cairo_set_operator(canvas->cr, CAIRO_OPERATOR_SOURCE);
    cairo_set_source_surface(canvas->cr, picture, 0, 0);
    cairo_paint(canvas->cr);
    cairo_restore(canvas->cr);
}

bool tr_canvas_replay(tr_canvas *canvas, const tr_canvas *strokes, tr_status *st) {
    if (!sound(strokes, st)) return false;
    put(canvas, strokes->surface);
    return sound(canvas, st);
}

bool tr_canvas_load(tr_canvas *canvas, const char *path, tr_status *st) {
    cairo_surface_t *picture = cairo_image_surface_create_from_png(path);
    cairo_status_t read = cairo_surface_status(picture);
    put(canvas, picture);
    cairo_surface_destroy(picture);
    return read == CAIRO_STATUS_SUCCESS ||
           tr_status_fail(st, TR_FILE, "error: cannot read %s: %s", path, cairo_status_to_string(read));
}
