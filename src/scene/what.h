/* SPDX-License-Identifier: MIT */
/* What a check can measure: one row each. The reader, the writer, the list of keys and the drivers of study/ read
 * these rows.
 *
 * Of bodies a new one is a row of TR_WHATS and its function in study/checks.c. Along a path the columns of
 * contact.csv are measured: a new one is a row of TR_COLUMNS and its field in study/contact.h. */
#ifndef TR_SCENE_WHAT_H
#define TR_SCENE_WHAT_H

#include "base/param.h"

/* Which key names its object: `contact` or `disk`. TR_OF_FLOOR: `disk`, and the check looks at its contact with wall
 * 0. */
typedef enum tr_whose { TR_OF_CONTACT, TR_OF_DISK, TR_OF_FLOOR } tr_whose;

typedef enum tr_when {
    TR_AT_TIME, /* `at`, or the mean over the time `over` before it */
    TR_SINCE,   /* the same, but `over: 0` is the whole time up to `at` */
    TR_EVENT,   /* it happens once, or never */
    TR_SLOPE    /* the least slope on which the function gives a distance; found in runs of its own */
} tr_when;

/* Choice, name, dimension TR_DIM_, unit "disk|sphere", whose, when, function in study/checks.c. The order is that of
 * the choices of `what:`. */
#define TR_WHATS(ROW)                                                                                                  \
    ROW(TR_SLIDING_VELOCITY, "sliding-velocity", SPEED, "m/s", TR_OF_CONTACT, TR_AT_TIME, sliding_velocity)            \
    ROW(TR_ROLLING_VELOCITY, "rolling-velocity", SPEED, "m/s", TR_OF_CONTACT, TR_AT_TIME, rolling_velocity)            \
    ROW(TR_CREEPAGE, "creepage", NUMBER, "1", TR_OF_CONTACT, TR_AT_TIME, creepage)                                     \
    ROW(TR_POWER_LOST, "power-lost", POWER, "N/s|J/s", TR_OF_CONTACT, TR_AT_TIME, power_lost)                          \
    ROW(TR_SLIP_ENDS, "slip-ends", TIME, "s", TR_OF_CONTACT, TR_EVENT, slip_ends)                                      \
    ROW(TR_SLIP_STARTS, "slip-starts", TIME, "s", TR_OF_CONTACT, TR_EVENT, slip_starts)                                \
    ROW(TR_SPEED, "speed", SPEED, "m/s", TR_OF_DISK, TR_AT_TIME, speed)                                                \
    ROW(TR_ACCELERATION, "acceleration", ACCELERATION, "m/s^2", TR_OF_DISK, TR_SINCE, acceleration)                    \
    ROW(TR_STOP_TIME, "stop-time", TIME, "s", TR_OF_DISK, TR_EVENT, stop_time)                                         \
    ROW(TR_STOP_DISTANCE, "stop-distance", LENGTH, "m", TR_OF_DISK, TR_EVENT, stop_distance)                           \
    ROW(TR_PLACE_X, "x", LENGTH, "m", TR_OF_DISK, TR_AT_TIME, place_x)                                                 \
    ROW(TR_PLACE_Y, "y", LENGTH, "m", TR_OF_DISK, TR_AT_TIME, place_y)                                                 \
    ROW(TR_SPIN, "spin", SPIN, "rad/s", TR_OF_DISK, TR_AT_TIME, spin)                                                  \
    ROW(TR_TORQUE, "torque", MOMENT, "N|N*m", TR_OF_DISK, TR_AT_TIME, torque)                                          \
    ROW(TR_POWER, "power", POWER, "N/s|J/s", TR_OF_DISK, TR_AT_TIME, power)                                            \
    ROW(TR_ENERGY_LOST, "energy-lost", NUMBER, "1", TR_OF_DISK, TR_AT_TIME, energy_lost)                               \
    ROW(TR_ROLLS_FROM, "rolls-from", NUMBER, "rad", TR_OF_DISK, TR_SLOPE, rolls_from)                                  \
    ROW(TR_SLIPS_FROM, "slips-from", NUMBER, "rad", TR_OF_FLOOR, TR_SLOPE, slips_from)

#define TR_WHAT_CHOICE(choice, ...) choice,
typedef enum tr_what { TR_WHATS(TR_WHAT_CHOICE) TR_N_WHATS } tr_what;

typedef struct tr_what_row {
    const char *name, *unit; /* unit: for tr_param_by_shape */
    tr_whose whose;
    tr_when when;
} tr_what_row;

extern const tr_what_row tr_whats[TR_N_WHATS];

/* The quantities of contact.csv: name, which is that of the field in tr_contact_state; dimension TR_DIM_; unit
 * "disk|sphere". With the unit behind its name each is a column: `P` is P_N_per_m or P_N. The second list is of
 * `kind: patch` alone. */
#define TR_COLUMNS(ROW)                                                                                                \
    ROW(u_slide, LENGTH, "m")                                                                                          \
    ROW(u_roll, LENGTH, "m")                                                                                           \
    ROW(P, FORCE, "N/m|N")                                                                                             \
    ROW(Q, FORCE, "N/m|N")                                                                                             \
    ROW(q, NUMBER, "1")                                                                                                \
    ROW(a, LENGTH, "m")                                                                                                \
    ROW(moment_1, MOMENT, "N|N*m")                                                                                     \
    ROW(moment_2, MOMENT, "N|N*m")                                                                                     \
    ROW(f_r, FORCE, "N/m|N")                                                                                           \
    ROW(overlap, LENGTH, "m")
#define TR_PATCH_COLUMNS(ROW)                                                                                          \
    ROW(p_max, MODULUS, "Pa")                                                                                          \
    ROW(stick, LENGTH, "m")                                                                                            \
    ROW(creepage, NUMBER, "1")                                                                                         \
    ROW(dissipated, MOMENT, "J/m|J")

#define TR_COLUMN_CHOICE(name, ...) TR_COLUMN_##name,
typedef enum tr_column {
    TR_COLUMNS(TR_COLUMN_CHOICE) TR_N_COLUMNS,
    TR_COLUMN_BEFORE_PATCH = TR_N_COLUMNS - 1, /* the next goes on from here */
    TR_PATCH_COLUMNS(TR_COLUMN_CHOICE) TR_N_PATCH_COLUMNS
} tr_column;

typedef struct tr_column_row {
    const char *name, *unit;
} tr_column_row;

extern const tr_column_row tr_columns[TR_N_PATCH_COLUMNS]; /* `kind: contact` has the first TR_N_COLUMNS */

#endif
