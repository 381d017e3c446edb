/* SPDX-License-Identifier: MIT */
/* Group `precision`: the registry. */
#include "verify/precision.h"

const tr_verification tr_verify_precision[] = {
    {"precision", "impact", "two disks with dashpot: coefficient of restitution",
     "closed form, physics of spring and dashpot", "TODO", tr_precision_impact},
    {"precision", "oblique", "two disks that stick: tangential rebound", "closed form", "TODO", tr_precision_oblique},
    {"precision", "thrown-disk", "a disk thrown along a floor without spin: its velocities", "closed form", "TODO",
     tr_precision_slip_to_roll},
    {"precision", "rolling-spring", "a disk that rocks on a floor on rolling and sliding springs", "closed form",
     "TODO", tr_precision_rolling_spring},
    {"precision", "impact-chain", "a sphere thrown against a chain of spheres", "Runge-Kutta, written here", "TODO",
     tr_precision_impact_chain},
    {"precision", "chain-linear", "a loaded chain of linear springs", "closed form, normal modes", "TODO",
     tr_precision_chain_linear},
    {"precision", "chain-hertz", "a loaded chain of Hertz contacts", "Runge-Kutta, written here", "TODO",
     tr_precision_chain_hertz},
    {"precision", "path", "one contact with reversals, each law", "the differential equation, Runge-Kutta", "TODO",
     tr_precision_path},
    {"precision", "half-plane-sliding", "inside a contact: pushed", "[Johnson1985 sec. 7.2]", "TODO",
     tr_precision_half_plane_sliding},
    {"precision", "half-plane-rolling", "inside a contact: rolling", "[Carter1926]", "TODO",
     tr_precision_half_plane_rolling},
    {"precision", "brush", "a brush: rolling", "closed form", "TODO", tr_precision_brush},
};
const int tr_n_verify_precision = sizeof tr_verify_precision / sizeof *tr_verify_precision;
