/* SPDX-License-Identifier: MIT */
/* What a test is quoted by, on rows made by hand, and the measures of three disks counted by hand. */
#include "assert_close.h"
#include "core/measures.h"
#include "out/summary.h"
#include "out/table.h"
#include <stdlib.h>
#include <string.h>

/* 401 rows, strain 0..0.2 in steps of 0.0005: a window of 0.5 % strain is 10 rows. sin phi rises by 0.01 a row to 0.5
 * at row 50, has a spike of one row at row 100, and is 0.3 from row 200 on; the void ratio is the strain.
 * The share of rolling rises at row 299; the fraction of contacts with s1 s2 < 0 falls with the row. */
static void test_strength(void **state) {
    (void)state;
    static double strain[401], sin_phi[401], void_ratio[401];
    static tr_measures measures[401];
    for (int i = 0; i < 401; i++) {
        strain[i] = void_ratio[i] = 0.0005 * i;
        sin_phi[i] = i < 50 ? 0.01 * i : i == 100 ? 0.9 : i < 200 ? 0.5 : 0.3;
        measures[i] = (tr_measures){.rolling_share = i < 299 ? 0.2 : 0.6, .opposed_fraction = 1 - i / 400.0};
    }
    tr_strength s = tr_summary_strength(&(tr_series){401, strain, sin_phi, void_ratio, measures});
    /* the best window holds the spike: (9 * 0.5 + 0.9)/10; rounding of a running sum of 400 terms */
    assert_close(s.sin_phi_peak, 0.54, 0, 1e-12);
    /* the first such window is rows 91..100, its middle at row 95.5 */
    assert_close(s.strain_peak, 0.04775, 0, 1e-12);
    assert_close(s.residual_from, 0.15, 1e-15, 0);
    /* rows 300..400, or 301..400 if 0.75 * 0.2 rounds up */
    assert_close(s.sin_phi_residual, 0.3, 0, 1e-12);
    assert_close(s.e_residual, 0.175, 0, 0.00026);
    assert_close(s.residual.rolling_share, 0.6, 0, 1e-12);
    assert_close(s.residual.opposed_fraction, 0.125, 0, 0.0013);
}

/* Disks 0-1 slide, 1-2 stick, wall-0 touches: ends of contacts on disks 2 + 2 + 1 = 5, of 3 disks. */
static void test_counts(void **state) {
    (void)state;
    double force[12] = {3, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    tr_world world = {.disks = {.n = 3, .force = force}};
    tr_record records[] = {
        {.a = 0, .b = 1, .R1 = 1, .R2 = 2, .delta = 0.1, .f_n = 3, .f_t = -4, .v_s = -3, .v_r = 1, .mobilisation = 1},
        {.a = 1, .b = 2, .R1 = 2, .R2 = 2, .delta = 0.1, .f_n = 5, .v_s = 0, .v_r = -2, .mobilisation = 0.5},
        {.a = -1, .b = 0, .R2 = 1, .delta = 0.2, .f_n = 10, .v_s = 7, .v_r = 7, .mobilisation = 1},
    };
    records[0].s1 = 1, records[0].s2 = -2, records[1].s1 = records[1].s2 = -2;
    records[2].s1 = 1, records[2].s2 = -1;
    tr_measures m = tr_measures_of(&world, records, 3);
    assert_close(m.n_contacts, 3, 0, 0);
    assert_close(m.coordination, 5.0 / 3, 1e-15, 0);
    assert_close(m.sliding_fraction, 0.5, 0, 0);
    assert_close(m.rolling_share, 3.0 / 6, 1e-15, 0); /* walls do not count */
    assert_close(m.opposed_fraction, 0.5, 0, 0);
    assert_close(m.mobilisation, 0.75, 1e-15, 0);
    assert_close(m.mean_f_n, 6, 1e-15, 0);
    assert_close(m.unbalanced, (5.0 / 3) / (20.0 / 3), 1e-15, 0);
    assert_close(m.largest_overlap, 0.2, 1e-15, 0);
}

static double cell(const tr_row *row, const char *name) {
    for (int i = 0; i < row->n; i++)
        if (!strcmp(row->cell[i].name, name)) return row->cell[i].value;
    fail_msg("no cell %s", name);
    return 0;
}

/* Each number under its name; a/R = 0.5/4. */
static void test_increments(void **state) {
    (void)state;
    static const char *const name[] = {"followed",
                                       "roll_over_slide_q1",
                                       "roll_over_slide_median",
                                       "roll_over_slide_q3",
                                       "roll_over_slide_mean",
                                       "creep_over_slide_q1",
                                       "creep_over_slide_median",
                                       "creep_over_slide_q3",
                                       "creep_over_slide_mean",
                                       "friction_share_of_q",
                                       "run_over_a_median",
                                       "run_over_a_median_by_length",
                                       "rolled_in_runs_above_2a"};
    tr_increments_state s = {.followed = 0, .roll = {1, 2, 3, 4}, .creep = {5, 6, 7, 8}, .width = 0.5};
    s.tangential = 9, s.run = 10, s.run_by_length = 11, s.long_runs = 12;
    tr_row row = {0};
    tr_row_increments(&row, &s, 4);
    for (int i = 0; i < 13; i++) assert_close(cell(&row, name[i]), i, 0, 0);
    assert_close(cell(&row, "a_over_R"), 0.125, 0, 0);
    row.n = 0;
    tr_row_increment(&row, &(tr_increment){.slide = -1, .roll = 2, .creep = 3, .followed = true});
    assert_close(cell(&row, "u_slide_m"), -1, 0, 0);
    assert_close(cell(&row, "u_roll_m"), 2, 0, 0);
    assert_close(cell(&row, "u_creep_m"), 3, 0, 0);
    assert_close(cell(&row, "followed"), 1, 0, 0);
}

/* tan phi = (s1 - s2)/(2 sqrt(s1 s2)): there is none where a stress pulls or is 0. */
static void test_tan_phi_where_there_is_one(void **state) {
    (void)state;
    const double s2[] = {1, 3, 0.01, 1e-10};
    for (int i = 0; i < 4; i++) {
        double sin_phi = (2 - s2[i]) / (2 + s2[i]);
        /* sin phi is rounded by 1e-16, of which tan makes 1e-16/(1 - sin^2) of itself: 1e-6 for the last */
        assert_close(tr_biaxial_tan_phi(sin_phi), (2 - s2[i]) / (2 * sqrt(2 * s2[i])), 1e-16 * (2 + 2 / s2[i]), 0);
    }
    const double none[] = {1, -1, nextafter(1, 2), -3, 1e9, INFINITY, NAN};
    for (int i = 0; i < 7; i++) assert_true(isnan(tr_biaxial_tan_phi(none[i])));
}

/* The text that a row of these numbers is. */
static void assert_row(const double *value, int n, const char *text) {
    char *is = NULL;
    size_t size;
    FILE *stream = open_memstream(&is, &size);
    tr_file file = {.stream = stream};
    tr_status st = {0};
    tr_row row = {0};
    for (int i = 0; i < n; i++) tr_row_add(&row, value[i], "x");
    fputs("head\n", stream);
    assert_true(tr_row_write(&row, &file, &st));
    fclose(stream);
    assert_string_equal(is, text);
    free(is);
}

static void test_what_is_no_number_is_an_empty_cell(void **state) {
    (void)state;
    assert_row((const double[]){1, NAN, -0.5}, 3, "head\n1,,-0.5\n");
    assert_row((const double[]){NAN, INFINITY, -INFINITY}, 3, "head\n,,\n");
    assert_row((const double[]){2, -NAN}, 2, "head\n2,\n");
    tr_row row = {0};
    tr_biaxial_state s = {.sin_phi = 1.5};
    tr_measures m = {0};
    tr_row_biaxial(&row, &s, &m, NULL);
    assert_true(isnan(cell(&row, "tan_phi")));
}

/* A row has room for TR_MAX_CELLS. What is behind it stays as it is. */
static void test_a_row_of_too_many_columns_is_not_written(void **state) {
    (void)state;
    struct {
        tr_row row;
        unsigned char behind[4 * sizeof(tr_cell)];
    } r = {0};
    memset(r.behind, 7, sizeof r.behind);
    for (int more = 0; more < 3; more++) {
        char *is = NULL;
        size_t size;
        FILE *stream = open_memstream(&is, &size);
        tr_file file = {.stream = stream};
        tr_status st = {0};
        r.row.n = 0;
        for (int i = 0; i < TR_MAX_CELLS + more; i++) tr_row_add(&r.row, i, "c%d", i);
        assert_int_equal(tr_row_write(&r.row, &file, &st), more == 0);
        assert_int_equal(st.code, more ? TR_FILE : TR_OK);
        if (more) assert_non_null(strstr(st.text, more > 1 ? "66 columns, at most 64" : "65 columns, at most 64"));
        fclose(stream);
        assert_int_equal(size > 0, more == 0); /* no header either */
        free(is);
    }
    for (size_t i = 0; i < sizeof r.behind; i++) assert_int_equal(r.behind[i], 7);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_strength),
                                       cmocka_unit_test(test_counts),
                                       cmocka_unit_test(test_increments),
                                       cmocka_unit_test(test_tan_phi_where_there_is_one),
                                       cmocka_unit_test(test_what_is_no_number_is_an_empty_cell),
                                       cmocka_unit_test(test_a_row_of_too_many_columns_is_not_written)};
    return cmocka_run_group_tests_name("summary", tests, NULL, NULL);
}
