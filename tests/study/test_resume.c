/* SPDX-License-Identifier: MIT */
/* A whole run that is stopped again and again, at known steps in every stage, ends with the bytes of one that is not.
 * The kills at random moments are in system/test_restart.sh. */
#include "assert_close.h"
#include "laws/law.h"
#include "study/run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char format[] =
    "kind: biaxial\nboundary: %s\nseed: 3\nsample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm}\n"
    "contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5, friction: dahlberg-alfredsson, k_t: 80 MPa, E_star: 200 MPa}\n"
    "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"
    "shear: {inertial_number: 2e-3, strain_end: 0.01, %s}\n"
    "output: {frames: 4, rows: 5, contacts: 5, paths: [most-mobilised, %s], path_rows: 7, increments: yes}\n";

static volatile sig_atomic_t stop;
static int compactions, calls;

/* Stops twice in the first stage, and at every call, all 256 steps, in the others. */
static void interrupt(void *context, const char *stage, double fraction) {
    (void)context, (void)fraction;
    bool compaction = !strcmp(stage, "compaction");
    if (!compaction || compactions++ == 10 || compactions == 30) stop = ++calls > 1 || compaction;
}

static bool run(const tr_scene *scene, const char *dir, bool with_stops) {
    static tr_run_report report;
    tr_status st = {0};
    tr_run_options options = {.dir = dir, .resume = true, .checkpoint = 1e9, .stop = &stop};
    if (with_stops) options.progress = interrupt;
    stop = 0, calls = 0; /* the first call of a run that goes on is where it has stopped */
    bool ok = tr_run(scene, &options, &report, &st);
    if (!ok && st.code != TR_INTERRUPTED) fail_msg("%s", st.text);
    return ok;
}

static void stops_in_every_stage(const char *boundary, const char *how, const char *contact) {
    char text[sizeof format + 80];
    snprintf(text, sizeof text, format, boundary, how, contact);
    compactions = 0;
    char dir[] = "/tmp/trundle-resume-XXXXXX", whole[64], parts[64], command[600];
    tr_scene scene;
    tr_status st = {0};
    assert_non_null(mkdtemp(dir));
    snprintf(whole, sizeof whole, "%s/whole", dir), snprintf(parts, sizeof parts, "%s/parts", dir);
    if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    assert_true(run(&scene, whole, false));
    int stops = 0;
    while (!run(&scene, parts, true)) assert_true(++stops < 30);
    assert_true(stops > 5);
    tr_scene_free(&scene);
    snprintf(command, sizeof command, "sed -i '/\"timing\"/,/}/d' %s/*/summary.json && diff -r %s %s", dir, whole,
             parts);
    assert_int_equal(system(command), 0);
    snprintf(command, sizeof command, "rm -r %s", dir);
    assert_int_equal(system(command), 0);
}

static void test_stops_in_every_stage(void **state) {
    (void)state;
    stops_in_every_stage("walls", "walls: rough", "wall1-15");
    stops_in_every_stage("periodic", "hold: mean", "0-15");
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_stops_in_every_stage)};
    return cmocka_run_group_tests_name("resume", tests, NULL, NULL);
}
