/* SPDX-License-Identifier: MIT */
#include "scene/check.h"
#include "base/math.h"
#include "scene/tables.h"
#include "scene/what.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct checker {
    const tr_resolver *r;
    tr_scene *scene;
} checker;

const tr_scope *tr_check_scope(const tr_resolver *r, const char *section, int item) {
    for (int i = 0; i < r->n_scopes; i++)
        if (r->scopes[i].item == item && !*r->scopes[i].sub && strcmp(r->scopes[i].section, section) == 0)
            return &r->scopes[i];
    return NULL;
}

/* A law is for one shape, and some choices of its parameters are not for assemblies. */
static bool check_law(const checker *c, const tr_scope *s, const char *slot, const tr_param_table *law) {
    const tr_entry *e = tr_resolve_entry(s, slot);
    tr_mark mark = e->node ? e->node->mark : s->mark;
    unsigned wrong = c->scene->shape == TR_SHAPE_SPHERE ? TR_ONLY_DISKS : TR_ONLY_SPHERES;
    if (law->demands & wrong)
        return tr_text_fail(c->r->st, mark, "the law %s is for %s, and `shape` is %s", law->name,
                            wrong == TR_ONLY_DISKS ? "disks" : "spheres", wrong == TR_ONLY_DISKS ? "sphere" : "disk");
    if (law->demands & TR_ONLY_DRIVER && c->scene->kind != TR_KIND_CONTACT)
        return tr_text_fail(c->r->st, mark, "the law %s is for `kind: contact` only", law->name);
    for (int i = 0; i < law->n && law->driver_choice && c->scene->kind != TR_KIND_CONTACT; i++) {
        const tr_param *p = &law->params[i];
        const tr_entry *choice = p->type == TR_CHOICE ? tr_resolve_entry(s, p->key) : NULL;
        if (choice && choice->node && strcmp(choice->node->text, law->driver_choice) == 0)
            return tr_text_fail(c->r->st, choice->node->mark, "`%s: %s` of the law %s is for `kind: contact` only",
                                p->key, law->driver_choice, law->name);
    }
    return true;
}

/* The place of a key, or the place where it should be. */
static tr_mark mark_in(const tr_scope *s, const char *key) {
    const tr_entry *e = tr_resolve_entry(s, key);
    return e && e->node ? e->node->mark : s->mark;
}

/* The same of segment i. */
static tr_mark mark_of(const checker *c, int i, const char *key) {
    return mark_in(tr_check_scope(c->r, "path", i), key);
}

/* The approach of a line contact counts from a depth d: a contact must be narrower. At a = d the overlap is (1 + ln
 * 4)/4 d^2/R. `where` presses it. */
static bool check_depth(const checker *c, double d, double E_star, const char *where) {
    double R = c->scene->pair.R_star;
    for (int i = 0; i < c->scene->n_segments; i++) {
        const tr_scene_segment *g = &c->scene->path[i];
        double a = sqrt(4 * g->force * R / (M_PI * E_star));
        bool by_force = !isnan(g->force), deep = by_force ? a < d : g->overlap < (0.25 + M_LN2 / 2) * d * d / R;
        const char *key = by_force ? "force" : "overlap";
        if (!deep)
            return tr_text_fail(
                c->r->st, mark_of(c, i, key),
                "this presses the contact%s as wide as its depth, %.3g m; give a smaller %s or a larger "
                "`%sdepth` or `%sLambda`",
                where, d, key, *where ? "bodies." : "", *where ? "bodies." : "");
    }
    return true;
}

static bool check_law_depth(const checker *c, const tr_scope *s) {
    const tr_entry *depth = tr_resolve_entry(s, "depth"), *E_star = tr_resolve_entry(s, "E_star");
    if (!depth || depth->law) return true; /* its law is not chosen */
    const tr_scene_pair *pair = &c->scene->pair;
    double d = *(double *)depth->value;
    if (d == 0) d = 2 * sqrt(pair->R1 * pair->R2) / M_E; /* which 0 stands for */
    char where[32];
    snprintf(where, sizeof where, " of `laws.%d`", s->item);
    return check_depth(c, d, *(double *)E_star->value, where);
}

/* The data that a law needs of a prescribed path. */
static bool check_demands(const checker *c, const tr_scope *s, const char *slot, const tr_param_table *law,
                          const void *par) {
    const tr_scene *scene = c->scene;
    unsigned demands = tr_param_demands(law, par);
    if (demands & TR_NEEDS_DENSITY && scene->pair.density == 0)
        return tr_text_fail(c->r->st, tr_check_scope(c->r, "bodies", -1)->mark,
                            "`bodies.density` is missing: %s law %s of `%s.%d` depends on the inertia of the bodies",
                            slot, law->name, s->section, s->item);
    for (int i = 0; i < scene->n_segments; i++) {
        const tr_scope *segment = tr_check_scope(c->r, "path", i);
        if (demands & TR_NEEDS_TIME && scene->path[i].time == 0)
            return tr_text_fail(c->r->st, segment->mark,
                                "`path.%d.time` is missing: %s law %s of `%s.%d` depends on the rate", i, slot,
                                law->name, s->section, s->item);
    }
    return true;
}

static bool check_laws(const checker *c, const tr_scope *s, const void *base) {
    for (int k = 0; k < TR_LAW_KINDS; k++) {
        tr_law_place slot = tr_tables_law_kind(c->r->catalog, k);
        const tr_scene_law *law = (const void *)((const char *)base + slot.offset);
        const tr_param_table *table = slot.laws[law->law];
        if (!check_law(c, s, slot.key, table)) return false;
        bool driven = c->scene->kind == TR_KIND_CONTACT && k > 0; /* its normal force is only elastic */
        if (driven && !check_demands(c, s, slot.key, table, law->par)) return false;
    }
    return c->scene->kind != TR_KIND_CONTACT || check_law_depth(c, s);
}

/* What the closed forms leave out. */
static bool check_closed_form(const checker *c, int i) {
    const tr_scene_segment *g = &c->scene->path[i], *first = c->scene->path;
    if (c->scene->patch.solver == TR_CARTER && g->roll == 0)
        return tr_text_fail(c->r->st, tr_check_scope(c->r, "path", i)->mark,
                            "`solver: carter` is for steady rolling: `path.%d` does not roll", i);
    if (c->scene->patch.solver != TR_CATTANEO) return true;
    bool by_force = !isnan(g->tangential);
    double way = by_force ? g->tangential - (i ? g[-1].tangential : 0) : g->slide, once = first->slide;
    if (!isnan(first->tangential)) once = first->tangential;
    bool mixed = by_force != !isnan(first->tangential);
    if (g->roll != 0 || g->force != first->force || mixed || way * once < 0)
        return tr_text_fail(
            c->r->st, tr_check_scope(c->r, "path", i)->mark,
            "`solver: cattaneo` is for sliding one way from rest, at constant force, without rolling, all "
            "by `slide` or all by `tangential`: take half-plane for `path.%d`",
            i);
    return true;
}

/* d from Lambda at the force of the first segment; no more friction than there can be. */
static bool check_patch(const checker *c) {
    tr_scene *scene = c->scene;
    tr_scene_pair *pair = &scene->pair;
    pair->d = pair->depth;
    if (scene->path_file && (scene->patch.solver == TR_CARTER || scene->patch.solver == TR_CATTANEO))
        return tr_text_fail(c->r->st, tr_resolve_entry(c->r->scopes, "solver")->node->mark,
                            "the closed forms are not for any path: with `path: FILE` take half-plane or brush");
    if (scene->path_file) return true; /* which is looked at when it is read */
    double P = scene->path[0].force, mu = scene->patch.mu;
    if (P == 0)
        return tr_text_fail(c->r->st, mark_of(c, 0, "force"),
                            "there is no contact to begin with: give a force above 0");
    pair->d = isnan(pair->depth) ? sqrt(4 * P * pair->R_star / (M_PI * pair->E_star)) * tr_exp(pair->Lambda) / 2
                                 : pair->depth;
    if (!check_depth(c, pair->d, pair->E_star, "")) return false;
    for (int i = 0; i < scene->n_segments; i++) {
        const tr_scene_segment *g = &scene->path[i];
        if (fabs(g->tangential) > mu * g->force * (1 + 1e-12))
            return tr_text_fail(c->r->st, mark_of(c, i, "tangential"),
                                "the contact slides: `tangential` is %.6g N/m, and mu times the force only %.6g N/m",
                                g->tangential, mu * g->force);
        if (!check_closed_form(c, i)) return false;
    }
    return true;
}

/* Walls and disks that a key names. */
static bool check_contact_ids(const checker *c, const tr_scope *s, const char *key, const tr_contact_ids *picks) {
    const tr_scene *scene = c->scene;
    int walls = scene->kind == TR_KIND_BIAXIAL ? (scene->boundary == TR_PERIODIC ? 0 : 4) : scene->n_walls;
    int disks = scene->kind == TR_KIND_BIAXIAL ? scene->sample.disks : scene->n_disks;
    const tr_entry *e = tr_resolve_entry(s, key);
    if (!e) return true; /* not for this kind of case, not with this choice */
    const tr_node *node = e->node && e->node->type == TR_NODE_LIST ? e->node->child : e->node;
    for (int i = 0; i < picks->n && node; i++, node = node->next) { /* as many nodes as picks */
        tr_contact_id pick = picks->item[i];
        if (pick.b < disks && pick.a >= -walls) continue;
        return tr_text_fail(c->r->st, node->mark, "there is no contact `%s`: disks count from 0 to %d, walls are %d",
                            node->text, disks - 1, walls);
    }
    return true;
}

/* What only walls, only a periodic cell has. */
static bool check_boundary(const checker *c, const tr_scope *s) {
    const tr_scene *scene = c->scene;
    if (scene->boundary == TR_PERIODIC && scene->shear.walls)
        return tr_text_fail(c->r->st, mark_in(s, "walls"),
                            "`boundary: periodic` has no walls: `walls: rough` is not allowed");
    if (scene->boundary == TR_WALLS && scene->shear.hold)
        return tr_text_fail(c->r->st, mark_in(s, "hold"),
                            "the lateral walls hold their own pressure: `hold: mean` takes `boundary: periodic`");
    return true;
}

static bool check_output(const checker *c, const tr_scope *s) {
    const tr_scene *scene = c->scene;
    if (scene->output.still > scene->time_end)
        return tr_text_fail(c->r->st, mark_in(s, "still"), "`still` is %.9g s, after `time_end`, which is %.9g s",
                            scene->output.still, scene->time_end);
    const tr_contact_ids *shown = &scene->output.contact;
    if (shown->n && shown->item[0].a == shown->item[0].b)
        return tr_text_fail(c->r->st, mark_in(s, "contact"),
                            "the panel shows one contact, named as 0-1 (two disks) or wall0-1 (wall 0, disk 1)");
    return check_contact_ids(c, s, "contact", shown) && check_contact_ids(c, s, "paths", &scene->output.paths);
}

/* A ring holds what is inside of it: smaller, and no deeper in the ring than a contact may be (0.3 of its radius). What
 * is outside is clear of it. */
static bool check_ring(const checker *c, const tr_scope *ring, int i) {
    const tr_scene_disk *r = &c->scene->disks[ring->item], *d = &c->scene->disks[i];
    const tr_scope *s = tr_check_scope(c->r, "disks", i);
    double apart = tr_hypot(d->x - r->x, d->y - r->y), out = apart + d->radius - r->radius;
    if (apart >= r->radius && apart - d->radius < r->radius + r->ring)
        return tr_text_fail(
            c->r->st, mark_in(s, "x"),
            "`disks.%d` lies across the ring `disks.%d`: its centre is %.6g m from that of the ring, whose "
            "inside ends at %.6g m; put it inside, or clear of the ring",
            i, ring->item, apart, r->radius);
    if (apart >= r->radius) return true;
    if (d->radius >= r->radius)
        return tr_text_fail(c->r->st, mark_in(s, "radius"),
                            "`disks.%d` is as large as the ring `disks.%d` or larger, %.6g m against %.6g m inside; a "
                            "disk in a ring is smaller",
                            i, ring->item, d->radius, r->radius);
    return out <= 0.3 * d->radius ||
           tr_text_fail(
               c->r->st, mark_in(s, "x"),
               "`disks.%d` overlaps the ring `disks.%d` by %.6g m, more than 0.3 of its radius, %.6g m; move it "
               "towards (%.6g, %.6g)",
               i, ring->item, out, d->radius, r->x, r->y);
}

static bool check_rings(const checker *c, const tr_scope *s) {
    const tr_scene *scene = c->scene;
    if (scene->disks[s->item].ring == 0) return true;
    if (s->item > 0 && scene->disks[s->item - 1].ring == 0)
        return tr_text_fail(c->r->st, mark_in(s, "ring"),
                            "rings come first in the list: put `disks.%d` in front of the disks", s->item);
    if (scene->disks[scene->n_disks - 1].ring > 0)
        return tr_text_fail(c->r->st, mark_in(s, "ring"), "there are only rings: a ring takes a disk inside");
    for (int i = s->item + 1; i < scene->n_disks; i++)
        if (scene->disks[i].ring == 0 && !check_ring(c, s, i)) return false;
    return true;
}

static bool check_disk(const checker *c, const tr_scope *s) {
    const tr_scene_disk *d = &c->scene->disks[s->item];
    if (!check_rings(c, s)) return false;
    if (d->torque == 0 || d->motion == TR_FREE || d->motion == TR_PINNED) return true;
    return tr_text_fail(c->r->st, mark_in(s, "torque"),
                        "a torque does nothing to `disks.%d`, whose motion keeps its spin: take free or pinned",
                        s->item);
}

/* A path in a file is not read yet: study/path.c looks at its rows. */
static bool check_on_path(const checker *c, const tr_scope *s) {
    const tr_scene *scene = c->scene;
    const tr_scene_check *check = &scene->checks[s->item];
    if (scene->kind == TR_KIND_CONTACT && check->law >= scene->n_laws)
        return tr_text_fail(c->r->st, mark_in(s, "law"), "there is no `laws.%d`: laws count from 0 to %d", check->law,
                            scene->n_laws - 1);
    if (!scene->path_file && check->segment >= scene->n_segments)
        return tr_text_fail(c->r->st, mark_in(s, "segment"),
                            "there is no `path.%d`: segments count from 0 to %d, and -1 is the last", check->segment,
                            scene->n_segments - 1);
    return true;
}

static bool check_check(const checker *c, const tr_scope *s) {
    if (c->scene->kind != TR_KIND_BODIES) return check_on_path(c, s);
    const tr_scene *scene = c->scene;
    const tr_scene_check *check = &scene->checks[s->item];
    if (check->disk >= scene->n_disks)
        return tr_text_fail(c->r->st, mark_in(s, "disk"), "there is no disk %d: disks count from 0 to %d", check->disk,
                            scene->n_disks - 1);
    if (check->at > scene->time_end)
        return tr_text_fail(c->r->st, mark_in(s, "at"), "`at` is %.9g s, after `time_end`, which is %.9g s", check->at,
                            scene->time_end);
    if (check->over > check->at)
        return tr_text_fail(c->r->st, mark_in(s, "over"), "`over` is %.9g s, longer than the time up to `at`, %.9g s",
                            check->over, check->at);
    if (check->contact.n && check->contact.item[0].a == check->contact.item[0].b)
        return tr_text_fail(c->r->st, mark_in(s, "contact"),
                            "a check is of one contact, named as 0-1 (two disks) or wall0-1 (wall 0, disk 1)");
    bool threshold = tr_whats[check->what].when == TR_SLOPE;
    const char *lacks = scene->n_walls == 0                              ? "a wall"
                        : scene->gravity.x == 0 && scene->gravity.y == 0 ? "gravity"
                        : scene->disks[check->disk].motion != TR_FREE    ? "a free disk"
                                                                         : NULL;
    if (threshold && lacks)
        return tr_text_fail(c->r->st, mark_in(s, "what"), "a slope to stand on takes %s, which is not there", lacks);
    if (threshold && !(check->exact >= 0 && check->exact < 85 * M_PI / 180))
        return tr_text_fail(c->r->st, mark_in(s, "exact"),
                            "a slope is looked for from 0 to 85 degrees, and `exact` is %.4g rad", check->exact);
    return check_contact_ids(c, s, "contact", &check->contact);
}

/* Two walls in one line, one of them with ends, may lie one on the other: a disk would touch both. Walls before this
 * one have their normals made. */
static bool check_apart(const checker *c, const tr_scope *s) {
    const tr_scene_wall *w = &c->scene->walls[s->item];
    for (int i = 0; i < s->item; i++) {
        const tr_scene_wall *v = &c->scene->walls[i];
        double dx = w->x - v->x, dy = w->y - v->y, same = w->nx * v->nx + w->ny * v->ny < 0 ? -1 : 1;
        double first = dx * v->ny - dy * v->nx, least = fmin(same * w->from, same * w->to) + first,
               most = fmax(same * w->from, same * w->to) + first, low = fmax(v->from, least), high = fmin(v->to, most);
        bool ends = fmin(fmin(fabs(w->from), fabs(w->to)), fmin(fabs(v->from), fabs(v->to))) < TR_ENDLESS;
        bool in_line = fabs(w->nx * v->ny - w->ny * v->nx) < 1e-9 && fabs(dx * v->nx + dy * v->ny) < 1e-9;
        if (ends && in_line && high - low > 1e-9)
            return tr_text_fail(c->r->st, s->mark,
                                "`walls.%d` lies on `walls.%d` over %.3g m: a disk there would touch both; let one end "
                                "where the other begins",
                                s->item, i, high - low);
    }
    return true;
}

/* A normal that is already 1 long to rounding stays as it is: what was written reads back bit for bit. */
static bool check_wall(const checker *c, const tr_scope *s) {
    tr_scene_wall *wall = &c->scene->walls[s->item];
    double length = tr_hypot(wall->nx, wall->ny);
    if (length < 1e-9) return tr_text_fail(c->r->st, s->mark, "the normal (nx, ny) of `walls.%d` is zero", s->item);
    if (fabs(length - 1) > 4 * DBL_EPSILON) wall->nx /= length, wall->ny /= length;
    if (!(wall->to > wall->from))
        return tr_text_fail(c->r->st, mark_in(s, tr_tree_find(s->node, "to") ? "to" : "from"),
                            "`walls.%d` has no length: it begins at `from`, %.9g m, and ends at `to`, %.9g m", s->item,
                            wall->from, wall->to);
    return check_apart(c, s);
}

/* A mapping in an item. */
static bool check_inner(const checker *c, const tr_scope *s) {
    if (strcmp(s->sub, "contact") == 0) return check_laws(c, s, &c->scene->walls[s->item].contact);
    const tr_scene_disk *d = &c->scene->disks[s->item];
    if (d->motion == TR_FREE || d->motion == TR_PINNED || d->motion == TR_DRIVEN) return true;
    return tr_text_fail(c->r->st, mark_in(s, "force"),
                        "a pull does nothing to `disks.%d`, whose motion is given: take free, pinned or driven",
                        s->item);
}

/* "no | yes | it depends": the answers that a class chooses from. */
static bool check_lesson(const checker *c, const tr_scope *s) {
    const tr_scene_lesson *l = &c->scene->lesson;
    int n = *l->choices != 0;
    for (const char *p = l->choices; *p; p++) n += *p == '|';
    if (n && (n < 2 || n > 4))
        return tr_text_fail(c->r->st, mark_in(s, "choices"),
                            "`choices` has %d answers; allowed are 2 to 4, with | between them", n);
    if (!n ? l->right == 0 : l->right >= 1 && l->right <= n) return true;
    return tr_text_fail(c->r->st, mark_in(s, l->right ? "right" : "choices"),
                        "`right` is %d, and there are %d choices: it is the number of the right one, from 1", l->right,
                        n);
}

/* What no single row can say. */
bool tr_check_together(const tr_resolver *r, tr_scene *scene) {
    const checker checker = {r, scene}, *c = &checker;
    if (c->scene->kind == TR_KIND_PATCH && !check_patch(c)) return false;
    for (int i = 0; i < c->r->n_scopes; i++) {
        const tr_scope *s = &c->r->scopes[i];
        const tr_scene_sample *sample = &c->scene->sample;
        if (*s->sub) {
            if (!check_inner(c, s)) return false;
            continue;
        }
        if (strcmp(s->section, "contact") == 0 && !check_laws(c, s, &c->scene->contact)) return false;
        if (strcmp(s->section, "shear") == 0 && !check_boundary(c, s)) return false;
        if (strcmp(s->section, "lesson") == 0 && !check_lesson(c, s)) return false;
        if (strcmp(s->section, "output") == 0 && !check_output(c, s)) return false;
        if (strcmp(s->section, "disks") == 0 && !check_disk(c, s)) return false;
        if (strcmp(s->section, "checks") == 0 && !check_check(c, s)) return false;
        if (strcmp(s->section, "laws") == 0 && !check_laws(c, s, &c->scene->laws[s->item])) return false;
        if (strcmp(s->section, "sample") == 0 && sample->r_min > sample->r_max)
            return tr_text_fail(c->r->st, tr_resolve_entry(s, "r_min")->node->key_mark,
                                "`sample.r_min` is %.9g m, more than `sample.r_max`, which is %.9g m", sample->r_min,
                                sample->r_max);
        if (strcmp(s->section, "walls") == 0 && !check_wall(c, s)) return false;
    }
    return true;
}
