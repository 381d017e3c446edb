/* SPDX-License-Identifier: MIT */
/* Pair finding: which disks are closer than a skin. Two finders behind one row: Box2D's tree, and brute force (the
 * oracle, and all that a handful of disks needs). No physics. */
#ifndef TR_BROAD_H
#define TR_BROAD_H

#include "base/status.h"

typedef struct tr_pairs {
    int n, capacity;
    int *a, *b; /* a < b, sorted by (a, b), no doubles */
} tr_pairs;

/* pos: n*4 doubles, x y . R of each disk [m]. All must be finite: TR_NUMERICAL names the disk that is not. */
typedef struct tr_broad_input {
    int n;
    const double *pos;
    double skin; /* pairs with gap |X21| - R1 - R2 < skin are wanted, no others are given [m] */
} tr_broad_input;

typedef struct tr_broad_finder {
    const char *name;
    void *(*create)(const tr_broad_input *input, tr_status *st); /* NULL on failure */
    bool (*find)(void *finder, const tr_broad_input *input, tr_pairs *pairs, tr_status *st);
    void (*destroy)(void *finder);
} tr_broad_finder;

extern const tr_broad_finder tr_broad_brute, tr_broad_box2d;

/* The finder for n disks: brute force up to 32, else Box2D. */
const tr_broad_finder *tr_broad_choose(int n);

/* Appends a pair; grows the arrays. */
bool tr_pairs_add(tr_pairs *pairs, int a, int b, tr_status *st);
void tr_pairs_free(tr_pairs *pairs);

#endif
