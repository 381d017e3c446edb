/* SPDX-License-Identifier: MIT */
/* Numbers among the arguments. */
#ifndef TR_CLI_NUMBER_H
#define TR_CLI_NUMBER_H

/* An argument that is a whole number from low to high; ends the program otherwise. what: names it. */
struct argp_state;
int tr_cli_whole(const char *text, int low, int high, const char *what, struct argp_state *state);

#endif
