/* test_equation_time.c - reading an equation takes time in proportion to the length of the text, times the
 * number of terms of the polynomials that are met.
 *
 * Bounds are processor time, many times what an ordinary machine takes, and many times less than what a power
 * of the length that is too high would take.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "algsurf/surface.h"

/* `count` times the unit, then the end; to be freed. */
static char *repeated(const char *start, const char *unit, size_t count, const char *end) {
    size_t width = strlen(unit), head = strlen(start);
    char *text = malloc(head + width * count + strlen(end) + 1);
    assert_non_null(text);
    strcpy(text, start);
    for (size_t n = 0; n < count; n++) memcpy(text + head + n * width, unit, width);
    strcpy(text + head + width * count, end);
    return text;
}

/* Reads the text, frees it, and fails when that took longer; returns the outcome. */
static algsurf_status timed(char *text, const algsurf_constant *constants, size_t count, double seconds) {
    algsurf_surface *surface = NULL;
    clock_t begin = clock();
    algsurf_status status = algsurf_surface_from_equation(text, constants, count, &surface, NULL);
    double took = (double)(clock() - begin) / CLOCKS_PER_SEC;
    if (took > seconds) fail_msg("%.40s, %zu bytes: %g s, more than %g", text, strlen(text), took, seconds);
    algsurf_surface_free(surface);
    free(text);
    return status;
}

/* Catches: at each letter of a name, constants tried one by one, length by length, letter by letter. */
static void test_names(void **unused) {
    (void)unused;
    for (size_t length = 2000; length <= 2000000; length *= 1000) {
        char *name = repeated("", "a", length, ""), *greek = repeated("", "\\mu", length / 4, "");
        const algsurf_constant constants[] = {{name, 1}, {"a", 1}, {greek, 1}, {"\xce\xbc", 1}};
        double bound = length == 2000 ? 0.1 : 5;
        assert_int_equal(timed(repeated("", "a", length, "b"), constants, 2, bound), ALGSURF_E_NAME);
        assert_int_equal(timed(repeated("", "a", length - 1, "x"), constants, 4, bound), ALGSURF_OK);
        assert_int_equal(timed(repeated("x+sin ", "a", length - 1, ""), constants, 4, bound),
                         ALGSURF_E_SYNTAX);
        assert_int_equal(timed(repeated("", "\\mu", length / 4 - 1, " x"), constants, 4, bound), ALGSURF_OK);
        assert_int_equal(timed(repeated("", "\xce\xbc", length / 4 - 1, "x"), constants, 4, bound),
                         ALGSURF_OK);
        assert_int_equal(timed(repeated("", "x", length, ""), constants, 4, bound), ALGSURF_E_DEGREE);
        free(name), free(greek);
    }
    enum { CONSTANTS = 3000, WIDTH = 8 }; /* many, each the beginning of others */
    static char names[CONSTANTS][WIDTH], text[CONSTANTS * WIDTH * 10];
    static algsurf_constant constants[CONSTANTS];
    for (int n = 0; n < CONSTANTS; n++) {
        snprintf(names[n], WIDTH, "c%d", n);
        constants[n] = (algsurf_constant){names[n], 1};
    }
    size_t length = 0;
    for (int n = 0; n < 9 * CONSTANTS; n++)
        length += (size_t)snprintf(text + length, WIDTH + 1, "c%d+", n % CONSTANTS);
    assert_int_equal(timed(repeated("", text, 1, "x"), constants, CONSTANTS, 1), ALGSURF_OK);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
