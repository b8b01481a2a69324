/* test_interval_arg.c - the argument of rectangles against a series of 384 bits.
 *
 * Breaks caught (each tried): a digit of a table, a sign of an octant, the bound of the error too small, the
 * small arctangent taken for its tangent, a wrong corner for one position of the rectangle, the turn beyond
 * pi. */
#include "exact_arg.h"
#include "interval_cases.h"
#include "unit.h"

#define SEED 13u
#define BITS 384
#define PI_LO 0x1.921fb54442d18p+1
#define PI_HI 0x1.921fb54442d19p+1

/* ---- the oracle: exact_arg.h ---- */

static int encloses(algsurf_interval r, const mpf_t y) {
    return mpf_cmp_d(y, r.lo) >= 0 && mpf_cmp_d(y, r.hi) <= 0;
}

/* How many doubles hi is above lo, at most 5. */
static int units(algsurf_interval r) {
    int n = 0;
    for (; r.lo < r.hi && n < 5; n++) r.lo = nextafter(r.lo, INFINITY);
    return n;
}

static algsurf_interval arg_of(double re0, double re1, double im0, double im1) {
    algsurf_interval r = {7, 7};
    assert_ok(algsurf_cinterval_arg((algsurf_cinterval){{re0, re1}, {im0, im1}}, &r));
    return r;
}

/* ---- points ---- */

static void case_point(uint64_t *seed, int kind, double *re, double *im) {
    *re = random_wide(seed, -2, 2), *im = random_wide(seed, -2, 2);
    if (kind == 1) *re = case_double(seed), *im = case_double(seed);
    if (kind == 2) *im = ldexp(*im, -random_int(seed, 70)); /* about the limits of the small arctangent */
    if (kind == 3) *im = ldexp(*re, -50 - random_int(seed, 10)) * (1 + 0x1p-52 * random_int(seed, 9));
    if (kind == 4) *re = *im * (1 + 0x1p-50 * random_unit(seed));                     /* near a diagonal */
    if (kind == 5) *re = *im * (random_int(seed, 17) / 16.0);                         /* on the table */
    if (kind == 6) *re = *im * ((0.5 + random_int(seed, 16)) / 16.0) * (1 + 0x1p-52); /* between */
    if (kind == 7) *im = ldexp(*im, -random_int(seed, 1074));
    if (*re == 0 && *im == 0) *re = 1;
}

TEST(test_points) {
    uint64_t seed = SEED;
    mpf_t y;
    mpf_init(y);
    int tight = 0, rounds = 16000;
    for (int i = 0; i < rounds; i++) {
        double re, im;
        case_point(&seed, i % 8, &re, &im);
        if (i % 16 >= 8) {
            double t = re;
            re = im, im = t;
        }
        exact_argument(y, re, im, 0);
        algsurf_interval r = arg_of(re, re, im, im);
        int n = units(r);
        if (!encloses(r, y) || n > 2)
            fail_msg("seed %u round %d: arg(%a + i %a) gave [%a,%a]", SEED, i, re, im, r.lo, r.hi);
        tight += n <= 1;
    }
    mpf_clear(y);
    assert_true(tight > rounds - rounds / 50);
}

/* Doubles n, d with n/d very near tan theta, 0 < theta < 1: the last convergent of its continued fraction
 * that fits, after scaling by a power of two.  The argument of d + in is then within about 2^-106 of a
 * double, relatively, on a side that only an arctangent as good can tell. */
static void hard_point(double theta, double *n, double *d) {
    mpf_t x, sine, cosine, term;
    mpz_t digit, h0, h1, k0, k1;
    mpf_inits(x, sine, cosine, term, NULL), mpz_inits(digit, h0, h1, k0, k1, NULL);
    mpf_set_d(x, theta), mpf_set_ui(term, 1);
    for (unsigned k = 1; k < 90; k++) { /* 1/89! < 2^-384 */
        mpf_ptr sum = k % 2 ? cosine : sine;
        if ((k - 1) % 4 < 2)
            mpf_add(sum, sum, term);
        else
            mpf_sub(sum, sum, term);
        mpf_mul(term, term, x), mpf_div_ui(term, term, k);
    }
    int exponent;
    (void)frexp(theta, &exponent);
    mpf_div(x, sine, cosine), mpf_mul_2exp(x, x, (unsigned)-exponent);
    mpz_set_ui(k0, 1), mpz_set_ui(h1, 1);
    for (;;) {
        mpz_set_f(digit, x), mpz_addmul(h0, digit, h1), mpz_addmul(k0, digit, k1);
        if (mpz_sizeinbase(h0, 2) > 53 || mpz_sizeinbase(k0, 2) > 53) break;
        mpz_swap(h0, h1), mpz_swap(k0, k1);
        mpf_set_z(term, digit), mpf_sub(x, x, term), mpf_ui_div(x, 1, x);
    }
    *n = ldexp(mpz_get_d(h1), exponent), *d = mpz_get_d(k1);
    mpf_clears(x, sine, cosine, term, NULL), mpz_clears(digit, h0, h1, k0, k1, NULL);
}

TEST(test_hard_points) {
    uint64_t seed = SEED;
    mpf_t y;
    mpf_init(y);
    for (int i = 0; i < 4000; i++) {
        double n, d, table = atan((1 + i % 16) / 16.0), t = fabs(random_unit(&seed));
        if (i % 4 == 1) t = ldexp(t, -random_int(&seed, 60));
        if (i % 4 >= 2) t = table * (1 + ldexp(t - 0.5, -random_int(&seed, 40)));
        if (!(t > 0 && t < 0.78)) continue;
        hard_point(t, &n, &d);
        algsurf_interval r = arg_of(d, d, n, n);
        exact_argument(y, d, n, 0);
        if (!encloses(r, y) || units(r) > 2) fail_msg("seed %u round %d: arg(%a + i %a)", SEED, i, d, n);
    }
    mpf_clear(y);
}

static void require(algsurf_interval r, double lo, double hi) {
    if (r.lo != lo || r.hi != hi || (lo == 0 && signbit(r.lo)))
        fail_msg("[%a,%a], not [%a,%a]", r.lo, r.hi, lo, hi);
}

TEST(test_axes_and_diagonals) {
    static const double sizes[] = {1, 3, 0x1p-1074, DBL_MAX, 0x1.123456789abcdp-300};
    for (int i = 0; i < 5; i++) {
        double s = sizes[i];
        require(arg_of(s, s, 0, 0), 0, 0);
        require(arg_of(-s, -s, 0, 0), PI_LO, PI_HI);
        require(arg_of(-s, -s, -0.0, -0.0), PI_LO, PI_HI);
        require(arg_of(0, 0, s, s), PI_LO / 2, PI_HI / 2);
        require(arg_of(0, 0, -s, -s), -PI_HI / 2, -PI_LO / 2);
        require(arg_of(s, s, s, s), PI_LO / 4, PI_HI / 4);
        require(arg_of(s, s, -s, -s), -PI_HI / 4, -PI_LO / 4);
        assert_true(units(arg_of(-s, -s, s, s)) == 1 && units(arg_of(-s, -s, -s, -s)) == 1);
    }
    require(arg_of(1, 5, 0, 0), 0, 0);
    require(arg_of(-5, -1, 0, 0), PI_LO, PI_HI);
    require(arg_of(1, 1, 0x1p-1074, 0x1p-1074), 0, 0x1p-1074); /* less than its tangent */
    require(arg_of(1, 1, 0x1p-60, 0x1p-60), nextafter(0x1p-60, 0), 0x1p-60);
    require(arg_of(-1, -1, 0x1p-1074, 0x1p-1074), PI_LO, PI_HI);
    require(arg_of(-1, -1, -0x1p-1074, -0x1p-1074), -PI_HI, -PI_LO);
}

/* ---- rectangles ---- */

TEST(test_branch_cut) {
    algsurf_interval above = arg_of(-2, -1, 0, 1), across = arg_of(-2, -1, -1, 1),
                     below = arg_of(-2, -1, -1, 0);
    algsurf_interval under = arg_of(-2, -1, -1, -0x1p-1074), thin = arg_of(-1, -1, -0x1p-1074, 0);
    assert_true(above.lo == 3 * (PI_LO / 4) && above.hi == PI_HI);
    assert_true(across.lo == above.lo && across.hi > 3.92 && across.hi < 3.93); /* 5 pi/4 */
    assert_true(below.lo == PI_LO && below.hi == across.hi);
    assert_true(under.lo == -PI_HI && under.hi > -2.36 && under.hi < -2.35); /* -3 pi/4 */
    require(thin, PI_LO, PI_HI);
    algsurf_interval right = arg_of(1, 2, -1, 1);
    require(right, -PI_HI / 4, PI_HI / 4);
    require(arg_of(1, INFINITY, 0, INFINITY), 0, PI_HI / 2);
    require(arg_of(-INFINITY, INFINITY, 1, INFINITY), 0, PI_HI);
    require(arg_of(-INFINITY, -1, -INFINITY, INFINITY), PI_LO / 2, 3 * (PI_HI / 2));
    require(arg_of(1, INFINITY, -INFINITY, INFINITY), -PI_HI / 2, PI_HI / 2);
}

/* Points of the rectangle are enclosed; the ends are those of a corner. */
TEST(test_rectangles) {
    uint64_t seed = SEED;
    mpf_t y;
    mpf_init(y);
    int done = 0;
    for (int i = 0; i < 8000; i++) {
        int wild = i % 2;
        algsurf_interval x =
            wild ? case_interval(&seed) : case_sorted(random_unit(&seed), random_unit(&seed));
        algsurf_interval z =
            wild ? case_interval(&seed) : case_sorted(random_unit(&seed), random_unit(&seed));
        algsurf_interval r = {7, 7};
        int zero = x.lo <= 0 && x.hi >= 0 && z.lo <= 0 && z.hi >= 0;
        assert_int_equal(algsurf_cinterval_arg((algsurf_cinterval){x, z}, &r),
                         zero ? ALGSURF_E_RANGE : ALGSURF_OK);
        if (zero) {
            assert_true(r.lo == 7 && r.hi == 7);
            continue;
        }
        int around = x.hi < 0 && z.lo < 0 && z.hi >= 0;
        double re = case_inside(&seed, x), im = case_inside(&seed, z), lo = INFINITY, hi = -INFINITY;
        exact_argument(y, re, im, around);
        int holds = encloses(r, y) && -PI_HI <= r.lo && r.lo <= PI_HI && r.lo <= r.hi;
        for (int k = 0; k < 4 && !wild; k++) {
            double u = k & 1 ? x.hi : x.lo, v = k & 2 ? z.hi : z.lo;
            algsurf_interval corner = arg_of(u, u, v, v);
            double turn = around && v < 0 ? 2 * PI_LO : 0;
            lo = fmin(lo, corner.lo + turn), hi = fmax(hi, corner.hi + turn);
        }
        if (!wild) holds &= r.lo == lo && fabs(r.hi - hi) <= (around ? 0x1p-49 : 0);
        if (!holds)
            fail_msg("seed %u round %d: [%a,%a] + i[%a,%a] gave [%a,%a]", SEED, i, x.lo, x.hi, z.lo, z.hi,
                     r.lo, r.hi);
        done++;
    }
    mpf_clear(y);
    assert_true(done > 3000);
}

TEST(test_bad_arguments) {
    algsurf_interval r = {7, 8};
    assert_int_equal(algsurf_cinterval_arg((algsurf_cinterval){{2, 1}, {0, 0}}, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_cinterval_arg((algsurf_cinterval){{1, 1}, {NAN, 0}}, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_cinterval_arg((algsurf_cinterval){{0, 0}, {0, 0}}, &r), ALGSURF_E_RANGE);
    assert_int_equal(algsurf_cinterval_arg((algsurf_cinterval){{0, 1}, {-1, 0}}, &r), ALGSURF_E_RANGE);
    assert_true(r.lo == 7 && r.hi == 8);
    assert_int_equal(algsurf_cinterval_arg((algsurf_cinterval){{1, 1}, {0, 0}}, NULL), ALGSURF_E_ARGUMENT);
}

int main(void) {
    mpf_set_default_prec(BITS);
    return unit_run("interval arg");
}
