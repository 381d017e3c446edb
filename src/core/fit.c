/* SPDX-License-Identifier: MIT */
#include "core/fit.h"
#include "base/math.h"

#include "core/resolution.h"
#include <math.h>

/* |log| of the given over the fitting value: half as stiff counts like twice as stiff. Infinite if nothing fits. */
static double misfit(const tr_fit *fit) {
    return fabs(tr_log(fit->k / fit->fits));
}

/* Parameters of the laws for one contact; else the given E_star and depth. */
typedef struct contact {
    const char *key; /* of k */
    double k, E_star, depth;
} contact;

/* False: no contradiction is possible, because a value is not given, or there is no friction. */
static bool given(const tr_scene_contact *laws, double E_star, double d, contact *c) {
    const tr_law *normal = tr_laws_normal[laws->normal.law], *friction = tr_laws_friction[laws->friction.law];
    const double *of_normal = laws->normal.par, *of_friction = laws->friction.par,
                 *k_t = tr_law_value(friction, of_friction, "k_t"), *k_n = tr_law_value(normal, of_normal, "k_n"),
                 *mu = tr_law_value(friction, of_friction, "mu"), *own = tr_law_value(friction, of_friction, "E_star"),
                 *other = tr_law_value(normal, of_normal, "E_star"), *depth = tr_law_value(normal, of_normal, "depth"),
                 *k = k_t   ? k_t
                      : own ? k_n
                            : NULL;
    if (own || other) E_star = own ? *own : *other;
    if (!k || !(mu && *mu > 0) || !(E_star > 0)) return false;
    *c = (contact){k_t ? "k_t" : "k_n", *k, E_star, depth ? *depth : d};
    return true;
}

bool tr_fit_contact(const tr_scene_contact *laws, double R1, double R2, double E_star, double d, double P,
                    tr_fit *fit) {
    contact c;
    if (!given(laws, E_star, d, &c) || !(P > 0)) return false;
    *fit = (tr_fit){.key = c.key, .k = c.k, .P = P, .d = tr_law_depth(c.depth, R1, R2)};
    fit->a = tr_law_width(TR_SHAPE_DISK, P, tr_law_R_star(R1, R2), c.E_star);
    double Lambda = tr_log(2 * fit->d / fit->a);
    fit->fits = Lambda > 0 ? M_PI * c.E_star / (2 * Lambda) : 0;
    return !(fabs(fit->k / fit->fits - 1) <= TR_FIT);
}

/* The mean force of two disks that share a stress s is about s 2R when frictionless disks are compacted. In the shear
 * the mean stress is about twice the lateral one, and half again as much falls to a contact since fewer are left: 3 and
 * 1.5, each to a factor of 1.5 for mu_r of 0 to 2. */
bool tr_fit_biaxial(const tr_biaxial *b, tr_fit *fit) {
    const tr_scene_shear *shear = &b->scene->shear;
    double R = b->mean_radius, of_stress = shear->hold == TR_HOLD_MEAN ? 1.5 : 3;
    return b->world.shape == TR_SHAPE_DISK &&
           tr_fit_contact(&b->scene->contact, R, R, 0, 0, of_stress * 2 * R * shear->lateral_pressure, fit);
}

bool tr_fit_bodies(const tr_bodies *b, tr_fit *fit) {
    const tr_world *w = &b->world;
    int n = 0;
    contact c;
    if (w->shape != TR_SHAPE_DISK) return false;
    if (!w->wall_laws && !given(&b->scene->contact, 0, 0, &c)) return false; /* pairs take their time */
    for (int i = w->n_rings; i < w->disks.n; i++)
        for (int a = -w->n_walls; a < i; a++) {
            double R1 = a < 0 ? 0 : w->disks.pos[tr_body(a) + TR_RADIUS], R2 = w->disks.pos[tr_body(i) + TR_RADIUS];
            tr_fit now;
            const tr_scene_contact *laws = a < 0 ? tr_world_wall_laws(w, -1 - a) : NULL;
            if (!laws) laws = &b->scene->contact;
            if (!tr_fit_contact(laws, R1, R2, 0, 0, tr_resolution_force(b, a, i), &now)) continue;
            now.one = a, now.two = i;
            if (n++ == 0 || misfit(&now) > misfit(fit)) *fit = now;
        }
    if (n) fit->more = n - 1;
    return n > 0;
}
