/* SPDX-License-Identifier: MIT */
/* Items of `laws:` of every law of the registry that kind: contact has, so that a new law is not forgotten. */
#ifndef TR_TEST_EVERY_LAW_H
#define TR_TEST_EVERY_LAW_H

#include "laws/law.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

typedef struct laws_text {
    char s[4000];
} laws_text;

static inline void add_text(laws_text *t, const char *format, ...) {
    size_t used = strlen(t->s);
    va_list args;
    va_start(args, format);
    vsnprintf(t->s + used, sizeof t->s - used, format, args);
    va_end(args);
}

/* The law with what it must be given and what by default names another key: stiffnesses of 1e9 SI, numbers of 0.3.
 * Switches are on, counts small. Moduli follow from the bodies. driver: with the choice that only this kind has. */
static inline void add_law(laws_text *t, const char *slot, const tr_law *law, bool driver) {
    add_text(t, "%s: %s", slot, law->table.name);
    for (int i = 0; i < law->table.n; i++) {
        const tr_param *p = &law->table.params[i];
        bool names_a_key = p->fallback && (p->fallback[strspn(p->fallback, "0123456789.e-")] != 0);
        bool modulus = p->dim.kg && !p->dim.line;
        if (p->type == TR_SWITCH) add_text(t, ", %s: yes", p->key);
        if (p->type == TR_COUNT) add_text(t, ", %s: %g", p->key, fmin(fmax(40, p->min), p->max));
        if (p->type == TR_REAL && (!p->fallback || names_a_key) && !modulus)
            add_text(t, ", %s: %s", p->key, p->dim.kg ? "1e9" : "0.3");
        if (driver && p->type == TR_CHOICE && strstr(p->choices, law->table.driver_choice))
            add_text(t, ", %s: %s", p->key, law->table.driver_choice);
    }
    if (law->needs & TR_NEEDS_PARTIALS) add_text(t, ", rolling_velocity: bagi-kuhn"); /* unlike wang it pulls too */
}

/* Each law of a slot beside the default of the other one. solved: with those that patch/ solves. */
static inline void add_laws(laws_text *t, tr_shape shape, bool solved) {
    const unsigned other = shape == TR_SHAPE_SPHERE ? TR_ONLY_DISKS : TR_ONLY_SPHERES;
    const tr_param_catalog *c = tr_laws_catalog();
    for (int rolling = 0; rolling < 2; rolling++)
        for (int i = 0; i < (rolling ? c->n_rolling : c->n_friction); i++) {
            const tr_law *law = rolling ? tr_laws_rolling[i] : tr_laws_friction[i];
            bool there = law->step || (solved && law->needs & TR_SOLVED_BY_PATCH);
            if (!there || law->table.demands & other) continue;
            for (int driver = 0; driver <= (solved && law->table.driver_choice); driver++) {
                add_text(t, "  - {");
                add_law(t, rolling ? "rolling" : "friction", law, driver);
                add_text(t, ", ");
                add_law(t, rolling ? "friction" : "rolling", rolling ? tr_laws_friction[0] : tr_laws_rolling[0], false);
                add_text(t, "}\n");
            }
        }
}

#endif
