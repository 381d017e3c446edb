/* SPDX-License-Identifier: MIT */
#include "study/convert_frames.h"

#include "base/alloc.h"
#include "laws/law.h"
#include "out/dir.h"
#include "out/summary_read.h"
#include "scene/scene.h"
#include "study/csv.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- tables in: columns by name, each a double of the struct, or its whole number */

typedef struct field {
    const char *name;
    size_t offset;
    bool whole;
} field;

#define DISK(name, field)                                                                                              \
    { name, offsetof(tr_frame_disk, field), false }
#define CONTACT(name, field)                                                                                           \
    { name, offsetof(tr_frame_contact, field), false }
static const field disk_fields[] = {DISK("time_s", time),     {"disk", offsetof(tr_frame_disk, disk), true},
                                    DISK("x_m", x),           DISK("y_m", y),
                                    DISK("angle_rad", angle), DISK("vx_m_per_s", vx),
                                    DISK("vy_m_per_s", vy),   DISK("spin_rad_per_s", spin),
                                    DISK("radius_m", radius)}; /* the last: history.csv has none */
static const field contact_fields[] = {CONTACT("time_s", time),
                                       {"a", offsetof(tr_frame_contact, a), true},
                                       {"b", offsetof(tr_frame_contact, b), true},
                                       CONTACT("x_m", x),
                                       CONTACT("y_m", y),
                                       CONTACT("nx", nx),
                                       CONTACT("ny", ny),
                                       CONTACT("overlap_m", overlap),
                                       CONTACT("v_s_m_per_s", v_s),
                                       CONTACT("v_r_m_per_s", v_r),
                                       CONTACT("f_n_N_per_m", f_n), /* names by shape from here */
                                       CONTACT("f_t_N_per_m", f_t),
                                       CONTACT("moment_a_N", moment_a),
                                       CONTACT("moment_b_N", moment_b)};
static const char *const of_spheres[] = {"f_n_N", "f_t_N", "moment_a_N_m", "moment_b_N_m"};
enum {
    DISK_FIELDS = sizeof disk_fields / sizeof *disk_fields,
    CONTACT_FIELDS = sizeof contact_fields / sizeof *contact_fields,
    BY_SHAPE = CONTACT_FIELDS - 4,
    MOST_FIELDS = CONTACT_FIELDS > DISK_FIELDS ? CONTACT_FIELDS : DISK_FIELDS
};

typedef struct table {
    const field *fields;
    const char *columns[MOST_FIELDS];
    size_t size;
    char *rows; /* owned by the frames */
    int n, capacity;
} table;

static bool cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    table *t = context;
    double v;
    (void)length;
    if (!tr_csv_number(csv, t->columns[column], text, false, &v)) return false;
    if (t->n == t->capacity) {
        int more = t->capacity ? 2 * t->capacity : 1024;
        if (!tr_alloc_grow(&t->rows, (size_t)t->n, (size_t)more, t->size, csv->st)) return false;
        t->capacity = more;
    }
    char *to = t->rows + (size_t)t->n * t->size + t->fields[column].offset;
    if (!t->fields[column].whole) return memcpy(to, &v, sizeof v), true;
    if (v != floor(v) || fabs(v) > 1e8)
        return tr_csv_fail(csv, csv->line, "%s is %s: it must be a whole number", t->columns[column], text);
    int whole = (int)v;
    memcpy(to, &whole, sizeof whole);
    return true;
}

static bool row(void *context, tr_csv *csv) {
    table *t = context;
    (void)csv;
    t->n++;
    return true;
}

static bool read_table(table *t, const char *run, const char *name, int n, tr_status *st) {
    char path[TR_PATH];
    const tr_csv_format format = {t->columns, n, n, "time_s,...", NULL, cell, row};
    return tr_dir_path(path, run, name, st) && tr_csv_read(path, &format, t, st);
}

static bool is_there(const char *run, const char *name, tr_status *st) {
    char path[TR_PATH];
    return tr_dir_path(path, run, name, st) && access(path, F_OK) == 0;
}

/* ---- the run */

static bool check_run(const char *run, tr_scene *scene, tr_status *st) {
    char path[TR_PATH];
    if (!is_there(run, "summary.json", st))
        return tr_status_fail(st, TR_BAD_CASE,
                              "error: %s is not the directory of a finished run: it has no summary.json", run);
    if (!tr_dir_path(path, run, "case.yaml", st) || !tr_scene_read_file(scene, path, NULL, 0, tr_laws_catalog(), st))
        return false;
    if (scene->kind != TR_KIND_BIAXIAL && scene->kind != TR_KIND_BODIES)
        return tr_status_fail(st, TR_BAD_CASE,
                              "error: %s is one contact along a path; disks are in runs of kind biaxial and bodies",
                              run);
    if (scene->n_more)
        return tr_status_fail(st, TR_BAD_CASE, "error: the case of %s has %d documents: run the one to convert alone",
                              run, scene->n_more + 1);
    return true;
}

/* Radii of kind bodies are those of the case. */
static bool give_radii(tr_frames *f, const tr_scene *scene, const char *run, tr_status *st) {
    for (int i = 0; i < f->n_disks; i++) {
        int k = f->disk[i].disk;
        if (k < 0 || k >= scene->n_disks)
            return tr_status_fail(st, TR_BAD_CASE, "error: %s/history.csv has a disk %d, case.yaml has 0 to %d", run, k,
                                  scene->n_disks - 1);
        f->disk[i].radius = scene->disks[k].radius;
    }
    return true;
}

static bool read_disks(tr_frames *f, const tr_scene *scene, const char *run, tr_status *st) {
    bool biaxial = scene->kind == TR_KIND_BIAXIAL;
    table t = {.fields = disk_fields, .size = sizeof(tr_frame_disk)};
    for (int k = 0; k < DISK_FIELDS; k++) t.columns[k] = disk_fields[k].name;
    bool ok = read_table(&t, run, biaxial ? "disks.csv" : "history.csv", biaxial ? DISK_FIELDS : DISK_FIELDS - 1, st);
    f->disk = (tr_frame_disk *)(void *)t.rows, f->n_disks = t.n;
    if (ok && !t.n)
        ok =
            tr_status_fail(st, TR_BAD_CASE, "error: %s has no row of a disk: run it with output.contacts above 0", run);
    return ok && (biaxial || give_radii(f, scene, run, st));
}

static bool read_contacts(tr_frames *f, const tr_scene *scene, const char *run, tr_status *st) {
    table t = {.fields = contact_fields, .size = sizeof(tr_frame_contact)};
    if (!is_there(run, "contacts.csv", st)) return !st->code; /* output.contacts was 0 */
    for (int k = 0; k < CONTACT_FIELDS; k++)
        t.columns[k] =
            scene->shape == TR_SHAPE_SPHERE && k >= BY_SHAPE ? of_spheres[k - BY_SHAPE] : contact_fields[k].name;
    bool ok = read_table(&t, run, "contacts.csv", CONTACT_FIELDS, st);
    f->contact = (tr_frame_contact *)(void *)t.rows, f->n_contacts = t.n;
    return ok;
}

/* ---- instants */

static void set_box(tr_frame_at *at) {
    at->box[0][0] = at->box[1][0] = INFINITY, at->box[0][1] = at->box[1][1] = -INFINITY;
    for (int i = 0; i < at->n; i++) {
        const double c[2] = {at->disk[i].x, at->disk[i].y}, R = at->disk[i].radius;
        for (int k = 0; k < 2; k++)
            at->box[k][0] = fmin(at->box[k][0], c[k] - R), at->box[k][1] = fmax(at->box[k][1], c[k] + R);
    }
}

static bool split(tr_frames *f, const char *run, tr_status *st) {
    int n = 0;
    for (int i = 0; i < f->n_disks; i++) n += i == 0 || f->disk[i].time != f->disk[i - 1].time;
    if (!(f->frame = tr_alloc((size_t)n, sizeof *f->frame, st))) return false;
    for (int i = 0, c = 0; i < f->n_disks;) {
        tr_frame_at *at = &f->frame[f->n++];
        *at = (tr_frame_at){.time = f->disk[i].time, .disk = &f->disk[i]};
        for (; i < f->n_disks && f->disk[i].time == at->time; i++, at->n++)
            if (f->disk[i].disk != at->n)
                return tr_status_fail(st, TR_BAD_CASE, "error: %s: at time %.9g s disk %d comes where %d is expected",
                                      run, at->time, f->disk[i].disk, at->n);
        while (c < f->n_contacts && f->contact[c].time < at->time) c++;
        for (at->contact = &f->contact[c]; c < f->n_contacts && f->contact[c].time == at->time; c++, at->n_contacts++)
            if (f->contact[c].b < 0 || f->contact[c].b >= at->n || f->contact[c].a >= at->n)
                return tr_status_fail(st, TR_BAD_CASE, "error: %s/contacts.csv: no such contact: %d and %d", run,
                                      f->contact[c].a, f->contact[c].b);
        set_box(at);
    }
    return true;
}

typedef struct sides {
    tr_frames *f;
    int k;          /* instants that have theirs */
    double cell[3]; /* time, width, height */
} sides;
static const char *const side_columns[] = {"time_s", "width_m", "height_m"};

static bool side_cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    sides *s = context;
    (void)length;
    return tr_csv_number(csv, side_columns[column], text, false, &s->cell[column]);
}

/* Into the cell: a run moves disks there now and then alone. */
static void wrap(tr_frames *f, tr_frame_at *at) {
    tr_frame_disk *disk = &f->disk[at->disk - f->disk];
    const double width = at->box[0][1] - at->box[0][0], height = at->box[1][1] - at->box[1][0];
    for (int i = 0; i < at->n; i++)
        disk[i].x -= width * rint(disk[i].x / width), disk[i].y -= height * rint(disk[i].y / height);
}

/* A periodic cell lies about the origin. Its sides are those of the first row of history.csv that is not before. */
static bool side_row(void *context, tr_csv *csv) {
    sides *s = context;
    (void)csv;
    for (; s->k < s->f->n && s->f->frame[s->k].time <= s->cell[0] * (1 + 1e-8); s->k++) {
        tr_frame_at *at = &s->f->frame[s->k];
        for (int axis = 0; axis < 2; axis++)
            at->box[axis][0] = -0.5 * s->cell[1 + axis], at->box[axis][1] = 0.5 * s->cell[1 + axis];
        wrap(s->f, at);
    }
    return true;
}

static bool read_sides(tr_frames *f, const char *run, tr_status *st) {
    char path[TR_PATH];
    sides s = {.f = f};
    const tr_csv_format format = {side_columns, 3, 3, "strain,...", NULL, side_cell, side_row};
    return tr_dir_path(path, run, "history.csv", st) && tr_csv_read(path, &format, &s, st);
}

bool tr_frames_read(tr_frames *f, const char *run, tr_status *st) {
    tr_scene scene = {.kind = TR_KIND_BODIES};
    *f = (tr_frames){.n = 0};
    bool ok = check_run(run, &scene, st) && read_disks(f, &scene, run, st) && read_contacts(f, &scene, run, st) &&
              split(f, run, st);
    f->periodic = scene.kind == TR_KIND_BIAXIAL && scene.boundary == TR_PERIODIC;
    ok = ok && (!f->periodic || read_sides(f, run, st));
    tr_scene_free(&scene);
    return ok;
}

void tr_frames_free(tr_frames *f) {
    free(f->frame), free(f->disk), free(f->contact);
    *f = (tr_frames){.n = 0};
}
