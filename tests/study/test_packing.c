/* SPDX-License-Identifier: MIT */
/* A run that starts from a packing in a file gives the bytes of a run that compacts its own; the packing is of the
 * seed, sizes, normal law and compaction alone; what is not it is refused. */
#include "assert_close.h"
#include "base/checkpoint.h"
#include "laws/law.h"
#include "study/packing.h"
#include "study/run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const char text[] =
    "kind: biaxial\nseed: 3\nsample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm}\n"
    "contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5}\n"
    "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"
    "shear: {inertial_number: 2e-3, strain_end: 0.01}\noutput: {frames: 0, rows: 5, contacts: 5}\n";
static char dir[] = "/tmp/trundle-packing-XXXXXX", file[64];
static int compactions; /* calls of progress in that stage */

static tr_scene scene_with(const char *const *sets, int n) {
    tr_scene scene;
    tr_status st = {0};
    if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), sets, n}, tr_laws_catalog(), &st)) fail_msg("%s", st.text);
    return scene;
}

static void count(void *context, const char *stage, double fraction) {
    (void)context, (void)fraction;
    compactions += !strcmp(stage, "compaction");
}

static bool run(const char *name, const char *const *sets, int n, const char *sample, tr_status *st) {
    static tr_run_report report;
    char path[128];
    snprintf(path, sizeof path, "%s/%s", dir, name);
    tr_scene scene = scene_with(sets, n);
    tr_run_options options = {.dir = path, .force = true, .checkpoint = 1e9, .sample = sample, .progress = count};
    *st = (tr_status){0};
    compactions = 0;
    bool ok = tr_run(&scene, &options, &report, st);
    tr_scene_free(&scene);
    return ok;
}

static void must_run(const char *name, const char *const *sets, int n, const char *sample) {
    tr_status st;
    if (!run(name, sets, n, sample, &st)) fail_msg("%s", st.text);
}

static void assert_same(const char *a, const char *b) {
    char command[600];
    snprintf(command, sizeof command,
             "cd %s && sed -i '/\"timing\"/,/}/d' %s/summary.json %s/summary.json && "
             "diff -r -x trundle-files.txt %s %s", dir, a, b, a, b);
    assert_int_equal(system(command), 0);
}

static void starts_the_same(const char *boundary) {
    /* Of the shear: laws, rolling velocity, step, walls. None of them may change the packing. */
    const char *const shears[][3] = {
        {boundary, "contact.mu=0.3", "contact.mu_r=0"},
        {boundary, "contact.k_r=10*k_t", "step.safety=0.1"},
        {boundary, "contact.rolling_velocity=alonso-min", "shear.lateral_pressure=100 kPa"},
        {boundary, "contact.rolling=none", strstr(boundary, "walls") ? "shear.walls=rough" : "shear.hold=mean"},
    };
    for (int i = 0; i < 4; i++) {
        must_run("alone", shears[i], 3, NULL);
        assert_true(compactions > 0);
        must_run("shared", shears[i], 3, file);
        assert_true(i == 0 ? compactions > 0 : compactions == 0); /* the first makes it */
        assert_same("alone", "shared");
        must_run("again", shears[i], 3, file);
        assert_int_equal(compactions, 0);
        assert_same("alone", "again");
    }
}

static void test_the_same_bytes(void **state) {
    (void)state;
    starts_the_same("boundary=walls");
}

static void test_the_same_bytes_in_a_cell(void **state) {
    (void)state;
    starts_the_same("boundary=periodic");
}

/* The friction of the compaction goes through the file; where the shear has less, the packing has come to rest with
 * that. */
static void friction_goes_through(const char *boundary) {
    const char *const sets[][3] = {{boundary, "compaction.mu=0.3", "contact.mu_r=0"},
                                   {boundary, "compaction.mu=0.3", "shear.inertial_number=4e-3"},
                                   {boundary, "compaction.mu=0.3", "contact.mu=0.1"}};
    for (int i = 0; i < 3; i++) {
        const char *sample = i < 2 ? file : NULL;
        must_run("alone", sets[i], 3, NULL);
        must_run("shared", sets[i], 3, sample);
        assert_true(i == 1 ? compactions == 0 : compactions > 0);
        assert_same("alone", "shared");
    }
    tr_status st; /* another packing */
    assert_false(run("shared", sets[2], 3, file, &st));
    if (!strstr(st.text, "mu: 0.3")) fail_msg("%s", st.text);
}

static void test_friction_goes_through_the_file(void **state) {
    (void)state;
    friction_goes_through("boundary=walls");
    unlink(file);
    friction_goes_through("boundary=periodic");
}

/* A packing with friction from before the file had histories: that its text says version 1 is all
 * that counts. */
static void test_an_old_packing_with_friction(void **state) {
    (void)state;
    const char *const sets[] = {"compaction.mu=0.3"};
    tr_scene scene = scene_with(sets, 1);
    tr_status st = {0};
    tr_checkpoint c;
    char *now = tr_packing_text(&scene, &st), old[8000];
    assert_true(now && strlen(now) < sizeof old);
    snprintf(old, sizeof old, "packing: 1%s", strchr(now, '\n'));
    tr_checkpoint_begin(&c, old, &st);
    assert_true(tr_checkpoint_write(&c, dir, "sample.bin"));
    assert_false(run("old", sets, 1, file, &st));
    assert_int_equal(st.code, TR_FILE);
    const char *why = "it has `packing: 1`, this case has `packing: 2, with friction histories`";
    if (!strstr(st.text, why)) fail_msg("%s", st.text);
    if (!strstr(st.text, "remove it")) fail_msg("%s", st.text);
    free(now), tr_scene_free(&scene);
}

/* And a finished run that was to be replaced is still there. */
static void refuses(const char *const *sets, int n, const char *sample, const char *why) {
    tr_status st;
    char summary[128];
    must_run("refused", NULL, 0, NULL);
    snprintf(summary, sizeof summary, "%s/refused/summary.json", dir);
    assert_false(run("refused", sets, n, sample, &st));
    assert_int_equal(st.code, TR_FILE);
    if (!strstr(st.text, why)) fail_msg("no \"%s\" in: %s", why, st.text);
    assert_int_equal(access(summary, F_OK), 0);
}

static void assert_refused(const char *const *sets, int n, const char *why) {
    refuses(sets, n, file, why);
}

/* Friction while compacting makes all of the friction law part of the packing. */
static void test_another_packing(void **state) {
    (void)state;
    static const char *const other[][2] = {{"seed=4", "it has `seed: 3"},
                                           {"sample.density=2600", "density"},
                                           {"compaction.pressure=100 kPa", "pressure"},
                                           {"contact.k_n=150 MPa", "k_n"},
                                           {"contact.damping_ratio=0.4", "damping_ratio"},
                                           {"compaction.mu=0.1", "friction"},
                                           {"boundary=periodic", "boundary: walls"}};
    must_run("first", NULL, 0, file);
    for (int i = 0; i < 7; i++) assert_refused(other[i], 1, other[i][1]);
}

static void test_a_damaged_file(void **state) {
    (void)state;
    must_run("first", NULL, 0, file);
    FILE *f = fopen(file, "r+b");
    fseek(f, 2000, SEEK_SET);
    int byte = fgetc(f);
    fseek(f, 2000, SEEK_SET);
    fputc(byte ^ 1, f);
    fclose(f);
    assert_refused(NULL, 0, "is damaged: its checksum is wrong");
    assert_int_equal(truncate(file, 1000), 0);
    assert_refused(NULL, 0, "is cut short: 1000 bytes of ");
}

/* Four processes that want one packing: three wait for the one that makes it. */
static void test_one_makes_it(void **state) {
    (void)state;
    static const char *const name[] = {"p0", "p1", "p2", "p3"};
    char part[80];
    int made = 0, status;
    snprintf(part, sizeof part, "%s.part", file);
    for (int i = 0; i < 4; i++) {
        pid_t pid = fork();
        if (pid) continue;
        tr_status st;
        bool ok = run(name[i], NULL, 0, file, &st);
        _exit(ok ? compactions > 0 : 99); /* no return into the test */
    }
    for (int i = 0; i < 4; i++) {
        assert_true(wait(&status) > 0 && WIFEXITED(status));
        assert_in_range(WEXITSTATUS(status), 0, 1);
        made += WEXITSTATUS(status);
    }
    assert_int_equal(made, 1);
    assert_true(access(part, F_OK) != 0);
    must_run("alone", NULL, 0, NULL);
    for (int i = 0; i < 4; i++) assert_same("alone", name[i]);
}

static void test_no_place_for_it(void **state) {
    (void)state;
    refuses(NULL, 0, "/nowhere/sample.bin", "cannot write /nowhere/sample.bin");
    refuses(NULL, 0, "", "--sample needs the name of a file");
}

static int begin(void **state) {
    (void)state;
    unlink(file);
    return 0;
}

int main(void) {
    if (!mkdtemp(dir)) return 1;
    snprintf(file, sizeof file, "%s/sample.bin", dir);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_the_same_bytes, begin),
        cmocka_unit_test_setup(test_the_same_bytes_in_a_cell, begin),
        cmocka_unit_test_setup(test_friction_goes_through_the_file, begin),
        cmocka_unit_test_setup(test_an_old_packing_with_friction, begin),
        cmocka_unit_test_setup(test_another_packing, begin),
        cmocka_unit_test_setup(test_a_damaged_file, begin),
        cmocka_unit_test_setup(test_one_makes_it, begin),
        cmocka_unit_test_setup(test_no_place_for_it, begin),
    };
    int failed = cmocka_run_group_tests_name("packing", tests, NULL, NULL);
    char command[96];
    snprintf(command, sizeof command, "rm -r %s", dir);
    return failed || system(command);
}
