/* SPDX-License-Identifier: MIT */
#include "base/version.h"

#ifndef TR_COMMIT
#define TR_COMMIT "unknown" /* not built by the Makefile */
#endif

const char tr_commit[] = TR_COMMIT;
