/* SPDX-License-Identifier: MIT */
#include "draw/stick.h"

#include "laws/law.h"
#include <math.h>

void tr_frame_stick(const tr_world *world, const tr_record *r, double stick[2]) {
    const tr_group_law *slot = &tr_world_group(world, r->a)->laws[TR_FRICTION];
    const tr_law *law = slot->law;
    stick[0] = stick[1] = 0;
    const double *mu = law ? tr_law_value(law, slot->par, "mu") : NULL;
    if (!law || !law->step || (mu && *mu == 0)) return;
    double left = 1 - fmin(fmax(r->mobilisation, 0), 1); /* NaN: 1 */
    double c = world->shape == TR_SHAPE_SPHERE ? cbrt(left) : sqrt(left);
    if (law->slip == TR_SLIPS_WHOLE) c = left > 1e-9; /* the law caps Q to rounding */
    const int *roll = tr_law_choice(law, slot->par, "creep_roll");
    double weight = roll && *roll ? (r->R1 != 0 ? r->R1 / (r->R1 + r->R2) : 1) : 0.5;
    double v_roll = law->slip == TR_SLIPS_TRAILING ? -((1 - weight) * r->s1 + weight * r->s2) : 0;
    stick[0] = v_roll > 0 ? -1 : v_roll < 0 ? 1 - 2 * c : -c; /* material leaves at +1 while v_roll > 0 */
    stick[1] = v_roll > 0 ? 2 * c - 1 : v_roll < 0 ? 1 : c;
}
