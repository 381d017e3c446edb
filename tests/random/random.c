/* SPDX-License-Identifier: MIT */
/* Random scenes. Each runs by one thread, by several, and with stops (SIGKILL, SIGTERM, SIGINT, SIGHUP) and
 * --resume. What must hold: an exit code that a valid scene may have, no signal, no hang, and what oracles.h says. The
 * library runs the scenes as `trundle run` does, but that threads share the work of the smallest.
 *
 * usage: random DIR N SEED      N scenes; of what went wrong the scene and its runs stay in DIR/SEED-NUMBER
 *        random DIR FILE.yaml   one scene */
#include "base/random.h"
#include "base/threads.h"
#include "cli/stop.h"
#include "laws/law.h"
#include "random/oracles.h"
#include "random/scenes.h"
#include "study/run.h"
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { LIMIT = 60, MOST_STOPS = 3, DRAFTS = 20, HANGS = 1000, MOST_PATH = 400 };

/* Shared by the processes that judge scenes. */
static struct counts { atomic_int scenes, failed, stops, runs, refused, code[5], kind[4]; } * counts;

/* ---- one run, in a process of its own ---- */

typedef struct job {
    const char *scene, *home; /* the results are home/out, the message home/message */
    int threads;
    bool resume;
    double checkpoint;
} job;

static void work(const job *j) {
    static tr_run_report report;
    tr_status st = {0};
    tr_scene scene;
    const volatile sig_atomic_t *stop = tr_cli_stop();
    alarm(LIMIT);
    if (chdir(j->home) || !freopen("/dev/null", "w", stdout)) exit(99);
    if (tr_scene_read_file(&scene, j->scene, NULL, 0, tr_laws_catalog(), &st)) {
        tr_run_options o = {.dir = "out",
                            .title = "random",
                            .resume = j->resume,
                            .checkpoint = j->checkpoint,
                            .threads = j->threads,
                            .share_few = true,
                            .stop = stop};
        tr_run(&scene, &o, &report, &st);
        tr_scene_free(&scene);
    }
    FILE *file = fopen("message", "w");
    if (!file) exit(99);
    fprintf(file, "%s\n", st.text);
    fclose(file);
    exit(st.code ? (int)st.code : report.failed ? TR_CHECK_FAILED : TR_OK);
}

static pid_t start(const job *j) {
    fflush(NULL);
    mkdir(j->home, 0777);
    pid_t pid = fork();
    if (pid == 0) work(j);
    counts->runs++;
    return pid;
}

/* The exit code; 1000 for a hang, 1000 + N for another signal. */
static int end(pid_t pid) {
    int status;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status)) return WEXITSTATUS(status);
    return WTERMSIG(status) == SIGALRM ? HANGS : HANGS + WTERMSIG(status);
}

/* ---- one scene ---- */

typedef struct judge {
    char home[MOST_PATH], scene[MOST_PATH + 16], path[3][MOST_PATH + 16];
    tr_random random;
    oracle_text why;
    double seconds; /* of the first run */
} judge;

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void message(const char *home, char *text, size_t size) {
    char path[MOST_PATH + 32];
    snprintf(path, sizeof path, "%s/message", home);
    FILE *f = fopen(path, "r");
    size_t n = f ? fread(text, 1, size - 1, f) : 0;
    text[n] = '\0';
    if (f) fclose(f);
}

static bool fail(judge *j, const char *what, int code, const char *home) {
    char said[600];
    message(home, said, sizeof said);
    if (code >= HANGS)
        snprintf(j->why.text, sizeof j->why.text, "%s: %s %d", what, code == HANGS ? "no end after s:" : "signal",
                 code == HANGS ? LIMIT : code - HANGS);
    else
        snprintf(j->why.text, sizeof j->why.text, "%s: exit code %d, %s", what, code, said);
    return false;
}

static bool all_same(judge *j, const char *what, int code, int expected, const char *home) {
    char said[1100], first[1100], out[2][MOST_PATH + 32];
    bool finished = expected == TR_CHECK_FAILED && code == TR_OK; /* it has told that before, and is left as it is */
    if (code != expected && !finished) return fail(j, what, code, home);
    message(home, said, sizeof said), message(j->path[0], first, sizeof first);
    snprintf(out[0], sizeof out[0], "%s/out", home), snprintf(out[1], sizeof out[1], "%s/out", j->path[0]);
    if (strcmp(said, first) == 0 && oracle_same(out[0], out[1], &j->why)) return true;
    if (strcmp(said, first) != 0) snprintf(j->why.text, sizeof j->why.text, "%s: %.400s", what, said);
    return false;
}

/* From least to 4; more are slower. */
static int threads_of(judge *j, int least) {
    int n = 1 + (int)(tr_random_next(&j->random) % 4);
    return n < least || tr_random_next(&j->random) % 2 ? least : n;
}

static bool with_stops(judge *j, int expected) {
    static const int signals[] = {SIGKILL, SIGTERM, SIGINT, SIGHUP};
    int code = TR_INTERRUPTED;
    for (int stops = 0; stops < MOST_STOPS; stops++) {
        double when = j->seconds * 1.1 * tr_random_uniform(&j->random);
        int number = signals[tr_random_next(&j->random) % 4];
        double checkpoint = tr_random_next(&j->random) % 2 ? 0 : 0.5 * j->seconds;
        int threads = threads_of(j, 1);
        pid_t pid = start(&(job){j->scene, j->path[2], threads, true, checkpoint});
        usleep((useconds_t)(1e6 * when));
        kill(pid, number);
        code = end(pid);
        if (code == HANGS + number || code == TR_INTERRUPTED)
            counts->stops++;
        else if (code == expected)
            break;
        else
            return fail(j, "with stops", code, j->path[2]);
    }
    if (code != expected) code = end(start(&(job){j->scene, j->path[2], 1, true, 60}));
    return all_same(j, "after stops", code, expected, j->path[2]);
}

static bool judge_scene(judge *j) {
    tr_status st = {0};
    tr_scene scene;
    char out[MOST_PATH + 32];
    double started = now();
    int code = end(start(&(job){j->scene, j->path[0], 1, false, 60}));
    j->seconds = now() - started;
    if (code != TR_OK && code != TR_CHECK_FAILED && code != TR_NUMERICAL) return fail(j, "run", code, j->path[0]);
    counts->code[code]++;
    if (!tr_scene_read_file(&scene, j->scene, NULL, 0, tr_laws_catalog(), &st)) return false;
    counts->kind[scene.kind]++;
    snprintf(out, sizeof out, "%s/out", j->path[0]);
    bool ok = oracle_numbers(out, &j->why);
    if (ok && code != TR_NUMERICAL) ok = oracle_inside(&scene, out, &j->why) && oracle_energy(&scene, out, &j->why);
    tr_scene_free(&scene);
    int threads = threads_of(j, 2);
    if (ok) ok = all_same(j, "threads", end(start(&(job){j->scene, j->path[1], threads, false, 0})), code, j->path[1]);
    return ok && with_stops(j, code);
}

static void sweep_out(const char *dir) {
    char command[MOST_PATH + 32];
    snprintf(command, sizeof command, "rm -rf '%s'", dir);
    if (system(command)) perror(dir);
}

/* By a process, for a scene may end that too. */
static int draft(const char *path, uint64_t seed) {
    static const char *const trial[] = {"cell would be too thin", "is out of reach", "too long for a test"};
    fflush(NULL);
    pid_t pid = fork();
    if (pid == 0) {
        tr_status st = {0};
        alarm(LIMIT);
        bool ok = scenes_write(path, seed, &st);
        bool known = false;
        for (size_t k = 0; k < sizeof trial / sizeof *trial; k++) known |= strstr(st.text, trial[k]) != NULL;
        if (!ok && !known) fprintf(stderr, "%s: %s\n", path, st.text);
        exit(ok ? TR_OK : known ? TR_BAD_CASE : 99);
    }
    return end(pid);
}

static void judge_one(const char *dir, const char *name, uint64_t seed, const char *file) {
    static judge j;
    bool ok = true;
    snprintf(j.home, sizeof j.home, "%s/%s", dir, name);
    sweep_out(j.home);
    mkdir(j.home, 0777);
    snprintf(j.scene, sizeof j.scene, "%s/scene.yaml", j.home);
    static const char *const part[] = {"one", "threads", "stops"};
    for (int k = 0; k < 3; k++) snprintf(j.path[k], sizeof j.path[k], "%s/%s", j.home, part[k]);
    if (file && !realpath(file, j.scene)) ok = false, snprintf(j.why.text, sizeof j.why.text, "cannot read %s", file);
    for (int k = 0; !file && k < DRAFTS; k++) {
        int code = draft(j.scene, seed * 1000 + (uint64_t)k);
        ok = code == TR_OK;
        if (ok) break;
        counts->refused++;
        if (code != TR_BAD_CASE) fail(&j, "draft", code, j.home), k = DRAFTS;
    }
    j.random = tr_random_seed(seed, 2);
    ok = ok && judge_scene(&j);
    counts->scenes++;
    if (ok)
        sweep_out(j.home);
    else
        printf("not ok %s: %s\n", j.scene, j.why.text), counts->failed++;
    fflush(stdout);
}

int main(int argc, char **argv) {
    char dir[MOST_PATH / 2];
    counts = mmap(NULL, sizeof *counts, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (argc < 3 || counts == MAP_FAILED) return fprintf(stderr, "usage: random DIR N SEED | random DIR FILE...\n"), 2;
    mkdir(argv[1], 0777);
    char *full = realpath(argv[1], NULL);
    if (!full) return perror(argv[1]), 3;
    snprintf(dir, sizeof dir, "%s", full);
    free(full);
    bool files = strstr(argv[2], ".yaml");
    int n = files ? argc - 2 : atoi(argv[2]), workers = tr_processors();
    uint64_t seed = argc > 3 && !files ? strtoull(argv[3], NULL, 10) : 1;
    double started = now();
    fflush(NULL);
    for (int w = 0; w < workers; w++) {
        if (fork()) continue;
        for (int i = w; i < n; i += workers) {
            char name[64];
            snprintf(name, sizeof name, files ? "file-%.0d%d" : "%d-%d", files ? 0 : (int)seed, i);
            judge_one(dir, name, seed * 1000000 + (uint64_t)i, files ? argv[i + 2] : NULL);
        }
        exit(0);
    }
    while (wait(NULL) > 0) {
    }
    printf("%d scenes (%d biaxial, %d bodies, %d contact, %d patch; ended with 0: %d, 1: %d, 4: %d; %d drafts "
           "refused), %d runs, "
           "%d stops, %.0f s: %d failed\n",
           counts->scenes, counts->kind[0], counts->kind[1], counts->kind[2], counts->kind[3], counts->code[0],
           counts->code[1], counts->code[4], counts->refused, counts->runs, counts->stops, now() - started,
           counts->failed);
    return counts->failed || counts->scenes != n;
}
