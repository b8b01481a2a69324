/* verified_roots_check.c - see verified_roots.h.
 *
 * Whatever the order in which the factors X - box are multiplied, the product holds p when the boxes hold
 * the roots; but intervals that grow on the way would hide a wrong root.  Two things make them grow.  A
 * rectangle times a complex number needs a larger rectangle, by a factor of up to sqrt(2): so factors are
 * multiplied in pairs, pairs of pairs and so on, and no root goes through more than log2(degree) products.
 * And the coefficients of a part of the product may be far larger than those of the whole: so the roots are
 * taken in Leja's order, each as far as can be from all before it (Reichel, Newton interpolation at Leja
 * points, 1990), in which neighbours, and so the roots of each part, lie spread around.
 */
#include "verified_roots.h"

#include <math.h>

static int boxes_meet(algsurf_cinterval a, algsurf_cinterval b) {
    algsurf_cinterval common;
    return algsurf_cinterval_intersect(a, b, &common) == ALGSURF_OK;
}

/* Puts the roots' numbers into Leja's order, beginning with the one farthest from 0. */
static void leja_order(const answer *a, int *order) {
    double far[ALGSURF_MAX_DEGREE]; /* log2 of the product of distances */
    for (int i = 0; i < a->count; i++) far[i] = log2(hypot(a->root[i].value.re, a->root[i].value.im));
    for (int k = 0; k < a->count; k++) {
        int best = -1;
        for (int i = 0; i < a->count; i++)
            if (!isnan(far[i]) && (best < 0 || far[i] > far[best])) best = i;
        order[k] = best;
        algsurf_complex z = a->root[best].value;
        if (k == 0)
            for (int i = 0; i < a->count; i++) far[i] = 0;
        far[best] = NAN; /* taken */
        for (int i = 0; i < a->count; i++)
            far[i] += log2(hypot(a->root[i].value.re - z.re, a->root[i].value.im - z.im));
    }
}

/* The coefficients of the product of X - z over n roots z, n > 0, lowest first. */
static void multiply_out(const algsurf_cinterval *z, int n, algsurf_cinterval *product) {
    const algsurf_cinterval zero = {{0, 0}, {0, 0}}, one = {{1, 1}, {0, 0}};
    algsurf_cinterval left[ALGSURF_MAX_DEGREE + 1], right[ALGSURF_MAX_DEGREE + 1];
    int half = n / 2, rest = n - half;
    if (n == 1) {
        product[0] = algsurf_cinterval_sub(zero, z[0]);
        product[1] = one;
        return;
    }
    multiply_out(z, half, left);
    multiply_out(z + half, rest, right);
    for (int k = 0; k <= n; k++) product[k] = zero;
    for (int i = 0; i <= half; i++)
        for (int j = 0; j <= rest; j++)
            product[i + j] = algsurf_cinterval_add(product[i + j], algsurf_cinterval_mul(left[i], right[j]));
}

/* The multiplicities add up to the degree of p. */
static int product_holds(const polynomial *p, const answer *a) {
    algsurf_cinterval z[ALGSURF_MAX_DEGREE] = {{{0, 0}, {0, 0}}}, product[ALGSURF_MAX_DEGREE + 1];
    const algsurf_complex top = p->c[p->degree];
    const algsurf_cinterval leading = {{top.re, top.re}, {top.im, top.im}};
    int order[ALGSURF_MAX_DEGREE], n = 0;
    leja_order(a, order);
    for (int k = 0; k < a->count; k++)
        for (int m = 0; m < a->root[order[k]].multiplicity; m++) z[n++] = a->root[order[k]].box;
    multiply_out(z, n, product);
    for (int k = 0; k <= n; k++)
        if (!algsurf_cinterval_contains(algsurf_cinterval_mul(leading, product[k]), p->c[k])) return 0;
    return 1;
}

const char *contradiction(const polynomial *p, const answer *a) {
    int roots = 0;
    for (int i = 0; i < a->count; i++) {
        if (!algsurf_cinterval_contains(a->root[i].box, a->root[i].value))
            return "a value outside of its box";
        if (a->complete && a->root[i].multiplicity < 1) return "a box without roots";
        roots += a->root[i].multiplicity;
        for (int j = 0; a->complete && j < i; j++)
            if (boxes_meet(a->root[i].box, a->root[j].box)) return "boxes that meet";
    }
    if (!a->complete) return NULL;
    if (roots != p->degree) return "multiplicities that do not add up to the degree";
    return product_holds(p, a) ? NULL : "boxes whose product does not hold the coefficients";
}

int simple_roots(const answer *a) {
    int count = 0;
    for (int i = 0; i < a->count; i++) {
        int fresh = a->root[i].simple;
        for (int j = 0; fresh && j < i; j++)
            if (a->root[j].simple && boxes_meet(a->root[i].box, a->root[j].box)) fresh = 0;
        count += fresh;
    }
    return count;
}

/* Does the box meet one of the answer's in which a root is proved? */
static int meets_any(algsurf_cinterval box, const answer *a) {
    for (int i = 0; i < a->count; i++)
        if (a->root[i].multiplicity > 0 && boxes_meet(box, a->root[i].box)) return 1;
    return 0;
}

const char *contradiction_between(const answer *a, const answer *complete) {
    for (int i = 0; i < a->count; i++)
        if (a->root[i].multiplicity > 0 && !meets_any(a->root[i].box, complete))
            return "a box where the complete answer has no root";
    for (int i = 0; a->complete && i < complete->count; i++)
        if (!meets_any(complete->root[i].box, a)) return "no box for a root of the complete answer";
    return NULL;
}
