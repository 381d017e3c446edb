/* SPDX-License-Identifier: MIT */
/* trundle measures: the numbers against values by hand and against definitions evaluated here in another way
 * (velocities of material points, cross products, the equations that the decomposition must satisfy), to 1e-12 of the
 * velocity scale; the table's way through a file; and what is refused, with its message. */
#include "assert_close.h"
#include "laws/kinematics.h"
#include "laws/law.h"
#include "study/card.h"
#include "study/measures.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double TIGHT = 1e-12;

static tr_motion_measures of(tr_motion m) {
    tr_status st = {0};
    tr_motion_measures r;
    assert_true(tr_measures_motions(&m, 1, &r, &st));
    return r;
}

static double at(const tr_motion_measures *r, int k) {
    double v;
    memcpy(&v, (const char *)r + tr_measures_column_of(k).offset, sizeof v);
    return v;
}

/* One of its columns, which must be there. */
static double by(const tr_motion_measures *r, const char *name) {
    double v = tr_measures_of_column(r, name);
    if (isnan(v)) fail_msg("no column %s", name);
    return v;
}

/* ---- by hand */

static const char *const columns[] = {"beta_dot",
                                      "Vt",
                                      "da",
                                      "db",
                                      "s1",
                                      "s2",
                                      "Vr_wang",
                                      "Vs_wang",
                                      "Vs_full_radii",
                                      "Vr_bagi_kuhn",
                                      "Us_iwashita_oda",
                                      "Vr_alonso_min",
                                      "Vr_alonso_mean",
                                      "Vs_alonso",
                                      "Vr_tordesillas",
                                      "Vr_jiang",
                                      "Us_jiang",
                                      "Vroll_kuhn",
                                      "lambda_dot",
                                      "alpha1_dot",
                                      "alpha2_dot"};
enum { COLUMNS = sizeof columns / sizeof *columns };

static void check_all(tr_motion m, const double expected[COLUMNS], double tolerance) {
    tr_motion_measures r = of(m);
    for (int k = 0; k < COLUMNS; k++)
        if (!(fabs(by(&r, columns[k]) - expected[k]) <= tolerance))
            fail_msg("%s is %.17g, expected %.17g", columns[k], by(&r, columns[k]), expected[k]);
}

static void test_pairs_by_hand(void **state) {
    (void)state;
    /* n = (1,0), t = (0,-1): Vt = -0.6, betadot = 0.2; gears seen by an observer who turns. */
    tr_motion m = {.R1 = 2, .R2 = 1, .x2x = 3, .v2y = 0.6, .w1 = 0.5, .w2 = -0.4};
    check_all(
        m, (double[]){0.2, -0.6, 0.6, -0.6, 0.6, 0.6, 0.6, 0, 0, 0.6, 0, 0.6, 0.6, 0, 0.9, 0.6, 0, -0.6, 0, 0.3, -0.6},
        TIGHT);
    m.w2 = 0.4; /* s2 = -0.2 */
    check_all(m, (double[]){0.2, -0.6, 0.6, 0.2, 0.6,     -0.2, 0.2 / 3, 0.8,     0.8,     0.2,     0.4,
                            0,   0,    0.8, 0.1, 0.2 / 3, 0.4,  -0.2,    0.8 / 3, 0.1 / 3, -0.2 / 3},
              TIGHT);
    m.x2x = 2.5; /* overlap 0.5: arms 5/3 and 5/6, betadot = 0.24, s1 = 0.52, s2 = -0.16 */
    check_all(m, (double[]){0.24, -0.6, 0.52, 0.16, 0.52,    -0.16, 0.2 / 3, 1.7 / 3,  0.8,     0.18,    0.34,
                            0,    0,    0.68, 0.1,  0.2 / 3, 0.34,  -0.18,   0.68 / 3, 0.1 / 3, -0.2 / 3},
              TIGHT);
    /* Apart, s1 and s2 alike but unequal: x21 = (0, 4), t = (1,0), Vt = 0.4, betadot = -0.1 */
    m = (tr_motion){
        .R1 = 1, .R2 = 2, .x1x = 5, .x1y = -1, .x2x = 5, .x2y = 3, .v1x = 0.1, .v2x = 0.5, .w1 = 0.2, .w2 = -0.2};
    check_all(m, (double[]){-0.1, 0.4,  0.3, -0.2, 0.3,     0.2,  0.8 / 3, 0.4 / 3, 0.2,     0.25,    0.05,
                            0.2,  0.25, 0.1, 0.4,  0.8 / 3, 0.05, -0.25,   0.1 / 3, 0.8 / 3, -0.4 / 3},
              TIGHT);
}

static void test_walls_by_hand(void **state) {
    (void)state;
    /* n = (0,1), t = (1,0). The wall moves with 0.1; the disk overlaps, which does not count. */
    tr_motion m = {.R1 = INFINITY, .R2 = 0.5, .x2y = 0.48, .v1x = 0.1, .v2x = 0.4, .v2y = -0.2, .w2 = -0.8};
    double e[] = {0,   0.3,  0.3,  -0.4, 0.3, 0.4,   0.4,   -0.1, -0.1, 0.35, -0.05,
                  0.3, 0.35, -0.1, 0.8,  0.4, -0.05, -0.35, 0,    0,    -0.8};
    check_all(m, e, TIGHT);
    /* All that turns with 2 rad/s about x1 besides changes but the spin of the normal. */
    m.w1 += 2, m.w2 += 2, m.v2x += -2 * 0.48, e[0] = 2;
    check_all(m, e, TIGHT);
    /* ... and about a point elsewhere, (3, -1) */
    m.w1 += 1, m.w2 += 1, e[0] = 3;
    m.v1x += -1 * (0 + 1), m.v1y += 1 * (0 - 3), m.v2x += -1 * (0.48 + 1), m.v2y += 1 * (0 - 3);
    check_all(m, e, 10 * TIGHT);
}

/* A wall is what a pair becomes for R1 -> inf, side 1, and a ring for R1 -> -inf, side -1: the error falls as 1/R1. */
static void look_at_limit(double side) {
    tr_motion wall = {
        .R1 = INFINITY, .R2 = 0.5, .x2x = 0.3, .x2y = 0.4, .v1x = 0.1, .v2x = 0.4, .v2y = -0.2, .w1 = 0.3, .w2 = -0.8};
    double nx = 0.6, ny = 0.8; /* touching: the arms have no say */
    tr_motion_measures limit = of(wall);
    double error[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        tr_motion pair = wall;
        double R1 = pair.R1 = side * (k ? 1e5 : 1e4);
        pair.x1x = -R1 * nx, pair.x1y = -R1 * ny;
        pair.v1x = wall.v1x + wall.w1 * R1 * ny, pair.v1y = wall.v1y - wall.w1 * R1 * nx;
        tr_motion_measures r = of(pair);
        for (int j = 0; j < tr_measures_columns(); j++) /* V_t alone is as the wall sees it: the pair's grows with R1 */
            if (strcmp(tr_measures_column_of(j).name, "Vt")) error[k] = fmax(error[k], fabs(at(&r, j) - at(&limit, j)));
    }
    print_message("%s less wall: %.3g at R1 = 1e4, %.3g at 1e5\n", side < 0 ? "ring" : "pair", error[0], error[1]);
    assert_true(error[0] < 1e-3 && error[1] < 0.11 * error[0]);
}

static void test_wall_is_the_limit(void **state) {
    (void)state;
    look_at_limit(1), look_at_limit(-1);
}

/* ---- any motion, by definitions in another form */

static double random_unit(unsigned *seed) {
    *seed = *seed * 1664525u + 1013904223u;
    return *seed / 4294967296.0 * 2 - 1;
}

static tr_motion any_motion(unsigned *seed) {
    double R1 = pow(10, 0.5 * random_unit(seed)), R2 = pow(10, 0.5 * random_unit(seed)), a = M_PI * random_unit(seed);
    double L = R1 + R2 + 0.1 * random_unit(seed) * fmin(R1, R2); /* overlapping or apart */
    tr_motion m = {.R1 = R1, .R2 = R2, .x1x = random_unit(seed), .x1y = random_unit(seed)};
    m.x2x = m.x1x + L * cos(a), m.x2y = m.x1y + L * sin(a);
    m.v1x = random_unit(seed), m.v1y = random_unit(seed), m.w1 = random_unit(seed);
    m.v2x = random_unit(seed), m.v2y = random_unit(seed), m.w2 = random_unit(seed);
    return m;
}

/* How fast the material of 2 at the ends of the arms passes that of 1, along t. */
static double passing(const tr_motion *m, double r1, double r2, double nx, double ny) {
    double ax = m->v1x - m->w1 * r1 * ny, ay = m->v1y + m->w1 * r1 * nx;
    double bx = m->v2x + m->w2 * r2 * ny, by = m->v2y - m->w2 * r2 * nx;
    return (bx - ax) * ny - (by - ay) * nx;
}

static double smaller(double a, double b) {
    return fabs(a) < fabs(b) ? a : b;
}

static void test_definitions(void **state) {
    (void)state;
    unsigned seed = 7;
    for (int k = 0; k < 2000; k++) {
        tr_motion m = any_motion(&seed);
        tr_motion_measures r = of(m);
        double dx = m.x2x - m.x1x, dy = m.x2y - m.x1y, ux = m.v2x - m.v1x, uy = m.v2y - m.v1y, L = hypot(dx, dy);
        double beta = (dx * uy - dy * ux) / (L * L), nx = dx / L, ny = dy / L, R1 = m.R1, R2 = m.R2, sum = R1 + R2;
        double a = TIGHT * (sum + 3), da = R1 * m.w1 - R1 * beta, db = R2 * m.w2 - R2 * beta;
        /* [Wang2015 eq. 16] with t = k x n, the opposite of ours, and |X21| for R1 + R2 */
        double eq16 = 0.5 * (R1 * m.w1 - R2 * m.w2 - (R2 - R1) / L * (ux * ny - uy * nx));
        assert_close(r.beta_dot, beta, 0, a);
        assert_close(r.Vt, -L * beta, 0, a);
        assert_close(r.da, da, 0, a);
        assert_close(r.db, db, 0, a);
        assert_close(r.s1, da, 0, a);
        assert_close(r.s2, -db, 0, a);
        assert_close(by(&r, "Vr_wang"), R1 * R2 * (m.w1 - m.w2) / sum, 0, a);
        assert_close(by(&r, "Vs_wang"), passing(&m, L * R1 / sum, L * R2 / sum, nx, ny), 0, a);
        assert_close(by(&r, "Vs_full_radii"), passing(&m, R1, R2, nx, ny), 0, a);
        assert_close(by(&r, "Vr_bagi_kuhn"), eq16, 0, a);
        assert_close(by(&r, "Us_iwashita_oda"), by(&r, "Vs_wang") * sum / L / 2, 0, a);
        assert_close(by(&r, "Vr_alonso_min"), da * db < 0 ? smaller(da, -db) : 0, 0, a);
        assert_close(by(&r, "Vr_alonso_mean"), da * db < 0 ? eq16 : 0, 0, a);
        assert_close(by(&r, "Vs_alonso"), by(&r, "Vs_wang") * sum / L, 0, a);
        assert_close(by(&r, "Vr_tordesillas"), m.w1 - m.w2, 0, a);
        assert_close(by(&r, "Vr_jiang"), R1 * R2 * (m.w1 - m.w2) / sum, 0, a); /* eq. 26 is eq. 9 */
        assert_close(by(&r, "Us_jiang"), by(&r, "Vs_wang") * sum / L / 2, 0, a);
        assert_close(by(&r, "Vroll_kuhn"), -eq16, 0, a);
        double lost = (sum - L) / 2; /* of each arm */
        assert_close(by(&r, "Vs_midpoint"), passing(&m, R1 - lost, R2 - lost, nx, ny), 0, a);
        /* [Wang2015 eqs. 7a-7c], which define the decomposition, and 2c, 4c, which use it */
        assert_close(r.alpha1_dot + r.lambda_dot, m.w1 - beta, 0, a);
        assert_close(r.alpha2_dot + r.lambda_dot, m.w2 - beta, 0, a);
        assert_close(R1 * r.alpha1_dot, -R2 * r.alpha2_dot, 0, a);
        assert_close(R1 * r.alpha1_dot, by(&r, "Vr_wang"), 0, a);
        assert_close(sum * r.lambda_dot, by(&r, "Vs_alonso"), 0, a);
    }
}

/* Many at once, pairs and walls mixed, over several tiles: the same bits as one by one. */
static void test_many_motions(void **state) {
    (void)state;
    enum { N = 333 };
    static tr_motion m[N];
    static tr_motion_measures r[N];
    unsigned seed = 9;
    for (int i = 0; i < N; i++) {
        m[i] = any_motion(&seed);
        if (i % 3 == 1) m[i].R1 = INFINITY;
    }
    tr_status st = {0};
    assert_true(tr_measures_motions(m, N, r, &st));
    for (int i = 0; i < N; i++) {
        tr_motion_measures one = of(m[i]);
        assert_memory_equal(&one, &r[i], sizeof one);
    }
}

/* ---- the card */

static void test_card(void **state) {
    (void)state;
    static tr_card_motion card[TR_CARD_MOTIONS];
    tr_measures_card(card);
    for (int i = 0; i < TR_CARD_MOTIONS; i++) {
        const tr_card_motion *c = &card[i];
        tr_motion_measures r = of(c->motion), other = of(card[i ^ 1].motion);
        assert_close(by(&r, "Vr_wang"), c->Vr, 0, TIGHT);
        assert_close(by(&r, "Vs_wang"), c->Vs, 0, TIGHT);
        for (int k = 0; k < tr_measures_columns(); k++) { /* both observers agree, on all that is objective */
            const char *name = tr_measures_column_of(k).name;
            bool seen = !strcmp(name, "beta_dot") || !strcmp(name, "Vt");
            if (!strcmp(name, "Vs_full_radii") && !strcmp(c->name, "RBR overlap")) {
                /* [Wang2015 eq. 12]: overlap times the spin of all */
                assert_close(by(&r, "Vs_full_radii"), 0.1 * TR_CARD_R2 * c->motion.w1, 0, TIGHT);
                seen = true;
            }
            if (!seen) assert_close(at(&r, k), at(&other, k), 0, TIGHT);
        }
    }
}

/* The card for other codes: places overlap as they say, all observers see one motion, and each motion is what its name
 * says, by speeds of the rims worked out here. */
static void test_card_for_codes(void **state) {
    (void)state;
    static tr_card_row row[TR_CARD_ROWS];
    tr_card_make(row);
    for (int i = 0; i < TR_CARD_ROWS; i++) {
        const tr_motion *m = &row[i].motion;
        double L = hypot(m->x2x - m->x1x, m->x2y - m->x1y), sum = isinf(m->R1) ? m->R2 : m->R1 + m->R2;
        bool wall = isinf(m->R1);
        assert_close(sum - L, row[i].overlap, 0, 1e-15);
        assert_close(row[i].overlap / sum, strstr(row[i].label, "0.1%") ? 0.001 : 0.05, 1e-12, 0);
        assert_true(strstr(row[i].label, "RBR") == row[i].label || fabs(of(*m).s1) + fabs(of(*m).s2) > 1e-3);
        enum { HALF = TR_CARD_ROWS / 2, PAIRS = 3 * TR_CARD_PAIRS / 2 }; /* of one overlap; floors come last */
        int first = wall ? (i % HALF - PAIRS) % 6 : i % HALF % 9,
            same = i - first + first % 3; /* the resting observer */
        tr_motion_measures one = of(row[same].motion), r = of(*m);
        assert_close(r.s1, one.s1, 0, TIGHT);
        assert_close(r.s2, one.s2, 0, TIGHT);
        if (!strncmp(row[i].label, "RBR", 3)) assert_close(fabs(r.s1) + fabs(r.s2), 0, 0, TIGHT);
        if (!strncmp(row[i].label, "PR", 2)) assert_close(r.s1, r.s2, 0, TIGHT);
        if (strstr(row[i].label, "mixed")) assert_close(r.s2, 2 * r.s1, 0, TIGHT);
        if (!strncmp(row[i].label, "PS R", 4)) assert_close(by(&r, "Vs_wang"), 0.01, TIGHT, 0);
        if (strstr(row[i].label, "rolling")) assert_close(r.s1, r.s2, 0, TIGHT);
        double ratio = 0;
        if (!wall) {
            assert_int_equal(sscanf(strstr(row[i].label, "R1/R2="), "R1/R2=%lg", &ratio), 1);
            assert_close(m->R1 / m->R2, ratio, 1e-14, 0);
            assert_close(fmin(m->R1, m->R2), 0.01, 1e-14, 0);
        }
        int springs = (row[i].k_t > 0) + (row[i].k_roll > 0); /* one experiment a row */
        assert_int_equal(springs, 1);
    }
}

/* Columns of --arms, by hand: R1 = 2, R2 = 1, |X21| = 2.5, overlap 0.5; Vt = -0.6. */
static void test_arms_by_hand(void **state) {
    (void)state;
    tr_motion_measures r = of((tr_motion){.R1 = 2, .R2 = 1, .x2x = 2.5, .v2y = 0.6, .w1 = 0.5, .w2 = 0.4});
    static const double wanted[][3] = {{5.0 / 3, 2.5 / 3, -0.6 + 2.5 / 3 + 1.0 / 3},
                                       {1.75, 0.75, -0.6 + 0.875 + 0.3},
                                       {2, 1, -0.6 + 1 + 0.4},
                                       {1.75, 0.75, 0.575},
                                       {1.75, 0.75, 0.575}};
    for (int k = 0; k < tr_n_arms_measured; k++) {
        assert_close(r.arms[k].r1, wanted[k][0], TIGHT, 0);
        assert_close(r.arms[k].r2, wanted[k][1], TIGHT, 0);
        assert_close(r.arms[k].power, wanted[k][2], TIGHT, 0);
    }
}

/* ---- errata that other tests do not show */

static void test_errata(void **state) {
    (void)state;
    /* [Wang2015 eq. 13] divides by (R1+R2)^2: with overlap a normal part is left in V_t; |X21|^2 leaves none. */
    double R1 = 2, R2 = 0.75, L = 2.5, approach = -0.3;
    tr_motion m = {.R1 = R1, .R2 = R2, .x2x = L, .v2x = approach};
    double printed = approach - L * (approach * L) / ((R1 + R2) * (R1 + R2)),
           meant = approach - L * (approach * L) / (L * L);
    assert_close(printed, approach * (1 - L * L / ((R1 + R2) * (R1 + R2))), TIGHT, 0);
    assert_true(fabs(printed) > 0.05);
    assert_close(meant, 0, 0, TIGHT);
    assert_close(of(m).Vt, 0, 0, TIGHT);
    /* Eq. 5 equates the rotations with da/R1, db/R2: in pure sliding with rigid rotation (eq. 6) nothing rotates, yet
     * da/R1 = db/R2 = -betadot. */
    double beta = 0.4;
    m = (tr_motion){.R1 = R1, .R2 = R2, .x2x = R1 + R2, .v2y = beta * (R1 + R2)};
    tr_motion_measures r = of(m);
    assert_close(r.da / R1, -beta, TIGHT, 0);
    assert_close(r.db / R2, -beta, TIGHT, 0);
    assert_close(r.lambda_dot, -beta, TIGHT, 0);
    /* Eq. 25 is an angle: gears of equal rim speed 1 have as many values as sizes; eq. 11 has one. */
    for (int k = 1; k <= 3; k++) {
        r = of((tr_motion){.R1 = k, .R2 = 1, .x2x = k + 1, .w1 = 1.0 / k, .w2 = -1});
        assert_close(by(&r, "Vr_tordesillas"), 1 + 1.0 / k, TIGHT, 0);
        assert_close(by(&r, "Vr_wang"), 1, TIGHT, 0);
    }
}

/* ---- files */

#define HEADER "case,R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2"

typedef struct result {
    bool ok;
    tr_status st;
    char *text;
} result;

static result run(const char *text, size_t length) {
    char in[] = "/tmp/trundle-measures-XXXXXX";
    int fd = mkstemp(in);
    assert_true(fd >= 0 && write(fd, text, length) == (ssize_t)length && close(fd) == 0);
    result r = {0};
    size_t size = 0;
    FILE *out = open_memstream(&r.text, &size);
    r.ok = tr_measures_csv(in, false, out, &r.st);
    fclose(out);
    unlink(in);
    if (!r.ok) { /* the name is not always the same */
        size_t skip = strlen(in);
        if (!strncmp(r.st.text, in, skip)) memmove(r.st.text, r.st.text + skip, strlen(r.st.text + skip) + 1);
    }
    return r;
}

static char *good(const char *text) {
    result r = run(text, strlen(text));
    if (!r.ok) fail_msg("refused: %s", r.st.text);
    return r.text;
}

static int lines_of(const char *text) {
    int n = 0;
    for (; *text; text++) n += *text == '\n';
    return n;
}

static void test_round_trip(void **state) {
    (void)state;
    enum { N = 200 };
    static tr_motion m[N];
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    unsigned seed = 11;
    fprintf(f, "%s\n", HEADER);
    for (int i = 0; i < N; i++) {
        m[i] = any_motion(&seed);
        if (i % 5 == 0) m[i].R1 = INFINITY;
        fprintf(f, "row %d", i);
        for (int k = 0; k < TR_MOTION_COLUMNS; k++) {
            double v;
            memcpy(&v, (const char *)&m[i] + tr_motion_columns[k].offset, sizeof v);
            fprintf(f, ",%.17g", v);
        }
        fprintf(f, "\n");
    }
    fclose(f);
    char *once = good(text), *twice = good(once);
    assert_string_equal(once, twice); /* its own output is an input: the measures are further columns */
    char header[1000] = HEADER ",beta_dot,Vt,da,db,s1,s2"; /* and the definitions, in the order of their tables */
    for (int k = 0; k < tr_n_rolling_measures; k++) strcat(strcat(header, ","), tr_rolling_velocities[k].column);
    for (int k = 0; k < tr_n_sliding_measures; k++) strcat(strcat(header, ","), tr_sliding_velocities[k].column);
    assert_string_equal(strtok(once, "\n"), strcat(header, ",lambda_dot,alpha1_dot,alpha2_dot"));
    for (int i = 0; i < N; i++) {
        char *cell = strtok(NULL, "\n"), label[24];
        tr_motion_measures r = of(m[i]);
        snprintf(label, sizeof label, "row %d,", i);
        assert_memory_equal(cell, label, strlen(label));
        for (int k = 0; k < 1 + TR_MOTION_COLUMNS; k++) cell = strchr(cell, ',') + 1;
        for (int k = 0; k < tr_measures_columns(); k++) {
            char *end;
            assert_true(strtod(cell, &end) == at(&r, k)); /* every bit */
            assert_true(*end == (k + 1 < tr_measures_columns() ? ',' : '\0'));
            cell = end + 1;
        }
    }
    free(text), free(once), free(twice);
}

#define ROW "a,2,1,0,0,3,0,0,0,0,0.6,0.5,-0.4"

static void test_forms_of_a_file(void **state) {
    (void)state;
    char *plain = good(HEADER "\n" ROW "\n");
    static const char *const same[] = {
        HEADER "\n" ROW,          /* no end of line */
        HEADER "\r\n" ROW "\r\n", /* of other systems */
        HEADER "\r" ROW "\r",
        "\xEF\xBB\xBF" HEADER "\n" ROW "\n", /* mark of a spreadsheet */
        "\n\n" HEADER "\n\n\n" ROW "\n\n",   /* blank lines */
        HEADER "\n a , 2 ,\t1,0,0,3e0,+0,0,0,0,.6,5E-1,-0.4\n",
        "\"case\",\"R1\",R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2\n\"a\",\"2\",1,0,0,3,0,0,0,0,0.6,0.5,-0.4\n",
        "w2,w1,v2y,v2x,v1y,v1x,x2y,x2x,x1y,x1x,R2,R1,case\n-0.4,0.5,0.6,0,0,0,0,3,0,0,1,2,a\n",
        "note," HEADER ",lambda\n\"x, y\nz\"," ROW ",nan\n", /* further columns hold anything */
    };
    for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
        char *text = good(same[k]);
        assert_string_equal(text, plain);
        free(text);
    }
    free(plain);
    char *text = good(HEADER "\n"); /* no row: the header */
    assert_int_equal(lines_of(text), 1);
    free(text);
    text = good(HEADER "\n\"say \"\"so\"\", all\",2,1,0,0,3,0,0,0,0,0.6,0.5,-0.4\n,inf,1,0,0,3,0,0,0,0,0,0,0\n");
    assert_non_null(strstr(text, "\n\"say \"\"so\"\", all\",2,1,"));
    assert_non_null(strstr(text, "\n\"\",inf,1,"));
    assert_null(strstr(text, "nan"));
    free(text);
}

static void test_bad_input(void **state) {
    (void)state;
    static const struct bad {
        const char *text, *message;
    } table[] = {
        {"", ":1: error: the file is empty; its first line names the columns: case,R1,R2,x1x,..."},
        {"\n\n", ":1: error: the file is empty; its first line names the columns: case,R1,R2,x1x,..."},
        {"case,R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1\n",
         ":1: error: no column w2 in the header line (cells are separated by commas)"},
        {"R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2y,w1,w2\n",
         ":1: error: no column case,v2x in the header line (cells are separated by commas)"},
        {ROW "\n",
         ":1: error: no column case,R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2 in the header line (cells are "
         "separated by commas)"},
        {HEADER ",R1\n", ":1: error: column R1 occurs twice"},
        {HEADER "\n" ROW "\na,2,1,0,0,3,0,0,0,0,0.6,0.5\n", ":3: error: 12 cells, but the header line has 13"},
        {HEADER "\n" ROW ",1\n", ":2: error: 14 cells, but the header line has 13"},
        {HEADER "\na\n", ":2: error: 1 cell, but the header line has 13"},
        {HEADER "\na,2,1,0,0,3,0,0,0,0,nan,0.5,0\n", ":2: error: v2y is \"nan\", which is not a number"},
        {HEADER "\na,2,1,0,0,3,0,0,0,0,fast,0.5,0\n", ":2: error: v2y is \"fast\", which is not a number"},
        {HEADER "\na,2,1,0,0,3,0,0,0,0,0x10,0.5,0\n", ":2: error: v2y is \"0x10\", which is not a number"},
        {HEADER "\na,2,1,0,0,3,0,0,0,0,\"0,5\",0.5,0\n", ":2: error: v2y is \"0,5\", which is not a number"},
        {HEADER "\na,2,1,0,0,3,0,0,0,0,1 m,0.5,0\n", ":2: error: v2y is \"1 m\", which is not a number"},
        {HEADER "\na,2,1,0,0,3,0,0,0,0,\x1b[31m,0.5,0\n", ":2: error: v2y is \"?[31m\", which is not a number"},
        {HEADER "\na,2,1,0,0,3,0,0,0,0,,0.5,0\n", ":2: error: v2y is empty"},
        {HEADER "\na,2,1,0,0,3,0,0,0,0,inf,0.5,0\n", ":2: error: v2y is inf: it must be finite"},
        {HEADER "\na,2,1,0,0,3,0,0,0,0,1e999,0.5,0\n", ":2: error: v2y is 1e999, which is too large"},
        {HEADER "\na,0,1,0,0,3,0,0,0,0,0,0,0\n",
         ":2: error: R1 is 0: a radius must be above 0 (a wall has R1 = inf, a ring R1 < 0)"},
        {HEADER "\na,-inf,1,0,0,3,0,0,0,0,0,0,0\n",
         ":2: error: R1 is -inf: a radius must be above 0 (a wall has R1 = inf, a ring R1 < 0)"},
        {HEADER "\na,1,-1,0,0,3,0,0,0,0,0,0,0\n", ":2: error: R2 is -1: a radius must be above 0"},
        {HEADER "\na,1,inf,0,0,3,0,0,0,0,0,0,0\n", ":2: error: R2 is inf: only body 1 can be a wall"},
        {HEADER "\na,-1,2,0,0,3,0,0,0,0,0,0,0\n",
         ":2: error: a ring of the radius 1 m (R1 < 0) holds smaller disks only, and R2 is 2 m"},
        {HEADER "\r\n" ROW "\r\na,1,1,3,4,3,4,0,0,0,0,0,0\r\n",
         ":3: error: x1 and x2 coincide: there is no line of centres"},
        {HEADER "\na,1,1,0,0,1e-170,0,0,0,0,0,0,0\n",
         ":2: error: x1 and x2 are 1e-170 m apart: allowed is 1e-150 m to 1e150 m"},
        {HEADER "\na,1e308,1e308,0,0,1,0,0,0,0,0,0,0\n", ":2: error: R1 is 1e+308 m: allowed is 1e-150 m to 1e150 m"},
        {HEADER "\n" ROW "\na,1,1,0,0,1,0,0,-1e308,0,1e308,0,0\n",
         ":3: error: beta_dot is not finite: the numbers of this row are too large or too small"},
        {HEADER "\n" ROW "\n\"a\"b,2,1,0,0,3,0,0,0,0,0,0,0\n",
         ":3: error: a quote inside a cell (write \"\" for it, and quotes around the cell)"},
        {HEADER "\n\"a,2,1,0,0,3,0,0,0,0,0,0,0\n", ":2: error: a quote that is not closed"},
        {"note," HEADER "\n\"two\nlines\"," ROW "\nx,a,2,1,0,0,3,0,0,0,0,0,0,?\n",
         ":4: error: w2 is \"?\", which is not a number"},
    };
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        result r = run(table[k].text, strlen(table[k].text));
        if (r.ok) fail_msg("not refused: %s", table[k].text);
        assert_string_equal(r.st.text, table[k].message);
        assert_int_equal(r.st.code, TR_BAD_CASE);
        assert_null(strstr(r.text, "nan"));
        free(r.text);
    }
    static const char zero[] = HEADER "\na\0b,2,1,0,0,3,0,0,0,0,0,0,0\n";
    result r = run(zero, sizeof zero - 1);
    assert_string_equal(r.st.text, ":2: error: a zero byte: not a text file in UTF-8 or ASCII");
    free(r.text);
}

/* A label and a cell that are too long, more columns than there is room for. */
static void test_long_input(void **state) {
    (void)state;
    enum { SIZE = 2 << 20 };
    char *text = malloc(SIZE);
    int n = sprintf(text, "%s\n", HEADER);
    memset(text + n, 'x', 300);
    strcpy(text + n + 300, ROW "\n");
    result r = run(text, strlen(text));
    assert_string_equal(r.st.text, ":2: error: case has more than 255 bytes");
    free(r.text);
    text[n] = '"', memset(text + n + 1, 'x', SIZE - n - 1);
    r = run(text, SIZE);
    assert_string_equal(r.st.text, ":2: error: a cell of more than 1048576 bytes: is a quote not closed?");
    free(r.text);
    for (int i = 0; i < 2000; i++) memcpy(text + 2 * i, "x,", 2);
    r = run(text, 4000);
    assert_string_equal(r.st.text, ":1: error: more than 1024 columns");
    free(r.text);
    free(text);
}

static void test_unreadable(void **state) {
    (void)state;
    static const char *const bad[][2] = {
        {"/nowhere/a.csv", "error: cannot read /nowhere/a.csv: No such file or directory"},
        {"/tmp", "error: cannot read /tmp: Is a directory"}};
    for (int k = 0; k < 2; k++) {
        tr_status st = {0};
        FILE *out = tmpfile();
        assert_false(tr_measures_csv(bad[k][0], false, out, &st));
        assert_int_equal(st.code, TR_FILE);
        assert_string_equal(st.text, bad[k][1]);
        assert_int_equal(ftell(out), 0);
        fclose(out);
    }
    tr_status st = {0};
    FILE *full = fopen("/dev/full", "w");
    char in[] = "/tmp/trundle-measures-XXXXXX";
    int fd = mkstemp(in);
    assert_true(full && fd >= 0 && dprintf(fd, "%s\n", HEADER) > 0);
    for (int i = 0; i < 1000; i++) dprintf(fd, "%s\n", ROW);
    close(fd);
    assert_false(tr_measures_csv(in, false, full, &st));
    assert_int_equal(st.code, TR_FILE);
    assert_string_equal(st.text, "error: cannot write the measures: No space left on device");
    fclose(full);
    unlink(in);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pairs_by_hand),
        cmocka_unit_test(test_walls_by_hand),
        cmocka_unit_test(test_wall_is_the_limit),
        cmocka_unit_test(test_definitions),
        cmocka_unit_test(test_many_motions),
        cmocka_unit_test(test_card),
        cmocka_unit_test(test_card_for_codes),
        cmocka_unit_test(test_arms_by_hand),
        cmocka_unit_test(test_errata),
        cmocka_unit_test(test_round_trip),
        cmocka_unit_test(test_forms_of_a_file),
        cmocka_unit_test(test_bad_input),
        cmocka_unit_test(test_long_input),
        cmocka_unit_test(test_unreadable),
    };
    return cmocka_run_group_tests_name("measures command", tests, NULL, NULL);
}
