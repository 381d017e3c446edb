/* SPDX-License-Identifier: MIT */
/* What the files of the group `exact` share. */
#ifndef TR_VERIFY_EXACT_H
#define TR_VERIFY_EXACT_H

#include "core/world.h"
#include "study/contact.h"
#include "verify/verify.h"

/* A row; order: NAN if none was observed. */
bool tr_exact_row(tr_verify *v, const char *quantity, const char *unit, double computed, double reference,
                  double tolerance, double order, const char *reason, tr_status *st);

/* The same, with words behind it. */
bool tr_exact_row_and(tr_verify *v, const char *quantity, const char *unit, double computed, double reference,
                      double tolerance, const char *reason, const char *outcome, tr_status *st);

/* Drives the first law of a case of kind contact: state at the end of each segment, at most n of them. pair: of the case;
 * may be NULL. */
bool tr_exact_path(const char *text, tr_contact_state *end, int n, tr_scene_pair *pair, tr_status *st);

/* Gives a world whose disks are set the laws of `contact: {...}` of a case. */
bool tr_exact_laws(tr_world *world, const char *contact, unsigned sinks, tr_status *st);

/* What is behind "prefix-" in the name of the verification at work: its law. */
const char *tr_exact_of(const tr_verify *v, const char *prefix);

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

#endif
