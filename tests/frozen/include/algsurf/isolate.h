#ifndef ALGSURF_ISOLATE_H
#define ALGSURF_ISOLATE_H
#include <stdint.h>
#include "algsurf/observe.h"
#include "algsurf/poly.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_real_root {
    double root;
    double lo, hi;
    int multiplicity;
    int sign;
} algsurf_real_root;
ALGSURF_API algsurf_status algsurf_real_roots(const double *c, int degree, double lo, double hi,
                                              algsurf_real_root *roots, int capacity, int *count);
ALGSURF_API algsurf_status algsurf_real_root_first(const double *c, int degree, double lo, double hi,
                                                   double *root, int *found);
ALGSURF_API algsurf_status algsurf_real_roots_integers(const algsurf_integer *c, int degree, double lo,
                                                       double hi, algsurf_real_root *roots, int capacity,
                                                       int *count);
typedef enum algsurf_bracket_kind {
    ALGSURF_BRACKET_ISOLATED = 0,
    ALGSURF_BRACKET_EXACT = 1,
    ALGSURF_BRACKET_UNDECIDED = 2
} algsurf_bracket_kind;
typedef struct algsurf_bracket {
    double lo, hi;
    int kind;
    int sign;
    int multiplicity;
    int status;
} algsurf_bracket;
typedef struct algsurf_isolate_options {
    size_t size;
    algsurf_observer *observer;
} algsurf_isolate_options;
ALGSURF_API algsurf_status algsurf_isolate_first(const double *c, const double *r, int degree, double lo,
                                                 double hi, const algsurf_isolate_options *options,
                                                 algsurf_bracket *bracket, int *found);
ALGSURF_API algsurf_status algsurf_isolate_all(const double *c, const double *r, int degree, double lo,
                                               double hi, const algsurf_isolate_options *options,
                                               algsurf_bracket *brackets, int capacity, int *count);
ALGSURF_API algsurf_status algsurf_count_roots(const double *c, const double *r, int degree, double lo,
                                               double hi, int *count);
#ifdef __cplusplus
}
#endif
#endif
