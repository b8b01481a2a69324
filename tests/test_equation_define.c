/* test_equation_define.c - equations that define names: w = y^2 + z^2; x^2 - w = 0.
 *
 * Each test says which breaks it catches.
 */
#include "equation_case.h"

static const char *const defined[][2] = {
    {"w = y^2 + z^2; x^2 - w = 0", "x^2-y^2-z^2"},
    {"w=y^2;v=w+z;v^2=w*x;", "(y^2+z)^2=y^2x"},
    {"r = 2; x^2 + y^2 = r^2 - z^2", "x^2+y^2+z^2-4"},
    {"$ \\rho = x^2 \\; + y^2 ; \\rho^2 = \u03c1 z $", "(x^2+y^2)^2-(x^2+y^2)z"},
    {"w=x+1; 2w^2y", "2(x+1)^2y"},
    {"w=x+1; a1=y; zwya1ww", "z*(x+1)*y*y*(x+1)*(x+1)"},
    {"wy=x; w=z; wywy", "x*x"},
    {"w=0; w x + y", "y"},
    {"w=5; x sin w + y/w^w", "sin(5)x+y/3125"},
    {"\\begin{equation} s_1 = x+y+z; s_2 = xy+yz+zx; s_1 s_2 = 1. \\end{equation}", "(x+y+z)(x y+y z+z x)=1"},
    {"v=x; $ w=y; v = w $;", "x-y"},
    {"v=x; f(x,y,z) = v^2 = 1", "x^2-1"},
    {"S=1/(2+1); S^2x=1", "x/9-1"},
};

/* A name is its sum in brackets, whatever stands about it.  Catches: brackets left out, letters lost behind a
 * name that was put in, a blank of LaTeX taken for the end. */
TEST(test_defined) {
    for (size_t c = 0; c < sizeof defined / sizeof *defined; c++) same(defined[c][0], defined[c][1]);
    const algsurf_constant a = {"a", 2};
    same_with("w=a x; b=a; w b = a", &a, 1, "4x-2");
}

static const refused_text refused[] = {
    {"w=y; v=w+u; u=1; x=v", "u", "used before it is defined"},
    {"w=w+1; x=w", "w", "used before it is defined"},
    {"w=y; w=z; x=w", "w", "a value already"},
    {"a=y; x=a", "a", "a value already"},
    {"w=y+b; x=w", "b", "needs a value"},
    {"w=y=z; x=w", "=", "or ';'"},
    {"w=; x=w", ";", "expected a number"},
    {"w=y;; x=w", ";", "expected a number"},
    {"w=|y|; x=w", "|", "absolute value"},
    {"x=1; y", "y", "nothing may follow ';'"},
    {"xy=1; y", "y", "nothing may follow ';'"},
    {"w=y; x=w; z", "z", "nothing may follow ';'"},
    {"w=y; 1/w", "w", "multiply both sides"},
    {"w=(x+y)^40; x*w*w", "*", "above 64"},
    {"w=x", "w", "needs a value"}, /* no definition: nothing behind it */
    {"w=x ; ", "w", "needs a value"},
};

/* Catches: names known before they are read, for ever, or twice; errors that are told elsewhere. */
TEST(test_refused) {
    const algsurf_constant a = {"a", 2};
    for (size_t c = 0; c < sizeof refused / sizeof *refused; c++) explained(&refused[c], &a, 1);
}

/* The k-th name stands for twice the one before it.  Catches: what is put in without a limit, time that grows
 * as a power, depth that is not counted. */
TEST(test_limits) {
    char text[4096];
    for (int names = 5; names <= 200; names += 195) {
        size_t length = (size_t)sprintf(text, "w0=x;");
        for (int k = 1; k <= names; k++)
            length += (size_t)sprintf(text + length, "w%d=w%d+w%d;", k, k - 1, k - 1);
        sprintf(text + length, "w%d=1", names);
        if (names == 5) {
            same(text, "32x-1");
            continue;
        }
        algsurf_surface *s;
        algsurf_parse_error error;
        double begin = unit_seconds();
        assert_int_equal(algsurf_surface_from_equation(text, NULL, 0, &s, &error), ALGSURF_E_SYNTAX);
        assert_non_null(strstr(error.message, "20000 characters"));
        assert_true(unit_seconds() - begin < 0.5);
    }
    size_t length = (size_t)sprintf(text, "w0=x;");
    for (int k = 1; k <= 120; k++) length += (size_t)sprintf(text + length, "w%d=w%d;", k, k - 1);
    sprintf(text + length, "w98=1");
    explained(&(refused_text){text, "w100", "nested deeper"}, NULL, 0);
}

/* Definitions are read once more where they stand, with the letters about them.  Catches: time with the
 * square of the length of a name or of the number of definitions. */
TEST(test_long) {
    enum { LENGTH = 400000 };
    char *text = malloc(LENGTH + 200000);
    assert_non_null(text);
    double begin = unit_seconds();
    size_t length = (size_t)sprintf(text, "w=1;");
    memset(text + length, 'w', 15000), length += 15000;
    memset(text + length, 'q', LENGTH), length += LENGTH;
    strcpy(text + length, "x");
    const algsurf_constant q = {"q", 1};
    same_with(text, &q, 1, "x");
    length = 0;
    for (int k = 0; k < 20000; k++) length += (size_t)sprintf(text + length, "c%d=1;", k);
    strcpy(text + length, "c19999 x");
    same(text, "x");
    assert_true(unit_seconds() - begin < 3);
    free(text);
}
