/* SPDX-License-Identifier: MIT */
/* output.path_rows: paths.csv against contacts.csv, against the path of single contacts of the same run, and against
 * where the disks of a periodic cell are. Its replay: the run's own law against the run's Q, the half-plane and the
 * laws against closed forms on made-up paths, the stress against that of the walls or of the cell. */
#include "assert_close.h"
#include "laws/law.h"
#include "study/replay.h"
#include "study/replay_write.h"
#include "study/run.h"
#include "study/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/trundle-replay-XXXXXX";

/* ---- tables and runs */

enum { TIME, LIFE, A, B, R1, R2, SLIDE, ROLL, FORCE, FRICTION, WHOLE, X, Y, N_COLUMNS };
static const char *const columns[N_COLUMNS] = {"time_s",      "life",       "a",         "b",         "R1_m",
                                               "R2_m",        "du_slide_m", "du_roll_m", "P_N_per_m", "Q_N_per_m",
                                               "f_n_N_per_m", "branch_x_m", "branch_y_m"};

#define CREEP "friction: dahlberg-alfredsson, mu: 0.4, k_t: 80 MPa, E_star: 400 MPa"
#define BIAXIAL(friction)                                                                                              \
    "kind: biaxial\nseed: 3\nsample: {disks: 30, r_min: 0.76 mm, r_max: 1.52 mm}\n"                                    \
    "contact: {normal: hertz-line, rolling: none, " friction "}\n"                                                     \
    "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"                                        \
    "shear: {inertial_number: 1e-3, strain_end: 0.03}\n"
/* As kuhn-disks.yaml has it, a/R = 3 %; so few disks that a quarter of the contacts are across an edge. */
#define PERIODIC(strain)                                                                                               \
    "kind: biaxial\nseed: 3\nboundary: periodic\nsample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm}\n"                \
    "contact: {normal: hertz-line, E_star: 100 MPa, friction: kuhn-creep, mu: 0.4, rolling: none}\n"                   \
    "compaction: {pressure: 100 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"                                        \
    "shear: {hold: mean, inertial_number: 3e-3, strain_end: " strain "}\n"

/* Results in folder/name. */
static void run_case(const char *text, const char *name) {
    static tr_run_report report;
    char dir[100];
    tr_scene scene;
    tr_status st = {0};
    if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st)) fail_msg("%s", st.text);
    snprintf(dir, sizeof dir, "%s/%s", folder, name);
    if (!tr_run(&scene, &(tr_run_options){.dir = dir, .force = true}, &report, &st)) fail_msg("%s", st.text);
    tr_scene_free(&scene);
}

/* ---- what is recorded */

/* The last instant of paths.csv is the end of the run, which contacts.csv lists too, from another walk over the
 * contacts: the same pairs, forces, and directions. Tables have 9 digits. */
static void last_instant_is_contacts_csv(void **state) {
    (void)state;
    run_case(BIAXIAL(CREEP) "output: {frames: 0, curves: no, path_rows: 12}\n", "all");
    static const char *const of_contact[] = {"a", "b", "f_n_N_per_m", "f_t_N_per_m", "nx", "ny", "overlap_m"};
    table t = table_read(folder, "all/paths.csv", columns, N_COLUMNS),
          c = table_read(folder, "all/contacts.csv", of_contact, 7);
    int instants = 1;
    for (int i = 1; i < t.n; i++) instants += t.row[i][TIME] > t.row[i - 1][TIME];
    assert_int_equal(instants, 12);
    assert_true(c.n > 30 && t.n > c.n);
    for (int i = 0; i < c.n; i++) {
        const double *p = t.row[t.n - c.n + i], *q = c.row[i];
        assert_true(p[TIME] == t.row[t.n - 1][TIME] && p[A] == q[0] && p[B] == q[1]);
        assert_close(p[WHOLE], q[2], 1e-8, 0);
        assert_close(p[FRICTION], q[3], 1e-8, 1e-9);
        double length = hypot(p[X], p[Y]);
        assert_close(p[X] / length, q[4], 0, 1e-8);
        assert_close(p[Y] / length, q[5], 0, 1e-8);
        assert_close(length, p[R1] + p[R2] - q[6], 1e-8, 0); /* R1 = 0 at a wall */
    }
    assert_true(t.row[t.n - c.n - 1][TIME] < t.row[t.n - 1][TIME]);
    free(t.row), free(c.row);
}

/* Sums of increments over 4 and over 23 instants, and, in its present life, u of the path of one contact, which another
 * sink adds up over all steps. Each row is rounded to 9 digits. */
static void sums_do_not_depend_on_the_rows(void **state) {
    (void)state;
    const char *const runs[] = {"few", "many"};
    run_case(BIAXIAL(CREEP) "output: {frames: 0, curves: no, path_rows: 4, paths: [wall0-0, most-mobilised]}\n", "few");
    run_case(BIAXIAL(CREEP) "output: {frames: 0, curves: no, path_rows: 23}\n", "many");
    double sum[2][4000][2] = {0}, ends[4000] = {0};
    int shared = 0;
    for (int k = 0; k < 2; k++) {
        char name[40];
        snprintf(name, sizeof name, "%s/paths.csv", runs[k]);
        table t = table_read(folder, name, columns, N_COLUMNS);
        for (int i = 0; i < t.n; i++) {
            int life = (int)t.row[i][LIFE];
            assert_true(life < 4000);
            sum[k][life][0] += t.row[i][SLIDE], sum[k][life][1] += t.row[i][ROLL];
            if (k == 0 && t.row[i][TIME] == t.row[t.n - 1][TIME]) ends[life] = 1;
        }
        free(t.row);
    }
    double best = INFINITY, moved = 0;
    static const char *const of_path[] = {"u_slide_m", "u_roll_m", "P_N_per_m"};
    table one = table_read(folder, "few/paths/most-mobilised.csv", of_path, 3);
    int i = one.n - 1;
    while (i > 0 && one.row[i][2] > 0) i--; /* where it touched last */
    double u[2] = {one.row[one.n - 1][0] - one.row[i][0], one.row[one.n - 1][1] - one.row[i][1]};
    for (int life = 0; life < 4000; life++) {
        if (!ends[life]) continue;
        shared++;
        for (int c = 0; c < 2; c++) assert_close(sum[0][life][c], sum[1][life][c], 1e-7, 1e-14);
        double off = hypot(sum[0][life][0] - u[0], sum[0][life][1] - u[1]);
        if (off < best) best = off, moved = hypot(u[0], u[1]);
    }
    print_message("%d lives; one is the most mobilised contact, to %.1e of %.2e m\n", shared, best, moved);
    assert_true(shared > 30 && moved > 1e-7);
    assert_true(best <= 1e-7 * moved);
    free(one.row);
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *x, int n) {
    qsort(x, (size_t)n, sizeof *x, ascending);
    return 0.5 * (x[(n - 1) / 2] + x[n / 2]);
}

/* Increments of contacts.csv, one instant a row of history.csv: slide and roll are those of paths.csv, another sink, at
 * the same instants; the medians over those that were followed are the row's, theirs are all of its contacts. Each
 * number has 9 digits, and a sum may be a small difference, so that single ones are held to the greatest. */
static void increments_add_up(const char *boundary, const char *name) {
    static const char *const of_contact[] = {"time_s", "a", "b", "u_slide_m", "u_roll_m", "u_creep_m", "followed"};
    static const char *const of_history[] = {"time_s", "roll_over_slide_median", "creep_over_slide_median"};
    char text[1000], file[3][60];
    snprintf(text, sizeof text,
             "%sboundary: %s\noutput: {frames: 0, curves: no, rows: 10, contacts: 9, path_rows: 10, "
             "increments: yes}\n",
             BIAXIAL(CREEP), boundary);
    run_case(text, name);
    static const char *const tables[] = {"paths", "contacts", "history"};
    for (int k = 0; k < 3; k++) snprintf(file[k], sizeof file[k], "%s/%s.csv", name, tables[k]);
    table p = table_read(folder, file[0], columns, N_COLUMNS), c = table_read(folder, file[1], of_contact, 7);
    table h = table_read(folder, file[2], of_history, 3);
    assert_int_equal(h.n, 10);
    double largest = 0, *roll = calloc((size_t)c.n, sizeof *roll), *creep = calloc((size_t)c.n, sizeof *creep);
    for (int i = 0; i < c.n; i++) largest = fmax(largest, fabs(c.row[i][3]));
    int at = 0, row = 1, n = 0, followed = 0;
    while (p.row[at][TIME] < 0.5 * h.row[1][0]) at++; /* paths.csv has an instant at the start */
    assert_int_equal(p.n - at, c.n);
    for (int i = 0; i < c.n; i++) {
        const double *u = c.row[i], *v = p.row[at + i];
        assert_true(v[A] == u[1] && v[B] == u[2]);
        assert_close(v[TIME], u[0], 1e-8, 0);
        if (u[1] < 0) { /* a wall */
            assert_true(u[3] == 0 && u[4] == 0 && u[5] == 0 && !u[6]);
        } else {
            assert_close(u[3], v[SLIDE], 1e-8, 1e-8 * largest);
            assert_close(u[4], v[ROLL], 1e-8, 1e-8 * largest);
        }
        if (u[6]) followed++, roll[n] = fabs(u[4] / u[3]), creep[n++] = fabs(u[5] / u[3]);
        if (i + 1 < c.n && c.row[i + 1][0] == u[0]) continue;
        assert_close(u[0], h.row[row][0], 1e-8, 0);
        assert_close(median(roll, n), h.row[row][1], 1e-8, 0);
        assert_close(median(creep, n), h.row[row][2], 1e-8, 0);
        assert_true(h.row[row++][2] > 0);
        n = 0;
    }
    assert_int_equal(row, 10);
    assert_true(followed > c.n / 2 && followed < c.n);
    free(p.row), free(c.row), free(h.row), free(roll), free(creep);
}

static void increments_of_contacts_csv(void **state) {
    (void)state;
    increments_add_up("walls", "in-walls");
    increments_add_up("periodic", "in-a-cell");
}

/* Where the disks are and how far they have turned is the integral of all that moves them, so the branches, and from
 * row to row
 *
 *   du_slide = -L dbeta + r1 dangle1 + r2 dangle2,   du_roll = -(R1 (dangle1 - dbeta) - R2 (dangle2 - dbeta))/2
 *
 * with beta the direction of the branch, follow from disks.csv, but for the square of what turns within a row. Across
 * an edge of a periodic cell the branch is that to the image, a side further. Rows of both tables are of the same step
 * where the times agree. */
static void motion_follows_the_disks_across_edges(void **state) {
    (void)state;
    enum { DISKS = 60, LIVES = 4000 };
    static const char *const of_disk[] = {"time_s", "disk", "x_m", "y_m", "angle_rad"};
    run_case(PERIODIC("0.01") "output: {frames: 0, curves: no, path_rows: 101, contacts: 100}\n", "edges");
    table t = table_read(folder, "edges/paths.csv", columns, N_COLUMNS),
          d = table_read(folder, "edges/disks.csv", of_disk, 5);
    struct {
        double time, beta, angle[2];
    } before[LIVES] = {0};
    double side[2] = {0}, worst = 0, moved = 0;
    int compared = 0, crossing = 0;
    for (int i = 0, j = 0; i < t.n; i++) {
        const double *p = t.row[i], L = hypot(p[X], p[Y]), beta = atan2(p[Y], p[X]);
        while (j + DISKS < d.n && d.row[j][0] < p[TIME]) j += DISKS; /* each list has all disks */
        int life = (int)p[LIFE];
        assert_true(life < LIVES);
        if (i && p[TIME] > t.row[i - 1][TIME]) side[0] = side[1] = 0;
        if (d.row[j][0] != p[TIME]) continue;
        const double *q[2] = {d.row[j + (int)p[A]], d.row[j + (int)p[B]]};
        bool edge = false;
        for (int axis = 0; axis < 2; axis++) {
            double image = p[X + axis] - (q[1][2 + axis] - q[0][2 + axis]);
            if (fabs(image) < 1e-10) continue; /* of 1e-2 m in 9 digits */
            if (side[axis] == 0) side[axis] = fabs(image);
            assert_close(fabs(image), side[axis], 0, 1e-10);
            assert_true(side[axis] > 1e-2); /* of 60 disks of 1.1 mm */
            edge = true;
        }
        double angle[2] = {q[0][4], q[1][4]}, db = remainder(beta - before[life].beta, 2 * M_PI);
        if (before[life].time > 0 && p[TIME] - before[life].time < 1.5 * t.row[t.n - 1][TIME] / 100) {
            double d1 = angle[0] - before[life].angle[0], d2 = angle[1] - before[life].angle[1],
                   g1 = p[R1] / (p[R1] + p[R2]);
            double slide = L * (g1 * d1 + (1 - g1) * d2 - db), roll = -0.5 * (p[R1] * (d1 - db) - p[R2] * (d2 - db));
            worst = fmax(worst, fmax(fabs(slide - p[SLIDE]), fabs(roll - p[ROLL])));
            moved += hypot(p[SLIDE], p[ROLL]), compared++, crossing += edge;
        }
        before[life].time = p[TIME], before[life].beta = beta;
        memcpy(before[life].angle, angle, sizeof angle);
    }
    print_message("%d rows, %d across an edge: worst %.1e m, mean motion %.1e m\n", compared, crossing, worst,
                  moved / compared);
    assert_true(compared > 1000 && crossing > 100);
    assert_true(worst < 1e-2 * moved / compared);
    free(t.row), free(d.row);
}

/* ---- the replay */

static tr_run_report said;

/* Of folder/run, its tables into folder/to. */
static tr_replay replay(const char *run, const char *to, int jobs, int elements, int every) {
    tr_replay r;
    tr_status st = {0};
    char from[100], dir[100];
    snprintf(from, sizeof from, "%s/%s", folder, run), snprintf(dir, sizeof dir, "%s/%s", folder, to);
    const tr_replay_options o = {.run = from, .dir = dir, .jobs = jobs, .elements = elements, .every = every};
    said = (tr_run_report){0};
    if (!tr_replay_run(&r, &o, &said, &st) || !tr_replay_write(&r, &o, &said, &st)) fail_msg("%s", st.text);
    return r;
}

static double Q_of(const tr_replay *r, int row, int law) {
    return r->Q[(size_t)row * (size_t)r->n_columns + (size_t)law];
}

static int law_of(const tr_replay *r, const char *name) {
    int k = TR_REPLAY_OWN + 1;
    while (k < r->n_columns && strcmp(r->name[k], name)) k++;
    assert_true(k < r->n_columns);
    return k;
}

#define PATHS "output: {frames: 0, curves: no, path_rows: "
#define SHORT                                                                                                          \
    "kind: biaxial\nseed: 3\nsample: {disks: 30, r_min: 0.76 mm, r_max: 1.52 mm}\n"                                    \
    "contact: {normal: hertz-line, rolling: none, " CREEP "}\n"                                                        \
    "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"                                        \
    "shear: {inertial_number: 3e-3, strain_end: 0.01}\n" PATHS

/* rms of (Q of the run's law, replayed - Q of the run)/(mu P) over all rows of disks. */
static double own_error(const char *text) {
    double sum = 0;
    int n = 0;
    run_case(text, "own");
    tr_replay r = replay("own", "own", 2, 4, 1);
    for (int i = 0; i < r.n_rows; i++) {
        if (r.row[i].a < 0 || !(r.row[i].P > 0)) continue;
        double e = (Q_of(&r, i, TR_REPLAY_OWN) - r.row[i].Q) / (r.mu * r.row[i].P);
        sum += e * e, n++;
    }
    tr_replay_free(&r);
    assert_true(n > 100);
    return sqrt(sum / n);
}

/* With a row for every step the replay is the run, but that a weak contact, as it forms or opens, takes some steps from
 * one row to the next. With fewer rows the way within a row is made up. */
static void own_law_reproduces_the_run(void **state) {
    (void)state;
    double every = own_error(SHORT "1000000}\n"), many = own_error(SHORT "400}\n"), some = own_error(SHORT "100}\n"),
           few = own_error(SHORT "20}\n");
    print_message("rms error, of mu P: every step %.1e, 400 rows %.1e, 100 %.1e, 20 %.1e\n", every, many, some, few);
    assert_true(every < 1e-4);
    assert_true(every < many && many < some && some < few);
    assert_true(some < 0.05);
    double periodic = own_error(PERIODIC("0.003") PATHS "200}\n"); /* 0.4 if P had the dashpot */
    print_message("periodic cell: %.1e\n", periodic);
    assert_true(periodic < 1e-3);
}

/* ---- made-up paths in the place of those of a run */

enum { ROWS = 40, SPIN = 40, ELEMENTS = 100 };
static const double R_1 = 1e-3, R_2 = 3e-3, P_0 = 300, MU = 0.4, E_STAR = 400e6;

/* The share of full slip that Cattaneo's contact has taken when it has slid u, with beta = 0 rolling; by bisection of
 * u = (2 mu P/(pi E_star)) (q (Lambda + 1/2) + (1 - q) ln(1 - q)/2). */
static double cattaneo(double u, double Lambda) {
    double low = 0, high = 1, unit = 2 * MU * P_0 / (M_PI * E_STAR);
    for (int n = 0; n < 60; n++) {
        double q = 0.5 * (low + high);
        *(unit * (q * (Lambda + 0.5) + 0.5 * (1 - q) * log(1 - q)) < u ? &low : &high) = q;
    }
    return low;
}

/* summary.json says how long paths.csv is. */
static void sign(const char *run) {
    char command[400];
    snprintf(
        command, sizeof command,
        "cd %s/%s && sed -i \"s/\\\"paths_bytes\\\": [0-9]*/\\\"paths_bytes\\\": $(wc -c <paths.csv)/\" summary.json",
        folder, run);
    assert_int_equal(system(command), 0);
}

/* Life 1 slides, life 2 slides the other way, life 3 rolls 40 a at the creepage xi, life 4 is of a wall, life 5 slides
 * far. */
static void closed_forms(void **state) {
    (void)state;
    const double R = R_1 * R_2 / (R_1 + R_2), a = sqrt(4 * P_0 * R / (M_PI * E_STAR)), d = 2 * sqrt(R_1 * R_2) / M_E;
    const double Lambda = log(2 * d / a), slip = 2 * MU * P_0 / (M_PI * E_STAR) * (Lambda + 0.5), F0 = MU * a / R,
                 xi = 0.5 * F0;
    char path[100];
    run_case(SHORT "40}\n", "made-up");
    snprintf(path, sizeof path, "%s/made-up/paths.csv", folder);
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    for (int c = 0; c < N_COLUMNS; c++) fprintf(f, "%s%c", columns[c], c + 1 < N_COLUMNS ? ',' : '\n');
    const double slide[] = {0.8 * slip / (ROWS - 1), -0.8 * slip / (ROWS - 1), xi * SPIN * a / (ROWS - 1), 0, slip};
    for (int i = 0; i < ROWS; i++)
        for (int k = 0, order[] = {1, 2, 3, 5, 4}, life; k < 5 && (life = order[k]); k++) /* the wall last */
            fprintf(f, "%d,%d,%d,9,%.17g,%.17g,%.17g,%.17g,%.17g,0,%s\n", i, life, life == 4 ? -1 : life, R_1, R_2,
                    i ? slide[life - 1] : 0, i && life == 3 ? -SPIN * a / (ROWS - 1) : 0, P_0,
                    life == 1 ? "900,0,1" : "300,1,0"); /* a dashpot pushes along y */
    assert_int_equal(fclose(f), 0);
    sign("made-up");
    tr_replay r = replay("made-up", "made-up", 1, ELEMENTS, 1);
    assert_int_equal(r.n_lives, 5);
    assert_false(r.life[3].done);
    static const char *const of_stress[] = {"sin_phi_exact"};
    table t = table_read(folder, "made-up/replay-stress.csv", of_stress, 1);
    assert_close(t.row[0][0], (900.0 - 4 * 300) / (900 + 4 * 300), 1e-5, 0); /* no friction yet */
    free(t.row);
    /* The run took other times: its rate of strain counts, not its end. Six digits. */
    static const char *const of_time[] = {"strain", "time_s"};
    table h = table_read(folder, "made-up/history.csv", of_time, 2),
          s = table_read(folder, "made-up/replay-stress.csv", of_time, 2);
    const double *last = h.row[h.n - 1], *before = h.row[h.n - 2]; /* at full speed */
    assert_close(s.row[ROWS - 1][0] - s.row[ROWS - 2][0], (last[0] - before[0]) / (last[1] - before[1]), 1e-5, 0);
    free(h.row), free(s.row);
    int spring = law_of(&r, "coulomb-spring"), bed = law_of(&r, "cattaneo-mindlin"),
        dahlberg = law_of(&r, "dahlberg-alfredsson"), kuhn = law_of(&r, "kuhn-creep");
    double work = 0, full = 0;
    for (int i = 0; i < ROWS; i++) {
        double u = i * slide[0], Q = MU * P_0 * cattaneo(u, Lambda),
               before = i ? MU * P_0 * cattaneo(u - slide[0], Lambda) : 0;
        work += 0.5 * (Q + before) * (i ? slide[0] : 0), full += MU * P_0 * (i ? slide[0] : 0);
        /* the law is the closed form (the approach of hertz-line has the same logarithm); elements: 1e-3 at 200 */
        assert_close(Q_of(&r, i, bed), Q, 1e-9, 1e-9);
        assert_close(Q_of(&r, i, TR_REPLAY_EXACT), Q, 0, 3e-3 * MU * P_0);
        assert_close(Q_of(&r, ROWS + i, TR_REPLAY_EXACT), -Q, 0, 3e-3 * MU * P_0);
        assert_close(Q_of(&r, i, spring), fmin(r.k_t * u, MU * P_0), 1e-9, 1e-9);
        assert_close(Q_of(&r, i, dahlberg), fmin(r.k_t * u, MU * P_0), 1e-9, 1e-9); /* nothing rolls */
    }
    assert_close(r.life[0].full, full, 1e-9, 0);
    assert_close(r.life[0].work[bed], work, 1e-3, 0); /* rows of 2 % of slip, steps of less */
    assert_close(r.life[1].work[TR_REPLAY_EXACT], work, 5e-3, 0);
    assert_close(
        r.k_t,
        M_PI * E_STAR /
            (2 * log(2 * (2 * 0.5 * (R_1 + R_2) / M_E) / sqrt(4 * P_0 * 0.25 * (R_1 + R_2) / (M_PI * E_STAR)))),
        1e-9, 0);
    /* Carter: q = 1 - (1 - xi/F0)^2 in the end. Of Dahlberg's way there exp(-2 (40/Lambda - 1/2)), e^-16, is left;
     * elements of a/50 are some 0.003 off */
    int end = 3 * ROWS - 1;
    double q = 0.75;
    assert_close(Q_of(&r, end, TR_REPLAY_EXACT) / (MU * P_0), q, 0, 0.005);
    assert_close(Q_of(&r, end, dahlberg) / (MU * P_0), q, 1e-5, 0);
    assert_close(Q_of(&r, end, kuhn) / (MU * P_0), q, 1e-5, 0);
    assert_close(Q_of(&r, end, bed) / (MU * P_0), cattaneo(fmin(SPIN * a * xi, slip * (1 - 1e-12)), Lambda), 1e-6, 0);
    assert_close(r.rolled[end], SPIN, 1e-9, 0);
    /* far beyond full slip: all take mu P |du|, less the way to it, which is half of slip for a spring of full slip at
     * most */
    assert_close(r.life[4].work[TR_REPLAY_EXACT] / r.life[4].full, 1, 0.02, 0);
    assert_close(Q_of(&r, 5 * ROWS - 1, TR_REPLAY_EXACT), MU * P_0, 1e-9, 0);
    tr_replay_free(&r);
}

/* replay-errors.csv of the made-up paths: each class has its rows, and the largest and median are found by counting. */
static void errors_by_class(void **state) {
    (void)state;
    static const char *const of_errors[] = {"n", "median", "max", "up_to"};
    tr_replay r = replay("made-up", "made-up", 1, 20, 1);
    table t = table_read(folder, "made-up/replay-errors.csv", of_errors, 4);
    double largest = 0;
    for (int i = 0; i < r.n_rows; i++)
        if (r.row[i].a >= 0)
            largest = fmax(largest, fabs(Q_of(&r, i, TR_REPLAY_OWN) - Q_of(&r, i, TR_REPLAY_EXACT)) / (MU * P_0));
    assert_int_equal(t.row[0][0], 4 * ROWS);
    assert_close(t.row[0][2], largest, 1e-5, 0); /* six digits */
    int below = 0, n[2] = {0};
    for (int i = 0; i < r.n_rows; i++)
        if (r.row[i].a >= 0)
            below += fabs(Q_of(&r, i, TR_REPLAY_OWN) - Q_of(&r, i, TR_REPLAY_EXACT)) / (MU * P_0) <=
                     t.row[0][1] * (1 + 1e-5);
    assert_in_range(below, 2 * ROWS, 2 * ROWS + 8); /* half of them; some are alike */
    for (int k = 1, by = -1; k < t.n && by < 2; k++) {
        by += k == 1 || isinf(t.row[k - 1][3]); /* a class up to infinity is the last of its kind */
        if (by < 2) n[by] += (int)t.row[k][0];
    }
    assert_int_equal(n[0], 4 * ROWS), assert_int_equal(n[1], 4 * ROWS);
    free(t.row), tr_replay_free(&r);
}

/* sum f_i l_j over the contacts, with those of walls, is wall force times length, but for inertia (I = 1e-3) and for
 * the instants: history.csv has means over the steps between its rows. Means of 100. A cell has the same sum, of all
 * its steps. */
static void stress_is_that_of_the_boundary(void **state) {
    (void)state;
    static const char *const of_history[] = {"sin_phi", "strain"}, *const of_stress[] = {"sin_phi_run", "strain"};
    static const char *const cases[] = {PERIODIC("0.01") PATHS "101, rows: 101}\n",
                                        BIAXIAL(CREEP) PATHS "101, rows: 101}\n"};
    for (int k = 0; k < 2; k++) {
        run_case(cases[k], "stress");
        tr_replay r = replay("stress", "stress", 2, 6, 1);
        table h = table_read(folder, "stress/history.csv", of_history, 2),
              s = table_read(folder, "stress/replay-stress.csv", of_stress, 2);
        double boundary = 0, contacts = 0;
        assert_int_equal(h.n, 101);
        assert_int_equal(s.n, 101);
        for (int i = 1; i < 101; i++) {
            boundary += h.row[i][0] / 100, contacts += s.row[i][0] / 100;
            assert_close(s.row[i][1], h.row[i][1], 1e-4, 1e-6); /* of the start too, in some hundred steps */
        }
        print_message("sin phi of the boundary %.4f, of contacts %.4f\n", boundary, contacts);
        assert_close(contacts, boundary, 0, 0.004);
        free(h.row), free(s.row), tr_replay_free(&r);
    }
}

static void compare_files(const char *one, const char *other) {
    char command[300];
    snprintf(command, sizeof command, "cmp %s/%s %s/%s", folder, one, folder, other);
    assert_int_equal(system(command), 0);
}

static void the_same_with_any_number_of_jobs(void **state) {
    (void)state;
    const int jobs[] = {1, 2, 5};
    const char *const files[] = {"replay.csv", "replay-errors.csv", "replay-stress.csv"};
    for (int k = 0; k < 3; k++) {
        char to[20], one[60], other[60];
        snprintf(to, sizeof to, "jobs-%d", jobs[k]);
        tr_replay r = replay("stress", to, jobs[k], 6, 1);
        tr_replay_free(&r);
        for (int i = 0; i < 3; i++) {
            snprintf(one, sizeof one, "jobs-1/%s", files[i]), snprintf(other, sizeof other, "%s/%s", to, files[i]);
            compare_files(one, other);
        }
    }
}

/* Every third: the lives 0, 3, 6, ... of the whole, and no stress of a part. */
static void a_sample(void **state) {
    (void)state;
    static const char *const of_lives[] = {"a", "b", "from_s", "run_replayed_rms"};
    tr_replay r = replay("stress", "sample", 2, 6, 3);
    tr_replay_free(&r);
    table all = table_read(folder, "jobs-1/replay.csv", of_lives, 4),
          part = table_read(folder, "sample/replay.csv", of_lives, 4);
    assert_in_range(part.n, all.n / 4, all.n / 2);
    for (int i = 0, k = 0; i < part.n; i++, k++) {
        while (k < all.n && memcmp(all.row[k], part.row[i], 4 * sizeof(double))) k++;
        assert_true(k < all.n);
    }
    char path[100];
    snprintf(path, sizeof path, "%s/sample/replay-stress.csv", folder);
    assert_int_equal(access(path, F_OK), -1);
    free(all.row), free(part.row);
}

static tr_code fails(const char *run, const volatile sig_atomic_t *stop, const char *message) {
    tr_replay r;
    tr_status st = {0};
    char from[100];
    snprintf(from, sizeof from, "%s/%s", folder, run);
    assert_false(tr_replay_run(
        &r, &(tr_replay_options){.run = from, .dir = from, .jobs = 2, .elements = 6, .every = 1, .stop = stop}, &said,
        &st));
    if (!strstr(st.text, message)) fail_msg("%s", st.text);
    tr_replay_free(&r);
    return st.code;
}

static void what_cannot_be_replayed(void **state) {
    (void)state;
    volatile sig_atomic_t stop = 1;
    said = (tr_run_report){0};
    assert_int_equal(fails("stress", &stop, "stopped"), TR_INTERRUPTED);
    assert_int_equal(fails("nowhere", NULL, "case.yaml"), TR_FILE);
    run_case(BIAXIAL(CREEP) "output: {frames: 0, curves: no}\n", "none");
    assert_int_equal(fails("none", NULL, "output.path_rows"), TR_BAD_CASE);
}

/* Of folder/made-up a copy, changed by a command. */
static void change(const char *command) {
    char text[600];
    snprintf(text, sizeof text, "cd %s && rm -rf bad && cp -r made-up bad && cd bad && %s", folder, command);
    assert_int_equal(system(text), 0);
}

static void an_unfinished_run_is_refused(void **state) {
    (void)state;
    change("rm summary.json");
    assert_int_equal(fails("bad", NULL, "bad has no summary.json: the run is not finished"), TR_BAD_CASE);
}

/* What friction brings with it from the compaction is not in its path. */
static void contacts_that_start_with_friction_are_refused(void **state) {
    (void)state;
    change("sed -i '/^compaction:/,/^[^ ]/s/^  mu: 0 /  mu: 0.1 /' case.yaml");
    assert_int_equal(fails("bad", NULL, "a run with compaction.mu: 0, not 0.1"), TR_BAD_CASE);
}

/* In the middle of a row, at the end of one, at the end of an instant; and a summary that knows nothing of them. */
static void paths_that_were_cut_are_refused(void **state) {
    (void)state;
    change("head -c -5 paths.csv >p && mv p paths.csv");
    assert_int_equal(fails("bad", NULL, "paths.csv:201: error: "), TR_BAD_CASE);
    change("head -n 199 paths.csv >p && mv p paths.csv");
    assert_int_equal(fails("bad", NULL, "paths.csv:199: error: the file ends here with "), TR_BAD_CASE);
    change("head -n 196 paths.csv >p && mv p paths.csv");
    assert_int_equal(fails("bad", NULL, "paths.csv:196: error: the file ends here with "), TR_BAD_CASE);
    change("sed -i /paths_bytes/d summary.json");
    assert_int_equal(fails("bad", NULL, "has no number `paths_bytes`"), TR_BAD_CASE);
}

/* Row by row, where the size of the file is what the run says. Line 2 is the first row, five to an instant; line 7:
 * instant 1, life 1 of the disks 1 and 9. */
static void rows_that_no_run_writes_are_refused_with_their_line(void **state) {
    (void)state;
    static const char *const rows[][2] = {
        {"sed -i '7s/,1,1,9,/,1,9,9,/' paths.csv", ":7: error: disk 9 touches itself"},
        {"sed -i '7s/,1,1,9,/,1,1,30,/' paths.csv",
         ":7: error: impossible contact: a = 1, b = 30; case.yaml has the disks 0 to 29"},
        {"sed -i '7s/,1,1,9,/,1,1,-1,/' paths.csv", ":7: error: impossible contact: a = 1, b = -1"},
        {"sed -i '7s/,1,1,9,/,1,77,9,/' paths.csv", ":7: error: impossible contact: a = 77"},
        {"sed -i '7s/,1,1,9,/,1,12,9,/' paths.csv", ":7: error: a = 12 is above b = 9"},
        {"sed -i '11s/,4,-1,9,/,4,-5,9,/' paths.csv", ":11: error: impossible contact: a = -5"},
        {"sed -i '7s/,1,1,9,/,1,1,8.5,/' paths.csv", ":7: error: life, a and b must be whole"},
        {"sed -i 7p paths.csv", ":8: error: the contact of 1 and 9 occurs twice"},
        {"sed -i '9{h;p;s/.*//};11{p;x}' paths.csv && sed -i '/^$/d' paths.csv",
         ":12: error: the contact of 3 and 9 is "},
        {"sed -i '8{h;d};9G' paths.csv", ":9: error: the contact of 2 and 9 is out of order"},
        {"sed -i '20s/^[0-9]*/1/' paths.csv", ":20: error: time_s falls"},
        {"sed -i '2,6s/^0/-1/' paths.csv", ":2: error: time_s is -1: it must start at 0"},
        {"sed -i '7s/,300,0,/,-300,0,/' paths.csv", ":7: error: impossible contact: P_N_per_m < 0"},
        {"sed -i '7s/,300,0,/,nan,0,/' paths.csv", ":7: error: P_N_per_m is \"nan\""},
        {"sed -i '7s/,300,0,/,inf,0,/' paths.csv", ":7: error: P_N_per_m is inf"},
        {"sed -i '7s/,0,300,0,/,nan,300,0,/' paths.csv", ":7: error: du_roll_m is \"nan\""},
        {"sed -i '7s/,300,0,.*/,300,0,900,0,0/' paths.csv", ":7: error: impossible contact: its branch"},
        {"sed -i '7s/$/,1/' paths.csv", ":7: error: 14 cells, but the header line has 13"},
        {"sed -i '7s/,[^,]*$//' paths.csv", ":7: error: 12 cells"},
        {"sed -i '1s/life/lif/' paths.csv", ":1: error: no column life"},
        {"sed -i '1s/,b,/,a,/' paths.csv", ":1: error: column a occurs twice"},
        {"sed -i 12d paths.csv", ":16: error: life 1 was last in line 7, not at the instant before"},
        {"sed -i '7s/,1,1,9,/,1,0,9,/' paths.csv", ":7: error: life 1 is of 0 and 9 here, of 1 and 9 in line 2"},
        {"sed -i 's/disks: 30/disks: 9/' case.yaml",
         ":2: error: impossible contact: a = 1, b = 9; case.yaml has the disks 0 to 8"},
        {"sed -i 's/path_rows: 40/path_rows: 7/' case.yaml",
         ":201: error: 40 instants; case.yaml has output.path_rows: 7"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        change(rows[k][0]);
        sign("bad");
        if (fails("bad", NULL, rows[k][1]) != TR_BAD_CASE) fail_msg("%s", rows[k][1]);
    }
    change("true");
    tr_replay r = replay("bad", "bad", 1, 6, 1); /* unchanged, it is taken */
    tr_replay_free(&r);
}

static int open_folder(void **state) {
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int close_folder(void **state) {
    (void)state;
    char command[100];
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(last_instant_is_contacts_csv),
                                       cmocka_unit_test(sums_do_not_depend_on_the_rows),
                                       cmocka_unit_test(increments_of_contacts_csv),
                                       cmocka_unit_test(motion_follows_the_disks_across_edges),
                                       cmocka_unit_test(own_law_reproduces_the_run),
                                       cmocka_unit_test(closed_forms),
                                       cmocka_unit_test(errors_by_class),
                                       cmocka_unit_test(stress_is_that_of_the_boundary),
                                       cmocka_unit_test(the_same_with_any_number_of_jobs),
                                       cmocka_unit_test(a_sample),
                                       cmocka_unit_test(what_cannot_be_replayed),
                                       cmocka_unit_test(an_unfinished_run_is_refused),
        cmocka_unit_test(contacts_that_start_with_friction_are_refused),
                                       cmocka_unit_test(paths_that_were_cut_are_refused),
                                       cmocka_unit_test(rows_that_no_run_writes_are_refused_with_their_line)};
    return cmocka_run_group_tests_name("replay", tests, open_folder, close_folder);
}
