/* algsurf/surface.h - an algebraic surface P(x,y,z) = 0.
 *
 * A surface is a polynomial whose coefficients are doubles, taken as exact numbers.  It never changes, so
 * any number of threads may share it.  If the doubles are rounded numbers, sqrt(5) for one,
 * algsurf_surface_with_error makes a surface whose answers allow for that.
 */
#ifndef ALGSURF_SURFACE_H
#define ALGSURF_SURFACE_H
#include <stddef.h>

#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A surface; its members are private. */
typedef struct algsurf_surface algsurf_surface;

/* The monomial a x^i y^j z^k. */
typedef struct algsurf_term {
    int i, j, k; /* exponents, >= 0 */
    double a;    /* the coefficient, finite */
} algsurf_term;

/* A named constant for algsurf_surface_from_equation. */
typedef struct algsurf_constant {
    const char *name; /* a letter, Latin or Greek, then letters, digits, underscores; not x, y, z, sqrt */
    double value;     /* finite; for a number that is not a double, such as sqrt(5), the nearest double */
} algsurf_constant;

/* Where and why an equation was refused. */
typedef struct algsurf_parse_error {
    size_t offset;       /* where it is wrong: bytes from the start of the text */
    size_t length;       /* of the name, number or sign there, in bytes; 0 at the end of the text */
    const char *message; /* what is wrong there, or what was expected; static */
} algsurf_parse_error;

/* A surface from its terms, in any order.  Terms with the same exponents are added (in order, each sum
 * rounded once); then terms that are zero are dropped, whatever their exponents.  count is at least 1.
 *   surface  receives the new surface; free it with algsurf_surface_free
 * Errors: E_ARGUMENT (null, count 0, negative exponent), E_NOT_FINITE (coefficient), E_RANGE (a sum
 * overflows), E_DEGREE (i+j+k above ALGSURF_MAX_DEGREE in a term that is not zero), E_ZERO (nothing remains),
 * E_NO_MEMORY.  A non-zero constant is accepted: a surface without points.
 * Cost: O(count log count).  38 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_surface_from_terms(const algsurf_term *terms, size_t count,
                                                      algsurf_surface **surface);

/* A surface from an equation as text, "x^2 + y^2 = 1 - z^2".
 * Grammar: + - * / ^ ( ), numbers (decimal or hexadecimal, point and exponent allowed, independent of
 * the locale), variables x y z, the given constants, pi, sqrt(...) of a constant, sin(...) and cos(...) of
 * a constant, at most 100 radians, implicit multiplication (3x^2 y), blanks anywhere between tokens, at
 * most one '=' (left minus right).  ^ binds tighter than unary minus, is right associative and takes a
 * constant integer exponent 0..64 (down to -64 for a constant base); division only by a constant.
 * Implicit multiplication binds like *: 1/2x is x/2; its right operand is never a number.  A name is read as
 * far as it goes; if that is no constant, it is a product of shorter names, the longest first: xyz, and ax
 * for a constant a; pi for constants p and i is pi.  sin and cos need no brackets for one number, name, root
 * or fraction of LaTeX at the end of a product: y cos a.  What can be read in two ways, sin pi/5 or cos a y,
 * is refused.
 *     Names may be defined before the equation: w = y^2 + z^2; x^2 - w = 0.  A definition may use x, y, z and
 * names defined before it.  It is put, in brackets, wherever its name stands, at most 20000 bytes in all.  A
 * name is defined once, and is no product of x, y and z.
 *     T_n(a), U_n(a), P_n(a), with n from 0 to 64, are the polynomials of Chebyshev, of both kinds, and of
 * Legendre in an expression a, T_6(x) + T_6(y) + T_6(z): also T_{6}(a), T with subscript digits,
 * ChebyshevT[6, a], ChebyshevU, LegendreP, chebyshevT(6, a), chebyshevU, legendreP.  Coefficients of T and U
 * are exact in double-double, those of P up to n = 30 at least.  A constant named T_6 hides T_6(a), but not
 * the other spellings.
 *     For equations that are pasted (UTF-8): ** is ^, == is =, a middle dot, dot operator or cross is *, a
 * minus sign or dash is -, a division sign is /, superscript digits are an exponent, the signs of a quarter,
 * a half and three quarters are numbers, a root sign is sqrt of the first factor behind it (a number, a
 * constant, a bracket), the Greek letter is pi; [ ] and { } are brackets; X Y Z are variables, unless they
 * are constants; no-break and other typographic spaces are blanks; .^ .* ./ are ^ * /; x<sup>2</sup> is x^2;
 * Sqrt, Sin, Cos are as with small letters; the text may begin with '=', or with NAME(x,y,z) =, which is
 * skipped, and end with '.', ',' or ';'.  Of POV-Ray: function { EQUATION }, function(x, y, z) { EQUATION },
 * and poly { n, < > }, cubic { < > }, quartic { < > }, quadric { < >, < >, < >, j } with constants as
 * coefficients, in the order of POV-Ray.
 *     Of LaTeX: \frac{a}{b} (\dfrac, \tfrac) is (a)/(b), \sqrt{a} a root, \sin and \cos as without
 * backslash, a single digit needs no braces; \cdot, \times and \ast are *, \div is /; \pi is pi; \left and
 * \right (\bigl, ...) before a bracket, \, \; \: \! \quad \qquad ~ \displaystyle are blanks; &= is =; a pair
 * $ $, $$ $$, \( \), \[ \], or \begin{equation} \end{equation} (align, both with *, displaymath, math) may
 * enclose the whole.  A Greek letter in a name is the same as its command: \phi, \Gamma; \varphi is
 * another letter, U+03D5; the Greek pi is none.
 *     Every coefficient is computed in double-double and rounded once; a number alone becomes the nearest
 * double.  pi and roots are computed to the full accuracy of double-double, sines and cosines to 2^-94, so
 * that a coefficient made of them is the double nearest to what is written, or the one next to it, unless
 * terms cancel or the sine or cosine is nearly zero, as in sin(3.141592653589793).  The surface is that of
 * these doubles; algsurf_surface_rounding returns how much they differ from the equation.  What double-double
 * cannot distinguish from zero is zero: p^2-p-1 for p = (1+sqrt(5))/2.
 *   constants, count  named values; constants may be null when count is 0
 *   error             may be null; filled only when E_SYNTAX, E_NAME, E_DEGREE, E_RANGE is returned
 * Errors: E_SYNTAX (also what is no polynomial: division by zero or by x, y, z, functions, fractions as
 * exponents), E_NAME (a name that is neither variable nor constant: a parameter that needs a value),
 * E_DEGREE (a product or power above degree 64, even if it would cancel; error points at its operator),
 * E_RANGE (a number or a coefficient overflows), E_ZERO, E_ARGUMENT (null; bad constant names, duplicates),
 * E_NOT_FINITE (a constant), E_NO_MEMORY.  Cost: at most proportional to the length of the text, definitions
 * put in, times the number of terms of intermediate polynomials, plus the length of the constants' names;
 * (x+y+z+1)^64 takes some 0.02 s.  Nesting deeper than 100 is E_SYNTAX.
 * 96 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_surface_from_equation(const char *text, const algsurf_constant *constants,
                                                         size_t count, algsurf_surface **surface,
                                                         algsurf_parse_error *error);

/* How much the coefficients of a surface made from an equation differ from the exact coefficients of the
 * equation: an upper bound of the relative errors, far above them where terms cancel or a sine is nearly
 * zero, and for high degrees.  11.8 and sqrt(5) in the text are exact numbers; constants are the doubles
 * given.  0 for surfaces from terms, and if every number in the text and every intermediate result is a
 * double; some 2^-53 as a rule; infinite if a coefficient underflowed to 0.  Coefficients that became 0
 * because double-double cannot distinguish them from 0 are not counted.  0 for null.  Since 1.0. */
ALGSURF_API double algsurf_surface_rounding(const algsurf_surface *surface);

/* The same surface with coefficients that are known up to a relative error only: it stands for all
 * polynomials with coefficients a', |a' - a| <= error |a|, and every guarantee (states, that a root is the
 * first, intervals that enclose it, bounds on values) holds for each of them.  What is not the same for all
 * of them is undecided, in the certified tier, too.  With the error that algsurf_surface_rounding returns,
 * answers are about the equation instead of its rounded coefficients.
 *   error        0 <= error < 1; 0 for exact coefficients
 *   approximate  receives the new surface; free it with algsurf_surface_free
 * Errors: E_ARGUMENT (null, error out of range), E_NOT_FINITE (error), E_NO_MEMORY.  Cost: as
 * algsurf_surface_from_terms.  38 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_surface_with_error(const algsurf_surface *surface, double error,
                                                      algsurf_surface **approximate);

/* Releases a surface; null is allowed.  Since 1.0. */
ALGSURF_API void algsurf_surface_free(algsurf_surface *surface);

/* The total degree, 0..ALGSURF_MAX_DEGREE; -1 for null.  Since 1.0. */
ALGSURF_API int algsurf_surface_degree(const algsurf_surface *surface);

/* The number of non-zero terms; 0 for null.  Since 1.0. */
ALGSURF_API size_t algsurf_surface_term_count(const algsurf_surface *surface);

/* Copies the terms, sorted by decreasing k, then j, then i; terms must have room for
 * algsurf_surface_term_count of them.  Errors: E_ARGUMENT (null).  Since 1.0. */
ALGSURF_API algsurf_status algsurf_surface_terms(const algsurf_surface *surface, algsurf_term *terms);

/* P at a point in double.
 *   value, bound  encloses: |value - P(point)| <= bound; bound may be null
 * Errors: E_ARGUMENT, E_NOT_FINITE (point), E_RANGE (overflow).  Cost: O(terms) for dense surfaces.
 * Source: nested Horner scheme with the same scheme on magnitudes as its error bound.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_surface_value(const algsurf_surface *surface, const double point[3],
                                                 double *value, double *bound);

/* P and its gradient at a point in double, with bounds on their errors; either bound may be null.
 * Errors, source: as above.  Cost: about three times algsurf_surface_value.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_surface_gradient(const algsurf_surface *surface, const double point[3],
                                                    double *value, double gradient[3], double *value_bound,
                                                    double gradient_bound[3]);

#ifdef __cplusplus
}
#endif
#endif
