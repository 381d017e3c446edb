/* SPDX-License-Identifier: MIT */
/* The name of a case. */
#ifndef TR_CLI_NAME_H
#define TR_CLI_NAME_H

#include <stddef.h>

/* "cases/slip-to-roll.yaml" -> "slip-to-roll" */
void tr_cli_name(const char *file, char *name, size_t size);

#endif
