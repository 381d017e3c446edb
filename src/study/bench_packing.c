/* SPDX-License-Identifier: MIT */
/* One packing, sheared here and, from the written files, in LAMMPS (tests/bench/peers.sh).
 *
 * SCENE. The compacted sample of a biaxial test without its walls: the disks at the walls (centre within a mean
 * diameter) are a rim that moves by itself, as in a homogeneous flow: y is shortened at the rate of the shear, x
 * stretched at 0.3 of it, which keeps about 700 contacts closed. So both codes have only disks, and the load is a
 * motion, which needs no servo. All disks start with that flow.
 *
 * SAME LAWS. LAMMPS pair_style granular: the dashpot of damping tsuji is alpha(e) sqrt(k m_eff), here 2 zeta sqrt(k
 * m_eff), so e solves alpha(e) = 2 zeta; limit_damping is f_n >= 0; linear_history without dashpot is coulomb-spring;
 * rolling sds without dashpot is wang-spring with the rolling velocity wang. gran/hooke/history, which is faster, has
 * no rolling resistance and the dashpot gamma m_eff. Differences: the arms of friction, here R_k |X21|/(R1+R2), in
 * LAMMPS with no part, or another part, of the overlap.
 *
 * SAME BODIES. LAMMPS has a sphere's mass from diameter and density, so the density is 3/(4R) times that of a disk of 1
 * m length; fix nve/sphere disc has m R^2/2.
 * SAME TIME. Velocity Verlet makes the half step v + dt/2 F/m, leapfrog has it: LAMMPS starts with v^(-1/2) + dt/2 F/m,
 * and the kinetic energies are those of v^(n-1/2) + dt/2 F/m. */
#include "study/bench_packing.h"

#include "core/pipeline.h"

#include "core/biaxial.h"
#include "core/record.h"
#include "core/step.h"
#include "laws/law.h"
#include "out/dir.h"
#include "study/bench_sizes.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool is_rim(const tr_world *world, int i) {
    return world->disks.inv[tr_body(i)] == 0;
}

static void make_rim(tr_biaxial *b) {
    tr_world *world = &b->world;
    const tr_wall *w = world->wall;
    double x = (w[TR_LEFT_WALL].x + w[TR_RIGHT_WALL].x) / 2, y = (w[TR_BOTTOM_WALL].y + w[TR_TOP_WALL].y) / 2;
    for (int i = 0; i < world->disks.n; i++) {
        double *q = world->disks.pos + tr_body(i), *v = world->disks.vel + tr_body(i), near = INFINITY;
        for (int k = 0; k < world->n_walls; k++)
            near = fmin(near, (q[0] - w[k].x) * w[k].nx + (q[1] - w[k].y) * w[k].ny);
        v[0] = 0.3 * b->rate * (q[0] - x), v[1] = -b->rate * (q[1] - y), v[2] = 0;
        tr_world_set_disk(world, i,
                          &(tr_disk_start){q[0], q[1], 0, q[3], b->scene->sample.density, near < 2 * b->mean_radius});
    }
    world->n_walls = 0, world->boxed = false;
}

/* Velocity k of disk i at the time of its position. */
static double velocity(const tr_world *world, int i, int k) {
    size_t at = tr_body(i) + (size_t)k;
    return world->disks.vel[at] + world->dt / 2 * world->disks.inv[at] * world->disks.force[at];
}

static bool write_data(const tr_world *world, const char *dir, tr_status *st) {
    tr_file file = {0};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    if (!tr_file_open(&file, dir, "packing.data", st)) return false;
    for (int i = 0; i < world->disks.n; i++)
        for (int k = 0; k < 2; k++) {
            const double *q = world->disks.pos + tr_body(i);
            low[k] = fmin(low[k], q[k] - 4 * q[3]), high[k] = fmax(high[k], q[k] + 4 * q[3]);
        }
    fprintf(file.stream, "a packing of disks; type 2: the rim\n\n%d atoms\n2 atom types\n", world->disks.n);
    fprintf(file.stream, "%.17g %.17g xlo xhi\n%.17g %.17g ylo yhi\n", low[0], high[0], low[1], high[1]);
    fputs("-1 1 zlo zhi\n\nAtoms # sphere\n\n", file.stream);
    for (int i = 0; i < world->disks.n; i++) {
        const double *q = world->disks.pos + tr_body(i), R = q[3];
        fprintf(file.stream, "%d %d %.17g %.17g %.17g %.17g 0\n", i + 1, is_rim(world, i) ? 2 : 1, 2 * R,
                world->disks.mass[i] / (4.0 / 3 * M_PI * R * R * R), q[0], q[1]);
    }
    fputs("\nVelocities\n\n", file.stream);
    for (int i = 0; i < world->disks.n; i++)
        fprintf(file.stream, "%d %.17g %.17g 0 0 0 %.17g\n", i + 1, velocity(world, i, 0), velocity(world, i, 1),
                velocity(world, i, 2));
    return tr_file_commit(&file, st);
}

/* The restitution coefficient for a damping ratio: [Tsuji1992 fig. 2], as in LAMMPS. */
static double restitution(double zeta) {
    double low = 0, high = 1;
    for (int k = 0; k < 60; k++) {
        double e = (low + high) / 2,
               alpha =
                   1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
        *(alpha > 2 * zeta ? &low : &high) = e;
    }
    return low;
}

static bool write_variables(const tr_biaxial *b, const char *dir, tr_status *st) {
    static const char *const keys[TR_N_LAW_KINDS][2] = {{"k_n", "damping_ratio"}, {"mu", "k_t"}, {"mu_r", "k_r"}};
    static const char *const laws[] = {"linear", "coulomb-spring", "wang-spring"};
    tr_file file = {0};
    if (!tr_file_open(&file, dir, "packing.lmp", st)) return false;
    const tr_group_law *normal = &b->world.group[0].laws[TR_NORMAL];
    fprintf(file.stream, "variable dt equal %.17g\nvariable diameter equal %.17g\n", b->world.dt, 2 * b->mean_radius);
    for (int k = 0; k < TR_N_LAW_KINDS; k++) {
        const tr_group_law *slot = &b->world.group[0].laws[k];
        if (k == TR_ROLLING && !slot->law->step) continue;
        if (strcmp(slot->law->table.name, laws[k])) {
            tr_file_discard(&file);
            return tr_status_fail(st, TR_BAD_CASE, "error: LAMMPS has no %s; the law here is %s", slot->law->table.name,
                                  laws[k]);
        }
        for (int p = 0; p < 2; p++)
            fprintf(file.stream, "variable %s equal %.17g\n", keys[k][p],
                    *tr_law_value(slot->law, slot->par, keys[k][p]));
    }
    double zeta = *tr_law_value(normal->law, normal->par, "damping_ratio"),
           k_n = *tr_law_value(normal->law, normal->par, "k_n");
    /* gran/hooke/history knows only gamma m_eff: right for two mean disks */
    fprintf(file.stream, "variable e equal %.17g\nvariable gamma equal %.17g\n", restitution(zeta),
            2 * zeta * sqrt(k_n / (b->mean_mass / 2)));
    return tr_file_commit(&file, st);
}

static bool look(tr_world *world, tr_bench_state *s, tr_status *st) {
    tr_record *records = NULL;
    int capacity = 0, n = tr_record_all(world, &records, &capacity, st);
    *s = (tr_bench_state){.touching = n};
    for (int i = 0; i < n; i++) {
        const tr_record *c = &records[i];
        const double *p = world->disks.pos + tr_body(c->a), *q = world->disks.pos + tr_body(c->b);
        /* on b: f_n n - f_t t, t = (ny, -nx) */
        s->xx += (c->f_n * c->nx - c->f_t * c->ny) * (q[0] - p[0]);
        s->yy += (c->f_n * c->ny + c->f_t * c->nx) * (q[1] - p[1]);
    }
    for (int i = 0; i < world->disks.n; i++) {
        double vx = velocity(world, i, 0), vy = velocity(world, i, 1), w = velocity(world, i, 2);
        if (is_rim(world, i)) continue;
        s->kinetic += world->disks.mass[i] * (vx * vx + vy * vy) / 2;
        s->spinning += world->disks.inertia[i] * w * w / 2;
    }
    free(records);
    return st->code == TR_OK;
}

static bool steps(tr_world *world, int n, tr_status *st) {
    for (int k = 0; k < n; k++) {
        tr_step_advance(world);
        if (!tr_step_forces(world, st)) return false;
    }
    return true;
}

bool tr_bench_packing(const tr_scene *scene, int threads, const char *dir, tr_bench_state state[2], double *us,
                      tr_status *st) {
    tr_biaxial b;
    if (!tr_biaxial_init(&b, scene, st)) return false;
    bool ok = tr_world_set_threads(&b.world, threads, st) && tr_bench_compact(&b, st) && tr_biaxial_begin_shear(&b, st);
    if (ok) make_rim(&b);
    ok = ok && tr_world_set_laws(&b.world, &scene->contact, true, 0, st) && tr_step_forces(&b.world, st) &&
         write_data(&b.world, dir, st) && write_variables(&b, dir, st) && steps(&b.world, TR_BENCH_COMPARED, st) &&
         look(&b.world, &state[0], st);
    double start = tr_bench_clock(&b.world);
    ok = ok && steps(&b.world, TR_BENCH_TIMED, st);
    *us = 1e6 * (tr_bench_clock(&b.world) - start) / TR_BENCH_TIMED;
    ok = ok && look(&b.world, &state[1], st);
    tr_biaxial_free(&b);
    return ok;
}
