/* SPDX-License-Identifier: MIT */
/* The parameters that several laws share: the material of the two bodies and their contact. Each row stands here once,
 * with its unit, range and words. A law lists it in its own rows with the place in its own struct, so a key of a case
 * means the same in every law that reads it. `at` is that place, `fallback` the default ("0.3"; NULL: the case must
 * give the key). */
#ifndef TR_MATERIAL_H
#define TR_MATERIAL_H

#include "base/param.h"

#define TR_ROW_E_STAR(par, at)                                                                                         \
    { "E_star", TR_REAL, TR_DIM_MODULUS, "Pa", NULL, 1e-3, 1e15, NULL, offsetof(par, at),                              \
      "contact modulus, 1/E_star = sum of (1 - nu^2)/E of both bodies; sets the size of the contact" }
#define TR_ROW_NU(par, at)                                                                                             \
    { "nu", TR_REAL, TR_DIM_NUMBER, "1", "0.3", -0.999, 0.5, NULL, offsetof(par, at),                                  \
      "Poisson's ratio of both bodies; only spheres use it" }
#define TR_ROW_DEPTH(par, at)                                                                                          \
    { "depth", TR_REAL, TR_DIM_LENGTH, "m", "0", 0, 1e6, NULL, offsetof(par, at),                                      \
      "d of the approach (2P/(pi E_star)) (ln(2d/a) + 1/2); 0: that of the disks, 2 sqrt(R1 R2)/e" }
#define TR_ROW_MU(par, at, least)                                                                                      \
    { "mu", TR_REAL, TR_DIM_NUMBER, "1", NULL, least, 100, NULL, offsetof(par, at), "friction coefficient" }
#define TR_ROW_MU_R(par, at, fallback)                                                                                 \
    { "mu_r", TR_REAL, TR_DIM_NUMBER, "1", fallback, 0, 100, NULL, offsetof(par, at),                                  \
      "coefficient of rolling resistance" }
#define TR_ROW_K_T(par, at)                                                                                            \
    { "k_t", TR_REAL, TR_DIM_STIFFNESS, "Pa|N/m", "0.5*k_n", 1e-3, 1e15, NULL, offsetof(par, at),                      \
      "tangential stiffness" }
#define TR_ROW_K_R(par, at)                                                                                            \
    { "k_r", TR_REAL, TR_DIM_STIFFNESS, "Pa|N/m", "k_t", 1e-3, 1e15, NULL, offsetof(par, at), "rolling stiffness" }
#define TR_ROW_DAMPING_RATIO(par, at)                                                                                  \
    { "damping_ratio", TR_REAL, TR_DIM_NUMBER, "1", "0.3", 0, 10, NULL, offsetof(par, at),                             \
      "normal dashpot, as a share of critical damping of the pair at its present stiffness" }
#define TR_ROW_CREEP_ROLL(par, at)                                                                                     \
    { "creep_roll", TR_CHOICE, TR_DIM_NUMBER, "", "kuhn", 0, 0, "kuhn|wang", offsetof(par, at),                        \
      "rolling that creeps: kuhn (s1 + s2)/2, the mean flow of material; wang R1R2/(R1+R2) (w1 - w2)" }
#define TR_ROW_R_EQ(par, at)                                                                                           \
    { "R_eq", TR_CHOICE, TR_DIM_NUMBER, "", "harmonic", 0, 0, "harmonic|half", offsetof(par, at),                      \
      "equivalent radius: harmonic: 2R1R2/(R1+R2), at a wall 2R2; half: R1R2/(R1+R2), at a wall R2" }

#endif
