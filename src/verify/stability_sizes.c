/* SPDX-License-Identifier: MIT */
/* Tiny and huge disks, 1:1000, and light and heavy disks, 1:1e9.
 *
 * Codes that mix velocities of the half step with normals of the full step have trapped and kicked small grains between
 * large ones. Here a tiny disk rolls off a huge one. It leaves where its weight no longer bends its path,
 *
 *   m v^2/(R + r) = m g cos(theta),   3/4 m v^2 = m g (R + r)(cos(theta0) - cos(theta))   =>   cos(theta) = (4/7)
 *                                     cos(theta0)
 *
 * and falls into the saddle between two: without dashpots its energy may fall, where a contact opens with its spring of
 * friction stretched, and must not grow; with dashpots it must come to rest. */
#include "base/alloc.h"
#include "core/step.h"
#include "verify/stability.h"
#include <stdlib.h>

static const char top[] = "kind: bodies\ntime_end: 3 s\ngravity: {y: -10}\nstep: {safety: 0.2}\n"
                          "contact: {k_n: 1 MPa, damping_ratio: 0.3, mu: 100, rolling: none}\n"
                          "disks: [{radius: 1, x: 0, y: 0, motion: prescribed}, {radius: 1e-3, density: 1000,\n"
                          "  x: 1.001 m*sin(10 deg), y: 1.001 m*cos(10 deg)}]\n";
static const char saddle[] =
    "kind: bodies\ntime_end: 2 s\ngravity: {y: -10}\nstep: {safety: 0.1}\n"
    "contact: {k_n: 1 MPa, damping_ratio: 0, mu: 100, rolling: none}\n"
    "disks: [{radius: 1, x: -1, y: 0, motion: prescribed}, {radius: 1, x: 1, y: 0, motion: prescribed},\n"
    "  {radius: 1e-3, density: 1000, x: 2 mm, y: 0.1}]\n";
static const char blow[] =
    "kind: bodies\ntime_end: 0.2 s\nstep: {safety: 0.05}\n"
    "contact: {k_n: 100 MPa, damping_ratio: 0, friction: none, rolling: none}\n"
    "disks: [{radius: 1, density: 1e6, x: 0, y: 0, vx: 1}, {radius: 1e-3, density: 1e3, x: 1.002, y: 0}]\n"
    "checks: [{what: speed, disk: 1, exact: 2*disks.0.vx/(1 + 1e-9), tolerance: 1e-3*exact}]\n";

static bool rolls_off(tr_verify *v, tr_stability_run *run, tr_status *st) {
    bool ok = tr_stability_open(run, top, NULL, 0, st);
    double left = NAN;
    while (ok && run->b.world.steps < run->b.steps && (ok = tr_stability_step(run, st))) {
        const double *p = run->b.world.disks.pos + 4;
        if (run->b.world.tile->touching) left = p[1] / hypot(p[0], p[1]);
    }
    tr_stability_close(run);
    return ok && tr_verify_add(v,
                               &(tr_verify_row){"cos(theta) where a disk rolls off one of 1000 R", "1",
                                                4 / 7.0 * cos(10 * M_PI / 180), left, 2e-3,
                                                "the weight is taken up by springs, r/R", NAN, NULL},
                               st);
}

/* The largest gain and the last loss of energy, in units of m g times the way to the ground. */
static bool falls(tr_verify *v, tr_stability_run *run, double zeta, double *gain, double *moving, tr_status *st) {
    const char *sets[] = {zeta > 0 ? "contact.damping_ratio=0.3" : "contact.damping_ratio=0"};
    bool ok = tr_stability_open(run, saddle, sets, 1, st);
    double unit = ok ? run->b.world.disks.mass[2] * 10 * 0.05 : 1, start = NAN;
    *gain = 0;
    while (ok && run->b.world.steps < run->b.steps && (ok = tr_step_forces(&run->b.world, st))) {
        if (run->b.world.steps % 20 == 0) {
            double energy = tr_stability_energy(&run->b.world) / unit;
            if (isnan(start)) start = energy;
            *gain = fmax(*gain, energy - start);
        }
        tr_bodies_advance(&run->b);
    }
    if (ok) {
        double velocity[3];
        tr_bodies_velocity(&run->b.world, 2, velocity);
        *moving = hypot(hypot(velocity[0], velocity[1]), 1e-3 * velocity[2]);
    }
    tr_stability_close(run);
    return ok && tr_verify_go_on(v, st);
}

bool tr_stability_sizes(tr_verify *v, tr_status *st) {
    tr_stability_run *run = tr_alloc(1, sizeof *run, st);
    double gain = NAN, moving = NAN;
    bool ok = run && rolls_off(v, run, st) && falls(v, run, 0, &gain, &moving, st) &&
              tr_verify_add(v,
                            &(tr_verify_row){"gain of energy between disks of 1000 R", "1", 0, gain, 1e-3,
                                             "(w dt)^3 = 1e-3 at each impact", NAN, NULL},
                            st) &&
              falls(v, run, 0.3, &gain, &moving, st) &&
              tr_verify_add(v,
                            &(tr_verify_row){"speed left there, with dashpots", "m/s", 0, moving, 1e-6,
                                             "1 m/s at the first impact, e-folds of the dashpots", NAN, NULL},
                            st) &&
              tr_verify_scene(v, blow, NULL, 0, 1, "(w dt)^2/24 of an impact", st);
    free(run);
    return ok;
}
