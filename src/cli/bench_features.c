/* SPDX-License-Identifier: MIT */
/* trundle bench --features: the cost of each feature, and a test that a part that is left out costs nothing.
 *
 * The first scene has all: the case's normal, friction and rolling law, and the ledger. The others shear its packing
 * with less (features one at a time) or with another law in one slot (without ledger: to compare with `+ rolling`).
 * Frames are added by calculation: time of drawing one, over the steps between two frames of the case. */
#include "cli/bench_features.h"

#include "base/alloc.h"
#include "cli/bench_case.h"
#include "cli/open.h"
#include "draw/draw.h"
#include "laws/law.h"
#include "out/table.h"
#include "study/bench.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double BARE_AT_MOST = 0.75; /* of the time of the full scene */
static const double PART = 1.0 / 16;     /* of the shear: blocks so short that all scenes stay near the first packing */

enum { FULL, BARE, FRICTION, ROLLING, LAWS, MAX_ROWS = 32 };

typedef struct table {
    int n;
    char group[MAX_ROWS][16], name[MAX_ROWS][64];
    tr_scene scene[MAX_ROWS];
    tr_bench_report report[MAX_ROWS];
} table;

static int declared(const tr_scene *s) {
    int disks = tr_laws_normal[s->contact.normal.law]->n_hist,
        spins = tr_laws_friction[s->contact.friction.law]->n_hist + tr_laws_rolling[s->contact.rolling.law]->n_hist;
    return 2 * disks + (s->shear.walls ? 2 : 1) * spins; /* smooth walls have only the normal law */
}

static bool add(table *t, const tr_bench_arguments *a, const char *group, const char *name, const char *const *set,
                int n, tr_status *st) {
    tr_scene *scene = &t->scene[t->n];
    if (!tr_cli_bench_case(a, set, n, scene, st)) return false;
    scene->shear.strain_end *= PART;
    scene->output.energy = t->n == FULL;
    if (t->n != FULL) scene->output.frames = 0;
    snprintf(t->group[t->n], sizeof t->group[0], "%s", group);
    snprintf(t->name[t->n++], sizeof t->name[0], "%s", name);
    return true;
}

/* Every other law of this kind. If a law does not fit the case, the reader says why. */
static void add_laws(table *t, const tr_bench_arguments *a, const char *slot, const tr_law *const *laws, int n,
                     int given) {
    for (int i = 0; i < n; i++) {
        char law[64], *line;
        tr_status why = {0};
        if (i == given || !laws[i]->step) continue;
        snprintf(law, sizeof law, "contact.%s=%s", slot, laws[i]->table.name);
        if (t->n < MAX_ROWS && add(t, a, slot, laws[i]->table.name, (const char *const[]){law}, 1, &why)) continue;
        if ((line = strchr(why.text, '\n'))) *line = 0;
        line = strstr(why.text, "error: ");
        printf("without %s: %s\n", law, line ? line + strlen("error: ") : "too many laws");
    }
}

/* Creep by the rolling of Wang, beside his moment: the case of `make creep`. Skipped if the case has no E_star (see
 * above). */
static void add_wang_creep(table *t, const tr_bench_arguments *a) {
    static const char *const set[] = {"contact.friction=dahlberg-alfredsson", "contact.creep_roll=wang"};
    tr_status why = {0};
    if (t->n < MAX_ROWS) add(t, a, "friction", "dahlberg-alfredsson (wang)", set, 2, &why);
}

static bool fill(table *t, const tr_bench_arguments *a, tr_status *st) {
    static const char *const set[] = {"contact.rolling=none", "contact.friction=none"};
    const tr_scene_contact *c = &t->scene[FULL].contact;
    const tr_param_catalog *catalog = tr_laws_catalog();
    if (!add(t, a, "feature", "+ energy ledger", NULL, 0, st)) return false;
    const tr_law *friction = tr_laws_friction[c->friction.law], *rolling = tr_laws_rolling[c->rolling.law];
    if (!friction->step || !rolling->step)
        return tr_status_fail(st, TR_BAD_CASE, "error: --features needs a case with friction and rolling resistance");
    char name[3][64];
    snprintf(name[0], sizeof *name, "%s only", tr_laws_normal[c->normal.law]->table.name);
    snprintf(name[1], sizeof *name, "+ %s", friction->table.name);
    snprintf(name[2], sizeof *name, "+ %s", rolling->table.name);
    if (!add(t, a, "feature", name[0], set, 2, st) || !add(t, a, "feature", name[1], set, 1, st) ||
        !add(t, a, "feature", name[2], set, 0, st))
        return false;
    add_laws(t, a, "normal", tr_laws_normal, catalog->n_normal, c->normal.law);
    add_laws(t, a, "friction", tr_laws_friction, catalog->n_friction, c->friction.law);
    add_wang_creep(t, a);
    add_laws(t, a, "rolling", tr_laws_rolling, catalog->n_rolling, c->rolling.law);
    return true;
}

static void write_row(const char *group, const char *name, const tr_bench_report *r, FILE *csv) {
    char quartiles[32];
    snprintf(quartiles, sizeof quartiles, "%.1f to %.1f", r->ns.low, r->ns.high);
    printf("%-9s %-30s %6.1f %16s %6.2f %9.2f %11.0f %7d\n", group, name, r->ns.median, quartiles, r->share.median,
           r->us_per_step, r->bytes_per_disk, r->histories);
    const double number[] = {r->ns.median,   r->ns.low,   r->ns.high,        r->share.median,
                             r->us_per_step, r->touching, r->bytes_per_disk, r->histories};
    if (!csv) return;
    fprintf(csv, "%s,%s", group, name);
    for (size_t i = 0; i < sizeof number / sizeof *number; i++) putc(',', csv), tr_cell_put(csv, number[i], 6);
    putc('\n', csv);
}

/* The full scene with its frames. */
static void write_frames(const table *t, FILE *csv) {
    const tr_scene *scene = &t->scene[FULL];
    tr_bench_report r = t->report[FULL];
    char name[64];
    if (!scene->output.frames) return;
    double steps = r.steps / PART / scene->output.frames, per_contact = 1e9 / (steps * r.touching);
    r.share.median *= 1 + r.frame.median * per_contact / r.ns.median;
    r.ns.low += r.frame.low * per_contact;
    r.ns.median += r.frame.median * per_contact;
    r.ns.high += r.frame.high * per_contact;
    r.us_per_step += 1e6 * r.frame.median / steps;
    r.bytes_per_disk += 4.0 * TR_FRAME_WIDTH * TR_FRAME_HEIGHT / scene->sample.disks;
    snprintf(name, sizeof name, "+ a frame every %.0f steps", steps);
    write_row("feature", name, &r, csv);
}

static void write_all(const table *t, FILE *csv) {
    static const int order[] = {BARE, FRICTION, ROLLING, FULL};
    printf("%d disks, %.0f touching of %.0f listed contacts: the same packing for %d scenes in turn\n",
           t->scene[FULL].sample.disks, t->report[FULL].touching, t->report[FULL].listed, t->n);
    printf("%40s %6s %16s %6s %9s %11s %7s\n", "", "ns per", "", "share", "us per", "bytes per", "history");
    printf("%40s %6s %16s %6s %9s %11s %7s\n", "", "contact", "quartiles", "of full", "step", "disk", "arrays");
    if (csv)
        fputs("group,name,ns_per_contact,lower_quartile,upper_quartile,share_of_full,us_per_step,touching_contacts,"
              "bytes_per_disk,history_arrays\n",
              csv);
    for (int k = 0; k < LAWS; k++) write_row(t->group[order[k]], t->name[order[k]], &t->report[order[k]], csv);
    write_frames(t, csv);
    for (int i = LAWS; i < t->n; i++) write_row(t->group[i], t->name[i], &t->report[i], csv);
}

/* The full scene has the ledger's arrays too: tests/core/test_histories.c. */
static bool check(const table *t, tr_status *st) {
    double share = t->report[BARE].share.median;
    int unused = 0;
    for (int i = BARE; i < t->n; i++) unused += t->report[i].histories != declared(&t->scene[i]);
    printf("%s: a bare scene takes %.2f of the time of the full one, allowed %.2f\n",
           share <= BARE_AT_MOST ? "ok" : "FAILED", share, BARE_AT_MOST);
    printf("%s: no history array but those that the laws of the scene declare\n", unused ? "FAILED" : "ok");
    if (share <= BARE_AT_MOST && !unused) return true;
    return tr_status_fail(st, TR_CHECK_FAILED, "error: parts that the scene leaves out cost too much");
}

bool tr_cli_bench_features(const tr_bench_arguments *a, tr_status *st) {
    table *t = tr_alloc(1, sizeof *t, st);
    const tr_scene *scene[MAX_ROWS];
    tr_file csv = {0};
    bool ok = t && (!a->out || tr_cli_open(&csv, a->out, a->file, st)) && fill(t, a, st);
    for (int i = 0; ok && i < t->n; i++) scene[i] = &t->scene[i];
    ok = ok && tr_bench(scene, t->n, a->threads, false, t->report, st);
    if (ok) write_all(t, csv.stream);
    ok = ok && (!a->out || tr_file_commit(&csv, st)) && check(t, st);
    tr_file_discard(&csv);
    for (int i = 0; t && i < t->n; i++) tr_scene_free(&t->scene[i]);
    free(t);
    return ok;
}
