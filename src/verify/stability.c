/* SPDX-License-Identifier: MIT */
/* Group `stability`: the registry. */
#include "verify/stability.h"

const tr_verification tr_verify_stability[] = {
    {"stability", "time-step", "1000 random networks from 0.1 to 2 times the exact limit", "[Irons1971]",
     "core/timestep.c: share z/m of a body replaced by 1/m", tr_stability_networks},
    {"stability", "not-conjugate", "networks of a rolling law with every rolling velocity",
     "Jury's criterion for symmetric K", "", tr_stability_not_conjugate},
    {"stability", "no-answer", "states that must end in a failure that says where", "outcome stated before the run",
     "core/world.c: thin skin not bounded by the smallest radius", tr_stability_failures},
    {"stability", "coefficients", "mu 0 to 10, mu_r 0 to 100, stiffness ratios 1e-6 to 1e6", "rigid disk on a slope",
     "core/timestep.c: rolling and sliding not coupled, w2 = max(slide, roll)", tr_stability_coefficients},
    {"stability", "thresholds", "a slope of exactly mu_r, and of exactly mu", "rigid disk on a slope",
     "laws: one side of the clamp, trial < -bound, left out", tr_stability_thresholds},
    {"stability", "sizes", "radii 1:1000, masses 1:1e9", "energy; disk that rolls off a cylinder; elastic impact",
     "laws/kinematics.c: V_s with t of the step before, or arm r2 = R1", tr_stability_sizes},
    {"stability", "far", "1e6 radii from the origin", "invariance under translation; brute force",
     "broad/box2d.cpp: down() and up() round to nearest", tr_stability_far},
    {"stability", "six-contacts", "sign laws on a disk that six others hold", "a moment against the spin takes energy",
     "core/contacts.c: a body's share in one contact is 1", tr_stability_six_contacts},
    {"stability", "pure-motions", "rolling without sliding and the reverse, every law", "definition of the motions", "",
     tr_stability_pure_motions},
    {"stability", "unloading", "the normal force falls to 0 under mobilised friction", "|Q| <= mu P", "",
     tr_stability_unloading},
    {"stability", "full-slip", "assemblies with Q at mu P, every law of friction", "outcome stated before the run", "",
     tr_stability_full_slip},
    {"stability", "hardness", "the biaxial test from k_n/pressure 10 to 1e7", "outcome stated before the run", "",
     tr_stability_biaxial},
};
const int tr_n_verify_stability = sizeof tr_verify_stability / sizeof *tr_verify_stability;
