/* test_complex_families.c - complex roots of integer polynomials of named families, each answer judged by
 * Newton's method in numbers of some thousand bits.
 *
 * From a place in a box z is brought to |p/p'|: a root is within n |p/p'| of z (Laguerre), and has to be
 * in the box.  So every box has a root of the factor that it is said to belong to; boxes are disjoint, and
 * there are as many as there are different roots: each has exactly one.  A box is at most two units in the
 * last place wide, in units of its larger part; real roots are said to be real, and others are not.
 *
 * Breaks tried, each caught: the error of cut values left out; discs far too small; boxes that are points
 * about z - W; the wrong one of two conjugates taken for a root of p. */
#include "allroots_case.h"
#include "integer_polys.h"

/* ---- the judge ---- */

/* x is within 2^log of a root: is that in the interval? */
static int is_in(const mpf_t a, double log, algsurf_interval box) {
    mpf_t end, by;
    mpf_init2(end, mpf_get_prec(a)), mpf_init2(by, mpf_get_prec(a));
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

/* From x on: does the box have a root of p? */
static int leads_to_root(const poly *p, const algsurf_complex_root *e) {
    double before = 1e6, log = 0, size = fmax(fabs(e->root.re), fabs(e->root.im)), enough = log2(size) - 120;
    for (int k = 0; k < 60; k++) {
        log = step(p) + log2(p->degree) + 1;
        if (k > 8 && log > before) break;
        before = log;
        if (log < enough) break;
    }
    return log < enough && is_in(x.re, log + 1, e->box.re) && is_in(x.im, log + 1, e->box.im);
}

/* A place in the interval, its lower end, its upper end. */
static void set_start(mpf_t a, algsurf_interval part, double root, int which) {
    const double end = which > 1 ? part.hi : part.lo;
    mpf_set_d(a, which == 0 || isinf(end) ? root : end);
}

/* Does the box have a root of p? */
static int has_root(const poly *p, const algsurf_complex_root *e) {
    if (e->root.re == 0 && e->root.im == 0) return mpz_sgn(p->re[0]) == 0 && mpz_sgn(p->im[0]) == 0;
    for (int start = 0; start < 9; start++) { /* the first one does, as a rule */
        set_start(x.re, e->box.re, e->root.re, start % 3), set_start(x.im, e->box.im, e->root.im, start / 3);
        if (leads_to_root(p, e)) return 1;
    }
    return 0;
}

static double ulps(algsurf_interval part, double size) {
    return (part.hi - part.lo) / (nextafter(size, INFINITY) - size);
}

enum { FACTORS = 4 };

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
        for (int j = 0; j < i; j++) assert_false(case_meet(e[i].box, e[j].box));
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

/* Degrees to 320; roots are 2^-20 apart. */
TEST(orthogonal_ones) {
    static const int degree[] = {3, 7, 15, 31, 63, 127, 160, 320};
    for (int i = 0; i < 8; i++) {
        const int n = degree[i];
        set_precision(1024);
        judge_one("Chebyshev", orthogonal(CHEBYSHEV, n), n);
        if (n > 160) continue;
        judge_one("Legendre", legendre(n), n);
        judge_one("Hermite", orthogonal(HERMITE, n), n);
        judge_one("Laguerre", orthogonal(LAGUERRE, n), n);
    }
}

TEST(wilkinsons) {
    for (int n = 10; n <= 160; n *= 2) {
        poly *q = make(0);
        mpz_set_ui(q->re[0], 1);
        for (int k = 1; k <= n && n < 160; k++) q = times_root(q, k, (k * 7) % 5 - 2, 1);
        set_precision(1024);
        judge_one("Wilkinson", wilkinson(n), n);
        judge_one("Wilkinson's, some of them complex", q, n < 160 ? n / 5 : 0);
    }
}

TEST(sparse) {
    static const int degree[] = {5, 17, 53, 161, 512};
    for (int i = 0; i < 5; i++) {
        const int n = degree[i];
        poly *p = make(n), *q = make(n);
        mpz_set_ui(p->re[n], 1), mpz_set_si(p->re[0], -1);
        mpz_set_ui(q->re[n], 1), mpz_set_si(q->im[0], -1);
        set_precision(512);
        judge_one("z^n - 1", p, n % 2 ? 1 : 2);
        judge_one("z^n - i", q, 0);
        set_precision(1024);
        if (n < 200) judge_one("exp", exponential(n), n % 2);
    }
}

TEST(mandelbrots) {
    for (int k = 5; k <= 9; k++) { /* degrees 15 to 255 */
        set_precision(1024);
        judge_one("Mandelbrot", mandelbrot(k), -1);
    }
}

/* Pairs of real roots, and of complex ones. */
TEST(close_pairs) {
    set_precision(4096);
    for (int n = 8; n <= 128; n *= 4)
        for (long a = 3; a <= (1L << 26) + 1; a = a * 4096 + 1) {
            double gap = -(n / 2.0 + 1) * log2((double)a) + log2((double)a);
            if (gap < -51) continue; /* doubles do not tell them apart */
            judge_one("Mignotte", mignotte(n, a, 1), -1);
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

/* (c^2 z^2 - 3)^2 + c^2 z^9 (Kameny): two pairs of complex roots about c^-4.5 apart. */
TEST(kameny) {
    for (long c = 10; c <= 1000; c *= 10) {
        poly *p = make(9);
        mpz_set_ui(p->re[0], 9), mpz_set_si(p->re[2], -6 * c * c), mpz_set_si(p->re[4], c * c * c * c);
        mpz_set_si(p->re[9], c * c);
        judge_one("Kameny", p, -1);
    }
}

/* (16 z^4 - 1)^n (z^4 - (1/2 + 2^-12)^4) (Kirrinnis): a simple root near each of four multiple ones. */
TEST(kirrinnis) {
    set_precision(1024);
    for (int n = 10; n <= 40; n *= 2) {
        poly *f = make(4), *g = make(4), *p = make(4);
        mpz_set_ui(f->re[4], 16), mpz_set_si(f->re[0], -1);
        mpz_set_ui(g->re[4], 1UL << 48), mpz_ui_pow_ui(g->re[0], 2049, 4), mpz_neg(g->re[0], g->re[0]);
        for (int k = 0; k <= 4; k++) mpz_set(p->re[k], g->re[k]);
        for (int k = 0; k < n; k++) {
            poly *q = product(p, f);
            drop(p);
            p = q;
        }
        judge("Kirrinnis", p, (const poly *const[FACTORS]){f, g}, (const int[FACTORS]){n, 1}, 4);
        drop(f), drop(g), drop(p);
    }
}

/* det(z - T), T an n x n Toeplitz matrix with -1 below the diagonal, and a[0], a[1] .. on it and above. */
static poly *toeplitz(const long *a, int bands, int n) {
    poly *p[MOST + 1];
    p[0] = make(0);
    mpz_set_ui(p[0]->re[0], 1);
    for (int k = 1; k <= n; k++) {
        p[k] = make(k);
        for (int i = 0; i < k; i++) mpz_set(p[k]->re[i + 1], p[k - 1]->re[i]);
        for (int j = 0; j < bands && j < k; j++)
            for (int i = 0; i < k - j; i++) {
                if ((a[j] > 0) == (j % 2 == 0))
                    mpz_submul_ui(p[k]->re[i], p[k - 1 - j]->re[i], (unsigned long)labs(a[j]));
                else
                    mpz_addmul_ui(p[k]->re[i], p[k - 1 - j]->re[i], (unsigned long)labs(a[j]));
            }
    }
    for (int k = 0; k < n; k++) drop(p[k]);
    return p[n];
}

/* Grcar's matrix, and one with larger entries: eigenvalues that rounding of the matrix would move far. */
TEST(toeplitz_ones) {
    static const long grcar[] = {1, 1, 1, 1}, other[] = {2, -3, 5, 0, 7};
    set_precision(1024);
    for (int n = 16; n <= 128; n *= 2) {
        judge_one("Toeplitz", toeplitz(grcar, 4, n), -1);
        judge_one("Toeplitz", toeplitz(other, 5, n), -1);
    }
}

/* Roots 2^-k apart at rational places, some of them doubles, where the conjugate's value is small. */
TEST(clusters) {
    for (int k = 10; k <= 40; k += 10)
        for (int size = 2; size <= 12; size += 5) {
            poly *p = make(0);
            const long wide = 1L << k;
            mpz_set_ui(p->re[0], 1);
            for (int i = 0; i < size; i++)
                p = times_root(p, wide / 3 + i, i % 3, wide), p = times_root(p, -wide - i, 0, wide);
            poly *f[FACTORS] = {p, make(0)};
            mpz_set_ui(f[1]->re[0], 1);
            f[1] = times_root(times_root(f[1], 5, 0, 1), 6, 1, 1);
            poly *q = product(p, f[1]), *r = product(q, f[1]);
            const int reals = size + (size + 2) / 3;
            judge("clusters and double roots", r, (const poly *const *)f, (const int[FACTORS]){1, 2},
                  reals + 1);
            drop(f[1]), drop(q), drop(r);
            judge_one("clusters", p, reals);
        }
}

/* Which roots of (1 + i) (z^2 - 2) (z - i)^zeros (z - 1), or of that and 2^-e i, are real: doubles are not
 * asked where a box meets the axis. */
TEST(real_roots_of_complex_doubles) {
    for (int e = 0; e <= 50; e += 5)
        for (int zeros = 0; zeros < 30; zeros += 7) {
            algsurf_complex c[40] = {{-2, -2}, {0, 0}, {1, 1}};
            algsurf_complex_root root[40];
            int n = 2, count, reals = 0;
            for (int k = 0; k <= zeros; k++, n++) /* times z - a - ib, exactly: (z - 1) apart from the rest */
                for (int j = n + 1; j >= 0; j--) {
                    const algsurf_complex up = j > 0 ? c[j - 1] : (algsurf_complex){0, 0};
                    const algsurf_complex by = k < zeros ? (algsurf_complex){0, 1} : (algsurf_complex){1, 0};
                    c[j] = (algsurf_complex){up.re - by.re * c[j].re + by.im * c[j].im,
                                             up.im - by.re * c[j].im - by.im * c[j].re};
                }
            const int off =
                e > 0 && zeros == 0; /* the last root moves, and with it the others: none is real */
            if (off) c[0].im += ldexp(1, -e);
            assert_ok(algsurf_complex_roots(c, NULL, n, root, &count));
            for (int i = 0; i < count; i++) {
                reals += root[i].real;
                assert_true(!root[i].real || (root[i].box.im.lo == 0 && root[i].box.im.hi == 0));
            }
            assert_int_equal(reals, off ? 0 : 3);
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

/* Products with multiplicities, of real and of Gaussian factors, which may share roots with their conjugates.
 */
TEST(multiple) {
    for (int round = 0; round < 60; round++) {
        poly *f[FACTORS] = {NULL};
        const int m[FACTORS] = {1, 2, 3, 5};
        poly *p = random_product(round % 2, 0, m, f);
        judge("multiple roots", p, (const poly *const *)f, m, -1);
        for (int i = 0; i < FACTORS && f[i]; i++) drop(f[i]);
        drop(p);
    }
}

/* z^zeros q(z^2). */
static poly *in_squares(const poly *q, int zeros) {
    poly *p = make(2 * q->degree + zeros);
    for (int k = 0; k <= q->degree; k++)
        mpz_set(p->re[2 * k + zeros], q->re[k]), mpz_set(p->im[2 * k + zeros], q->im[k]);
    return p;
}

static void judge_in_squares(const char *name, poly *q, int real) {
    poly *p = in_squares(q, 0);
    judge_one(name, in_squares(q, 1), real < 0 ? real : real + 1);
    judge_one(name, in_squares(p, 0), -1);
    judge_one(name, p, real);
    drop(q);
}

/* Those that begin at square roots: of positive and negative numbers, of clusters and pairs, of numbers of
 * very different sizes and next to 0, with and without the root 0, of multiple roots. */
TEST(polynomials_of_squares) {
    set_precision(2048);
    judge_in_squares("Wilkinson's", wilkinson(40), 80);
    judge_in_squares("Toeplitz' of", toeplitz((const long[]){1, 1, 1, 1}, 4, 40), -1);
    judge_in_squares("Mandelbrot's of", mandelbrot(6), -1);
    for (int side = -1; side <= 1; side += 2) {
        poly *p = make(0), *q = make(0);
        mpz_set_ui(p->re[0], 1), mpz_set_ui(q->re[0], 1);
        for (int i = 0; i < 12; i++) {
            p = times_root(p, side * ((1L << 40) / 3 + i), 0, 1L << 40);
            q = times_root(q, side * (1L << (5 * i)), i % 3, 1L << 30);
        }
        judge_in_squares("a cluster of", p, side > 0 ? 24 : 0);
        judge_in_squares("2^5k of", q, -1);
    }
    for (int round = 0; round < 40; round++) {
        poly *f[FACTORS] = {NULL}, *g[FACTORS] = {NULL};
        const int m[FACTORS] = {1, 2, 3, 5};
        poly *q = random_product(round % 2, 0, m, f), *p = in_squares(q, 0);
        if (mpz_sgn(p->re[0]) || mpz_sgn(p->im[0])) {
            for (int i = 0; i < FACTORS && f[i]; i++) g[i] = in_squares(f[i], 0);
            judge("multiple roots of", p, (const poly *const *)g, m, -1);
        }
        for (int i = 0; i < FACTORS && f[i]; i++) {
            drop(f[i]);
            if (g[i]) drop(g[i]);
        }
        drop(p), drop(q);
    }
}

/* ((z - 7/3 - i/3) (z - 14/3 - i/3) ...)^5: that this is not 0 at its roots' conjugates is seen only from
 * places far narrower than doubles, as it is small there beside its terms. */
TEST(conjugates_are_told_apart) {
    for (int roots = 2; roots <= 8; roots += 3) {
        poly *f[FACTORS] = {make(0)}, *p = make(0);
        const int m[FACTORS] = {5};
        mpz_set_ui(f[0]->re[0], 1), mpz_set_ui(p->re[0], 1);
        for (int k = 1; k <= roots; k++) f[0] = times_root(f[0], 7 * k, 1, 3);
        for (int k = 0; k < 5; k++) {
            poly *q = product(p, f[0]);
            drop(p);
            p = q;
        }
        judge("conjugates", p, (const poly *const *)f, m, 0);
        drop(f[0]), drop(p);
    }
}

/* Dense ones, of integers of very different sizes. */
TEST(random_ones) {
    set_precision(1024);
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
    set_precision(1024);
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

/* s t (a - s t + 2^-w t^2) has a root just beyond s a, a double, and 0: of neighbours of s a the box has
 * those that the root is between, also among the last numbers above 0 and the largest ones. */
TEST(beside_doubles_of_all_sizes) {
    static const int places[][2] = {{-1074, 0}, {-1073, 0},  {-1040, 0},  {-950, 0},
                                    {0, 200},   {950, 1200}, {1000, 1200}};
    set_precision(4096);
    for (size_t i = 0; i < 4 * sizeof places / sizeof *places; i++) {
        const int e = places[i / 4][0], w = places[i / 4][1], m = i & 1 ? 3 : 1, s = i & 2 ? -1 : 1;
        const mp_bitcnt_t up = (mp_bitcnt_t)(e < -w ? -e : w);
        const double a = ldexp(m, e);
        algsurf_complex_root root[3];
        algsurf_integer c[4];
        int count, found = 0;
        poly *p = make(3);
        mpz_set_si(p->re[1], s * m), mpz_mul_2exp(p->re[1], p->re[1], (mp_bitcnt_t)((int)up + e));
        mpz_set_si(p->re[2], -1), mpz_mul_2exp(p->re[2], p->re[2], up);
        mpz_set_si(p->re[3], s), mpz_mul_2exp(p->re[3], p->re[3], up - (mp_bitcnt_t)w);
        integers(p->re, 3, c);
        assert_int_equal(algsurf_complex_roots_integers(c, NULL, 3, root, &count), ALGSURF_OK);
        assert_int_equal(count, 3);
        for (int k = 0; k < 3; k++) {
            const algsurf_interval box = root[k].box.re;
            assert_true(root[k].real && root[k].multiplicity == 1);
            if (s < 0)
                found += box.hi == -a && box.lo == nextafter(-a, -INFINITY);
            else
                found += box.lo == a && box.hi == nextafter(a, INFINITY);
        }
        if (!found) fail_msg("%d 2^%d, s = %d", m, e, s);
        drop(p);
    }
}

/* z (i s m 2^e - z): a root with a real part of 0 is exact, and told from the root 0, down to the last
 * numbers above 0; of doubles and of integers. */
TEST(imaginary_ones) {
    for (int i = 0; i < 24; i++) {
        static const int places[] = {-1074, -1073, -1060, -900, 0, 970};
        const int e = places[i / 4], m = i & 1 ? 3 : 1, s = i & 2 ? -1 : 1;
        const double a = s * ldexp(m, e);
        const algsurf_complex c[3] = {{0, 0}, {0, a}, {-1, 0}};
        algsurf_integer re[3], im[3];
        algsurf_complex_root root[2];
        int count;
        poly *p = make(2);
        mpz_set_si(p->re[2], -1), mpz_mul_2exp(p->re[2], p->re[2], e < 0 ? (mp_bitcnt_t)-e : 0);
        mpz_set_si(p->im[1], s * m), mpz_mul_2exp(p->im[1], p->im[1], e < 0 ? 0 : (mp_bitcnt_t)e);
        integers(p->re, 2, re), integers(p->im, 2, im);
        for (int kind = 0; kind < 2; kind++) {
            assert_int_equal(kind ? algsurf_complex_roots_integers(re, im, 2, root, &count)
                                  : algsurf_complex_roots(c, NULL, 2, root, &count),
                             ALGSURF_OK);
            assert_int_equal(count, 2);
            const algsurf_cinterval box = root[s > 0].box; /* sorted by im */
            if (!(box.re.lo == 0 && box.re.hi == 0 && box.im.lo == a && box.im.hi == a))
                fail_msg("%d 2^%d, kind %d: [%a, %a] + i [%a, %a]", s * m, e, kind, box.re.lo, box.re.hi,
                         box.im.lo, box.im.hi);
        }
        drop(p);
    }
}

/* (z - a/2)^3 = i (1 + 2^-e i) 2^-m: two of the roots are on either side of a double in the real part, less
 * than a unit from it, and differ in the imaginary part by 2^-e of it. */
TEST(apart_in_the_smaller_part) {
    set_precision(4096);
    for (int round = 0; round < 60; round++) {
        const int e = 20 + random_below(28), m = 150 + random_below(9), turned = round & 1;
        poly *p = make(0);
        mpz_set_ui(p->re[0], 1);
        for (int k = 0; k < 3; k++) p = times_root(p, 9 + 2 * (round % 3), 0, 2);
        for (int k = 0; k <= 3; k++) mpz_mul_2exp(p->re[k], p->re[k], (mp_bitcnt_t)(m - 3 + e));
        mpz_set_si(p->im[0], turned ? 1 : -1), mpz_mul_2exp(p->im[0], p->im[0], (mp_bitcnt_t)e);
        mpz_add_ui(p->re[0], p->re[0], 1);
        judge_one("apart in the smaller part", p, 0);
    }
}

/* 2^e + i 2^-k, and 2^e - i 2^-k or 2^e + 2 i 2^-k, up to the whole range of doubles apart in size. */
TEST(parts_of_all_sizes) {
    static const int places[][2] = {{0, 400}, {500, 400}, {1000, 400}, {1000, 1000}, {1020, 1070}};
    for (int i = 0; i < 10; i++) {
        const int e = places[i / 2][0], k = places[i / 2][1], other = i % 2 ? 2 : -1;
        algsurf_integer re[3], im[3];
        algsurf_complex_root root[2];
        int count;
        poly *p = make(0);
        mpz_set_ui(p->re[0], 1);
        for (int j = 0; j < 2; j++) { /* 2^k (z - 2^e) - i, or other than i */
            poly *f = make(1), *q;
            mpz_set_ui(f->re[1], 1), mpz_mul_2exp(f->re[1], f->re[1], (mp_bitcnt_t)k);
            mpz_set_si(f->re[0], -1), mpz_mul_2exp(f->re[0], f->re[0], (mp_bitcnt_t)(k + e));
            mpz_set_si(f->im[0], j ? -other : -1);
            q = product(p, f);
            drop(p), drop(f);
            p = q;
        }
        integers(p->re, 2, re), integers(p->im, 2, im);
        assert_int_equal(algsurf_complex_roots_integers(re, is_real(p) ? NULL : im, 2, root, &count),
                         ALGSURF_OK);
        if (count != 2) fail_msg("2^%d, i 2^-%d, %d times that: %d", e, k, other, count);
        const double a = ldexp(1, e), b = ldexp(1, -k);
        int found = 0;
        for (int j = 0; j < 2; j++) {
            const algsurf_cinterval box = root[j].box;
            assert_true(box.re.lo <= a && box.re.hi >= a && root[j].multiplicity == 1);
            found |=
                (box.im.lo <= b && box.im.hi >= b) + 2 * (box.im.lo <= other * b && box.im.hi >= other * b);
        }
        assert_int_equal(found, 3);
        drop(p);
    }
}

/* Arguments, and the root 0. */
TEST(the_interface) {
    const uint64_t two_limb = 2, zero = 0;
    const algsurf_integer c[3] = {{&zero, 1}, {&two_limb, -1}, {&two_limb, 1}},
                          nothing[2] = {{NULL, 0}, {&zero, 1}};
    static const uint64_t zeros[ALGSURF_MAX_LIMBS + 1];
    const algsurf_integer bad[1] = {{NULL, 1}}, huge[1] = {{zeros, ALGSURF_MAX_LIMBS + 1}};
    algsurf_complex_root e[2];
    int count = -1;
    assert_int_equal(algsurf_complex_roots_integers(NULL, NULL, 2, e, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(c, NULL, -1, e, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(c, NULL, 2, NULL, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(c, NULL, 2, e, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(bad, NULL, 0, e, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(huge, NULL, 0, e, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(huge, c + 1, 0, e, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_integers(c + 1, huge, 0, e, &count), ALGSURF_E_ARGUMENT);
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
    set_precision(4096);
    int failed = unit_run("complex roots of families");
    end_precision();
    return failed;
}
