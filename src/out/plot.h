/* SPDX-License-Identifier: MIT */
/* The curves of a biaxial test, by gnuplot: biaxial.svg and biaxial.png beside history.csv, and plot.gp that makes
 * them, for a student to change and run again. */
#ifndef TR_PLOT_H
#define TR_PLOT_H

#include "base/status.h"
#include <stdbool.h>

bool tr_plot_available(void); /* is gnuplot on the PATH? */

/* caption: one line above the curves. TR_FILE with gnuplot's exit code when it fails. */
bool tr_plot_biaxial(const char *dir, const char *caption, tr_status *st);

#endif
