/* SPDX-License-Identifier: MIT */
#include "base/param.h"

#include <assert.h>
#include <stdbool.h>
#include <string.h>

const char *tr_param_by_shape(const char *text, tr_shape shape, char buffer[TR_BY_SHAPE]) {
    const char *bar = strchr(text, '|');
    if (!bar) return text;
    if (shape == TR_SHAPE_SPHERE) return bar + 1;
    size_t n = (size_t)(bar - text);
    assert(n < TR_BY_SHAPE);
    memcpy(buffer, text, n);
    buffer[n] = '\0';
    return buffer;
}

unsigned tr_param_demands(const tr_param_table *table, const void *par) {
    for (int i = 0; i < table->n && table->demands_if; i++) {
        const tr_param *p = &table->params[i];
        if (strcmp(p->key, table->demands_if) != 0) continue;
        const char *value = (const char *)par + p->offset;
        bool on = p->type == TR_SWITCH ? *(const bool *)value : *(const double *)(const void *)value > 0;
        if (!on) return table->demands & ~(unsigned)(TR_NEEDS_TIME | TR_NEEDS_DENSITY);
    }
    return table->demands;
}
