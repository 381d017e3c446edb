/* SPDX-License-Identifier: MIT */
/* What is printed beside the inset of a biaxial test, frame by frame: Q/(mu P) by the law is that of the recorded path,
 * and the exact one that of `kind: patch` along this path. The linker gives tr_draw_biaxial to this test. */
#include "assert_close.h"
#include "draw/frame.h"
#include "draw/frame_biaxial.h"
#include "laws/law.h"
#include "study/contact.h"
#include "study/inside.h"
#include "study/path.h"
#include "study/run.h"
#include "study/table.h"

#include <stdlib.h>
#include <string.h>

static char folder[] = "/tmp/trundle-inset-XXXXXX";

enum { FRAMES = 24, ROLL = 1, FORCE, TIME, FRICTION, COLUMNS };
static const double mu = 0.5;

static struct {
    double time, law, exact;
    bool open;
} shown[FRAMES];
static int n_shown;
static double radius[2];

/* The sign of a number is a minus of three bytes. */
static double number_after(const char *text, const char *word) {
    const char *at = strstr(text, word), minus[] = "−";
    assert_non_null(at);
    at += strlen(word);
    bool negative = !strncmp(at, minus, strlen(minus));
    return negative ? -strtod(at + strlen(minus), NULL) : strtod(at, NULL);
}

void __real_tr_draw_biaxial(tr_canvas *canvas, const tr_view *view);
void __wrap_tr_draw_biaxial(tr_canvas *canvas, const tr_view *view);
void __wrap_tr_draw_biaxial(tr_canvas *canvas, const tr_view *view) {
    char text[TR_INSET_NUMBERS];
    assert_true(n_shown < FRAMES);
    tr_frame_inset_numbers(view, TR_EN, text);
    shown[n_shown].open = !strcmp(text, "open");
    shown[n_shown].time = view->time;
    radius[0] = view->world->disks.pos[4 * view->inset_a + 3],
    radius[1] = view->world->disks.pos[4 * view->inset_b + 3];
    if (!shown[n_shown].open) {
        shown[n_shown].law = number_after(text, "law "), shown[n_shown].exact = number_after(text, "exact ");
    }
    n_shown++;
    __real_tr_draw_biaxial(canvas, view);
}

static tr_scene read_case(const char *text) {
    tr_scene scene;
    tr_status st = {0};
    if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    return scene;
}

/* Row before or at this time. */
static int row_at(const table *t, double time) {
    int i = 0;
    while (i < t->n - 1 && t->row[i + 1][TIME] <= time * (1 + 1e-12)) i++;
    return i;
}

/* q of each row by the half-plane, with more elements than the inset has. */
static double *replayed(const table *t) {
    char text[600];
    tr_status st = {0};
    snprintf(text, sizeof text,
             "kind: patch\nmu: %g\nelements: 120\nbodies: {R1: %.17g, R2: %.17g, E: 800 MPa, nu: 0}\n"
             "path: %s/run/paths/most-mobilised.csv\n",
             mu, radius[0], radius[1], folder);
    tr_scene scene = read_case(text);
    if (!tr_path_read(&scene, &st)) fail_msg("%s", st.text);
    tr_inside *inside = tr_inside_new(&scene, &st);
    double *q = calloc((size_t)t->n, sizeof *q);
    assert_true(inside && tr_contact_steps(&scene) == t->n); /* a step for each row */
    for (int i = 0; i < t->n; i++) {
        tr_contact_state s;
        if (!tr_inside_step(inside, &s, &st)) fail_msg("%s", st.text);
        q[i] = s.q;
    }
    tr_inside_free(inside), tr_scene_free(&scene);
    return q;
}

static void printed_numbers(void **state) {
    (void)state;
    char dir[100];
    tr_run_report report;
    tr_status st = {0};
    tr_scene scene = read_case(
        "kind: biaxial\nsample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm, density: 2700 kg/m^3}\n"
        "contact: {k_n: 160 MPa, friction: dahlberg-alfredsson, mu: 0.5, E_star: 400 MPa, k_t: k_n, mu_r: 0}\n"
        "compaction: {pressure: 160 kPa, mu: 0}\n"
        "shear: {lateral_pressure: 160 kPa, inertial_number: 3e-3, strain_end: 0.05}\n"
        "output: {frames: 20, rows: 3, curves: no, color: slip, paths: [most-mobilised]}\n");
    snprintf(dir, sizeof dir, "%s/run", folder);
    if (!tr_run(&scene, &(tr_run_options){.dir = dir, .force = true}, &report, &st)) fail_msg("%s", st.text);
    tr_scene_free(&scene);
    static const char *const columns[] = {"u_slide_m", "u_roll_m", "P_N_per_m", "time_s", "Q_N_per_m"};
    table t = table_read(dir, "paths/most-mobilised.csv", columns, COLUMNS);
    double *q = replayed(&t), differ = 0;
    int closed = 0;
    assert_int_equal(n_shown, 20);
    for (int k = 0; k < n_shown; k++) {
        int i = row_at(&t, shown[k].time), j = i < t.n - 1 ? i + 1 : i;
        const double *r = t.row[i], *next = t.row[j];
        assert_int_equal(shown[k].open, r[FORCE] == 0);
        if (shown[k].open || next[FORCE] == 0) continue;
        double law = r[FRICTION] / (mu * r[FORCE]), after = next[FRICTION] / (mu * next[FORCE]);
        print_message("%.4f s: law %5.2f (path %.4f to %.4f), exact %5.2f (replay %.4f to %.4f)\n", shown[k].time,
                      shown[k].law, law, after, shown[k].exact, q[i], q[j]);
        /* Between two rows, to half of the last digit. */
        assert_true(shown[k].law >= fmin(law, after) - 0.0051 && shown[k].law <= fmax(law, after) + 0.0051);
        /* The inset is behind by 1/20 of Cattaneo's sliding at most, 0.05/Lambda = 0.014 of q; it has half as many
         * elements: 1/60. */
        assert_true(shown[k].exact >= fmin(q[i], q[j]) - 0.03 && shown[k].exact <= fmax(q[i], q[j]) + 0.03);
        differ = fmax(differ, fabs(shown[k].law - shown[k].exact));
        closed++;
    }
    assert_true(closed > 10);
    assert_true(differ > 0.05); /* the two numbers are told apart */
    free(q), free(t.row);
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

static int open_folder(void **state) {
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int close_folder(void **state) {
    char command[100];
    (void)state;
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(printed_numbers)};
    return cmocka_run_group_tests_name("inset_numbers", tests, open_folder, close_folder);
}
