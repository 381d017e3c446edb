/* SPDX-License-Identifier: MIT */
/* A value of a case file: text such as `0.76 mm`, `160 kPa` or `0.5*k_n` to a double in SI, with its dimension checked.
 *
 * Numbers, names, + - * / ^, parentheses, pi, and sqrt exp sin cos tan atan of one argument. A number directly followed
 * by a name is their product, and binds no tighter than `*`: `160 kN/m^2` is 160*kN/m^2, `2 mm^2` is 2*(mm^2), `1/2 mm`
 * is (1/2)*mm = 0.5 mm. Text that names no unit and no key is a plain number, and is in SI whatever the dimension. */
#ifndef TR_EXPRESSION_H
#define TR_EXPRESSION_H

#include "base/param.h"
#include "base/status.h"

enum { TR_EXPRESSION_LENGTH = 200 }; /* longer text is refused */

/* The units, for messages. An angle is a number, so rad is 1 and rpm, a turn a minute, is 2 pi/60 s^-1. Hz is
 * refused. */
#define TR_EXPRESSION_UNITS "kg g t m mm cm um km s ms us min N kN MN Pa kPa MPa GPa J deg rad rpm"

typedef struct tr_quantity {
    double value; /* SI */
    tr_dim dim;
} tr_quantity;

/* What is wrong with a text, and at which character of it (from 0). */
typedef struct tr_problem {
    size_t at;
    bool no_memory; /* the text is not to blame */
    char text[320];
} tr_problem;

typedef enum tr_found { TR_FOUND, TR_UNKNOWN, TR_FAILED } tr_found;

/* How names other than units are looked up: they come first. On TR_FAILED, and on TR_UNKNOWN for a name that is not a
 * unit, find has written the problem's text. */
typedef struct tr_names {
    tr_found (*find)(void *context, const char *name, tr_quantity *quantity, tr_problem *problem);
    void *context;
} tr_names;

/* The parser; one serves any number of texts, also when find evaluates another text. NULL and TR_FILE: out of memory.
 */
typedef struct tr_expression tr_expression;
tr_expression *tr_expression_new(tr_status *st);
void tr_expression_free(tr_expression *e);

/* False and *problem when the text is no expression, the result is not finite, or its dimension is not dim. */
bool tr_expression_value(tr_expression *e, const char *text, tr_dim dim, const tr_names *names, double *value,
                         tr_problem *problem);

/* A unit, Hz, a function or pi: no key may have this name. */
bool tr_expression_reserved(const char *name);

#endif
