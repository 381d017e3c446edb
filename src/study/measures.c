/* SPDX-License-Identifier: MIT */
/* trundle measures: see measures.h. */
#include "study/measures.h"
#include "base/math.h"

#include "base/alloc.h"
#include "laws/kinematics.h"
#include "laws/law.h"
#include "study/csv.h"
#include <assert.h>
#include <csv.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* clang-format off */
#define COLUMN(name) {#name, offsetof(tr_motion, name)}
const tr_measures_column tr_motion_columns[TR_MOTION_COLUMNS] = {
    COLUMN(R1), COLUMN(R2), COLUMN(x1x), COLUMN(x1y), COLUMN(x2x), COLUMN(x2y),
    COLUMN(v1x), COLUMN(v1y), COLUMN(v2x), COLUMN(v2y), COLUMN(w1), COLUMN(w2),
};
#undef COLUMN
/* clang-format on */

#define COLUMN(name)                                                                                                   \
    { #name, offsetof(tr_motion_measures, name) }
static const tr_measures_column before[] = {COLUMN(beta_dot), COLUMN(Vt), COLUMN(da),
                                            COLUMN(db),       COLUMN(s1), COLUMN(s2)};
static const tr_measures_column behind[] = {COLUMN(lambda_dot), COLUMN(alpha1_dot), COLUMN(alpha2_dot)};
enum { BEFORE = sizeof before / sizeof *before, BEHIND = sizeof behind / sizeof *behind };

int tr_measures_columns(void) {
    return BEFORE + tr_n_rolling_measures + tr_n_sliding_measures + BEHIND;
}

tr_measures_column tr_measures_column_of(int k) {
    if (k < BEFORE) return before[k];
    k -= BEFORE;
    if (k < tr_n_rolling_measures)
        return (tr_measures_column){tr_rolling_velocities[k].column,
                                    offsetof(tr_motion_measures, rolling) + (size_t)k * sizeof(double)};
    k -= tr_n_rolling_measures;
    if (k < tr_n_sliding_measures)
        return (tr_measures_column){tr_sliding_velocities[k].column,
                                    offsetof(tr_motion_measures, sliding) + (size_t)k * sizeof(double)};
    return behind[k - tr_n_sliding_measures];
}

static double value(const void *row, tr_measures_column column) {
    double v;
    memcpy(&v, (const char *)row + column.offset, sizeof v);
    return v;
}

double tr_measures_of_column(const tr_motion_measures *measures, const char *name) {
    for (int k = 0; k < tr_measures_columns(); k++)
        if (!strcmp(tr_measures_column_of(k).name, name)) return value(measures, tr_measures_column_of(k));
    return NAN;
}

double tr_measures_sliding_of(const tr_motion_measures *measures, const char *name) {
    int k = 0;
    while (strcmp(tr_sliding_velocities[k].name, name)) k++;
    return measures->sliding[k];
}

/* ---- motions through the passes */

typedef struct lanes {
    tr_tile tile;
    double R1[TR_TILE], R2[TR_TILE], g1[TR_TILE];
    int of[TR_TILE]; /* lane -> motion */
} lanes;

static bool is_wall(const tr_motion *m) {
    return isinf(m->R1);
}

static void gather_pair(lanes *b, int i, const tr_motion *m) {
    b->R1[i] = m->R1, b->R2[i] = m->R2, b->g1[i] = m->R1 / (m->R1 + m->R2);
    b->tile.dx[i] = m->x2x - m->x1x, b->tile.dy[i] = m->x2y - m->x1y;
    b->tile.dvx[i] = m->v2x - m->v1x, b->tile.dvy[i] = m->v2y - m->v1y;
    b->tile.w1[i] = m->w1, b->tile.w2[i] = m->w2;
}

/* Seen from the wall, which then rests. Its material, continued to the centre of the disk, moves there with v1 + w1 k x
 * X21. */
static void gather_wall(lanes *b, int i, const tr_motion *m) {
    double dx = m->x2x - m->x1x, dy = m->x2y - m->x1y, L = sqrt(dx * dx + dy * dy);
    b->R1[i] = 0, b->R2[i] = m->R2, b->g1[i] = 1;
    b->tile.nx[i] = dx / L, b->tile.ny[i] = dy / L;
    b->tile.dx[i] = L, b->tile.dy[i] = 0;
    b->tile.dvx[i] = m->v2x - m->v1x + m->w1 * dy, b->tile.dvy[i] = m->v2y - m->v1y - m->w1 * dx;
    b->tile.w1[i] = 0, b->tile.w2[i] = m->w2 - m->w1;
}

/* Numbers that no pass computes, and numbers that kinematics left in the tile. g1 = R1/(R1+R2), at a wall 1: there the
 * formulas with g1 are the limits for R1 -> inf. */
static void derive(const lanes *b, int i, const tr_motion *m, tr_motion_measures *out) {
    const tr_tile *t = &b->tile;
    double g1 = b->g1[i], g2 = 1 - g1, w1 = t->w1[i], w2 = t->w2[i];
    double Vt = t->dvx[i] * t->ny[i] - t->dvy[i] * t->nx[i];
    double beta_dot = is_wall(m) ? 0 : -Vt / (t->r1[i] + t->r2[i]); /* r1 + r2 = |X21| */
    out->Vt = Vt;
    out->beta_dot = is_wall(m) ? m->w1 : beta_dot;
    out->s1 = t->s1[i], out->s2 = t->s2[i];
    out->da = out->s1, out->db = -out->s2;          /* below [Wang2015 eq. 24] */
    out->alpha1_dot = g2 * (w1 - w2);               /* [Wang2015 eq. 8a] */
    out->alpha2_dot = -g1 * (w1 - w2);              /* [Wang2015 eq. 8b] */
    out->lambda_dot = g2 * w2 + g1 * w1 - beta_dot; /* [Wang2015 eq. 8c] */
}

static void measure_tile(lanes *b, tr_pass_run *kinematics, const tr_motion *motion, tr_motion_measures *out) {
    kinematics(&b->tile, NULL);
    for (int i = 0; i < b->tile.n; i++) derive(b, i, &motion[b->of[i]], &out[b->of[i]]);
    for (int k = 0; k < tr_n_rolling_measures; k++) {
        tr_rolling_velocities[k].step(&b->tile, NULL);
        for (int i = 0; i < b->tile.n; i++) out[b->of[i]].rolling[k] = b->tile.v_r[i];
    }
    for (int k = 0; k < tr_n_sliding_measures; k++) {
        tr_sliding_velocities[k].step(&b->tile, NULL);
        for (int i = 0; i < b->tile.n; i++) out[b->of[i]].sliding[k] = b->tile.v_s[i];
    }
    for (int k = 0; k < tr_n_arms_measured; k++) {
        tr_arms_rows[k].arms(&b->tile, NULL);
        for (int i = 0; i < b->tile.n; i++) {
            tr_motion_measures *m = &out[b->of[i]];
            double r1 = b->tile.r1[i], r2 = b->tile.r2[i];
            m->arms[k].r1 = r1, m->arms[k].r2 = r2;
            m->arms[k].power = m->Vt + r1 * b->tile.w1[i] + r2 * b->tile.w2[i];
        }
    }
}

bool tr_measures_motions(const tr_motion *motion, int n, tr_motion_measures *measures, tr_status *st) {
    lanes *b = tr_alloc(1, sizeof *b, st);
    if (!b) return false;
    assert(tr_n_rolling_measures <= TR_MOST_DEFINITIONS && tr_n_sliding_measures <= TR_MOST_DEFINITIONS &&
           tr_n_arms_measured <= TR_MOST_ARMS);
    memset(measures, 0, (size_t)n * sizeof *measures);
    b->tile.R1 = b->R1, b->tile.R2 = b->R2, b->tile.g1 = b->g1;
    enum { PAIR, WALL, RING, KINDS };
    tr_pass_run *const kinematics[KINDS] = {tr_kinematics_pair, tr_kinematics_wall, tr_kinematics_ring};
    for (int kind = 0; kind < KINDS; kind++) /* as in an assembly, each kind in tiles of its own */
        for (int next = 0; next < n;) {
            int filled = 0;
            for (; next < n && filled < TR_TILE; next++) {
                const tr_motion *m = &motion[next];
                if ((is_wall(m) ? WALL : m->R1 < 0 ? RING : PAIR) != kind) continue;
                (kind == WALL ? gather_wall : gather_pair)(b, filled, m);
                b->of[filled++] = next;
            }
            b->tile.n = filled;
            measure_tile(b, kinematics[kind], motion, measures);
        }
    free(b);
    return true;
}

/* ---- rows out */

/* A name of the table as part of that of a column. */
static void write_name(FILE *out, const char *what, const char *name) {
    fprintf(out, ",%s_", what);
    for (; *name; name++) fputc(*name == '-' ? '_' : *name, out);
}

void tr_measures_write_header(FILE *out, bool arms) {
    fputs("case", out);
    for (int k = 0; k < TR_MOTION_COLUMNS; k++) fprintf(out, ",%s", tr_motion_columns[k].name);
    for (int k = 0; k < tr_measures_columns(); k++) fprintf(out, ",%s", tr_measures_column_of(k).name);
    for (int k = 0; arms && k < tr_n_arms_measured; k++)
        for (int what = 0; what < 3; what++)
            write_name(out, what == 0 ? "r1" : what == 1 ? "r2" : "power", tr_arms_rows[k].name);
    fputc('\n', out);
}

void tr_measures_write(FILE *out, const char *label, const tr_motion *motion, const tr_motion_measures *measures,
                       bool arms) {
    size_t length = strlen(label);
    bool plain =
        length > 0 && !strpbrk(label, ",\"\r\n") && !strchr(" \t", label[0]) && !strchr(" \t", label[length - 1]);
    if (plain)
        fputs(label, out);
    else
        csv_fwrite(out, label, length);
    for (int k = 0; k < TR_MOTION_COLUMNS; k++) fprintf(out, ",%.17g", value(motion, tr_motion_columns[k]));
    /* + 0.0: a zero has no sign in a table */
    for (int k = 0; k < tr_measures_columns(); k++)
        fprintf(out, ",%.17g", value(measures, tr_measures_column_of(k)) + 0.0);
    for (int k = 0; arms && k < tr_n_arms_measured; k++)
        fprintf(out, ",%.17g,%.17g,%.17g", measures->arms[k].r1, measures->arms[k].r2, measures->arms[k].power + 0.0);
    fputc('\n', out);
}

/* ---- rows in */

typedef struct table {
    FILE *out;
    bool arms;
    /* rows that wait to be measured, and the one being read */
    int n;
    long lines[TR_TILE];
    char label[TR_TILE][TR_CASE_LABEL];
    tr_motion motion[TR_TILE];
    tr_motion_measures measures[TR_TILE];
} table;

enum { CASE, R1, R2, COLUMNS = 1 + TR_MOTION_COLUMNS };

static bool flush(table *t, tr_csv *csv) {
    if (!tr_measures_motions(t->motion, t->n, t->measures, csv->st)) return false;
    for (int i = 0; i < t->n; i++) {
        for (int k = 0; k < tr_measures_columns(); k++)
            if (!isfinite(value(&t->measures[i], tr_measures_column_of(k))))
                return tr_csv_fail(csv, t->lines[i],
                                   "%s is not finite: the numbers of this row are too large or too small",
                                   tr_measures_column_of(k).name);
        tr_measures_write(t->out, t->label[i], &t->motion[i], &t->measures[i], t->arms);
    }
    t->n = 0;
    if (!ferror(t->out)) return true;
    return tr_status_fail(csv->st, TR_FILE, "error: cannot write the measures: %s", strerror(errno));
}

static bool begin(void *context, tr_csv *csv) {
    table *t = context;
    (void)csv;
    tr_measures_write_header(t->out, t->arms);
    return true;
}

static bool cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    table *t = context;
    if (column == CASE) {
        if (length >= TR_CASE_LABEL)
            return tr_csv_fail(csv, csv->line, "case has more than %d bytes", TR_CASE_LABEL - 1);
        memcpy(t->label[t->n], text, length + 1);
        return true;
    }
    const tr_measures_column *to = &tr_motion_columns[column - 1];
    bool radius = column == R1 || column == R2;
    char show[TR_CSV_SHOWN];
    double v = 0;
    if (!tr_csv_number(csv, to->name, text, radius, &v)) return false;
    bool ring = column == R1 && v < 0 && isfinite(v);
    if (radius && !(v > 0) && !ring)
        return tr_csv_fail(csv, csv->line, "%s is %s: a radius must be above 0%s", to->name, tr_csv_show(text, show),
                           column == R1 ? " (a wall has R1 = inf, a ring R1 < 0)" : "");
    if (isinf(v) && column == R2) return tr_csv_fail(csv, csv->line, "R2 is inf: only body 1 can be a wall");
    memcpy((char *)&t->motion[t->n] + to->offset, &v, sizeof v);
    return true;
}

/* Lengths whose squares are finite and have all digits. */
static bool in_range(double length) {
    return length >= 1e-150 && length <= 1e150;
}
static const char out_of_range[] = "allowed is 1e-150 m to 1e150 m";

static bool row(void *context, tr_csv *csv) {
    table *t = context;
    const tr_motion *m = &t->motion[t->n];
    long line = csv->row_line;
    double distance = tr_hypot(m->x2x - m->x1x, m->x2y - m->x1y);
    if (distance == 0) return tr_csv_fail(csv, line, "x1 and x2 coincide: there is no line of centres");
    if (!in_range(distance)) return tr_csv_fail(csv, line, "x1 and x2 are %.3g m apart: %s", distance, out_of_range);
    if (m->R1 < 0 && !(m->R2 < -m->R1))
        return tr_csv_fail(csv, line, "a ring of the radius %.6g m (R1 < 0) holds smaller disks only, and R2 is %.6g m",
                           -m->R1, m->R2);
    if (!in_range(fabs(m->R1)) && !is_wall(m)) return tr_csv_fail(csv, line, "R1 is %.3g m: %s", m->R1, out_of_range);
    if (!in_range(m->R2)) return tr_csv_fail(csv, line, "R2 is %.3g m: %s", m->R2, out_of_range);
    t->lines[t->n++] = line;
    return t->n < TR_TILE || flush(t, csv);
}

bool tr_measures_csv(const char *path, bool arms, FILE *out, tr_status *st) {
    const char *columns[COLUMNS] = {"case"};
    for (int k = 0; k < TR_MOTION_COLUMNS; k++) columns[1 + k] = tr_motion_columns[k].name;
    const tr_csv_format format = {columns, COLUMNS, COLUMNS, "case,R1,R2,x1x,...", begin, cell, row};
    table *t = tr_alloc(1, sizeof *t, st);
    if (!t) return false;
    t->out = out, t->arms = arms;
    tr_csv csv = {.path = path, .st = st};
    bool ok = tr_csv_read(path, &format, t, st) && flush(t, &csv);
    free(t);
    return ok;
}

/* ---- the card */

/* The motions with body 1 at x1: betadot = spin of the line of centres. L: distance. Each slides or rolls at U. */
typedef struct pure {
    const char *name;
    double overlap;      /* of R2 */
    double beta, w1, w2; /* times U */
    double Vr, Vs;       /* times U */
} pure;

static tr_motion pair_motion(const pure *p, double R1, double R2, double U) {
    static const double nx = 0.6, ny = 0.8;
    double L = R1 + R2 - p->overlap * R2, B = p->beta * U;
    tr_motion m = {.R1 = R1, .R2 = R2, .x1x = 0.02, .x1y = -0.01, .w1 = p->w1 * U, .w2 = p->w2 * U};
    m.x2x = m.x1x + L * nx, m.x2y = m.x1y + L * ny;
    m.v2x = -B * L * ny, m.v2y = B * L * nx;
    return m;
}

/* A disk on a horizontal floor; v along x. */
static tr_motion floor_motion(double v, double w, double R2) {
    return (tr_motion){
        .R1 = INFINITY, .R2 = R2, .x1x = 0.02, .x1y = -0.01, .x2x = 0.02, .x2y = -0.01 + R2, .v2x = v, .w2 = w};
}

/* The same for an observer who moves and turns about the origin: everything gets a rigid motion. */
static tr_motion seen_moving(tr_motion m) {
    static const double ux = 0.03, uy = -0.02, W = 3;
    m.v1x += ux - W * m.x1y, m.v1y += uy + W * m.x1x, m.w1 += W;
    m.v2x += ux - W * m.x2y, m.v2y += uy + W * m.x2x, m.w2 += W;
    return m;
}

static void add(tr_card_motion **next, const char *name, const char *size, tr_motion m, double Vr, double Vs) {
    for (int moving = 0; moving < 2; moving++) {
        tr_card_motion *c = (*next)++;
        *c = (tr_card_motion){.name = name, .motion = moving ? seen_moving(m) : m, .Vr = Vr, .Vs = Vs};
        snprintf(c->label, sizeof c->label, "%s%s %s", name, size, moving ? "(moving observer)" : "(resting observer)");
    }
}

void tr_measures_card(tr_card_motion card[TR_CARD_MOTIONS]) {
    static const double ratio[] = {1, 2, 10};
    const double R2 = TR_CARD_R2, U = TR_CARD_U;
    tr_card_motion *next = card;
    for (int k = 0; k < 6; k++)
        for (int r = 0; r < 3; r++) {
            double R1 = ratio[r] * R2, L = R1 + R2, turn = 1 / L;
            const pure all[] = {
                {"RBR", 0, turn, turn, turn, 0, 0},
                {"RBR overlap", 0.1, turn, turn, turn, 0, 0},
                {"PR", 0, 0, 1 / R1, -1 / R2, 1, 0},
                {"PS", 0, 0, turn, turn, 0, 1},
                {"PR + RBR", 0, -1 / R1, 0, -L / (R1 * R2), 1, 0}, /* rolls over body 1, which rests */
                {"PS + RBR", 0, -turn, 0, 0, 0, 1},                /* is carried round it without turning */
            };
            char size[24];
            snprintf(size, sizeof size, " R1/R2=%g", ratio[r]);
            add(&next, all[k].name, size, pair_motion(&all[k], R1, R2, U), all[k].Vr * U, all[k].Vs * U);
        }
    add(&next, "floor: rolling", "", floor_motion(U, -U / R2, R2), U, 0);
    add(&next, "floor: sliding", "", floor_motion(U, 0, R2), 0, U);
    add(&next, "floor: spinning", "", floor_motion(0, U / R2, R2), -U, U); /* in place: rolls back as it slides */
    assert(next == card + TR_CARD_MOTIONS);
}
