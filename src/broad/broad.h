/* SPDX-License-Identifier: MIT */
/* Pair finding: which disks are closer than a skin. Two finders behind one row: Box2D's tree, and brute force (the
 * oracle, and enough for a handful of disks). No physics.
 *
 * In a periodic cell a pair is a disk and the nearest image of the other one. Each side of the cell must be longer than
 * 2 (2 r_max + skin), so that no other image is near. The caller ensures this. Centres are in one cell, edges included.
 */
#ifndef TR_BROAD_H
#define TR_BROAD_H

#include "base/status.h"
#include "base/threads.h"
#include <math.h>
#include <stddef.h>

typedef struct tr_pairs {
    int n, capacity;
    int *a, *b; /* a < b, sorted by (a, b), no doubles */
} tr_pairs;

/* pos: n*4 doubles, x y . R of each disk [m]. All must be finite: TR_NUMERICAL names the disk that is not. */
typedef struct tr_broad_input {
    int n;
    const double *pos;
    double skin;        /* exactly the pairs with gap |X21| - R1 - R2 < skin are found [m] */
    const double *cell; /* two sides of the periodic cell [m]; NULL: no cell */
    tr_threads *threads; /* threads for the work; NULL: one */
} tr_broad_input;

typedef struct tr_broad_finder {
    const char *name;
    void *(*create)(const tr_broad_input *input, tr_status *st); /* NULL on failure */
    bool (*find)(void *finder, const tr_broad_input *input, tr_pairs *pairs, tr_status *st);
    void (*destroy)(void *finder);
} tr_broad_finder;

extern const tr_broad_finder tr_broad_brute, tr_broad_box2d;

/* Number of the image of q that is nearest to p, along one axis: it is at q + image*side. */
static inline double tr_broad_image(double p, double q, double side) {
    return -rint((q - p) / side);
}

/* Appends a pair; grows the arrays. */
bool tr_pairs_add(tr_pairs *pairs, int a, int b, tr_status *st);

/* Room for n pairs in all; TR_FILE when memory is short. */
bool tr_pairs_reserve(tr_pairs *pairs, size_t n, tr_status *st);
void tr_pairs_free(tr_pairs *pairs);

#endif
