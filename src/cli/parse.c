/* SPDX-License-Identifier: MIT */
#include "cli/parse.h"

#include "base/status.h"

#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void tr_cli_parse(const struct argp *argp, int argc, char **argv, void *arguments) {
    argp_err_exit_status = TR_BAD_CASE;
    int error = argp_parse(argp, argc, argv, 0, NULL, arguments);
    if (!error) return;
    fprintf(stderr, "error: cannot read the arguments: %s\n", strerror(error));
    exit(TR_FILE);
}
