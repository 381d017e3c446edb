/* SPDX-License-Identifier: MIT */
/* Each palette is a few anchor colours, evenly spaced and interpolated straight in sRGB. */
#include "draw/palette.h"

#include <math.h>

enum { N = 4 };
static const unsigned ramps[][N] = {[TR_RAMP_PLAIN] = {0xD9CBDD, 0xB08BBB, 0x7F4A90, 0x3F1250},
                                    [TR_RAMP_SLIDING] = {0xF3D3BC, 0xE39A66, TR_SLIDES, 0x662900},
                                    [TR_RAMP_ROLLING] = {0xC6D6E6, 0x6D9AC4, TR_ROLLS, 0x00203A}};
static const unsigned below[] = {0xD5D8DC, 0x6FA687, 0x17603A}, above[] = {0xD5D8DC, 0xA87BB4, 0x592769};

tr_rgb tr_palette_hue(unsigned hue) {
    return (tr_rgb){(hue >> 16 & 255) / 255.0, (hue >> 8 & 255) / 255.0, (hue & 255) / 255.0};
}

static tr_rgb interpolate(const unsigned *anchor, int n, double u) {
    u = u > 0 ? (u < 1 ? u : 1) : 0;
    int i = (int)(u * (n - 1));
    if (i > n - 2) i = n - 2;
    double w = u * (n - 1) - i;
    tr_rgb p = tr_palette_hue(anchor[i]), q = tr_palette_hue(anchor[i + 1]);
    return (tr_rgb){p.r + w * (q.r - p.r), p.g + w * (q.g - p.g), p.b + w * (q.b - p.b)};
}

tr_rgb tr_palette_ramp(tr_ramp ramp, double u) {
    return interpolate(ramps[ramp], N, u);
}

tr_rgb tr_palette_motion(double u) {
    static const unsigned slides[] = {0xDDDDDD, 0xE39A66, TR_SLIDES}, rolls[] = {0xDDDDDD, 0x6D9AC4, TR_ROLLS};
    return interpolate(u < 0 ? slides : rolls, 3, fabs(u));
}

tr_rgb tr_palette_diverging(double u) {
    return u < 0 ? interpolate(below, sizeof below / sizeof *below, -u)
                 : interpolate(above, sizeof above / sizeof *above, u);
}
