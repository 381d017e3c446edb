/* SPDX-License-Identifier: MIT */
#include "study/path.h"

#include "base/alloc.h"
#include "laws/law.h"
#include "study/csv.h"
#include <math.h>

enum { SLIDE, ROLL, FORCE, TIME, LAW, COLUMNS };

typedef struct path {
    tr_scene *scene;
    int capacity;
    bool timed;                           /* the file has a column of times */
    double law;                           /* only the rows with this law count: that of the first row */
    double now[COLUMNS], before[COLUMNS]; /* this row, the row before */
} path;

static const char *const columns_disk[COLUMNS] = {"u_slide_m", "u_roll_m", "P_N_per_m", "time_s", "law"};
static const char *const columns_sphere[COLUMNS] = {"u_slide_m", "u_roll_m", "P_N", "time_s", "law"};

static bool cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    path *p = context;
    const char *name = (p->scene->shape == TR_SHAPE_SPHERE ? columns_sphere : columns_disk)[column];
    (void)length;
    p->timed |= column == TIME;
    if (!tr_csv_number(csv, name, text, false, &p->now[column])) return false;
    if (column == FORCE && p->now[FORCE] < 0)
        return tr_csv_fail(csv, csv->line, "%s is %s: a force must be above 0, or 0 where the bodies are apart", name,
                           text);
    double most = column == FORCE ? 1e12 : column == SLIDE || column == ROLL ? 1e3 : INFINITY; /* as in a case */
    if (!(fabs(p->now[column]) <= most))
        return tr_csv_fail(csv, csv->line, "%s is %s, allowed is up to %g", name, text, most);
    return true;
}

/* The widest contact that an item's line law can have, as a force; see scene/check.c for paths in the case. */
static bool deep_enough(const path *p, tr_csv *csv) {
    for (int i = 0; i < p->scene->n_laws; i++) {
        const tr_scene_law *chosen = &p->scene->laws[i].normal;
        const tr_law *law = tr_laws_normal[chosen->law];
        const double *depth = tr_law_value(law, chosen->par, "depth"),
                     *E_star = tr_law_value(law, chosen->par, "E_star");
        const tr_scene_pair *pair = &p->scene->pair;
        if (!depth) continue;
        double d = tr_law_depth(*depth, pair->R1, pair->R2);
        double a = tr_law_width(TR_SHAPE_DISK, p->now[FORCE], pair->R_star, *E_star);
        if (!(a < d))
            return tr_csv_fail(
                csv, csv->row_line,
                "this force presses the contact of `laws.%d` as wide as its depth, %.3g m; give a larger "
                "`bodies.depth` or `bodies.Lambda`",
                i, d);
    }
    return true;
}

static bool row(void *context, tr_csv *csv) {
    path *p = context;
    tr_scene *s = p->scene;
    if (!s->n_segments) p->law = p->now[LAW];
    if (p->now[LAW] != p->law) return true;
    if (p->timed && !(p->now[TIME] > p->before[TIME]))
        return tr_csv_fail(csv, csv->row_line, "time_s is %g: it must grow from row to row, and from 0 to the first",
                           p->now[TIME]);
    if (!deep_enough(p, csv)) return false;
    if (s->n_segments == p->capacity) {
        int grown = p->capacity * 2 + 1024;
        if (!tr_alloc_grow(&s->path, (size_t)s->n_segments, (size_t)grown, sizeof *s->path, csv->st)) return false;
        p->capacity = grown;
    }
    s->path[s->n_segments++] = (tr_scene_segment){.force = p->now[FORCE],
                                                  .overlap = NAN,
                                                  .slide = p->now[SLIDE] - p->before[SLIDE],
                                                  .roll = p->now[ROLL] - p->before[ROLL],
                                                  .tangential = NAN,
                                                  .time = p->now[TIME] - p->before[TIME],
                                                  .steps = 1};
    for (int k = 0; k < COLUMNS; k++) p->before[k] = p->now[k];
    return true;
}

/* Rates are not guessed. */
static bool has_times(const path *p, tr_status *st) {
    for (int i = 0; i < p->scene->n_laws && !p->timed; i++) {
        const tr_scene_contact *c = &p->scene->laws[i];
        const tr_param_table *friction = &tr_laws_friction[c->friction.law]->table,
                             *rolling = &tr_laws_rolling[c->rolling.law]->table;
        bool by_friction = tr_param_demands(friction, c->friction.par) & TR_NEEDS_TIME;
        if (by_friction || tr_param_demands(rolling, c->rolling.par) & TR_NEEDS_TIME)
            return tr_status_fail(st, TR_BAD_CASE,
                                  "%.480s:1: error: no column time_s: the law %s of `laws.%d` depends on the rate",
                                  p->scene->path_file, (by_friction ? friction : rolling)->name, i);
    }
    return true;
}

static bool reaches_checks(const tr_scene *scene, tr_status *st) {
    for (int i = 0; i < scene->n_checks; i++)
        if (scene->checks[i].segment >= scene->n_segments)
            return tr_status_fail(st, TR_BAD_CASE,
                                  "%.480s:1: error: `checks.%d.segment` is %d, and the rows of this path count from 0 "
                                  "to %d",
                                  scene->path_file, i, scene->checks[i].segment, scene->n_segments - 1);
    return true;
}

bool tr_path_read(tr_scene *scene, tr_status *st) {
    path p = {.scene = scene};
    bool sphere = scene->shape == TR_SHAPE_SPHERE;
    const tr_csv_format format = {sphere ? columns_sphere : columns_disk,
                                  COLUMNS,
                                  TIME,
                                  sphere ? "u_slide_m,u_roll_m,P_N" : "u_slide_m,u_roll_m,P_N_per_m",
                                  NULL,
                                  cell,
                                  row};
    if (!tr_csv_read(scene->path_file, &format, &p, st)) return false;
    if (!scene->n_segments)
        return tr_status_fail(st, TR_BAD_CASE, "%.480s:1: error: no row after the header line", scene->path_file);
    return has_times(&p, st) && reaches_checks(scene, st);
}
