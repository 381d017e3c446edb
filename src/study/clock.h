/* SPDX-License-Identifier: MIT */
/* Wall time. */
#ifndef TR_CLOCK_H
#define TR_CLOCK_H

double tr_run_clock(void); /* wall time [s] */

#endif
