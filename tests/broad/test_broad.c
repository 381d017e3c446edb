/* SPDX-License-Identifier: MIT */
/* Pair finding. The reference is the definition itself, gap < skin, looked at for every pair with the distance from
 * hypot; pairs whose gap equals the skin to rounding may go either way. */
#include "assert_close.h"
#include "base/random.h"
#include "broad/broad.h"
#include "broad/choose.h"
#include <stdlib.h>
#include <string.h>

static const tr_broad_finder *const finders[] = {&tr_broad_brute, &tr_broad_box2d};

typedef struct crowd {
    int n;
    double *pos;
    tr_random random;
} crowd;

static double random_in(tr_random *r, double a, double b) {
    return a + (b - a) * tr_random_uniform(r);
}

/* n disks of radii 1:10 (log-uniform, largest 1) in a square of the side, about (x0, x0). */
static crowd new_crowd(int n, double side, double x0, uint64_t seed) {
    crowd c = {n, calloc(4 * (size_t)n + 4, sizeof(double)), tr_random_seed(seed, 1)};
    for (int i = 0; i < n; i++) {
        c.pos[4 * i] = x0 + random_in(&c.random, 0, side), c.pos[4 * i + 1] = x0 + random_in(&c.random, 0, side);
        c.pos[4 * i + 2] = NAN; /* the angle: no finder may look at it */
        c.pos[4 * i + 3] = pow(10, random_in(&c.random, -1, 0));
    }
    return c;
}

static void *new_finder(const tr_broad_finder *f, const tr_broad_input *input) {
    tr_status st = {0};
    void *finder = f->create(input, &st);
    if (!finder) fail_msg("%s", st.text);
    return finder;
}

/* Sorted, no doubles, a < b, and complete. */
static void check_pairs(const tr_broad_input *in, const tr_pairs *pairs) {
    int next = 0;
    for (int a = 0; a < in->n; a++)
        for (int b = a + 1; b < in->n; b++) {
            const double *p = in->pos + 4 * a, *q = in->pos + 4 * b;
            double distance = hypot(q[0] - p[0], q[1] - p[1]), reach = p[3] + q[3] + in->skin;
            bool given = next < pairs->n && pairs->a[next] == a && pairs->b[next] == b;
            if (given != (distance < reach) && fabs(distance - reach) > 1e-14 * (reach + fabs(p[0]) + fabs(p[1])))
                fail_msg("pair (%d, %d), distance %.17g, reach %.17g: %s", a, b, distance, reach,
                         given ? "given" : "missing");
            next += given;
        }
    assert_int_equal(next, pairs->n); /* nothing else, and in order */
}

/* A clustered crowd drifts apart and comes back, with jumps; every state is searched by both finders, whose trees have
 * followed all states before. */
static void moving_crowd(double x0) {
    enum { N = 70, STEPS = 2000 };
    crowd c = new_crowd(N, 12, x0, 5);
    double v[N][2];
    for (int i = 0; i < N; i++)
        v[i][0] = random_in(&c.random, -0.02, 0.02), v[i][1] = random_in(&c.random, -0.02, 0.02);
    tr_broad_input in = {N, c.pos, 0.1, NULL, NULL};
    void *f[2] = {new_finder(finders[0], &in), new_finder(finders[1], &in)};
    tr_pairs pairs[2] = {{0}, {0}};
    long found = 0;
    for (int s = 0; s < STEPS; s++) {
        in.skin = 0.5 * (s % 11) / 10;
        for (int i = 0; i < N; i++) {
            double *p = c.pos + 4 * i, out = s / 250 % 2 ? -1 : 1;
            p[0] += out * v[i][0], p[1] += out * v[i][1];
        }
        if (s % 97 == 0) c.pos[4 * (s % N)] = x0 + random_in(&c.random, -40, 40); /* one jumps */
        for (int k = 0; k < 2; k++) {
            tr_status st = {0};
            if (!finders[k]->find(f[k], &in, &pairs[k], &st)) fail_msg("%s", st.text);
        }
        check_pairs(&in, &pairs[0]);
        assert_int_equal(pairs[0].n, pairs[1].n);
        assert_memory_equal(pairs[0].a, pairs[1].a, (size_t)pairs[0].n * sizeof(int));
        assert_memory_equal(pairs[0].b, pairs[1].b, (size_t)pairs[0].n * sizeof(int));
        found += pairs[0].n;
    }
    assert_true(found > 10L * STEPS); /* there was something to find */
    for (int k = 0; k < 2; k++) finders[k]->destroy(f[k]), tr_pairs_free(&pairs[k]);
    free(c.pos);
}

static void test_moving_crowd(void **state) {
    (void)state, moving_crowd(0);
}

/* 1000 diameters of the largest disk away: single precision inside Box2D has 1e-7 of that, rounded outward. */
static void test_far_from_the_origin(void **state) {
    (void)state, moving_crowd(2000);
}

static void test_crowds_at_rest(void **state) {
    (void)state;
    static const double sides[] = {0.5, 5, 20, 200, 1e5}, skins[] = {0, 1e-9, 0.05, 0.5};
    for (int i = 0; i < 5; i++)
        for (int s = 0; s < 4; s++)
            for (int k = 0; k < 2; k++) {
                crowd c = new_crowd(120, sides[i], -3, 9 + (uint64_t)i);
                tr_broad_input in = {c.n, c.pos, skins[s], NULL, NULL};
                void *f = new_finder(finders[k], &in);
                tr_pairs pairs = {0};
                tr_status st = {0};
                in.threads = tr_threads_new(1 + s, &st);
                assert_true(finders[k]->find(f, &in, &pairs, &st));
                check_pairs(&in, &pairs);
                finders[k]->destroy(f), tr_pairs_free(&pairs), free(c.pos), tr_threads_free(in.threads);
            }
}

/* Millimetre disks: a finder with an absolute margin would give every pair. */
static void test_small_lengths(void **state) {
    (void)state;
    for (int k = 0; k < 2; k++) {
        crowd c = new_crowd(200, 25, 0, 4);
        for (int i = 0; i < 4 * c.n; i++) c.pos[i] *= 1e-3;
        tr_broad_input in = {c.n, c.pos, 1e-4, NULL, NULL};
        void *f = new_finder(finders[k], &in);
        tr_pairs pairs = {0};
        tr_status st = {0};
        assert_true(finders[k]->find(f, &in, &pairs, &st));
        check_pairs(&in, &pairs);
        finders[k]->destroy(f), tr_pairs_free(&pairs), free(c.pos);
    }
}

static void test_not_finite_is_refused_by_name(void **state) {
    (void)state;
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < 2; k++)
        for (int b = 0; b < 3; b++)
            for (int lane = 0; lane < 2; lane++) {
                crowd c = new_crowd(40, 9, 0, 2);
                tr_broad_input in = {c.n, c.pos, 0.1, NULL, NULL};
                void *f = new_finder(finders[k], &in);
                tr_pairs pairs = {0};
                tr_status st = {0};
                assert_true(finders[k]->find(f, &in, &pairs, &st));
                double kept = c.pos[4 * 17 + lane];
                c.pos[4 * 17 + lane] = bad[b];
                assert_false(finders[k]->find(f, &in, &pairs, &st));
                assert_int_equal(st.code, TR_NUMERICAL);
                assert_non_null(strstr(st.text, "disk 17 "));
                c.pos[4 * 17 + lane] = kept; /* and the finder still works */
                st = (tr_status){0};
                assert_true(finders[k]->find(f, &in, &pairs, &st));
                check_pairs(&in, &pairs);
                finders[k]->destroy(f), tr_pairs_free(&pairs), free(c.pos);
            }
    crowd c = new_crowd(40, 9, 0, 2);
    c.pos[4 * 3] = NAN;
    tr_status st = {0};
    assert_null(tr_broad_box2d.create(&(tr_broad_input){c.n, c.pos, 0.1, NULL, NULL}, &st));
    assert_non_null(strstr(st.text, "disk 3 "));
    free(c.pos);
}

static void test_few_disks(void **state) {
    (void)state;
    double pos[8] = {1, 2, 0, 0.5, 1, 2, 0, 0.5}; /* two that coincide */
    for (int k = 0; k < 2; k++)
        for (int n = 0; n <= 2; n++) {
            tr_broad_input in = {n, pos, 0, NULL, NULL};
            void *f = new_finder(finders[k], &in);
            tr_pairs pairs = {0};
            tr_status st = {0};
            for (int again = 0; again < 2; again++) assert_true(finders[k]->find(f, &in, &pairs, &st));
            assert_int_equal(pairs.n, n == 2);
            finders[k]->destroy(f), tr_pairs_free(&pairs);
        }
}

static void test_coincident_disks(void **state) {
    (void)state;
    crowd c = new_crowd(60, 9, 0, 3);
    for (int i = 20; i < 40; i++) c.pos[4 * i] = 4, c.pos[4 * i + 1] = 4;
    for (int k = 0; k < 2; k++) {
        tr_broad_input in = {c.n, c.pos, 0, NULL, NULL};
        void *f = new_finder(finders[k], &in);
        tr_pairs pairs = {0};
        tr_status st = {0};
        assert_true(finders[k]->find(f, &in, &pairs, &st));
        check_pairs(&in, &pairs);
        finders[k]->destroy(f), tr_pairs_free(&pairs);
    }
    free(c.pos);
}

/* ---- periodic cells: the reference looks at all nine images of each pair */

static void check_images(const tr_broad_input *in, const tr_pairs *pairs) {
    int next = 0;
    for (int a = 0; a < in->n; a++)
        for (int b = a + 1; b < in->n; b++) {
            const double *p = in->pos + 4 * a, *q = in->pos + 4 * b;
            double distance = INFINITY, reach = p[3] + q[3] + in->skin;
            for (int i = -1; i <= 1; i++)
                for (int j = -1; j <= 1; j++)
                    distance = fmin(distance, hypot(q[0] + i * in->cell[0] - p[0], q[1] + j * in->cell[1] - p[1]));
            bool given = next < pairs->n && pairs->a[next] == a && pairs->b[next] == b;
            if (given != (distance < reach) && fabs(distance - reach) > 1e-14 * (in->cell[0] + in->cell[1]))
                fail_msg("pair (%d, %d), distance %.17g, reach %.17g: %s", a, b, distance, reach,
                         given ? "given" : "missing");
            next += given;
        }
    assert_int_equal(next, pairs->n);
}

/* Radii 1:10 in cells that a strain squeezes from wide to tall, down to the least side; a tenth of the disks on edges,
 * the first four in the corners. */
static void test_periodic_cells(void **state) {
    (void)state;
    enum { N = 90, STEPS = 60 };
    long found = 0;
    for (int k = 0; k < 2; k++) {
        crowd c = new_crowd(N, 1, -0.5, 21);
        double cell[2] = {1, 1}, unit[N][2];
        for (int i = 0; i < N; i++) {
            for (int axis = 0; axis < 2; axis++) unit[i][axis] = c.pos[4 * i + axis];
            if (i < 4) unit[i][0] = i % 2 - 0.5, unit[i][1] = i / 2 - 0.5;
            if (i % 10 == 5) unit[i][i % 4 == 1] = i % 20 == 5 ? 0.5 : -0.5;
        }
        c.pos[3] = 1; /* the largest in a corner */
        tr_broad_input in = {N, c.pos, 0, cell, NULL};
        void *f = new_finder(finders[k], &in);
        tr_pairs pairs = {0};
        for (int s = 0; s < STEPS; s++) {
            in.skin = 0.5 * (s % 6) / 5;
            double least = 2 * (2 + in.skin) * (1 + 1e-12), part = s / (STEPS - 1.0);
            cell[0] = least + 20 * (1 - part), cell[1] = least + 20 * part;
            for (int i = 0; i < N; i++)
                for (int axis = 0; axis < 2; axis++) {
                    if (i % 10 != 5 && i >= 4) /* they wander through the cell, and come back on the other side */
                        unit[i][axis] = remainder(unit[i][axis] + random_in(&c.random, -0.1, 0.1), 1);
                    c.pos[4 * i + axis] = unit[i][axis] * cell[axis];
                }
            tr_status st = {0};
            if (!finders[k]->find(f, &in, &pairs, &st)) fail_msg("%s", st.text);
            check_images(&in, &pairs);
            found += pairs.n;
        }
        finders[k]->destroy(f), tr_pairs_free(&pairs), free(c.pos);
    }
    assert_true(found > 100L * STEPS);
}

static void test_choice(void **state) {
    (void)state;
    assert_ptr_equal(tr_broad_choose(2), &tr_broad_brute);
    assert_ptr_equal(tr_broad_choose(400), &tr_broad_box2d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_moving_crowd),
        cmocka_unit_test(test_far_from_the_origin),
        cmocka_unit_test(test_crowds_at_rest),
        cmocka_unit_test(test_small_lengths),
        cmocka_unit_test(test_not_finite_is_refused_by_name),
        cmocka_unit_test(test_few_disks),
        cmocka_unit_test(test_coincident_disks),
        cmocka_unit_test(test_periodic_cells),
        cmocka_unit_test(test_choice),
    };
    return cmocka_run_group_tests_name("broad", tests, NULL, NULL);
}
