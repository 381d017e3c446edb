/* SPDX-License-Identifier: MIT */
#include "verify/integrate.h"

#include "base/alloc.h"
#include "core/step.h"
#include <stdlib.h>
#include <string.h>

void tr_integrate_kick(tr_world *world, double share) {
    const tr_disks *d = &world->disks;
    for (int k = 0; k < TR_LANES * d->n; k++) d->vel[k] += share * world->dt * d->inv[k] * d->force[k];
}

static bool leapfrog(tr_world *world, int64_t n, tr_status *st) {
    for (int64_t i = 0; i < n; i++) {
        if (!tr_step_forces(world, st)) return false;
        tr_step_advance(world);
    }
    if (!tr_step_forces(world, st)) return false;
    tr_integrate_kick(world, 0.5);
    return true;
}

/* tr_step_advance kicks by a whole step: half of it is taken back before. */
static bool velocity_verlet(tr_world *world, int64_t n, tr_status *st) {
    if (!tr_step_forces(world, st)) return false;
    tr_integrate_kick(world, 0.5);
    for (int64_t i = 0; i < n; i++) {
        tr_integrate_kick(world, -0.5);
        tr_step_advance(world);
        if (!tr_step_forces(world, st)) return false;
        tr_integrate_kick(world, 0.5);
    }
    return true;
}

/* The forces of the step before are kept here: tr_step_advance leaves them at 0. */
static bool predicted(tr_world *world, int64_t n, tr_status *st) {
    const tr_disks *d = &world->disks;
    size_t lanes = tr_body(d->n), bytes = lanes * sizeof(double);
    double *half = tr_alloc(2 * lanes, sizeof *half, st);
    if (!half) return false;
    double *before = half + lanes;
    memcpy(before, d->force, bytes);
    bool ok = true;
    for (int64_t i = 0; i <= n && ok; i++) {
        memcpy(half, d->vel, bytes);
        for (size_t k = 0; k < lanes; k++) d->vel[k] += 0.5 * world->dt * d->inv[k] * before[k];
        ok = tr_step_forces(world, st);
        memcpy(d->vel, half, bytes), memcpy(before, d->force, bytes);
        if (i < n) tr_step_advance(world);
    }
    if (ok) tr_integrate_kick(world, 0.5);
    free(half);
    return ok;
}

/* Drifts and kicks in turn, as fractions of the step. */
static bool compose(tr_world *world, int64_t n, int stages, const double *drift, const double *kick, tr_status *st) {
    const tr_disks *d = &world->disks;
    if (!tr_step_forces(world, st)) return false;
    tr_integrate_kick(world, 0.5);
    for (int64_t i = 0; i < n; i++)
        for (int s = 0; s <= stages; s++) {
            for (int k = 0; k < TR_LANES * d->n; k++) d->pos[k] += drift[s] * world->dt * d->vel[k];
            if (s == stages) break;
            if (!tr_step_forces(world, st)) return false;
            tr_integrate_kick(world, kick[s]);
        }
    return true;
}

static bool conserves(const tr_world *world, tr_status *st) {
    for (int k = 0; k < 2; k++) {
        const tr_group_law *slot = world->group[k].laws;
        const double *damping = tr_law_value(slot[TR_NORMAL].law, slot[TR_NORMAL].par, "damping_ratio");
        if (slot[TR_FRICTION].law->step || slot[TR_ROLLING].law->step || (damping && *damping > 0))
            return tr_status_fail(
                st, TR_BAD_CASE,
                "error: a step that runs backwards for a part needs contacts without friction, rolling "
                "resistance and damping");
    }
    return true;
}

bool tr_integrate(tr_world *world, tr_integrator method, int64_t n, tr_status *st) {
    /* 1/(2 - cbrt(2)) */
    const double theta = 1.3512071919596578;
    const double fr_drift[] = {theta / 2, (1 - theta) / 2, (1 - theta) / 2, theta / 2};
    const double fr_kick[] = {theta, 1 - 2 * theta, theta};
    const double xi = 0.1786178958448091, lambda = -0.2123418310626054, chi = -0.06626458266981849;
    const double pe_drift[] = {xi, chi, 1 - 2 * (chi + xi), chi, xi};
    const double pe_kick[] = {0.5 - lambda, lambda, lambda, 0.5 - lambda};
    switch (method) {
    case TR_LEAPFROG:
        return leapfrog(world, n, st);
    case TR_VELOCITY_VERLET:
        return velocity_verlet(world, n, st);
    case TR_PREDICTED:
        return predicted(world, n, st);
    case TR_FOREST_RUTH:
        return conserves(world, st) && compose(world, n, 3, fr_drift, fr_kick, st);
    case TR_PEFRL:
        return conserves(world, st) && compose(world, n, 4, pe_drift, pe_kick, st);
    }
    return false;
}
