/* SPDX-License-Identifier: MIT */
#include "study/schedule.h"

#include <math.h>

static int64_t instant_of(int j, int n, int64_t total) {
    return n == 1 ? total : (int64_t)llround((double)total * j / (n - 1));
}

bool tr_run_is_due(int j, int n, int64_t k, int64_t total) {
    return j < n && k == instant_of(j, n, total);
}

bool tr_run_is_between(int j, int n, int64_t k, int64_t total) {
    if (j < 0 || j > n) return false;
    return (j == 0 || instant_of(j - 1, n, total) < k) && (j == n || instant_of(j, n, total) >= k);
}
