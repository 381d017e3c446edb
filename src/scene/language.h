/* SPDX-License-Identifier: MIT */
/* Texts of a case in several languages: `lesson: {en: {title: ...}, de: {title: ...}}`,
 * `label: {en: rests, de: ruht}`. */
#ifndef TR_SCENE_LANGUAGE_H
#define TR_SCENE_LANGUAGE_H

#include "scene/tree.h"

extern const char tr_language_choices[]; /* "en|de" */

/* Leaves of each such text the one in the language of the document, its `language`, or where that is missing the first.
 * A language that has not the keys of the first: an error. */
bool tr_language_choose(tr_node *root, tr_status *st);

#endif
