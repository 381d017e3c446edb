/* SPDX-License-Identifier: MIT */
/* kind: patch: each solver along the path of a case. What the path does to the numbers (totals, segments, opening), the
 * solvers against each other: transient and steady, exact and closed. The solvers themselves: tests/patch. */
#include "assert_close.h"
#include "laws/law.h"
#include "patch/carter.h"
#include "patch/cattaneo.h"
#include "study/inside.h"

#include <stdlib.h>
#include <string.h>

#define HEAD                                                                                                           \
    "kind: patch\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3}\nmu: 0.3\nelements: 100\ndepth: 1 mm\nsolver: "

typedef struct run {
    tr_scene scene;
    tr_inside *inside;
    int n;
    double lost; /* by slip */
    tr_contact_state state[2000];
} run;

/* All steps; the inside stays as after the last. */
static void drive(run *r, const char *solver, const char *path) {
    char text[1000];
    tr_status st = {0};
    snprintf(text, sizeof text, HEAD "%s\npath: %s\n", solver, path);
    if (!tr_scene_read(&r->scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    r->inside = tr_inside_new(&r->scene, &st);
    assert_non_null(r->inside);
    r->n = (int)tr_contact_steps(&r->scene);
    assert_true(r->n <= 2000);
    r->lost = 0;
    for (int i = 0; i < r->n; i++) {
        if (!tr_inside_step(r->inside, &r->state[i], &st)) fail_msg("%s", st.text);
        assert_int_equal(r->state[i].step, i + 1);
        r->lost += tr_inside_patch(r->inside)->dissipated;
    }
}

static void end(run *r) {
    tr_inside_free(r->inside);
    tr_scene_free(&r->scene);
}

static run A, B;

/* Totals of segments, prescribed Q and prescribed slide in turn, an opening that forgets. */
static void totals(void **state) {
    (void)state;
    static const char *const solvers[] = {"half-plane", "brush"};
    for (int k = 0; k < 2; k++) {
        drive(
            &A, solvers[k],
            "[{force: 10 kN/m, tangential: 1.5 kN/m, steps: 10}, {force: 20 kN/m, slide: -0.1 um, roll: a, steps: 20},"
            " {force: 0, tangential: 0, steps: 5}, {force: 10 kN/m, slide: 0.02 um, steps: 10}]");
        for (int i = 0; i < A.n; i++) {
            const tr_contact_state *s = &A.state[i];
            double P = i < 10 ? 1e4 : i < 30 ? 1e4 + 1e4 * (i - 9) / 20 : i < 35 ? 2e4 * (34 - i) / 5 : 1e3 * (i - 34);
            assert_int_equal(s->segment, i < 10 ? 0 : i < 30 ? 1 : i < 35 ? 2 : 3);
            assert_close(s->P, P, 1e-13, 1e-9);
            assert_close(s->a, sqrt(4 * P * 0.0075 / (M_PI * A.scene.pair.E_star)), 1e-13, 1e-18);
            assert_true(fabs(s->Q) <= 0.3 * P * (1 + 1e-12));
            /* a prescribed force is met to the rounding of a sum of 100 elements */
            if (i < 10) assert_close(s->Q, 150.0 * (i + 1), 1e-12, 0);
            if (i >= 30 && i < 35) assert_close(s->Q, A.state[29].Q * (34 - i) / 5, 1e-11, 1e-9 * P);
        }
        assert_close(A.state[29].u_slide - A.state[9].u_slide, -1e-7, 1e-12, 0);
        assert_close(A.state[29].u_roll, sqrt(4e4 * 0.0075 / (M_PI * A.scene.pair.E_star)), 1e-13, 0);
        assert_true(A.state[34].P == 0 && A.state[34].Q == 0 && A.state[34].a == 0);
        drive(&B, solvers[k],
              "[{force: 10 kN/m, steps: 1}, {force: 0, steps: 1}, {force: 1 kN/m, slide: 0.002 um, steps: 1},"
              " {force: 10 kN/m, slide: 0.018 um, steps: 9}]");
        for (int i = 0; i < 10; i++) assert_close(A.state[35 + i].Q, B.state[2 + i].Q, 1e-9, 0); /* as if new */
        end(&A), end(&B);
    }
}

/* The closed forms along a path, by sliding and by force, against formulas and against the half-plane, whose error at
 * 100 elements is below 1e-2 of mu P here (first order in 1/n, 2e-3 at 200). */
static void closed_forms(void **state) {
    (void)state;
    drive(&A, "cattaneo", "[{force: 10 kN/m, slide: 0.1 um, steps: 7}, {force: 10 kN/m, slide: 0.3 um, steps: 13}]");
    drive(&B, "half-plane", "[{force: 10 kN/m, slide: 0.1 um, steps: 7}, {force: 10 kN/m, slide: 0.3 um, steps: 13}]");
    tr_patch_pair c = tr_inside_pair(&A.scene);
    bool full = false;
    for (int i = 0; i < A.n; i++) {
        double u = i < 7 ? 1e-7 * (i + 1) / 7 : 1e-7 + 3e-7 * (i - 6) / 13;
        assert_close(A.state[i].u_slide, u, 1e-13, 0);
        assert_close(tr_cattaneo_u(&c, 1e4, fmin(A.state[i].q, 1)), fmin(u, tr_cattaneo_u(&c, 1e4, 1)), 1e-9, 0);
        assert_close(A.state[i].Q, B.state[i].Q, 0, 1e-2 * 3e3);
        full |= A.state[i].q == 1;
    }
    assert_true(full && A.state[7].q < 1);
    /* what slips in the last step, at full slip: all slides alike */
    const tr_patch_state *s = tr_inside_patch(A.inside), *t = tr_inside_patch(B.inside);
    for (int i = 0; i < s->n; i++) {
        assert_int_equal(s->side[i], 1);
        assert_close(s->slip[i], 3e-7 / 13, 1e-12, 0);
        assert_close(t->slip[i], 3e-7 / 13, 1e-12, 0);
    }
    end(&A), end(&B);
    /* Energy lost by slip up to Q = 0.8 mu P, in as many steps: slip of the closed form against that of the half-plane,
     * of which 0.3 % is missing where stick ends. */
    drive(&A, "cattaneo", "[{force: 10 kN/m, tangential: 0.8*mu*P, steps: 50}]");
    drive(&B, "half-plane", "[{force: 10 kN/m, tangential: 0.8*mu*P, steps: 50}]");
    print_message("lost by slip: %.6g J/m closed, %.6g half-plane\n", A.lost, B.lost);
    assert_close(A.lost, B.lost, 1e-2, 0);
    assert_true(A.lost > 0);
    end(&A), end(&B);
}

/* Steady rolling: the closed form at once, the half-plane and, with its own law, the brush after a while. */
static void steady(void **state) {
    (void)state;
    /* the transient fades over Lambda a, here 3.7 a: 30 a leave 3e-4 of it */
    const char *path = "[{force: 10 kN/m, slide: 0.6*mu*a/R_star*30*a, roll: -30*a, steps: 1500}]";
    drive(&A, "carter", path);
    tr_patch_pair c = tr_inside_pair(&A.scene);
    double a = tr_patch_a(&c, 1e4), q = 1 - 0.4 * 0.4; /* xi = F0 (1 - sqrt(1 - q)) */
    for (int i = 0; i < A.n; i++) assert_close(A.state[i].q, q, 1e-12, 0);
    const tr_patch_state *s = tr_inside_patch(A.inside);
    for (int i = 0; i < s->n; i++) { /* material runs back: it enters on the right, where it sticks */
        assert_close(s->tau[i], tr_carter_tau(&c, 1e4, q, -1, s->x[i]), 1e-12, 1e-6);
        assert_int_equal(s->side[i], s->x[i] >= -a * (2 * 0.4 - 1) ? 0 : 1);
    }
    drive(&B, "half-plane", path);
    assert_close(B.state[1499].q, q, 0, 5e-3); /* first order in 1/n: 2e-3 */
    assert_true(B.state[0].q < 0.1);
    end(&A), end(&B);
    drive(&A, "carter", "[{force: 10 kN/m, tangential: -0.84*mu*P, roll: a, steps: 10}]");
    double xi = 0; /* Q grows with the steps: creepage of each */
    for (int i = 1; i <= 10; i++) xi += 0.1 * (1 - sqrt(1 - 0.084 * i));
    assert_close(A.state[9].u_slide, -xi * 0.3 * a / 0.0075 * a, 1e-10, 0);
    end(&A);
}

/* The force is given, so q is known: each solver is asked for -0.6 mu P, and then for 0.3. The tolerance is that of a
 * prescribed force. */
static void q_has_the_sign_of_Q(void **state) {
    (void)state;
    static const char *const solver[] = {"half-plane", "brush", "cattaneo", "carter"};
    for (int k = 0; k < 4; k++) {
        bool from_rest = k == 2; /* cattaneo loads only once */
        drive(&A, solver[k],
              from_rest ? "[{force: 10 kN/m, tangential: -0.6*mu*P, steps: 10}]"
              : k == 3  ? "[{force: 10 kN/m, tangential: -0.6*mu*P, roll: a, steps: 10}]"
                        : "[{force: 10 kN/m, tangential: -0.6*mu*P, steps: 10},"
                          " {force: 10 kN/m, tangential: 0.3*mu*P, steps: 10}]");
        assert_close(A.state[9].q, -0.6, 1e-6, 0);
        if (k < 2) assert_close(A.state[19].q, 0.3, 1e-6, 0);
        end(&A);
    }
}

/* A failure says where. */
static void failure(void **state) {
    (void)state;
    tr_status st = {0};
    char text[1000];
    snprintf(text, sizeof text, HEAD "half-plane\npath: %s\n", "[{force: 10 kN/m, slide: 1 um, steps: 3}]");
    assert_true(tr_scene_read(&A.scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st));
    A.scene.path[0].slide = INFINITY;
    A.inside = tr_inside_new(&A.scene, &st);
    assert_false(tr_inside_step(A.inside, A.state, &st));
    assert_non_null(strstr(st.text, "error: "));
    assert_non_null(strstr(st.text, ", at step 1 (path.0)"));
    end(&A);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(totals),
        cmocka_unit_test(closed_forms),
        cmocka_unit_test(steady),
        cmocka_unit_test(q_has_the_sign_of_Q),
        cmocka_unit_test(failure),
    };
    return cmocka_run_group_tests_name("inside", tests, NULL, NULL);
}
