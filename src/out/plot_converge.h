/* SPDX-License-Identifier: MIT */
/* The pictures of `trundle converge`: converge-time, error against run time of each cause, from levels.csv;
 * converge-parts, how much of the error each cause makes. Scripts beside them make them again. */
#ifndef TR_PLOT_CONVERGE_H
#define TR_PLOT_CONVERGE_H

#include "base/status.h"

enum { TR_PLOT_NUMBERS = 4, TR_PLOT_CAUSES = 10 };

typedef struct tr_plot_converge_labels {
    int n_numbers, n_causes;
    struct {
        const char *name;
        double total;                /* the error in all */
        bool whole;                  /* no part is unknown */
        double part[TR_PLOT_CAUSES]; /* of each cause; NaN: not known */
        double low, high;            /* errors in levels.csv, > 0; low = 0: there are none */
    } number[TR_PLOT_NUMBERS];
    const char *cause[TR_PLOT_CAUSES];
    double fast, slow; /* run times in levels.csv [s] */
} tr_plot_converge_labels;

/* *code: gnuplot's exit code; if it is not 0 there are no pictures, which is no failure. TR_FILE: a file cannot be
 * written. */
bool tr_plot_converge(const char *dir, const tr_plot_converge_labels *labels, int *code, tr_status *st);

#endif
