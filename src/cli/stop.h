/* SPDX-License-Identifier: MIT */
/* How a command is stopped. */
#ifndef TR_CLI_STOP_H
#define TR_CLI_STOP_H

#include <signal.h>

/* Ctrl-C, SIGTERM, SIGHUP (the terminal was closed): from here on the first one asks to stop by setting the flag. A
 * second one kills. */
const volatile sig_atomic_t *tr_cli_stop(void);

#endif
