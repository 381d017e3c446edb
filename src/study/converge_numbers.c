/* SPDX-License-Identifier: MIT */
#include "study/converge_numbers.h"

#include "base/gather.h"
#include "scene/text.h"
#include "scene/what.h"
#include "study/converge_cell.h"
#include "study/run.h"
#include "base/math.h"
#include <fnmatch.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a kind is quoted by. */
static const struct {
    tr_kind kind;
    const char *pattern;
} usual[] = {
    {TR_KIND_BIAXIAL, "sin_phi_peak"},       {TR_KIND_BIAXIAL, "sin_phi_residual"},
    {TR_KIND_BIAXIAL, "e_residual"},         {TR_KIND_BODIES, "checks.*.measured"},
    {TR_KIND_CONTACT, "laws.*.Q_end*"},      {TR_KIND_CONTACT, "laws.*.Q_max*"},
    {TR_KIND_CONTACT, "laws.*.moment_max*"}, {TR_KIND_PATCH, "Q_end*"},
    {TR_KIND_PATCH, "u_slide_end*"},         {TR_KIND_PATCH, "dissipated*"},
};

/* The number k of the checks of all documents. */
static const tr_scene_check *check_of(const tr_scene *s, int k) {
    if (k < s->n_checks) return &s->checks[k];
    for (int i = 0; i < s->n_more; i++) {
        k -= i ? s->more[i - 1].n_checks : s->n_checks;
        if (k < s->more[i].n_checks) return &s->more[i].checks[k];
    }
    return NULL;
}

/* The check that a number is of; NULL: it is of none. */
static const tr_scene_check *check_behind(const tr_scene *s, const char *name) {
    int k, end = 0;
    return sscanf(name, "checks.%d.measured%n", &k, &end) == 1 && end && k >= 0 ? check_of(s, k) : NULL;
}

static bool add(tr_converge *c, const char *name, bool is_usual, tr_status *st) {
    for (int i = 0; i < c->n_numbers; i++)
        if (!strcmp(c->number[i].name, name))
            return is_usual || tr_status_fail(st, TR_BAD_CASE, "error: --of has `%.60s` twice", name);
    if (c->n_numbers == TR_CONVERGE_NUMBERS)
        return is_usual || tr_status_fail(st, TR_BAD_CASE, "error: --of takes at most %d names", TR_CONVERGE_NUMBERS);
    tr_converge_number *n = &c->number[c->n_numbers++];
    const tr_scene_check *check = check_behind(&c->scene, name);
    snprintf(n->name, sizeof n->name, "%s", name);
    snprintf(n->shown, sizeof n->shown, check ? "%s (%s)" : "%s", n->name, check ? tr_whats[check->what].name : "");
    n->usual = is_usual;
    return true;
}

typedef struct names {
    tr_converge *c;
    const char *wanted, *pattern; /* wanted NULL: those of the pattern */
    bool found;
    tr_near near;
    char kept[TR_SUMMARY_NAME];
    FILE *list;
    int n;
} names;

static void take(void *context, const char *name) {
    names *n = context;
    tr_status ignored = {0};
    if (!strncmp(name, "timing.", 7)) return;
    if (!n->wanted) {
        if (!fnmatch(n->pattern, name, 0)) add(n->c, name, true, &ignored);
        return;
    }
    const char *before = n->near.word;
    n->found |= !strcmp(name, n->wanted);
    tr_text_nearer(&n->near, n->wanted, name);
    if (n->near.word != before) snprintf(n->kept, sizeof n->kept, "%s", name), n->near.word = n->kept;
    fprintf(n->list, "%s%s", n->n++ ? ", " : "", name);
}

static bool add_named(tr_converge *c, const char *summary, const char *name, tr_status *st) {
    tr_gather list;
    if (strchr(name, '@')) return tr_converge_cell_check(c->scene.kind, name, st) && add(c, name, false, st);
    if (!tr_gather_begin(&list, st)) return false;
    names n = {.c = c, .wanted = name, .list = list.stream};
    bool ok = tr_summary_numbers(summary, take, &n, st);
    char *all = tr_gather_end(&list, st);
    if (ok && all && !n.found)
        tr_status_fail(st, TR_BAD_CASE, "error: the summary of %.200s has no number `%s`%s; there are: %.600s",
                       c->options->case_file, tr_text_show(name).text, tr_text_hint(&n.near).text, all);
    free(all);
    return !st->code && add(c, name, false, st);
}

/* Bodies without checks: how each disk that moves ends. */
static void add_ends(tr_converge *c) {
    static const char *const columns[] = {"vx_m_per_s", "vy_m_per_s", "spin_rad_per_s"};
    tr_status ignored = {0};
    for (int i = 0; i < c->scene.n_disks; i++)
        for (int k = 0; k < 3 && c->scene.disks[i].motion != TR_PRESCRIBED; k++) {
            char name[80];
            snprintf(name, sizeof name, "history.%d.%s@end", i, columns[k]);
            add(c, name, true, &ignored);
        }
}

bool tr_converge_choose(tr_converge *c, tr_status *st) {
    tr_run_report report;
    char *summary = NULL;
    const char *of = c->options->of;
    if (!tr_run_check(&c->scene, &report, &summary, st)) return false;
    bool ok = !of || *of || tr_status_fail(st, TR_BAD_CASE, "error: --of names no number");
    for (size_t i = 0; ok && !of && i < sizeof usual / sizeof *usual; i++) {
        names some = {.c = c, .pattern = usual[i].pattern};
        ok = usual[i].kind != c->scene.kind || tr_summary_numbers(summary, take, &some, st);
    }
    while (ok && of && *of) {
        char name[TR_SUMMARY_NAME];
        size_t n = strcspn(of, ",");
        snprintf(name, sizeof name, "%.*s", (int)n, of);
        ok = add_named(c, summary, name, st);
        of += n + (of[n] == ',');
    }
    free(summary);
    if (ok && !c->n_numbers && c->scene.kind == TR_KIND_BODIES && !c->scene.n_more) add_ends(c);
    if (ok && !c->n_numbers)
        tr_status_fail(st, TR_BAD_CASE, "error: %.200s has no number to look at; name some with --of",
                       c->options->case_file);
    return !st->code;
}

static double scale_of_cell(const tr_scene *s, const char *column) {
    double R = INFINITY, speed = 0;
    for (int i = 0; i < s->n_disks; i++) {
        const tr_scene_disk *d = &s->disks[i];
        R = fmin(R, d->radius);
        speed = fmax(speed, tr_hypot(d->vx, d->vy) + fabs(d->spin) * d->radius);
    }
    speed = fmax(speed, tr_hypot(s->gravity.x, s->gravity.y) * s->time_end);
    if (!strncmp(column, "v", 1)) return speed;
    if (!strncmp(column, "spin", 4)) return speed / R;
    return !strncmp(column, "angle", 5) ? 1 : R;
}

double tr_converge_scale(const tr_converge *c, int number, double value) {
    const char *name = c->number[number].name, *at = strchr(name, '@');
    const tr_scene_check *check = check_behind(&c->scene, name);
    double scale = check ? fmax(fabs(check->exact), check->tolerance) : 0;
    scale = fmax(scale, fabs(value));
    if (at && c->scene.kind == TR_KIND_BODIES) {
        /* a cell of history.csv has 9 digits: its rounding is a hundred times that of a summary */
        const char *column = strchr(strchr(name, '.') + 1, '.');
        scale = 100 * fmax(scale, scale_of_cell(&c->scene, column ? column + 1 : ""));
    }
    return scale;
}

double tr_converge_grain(const tr_converge *c, int number) {
    static const double SLOPE = 0.05 * M_PI / 180; /* study/checks.h */
    const tr_scene_check *check = check_behind(&c->scene, c->number[number].name);
    return check && tr_whats[check->what].when == TR_SLOPE ? SLOPE : 0;
}
