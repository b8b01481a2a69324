/* interval_complex.c - rectangles of the complex plane: division, modulus, the public operations.
 *
 * Division is a * (1/b) with the exact hull of 1/b up to rounding (Rokne, Lancaster, Complex interval
 * arithmetic, Comm. ACM 14, 1971).  Re 1/b = x / (x^2 + y^2) is harmonic, so its extremes lie on the border
 * of the rectangle. For x > 0 it falls with |y|; along x it rises up to x = |y| and falls after.  Hence the
 * largest value over a rectangle that reaches into x > 0 is at the least |y|, at the x nearest to that; over
 * one in x <= 0 it is at the greatest |y|, at one of the two ends of x.  The smallest value is that of the
 * mirrored rectangle with the sign turned, and Im 1/b = -y / (x^2 + y^2) is the same function with x and y
 * exchanged.
 *
 * Squares of components leave the range of double long before their quotients do: where a magnitude is
 * outside 2^+-300, it is brought near 1 by a power of two, rounded outward.
 */
#include "../base/arithmetic.h"
#include "../base/fpenv.h"
#include "value.h"
#include "interval_impl.h"

/* 0 if a number of that size can be squared and divided at ease, otherwise its binary exponent. */
static int awkward_exponent(double size) {
    if (size == 0 || isinf(size) || (size >= 0x1p-300 && size <= 0x1p300)) return 0;
    int k;
    (void)frexp(size, &k);
    return k;
}

static algsurf_interval sum_of_squares(algsurf_interval x, algsurf_interval y) {
    return algsurf_i_interval_add(algsurf_i_interval_sqr(x), algsurf_i_interval_sqr(y));
}

/* sqrt(x^2 + y^2), x, y >= 0 */
static algsurf_interval modulus(double x, double y) {
    int k = awkward_exponent(x > y ? x : y);
    algsurf_interval u = algsurf_i_interval_scale((algsurf_interval){x, x}, -k);
    algsurf_interval v = algsurf_i_interval_scale((algsurf_interval){y, y}, -k);
    return algsurf_i_interval_scale(algsurf_i_interval_sqrt(sum_of_squares(u, v)), k);
}

algsurf_interval algsurf_i_cinterval_abs(algsurf_cinterval a) {
    algsurf_interval x = algsurf_i_interval_abs(a.re), y = algsurf_i_interval_abs(a.im);
    return (algsurf_interval){modulus(x.lo, y.lo).lo, modulus(x.hi, y.hi).hi};
}

/* x / (x^2 + y^2), x, y >= 0; its limit 0 at infinity, and everything at x = y = 0. */
static algsurf_interval inverse_part(double x, double y) {
    double size = x > y ? x : y;
    if (size == 0) return (algsurf_interval){0, INFINITY};
    if (isinf(size)) return (algsurf_interval){0, 0};
    int k = awkward_exponent(size);
    algsurf_interval u = algsurf_i_interval_scale((algsurf_interval){x, x}, -k);
    algsurf_interval v = algsurf_i_interval_scale((algsurf_interval){y, y}, -k);
    return algsurf_i_interval_scale(algsurf_i_interval_div(u, sum_of_squares(u, v)), -k);
}

/* The largest x / (x^2 + y^2), rounded up.  size_y = { |y| } */
static double largest_part(algsurf_interval x, algsurf_interval size_y) {
    if (x.hi > 0) {
        double least = x.lo > 0 ? x.lo : 0, y = size_y.lo;
        return inverse_part(y < least ? least : y > x.hi ? x.hi : y, y).hi;
    }
    double left = inverse_part(-x.lo, size_y.hi).lo, right = inverse_part(-x.hi, size_y.hi).lo;
    return 0.0 - (left < right ? left : right);
}

/* { x / (x^2 + y^2) } */
static algsurf_interval range_of_part(algsurf_interval x, algsurf_interval y) {
    y = algsurf_i_interval_abs(y);
    return (algsurf_interval){0.0 - largest_part(algsurf_i_interval_neg(x), y), largest_part(x, y)};
}

static algsurf_cinterval inverse(algsurf_cinterval b) {
    return (algsurf_cinterval){range_of_part(b.re, b.im), algsurf_i_interval_neg(range_of_part(b.im, b.re))};
}

/* The exponent that brings the larger component near 1. */
static int size_exponent(algsurf_cinterval a) {
    double x = algsurf_i_interval_abs(a.re).hi, y = algsurf_i_interval_abs(a.im).hi;
    return awkward_exponent(x > y ? x : y);
}

algsurf_cinterval algsurf_i_cinterval_mul(algsurf_cinterval a, algsurf_cinterval b) {
    return (algsurf_cinterval){
        algsurf_i_interval_sub(algsurf_i_interval_mul(a.re, b.re), algsurf_i_interval_mul(a.im, b.im)),
        algsurf_i_interval_add(algsurf_i_interval_mul(a.re, b.im), algsurf_i_interval_mul(a.im, b.re))};
}

algsurf_cinterval algsurf_i_cinterval_div(algsurf_cinterval a, algsurf_cinterval b) {
    int i = size_exponent(a), j = size_exponent(b);
    algsurf_cinterval x = algsurf_i_cinterval_scale(a, -i), y = inverse(algsurf_i_cinterval_scale(b, -j));
    return algsurf_i_cinterval_scale(algsurf_i_cinterval_mul(x, y), i - j);
}

ALGSURF_I_ENTRY(algsurf_status, cinterval_arg, (algsurf_cinterval a, algsurf_interval *result), (a, result)) {
    if (!result || !algsurf_i_cinterval_valid(a)) return ALGSURF_E_ARGUMENT;
    if (algsurf_i_cinterval_has_zero(a)) return ALGSURF_E_RANGE;
    *result = algsurf_i_cinterval_arg(a);
    return ALGSURF_OK;
}

static double algsurf_i_cinterval_width(algsurf_cinterval a) {
    double re = algsurf_i_interval_width(a.re), im = algsurf_i_interval_width(a.im);
    return re > im ? re : im;
}

static int algsurf_i_cinterval_contains(algsurf_cinterval a, algsurf_complex z) {
    return algsurf_i_interval_contains(a.re, z.re) && algsurf_i_interval_contains(a.im, z.im);
}

static int algsurf_i_cinterval_interior(algsurf_cinterval a, algsurf_cinterval b) {
    return algsurf_i_interval_interior(a.re, b.re) && algsurf_i_interval_interior(a.im, b.im);
}

#define RANGE algsurf_cinterval
#define POINT algsurf_complex
#define CALL(name) cinterval_##name
#define OP(name) algsurf_i_cinterval_##name
#include "interval_calls_template.h"
