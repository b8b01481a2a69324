/* test_equation_time.c - reading an equation takes time in proportion to the length of the text, times the
 * number of terms of the polynomials that are met.
 *
 * Bounds are processor time (unit.h), many times what an ordinary machine takes, and many times less than
 * what a power of the length that is too high would take.
 */
#include "scenes.h"

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

static double took(const char *text, const algsurf_constant *constants, size_t count,
                   algsurf_status *status) {
    algsurf_surface *surface = NULL;
    double begin = unit_seconds();
    *status = algsurf_surface_from_equation(text, constants, count, &surface, NULL);
    double seconds = unit_seconds() - begin;
    algsurf_surface_free(surface);
    return seconds;
}

/* Reads the text, frees it, and fails when that took longer; returns the outcome. */
static algsurf_status timed(char *text, const algsurf_constant *constants, size_t count, double most) {
    algsurf_status status;
    double seconds = took(text, constants, count, &status);
    if (seconds > most) fail_msg("%.40s, %zu bytes: %g s, more than %g", text, strlen(text), seconds, most);
    free(text);
    return status;
}

/* Products, powers and sums of polynomials as large as they can be, in units of the time that it takes to
 * multiply such a polynomial by a constant.  Catches: factors multiplied term by term that are short as they
 * are written, on whatever side, behind whatever sum, sign, divisor or exponent. */
TEST(test_expansions) {
    static const char *const large[] = {
        "(x+y+z+1)^64",
        "(x+y+z+1)^32(x+y+z+1)^32",
        "(x+y-z+1)^32(1.1x+.7y+pi*z-3)^32",
        "((x+y+z+1)^32)^2",
        "((x+y+z+1)^32+1)^2",
        "((x+y+z+1)^32/3-x)((2-x+y+z)^32+y)",
        "-(-(x+y+z+1)^32/2)^2",
        "((x+y+z+1)^16+x)^4",
        "((x+y+z+1)^8+x)^8",
        "(((x+y+z+1)^4+x)^4+y)^4",
        "((x+y+z+1)^30*2x y)((x+y+z-1)^30*2z y)",
        "1((((x+y+z+1)^31*x)^1)^1*(1*((x+y+z+1)^30-x)x)/2)",
    };
    enum { ONES = 100, TERMS = 47905, UNITS = 12 };
    algsurf_status status;
    char *ones = repeated("(x+y+z+1)^64", "*1", ONES, "");
    double unit = took(ones, NULL, 0, &status) / ONES / TERMS;
    assert_ok(status);
    free(ones);
    for (size_t n = 0; n < sizeof large / sizeof *large; n++) {
        double most = UNITS * unit * TERMS * (double)strlen(large[n]);
        assert_ok(timed(repeated("", large[n], 1, ""), NULL, 0, most));
    }
    char *many = repeated("", "(x+y+z+1)^32(x+y+z+1)^32+", 12, "x"); /* in proportion, not more */
    double most = UNITS * unit * TERMS * (double)strlen(many);
    assert_ok(timed(many, NULL, 0, most));
    /* few terms of a high degree */
    char *few = repeated("", "(x^32+y^32+z^32+1)(x^32+y^32+z^32+1)+", 1000, "x");
    assert_ok(timed(few, NULL, 0, 0.3));
}

/* What is short as it is written has the coefficients of what it is: those of a product by its factors are
 * those of the product term by term, whole numbers exactly.  Catches: a factor, sign or divisor that is lost.
 */
TEST(test_by_factors) {
    static const char *const pairs[][2] = {
        {"((x+y+z+1)^9-x)((x+y+z+1)^9-x)", "(x+y+z+1)^18-2x(x+y+z+1)^9+x^2"},
        {"-(-(x-y+z+2)^12/4)(2(y-x-z-2)^8*2)", "(x-y+z+2)^20"},
        {"((x+y+z+1)^9+(x-y+z-1)^9-z)^2",
         "(x+y+z+1)^18+(x-y+z-1)^18+z^2+2(x+y+z+1)^9(x-y+z-1)^9-2z(x+y+z+1)^9-2z(x-y+z-1)^9"},
        {"(x y^2(x+y+z+1)^10*3)(-2(x+y+z+1)^10 z/3)", "-2x y^2z(x+y+z+1)^20"},
        {"((x+y+z+1)^10-(x+y+z+1)^10+x)^2(x+y+z+1)^9", "x^2(x+y+z+1)^9"},
        {"((x+y+z+1)^5)^4/((1+1)^2)^2", "(x+y+z+1)^20/16"},
        {"(x+y+z+1)^10((x+y-1)^9*((x+z+1)^9-1))", "(x+y+z+1)^10(x+y-1)^9(x+z+1)^9-(x+y+z+1)^10(x+y-1)^9"},
    };
    enum { MOST = 8000 };
    static algsurf_term a[MOST], b[MOST];
    for (size_t n = 0; n < sizeof pairs / sizeof *pairs; n++) {
        algsurf_surface *left = surface_of(pairs[n][0]), *right = surface_of(pairs[n][1]);
        size_t count = algsurf_surface_term_count(left);
        if (count != algsurf_surface_term_count(right)) fail_msg("%s: %zu terms", pairs[n][0], count);
        assert_true(count <= MOST);
        assert_ok(algsurf_surface_terms(left, a));
        assert_ok(algsurf_surface_terms(right, b));
        for (size_t t = 0; t < count; t++)
            if (a[t].i != b[t].i || a[t].j != b[t].j || a[t].k != b[t].k || a[t].a != b[t].a)
                fail_msg("%s: x^%d y^%d z^%d: %a, not %a", pairs[n][0], a[t].i, a[t].j, a[t].k, a[t].a,
                         b[t].a);
        assert_true(algsurf_surface_rounding(left) < 0x1p-52);
    }
}

/* Catches: at each letter of a name, constants tried one by one, length by length, letter by letter. */
TEST(test_names) {
    for (size_t length = 2000; length <= 200000; length *= 100) {
        char *name = repeated("", "a", length, ""), *greek = repeated("", "\\mu", length / 4, "");
        const algsurf_constant constants[] = {{name, 1}, {"a", 1}, {greek, 1}, {"\xce\xbc", 1}};
        double bound = length == 2000 ? 0.1 : 0.5;
        assert_int_equal(timed(repeated("", "a", length, "b"), constants, 2, bound), ALGSURF_E_NAME);
        assert_ok(timed(repeated("", "a", length - 1, "x"), constants, 4, bound));
        assert_int_equal(timed(repeated("x+sin ", "a", length - 1, ""), constants, 4, bound),
                         ALGSURF_E_SYNTAX);
        assert_ok(timed(repeated("", "\\mu", length / 4 - 1, " x"), constants, 4, bound));
        assert_ok(timed(repeated("", "\xce\xbc", length / 4 - 1, "x"), constants, 4, bound));
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
    assert_ok(timed(repeated("", text, 1, "x"), constants, CONSTANTS, 1));
}
