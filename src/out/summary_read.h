/* SPDX-License-Identifier: MIT */
/* What a summary.json says. */
#ifndef TR_OUT_SUMMARY_READ_H
#define TR_OUT_SUMMARY_READ_H

#include "base/status.h"

/* A number of a summary.json by its key, or the way to it: "checks.0.measured". NaN where it says null. There is none:
 * TR_BAD_CASE. */
bool tr_summary_read(const char *path, const char *name, double *value, tr_status *st);

/* Which version of the program wrote it; "": it is not there, or is not whole. TR_FILE: it cannot be read. */
enum { TR_SUMMARY_VERSION = 32 };
bool tr_summary_version(const char *path, char version[TR_SUMMARY_VERSION], tr_status *st);

/* How many of its checks have failed. */
bool tr_summary_failed(const char *path, int *n, tr_status *st);

/* Names all numbers in the text of a summary, as tr_summary_read takes them. TR_FILE: memory was short. */
enum { TR_SUMMARY_NAME = 128 };
bool tr_summary_numbers(const char *text, void (*take)(void *context, const char *name), void *context, tr_status *st);

#endif
