/* SPDX-License-Identifier: MIT */
/* Which coefficients of another code give the same law. Only what was measured with a release of that code:
 * tests/interop/ has the answers, and tests/study/test_counterparts.c compares. */
#ifndef TR_STUDY_COUNTERPARTS_H
#define TR_STUDY_COUNTERPARTS_H

#include <stdbool.h>

/* key of ours = factor(R1, R2) x what the code calls theirs. */
typedef struct tr_counterpart_key {
    const char *key, *theirs;
    double (*factor)(double R1, double R2);
} tr_counterpart_key;

enum { TR_COUNTERPART_KEYS = 2 };
typedef struct tr_counterpart {
    const char *code, *law;                      /* as in `trundle laws LAW --in CODE` */
    const char *where;                           /* release, and what to write in that code */
    tr_counterpart_key key[TR_COUNTERPART_KEYS]; /* key NULL: no more */
    const char *differs;                         /* what no coefficient mends; NULL: nothing was seen */
} tr_counterpart;

extern const tr_counterpart tr_counterparts[];
extern const int tr_n_counterparts;

/* NULL: not measured. */
const tr_counterpart *tr_counterpart_of(const char *code, const char *law);
/* The factor of a key is the same for all radii. */
bool tr_counterpart_is_plain(const tr_counterpart_key *key);

#endif
