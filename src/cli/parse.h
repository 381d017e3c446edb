/* SPDX-License-Identifier: MIT */
/* Arguments. */
#ifndef TR_CLI_PARSE_H
#define TR_CLI_PARSE_H

/* Reads the arguments, or ends the program: with TR_BAD_CASE if they are wrong, with TR_FILE if memory runs out. */
struct argp;
void tr_cli_parse(const struct argp *argp, int argc, char **argv, void *arguments);

#endif
