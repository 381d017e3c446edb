/* SPDX-License-Identifier: MIT */
#include "study/warn.h"

#include "core/tangent.h"
#include "study/run_internal.h"
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

void tr_warn_bodies(const tr_bodies *b, const char *label, tr_run_report *report) {
    char of[64] = "";
    if (*label) snprintf(of, sizeof of, "%s: ", label);
    warn_tangent(b, of, report);
}
