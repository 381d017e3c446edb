/* SPDX-License-Identifier: MIT */
/* How a picture shows a check. */
#include "assert_close.h"
#include "scene/what.h"
#include "study/shown_check.h"
#include <string.h>

/* 1 N/s is 1 W per metre of a cylinder's length, and 1 J/s is 1 W. */
static void every_power_is_shown_in_watts(void **state) {
    (void)state;
    int n = 0;
    for (int i = 0; i < TR_N_WHATS; i++) {
        if (strcmp(tr_whats[i].unit, "N/s|J/s") != 0) continue;
        tr_scene_check check = {.what = i, .exact = 3, .tolerance = 1};
        tr_scene scene = {.n_disks = 1, .time_end = 1};
        tr_check_result r = {.lane = "",
                             .shape = TR_SHAPE_DISK,
                             .check = &check,
                             .what = tr_whats[i].name,
                             .unit = tr_whats[i].unit,
                             .measured = 3,
                             .ok = true};
        assert_string_equal(tr_run_shown_check(&r, &scene, false).exact, "3 W/m");
        r.shape = TR_SHAPE_SPHERE;
        assert_string_equal(tr_run_shown_check(&r, &scene, false).exact, "3 W");
        n++;
    }
    assert_true(n > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_power_is_shown_in_watts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
