/* test_roots_outward.c - enclosures as decimals, against exact arithmetic: they hold the interval, and are at
 * most half as wide again where 17 digits suffice.  Catches: an end rounded to nearest, a carry that is lost,
 * an exponent one off. */
#include "exact_decimal.h"
#include "roots_outward.h"
#include "unit.h"

static void writes(double lo, double hi, const char *expected) {
    char text[ROOTS_OUTWARD_ROOM];
    roots_outward((algsurf_interval){lo, hi}, text);
    assert_string_equal(text, expected);
}

TEST(test_known) {
    writes(0.9999, 1.0001, "[0.9999, 1.0001]"); /* the doubles are above 0.9999 and below 1.0001 */
    writes(99.96, 99.99, "[99.959, 99.99]");    /* both below */
    writes(-1.5, 2.5, "[-2, 3]");
    writes(-0.0625, 0.0625, "[-0.07, 0.07]");
    writes(0, 3, "[0, 3]");
    writes(9.99, 9.999999, "[9.99, 10]");
    writes(-3e-7, -1e-7, "[-3e-07, -9e-08]");
    writes(1e-300, 2e-300, "[1e-300, 2.1e-300]");
    writes(1e300, 2e300, "[1e+300, 2.1e+300]");
    writes(1, nextafter(1, 2), "[1, 1.0000000000000003]");
    writes(-INFINITY, INFINITY, "[-inf, inf]");
    writes(-INFINITY, 0.25, "[-inf, 0.25]");
}

/* The two ends of a text as rational numbers. */
static void read_ends(const char *text, mpq_t lo, mpq_t hi) {
    char end[ROOTS_OUTWARD_ROOM];
    const char *comma = strchr(text, ',');
    assert_true(text[0] == '[' && comma && text[strlen(text) - 1] == ']');
    snprintf(end, sizeof end, "%.*s", (int)(comma - text - 1), text + 1);
    assert_true(exact_decimal(lo, end));
    snprintf(end, sizeof end, "%.*s", (int)(strlen(comma + 2) - 1), comma + 2);
    assert_true(exact_decimal(hi, end));
}

static uint64_t seed = 1;

TEST(test_random) {
    mpq_t lo, hi, ends[2], width, wider;
    mpq_inits(lo, hi, ends[0], ends[1], width, wider, NULL);
    for (int n = 0; n < 20000; n++) {
        int e = (int)((random_bits(&seed) >> 11) % 1200) - 600;
        double a =
            ldexp((double)(random_bits(&seed) >> 11), e - 53) * ((random_bits(&seed) >> 11) % 2 ? 1 : -1);
        double b = a + fabs(a) * ldexp((double)((random_bits(&seed) >> 11) % 1000 + 1),
                                       -(int)((random_bits(&seed) >> 11) % 60));
        if (!(a < b) || !isfinite(b)) continue;
        char text[ROOTS_OUTWARD_ROOM];
        roots_outward((algsurf_interval){a, b}, text);
        read_ends(text, lo, hi);
        exact_set(ends[0], a), exact_set(ends[1], b);
        mpq_sub(width, ends[1], ends[0]);
        mpq_sub(wider, hi, lo);
        if (mpq_cmp(lo, ends[0]) > 0 || mpq_cmp(hi, ends[1]) < 0) fail_msg("%a %a: %s", a, b, text);
        double times = mpq_get_d(wider) / mpq_get_d(width), most = fmax(fabs(a), fabs(b));
        if (b - a > 1e-15 * most && times > 1.5 + 1e-9) fail_msg("%a %a: %s, %g times", a, b, text, times);
        if (times > 200) fail_msg("%a %a: %s, %g times", a, b, text, times);
    }
    mpq_clears(lo, hi, ends[0], ends[1], width, wider, NULL);
}
