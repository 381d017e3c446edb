/* SPDX-License-Identifier: MIT */
/* A settled step allocates nothing. Counted by the linker's --wrap (Makefile), which sends every call of the library
 * through the functions below. */
#include "core/worlds.h"

static long allocations;

void *__real_malloc(size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t size);

void *__wrap_malloc(size_t size) {
    return allocations++, __real_malloc(size);
}
void *__wrap_aligned_alloc(size_t alignment, size_t size) {
    return allocations++, __real_aligned_alloc(alignment, size);
}
void *__wrap_calloc(size_t n, size_t size) {
    return allocations++, __real_calloc(n, size);
}
void *__wrap_realloc(void *p, size_t size) {
    return allocations++, __real_realloc(p, size);
}

static void test_settled_steps_allocate_nothing(void **state) {
    (void)state;
    tr_scene scene = biaxial_scene(100, 1, sand);
    tr_biaxial b;
    long before = allocations;
    compact(&b, &scene);
    assert_true(allocations > before + 10); /* the counter counts */
    begin_shear(&b);
    shear_steps(&b, 500);
    int64_t refreshes = b.world.refreshes;
    before = allocations;
    shear_steps(&b, 5000);
    assert_int_equal(allocations, before);
    assert_true(b.world.refreshes > refreshes); /* renewals of the list included */
    tr_biaxial_free(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_settled_steps_allocate_nothing)};
    return cmocka_run_group_tests_name("allocation", tests, NULL, NULL);
}
