/* quadratic_template.h - both roots of LANES real quadratic polynomials a x^2 + b x + c, in closed form.
 *
 * D = b^2 - 4 a c from exact products.  Three sums of what rounding left are off by at most 6 u^2 size
 * together, size = b^2 + |4 a c|; lanes with |D| <= 2^-40 size are left.  So the error of D is below
 * 8 u^2 size / |D| of it, and that of its root half as much.
 *
 * The root h + l of |D|: l is off by 10 u^2 h (what is left of |D| - h^2, rounded, and l^2 / 2 h).  Two real
 * roots are t / a and c / t, t = -(b + sign b (h + l)) / 2, without cancellation; a pair is
 * -b / 2 a +- i (h + l) / 2 |a|.  A quotient is off by 2 u, and corrected once, to 40 u^2.  2^-98 takes in
 * all of these.
 *
 * Roots are 2^-20 of their size apart, or a pair as far off the axis: boxes are disjoint.  With |a|, |c| and
 * b, unless it is 0, within 2^+-300, nothing over- or underflows that matters. */
#ifndef ALGSURF_COMPLEX_QUADRATIC_TEMPLATE_H
#define ALGSURF_COMPLEX_QUADRATIC_TEMPLATE_H
#include "boxes_template.h"

typedef struct double_lanes {
    lanes hi, lo;
} double_lanes;

/* a / b; `inverse` is 1 / b.hi, rounded. */
INLINE double_lanes corrected_quotient(double_lanes a, double_lanes b, lanes inverse) {
    double_lanes q;
    lanes first = a.hi * inverse, low, product = exact_product(first, b.hi, &low);
    q.hi = exact_sum(first, ((((a.hi - product) - low) + a.lo) - first * b.lo) * inverse, &q.lo);
    return q;
}

INLINE double_lanes corrected_root(double_lanes a) {
    double_lanes h = {.hi = root(a.hi)};
    lanes inverse = 0.5 / h.hi, low, square = exact_product(h.hi, h.hi, &low);
    h.lo = (((a.hi - square) - low) + a.lo) * inverse;
    return h;
}

INLINE mask is_in_range(lanes a) {
    return at_most(all_lanes(0x1p-300), absolute(a)) & at_most(absolute(a), all_lanes(0x1p300));
}

/* As solve_boxes. */
INLINE unsigned solve_quadratics(const polynomials *p, unsigned wanted, algsurf_complex_root *roots,
                                 size_t stride) {
    const lanes a = p->re[2], b = p->re[1], c = p->re[0], zero = all_lanes(0);
    lanes square_low, product_low, d_low;
    lanes square = exact_product(b, b, &square_low), product = exact_product(4 * a, c, &product_low);
    lanes d = exact_sum(square, -product, &d_low), size = square + absolute(product);
    double_lanes least;
    least.hi = exact_sum(d, d_low + (square_low - product_low), &least.lo);
    mask fit =
        is_in_range(a) & is_in_range(c) & (is_zero(b) | is_in_range(b)) & less(0x1p-40 * size, absolute(d));
    unsigned solved = wanted & bits(fit);
    if (!solved) return 0;

    mask real = less(zero, d);
    least.lo = choose(real, least.lo, -least.lo);
    least.hi = absolute(least.hi);
    double_lanes h = corrected_root(least), t, middle = {-0.5 * b, zero};
    lanes half = choose(less(b, zero), all_lanes(0.5), all_lanes(-0.5)); /* -sign b / 2 */
    t.hi = exact_sum(middle.hi, half * h.hi, &t.lo);
    t.lo += half * h.lo;
    double_lanes first_top = {choose(real, t.hi, middle.hi), choose(real, t.lo, zero)};
    double_lanes second_top = {choose(real, c, 0.5 * h.hi), choose(real, zero, 0.5 * h.lo)};
    double_lanes second_bottom = {choose(real, t.hi, absolute(a)), choose(real, t.lo, zero)};
    double_lanes first = corrected_quotient(first_top, (double_lanes){a, zero}, 1 / a);
    double_lanes second = corrected_quotient(second_top, second_bottom, 1 / second_bottom.hi);

    lanes error = 8 * ROUNDING * ROUNDING * size / absolute(d) + 0x1p-98;
    lanes first_error = absolute(first.hi) * choose(real, error, all_lanes(0x1p-98));
    lanes second_error = absolute(second.hi) * error, larger_error = larger(first_error, second_error);
    points r;
    narrow n;
    answer out;
    for (int i = 0; i < 2; i++) {
        n.x[i] = i ? choose(real, second.hi, first.hi) : first.hi;
        n.xl[i] = i ? choose(real, second.lo, first.lo) : first.lo;
        n.y[i] = choose(real, zero, second.hi), n.yl[i] = choose(real, zero, second.lo);
        r.x[i] = n.x[i], r.y[i] = i ? -n.y[i] : n.y[i];
    }
    n.radius[0] = choose(real, first_error, larger_error);
    n.radius[1] = choose(real, second_error, larger_error);
    const layout s = {2, 0};
    set_answer(s, 1, &r, &n, &out);
    for (int l = 0; l < LANES; l++)
        if (solved >> l & 1) write_answer(s, 1, &out, l, roots + (size_t)l * stride);
    return solved;
}

#endif
