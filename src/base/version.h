/* SPDX-License-Identifier: MIT */
#ifndef TR_VERSION_H
#define TR_VERSION_H

#define TR_VERSION "0.3.0"

/* The commit that this was built from; with -dirty where files differed from it; "unknown" without git. */
extern const char tr_commit[];

#endif
