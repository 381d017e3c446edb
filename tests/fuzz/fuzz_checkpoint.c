/* SPDX-License-Identifier: MIT */
/* Checkpoints and samples behind a checksum that is right. An input is a list of changes of a file that a run has left:
 * which of the two, where, and up to eight bytes to put there. The checksum is then made good, and the run goes on from
 * the file. It must end in time, with a message or with a result. */
#include "fuzz.h"
#include "base/hash.h"
#include "laws/law.h"
#include "study/run.h"
#include <signal.h>

static const char text[] =
    "kind: biaxial\nseed: 1\nsample: {disks: 8, r_min: 0.76 mm, r_max: 1.52 mm}\n"
    "contact: {normal: hertz-line, E_star: 100 MPa, friction: cattaneo-mindlin, mu: 0.5, mu_r: 0.5, k_r: 8 MPa}\n"
    "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n"
    "shear: {inertial_number: 2e-2, strain_end: 0.03}\n"
    "output: {frames: 0, rows: 6, contacts: 2, paths: [0-1], path_rows: 4, increments: yes, curves: no}\n";

static const char *const names[] = {"checkpoint.bin", "sample.bin",        "case.yaml", "history.csv",  "contacts.csv",
                                    "disks.csv",      "trundle-files.txt", "paths.csv", "paths/0-1.csv"};
enum { FILES = sizeof names / sizeof *names, LONGEST = 200000 };

static struct kept {
    unsigned char *bytes;
    size_t size;
} kept[FILES]; /* what a stopped run has left */
static tr_scene scene;
static volatile sig_atomic_t stop;
static int calls; /* of progress */

/* Stops the first run in its shear, and any other that does not come to an end. */
static void watch(void *context, const char *stage, double fraction) {
    if (++calls > 100000 || (context && !strcmp(stage, "shear") && fraction > 0.2)) stop = 1;
}

static bool go(bool first, bool resume, tr_status *st) {
    static tr_run_report report;
    char sample[TR_PATH];
    snprintf(sample, sizeof sample, "%s/sample.bin", fuzz_dir());
    stop = calls = 0;
    const tr_run_options options = {.dir = fuzz_dir(),
                                    .force = !resume,
                                    .resume = resume,
                                    .checkpoint = 1000,
                                    .sample = sample,
                                    .stop = &stop,
                                    .progress = watch,
                                    .context = first ? &calls : NULL};
    return tr_run(&scene, &options, &report, st);
}

static void begin(void) {
    tr_status st = {0};
    char old[TR_PATH];
    snprintf(old, sizeof old, "%s/sample.bin", fuzz_dir());
    remove(old);
    if (!tr_scene_read(&scene, &(tr_scene_source){"fuzz", text, sizeof text - 1, NULL, 0}, tr_laws_catalog(), &st) ||
        go(true, false, &st) || st.code != TR_INTERRUPTED) {
        fprintf(stderr, "%s\n", st.text);
        abort();
    }
    for (int k = 0; k < FILES; k++) {
        char path[TR_PATH];
        snprintf(path, sizeof path, "%s/%s", fuzz_dir(), names[k]);
        FILE *file = fopen(path, "rb");
        kept[k].bytes = malloc(LONGEST);
        if (!file || !kept[k].bytes) perror(path), abort();
        kept[k].size = fread(kept[k].bytes, 1, LONGEST, file);
        fclose(file);
    }
}

/* 1 byte: how many bytes (low bits) and which file (high bit); 4 bytes: where; then the bytes. */
static void change(unsigned char *bytes, size_t size, const uint8_t *data, size_t n, int file) {
    while (n >= 5) {
        size_t count = 1 + (data[0] & 7), at = 0;
        for (int k = 1; k < 5; k++) at = at << 8 | data[k];
        bool ours = data[0] >> 7 == file;
        data += 5, n -= 5;
        if (count > n) count = n;
        at %= size - 16;
        for (size_t k = 0; ours && k < count && at + k < size - 8; k++) bytes[at + k] = data[k];
        data += count, n -= count;
    }
    uint64_t sum = tr_hash(TR_HASH_BEGIN, bytes, size - sizeof sum);
    memcpy(bytes + size - sizeof sum, &sum, sizeof sum);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static unsigned char bytes[LONGEST];
    tr_status st = {0};
    char path[TR_PATH];
    bool resume = !size || !(data[0] >> 7);
    if (!kept[0].bytes) begin();
    snprintf(path, sizeof path, "%s/summary.json", fuzz_dir());
    remove(path);
    if (!tr_dir_make(fuzz_dir(), "paths", &st)) abort(); /* a run that starts over removes it */
    for (int k = 0; k < FILES; k++) {
        if (!resume && k == 0) continue; /* a sample: the run starts over */
        memcpy(bytes, kept[k].bytes, kept[k].size);
        if (k < 2) change(bytes, kept[k].size, data, size, k);
        fuzz_file(names[k], bytes, kept[k].size);
    }
    if (!go(false, resume, &st) && st.code != TR_FILE && st.code != TR_NUMERICAL && st.code != TR_BAD_CASE) {
        fprintf(stderr, "code %d: %s\n", st.code, st.text);
        abort();
    }
    return 0;
}
