/* SPDX-License-Identifier: MIT */
/* Sweeps: which points there are and in which order, ranges against their closed forms, names that a file system takes,
 * Student's quantiles against printed tables, closed forms and the integral of the density, means and paired
 * differences by hand, and the whole message of each mistake. */
#include "assert_close.h"
#include "base/student.h"
#include "base/version.h"
#include "laws/law.h"
#include "out/dir.h"
#include "scene/write.h"
#include "study/sweep.h"
#include "study/sweep_collect.h"
#include "study/sweep_read.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/test_sweep_XXXXXX";

static const char base_case[] = "kind: biaxial\n"
                                "sample: {disks: 12, r_min: 1 mm, r_max: 2 mm}\n"
                                "contact: {k_n: 1 MPa, mu: 0.5, mu_r: 0.1}\n"
                                "compaction: {pressure: 1 kPa}\n"
                                "output: {frames: 0}\n";

static const char bodies_case[] = "kind: bodies\n"
                                  "time_end: 1 ms\n"
                                  "contact: {k_n: 1 MPa, mu: 0.5, mu_r: 0.1}\n"
                                  "disks: [{radius: 10 mm, x: 0, y: 20 mm, vx: 1 m/s}]\n"
                                  "walls: [{nx: 0, ny: 1}]\n"
                                  "checks: [{what: speed, disk: 0, exact: 1 m/s, tolerance: 1e-9 m/s}]\n";

#define HEAD "kind: sweep\nbase: base.yaml\n"

static const char *write_file(const char *name, const char *text) {
    static char path[TR_PATH];
    tr_status st = {0};
    assert_true(tr_file_write(folder, name, text, &st));
    assert_true(tr_dir_path(path, folder, name, &st));
    return path;
}

static tr_grid read_ok(const char *text) {
    tr_grid g;
    tr_status st = {0};
    if (!tr_grid_read(&g, write_file("sweep.yaml", text), false, &st)) fail_msg("%s", st.text);
    return g;
}

static void assert_point(const tr_grid *g, int point, const char *name, const char *sets) {
    char is[TR_POINT_NAME], joined[1000] = "";
    tr_status st = {0};
    tr_grid_name(g, point, is);
    assert_string_equal(is, name);
    char **text = tr_grid_sets(g, point, &st);
    for (int i = 0; i < g->n_axes; i++) strcat(strcat(joined, text[i]), " ");
    assert_string_equal(joined, sets);
    tr_grid_sets_free(g, text);
}

/* Seeds are slowest, then the keys in the order of the file. */
static void points(void **state) {
    (void)state;
    tr_grid g = read_ok(HEAD "seeds: [3, 1]\nset: {sample.disks: 10}\n"
                             "vary: {contact.mu_r: [0, 0.2, 0.5], contact.rolling_velocity: [wang, bagi-kuhn]}\n");
    assert_int_equal(g.n, 12);
#define SETS(mu_r, velocity, seed)                                                                                     \
    "contact.mu_r=" mu_r " contact.rolling_velocity=" velocity " seed=" seed " sample.disks=10 "
    assert_point(&g, 0, "mu_r=0,rolling_velocity=wang,seed=3", SETS("0", "wang", "3"));
    assert_point(&g, 1, "mu_r=0,rolling_velocity=bagi-kuhn,seed=3", SETS("0", "bagi-kuhn", "3"));
    assert_point(&g, 5, "mu_r=0.5,rolling_velocity=bagi-kuhn,seed=3", SETS("0.5", "bagi-kuhn", "3"));
    assert_point(&g, 6, "mu_r=0,rolling_velocity=wang,seed=1", SETS("0", "wang", "1"));
    assert_point(&g, 9, "mu_r=0.2,rolling_velocity=bagi-kuhn,seed=1", SETS("0.2", "bagi-kuhn", "1"));
    for (int i = 0; i < g.n; i++) { /* every point is a case with its own values */
        tr_scene scene;
        tr_status st = {0};
        if (!tr_grid_scene(&g, i, &scene, &st)) fail_msg("%s", st.text);
        assert_int_equal(scene.seed, i < 6 ? 3 : 1);
        assert_int_equal(scene.sample.disks, 10);
        assert_int_equal(scene.contact.rolling_velocity, i % 2);
        const double mu_r[] = {0, 0.2, 0.5};
        assert_true(scene.contact.rolling.par[0] == mu_r[i / 2 % 3]); /* the first parameter of wang-spring */
        tr_scene_free(&scene);
    }
    tr_grid_free(&g);
    g = read_ok(HEAD "vary: {contact.mu_r: [0, 1]}\n"); /* no seeds: that of the base case */
    assert_int_equal(g.n, 2);
    assert_point(&g, 1, "mu_r=1", "contact.mu_r=1 ");
    tr_grid_free(&g);
    g = read_ok(HEAD "seeds: 18446744073709551613-18446744073709551615\n"); /* to the largest, which has no next */
    assert_int_equal(g.n, 3);
    assert_point(&g, 2, "seed=18446744073709551615", "seed=18446744073709551615 ");
    tr_grid_free(&g);
}

static void ranges(void **state) {
    (void)state;
    tr_grid g = read_ok(HEAD "vary:\n"
                             "  shear.inertial_number: {from: 1e-4, to: 1e-2, points: 5, scale: log}\n"
                             "  contact.mu_r: {from: 0, to: 1.2, points: 5}\n"
                             "  compaction.pressure: {from: 100 kPa, to: 200 kPa, points: 3, scale: lin}\n");
    assert_int_equal(g.n, 75);
    for (int i = 0; i < 5; i++) {
        /* six digits are written */
        assert_close(strtod(g.axis[0].value[i], NULL), pow(10, -4 + 0.5 * i), 5e-6, 0);
        assert_close(strtod(g.axis[1].value[i], NULL), 0.3 * i, 5e-6, 0);
    }
    assert_string_equal(g.axis[0].value[0], "1e-4"); /* ends as they are given */
    assert_string_equal(g.axis[0].value[4], "1e-2");
    assert_string_equal(g.axis[1].value[3], "0.9"); /* not 0.90000000000000002 */
    assert_string_equal(g.axis[2].value[1], "150 kPa");
    tr_grid_free(&g);
}

/* Names are told apart, and are those of files, whatever the values. */
static void names(void **state) {
    (void)state;
    char a[TR_POINT_NAME], b[TR_POINT_NAME];
    tr_grid g = read_ok(HEAD "vary: {shear.inertial_number: [1, 2], compaction.inertial_number: [3, 4]}\n");
    tr_grid_name(&g, 1, a);
    assert_string_equal(a, "shear.inertial_number=1,compaction.inertial_number=4");
    tr_grid_free(&g);
    g = read_ok(HEAD "vary: {contact.k_n: [1/2 MPa, 1*2 MPa, ../../x, \"\\u00b5\"]}\n");
    tr_grid_name(&g, 0, a);
    tr_grid_name(&g, 1, b);
    assert_memory_equal(a, "k_n=1_2_MPa-", 12);
    assert_memory_equal(b, "k_n=1_2_MPa-", 12);
    assert_string_not_equal(a, b);
    tr_grid_name(&g, 2, a);
    assert_null(strchr(a, '/'));
    tr_grid_name(&g, 3, a);
    assert_memory_equal(a, "k_n=__-", 7);
    tr_grid_free(&g);
    char text[1200], ones[400];
    memset(ones, '1', sizeof ones - 1);
    ones[sizeof ones - 1] = '\0';
    snprintf(text, sizeof text, HEAD "vary: {contact.mu: [%s, %s2]}\n", ones, ones);
    g = read_ok(text);
    tr_grid_name(&g, 0, a);
    tr_grid_name(&g, 1, b);
    assert_true(strlen(a) <= 255 && strlen(b) <= 255);
    assert_string_not_equal(a, b);
    tr_grid_free(&g);
}

/* P(|T| < t) by Simpson's rule over the density, of which the normalisation is by lgamma. */
static double within(double t, double n) {
    enum { HALVES = 2000 };
    double h = t / HALVES, sum = 0;
    double top = exp(lgamma((n + 1) / 2) - lgamma(n / 2)) / sqrt(n * M_PI);
    for (int i = 0; i <= HALVES; i++)
        sum += (i == 0 || i == HALVES ? 1 : i % 2 ? 4 : 2) * pow(1 + i * h * i * h / n, -(n + 1) / 2);
    return 2 * top * sum * h / 3;
}

static void student(void **state) {
    (void)state;
    static const struct {
        int n;
        double t;
    } table[] = {{1, 12.706}, {2, 4.303},  {3, 3.182},  {4, 2.776},  {5, 2.571},  {6, 2.447},
                 {7, 2.365},  {8, 2.306},  {9, 2.262},  {10, 2.228}, {11, 2.201}, {15, 2.131},
                 {20, 2.086}, {29, 2.045}, {30, 2.042}, {60, 2.000}, {120, 1.980}}; /* as textbooks print it */
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        assert_close(tr_student_95(table[i].n), table[i].t, 0, 0.00051); /* half of the last printed digit */
    /* Cauchy's distribution; and t/sqrt(2 + t^2) of two degrees of freedom. The slope of tan at 0.475 pi is 163:
     * rounding of pi and of 0.95 by 1e-16 gives 1e-14 */
    assert_close(tr_student_95(1), tan(0.475 * M_PI), 1e-13, 0);
    assert_close(tr_student_95(2), 0.95 * sqrt(2 / (1 - 0.95 * 0.95)), 1e-13, 0);
    for (int n = 3; n < 40; n++) assert_close(within(tr_student_95(n), n), 0.95, 1e-10, 0); /* Simpson: (t/2000)^4 */
    assert_close(tr_student_95(1000000), 1.959963985, 5e-6, 0); /* the normal quantile z, + (z^3 + z)/(4 n) */
}

static void means(void **state) {
    (void)state;
    const double x[] = {NAN, 1, 2, NAN, 4};
    tr_mean m = tr_mean_of(x, 5);
    assert_int_equal(m.n, 3);
    assert_close(m.mean, 7.0 / 3, 1e-15, 0);
    assert_close(m.error, sqrt(7) / 3, 1e-15, 0);                      /* s^2 = (16 + 1 + 25)/9/2 */
    assert_close(m.high - m.mean, 4.302652730 * sqrt(7) / 3, 1e-9, 0); /* t of 2, ten digits */
    assert_close(m.mean - m.low, m.high - m.mean, 1e-14, 0);
    m = tr_mean_of(x, 2);
    assert_true(m.n == 1 && m.mean == 1 && isnan(m.error) && isnan(m.low) && isnan(m.high));
    m = tr_mean_of(x, 1);
    assert_true(m.n == 0 && isnan(m.mean));
}

/* Leaves what a finished run of a point leaves. */
static void finish(const tr_grid *g, int point, const char *summary) {
    char name[TR_POINT_NAME], dir[TR_PATH];
    tr_scene scene;
    tr_status st = {0};
    tr_grid_name(g, point, name);
    assert_true(tr_dir_path(dir, folder, name, &st) && tr_dir_make(folder, name, &st));
    if (!tr_grid_scene(g, point, &scene, &st)) fail_msg("%s", st.text);
    char *text = tr_scene_write(&scene, tr_laws_catalog(), &st);
    assert_true(tr_file_write(dir, "case.yaml", text, &st) && tr_file_write(dir, "summary.json", summary, &st));
    free(text);
    tr_scene_free(&scene);
}

/* Two values of mu, two of mu_r, three seeds; x = 10 mu_r + seed, and with mu = 0.4: + 1, 2, 4 by seed. So the
 * differences are 1, 2, 4; where seed 2 is missing under mu = 0.5, mu_r = 1, they are 1, 4. */
static void collect(void **state) {
    (void)state;
    tr_grid g = read_ok(HEAD "seeds: 1-3\nvary: {contact.mu: [0.4, 0.5], contact.mu_r: [0, 1]}\n"
                             "compare: [{key: contact.mu, to: 0.5}, {key: contact.mu_r, to: 0}]\n"
                             "collect: [x, deep.1.y]\n");
    tr_status st = {0};
    char path[TR_PATH], line[300];
    int missing;
    for (int i = 0; i < g.n; i++) {
        int seed = i / 4 + 1, mu_r = i % 2;
        double more = i / 2 % 2 ? 0 : (double[]){1, 2, 4}[seed - 1];
        char summary[160];
        snprintf(summary, sizeof summary, "{\"version\": \"" TR_VERSION "\", \"x\": %g, \"deep\": [{}, {\"y\": null}]}",
                 10 * mu_r + seed + more);
        if (!(i == 7)) finish(&g, i, summary);
    }
    if (!tr_grid_collect(&g, folder, &missing, &st)) fail_msg("%s", st.text);
    assert_int_equal(missing, 1);
    assert_true(tr_dir_path(path, folder, "collect.csv", &st));
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    assert_string_equal(line, "contact.mu,contact.mu_r,quantity,minus,seeds,mean,standard_error,low_95,high_95\n");
    const double t3 = 4.302652730, t2 = 12.70620474; /* of two and of one degree of freedom */
    const struct {
        const char *key;
        double mean, error, t;
    } row[] = {
        {"0.4,0,x,,3,", 13.0 / 3, 1.452966315, t3}, /* 2 4 7: s^2 = 19/3, over 3 */
        {"0.4,1,x,,3,", 43.0 / 3, 1.452966315, t3}, /* 12 14 17 */
        {"0.5,0,x,,3,", 2, 0.577350269, t3},        /* 1 2 3 */
        {"0.5,1,x,,2,", 12, 1, t2},                 /* 11 13 */
        {"0.4,0,x,contact.mu=0.5,3,", 7.0 / 3, 0.881917104, t3},
        {"0.4,1,x,contact.mu=0.5,2,", 2.5, 1.5, t2},
        {"0.4,1,x,contact.mu_r=0,3,", 10, 0, t3}, /* none from itself */
        {"0.5,1,x,contact.mu_r=0,2,", 10, 0, t2},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        double v[4];
        assert_non_null(fgets(line, sizeof line, file));
        assert_memory_equal(line, row[i].key, strlen(row[i].key));
        assert_int_equal(sscanf(line + strlen(row[i].key), "%lf,%lf,%lf,%lf", &v[0], &v[1], &v[2], &v[3]), 4);
        /* ten digits here and there */
        assert_close(v[0], row[i].mean, 1e-9, 0);
        assert_close(v[1], row[i].error, 1e-9, 0);
        assert_close(v[2], row[i].mean - row[i].t * row[i].error, 1e-8, 0);
        assert_close(v[3], row[i].mean + row[i].t * row[i].error, 1e-8, 0);
        assert_non_null(fgets(line, sizeof line, file)); /* of the number that is null */
        assert_non_null(strstr(line, ",deep.1.y,"));
        assert_non_null(strstr(line, ",0,,,,\n"));
    }
    assert_null(fgets(line, sizeof line, file));
    fclose(file);
    assert_true(tr_dir_path(path, folder, "points.csv", &st));
    assert_non_null(file = fopen(path, "r"));
    static const char *const points[] = {"contact.mu,contact.mu_r,seed,x,deep.1.y\n",
                                         "0.4,0,1,2,\n",
                                         "0.4,1,1,12,\n",
                                         "0.5,0,1,1,\n",
                                         "0.5,1,1,11,\n",
                                         "0.4,0,2,4,\n",
                                         "0.4,1,2,14,\n",
                                         "0.5,0,2,2,\n"}; /* the one that is not finished has no row */
    for (int i = 0; i < 8; i++) {
        assert_non_null(fgets(line, sizeof line, file));
        assert_string_equal(line, points[i]);
    }
    fclose(file);
    tr_grid_free(&g);
}

static tr_point_state state_of(const tr_grid *g, int point) {
    tr_point_state is;
    tr_status st = {0};
    if (!tr_grid_state(g, point, folder, &is, &st)) fail_msg("%s", st.text);
    return is;
}

#define WHOLE "{\"version\": \"" TR_VERSION "\", \"sin_phi_peak\": 0.5}"

/* What counts as finished: a summary that is whole, of this version, with the numbers to collect, of this case. */
static void states(void **state) {
    (void)state;
    static const struct {
        const char *summary;
        tr_point_state is;
    } row[] = {
        {WHOLE, TR_POINT_FINISHED},
        {"", TR_POINT_BROKEN}, /* as a computer that loses its power may leave it */
        {"{\"version\": \"" TR_VERSION "\", \"sin_phi_p", TR_POINT_BROKEN},
        {"[]", TR_POINT_BROKEN},
        {"{\"sin_phi_peak\": 0.5}", TR_POINT_BROKEN},
        {"{\"version\": \"" TR_VERSION "0\", \"sin_phi_peak\": 0.5}", TR_POINT_OLD},
        {"{\"version\": \"" TR_VERSION "\", \"sin_phi\": 0.5}", TR_POINT_LACKING},
        {WHOLE "\n", TR_POINT_FINISHED},
    };
    tr_grid g = read_ok(HEAD "seeds: [77, 78]\ncollect: [sin_phi_peak]\n"), other;
    int missing;
    tr_status st = {0};
    assert_int_equal(state_of(&g, 0), TR_POINT_MISSING);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        finish(&g, 0, row[i].summary);
        if (state_of(&g, 0) != row[i].is) fail_msg("%s: %d, not %d", row[i].summary, state_of(&g, 0), row[i].is);
        if (!tr_grid_collect(&g, folder, &missing, &st)) fail_msg("%s: %s", row[i].summary, st.text);
        assert_int_equal(missing, row[i].is == TR_POINT_FINISHED ? 1 : 2);
    }
    assert_int_equal(state_of(&g, 1), TR_POINT_MISSING);
    tr_grid_free(&g);
    other = read_ok(HEAD "seeds: [77]\nset: {contact.mu: 0.4}\n"); /* the same directory, another case */
    assert_int_equal(state_of(&other, 0), TR_POINT_OTHER);
    tr_grid_free(&other);
}

static void bad(void **state) {
    (void)state;
    static const struct {
        const char *text, *message; /* behind "error: "; the place is checked by it */
    } rows[] = {
        {"kind: sweep\nseeds: 1-2\n", "1:1: error: `base` is missing: the case that is varied\nkind: sweep\n^"},
        {"kind: biaxial\n",
         "1:7: error: this is not a sweep, `kind: sweep`; trundle run runs a single case\nkind: biaxial\n      ^"},
        {HEAD, "1:1: error: nothing varies: give `vary` or `seeds`\nkind: sweep\n^"},
        {HEAD "seed: 1\n",
         "3:1: error: unknown key `seed` (did you mean `seeds`?); allowed here: kind, base, seeds, vary, set, "
         "compare, collect\nseed: 1\n^"},
        {HEAD "vary: {contact.mu: []}\n",
         "3:20: error: the list of `contact.mu` is empty\nvary: {contact.mu: []}\n                   ^"},
        {HEAD "seeds: []\n", "3:8: error: the list of `seeds` is empty\nseeds: []\n       ^"},
        {HEAD "vary: {contact.mu: [0.1, 0.2, 0.1]}\n",
         "3:31: error: `0.1` is given twice\nvary: {contact.mu: [0.1, 0.2, 0.1]}\n                              ^"},
        {HEAD "vary: {contact.mu: 0.1}\n",
         "3:20: error: give `contact.mu` a list, [0, 0.5], or a range, {from: 0, to: 1, points: "
         "5}; one value belongs to `set`\nvary: {contact.mu: 0.1}\n                   ^"},
        {HEAD "vary: {seed: [1, 2]}\n",
         "3:8: error: seeds cannot be compared: list them in `seeds`\nvary: {seed: [1, 2]}\n       ^"},
        {HEAD "seeds: 8-1\n",
         "3:8: error: a seed must be a whole number; for several write 1-8 or [1, 2, 5]\nseeds: 8-1\n       ^"},
        {HEAD "seeds: [-1]\n",
         "3:9: error: a seed must be a whole number; for several write 1-8 or [1, 2, 5]\nseeds: [-1]\n        ^"},
        {HEAD "seeds: 1-1000000\n", "3:1: error: 1000000 points; --yes allows more than 10000\nseeds: 1-1000000\n^"},
        {HEAD "seeds: 0-18446744073709551615\n",
         "3:8: error: 1.84467e+19 values, allowed is 1 to 1000000\nseeds: 0-18446744073709551615\n       ^"},
        {HEAD "vary: {contact.mu: {from: 0, to: 1, points: 3, scale: log}}\n",
         "3:55: error: a log range must not reach or cross 0\n"
         "vary: {contact.mu: {from: 0, to: 1, points: 3, scale: log}}\n"
         "                                                      ^"},
        {HEAD "vary: {contact.mu: {from: 0, to: 1, points: 1}}\n",
         "3:45: error: `points` must be a whole number, 2 or more\n"
         "vary: {contact.mu: {from: 0, to: 1, points: 1}}\n"
         "                                            ^"},
        {HEAD "vary: {contact.k_n: {from: 1 kPa, to: 1 MPa, points: 3}}\n",
         "3:39: error: `from` and `to` must have the same unit\n"
         "vary: {contact.k_n: {from: 1 kPa, to: 1 MPa, points: 3}}\n"
         "                                      ^"},
        {HEAD "vary: {contact.mu: [0, 1]}\nset: {contact.mu: 1}\n",
         "4:7: error: `contact.mu` is already varied in line 3\nset: {contact.mu: 1}\n      ^"},
        {HEAD "vary: {contact.mu: [0, 1]}\ncompare: {key: contact.mu_r, to: 1}\n",
         "4:16: error: `contact.mu_r` is not in `vary`\ncompare: {key: contact.mu_r, to: 1}\n               ^"},
        {HEAD "vary: {contact.mu: [0, 1]}\ncompare: {key: contact.mu, to: 2}\n",
         "4:32: error: `2` is not one of the values of `contact.mu`: write it as it is written there\ncompare: {key: "
         "contact.mu, to: 2}\n"
         "                               ^"},
        {HEAD "seeds: [1]\ncollect: []\n",
         "4:10: error: `collect` must be a list of numbers of summary.json\ncollect: []\n         ^"},
        {HEAD "vary: {contact.mu: [0, 1]}\ncompare: [{key: contact.mu, to: 1}, {key: contact.mu, to: 1}]\n",
         "4:37: error: this comparison is given twice"},
        {HEAD "seeds: [1]\ncollect: [e0, sin_phi_peak, e0]\n", "4:29: error: `e0` is given twice"},
        /* numbers that no run of this case will have */
        {HEAD "seeds: [5]\ncollect: [e0, sin_phi_paek]\n",
         "4:15: error: no number `sin_phi_paek` will be in the summary.json of point 0 (seed=5) (did you mean "
         "`sin_phi_peak`?); collect of: seed, n_disks, e0, "},
        {HEAD "seeds: [5]\ncollect: [version]\n", "4:11: error: no number `version` will be"}, /* a text */
        {HEAD "seeds: [5]\ncollect: [e0.]\n", "4:11: error: no number `e0.` will be"},
        {HEAD "seeds: [5]\ncollect: [checks.0.measured]\n", "4:11: error: no number `checks.0.measured` will be"},
        {HEAD "seeds: [5]\ncollect: [passes.a]\n", "4:11: error: no number `passes.a` will be"},
        {HEAD "seeds: [5]\nset: {output.energy: no}\ncollect: [energy_residual_over_work]\n",
         "5:11: error: no number `energy_residual_over_work` will be in the summary.json of point 0 (seed=5)"},
        {HEAD "seeds: [5]\nvary: {output.energy: [yes, no]}\ncollect: [energy_residual_over_work]\n",
         "5:11: error: no number `energy_residual_over_work` will be in the summary.json of point 1 "
         "(energy=no,seed=5)"},
        {"kind: sweep\nbase: bodies.yaml\nvary: {contact.mu: [0.1, 0.2]}\n",
         "1:1: error: no number `sin_phi_residual` will be in the summary.json of point 0 (mu=0.1); collect of: "},
        {"kind: sweep\nbase: bodies.yaml\nvary: {contact.mu: [0.1, 0.2]}\ncollect: [checks.1.measured]\n",
         "4:11: error: no number `checks.1.measured` will be in the summary.json of point 0 (mu=0.1) (did you mean "
         "`checks.0.measured`?); "},
        {"kind: sweep\nbase: bodies.yaml\nvary: {contact.mu: [0.1, 0.2]}\ncollect: [checks.zero.measured]\n",
         "4:11: error: no number `checks.zero.measured` will be"},
        /* one value under two spellings */
        {HEAD "vary: {contact.mu: [0.25, 0.5, 1/2]}\n",
         "3:32: error: `0.5` and `1/2` of `contact.mu` make the same case: give one of them\n"
         "vary: {contact.mu: [0.25, 0.5, 1/2]}\n                               ^"},
        {HEAD "vary: {contact.mu_r: [0, 1], contact.mu: [50e-2, 0.5]}\n",
         "3:50: error: `50e-2` and `0.5` of `contact.mu` make the same case"},
        {HEAD "vary: {sample.r_min: [1 mm, 0.5 mm, 0.001]}\n",
         "3:37: error: `1 mm` and `0.001` of `sample.r_min` make the same case"},
        {HEAD "vary: {contact.k_n: [1000 kPa, 2 MPa, 2e6 Pa]}\n",
         "3:39: error: `2 MPa` and `2e6 Pa` of `contact.k_n` make the same case"},
        {HEAD "vary: {contact.mu: [0.3, 0.1*3]}\n", /* which is 0.30000000000000004 */
         "3:26: error: `0.3` and `0.1*3` of `contact.mu` make the same case"},
        {HEAD "vary: {contact.mu: [0.1, 0.2]}\nset: {\"contact.mu \": 0.3}\n",
         "3:26: error: `0.1` and `0.2` of `contact.mu` make the same case"},
        {HEAD "seeds: [1, 01]\n", "3:12: error: `1` is given twice"},
        {HEAD "seeds: [1]\n---\nseeds: [1]\n", "4:1: error: a second document (---) is not allowed\n---\n^"},
        /* what reading the base case finds */
        {HEAD "seeds: [4]\nvary:\n  contact.mu_R: [1]\n",
         "5:3: error: point 0 (mu_R=1,seed=4) cannot run: unknown key `contact.mu_R` (did you mean `mu_r`?); allowed "
         "here: "
         "normal, friction, rolling, rolling_velocity, arms, k_n, damping_ratio,"},
        {HEAD "vary:\n  contact.mu_r: [0,\n    -1]\n",
         "5:5: error: point 1 (mu_r=-1) cannot run: `mu_r` is -1, allowed is 0 to"},
        {HEAD "seeds: 1-2\nset: {contact.k_n: 3 m}\n", "4:20: error: point 0 (seed=1) cannot run: "},
        {HEAD "vary: {contact.normal: [linear, hertz-sphere]}\n",
         "3:33: error: point 1 (normal=hertz-sphere) cannot run: "},
        {HEAD "vary: {step.dt: [1 us, 1 s]}\n", "3:24: error: point 1 (dt=1_s-"}, /* above the bound of stability */
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        tr_grid g;
        tr_status st = {0};
        bool ok = tr_grid_read(&g, write_file("bad.yaml", rows[i].text), false, &st);
        for (int point = 0; ok && point < g.n; point++) ok = tr_grid_check(&g, point, &st);
        if (ok) fail_msg("no error:\n%s", rows[i].text);
        assert_int_equal(st.code, TR_BAD_CASE);
        const char *message = strstr(st.text, "bad.yaml:");
        assert_non_null(message);
        if (strncmp(message + 9, rows[i].message, strlen(rows[i].message)) != 0)
            fail_msg("%s\nis not:\n%s", message + 9, rows[i].message);
        tr_grid_free(&g);
    }
}

/* Nearly equal is not equal; nor are values that matter only where another key has another value. */
static void values_that_differ_are_not_one(void **state) {
    (void)state;
    static const char *const text[] = {
        HEAD "vary: {contact.mu: [0.3, 0.3000000001]}\n",
        HEAD "vary: {contact.mu: [0.1, 0.2], contact.mu_r: [0.1, 0.2]}\n",
        HEAD "vary: {contact.rolling: [none, wang-spring], contact.rolling_velocity: [wang, bagi-kuhn]}\n",
        HEAD "vary: {sample.r_min: [1 mm, 0.1 mm, 0.01]}\n",
    };
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        tr_grid g = read_ok(text[i]);
        tr_grid_free(&g);
    }
}

static void shipped(void **state) {
    (void)state;
    tr_grid g;
    tr_status st = {0};
    if (!tr_grid_read(&g, "cases/sweep-quick.yaml", false, &st)) fail_msg("%s", st.text);
    for (int i = 0; i < g.n; i++)
        if (!tr_grid_check(&g, i, &st)) fail_msg("%s", st.text);
    tr_grid_free(&g);
}

static int set_up(void **state) {
    (void)state;
    if (!mkdtemp(folder)) return -1;
    write_file("base.yaml", base_case);
    write_file("bodies.yaml", bodies_case);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    char command[100];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points),  cmocka_unit_test(ranges),
        cmocka_unit_test(names),   cmocka_unit_test(student),
        cmocka_unit_test(means),   cmocka_unit_test(collect),
        cmocka_unit_test(states),  cmocka_unit_test(bad),
        cmocka_unit_test(shipped), cmocka_unit_test(values_that_differ_are_not_one),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
