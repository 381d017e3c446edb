/* SPDX-License-Identifier: MIT */
/* trundle identify on the measured answers of three codes (tests/interop), as they are and with one mistake put
 * in: the words that name it must be there, and the exit must be that of a code that is objective, balanced and
 * conjugate or not. And bad input, with its message. The formulas of the mistakes are written out here. */
#include "assert_close.h"
#include "study/card.h"
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
         "V_r            wang|M1             wang, lever R_eff = R1R2/(R1+R2)|cap 1          R_eff|V_s            "
         "full-radius|not "
         "objective when disks overlap|1 overlap*w in a rigid rotation|arm 1          midpoint|LAMMPS 29Sep2021|power "
         "of "
         "friction "
         "differs from F_t V_s|at 5 % overlap"},
        {"liggghts", true,
         "M1             wang, lever R_eff = R1R2/(R1+R2)|cap 1          R_eff|V_s            midpoint|arm 2          "
         "midpoint|good: "
         "objective: yes, balanced: yes, conjugate: yes"},
        {"yade", false,
         "(w1-w2), lever R1R2|wang, lever R1+R2|cap 1          min(R1,R2)|V_s            alonso|arm 1          "
         "midpoint|YADE "
         "2023.02a|not conjugate|!not objective"},
        {"yade-no-ratcheting", true, "V_s            midpoint|arm 1          midpoint|conjugate: yes"},
        {"yade-mindlin", true, "M1             tordesillas (w1-w2) ["},
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
    {"lammps", "V_r", twice, false, "V_r            wang, factor 2|(harmonic mean)|diameters for radii"},
    {"lammps", "M1 M2", twice, false,
     "M1             wang, lever 2R1R2/(R1+R2) (harmonic mean)|factor 2|diameters for radii"},
    {"liggghts", "M1 M2", twice, true, "lever 2R1R2/(R1+R2) (harmonic mean)|factor 2|diameters for radii"},
    {"yade", "M1 M2", twice, false, "lever R1R2, factor 2"},
    {"liggghts", "V_s", twice, false, "V_s            midpoint, factor 2|not conjugate"},
    {"yade", "V_s", twice, false, "V_s            alonso, factor 2"},
    {"lammps", "cap", twice, false, "2R1R2/(R1+R2) (harmonic mean)|factor 2"},
    {"lammps", "V_r", half, false, "V_r            wang, factor 1/2"},
    {"liggghts", "M1 M2", half, true, "wang, lever R_eff = R1R2/(R1+R2), factor 1/2"},
    {"liggghts", "V_s", half, false, "V_s            midpoint, factor 1/2|not conjugate"},
    {"yade", "V_s", half, false, "V_s            iwashita-oda|alonso, factor 1/2"},
    {"lammps", "V_r", minus, false,
     "V_r            wang, sign opposite|the sign of V_r is opposite, that of V_s is not"},
    {"liggghts", "V_s", minus, true, "V_s            midpoint, sign opposite|t is reversed"},
    {"liggghts", "M1 M2", minus, false, "M1, M2 drive the rolling"},
    {"yade", "M1 M2", minus, false, "M1, M2 drive the rolling"},
    {"lammps", "V_r V_s", minus, false, "t is reversed: V_r and V_s flip together"},
    {"lammps", "V_s", full_exchanged, false, "V_s            full-radius with R1 and R2 exchanged|not objective"},
    {"liggghts", "V_s", midpoint_exchanged, false, "V_s            midpoint with R1 and R2 exchanged|not conjugate"},
    {"yade", "arm1 arm2", arms_exchanged, false, "arm 1          midpoint with R1 and R2 exchanged"},
    {"liggghts", "arm1 arm2", arms_exchanged, false, "arm 2          midpoint with R1 and R2 exchanged|not conjugate"},
    {"lammps", "V_r", bagi_kuhn, false, "V_r            bagi-kuhn"},
    {"lammps", "V_r", bagi_kuhn_exchanged, false, "V_r            bagi-kuhn with R1 and R2 exchanged"},
    {"liggghts", "M1 M2", own_radius, false,
     "the moments do not cancel|M1             wang, lever R1 |M2             wang, lever R2 "},
    {"liggghts", "M1 M2", half_of_2, false, "the moments do not cancel: M1 + M2 is up to 0.5"},
    {"yade", "M1 M2", half_of_2, false, "the moments do not cancel"},
    {"lammps", "V_r", of_the_observer, false, "V_r depends on the observer: lines"},
    {"liggghts", "V_s", of_the_observer, false, "V_s depends on the observer: lines"},
    {"liggghts", "M1 M2", moments_of_the_observer, false, "M1 depends on the observer|w1 alone"},
    {"lammps", "V_r", product_of_radii, false, "V_r            tordesillas (w1-w2), lever R1R2"},
    {"liggghts", "M1 M2", product_of_radii, true, "M1             wang, lever R1R2"},
    {"lammps", "cap", product_of_radii, false, "cap 1          R1R2"},
    {"lammps", "V_r", smaller_radius, false, "V_r            tordesillas (w1-w2), lever min(R1,R2)"},
    {"liggghts", "M1 M2", smaller_radius, true, "M1             wang, lever min(R1,R2)"},
    {"liggghts", "cap", smaller_radius, true, "cap 1          min(R1,R2)"},
    {"lammps", "V_s", full_diameters, false, "V_s            full-radius with diameters for radii|not objective"},
    {"liggghts", "V_s", midpoint_diameters, false, "V_s            midpoint, diameters for radii"},
    {"liggghts", "arm1 arm2", arms_diameters, false, "arm 1          midpoint, diameters for radii|not balanced"},
    {"liggghts", "arm1 arm2", arms_full, false, "arm 1          full|not balanced|not conjugate"},
    {"liggghts", "M1 M2", bagi_kuhn_moments, false,
     "M1             bagi-kuhn, lever R_eff|not conjugate: the moments are of"},
    {"lammps", "V_r", millimetres, false, "V_r            wang, factor 1000, as of mm"},
    {"lammps", "V_r", degrees, false, "V_r            wang, factor 180/pi, as of degrees"},
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

/* ---- a code that runs the card */

typedef struct made_code {
    const char *name;
    double at_wall;     /* 2: there the arms lack all of the overlap, 1: half of it */
    double slide, turn; /* what of half the overlap the arms lack, of the velocity and of the torque */
    double F_t;         /* sign of friction */
    bool good;
    const char *words;
} made_code;

static void run_card(const made_code *c, FILE *out) {
    static tr_card_row row[TR_CARD_ROWS];
    tr_card_make(row);
    fputs("R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2,k_t,k_roll,mu_r,time,F_n,F_t,M1,M2\n", out);
    for (int i = 0; i < TR_CARD_ROWS; i++) {
        const tr_card_row *r = &row[i];
        const tr_motion *m = &r->motion;
        bool wall = isinf(m->R1);
        double dx = m->x2x - m->x1x, dy = m->x2y - m->x1y, L = hypot(dx, dy), d = r->overlap * (wall ? c->at_wall : 1);
        double Vt = ((m->v2x - m->v1x) * dy - (m->v2y - m->v1y) * dx) / L, R1 = wall ? 0 : m->R1;
        double R_eff = wall ? m->R2 : R1 * m->R2 / (R1 + m->R2), F_n = r->k_n * r->overlap;
        double V_s = Vt + m->R2 * m->w2 + R1 * m->w1 - c->slide * d / 2 * (wall ? m->w2 : m->w1 + m->w2);
        double F_t = c->F_t * r->k_t * V_s * r->time_s, T = r->k_roll * R_eff * (m->w1 - m->w2) * r->time_s;
        double cap = r->mu_r * F_n, M = fmax(-cap, fmin(cap, T)) * R_eff;
        double M1 = -M - (wall ? 0 : R1 - c->turn * d / 2) * F_t, M2 = M - (m->R2 - c->turn * d / 2) * F_t;
        const double cell[] = {m->R1, m->R2, m->x1x, m->x1y,    m->x2x,  m->x2y,    m->v1x, m->v1y, m->v2x, m->v2y,
                               m->w1, m->w2, r->k_t, r->k_roll, r->mu_r, r->time_s, F_n,    F_t,    M1,     M2};
        for (int k = 0; k < 20; k++) fprintf(out, "%.17g%c", cell[k], k < 19 ? ',' : '\n');
    }
}

static void a_code_that_runs_the_card_is_named(void **state) {
    (void)state;
    static const made_code codes[] = {
        {"midpoint arms", 2, 1, 1, 1, true,
         "good: objective: yes, balanced: yes, conjugate: yes|M1             wang, lever R_eff|cap 2          "
         "R_eff|F_t            "
         "midpoint|arm 1          midpoint|F_t at wall    midpoint|arm 2 at wall  midpoint"},
        {"full radii in the velocity", 2, 0, 1, 1, false,
         "F_t            full-radius|arm 2          midpoint|LAMMPS 29Sep2021|at a wall: velocity wang"},
        {"half of the overlap at walls", 1, 1, 1, 1, true,
         "F_t at wall    half of the overlap|arm 2 at wall  half of the overlap"},
        {"full radii", 2, 0, 0, 1, false, "arm 1          full|not balanced|not objective when disks overlap"},
        {"friction that drives", 2, 1, 1, -1, false, "F_t drives the sliding"},
    };
    for (int k = 0; k < (int)(sizeof codes / sizeof *codes); k++) {
        char path[] = "/tmp/trundle-identify-XXXXXX";
        FILE *out = fdopen(mkstemp(path), "w");
        assert_non_null(out);
        run_card(&codes[k], out);
        fclose(out);
        told t = identify(path, NULL);
        unlink(path);
        if (!t.ok) fail_msg("%s", t.st.text);
        demand(&t, codes[k].name, codes[k].good, codes[k].words);
    }
}

/* ---- what is refused, and what cannot be told */

#define HEADER "R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2"
#define STATE "0.01,0.02,0,0,0.029,0,0,0,0,0.01,3,1"
#define OTHER "0.01,0.02,0,0,0.029,0,0,0,0,0.02,1,-1"

static told identify_text(const char *text) {
    char path[] = "/tmp/trundle-identify-XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0 && write(fd, text, strlen(text)) == (ssize_t)strlen(text) && close(fd) == 0);
    told t = identify(path, NULL);
    unlink(path);
    return t;
}

static void bad_files_are_refused(void **state) {
    (void)state;
    static const struct {
        const char *text, *message;
    } bad[] = {
        {"", ":1: error: the file is empty"},
        {HEADER ",V_r\n", ":2: error: no rows"},
        {"R1,R2,x1x,x1y,x2x,v1x,v1y,v2x,v2y,w1,w2,V_r\n", "no column x2y"},
        {HEADER "\n" STATE "\n", ":1: error: no row has an answer: add a column V_r"},
        {HEADER ",V_r\n" STATE ",nan\n", ":2: error: V_r is nan: leave the cell empty"},
        {HEADER ",V_r\n" STATE ",fast\n", ":2: error: V_r is \"fast\", which is not a number"},
        {HEADER ",V_r\n" STATE ",0.1,4\n", ":2: error: 14 cells, but the header line has 13"},
        {HEADER ",V_r\n" STATE ",0\n" OTHER ",0\n", ":2: error: column V_r is 0 in all its rows (lines 2 to 3)"},
        {HEADER ",V_r\n" STATE ",0.7\n" OTHER ",0.7\n", ":2: error: column V_r is the same number in all its rows"},
        {HEADER ",V_r\n0.01,0.02,0,0,29,0,0,0,0,0.01,3,1,0.1\n", ":2: error: the centres are 967 times R1+R2 apart"},
        {HEADER ",M1\n0.01,0.02,0,0,0.031,0,0,0,0,0.01,3,1,0.1\n", ":2: error: in no row do the two touch"},
        {HEADER ",M1,k_roll\n" STATE ",0.1,-3\n", ":2: error: k_roll is -3: it must be at least 0"},
        {HEADER ",M1,k_roll\n" STATE ",0.1,0\n", ":2: error: no row has an answer that can be explained"},
        {HEADER ",M1,k_roll,mu_r,F_n\n" STATE ",0.1,1,1,0.1\n", ":2: error: the spring (k_roll, time) and its bound"},
        {HEADER ",V_r\n-1,0.02,0,0,0.029,0,0,0,0,0.01,3,1,1\n", ":2: error: R1 is -1: a radius is above 0"},
        {HEADER ",V_r\n0.01,0.02,0,0,0,0,0,0,0,0.01,3,1,1\n", ":2: error: the centres coincide"},
        {HEADER ",V_r\n1e30,0.02,0,0,0.029,0,0,0,0,0.01,3,1,1\n", ":2: error: radii are 1e+30 m"},
        {HEADER ",V_r\n" STATE ",1e99\n", ":2: error: V_r is 1e+99, which is too large"},
        {"ITEM: TIMESTEP\n0\n", ":1: error: this is a dump of LAMMPS or LIGGGHTS"},
        {"# vtk DataFile Version 3.0\n", ":1: error: this is a file of VTK"},
        {"kind: bodies\n", ":1: error: this is a case of trundle"},
        {"R1;R2;V_r\n1;2;3\n", ":1: error: no column R1,R2,x1x"},
    };
    for (int k = 0; k < (int)(sizeof bad / sizeof *bad); k++) {
        told t = identify_text(bad[k].text);
        if (t.ok || t.st.code != TR_BAD_CASE || !strstr(t.st.text, bad[k].message))
            fail_msg("bad file %d: \"%s\" is not in \"%s\"", k, bad[k].message, t.st.text);
        free(t.text);
    }
}

/* Without overlap all arms are one: a row is asked for that tells them apart, and with it they are told. */
static void a_row_that_tells_apart_is_asked_for(void **state) {
    (void)state;
    const char *apart = HEADER ",V_s\n0.01,0.02,0,0,0.03,0,0,0,0,0.01,3,1,0.04\n"
                               "0.01,0.02,0,0,0.03,0,0,0,0,0.02,1,-1,-0.03\n"; /* Vt = -v2y; R1 w1 + R2 w2 + Vt */
    told t = identify_text(apart);
    if (!t.ok) fail_msg("%s", t.st.text);
    const char *row = strstr(t.text, HEADER "\n");
    if (!row || !strstr(t.text, "not told apart: V_s is wang, or alonso")) fail_msg("%s", t.text);
    double m[12], V_s, L, Vt;
    const char *p = row + strlen(HEADER) + 1;
    for (int k = 0; k < 12; k++, p++) {
        char *end;
        m[k] = strtod(p, &end);
        p = end;
    }
    L = hypot(m[4] - m[2], m[5] - m[3]);
    Vt = ((m[8] - m[6]) * (m[5] - m[3]) - (m[9] - m[7]) * (m[4] - m[2])) / L;
    V_s = Vt + L / (m[0] + m[1]) * (m[0] * m[10] + m[1] * m[11]);
    char text[1000];
    snprintf(text, sizeof text, "%s%.*s,%.12g\n", apart, (int)strcspn(row + strlen(HEADER) + 1, "\n"),
             row + strlen(HEADER) + 1, V_s);
    free(t.text);
    t = identify_text(text);
    if (!t.ok) fail_msg("%s", t.st.text);
    demand(&t, "the row that was asked for", true, "V_s            wang|!not told apart");
}

/* Columns by other names. */
static void names_are_mapped(void **state) {
    (void)state;
    char path[] = "/tmp/trundle-identify-XXXXXX";
    int fd = mkstemp(path);
    static const char text[] = "r_one,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2,roll\n" STATE ",0.0133333333333\n" OTHER
                               ",0.0133333333333\n0.01,0.05,0,0,0.055,0,0,0,0,0.01,2,4,-0.016666666666667\n";
    assert_true(fd >= 0 && write(fd, text, strlen(text)) == (ssize_t)strlen(text) && close(fd) == 0);
    tr_identify_map map = {2, {"r_one", "roll"}, {"R1", "V_r"}};
    told t = identify(path, &map);
    unlink(path);
    if (!t.ok) fail_msg("%s", t.st.text);
    demand(&t, "other names", true, "V_r            wang");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_codes_are_named),
        cmocka_unit_test(each_mistake_is_named),
        cmocka_unit_test(a_code_that_runs_the_card_is_named),
        cmocka_unit_test(bad_files_are_refused),
        cmocka_unit_test(a_row_that_tells_apart_is_asked_for),
        cmocka_unit_test(names_are_mapped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
