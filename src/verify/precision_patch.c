/* SPDX-License-Identifier: MIT */
/* Error against time: the inside of a line contact over the number of elements. X = x/a. Each error is the root mean
 * square over four loads, because it depends on the place of the edge of stick in an element.
 *
 *   half-plane, sliding  pushed from rest to q in 20 steps [Johnson1985 sec. 7.2]:
 *                        u = (2 mu P/(pi E*)) (q (Lambda + 1/2) + (1 - q) ln(1 - q)/2)
 *   half-plane, rolling  8 a at the creepage xi = x F0 from rest, steps of an element [Carter1926]: q = x (2 - x).
 *                        Lambda = 1.5: what is left of the transient is e^(-2 (1 - x) 8/Lambda), 1e-7
 *   brush                3 a, the same: tau = min(mu p, k_w xi (x + a)); b = k_w xi a/(mu p0), X1 = (1 - b^2)/(1 +
 *                        b^2): q = (2/pi) (b (1 + X1)^2/2 + (acos X1 - X1 sqrt(1 - X1^2))/2)
 *
 * Orders: the traction turns from stick to slip within an element. Its sum, Q, is of second order if that is the whole
 * error. A rolling half-plane reads the earlier displacement between the middles of elements: first order,
 * half_plane.h.
 */
#include "patch/brush.h"
#include "patch/half_plane.h"
#include "verify/precision.h"

#include <math.h>

static const tr_patch_pair pair = {.R_star = 0.005, .E_star = 38.46e9, .d = 9.1e-5, .mu = 0.3};
static const double P = 1e4;

enum { LOADS = 4 };
static const int elements[] = {25, 50, 100, 200, 400};

/* A solver, for the sweep. */
typedef struct solver {
    void *(*open)(int n, tr_status *st);
    bool (*step)(void *o, const tr_patch_step *step, tr_status *st);
    double (*force)(const void *o);
    void (*close)(void *o);
    double (*load)(int i, int n, double *du, double *dr, int *steps); /* a step of case i; returns q in the end */
} solver;

static void *half_plane_open(int n, tr_status *st) {
    return tr_half_plane_new(&pair, n, st);
}
static bool half_plane_step(void *o, const tr_patch_step *step, tr_status *st) {
    return tr_half_plane_step(o, step, st);
}
static double half_plane_force(const void *o) {
    return tr_half_plane_state(o)->Q;
}
static void half_plane_close(void *o) {
    tr_half_plane_free(o);
}
static void *brush_open(int n, tr_status *st) {
    return tr_brush_new(&pair, n, 0, st);
}
static bool brush_step(void *o, const tr_patch_step *step, tr_status *st) {
    return tr_brush_step(o, step, st);
}
static double brush_force(const void *o) {
    return tr_brush_state(o)->Q;
}
static void brush_close(void *o) {
    tr_brush_free(o);
}

static double half_width(void) {
    return sqrt(4 * P * pair.R_star / (M_PI * pair.E_star));
}

static double sliding(int i, int n, double *du, double *dr, int *steps) {
    (void)n;
    double q = 0.5 + 0.11 * i, Lambda = log(2 * pair.d / half_width());
    *du = 2 * pair.mu * P / (M_PI * pair.E_star) * (q * (Lambda + 0.5) + 0.5 * (1 - q) * log(1 - q)) / 20;
    *dr = 0, *steps = 20;
    return q;
}

static double creepage(int i, int n, double *du, double *dr) {
    double x = 0.2 + 0.11 * i;
    *dr = 2 * half_width() / n, *du = x * pair.mu * half_width() / pair.R_star * *dr;
    return x;
}

static double rolling(int i, int n, double *du, double *dr, int *steps) {
    double x = creepage(i, n, du, dr);
    *steps = 4 * n;
    return x * (2 - x);
}

static double brush_rolling(int i, int n, double *du, double *dr, int *steps) {
    double b = M_PI / 2 * creepage(i, n, du, dr), X = (1 - b * b) / (1 + b * b); /* k_w = pi E/(4a), p0 = E a/(2R) */
    *steps = 3 * n / 2;
    return 2 / M_PI * (0.5 * b * (1 + X) * (1 + X) + 0.5 * (acos(X) - X * sqrt(1 - X * X)));
}

static bool run(void *context, int method, int k, tr_sweep_result *result, tr_status *st) {
    (void)method;
    const solver *s = context;
    int n = elements[k], steps;
    double seconds = 0, sum = 0;
    bool ok = true;
    for (int i = 0; i < LOADS && ok; i++) {
        tr_patch_step step = {.P = P};
        double q = s->load(i, n, &step.du, &step.dr, &steps);
        void *o = s->open(n, st);
        double start = tr_sweep_now();
        ok = o;
        for (int j = 0; j < steps && ok; j++) ok = s->step(o, &step, st);
        seconds += tr_sweep_now() - start;
        if (ok) sum += pow(s->force(o) / (pair.mu * P) - q, 2);
        s->close(o);
    }
    *result = (tr_sweep_result){1.0 / n, sqrt(sum / LOADS), seconds / LOADS};
    return ok;
}

static bool sweep(tr_verify *v, solver s, tr_sweep_method method, int repeats, double goal, const char *reason,
                  tr_status *st) {
    const tr_sweep w = {.step_name = "element / contact width",
                        .method = &method,
                        .methods = 1,
                        .steps = sizeof elements / sizeof *elements,
                        .repeats = repeats,
                        .usual = 3, /* 200 elements */
                        .goal = goal,
                        .reason = reason,
                        .run = run,
                        .context = &s};
    return tr_sweep_add(v, &w, st);
}

static const char edge[] = "the edge of stick falls where it falls in an element";

bool tr_precision_half_plane_sliding(tr_verify *v, tr_status *st) {
    const solver s = {half_plane_open, half_plane_step, half_plane_force, half_plane_close, sliding};
    return sweep(v, s, (tr_sweep_method){"half-plane sliding", 2, 0.5, edge}, 5, 1e-3,
                 "(1/200)^2, with room for its factor", st);
}

bool tr_precision_half_plane_rolling(tr_verify *v, tr_status *st) {
    const solver s = {half_plane_open, half_plane_step, half_plane_force, half_plane_close, rolling};
    return sweep(v, s, (tr_sweep_method){"half-plane rolling", 1, 0.3, edge}, 3, 5e-3, "first order: an element, 1/200",
                 st);
}

bool tr_precision_brush(tr_verify *v, tr_status *st) {
    const solver s = {brush_open, brush_step, brush_force, brush_close, brush_rolling};
    return sweep(v, s, (tr_sweep_method){"brush", 2, 0.5, edge}, 7, 1e-3, "(1/200)^2, with room for its factor", st);
}
