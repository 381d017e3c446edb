/* SPDX-License-Identifier: MIT */
/* Arguments. */
#ifndef TR_CLI_PARSE_H
#define TR_CLI_PARSE_H

/* Reads the arguments, or ends the program: with TR_BAD_CASE if they are wrong, with TR_FILE if memory runs out. */
struct argp;
struct argp_state;
void tr_cli_parse(const struct argp *argp, int argc, char **argv, void *arguments);

/* Ends the program: a second file name, which may be a piece of --set. */
_Noreturn void tr_cli_second_file(struct argp_state *state, const char *const *set, int n_set, const char *first,
                                  const char *second);

#endif
