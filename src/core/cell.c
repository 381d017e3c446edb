/* SPDX-License-Identifier: MIT */
#include "core/cell.h"

#include "base/vector.h"

double tr_cell_least_side(const tr_world *world) {
    return 2 * (2 * world->r_max + world->wide_skin);
}

bool tr_cell_check(const tr_world *world, tr_status *st) {
    const double *side = world->cell.side;
    double least = tr_cell_least_side(world);
    for (int k = 0; k < 2 && side[k] > 0; k++)
        if (!(side[k] > least))
            return tr_status_fail(
                st, TR_NUMERICAL,
                "error: the periodic cell is too thin: its %s is %.3g m, and must be above %.3g m, twice "
                "the largest disk and the skin of the contact list, at step %lld, time %.9g s",
                k ? "height" : "width", side[k], least, (long long)world->steps, (double)world->steps * world->dt);
    return true;
}

void tr_cell_wrap(tr_world *world) {
    const tr_periodic_cell *c = &world->cell;
    const tr_disks *d = &world->disks;
    for (int axis = 0; axis < 2 && c->side[axis] > 0; axis++)
        for (int i = 0; i < d->n; i++) {
            double *x = d->pos + tr_body(i) + axis, n = tr_broad_image(0, *x, c->side[axis]);
            if (n == 0) continue;
            *x += n * c->side[axis];
            d->vel[tr_body(i) + (size_t)axis] += n * c->rate[axis];
            world->wide_ref[2 * (size_t)i + (size_t)axis] += n * world->wide_extent.side[axis];
        }
}

void tr_cell_set_rate(tr_world *world, int axis, double rate) {
    tr_periodic_cell *c = &world->cell;
    double part = (rate - c->rate[axis]) / c->side[axis];
    c->rate[axis] = rate;
    if (part != 0)
        for (int k = axis; k < 4 * world->disks.n; k += 4) world->disks.vel[k] += part * world->disks.pos[k];
}

void tr_cell_advance(tr_world *world) {
    tr_periodic_cell *c = &world->cell;
    for (int k = 0; k < 2; k++) {
        if (c->mass[k] > 0) {
            double rate = c->rate[k] + world->dt * (tr_cell_force(c, k) - c->load[k]) / c->mass[k];
            tr_cell_set_rate(world, k, fmin(fmax(rate, -c->v_max[k]), c->v_max[k]));
        } else if (c->gain[k] != 0) {
            tr_cell_set_rate(world, k, c->rate[k] + world->dt * c->gain[k]);
        }
    }
    for (int k = 0; k < 2; k++) c->side[k] += world->dt * c->rate[k];
}

TR_VECTOR void tr_cell_shift(const tr_periodic_cell *cell, const tr_group *g, tr_tile *restrict tile) {
    const double *restrict nx = g->pair[TR_PAIR_IMAGE_X] + tile->first, *restrict ny =
                                                                            g->pair[TR_PAIR_IMAGE_Y] + tile->first;
    double Lx = cell->side[0], Ly = cell->side[1], rate_x = cell->rate[0], rate_y = cell->rate[1];
    for (int i = 0; i < tile->n; i++) {
        tile->dx[i] += nx[i] * Lx, tile->dy[i] += ny[i] * Ly;
        tile->dvx[i] += nx[i] * rate_x, tile->dvy[i] += ny[i] * rate_y;
    }
}

void tr_cell_add_virial(tr_periodic_cell *cell, const tr_tile *tile) {
    double x = 0, y = 0;
    for (int i = 0; i < tile->n; i++) x += tile->fx[i] * tile->dx[i], y += tile->fy[i] * tile->dy[i];
    cell->virial[0] += x, cell->virial[1] += y;
}

double tr_cell_kinetic_work(const tr_world *world, int axis) {
    const tr_periodic_cell *c = &world->cell;
    const tr_disks *d = &world->disks;
    double flow = tr_cell_strain_rate(c, axis), before = c->side[axis] - world->dt * c->rate[axis], sum = 0;
    for (int i = 0; i < d->n; i++) {
        size_t k = tr_body(i) + (size_t)axis;
        double v = d->vel[k] - flow * d->pos[k];
        sum += d->mass[i] * v * v;
    }
    return 0.5 * sum * (c->side[axis] * c->side[axis] / (before * before) - 1);
}
