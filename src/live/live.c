/* SPDX-License-Identifier: MIT */
/* What the page calls. Text comes in and goes out through one buffer, numbers through arrays that the page reads in the
 * memory of the module. A slot holds one world; scenes that compare two samples use two. */
#include "live/hash.h"
#include "live/live.h"
#include "trundle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SLOTS = 4, TEXT = 1 << 16 };

static char text[TEXT];
trundle_error live_failed;

static struct slot {
    trundle_scene *scene, *laws;
    trundle_world *world;
    trundle_touch *touch;
    int room;
    trundle_disk *disk;
    trundle_biaxial biaxial;
} slots[SLOTS];

/* Where the page writes a text, NUL at its end; how long it may be. */
char *EXPORT(live_text)(void) {
    return text;
}
int EXPORT(live_room)(void) {
    return TEXT;
}
const char *EXPORT(live_error)(void) {
    return live_failed.text;
}
const char *EXPORT(live_version)(void) {
    return trundle_version();
}

void EXPORT(live_close)(int s) {
    trundle_world_free(slots[s].world);
    trundle_scene_free(slots[s].scene);
    trundle_scene_free(slots[s].laws);
    free(slots[s].touch);
    free(slots[s].disk);
    slots[s] = (struct slot){0};
}

static bool make(struct slot *l) {
    l->scene = trundle_scene_read("case.yaml", text, NULL, 0, &live_failed);
    l->world = l->scene ? trundle_world_new(l->scene, &live_failed) : NULL;
    l->disk = l->world ? calloc((size_t)trundle_world_count(l->world), sizeof *l->disk) : NULL;
    return l->disk;
}

/* The case in the text buffer: a world in slot s. Returns the code of the error. */
int EXPORT(live_open)(int s) {
    live_close(s);
    if (make(&slots[s])) return TRUNDLE_OK;
    live_close(s);
    return live_failed.code ? live_failed.code : TRUNDLE_FILE;
}

int EXPORT(live_step)(int s, int n) {
    return trundle_world_step(slots[s].world, n, &live_failed);
}
double EXPORT(live_time)(int s) {
    return trundle_world_time(slots[s].world);
}
double EXPORT(live_dt)(int s) {
    return trundle_world_dt(slots[s].world);
}
int EXPORT(live_count)(int s) {
    return trundle_world_count(slots[s].world);
}

/* count times trundle_disk, 11 doubles each. */
const trundle_disk *EXPORT(live_disks)(int s) {
    for (int i = 0; i < trundle_world_count(slots[s].world); i++)
        trundle_world_disk(slots[s].world, i, &slots[s].disk[i], &live_failed);
    return slots[s].disk;
}

/* Returns how many touch, -1 if memory is short; live_touches: trundle_touch of each. */
int EXPORT(live_contacts)(int s) {
    struct slot *l = &slots[s];
    int n = trundle_world_contacts(l->world, l->touch, l->room, &live_failed);
    if (n <= l->room) return n;
    free(l->touch);
    l->room = 2 * n;
    l->touch = malloc((size_t)l->room * sizeof *l->touch);
    if (!l->touch) return l->room = 0, -1;
    return trundle_world_contacts(l->world, l->touch, l->room, &live_failed);
}
const trundle_touch *EXPORT(live_touches)(int s) {
    return slots[s].touch;
}
int EXPORT(live_touch_size)(void) {
    return (int)sizeof(trundle_touch);
}

/* strain, stress_1, stress_2, sin_phi, void_ratio; NULL: not a biaxial test */
const trundle_biaxial *EXPORT(live_biaxial)(int s) {
    return trundle_world_biaxial(slots[s].world, &slots[s].biaxial, &live_failed) ? NULL : &slots[s].biaxial;
}

int EXPORT(live_velocity)(int s, int i, double vx, double vy, double spin) {
    return trundle_world_set_velocity(slots[s].world, i, vx, vy, spin, &live_failed);
}

/* The world of slot s goes on with the laws of the case in the text buffer. */
int EXPORT(live_laws)(int s) {
    trundle_scene *scene = trundle_scene_read("case.yaml", text, NULL, 0, &live_failed);
    if (!scene) return live_failed.code;
    int code = trundle_world_change_laws(slots[s].world, scene, &live_failed);
    if (code) return trundle_scene_free(scene), code;
    trundle_scene_free(slots[s].laws);
    slots[s].laws = scene;
    return code;
}

/* Of all bits of the positions. */
uint64_t EXPORT(live_hash)(int s) {
    return live_hash_of(slots[s].world);
}

/* ---- definitions ---- */

static struct motion {
    double R1, R2;
    trundle_body one, two;
} motion;

/* Where the page writes a motion: R1 (Infinity: a floor), R2, then x, y, vx, vy, spin of both. */
struct motion *EXPORT(live_motion)(void) {
    return &motion;
}
int EXPORT(live_definitions)(int kind) {
    return trundle_definition_count((trundle_velocity)kind);
}
const char *EXPORT(live_definition)(int kind, int i) {
    return trundle_definition_name((trundle_velocity)kind, i);
}
double EXPORT(live_measure)(int kind, int i) {
    return trundle_definition_value((trundle_velocity)kind, i, motion.R1, motion.R2, &motion.one, &motion.two);
}
