/* SPDX-License-Identifier: MIT */
#include "cli/progress.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

int tr_cli_fail(const tr_status *st) {
    fprintf(stderr, "%s\n", st->text);
    return st->code;
}

static double clock_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

tr_progress tr_progress_begin(void) {
    const char *no_color = getenv("NO_COLOR"), *term = getenv("TERM");
    bool dumb = term && !strcmp(term, "dumb");
    return (tr_progress){.terminal = isatty(STDERR_FILENO) && !dumb, .color = !(no_color && *no_color)};
}

static int terminal_width(void) {
    struct winsize size;
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void tr_progress_show(void *context, const char *stage, double fraction) {
    tr_progress *p = context;
    if (!p->terminal) return;
    double now = clock_now();
    if (strncmp(p->stage, stage, sizeof p->stage - 1)) {
        snprintf(p->stage, sizeof p->stage, "%s", stage);
        p->started = now;
        p->drawn = 0;
    }
    if (now - p->drawn < 0.1) return;
    p->drawn = now;
    fraction = fmin(fmax(fraction, 0), 1);
    char tail[40], line[128];
    double eta = fraction > 0.02 ? (now - p->started) * (1 - fraction) / fraction : NAN;
    if (isnan(eta))
        snprintf(tail, sizeof tail, "%3.0f %%", 100 * fraction);
    else
        snprintf(tail, sizeof tail, "%3.0f %%  %.0f s left", 100 * fraction, ceil(eta));
    int width = terminal_width() - 1, bar = width - (int)strlen(p->stage) - 2 - (int)strlen(tail) - 2;
    if (bar < 4) { /* too narrow: a line that wraps could not be wiped */
        snprintf(line, sizeof line, "%s  %s", p->stage, tail);
        fprintf(stderr, "\r\033[K%.*s", width, line);
    } else {
        bar = bar > 40 ? 40 : bar;
        int full = (int)lround(bar * fraction);
        fprintf(stderr, "\r\033[K%s  %s", p->stage, p->color ? "\033[34m" : "");
        for (int k = 0; k < bar; k++) fputs(k < full ? "#" : ".", stderr);
        fprintf(stderr, "%s  %s", p->color ? "\033[0m" : "", tail);
    }
    fflush(stderr);
}

void tr_progress_end(tr_progress *p) {
    if (p->terminal && p->stage[0]) fputs("\r\033[K", stderr);
}
