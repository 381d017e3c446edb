/* SPDX-License-Identifier: MIT */
/* P(|T| < t) for a whole number of degrees of freedom n is a finite sum in theta = atan(t/sqrt n) [Abramowitz1964
 * 26.7.3, 26.7.4]:
 *
 *     n odd: (2/pi) {theta + sin theta (cos theta + 2/3 cos^3 theta + ... + 2 4...(n-3)/(3 5...(n-2)) cos^(n-2) theta)}
 *     n even: sin theta {1 + 1/2 cos^2 theta + 1 3/(2 4) cos^4 theta + ... + 1 3...(n-3)/(2 4...(n-2)) cos^(n-2) theta}
 *
 * It grows with theta, so the quantile is found by bisection. All terms are positive: nothing cancels. The number of
 * seeds is small, so n terms cost nothing. */
#include "base/student.h"
#include "base/math.h"

#include <math.h>

/* P(|T| < sqrt(n) tan theta) */
static double within(double theta, int n) {
    double c = tr_cos(theta), term = n % 2 ? c : 1, sum = n == 1 ? 0 : term;
    for (int k = n % 2 ? 3 : 2; k <= n - 2; k += 2) sum += term *= c * c * (k - 1) / k;
    return n % 2 ? 2 / M_PI * (theta + tr_sin(theta) * sum) : tr_sin(theta) * sum;
}

double tr_student_t(int freedom, double probability) {
    double low = 0, high = M_PI / 2;
    for (int i = 0; i < 60; i++) { /* to the last bit */
        double middle = 0.5 * (low + high);
        *(within(middle, freedom) < probability ? &low : &high) = middle;
    }
    return sqrt(freedom) * tr_tan(low);
}

double tr_student_95(int freedom) {
    return tr_student_t(freedom, 0.95);
}

tr_mean tr_mean_of(const double *x, int n) {
    tr_mean m = {.mean = NAN, .error = NAN, .low = NAN, .high = NAN};
    double sum = 0, square = 0;
    for (int i = 0; i < n; i++)
        if (!isnan(x[i])) sum += x[i], m.n++;
    if (m.n) m.mean = sum / m.n;
    for (int i = 0; i < n; i++)
        if (!isnan(x[i])) square += (x[i] - m.mean) * (x[i] - m.mean);
    if (m.n < 2) return m;
    m.error = sqrt(square / (m.n - 1) / m.n);
    double half = tr_student_95(m.n - 1) * m.error;
    m.low = m.mean - half, m.high = m.mean + half;
    return m;
}
