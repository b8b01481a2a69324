/* eft.h - error-free transforms and double-double arithmetic.
 *
 * two_sum and two_prod return a rounded result and the exact rounding error (Knuth; Dekker,
 * Veltkamp), barring overflow and, for products, results under 2^-969.  A double-double is an
 * unevaluated sum hi + lo with |lo| <= ulp(hi)/2, a 106-bit number.  The operations below are those
 * of Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks of
 * double-word arithmetic, 2017; each has a relative error of at most 7 u^2 < 2^-103, u = 2^-53,
 * which ALGSURF_DD_U rounds up.
 */
#ifndef ALGSURF_EFT_H
#define ALGSURF_EFT_H
#include <math.h>

#define ALGSURF_U 0x1p-53            /* unit roundoff of double */
#define ALGSURF_DD_U 0x1p-102        /* bound on the relative error of one double-double operation */
#define ALGSURF_SPLITTER 134217729.0 /* 2^27 + 1: Veltkamp's split into 26 bits each */

typedef struct algsurf_dd {
    double hi, lo;
} algsurf_dd;

static inline algsurf_dd algsurf_two_sum(double a, double b) {
    double s = a + b, t = s - a;
    return (algsurf_dd){s, (a - (s - t)) + (b - t)};
}

/* Needs |a| >= |b| or a = 0. */
static inline algsurf_dd algsurf_fast_two_sum(double a, double b) {
    double s = a + b;
    return (algsurf_dd){s, b - (s - a)};
}

static inline algsurf_dd algsurf_two_prod(double a, double b) {
    double p = a * b;
#if defined(__FMA__) || defined(__aarch64__)
    return (algsurf_dd){p, __builtin_fma(a, b, -p)};
#else
    double ta = ALGSURF_SPLITTER * a, tb = ALGSURF_SPLITTER * b;
    double ah = ta - (ta - a), al = a - ah, bh = tb - (tb - b), bl = b - bh;
    return (algsurf_dd){p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
#endif
}

static inline algsurf_dd algsurf_dd_from(double a) { return (algsurf_dd){a, 0.0}; }
static inline algsurf_dd algsurf_dd_neg(algsurf_dd a) { return (algsurf_dd){-a.hi, -a.lo}; }

static inline algsurf_dd algsurf_dd_add(algsurf_dd a, algsurf_dd b) {
    algsurf_dd s = algsurf_two_sum(a.hi, b.hi), t = algsurf_two_sum(a.lo, b.lo);
    s = algsurf_fast_two_sum(s.hi, s.lo + t.hi);
    return algsurf_fast_two_sum(s.hi, s.lo + t.lo);
}

static inline algsurf_dd algsurf_dd_sub(algsurf_dd a, algsurf_dd b) {
    return algsurf_dd_add(a, algsurf_dd_neg(b));
}

static inline algsurf_dd algsurf_dd_add_d(algsurf_dd a, double b) {
    algsurf_dd s = algsurf_two_sum(a.hi, b);
    return algsurf_fast_two_sum(s.hi, s.lo + a.lo);
}

static inline algsurf_dd algsurf_dd_mul(algsurf_dd a, algsurf_dd b) {
    algsurf_dd p = algsurf_two_prod(a.hi, b.hi);
    return algsurf_fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

static inline algsurf_dd algsurf_dd_mul_d(algsurf_dd a, double b) {
    algsurf_dd p = algsurf_two_prod(a.hi, b);
    return algsurf_fast_two_sum(p.hi, p.lo + a.lo * b);
}

/* Quotient, relative error at most 10 u^2 (DWDivDW2). */
static inline algsurf_dd algsurf_dd_div(algsurf_dd a, algsurf_dd b) {
    double q = a.hi / b.hi;
    algsurf_dd r = algsurf_dd_sub(a, algsurf_dd_mul_d(b, q));
    return algsurf_fast_two_sum(q, r.hi / b.hi);
}

/* Square root, a >= 0: one Newton correction of the rounded root, relative error a few u^2. */
static inline algsurf_dd algsurf_dd_sqrt(algsurf_dd a) {
    if (!(a.hi > 0)) return algsurf_dd_from(a.hi);
    double s = sqrt(a.hi);
    algsurf_dd r = algsurf_dd_sub(a, algsurf_two_prod(s, s));
    return algsurf_fast_two_sum(s, r.hi / (2.0 * s));
}

/* Multiplication by a power of two: exact barring underflow. */
static inline algsurf_dd algsurf_dd_scale(algsurf_dd a, double power_of_two) {
    return (algsurf_dd){a.hi * power_of_two, a.lo * power_of_two};
}

static inline int algsurf_in_middle(double a) {
    return a == 0 || (0x1p-400 <= fabs(a) && fabs(a) <= 0x1p400);
}

/* a b + c, rounded once, or to a neighbour of that where the exact value is closer than 2^-104 of itself to
 * the middle between two doubles; a subnormal result twice.  libm's fma rounds wrongly on some systems. */
static inline double algsurf_multiply_add(double a, double b, double c) {
    if (algsurf_in_middle(a) && algsurf_in_middle(b) && fabs(c) <= 0x1p400)
        return algsurf_dd_add_d(algsurf_two_prod(a, b), c).hi;
    if (a == 0 || b == 0 || !isfinite(a) || !isfinite(b) || !isfinite(c)) return a * b + c;
    int i, j, top;
    a = frexp(a, &i), b = frexp(b, &j);
    (void)frexp(c, &top);
    if (c == 0 || top < i + j) top = i + j;
    algsurf_dd product = algsurf_two_prod(a, b);
    product = (algsurf_dd){ldexp(product.hi, i + j - top), ldexp(product.lo, i + j - top)};
    return ldexp(algsurf_dd_add_d(product, ldexp(c, -top)).hi, top);
}

#endif
