/* SPDX-License-Identifier: MIT */
#include "random/scenes.h"

#include "base/random.h"
#include "core/biaxial.h"
#include "core/bodies.h"
#include "laws/law.h"
#include "scene/scene.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BODIES = 8, MOST_TEXT = 1 << 16, MOST_KEYS = 64 };

/* Of all lengths, densities and moduli those of one scene fit to each other. */
typedef struct maker {
    tr_random random;
    FILE *out;
    tr_kind kind;
    tr_shape shape;
    double R, rho, K;           /* largest radius [m], density [kg/m^3], modulus [Pa] */
    const char *key[MOST_KEYS]; /* of the laws: each is written once */
    int n_keys;
    bool needs_density, needs_time;
} maker;

static double uniform(maker *m, double from, double to) {
    return from + (to - from) * tr_random_uniform(&m->random);
}
static double power(maker *m, double from, double to) {
    return pow(10, uniform(m, from, to));
}
static int whole(maker *m, int from, int to) {
    return from + (int)(tr_random_next(&m->random) % (uint32_t)(to - from + 1));
}
static bool one_in(maker *m, int n) {
    return whole(m, 1, n) == 1;
}
static double sign(maker *m) {
    return one_in(m, 2) ? -1 : 1;
}
static double clip(double x, double low, double high) {
    return fmin(fmax(x, low), high);
}

/* What 1 is of this dimension. */
static double unit(const maker *m, tr_dim dim) {
    tr_dim d = tr_dim_of(dim, m->shape);
    double mass = m->rho * m->R * m->R * m->R, time = m->R * sqrt(m->rho / m->K);
    return pow(mass, d.kg) * pow(m->R, d.m) * pow(time, d.s);
}

static void choice(maker *m, const char *choices, const char *but, char name[64]) {
    int n = 1;
    for (const char *p = choices; *p; p++) n += *p == '|';
    do {
        const char *p = choices;
        for (int k = whole(m, 0, n - 1); k > 0; k--) p = strchr(p, '|') + 1;
        snprintf(name, 64, "%.*s", (int)strcspn(p, "|"), p);
    } while (but && strcmp(name, but) == 0);
}

static void law_value(maker *m, const tr_param_table *law, const tr_param *p) {
    char name[64];
    bool number = p->dim.kg == 0 && p->dim.m == 0 && p->dim.s == 0;
    double value;
    switch (p->type) {
    case TR_REAL:
        if (p->min < 0 && number)
            value = uniform(m, p->min, p->max);
        else if (number)
            value = p->min == 0 && one_in(m, 6) ? 0 : power(m, -2, 1);
        else /* a length: wider than any contact */
            value = unit(m, p->dim) * (p->dim.kg ? power(m, -1, 0.5) : power(m, 0, 1));
        fprintf(m->out, ", %s: %.6g", p->key, clip(value, p->min, p->max));
        break;
    case TR_COUNT:
        fprintf(m->out, ", %s: %d", p->key, whole(m, (int)p->min, (int)fmin(p->max, 40)));
        break;
    case TR_CHOICE:
        choice(m, p->choices, m->kind == TR_KIND_CONTACT ? NULL : law->driver_choice, name);
        fprintf(m->out, ", %s: %s", p->key, name);
        break;
    case TR_SWITCH:
        fprintf(m->out, ", %s: %s", p->key, one_in(m, 2) ? "yes" : "no");
        break;
    default:
        break;
    }
}

static void law(maker *m, const char *slot, const tr_param_table *const *laws, int n) {
    const tr_param_table *t;
    unsigned wrong = (m->shape == TR_SHAPE_SPHERE ? TR_ONLY_DISKS : TR_ONLY_SPHERES) |
                     (m->kind == TR_KIND_CONTACT ? 0 : TR_ONLY_DRIVER);
    do t = laws[whole(m, 0, n - 1)];
    while (t->demands & wrong);
    fprintf(m->out, "%s%s: %s", slot[0] == 'n' ? "" : ", ", slot, t->name);
    m->needs_density |= t->demands & TR_NEEDS_DENSITY, m->needs_time |= slot[0] != 'n' && t->demands & TR_NEEDS_TIME;
    for (int i = 0; i < t->n; i++) {
        bool seen = false;
        for (int k = 0; k < m->n_keys; k++) seen |= strcmp(m->key[k], t->params[i].key) == 0;
        const char *fallback = t->params[i].fallback;
        bool other = fallback && (fallback[0] < '0' || fallback[0] > '9' || strchr(fallback, '*')); /* names a key */
        if (seen || (fallback && !other && one_in(m, 2)) || m->n_keys == MOST_KEYS) continue;
        m->key[m->n_keys++] = t->params[i].key;
        law_value(m, t, &t->params[i]);
    }
}

static void laws(maker *m) {
    const tr_param_catalog *c = tr_laws_catalog();
    char name[64];
    m->n_keys = 0;
    law(m, "normal", c->normal, c->n_normal);
    law(m, "friction", c->friction, c->n_friction);
    law(m, "rolling", c->rolling, c->n_rolling);
    choice(m, c->rolling_velocities, NULL, name);
    fprintf(m->out, ", rolling_velocity: %s", name);
    if (m->kind == TR_KIND_CONTACT) return; /* without overlap in its kinematics */
    choice(m, c->arms, NULL, name);
    fprintf(m->out, ", arms: %s", name);
}

/* ---- a few bodies ---- */

typedef struct place {
    double x, y, r;
} place;
typedef struct plane {
    double x, y, nx, ny;
} plane;

/* Overlaps of the start are small. */
static bool fits(const place *p, int n, const plane *walls, int n_walls) {
    const double slack = 0.011;
    const place *new = &p[n];
    for (int i = 0; i < n; i++)
        if (hypot(new->x - p[i].x, new->y - p[i].y) < new->r + p[i].r - slack * fmin(new->r, p[i].r)) return false;
    for (int w = 0; w < n_walls; w++)
        if ((new->x - walls[w].x) * walls[w].nx + (new->y - walls[w].y) * walls[w].ny < (1 - slack) * new->r)
            return false;
    return true;
}

/* Touches another, or a wall, or nothing. */
static bool put(maker *m, place *p, int n, const plane *walls, int n_walls) {
    place *new = &p[n];
    for (int tries = 0; tries < 200; tries++) {
        double turn = uniform(m, 0, 2 * M_PI), overlap = power(m, -6, -2), wide = 4 * m->R;
        new->x = uniform(m, -wide, wide), new->y = uniform(m, -wide, wide);
        if (n && one_in(m, 2)) {
            const place *to = &p[whole(m, 0, n - 1)];
            double away = new->r + to->r - overlap *fmin(new->r, to->r);
            new->x = to->x + away *cos(turn), new->y = to->y + away *sin(turn);
        } else if (n_walls && one_in(m, 2)) {
            const plane *w = &walls[whole(m, 0, n_walls - 1)];
            double off = (new->x - w->x) * w->nx + (new->y - w->y) * w->ny - (1 - overlap) * new->r;
            new->x -= off * w->nx, new->y -= off * w->ny;
        }
        if (fits(p, n, walls, n_walls)) return true;
    }
    return false;
}

static void motion(maker *m, const place *p, double speed) {
    static const char *const motions[] = {"free", "free", "free", "prescribed", "orbit", "pinned", "driven"};
    const char *is = motions[whole(m, 0, 6)];
    bool turns = strcmp(is, "free") == 0 || strcmp(is, "pinned") == 0;
    fprintf(m->out, "  - {radius: %.17g, x: %.17g, y: %.17g, motion: %s", p->r, p->x, p->y, is);
    if (strcmp(is, "prescribed") != 0 || one_in(m, 2)) fprintf(m->out, ", density: %.6g", m->rho * power(m, -1, 1));
    if (one_in(m, 2)) fprintf(m->out, ", vx: %.6g, vy: %.6g", sign(m) * speed, uniform(m, -speed, speed));
    if (one_in(m, 2)) fprintf(m->out, ", spin: %.6g", uniform(m, -speed, speed) / p->r);
    if (one_in(m, 4)) fprintf(m->out, ", angle: %.6g", uniform(m, -10, 10));
    if (turns && one_in(m, 4))
        fprintf(m->out, ", torque: %.6g", unit(m, (tr_dim)TR_DIM_MOMENT) * sign(m) * power(m, -9, -4));
    if (strcmp(is, "orbit") == 0) {
        double x = p->x + uniform(m, -3, 3) * m->R, y = p->y + uniform(m, -3, 3) * m->R;
        fprintf(m->out, ", orbit: %.6g, orbit_x: %.17g, orbit_y: %.17g",
                sign(m) * speed / (m->R + hypot(x - p->x, y - p->y)), x, y);
    }
    fprintf(m->out, "}\n");
}

static void write_output(maker *m, int disks, int walls, const char *more) {
    fprintf(m->out, "output: {frames: %d, rows: %d, contacts: %d", one_in(m, 20) ? whole(m, 1, 2) : 0, whole(m, 3, 40),
            whole(m, 0, 3));
    if (disks > 1 && one_in(m, 3)) {
        fprintf(m->out, ", paths: [%s", one_in(m, 2) ? "most-mobilised, " : "");
        fprintf(m->out, "0-%d", whole(m, 1, disks - 1));
        if (walls) fprintf(m->out, ", wall%d-%d", whole(m, 0, walls - 1), whole(m, 0, disks - 1));
        fprintf(m->out, "]");
    }
    fprintf(m->out, "%s}\n", more);
}

static void write_checks(maker *m, int disks) {
    static const char *const of_disk[] = {"speed", "acceleration", "stop-time", "stop-distance",
                                          "spin",  "torque",       "power"};
    static const char *const of_contact[] = {"sliding-velocity", "rolling-velocity", "power-lost", "slip-ends",
                                             "slip-starts"};
    fprintf(m->out, "checks:\n  - {what: %s, disk: %d, exact: 0, tolerance: 1e30}\n", of_disk[whole(m, 0, 6)],
            whole(m, 0, disks - 1));
    if (disks > 1)
        fprintf(m->out, "  - {what: %s, contact: 0-%d, exact: 0, tolerance: 1e30}\n", of_contact[whole(m, 0, 4)],
                whole(m, 1, disks - 1));
}

static void bodies(maker *m) {
    enum { MOST_WALLS = 4 };
    plane walls[MOST_WALLS];
    place p[MOST_BODIES + 1];
    int n = 0, asked = whole(m, 1, MOST_BODIES), n_walls = whole(m, 0, MOST_WALLS);
    double speed = sqrt(m->K / m->rho) * (one_in(m, 4) ? power(m, -1.5, -0.3) : power(m, -6, -1.5)),
           ratio = one_in(m, 2) ? power(m, 0, 2) : 1, turn = uniform(m, 0, 7);
    for (int w = 0; w < n_walls; w++, turn += uniform(m, 0.8, 2)) {
        double nx = cos(turn), ny = sin(turn), d = uniform(m, 2, 4) * m->R;
        walls[w] = (plane){-d * nx, -d * ny, nx, ny};
    }
    for (int i = 0; i < asked; i++) {
        p[n].r = m->R * pow(ratio, i ? -tr_random_uniform(&m->random) : 0);
        n += put(m, p, n, walls, n_walls);
    }
    if (!n) p[n++] = (place){0, 0, m->R};
    fprintf(m->out, "contact: {");
    laws(m);
    fprintf(m->out, "}\nstep: {safety: %.6g}\ndisks:\n", one_in(m, 2) ? 0.1 : uniform(m, 0.02, 0.5));
    for (int i = 0; i < n; i++) motion(m, &p[i], speed);
    if (n_walls) fprintf(m->out, "walls:\n");
    for (int w = 0; w < n_walls; w++) {
        fprintf(m->out, "  - {x: %.17g, y: %.17g, nx: %.17g, ny: %.17g", walls[w].x, walls[w].y, walls[w].nx,
                walls[w].ny);
        if (one_in(m, 3)) fprintf(m->out, ", vx: %.6g, vy: %.6g", sign(m) * speed, uniform(m, -speed, speed));
        fprintf(m->out, "}\n");
    }
    if (one_in(m, 2)) {
        double g = fmin(m->K / (m->rho * m->R) * power(m, -7, -3), 1e9);
        fprintf(m->out, "gravity: {x: %.6g, y: %.6g", uniform(m, -g, g), -g);
        fprintf(m->out, ", turn: %.6g}\n",
                one_in(m, 3) ? sign(m) * fmin(power(m, -3, 0) * sqrt(m->K / m->rho) / m->R, 1e6) : 0);
    }
    if (one_in(m, 4)) write_checks(m, n);
    write_output(m, n, n_walls, one_in(m, 2) ? "" : ", curve: velocities");
    if (one_in(m, 6)) fprintf(m->out, "---\nlabel: beside it\nstep: {safety: %.6g}\n", uniform(m, 0.02, 0.5));
}

/* ---- a biaxial test ---- */

static void biaxial(maker *m) {
    bool periodic = one_in(m, 2), wide = one_in(m, 3);
    double ratio = wide ? power(m, 0.5, 2) : uniform(m, 1, 3), pressure = power(m, wide ? -3 : -4, -2.2);
    char more[128];
    static const char *const color[] = {"mobilisation", "sliding", "rolling", "slip", "spin"};
    int n = whole(m, periodic ? 16 : 2, 36);
    fprintf(m->out, "seed: %d\nboundary: %s\nsample: {disks: %d, r_min: %.6g, r_max: %.6g, density: %.6g}\ncontact: {",
            whole(m, 1, 1000000), periodic ? "periodic" : "walls", n, m->R / ratio, m->R, m->rho);
    laws(m);
    bool mu = false;
    for (int k = 0; k < m->n_keys; k++) mu |= strcmp(m->key[k], "mu") == 0;
    pressure = fmax(pressure * unit(m, (tr_dim)TR_DIM_STRESS), 2e-3); /* 1e-3 is the least; the lateral one may be
                                                                       * half */
    fprintf(m->out, "}\nstep: {safety: %.6g}\n", one_in(m, 2) ? 0.4 : uniform(m, 0.05, 0.8));
    snprintf(more, sizeof more, ", curves: no, energy: %s, increments: %s, path_rows: %d, color: %s",
             one_in(m, 4) ? "no" : "yes", one_in(m, 3) ? "yes" : "no", one_in(m, 4) ? whole(m, 1, 20) : 0,
             color[whole(m, 0, 4)]);
    write_output(m, n, periodic ? 0 : 4, more);
    /* Last, since their numbers follow from the step: see finish(). */
    fprintf(m->out, "compaction: {pressure: %.6g, mu: %.6g, unbalanced: %.6g", pressure,
            mu && one_in(m, 3) ? power(m, -2, 0) : 0, power(m, -2.5, -1));
    fprintf(m->out,
            ", inertial_number: COMPACTION}\nshear: {lateral_pressure: %.6g, %s, inertial_number: SHEAR, strain_end: "
            "STRAIN}\n",
            pressure * (one_in(m, 2) ? 1 : uniform(m, 0.5, 2)),
            periodic ? (one_in(m, 2) ? "hold: mean" : "hold: lateral")
                     : (one_in(m, 2) ? "walls: rough" : "walls: smooth"));
}

/* ---- one contact ---- */

static void pair(maker *m) {
    double other = m->R * power(m, one_in(m, 2) ? -2 : -0.3, 0);
    fprintf(m->out, "bodies: {R1: %.6g, R2: %.6g, E: %.6g, nu: %.6g", one_in(m, 2) ? m->R : other, other, m->K,
            uniform(m, -0.5, 0.5));
}

static double force(maker *m) {
    return unit(m, (tr_dim)TR_DIM_FORCE) * power(m, -9, -6);
}

/* In contact widths or so, whatever the sizes are. */
static double way(maker *m) {
    return sign(m) * m->R * power(m, -7, -2);
}

static void contact(maker *m) {
    int n_laws = whole(m, 1, 4), segments = whole(m, 1, 5);
    pair(m);
    fprintf(m->out, ", shape: %s, density: %.6g}\nlaws:\n", m->shape == TR_SHAPE_SPHERE ? "sphere" : "disk", m->rho);
    for (int i = 0; i < n_laws; i++) {
        fprintf(m->out, "  - {");
        laws(m);
        fprintf(m->out, "}\n");
    }
    fprintf(m->out, "path:\n");
    for (int i = 0; i < segments; i++) {
        bool overlap = one_in(m, 4), open = i && one_in(m, 6);
        fprintf(m->out, "  - {%s: %.6g, steps: %d", overlap ? "overlap" : "force",
                open ? (overlap ? -1e-6 * m->R : 0) : (overlap ? m->R * power(m, -7, -4) : force(m)), whole(m, 1, 100));
        if (one_in(m, 2)) fprintf(m->out, ", slide: %.6g", way(m));
        if (one_in(m, 2)) fprintf(m->out, ", roll: %.6g", way(m));
        fprintf(m->out, ", time: %.6g}\n", m->R * sqrt(m->rho / m->K) * power(m, 0, 4));
    }
    fprintf(m->out, "output: {curves: no}\n");
}

static void patch(maker *m) {
    static const char *const solvers[] = {"half-plane", "half-plane", "brush", "carter", "cattaneo"};
    int solver = whole(m, 0, 4), segments = whole(m, 1, 4);
    double mu = power(m, -2, 0.5), f = force(m), way_one = sign(m), pushed = 0;
    bool push = one_in(m, 2);
    pair(m);
    fprintf(m->out, "}\nmu: %.6g\nsolver: %s\nelements: %d\n", mu, solvers[solver], whole(m, 3, 60));
    if (one_in(m, 2)) fprintf(m->out, "Lambda: %.6g\n", uniform(m, 6, 20));
    fprintf(m->out, "path:\n");
    for (int i = 0; i < segments; i++) {
        if (solver < 4) f *= power(m, -1, 0.3), push = one_in(m, 2);
        pushed = solver < 4 ? uniform(m, -0.99, 0.99) : way_one * (fabs(pushed) + uniform(m, 0, 0.24));
        fprintf(m->out, "  - {force: %.6g, steps: %d", f, whole(m, 1, 60));
        if (push)
            fprintf(m->out, ", tangential: %.6g", pushed * mu * f);
        else
            fprintf(m->out, ", slide: %.6g", way_one * fabs(way(m)));
        if (solver < 4 && (solver == 3 || one_in(m, 2))) fprintf(m->out, ", roll: %.6g", way(m));
        fprintf(m->out, "}\n");
    }
    fprintf(m->out, "output: {curves: no, frames: %d, snapshots: %d}\n", one_in(m, 20) ? 1 : 0, whole(m, 0, 4));
}

/* ---- how long ---- */

static bool replace(char *text, const char *name, double value) {
    char *at = strstr(text, name), rest[MOST_TEXT], number[32];
    if (!at) return false;
    snprintf(number, sizeof number, "%.6g", value);
    snprintf(rest, sizeof rest, "%s", at + strlen(name));
    snprintf(at, MOST_TEXT - (size_t)(at - text), "%s%s", number, rest);
    return true;
}

/* A scene of at most some ten thousand steps: its step is known when it is read with any length. */
static bool finish(maker *m, char *text, tr_status *st) {
    /* no compaction, no strain, no time */
    static const char *const sets[2][3] = {
        {"compaction.inertial_number=1", "shear.inertial_number=1", "shear.strain_end=1e-9"}, {"time_end=1e-12"}};
    tr_scene scene;
    if (m->kind == TR_KIND_CONTACT || m->kind == TR_KIND_PATCH) return true;
    bool tests = m->kind == TR_KIND_BIAXIAL;
    if (!tr_scene_read(&scene, &(tr_scene_source){"draft", text, strlen(text), sets[!tests], tests ? 3 : 1},
                       tr_laws_catalog(), st))
        return false;
    double steps = power(m, 1.5, 3.3);
    bool ok;
    if (tests) {
        tr_biaxial b;
        double I = power(m, -3, -1.3);
        ok = tr_biaxial_init(&b, &scene, st);
        if (ok) {
            double a_step = sqrt(scene.compaction.pressure / b.mean_mass);
            double sheared = I * sqrt(scene.shear.lateral_pressure / b.mean_mass) * b.dt;
            double closing = 1 / (a_step * b.world.dt); /* steps at I = 1; it takes a few times as many */
            if (closing > 2000) ok = tr_status_fail(st, TR_BAD_CASE, "compaction would be too long for a test");
            replace(text, "COMPACTION", clip(closing / 1000, 1e-2, 0.5));
            replace(text, "SHEAR", I), replace(text, "STRAIN", clip(steps * sheared, 1e-6, 0.2));
            tr_biaxial_free(&b);
        }
    } else {
        tr_bodies b;
        scene.time_end = m->R * sqrt(m->rho / m->K) * 1e-3;
        scene.output.still = 0;
        for (int k = 0; k < scene.n_checks; k++) scene.checks[k].at = 0;
        ok = tr_bodies_init(&b, &scene, st);
        if (ok) {
            double dt = isfinite(b.dt_bound) ? scene.step.safety * b.dt_bound : scene.time_end;
            replace(text, "TIME", dt * steps);
            tr_bodies_free(&b);
        }
    }
    tr_scene_free(&scene);
    return ok;
}

/* What only a trial can tell: a cell that gets too thin, a pressure out of reach. */
static bool holds_together(const maker *m, const char *text, tr_status *st) {
    tr_scene scene;
    tr_biaxial b;
    if (!tr_scene_read(&scene, &(tr_scene_source){"scene", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = m->kind != TR_KIND_BIAXIAL || tr_biaxial_init(&b, &scene, st);
    if (ok && m->kind == TR_KIND_BIAXIAL) tr_biaxial_free(&b);
    tr_scene_free(&scene);
    return ok;
}

bool scenes_write(const char *path, uint64_t seed, tr_status *st) {
    static void (*const write[])(maker *) = {biaxial, bodies, contact, patch};
    static const char *const kinds[] = {"biaxial", "bodies", "contact", "patch"};
    static char text[MOST_TEXT];
    maker m = {.random = tr_random_seed(seed, 1)};
    int pick = whole(&m, 0, 9); /* as often as there is to go wrong */
    m.kind = pick < 4 ? TR_KIND_BIAXIAL : pick < 8 ? TR_KIND_BODIES : pick < 9 ? TR_KIND_CONTACT : TR_KIND_PATCH;
    m.shape = m.kind != TR_KIND_PATCH && one_in(&m, 3) ? TR_SHAPE_SPHERE : TR_SHAPE_DISK;
    m.R = power(&m, -5, 1), m.rho = power(&m, 1, 4), m.K = power(&m, 4, 10);
    memset(text, 0, sizeof text);
    m.out = fmemopen(text, sizeof text, "w");
    fprintf(m.out, "kind: %s\n", kinds[m.kind]);
    if (m.kind == TR_KIND_BIAXIAL || m.kind == TR_KIND_BODIES)
        fprintf(m.out, "shape: %s\n", m.shape == TR_SHAPE_SPHERE ? "sphere" : "disk");
    if (m.kind == TR_KIND_BODIES) fprintf(m.out, "time_end: TIME\n");
    write[m.kind](&m);
    fclose(m.out);
    bool ok = finish(&m, text, st) && holds_together(&m, text, st);
    FILE *file = fopen(path, "w"); /* one that was refused too, to be looked at */
    if (!file) return tr_status_fail(st, TR_FILE, "cannot write %s", path);
    fputs(text, file);
    return fclose(file) == 0 && ok;
}
