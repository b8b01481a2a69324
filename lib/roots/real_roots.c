/* real_roots.c - all real roots of a polynomial, refined, with their multiplicities: the public calls.
 *
 * Doubles first, then integers, as in isolate.c. */
#include <math.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../base/integer.h"
#include "algsurf/isolate.h"
#include "algsurf/refine.h"
#include "decide.h"

/* The real roots in [lo,hi] of a polynomial from doubles c or, if that is null, from integers z. */
typedef struct question {
    const double *c;
    const algsurf_integer *z;
    int degree;
    double lo, hi;
} question;

static algsurf_status check_doubles(const question *q) {
    int zero = 1;
    for (int k = 0; k <= q->degree; k++) {
        if (!isfinite(q->c[k])) return ALGSURF_E_NOT_FINITE;
        zero = zero && q->c[k] == 0;
    }
    return zero ? ALGSURF_E_ZERO : ALGSURF_OK;
}

static algsurf_status check_integers(const question *q) {
    int zero = 1;
    for (int k = 0; k <= q->degree; k++) {
        const algsurf_integer *z = q->z + k;
        if (z->length < -ALGSURF_MAX_LIMBS || z->length > ALGSURF_MAX_LIMBS) return ALGSURF_E_ARGUMENT;
        if (z->length && !z->limbs) return ALGSURF_E_ARGUMENT;
        zero = zero && algsurf_z_length(z->limbs, z->length < 0 ? -z->length : z->length) == 0;
    }
    return zero ? ALGSURF_E_ZERO : ALGSURF_OK;
}

/* From a bracket to neighbouring doubles; 0 when there is no memory. */
static int narrow(const algsurf_i_coefficients *p, const algsurf_bracket *b, algsurf_real_root *root) {
    algsurf_root found;
    if (algsurf_refine_poly(p->c, p->degree, b->lo, b->hi, NULL, &found) != ALGSURF_OK) return 0;
    double lo = found.lo, hi = found.hi, between;
    while (lo < hi && (between = nextafter(lo, hi)) < hi) {
        int sign = algsurf_i_sign_at(p, between);
        if (sign == ALGSURF_SIGN_UNKNOWN) return 0;
        if (sign != -b->sign) lo = between;
        if (sign != b->sign) hi = between;
    }
    *root = (algsurf_real_root){found.root > lo ? hi : lo, lo, hi, 1, b->sign};
    return 1;
}

/* Where all roots are simple and doubles tell them apart: refined with certain signs. */
static int find_in_doubles(const question *q, algsurf_real_root *roots, int *count) {
    algsurf_i_coefficients p = {q->c, NULL, q->degree};
    algsurf_bracket b[ALGSURF_MAX_DEGREE];
    while (p.degree > 0 && p.c[p.degree] == 0) p.degree--;
    if (p.degree > ALGSURF_MAX_DEGREE || !algsurf_i_isolate_in_lane(p.c, p.degree, q->lo, q->hi, b, count))
        return 0;
    for (int i = 0; i < *count; i++)
        if (!narrow(&p, b + i, roots + i)) return 0;
    return 1;
}

static ALGSURF_NOINLINE algsurf_status find(const question *q, algsurf_real_root *roots, int capacity,
                                            int *count) {
    algsurf_real_root found[ALGSURF_MAX_POLY_DEGREE];
    int n = 0;
    if ((!q->c && !q->z) || q->degree < 0 || q->degree > ALGSURF_MAX_POLY_DEGREE || !(q->lo <= q->hi))
        return ALGSURF_E_ARGUMENT;
    algsurf_status status = q->c ? check_doubles(q) : check_integers(q);
    if (status == ALGSURF_OK && !(q->c && find_in_doubles(q, found, &n)))
        status = q->c ? algsurf_i_decide_roots(q->c, q->degree, q->lo, q->hi, 0, found, q->degree, &n, NULL)
                      : algsurf_i_decide_integers(q->z, q->degree, q->lo, q->hi, found, q->degree, &n);
    if (status != ALGSURF_OK) return status;
    if (n > capacity) return ALGSURF_E_ARGUMENT;
    memcpy(roots, found, (size_t)n * sizeof *roots);
    *count = n;
    return ALGSURF_OK;
}

static algsurf_status answer(const question *q, algsurf_real_root *roots, int capacity, int *count) {
    if (!roots || !count || capacity < 0) return ALGSURF_E_ARGUMENT;
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = find(q, roots, capacity, count);
    algsurf_fpenv_leave(&saved);
    return status;
}

algsurf_status algsurf_real_roots(const double *c, int degree, double lo, double hi, algsurf_real_root *roots,
                                  int capacity, int *count) {
    const question q = {c, NULL, degree, lo, hi};
    return answer(&q, roots, capacity, count);
}

algsurf_status algsurf_real_roots_integers(const algsurf_integer *c, int degree, double lo, double hi,
                                           algsurf_real_root *roots, int capacity, int *count) {
    const question q = {NULL, c, degree, lo, hi};
    return answer(&q, roots, capacity, count);
}
