/* SPDX-License-Identifier: MIT */
/* What no single row of the tables can say: keys that must fit together, laws that must fit the case. */
#ifndef TR_CHECK_H
#define TR_CHECK_H

#include "scene/resolve.h"

/* After all entries are resolved. Also settles what follows from several keys: normals of walls, the depth of a patch.
 */
bool tr_check_together(const tr_resolver *resolver, tr_scene *scene);

/* The scope of a section (item -1), or of item i of a list; NULL. */
const tr_scope *tr_check_scope(const tr_resolver *resolver, const char *section, int item);

#endif
