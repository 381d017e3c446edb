/* SPDX-License-Identifier: MIT */
/* usage: calls AT FAULT COUNT-FILE PROGRAM ARGUMENT...
 * Runs the program, and lets system call number AT of those that open, write, sync, cut, rename, close or remove
 * fail. FAULT is ENOSPC, EIO or EINTR, or `short`: then only writes count, and that one writes half. AT 0: none fails.
 * Their number goes into COUNT-FILE.
 *
 * Ends with the exit code of the program, or 128 and the signal; 77: cannot trace here. It is a tracer: the calls that
 * the C library makes by itself are met too. Threads and what the program forks are followed, and counted from when
 * they open /dev/null, which main() begins with; what it spawns (ffmpeg, gnuplot) is not. Standard error is left
 * alone: it carries the message. */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#ifndef __x86_64__
int main(void) {
    fputs("calls: knows only the registers of x86-64\n", stderr);
    return 77;
}
#else

enum { MOST = 1 << 16 };
static char counts[MOST * 64]; /* by process: main() has begun */
static long count, at;
static int fault; /* errno; 0: short */
static pid_t hit; /* whose call is under way and fails */

static int is_write(long call) {
    return call == SYS_write || call == SYS_pwrite64 || call == SYS_writev;
}

static int is_open(long call) {
    return call == SYS_open || call == SYS_openat;
}

static int is_of_kind(long call) {
    static const long kind[] = {SYS_fsync,  SYS_fdatasync, SYS_rename, SYS_renameat, SYS_renameat2, SYS_close,
                                SYS_unlink, SYS_unlinkat,  SYS_rmdir,  SYS_mkdir,    SYS_truncate,  SYS_ftruncate};
    if (is_write(call) || !fault) return is_write(call);
    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++)
        if (call == kind[k]) return 1;
    return is_open(call);
}

/* Eight letters are a word. */
static int opens_null(pid_t pid, long call, const struct user_regs_struct *r) {
    long word = 0;
    if (is_open(call)) word = ptrace(PTRACE_PEEKDATA, pid, call == SYS_open ? r->rdi : r->rsi, NULL);
    return memcmp(&word, "/dev/nul", sizeof word) == 0;
}

static void enter(pid_t pid, struct user_regs_struct *r) {
    long call = (long)r->orig_rax;
    if (!counts[pid] && opens_null(pid, call, r)) counts[pid] = 1;
    if (!counts[pid] || !is_of_kind(call) || (is_write(call) && r->rdi == STDERR_FILENO)) return;
    if (++count != at) return;
    if (fault)
        hit = pid;
    else
        r->rdx -= r->rdx / 2;
    if (fault && call != SYS_close) r->orig_rax = (unsigned long long)-1; /* a file is closed even if that fails */
    ptrace(PTRACE_SETREGS, pid, NULL, r);
}

static void leave(pid_t pid, struct user_regs_struct *r) {
    if (hit != pid) return;
    hit = 0;
    r->rax = (unsigned long long)-fault;
    ptrace(PTRACE_SETREGS, pid, NULL, r);
}

static void stop_at_call(pid_t pid) {
    struct __ptrace_syscall_info info;
    struct user_regs_struct r;
    if (ptrace(PTRACE_GET_SYSCALL_INFO, pid, sizeof info, &info) <= 0 || ptrace(PTRACE_GETREGS, pid, NULL, &r)) return;
    if (info.op == PTRACE_SYSCALL_INFO_ENTRY) enter(pid, &r);
    if (info.op == PTRACE_SYSCALL_INFO_EXIT) leave(pid, &r);
}

static void stop_at_event(pid_t pid, int event) {
    unsigned long child = 0;
    if (event == PTRACE_EVENT_EXEC) counts[pid] = 0;
    if (event != PTRACE_EVENT_CLONE && event != PTRACE_EVENT_FORK) return;
    if (!ptrace(PTRACE_GETEVENTMSG, pid, NULL, &child)) counts[child] = counts[pid];
}

/* Returns the program's status. */
static int follow(pid_t program) {
    int status, result = 0;
    for (pid_t pid; (pid = waitpid(-1, &status, __WALL)) > 0;) {
        if (!WIFSTOPPED(status)) {
            if (pid == program) result = status;
            continue;
        }
        int sig = WSTOPSIG(status), event = status >> 16;
        if (sig == (SIGTRAP | 0x80)) stop_at_call(pid);
        if (event) stop_at_event(pid, event);
        if (sig == (SIGTRAP | 0x80) || event || sig == SIGSTOP) sig = 0; /* a new thread begins with SIGSTOP */
        ptrace(PTRACE_SYSCALL, pid, NULL, sig);
    }
    return result;
}

int main(int argc, char **argv) {
    static const struct {
        const char *name;
        int number;
    } faults[] = {{"ENOSPC", ENOSPC}, {"EIO", EIO}, {"EINTR", EINTR}, {"short", 0}};
    if (argc < 5) return fputs("usage: calls AT FAULT COUNT-FILE PROGRAM ARGUMENT...\n", stderr), 2;
    at = atol(argv[1]);
    for (size_t k = 0; k < sizeof faults / sizeof *faults; k++)
        if (!strcmp(argv[2], faults[k].name)) fault = faults[k].number;
    pid_t program = fork();
    if (program == 0) {
        if (ptrace(PTRACE_TRACEME, 0, NULL, NULL)) _exit(77);
        raise(SIGSTOP);
        execv(argv[4], argv + 4);
        _exit(127);
    }
    int status;
    if (waitpid(program, &status, 0) != program || !WIFSTOPPED(status)) return 77; /* no tracing here */
    ptrace(PTRACE_SETOPTIONS, program, NULL,
           PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACECLONE | PTRACE_O_TRACEFORK | PTRACE_O_TRACEEXEC | PTRACE_O_EXITKILL);
    ptrace(PTRACE_SYSCALL, program, NULL, 0);
    status = follow(program);
    FILE *file = fopen(argv[3], "w");
    if (file) fprintf(file, "%ld\n", count), fclose(file);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}
#endif
