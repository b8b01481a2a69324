/* test_precise_roots.c - complex roots of integer polynomials to hundreds and thousands of bits.
 *
 * The judge, as in test_complex_families.c: from the middle of a box Newton's method makes |p/p'| small, and
 * a root is within n |p/p'| of the point (Laguerre), which has to be in the box.  As many disjoint boxes as
 * there are different roots, in each of which there is one, have one each.
 *
 * Breaks tried, each caught: z in place of z - W; radii 2^-12 of theirs; conjugates said to be real; roots of
 * the conjugate polynomial kept; a conjugate with the root's multiplicity; roots that two factors share. */
#include "integer_polys.h"

static void set_integer(mpf_t a, algsurf_integer z, int exponent) {
    mpz_t w;
    mpz_init(w);
    mpz_import(w, (size_t)abs(z.length), -1, sizeof *z.limbs, 0, 0, z.limbs);
    if (z.length < 0) mpz_neg(w, w);
    mpf_set_z(a, w);
    if (exponent < 0)
        mpf_div_2exp(a, a, (mp_bitcnt_t)-exponent);
    else
        mpf_mul_2exp(a, a, (mp_bitcnt_t)exponent);
    mpz_clear(w);
}

/* |a - b| <= by. */
static int within(const mpf_t a, const mpf_t b, const mpf_t by) {
    mpf_t w;
    mpf_init2(w, mpf_get_prec(a));
    mpf_sub(w, a, b), mpf_abs(w, w);
    int answer = mpf_cmp(w, by) <= 0;
    mpf_clear(w);
    return answer;
}

static double log_of(const mpf_t a) {
    long e;
    double m = mpf_get_d_2exp(&e, a);
    return m == 0 ? -INFINITY : log2(fabs(m)) + (double)e;
}

/* A root as numbers. */
typedef struct box {
    mpf_t re, im, radius;
} box;

static void take_box(box *b, const algsurf_precise_root *r) {
    const unsigned long bits = mpf_get_prec(x.re);
    mpf_init2(b->re, bits), mpf_init2(b->im, bits), mpf_init2(b->radius, bits);
    const uint64_t radius = (uint64_t)r->radius;
    assert_true(r->radius >= 0);
    set_integer(b->re, r->re, r->exponent), set_integer(b->im, r->im, r->exponent);
    set_integer(b->radius, (algsurf_integer){&radius, 1}, r->exponent);
}

static void drop_box(box *b) { mpf_clears(b->re, b->im, b->radius, NULL); }

/* Does the box have a root of p?  A box that is a point: exactly there. */
static int has_root(const poly *p, const box *b) {
    mpf_set(x.re, b->re), mpf_set(x.im, b->im);
    if (mpf_sgn(b->radius) == 0) {
        values(p);
        return mpf_sgn(v.re) == 0 && mpf_sgn(v.im) == 0;
    }
    double log = 0, enough = log_of(b->radius) - 20;
    for (int k = 0; k < 40; k++) {
        log = step(p) + log2(p->degree) + 1;
        if (log < enough) break;
    }
    if (!(log < enough)) return 0;
    mpf_t by;
    mpf_init2(by, mpf_get_prec(x.re));
    mpf_div_ui(by, b->radius, 1 << 19), mpf_sub(by, b->radius, by);
    int answer = within(x.re, b->re, by) && within(x.im, b->im, by);
    mpf_clear(by);
    return answer;
}

static int meet(const box *a, const box *b) {
    mpf_t by;
    mpf_init2(by, mpf_get_prec(a->re));
    mpf_add(by, a->radius, b->radius);
    int answer = within(a->re, b->re, by) && within(a->im, b->im, by);
    mpf_clear(by);
    return answer;
}

enum { FACTORS = 4 };

/* The roots of the product p of factors f[i]^m[i], squarefree and without common roots. */
static void judge(const char *name, poly *p, const poly *const *f, const int *m, int bits) {
    static algsurf_integer re[MOST + 1], im[MOST + 1];
    static box boxes[MOST];
    algsurf_precise_roots *roots;
    int left[FACTORS] = {0}, different = 0, sum = 0, real = is_real(p);
    integers(p->re, p->degree, re), integers(p->im, p->degree, im);
    algsurf_status status = algsurf_precise_roots_create(re, real ? NULL : im, p->degree, bits, 0, &roots);
    if (status != ALGSURF_OK)
        fail_msg("%s, seed %llu: %s", name, (unsigned long long)seed, algsurf_status_text(status));
    for (int i = 0; i < FACTORS && f[i]; i++) different += left[i] = f[i]->degree;
    const int count = algsurf_precise_roots_count(roots);
    if (count != different) fail_msg("%s: %d entries for %d roots", name, count, different);
    for (int i = 0; i < count; i++) {
        algsurf_precise_root r;
        assert_int_equal(algsurf_precise_roots_get(roots, i, &r), ALGSURF_OK);
        box *b = boxes + i;
        take_box(b, &r);
        sum += r.multiplicity;
        double most = fmax(log_of(b->re), log_of(b->im));
        if (log_of(b->radius) > most - bits) fail_msg("%s: root %d is wide", name, i);
        assert_true(!r.real || r.im.length == 0);
        if (i > 0) {
            int order = mpf_cmp(boxes[i - 1].re, b->re);
            assert_true(order < 0 || (order == 0 && mpf_cmp(boxes[i - 1].im, b->im) < 0));
        }
        for (int j = 0; j < i; j++) assert_false(meet(b, boxes + j));
        int found = 0, mates = 0;
        for (int k = 0; k < FACTORS && f[k]; k++)
            if (m[k] == r.multiplicity && left[k] > 0 && has_root(f[k], b)) found++, left[k]--;
        if (found != 1) fail_msg("%s: root %d, %d times: %d factors have it", name, i, r.multiplicity, found);
        if (!real) continue;
        assert_true(r.real || mpf_sgn(b->im) != 0);
        mpf_neg(b->im, b->im);
        for (int j = 0; j < i; j++) mates += !mpf_cmp(boxes[j].re, b->re) && !mpf_cmp(boxes[j].im, b->im);
        mpf_neg(b->im, b->im);
        if (mpf_sgn(b->im) > 0) assert_int_equal(mates, 1);
    }
    assert_int_equal(sum, p->degree);
    for (int i = 0; i < count; i++) drop_box(boxes + i);
    algsurf_precise_roots_free(roots);
}

static void judge_one(const char *name, poly *p, int bits) {
    const poly *const f[FACTORS] = {p};
    const int m[FACTORS] = {1};
    judge(name, p, f, m, bits);
    drop(p);
}

TEST(families) {
    static const int bits[] = {1, 53, 64, 200, 1500};
    for (int i = 0; i < 5; i++) {
        set_precision((unsigned long)(2 * bits[i] + 4096));
        judge_one("Chebyshev", orthogonal(CHEBYSHEV, 40), bits[i]);
        judge_one("Laguerre", orthogonal(LAGUERRE, 25), bits[i]);
        judge_one("Legendre", legendre(31), bits[i]);
        judge_one("Wilkinson", wilkinson(30), bits[i]);
        judge_one("exp", exponential(33), bits[i]);
        judge_one("Mandelbrot", mandelbrot(6), bits[i]);
        judge_one("Mignotte", mignotte(20, 1L << 20, 1), bits[i]);
        judge_one("Mignotte", mignotte(33, 12345, 1), bits[i]);
    }
}

/* Random ones: real and Gaussian, of sizes that differ, and with multiple roots, some of them conjugates. */
TEST(random_ones) {
    for (int round = 0; round < 30; round++) {
        const int n = 1 + random_below(30), complex = round % 2, bits = 1 + random_below(900);
        poly *p = make(n);
        for (int k = 0; k <= n; k++)
            for (int i = 0; i <= complex; i++) {
                mpz_t *c = i ? p->im + k : p->re + k;
                mpz_set_si(*c, random_below(2000) - 999);
                if (round % 3 == 2) mpz_mul_2exp(*c, *c, (mp_bitcnt_t)random_below(300));
            }
        if (mpz_sgn(p->re[n]) == 0) mpz_set_ui(p->re[n], 1);
        if (mpz_sgn(p->re[0]) == 0) mpz_set_ui(p->re[0], 1);
        set_precision((unsigned long)(2 * bits + 6000));
        judge_one("random", p, bits);
    }
    for (int round = 0; round < 40; round++) {
        poly *f[FACTORS] = {NULL};
        const int m[FACTORS] = {1, 2, 3, 5};
        poly *p = random_product(round % 2, 1, m, f);
        set_precision(6000);
        judge("multiple roots", p, (const poly *const *)f, m, 1 + random_below(400));
        for (int i = 0; i < FACTORS && f[i]; i++) drop(f[i]);
        drop(p);
    }
}

/* p times (3 2^k z - (2^k + 3 (a + ib))): the root 1/3 + (a + ib) 2^-k. */
static poly *times_close_root(poly *p, int k, int a, int b) {
    poly *f = make(1);
    mpz_set_si(f->re[1], 3), mpz_mul_2exp(f->re[1], f->re[1], (mp_bitcnt_t)k);
    mpz_set_si(f->re[0], -1), mpz_mul_2exp(f->re[0], f->re[0], (mp_bitcnt_t)k);
    mpz_sub_ui(f->re[0], f->re[0], 3 * (unsigned)a);
    mpz_set_si(f->im[0], -3 * b);
    poly *q = product(p, f);
    drop(f), drop(p);
    return q;
}

/* Roots of different factors, closer than the bits asked for tell: a double one and a simple one; a real one
 * and a complex one, both simple, beside a double one far away. */
TEST(close_roots_of_different_factors) {
    static const int gap[] = {20, 100, 300};
    for (int i = 0; i < 3; i++)
        for (int complex = 0; complex < 2; complex++) {
            poly *f[FACTORS] = {make(0), make(0)};
            const int m[FACTORS] = {1, 2};
            mpz_set_ui(f[0]->re[0], 1), mpz_set_ui(f[1]->re[0], 1);
            f[0] = times_close_root(f[0], gap[i], !complex, complex);
            if (complex) f[0] = times_root(f[0], 1, 0, 3);
            f[1] = complex ? times_root(f[1], 5, 1, 1) : times_root(f[1], 1, 0, 3);
            poly *square = product(f[1], f[1]), *p = product(square, f[0]);
            set_precision(4096);
            judge("close roots", p, (const poly *const *)f, m, 2);
            drop(f[0]), drop(f[1]), drop(square), drop(p);
        }
}

/* Roots with conjugates of another multiplicity, or of the same, beside real ones and single ones. */
TEST(conjugates_of_other_multiplicities) {
    static const struct {
        int factor, a, b, d;
    } root[] = {{0, 1, 2, 1}, {1, 1, -2, 1}, {2, 0, 1, 3},  {0, 0, -1, 3}, {1, -4, 1, 2}, {1, -4, -1, 2},
                {2, 5, 0, 7}, {0, 9, 0, 1},  {1, -2, 0, 1}, {0, 3, 3, 1},  {2, 2, -7, 1}, {0, -1, 1, 5}};
    const int m[FACTORS] = {1, 2, 3};
    for (int bits = 1; bits <= 400; bits *= 20)
        for (int most = 2; most <= 12; most++) {
            poly *f[FACTORS] = {NULL}, *p = make(0);
            mpz_set_ui(p->re[0], 1);
            for (int i = 0; i < 3; i++) f[i] = make(0), mpz_set_ui(f[i]->re[0], 1);
            for (int i = 0; i < most; i++) {
                f[root[i].factor] = times_root(f[root[i].factor], root[i].a, root[i].b, root[i].d);
                for (int k = 0; k < m[root[i].factor]; k++)
                    p = times_root(p, root[i].a, root[i].b, root[i].d);
            }
            set_precision(4096);
            judge("conjugates", p, (const poly *const *)f, m, bits);
            for (int i = 0; i < 3; i++) drop(f[i]);
            drop(p);
        }
}

/* 2 to 20 roots 2^-30 to 2^-300 apart, real and complex ones, and others far away. */
TEST(clusters) {
    static const int gap[] = {30, 100, 300};
    for (int i = 0; i < 3; i++)
        for (int size = 2; size <= 20; size += 6)
            for (int complex = 0; complex < 2; complex++) {
                poly *p = wilkinson(5);
                for (int k = 0; k < size; k++) p = times_close_root(p, gap[i], k, complex ? k * k % 7 : 0);
                set_precision((unsigned long)(4096 + 2 * size * gap[i]));
                judge_one("cluster", p, 53);
            }
}

/* The square root of 2 to 100,000 bits, beside GMP's; and exact ones. */
TEST(many_bits) {
    enum { MANY = 100000 };
    const uint64_t one = 1, two = 2;
    const algsurf_integer c[4] = {{&two, -1}, {NULL, 0}, {&one, 1}, {&one, 1}};
    algsurf_precise_roots *roots;
    algsurf_precise_root r;
    box b;
    set_precision(MANY + 200);
    assert_int_equal(algsurf_precise_roots_create(c, NULL, 2, MANY, 0, &roots), ALGSURF_OK);
    assert_int_equal(algsurf_precise_roots_count(roots), 2);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(algsurf_precise_roots_get(roots, i, &r), ALGSURF_OK);
        assert_true(r.real && r.multiplicity == 1 && r.radius > 0);
        take_box(&b, &r);
        mpf_sqrt_ui(x.re, 2);
        if (i == 0) mpf_neg(x.re, x.re);
        assert_true(within(x.re, b.re, b.radius));
        assert_true(log_of(b.radius) < -MANY + 1);
        drop_box(&b);
    }
    algsurf_precise_roots_free(roots);
    assert_int_equal(algsurf_precise_roots_create(c + 1, NULL, 2, MANY, 0, &roots), ALGSURF_OK); /* z + z^2 */
    assert_int_equal(algsurf_precise_roots_count(roots), 2);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(algsurf_precise_roots_get(roots, i, &r), ALGSURF_OK);
        assert_true(r.radius == 0 && r.real && r.im.length == 0 && abs(r.re.length) == 1 - i);
    }
    assert_int_equal(algsurf_precise_roots_get(roots, 2, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_precise_roots_get(roots, -1, &r), ALGSURF_E_ARGUMENT);
    algsurf_precise_roots_free(roots);
}

TEST(bad_arguments) {
    const uint64_t one = 1;
    const uint64_t two = 2;
    const algsurf_integer c[3] = {{&one, 1}, {NULL, 0}, {&one, 1}}, none = {NULL, 0};
    const algsurf_integer square[3] = {{&two, -1}, {NULL, 0}, {&one, 1}};
    algsurf_precise_roots *roots = NULL;
    algsurf_precise_root r;
    assert_int_equal(algsurf_precise_roots_create(NULL, NULL, 2, 64, 0, &roots), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_precise_roots_create(c, NULL, 2, 64, 0, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_precise_roots_create(c, NULL, -1, 64, 0, &roots), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_precise_roots_create(c, NULL, 2, 0, 0, &roots), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_precise_roots_create(c, NULL, 2, ALGSURF_MAX_ROOT_BITS + 1, 0, &roots),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_precise_roots_create(&none, NULL, 0, 64, 0, &roots), ALGSURF_E_ZERO);
    assert_int_equal(algsurf_precise_roots_create(square, NULL, 2, 100000, 4096, &roots),
                     ALGSURF_E_NO_MEMORY);
    assert_null(roots);
    assert_int_equal(algsurf_precise_roots_count(NULL), 0);
    assert_int_equal(algsurf_precise_roots_get(NULL, 0, &r), ALGSURF_E_ARGUMENT);
    algsurf_precise_roots_free(NULL);
    assert_int_equal(algsurf_precise_roots_create(c, NULL, 0, 64, 0, &roots), ALGSURF_OK);
    assert_int_equal(algsurf_precise_roots_count(roots), 0);
    algsurf_precise_roots_free(roots);
}

int main(void) {
    set_precision(4096);
    int failed = unit_run("roots to many bits");
    end_precision();
    return failed;
}
