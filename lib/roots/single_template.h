/* single_template.h - all roots of one polynomial: the walk of first_walk_template.h in one lane, again and
 * again from the last bracket's end.  (Packets of two: a lone double is no faster.)
 *
 * About the middle m of the interval, in units of half its length h, the polynomial is sum d_k v^k, as in
 * centred_template.h.  With x = (1+v)/2 and y = 1 - x, v = x - y and 1 = x + y, so that Horner's rule in x
 * and y, B <- B (x - y) + d_k (x + y)^(n-k), ends with C(n,j) b_j: no matrix is needed.
 *
 * Error.  Let M = max(|lo|, |hi|), S = sum |c_k| M^k.  The sizes of all that is added to a coefficient b_j
 * are at most S together.  The shift costs n + 1 sums, and for each factor m a product and m's own rounding,
 * for each factor h as much: 3n + 1.  Horner's rule costs two sums in each of n steps, a product, a binomial
 * and the division: 2n + 4.  So b_j is off by (5n + 5) u S; the bound (7n + 16) u S takes in the higher
 * orders and the rounding of S.  Numbers that are out of range are scaled first: M to at most 1, the largest
 * c_k M^k to about 1; what underflow changes then is below 2^-900.  Those in range have S and M^n within
 * 2^+-300, so that nothing is above 2^600 on the way, and what underflow changes is below 2^-700, hence below
 * 2^-300 u S.
 *
 * Ends of brackets.  The end of a cell is lo + (hi - lo) p, p a multiple of 2^-40.  Where that is a double,
 * the walk knows the sign there.  Elsewhere a double nearby is taken, left of either end by more than its
 * rounding, and the sign there is computed anew, with certainty.  A left end may lie where no root is,
 * between the bracket before and the cell; a right end within the cell, with the sign of its right end, has
 * the root to its left. */
#ifndef ALGSURF_SINGLE_TEMPLATE_H
#define ALGSURF_SINGLE_TEMPLATE_H
#define KNOWN_DEGREES 1
#include "../base/eft.h"
#include "coefficients.h"
#include "polys.h"
#include "first_walk_template.h"

/* One polynomial over [0,1], and where it came from. */
typedef struct single {
    const algsurf_i_coefficients *p;
    double lo, hi;
    double b[ALGSURF_MAX_DEGREE + 1], error;
} single;

/* d_k before the shift: c_k, or scaled; returns S, and the same sum over the radii. */
static double scale_coefficients(const single *s, int unit, int common, double most, double *d,
                                 double *spread) {
    const algsurf_i_coefficients *p = s->p;
    double size = 0;
    *spread = 0;
    for (int k = p->degree; k >= 0; k--) {
        int e = k * unit - common;
        d[k] = e == 0 ? p->c[k] : ldexp(p->c[k], e);
        size = size * most + fabs(d[k]);
        if (p->r) *spread = *spread * most + ldexp(p->r[k], e);
    }
    return size;
}

/* d_k of the head comment; returns S, and the same sum over the radii. */
static double shift_to_middle(const single *s, double *d, double *spread) {
    int n = s->p->degree, unit = 0;
    double lo = s->lo, hi = s->hi, most = fmax(fabs(lo), fabs(hi));
    double size = scale_coefficients(s, 0, 0, most, d, spread);
    if (!(most > 0x1p-4 && most < 0x1p4 && size > 0x1p-300 && size < 0x1p300)) {
        (void)frexp(most, &unit);
        lo = ldexp(lo, -unit), hi = ldexp(hi, -unit), most = ldexp(most, -unit);
        size = scale_coefficients(s, unit, algsurf_i_common_exponent(s->p, unit), most, d, spread);
    }
    double m = 0.5 * lo + 0.5 * hi, h = 0.5 * hi - 0.5 * lo, power = 1;
    for (int i = 0; i < n && m != 0; i++)
        for (int k = n - 1; k >= i; k--) d[k] += m * d[k + 1];
    for (int k = 1; k <= n; k++) {
        power *= h;
        d[k] *= power;
    }
    return size;
}

static void middle_to_bernstein(const double *d, int n, double *b) {
    double binomial[ALGSURF_MAX_DEGREE + 2] = {1};
    b[0] = d[n];
    for (int g = 1; g <= n; g++) { /* binomial: C(g,j) */
        binomial[g] = b[g] = 0;
        for (int j = g; j > 0; j--) {
            binomial[j] += binomial[j - 1];
            b[j] = (b[j - 1] - b[j]) + d[n - g] * binomial[j];
        }
        b[0] = d[n - g] - b[0];
    }
    for (int j = 1; j < n; j++) b[j] /= binomial[j];
}

static void set_single(single *s) {
    double d[ALGSURF_MAX_DEGREE + 1], spread;
    int n = s->p->degree;
    double size = shift_to_middle(s, d, &spread);
    middle_to_bernstein(d, n, s->b);
    s->error = (1 + 0x1p-40) * spread + (7 * n + 16) * 0x1p-53 * size + 0x1p-900;
}

/* lo + (hi - lo) at, if that is a double. */
static int is_double(const single *s, double at, double *x) {
    double width = s->hi - s->lo;
    algsurf_dd part = algsurf_two_prod(width, at), sum = algsurf_two_sum(s->lo, part.hi);
    *x = sum.hi;
    return width + s->lo == s->hi && s->hi - width == s->lo && fabs(part.hi) >= 0x1p-969 && part.lo == 0 &&
           sum.lo == 0;
}

/* Sets an end of a bracket where the sign is known; returns whether there is one. */
static int set_end(const single *s, double at, double least, int sign, double *end) {
    if (is_double(s, at, end) && *end >= least) return 1;
    *end = fmax(*end - 0x1p-50 * fmax(fabs(s->lo), fabs(s->hi)), least);
    return *end <= s->hi && algsurf_i_sign_at(s->p, *end) == sign;
}

static int set_bracket(const single *s, const packet *k, double least, algsurf_bracket *b) {
    int sign = k->at.side[0] ? -1 : 1;
    *b = (algsurf_bracket){s->lo, s->hi, ALGSURF_BRACKET_ISOLATED, sign, 1, ALGSURF_OK};
    if (k->at.p[0] > 0 && !set_end(s, k->at.p[0], least, sign, &b->lo)) return 0;
    if (k->at.q[0] < 1 && !set_end(s, k->at.q[0], b->lo, -sign, &b->hi)) return 0;
    return b->lo < b->hi;
}

int KERNEL(algsurf_i_roots_single)(const algsurf_i_coefficients *p, double lo, double hi, int most,
                                   algsurf_bracket *b, int *count, const algsurf_i_watch *watch) {
    single s = {.p = p, .lo = lo, .hi = hi};
    algsurf_i_watch here;
    packet k;
    int n = p->degree;
    if (n < 1 || n > ALGSURF_MAX_DEGREE) __builtin_unreachable();
    *count = 0;
    set_single(&s);
    k.watch = NULL;
    if (watch) {
        here = *watch;
        here.lo = lo, here.hi = hi;
        k.watch = &here;
    }
    k.open = less(numbered(), all_lanes(1));
    k.undecided = no_lane();
    k.start = all_lanes(-1);
    k.stop = all_lanes(2);
    k.blur = all_lanes(0);
    for (int j = 0; j <= n; j++) {
        k.b[j] = all_lanes(s.b[j]);
        k.e[j] = all_lanes(s.error);
    }
    begin(&k, n, 1);
    if (watch) tell_cell(k.watch, 0, 1, k.at.w, k.at.e, n, 1, k.at.side[0] != 0);
    bound_errors(&k, n, 1);
    leave_undecided(&k, ~ends_known(k.b, k.e, n, 1, all_lanes(0)));
    for (;;) {
        isolate_known(&k, n);
        if (any(k.undecided)) return 0;
        if (!any(k.hit)) return 1;
        if (!set_bracket(&s, &k, *count ? b[*count - 1].hi : lo, b + *count)) return 0;
        if (++*count == most || k.at.q[0] >= 1) return 1;
        next(&k, n, k.at.q);
    }
}

#endif
