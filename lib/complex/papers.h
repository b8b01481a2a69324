/* papers.h - what the algorithms of algsurf/papers.h share: the system they solve, its units, its defect.
 *
 * Unknowns z and q_0..q_{n-2}; q_{n-1} = p_n is given, q_{-1} = 0.  The system
 *     F_i = q_{i-1} - z q_i - p_i = 0,   i = 0..n-1,   says that   p(X) = (X - z) sum q_i X^i.
 * It is quadratic: with d = F(q,z), F(q + D, z + t) = d + J (D,t) - t (D;0), and J (D,t) has the components
 * D_{i-1} - z D_i - q_i t (D_{-1} = D_{n-1} = 0).  So J (D,t) = -d is solved from the top in O(n):
 *     S_i = d_i + z S_{i+1},  w_i = q_i + z w_{i+1}  (S_n = w_n = 0),  D_{i-1} = -S_i + t w_i,
 * and D_{-1} = 0 gives t = S_0 / w_0; at a solution w_0 = p'(z).  For any other right side put it for -d.
 *
 * Units are powers of two: X = 2^unit Y, and p is divided by 2^exponent, so that near z the variable and
 * the largest coefficient are about 1:
 *     y = z 2^-unit,   c_k = p_k 2^(k unit - exponent),   q_i in units of 2^(exponent - (i+1) unit).
 *
 * Source: Hammer, Hocks, Kulisch, Ratz, C++ Toolbox for Verified Computing, 1995, ch. 9.
 */
#ifndef ALGSURF_COMPLEX_PAPERS_H
#define ALGSURF_COMPLEX_PAPERS_H
#include "algsurf/papers.h"
#include "../base/eft.h"

/* Finite coefficients and finite radii that are not negative, degree 1..ALGSURF_MAX_POLY_DEGREE?  The
 * caller's options with defaults filled in. */
algsurf_status algsurf_i_paper_check(const algsurf_complex *p, const double *r, int degree,
                                     const algsurf_paper_options *given, algsurf_paper_options *options);

/* The larger part's magnitude. */
static inline double algsurf_i_size(algsurf_complex z) { return fmax(fabs(z.re), fabs(z.im)); }

static inline int algsurf_i_finite(algsurf_complex z) { return isfinite(z.re) && isfinite(z.im); }

/* z 2^k, rounded */
static inline algsurf_complex algsurf_i_shift(algsurf_complex z, int k) {
    return (algsurf_complex){ldexp(z.re, k), ldexp(z.im, k)};
}

/* The unit for work near z; at 0 the mean size of the roots that are not 0.  p[n] is not 0. */
int algsurf_i_unit_near(const algsurf_complex *p, int n, algsurf_complex z);
/* The exponent that belongs to a unit. */
int algsurf_i_exponent_in(const algsurf_complex *p, int n, int unit);

/* A part of d_i as an unevaluated sum: it is high + sum low_k, to within `lost`. */
typedef struct algsurf_i_defect {
    double high, low[5], lost;
} algsurf_i_defect;

/* q - a b - e f - p.  A product below 2^-960, not of a zero, may lose its low part; that is below 2^-1030. */
static inline algsurf_i_defect algsurf_i_defect_part(double q, double a, double b, double e, double f,
                                                     double p) {
    algsurf_dd ab = algsurf_two_prod(-a, b), ef = algsurf_two_prod(-e, f);
    algsurf_dd x = algsurf_two_sum(q, ab.hi), y = algsurf_two_sum(x.hi, ef.hi), s = algsurf_two_sum(y.hi, -p);
    int small = (a != 0 && b != 0 && fabs(ab.hi) < 0x1p-960) || (e != 0 && f != 0 && fabs(ef.hi) < 0x1p-960);
    return (algsurf_i_defect){s.hi, {x.lo, y.lo, s.lo, ab.lo, ef.lo}, small ? 0x1p-1029 : 0};
}

/* algsurf_paper_approximation in the standard environment; arguments were checked. */
algsurf_status algsurf_i_paper_approximation(const algsurf_complex *p, int n, algsurf_complex start,
                                             const algsurf_paper_options *options, algsurf_complex *z,
                                             algsurf_complex *q, int *steps);

/* algsurf_paper_inclusion, likewise; r, Q, unique may be null. */
algsurf_status algsurf_i_paper_inclusion(const algsurf_complex *p, const double *r, int n, algsurf_complex z,
                                         const algsurf_complex *q, const algsurf_paper_options *options,
                                         algsurf_cinterval *Z, algsurf_cinterval *Q, int *unique,
                                         int *inflations);

#endif
