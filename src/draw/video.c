/* SPDX-License-Identifier: MIT */
/* Films: raw frames through a socket to ffmpeg; GIFs: ffmpeg again, from the finished film.
 *
 * A socket rather than a pipe, because send() can be told not to raise SIGPIPE when ffmpeg dies. ffmpeg gets its own
 * process group, so that Ctrl-C reaches only trundle and the film so far ends properly. ffmpeg's messages go to memory
 * and are shown only as the reason of a failure. */
#include "draw/video.h"

#include "base/alloc.h"
#include "base/temporary.h"
#include "base/program.h"
#include "draw/canvas.h"
#include <errno.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

struct tr_video {
    char *path, *part;
    pid_t pid;
    int input, log; /* our end of the socket; the messages of ffmpeg */
    int frames;     /* whole frames sent */
    bool broken;    /* a frame was cut short */
};

bool tr_video_available(void) {
    return tr_program_available("ffmpeg");
}

/* "file:" and the path: a URL of its own protocol, so that a colon or a dash in the path means nothing. NULL: no
 * memory. */
static char *url_of(const char *path, tr_status *st) {
    char *url = tr_alloc(strlen(path) + sizeof "file:", 1, st);
    return url ? strcat(strcpy(url, "file:"), path) : NULL;
}

/* part: the file that it writes. input: -1 for none */
static bool spawn(pid_t *pid, const char *const args[], const char *part, int input, int log, tr_status *st) {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attr;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attr);
    int error = input >= 0 ? posix_spawn_file_actions_adddup2(&files, input, 0) : 0;
    if (!error) error = posix_spawn_file_actions_adddup2(&files, log, 1);
    if (!error) error = posix_spawn_file_actions_adddup2(&files, log, 2);
    posix_spawnattr_setflags(&attr, POSIX_SPAWN_SETPGROUP);
    if (!error) error = posix_spawnp(pid, "ffmpeg", &files, &attr, (char *const *)args, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attr);
    if (error) remove(part);
    return error == 0 || tr_status_fail(st, TR_FILE, "error: cannot start ffmpeg: %s", strerror(error));
}

static bool start(tr_video *v, int input, int frames_per_second, tr_status *st) {
    char size[32], rate[32];
    snprintf(size, sizeof size, "%dx%d", TR_FRAME_WIDTH, TR_FRAME_HEIGHT);
    snprintf(rate, sizeof rate, "%d", frames_per_second);
    char *url = url_of(v->part, st);
    const char *args[] = {"ffmpeg",  "-nostdin", "-loglevel", "error",    "-f",        "rawvideo",  "-pix_fmt",
                          "bgr0",    "-s",       size,        "-r",       rate,        "-i",        "pipe:0",
                          "-c:v",    "libx264",  "-preset",   "veryfast", "-threads",  "2",         "-pix_fmt",
                          "yuv420p", "-flags:v", "+bitexact", "-fflags",  "+bitexact", "-movflags", "+faststart",
                          "-f",      "mp4",      "-y",        url,        NULL};
    bool ok = url && spawn(&v->pid, args, v->part, input, v->log, st);
    free(url);
    return ok;
}

static void release(tr_video *v) {
    if (v->input >= 0) close(v->input);
    if (v->log >= 0) close(v->log);
    free(v->path);
    free(v->part);
    free(v);
}

tr_video *tr_video_open(const char *path, int frames_per_second, tr_status *st) {
    tr_video *v = tr_alloc(1, sizeof *v, st);
    if (!v) return NULL;
    int end[2] = {-1, -1};
    v->log = memfd_create("ffmpeg", MFD_CLOEXEC);
    v->input = -1;
    v->part = tr_temporary_name(path, st);
    v->path = tr_alloc(strlen(path) + 1, 1, st);
    bool ok = v->part && v->path;
    if (ok) strcpy(v->path, path);
    if (ok && (v->log < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, end) != 0))
        ok = tr_status_fail(st, TR_FILE, "error: cannot start ffmpeg: %s", strerror(errno));
    v->input = end[1];
    ok = ok && start(v, end[0], frames_per_second, st);
    if (end[0] >= 0) close(end[0]);
    if (ok) return v;
    release(v);
    return NULL;
}

/* ffmpeg's messages, without the line break at the end; "": none. */
static void read_log(int log, char *text, size_t size) {
    ssize_t n = pread(log, text, size - 1, 0);
    while (n > 0 && text[n - 1] == '\n') n--;
    text[n > 0 ? n : 0] = 0;
}

bool tr_video_frame(tr_video *v, const tr_canvas *canvas, tr_status *st) {
    const unsigned char *at = tr_canvas_pixels(canvas), *end = at + 4 * TR_FRAME_WIDTH * TR_FRAME_HEIGHT;
    while (at < end) {
        ssize_t n = send(v->input, at, (size_t)(end - at), MSG_NOSIGNAL);
        if (n >= 0) {
            at += n;
        } else if (errno != EINTR) {
            int error = errno;
            char said[512];
            v->broken = true;
            read_log(v->log, said, sizeof said);
            return tr_status_fail(st, TR_FILE, "error: cannot write %s: ffmpeg stopped: %s", v->path,
                                  *said ? said : strerror(error));
        }
    }
    v->frames++;
    return true;
}

/* Waits for ffmpeg and reads its messages. On a full disk it ends with code 0 and a film that does not play; only its
 * messages show it. */
static bool succeeds(pid_t pid, int log, char *said, size_t size) {
    int exit_status = -1;
    while (waitpid(pid, &exit_status, 0) < 0 && errno == EINTR) {
    }
    read_log(log, said, size);
    return WIFEXITED(exit_status) && WEXITSTATUS(exit_status) == 0 && !*said;
}

bool tr_video_close(tr_video *v, bool keep, tr_status *st) {
    if (!v) return true;
    close(v->input);
    v->input = -1;
    char said[512];
    bool ended = succeeds(v->pid, v->log, said, sizeof said) && !v->broken && v->frames > 0;
    bool ok = true;
    if (ended && keep) {
        ok = tr_temporary_rename(v->part, v->path, st);
    } else {
        remove(v->part);
        if (!ended) {
            const char *why = v->frames == 0 ? "no frames" : *said ? said : "ffmpeg failed";
            ok = tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", v->path, why);
        }
    }
    release(v);
    return ok;
}

/* Every k-th frame of the film, so that motion stays even. The film is read twice, once for the palette of all its
 * frames: ffmpeg would otherwise hold them in memory. No dithering: the pictures are flat colours.
 * The palette is chosen from colours of 16 bits: smoothed and scaled edges have so many colours of 24 bits that the
 * choice took longer than the film. */
static bool run_gif(const char *film, const char *part, int log, int frames_per_second, char *said, size_t size,
                    tr_status *st) {
    char filter[200];
    int k = (frames_per_second + TR_GIF_RATE - 1) / TR_GIF_RATE;
    snprintf(filter, sizeof filter,
             "[0]framestep=%d,scale=640:-1[b];[1]framestep=%d,scale=640:-1,format=rgb565le,palettegen[p];"
             "[b][p]paletteuse=dither=none",
             k, k);
    char *from = url_of(film, st), *to = url_of(part, st);
    const char *args[] = {"ffmpeg",  "-nostdin",        "-loglevel", "error", "-i", from,       "-i",
                          from,      "-filter_complex", filter,      "-loop", "0",  "-flags:v", "+bitexact",
                          "-fflags", "+bitexact",       "-f",        "gif",   "-y", to,         NULL};
    pid_t pid = -1;
    bool ok = from && to && spawn(&pid, args, part, -1, log, st) && succeeds(pid, log, said, size);
    free(from);
    free(to);
    return ok;
}

bool tr_video_gif(const char *film, const char *path, int frames_per_second, tr_status *st) {
    char said[512] = "";
    char *part = tr_temporary_name(path, st);
    int log = memfd_create("ffmpeg", MFD_CLOEXEC);
    bool ok = part && log >= 0 && run_gif(film, part, log, frames_per_second, said, sizeof said, st);
    if (ok) {
        ok = tr_temporary_rename(part, path, st);
    } else {
        if (part) remove(part);
        tr_status_fail(st, TR_FILE, "error: cannot write %s: %s", path, *said ? said : "ffmpeg failed");
    }
    if (log >= 0) close(log);
    free(part);
    return ok;
}
