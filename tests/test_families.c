/* test_families.c - real roots of integer polynomials of named families, degrees to 512, each answer judged
 * by what is known of the family and by exact signs at the ends of its enclosures.
 *
 * As many different real roots as there are known to be, each in an enclosure of its own across which a
 * factor of the polynomial changes its sign: then every root is there, once.  The factor's power is the
 * multiplicity.
 *
 * Catches: roots lost or doubled in crowds, close pairs, far out, beside 0; multiplicities of products;
 * limbs. */
#include "algsurf/algsurf.h"
#include "exact_roots.h"
#include "exact_zpolys.h"
#include "unit.h"

enum { MOST = ALGSURF_MAX_POLY_DEGREE };

typedef exact_zpoly poly;

static poly *make(int degree) {
    poly *p = exact_zpoly_new();
    p->n = degree;
    return p;
}

static poly *product(const poly *a, const poly *b) {
    poly *p = exact_zpoly_new();
    exact_zpoly_multiply(p, a, b);
    return p;
}

static int sign_at(const poly *p, double x) { return exact_integers_sign((mpz_t *)p->c, p->n, x); }

/* All real roots of p are those of the factors, to the powers; they have `real` of them, all different. */
static void judge(const char *family, const poly *p, const poly *const *factor, const int *power, int factors,
                  int real) {
    static algsurf_real_root root[MOST];
    static algsurf_integer z[MOST + 1];
    int count = -1;
    for (int k = 0; k <= p->n; k++)
        z[k] = (algsurf_integer){(const uint64_t *)mpz_limbs_read(p->c[k]),
                                 mpz_sgn(p->c[k]) * (int)mpz_size(p->c[k])};
    algsurf_status status = algsurf_real_roots_integers(z, p->n, -HUGE_VAL, HUGE_VAL, root, MOST, &count);
    if (status != ALGSURF_OK || count != real)
        fail_msg("%s, degree %d: status %d, %d roots, not %d", family, p->n, status, count, real);
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
            fail_msg("%s, degree %d: root %d of multiplicity %d in [%a,%a]: it is %d", family, p->n, i, told,
                     r->lo, r->hi, known);
        assert_true(r->lo <= r->root && r->root <= r->hi && r->hi <= nextafter(r->lo, HUGE_VAL));
    }
}

/* The same by the complex solver, if all coefficients are doubles: as many roots as the degree, those on the
 * axis real, across whose boxes p changes its sign. */
static void judge_complex(const char *family, const poly *p, int real) {
    static algsurf_complex c[MOST + 1];
    static algsurf_complex_root e[MOST];
    algsurf_complex_solver *solver;
    int count, sum = 0, found = 0, clusters = 0;
    for (int k = 0; k <= p->n; k++) {
        c[k] = (algsurf_complex){mpz_get_d(p->c[k]), 0};
        if (mpz_cmp_d(p->c[k], c[k].re) != 0) return;
    }
    assert_ok(algsurf_complex_solver_create(p->n, &solver));
    algsurf_status status = algsurf_complex_solver_run(solver, c, NULL, p->n, NULL, e, &count, NULL);
    algsurf_complex_solver_free(solver);
    if (status != ALGSURF_OK) fail_msg("%s, degree %d: status %d", family, p->n, status);
    for (int i = 0; i < count; i++) {
        sum += e[i].multiplicity;
        clusters += e[i].multiplicity > 1; /* roots closer than doubles can tell */
        if (!e[i].real || e[i].multiplicity > 1) continue;
        found++;
        int before = sign_at(p, e[i].box.re.lo), after = sign_at(p, e[i].box.re.hi);
        if (!(before * after < 0 || (before == 0 && after == 0)))
            fail_msg("%s, degree %d: no simple root in [%a,%a]", family, p->n, e[i].box.re.lo,
                     e[i].box.re.hi);
    }
    if (sum != p->n || found > real || (!clusters && found < real))
        fail_msg("%s, degree %d: %d roots, %d real, not %d", family, p->n, sum, found, real);
}

enum { MOST_COMPLEX = 100 };

static void judge_simple(const char *family, poly *p, int real) {
    const poly *factor[1] = {p};
    judge(family, p, factor, (const int[]){1}, 1, real);
    if (p->n <= MOST_COMPLEX) judge_complex(family, p, real);
    exact_zpoly_free(p);
}

/* ---- the families ---- */

/* p_0 = 1, p_1 = first; m p_m = (a x + b) p_(m-1) - c p_(m-2) with what `step` says, times m! all over. */
typedef void step(int m, long *a, long *b, long *c, long *divisor);

static poly *recur(int n, step *how) {
    poly *before = make(0), *p = make(0);
    mpz_set_ui(p->c[0], 1);
    for (int m = 1; m <= n; m++) {
        poly *next = make(m);
        long a, b, c, divisor;
        mpz_t term;
        mpz_init(term);
        how(m, &a, &b, &c, &divisor);
        for (int k = 0; k <= m; k++) {
            if (k > 0) mpz_mul_si(next->c[k], p->c[k - 1], a);
            mpz_mul_si(term, p->c[k], b);
            mpz_add(next->c[k], next->c[k], term);
            mpz_mul_si(term, before->c[k], c);
            mpz_sub(next->c[k], next->c[k], term);
            if (divisor > 1) mpz_divexact_ui(next->c[k], next->c[k], (unsigned long)divisor);
        }
        mpz_clear(term);
        exact_zpoly_free(before);
        before = p;
        p = next;
    }
    exact_zpoly_free(before);
    return p;
}

static void chebyshev(int m, long *a, long *b, long *c, long *divisor) {
    *a = m > 1 ? 2 : 1, *b = 0, *c = 1, *divisor = 1;
}

static void hermite(int m, long *a, long *b, long *c, long *divisor) {
    *a = 2, *b = 0, *c = 2 * (m - 1), *divisor = 1;
}

static void laguerre(int m, long *a, long *b, long *c, long *divisor) { /* m! L_m */
    *a = -1, *b = 2 * m - 1, *c = (long)(m - 1) * (m - 1), *divisor = 1;
}

static void legendre(int m, long *a, long *b, long *c, long *divisor) { /* 2^m P_m, of integers */
    *a = 2 * (2 * m - 1), *b = 0, *c = 4 * (m - 1), *divisor = m;
}

static poly *power(int n, long a) { /* x^n - a */
    poly *p = make(n);
    mpz_set_si(p->c[0], -a);
    mpz_set_ui(p->c[n], 1);
    return p;
}

static poly *mignotte(int n, long a) { /* x^n - 2 (a x - 1)^2 */
    poly *p = make(n);
    mpz_set_ui(p->c[n], 1);
    mpz_set_si(p->c[0], -2);
    mpz_set_si(p->c[1], 4 * a);
    mpz_set_si(p->c[2], -2 * a * a);
    return p;
}

static poly *linear(long root, unsigned shift) { /* 2^shift x - root */
    poly *p = make(1);
    mpz_set_si(p->c[0], -root);
    mpz_set_ui(p->c[1], 1);
    mpz_mul_2exp(p->c[1], p->c[1], shift);
    return p;
}

static poly *of_roots(const long *root, const unsigned *shift, int count) {
    poly *p = make(0);
    mpz_set_ui(p->c[0], 1);
    for (int i = 0; i < count; i++) {
        poly *l = linear(root[i], shift[i]), *more = product(p, l);
        exact_zpoly_free(l);
        exact_zpoly_free(p);
        p = more;
    }
    return p;
}

TEST(test_orthogonal) {
    static const int degree[] = {1, 2, 3, 9, 32, 63, 64, 65, 128};
    for (size_t i = 0; i < sizeof degree / sizeof *degree; i++) {
        int n = degree[i];
        judge_simple("Chebyshev", recur(n, chebyshev), n);
        judge_simple("Hermite", recur(n, hermite), n);
        judge_simple("Laguerre", recur(n, laguerre), n);
        judge_simple("Legendre", recur(n, legendre), n);
    }
    judge_simple("Chebyshev", recur(320, chebyshev), 320);
    judge_simple("Legendre", recur(256, legendre), 256);
}

TEST(test_wilkinson) {
    for (int n = 10; n <= 160; n += 50) {
        long root[MOST];
        unsigned shift[MOST];
        for (int i = 0; i < n; i++) root[i] = i + 1, shift[i] = 0;
        judge_simple("Wilkinson", of_roots(root, shift, n), n);
        for (int i = 0; i < n; i++) root[i] = 1, shift[i] = (unsigned)i; /* 2^-i */
        judge_simple("powers of two", of_roots(root, shift, n), n);
    }
}

TEST(test_sparse) {
    for (int n = 3; n <= MOST; n += n < 16 ? 1 : 31) {
        judge_simple("x^n - 7", power(n, 7), n % 2 ? 1 : 2);
        judge_simple("x^n + 7", power(n, -7), n % 2);
        judge_simple("x^n - 1", power(n, 1), n % 2 ? 1 : 2);
        judge_simple("Mignotte, close", mignotte(n, 1 << 20), n % 2 ? 3 : 4);
        if (n <= 200) judge_simple("Mignotte, closer", mignotte(n, 3), n % 2 ? 3 : 4); /* 512 takes 10 s */
    }
}

/* (x^p - 1) / (x - 1) of a prime p has no real roots, but times others it is in their way. */
TEST(test_cyclotomic) {
    static const int prime[] = {3, 5, 17, 61, 127, 251, 509};
    for (size_t i = 0; i < sizeof prime / sizeof *prime; i++) {
        int n = prime[i] - 1;
        poly *p = make(n), *q = power(3, 2);
        for (int k = 0; k <= n; k++) mpz_set_ui(p->c[k], 1);
        if (n + 3 <= MOST) judge_simple("cyclotomic and a cube root", product(p, q), 1);
        exact_zpoly_free(q);
        judge_simple("cyclotomic", p, 0);
    }
}

/* Roots in clusters of clusters: 2^-20 apart in groups that are 2^-8 apart. */
TEST(test_nested) {
    long root[12];
    unsigned shift[12];
    for (int gap = 12; gap <= 40; gap += 14) {
        for (int i = 0; i < 12; i++) {
            root[i] = ((long)(i / 4) << (gap + 6)) + ((long)(i / 2 % 2) << gap) + i % 2 + 5;
            shift[i] = (unsigned)gap + 10;
        }
        judge_simple("nested clusters", of_roots(root, shift, 12), 12);
    }
}

TEST(test_products) {
    poly *a = recur(12, legendre), *b = mignotte(9, 100), *c = linear(3, 0), *squares = product(a, a);
    poly *cubes = product(c, c), *p = product(squares, b), *all = product(cubes, c), *whole = product(p, all);
    const poly *factor[] = {a, b, c};
    judge("a square, Mignotte's and a cube", whole, factor, (const int[]){2, 1, 3}, 3, 12 + 3 + 1);
    poly *wider = product(whole, whole);
    judge("its square", wider, factor, (const int[]){4, 2, 6}, 3, 12 + 3 + 1);
    exact_zpoly_free(wider), exact_zpoly_free(whole), exact_zpoly_free(all), exact_zpoly_free(p),
        exact_zpoly_free(cubes), exact_zpoly_free(squares), exact_zpoly_free(c), exact_zpoly_free(b),
        exact_zpoly_free(a);
}
