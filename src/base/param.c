/* SPDX-License-Identifier: MIT */
#include "base/param.h"

#include <assert.h>
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
