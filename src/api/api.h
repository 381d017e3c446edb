/* SPDX-License-Identifier: MIT */
/* What the files of the public face share. Its contract is in trundle.h. */
#ifndef TR_API_H
#define TR_API_H

#include "base/status.h"
#include "core/record.h"
#include "scene/scene.h"
#include "trundle.h"

struct trundle_scene {
    tr_scene scene;
};

/* Copies a failure to the caller, who may have passed NULL. Returns the code. */
int tr_api_tell(const tr_status *st, trundle_error *error);

trundle_touch tr_api_touch(const tr_record *record);

#endif
