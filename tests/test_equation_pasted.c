/* test_equation_pasted.c - equations as people paste them: typography, LaTeX, Greek letters; and what those
 * are told who write something else.
 *
 * Each test says which breaks it catches.
 */
#include "equation_case.h"

static const char *const pasted[][2] = {
    {"x**2+y ** 3==z", "x^2+y^3-z"},
    {"x*y**2*z", "x y^2 z"},
    {"x\u00b2+y\u00b3+z\u2074=1", "x^2+y^3+z^4-1"},
    {"x\u00b9\u2070+x\u2070+x\u2075\u00b9+x\u2076+x\u2077+x\u2078+x\u2079+y",
     "x^10+1+x^51+x^6+x^7+x^8+x^9+y"},
    {"-x\u00b2+2\u00b3y", "8y-x^2"},
    {"xy\u00b2z", "x y^2 z"},
    {"2\u00b7x\u00d7y\u22c5z\u2217x\u2062y", "2x*y*z*x*y"},
    {"x\u2212y\u2013\u22121", "x-y+1"},
    {"x\u2010y\u2011z\u2012x^2\u2014y^2\u2015z^2", "x-y-z-x^2-y^2-z^2"},
    {"x\u1680+\u2000y\u2001=\u3000z", "x+y=z"},
    {"x\u00f72 + y\u22154+z\u20442", "x/2+y/4+z/2"},
    {"\xef\xbb\xbfx\u00a0+\u2009y\u202f=\u20031\u200b", "x+y=1"},
    {"[x+{y-1}]^{2}+x^[2]", "(x+y-1)^2+x^2"},
    {"X^2+yY XZ", "x^2+y y x z"},
    {"x^2+y;", "x^2+y"},
    {"x=1 ; ", "x-1"},
    {"=x^2-y", "x^2-y"},
    {" == x", "x"},
    {"\u221a2 x+\u221a(2+1)y+\u221a(x\u2070)z", "sqrt(2)x+sqrt(3)y+z"},
    {"\u221a\u221a16x + \u221a9\u00b2y+3\u221a{4}z", "2x+9y+6z"},
    {"x+y\u221api\u03c0", "x+y*pi*sqrt(pi)"},
    {"sqrt[9]x+sqrt{4}y", "3x+2y"},
    {"pi x+\u03c0y+Pi z - PI*1", "pi(x+y+z-1)"},
    {"2pix^2+\u03c0\u00b2y", "2*pi*x^2+pi^2*y"},
    {"3.14159265358979323846264338327950288x", "pi*x"},
    {"sin(0)x+cos(0)y+sin(pi)z+cos(pi)", "y-1"},
    {"sin(pi/6)x+cos(pi/3)y+sin(-pi/2)z", "x/2+y/2-z"},
    {"cos(2pi/5)x+cos{4*\u03c0/5}y+z", "(sqrt(5)-1)/4*x-(sqrt(5)+1)/4*y+z"},
    {"sin(31pi+pi/4)x+cos(-31 pi-pi/4)y+z", "-sqrt(2)/2*x-sqrt(2)/2*y+z"},
    {"x+y sin 2-cos .5", "x+y*sin(2)-cos(0.5)"}, /* one thing alone needs no brackets */
    {"x+(cos sqrt(2))y=cos\u221a2", "x+y*cos(sqrt(2))-cos(sqrt(2))"},
    {"x=sin cos 1;", "x-sin(cos(1))"},
    {"sin(1e-200)x+cos(1e-200)y", "1e-200x+y"},
    {"sin(0.001)^2x+cos[0.001]^2x+y", "x+y"},
    {"(sin(100)^2+cos(100)^2-1)x^9+y", "y"},
    {"\u00bdx^2+\u00bcy\u00b2-\u00bez", "x^2/2+y^2/4-3z/4"},
    {"x=\u00bd(y\u2212\u00be)\u00b7\u03c0", "x-pi*(y-0.75)/2"},
    {"\u00bd\u00b2x+cos\u00bd", "x/4+cos(0.5)"},
    {"(pi-3.14159265358979323846264338327950288419716939937510582)x^9+y", "y"},
};

/* Catches: a sign or a blank of typesetters that is read as another, a table's row that is never found. */
TEST(test_pasted) {
    for (size_t c = 0; c < sizeof pasted / sizeof *pasted; c++) same(pasted[c][0], pasted[c][1]);
}

static const char *const latex[][2] = {
    {"$x^2+y^2=1$", "x^2+y^2-1"},
    {" $$ x^{2} = y $$ ", "x^2-y"},
    {"\\(x=1\\);", "x-1"},
    {"\\[ =x+y \\] ;", "x+y"},
    {"\\frac{1}{2}x+\\dfrac{y}{4}-\\tfrac{x+1}{2+2}", "x/2+y/4-(x+1)/4"},
    {"\\frac12x+\\frac 1 3 y+\\frac3{4}z", "x/2+y/3+3*z/4"},
    {"2\\frac{3}{4}x\\frac{y}{2}", "3/4*x*y"},
    {"\\frac{\\frac{1}{2}}{\\frac{1}{3}}x", "3x/2"},
    {"\\frac{x}{2}^2+1/\\frac12y", "x^2/4+2y"},
    {"\\sqrt{2}x+\\sqrt3y+\\sqrt(5) z", "sqrt(2)x+sqrt(3)y+sqrt(5)z"},
    {"2\\sqrt{1+\\sqrt 9}x", "4x"},
    {"\\left(x+\\left[y\\right]\\right)^{2}", "(x+y)^2"},
    {"\\bigl\\{x+\\Bigl (y \\Bigr )\\bigr\\}\\cdot\\big(2\\Big)", "2x+2y"},
    {"\\left\\{x\\right\\}^2\\left (y\\right)", "x^2y"},
    {"x\\cdot y\\times z\\ast x\\div2", "x*y*z*x/2"},
    {"x\\,y\\;z\\:x\\!y\\ z\\quad x\\qquad y~z", "x^3y^3z^3"},
    {"2\\pi x+\\pi^2y", "2pi x+pi^2y"},
    {"\\sin(1)x+\\cos\\left(\\frac{\\pi}{5}\\right)y+\\sin{2}", "sin(1)x+cos(pi/5)y+sin(2)"},
    {"$$P\\left(x,y,z\\right)=x^2-y$$", "x^2-y"},
    {"\\begin{equation} x^2 = y \\end{equation}", "x^2-y"},
    {" \\begin{align*} x &= y - \\frac{1}{2}, \\end{align*} ", "x-y+1/2"},
    {"\\begin{math}x\\end{math}.", "x"},
    {"$\\displaystyle x = y.$;", "x-y"},
    {"x^2 = y ,", "x^2-y"},
    {"x+y\\cos\\frac{2\\pi}{5}=z\\sin \\frac{\\pi}{5}", "x+y*cos(2pi/5)-z*sin(pi/5)"},
};

/* As other programs have them.  Catches: a sign, a coefficient or a power that is taken for another. */
TEST(test_programs) {
    static const char *const others[][2] = {
        {"x.^2+y.*z./2-1.^2", "x^2+y z/2-1"}, /* MATLAB */
        {"2.*x.^2-3.5.*y", "2x^2-3.5y"},
        {"Sqrt[2] x + Sin[Pi/6]y - Cos[0] z==1", "sqrt(2)x+y/2-z-1"},                     /* Mathematica */
        {"poly {2, <1,2,3,4,5,6,7,8,9,10>}", "x^2+2x y+3x z+4x+5y^2+6y z+7y+8z^2+9z+10"}, /* POV-Ray */
        {"poly { 1 <-1/2, .5e1, 0, sqrt(4)> sturm }", "-x/2+5y+2"},
        {"cubic { <1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20> }",
         "x^3+2x^2y+3x^2z+4x^2+5x y^2+6x y z+7x y+8x z^2+9x z+10x+11y^3+12y^2z+13y^2+14y z^2+15y z+16y+17z^3+"
         "18z^2+19z+20"},
        {"quartic { <1,0,0,0,2,0,0,2,0,-10,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,6,0,0,0,0,1,0,-10,0,9> }",
         "(x^2+y^2+z^2)^2-10(x^2+z^2)+6y^2+9"},
        {"quadric { <1,2,3>, <4,5,6>, <7,8,9>, 10 };", "x^2+2y^2+3z^2+4x y+5x z+6y z+7x+8y+9z+10"},
        {"function { x^2 + {y} - 1 }", "x^2+y-1"},
        {"function(x,y,z) {x=y};", "x-y"},
        {"function(x,y,z){x^2-1}", "x^2-1"},
        {"function (x, y, z)\n{ x }", "x"},
        {"function  { x }", "x"},
        {"x<sup>2</sup>+y<sup> 1+2 </sup>z<sup>4</sup>=1", "x^2+y^3z^4-1"}, /* HTML */
        {"-x<sup>2</sup>", "-x^2"},
    };
    for (size_t c = 0; c < sizeof others / sizeof *others; c++) same(others[c][0], others[c][1]);
    const algsurf_constant poly = {"poly", 2};
    same_with("poly x", &poly, 1, "2x");
}

/* Catches: each command; one whose name begins another's; a digit cut off or too many behind \frac. */
TEST(test_latex) {
    for (size_t c = 0; c < sizeof latex / sizeof *latex; c++) same(latex[c][0], latex[c][1]);
}

/* NAME(x,y,z) = before an equation.  Catches: a head cut short, or taken where a product stands. */
TEST(test_heads) {
    same("P(x,y,z)=x^2+y", "x^2+y");
    same(" f_1 ( X , y , z ) == x^2+y = 1 ;", "x^2+y-1");
    same("\\Phi(x,y,z) = x", "x");
    const algsurf_constant a = {"a", 2};
    same_with("a(x+1)=y", &a, 1, "2x+2-y");
    same_with("a(x)y=1", &a, 1, "2x*y-1");
    same_with("a(x,y,z)=x", &a, 1, "x");
}

/* Greek letters in names.  Catches: a letter mistaken for another, for a variable (xi has an x), cut in two;
 * a name by its command that differs from the letter's. */
TEST(test_greek) {
    static const algsurf_constant constants[] = {{"\u03c6", 2},   {"\u03d5", 3},   {"\\mu", 5},
                                                 {"\u03be_1", 7}, {"a\u03b1", 11}, {"\u03b1", 13},
                                                 {"\u03a0", 17}};
    static const char *const pairs[][2] = {
        {"\u03c6 x", "2x"},
        {"\\phi x", "2x"},
        {"\\phi x+\\varphi y+\u03d5z", "2x+3y+3z"},
        {"\u03bcx+\u00b5y+\\mu z", "5x+5y+5z"},
        {"\u03be_1x+\\xi_1 y", "7x+7y"},
        {"a\u03b1x+a\\alpha y+\u03b1z", "11x+11y+13z"},
        {"\u03b1\u03c6\\mu x", "130x"},
        {"x\\phi^2y\u03c6\u00b2", "16x*y"},
        {"\u03a0x+\\Pi y+\u03c0z", "17x+17y+pi z"},
        {"\\frac{\\phi}{\\mu}x\\left(\\alpha+y\\right)", "2/5*x*(13+y)"},
        {"x\\cos\\phi+y\\sin\\phi=z\\cos \\mu", "x*cos(2)+y*sin(2)-z*cos(5)"},
        {"\\mu{x}\\mu(y)\u03bcpi", "125pi x*y"},
    };
    for (size_t c = 0; c < sizeof pairs / sizeof *pairs; c++)
        same_with(pairs[c][0], constants, 7, pairs[c][1]);
}

/* Every Greek letter is the same as its command, and differs from all others: as names of constants they are
 * no duplicates, but the letter and its command are.  Catches: a row of the table left out or moved. */
TEST(test_alphabet) {
    static const char *const letters[][2] = {
        {"\u03b1", "\\alpha"},     {"\u03b2", "\\beta"},     {"\u03b3", "\\gamma"},
        {"\u03b4", "\\delta"},     {"\u03b5", "\\epsilon"},  {"\u03b6", "\\zeta"},
        {"\u03b7", "\\eta"},       {"\u03b8", "\\theta"},    {"\u03b9", "\\iota"},
        {"\u03ba", "\\kappa"},     {"\u03bb", "\\lambda"},   {"\u03bc", "\\mu"},
        {"\u03bd", "\\nu"},        {"\u03be", "\\xi"},       {"\u03bf", "\\omicron"},
        {"\u03c1", "\\rho"},       {"\u03c2", "\\varsigma"}, {"\u03c3", "\\sigma"},
        {"\u03c4", "\\tau"},       {"\u03c5", "\\upsilon"},  {"\u03c6", "\\phi"},
        {"\u03c7", "\\chi"},       {"\u03c8", "\\psi"},      {"\u03c9", "\\omega"},
        {"\u0391", "\\Alpha"},     {"\u0393", "\\Gamma"},    {"\u0394", "\\Delta"},
        {"\u0398", "\\Theta"},     {"\u039b", "\\Lambda"},   {"\u039e", "\\Xi"},
        {"\u03a0", "\\Pi"},        {"\u03a3", "\\Sigma"},    {"\u03a5", "\\Upsilon"},
        {"\u03a6", "\\Phi"},       {"\u03a8", "\\Psi"},      {"\u03a9", "\\Omega"},
        {"\u03d1", "\\vartheta"},  {"\u03d5", "\\varphi"},   {"\u03f1", "\\varrho"},
        {"\u03f5", "\\varepsilon"}};
    enum { COUNT = sizeof letters / sizeof *letters };
    algsurf_constant all[COUNT + 1];
    for (size_t c = 0; c < COUNT; c++) all[c] = (algsurf_constant){letters[c][0], (double)c + 2};
    for (size_t c = 0; c < COUNT; c++) {
        char text[64], number[64];
        snprintf(text, sizeof text, "%s x+%s y", letters[c][0], letters[c][1]);
        snprintf(number, sizeof number, "%zux+%zuy", c + 2, c + 2);
        same_with(text, all, COUNT, number);
        all[COUNT] = (algsurf_constant){letters[c][1], 1};
        algsurf_surface *s;
        assert_int_equal(algsurf_surface_from_equation("x", all, COUNT + 1, &s, NULL), ALGSURF_E_ARGUMENT);
    }
}

/* Catches: a name of no letters taken for one; pi, \pi and what Unicode leaves free among the letters. */
TEST(test_no_letters) {
    static const char *const bad[] = {"\u03c0", "\\pi", "\\varpi",      "\\Varsigma", "\\",
                                      "\\mux",  "mu\\", "\u0390",       "\\mu a",     "\u03ca",
                                      "\u1f00", "\xce", "\xce\xb1\xce", "\u20ac"};
    for (size_t c = 0; c < sizeof bad / sizeof *bad; c++) {
        algsurf_surface *s;
        const algsurf_constant constant = {bad[c], 1};
        if (algsurf_surface_from_equation("x", &constant, 1, &s, NULL) != ALGSURF_E_ARGUMENT)
            fail_msg("a name: '%s'", bad[c]);
    }
}

static const refused_text explanations[] = {
    {"x^2 + |y| = 1", "|", "absolute value"},
    {"|x|", "|", "absolute value"},
    {"(x + |y|)", "|", "absolute value"},
    {"2|x| = y", "|", "absolute value"},
    {"sin(x) = y", "sin", "not a polynomial"},
    {"x + log(y)", "log", "not a polynomial"},
    {"x cosy", "cosy", "not a polynomial"},
    {"x^(1/2) + y", "(", "not a polynomial"},
    {"x^y", "y", "not a polynomial: x, y or z in an exponent"},
    {"2^.5 x", ".5", "sqrt"},
    {"x^-1", "-", "negative power"},
    {"1/(x+y) = z", "(", "multiply both sides"},
    {"sqrt(x)", "(", "not a polynomial: a root"},
    {"\u221ay", "y", "not a polynomial: a root"},
    {"x^2 <= 1", "<", "expected '='"},
    {"x^2 \u2265 1", "\u2265", "expected '='"},
    {"x!", "!", "factorial"},
    {"x + 0,5", ",", "decimal point"},
    {"x2 + y2", "x2", "x^2"},
    {"x 25", "25", "x^2"},
    {"x + 1)", ")", "without an opening one"},
    {"(x + 1]", "]", "or ')'"},
    {"[x + 1)", ")", "or ']'"},
    {"{x + 1)", ")", "or '}'"},
    {"x + (", "", "expected a number"},
    {"sqrt2 x", "sqrt2", "behind sqrt"},
    {"x \u00e9", "\u00e9", "expected an operator"},
    {"x = 1; y", "y", "nothing may follow ';'"},
    {"ax^2 + y", "a", "needs a value"},
    {"y radius", "radius", "needs a value"},
    {"y alpha_x", "alpha_x", "needs a value"},
    {"xyradiusz", "radius", "needs a value"},
    {"x + \u03b1y", "\u03b1", "needs a value"}, /* Greek letters */
    {"x + 2\\xi y", "\\xi", "needs a value"},
    {"x\\beta y", "\\beta", "needs a value"},
    {"x\u03bb\u03bcy", "\u03bb\u03bc", "needs a value"},
    {"\\int x", "\\int", "LaTeX is not understood"}, /* LaTeX */
    {"x^2 + \\mathrm{d}", "\\mathrm", "LaTeX is not understood"},
    {"x \\\\ y", "\\\\", "LaTeX is not understood"},
    {"x + \\", "\\", "LaTeX is not understood"},
    {"x \\\u00e9", "\\\u00e9", "LaTeX is not understood"},
    {"x \\timesx", "\\timesx", "LaTeX is not understood"},
    {"\\left x", "\\left", "LaTeX is not understood"},
    {"\\left.x", "\\left", "LaTeX is not understood"},
    {"\\log x", "\\log", "not a polynomial"},
    {"y + 2\\sin x", "\\sin", "not a polynomial"},
    {"x + \\left|y\\right|", "|", "absolute value"},
    {"x + \\lvert y", "\\lvert", "absolute value"},
    {"x \\leq 1", "\\leq", "expected '='"},
    {"\\frac{1}{x}", "{", "multiply both sides"},
    {"\\frac{1}y", "y", "expected '{'"},
    {"\\frac x{2}", "x", "expected '{'"},
    {"\\frac123", "3", "a number behind a factor"},
    {"\\sqrt25x", "5", "a number behind a factor"},
    {"\\sqrt[3]{2}x", "[", "only square roots"},
    {"\\sqrt x", "x", "expected '{'"},
    {"\\sqrt{x}", "{", "not a polynomial: a root"},
    {"$x", "", "sign that closes"},
    {"$$x$", "$", "sign that closes"},
    {"\\(x\\]", "\\]", "LaTeX is not understood"},
    {"\\[x;\\]", ";", "sign that closes"},
    {"x$", "$", "the end"},
    {"sin x", "sin", "not a polynomial"}, /* words */
    {"y+cos \u03b1", "\u03b1", "needs a value"},
    {"y+\\cos b", "b", "needs a value"},
    {"sin 2x", "2", "needs brackets"}, /* sines without brackets */
    {"sin \\pi/5+x", "\\pi", "needs brackets"},
    {"x+\\sin\\pi x", "\\pi", "needs brackets"},
    {"\\sin\\frac{\\pi}{5}x", "\\frac", "needs brackets"},
    {"\\cos\\frac{1}{5}\\pi+x", "\\frac", "needs brackets"},
    {"\\cos\\frac{1}{5}^2+x", "\\frac", "needs brackets"},
    {"x+cos 2 3", "2", "needs brackets"},
    {"x+cos 2\u00bd", "2", "needs brackets"},
    {"x+cos pi\u00b2", "pi", "needs brackets"},
    {"x+cos pi*2", "pi", "needs brackets"},
    {"x+sin -1", "-", "needs brackets"},
    {"x+sin", "", "needs brackets"},
    {"x+sin |1|", "|", "absolute value"},
    {"\\sin^2 1 x", "^", "write sin(a)^2"},
    {"x+sin\u00b2(1)", "\u00b2", "write sin(a)^2"},
    {"sin piy", "sin", "not a polynomial"},
    {"sin \u221ax", "x", "a root"},
    {"pow(x,2)", "pow", "write x^2"},
    {"x pow(y,2)", "pow", "write x^2"},
    {"y+foo(x)", "foo", "no function of this name"},
    {"f(x, y)", "f", "no function of this name"},
    {"\u03c6(x,1)", "\u03c6", "no function of this name"},
    {"a_1(x,1)", "a_1", "no function of this name"},
    {"b(x+1)", "b", "needs a value"},
    {"b_1(x+1)", "b_1", "needs a value"},
    {"foo x", "foo", "needs a value"},
    {"pow x", "pow", "needs a value"},
    {"f(x,y) = x", "f", "write z ="},
    {"f(x,z,y) = x", "f", "no function of this name"},
    {"f(x,y,z) x", "f", "no function of this name"},
    {"f(x,y,z) = =x", "=", "expected a number"},
    {"x_1^2+y", "x_1", "coordinates are x, y and z"}, /* indices */
    {"2x_{1}", "x_", "coordinates are x, y and z"},
    {"x y_2", "y_2", "constants may be named"},
    {"xZ_i", "Z_i", "constants may be named"},
    {"x\u2081^2+y", "\u2081", "coordinates are x, y and z"},
    {"x+2ab\u2080", "ab", "constants may be named"},
    {"x+\u2093", "\u2093", "coordinates are x, y and z"},
    {"x+\u208a", "\u208a", "expected a number"},
    {"x\u00bd", "\u00bd", "a number behind a factor"},
    {"2\u00bd", "\u00bd", "a number behind a factor"},
    {"x^\u00bd", "\u00bd", "as exponent"},
    {"c_{1}x", "c_", "write a_1"},
    {"\\mu_{1}x", "\\mu_", "write a_1"},
    {"x = 1 and y = 2", "and", "one equation"},
    {"x or y", "or", "one equation"},
    {"x = 1, y = 2", ",", "one equation"},
    {"(x, y)", ",", "no points or vectors"},
    {"(0,5x+y)", ",", "decimal point"},
    {"(1,2,3)", ",", "no points or vectors"},
    {"<1,2>", "<", "expected '='"},
    {"Abs[x]+y", "Abs", "not a polynomial"}, /* other programs */
    {"Power[x, 2]", "Power", "write x^2"},
    {"ContourPlot3D[x^2==1, {x,-1,1}]", "ContourPlot3D", "no function of this name"},
    {"isosurface { function { x } }", "isosurface", "of POV-Ray"},
    {"poly { 65, <1> }", "65", "the order of poly"},
    {"poly { 1, <1, 2, 3> }", "}", "too few coefficients"},
    {"poly { 1, <1, 2, 3, 4, 5> }", "5", "too many coefficients"},
    {"poly { 1, <1, 2, x, 4> }", "x", "expected a constant"},
    {"quadric { <1,1,1>,<0,0,0>,<0,0,0>,2 } x", "x", "expected"},
    {"cubic { <1> texture", "texture", "of POV-Ray"},
    {"function { x", "", "sign that closes"},
    {"x<sup>65</sup>", "<sup>", "above 64"},
    {"x<sup> y</sup>", "y", "in an exponent"},
    {"x<sup>2+", "", "expected a number"},
    {"x<sup>2=1", "=", "or </sup>"},
    {"<sup>2</sup>", "<sup>", "nothing before it"},
    {"x<sub>1</sub>", "<sub>", "coordinates are x, y and z"},
    {"x^2 & y", "&", "one equation"},
    {"x.^y", "y", "in an exponent"},
    {"\\begin{eqnarray} x", "\\begin", "LaTeX is not understood"},
    {"\\begin{equation} x", "", "sign that closes"},
    {"x = y. z", ".", "the end"},
};

/* What is refused because it is no polynomial, or is a slip, is told what to do.  Catches: an explanation
 * that is not reached, or that is given for something else; a name cut short or too long. */
TEST(test_explained) {
    for (size_t c = 0; c < sizeof explanations / sizeof *explanations; c++)
        explained(&explanations[c], NULL, 0);
    const algsurf_constant pow = {"pow", 2}, a = {"a", 2}, index = {"x_1", 3};
    same_with("pow(x+2)", &pow, 1, "2x+4");
    same_with("x_1 x", &index, 1, "3x");
    explained(&(refused_text){"a_{1}x", "a_", "write a_1"}, &a, 1);
    explained(&(refused_text){"ax_1", "x_1", "coordinates are x, y and z"}, &a, 1);
}

/* Names of a million letters, and brackets of LaTeX a million deep.  Catches: time that grows with the square
 * of the length, depth without a limit. */
TEST(test_long) {
    enum { LENGTH = 1000000 };
    char *text = malloc(LENGTH + 64);
    assert_non_null(text);
    const algsurf_constant one[] = {{"\u03b1", 1}, {"\u03b1\u03b1\u03b1", 1}};
    for (int n = 0; n < LENGTH; n += 2) memcpy(text + n, "\u03b1", 2);
    strcpy(text + LENGTH, "+x");
    same_with(text, one, 2, "1+x");
    for (int n = 0; n < LENGTH; n += 5) memcpy(text + n, "\\left", 5);
    strcpy(text + LENGTH, "(x)");
    explained(&(refused_text){text, "\\left", "LaTeX is not understood"}, NULL, 0);
    for (int n = 0; n < LENGTH; n += 6) memcpy(text + n, "\\frac{", 7);
    explained(&(refused_text){text, "\\frac", "nested deeper"}, NULL, 0);
    for (int n = 0; n < LENGTH; n += 4) memcpy(text + n, "sin ", 4);
    strcpy(text + LENGTH, "1");
    explained(&(refused_text){text, "sin", "nested deeper"}, NULL, 0);
    memset(text, 'k', LENGTH), text[0] = '\\', text[LENGTH] = '\0';
    explained(&(refused_text){text, text, "LaTeX is not understood"}, NULL, 0);
    free(text);
}
