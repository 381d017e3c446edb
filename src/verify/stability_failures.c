/* SPDX-License-Identifier: MIT */
/* Cases without a right answer: each must stop with TR_NUMERICAL and say where, before any number is wrong. */
#include "base/alloc.h"
#include "core/step.h"
#include "verify/stability.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define START "kind: bodies\ntime_end: 1 s\ncontact: {k_n: 1 MPa, damping_ratio: 0, mu: 0.5, mu_r: 0.5}\n"
#define HUGE_AND_TINY                                                                                                  \
    START "disks: [{radius: 10, x: -1000, y: 0}, {radius: 10, x: 1000, y: 0}, {radius: 10, x: 0, y: 1000},\n"

typedef struct doomed {
    const char *what, *text, *words; /* words: names in the message, besides step and time */
} doomed;

static const doomed cases[] = {
    {"overlap 90 % at the start", START "disks: [{radius: 1, x: 0, y: 0}, {radius: 1, x: 1.1, y: 0}]\n",
     "disks 0 and 1: overlap"},
    {"centres that coincide", START "disks: [{radius: 1, x: 0, y: 0}, {radius: 1, x: 0, y: 0}]\n",
     "disks 0 and 1: overlap"},
    {"centre behind a wall", START "disks: [{radius: 1, x: 0, y: -3}]\nwalls: [{nx: 0, ny: 1}]\n",
     "wall 0 with disk 0: overlap"},
    {"impact too hard for the springs",
     START "step: {safety: 0.01}\ndisks: [{radius: 1, x: 0, y: 0, vx: 30}, {radius: 1, x: 2.1, y: 0, vx: -30}]\n",
     "disks 0 and 1: overlap"},
    {"impact that would leap through", START "disks: [{radius: 1, x: 0, y: 0, vx: 1e5}, {radius: 1, x: 3, y: 0}]\n",
     "disk 0: it moves"},
    {"wall that sweeps over a disk", START "disks: [{radius: 1, x: 0, y: 5}]\nwalls: [{nx: 0, ny: 1, vy: 1e5}]\n",
     "wall 0 with disk 0: overlap"},
    /* the mean diameter, which sets the skin of the list, is 1e4 times theirs */
    {"tiny disks too hard, huge ones far away",
     HUGE_AND_TINY
     "{radius: 1e-3, x: 0, y: 0, vx: 30}, {radius: 1e-3, x: 2.1e-3, y: 0, vx: -30}]\nstep: {safety: 0.01}\n",
     "disks 3 and 4: overlap"},
    {"tiny disk crushed between huge ones",
     START "disks: [{radius: 10, x: -10.001, y: 0, vx: 1e-2, motion: prescribed}, {radius: 10, x: 10.001, y: 0, "
           "motion: prescribed},\n"
           "{radius: 1e-3, x: 0, y: 0}]\n",
     "disk 2: overlap|disks 0 and 2: overlap|disks 1 and 2: overlap"},
    {"mass ratio 1e9, the light one below",
     START
     "gravity: {y: -9.81}\ndisks: [{radius: 1, x: 0, y: 1, density: 1e-3}, {radius: 1, x: 0, y: 3, density: 1e6}]\n"
     "walls: [{nx: 0, ny: 1}]\n",
     "overlap"},
    {"step at twice the limit, allowed",
     "kind: bodies\ntime_end: 100 s\ncontact: {k_n: 1 MPa, damping_ratio: 0, friction: none, rolling: none}\n"
     "step: {dt: 4*sqrt(2700 kg/m^3*pi*1 m^2/(2*contact.k_n)), allow_unstable: yes}\n"
     "disks: [{radius: 1, x: 0, y: 0.99, vy: 1e-6}]\nwalls: [{nx: 0, ny: 1}, {y: 1.98, nx: 0, ny: -1}]\n",
     "disk 0"},
};

static bool names(const char *text, const char *words) {
    char one[80];
    for (; *words; words += strcspn(words, "|"), words += *words == '|') {
        snprintf(one, sizeof one, "%.*s", (int)strcspn(words, "|"), words);
        if (strstr(text, one)) return strstr(text, "step") && strstr(text, "time");
    }
    return false;
}

static bool one(tr_verify *v, const doomed *c, tr_stability_run *run, tr_status *st) {
    tr_status end = {0};
    bool started = tr_stability_open(run, c->text, NULL, 0, &end), finite = true;
    while (started && run->b.world.steps < run->b.steps && tr_stability_step(run, &end)) {
    }
    if (started) finite = tr_stability_readable(&run->b.world);
    tr_stability_close(run);
    char said[200];
    if (end.code == TR_BAD_CASE) return tr_status_fail(st, TR_BAD_CASE, "%s", end.text);
    snprintf(said, sizeof said, "%.120s%s", end.code ? end.text : "ran to its end", finite ? "" : "; NOT FINITE");
    return tr_verify_go_on(v, st) &&
           tr_verify_outcome(v, c->what, said, end.code == TR_NUMERICAL && finite && names(end.text, c->words), st);
}

bool tr_stability_failures(tr_verify *v, tr_status *st) {
    tr_stability_run *run = tr_alloc(1, sizeof *run, st);
    bool ok = run != NULL;
    for (size_t i = 0; ok && i < sizeof cases / sizeof *cases; i++) ok = one(v, &cases[i], run, st);
    free(run);
    return ok;
}
