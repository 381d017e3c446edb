/* SPDX-License-Identifier: MIT */
#include "core/crush.h"
#include "base/math.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

tr_crush_limit tr_crush_find(const tr_group_law *normal, tr_shape shape, double R1, double R2, double force,
                             double energy) {
    static const char *const keys[] = {"k_n", "E_star"};
    tr_group_law trial = *normal;
    double depth = TR_LARGEST_OVERLAP * tr_world_smaller(R1, R2);
    for (int k = 0; k < 2; k++) {
        double *value = tr_law_value(trial.law, trial.par, keys[k]);
        if (!value) continue;
        bool lengths = k == 0 && shape == TR_SHAPE_SPHERE;
        tr_crush_limit limit = {keys[k], lengths ? "N/m" : "Pa", *value, NAN};
        for (; *value < 1e16; *value *= 1.1) {
            tr_elastic e = trial.law->elastic(trial.par, R1, R2, depth);
            if (e.force < force || e.energy < energy) continue;
            double digit = tr_pow(10, floor(tr_log10(*value)) - 1); /* two digits, up */
            limit.holds = digit * ceil(*value / digit - 1e-9);
            return limit;
        }
    }
    return (tr_crush_limit){0};
}

static bool moves_as_given(const double *inv, const double *vel) {
    return (inv[0] == 0 && vel[0] != 0) || (inv[1] == 0 && vel[1] != 0);
}

static bool wall_moves(const tr_wall *w) {
    return w->vx != 0 || w->vy != 0;
}

/* Whether a prescribed motion may bring energy into the scene. */
static bool is_driven(const tr_world *w) {
    bool driven = false;
    for (size_t i = 0; i < (size_t)w->disks.n; i++)
        driven |= moves_as_given(w->disks.inv + tr_body(i), w->disks.vel + tr_body(i));
    for (int i = 0; i < w->n_walls; i++) driven |= wall_moves(&w->wall[i]);
    return driven;
}

/* Of all that moves freely. */
static double kinetic_energy(const tr_world *w) {
    double sum = 0;
    for (int i = 0; i < w->disks.n; i++)
        for (int k = TR_LANES * i; k < TR_LANES * i + 2; k++)
            if (w->disks.inv[k] > 0) sum += 0.5 * w->disks.mass[i] * w->disks.vel[k] * w->disks.vel[k];
    return sum;
}

void tr_crush_say(const tr_world *world, const tr_crush *crush, char *text, size_t size) {
    const tr_group_law *normal = &tr_world_group(world, crush->walls ? -1 - crush->a : crush->a)->laws[TR_NORMAL];
    const tr_disks *d = &world->disks;
    const size_t one = tr_body(crush->walls ? crush->b : crush->a), two = tr_body(crush->b);
    const double *inv1 = d->inv + one, *inv2 = d->inv + two;
    double R1 = crush->walls ? 0 : d->pos[one + 3], R2 = d->pos[two + 3];
    bool given = moves_as_given(inv2, d->vel + two) ||
                 (crush->walls ? wall_moves(&world->wall[crush->a]) : moves_as_given(inv1, d->vel + one));
    if (world->steps == 0 && crush->walls && crush->delta > R2) {
        const tr_wall *wall = &world->wall[crush->a];
        snprintf(text, size,
                 "; disk %d is behind wall %d, whose normal points to the other side: write nx: %g, ny: %g, or place "
                 "the disk in front",
                 crush->b, crush->a, 0.0 - wall->nx, 0.0 - wall->ny);
        return;
    }
    if (world->steps == 0) {
        snprintf(text, size, "; the scene starts so: place them further apart");
        return;
    }
    /* The energy in this contact, and all that may still reach it, also from other contacts. Times 1.5, for the energy
     * that the dashpot has taken. */
    double energy = normal->law->elastic(normal->par, R1, R2, crush->delta).energy + kinetic_energy(world);
    tr_crush_limit limit = tr_crush_find(normal, world->shape, R1, R2, 0, 1.5 * energy);
    if (!limit.key) return;
    if (given)
        snprintf(text, size, "; the prescribed motion presses it, or contact.%s = %.3g %s is too small", limit.key,
                 limit.is, limit.unit);
    else
        snprintf(text, size, "; contact.%s = %.3g %s is too small for the forces or the impact: %s about %.2g %s%s",
                 limit.key, limit.is, limit.unit, is_driven(world) ? "it takes at least" : "from", limit.holds,
                 limit.unit, is_driven(world) ? "" : " it would hold");
}
