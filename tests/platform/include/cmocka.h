/* cmocka.h - as much of cmocka as test_host_environment.c asks for, where there is no package of it. */
#ifndef PLATFORM_CMOCKA_H
#define PLATFORM_CMOCKA_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define REQUIRED(holds)                                                                                      \
    do {                                                                                                     \
        if (!(holds)) {                                                                                      \
            (void)fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #holds);                                \
            exit(1);                                                                                         \
        }                                                                                                    \
    } while (0)
#define assert_true(a) REQUIRED(a)
#define assert_non_null(a) REQUIRED((a) != NULL)
#define assert_int_equal(a, b) REQUIRED((a) == (b))
#define assert_in_range(a, lo, hi) REQUIRED((a) >= (lo) && (a) <= (hi))
#define assert_memory_equal(a, b, size) REQUIRED(memcmp(a, b, size) == 0)
#define print_error(...) (void)fprintf(stderr, __VA_ARGS__)

typedef void (*CMUnitTestFunction)(void **state);
struct CMUnitTest {
    const char *name;
    CMUnitTestFunction run, setup, teardown;
    void *initial;
};
#define cmocka_run_group_tests_name(group, tests, setup, teardown)                                           \
    run_group(group, tests, sizeof(tests) / sizeof *(tests))

static inline int run_group(const char *group, const struct CMUnitTest *tests, size_t count) {
    void *state = NULL;
    for (size_t i = 0; i < count && tests[i].run; i++) {
        tests[i].run(&state);
        (void)printf("%s: %s: passed\n", group, tests[i].name);
    }
    return 0;
}

#endif
