/* interval_poly.c - the range of a polynomial over an interval or a rectangle.
 *
 * Horner's scheme overestimates by the first order of the width.  The centred form
 *     p(x) = p(m) + q(x) (x - m),   q = the quotient of p - p(m) by x - m,
 * has an excess of the second order (Krawczyk, Neumaier 1985): the coefficients of q are the intermediate
 * results of Horner's scheme at the point m, highest first, so both run together.  That is an identity of
 * polynomials, good for complex ones too, where the mean value theorem is not.  q(x) is a slope, about half
 * as wide as the enclosure of p'(x) it replaces.
 */
#include "../base/arithmetic.h"
#include "../base/fpenv.h"
#include "interval_impl.h"

#define RANGE algsurf_interval
#define OP(name) algsurf_i_interval_##name
#define ENCLOSE enclose
#include "interval_poly_template.h"
#undef RANGE
#undef OP
#undef ENCLOSE

#define RANGE algsurf_cinterval
#define OP(name) algsurf_i_cinterval_##name
#define ENCLOSE cenclose
#include "interval_poly_template.h"

#define PUBLIC_POLY(room, name, work, centred)                                                               \
    static algsurf_status here_##name(const algsurf_##room *c, int degree, algsurf_##room x,                 \
                                      algsurf_##room *result) {                                              \
        return work(c, degree, x, centred, result);                                                          \
    }                                                                                                        \
    ALGSURF_I_PUBLIC(algsurf_status, name, here_##name,                                                      \
                     (const algsurf_##room *c, int degree, algsurf_##room x, algsurf_##room *result),        \
                     (c, degree, x, result))

PUBLIC_POLY(interval, interval_poly, enclose, 0)
PUBLIC_POLY(interval, interval_poly_centred, enclose, 1)
PUBLIC_POLY(cinterval, cinterval_poly, cenclose, 0)
PUBLIC_POLY(cinterval, cinterval_poly_centred, cenclose, 1)
