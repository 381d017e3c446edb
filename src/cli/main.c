/* SPDX-License-Identifier: MIT */
/* trundle: arguments in, printing out; other folders do the work. Exit codes: base/status.h. */
#include "base/status.h"
#include "base/version.h"
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* argv[0] is the command's name; each returns the exit code. */
typedef int tr_command(int argc, char **argv);
tr_command tr_cli_run, tr_cli_sweep, tr_cli_converge, tr_cli_replay, tr_cli_laws, tr_cli_bench, tr_cli_measures,
    tr_cli_identify, tr_cli_convert, tr_cli_verify;

static const struct command {
    const char *name, *doc;
    tr_command *run;
} commands[] = {
    {"run", "run a case file: trundle run cases/biaxial.yaml -o out/biaxial", tr_cli_run},
    {"sweep", "run a case for each point of a grid of values and seeds: cases/sweep-quick.yaml", tr_cli_sweep},
    {"converge", "how wrong the numbers of a case are, from which cause, and what to set: error against run time",
     tr_cli_converge},
    {"replay", "move the contacts of a biaxial test again, by the exact half-plane and every friction law",
     tr_cli_replay},
    {"laws", "list the contact laws, or explain one: trundle laws wang-spring", tr_cli_laws},
    {"bench", "measure the speed of the contact loop on a sheared sample", tr_cli_bench},
    {"measures", "rolling and sliding by every definition: a card of pure motions, or a CSV file", tr_cli_measures},
    {"identify", "name the definitions behind another code's numbers, and what they break", tr_cli_identify},
    {"convert", "disks and contacts of a finished run for LAMMPS, extended XYZ or VTK", tr_cli_convert},
    {"verify", "compare numbers with closed forms and independent solvers: exact, precision, stability", tr_cli_verify},
};
enum { N_COMMANDS = sizeof commands / sizeof *commands };

static int usage(FILE *to, int code) {
    fprintf(to,
            "trundle %s: disks that roll and slide (2D DEM for teaching and for verifying contact laws)\n\n"
            "Usage: trundle COMMAND [OPTION...]\n\n",
            TR_VERSION);
    for (int k = 0; k < N_COMMANDS; k++) fprintf(to, "  %-9s %s\n", commands[k].name, commands[k].doc);
    fputs("\n  trundle COMMAND --help    options of a command\n"
          "  trundle --version         version, and the commit that it was built from\n\n"
          "Exit code: 0 done, 1 a check failed, 2 usage or case, 3 files, 4 numerical failure, 130 interrupted\n",
          to);
    return code;
}

/* If the caller closed a standard stream, no file of results may get its number. */
static void open_standard_streams(void) {
    int fd;
    do fd = open("/dev/null", O_RDWR);
    while (fd >= 0 && fd <= STDERR_FILENO);
    if (fd >= 0) close(fd);
}

static int run(int argc, char **argv) {
    const char *word = argc > 1 ? argv[1] : "";
    if (!strcmp(word, "--help") || !strcmp(word, "-h") || !strcmp(word, "help")) return usage(stdout, TR_OK);
    if (!strcmp(word, "--version")) return printf("trundle %s, commit %s\n", TR_VERSION, tr_commit), TR_OK;
    for (int k = 0; k < N_COMMANDS; k++)
        if (!strcmp(word, commands[k].name)) return commands[k].run(argc - 1, argv + 1);
    if (*word) fprintf(stderr, "error: no command \"%s\"\n\n", word);
    return usage(stderr, TR_BAD_CASE);
}

int main(int argc, char **argv) {
    open_standard_streams();
    signal(SIGXFSZ, SIG_IGN); /* a limit on the size of files is an error of the write */
    int code = run(argc, argv);
    if (!fflush(stdout) && !ferror(stdout)) return code;
    perror("error: cannot write to standard output");
    return code ? code : TR_FILE;
}
