/* SPDX-License-Identifier: MIT */
/* The points of a grid: values, names, cases, and the state of their directories. */
#include "study/sweep.h"

#include "base/alloc.h"
#include "base/hash.h"
#include "base/version.h"
#include "laws/law.h"
#include "out/dir.h"
#include "out/summary.h"
#include "out/summary_read.h"
#include "scene/write.h"
#include "study/run.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int tr_grid_value(const tr_grid *g, int point, int axis) {
    if (axis >= g->n_named) return 0;
    if (axis >= g->n_vary) return point / g->combinations;
    int rest = point % g->combinations;
    for (int i = g->n_vary - 1; i > axis; i--) rest /= g->axis[i].n;
    return rest % g->axis[axis].n;
}

int tr_grid_with(const tr_grid *g, int combination, int axis, int value) {
    int stride = 1;
    for (int i = axis + 1; i < g->n_vary; i++) stride *= g->axis[i].n;
    return combination + (value - tr_grid_value(g, combination, axis)) * stride;
}

/* "mu_r" of "contact.mu_r", if no other key that varies ends so. */
static const char *short_key(const tr_grid *g, int axis) {
    const char *key = g->axis[axis].key, *dot = strrchr(key, '.'), *end = dot ? dot + 1 : key;
    for (int i = 0; i < g->n_named; i++) {
        const char *other = g->axis[i].key, *d = strrchr(other, '.');
        if (i != axis && strcmp(d ? d + 1 : other, end) == 0) return key;
    }
    return end;
}

void tr_grid_name(const tr_grid *g, int point, char name[TR_POINT_NAME]) {
    enum { HASH = 9 };
    uint64_t hash = TR_HASH_BEGIN;
    size_t used = 0, room = TR_POINT_NAME - HASH - 1;
    bool exact = true;
    for (int i = 0; i < g->n_named; i++) {
        const char *part[] = {i ? "," : "", short_key(g, i), "=", g->axis[i].value[tr_grid_value(g, point, i)]};
        for (int k = 0; k < 4; k++) {
            for (const char *p = part[k]; *p; p++) {
                bool plain = strchr("+-._,=", *p) || (*p >= '0' && *p <= '9') || ((*p | 32) >= 'a' && (*p | 32) <= 'z');
                hash = tr_hash(hash, p, 1);
                exact = exact && plain && used < room;
                if (used < room) name[used++] = plain ? *p : '_';
            }
        }
    }
    name[used] = '\0';
    if (!exact) snprintf(name + used, HASH + 1, "-%08x", (unsigned)hash);
}

char **tr_grid_sets(const tr_grid *g, int point, tr_status *st) {
    char **sets = tr_alloc((size_t)g->n_axes, sizeof *sets, st);
    for (int i = 0; sets && i < g->n_axes; i++) {
        const tr_axis *axis = &g->axis[i];
        if (asprintf(&sets[i], "%s=%s", axis->key, axis->value[tr_grid_value(g, point, i)]) >= 0) continue;
        sets[i] = NULL;
        tr_grid_sets_free(g, sets);
        return tr_status_fail(st, TR_FILE, "error: out of memory"), NULL;
    }
    return sets;
}

void tr_grid_sets_free(const tr_grid *g, char **sets) {
    for (int i = 0; sets && i < g->n_axes; i++) free(sets[i]);
    free(sets);
}

/* The message is "--set:1:COLUMN: error: WHAT\nTHE SET\n..." if a value is wrong: then the place of the value is known.
 * Otherwise the base case does not fit these values, and the message points to the first of them. */
static bool blame(const tr_grid *g, int point, char *const *sets, const tr_status *inner, tr_status *st) {
    if (inner->code == TR_FILE) return tr_status_fail(st, inner->code, "%s", inner->text);
    char name[TR_POINT_NAME], first[sizeof inner->text];
    tr_grid_name(g, point, name);
    snprintf(first, sizeof first, "%s", inner->text);
    char *what = strtok(first, "\n"), *line = strtok(NULL, "\n");
    if (strncmp(what, "error: ", 7) == 0) what += 7;
    tr_mark mark = g->axis[0].mark[tr_grid_value(g, point, 0)];
    int column = 0, at = 0;
    if (line && sscanf(what, "--set:1:%d: error: %n", &column, &at) == 1 && at) {
        what += at;
        for (int i = 0; i < g->n_axes; i++) {
            if (strcmp(sets[i], line) != 0) continue;
            bool key = (size_t)column <= strlen(g->axis[i].key);
            mark = key ? g->axis[i].key_mark : g->axis[i].mark[tr_grid_value(g, point, i)];
        }
    }
    return tr_text_fail(st, mark, "point %d (%s) cannot run: %s", point, tr_text_show(name).text, what);
}

bool tr_grid_scene(const tr_grid *g, int point, tr_scene *scene, tr_status *st) {
    *scene = (tr_scene){0};
    char **sets = tr_grid_sets(g, point, st);
    if (!sets) return false;
    tr_status inner = {0};
    bool ok = tr_scene_read_file(scene, g->base, (const char *const *)sets, g->n_axes, tr_laws_catalog(), &inner);
    if (!ok) blame(g, point, sets, &inner, st);
    tr_grid_sets_free(g, sets);
    return ok;
}

bool tr_grid_scenes(const tr_grid *g, tr_status *st) {
    for (int axis = -1; axis < g->n_vary; axis++)
        for (int i = 0; i < (axis < 0 ? 1 : g->axis[axis].n); i++) {
            tr_scene scene;
            if (!tr_grid_scene(g, axis < 0 ? 0 : tr_grid_with(g, 0, axis, i), &scene, st)) return false;
            tr_scene_free(&scene);
        }
    return true;
}

static bool has_numbers(const tr_grid *g, const char *summary, tr_status *st) {
    tr_status inner = {0};
    double value;
    for (int k = 0; !inner.code && k < g->n_collect; k++) tr_summary_read(summary, g->collect[k], &value, &inner);
    if (inner.code == TR_FILE) return tr_status_fail(st, inner.code, "%s", inner.text);
    return !inner.code;
}

bool tr_grid_state(const tr_grid *g, int point, const char *dir, tr_point_state *state, tr_status *st) {
    char name[TR_POINT_NAME], path[TR_PATH], summary[TR_PATH];
    tr_scene scene;
    tr_grid_name(g, point, name);
    if (!tr_dir_path(path, dir, name, st) || !tr_dir_path(summary, path, "summary.json", st)) return false;
    if (!tr_grid_scene(g, point, &scene, st)) return false;
    char *text = tr_scene_write(&scene, tr_laws_catalog(), st), version[TR_SUMMARY_VERSION];
    bool ended = !access(summary, F_OK), same = false;
    bool known = text && tr_dir_holds(path, "case.yaml", text, &same, st) && tr_summary_version(summary, version, st);
    if (!known)
        *state = TR_POINT_MISSING; /* and a failure */
    else if (!ended)
        *state = same ? TR_POINT_BEGUN : TR_POINT_MISSING;
    else if (!same)
        *state = TR_POINT_OTHER;
    else if (!*version)
        *state = TR_POINT_BROKEN;
    else if (strcmp(version, TR_VERSION) != 0)
        *state = TR_POINT_OLD;
    else
        *state = has_numbers(g, summary, st) ? TR_POINT_FINISHED : TR_POINT_LACKING;
    free(text);
    tr_scene_free(&scene);
    return !st->code;
}

/* The names in the summaries, for the message about missing ones. */
typedef struct names {
    const char *wanted;
    bool found;
    tr_near near;
    char kept[TR_SUMMARY_NAME], list[240]; /* of the nearest; the first ones */
} names;

static void take_name(void *context, const char *name) {
    names *n = context;
    size_t used = strlen(n->list);
    const char *before = n->near.word;
    n->found |= strcmp(name, n->wanted) == 0;
    tr_text_nearer(&n->near, n->wanted, name);
    if (n->near.word != before) snprintf(n->kept, sizeof n->kept, "%s", name), n->near.word = n->kept;
    if (used && n->list[used - 1] == '.') return;
    bool fits = used + strlen(name) + sizeof ", , ..." < sizeof n->list;
    snprintf(n->list + used, sizeof n->list - used, "%s%s", used ? ", " : "", fits ? name : "...");
}

static bool check_collected(const tr_grid *g, int point, const char *summary, tr_status *st) {
    char name[TR_POINT_NAME];
    tr_grid_name(g, point, name);
    for (int k = 0; k < g->n_collect; k++) {
        names n = {.wanted = g->collect[k]};
        if (!tr_summary_numbers(summary, take_name, &n, st)) return false;
        if (n.found) continue;
        return tr_text_fail(st, g->collect_mark[k],
                            "no number `%s` will be in the summary.json of point %d (%s)%s; collect of: %s",
                            tr_text_show(g->collect[k]).text, point, tr_text_show(name).text,
                            tr_text_hint(&n.near).text, n.list);
    }
    return true;
}

bool tr_grid_check(const tr_grid *g, int point, tr_status *st) {
    tr_scene scene;
    tr_status inner = {0};
    tr_run_report notes; /* they are in the log of each point */
    char *summary = NULL;
    if (!tr_grid_scene(g, point, &scene, st)) return false;
    if (tr_run_check(&scene, &notes, &summary, &inner)) {
        check_collected(g, point, summary, st);
    } else {
        char **sets = tr_grid_sets(g, point, st);
        if (sets) blame(g, point, sets, &inner, st);
        tr_grid_sets_free(g, sets);
    }
    free(summary);
    tr_scene_free(&scene);
    return !st->code;
}
