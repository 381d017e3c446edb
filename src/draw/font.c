/* SPDX-License-Identifier: MIT */
#include "draw/font.h"

#include "base/alloc.h"
#include <cairo-ft.h>
#include <stdlib.h>

static const char *const files[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"};
enum { N_FILES = sizeof files / sizeof *files };
static const cairo_user_data_key_t of_context[N_FILES], of_face;

/* FreeType's data of a face. Each face has its own, because FreeType allows one thread at a time. */
typedef struct source {
    FT_Library library;
    FT_Face file;
} source;

static void close_source(void *context) {
    source *s = context;
    if (s->file) FT_Done_Face(s->file);
    if (s->library) FT_Done_FreeType(s->library);
    free(s);
}

static void release(void *face) {
    cairo_font_face_destroy(face);
}

/* NULL without a failure: no such file. */
static cairo_font_face_t *load(const char *file, tr_status *st) {
    source *s = tr_alloc(1, sizeof *s, st);
    if (!s) return NULL;
    FT_Error error = FT_Init_FreeType(&s->library);
    if (!error) error = FT_New_Face(s->library, file, 0, &s->file);
    if (error) {
        if (error != FT_Err_Cannot_Open_Resource)
            tr_status_fail(st, TR_FILE, "error: cannot read the font %s: FreeType's error %d", file, error);
        return close_source(s), NULL;
    }
    cairo_font_face_t *face = cairo_ft_font_face_create_for_ft_face(s->file, 0);
    if (cairo_font_face_set_user_data(face, &of_face, s, close_source)) {
        tr_status_fail(st, TR_FILE, "error: out of memory (font)");
        return cairo_font_face_destroy(face), close_source(s), NULL;
    }
    return face;
}

bool tr_font_give(cairo_t *cr, cairo_t *like, tr_status *st) {
    for (int k = 0; k < N_FILES; k++) {
        cairo_font_face_t *face = like ? cairo_get_user_data(like, &of_context[k]) : load(files[k], st);
        if (st->code) return false;
        if (!face) continue;
        if (like) cairo_font_face_reference(face);
        if (!cairo_set_user_data(cr, &of_context[k], face, release)) continue;
        cairo_font_face_destroy(face);
        return tr_status_fail(st, TR_FILE, "error: out of memory (font)");
    }
    return true;
}

void tr_font_choose(cairo_t *cr, bool bold) {
    cairo_font_face_t *face = cairo_get_user_data(cr, &of_context[bold]);
    if (face)
        cairo_set_font_face(cr, face);
    else
        cairo_select_font_face(cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                               bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
}
