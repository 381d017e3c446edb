/* SPDX-License-Identifier: MIT */
/* Arrays of bodies have four doubles for each body, so that one vector load takes them all: place x, y, angle and
 * radius; velocity vx, vy, spin; force fx, fy, torque. tr_body(i) is where those of body i begin. */
#ifndef TR_LANES_H
#define TR_LANES_H

#include <stddef.h>

enum { TR_X, TR_Y, TR_TURN, TR_RADIUS, TR_LANES }; /* TR_TURN: angle, spin or torque */

static inline size_t tr_body(int i) {
    return (size_t)TR_LANES * (size_t)i;
}

#endif
