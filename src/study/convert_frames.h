/* SPDX-License-Identifier: MIT */
/* Instants of a run: its disks, and the contacts that contacts.csv has at that time. */
#ifndef TR_STUDY_CONVERT_FRAMES_H
#define TR_STUDY_CONVERT_FRAMES_H

#include "base/status.h"
#include <stdio.h>

typedef struct tr_frame_disk {
    double time, x, y, angle, vx, vy, spin, radius;
    int disk;
} tr_frame_disk;

/* a = -1-w: wall w. Normal from a to b; forces [N/m] or [N], f_t along t = (ny, -nx) on a and -t on b. */
typedef struct tr_frame_contact {
    double time, x, y, nx, ny, overlap, f_n, f_t, moment_a, moment_b, v_s, v_r;
    int a, b;
} tr_frame_contact;

typedef struct tr_frame_at {
    double time, box[2][2]; /* low and high of x and of y: of the disks, or of the periodic cell */
    int n, n_contacts;
    const tr_frame_disk *disk; /* in the order of their numbers */
    const tr_frame_contact *contact;
} tr_frame_at;

typedef struct tr_frames {
    bool periodic;
    int n, n_disks, n_contacts;
    tr_frame_at *frame;
    tr_frame_disk *disk;
    tr_frame_contact *contact;
} tr_frames;

/* Free it, also after a failure. */
bool tr_frames_read(tr_frames *frames, const char *run, tr_status *st);
void tr_frames_free(tr_frames *frames);

#endif
