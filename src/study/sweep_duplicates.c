/* SPDX-License-Identifier: MIT */
/* One value in two spellings, `0.5` and `1/2`, would run twice and count twice. Two values of a key are equal if their
 * cases are equal for all values of the other keys. This includes a key without effect, which `set` overrides. */

#include "study/sweep_duplicates.h"

#include "base/alloc.h"
#include "base/hash.h"
#include "laws/law.h"
#include "scene/write.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of the resolved case, its numbers to 14 digits: `30 deg` and `pi/6` differ by rounding. 0: these values make no case;
 * the run says why. */
static uint64_t hash_case(const tr_grid *g, int point) {
    tr_scene scene;
    tr_status ignored = {0};
    uint64_t hash = TR_HASH_BEGIN;
    if (!tr_grid_scene(g, point, &scene, &ignored)) return 0;
    char *text = tr_scene_write(&scene, tr_laws_catalog(), &ignored), number[32], *end;
    for (const char *p = text; p && *p; p = end) {
        bool digit = strchr("0123456789", *p) && (p == text || strchr(" -[,", p[-1]));
        end = (char *)p + 1;
        if (digit) snprintf(number, sizeof number, "%.14g", strtod(p, &end));
        if (*p != ' ') hash = digit ? tr_hash(hash, number, strlen(number)) : tr_hash(hash, p, 1);
    }
    free(text);
    tr_scene_free(&scene);
    return text ? hash : 0;
}

typedef struct hashed {
    uint64_t hash;
    int value;
} hashed;

static int compare(const void *a, const void *b) {
    const hashed *p = a, *q = b;
    return p->hash != q->hash ? (p->hash > q->hash) - (p->hash < q->hash) : p->value - q->value;
}

static bool always_equal(const tr_grid *g, int axis, int one, int two) {
    for (int i = 0; i < g->combinations; i++)
        if (tr_grid_value(g, i, axis) == one && hash_case(g, i) != hash_case(g, tr_grid_with(g, i, axis, two)))
            return false;
    return true;
}

static bool check_axis(const tr_grid *g, int axis, tr_status *st) {
    const tr_axis *a = &g->axis[axis];
    hashed *h = tr_alloc((size_t)a->n, sizeof *h, st);
    for (int i = 0; h && i < a->n; i++) h[i] = (hashed){hash_case(g, tr_grid_with(g, 0, axis, i)), i};
    if (h) qsort(h, (size_t)a->n, sizeof *h, compare);
    for (int i = 1; h && !st->code && i < a->n; i++) {
        int one = h[i - 1].value, two = h[i].value;
        if (h[i].hash && h[i].hash == h[i - 1].hash && always_equal(g, axis, one, two))
            tr_text_fail(st, a->mark[two], "`%s` and `%s` of `%s` make the same case: give one of them",
                         tr_text_show(a->value[one]).text, tr_text_show(a->value[two]).text, tr_text_show(a->key).text);
    }
    free(h);
    return !st->code;
}

bool tr_grid_check_duplicates(const tr_grid *g, tr_status *st) {
    for (int axis = 0; axis < g->n_vary; axis++)
        if (!check_axis(g, axis, st)) return false;
    return true;
}
