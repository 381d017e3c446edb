/* SPDX-License-Identifier: MIT */
#include "study/replay.h"
#include "base/math.h"

#include "base/alloc.h"
#include "base/gather.h"
#include "laws/law.h"
#include "patch/cut.h"
#include "study/clock.h"
#include "study/contact.h"
#include "study/replay_read.h"
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* ---- the laws */

/* A parameter of the run's friction law, else of its normal law, else 0. */
static double value_of(const tr_scene_contact *c, const char *key) {
    const double *friction = tr_law_value(tr_laws_friction[c->friction.law], c->friction.par, key);
    const double *normal = tr_law_value(tr_laws_normal[c->normal.law], c->normal.par, key);
    return friction ? *friction : normal ? *normal : 0;
}

/* That of a contact of two mean disks under the mean force. All contacts have it, as in a run. */
static double stiffness(const tr_replay *r) {
    double P = 0, R = 0, n = 0;
    for (int i = 0; i < r->n_rows; i++) {
        const tr_replay_row *c = &r->row[i];
        if (c->a >= 0) P += c->P, R += 0.5 * (c->R1 + c->R2), n++;
    }
    P /= n, R /= n;
    double a = tr_law_width(TR_SHAPE_DISK, P, R / 2, r->E_star);
    return M_PI * r->E_star / (2 * tr_log(2 * tr_law_depth(r->depth, R, R) / a));
}

static bool has(const tr_law *law, const char *key) {
    for (int k = 0; k < law->table.n; k++)
        if (!strcmp(law->table.params[k].key, key)) return true;
    return false;
}

/* One item of `laws:`. hertz-line beside it: the laws that follow the curve of the normal force take it from there. */
static void write_item(FILE *out, const tr_replay *r, const tr_law *law, int elements) {
    fprintf(out, "  - {friction: %s, normal: hertz-line, mu: %.17g, E_star: %.17g, depth: %.17g", law->table.name,
            r->mu, r->E_star, r->depth);
    if (has(law, "k_t")) fprintf(out, ", k_t: %.17g", r->k_t);
    if (has(law, "elements")) fprintf(out, ", elements: %d", elements);
    fputs("}\n", out);
}

static bool choose_laws(tr_replay *r, int elements, tr_status *st) {
    const tr_scene_contact *own = &r->scene.contact;
    const tr_law *exact = NULL, *chosen[TR_REPLAY_LAWS];
    int n_friction = tr_laws_catalog()->n_friction, n = 2;
    r->mu = value_of(own, "mu"), r->E_star = value_of(own, "E_star"), r->depth = value_of(own, "depth");
    if (!(r->mu > 0 && r->E_star > 0))
        return tr_status_fail(st, TR_BAD_CASE, "error: replay needs a run whose laws have mu > 0 and E_star");
    r->k_t = stiffness(r);
    if (!(r->k_t > 0 && isfinite(r->k_t)))
        return tr_status_fail(st, TR_BAD_CASE,
                              "error: replay needs a run with contacts of two disks under a normal force");
    for (int i = 0; i < n_friction; i++) {
        const tr_law *law = tr_laws_friction[i];
        if (law->needs & TR_SOLVED_BY_PATCH)
            exact = law;
        else if (law->step && !(law->table.demands & TR_ONLY_SPHERES) && n < TR_REPLAY_LAWS - 1)
            chosen[n++] = law;
    }
    chosen[TR_REPLAY_EXACT] = chosen[TR_REPLAY_OWN] = exact; /* the latter makes room */
    tr_gather scene;
    if (tr_gather_begin(&scene, st)) {
        fputs("kind: contact\nbodies: {R1: 1, R2: 1, E: 1, nu: 0}\nlaws:\n", scene.stream);
        for (int i = 0; i < n; i++) write_item(scene.stream, r, chosen[i], elements);
        fputs("path: [{force: 0}]\n", scene.stream);
    }
    char *text = tr_gather_end(&scene, st);
    bool ok =
        text && tr_scene_read(&r->contact, &(tr_scene_source){"replay", text, scene.n, NULL, 0}, tr_laws_catalog(), st);
    free(text);
    if (!ok) return false;
    tr_scene_contact *item = &r->contact.laws[TR_REPLAY_OWN];
    item->friction = own->friction, item->normal = own->normal;
    for (int i = 0; i < n; i++) r->name[i] = chosen[i]->table.name;
    r->name[TR_REPLAY_OWN] = "run-replayed", r->name[n] = "run";
    r->n_laws = n, r->n_columns = n + 1;
    return true;
}

/* ---- one life */

/* Steps from row `from` (NULL: the contact forms) to row `to`. */
static int steps_of(const tr_replay *r, const tr_replay_row *from, const tr_replay_row *to, int elements) {
    double R = tr_law_R_star(to->R1, to->R2), d = tr_law_depth(r->depth, to->R1, to->R2);
    double a = tr_law_width(TR_SHAPE_DISK, to->P, R, r->E_star);
    double before = from ? tr_law_width(TR_SHAPE_DISK, from->P, R, r->E_star) : 0;
    if (!(to->P > 0)) return 1;
    double slip = r->mu * 2 * to->P / (M_PI * r->E_star) * (tr_log(2 * d / a) + 0.5);
    int slides = (int)ceil(10 * fmin(fabs(to->slide) / slip, 2)); /* beyond 2 slip all of it slips */
    int steps = tr_patch_pieces(before > 0 ? before : a, a, elements, to->roll);
    return steps > slides ? steps : slides;
}

static bool set_path(const tr_replay *r, const tr_replay_life *life, int elements, tr_scene *s, tr_status *st) {
    const tr_replay_row *row = r->row + life->first;
    *s = r->contact;
    s->pair.R1 = row->R1, s->pair.R2 = row->R2, s->pair.R_star = tr_law_R_star(row->R1, row->R2);
    s->n_segments = life->n + 1;
    if (!(s->path = tr_alloc((size_t)s->n_segments, sizeof *s->path, st))) return false;
    s->path[0] = (tr_scene_segment){.overlap = NAN, .tangential = NAN, .steps = 1}; /* apart */
    for (int i = 0; i < life->n; i++)
        s->path[i + 1] = (tr_scene_segment){.force = row[i].P,
                                            .overlap = NAN,
                                            .tangential = NAN,
                                            .slide = row[i].slide,
                                            .roll = row[i].roll,
                                            .steps = steps_of(r, i ? &row[i - 1] : NULL, &row[i], elements)};
    return true;
}

static bool is_stopped(const tr_replay_options *o) {
    return o->stop && *o->stop;
}

static bool drive(tr_replay *r, tr_replay_life *life, const tr_scene *s, tr_contact *contact,
                  const tr_replay_options *o, tr_status *st) {
    tr_contact_state state[TR_MAX_LAWS];
    double before[TR_REPLAY_LAWS] = {0}, P = 0;
    if (!tr_contact_step(contact, state, st)) return false;
    for (int i = 0; i < life->n && !is_stopped(o); i++) {
        const tr_scene_segment *g = &s->path[i + 1];
        double *Q = r->Q + (size_t)(life->first + i) * (size_t)r->n_columns, du = g->slide / g->steps;
        for (int k = 0; k < g->steps; k++) {
            if (!tr_contact_step(contact, state, st)) return false;
            for (int j = 0; j < r->n_laws; j++) {
                life->work[j] += 0.5 * (before[j] + state[j].Q) * du;
                before[j] = Q[j] = state[j].Q;
            }
            if (state[0].a > 0) life->rolled += fabs(g->roll) / g->steps / state[0].a;
            life->full += r->mu * 0.5 * (P + state[0].P) * fabs(du);
            P = state[0].P;
        }
        r->rolled[life->first + i] = life->rolled;
        double recorded = r->row[life->first + i].Q;
        Q[r->n_laws] = recorded;
        life->work[r->n_laws] += 0.5 * (before[r->n_laws] + recorded) * g->slide;
        before[r->n_laws] = recorded;
    }
    return true;
}

static void replay(tr_replay *r, tr_replay_life *life, const tr_replay_options *o, tr_status *st) {
    tr_scene s;
    tr_contact *contact = NULL;
    if (set_path(r, life, o->elements, &s, st) && (contact = tr_contact_new(&s, st)))
        life->done = drive(r, life, &s, contact, o, st);
    tr_contact_free(contact);
    free(s.path);
}

/* ---- all lives: a free thread takes the next one and writes only the data of that life */

typedef struct crew {
    tr_replay *r;
    const tr_replay_options *o;
    atomic_int next, rows, failed; /* rows: behind us */
    atomic_bool starved;           /* of memory: that is no reason to leave a contact out */
} crew;

static void *work(void *context) {
    crew *c = context;
    for (int k; !is_stopped(c->o) && !atomic_load(&c->starved) &&
                (k = atomic_fetch_add(&c->next, c->o->every)) < c->r->n_lives;) {
        tr_replay_life *life = &c->r->life[k];
        tr_status st = {0};
        if (c->r->row[life->first].a >= 0) {
            replay(c->r, life, c->o, &st);
            atomic_fetch_add(&c->failed, !life->done);
            if (st.code == TR_FILE) atomic_store(&c->starved, true);
        }
        atomic_fetch_add(&c->rows, life->n);
    }
    return NULL;
}

static bool replay_all(crew *c, tr_status *st) {
    pthread_t *thread = tr_alloc((size_t)c->o->jobs, sizeof *thread, st);
    int n = 0, of = 0;
    if (!thread) return false;
    for (int k = 0; k < c->r->n_lives; k += c->o->every) of += c->r->life[k].n;
    while (n < c->o->jobs && !pthread_create(&thread[n], NULL, work, c)) n++;
    if (!n) work(c);
    while (n && atomic_load(&c->rows) < of && !is_stopped(c->o) && !atomic_load(&c->starved)) {
        if (c->o->progress) c->o->progress(c->o->context, "replay", (double)atomic_load(&c->rows) / of);
        nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL);
    }
    while (n) pthread_join(thread[--n], NULL);
    free(thread);
    if (is_stopped(c->o)) return tr_status_fail(st, TR_INTERRUPTED, "stopped; nothing was written");
    if (atomic_load(&c->starved)) return tr_status_fail(st, TR_FILE, "error: out of memory");
    return true;
}

bool tr_replay_run(tr_replay *r, const tr_replay_options *o, tr_run_report *report, tr_status *st) {
    crew c = {.r = r, .o = o};
    double started = tr_run_clock();
    *r = (tr_replay){0};
    bool ok = tr_replay_read(r, o->run, st) && choose_laws(r, o->elements, st) &&
              (r->Q = tr_alloc((size_t)r->n_rows * (size_t)r->n_columns, sizeof(double), st)) &&
              (r->rolled = tr_alloc((size_t)r->n_rows, sizeof(double), st)) && replay_all(&c, st);
    if (!ok) return false;
    int lives = 0, rows = 0;
    for (int k = 0; k < r->n_lives; k++)
        if (r->life[k].done) lives++, rows += r->life[k].n;
    if (!lives) return tr_status_fail(st, TR_NUMERICAL, "error: no contact of two disks could be replayed");
    tr_run_say(report, "contacts, rows", "%d, %d", lives, rows);
    tr_run_say(report, "mu, E_star, k_t", "%.4g, %.6g Pa, %.6g Pa (= pi E_star/(2 Lambda) at the mean P)", r->mu,
               r->E_star, r->k_t);
    tr_run_say(report, "wall time", "%.1f s, %d elements, %d jobs", tr_run_clock() - started, o->elements, o->jobs);
    if (atomic_load(&c.failed))
        tr_run_note(report, "%d contacts left out: the half-plane has no answer (is a below the depth?)",
                    atomic_load(&c.failed));
    return true;
}

void tr_replay_free(tr_replay *r) {
    tr_scene_free(&r->scene), tr_scene_free(&r->contact);
    free(r->row), free(r->life), free(r->Q), free(r->rolled);
    *r = (tr_replay){0};
}
