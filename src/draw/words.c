/* SPDX-License-Identifier: MIT */
#include "draw/words.h"

#include <stdio.h>
#include <string.h>

#define W(key, text) [TR_WORD_##key] = (text),
static const char *const words[TR_N_LANGUAGES][TR_N_WORDS] = {[TR_EN] =
                                                                  {
#include "draw/words_en.h"
                                                                  },
                                                              [TR_DE] = {
#include "draw/words_de.h"
                                                              }};
#undef W

const char *tr_words_of(tr_language language, tr_word_key key) {
    return words[language][key];
}

void tr_words_fill(char *text, size_t size, const char *with, const char *first, const char *second) {
    const char *one = strstr(with, "%s"), *two = one ? strstr(one + 2, "%s") : NULL;
    if (!one)
        snprintf(text, size, "%s", with);
    else if (!two)
        snprintf(text, size, "%.*s%s%s", (int)(one - with), with, first, one + 2);
    else
        snprintf(text, size, "%.*s%s%.*s%s%s", (int)(one - with), with, first, (int)(two - one - 2), one + 2, second,
                 two + 2);
}
