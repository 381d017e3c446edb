/* SPDX-License-Identifier: MIT */
/* The file of a checkpoint: what is put in comes out; nothing but that is taken; and whichever call fails while it is
 * written, or whenever the run is killed, the last good state is whole. Calls are made to fail by the linker's --wrap
 * (Makefile). */
#include "assert_close.h"
#include "base/checkpoint.h"
#include "base/hash.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- calls that fail */

static int calls, failing = -1; /* the number of the call that fails */
static bool killed;             /* and of all after it: as if the run had ended there */

static bool fails(void) {
    bool now = failing >= 0 && (calls == failing || (killed && calls > failing));
    calls++;
    if (now) errno = ENOSPC;
    return now;
}

int __real_openat(int dir, const char *path, int flags, mode_t mode);
ssize_t __real_write(int fd, const void *bytes, size_t n);
int __real_fsync(int fd);
int __real_close(int fd);
int __real_renameat(int dir, const char *from, int to_dir, const char *to);
int __real_unlinkat(int dir, const char *path, int flags);

int __wrap_openat(int dir, const char *path, int flags, mode_t mode) {
    return fails() ? -1 : __real_openat(dir, path, flags, mode);
}
ssize_t __wrap_write(int fd, const void *bytes, size_t n) {
    if (!fails()) return __real_write(fd, bytes, n < 100 ? n : 100); /* a disk may take less than it is given */
    if (__real_write(fd, bytes, n / 2) < 0) errno = EIO;             /* half of it got there */
    return -1;
}
int __wrap_fsync(int fd) {
    return fails() ? -1 : __real_fsync(fd);
}
int __wrap_close(int fd) {
    int closed = __real_close(fd);
    return fails() ? -1 : closed;
}
int __wrap_renameat(int dir, const char *from, int to_dir, const char *to) {
    return fails() ? -1 : __real_renameat(dir, from, to_dir, to);
}
int __wrap_unlinkat(int dir, const char *path, int flags) {
    return fails() ? -1 : __real_unlinkat(dir, path, flags);
}

/* ---- a small state */

enum { N = 20 };
static const char CASE[] = "kind: biaxial\nseed: 1 # the sample\nmu: 0.5\n";
static char dir[64], newest[96], before[128];

typedef struct body {
    double x[N];
    int64_t steps;
    bool open;
} body;

static void keep(body *b, tr_checkpoint *c) {
    TR_KEEP(c, b->x, N);
    TR_KEEP(c, &b->steps, 1);
    TR_KEEP(c, &b->open, 1);
}

static body body_of(int64_t steps) {
    body b = {.steps = steps, .open = steps % 2};
    for (int i = 0; i < N; i++) b.x[i] = (double)steps + 0.1 * i;
    return b;
}

static bool save(int64_t steps, tr_status *st) {
    tr_checkpoint c;
    body b = body_of(steps);
    tr_checkpoint_begin(&c, CASE, st);
    keep(&b, &c);
    return tr_checkpoint_write(&c, dir, TR_CHECKPOINT);
}

static void must_save(int64_t steps) {
    tr_status st = {0};
    if (!save(steps, &st)) fail_msg("%s", st.text);
}

/* The present state; -1: none, or it is refused. */
static int64_t load(const char *text, tr_status *instead, tr_status *st) {
    tr_checkpoint c;
    body b = {.steps = -1};
    *instead = *st = (tr_status){0};
    if (!tr_checkpoint_open(&c, dir, TR_CHECKPOINT, text, instead, st)) return -1;
    assert_true(c.loading);
    keep(&b, &c);
    if (!tr_checkpoint_close(&c)) return -1;
    body wanted = body_of(b.steps);
    assert_memory_equal(b.x, wanted.x, sizeof b.x);
    assert_true(b.open == wanted.open);
    return b.steps;
}

static void assert_loads(int64_t steps) {
    tr_status instead, st;
    assert_int_equal(load(CASE, &instead, &st), steps);
    assert_int_equal(st.code, TR_OK);
    assert_int_equal(instead.code, TR_OK);
}

static void assert_refused(const char *why) {
    tr_status instead, st;
    assert_int_equal(load(CASE, &instead, &st), -1);
    assert_int_equal(st.code, TR_FILE);
    if (!strstr(st.text, why)) fail_msg("no \"%s\" in: %s", why, st.text);
}

static int empty_dir(void **state) {
    (void)state;
    strcpy(dir, "/tmp/trundle-checkpoint-XXXXXX");
    assert_non_null(mkdtemp(dir));
    snprintf(newest, sizeof newest, "%s/checkpoint.bin", dir);
    snprintf(before, sizeof before, "%s.old", newest);
    calls = 0, failing = -1, killed = false;
    return 0;
}

static int remove_dir(void **state) {
    (void)state;
    char part[160];
    snprintf(part, sizeof part, "%s.part", newest);
    remove(newest), remove(before), remove(part);
    return rmdir(dir);
}

static size_t get(const char *path, unsigned char *bytes, size_t room) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t n = fread(bytes, 1, room, file);
    fclose(file);
    return n;
}

static void put(const char *path, const unsigned char *bytes, size_t n) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, n, file), n);
    fclose(file);
}

/* ---- tests */

static void test_what_is_saved_is_loaded(void **state) {
    (void)state;
    assert_loads(-1); /* none: no failure */
    must_save(3);
    assert_loads(3);
    must_save(4);
    assert_loads(4);
    assert_int_equal(remove(newest), 0); /* killed between the two renamings: the one before is there */
    assert_loads(3);
    assert_loads(3); /* and stays */
    tr_checkpoint_remove(dir);
    assert_loads(-1);
}

/* Call after call fails, and then, as if killed, all calls from there on. */
static void test_a_write_that_fails_leaves_the_last_state(void **state) {
    (void)state;
    for (int dead = 0; dead < 2; dead++) {
        int64_t good = 100;
        must_save(good);
        for (int call = 0;; call++) {
            tr_status st = {0};
            killed = dead, failing = call, calls = 0;
            bool ok = save(good + 1, &st);
            int made = calls;
            failing = -1;
            tr_status instead, why;
            int64_t there = load(CASE, &instead, &why);
            if (!ok && st.code != TR_FILE) fail_msg("call %d: no reason given", call);
            if (ok ? there != good + 1 : there != good && there != good + 1)
                fail_msg("call %d of %d: state %lld in place of %lld; %s", call, made, (long long)there,
                         (long long)good, why.text);
            good = there;
            if (call >= made) {
                assert_true(ok && call > 8); /* openat, writes, fsync, close, two renamings, fsync, close */
                break;
            }
        }
    }
}

static void test_every_damaged_byte_is_seen(void **state) {
    (void)state;
    unsigned char whole[2048], hurt[2048];
    must_save(7);
    size_t n = get(newest, whole, sizeof whole);
    assert_true(n > 300 && n < sizeof whole);
    for (size_t i = 0; i < n; i++)
        for (int bit = 0; bit < 8; bit += 7) {
            memcpy(hurt, whole, n);
            hurt[i] ^= (unsigned char)(1 << bit);
            put(newest, hurt, n);
            assert_refused("error: ");
        }
    for (size_t cut = 0; cut < n; cut++) {
        put(newest, whole, cut);
        assert_refused("cut short");
    }
    put(newest, whole, n);
    assert_loads(7);
}

static void test_the_one_before_stands_in_for_a_damaged_one(void **state) {
    (void)state;
    tr_status instead, st;
    must_save(7), must_save(8);
    assert_int_equal(truncate(newest, 200), 0);
    assert_int_equal(load(CASE, &instead, &st), 7);
    assert_non_null(strstr(instead.text, "cut short"));
    assert_loads(7); /* it has become the newest, so that the next one does not replace it by the damaged one */
    must_save(9), must_save(10);
    assert_int_equal(truncate(newest, 200), 0);
    assert_int_equal(truncate(before, 100), 0);
    assert_refused("200 bytes");
}

static void test_what_is_not_ours_is_refused(void **state) {
    (void)state;
    unsigned char bytes[2048];
    tr_status instead, st;
    must_save(6), must_save(7);
    assert_int_equal(load("kind: biaxial\nseed: 2 # the sample\nmu: 0.5\n", &instead, &st), -1);
    assert_int_equal(st.code, TR_FILE);
    assert_non_null(strstr(st.text, "another case: it has `seed: 1`, this case has `seed: 2`"));
    assert_int_equal(load("kind: biaxial\n", &instead, &st), -1);
    assert_non_null(strstr(st.text, "another case"));
    assert_int_equal(load("kind: biaxial\nseed: 1 # of the sample\nmu: 0.5\n", &instead, &st), -1);
    assert_non_null(strstr(st.text, "another version of trundle"));
    size_t n = get(newest, bytes, sizeof bytes);
    bytes[8] = 2; /* the version, behind the magic */
    put(newest, bytes, n);
    assert_refused("has version 2, from a newer trundle");
    put(newest, (const unsigned char *)"once upon a time there was a disk", 33);
    remove(before);
    assert_refused("not a checkpoint");
}

/* A program whose fields differ is told which. */
static void test_other_fields_are_named(void **state) {
    (void)state;
    double y[N] = {0};
    body b = {0};
    for (int which = 0; which < 4; which++) {
        tr_checkpoint c;
        tr_status instead = {0}, st = {0};
        must_save(7);
        assert_true(tr_checkpoint_open(&c, dir, TR_CHECKPOINT, CASE, &instead, &st));
        if (which == 0) TR_KEEP(&c, y, N);
        if (which == 1) TR_KEEP(&c, b.x, N);
        if (which == 2) tr_checkpoint_field(&c, TR_KEPT_NUMBERS, "b->x", b.x, sizeof *b.x, N - 1);
        if (which == 3) keep(&b, &c), TR_KEEP(&c, y, N);
        assert_false(tr_checkpoint_close(&c));
        const char *const said[] = {"it has b->x, 20 of 8 bytes, where this one has y, 20 of 8",
                                    "this one has b.x, 20 of 8", "this one has b->x, 19 of 8",
                                    "it has nothing, 0 of 0 bytes, where this one has y"};
        if (!strstr(st.text, said[which])) fail_msg("%s", st.text);
    }
    tr_checkpoint c;
    tr_status instead = {0}, st = {0};
    assert_true(tr_checkpoint_open(&c, dir, TR_CHECKPOINT, CASE, &instead, &st));
    tr_checkpoint_field(&c, TR_KEPT_NUMBERS, "b->x", b.x, sizeof *b.x, N);
    assert_false(tr_checkpoint_close(&c));
    assert_non_null(strstr(st.text, "it has b->steps, this build does not"));
}

/* Of the newest; the checksum is made good. */
static void overwrite(const char *field, size_t at, const void *with, size_t n) {
    unsigned char bytes[2048];
    size_t size = get(newest, bytes, sizeof bytes);
    unsigned char *record = memmem(bytes, size, field, strlen(field) + 1);
    assert_non_null(record);
    memcpy(record + at, with, n);
    uint64_t sum = tr_hash(TR_HASH_BEGIN, bytes, size - sizeof sum);
    memcpy(bytes + size - sizeof sum, &sum, sizeof sum);
    put(newest, bytes, size);
}

static void test_what_cannot_be_is_refused_behind_a_right_checksum(void **state) {
    (void)state;
    enum { DATA = 64, COUNT = 56 }; /* of a record */
    const double numbers[] = {NAN, INFINITY, -INFINITY};
    const int64_t counts[] = {-1, INT64_MIN, INT64_MAX};
    const unsigned char flags[] = {2, 255};
    const uint64_t lengths[] = {UINT64_MAX, 1 << 20, 2000};
    for (int k = 0; k < 3; k++) {
        must_save(7);
        overwrite("b->x", DATA + 8, &numbers[k], 8);
        assert_refused("the checkpoint is damaged: b->x is out of range");
        must_save(7);
        overwrite("b->steps", DATA, &counts[k], 8);
        assert_refused("the checkpoint is damaged: b->steps is out of range");
        must_save(7);
        overwrite("b->open", DATA, &flags[k % 2], 1);
        assert_refused("the checkpoint is damaged: b->open is out of range");
        must_save(7);
        overwrite("case", COUNT, &lengths[k], 8);
        assert_refused("checkpoint.bin is damaged: it has no case");
        must_save(7);
        overwrite("b->x", COUNT, &lengths[k], 8);
        assert_refused("error: ");
    }
}

/* A list that would not fit into the file is not made room for. */
static void test_a_count_beyond_the_file_is_refused(void **state) {
    (void)state;
    const int wrong[] = {-1, 3, 1 << 30};
    for (int k = 0; k < 3; k++) {
        tr_checkpoint c;
        tr_status instead = {0}, st = {0};
        int n = wrong[k], list[2] = {5, 6};
        tr_checkpoint_begin(&c, CASE, &st);
        TR_KEEP_COUNT(&c, &n, 10 * sizeof *list); /* 72 bytes are there: a record and the list */
        TR_KEEP(&c, list, 2);
        assert_true(tr_checkpoint_write(&c, dir, TR_CHECKPOINT));
        assert_true(tr_checkpoint_open(&c, dir, TR_CHECKPOINT, CASE, &instead, &st));
        TR_KEEP_COUNT(&c, &n, 10 * sizeof *list);
        assert_false(tr_checkpoint_close(&c));
        assert_non_null(strstr(st.text, "the checkpoint is damaged: n is out of range"));
    }
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, empty_dir, remove_dir)
    const struct CMUnitTest tests[] = {
        TEST(test_what_is_saved_is_loaded),
        TEST(test_a_write_that_fails_leaves_the_last_state),
        TEST(test_every_damaged_byte_is_seen),
        TEST(test_the_one_before_stands_in_for_a_damaged_one),
        TEST(test_what_is_not_ours_is_refused),
        TEST(test_other_fields_are_named),
        TEST(test_what_cannot_be_is_refused_behind_a_right_checksum),
        TEST(test_a_count_beyond_the_file_is_refused),
    };
    return cmocka_run_group_tests_name("checkpoint", tests, NULL, NULL);
}
