/* SPDX-License-Identifier: MIT */
/* trundle measures */
#include "cli/cli.h"

#include "out/dir.h"
#include "study/measures.h"
#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct arguments {
    const char *file, *out;
} arguments;

static const struct argp_option options[] = {
    {"output", 'o', "OUT.csv", 0, "write CSV there, whole or not at all (default with FILE.csv: standard output)", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    if (key == 'o')
        a->out = value;
    else if (key == ARGP_KEY_ARG && !a->file)
        a->file = value;
    else if (key == ARGP_KEY_ARG)
        argp_error(state, "one file at a time");
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
    "A wall is body 1 with R1 = inf: the plane through x1, the foot of the perpendicular from x2; v1 is the velocity "
    "of "
    "the wall at x1 and w1 its spin. It is measured in the wall's frame; beta_dot is then w1, and lambda_dot, "
    "alpha1_dot, alpha2_dot are their limits for R1 -> inf: 0, 0 and w2 - w1.\n\n"
    "Added columns, with n from 1 to 2 and t = n x k = (n_y, -n_x):\n\n"
    "  beta_dot             spin of the line of centres [rad/s]\n"
    "  Vt                   (v2 - v1).t [m/s]\n"
    "  da,db                arcs per second, s1 and -s2 [m/s]\n"
    "  s1,s2                R1(w1 - beta_dot), -R2(w2 - beta_dot) [m/s]\n"
    "  Vr_... Us_... Vs_... rolling (r) and sliding (s) by author [m/s]\n"
    "  Vs_wang              with the arms to the contact point\n"
    "  Vs_full_radii        with R1 and R2, as Wang prints it\n"
    "  Vr_tordesillas       w1 - w2 [rad/s]\n"
    "  Vroll_kuhn           material through the contact, along t\n"
    "  lambda_dot           common spin of pure sliding [rad/s]\n"
    "  alpha1_dot,..2_dot   spins of pure rolling [rad/s]\n";

/* ---- the card */

/* The columns. An angle (tordesillas) cannot be compared with a velocity: only zero or not can be wrong. */
static const struct definition {
    const char *head[2];
    size_t offset;
    bool rolling, angle;
} definitions[] = {
    {{"", "wang"}, offsetof(tr_motion_measures, Vr_wang), true, false},
    {{"bagi-", "kuhn"}, offsetof(tr_motion_measures, Vr_bagi_kuhn), true, false},
    {{"alonso", "min"}, offsetof(tr_motion_measures, Vr_alonso_min), true, false},
    {{"alonso", "mean"}, offsetof(tr_motion_measures, Vr_alonso_mean), true, false},
    {{"torde-", "sillas"}, offsetof(tr_motion_measures, Vr_tordesillas), true, true},
    {{"", "wang"}, offsetof(tr_motion_measures, Vs_wang), false, false},
    {{"full", "radii"}, offsetof(tr_motion_measures, Vs_full_radii), false, false},
    {{"iwash.", "oda"}, offsetof(tr_motion_measures, Us_iwashita_oda), false, false},
    {{"", "alonso"}, offsetof(tr_motion_measures, Vs_alonso), false, false},
};
enum { N_DEFINITIONS = sizeof definitions / sizeof *definitions };

static double by(const struct definition *d, const tr_motion_measures *m) {
    double v;
    memcpy(&v, (const char *)m + d->offset, sizeof v);
    return v / (d->angle ? TR_CARD_U / TR_CARD_R2 : TR_CARD_U);
}

static void print_cell(const struct definition *d, const tr_card_motion *c, const tr_motion_measures *m) {
    static const double same = 1e-9;
    double v = by(d, m), wanted = (d->rolling ? c->Vr : c->Vs) / TR_CARD_U;
    bool wrong = d->angle ? (fabs(v) > same) != (fabs(wanted) > same) : fabs(v - wanted) > same;
    bool depends = fabs(by(d, m + 1) - v) > same;
    char text[24];
    snprintf(text, sizeof text, fabs(v) < same ? "%2.0f%s%s" : "%6.3f%s%s", fabs(v) < same ? 0 : v, wrong ? "*" : "",
             depends ? "!" : "");
    printf("%-8s", text);
}

static void print_card(const tr_card_motion *card, const tr_motion_measures *measures) {
    printf("Rolling and sliding of the pure motions, as multiples of the motion's speed U = %g mm/s (R2 = %g mm)\n\n",
           TR_CARD_U * 1e3, TR_CARD_R2 * 1e3);
    printf("%21s%-40s%s\n", "", "  ----------- rolling V_r -----------", "  --------- sliding V_s -------");
    for (int line = 0; line < 2; line++) {
        printf("%-15s%-6s", line ? "motion" : "", line ? "R1/R2" : "");
        for (int k = 0; k < N_DEFINITIONS; k++)
            printf("%6s%s", definitions[k].head[line], k + 1 < N_DEFINITIONS ? "  " : "\n");
    }
    for (int i = 0; i < TR_CARD_MOTIONS; i += 2) { /* the resting observer; the moving one is next */
        const tr_motion *m = &card[i].motion;
        if (i == 0 || (strcmp(card[i].name, card[i - 2].name) && !isinf(card[i - 2].motion.R1))) printf("\n");
        printf("%-15s%5.3g ", card[i].name, m->R1 / m->R2);
        for (int k = 0; k < N_DEFINITIONS; k++) print_cell(&definitions[k], &card[i], &measures[i]);
        printf("\n");
    }
    fputs("\n"
          "RBR rigid rotation, PR pure rolling (gears), PS pure sliding (equal spins); + RBR: body 1 rests\n"
          "*  differs from what the definition of the motion says (Wang et al. 2015, eqs. 1-6, 14-15)\n"
          "!  an observer who moves and turns sees another value: not objective. All others: the same\n"
          "\n"
          "wang         R1R2/(R1+R2) (w1-w2): what a pure pair of moments does work on (= luding, jiang)\n"
          "bagi-kuhn    (s1+s2)/2: mean flow of material through the contact (= iwashita-oda); a question of\n"
          "             its own: where * it is not wrong, material does flow through the contact\n"
          "alonso       min: the slower rim, mean: their mean, if both run the same way; else 0 (as inferred)\n"
          "tordesillas  w1-w2: an angle, in units of U/R2\n"
          "V_s: wang with the arms to the contact point; full radii: his eq. 12 as printed, wrong with\n"
          "overlap; iwashita-oda (= jiang) is half of it, alonso (s1-s2) the same but for overlap\n",
          stdout);
}

static bool card(FILE *csv, tr_status *st) {
    tr_card_motion card[TR_CARD_MOTIONS];
    tr_motion motion[TR_CARD_MOTIONS];
    tr_motion_measures measures[TR_CARD_MOTIONS];
    tr_measures_card(card);
    for (int i = 0; i < TR_CARD_MOTIONS; i++) motion[i] = card[i].motion;
    if (!tr_measures_motions(motion, TR_CARD_MOTIONS, measures, st)) return false;
    print_card(card, measures);
    if (csv) tr_measures_write_header(csv);
    for (int i = 0; csv && i < TR_CARD_MOTIONS; i++) tr_measures_write(csv, card[i].label, &motion[i], &measures[i]);
    return true;
}

/* ---- where the table goes */

static bool to_file(const arguments *a, tr_status *st) {
    tr_file file;
    if (!tr_cli_open(&file, a->out, a->file, st)) return false;
    if (a->file ? tr_measures_csv(a->file, file.stream, st) : card(file.stream, st)) return tr_file_commit(&file, st);
    tr_file_discard(&file);
    return false;
}

/* Kept in a temporary file until the last row is known to be good. */
static bool to_stdout(const arguments *a, tr_status *st) {
    FILE *rows = tmpfile();
    if (!rows) return tr_status_fail(st, TR_FILE, "error: cannot make a temporary file: %s", strerror(errno));
    bool ok = tr_measures_csv(a->file, rows, st);
    if (ok && (fflush(rows) || ferror(rows)))
        ok = tr_status_fail(st, TR_FILE, "error: cannot write a temporary file: %s", strerror(errno));
    char chunk[1 << 14];
    rewind(rows);
    for (size_t n; ok && (n = fread(chunk, 1, sizeof chunk, rows)) > 0;)
        if (fwrite(chunk, 1, n, stdout) < n) break; /* main complains */
    fclose(rows);
    return ok;
}

int tr_cli_measures(int argc, char **argv) {
    arguments a = {0};
    const struct argp argp = {options, parse, "[FILE.csv]", doc, 0, 0, 0};
    argv[0] = "trundle measures";
    tr_cli_parse(&argp, argc, argv, &a);
    tr_status st = {0};
    bool ok = a.out ? to_file(&a, &st) : a.file ? to_stdout(&a, &st) : card(NULL, &st);
    return ok ? TR_OK : tr_cli_fail(&st);
}
