/* value.h - a caller's polynomials: what they may be, their values with bounds, tables of them. */
#ifndef ALGSURF_VALUE_H
#define ALGSURF_VALUE_H
#include <math.h>

#include "algsurf/poly.h"

/* OK, E_ARGUMENT below 0, or E_DEGREE above ALGSURF_MAX_POLY_DEGREE. */
static inline algsurf_status algsurf_i_check_degree(int degree) {
    if (degree < 0) return ALGSURF_E_ARGUMENT;
    return degree > ALGSURF_MAX_POLY_DEGREE ? ALGSURF_E_DEGREE : ALGSURF_OK;
}

/* The same, E_NOT_FINITE for numbers that are not, or E_ARGUMENT for a negative radius: coefficients of as
 * many parts, 1 or 2, and their radii, or null. */
static inline algsurf_status algsurf_i_check_polynomial(const double *c, int parts, const double *r,
                                                        int degree) {
    algsurf_status status = algsurf_i_check_degree(degree);
    for (int k = 0; status == ALGSURF_OK && k <= degree; k++) {
        const double *a = c + k * parts;
        if (!isfinite(a[0]) || !isfinite(a[parts - 1]) || (r && !isfinite(r[k]))) return ALGSURF_E_NOT_FINITE;
        if (r && r[k] < 0) return ALGSURF_E_ARGUMENT;
    }
    return status;
}

typedef struct algsurf_i_bounded {
    double value, bound;
} algsurf_i_bounded;

/* algsurf_poly_value_compensated for finite c, r (or null) and t, in the library's floating-point
 * environment. */
algsurf_i_bounded algsurf_i_compensated(const double *c, const double *r, int degree, double t);

/* Entries of powers 0 .. degree of polynomial i, `step` apart in the row. */
static inline void algsurf_i_table_row(const algsurf_table *t, int degree, size_t i, double *row, int step) {
    for (int k = 0; k <= degree; k++) row[k * step] = t->at[k * t->power + (ptrdiff_t)i * t->polynomial];
}

#endif
