/* SPDX-License-Identifier: MIT */
/* All that a converge leaves in its directory. */
#ifndef TR_STUDY_CONVERGE_TABLES_H
#define TR_STUDY_CONVERGE_TABLES_H

#include "study/converge_data.h"

/* converge.csv: a row of each number and cause; levels.csv: a row of each number, cause and level; converge.md,
 * comment.txt, pictures. *text: as converge.md (free()). */
bool tr_converge_write(tr_converge *c, char **text, tr_status *st);

#endif
