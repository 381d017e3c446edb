/* SPDX-License-Identifier: MIT */
/* The contacts of a biaxial test, each along the path that it had there (paths.csv, study/recorder.h), through the
 * exact half-plane and through every friction law: the error of each law on the paths of an assembly.
 *
 * A life of a contact is a case of kind: contact (study/contact.h), its rows are the segments: P linear, sliding and
 * rolling at constant rates from row to row; before the first row P grows from 0. All laws take the same steps. A step
 * rolls at most an element h = 2a/n, slides at most a tenth of the way from rest to full slip, mu delta(P), and changes
 * a by at most h (patch/cut.h; 1000 at most, in which case only the half-plane cuts on). So the path between two rows
 * is assumed, but it is the same for all laws.
 *
 * Laws: 0 exact; 1 the run's own with the run's parameters, which gives the run's Q as the rows become many; then each
 * of the registry with equivalent ones: mu, E_star, depth of the run; k_t = pi E_star/(2 Lambda), the stiffness from
 * rest of the exact contact at the mean P and radius. The last column is not a law: it is the recorded Q, of the path
 * in all its steps. If the run has no depth, it is that of hertz-line.
 *
 * Errors. Of force: (Q - Q_exact)/(mu P) at each row. Of energy: the energy that the law takes from the sliding bodies
 * over a life, W = int Q du_slide, less that of the exact contact, over int mu P |du_slide|, the energy of full slip. A
 * contact that opens has lost it all. If the contact touches at the end, W includes the stored energy, for law and
 * half-plane alike. Stress: sum of (f_n n - Q t)_i branch_j over all contacts at an instant; the area cancels in sin
 * phi = (S_yy - S_xx)/(S_yy + S_xx). Contacts of walls, and lives that could not be replayed, keep the Q of the run
 * there. */
#ifndef TR_REPLAY_H
#define TR_REPLAY_H

#include "study/replay_data.h"

/* Reads case.yaml, history.csv and paths.csv. Every disk-disk life is replayed, except those that `every` leaves out.
 * The result does not depend on the number of jobs. TR_INTERRUPTED; TR_BAD_CASE: no such run, one that is not finished,
 * or a paths.csv that this run cannot have written. */
bool tr_replay_run(tr_replay *r, const tr_replay_options *o, tr_run_report *report, tr_status *st);
void tr_replay_free(tr_replay *r);

#endif
