/* SPDX-License-Identifier: MIT */
/* The words of pictures and page: one file per language. */
#ifndef TR_WORDS_H
#define TR_WORDS_H

#include <stddef.h>

typedef enum tr_word_key {
#define W(key, text) TR_WORD_##key,
#include "draw/words_en.h"
#undef W
    TR_N_WORDS
} tr_word_key;

/* In the order of the choices of the scene's `language:`. */
typedef enum tr_language { TR_EN, TR_DE, TR_N_LANGUAGES } tr_language;

/* NULL: the language has no such word, which a test does not let pass. */
const char *tr_words_of(tr_language language, tr_word_key key);

/* A text with its first %s, or its first two, filled in. */
void tr_words_fill(char *text, size_t size, const char *with, const char *first, const char *second);

#endif
