/* low.c - roots of degrees 1 and 2 by formula, and how many there are up to degree 3.
 *
 * Roots.  D = b^2 - 4 a c is off by 3 u size, size = b^2 + |4 a c|.  With |D| > 2^-20 size its sign is sure
 * and it is off by 2^-31 of itself, its square root by 2^-32, as is t = -(b + sign b sqrt(D)) / 2, which does
 * not cancel.  Roots are t / a and c / t, in brackets 2^-30 of their size to either side; and one of them is
 * 1 + 2^-9 times as large as the other, or of the other sign.  With all coefficients within 2^+-300, b maybe
 * 0, nothing over- or underflows.
 *
 * Discriminant.  A term rounds six times at most, the sum four times: 10 u of the sum of their sizes, to
 * first order, taken as 32 u.  Nothing underflows where coefficients are 0 or within 2^+-200. */
#include "../base/arithmetic.h"
#include "line.h"

#include <math.h>

#include "../base/eft.h"

static int is_within(double a, double most) { return fabs(a) >= 1 / most && fabs(a) <= most; }

static algsurf_real_root root_about(double x, int sign) {
    double part = 0x1p-30 * fabs(x);
    return (algsurf_real_root){x, x - part, x + part, 1, sign};
}

int algsurf_i_low_roots(const algsurf_i_coefficients *p, algsurf_real_root *roots) {
    double c = p->c[0], b = p->c[1], a = p->c[p->degree];
    int rising = a > 0 ? 1 : -1;
    if (!is_within(a, 0x1p300) || !is_within(c, 0x1p300) || !(b == 0 || is_within(b, 0x1p300))) return -1;
    if (p->degree == 1) return roots[0] = root_about(-c / b, -rising), 1;
    double square = b * b, product = 4 * a * c, d = square - product;
    if (!(fabs(d) > 0x1p-20 * (square + fabs(product)))) return -1;
    if (d < 0) return 0;
    double t = -0.5 * (b < 0 ? b - sqrt(d) : b + sqrt(d)), x = t / a, y = c / t;
    roots[0] = root_about(fmin(x, y), rising);
    roots[1] = root_about(fmax(x, y), -rising);
    return 2;
}

int algsurf_i_low_number(const algsurf_i_coefficients *p) {
    const double *c = p->c;
    double sum = 0, size = 0, term[5] = {0};
    if (p->degree == 1 || p->degree > 3) return p->degree == 1 ? 1 : -1;
    for (int k = 0; k <= p->degree; k++)
        if (c[k] != 0 && !is_within(c[k], 0x1p200)) return -1;
    if (p->degree == 2) {
        term[0] = c[1] * c[1];
        term[1] = -4 * (c[0] * c[2]);
    } else {
        double square = c[1] * c[1], outer = c[0] * c[3], inner = c[1] * c[2];
        term[0] = 18 * (outer * inner);
        term[1] = -4 * (c[2] * c[2]) * (c[2] * c[0]);
        term[2] = inner * inner;
        term[3] = -4 * square * (c[1] * c[3]);
        term[4] = -27 * (outer * outer);
    }
    for (int i = 0; i < 5; i++) {
        sum += term[i];
        size += fabs(term[i]);
    }
    if (!(fabs(sum) > 32 * ALGSURF_U * size)) return -1;
    return sum > 0 ? p->degree : p->degree - 2;
}
