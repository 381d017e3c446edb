/* SPDX-License-Identifier: MIT */
#ifndef TR_VERSION_H
#define TR_VERSION_H

#define TR_VERSION "0.2.0"

#endif
