#ifndef ALGSURF_INTERVAL_H
#define ALGSURF_INTERVAL_H
#include "algsurf/status.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_complex {
    double re, im;
} algsurf_complex;
typedef struct algsurf_interval {
    double lo, hi;
} algsurf_interval;
typedef struct algsurf_cinterval {
    algsurf_interval re, im;
} algsurf_cinterval;
ALGSURF_API algsurf_status algsurf_interval_make(double lo, double hi, algsurf_interval *result);
ALGSURF_API algsurf_interval algsurf_interval_add(algsurf_interval a, algsurf_interval b);
ALGSURF_API algsurf_interval algsurf_interval_sub(algsurf_interval a, algsurf_interval b);
ALGSURF_API algsurf_interval algsurf_interval_mul(algsurf_interval a, algsurf_interval b);
ALGSURF_API algsurf_status algsurf_interval_div(algsurf_interval a, algsurf_interval b,
                                                algsurf_interval *result);
ALGSURF_API algsurf_status algsurf_interval_pow(algsurf_interval a, int n, algsurf_interval *result);
ALGSURF_API algsurf_status algsurf_interval_sqrt(algsurf_interval a, algsurf_interval *result);
ALGSURF_API algsurf_interval algsurf_interval_abs(algsurf_interval a);
ALGSURF_API algsurf_interval algsurf_interval_hull(algsurf_interval a, algsurf_interval b);
ALGSURF_API algsurf_status algsurf_interval_intersect(algsurf_interval a, algsurf_interval b,
                                                      algsurf_interval *result);
ALGSURF_API double algsurf_interval_width(algsurf_interval a);
ALGSURF_API double algsurf_interval_mid(algsurf_interval a);
ALGSURF_API int algsurf_interval_contains(algsurf_interval a, double x);
ALGSURF_API int algsurf_interval_interior(algsurf_interval a, algsurf_interval b);
ALGSURF_API algsurf_status algsurf_interval_poly(const algsurf_interval *c, int degree, algsurf_interval x,
                                                 algsurf_interval *result);
ALGSURF_API algsurf_cinterval algsurf_cinterval_add(algsurf_cinterval a, algsurf_cinterval b);
ALGSURF_API algsurf_cinterval algsurf_cinterval_sub(algsurf_cinterval a, algsurf_cinterval b);
ALGSURF_API algsurf_cinterval algsurf_cinterval_mul(algsurf_cinterval a, algsurf_cinterval b);
ALGSURF_API algsurf_status algsurf_cinterval_div(algsurf_cinterval a, algsurf_cinterval b,
                                                 algsurf_cinterval *result);
ALGSURF_API algsurf_interval algsurf_cinterval_abs(algsurf_cinterval a);
ALGSURF_API algsurf_status algsurf_cinterval_arg(algsurf_cinterval a, algsurf_interval *result);
ALGSURF_API algsurf_cinterval algsurf_cinterval_hull(algsurf_cinterval a, algsurf_cinterval b);
ALGSURF_API algsurf_status algsurf_cinterval_intersect(algsurf_cinterval a, algsurf_cinterval b,
                                                       algsurf_cinterval *result);
ALGSURF_API double algsurf_cinterval_width(algsurf_cinterval a);
ALGSURF_API algsurf_complex algsurf_cinterval_mid(algsurf_cinterval a);
ALGSURF_API int algsurf_cinterval_contains(algsurf_cinterval a, algsurf_complex z);
ALGSURF_API int algsurf_cinterval_interior(algsurf_cinterval a, algsurf_cinterval b);
ALGSURF_API algsurf_status algsurf_cinterval_poly(const algsurf_cinterval *c, int degree, algsurf_cinterval z,
                                                  algsurf_cinterval *result);
#ifdef __cplusplus
}
#endif
#endif
