/* SPDX-License-Identifier: MIT */
/* Periodic cells. References: closed forms of lattices and of a gas, the same bodies in the open plane (which has no
 * cell code), invariance under shift, drift and tiling, conserved momentum. */
#include "core/cell.h"
#include "core/contacts.h"
#include "core/ledger.h"
#include "core/pipeline.h"
#include "core/record.h"
#include "core/worlds.h"

static void new_cell(tr_world *w, int n, double width, double height) {
    new_world(w, n);
    w->cell.side[0] = width, w->cell.side[1] = height;
}

/* ---- two disks ---- */

enum { HISTORY = 3 }; /* more than the laws of `sand` keep: friction 1, rolling 1 */

typedef struct pair_state {
    double x, y, vx, vy, w1, w2, fx, fy, torque, x_contact, y_contact, hist[HISTORY];
} pair_state;

/* Disks that touch, strike, slide and roll on each other while they drift. In a cell their way leads through its edges
 * and corners, at another phase for each (x0, y0). */
static pair_state strike(bool cell, double x0, double y0, int n_steps, int64_t *wraps) {
    tr_world w;
    const double D = 0.02;
    if (cell)
        new_cell(&w, 2, 0.06, 0.08);
    else
        new_world(&w, 2);
    tr_world_set_disk(&w, 0, &(tr_disk_start){x0, y0, 0, 0.5 * D, 1000, false});
    tr_world_set_disk(&w, 1, &(tr_disk_start){x0 + 0.8 * D, y0 + 0.599 * D, 0, 0.5 * D, 1000, false});
    set_velocity(&w, 0, 6.0, 7.3, 5), set_velocity(&w, 1, 5.97, 7.28, -2);
    set_gravity(&w, 0, 0); /* then pressed together */
    for (int k = 0; k < 2; k++) w.disks.load[4 * k] = k ? -16 : 16, w.disks.load[4 * k + 1] = k ? -12 : 12;
    set_laws(&w, (test_laws){1e6, 0.05, 0.3, 0.5e6, 0.2, 0.5e6, "wang", NULL}, 0);
    w.dt = 0.1 * tr_timestep_worst(&w);
    double before = 0;
    for (int k = 0; k < n_steps; k++) {
        before = w.disks.pos[0];
        forces(&w);
        *wraps += w.disks.pos[0] < before - 0.03;
        if (k < n_steps - 1) tr_step_advance(&w);
    }
    const double *p = w.disks.pos, *v = w.disks.vel, *f = w.disks.force;
    double offset[2] = {0};
    tr_record *records = NULL;
    tr_status st = {0};
    int capacity = 0, n = tr_record_all(&w, &records, &capacity, &st);
    for (int k = 0; k < 2 && cell; k++) offset[k] = tr_cell_offset(&w.cell, &w.group[0], 0, k);
    pair_state s = {p[4] + offset[0] - p[0],
                    p[5] + offset[1] - p[1],
                    v[4] - v[0],
                    v[5] - v[1],
                    v[2],
                    v[6],
                    f[4],
                    f[5],
                    f[6],
                    0,
                    0,
                    {0}};
    assert_int_equal(w.group[0].n, 1);
    for (int h = 0; h < w.group[0].n_hist && h < HISTORY; h++) s.hist[h] = w.group[0].hist[h][0];
    assert_int_equal(n, 1);
    s.x_contact = records[0].x - p[0], s.y_contact = records[0].y - p[1];
    free(records), tr_world_free(&w);
    return s;
}

static void test_an_edge_is_no_place(void **state) {
    (void)state;
    int64_t wraps = 0, none = 0;
    for (int n = 400; n <= 1200; n += 400) { /* up to 0.09 m of way */
        pair_state free = strike(false, 0, 0, n, &none);
        assert_true(fabs(free.fx) > 0.1 && free.hist[0] != 0 && free.hist[1] != 0);
        for (int place = 0; place < 12; place++) {
            pair_state s = strike(true, 0.005 * place - 0.03, 0.04 - 0.0066 * place, n, &wraps);
            const double *got = &s.x, *wanted = &free.x;
            double scale[sizeof s / sizeof(double)] = {0.02,         0.02,    0.1,     0.1,           10,
                                                       10,           free.fx, free.fx, 0.1 * free.fx, free.hist[0],
                                                       free.hist[1], 1,       0.02,    0.02};
            /* A place is rounded to 1e-17 m of an overlap of 1e-5 m, some times over, and steps add that up */
            for (size_t i = 0; i < sizeof s / sizeof(double); i++)
                assert_close(got[i], wanted[i], 0, 1e-8 * fabs(scale[i]));
        }
    }
    assert_true(none == 0 && wraps >= 12);
}

/* Two disks at rest, and two near each other elsewhere, so that the list is not empty; the cell closes the gap across
 * its edge, which is wider than all skins: the list must follow the images, though no disk moves. Force k (rate t -
 * gap), along x or y. */
static void test_images_alone_move(void **state) {
    (void)state;
    const double k_n = 1e6, rate = -0.7, gap = 1.3; /* the wide skin is 0.6 */
    for (int axis = 0; axis < 2; axis++) {
        tr_world w;
        new_cell(&w, 4, axis ? 9 : 10, axis ? 10 : 9);
        for (int i = 0; i < 4; i++) {
            double at = (i % 2 ? -1 : 1) * (i < 2 ? 4 - gap / 2 : 1.1), side = i < 2 ? 1 : -2.2;
            tr_world_set_disk(&w, i, &(tr_disk_start){axis ? side : at, axis ? at : side, 0, 1, 1000, true});
        }
        set_laws(&w, (test_laws){.k_n = k_n}, 0);
        w.dt = 1e-3, w.cell.rate[axis] = rate;
        for (int k = 0; k < 2100; k++) {
            forces(&w);
            double overlap = fmax(0, 1e-3 * k * -rate - gap);
            /* disk 1 is pushed into the cell, away from the image of 0; 2000 sums of L, each rounded */
            assert_close(w.disks.force[4 + axis], k_n * overlap, 0, 1e-10 * k_n);
            assert_close(w.cell.virial[axis], k_n * overlap * (2 - overlap), 0, 1e-10 * k_n);
            tr_step_advance(&w);
        }
        assert_true(w.searches > 2);
        tr_world_free(&w);
    }
}

/* ---- lattices in a homogeneous flow ---- */

enum { ROW = 6 };

/* R = 1 with an overlap of 1 %. Square, or triangular in rows along x. */
static void new_lattice(tr_world *w, bool triangular) {
    const double d = 1.98, rise = triangular ? d * sqrt(3) / 2 : d;
    new_cell(w, ROW * ROW, ROW * d, ROW * rise);
    for (int i = 0; i < ROW * ROW; i++) {
        int row = i / ROW;
        double x = (i % ROW + (triangular && row % 2 ? 0.5 : 0)) * d, y = row * rise;
        tr_world_set_disk(w, i, &(tr_disk_start){x, y, 0, 1, 1000, false});
    }
    set_laws(w, (test_laws){.k_n = 1e9, .damping_ratio = 0.2}, 0);
    w->dt = 0.2 * tr_timestep_worst(w);
}

/* All contacts of a lattice follow the flow: with F the stretch and D its rate, l = F l0, approach -n.D.n l, sliding
 * n_x n_y (D_x - D_y) l (of spins 0). Stress by virtual work: (1/A) sum f l n n, f = k (2 - l) - c n.D.n l. */
static void lattice_flows(bool triangular, double Dx, double Dy) {
    const double k = 1e9, m = 1000 * M_PI, c = 2 * 0.2 * sqrt(k * m / 2), d = 1.98;
    const double bond[3][2] = {
        {d, 0}, {triangular ? d / 2 : 0, triangular ? d * sqrt(3) / 2 : d}, {-d / 2, d * sqrt(3) / 2}};
    const int bonds = triangular ? 3 : 2, n = ROW * ROW;
    tr_world w;
    tr_record *records = NULL;
    tr_status st = {0};
    int capacity = 0;
    new_lattice(&w, triangular);
    const double side0[2] = {w.cell.side[0], w.cell.side[1]};
    forces(&w);
    tr_cell_set_rate(&w, 0, Dx * side0[0]), tr_cell_set_rate(&w, 1, Dy * side0[1]);
    for (int step = 0; step < 400; step++) {
        forces(&w);
        double F[2] = {w.cell.side[0] / side0[0], w.cell.side[1] / side0[1]}, stress[2] = {0}, l[3], approach[3],
               slide[3];
        double D[2] = {Dx / F[0], Dy / F[1]}; /* the rate of the sides is constant */
        for (int b = 0; b < bonds; b++) {
            double x = F[0] * bond[b][0], y = F[1] * bond[b][1], nx, ny;
            l[b] = hypot(x, y), nx = x / l[b], ny = y / l[b];
            approach[b] = -(D[0] * nx * nx + D[1] * ny * ny) * l[b];
            slide[b] = fabs(nx * ny * (D[0] - D[1])) * l[b];
            double f = k * (2 - l[b]) + c * approach[b];
            stress[0] += f * l[b] * nx * nx * n, stress[1] += f * l[b] * ny * ny * n;
        }
        for (int axis = 0; axis < 2; axis++) /* an overlap of 0.02 of a length that is rounded to 1e-15, 400 times */
            assert_close(w.cell.virial[axis], stress[axis], 1e-10, 0);
        if (step % 100) {
            tr_step_advance(&w);
            continue;
        }
        int all = tr_record_all(&w, &records, &capacity, &st), of_bond[3] = {0};
        assert_int_equal(all, bonds * n);
        for (int i = 0; i < all; i++) {
            int b = fabs(records[i].ny) < 0.1 ? 0 : records[i].nx * records[i].ny < -0.1 && bonds == 3 ? 2 : 1;
            assert_close(2 - records[i].delta, l[b], 1e-13, 0);
            assert_close(records[i].v_n, approach[b], 0, 1e-12 * 500); /* of sound */
            assert_close(fabs(records[i].v_s), slide[b], 0, 1e-12 * 500);
            of_bond[b]++;
        }
        for (int b = 0; b < bonds; b++) assert_int_equal(of_bond[b], n);
        for (int i = 0; i < 4 * n; i++) /* in equilibrium with itself */
            assert_close(w.disks.force[i], 0, 0, 1e-8 * k * 0.02);
        tr_step_advance(&w);
    }
    free(records), tr_world_free(&w);
}

static void test_lattices_flow(void **state) {
    (void)state;
    for (int triangular = 0; triangular < 2; triangular++) {
        lattice_flows(triangular, 0, 0);
        lattice_flows(triangular, 0.03, -0.02);
        lattice_flows(triangular, -0.01, -0.03);
    }
    tr_world w; /* at rest, as a book has it: sqrt(3) k delta/d in all directions, k delta/d of squares */
    for (int triangular = 0; triangular < 2; triangular++) {
        new_lattice(&w, triangular);
        forces(&w);
        for (int axis = 0; axis < 2; axis++)
            assert_close(tr_cell_force(&w.cell, axis) / w.cell.side[1 - axis],
                         (triangular ? sqrt(3) : 1) * 1e9 * 0.02 / 1.98, 1e-12, 0);
        tr_world_free(&w);
    }
}

/* ---- a gas that is pressed ---- */

/* Disks that never touch: each keeps its c L, so that K of a direction goes as 1/L^2, and all of it is work of the
 * cell. Their momentum relative to the flow goes as 1/L. */
static void test_gas(void **state) {
    (void)state;
    enum { N = 20 };
    tr_world w;
    tr_random r = tr_random_seed(4, 1);
    double p0[2] = {0}, K0[2] = {0};
    new_cell(&w, N, 6, 4);
    for (int i = 0; i < N; i++) { /* half of them outside the cell, where their images are not */
        tr_world_set_disk(&w, i,
                          &(tr_disk_start){6 * tr_random_uniform(&r), 4 * tr_random_uniform(&r), 0, 1e-3, 1000, false});
        set_velocity(&w, i, tr_random_uniform(&r) - 0.2, tr_random_uniform(&r) - 0.7, 0);
    }
    for (int i = 0; i < 2 * N; i++) {
        double m = w.disks.mass[i / 2], v = w.disks.vel[4 * (i / 2) + i % 2];
        p0[i % 2] += m * v, K0[i % 2] += 0.5 * m * v * v;
    }
    set_laws(&w, (test_laws){.k_n = 1e3}, TR_SINK_LEDGER);
    w.dt = 1e-5;
    tr_cell_set_rate(&w, 0, -20), tr_cell_set_rate(&w, 1, 9);
    forces(&w), tr_ledger_begin(&w);
    for (int k = 0; k < 4000; k++) tr_step_advance(&w), forces(&w), tr_ledger_walls(&w);
    const double F[2] = {1 - 20 * 0.04 / 6, 1 + 9 * 0.04 / 4};
    tr_energy e = tr_ledger_read(&w);
    assert_true(w.cell.virial[0] == 0 && w.refreshes > 3);
    for (int axis = 0; axis < 2; axis++) {
        double p = 0;
        assert_close(w.cell.side[axis], (axis ? 4 : 6) * F[axis], 1e-12, 0); /* 4000 sums */
        for (int i = 0; i < N; i++)
            p += w.disks.mass[i] *
                 (w.disks.vel[4 * i + axis] - w.cell.rate[axis] / w.cell.side[axis] * w.disks.pos[4 * i + axis]);
        assert_close(p, p0[axis] / F[axis], 0, 1e-10 * fabs(p0[0]));
    }
    assert_close(e.kinetic, K0[0] / (F[0] * F[0]) + K0[1] / (F[1] * F[1]), 1e-11, 0);
    assert_close(e.work, e.kinetic - K0[0] - K0[1], 0, 1e-11 * e.kinetic);
    tr_world_free(&w);
}

/* ---- a packing, shifted, drifting, tiled ---- */

enum { N = 60 };

static tr_scene periodic_scene(int disks, uint64_t seed, test_laws laws) {
    tr_scene scene = biaxial_scene(disks, seed, laws);
    scene.boundary = TR_PERIODIC;
    return scene;
}

/* By (x, y) in the flow; then all drift with (vx, vy) besides. */
static void displace(tr_world *w, double x, double y, double vx, double vy) {
    for (int i = 0; i < w->disks.n; i++) {
        w->disks.pos[4 * i] += x, w->disks.pos[4 * i + 1] += y;
        w->disks.vel[4 * i] += vx + tr_cell_strain_rate(&w->cell, 0) * x;
        w->disks.vel[4 * i + 1] += vy + tr_cell_strain_rate(&w->cell, 1) * y;
    }
}

/* The servo of the width is at work, the height shrinks. While no rounding has grown (it grows by 10 in some hundred
 * steps, as in all packings), forces and stresses are the same, and the energies too, which count from the flow. */
static void assert_same_elsewhere(double x, double y, double vx, double vy) {
    tr_scene scene = periodic_scene(N, 2, sand);
    tr_biaxial b, other;
    compact(&b, &scene), compact(&other, &scene);
    int64_t searches = b.world.searches;
    displace(&other.world, x, y, vx, vy);
    begin_shear(&b), begin_shear(&other);
    double mean_force = 160e3 * 2e-3;
    for (int k = 0; k < 600; k++) {
        shear_forces(&b), shear_forces(&other);
        double allowed =
            k == 0 ? 1e-9 : 1e-6; /* of a force: overlaps of 1e-6 m, places rounded to 1e-18 m; then see above */
        for (int i = 0; i < 4 * N; i++)
            assert_close(other.world.disks.force[i], b.world.disks.force[i], 0, allowed * mean_force);
        for (int axis = 0; axis < 2; axis++) {
            assert_close(other.world.cell.virial[axis], b.world.cell.virial[axis], allowed, 0);
            assert_close(other.world.cell.side[axis], b.world.cell.side[axis], 1e-10, 0);
        }
        tr_step_advance(&b.world), tr_step_advance(&other.world);
    }
    tr_energy e = tr_ledger_read(&b.world), f = tr_ledger_read(&other.world);
    if (vx != 0) e.work = f.work, e.kinetic = f.kinetic; /* to press what drifts is work too */
    assert_close(f.work, e.work, 1e-6, 0);
    assert_close(f.damped, e.damped, 1e-6, 0);
    assert_close(f.kinetic, e.kinetic, 1e-6, 0);
    assert_true(b.world.searches > searches && fabs(b.world.cell.rate[0]) > 0);
    tr_biaxial_free(&b), tr_biaxial_free(&other);
}

static void test_no_place_is_special(void **state) {
    (void)state;
    assert_same_elsewhere(0.003, 0, 0, 0);
    assert_same_elsewhere(-0.0071, 0.0052, 0, 0);
    assert_same_elsewhere(0, 0, 5, -8); /* 2 to 3 mm in 600 steps: through the edges */
}

/* Before the first contact: the drag of compaction acts against the flow of the cell. Disks that follow it keep x/L;
 * of what a disk has besides, c L falls by 1 - drag dt in a step. */
static void test_drag_is_against_the_flow(void **state) {
    (void)state;
    enum { FEW = 30, STEPS = 20 };
    tr_scene scene = periodic_scene(FEW, 3, sand);
    tr_biaxial b;
    tr_status st = {0};
    double x0[FEW][2], unbalanced, want = 0.01;
    bool done;
    if (!tr_biaxial_init(&b, &scene, &st)) fail_msg("%s", st.text);
    tr_world *w = &b.world;
    const double L0 = w->cell.side[0];
    for (int i = 0; i < FEW; i++) memcpy(x0[i], w->disks.pos + 4 * i, sizeof x0[i]);
    for (int k = 0; k < 2; k++) w->cell.mass[k] = 0, tr_cell_set_rate(w, k, -0.3);
    w->disks.vel[0] += want;
    for (int n = 0; n < STEPS; n++) {
        if (!tr_biaxial_compact(&b, 1, &unbalanced, &done, &st)) fail_msg("%s", st.text);
        want *= 1 - b.drag * w->dt;
    }
    assert_true(w->contact_updates == 0);
    for (int i = 1; i < FEW; i++)
        for (int k = 0; k < 2; k++) {
            double turns = w->disks.pos[4 * i + k] / w->cell.side[k] - x0[i][k] / L0;
            assert_close(turns, rint(turns), 0, 1e-13); /* 20 roundings */
        }
    double c = w->disks.vel[0] - tr_cell_strain_rate(&w->cell, 0) * w->disks.pos[0];
    assert_close(c * w->cell.side[0] / L0, want, 1e-12, 0);
    tr_biaxial_free(&b);
}

/* Four copies side by side are the same sample in a cell twice as wide and high. */
static void test_tiles(void **state) {
    (void)state;
    tr_scene scene = periodic_scene(N, 3, sand);
    tr_biaxial b;
    tr_world tiled;
    tr_status st = {0};
    compact(&b, &scene);
    const double *side = b.world.cell.side;
    new_cell(&tiled, 4 * N, 2 * side[0], 2 * side[1]);
    begin_shear(&b);
    tr_world *w = &b.world;
    for (int k = 0; k < 4 * N; k++) {
        const double *p = w->disks.pos + 4 * (k % N), *v = w->disks.vel + 4 * (k % N);
        int i = k / N % 2, j = k / (2 * N);
        tr_world_set_disk(&tiled, k, &(tr_disk_start){p[0] + i * side[0], p[1] + j * side[1], p[2], p[3], 2700, false});
        set_velocity(&tiled, k, v[0] + i * w->cell.rate[0], v[1] + j * w->cell.rate[1], v[2]);
    }
    if (!tr_world_set_laws(&tiled, &scene.contact, true, 0, &st)) fail_msg("%s", st.text);
    tiled.dt = w->dt;
    for (int axis = 0; axis < 2; axis++) tiled.cell.rate[axis] = 2 * w->cell.rate[axis];
    tiled.cell.mass[0] = w->cell.mass[0], tiled.cell.v_max[0] = INFINITY;
    for (int k = 0; k < 500; k++) {
        shear_forces(&b), forces(&tiled);
        tiled.cell.load[0] = 2 * w->cell.load[0], tiled.cell.gain[1] = 2 * w->cell.gain[1];
        for (int axis = 0; axis < 2; axis++) {
            assert_close(tiled.cell.virial[axis], 4 * w->cell.virial[axis], 1e-6, 0); /* rounding that grows */
            assert_close(tiled.cell.side[axis], 2 * side[axis], 1e-10, 0);
        }
        for (int i = 0; i < 4 * 4 * N; i++)
            assert_close(tiled.disks.force[i], w->disks.force[i % (4 * N)], 0, 1e-6 * 160e3 * 2e-3);
        tr_step_advance(w), tr_step_advance(&tiled);
    }
    assert_true(tiled.cell.rate[0] != 0);
    tr_world_free(&tiled), tr_biaxial_free(&b);
}

/* Forces in a cell sum up to nothing, and momentum that counts from the flow goes as 1/L. */
static void test_momentum(void **state) {
    (void)state;
    tr_scene scene = periodic_scene(N, 5, sand);
    tr_biaxial b;
    compact(&b, &scene), begin_shear(&b);
    tr_world *w = &b.world;
    displace(w, 0, 0, 3, 4);
    double kept[2] = {0}, mass = 0;
    for (int k = 0; k < 1000; k++) {
        double sum[2] = {0}, momentum[2] = {0};
        shear_forces(&b);
        for (int i = 0; i < 2 * N; i++) {
            int at = 4 * (i / 2) + i % 2;
            double flow = w->cell.rate[i % 2] / w->cell.side[i % 2];
            sum[i % 2] += w->disks.force[at];
            momentum[i % 2] += w->disks.mass[i / 2] * (w->disks.vel[at] - flow * w->disks.pos[at]);
            if (k == 0) mass += 0.5 * w->disks.mass[i / 2];
        }
        for (int axis = 0; axis < 2; axis++) {
            double now = momentum[axis] * w->cell.side[axis];
            if (k == 0) kept[axis] = now;
            assert_close(sum[axis], 0, 0, 1e-11 * 160e3 * 2e-3 * N); /* rounding of N sums */
            assert_close(now, kept[axis], 0, 1e-10 * mass * 5 * w->cell.side[axis]);
        }
        tr_step_advance(w);
    }
    assert_true(kept[0] > 0 && kept[1] > 0);
    tr_biaxial_free(&b);
}

/* ---- bad cells ---- */

static void test_thin_cell_is_refused(void **state) {
    (void)state;
    for (int thin = 0; thin < 2; thin++) {
        tr_world w;
        tr_status st = {0};
        new_cell(&w, 2, 5, 5);
        for (int i = 0; i < 2; i++) tr_world_set_disk(&w, i, &(tr_disk_start){i * 2.2, 0, 0, 1, 1000, false});
        set_laws(&w, (test_laws){.k_n = 1e6}, 0);
        w.dt = 1e-4;
        /* 2 (2 + 0.3*2), for the wide skin is 0.3 of the mean diameter */
        w.cell.side[thin] = 5.2 * (1 + 1e-9), w.cell.side[1 - thin] = 6;
        assert_true(tr_step_forces(&w, &st));
        w.cell.side[thin] = 5.2 * (1 - 1e-9), w.stale = true;
        assert_false(tr_step_forces(&w, &st));
        assert_int_equal(st.code, TR_NUMERICAL);
        assert_non_null(strstr(st.text, thin ? "the periodic cell is too thin: its height is 5.2 m"
                                             : "the periodic cell is too thin: its width is 5.2 m"));
        tr_world_free(&w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_edge_is_no_place),
        cmocka_unit_test(test_images_alone_move),
        cmocka_unit_test(test_lattices_flow),
        cmocka_unit_test(test_gas),
        cmocka_unit_test(test_no_place_is_special),
        cmocka_unit_test(test_drag_is_against_the_flow),
        cmocka_unit_test(test_tiles),
        cmocka_unit_test(test_momentum),
        cmocka_unit_test(test_thin_cell_is_refused),
    };
    return cmocka_run_group_tests_name("cell", tests, NULL, NULL);
}
