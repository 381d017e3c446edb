/* SPDX-License-Identifier: MIT */
/* The reference of all keys of a case, as Markdown tables that are also readable in a terminal. */
#ifndef TR_KEYS_H
#define TR_KEYS_H

#include "base/param.h"
#include "base/status.h"

/* For one kind of case, by its name; NULL: for all kinds. Allocated: free(). NULL and TR_BAD_CASE: no kind has this
 * name. */
char *tr_scene_keys(const char *kind, const tr_param_catalog *catalog, tr_status *st);

#endif
