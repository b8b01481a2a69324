/* scale.c - where on the line the roots of a polynomial can be, and in which units to look.
 *
 * Where coefficients differ by hundreds of orders of magnitude so do the roots, and no single unit
 * serves them all.  The upper convex hull of the points (k, log2 |c_k|) (Newton's polygon) gives the
 * magnitudes of the roots up to a factor of about the degree; they are gathered into groups, and each
 * group is looked for in its own unit.
 *
 * Between two groups, at the corner m of the hull that parts them, c_m x^m dominates: where
 * |c_m| x^m > sum over k != m of |c_k| x^k there is no root of magnitude x (Pellet 1881).  The ratio of the
 * two sides is convex in log x, so if it holds at both ends of an annulus it holds between them, and
 * the annulus is left out.
 */
#include <math.h>

#include "isolate_impl.h"
#include "../poly/hull.h"

#define GROUP_GAP 16 /* binary orders of magnitude between roots that part two groups */

int algsurf_i_common_exponent(const algsurf_i_coefficients *p, int first, int unit) {
    int common = -0x7fffffff;
    for (int k = first; k <= p->degree; k++) {
        double a = fmax(fabs(p->c[k]), p->r ? p->r[k] : 0);
        if (a > 0 && ilogb(a) + k * unit > common) common = ilogb(a) + k * unit;
    }
    return common;
}

/* log2 of the largest magnitude coefficient k may have, up to 1. */
static double height_of(const algsurf_i_coefficients *p, int k) {
    double r = p->r ? p->r[k] : 0, a = fmax(fabs(p->c[k]), r);
    return a > 0 ? log2(a) + (r > 0) : -HUGE_VAL;
}

/* Does c_m x^m dominate at x = 2^e?  A factor 2 to spare covers the rounding of the logarithms. */
static int dominates(const algsurf_i_coefficients *p, const double *height, int m, int e) {
    double r = p->r ? p->r[m] : 0, lead = fabs(p->c[m]) - r, rest = 0;
    if (!(lead > 0.5 * fabs(p->c[m]))) return 0;
    for (int k = p->zeros; k <= p->degree; k++)
        if (k != m) rest += exp2(height[k] - (log2(fabs(p->c[m])) - 1) + (double)(k - m) * e);
    return rest < 0.5;
}

/* Roots with magnitudes from inner to outer, looked for in units of 2^exponent. */
typedef struct group {
    int exponent;
    double inner, outer;
} group;

/* The border between a group and the next one, whose roots begin at 2^next: an annulus without roots about
 * corner m, or where there is none a single cut.  An end of the annulus that is no double is moved along it
 * to the least or the largest power of two: 2^from < 2^-1074 <= 2^to, or the like above, or else both are 0
 * or infinite, and one of the groups is looked for together with the other. */
static void part(const algsurf_i_coefficients *p, const double *height, int m, double last, double next,
                 group *g, group *h) {
    int from = (int)ceil(last), to = (int)floor(next);
    while (from < to && !dominates(p, height, m, from)) from++;
    while (to > from && !dominates(p, height, m, to)) to--;
    if (from < to) {
        double outer = ldexp(1, from), inner = ldexp(1, to);
        g->outer = fmax(outer, fmin(inner, 0x1p-1074));
        h->inner = fmin(inner, fmax(outer, 0x1p1023));
    } else {
        g->outer = h->inner = ldexp(ALGSURF_CUT, (int)lround(0.5 * (last + next)));
    }
}

static int groups_of(const algsurf_i_coefficients *p, group *groups) {
    double height[ALGSURF_MAX_POLY_DEGREE + 1];
    int hull[ALGSURF_MAX_POLY_DEGREE + 1], count = 0;
    for (int k = p->zeros; k <= p->degree; k++) height[k] = height_of(p, k);
    int corners = algsurf_i_upper_hull(height, p->zeros, p->degree, hull);
    double sum = 0, weight = 0, last = 0;
    groups[0].inner = 0;
    for (int i = 1; i < corners; i++) {
        int roots = hull[i] - hull[i - 1];
        double size = (height[hull[i - 1]] - height[hull[i]]) / roots;
        if (i > 1 && size - last > GROUP_GAP) {
            groups[count].exponent = (int)lround(sum / weight);
            part(p, height, hull[i - 1], last, size, groups + count, groups + count + 1);
            count++;
            sum = weight = 0;
        }
        sum += roots * size;
        weight += roots;
        last = size;
    }
    groups[count].exponent = weight > 0 ? (int)lround(sum / weight) : 0;
    groups[count].outer = HUGE_VAL;
    return count + 1;
}

/* The part of [from,to] in [lo,hi]; returns 0 if there is none. */
static int stretch(double lo, double hi, double from, double to, int exponent, algsurf_i_stretch *s) {
    *s = (algsurf_i_stretch){fmax(from, lo), fmin(to, hi), exponent};
    return s->lo < s->hi;
}

int algsurf_i_stretches(const algsurf_i_coefficients *p, double lo, double hi,
                        algsurf_i_stretch s[ALGSURF_MOST_STRETCHES]) {
    group g[ALGSURF_MAX_POLY_DEGREE + 1];
    int n = groups_of(p, g), count = 0;
    for (int i = n - 1; i > 0; i--)
        count += stretch(lo, hi, -g[i].outer, -g[i].inner, g[i].exponent, s + count);
    if (p->zeros) {
        count += stretch(lo, hi, -g[0].outer, 0, g[0].exponent, s + count);
        count += stretch(lo, hi, 0, g[0].outer, g[0].exponent, s + count);
    } else {
        count += stretch(lo, hi, -g[0].outer, g[0].outer, g[0].exponent, s + count);
    }
    for (int i = 1; i < n; i++) count += stretch(lo, hi, g[i].inner, g[i].outer, g[i].exponent, s + count);
    return count;
}
