#ifndef ALGSURF_REFINE_H
#define ALGSURF_REFINE_H
#include <stddef.h>
#include "algsurf/observe.h"
#include "algsurf/status.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef enum algsurf_method {
    ALGSURF_METHOD_DEFAULT = 0,
    ALGSURF_METHOD_BRENT = 1,
    ALGSURF_METHOD_BISECTION = 2,
    ALGSURF_METHOD_REGULA_FALSI = 3
} algsurf_method;
typedef struct algsurf_refine_options {
    size_t size;
    int method;
    int max_iterations;
    double absolute_tolerance;
    algsurf_observer *observer;
} algsurf_refine_options;
typedef struct algsurf_refined_root {
    double root;
    double lo, hi;
    double residual;
    int evaluations;
    int iterations;
    int converged;
} algsurf_refined_root;
typedef double (*algsurf_function)(double x, void *data);
ALGSURF_API algsurf_status algsurf_refine_function(algsurf_function f, void *data, double lo, double hi,
                                                   const algsurf_refine_options *options,
                                                   algsurf_refined_root *result);
ALGSURF_API algsurf_status algsurf_refine_poly(const double *c, const double *r, int degree, double lo,
                                               double hi, const algsurf_refine_options *options,
                                               algsurf_refined_root *result);
#ifdef __cplusplus
}
#endif
#endif
