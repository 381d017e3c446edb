/* SPDX-License-Identifier: MIT */
/* The table that `trundle identify` reads. What it says has no NaN. */
#include "fuzz.h"
#include "study/identify.h"
#include "study/identify_words.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const tr_identify_map none = {0};
    tr_status st = {0};
    char *text = NULL;
    size_t n;
    tr_identify *work = calloc(1, sizeof *work);
    FILE *out = open_memstream(&text, &n);
    work->table.path = fuzz_file("identify.csv", data, size), work->table.map = &none;
    if (tr_identify_make(work, &st)) tr_identify_print(out, work), tr_identify_write(out, work);
    fclose(out);
    if (strstr(text, "nan")) fputs(text, stderr), abort();
    tr_identify_free(work);
    free(work), free(text);
    return 0;
}
