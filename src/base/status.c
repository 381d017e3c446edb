/* SPDX-License-Identifier: MIT */
#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool tr_status_fail(tr_status *st, tr_code code, const char *format, ...) {
    if (st->code != TR_OK) return false;
    st->code = code;
    va_list args;
    va_start(args, format);
    vsnprintf(st->text, sizeof st->text, format, args);
    va_end(args);
    return false;
}

bool tr_status_more(tr_status *st, const char *format, ...) {
    size_t used = strlen(st->text);
    if (st->code == TR_OK) return false;
    va_list args;
    va_start(args, format);
    vsnprintf(st->text + used, sizeof st->text - used, format, args);
    va_end(args);
    return false;
}
