/* refine_dd.h - the root in a bracket, in double-double. */
#ifndef ALGSURF_REFINE_DD_H
#define ALGSURF_REFINE_DD_H
#include "../base/eft.h"

/* The root of sum c_k v^k, degree n, in [lo,hi], where the sign at lo is `sign` and at hi the opposite:
 * approximate, to what evaluation in double-double can tell.  Bounded work: at most 400 evaluations. */
algsurf_dd algsurf_i_refine_dd(const algsurf_dd *c, int n, algsurf_dd lo, algsurf_dd hi, int sign);

/* The sign of sum c_k v^k as evaluated in double-double. */
int algsurf_i_sign_dd(const algsurf_dd *c, int n, algsurf_dd v);

#endif
