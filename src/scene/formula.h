/* SPDX-License-Identifier: MIT */
/* muParser behind a C interface: an arithmetic text over the variables v0, v1, ... to a number. muParser reports
 * errors, and a lack of memory, by exceptions; none of them leaves formula.cpp. */
#ifndef TR_FORMULA_H
#define TR_FORMULA_H

#include "base/status.h"

typedef struct tr_formula tr_formula;

/* values: of v0 to v<n-1>; read at each evaluation, so they must live as long. NULL and TR_FILE: out of memory. */
tr_formula *tr_formula_new(double *values, int n, tr_status *st);
void tr_formula_free(tr_formula *f);

typedef enum tr_formula_end { TR_FORMULA_DONE, TR_FORMULA_WRONG, TR_FORMULA_NO_MEMORY } tr_formula_end;

/* The text to evaluate from now on. An error in it may show only at the evaluation. */
tr_formula_end tr_formula_set(tr_formula *f, const char *text);
tr_formula_end tr_formula_evaluate(tr_formula *f, double *value);

#endif
