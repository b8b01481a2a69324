/* real_roots.c - all real roots of a polynomial, refined, with their multiplicities: the public calls.
 *
 * Doubles first, then integers, as in isolate.c; a polynomial t^m q(t^k) becomes q before. */
#include "../base/arithmetic.h"
#include <math.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../base/integer.h"
#include "../poly/value.h"
#include "algsurf/isolate.h"
#include "decide.h"
#include "exact.h"
#include "kernel.h"
#include "power.h"
#include "quarters.h"
#include "refine_impl.h"

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

/* Of two doubles around a root that with less |p|, as the compensated scheme has it; the lower one if they
 * are equal: whichever way the two were found, the same. */
static double nearer(const algsurf_i_coefficients *p, double lo, double hi) {
    if (lo == hi || isinf(lo) || isinf(hi)) return isinf(lo) ? hi : lo;
    return fabs(algsurf_i_compensated(p->c, NULL, p->degree, lo).value) <=
                   fabs(algsurf_i_compensated(p->c, NULL, p->degree, hi).value)
               ? lo
               : hi;
}

/* From a bracket to neighbouring doubles; 0 when there is no memory. */
static int narrow(const algsurf_i_coefficients *p, const algsurf_bracket *b, algsurf_real_root *root) {
    algsurf_refined_root found;
    if (algsurf_i_refine_bracket(p, b->lo, b->hi, &found) != ALGSURF_OK) return 0;
    double lo = found.lo, hi = found.hi, between;
    while ((between = algsurf_exact_between(lo, hi)) < hi) {
        int sign = algsurf_i_sign_at(p, between);
        if (sign == ALGSURF_SIGN_UNKNOWN) return 0;
        if (sign != -b->sign) lo = between;
        if (sign != b->sign) hi = between;
    }
    *root = (algsurf_real_root){nearer(p, lo, hi), lo, hi, 1, b->sign};
    return 1;
}

/* Side by side, where nothing can overflow; multiplicity 0: not known. */
void algsurf_i_settle(const algsurf_i_coefficients *p, const algsurf_bracket *b, int count,
                      algsurf_real_root *roots) {
    double most = ldexp(1, 400 / (p->degree > 0 ? p->degree : 1)), largest = 0;
    for (int k = 0; k <= p->degree; k++) largest = fmax(largest, fabs(p->c[k]));
    int fits = largest <= 0x1p401 && (count == 0 || (b[0].lo >= -most && b[count - 1].hi <= most));
    if (fits) algsurf_i_roots_settle_fastest()(p, b, count, roots);
    for (int i = 0; i < count && !fits; i++) roots[i].multiplicity = 0;
}

/* Where all roots are simple and doubles tell them apart: refined with certain signs. */
static int find_in_doubles(question *q, int first_only, int halvings, algsurf_real_root *roots, int *count) {
    algsurf_i_coefficients p = {q->c, NULL, q->degree};
    algsurf_bracket b[ALGSURF_MAX_DEGREE];
    if (p.degree > ALGSURF_MAX_DEGREE ||
        !algsurf_i_isolate_in_lane(&p, &q->lo, &q->hi, first_only, halvings, b, count))
        return 0;
    algsurf_i_settle(&p, b, *count, roots);
    for (int i = 0; i < *count; i++)
        if (!roots[i].multiplicity && !narrow(&p, b + i, roots + i)) return 0;
    return 1;
}

/* By integers: the first `capacity` roots. */
static algsurf_status decide_doubles(const question *q, algsurf_real_root *roots, int capacity, int *count) {
    const algsurf_i_coefficients p = {q->c, NULL, q->degree};
    algsurf_status status =
        algsurf_i_decide_roots(q->c, q->degree, q->lo, q->hi, roots, capacity, count, NULL);
    for (int i = 0; status == ALGSURF_OK && i < *count; i++)
        roots[i].root = nearer(&p, roots[i].lo, roots[i].hi);
    return status;
}

algsurf_status algsurf_i_first_root(const double *c, int degree, double lo, double hi,
                                    algsurf_real_root *root, int *count) {
    while (degree > 0 && c[degree] == 0) degree--;
    question q = {c, NULL, degree, lo, hi};
    if (find_in_doubles(&q, 1, algsurf_i_halvings_at_first(degree), root, count)) return ALGSURF_OK;
    return decide_doubles(&q, root, 1, count);
}

static algsurf_status find_in_part(const question *q, const algsurf_i_part *part, int patient,
                                   algsurf_real_root *roots, int *count) {
    const algsurf_i_coefficients p = {q->c, NULL, q->degree};
    const algsurf_bracket b = {.lo = part->lo, .hi = part->hi, .sign = part->sign};
    question here = *q;
    *count = 1;
    if (b.sign && narrow(&p, &b, roots)) return ALGSURF_OK;
    here.lo = part->lo;
    here.hi = part->hi;
    if (patient && find_in_doubles(&here, 0, ALGSURF_I_HALVINGS, roots, count)) return ALGSURF_OK;
    return decide_doubles(&here, roots, here.degree, count);
}

/* In doubles; else in the parts of the line that may have roots. */
static algsurf_status find_itself(question q, algsurf_real_root *roots, int *count) {
    if (!q.c)
        return algsurf_i_integers_in_doubles(q.z, q.degree, q.lo, q.hi, roots, count)
                   ? ALGSURF_OK
                   : algsurf_i_decide_integers(q.z, q.degree, q.lo, q.hi, roots, q.degree, count);
    while (q.c[q.degree] == 0) q.degree--;
    int halvings = algsurf_i_halvings_at_first(q.degree), found = 0;
    if (find_in_doubles(&q, 0, halvings, roots, count)) return ALGSURF_OK;
    algsurf_i_part parts[ALGSURF_I_PARTS];
    int n = algsurf_i_parts_of(&(algsurf_i_coefficients){q.c, NULL, q.degree}, q.lo, q.hi, parts, NULL);
    *count = 0;
    for (int i = 0; i < n; i++, *count += found) {
        algsurf_status status =
            find_in_part(&q, parts + i, halvings < ALGSURF_I_HALVINGS, roots + *count, &found);
        if (status != ALGSURF_OK) return status;
    }
    return ALGSURF_OK;
}

/* Roots of q in p(t) = t^m q(t^k) become those of p; returns 0 where that will not do.  Ends of q's that are
 * neighbours are near in proportion only where they are normal numbers: p's may still have doubles between.
 */
static ALGSURF_NOINLINE int from_power(const algsurf_i_power *w, const algsurf_i_coefficients *p, double lo,
                                       double hi, algsurf_real_root *roots, int *count) {
    algsurf_bracket b[ALGSURF_MAX_POLY_DEGREE];
    for (int i = 0; i < *count; i++)
        b[i] = (algsurf_bracket){.lo = roots[i].lo,
                                 .hi = roots[i].hi,
                                 .sign = roots[i].sign,
                                 .multiplicity = roots[i].multiplicity};
    if (!algsurf_i_power_roots(w, p->c, lo, hi, b, count)) return 0;
    for (int i = 0; i < *count; i++) {
        int multiplicity = b[i].multiplicity, final = !(algsurf_exact_between(b[i].lo, b[i].hi) < b[i].hi);
        roots[i] = (algsurf_real_root){nearer(p, b[i].lo, b[i].hi), b[i].lo, b[i].hi, 1, b[i].sign};
        if (!final && !narrow(p, b + i, roots + i)) return 0;
        roots[i].multiplicity = multiplicity;
    }
    return 1;
}

/* By the roots of a polynomial of lower degree; returns 0 where that will not do. */
static int find_by_power(const question *q, algsurf_real_root *roots, int *count) {
    algsurf_i_coefficients p = {q->c, NULL, q->degree};
    algsurf_i_power w;
    while (p.c[p.degree] == 0) p.degree--;
    if (!algsurf_i_power_of(p.c, p.degree, &w)) return 0;
    question inner = {w.q, NULL, w.degree, 0, 0};
    algsurf_i_power_interval(&w, q->lo, q->hi, &inner.lo, &inner.hi);
    *count = 0;
    if (w.degree > 0 && find_itself(inner, roots, count) != ALGSURF_OK) return 0;
    return from_power(&w, &p, q->lo, q->hi, roots, count);
}

/* Room for as many roots as the degree says. */
static algsurf_status find(const question *q, algsurf_real_root *roots, int *count) {
    algsurf_status status = q->c ? check_doubles(q) : check_integers(q);
    if (status == ALGSURF_OK && !(q->c && find_by_power(q, roots, count)))
        status = find_itself(*q, roots, count);
    return status;
}

algsurf_status algsurf_i_real_roots(const double *c, int degree, double lo, double hi,
                                    algsurf_real_root *roots, int *count) {
    const question q = {c, NULL, degree, lo, hi};
    return find(&q, roots, count);
}

static ALGSURF_NOINLINE algsurf_status find_some(const question *q, algsurf_real_root *roots, int capacity,
                                                 int *count) {
    algsurf_real_root found[ALGSURF_MAX_POLY_DEGREE];
    int n = 0;
    if ((!q->c && !q->z) || q->degree < 0 || q->degree > ALGSURF_MAX_POLY_DEGREE || !(q->lo <= q->hi))
        return ALGSURF_E_ARGUMENT;
    algsurf_status status = find(q, found, &n);
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
    algsurf_status status = find_some(q, roots, capacity, count);
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
