/* test_equation_number.c - numbers in equations, against the C library's strtod in the "C" locale.
 *
 * Each test says which breaks it catches.
 */
#include "equation_case.h"
#include "exact.h"

static const uint64_t seed = 20240607;

/* The constant term of "NUMBER+x". */
static double lone(const char *number) {
    static char text[4096];
    assert_true(snprintf(text, sizeof text, "%s+x", number) < (int)sizeof text);
    algsurf_surface *s = parse(text);
    algsurf_term terms[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    assert_ok(algsurf_surface_terms(s, terms));
    return terms[1].a;
}

static void check_number(const char *number) {
    double got = lone(number), expected = strtod(number, NULL);
    if (got != expected)
        fprintf(stderr, "seed %llu, %s: %a, not %a\n", (unsigned long long)seed, number, got, expected);
    assert_true(got == expected);
}

/* Catches: a tie broken wrongly, "more" forgotten, limbs misaligned, double rounding of subnormals. */
TEST(test_numbers) {
    static const char *const numbers[] = {"11.8",
                                          "0.1",
                                          "1e22",
                                          "1e23",
                                          "1e-300",
                                          "0x1.8p3",
                                          "9007199254740993",
                                          "9007199254740993.0000000000000000001",
                                          "9007199254740991.5",
                                          "1.00000000000000011102230246251565404236316680908203125",
                                          "1.00000000000000011102230246251565404236316680908203124",
                                          "1.00000000000000011102230246251565404236316680908203126",
                                          "1.7976931348623157e308",
                                          "5e-324",
                                          "2.4703282292062328e-324",
                                          "2.4703282292062327e-324",
                                          "2.2250738585072011e-308",
                                          "2.2250738585072012e-308",
                                          "1e-330",
                                          "0e99",
                                          "0.000",
                                          "000123.4500",
                                          "0x1.fffffffffffff8p0",
                                          "0x1.fffffffffffff7ffffffffffffffffffffffffffffp0",
                                          "0x.8p-1073",
                                          "0x1.8p-1074",
                                          "0x0.0000000000001p-1022",
                                          "0x1.00000000000008p0",
                                          "0x1.000000000000080000000000000000000001p0",
                                          "0xabcdef0123456789abcdef0123456789",
                                          "4503599627370497.5",
                                          "123456789012345678901234567890e-10",
                                          "6.6312368714699758276785396630275967242439909947355e-316"};
    for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++) check_number(numbers[n]);
    uint64_t state = seed;
    for (int n = 0; n < 20000; n++) {
        char text[1200];
        double x = random_wide(&state, -1074, 1023), y = nextafter(x = fabs(x), 0);
        int kind = n % 5, digits = random_int(&state, 22);
        if (kind == 0) snprintf(text, sizeof text, "%.*e", digits, x);
        if (kind == 1) snprintf(text, sizeof text, "%a", x);
        if (kind == 2) snprintf(text, sizeof text, "%.17g", x);
        if (kind == 3) snprintf(text, sizeof text, "%d.%0*de%d", n, digits + 1, n % 7, digits * 5 - 50);
        if (kind == 4) { /* exactly halfway between two doubles, and just above when n is even */
            mpf_t middle, other;
            mpf_init2(middle, 3000), mpf_init2(other, 3000);
            mpf_set_d(middle, x), mpf_set_d(other, y);
            mpf_add(middle, middle, other), mpf_div_2exp(middle, middle, 1);
            gmp_snprintf(text, sizeof text, "%.800Fe", middle);
            mpf_clears(middle, other, NULL);
            char *e = strchr(text, 'e');
            if (n % 2 == 0 && e) e[-1] = '1';
        }
        if (isfinite(strtod(text, NULL))) check_number(text); /* fewer digits may be more than DBL_MAX */
    }
}
