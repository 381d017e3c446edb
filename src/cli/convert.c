/* SPDX-License-Identifier: MIT */
/* trundle convert */
#include "cli/parse.h"
#include "cli/progress.h"
#include "out/path.h"
#include "study/convert.h"
#include <argp.h>
#include <stdio.h>

typedef struct arguments {
    const char *run, *format, *out;
} arguments;

static const struct argp_option options[] = {
    {"to", 't', "FORMAT", 0, "lammps, extxyz or vtk", 0},
    {"output", 'o', "DIR", 0, "directory of the files (default: RUN/FORMAT)", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state) {
    arguments *a = state->input;
    if (key == 't')
        a->format = value;
    else if (key == 'o')
        a->out = value;
    else if (key == ARGP_KEY_ARG && !a->run)
        a->run = value;
    else if (key == ARGP_KEY_ARG)
        argp_error(state, "one run at a time");
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which run?");
    else if (key == ARGP_KEY_END && !a->format)
        argp_error(state, "--to which format? lammps, extxyz or vtk");
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

static const char doc[] = "Writes disks and contacts of a finished run as files of other programs. RUN is the "
                          "directory of a run of kind biaxial or "
                          "bodies."
                          "\v"
                          "  lammps   disks.dump and contacts.dump, as of dump custom and dump local\n"
                          "  extxyz   disks.xyz, extended XYZ, which has no place for contacts\n"
                          "  vtk      0000.vtk and so on: disks as vertices, contacts as lines with their forces\n\n"
                          "Instants are those of disks.csv (output.contacts of them), of kind bodies the rows of "
                          "history.csv. A contact stands beside "
                          "the disks of its instant. Units are those of the run: m, s, N (N/m of disks).\n";

int tr_cli_convert(int argc, char **argv) {
    arguments a = {0};
    const struct argp argp = {options, parse, "RUN", doc, 0, 0, 0};
    char inside[TR_PATH];
    int files = 0;
    argv[0] = "trundle convert";
    tr_cli_parse(&argp, argc, argv, &a);
    tr_status st = {0};
    if (!a.out && !tr_dir_path(inside, a.run, a.format, &st)) return tr_cli_fail(&st);
    if (!tr_convert(a.run, a.format, a.out ? a.out : inside, &files, &st)) return tr_cli_fail(&st);
    printf("%d file%s in %s\n", files, files == 1 ? "" : "s", a.out ? a.out : inside);
    return TR_OK;
}
