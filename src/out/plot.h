/* SPDX-License-Identifier: MIT */
/* The curves of a run, by gnuplot: biaxial.svg and biaxial.png beside history.csv, or contact.svg and contact.png
 * beside contact.csv, and plot.gp that makes them, for a student to change and run again. */
#ifndef TR_PLOT_H
#define TR_PLOT_H

#include "base/param.h"
#include "base/status.h"
#include <stdbool.h>

bool tr_plot_available(void); /* is gnuplot on the PATH? */

/* caption: one line above the curves; strain_end: of the axis. *code: gnuplot's exit code. If it is not 0, there are no
 * pictures, but the run does not fail. TR_FILE: a file cannot be written. */
bool tr_plot_biaxial(const char *dir, const char *caption, double strain_end, int *code, tr_status *st);

/* The same for a contact along a path. label[i]: name of law i in the legend; rolling: some law has moments, and they
 * get their own panel; shape: of the bodies, for the units. */
bool tr_plot_contact(const char *dir, const char *const *label, int n_laws, bool rolling, tr_shape shape, int *code,
                     tr_status *st);

/* Runs a script in dir, and names its pictures STEM.svg and STEM.png. The script writes each as NAME.part, where
 * `part` is set. */
bool tr_plot_draw(const char *dir, const char *script, const char *stem, int *code, tr_status *st);

#endif
