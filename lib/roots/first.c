/* first.c - many polynomials: checked, solved side by side, and what stays in doubt one by one.
 *
 * The packet code (first_template.h) writes the answers it is sure of, and ALGSURF_LANE_DOUBTFUL as state of
 * the others.  Those are isolated alone, and refined in double-double: they are the ill-conditioned ones. */
#include "algsurf/packet.h"

#include <math.h>
#include <string.h>

#include "algsurf/isolate.h"
#include "../base/fpenv.h"
#include "isolate_impl.h"
#include "kernel.h"
#include "../base/options.h"
#include "refine_dd.h"

typedef struct query {
    algsurf_poly_packet polys;
    algsurf_first_roots_options options;
    const algsurf_i_roots_kernel *kernel;
} query;

static algsurf_status check_one(const algsurf_poly_packet *p, size_t i) {
    if (!isfinite(p->lo[i]) || !isfinite(p->hi[i])) return ALGSURF_E_NOT_FINITE;
    if (!(p->lo[i] < p->hi[i])) return ALGSURF_E_ARGUMENT;
    for (int k = 0; k <= p->degree; k++) {
        if (!isfinite(p->c[k][i]) || (p->r && !isfinite(p->r[k][i]))) return ALGSURF_E_NOT_FINITE;
        if (p->r && p->r[k][i] < 0) return ALGSURF_E_ARGUMENT;
    }
    return ALGSURF_OK;
}

static algsurf_status check_shape(const algsurf_poly_packet *p) {
    if (p->degree < 0 || p->degree > ALGSURF_MAX_POLY_DEGREE) return ALGSURF_E_ARGUMENT;
    if (p->count == 0) return ALGSURF_OK;
    if (!p->c || !p->lo || !p->hi) return ALGSURF_E_ARGUMENT;
    for (int k = 0; k <= p->degree; k++)
        if (!p->c[k] || (p->r && !p->r[k])) return ALGSURF_E_ARGUMENT;
    return ALGSURF_OK;
}

static algsurf_status prepare(query *q, const algsurf_poly_packet *packet,
                              const algsurf_first_roots_options *options) {
    q->options = (algsurf_first_roots_options){.size = sizeof q->options};
    if (!packet || !algsurf_options_read(&q->polys, sizeof q->polys, packet)) return ALGSURF_E_ARGUMENT;
    if (options && !algsurf_options_read(&q->options, sizeof q->options, options)) return ALGSURF_E_ARGUMENT;
    if (!(q->options.tolerance >= 0 && q->options.tolerance < 1)) return ALGSURF_E_ARGUMENT;
    const algsurf_i_kernel *kernel = algsurf_i_kernel_find(q->options.kernel);
    if (!kernel) return ALGSURF_E_ARGUMENT;
    q->kernel = algsurf_i_roots_kernel_for(kernel);
    return check_shape(&q->polys);
}

/* Coefficient k of v^k over [-1,1] in the Bernstein basis of degree n at j (n+1) + k: that of x^k in
 * (1+x)^j (1-x)^(n-j) over C(n,k), the numbers of ways to choose k ends of n.  All but the quotient is exact.
 */
static void set_basis(double *basis, int n) {
    double binomial[ALGSURF_MAX_POLYS_DEGREE + 1] = {1}, g[ALGSURF_MAX_POLYS_DEGREE + 1] = {1};
    for (int k = 1; k <= n; k++) {
        binomial[k] = binomial[k - 1] * (n - k + 1) / k;
        g[k] = k % 2 ? -binomial[k] : binomial[k];
    }
    for (int j = 0; j <= n; j++) {
        for (int k = 0; k <= n; k++) basis[j * (n + 1) + k] = g[k] / binomial[k];
        for (int k = 1; k <= n; k++) g[k] += g[k - 1]; /* g / (1-x) */
        for (int k = n; k >= 1; k--) g[k] += g[k - 1]; /* g (1+x) */
    }
}

/* ---- one polynomial alone ----
 *
 * Values are computed in a unit in which the point is in [1/2,2] and the largest coefficient about 1.  The
 * largest term is then above 2^-513, up to degree 512, and what underflow takes from the others, 2^-1074
 * each, is nothing to double-double.  In the unit of a bracket that is wider than its root is large, all of
 * the value may underflow, as that of t^29 + 2 t^28 - 1 near -2 does in units of 2^100. */

static void set_unit(const algsurf_i_coefficients *p, int unit, algsurf_dd *c) {
    int common = algsurf_i_common_exponent(p, 0, unit);
    for (int k = 0; k <= p->degree; k++) c[k] = algsurf_dd_from(ldexp(p->c[k], k * unit - common));
}

static int sign_near(const algsurf_i_coefficients *p, double x, algsurf_dd *c) {
    if (x == 0) return (p->c[0] > 0) - (p->c[0] < 0);
    int unit = ilogb(x);
    set_unit(p, unit, c);
    return algsurf_i_sign_dd(c, p->degree, algsurf_dd_from(ldexp(x, -unit)));
}

/* The largest e with 2^e <= |x| for all x in the bracket; one less than that of any double if 0 is in it. */
static int least_exponent(const algsurf_bracket *b) {
    double least = fmin(fabs(b->lo), fabs(b->hi));
    return least > 0 ? ilogb(least) : -1075;
}

/* Where to part a bracket: at 0 if its ends have different signs, at the power of two in the middle of its
 * exponents if these differ by more than 1; else at an end, that is, not at all. */
static double parting(const algsurf_bracket *b) {
    if (b->lo < 0 && b->hi > 0) return 0;
    int from = least_exponent(b), to = ilogb(fmax(fabs(b->lo), fabs(b->hi)));
    return to > from + 1 ? copysign(ldexp(1, from + (to - from) / 2), b->lo < 0 ? -1 : 1) : b->lo;
}

/* A bracket's root: first its order of magnitude, in at most 13 steps, then all of it. */
static double refine_alone(const algsurf_i_coefficients *p, algsurf_bracket b) {
    algsurf_dd c[ALGSURF_MAX_POLY_DEGREE + 1];
    for (double x = parting(&b); b.lo < x && x < b.hi; x = parting(&b)) {
        int sign = sign_near(p, x, c);
        if (sign == 0) return x;
        *(sign == b.sign ? &b.lo : &b.hi) = x;
    }
    int unit = least_exponent(&b) + 1;
    set_unit(p, unit, c);
    algsurf_dd lo = algsurf_dd_from(ldexp(b.lo, -unit)), hi = algsurf_dd_from(ldexp(b.hi, -unit));
    double root = ldexp(algsurf_i_refine_dd(c, p->degree, lo, hi, b.sign).hi, unit);
    return fmin(fmax(root, b.lo), b.hi);
}

static void solve_alone(const algsurf_poly_packet *polys, size_t i, unsigned char *state, double *root) {
    double c[ALGSURF_MAX_POLY_DEGREE + 1], r[ALGSURF_MAX_POLY_DEGREE + 1], where = HUGE_VAL;
    algsurf_i_coefficients p = {c, polys->r ? r : NULL, polys->degree, 0};
    algsurf_bracket bracket;
    int found = 0;
    for (int k = 0; k <= p.degree; k++) {
        c[k] = polys->c[k][i];
        r[k] = polys->r ? polys->r[k][i] : 0;
    }
    algsurf_status status =
        algsurf_isolate_first(c, p.r, p.degree, polys->lo[i], polys->hi[i], &bracket, &found);
    if (status == ALGSURF_OK) {
        state[i] = found ? ALGSURF_FIRST_ROOT_FOUND : ALGSURF_FIRST_ROOT_NONE;
        if (root && found)
            where = bracket.kind == ALGSURF_ROOT_EXACT ? bracket.lo : refine_alone(&p, bracket);
    } else {
        state[i] = ALGSURF_FIRST_ROOT_UNCERTAIN;
        where = status == ALGSURF_E_ZERO ? polys->lo[i] : 0.5 * bracket.lo + 0.5 * bracket.hi;
    }
    if (root) root[i] = where;
}

static ALGSURF_NOINLINE algsurf_status run(const algsurf_poly_packet *packet,
                                           const algsurf_first_roots_options *options, unsigned char *state,
                                           double *root) {
    query q;
    double basis[(ALGSURF_MAX_POLYS_DEGREE + 1) * (ALGSURF_MAX_POLYS_DEGREE + 1)];
    algsurf_status status = prepare(&q, packet, options);
    size_t count = status == ALGSURF_OK ? q.polys.count : 0;
    if (count == 0) return status;
    if (!state) return ALGSURF_E_ARGUMENT;
    const algsurf_poly_packet *p = &q.polys;
    const algsurf_i_polys_job job = {p->c,  p->r,  p->lo, p->hi, p->degree, q.options.tolerance,
                                     basis, state, root};
    if (!q.kernel->good(&job, count))
        for (size_t i = 0; i < count; i++)
            if ((status = check_one(p, i)) != ALGSURF_OK) return status;
    if (p->degree >= 1 && p->degree <= ALGSURF_MAX_POLYS_DEGREE) {
        if (p->degree > 2) set_basis(basis, p->degree);
        q.kernel->solve(&job, count);
    } else {
        memset(state, ALGSURF_LANE_DOUBTFUL, count);
    }
    const unsigned char *doubtful = state;
    while ((doubtful = memchr(doubtful, ALGSURF_LANE_DOUBTFUL, (size_t)(state + count - doubtful)))) {
        solve_alone(p, (size_t)(doubtful - state), state, root);
        doubtful++;
    }
    return ALGSURF_OK;
}

algsurf_status algsurf_first_roots(const algsurf_poly_packet *packet,
                                   const algsurf_first_roots_options *options, unsigned char *state,
                                   double *root) {
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = run(packet, options, state, root);
    algsurf_fpenv_leave(&saved);
    return status;
}
