/* SPDX-License-Identifier: MIT */
/* What the files with functions for the page share. */
#ifndef TR_LIVE_H
#define TR_LIVE_H

#include "trundle.h"

#define EXPORT(name) __attribute__((export_name(#name))) name

char *live_text(void);            /* the buffer for text that comes in */
extern trundle_error live_failed; /* of the last function that failed */

#endif
