/* SPDX-License-Identifier: MIT */
/* Names of contacts: "3-17", "wall0-2", "most-mobilised". */
#ifndef TR_SCENE_CONTACT_NAME_H
#define TR_SCENE_CONTACT_NAME_H

#include "scene/data.h"

/* False: no such name. */
bool tr_contact_name_read(tr_contact_id *pick, const char *name);
void tr_contact_name_write(tr_contact_id pick, char name[TR_CONTACT_NAME]);

#endif
