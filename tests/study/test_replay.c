/* SPDX-License-Identifier: MIT */
/* output.path_rows: paths.csv against contacts.csv and against the path of single contacts of the same run. */
#include "assert_close.h"
#include "laws/law.h"
#include "study/csv.h"
#include "study/run.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/trundle-replay-XXXXXX";

/* ---- tables and runs */

enum { MAX_COLUMNS = 12 };

typedef struct table {
    int n, capacity;
    double now[MAX_COLUMNS], (*row)[MAX_COLUMNS];
} table;

static bool cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    (void)length;
    return tr_csv_number(csv, "", text, true, &((table *)context)->now[column]);
}

static bool row(void *context, tr_csv *csv) {
    table *t = context;
    (void)csv;
    if (t->n == t->capacity) t->row = realloc(t->row, (size_t)(t->capacity = 2 * t->n + 1000) * sizeof *t->row);
    memcpy(t->row[t->n++], t->now, sizeof t->now);
    return true;
}

static table read_table(const char *name, const char *const *columns, int n) {
    table t = {0};
    char path[300];
    tr_status st = {0};
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (!tr_csv_read(path, &(tr_csv_format){columns, n, n, "", NULL, cell, row}, &t, &st)) fail_msg("%s", st.text);
    return t;
}

enum { TIME, LIFE, A, B, R1, R2, SLIDE, ROLL, FORCE, FRICTION, X, Y, N_COLUMNS };
static const char *const columns[N_COLUMNS] = {"time_s",    "life",      "a",          "b",
                                               "R1_m",      "R2_m",      "du_slide_m", "du_roll_m",
                                               "P_N_per_m", "Q_N_per_m", "branch_x_m", "branch_y_m"};

#define CREEP "friction: dahlberg-alfredsson, mu: 0.4, k_t: 80 MPa, E_star: 400 MPa"
#define BIAXIAL(friction)                                                                                              \
    "kind: biaxial\nseed: 3\nsample: {disks: 30, r_min: 0.76 mm, r_max: 1.52 mm}\n"                                    \
    "contact: {normal: hertz-line, rolling: none, " friction "}\n"                                                     \
    "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"                                        \
    "shear: {inertial_number: 1e-3, strain_end: 0.03}\n"

/* Results in folder/name. */
static void run_case(const char *text, const char *name) {
    static tr_run_report report;
    char dir[100];
    tr_scene scene;
    tr_status st = {0};
    if (!tr_scene_read(&scene, "a.yaml", text, strlen(text), NULL, 0, tr_laws_catalog(), &st)) fail_msg("%s", st.text);
    snprintf(dir, sizeof dir, "%s/%s", folder, name);
    if (!tr_run(&scene, &(tr_run_options){.dir = dir, .force = true}, &report, &st)) fail_msg("%s", st.text);
    tr_scene_free(&scene);
}

/* ---- what is recorded */

/* The last instant of paths.csv is the end of the run, which contacts.csv lists too, from another walk over the contacts:
 * the same pairs, forces, and directions. Tables have 9 digits. */
static void last_instant_is_contacts_csv(void **state) {
    (void)state;
    run_case(BIAXIAL(CREEP) "output: {frames: 0, curves: no, path_rows: 12}\n", "all");
    static const char *const of_contact[] = {"a", "b", "f_n_N_per_m", "f_t_N_per_m", "nx", "ny", "overlap_m"};
    table t = read_table("all/paths.csv", columns, N_COLUMNS), c = read_table("all/contacts.csv", of_contact, 7);
    int instants = 1;
    for (int i = 1; i < t.n; i++) instants += t.row[i][TIME] > t.row[i - 1][TIME];
    assert_int_equal(instants, 12);
    assert_true(c.n > 30 && t.n > c.n);
    for (int i = 0; i < c.n; i++) {
        const double *p = t.row[t.n - c.n + i], *q = c.row[i];
        assert_true(p[TIME] == t.row[t.n - 1][TIME] && p[A] == q[0] && p[B] == q[1]);
        assert_close(p[FORCE], q[2], 1e-8, 0);
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
        table t = read_table(name, columns, N_COLUMNS);
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
    table one = read_table("few/paths/most-mobilised.csv", of_path, 3);
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
                                       cmocka_unit_test(sums_do_not_depend_on_the_rows)};
    return cmocka_run_group_tests_name("replay", tests, open_folder, close_folder);
}
