/* certain_template.h - values of LANES polynomials whose signs are certain, and neighbouring doubles.
 *
 * The compensated Horner scheme (Graillat, Langlois, Louvet, Compensated Horner Scheme, 2005) is off by
 *   u |p(t)| + g^2 S at most,   g = 2 n u / (1 - 2 n u),   S = sum |c_k| |t|^k,   u = 2^-53:
 * a value above g^2 S has p's sign.  8 n^2 u^2 takes in the roundings of S, of the value, and of the bound.
 * Callers see to it that nothing overflows and |t|^n is at most 2^400: what underflow loses, below 2^-1070 in
 * each of n steps, is then less than 2^-600, which is added. */
#ifndef ALGSURF_CERTAIN_TEMPLATE_H
#define ALGSURF_CERTAIN_TEMPLATE_H
#include "../simd/lanes.h"

/* Of one polynomial for all lanes, or of one for each. */
typedef struct terms {
    const double *shared;
    const lanes *each; /* or null */
} terms;

INLINE lanes term_at(terms c, int k) { return c.each ? c.each[k] : all_lanes(c.shared[k]); }

/* p(t) where its sign is certain, else 0; as computed; and its slope, roughly. */
INLINE lanes certain_value(terms c, int n, lanes t, lanes *value, lanes *slope) {
    lanes y = term_at(c, n), error = all_lanes(0), size = absolute(y), far = absolute(t);
    *slope = error;
    for (int k = n - 1; k >= 0; k--) {
        lanes product_low, sum_low, product = exact_product(y, t, &product_low), term = term_at(c, k);
        *slope = *slope * t + y;
        y = exact_sum(product, term, &sum_low);
        error = error * t + (product_low + sum_low);
        size = size * far + absolute(term);
    }
    *value = y + error;
    lanes bound = (8.0 * n * n * 0x1p-106) * size + 0x1p-600;
    return choose(less(bound, absolute(*value)), *value, all_lanes(0));
}

/* The neighbouring double in the direction of `step`, which is not NaN; a is not 0. */
INLINE lanes next_double(lanes a, lanes step) {
    mask shrinks = negative((words)a ^ (words)step);
    return choose(shrinks, (lanes)((words)a - 1), (lanes)((words)a + 1));
}

#endif
