/* SPDX-License-Identifier: MIT */
/* Everything here must work for any bytes: this code reports errors in garbage. */
#include "scene/text.h"
#include "base/alloc.h"

#include <errno.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SIZE = 1 << 20, MAX_WORD = 40, BAD_BYTE = -1 };

/* Code point at p, and its length in bytes; BAD_BYTE and 1 where the bytes are not UTF-8. n > 0 bytes are there. */
static int32_t decode(const char *p, size_t n, size_t *length) {
    static const int32_t least[] = {0, 0, 0x80, 0x800, 0x10000}; /* shorter codes must not be written longer */
    unsigned char c = (unsigned char)*p;
    *length = 1;
    if (c < 0x80) return c;
    size_t len = c >= 0xf0 && c < 0xf8 ? 4 : c >= 0xe0 ? 3 : 2;
    if (c < 0xc0 || c >= 0xf8 || len > n) return BAD_BYTE;
    int32_t code = c & (0x7f >> len);
    for (size_t i = 1; i < len; i++) {
        if (((unsigned char)p[i] & 0xc0) != 0x80) return BAD_BYTE;
        code = code << 6 | (p[i] & 0x3f);
    }
    if (code < least[len] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return BAD_BYTE;
    *length = len;
    return code;
}

/* May stand in a line of a case. YAML takes U+0085, U+2028 and U+2029 for line ends, but editors do not: they are
 * refused.
 */
static bool printable(int32_t c) {
    return c >= 0x20 && !(c >= 0x7f && c < 0xa0) && c != 0x2028 && c != 0x2029 && c != 0xfeff && (c & 0xfffe) != 0xfffe;
}

char *tr_text_file(const char *path, size_t *size, tr_status *st) {
    const size_t room = MAX_SIZE + 8;
    char *text = tr_alloc(room, 1, st);
    FILE *file = text ? fopen(path, "rb") : NULL;
    *size = file ? fread(text, 1, room, file) : 0;
    bool ok = file && !ferror(file);
    if (!ok) tr_status_fail(st, TR_FILE, "error: cannot %s %.300s: %s", file ? "read" : "open", path, strerror(errno));
    if (file) fclose(file);
    if (ok) return text;
    free(text);
    return NULL;
}

tr_shown tr_text_show(const char *text) {
    tr_shown shown = {{0}};
    size_t left = strlen(text), length, used = 0;
    for (int i = 0; left && used < 48; i++, text += length, left -= length) {
        int32_t c = decode(text, left, &length);
        if (i == MAX_WORD) break;
        if (printable(c))
            memcpy(shown.text + used, text, length), used += length;
        else
            used += (size_t)sprintf(shown.text + used, c < 0x80 ? "\\x%02x" : "\\u%04x",
                                    (unsigned)(c < 0 ? *text & 0xff : c));
    }
    if (left) strcpy(shown.text + used, "...");
    return shown;
}

/* Start of line number `line` (from 1). */
static const char *line_start(const tr_source *source, int line) {
    const char *p = source->text, *end = p + source->size;
    for (; line > 1 && p < end; p++) {
        if (*p == '\n' || (*p == '\r' && !(p + 1 < end && p[1] == '\n'))) line--;
    }
    return p;
}

/* The line around the mark, and a caret line. room: bytes in line, enough for BEFORE characters of 4 bytes. */
static void show_line(tr_mark at, char *line, size_t room, char *caret) {
    enum { BEFORE = 70, WIDTH = 100 };
    const char *p = line_start(at.source, at.line), *end = at.source->text + at.source->size;
    int from = at.column > BEFORE ? at.column - BEFORE : 1;
    size_t length, used = 0, spaces = 0;
    for (int column = 1; p < end && *p != '\n' && *p != '\r' && column < from + WIDTH; column++, p += length) {
        int32_t c = decode(p, (size_t)(end - p), &length);
        if (column < from) continue;
        if (used + length + 1 > room) break;
        if (column < at.column) spaces++;
        if (printable(c))
            memcpy(line + used, p, length), used += length;
        else
            line[used++] = c == '\t' ? ' ' : '?';
    }
    line[used] = '\0';
    memset(caret, ' ', spaces);
    strcpy(caret + spaces, "^");
}

bool tr_text_fail(tr_status *st, tr_mark at, const char *format, ...) {
    char what[400], line[300], caret[110], name[128]; /* together they fit the status */
    va_list args;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    show_line(at, line, sizeof line, caret);
    size_t n = 0;
    for (const char *p = at.source->name; *p && n + 1 < sizeof name; p++)
        name[n++] = (unsigned char)*p < 0x20 ? '?' : *p;
    name[n] = '\0';
    return tr_status_fail(st, TR_BAD_CASE, "%s:%d:%d: error: %s\n%s\n%s", name, at.line, at.column, what, line, caret);
}

/* Reads one character at *p and moves p and the mark behind it. */
static int32_t next(const char **p, tr_mark *at) {
    const char *end = at->source->text + at->source->size;
    size_t length;
    int32_t c = decode(*p, (size_t)(end - *p), &length);
    *p += length;
    at->column++;
    if (c == '\n' || (c == '\r' && !(*p < end && **p == '\n'))) at->line++, at->column = 1;
    return c;
}

bool tr_text_check(const tr_source *source, tr_status *st) {
    tr_mark at = {source, 1, 1}, here;
    if (source->size > MAX_SIZE) return tr_text_fail(st, at, "the text is longer than 1 MB; a case is a few kB");
    for (const char *p = source->text, *end = p + source->size; p < end;) {
        here = at;
        int byte = *p & 0xff, c = next(&p, &at);
        if (c == '\t') return tr_text_fail(st, here, "tabs are not allowed; use spaces");
        if (c == BAD_BYTE) return tr_text_fail(st, here, "byte 0x%02x is not UTF-8; a case is a text file", byte);
        if (!printable(c) && c != '\n' && c != '\r')
            return tr_text_fail(st, here, "character U+%04X is not allowed; a case is a text file", (unsigned)c);
    }
    return true;
}

size_t tr_text_line(const char *text, char *line, size_t room) {
    size_t used = 0, left = strlen(text), length;
    bool gap = false;
    for (; left; text += length, left -= length) {
        int32_t c = decode(text, left, &length);
        bool white = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (!white && !printable(c)) return 0; /* YAML's \x07 makes them after tr_text_check */
        if (!white) {
            gap = gap && used;
            if (used + gap + length < room) {
                if (gap) line[used] = ' ';
                memcpy(line + used + gap, text, length);
            }
            used += gap + length;
        }
        gap = white;
    }
    if (used < room) line[used] = '\0';
    return used + 1;
}

tr_mark tr_text_end(const tr_source *source) {
    tr_mark at = {source, 1, 1}, last = at;
    for (const char *p = source->text, *end = p + source->size; p < end;) {
        if (next(&p, &at) > ' ') last = at;
    }
    return last;
}

/* Number of letters to insert, drop, change, or swap with the next (optimal string alignment). */
static int distance(const char *a, const char *b) {
    int na = (int)strlen(a), nb = (int)strlen(b), d[3][MAX_WORD + 1];
    if (na > MAX_WORD || nb > MAX_WORD) return MAX_WORD;
    for (int i = 0; i <= na; i++) {
        int *row = d[i % 3], *up = d[(i + 2) % 3], *up2 = d[(i + 1) % 3];
        for (int j = 0; j <= nb; j++) {
            row[j] = i == 0 ? j : j == 0 ? i : up[j - 1] + (a[i - 1] != b[j - 1]);
            if (i && j && up[j] + 1 < row[j]) row[j] = up[j] + 1;
            if (i && j && row[j - 1] + 1 < row[j]) row[j] = row[j - 1] + 1;
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && up2[j - 2] + 1 < row[j])
                row[j] = up2[j - 2] + 1;
        }
    }
    return d[na % 3][nb];
}

void tr_text_nearer(tr_near *best, const char *wanted, const char *candidate) {
    int d = distance(wanted, candidate), longest = (int)strlen(candidate);
    if (d <= (longest + 1) / 3 && (!best->word || d < best->distance)) *best = (tr_near){candidate, d};
}

tr_shown tr_text_hint(const tr_near *best) {
    tr_shown hint = {{0}};
    if (best->word) snprintf(hint.text, sizeof hint.text, " (did you mean `%.40s`?)", best->word);
    return hint;
}
