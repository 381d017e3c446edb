/* SPDX-License-Identifier: MIT */
/* The bound on the step. References: the largest eigenvalue of the whole network, assembled here from the definitions
 * of the contact velocities and found by power iteration (it converges from below, so that 2/sqrt(lambda) is at or
 * above the exact bound); and leapfrog itself just below and just above the bound. */
#include "core/worlds.h"

/* ---- the exact bound: lambda_max of M^-1/2 K M^-1/2 */

/* One elastic coordinate of a contact: stiffness, and what it reads of the displacements of a and of b (x, y, angle).
 */
typedef struct row {
    double k, a[3], b[3];
    int ia, ib; /* numbers of the bodies; walls come after the disks */
} row;

typedef struct network {
    int n_rows, n_bodies;
    row *rows;
    double *inv_root; /* n_bodies*3: 1/sqrt of mass, mass, inertia; 0 where held */
} network;

static network network_of(const tr_world *w, test_laws p) {
    network net = {.n_bodies = w->disks.n + w->n_walls};
    net.rows = calloc((size_t)(w->group[0].n + w->group[1].n) * 3, sizeof(row));
    net.inv_root = calloc((size_t)net.n_bodies * 3, sizeof(double));
    for (int i = 0; i < w->disks.n; i++) {
        double m = w->disks.mass[i], R = w->disks.pos[4 * i + 3];
        net.inv_root[3 * i] = net.inv_root[3 * i + 1] = 1 / sqrt(m), net.inv_root[3 * i + 2] = 1 / sqrt(m * R * R / 2);
    }
    for (int v = 0; v < w->n_walls; v++) /* a piston moves along its normal alone: lane 0 */
        if (w->wall[v].mass > 0) net.inv_root[3 * (w->disks.n + v)] = 1 / sqrt(w->wall[v].mass);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < w->group[k].n; i++) {
            const tr_group *g = &w->group[k];
            const double *q = w->disks.pos + 4 * g->b[i];
            double nx, ny, L, R1 = 0, R2 = q[3], r1, r2, R_eff;
            int ia = g->a[i], ib = g->b[i];
            if (g->walls) {
                const tr_wall *v = &w->wall[ia];
                nx = v->nx, ny = v->ny, L = (q[0] - v->x) * nx + (q[1] - v->y) * ny;
                r1 = 0, r2 = R2, R_eff = R2, ia += w->disks.n;
                if (L >= R2) continue;
            } else {
                const double *c = w->disks.pos + 4 * ia;
                L = hypot(q[0] - c[0], q[1] - c[1]), nx = (q[0] - c[0]) / L, ny = (q[1] - c[1]) / L, R1 = c[3];
                r1 = R1 * L / (R1 + R2), r2 = L - r1, R_eff = R1 * R2 / (R1 + R2);
                if (L >= R1 + R2) continue;
            }
            double tx = ny, ty = -nx;
            row normal = {p.k_n, {-nx, -ny, 0}, {nx, ny, 0}, ia, ib};
            row slide = {p.mu > 0 ? p.k_t : 0, {-tx, -ty, r1}, {tx, ty, r2}, ia, ib};
            row roll = {p.mu_r > 0 ? p.k_r : 0, {0, 0, R_eff}, {0, 0, -R_eff}, ia, ib};
            if (g->walls) { /* displacement of the piston along n */
                normal.a[0] = -1, normal.a[1] = 0;
                memset(slide.a, 0, sizeof slide.a), memset(roll.a, 0, sizeof roll.a);
            }
            net.rows[net.n_rows++] = normal, net.rows[net.n_rows++] = slide, net.rows[net.n_rows++] = roll;
        }
    return net;
}

static double exact_bound(const tr_world *w, test_laws p) {
    network net = network_of(w, p);
    int n = 3 * net.n_bodies;
    double *x = calloc((size_t)n, sizeof *x), *y = calloc((size_t)n, sizeof *y), lambda = 0;
    tr_random r = tr_random_seed(1, 1);
    for (int i = 0; i < n; i++) x[i] = (tr_random_uniform(&r) - 0.5) * (net.inv_root[i] > 0);
    for (int it = 0; it < 4000; it++) {
        double xx = 0, xy = 0, yy = 0;
        memset(y, 0, (size_t)n * sizeof *y);
        for (int i = 0; i < net.n_rows; i++) {
            const row *q = &net.rows[i];
            double d = 0;
            for (int k = 0; k < 3; k++)
                d += q->a[k] * net.inv_root[3 * q->ia + k] * x[3 * q->ia + k] +
                     q->b[k] * net.inv_root[3 * q->ib + k] * x[3 * q->ib + k];
            for (int k = 0; k < 3; k++) {
                y[3 * q->ia + k] += q->k * d * q->a[k] * net.inv_root[3 * q->ia + k];
                y[3 * q->ib + k] += q->k * d * q->b[k] * net.inv_root[3 * q->ib + k];
            }
        }
        for (int i = 0; i < n; i++) xx += x[i] * x[i], xy += x[i] * y[i], yy += y[i] * y[i];
        lambda = xy / xx;
        for (int i = 0; i < n; i++) x[i] = y[i] / sqrt(yy);
    }
    free(x), free(y), free(net.rows), free(net.inv_root);
    return 2 / sqrt(lambda);
}

/* ---- networks */

/* Rows and columns of disks of radius 1 cm, hexagonal or square, overlapping by 1e-4 R; held by walls on all sides if
 * walls. */
static void new_lattice(tr_world *w, int columns, int rows, bool hexagonal, bool walls, test_laws laws) {
    const double R = 0.01, d = 2 * R * (1 - 0.5e-4), up = hexagonal ? d * sqrt(3) / 2 : d;
    new_world(w, columns * rows);
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++)
            tr_world_set_disk(w, j * columns + i, &(tr_disk_start){i * d + (hexagonal && j % 2 ? d / 2 : 0), j * up, 0, R, 1000, false});
    if (walls) {
        double edge = d / 2;
        tr_wall box[4] = {{.x = -edge, .nx = 1},
                          {.x = (columns - 1) * d + edge, .nx = -1},
                          {.y = -edge, .ny = 1},
                          {.y = (rows - 1) * d + edge, .ny = -1}};
        for (int k = 0; k < (rows > 1 ? 4 : 2); k++) w->wall[w->n_walls++] = box[k];
    }
    set_laws(w, laws, 0);
    w->dt = 1e-9;
    forces(w);
}

static void compare(const char *what, const tr_world *w, test_laws laws, double least) {
    double bound = tr_timestep_contacts(w).dt, exact = exact_bound(w, laws), worst = tr_timestep_worst(w);
    print_message("%s: bound/exact %.3f, worst/exact %.3f\n", what, bound / exact, worst / exact);
    assert_true(bound <= exact * (1 + 1e-12)); /* roundings of the power iteration */
    assert_true(bound >= least * exact);
    assert_true(worst <= bound * (1 + 1e-12));
}

static const test_laws normal_only = {.k_n = 1e6}, all = {1e6, 0, 0.5, 0.5e6, 0.5, 0.5e6, "wang", NULL},
                       soft_normal = {1e5, 0, 0.5, 1e6, 0.5, 1e6, "wang", NULL};

static void test_lattices(void **state) {
    (void)state;
    static const struct {
        const char *name;
        test_laws laws;
    } with[] = {{"normal", {.k_n = 1e6}},
                {"all", {1e6, 0, 0.5, 0.5e6, 0.5, 0.5e6, "wang", NULL}},
                {"stiff tangential", {1e5, 0, 0.5, 1e6, 0.5, 1e6, "wang", NULL}},
                {"stiff rolling", {1e5, 0, 0.5, 1e5, 0.5, 1e6, "wang", NULL}}};
    for (int k = 0; k < 4; k++)
        for (int walls = 0; walls < 2; walls++) {
            char name[80];
            tr_world w;
            /* a chain with normal forces alone: equal but for the ends of 40 disks, (pi/80)^2/8 = 2e-4 */
            new_lattice(&w, 40, 1, false, walls, with[k].laws);
            snprintf(name, sizeof name, "chain, %s%s", with[k].name, walls ? ", walls" : "");
            compare(name, &w, with[k].laws, k == 0 ? 0.998 : 0.5);
            tr_world_free(&w);
            new_lattice(&w, 7, 7, false, walls, with[k].laws);
            snprintf(name, sizeof name, "square, %s%s", with[k].name, walls ? ", walls" : "");
            compare(name, &w, with[k].laws, 0.5);
            tr_world_free(&w);
            if (walls) continue;
            new_lattice(&w, 7, 7, true, false, with[k].laws);
            snprintf(name, sizeof name, "hexagonal, %s", with[k].name);
            compare(name, &w, with[k].laws, 0.5);
            tr_world_free(&w);
        }
}

/* A single pair is one contact with all of its masses: exact for every mode, whatever the radii. */
static void test_one_pair_is_exact(void **state) {
    (void)state;
    static const double radii[] = {0.01, 0.005, 0.001};
    const test_laws *laws[] = {&normal_only, &all, &soft_normal};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            tr_world w;
            new_world(&w, 2);
            tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, 0.01, 1000, false});
            tr_world_set_disk(&w, 1, &(tr_disk_start){0.6 * (0.01 + radii[i]) * (1 - 1e-9), 0.8 * (0.01 + radii[i]), 0, radii[i], 1000, false});
            set_laws(&w, *laws[k], 0);
            w.dt = 1e-12;
            forces(&w);
            /* power iteration: 4000 rounds over gaps of at least a percent; overlap 1e-9 */
            assert_close(tr_timestep_contacts(&w).dt, exact_bound(&w, *laws[k]), 1e-8, 0);
            tr_world_free(&w);
        }
}

static void test_random_packings(void **state) {
    (void)state;
    for (int wide = 0; wide < 2; wide++)
        for (int pistons = 0; pistons < 2; pistons++)
            for (int k = 0; k < 2; k++) {
                test_laws laws = sand;
                if (k) laws.k_t = laws.k_r = 2 * laws.k_n;
                tr_scene scene = biaxial_scene(wide ? 60 : 100, 3, laws);
                scene.shear.walls = 1;
                if (wide) scene.sample.r_min = scene.sample.r_max / 10;
                scene.compaction.unbalanced = 0.01;
                tr_biaxial b;
                compact(&b, &scene);
                for (int v = 0; v < 4 && !pistons; v++) b.world.wall[v].mass = 0;
                laws.damping_ratio = 0;
                set_laws(&b.world, laws, 0);
                b.world.dt = 1e-12;
                forces(&b.world);
                char name[80];
                snprintf(name, sizeof name, "radii 1:%d%s%s", wide ? 10 : 2, pistons ? ", pistons" : "",
                         k ? ", stiff tangential" : "");
                compare(name, &b.world, laws, 0.5);
                tr_biaxial_free(&b);
            }
}

/* tr_timestep_worst promises a bound for any packing of the disks: so for every pair, whatever its radii and whichever
 * mode is stiffest. */
static void test_worst_covers_every_pair(void **state) {
    (void)state;
    tr_random r = tr_random_seed(8, 1);
    double largest = 0;
    test_laws worst_laws = {0};
    double worst_ratio = 0;
    for (int k = 0; k < 3000; k++) {
        double k_n = 1e6, ratio = pow(10, 1.5 * tr_random_uniform(&r)), zeta = 2 * tr_random_uniform(&r);
        test_laws laws = {k_n,   k % 2 ? zeta : 0,
                          0.5,   k_n * pow(10, 4 * tr_random_uniform(&r) - 2),
                          0.5,   k_n * pow(10, 4 * tr_random_uniform(&r) - 2),
                          "wang", NULL};
        double R = 0.01 / ratio;
        tr_world w;
        new_world(&w, 2);
        tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, 0.01, 1000, k % 3 == 0});
        tr_world_set_disk(&w, 1, &(tr_disk_start){0.01 + R * 0.999999, 0, 0, R, 1000, false});
        set_laws(&w, laws, 0);
        w.dt = 1e-15;
        forces(&w);
        double share = tr_timestep_worst(&w) / tr_timestep_contacts(&w).dt;
        if (share > largest) largest = share, worst_laws = laws, worst_ratio = ratio;
        tr_world_free(&w);
    }
    if (!(largest <= 1 + 1e-12))
        fail_msg("worst/contacts = %.4f for radii 1:%.3g, k_n %.3g, k_t %.3g, k_r %.3g, damping ratio %.2g", largest,
                 worst_ratio, worst_laws.k_n, worst_laws.k_t, worst_laws.k_r, worst_laws.damping_ratio);
}

/* ---- leapfrog itself */

/* Growth of a tiny disturbance of a pressed chain between walls in 20000 steps of share * bound. */
static double growth(double zeta, double share) {
    enum { N = 24 };
    const double R = 0.01, lap = 0.01 * R, tiny = 1e-9;
    test_laws laws = {.k_n = 1e6, .damping_ratio = zeta};
    tr_world w;
    new_world(&w, N);
    for (int i = 0; i < N; i++) tr_world_set_disk(&w, i, &(tr_disk_start){(R - lap) + i * (2 * R - lap), 0, 0, R, 1000, false});
    w.wall[0] = (tr_wall){.nx = 1}, w.wall[1] = (tr_wall){.x = 2 * (R - lap) + (N - 1) * (2 * R - lap), .nx = -1};
    w.n_walls = 2;
    set_laws(&w, laws, 0);
    w.dt = 1e-9;
    forces(&w);
    w.dt = share * tr_timestep_contacts(&w).dt;
    w.allow_unstable = true;
    tr_random r = tr_random_seed(2, 1);
    for (int i = 0; i < N; i++) set_velocity(&w, i, tiny * (tr_random_uniform(&r) - 0.5), 0, 0);
    double largest = 0;
    for (int k = 0; k < 20000 && largest < 1e4 * tiny; k++) {
        tr_status st = {0};
        if (!tr_step_forces(&w, &st)) break;
        tr_step_advance(&w);
        for (int i = 0; i < N; i++) largest = fmax(largest, fabs(w.disks.vel[4 * i]));
    }
    tr_world_free(&w);
    return largest / tiny;
}

/* A chain of 24 in walls has its highest mode 0.2 % below that of an endless one, on which the bound is exact; with
 * strong dashpots this is 0.4 % of the step. */
static void test_leapfrog_on_a_chain(void **state) {
    (void)state;
    static const double zeta[] = {0, 0.1, 0.3, 1};
    for (int i = 0; i < 4; i++) {
        double below = growth(zeta[i], 0.99), above = growth(zeta[i], 1.02);
        print_message("chain, damping ratio %.1f: growth %.1f at 0.99 of the bound, %.1g at 1.02\n", zeta[i], below,
                      above);
        /* Near the bound a mode may swing to 1/sqrt(1 - 0.99^2) = 7 times of where it started, times sqrt(24). */
        assert_true(below < 35);
        assert_true(above >= 1e4);
    }
}

/* Kinetic energy of the disks that others hold; free ones keep theirs. */
static double held_energy(const tr_world *w) {
    double e = 0;
    for (int i = 0; i < w->disks.n; i++) {
        const double *v = w->disks.vel + 4 * i, R = w->disks.pos[4 * i + 3];
        if (w->disks.coordination[i] > 1)
            e += 0.5 * w->disks.mass[i] * (v[0] * v[0] + v[1] * v[1] + 0.5 * R * R * v[2] * v[2]);
    }
    return e;
}

/* All laws on a random packing under pressure: at the bound of its contacts it stays at rest. */
static void test_leapfrog_on_a_packing(void **state) {
    (void)state;
    tr_scene scene = biaxial_scene(100, 5, sand);
    tr_biaxial b;
    compact(&b, &scene);
    begin_shear(&b);
    for (int v = 0; v < 4; v++) b.world.wall[v].mass = b.world.wall[v].vx = b.world.wall[v].vy = 0;
    b.world.dt *= 0.5;
    steps(&b.world, 2000);
    b.world.dt = 0.98 * tr_timestep_contacts(&b.world).dt; /* 2 %: an overlap more changes nothing, a contact would */
    b.world.allow_unstable = true;
    double before, after;
    before = held_energy(&b.world);
    steps(&b.world, 20000);
    after = held_energy(&b.world);
    print_message("packing: kinetic energy %.2g N, after 20000 steps at 0.98 of the bound %.2g\n", before, after);
    assert_true(before > 0 && after < before);
    tr_biaxial_free(&b);
}

/* ---- what a case hears */

static void expect_failure(tr_world *w, tr_code code, const char *const *words) {
    tr_status st = {0};
    bool ok = tr_step_forces(w, &st);
    for (int k = 0; ok && k < 200; k++) {
        tr_step_advance(w);
        ok = tr_step_forces(w, &st);
    }
    assert_false(ok);
    assert_int_equal(st.code, code);
    for (; *words; words++)
        if (!strstr(st.text, *words)) fail_msg("`%s` does not say `%s`", st.text, *words);
}

static void test_step_above_the_bound_is_named(void **state) {
    (void)state;
    tr_world w;
    new_lattice(&w, 5, 1, false, false, normal_only);
    w.disks.pos[4 * 4] += 1; /* disk 4 is off; the ends have fewer contacts: 1-2 sets the bound */
    w.stale = true;
    forces(&w);
    double bound = tr_timestep_contacts(&w).dt;
    for (int k = 0; k < 7; k++) tr_step_advance(&w);
    w.dt = 1.01 * bound, w.stale = true;
    expect_failure(&w, TR_NUMERICAL, (const char *[]){"disks 1 and 2", "step 7", "time", "stability bound", NULL});
    w.allow_unstable = true;
    forces(&w);
    tr_world_free(&w);

    tr_status st = {0};
    new_lattice(&w, 5, 1, false, false, normal_only);
    double given = 1.01 * tr_timestep_worst(&w), told;
    assert_false(tr_timestep_choose(&w, &(tr_scene_step){.dt = given}, 0, &told, &st));
    assert_int_equal(st.code, TR_BAD_CASE);
    assert_non_null(strstr(st.text, "bound"));
    st = (tr_status){0};
    assert_true(tr_timestep_choose(&w, &(tr_scene_step){.dt = given, .allow_unstable = true}, 0, &told, &st));
    assert_true(w.dt == given && w.allow_unstable);
    assert_true(tr_timestep_choose(&w, &(tr_scene_step){.safety = 0.25}, 0, &told, &st));
    assert_close(w.dt, 0.25 * tr_timestep_worst(&w), 1e-15, 0);
    tr_world_free(&w);
}

/* A step that is stable in any packing of the disks: pistons are looked at all the same. m is the disk's mass, M the
 * piston's; the disk has one contact, and in any packing of two bodies no more. */
static void test_a_light_piston_is_named(void **state) {
    (void)state;
    for (int light = 0; light < 2; light++) {
        tr_world w;
        new_world(&w, 1);
        tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, 0.01, 1000, false});
        double m = w.disks.mass[0], M = light ? m / 9 : 9 * m;
        w.wall[0] = (tr_wall){.x = -0.00999, .nx = 1, .mass = M}, w.n_walls = 1;
        set_laws(&w, normal_only, 0);
        double held = tr_timestep_worst(&w), bound = 2 / sqrt(normal_only.k_n * (1 / m + 1 / M));
        assert_close(held, 2 / sqrt(normal_only.k_n / m), 1e-12, 0);
        w.dt = 0.5 * held;
        if (light) {
            assert_true(w.dt > bound);
            expect_failure(&w, TR_NUMERICAL, (const char *[]){"wall 0 with disk 0", "stability bound", NULL});
        } else {
            forces(&w);
            assert_true(w.dt <= w.sure_dt && tr_timestep_sure(&w));
        }
        tr_world_free(&w);
    }
}

/* What may come is not left out because of what is: the two free disks, neither smallest nor largest, do not touch yet,
 * and the others, which they might, are held; facets of a bowl may all touch a disk. m: of a free disk, z: contacts
 * that it may have. */
static void test_sure_of_what_may_come(void **state) {
    (void)state;
    for (int bowl = 0; bowl < 2; bowl++) {
        tr_world w;
        new_world(&w, bowl ? 1 : 4);
        tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, 0.01, 1000, false});
        double m = w.disks.mass[0], z = bowl ? 12 : 3;
        for (int i = 1; i < w.disks.n; i++)
            tr_world_set_disk(&w, i, &(tr_disk_start){i, 0, 0, (double[]){0.01, 0.005, 0.02}[i - 1], 1000, i > 1});
        for (int k = 0; bowl && k < 12; k++)
            w.wall[w.n_walls++] = (tr_wall){.x = -0.02 * cos(k), .y = -0.02 * sin(k), .nx = cos(k), .ny = sin(k)};
        set_laws(&w, normal_only, 0);
        double bound = 2 / sqrt(normal_only.k_n * (bowl ? z / m : 2 * z / m));
        w.dt = 0.99 * bound;
        assert_true(tr_timestep_sure(&w));
        w.dt = 1.01 * bound;
        assert_false(tr_timestep_sure(&w));
        tr_world_free(&w);
    }
}

static void test_not_finite_is_named(void **state) {
    (void)state;
    for (int lane = 0; lane < 3; lane++)
        for (int kind = 0; kind < 2; kind++)
            for (int later = 0; later < 2; later++) {
                tr_world w;
                new_lattice(&w, 5, 9, false, false, all);
                w.disks.pos[4 * 44 + 1] += 1; /* this one is free: nothing but itself makes the list stale */
                w.stale = true;
                if (later) steps(&w, 3);
                w.disks.vel[4 * 44 + lane] = kind ? INFINITY : NAN;
                if (lane == 2) w.stale = true; /* a spin moves no centre */
                expect_failure(&w, TR_NUMERICAL, (const char *[]){"disk 44", "step", "time", NULL});
                tr_world_free(&w);
            }
}

/* The same when the centre goes while the broad phase has to be asked. */
static void test_not_finite_in_the_search_is_named(void **state) {
    (void)state;
    tr_world w;
    new_lattice(&w, 5, 9, false, false, all);
    w.disks.pos[4 * 7 + 1] = NAN;
    w.disks.pos[4 * 44 + 1] += 1; /* further than the wide skin */
    w.stale = true;
    expect_failure(&w, TR_NUMERICAL, (const char *[]){"disk 7", "step", "time", NULL});
    tr_world_free(&w);
}

static void test_overlap_is_named(void **state) {
    (void)state;
    tr_world w;
    new_lattice(&w, 3, 1, false, true, normal_only);
    w.disks.pos[4 * 2] -= 0.31 * 0.01, w.stale = true;
    expect_failure(&w, TR_NUMERICAL, (const char *[]){"disks 1 and 2", "overlap", "step", "time", NULL});
    tr_world_free(&w);
    new_lattice(&w, 1, 1, false, true, normal_only);
    w.disks.pos[0] += 0.31 * 0.01, w.stale = true;
    expect_failure(&w, TR_NUMERICAL, (const char *[]){"wall 1", "disk 0", "overlap", "step", "time", NULL});
    tr_world_free(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lattices),
        cmocka_unit_test(test_one_pair_is_exact),
        cmocka_unit_test(test_random_packings),
        cmocka_unit_test(test_worst_covers_every_pair),
        cmocka_unit_test(test_leapfrog_on_a_chain),
        cmocka_unit_test(test_leapfrog_on_a_packing),
        cmocka_unit_test(test_step_above_the_bound_is_named),
        cmocka_unit_test(test_a_light_piston_is_named),
        cmocka_unit_test(test_sure_of_what_may_come),
        cmocka_unit_test(test_not_finite_is_named),
        cmocka_unit_test(test_not_finite_in_the_search_is_named),
        cmocka_unit_test(test_overlap_is_named),
    };
    return cmocka_run_group_tests_name("timestep", tests, NULL, NULL);
}
