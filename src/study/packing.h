/* SPDX-License-Identifier: MIT */
/* sample.bin: a packing after its compaction, from which many runs start. Positions and velocities of disks and walls
 * and, where compaction.mu is above 0, the contacts with their friction, which the shear begins with.
 * The file is one of base/checkpoint.h, and its case is what the compaction sees of a scene: the packing of another
 * seed, size, normal law or pressure is refused, and a run from the file gives the bytes of a run without. */
#ifndef TR_STUDY_PACKING_H
#define TR_STUDY_PACKING_H

#include "core/biaxial.h"
#include "study/report.h"

/* The case.yaml of the compaction alone, and which packings this program makes; free it. Equal texts, equal packings. */
char *tr_packing_text(const tr_scene *scene, tr_status *st);

/* Finds, before a run touches its directory, that the file is of another case or damaged, or that there is no place for it (TR_FILE). */
bool tr_packing_check(const tr_scene *scene, const char *path, tr_status *st);

/* One file, for one of the runs that want it at once. */
typedef struct tr_packing {
    char *text, *dir, *name, *part;
    int lock; /* on the part: this run makes the packing, others wait */
} tr_packing;

/* Loads options->sample into a test that has been initialised; *there: it was there. Where it is not, this run is to make it and to
 * call tr_packing_save; another run that is making it is waited for. Refused (TR_FILE): a damaged file, or one of
 * another case. */
bool tr_packing_load(tr_packing *p, tr_biaxial *b, const tr_run_options *options, double *unbalanced, bool *there,
                     tr_status *st);
bool tr_packing_save(tr_packing *p, tr_biaxial *b, double *unbalanced, tr_status *st);
void tr_packing_close(tr_packing *p);

#endif
