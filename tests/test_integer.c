/* test_integer.c - integers of many limbs, against GMP.
 *
 * The inputs favour what breaks carries: limbs of zeros and of ones, powers of two and their neighbours, -1,
 * the least integer of a width, width 1.  Breaks caught: a carry lost between limbs or at the end, a sign
 * extended wrongly, a shift by a whole number of limbs, a trial quotient corrected once too little, a double
 * rounded to the wrong side. */
#include "exact_limbs.h"

#include "base/integer.h"
#include "unit.h"

#define SEED 20240612u
#define ROUNDS 40000
#define MOST 14 /* limbs */

typedef struct operands {
    algsurf_limb a[MOST], b[MOST], old[MOST];
    int wa, wb;
    mpz_t za, zb, z;
} operands;

static void begin(operands *o) { mpz_inits(o->za, o->zb, o->z, NULL); }
static void end(operands *o) { mpz_clears(o->za, o->zb, o->z, NULL); }

static void next(operands *o, uint64_t *seed) {
    o->wa = 1 + random_int(seed, MOST);
    o->wb = 1 + random_int(seed, MOST);
    random_limbs(seed, o->a, o->wa);
    random_limbs(seed, o->b, o->wb);
    exact_limbs(o->za, o->a, o->wa);
    exact_limbs(o->zb, o->b, o->wb);
    memcpy(o->old, o->a, sizeof o->a);
}

static void failed(const char *what, int round, const operands *o, long more) {
    exact_limbs_print("a", o->old, o->wa);
    exact_limbs_print("b", o->b, o->wb);
    exact_limbs_print("result", o->a, o->wa);
    fail_msg("%s, seed %u round %d, parameter %ld", what, SEED, round, more);
}

/* a = z modulo 2^(64 wa)? */
static void check(const char *what, int round, operands *o, long more) {
    if (!exact_limbs_equal(o->a, o->wa, o->z)) failed(what, round, o, more);
}

TEST(test_sums) {
    uint64_t seed = SEED;
    operands o;
    begin(&o);
    for (int i = 0; i < ROUNDS; i++) {
        next(&o, &seed);
        algsurf_limb same[MOST];
        algsurf_z_copy(same, o.wa, o.b, o.wb);
        mpz_add(o.z, o.za, o.zb);
        algsurf_z_add(o.a, same, o.wa), check("add", i, &o, 0);
        mpz_set(o.z, o.za);
        algsurf_z_sub(o.a, same, o.wa), check("sub", i, &o, 0);
        mpz_neg(o.z, o.za);
        algsurf_z_negate(o.a, o.wa), check("negate", i, &o, 0);
        int64_t small = (int64_t)random_bits(&seed) >> random_int(&seed, 64);
        mpz_set_si(o.z, small);
        algsurf_z_set(o.a, o.wa, small), check("set", i, &o, (long)small);
        mpz_set(o.z, o.zb);
        algsurf_z_copy(o.a, o.wa, o.b, o.wb), check("copy", i, &o, 0);
    }
    end(&o);
}

TEST(test_questions) {
    uint64_t seed = SEED + 1;
    operands o;
    begin(&o);
    int signs[3] = {0};
    for (int i = 0; i < ROUNDS; i++) {
        next(&o, &seed);
        int sign = mpz_sgn(o.za);
        signs[sign + 1]++;
        if (algsurf_z_sign(o.a, o.wa) != sign || algsurf_z_negative(o.a, o.wa) != (sign < 0))
            failed("sign", i, &o, sign);
        int zeros = sign ? (int)mpz_scan1(o.za, 0) : ALGSURF_Z_NO_BIT;
        if (algsurf_z_trailing(o.a, o.wa) != zeros) failed("trailing", i, &o, zeros);
        mpz_set(o.z, o.za);
        if (sign < 0) mpz_com(o.z, o.z);
        int bits = mpz_sgn(o.z) ? (int)mpz_sizeinbase(o.z, 2) : 0;
        if (algsurf_z_bits(o.a, o.wa) != bits) failed("bits", i, &o, bits);
        if (algsurf_z_width(bits) > o.wa) failed("width", i, &o, bits);
        int la = algsurf_z_length(o.a, o.wa), lb = algsurf_z_length(o.b, o.wb);
        mpz_import(o.za, (size_t)o.wa, -1, 8, 0, 0, o.a), mpz_import(o.zb, (size_t)o.wb, -1, 8, 0, 0, o.b);
        if (la != (int)((mpz_sgn(o.za) ? mpz_sizeinbase(o.za, 2) : 0) + 63) / 64) failed("length", i, &o, la);
        int order = mpz_cmp(o.za, o.zb), found = algsurf_z_compare_magnitudes(o.a, la, o.b, lb);
        if (found != (order > 0) - (order < 0)) failed("compare", i, &o, found);
        if (algsurf_z_compare_magnitudes(o.a, la, o.a, la) != 0) failed("compare with itself", i, &o, 0);
    }
    assert_true(signs[0] > 1000 && signs[1] > 100 && signs[2] > 1000);
    end(&o);
}

TEST(test_shifts) {
    uint64_t seed = SEED + 2;
    operands o;
    begin(&o);
    for (int i = 0; i < ROUNDS; i++) {
        next(&o, &seed);
        int bits = random_int(&seed, 64 * o.wa + 130);
        if (random_int(&seed, 3) == 0) bits &= ~63;
        mpz_mul_2exp(o.z, o.za, (mp_bitcnt_t)bits);
        algsurf_z_shift_up(o.a, o.wa, bits), check("shift up", i, &o, bits);
        memcpy(o.a, o.old, sizeof o.a);
        mpz_fdiv_q_2exp(o.z, o.za, (mp_bitcnt_t)bits);
        algsurf_z_shift_down(o.a, o.wa, bits), check("shift down", i, &o, bits);
    }
    end(&o);
}

TEST(test_products) {
    uint64_t seed = SEED + 3;
    operands o;
    begin(&o);
    mpz_t f;
    mpz_init(f);
    int beyond = 0;
    for (int i = 0; i < ROUNDS; i++) {
        next(&o, &seed);
        algsurf_limb limb, factor[MOST];
        random_limbs(&seed, &limb, 1);
        mpz_import(f, 1, -1, 8, 0, 0, &limb);
        int at = random_int(&seed, o.wa + 2);
        beyond += at + o.wb > o.wa;
        mpz_mul_2exp(o.z, o.zb, (mp_bitcnt_t)(64 * at)), mpz_mul(o.z, o.z, f), mpz_add(o.z, o.z, o.za);
        algsurf_z_add_product(o.a, o.wa, o.b, o.wb, limb, at), check("add product", i, &o, at);
        mpz_set(o.z, o.za);
        algsurf_z_join_product(o.a, o.wa, o.b, o.wb, limb, at, 1), check("sub product", i, &o, at);
        mpz_mul(o.z, o.za, f);
        algsurf_z_multiply(o.a, o.wa, limb), check("multiply", i, &o, (long)limb);
        memcpy(o.a, o.old, sizeof o.a);
        int wf = 1 + random_int(&seed, MOST), negate = random_int(&seed, 2);
        algsurf_limb x[MOST];
        random_limbs(&seed, x, wf);
        algsurf_z_factor g = algsurf_z_factor_of(x, wf, factor);
        exact_limbs(f, x, wf);
        int bits = mpz_sgn(f) ? (int)mpz_sizeinbase(f, 2) : 0;
        if (g.bits != bits || g.length != (bits + 63) / 64) failed("factor", i, &o, g.bits);
        mpz_mul(f, f, o.zb);
        if (negate) mpz_neg(f, f);
        mpz_add(o.z, o.za, f);
        algsurf_z_add_times(o.a, o.wa, o.b, o.wb, &g, negate), check("add times", i, &o, wf);
    }
    assert_true(beyond > 1000);
    mpz_clear(f);
    end(&o);
}

TEST(test_division) {
    uint64_t seed = SEED + 4;
    mpz_t u, v, q, r, got;
    mpz_inits(u, v, q, r, got, NULL);
    int count = 0;
    for (int i = 0; i < 3 * ROUNDS; i++) {
        algsurf_limb U[MOST + 1], V[MOST], Q[MOST + 1], room[MOST + 1], old[MOST + 1];
        int nu = 1 + random_int(&seed, MOST), nv = 1 + random_int(&seed, nu);
        random_limbs(&seed, U, nu), random_limbs(&seed, V, nv);
        if (V[nv - 1] == 0) continue;
        if (random_int(&seed, 4) == 0) /* leading limbs alike: the largest trial quotients */
            for (int k = 0; k < nv; k++) U[nu - 1 - k] = V[nv - 1 - k];
        U[nu] = 0;
        memcpy(old, U, sizeof U);
        mpz_import(u, (size_t)nu, -1, 8, 0, 0, U), mpz_import(v, (size_t)nv, -1, 8, 0, 0, V);
        mpz_fdiv_qr(q, r, u, v);
        algsurf_z_divide(Q, U, nu, V, nv, room);
        mpz_import(got, (size_t)(nu - nv + 1), -1, 8, 0, 0, Q);
        int same = mpz_cmp(got, q) == 0;
        mpz_import(got, (size_t)nu + 1, -1, 8, 0, 0, U);
        if (!same || mpz_cmp(got, r) != 0) {
            exact_limbs_print("u", old, nu), exact_limbs_print("v", V, nv);
            fail_msg("divide, seed %u round %d", SEED + 4, i);
        }
        count++;
    }
    assert_true(count > ROUNDS);
    mpz_clears(u, v, q, r, got, NULL);
}

/* Division by a limb, also where the compiler has no wider integers: against the product. */
TEST(test_limbs) {
    uint64_t seed = SEED + 5;
    for (int i = 0; i < ROUNDS; i++) {
        algsurf_limb x[4], r, high, back;
        random_limbs(&seed, x, 4);
        algsurf_limb d = x[0] | (algsurf_limb)1 << 63, q;
        if (x[1] >= d) x[1] -= d;
        q = algsurf_limb_divide(x[1], x[2], d, algsurf_limb_inverse(d), &r);
        back = algsurf_limb_product(q, d, r, 0, &high);
        if (r >= d || high != x[1] || back != x[2] || algsurf_limb_quotient(x[1], x[2], d) != q)
            fail_msg("seed %u round %d: (%#llx 2^64 + %#llx) / %#llx", SEED + 5, i, (unsigned long long)x[1],
                     (unsigned long long)x[2], (unsigned long long)d);
        int bits = algsurf_limb_bits(x[3]);
        assert_true(bits == 64 || x[3] >> bits == 0);
        assert_true(bits == 0 || x[3] >> (bits - 1) == 1);
    }
}

/* ---- doubles ---- */

static double random_double(uint64_t *seed) {
    switch (random_int(seed, 8)) {
    case 0:
        return 0;
    case 1:
        return random_int(seed, 2) ? DBL_MAX : -DBL_MAX;
    case 2:
        return ldexp(random_unit(seed), -1060); /* subnormal */
    case 3:
        return ldexp(random_int(seed, 2) ? 1 : -1, random_int(seed, 2098) - 1074);
    default:
        return random_wide(seed, -1000, 1000);
    }
}

TEST(test_doubles_into_integers) {
    uint64_t seed = SEED + 6;
    mpz_t z, got;
    mpq_t q, unit;
    mpz_inits(z, got, NULL), mpq_inits(q, unit, NULL);
    for (int i = 0; i < ROUNDS / 4; i++) {
        double x = random_double(&seed);
        int e;
        algsurf_limb m = algsurf_z_odd_part(x, &e);
        assert_true(m == 0 ? x == 0 && e == 0 : m & 1 && ldexp((double)m, e) == fabs(x));
        int shift = random_int(&seed, 300) - e, w = 1 + random_int(&seed, 40);
        algsurf_limb r[40], old[40];
        random_limbs(&seed, r, w);
        memcpy(old, r, sizeof r);
        algsurf_z_add_double(r, w, x, shift);
        mpz_set_d(z, m == 0 ? 0 : x < 0 ? -(double)m : (double)m);
        if (m) mpz_mul_2exp(z, z, (mp_bitcnt_t)(e + shift));
        exact_limbs(got, old, w), mpz_add(z, z, got);
        if (!exact_limbs_equal(r, w, z))
            fail_msg("seed %u round %d: %a 2^%d, %d limbs", SEED + 6, i, x, shift, w);
    }
    mpz_clears(z, got, NULL), mpq_clears(q, unit, NULL);
}

/* The largest double <= q, from GMP's truncation. */
static double floor_double(const mpq_t q) {
    double x = mpq_get_d(q); /* towards 0; infinite beyond */
    if (isinf(x) || fabs(x) == DBL_MAX) {
        mpq_t largest;
        mpq_init(largest), exact_set(largest, DBL_MAX);
        int beyond = mpq_cmp(q, largest);
        mpq_neg(largest, largest);
        int below = mpq_cmp(q, largest);
        mpq_clear(largest);
        return below < 0 ? -HUGE_VAL : beyond >= 0 ? DBL_MAX : -DBL_MAX;
    }
    mpq_t back;
    mpq_init(back), exact_set(back, x);
    int order = mpq_cmp(back, q);
    mpq_clear(back);
    return order > 0 ? nextafter(x, -HUGE_VAL) : x;
}

static void scaled(mpq_t q, const mpz_t z, int e) {
    mpq_set_z(q, z);
    if (e >= 0)
        mpq_mul_2exp(q, q, (mp_bitcnt_t)e);
    else
        mpq_div_2exp(q, q, (mp_bitcnt_t)-e);
}

TEST(test_integers_into_doubles) {
    uint64_t seed = SEED + 7;
    operands o;
    begin(&o);
    mpq_t q, error, bound;
    mpq_inits(q, error, bound, NULL);
    int subnormal = 0, huge = 0, exact = 0;
    for (int i = 0; i < ROUNDS; i++) {
        next(&o, &seed);
        int e, bits = algsurf_z_bits(o.a, o.wa);
        double d = algsurf_z_to_double(o.a, o.wa, &e);
        if (mpz_sgn(o.za) == 0) {
            assert_true(d == 0 && e == 0);
        } else {
            scaled(q, o.za, -e), exact_error(error, d, q);
            mpq_abs(bound, q), mpq_div_2exp(bound, bound, 52);
            if (!(fabs(d) >= 0.5 && fabs(d) <= 1) || mpq_cmp(error, bound) > 0) failed("to_double", i, &o, e);
        }
        static const int centre[] = {0, 1024, -1074, -1022};
        int place = centre[random_int(&seed, 4)] - bits + random_int(&seed, 140) - 70;
        if (random_int(&seed, 50) == 0) place = random_int(&seed, 2) ? 5000 : -5000;
        scaled(q, o.za, place);
        double low = floor_double(q), high, found[2];
        mpq_neg(q, q), high = -floor_double(q);
        found[0] = algsurf_z_round_down(o.a, o.wa, place), found[1] = algsurf_z_round_up(o.a, o.wa, place);
        if (found[0] != low || found[1] != high) {
            fprintf(stderr, "expected %a and %a, found %a and %a\n", low, high, found[0], found[1]);
            failed("rounding", i, &o, place);
        }
        subnormal += fabs(low) < DBL_MIN && low != 0;
        huge += isinf(low) || isinf(high);
        exact += low == high;
    }
    assert_true(subnormal > 500 && huge > 500 && exact > 500);
    mpq_clears(q, error, bound, NULL);
    end(&o);
}
