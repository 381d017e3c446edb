/* SPDX-License-Identifier: MIT */
#include "study/identify.h"

#include "base/alloc.h"
#include <math.h>
#include <stdlib.h>

static bool make_states(tr_identify *w, tr_status *st) {
    const tr_identify_table *t = &w->table;
    bool pairs = false, walls = false;
    tr_motion *motion = tr_alloc((size_t)t->n, sizeof *motion, st);
    if (!motion) return false;
    for (int i = 0; i < t->n; i++) {
        motion[i] = t->row[i].motion;
        if (isinf(motion[i].R1))
            walls = true;
        else
            pairs = true;
    }
    bool ok = tr_states_make(&w->states, motion, t->n, st) && tr_probes_make(&w->probes, pairs, walls, st);
    free(motion);
    return ok;
}

bool tr_identify_make(tr_identify *w, tr_status *st) {
    if (!tr_identify_read(&w->table, st) || !tr_questions_make(&w->questions, &w->table, st) || !make_states(w, st))
        return false;
    for (int k = 0; k < TR_QUESTIONS; k++)
        if (w->questions.of[k].n &&
            !tr_fit_question(&w->found.fit[k], &w->questions.of[k], &w->table, &w->states, &w->probes, st))
            return false;
    tr_identify_judge(w);
    return true;
}

void tr_identify_free(tr_identify *w) {
    free(w->table.row);
    tr_states_free(&w->states);
    tr_probes_free(&w->probes);
    tr_questions_free(&w->questions);
}
