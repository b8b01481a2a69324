/* test_residue.c - arithmetic modulo primes of 62 bits, against GMP.
 *
 * Breaks caught, each tried: a composite number in the table, a prime left out, a final subtraction
 * forgotten, the sign of a negative integer forgotten, gcd steps that take a remainder's degree for granted.
 */
#include "exact_limbs.h"

#include "poly/residue.h"
#include "unit.h"

#define SEED 20240701u
#define MOST 40

/* z = a limb, which unsigned long may not hold. */
static void set_limb(mpz_t z, algsurf_limb a) { mpz_import(z, 1, -1, sizeof a, 0, 0, &a); }

static algsurf_limb limb_of(const mpz_t z) {
    algsurf_limb a = 0;
    mpz_export(&a, NULL, -1, sizeof a, 0, 0, z);
    return a;
}

/* z = z R^(e) modulo p, e of any sign. */
static void scale(mpz_t z, int e, const mpz_t p) {
    mpz_t f;
    mpz_init(f);
    mpz_setbit(f, 64);
    mpz_powm_ui(f, f, (unsigned long)(e < 0 ? -e : e), p);
    if (e < 0) mpz_invert(f, f, p);
    mpz_mul(z, z, f), mpz_mod(z, z, p);
    mpz_clear(f);
}

TEST(test_primes) {
    algsurf_prime m = algsurf_prime_first();
    mpz_t p, wanted;
    mpz_inits(p, wanted, NULL);
    mpz_setbit(wanted, 62);
    for (int i = 0; i < 400; i++) { /* the table and what is computed behind it */
        do mpz_sub_ui(wanted, wanted, 1);
        while (!mpz_probab_prime_p(wanted, 30));
        set_limb(p, m.p);
        if (mpz_cmp(p, wanted) || m.index != i) fail_msg("prime %d is %llu", i, (unsigned long long)m.p);
        assert_true(m.p * m.negative_inverse == ~(algsurf_limb)0);
        mpz_set_ui(p, 1), scale(p, 1, wanted);
        assert_true(limb_of(p) == m.one);
        scale(p, 1, wanted);
        assert_true(limb_of(p) == m.square);
        m = algsurf_prime_next(&m);
    }
    mpz_clears(p, wanted, NULL);
}

static algsurf_limb random_residue(uint64_t *seed, const algsurf_prime *m) {
    int kind = random_int(seed, 8);
    algsurf_limb near = random_bits(seed) % 3;
    return kind == 0 ? near : kind == 1 ? m->p - 1 - near : random_bits(seed) % m->p;
}

static algsurf_prime random_prime(uint64_t *seed) {
    algsurf_prime m = algsurf_prime_first();
    for (int i = random_int(seed, 4); i > 0; i--) m = algsurf_prime_next(&m);
    return m;
}

TEST(test_products) {
    uint64_t seed = SEED;
    mpz_t x, y, p;
    mpz_inits(x, y, p, NULL);
    for (int i = 0; i < 4000; i++) {
        algsurf_prime m = random_prime(&seed);
        algsurf_limb a = random_residue(&seed, &m),
                     b = i % 3 ? random_residue(&seed, &m) : random_bits(&seed);
        set_limb(p, m.p), set_limb(x, a), set_limb(y, b);
        mpz_mul(x, x, y), scale(x, -1, p);
        if (limb_of(x) != algsurf_residue_times(a, b, &m)) fail_msg("seed %u round %d: times", SEED, i);
        b %= m.p;
        algsurf_limb difference = algsurf_residue_minus(a, b, &m);
        assert_true(difference < m.p && (difference + b) % m.p == a);
        if (a == 0) continue;
        algsurf_limb one = algsurf_residue_times(a, algsurf_residue_inverse(a, &m), &m);
        if (one != m.one) fail_msg("seed %u round %d: inverse", SEED, i);
    }
    mpz_clears(x, y, p, NULL);
}

TEST(test_residues_of_integers) {
    uint64_t seed = SEED + 1;
    algsurf_limb a[9 * 12], r[9];
    int negative = 0, zero = 0;
    mpz_t x, p;
    mpz_inits(x, p, NULL);
    for (int i = 0; i < 6000; i++) {
        algsurf_prime m = random_prime(&seed);
        int count = 1 + random_int(&seed, 9), w = 1 + random_int(&seed, 12);
        set_limb(p, m.p);
        for (int k = 0; k < count; k++) random_limbs(&seed, a + k * w, w);
        if (i % 8 == 0) { /* a multiple of the prime */
            memset(a, 0, (size_t)w * sizeof *a);
            a[0] = m.p;
            if (i % 16) algsurf_z_negate(a, w);
        }
        algsurf_residues_of(r, a, count, w, &m);
        for (int k = 0; k < count; k++) {
            exact_limbs(x, a + k * w, w);
            negative += mpz_sgn(x) < 0;
            mpz_mod(x, x, p), scale(x, -w, p);
            zero += mpz_sgn(x) == 0;
            if (limb_of(x) == r[k]) continue;
            exact_limbs_print("a", a + k * w, w);
            fail_msg("seed %u round %d: residue", SEED + 1, i);
        }
    }
    assert_true(negative > 1000 && zero > 400);
    mpz_clears(x, p, NULL);
}

/* ---- polynomials ---- */

typedef struct modular {
    int n; /* -1: 0 */
    algsurf_limb c[2 * MOST + 2];
} modular;

static void random_poly(uint64_t *seed, modular *a, int n, const algsurf_prime *m) {
    a->n = n;
    for (int k = 0; k <= n; k++) a->c[k] = random_int(seed, 4) ? random_residue(seed, m) : 0;
    if (n >= 0 && a->c[n] == 0) a->c[n] = 1;
}

static void multiply(modular *r, const modular *a, const modular *b, const algsurf_prime *m) {
    modular t = {.n = a->n + b->n};
    for (int i = 0; i <= a->n; i++)
        for (int j = 0; j <= b->n; j++) {
            algsurf_limb *to = t.c + i + j;
            *to = (*to + algsurf_residue_times(a->c[i], b->c[j], m)) % m->p;
        }
    *r = t;
}

static void make_monic(modular *a, const algsurf_prime *m) {
    algsurf_limb inverse = algsurf_residue_inverse(a->c[a->n], m);
    for (int k = 0; k <= a->n; k++) a->c[k] = algsurf_residue_times(a->c[k], inverse, m);
}

/* a = a mod b from the definition: b monic; returns the quotient. */
static modular remainder_of(modular *a, const modular *b, const algsurf_prime *m) {
    modular q = {.n = a->n - b->n};
    for (int k = a->n - b->n; k >= 0; k--) {
        q.c[k] = a->c[k + b->n];
        for (int i = 0; i <= b->n; i++) {
            algsurf_limb *to = a->c + k + i;
            *to = algsurf_residue_minus(*to, algsurf_residue_times(q.c[k], b->c[i], m), m);
        }
    }
    while (a->n >= 0 && a->c[a->n] == 0) a->n--;
    return q;
}

static void euclid(modular *a, modular *b, const algsurf_prime *m) {
    while (b->n >= 0) {
        make_monic(b, m);
        if (a->n >= b->n) (void)remainder_of(a, b, m);
        modular t = *a;
        *a = *b, *b = t;
    }
    make_monic(a, m);
}

static void fail_with(const char *what, int round, const modular *a, const modular *b) {
    for (int k = 0; k <= a->n; k++) fprintf(stderr, "a[%d] = %llu\n", k, (unsigned long long)a->c[k]);
    for (int k = 0; k <= b->n; k++) fprintf(stderr, "b[%d] = %llu\n", k, (unsigned long long)b->c[k]);
    fail_msg("%s, seed %u round %d", what, SEED + 2, round);
}

TEST(test_gcd) {
    uint64_t seed = SEED + 2;
    int constant = 0, vanishing = 0, proper = 0;
    for (int i = 0; i < 3000; i++) {
        algsurf_prime m = random_prime(&seed);
        modular a = {0}, b = {0}, g = {0};
        int sparse = random_int(&seed, 3) == 0 ? 3 : 12;
        random_poly(&seed, &a, random_int(&seed, sparse), &m);
        random_poly(&seed, &b, random_int(&seed, sparse) - (i % 10 == 0), &m);
        random_poly(&seed, &g, random_int(&seed, 6), &m);
        multiply(&a, &a, &g, &m);
        if (b.n >= 0) multiply(&b, &b, &g, &m);
        modular x = a, y = b, u = a, v = b;
        algsurf_limb *where;
        int d = algsurf_residues_gcd(x.c, x.n, y.c, y.n + 2, &where, &m); /* two zeros above b */
        euclid(&u, &v, &m);
        if (d != u.n || where[d] == 0) fail_with("degree of the gcd", i, &a, &b);
        algsurf_limb inverse = algsurf_residue_inverse(where[d], &m);
        for (int k = 0; k <= d; k++)
            if (algsurf_residue_times(where[k], inverse, &m) != u.c[k]) fail_with("gcd", i, &a, &b);
        constant += d == 0, vanishing += b.n<0, proper += d> 0 && d < a.n && d < b.n;
    }
    assert_true(constant > 200 && vanishing > 20 && proper > 1000);
}

TEST(test_division_and_derivative) {
    uint64_t seed = SEED + 3;
    for (int i = 0; i < 1000; i++) {
        algsurf_prime m = random_prime(&seed);
        modular a = {0}, b = {0}, derivative = {0};
        int d = random_int(&seed, 8);
        random_poly(&seed, &a, d + random_int(&seed, 12), &m);
        random_poly(&seed, &b, d, &m);
        make_monic(&b, &m);
        algsurf_residues_derive(derivative.c, a.c, a.n, &m);
        for (int k = 1; k <= a.n; k++) {
            algsurf_limb sum = 0; /* k a[k] as a sum: the derivative comes divided by R */
            for (int j = 0; j < k; j++) sum = (sum + a.c[k]) % m.p;
            assert_true(algsurf_residue_times(derivative.c[k - 1], m.square, &m) == sum);
        }
        modular x = a, y = a;
        algsurf_residues_divide(x.c, x.n, b.c, d, &m);
        modular q = remainder_of(&y, &b, &m);
        for (int k = 0; k <= a.n; k++)
            if (x.c[k] != (k >= d ? q.c[k - d] : y.c[k])) fail_with("division", i, &a, &b);
    }
}
