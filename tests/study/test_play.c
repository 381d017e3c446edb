/* SPDX-License-Identifier: MIT */
/* What the curve of a few bodies is of. */
#include "assert_close.h"
#include "laws/law.h"
#include "study/play.h"

#include <stdlib.h>
#include <string.h>

/* Two disks glide on a floor at 1 and 3 m/s, without spin: V_s of their contacts, -1 and -3 m/s (a wall is body 1
 * and stands still). A third is above the floor. */
static const char scene_text[] =
    "kind: bodies\ntime_end: 0.1 s\nstep: {dt: 0.01}\ncontact: {k_n: 1 MPa, mu: 0, mu_r: 0}\n"
    "disks: [{radius: 1, x: 0, y: 0.999, vx: 1, motion: prescribed}, "
    "{radius: 1, x: 5, y: 0.999, vx: 3, motion: prescribed}, "
    "{radius: 1, x: 20, y: 5, vx: 7, motion: prescribed}]\n"
    "walls: [{nx: 0, ny: 1}]\noutput: {curve: velocities, frames: 0";

/* V_s at the end, NaN where the curve has a gap. */
static double end_of_curve(const char *contact) {
    char text[800];
    tr_status st = {0};
    tr_scene scene;
    snprintf(text, sizeof text, "%s%s%s}\n", scene_text, *contact ? ", contact: " : "", contact);
    if (!tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    tr_play *p = calloc(1, sizeof *p);
    if (!tr_play_open(p, &scene, scene.output.curve, &st) || !tr_play_to(p, p->b.steps, &st)) fail_msg("%s", st.text);
    assert_true(p->n > 5);
    double value = p->value[0][p->n - 1];
    tr_show_lane lane = tr_play_lane(p);
    int n = *contact ? 1 : 0;
    assert_int_equal(lane.contact.a != lane.contact.b, n);
    tr_play_close(p);
    free(p);
    tr_scene_free(&scene);
    return value;
}

static void the_curve_is_of_the_contact_that_is_chosen(void **state) {
    (void)state;
    double first = end_of_curve("");
    assert_close(fabs(first), 1, 1e-12, 0);
    assert_close(end_of_curve("wall0-0"), first, 0, 0);
    assert_close(end_of_curve("wall0-1"), 3 * first, 1e-12, 0);
    assert_close(end_of_curve("[wall0-1]"), 3 * first, 1e-12, 0);
    assert_true(isnan(end_of_curve("wall0-2")));
    assert_true(isnan(end_of_curve("0-2")));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_curve_is_of_the_contact_that_is_chosen)};
    return cmocka_run_group_tests_name("play", tests, NULL, NULL);
}
