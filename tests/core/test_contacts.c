/* SPDX-License-Identifier: MIT */
/* The list of contacts. References: every pair looked at (is a touching one missing?), the path of a contact summed up
 * by hand (is its history whole?), and the same run with other skins, another finder, another world beside it, or
 * looked at in between (are the bits the same?). */
#include "core/pipeline.h"
#include "core/record.h"
#include "core/worlds.h"

enum { DISKS = 60, STEPS = 5000 };

static const test_laws normal_spring = {.k_n = 1e6};

static tr_scene small_scene(uint64_t seed) {
    tr_scene scene = biaxial_scene(DISKS, seed, sand);
    scene.shear.walls = 1; /* histories at walls too */
    scene.shear.inertial_number = 5e-3;
    scene.compaction.unbalanced = 1e-2;
    scene.shear.strain_end = 0.5;
    return scene;
}

static void sheared(tr_biaxial *b, const tr_scene *scene) {
    compact(b, scene);
    begin_shear(b);
}

/* ---- completeness */

static void test_no_touching_pair_is_missed(void **state) {
    (void)state;
    tr_scene scene = small_scene(2);
    scene.shear.inertial_number = 1e-2; /* faster: new contacts */
    tr_biaxial b;
    sheared(&b, &scene);
    tr_world *w = &b.world;
    int64_t refreshes = w->refreshes, searches = w->searches, touched[2] = {0};
    double way = 0; /* at least that of the body that went furthest since any step */
    for (int k = 0; k < STEPS; k++) {
        shear_forces(&b);
        int touching[2] = {0};
        for (int i = 0; i < DISKS; i++) {
            const double *p = w->disks.pos + 4 * i;
            for (int j = i + 1; j < DISKS; j++) {
                const double *q = w->disks.pos + 4 * j;
                double dx = q[0] - p[0], dy = q[1] - p[1], reach = p[3] + q[3];
                if (dx * dx + dy * dy >= reach * reach) continue;
                touching[0]++;
                if (listed(&w->group[0], i, j) < 0) fail_msg("step %d: disks %d and %d touch, not listed", k, i, j);
            }
            for (int v = 0; v < 4; v++) {
                const tr_wall *s = &w->wall[v];
                if ((p[0] - s->x) * s->nx + (p[1] - s->y) * s->ny >= p[3]) continue;
                touching[1]++;
                if (listed(&w->group[1], v, i) < 0) fail_msg("step %d: wall %d and disk %d touch, not listed", k, v, i);
            }
        }
        touched[0] += touching[0], touched[1] += touching[1];
        tr_step_advance(w);
        double fastest = 0;
        for (int i = 0; i < DISKS; i++) fastest = fmax(fastest, hypot(w->disks.vel[4 * i], w->disks.vel[4 * i + 1]));
        for (int v = 0; v < 4; v++) fastest = fmax(fastest, hypot(w->wall[v].vx, w->wall[v].vy));
        way += fastest * w->dt;
    }
    assert_true(touched[0] > STEPS * DISKS / 2 && touched[1] > STEPS * 4);    /* a packing, not a gas */
    assert_true(w->refreshes > refreshes + 20 && w->searches > searches + 3); /* both kinds of renewal */
    /* and not before a body has gone half a skin */
    double most = way / (w->thin_skin / 2) + 1;
    assert_true(most < STEPS / 2 && (double)(w->refreshes - refreshes) <= most);
    tr_biaxial_free(&b);
}

/* Two disks fly at each other and a wall at a disk, each just slow enough for the criterion to matter. */
static void test_approach_from_far_is_seen(void **state) {
    (void)state;
    for (int speed = 1; speed <= 64; speed *= 2)
        for (int wall = 0; wall < 2; wall++) {
            tr_world w;
            new_world(&w, 2);
            tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, 0.01, 1000, wall});
            tr_world_set_disk(&w, 1, &(tr_disk_start){wall ? 1 : 0.05, 0, 0, 0.01, 1000, wall});
            if (wall) w.wall[0] = (tr_wall){.x = -0.03, .nx = 1, .vx = 2e-3 * speed}, w.n_walls = 1;
            set_laws(&w, normal_spring, 0);
            w.dt = 1e-3, w.allow_unstable = true;
            if (!wall) set_velocity(&w, 0, 1e-3 * speed, 0, 0), set_velocity(&w, 1, -1e-3 * speed, 0, 0);
            for (int k = 0; k < 20000; k++) {
                forces(&w);
                double overlap = 0.02 - w.disks.pos[4] + w.disks.pos[0];
                if (wall) overlap = 0.01 + w.wall[0].x - w.disks.pos[0];
                if (overlap > 0) {
                    assert_close(w.disks.force[0], (wall ? 1 : -1) * normal_spring.k_n * overlap, 1e-12, 1e-9);
                    break;
                }
                assert_true(w.disks.force[0] == 0);
                tr_step_advance(&w);
            }
            assert_true(w.disks.force[0] != 0);
            tr_world_free(&w);
        }
}

/* What stretches with its box or its cell: 144 disks, held, follow the walls, and do not quite where `astray`, in
 * radii, is above 0. Rows come closer until they overlap by 0.1 R: gaps that were within the thin skin, beyond it,
 * beyond the wide one. */
static void stretch(bool periodic, double rows, double astray) {
    enum { ROW = 12, N = ROW * ROW, TIMES = 400 };
    const double R = 1e-3, pitch[2] = {2.2 * R, rows * R}, dt = 1e-3, time = TIMES * dt;
    const double side[2] = {ROW * pitch[0], ROW * pitch[1]};
    const double shrinks = log(1.9 / rows) / time, rate[2] = {-0.5 * shrinks, shrinks};
    tr_random random = tr_random_seed(5, 1);
    tr_world w;
    new_world(&w, N);
    double u[2 * N];
    for (int i = 0; i < N; i++) {
        double x = (i % ROW + 0.5) * pitch[0] - side[0] / 2, y = (i / ROW + 0.5) * pitch[1] - side[1] / 2;
        tr_world_set_disk(&w, i, &(tr_disk_start){x, y, 0, R, 1000, true});
        for (int k = 0; k < 2; k++) u[2 * i + k] = astray * R / time * (2 * tr_random_uniform(&random) - 1);
    }
    if (periodic) w.cell = (tr_periodic_cell){.side = {side[0], side[1]}};
    for (int v = 0; v < 4 && !periodic; v++) {
        double sign = v % 2 ? 1 : -1, at = sign * side[v < 2] / 2;
        w.wall[w.n_walls++] = v < 2 ? (tr_wall){.y = at, .ny = -sign} : (tr_wall){.x = at, .nx = -sign};
    }
    w.boxed = !periodic;
    set_laws(&w, normal_spring, 0);
    w.dt = dt, w.allow_unstable = true;
    int touched[2] = {0};
    for (int k = 0; k < TIMES; k++) {
        for (int i = 0; i < N; i++) {
            const double *p = w.disks.pos + 4 * i;
            set_velocity(&w, i, rate[0] * p[0] + u[2 * i], rate[1] * p[1] + u[2 * i + 1], 0);
        }
        for (int axis = 0; periodic && axis < 2; axis++) w.cell.rate[axis] = rate[axis] * w.cell.side[axis];
        for (int v = 0; v < w.n_walls; v++) w.wall[v].vx = rate[0] * w.wall[v].x, w.wall[v].vy = rate[1] * w.wall[v].y;
        forces(&w);
        for (int i = 0; i < N; i++) {
            const double *p = w.disks.pos + 4 * i;
            for (int j = i + 1; j < N; j++) {
                const double *q = w.disks.pos + 4 * j;
                double dx = q[0] - p[0], dy = q[1] - p[1];
                if (periodic) dx = remainder(dx, w.cell.side[0]), dy = remainder(dy, w.cell.side[1]);
                if (dx * dx + dy * dy >= 4 * R * R) continue;
                touched[0]++;
                if (listed(&w.group[0], i, j) < 0) fail_msg("step %d: disks %d and %d touch, not listed", k, i, j);
            }
            for (int v = 0; v < w.n_walls; v++) {
                const tr_wall *s = &w.wall[v];
                if ((p[0] - s->x) * s->nx + (p[1] - s->y) * s->ny >= R) continue;
                touched[1]++;
                if (listed(&w.group[1], v, i) < 0) fail_msg("step %d: wall %d and disk %d touch, not listed", k, v, i);
            }
        }
        tr_step_advance(&w);
    }
    assert_true(touched[0] > 10 * N && (periodic || touched[1] > 10 * ROW));
    /* A list lasts until disks have come closer by the skin, not until one at a wall has moved half of it: there are
     * 1/ROW as many. Half as many again, for the thin skin must fit into what is left of the wide one. */
    double closer = (rows - 1.9) * R, lists = closer / w.thin_skin, searches = closer / (w.wide_skin - w.thin_skin);
    if (astray == 0) assert_true((double)w.refreshes < 2 + 1.5 * lists && (double)w.searches < 2 + 1.5 * searches);
    tr_world_free(&w);
}

static void test_what_stretches_is_seen(void **state) {
    (void)state;
    static const double rows[] = {2.04, 2.1, 2.3, 2.605, 2.61, 2.615, 2.62, 2.7};
    for (int periodic = 0; periodic < 2; periodic++)
        for (int k = 0; k < 16; k++) stretch(periodic, rows[k / 2], k % 2 * 0.05);
}

/* ---- histories */

/* Disk 2 slides over disk 7, and disk 4 along wall 1, while 0, 1 and 3 come and go, so that the places of these pairs
 * in the list change at many renewals. Q must be k_t times the path of Vs, T k_r times that of V_r, with nothing lost;
 * and a pair that has just met starts at zero. All motions are prescribed. */
static void test_histories_follow_their_pair(void **state) {
    (void)state;
    const test_laws laws = {1e3, 0, 1e6, 2e3, 1e6, 3e3, "bagi-kuhn", NULL};
    tr_world w;
    new_world(&w, 8);
    for (int i = 0; i < 8; i++)
        tr_world_set_disk(&w, i, &(tr_disk_start){2 + 0.1 * i, 1, 0, i == 2 ? 0.02 : 0.01, 1000, true});
    double *pos = w.disks.pos;
    pos[8] = pos[9] = 0, pos[28] = 0.029, pos[29] = 0, pos[16] = 1, pos[17] = -0.991;
    w.wall[0] = (tr_wall){.y = -2, .ny = 1}, w.wall[1] = (tr_wall){.y = -1, .ny = 1, .vx = 0.2}, w.n_walls = 2;
    set_laws(&w, laws, TR_SINK_ARCS);
    w.dt = 1e-4, w.allow_unstable = true;
    set_velocity(&w, 2, 0, 0, 0.3), set_velocity(&w, 7, 0, 0.01, -0.1), set_velocity(&w, 4, 0.05, 0, 0.4);
    double Q = 0, T = 0, da = 0, db = 0, Qw = 0, Tw = 0;
    int places[2] = {0}, last[2] = {-1, -1}, fresh = 0, since_disk = 0, since_wall = 0;
    tr_random r = tr_random_seed(9, 1);
    for (int k = 0; k < 3000; k++) {
        if (k % 3 == 0) {
            int zero = (int)(2 * tr_random_uniform(&r)), three = (int)(3 * tr_random_uniform(&r));
            pos[0] = zero ? 0 : 2, pos[1] = zero ? 0.0295 : 1;        /* 0 touches 2, or nothing */
            pos[4] = zero ? 0.0193 : 2.1, pos[5] = zero ? 0.0295 : 1; /* 1 touches 0 and 7, or nothing */
            pos[12] = three == 0 ? -0.0295 : three == 1 ? 0.5 : 2.3;  /* 3 touches 2, or wall 1, or nothing */
            pos[13] = three == 0 ? 0 : three == 1 ? -0.991 : 1;
            w.stale = true;
        }
        forces(&w);
        const tr_group *g = &w.group[0], *h = &w.group[1];
        const double *Q_disks = g->hist[g->laws[TR_FRICTION].hist], *Q_walls = h->hist[h->laws[TR_FRICTION].hist];
        int i = listed(g, 2, 7), j = listed(h, 1, 4);
        assert_true(i >= 0 && j >= 0);
        places[0] += i != last[0], last[0] = i;
        places[1] += j != last[1], last[1] = j;
        /* By hand: the definitions, with the present n and t. The first call moves no history. */
        const double *p = pos + 8, *q = pos + 28;
        double dx = q[0] - p[0], dy = q[1] - p[1], L = hypot(dx, dy), Vt = -0.01 * dx / L;
        double Vs = L * (2.0 / 3 * 0.3 - 1.0 / 3 * 0.1) + Vt, s1 = 0.02 * (0.3 + Vt / L), s2 = -0.01 * (-0.1 + Vt / L);
        double dt = k ? w.dt : 0, Vw = 0.05 - 0.2 + 0.01 * 0.4;
        Q += 2e3 * Vs * dt, T += 3e3 * 0.5 * (s1 + s2) * dt, da += s1 * dt, db -= s2 * dt;
        Qw += 2e3 * Vw * dt, Tw += 3e3 * 0.5 * (0.05 - 0.2 - 0.01 * 0.4) * dt;
        /* 3000 sums */
        assert_close(Q_disks[i], Q, 1e-11, 1e-12);
        assert_close(g->hist[g->laws[TR_ROLLING].hist][i], T, 1e-11, 1e-12);
        assert_close(g->hist[g->arcs_sink.hist][i], da, 1e-11, 1e-15);
        assert_close(g->hist[g->arcs_sink.hist + 1][i], db, 1e-11, 1e-15);
        assert_close(Q_walls[j], Qw, 1e-11, 1e-12);
        assert_close(h->hist[h->laws[TR_ROLLING].hist][j], Tw, 1e-11, 1e-12);
        /* Disk 3, at rest, against 2 (arm 2/3 of 0.0295, spin 0.3) or against the wall: at most the path of the steps
         * since it came, which is also kept while it stays. */
        int m = listed(g, 2, 3), n = listed(h, 1, 3);
        since_disk = m < 0 || k == 0 ? 0 : since_disk + 1, since_wall = n < 0 || k == 0 ? 0 : since_wall + 1;
        if (m >= 0) assert_close(Q_disks[m], 2e3 * 0.0295 * 2 / 3 * 0.3 * since_disk * w.dt, 1e-9, 1e-12);
        if (n >= 0) assert_close(Q_walls[n], -2e3 * 0.2 * since_wall * w.dt, 1e-9, 1e-12);
        fresh += since_disk == 1;
        tr_step_advance(&w);
    }
    assert_true(places[0] > 200 && places[1] > 200 && fresh > 100); /* they did move about in the list */
    tr_world_free(&w);
}

/* A floor with 120 sliding disks; then 480 more land at once, each before one of the old ones in the list, so that the
 * arrays grow while histories are carried over. */
static void test_histories_survive_growth(void **state) {
    (void)state;
    enum { ALL = 600 };
    tr_world w;
    new_world(&w, ALL);
    for (int i = 0; i < ALL; i++)
        tr_world_set_disk(&w, i, &(tr_disk_start){0.03 * i, i % 5 == 4 ? 0.0099 : 1, 0, 0.01, 1000, true}),
            set_velocity(&w, i, 0.2, 0, 0);
    w.wall[0] = (tr_wall){.ny = 1}, w.n_walls = 1;
    set_laws(&w, (test_laws){1e3, 0, 1e6, 2e3, 1e6, 3e3, "bagi-kuhn", NULL}, 0);
    w.dt = 1e-4, w.allow_unstable = true;
    steps(&w, 11); /* the first moves no history */
    for (int i = 0; i < ALL; i++) w.disks.pos[4 * i + 1] = 0.0099;
    w.stale = true;
    forces(&w);
    const tr_group *g = &w.group[1];
    assert_int_equal(g->n, ALL);
    for (int i = 0; i < ALL; i++) { /* t = (1, 0): Vs = 0.2, V_r = 0.1; 11 sums */
        double path = w.dt * (i % 5 == 4 ? 11 : 1);
        assert_int_equal(g->b[i], i);
        assert_close(g->hist[g->laws[TR_FRICTION].hist][i], 2e3 * 0.2 * path, 1e-13, 0);
        assert_close(g->hist[g->laws[TR_ROLLING].hist][i], 3e3 * 0.1 * path, 1e-13, 0);
        assert_close(w.disks.force[4 * i + 1], 1e3 * 0.0001, 1e-12, 1e-15 * 1e3); /* difference of numbers 0.01 */
        assert_true(g->pair[0][i] == 0 && g->pair[1][i] == 0.01 && g->pair[2][i] == 1);
    }
    tr_world_free(&w);
}

/* A wall crushes a disk while the list of disks changes: who looks at the state still finds contacts with their own
 * radii and histories. */
static void test_a_failed_renewal_leaves_the_lists(void **state) {
    (void)state;
    tr_world w;
    tr_status st = {0};
    new_world(&w, 4);
    for (int i = 0; i < 4; i++) tr_world_set_disk(&w, i, &(tr_disk_start){0.1 * i, 0, 0, 0.01 + 0.001 * i, 1000, true});
    double *pos = w.disks.pos;
    pos[8] = pos[4] + 0.0229, pos[12] = pos[8] + 0.0249; /* 1-2, 2-3 */
    w.wall[0] = (tr_wall){.y = -1, .ny = 1}, w.n_walls = 1;
    set_laws(&w, (test_laws){1e3, 0, 1e6, 2e3, 1e6, 3e3, "bagi-kuhn", NULL}, 0);
    w.dt = 1e-4, w.allow_unstable = true;
    set_velocity(&w, 3, 0, 0, 1);
    steps(&w, 3);
    const tr_group *g = &w.group[0];
    double Q = g->hist[g->laws[TR_FRICTION].hist][listed(g, 2, 3)];
    assert_true(Q != 0);
    pos[0] = pos[4] - 0.0209, pos[1] = 0; /* 0-1 would come first */
    w.wall[0].y = -0.001, w.stale = true;
    assert_false(tr_step_forces(&w, &st));
    assert_non_null(strstr(st.text, "contact of wall 0 with disk"));
    for (int i = 0; i < g->n; i++) {
        assert_true(g->pair[0][i] == pos[4 * g->a[i] + 3] && g->pair[1][i] == pos[4 * g->b[i] + 3]);
        assert_true(g->hist[g->laws[TR_FRICTION].hist][i] == (g->a[i] == 2 ? Q : 0));
    }
    tr_world_free(&w);
}

/* ---- the same bits */

static void test_skins_do_not_matter(void **state) {
    (void)state;
    static const double thin[] = {0.5, 2}, wide[] = {0.7, 1.5};
    tr_scene scene = small_scene(3);
    tr_biaxial b, c;
    sheared(&b, &scene);
    int64_t before = b.world.refreshes;
    shear_steps(&b, STEPS);
    for (int k = 0; k < 2; k++) {
        sheared(&c, &scene);
        assert_int_equal(c.world.refreshes, before);
        c.world.thin_skin *= thin[k], c.world.wide_skin *= wide[k];
        shear_steps(&c, STEPS);
        assert_int_not_equal(c.world.refreshes, b.world.refreshes);
        assert_same_bits(&b.world, &c.world);
        tr_biaxial_free(&c);
    }
    tr_biaxial_free(&b);
}

static void replace_finder(tr_world *w, const tr_broad_finder *finder) {
    tr_status st = {0};
    w->broad->destroy(w->finder);
    w->broad = finder;
    w->finder = finder->create(&(tr_broad_input){w->disks.n, w->disks.pos, w->wide_skin, NULL, NULL}, &st);
    if (!w->finder) fail_msg("%s", st.text);
}

static void test_finders_give_the_same_bits(void **state) {
    (void)state;
    tr_scene scene = small_scene(4);
    tr_biaxial b, c;
    sheared(&b, &scene), sheared(&c, &scene);
    assert_ptr_equal(b.world.broad, &tr_broad_box2d);
    replace_finder(&c.world, &tr_broad_brute);
    shear_steps(&b, STEPS), shear_steps(&c, STEPS);
    assert_true(b.world.searches > 5 && c.world.searches == b.world.searches);
    assert_same_bits(&b.world, &c.world);
    tr_biaxial_free(&b), tr_biaxial_free(&c);
}

static void test_two_worlds_side_by_side(void **state) {
    (void)state;
    tr_scene one = small_scene(5), two = small_scene(6);
    two.contact = contact_of((test_laws){80e6, 0.1, 0.3, 40e6, 0, 0, NULL, NULL});
    tr_biaxial alone, b, c;
    sheared(&alone, &one);
    shear_steps(&alone, STEPS);
    sheared(&b, &one), sheared(&c, &two);
    for (int k = 0; k < STEPS; k++) shear_steps(&b, 1), shear_steps(&c, 1);
    assert_same_bits(&alone.world, &b.world);
    tr_biaxial_free(&alone), tr_biaxial_free(&b), tr_biaxial_free(&c);
}

static void test_seeds(void **state) {
    (void)state;
    tr_scene one = small_scene(7), two = small_scene(8);
    tr_biaxial a, b, c;
    sheared(&a, &one), sheared(&b, &one), sheared(&c, &two);
    shear_steps(&a, 1000), shear_steps(&b, 1000), shear_steps(&c, 1000);
    assert_same_bits(&a.world, &b.world);
    assert_memory_not_equal(a.world.disks.pos, c.world.disks.pos, DISKS * 4 * sizeof(double));
    tr_biaxial_free(&a), tr_biaxial_free(&b), tr_biaxial_free(&c);
}

static void test_looking_changes_nothing(void **state) {
    (void)state;
    tr_scene scene = small_scene(9);
    tr_biaxial b, c;
    sheared(&b, &scene), sheared(&c, &scene);
    tr_record *records = NULL;
    int capacity = 0;
    for (int k = 0; k < STEPS; k++) {
        shear_steps(&b, 1);
        shear_forces(&c);
        if (k % 7 == 0) {
            tr_status st = {0};
            int64_t updates = c.world.contact_updates;
            int n = tr_record_all(&c.world, &records, &capacity, &st);
            assert_true(n > DISKS && st.code == TR_OK);
            assert_int_equal(c.world.contact_updates, updates);
        }
        tr_step_advance(&c.world);
    }
    assert_same_bits(&b.world, &c.world);
    for (int k = 0; k < 2; k++) {
        const tr_group *g = &b.world.group[k], *h = &c.world.group[k];
        assert_int_equal(g->n, h->n);
        for (int s = 0; s < g->n_hist; s++) assert_memory_equal(g->hist[s], h->hist[s], (size_t)g->n * sizeof(double));
    }
    assert_true(b.world.ledger->friction == c.world.ledger->friction && b.world.ledger->work == c.world.ledger->work);
    free(records);
    tr_biaxial_free(&b), tr_biaxial_free(&c);
}

/* Forces are of this instant, however often they are asked for: with a load and without, before and after a step. */
static void test_forces_do_not_add_up(void **state) {
    (void)state;
    for (int load = 0; load < 2; load++) {
        tr_world w;
        new_world(&w, 2);
        for (int i = 0; i < 2; i++) tr_world_set_disk(&w, i, &(tr_disk_start){0.0199 * i, 0, 0, 0.01, 1000, true});
        if (load) set_gravity(&w, 1, 0);
        set_laws(&w, normal_spring, 0);
        w.dt = 1e-4, w.allow_unstable = true;
        for (int k = 0; k < 4; k++) {
            forces(&w);
            double push = normal_spring.k_n * 0.0001,
                   weight = load * w.disks.mass[0]; /* a difference of numbers 0.02 */
            assert_close(w.disks.force[0], weight - push, 1e-12, 1e-9);
            assert_close(w.disks.force[4], weight + push, 1e-12, 1e-9);
            if (k == 1) tr_step_advance(&w); /* held: nothing moves */
        }
        tr_world_free(&w);
    }
}

/* What is recorded is what acts: the forces of the records add up to those on the disks. */
static void test_records_are_the_forces(void **state) {
    (void)state;
    tr_scene scene = small_scene(10);
    tr_biaxial b;
    sheared(&b, &scene);
    shear_steps(&b, 2000), shear_forces(&b);
    tr_record *records = NULL;
    int capacity = 0;
    tr_status st = {0};
    int n = tr_record_all(&b.world, &records, &capacity, &st);
    double sum[DISKS][3] = {{0}}, largest = 0;
    for (int i = 0; i < n; i++) {
        const tr_record *c = &records[i];
        double fx = c->f_n * c->nx - c->f_t * c->ny, fy = c->f_n * c->ny + c->f_t * c->nx;
        double r1 = c->R1 * (1 - c->delta / (c->R1 + c->R2)), r2 = c->R2 * (1 - c->delta / (c->R1 + c->R2));
        if (c->a < 0) r2 = c->R2;
        largest = fmax(largest, hypot(fx, fy));
        sum[c->b][0] += fx, sum[c->b][1] += fy, sum[c->b][2] += c->m2 - r2 * c->f_t;
        const double *q = b.world.disks.pos + 4 * c->b;
        assert_close(hypot(c->x - q[0], c->y - q[1]), r2, 1e-12, 0);
        if (c->a >= 0) sum[c->a][0] -= fx, sum[c->a][1] -= fy, sum[c->a][2] += c->m1 - r1 * c->f_t;
        assert_true(c->mobilisation >= 0 && c->mobilisation <= 1 && c->rolling_mobilisation <= 1 + 1e-15);
        assert_true(c->v_r == c->v_r_by[b.world.rolling_velocity]);
    }
    assert_true(st.code == TR_OK && n > DISKS && largest > 0);
    for (int i = 0; i < DISKS; i++)
        for (int k = 0; k < 3; k++) /* a handful of terms */
            assert_close(b.world.disks.force[4 * i + k], sum[i][k], 0, 1e-13 * largest * (k == 2 ? 1e-3 : 1));
    free(records);
    tr_biaxial_free(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_touching_pair_is_missed), cmocka_unit_test(test_approach_from_far_is_seen),
        cmocka_unit_test(test_what_stretches_is_seen),     cmocka_unit_test(test_histories_follow_their_pair),
        cmocka_unit_test(test_histories_survive_growth),   cmocka_unit_test(test_a_failed_renewal_leaves_the_lists),
        cmocka_unit_test(test_skins_do_not_matter),        cmocka_unit_test(test_finders_give_the_same_bits),
        cmocka_unit_test(test_two_worlds_side_by_side),    cmocka_unit_test(test_seeds),
        cmocka_unit_test(test_forces_do_not_add_up),       cmocka_unit_test(test_looking_changes_nothing),
        cmocka_unit_test(test_records_are_the_forces),
    };
    return cmocka_run_group_tests_name("contacts", tests, NULL, NULL);
}
