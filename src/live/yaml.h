/* SPDX-License-Identifier: MIT */
/* The part of libyaml's face that scene/tree.c takes, for the page: libyaml is not to be had for WebAssembly. It reads
 * what cases have: mappings and lists in block and flow style, plain, quoted, folded and literal text, comments,
 * documents. Anchors, tags and aliases are told, so that the reader can refuse them. */
#ifndef YAML_H
#define YAML_H

#include <stddef.h>

typedef unsigned char yaml_char_t;

typedef enum yaml_event_type_t {
    YAML_NO_EVENT,
    YAML_STREAM_END_EVENT,
    YAML_DOCUMENT_START_EVENT,
    YAML_ALIAS_EVENT,
    YAML_SCALAR_EVENT,
    YAML_SEQUENCE_START_EVENT,
    YAML_SEQUENCE_END_EVENT,
    YAML_MAPPING_START_EVENT,
    YAML_MAPPING_END_EVENT
} yaml_event_type_t;

typedef enum yaml_error_type_t { YAML_NO_ERROR, YAML_MEMORY_ERROR, YAML_PARSER_ERROR } yaml_error_type_t;

enum { YAML_UTF8_ENCODING, YAML_PLAIN_SCALAR_STYLE = 1, YAML_QUOTED_SCALAR_STYLE };

typedef struct yaml_mark_t {
    size_t line, column; /* from 0; in characters */
} yaml_mark_t;

typedef struct yaml_node_head {
    yaml_char_t *anchor, *tag; /* NULL: none */
} yaml_node_head;

typedef struct yaml_event_t {
    yaml_event_type_t type;
    struct {
        struct {
            struct {
                const void *start, *end;
            } tag_directives;
        } document_start;
        struct {
            yaml_char_t *anchor, *tag, *value;
            size_t length;
            int style;
        } scalar;
        yaml_node_head sequence_start, mapping_start;
    } data;
    yaml_mark_t start_mark, end_mark;
} yaml_event_t;

typedef struct yaml_parser_t {
    yaml_error_type_t error;
    const char *problem, *context; /* NULL: none */
    yaml_mark_t problem_mark, context_mark;
    const char *text, *end, *at; /* all of it; what comes next */
    yaml_mark_t mark;            /* of `at` */
    int depth;
    yaml_event_t *events;
    int n, room, next; /* read so far, once all is read; which is told next */
} yaml_parser_t;

int yaml_parser_initialize(yaml_parser_t *parser);
void yaml_parser_set_encoding(yaml_parser_t *parser, int encoding);
void yaml_parser_set_input_string(yaml_parser_t *parser, const unsigned char *text, size_t size);
/* 0: a failure, see error and problem. */
int yaml_parser_parse(yaml_parser_t *parser, yaml_event_t *event);
void yaml_event_delete(yaml_event_t *event);
void yaml_parser_delete(yaml_parser_t *parser);

#endif
