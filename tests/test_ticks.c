/* test_ticks.c - steps and numbers of axes.  Catches: a step that is too small or not the least one, a digit
 * or a zero too many, a point in the wrong place. */
#include "ticks.h"
#include "unit.h"

static void steps(double least, int digit, int exponent) {
    tick_step step = ticks_step(least);
    if (step.digit != digit || step.exponent != exponent)
        fail_msg("from %a: %d e%d, not %d e%d", least, step.digit, step.exponent, digit, exponent);
}

TEST(test_step) {
    steps(1, 1, 0);
    steps(1.0000001, 2, 0);
    steps(2, 2, 0);
    steps(2.5, 5, 0);
    steps(5.1, 1, 1);
    steps(10, 1, 1);
    steps(0.1, 1, -1);
    steps(0.3, 5, -1);
    steps(0.001, 1, -3);
    steps(7e-12, 1, -11);
    steps(1.5e200, 2, 200);
    for (int e = -20; e <= 20; e++) {
        char text[16];
        snprintf(text, sizeof text, "1e%d", e);
        steps(strtod(text, NULL), 1, e);
        assert_true(ticks_size(ticks_step(strtod(text, NULL))) == strtod(text, NULL));
    }
}

static void writes(int digit, int exponent, long long k, const char *expected) {
    char text[TICKS_TEXT];
    ticks_text((tick_step){digit, exponent}, k, text);
    if (strcmp(text, expected) != 0)
        fail_msg("%lld times %d e%d: '%s', not '%s'", k, digit, exponent, text, expected);
}

TEST(test_text) {
    writes(1, 0, 0, "0");
    writes(5, -7, 0, "0");
    writes(1, 0, -3, "-3");
    writes(5, -1, 1, "0.5");
    writes(5, -1, 2, "1");
    writes(5, -1, -3, "-1.5");
    writes(5, -2, 3, "0.15");
    writes(2, 2, 7, "1400");
    writes(1, 5, 9, "900000");
    writes(1, 6, 9, "9e6");
    writes(5, 6, 3, "1.5e7");
    writes(2, -4, 1, "0.0002");
    writes(2, -5, 1, "2e-5");
    writes(2, -5, -11, "-0.00022");
    writes(1, -1, 1234567, "123456.7");
    writes(1, 0, 1234567, "1.234567e6");
}

/* Every number is what strtod reads. */
TEST(test_values) {
    static const int digits[] = {1, 2, 5};
    for (int d = 0; d < 3; d++)
        for (int e = -12; e <= 12; e++)
            for (long long k = -120; k <= 120; k++) {
                char text[TICKS_TEXT], whole[40];
                ticks_text((tick_step){digits[d], e}, k, text);
                snprintf(whole, sizeof whole, "%llde%d", k * digits[d], e);
                if (strtod(text, NULL) != strtod(whole, NULL)) fail_msg("%s is written as %s", whole, text);
            }
}
