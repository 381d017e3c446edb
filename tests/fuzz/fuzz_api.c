/* SPDX-License-Identifier: MIT */
/* The laws that a program gives to the library, and what its bodies do: the text, a NUL byte, then ten numbers of 8
 * bytes for each step (y, vx, vy, spin of body 1, x, y, vx, vy, spin of body 2, dt). All forces must be finite. */
#include "fuzz.h"
#include "trundle.h"

#include <math.h>

enum { NUMBERS = 10 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const uint8_t *end = size ? memchr(data, 0, size) : NULL;
    size_t length = end ? (size_t)(end - data) : size, left = end ? size - length - 1 : 0;
    char *laws = calloc(length + 1, 1);
    memcpy(laws, data, length);
    for (int plane = 0; plane < 2; plane++) {
        const trundle_pair pair = {.R1 = plane ? 0 : 0.01, .R2 = 0.03, .density1 = 1000, .density2 = 1000, .ny = 1};
        trundle_error error;
        trundle_contact *c = trundle_contact_new(laws, &pair, &error);
        if (!c && !error.code) abort();
        for (size_t at = 0; c && at + NUMBERS * 8 <= left && at < 100 * NUMBERS * 8; at += NUMBERS * 8) {
            double n[NUMBERS];
            memcpy(n, end + 1 + at, sizeof n);
            trundle_body one = {0, n[0], n[1], n[2], n[3]}, two = {n[4], n[5], n[6], n[7], n[8]};
            trundle_force f;
            trundle_touch touch;
            int code = trundle_contact_step(c, n[9], &one, &two, &f, &error);
            if (!isfinite(f.fx) || !isfinite(f.fy) || !isfinite(f.torque1) || !isfinite(f.torque2)) abort();
            if (!code && !trundle_contact_read(c, &touch, &error) && !isfinite(touch.f_n)) abort();
        }
        trundle_contact_free(c);
    }
    free(laws);
    return 0;
}
