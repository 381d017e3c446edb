/* SPDX-License-Identifier: MIT */
/* Group `precision`: the registry. */
#include "verify/groups.h"

typedef bool tr_precision_run(tr_verify *v, tr_status *st);
tr_precision_run tr_precision_impact, tr_precision_oblique, tr_precision_thrown_disk, tr_precision_rolling_spring;
tr_precision_run tr_precision_impact_chain, tr_precision_chain_linear, tr_precision_chain_hertz;
tr_precision_run tr_precision_path;
tr_precision_run tr_precision_half_plane_sliding, tr_precision_half_plane_rolling, tr_precision_brush;
tr_precision_run tr_precision_biaxial;

const tr_verification tr_verify_precision[] = {
    {"precision", "impact", "two disks with dashpots: coefficient of restitution",
     "closed form, e = exp(-2 tan q (pi/2 - q)), sin q = zeta", "normal_linear.c: half the dashpot",
     tr_precision_impact},
    {"precision", "oblique", "two disks that stick: tangential rebound", "closed form, cos(pi sqrt(3 k_t/k_n))",
     "friction_coulomb_spring.c: k_t 2 % larger; world.c: I = m R^2", tr_precision_oblique},
    {"precision", "thrown-disk", "a disk thrown along a floor without spin: velocities", "closed form with springs",
     "friction_coulomb_spring.c: k_t 2 % larger; world.c: I = m R^2", tr_precision_thrown_disk},
    {"precision", "rolling-spring", "a disk that rocks on a floor on springs", "closed form, two modes",
     "rolling_wang_spring.c: one moment 2 % smaller; integrate.c: the forces before, read after the step",
     tr_precision_rolling_spring},
    {"precision", "impact-chain", "a sphere thrown against a chain of spheres", "Runge-Kutta, written here",
     "normal_hertz_sphere.c: R2 for R_star", tr_precision_impact_chain},
    {"precision", "chain-linear", "a loaded chain of springs", "closed form, normal modes",
     "bodies.c: no half step back; step.c: a drift that lacks 0.001 of the kick; integrate.c: friction not refused",
     tr_precision_chain_linear},
    {"precision", "chain-hertz", "a loaded chain of Hertz contacts", "Runge-Kutta, written here",
     "normal_hertz_sphere.c: R2 for R_star; integrate.c: lambda -0.2124", tr_precision_chain_hertz},
    {"precision", "path", "one contact with reversals, each friction law", "Runge-Kutta and sliders, written here",
     "friction_dahlberg_alfredsson.c: R2 for R_star, sign of the old Q; friction_kuhn_creep.c: 3 % less creep",
     tr_precision_path},
    {"precision", "half-plane-sliding", "inside a contact: pushed", "[Johnson1985 sec. 7.2]",
     "half_plane.c: d 1 % smaller in the kernel", tr_precision_half_plane_sliding},
    {"precision", "half-plane-rolling", "inside a contact: rolling", "[Carter1926]",
     "half_plane.c: the first element left out of the sum in carry", tr_precision_half_plane_rolling},
    {"precision", "brush", "a brush: rolling", "closed form, tau = min(mu p, k_w xi (x + a))",
     "brush.c: k_w 0.25 % smaller", tr_precision_brush},
    {"precision", "biaxial", "residual strength of small samples",
     "trial by another program; no dependence on I, kappa, dt",
     "friction_coulomb_spring.c: a twentieth of the bound (of the differences between variants no change was tried)",
     tr_precision_biaxial},
};
const int tr_n_verify_precision = sizeof tr_verify_precision / sizeof *tr_verify_precision;
