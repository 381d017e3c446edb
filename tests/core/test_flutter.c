/* SPDX-License-Identifier: MIT */
/* A disk on a floor that runs under it, leaning on one that is held: one contact slides, one sticks. Friction of the
 * sliding one follows its normal force, so the stiffness is not symmetric, and without dashpots two modes may couple
 * and grow: flutter [Hoffmann2002]. In q = (x, y, R theta), of masses m, m, m/2, with e to the held disk, s the sliding
 * of that contact, and the pull of the floor p:
 *
 *   K = k_n e e' + k_t s s' + k_n p (0, 1, 0),   e = (cos a, sin a, 0),   s = (-sin a, cos a, 1),   p = (mu, 1, mu)
 *
 * The eigenvalues of M^-1 K are the roots of a cubic; a complex pair grows as Im sqrt of it. A negative root k grows as
 * sqrt(-k), and does not swing: the floor draws the disk in under the other. */
#include "core/worlds.h"

static const double R = 0.01, DENSITY = 1000, K_N = 1e6, LAP = 1e-8;

/* Growth of the exact equations, and the frequency of the mode [1/s]; growth 0: all roots are real. */
static double exact_growth(double a, double mu, double k_t, double *frequency) {
    const double e[3] = {cos(a), sin(a), 0}, s[3] = {-sin(a), cos(a), 1}, p[3] = {mu, 1, mu};
    const double m = DENSITY * M_PI * R * R, mass[3] = {m, m, m / 2};
    double A[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) A[i][j] = (K_N * e[i] * e[j] + k_t * s[i] * s[j] + (j == 1) * K_N * p[i]) / mass[i];
    double T = A[0][0] + A[1][1] + A[2][2], S = 0, D = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        S += A[i][i] * A[j][j] - A[i][j] * A[j][i];
        D += A[0][i] * (A[1][j] * A[2][k] - A[1][k] * A[2][j]);
    }
    /* x^3 - T x^2 + S x - D; its real root lies in a bracket, for the cubic is negative at -big and positive at big */
    double low = -1e3 * T, high = 1e3 * T;
    for (int i = 0; i < 200; i++) {
        double x = 0.5 * (low + high);
        *(((x - T) * x + S) * x - D > 0 ? &high : &low) = x;
    }
    double sum = T - high, product = S - high * sum, real = sum / 2, imaginary2 = product - real * real;
    *frequency = sqrt(T);
    double least = imaginary2 > 0 ? high : fmin(high, real - sqrt(-imaginary2));
    if (least < 0) return sqrt(-least);
    if (imaginary2 <= 0) return 0;
    double size = sqrt(product);
    *frequency = sqrt((size + real) / 2);
    return sqrt((size - real) / 2);
}

static void set_up(tr_world *w, double a, double mu, double k_t) {
    const double L = 2 * R - LAP, f = K_N * LAP;
    new_world(w, 2);
    tr_world_set_disk(w, 0, &(tr_disk_start){L * cos(a), R - LAP + L * sin(a), 0, R, DENSITY, true});
    tr_world_set_disk(w, 1, &(tr_disk_start){0, R - LAP, 0, R, DENSITY, false});
    w->wall[0] = (tr_wall){.ny = 1}, w->n_walls = 1;
    set_laws(w, (test_laws){.k_n = K_N, .mu = mu, .k_t = k_t}, 0);
    w->dt = 1e-12;
    forces(w);
    w->dt = 0.1 * tr_timestep_contacts(w).dt;
    w->wall[0].vx = 1e-3 * R / w->dt; /* no disturbance turns it back */
    tr_group *g = &w->group[1];
    g->hist[g->laws[TR_FRICTION].hist][listed(g, 0, 1)] = -2 * mu * f; /* cut to the bound by the first step */
    w->disks.load = calloc(8, sizeof(double));
    double *load = w->disks.load + 4;
    load[0] = f * cos(a) - mu * f, load[1] = f * sin(a) - f, load[2] = -mu * f * R;
    w->fresh = true;
}

static double fastest_in(tr_world *w, int n) {
    double most = 0;
    for (int k = 0; k < n; k++) {
        steps(w, 1);
        for (int l = 4; l < 7; l++) most = fmax(most, fabs(w->disks.vel[l]) * (l == 6 ? R : 1));
    }
    return most;
}

/* Growth of the leapfrog of the tool [1/s]; 0: none in `periods`. */
static double measured_growth(double a, double mu, double k_t, double frequency, int periods) {
    tr_world w;
    set_up(&w, a, mu, k_t);
    double tiny = 1e-8 * LAP * frequency, growth = 0, first = 0, now = 0;
    int period = (int)(2 * M_PI / frequency / w.dt), from = 0;
    set_velocity(&w, 1, tiny, -0.3 * tiny, 0.5 * tiny / R);
    for (int k = 0; k < periods && now < 1e5 * tiny; k++) {
        now = fastest_in(&w, period);
        if (first == 0 && now > 1e2 * tiny) first = now, from = k; /* other modes are a hundredth now */
        if (k > from && first > 0) growth = log(now / first) / ((k - from) * period * w.dt);
    }
    tr_world_free(&w);
    return growth;
}

static void test_flutter_of_one_disk(void **state) {
    (void)state;
    int grow = 0, rest = 0;
    for (int i = 1; i < 12; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 2; k++) {
                double a = i * M_PI / 12, mu = (double[]){0.2, 0.5, 1}[j], k_t = K_N * (k ? 1 : 0.5), frequency;
                double exact = exact_growth(a, mu, k_t, &frequency);
                if (exact > 0 && exact < 0.01 * frequency) continue; /* takes too long to see */
                /* ln 1e3 of growth takes 115 periods at 0.01 of the frequency */
                double tool = measured_growth(a, mu, k_t, frequency, 400);
                if (exact == 0) {
                    if (tool != 0) fail_msg("angle %.0f deg, mu %.1f, k_t %.1g: grows", 15.0 * i, mu, k_t);
                    rest++;
                    continue;
                }
                /* a tenth of the bound: (dt w)^2/8 = 0.5 % at most; a hundredth of other modes at both ends, and the
                 * phase in the window, over ln 1e3: 1 % */
                assert_close(tool, exact, 0.02, 0);
                grow++;
            }
    print_message("one sliding and one sticking contact, undamped: %d cases grow, %d do not\n", grow, rest);
    assert_true(grow >= 5 && rest >= 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_flutter_of_one_disk)};
    return cmocka_run_group_tests_name("flutter", tests, NULL, NULL);
}
