/* test_families.c - real roots of integer polynomials of named families, degrees to 512, each answer judged
 * by what is known of the family and by exact signs at the ends of its enclosures.
 *
 * As many different real roots as there are known to be, each in an enclosure of its own across which a
 * factor of the polynomial changes its sign: then every root is there, once.  The factor's power is the
 * multiplicity.
 *
 * Catches: roots lost or doubled in crowds, close pairs, far out, beside 0; multiplicities of products;
 * limbs. */
#include "exact_roots.h"
#include "integer_polys.h"

static int sign_at(const poly *p, double at) { return exact_integers_sign((mpz_t *)p->re, p->degree, at); }

/* All real roots of p are those of the factors, to the powers; they have `real` of them, all different. */
static void judge(const char *name, const poly *p, const poly *const *factor, const int *power, int factors,
                  int real) {
    static algsurf_real_root root[MOST];
    static algsurf_integer z[MOST + 1];
    int count = -1;
    integers((mpz_t *)p->re, p->degree, z);
    algsurf_status status =
        algsurf_real_roots_integers(z, p->degree, -HUGE_VAL, HUGE_VAL, root, MOST, &count);
    if (status != ALGSURF_OK || count != real)
        fail_msg("%s, degree %d: status %d, %d roots, not %d", name, p->degree, status, count, real);
    for (int i = 0, next; i < count; i = next) {
        const algsurf_real_root *r = root + i;
        int known = 0, told = 0;
        for (next = i; next < count && root[next].lo == r->lo && root[next].hi == r->hi; next++)
            told += root[next].multiplicity;
        for (int f = 0; f < factors; f++) {
            int before = sign_at(factor[f], r->lo), after = sign_at(factor[f], r->hi);
            known += (r->lo == r->hi ? before == 0 : before * after < 0) * power[f];
        }
        int good = next == i + 1 ? told == known : told % 2 == known % 2; /* several between two doubles */
        if (!good || (i > 0 && root[i - 1].hi > r->lo))
            fail_msg("%s, degree %d: root %d of multiplicity %d in [%a,%a]: it is %d", name, p->degree, i,
                     told, r->lo, r->hi, known);
        assert_true(r->lo <= r->root && r->root <= r->hi && r->hi <= nextafter(r->lo, HUGE_VAL));
    }
}

/* The same by the complex solver, if all coefficients are doubles: as many roots as the degree, those on the
 * axis real, across whose boxes p changes its sign. */
static void judge_complex(const char *name, const poly *p, int real) {
    static algsurf_complex c[MOST + 1];
    static algsurf_complex_root e[MOST];
    algsurf_complex_solver *solver;
    int count, sum = 0, found = 0, clusters = 0;
    for (int k = 0; k <= p->degree; k++) {
        c[k] = (algsurf_complex){mpz_get_d(p->re[k]), 0};
        if (mpz_cmp_d(p->re[k], c[k].re) != 0) return;
    }
    assert_ok(algsurf_complex_solver_create(p->degree, &solver));
    algsurf_status status = algsurf_complex_solver_run(solver, c, NULL, p->degree, NULL, e, &count, NULL);
    algsurf_complex_solver_free(solver);
    if (status != ALGSURF_OK) fail_msg("%s, degree %d: status %d", name, p->degree, status);
    for (int i = 0; i < count; i++) {
        sum += e[i].multiplicity;
        clusters += e[i].multiplicity > 1; /* roots closer than doubles can tell */
        if (!e[i].real || e[i].multiplicity > 1) continue;
        found++;
        int before = sign_at(p, e[i].box.re.lo), after = sign_at(p, e[i].box.re.hi);
        if (!(before * after < 0 || (before == 0 && after == 0)))
            fail_msg("%s, degree %d: no simple root in [%a,%a]", name, p->degree, e[i].box.re.lo,
                     e[i].box.re.hi);
    }
    if (sum != p->degree || found > real || (!clusters && found < real))
        fail_msg("%s, degree %d: %d roots, %d real, not %d", name, p->degree, sum, found, real);
}

enum { MOST_COMPLEX = 100 };

static void judge_simple(const char *name, poly *p, int real) {
    const poly *factor[1] = {p};
    judge(name, p, factor, (const int[]){1}, 1, real);
    if (p->degree <= MOST_COMPLEX) judge_complex(name, p, real);
    drop(p);
}

static poly *power(int n, long a) { /* x^n - a */
    poly *p = make(n);
    mpz_set_si(p->re[0], -a);
    mpz_set_ui(p->re[n], 1);
    return p;
}

static poly *powers_of_two(int n) { /* (x - 1) (2 x - 1) .. (2^(n-1) x - 1) */
    poly *p = make(n);
    mpz_t up;
    mpz_init(up);
    mpz_set_ui(p->re[0], 1);
    for (int k = 0; k < n; k++)
        for (int i = k + 1; i >= 0; i--) {
            mpz_mul_2exp(up, p->re[i > 0 ? i - 1 : 0], (mp_bitcnt_t)k);
            mpz_neg(p->re[i], p->re[i]);
            if (i > 0) mpz_add(p->re[i], p->re[i], up);
        }
    mpz_clear(up);
    return p;
}

TEST(test_orthogonal) {
    static const int degree[] = {1, 2, 3, 9, 32, 63, 64, 65, 128};
    for (size_t i = 0; i < sizeof degree / sizeof *degree; i++) {
        int n = degree[i];
        judge_simple("Chebyshev", orthogonal(CHEBYSHEV, n), n);
        judge_simple("Hermite", orthogonal(HERMITE, n), n);
        judge_simple("Laguerre", orthogonal(LAGUERRE, n), n);
        judge_simple("Legendre", legendre(n), n);
    }
    judge_simple("Chebyshev", orthogonal(CHEBYSHEV, 320), 320);
    judge_simple("Legendre", legendre(256), 256);
}

TEST(test_wilkinson) {
    for (int n = 10; n <= 160; n += 50) {
        judge_simple("Wilkinson", wilkinson(n), n);
        judge_simple("powers of two", powers_of_two(n), n);
    }
}

TEST(test_sparse) {
    for (int n = 3; n <= MOST; n += n < 16 ? 1 : 31) {
        judge_simple("x^n - 7", power(n, 7), n % 2 ? 1 : 2);
        judge_simple("x^n + 7", power(n, -7), n % 2);
        judge_simple("x^n - 1", power(n, 1), n % 2 ? 1 : 2);
        judge_simple("Mignotte, close", mignotte(n, 1 << 20, 2), n % 2 ? 3 : 4);
        if (n <= 200) judge_simple("Mignotte, closer", mignotte(n, 3, 2), n % 2 ? 3 : 4); /* 512 takes 10 s */
    }
}

/* (x^p - 1) / (x - 1) of a prime p has no real roots, but times others it is in their way. */
TEST(test_cyclotomic) {
    static const int prime[] = {3, 5, 17, 61, 127, 251, 509};
    for (size_t i = 0; i < sizeof prime / sizeof *prime; i++) {
        int n = prime[i] - 1;
        poly *p = make(n), *q = power(3, 2);
        for (int k = 0; k <= n; k++) mpz_set_ui(p->re[k], 1);
        if (n + 3 <= MOST) judge_simple("cyclotomic and a cube root", product(p, q), 1);
        drop(q);
        judge_simple("cyclotomic", p, 0);
    }
}

/* Roots in clusters of clusters: 2^-20 apart in groups that are 2^-8 apart. */
TEST(test_nested) {
    for (int gap = 12; gap <= 40; gap += 14) {
        poly *p = power(0, -1);
        for (int i = 0; i < 12; i++) {
            const long group = (long)(i / 4) << (gap + 6), pair = (long)(i / 2 % 2) << gap;
            p = times_root(p, group + pair + i % 2 + 5, 0, 1L << (gap + 10));
        }
        judge_simple("nested clusters", p, 12);
    }
}

TEST(test_products) {
    poly *a = legendre(12), *b = mignotte(9, 100, 2), *c = power(1, 3), *squares = product(a, a);
    poly *cubes = product(c, c), *p = product(squares, b), *all = product(cubes, c), *whole = product(p, all);
    const poly *factor[] = {a, b, c};
    judge("a square, Mignotte's and a cube", whole, factor, (const int[]){2, 1, 3}, 3, 12 + 3 + 1);
    poly *wider = product(whole, whole);
    judge("its square", wider, factor, (const int[]){4, 2, 6}, 3, 12 + 3 + 1);
    drop(wider), drop(whole), drop(all), drop(p), drop(cubes), drop(squares), drop(c), drop(b), drop(a);
}
