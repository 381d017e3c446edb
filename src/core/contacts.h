/* SPDX-License-Identifier: MIT */
/* The renewal of the list of contacts, and the checks at that time. */
#ifndef TR_CONTACTS_H
#define TR_CONTACTS_H

#include "core/world.h"

/* Checks that the state is finite and that no disk moves too far in one step. Renews the lists of both groups: every
 * pair closer than the thin skin, sorted by (a, b). Histories follow the ids (list.h).
 * Searches with the broad phase if its wider list may have missed a pair. No overlap may be above 0.3 R, and dt not
 * above the stability bound of the touching contacts (unless allow_unstable). Else TR_NUMERICAL naming disk, contact,
 * step and time. */
bool tr_contacts_refresh(tr_world *world, tr_status *st);

#endif
