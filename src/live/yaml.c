/* SPDX-License-Identifier: MIT */
/* Reads the whole text at the first call, by recursive descent, into a list of events. */
#include "live/yaml.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_DEPTH = 64 };

typedef yaml_parser_t parser;

static bool node(parser *p, int indent);
static bool flow(parser *p);

static bool fail(parser *p, const char *problem) {
    if (p->error) return false;
    p->error = YAML_PARSER_ERROR, p->problem = problem, p->problem_mark = p->mark;
    return false;
}

static int peek(const parser *p, int ahead) {
    return p->end - p->at > ahead ? (unsigned char)p->at[ahead] : 0;
}

static void advance(parser *p) {
    int c = (unsigned char)*p->at++;
    if (c == '\n')
        p->mark.line++, p->mark.column = 0;
    else if ((c & 0xC0) != 0x80)
        p->mark.column++;
}

static bool blank(int c) {
    return c == ' ' || c == '\n' || c == '\r' || c == 0;
}

static void skip_line(parser *p) {
    while (p->at < p->end && *p->at != '\n') advance(p);
}

/* To what comes next, over comments and ends of lines. */
static void skip(parser *p) {
    while (p->at < p->end) {
        int c = peek(p, 0);
        if (c == '#' && (p->at == p->text || blank(p->at[-1])))
            skip_line(p);
        else if (c == ' ' || c == '\n' || c == '\r')
            advance(p);
        else
            break;
    }
}

static yaml_event_t *add(parser *p, yaml_event_type_t type, yaml_mark_t start) {
    if (p->n == p->room) {
        int room = p->room ? 2 * p->room : 64;
        yaml_event_t *grown = realloc(p->events, (size_t)room * sizeof *grown);
        if (!grown) return p->error = YAML_MEMORY_ERROR, NULL;
        p->events = grown, p->room = room;
    }
    p->events[p->n] = (yaml_event_t){.type = type, .start_mark = start, .end_mark = p->mark};
    return &p->events[p->n++];
}

/* ---- text of a value ---- */

typedef struct buffer {
    char *text;
    size_t n, room;
} buffer;

static bool put(parser *p, buffer *b, int c) {
    if (b->n + 1 >= b->room) {
        size_t room = b->room ? 2 * b->room : 32;
        char *grown = realloc(b->text, room);
        if (!grown) return p->error = YAML_MEMORY_ERROR, false;
        b->text = grown, b->room = room;
    }
    b->text[b->n++] = (char)c, b->text[b->n] = 0;
    return true;
}

static bool scalar(parser *p, yaml_mark_t start, buffer *b, int style) {
    bool ok = b->text || (put(p, b, 0) && (b->n = 0, true));
    yaml_event_t *e = ok ? add(p, YAML_SCALAR_EVENT, start) : NULL;
    if (!e) return free(b->text), false;
    e->data.scalar.value = (yaml_char_t *)b->text, e->data.scalar.length = b->n, e->data.scalar.style = style;
    return true;
}

static bool empty(parser *p, yaml_mark_t at) {
    buffer b = {0};
    bool ok = scalar(p, at, &b, YAML_PLAIN_SCALAR_STYLE);
    if (ok) p->events[p->n - 1].end_mark = at;
    return ok;
}

/* Does plain text end here? */
static bool plain_ends(const parser *p, bool in_flow) {
    int c = peek(p, 0);
    if (c == 0 || c == '\n' || c == '\r') return true;
    if (c == ':' && (blank(peek(p, 1)) || (in_flow && strchr(",[]{}", peek(p, 1))))) return true;
    if (c == '#' && blank(p->at[-1])) return true;
    return in_flow && strchr(",[]{}", c);
}

static bool plain_line(parser *p, buffer *b, bool in_flow) {
    yaml_mark_t mark = p->mark;
    size_t n = b->n;
    do {
        if (!put(p, b, peek(p, 0))) return false;
        advance(p);
        if (b->text[b->n - 1] != ' ') n = b->n, mark = p->mark;
    } while (!plain_ends(p, in_flow));
    b->n = n, b->text[n] = 0;
    p->context_mark = mark; /* where the text ends, without blanks behind it */
    return true;
}

/* Text may go on in lines that stand further right than indent. */
static bool plain(parser *p, int indent, bool in_flow) {
    yaml_mark_t start = p->mark;
    buffer b = {0};
    if (strchr("%@`|>", peek(p, 0)) || (peek(p, 0) == '\t'))
        return fail(p, "found character that cannot start any token");
    for (;;) {
        if (!plain_line(p, &b, in_flow)) return free(b.text), false;
        yaml_mark_t end = p->context_mark, here = p->mark;
        const char *at = p->at;
        if (peek(p, 0) == '\n' || peek(p, 0) == '\r') skip(p);
        bool more = p->mark.line == here.line + 1 && (int)p->mark.column > indent && p->at < p->end &&
                    !plain_ends(p, in_flow) && peek(p, 0) != '#';
        if (more) more = put(p, &b, ' ');
        if (more) continue;
        p->at = at, p->mark = here;
        if (!scalar(p, start, &b, YAML_PLAIN_SCALAR_STYLE)) return false;
        p->events[p->n - 1].end_mark = end;
        return true;
    }
}

/* A character by its number, as UTF-8. */
static bool put_character(parser *p, buffer *b, unsigned c) {
    if (c < 0x80) return put(p, b, (int)c);
    if (c < 0x800) return put(p, b, (int)(0xC0 | c >> 6)) && put(p, b, (int)(0x80 | (c & 0x3F)));
    if (c < 0x10000 && !put(p, b, (int)(0xE0 | c >> 12))) return false;
    if (c >= 0x10000 && !(put(p, b, (int)(0xF0 | c >> 18)) && put(p, b, (int)(0x80 | (c >> 12 & 0x3F))))) return false;
    return put(p, b, (int)(0x80 | (c >> 6 & 0x3F))) && put(p, b, (int)(0x80 | (c & 0x3F)));
}

/* \x41, \u00e4, \U0001f600 */
static bool numbered(parser *p, buffer *b, int digits) {
    unsigned c = 0;
    for (int k = 0; k < digits; k++) {
        const char hex[] = {(char)peek(p, 1), 0};
        char *end;
        unsigned long digit = strtoul(hex, &end, 16);
        if (!*hex || *end || strchr(" +-", *hex)) return fail(p, "did not find expected hexdecimal number");
        c = 16 * c + (unsigned)digit;
        advance(p);
    }
    if ((c >= 0xD800 && c < 0xE000) || c > 0x10FFFF) return fail(p, "found invalid Unicode character escape code");
    return put_character(p, b, c);
}

/* At a \; ends at the last character of what it stands for. */
static bool escape(parser *p, buffer *b) {
    static const char from[] = "0abtnvfre\"/\\ \t", to[] = "\0\a\b\t\n\v\f\r\x1b\"/\\ \t";
    int c = peek(p, 1);
    const char *which = strchr(from, c);
    if (!c || (!which && !strchr("xuUN_LP", c))) return fail(p, "found unknown escape character");
    advance(p);
    if (which) return put(p, b, to[which - from]);
    switch (c) {
    case 'x':
        return numbered(p, b, 2);
    case 'u':
        return numbered(p, b, 4);
    case 'U':
        return numbered(p, b, 8);
    case 'N':
        return put_character(p, b, 0x85);
    case '_':
        return put_character(p, b, 0xA0);
    default:
        return put_character(p, b, c == 'L' ? 0x2028 : 0x2029);
    }
}

static bool quoted(parser *p) {
    yaml_mark_t start = p->mark;
    buffer b = {0};
    const int quote = peek(p, 0);
    bool ok = true;
    advance(p);
    while (ok && p->at < p->end && (peek(p, 0) != quote || (quote == '\'' && peek(p, 1) == quote))) {
        int c = peek(p, 0);
        if (c == '\\' && quote == '"') {
            ok = escape(p, &b);
        } else if (c == '\n') {
            while (b.n && b.text[b.n - 1] == ' ') b.text[--b.n] = 0;
            while (peek(p, 1) == ' ' || peek(p, 1) == '\n') advance(p);
            ok = put(p, &b, ' ');
        } else {
            if (c == quote) advance(p);
            ok = put(p, &b, c);
        }
        advance(p);
    }
    if (ok && p->at == p->end) ok = fail(p, "found unexpected end of stream");
    if (!ok) return free(b.text), false;
    advance(p);
    return scalar(p, start, &b, YAML_QUOTED_SCALAR_STYLE);
}

/* > folded, | literal: the lines that stand further right than indent. One end of line at the end is kept, - none. */
static bool block_text(parser *p, int indent) {
    yaml_mark_t start = p->mark;
    buffer b = {0};
    const bool folded = peek(p, 0) == '>', strip = peek(p, 1) == '-';
    size_t left = 0, gaps = 0;
    bool ok = true;
    for (skip_line(p); ok && p->at < p->end;) {
        const char *at = p->at;
        yaml_mark_t mark = p->mark;
        advance(p);
        while (peek(p, 0) == ' ' && (!left || p->mark.column < left)) advance(p);
        if (peek(p, 0) == '\n' || peek(p, 0) == '\r' || p->at == p->end) {
            gaps++;
            skip_line(p);
            continue;
        }
        if ((int)p->mark.column <= indent || (left && p->mark.column < left)) {
            p->at = at, p->mark = mark;
            break;
        }
        left = p->mark.column;
        if (b.n) ok = put(p, &b, folded && !gaps ? ' ' : '\n');
        for (gaps = 0; ok && peek(p, 0) && peek(p, 0) != '\n'; advance(p)) ok = put(p, &b, peek(p, 0));
    }
    if (ok && !strip && b.n) ok = put(p, &b, '\n');
    return ok ? scalar(p, start, &b, YAML_QUOTED_SCALAR_STYLE) : (free(b.text), false);
}

/* ---- structure ---- */

/* Anchor or tag before a node: told with the next event, which begins there. */
static void head(parser *p, yaml_node_head *h, yaml_mark_t *start) {
    static yaml_char_t here[] = "";
    *start = p->mark;
    while (peek(p, 0) == '&' || peek(p, 0) == '!') {
        *(peek(p, 0) == '&' ? &h->anchor : &h->tag) = here;
        while (!blank(peek(p, 0))) advance(p);
        skip(p);
    }
}

static void tell_head(parser *p, int event, yaml_node_head h, yaml_mark_t start) {
    if (!h.anchor && !h.tag) return;
    p->events[event].start_mark = start;
    yaml_event_t *e = &p->events[event];
    if (e->type == YAML_SCALAR_EVENT) e->data.scalar.anchor = h.anchor, e->data.scalar.tag = h.tag;
    if (e->type == YAML_SEQUENCE_START_EVENT) e->data.sequence_start = h;
    if (e->type == YAML_MAPPING_START_EVENT) e->data.mapping_start = h;
}

static bool alias(parser *p) {
    yaml_mark_t start = p->mark;
    do advance(p);
    while (!blank(peek(p, 0)) && !strchr(",]}", peek(p, 0)));
    return add(p, YAML_ALIAS_EVENT, start);
}

static bool flow_text(parser *p) {
    if (peek(p, 0) == '"' || peek(p, 0) == '\'') return quoted(p);
    return plain(p, -1, true);
}

/* Behind a key: its value, up to , or the end. */
static bool flow_value(parser *p) {
    skip(p);
    int c = peek(p, 0);
    return c == ',' || c == '}' || c == ']' || !c ? empty(p, p->mark) : flow(p);
}

static bool flow_list(parser *p, bool mapping) {
    const int close = mapping ? '}' : ']';
    const yaml_mark_t start = p->mark;
    advance(p);
    if (!add(p, mapping ? YAML_MAPPING_START_EVENT : YAML_SEQUENCE_START_EVENT, start)) return false;
    for (skip(p); peek(p, 0) != close; skip(p)) {
        if (mapping) {
            if (!flow_text(p)) return false;
            skip(p);
            if (peek(p, 0) == ':') advance(p);
        }
        if (!(mapping ? flow_value : flow)(p)) return false;
        skip(p);
        if (peek(p, 0) == ',')
            advance(p);
        else if (peek(p, 0) != close) {
            p->context = mapping ? "while parsing a flow mapping" : "while parsing a flow sequence",
            p->context_mark = start;
            return fail(p, mapping ? "did not find expected ',' or '}'" : "did not find expected ',' or ']'");
        }
    }
    yaml_mark_t end = p->mark;
    advance(p);
    return add(p, mapping ? YAML_MAPPING_END_EVENT : YAML_SEQUENCE_END_EVENT, end);
}

static bool flow(parser *p) {
    yaml_node_head h = {0};
    yaml_mark_t start;
    int c, event = p->n;
    if (p->depth++ == MOST_DEPTH) return fail(p, "nested too deep");
    head(p, &h, &start);
    c = peek(p, 0);
    bool ok = c == '{' || c == '['               ? flow_list(p, c == '{')
              : c == '*'                         ? alias(p)
              : c == 0 || strchr(",]}:", c) != 0 ? fail(p, "did not find expected node content")
                                                 : flow_text(p);
    p->depth--;
    if (ok) tell_head(p, event, h, start);
    return ok;
}

/* Does a key begin here: text, then `:` and a blank, in this line? */
static bool is_key(const parser *p) {
    parser ahead = *p;
    int c = peek(p, 0);
    if (c == '[' || c == '{') return false;
    if (c == '"' || c == '\'') {
        do advance(&ahead);
        while (peek(&ahead, 0) && peek(&ahead, 0) != c && peek(&ahead, 0) != '\n');
        if (peek(&ahead, 0) == c) advance(&ahead);
    } else {
        while (!plain_ends(&ahead, false)) advance(&ahead);
    }
    while (peek(&ahead, 0) == ' ') advance(&ahead);
    return peek(&ahead, 0) == ':' && blank(peek(&ahead, 1));
}

static bool is_item(const parser *p) {
    return peek(p, 0) == '-' && blank(peek(p, 1));
}

static bool document_mark(const parser *p) {
    return p->mark.column == 0 && p->end - p->at >= 3 && !strncmp(p->at, "---", 3) && blank(peek(p, 3));
}

/* A value that stands further right than indent, or, a list behind a key, as far; nothing there: an empty one. */
static bool value(parser *p, int indent, bool after_key) {
    yaml_mark_t behind = p->mark;
    skip(p);
    bool here = p->mark.line == behind.line && p->at < p->end;
    int column = (int)p->mark.column;
    if (p->at == p->end || document_mark(p) ||
        (!here && column <= indent && !(after_key && column == indent && is_item(p))))
        return empty(p, behind);
    if (here && after_key && peek(p, 0) != '{' && peek(p, 0) != '[' && is_key(p))
        return fail(p, "mapping values are not allowed in this context");
    return node(p, indent);
}

static bool block_list(parser *p) {
    const int column = (int)p->mark.column;
    if (!add(p, YAML_SEQUENCE_START_EVENT, p->mark)) return false;
    while (p->at < p->end && (int)p->mark.column == column && is_item(p)) {
        advance(p);
        if (!value(p, column, false)) return false;
        skip(p);
    }
    return add(p, YAML_SEQUENCE_END_EVENT, p->mark);
}

static bool block_mapping(parser *p) {
    const yaml_mark_t start = p->mark;
    const int column = (int)p->mark.column;
    if (!add(p, YAML_MAPPING_START_EVENT, p->mark)) return false;
    while (p->at < p->end && (int)p->mark.column == column && !document_mark(p) && is_key(p)) {
        if (!(peek(p, 0) == '"' || peek(p, 0) == '\'' ? quoted(p) : plain(p, column, false))) return false;
        skip(p);
        advance(p);
        if (!value(p, column, true)) return false;
        skip(p);
    }
    if (peek(p, 0) == ':') return fail(p, "mapping values are not allowed in this context");
    if ((int)p->mark.column == column && (peek(p, 0) == '[' || peek(p, 0) == '{'))
        return flow_list(p, peek(p, 0) == '{');
    if (p->at < p->end && (int)p->mark.column >= column && !document_mark(p)) {
        p->context = "while parsing a block mapping", p->context_mark = start;
        return fail(p, "did not find expected key");
    }
    return add(p, YAML_MAPPING_END_EVENT, p->mark);
}

static bool node(parser *p, int indent) {
    yaml_node_head h = {0};
    yaml_mark_t start;
    int c, event = p->n;
    bool ok;
    if (p->depth++ == MOST_DEPTH) return fail(p, "nested too deep");
    head(p, &h, &start);
    c = peek(p, 0);
    if (c == '*')
        ok = alias(p);
    else if (is_item(p))
        ok = block_list(p);
    else if (c == '{' || c == '[')
        ok = flow_list(p, c == '{');
    else if (is_key(p))
        ok = block_mapping(p);
    else if (c == '"' || c == '\'')
        ok = quoted(p);
    else
        ok = c == '>' || c == '|' ? block_text(p, indent) : plain(p, indent, false);
    p->depth--;
    if (ok) tell_head(p, event, h, start);
    return ok;
}

static bool documents(parser *p) {
    for (skip(p); p->at < p->end; skip(p)) {
        yaml_event_t *start = add(p, YAML_DOCUMENT_START_EVENT, p->mark);
        if (!start) return false;
        if (!strncmp(p->at, "%TAG", 4)) start->data.document_start.tag_directives.end = p->at; /* it is refused */
        while (peek(p, 0) == '%' && p->mark.column == 0) skip_line(p), skip(p);
        if (document_mark(p)) {
            for (int k = 0; k < 3; k++) advance(p);
            skip(p);
        }
        if (p->at == p->end || document_mark(p) ? !empty(p, p->mark) : !node(p, -1)) return false;
        skip(p);
        if (p->at < p->end && !document_mark(p)) return fail(p, "did not find expected <document start>");
    }
    return add(p, YAML_STREAM_END_EVENT, p->mark);
}

/* ---- the face ---- */

int yaml_parser_initialize(yaml_parser_t *p) {
    *p = (yaml_parser_t){0};
    return 1;
}

void yaml_parser_set_encoding(yaml_parser_t *p, int encoding) {
    (void)p, (void)encoding;
}

void yaml_parser_set_input_string(yaml_parser_t *p, const unsigned char *text, size_t size) {
    p->text = p->at = (const char *)text, p->end = p->text + size;
}

int yaml_parser_parse(yaml_parser_t *p, yaml_event_t *event) {
    *event = (yaml_event_t){0};
    if (!p->n && !p->error) documents(p);
    if (p->next < p->n) {
        *event = p->events[p->next++];
        p->events[p->next - 1].data.scalar.value = NULL;
        return 1;
    }
    return !p->error;
}

void yaml_event_delete(yaml_event_t *event) {
    free(event->data.scalar.value);
    event->data.scalar.value = NULL;
}

void yaml_parser_delete(yaml_parser_t *p) {
    for (int i = p->next; i < p->n; i++) yaml_event_delete(&p->events[i]);
    free(p->events);
}
