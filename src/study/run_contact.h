/* SPDX-License-Identifier: MIT */
/* Laws along the path of one contact: kind `contact`. */
#ifndef TR_RUN_CONTACT_H
#define TR_RUN_CONTACT_H

#include "study/driven.h"

extern const tr_driven_kind tr_driven_contact;

#endif
