/* SPDX-License-Identifier: MIT */
/* Tests that walk the registry: where one fails, the law of that moment is named. */
#ifndef TR_TEST_JUDGED_H
#define TR_TEST_JUDGED_H

#include "assert_close.h"
#include "laws/law.h"

/* The laws that are being judged; a test that comes to its end leaves NULL. */
static const tr_law *judged[2];

static inline int tell_the_law(void **state) {
    (void)state;
    for (int i = 0; i < 2; i++)
        if (judged[i]) print_message("failed at the law: %s\n", judged[i]->table.name);
    judged[0] = judged[1] = NULL;
    return 0;
}

#define law_test(test) cmocka_unit_test_teardown(test, tell_the_law)

#endif
