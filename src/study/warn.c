/* SPDX-License-Identifier: MIT */
#include "study/warn.h"
#include "base/math.h"

#include "core/fit.h"
#include "core/resolution.h"
#include "core/tangent.h"
#include <math.h>
#include <stdio.h>

enum { NAMES = 80 };

/* "disks 0 and 1", "wall 0 and disk 1", "ring 0 and disk 1" */
static void name_pair(const tr_world *world, int a, int b, char text[NAMES]) {
    const char *format = a < 0                ? "wall %d and disk %d"
                         : a < world->n_rings ? "ring %d and disk %d"
                                              : "disks %d and %d";
    snprintf(text, NAMES, format, a < 0 ? -1 - a : a, b);
}

static void warn_tangent(const tr_bodies *b, const char *of, tr_run_report *report) {
    tr_tangent t;
    char names[NAMES], more[60] = "";
    if (!tr_tangent_find(b, &t)) return;
    name_pair(&b->world, t.a, t.b, names);
    if (t.more) snprintf(more, sizeof more, "; so do %d more pair%s", t.more, t.more > 1 ? "s" : "");
    const char *unit = b->world.shape == TR_SHAPE_SPHERE ? "N" : "N/m";
    if (t.weight)
        tr_run_note(report,
                    "%s%s only touch (gap %.2g m): the run begins with a fall. The weight needs an overlap of %.4g m; "
                    "give disk %d x: %.12g, y: %.12g%s",
                    of, names, t.gap, t.overlap, t.moved, t.x, t.y, more);
    else
        tr_run_note(report,
                    "%s%s only touch (gap %.2g m) and nothing presses them: they may not be in contact at all. An "
                    "overlap of %.4g m presses them with %.4g %s; give disk %d x: %.12g, y: %.12g%s",
                    of, names, t.gap, t.overlap, t.force, unit, t.moved, t.x, t.y, more);
}

static void warn_resolution(const tr_bodies *b, const char *of, tr_run_report *report) {
    tr_resolution r;
    char names[NAMES];
    if (tr_resolution_overlap(b, &r)) {
        name_pair(&b->world, r.a, r.b, names);
        tr_run_note(
            report,
            "%s%s: numbers near %.4g m are %.2g m apart, and an overlap of about %.2g m is made of them: it may "
            "be off by %.2g of itself. Stay nearer to the origin (0, 0), or take softer contacts",
            of, names, r.reach, r.spacing, r.size, r.spacing / r.size);
    }
    if (tr_resolution_way(b, &r)) {
        tr_run_note(
            report,
            "%s%s %d moves by %.2g m a step, and numbers near %.4g m are %.2g m apart: its way may be off by %.2g "
            "of itself. Stay nearer to the origin (0, 0), or take a larger step.dt",
            of, r.b < 0 ? "wall" : "disk", r.b < 0 ? -1 - r.b : r.b, r.size, r.reach, r.spacing,
            fmin(1, 0.5 * r.spacing / r.size));
    }
}

/* of, more: in front and behind, or "". where: of the force, and "" or the disks. */
static void warn_fit(const tr_fit *f, const char *of, const char *where, const char *more, tr_run_report *report) {
    if (f->fits == 0) {
        tr_run_note(
            report,
            "%sE_star is too small for a line contact%s (%.3g N/m): its half-width %.3g m is not below twice its "
            "depth, d = %.3g m. Set a larger E_star%s",
            of, where, f->P, f->a, f->d, more);
        return;
    }
    tr_run_note(report,
                "%s%s = %.4g Pa does not fit E_star and depth. A line contact has pi E_star/(2 ln(2d/a)) = %.4g Pa%s "
                "(%.3g N/m, depth d = %.3g m). Set %s: %.4g Pa, or change E_star%s",
                of, f->key, f->k, f->fits, where, f->P, f->d, f->key, f->fits, more);
}

static void warn_fit_bodies(const tr_bodies *b, const char *of, tr_run_report *report) {
    tr_fit f;
    char names[NAMES], where[NAMES + 8], more[60] = "";
    if (!tr_fit_bodies(b, &f)) return;
    name_pair(&b->world, f.one, f.two, names);
    snprintf(where, sizeof where, " of %s", names);
    if (f.more) snprintf(more, sizeof more, ". The same for %d more pair%s", f.more, f.more > 1 ? "s" : "");
    warn_fit(&f, of, where, more, report);
}

/* Gravity that points away from all walls, which are there to carry the disks. */
static void warn_gravity(const tr_bodies *b, const char *of, tr_run_report *report) {
    const tr_scene *scene = b->scene;
    bool away = scene->n_walls > 0 && scene->gravity.turn == 0, free = false;
    for (int i = 0; i < scene->n_walls; i++)
        away &= scene->gravity.x * scene->walls[i].nx + scene->gravity.y * scene->walls[i].ny > 0;
    for (int i = 0; i < scene->n_disks; i++) free |= scene->disks[i].motion == TR_FREE;
    if (away && free)
        tr_run_note(
            report,
            "%sgravity (%g, %g) m/s^2 points away from %s: disks fly off. Down is negative: gravity: {y: -9.81}", of,
            scene->gravity.x, scene->gravity.y, scene->n_walls > 1 ? "all walls" : "the wall");
}

void tr_warn_bodies(const tr_bodies *b, const char *label, tr_run_report *report) {
    char of[64] = "";
    if (*label) snprintf(of, sizeof of, "%s: ", label);
    warn_gravity(b, of, report);
    warn_tangent(b, of, report);
    warn_resolution(b, of, report);
    warn_fit_bodies(b, of, report);
}

void tr_warn_biaxial(const tr_biaxial *b, tr_run_report *report) {
    tr_resolution r;
    if (tr_resolution_biaxial(b, &r))
        tr_run_note(
            report,
            "contacts are too stiff for the pressure: numbers across the sample, %.2g m, are %.2g m apart, and a "
            "mean overlap of %.2g m is made of them: it may be off by %.2g of itself",
            r.reach, r.spacing, r.size, r.spacing / r.size);
    tr_fit f;
    if (tr_fit_biaxial(b, &f)) warn_fit(&f, "", " at the mean force to expect in the shear", "", report);
}

/* Over the steps with a contact; 0: none. */
static double mean_force(const tr_scene *played, const tr_scene_law *normal) {
    const tr_law *law = tr_laws_normal[normal->law];
    const tr_scene_pair *pair = &played->pair;
    double sum = 0, steps = 0, before = NAN;
    for (int i = 0; i < played->n_segments; i++) {
        const tr_scene_segment *g = &played->path[i];
        double P =
            isnan(g->force) ? law->elastic(normal->par, pair->R1, pair->R2, fmax(g->overlap, 0)).force : g->force;
        double mean = isnan(before) ? P : 0.5 * (before + P);
        if (mean > 0) sum += g->steps * mean, steps += g->steps;
        before = P;
    }
    return steps > 0 ? sum / steps : 0;
}

/* As given, or from Lambda at the force of the first segment; 0: not given. */
static double depth_of(const tr_scene *played) {
    const tr_scene_pair *pair = &played->pair;
    if (!isnan(pair->depth)) return pair->depth;
    double a = tr_law_width(TR_SHAPE_DISK, played->path[0].force, pair->R_star, pair->E_star);
    return isnan(a * pair->Lambda) ? 0 : 0.5 * a * tr_exp(pair->Lambda);
}

void tr_warn_contact(const tr_scene *played, tr_run_report *report) {
    const tr_scene_pair *pair = &played->pair;
    tr_fit first, now;
    int n = 0, which = 0;
    for (int i = 0; played->shape == TR_SHAPE_DISK && i < played->n_laws; i++) {
        const tr_scene_contact *laws = &played->laws[i];
        double P = mean_force(played, &laws->normal);
        if (!tr_fit_contact(laws, pair->R1, pair->R2, pair->E_star, depth_of(played), P, &now)) continue;
        if (n++ == 0) first = now, which = i;
    }
    if (!n) return;
    char of[32], more[60] = "";
    snprintf(of, sizeof of, "laws.%d: ", which);
    if (n > 1) snprintf(more, sizeof more, ". The same for %d more law%s", n - 1, n > 2 ? "s" : "");
    warn_fit(&first, of, " at the mean force of the path", more, report);
}
