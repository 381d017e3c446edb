/* SPDX-License-Identifier: MIT */
/* What the files of the group `exact` share. */
#ifndef TR_VERIFY_EXACT_H
#define TR_VERIFY_EXACT_H

#include "core/world.h"
#include "study/contact.h"
#include "verify/verify.h"

/* Drives the first law of a case of kind contact: state at the end of each segment, at most n of them. pair: of the
 * case; may be NULL. */
bool tr_exact_path(const char *text, tr_contact_state *end, int n, tr_scene_pair *pair, tr_status *st);

/* Gives a world whose disks are set the laws of `contact: {...}` of a case. */
bool tr_exact_laws(tr_world *world, const char *contact, unsigned sinks, tr_status *st);

/* Of n rows, each `size` bytes and beginning with the name of a law, that of the law in the name of the
 * verification at work, "PREFIX-LAW". NULL and a failure: there is none. */
const void *tr_exact_find(const tr_verify *v, const char *prefix, const void *rows, size_t n, size_t size,
                          tr_status *st);

#endif
