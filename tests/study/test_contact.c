/* SPDX-License-Identifier: MIT */
/* kind: contact: the laws along prescribed paths against closed forms written here; what a path does to the bodies;
 * what is refused. */
#include "assert_close.h"
#include "laws/law.h"
#include "study/contact.h"
#include "study/every_law.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_STEPS = 5000 };

/* All steps of a case, law by law: run.state[law][step]. */
typedef struct run {
    tr_scene scene;
    int n; /* steps */
    tr_contact_state *state[TR_MAX_LAWS];
} run;

static bool read_case(tr_scene *scene, const char *text, tr_status *st) {
    return tr_scene_read(scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), st);
}

static run drive(const char *text) {
    run r = {0};
    tr_status st = {0};
    if (!read_case(&r.scene, text, &st)) fail_msg("%s", st.text);
    tr_contact *contact = tr_contact_new(&r.scene, &st);
    if (!contact) fail_msg("%s", st.text);
    assert_true(tr_contact_steps(&r.scene) <= MAX_STEPS);
    r.n = (int)tr_contact_steps(&r.scene);
    for (int l = 0; l < r.scene.n_laws; l++) r.state[l] = calloc((size_t)r.n, sizeof *r.state[l]);
    for (int k = 0; k < r.n; k++) {
        tr_contact_state state[TR_MAX_LAWS];
        if (!tr_contact_step(contact, state, &st)) fail_msg("%s", st.text);
        for (int l = 0; l < r.scene.n_laws; l++) {
            assert_int_equal(state[l].law, l);
            assert_int_equal(state[l].step, k + 1);
            r.state[l][k] = state[l];
        }
    }
    tr_contact_free(contact);
    return r;
}

static void end(run *r) {
    for (int l = 0; l < r->scene.n_laws; l++) free(r->state[l]);
    tr_scene_free(&r->scene);
}

static void refused(const char *text, const char *message) {
    tr_scene scene;
    tr_status st = {0};
    if (read_case(&scene, text, &st)) fail_msg("accepted: %s", text);
    assert_int_equal(st.code, TR_BAD_CASE);
    if (!strstr(st.text, message)) fail_msg("no `%s` in %s", message, st.text);
}

#define BODIES "kind: contact\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3}\n"

/* Where the path is after each step, and that a law sees that motion: springs that never reach their bound hold the
 * totals. */
static void totals(void **state) {
    (void)state;
    run r =
        drive(BODIES "laws:\n"
                     "  - {friction: coulomb-spring, mu: 100, k_t: 1 GPa, rolling: wang-spring, mu_r: 100, k_r: 1 GPa, "
                     "rolling_velocity: bagi-kuhn}\n"
                     "  - {rolling: wang-spring, mu_r: 100, k_r: 1 GPa, rolling_velocity: wang}\n"
                     "path:\n"
                     "  - {force: 9 kN/m, slide: 2 um, roll: -5 um, steps: 7}\n"
                     "  - {force: 6 kN/m, slide: -7 um, roll: 4 um, steps: 13, time: 1 ms}\n"
                     "  - {force: 6 kN/m, roll: 30 um}\n");
    const double R_eff = 0.0075, k = 1e9, g1 = 0.25;
    assert_int_equal(r.n, 120);
    for (int i = 0; i < r.n; i++) {
        const tr_contact_state *s = &r.state[0][i], *w = &r.state[1][i];
        double j = i + 1, slide = i < 7 ? 2e-6 * j / 7 : i < 20 ? 2e-6 - 7e-6 * (j - 7) / 13 : -5e-6;
        double roll = i < 7 ? -5e-6 * j / 7 : i < 20 ? -5e-6 + 4e-6 * (j - 7) / 13 : -1e-6 + 30e-6 * (j - 20) / 100;
        double P = i < 7 ? 9e3 : i < 20 ? 9e3 - 3e3 * (j - 7) / 13 : 6e3;
        assert_int_equal(s->segment, i < 7 ? 0 : i < 20 ? 1 : 2);
        assert_close(s->u_slide, slide, 1e-13, 1e-20);
        assert_close(s->u_roll, roll, 1e-13, 1e-20);
        assert_close(s->P, P, 1e-14, 0);
        assert_close(s->a, sqrt(4 * P * R_eff / (M_PI * 70e9 / (2 * 0.91))), 1e-14, 0);
        assert_close(s->Q, k * slide, 1e-12, 1e-9);
        assert_close(s->q, k * slide / (100 * P), 1e-12, 1e-15);
        /* V_r of bagi-kuhn is -roll', of wang -roll' + (1/2 - g1) slide' */
        assert_close(s->moment_1, R_eff * k * roll, 1e-12, 1e-11);
        assert_close(w->moment_1, R_eff * k * (roll - (0.5 - g1) * slide), 1e-12, 1e-11);
        assert_close(s->moment_2, -s->moment_1, 0, 0);
        assert_close(w->Q, 0, 0, 0);
        assert_close(w->q, 0, 0, 0);
    }
    end(&r);
}

/* A capped spring on a monotone piece of a path, force constant or falling: Q = Q0 + k u, but within mu P. */
static void coulomb_reversals(void **state) {
    (void)state;
    run r = drive(BODIES "laws: [{friction: coulomb-spring, mu: 0.5, k_t: 1 GPa}]\n"
                         "path:\n"
                         "  - {force: 1 kN/m, slide: 0.8 um}\n"                /* slips from 0.5 um on */
                         "  - {force: 1 kN/m, slide: -0.3 um, roll: 1 mm}\n"   /* back, no slip */
                         "  - {force: 1 kN/m, slide: 0.1 um, roll: -2 mm}\n"   /* and forth, no slip */
                         "  - {force: 0.4 kN/m, steps: 50}\n"                  /* the bound comes down to Q */
                         "  - {force: 0.2 kN/m, slide: -1 um, steps: 200}\n"); /* reversed slip, bound still falling */
    for (int i = 0; i < r.n; i++) {
        const tr_contact_state *s = &r.state[0][i];
        double j = i + 1, part = fmod(i, 100) + 1, Q;
        if (i < 100)
            Q = fmin(8 * part, 500);
        else if (i < 200)
            Q = 500 - 3 * part;
        else if (i < 300)
            Q = 200 + part;
        else if (i < 350)
            Q = fmin(300, 0.5 * (1000 - 600 * (j - 300) / 50));
        else
            Q = fmax(200 - 5 * (j - 350), -0.5 * (400 - (j - 350)));
        assert_close(s->Q, Q, 1e-12, 1e-9);
        assert_close(s->q, Q / (0.5 * s->P), 1e-12, 1e-12);
        assert_true(fabs(s->q) <= 1 + 1e-15);
    }
    assert_close(r.state[0][r.n - 1].Q, -100, 1e-12, 0);
    end(&r);
}

static void rolling_reversals(void **state) {
    (void)state;
    run r = drive(BODIES "laws: [{rolling: wang-spring, mu_r: 0.2, k_r: 1 GPa}]\n"
                         "path:\n"
                         "  - {force: 1 kN/m, roll: 0.5 um}\n"
                         "  - {force: 1 kN/m, roll: -0.5 um}\n"
                         "  - {force: 0.5 kN/m, roll: 0.5 um}\n");
    const double R_eff = 0.0075;
    for (int i = 0; i < r.n; i++) {
        double part = i % 100 + 1, T; /* moment_1/R_eff, of the sign of the roll */
        if (i < 100)
            T = fmin(5 * part, 200);
        else if (i < 200)
            T = fmax(200 - 5 * part, -200);
        else
            T = fmin(-200 + 5 * part, 0.2 * (1000 - 5 * part)); /* away from a bound that comes down */
        assert_close(r.state[0][i].moment_1, R_eff * T, 1e-12, 1e-12);
        assert_close(r.state[0][i].moment_2, -R_eff * T, 1e-12, 1e-12);
    }
    end(&r);
}

/* z = sqrt(1 - q) after rolling L = tau (pi/2) (E_star/k) a at constant creepage from rest:
 * (1 - z) + alpha ln((z + alpha)/(1 + alpha)) = tau, alpha = xi/F0 - 1; full slip where z reaches 0. */
static double constant_creepage(double alpha, double tau) {
    double low = fmax(0, -alpha), high = 1; /* the left side falls from low to high */
    for (int i = 0; i < 200; i++) {
        double z = 0.5 * (low + high), left = 1 - z + alpha * log((z + alpha) / (1 + alpha));
        if (left > tau)
            low = z;
        else
            high = z;
    }
    return 1 - high * high;
}

/* Largest error in q of Dahlberg-Alfredsson over a roll of 4 a, in that many steps. */
static double creep_error(double ratio, double way, int steps) {
    char text[600];
    const double mu = 0.3, R = 0.0075, E_star = 70e9 / (2 * 0.91), P = 1e4, k = 0.35 * E_star;
    const double a = sqrt(4 * P * R / (M_PI * E_star)), F0 = mu * a / R;
    snprintf(text, sizeof text,
             BODIES "laws: [{friction: dahlberg-alfredsson, mu: 0.3, k_t: 0.35*E_star}]\n"
                    "path: [{force: 10 kN/m, roll: %g*4*a, slide: %.17g*4*a, steps: %d}]\n",
             way, ratio * F0, steps);
    run r = drive(text);
    double worst = 0;
    for (int i = 0; i < r.n; i++) {
        const tr_contact_state *s = &r.state[0][i];
        double tau = 2 / M_PI * k / E_star * 4 * (i + 1) / steps;
        worst = fmax(worst, fabs(s->q - constant_creepage(ratio - 1, tau)));
        assert_close(s->Q, mu * P * s->q, 1e-12, 0);
        assert_true(s->q <= 1);
    }
    end(&r);
    return worst;
}

static void creep_closed_form(void **state) {
    (void)state;
    const double ratios[] = {0.1, 0.5, 0.9, 1.5, 4};
    for (int i = 0; i < 5; i++) {
        double coarse = creep_error(ratios[i], 1, 200), fine = creep_error(ratios[i], 1, 400),
               finest = creep_error(ratios[i], 1, 3200);
        print_message("xi/F0 = %g: error in q %.2e, %.2e, %.2e in 200, 400, 3200 steps over 4 a\n", ratios[i], coarse,
                      fine, finest);
        assert_true(finest < 1e-3);
        assert_true(coarse / fine > 1.7 && coarse / fine < 2.3);        /* first order */
        assert_close(creep_error(ratios[i], -1, 200), coarse, 1e-9, 0); /* which way it rolls does not matter */
    }
}

/* E_star of a law is that of the bodies unless it is given. */
static void own_contact_modulus(void **state) {
    (void)state;
    run r = drive(BODIES "laws:\n"
                         "  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: 1 GPa}\n"
                         "  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: 1 GPa, E_star: E_star}\n"
                         "  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: 1 GPa, E_star: 2*E_star}\n"
                         "path: [{force: 1 kN/m, slide: 0.2 um, roll: 10*a}]\n");
    for (int i = 0; i < r.n; i++) assert_close(r.state[0][i].Q, r.state[1][i].Q, 0, 0);
    assert_true(r.state[2][r.n - 1].Q > r.state[0][r.n - 1].Q * 1.01);
    end(&r);
}

#define HEAVY "kind: contact\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3, density: 2700}\n"

/* At P = 0 nothing acts, and what follows is as if the contact were new. */
static void opening_forgets(void **state) {
    (void)state;
    const char *then = "  - {force: 1 kN/m, slide: 0.1 um, roll: 3 um, steps: 50, time: 1 ms}\n"
                       "  - {force: 0.5 kN/m, slide: -0.1 um, roll: -5 um, steps: 50, time: 1 ms}\n";
    char old[5000], new[5000];
    laws_text laws = {""};
    bool pulls = false;
    add_laws(&laws, TR_SHAPE_DISK, false);
    snprintf(new, sizeof new, HEAVY "laws:\n%spath:\n  - {force: 0, time: 1 ms, steps: 1}\n%s", laws.s, then);
    snprintf(old, sizeof old,
             HEAVY "laws:\n%spath:\n  - {force: 1 kN/m, slide: 0.4 um, roll: 2 um, time: 1 ms, steps: 9}\n"
                   "  - {force: 0, slide: 0.2 um, roll: 2 um, time: 1 ms, steps: 20}\n%s",
             laws.s, then);
    run fresh = drive(new), again = drive(old);
    for (int l = 0; l < fresh.scene.n_laws; l++) {
        const tr_contact_state *open = &again.state[l][28], *held = &again.state[l][8];
        assert_true(fabs(held->Q) + fabs(held->moment_1) > 0);
        assert_true(open->P == 0 && open->Q == 0 && open->q == 0 && open->a == 0);
        assert_true(open->moment_1 == 0 && open->moment_2 == 0 && open->f_r == 0);
        for (int i = 0; i < 100; i++) {
            const tr_contact_state *f = &fresh.state[l][1 + i], *a = &again.state[l][29 + i];
            assert_true(f->Q == a->Q && f->q == a->q && f->moment_1 == a->moment_1 && f->moment_2 == a->moment_2);
            assert_true(f->f_r == a->f_r && isfinite(f->Q) && isfinite(f->moment_1) && isfinite(f->f_r));
            pulls |= f->f_r != 0;
        }
    }
    assert_true(pulls);
    end(&fresh);
    end(&again);
}

/* The time of a segment: without meaning for most laws, asked for where it has one. */
static void time_counts_where_it_must(void **state) {
    (void)state;
    run r = drive(BODIES "laws: [{friction: dahlberg-alfredsson, mu: 0.3, k_t: 1 GPa}]\n"
                         "path: [{force: 1 kN/m, slide: 1 um, roll: a}]\n");
    run slow = drive(BODIES "laws: [{friction: dahlberg-alfredsson, mu: 0.3, k_t: 1 GPa}]\n"
                            "path: [{force: 1 kN/m, slide: 1 um, roll: a, time: 1e6}]\n");
    for (int i = 0; i < r.n; i++) assert_close(slow.state[0][i].Q, r.state[0][i].Q, 1e-12, 0);
    end(&r);
    end(&slow);
    refused(
        BODIES "laws: [{}, {rolling: star-displacement-damping, damping: yes}]\npath: [{force: 1, time: 1}]\n",
        "a.yaml:2:9: error: `bodies.density` is missing: rolling law star-displacement-damping of `laws.1` depends on "
        "the inertia of the bodies");
    refused(
        HEAVY
        "laws: [{}, {rolling: star-displacement-damping, damping: yes}]\npath: [{force: 1, time: 1}, {force: 2}]\n",
        "a.yaml:4:29: error: `path.1.time` is missing: rolling law star-displacement-damping of `laws.1` depends on "
        "the rate");
    r = drive(HEAVY "laws: [{rolling: star-displacement-damping, damping: yes}]\n"
                    "path: [{force: 1 kN/m, roll: 1 um, time: 1 ms}]\n");
    slow = drive(HEAVY "laws: [{rolling: star-displacement-damping, damping: yes}]\n"
                       "path: [{force: 1 kN/m, roll: 1 um, time: 1 s}]\n");
    assert_true(fabs(r.state[0][50].moment_1) > 2 * fabs(slow.state[0][50].moment_1));
    end(&r);
    end(&slow);
}

/* Overlap in place of force, for each normal law: P and a by the closed forms, linear in the overlap; two laws on one
 * path have forces of their own; a path that opens the contact leaves nothing, and starts again. */
static void overlaps(void **state) {
    (void)state;
    run r = drive("kind: contact\nbodies: {shape: sphere, R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3}\n"
                  "laws:\n"
                  "  - {friction: coulomb-spring, mu: 100, k_t: 1 MN/m}\n"
                  "  - {normal: linear, k_n: 2 MN/m, friction: coulomb-spring, mu: 100, k_t: 1 MN/m}\n"
                  "path:\n"
                  "  - {overlap: 2 um, slide: 1 um, steps: 10}\n"
                  "  - {overlap: 5 um, slide: 1 um, steps: 10}\n"
                  "  - {force: 12 N, slide: 1 um, steps: 10}\n"
                  "  - {overlap: -1 um, steps: 4}\n"
                  "  - {overlap: 3 um, slide: 4 um, steps: 4}\n");
    const double R = 0.0075, E = 70e9 / (2 * 0.91);
    for (int i = 0; i < r.n; i++) {
        for (int l = 0; l < 2; l++) {
            const tr_contact_state *s = &r.state[l][i];
            double x = l ? 12 / 2e6 : pow(12 / (4.0 / 3 * E * sqrt(R)), 2.0 / 3), delta, Q; /* x: the overlap at 12 N */
            if (i < 10)
                delta = 2e-6;
            else if (i < 20)
                delta = 2e-6 + 3e-6 * (i - 9) / 10;
            else if (i < 30)
                delta = NAN;
            else if (i < 34)
                delta = x + (-1e-6 - x) * (i - 29) / 4;
            else
                delta = -1e-6 + 4e-6 * (i - 33) / 4;
            double P = l ? 2e6 * delta : 4.0 / 3 * E * sqrt(R) * delta * sqrt(delta);
            if (i >= 20 && i < 30) {
                double at_5 = l ? 10 : 4.0 / 3 * E * sqrt(R) * 5e-6 * sqrt(5e-6);
                P = at_5 + (12 - at_5) * (i - 19) / 10;
                delta = l ? P / 2e6 : pow(P / (4.0 / 3 * E * sqrt(R)), 2.0 / 3);
            }
            if (!(delta > 0)) P = 0;
            assert_close(s->overlap, delta, 1e-13, 1e-20);
            assert_close(s->P, P, 1e-13, 1e-12);
            assert_close(s->a, cbrt(3 * P * R / (4 * E)), 1e-13, 1e-18);
            if (i < 30)
                Q = 1e6 * 1e-7 * (i + 1);
            else if (i < 34)
                Q = delta > 0 ? 3 : 0;
            else /* from the first step with a contact on */
                Q = delta > 0 ? 1e6 * 1e-6 * (i - 33 - 1) : 0;
            assert_close(s->Q, Q, 1e-12, 1e-12);
        }
    }
    end(&r);
}

/* The motion is prescribed: sign laws do not slow down as if they could stop it. Full moment at any speed and step,
 * none at rest; and without the dashpot no law here knows time or inertia. R1 = 10, R2 = 30 mm, P = 1 kN/m. */
static void sign_laws_at_any_speed(void **state) {
    (void)state;
    static const char *const times[] = {"1e-6", "1", "1e6"};
    for (int k = 0; k < 3; k++) {
        char text[800];
        snprintf(text, sizeof text,
                 BODIES "laws:\n"
                        "  - {rolling: star-constant-torque, mu_r: 0.1}\n"
                        "  - {rolling: star-force-proportional, mu_r: 0.1}\n"
                        "  - {rolling: star-displacement-damping, mu_r: 0.1}\n"
                        "path:\n"
                        "  - {force: 1 kN/m, roll: 1 mm, time: %s, steps: %d}\n"
                        "  - {force: 1 kN/m, time: %s, steps: 2}\n",
                 times[k], 10 + 100 * k, times[k]);
        run r = drive(text);
        const tr_contact_state *torque = r.state[0], *arm = r.state[1], *spring = r.state[2];
        for (int i = 0; i < r.n; i++) {
            double on = i < r.n - 2; /* material runs along t: body 1 turns clockwise */
            assert_close(torque[i].moment_1, on * 0.1 * 0.015 * 1e3, 1e-14, 0);
            assert_close(torque[i].moment_2, -on * 0.1 * 0.015 * 1e3, 1e-14, 0);
            assert_close(arm[i].moment_1, on * 0.1 * 0.01 * 1e3, 1e-14, 0);
            assert_close(arm[i].moment_2, -on * 0.1 * 0.03 * 1e3, 1e-14, 0);
        }
        assert_close(spring[r.n - 1].moment_1, 0.1 * 0.015 * 1e3, 1e-14, 0); /* 1 mm turns far beyond theta_max */
        end(&r);
    }
}

/* The exact contact beside the laws: Cattaneo's displacement without rolling, his law on a path with reversals and a
 * changing force (both to 200 elements: 1e-3 of mu P, of first order), Carter's creepage after long rolling. Not for
 * assemblies. */
static void exact_beside_laws(void **state) {
    (void)state;
    run r = drive("kind: contact\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3, Lambda: 2}\n"
                  "laws: [{friction: exact, mu: 0.3}, {friction: cattaneo-mindlin, mu: 0.3}]\n"
                  "path:\n"
                  "  - {force: 10 kN/m, slide: 0.06 um, steps: 50}\n"
                  "  - {force: 10 kN/m, slide: -0.1 um, steps: 50}\n"
                  "  - {force: 20 kN/m, slide: 0.1 um, steps: 200}\n"
                  "  - {force: 15 kN/m, steps: 200}\n"
                  "  - {force: 0, steps: 1}\n");
    for (int i = 0; i < 501; i++) assert_close(r.state[0][i].Q, r.state[1][i].Q, 0, 5e-3 * 0.3 * 2e4);
    assert_true(r.state[0][49].Q > 1000 && r.state[0][99].Q < 0 && r.state[0][500].Q == 0 && r.state[0][500].q == 0);
    assert_close(r.state[0][49].q, r.state[0][49].Q / 3e3, 1e-14, 0);
    for (int i = 0; i < 2; i++) /* q has the sign of Q; one division, so rounding only */
        assert_close(r.state[i][99].q, r.state[i][99].Q / 3e3, 1e-14, 0);
    end(&r);
    r = drive("kind: contact\nbodies: {R1: 10 mm, R2: 30 mm, E: 70 GPa, nu: 0.3, Lambda: 2}\n"
              "laws: [{friction: exact, mu: 0.3, elements: 100}]\n"
              "path: [{force: 10 kN/m, slide: -0.5*0.3*a/R_star*20*a, roll: 20*a, steps: 1000}]\n");
    assert_close(r.state[0][r.n - 1].Q, -0.75 * 3e3, 0, 5e-3 * 3e3); /* xi = F0/2: q = 1 - 1/4 */
    end(&r);
    refused("kind: bodies\ntime_end: 1\ncontact: {k_n: 1, friction: exact, mu: 1, E_star: 1 GPa, rolling: none}\n"
            "disks: [{radius: 1, x: 0, y: 0}]\n",
            "a.yaml:3:29: error: the law exact is for `kind: contact` only");
}

/* The largest numbers that a case may hold do not give NaN: a row, or an error that names the step. */
static void extremes(void **state) {
    (void)state;
    static const struct {
        const char *bodies, *law, *segment;
    } cases[] = {
        {"R1: 1e-9, R2: 1000, E: 0.001, nu: -0.999, depth: 1e6", "friction: dahlberg-alfredsson, mu: 100, k_t: 1e15",
         "force: 1e12, slide: 1000, roll: -1000, steps: 3, time: 1e-30"},
        {"R1: 1000, R2: 1e-9, E: 1e15, nu: 0.5, depth: 1", "friction: dahlberg-alfredsson, mu: 1e-300, k_t: 1e-3",
         "force: 1e-300, slide: 1e-300, roll: 1000, steps: 3"},
        {"R1: 1000, R2: 1e-9, E: 1e15, nu: 0.5, depth: 1", "rolling: wang-spring, mu_r: 1, k_r: 1e15",
         "force: 1, slide: 1, roll: 1000, steps: 3, time: 1e-308"},
    };
    for (int i = 0; i < 3; i++) {
        char text[500];
        snprintf(text, sizeof text, "kind: contact\nbodies: {%s}\nlaws: [{%s}]\npath: [{%s}]\n", cases[i].bodies,
                 cases[i].law, cases[i].segment);
        tr_scene scene;
        tr_status st = {0};
        if (!read_case(&scene, text, &st)) fail_msg("%s", st.text);
        tr_contact *contact = tr_contact_new(&scene, &st);
        tr_contact_state s;
        for (int k = 0; k < 3 && !st.code; k++) {
            if (!tr_contact_step(contact, &s, &st)) continue;
            assert_true(isfinite(s.Q) && isfinite(s.q) && isfinite(s.moment_1) && isfinite(s.moment_2));
        }
        if (st.code) assert_non_null(strstr(st.text, "error: a number of laws.0 is not finite at step "));
        assert_true(st.code == TR_OK || st.code == TR_NUMERICAL);
        tr_contact_free(contact);
        tr_scene_free(&scene);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(totals),
        cmocka_unit_test(coulomb_reversals),
        cmocka_unit_test(rolling_reversals),
        cmocka_unit_test(creep_closed_form),
        cmocka_unit_test(own_contact_modulus),
        cmocka_unit_test(opening_forgets),
        cmocka_unit_test(time_counts_where_it_must),
        cmocka_unit_test(sign_laws_at_any_speed),
        cmocka_unit_test(exact_beside_laws),
        cmocka_unit_test(overlaps),
        cmocka_unit_test(extremes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
