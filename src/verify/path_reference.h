/* SPDX-License-Identifier: MIT */
/* Friction along the path of a case of kind contact, force given, computed without the laws of the tool.
 *
 * The differential equation [Kuhn2014 eq. 11], signed, by Runge and Kutta with 1e5 steps a segment; F0 = mu a/R, 0 for
 * a spring:
 *
 *   Q' = k_t (Vs - sgn(Q) F0 (1 - sqrt(1 - |Q|/(mu P))) |V_roll|),   |Q| <= mu P
 *
 * The bed of sliders [Jaeger2005] of a line contact, slider by slider: each stands for the same step of P, has the
 * weight int dP', P' = pi E/(2 Lambda), and joins at the mean overlap int s dP'/int dP', so that full slip is mu P:
 *
 *   e_i += du,   |e_i| <= mu (delta - s_i),   Q = sum weight_i e_i
 *   du = Vs dt; less sgn(Q) F0 (1 - sqrt(1 - q)) |dr| [Kuhn2014 eq. 16]; or less (2/pi) (|dr|/a) e_0 [VuQuoc1999]
 *
 * 4000 sliders, 8000 steps a segment: an error of about 1e-5 of mu P, by halving both. */
#ifndef TR_PATH_REFERENCE_H
#define TR_PATH_REFERENCE_H

#include "base/status.h"
#include "scene/scene.h"

enum { TR_PATH_INSTANTS = 25 }; /* of each segment, equally spaced, the last at its end */

/* k: k_t/E_star. Q_at: TR_PATH_INSTANTS for each segment. */
void tr_path_equation(const tr_scene *scene, double k, double mu, bool creeps, double *Q_at);

typedef enum tr_path_creep { TR_NO_CREEP, TR_CARTER_CREEP, TR_FADING } tr_path_creep;

bool tr_path_bed(const tr_scene *scene, double mu, tr_path_creep creep, double *Q_at, tr_status *st);

#endif
