/* SPDX-License-Identifier: MIT */

#include "out/summary_read.h"

#include "base/regular.h"
#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const json_t *item(const json_t *array, const char *key) {
    bool number = *key && strspn(key, "0123456789") == strlen(key);
    return number ? json_array_get(array, strtoul(key, NULL, 10)) : NULL;
}

/* "checks.0.measured": keys of objects, numbers of items. */
static const json_t *find(const json_t *at, const char *name) {
    char key[64];
    for (;;) {
        size_t n = strcspn(name, ".");
        if (n >= sizeof key) return NULL;
        memcpy(key, name, n), key[n] = '\0';
        at = json_is_array(at) ? item(at, key) : json_object_get(at, key);
        if (!at || !name[n]) return at;
        name += n + 1;
    }
}

/* NULL: it does not exist or is incomplete. With TR_FILE: it cannot be read. */
static json_t *load(const char *path, tr_status *st) {
    FILE *file = tr_regular_open(path, st);
    if (!file) return NULL;
    errno = 0;
    json_t *o = json_loadf(file, 0, NULL);
    if (ferror(file) || errno == ENOMEM)
        tr_status_fail(st, TR_FILE, "error: cannot read %.300s: %s", path, strerror(errno));
    fclose(file);
    if (st->code) json_decref(o), o = NULL;
    return o;
}

static bool is_number(const json_t *value) {
    return json_is_number(value) || json_is_null(value);
}

bool tr_summary_read(const char *path, const char *name, double *value, tr_status *st) {
    json_t *o = load(path, st);
    if (!o) return tr_status_fail(st, TR_FILE, "error: cannot read %.300s: it does not exist, or is incomplete", path);
    const json_t *number = find(o, name);
    bool ok = is_number(number);
    *value = json_is_number(number) ? json_number_value(number) : NAN;
    json_decref(o);
    return ok || tr_status_fail(st, TR_BAD_CASE, "error: %.300s has no number `%.60s`", path, name);
}

bool tr_summary_version(const char *path, char version[TR_SUMMARY_VERSION], tr_status *st) {
    json_t *o = load(path, st);
    const char *text = json_string_value(json_object_get(o, "version"));
    snprintf(version, TR_SUMMARY_VERSION, "%s", text ? text : "");
    json_decref(o);
    return !st->code;
}

bool tr_summary_failed(const char *path, int *n, tr_status *st) {
    json_t *o = load(path, st), *check;
    size_t i;
    *n = 0;
    json_array_foreach(json_object_get(o, "checks"), i, check) *n += json_is_false(json_object_get(check, "ok"));
    json_decref(o);
    return !st->code;
}

typedef struct listing {
    void (*take)(void *context, const char *name);
    void *context;
} listing;

/* name has room for one more key, at `used`. */
static void list(const listing *l, json_t *at, char name[TR_SUMMARY_NAME], size_t used) {
    const char *key;
    json_t *value;
    size_t i;
    if (is_number(at)) l->take(l->context, name);
    json_object_foreach(at, key, value) {
        snprintf(name + used, TR_SUMMARY_NAME - used, "%s%s", used ? "." : "", key);
        list(l, value, name, strlen(name));
    }
    json_array_foreach(at, i, value) {
        snprintf(name + used, TR_SUMMARY_NAME - used, ".%zu", i);
        list(l, value, name, strlen(name));
    }
}

bool tr_summary_numbers(const char *text, void (*take)(void *context, const char *name), void *context, tr_status *st) {
    char name[TR_SUMMARY_NAME] = "";
    json_t *o = json_loads(text, 0, NULL);
    if (!o) return tr_status_fail(st, TR_FILE, "error: out of memory (summary)");
    list(&(listing){take, context}, o, name, 0);
    json_decref(o);
    return true;
}
