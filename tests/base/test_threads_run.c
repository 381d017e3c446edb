/* SPDX-License-Identifier: MIT */
/* The threads themselves, without physics: each share is done once and before the run returns, whatever the number of
 * threads and of processors; nothing is left of threads that were freed; signals go to the caller. */
#include "assert_close.h"
#include "base/threads.h"
#include <dirent.h>
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <string.h>
#include <unistd.h>

enum { MOST = 8 };

static tr_threads *new_threads(int n) {
    tr_status st = {0};
    tr_threads *threads = tr_threads_new(n, &st);
    if (!threads) fail_msg("%s", st.text);
    return threads;
}

static int living(void) {
    int n = 0;
    DIR *tasks = opendir("/proc/self/task");
    assert_non_null(tasks);
    for (struct dirent *d; (d = readdir(tasks));) n += d->d_name[0] != '.';
    closedir(tasks);
    return n;
}

/* A joined thread may stand in the list of the system for a moment. */
static void wait_for_living(int n) {
    for (int tries = 0; living() != n && tries < 1000; tries++) usleep(1000);
    assert_int_equal(living(), n);
}

/* Plain numbers: a run that returned too early, or a share that is done twice at a time, is a race that ThreadSanitizer
 * sees too. */
typedef struct counted {
    long done[MOST], seen, slow;
} counted;

static void count(void *context, int k) {
    counted *c = context;
    c->done[k]++;
    if (k == c->slow) usleep(200); /* longer than a thread looks before it sleeps */
}

static void each_share_is_done_once_in_every_run(void **state) {
    (void)state;
    for (int n = 1; n <= MOST; n++) {
        tr_threads *threads = new_threads(n);
        counted c = {.slow = -1};
        assert_int_equal(tr_threads_count(threads), n);
        for (int run = 1; run <= 5000; run++) {
            tr_threads_run(threads, count, &c);
            for (int k = 0; k < n; k++) assert_int_equal(c.done[k], run);
        }
        for (int k = n; k < MOST; k++) assert_int_equal(c.done[k], 0);
        tr_threads_free(threads);
    }
}

/* Threads that sleep are woken, and so is a caller. */
static void a_slow_share_and_a_pause_lose_nothing(void **state) {
    (void)state;
    for (int n = 2; n <= 4; n++) {
        tr_threads *threads = new_threads(n);
        counted c = {0};
        for (int run = 1; run <= 300; run++) {
            c.slow = run % n;
            if (run % 3 == 0) usleep(300); /* all sleep */
            tr_threads_run(threads, count, &c);
            for (int k = 0; k < n; k++) assert_int_equal(c.done[k], run);
        }
        tr_threads_free(threads);
    }
}

/* Another context and work in each run: one that comes late must not take what is not meant for it. */
static void add(void *context, int k) {
    if (k == 0) ((counted *)context)->seen++;
    ((counted *)context)->done[k] += k;
}

static void work_and_context_are_those_of_the_run(void **state) {
    (void)state;
    tr_threads *threads = new_threads(3);
    for (int run = 0; run < 3000; run++) {
        counted a = {.slow = -1}, b = {0};
        tr_threads_run(threads, count, &a);
        tr_threads_run(threads, add, &b);
        for (int k = 0; k < 3; k++) assert_true(a.done[k] == 1 && b.done[k] == k);
        assert_true(a.seen == 0 && b.seen == 1);
    }
    tr_threads_free(threads);
}

static void no_threads_are_the_caller(void **state) {
    (void)state;
    counted c = {.slow = -1};
    assert_int_equal(tr_threads_count(NULL), 1);
    tr_threads_run(NULL, count, &c);
    assert_int_equal(c.done[0], 1);
    tr_threads_free(NULL);
}

static void threads_are_gone_when_freed(void **state) {
    (void)state;
    int before = living();
    for (int round = 0; round < 3000; round++) {
        tr_threads *threads = new_threads(1 + round % MOST);
        counted c = {.slow = -1};
        if (round % 100 == 0) assert_int_equal(living(), before + round % MOST);
        if (round % 2) tr_threads_run(threads, count, &c);
        tr_threads_free(threads);
        for (int k = 0; k < MOST; k++) assert_int_equal(c.done[k], round % 2 && k <= round % MOST);
    }
    wait_for_living(before);
}

static void two_sets_do_not_meet(void **state) {
    (void)state;
    tr_threads *one = new_threads(2), *two = new_threads(3);
    counted a = {.slow = -1}, b = {.slow = -1};
    for (int run = 1; run <= 2000; run++) tr_threads_run(one, count, &a), tr_threads_run(two, count, &b);
    for (int k = 0; k < 3; k++) assert_true(a.done[k] == (k < 2 ? 2000 : 0) && b.done[k] == 2000);
    tr_threads_free(one), tr_threads_free(two);
}

static atomic_int caught, elsewhere;
static pid_t caller;

static void handler(int number) {
    (void)number;
    caught++;
    if (gettid() != caller) elsewhere++;
}

/* Sent to the process, while the caller is at work and the others wait. */
static void signals_go_to_the_caller(void **state) {
    (void)state;
    caller = gettid();
    struct sigaction action = {.sa_handler = handler}, old;
    sigset_t mask[2], usr1;
    sigemptyset(&usr1), sigaddset(&usr1, SIGUSR1);
    pthread_sigmask(SIG_SETMASK, NULL, &mask[0]);
    sigaction(SIGUSR1, &action, &old);
    tr_threads *threads = new_threads(4);
    pthread_sigmask(SIG_SETMASK, NULL, &mask[1]);
    assert_int_equal(sigismember(&mask[0], SIGUSR1), sigismember(&mask[1], SIGUSR1)); /* the caller's is as it was */
    pthread_sigmask(SIG_BLOCK, &usr1, NULL);
    kill(getpid(), SIGUSR1); /* no thread may have it now: it waits */
    counted c = {.slow = -1};
    for (int run = 0; run < 100; run++) tr_threads_run(threads, count, &c);
    usleep(1000);
    assert_int_equal(caught, 0);
    pthread_sigmask(SIG_UNBLOCK, &usr1, NULL);
    assert_int_equal(caught, 1);
    assert_int_equal(elsewhere, 0);
    tr_threads_free(threads);
    sigaction(SIGUSR1, &old, NULL);
}

/* Threads that the system still gives. The linker puts this in the place of pthread_create. */
static int given = 1 << 30;

int __real_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *), void *context);
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *), void *context);
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *), void *context) {
    return given-- > 0 ? __real_pthread_create(thread, attributes, start, context) : EAGAIN;
}

static void a_system_without_threads_is_told(void **state) {
    (void)state;
    int before = living();
    for (int n = 0; n < 3; n++) {
        tr_status st = {0};
        given = n;
        assert_null(tr_threads_new(5, &st));
        assert_int_equal(st.code, TR_FILE);
        assert_non_null(strstr(st.text, "5 threads"));
    }
    given = 1 << 30;
    wait_for_living(before);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_share_is_done_once_in_every_run),
                                       cmocka_unit_test(a_slow_share_and_a_pause_lose_nothing),
                                       cmocka_unit_test(work_and_context_are_those_of_the_run),
                                       cmocka_unit_test(no_threads_are_the_caller),
                                       cmocka_unit_test(threads_are_gone_when_freed),
                                       cmocka_unit_test(two_sets_do_not_meet),
                                       cmocka_unit_test(signals_go_to_the_caller),
                                       cmocka_unit_test(a_system_without_threads_is_told)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
