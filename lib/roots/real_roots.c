/* real_roots.c - all real roots of a polynomial, refined, with their multiplicities: the public call. */
#include <math.h>
#include <string.h>

#include "../base/fpenv.h"
#include "algsurf/isolate.h"
#include "decide.h"

static algsurf_status check(const double *c, int degree, double lo, double hi) {
    int zero = 1;
    if (!c || degree < 0 || degree > ALGSURF_MAX_POLY_DEGREE || !(lo <= hi)) return ALGSURF_E_ARGUMENT;
    for (int k = 0; k <= degree; k++) {
        if (!isfinite(c[k])) return ALGSURF_E_NOT_FINITE;
        zero = zero && c[k] == 0;
    }
    return zero ? ALGSURF_E_ZERO : ALGSURF_OK;
}

static ALGSURF_NOINLINE algsurf_status find(const double *c, int degree, double lo, double hi,
                                            algsurf_real_root *roots, int capacity, int *count) {
    algsurf_real_root found[ALGSURF_MAX_POLY_DEGREE];
    int n = 0;
    algsurf_status status = check(c, degree, lo, hi);
    if (status == ALGSURF_OK) status = algsurf_i_decide_roots(c, degree, lo, hi, 0, found, degree, &n, NULL);
    if (status != ALGSURF_OK) return status;
    if (n > capacity) return ALGSURF_E_ARGUMENT;
    memcpy(roots, found, (size_t)n * sizeof *roots);
    *count = n;
    return ALGSURF_OK;
}

algsurf_status algsurf_real_roots(const double *c, int degree, double lo, double hi, algsurf_real_root *roots,
                                  int capacity, int *count) {
    if (!roots || !count || capacity < 0) return ALGSURF_E_ARGUMENT;
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = find(c, degree, lo, hi, roots, capacity, count);
    algsurf_fpenv_leave(&saved);
    return status;
}
