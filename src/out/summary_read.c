/* SPDX-License-Identifier: MIT */
#include "out/summary.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* "checks.0.measured": keys of objects, numbers of items. */
static const json_t *find(const json_t *at, const char *name) {
    char key[64];
    while (at && *name) {
        size_t n = strcspn(name, ".");
        snprintf(key, sizeof key, "%.*s", (int)n, name);
        at = json_is_array(at) ? json_array_get(at, (size_t)atoi(key)) : json_object_get(at, key);
        name += n + (name[n] == '.');
    }
    return at;
}

bool tr_summary_read(const char *path, const char *name, double *value, tr_status *st) {
    json_error_t error;
    json_t *o = json_load_file(path, 0, &error);
    if (!o) return tr_status_fail(st, TR_FILE, "error: cannot read %.300s: %s", path, error.text);
    const json_t *number = find(o, name);
    bool ok = json_is_number(number) || json_is_null(number);
    *value = json_is_number(number) ? json_number_value(number) : NAN;
    json_decref(o);
    return ok || tr_status_fail(st, TR_BAD_CASE, "error: %.300s has no number `%.60s`", path, name);
}
