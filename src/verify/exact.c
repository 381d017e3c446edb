/* SPDX-License-Identifier: MIT */
/* Group `exact`: the registry. */
#include "verify/verify.h"

static bool slip_to_roll(tr_verify *v, tr_status *st) {
    static const char text[] =
        "kind: bodies\ntime_end: 0.5 s\ngravity: {y: -9.81 m/s^2}\n"
        "contact: {k_n: 100 MPa, damping_ratio: 0.3, friction: coulomb-spring, mu: 0.3, rolling: none}\n"
        "disks: [{radius: 50 mm, density: 1200, x: 0, y: radius - density*pi*radius^2*9.81 m/s^2/contact.k_n, vx: 1}]\n"
        "walls: [{nx: 0, ny: 1}]\n"
        "checks:\n"
        "  - {what: slip-ends, contact: wall0-0, exact: disks.0.vx/(3*contact.mu*9.81 m/s^2), tolerance: 0.005*exact}\n"
        "  - {what: speed, over: 0.1 s, exact: 2/3*disks.0.vx, tolerance: 0.003*exact}\n";
    return tr_verify_scene(v, text, NULL, 0, 2, "the contact is a spring that gives way by g/w_t", st);
}

const tr_verification tr_verify_exact[] = {
    {"exact", "slip-to-roll", "a ball thrown without spin", "rigid disk, I = m R^2/2",
     "core/world.c: I = m R^2 in place of m R^2/2", slip_to_roll},
};
const int tr_n_verify_exact = sizeof tr_verify_exact / sizeof *tr_verify_exact;
