/* degree.h - which degrees a caller's polynomial may have. */
#ifndef ALGSURF_POLY_DEGREE_H
#define ALGSURF_POLY_DEGREE_H
#include "algsurf/status.h"

/* OK, E_ARGUMENT below 0, or E_DEGREE above ALGSURF_MAX_POLY_DEGREE. */
static inline algsurf_status algsurf_i_check_degree(int degree) {
    if (degree < 0) return ALGSURF_E_ARGUMENT;
    return degree > ALGSURF_MAX_POLY_DEGREE ? ALGSURF_E_DEGREE : ALGSURF_OK;
}

#endif
