/* SPDX-License-Identifier: MIT */
/* Rows of a path of any length: kind: contact with `friction: exact` and kind: patch give Carter's steady rolling, and
 * the transient of the half-plane in steps of an element, whether a row rolls 0.01 a or a million. */
#include "assert_close.h"
#include "laws/law.h"
#include "patch/carter.h"
#include "patch/half_plane.h"
#include "study/inside.h"
#include "study/path.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double P = 1e4, MU = 0.3, R_STAR = 0.0075, DEPTH = 5e-4, E_STAR = 70e9 / (2 * 0.91);
/* Elements of a/50 are that far from Carter and from finer ones, in q: in steps of an element 1.1e-3 at a/100, of first
 * order in the width; rows shorter than an element about twice as far (half_plane.h). */
static const double COARSE = 0.006;
static const double ROWS[] = {0.01, 0.1, 0.5, 2, 5, 20, 200}; /* a */
enum { N_ROWS = sizeof ROWS / sizeof *ROWS };

#define BODIES "bodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3, depth: 0.5 mm}\n"
static const char *const HEADS[] = {
    "kind: patch\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3}\ndepth: 0.5 mm\nmu: 0.3\nelements: 100\nsolver: "
    "half-plane\n",
    "kind: contact\n" BODIES "laws: [{friction: exact, mu: 0.3, elements: 100}]\n",
    "kind: contact\n" BODIES "laws: [{friction: dahlberg-alfredsson, mu: 0.3, k_t: pi*E_star/6}]\n",
    "kind: contact\n" BODIES "laws: [{friction: kuhn-creep, mu: 0.3, normal: hertz-line, depth: 0.5 mm}]\n",
    "kind: contact\n" BODIES "laws: [{friction: vu-quoc-zhang, mu: 0.3, normal: hertz-line, depth: 0.5 mm}]\n"};
enum { PATCH, EXACT, DAHLBERG, KUHN, VU_QUOC };

static char folder[] = "/tmp/trundle-rows-XXXXXX", file[64];

static double width(void) {
    return sqrt(4 * P * R_STAR / (M_PI * E_STAR));
}

/* A part of a path: how far, in how many rows. slide NAN: under the force `tangential`. */
typedef struct part {
    double force, roll, slide, tangential;
    int rows;
} part;

static void write_segments(char *text, size_t size, const part *parts, int n) {
    size_t used = (size_t)snprintf(text, size, "path:\n");
    for (int i = 0; i < n; i++) {
        used += (size_t)snprintf(text + used, size - used, "  - {force: %.17g, roll: %.17g, steps: %d, ",
                                 parts[i].force, parts[i].roll, parts[i].rows);
        bool pulled = isnan(parts[i].slide);
        used += (size_t)snprintf(text + used, size - used, "%s: %.17g}\n", pulled ? "tangential" : "slide",
                                 pulled ? parts[i].tangential : parts[i].slide);
    }
}

/* The first row is the start of the path: its force, nothing slid. */
static void write_rows(char *text, size_t size, const part *parts, int n) {
    FILE *f = fopen(file, "w");
    double slide = 0, roll = 0, force = parts[0].force;
    assert_non_null(f);
    fprintf(f, "u_slide_m,u_roll_m,P_N_per_m\n0,0,%.17g\n", force);
    for (int i = 0; i < n; i++) {
        for (int k = 1; k <= parts[i].rows; k++) {
            double at = (double)k / parts[i].rows;
            fprintf(f, "%.17g,%.17g,%.17g\n", slide + at * parts[i].slide, roll + at * parts[i].roll,
                    force + at * (parts[i].force - force));
        }
        slide += parts[i].slide, roll += parts[i].roll, force = parts[i].force;
    }
    assert_int_equal(fclose(f), 0);
    snprintf(text, size, "path: %s\n", file);
}

/* The state at the end, and u_slide a row before. */
static tr_contact_state drive(int head, bool from_file, const part *parts, int n, double *u_before) {
    static char text[4000], path[2000];
    tr_scene scene;
    tr_status st = {0};
    tr_contact_state s = {0};
    (from_file ? write_rows : write_segments)(path, sizeof path, parts, n);
    snprintf(text, sizeof text, "%s%s", HEADS[head], path);
    if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    if (from_file && !tr_path_read(&scene, &st)) fail_msg("%s", st.text);
    tr_inside *inside = head == PATCH ? tr_inside_new(&scene, &st) : NULL;
    tr_contact *contact = head == PATCH ? NULL : tr_contact_new(&scene, &st);
    for (int64_t k = tr_contact_steps(&scene); k > 0; k--) {
        if (u_before) *u_before = s.u_slide;
        if (inside ? !tr_inside_step(inside, &s, &st) : !tr_contact_step(contact, &s, &st)) fail_msg("%s", st.text);
    }
    tr_inside_free(inside), tr_contact_free(contact), tr_scene_free(&scene);
    return s;
}

static double q_after(int head, bool from_file, const part *parts, int n) {
    return drive(head, from_file, parts, n, NULL).Q / (MU * P);
}

/* Steady rolling at xi = F0/2: q = 1 - (1 - 1/2)^2 of the sign of the sliding, whichever way it rolls. 30 a at Lambda =
 * 3 leave e^-10 of the start. */
static void steady_rolling_in_rows_of_any_length(void **state) {
    (void)state;
    const double a = width(), F0 = MU * a / R_STAR;
    for (int i = 0; i < N_ROWS + 1; i++)
        for (int head = PATCH; head <= EXACT; head++)
            for (int way = 0; way < 4; way++) {
                double row = i < N_ROWS ? ROWS[i] : 1e6, slide = way & 1 ? -1 : 1, roll = way & 2 ? -1 : 1;
                if (row < 0.1 && way) continue; /* all the same: many rows */
                int rows = (int)ceil(30 / row);
                part p = {P, roll * rows * row * a, slide * 0.5 * F0 * rows * row * a, NAN, rows};
                assert_close(q_after(head, false, &p, 1), 0.75 * slide, 0, COARSE);
                if (row >= 0.1) assert_close(q_after(head, true, &p, 1), 0.75 * slide, 0, COARSE);
            }
}

/* The same under a prescribed force: it creeps by F0 (1 - sqrt(1 - q)) of the way that it rolls. In a row of 30 a or
 * more the start has its part: what Cattaneo slides at once, and some a of other creepage. So it is the last row that
 * counts. */
static void steady_creep_under_a_force(void **state) {
    (void)state;
    const double a = width(), F0 = MU * a / R_STAR;
    for (int i = 1; i < N_ROWS + 1; i++)
        for (int way = -1; way <= 1; way += 2) {
            double row = i < N_ROWS ? ROWS[i] : 1e6, before;
            part p[] = {{P, 0, NAN, way * 0.75 * MU * P, 20},
                        {P, 20 * a, NAN, way * 0.75 * MU * P, 200},
                        {P, 2 * row * a, NAN, way * 0.75 * MU * P, 2}};
            tr_contact_state s = drive(PATCH, false, p, 3, &before);
            assert_close(s.Q, way * 0.75 * MU * P, 1e-9, 0);
            assert_close((s.u_slide - before) / (row * a), way * 0.5 * F0, 0.02, 0); /* COARSE q over its slope in xi */
        }
}

/* Pushed to q = 0.6, then 2 a of rolling at xi = -F0/4: in steps of an element of a half-plane of 240, by hand. */
static double by_hand(double slide, double xi) {
    tr_status st = {0};
    enum { FINE = 240 };
    tr_patch_pair pair = {R_STAR, E_STAR, DEPTH, MU};
    tr_half_plane *o = tr_half_plane_new(&pair, FINE, &st);
    const double h = 2 * width() / FINE;
    bool ok = tr_half_plane_step(o, &(tr_patch_step){.P = P, .du = slide}, &st); /* no rolling: exact in one */
    for (int k = 0; k < FINE && ok; k++)
        ok = tr_half_plane_step(o, &(tr_patch_step){.P = P, .dr = h, .du = xi * h}, &st);
    if (!ok) fail_msg("%s", st.text);
    double q = tr_half_plane_state(o)->Q / (MU * P);
    tr_half_plane_free(o);
    return q;
}

static void transient_in_rows_of_any_length(void **state) {
    (void)state;
    const double a = width(), xi = -0.25 * MU * a / R_STAR, slide = 1.2 * 2 * MU * P / (M_PI * E_STAR);
    const double right = by_hand(slide, xi);
    assert_true(right < 0.25 && right > -0.4); /* on its way: it began above 0.3, and ends at -0.4375 */
    for (int i = 0; i < 4; i++)
        for (int head = PATCH; head <= EXACT; head++)
            for (int from_file = 0; from_file < 2; from_file++) {
                part p[] = {{P, 0, slide, NAN, 1}, {P, 2 * a, 2 * a * xi, NAN, (int)(2 / ROWS[i] + 0.5)}};
                double q = q_after(head, from_file, p, 2);
                if (head == PATCH) print_message("rows of %g a: q = %.4f, by hand %.4f\n", ROWS[i], q, right);
                assert_close(q, right, 0, COARSE);
            }
}

/* A law that creeps in rows of a file: as in 2000 steps of the same path, to 0.003: steps of a/100 are of first order
 * for one of them. As one step, rows of 2 a are off by 0.08, which is to be seen; vu-quoc-zhang is linear here, and
 * right in any step. */
static void laws_that_creep_in_rows_of_a_file(void **state) {
    (void)state;
    const double a = width(), xi = -0.25 * MU * a / R_STAR, slide = 1.2 * 2 * MU * P / (M_PI * E_STAR);
    for (int head = DAHLBERG; head <= VU_QUOC; head++) {
        part fine[] = {{P, 0, slide, NAN, 100}, {P, 2 * a, 2 * a * xi, NAN, 2000}};
        double right = q_after(head, false, fine, 2);
        for (int rows = 1; rows <= 10; rows++) {
            part p[] = {{P, 0, slide, NAN, 1}, {P, 2 * a, 2 * a * xi, NAN, rows}};
            double q = q_after(head, true, p, 2), uncut = q_after(head, false, p, 2);
            if (rows < 3)
                print_message("law %d, rows of %g a: q = %.4f, fine %.4f, as one step %.4f\n", head, 2.0 / rows, q,
                              right, uncut);
            assert_close(q, right, 0, 0.003);
            assert_true(rows > 1 || head == VU_QUOC || fabs(uncut - right) > 0.03);
        }
    }
}

/* P grows, or falls, while it slides, in one row: against the bed of sliders, which is exact in one step [Jaeger2005].
 * From open, too. */
static void loading_and_sliding_in_one_row(void **state) {
    (void)state;
    const double unit = 2 * MU * P / (M_PI * E_STAR), from[] = {0, 0.3 * P, 2 * P};
    for (int k = 0; k < 3; k++)
        for (int rows = 1; rows <= 100; rows *= 10) {
            static const char bed[] =
                "kind: contact\n" BODIES
                "laws: [{friction: cattaneo-mindlin, mu: 0.3, normal: hertz-line, depth: 0.5 mm}, "
                "{friction: exact, mu: 0.3, elements: 100}]\npath:\n"
                "  - {force: %.17g, steps: 1}\n"
                "  - {force: 10 kN/m, slide: %.17g, steps: %d}\n"
                "  - {force: 12 kN/m, slide: -%.17g, steps: %d}\n";
            char text[1000];
            snprintf(text, sizeof text, bed, from[k], unit, rows, 2 * unit, rows);
            tr_scene scene;
            tr_status st = {0};
            tr_contact_state s[TR_MAX_LAWS];
            if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(),
                               &st))
                fail_msg("%s", st.text);
            tr_contact *c = tr_contact_new(&scene, &st);
            for (int i = 0; i < 1 + 2 * rows; i++) {
                if (!tr_contact_step(c, s, &st)) fail_msg("%s", st.text);
                if (i % rows) continue; /* ends of the segments */
                print_message("from %g, %d rows: q = %.4f, bed %.4f\n", from[k], rows, s[1].Q / (MU * P),
                              s[0].Q / (MU * P));
                assert_close(s[1].Q, s[0].Q, 0, 2 * COARSE * MU * P);
            }
            tr_contact_free(c), tr_scene_free(&scene);
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
        cmocka_unit_test(steady_rolling_in_rows_of_any_length), cmocka_unit_test(steady_creep_under_a_force),
        cmocka_unit_test(transient_in_rows_of_any_length), cmocka_unit_test(laws_that_creep_in_rows_of_a_file),
        cmocka_unit_test(loading_and_sliding_in_one_row)};
    return cmocka_run_group_tests_name("rows", tests, open_folder, close_folder);
}
