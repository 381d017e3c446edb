/* SPDX-License-Identifier: MIT */
/* trundle identify on the measured answers of three codes (tests/interop), as they are and with one mistake put in: the
 * words that name it must be there, and the exit must be that of a code that is objective, balanced and conjugate or not. And
 * bad input, with its message. The formulas of the mistakes are written out here. */
#include "assert_close.h"
#include "study/identify.h"
#include "study/identify_words.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- a table that can be changed */

enum { ROWS = 1000, COLUMNS = 40 };
typedef struct sheet {
    int n, columns;
    char name[COLUMNS][24];
    double cell[ROWS][COLUMNS]; /* NAN: empty, or a text */
} sheet;
static sheet S;

static void read_sheet(const char *path) {
    static char line[4096];
    FILE *in = fopen(path, "r");
    if (!in) fail_msg("cannot read %s", path);
    memset(&S, 0, sizeof S), S.n = -1;
    while (fgets(line, sizeof line, in)) {
        line[strcspn(line, "\n")] = '\0';
        int k = 0;
        for (char *p = line, *next; p; p = next, k++) {
            next = strchr(p, ',');
            if (next) *next++ = '\0';
            char *end;
            assert_true(k < COLUMNS && S.n < ROWS);
            if (S.n < 0) snprintf(S.name[k], sizeof S.name[k], "%.20s", p), S.columns = k + 1;
            if (S.n >= 0) S.cell[S.n][k] = strtod(p, &end), S.cell[S.n][k] = *p && !*end ? S.cell[S.n][k] : NAN;
        }
        S.n++;
    }
    fclose(in);
}

static int column(const char *name) {
    int k = 0;
    while (k < S.columns && strcmp(S.name[k], name)) k++;
    return k < S.columns ? k : -1;
}
static double at(int row, const char *name) {
    assert_true(column(name) >= 0);
    return S.cell[row][column(name)];
}

static void write_sheet(const char *path) {
    FILE *out = fopen(path, "w");
    for (int k = 2; k < S.columns; k++) fprintf(out, "%s%s", k > 2 ? "," : "", S.name[k]); /* case and code are texts */
    fputc('\n', out);
    for (int i = 0; i < S.n; i++)
        for (int k = 2; k < S.columns; k++) {
            if (!isnan(S.cell[i][k])) fprintf(out, "%.17g", S.cell[i][k]);
            fputc(k + 1 < S.columns ? ',' : '\n', out);
        }
    fclose(out);
}

/* ---- what is said of it */

typedef struct told {
    bool ok, good;
    tr_status st;
    char *text;
} told;

static told identify(const char *path, const tr_identify_map *map) {
    static const tr_identify_map none = {0};
    told t = {0};
    size_t size;
    tr_identify *w = calloc(1, sizeof *w);
    w->table.path = path, w->table.map = map ? map : &none;
    t.ok = tr_identify_make(w, &t.st);
    FILE *out = open_memstream(&t.text, &size);
    if (t.ok) tr_identify_print(out, w), t.good = tr_identify_is_good(&w->found);
    fclose(out);
    tr_identify_free(w), free(w);
    return t;
}

static told identify_sheet(void) {
    static const char path[] = "/tmp/trundle-identify.csv";
    char own[64];
    snprintf(own, sizeof own, "%s.%d", path, (int)getpid());
    write_sheet(own);
    told t = identify(own, NULL);
    unlink(own);
    if (!t.ok) fail_msg("refused: %s", t.st.text);
    return t;
}

/* words: those that must be there, with | between; after a ! those that must not. */
static void demand(const told *t, const char *of, bool good, const char *words) {
    char copy[400];
    snprintf(copy, sizeof copy, "%s", words);
    for (char *word = strtok(copy, "|"); word; word = strtok(NULL, "|")) {
        bool wanted = *word != '!';
        if ((strstr(t->text, wanted ? word : word + 1) != NULL) != wanted)
            fail_msg("%s: \"%s\" is %s in\n%s", of, word, wanted ? "not" : "there", t->text);
    }
    if (t->good != good) fail_msg("%s: %s\n%s", of, t->good ? "good" : "not good", t->text);
    free(t->text);
}

static void the_codes_are_named(void **state) {
    (void)state;
    static const struct {
        const char *file;
        bool good;
        const char *words;
    } codes[] = {
        {"lammps", false,
         "V_r          wang|M1           wang, lever R_eff = R1R2/(R1+R2)|cap 1        R_eff|V_s          "
         "full-radius|not "
         "objective when disks overlap|1 overlap*w in a rigid rotation|arm 1        midpoint|LAMMPS 29Sep2021|power of "
         "friction "
         "differs from F_t V_s|at 5 % overlap"},
        {"liggghts", true,
         "M1           wang, lever R_eff = R1R2/(R1+R2)|cap 1        R_eff|V_s          midpoint|arm 2        "
         "midpoint|good: "
         "objective: yes, balanced: yes, conjugate: yes"},
        {"yade", false,
         "(w1-w2), lever R1R2|wang, lever R1+R2|cap 1        min(R1,R2)|V_s          alonso|arm 1        midpoint|YADE "
         "2023.02a|not conjugate|!not objective"},
        {"yade-no-ratcheting", true, "V_s          midpoint|arm 1        midpoint|conjugate: yes"},
        {"yade-mindlin", true, "M1           tordesillas (w1-w2) ["},
    };
    for (int k = 0; k < (int)(sizeof codes / sizeof *codes); k++) {
        char path[80];
        snprintf(path, sizeof path, "tests/interop/%s.csv", codes[k].file);
        told t = identify(path, NULL);
        if (!t.ok) fail_msg("%s", t.st.text);
        demand(&t, codes[k].file, codes[k].good, codes[k].words);
    }
}

/* ---- mistakes */

typedef struct mistake {
    const char *file, *columns; /* of those with a blank between them */
    double (*of)(int row, const char *column, double v);
    bool good;
    const char *words;
} mistake;

static double overlap(int i) {
    return at(i, "R1") + at(i, "R2") - hypot(at(i, "x2x") - at(i, "x1x"), at(i, "x2y") - at(i, "x1y"));
}
static double Vt(int i) {
    double dx = at(i, "x2x") - at(i, "x1x"), dy = at(i, "x2y") - at(i, "x1y"), L = hypot(dx, dy);
    return ((at(i, "v2x") - at(i, "v1x")) * dy - (at(i, "v2y") - at(i, "v1y")) * dx) / L;
}
#define MISTAKE(name, expression)                                                                                      \
    static double name(int i, const char *column, double v) {                                                          \
        double R1 = at(i, "R1"), R2 = at(i, "R2"), w1 = at(i, "w1"), w2 = at(i, "w2"), d = overlap(i);                 \
        (void)column, (void)v, (void)R1, (void)R2, (void)w1, (void)w2, (void)d;                                        \
        return expression;                                                                                             \
    }
MISTAKE(twice, 2 * v)
MISTAKE(half, v / 2)
MISTAKE(minus, -v)
MISTAKE(product_of_radii, v *(R1 + R2))
MISTAKE(smaller_radius, v *fmin(R1, R2) * (R1 + R2) / (R1 * R2))
MISTAKE(own_radius, v *(column[1] == '1' ? R1 : R2) * (R1 + R2) / (R1 * R2))
MISTAKE(half_of_2, column[1] == '2' ? v / 2 : v)
MISTAKE(of_the_observer, v + 0.1 * R1 * w1)
MISTAKE(moments_of_the_observer, (column[1] == '1' ? -1 : 1) * R1 * R2 / (R1 + R2) * R1 * w1)
MISTAKE(full_exchanged, Vt(i) + R2 * w1 + R1 * w2)
MISTAKE(midpoint_exchanged, Vt(i) + (R2 - d / 2) * w1 + (R1 - d / 2) * w2)
MISTAKE(full_diameters, Vt(i) + 2 * R1 * w1 + 2 * R2 * w2)
MISTAKE(midpoint_diameters, Vt(i) + (2 * R1 - d / 2) * w1 + (2 * R2 - d / 2) * w2)
MISTAKE(arms_exchanged, isnan(v) ? v : (column[3] == '1' ? R2 : R1) - d / 2)
MISTAKE(arms_diameters, isnan(v) ? v : 2 * (column[3] == '1' ? R1 : R2) - d / 2)
MISTAKE(arms_full, isnan(v) ? v : column[3] == '1' ? R1 : R2)
MISTAKE(bagi_kuhn, (R1 * (w1 + Vt(i) / (R1 + R2 - d)) - R2 * (w2 + Vt(i) / (R1 + R2 - d))) / 2)
MISTAKE(bagi_kuhn_exchanged, (R2 * (w1 + Vt(i) / (R1 + R2 - d)) - R1 * (w2 + Vt(i) / (R1 + R2 - d))) / 2)
MISTAKE(bagi_kuhn_moments, (column[1] == '1' ? -1 : 1) * R1 * R2 / (R1 + R2) * bagi_kuhn(i, column, v))
MISTAKE(millimetres, 1000 * v)
MISTAKE(degrees, v * 180 / M_PI)

static const mistake mistakes[] = {
    /* one class: factor 2, diameters, the harmonic mean */
    {"lammps", "V_r", twice, false, "V_r          wang, factor 2|(harmonic mean)|diameters for radii"},
    {"lammps", "M1 M2", twice, false,
     "M1           wang, lever 2R1R2/(R1+R2) (harmonic mean)|factor 2|diameters for radii"},
    {"liggghts", "M1 M2", twice, true, "lever 2R1R2/(R1+R2) (harmonic mean)|factor 2|diameters for radii"},
    {"yade", "M1 M2", twice, false, "lever R1R2, factor 2"},
    {"liggghts", "V_s", twice, false, "V_s          midpoint, factor 2|not conjugate"},
    {"yade", "V_s", twice, false, "V_s          alonso, factor 2"},
    {"lammps", "cap", twice, false, "2R1R2/(R1+R2) (harmonic mean)|factor 2"},
    {"lammps", "V_r", half, false, "V_r          wang, factor 1/2"},
    {"liggghts", "M1 M2", half, true, "wang, lever R_eff = R1R2/(R1+R2), factor 1/2"},
    {"liggghts", "V_s", half, false, "V_s          midpoint, factor 1/2|not conjugate"},
    {"yade", "V_s", half, false, "V_s          iwashita-oda|alonso, factor 1/2"},
    {"lammps", "V_r", minus, false, "V_r          wang, sign opposite|the sign of V_r is opposite, that of V_s is not"},
    {"liggghts", "V_s", minus, true, "V_s          midpoint, sign opposite|t is reversed"},
    {"liggghts", "M1 M2", minus, false, "M1, M2 drive the rolling"},
    {"yade", "M1 M2", minus, false, "M1, M2 drive the rolling"},
    {"lammps", "V_r V_s", minus, false, "t is reversed: V_r and V_s flip together"},
    {"lammps", "V_s", full_exchanged, false, "V_s          full-radius with R1 and R2 exchanged|not objective"},
    {"liggghts", "V_s", midpoint_exchanged, false, "V_s          midpoint with R1 and R2 exchanged|not conjugate"},
    {"yade", "arm1 arm2", arms_exchanged, false, "arm 1        midpoint with R1 and R2 exchanged"},
    {"liggghts", "arm1 arm2", arms_exchanged, false, "arm 2        midpoint with R1 and R2 exchanged|not conjugate"},
    {"lammps", "V_r", bagi_kuhn, false, "V_r          bagi-kuhn"},
    {"lammps", "V_r", bagi_kuhn_exchanged, false, "V_r          bagi-kuhn with R1 and R2 exchanged"},
    {"liggghts", "M1 M2", own_radius, false,
     "the moments do not cancel|M1           wang, lever R1 |M2           wang, lever R2 "},
    {"liggghts", "M1 M2", half_of_2, false, "the moments do not cancel: M1 + M2 is up to 0.5"},
    {"yade", "M1 M2", half_of_2, false, "the moments do not cancel"},
    {"lammps", "V_r", of_the_observer, false, "V_r depends on the observer: lines"},
    {"liggghts", "V_s", of_the_observer, false, "V_s depends on the observer: lines"},
    {"liggghts", "M1 M2", moments_of_the_observer, false, "M1 depends on the observer|w1 alone"},
    {"lammps", "V_r", product_of_radii, false, "V_r          tordesillas (w1-w2), lever R1R2"},
    {"liggghts", "M1 M2", product_of_radii, true, "M1           wang, lever R1R2"},
    {"lammps", "cap", product_of_radii, false, "cap 1        R1R2"},
    {"lammps", "V_r", smaller_radius, false, "V_r          tordesillas (w1-w2), lever min(R1,R2)"},
    {"liggghts", "M1 M2", smaller_radius, true, "M1           wang, lever min(R1,R2)"},
    {"liggghts", "cap", smaller_radius, true, "cap 1        min(R1,R2)"},
    {"lammps", "V_s", full_diameters, false, "V_s          full-radius with diameters for radii|not objective"},
    {"liggghts", "V_s", midpoint_diameters, false, "V_s          midpoint, diameters for radii"},
    {"liggghts", "arm1 arm2", arms_diameters, false, "arm 1        midpoint, diameters for radii|not balanced"},
    {"liggghts", "arm1 arm2", arms_full, false, "arm 1        full|not balanced|not conjugate"},
    {"liggghts", "M1 M2", bagi_kuhn_moments, false,
     "M1           bagi-kuhn, lever R_eff|not conjugate: the moments are of"},
    {"lammps", "V_r", millimetres, false, "V_r          wang, factor 1000, as of mm"},
    {"lammps", "V_r", degrees, false, "V_r          wang, factor 180/pi, as of degrees"},
};

static void each_mistake_is_named(void **state) {
    (void)state;
    for (int k = 0; k < (int)(sizeof mistakes / sizeof *mistakes); k++) {
        const mistake *m = &mistakes[k];
        char path[80], columns[40], of[120];
        snprintf(path, sizeof path, "tests/interop/%s.csv", m->file);
        snprintf(of, sizeof of, "mistake %d, %s in %s", k, m->columns, m->file);
        read_sheet(path);
        snprintf(columns, sizeof columns, "%s", m->columns);
        for (char *name = strtok(columns, " "); name; name = strtok(NULL, " ")) {
            static double changed[ROWS];
            for (int i = 0; i < S.n; i++) changed[i] = m->of(i, name, at(i, name));
            for (int i = 0; i < S.n; i++) S.cell[i][column(name)] = changed[i];
        }
        told t = identify_sheet();
        demand(&t, of, m->good, m->words);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_codes_are_named),
        cmocka_unit_test(each_mistake_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
