/* SPDX-License-Identifier: MIT */
#include "study/warn.h"

#include "core/resolution.h"
#include "core/tangent.h"
#include "study/run_internal.h"
#include <math.h>
#include <stdio.h>

enum { NAMES = 80 };

/* "disks 0 and 1", "wall 0 and disk 1" */
static void name_pair(int a, int b, char text[NAMES]) {
    snprintf(text, NAMES, a < 0 ? "wall %d and disk %d" : "disks %d and %d", a < 0 ? -1 - a : a, b);
}

static void warn_tangent(const tr_bodies *b, const char *of, tr_run_report *report) {
    tr_tangent t;
    char names[NAMES], more[60] = "";
    if (!tr_tangent_find(b, &t)) return;
    name_pair(t.a, t.b, names);
    if (t.more) snprintf(more, sizeof more, "; so do %d more pair%s", t.more, t.more > 1 ? "s" : "");
    const char *unit = b->world.shape == TR_SHAPE_SPHERE ? "N" : "N/m";
    if (t.weight)
        tr_run_note(report,
                    "%s%s only touch (gap %.2g m): the run begins with a fall. The weight needs an overlap of %.4g m; "
                    "give disk %d x: %.12g, y: %.12g%s",
                    of, names, t.gap, t.overlap, t.moved, t.x, t.y, more);
    else
        tr_run_note(report,
                    "%s%s only touch (gap %.2g m) and nothing presses them: they may not be in contact at all. An "
                    "overlap of %.4g m presses them with %.4g %s; give disk %d x: %.12g, y: %.12g%s",
                    of, names, t.gap, t.overlap, t.force, unit, t.moved, t.x, t.y, more);
}

static void warn_resolution(const tr_bodies *b, const char *of, tr_run_report *report) {
    tr_resolution r;
    char names[NAMES];
    if (tr_resolution_overlap(b, &r)) {
        name_pair(r.a, r.b, names);
        tr_run_note(
            report,
            "%s%s: numbers near %.4g m are %.2g m apart, and an overlap of about %.2g m is made of them: it may "
            "be off by %.2g of itself. Stay nearer to the origin (0, 0), or take softer contacts",
            of, names, r.reach, r.spacing, r.size, r.spacing / r.size);
    }
    if (tr_resolution_way(b, &r)) {
        tr_run_note(
            report,
            "%s%s %d moves by %.2g m a step, and numbers near %.4g m are %.2g m apart: its way may be off by %.2g "
            "of itself. Stay nearer to the origin (0, 0), or take a larger step.dt",
            of, r.b < 0 ? "wall" : "disk", r.b < 0 ? -1 - r.b : r.b, r.size, r.reach, r.spacing,
            fmin(1, 0.5 * r.spacing / r.size));
    }
}

void tr_warn_bodies(const tr_bodies *b, const char *label, tr_run_report *report) {
    char of[64] = "";
    if (*label) snprintf(of, sizeof of, "%s: ", label);
    warn_tangent(b, of, report);
    warn_resolution(b, of, report);
}

void tr_warn_biaxial(const tr_biaxial *b, tr_run_report *report) {
    tr_resolution r;
    if (tr_resolution_biaxial(b, &r))
        tr_run_note(
            report,
            "contacts are too stiff for the pressure: numbers across the sample, %.2g m, are %.2g m apart, and a "
            "mean overlap of %.2g m is made of them: it may be off by %.2g of itself",
            r.reach, r.spacing, r.size, r.spacing / r.size);
}
