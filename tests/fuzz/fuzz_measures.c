/* SPDX-License-Identifier: MIT */
/* The table that `trundle measures` reads. No number that comes out may be NaN. */
#include "fuzz.h"
#include "laws/kinematics.h"
#include "study/measures.h"

/* The numbers of the last row. What is before them may be any text. */
static const char *last_numbers(const char *text) {
    const char *p = text + strlen(text);
    for (int commas = 0; p > text && commas < TR_MOTION_COLUMNS + tr_measures_columns() + 3 * tr_n_arms_measured; p--)
        commas += p[-1] == ',';
    return p;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    tr_status st = {0};
    char *text = NULL;
    size_t n;
    FILE *out = open_memstream(&text, &n);
    bool ok = tr_measures_csv(fuzz_file("measures.csv", data, size), true, out, &st);
    fclose(out);
    if (ok && strstr(last_numbers(text), "nan")) fputs(text, stderr), abort();
    free(text);
    return 0;
}
