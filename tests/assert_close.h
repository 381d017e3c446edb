/* SPDX-License-Identifier: MIT */
/* What every test includes: CMocka, and one comparison of doubles (CMocka's own compares as float). */
#ifndef TR_ASSERT_CLOSE_H
#define TR_ASSERT_CLOSE_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>

/* |a - b| <= atol + rtol |b|; prints both values, the difference and what was allowed. NaN never passes. */
#define assert_close(a, b, rtol, atol)                                                                                 \
    do {                                                                                                               \
        double a_ = (a), b_ = (b), allowed_ = (atol) + (rtol)*fabs(b_);                                                \
        if (!(fabs(a_ - b_) <= allowed_))                                                                              \
            fail_msg("%s = %.17g, expected %s = %.17g; differs by %g, allowed %g", #a, a_, #b, b_, a_ - b_, allowed_); \
    } while (0)

#endif
