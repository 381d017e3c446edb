/* SPDX-License-Identifier: MIT */
/* What a summary.json will have is known before the run: of each kind the names that tr_run_check tells are those of
 * the file that a run leaves. */
#include "assert_close.h"
#include "laws/law.h"
#include "out/dir.h"
#include "out/summary.h"
#include "out/summary_read.h"
#include "scene/text.h"
#include "study/run.h"

#include <stdlib.h>
#include <string.h>

static char folder[] = "/tmp/test_names_XXXXXX";

static void list_name(void *context, const char *name) {
    strcat(strcat(context, name), " ");
}

static void names_are_known_before(void **state) {
    (void)state;
    static const char *const base[] = {
        "kind: biaxial\nsample: {disks: 12, r_min: 1 mm, r_max: 2 mm}\ncontact: {k_n: 1 MPa, mu: 0.5, mu_r: 0.1}\n"
        "compaction: {pressure: 1 kPa, inertial_number: 0.1, unbalanced: 0.1}\n"
        "shear: {inertial_number: 0.01, strain_end: 0.001}\noutput: {frames: 0, curves: no}\n",
        "kind: bodies\ntime_end: 1 ms\ncontact: {k_n: 1 MPa, mu: 0.5, mu_r: 0.1}\noutput: {frames: 0}\n"
        "disks: [{radius: 10 mm, x: 0, y: 20 mm, vx: 1 m/s}]\nwalls: [{nx: 0, ny: 1}]\n"
        "checks: [{what: speed, disk: 0, exact: 1 m/s, tolerance: 1e-9 m/s}]\nlabel: a\n---\nlabel: b\n",
        "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}\noutput: {curves: no}\n"
        "laws: [{friction: cattaneo-mindlin, mu: 0.3}, {rolling: wang-spring, mu_r: 0.1, k_r: 1 GPa}]\n"
        "path: [{force: 1 kN/m, slide: 1 um, steps: 3}]\n",
        ("kind: patch\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}\nmu: 0.3\nelements: 16\n"
         "output: {frames: 0, curves: no}\npath: [{force: 1 kN/m, slide: 1 um, steps: 3}]\n"),
    };
    for (size_t i = 0; i < sizeof base / sizeof *base; i++) {
        tr_scene scene;
        tr_status st = {0};
        static tr_run_report report;
        char dir[TR_PATH], path[TR_PATH], *before = NULL;
        size_t size;
        if (!tr_file_write(folder, "known.yaml", base[i], &st) || !tr_dir_path(path, folder, "known.yaml", &st) ||
            !tr_scene_read_file(&scene, path, NULL, 0, tr_laws_catalog(), &st) ||
            !tr_run_check(&scene, &report, &before, &st) || !tr_dir_path(dir, folder, "known", &st) ||
            !tr_run(&scene, &(tr_run_options){.dir = dir, .force = true, .checkpoint = 60}, &report, &st) ||
            !tr_dir_path(path, dir, "summary.json", &st))
            fail_msg("%s", st.text);
        char *after = tr_text_file(path, &size, &st), told[8192] = "", found[8192] = "";
        tr_summary_numbers(before, list_name, told, &st);
        tr_summary_numbers(after, list_name, found, &st);
        assert_true(strlen(told) > 60);
        assert_string_equal(told, found);
        free(before), free(after);
        tr_scene_free(&scene);
    }
}

static void numbers_by_their_way(void **state) {
    (void)state;
    static const char json[] = "{\"x\": 1, \"deep\": [{\"y\": 2}, {\"y\": 3, \"z\": \"4\"}]}";
    static const char *const none[] = {"",         "y",        "x.",        "x.0",        "deep",      "deep.y",
                                       "deep.2.y", "deep.1.z", "deep.1.y.", "deep.one.y", "deep.-1.y", "deep.1..y"};
    char path[TR_PATH];
    double value;
    tr_status st = {0};
    assert_true(tr_file_write(folder, "deep.json", json, &st) && tr_dir_path(path, folder, "deep.json", &st));
    assert_true(tr_summary_read(path, "x", &value, &st) && value == 1);
    assert_true(tr_summary_read(path, "deep.0.y", &value, &st) && value == 2);
    assert_true(tr_summary_read(path, "deep.1.y", &value, &st) && value == 3);
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        if (tr_summary_read(path, none[i], &value, &st)) fail_msg("`%s` is %g", none[i], value);
        assert_int_equal(st.code, TR_BAD_CASE);
        st = (tr_status){0};
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(names_are_known_before),
                                       cmocka_unit_test(numbers_by_their_way)};
    if (!mkdtemp(folder)) return 1;
    int failed = cmocka_run_group_tests_name("summary names", tests, NULL, NULL);
    char command[100];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command) || failed;
}
