/* SPDX-License-Identifier: MIT */
/* Each palette is a few anchor colours, evenly spaced and interpolated straight in sRGB. */
#include "draw/palette.h"

static const unsigned sequential[] = {0xF7C331, 0xF49339, 0xDE6258, 0xB23A80, 0x731F8E, 0x2A0E63};
static const unsigned below[] = {0xD5D8DC, 0x5E9CCB, 0x0B4F8A}, above[] = {0xD5D8DC, 0xD9904A, 0x96480A};

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

tr_rgb tr_palette_sequential(double u) {
    return interpolate(sequential, sizeof sequential / sizeof *sequential, u);
}

tr_rgb tr_palette_diverging(double u) {
    return u < 0 ? interpolate(below, sizeof below / sizeof *below, -u)
                 : interpolate(above, sizeof above / sizeof *above, u);
}
