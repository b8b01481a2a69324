/* test_shortest.c - doubles as the shortest text that reads back: against strtod, and printf with fewer
 * digits.
 *
 * Catches: text that reads back as another double, a digit too many, not the nearest of the shortest, the
 * lower neighbour of a power of two, subnormals, a point or an exponent out of place. */
#include "shortest.h"
#include "random.h"
#include "unit.h"

static shortest_powers powers;
static const uint64_t SEED = 20261122;

/* The digits of a text without zeros at either end; their number. */
static int digits_of(const char *text, char *digits) {
    int count = 0, trailing = 0;
    for (; *text && *text != 'e'; text++) {
        if (*text < '0' || *text > '9' || (count == 0 && *text == '0')) continue;
        digits[count++] = *text;
        trailing = *text == '0' ? trailing + 1 : 0;
    }
    digits[count - trailing] = 0;
    return count - trailing;
}

/* A normal number's text of at most 15 digits is the nearest one of 15, but for zeros at its end. */
static void check(double x) {
    char text[SHORTEST_ROOM], nearest[64], got[64], wanted[64];
    int length = shortest_write(&powers, x, text), digits = fabs(x) >= DBL_MIN ? DBL_DIG : 1;
    assert_in_range(length, 1, SHORTEST_ROOM - 1);
    text[length] = 0;
    do {
        snprintf(nearest, sizeof nearest, "%.*e", digits - 1, x);
    } while (strtod(nearest, NULL) != x && ++digits <= 17);
    int count = digits_of(text, got), most = digits_of(nearest, wanted);
    if (strtod(text, NULL) != x || signbit(strtod(text, NULL)) != signbit(x) || count > most ||
        (count == most && strcmp(got, wanted) != 0))
        fail_msg("%a is written %s, not %s; seed %llu", x, text, nearest, (unsigned long long)SEED);
}

static void same(double x, const char *wanted) {
    char text[SHORTEST_ROOM];
    text[shortest_write(&powers, x, text)] = 0;
    assert_string_equal(wanted, text);
}

TEST(test_forms) {
    same(0, "0");
    same(-0.0, "-0");
    same(1, "1");
    same(-1.5, "-1.5");
    same(0.1, "0.1");
    same(1e-4, "0.0001");
    same(1e-5, "1e-05");
    same(123456, "123456");
    same(1e16, "10000000000000000");
    same(1e17, "1e+17");
    same(0.3, "0.3");
    same(0.1 + 0.2, "0.30000000000000004");
    same(DBL_MAX, "1.7976931348623157e+308");
    same(DBL_MIN, "2.2250738585072014e-308");
    same(DBL_TRUE_MIN, "5e-324");
    same(9007199254740992, "9007199254740992");
    same(2e-44, "2e-44");
    same(HUGE_VAL, "inf");
    same(-HUGE_VAL, "-inf");
    same(NAN, "nan");
}

TEST(test_powers) {
    for (int e = -1074; e < 1024; e++) {
        double x = ldexp(1, e);
        check(x);
        check(nextafter(x, HUGE_VAL));
        check(nextafter(x, 0));
    }
    for (int k = -320; k <= 308; k++) {
        char text[16];
        snprintf(text, sizeof text, "1e%d", k);
        double x = strtod(text, NULL);
        check(x);
        check(nextafter(x, HUGE_VAL));
        check(nextafter(x, 0));
    }
}

TEST(test_random) {
    uint64_t bits = SEED;
    for (int i = 0; i < 200000; i++) {
        double x;
        uint64_t mixed = random_bits(&bits);
        memcpy(&x, &mixed, sizeof x);
        if (isfinite(x)) check(x);
        check((double)(int64_t)(mixed >> 40) / 1000);
        check(ldexp((double)(mixed >> 11), -53));
    }
}

int main(void) {
    shortest_fill(&powers);
    return unit_run("shortest");
}
