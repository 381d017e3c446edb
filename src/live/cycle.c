/* SPDX-License-Identifier: MIT */
/* The closed cycle of one contact, for the page. */
#include "live/cycle.h"
#include "live/live.h"

static trundle_contact *contact;
static live_cycle cycle;

/* The laws in the text buffer, as they stand in `contact`. Returns the code of the error. */
int EXPORT(live_cycle_open)(double R1, double R2, double overlap, double du, double dtheta) {
    const trundle_pair pair = {.R1 = R1, .R2 = R2, .density1 = 1000, .density2 = 1000};
    trundle_contact_free(contact);
    cycle = (live_cycle){.R1 = R1, .R2 = R2, .overlap = overlap, .du = du, .dtheta = dtheta};
    contact = trundle_contact_new(live_text(), &pair, &live_failed);
    return contact ? TRUNDLE_OK : live_failed.code;
}

int EXPORT(live_cycle_go)(int n) {
    int code = TRUNDLE_OK;
    for (int k = 0; k < n && !code; k++) code = live_cycle_step(&cycle, contact, &live_failed);
    return code;
}

/* From R1 on, 11 doubles. */
const live_cycle *EXPORT(live_cycle_state)(void) {
    return &cycle;
}
int EXPORT(live_cycle_leg)(void) {
    return LIVE_LEG;
}
