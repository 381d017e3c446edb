/* SPDX-License-Identifier: MIT */
/* One running scene of a few bodies, with its observers: checks, recorded paths, the past that frames show (the path of
 * the contact points, the curves), and the inside of a contact. A case may have several scenes: each runs with its own
 * step, and the film shows them side by side. */
#ifndef TR_PLAY_H
#define TR_PLAY_H

#include "draw/draw.h"
#include "study/checks.h"
#include "study/inset.h"
#include "study/marks.h"
#include "study/recorder.h"

enum { TR_PLAY_SAMPLES = 401, TR_PLAY_TRACES = 4 };

typedef struct tr_play {
    const tr_scene *scene;
    int curve; /* tr_curve, of the first scene */
    tr_bodies b;
    tr_checks checks;
    tr_recorder recorder;
    tr_inset inset;
    int64_t at;         /* steps taken; -1: the forces of time 0 are still missing */
    tr_record *records; /* of the last tr_play_observe */
    int n_records, capacity;
    int samples, n; /* of the past: asked, taken */
    double time[TR_PLAY_SAMPLES], value[2][TR_PLAY_SAMPLES];
    double creepage; /* end of its axis: 1.5 times its largest value while the contact sticks somewhere; beyond,
                      * creepage has no meaning */
    tr_contact_id traced[TR_PLAY_TRACES];
    double point[TR_PLAY_TRACES][TR_PLAY_SAMPLES][2];
    double trace[TR_PLAY_TRACES * (TR_PLAY_SAMPLES + 1) * 2]; /* the points one behind the other, as frames want them */
    tr_marks marks;
    tr_rim_mark mark[TR_MARKS_MOST]; /* one behind the other */
} tr_play;

/* At the start. The play must not move until it is closed. */
bool tr_play_open(tr_play *p, const tr_scene *scene, int curve, tr_status *st);
void tr_play_close(tr_play *p);

/* Runs to the forces of that step. */
bool tr_play_to(tr_play *p, int64_t step, tr_status *st);

/* Fills in records. */
bool tr_play_observe(tr_play *p, tr_status *st);

double tr_play_time(const tr_play *p);

/* The angle by which a picture is turned so that gravity points down; 0 without gravity [rad]. */
double tr_play_tilt(const tr_play *p);

/* After tr_play_observe: the contents of a frame, except its box. */
tr_show_lane tr_play_lane(tr_play *p);

#endif
