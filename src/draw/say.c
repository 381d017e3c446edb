/* SPDX-License-Identifier: MIT */
#include "draw/say.h"

#include <stdint.h>

static const cairo_user_data_key_t of_context;

void tr_say_in(cairo_t *cr, tr_language language) {
    cairo_set_user_data(cr, &of_context, (void *)(uintptr_t)language, NULL);
}

tr_language tr_say_language(cairo_t *cr) {
    return (tr_language)(uintptr_t)cairo_get_user_data(cr, &of_context);
}

const char *tr_say(cairo_t *cr, tr_word_key key) {
    return tr_words_of(tr_say_language(cr), key);
}
