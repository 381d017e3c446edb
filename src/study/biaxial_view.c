/* SPDX-License-Identifier: MIT */
#include "study/biaxial_view.h"

#include "draw/field.h"
#include "draw/words.h"
#include "laws/law.h"

#include <math.h>
#include <stdio.h>

/* Value of a law's parameter; 0 where the law has none of that name. */
static double law_value(const tr_group_law *slot, const char *key) {
    const double *value = tr_law_value(slot->law, slot->par, key);
    return value ? *value : 0;
}

tr_view tr_run_biaxial_view(const tr_biaxial *b, char title[TR_RUN_TITLE]) {
    const tr_wall *w = b->world.wall;
    tr_biaxial_state box;
    tr_biaxial_shape(b, &box);
    const tr_scene_sample *sample = &b->scene->sample;
    tr_color color = (tr_color)b->scene->output.color;
    double width = box.width, centre = 0.5 * (w[TR_RIGHT_WALL].x + w[TR_LEFT_WALL].x);
    double bottom = b->world.n_walls ? w[TR_BOTTOM_WALL].y : -0.5 * box.height;
    double spread = 0.5 * width * 1.1 / (1 - b->scene->shear.strain_end); /* volume kept, and a tenth of dilation */
    double arrows = 0.08 * width;                                         /* room for those of the driven walls */
    double d = *sample->file ? 2 * b->mean_radius : sample->r_min + sample->r_max, speed = 4 * b->rate * d;
    tr_record typical = {.v_s = speed, .v_r = speed};
    /* Rigid blocks would turn by about the strain, disks on either side of a slip line by a multiple of it. */
    double turn = fmax(1, round(18 * b->scene->shear.strain_end)) * 10 * M_PI / 180;
    const tr_group_law *slot = b->world.group[0].laws;
    char mu[24], mu_r[24];
    snprintf(mu, sizeof mu, "%g", law_value(&slot[TR_FRICTION], "mu"));
    snprintf(mu_r, sizeof mu_r, "%g", law_value(&slot[TR_ROLLING], "mu_r"));
    const char *title_of = tr_words_of((tr_language)b->scene->language, TR_WORD_biaxial_title);
    tr_words_fill(title, TR_RUN_TITLE, title_of, mu, mu_r);
    return (tr_view){
        .world = &b->world,
        .color = color,
        .title = title,
        .range = color == TR_COLOR_SPIN ? turn : tr_frame_range(&typical, 1, color),
        .f_mean = 1.5 * b->scene->shear.lateral_pressure * d,
        .x0 = centre - spread,
        .x1 = centre + spread,
        .y0 = bottom - arrows,
        .y1 = bottom + box.height + arrows,
        .time_end = (double)b->shear_steps * b->world.dt,
    };
}
