/* SPDX-License-Identifier: MIT */
/* output.paths: what is recorded against closed forms and against every step of the same run; what its replay in
 * kind: contact gives; which names are contacts. */
#include "assert_close.h"
#include "core/biaxial.h"
#include "core/bodies.h"
#include "core/paths.h"
#include "core/step.h"
#include "laws/law.h"
#include "scene/write.h"
#include "study/contact.h"
#include "study/inside.h"
#include "study/path.h"
#include "study/recorder.h"
#include "study/run.h"
#include "study/table.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/trundle-record-XXXXXX";

/* ---- a table */

enum { SLIDE, ROLL, FORCE, TIME, FRICTION, COLUMNS };

static table read_columns(const char *run, const char *name, const char *const columns[], int n) {
    char dir[200];
    snprintf(dir, sizeof dir, "%s/%s", folder, run);
    return table_read(dir, name, columns, n);
}

static table read_path(const char *run, const char *name) {
    static const char *const columns[] = {"u_slide_m", "u_roll_m", "P_N_per_m", "time_s", "Q_N_per_m"};
    return read_columns(run, name, columns, COLUMNS);
}

/* ---- runs */

static tr_scene read_case(const char *text) {
    tr_scene scene;
    tr_status st = {0};
    if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    return scene;
}

/* Results in folder/name. */
static tr_run_report run_case(const char *text, const char *name) {
    char dir[100];
    tr_scene scene = read_case(text);
    tr_run_report report;
    tr_status st = {0};
    snprintf(dir, sizeof dir, "%s/%s", folder, name);
    if (!tr_run(&scene, &(tr_run_options){.dir = dir, .force = true}, &report, &st)) fail_msg("%s", st.text);
    tr_scene_free(&scene);
    return report;
}

/* ---- closed forms */

/* Two turning disks whose centres stand still. */
static void turning(void **state) {
    (void)state;
    run_case("kind: bodies\ntime_end: 1\ncontact: {k_n: 1 MPa, mu: 0.3, mu_r: 0}\nstep: {dt: 1e-4}\n"
             "disks:\n  - {radius: 0.01, x: 0.0299, y: 0, spin: 0.7, motion: prescribed}\n"
             "  - {radius: 0.02, x: 0, y: 0, spin: -0.2, motion: prescribed}\n"
             "output: {frames: 0, paths: 1-0}\n",
             "turning");
    table t = read_path("turning", "paths/0-1.csv");
    const double L = 0.0299, P = 1e6 * 1e-4, dt = 1e-4;
    const double v_slide = L / 3 * 0.7 - 2 * L / 3 * 0.2, v_roll = -0.5 * (0.01 * 0.7 + 0.02 * 0.2);
    assert_true(t.n > 500 && t.n < 5000); /* 1/500 of a range, and less while it grows: 500 (1 + ln(10001/500)) rows */
    assert_close(t.row[0][TIME], dt, 1e-15, 0);
    assert_close(t.row[t.n - 1][TIME], 1 + dt, 1e-12, 0);
    for (int i = 0; i < t.n; i++) {
        const double *r = t.row[i], time = r[TIME] - dt;
        assert_close(r[SLIDE], v_slide * time, 1e-11, 1e-18); /* 10,000 roundings */
        assert_close(r[ROLL], v_roll * time, 1e-11, 1e-18);
        assert_close(r[FORCE], P, 1e-11, 0); /* an overlap of 1e-4 from lengths of 0.03 */
        assert_close(r[FRICTION], fmin(0.5e6 * v_slide * time, 0.3 * P), 1e-11, 1e-12);
    }
    free(t.row);
}

/* A disk with velocity v passes over another, h above its centre: int Vs dt = h asinh(x/h), and the branch turns by
 * atan(x/h). A step is as good as the velocity at its end. */
static void passing(void **state) {
    (void)state;
    run_case("kind: bodies\ntime_end: 1\ncontact: {k_n: 1 MPa, damping_ratio: 0, friction: none, rolling: none}\n"
             "step: {dt: 1e-5}\n"
             "disks:\n  - {radius: 0.01, x: 0, y: 0, motion: prescribed}\n"
             "  - {radius: 0.02, x: -0.01, y: 0.0295, vx: 0.02, motion: prescribed}\n"
             "output: {frames: 0, paths: [0-1]}\n",
             "passing");
    table t = read_path("passing", "paths/0-1.csv");
    const double h = 0.0295, L = 0.03, v = 0.02, dt = 1e-5, x_in = -sqrt(L * L - h * h);
    int changes = 0;
    for (int i = 0; i < t.n; i++) {
        const double *r = t.row[i], x = -0.01 + v * (r[TIME] - dt), in = fmin(fmax(x, x_in), -x_in);
        assert_close(r[FORCE], 1e6 * fmax(0, L - hypot(x, h)), 1e-10, 1e-8);
        assert_close(r[SLIDE], h * (asinh(in / h) - asinh(x_in / h)), 0, 1.5 * v * dt);
        assert_close(r[ROLL], 0.005 * (atan(in / h) - atan(x_in / h)), 0, 1.5 * 0.005 * v / h * dt);
        if (i == 0 || (r[FORCE] > 0) == (t.row[i - 1][FORCE] > 0)) continue;
        changes++;
        assert_close(r[TIME] - t.row[i - 1][TIME], dt, 1e-9, 0); /* both sides of a change are rows */
    }
    assert_int_equal(changes, 2);
    free(t.row);
}

/* Episodes on a floor: y'' = -g - (k/m) y takes (2/w)(pi - atan(v w/g)) from touch to leave, w^2 = k/m. */
static void bouncing(void **state) {
    (void)state;
    run_case("kind: bodies\ntime_end: 0.2\ngravity: {y: -9.81}\n"
             "contact: {k_n: 1 MPa, damping_ratio: 0, friction: none, rolling: none}\nstep: {dt: 2e-6}\n"
             "disks: [{radius: 0.01, density: 2700, x: 0, y: 0.011, vx: 0.1, spin: 3}]\n"
             "walls: [{nx: 0, ny: 1}]\noutput: {frames: 0, paths: [wall0-0]}\n",
             "bouncing");
    table t = read_path("bouncing", "paths/wall0-0.csv");
    const double m = 2700 * M_PI * 1e-4, w = sqrt(1e6 / m), v = sqrt(2 * 9.81 * 0.001);
    const double touch = 2 / w * (M_PI - atan(v * w / 9.81)), dt = 2e-6;
    const double v_slide = 0.1 + 0.01 * 3, v_roll = -0.5 * (0.1 - 0.01 * 3);
    int episodes = 0;
    for (int i = 1; i < t.n; i++) {
        const double *r = t.row[i], *before = t.row[i - 1];
        if (before[FORCE] > 0 && r[FORCE] == 0) episodes++;
        if (r[FORCE] > 0) continue;
        double tolerance = 2 * episodes * dt; /* touch and leave fall between steps */
        assert_close(r[SLIDE], episodes * v_slide * touch, 0, tolerance * v_slide);
        assert_close(r[ROLL], episodes * v_roll * touch, 0, tolerance * -v_roll);
        if (before[FORCE] == 0) assert_close(r[SLIDE], before[SLIDE], 0, 0);
    }
    /* the first fall takes v/g; then a bounce and a flight of 2 v/g each */
    assert_int_equal(episodes, (int)((0.2 - v / 9.81 - touch) / (2 * v / 9.81 + touch)) + 1);
    free(t.row);
}

/* A force that jumps for one step and is back at the next is in the file, fed by hand. */
static void spike(void **state) {
    (void)state;
    tr_scene scene = read_case("kind: bodies\ntime_end: 1\ncontact: {k_n: 1 MPa, friction: none, rolling: none}\n"
                               "disks: [{radius: 1, x: 0, y: 0}, {radius: 1, x: 3, y: 0}]\noutput: {paths: 0-1}\n");
    tr_bodies b;
    tr_run_report report = {0};
    tr_status st = {0};
    tr_recorder *r = calloc(1, sizeof *r);
    if (!tr_bodies_init(&b, &scene, &st) ||
        !tr_recorder_open(r, &(tr_recording){&scene, &b.world, folder, "", {0}, 0, false}, &report, &st))
        fail_msg("%s", st.text);
    for (int k = 1; k <= 9; k++) {
        r->paths.now[0].P = k == 5 ? 150 : 100;
        assert_true(tr_recorder_step(r, &st));
    }
    tr_recorder_close(r, &st);
    assert_int_equal(st.code, TR_OK);
    table t = read_path(".", "paths/0-1.csv");
    const double at[] = {1, 4, 5, 6, 9}, force[] = {100, 100, 150, 100, 100}; /* both sides of both jumps, the ends */
    assert_int_equal(t.n, 5);
    for (int i = 0; i < t.n; i++) {
        assert_close(t.row[i][TIME], at[i] * b.world.dt, 1e-15, 0);
        assert_close(t.row[i][FORCE], force[i], 0, 0);
    }
    free(t.row), free(r), tr_bodies_free(&b), tr_scene_free(&scene);
}

/* ---- a small biaxial test */

#define SPRING "friction: coulomb-spring, mu: 0.4, k_t: 80 MPa"
#define CREEP "friction: dahlberg-alfredsson, mu: 0.4, k_t: 80 MPa, E_star: 200 MPa"
#define BED "friction: cattaneo-mindlin, mu: 0.4"
#define BIAXIAL(friction)                                                                                              \
    "kind: biaxial\nseed: 3\nsample: {disks: 30, r_min: 0.76 mm, r_max: 1.52 mm}\n"                                    \
    "contact: {k_n: 160 MPa, rolling: none, " friction "}\n"                                                           \
    "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"                                        \
    "shear: {inertial_number: 1e-3, strain_end: 0.03}\n"

/* The contact that most-mobilised stood for, from the note of the run. */
static tr_contact_id most_of(const tr_run_report *report) {
    tr_contact_id pick = {0};
    for (int i = 0; i < report->n_notes; i++) sscanf(report->note[i], "most-mobilised is %d-%d", &pick.a, &pick.b);
    assert_true(pick.a < pick.b);
    return pick;
}

/* Every step of the same run against the straight lines between the rows of the file: 2/500 of each range. */
static void compare_with_every_step(const char *text, tr_contact_id pick, const table *t, double radius[2]) {
    tr_scene scene = read_case(text);
    tr_biaxial b;
    tr_paths paths = {.contacts = {1, {pick}}};
    tr_status st = {0};
    bool done = false, ok = tr_biaxial_init(&b, &scene, &st);
    double unbalanced, low[COLUMNS] = {0}, high[COLUMNS] = {0}, worst[COLUMNS] = {0};
    while (ok && !done) ok = tr_biaxial_compact(&b, 200, &unbalanced, &done, &st);
    if (!ok || !tr_biaxial_begin_shear(&b, &st)) fail_msg("%s", st.text);
    tr_paths_attach(&b.world, &paths);
    int changes = 0, i = 1;
    for (int64_t k = 0; k <= b.shear_steps; k++) {
        if (!tr_biaxial_forces(&b, &st)) fail_msg("%s", st.text);
        tr_path_point p = tr_paths_take(&paths, 0);
        double now[COLUMNS] = {p.u_slide, p.u_roll, p.P, (double)(k + 1) * b.world.dt, p.Q};
        while (i < t->n - 1 && t->row[i][TIME] < now[TIME] * (1 - 1e-14)) i++;
        const double *from = t->row[i - 1], *to = t->row[i];
        double part = (now[TIME] - from[TIME]) / (to[TIME] - from[TIME]);
        for (int c = 0; c < COLUMNS; c++) {
            low[c] = fmin(low[c], now[c]), high[c] = fmax(high[c], now[c]);
            worst[c] = fmax(worst[c], fabs(from[c] + part * (to[c] - from[c]) - now[c]));
        }
        if (k < b.shear_steps) tr_step_advance(&b.world);
    }
    for (int k = 1; k < t->n; k++) changes += (t->row[k][FORCE] > 0) != (t->row[k - 1][FORCE] > 0);
    for (int c = 0; c < COLUMNS; c++)
        if (c != TIME) {
            print_message("column %d: worst %.2e of range\n", c, worst[c] / (high[c] - low[c]));
            assert_true(worst[c] <= 2.0 / 500 * (high[c] - low[c]));
        }
    print_message("%d rows for %lld steps, %d changes between open and closed\n", t->n, (long long)b.shear_steps,
                  changes);
    assert_true(t->n < b.shear_steps);
    radius[0] = b.world.disks.pos[4 * pick.a + 3], radius[1] = b.world.disks.pos[4 * pick.b + 3];
    tr_biaxial_free(&b), tr_scene_free(&scene);
}

/* Largest |Q - recorded| at the rows, over max |Q| + mu max P. */
static double replay(const char *run, const char *file, const char *friction, const double radius[2], const table *t) {
    char text[900];
    tr_status st = {0};
    snprintf(text, sizeof text,
             "kind: contact\nbodies: {R1: %.17g, R2: %.17g, E: 1 GPa, nu: 0}\n"
             "laws: [{normal: linear, k_n: 160 MPa, %s}]\npath: %s/%s/%s\n",
             radius[0], radius[1], friction, folder, run, file);
    tr_scene scene = read_case(text);
    if (!tr_path_read(&scene, &st)) fail_msg("%s", st.text);
    tr_contact *c = tr_contact_new(&scene, &st);
    assert_int_equal(tr_contact_steps(&scene), t->n);
    double worst = 0, Q_max = 0, P_max = 0;
    for (int i = 0; i < t->n; i++) {
        tr_contact_state s;
        if (!tr_contact_step(c, &s, &st)) fail_msg("%s", st.text);
        worst = fmax(worst, fabs(s.Q - t->row[i][FRICTION]));
        Q_max = fmax(Q_max, fabs(t->row[i][FRICTION])), P_max = fmax(P_max, t->row[i][FORCE]);
    }
    assert_true(Q_max > 0);
    tr_contact_free(c), tr_scene_free(&scene);
    return worst / (Q_max + 0.4 * P_max);
}

/* Half the creepage of full slip, over some relaxation lengths: the rows are some 1500 of 10,000 steps, the law is of
 * first order in them. A spring on the same path is far off. */
static void replay_steady_creep(void **state) {
    (void)state;
    run_case("kind: bodies\ntime_end: 1\ncontact: {k_n: 1 MPa, rolling: none, " CREEP "}\nstep: {dt: 1e-4}\n"
             "disks:\n  - {radius: 0.01, x: 0, y: 0, spin: -0.1, motion: prescribed}\n"
             "  - {radius: 0.02, x: 0.0299, y: 0, spin: 0.0501, motion: prescribed}\n"
             "output: {frames: 0, paths: 0-1}\n",
             "steady");
    const char *file = "paths/0-1.csv";
    const double radius[2] = {0.01, 0.02};
    table t = read_path("steady", file);
    double error = replay("steady", file, CREEP, radius, &t), spring = replay("steady", file, SPRING, radius, &t);
    print_message("%d rows: replay within %.2e of max |Q| + mu max P, with a spring %.2e\n", t.n, error, spring);
    assert_true(error <= 2.0 / 500);
    assert_true(spring > 0.05);
    free(t.row);
}

/* kind: patch takes the same file, slide and all: it ends rolling steadily, q = 1 - (1 - xi/F0)^2 by Carter, xi =
 * 2e-6/1e-3 (less the overlap, 0.3 %), F0 = mu a/R. 60 elements are good to some percent. */
static void inside_of_a_recorded_path(void **state) {
    (void)state;
    char text[500];
    tr_status st = {0};
    snprintf(text, sizeof text,
             "kind: patch\nmu: 0.4\nelements: 60\nbodies: {R1: 10 mm, R2: 20 mm, E: 400 MPa, nu: 0}\n"
             "path: %s/steady/paths/0-1.csv\n",
             folder);
    tr_scene scene = read_case(text);
    if (!tr_path_read(&scene, &st)) fail_msg("%s", st.text);
    tr_inside *inside = tr_inside_new(&scene, &st);
    tr_contact_state s = {0};
    for (int64_t k = tr_contact_steps(&scene); k > 0; k--)
        if (!tr_inside_step(inside, &s, &st)) fail_msg("%s", st.text);
    const double R = 0.02 / 3, a = sqrt(4 * 100 * R / (M_PI * 200e6)), F0 = 0.4 * a / R;
    assert_close(s.q, 1 - pow(1 - 2e-3 / F0, 2), 0, 0.03);
    tr_inside_free(inside), tr_scene_free(&scene);
}

static void biaxial(const char *plain, const char *recorded, const char *friction, const char *other_law,
                    double tolerance) {
    tr_run_report report = run_case(recorded, "recorded");
    tr_contact_id most = most_of(&report);
    table t = read_path("recorded", "paths/most-mobilised.csv");
    double radius[2];
    compare_with_every_step(plain, most, &t, radius);
    double error = replay("recorded", "paths/most-mobilised.csv", friction, radius, &t);
    print_message("%s: replay within %.2e of max |Q| + mu max P\n", friction, error);
    assert_true(error <= tolerance);
    double other = replay("recorded", "paths/most-mobilised.csv", other_law, radius, &t);
    print_message("%s: %.2e\n", other_law, other);
    assert_true(other > tolerance); /* the path tells the laws apart */
    free(t.row);
}

#define RECORD "output: {frames: 0, rows: 20, paths: [most-mobilised, 0-1, wall1-2]}\n"

static void replay_spring(void **state) {
    (void)state;
    biaxial(BIAXIAL(SPRING), BIAXIAL(SPRING) RECORD, SPRING, CREEP, 2.0 / 500);
}

static void replay_creep(void **state) {
    (void)state;
    biaxial(BIAXIAL(CREEP), BIAXIAL(CREEP) RECORD, CREEP, SPRING, 2.0 / 500);
}

/* P of the file is without the dashpot here: with it the bed would be squeezed by another way, and Q off by 0.02. */
static void replay_bed(void **state) {
    (void)state;
    biaxial(BIAXIAL(BED), BIAXIAL(BED) RECORD, BED, SPRING, 2.0 / 500);
}

static void most_mobilised_is_the_largest(void **state) {
    (void)state;
    static const char *const columns[] = {"a", "b", "mobilisation"};
    tr_run_report report = run_case(BIAXIAL(CREEP) RECORD, "most");
    tr_contact_id most = most_of(&report);
    table t = read_columns("most", "contacts.csv", columns, 3); /* at the end of the run */
    double largest = 0, its = -1;
    for (int i = 0; i < t.n; i++) {
        largest = fmax(largest, t.row[i][2]);
        if (t.row[i][0] == most.a && t.row[i][1] == most.b) its = t.row[i][2];
    }
    assert_true(largest > 0);
    assert_close(its, largest, 0, 0);
    free(t.row);
}

static void recording_changes_nothing(void **state) {
    (void)state;
    char command[200];
    run_case(BIAXIAL(CREEP) "output: {frames: 2, rows: 20, paths: [most-mobilised, 0-1]}\n",
             "with"); /* with an inset */
    run_case(BIAXIAL(CREEP) "output: {frames: 0, rows: 20}\n", "without");
    snprintf(command, sizeof command, "cd %s && cmp with/history.csv without/history.csv && test ! -e without/paths",
             folder);
    assert_int_equal(system(command), 0);
    run_case(BIAXIAL(SPRING) "output: {frames: 0, rows: 20}\n", "with");
    snprintf(command, sizeof command, "test ! -e %s/with/paths", folder); /* those of the run before are gone */
    assert_int_equal(system(command), 0);
}

/* ---- names */

#define BODIES(paths)                                                                                                  \
    "kind: bodies\ntime_end: 1\ncontact: {k_n: 1 MPa, mu: 0, rolling: none}\n"                                         \
    "disks: [{radius: 1, x: 0, y: 0}, {radius: 1, x: 3, y: 0}]\nwalls: [{nx: 0, ny: 1}]\noutput: {paths: " paths "}\n"

static void names(void **state) {
    (void)state;
    tr_scene a = read_case(BODIES("[1-0, wall0-1, most-mobilised]"));
    const tr_contact_ids *p = &a.output.paths;
    assert_int_equal(p->n, 3);
    assert_true(p->item[0].a == 0 && p->item[0].b == 1 && p->item[1].a == -1 && p->item[1].b == 1);
    assert_true(p->item[2].a == p->item[2].b);
    tr_status st = {0};
    char *text = tr_scene_write(&a, tr_laws_catalog(), &st);
    assert_non_null(strstr(text, "\n  paths: [0-1, wall0-1, most-mobilised] "));
    tr_scene b = read_case(text);
    assert_memory_equal(p, &b.output.paths, sizeof *p);
    free(text), tr_scene_free(&a), tr_scene_free(&b);
    static const struct {
        const char *text, *message;
    } bad[] = {
        {BODIES("[0-1, 1-2]"), "a.yaml:6:23: error: there is no contact `1-2`: disks count from 0 to 1, walls are 1\n"},
        {BODIES("wall1-0"), "a.yaml:6:17: error: there is no contact `wall1-0`: "},
        {BODIES("[0-1, 1-0]"), "a.yaml:6:23: error: `1-0` is given twice\n"},
        {BODIES("[0-0]"), "a.yaml:6:18: error: `0-0` is no contact; name it 17-42 (disks 17 and 42), wall0-3 "},
        {BODIES("0-1x"), "a.yaml:6:17: error: `0-1x` is no contact; "},
        {BODIES("wall-1"), "a.yaml:6:17: error: `wall-1` is no contact; "},
        {BODIES("[0-99999999999]"), "a.yaml:6:18: error: `0-99999999999` is no contact; "},
        {BODIES("{a: 1}"), "a.yaml:6:17: error: this is no contact; "},
        {BODIES("[[0-1]]"), "a.yaml:6:18: error: this is no contact; "},
        {BODIES("[0-1, 0-2, 0-3, 0-4, 0-5, 0-6, 0-7, 0-8, 0-9, 1-2, 1-3, 1-4, 1-5, 1-6, 1-7, 1-8, 1-9]"),
         "a.yaml:6:98: error: more than 16 contacts in `paths`\n"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        tr_scene s;
        st = (tr_status){0};
        assert_false(tr_scene_read(&s, &(tr_scene_source){"a.yaml", bad[i].text, strlen(bad[i].text), NULL, 0},
                                   tr_laws_catalog(), &st));
        assert_int_equal(st.code, TR_BAD_CASE);
        if (strncmp(st.text, bad[i].message, strlen(bad[i].message)))
            fail_msg("%s\nis not\n%s", st.text, bad[i].message);
    }
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

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(turning),
                                       cmocka_unit_test(passing),
                                       cmocka_unit_test(bouncing),
                                       cmocka_unit_test(replay_spring),
                                       cmocka_unit_test(spike),
                                       cmocka_unit_test(replay_creep),
                                       cmocka_unit_test(replay_bed),
                                       cmocka_unit_test(replay_steady_creep),
                                       cmocka_unit_test(inside_of_a_recorded_path),
                                       cmocka_unit_test(most_mobilised_is_the_largest),
                                       cmocka_unit_test(recording_changes_nothing),
                                       cmocka_unit_test(names)};
    return cmocka_run_group_tests_name("record_path", tests, open_folder, close_folder);
}
