/* SPDX-License-Identifier: MIT */
/* `checks:` along a path, of `kind: contact` and `patch`: what is measured, where on the path, of which law. The
 * numbers are closed forms. */
#include "assert_close.h"
#include "laws/law.h"
#include "out/dir.h"
#include "out/summary_read.h"
#include "study/run.h"

#include <stdlib.h>
#include <string.h>

static char folder[] = "/tmp/test_path_checks_XXXXXX";
static tr_run_report report;
static char summary[TR_PATH], table[TR_PATH];

#define CONTACT "kind: contact\noutput: {curves: no}\n"
#define PATCH "kind: patch\nmu: 0.3\nLambda: 4\nelements: 100\noutput: {frames: 0, curves: no}\n"
#define DISKS "bodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3}\n"
#define BALLS "bodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3, shape: sphere}\n"
#define LAWS "laws: [{friction: coulomb-spring, mu: 0.3, k_t: 1e9, rolling: wang-spring, mu_r: 0.01, k_r: 1e9}, {}]\n"
#define PATH "path: [{force: 2, slide: 1e-10, roll: 1 um, steps: 7}, {force: 4, slide: -1 m, steps: 3}]\n"

static const double E_star = 70e9 / (2 * (1 - 0.09)), R_star = 0.01 * 0.03 / 0.04;

/* Runs the case with checks of these, each with exact 0 and no tolerance to speak of: none but a zero agrees. */
static void run(const char *text, const char *const *checks, int n) {
    char all[4000], path[TR_PATH], dir[TR_PATH];
    tr_scene scene;
    tr_status st = {0};
    int used = snprintf(all, sizeof all, "%schecks:\n", text);
    for (int i = 0; i < n; i++)
        used +=
            snprintf(all + used, sizeof all - (size_t)used, "  - {what: %s, exact: 0, tolerance: 1e-30}\n", checks[i]);
    if (!tr_file_write(folder, "case.yaml", all, &st) || !tr_dir_path(path, folder, "case.yaml", &st) ||
        !tr_scene_read_file(&scene, path, NULL, 0, tr_laws_catalog(), &st) || !tr_dir_path(dir, folder, "run", &st))
        fail_msg("%s", st.text);
    report = (tr_run_report){0};
    if (!tr_run(&scene, &(tr_run_options){.dir = dir, .force = true, .checkpoint = 60}, &report, &st) ||
        !tr_dir_path(summary, dir, "summary.json", &st) || !tr_dir_path(table, dir, "contact.csv", &st))
        fail_msg("%s", st.text);
    tr_scene_free(&scene);
}

static double measured(int check) {
    char name[40];
    double value;
    tr_status st = {0};
    snprintf(name, sizeof name, "checks.%d.measured", check);
    if (!tr_summary_read(summary, name, &value, &st)) fail_msg("%s", st.text);
    return value;
}

/* A spring of 1 GPa slides by 0.1 nm: 0.1 N/m. Back by a metre: its bound, 0.3 times 4 N/m. Rolled by 1 um: the
 * moment is at its bound, R_eff mu_r P, against the way it rolls. The second law is none. */
static void each_law_at_the_end_of_each_segment(void **state) {
    (void)state;
    static const char *const checks[] = {"Q, segment: 0",
                                         "Q, segment: 1",
                                         "Q",
                                         "Q, law: 1",
                                         "P, segment: 0",
                                         "P",
                                         "q, segment: 0",
                                         "moment_1, segment: 0",
                                         "moment_2, segment: 0",
                                         "u_slide, segment: 0",
                                         "u_roll",
                                         "a"};
    const double exact[] = {
        0.1,       -1.2,          -1.2,           0,     2,    4,
        0.1 / 0.6, R_star * 0.02, -R_star * 0.02, 1e-10, 1e-6, sqrt(4 * 4 * R_star / (M_PI * E_star))};
    const int n = sizeof checks / sizeof *checks;
    run(CONTACT DISKS LAWS PATH, checks, n);
    for (int i = 0; i < n; i++)
        assert_close(measured(i), exact[i], 1e-11, 0); /* roundings of a roll that is 1e4 times the slide */
    assert_int_equal(report.failed, n - 1);
    int failed;
    tr_status st = {0};
    assert_true(tr_summary_failed(summary, &failed, &st) && failed == n - 1);
}

/* Their names have the units that the checks have. */
static void columns_of_spheres_have_their_units(void **state) {
    (void)state;
    static const char *const checks[] = {"P", "a"};
    char line[400] = "";
    run(CONTACT BALLS LAWS PATH, checks, 2);
    assert_close(measured(0), 4, 0, 0);
    assert_close(measured(1), cbrt(3 * 4 * R_star / (4 * E_star)), 1e-12, 0);
    FILE *file = fopen(table, "r");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    fclose(file);
    assert_string_equal(
        line, "law,step,segment,u_slide_m,u_roll_m,P_N,Q_N,q,a_m,moment_1_N_m,moment_2_N_m,f_r_N,overlap_m,"
              "R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2,dt_s\n");
}

/* Slid far beyond full slip: all of it rubs at mu P, and nothing sticks. Hertz: p_max = 2 P/(pi a). */
static void the_inside_has_four_columns_more(void **state) {
    (void)state;
    static const char *const checks[] = {"p_max", "stick, segment: 0", "stick", "creepage", "dissipated", "Q"};
    const double P = 1e4, a = sqrt(4 * P * R_star / (M_PI * E_star)), u = 1e-3;
    run(PATCH DISKS "path: [{force: 1e4, tangential: 0, steps: 1}, {force: P, slide: 1 mm, steps: 20}]\n", checks, 6);
    assert_close(measured(0), 2 * P / (M_PI * a), 1e-12, 0);
    assert_close(measured(1), 2 * a, 1e-12, 0);
    assert_close(measured(2), 0, 0, 0);
    assert_true(isnan(measured(3))); /* it does not roll */
    double Q = 0.3 * P;              /* all of mu P u but what it takes to full slip, which is 3e-4 of it here */
    assert_close(measured(4), Q * u, Q * 4.5 * 2 / (M_PI * E_star * u), 0);
    assert_true(measured(4) < Q * u);
    assert_close(measured(5), Q, 1e-9, 0); /* the sum over 100 elements */
}

/* [Carter1926]: the creepage at Q = mu P/2 is (mu a/R_star) (1 - sqrt(1/2)), and 2 a sqrt(1/2) sticks. The solver
 * of that name has it exactly, but for the element in which the edge of stick falls. Rolled back it has the sign
 * of Q still. */
static void creepage_is_that_of_carter(void **state) {
    (void)state;
    static const char *const checks[] = {"creepage, segment: 0", "creepage", "stick"};
    const double P = 1e4, a = sqrt(4 * P * R_star / (M_PI * E_star)), c = sqrt(0.5), xi = 0.3 * a / R_star * (1 - c);
    run("solver: carter\n" PATCH DISKS
        "path: [{force: 1e4, tangential: 0.5*mu*P, roll: a}, {force: P, tangential: 0.5*mu*P, "
        "roll: -a, steps: 1}]\n",
        checks, 3);
    assert_true(fabs(measured(0)) > 0);
    assert_close(measured(1), xi, 1e-12, 0);
    assert_close(measured(2), 2 * a * c, 0, 2 * 2 * a / 100);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_law_at_the_end_of_each_segment), cmocka_unit_test(columns_of_spheres_have_their_units),
        cmocka_unit_test(the_inside_has_four_columns_more), cmocka_unit_test(creepage_is_that_of_carter)};
    if (!mkdtemp(folder)) return 1;
    int failed = cmocka_run_group_tests_name("checks along a path", tests, NULL, NULL);
    char command[100];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command) || failed;
}
