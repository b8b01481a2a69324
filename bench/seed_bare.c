/* seed_bare.c - see seed.h: Descartes' rule of signs on Bernstein coefficients, halving from the left
 * (Lane, Riesenfeld, Bounds on a polynomial, BIT 21, 1981), in plain double.
 *
 * This is the inner loop of algsurf_isolate_first without what makes it trustworthy: bounds on the rounding
 * error of each sign, a second look in better precision where a bound does not decide, input of any scale,
 * roots at ends, checks of the arguments.
 */
#include "seed.h"

#include <string.h>

enum { HALVINGS = 40 };
static const double NARROW = 0x1p-39; /* [-1,1] after so many */

typedef struct form {
    double b[SEED_DEGREE + 1], lo, hi; /* Bernstein coefficients over [lo,hi] */
} form;

/* Over [-1,1], from powers of x = 2s - 1: powers of s, then each over its binomial, summed up. */
static void convert(const double *c, int n, form *to) {
    double *b = to->b, scale = 1;
    memcpy(b, c, ((size_t)n + 1) * sizeof *b);
    for (int i = 0; i < n; i++)
        for (int k = n - 1; k >= i; k--) b[k] -= b[k + 1];
    for (int k = 1; k <= n; k++) {
        scale *= 2.0 * k / (n - k + 1);
        b[k] *= scale;
    }
    for (int i = 0; i < n; i++)
        for (int k = n; k > i; k--) b[k] += b[k - 1];
    to->lo = -1;
    to->hi = 1;
}

/* De Casteljau's scheme at the middle: the left half stays. */
static void halve(form *f, int n, form *right) {
    for (int i = 0; i < n; i++) {
        right->b[n - i] = f->b[n];
        for (int k = n; k > i; k--) f->b[k] = 0.5 * (f->b[k - 1] + f->b[k]);
    }
    right->b[0] = f->b[n];
    right->hi = f->hi;
    right->lo = f->hi = 0.5 * (f->lo + f->hi);
}

static int variations(const double *b, int n) {
    int count = 0;
    for (int k = 1; k <= n; k++) count += (b[k - 1] < 0) != (b[k] < 0);
    return count;
}

int seed_bare_isolate(const double *c, int degree, double *lo, double *hi) {
    form part[HALVINGS + 1]; /* the leftmost last */
    int parts = 1;
    convert(c, degree, &part[0]);
    while (parts > 0) {
        form *f = &part[parts - 1];
        int count = variations(f->b, degree);
        if (count == 1) {
            *lo = f->lo;
            *hi = f->hi;
            return 1;
        }
        if (count == 0 || f->hi - f->lo <= NARROW) {
            parts--;
            continue;
        }
        form left = *f;
        halve(&left, degree, f);
        part[parts++] = left;
    }
    return 0;
}
