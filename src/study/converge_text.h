/* SPDX-License-Identifier: MIT */
/* What a converge tells: tables, sentences, lines to paste. */
#ifndef TR_STUDY_CONVERGE_TEXT_H
#define TR_STUDY_CONVERGE_TEXT_H

#include "study/converge_data.h"

/* What would run and about how long it takes (free()). */
char *tr_converge_plan(const tr_converge *c, tr_status *st);

/* converge.md, which is *text too (free()), and comment.txt, a block for the case. */
bool tr_converge_write_text(const tr_converge *c, char **text, tr_status *st);

#endif
