/* SPDX-License-Identifier: MIT */
#include "scene/contact_name.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char most_mobilised[] = "most-mobilised";

/* Up to nine digits; NULL: no number. */
static const char *read_number(const char *text, int *number) {
    size_t digits = strspn(text, "0123456789");
    *number = atoi(text);
    return digits && digits <= 9 ? text + digits : NULL;
}

bool tr_contact_name_read(tr_contact_id *pick, const char *name) {
    int a, b;
    *pick = (tr_contact_id){0};
    if (strcmp(name, most_mobilised) == 0) return true;
    bool wall = strncmp(name, "wall", 4) == 0;
    const char *end = read_number(wall ? name + 4 : name, &a);
    if (!end || *end != '-' || !(end = read_number(end + 1, &b)) || *end || (!wall && a == b)) return false;
    *pick = wall ? (tr_contact_id){-1 - a, b} : a < b ? (tr_contact_id){a, b} : (tr_contact_id){b, a};
    return true;
}

void tr_contact_name_write(tr_contact_id pick, char name[TR_CONTACT_NAME]) {
    bool wall = pick.a < 0;
    if (pick.a == pick.b)
        strcpy(name, most_mobilised);
    else
        snprintf(name, TR_CONTACT_NAME, "%s%d-%d", wall ? "wall" : "", wall ? -1 - pick.a : pick.a, pick.b);
}
