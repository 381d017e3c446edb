/* SPDX-License-Identifier: MIT */
#include "cli/parse.h"

#include "base/status.h"

#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of `--set KEY VALUE`, `--set KEY= VALUE`, `--set KEY =VALUE`: where the key ends; NULL: the set is whole. */
static const char *end_of_key(const char *set) {
    const char *equals = strchr(set, '=');
    return !equals || !equals[strspn(equals, "= ")] ? set + strcspn(set, "= ") : NULL;
}

void tr_cli_second_file(struct argp_state *state, const char *const *set, int n_set, const char *first,
                        const char *second) {
    for (int i = 0; i < n_set; i++) {
        const char *end = end_of_key(set[i]);
        if (end) argp_error(state, "--set takes KEY=VALUE in one word: --set %.*s=VALUE", (int)(end - set[i]), set[i]);
    }
    const char *const word[] = {first, second};
    for (int i = 0; i < 2; i++)
        if (strchr(word[i], '=')) argp_error(state, "to change a key of the case write --set %s", word[i]);
    argp_error(state, "one case file at a time, and these are two: %s %s", first, second);
    exit(TR_BAD_CASE); /* argp_error has */
}

void tr_cli_parse(const struct argp *argp, int argc, char **argv, void *arguments) {
    argp_err_exit_status = TR_BAD_CASE;
    int error = argp_parse(argp, argc, argv, 0, NULL, arguments);
    if (!error) return;
    fprintf(stderr, "error: cannot read the arguments: %s\n", strerror(error));
    exit(TR_FILE);
}
