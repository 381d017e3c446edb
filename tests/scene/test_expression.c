/* SPDX-License-Identifier: MIT */
/* What a value may say, and what it is then. Expected numbers are worked out by hand. */
#include "assert_close.h"
#include "base/math.h"
#include "scene/expression.h"
#include "scene/tables.h"
#include <string.h>

static tr_found find(void *context, const char *name, tr_quantity *quantity, tr_problem *problem) {
    (void)context;
    const struct {
        const char *name;
        tr_quantity quantity;
    } keys[] = {{"k_n", {2e8, TR_DIM_STIFFNESS}}, {"zero", {0, TR_DIM_LENGTH}}, {"mu", {0.5, TR_DIM_NUMBER}},
                {"a.b", {3, TR_DIM_LENGTH}},      {"v0", {7, TR_DIM_LENGTH}},   {"_pi", {5, TR_DIM_NUMBER}}};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        if (strcmp(keys[i].name, name) == 0) return *quantity = keys[i].quantity, TR_FOUND;
    }
    strcpy(problem->text, "unknown");
    return TR_UNKNOWN;
}

static tr_expression *parser;

static bool value(const char *text, tr_dim dim, double *v, tr_problem *problem) {
    return tr_expression_value(parser, text, dim, &(tr_names){find, NULL}, v, problem);
}

static void accepts(void **state) {
    (void)state;
    const tr_dim number = TR_DIM_NUMBER, length = TR_DIM_LENGTH, area = {0, 2, 0, 0}, pressure = TR_DIM_STRESS,
                 time = TR_DIM_TIME, speed = TR_DIM_SPEED, density = TR_DIM_DENSITY, spin = TR_DIM_SPIN;
    const struct {
        const char *text;
        tr_dim dim;
        double wanted;
    } rows[] = {
        {"0.76 mm", length, 0.00076},
        {"0.76mm", length, 0.00076},
        {"160 kN/m^2", pressure, 160000},
        {"160 kPa", pressure, 160000},
        {"2 mm^2", area, 0.000002},
        {"(2*mm)^2", area, 0.000004},
        {"1/2 mm", length, 0.0005},
        {"1e-3", number, 0.001},
        {"2.5E6", pressure, 2500000},
        {"1e3mm", length, 1},
        {".5", number, 0.5},
        {"5.", number, 5},
        {"-3 mm", length, -0.003},
        {"+4", number, 4},
        {"2*-3", number, -6},
        {"2 - -3", number, 5},
        {"2--3", number, 5},
        {"2^-1", number, 0.5},
        {"-2^2", number, -4},
        {"2^3^2", number, 512},
        {"0.5*k_n", pressure, 1e8},
        {"2 k_n", pressure, 4e8},
        {"a.b + 1 m", length, 4},
        {"v0/m", number, 7},
        {"2*_pi", number, 10},
        {"sqrt(4 m * 9 m)", length, 6},
        {"sqrt (16)", number, 4},
        {"sqrt(k_n/(2000 kg/m^3)) * s/m", number, 316.22776601683796},
        {"180 deg", number, 3.1415926535897931},
        {"pi", number, 3.1415926535897931},
        {"2*pi", spin, 6.2831853071795862},
        {"60 rpm", spin, 6.2831853071795862}, /* a turn a second */
        {"rpm*1 min", number, 6.2831853071795862},
        {"360 deg/s", spin, 6.2831853071795862},
        {"1 rad/s", spin, 1},
        {"1/s", spin, 1},
        {"sin(30 deg)", number, 0.5},
        {"cos(60 deg)", number, 0.5},
        {"4*atan(1)", number, 3.1415926535897931},
        {"tan(45 deg)", number, 1},
        {"2.7 g/cm^3", density, 2700},
        {"2.7 t/m^3", density, 2700},
        {"36 km/(60*min)", speed, 10},
        {"1 um/us", speed, 1},
        {"1 J/m^3", pressure, 1},
        {"1 MN/m^2 + 1 MPa + 1 GPa/1000", pressure, 3e6},
        {"0 mm", length, 0},
        {"zero", length, 0},
        {"zero^0", number, 1},
        {"1 mm - 1 mm", length, 0},
        {"mu*ms*zero/m", time, 0},
        {"7", density, 7},
        {"  1  ", number, 1},
        {"3 kg^0.5*kg^1.5/(kg*m^3)", density, 3},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double v = NAN;
        tr_problem problem = {0};
        if (!value(rows[i].text, rows[i].dim, &v, &problem)) fail_msg("`%s`: %s", rows[i].text, problem.text);
        if (!(fabs(v - rows[i].wanted) <= 1e-15 * fabs(rows[i].wanted)))
            fail_msg("`%s` is %.17g, expected %.17g", rows[i].text, v, rows[i].wanted);
    }
}

/* Not muParser's own, which are of the C library. Some arguments where the two differ are among so many. */
static void functions_are_the_portable_ones(void **state) {
    (void)state;
    for (int i = 1; i <= 2000; i++) {
        const double x = i / 256.0;
        const struct {
            const char *before, *behind;
            double wanted;
        } rows[] = {{"exp(", ")", tr_exp(x)}, {"sin(", ")", tr_sin(x)},   {"cos(", ")", tr_cos(x)},
                    {"tan(", ")", tr_tan(x)}, {"atan(", ")", tr_atan(x)}, {"", "^2.7", tr_pow(x, 2.7)}};
        for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
            char text[64];
            snprintf(text, sizeof text, "%s%.17g%s", rows[k].before, x, rows[k].behind);
            double v = NAN;
            tr_problem problem = {0};
            if (!value(text, (tr_dim)TR_DIM_NUMBER, &v, &problem)) fail_msg("`%s`: %s", text, problem.text);
            if (v != rows[k].wanted) fail_msg("`%s` is %.17g, expected %.17g", text, v, rows[k].wanted);
        }
    }
}

static void refuses(void **state) {
    (void)state;
    const char *const mixes =
        "mixes dimensions: the terms of a sum need one dimension, functions and powers need numbers";
    const char *const hertz =
        "Hz is not a unit here: a turn a second is 2*pi*rad/s, not 1 rad/s; write rad/s, deg/s or "
        "rpm (1 Hz = 2*pi*rad/s = 360 deg/s = 60 rpm)";
    const char *const operand = "expected a number, a unit, a key or `(` here";
    const char *const operator= "expected + - * / ^ or the end here";
    const char *const comma = "`,` cannot stand in a value; a number has a decimal point, and nothing between "
                              "thousands: write 0.3 for 0,3, and 1000 for 1,000";
    const char *const character = "this character cannot stand in a value; allowed are numbers, names, + - * / ^ ( )";
    const struct {
        const char *text;
        size_t at;
        const char *wanted;
    } rows[] = {{"mm=3", 2, character}, {"1,2", 1, comma}, {"1e3;2", 3, character},
                {"2 3", 2, operator},
                 {"mm 3", 3, operator},
                  {"mm mm", 3, operator},
                   {"2(3)", 1, operator},
                    {"(1) mm", 4, operator},
                     {
                         "1.2.3",
                         3,
                         operator},
                         {"1e", 1, "unknown"},
                         {"1 mx", 2, "unknown"},
                         {"1 Hz", 2, hertz},
                         {"2*pi*kHz", 5, hertz},
                         {"1/(3 MHz)", 5, hertz},
                         {"1hz", 1, hertz},
                         {"30 rpm", 0, "wrong dimension: this is in s^-1"},
                         {"nan", 0, "unknown"},
                         {"inf", 0, "unknown"},
                         {"0x10", 1, "unknown"},
                         {".nan", 0, operand},
                         {"1 +", 3, "the value ends too early here"},
                         {"*2", 0, operand},
                         {"2---3", 3, operand},
                         {"()", 1, operand},
                         {"(1", 2, "a `)` is missing"},
                         {"1)", 1, "this `)` has no `(`"},
                         {"", 0, "no value"},
                         {"sqrt 2", 0, "a function needs its argument in parentheses, as in sqrt(2)"},
                         {"log(2)", 0, "not a function; allowed are sqrt exp sin cos tan atan"},
                         {"mm(2)", 0, "not a function; allowed are sqrt exp sin cos tan atan"},
                         {"1e999", 0, "the result is not a finite number"},
                         {"1/0", 0, "the result is not a finite number"},
                         {"sqrt(-1)", 0, "the result is not a finite number"},
                         {"3 s", 0, "wrong dimension: this is in s"},
                         {"3 rad", 0, "wrong dimension: this is a number"},
                         {"0 kPa", 0, "wrong dimension: this is in kg m^-1 s^-2"},
                         {"sqrt(m)", 0, "wrong dimension: this is in m^0.5"},
                         {"1 m/2 s", 0, "wrong dimension: this is in m s"},
                         {"1 mm + 1 s", 0, mixes},
                         {"zero + 1 s", 0, mixes},
                         {"1 m + 1e-9 s", 0, mixes},
                         {"sin(1 m)", 0, mixes},
                         {"3^(1 m)", 0, mixes},
                    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double v;
        tr_problem problem = {0};
        const tr_dim length = TR_DIM_LENGTH;
        bool ok = value(rows[i].text, length, &v, &problem);
        if (ok) fail_msg("`%s` was accepted", rows[i].text);
        if (strcmp(problem.text, rows[i].wanted) != 0 || problem.at != rows[i].at)
            fail_msg("`%s`: %zu \"%s\", expected %zu \"%s\"", rows[i].text, problem.at, problem.text, rows[i].at,
                     rows[i].wanted);
    }
}

static void long_texts(void **state) {
    (void)state;
    const tr_dim number = TR_DIM_NUMBER;
    char text[TR_EXPRESSION_LENGTH + 2];
    double v;
    tr_problem problem;
    for (size_t i = 0; i < TR_EXPRESSION_LENGTH; i++)
        text[i] = "1m/"[i % 3]; /* the densest: an operand in 1.5 characters */
    text[TR_EXPRESSION_LENGTH - 1] = ' ';
    text[TR_EXPRESSION_LENGTH - 2] = '1';
    text[TR_EXPRESSION_LENGTH] = '\0';
    assert_false(value(text, number, &v, &problem));
    assert_non_null(strstr(problem.text, "wrong dimension"));
    memset(text, '(', TR_EXPRESSION_LENGTH);
    assert_false(value(text, number, &v, &problem));
    memset(text, '1', TR_EXPRESSION_LENGTH + 1);
    text[TR_EXPRESSION_LENGTH + 1] = '\0';
    assert_false(value(text, number, &v, &problem));
    assert_string_equal(problem.text, "this value is longer than 200 characters");
}

/* Every row: the printed unit has the row's dimension, and no key means two things. */
static void rows_agree_with_units(void **state) {
    (void)state;
    for (int i = 0; i < tr_n_sections; i++) {
        for (int k = 0; k < tr_sections[i].n; k++) {
            const tr_param *p = &tr_sections[i].params[k];
            double v;
            tr_problem problem;
            char text[64], buffer[TR_BY_SHAPE];
            assert_false(tr_expression_reserved(p->key));
            for (tr_shape shape = TR_SHAPE_DISK; p->type == TR_REAL && shape <= TR_SHAPE_SPHERE; shape++) {
                const char *unit = tr_param_by_shape(p->unit, shape, buffer);
                snprintf(text, sizeof text, strcmp(unit, "1") == 0 ? "%s" : "1 %s", unit);
                if (!value(text, tr_dim_of(p->dim, shape), &v, &problem))
                    fail_msg("%s: `%s` %s", p->key, text, problem.text);
                assert_close(v, 1, 0, 0);
            }
        }
    }
    char all[] = TR_EXPRESSION_UNITS;
    for (char *unit = strtok(all, " "); unit; unit = strtok(NULL, " ")) assert_true(tr_expression_reserved(unit));
}

int main(void) {
    tr_status st = {0};
    parser = tr_expression_new(&st);
    const struct CMUnitTest tests[] = {cmocka_unit_test(accepts), cmocka_unit_test(functions_are_the_portable_ones),
                                       cmocka_unit_test(refuses), cmocka_unit_test(long_texts),
                                       cmocka_unit_test(rows_agree_with_units)};
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    tr_expression_free(parser);
    return failed;
}
