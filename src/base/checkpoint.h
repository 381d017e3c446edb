/* SPDX-License-Identifier: MIT */
/* Checkpoints: the state of a run in one file. The run continues from it with the same bits.
 *
 * A file with state lists it in one function, a TR_KEEP for each field. The same function saves and loads:
 *
 *     void tr_ball_checkpoint(tr_ball *ball, tr_checkpoint *c) {
 *         TR_KEEP(c, ball->x, 3);
 *         TR_KEEP(c, &ball->bounces, 1);
 *     }
 *
 * To load, the run is first built like a new one; then the fields replace its values. Values that follow from the case,
 * or are computed again before they are read, need no field.
 *
 * FILE. In the byte order of the machine: magic, version, bytes of the whole; records (name, size of one, count,
 * bytes), the first of which is the resolved case; FNV-1a of all before, which sees any change of one byte. The version
 * counts changes outside of the records. A field that was added, removed or resized is reported by its name.
 *
 * NAME is written as NAME.part, synced, and renamed; the older one is NAME.old. After any failed call or kill, one of
 * the two is complete. */
#ifndef TR_CHECKPOINT_H
#define TR_CHECKPOINT_H

#include "base/status.h"
#include <stddef.h>
#include <stdint.h>

#define TR_CHECKPOINT "checkpoint.bin" /* the name of that of a run */

typedef struct tr_checkpoint {
    bool loading;
    unsigned char *bytes;
    size_t size, room, at; /* at: the position of loading */
    tr_status *st;
} tr_checkpoint;

/* The content of a field. A file with a right checksum may still be wrong: loading fails at a number that is not
 * finite, at a count below 0 or beyond all reason, at a flag that is not 0 or 1. TR_KEEP chooses by the type of the
 * pointer: double, int64_t (a count), bool, else bytes. */
typedef enum tr_checkpoint_kind { TR_KEPT_BYTES, TR_KEPT_NUMBERS, TR_KEPT_COUNTS, TR_KEPT_FLAGS } tr_checkpoint_kind;

/* count objects of size bytes at data: appended, or read into data. After the first failure, which goes to c->st, it
 * does nothing. */
void tr_checkpoint_field(tr_checkpoint *c, tr_checkpoint_kind kind, const char *name, void *data, size_t size,
                         size_t count);
#define TR_KEEP(c, data, count) TR_KEEP_AS(c, TR_CHECKPOINT_KIND(data), data, count)
#define TR_KEEP_NUMBERS(c, data, count) TR_KEEP_AS(c, TR_KEPT_NUMBERS, data, count) /* structs of doubles */
#define TR_KEEP_AS(c, kind, data, count) tr_checkpoint_field(c, kind, #data, data, sizeof *(data), (size_t)(count))
#ifdef TR_LINT /* cppcheck 2.10 crashes on many _Generic in a function */
#define TR_CHECKPOINT_KIND(data) TR_KEPT_BYTES
#else
#define TR_CHECKPOINT_KIND(data)                                                                                       \
    _Generic((data), double *: TR_KEPT_NUMBERS, int64_t *: TR_KEPT_COUNTS, bool *: TR_KEPT_FLAGS, default: TR_KEPT_BYTES)
#endif

/* How many objects of `size` bytes follow. Loading fails if the rest of the file is too short for them. */
void tr_checkpoint_count(tr_checkpoint *c, const char *name, int *n, size_t size);
#define TR_KEEP_COUNT(c, n, size) tr_checkpoint_count(c, #n, n, size)

/* Loading fails unless ok: `what` is out of its range. It is needed for indices, enumerations and counts that other
 * code relies on. */
void tr_checkpoint_check(tr_checkpoint *c, bool ok, const char *what);

/* To save: begin, fields, write, which frees. */
void tr_checkpoint_begin(tr_checkpoint *c, const char *resolved_case, tr_status *st);
bool tr_checkpoint_write(tr_checkpoint *c, const char *dir, const char *name);

/* To load: open, fields, close, which frees, and fails if fields are left over. Open: false without a failure: no
 * checkpoint. A checkpoint of another case, or of a newer version, is refused (TR_FILE). A damaged one is refused too.
 * But if the older one is complete, it is taken instead, and `instead` (else empty) says why. */
bool tr_checkpoint_open(tr_checkpoint *c, const char *dir, const char *name, const char *resolved_case,
                        tr_status *instead, tr_status *st);
bool tr_checkpoint_close(tr_checkpoint *c);

/* Whether an open file has no second name, and is empty or begins like a checkpoint: then it belongs to a run, not to
 * the user. */
bool tr_checkpoint_is_one(int fd);

/* Removes those of a finished run. False: one is left, see errno. */
bool tr_checkpoint_remove(const char *dir);

/* Removes the rest of a run that was killed while it wrote a checkpoint. */
void tr_checkpoint_remove_temporary(const char *dir);

/* Makes sure that dir/name, a file or a directory, is on the disk. If it does not exist, nothing is done. */
bool tr_checkpoint_sync(const char *dir, const char *name, tr_status *st);

#endif
