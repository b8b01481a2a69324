/* test_complex_families.c - complex roots of integer polynomials of named families, each answer judged by
 * Newton's method in numbers of some thousand bits.
 *
 * From the middle of a box z is brought to |p/p'|: a root is within n |p/p'| of z (Laguerre), and has to be
 * in the box.  So every box has a root of the factor that it is said to belong to; boxes are disjoint, and
 * there are as many as there are different roots: each has exactly one.  A box is at most two units in the
 * last place wide, in units of its larger part; real roots are said to be real, and others are not.
 *
 * Breaks tried, each caught: the error of cut values left out; discs far too small; boxes that are points
 * about z - W; the wrong one of two conjugates taken for a root of p. */
#include <stdio.h> /* before gmp.h, which then declares gmp_fprintf */

#include <gmp.h>

#include "algsurf/algsurf.h"
#include "unit.h"

enum { MOST = ALGSURF_MAX_POLY_DEGREE, BITS = 4096 };

/* Gaussian integers. */
typedef struct poly {
    int degree;
    mpz_t re[MOST + 1], im[MOST + 1];
} poly;

static poly *make(int degree) {
    poly *p = malloc(sizeof *p);
    assert_non_null(p);
    p->degree = degree;
    for (int k = 0; k <= MOST; k++) mpz_inits(p->re[k], p->im[k], NULL);
    return p;
}

static void drop(poly *p) {
    for (int k = 0; k <= MOST; k++) mpz_clears(p->re[k], p->im[k], NULL);
    free(p);
}

static poly *product(const poly *a, const poly *b) {
    poly *p = make(a->degree + b->degree);
    for (int i = 0; i <= a->degree; i++)
        for (int k = 0; k <= b->degree; k++) {
            mpz_addmul(p->re[i + k], a->re[i], b->re[k]), mpz_submul(p->re[i + k], a->im[i], b->im[k]);
            mpz_addmul(p->im[i + k], a->re[i], b->im[k]), mpz_addmul(p->im[i + k], a->im[i], b->re[k]);
        }
    return p;
}

/* p times (d z - (a + ib)). */
static poly *times_root(poly *p, long a, long b, long d) {
    poly *f = make(1);
    mpz_set_si(f->re[1], d), mpz_set_si(f->re[0], -a), mpz_set_si(f->im[0], -b);
    poly *q = product(p, f);
    drop(f), drop(p);
    return q;
}

static int is_real(const poly *p) {
    for (int k = 0; k <= p->degree; k++)
        if (mpz_sgn(p->im[k])) return 0;
    return 1;
}

/* ---- the judge ---- */

typedef struct number {
    mpf_t re, im;
} number;

static number x, y, v, d, t;

static void times(number *a, const number *b) {
    mpf_mul(t.re, a->re, b->re), mpf_mul(t.im, a->im, b->im), mpf_sub(t.re, t.re, t.im);
    mpf_mul(t.im, a->re, b->im), mpf_mul(a->im, a->im, b->re), mpf_add(a->im, a->im, t.im);
    mpf_set(a->re, t.re);
}

/* |a|^2 as part 2^exponent. */
static double square(const number *a, long *exponent) {
    mpf_mul(t.re, a->re, a->re), mpf_mul(t.im, a->im, a->im), mpf_add(t.re, t.re, t.im);
    return mpf_get_d_2exp(exponent, t.re);
}

/* v = p(x), d = p'(x). */
static void values(const poly *p) {
    mpf_set_ui(v.re, 0), mpf_set_ui(v.im, 0), mpf_set_ui(d.re, 0), mpf_set_ui(d.im, 0);
    for (int k = p->degree; k >= 0; k--) {
        times(&d, &x), mpf_add(d.re, d.re, v.re), mpf_add(d.im, d.im, v.im);
        times(&v, &x);
        mpf_set_z(y.re, p->re[k]), mpf_set_z(y.im, p->im[k]);
        mpf_add(v.re, v.re, y.re), mpf_add(v.im, v.im, y.im);
    }
}

/* One step of Newton's method from x; returns log2 of |p/p'|. */
static double step(const poly *p) {
    long a, b;
    values(p);
    double up = square(&v, &a), down = square(&d, &b);
    if (up == 0) return -1e6;
    if (down == 0) return 1e6;
    mpf_mul(y.re, d.re, d.re), mpf_mul(y.im, d.im, d.im), mpf_add(y.re, y.re, y.im);
    mpf_neg(d.im, d.im), times(&v, &d);
    mpf_div(v.re, v.re, y.re), mpf_div(v.im, v.im, y.re);
    mpf_sub(x.re, x.re, v.re), mpf_sub(x.im, x.im, v.im);
    return 0.5 * ((double)(a - b) + log2(up / down));
}

/* x is within 2^log of a root: is that in the interval? */
static int is_in(const mpf_t a, double log, algsurf_interval box) {
    mpf_t end, by;
    mpf_init2(end, BITS), mpf_init2(by, BITS);
    mpf_set_ui(by, 1);
    long e = (long)floor(log) + 1;
    if (e < 0)
        mpf_div_2exp(by, by, (mp_bitcnt_t)-e);
    else
        mpf_mul_2exp(by, by, (mp_bitcnt_t)e);
    mpf_add(end, a, by);
    int in = isinf(box.lo) || mpf_cmp_d(end, box.lo) >= 0;
    mpf_sub(end, a, by);
    in = in && (isinf(box.hi) || mpf_cmp_d(end, box.hi) <= 0);
    mpf_clear(end), mpf_clear(by);
    return in;
}

/* Does the box have a root of p? */
static int has_root(const poly *p, const algsurf_complex_root *e) {
    double before = 1e6, log = 0, size = fmax(fabs(e->root.re), fabs(e->root.im)), enough = log2(size) - 120;
    if (size == 0) return mpz_sgn(p->re[0]) == 0 && mpz_sgn(p->im[0]) == 0;
    mpf_set_d(x.re, e->root.re), mpf_set_d(x.im, e->root.im);
    for (int k = 0; k < 60; k++) {
        log = step(p) + log2(p->degree) + 1;
        if (k > 8 && log > before) break;
        before = log;
        if (log < enough - 500) break;
    }
    return log < enough && is_in(x.re, log + 1, e->box.re) && is_in(x.im, log + 1, e->box.im);
}

static int meet(const algsurf_cinterval *a, const algsurf_cinterval *b) {
    return a->re.lo <= b->re.hi && b->re.lo <= a->re.hi && a->im.lo <= b->im.hi && b->im.lo <= a->im.hi;
}

static double ulps(algsurf_interval part, double size) {
    return (part.hi - part.lo) / (nextafter(size, INFINITY) - size);
}

enum { FACTORS = 4 };

static void integers(mpz_t *c, int n, algsurf_integer *z) {
    for (int k = 0; k <= n; k++)
        z[k] = (algsurf_integer){mpz_limbs_read(c[k]), mpz_sgn(c[k]) * (int)mpz_size(c[k])};
}

/* The roots of the product of factors f[i]^m[i], squarefree and without common roots, which is p; `real`: how
 * many different real ones there are, -1: not known. */
static void judge(const char *name, poly *p, const poly *const *f, const int *m, int real) {
    static algsurf_integer re[MOST + 1], im[MOST + 1];
    static algsurf_complex_root e[MOST];
    int count, different = 0, sum = 0, reals = 0, left[FACTORS] = {0};
    integers(p->re, p->degree, re), integers(p->im, p->degree, im);
    algsurf_status status = algsurf_complex_roots_integers(re, is_real(p) ? NULL : im, p->degree, e, &count);
    if (status != ALGSURF_OK) fail_msg("%s: %s", name, algsurf_status_text(status));
    for (int i = 0; i < FACTORS && f[i]; i++) different += left[i] = f[i]->degree;
    if (count != different) fail_msg("%s: %d boxes for %d roots", name, count, different);
    for (int i = 0; i < count; i++) {
        double size = fmax(fabs(e[i].root.re), fabs(e[i].root.im));
        sum += e[i].multiplicity, reals += e[i].real;
        assert_true(!e[i].real || (e[i].box.im.lo == 0 && e[i].box.im.hi == 0));
        if (ulps(e[i].box.re, size) > 2 || ulps(e[i].box.im, size) > 2)
            fail_msg("%s: [%a, %a] + i [%a, %a] is wide", name, e[i].box.re.lo, e[i].box.re.hi,
                     e[i].box.im.lo, e[i].box.im.hi);
        for (int j = 0; j < i; j++) assert_false(meet(&e[i].box, &e[j].box));
        int found = 0;
        for (int k = 0; k < FACTORS && f[k]; k++)
            if (m[k] == e[i].multiplicity && left[k] > 0 && has_root(f[k], e + i)) found++, left[k]--;
        if (found != 1)
            fail_msg("%s: [%a, %a] + i [%a, %a], %d times: %d factors have a root there", name,
                     e[i].box.re.lo, e[i].box.re.hi, e[i].box.im.lo, e[i].box.im.hi, e[i].multiplicity,
                     found);
    }
    assert_int_equal(sum, p->degree);
    if (real >= 0) assert_int_equal(reals, real);
}

static void judge_one(const char *name, poly *p, int real) {
    const poly *const f[FACTORS] = {p};
    const int m[FACTORS] = {1};
    judge(name, p, f, m, real);
    drop(p);
}

/* ---- families ---- */

/* c_(k+1) = (a z + b) c_k - c c_(k-1), from 1 and z's multiple. */
static poly *recurrence(int n, long (*a)(int), long (*b)(int), long (*c)(int)) {
    poly *before = make(0), *p = make(0);
    mpz_set_ui(p->re[0], 1);
    for (int k = 0; k < n; k++) {
        poly *next = make(k + 1);
        for (int i = 0; i <= k; i++) {
            mpz_t w;
            mpz_init(w);
            mpz_mul_si(w, p->re[i], a(k)), mpz_add(next->re[i + 1], next->re[i + 1], w);
            mpz_mul_si(w, p->re[i], b(k)), mpz_add(next->re[i], next->re[i], w);
            if (i < k) mpz_mul_si(w, before->re[i], c(k)), mpz_sub(next->re[i], next->re[i], w);
            mpz_clear(w);
        }
        drop(before);
        before = p, p = next;
    }
    drop(before);
    return p;
}

static long one(int k) { return k ? 2 : 1; }
static long two(int k) {
    (void)k;
    return 2;
}
static long none(int k) {
    (void)k;
    return 0;
}
static long unit(int k) {
    (void)k;
    return 1;
}
static long twice(int k) { return 2L * k; }
static long minus(int k) {
    (void)k;
    return -1;
}
static long odd(int k) { return 2L * k + 1; }
static long squared(int k) { return (long)k * k; }

TEST(orthogonal) {
    for (int n = 3; n <= 130; n = n * 2 + 1) {
        judge_one("Chebyshev", recurrence(n, one, none, unit), n);
        judge_one("Hermite", recurrence(n, two, none, twice), n);
        judge_one("Laguerre", recurrence(n, minus, odd, squared), n);
    }
}

TEST(wilkinson) {
    for (int n = 10; n <= 80; n *= 2) {
        poly *p = make(0), *q = make(0);
        mpz_set_ui(p->re[0], 1), mpz_set_ui(q->re[0], 1);
        for (int k = 1; k <= n; k++) p = times_root(p, k, 0, 1), q = times_root(q, k, (k * 7) % 5 - 2, 1);
        judge_one("Wilkinson", p, n);
        judge_one("Wilkinson's, some of them complex", q, -1);
    }
}

TEST(sparse) {
    for (int n = 5; n <= 400; n = n * 3 + 2) {
        poly *p = make(n), *q = make(n), *exponential = make(n < 160 ? n : 160);
        mpz_set_ui(p->re[n], 1), mpz_set_si(p->re[0], -1);
        mpz_set_ui(q->re[n], 1), mpz_set_si(q->im[0], -1);
        mpz_set_ui(exponential->re[exponential->degree], 1);
        for (int k = exponential->degree; k > 0; k--)
            mpz_mul_si(exponential->re[k - 1], exponential->re[k], k);
        judge_one("z^n - 1", p, n % 2 ? 1 : 2);
        judge_one("z^n - i", q, -1);
        judge_one("exp", exponential, exponential->degree % 2);
    }
}

/* z -> z^2 + c, as a polynomial in c. */
TEST(mandelbrot) {
    poly *p = make(0);
    mpz_set_ui(p->re[0], 1);
    for (int k = 1; k <= 6; k++) {
        poly *q = product(p, p), *next = make(q->degree + 1);
        for (int i = 0; i <= q->degree; i++) mpz_set(next->re[i + 1], q->re[i]);
        mpz_add_ui(next->re[0], next->re[0], 1);
        drop(p), drop(q);
        p = next;
    }
    judge_one("Mandelbrot", p, -1);
}

/* Two real roots about 2 a^-(n/2+1) apart, at 1/a; a pair of complex ones. */
TEST(close_pairs) {
    for (int n = 8; n <= 128; n *= 4)
        for (long a = 3; a <= (1L << 26) + 1; a = a * 4096 + 1) {
            double gap = -(n / 2.0 + 1) * log2((double)a) + log2((double)a);
            if (gap < -51) continue; /* doubles do not tell them apart */
            poly *p = make(n);
            mpz_set_ui(p->re[n], 1);
            mpz_set_si(p->re[0], -1), mpz_set_si(p->re[1], 2 * a), mpz_set_si(p->re[2], -a * a);
            judge_one("Mignotte", p, -1);
        }
    for (int n = 20; n <= 200; n *= 10) { /* 1 + t^(n-2) (t + 20000)^2 */
        poly *p = make(n);
        mpz_set_ui(p->re[0], 1);
        mpz_set_ui(p->re[n], 1), mpz_set_ui(p->re[n - 1], 40000), mpz_set_ui(p->re[n - 2], 400000000);
        static algsurf_integer re[MOST + 1];
        static algsurf_complex_root e[MOST];
        int count, sum = 0;
        integers(p->re, n, re);
        assert_int_equal(algsurf_complex_roots_integers(re, NULL, n, e, &count), ALGSURF_OK);
        for (int i = 0; i < count; i++) {
            sum += e[i].multiplicity;
            assert_false(e[i].real);
        }
        assert_int_equal(
            count, n == 20 ? n : n - 1); /* 20000^-99 is no double: the pair is one box, across the axis */
        assert_int_equal(sum, n);
        drop(p);
    }
}

/* Roots 2^-k apart at rational places. */
TEST(clusters) {
    for (int k = 10; k <= 40; k += 10)
        for (int size = 2; size <= 12; size += 5) {
            poly *p = make(0);
            const long wide = 1L << k;
            mpz_set_ui(p->re[0], 1);
            for (int i = 0; i < size; i++)
                p = times_root(p, wide / 3 + i, i % 3, wide), p = times_root(p, -wide - i, 0, wide);
            judge_one("clusters", p, -1);
        }
}

TEST(geometric) {
    for (int n = 10; n <= 60; n += 25) {
        poly *p = make(0), *q = make(0);
        mpz_set_ui(p->re[0], 1), mpz_set_ui(q->re[0], 1);
        long a = 1, b = 0;
        for (int k = 0; k < n; k++) {
            p = times_root(p, 1L << k, 0, 1);
            if (k >= 30) continue;
            q = times_root(q, a, b, 1);
            long next = a - 2 * b; /* (1 + 2i)^k: a spiral */
            b = b + 2 * a, a = next;
        }
        judge_one("2^k", p, n);
        judge_one("(1 + 2i)^k", q, -1);
    }
}

static uint64_t seed = 20261126;

static int random_below(int n) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (int)(seed >> 33) % n;
}

/* Products with multiplicities, of real and of Gaussian factors, which may share roots with their conjugates.
 */
TEST(multiple) {
    for (int round = 0; round < 60; round++) {
        poly *f[FACTORS] = {NULL}, *p = make(0);
        int m[FACTORS] = {1, 2, 3, 5}, real = round % 2, factors = 1 + random_below(FACTORS), taken = 0;
        mpz_set_ui(p->re[0], 1);
        for (int i = 0; i < factors; i++) {
            int roots = 1 + random_below(4);
            f[i] = make(0);
            mpz_set_ui(f[i]->re[0], 1);
            for (int k = 0; k < roots; k++) { /* roots differ in their real parts, but conjugates */
                long a = 7 * ++taken + random_below(5), b = random_below(3) * (1 + random_below(9));
                f[i] = times_root(f[i], a, b, 3);
                if (b && (real || random_below(2))) f[i] = times_root(f[i], a, -b, 3);
            }
            for (int k = 0; k < m[i]; k++) {
                poly *q = product(p, f[i]);
                drop(p);
                p = q;
            }
        }
        judge("multiple roots", p, (const poly *const *)f, m, -1);
        for (int i = 0; i < factors; i++) drop(f[i]);
        drop(p);
    }
}

/* Dense ones, of integers of very different sizes. */
TEST(random_ones) {
    for (int round = 0; round < 12; round++) {
        int n = round % 3 == 2 ? 200 : 20 + random_below(40), complex = round % 2;
        poly *p = make(n);
        for (int k = 0; k <= n; k++)
            for (int i = 0; i <= complex; i++) {
                mpz_set_si(i ? p->im[k] : p->re[k], random_below(2000) - 999);
                if (round % 4 > 1)
                    mpz_mul_2exp(i ? p->im[k] : p->re[k], i ? p->im[k] : p->re[k],
                                 (mp_bitcnt_t)random_below(900));
            }
        if (mpz_sgn(p->re[n]) == 0) mpz_set_ui(p->re[n], 1);
        if (mpz_sgn(p->re[0]) == 0) mpz_set_ui(p->re[0], 1);
        judge_one("random", p, -1);
    }
}

/* Those whose values may come from doubles, on either side of where these end: ends of 2^-700 of the largest
 * coefficient, values of 2^900, coefficients of 53 and 54 bits. */
TEST(borders_of_doubles) {
    static const int spread[] = {0, 30, 300, 690, 710, 900};
    for (int round = 0; round < 36; round++) {
        int n = 25 + random_below(50), complex = round % 2, kind = round / 2 % 3, E = spread[round / 6];
        poly *p = make(n);
        for (int k = 0; k <= n; k++) {
            double side = 2.0 * k / n - 1;
            int up = kind == 0   ? random_below(E + 1)
                     : kind == 1 ? (int)(E * (1 - side * side))
                     : k < n     ? E
                                 : 0;
            for (int i = 0; i <= complex; i++) {
                mpz_t *c = i ? &p->im[k] : &p->re[k];
                mpz_set_si(*c, random_below(1 << 30));
                mpz_mul_2exp(*c, *c, random_below(8) ? 23 : 24);
                mpz_add_ui(*c, *c, (unsigned)random_below(1 << 23));
                mpz_mul_2exp(*c, *c, (mp_bitcnt_t)up);
                if (random_below(2)) mpz_neg(*c, *c);
            }
        }
        if (mpz_sgn(p->re[n]) == 0) mpz_set_ui(p->re[n], 1);
        if (mpz_sgn(p->re[0]) == 0) mpz_set_ui(p->re[0], 1);
        judge_one("borders of doubles", p, -1);
    }
}

/* Arguments, and the root 0. */
TEST(the_interface) {
    const uint64_t two_limb = 2, zero = 0;
    const algsurf_integer c[3] = {{&zero, 1}, {&two_limb, -1}, {&two_limb, 1}},
                          nothing[2] = {{NULL, 0}, {&zero, 1}};
    const algsurf_integer bad[1] = {{NULL, 1}}, huge[1] = {{&zero, ALGSURF_MAX_LIMBS + 1}};
    algsurf_complex_root e[2];
    int count = -1;
    assert_int_equal(algsurf_complex_roots_integers(NULL, NULL, 2, e, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(c, NULL, -1, e, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(c, NULL, 2, NULL, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(c, NULL, 2, e, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(bad, NULL, 0, e, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(huge, NULL, 0, e, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(nothing, nothing, 1, e, &count), ALGSURF_E_ZERO);
    assert_int_equal(count, -1);
    assert_int_equal(algsurf_complex_roots_integers(c + 1, nothing, 0, e, &count), ALGSURF_OK);
    assert_int_equal(count, 0);
    for (int turned = 0; turned < 2; turned++) { /* 2 z^2 - 2 z, and i times that */
        const algsurf_integer none_of_them[3] = {{NULL, 0}, {NULL, 0}, {&zero, 1}};
        assert_int_equal(
            algsurf_complex_roots_integers(turned ? none_of_them : c, turned ? c : NULL, 2, e, &count),
            ALGSURF_OK);
        assert_int_equal(count, 2);
        for (int i = 0; i < 2; i++) {
            assert_true(e[i].box.re.lo <= i && e[i].box.re.hi >= i);
            assert_true(e[i].real && e[i].multiplicity == 1);
        }
    }
}

int main(void) {
    number *const all[] = {&x, &y, &v, &d, &t};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        mpf_init2(all[i]->re, BITS), mpf_init2(all[i]->im, BITS);
    return unit_run("complex roots of families");
}
