/* SPDX-License-Identifier: MIT */
/* usage: one PROGRAMS TRUNDLE WORK SCENE FAULT COMMAND NUMBER...
 * One fault after the other: lays out WORK/SCENE/start, runs COMMAND there with fault NUMBER, and judges what is left
 * by what faults.sh promises. Prints each that went wrong, and `in Cairo, signal` or `in Cairo, pixels` for each that
 * Cairo did not survive.
 *
 * What the command gives after the fault depends on the files alone that the fault left. A state that was proven once
 * is kept by its hash, in WORK/SCENE/known, and not run again. */
#include <dirent.h>
#include <fcntl.h>
#include <png.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST = 256, WORDS = 64, PATH = 512, LIMIT = 20, HANGS = 128 + SIGALRM };

/* A directory with all that is in it, sorted by name. data NULL: a directory. */
typedef struct file {
    char name[PATH];
    char *data;
    size_t size;
} file;
typedef struct tree {
    file at[MOST];
    int n;
} tree;

static const char *programs, *trundle, *scene, *fault, *number;
static char here[PATH], known[PATH], out_file[2 * PATH], error_file[2 * PATH], where_file[2 * PATH];
static char count_file[2 * PATH];
static char *command[WORDS], *again[WORDS];
static tree start, want, left;
static file said, wanted; /* standard output: now, and without a fault */
static char complaint[1 << 16];
static int server = -1;

static void die(const char *what) {
    perror(what);
    exit(2);
}

/* ---- files ---- */

static char *slurp(const char *path, size_t *size) {
    FILE *f = fopen(path, "rb");
    size_t room = 1 << 16;
    char *data = f ? malloc(room + 1) : NULL;
    *size = 0;
    for (size_t n; data && (n = fread(data + *size, 1, room - *size, f)) > 0;)
        if ((*size += n) == room && !(data = realloc(data, (room *= 2) + 1))) break;
    if (f) fclose(f);
    if (data) data[*size] = '\0';
    return data;
}

static int by_name(const void *a, const void *b) {
    return strcmp(((const file *)a)->name, ((const file *)b)->name);
}

static void add(tree *t, const char *root, const char *under) {
    char path[3 * PATH];
    snprintf(path, sizeof path, "%s/%s", root, under);
    DIR *dir = opendir(path);
    if (!dir) die(path);
    for (struct dirent *e; (e = readdir(dir));) {
        if (!strcmp(e->d_name, ".") || !strcmp(e->d_name, "..")) continue;
        if (t->n == MOST) die("too many files");
        file *f = &t->at[t->n++];
        snprintf(f->name, sizeof f->name, "%s%s%s", under, *under ? "/" : "", e->d_name);
        snprintf(path, sizeof path, "%s/%s", root, f->name);
        f->data = e->d_type == DT_DIR ? NULL : slurp(path, &f->size);
        if (e->d_type == DT_DIR) add(t, root, f->name);
    }
    closedir(dir);
}

static void load(tree *t, const char *root) {
    for (int i = 0; i < t->n; i++) free(t->at[i].data);
    t->n = 0;
    add(t, root, "");
    qsort(t->at, (size_t)t->n, sizeof *t->at, by_name);
}

static void lay_out(const tree *t) {
    char path[2 * PATH];
    load(&left, here);
    for (int i = left.n; i-- > 0;) snprintf(path, sizeof path, "%s/%s", here, left.at[i].name), remove(path);
    for (int i = 0; i < t->n; i++) {
        snprintf(path, sizeof path, "%s/%s", here, t->at[i].name);
        FILE *f = t->at[i].data ? fopen(path, "wb") : NULL;
        if (f ? fwrite(t->at[i].data, 1, t->at[i].size, f) != t->at[i].size || fclose(f) : mkdir(path, 0777)) die(path);
    }
}

static const file *find(const tree *t, const char *name) {
    file key;
    snprintf(key.name, sizeof key.name, "%s", name);
    return bsearch(&key, t->at, (size_t)t->n, sizeof key, by_name);
}

static bool same_bytes(const file *a, const file *b) {
    return a && b && !a->data == !b->data && (!a->data || (a->size == b->size && !memcmp(a->data, b->data, a->size)));
}

static bool ends(const char *name, const char *end) {
    size_t n = strlen(name), m = strlen(end);
    return n >= m && !strcmp(name + n - m, end);
}

static bool is_result(const char *name) {
    return !strncmp(name, "out/", 4);
}

/* ---- what may differ from run to run: times, and what the log of a point tells ---- */

static bool drop_line(const file *f, const char *line, bool *timing) {
    static const char unsaid[] = "error: cannot write to standard output";
    if (ends(f->name, "/log") && (!strncmp(line, "note: ", 6) || !strncmp(line, unsaid, strlen(unsaid)))) return true;
    if (ends(f->name, "/summary.json") && strstr(line, "\"timing\"")) *timing = true;
    bool drop = *timing || (f == &said && !strncmp(line, "wall time", 9)) ||
                (f == &wanted && !strncmp(line, "wall time", 9));
    if (strchr(line, '}')) *timing = false;
    return drop;
}

static void drop_numbers(const file *f, char *line) {
    char *ok = strstr(line, ",ok,"), *comma = ok, *to = line;
    char *cost = (f == &said || f == &wanted) && !strncmp(line, "sin phi", 7) ? strstr(line, "), ") : NULL;
    if (cost) *cost = '\0';
    if (ends(f->name, "/sizes.csv") && (comma = strchr(line, ','))) *comma = '\0';
    if (ends(f->name, "/verify.csv") && ok) {
        while (comma > line && comma[-1] != ',') comma--;
        memmove(comma, ok + 1, strlen(ok));
    }
    if (strcmp(scene, "bench") && strcmp(scene, "sizes")) return;
    for (const char *from = line; *from; from++)
        if (!strchr("0123456789.e+-", *from) && (*from != ' ' || to == line || to[-1] != ' ')) *to++ = *from;
    *to = '\0';
}

static int by_text(const void *a, const void *b) {
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* What a list of files lists in the end, sorted. */
static size_t listed(char **line, size_t n) {
    size_t kept = 0;
    for (size_t i = 0; i < n; i++) {
        if (!*line[i] || *line[i] == '#') continue;
        bool takes = *line[i] == '-', found = false;
        for (size_t k = 0; k < kept && !found; k++)
            if (!strcmp(line[k], line[i] + takes) && (found = true) && takes) line[k] = line[--kept];
        if (!takes && !found) line[kept++] = line[i];
    }
    qsort(line, kept, sizeof *line, by_text);
    return kept;
}

/* The caller frees it. */
static char *plain(const file *f) {
    char *copy = memcpy(malloc(f->size + 1), f->data, f->size + 1), *to = malloc(f->size + 2), *result = to;
    char **line = malloc((f->size + 2) * sizeof *line);
    size_t n = 0;
    bool timing = false;
    for (char *p = strtok(copy, "\n"); p; p = strtok(NULL, "\n"))
        if (!drop_line(f, p, &timing)) line[n++] = p;
    if (ends(f->name, "trundle-files.txt"))
        n = listed(line, n);
    else
        for (size_t i = 0; i < n; i++) drop_numbers(f, line[i]);
    *to = '\0';
    for (size_t i = 0; i < n; i++) to += sprintf(to, "%s\n", line[i]);
    free(copy), free(line);
    return result;
}

/* The caller frees it; NULL: not a whole picture. */
static png_bytep pixels_of(const file *f, png_image *image) {
    static const char last[12] = "\0\0\0\0IEND\xae\x42\x60\x82"; /* which libpng does not miss */
    *image = (png_image){.version = PNG_IMAGE_VERSION};
    if (f->size < sizeof last || memcmp(f->data + f->size - sizeof last, last, sizeof last)) return NULL;
    if (!png_image_begin_read_from_memory(image, f->data, f->size)) return NULL;
    image->format = PNG_FORMAT_RGBA;
    png_bytep pixels = malloc(PNG_IMAGE_SIZE(*image));
    if (png_image_finish_read(image, NULL, pixels, 0, NULL)) return pixels;
    free(pixels);
    return NULL;
}

/* ISA-L compresses the same pixels now and then to other bytes. */
static bool same_pixels(const file *a, const file *b) {
    png_image of_a, of_b;
    png_bytep x = pixels_of(a, &of_a), y = pixels_of(b, &of_b);
    bool equal =
        x && y && of_a.width == of_b.width && of_a.height == of_b.height && !memcmp(x, y, PNG_IMAGE_SIZE(of_a));
    free(x), free(y);
    return equal;
}

static bool same(const file *a, const file *b) {
    if (same_bytes(a, b)) return true;
    if (!a || !b || !a->data || !b->data) return false;
    if (ends(a->name, ".png")) return same_pixels(a, b);
    if (ends(a->name, ".bin")) return false;
    char *x = plain(a), *y = plain(b);
    bool equal = !strcmp(x, y);
    free(x), free(y);
    return equal;
}

/* The name of a file that is missing, too many or not as without a fault, that counts; NULL: none. */
static const char *odd(bool pictures_count) {
    for (int i = 0; i < want.n + left.n; i++) {
        const char *name = i < want.n ? want.at[i].name : left.at[i - want.n].name;
        bool picture = ends(name, ".png") || ends(name, ".mp4") || ends(name, ".gif");
        const file *a = find(&left, name), *b = find(&want, name);
        if (picture && !pictures_count && a && b) continue;
        if ((b ? b : a)->data && !same(a, b)) return name;
    }
    return NULL;
}

static uint64_t hash(const tree *t) {
    uint64_t h = 14695981039346656037u;
    for (int i = 0; i < t->n; i++) {
        const file *f = &t->at[i];
        char *text = ends(f->name, "/summary.json") ? plain(f) : NULL;
        const char *part[] = {f->name, text ? text : f->data ? f->data : ""};
        const size_t size[] = {strlen(f->name) + 1, text ? strlen(text) : f->size * !!f->data};
        for (int k = 0; k < 2; k++)
            for (size_t c = 0; c < size[k]; c++) h = (h ^ (unsigned char)part[k][c]) * 1099511628211u;
        h = (h ^ size[1]) * 1099511628211u;
        free(text);
    }
    return h;
}

/* ---- runs ---- */

static void redirect(const char *path, int to) {
    int fd = open(path, to ? O_WRONLY | O_CREAT | O_APPEND : O_RDONLY, 0666);
    if (fd < 0 || dup2(fd, to) < 0) die(path);
    close(fd);
}

/* Killed after so many seconds; 0: never. */
static pid_t spawn(char **words, unsigned limit) {
    fflush(stdout);
    pid_t pid = fork();
    if (pid < 0) die("fork");
    if (pid) return pid;
    alarm(limit);
    redirect("/dev/null", 0), redirect(out_file, 1), redirect(error_file, 2);
    if (chdir(here)) die(here);
    execv(words[0], words);
    die(words[0]);
    return 0;
}

/* The program up to its first allocation, memory.so: it forks itself for each fault. */
static void start_server(void) {
    int pair[2];
    char fd[16], so[PATH];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, pair)) die("socketpair");
    fcntl(pair[0], F_SETFD, FD_CLOEXEC);
    snprintf(fd, sizeof fd, "%d", pair[1]), snprintf(so, sizeof so, "%s/memory.so", programs);
    setenv("FAULT_SERVER", fd, 1), setenv("FAULT_WHERE", where_file, 1), setenv("LD_PRELOAD", so, 1);
    spawn(command, 0);
    unsetenv("LD_PRELOAD"), unsetenv("FAULT_SERVER");
    close(pair[1]);
    server = pair[0];
}

static int run_served(void) {
    long n = atol(number);
    int status;
    if (server < 0) start_server();
    if (write(server, &n, sizeof n) != sizeof n || read(server, &status, sizeof status) != sizeof status) die("server");
    return status;
}

static int run_alone(char **words) {
    int status;
    pid_t pid = spawn(words, LIMIT);
    if (waitpid(pid, &status, 0) != pid) die("wait");
    return status;
}

static int run_traced(void) {
    char calls[PATH];
    const char *words[WORDS + 8] = {calls, number, fault, count_file};
    snprintf(calls, sizeof calls, "%s/calls", programs);
    for (int i = 0; command[i]; i++) words[4 + i] = command[i];
    return run_alone((char **)words);
}

/* Returns the exit code, or 128 and the signal. */
static int execute(bool once_more) {
    size_t size;
    if (truncate(out_file, 0) || truncate(error_file, 0)) die(out_file);
    int status = once_more ? run_alone(again) : !strcmp(fault, "memory") ? run_served() : run_traced();
    load(&left, here);
    free(said.data);
    said.data = slurp(out_file, &said.size);
    char *text = slurp(error_file, &size);
    size_t used = once_more ? strlen(complaint) : 0;
    snprintf(complaint + used, sizeof complaint - used, "%s%s", once_more ? "-- then:\n" : "", text);
    free(text);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/* ---- the judgement ---- */

__attribute__((format(printf, 1, 2))) static bool bad(const char *format, ...) {
    va_list args;
    printf("not ok %s, %s %s: ", scene, fault, number);
    va_start(args, format);
    vprintf(format, args);
    va_end(args);
    printf("\n");
    int lines = 0;
    for (char *line = strtok(complaint, "\n"); line && lines++ < 8; line = strtok(NULL, "\n")) printf("# %s\n", line);
    return false;
}

/* Cairo does not survive each of its own allocations: a signal ends the run, or a picture lacks something. */
static bool in_cairo(void) {
    size_t size;
    char *library = slurp(where_file, &size);
    bool is = false;
    const char *const of_cairo[] = {"libcairo", "libfreetype", "libpixman"};
    for (int k = 0; library && k < 3; k++)
        if (strstr(library, of_cairo[k])) is = true;
    free(library);
    return is;
}

/* A line begins with `note: `, and an undisturbed run does not say it. */
static bool has_new_note(const char *text, const char *usual) {
    char *copy = strdup(text);
    bool has = false;
    for (char *line = strtok(copy, "\n"); line; line = strtok(NULL, "\n"))
        if (!strncmp(line, "note: ", 6) && !strstr(usual, line)) has = true;
    free(copy);
    return has;
}

/* On stderr, or in the log of a point of a sweep. */
static bool has_note(void) {
    size_t size;
    char path[2 * PATH];
    snprintf(path, sizeof path, "%s.stderr", known);
    char *usual = slurp(path, &size);
    bool has = has_new_note(complaint, usual);
    free(usual);
    for (int i = 0; i < left.n && !has; i++) {
        const file *log = &left.at[i], *before = find(&want, log->name);
        if (ends(log->name, "/log") && before) has = has_new_note(log->data, before->data);
    }
    return has;
}

static bool has_message(void) {
    const char *const word[] = {"error: ", "memory", "cannot"};
    for (int k = 0; k < 3; k++)
        if (strstr(complaint, word[k])) return true;
    return false;
}

static bool in_list(const char *dir, const char *name) {
    char path[2 * PATH], line[2 * PATH];
    snprintf(path, sizeof path, "%s/trundle-files.txt", dir);
    const file *list = find(&left, path);
    snprintf(line, sizeof line, "\n%s\n", name);
    return list && list->data && strstr(list->data, line);
}

/* What stands in a directory of results and is on no list of it, nor of the one above. */
static const char *unlisted(void) {
    for (int i = 0; i < left.n; i++) {
        const char *full = left.at[i].name;
        char name[PATH], dir[PATH];
        if (!left.at[i].data || !is_result(full) || strstr(full, "trundle-files.txt") || strstr(full, "out/samples/"))
            continue;
        snprintf(name, sizeof name, "%s", full + 4);
        if (ends(name, ".part")) name[strlen(name) - 5] = '\0';
        if (ends(name, ".old")) name[strlen(name) - 4] = '\0';
        char *slash = strchr(name, '/');
        snprintf(dir, sizeof dir, "out/%.*s", slash ? (int)(slash - name) : 0, name);
        if (!in_list("out", name) && !(slash && in_list(dir, slash + 1))) return full;
    }
    return NULL;
}

static const char *part(void) {
    for (int i = 0; i < left.n; i++)
        if (ends(left.at[i].name, ".part")) return left.at[i].name;
    return NULL;
}

/* The run that was to be replaced stands there. */
static bool untouched(void) {
    const file *before = find(&start, "out/summary.json");
    return before && same_bytes(before, find(&left, "out/summary.json"));
}

static bool whole(void) {
    int n = 0;
    for (int i = 0; i < left.n; i++) n += is_result(left.at[i].name);
    for (int i = 0; i < start.n; i++) {
        n -= is_result(start.at[i].name);
        if (is_result(start.at[i].name) && !same_bytes(&start.at[i], find(&left, start.at[i].name))) return false;
    }
    return n == 0;
}

/* The same command, without a fault. */
static bool ends_well(void) {
    char path[2 * PATH];
    if (untouched()) return whole() || bad("the run before is no longer whole");
    snprintf(path, sizeof path, "%s/%016llx", known, (unsigned long long)hash(&left));
    if (access(path, F_OK) == 0) return true;
    int code = execute(true);
    if (code) return bad("afterwards: exit code %d", code);
    if (odd(true)) return bad("afterwards: not as without a fault: %s", odd(true));
    int fd = open(path, O_WRONLY | O_CREAT, 0666);
    return fd >= 0 && close(fd) == 0;
}

static bool judge_success(bool pixels) {
    if (odd(true) && !pixels && !has_note()) return bad("exit code 0, and no word of %s", odd(true));
    return !strcmp(fault, "short") || same(&said, &wanted) || bad("exit code 0, and not all is said");
}

static bool judge(int code) {
    bool killed = (code == 128 + SIGABRT || code == 128 + SIGSEGV) && in_cairo();
    bool pixels = code == 0 && odd(true) && !odd(false) && in_cairo();
    if (code == HANGS) return bad("hangs");
    if (killed || pixels) printf("in Cairo, %s: %s %s\n", killed ? "signal" : "pixels", scene, number);
    if (code != 0 && code != 3 && !killed) return bad("exit code %d", code);
    if (code == 0 && !judge_success(pixels)) return false;
    if (code == 3 && !has_message()) return bad("no message");
    if (code == 3 && !strcmp(fault, "memory") && part()) return bad("a part is left: %s", part());
    for (int i = 0; i < start.n; i++) {
        const file *f = &start.at[i];
        if (f->data && !is_result(f->name) && !same_bytes(f, find(&left, f->name)))
            return bad("%s is not as it was", f->name);
    }
    bool results = !strcmp(command[1], "run") || !strcmp(command[1], "sweep");
    if (results && find(&left, "out") && unlisted()) return bad("not on the list: %s", unlisted());
    bool begun = code != 3 || find(&left, "out");
    return !begun || pixels || ends_well();
}

static void set_commands(char *line) {
    int n = 0, m = 0;
    command[n++] = again[m++] = (char *)trundle;
    for (char *word = strtok(line, " "); word && n < WORDS - 2; word = strtok(NULL, " ")) {
        command[n++] = word;
        if (strcmp(word, "--force") && strcmp(word, "--resume")) again[m++] = word;
    }
    if (!strcmp(command[1], "run")) again[m] = "--resume";
}

int main(int argc, char **argv) {
    if (argc < 8) return fputs("usage: one PROGRAMS TRUNDLE WORK SCENE FAULT COMMAND NUMBER...\n", stderr), 2;
    programs = argv[1], trundle = argv[2], scene = argv[4], fault = argv[5];
    char root[PATH / 2], path[PATH];
    snprintf(root, sizeof root, "%s/%s", argv[3], scene);
    set_commands(argv[6]);
    snprintf(here, sizeof here, "%s/XXXXXX", root); /* thousands of these programs: numbers of processes come again */
    if (!mkdtemp(here)) die(here);
    snprintf(out_file, sizeof out_file, "%s.stdout", here);
    snprintf(error_file, sizeof error_file, "%s.stderr", here);
    snprintf(where_file, sizeof where_file, "%s.where", here);
    snprintf(count_file, sizeof count_file, "%s.count", here);
    snprintf(known, sizeof known, "%s/known", root);
    snprintf(path, sizeof path, "%s/start", root), load(&start, path);
    snprintf(path, sizeof path, "%s/want", root), load(&want, path);
    snprintf(path, sizeof path, "%s/want.stdout", root), wanted.data = slurp(path, &wanted.size);
    if (close(creat(out_file, 0666)) || close(creat(error_file, 0666))) die(here);
    for (int k = 7; k < argc; k++) {
        number = argv[k];
        remove(where_file);
        lay_out(&start);
        judge(execute(false));
    }
    return 0;
}
