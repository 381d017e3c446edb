/* SPDX-License-Identifier: MIT */
/* CSV tables: the names of a row's cells are the header, so a column is written once. */
#ifndef TR_TABLE_H
#define TR_TABLE_H

#include "core/biaxial.h"
#include "core/bodies.h"
#include "core/increments.h"
#include "core/ledger.h"
#include "core/measures.h"
#include "out/dir.h"

typedef struct tr_cell {
    char name[40]; /* with the unit: "stress_1_Pa" */
    double value;
} tr_cell;

enum { TR_MAX_CELLS = 64 };

typedef struct tr_row {
    tr_shape shape; /* of the bodies: chooses the units in the names */
    int n;
    tr_cell cell[TR_MAX_CELLS];
} tr_row;

/* name_format: see tr_param_by_shape. A row of more than TR_MAX_CELLS is not written: that fails. */
void tr_row_add(tr_row *row, double value, const char *name_format, ...) __attribute__((format(printf, 3, 4)));

/* The column of a quantity with its unit behind: "P", "N/m|N" is P_N_per_m or P_N. */
void tr_row_add_in(tr_row *row, double value, const char *name, const char *unit);

/* Every number of every table goes through here. What is not finite has no number: an empty cell. */
void tr_cell_put(FILE *file, double value, int digits);

/* Writes the names, if the file is empty: a table without rows has a header too. */
void tr_row_header(const tr_row *row, tr_file *file);

/* Writes the header first when it is the first row of the file. */
bool tr_row_write(const tr_row *row, tr_file *file, tr_status *st);

/* The same with 17 digits, which read back to the same bits. */
bool tr_row_write_exact(const tr_row *row, tr_file *file, tr_status *st);

/* One row of history.csv of a biaxial test; energy may be NULL. */
void tr_row_biaxial(tr_row *row, const tr_biaxial_state *state, const tr_measures *measures, const tr_energy *energy);

/* Further cells of it, with output.increments. R: mean radius of the disks [m]. */
void tr_row_increments(tr_row *row, const tr_increments_state *state, double R);

/* The cells of a row of contacts.csv: every touching contact is one. strain < 0: bodies have none. */
void tr_row_contact(tr_row *row, double time, double strain, const tr_record *record);

/* Further cells of it, with output.increments. */
void tr_row_increment(tr_row *row, const tr_increment *increment);

/* One row of disks.csv of a biaxial test. v_r: mean |V_r| over its touching contacts [m/s], of which there are
 * `ends`. */
void tr_row_sample(tr_row *row, double time, double strain, const tr_world *world, int i, double v_r, int ends);

/* The cells of a row of history.csv of bodies: one disk. */
void tr_row_disk(tr_row *row, double time, const tr_world *world, int disk);

#endif
