/* SPDX-License-Identifier: MIT */
/* The same law in another code: the factors against what those codes answered (tests/interop), where their
 * coefficient was 1, and against numbers worked out by hand. */
#include "assert_close.h"
#include "study/counterparts.h"
#include "study/identify_read.h"

#include <stdlib.h>
#include <string.h>

static const tr_counterpart_key *key_of(const char *code, const char *law, const char *key) {
    const tr_counterpart *c = tr_counterpart_of(code, law);
    assert_non_null(c);
    for (int k = 0; k < TR_COUNTERPART_KEYS; k++)
        if (c->key[k].key && !strcmp(c->key[k].key, key)) return &c->key[k];
    fail_msg("%s in %s has no %s", law, code, key);
    return NULL;
}

/* M1 = -k_r R_eff^2 (w1 - w2), and the bound mu_r R_eff, with k_r and mu_r as told: to the nine digits and more
 * that were measured; caps are quotients, to 1e-5. */
static void the_codes_answer_so(void **state) {
    (void)state;
    static const char *const codes[] = {"lammps", "liggghts", "yade"};
    static const tr_identify_map none = {0};
    for (int c = 0; c < 3; c++) {
        char path[80];
        int rolls = 0;
        snprintf(path, sizeof path, "tests/interop/%s.csv", codes[c]);
        tr_identify_table t = {.path = path, .map = &none};
        tr_status st = {0};
        if (!tr_identify_read(&t, &st)) fail_msg("%s", st.text);
        for (int i = 0; i < t.n; i++) {
            const tr_motion *m = &t.row[i].motion;
            double R_eff = m->R1 * m->R2 / (m->R1 + m->R2), spin = m->w1 - m->w2, cap = t.row[i].cell[TR_CELL_CAP];
            double k_r = key_of(codes[c], "wang-spring", "k_r")->factor(m->R1, m->R2);
            double mu_r = key_of(codes[c], "wang-spring", "mu_r")->factor(m->R1, m->R2);
            assert_close(t.row[i].cell[TR_CELL_M1], -k_r * R_eff * R_eff * spin, 1e-9, 1e-13);
            if (!(cap > 1e-6)) continue;
            assert_close(cap, mu_r * R_eff, 1e-5, 0);
            rolls++;
        }
        assert_true(rolls > 50);
        free(t.row);
    }
}

static void factors_by_hand(void **state) {
    (void)state;
    const tr_counterpart_key *k_r = key_of("yade", "wang-spring", "k_r"), *mu_r = key_of("yade", "wang-spring", "mu_r");
    static const double wanted[][3] = {{1, 4, 2}, {2, 4.5, 1.5}, {10, 12.1, 1.1}, {0.5, 4.5, 1.5}};
    for (int k = 0; k < 4; k++) {
        assert_close(k_r->factor(wanted[k][0] * 0.01, 0.01), wanted[k][1], 1e-14, 0);
        assert_close(mu_r->factor(wanted[k][0] * 0.01, 0.01), wanted[k][2], 1e-14, 0);
    }
    assert_null(tr_counterpart_of("yade", "kuhn-creep"));
    assert_ptr_equal(tr_counterpart_of("yade", "conjugate-spring"), tr_counterpart_of("yade", "wang-spring"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_codes_answer_so),
        cmocka_unit_test(factors_by_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
