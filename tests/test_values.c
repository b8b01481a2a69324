/* test_values.c - values of polynomials at many points in doubled precision: within their bound, the same
 * bits from every kernel.
 *
 * Points are next to roots, where all digits of Horner's rule cancel.  Exact are numbers of 12288 bits, which
 * hold each value whole.
 *
 * Breaks tried, each caught: the error of a sum left out, in either part; a point answered by the first one
 * of its register. */
#include <stdio.h> /* before gmp.h, which then declares gmp_fprintf */

#include <gmp.h>

#include "algsurf/algsurf.h"
#include "complex/boxes.h"
#include "random.h"
#include "unit.h"

enum { BITS = 12288, MOST = 100, POINTS = 2 * MOST };

static uint64_t seed = 20261127u;

static double uniform(void) { /* in (-1,1) */
    return ldexp((double)(int64_t)(random_bits(&seed) >> 10 << 10), -63);
}

static mpf_t exact_re, exact_im, zx, zy, a, b;

static void exact_value(const double *re, const double *im, int n, double x, double y) {
    mpf_set_d(zx, x), mpf_set_d(zy, y);
    mpf_set_d(exact_re, re[n]), mpf_set_d(exact_im, im[n]);
    for (int k = n - 1; k >= 0; k--) {
        mpf_mul(a, exact_re, zy), mpf_mul(b, exact_im, zx);
        mpf_add(a, a, b);
        mpf_mul(exact_re, exact_re, zx), mpf_mul(b, exact_im, zy);
        mpf_sub(exact_re, exact_re, b);
        mpf_set_d(b, re[k]), mpf_add(exact_re, exact_re, b);
        mpf_set_d(b, im[k]), mpf_add(exact_im, a, b);
    }
}

/* |computed - exact| in units of 32 n (n + 2) u^2 sum + u |p|. */
static double excess(int n, double re, double im, double sum) {
    const double u = 0x1p-53;
    double size = hypot(mpf_get_d(exact_re), mpf_get_d(exact_im));
    mpf_set_d(a, re), mpf_set_d(b, im);
    mpf_sub(a, a, exact_re), mpf_sub(b, b, exact_im);
    return hypot(mpf_get_d(a), mpf_get_d(b)) / (32.0 * n * (n + 2) * u * u * sum + u * size);
}

/* sum |c_k| |z|^k, a little less. */
static double sum_of(const double *size, int n, double x, double y) {
    double sum = size[n], far = hypot(x, y);
    for (int k = n - 1; k >= 0; k--) sum = sum * far + size[k];
    return sum * (1 - 0x1p-40);
}

static double worst;

static void judge(const double *re, const double *im, int n, const double *x, const double *y, int count) {
    double size[MOST + 1], first[3][POINTS], next[3][POINTS];
    for (int k = 0; k <= n; k++) size[k] = hypot(re[k], im[k]) * (1 + 0x1p-50);
    const algsurf_i_flat p = {.n = n, .exact = 1, .re = re, .im = im, .size = size, .noise = size};
    const algsurf_i_kernel *kernel;
    for (int k = 0; (kernel = algsurf_i_kernel_at(k)); k++) {
        double(*to)[POINTS] = k ? next : first;
        algsurf_i_allroots_kernel_for(kernel)->values(&p, x, y, count, to[0], to[1], to[2]);
        for (int i = 0; i < 3; i++) assert_memory_equal(to[i], first[i], (size_t)count * sizeof **to);
    }
    for (int i = 0; i < count; i++) {
        exact_value(re, im, n, x[i], y[i]);
        double off = excess(n, first[0][i], first[1][i], first[2][i]);
        if (off > 1 || first[2][i] < sum_of(size, n, x[i], y[i]))
            fail_msg("degree %d at %a + %a i: %a + %a i is off by %g times the bound, sum %a (seed %llu)", n,
                     x[i], y[i], first[0][i], first[1][i], off, first[2][i], (unsigned long long)seed);
        worst = fmax(worst, off);
    }
}

TEST(next_to_roots) {
    for (int round = 0; round < 60; round++) {
        double re[MOST + 1], im[MOST + 1], x[POINTS], y[POINTS];
        int n = 2 + round * 97 % (MOST - 1), complex = round % 2, count = 0, wide = round % 5 * 150;
        algsurf_complex_root root[MOST];
        algsurf_complex c[MOST + 1];
        for (int k = 0; k <= n; k++) {
            double up = round % 3 == 0   ? wide * uniform() / 2
                        : round % 3 == 1 ? -fabs(2.0 * k / n - 1) * wide
                                         : 0;
            re[k] = ldexp(uniform(), (int)up), im[k] = complex ? ldexp(uniform(), (int)up) : 0;
            c[k] = (algsurf_complex){re[k], im[k]};
        }
        int roots;
        assert_ok(algsurf_complex_roots(c, NULL, n, root, &roots));
        for (int i = 0; i < roots; i++) {
            double size = hypot(root[i].root.re, root[i].root.im);
            if (n * log2(size) > 800 || !(size > 0x1p-400)) continue;
            x[count] = root[i].root.re, y[count++] = root[i].root.im;
            x[count] = root[i].root.re + size * 0x1p-30 * uniform(), y[count++] = root[i].root.im;
        }
        judge(re, im, n, x, y, count);
        judge(re, im, n, x, y, count < 3 ? count : 3);
    }
    assert_true(worst > 1e-4); /* the bound is felt */
}

int main(void) {
    mpf_t *const all[] = {&exact_re, &exact_im, &zx, &zy, &a, &b};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) mpf_init2(*all[i], BITS);
    int failed = unit_run("values at many points");
    printf("the worst error is %.3g of its bound\n", worst);
    return failed;
}
