/* SPDX-License-Identifier: MIT */
/* Included before every file that is compiled for the page: what wasi-libc does not declare. */
#ifndef TR_WASI_H
#define TR_WASI_H

char *realpath(const char *path, char *room);

#endif
