/* SPDX-License-Identifier: MIT */
#include "study/identify_words.h"

#include <csv.h>
#include <math.h>
#include <string.h>

static const char *const answers[] = {"not told", "yes", "no"};

static void print_verdict(FILE *out, const tr_identified *f) {
    if (tr_identify_is_good(f))
        fprintf(out, "good: objective: %s, balanced: %s, conjugate: %s\n", answers[f->objective], answers[f->balanced],
                answers[f->conjugate]);
    for (int k = 0; k < f->n_reasons; k++) fprintf(out, "%s\n", f->reason[k]);
}

static void print_formula(FILE *out, const tr_form *form) {
    const char *formula = form->family == TR_FAMILY_CAP ? "" : tr_forms_formula(form->family, form->definition);
    size_t n = strcspn(formula, ";\n");
    if (n) fprintf(out, " [%.*s]", (int)n, formula);
}

static void print_fit(FILE *out, const tr_fit *fit) {
    char words[TR_FORM_WORDS];
    const tr_question *q = fit->question;
    fprintf(out, "%-14s %s%s", q->name, fit->fits ? "" : "none of the tables; nearest ",
            tr_forms_words(&fit->best, words));
    print_formula(out, &fit->best);
    fprintf(out, "\n%15s%d row%s, largest error %.2g of %s%s", "", q->n, q->n == 1 ? "" : "s", fit->error,
            q->length ? "it" : "the greatest", fit->objective || q->length ? "" : ", depends on the observer");
    for (int k = 0; k < fit->n_same; k++)
        fprintf(out, "%s%s", k ? "; or " : "\n               the same: ", tr_forms_words(&fit->same[k], words));
    for (int k = 0; k < fit->n_ties; k++)
        fprintf(out, "\n               fits as well: %s", tr_forms_words(&fit->tie[k], words));
    if (fit->has_runner && !fit->n_ties)
        fprintf(out, "\n               next best: %s, error %.2g", tr_forms_words(&fit->runner, words),
                fit->runner_error);
    fputc('\n', out);
}

static void print_row_to_add(FILE *out, const tr_identify *w, const tr_fit *fit) {
    const tr_motion *m = &w->probes.states.motion[fit->apart];
    fprintf(out, "\nto tell for %s, add this row and what your code answers:\n", fit->question->name);
    for (int k = 0; k < TR_MOTION_COLUMNS; k++) fprintf(out, "%s%s", k ? "," : "", tr_motion_columns[k].name);
    fputc('\n', out);
    for (int k = 0; k < TR_MOTION_COLUMNS; k++) {
        double v;
        memcpy(&v, (const char *)m + tr_motion_columns[k].offset, sizeof v);
        fprintf(out, "%s%.10g", k ? "," : "", v);
    }
    fputc('\n', out);
}

void tr_identify_print(FILE *out, const tr_identify *w) {
    const tr_identified *f = &w->found;
    print_verdict(out, f);
    fputc('\n', out);
    for (int k = 0; k < TR_QUESTIONS; k++)
        if (f->fit[k].question) print_fit(out, &f->fit[k]);
    for (int k = 0; k < f->n_notes; k++) fprintf(out, "%snote: %s\n", k ? "" : "\n", f->note[k]);
    for (int k = 0; k < TR_QUESTIONS; k++)
        if (f->fit[k].question && f->fit[k].n_ties) print_row_to_add(out, w, &f->fit[k]);
}

static void write_text(FILE *out, const char *text) {
    fputc(',', out);
    if (strpbrk(text, ",\""))
        csv_fwrite(out, text, strlen(text));
    else
        fputs(text, out);
}

void tr_identify_write(FILE *out, const tr_identify *w) {
    const tr_identified *f = &w->found;
    char words[TR_FORM_WORDS];
    fputs("answer,explanation,factor,rows,error,runner_up,runner_up_error,others_that_fit,objective\n", out);
    for (int k = 0; k < TR_QUESTIONS; k++) {
        const tr_fit *fit = &f->fit[k];
        if (!fit->question) continue;
        fputs(fit->question->name, out);
        write_text(out, fit->fits ? tr_forms_words(&fit->best, words) : "none");
        fprintf(out, ",%.17g,%d,%.3g", fit->best.factor, fit->question->n, fit->error);
        write_text(out, fit->has_runner ? tr_forms_words(&fit->runner, words) : "");
        if (fit->has_runner)
            fprintf(out, ",%.3g", fit->runner_error);
        else
            fputc(',', out);
        fprintf(out, ",%d,%s\n", fit->n_ties,
                fit->question->length ? "" : answers[fit->objective && !fit->line[0] ? TR_YES : TR_NO]);
    }
    fprintf(out, "objective,%s,,,,,,,\nbalanced,%s,,,,,,,\nconjugate,%s,,,,,,,\n", answers[f->objective],
            answers[f->balanced], answers[f->conjugate]);
}
