/* SPDX-License-Identifier: MIT */
/* sample.bin: a packing after its compaction, from which many runs start. Positions and velocities of disks and walls
 * and, where compaction.mu is above 0, the contacts with their friction, which the shear begins with.
 * The file is one of base/checkpoint.h, and its case has the keys that the compaction uses. The packing of another
 * seed, size, normal law or pressure is refused. A run from the file gives the same bytes as a run without it. */
#ifndef TR_STUDY_PACKING_H
#define TR_STUDY_PACKING_H

#include "core/biaxial.h"
#include "study/report.h"

/* The case.yaml of the compaction only, with the version of packings; free it. Equal texts mean equal packings. */
char *tr_packing_text(const tr_scene *scene, tr_status *st);

/* Finds, before a run changes its directory, that the file is of another case or damaged, or cannot be written
 * (TR_FILE). */
bool tr_packing_check(const tr_scene *scene, const char *path, tr_status *st);

/* One file, for one of the runs that want it at once. */
typedef struct tr_packing {
    char *text, *dir, *name, *part;
    int lock; /* on the part: this run makes the packing, others wait */
} tr_packing;

/* Loads options->sample into a test that has been initialised; *there: the file existed. If not, this run must make it
 * and call tr_packing_save; if another run is making it, this one waits. Refused (TR_FILE): a damaged file, or one of
 * another case. */
bool tr_packing_load(tr_packing *p, tr_biaxial *b, const tr_run_options *options, double *unbalanced, bool *there,
                     tr_status *st);
bool tr_packing_save(tr_packing *p, tr_biaxial *b, double *unbalanced, tr_status *st);
void tr_packing_close(tr_packing *p);

#endif
