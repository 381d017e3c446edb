/* SPDX-License-Identifier: MIT */
#include "api/api.h"

#include <string.h>

int tr_api_tell(const tr_status *st, trundle_error *error) {
    if (!error) return (int)st->code;
    error->code = (int)st->code;
    memcpy(error->text, st->text, sizeof error->text);
    return error->code;
}

trundle_touch tr_api_touch(const tr_record *r) {
    return (trundle_touch){.a = r->a,
                           .b = r->b,
                           .x = r->x,
                           .y = r->y,
                           .nx = r->nx,
                           .ny = r->ny,
                           .overlap = r->delta,
                           .f_n = r->f_n,
                           .f_t = r->f_t,
                           .moment_a = r->m1,
                           .moment_b = r->m2,
                           .v_s = r->v_s,
                           .v_r = r->v_r,
                           .s1 = r->s1,
                           .s2 = r->s2,
                           .mobilisation = r->mobilisation};
}

tr_api_locale tr_api_locale_enter(tr_status *st) {
    tr_api_locale l = {.own = newlocale(LC_ALL_MASK, "C", (locale_t)0)};
    if (l.own)
        l.before = uselocale(l.own);
    else
        tr_status_fail(st, TR_FILE, "error: out of memory");
    return l;
}

void tr_api_locale_leave(tr_api_locale l) {
    if (!l.own) return;
    uselocale(l.before);
    freelocale(l.own);
}
