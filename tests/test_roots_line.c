/* test_roots_line.c - lines of numbers and fractions as polynomials, against GMP: as integers, which must be
 * exactly in proportion, and rounded to doubles.  Catches: a denominator that is not in the multiple of all,
 * a quotient that loses a limb, a carry, a double that is not the nearest, a tie to the odd one. */
#include "roots_line.h"
#include "exact_decimal.h"
#include "exact_limbs.h"
#include "unit.h"

static roots_polynomial p;
static roots_complaint why;
static uint64_t seed = 1, line_seed;

static void check(int right, const char *what) {
    if (!right) fail_msg("the line of seed %llu: %s", (unsigned long long)line_seed, what);
}

static void parse(char *const *field, int count, int rounded) {
    check(roots_parse(field, count, rounded, &p, &why), why.text);
}

/* ---- random numbers as texts ---- */

enum { MOST_FIELDS = 12, TEXT = 1600 };

static int below(int n) { return random_int(&seed, n); }

/* An integer of some limbs, often a multiple of an earlier one. */
static void random_integer(mpz_t z) {
    static const int words[] = {1, 1, 1, 2, 3, 7};
    uint64_t limb[8] = {0};
    int w = words[below(6)];
    random_limbs(&seed, limb, w);
    mpz_import(z, (size_t)w, -1, sizeof *limb, 0, 0, limb);
    mpz_fdiv_q_2exp(z, z, (mp_bitcnt_t)below(60));
}

static int write_number(char *text, const mpz_t z) {
    static const char *const exponents[] = {"", "", "e3", "e-2", "e0", "e-20", "e30"};
    if (below(3)) return gmp_sprintf(text, "%s%Zd%s", below(2) ? "-" : "", z, exponents[below(7)]);
    return gmp_sprintf(text, "%s0x%Zx%s", below(2) ? "-" : "+", z, below(2) ? "p-7" : ".8p3");
}

/* Numbers, and fractions whose denominators share factors. */
static int write_part(char *text, mpz_t *factor) {
    mpz_t z;
    mpz_init(z);
    random_integer(z);
    int length = write_number(text, z);
    if (below(4)) {
        mpz_set(z, factor[below(4)]);
        for (int i = below(3); i > 0; i--) mpz_mul(z, z, factor[below(4)]);
        text[length++] = '/';
        length += write_number(text + length, z);
    }
    mpz_clear(z);
    return length;
}

static int random_line(char text[MOST_FIELDS][TEXT], char **field) {
    mpz_t factor[4];
    int fields = 1 + below(MOST_FIELDS);
    for (int i = 0; i < 4; i++) {
        mpz_init(factor[i]);
        while (mpz_sgn(factor[i]) == 0) random_integer(factor[i]);
    }
    for (int k = 0; k < fields; k++) {
        int length = write_part(text[k], factor);
        if (below(2)) {
            text[k][length++] = ',';
            write_part(text[k] + length, factor);
        }
        field[k] = text[k];
    }
    for (int i = 0; i < 4; i++) mpz_clear(factor[i]);
    return fields;
}

static void read_parts(mpq_t re, mpq_t im, const char *text) {
    const char *comma = strchr(text, ',');
    assert_true(exact_fraction(re, text));
    mpq_set_ui(im, 0, 1);
    if (comma) assert_true(exact_fraction(im, comma + 1));
}

/* ---- judges ---- */

/* z = by q; `by` is found where it is still 0. */
static void check_part(const algsurf_integer *z, const mpq_t q, mpq_t by) {
    mpq_t is;
    mpq_init(is);
    mpz_import(mpq_numref(is), (size_t)abs(z->length), -1, sizeof *z->limbs, 0, 0, z->limbs);
    if (z->length < 0) mpq_neg(is, is);
    check(mpq_sgn(is) == mpq_sgn(q), "a sign");
    if (mpq_sgn(q) != 0) {
        mpq_div(is, is, q);
        if (mpq_sgn(by) == 0) mpq_set(by, is);
        check(mpq_sgn(by) > 0 && mpq_equal(by, is), "an integer");
    }
    mpq_clear(is);
}

static void check_line(char *const *field, int fields) {
    mpq_t re, im, by;
    mpq_inits(re, im, by, NULL);
    parse(field, fields, 0);
    for (int k = 0; k <= p.degree; k++) {
        read_parts(re, im, field[k]);
        check_part(&p.integer[k], re, by);
        check_part(&p.imaginary[k], im, by);
    }
    for (int k = p.degree + 1; k < fields; k++) {
        read_parts(re, im, field[k]);
        check(mpq_sgn(re) == 0 && mpq_sgn(im) == 0, "the degree");
    }
    parse(field, fields, 1);
    for (int k = 0; k <= p.degree; k++) {
        read_parts(re, im, field[k]);
        if (!strchr(field[k], '/')) continue; /* the C library's affair */
        check(exact_is_nearest(p.c[k].re, re) && exact_is_nearest(p.c[k].im, im), "a double");
    }
    mpq_clears(re, im, by, NULL);
}

TEST(test_random) {
    static char text[MOST_FIELDS][TEXT];
    char *field[MOST_FIELDS];
    for (int n = 0; n < 3000; n++) {
        line_seed = seed;
        check_line(field, random_line(text, field));
    }
}

/* ---- known ones ---- */

static double rounded(const char *text) {
    char *field[] = {(char *)(uintptr_t)text};
    parse(field, 1, 1);
    return p.c[0].re;
}

TEST(test_rounded) {
    assert_true(rounded("1/3") == 1.0 / 3);
    assert_true(rounded("-2/7") == -2.0 / 7);
    assert_true(rounded("1/-0x1p3") == -0.125);
    assert_true(rounded("9007199254740993/1") == 9007199254740992);   /* a tie, to the even one */
    assert_true(rounded("9007199254740993.1/1") == 9007199254740994); /* hardly above it */
    assert_true(rounded("9007199254740992.9/1") == 9007199254740992); /* hardly below */
    assert_true(rounded("18014398509481990/2") == 9007199254740996);  /* the tie above, to the even one */
    assert_true(rounded("1e-324/3e0") == 0);
    assert_true(rounded("1e-323/3") == 0x1p-1074);
    assert_true(rounded("0x1p-1075/1") == 0);
    assert_true(rounded("0x1.0001p-1075/1") == 0x1p-1074);
    assert_true(rounded("0x3p-1075/1") == 0x1p-1073);
    assert_true(rounded("1e400/1e400") == 1);
    assert_true(rounded("0x1p-1000000000/0x1p-1000000001") == 2);
    assert_true(rounded("0x1p-1000000000/3") == 0);
    assert_true(rounded("0/3") == 0);
    assert_true(rounded("0x1.fffffffffffffp1023/1") == DBL_MAX);
}

static void refuses(const char *text, int exactly, int as_double) {
    char *field[] = {(char *)(uintptr_t)text, (char *)(uintptr_t) "1"};
    assert_int_equal(roots_parse(field, 2, 0, &p, &why), !exactly);
    assert_int_equal(roots_parse(field, 2, 1, &p, &why), !as_double);
}

TEST(test_refused) {
    static const char *const bad[] = {"1/",    "/2",    "1/2/3", "1/0",       "0/0",   "1/0x0p9",
                                      "1,2/0", "1,/2",  "1/,2",  "1/2,3/4,5", "1/--2", "1//2",
                                      "1/x",   "1/nan", "inf/2", "1/2e",      "/"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) refuses(bad[i], 1, 1);
    refuses("1e400/3", 0, 1);
    refuses("0x1p1024/1", 0, 1);
    refuses("1e9000/3e-9000", 1, 1);
    refuses("1/3e-5", 0, 0);
}

/* Each of a thousand digits, without common factors: no multiple is long enough, and that is said at once. */
TEST(test_long_denominators) {
    static char text[ALGSURF_MAX_POLY_DEGREE + 1][1100];
    char *field[ALGSURF_MAX_POLY_DEGREE + 1];
    mpz_t z;
    mpz_init(z);
    for (int k = 0; k <= ALGSURF_MAX_POLY_DEGREE; k++) {
        mpz_ui_pow_ui(z, 10, 1000);
        mpz_add_ui(z, z, (unsigned long)(2 * k + 1));
        gmp_snprintf(text[k], sizeof text[k], "1/%Zd", z);
        field[k] = text[k];
    }
    assert_false(roots_parse(field, ALGSURF_MAX_POLY_DEGREE + 1, 0, &p, &why));
    assert_string_equal(why.text, "coefficient 9: the common denominator has more than 9830 decimals");
    parse(field, ALGSURF_MAX_POLY_DEGREE + 1, 1); /* each by itself is a double, if only 0 */
    for (int k = 0; k <= ALGSURF_MAX_POLY_DEGREE; k++) field[k] = text[k % 2];
    parse(field, ALGSURF_MAX_POLY_DEGREE + 1, 0);
    mpz_clear(z);
}

int main(void) {
    int status = unit_run("roots_line");
    free(p.limbs);
    return status;
}
