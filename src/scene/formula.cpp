/* SPDX-License-Identifier: MIT */
/* The only user of muParser. Its own C interface lets exceptions through, so this file replaces it. */
extern "C" {
#include "base/math.h"
#include "scene/formula.h"
}
#include <muParser.h>
#include <new>
#include <string>

struct tr_formula {
    mu::Parser parser;
};

namespace {

double add(double x, double y) {
    return x + y;
}
double subtract(double x, double y) {
    return x - y;
}
double multiply(double x, double y) {
    return x * y;
}
double divide(double x, double y) {
    return x / y;
}

/* muParser's own ^ and functions are those of the C library. A built-in operator cannot be replaced alone. */
void define(mu::Parser &parser) {
    parser.EnableBuiltInOprt(false);
    parser.DefineOprt("+", add, mu::prADD_SUB);
    parser.DefineOprt("-", subtract, mu::prADD_SUB);
    parser.DefineOprt("*", multiply, mu::prMUL_DIV);
    parser.DefineOprt("/", divide, mu::prMUL_DIV);
    parser.DefineOprt("^", tr_pow, mu::prPOW, mu::oaRIGHT);
    parser.DefineFun("exp", tr_exp);
    parser.DefineFun("sin", tr_sin);
    parser.DefineFun("cos", tr_cos);
    parser.DefineFun("tan", tr_tan);
    parser.DefineFun("atan", tr_atan);
}

/* Does the work; tells how it ended, whatever was thrown. */
template <typename Work> tr_formula_end guarded(Work work) {
    try {
        work();
        return TR_FORMULA_DONE;
    } catch (const std::bad_alloc &) {
        return TR_FORMULA_NO_MEMORY;
    } catch (...) {
        return TR_FORMULA_WRONG;
    }
}

} // namespace

extern "C" tr_formula *tr_formula_new(double *values, int n, tr_status *st) {
    tr_formula *f = nullptr;
    tr_formula_end end = guarded([&] {
        f = new tr_formula;
        define(f->parser);
        for (int i = 0; i < n; i++) f->parser.DefineVar("v" + std::to_string(i), &values[i]);
    });
    if (end == TR_FORMULA_DONE) return f;
    tr_formula_free(f);
    tr_status_fail(st, TR_FILE, "error: out of memory");
    return nullptr;
}

extern "C" void tr_formula_free(tr_formula *f) {
    delete f;
}

extern "C" tr_formula_end tr_formula_set(tr_formula *f, const char *text) {
    return guarded([&] { f->parser.SetExpr(text); });
}

extern "C" tr_formula_end tr_formula_evaluate(tr_formula *f, double *value) {
    return guarded([&] { *value = f->parser.Eval(); });
}
