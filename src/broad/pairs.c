/* SPDX-License-Identifier: MIT */
/* The list of pairs, and brute force: every pair looked at, in order. */
#include "broad/broad_internal.h"

#include "base/alloc.h"
#include "base/lanes.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>

bool tr_pairs_reserve(tr_pairs *pairs, size_t n, tr_status *st) {
    size_t now = (size_t)pairs->n, grown = n + n / 2 + 64;
    if (n <= (size_t)pairs->capacity) return true;
    if (grown > INT_MAX) return tr_status_fail(st, TR_FILE, "error: too many pairs of disks (%zu)", n);
    if (!tr_alloc_grow(&pairs->a, now, grown, sizeof *pairs->a, st)) return false;
    if (!tr_alloc_grow(&pairs->b, now, grown, sizeof *pairs->b, st)) return false;
    pairs->capacity = (int)grown;
    return true;
}

bool tr_pairs_add(tr_pairs *pairs, int a, int b, tr_status *st) {
    if (!tr_pairs_reserve(pairs, (size_t)pairs->n + 1, st)) return false;
    pairs->a[pairs->n] = a;
    pairs->b[pairs->n++] = b;
    return true;
}

void tr_pairs_free(tr_pairs *pairs) {
    free(pairs->a);
    free(pairs->b);
    *pairs = (tr_pairs){0};
}

bool tr_broad_check(const tr_broad_input *input, tr_status *st) {
    for (int i = 0; i < input->n; i++) {
        const double *p = input->pos + tr_body(i);
        if (!(isfinite(p[0]) && isfinite(p[1]) && isfinite(p[3])))
            return tr_status_fail(st, TR_NUMERICAL, "error: position of disk %d is not finite (%g, %g)", i, p[0], p[1]);
    }
    return true;
}

bool tr_broad_near(const tr_broad_input *input, int a, int b) {
    const double *p = input->pos + tr_body(a), *q = input->pos + tr_body(b);
    double dx = q[0] - p[0], dy = q[1] - p[1], reach = p[3] + q[3] + input->skin;
    if (input->cell) {
        dx += tr_broad_image(p[0], q[0], input->cell[0]) * input->cell[0];
        dy += tr_broad_image(p[1], q[1], input->cell[1]) * input->cell[1];
    }
    return dx * dx + dy * dy < reach * reach;
}

static void *brute_create(const tr_broad_input *input, tr_status *st) {
    (void)input;
    return tr_alloc(1, 1, st); /* no state, but NULL would mean failure */
}

static bool brute_find(void *finder, const tr_broad_input *input, tr_pairs *pairs, tr_status *st) {
    (void)finder;
    if (!tr_broad_check(input, st)) return false;
    pairs->n = 0;
    for (int a = 0; a < input->n; a++)
        for (int b = a + 1; b < input->n; b++)
            if (tr_broad_near(input, a, b) && !tr_pairs_add(pairs, a, b, st)) return false;
    return true;
}

const tr_broad_finder tr_broad_brute = {"brute-force", brute_create, brute_find, free};
