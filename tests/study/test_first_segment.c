/* SPDX-License-Identifier: MIT */
/* A path begins under the force, or at the overlap, of its first segment with Q = 0. So what its first segment slides
 * and rolls gives the same as behind a segment that only presses: by closed forms, in any number of steps, and for each
 * law and each way to give a path. */
#include "assert_close.h"
#include "laws/law.h"
#include "study/contact.h"
#include "study/every_law.h"
#include "study/inside.h"
#include "study/path.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST = 200 };

static const double E_STAR = 70e9 / (2 * 0.91), R_STAR = 0.005, MU = 0.3, NU = 0.3;

#define DISKS "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, depth: 4 mm, density: 2700}\n"
#define SPHERES "kind: contact\nbodies: {shape: sphere, R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, density: 2700}\n"

/* The states of all laws, law by law, of the last n steps; returns the number of laws. */
static int drive(const char *text, int n, tr_contact_state last[][MOST]) {
    tr_scene scene;
    tr_status st = {0};
    if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    if (scene.path_file && !tr_path_read(&scene, &st)) fail_msg("%s", st.text);
    tr_contact *c = tr_contact_new(&scene, &st);
    assert_non_null(c);
    int steps = (int)tr_contact_steps(&scene), laws = scene.n_laws;
    for (int k = 0; k < steps; k++) {
        tr_contact_state now[TR_MAX_LAWS];
        if (!tr_contact_step(c, now, &st)) fail_msg("%s", st.text);
        for (int l = 0; l < laws && k >= steps - n; l++) last[l][k - steps + n] = now[l];
    }
    tr_contact_free(c);
    tr_scene_free(&scene);
    return laws;
}

static tr_contact_state one[TR_MAX_LAWS][MOST], two[TR_MAX_LAWS][MOST];

/* ---- closed forms of the virgin curve */

static double spheres(double u, double delta) { /* Mindlin */
    double y = 1 - u / (MU * (2 - NU) / (2 * (1 - NU)) * delta);
    return 1 - y * sqrt(y);
}

/* Cattaneo, Lambda = 4: u = (2 mu P/(pi E_star)) (q (Lambda + 1/2) + (1 - q) ln(1 - q)/2), which grows with q. */
static double disks(double u, double P) {
    double low = 0, high = 1, unit = 2 * MU * P / (M_PI * E_STAR);
    for (int k = 0; k < 100; k++) {
        double q = 0.5 * (low + high);
        *(unit * (q * 4.5 + 0.5 * (1 - q) * log(1 - q)) < u ? &low : &high) = q;
    }
    return low;
}

static void slides_from_its_own_force(void **state) {
    (void)state;
    static const int steps[] = {1, 10, 100};
    const double delta = 2e-6, u = 5e-7, P = 4.0 / 3 * E_STAR * sqrt(R_STAR * delta) * delta;
    const double P_line = 1e4, u_line = 0.6 * 2 * MU * P_line / (M_PI * E_STAR) * 4.5;
    for (int k = 0; k < 3; k++)
        for (int by_force = 0; by_force < 2; by_force++) {
            char text[500];
            snprintf(text, sizeof text,
                     SPHERES "laws: [{friction: cattaneo-mindlin, mu: 0.3}]\n"
                             "path: [{%s: %.17g, slide: %.17g, steps: %d}]\n",
                     by_force ? "force" : "overlap", by_force ? P : delta, u, steps[k]);
            drive(text, steps[k], one);
            for (int i = 0; i < steps[k]; i++) /* the overlap is found to 1e-12 of itself, the pieces keep 1e-12 */
                assert_close(one[0][i].q, spheres(u * (i + 1) / steps[k], delta), 0, 1e-11);
            snprintf(text, sizeof text,
                     "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, depth: %.17g}\n"
                     "laws: [{friction: cattaneo-mindlin, mu: 0.3}]\n"
                     "path: [{%s: %.17g, slide: %.17g, steps: %d}]\n",
                     0.5 * exp(4) * sqrt(4 * P_line * R_STAR / (M_PI * E_STAR)), by_force ? "force" : "overlap",
                     by_force ? P_line : 2 * P_line / (M_PI * E_STAR) * 4.5, -u_line, steps[k]);
            drive(text, steps[k], one);
            for (int i = 0; i < steps[k]; i++)
                assert_close(-one[0][i].Q / (MU * P_line), disks(u_line * (i + 1) / steps[k], P_line), 0, 1e-11);
        }
}

/* Vu-Quoc and Zhang: u' = (u/c)(1 - e^-c), c = (2/pi) roll/a, on the same curve: exact in any number of steps. */
static void rolls_from_its_own_force(void **state) {
    (void)state;
    const double delta = 2e-6, u = 5e-7, a = sqrt(R_STAR * delta), c = 2 / M_PI * 1.5;
    for (int steps = 1; steps < MOST; steps *= 7) {
        char text[500];
        snprintf(text, sizeof text,
                 SPHERES "laws: [{friction: vu-quoc-zhang, mu: 0.3}]\n"
                         "path: [{overlap: %.17g, slide: %.17g, roll: %.17g, steps: %d}]\n",
                 delta, u, 1.5 * a, steps);
        drive(text, 1, one);
        assert_close(one[0][0].q, spheres(u / c * -expm1(-c), delta), 0, 1e-11);
    }
}

/* ---- every law, every way: bit for bit as behind a segment that only presses */

static void same(int laws, int n) {
    for (int l = 0; l < laws; l++)
        for (int i = 0; i < n; i++) {
            const tr_contact_state *a = &one[l][i], *b = &two[l][i];
            assert_true(a->Q == b->Q && a->q == b->q && a->P == b->P && a->overlap == b->overlap);
            assert_true(a->moment_1 == b->moment_1 && a->moment_2 == b->moment_2 && a->f_r == b->f_r);
        }
}

static void every_law(void **state) {
    (void)state;
    static const char *const bodies[] = {DISKS, SPHERES}, *const load[] = {"force: 500", "overlap: 1 um"};
    for (int shape = 0; shape < 2; shape++) {
        laws_text every = {""};
        add_laws(&every, shape ? TR_SHAPE_SPHERE : TR_SHAPE_DISK, true);
        for (int how = 0; how < 2; how++)
            for (int steps = 1; steps < 50; steps += 16) {
                char path[400], text[5000];
                snprintf(path, sizeof path,
                         "  - {%s, slide: 0.2 um, roll: 30 um, time: 1 ms, steps: %d}\n"
                         "  - {force: 800, slide: -0.3 um, roll: -10 um, time: 1 ms, steps: 5}\n",
                         load[how], steps);
                snprintf(text, sizeof text, "%slaws:\n%spath:\n%s", bodies[shape], every.s, path);
                int laws = drive(text, steps + 5, one);
                snprintf(text, sizeof text, "%slaws:\n%spath:\n  - {%s, time: 1 ms, steps: 2}\n%s", bodies[shape],
                         every.s, load[how], path);
                assert_int_equal(drive(text, steps + 5, two), laws);
                same(laws, steps + 5);
                for (int l = 0; l < laws; l++) assert_true(one[l][0].Q != 0 || one[l][0].moment_1 != 0);
            }
    }
}

static char folder[] = "/tmp/trundle-first-XXXXXX", file[64];

static void write_rows(const char *rows) {
    FILE *f = fopen(file, "w");
    assert_non_null(f);
    fprintf(f, "u_slide_m,u_roll_m,P_N_per_m,time_s\n%s", rows);
    assert_int_equal(fclose(f), 0);
}

static void first_row_of_a_file(void **state) {
    (void)state;
    char text[5000];
    laws_text every = {""};
    add_laws(&every, TR_SHAPE_DISK, true);
    snprintf(text, sizeof text, DISKS "laws:\n%spath: %s\n", every.s, file);
    write_rows("4e-9,1e-6,500,1\n2e-8,3e-6,500,2\n1e-8,2e-6,800,3\n");
    int laws = drive(text, 3, one);
    write_rows("0,0,500,1\n4e-9,1e-6,500,2\n2e-8,3e-6,500,3\n1e-8,2e-6,800,4\n");
    drive(text, 3, two);
    same(laws, 3);
}

static void inside(const char *solver, const char *path, int n, tr_contact_state *last, double *tau) {
    char text[600];
    tr_scene scene;
    tr_status st = {0};
    snprintf(text, sizeof text,
             "kind: patch\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}\ndepth: 4 mm\nmu: 0.3\nelements: 40\n"
             "solver: %s\npath:\n%s",
             solver, path);
    if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    tr_inside *o = tr_inside_new(&scene, &st);
    assert_non_null(o);
    int steps = (int)tr_contact_steps(&scene);
    for (int k = 0; k < steps; k++) {
        tr_contact_state now;
        if (!tr_inside_step(o, &now, &st)) fail_msg("%s", st.text);
        if (k >= steps - n) last[k - steps + n] = now;
    }
    memcpy(tau, tr_inside_patch(o)->tau, 40 * sizeof *tau);
    tr_inside_free(o);
    tr_scene_free(&scene);
}

static void inside_of_a_contact(void **state) {
    (void)state;
    static const char *const solver[] = {"half-plane", "brush"}, *const first[] = {"slide: 0.2 um, roll: 0.3*a",
                                                                                   "tangential: 1 kN/m, roll: 0.3*a"};
    for (int k = 0; k < 2; k++)
        for (int by_Q = 0; by_Q < 2; by_Q++)
            for (int steps = 1; steps < 20; steps += 6) {
                char path[300], pressed[400];
                double tau[40], want[40];
                snprintf(path, sizeof path,
                         "  - {force: 10 kN/m, %s, steps: %d}\n"
                         "  - {force: 20 kN/m, slide: -0.2 um, roll: -a, steps: 5}\n",
                         first[by_Q], steps);
                snprintf(pressed, sizeof pressed, "  - {force: 10 kN/m, steps: 1}\n%s", path);
                inside(solver[k], path, steps + 5, one[0], tau), inside(solver[k], pressed, steps + 5, two[0], want);
                same(1, steps + 5);
                for (int i = 0; i < 40; i++) assert_true(tau[i] == want[i]);
                assert_true(one[0][0].Q != 0);
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
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slides_from_its_own_force),
        cmocka_unit_test(rolls_from_its_own_force),
        cmocka_unit_test(every_law),
        cmocka_unit_test(first_row_of_a_file),
        cmocka_unit_test(inside_of_a_contact),
    };
    return cmocka_run_group_tests_name("first_segment", tests, open_folder, close_folder);
}
