/* SPDX-License-Identifier: MIT */
/* trundle laws */
#include "cli/parse.h"
#include "laws/law.h"
#include "scene/text.h"
#include "study/counterparts.h"
#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 100 };

static const struct slot {
    const char *name;
    const tr_law *const *laws;
} slots[] = {{"normal", tr_laws_normal}, {"friction", tr_laws_friction}, {"rolling", tr_laws_rolling}};
enum { N_LAW_KINDS = sizeof slots / sizeof *slots };

static int count(int slot) {
    const tr_param_catalog *c = tr_laws_catalog();
    const int n[N_LAW_KINDS] = {c->n_normal, c->n_friction, c->n_rolling};
    return n[slot];
}

static void list(FILE *to) {
    for (int s = 0; s < N_LAW_KINDS; s++) {
        fprintf(to, "%s%s:\n", s ? "\n" : "", slots[s].name);
        for (int i = 0; i < count(s); i++)
            fprintf(to, "  %-26s %s\n", slots[s].laws[i]->table.name, slots[s].laws[i]->table.doc);
    }
}

/* Text behind a label, broken at blanks and at \n. */
static void paragraph(const char *label, const char *text) {
    printf("  %s\n", label);
    while (*text) {
        size_t n = strcspn(text, "\n"), room = WIDTH - 4;
        if (n > room)
            for (n = room; n > 0 && text[n] != ' ';) n--;
        if (n == 0) n = strcspn(text, " \n");
        printf("    %.*s\n", (int)n, text);
        text += n;
        if (*text == ' ' || *text == '\n') text++;
    }
}

static void print_param(const tr_param *p) {
    char what[64] = "", range[64] = "";
    if (p->type == TR_REAL) {
        char disk[TR_BY_SHAPE], sphere[TR_BY_SHAPE];
        const char *of_disk = tr_param_by_shape(p->unit, TR_SHAPE_DISK, disk),
                   *of_sphere = tr_param_by_shape(p->unit, TR_SHAPE_SPHERE, sphere);
        bool differ = strcmp(of_disk, of_sphere) != 0;
        snprintf(what, sizeof what, " [%s%s%s]", of_disk, differ ? "; spheres " : "", differ ? of_sphere : "");
    }
    if (p->type == TR_CHOICE)
        snprintf(range, sizeof range, "%s", p->choices);
    else if (p->type == TR_SWITCH)
        snprintf(range, sizeof range, "yes|no");
    else
        snprintf(range, sizeof range, "%g to %g", p->min, p->max);
    printf("    %s%s, %s, %s%s\n      %s\n", p->key, what, range, p->fallback ? "default " : "must be given",
           p->fallback ? p->fallback : "", p->doc);
}

static void print_claims(unsigned claims) {
    static const struct {
        unsigned bit;
        const char *yes, *no;
    } names[] = {
        {TR_RATE_INDEPENDENT, "rate-independent", "depends on the rate"},
        {TR_OBJECTIVE, "objective", "not objective: depends on the observer"},
        {TR_BALANCED, "balanced", "not balanced: makes angular momentum"},
        {TR_ENERGY_CLOSED, "energy-closed", "not energy-closed: a closed cycle may make energy"},
    };
    printf("  claims, at the default options\n");
    for (int i = 0; i < 4; i++) printf("    %s\n", claims & names[i].bit ? names[i].yes : names[i].no);
}

static void show(const char *slot, const tr_law *law) {
    printf("%s: %s - %s\n", slot, law->table.name, law->table.doc);
    paragraph("formula", law->formula);
    if (law->source) paragraph("source", law->source);
    if (law->differs) paragraph("differs from the paper", law->differs);
    unsigned only = law->table.demands & (TR_ONLY_DISKS | TR_ONLY_SPHERES);
    printf("  for\n    %s\n", only == TR_ONLY_DISKS ? "disks" : only ? "spheres" : "disks and spheres");
    if (law->table.n) printf("  parameters (under contact:, or in an item of laws:)\n");
    for (int i = 0; i < law->table.n; i++) print_param(&law->table.params[i]);
    print_claims(tr_law_claims(law));
}

/* ---- the same law in another code */

typedef struct arguments {
    const char *name, *code;
    double R1, R2; /* 0: not given */
} arguments;

static void print_key(const tr_counterpart_key *k, double R1, double R2) {
    static const double ratios[] = {1, 2, 10};
    if (tr_counterpart_is_plain(k)) {
        printf("    %s = %s, for all radii\n", k->key, k->theirs);
    } else if (R1 > 0) {
        printf("    %s = %.6g %s\n", k->key, k->factor(R1, R2), k->theirs);
    } else {
        printf("    %s = c %s, c =", k->key, k->theirs);
        for (int i = 0; i < 3; i++) printf("%s %.6g", i ? "," : "", k->factor(ratios[i], 1));
        printf(" at R1/R2 = 1, 2, 10\n");
    }
}

static int print_counterpart(const arguments *a) {
    const tr_counterpart *c = tr_counterpart_of(a->code, a->name);
    if (!c) {
        fprintf(stderr, "error: %s was not measured in %s; measured are", a->name, a->code);
        for (int k = 0; k < tr_n_counterparts; k++)
            fprintf(stderr, "%s %s in %s", k ? "," : "", tr_counterparts[k].law, tr_counterparts[k].code);
        fputc('\n', stderr);
        return TR_BAD_CASE;
    }
    if (a->R1 > 0)
        printf("%s in %s, for R1 = %g m and R2 = %g m\n", a->name, a->code, a->R1, a->R2);
    else
        printf("%s in %s\n", a->name, a->code);
    paragraph("measured with", c->where);
    printf("  here = there\n");
    for (int k = 0; k < TR_COUNTERPART_KEYS && c->key[k].key; k++) print_key(&c->key[k], a->R1, a->R2);
    if (c->differs) paragraph("differs", c->differs);
    if (strcmp(a->name, c->law)) printf("  with\n    rolling_velocity: wang\n");
    return TR_OK;
}

static const struct argp_option options[] = {
    {"in", 'i', "CODE", 0, "which coefficients of lammps, liggghts or yade give the same law", 0},
    {"radii", 'r', "R1,R2", 0, "with --in: of bodies of these radii [m]", 0},
    {0},
};

static void read_radii(const char *text, arguments *a, struct argp_state *state) {
    char rest;
    if (sscanf(text, "%lf,%lf%c", &a->R1, &a->R2, &rest) != 2 || !(a->R1 > 0 && a->R2 > 0) || !isfinite(a->R1 + a->R2))
        argp_error(state, "--radii takes two lengths above 0 in m, R1,R2, not %s", text);
}

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    if (key == 'i')
        a->code = value;
    else if (key == 'r')
        read_radii(value, a, state);
    else if (key == ARGP_KEY_ARG && a->name)
        argp_error(state, "one law at a time");
    else if (key == ARGP_KEY_ARG)
        a->name = value;
    else if (key == ARGP_KEY_END && a->code && !a->name)
        argp_error(state, "--in: of which law?");
    else if (key == ARGP_KEY_END && a->R1 > 0 && !a->code)
        argp_error(state, "--radii goes with --in");
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

int tr_cli_laws(int argc, char **argv) {
    arguments a = {0};
    const struct argp argp = {
        options,  parse,
        "[NAME]", "Lists the contact laws, or prints all about one: formula, parameters, source, claims.",
        0,        0,
        0};
    argv[0] = "trundle laws";
    tr_cli_parse(&argp, argc, argv, &a);
    const char *name = a.name;
    if (!name) return list(stdout), TR_OK;
    tr_near near = {NULL, 0};
    int found = 0;
    for (int s = 0; s < N_LAW_KINDS; s++)
        for (int i = 0; i < count(s); i++) {
            const tr_law *law = slots[s].laws[i];
            tr_text_nearer(&near, name, law->table.name);
            if (strcmp(law->table.name, name)) continue;
            if (found++ && !a.code) printf("\n");
            if (!a.code) show(slots[s].name, law);
        }
    if (found) return a.code ? print_counterpart(&a) : TR_OK;
    fprintf(stderr, "error: no law is called `%s`%s; there are\n", tr_text_show(name).text, tr_text_hint(&near).text);
    list(stderr);
    return TR_BAD_CASE;
}
