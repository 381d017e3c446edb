/* SPDX-License-Identifier: MIT */
#include "scene/pick.h"

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

bool tr_scene_pick_read(tr_scene_pick *pick, const char *name) {
    int a, b;
    *pick = (tr_scene_pick){0};
    if (strcmp(name, most_mobilised) == 0) return true;
    bool wall = strncmp(name, "wall", 4) == 0;
    const char *end = read_number(wall ? name + 4 : name, &a);
    if (!end || *end != '-' || !(end = read_number(end + 1, &b)) || *end || (!wall && a == b)) return false;
    *pick = wall ? (tr_scene_pick){-1 - a, b} : a < b ? (tr_scene_pick){a, b} : (tr_scene_pick){b, a};
    return true;
}

void tr_scene_pick_name(tr_scene_pick pick, char name[TR_PICK_NAME]) {
    bool wall = pick.a < 0;
    if (pick.a == pick.b)
        strcpy(name, most_mobilised);
    else
        snprintf(name, TR_PICK_NAME, "%s%d-%d", wall ? "wall" : "", wall ? -1 - pick.a : pick.a, pick.b);
}
