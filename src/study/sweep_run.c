/* SPDX-License-Identifier: MIT */
/* Runs the points of a grid as child processes of this same program: a point that fails, or is killed because memory is
 * short, does not affect the others. A point gives the same bytes as `trundle run` by hand.
 *
 * A run dies with the process that started it (PR_SET_PDEATHSIG), and locks its directory (tr_dir_lock). So after a
 * kill and a new start, two runs never work in one directory. */

#include "study/sweep_run.h"

#include "base/alloc.h"
#include "base/hash.h"
#include "out/dir.h"
#include "out/manifest.h"
#include "study/packing.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

typedef struct job {
    pid_t pid; /* 0: free */
    int point;
} job;

typedef struct runner {
    const tr_grid *g;
    const tr_grid_options *o;
    tr_grid_report *report;
    tr_point_state *state; /* of points first ... end - 1 */
    job *jobs;
    int running;
    tr_status *st;
} runner;

static void say(const runner *r, int point, const char *format, ...) __attribute__((format(printf, 3, 4)));
static void say(const runner *r, int point, const char *format, ...) {
    char name[TR_POINT_NAME], what[1200], line[1600];
    va_list args;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    tr_grid_name(r->g, point, name);
    snprintf(line, sizeof line, "point %d (%s): %s", point, name, what);
    if (r->o->say) r->o->say(r->o->context, line);
}

static bool stopped(const runner *r) {
    return r->o->stop && *r->o->stop;
}

static void show(const runner *r, const char *stage, int done, int of) {
    if (r->o->progress) r->o->progress(r->o->context, stage, of ? (double)done / of : 1);
}

/* In the child: only calls that are safe between fork and exec. */
static void become(char *const *arguments, const char *log, pid_t parent) {
    unlink(log); /* it may be a link: results are not written through links */
    int file = open(log, O_WRONLY | O_CREAT | O_EXCL, 0666), null = open("/dev/null", O_RDWR);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() == parent && file >= 0 && dup2(null, 0) >= 0 && dup2(null, 1) >= 0 && dup2(file, 2) >= 0)
        execv("/proc/self/exe", arguments);
    raise(SIGKILL);
}

/* The command of a child: trundle run BASE --force|--resume -o PATH --sample FILE --set ... */
typedef struct order {
    char path[TR_PATH], log[TR_PATH], sample[TR_PATH];
    bool begun;
    char **sets;
} order;

static pid_t start(const tr_grid *g, const order *what, tr_status *st) {
    const char **arguments = tr_alloc((size_t)g->n_axes * 2 + 9, sizeof *arguments, st);
    if (!arguments) return -1;
    int n = 0;
    const char *const head[] = {"trundle", "run",      g->base,    what->begun ? "--resume" : "--force",
                                "-o",      what->path, "--sample", what->sample};
    for (; n < (*what->sample ? 8 : 6); n++) arguments[n] = head[n];
    for (int i = 0; i < g->n_axes; i++) arguments[n++] = "--set", arguments[n++] = what->sets[i];
    pid_t parent = getpid(), pid = fork();
    if (pid == 0) become((char *const *)arguments, what->log, parent);
    if (pid < 0) tr_status_fail(st, TR_FILE, "error: cannot start a run: %s", strerror(errno));
    free(arguments);
    return pid;
}

static void fail(runner *r, int point, tr_code code, const char *what) {
    if (!r->report->failed++ || code < r->report->code) r->report->code = code;
    say(r, point, "%s", what);
}

/* DIR/samples/HASH.bin: points with the same sample use one file. "" for other kinds. */
static bool name_sample(const runner *r, int point, char sample[TR_PATH]) {
    char name[32], samples[TR_PATH];
    tr_scene scene;
    if (!tr_grid_scene(r->g, point, &scene, r->st)) return false;
    bool compacts = scene.kind == TR_KIND_BIAXIAL;
    char *text = compacts ? tr_packing_text(&scene, r->st) : NULL;
    tr_scene_free(&scene);
    *sample = '\0';
    if (!text) return !compacts;
    snprintf(name, sizeof name, "%016llx.bin", (unsigned long long)tr_hash(TR_HASH_BEGIN, text, strlen(text)));
    free(text);
    return tr_dir_make(r->o->dir, "samples", r->st) && tr_dir_path(samples, r->o->dir, "samples", r->st) &&
           tr_dir_path(sample, samples, name, r->st);
}

/* False: no further point can be started. */
static bool begin(runner *r, job *free_job, int point) {
    char name[TR_POINT_NAME], log[TR_POINT_NAME + 8];
    order what = {.begun = r->state[point - r->o->first] == TR_POINT_BEGUN};
    tr_grid_name(r->g, point, name);
    snprintf(log, sizeof log, "%s/log", name);
    if (!tr_dir_make(r->o->dir, name, r->st) || !tr_manifest_add(r->o->dir, log, r->st) ||
        !tr_dir_path(what.path, r->o->dir, name, r->st) ||
        !tr_dir_path(what.log, what.path, "log", r->st) || !name_sample(r, point, what.sample))
        return false;
    what.sets = tr_grid_sets(r->g, point, r->st);
    pid_t pid = what.sets ? start(r->g, &what, r->st) : -1;
    tr_grid_sets_free(r->g, what.sets);
    if (pid < 0) return false;
    *free_job = (job){pid, point};
    r->running++;
    return true;
}

/* The last message in the log of a run. */
static void read_error(const char *dir, const char *name, int status, char *text, size_t size) {
    char path[TR_PATH];
    tr_status ignored = {0};
    size_t n = 0;
    if (tr_dir_path(path, dir, name, &ignored) && strlen(path) + 5 < sizeof path) {
        FILE *log = fopen(strcat(path, "/log"), "r");
        if (log) n = fread(text, 1, size - 1, log), fclose(log);
    }
    while (n && text[n - 1] == '\n') n--;
    text[n] = '\0';
    if (WIFSIGNALED(status))
        snprintf(text, size, "error: ended by signal %d, %s", WTERMSIG(status), strsignal(WTERMSIG(status)));
    else if (n == 0)
        snprintf(text, size, "error: exit code %d", WEXITSTATUS(status));
}

/* Of a run that did not finish. A run that ended by a signal counts as short of memory: TR_FILE. */
static tr_code code_of(int status) {
    int code = WIFEXITED(status) ? WEXITSTATUS(status) : TR_FILE;
    return code == TR_BAD_CASE || code == TR_NUMERICAL ? (tr_code)code : TR_FILE;
}

/* Only the directory of a point shows whether it is finished. */
static void end(runner *r, job *j, int status) {
    char name[TR_POINT_NAME], text[1024];
    tr_point_state state = TR_POINT_MISSING;
    tr_status inner = {0};
    tr_grid_name(r->g, j->point, name);
    if (tr_grid_state(r->g, j->point, r->o->dir, &state, &inner) && state == TR_POINT_FINISHED) {
        r->report->ran++;
    } else if (!stopped(r)) {
        read_error(r->o->dir, name, status, text, sizeof text);
        fail(r, j->point, inner.code ? inner.code : code_of(status), inner.code ? inner.text : text);
    }
    *j = (job){0};
    r->running--;
}

static void take_ended(runner *r) {
    for (int i = 0; i < r->o->jobs; i++) {
        int status;
        if (r->jobs[i].pid && waitpid(r->jobs[i].pid, &status, WNOHANG) == r->jobs[i].pid) end(r, &r->jobs[i], status);
    }
}

/* Every point is checked before the first one runs. */
static bool look(runner *r, int *missing) {
    int n = r->o->end - r->o->first;
    for (int i = 0; i < n; i++) {
        if (stopped(r)) return tr_status_fail(r->st, TR_INTERRUPTED, "stopped before the first point");
        if (!tr_grid_state(r->g, r->o->first + i, r->o->dir, &r->state[i], r->st)) return false;
        bool done = r->state[i] == TR_POINT_FINISHED, look_closer = n == 1 || r->o->first + i < r->g->combinations;
        if (!done && look_closer && !tr_grid_check(r->g, r->o->first + i, r->st)) return false;
        r->report->before += done, *missing += !done;
        show(r, "checking", i + 1, n);
    }
    return true;
}

/* Tables that would be overwritten are found before the first point runs. */
static bool claim(const runner *r) {
    const char *dir = r->o->dir;
    return tr_dir_make(dir, ".", r->st) && tr_manifest_add(dir, "points.csv", r->st) &&
           tr_manifest_add(dir, "collect.csv", r->st);
}

static const char *const again[TR_POINT_FINISHED] = {
    [TR_POINT_OTHER] = "another case",
    [TR_POINT_BROKEN] = "an incomplete summary.json",
    [TR_POINT_OLD] = "a run of another version of trundle",
    [TR_POINT_LACKING] = "a summary.json without a number to collect",
};

static void run_all(runner *r, int missing) {
    bool ended = false;
    int next = r->o->first;
    for (;;) {
        take_ended(r);
        show(r, "points", r->report->ran + r->report->failed, missing);
        if (stopped(r) && !ended) {
            for (int i = 0; i < r->o->jobs; i++)
                if (r->jobs[i].pid) kill(r->jobs[i].pid, SIGTERM);
            ended = true;
        }
        while (next < r->o->end && r->state[next - r->o->first] == TR_POINT_FINISHED) next++;
        bool more = next < r->o->end && !ended && !r->st->code;
        if (!more && !r->running) break;
        job *j = r->jobs;
        while (j < r->jobs + r->o->jobs && j->pid) j++;
        if (more && j < r->jobs + r->o->jobs) {
            const char *why = again[r->state[next - r->o->first]];
            if (why) say(r, next, "note: its directory has %s; it runs again", why);
            begin(r, j, next++);
        } else {
            nanosleep(&(struct timespec){.tv_nsec = 5000000}, NULL);
        }
    }
}

bool tr_grid_run(const tr_grid *g, const tr_grid_options *o, tr_grid_report *report, tr_status *st) {
    *report = (tr_grid_report){0};
    runner r = {.g = g, .o = o, .report = report, .st = st};
    int missing = 0;
    r.state = tr_alloc((size_t)(o->end - o->first), sizeof *r.state, st);
    r.jobs = tr_alloc((size_t)o->jobs, sizeof *r.jobs, st);
    if (r.state && r.jobs && look(&r, &missing) && claim(&r)) run_all(&r, missing);
    free(r.state);
    free(r.jobs);
    if (stopped(&r))
        tr_status_fail(st, TR_INTERRUPTED, "stopped: %d of %d points are finished; the same command continues",
                       report->before + report->ran, o->end - o->first);
    if (report->failed)
        tr_status_fail(st, report->code, "error: %d of %d points failed; their messages are in %s/POINT/log",
                       report->failed, o->end - o->first, o->dir);
    return !st->code;
}
