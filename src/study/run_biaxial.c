/* SPDX-License-Identifier: MIT */
/* A biaxial test with its outputs: compaction, shear, summary, curves; and its checkpoints. */
#include "study/run_biaxial.h"
#include "base/math.h"

#include "core/checkpoint.h"
#include "core/step.h"
#include "draw/canvas.h"
#include "draw/field.h"
#include "draw/frame_biaxial.h"
#include "draw/words.h"
#include "out/plot.h"
#include "out/summary.h"
#include "base/alloc.h"
#include "laws/law.h"
#include "scene/write.h"
#include "study/biaxial_view.h"
#include "study/clock.h"
#include "study/inset.h"
#include "study/open.h"
#include "study/outputs.h"
#include "study/packing.h"
#include "study/recorder.h"
#include "study/spread.h"
#include "study/warn.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct test {
    tr_biaxial b;
    const tr_scene *scene;
    const tr_run_options *options;
    tr_run_report *report;
    tr_outputs out;
    tr_series series;
    double *rolling_share, *unbalanced_share; /* of its rows, for the curves of a frame */
    tr_file disks;
    double *fill; /* of each disk: its colour value in frames, or a column of disks.csv */
    int *ends;    /* and how many contacts it has */
    tr_increments increments;
    tr_inset inset; /* of the frames: the inside of the first contact whose path is recorded */
    tr_view view;   /* equal in all frames */
    char title[TR_RUN_TITLE];
    bool rehearsal; /* a run without outputs, which finds: */
    tr_contact_id most;
    bool shearing;        /* compaction is over */
    tr_checkpoint resume; /* loading: the place to continue; used when the run gets there */
    double saved;         /* when the last checkpoint was made [s] */
    double e0, unbalanced, stress_1_sum, stress_2_sum;
    int stress_n;
    tr_biaxial_state state; /* of the last row */
    tr_energy energy;
} test;

/* {0, 0} stands for none. */
static bool is_contact(tr_contact_id pick, const tr_scene *scene) {
    int n = scene->sample.disks;
    return pick.a >= -4 && pick.a < n && pick.b >= 0 && pick.b < n; /* -1 - wall, of four */
}

/* The fields that are needed to build the test before the rest can be loaded. */
static void keep_stage(test *t, tr_checkpoint *c) {
    TR_KEEP(c, &t->rehearsal, 1);
    TR_KEEP(c, &t->most, 1);
    tr_checkpoint_check(c, is_contact(t->most, t->scene), "a contact");
    TR_KEEP(c, &t->shearing, 1);
}

static void keep_rest(test *t, tr_checkpoint *c) {
    tr_biaxial_checkpoint(&t->b, c);
    if (!t->shearing) return;
    TR_KEEP(c, &t->unbalanced, 1);
    if (t->rehearsal) return;
    TR_KEEP(c, &t->e0, 1);
    TR_KEEP(c, &t->view.x0, 1);
    TR_KEEP(c, &t->view.x1, 1);
    TR_KEEP(c, &t->view.y0, 1);
    TR_KEEP(c, &t->view.y1, 1);
    TR_KEEP(c, &t->stress_1_sum, 1);
    TR_KEEP(c, &t->stress_2_sum, 1);
    TR_KEEP(c, &t->stress_n, 1);
    TR_KEEP_NUMBERS(c, &t->state, 1);
    TR_KEEP_NUMBERS(c, &t->increments.since, 1);
    TR_KEEP(c, &t->series.n, 1);
    int rows = t->series.n;
    tr_checkpoint_check(c, rows >= 0 && rows <= t->scene->output.rows, "a number of rows");
    tr_checkpoint_check(c, t->stress_n >= 0 && t->stress_n <= rows, "a number of stresses");
    TR_KEEP(c, t->series.strain, t->series.n);
    TR_KEEP(c, t->series.sin_phi, t->series.n);
    TR_KEEP(c, t->series.void_ratio, t->series.n);
    TR_KEEP_NUMBERS(c, t->series.measures, t->series.n);
    tr_file_checkpoint(&t->disks, c);
    tr_inset_checkpoint(&t->inset, c);
    tr_outputs_checkpoint(&t->out, c);
    tr_checkpoint_check(c, rows == t->out.rows, "a number of rows");
}

static bool save(test *t, tr_status *st) {
    tr_checkpoint c;
    double start = tr_run_clock();
    char *resolved = tr_scene_write(t->scene, tr_laws_catalog(), st);
    if (!resolved) return false;
    tr_checkpoint_begin(&c, resolved, st);
    free(resolved);
    keep_stage(t, &c);
    keep_rest(t, &c);
    bool ok = tr_checkpoint_write(&c, t->options->dir, TR_CHECKPOINT);
    t->saved = tr_run_clock();
    t->out.seconds += t->saved - start;
    return ok;
}

static bool save_if_due(test *t, tr_status *st) {
    return tr_run_clock() - t->saved < t->options->checkpoint || save(t, st);
}

/* Builds the test up to the state of t->shearing. Does nothing without a checkpoint. */
static bool resume(test *t) {
    if (!t->resume.loading) return true;
    keep_rest(t, &t->resume);
    t->resume.loading = false;
    return tr_checkpoint_close(&t->resume);
}

static bool compact(test *t, tr_status *st) {
    const int at_once = 200;
    bool done = false;
    double asked = t->scene->compaction.unbalanced, fraction = 0;
    while (!done) {
        if (tr_run_stopped(t->options))
            return save(t, st) &&
                   tr_status_fail(st, TR_INTERRUPTED, "stopped during compaction; --resume continues from there");
        if (!tr_biaxial_compact(&t->b, at_once, &t->unbalanced, &done, st)) return false;
        fraction = fmax(fraction, tr_log(t->unbalanced) / tr_log(asked)); /* it decays exponentially */
        tr_run_progress(t->options, "compaction", fraction);
        if (!done && !save_if_due(t, st)) return false;
    }
    return true;
}

/* Or takes the packing from a file. An interrupted compaction resumes. */
static bool pack(test *t, bool begun, tr_status *st) {
    tr_packing p;
    bool there = false;
    if (!t->options->sample || begun) return compact(t, st);
    bool ok = tr_packing_load(&p, &t->b, t->options, &t->unbalanced, &there, st) &&
              (there || (compact(t, st) && tr_packing_save(&p, &t->b, &t->unbalanced, st)));
    tr_packing_close(&p);
    return ok;
}

static bool frame(test *t, int n_records, const tr_measures *m, tr_status *st) {
    static const tr_word_key label[] = {TR_WORD_strain,           TR_WORD_void_ratio,    TR_WORD_unbalanced,
                                        TR_WORD_sliding_contacts, TR_WORD_rolling_share, TR_N_WORDS};
    enum { LINES = 6 };
    char text[LINES][48];
    tr_view_line line[LINES];
    for (int i = 0; i < LINES; i++) {
        bool is_word = label[i] != TR_N_WORDS;
        line[i] = (tr_view_line){is_word ? tr_words_of((tr_language)t->scene->language, label[i]) : "sin φ", text[i]};
    }
    snprintf(text[0], sizeof text[0], "%.1f %%", 100 * t->state.strain);
    snprintf(text[1], sizeof text[1], "%.3f", t->state.void_ratio);
    snprintf(text[2], sizeof text[2], "%.1f %%", 100 * m->unbalanced);
    snprintf(text[3], sizeof text[3], "%.0f %%", 100 * m->sliding_fraction);
    snprintf(text[4], sizeof text[4], "%.0f %%", 100 * m->rolling_share);
    snprintf(text[5], sizeof text[5], "%.2f", t->state.sin_phi);
    const tr_series *s = &t->series;
    for (int i = 0; i < s->n; i++)
        t->rolling_share[i] = s->measures[i].rolling_share, t->unbalanced_share[i] = s->measures[i].unbalanced;
    const tr_history history = {
        s->n, s->strain, s->sin_phi, t->rolling_share, t->unbalanced_share, t->scene->shear.strain_end};
    tr_canvas_speak(t->out.film.canvas, t->scene->language);
    tr_view view = t->view;
    view.record = t->out.records, view.n_records = n_records;
    if (view.fill) tr_frame_fill(&t->b.world, t->out.records, n_records, view.color, t->fill, t->ends);
    view.time = t->state.time;
    if (t->inset.solver) {
        view.inset = tr_half_plane_state(t->inset.solver), view.inset_pair = &t->inset.pair;
        view.inset_a = t->inset.pick.a, view.inset_b = t->inset.pick.b;
        view.inset_law = tr_inset_law(&t->inset, tr_recorder_now(&t->out.recorder, 0));
    }
    view.line = line, view.n_lines = LINES, view.history = &history;
    return tr_outputs_frame(&t->out, tr_draw_biaxial, &view, st);
}

static bool row(test *t, const tr_measures *m, tr_status *st) {
    tr_row cells = {.shape = t->scene->shape};
    bool energy = t->b.world.ledger != NULL;
    if (energy) t->energy = tr_ledger_read(&t->b.world);
    t->series.strain[t->series.n] = t->state.strain;
    t->series.sin_phi[t->series.n] = t->state.sin_phi;
    t->series.void_ratio[t->series.n] = t->state.void_ratio;
    t->series.measures[t->series.n++] = *m;
    bool early = t->state.strain <= fmin(0.01, 0.5 * t->scene->shear.strain_end);
    if (!early) t->stress_1_sum += t->state.stress_1, t->stress_2_sum += t->state.stress_2, t->stress_n++;
    tr_row_biaxial(&cells, &t->state, m, energy ? &t->energy : NULL);
    if (t->scene->output.increments) {
        tr_increments_state increments;
        if (!tr_increments_read(&t->increments, &increments, st)) return false;
        tr_row_increments(&cells, &increments, t->b.mean_radius);
    }
    return tr_outputs_row(&t->out, &cells, st);
}

static bool write_lists(test *t, int n, tr_status *st) {
    if (!tr_outputs_contacts(&t->out, -1, t->state.time, t->state.strain, t->out.records, n, st)) return false;
    tr_frame_fill(&t->b.world, t->out.records, n, TR_COLOR_ROLLING, t->fill, t->ends);
    for (int i = 0; i < t->b.world.disks.n; i++) {
        tr_row row = {.shape = t->scene->shape};
        tr_row_sample(&row, t->state.time, t->state.strain, &t->b.world, i, t->fill[i], t->ends[i]);
        if (!tr_row_write(&row, &t->disks, st)) return false;
    }
    t->out.instants++; /* only now: a file without a complete instant gets no name */
    return true;
}

static bool look(test *t, unsigned due, tr_status *st) {
    double start = tr_run_clock();
    int n = tr_record_all(&t->b.world, &t->out.records, &t->out.capacity, st);
    if (st->code) return false;
    tr_measures m = tr_measures_of(&t->b.world, t->out.records, n);
    if (due & TR_DUE_ROW)
        t->state = tr_biaxial_read(&t->b);
    else
        tr_biaxial_shape(&t->b, &t->state);
    if (due & TR_DUE_ROW && !row(t, &m, st)) return false;
    if (due & TR_DUE_CONTACTS && !write_lists(t, n, st)) return false;
    if (due & TR_DUE_FRAME && !frame(t, n, &m, st)) return false;
    t->out.seconds += tr_run_clock() - start;
    return true;
}

static bool open_inset(test *t, tr_status *st) {
    const tr_paths *paths = &t->out.recorder.paths;
    tr_status why = {0};
    if (!t->scene->output.frames || !paths->contacts.n) return true;
    if (tr_inset_open(&t->inset, &t->b.world, paths->contacts.item[0], &why)) return true;
    if (why.code == TR_FILE) return tr_status_fail(st, TR_FILE, "%s", why.text);
    tr_run_note(t->report, "no inset in the frames: it needs a contact of two disks, and laws with mu and E_star");
    return true;
}

/* A test continues without its inset. */
static void step_inset(test *t) {
    tr_status why = {0};
    if (!t->inset.solver || tr_inset_step(&t->inset, tr_recorder_now(&t->out.recorder, 0), &why)) return;
    tr_run_note(t->report, "no inset from strain %.4f on: %.120s", t->state.strain, why.text);
    tr_inset_close(&t->inset);
}

static bool shear(test *t, tr_status *st) {
    int64_t total = t->b.shear_steps;
    for (int64_t k = t->b.world.steps - t->b.shear_start;; k++) {
        if (tr_run_stopped(t->options))
            return save(t, st) &&
                   tr_status_fail(st, TR_INTERRUPTED, "stopped %sat strain %.4f of %g; --resume continues from there",
                                  t->rehearsal ? "in the first pass " : "", t->state.strain,
                                  t->scene->shear.strain_end);
        if (k % 256 == 0 && !save_if_due(t, st)) return false;
        if (!tr_biaxial_forces(&t->b, st) || !tr_recorder_step(&t->out.recorder, st)) return false;
        unsigned due = t->rehearsal ? 0 : tr_outputs_due(&t->out, k, total);
        step_inset(t);
        if (due && !look(t, due, st)) return false;
        if (k == total) return true;
        if (k % 256 == 0) tr_run_progress(t->options, t->rehearsal ? "first pass" : "shear", (double)k / (double)total);
        tr_step_advance(&t->b.world);
    }
}

/* Up to the point where the shear begins or continues. */
static bool prepare(test *t, tr_status *st) {
    bool compacted = t->shearing;
    tr_run_report *report = t->report;
    if (!tr_biaxial_init(&t->b, t->scene, st)) return false;
    if (!tr_run_threads(t->options, &t->b.world, st)) return false;
    bool begun = t->resume.loading;
    if (!compacted && !(resume(t) && pack(t, begun, st))) return false;
    if (!tr_biaxial_begin_shear(&t->b, st)) return false;
    t->shearing = true;
    if (t->rehearsal) return resume(t);
    tr_biaxial_state now;
    tr_biaxial_shape(&t->b, &now);
    t->e0 = now.void_ratio;
    t->view = tr_run_biaxial_view(&t->b, t->title);
    bool small = t->scene->sample.disks > 2000; /* disks of 12 pixels and less: no room for lines */
    if (small || t->view.color == TR_COLOR_SPIN) t->view.fill = t->fill;
    t->b.world.contact_updates = 0;
    const tr_recording recorded = {t->scene, &t->b.world, t->options->dir, "", t->most, t->b.shear_steps, compacted};
    const tr_outputs_wanted wanted = {t->scene, t->options, "biaxial.mp4", t->b.shear_steps, compacted};
    bool ok = tr_outputs_open(&t->out, &wanted, report, st) &&
              tr_recorder_open(&t->out.recorder, &recorded, report, st) &&
              (!t->scene->output.contacts ||
               (compacted ? tr_file_reopen : tr_file_open)(&t->disks, t->options->dir, "disks.csv", st));
    ok = ok && open_inset(t, st);
    if (ok && t->scene->output.increments) tr_increments_attach(&t->b.world, &t->increments);
    return ok && resume(t);
}

/* Finds the most mobilised contact at the end: the same run with the same bits, without outputs. */
static bool rehearse(test *t, tr_status *st) {
    t->rehearsal = true;
    bool ok = prepare(t, st) && shear(t, st);
    if (ok) t->most = tr_recorder_most(&t->b.world, st);
    tr_biaxial_free(&t->b);
    t->rehearsal = t->shearing = false;
    return ok && !st->code;
}

static bool close_outputs(test *t, tr_status *st) {
    if (t->out.instants && t->disks.stream)
        tr_file_commit(&t->disks, st);
    else
        tr_file_discard(&t->disks);
    return tr_outputs_close(&t->out, st);
}

/* Why a law can make energy. If a law claims to make none, only the time step makes it. */
static const char *why_made(const tr_law *law, int rolling_velocity) {
    if (law->needs & TR_NEEDS_V_R && !(law->needs & TR_NEEDS_PARTIALS) && rolling_velocity != 0)
        return "its moments do not fit the rolling_velocity";
    if (law->claims & TR_ENERGY_CLOSED) return "a smaller step.safety makes it less";
    return "closed cycles of it may make energy";
}

/* Rounding and thin contacts stay far below 1 % of the work. */
static void report_made(test *t) {
    static const char *const law_kind_name[TR_N_LAW_KINDS] = {"normal", "friction", "rolling"};
    const tr_energy *e = &t->energy;
    const double net[TR_N_LAW_KINDS] = {e->damped, e->friction, e->rolling}, work = fabs(e->work);
    for (int k = 0; k < TR_N_LAW_KINDS; k++) {
        const tr_law *law = t->b.world.group[0].laws[k].law;
        if (!(e->made[k] > 0.01 * work)) continue;
        tr_run_note(t->report, "the %s law %s made energy: %.3g times the work of the walls (net it took %.3g); %s",
                    law_kind_name[k], law->table.name, e->made[k] / work, net[k] / work,
                    why_made(law, t->b.world.rolling_velocity));
    }
}

/* "0.515 +- 0.05 (...), 3.7 s; +- 0.02 takes 7 seeds, 26 s"; about: the place in the test. A resumed run does not know
 * the time of the whole test. */
static void say_strength(const test *t, const char *label, double sin_phi, const char *about, const tr_accuracy *a,
                         int i, double wall_s) {
    const tr_strength_accuracy *one = &a->strength[i];
    char took[32] = "", takes[32] = "";
    if (!t->options->resume) {
        snprintf(took, sizeof took, ", %.1f s", wall_s);
        snprintf(takes, sizeof takes, ", %.0f s", one->seeds * wall_s);
    }
    if (!*a->row)
        tr_run_say(t->report, label, "%.3f +- not examined (%s)%s", sin_phi, about, took);
    else
        tr_run_say(t->report, label,
                   "%.3f +- %.2g (%s; one sample of %d; step %.1g +- %.1g)%s; +- %.2g takes %d seeds%s", sin_phi,
                   one->half, about, t->scene->sample.disks, one->step, one->step_half, took, one->aim, one->seeds,
                   takes);
}

static void report(test *t, const tr_strength *s, const tr_accuracy *a, const tr_timing *timing) {
    tr_run_report *r = t->report;
    tr_run_say(r, "disks, seed", "%d, %llu", t->scene->sample.disks, (unsigned long long)t->scene->seed);
    tr_run_say(r, "inertial number I", "%g", t->scene->shear.inertial_number);
    tr_run_say(r, "void ratio e0", "%.4f", t->e0);
    char about[2][48];
    snprintf(about[0], sizeof about[0], "at %.1f %% strain", 100 * s->strain_peak);
    snprintf(about[1], sizeof about[1], "mean over %.3g-%.3g %% strain", 100 * s->residual_from,
             100 * t->scene->shear.strain_end);
    say_strength(t, "sin phi, peak", s->sin_phi_peak, about[0], a, 0, timing->wall_s);
    say_strength(t, "sin phi, residual", s->sin_phi_residual, about[1], a, 1, timing->wall_s);
    if (*a->row)
        tr_run_say(r, "+-, with 95 %", "%s", a->row);
    else
        tr_run_say(r, "not examined", "%s", a->not_examined);
    tr_run_say(r, "void ratio, residual", "%.4f", s->e_residual);
    tr_run_say(r, "rolling share, residual", "%.3f", s->residual.rolling_share);
    tr_run_say(r, "contacts with s1 s2 < 0", "%.1f %%, residual", 100 * s->residual.opposed_fraction);
    bool mean = t->scene->shear.hold == TR_HOLD_MEAN;
    double held = mean ? 0.5 * (t->stress_1_sum + t->stress_2_sum) : t->stress_2_sum;
    tr_run_say(r, mean ? "mean stress" : "lateral stress", "%.4g %s, asked %.4g", held / t->stress_n,
               t->scene->shape == TR_SHAPE_SPHERE ? "N/m" : "Pa", t->scene->shear.lateral_pressure);
    if (t->b.world.ledger && t->energy.work != 0) {
        tr_run_say(r, "energy residual/work", "%.1e (bookkeeping, not accuracy)", t->energy.residual / t->energy.work);
        report_made(t);
    }
    tr_run_say(r, "time step", "%.3g s, bound %.3g s", t->b.world.dt, t->b.dt_bound);
    tr_run_say(r, "steps", "%lld compaction, %lld shear", (long long)t->b.shear_start, (long long)t->b.shear_steps);
    tr_run_say(r, "wall time", "%.1f s, %.1f M contact updates/s", timing->wall_s, timing->contact_updates_per_s / 1e6);
}

static bool summarise(test *t, double started, double updates_per_s, tr_status *st) {
    tr_strength s = tr_summary_strength(&t->series);
    char caption[200];
    int code = 0;
    const tr_scene *scene = t->scene;
    snprintf(caption, sizeof caption, "%d disks, seed %llu, I = %g, stiffness ratio %g, %s, rolling velocity %s",
             scene->sample.disks, (unsigned long long)scene->seed, scene->shear.inertial_number,
             tr_biaxial_stiffness(&t->b, scene->shear.lateral_pressure) / scene->shear.lateral_pressure,
             t->b.world.group[0].laws[TR_ROLLING].law->table.name,
             tr_rolling_velocities[scene->contact.rolling_velocity].name);
    if (scene->output.curves && !tr_plot_available())
        tr_run_note(t->report, "no curves: gnuplot is not installed; history.csv has the numbers");
    else if (scene->output.curves &&
             !tr_plot_biaxial(t->options->dir, caption, fmax(t->state.strain, scene->shear.strain_end), &code, st))
        return false;
    else if (code)
        tr_run_note(t->report, "no curves: gnuplot failed (%d) on plot.gp; run it there to see why", code);
    const tr_biaxial_result result = {t->e0,
                                      t->unbalanced,
                                      s,
                                      t->stress_2_sum / t->stress_n,
                                      t->b.world.ledger ? &t->energy : NULL,
                                      t->out.recorder.bytes,
                                      tr_spread_of(&t->b),
                                      {tr_run_clock() - started, updates_per_s}};
    char *text = tr_summary_biaxial(scene, &t->b, &result, st);
    if (!text) return false;
    report(t, &s, &result.accuracy, &result.timing);
    bool ok = tr_file_write(t->options->dir, "summary.json", text, st);
    free(text);
    return ok;
}

char *tr_run_check_biaxial(const tr_scene *scene, tr_run_report *report, tr_status *st) {
    const tr_energy energy = {0};
    tr_biaxial *b = tr_alloc(1, sizeof *b, st);
    char *summary = NULL;
    if (b && tr_biaxial_init(b, scene, st)) {
        tr_warn_biaxial(b, report);
        const tr_biaxial_result later = {.energy = scene->output.energy ? &energy : NULL,
                                         .paths_bytes = scene->output.path_rows,
                                         .accuracy = tr_spread_of(b)};
        summary = tr_summary_biaxial(scene, b, &later, st);
        tr_biaxial_free(b);
    }
    free(b);
    return summary;
}

bool tr_run_biaxial(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    size_t rows = (size_t)scene->output.rows, disks = (size_t)scene->sample.disks;
    test *t = tr_alloc(1, sizeof *t, st);
    if (!t) return false;
    t->scene = scene, t->options = options, t->report = report;
    double started = t->saved = tr_run_clock();
    bool ok = (t->series.strain = tr_alloc(rows, sizeof(double), st)) &&
              (t->series.sin_phi = tr_alloc(rows, sizeof(double), st)) &&
              (t->series.void_ratio = tr_alloc(rows, sizeof(double), st)) &&
              (t->series.measures = tr_alloc(rows, sizeof(tr_measures), st)) &&
              (t->rolling_share = tr_alloc(rows, sizeof(double), st)) &&
              (t->unbalanced_share = tr_alloc(rows, sizeof(double), st)) &&
              (t->fill = tr_alloc(disks, sizeof(double), st)) && (t->ends = tr_alloc(disks, sizeof(int), st)) &&
              (!options->sample || tr_packing_check(scene, options->sample, st)) &&
              tr_run_open(scene, options, &t->resume, report, st);
    if (ok && t->resume.loading) keep_stage(t, &t->resume);
    bool rehearsed = t->resume.loading && !t->rehearsal;
    ok = ok && !st->code && (rehearsed || !tr_recorder_wants_most(scene) || rehearse(t, st));
    if (ok) {
        bool prepared = prepare(t, st);
        double shear_started = tr_run_clock();
        t->out.seconds = 0;
        int64_t before = t->b.world.contact_updates;
        if (prepared) shear(t, st);
        double stepping = tr_run_clock() - shear_started - t->out.seconds;
        double updates = (double)(t->b.world.contact_updates - before);
        bool opened = t->out.scene != NULL;
        ok = (opened ? close_outputs(t, st) : prepared) && summarise(t, started, updates / stepping, st);
        if (ok) tr_run_remove_checkpoint(options->dir, report);
    }
    tr_biaxial_free(&t->b);
    tr_inset_close(&t->inset);
    free(t->resume.bytes);
    free(t->series.strain), free(t->series.sin_phi), free(t->series.void_ratio);
    free(t->series.measures), free(t->rolling_share), free(t->unbalanced_share);
    free(t->fill), free(t->ends), free(t);
    return ok;
}
