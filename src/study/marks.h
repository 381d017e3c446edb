/* SPDX-License-Identifier: MIT */
/* What contacts leave on the rims as they go: a rubbed trace while they slide, numbered ticks while they roll without
 * sliding. The two ticks with a number are laid at one instant, where the bodies touch. Instants are those at which the
 * contacts are looked at, a few hundred in a film; in between the arcs tell where the contact point was. */
#ifndef TR_MARKS_H
#define TR_MARKS_H

#include "draw/draw.h"

enum { TR_MARKS_CONTACTS = 4, TR_MARKS_TICKS = 9, TR_MARKS_RUBS = 16 };
enum { TR_MARKS_MOST = 2 * TR_MARKS_CONTACTS * (TR_MARKS_TICKS + TR_MARKS_RUBS) };

/* The marks of one contact, on a and on b. Ticks are 1/10 of the smaller rim apart; older ones than a turn are gone. */
typedef struct tr_contact_marks {
    bool met, touches, rubs; /* rubs: the last trace goes on */
    tr_record last;
    double at[2]; /* where the contact point is: see tr_rim_mark, not wrapped */
    double rolled;
    int n_ticks, n_rubs;
    tr_rim_mark tick[TR_MARKS_TICKS][2], rub[TR_MARKS_RUBS][2];
} tr_contact_marks;

typedef struct tr_marks {
    double range; /* of the bars, see tr_lamp_of; 0: nothing is marked */
    tr_contact_marks contact[TR_MARKS_CONTACTS];
} tr_marks;

/* The touching contacts of the next instant. The first few contacts that ever were leave marks. */
void tr_marks_take(tr_marks *marks, const tr_world *world, const tr_record *record, int n);

/* All marks so far; returns how many. */
int tr_marks_all(const tr_marks *marks, tr_rim_mark all[TR_MARKS_MOST]);

#endif
