/* test_integral.c - polynomials with integer coefficients, against GMP and definitions.
 *
 * Breaks caught: a width one limb too small (coefficients of one sign and full size, ends of an interval far
 * out), a power of two counted twice, a binomial factor wrong in one degree, a root taken for a value, a
 * quotient returned for polynomials that do not divide, a content left in. */
#include "exact_limbs.h"

#include "poly/integral.h"
#include "unit.h"

#define SEED 20240613u
#define LIMIT ((size_t)1 << 28)

/* Memory for a test, given back at its end. */
typedef struct room {
    algsurf_memory m;
    algsurf_memory_mark start;
    uint64_t first[64];
} room;

static void room_begin(room *r) {
    algsurf_memory_begin(&r->m, r->first, 64, LIMIT);
    r->start = algsurf_memory_here(&r->m);
}
static void room_empty(room *r) {
    algsurf_memory_release(&r->m, r->start);
    assert_int_equal(r->m.allocated, 0);
}

static void get(mpz_t z, const algsurf_zpoly *p, int k) { exact_limbs(z, algsurf_zpoly_at(p, k), p->width); }
static void put(const algsurf_zpoly *p, int k, const mpz_t z) {
    algsurf_limb *a = algsurf_zpoly_at(p, k);
    size_t count = 0, w = (size_t)p->width;
    assert_true(mpz_sizeinbase(z, 2) < 64 * w);
    memset(a, 0, w * sizeof *a);
    mpz_export(a, &count, -1, 8, 0, 0, z);
    if (mpz_sgn(z) < 0) algsurf_z_negate(a, p->width);
}

static void print(const char *name, const algsurf_zpoly *p) {
    mpz_t z;
    mpz_init(z);
    gmp_fprintf(stderr, "%s: degree %d, width %d:", name, p->degree, p->width);
    for (int k = 0; k <= p->degree; k++) get(z, p, k), gmp_fprintf(stderr, " %Zd,", z);
    fprintf(stderr, "\n");
    mpz_clear(z);
}

/* Any limbs, or coefficients of one sign and the full size, or of falling size; the leading one not 0. */
static algsurf_zpoly random_poly(uint64_t *seed, algsurf_memory *m, int degree, int width) {
    algsurf_zpoly p;
    assert_true(algsurf_zpoly_new(m, degree, width, &p));
    int kind = random_int(seed, 4);
    for (int k = 0; k <= degree; k++) {
        algsurf_limb *a = algsurf_zpoly_at(&p, k);
        do random_limbs(seed, a, width);
        while (k == degree && algsurf_z_sign(a, width) == 0);
        if (kind == 0) memset(a, 0xff, (size_t)width * sizeof *a), a[width - 1] >>= 1;
        if (kind == 1) algsurf_z_zero(a, width), a[width - 1] = (algsurf_limb)1 << 63;
        if (kind == 2 && k < degree) algsurf_z_shift_down(a, width, random_int(seed, 64 * width));
    }
    return p;
}

/* value 2^(r n) = sum c_k N^k 2^(r (n-k)) for r >= 0, p(N 2^-r) otherwise. */
static void exact_value(mpz_t value, const algsurf_zpoly *p, const mpz_t N, int r) {
    mpz_t c, x;
    mpz_inits(c, x, NULL);
    mpz_set(x, N);
    if (r < 0) mpz_mul_2exp(x, x, (mp_bitcnt_t)-r);
    mpz_set_ui(value, 0);
    for (int k = p->degree; k >= 0; k--) {
        get(c, p, k);
        if (r > 0) mpz_mul_2exp(c, c, (mp_bitcnt_t)(r * (p->degree - k)));
        mpz_mul(value, value, x), mpz_add(value, value, c);
    }
    mpz_clears(c, x, NULL);
}

static void check_value(uint64_t *seed, room *m, const algsurf_zpoly *p, const algsurf_limb *N, int w, int r,
                        int count[3]) {
    mpz_t z, x;
    mpq_t q, error;
    mpz_inits(z, x, NULL), mpq_inits(q, error, NULL);
    int sign = 7, exponent = 0, want = random_int(seed, 4);
    double value = 0;
    uint64_t *before = m->m.at;
    exact_limbs(x, N, w), exact_value(z, p, x, r);
    assert_true(
        algsurf_zpoly_sign_at(&m->m, p, N, w, r, &sign, want ? &value : NULL, want ? &exponent : NULL));
    assert_ptr_equal(m->m.at, before);
    int right = sign == mpz_sgn(z);
    if (right && want && sign == 0) right = value == 0 && exponent == 0;
    if (right && want && sign) { /* z = value 2^(exponent + r n) to 2^-52 */
        long up = exponent + (r > 0 ? (long)r * p->degree : 0);
        mpq_set_z(q, z);
        if (up > 0) mpq_div_2exp(q, q, (mp_bitcnt_t)up);
        if (up < 0) mpq_mul_2exp(q, q, (mp_bitcnt_t)-up);
        exact_error(error, value, q);
        mpq_abs(q, q), mpq_div_2exp(q, q, 52);
        right = fabs(value) >= 0.5 && fabs(value) <= 1 && mpq_cmp(error, q) <= 0;
    }
    if (!right) {
        print("p", p), exact_limbs_print("N", N, w);
        fail_msg("value, seed %u: r = %d, sign %d, expected %d, value %a 2^%d", SEED, r, sign, mpz_sgn(z),
                 value, exponent);
    }
    count[sign + 1]++;
    mpz_clears(z, x, NULL), mpq_clears(q, error, NULL);
}

TEST(test_values) {
    uint64_t seed = SEED;
    int count[3] = {0};
    room m;
    for (int i = 0; i < 12000; i++) {
        room_begin(&m);
        int degree = random_int(&seed, i % 20 ? 12 : 65),
            w = 1 + (random_int(&seed, 3) ? 0 : random_int(&seed, 4));
        algsurf_zpoly p = random_poly(&seed, &m.m, degree, 1 + random_int(&seed, 8));
        algsurf_limb N[4];
        random_limbs(&seed, N, w);
        int r = random_int(&seed, 5) ? random_int(&seed, 140) - 10 : random_int(&seed, 1500) - 300;
        if (random_int(&seed, 4) == 0) algsurf_z_shift_down(N, w, 64 * w - 1 - random_int(&seed, 20));
        check_value(&seed, &m, &p, N, w, r, count);
        room_empty(&m);
    }
    assert_true(count[0] > 2000 && count[2] > 2000);
}

/* p = (2^s x - M) g: the root itself, and its neighbours.  Sometimes of high degree, with the root near 1 and
 * a constant more: what is left there is as small as the errors of three limbs, about 2^-180 of the terms. */
TEST(test_values_at_roots) {
    uint64_t seed = SEED + 1;
    int count[3] = {0};
    room m;
    mpz_t M, c, old;
    mpz_inits(M, c, old, NULL);
    for (int i = 0; i < 3000; i++) {
        room_begin(&m);
        int high = i % 5 == 0, s = high ? 52 : random_int(&seed, 60), n = random_int(&seed, high ? 200 : 10),
            more = high ? 0 : random_int(&seed, 70);
        algsurf_zpoly p, g = random_poly(&seed, &m.m, n, high ? 4 : 1 + random_int(&seed, 4));
        int64_t root = (int64_t)random_bits(&seed) >> (4 + random_int(&seed, 59));
        if (high) root = ((int64_t)1 << 52) + (root >> random_int(&seed, 40)) % ((int64_t)1 << 51);
        assert_true(algsurf_zpoly_new(&m.m, n + 1, g.width + 2, &p));
        mpz_set_si(M, root), mpz_set_ui(old, 0);
        for (int k = 0; k <= n + 1; k++) { /* 2^s g_(k-1) - M g_k */
            mpz_mul_2exp(old, old, (mp_bitcnt_t)s);
            if (k <= n) get(c, &g, k), mpz_submul(old, c, M);
            put(&p, k, old);
            if (k <= n) mpz_set(old, c);
        }
        if (high) {
            mpz_set_si(old, (int64_t)random_bits(&seed)), mpz_mul_2exp(old, old, (mp_bitcnt_t)(i % 100));
            get(c, &p, 0), mpz_add(c, c, old), put(&p, 0, c);
        }
        algsurf_limb N[3];
        for (int near = -1; near <= 1; near++) {
            algsurf_z_set(N, 3, root), algsurf_z_shift_up(N, 3, more);
            algsurf_limb step[3];
            algsurf_z_set(step, 3, near), algsurf_z_add(N, step, 3);
            check_value(&seed, &m, &p, N, 3, s + more, count);
        }
        room_empty(&m);
    }
    assert_true(count[0] > 1000 && count[1] > 2000 && count[2] > 1000);
    mpz_clears(M, c, old, NULL);
}

/* ---- Bernstein coefficients ---- */

/* b_j (j <= n), times any positive power of two, from the definition: sum_k C(j,k) L/C(n,k) a_k. */
static void definition(mpz_t *b, const algsurf_zpoly *p, int64_t at, int q) {
    int n = p->degree;
    mpz_t *a = malloc((size_t)(n + 1) * sizeof *a), L, x, y;
    mpz_inits(L, x, y, NULL);
    for (int k = 0; k <= n; k++) mpz_init(a[k]), get(a[k], p, k);
    mpz_set_si(x, at);
    for (int i = 0; i < n; i++)
        for (int k = n - 1; k >= i; k--) mpz_addmul(a[k], a[k + 1], x);
    mpz_set_ui(L, 1);
    for (int k = 0; k <= n; k++) {
        mpz_bin_uiui(x, (unsigned long)n, (unsigned long)k), mpz_lcm(L, L, x);
        mpz_mul_2exp(a[k], a[k], (mp_bitcnt_t)(q >= 0 ? k * q : (k - n) * q));
    }
    for (int j = 0; j <= n; j++) {
        mpz_set_ui(b[j], 0);
        mpz_set_ui(y, 1); /* C(j,k) */
        for (int k = 0; k <= j; k++) {
            mpz_bin_uiui(x, (unsigned long)n, (unsigned long)k), mpz_divexact(x, L, x), mpz_mul(x, x, y);
            mpz_addmul(b[j], x, a[k]);
            mpz_mul_ui(y, y, (unsigned long)(j - k)), mpz_divexact_ui(y, y, (unsigned long)(k + 1));
        }
    }
    for (int k = 0; k <= n; k++) mpz_clear(a[k]);
    free(a), mpz_clears(L, x, y, NULL);
}

static void check_bernstein(room *m, const algsurf_zpoly *p, int64_t at, int q) {
    int n = p->degree, right;
    mpz_t *b = malloc((size_t)(n + 1) * sizeof *b), z;
    mpz_init(z);
    for (int j = 0; j <= n; j++) mpz_init(b[j]);
    definition(b, p, at, q);
    algsurf_zpoly found;
    assert_true(algsurf_zpoly_bernstein(&m->m, p, at, q, &found));
    mp_bitcnt_t zeros = ~(mp_bitcnt_t)0;
    size_t bits = 0;
    for (int j = 0; j <= n; j++) {
        mp_bitcnt_t low = mpz_sgn(b[j]) ? mpz_scan1(b[j], 0) : ~(mp_bitcnt_t)0;
        if (low < zeros) zeros = low;
    }
    right = found.degree == n;
    for (int j = 0; j <= n && right; j++) {
        mpz_tdiv_q_2exp(b[j], b[j], zeros);
        size_t size = mpz_sizeinbase(b[j], 2);
        if (size > bits) bits = size;
        get(z, &found, j);
        right = mpz_cmp(z, b[j]) == 0;
    }
    if (!right || found.width > (int)bits / 64 + 1) {
        print("p", p), print("b", &found);
        fail_msg("Bernstein coefficients over [%lld, it + 2^%d], %zu bits", (long long)at, q, bits);
    }
    for (int j = 0; j <= n; j++) mpz_clear(b[j]);
    free(b), mpz_clear(z);
}

TEST(test_bernstein) {
    uint64_t seed = SEED + 2;
    room m;
    for (int i = 0; i < 4000; i++) {
        room_begin(&m);
        int degree = i < 600 ? i % 66 : random_int(&seed, 20);
        algsurf_zpoly p = random_poly(&seed, &m.m, degree, 1 + random_int(&seed, 8));
        int64_t at = (int64_t)random_bits(&seed) >> random_int(&seed, 64);
        int q = random_int(&seed, 4) ? random_int(&seed, 12) : random_int(&seed, 200) - 30;
        if (random_int(&seed, 3) == 0) at = random_int(&seed, 33) - 16, q = 4;
        if (random_int(&seed, 30) == 0) at = INT64_MIN;
        if (random_int(&seed, 30) == 0) at = INT64_MAX;
        if (random_int(&seed, 10) == 0) at = 0;
        check_bernstein(&m, &p, at, q);
        room_empty(&m);
    }
    static const int large[] = {66, 100, 128, 256, 512};
    for (size_t i = 0; i < sizeof large / sizeof *large; i++) {
        room_begin(&m);
        algsurf_zpoly p = random_poly(&seed, &m.m, large[i], 2);
        check_bernstein(&m, &p, -3, 2);
        room_empty(&m);
    }
}

/* ---- division, content, small things ---- */

static void multiply(room *m, const algsurf_zpoly *a, const algsurf_zpoly *b, algsurf_zpoly *p) {
    mpz_t x, y, z;
    mpz_inits(x, y, z, NULL);
    assert_true(algsurf_zpoly_new(&m->m, a->degree + b->degree, a->width + b->width + 1, p));
    for (int k = 0; k <= p->degree; k++) {
        mpz_set_ui(z, 0);
        for (int i = 0; i <= a->degree && i <= k; i++)
            if (k - i <= b->degree) get(x, a, i), get(y, b, k - i), mpz_addmul(z, x, y);
        put(p, k, z);
    }
    mpz_clears(x, y, z, NULL);
}

static int equal(const algsurf_zpoly *a, const algsurf_zpoly *b) {
    mpz_t x, y;
    mpz_inits(x, y, NULL);
    int same = a->degree == b->degree;
    for (int k = 0; k <= a->degree && same; k++) get(x, a, k), get(y, b, k), same = mpz_cmp(x, y) == 0;
    mpz_clears(x, y, NULL);
    return same;
}

static void content(mpz_t g, const algsurf_zpoly *p) {
    mpz_t c;
    mpz_init(c), mpz_set_ui(g, 0);
    for (int k = 0; k <= p->degree; k++) get(c, p, k), mpz_gcd(g, g, c);
    mpz_clear(c);
}

TEST(test_primitive) {
    uint64_t seed = SEED + 3;
    room m;
    mpz_t g, c, f;
    mpz_inits(g, c, f, NULL);
    int large = 0, none = 0;
    for (int i = 0; i < 3000; i++) {
        room_begin(&m);
        algsurf_zpoly p, found, a = random_poly(&seed, &m.m, random_int(&seed, 12), 1 + random_int(&seed, 6));
        algsurf_limb factor[5];
        int w = 1 + random_int(&seed, 5);
        random_limbs(&seed, factor, w);
        exact_limbs(f, factor, w);
        if (mpz_sgn(f) == 0 || random_int(&seed, 3) == 0) mpz_set_ui(f, 1);
        assert_true(algsurf_zpoly_new(&m.m, a.degree, a.width + w, &p));
        for (int k = 0; k <= a.degree; k++) get(c, &a, k), mpz_mul(c, c, f), put(&p, k, c);
        content(g, &p);
        assert_true(algsurf_zpoly_primitive(&m.m, &p, &found));
        for (int k = 0; k <= p.degree; k++) {
            get(c, &p, k), mpz_divexact(c, c, g);
            int right =
                found.degree == p.degree && exact_limbs_equal(algsurf_zpoly_at(&found, k), found.width, c);
            if (right) continue;
            print("p", &p), print("found", &found);
            fail_msg("primitive, seed %u round %d", SEED + 3, i);
        }
        large += mpz_sizeinbase(g, 2) > 64;
        none += mpz_cmp_ui(g, 1) == 0;
        room_empty(&m);
    }
    assert_true(large > 300 && none > 300);
    mpz_clears(g, c, f, NULL);
}

/* Products are divided, products with one coefficient changed are not. */
TEST(test_divide) {
    uint64_t seed = SEED + 4;
    room m;
    int zeros = 0;
    for (int i = 0; i < 4000; i++) {
        room_begin(&m);
        algsurf_zpoly b, p, q, any = random_poly(&seed, &m.m, random_int(&seed, 8), 1 + random_int(&seed, 4));
        algsurf_zpoly a = random_poly(&seed, &m.m, random_int(&seed, 12), 1 + random_int(&seed, 4));
        if (random_int(&seed, 3) == 0)
            algsurf_z_set(algsurf_zpoly_at(&any, any.degree), any.width, i & 1 ? 1 : -1);
        if (random_int(&seed, 10) == 0) algsurf_z_zero(any.c, any.width);
        if (random_int(&seed, 10) == 0) algsurf_z_zero(a.c, a.width);
        if (algsurf_z_sign(algsurf_zpoly_at(&any, any.degree), any.width) == 0)
            algsurf_z_set(any.c, any.width, 1);
        assert_true(algsurf_zpoly_primitive(&m.m, &any, &b));
        multiply(&m, &a, &b, &p);
        int divides = 7;
        assert_true(algsurf_zpoly_divide(&m.m, &p, &b, &divides, &q));
        if (divides != 1 || !equal(&q, &a)) {
            print("a", &p), print("b", &b), print("a / b", &a);
            fail_msg("divide, seed %u round %d: %d", SEED + 4, i, divides);
        }
        if (b.degree == 0) {
            room_empty(&m);
            continue;
        }
        algsurf_limb *c = algsurf_zpoly_at(&p, random_int(&seed, p.degree)), one[1] = {1};
        algsurf_z_add_product(c, p.width, one, 1, 1, random_int(&seed, p.width - 1));
        uint64_t *before = m.m.at;
        assert_true(algsurf_zpoly_divide(&m.m, &p, &b, &divides, &q));
        mpz_t lowest;
        mpz_init(lowest), get(lowest, &b, 0);
        zeros += mpz_sgn(lowest) == 0;
        /* a power of 2^64 x^k more: only c x^k divides that */
        int monomial = 1;
        for (int k = 0; k < b.degree; k++) get(lowest, &b, k), monomial = monomial && mpz_sgn(lowest) == 0;
        if (divides && !monomial) {
            print("a", &p), print("b", &b);
            fail_msg("divides what it should not, seed %u round %d", SEED + 4, i);
        }
        if (!divides) assert_ptr_equal(m.m.at, before);
        mpz_clear(lowest);
        room_empty(&m);
    }
    assert_true(zeros > 100);
}

TEST(test_small_things) {
    uint64_t seed = SEED + 5;
    room m;
    mpz_t x, y;
    mpz_inits(x, y, NULL);
    for (int i = 0; i < 3000; i++) {
        room_begin(&m);
        algsurf_zpoly d, q, p = random_poly(&seed, &m.m, random_int(&seed, 12), 1 + random_int(&seed, 6));
        assert_true(algsurf_zpoly_derivative(&m.m, &p, &d));
        assert_int_equal(d.degree, p.degree - 1);
        for (int k = 1; k <= p.degree; k++) {
            get(x, &p, k), mpz_mul_ui(x, x, (unsigned long)k), get(y, &d, k - 1);
            assert_int_equal(mpz_cmp(x, y), 0);
        }
        int shift = random_int(&seed, 150), top = random_int(&seed, 3), bits = 0, zeros = ALGSURF_Z_NO_BIT;
        assert_true(algsurf_zpoly_new(&m.m, p.degree + top, p.width + 3, &q));
        for (int k = 0; k <= p.degree; k++) {
            algsurf_limb *a = algsurf_zpoly_at(&p, k);
            get(x, &p, k), mpz_mul_2exp(x, x, (mp_bitcnt_t)shift), put(&q, k, x);
            if (algsurf_z_bits(a, p.width) > bits) bits = algsurf_z_bits(a, p.width);
            if (algsurf_z_trailing(a, p.width) < zeros) zeros = algsurf_z_trailing(a, p.width);
        }
        assert_int_equal(algsurf_zpoly_bits(&p), bits);
        assert_int_equal(algsurf_zpoly_trailing(&p), zeros);
        algsurf_zpoly_compact(&q);
        assert_int_equal(q.degree, p.degree);
        assert_int_equal(algsurf_zpoly_trailing(&q), 0);
        assert_int_equal(q.width, algsurf_z_width(algsurf_zpoly_bits(&q)));
        for (int k = 0; k <= p.degree; k++) {
            get(x, &p, k), get(y, &q, k), mpz_mul_2exp(y, y, (mp_bitcnt_t)zeros);
            assert_int_equal(mpz_cmp(x, y), 0);
        }
        room_empty(&m);
    }
    mpz_clears(x, y, NULL);
}

TEST(test_zero_polynomial) {
    room m;
    room_begin(&m);
    algsurf_zpoly zero, p, q, one;
    int sign = 7, divides = 7, exponent = 7;
    double value = 7;
    algsurf_limb N[1] = {5};
    assert_true(algsurf_zpoly_new(&m.m, 3, 2, &zero));
    assert_true(algsurf_zpoly_bernstein(&m.m, &zero, 1, 4, &p) && p.degree == 3 && p.width == 1);
    assert_true(algsurf_zpoly_sign_at(&m.m, &zero, N, 1, 3, &sign, &value, &exponent));
    assert_true(sign == 0 && value == 0 && exponent == 0);
    assert_true(algsurf_zpoly_primitive(&m.m, &zero, &p) && p.degree == 3);
    algsurf_zpoly_compact(&zero);
    assert_int_equal(zero.degree, -1);
    sign = 7, value = 7, exponent = 7;
    assert_true(algsurf_zpoly_new(&m.m, 0, 1, &one));
    one.c[0] = 1;
    assert_true(algsurf_zpoly_sign_at(&m.m, &zero, N, 1, 3, &sign, &value, &exponent));
    assert_true(sign == 0 && value == 0 && exponent == 0);
    assert_true(algsurf_zpoly_bernstein(&m.m, &zero, 1, 4, &p) && p.degree == -1);
    assert_true(algsurf_zpoly_derivative(&m.m, &zero, &p) && p.degree == -1);
    assert_true(algsurf_zpoly_derivative(&m.m, &one, &p) && p.degree == -1);
    assert_true(algsurf_zpoly_primitive(&m.m, &zero, &p) && p.degree == -1);
    assert_true(algsurf_zpoly_copy(&m.m, &zero, 2, &p) && p.degree == -1);
    assert_true(algsurf_zpoly_divide(&m.m, &zero, &one, &divides, &q) && divides == 1 && q.degree == -1);
    assert_true(algsurf_zpoly_divide(&m.m, &one, &zero, &divides, &q) && divides == 0);
    assert_int_equal(algsurf_zpoly_bits(&zero), 0);
    assert_int_equal(algsurf_zpoly_trailing(&zero), ALGSURF_Z_NO_BIT);
    room_empty(&m);
}

/* With every limit up to the one that suffices: 0, and nothing is kept. */
TEST(test_no_memory) {
    uint64_t seed = SEED + 6;
    room m;
    room_begin(&m);
    algsurf_zpoly a = random_poly(&seed, &m.m, 20, 30), b = random_poly(&seed, &m.m, 5, 3), p, q;
    b.c[0] = 1;
    assert_true(algsurf_zpoly_primitive(&m.m, &b, &b)); /* a result may replace its input */
    multiply(&m, &a, &b, &p);
    algsurf_limb N[2] = {3, 4};
    for (int which = 0; which < 5; which++) {
        int done = 0, refused = 0;
        for (size_t words = 0; !done; words += 3) {
            algsurf_memory small;
            uint64_t first[10];
            int sign, divides = 0;
            algsurf_memory_begin(&small, first, 10, words * 8);
            algsurf_memory_mark start = algsurf_memory_here(&small);
            done = which == 0   ? algsurf_zpoly_sign_at(&small, &p, N, 2, 20, &sign, NULL, NULL)
                   : which == 1 ? algsurf_zpoly_bernstein(&small, &p, 3, 4, &q)
                   : which == 2 ? algsurf_zpoly_divide(&small, &p, &b, &divides, &q)
                   : which == 3 ? algsurf_zpoly_primitive(&small, &p, &q)
                                : algsurf_zpoly_derivative(&small, &p, &q);
            refused += !done;
            if (done && which == 2) assert_int_equal(divides, 1);
            algsurf_memory_release(&small, start);
            assert_int_equal(small.allocated, 0);
            assert_true(words < 100000);
        }
        assert_true(refused > 10);
    }
    room_empty(&m);
}
