/* SPDX-License-Identifier: MIT */
/* trundle convert: disks and contacts of a finished run as files of other programs. */
#ifndef TR_STUDY_CONVERT_H
#define TR_STUDY_CONVERT_H

#include "base/status.h"

/* Reads case.yaml, summary.json and the tables of the run in the directory `run`; writes into the directory `to`,
 * which is made, in the format of this name. files: how many were written. TR_BAD_CASE: not a finished run of
 * disks, an unknown format, a table that does not fit; TR_FILE. */
bool tr_convert(const char *run, const char *format, const char *to, int *files, tr_status *st);

extern const char tr_convert_formats[]; /* a line for each: "  NAME\tWHAT\n" */

#endif
