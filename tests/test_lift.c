/* test_lift.c - fractions with one denominator from their images modulo primes, against GMP.
 *
 * Breaks caught, each tried: a digit of the mixed radix not reduced, a sign lost, a step of Lehmer's in
 * Euclid's algorithm beyond its goal, a denominator not carried along, a prime of the modulus in the
 * denominator. */
#include "exact_zpolys.h"

#include "poly/lift.h"
#include "unit.h"

#define SEED 20240704u
#define MOST 8 /* numbers */

static void set_limb(mpz_t z, algsurf_limb a) { mpz_import(z, 1, -1, sizeof a, 0, 0, &a); }

typedef struct bench {
    uint64_t seed, stack[20000];
    algsurf_memory m;
    algsurf_lift lift;
    algsurf_prime prime;
    mpz_t number[MOST + 1], p, x; /* x_k = number[k] / number[count] */
    int count;
} bench;

static void begin(bench *t) {
    algsurf_memory_begin(&t->m, t->stack, sizeof t->stack / sizeof *t->stack, 0);
    algsurf_lift_begin(&t->lift, &t->m, t->count);
    t->prime = algsurf_prime_first();
}

/* Another image; not for a prime that divides the denominator. */
static void add_image(bench *t) {
    algsurf_limb x[MOST];
    for (;; t->prime = algsurf_prime_next(&t->prime)) {
        set_limb(t->p, t->prime.p);
        if (mpz_invert(t->x, t->number[t->count], t->p)) break;
    }
    for (int k = 0; k < t->count; k++) {
        mpz_t y;
        mpz_init(y);
        mpz_mul(y, t->x, t->number[k]), mpz_mod(y, y, t->p);
        x[k] = 0;
        mpz_export(x + k, NULL, -1, sizeof *x, 0, 0, y);
        mpz_clear(y);
    }
    algsurf_limb modulus = algsurf_lift_modulus(&t->lift, &t->prime);
    assert_true(algsurf_lift_add(&t->lift, x, algsurf_residue_inverse(modulus, &t->prime), &t->prime));
    t->prime = algsurf_prime_next(&t->prime);
}

/* Reduced, the denominator positive. */
static void set_numbers(bench *t, int bits, int denominator_bits) {
    t->count = 1 + random_int(&t->seed, MOST);
    for (int k = 0; k < t->count; k++) random_mpz(&t->seed, t->number[k], bits);
    random_mpz(&t->seed, t->x, denominator_bits);
    mpz_abs(t->x, t->x);
    mpz_set(t->number[t->count], t->x);
    if (mpz_sgn(t->x) == 0) mpz_set_ui(t->number[t->count], 1);
    mpz_set(t->x, t->number[t->count]);
    for (int k = 0; k < t->count; k++) mpz_gcd(t->x, t->x, t->number[k]);
    for (int k = 0; k <= t->count; k++) mpz_divexact(t->number[k], t->number[k], t->x);
}

static int is_right(bench *t, const algsurf_zpoly *c) {
    int right = c->degree == t->count - 1;
    for (int k = 0; k < t->count && right; k++) {
        exact_limbs(t->x, algsurf_zpoly_at(c, k), c->width);
        right = mpz_cmp(t->x, t->number[k]) == 0;
    }
    return right;
}

static size_t largest(const bench *t) {
    size_t bits = 1;
    for (int k = 0; k <= t->count; k++) {
        size_t b = mpz_sizeinbase(t->number[k], 2);
        bits = b > bits ? b : bits;
    }
    return bits;
}

TEST(test_fractions) {
    static bench t = {.seed = SEED};
    int wrong = 0, early = 0, guesses = 0, images = 0;
    for (int k = 0; k <= MOST; k++) mpz_init(t.number[k]);
    mpz_inits(t.p, t.x, NULL);
    for (int i = 0; i < 1500; i++) {
        static const int most[] = {3, 20, 61, 63, 64, 130, 400, 1500};
        set_numbers(&t, most[i % 8], i % 3 ? most[i % 8] : 1 + random_int(&t.seed, 40));
        int enough = (int)(largest(&t) + 6 + 30) / 31, found = 0; /* 31 bits of a prime each, less 6 */
        begin(&t);
        /* two more images, for what looks small by chance */
        for (int k = 1; k <= enough || (!found && k <= enough + 2); k++) {
            algsurf_zpoly c;
            add_image(&t);
            images++;
            if (enough > 8 && k % 5 && k < enough) continue;
            algsurf_memory_mark here = algsurf_memory_here(&t.m);
            assert_true(algsurf_lift_guess(&t.lift, &found, &c));
            if (!found) assert_true(t.m.at == here.at);
            guesses++;
            if (found && !is_right(&t, &c)) wrong++, found = 0;
            early += found && k < enough;
            algsurf_memory_release(&t.m, here);
        }
        if (!found) fail_msg("seed %u round %d: %d images do not suffice", SEED, i, enough);
        algsurf_lift_forget(&t.lift);
        assert_true(t.m.at == t.stack && t.lift.primes == 0);
    }
    /* A single number of random images has a fraction once in 2^12 or so; `early`: short denominators. */
    if (wrong > guesses / 100 || early < 100) fail_msg("%d wrong, %d early of %d", wrong, early, guesses);
    assert_true(images > 5000);
    for (int k = 0; k <= MOST; k++) mpz_clear(t.number[k]);
    mpz_clears(t.p, t.x, NULL);
}

/* One image is of other numbers: with two images more than necessary its prime would join all numerators and
 * the denominator, which are no longer small, but by chance. */
TEST(test_wrong_image) {
    static bench t = {.seed = SEED + 1};
    int tried = 0, wrong = 0;
    for (int k = 0; k <= MOST; k++) mpz_init(t.number[k]);
    mpz_inits(t.p, t.x, NULL);
    for (int i = 0; i < 300; i++) {
        int found;
        set_numbers(&t, 100, 100);
        if (t.count < 2 || mpz_sgn(t.number[0]) == 0) continue;
        begin(&t);
        mpz_add_ui(t.number[0], t.number[0], 1);
        add_image(&t);
        mpz_sub_ui(t.number[0], t.number[0], 1);
        for (int k = 0; k < 7; k++) {
            algsurf_zpoly c;
            add_image(&t);
            algsurf_memory_mark here = algsurf_memory_here(&t.m);
            assert_true(algsurf_lift_guess(&t.lift, &found, &c));
            wrong += found && k > 2;
            algsurf_memory_release(&t.m, here);
        }
        tried++;
    }
    assert_true(tried > 100);
    if (wrong > tried / 50) fail_msg("seed %u: %d guesses from a wrong image", SEED + 1, wrong);
    for (int k = 0; k <= MOST; k++) mpz_clear(t.number[k]);
    mpz_clears(t.p, t.x, NULL);
}
