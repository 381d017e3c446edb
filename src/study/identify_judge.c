/* SPDX-License-Identifier: MIT */
#include "study/identify_judge.h"

#include "laws/kinematics.h"
#include "laws/law.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const double NOTHING = 1e-6; /* of the greatest: what rounding of a file may leave */

__attribute__((format(printf, 2, 3))) static void reason(tr_identified *f, const char *format, ...) {
    va_list args;
    if (f->n_reasons == TR_MOST_FINDINGS) return;
    va_start(args, format);
    vsnprintf(f->reason[f->n_reasons++], TR_FINDING_WORDS, format, args);
    va_end(args);
}

__attribute__((format(printf, 2, 3))) static void note(tr_identified *f, const char *format, ...) {
    va_list args;
    if (f->n_notes == TR_MOST_FINDINGS) return;
    va_start(args, format);
    vsnprintf(f->note[f->n_notes++], TR_FINDING_WORDS, format, args);
    va_end(args);
}

static const tr_fit *asked(const tr_identified *f, int k) {
    return f->fit[k].question ? &f->fit[k] : NULL;
}
static const tr_fit *told(const tr_identified *f, int k) {
    const tr_fit *fit = asked(f, k);
    return fit && fit->fits ? fit : NULL;
}

static void answer(tr_answer *to, bool good) {
    if (!good)
        *to = TR_NO;
    else if (*to == TR_NOT_TOLD)
        *to = TR_YES;
}

/* ---- objective */

/* Of a rigid rotation w: what a form gives over w times the overlap, if that is one number; NAN: it is not. */
static double per_overlap(const tr_form *form) {
    double ratio = NAN;
    for (int k = 0; k < 4; k++) {
        double R1 = k % 2 ? 0.01 : 0.02, R2 = 0.01, overlap = k < 2 ? 1e-4 : 1e-3, L = R1 + R2 - overlap, w = 1;
        tr_motion m = {.R1 = R1, .R2 = R2, .x2x = L, .v2y = w * L, .w1 = w, .w2 = w};
        tr_states s;
        tr_status st = {0};
        double v = tr_states_make(&s, &m, 1, &st) ? tr_forms_value(form, &s, 0) / (w * overlap) : NAN;
        tr_states_free(&s);
        if (k && !(fabs(v - ratio) < 1e-6 * fabs(ratio))) return NAN;
        ratio = v;
    }
    return ratio;
}

static void judge_form(tr_identified *f, const tr_fit *fit) {
    char words[TR_FORM_WORDS];
    answer(&f->objective, fit->objective);
    if (fit->objective) return;
    double ratio = per_overlap(&fit->best);
    tr_forms_words(&fit->best, words);
    if (!isnan(ratio) && fabs(ratio) > 1e-9)
        reason(
            f,
            "not objective when disks overlap: %s = %s gives %.4g overlap*w in a rigid rotation by w, and depends on "
            "the observer",
            fit->question->name, words, ratio);
    else
        reason(f, "not objective: %s = %s depends on the observer", fit->question->name, words);
}

static void judge_observers(tr_identified *f, int k) {
    const tr_fit *fit = asked(f, k);
    if (!fit || fit->question->length) return;
    if (fit->fits) judge_form(f, fit);
    if (fit->line[0]) {
        reason(f,
               "not objective: %s depends on the observer: lines %ld and %ld are one motion, and differ by %.3g of its "
               "greatest value",
               fit->question->name, fit->line[0], fit->line[1], fit->differs);
        answer(&f->objective, false);
    }
}

/* ---- rolling: balance and power of the moments */

static void judge_sum(tr_identify *w) {
    tr_identified *f = &w->found;
    const tr_questions *q = &w->questions;
    if (!(q->moment > 0)) return;
    double part = q->sum / q->moment;
    const tr_fit *M1 = told(f, TR_ASK_M1), *M2 = told(f, TR_ASK_M2);
    double rounding = fmax(NOTHING, 4 * fmax(M1 ? M1->error : 0, M2 ? M2->error : 0));
    answer(&f->balanced, part <= rounding);
    if (part > rounding)
        reason(f,
               "not balanced: the moments do not cancel: M1 + M2 is up to %.3g of the greatest moment (line %ld), so "
               "rolling changes the angular momentum of the two",
               part, q->sum_line);
}

/* Power of the moments of two disks on probe i; without one of them, it is the opposite of the other. */
static double rolling_power(const tr_identify *w, const tr_fit *M1, const tr_fit *M2, int i) {
    const tr_motion *v = &w->probes.states.motion[i];
    double of1 = M1 ? -tr_forms_value(&M1->best, &w->probes.states, i) : 0;
    double of2 = M2 ? tr_forms_value(&M2->best, &w->probes.states, i) : -of1;
    if (!M1) of1 = -of2;
    return of1 * v->w1 + of2 * v->w2;
}

/* The moments of a spring on V_r do the power -T V_r, if they are T dV_r/dw: of opposite moments V_r is a length
 * times w1 - w2. Then the power over (w1 - w2)^2 is one number, below 0, at each place. */
static void judge_rolling_power(tr_identify *w) {
    tr_identified *f = &w->found;
    const tr_fit *M1 = told(f, TR_ASK_M1), *M2 = told(f, TR_ASK_M2), *one = M1 ? M1 : M2;
    if (!one || (!M1 && asked(f, TR_ASK_M1)) || (!M2 && asked(f, TR_ASK_M2)) || !one->objective) return;
    const tr_probes *p = &w->probes;
    double off = 0, sign = 0;
    enum { AT_ONE_PLACE = 4 };
    for (int i = 0; i < p->n / 2 && !isinf(p->states.motion[i].R1); i += AT_ONE_PLACE) {
        double first = 0;
        for (int k = 0; k < AT_ONE_PLACE; k++) {
            double spin = p->states.motion[i + k].w1 - p->states.motion[i + k].w2;
            double r = rolling_power(w, M1, M2, i + k) / (spin * spin);
            if (k == 0) first = r;
            off = fmax(off, fabs(r - first) / fmax(fabs(first), 1e-300)), sign += r;
        }
    }
    char words[TR_FORM_WORDS];
    tr_forms_words(&one->best, words);
    bool drives = off > 1e-9 ? one->best.factor < 0 : sign > 0;
    if (drives) {
        reason(f, "not conjugate: M1, M2 drive the rolling (their sign is opposite): the contact makes energy");
        answer(&f->conjugate, false);
    }
    if (off > 1e-9) {
        reason(f,
               "not conjugate: the moments are of %s, which is more than w1 - w2: their power is not that of a spring, "
               "and closed cycles make or take energy",
               words);
        answer(&f->conjugate, false);
    }
    answer(&f->conjugate, true);
}

/* ---- friction: balance and power of force and torques */

/* The row of the table with this velocity and these arms of torques, or NULL. */
static const tr_arms *known_mixture(const tr_form *velocity, const tr_form *arm) {
    if (velocity->radii || arm->radii || fabs(velocity->factor) != 1 || fabs(arm->factor) != 1) return NULL;
    const char *sliding = tr_forms_name(velocity->family, velocity->definition);
    const char *arms = tr_forms_name(arm->family, arm->definition);
    for (int k = 0; k < tr_n_arms_measured; k++) {
        const tr_arms *row = &tr_arms_rows[k];
        const char *dash = strchr(row->name, '-');
        if (!strcmp(row->sliding, sliding) && !strcmp(dash ? dash + 1 : row->name, arms)) return row;
    }
    return NULL;
}

static void judge_arms(tr_identify *w, const tr_fit *one, const tr_fit *two) {
    tr_identified *f = &w->found;
    const tr_probes *p = &w->probes;
    double off = 0, over = 0;
    for (int i = 0; i < p->n / 2; i++) {
        const tr_motion *m = &p->states.motion[i];
        if (isinf(m->R1)) continue;
        double L = p->states.length[i],
               sum = fabs(tr_forms_value(&one->best, &p->states, i)) + fabs(tr_forms_value(&two->best, &p->states, i));
        if (fabs(sum - L) > fabs(off)) off = sum - L, over = off / (m->R1 + m->R2 - L);
    }
    answer(&f->balanced, fabs(over) < 1e-6);
    if (fabs(over) >= 1e-6)
        reason(
            f,
            "not balanced: the arms of friction add up to |X21| %+.3g overlap at worst, not to |X21|: friction changes "
            "the angular momentum of the two",
            over);
}

typedef struct gap {
    double worst, at, greatest; /* m/s; overlap over R1+R2 (R2 at a wall); V_s */
} gap;

/* Power of a unit force of friction less the sliding velocity, over the rows of the file. one: NULL at a wall. */
static gap power_gap(const tr_identify *w, const tr_form *velocity, const tr_fit *one, const tr_fit *two, bool wall) {
    gap g = {0};
    for (int i = 0; i < w->states.n; i++) {
        const tr_motion *m = &w->states.motion[i];
        if (isinf(m->R1) != wall) continue;
        double Vs = tr_forms_value(velocity, &w->states, i), power = w->states.measures[0][i].Vt;
        if (!wall) power += fabs(tr_forms_value(&one->best, &w->states, i)) * m->w1;
        power += fabs(tr_forms_value(&two->best, &w->states, i)) * (wall ? m->w2 - m->w1 : m->w2);
        g.greatest = fmax(g.greatest, fabs(Vs));
        if (fabs(power - Vs) <= g.worst) continue;
        g.worst = fabs(power - Vs), g.at = 1 - w->states.length[i] / (wall ? m->R2 : m->R1 + m->R2);
    }
    return g;
}

static void judge_friction_power(tr_identify *w, const tr_fit *one, const tr_fit *two, int wall) {
    tr_identified *f = &w->found;
    const tr_fit *V = told(f, TR_ASK_V_S + wall), *F = told(f, TR_ASK_F_T + wall);
    if (!V && !F) return;
    tr_form velocity = V ? V->best : F->best;
    velocity.factor = V ? fabs(velocity.factor) : 1; /* that of F_t is a matter of k_t */
    if (!V && !strcmp(tr_forms_name(TR_FAMILY_SLIDING, velocity.definition), "iwashita-oda")) velocity.factor = 2;
    gap g = power_gap(w, &velocity, one, two, wall > 0);
    const tr_arms *known = wall ? NULL : known_mixture(&velocity, &one->best);
    char words[2][TR_FORM_WORDS];
    bool good = g.worst <= NOTHING * g.greatest;
    answer(&f->conjugate, good);
    if (!good)
        reason(
            f,
            "not conjugate%s: velocity %s, torque arms %s%s%s%s: the power of friction differs from F_t V_s by up to "
            "%.3g m/s for each unit of force, %.2g of the greatest V_s, at %.3g %% overlap",
            wall ? " at a wall" : "", tr_forms_words(&velocity, words[0]), tr_forms_words(&two->best, words[1]),
            known ? " (both as " : "", known ? known->source : "", known ? ")" : "", g.worst, g.worst / g.greatest,
            100 * g.at);
    else if (known)
        note(f, "velocity and torque as in the row `%s` of the arms (%s)", known->name, known->source);
}

/* wall: 0, or TR_ASKS. */
static void judge_friction(tr_identify *w, int wall) {
    tr_identified *f = &w->found;
    const tr_fit *one = told(f, TR_ASK_ARM1 + wall), *two = told(f, TR_ASK_ARM2 + wall);
    const tr_fit *F = told(f, TR_ASK_F_T + wall), *V = told(f, TR_ASK_V_S + wall);
    bool opposite = F && F->best.factor < 0 && V && V->best.factor > 0;
    opposite |= F && F->best.factor < 0 && !V && two && two->best.factor > 0;
    if (opposite) {
        reason(f, "not conjugate: F_t drives the sliding (its sign is opposite): the contact makes energy");
        answer(&f->conjugate, false);
    }
    if (one && two && (one->best.factor < 0) != (two->best.factor < 0)) {
        reason(f, "not conjugate: the torques of friction on 1 and 2 have opposite signs: one of them drives");
        answer(&f->conjugate, false);
    }
    if (!two || (!one && !wall)) {
        if ((F || V) && !wall) note(f, "power and balance of friction are not told: add T1 and T2 (or arm1 and arm2)");
        return;
    }
    if (!wall) judge_arms(w, one, two);
    judge_friction_power(w, one, two, wall);
}

/* ---- signs, and what is not told */

static void judge_signs(tr_identified *f) {
    const tr_fit *V_r = told(f, TR_ASK_V_R), *V_s = told(f, TR_ASK_V_S);
    if (V_r && V_s && V_r->best.factor < 0 && V_s->best.factor < 0)
        note(f, "t is reversed: V_r and V_s flip together, t = k x n in the place of n x k");
    else if (V_r && V_s && (V_r->best.factor < 0) != (V_s->best.factor < 0))
        note(f, "the sign of %s is opposite, that of %s is not: they are not along one t",
             V_r->best.factor < 0 ? "V_r" : "V_s", V_r->best.factor < 0 ? "V_s" : "V_r");
    else if ((V_r && V_r->best.factor < 0) || (V_s && V_s->best.factor < 0))
        note(f, "the sign of %s is opposite, or t is reversed (t = k x n)", V_r ? "V_r" : "V_s");
    if (f->conjugate == TR_NOT_TOLD)
        note(f, "conjugate or not is not told: add M1 and M2 of a rolling spring, or F_t, T1, T2");
}

static void judge_fit(tr_identified *f, int k) {
    const tr_fit *fit = asked(f, k);
    char words[TR_FORM_WORDS], other[TR_FORM_WORDS];
    if (!fit) return;
    tr_forms_words(&fit->best, words);
    if (!fit->fits) {
        f->unclear = true;
        bool blind = !fit->pairs && !fit->question->length;
        reason(f, "not recognised: %s is none of the tables; the nearest, %s, is off by %.3g of %s%s",
               fit->question->name, words, fit->error, fit->question->length ? "it" : "the greatest",
               blind ? "; no two rows show one motion to two observers, so whether it depends on them is not told"
                     : "");
    } else if (fit->n_ties) {
        f->unclear = true;
        reason(f, "not told apart: %s is %s, or %s%s: add the row below", fit->question->name, words,
               tr_forms_words(&fit->tie[0], other), fit->n_ties > 1 ? ", or others" : "");
    }
}

void tr_identify_judge(tr_identify *w) {
    tr_identified *f = &w->found;
    for (int k = 0; k < TR_QUESTIONS; k++) judge_observers(f, k);
    judge_sum(w);
    judge_rolling_power(w);
    judge_friction(w, 0);
    judge_friction(w, TR_ASKS);
    for (int k = 0; k < TR_QUESTIONS; k++) judge_fit(f, k);
    judge_signs(f);
}

bool tr_identify_is_good(const tr_identified *f) {
    return !f->unclear && f->objective != TR_NO && f->balanced != TR_NO && f->conjugate != TR_NO;
}
