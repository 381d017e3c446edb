/* SPDX-License-Identifier: MIT */
#include "study/identify_read.h"

#include "base/alloc.h"
#include "study/csv.h"
#include "base/math.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const tr_identify_column tr_identify_columns[TR_CELLS] = {
    {"V_r", "m/s or rad/s", "rolling velocity"},
    {"V_s", "m/s", "sliding velocity"},
    {"M1", "N m", "moment of the rolling law on 1, counter-clockwise"},
    {"M2", "N m", "the same on 2"},
    {"F_t", "N", "friction, as force -F_t t on 2 and F_t t on 1"},
    {"T1", "N m", "torque of friction on 1, counter-clockwise"},
    {"T2", "N m", "the same on 2"},
    {"arm1", "m", "arm of friction on 1, -T1/F_t"},
    {"arm2", "m", "the same on 2"},
    {"cap", "m", "greatest |M1| over mu_r F_n"},
    {"F_n", "N", "normal force"},
    {"k_roll", "N/m", "stiffness of the rolling spring; 0: there is none (default 1)"},
    {"k_t", "N/m", "stiffness of the sliding spring; 0: there is none (default 1)"},
    {"mu_r", "1", "coefficient of the bound on |M1|; 0: there is none"},
    {"time", "s", "how long the motion has lasted since the contact was new (default 1)"},
};

enum { ALL = TR_MOTION_COLUMNS + TR_CELLS };

static const char *ours(int k) {
    return k < TR_MOTION_COLUMNS ? tr_motion_columns[k].name : tr_identify_columns[k - TR_MOTION_COLUMNS].name;
}

bool tr_identify_is_ours(const char *name) {
    int k = 0;
    while (k < ALL && strcmp(ours(k), name)) k++;
    return k < ALL;
}

static const char *in_file(const tr_identify_map *map, const char *name) {
    for (int i = 0; i < map->n; i++)
        if (!strcmp(map->ours[i], name)) return map->mine[i];
    return name;
}

const char *tr_identify_name(const tr_identify_table *table, int cell) {
    return in_file(table->map, tr_identify_columns[cell].name);
}

double tr_identify_overlap(const tr_identify_row *row) {
    const tr_motion *m = &row->motion;
    return (isinf(m->R1) ? m->R2 : m->R1 + m->R2) - row->length;
}

/* ---- rows in */

typedef struct reader {
    tr_identify_table *table;
    tr_identify_row row; /* being read */
} reader;

static void clear(tr_identify_row *row) {
    *row = (tr_identify_row){0};
    for (int k = 0; k < TR_CELLS; k++) row->cell[k] = NAN;
}

static bool cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    reader *r = context;
    (void)length;
    const char *name = in_file(r->table->map, ours(column));
    bool answer = column >= TR_MOTION_COLUMNS, radius = column < 2;
    double v = NAN;
    if (answer && !*text) return true;
    if (answer && (!strcasecmp(text, "nan") || !strcasecmp(text, "NA")))
        return tr_csv_fail(csv, csv->line, "%s is %s: leave the cell empty where the code does not answer", name, text);
    if (!tr_csv_number(csv, name, text, radius, &v)) return false;
    if (fabs(v) > 1e50 && !radius) return tr_csv_fail(csv, csv->line, "%s is %g, which is too large", name, v);
    if (answer) {
        r->row.cell[column - TR_MOTION_COLUMNS] = v, r->table->is_there[column - TR_MOTION_COLUMNS] = true;
        return true;
    }
    if (radius && !(v > 0))
        return tr_csv_fail(csv, csv->line, "%s is %g: a radius is above 0%s", name, v,
                           column == 0 ? " (a wall has R1 = inf)" : "");
    if (isinf(v) && column == 1) return tr_csv_fail(csv, csv->line, "%s is inf: only body 1 can be a wall", name);
    memcpy((char *)&r->row.motion + tr_motion_columns[column].offset, &v, sizeof v);
    return true;
}

/* Products of lengths and velocities stay finite. */
static const double LARGE = 1e12;
static bool in_range(double length) {
    return length >= 1 / LARGE && length <= LARGE;
}

/* Stiffnesses, coefficients and times of a row that makes no sense. */
static bool check_springs(const reader *r, tr_csv *csv) {
    static const int not_below_0[] = {TR_CELL_K_ROLL, TR_CELL_K_T, TR_CELL_MU_R, TR_CELL_F_N, TR_CELL_TIME};
    for (int i = 0; i < (int)(sizeof not_below_0 / sizeof *not_below_0); i++) {
        int k = not_below_0[i];
        if (r->row.cell[k] < 0 || (k == TR_CELL_TIME && r->row.cell[k] == 0))
            return tr_csv_fail(csv, csv->row_line, "%s is %g: it must be %s 0", tr_identify_name(r->table, k),
                               r->row.cell[k], k == TR_CELL_TIME ? "above" : "at least");
    }
    return true;
}

static bool row(void *context, tr_csv *csv) {
    reader *r = context;
    tr_identify_table *t = r->table;
    const tr_motion *m = &r->row.motion;
    r->row.line = csv->row_line;
    r->row.length = tr_hypot(m->x2x - m->x1x, m->x2y - m->x1y);
    if (!in_range(m->R2) || (!isinf(m->R1) && !in_range(m->R1)) || r->row.length > LARGE)
        return tr_csv_fail(csv, csv->row_line,
                           "radii are %.3g m and %.3g m, the centres %.3g m apart: only %g m to %g m", m->R1, m->R2,
                           r->row.length, 1 / LARGE, LARGE);
    if (!(r->row.length > 0))
        return tr_csv_fail(csv, csv->row_line, "the centres coincide: there is no line of centres");
    if (!check_springs(r, csv)) return false;
    if (t->n == TR_IDENTIFY_ROWS)
        return tr_csv_fail(csv, csv->row_line, "more than %d rows; a few hundred different ones tell all there is",
                           TR_IDENTIFY_ROWS);
    if (t->n == t->capacity) {
        int more = t->capacity ? 2 * t->capacity : 256;
        if (!tr_alloc_grow(&t->row, (size_t)t->n, (size_t)more, sizeof *t->row, csv->st)) return false;
        t->capacity = more;
    }
    t->row[t->n++] = r->row;
    clear(&r->row);
    return true;
}

/* ---- what is wrong with the file as a whole */

/* A file of another program, by how it begins. */
static bool check_kind(const char *path, tr_status *st) {
    static const struct {
        const char *start, *what;
    } others[] = {
        {"ITEM:", "a dump of LAMMPS or LIGGGHTS"},
        {"# vtk", "a file of VTK"},
        {"<?xml", "an XML file (VTK writes such)"},
        {"LAMMPS", "a data file or a log of LAMMPS"},
        {"{", "a JSON file"},
        {"kind:", "a case of trundle"},
        {"PK", "a ZIP file (a spreadsheet?)"},
    };
    char head[8] = "";
    FILE *in = fopen(path, "r");
    if (!in) return true; /* told by the reader */
    size_t n = fread(head, 1, sizeof head - 1, in);
    fclose(in);
    head[n] = '\0';
    for (int k = 0; k < (int)(sizeof others / sizeof *others); k++)
        if (!strncmp(head, others[k].start, strlen(others[k].start)))
            return tr_status_fail(
                st, TR_BAD_CASE,
                "%s:1: error: this is %s; needed is a table in CSV whose first line names the columns: "
                "R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2 and answers (trundle identify --help)",
                path, others[k].what);
    return true;
}

static bool check_answers(const tr_identify_table *t, tr_status *st) {
    static const int answers = TR_CELL_F_N; /* those before it */
    for (int k = 0; k < answers; k++)
        if (t->is_there[k]) return true;
    return tr_status_fail(
        st, TR_BAD_CASE,
        "%s:1: error: no row has an answer: add a column V_r, V_s, M1, M2, F_t, T1, T2, arm1, arm2 or "
        "cap, or say which of yours it is (--map MINE=V_r)",
        t->path);
}

/* Radii and centres in other units, or none that touch where forces were answered. */
static bool check_touching(const tr_identify_table *t, tr_status *st) {
    double least = INFINITY, most = 0;
    bool touches = false, forces = false;
    for (int i = 0; i < t->n; i++) {
        const tr_motion *m = &t->row[i].motion;
        double part = t->row[i].length / (isinf(m->R1) ? m->R2 : m->R1 + m->R2);
        least = fmin(least, part), most = fmax(most, part);
        touches |= part < 1;
    }
    for (int k = TR_CELL_M1; k <= TR_CELL_CAP; k++) forces |= t->is_there[k];
    if (least > 10 || most < 0.1)
        return tr_status_fail(
            st, TR_BAD_CASE,
            "%s:%ld: error: the centres are %.3g times R1+R2 apart (in all rows %.3g to %.3g): do R1, R2 "
            "and x1x...x2y have one unit, and are R1, R2 radii? All are in m",
            t->path, t->row[0].line, t->row[0].length / (t->row[0].motion.R1 + t->row[0].motion.R2), least, most);
    if (touches || !forces) return true;
    return tr_status_fail(
        st, TR_BAD_CASE,
        "%s:%ld: error: in no row do the two touch (the distance of the centres is %.6g to %.6g times "
        "R1+R2), so no code has a force; add rows with overlap, as of trundle measures --card",
        t->path, t->row[0].line, least, most);
}

bool tr_identify_read(tr_identify_table *t, tr_status *st) {
    const char *columns[ALL];
    for (int k = 0; k < ALL; k++) columns[k] = in_file(t->map, ours(k));
    const tr_csv_format format = {columns, ALL, TR_MOTION_COLUMNS, "R1,R2,x1x,...,w1,w2,V_r,V_s,M1,M2", NULL,
                                  cell,    row};
    reader *r = tr_alloc(1, sizeof *r, st);
    if (!r) return false;
    r->table = t;
    clear(&r->row);
    bool ok = check_kind(t->path, st) && tr_csv_read(t->path, &format, r, st);
    free(r);
    if (ok && !t->n) ok = tr_status_fail(st, TR_BAD_CASE, "%s:2: error: no rows below the header line", t->path);
    return ok && check_answers(t, st) && check_touching(t, st);
}
