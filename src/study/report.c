/* SPDX-License-Identifier: MIT */
#include "study/report.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>

void tr_run_say(tr_run_report *report, const char *label, const char *format, ...) {
    assert(report->n_lines < (int)(sizeof report->line / sizeof *report->line));
    struct tr_report_line *line = &report->line[report->n_lines++];
    va_list args;
    va_start(args, format);
    snprintf(line->label, sizeof line->label, "%s", label);
    vsnprintf(line->value, sizeof line->value, format, args);
    va_end(args);
}

void tr_run_note(tr_run_report *report, const char *format, ...) {
    assert(report->n_notes < (int)(sizeof report->note / sizeof *report->note));
    va_list args;
    va_start(args, format);
    vsnprintf(report->note[report->n_notes++], sizeof report->note[0], format, args);
    va_end(args);
}

bool tr_run_stopped(const tr_run_options *options) {
    return options->stop && *options->stop;
}

void tr_run_progress(const tr_run_options *options, const char *stage, double fraction) {
    if (options->progress) options->progress(options->context, stage, fraction);
}
