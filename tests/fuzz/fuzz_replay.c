/* SPDX-License-Identifier: MIT */
/* The tables that `trundle replay` reads. Parts: paths.csv, history.csv, case.yaml, summary.json; the last three have
 * defaults. */
#include "fuzz.h"
#include "study/replay.h"
#include "study/replay_read.h"

static const char *const names[] = {"paths.csv", "history.csv", "case.yaml", "summary.json"};
static const char base[] = "kind: biaxial\nsample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm}\n"
                           "contact: {friction: dahlberg-alfredsson, mu: 0.5, k_n: 160 MPa, E_star: 400 MPa}\n"
                           "compaction: {pressure: 160 kPa}\noutput: {path_rows: 5}\n";
static const char *const defaults[] = {"", "strain,time_s\n0,0\n0.01,0.2\n", base, "{}"};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    tr_status st = {0};
    tr_replay r = {0};
    for (int k = 0; k < 4; k++) {
        const uint8_t *part;
        size_t n = fuzz_part(data, size, k, &part);
        if (n || !k)
            fuzz_file(names[k], part, n);
        else
            fuzz_file(names[k], defaults[k], strlen(defaults[k]));
    }
    tr_replay_read(&r, fuzz_dir(), &st);
    tr_replay_free(&r);
    return 0;
}
