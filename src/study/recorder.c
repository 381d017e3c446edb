/* SPDX-License-Identifier: MIT */
#include "study/recorder.h"

#include "core/record.h"
#include "out/table.h"
#include "scene/contact_name.h"
#include "study/schedule.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double TOLERANCE = 1.0 / 500;
enum { P = 2, CHANNELS = TR_PATH_CHANNELS };

bool tr_recorder_wants_most(const tr_scene *scene) {
    const tr_contact_ids *picks = &scene->output.paths;
    for (int k = 0; k < picks->n; k++)
        if (picks->item[k].a == picks->item[k].b) return true;
    return false;
}

tr_contact_id tr_recorder_most(tr_world *world, tr_status *st) {
    tr_record *records = NULL;
    int capacity = 0, n = tr_record_all(world, &records, &capacity, st);
    tr_contact_id most = {0};
    double largest = 0;
    for (int i = 0; i < n; i++)
        if (records[i].mobilisation > largest)
            largest = records[i].mobilisation, most = (tr_contact_id){records[i].a, records[i].b};
    free(records);
    return most;
}

bool tr_recorder_open(tr_recorder *r, const tr_recording *of, tr_run_report *report, tr_status *st) {
    const tr_scene *scene = of->scene;
    tr_world *world = of->world;
    const tr_contact_ids *picks = &scene->output.paths;
    bool (*open)(tr_file *, const char *, const char *, tr_status *) = of->resume ? tr_file_reopen : tr_file_open;
    *r = (tr_recorder){.shape = scene->shape, .total = of->total, .world = world, .dt = world->dt, .report = report};
    r->n_rows = scene->output.path_rows > of->total ? (int)of->total + 1 : scene->output.path_rows;
    r->paths.all = r->n_rows > 0;
    if (r->paths.all && !open(&r->all, of->dir, "paths.csv", st)) return false;
    if (picks->n && !tr_dir_make(of->dir, "paths", st)) return false;
    for (int k = 0; k < picks->n; k++) {
        tr_contact_id pick = picks->item[k];
        char name[TR_CONTACT_NAME], file[TR_CONTACT_NAME + 16];
        tr_contact_name_write(pick, name);
        snprintf(file, sizeof file, "paths/%s%s.csv", of->prefix, name);
        if (pick.a == pick.b) {
            pick = of->most;
            tr_contact_name_write(pick, name);
            if (pick.a == pick.b) {
                tr_run_note(report, "no path of most-mobilised: no contact has friction at the end");
                continue;
            }
            tr_run_note(report, "most-mobilised is %s; the case was run twice to find it", name);
        }
        int n = r->paths.contacts.n;
        if (!open(&r->item[n].file, of->dir, file, st)) return false;
        r->paths.contacts.item[r->paths.contacts.n++] = pick;
    }
    if (picks->n || r->paths.all) tr_paths_attach(world, &r->paths);
    return true;
}

void tr_recorder_checkpoint(tr_recorder *r, tr_checkpoint *c) {
    TR_KEEP(c, &r->steps, 1);
    TR_KEEP_NUMBERS(c, r->paths.now, r->paths.contacts.n);
    for (int k = 0; k < r->paths.contacts.n; k++) {
        struct tr_recorded *item = &r->item[k];
        TR_KEEP(c, item->row, CHANNELS);
        TR_KEEP(c, item->before, CHANNELS);
        TR_KEEP(c, item->low, CHANNELS);
        TR_KEEP(c, item->high, CHANNELS);
        TR_KEEP(c, &item->row_step, 1);
        TR_KEEP(c, &item->touched, 1);
        tr_file_checkpoint(&item->file, c);
    }
    TR_KEEP(c, &r->rows, 1);
    TR_KEEP(c, &r->paths.lives, 1);
    TR_KEEP(c, &r->paths.taken, 1);
    tr_checkpoint_check(c, tr_run_is_between(r->rows, r->n_rows, r->steps, r->total), "a number of rows");
    tr_checkpoint_check(c, r->paths.taken <= r->paths.lives, "a number of lives");
    tr_file_checkpoint(&r->all, c);
}

static bool write_point(const tr_recorder *r, struct tr_recorded *c, int64_t step, const double now[CHANNELS],
                        tr_status *st) {
    tr_row row = {.shape = r->shape};
    tr_row_add(&row, now[0] + 0.0, "u_slide_m"); /* a zero has no sign in a table */
    tr_row_add(&row, now[1] + 0.0, "u_roll_m");
    tr_row_add(&row, now[2], "P_N_per_m|P_N");
    tr_row_add(&row, (double)step * r->dt, "time_s");
    tr_row_add(&row, now[3] + 0.0, "Q_N_per_m|Q_N");
    memcpy(c->row, now, sizeof c->row);
    c->row_step = step;
    return tr_row_write_exact(&row, &c->file, st);
}

static bool is_far(const struct tr_recorded *c, const double now[CHANNELS]) {
    bool far = false;
    for (int i = 0; i < CHANNELS; i++) far |= fabs(now[i] - c->row[i]) > TOLERANCE * (c->high[i] - c->low[i]);
    return far;
}

static bool look(const tr_recorder *r, struct tr_recorded *c, tr_path_point point, tr_status *st) {
    const double now[CHANNELS] = {point.u_slide, point.u_roll, point.P, point.Q};
    bool first = r->steps == 1, turns = (now[P] > 0) != (c->before[P] > 0);
    bool leaves = turns || is_far(c, now) || is_far(c, c->before); /* the latter: a jump in the step after a row */
    for (int i = 0; i < CHANNELS; i++) c->low[i] = fmin(c->low[i], now[i]), c->high[i] = fmax(c->high[i], now[i]);
    c->touched |= now[P] > 0;
    if (leaves && !first && c->row_step < r->steps - 1 && !write_point(r, c, r->steps - 1, c->before, st)) return false;
    memcpy(c->before, now, sizeof now);
    return !(first || turns) || write_point(r, c, r->steps, now, st);
}

/* One instant of paths.csv. Nine digits: the sums of a whole life are then good to 1e-9 of the largest part. */
static bool write_all(tr_recorder *r, tr_status *st) {
    FILE *out = r->all.stream;
    const char *force = r->shape == TR_SHAPE_SPHERE ? "N" : "N_per_m";
    if (!r->rows++)
        fprintf(out, "time_s,life,a,b,R1_m,R2_m,du_slide_m,du_roll_m,P_%s,Q_%s,f_n_%s,branch_x_m,branch_y_m\n", force,
                force, force);
    for (int k = 0; k < r->world->n_groups; k++) {
        tr_group *g = &r->world->group[k];
        for (int i = 0; i < g->n; i++) {
            tr_path_life c;
            if (!tr_paths_life(g, i, &c)) continue;
            const double number[] = {c.R1, c.R2, c.slide + 0.0, c.roll + 0.0, c.P, c.Q + 0.0, c.f_n, c.x, c.y};
            fprintf(out, "%.9g,%.0f,%d,%d", (double)(r->steps - 1) * r->dt, c.life, c.a, c.b);
            for (size_t n = 0; n < sizeof number / sizeof *number; n++) putc(',', out), tr_cell_put(out, number[n], 9);
            putc('\n', out);
        }
    }
    return tr_file_check(&r->all, st);
}

bool tr_recorder_step(tr_recorder *r, tr_status *st) {
    r->steps++;
    bool ok = true;
    if (r->paths.all && tr_run_is_due(r->rows, r->n_rows, r->steps - 1, r->total)) ok = write_all(r, st);
    for (int k = 0; ok && k < r->paths.contacts.n; k++) ok = look(r, &r->item[k], tr_paths_take(&r->paths, k), st);
    return ok;
}

tr_path_point tr_recorder_now(const tr_recorder *r, int k) {
    const double *now = r->item[k].before;
    return (tr_path_point){now[0], now[1], now[2], now[3]};
}

void tr_recorder_close(tr_recorder *r, tr_status *st) {
    char apart[160] = "";
    if (r->rows && r->all.stream) /* one that could not be written is already gone */
        r->bytes = ftell(r->all.stream), tr_file_commit(&r->all, st);
    else
        tr_file_discard(&r->all);
    if (r->rows && r->paths.taken < r->paths.lives)
        tr_run_note(r->report, "paths.csv has %lld contacts, of %lld; the others touched only between two instants",
                    (long long)r->paths.taken, (long long)r->paths.lives);
    for (int k = 0; k < r->paths.contacts.n; k++) {
        struct tr_recorded *c = &r->item[k];
        char name[TR_CONTACT_NAME];
        tr_contact_name_write(r->paths.contacts.item[k], name);
        size_t used = strlen(apart);
        if (!c->touched) snprintf(apart + used, sizeof apart - used, " %s", name);
        bool whole =
            c->file.stream && r->steps && (c->row_step == r->steps || write_point(r, c, r->steps, c->before, st));
        if (whole)
            tr_file_commit(&c->file, st);
        else
            tr_file_discard(&c->file);
    }
    if (*apart && r->steps) tr_run_note(r->report, "paths of contacts that never touched:%s", apart);
}
