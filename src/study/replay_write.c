/* SPDX-License-Identifier: MIT */
/* The tables of a replay. All sums run in the order of the lives. */
#include "study/replay_write.h"
#include "base/math.h"

#include "base/alloc.h"
#include "base/quantile.h"
#include "laws/law.h"
#include "out/table.h"
#include "study/report.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static double force_error(const tr_replay *r, int i, int law) {
    const double *Q = r->Q + (size_t)i * (size_t)r->n_columns;
    double bound = r->mu * r->row[i].P;
    return bound > 0 ? (Q[law] - Q[TR_REPLAY_EXACT]) / bound : 0;
}

static double mobilisation(const tr_replay *r, int i) {
    double bound = r->mu * r->row[i].P;
    return bound > 0 ? fabs(r->Q[(size_t)i * (size_t)r->n_columns]) / bound : 0;
}

static double largest_mobilisation(const tr_replay *r, const tr_replay_life *life) {
    double largest = 0;
    for (int i = life->first; i < life->first + life->n; i++) largest = fmax(largest, mobilisation(r, i));
    return largest;
}

static double energy_error(const tr_replay_life *life, int law) {
    return life->full > 0 ? (life->work[law] - life->work[TR_REPLAY_EXACT]) / life->full : 0;
}

/* ---- replay.csv */

static void life_row(const tr_replay *r, const tr_replay_life *life, tr_row *cells) {
    const tr_replay_row *first = &r->row[life->first], *last = first + life->n - 1;
    tr_row_add(cells, first->a, "a");
    tr_row_add(cells, first->b, "b");
    tr_row_add(cells, first->time, "from_s");
    tr_row_add(cells, last->time, "to_s");
    tr_row_add(cells, life->n, "rows");
    tr_row_add(cells, life->rolled, "rolled_a");
    tr_row_add(cells, largest_mobilisation(r, life), "mobilisation_max");
    tr_row_add(cells, life->full, "full_slip_J_per_m");
    for (int k = 0; k < r->n_columns; k++) {
        double squares = 0, largest = 0;
        for (int i = life->first; i < life->first + life->n; i++) {
            double e = force_error(r, i, k);
            squares += e * e, largest = fmax(largest, fabs(e));
        }
        tr_row_add(cells, life->work[k], "%s_J_per_m", r->name[k]);
        if (k == TR_REPLAY_EXACT) continue;
        tr_row_add(cells, force_error(r, life->first + life->n - 1, k), "%s_end", r->name[k]);
        tr_row_add(cells, sqrt(squares / life->n), "%s_rms", r->name[k]);
        tr_row_add(cells, largest, "%s_max", r->name[k]);
    }
}

static bool write_lives(const tr_replay *r, const char *dir, tr_status *st) {
    tr_file file = {0};
    bool ok = tr_file_open(&file, dir, "replay.csv", st);
    for (int k = 0; ok && k < r->n_lives; k++) {
        tr_row cells = {0};
        if (!r->life[k].done) continue;
        life_row(r, &r->life[k], &cells);
        ok = tr_row_write(&cells, &file, st);
    }
    if (ok) return tr_file_commit(&file, st);
    tr_file_discard(&file);
    return false;
}

/* ---- replay-errors.csv */

/* The quantity that errors are sorted by, and the ends of the classes, each with its upper end. */
static const struct classes {
    const char *name;
    int n;
    double end[8];
} classes[] = {{"all", 1, {-INFINITY, INFINITY}},
               {"mobilisation", 6, {-INFINITY, 0.2, 0.4, 0.6, 0.8, 0.99, INFINITY}},
               {"rolled_a", 6, {-INFINITY, 0.03, 0.1, 0.3, 1, 3, INFINITY}}};
enum { N_CLASSES = sizeof classes / sizeof *classes };

typedef struct sample {
    int n;
    double *e; /* |error| */
    double sum, squares;
} sample;

static void add(sample *s, double e) {
    s->e[s->n++] = fabs(e);
    s->sum += e, s->squares += e * e;
}

static bool is_in(const struct classes *c, int k, double value) {
    return value > c->end[k] && value <= c->end[k + 1];
}

/* Which errors, of which law: of_rows: of force at rows, else of energy of lives; those in class k of classes[by]. */
typedef struct wanted {
    bool of_rows;
    int law, by, k;
} wanted;

static void collect(const tr_replay *r, wanted of, sample *s) {
    const struct classes *c = &classes[of.by];
    const bool of_rows = of.of_rows;
    s->n = 0, s->sum = s->squares = 0;
    for (int i = 0; i < (of_rows ? r->n_rows : r->n_lives); i++) {
        const tr_replay_life *life = &r->life[of_rows ? r->row[i].life : i];
        if (!life->done || (of_rows ? !(r->row[i].P > 0) : !(life->full > 0))) continue;
        double rolled = of_rows ? r->rolled[i] : life->rolled;
        double at = !of.by ? 0 : of.by == 2 ? rolled : of_rows ? mobilisation(r, i) : largest_mobilisation(r, life);
        if (is_in(c, of.k, at)) add(s, of_rows ? force_error(r, i, of.law) : energy_error(life, of.law));
    }
    tr_sort(s->e, s->n);
}

static bool write_class(const tr_replay *r, wanted of, sample *s, tr_file *file, tr_status *st) {
    const double shares[] = {0.5, 0.75, 0.9, 0.99, 1};
    const struct classes *c = &classes[of.by];
    collect(r, of, s);
    if (ftell(file->stream) == 0)
        fputs("error_of,law,by,above,up_to,n,mean,rms,median,q75,q90,q99,max\n", file->stream);
    if (!s->n) return true;
    double number[7] = {s->sum / s->n, sqrt(s->squares / s->n)};
    for (int i = 0; i < 5; i++) number[2 + i] = tr_quantile(s->e, s->n, shares[i]);
    fprintf(file->stream, "%s,%s,%s,%g,%g,%d", of.of_rows ? "force" : "energy", r->name[of.law], c->name,
            c->end[of.k], c->end[of.k + 1], s->n);
    for (int i = 0; i < 7; i++) putc(',', file->stream), tr_cell_put(file->stream, number[i], 6);
    fputc('\n', file->stream);
    return tr_file_check(file, st);
}

static void report_law(const tr_replay *r, int law, sample *s, tr_run_report *report) {
    double work = 0, exact = 0;
    for (int k = 0; k < r->n_lives; k++) {
        if (!r->life[k].done) continue;
        work += r->life[k].work[law], exact += r->life[k].work[TR_REPLAY_EXACT];
    }
    collect(r, (wanted){.of_rows = true, .law = law}, s);
    if (!s->n || exact == 0)
        tr_run_say(report, r->name[law], "no contact does work by friction");
    else
        tr_run_say(report, r->name[law], "error/(mu P): median %.4f, 90 %% %.4f, 99 %% %.4f; energy %+.2f %%",
                   tr_quantile(s->e, s->n, 0.5), tr_quantile(s->e, s->n, 0.9), tr_quantile(s->e, s->n, 0.99),
                   100 * (work / exact - 1));
}

static bool write_errors(const tr_replay *r, const char *dir, tr_run_report *report, tr_status *st) {
    tr_file file = {0};
    sample s = {.e = tr_alloc((size_t)r->n_rows, sizeof(double), st)};
    bool ok = s.e && tr_file_open(&file, dir, "replay-errors.csv", st);
    for (int of_rows = 1; of_rows >= 0; of_rows--)
        for (int law = TR_REPLAY_OWN; law < r->n_columns; law++)
            for (int by = 0; by < N_CLASSES; by++)
                for (int k = 0; ok && k < classes[by].n; k++)
                    ok = write_class(r, (wanted){of_rows, law, by, k}, &s, &file, st);
    for (int law = TR_REPLAY_OWN; ok && law < r->n_columns; law++) report_law(r, law, &s, report);
    free(s.e);
    if (ok) return tr_file_commit(&file, st);
    tr_file_discard(&file);
    return false;
}

/* ---- replay-stress.csv */

/* Of an instant: area times stress, of the normal forces, then of the friction of each column. */
typedef struct stress {
    double time, normal[2], friction[TR_REPLAY_LAWS][2]; /* xx, yy */
    int contacts;
} stress;

static void add_contact(const tr_replay *r, int i, stress *s) {
    const tr_replay_row *c = &r->row[i];
    double length = tr_hypot(c->x, c->y), nx = c->x / length, ny = c->y / length;
    s->time = c->time, s->contacts++;
    s->normal[0] += c->f_n * nx * c->x, s->normal[1] += c->f_n * ny * c->y;
    for (int k = 0; k < r->n_columns; k++) {
        double Q = r->life[c->life].done ? r->Q[(size_t)i * (size_t)r->n_columns + (size_t)k] : c->Q;
        s->friction[k][0] -= Q * ny * c->x, s->friction[k][1] += Q * nx * c->y; /* t = (n_y, -n_x) */
    }
}

/* NaN without normal forces. */
static double sin_phi(const stress *s, int k) {
    double xx = s->normal[0] + s->friction[k][0], yy = s->normal[1] + s->friction[k][1];
    return (yy - xx) / (yy + xx);
}

static void report_stress(const tr_replay *r, const stress *s, tr_run_report *report) {
    int from = r->n_instants * 3 / 4;
    for (int k = 0; k < r->n_columns; k++) {
        double sum = 0, change = 0;
        int n = 0;
        for (int i = from; i < r->n_instants; i++) {
            double phi = sin_phi(&s[i], k), d = phi - sin_phi(&s[i], TR_REPLAY_EXACT);
            if (isfinite(d)) sum += phi, change += d * d, n++;
        }
        char label[40];
        if (!n) continue;
        snprintf(label, sizeof label, "sin phi, %.24s", r->name[k]);
        tr_run_say(report, label, "%.4f over the last quarter; rms from exact %.4f", sum / n, sqrt(change / n));
    }
}

/* The speed grows as 3 x^2 - 2 x^3 of x = time/start; before that, its integral. */
static double strain_at(const tr_replay *r, double time) {
    double x = r->start > 0 ? fmin(1, time / r->start) : 1;
    return r->rate * (r->start * x * x * x * (1 - 0.5 * x) + fmax(0, time - r->start));
}

static bool write_stress(const tr_replay *r, const char *dir, tr_run_report *report, tr_status *st) {
    tr_file file = {0};
    stress *s = tr_alloc((size_t)r->n_instants, sizeof *s, st);
    bool ok = s && tr_file_open(&file, dir, "replay-stress.csv", st);
    for (int i = 0; ok && i < r->n_rows; i++) add_contact(r, i, &s[r->row[i].instant]);
    for (int i = 0; ok && i < r->n_instants; i++) {
        tr_row cells = {0};
        tr_row_add(&cells, s[i].time, "time_s");
        tr_row_add(&cells, strain_at(r, s[i].time), "strain");
        tr_row_add(&cells, s[i].contacts, "contacts");
        for (int k = 0; k < r->n_columns; k++) tr_row_add(&cells, sin_phi(&s[i], k), "sin_phi_%s", r->name[k]);
        ok = tr_row_write(&cells, &file, st);
    }
    if (ok) report_stress(r, s, report);
    free(s);
    if (ok) return tr_file_commit(&file, st);
    tr_file_discard(&file);
    return false;
}

bool tr_replay_write(const tr_replay *r, const tr_replay_options *o, tr_run_report *report, tr_status *st) {
    int lock;
    if (!tr_dir_lock(o->dir, &lock, st)) return false;
    bool ok = write_lives(r, o->dir, st) && write_errors(r, o->dir, report, st) &&
              (o->every > 1 || write_stress(r, o->dir, report, st));
    close(lock);
    return ok;
}
