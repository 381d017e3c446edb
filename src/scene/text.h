/* SPDX-License-Identifier: MIT */
/* Text from a user: the place of a character, whether the text may be read, and how a message shows it. */
#ifndef TR_TEXT_H
#define TR_TEXT_H

#include "base/status.h"
#include <stddef.h>

/* A file's bytes, or the text of one --set. Outlives every mark in it. */
typedef struct tr_source {
    const char *name, *text;
    size_t size;
} tr_source;

/* A place in a source: line and column count from 1, columns count characters. */
typedef struct tr_mark {
    const tr_source *source;
    int line, column;
} tr_mark;

/* The bytes of a file up to the limit and a little more, so that a file that is too long is noticed. NULL and TR_FILE:
 * cannot open or read it. free(). */
char *tr_text_file(const char *path, size_t *size, tr_status *st);

/* A piece of text fit for a message: short, one line, nothing that a terminal would obey. */
typedef struct tr_shown {
    char text[64];
} tr_shown;

/* Cut to about 40 characters, control characters as \xNN. Use as tr_text_show(s).text inside one call. */
tr_shown tr_text_show(const char *text);

/* Fails with TR_BAD_CASE and "name:line:column: error: <format>", the source line (about 100 characters around the
 * column) and a caret under the column. Returns false. */
bool tr_text_fail(tr_status *st, tr_mark at, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* The source is at most 1 MB of UTF-8 without tabs, NUL and other control characters; line ends are \n, \r\n or \r. */
bool tr_text_check(const tr_source *source, tr_status *st);

/* Text as one line: no white space at its ends, one space for each run of it inside. Returns the bytes that it takes
 * with its NUL, and fills line if they fit into room; 0: a character is not allowed in a case. */
size_t tr_text_line(const char *text, char *line, size_t room);

/* The place after the last visible character of a source: messages about missing text point there. */
tr_mark tr_text_end(const tr_source *source);

/* "Did you mean": the closest of the candidates offered so far; word is NULL while no candidate is close. */
typedef struct tr_near {
    const char *word;
    int distance;
} tr_near;

void tr_text_nearer(tr_near *best, const char *wanted, const char *candidate);
tr_shown tr_text_hint(const tr_near *best); /* " (did you mean `word`?)" or "" */

#endif
