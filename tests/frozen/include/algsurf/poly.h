#ifndef ALGSURF_POLY_H
#define ALGSURF_POLY_H
#include <stddef.h>
#include <stdint.h>
#include "algsurf/status.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_integer {
    const uint64_t *limbs;
    int length;
} algsurf_integer;
#define ALGSURF_MAX_LIMBS 16384
ALGSURF_API algsurf_status algsurf_poly_value(const double *c, const double *r, int degree, double t,
                                             double *value, double *bound);
ALGSURF_API algsurf_status algsurf_poly_value_compensated(const double *c, const double *r, int degree,
                                                         double t, double *value, double *bound);
ALGSURF_API algsurf_status algsurf_poly_to_bernstein(const double *c, const double *r, int degree, double lo,
                                                     double hi, double *b, double *br);
typedef struct algsurf_table {
    const double *at;
    ptrdiff_t power, polynomial;
} algsurf_table;
#ifdef __cplusplus
}
#endif
#endif
