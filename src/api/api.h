/* SPDX-License-Identifier: MIT */
/* What the files of the public face share. Its contract is in trundle.h. */
#ifndef TR_API_H
#define TR_API_H

#include "base/status.h"
#include "core/record.h"
#include "scene/scene.h"
#include "trundle.h"
#include <locale.h>

struct trundle_scene {
    tr_scene scene;
};

/* Numbers of cases and laws have a point in any locale: put this around code that reads or writes text. */
typedef struct tr_api_locale {
    locale_t own, before;
} tr_api_locale;
tr_api_locale tr_api_locale_enter(tr_status *st);
void tr_api_locale_leave(tr_api_locale l);

/* Copies a failure to the caller, who may have passed NULL. Returns the code. */
int tr_api_tell(const tr_status *st, trundle_error *error);

trundle_touch tr_api_touch(const tr_record *record);

#endif
