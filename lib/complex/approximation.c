/* approximation.c - Newton's method for a root together with its deflated polynomial.
 *
 * The system and its solution are in papers.h.  The defect is summed in doubled precision, which makes
 * a step an iterative refinement: at a simple root z and q end within an ulp or two of the exact ones,
 * however ill-conditioned the root, as long as the iteration converges at all.  The unit follows z, so that
 * no power of z overflows.
 */
#include "../base/arithmetic.h"
#include <float.h>

#include "papers.h"
#include "scaled.h"
#include "../base/fpenv.h"
#include "../base/options.h"
#include "../poly/value.h"

#define UNIT_LIMIT 1100 /* beyond it z is 0 or infinite as a double */

algsurf_status algsurf_i_paper_check(const algsurf_complex *p, const double *r, int degree,
                                     const algsurf_paper_options *given, algsurf_paper_options *options) {
    algsurf_paper_options o = {sizeof o, 0, 0, 0};
    if (!p || degree == 0) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_polynomial(&p->re, 2, r, degree);
    if (status != ALGSURF_OK) return status;
    if (given && algsurf_options_read(&o, sizeof o, given) != ALGSURF_OK) return ALGSURF_E_SIZE;
    if (!isfinite(o.relative_step)) return ALGSURF_E_NOT_FINITE;
    if (o.relative_step < 0 || o.max_steps < 0 || o.max_inflations < 0) return ALGSURF_E_ARGUMENT;
    if (o.relative_step == 0) o.relative_step = 1e-10;
    if (o.max_steps == 0) o.max_steps = 50;
    if (o.max_inflations == 0) o.max_inflations = 10;
    *options = o;
    return ALGSURF_OK;
}

int algsurf_i_unit_near(const algsurf_complex *p, int n, algsurf_complex z) {
    int low = 0;
    if (algsurf_i_size(z) > 0) return ilogb(algsurf_i_size(z));
    while (algsurf_i_size(p[low]) == 0) low++;
    return low == n ? 0 : (ilogb(algsurf_i_size(p[low])) - ilogb(algsurf_i_size(p[n]))) / (n - low);
}

int algsurf_i_exponent_in(const algsurf_complex *p, int n, int unit) {
    int most = ilogb(algsurf_i_size(p[n])) + n * unit;
    for (int k = 0; k < n; k++) {
        if (algsurf_i_size(p[k]) == 0) continue;
        int e = ilogb(algsurf_i_size(p[k])) + k * unit;
        if (e > most) most = e;
    }
    return most;
}

/* a / b, without squaring b (Smith 1962). */
static algsurf_complex quotient(algsurf_complex a, algsurf_complex b) {
    if (fabs(b.re) >= fabs(b.im)) {
        double ratio = b.im / b.re, whole = b.re + b.im * ratio;
        return (algsurf_complex){(a.re + a.im * ratio) / whole, (a.im - a.re * ratio) / whole};
    }
    double ratio = b.re / b.im, whole = b.re * ratio + b.im;
    return (algsurf_complex){(a.re * ratio + a.im) / whole, (a.im * ratio - a.re) / whole};
}

/* ---- the iteration ---- */

typedef struct iteration {
    const algsurf_complex *p;
    int n, unit, exponent;
    algsurf_complex y;                              /* z 2^-unit */
    algsurf_complex c[ALGSURF_MAX_POLY_DEGREE + 1]; /* p in this unit */
    algsurf_complex q[ALGSURF_MAX_POLY_DEGREE];     /* q in this unit */
    algsurf_complex s[ALGSURF_MAX_POLY_DEGREE], w[ALGSURF_MAX_POLY_DEGREE];
} iteration;

static void take_unit(iteration *it, int unit) {
    it->unit = unit;
    it->exponent = algsurf_i_exponent_in(it->p, it->n, unit);
    for (int k = 0; k <= it->n; k++) it->c[k] = algsurf_i_shift(it->p[k], k * unit - it->exponent);
}

static void begin(iteration *it, algsurf_complex start) {
    take_unit(it, algsurf_i_unit_near(it->p, it->n, start));
    it->y = algsurf_i_shift(start, -it->unit);
    it->q[it->n - 1] = it->c[it->n];
    for (int i = it->n - 1; i > 0; i--) it->q[i - 1] = plus(it->c[i], product(it->y, it->q[i]));
}

/* Brings y back to about 1; 0 when z has left the range of double. */
static int follow(iteration *it) {
    double size = algsurf_i_size(it->y);
    if (size == 0 || (size >= 0.5 && size < 2)) return 1;
    int more = ilogb(size), before = it->exponent, unit = it->unit + more;
    if (unit > UNIT_LIMIT) return 0;
    if (unit < -UNIT_LIMIT) {
        it->y = (algsurf_complex){0, 0};
        return 1;
    }
    take_unit(it, unit);
    it->y = algsurf_i_shift(it->y, -more);
    for (int i = 0; i < it->n - 1; i++)
        it->q[i] = algsurf_i_shift(it->q[i], (i + 1) * more + before - it->exponent);
    it->q[it->n - 1] = it->c[it->n];
    return 1;
}

static double rounded(algsurf_i_defect d) {
    return d.high + (((d.low[0] + d.low[1]) + (d.low[2] + d.low[3])) + d.low[4]);
}

/* s_i = S_i, w_i = w_i */
static void eliminate(iteration *it) {
    const algsurf_complex zero = {0, 0}, y = it->y;
    algsurf_complex s = zero, w = zero;
    for (int i = it->n - 1; i >= 0; i--) {
        algsurf_complex a = i > 0 ? it->q[i - 1] : zero, b = it->q[i];
        algsurf_complex d = {rounded(algsurf_i_defect_part(a.re, y.re, b.re, -y.im, b.im, it->c[i].re)),
                             rounded(algsurf_i_defect_part(a.im, y.re, b.im, y.im, b.re, it->c[i].im))};
        it->s[i] = s = plus(d, product(y, s));
        it->w[i] = w = plus(b, product(y, w));
    }
}

typedef enum outcome { FAILED = -1, GOING_ON, CONVERGED } outcome;

/* One step, if it is finite; else, as when w_0 is 0 and t no number, nothing changes. */
static outcome step(iteration *it, double epsilon) {
    double change = 0, size = algsurf_i_size(it->q[it->n - 1]);
    eliminate(it);
    algsurf_complex t = quotient(it->s[0], it->w[0]), y = plus(it->y, t);
    for (int i = 0; i < it->n - 1; i++) {
        algsurf_complex s = it->s[i + 1], d = plus((algsurf_complex){-s.re, -s.im}, product(t, it->w[i + 1]));
        it->s[i] = plus(it->q[i], d);
        if (!algsurf_i_finite(it->s[i])) return FAILED;
        change = fmax(change, algsurf_i_size(d));
        size = fmax(size, algsurf_i_size(it->s[i]));
    }
    for (int i = 0; i < it->n - 1; i++) it->q[i] = it->s[i];
    it->y = y;
    int settled = algsurf_i_size(t) <= epsilon * algsurf_i_size(y) && change <= epsilon * size;
    return !follow(it) ? FAILED : settled ? CONVERGED : GOING_ON;
}

/* z 2^k; what exceeds the range of double, or is no number, becomes the largest double. */
static algsurf_complex held(algsurf_complex z, int k) {
    z = algsurf_i_shift(z, k);
    return (algsurf_complex){fmax(fmin(z.re, DBL_MAX), -DBL_MAX), fmax(fmin(z.im, DBL_MAX), -DBL_MAX)};
}

/* q in the caller's unit.  What is lost in that of a tiny z is what Horner's scheme gives: rounded alone, as
 * z changes it little. */
static void give_quotient(const iteration *it, algsurf_complex z, algsurf_complex *q) {
    q[it->n - 1] = it->p[it->n];
    for (int i = it->n - 2; i >= 0; i--) {
        const int shift = it->exponent - (i + 1) * it->unit;
        if (shift > 800 && algsurf_i_size(it->q[i]) < 0x1p-900)
            q[i] = held(plus(it->p[i + 1], product(z, q[i + 1])), 0);
        else
            q[i] = held(it->q[i], shift);
    }
}

algsurf_status algsurf_i_paper_approximation(const algsurf_complex *p, int n, algsurf_complex start,
                                             const algsurf_paper_options *options, algsurf_complex *z,
                                             algsurf_complex *q, int *steps) {
    iteration it;
    outcome last = GOING_ON;
    int count = 0;
    it.p = p;
    it.n = n;
    begin(&it, n > 1 ? start : (algsurf_complex){0, 0}); /* degree 1: the first step hits from anywhere */
    while (count < options->max_steps && last == GOING_ON) {
        last = step(&it, options->relative_step);
        count += last != FAILED;
    }
    *z = held(it.y, it.unit);
    give_quotient(&it, *z, q);
    *steps = count;
    return last == CONVERGED && algsurf_i_finite(algsurf_i_shift(it.y, it.unit)) ? ALGSURF_OK
                                                                                 : ALGSURF_NOT_CONVERGED;
}

/* ---- the public call ---- */

ALGSURF_I_ENTRY(algsurf_status, paper_approximation,
                (const algsurf_complex *p, int degree, algsurf_complex start,
                 const algsurf_paper_options *given, algsurf_complex *z, algsurf_complex *q, int *steps),
                (p, degree, start, given, z, q, steps)) {
    algsurf_paper_options options;
    algsurf_complex found[ALGSURF_MAX_POLY_DEGREE];
    int count;
    algsurf_status status = algsurf_i_paper_check(p, NULL, degree, given, &options);
    if (status != ALGSURF_OK) return status;
    if (!algsurf_i_finite(start)) return ALGSURF_E_NOT_FINITE;
    if (!z || !q || algsurf_i_size(p[degree]) == 0) return ALGSURF_E_ARGUMENT;
    status = algsurf_i_paper_approximation(p, degree, start, &options, z, found, &count);
    for (int i = 0; i < degree; i++) q[i] = found[i];
    if (steps) *steps = count;
    return status;
}
