/* SPDX-License-Identifier: MIT */
/* trundle identify */
#include "base/alloc.h"
#include "cli/open.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "study/identify.h"
#include "study/identify_words.h"
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct arguments {
    const char *file, *out;
    tr_identify_map map;
} arguments;

static const struct argp_option options[] = {
    {"output", 'o', "OUT.csv", 0, "also write what was found there, as CSV", 0},
    {"map", 'm', "MINE=OURS", 0, "column MINE of the file is what is called OURS here; may be given again", 0},
    {0},
};

static void add_map(tr_identify_map *map, char *text, struct argp_state *state) {
    char *equals = strrchr(text, '=');
    if (!equals || equals == text) {
        argp_error(state, "--map takes MINE=OURS, not %s", text);
        return; /* it does not come here */
    }
    if (map->n == TR_IDENTIFY_MAPS) argp_error(state, "more than %d --map", TR_IDENTIFY_MAPS);
    *equals = '\0';
    if (!tr_identify_is_ours(equals + 1))
        argp_error(state, "--map: there is no column %s here (see below)", equals + 1);
    map->mine[map->n] = text, map->ours[map->n++] = equals + 1;
}

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    if (key == 'o')
        a->out = value;
    else if (key == 'm')
        add_map(&a->map, value, state);
    else if (key == ARGP_KEY_ARG && !a->file)
        a->file = value;
    else if (key == ARGP_KEY_ARG)
        argp_error(state, "one file at a time");
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which FILE.csv?");
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

static const char doc[] =
    "Says which rolling velocity, lever, sliding velocity and arms are behind the numbers that a code answered, "
    "whether they "
    "are objective, balanced and power-conjugate, and where a factor, a sign or a radius differs. Exit code 0 if they "
    "are all "
    "three, 1 if not, with the reasons first."
    "\v"
    "FILE.csv has the state of the two bodies as trundle measures takes it "
    "(R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2 in "
    "m, m/s, rad/s; a wall is body 1 with R1 = inf) and any of these columns; a cell may be empty:\n\n"
    "  V_r        rolling velocity [m/s], or an angle rate [rad/s]\n"
    "  V_s        sliding velocity [m/s]\n"
    "  M1,M2      moments of the rolling law, counter-clockwise [N m]\n"
    "  F_t        friction [N]: force -F_t t on 2, F_t t on 1\n"
    "  T1,T2      torques of friction [N m]; or its arms\n"
    "  arm1,arm2  -T1/F_t, -T2/F_t [m]\n"
    "  cap        greatest |M1| over mu_r F_n [m]\n"
    "  F_n        normal force [N]\n"
    "  k_roll     stiffness of the rolling spring [N/m]; default 1\n"
    "  k_t        stiffness of the sliding spring [N/m]; default 1\n"
    "  mu_r       coefficient of the bound on |M1|\n"
    "  time       how long the motion has lasted since the contact was new [s]; default 1\n\n"
    "Signs: n from 1 to 2, t = n x k = (n_y, -n_x), V_s of 2 relative to 1, M1 = -lever k_roll V_r time, M2 the "
    "opposite, "
    "F_t = k_t V_s time. The motion and the places last for the time.\n\n"
    "Rows of different experiments may stand in one file. Where k_roll is above 0, M1 and M2 are of the rolling "
    "spring, or of "
    "its bound mu_r F_n if the spring would be far above it; elsewhere, beside F_t, they are torques of friction. "
    "trundle "
    "measures --card writes such a file, without the answers.\n";

static bool write_table(const char *path, const char *input, const tr_identify *work, tr_status *st) {
    tr_file file;
    if (!tr_cli_open(&file, path, input, st)) return false;
    tr_identify_write(file.stream, work);
    return tr_file_commit(&file, st);
}

int tr_cli_identify(int argc, char **argv) {
    arguments a = {0};
    const struct argp argp = {options, parse, "FILE.csv", doc, 0, 0, 0};
    argv[0] = "trundle identify";
    tr_cli_parse(&argp, argc, argv, &a);
    tr_status st = {0};
    tr_identify *work = tr_alloc(1, sizeof *work, &st);
    bool ok = work != NULL, good = false;
    if (ok) {
        work->table.path = a.file, work->table.map = &a.map;
        ok = tr_identify_make(work, &st) && (!a.out || write_table(a.out, a.file, work, &st));
        if (ok) tr_identify_print(stdout, work), good = tr_identify_is_good(&work->found);
        tr_identify_free(work);
    }
    free(work);
    return ok ? good ? TR_OK : TR_CHECK_FAILED : tr_cli_fail(&st);
}
