/* SPDX-License-Identifier: MIT */
/* Tables beside the stage. */
#ifndef TR_DRAW_SHOW_PANEL_H
#define TR_DRAW_SHOW_PANEL_H

#include "draw/frame.h"

/* V_s and V_r by every definition, a column for each of the first contacts. Rows that do not fit at a readable size are
 * left out: the arcs, then the last definitions; then all, and it returns false. */
bool tr_panel_bars(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range);

/* Height that the table of checks wants [px]; its last line counts the rows that do not fit. */
double tr_panel_checks_height(const tr_show_check *check, int n);
void tr_panel_checks(cairo_t *cr, tr_box box, const tr_show_check *check, int n);

#endif
