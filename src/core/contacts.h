/* SPDX-License-Identifier: MIT */
/* When the list of contacts that a step walks is renewed, and what is looked at then. */
#ifndef TR_CONTACTS_H
#define TR_CONTACTS_H

#include "core/world.h"

/* Looks whether the state is finite and no disk leaps in one step; renews the lists of both groups: every pair closer than the thin skin,
 * sorted by (a, b). Histories follow the ids (list.h).
 * Searches with the broad phase when its wider list may have missed a pair. No overlap may be above 0.3 R, and dt not above the
 * stability bound of the touching contacts (unless allow_unstable). Else TR_NUMERICAL naming disk, contact, step and time. */
bool tr_contacts_refresh(tr_world *world, tr_status *st);

#endif
