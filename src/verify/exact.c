/* SPDX-License-Identifier: MIT */
/* Group `exact`: the registry. To add a verification, write its function in a file, name it and give it a row here. */
#include "verify/groups.h"

typedef bool tr_verify_this(tr_verify *v, tr_status *st);

tr_verify_this tr_exact_slip_to_roll, tr_exact_incline, tr_exact_no_spin, tr_exact_coasting; /* exact_rolling.c */
tr_verify_this tr_exact_impact, tr_exact_peak, tr_exact_sticking, tr_exact_sliding, tr_exact_spin, tr_exact_damped,
    tr_exact_grazing; /* exact_impact.c */
tr_verify_this tr_exact_step_bound;
tr_verify_this tr_exact_dahlberg, tr_exact_cattaneo, tr_exact_kuhn_creep, tr_exact_vu_quoc; /* exact_paths.c */
tr_verify_this tr_exact_contact_size, tr_exact_fig_5;                                       /* exact_kuhn.c */
tr_verify_this tr_exact_patch_cattaneo, tr_exact_patch_carter, tr_exact_patch_kalker,
    tr_exact_patch_brush;                                                          /* exact_patch.c */
tr_verify_this tr_exact_claims, tr_exact_cycle;                                    /* exact_claims.c */
tr_verify_this tr_exact_observers, tr_exact_errata;                                /* exact_motions.c */
tr_verify_this tr_exact_collision, tr_exact_packing;                               /* exact_balance.c */
tr_verify_this tr_exact_cell, tr_exact_drag, tr_exact_hold;                        /* exact_cell.c */
tr_verify_this tr_exact_patch_loads, tr_exact_patch_reversed, tr_exact_patch_slip; /* exact_loads.c */
tr_verify_this tr_exact_bed_energy, tr_exact_creep_books;                          /* exact_bed.c */
tr_verify_this tr_exact_sign_laws, tr_exact_conjugate, tr_exact_rolling_store, tr_exact_rolling_share,
    tr_exact_turning_gravity; /* exact_turns.c */

#define RIGID "rigid disk, I = m R^2/2"

const tr_verification tr_verify_exact[] = {
    {"exact", "slip-to-roll", "a ball thrown without spin", RIGID, "core/world.c: 1/I = 1/(m R^2)",
     tr_exact_slip_to_roll},
    {"exact", "incline-none", "a disk on a slope without rolling resistance", RIGID,
     "friction_coulomb_spring.c: the bound 5 % above mu f_n", tr_exact_incline},
    {"exact", "incline-wang-spring", "a disk on a slope: where it rolls and slips, how fast", RIGID,
     "rolling_wang_spring.c: lever R_eff/2 on body 2", tr_exact_incline},
    {"exact", "incline-conjugate-spring", "a disk on a slope: half of the resistance is a force", RIGID,
     "rolling_conjugate_spring.c: no force f_r", tr_exact_incline},
    {"exact", "incline-star-force-proportional", "a disk on a slope: where it rolls and slips, how fast", RIGID,
     "rolling_star_force_proportional.c: lever 2 r2", tr_exact_incline},
    {"exact", "incline-star-constant-torque", "a disk on a slope: lever 2 R", RIGID,
     "rolling_star_constant_torque.c: the readings of R_eq exchanged", tr_exact_incline},
    {"exact", "incline-star-displacement-damping", "a disk on a slope: lever 2 R", RIGID,
     "rolling_star_displacement_damping.c: the readings of R_eq exchanged", tr_exact_incline},
    {"exact", "incline-no-spin", "mu_r > mu: slides without spinning", RIGID,
     "rolling_wang_spring.c: lever R_eff/4 on body 2", tr_exact_no_spin},
    {"exact", "coasting-wang-spring", "rolls to rest; the rolling spring takes x_c to load", RIGID,
     "rolling_wang_spring.c: k_r doubled", tr_exact_coasting},
    {"exact", "coasting-star-force-proportional", "rolls to rest", RIGID,
     "rolling_star_force_proportional.c: the bound 1 % larger", tr_exact_coasting},
    {"exact", "coasting-star-constant-torque", "rolls to rest, lever 2 R", RIGID,
     "rolling_star_constant_torque.c: sign of the moment on 2", tr_exact_coasting},
    {"exact", "coasting-star-displacement-damping", "rolls to rest, lever 2 R", RIGID,
     "rolling_star_displacement_damping.c: theta_max halved", tr_exact_coasting},
    {"exact", "impact-normal", "spring and dashpot; a contact ends when its force is 0",
     "delta'' = -2 z w delta' - w^2 delta", "normal_linear.c: the dashpot may pull (ends at overlap 0)",
     tr_exact_impact},
    {"exact", "impact-peak", "greatest force of elastic impacts", "energy; Hertz [Johnson1985 sec. 11.4]",
     "normal_hertz_line.c: P(delta) by the expansion, without Halley steps", tr_exact_peak},
    {"exact", "impact-sticking", "oblique, the contact never slips, undamped", "cos(pi sqrt(3 k_t/k_n))",
     "kinematics.c: no torque of friction on body 2", tr_exact_sticking},
    {"exact", "impact-sliding", "oblique, the contact never sticks", "impulse mu (1 + e) m_eff v_n",
     "friction_coulomb_spring.c: bound by the elastic force, without the dashpot", tr_exact_sliding},
    {"exact", "impact-spin", "a spinning disk falls on a wall, never sticks", "impulse mu (1 + e) m_eff v_n",
     "kinematics.c: sign of the spin in V_s at a wall", tr_exact_spin},
    {"exact", "impact-dissipation", "what the dashpot takes, by the ledger", "1 - e^2",
     "ledger.c: the dashpot of now alone, halved", tr_exact_damped},
    {"exact", "impact-grazing", "no impact may gain energy: angles from steep to grazing", "energy",
     "friction_coulomb_spring.c: sign of V_s dt", tr_exact_grazing},
    {"exact", "step-bound", "the bound on the step of chains and lattices", "largest eigenvalue of M^-1 K [Irons1971]",
     "timestep.c: the mass of a contact doubled", tr_exact_step_bound},
    {"exact", "dahlberg-alfredsson", "a line contact that creeps: from rest, turned back, relaxing",
     "closed form of its equation; Carter [Kuhn2014 eq. 11]", "dahlberg_exact.c: sliding against Q goes on through 0",
     tr_exact_dahlberg},
    {"exact", "cattaneo-mindlin", "a loop of sliding at constant force",
     "Cattaneo, Mindlin, Masing [Johnson1985 sec. 7.2]", "bed.c: caps of the sliders without kappa", tr_exact_cattaneo},
    {"exact", "kuhn-creep", "spheres that creep, from rest", "closed form of its equation [Kuhn2014 eq. 16]",
     "friction_kuhn_creep.c: backward Euler (first order)", tr_exact_kuhn_creep},
    {"exact", "vu-quoc-zhang", "spheres whose sliding fades as they roll",
     "closed form of its equation [Kuhn2014 sec. 2.3]", "friction_vu_quoc_zhang.c: 1/2 for 2/pi", tr_exact_vu_quoc},
    {"exact", "kuhn-contact-size", "how small contacts of quartz are", "[Kuhn2014 Table 2, sec. 2.3]",
     "law.h: R for R_star in the radius of the circle", tr_exact_contact_size},
    {"exact", "kuhn-fig-5", "steady rolling of spheres, a = R/100", "[Kuhn2014 Fig. 5, sec. 3.1]",
     "friction_kuhn_creep.c: the factor 8 of the printed eq. 10 with R_star", tr_exact_fig_5},
    {"exact", "patch-cattaneo", "half-plane: pushed from rest", "[Johnson1985 sec. 7.2]",
     "half_plane.c: 2d for d in the kernel", tr_exact_patch_cattaneo},
    {"exact", "patch-carter", "half-plane: steady rolling", "[Carter1926]", "half_plane.c: u_{n-1} read at x + dr",
     tr_exact_patch_carter},
    {"exact", "patch-kalker", "half-plane: from Cattaneo to Carter at constant force", "[Kalker1971]",
     "half_plane.c: material carried by 0.8 dr", tr_exact_patch_kalker},
    {"exact", "patch-brush", "brush: rolling from rest", "tau = min(mu p, k_w xi min(L, x + a))",
     "brush.c: k_w doubled", tr_exact_patch_brush},
    {"exact", "claims", "what each law of the registry claims, and what it does not", "invariance",
     "kinematics.c: full radii for arms", tr_exact_claims},
    {"exact", "conjugate-cycle", "work of a closed cycle over k_r R_eff (R2 - R1)/(2|X21|) du dth1",
     "power conjugacy, linear spring", "rolling_velocity.c: R1 and R2 exchanged in wang", tr_exact_cycle},
    {"exact", "observers", "64 motions of pairs, seen by one who moves and one who turns", "invariance",
     "kinematics.c: s1 without the spin of the branch", tr_exact_observers},
    {"exact", "errata", "printed formulas beside the right ones", "rigid motions; signs; README",
     "rolling_star_force_proportional.c: sign of the moment on 1", tr_exact_errata},
    {"exact", "collision", "49 disks fly together", "conservation",
     "kinematics.c: full radius for the arm of the torque", tr_exact_collision},
    {"exact", "packing", "60 disks sheared between walls: the ledger of energy", "conservation",
     "ledger.c: half of the work of the walls", tr_exact_packing},
    {"exact", "periodic-cell", "a gas and a lattice in a cell that changes", "straight flight, virial [Love1927]",
     "cell.c: sign of the rate in the velocity of what leaves the cell", tr_exact_cell},
    {"exact", "compaction-drag", "the drag of compaction acts against the flow of the cell", "x/L, (1 - drag dt) L/L'",
     "biaxial.c: vel + flow pos", tr_exact_drag},
    {"exact", "servo", "what a periodic cell holds in the shear", "what the case asks",
     "biaxial.c: sign of the excess of the mean stress", tr_exact_hold},
    {"exact", "patch-loads", "half-plane: the normal force changes with and after the push", "[Mindlin1953]",
     "half_plane.c: the grid of before taken for that of now", tr_exact_patch_loads},
    {"exact", "patch-reversed", "half-plane and closed form: rolling along -x", "[Carter1926], mirrored",
     "carter.c: X where roll < 0 not turned", tr_exact_patch_reversed},
    {"exact", "patch-slip", "how far the edge slips, pushed", "slope of a surface beside Hertz's contact",
     "cattaneo.c: sign of the logarithm", tr_exact_patch_slip},
    {"exact", "bed-energy", "what cattaneo-mindlin stores: pushed, turned back", "Hertz's pressures, superposed",
     "bed.c: sign of P e in the energy", tr_exact_bed_energy},
    {"exact", "creep-books", "what laws say that creep takes off the sliding",
     "k_t (u_slide - u_creep) = Q; steady rolling", "friction_dahlberg_alfredsson.c: 1 + sqrt(1 - q) in crept",
     tr_exact_creep_books},
    {"exact", "sign-laws", "spins that a step stops, with friction's torque", "I w' = I w + (M - r Q) dt",
     "rolling_star_constant_torque.c: sign of friction's torque", tr_exact_sign_laws},
    {"exact", "conjugate-pair", "conjugate-spring of bagi-kuhn on disks of unequal radii", "power; eigenvalue of two springs",
     "rolling_conjugate_spring.c: sign of `along` or of the rest in a lever", tr_exact_conjugate},
    {"exact", "rolling-store", "work that loads a rolling spring", "work of the moments",
     "rolling_star_displacement_damping.c: the energy doubled", tr_exact_rolling_store},
    {"exact", "rolling-share", "measures of two pairs: share of rolling, coordination", "rigid motion",
     "measures.c: sliding left out", tr_exact_rolling_share},
    {"exact", "turning-gravity", "a disk that falls while gravity turns", "integral of gravity",
     "bodies_state.c: turned the other way", tr_exact_turning_gravity},
};
const int tr_n_verify_exact = sizeof tr_verify_exact / sizeof *tr_verify_exact;
