/* SPDX-License-Identifier: MIT */
/* scene/formula.h without muParser, for the page: the same arithmetic in the same order. expression.c has made the
 * text: variables v0, v1, ..., + - * / ^ ( ) and six functions. */
#include "base/alloc.h"
#include "base/math.h"
#include "scene/formula.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct tr_formula {
    const double *values;
    int n;
    char *text;
    const char *at; /* what comes next */
    bool wrong;
};

tr_formula *tr_formula_new(double *values, int n, tr_status *st) {
    tr_formula *f = tr_alloc(1, sizeof *f, st);
    if (f) f->values = values, f->n = n;
    return f;
}

void tr_formula_free(tr_formula *f) {
    if (f) free(f->text);
    free(f);
}

tr_formula_end tr_formula_set(tr_formula *f, const char *text) {
    free(f->text);
    f->text = strdup(text);
    return f->text ? TR_FORMULA_DONE : TR_FORMULA_NO_MEMORY;
}

static double sum(tr_formula *f);

static bool take(tr_formula *f, char c) {
    return *f->at == c && f->at++;
}

static double inside(tr_formula *f) {
    double x = sum(f);
    if (!take(f, ')')) f->wrong = true;
    return x;
}

static double atom(tr_formula *f) {
    static const struct {
        const char *name;
        double (*of)(double);
    } functions[] = {{"sqrt(", sqrt},  {"exp(", tr_exp}, {"sin(", tr_sin},
                     {"cos(", tr_cos}, {"tan(", tr_tan}, {"atan(", tr_atan}};
    if (take(f, '(')) return inside(f);
    for (size_t k = 0; k < sizeof functions / sizeof *functions; k++)
        if (!strncmp(f->at, functions[k].name, strlen(functions[k].name))) {
            f->at += strlen(functions[k].name);
            return functions[k].of(inside(f));
        }
    if (!take(f, 'v')) return f->wrong = true, 0;
    char *end;
    long k = strtol(f->at, &end, 10);
    if (end == f->at || k < 0 || k >= f->n) return f->wrong = true, 0;
    f->at = end;
    return f->values[k];
}

static double sign(tr_formula *f);

/* a^b^c is a^(b^c). */
static double power(tr_formula *f) {
    double x = atom(f);
    return take(f, '^') ? tr_pow(x, sign(f)) : x;
}

/* -a^b is -(a^b). */
static double sign(tr_formula *f) {
    return take(f, '-') ? -sign(f) : power(f);
}

static double product(tr_formula *f) {
    double x = sign(f);
    for (;;) {
        if (take(f, '*'))
            x = x * sign(f);
        else if (take(f, '/'))
            x = x / sign(f);
        else
            return x;
    }
}

static double sum(tr_formula *f) {
    double x = product(f);
    for (;;) {
        if (take(f, '+'))
            x = x + product(f);
        else if (take(f, '-'))
            x = x - product(f);
        else
            return x;
    }
}

tr_formula_end tr_formula_evaluate(tr_formula *f, double *value) {
    f->at = f->text, f->wrong = false;
    *value = sum(f);
    return f->wrong || *f->at ? TR_FORMULA_WRONG : TR_FORMULA_DONE;
}
