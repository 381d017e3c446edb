/* SPDX-License-Identifier: MIT */
/* trundle measures */
#include "cli/open.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "laws/law.h"
#include "base/alloc.h"
#include "laws/kinematics.h"
#include "out/dir.h"
#include "study/card.h"
#include "study/measures.h"
#include "base/math.h"
#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct arguments {
    const char *file, *out, *card;
    bool arms;
} arguments;

enum { CARD = 256, ARMS };

static const struct argp_option options[] = {
    {"output", 'o', "OUT.csv", 0,
     "write CSV to OUT.csv, only if all rows are right (default with FILE.csv: standard output)", 0},
    {"card", CARD, "OUT.csv", 0,
     "write motions for another code to run, with overlap and with the springs to use, for trundle identify", 0},
    {"arms", ARMS, NULL, 0, "also the arms of every code: columns r1_..., r2_..., power_..., and a table of them", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    if (key == 'o')
        a->out = value;
    else if (key == CARD)
        a->card = value;
    else if (key == ARMS)
        a->arms = true;
    else if (key == ARGP_KEY_ARG && !a->file)
        a->file = value;
    else if (key == ARGP_KEY_ARG)
        argp_error(state, "one file at a time");
    else if (key == ARGP_KEY_END && a->card && (a->file || a->out || a->arms))
        argp_error(state, "--card writes a table of its own: give it alone");
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

static const char doc[] =
    "Rolling and sliding velocities of a contact by every author's definition, of the motions in FILE.csv (SI units); "
    "without a file, a card of the pure motions, which -o also exports as CSV with 17 digits, to compare another code "
    "with."
    "\v"
    "Columns of FILE.csv, in any order, named by its first line:\n\n"
    "  case                 any text\n"
    "  R1,R2                radii [m]\n"
    "  x1x,x1y,x2x,x2y      centres [m]\n"
    "  v1x,v1y,v2x,v2y      velocities [m/s]\n"
    "  w1,w2                spins, counter-clockwise [rad/s]\n\n"
    "Further columns are ignored and left out of the result. The disks need not touch, but their centres must "
    "differ.\n\n"
    "A ring around body 2 is body 1 with R1 < 0, minus its inner radius.\n\n"
    "A wall is body 1 with R1 = inf: the plane through x1, the foot of the perpendicular from x2; v1 is the velocity "
    "of "
    "the wall at x1 and w1 its spin. It is measured in the wall's frame; beta_dot is then w1, and lambda_dot, "
    "alpha1_dot, alpha2_dot are their limits for R1 -> inf: 0, 0 and w2 - w1.\n\n"
    "Added columns, with n from 1 to 2 and t = n x k = (n_y, -n_x):\n\n"
    "  beta_dot             spin of the line of centres [rad/s]\n"
    "  Vt                   (v2 - v1).t [m/s]\n"
    "  da,db                arcs per second, s1 and -s2 [m/s]\n"
    "  s1,s2                R1(w1 - beta_dot), -R2(w2 - beta_dot) [m/s]\n"
    "  Vr_..., Us_..., Vs_...  rolling (r), sliding (s) [m/s]: see the card\n"
    "  Vr_tordesillas       w1 - w2 [rad/s]\n"
    "  Vroll_kuhn           material through the contact, along t\n"
    "  Vs_midpoint          arms R - delta/2; R2 - delta at a wall\n"
    "  lambda_dot           common spin of pure sliding [rad/s]\n"
    "  alpha1_dot,..2_dot   spins of pure rolling [rad/s]\n\n"
    "With --arms also, for each row of the table of arms:\n\n"
    "  r1_...,r2_...        arms of the torques of friction [m]\n"
    "  power_...            power of a unit force of friction with them [m/s]; that of the sliding velocity, if both "
    "fit\n\n"
    "The table of --card has three lines for each motion, told apart by `experiment`: roll (a rolling spring k_roll), "
    "cap "
    "(its bound mu_r F_n is reached at once), slide (a spring k_t). 0 is none. Keep the places, give the velocities "
    "for "
    "`time` from a new contact, add your F_n, F_t, M1, M2 as columns, and hand the file to trundle identify.\n";

/* ---- the card */

/* A definition on the card: a row of the tables that has a head. */
typedef struct column {
    const tr_velocity_measure *row;
    bool rolling;
    int k; /* in its table */
} column;

enum { MOST_COLUMNS = 2 * TR_MOST_DEFINITIONS };

static int columns(column *out, bool rolling) {
    const tr_velocity_measure *row = rolling ? tr_rolling_velocities : tr_sliding_velocities;
    int n = 0, rows = rolling ? tr_n_rolling_measures : tr_n_sliding_measures;
    for (int k = 0; k < rows; k++)
        if (row[k].head) out[n++] = (column){&row[k], rolling, k};
    return n;
}

/* An angle cannot be compared with a velocity: only zero or not can be wrong. */
static bool is_angle(const column *c) {
    return c->row->claims & TR_DEFINES_ANGLE;
}

static double by(const column *c, const tr_motion_measures *m) {
    return (c->rolling ? m->rolling : m->sliding)[c->k] / (is_angle(c) ? TR_CARD_U / TR_CARD_R2 : TR_CARD_U);
}

/* Rounding is nothing. */
static double tidy(double v) {
    return fabs(v) < 1e-9 ? 0 : v;
}

static void print_cell(const column *d, const tr_card_motion *c, const tr_motion_measures *m, bool last) {
    static const double same = 1e-9;
    double v = by(d, m), wanted = (d->rolling ? c->Vr : c->Vs) / TR_CARD_U;
    bool wrong = is_angle(d) ? (fabs(v) > same) != (fabs(wanted) > same) : fabs(v - wanted) > same;
    bool depends = fabs(by(d, m + 1) - v) > same;
    char text[24];
    snprintf(text, sizeof text, fabs(v) < same ? "%2.0f%s%s" : "%6.3f%s%s", fabs(v) < same ? 0 : v, wrong ? "*" : "",
             depends ? "!" : "");
    printf(last ? "%s" : "%-8s", text);
}

/* One of the two lines of a head. */
static void print_head(const column *c, int line, bool last) {
    const char *split = strchr(c->row->head, '\n'), *text = line ? split + 1 : c->row->head;
    printf("%6.*s%s", line ? 6 : (int)(split - text), text, last ? "\n" : "  ");
}

/* What each definition is; lines of the formula are aligned. */
static void print_formulas(const column *c, int n) {
    for (int k = 0; k < n; k++) {
        printf("%-13s", c[k].row->name);
        for (const char *p = c[k].row->formula; *p; p++) {
            putchar(*p);
            if (*p == '\n') printf("%13s", "");
        }
        putchar('\n');
    }
}

static void print_card(const tr_card_motion *card, const tr_motion_measures *measures) {
    column c[MOST_COLUMNS];
    int n_rolling = columns(c, true), n = n_rolling + columns(c + n_rolling, false);
    printf("Rolling and sliding of the pure motions, as multiples of the motion's speed U = %g mm/s (R2 = %g mm)\n\n",
           TR_CARD_U * 1e3, TR_CARD_R2 * 1e3);
    printf("%21s%-*s%s\n", "", 8 * n_rolling, "  ----------- rolling V_r -----------",
           "  --------- sliding V_s -------");
    for (int line = 0; line < 2; line++) {
        printf("%-15s%-6s", line ? "motion" : "", line ? "R1/R2" : "");
        for (int k = 0; k < n; k++) print_head(&c[k], line, k + 1 == n);
    }
    for (int i = 0; i < TR_CARD_MOTIONS; i += 2) { /* the resting observer; the moving one is next */
        const tr_motion *m = &card[i].motion;
        if (i == 0 || (strcmp(card[i].name, card[i - 2].name) && !isinf(card[i - 2].motion.R1))) printf("\n");
        printf("%-15s%5.3g ", card[i].name, m->R1 / m->R2);
        for (int k = 0; k < n; k++) print_cell(&c[k], &card[i], &measures[i], k + 1 == n);
        printf("\n");
    }
    fputs("\n"
          "RBR rigid rotation, PR pure rolling (gears), PS pure sliding (equal spins); + RBR: body 1 rests\n"
          "*  differs from what the definition of the motion says (Wang et al. 2015, eqs. 1-6, 14-15)\n"
          "!  an observer who moves and turns sees another value: not objective. All others: the same\n"
          "\nrolling V_r\n",
          stdout);
    print_formulas(c, n_rolling);
    printf("sliding V_s\n");
    print_formulas(c + n_rolling, n - n_rolling);
}

/* Worst of the card's motions with overlap: what a rigid rotation slides, what r1 + r2 lacks of |X21|, and the power of
 * a unit force less the sliding velocity. */
static void print_arms(const tr_card_row *row, const tr_motion_measures *measures) {
    printf("\narms               with 5 %% overlap: rigid rotation slides, r1+r2 less |X21|, power less V_s\n");
    for (int k = 0; k < tr_n_arms_measured; k++) {
        double slides = 0, length = 0, power = 0;
        for (int i = 0; i < TR_CARD_ROWS; i += 3) {
            const tr_motion *m = &row[i].motion;
            const tr_motion_measures *of = &measures[i];
            double L = tr_hypot(m->x2x - m->x1x, m->x2y - m->x1y),
                   Vs = tr_measures_sliding_of(of, tr_arms_rows[k].sliding);
            if (isinf(m->R1) || row[i].overlap < 0.01 * L || !strstr(row[i].label, "resting")) continue;
            if (!strncmp(row[i].label, "RBR", 3)) slides = fmax(slides, fabs(Vs) / fabs(m->w1 * row[i].overlap));
            length = fmax(length, fabs(of->arms[k].r1 + of->arms[k].r2 - L) / row[i].overlap);
            power = fmax(power, fabs(of->arms[k].power - Vs) / TR_CARD_U);
        }
        printf("%-19s%6.3f w*overlap, %6.3f overlap, %6.3f U   %s\n", tr_arms_rows[k].name, tidy(slides), tidy(length),
               tidy(power), tr_arms_rows[k].formula);
    }
}

static bool arms(tr_status *st) {
    tr_card_row *row = tr_alloc(TR_CARD_ROWS, sizeof *row, st);
    tr_motion *motion = tr_alloc(TR_CARD_ROWS, sizeof *motion, st);
    tr_motion_measures *measures = tr_alloc(TR_CARD_ROWS, sizeof *measures, st);
    bool ok = row && motion && measures;
    if (ok) {
        tr_card_make(row);
        for (int i = 0; i < TR_CARD_ROWS; i++) motion[i] = row[i].motion;
        ok = tr_measures_motions(motion, TR_CARD_ROWS, measures, st);
    }
    if (ok) print_arms(row, measures);
    free(measures), free(motion), free(row);
    return ok;
}

static bool card(const arguments *a, FILE *csv, tr_status *st) {
    tr_card_motion card[TR_CARD_MOTIONS];
    tr_motion motion[TR_CARD_MOTIONS];
    tr_motion_measures measures[TR_CARD_MOTIONS];
    tr_measures_card(card);
    for (int i = 0; i < TR_CARD_MOTIONS; i++) motion[i] = card[i].motion;
    if (!tr_measures_motions(motion, TR_CARD_MOTIONS, measures, st)) return false;
    print_card(card, measures);
    if (csv) tr_measures_write_header(csv, a->arms);
    for (int i = 0; csv && i < TR_CARD_MOTIONS; i++)
        tr_measures_write(csv, card[i].label, &motion[i], &measures[i], a->arms);
    return !a->arms || arms(st);
}

/* ---- where the table goes */

static bool to_file(const arguments *a, tr_status *st) {
    tr_file file;
    if (!tr_cli_open(&file, a->out, a->file, st)) return false;
    if (a->file ? tr_measures_csv(a->file, a->arms, file.stream, st) : card(a, file.stream, st))
        return tr_file_commit(&file, st);
    tr_file_discard(&file);
    return false;
}

/* Rows stay in a temporary file until the last row is right. */
static bool to_stdout(const arguments *a, tr_status *st) {
    FILE *rows = tmpfile();
    if (!rows) return tr_status_fail(st, TR_FILE, "error: cannot make a temporary file: %s", strerror(errno));
    bool ok = tr_measures_csv(a->file, a->arms, rows, st);
    if (ok && (fflush(rows) || ferror(rows)))
        ok = tr_status_fail(st, TR_FILE, "error: cannot write a temporary file: %s", strerror(errno));
    char chunk[1 << 14];
    rewind(rows);
    for (size_t n; ok && (n = fread(chunk, 1, sizeof chunk, rows)) > 0;)
        if (fwrite(chunk, 1, n, stdout) < n) break; /* main complains */
    fclose(rows);
    return ok;
}

static bool write_card(const char *path, tr_status *st) {
    tr_file file;
    tr_card_row *row = tr_alloc(TR_CARD_ROWS, sizeof *row, st);
    bool ok = row && tr_cli_open(&file, path, NULL, st);
    if (ok) {
        tr_card_make(row);
        tr_card_write(file.stream, row);
        ok = tr_file_commit(&file, st);
    }
    free(row);
    return ok;
}

int tr_cli_measures(int argc, char **argv) {
    arguments a = {0};
    const struct argp argp = {options, parse, "[FILE.csv]", doc, 0, 0, 0};
    argv[0] = "trundle measures";
    tr_cli_parse(&argp, argc, argv, &a);
    tr_status st = {0};
    bool ok = a.card   ? write_card(a.card, &st)
              : a.out  ? to_file(&a, &st)
              : a.file ? to_stdout(&a, &st)
                       : card(&a, NULL, &st);
    return ok ? TR_OK : tr_cli_fail(&st);
}
