/* SPDX-License-Identifier: MIT */
/* The data of the threads during the forces of a step; see parallel_forces.h. */
#ifndef TR_PARALLEL_MEMORY_H
#define TR_PARALLEL_MEMORY_H

#include "base/vector.h"
#include "laws/law.h"
#include <stdint.h>

/* The part of a tile in the sums over all. */
typedef struct tr_parallel_sums {
    double virial[2], lost[3], made[TR_N_LAW_KINDS]; /* lost, made: of the ledger */
    int touching;
    bool mixed; /* the tile has disks of an earlier thread */
} tr_parallel_sums;

/* A part of the force on a disk that waits for its turn. */
typedef struct tr_parallel_deferred {
    tr_quad force;
    int disk;
} tr_parallel_deferred;

typedef struct tr_parallel_thread {
    tr_tile tile;
    tr_parallel_deferred *late;
    int n_late, capacity;
} tr_parallel_thread;

typedef struct tr_parallel {
    int threads, tiles;       /* that the rest is for */
    int64_t list;             /* and the number of the list */
    uint16_t *owner;          /* of each disk the first thread that has a contact of it */
    tr_parallel_sums *sums;   /* of each tile */
    int n_sums;               /* room */
    tr_parallel_thread *part; /* of each thread */
    double dt;                /* of this step */
} tr_parallel;

void tr_parallel_free(tr_parallel *shares);

/* Of n disks. */
size_t tr_parallel_bytes(const tr_parallel *shares, int n);

#endif
