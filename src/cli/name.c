/* SPDX-License-Identifier: MIT */
#include "cli/name.h"

#include <stdio.h>
#include <string.h>

void tr_cli_name(const char *file, char *name, size_t size) {
    const char *slash = strrchr(file, '/');
    snprintf(name, size, "%s", slash ? slash + 1 : file);
    char *dot = strrchr(name, '.');
    if (dot && dot != name) *dot = '\0';
}
