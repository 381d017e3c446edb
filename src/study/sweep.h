/* SPDX-License-Identifier: MIT */
/* Sweeps: `trundle run` for each point of a grid of values, and statistics over the seeds.
 *
 * A sweep file is YAML with places (scene/tree.h):
 *
 *     kind: sweep
 *     base: biaxial.yaml            # relative to the folder of this file
 *     seeds: 1-8                    # or [1, 2, 5]
 *     vary: {contact.mu_r: [0, 0.2], shear.inertial_number: {from: 1e-4, to: 1e-2, points: 5, scale: log}}
 *     set: {output.frames: 0}       # the same for all points
 *     compare: {key: contact.mu_r, to: 0}                       # or a list of such
 *     collect: [sin_phi_peak]       # numbers of summary.json
 *
 * Every value stays text: a point is a list of --sets, and the reader of cases interprets them.
 *
 * Points are numbered with the seed slowest, then the first key of `vary`: points that can share a sample follow each
 * other, and a stopped sweep has complete comparisons of its first seeds.
 *
 * A point has a directory, named after its values, so that a further value in the file does not move the others. A
 * point is finished if its summary.json (which a run writes last) is complete, of this version of the program, and has
 * the collected numbers, and if case.yaml has the bytes of its resolved case. There is no other record of finished
 * points, so none can be out of date. */
#ifndef TR_STUDY_SWEEP_H
#define TR_STUDY_SWEEP_H

#include "scene/scene.h"
#include "scene/tree.h"

/* A key of the base case and the texts of its values. */
typedef struct tr_axis {
    const char *key;
    tr_mark key_mark;
    char **value;
    tr_mark *mark; /* of each value; of a range: of the whole */
    int n;
} tr_axis;

/* All points except those of one value of an axis. */
typedef struct tr_compare {
    int axis, to;
} tr_compare;

typedef struct tr_grid {
    tr_source source;
    char *text;
    tr_node *root;
    char *base;                  /* path of the base case */
    tr_axis *axis;               /* `vary`, `seeds`, `set` */
    int n_vary, n_named, n_axes; /* named: `vary` and `seeds`; of `set` every axis has one value */
    int combinations, seeds, n;  /* of the values of `vary`; at least 1; their product, the number of points */
    const char **collect;
    tr_mark *collect_mark;
    int n_collect;
    tr_compare *compare;
    int n_compare;
} tr_grid;

/* The value of an axis at a point. */
int tr_grid_value(const tr_grid *g, int point, int axis);

/* The combination with another value of one axis. */
int tr_grid_with(const tr_grid *g, int combination, int axis, int value);

/* "mu_r=0.2,rolling_velocity=wang,seed=3": the last part of each key, or enough to be unique. Characters that are not
 * allowed in a file name become `_`. Then, and if the name is too long, a hash of the whole follows. */
enum { TR_POINT_NAME = 256 };
void tr_grid_name(const tr_grid *g, int point, char name[TR_POINT_NAME]);

/* Its --sets, "key=value", n_axes of them; free each, and the array. */
char **tr_grid_sets(const tr_grid *g, int point, tr_status *st);
void tr_grid_sets_free(const tr_grid *g, char **sets);

/* Reads the case of a point. A failure names the point, and the place of the value in the sweep file. */
bool tr_grid_scene(const tr_grid *g, int point, tr_scene *scene, tr_status *st);

/* The same of a point for each value. Which values go together a run tells. */
bool tr_grid_scenes(const tr_grid *g, tr_status *st);

/* BEGUN: this run, but not finished. The states between BEGUN and FINISHED have a summary.json and run again: of
 * another case; with a summary that cannot be read; of another version of the program; without a number to collect. */
typedef enum tr_point_state {
    TR_POINT_MISSING,
    TR_POINT_BEGUN,
    TR_POINT_OTHER,
    TR_POINT_BROKEN,
    TR_POINT_OLD,
    TR_POINT_LACKING,
    TR_POINT_FINISHED
} tr_point_state;

/* The state of the directory of a point. Reads the case of the point. */
bool tr_grid_state(const tr_grid *g, int point, const char *dir, tr_point_state *state, tr_status *st);

/* Finds, before a run, the errors of tr_run_check and missing numbers to collect. A point of the first seed stands for
 * all seeds, because a seed changes only the sample. */
bool tr_grid_check(const tr_grid *g, int point, tr_status *st);

#endif
