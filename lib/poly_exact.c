/* poly_exact.c - Horner's rule over expansions: exact, for points where no bound can tell. */
#include "poly_exact.h"

int algsurf_i_poly_exact_sign(const double *c, int degree, double x) {
    algsurf_i_expansion value, point;
    algsurf_i_expansion_set(&value, c[degree]);
    algsurf_i_expansion_set(&point, x);
    for (int k = degree - 1; k >= 0; k--) {
        algsurf_i_expansion_multiply(&value, &point);
        algsurf_i_expansion_add_double(&value, c[k]);
    }
    return algsurf_i_expansion_sign(&value);
}
