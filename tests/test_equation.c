/* test_equation.c - equations as text: what is accepted, what is refused and where.
 *
 * Each test says which breaks it catches.
 */
#include "equation_case.h"
#include "exact.h"

static const char *const pairs[][2] = {
    {"x^2+y^2=1-z^2", "z^2+y^2+x^2-1"},
    {"-x^2", "0-x*x"},
    {"(-x)^2", "x^2"},
    {"3x^2 y", "3*x*x*y"},
    {"2(x+1)(x-1)", "2x^2-2"},
    {"x y z", "xyz"},
    {"xy^2", "x*y*y"},
    {"yzx^2y", "y^2 z x^2"},
    {"x^2^3", "x^8"},
    {"x^(1+1)", "x^2"},
    {"x^(4/2)", "x^2"},
    {"x^(1/3*6)", "x^2"},
    {"x^sqrt(4)", "x^2"},
    {"x^0 y", "y"},
    {"x+0^0", "x+1"},
    {"2^-1 x", "0.5x"},
    {"x*2^-2^2", "x/16"},
    {"1/2x", "x/2"},
    {"6x/3/2", "x"},
    {"x/2^3", "x*0.125"},
    {"x--y", "x+y"},
    {"x*-+-y", "x*y"},
    {"2--3x", "2+3x"},
    {" \t\n\r\v\fx\n+\t1 ", "x+1"},
    {"sqrt(1e60)x + y", "1e30x + y"}, /* from here on: sizes that an exponent apart keeps */
    {"2^64*2^64*2x + 2^64*2^63x + y", "2^64*2^63*5x + y"},
    {"2^64*2^63x + 2^64*2^64*2x + y", "2^64*2^63*5x + y"},
    {"1e60x + 1e-60x + y", "1e60x + y"},
    {"1e-60x + 1e60x + y", "1e60x + y"},
    {"1e-150x + 1e150x + y", "1e150x + y"},
    {"y=0 z", "y"},
    {"1=x", "1-x"},
    {"0x10+x", "16+x"},
    {"0x1.8p3x", "12x"},
    {"0X.8P+1 x", "x"},
    {"0x+y", "y"}, /* no hexadecimal digit follows: 0 times x */
    {"2e1x", "20x"},
    {"1e2y", "100y"},
    {".5x+3.", "0.5*x+3"},
    {"3.x", "3x"},
    {"sqrt(9)x", "3x"},
    {"sqrt ( 2*2 ) x", "2x"},
    {"sqrt(2)sqrt(2)x", "2x"},
    {"1e200*1e200*1e-300 x + 1e-200*1e-200*1e300 y", "1e100x+1e-100 y"},
    {"1e-300*1e-300 x + y", "y"},
    {"1e-600 x + y", "y"},
    {"1e-309*1e-309*1e-300 x + y", "y"},
    {"1e305x*2", "2e305*x"},
    {"1e300*x+1e-300*y", "1e-300*y+1e300*x"},
    {"(x+y)^3-(x^3+3x^2y+3x y^2)", "y^3"},
    {"(0.1+0.2-0.3)x^5+y", "y"},
    {"(((1+sqrt(5))/2)^2-(1+sqrt(5))/2-1)x^5+y", "y"},
    {"sqrt(sqrt(2)^2-2)+x", "x"},
    {"0.1x", "x/10"},
    {"(x+1)^64/(1+1)-(x+1)^64*.5+z", "z"},
};

/* Catches: precedence, associativity, implicit multiplication, signs, blanks, numbers cut short. */
TEST(test_accepted) {
    for (size_t c = 0; c < sizeof pairs / sizeof *pairs; c++) same(pairs[c][0], pairs[c][1]);
}

static const struct {
    const char *text;
    algsurf_status status;
    size_t offset;
} refused[] = {
    {"", ALGSURF_E_SYNTAX, 0},
    {"  ", ALGSURF_E_SYNTAX, 2},
    {"x+", ALGSURF_E_SYNTAX, 2},
    {"x^", ALGSURF_E_SYNTAX, 2},
    {"*x", ALGSURF_E_SYNTAX, 0},
    {"x+*y", ALGSURF_E_SYNTAX, 2},
    {"x 2", ALGSURF_E_SYNTAX, 2},
    {"(x)2", ALGSURF_E_SYNTAX, 3},
    {"2 3 x", ALGSURF_E_SYNTAX, 2},
    {"1.5.2x", ALGSURF_E_SYNTAX, 3},
    {"x.5", ALGSURF_E_SYNTAX, 1},
    {".", ALGSURF_E_SYNTAX, 0},
    {"x . y", ALGSURF_E_SYNTAX, 2},
    {"x2", ALGSURF_E_SYNTAX, 0},
    {"y+x_", ALGSURF_E_SYNTAX, 2},
    {"1+foo", ALGSURF_E_NAME, 2},
    {"NaN", ALGSURF_E_NAME, 0},
    {"x+inf", ALGSURF_E_NAME, 2},
    {"2e", ALGSURF_E_NAME, 1},
    {"xyt", ALGSURF_E_NAME, 2},
    {"x=y=z", ALGSURF_E_SYNTAX, 3},
    {"=", ALGSURF_E_SYNTAX, 1},
    {"=x=y", ALGSURF_E_SYNTAX, 2},
    {"x=", ALGSURF_E_SYNTAX, 2},
    {"(x", ALGSURF_E_SYNTAX, 2},
    {"x)", ALGSURF_E_SYNTAX, 1},
    {"()", ALGSURF_E_SYNTAX, 1},
    {"(x=1)", ALGSURF_E_SYNTAX, 2},
    {"x;y", ALGSURF_E_SYNTAX, 2},
    {";", ALGSURF_E_SYNTAX, 0},
    {"x;;", ALGSURF_E_SYNTAX, 2},
    {"x^\u00b2", ALGSURF_E_SYNTAX, 2},
    {"\u00b2x", ALGSURF_E_SYNTAX, 0},
    {"x\u00b2^3", ALGSURF_E_SYNTAX, 3},
    {"x\u00b2 \u00b3", ALGSURF_E_SYNTAX, 4},
    {"x\u00b2\u00b2\u00b2\u00b2\u00b2\u00b2\u00b2\u00b2\u00b2\u00b2\u00b2\u00b2\u00b2", ALGSURF_E_DEGREE, 1},
    {"2\u2076\u2075x", ALGSURF_E_SYNTAX, 1},
    {"x\xc2", ALGSURF_E_SYNTAX, 1},
    {"x\xc2+y", ALGSURF_E_SYNTAX, 1},
    {"x\\ \x84\x84", ALGSURF_E_SYNTAX, 3},
    {"x+\u03b1", ALGSURF_E_NAME, 2},
    {"x*\u2212", ALGSURF_E_SYNTAX, 5},
    {"x* *y", ALGSURF_E_SYNTAX, 3},
    {"x***y", ALGSURF_E_SYNTAX, 3},
    {"(x]", ALGSURF_E_SYNTAX, 2},
    {"[x+(y])", ALGSURF_E_SYNTAX, 5},
    {"x}", ALGSURF_E_SYNTAX, 1},
    {"\u221ax", ALGSURF_E_SYNTAX, 3},
    {"\u221a\u22122", ALGSURF_E_SYNTAX, 3},
    {"\u221a", ALGSURF_E_SYNTAX, 3},
    {"ax+by+x", ALGSURF_E_NAME, 0},
    {"x+2xab_1", ALGSURF_E_NAME, 3},
    {"x+2xaby", ALGSURF_E_NAME, 4},
    {"|x|+y", ALGSURF_E_SYNTAX, 0},
    {"y+|x|", ALGSURF_E_SYNTAX, 2},
    {"x^2<1", ALGSURF_E_SYNTAX, 3},
    {"x\u22641", ALGSURF_E_SYNTAX, 1},
    {"y+sinx", ALGSURF_E_SYNTAX, 2},
    {"exp(x)", ALGSURF_E_SYNTAX, 0},
    {"\xff", ALGSURF_E_SYNTAX, 0},
    {"x,5", ALGSURF_E_SYNTAX, 1},
    {"sqrt 2 x", ALGSURF_E_SYNTAX, 5},
    {"sqrt", ALGSURF_E_SYNTAX, 4},
    {"sqrt(x)", ALGSURF_E_SYNTAX, 4},
    {"x+sqrt(-1)", ALGSURF_E_SYNTAX, 6},
    {"sqrt2", ALGSURF_E_SYNTAX, 0},
    {"x+sin 2y", ALGSURF_E_SYNTAX, 6},
    {"x+cos(z)", ALGSURF_E_SYNTAX, 2},
    {"x+sin(101)", ALGSURF_E_SYNTAX, 2},
    {"x+sin(1e300)", ALGSURF_E_SYNTAX, 2},
    {"x+sin(", ALGSURF_E_SYNTAX, 6},
    {"x/0", ALGSURF_E_SYNTAX, 2},
    {"x/ (1-1)", ALGSURF_E_SYNTAX, 3},
    {"x/x", ALGSURF_E_SYNTAX, 2},
    {"1/(sqrt(2)^2-2)x", ALGSURF_E_SYNTAX, 2},
    {"x^y", ALGSURF_E_SYNTAX, 2},
    {"x^-1", ALGSURF_E_SYNTAX, 2},
    {"x^0.5", ALGSURF_E_SYNTAX, 2},
    {"2^0.5x", ALGSURF_E_SYNTAX, 2},
    {"2^65x", ALGSURF_E_SYNTAX, 2},
    {"2^1e-320x", ALGSURF_E_SYNTAX, 2},
    {"x*0^-1", ALGSURF_E_SYNTAX, 3},
    {"x^1e9", ALGSURF_E_SYNTAX, 2},
    {"x^65", ALGSURF_E_DEGREE, 1},
    {"1+(x y)^33", ALGSURF_E_DEGREE, 7},
    {"x^64 *y", ALGSURF_E_DEGREE, 5},
    {"x^64 y", ALGSURF_E_DEGREE, 5},
    {"(x+y+z+1)^32(x+y)^33", ALGSURF_E_DEGREE, 12},
    {"x+1e309", ALGSURF_E_RANGE, 2},
    {"0x1p1024x", ALGSURF_E_RANGE, 0},
    {"1e99999999999999999999x", ALGSURF_E_RANGE, 0},
    {"1e200*1e200x", ALGSURF_E_RANGE, 12},
    {"2^64^-1", ALGSURF_E_SYNTAX, 2},
    {"0", ALGSURF_E_ZERO, 99},
    {"x=x", ALGSURF_E_ZERO, 99},
    {"1e-400x", ALGSURF_E_ZERO, 99},
    {"0.1+0.2=0.3", ALGSURF_E_ZERO, 99},
};

/* Catches: an offset one off, a check left out, a wrong status. */
TEST(test_refused) {
    static char place;
    for (size_t c = 0; c < sizeof refused / sizeof *refused; c++) {
        algsurf_surface *s = (void *)&place;
        algsurf_parse_error error = {99, 99, NULL};
        algsurf_status status = algsurf_surface_from_equation(refused[c].text, NULL, 0, &s, &error);
        if (status != refused[c].status || error.offset != refused[c].offset) {
            fprintf(stderr, "'%s': %d at %zu: %s\n", refused[c].text, status, error.offset, error.message);
        }
        assert_int_equal(status, refused[c].status);
        assert_int_equal(error.offset, refused[c].offset);
        assert_int_equal(error.message != NULL, refused[c].offset != 99);
        if (error.message) assert_true(error.offset + error.length <= strlen(refused[c].text));
        assert_ptr_equal(s, &place);
        assert_int_equal(algsurf_surface_from_equation(refused[c].text, NULL, 0, &s, NULL), status);
    }
}

/* Catches: a name matched by its beginning, unsorted look-up, each check of the names. */
TEST(test_constants) {
    const algsurf_constant good[] = {{"k2", 3},   {"k", 5},   {"p", 7}, {"xy", 11},
                                     {"a_1", 13}, {"yz", 17}, {"e", 19}};
    const struct {
        const char *text, *same;
    } uses[] = {{"k2 x", "3x"},       {"k^2x", "25x"},     {"2p^2x^2", "98x^2"}, {"xy^2 z", "121z"},
                {"2a_1 x", "26x"},    {"k(x+p)", "5x+35"}, {"x/p*14", "2x"},     {"xyz", "x y z"},
                {"y z+yz", "y*z+17"}, {"2e+x", "38+x"},    {"2e1x", "20x"},      {"kx+py", "5x+7y"},
                {"xk2y", "3x*y"},     {"kpx^2", "35x^2"},  {"xyk", "5x y"},      {"pkyzx", "35x y z"},
                {"k\u00b2x", "25x"}};
    static char place;
    algsurf_surface *s;
    for (size_t c = 0; c < sizeof uses / sizeof *uses; c++) {
        algsurf_term a[4], b[4];
        const algsurf_surface *t = parse(uses[c].same);
        s = parse_with(uses[c].text, good, 7);
        size_t count = algsurf_surface_term_count(s);
        assert_int_equal(count, algsurf_surface_term_count(t));
        assert_ok(algsurf_surface_terms(s, a));
        assert_ok(algsurf_surface_terms(t, b));
        for (size_t n = 0; n < count; n++)
            assert_true(a[n].a == b[n].a && a[n].i == b[n].i && a[n].k == b[n].k);
    }
    const algsurf_constant own[] = {{"X", 2}, {"pi", 3}}; /* come before what these names mean otherwise */
    algsurf_term terms[2];
    s = parse_with("X pi y + z", own, 2);
    assert_int_equal(algsurf_surface_term_count(s), 2);
    assert_ok(algsurf_surface_terms(s, terms));
    assert_true(terms[0].k == 1 && terms[0].a == 1 && terms[1].j == 1 && terms[1].a == 6);
    const algsurf_constant letters[] = {{"p", 2}, {"i", 3}}; /* of pi: the longest name counts */
    same_with("pi x + xpi y + p i z + ipi", letters, 2, "pi x + pi x y + 6z + 3pi");
    same("p=(1+sqrt(5))/2; p x + pi y", "(1+sqrt(5))/2*x + pi y");
    same_with("pi X y + yX", own, 2, "8y");
    const char *const bad[] = {NULL, "", "x", "y", "z", "sqrt", "1a", "_a", "a b", "a-", "\xc3\xa9"};
    s = (void *)&place;
    for (size_t c = 0; c < sizeof bad / sizeof *bad; c++) {
        const algsurf_constant named[] = {{"ok", 1}, {bad[c], 1}};
        assert_int_equal(algsurf_surface_from_equation("x", named, 2, &s, NULL), ALGSURF_E_ARGUMENT);
    }
    const algsurf_constant twice[] = {{"b", 1}, {"a", 1}, {"b", 1}};
    assert_int_equal(algsurf_surface_from_equation("x", twice, 3, &s, NULL), ALGSURF_E_ARGUMENT);
    const algsurf_constant nan[] = {{"b", NAN}}, inf[] = {{"b", INFINITY}};
    assert_int_equal(algsurf_surface_from_equation("x", nan, 1, &s, NULL), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_surface_from_equation("x", inf, 1, &s, NULL), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_surface_from_equation("x", NULL, 1, &s, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_from_equation(NULL, good, 1, &s, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_from_equation("x", good, 1, NULL, NULL), ALGSURF_E_ARGUMENT);
    assert_ptr_equal(s, &place);
}

/* Bounded time for long texts.  Catches: quadratic digits or sums, recursion on signs, products with
 * constants that cost as much as with polynomials (minutes), depth that never shrinks. */
TEST(test_long_texts) {
    enum { LENGTH = 1000000 };
    char *text = malloc(LENGTH + 64);
    assert_non_null(text);
    static char place;
    algsurf_surface *s = (void *)&place;
    algsurf_parse_error error;

    memset(text, '7', LENGTH), strcpy(text + LENGTH, "e-999999x"); /* a million digits */
    s = parse(text);
    algsurf_term term;
    assert_ok(algsurf_surface_terms(s, &term));
    assert_true(term.a == 7.777777777777777777777);

    memset(text, '-', LENGTH), strcpy(text + LENGTH, "x");
    same(text, "x");

    for (int n = 0; n < LENGTH; n += 4) memcpy(text + n, n % 8 ? "+x*y" : "-x*z", 4);
    text[LENGTH] = '\0';
    same(text, "125000x*y-125000x*z");

    memset(text, '(', LENGTH), text[LENGTH] = '\0';
    s = (void *)&place;
    assert_int_equal(algsurf_surface_from_equation(text, NULL, 0, &s, &error), ALGSURF_E_SYNTAX);
    assert_int_equal(error.offset, 100);
    assert_ptr_equal(s, &place);

    text[0] = 'x';
    for (int n = 1; n < LENGTH - 1; n += 2) memcpy(text + n, "^1", 2);
    assert_int_equal(algsurf_surface_from_equation(text, NULL, 0, &s, &error), ALGSURF_E_SYNTAX);
    assert_int_equal(error.offset, 201);

    strcpy(text, "(x^64+y^64+z^64)");
    for (int n = 16; n < 100000; n += 2) memcpy(text + n, "*1", 3);
    same(text, "x^64+y^64+z^64");
    memset(text, '(', 100), text[100] = 'x', memset(text + 101, ')', 100), text[201] = '\0';
    same(text, "x");
    for (int n = 0; n < 900; n += 3) memcpy(text + n, "(1)", 3); /* many, but not nested */
    strcpy(text + 900, "x");
    same(text, "x");
    free(text);
}

/* The binomial theorem at degree 64.  Catches: exponents that overflow their fields, a chain of
 * constant powers that leaves int. */
TEST(test_large_powers) {
    algsurf_surface *s = parse("(x+y+z+1)^64");
    size_t count = algsurf_surface_term_count(s);
    assert_int_equal(count, 47905);
    algsurf_term *terms = malloc(count * sizeof *terms);
    assert_non_null(terms);
    assert_ok(algsurf_surface_terms(s, terms));
    mpz_t exact, factor;
    mpq_t q;
    mpz_inits(exact, factor, NULL), mpq_init(q);
    for (size_t t = 0; t < count; t++) { /* 64! / (i! j! k! (64-i-j-k)!), within half a unit */
        unsigned long i = (unsigned long)terms[t].i, j = (unsigned long)terms[t].j,
                      k = (unsigned long)terms[t].k;
        mpz_bin_uiui(exact, 64, i);
        mpz_bin_uiui(factor, 64 - i, j), mpz_mul(exact, exact, factor);
        mpz_bin_uiui(factor, 64 - i - j, k), mpz_mul(exact, exact, factor);
        mpq_set_z(q, exact);
        assert_true(exact_within(terms[t].a, q, (nextafter(terms[t].a, INFINITY) - terms[t].a) / 2));
    }
    mpz_clears(exact, factor, NULL), mpq_clear(q);
    free(terms);
    char text[1000] = "";
    for (int n = 0; n < 40; n++) strcat(text, "(");
    strcat(text, "2");
    for (int n = 0; n < 40; n++) strcat(text, "^64)");
    algsurf_parse_error error;
    assert_int_equal(algsurf_surface_from_equation(text, NULL, 0, &s, &error), ALGSURF_E_RANGE);
}

/* The corpus's surfaces from their closed forms, bit for bit.  Catches: rounding in double on the
 * way (boy, sextic and decic then differ). */
TEST(test_catalogue) {
#define P "((1+sqrt(5))/2)"
    static const char *const surfaces[][2] = {
        {"sphere", "x^2+y^2+z^2-1"},
        {"whitney", "x^2 z + y^2"},
        {"steiner", "x^2y^2+x^2z^2+y^2z^2+xyz"},
        {"chair", "(x^2+y^2+z^2-0.95*5^2)^2 - 0.8((z-5)^2-2x^2)((z+5)^2-2y^2)"},
        {"tangle", "x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8"},
        {"boy", "64(1-z)^3z^3 - 48(1-z)^2z^2(3x^2+3y^2+2z^2) + 12(1-z)z(27(x^2+y^2)^2-24z^2(x^2+y^2)"
                "+36sqrt(2)yz(y^2-3x^2)+4z^4) + (9x^2+9y^2-2z^2)(-81(x^2+y^2)^2-72z^2(x^2+y^2)"
                "+108sqrt(2)xz(x^2-3y^2)+4z^4)"},
        {"sextic", "4(" P "^2x^2-y^2)(" P "^2y^2-z^2)(" P "^2z^2-x^2)-(1+2" P ")(x^2+y^2+z^2-1)^2"},
        {"decic", "8(x^2-" P "^4y^2)(y^2-" P "^4z^2)(z^2-" P "^4x^2)(x^4+y^4+z^4-2x^2y^2-2x^2z^2-2y^2z^2)"
                  "+(3+5" P ")(x^2+y^2+z^2-1)^2(x^2+y^2+z^2-(2-" P "))^2"},
        {"cusp", "z^3+xz+y"},
        {"torus", "(x^2+y^2+z^2-0.9^2-2.5^2)^2-4*2.5^2(0.9^2-z^2)"},
        {"pillow", "x^4+y^4+z^4-(x^2+y^2+z^2)"},
        {"lemniscate", "(x^2+y^2+z^2)^2-2*2.7^2(x^2-y^2-z^2)"},
    };
    for (size_t c = 0; c < sizeof surfaces / sizeof *surfaces; c++) {
        char path[1024], line[256];
        const char *end = strrchr(__FILE__, '/'); /* the data lies beside this file */
        int length = end ? (int)(end - __FILE__) + 1 : 0;
        snprintf(path, sizeof path, "%.*sdata/surfaces/%s.terms", length, __FILE__, surfaces[c][0]);
        FILE *file = fopen(path, "r");
        if (!file) fprintf(stderr, "cannot open %s\n", path);
        assert_non_null(file);
        algsurf_surface *s = parse(surfaces[c][1]);
        algsurf_term terms[MOST_TERMS], t;
        size_t count = algsurf_surface_term_count(s), found = 0, lines = 0;
        assert_true(count <= MOST_TERMS);
        assert_ok(algsurf_surface_terms(s, terms));
        while (fgets(line, sizeof line, file)) {
            if (sscanf(line, "%d %d %d %la", &t.i, &t.j, &t.k, &t.a) != 4) continue;
            for (size_t n = 0; n < count; n++) {
                found += terms[n].i == t.i && terms[n].j == t.j && terms[n].k == t.k && terms[n].a == t.a;
            }
            lines++;
        }
        fclose(file);
        if (found != count || lines != count) fprintf(stderr, "%s\n", surfaces[c][0]);
        assert_true(found == count && lines == count);
    }
#undef P
}
