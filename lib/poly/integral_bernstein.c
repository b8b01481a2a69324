/* integral_bernstein.c - Bernstein coefficients over [m, m + 2^q], as integers.
 *
 * p(m + 2^q s) = sum a_k s^k has b_j = sum_k C(j,k)/C(n,k) a_k.  So: Taylor's shift by m, the powers of two,
 * the factors L/C(n,k) with L = lcm C(n,k) = lcm(1..n+1)/(n+1) (84 bits at n = 64, where n! has 296), and
 * then sums in place of C(j,k).  The shift is done in the fewer limbs that its own results need. */
#include "../base/arithmetic.h"
#include "integral_impl.h"

#include <stddef.h>

/* The least prime that divides i >= 2. */
static int least_prime(int i) {
    for (int d = 2; d * d <= i; d++)
        if (i % d == 0) return d;
    return i;
}

/* a = a / d for a magnitude of w limbs that d divides. */
static void divide_by_int(algsurf_limb *a, int w, int d) {
    int shift = algsurf_limb_leading((algsurf_limb)d);
    algsurf_limb lead = (algsurf_limb)d << shift, inverse = algsurf_limb_inverse(lead), rest = 0;
    for (int i = w - 1; i >= 0;
         i--) { /* (rest 2^64 + a_i) / d, both shifted; rest < lead is shifted already */
        algsurf_limb high = rest | (shift ? a[i] >> (LIMB_BITS - shift) : 0);
        a[i] = algsurf_limb_divide(high, a[i] << shift, lead, inverse, &rest);
    }
}

/* a = lcm C(n,k) = lcm(1..n+1) / (n+1). */
static void set_lcm(algsurf_limb *a, int w, int n) {
    algsurf_z_set(a, w, 1);
    for (int i = 2; i <= n + 1; i++) { /* a prime for each of its powers */
        int p = least_prime(i), power = i;
        while (power % p == 0) power /= p;
        if (power == 1) algsurf_z_multiply(a, w, (algsurf_limb)p);
    }
    divide_by_int(a, w, n + 1);
}

/* An upper bound of 8 log2 M, M = a + b >= 1. */
static int eighths(algsurf_limb a, algsurf_limb b) {
    unsigned char carry = 0;
    algsurf_limb M = algsurf_limb_add(a, b, &carry);
    if (carry) return 8 * 65;
    int drop = larger(algsurf_limb_bits(M) - 7, 0);
    algsurf_limb t = ((M - 1) >> drop) + 1, power = t * t; /* M <= t 2^drop, t <= 2^7 */
    power *= power, power *= power;
    return algsurf_limb_bits(power - 1) + 8 * drop;
}

/* Bounds: sum |c_k| M^k < 2^bits.  With M = |m| + 1 it bounds each |a_k|, a sum of c_j C(j,k) m^(j-k); with
 * M = |m| + 2^q each |b_j|, since C(j,k) <= C(n,k). */
static int value_bits(const algsurf_zpoly *p, int eighths_of_M) {
    int bits = 0;
    for (int k = 0; k <= p->degree; k++)
        bits = larger(bits, algsurf_z_bits(algsurf_zpoly_at(p, k), p->width) + (k * eighths_of_M + 7) / 8);
    return bits + bits_of_int(p->degree + 1);
}

/* p(x + 1) in w limbs of each coefficient.  In this order (the transpose of the sums of
 * algsurf_zpoly_bernstein) a pass reads what the passes before wrote, and its steps do not wait for each
 * other. */
static inline __attribute__((always_inline)) void add_up(const algsurf_zpoly *p, int w) {
    for (int i = p->degree - 1; i >= 0; i--) {
        algsurf_limb *r = algsurf_zpoly_at(p, i);
        for (int k = i; k < p->degree; k++, r += p->width) algsurf_z_add(r, r + p->width, w);
    }
}

/* With the width known to the compiler the sums are chains without a loop. */
static void shift_by_one(const algsurf_zpoly *p, int w) {
    w == 1   ? add_up(p, 1)
    : w == 2 ? add_up(p, 2)
    : w == 3 ? add_up(p, 3)
    : w == 4 ? add_up(p, 4)
             : add_up(p, w);
}

/* p(-x) */
static void mirror(const algsurf_zpoly *p, int w) {
    for (int k = 1; k <= p->degree; k += 2) algsurf_z_negate(algsurf_zpoly_at(p, k), w);
}

/* p(x + at) in w limbs. */
static void taylor_shift(const algsurf_zpoly *b, int w, int64_t at) {
    algsurf_limb size = at < 0 ? 0 - (algsurf_limb)at : (algsurf_limb)at;
    if (at < 0) mirror(b, w);
    if (size == 1) shift_by_one(b, w);
    for (int i = b->degree - 1; i >= 0 && size > 1; i--)
        for (int k = i; k < b->degree; k++)
            (void)algsurf_z_add_row(algsurf_zpoly_at(b, k), algsurf_zpoly_at(b, k + 1), w, size);
    if (at < 0) mirror(b, w);
}

/* lcm C(n,k), k = 0 .. n, as far as it is below 2^53. */
#define MOST_SHORT 41
/* clang-format off */
static const algsurf_limb lcm_of_binomials[MOST_SHORT + 1] = {
    1, 1, 2, 3, 12, 10, 60, 105, 280, 252, 2520, 2310, 27720, 25740, 24024, 45045, 720720, 680680,
    12252240, 11639628, 11085360, 10581480, 232792560, 223092870, 1070845776, 1029659400,
    2974571600, 2868336900, 80313433200, 77636318760, 2329089562800, 4512611027925, 4375865239200,
    4247163320400, 4125815796960, 4011209802600, 144403552893600, 140603459396400, 136998242488800,
    133573286426580, 5342931457063200, 5215718803323600};
/* clang-format on */

/* bits(lcm C(n,k)): lcm(1..n) < 3^n (Hanson 1972), log2(3) < 8/5. */
static int lcm_bits(int n) {
    return n <= MOST_SHORT ? algsurf_limb_bits(lcm_of_binomials[n]) : 8 * (n + 1) / 5 + 1;
}

/* Coefficient k times 2^(k q) (or 2^((k-n) q) for q < 0) and lcm C(n,k) / C(n,k); `used` limbs are valid
 * before. Here for factors of one limb; the binomials and quotients are exact in double, which divides
 * faster. */
static void scale_short(const algsurf_zpoly *b, int used, int q) {
    int n = b->degree;
    double lcm = (double)lcm_of_binomials[n], binomial = 1;
    for (int k = 0; k <= n; k++) {
        algsurf_limb *a = algsurf_zpoly_at(b, k), f = (algsurf_limb)(lcm / binomial);
        int shift = q >= 0 ? k * q : (k - n) * q, rest = shift % LIMB_BITS;
        algsurf_z_copy(a, b->width, a, used);
        int joined = algsurf_limb_bits(f) + rest <= LIMB_BITS;
        (void)algsurf_z_multiply(a, b->width, joined ? f << rest : f);
        algsurf_z_shift_up(a, b->width, joined ? shift - rest : shift);
        binomial = binomial * (n - k) / (k + 1);
    }
}

static int scale_long(algsurf_memory *m, const algsurf_zpoly *b, int used, int q) {
    int n = b->degree, w = b->width, wf = algsurf_z_width(lcm_bits(n) + bits_of_int(n + 1));
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_limb *lcm = take(m, wf), *copy = take(m, w);
    const algsurf_z_factor f = {0, wf, 0, lcm}; /* over C(n,k) */
    if (lcm && copy) set_lcm(lcm, wf, n);
    for (int k = 0; lcm && copy && k <= n; k++) {
        algsurf_limb *a = algsurf_zpoly_at(b, k);
        algsurf_z_copy(copy, w, a, used);
        algsurf_z_zero(a, w);
        algsurf_z_add_times(a, w, copy, w, &f, 0);
        algsurf_z_shift_up(a, w, q >= 0 ? k * q : (k - n) * q);
        algsurf_z_multiply(lcm, wf, (algsurf_limb)(k + 1));
        if (k < n) divide_by_int(lcm, wf, n - k);
    }
    algsurf_memory_release(m, mark);
    return lcm && copy;
}

int algsurf_zpoly_bernstein(algsurf_memory *m, const algsurf_zpoly *p, int64_t at, int length_bits,
                            algsurf_zpoly *b) {
    int n = p->degree, q = length_bits;
    if (n < 0) return algsurf_zpoly_new(m, -1, 1, b);
    algsurf_limb size = at < 0 ? 0 - (algsurf_limb)at : (algsurf_limb)at;
    int reach =
        q > 63 ? larger(8 * q, eighths(size, 1)) + 8 : eighths(size, q > 0 ? (algsurf_limb)1 << q : 1);
    int w = algsurf_z_width(value_bits(p, reach) + lcm_bits(n) + (q < 0 ? -q * n : 0));
    int used = smaller(w, algsurf_z_width(value_bits(p, eighths(size, 1))));
    if (!algsurf_zpoly_copy(m, p, w, b)) return 0;
    taylor_shift(b, used, at);
    if (n <= MOST_SHORT)
        scale_short(b, used, q);
    else if (!scale_long(m, b, used, q))
        return 0;
    algsurf_zpoly_join_neighbours(b, 0);
    algsurf_zpoly_cut(b, algsurf_zpoly_trailing(b)); /* and keep leading zeros: roots at the right end */
    return 1;
}
