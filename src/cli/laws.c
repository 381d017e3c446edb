/* SPDX-License-Identifier: MIT */
/* trundle laws */
#include "cli/parse.h"
#include "laws/law.h"
#include "scene/text.h"
#include <argp.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 100 };

static const struct slot {
    const char *name;
    const tr_law *const *laws;
} slots[] = {{"normal", tr_laws_normal}, {"friction", tr_laws_friction}, {"rolling", tr_laws_rolling}};
enum { N_SLOTS = sizeof slots / sizeof *slots };

static int count(int slot) {
    const tr_param_catalog *c = tr_laws_catalog();
    const int n[N_SLOTS] = {c->n_normal, c->n_friction, c->n_rolling};
    return n[slot];
}

static void list(FILE *to) {
    for (int s = 0; s < N_SLOTS; s++) {
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

static error_t parse(int key, char *value, struct argp_state *state) {
    const char **name = state->input;
    if (key != ARGP_KEY_ARG) return ARGP_ERR_UNKNOWN;
    if (*name) argp_error(state, "one law at a time");
    *name = value;
    return 0;
}

int tr_cli_laws(int argc, char **argv) {
    const char *name = NULL;
    const struct argp argp = {
        NULL, parse, "[NAME]", "Lists the contact laws, or prints all about one: formula, parameters, source, claims.",
        0,    0,     0};
    argv[0] = "trundle laws";
    tr_cli_parse(&argp, argc, argv, &name);
    if (!name) return list(stdout), TR_OK;
    tr_near near = {NULL, 0};
    int found = 0;
    for (int s = 0; s < N_SLOTS; s++)
        for (int i = 0; i < count(s); i++) {
            const tr_law *law = slots[s].laws[i];
            tr_text_nearer(&near, name, law->table.name);
            if (strcmp(law->table.name, name)) continue;
            if (found++) printf("\n");
            show(slots[s].name, law);
        }
    if (found) return TR_OK;
    fprintf(stderr, "error: no law is called `%s`%s; there are\n", tr_text_show(name).text, tr_text_hint(&near).text);
    list(stderr);
    return TR_BAD_CASE;
}
