/* SPDX-License-Identifier: MIT */
/* The table that trundle identify reads: states of two bodies and what a code answered. */
#ifndef TR_STUDY_IDENTIFY_READ_H
#define TR_STUDY_IDENTIFY_READ_H

#include "study/measures.h"

/* Columns beside those of tr_motion; a cell that is empty is not answered. In the order of tr_identify_columns. */
enum {
    TR_CELL_V_R,
    TR_CELL_V_S,
    TR_CELL_M1,
    TR_CELL_M2,
    TR_CELL_F_T,
    TR_CELL_T1,
    TR_CELL_T2,
    TR_CELL_ARM1,
    TR_CELL_ARM2,
    TR_CELL_CAP,
    TR_CELL_F_N,
    TR_CELL_K_ROLL,
    TR_CELL_K_T,
    TR_CELL_MU_R,
    TR_CELL_TIME,
    TR_CELLS
};

typedef struct tr_identify_column {
    const char *name, *unit, *doc;
} tr_identify_column;
extern const tr_identify_column tr_identify_columns[TR_CELLS];

typedef struct tr_identify_row {
    long line;
    tr_motion motion;
    double length;         /* distance of the centres, or of the disk from the wall [m] */
    double cell[TR_CELLS]; /* NAN: not answered */
} tr_identify_row;

/* What the file calls a column: --map MINE=OURS. */
enum { TR_IDENTIFY_MAPS = 40, TR_IDENTIFY_ROWS = 20000 };
typedef struct tr_identify_map {
    int n;
    const char *mine[TR_IDENTIFY_MAPS], *ours[TR_IDENTIFY_MAPS];
} tr_identify_map;

typedef struct tr_identify_table {
    const char *path;
    const tr_identify_map *map;
    int n, capacity;
    tr_identify_row *row; /* owned */
    bool is_there[TR_CELLS];
} tr_identify_table;

/* False where no column of ours is called so. */
bool tr_identify_is_ours(const char *name);
/* The name in the file of a cell's column. */
const char *tr_identify_name(const tr_identify_table *table, int cell);
/* Overlap of a row [m]; below 0: a gap. */
double tr_identify_overlap(const tr_identify_row *row);

/* Reads table->path with table->map into the empty rest. TR_BAD_CASE with "path:line: error: ...", or TR_FILE. */
bool tr_identify_read(tr_identify_table *table, tr_status *st);

#endif
