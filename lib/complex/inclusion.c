/* inclusion.c - the interval iteration: proof that a root and its quotient are near their
 * approximation.
 *
 * With the system of papers.h, (q + D, z + t) is a solution iff (D,t) is a fixed point of
 *     G(D,t) = J^-1 (-d + t (D;0)),
 * d and J taken at the approximation.  Y encloses G(X) for a box X of corrections:
 *     Y = Y0 + v_{i+1} - r w_{i+1},   Y_t = Y0_t - r,   r = v_0 / w_0,
 *     v_i = X_t X_i + z v_{i+1},   v_{n-1} = 0,
 * where Y0 = J^-1 (-d).  If Y lies inside X, then G maps Y into itself, and Brouwer's theorem gives a fixed
 * point in Y.  J is regular because 0 is not in the enclosure of w_0.  X is any box at all; a good one is the
 * last Y, inflated (Rump's epsilon inflation); the schedule grows because the quadratic term may ask for more
 * room.
 *
 * Radii, and what scaling by powers of two loses among subnormals, widen d and the leading coefficient: every
 * polynomial of the set has its own d and J in the intervals, and the proof goes through for each.
 */
#include "../base/arithmetic.h"
#include "papers.h"
#include "../base/fpenv.h"
#include "../poly/interval_impl.h"

#define LARGEST_Q 0x1p600       /* in units where p is about 1: more is no approximation */
#define ROOM_AT_POINTS 0x1p-51  /* relative: a point is never inside itself, */
#define SMALLEST_ROOM 0x1p-1000 /* nor is 0; well above what rounds to subnormals */

typedef struct proof {
    int n, unit, exponent;
    algsurf_complex y;                          /* z 2^-unit */
    algsurf_complex q[ALGSURF_MAX_POLY_DEGREE]; /* in this unit, as all that follows */
    algsurf_cinterval lead;
    algsurf_cinterval w[ALGSURF_MAX_POLY_DEGREE];
    algsurf_cinterval start[ALGSURF_MAX_POLY_DEGREE]; /* Y0_0..Y0_{n-2}, Y0_t */
    algsurf_cinterval box[ALGSURF_MAX_POLY_DEGREE];   /* Y, likewise */
    algsurf_cinterval v[ALGSURF_MAX_POLY_DEGREE];
} proof;

/* A coefficient in units: all of the set are within `radius` of `value` in each part. */
typedef struct coefficient {
    algsurf_complex value;
    double radius;
} coefficient;

static coefficient scaled(const algsurf_complex *p, const double *r, int k, int shift) {
    coefficient c = {algsurf_i_shift(p[k], shift), r ? algsurf_i_scale_up(r[k], shift) : 0};
    algsurf_complex back = algsurf_i_shift(c.value, -shift);
    if (back.re != p[k].re || back.im != p[k].im) c.radius = algsurf_i_add_up(c.radius, 0x1p-1074);
    return c;
}

static algsurf_interval around(double x, double radius) {
    return (algsurf_interval){algsurf_i_add_down(x, -radius), algsurf_i_add_up(x, radius)};
}

static algsurf_cinterval caround(algsurf_complex z, double radius) {
    return (algsurf_cinterval){around(z.re, radius), around(z.im, radius)};
}

static algsurf_interval enclosed(algsurf_i_defect d, double radius) {
    algsurf_interval sum = around(0, algsurf_i_add_up(radius, d.lost));
    for (int k = 0; k < 5; k++) sum = algsurf_i_interval_add(sum, algsurf_i_interval_point(d.low[k]));
    return algsurf_i_interval_add(sum, algsurf_i_interval_point(d.high));
}

/* d_i at the point; the leading coefficient's radius is not in it yet. */
static algsurf_cinterval defect(const proof *f, int i, coefficient c) {
    algsurf_complex a = i > 0 ? f->q[i - 1] : (algsurf_complex){0, 0}, b = f->q[i], y = f->y;
    return (algsurf_cinterval){
        enclosed(algsurf_i_defect_part(a.re, y.re, b.re, -y.im, b.im, c.value.re), c.radius),
        enclosed(algsurf_i_defect_part(a.im, y.re, b.im, y.im, b.re, c.value.im), c.radius)};
}

/* Scales everything; 0 when q cannot be meant. */
static int begin(proof *f, const algsurf_complex *p, const double *r, int n, algsurf_complex z,
                 const algsurf_complex *q) {
    f->n = n;
    f->unit = algsurf_i_unit_near(p, n, z);
    f->exponent = algsurf_i_exponent_in(p, n, f->unit);
    f->y = algsurf_i_shift(z, -f->unit);
    for (int i = 0; i < n - 1; i++) {
        f->q[i] = algsurf_i_shift(q[i], (i + 1) * f->unit - f->exponent);
        if (!(algsurf_i_size(f->q[i]) < LARGEST_Q)) return 0;
    }
    coefficient c = scaled(p, r, n, n * f->unit - f->exponent);
    f->q[n - 1] = c.value;
    f->lead = caround(c.value, c.radius);
    return 1;
}

/* w and, in place of S, Y0; 0 when w_0 may be 0. */
static int solve_linear(proof *f, const algsurf_complex *p, const double *r) {
    int n = f->n;
    algsurf_cinterval y = algsurf_i_cinterval_point(f->y), *s = f->start;
    for (int i = n - 1; i >= 0; i--) {
        algsurf_cinterval d = defect(f, i, scaled(p, r, i, i * f->unit - f->exponent));
        if (i == n - 1) {
            algsurf_cinterval spread = algsurf_i_cinterval_sub(f->lead, algsurf_i_cinterval_point(f->q[i]));
            s[i] = algsurf_i_cinterval_sub(d, algsurf_i_cinterval_mul(y, spread));
            f->w[i] = f->lead;
        } else {
            s[i] = algsurf_i_cinterval_add(d, algsurf_i_cinterval_mul(y, s[i + 1]));
            f->w[i] = algsurf_i_cinterval_add(algsurf_i_cinterval_point(f->q[i]),
                                              algsurf_i_cinterval_mul(y, f->w[i + 1]));
        }
    }
    if (algsurf_i_cinterval_has_zero(f->w[0])) return 0;
    algsurf_cinterval t = algsurf_i_cinterval_div(s[0], f->w[0]);
    for (int i = 0; i < n - 1; i++)
        s[i] = algsurf_i_cinterval_sub(algsurf_i_cinterval_mul(t, f->w[i + 1]), s[i + 1]);
    s[n - 1] = t;
    return 1;
}

static algsurf_interval inflated(algsurf_interval a, double factor) {
    double room = factor * (a.hi - a.lo) + ROOM_AT_POINTS * fmax(fabs(a.lo), fabs(a.hi)) + SMALLEST_ROOM;
    return (algsurf_interval){a.lo - room, a.hi + room};
}

static algsurf_cinterval cinflated(algsurf_cinterval a, double factor) {
    return (algsurf_cinterval){inflated(a.re, factor), inflated(a.im, factor)};
}

/* Bounded, and in the interior of what it was before, inflated. */
static int contracted(algsurf_cinterval now, algsurf_cinterval before, double factor) {
    algsurf_cinterval x = cinflated(before, factor);
    return isfinite(now.re.lo) && isfinite(now.re.hi) && isfinite(now.im.lo) && isfinite(now.im.hi) &&
           algsurf_i_interval_interior(now.re, x.re) && algsurf_i_interval_interior(now.im, x.im);
}

/* Y = G(X), X the inflated Y; 1 when Y lies inside X. */
static int iterate(proof *f, double factor) {
    int n = f->n, inside = 1;
    const algsurf_cinterval y = algsurf_i_cinterval_point(f->y), xt = cinflated(f->box[n - 1], factor);
    f->v[n - 1] = (algsurf_cinterval){{0, 0}, {0, 0}};
    for (int i = n - 2; i >= 0; i--)
        f->v[i] = algsurf_i_cinterval_add(algsurf_i_cinterval_mul(xt, cinflated(f->box[i], factor)),
                                          algsurf_i_cinterval_mul(y, f->v[i + 1]));
    algsurf_cinterval r = algsurf_i_cinterval_div(f->v[0], f->w[0]);
    for (int i = 0; i < n; i++) {
        algsurf_cinterval now =
            i == n - 1 ? algsurf_i_cinterval_sub(f->start[i], r)
                       : algsurf_i_cinterval_sub(algsurf_i_cinterval_add(f->start[i], f->v[i + 1]),
                                                 algsurf_i_cinterval_mul(r, f->w[i + 1]));
        inside = inside && contracted(now, f->box[i], factor);
        f->box[i] = now;
    }
    return inside;
}

static algsurf_cinterval quotient_in_unit(const proof *f, int i) {
    if (i == f->n - 1) return f->lead;
    return algsurf_i_cinterval_add(algsurf_i_cinterval_point(f->q[i]), f->box[i]);
}

/* p = (X - z) q has a second root in Z, or a double one, only where q vanishes in Z. */
static int alone(const proof *f, algsurf_cinterval Z) {
    algsurf_cinterval y = algsurf_i_cinterval_scale(Z, -f->unit), value = f->lead;
    for (int i = f->n - 2; i >= 0; i--)
        value = algsurf_i_cinterval_add(algsurf_i_cinterval_mul(value, y), quotient_in_unit(f, i));
    return !algsurf_i_cinterval_has_zero(value);
}

algsurf_status algsurf_i_paper_inclusion(const algsurf_complex *p, const double *r, int n, algsurf_complex z,
                                         const algsurf_complex *q, const algsurf_paper_options *options,
                                         algsurf_cinterval *Z, algsurf_cinterval *Q, int *unique,
                                         int *inflations) {
    static const double schedule[] = {0.1, 0.5, 5};
    proof f;
    int inside = 0, count = 0;
    if (begin(&f, p, r, n, z, q) && solve_linear(&f, p, r)) {
        for (int i = 0; i < n; i++) f.box[i] = f.start[i];
        for (; count < options->max_inflations && !inside; count++)
            inside = iterate(&f, schedule[count < 2 ? count : 2]);
    }
    *inflations = count;
    if (!inside) return ALGSURF_NOT_VERIFIED;
    *Z = algsurf_i_cinterval_scale(algsurf_i_cinterval_add(algsurf_i_cinterval_point(f.y), f.box[n - 1]),
                                   f.unit);
    if (unique) *unique = alone(&f, *Z);
    for (int i = 0; Q && i < n - 1; i++)
        Q[i] = algsurf_i_cinterval_scale(quotient_in_unit(&f, i), f.exponent - (i + 1) * f.unit);
    if (Q) Q[n - 1] = caround(p[n], r ? r[n] : 0);
    return ALGSURF_OK;
}

/* ---- the public call ---- */

ALGSURF_I_ENTRY(algsurf_status, paper_inclusion,
                (const algsurf_complex *p, const double *r, int degree, algsurf_complex z,
                 const algsurf_complex *q, const algsurf_paper_options *given, algsurf_cinterval *Z,
                 algsurf_cinterval *Q, int *unique, int *inflations),
                (p, r, degree, z, q, given, Z, Q, unique, inflations)) {
    algsurf_paper_options options;
    int count;
    algsurf_status status = algsurf_i_paper_check(p, r, degree, given, &options);
    if (status != ALGSURF_OK) return status;
    if (!q || !Z || algsurf_i_size(p[degree]) == 0) return ALGSURF_E_ARGUMENT;
    for (int i = 0; i < degree; i++)
        if (!algsurf_i_finite(q[i])) return ALGSURF_E_NOT_FINITE;
    if (!algsurf_i_finite(z)) return ALGSURF_E_NOT_FINITE;
    status = algsurf_i_paper_inclusion(p, r, degree, z, q, &options, Z, Q, unique, &count);
    if (inflations) *inflations = count;
    return status;
}
