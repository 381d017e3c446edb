/* SPDX-License-Identifier: MIT */
/* `path: FILE.csv` against the same path written out in the case; what a file may not hold. */
#include "assert_close.h"
#include "laws/law.h"
#include "study/contact.h"
#include "study/path.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define HEAD                                                                                                           \
    "kind: contact\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3, depth: 1 mm, density: 2700}\n"                  \
    "laws: [{friction: dahlberg-alfredsson, mu: 0.3, k_t: 1 GPa, rolling: star-displacement-damping, damping: yes}]\n"

enum { N = 5 };
/* um; a row rolls by less than an element, so that it is one step */
static const double slide[N] = {0.1, 0.3, 0.2, 0.2, -0.1}, roll[N] = {0.05, 0.1, 0.25, -0.15, -0.15},
    force[N] = {8, 9, 7, 0, 4}, at[N] = {1, 3, 4, 8, 9};                                /* kN/m, s */

static char folder[] = "/tmp/trundle-path-XXXXXX", file[64];

static void write_file(const char *text) {
    FILE *f = fopen(file, "w");
    assert_non_null(f);
    fputs(text, f);
    assert_int_equal(fclose(f), 0);
}

static bool read_case(tr_scene *scene, const char *name, const char *text, tr_status *st) {
    return tr_scene_read(scene, &(tr_scene_source){name, text, strlen(text), NULL, 0}, tr_laws_catalog(), st);
}

/* The state at the end of each step. */
static void drive(const tr_scene *scene, tr_contact_state *state) {
    tr_status st = {0};
    tr_contact *c = tr_contact_new(scene, &st);
    assert_non_null(c);
    assert_int_equal(tr_contact_steps(scene), N);
    for (int i = 0; i < N; i++)
        if (!tr_contact_step(c, &state[i], &st)) fail_msg("%s", st.text);
    tr_contact_free(c);
}

/* Columns in another order, others among them; the name counts from the folder of the case. */
static void same_as_written_out(void **state) {
    (void)state;
    char csv[2000] = "P_N_per_m,note,time_s,u_slide_m,law,u_roll_m\n", path[2000] = HEAD "path:\n", name[80];
    for (int i = 0; i < N; i++) {
        sprintf(csv + strlen(csv), "%g,\"a, b\",%g,%ge-6,2,%ge-6\n", 1e3 * force[i], at[i], slide[i], roll[i]);
        strcat(csv, "7,another law,1,2,3,4\n");
        sprintf(path + strlen(path), "  - {force: %g kN/m, time: %g, slide: %.17g um, roll: %.17g um, steps: 1}\n",
                force[i], at[i] - (i ? at[i - 1] : 0), slide[i] - (i ? slide[i - 1] : 0),
                roll[i] - (i ? roll[i - 1] : 0));
    }
    write_file(csv);
    tr_scene a, b;
    tr_status st = {0};
    snprintf(name, sizeof name, "%s/case.yaml", folder);
    if (!read_case(&a, name, HEAD "path: path.csv\n", &st) || !tr_path_read(&a, &st)) fail_msg("%s", st.text);
    if (!read_case(&b, "a.yaml", path, &st)) fail_msg("%s", st.text);
    assert_string_equal(a.path_file, file);
    tr_contact_state one[N], two[N];
    drive(&a, one), drive(&b, two);
    for (int i = 0; i < N; i++) { /* differences of totals: some roundings */
        assert_close(one[i].u_slide, 1e-6 * slide[i], 1e-13, 1e-21);
        assert_close(one[i].u_roll, 1e-6 * roll[i], 1e-13, 1e-21);
        assert_close(one[i].P, 1e3 * force[i], 0, 0);
        assert_close(one[i].Q, two[i].Q, 1e-12, 1e-9);
        assert_close(one[i].moment_1, two[i].moment_1, 1e-12, 1e-12);
        assert_true(force[i] > 0 || (one[i].Q == 0 && one[i].moment_1 == 0));
    }
    assert_true(fabs(one[1].Q) > 1 && fabs(one[1].moment_1) > 0);
    tr_scene_free(&a), tr_scene_free(&b);
}

/* Rows count as segments do. */
static void a_check_beyond_the_last_row_is_refused(void **state) {
    (void)state;
    char text[600], begins[200];
    tr_status st = {0};
    tr_scene s;
    write_file("u_slide_m,u_roll_m,P_N_per_m,time_s\n0,0,1,1\n0,0,2,2\n");
    for (int segment = 1; segment < 3; segment++) {
        snprintf(text, sizeof text, HEAD "path: %s\nchecks: [{what: P, segment: %d, exact: 2, tolerance: 1}]\n", file,
                 segment);
        if (!read_case(&s, "a.yaml", text, &st)) fail_msg("%s", st.text);
        assert_int_equal(tr_path_read(&s, &st), segment < 2);
        tr_scene_free(&s);
    }
    snprintf(begins, sizeof begins, "%s:1: error: `checks.0.segment` is 2, and the rows of this path count from 0 to 1",
             file);
    assert_string_equal(st.text, begins);
}

static void refuses(void **state) {
    (void)state;
#define COLUMNS "u_slide_m,u_roll_m,P_N_per_m,time_s\n"
    static const struct {
        const char *csv, *message;
    } rows[] = {
        {"", ":1: error: the file is empty; its first line names the columns: u_slide_m,u_roll_m,P_N_per_m"},
        {"u_slide_m,P_N_per_m\n0,0\n", ":1: error: no column u_roll_m in the header line"},
        {"u_slide_m,u_roll_m,P_N\n0,0,0\n", ":1: error: no column P_N_per_m in the header line"},
        {COLUMNS, ":1: error: no row after the header line"},
        {COLUMNS "0,0,1,1\n0,nan,1,2\n", ":3: error: u_roll_m is \"nan\", which is not a number"},
        {COLUMNS "0,0,1,1\n0,inf,1,2\n", ":3: error: u_roll_m is inf: it must be finite"},
        {COLUMNS "0,0,-1,1\n", ":2: error: P_N_per_m is -1: "},
        {COLUMNS "0,0,1,1\n0,0,1,1\n", ":3: error: time_s is 1: it must grow"},
        {COLUMNS "0,0,1,0\n", ":2: error: time_s is 0: it must grow from row to row, and from 0"},
        {COLUMNS "0,0,1e308,1\n", ":2: error: P_N_per_m is 1e308, allowed is up to 1e+12"},
        {COLUMNS "0,-1e4,1,1\n", ":2: error: u_roll_m is -1e4, allowed is up to 1000"},
        {COLUMNS "0,0,1e9,1\n", ":2: error: this force presses the contact of `laws.0` as wide as its depth, 0.001 m"},
        {"u_slide_m,u_roll_m,P_N_per_m\n0,0,1\n",
         ":1: error: no column time_s: the law star-displacement-damping of `laws.0` depends on the rate"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        tr_scene s;
        tr_status st = {0};
        char text[500], begins[300];
        write_file(rows[i].csv);
        snprintf(text, sizeof text, HEAD "path: %s\n", file);
        if (!read_case(&s, "a.yaml", text, &st)) fail_msg("%s", st.text);
        assert_false(tr_path_read(&s, &st));
        assert_int_equal(st.code, TR_BAD_CASE);
        snprintf(begins, sizeof begins, "%s%s", file, rows[i].message);
        if (strncmp(st.text, begins, strlen(begins)) != 0) fail_msg("%s\nis not\n%s", st.text, begins);
        tr_scene_free(&s);
    }
    tr_scene s;
    tr_status st = {0};
    assert_false(read_case(&s, "a.yaml", HEAD "path: nowhere.csv\n", &st));
    assert_non_null(strstr(st.text, "a.yaml:4:7: error: cannot read nowhere.csv: No such file or directory\n"));
}

/* Without the dashpot nothing depends on the rate: no times are asked for. The closed forms take no path from a
 * file. */
static void what_needs_no_times(void **state) {
    (void)state;
    tr_scene s;
    tr_status st = {0};
    char text[500];
    write_file("u_slide_m,u_roll_m,P_N_per_m\n0,1e-6,1000\n");
    snprintf(text, sizeof text,
             "kind: contact\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3}\n"
             "laws: [{rolling: star-displacement-damping}]\npath: %s\n",
             file);
    if (!read_case(&s, "a.yaml", text, &st) || !tr_path_read(&s, &st)) fail_msg("%s", st.text);
    tr_scene_free(&s);
    for (int k = 0; k < 4; k++) {
        static const char *const solvers[] = {"half-plane", "brush", "carter", "cattaneo"};
        st = (tr_status){0};
        snprintf(text, sizeof text,
                 "kind: patch\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3}\nmu: 0.3\nsolver: %s\npath: %s\n",
                 solvers[k], file);
        assert_int_equal(read_case(&s, "a.yaml", text, &st), k < 2);
        assert_true(k < 2 || strstr(st.text, "a.yaml:4:9: error: the closed forms are not for any path"));
        tr_scene_free(&s);
    }
}

static int open_folder(void **state) {
    (void)state;
    if (!mkdtemp(folder)) return -1;
    snprintf(file, sizeof file, "%s/path.csv", folder);
    return 0;
}

static int close_folder(void **state) {
    (void)state;
    return unlink(file) || rmdir(folder);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(same_as_written_out), cmocka_unit_test(refuses),
                                       cmocka_unit_test(a_check_beyond_the_last_row_is_refused),
                                       cmocka_unit_test(what_needs_no_times)};
    return cmocka_run_group_tests_name("path", tests, open_folder, close_folder);
}
