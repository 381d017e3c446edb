/* SPDX-License-Identifier: MIT */
/* muParser does the arithmetic, nothing else: this file decides what an expression is. It turns the text into one in
 * which every number and name is a variable v0, v1, ..., so no name can meet a built-in of muParser.
 *
 * Dimensions are checked by arithmetic: a result in kg^a m^b s^c is multiplied by 4^a when the unit of mass is
 * made four times smaller, and so on. Powers of four stay exact through + - * / and sqrt. */
#include "scene/expression.h"
#include "base/math.h"
#include "base/alloc.h"
#include "scene/formula.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MAX_OPERANDS = TR_EXPRESSION_LENGTH, MAX_NAME = 64 };
#define SLACK 1e-14 /* in a power found from a result: a few roundings of ^ */

struct tr_expression {
    tr_formula *formula;
    double values[MAX_OPERANDS]; /* of v0, v1, ... */
};

typedef struct unit {
    const char *name;
    double factor; /* SI */
    tr_dim dim;
} unit;

static const unit units[] = {
    {"kg", 1, {1, 0, 0, 0}},
    {"g", 1e-3, {1, 0, 0, 0}},
    {"t", 1e3, {1, 0, 0, 0}},
    {"m", 1, {0, 1, 0, 0}},
    {"mm", 1e-3, {0, 1, 0, 0}},
    {"cm", 1e-2, {0, 1, 0, 0}},
    {"um", 1e-6, {0, 1, 0, 0}},
    {"km", 1e3, {0, 1, 0, 0}},
    {"s", 1, {0, 0, 1, 0}},
    {"ms", 1e-3, {0, 0, 1, 0}},
    {"us", 1e-6, {0, 0, 1, 0}},
    {"min", 60, {0, 0, 1, 0}},
    {"N", 1, {1, 1, -2, 0}},
    {"kN", 1e3, {1, 1, -2, 0}},
    {"MN", 1e6, {1, 1, -2, 0}},
    {"Pa", 1, {1, -1, -2, 0}},
    {"kPa", 1e3, {1, -1, -2, 0}},
    {"MPa", 1e6, {1, -1, -2, 0}},
    {"GPa", 1e9, {1, -1, -2, 0}},
    {"J", 1, {1, 2, -2, 0}},
    {"deg", M_PI / 180, {0, 0, 0, 0}},
    {"rpm", M_PI / 30, {0, 0, -1, 0}},
    {"rad", 1, {0, 0, 0, 0}},
};

/* What to write for characters that are no part of a value. */
static const struct {
    const char *text, *write;
} instead[] = {
    {",", "a number has a decimal point, and nothing between thousands: write 0.3 for 0,3, and 1000 for 1,000"},
    {"%", "write 0.2 for 20 %"},
    {"°", "write 10 deg for 10 °"},
    {"µ", "write um for µm"}, /* the micro sign */
    {"μ", "write um for μm"}, /* the Greek letter */
    {"−", "write - for the minus"},
    {"–", "write - for the minus"},
    {"·", "write * between factors"},
    {"×", "write * between factors"},
    {"²", "write ^2"},
    {"³", "write ^3"},
    {"½", "write 1/2"},
    {"π", "write pi"},
};

static const char *const functions[] = {"sqrt", "exp", "sin", "cos", "tan", "atan"};

typedef struct operand {
    tr_quantity quantity;
    bool exponent; /* stands behind ^ */
} operand;

/* The text on its way to muParser. Local to one call: a name's value may need another expression. */
typedef struct translation {
    char text[8 * TR_EXPRESSION_LENGTH];
    size_t length;
    operand operands[MAX_OPERANDS];
    int n;
    bool named; /* a unit or a key occurred: the dimension counts */
} translation;

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_function(const char *name) {
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        if (strcmp(name, functions[i]) == 0) return true;
    }
    return false;
}

static const unit *find_unit(const char *name) {
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        if (strcmp(name, units[i].name) == 0) return &units[i];
    }
    return NULL;
}

/* Hz, kHz, mHz, hz: known, to be refused. A turn a second to some and 1/s to others. */
static bool is_hertz(const char *name) {
    size_t n = strlen(name);
    return (n == 2 || n == 3) && strcasecmp(name + n - 2, "Hz") == 0;
}

bool tr_expression_reserved(const char *name) {
    return find_unit(name) || is_hertz(name) || is_function(name) || strcmp(name, "pi") == 0;
}

/* 12, 1.5, .5, 2e-3: its length, 0 when there is none. */
static size_t number_length(const char *p) {
    size_t whole = strspn(p, "0123456789"), n = whole, part = 0;
    if (p[n] == '.') part = strspn(p + n + 1, "0123456789"), n += 1 + part;
    if (whole + part == 0) return 0;
    if (p[n] == 'e' || p[n] == 'E') {
        size_t sign = p[n + 1] == '-' || p[n + 1] == '+', power = strspn(p + n + 1 + sign, "0123456789");
        if (power) n += 1 + sign + power;
    }
    return n;
}

/* A letter, then letters, digits and dots inside. */
static size_t name_length(const char *p) {
    size_t n = 0;
    if (is_letter(*p)) {
        while (is_letter(p[n]) || is_digit(p[n]) || p[n] == '.') n++;
    }
    return n;
}

static bool fail(tr_problem *problem, size_t at, const char *text) {
    problem->at = at;
    snprintf(problem->text, sizeof problem->text, "%s", text);
    return false;
}

static void emit(translation *t, const char *text) {
    t->length += (size_t)snprintf(t->text + t->length, sizeof t->text - t->length, "%s", text);
}

static void emit_operand(translation *t, tr_quantity quantity) {
    char name[16];
    bool exponent = t->length && t->text[t->length - 1] == '^';
    snprintf(name, sizeof name, "v%d", t->n);
    emit(t, name);
    t->operands[t->n++] = (operand){quantity, exponent};
}

static bool name_value(const char *name, const tr_names *names, tr_quantity *quantity, tr_problem *problem) {
    tr_found found = names ? names->find(names->context, name, quantity, problem) : TR_UNKNOWN;
    if (found != TR_UNKNOWN) return found == TR_FOUND;
    const unit *u = find_unit(name);
    if (!u) {
        if (!names) snprintf(problem->text, sizeof problem->text, "unknown name `%s`", name);
        return false;
    }
    *quantity = (tr_quantity){u->factor, u->dim};
    return true;
}

/* A name or a function at text[at], n letters long. *open: it was a function, and its `(` is still to come. */
static bool translate_name(translation *t, const char *text, size_t at, size_t n, const tr_names *names, bool *open,
                           tr_problem *problem) {
    char name[MAX_NAME];
    if (n >= sizeof name) return fail(problem, at, "this name is too long");
    memcpy(name, text + at, n);
    name[n] = '\0';
    size_t behind = at + n + strspn(text + at + n, " ");
    bool call = text[behind] == '(';
    *open = is_function(name);
    if (*open && !call) return fail(problem, at, "a function needs its argument in parentheses, as in sqrt(2)");
    if (!*open && call) return fail(problem, at, "not a function; allowed are sqrt exp sin cos tan atan");
    if (*open) return emit(t, name), true;
    if (is_hertz(name))
        return fail(problem, at,
                    "Hz is not a unit here: a turn a second is 2*pi*rad/s, not 1 rad/s; write rad/s, deg/s or rpm "
                    "(1 Hz = 2*pi*rad/s = 360 deg/s = 60 rpm)");
    tr_quantity quantity = {M_PI, TR_DIM_NUMBER};
    if (strcmp(name, "pi") != 0) {
        t->named = true;
        problem->at = at;
        if (!name_value(name, names, &quantity, problem)) return false;
    }
    emit_operand(t, quantity);
    return true;
}

static bool fail_character(const char *text, size_t i, tr_problem *problem) {
    fail(problem, i, "this character cannot stand in a value; allowed are numbers, names, + - * / ^ ( )");
    for (size_t k = 0; k < sizeof instead / sizeof *instead; k++)
        if (strncmp(text + i, instead[k].text, strlen(instead[k].text)) == 0)
            snprintf(problem->text, sizeof problem->text, "`%s` cannot stand in a value; %s", instead[k].text,
                     instead[k].write);
    return false;
}

/* The grammar: operand and operator take turns. */
static bool translate(translation *t, const char *text, const tr_names *names, tr_problem *problem) {
    size_t i = 0;
    int depth = 0;
    bool wanted = true, sign = false, number = false; /* an operand comes next; behind a sign; just behind a number */
    for (; text[i]; i++) {
        const char c = text[i], one[2] = {c, 0};
        const bool may_sign = !sign;
        size_t n = name_length(text + i);
        if (c == ' ') continue;
        if (!n && !is_digit(c) && !strchr(".+-*/^()", c)) return fail_character(text, i, problem);
        if (!wanted && number && n) emit(t, "*"), wanted = true;
        number = sign = false;
        if (wanted && n) {
            if (!translate_name(t, text, i, n, names, &wanted, problem)) return false;
            i += n - 1;
        } else if (wanted && (n = number_length(text + i))) {
            emit_operand(t, (tr_quantity){strtod(text + i, NULL), TR_DIM_NUMBER});
            number = true;
            wanted = false;
            i += n - 1;
        } else if (wanted && c == '(') {
            emit(t, one);
            depth++;
        } else if (wanted && (c == '-' || c == '+') && may_sign) {
            if (c == '-') emit(t, one);
            sign = true;
        } else if (wanted) {
            return fail(problem, i, "expected a number, a unit, a key or `(` here");
        } else if (c == ')') {
            if (depth-- == 0) return fail(problem, i, "this `)` has no `(`");
            emit(t, one);
        } else if (strchr("+-*/^", c)) {
            emit(t, one);
            wanted = true;
        } else {
            return fail(problem, i, "expected + - * / ^ or the end here");
        }
    }
    if (wanted) return fail(problem, i, t->length ? "the value ends too early here" : "no value");
    return depth == 0 || fail(problem, i, "a `)` is missing");
}

static bool ended_well(tr_formula_end end, tr_problem *problem) {
    problem->no_memory = end == TR_FORMULA_NO_MEMORY;
    if (problem->no_memory) return fail(problem, 0, "out of memory");
    return end == TR_FORMULA_DONE || fail(problem, 0, "this cannot be computed; use parentheses");
}

/* The result when the units of mass, length and time are 4^-scale of what they are. check: zeros become tiny, so that
 * `0 mm` keeps its dimension. */
static bool evaluate(tr_expression *e, const translation *t, tr_dim scale, bool check, double *value,
                     tr_problem *problem) {
    for (int i = 0; i < t->n; i++) {
        tr_quantity q = t->operands[i].quantity;
        if (check && q.value == 0 && !t->operands[i].exponent) q.value = 0x1p-20;
        e->values[i] = ldexp(q.value, 2 * (q.dim.kg * scale.kg + q.dim.m * scale.m + q.dim.s * scale.s));
    }
    return ended_well(tr_formula_evaluate(e->formula, value), problem);
}

/* "in m s^-1", from the powers of kg, m, s. */
static bool describe(tr_problem *problem, const double power[3]) {
    static const char *const names[] = {"kg", "m", "s"};
    char text[64] = "";
    for (int i = 0; i < 3; i++) {
        size_t used = strlen(text);
        double p = round(4 * power[i]) / 4;
        if (!(fabs(power[i] - p) < SLACK && fabs(p) < 100))
            return fail(problem, 0,
                        "mixes dimensions: the terms of a sum need one dimension, functions and powers need numbers");
        if (p != 0) snprintf(text + used, sizeof text - used, p == 1 ? " %s" : " %s^%g", names[i], p);
    }
    snprintf(problem->text, sizeof problem->text, "wrong dimension: this is %s%s", *text ? "in" : "a number", text);
    return false;
}

static bool check_dimension(tr_expression *e, const translation *t, tr_dim dim, tr_problem *problem) {
    const tr_dim scale[3] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    double base, power[3];
    if (!evaluate(e, t, (tr_dim)TR_DIM_NUMBER, true, &base, problem)) return false;
    if (base == 0) return true; /* 1 mm - 1 mm */
    for (int i = 0; i < 3; i++) {
        if (!evaluate(e, t, scale[i], true, &power[i], problem)) return false;
        power[i] = tr_log2(power[i] / base) / 2;
    }
    bool same = fabs(power[0] - dim.kg) < SLACK && fabs(power[1] - dim.m) < SLACK && fabs(power[2] - dim.s) < SLACK;
    return same || describe(problem, power);
}

bool tr_expression_value(tr_expression *e, const char *text, tr_dim dim, const tr_names *names, double *value,
                         tr_problem *problem) {
    problem->at = 0;
    problem->no_memory = false;
    if (strlen(text) > TR_EXPRESSION_LENGTH) return fail(problem, 0, "this value is longer than 200 characters");
    translation t;
    t.length = 0;
    t.n = 0;
    t.named = false;
    if (!translate(&t, text, names, problem)) return false;
    if (!ended_well(tr_formula_set(e->formula, t.text), problem) ||
        !evaluate(e, &t, (tr_dim)TR_DIM_NUMBER, false, value, problem))
        return false;
    problem->at = 0;
    if (!isfinite(*value)) return fail(problem, 0, "the result is not a finite number");
    return !t.named || check_dimension(e, &t, dim, problem);
}

tr_expression *tr_expression_new(tr_status *st) {
    tr_expression *e = tr_alloc(1, sizeof *e, st);
    if (!e) return NULL;
    e->formula = tr_formula_new(e->values, MAX_OPERANDS, st);
    if (!e->formula) free(e), e = NULL;
    return e;
}

void tr_expression_free(tr_expression *e) {
    if (!e) return;
    tr_formula_free(e->formula);
    free(e);
}
