/* isolate_scale.c - where on the line the roots of a polynomial can be, and in which units to look.
 *
 * Where coefficients differ by hundreds of orders of magnitude so do the roots, and no single unit
 * serves them all.  The upper convex hull of the points (k, log2 |c_k|) (Newton's polygon) gives the
 * magnitudes of the roots up to a factor of about the degree; they are gathered into groups, the line
 * is cut between groups, and each stretch is walked in the unit of its group.
 */
#include <math.h>

#include "isolate_impl.h"

#define GROUP_GAP 16 /* binary orders of magnitude between roots that part two groups */

/* log2 of the magnitude of coefficient k, its radius included. */
static double height(const algsurf_i_coefficients *t, int k) {
    double a = fabs(t->c[k]) + (t->r ? t->r[k] : 0);
    return a > 0 ? log2(a) : -HUGE_VAL;
}

/* Ends of the edges of the upper hull of (k, height), k increasing; returns how many points. */
static int upper_hull(const algsurf_i_coefficients *t, int *hull) {
    int count = 0;
    for (int k = t->zeros; k <= t->degree; k++) {
        double y = height(t, k);
        if (isinf(y)) continue;
        while (count >= 2) {
            int a = hull[count - 2], b = hull[count - 1];
            if ((height(t, b) - height(t, a)) * (k - a) > (y - height(t, a)) * (b - a)) break;
            count--;
        }
        hull[count++] = k;
    }
    return count;
}

typedef struct group {
    int exponent;   /* unit 2^exponent */
    int outer;      /* ends at ALGSURF_CUT 2^outer, where the next one starts */
} group;

static int groups_of(const algsurf_i_coefficients *t, group *groups) {
    int hull[ALGSURF_MAX_POLY_DEGREE + 1], points = upper_hull(t, hull), count = 0;
    double sum = 0, weight = 0, last = 0;
    for (int i = 1; i < points; i++) {
        int roots = hull[i] - hull[i - 1];
        double size = (height(t, hull[i - 1]) - height(t, hull[i])) / roots;
        if (i > 1 && size - last > GROUP_GAP) {
            groups[count].exponent = (int)lround(sum / weight);
            groups[count++].outer = (int)lround(0.5 * (last + size));
            sum = weight = 0;
        }
        sum += roots * size;
        weight += roots;
        last = size;
    }
    groups[count].exponent = weight > 0 ? (int)lround(sum / weight) : 0;
    groups[count++].outer = 0;
    return count;
}

static int stretch_into(double lo, double hi, double from, double to, int exponent, algsurf_i_stretch *s) {
    s->lo = fmax(from, lo);
    s->hi = fmin(to, hi);
    s->exponent = exponent;
    return s->lo < s->hi;
}

int algsurf_i_stretches(const algsurf_i_coefficients *t, double lo, double hi, algsurf_i_stretch s[ALGSURF_MOST_STRETCHES]) {
    group g[ALGSURF_MAX_POLY_DEGREE + 1];
    int n = groups_of(t, g), count = 0;
    for (int i = n - 1; i > 0; i--)
        count += stretch_into(lo, hi, i == n - 1 ? -HUGE_VAL : -ldexp(ALGSURF_CUT, g[i].outer),
                              -ldexp(ALGSURF_CUT, g[i - 1].outer), g[i].exponent, s + count);
    double end = n > 1 ? ldexp(ALGSURF_CUT, g[0].outer) : HUGE_VAL;
    if (t->zeros) {
        count += stretch_into(lo, hi, -end, 0, g[0].exponent, s + count);
        count += stretch_into(lo, hi, 0, end, g[0].exponent, s + count);
    } else {
        count += stretch_into(lo, hi, -end, end, g[0].exponent, s + count);
    }
    for (int i = 1; i < n; i++)
        count += stretch_into(lo, hi, ldexp(ALGSURF_CUT, g[i - 1].outer),
                              i == n - 1 ? HUGE_VAL : ldexp(ALGSURF_CUT, g[i].outer), g[i].exponent, s + count);
    return count;
}
