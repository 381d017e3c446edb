/* SPDX-License-Identifier: MIT */
/* Pictures of a world: frames of 1280 x 720 drawn off-screen, saved as PNG or sent to a film.
 *
 * A canvas may be drawn over. What to draw is a tr_view or a tr_show; nothing is read from
 * anywhere else, and the same view gives the same pixels. In all strings `_` lowers
 * the letters and digits behind it, or one other character: "V_s", "R_eq". */
#ifndef TR_DRAW_H
#define TR_DRAW_H

#include "base/status.h"
#include "core/record.h"
#include "core/world.h"
#include "patch/patch.h"
#include "scene/scene.h"
#include <stdbool.h>

enum { TR_FRAME_WIDTH = 1280, TR_FRAME_HEIGHT = 720 };

/* One row of the side panel; a value carries its unit. */
typedef struct tr_view_line {
    const char *label, *value;
} tr_view_line;

/* A biaxial test so far, row by row. */
typedef struct tr_history {
    int n;
    const double *strain, *sin_phi, *rolling_share, *unbalanced;
    double strain_end;
} tr_history;

/* The contents of a frame of an assembly. For a film without flicker keep range, f_mean and the box the same in all
 * frames. */
typedef struct tr_view {
    const tr_world *world;
    const tr_record *record; /* touching contacts */
    int n_records;
    tr_color color;        /* field that colours the contacts, or, with `fill`, the disks */
    const double *fill;    /* of each disk [1, m/s or rad]; contacts are then not drawn. NULL: contacts are drawn */
    double range;          /* end of the colour bar, of TR_COLOR_SPIN both ends; 0: chosen from this frame */
    double f_mean;         /* normal force drawn as a line of mean width [N/m]; 0: this frame's mean */
    double x0, y0, x1, y1; /* part of the plane that is shown, x0 < x1, y0 < y1 [m] */
    double time, time_end; /* [s]; time_end chooses the printed unit, so that it does not change */
    const char *title;     /* NULL: no title, the picture uses its room */
    const tr_view_line *line;
    int n_lines;
    const tr_history *history;   /* its curves, where there is no inset; NULL: none */
    const tr_patch_state *inset; /* the inside of the contact of disks inset_a and inset_b; NULL: none */
    const tr_patch_pair *inset_pair;
    int inset_a, inset_b;
    double inset_law; /* Q/(mu P) of the inset's contact by the law of the run; the inset has its own in its state */
} tr_view;

typedef struct tr_canvas tr_canvas;

/* ---- films of a few bodies ---- */

/* What a contact has left on the surface of a body. On a disk: angles that turn with it [rad]; on a wall: places along
 * (n_y, -n_x) from its own point [m]. */
typedef struct tr_rim_mark {
    int body;        /* disk, or -1-w for wall w */
    double from, to; /* rubbed from..to; a tick is at `to` */
    int number;      /* of the tick; 0: rubbed */
    double apart;    /* of ticks: way to the next [m] */
} tr_rim_mark;

/* One number of the table of checks, as text. */
typedef struct tr_show_check {
    char group[48], what[80], measured[40], exact[40]; /* group: of neighbours in the table; "": none */
    bool ok;
} tr_show_check;

/* One of the scenes of a film, side by side; most films have one. */
typedef struct tr_show_lane {
    const char *label; /* NULL: none */
    const tr_world *world;
    const tr_scene_disk *disk; /* what the case says of the disks of world, for threads; NULL: nothing */
    const tr_record *record;   /* touching contacts */
    int n_records;
    tr_contact_id contact; /* the one that the panel shows; a = b: the first ones */
    double tilt;  /* the picture is turned by it, counter-clockwise, so that gravity points down [rad] */
    double slope; /* shown as the angle of the floor; NaN: there is none, or it is level [rad] */
    double x0, y0, x1,
        y1; /* part of the turned plane that is shown, of (x cos tilt - y sin tilt, x sin tilt + y cos tilt)
                              [m] */
    const double *trace; /* path of the contact points so far: x, y, in the plane before turning; NaN, NaN lifts
                              the pen [m] */
    int n_trace;         /* points */
    const tr_rim_mark *mark;
    int n_marks;
    const tr_patch_state *inset; /* the inside of the contact inset_a, inset_b (as in tr_record); NULL: none */
    const tr_patch_pair *inset_pair;
    int inset_a, inset_b;
} tr_show_lane;

/* Curves over time, one or two a lane: beside the bars or, with several lanes, instead of them. */
typedef struct tr_chart {
    const char *name[2];                  /* of the curves of a lane: "V_s", "V_r", or "speed", NULL */
    unsigned hue[2];                      /* of the curves: what they mean */
    const char *unit;                     /* SI: "m/s", "1" */
    double top, bottom;                   /* range of values over the whole film */
    int n;                                /* points so far */
    const double *time;                   /* [s] */
    const double *value[TR_MAX_LANES][2]; /* n each; NULL: none */
    double mark[TR_MAX_LANES];            /* time of the closed form, a vertical line [s]; NaN: none */
} tr_chart;

typedef struct tr_show {
    bool expert;                  /* the table of all definitions; else what a class reads: three numbers, large */
    const char *title, *equation; /* NULL: none. equation: with its Wang number, "Δa = −Δb   [Wang eq. 2]" */
    double time, time_end;        /* [s] */
    double slower;                /* film time / time of the motion; 1: as it is */
    double range;                 /* speed of a full bar or longest arrow; 0 or less: from this frame [m/s] */
    const tr_show_lane *lane;
    int n_lanes;           /* 1 to TR_MAX_LANES */
    const tr_chart *chart; /* NULL: none */
    /* of a still: */
    const char *caption; /* one sentence below the picture; NULL: a frame of the film */
    const tr_show_check *check;
    int n_checks;
} tr_show;

/* One instant of the inside of a line contact. For a film without flicker set the ranges. */
typedef struct tr_patch_view {
    const tr_patch_pair *pair;
    const tr_patch_state *state; /* P = 0: the contact is open */
    double v_slide, v_roll;      /* du and dr of the path, in any unit: only signs and ratio are drawn */
    double a_max, p_max;         /* largest half-width [m] and pressure [Pa]; 0: of this state */
    double slip_max;             /* of a step, end of the colour bar [m]; 0: of this state */
    double progress;             /* of the path, 0 to 1 */
    const char *title;           /* NULL: none */
    const tr_view_line *line;
    int n_lines;
} tr_patch_view;

#endif
