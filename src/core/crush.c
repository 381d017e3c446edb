/* SPDX-License-Identifier: MIT */
#include "core/crush.h"

#include "core/contacts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

tr_crush_limit tr_crush_find(const tr_slot *normal, tr_shape shape, double R1, double R2, double force, double energy) {
    static const char *const keys[] = {"k_n", "E_star"};
    tr_slot trial = *normal;
    double depth = TR_LARGEST_OVERLAP * (R1 > 0 ? fmin(R1, R2) : R2);
    for (int k = 0; k < 2; k++) {
        double *value = tr_law_value(trial.law, trial.par, keys[k]);
        if (!value) continue;
        bool lengths = k == 0 && shape == TR_SHAPE_SPHERE;
        tr_crush_limit limit = {keys[k], lengths ? "N/m" : "Pa", *value, NAN};
        for (; *value < 1e16; *value *= 1.1) {
            tr_elastic e = trial.law->elastic(trial.par, R1, R2, depth);
            if (e.force < force || e.energy < energy) continue;
            double digit = pow(10, floor(log10(*value)) - 1); /* two digits, up */
            limit.holds = digit * ceil(*value / digit - 1e-9);
            return limit;
        }
    }
    return (tr_crush_limit){0};
}

/* Nothing moves but what forces move. */
static bool is_free(const tr_world *w) {
    for (int i = 0; i < w->disks.n; i++)
        for (int k = 0; k < 2; k++)
            if (w->disks.inv[4 * (size_t)i + k] == 0 && w->disks.vel[4 * (size_t)i + k] != 0) return false;
    for (int i = 0; i < w->n_walls; i++)
        if (w->wall[i].vx != 0 || w->wall[i].vy != 0) return false;
    return true;
}

void tr_crush_say(const tr_world *world, const tr_crush *crush, char *text, size_t size) {
    const tr_slot *normal = &world->group[crush->walls].slot[TR_NORMAL];
    const tr_disks *d = &world->disks;
    const size_t one = 4 * (size_t)(crush->walls ? crush->b : crush->a), two = 4 * (size_t)crush->b;
    double R1 = crush->walls ? 0 : d->pos[one + 3], R2 = d->pos[two + 3];
    double inv = (crush->walls ? 0 : d->inv[one]) + d->inv[two]; /* 1/m_eff; 0: neither gives way */
    double vx = d->vel[two] - (crush->walls ? 0 : d->vel[one]);
    double vy = d->vel[two + 1] - (crush->walls ? 0 : d->vel[one + 1]);
    if (world->steps == 0) {
        snprintf(text, size, "; it is so at the start: place them further apart");
        return;
    }
    /* What the contact has taken up, and what still comes: a stiffer one gets no more than that from what presses it. Half
     * as much again for what the dashpot has taken. */
    double energy = normal->law->elastic(normal->par, R1, R2, crush->delta).energy;
    if (inv > 0) energy += 0.5 * (vx * vx + vy * vy) / inv;
    tr_crush_limit limit = tr_crush_find(normal, world->shape, R1, R2, 0, 1.5 * energy);
    if (!is_free(world) || !(inv > 0))
        snprintf(text, size, "; the given motion presses it, or contact.%s = %.3g is too small", limit.key, limit.is);
    else if (limit.key)
        snprintf(text, size,
                 "; contact.%s = %.3g %s is too small for the forces or the impact: from about %.2g %s it would hold",
                 limit.key, limit.is, limit.unit, limit.holds, limit.unit);
}
