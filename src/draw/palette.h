/* SPDX-License-Identifier: MIT */
/* Colours that stay apart for colour-blind eyes and in grey print.
 *
 * The sequential palette runs from light to dark, because frames have a white ground: high values must stand out. */
#ifndef TR_PALETTE_H
#define TR_PALETTE_H

/* 0xRRGGBB. Accents: Okabe and Ito's set, which keeps apart for the common colour deficiencies. */
typedef enum tr_hue {
    TR_WHITE = 0xFFFFFF,
    TR_INK = 0x2B2F36,
    TR_FAINT = 0x6F7782, /* secondary text: still 4.5:1 on white */
    TR_DISK = 0xE8EBEE,
    TR_FORCE = 0xC9CED4, /* of lines of force that carry no colour of their own */
    TR_RIM = 0x8A929C,
    TR_WALL = 0x4A515B,
    TR_BLUE = 0x0072B2,
    TR_VERMILLION = 0xD55E00,
    TR_GREEN = 0x009E73,
    TR_SLIPS = TR_VERMILLION, /* of the width of a contact; as sliding */
    TR_STICKS = 0x42505E,
    TR_PURPLE = 0xB05A8B, /* Okabe-Ito's, darker: thin lines on light grey */
} tr_hue;

typedef struct tr_rgb {
    double r, g, b; /* 0..1, sRGB */
} tr_rgb;

tr_rgb tr_palette_hue(unsigned hue);

/* u in 0..1, clamped; NaN counts as 0. Lightness falls strictly with u. */
tr_rgb tr_palette_sequential(double u);

/* u in -1..1, clamped; NaN counts as 0. Blue below, light grey at, orange-brown above 0; lightness falls with |u|. */
tr_rgb tr_palette_diverging(double u);

#endif
