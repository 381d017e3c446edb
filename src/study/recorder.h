/* SPDX-License-Identifier: MIT */
/* paths/NAME.csv for each contact of output.paths: its path (study/path.h) and, as a further column, its friction Q.
 *
 * A row per step would be far too many. Of u_slide, u_roll, P and Q each step is compared with the last row: if one of
 * them has moved by more than 1/500 of its range so far (which includes 0), the step before is written. So all steps
 * between two rows, and the straight line between them, are within 1/500 of the range of a row, and the line is within
 * 2/500 of the path. The first and the last step are rows, and both steps where the contact opens or closes; two rows
 * that differ by more are neighbouring steps.
 *
 * Q is compared too, so that a law can be replayed: after sliding over millimetres, the tolerance of u_slide does not
 * see the micrometres of a spring that turns back, but Q does. In a replay a stretch between two rows is straight.
 * Where coulomb-spring sticks, it adds no error. Where it slips, it forgets earlier errors, and Q and mu P have moved
 * at most by their tolerance: |Q - recorded| <= 2/500 (range of Q + mu max P), which does not grow with the number of
 * rows. A row may roll by many widths of the contact, so a replay cuts it (study/contact.h). The bend of the path
 * within a row is lost, at most 2/500 of the range of each. If a row rolls far, this may be much of its sliding. But Q
 * of the run's law is nearly constant there, so only a law with another memory notices the difference.
 *
 * time_s counts from a step before the first row: a row is the end of a step, and nothing moves in the first step.
 *
 * paths.csv, with output.path_rows: N: ALL contacts of disks and of walls (a = -1-w) at N instants evenly spread from
 * start to end, in the order of time; du_slide and du_roll are sums over the steps since the row before of this
 * contact, or since it touched. The sums make the end points of the path exact; the path between two rows is not kept.
 * P, Q and the whole normal force f_n are those of the instant; P is the force that the friction law uses
 * (core/paths.h). A contact that opens and touches again is another life with its own number. A life between two
 * instants has a number but no row, and a note counts them. Motion after the last row of a contact is not kept. branch:
 * from the centre of a (of a wall: from the contact) to that of b, so that sum (f_n n - Q t)_i branch_j is area times
 * stress. */
#ifndef TR_RECORDER_H
#define TR_RECORDER_H

#include "core/paths.h"
#include "out/dir.h"
#include "study/report.h"

enum { TR_PATH_CHANNELS = 4 }; /* u_slide, u_roll, P, Q */

typedef struct tr_recorder {
    tr_paths paths;
    tr_shape shape;
    int64_t steps; /* looked at */
    int64_t total; /* of the run */
    int rows, n_rows;
    tr_file all;   /* paths.csv */
    int64_t bytes; /* of it; once it is closed */
    tr_world *world;
    double dt;
    tr_run_report *report;
    struct tr_recorded {
        tr_file file;
        double row[TR_PATH_CHANNELS], before[TR_PATH_CHANNELS]; /* the last row written; the step before */
        double low[TR_PATH_CHANNELS], high[TR_PATH_CHANNELS];
        int64_t row_step;
        bool touched;
    } item[TR_MAX_CONTACT_IDS];
} tr_recorder;

/* What is recorded, and where. */
typedef struct tr_recording {
    const tr_scene *scene;
    tr_world *world;
    const char *dir, *prefix; /* prefix: of the names of the files */
    tr_contact_id most;       /* the contact of most-mobilised; a == b: none */
    int64_t total;            /* steps of the run, for path_rows; 0: none */
    bool resume;              /* the files are continued */
} tr_recording;

/* The recorder must not move until it is closed. */
bool tr_recorder_open(tr_recorder *r, const tr_recording *of, tr_run_report *report, tr_status *st);
/* After it; resume: the files continue. */
void tr_recorder_checkpoint(tr_recorder *r, tr_checkpoint *c);
bool tr_recorder_step(tr_recorder *r, tr_status *st);  /* after every tr_step_forces */
void tr_recorder_close(tr_recorder *r, tr_status *st); /* after any end of the run: rows are complete */

/* The present state of contact k of paths.contacts. */
tr_path_point tr_recorder_now(const tr_recorder *r, int k);

/* The scene asks for the most mobilised contact. It is known only at the end, so a first run with the same bits finds
 * it. Among equals it is the first in contacts.csv. */
bool tr_recorder_wants_most(const tr_scene *scene);
tr_contact_id tr_recorder_most(tr_world *world, tr_status *st);

#endif
