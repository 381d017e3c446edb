/* SPDX-License-Identifier: MIT */
/* Reading good cases, writing them back, overriding keys; and 4000 damaged cases, none of which may crash or hang. */
#include "assert_close.h"
#include "base/random.h"
#include "fake_catalog.h"
#include <float.h>
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
    assert_int_equal(s.output.color, TR_COLOR_MOBILISATION);
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
    assert_int_equal(a->n_disks, b->n_disks);
    assert_int_equal(a->n_walls, b->n_walls);
    if (a->n_disks) assert_memory_equal(a->disks, b->disks, (size_t)a->n_disks * sizeof *a->disks);
    if (a->n_walls) assert_memory_equal(a->walls, b->walls, (size_t)a->n_walls * sizeof *a->walls);
    assert_int_equal(a->n_laws, b->n_laws);
    assert_int_equal(a->n_segments, b->n_segments);
    if (a->n_laws) assert_memory_equal(a->laws, b->laws, (size_t)a->n_laws * sizeof *a->laws);
    if (a->n_segments) assert_memory_equal(a->path, b->path, (size_t)a->n_segments * sizeof *a->path);
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

/* The most disks there can be, with awkward numbers and normals: still readable, still the same bits. */
static void large_case_reads_the_same(void **state) {
    (void)state;
    tr_scene s = read_ok(bodies_case, NULL, 0);
    tr_random random = tr_random_seed(1, 2);
    tr_status st = {0};
    free(s.disks);
    free(s.walls);
    s.n_disks = 1000;
    s.n_walls = 100;
    s.disks = calloc(1000, sizeof *s.disks);
    s.walls = calloc(100, sizeof *s.walls);
    for (int i = 0; i < 1000; i++) {
        double u = tr_random_uniform(&random) + 0.1;
        s.disks[i] =
            (tr_scene_disk){u / 3, u / 7, -u / 11, sqrt(u), -u * DBL_MIN, DBL_TRUE_MIN, -0.0, exp(-100 * u), i % 2};
    }
    for (int i = 0; i < 100; i++)
        s.walls[i] = (tr_scene_wall){.nx = tr_random_uniform(&random) + 1e-9, .ny = -3 * sin(i)};
    char *text = tr_scene_write(&s, &fake_catalog, &st);
    tr_scene normalised = read_ok(text, NULL, 0);
    for (int i = 0; i < 100; i++) assert_close(hypot(normalised.walls[i].nx, normalised.walls[i].ny), 1, 1e-15, 0);
    assert_memory_equal(s.disks, normalised.disks, 1000 * sizeof *s.disks);
    round_trip(&normalised);
    tr_scene_free(&normalised);
    tr_scene_free(&s);
    free(text);
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
        "\ncontact: # what two disks do to each other\n"
        "  normal: linear                           # law of the normal force\n",
        "  k_t: 500000                              # stiffness k_t [Pa]\n",
        "\ndisks:\n  - radius: 0.01                           # radius [m]\n",
        "keeps vx, vy, spin\n  - radius: 0.0033333333333333335\n",
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

static void sets(void **state) {
    (void)state;
    tr_scene s = set_ok(biaxial_case, "shear.inertial_number=1e-4");
    assert_close(s.shear.inertial_number, 1e-4, 0, 0);
    tr_scene_free(&s);
    s = set_ok(biaxial_case, " step . safety = 1/4 "); /* the section is not in the file */
    assert_close(s.step.safety, 0.25, 0, 0);
    tr_scene_free(&s);
    s = set_ok(bodies_case, "disks.1.spin=2 Hz");
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
    tr_random random = tr_random_seed(3, 4);
    int accepted = 0;
    for (int i = 0; i < 4000; i++) {
        const char *const sources[] = {bodies_case, biaxial_case, contact_case};
        const char *source = sources[i % 3];
        char text[2048];
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
        if (tr_scene_read(&s, "a", text, n, NULL, 0, &fake_catalog, &st)) {
            round_trip(&s);
            accepted++;
        } else {
            int line, column;
            assert_int_equal(st.code, TR_BAD_CASE);
            assert_int_equal(sscanf(st.text, "a:%d:%d: error: ", &line, &column), 2);
            assert_null(s.disks);
            assert_null(s.path);
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
        cmocka_unit_test(large_case_reads_the_same),
        cmocka_unit_test(sets),
        cmocka_unit_test(laws_not_chosen),
        cmocka_unit_test(laws_share_a_key),
        cmocka_unit_test(files),
        cmocka_unit_test(damaged_cases),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
