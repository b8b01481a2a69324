/* real_roots.c - all real roots of a polynomial, refined, with their multiplicities: the public calls. */
#include "../base/arithmetic.h"
#include <math.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../base/integer.h"
#include "algsurf/isolate.h"
#include "line.h"

static algsurf_status check_doubles(const algsurf_i_given *p) {
    int zero = 1;
    for (int k = 0; k <= p->degree; k++) {
        if (!isfinite(p->c[k])) return ALGSURF_E_NOT_FINITE;
        zero = zero && p->c[k] == 0;
    }
    return zero ? ALGSURF_E_ZERO : ALGSURF_OK;
}

static algsurf_status check_integers(const algsurf_i_given *p) {
    int zero = 1;
    for (int k = 0; k <= p->degree; k++) {
        const algsurf_integer *z = p->z + k;
        if (z->length < -ALGSURF_MAX_LIMBS || z->length > ALGSURF_MAX_LIMBS) return ALGSURF_E_ARGUMENT;
        if (z->length && !z->limbs) return ALGSURF_E_ARGUMENT;
        zero = zero && algsurf_z_length(z->limbs, z->length < 0 ? -z->length : z->length) == 0;
    }
    return zero ? ALGSURF_E_ZERO : ALGSURF_OK;
}

static ALGSURF_NOINLINE algsurf_status find(const algsurf_i_line *line, algsurf_real_root *roots,
                                            int capacity, int *count) {
    algsurf_real_root found[ALGSURF_MAX_POLY_DEGREE];
    const algsurf_i_given *p = &line->p;
    int n = 0;
    if ((!p->c && !p->z) || p->degree < 0 || p->degree > ALGSURF_MAX_POLY_DEGREE || !(line->lo <= line->hi))
        return ALGSURF_E_ARGUMENT;
    algsurf_status status = p->c ? check_doubles(p) : check_integers(p);
    if (status == ALGSURF_OK) status = algsurf_i_line_solve(line, found, &n);
    if (status != ALGSURF_OK) return status;
    if (n > capacity) return ALGSURF_E_ARGUMENT;
    memcpy(roots, found, (size_t)n * sizeof *roots);
    *count = n;
    return ALGSURF_OK;
}

static algsurf_status solve_given(algsurf_i_given p, double lo, double hi, algsurf_real_root *roots,
                                  int capacity, int *count) {
    const algsurf_i_line line = {p, lo, hi, ALGSURF_I_ALL, 1, NULL, 0};
    if (!roots || !count || capacity < 0) return ALGSURF_E_ARGUMENT;
    algsurf_status status;
    ALGSURF_STANDARD(status = find(&line, roots, capacity, count));
    return status;
}

algsurf_status algsurf_real_roots(const double *c, int degree, double lo, double hi, algsurf_real_root *roots,
                                  int capacity, int *count) {
    return solve_given((algsurf_i_given){c, NULL, degree}, lo, hi, roots, capacity, count);
}

algsurf_status algsurf_real_roots_integers(const algsurf_integer *c, int degree, double lo, double hi,
                                           algsurf_real_root *roots, int capacity, int *count) {
    return solve_given((algsurf_i_given){NULL, c, degree}, lo, hi, roots, capacity, count);
}
