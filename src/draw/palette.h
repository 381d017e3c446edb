/* SPDX-License-Identifier: MIT */
/* Colours that stay apart for colour-blind eyes and in grey print.
 *
 * Two colours have one meaning each, in every picture: TR_SLIDES and TR_ROLLS. Nothing else is drawn in an orange or a
 * blue. Lanes are told by name and symbol, signs by the direction of a bar, agreement by a tick or a cross.
 *
 * Ramps run from light to dark, because frames have a white ground: what is high must stand out. */
#ifndef TR_PALETTE_H
#define TR_PALETTE_H

/* 0xRRGGBB. Both meanings have a contrast of 4.5 with white, as text needs, and 2.1 with each other: in grey they
 * differ. */
typedef enum tr_hue {
    TR_WHITE = 0xFFFFFF,
    TR_INK = 0x2B2F36,
    TR_FAINT = 0x6F7782, /* secondary text: still 4.5:1 on white */
    TR_DISK = 0xE8EBEE,
    TR_FORCE = 0xC9CED4, /* of lines of force that carry no colour of their own */
    TR_RIM = 0x8A929C,
    TR_WALL = 0x4A515B,
    TR_SLIDES = 0xC75000,
    TR_ROLLS = 0x00457C,
    TR_STICKS = 0x42505E,
    TR_ARC_A = 0x33383F,  /* a full line */
    TR_ARC_B = 0x565D67,  /* a line with a white core */
    TR_GREEN = 0x00714F,  /* velocities, and the tick */
    TR_PURPLE = 0x8F3F6B, /* spins */
} tr_hue;

/* What a ramp stands for: its dark end is that of the meaning. */
typedef enum tr_ramp { TR_RAMP_PLAIN, TR_RAMP_SLIDING, TR_RAMP_ROLLING } tr_ramp;

typedef struct tr_rgb {
    double r, g, b; /* 0..1, sRGB */
} tr_rgb;

tr_rgb tr_palette_hue(unsigned hue);

/* u in 0..1, clamped; NaN counts as 0. Lightness falls strictly with u. */
tr_rgb tr_palette_ramp(tr_ramp ramp, double u);

/* u in -1..1, clamped; NaN counts as 0. From sliding alone to rolling alone, light grey where both are as fast. */
tr_rgb tr_palette_motion(double u);

/* u in -1..1, clamped; NaN counts as 0. Green below, light grey at, purple above 0; lightness falls with |u|. */
tr_rgb tr_palette_diverging(double u);

#endif
