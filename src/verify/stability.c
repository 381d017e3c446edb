/* SPDX-License-Identifier: MIT */
/* Group `stability`: the registry. */
#include "verify/groups.h"

typedef bool tr_stability_this(tr_verify *v, tr_status *st);

tr_stability_this tr_stability_networks, tr_stability_sliding, tr_stability_not_conjugate, tr_stability_failures,
    tr_stability_coefficients, tr_stability_thresholds, tr_stability_sizes, tr_stability_far,
    tr_stability_six_contacts, tr_stability_pure_motions, tr_stability_unloading, tr_stability_full_slip,
    tr_stability_biaxial;

#define STATED "outcome stated before the run"

const tr_verification tr_verify_stability[] = {
    {"stability", "time-step", "1000 random networks from 0.1 to 2 times the exact limit", "[Irons1971]",
     "core/timestep.c: m in the place of a contact's share m/z; `+ r2` for `- r2` in mixed", tr_stability_networks},
    {"stability", "sliding", "networks with contacts that slide, which may flutter", "[Hoffmann2002]",
     "laws/friction_coulomb_spring.c: f_elastic for f_n in the bound", tr_stability_sliding},
    {"stability", "not-conjugate", "networks with every rolling velocity, at a tenth of the bound",
     "energy, symmetric K", "laws/rolling_wang_spring.c: m2 = -R_eff T", tr_stability_not_conjugate},
    {"stability", "no-answer", "states that must end in a failure that says where", STATED,
     "core/pipeline.c: the thin skin not bounded by the smallest radius", tr_stability_failures},
    {"stability", "coefficients", "mu 0 to 10, mu_r 0 to 100, stiffness ratios 1e-6 to 1e6", "rigid disk on a slope",
     "laws/friction_coulomb_spring.c: no upper bound", tr_stability_coefficients},
    {"stability", "thresholds", "a slope of exactly mu_r, and of exactly mu", "rigid disk on a slope",
     "laws/rolling_wang_spring.c: bound 0.9 mu_r f_n", tr_stability_thresholds},
    {"stability", "sizes", "radii 1:1000, masses 1:1e9", "energy; disk that rolls off a cylinder; elastic impact",
     "core/world.c: I = m R^2; laws/normal_linear.c: force below 0", tr_stability_sizes},
    {"stability", "far", "1e6 radii from the origin", "invariance under translation; brute force",
     "broad/box2d.cpp: half the radius", tr_stability_far},
    {"stability", "six-contacts", "sign laws on a disk that six others hold", "a moment against the spin takes energy",
     "core/contacts.c: z1 = z2 = 1", tr_stability_six_contacts},
    {"stability", "pure-motions", "rolling without sliding and the reverse, every law", "definition of the motions",
     "laws/rolling_velocity.c: s1 - s2 for s1 + s2", tr_stability_pure_motions},
    {"stability", "unloading", "the normal force falls to 0 under mobilised friction", "|Q| <= mu P",
     "laws/friction_coulomb_spring.c: no lower bound", tr_stability_unloading},
    {"stability", "full-slip", "assemblies with Q at mu P, every law of friction", STATED,
     "laws/friction_coulomb_spring.c: no lower bound", tr_stability_full_slip},
    {"stability", "hardness", "the biaxial test from k_n/pressure 10 and 500 to 1e7", STATED,
     "core/contacts.c: overlaps to 9 R allowed", tr_stability_biaxial},
};
const int tr_n_verify_stability = sizeof tr_verify_stability / sizeof *tr_verify_stability;
