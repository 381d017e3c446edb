/* SPDX-License-Identifier: MIT */
/* A biaxial test that is saved in the midst of its way and loaded into a new one goes on bit for bit. For every law of
 * the registries, every boundary, kind of wall, stress that is held and shape, so that what is added later is covered.
 * What is compared is all that a run reads, not the fields that are saved. */
#include "core/checkpoint.h"
#include "core/ledger.h"
#include "core/measures.h"
#include "core/record.h"
#include "core/stretch.h"
#include "core/worlds.h"
#include "scene/tables.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

enum { DISKS = 40 };
static char dir[] = "/tmp/trundle-restart-XXXXXX";

/* ---- scenes of every law */

typedef struct text {
    char s[600];
} text;

static void add(text *t, const char *format, ...) {
    size_t used = strlen(t->s);
    va_list args;
    va_start(args, format);
    vsnprintf(t->s + used, sizeof t->s - used, format, args);
    va_end(args);
}

/* The parameters that a law must be given, and stiffnesses, whose default may name another law's; each once, though two
 * laws may share it. */
static void add_parameters(text *t, const tr_law *law) {
    for (int i = 0; i < law->table.n; i++) {
        const tr_param *p = &law->table.params[i];
        char key[40];
        snprintf(key, sizeof key, " %s:", p->key);
        static const tr_dim of_stiffness = TR_DIM_STIFFNESS, of_modulus = TR_DIM_MODULUS;
        bool stiffness = p->type == TR_REAL && memcmp(&p->dim, &of_stiffness, sizeof p->dim) == 0;
        bool modulus = memcmp(&p->dim, &of_modulus, sizeof p->dim) == 0;
        if ((p->fallback && !stiffness) || strstr(t->s, key)) continue;
        add(t, ",%s %s", key, stiffness ? "1000*compaction.pressure" : modulus ? "200 MPa" : "0.3");
    }
}

static const char *const shapes[] = {"disk", "sphere"};

/* False: the reader refuses these laws for this shape. */
static bool scene_of(tr_scene *scene, const tr_law *const law[3], const char *boundary, const char *how, int shape) {
    tr_status st = {0};
    text t = {""};
    add(&t, "kind: biaxial\nboundary: %s\nshape: %s\nsample: {disks: %d, r_min: 0.76 mm, r_max: 1.52 mm}\n", boundary,
        shapes[shape], DISKS);
    add(&t, "compaction: {pressure: %s, inertial_number: 0.1, unbalanced: 1e-2}\n", shape ? "160 N/m" : "160 kPa");
    add(&t, "shear: {inertial_number: 0.01, strain_end: 0.4, %s, lateral_pressure: compaction.pressure}\n", how);
    add(&t, "output: {paths: [0-1]}\ncontact: {normal: %s, friction: %s, rolling: %s", law[0]->table.name,
        law[1]->table.name, law[2]->table.name);
    for (int k = 0; k < 3; k++) add_parameters(&t, law[k]);
    add(&t, ", arms: %s}\n", strcmp(boundary, "walls") ? "shared" : "midpoint");
    if (tr_scene_read(scene, &(tr_scene_source){"case", t.s, strlen(t.s), NULL, 0}, tr_laws_catalog(), &st))
        return true;
    const unsigned only = TR_ONLY_DISKS | TR_ONLY_SPHERES | TR_ONLY_DRIVER;
    for (int k = 0; k < 3; k++)
        if (law[k]->table.demands & only) return false;
    if (strstr(st.text, "`boundary: periodic`")) return false; /* rough walls have none, mean stress needs one */
    fail_msg("%s\n%s", st.text, t.s);
    return false;
}

/* ---- two ways to the same state */

static void begin(tr_biaxial *b, const tr_scene *scene) {
    tr_status st = {0};
    if (!tr_biaxial_init(b, scene, &st)) fail_msg("%s", st.text);
}

static void save(tr_biaxial *b) {
    tr_checkpoint c;
    tr_status st = {0};
    tr_checkpoint_begin(&c, "case", &st);
    tr_biaxial_checkpoint(b, &c);
    if (!tr_checkpoint_write(&c, dir, TR_CHECKPOINT)) fail_msg("%s", st.text);
}

static void load(tr_biaxial *b) {
    tr_checkpoint c;
    tr_status st = {0}, instead = {0};
    assert_true(tr_checkpoint_open(&c, dir, TR_CHECKPOINT, "case", &instead, &st));
    tr_biaxial_checkpoint(b, &c);
    if (!tr_checkpoint_close(&c)) fail_msg("%s", st.text);
}

static void assert_same_group(const tr_group *p, const tr_group *q) {
    size_t n = (size_t)p->n;
    assert_int_equal(p->n, q->n);
    assert_memory_equal(p->a, q->a, n * sizeof(int));
    assert_memory_equal(p->b, q->b, n * sizeof(int));
    for (int k = 0; k < p->n_hist; k++) assert_memory_equal(p->hist[k], q->hist[k], n * sizeof(double));
    for (int k = 0; k < p->n_pair; k++) assert_memory_equal(p->pair[k], q->pair[k], n * sizeof(double));
}

/* Forces are there. */
static void assert_same(tr_biaxial *p, tr_biaxial *q) {
    const tr_world *v = &p->world, *w = &q->world;
    assert_same_bits(v, w);
    assert_memory_equal(v->disks.force, w->disks.force, 4 * (size_t)v->disks.n * sizeof(double));
    assert_memory_equal(v->wall, w->wall, (size_t)v->n_walls * sizeof *v->wall);
    assert_memory_equal(&v->cell, &w->cell, sizeof v->cell);
    assert_int_equal(v->searches, w->searches);
    assert_int_equal(v->refreshes, w->refreshes);
    assert_int_equal(v->contact_updates, w->contact_updates);
    for (int k = 0; k < 2; k++) assert_same_group(&v->group[k], &w->group[k]);
    if (v->ledger) {
        tr_energy e = tr_ledger_read(v), f = tr_ledger_read(w);
        assert_memory_equal(&e, &f, sizeof e);
    }
    tr_biaxial_state s = tr_biaxial_read(p), t = tr_biaxial_read(q);
    assert_memory_equal(&s, &t, sizeof s);
    assert_true(p->held_sum == q->held_sum && p->held_strain == q->held_strain);
    assert_true(p->held_strain > 0 || !p->shear_steps);
}

static tr_measures measures_of(tr_world *world) {
    tr_record *records = NULL;
    tr_status st = {0};
    int capacity = 0, n = tr_record_all(world, &records, &capacity, &st);
    tr_measures m = tr_measures_of(world, records, n);
    free(records);
    return m;
}

/* The shear of a packing, whose disks are those of the scene. */
static void follow(tr_biaxial *b, const tr_scene *scene, const tr_biaxial *packing) {
    begin(b, scene);
    memcpy(b->world.disks.pos, packing->world.disks.pos, 4 * DISKS * sizeof(double));
    memcpy(b->world.wall, packing->world.wall, sizeof b->world.wall);
    b->world.cell = packing->world.cell;
    b->world.steps = packing->world.steps;
    begin_shear(b);
}

static bool has_moved(const tr_world *world) {
    tr_extent now = tr_stretch_extent(world);
    return memcmp(&now, &world->thin_extent, sizeof now) != 0;
}

typedef struct seen {
    bool moved, slides, sticks;  /* when it is saved: bodies, since the list was made; some contacts; others */
    int64_t searches, refreshes; /* after it */
} seen;

/* Shears the packing for `first` steps, saves, and for `then` more, as does one that was loaded. */
static seen assert_goes_on(const tr_scene *scene, const tr_biaxial *packing, int first, int then) {
    tr_biaxial b, loaded;
    seen s = {0};
    follow(&b, scene, packing);
    begin(&loaded, scene), begin_shear(&loaded);
    shear_steps(&b, first - 1), shear_forces(&b);
    tr_measures m = measures_of(&b.world);
    tr_step_advance(&b.world);
    save(&b);
    s.searches = b.world.searches, s.refreshes = b.world.refreshes;
    s.moved = !b.world.stale && has_moved(&b.world) &&
              memcmp(b.world.disks.pos + 4 * 7, b.world.thin_ref + 2 * 7, sizeof(double));
    load(&loaded);
    shear_steps(&b, then), shear_forces(&b);
    shear_steps(&loaded, then), shear_forces(&loaded);
    assert_same(&b, &loaded);
    s.slides = m.sliding_fraction > 0, s.sticks = m.sliding_fraction < 1;
    s.searches = b.world.searches - s.searches, s.refreshes = b.world.refreshes - s.refreshes;
    tr_biaxial_free(&b), tr_biaxial_free(&loaded);
    return s;
}

/* A compacted sample, the same for all laws: its disks depend on the seed alone. */
static void pack(tr_biaxial *packing, tr_scene *scene, const char *boundary, int shape) {
    const tr_law *const law[3] = {tr_laws_normal[0], tr_laws_friction[0], tr_laws_rolling[0]};
    assert_true(scene_of(scene, law, boundary, "walls: smooth", shape));
    compact(packing, scene);
}

/* Choice k of a key of the biaxial test; false: there is none. */
static bool choice(const char *key, int k, char name[32]) {
    const tr_param *p = NULL;
    for (int i = 0; i < tr_n_sections; i++)
        for (int j = 0; tr_sections[i].kinds & TR_FOR_BIAXIAL && j < tr_sections[i].n; j++)
            if (!strcmp(tr_sections[i].params[j].key, key)) p = &tr_sections[i].params[j];
    assert_non_null(p);
    const char *at = p->choices;
    for (; k > 0 && at; k--) at = strchr(at, '|') ? strchr(at, '|') + 1 : NULL;
    if (at) snprintf(name, 32, "%.*s", (int)strcspn(at, "|"), at);
    return at != NULL;
}

/* "walls: smooth", which is the default, then each other choice; false: no more. */
static bool way(int k, char how[48]) {
    static const char *const keys[] = {"walls", "hold"};
    char name[32];
    for (int key = 0; key < 2; key++)
        for (int i = key; choice(keys[key], i, name); i++)
            if (k-- == 0) {
                snprintf(how, 48, "%s: %s", keys[key], name);
                return true;
            }
    return false;
}

/* Each law of each slot, beside the first of the other slots. */
static void test_every_law_and_boundary(void **state) {
    (void)state;
    const tr_param_catalog *catalog = tr_laws_catalog();
    const int n[3] = {catalog->n_normal, catalog->n_friction, catalog->n_rolling};
    const tr_law *const *const all[3] = {tr_laws_normal, tr_laws_friction, tr_laws_rolling};
    int histories = 0, ran[3][16] = {{0}}, slid = 0, moved = 0, renewed = 0, searched = 0, ways = 0;
    char boundary[32], how[48];
    for (int k = 0; choice("boundary", k, boundary); k++)
        for (int shape = 0; shape < 2; shape++) {
            tr_biaxial packing;
            tr_scene compacted;
            pack(&packing, &compacted, boundary, shape);
            for (int j = 0; way(j, how); j++) {
                int runs = 0;
                for (int slot = 0; slot < 3; slot++)
                    for (int i = 0; i < n[slot]; i++) {
                        const tr_law *law[3] = {tr_laws_normal[0], tr_laws_friction[0], tr_laws_rolling[0]};
                        tr_scene scene;
                        law[slot] = all[slot][i];
                        if (!scene_of(&scene, law, boundary, how, shape)) continue;
                        seen s = assert_goes_on(&scene, &packing, 701, 900);
                        assert_true(s.sticks);
                        ran[slot][i]++, runs++, slid += s.slides, moved += s.moved, renewed += s.refreshes > 0,
                            searched += s.searches > 0;
                        if (law[slot]->n_hist) histories++;
                        tr_scene_free(&scene);
                    }
                ways += runs > 0;
            }
            tr_biaxial_free(&packing), tr_scene_free(&compacted);
        }
    for (int slot = 0; slot < 3; slot++)
        for (int i = 0; i < n[slot]; i++)
            if (!ran[slot][i] && !(all[slot][i]->table.demands & TR_ONLY_DRIVER))
                fail_msg("%s was never run", all[slot][i]->table.name);
    assert_true(histories > 20 && slid > 20 && moved > 20 && renewed > 20 && searched > 20 && ways >= 8);
}

/* Many steps of a while: right at the start, when nothing has moved yet; when the list is stale; in between. */
static void every_moment(const char *boundary, const char *how) {
    enum { UNTIL = 600 };
    const tr_law *const law[3] = {tr_laws_normal[0], tr_laws_friction[0], tr_laws_rolling[0]};
    tr_biaxial packing, whole, b, loaded;
    tr_scene compacted, scene;
    int stale = 0, fresh = 0, moved = 0;
    pack(&packing, &compacted, boundary, 0);
    assert_true(scene_of(&scene, law, boundary, how, 0));
    follow(&whole, &scene, &packing), follow(&b, &scene, &packing);
    shear_steps(&whole, UNTIL), shear_forces(&whole);
    for (int k = 0; k < UNTIL; k++, shear_steps(&b, 1)) {
        if (k > 3 && k % 16 && !b.world.stale) continue;
        save(&b);
        stale += b.world.stale, fresh += b.world.fresh, moved += has_moved(&b.world);
        begin(&loaded, &scene), begin_shear(&loaded);
        load(&loaded);
        shear_steps(&loaded, UNTIL - k), shear_forces(&loaded);
        tr_biaxial all = whole; /* reading it begins a new interval of its averages */
        assert_same(&all, &loaded);
        tr_biaxial_free(&loaded);
    }
    assert_true(stale > 2 && fresh == 1 && moved > 20);
    tr_biaxial_free(&packing), tr_biaxial_free(&whole), tr_biaxial_free(&b);
    tr_scene_free(&compacted), tr_scene_free(&scene);
}

static void test_every_moment(void **state) {
    (void)state;
    every_moment("walls", "walls: rough"), every_moment("periodic", "hold: mean");
}

static void in_the_compaction(const char *boundary) {
    tr_biaxial whole, b;
    tr_scene scene;
    pack(&whole, &scene, boundary, 0);
    for (int batches = 1; batches < 40; batches += 6) {
        tr_biaxial loaded;
        tr_status st = {0};
        double unbalanced;
        bool done = false;
        begin(&b, &scene);
        for (int k = 0; k < batches; k++) assert_true(tr_biaxial_compact(&b, 200, &unbalanced, &done, &st) && !done);
        save(&b);
        tr_biaxial_free(&b);
        begin(&loaded, &scene), load(&loaded);
        while (!done) assert_true(tr_biaxial_compact(&loaded, 200, &unbalanced, &done, &st));
        tr_biaxial all = whole;
        assert_same(&all, &loaded);
        tr_biaxial_free(&loaded);
    }
    tr_biaxial_free(&whole), tr_scene_free(&scene);
}

static void test_in_the_compaction(void **state) {
    (void)state;
    char boundary[32];
    for (int k = 0; choice("boundary", k, boundary); k++) in_the_compaction(boundary);
}

/* Saved with *field = wrong, as behind a checksum that was made good; loaded into a world that is right. */
static void assert_refused(tr_biaxial *b, const tr_scene *scene, void *field, const void *wrong, size_t size,
                           const char *what) {
    unsigned char right[sizeof(double)];
    tr_biaxial loaded;
    tr_checkpoint c;
    tr_status st = {0}, instead = {0};
    memcpy(right, field, size);
    memcpy(field, wrong, size);
    save(b);
    memcpy(field, right, size);
    begin(&loaded, scene);
    assert_true(tr_checkpoint_open(&c, dir, TR_CHECKPOINT, "case", &instead, &st));
    tr_biaxial_checkpoint(&loaded, &c);
    assert_false(tr_checkpoint_close(&c));
    assert_int_equal(st.code, TR_FILE);
    if (!strstr(st.text, what)) fail_msg("no \"%s\" in: %s", what, st.text);
    tr_biaxial_free(&loaded);
}

static void test_bodies_that_are_not_there_are_refused(void **state) {
    (void)state;
    tr_biaxial b;
    tr_scene scene;
    pack(&b, &scene, "walls", 0);
    tr_world *world = &b.world;
    const int ids[] = {-1, DISKS, 1 << 30}, last = DISKS - 1; /* out of order */
    int *const from[] = {world->near.a, world->near.b, world->group[0].a, world->group[0].b, world->group[1].a};
    const double radii[] = {0, -1, 1}, right_of_all = 1e3;
    for (size_t k = 0; k < sizeof from / sizeof *from; k++)
        for (int i = 0; i < 3; i++) assert_refused(&b, &scene, from[k], &ids[i], sizeof(int), "a pair of bodies");
    assert_refused(&b, &scene, world->near.a, &last, sizeof(int), "a pair of bodies");
    assert_refused(&b, &scene, world->group[0].a, &last, sizeof(int), "a pair of bodies");
    for (int i = 0; i < 3; i++)
        assert_refused(&b, &scene, world->disks.pos + 4 * 5 + 3, &radii[i], sizeof(double), "a radius");
    assert_refused(&b, &scene, &world->wall[TR_LEFT_WALL].x, &right_of_all, sizeof(double), "a wall or the cell");
    assert_refused(&b, &scene, &world->cell.side[0], &right_of_all, sizeof(double), "a wall or the cell");
    tr_biaxial_free(&b), tr_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_law_and_boundary),
        cmocka_unit_test(test_every_moment),
        cmocka_unit_test(test_in_the_compaction),
        cmocka_unit_test(test_bodies_that_are_not_there_are_refused),
    };
    if (!mkdtemp(dir)) return 1;
    int failed = cmocka_run_group_tests_name("restart", tests, NULL, NULL);
    tr_checkpoint_remove(dir);
    rmdir(dir);
    return failed;
}
