/* SPDX-License-Identifier: MIT */
/* What a summary.json says. */
#ifndef TR_OUT_SUMMARY_READ_H
#define TR_OUT_SUMMARY_READ_H

#include "base/status.h"

/* A number of a summary.json by its key, or the way to it: "checks.0.measured". null gives NaN. TR_BAD_CASE: no such
 * number. */
bool tr_summary_read(const char *path, const char *name, double *value, tr_status *st);

/* The version of the program that wrote it; "": it does not exist or is incomplete. TR_FILE: it cannot be read. */
enum { TR_SUMMARY_VERSION = 32 };
bool tr_summary_version(const char *path, char version[TR_SUMMARY_VERSION], tr_status *st);

/* The number of its failed checks. */
bool tr_summary_failed(const char *path, int *n, tr_status *st);

/* The names of all numbers in a summary, in the form that tr_summary_read takes. TR_FILE: memory is short. */
enum { TR_SUMMARY_NAME = 128 };
bool tr_summary_numbers(const char *text, void (*take)(void *context, const char *name), void *context, tr_status *st);

#endif
