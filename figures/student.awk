# SPDX-License-Identifier: MIT
# Student's distribution, exact: the finite sums of Abramowitz & Stegun 26.7.3 and 26.7.4. Give this file with -f before
# the script that uses it.
function within(theta, f,   c, term, sum, k) { # P(|T| < sqrt(f) tan(theta)), f degrees of freedom
    c = cos(theta); term = f%2 ? c : 1; sum = f == 1 ? 0 : term
    for (k = f%2 ? 3 : 2; k <= f - 2; k += 2) { term *= c*c*(k - 1)/k; sum += term }
    return f%2 ? (theta + sin(theta)*sum)/(2*atan2(1, 1)) : sin(theta)*sum
}
function student(p, f,   low, high, mid, i) { # the t with P(|T| > t) = p
    low = 0; high = 2*atan2(1, 1)
    for (i = 0; i < 60; i++) { mid = (low + high)/2; if (within(mid, f) < 1 - p) low = mid; else high = mid }
    return sqrt(f)*sin(low)/cos(low)
}
