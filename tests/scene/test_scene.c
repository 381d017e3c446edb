/* SPDX-License-Identifier: MIT */
/* Reading good cases, writing them back, overriding keys; and 4000 damaged cases, none of which may crash or hang. */
#include "assert_close.h"
#include "base/random.h"
#include "fake_catalog.h"
#include "laws/law.h"
#include "scene/what.h"
#include "scene/write.h"
#include <float.h>
#include <glob.h>
#include <stdlib.h>

static tr_scene read_ok(const char *text, const char *const *sets, int n_sets) {
    tr_scene scene;
    tr_status st;
    if (!fake_read(&scene, text, sets, n_sets, &st)) fail_msg("%s", st.text);
    return scene;
}

static tr_scene set_ok(const char *text, const char *set) {
    return read_ok(text, &set, 1);
}

static void biaxial(void **state) {
    (void)state;
    tr_scene s = read_ok(biaxial_case, NULL, 0);
    const fake_linear *linear = (const void *)s.contact.normal.par;
    const fake_spring *spring = (const void *)s.contact.friction.par;
    const fake_rolling *rolling = (const void *)s.contact.rolling.par;
    assert_int_equal(s.kind, TR_KIND_BIAXIAL);
    assert_int_equal(s.seed, 7);
    assert_int_equal(s.sample.disks, 400);
    assert_close(s.sample.r_min, 0.76e-3, 1e-15, 0);
    assert_close(s.sample.r_max, 1.52e-3, 1e-15, 0);
    assert_close(s.sample.density, 2700, 1e-15, 0);
    assert_int_equal(s.contact.normal.law, 0);
    assert_int_equal(s.contact.friction.law, 0);
    assert_int_equal(s.contact.rolling.law, 1);
    assert_int_equal(s.contact.rolling_velocity, 1);
    assert_close(linear->k_n, 160e6, 0, 0);
    assert_close(linear->damping_ratio, 0.3, 0, 0);
    assert_close(spring->mu, 0.5, 0, 0);
    assert_close(spring->k_t, 80e6, 0, 0);
    assert_close(rolling->mu_r, 0.5, 0, 0);
    assert_close(rolling->k_r, 80e6, 0, 0);
    assert_close(s.compaction.pressure, 160e3, 0, 0);
    assert_close(s.shear.inertial_number, 1e-3, 0, 0);
    assert_int_equal(s.output.frames, 20);
    assert_false(s.output.energy);
    tr_scene_free(&s);
}

static void defaults(void **state) {
    (void)state;
    tr_scene s =
        read_ok("kind: biaxial\nsample: {r_min: 1, r_max: 1}\ncontact: {k_n: 8}\ncompaction: {pressure: 5}\noutput:\n",
                NULL, 0);
    const fake_linear *linear = (const void *)s.contact.normal.par;
    const fake_spring *spring = (const void *)s.contact.friction.par;
    const fake_rolling *rolling = (const void *)s.contact.rolling.par;
    assert_int_equal(s.seed, 1);
    assert_int_equal(s.sample.disks, 400);
    assert_close(s.sample.density, 2700, 0, 0);
    assert_int_equal(s.contact.normal.law, 0);
    assert_int_equal(s.contact.friction.law, 0);
    assert_int_equal(s.contact.rolling.law, 1);
    assert_int_equal(s.contact.rolling_velocity, 0);
    assert_close(linear->damping_ratio, 0.3, 0, 0);
    assert_close(spring->mu, 0.5, 0, 0);
    assert_close(spring->k_t, 4, 0, 0);
    assert_close(rolling->mu_r, 0.5, 0, 0);
    assert_close(rolling->k_r, 4, 0, 0);
    assert_close(s.compaction.mu, 0, 0, 0);
    assert_close(s.compaction.inertial_number, 0.01, 0, 0);
    assert_close(s.compaction.unbalanced, 1e-4, 0, 0);
    assert_close(s.shear.lateral_pressure, 5, 0, 0);
    assert_close(s.shear.inertial_number, 1e-3, 0, 0);
    assert_close(s.shear.strain_end, 0.2, 0, 0);
    assert_int_equal(s.shear.walls, 0);
    assert_close(s.step.safety, 0.4, 0, 0);
    assert_close(s.step.dt, 0, 0, 0);
    assert_false(s.step.allow_unstable);
    assert_int_equal(s.output.frames, 20);
    assert_int_equal(s.output.rows, 400);
    assert_int_equal(s.output.contacts, 1);
    assert_int_equal(s.output.color, TR_COLOR_MOTION);
    assert_true(s.output.energy);
    assert_null(s.disks);
    tr_scene_free(&s);
}

static void bodies(void **state) {
    (void)state;
    tr_scene s = read_ok(bodies_case, NULL, 0);
    assert_int_equal(s.kind, TR_KIND_BODIES);
    assert_close(s.time_end, 0.1, 1e-15, 0);
    assert_close(s.gravity.x, 0, 0, 0);
    assert_close(s.gravity.y, -9.81, 0, 0);
    assert_int_equal(s.contact.rolling.law, 0);
    assert_false(s.output.energy);
    assert_int_equal(s.n_disks, 2);
    assert_close(s.disks[0].y, 0.01, 1e-15, 0);
    assert_close(s.disks[0].spin, -1.0 / 3, 0, 0);
    assert_close(s.disks[0].density, 2700, 0, 0);
    assert_int_equal(s.disks[0].motion, 0);
    assert_close(s.disks[1].radius, 0.01 / 3, 1e-15, 0);
    assert_close(s.disks[1].y, 0.01 / 3, 1e-15, 0);
    assert_close(s.disks[1].angle, 0.52359877559829887, 1e-15, 0);
    assert_int_equal(s.disks[1].motion, 1);
    assert_int_equal(s.n_walls, 2);
    assert_close(s.walls[0].nx, 0.3 / sqrt(0.58), 1e-15, 0);
    assert_close(s.walls[0].ny, 0.7 / sqrt(0.58), 1e-15, 0);
    assert_close(s.walls[0].vx, 1e-3, 0, 0);
    assert_close(s.walls[0].x, 0, 0, 0);
    tr_scene_free(&s);
}

static void contact(void **state) {
    (void)state;
    tr_scene s = read_ok(contact_case, NULL, 0);
    double E_star = 70e9 / (2 * (1 - 0.3 * 0.3)), R_star = 0.0025;
    assert_int_equal(s.kind, TR_KIND_CONTACT);
    assert_close(s.pair.R2, 0.01 / 3, 1e-15, 0);
    assert_close(s.pair.E_star, E_star, 1e-15, 0);
    assert_close(s.pair.R_star, R_star, 1e-15, 0);
    assert_close(s.pair.density, 1000, 1e-15, 0);
    assert_int_equal(s.n_laws, 2);
    const fake_spring *spring = (const void *)s.laws[0].friction.par;
    const fake_rolling *rolling = (const void *)s.laws[1].rolling.par;
    assert_int_equal(s.laws[0].friction.law, 0);
    assert_int_equal(s.laws[0].rolling.law, 0);
    assert_close(spring->k_t, 0.35 * E_star, 1e-15, 0);
    assert_int_equal(s.laws[1].friction.law, 1);
    assert_int_equal(s.laws[1].rolling.law, 1);
    assert_int_equal(s.laws[1].rolling_velocity, 1);
    assert_close(rolling->k_r, E_star / 7, 1e-15, 0);
    assert_int_equal(s.n_segments, 3);
    assert_close(s.path[0].force, 1e4, 0, 0);
    assert_close(s.path[0].roll, 3 * sqrt(4e4 * R_star / (M_PI * E_star)), 1e-14, 0);
    assert_int_equal(s.path[0].steps, 40);
    assert_close(s.path[1].force, 2.25e4, 0, 0);
    assert_close(s.path[1].slide, -0.18e-6, 1e-15, 0);
    assert_close(s.path[1].roll, -2 * sqrt(4e4 * R_star / (M_PI * E_star)), 1e-14,
                 0); /* its start is the first's end */
    assert_int_equal(s.path[1].steps, 100);
    assert_close(s.path[2].roll, sqrt(4 * 2.25e4 * R_star / (M_PI * E_star)), 1e-14, 0);
    assert_close(s.path[2].time, 1e-3, 0, 0);
    tr_scene_free(&s);
}

/* tr_alloc and the reader leave no byte of a scene unset, so scenes compare as bytes, lists aside. */
static void assert_same(const tr_scene *a, const tr_scene *b) {
    tr_scene x = *a, y = *b;
    assert_int_equal(a->n_more, b->n_more);
    for (int i = 0; i < a->n_more; i++) assert_same(&a->more[i], &b->more[i]);
    x.more = y.more = NULL;
    assert_int_equal(a->n_disks, b->n_disks);
    assert_int_equal(a->n_walls, b->n_walls);
    if (a->n_disks) assert_memory_equal(a->disks, b->disks, (size_t)a->n_disks * sizeof *a->disks);
    if (a->n_walls) assert_memory_equal(a->walls, b->walls, (size_t)a->n_walls * sizeof *a->walls);
    assert_int_equal(a->n_laws, b->n_laws);
    assert_int_equal(a->n_segments, b->n_segments);
    if (a->n_laws) assert_memory_equal(a->laws, b->laws, (size_t)a->n_laws * sizeof *a->laws);
    if (a->n_segments) assert_memory_equal(a->path, b->path, (size_t)a->n_segments * sizeof *a->path);
    assert_int_equal(a->n_checks, b->n_checks);
    if (a->n_checks) assert_memory_equal(a->checks, b->checks, (size_t)a->n_checks * sizeof *a->checks);
    x.checks = y.checks = NULL;
    x.laws = y.laws = NULL;
    x.path = y.path = NULL;
    x.disks = y.disks = NULL;
    x.walls = y.walls = NULL;
    assert_memory_equal(&x, &y, sizeof x);
}

static void round_trip(const tr_scene *s) {
    tr_status st = {0};
    char *text = tr_scene_write(s, &fake_catalog, &st);
    assert_non_null(text);
    tr_scene again = read_ok(text, NULL, 0);
    assert_same(s, &again);
    char *text2 = tr_scene_write(&again, &fake_catalog, &st);
    assert_string_equal(text, text2);
    tr_scene_free(&again);
    free(text);
    free(text2);
}

static void written_reads_the_same(void **state) {
    (void)state;
    const char *const sets[] = {"contact.normal=sticky", "contact.layers=5",          "contact.wet=true",
                                "contact.model=dmt",     "seed=18446744073709551615", "step.dt=0.1/3 us",
                                "shear.walls=rough",     "output.color=rolling"};
    tr_scene s = read_ok(biaxial_case, NULL, 0);
    round_trip(&s);
    tr_scene_free(&s);
    s = read_ok(contact_case, NULL, 0);
    round_trip(&s);
    tr_scene_free(&s);
    s = read_ok(biaxial_case, sets, sizeof sets / sizeof *sets);
    assert_true(s.seed == UINT64_MAX);
    round_trip(&s);
    tr_scene_free(&s);
    s = read_ok(bodies_case, NULL, 0);
    round_trip(&s);
    tr_scene_free(&s);
}

/* As long as its text can get with n disks: awkward numbers, normals and texts. */
static void fill(tr_scene *s, int n, tr_random *random) {
    tr_scene_free(s);
    *s = read_ok(bodies_case, NULL, 0);
    free(s->disks);
    free(s->walls);
    free(s->checks);
    s->n_disks = n;
    s->n_walls = 100;
    s->n_checks = 32;
    s->disks = calloc((size_t)n, sizeof *s->disks);
    s->walls = calloc(100, sizeof *s->walls);
    s->checks = calloc(32, sizeof *s->checks);
    for (int i = 0; i < n; i++) {
        double u = tr_random_uniform(random) + 0.1;
        s->disks[i] = (tr_scene_disk){
            u / 3, u / 7,         -u / 11,         sqrt(u),          -u * DBL_MIN,      DBL_TRUE_MIN,
            -0.0,  exp(-100 * u), .motion = i % 5, .orbit = -u / 13, .orbit_x = u / 17, .orbit_y = u / 19};
        s->disks[i].inertia = u / 23;
        if (i % 10 == 0) s->disks[i].pull = (tr_scene_pull){true, -u / 29, u / 31, -u / 37};
    }
    for (int i = 0; i < 100; i++)
        s->walls[i] = (tr_scene_wall){.nx = tr_random_uniform(random) + 1e-9, .ny = -3 * sin(i),
                                      .from = i % 3 ? -TR_ENDLESS : -i / 7.0, .to = i % 2 ? TR_ENDLESS : 1 / 3.0,
                                      .belt = -i / 11.0};
    for (int i = 0; i < 32; i++)
        s->checks[i] =
            (tr_scene_check){TR_POWER, .at = 0.1 / 3, .over = 0.1 / 7, .exact = -1 / 3.0, .tolerance = 1e-5 / 3};
    memset(s->lesson.answer, '"', sizeof s->lesson.answer - 1);
    memset(s->label, '\\', sizeof s->label - 1);
}

/* The most disks there can be, in one document and in six: still readable, still the same bits. */
static void large_case_reads_the_same(void **state) {
    (void)state;
    tr_random random = tr_random_seed(1, 2);
    for (int lanes = 1; lanes <= TR_MAX_LANES; lanes += TR_MAX_LANES - 1) {
        tr_scene s = {0};
        tr_status st = {0};
        fill(&s, 1000 - (lanes - 1) * 100, &random);
        s.n_more = lanes - 1;
        s.more = calloc(TR_MAX_LANES, sizeof *s.more);
        for (int i = 0; i < s.n_more; i++) fill(&s.more[i], 100, &random);
        char *text = tr_scene_write(&s, &fake_catalog, &st);
        tr_scene normalised = read_ok(text, NULL, 0);
        for (int i = 0; i < 100; i++) assert_close(hypot(normalised.walls[i].nx, normalised.walls[i].ny), 1, 1e-15, 0);
        assert_memory_equal(s.disks, normalised.disks, (size_t)s.n_disks * sizeof *s.disks);
        round_trip(&normalised);
        tr_scene_free(&normalised);
        tr_scene_free(&s);
        free(text);
    }
}

/* A line of text as a case may write it, and what it stands for. All but `plain` is text that means something else to
 * YAML. */
static void texts(void **state) {
    (void)state;
    static const struct {
        const char *yaml, *text;
    } rows[] = {
        {"plain words", "plain words"},
        {"\u0394a = \u2212\u0394b  [Wang eq. 2]", "\u0394a = \u2212\u0394b [Wang eq. 2]"},
        {"'it''s: \"so\" # not a comment'", "it's: \"so\" # not a comment"},
        {"\"\\\"a\\\\b\\\" \\u00e4\"", "\"a\\b\" \u00e4"},
        {">\n    folded: text,\n    \u00fcber #zwei\n    Zeilen\n", "folded: text, \u00fcber #zwei Zeilen"},
        {"|\n    two\n\n    lines\n\n", "two lines"},
        {"\"  a\\tb\\r\\nc  \"", "a b c"},
        {"", ""},
        {"' '", ""},
        {"'- *x &y !z %w @v'", "- *x &y !z %w @v"},
        {"'---'", "---"},
        {"'{a: [1, 2]}'", "{a: [1, 2]}"},
        {"'%s %n 3 mm'", "%s %n 3 mm"},
        {"'\"'", "\""},
        {"'\\'", "\\"},
        {"~", "~"},
        {"012345678901234567890123456789012345678901234567890123456789\u00e4x", /* all 63 bytes of the room */
         "012345678901234567890123456789012345678901234567890123456789\u00e4x"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[800];
        snprintf(text, sizeof text, "%slesson:\n  title: %s\n", bodies_case, rows[i].yaml);
        tr_scene s = read_ok(text, NULL, 0);
        assert_string_equal(s.lesson.title, rows[i].text);
        round_trip(&s);
        tr_scene_free(&s);
    }
    tr_scene s = set_ok(biaxial_case, "lesson.sentence= a = b: \"c\" # d "); /* no YAML there */
    assert_string_equal(s.lesson.sentence, "a = b: \"c\" # d");
    round_trip(&s);
    tr_scene_free(&s);
    s = set_ok(bodies_case, "label=rubber");
    assert_string_equal(s.label, "rubber");
    tr_scene_free(&s);
}

/* What the file looks like: keys, values, meanings, units. */
static void written_text(void **state) {
    (void)state;
    tr_scene s = read_ok(bodies_case, NULL, 0);
    tr_status st = {0};
    char *text = tr_scene_write(&s, &fake_catalog, &st);
    const char *const lines[] = {
        "kind: bodies                               # what is simulated: a biaxial test, a few bodies, one contact "
        "along a path, or the inside of one\n"
        "shape: disk                                # disk: a cylinder per metre of length; sphere: moves in the "
        "plane\n"
        "time_end: 0.1                              # time that the run covers [s]\n"
        "label: \"\"                                  # name of this document, among several in one file\n"
        "language: en                               # of the words in pictures: English or German; a lesson or label "
        "may be in both, {en: ..., de: ...}\n"
        "\nlesson: # texts for the class\n"
        "  title: \"\"                                # title of the film\n",
        ("\ncontact: # the laws between two disks\n"
         "  normal: linear                           # law of the normal force\n"),
        "  k_t: 500000                              # stiffness k_t [Pa]\n",
        "\ndisks:\n  - radius: 0.01                           # radius [m]\n",
        "centre of the orbit [m]\n  - radius: 0.0033333333333333335\n",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        if (!strstr(text, lines[i])) fail_msg("not found:\n%s\nin\n%s", lines[i], text);
    }
    assert_null(strstr(text, "energy"));
    assert_null(strstr(text, "mu_r"));
    free(text);
    tr_scene_free(&s);
}

/* Spheres: their units, their laws by default, their contact; the ways of giving a depth. */
static void spheres(void **state) {
    (void)state;
    tr_scene s = read_ok("kind: contact\n"
                         "bodies: {shape: sphere, R1: 1 cm, R2: 1 cm, E: 91 GPa, nu: 0.3}\n"
                         "laws: [{}, {normal: linear, k_n: 3 kN/m}]\n"
                         "path: [{force: 6 N, roll: a}, {overlap: 2 um}]\n",
                         NULL, 0);
    assert_int_equal(s.shape, TR_SHAPE_SPHERE);
    assert_int_equal(s.laws[0].normal.law, 3);
    assert_int_equal(s.laws[1].normal.law, 0);
    assert_close(((const fake_curve *)(const void *)s.laws[0].normal.par)->E_star, 50e9, 1e-15, 0);
    assert_close(((const fake_linear *)(const void *)s.laws[1].normal.par)->k_n, 3e3, 0, 0);
    assert_close(s.path[0].roll, cbrt(3 * 6 * 0.005 / (4 * 50e9)), 1e-14, 0);
    assert_true(isnan(s.path[0].overlap) && isnan(s.path[1].force));
    assert_close(s.path[1].overlap, 2e-6, 0, 0);
    round_trip(&s);
    tr_scene_free(&s);
    static const char *const depths[] = {"", ", depth: 3 mm", ", Lambda: 4.5"};
    const double a = sqrt(4 * 1e4 * 0.005 / (M_PI * 50e9)), d[] = {0.02 / M_E, 3e-3, a * exp(4.5) / 2};
    for (int i = 0; i < 3; i++) {
        char text[400];
        snprintf(text, sizeof text,
                 "kind: contact\nbodies: {R1: 1 cm, R2: 1 cm, E: 91 GPa, nu: 0.3%s}\nlaws: [{}]\n"
                 "path: [{force: 10 kN/m}]\n",
                 depths[i]);
        s = read_ok(text, NULL, 0);
        assert_close(s.pair.d, d[i], 1e-14, 0);
        assert_close(((const fake_curve *)(const void *)s.laws[0].normal.par)->depth, d[i], 1e-14, 0);
        round_trip(&s);
        tr_scene_free(&s);
    }
    s = read_ok("kind: biaxial\nshape: sphere\nsample: {r_min: 1 mm, r_max: 2 mm}\n"
                "contact: {normal: hertz-sphere, E_star: 1 GPa, k_t: 5 kN/m, k_r: k_t}\n"
                "compaction: {pressure: 100 N/m}\n",
                NULL, 0);
    assert_close(s.shear.lateral_pressure, 100, 0, 0);
    round_trip(&s);
    tr_scene_free(&s);
}

/* The inside of a contact: three ways to say the depth, prescribed sliding or friction. */
static void patch(void **state) {
    (void)state;
    static const char *const depths[] = {"", "depth: 3 mm\n", "Lambda: 4.5\n"};
    const double a = sqrt(4 * 1e4 * 0.005 / (M_PI * 50e9)), d[] = {0.02 / M_E, 3e-3, a * exp(4.5) / 2};
    for (int i = 0; i < 3; i++) {
        char text[500];
        snprintf(text, sizeof text,
                 "kind: patch\nbodies: {R1: 1 cm, R2: 1 cm, E: 91 GPa, nu: 0.3}\nmu: 0.25\n%selements: 50\n"
                 "path:\n  - {force: 10 kN/m, tangential: 0.6*mu*P, roll: 4*a}\n  - {force: 2*P, slide: 1 um}\n"
                 "output: {frames: 7}\n",
                 depths[i]);
        tr_scene s = read_ok(text, NULL, 0);
        assert_int_equal(s.kind, TR_KIND_PATCH);
        assert_int_equal(s.patch.solver, TR_HALF_PLANE);
        assert_true(s.patch.elements == 50 && s.patch.frames == 7 && s.patch.snapshots == 20);
        assert_close(s.pair.d, d[i], 1e-14, 0);
        assert_close(s.path[0].tangential, 1500, 1e-14, 0);
        assert_close(s.path[0].roll, 4 * a, 1e-14, 0);
        assert_close(s.path[1].force, 2e4, 1e-14, 0);
        assert_close(s.path[1].slide, 1e-6, 0, 0);
        assert_true(isnan(s.path[0].slide) && isnan(s.path[1].tangential));
        round_trip(&s);
        tr_scene_free(&s);
    }
}

static bool read_checks(tr_scene *s, const char *shape, const char *checks, tr_status *st) {
    char text[1500];
    const char *const plain = "contact.k_n=1e6"; /* Pa, N/m */
    snprintf(text, sizeof text, "shape: %s\n%s%s", shape, bodies_case, checks);
    return fake_read(s, text, &plain, 1, st);
}

static void checks(void **state) {
    (void)state;
    tr_scene s;
    tr_status st;
    if (!read_checks(&s, "disk", checks_part, &st)) fail_msg("%s", st.text);
    assert_int_equal(s.n_checks, 3);
    const tr_scene_check *c = s.checks;
    assert_int_equal(c[0].what, TR_SLIP_ENDS);
    assert_true(c[0].contact.n == 1 && c[0].contact.item[0].a == -1 && c[0].contact.item[0].b == 1);
    assert_close(c[0].exact, 1 / (3 * 0.5 * 9.81), 1e-15, 0);
    assert_close(c[0].tolerance, 0.01 / (3 * 0.5 * 9.81), 1e-15, 0);
    assert_true(c[0].at == 0 && c[0].over == 0); /* it has no time */
    assert_int_equal(c[1].what, TR_CREEPAGE);
    assert_true(c[1].contact.n == 1 && c[1].contact.item[0].a == 0 && c[1].contact.item[0].b == 1);
    assert_close(c[1].at, 0.1, 1e-15, 0);
    assert_close(c[1].over, 0.025, 1e-15, 0);
    assert_int_equal(c[2].what, TR_SPIN);
    assert_int_equal(c[2].disk, 1);
    assert_close(c[2].at, 0.03, 1e-15, 0);
    assert_close(c[2].exact, 1.0 / 3, 0, 0);
    assert_true(c[2].contact.n == 0);
    assert_close(s.output.still, 0.1, 1e-15, 0);
    round_trip(&s);
    char *text = tr_scene_write(&s, &fake_catalog, &st);
    static const char spin[] =
        "  - what: spin\n    disk: 1\n    at: 0.03\n    over: 0\n    exact: 0.3333333333333333\n    tolerance: 0.1\n";
    const char *end = strstr(text, spin); /* without `contact`, which would be refused */
    assert_non_null(end);
    assert_string_equal(end, spin);
    free(text);
    tr_scene_free(&s);
}

/* One check of `what`, whose exact and tolerance are in these units. */
static bool read_check(tr_scene *s, int shape, int what, const char *name, const char *exact, const char *tolerance,
                       tr_status *st) {
    char text[200];
    snprintf(text, sizeof text, "checks: [{what: %s, %sexact: 1%s, tolerance: 1%s}]\n", name,
             tr_whats[what].whose == TR_OF_CONTACT ? "contact: 0-1, " : "", exact, tolerance);
    return read_checks(s, shape ? "sphere" : "disk", text, st);
}

/* The dimension of exact and tolerance follows from `what`, and for two of them from the shape. */
static void checks_have_dimensions(void **state) {
    (void)state;
    static const struct {
        const char *what, *unit[2]; /* of disks, of spheres */
    } rows[TR_N_WHATS] = {
        [TR_SLIDING_VELOCITY] = {"sliding-velocity", {" m/s", " m/s"}},
        [TR_ROLLING_VELOCITY] = {"rolling-velocity", {" m/s", " m/s"}},
        [TR_CREEPAGE] = {"creepage", {" rad", " rad"}},
        [TR_POWER_LOST] = {"power-lost", {" N/s", " N*m/s"}},
        [TR_SLIP_ENDS] = {"slip-ends", {" s", " s"}},
        [TR_SLIP_STARTS] = {"slip-starts", {" s", " s"}},
        [TR_SPEED] = {"speed", {" m/s", " m/s"}},
        [TR_ACCELERATION] = {"acceleration", {" m/s^2", " m/s^2"}},
        [TR_STOP_TIME] = {"stop-time", {" s", " s"}},
        [TR_STOP_DISTANCE] = {"stop-distance", {" m", " m"}},
        [TR_PLACE_X] = {"x", {" m", " m"}},
        [TR_PLACE_Y] = {"y", {" m", " m"}},
        [TR_SPIN] = {"spin", {" rad/s", " rad/s"}},
        [TR_TORQUE] = {"torque", {" N", " N*m"}},
        [TR_POWER] = {"power", {" N/s", " N*m/s"}},
        [TR_ENERGY_LOST] = {"energy-lost", {" rad", " rad"}},
        [TR_ROLLS_FROM] = {"rolls-from", {" rad", " rad"}},
        [TR_SLIPS_FROM] = {"slips-from", {" rad", " rad"}},
    };
    static const char *const units[] = {" m/s", " rad", " s", " m/s^2", " m", " rad/s", " N", " N*m", " N/s", " N*m/s"};
    for (int i = 0; i < TR_N_WHATS; i++)
        if (!rows[i].what) fail_msg("%s has no row here", tr_whats[i].name);
    for (int shape = 0; shape < 2; shape++)
        for (int i = 0; i < TR_N_WHATS; i++)
            for (size_t u = 0; u < sizeof units / sizeof *units; u++) {
                tr_scene s;
                tr_status st;
                bool right = strcmp(units[u], rows[i].unit[shape]) == 0;
                for (int key = 0; key < 2; key++) {
                    if (read_check(&s, shape, i, rows[i].what, key ? "" : units[u], key ? units[u] : "", &st) != right)
                        fail_msg("%s in%s: %s", rows[i].what, units[u], right ? st.text : "accepted");
                    if (!right) assert_non_null(strstr(st.text, "wrong dimension"));
                    if (!right) continue;
                    assert_int_equal(s.checks[0].what, i);
                    round_trip(&s);
                    tr_scene_free(&s);
                }
            }
}

/* Each document is what the first would be with the changes written into it. */
static void documents(void **state) {
    (void)state;
    char text[3000], alone[3000];
    snprintf(text, sizeof text, "%s%s%s", bodies_case, checks_part, documents_part);
    tr_scene s = read_ok(text, NULL, 0);
    assert_int_equal(s.n_more, 2);
    assert_string_equal(s.label, "first");
    const char *const second[] = {"label=second: \"b\"", "contact.k_n=3 MPa", "contact.mu=0.25"};
    snprintf(alone, sizeof alone, "%s%s", bodies_case, checks_part);
    tr_scene as = read_ok(alone, second, 3);
    assert_same(&s.more[0], &as);
    tr_scene_free(&as);
    as = read_ok("kind: bodies\nlabel: first\ntime_end: 100 ms\ngravity: {y: -9.81, turn: pi/180}\n"
                 "contact: {normal: sticky, k_n: 1 MPa, layers: 6, friction: none, rolling: wang-spring, k_r: 1e6/7}\n"
                 "disks: [{radius: 1/3, x: 0, y: 1/3, vx: 2}, {radius: 1, x: 1, y: 1, motion: driven, spin: 1}]\n"
                 "walls: [{nx: 1, ny: 0.1}]\n",
                 NULL, 0);
    assert_same(&s.more[1], &as);
    tr_scene_free(&as);
    /* derived values and checks see their own document: k_t = 0.5*k_n, t = v/(3 mu g) */
    const fake_spring *spring[] = {(const void *)s.contact.friction.par, (const void *)s.more[0].contact.friction.par};
    assert_true(spring[0]->k_t == 0.5e6 && spring[1]->k_t == 1.5e6);
    assert_close(s.checks[0].exact, 1 / (3 * 0.5 * 9.81), 1e-15, 0);
    assert_close(s.more[0].checks[0].exact, 1 / (3 * 0.25 * 9.81), 1e-15, 0);
    round_trip(&s);
    tr_scene_free(&s);
    const char *const sets[] = {"contact.mu=0.125", "disks.1.spin=7", "output.frames=3", "step.safety=0.25"};
    s = read_ok(text, sets, 4);
    assert_close(((const fake_spring *)(const void *)s.more[0].contact.friction.par)->mu, 0.125, 0, 0);
    for (int i = -1; i < 2; i++) {
        const tr_scene *each = i < 0 ? &s : &s.more[i];
        assert_true(each->disks[1].spin == 7 && each->output.frames == 3 && each->step.safety == 0.25);
    }
    round_trip(&s);
    tr_scene_free(&s);
}

/* In the resolved case the keys of the first document's laws stay behind where a further one has other laws. Keys of
 * one name must then be one parameter. */
static void documents_with_any_two_laws(void **state) {
    (void)state;
    static const char text[] = "%skind: bodies\ntime_end: 1 s\n"
                               "contact: {normal: %s, friction: %s, rolling: %s, k_n: 3 MPa, E_star: 7 MPa, mu: 0.3, "
                               "mu_r: 0.1, k_t: k_n/3, k_r: k_n/7, theta_max: 1/3, limiter: yes, R_eq: half}\n"
                               "disks: [{radius: 1, x: 0, y: 0}]\n";
    const tr_param_catalog *laws = tr_laws_catalog();
    tr_random random = tr_random_seed(5, 6);
    int read = 0;
    for (int i = 0; i < 1000; i++) {
        char both[2000];
        size_t used = (size_t)snprintf(both, sizeof both, "shape: %s\n", i % 2 ? "sphere" : "disk");
        for (int k = 0; k < 2; k++) {
            const char *normal = laws->normal[tr_random_next(&random) % (uint32_t)laws->n_normal]->name;
            const char *friction = laws->friction[tr_random_next(&random) % (uint32_t)laws->n_friction]->name;
            const char *rolling = laws->rolling[tr_random_next(&random) % (uint32_t)laws->n_rolling]->name;
            used +=
                (size_t)snprintf(both + used, sizeof both - used, text, k ? "---\n" : "", normal, friction, rolling);
        }
        tr_scene s, again;
        tr_status st = {0};
        if (!tr_scene_read(&s, &(tr_scene_source){"a", both, used, NULL, 0}, laws, &st)) continue; /* a law for another shape or kind */
        char *resolved = tr_scene_write(&s, laws, &st);
        if (!tr_scene_read(&again, &(tr_scene_source){"a", resolved, strlen(resolved), NULL, 0}, laws, &st)) fail_msg("%s", st.text);
        assert_same(&s, &again);
        free(resolved);
        tr_scene_free(&s);
        tr_scene_free(&again);
        read++;
    }
    assert_true(read > 100);
}

/* The cases that ship, with the laws that there are. */
static void shipped_cases(void **state) {
    (void)state;
    glob_t files;
    assert_int_equal(glob("cases/*.yaml", 0, NULL, &files), 0); /* tests run in the root of the repository */
    for (size_t i = 0; i < files.gl_pathc; i++) {
        tr_scene s, again;
        tr_status st = {0};
        const tr_param_catalog *laws = tr_laws_catalog();
        if (strstr(files.gl_pathv[i], "/sweep")) continue; /* no case: tests/study/test_sweep.c */
        if (!tr_scene_read_file(&s, files.gl_pathv[i], NULL, 0, laws, &st)) fail_msg("%s", st.text);
        char *text = tr_scene_write(&s, laws, &st);
        if (!tr_scene_read(&again, &(tr_scene_source){"a", text, strlen(text), NULL, 0}, laws, &st)) fail_msg("%s", st.text);
        assert_same(&s, &again);
        free(text);
        tr_scene_free(&s);
        tr_scene_free(&again);
    }
    globfree(&files);
}

/* A turn a second, however it is written; 1e-15 is a few roundings. */
static void turns_a_second(void **state) {
    (void)state;
    const char *const sets[] = {"disks.0.spin=60 rpm", "disks.1.spin=360 deg/s", "gravity.turn=2*pi*rad/s",
                                "disks.1.orbit=2*pi/s"};
    tr_scene s = read_ok(bodies_case, sets, 4);
    const double turn = 6.2831853071795865;
    assert_close(s.disks[0].spin, turn, 1e-15, 0);
    assert_close(s.disks[1].spin, turn, 1e-15, 0);
    assert_close(s.gravity.turn, turn, 1e-15, 0);
    assert_close(s.disks[1].orbit, turn, 1e-15, 0);
    tr_scene_free(&s);
}

/* A torque where spin follows from moments; an orbit at rest. */
static void motions(void **state) {
    (void)state;
    const char *const pinned[] = {"disks.0.torque=3 N", "disks.1.torque=-1", "disks.1.motion=pinned"};
    tr_scene s = read_ok(bodies_case, pinned, 3);
    assert_true(s.disks[0].torque == 3 && s.disks[1].torque == -1 && s.disks[1].motion == TR_PINNED);
    tr_scene_free(&s);
    s = set_ok(bodies_case, "disks.1.motion=orbit");
    assert_true(s.disks[1].motion == TR_ORBIT && s.disks[1].orbit == 0);
    tr_scene_free(&s);
}

static void sets(void **state) {
    (void)state;
    tr_scene s = set_ok(biaxial_case, "shear.inertial_number=1e-4");
    assert_close(s.shear.inertial_number, 1e-4, 0, 0);
    tr_scene_free(&s);
    s = set_ok(biaxial_case, " step . safety = 1/4 "); /* the section is not in the file */
    assert_close(s.step.safety, 0.25, 0, 0);
    tr_scene_free(&s);
    s = set_ok(bodies_case, "disks.1.spin=2 rad/s");
    assert_close(s.disks[1].spin, 2, 0, 0);
    tr_scene_free(&s);
    s = set_ok("kind: bodies\ntime_end: 1\ncontact: {k_n: 1}\noutput:\ndisks: [{radius: 1, x: 0, y: 0}]",
               "output.frames=3");
    assert_int_equal(s.output.frames, 3);
    tr_scene_free(&s);
    s = set_ok(biaxial_case, "output.rows=2*sample.disks + 1"); /* a count is a number */
    assert_int_equal(s.output.rows, 801);
    tr_scene_free(&s);
    const char *const twice[] = {"seed=2", "seed=3"};
    s = read_ok(biaxial_case, twice, 2);
    assert_int_equal(s.seed, 3);
    tr_scene_free(&s);
}

/* A law can be dropped without touching its keys; what a dropped law's key says can still be named. */
static void laws_not_chosen(void **state) {
    (void)state;
    const double nothing[TR_LAW_PAR] = {0};
    tr_scene s = set_ok(biaxial_case, "contact.rolling=none");
    assert_int_equal(s.contact.rolling.law, 0);
    assert_memory_equal(s.contact.rolling.par, nothing, sizeof nothing);
    tr_scene_free(&s);
    s = set_ok(biaxial_case, "contact.friction=none");
    const fake_rolling *rolling = (const void *)s.contact.rolling.par;
    assert_memory_equal(s.contact.friction.par, nothing, sizeof nothing);
    assert_close(rolling->k_r, 80e6, 0, 0);
    tr_scene_free(&s);
}

static void laws_share_a_key(void **state) {
    (void)state;
    tr_scene s = set_ok(biaxial_case, "contact.normal=sticky");
    const fake_sticky *sticky = (const void *)s.contact.normal.par;
    const fake_spring *spring = (const void *)s.contact.friction.par;
    assert_close(sticky->mu, 0.5, 0, 0);
    assert_close(spring->mu, 0.5, 0, 0);
    assert_int_equal(sticky->layers, 3);
    assert_int_equal(sticky->model, 1);
    tr_scene_free(&s);
    s = read_ok("kind: bodies\ntime_end: 1\ncontact: {normal: sticky, k_n: 1}\ndisks: [{radius: 1, x: 0, y: 0}]", NULL,
                0);
    sticky = (const void *)s.contact.normal.par;
    spring = (const void *)s.contact.friction.par;
    assert_close(sticky->mu, 0.25, 0, 0); /* the first law's default is the key's */
    assert_close(spring->mu, 0.25, 0, 0);
    round_trip(&s);
    tr_scene_free(&s);
}

static void files(void **state) {
    (void)state;
    tr_scene s;
    tr_status st = {0};
    assert_false(tr_scene_read_file(&s, "no/such.yaml", NULL, 0, &fake_catalog, &st));
    assert_int_equal(st.code, TR_FILE);
    assert_string_equal(st.text, "error: cannot open no/such.yaml: No such file or directory");
    st = (tr_status){0};
    assert_false(tr_scene_read_file(&s, "/", NULL, 0, &fake_catalog, &st));
    assert_string_equal(st.text, "error: cannot read /: Is a directory");
    char path[] = "/tmp/trundle-scene-XXXXXX";
    FILE *file = fdopen(mkstemp(path), "w");
    fprintf(file, "\xef\xbb\xbf---\r\n%s", biaxial_case); /* as some editors save */
    fclose(file);
    st = (tr_status){0};
    bool ok = tr_scene_read_file(&s, path, NULL, 0, &fake_catalog, &st);
    remove(path);
    if (!ok) fail_msg("%s", st.text);
    tr_scene again = read_ok(biaxial_case, NULL, 0);
    assert_same(&s, &again);
    tr_scene_free(&s);
    tr_scene_free(&again);
}

/* Bytes changed, dropped, doubled at random: read or refused with a place, never more. */
static void damaged_cases(void **state) {
    (void)state;
    static const char strange[] = "[]{}:,-#&*!|>'\"%@`?\n\t \\\0\x80\xff.^(/k0e9";
    char documents[3000];
    snprintf(documents, sizeof documents, "%s%s%slesson:\n  title: >\n    \u0394a =\n    \u2212\u0394b\n", bodies_case,
             checks_part, documents_part);
    tr_random random = tr_random_seed(3, 4);
    int accepted = 0;
    for (int i = 0; i < 4000; i++) {
        const char *const sources[] = {documents, biaxial_case, contact_case};
        const char *source = sources[i % 3];
        char text[3000];
        size_t n = strlen(source);
        memcpy(text, source, n);
        for (uint32_t k = tr_random_next(&random) % 4 + 1; k > 0; k--) {
            size_t at = tr_random_next(&random) % n, from = tr_random_next(&random) % n;
            size_t length = tr_random_next(&random) % 40;
            if (from + length > n) length = n - from;
            if (at + length > n) length = n - at;
            if (k % 2)
                text[at] = strange[tr_random_next(&random) % (sizeof strange - 1)];
            else
                memmove(text + at, text + from, length);
        }
        tr_scene s;
        tr_status st = {0};
        if (tr_scene_read(&s, &(tr_scene_source){"a", text, n, NULL, 0}, &fake_catalog, &st)) {
            round_trip(&s);
            accepted++;
        } else {
            int line, column;
            assert_int_equal(st.code, TR_BAD_CASE);
            assert_int_equal(sscanf(st.text, "a:%d:%d: error: ", &line, &column), 2);
            assert_null(s.disks);
            assert_null(s.path);
            assert_null(s.checks);
            assert_null(s.more);
        }
        tr_scene_free(&s);
    }
    assert_true(accepted > 40 && accepted < 3900); /* both ways were tried */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(biaxial),
        cmocka_unit_test(defaults),
        cmocka_unit_test(bodies),
        cmocka_unit_test(contact),
        cmocka_unit_test(spheres),
        cmocka_unit_test(patch),
        cmocka_unit_test(written_reads_the_same),
        cmocka_unit_test(written_text),
        cmocka_unit_test(texts),
        cmocka_unit_test(large_case_reads_the_same),
        cmocka_unit_test(checks),
        cmocka_unit_test(checks_have_dimensions),
        cmocka_unit_test(shipped_cases),
        cmocka_unit_test(motions),
        cmocka_unit_test(documents),
        cmocka_unit_test(documents_with_any_two_laws),
        cmocka_unit_test(turns_a_second),
        cmocka_unit_test(sets),
        cmocka_unit_test(laws_not_chosen),
        cmocka_unit_test(laws_share_a_key),
        cmocka_unit_test(files),
        cmocka_unit_test(damaged_cases),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
