/* SPDX-License-Identifier: MIT */
/* A run has a number. The caller writes the work, then the number: a thread that reads the new number also sees the
 * work. A chunk is taken by setting its own number from that of the run before to that of this run, which only one
 * thread can do. A late thread fails at that and does not look at the work, which may already be of the next run. */
#include "base/threads.h"

#include "base/alloc.h"
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* Looks at a number before a thread sleeps: about 100 us, longer than most waits in a step of 10,000 disks. */
enum { POLLS = 4000, CACHE_LINE = 64 };

typedef struct member {
    _Alignas(CACHE_LINE) _Atomic uint64_t taken; /* number of the last run in which its chunk was taken */
    tr_threads *threads;
    pthread_t thread; /* of all threads except the first, which is the caller */
} member;

struct tr_threads {
    int n, made; /* chunks; threads that were made */
    int polls;
    void (*work)(void *context, int k);
    void *context;
    pthread_mutex_t lock;
    pthread_cond_t begun, done; /* a run has begun; the last chunk is done */
    atomic_int sleeping;        /* threads that wait for `begun` */
    atomic_bool waiting;        /* the caller waits for `done` */
    atomic_bool closing;
    _Alignas(CACHE_LINE) _Atomic uint64_t run; /* number of the present run */
    _Alignas(CACHE_LINE) atomic_int left;      /* chunks of it that are not done */
    member member[];
};

static void relax(void) {
#ifdef __x86_64__
    __builtin_ia32_pause();
#endif
}

/* With the lock: a thread that goes to sleep holds it from its last look on. */
static void wake(tr_threads *t, pthread_cond_t *who) {
    pthread_mutex_lock(&t->lock);
    pthread_cond_broadcast(who);
    pthread_mutex_unlock(&t->lock);
}

/* The chunk of member k first. */
static void take_shares(tr_threads *t, int k, uint64_t run) {
    for (int i = 0; i < t->n; i++) {
        int chunk = (k + i) % t->n;
        uint64_t before = run - 1;
        if (!atomic_compare_exchange_strong(&t->member[chunk].taken, &before, run)) continue;
        t->work(t->context, chunk);
        if (atomic_fetch_sub(&t->left, 1) == 1 && atomic_load(&t->waiting)) wake(t, &t->done);
    }
}

/* The number of a run after `seen`. */
static uint64_t wait_for_run(tr_threads *t, uint64_t seen) {
    for (int i = 0; i < t->polls; i++) {
        if (atomic_load_explicit(&t->run, memory_order_relaxed) != seen) return atomic_load(&t->run);
        relax();
    }
    pthread_mutex_lock(&t->lock);
    atomic_fetch_add(&t->sleeping, 1); /* before the last look: the caller polls at it after it has begun a run */
    while (atomic_load(&t->run) == seen) pthread_cond_wait(&t->begun, &t->lock);
    atomic_fetch_sub(&t->sleeping, 1);
    pthread_mutex_unlock(&t->lock);
    return atomic_load(&t->run);
}

static void wait_until_done(tr_threads *t) {
    for (int i = 0; i < t->polls; i++) {
        if (atomic_load(&t->left) == 0) return;
        relax();
    }
    pthread_mutex_lock(&t->lock);
    atomic_store(&t->waiting, true);
    while (atomic_load(&t->left) > 0) pthread_cond_wait(&t->done, &t->lock);
    atomic_store(&t->waiting, false);
    pthread_mutex_unlock(&t->lock);
}

static void begin(tr_threads *t) {
    atomic_fetch_add(&t->run, 1);
    if (atomic_load(&t->sleeping)) wake(t, &t->begun);
}

static void *live(void *context) {
    member *m = context;
    tr_threads *t = m->threads;
    for (uint64_t run = 0;;) {
        run = wait_for_run(t, run);
        if (atomic_load(&t->closing)) return NULL;
        take_shares(t, (int)(m - t->member), run);
    }
}

/* A new thread inherits the mask of its maker. */
static int make_threads(tr_threads *t) {
    sigset_t all, before;
    int error = 0;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    for (; !error && t->made < t->n - 1; t->made += !error) {
        member *m = &t->member[t->made + 1];
        m->threads = t;
        error = pthread_create(&m->thread, NULL, live, m);
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return error;
}

tr_threads *tr_threads_new(int n, tr_status *st) {
    tr_threads *t = tr_alloc(1, sizeof *t + (size_t)n * sizeof *t->member, st);
    if (!t) return NULL;
    t->n = n, t->polls = tr_processors() < n ? 0 : POLLS;
    pthread_mutex_init(&t->lock, NULL);
    pthread_cond_init(&t->begun, NULL), pthread_cond_init(&t->done, NULL);
    int error = make_threads(t);
    if (!error) return t;
    tr_status_fail(st, TR_FILE, "error: cannot make %d threads: %s; the system allows %d now", n, strerror(error),
                   t->made + 1);
    tr_threads_free(t);
    return NULL;
}

void tr_threads_free(tr_threads *t) {
    if (!t) return;
    atomic_store(&t->closing, true);
    begin(t);
    for (int k = 1; k <= t->made; k++) pthread_join(t->member[k].thread, NULL);
    pthread_cond_destroy(&t->begun), pthread_cond_destroy(&t->done);
    pthread_mutex_destroy(&t->lock);
    free(t);
}

int tr_threads_count(const tr_threads *t) {
    return t ? t->n : 1;
}

void tr_threads_run(tr_threads *t, void (*work)(void *context, int k), void *context) {
    if (!t) {
        work(context, 0);
        return;
    }
    t->work = work, t->context = context;
    atomic_store(&t->left, t->n);
    begin(t);
    take_shares(t, 0, atomic_load(&t->run));
    wait_until_done(t);
}

int tr_processors(void) {
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) ? 1 : CPU_COUNT(&set);
}
