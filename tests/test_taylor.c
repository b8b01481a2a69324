/* test_taylor.c - values of polynomials of integers at points that are integers times powers of two, cut to
 * so many limbs: within what they say is lost.
 *
 * Polynomials have coefficients of very different length, gaps, and roots at some of the points; points are
 * on the axes and beside them, 0, of one bit or of many limbs, tiny or huge.  Exact are GMP's integers.
 *
 * Breaks tried, each caught: a sum of 0 that keeps its limbs; a ninth of the loss; one more limb of the point
 * left out; cuts not counted; a limb less than what p(z) needs; other coefficients cut a limb higher; a
 * quotient without limbs below those of its sums. */
#include <stdio.h> /* before gmp.h, which then declares gmp_fprintf */

#include <gmp.h>

#include "algsurf/algsurf.h"
#include "complex/discs.h"
#include "random.h"
#include "unit.h"

enum { MOST = 60, LIMBS = 64 };

static uint64_t seed = 20261129u;

/* (re + i im) 2^exponent. */
typedef struct number {
    mpz_t re, im;
    long exponent;
} number;

static void number_init(number *a) { mpz_inits(a->re, a->im, NULL), a->exponent = 0; }
static void number_clear(number *a) { mpz_clears(a->re, a->im, NULL); }

/* In the unit 2^exponent, which is not above a's. */
static void number_lower(number *a, long exponent) {
    mpz_mul_2exp(a->re, a->re, (mp_bitcnt_t)(a->exponent - exponent));
    mpz_mul_2exp(a->im, a->im, (mp_bitcnt_t)(a->exponent - exponent));
    a->exponent = exponent;
}

/* a = a z. */
static void number_multiply(number *a, const number *z) {
    mpz_t x, y;
    mpz_inits(x, y, NULL);
    mpz_mul(x, a->re, z->im), mpz_addmul(x, a->im, z->re);
    mpz_mul(y, a->re, z->re), mpz_submul(y, a->im, z->im);
    mpz_swap(a->re, y), mpz_swap(a->im, x);
    a->exponent += z->exponent;
    mpz_clears(x, y, NULL);
}

static void random_integer(mpz_t a, int bits) {
    mpz_set_ui(a, 0);
    for (int left = bits; left > 0; left -= 32) {
        const int part = left < 32 ? left : 32;
        mpz_mul_2exp(a, a, (mp_bitcnt_t)part);
        mpz_add_ui(a, a, (unsigned long)(random_bits(&seed) >> (64 - part)));
    }
    if (random_int(&seed, 2)) mpz_neg(a, a);
}

static void to_limbs(algsurf_limb *r, int w, const mpz_t a) {
    algsurf_z_zero(r, w);
    assert_true(mpz_sizeinbase(a, 2) < 64 * (size_t)w);
    mpz_export(r, NULL, -1, sizeof *r, 0, 0, a);
    if (mpz_sgn(a) < 0) algsurf_z_negate(r, w);
}

static void from_limbs(mpz_t a, const algsurf_limb *x, int w) {
    algsurf_limb size[4 * LIMBS];
    algsurf_z_copy(size, w, x, w);
    if (algsurf_z_negative(x, w)) algsurf_z_negate(size, w);
    mpz_import(a, (size_t)w, -1, sizeof *size, 0, 0, size);
    if (algsurf_z_negative(x, w)) mpz_neg(a, a);
}

/* p and z, as they are and for the library. */
typedef struct question {
    number c[MOST + 1], z;
    int n, complex, on_axis;
    algsurf_i_integers p;
    algsurf_i_point at;
} question;

/* Times (y - z), if z is a Gaussian integer: so that z is a root. */
static void add_root(question *q) {
    number t;
    number_init(&t);
    mpz_set_ui(q->c[q->n + 1].re, 0), mpz_set_ui(q->c[q->n + 1].im, 0);
    for (int k = ++q->n; k >= 0; k--) {
        if (k < q->n) {
            mpz_set(t.re, q->c[k].re), mpz_set(t.im, q->c[k].im), t.exponent = 0;
            number_multiply(&t, &q->z);
            number_lower(&t, 0);
            mpz_neg(q->c[k].re, t.re), mpz_neg(q->c[k].im, t.im);
        }
        if (k > 0) mpz_add(q->c[k].re, q->c[k].re, q->c[k - 1].re);
        if (k > 0) mpz_add(q->c[k].im, q->c[k].im, q->c[k - 1].im);
    }
    number_clear(&t);
}

static void random_question(question *q) {
    const int wide = 1 + random_int(&seed, 3) * random_int(&seed, 600), gaps = random_int(&seed, 3);
    const int bits[] = {1, 53, 64, 65, 200, 400};
    q->n = 1 + random_int(&seed, MOST - 2), q->complex = random_int(&seed, 2);
    q->on_axis = random_int(&seed, 2);
    for (int k = 0; k <= q->n; k++) {
        mpz_set_ui(q->c[k].re, 0), mpz_set_ui(q->c[k].im, 0);
        if (gaps == 2 && k < q->n && random_int(&seed, 4)) continue;
        random_integer(q->c[k].re, 1 + random_int(&seed, wide));
        if (q->complex) random_integer(q->c[k].im, 1 + random_int(&seed, wide));
    }
    if (mpz_sgn(q->c[q->n].re) == 0) mpz_set_si(q->c[q->n].re, -1);
    const int length = bits[random_int(&seed, 6)], up = random_int(&seed, 61) - 30;
    random_integer(q->z.re, random_int(&seed, 6) ? length : 0);
    random_integer(q->z.im, q->on_axis ? 0 : length);
    q->z.exponent = random_int(&seed, 3) ? up - length : 0;
    if (random_int(&seed, 3) == 0 && q->z.exponent >= 0 && length < 100 && (q->complex || q->on_axis))
        add_root(q);
}

static void hand_over(question *q, algsurf_memory *m) {
    algsurf_zpoly part[2];
    int w = 1;
    for (int k = 0; k <= q->n; k++) {
        const size_t a = mpz_sizeinbase(q->c[k].re, 2), b = mpz_sizeinbase(q->c[k].im, 2);
        const int more = algsurf_z_width((int)(a > b ? a : b));
        w = more > w ? more : w;
    }
    for (int i = 0; i < 2; i++) {
        assert_true(algsurf_zpoly_new(m, q->n, w, part + i));
        for (int k = 0; k <= q->n; k++)
            to_limbs(algsurf_zpoly_at(part + i, k), w, i ? q->c[k].im : q->c[k].re);
    }
    assert_true(algsurf_i_make_integers(m, part, q->complex ? part + 1 : NULL, &q->p));
    algsurf_limb limb[2 * LIMBS];
    const int wz = algsurf_z_width((int)mpz_sizeinbase(q->z.re, 2) + (int)mpz_sizeinbase(q->z.im, 2));
    to_limbs(limb, wz, q->z.re), to_limbs(limb + wz, wz, q->z.im);
    const algsurf_i_point from = {.x = limb,
                                  .y = limb + wz,
                                  .w = wz,
                                  .exponent = q->z.exponent,
                                  .head = algsurf_i_head(limb, limb + wz, wz, q->z.exponent)};
    q->at = (algsurf_i_point){.room = 0};
    assert_true(algsurf_i_set_point(m, &q->at, &from, scaled_none(), q->z.exponent, 0));
}

/* p(z) or, for j > 0, its Taylor coefficient j. */
static void exact_sum(const question *q, int j, number *sum) {
    mpz_t choose;
    number term;
    mpz_init(choose), number_init(&term);
    mpz_set_ui(sum->re, 0), mpz_set_ui(sum->im, 0), sum->exponent = 0;
    for (int k = q->n; k >= j; k--) {
        number_multiply(sum, &q->z);
        mpz_bin_uiui(choose, (unsigned long)k, (unsigned long)j);
        mpz_mul(term.re, q->c[k].re, choose), mpz_mul(term.im, q->c[k].im, choose), term.exponent = 0;
        const long low = sum->exponent < 0 ? sum->exponent : 0;
        number_lower(&term, low), number_lower(sum, low);
        mpz_add(sum->re, sum->re, term.re), mpz_add(sum->im, sum->im, term.im);
    }
    mpz_clear(choose), number_clear(&term);
}

static double worst = -HUGE_VAL;
static int exact_count, quotients;

/* log2 of the size, 0 for 0. */
static double log2_of(const number *a) {
    long x, y;
    const double re = mpz_get_d_2exp(&x, a->re), im = mpz_get_d_2exp(&y, a->im);
    if (re == 0 && im == 0) return -HUGE_VAL;
    const long top = re == 0 || (im != 0 && y > x) ? y : x;
    return log2(hypot(ldexp(re, (int)(x - top < -200 ? -200 : x - top)),
                      ldexp(im, (int)(y - top < -200 ? -200 : y - top)))) +
           (double)(top + a->exponent);
}

/* a = a - b, where b's unit may be lowered. */
static void subtract(number *a, number *b) {
    const long low = a->exponent < b->exponent ? a->exponent : b->exponent;
    number_lower(a, low), number_lower(b, low);
    mpz_sub(a->re, a->re, b->re), mpz_sub(a->im, a->im, b->im);
}

/* What a sum of the library's is off by. */
static double error_of(const algsurf_i_sum *got, const number *exact, double *size) {
    number a, b;
    number_init(&a), number_init(&b);
    from_limbs(a.re, got->re, got->w), from_limbs(a.im, got->im, got->w), a.exponent = (long)got->exponent;
    mpz_set(b.re, exact->re), mpz_set(b.im, exact->im), b.exponent = exact->exponent;
    *size = log2_of(&b);
    subtract(&a, &b);
    const double error = log2_of(&a);
    number_clear(&a), number_clear(&b);
    return error;
}

static void number_of_sum(number *a, const algsurf_i_sum *sum) {
    from_limbs(a->re, sum->re, sum->w), from_limbs(a->im, sum->im, sum->w), a->exponent = (long)sum->exponent;
}

/* z less the quotient of its first two sums, to 200 bits of that: the product with the second one tells. */
static void judge_quotient(const question *q, algsurf_i_sums *sums, int round) {
    number a, b, way, at;
    const algsurf_i_sum now = {.re = q->at.x, .im = q->at.y, .w = q->at.w, .exponent = q->at.exponent};
    algsurf_i_point z = {.room = 0};
    number_init(&a), number_init(&b), number_init(&way), number_init(&at);
    number_of_sum(&a, sums->at), number_of_sum(&b, sums->at + 1), number_of_sum(&way, &now);
    const double size = log2_of(&b), quotient = log2_of(&a) - size;
    if (size > -HUGE_VAL && quotient > -HUGE_VAL && fabs(quotient) < 1000) {
        const int64_t low = (int64_t)quotient - 200;
        assert_true(algsurf_i_set_point(sums->m, &z, &q->at, scaled_none(), q->at.exponent, 0));
        assert_true(algsurf_i_subtract_quotient(sums, &z, 0, 1, low, 0));
        const algsurf_i_sum then = {.re = z.x, .im = z.y, .w = z.w, .exponent = z.exponent};
        number_of_sum(&at, &then);
        subtract(&way, &at);
        number_multiply(&way, &b);
        subtract(&way, &a);
        const double off = log2_of(&way) - size;
        if (off > (double)low + 4)
            fail_msg("round %d: a quotient is off by 2^%.1f, asked 2^%ld", round, off, (long)low);
        quotients++;
    }
    number_clear(&a), number_clear(&b), number_clear(&way), number_clear(&at);
}

static void judge(question *q, algsurf_memory *m, int round) {
    algsurf_i_sums sums = {.m = m, .last = -1};
    number exact;
    number_init(&exact);
    const int last = random_int(&seed, 4), widest = random_int(&seed, 4) ? 8 : 60;
    const double far = log2_of(&q->z);
    double most = -HUGE_VAL; /* of the terms; others lose as much, times binomials up to (61 over 4) */
    for (int k = 0; k <= q->n; k++) most = fmax(most, log2_of(q->c + k) + k * far);
    for (int w = 2; w <= widest; w += w / 2 + 1) {
        assert_true(algsurf_i_taylor(&sums, &q->p, &q->at, last, w));
        double size;
        exact_sum(q, 0, &exact);
        const double error = error_of(sums.at, &exact, &size);
        const double lost = is_zero(sums.lost) ? -HUGE_VAL : log2(sums.lost.re) + (double)sums.lost.exponent;
        if (error > lost)
            fail_msg("round %d, w %d: off by 2^%.1f, lost 2^%.1f (seed %llu)", round, w, error, lost,
                     (unsigned long long)seed);
        worst = fmax(worst, error - lost);
        for (int j = 1; j <= last && j <= q->n && far > -HUGE_VAL; j++) {
            exact_sum(q, j, &exact);
            const double off = error_of(sums.at + j, &exact, &size), bound = most + 32 - 64 * w - j * far;
            if (off > bound) fail_msg("round %d, w %d: coefficient %d is off by 2^%.1f", round, w, j, off);
        }
    }
    if (last > 0) judge_quotient(q, &sums, round);
    const int whole = algsurf_i_whole_width(&q->p, &q->at);
    if (whole < 4 * LIMBS - 8) {
        double size;
        exact_sum(q, 0, &exact);
        assert_true(algsurf_i_taylor(&sums, &q->p, &q->at, 0, whole));
        if (!is_zero(sums.lost) || error_of(sums.at, &exact, &size) > -HUGE_VAL)
            fail_msg("round %d: %d limbs do not suffice (seed %llu)", round, whole, (unsigned long long)seed);
        exact_count++;
    }
    number_clear(&exact);
}

TEST(within_what_is_lost) {
    static question q;
    for (int k = 0; k <= MOST; k++) number_init(q.c + k);
    number_init(&q.z);
    for (int round = 0; round < 3000; round++) {
        algsurf_memory m;
        algsurf_memory_mark mark = algsurf_memory_begin(&m, NULL, 0, (size_t)1 << 28);
        random_question(&q);
        hand_over(&q, &m);
        judge(&q, &m, round);
        algsurf_memory_release(&m, mark);
    }
    for (int k = 0; k <= MOST; k++) number_clear(q.c + k);
    number_clear(&q.z);
    assert_true(worst > -8 && exact_count > 1000 && quotients > 1000); /* the bound is felt */
}

int main(void) {
    int failed = unit_run("Taylor coefficients by integers");
    printf("the worst error is 2^%.1f of what is lost\n", worst);
    return failed;
}
