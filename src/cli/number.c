/* SPDX-License-Identifier: MIT */
#include "cli/number.h"

#include <argp.h>
#include <stdlib.h>

int tr_cli_whole(const char *text, int low, int high, const char *what, struct argp_state *state) {
    char *end;
    long value = strtol(text, &end, 10);
    if (end == text || *end || value < low || value > high)
        argp_error(state, "%s must be a whole number, %d to %d, not `%.40s`", what, low, high, text);
    return (int)value;
}
