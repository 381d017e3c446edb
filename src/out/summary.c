/* SPDX-License-Identifier: MIT */
#include "out/summary.h"

#include "base/version.h"
#include <errno.h>
#include <string.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define ADD(name, ...) sum->name += m->name;
#define DIVIDE(name, ...) sum->name /= n;
static void add_measures(tr_measures *sum, const tr_measures *m) {
    TR_CONTACT_MEASURES(ADD)
    TR_FORCE_MEASURES(ADD)
}

static void divide_measures(tr_measures *sum, int n){TR_CONTACT_MEASURES(DIVIDE) TR_FORCE_MEASURES(DIVIDE)}

tr_strength tr_summary_strength(const tr_series *s) {
    tr_strength r = {0};
    if (s->n < 2) return r;
    double end = s->strain[s->n - 1], spacing = end / (s->n - 1);
    r.residual_from = 0.75 * end;
    int window = (int)fmax(1, fmin(s->n, round(0.005 / spacing))), kept = 0;
    double sum = 0, best = -INFINITY;
    for (int i = 0; i < s->n; i++) {
        sum += s->sin_phi[i] - (i >= window ? s->sin_phi[i - window] : 0);
        if (i + 1 >= window && sum / window > best)
            best = sum / window, r.strain_peak = s->strain[i] - 0.5 * (window - 1) * spacing;
        if (s->strain[i] < r.residual_from) continue;
        r.sin_phi_residual += s->sin_phi[i], r.e_residual += s->void_ratio[i];
        add_measures(&r.residual, &s->measures[i]);
        kept++;
    }
    r.sin_phi_peak = best;
    r.sin_phi_residual /= kept, r.e_residual /= kept;
    divide_measures(&r.residual, kept);
    return r;
}

/* A number that is not finite is null. */
static void add(json_t *object, const char *key, double value) {
    json_object_set_new(object, key, isfinite(value) ? json_real(value) : json_null());
}

/* "no | yes" as a list, without the blanks around. */
static json_t *choices_of(const char *text) {
    json_t *list = json_array();
    for (;; text++) {
        text += strspn(text, " ");
        size_t n = strcspn(text, "|"), all = n;
        while (n && text[n - 1] == ' ') n--;
        json_array_append_new(list, json_stringn(text, n));
        text += all;
        if (!*text) return list;
    }
}

static json_t *begin(const tr_scene *scene, const char *kind) {
    errno = 0;
    json_t *o = json_object();
    json_object_set_new(o, "version", json_string(TR_VERSION));
    json_object_set_new(o, "commit", json_string(tr_commit));
    json_object_set_new(o, "kind", json_string(kind));
    const tr_scene_lesson *l = &scene->lesson;
    const char *const text[][2] = {{"title", l->title},       {"equation", l->equation}, {"sentence", l->sentence},
                                   {"question", l->question}, {"answer", l->answer},     {"happens", l->happens}};
    json_t *lesson = json_object();
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        if (*text[i][1]) json_object_set_new(lesson, text[i][0], json_string(text[i][1]));
    if (*l->choices) {
        json_object_set_new(lesson, "choices", choices_of(l->choices));
        json_object_set_new(lesson, "right", json_integer(l->right));
    }
    if (json_object_size(lesson)) json_object_set(o, "lesson", lesson);
    json_decref(lesson);
    if (scene->kind != TR_KIND_BIAXIAL) return o; /* nothing random */
    char seed[24]; /* JSON text has no limit, but jansson's integers are signed: the upper half as a string */
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)scene->seed);
    bool fits = scene->seed <= INT64_MAX;
    json_object_set_new(o, "seed", fits ? json_integer((json_int_t)scene->seed) : json_string(seed));
    return o;
}

/* key: "of disks|of spheres". */
static void add_by_shape(json_t *object, tr_shape shape, const char *key, double value) {
    char part[TR_BY_SHAPE];
    add(object, tr_param_by_shape(key, shape, part), value);
}

/* The passes that ran, and the parts that were left out because the scene does not need them. */
static void add_pipeline(json_t *o, const tr_world *world) {
    json_t *passes = json_object(), *out = json_array();
    for (int k = 0; k < world->n_groups; k++) {
        char group[32];
        snprintf(group, sizeof group,
                 k == 0                  ? "disk_disk"
                 : k == 1                ? "wall_disk"
                 : world->group[k].rings ? "ring_disk"
                                         : "wall_disk_%d",
                 k);
        json_t *names = json_array();
        for (int p = 0; p < world->group[k].n_pass; p++)
            json_array_append_new(names, json_string(world->group[k].pass[p].name));
        json_object_set_new(passes, group, names);
    }
    json_object_set_new(o, "passes", passes);
    json_object_set_new(o, "pair_finding", json_string(world->broad->name));
    if (!world->group[0].laws[TR_FRICTION].law->step) json_array_append_new(out, json_string("friction"));
    if (!world->group[0].laws[TR_ROLLING].law->step) json_array_append_new(out, json_string("rolling resistance"));
    if (!world->group[1].spins && world->n_walls)
        json_array_append_new(out, json_string("friction and rolling resistance at walls"));
    if (!world->n_walls) json_array_append_new(out, json_string("walls"));
    if (!world->disks.load) json_array_append_new(out, json_string("weight"));
    if (!world->ledger) json_array_append_new(out, json_string("energy ledger"));
    if (world->broad == &tr_broad_brute) json_array_append_new(out, json_string("broad phase"));
    json_object_set_new(o, "left_out", out);
}

/* If memory is short, jansson's calls leave parts out and continue. errno then still says that malloc failed since
 * begin(). */
static char *finish(json_t *o, const tr_timing *timing, tr_status *st) {
    json_t *t = json_object();
    add(t, "wall_s", timing->wall_s);
    add(t, "contact_updates_per_s", timing->contact_updates_per_s);
    json_object_set_new(o, "timing", t);
    char *text = json_dumps(o, JSON_INDENT(2) | JSON_REAL_PRECISION(15)), *line = NULL;
    json_decref(o);
    if (!text || errno == ENOMEM || asprintf(&line, "%s\n", text) < 0)
        tr_status_fail(st, TR_FILE, "error: out of memory (summary)");
    free(text);
    return st->code ? NULL : line;
}

/* Energy that each mechanism stores and has taken; the names are those of history.csv. */
static json_t *energy_of(tr_shape shape, const tr_energy *e) {
    const struct {
        const char *name;
        double net, made;
    } lost[] = {{"damped", e->damped, e->made[TR_NORMAL]},
                {"friction", e->friction, e->made[TR_FRICTION]},
                {"rolling", e->rolling, e->made[TR_ROLLING]}};
    json_t *o = json_object();
    add_by_shape(o, shape, "kinetic_J_per_m|kinetic_J", e->kinetic);
    add_by_shape(o, shape, "elastic_normal_J_per_m|elastic_normal_J", e->elastic_normal);
    add_by_shape(o, shape, "elastic_friction_J_per_m|elastic_friction_J", e->elastic_friction);
    add_by_shape(o, shape, "elastic_rolling_J_per_m|elastic_rolling_J", e->elastic_rolling);
    for (size_t i = 0; i < sizeof lost / sizeof *lost; i++) {
        json_t *of = json_object();
        add_by_shape(of, shape, "net_J_per_m|net_J", lost[i].net);
        add_by_shape(of, shape, "made_J_per_m|made_J", lost[i].made);
        add(of, "made_over_work", lost[i].made / fabs(e->work));
        json_object_set_new(o, lost[i].name, of);
    }
    return o;
}

static json_t *accuracy_of(const tr_accuracy *a) {
    static const char *const name[] = {"sin_phi_peak", "sin_phi_residual"};
    json_t *o = json_object();
    if (!*a->row) return json_object_set_new(o, "not_examined", json_string(a->not_examined)), o;
    json_object_set_new(o, "from", json_string(a->row));
    for (int i = 0; i < 2; i++) {
        const tr_strength_accuracy *of = &a->strength[i];
        json_t *one = json_object();
        add(one, "half_width_95", of->half);
        add(one, "half_width_asked", of->aim);
        json_object_set_new(one, "seeds_it_takes", json_integer(of->seeds));
        add(one, "half_step_changes", of->step);
        add(one, "half_step_half_width_95", of->step_half);
        json_object_set_new(o, name[i], one);
    }
    return o;
}

char *tr_summary_biaxial(const tr_scene *scene, const tr_biaxial *b, const tr_biaxial_result *result, tr_status *st) {
    const tr_strength *s = &result->strength;
    json_t *o = begin(scene, "biaxial");
    json_object_set_new(o, "n_disks", json_integer(scene->sample.disks));
    add(o, "e0", result->e0);
    add(o, "unbalanced_after_compaction", result->unbalanced);
    add(o, "e_residual", s->e_residual);
    add(o, "sin_phi_peak", s->sin_phi_peak);
    add(o, "strain_at_peak", s->strain_peak);
    add(o, "sin_phi_residual", s->sin_phi_residual);
    add(o, "tan_phi_peak", tr_biaxial_tan_phi(s->sin_phi_peak));
    add(o, "tan_phi_residual", tr_biaxial_tan_phi(s->sin_phi_residual));
    add(o, "q_over_p_peak", 2 * s->sin_phi_peak);
    add(o, "q_over_p_residual", 2 * s->sin_phi_residual);
#define RESIDUAL(name, unit, quoted)                                                                                   \
    if (quoted) add(o, #name "_residual", s->residual.name);
    TR_CONTACT_MEASURES(RESIDUAL)
    TR_FORCE_MEASURES(RESIDUAL)
    add(o, "residual_from_strain", s->residual_from);
    add(o, "strain_end", scene->shear.strain_end);
    add_by_shape(o, scene->shape, "mean_stress_2_Pa|mean_stress_2_N_per_m", result->mean_stress_2);
    add(o, "inertial_number", scene->shear.inertial_number);
    add(o, "stiffness_ratio", tr_biaxial_stiffness(b, scene->shear.lateral_pressure) / scene->shear.lateral_pressure);
    add_by_shape(o, scene->shape, "mean_mass_kg_per_m|mean_mass_kg", b->mean_mass);
    add(o, "strain_rate_per_s", b->rate);
    json_object_set_new(o, "servo", json_string("piston: M dv/dt = pressure*length - force"));
    add_by_shape(o, scene->shape, "servo_mass_kg_per_m|servo_mass_kg",
                 b->world.n_walls ? b->world.wall[TR_LEFT_WALL].mass : b->world.cell.mass[0]);
    json_object_set_new(o, "start_of_shear",
                        json_string("velocities and friction of disks after compaction, "
                                    "other histories zero, driven sides at rest"));
    add(o, "dt_s", b->world.dt);
    add(o, "dt_bound_s", b->dt_bound);
    json_object_set_new(o, "steps_compaction", json_integer(b->shear_start));
    json_object_set_new(o, "steps", json_integer(b->shear_steps));
    json_object_set_new(o, "contact_updates", json_integer(b->world.contact_updates));
    json_object_set_new(o, "pair_searches", json_integer(b->world.searches));
    json_object_set_new(o, "list_refreshes", json_integer(b->world.refreshes));
    if (result->energy) {
        const tr_energy *energy = result->energy;
        add_by_shape(o, scene->shape, "energy_work_J_per_m|energy_work_J", energy->work);
        add_by_shape(o, scene->shape, "energy_residual_J_per_m|energy_residual_J", energy->residual);
        add(o, "energy_residual_over_work", energy->residual / energy->work);
        json_object_set_new(o, "energy", energy_of(scene->shape, energy));
    }
    json_object_set_new(o, "accuracy", accuracy_of(&result->accuracy));
    if (result->paths_bytes) json_object_set_new(o, "paths_bytes", json_integer(result->paths_bytes));
    add_pipeline(o, &b->world);
    return finish(o, &result->timing, st);
}

static void add_lane(json_t *o, const tr_scene *scene, const tr_bodies *b) {
    json_object_set_new(o, "n_disks", json_integer(scene->n_disks));
    add(o, "dt_s", b->world.dt);
    add(o, "dt_bound_s", b->dt_bound); /* null: no contact can vibrate */
    json_object_set_new(o, "steps", json_integer(b->steps));
    json_object_set_new(o, "contact_updates", json_integer(b->world.contact_updates));
    add_pipeline(o, &b->world);
}

static void add_checks(json_t *o, const tr_check_result *result, int n) {
    json_t *checks = json_array();
    char part[TR_BY_SHAPE];
    for (const tr_check_result *r = result; r < result + n; r++) {
        json_t *c = json_object();
        if (*r->lane) json_object_set_new(c, "lane", json_string(r->lane));
        json_object_set_new(c, "what", json_string(r->what));
        json_object_set_new(c, "of", json_string(r->of));
        add(c, "measured", r->measured); /* null: it did not happen */
        add(c, "exact", r->check->exact);
        add(c, "error", r->measured - r->check->exact);
        add(c, "tolerance", r->check->tolerance);
        json_object_set_new(c, "unit", json_string(tr_param_by_shape(r->unit, r->shape, part)));
        json_object_set_new(c, "ok", json_boolean(r->ok));
        json_array_append_new(checks, c);
    }
    if (n) json_object_set(o, "checks", checks);
    json_decref(checks);
}

char *tr_summary_bodies(const tr_scene *scene, const tr_bodies *const *b, const tr_check_result *result, int n,
                        const tr_timing *timing, tr_status *st) {
    json_t *o = begin(scene, "bodies");
    add(o, "time_end_s", scene->time_end);
    if (scene->n_more == 0) {
        add_lane(o, scene, b[0]);
    } else {
        json_t *lanes = json_array();
        for (int i = 0; i <= scene->n_more; i++) {
            const tr_scene *of = i ? &scene->more[i - 1] : scene;
            json_t *lane = json_object();
            json_object_set_new(lane, "label", json_string(of->label));
            add_lane(lane, of, b[i]);
            json_array_append_new(lanes, lane);
        }
        json_object_set_new(o, "lanes", lanes);
    }
    add_checks(o, result, n);
    return finish(o, timing, st);
}

static json_t *laws_of(const tr_scene *scene, const tr_path_result *law) {
    json_t *laws = json_array();
    for (const tr_path_result *r = law; r < law + scene->n_laws; r++) {
        json_t *l = json_object();
        json_object_set_new(l, "friction", json_string(r->friction));
        json_object_set_new(l, "rolling", json_string(r->rolling));
        if (r->rolling_velocity) json_object_set_new(l, "rolling_velocity", json_string(r->rolling_velocity));
        add_by_shape(l, scene->shape, "Q_end_N_per_m|Q_end_N", r->Q_end);
        add(l, "q_end", r->q_end);
        add_by_shape(l, scene->shape, "Q_max_N_per_m|Q_max_N", r->Q_max);
        add_by_shape(l, scene->shape, "moment_1_end_N|moment_1_end_N_m", r->moment_1_end);
        add_by_shape(l, scene->shape, "moment_2_end_N|moment_2_end_N_m", r->moment_2_end);
        add_by_shape(l, scene->shape, "moment_max_N|moment_max_N_m", r->moment_max);
        json_object_set_new(l, "history_merged", json_integer(r->merged));
        json_array_append_new(laws, l);
    }
    return laws;
}

static void add_solver(json_t *o, const tr_scene *scene, const tr_path_result *r) {
    json_object_set_new(o, "solver", json_string(r->solver));
    json_object_set_new(o, "elements", json_integer(scene->patch.elements));
    add(o, "mu", scene->patch.mu);
    add(o, "depth_m", scene->pair.d);
    add(o, "Q_end_N_per_m", r->Q_end);
    add(o, "q_end", r->q_end);
    add(o, "u_slide_end_m", r->u_slide_end);
    add(o, "dissipated_J_per_m", r->dissipated);
}

char *tr_summary_path(const tr_scene *scene, int64_t steps, const tr_path_result *result, const tr_check_result *check,
                      const tr_timing *timing, tr_status *st) {
    json_t *o = begin(scene, result->solver ? "patch" : "contact");
    json_object_set_new(o, "segments", json_integer(scene->n_segments));
    json_object_set_new(o, "steps", json_integer(steps));
    add(o, "E_star_Pa", scene->pair.E_star);
    add(o, "R_star_m", scene->pair.R_star);
    if (result->solver)
        add_solver(o, scene, result);
    else
        json_object_set_new(o, "laws", laws_of(scene, result));
    add_checks(o, check, scene->n_checks);
    return finish(o, timing, st);
}
