/* SPDX-License-Identifier: MIT */
/* The data of the threads during the forces of a step; see shares.h. */
#ifndef TR_SHARES_MEMORY_H
#define TR_SHARES_MEMORY_H

#include "base/vector.h"
#include "laws/law.h"
#include <stdint.h>

/* The part of a tile in the sums over all. */
typedef struct tr_share_sums {
    double virial[2], lost[3], made[TR_N_SLOTS]; /* lost, made: of the ledger */
    int touching;
    bool mixed; /* the tile has disks of an earlier thread */
} tr_share_sums;

/* A part of the force on a disk that waits for its turn. */
typedef struct tr_share_late {
    tr_quad force;
    int disk;
} tr_share_late;

typedef struct tr_share_part {
    tr_tile tile;
    tr_share_late *late;
    int n_late, capacity;
} tr_share_part;

typedef struct tr_shares {
    int threads, tiles;  /* that the rest is for */
    int64_t list;        /* and the number of the list */
    uint16_t *owner;     /* of each disk the first thread that has a contact of it */
    tr_share_sums *sums; /* of each tile */
    int n_sums;          /* room */
    tr_share_part *part; /* of each thread */
    double dt;           /* of this step */
} tr_shares;

void tr_shares_free(tr_shares *shares);

/* Of n disks. */
size_t tr_shares_bytes(const tr_shares *shares, int n);

#endif
