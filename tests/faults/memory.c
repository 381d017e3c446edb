/* SPDX-License-Identifier: MIT */
/* LD_PRELOAD: allocation number FAULT_AT fails, in the program `trundle` alone, not in what it starts.
 * FAULT_SERVER: descriptor; for each number read from it, a fork of the program meets that fault, and its status is
 * written back. All of them share the work of the dynamic linker. A fork that hangs is ended by SIGALRM after 20 s.
 * FAULT_COUNT: file for the number of allocations; FAULT_WHERE: for the name of the library that met the fault. */
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t), *__libc_realloc(void *, size_t);
extern void *__libc_memalign(size_t, size_t);

static long count, at;
static int active;

/* Returns in each fork. */
static void serve(int fd) {
    while (read(fd, &at, sizeof at) == sizeof at) {
        int status = -1;
        pid_t pid = fork();
        if (pid == 0) {
            close(fd), alarm(20);
            return;
        }
        if (waitpid(pid, &status, 0) != pid || write(fd, &status, sizeof status) != sizeof status) break;
    }
    _exit(0);
}

__attribute__((constructor)) static void begin(void) {
    const char *number = getenv("FAULT_AT"), *fd = getenv("FAULT_SERVER");
    if (strcmp(program_invocation_short_name, "trundle") != 0) return;
    at = number ? atol(number) : 0;
    unsetenv("LD_PRELOAD");
    if (fd) serve(atoi(fd));
    active = 1;
}

__attribute__((destructor)) static void end(void) {
    const char *path = getenv("FAULT_COUNT");
    int file = active && path ? open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
    active = 0;
    if (file < 0) return;
    dprintf(file, "%ld\n", count);
    close(file);
}

static void tell(const char *path, const void *caller) {
    Dl_info info;
    int file = path && dladdr(caller, &info) ? open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
    if (file < 0) return;
    dprintf(file, "%s\n", info.dli_fname);
    close(file);
}

static int fails(const void *caller) {
    long k = active ? __atomic_add_fetch(&count, 1, __ATOMIC_RELAXED) : -1;
    if (k < 0 || k != at) return 0;
    tell(getenv("FAULT_WHERE"), caller);
    errno = ENOMEM;
    return 1;
}

#define FAILS fails(__builtin_return_address(0))

void *malloc(size_t size) {
    return FAILS ? NULL : __libc_malloc(size);
}

void *calloc(size_t n, size_t size) {
    return FAILS ? NULL : __libc_calloc(n, size);
}

void *realloc(void *old, size_t size) {
    return FAILS ? NULL : __libc_realloc(old, size);
}

void *memalign(size_t alignment, size_t size) {
    return FAILS ? NULL : __libc_memalign(alignment, size);
}

void *aligned_alloc(size_t alignment, size_t size) {
    return FAILS ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void **p, size_t alignment, size_t size) {
    void *memory = FAILS ? NULL : __libc_memalign(alignment, size);
    if (memory) *p = memory;
    return memory ? 0 : ENOMEM;
}
