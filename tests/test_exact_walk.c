/* test_exact_walk.c - the exact walk on polynomials whose roots are known exactly.
 *
 * Products of known factors are judged root by root with rational arithmetic: all roots of the interval, in
 * order, with multiplicity, sign before, enclosure and place.  Other families are judged by a Sturm chain, or
 * by as many changes of sign as the degree allows.  Every polynomial is walked twice, refined and not.
 *
 * Breaks caught, each tried: roots reported twice after the squarefree part is taken, or not; multiplicity
 * and sign before off; an end of the interval open; a root at a cut forgotten or reported twice; pieces too
 * short at either end, also by underflow; bounds of roots and of bare annuli too narrow; a middle at the
 * wrong place, or none made (slow); ends of places that are roots; enclosures that reach over an end of the
 * interval; widths without room for a halving; memory not given back, a failed allocation not seen; bisection
 * never taken.  Outer parts of a zoom that are not proved: test_exact_sign. */

#include "exact_known.h"
#include "exact_roots.h"

#include "algsurf/isolate.h"
#include "roots/exact_walk.h"
#include "unit.h"

#define SEED 20250311u
#define LIMIT ((size_t)1 << 30)
enum { MOST_ROOTS = 600, STACK_WORDS = 1024 };

static uint64_t stack[STACK_WORDS];
static size_t counted; /* cells of the last walk that was refined */

/* ---- judging against known roots ---- */

typedef struct query {
    const known *k;
    int unit, refine;
    double lo, hi;
    const char *family;
    int round;
} query;

static void failed(const query *q, const char *what, int i) {
    known_print(q->k);
    fprintf(stderr, "unit %d, [%a, %a], refine %d\n", q->unit, q->lo, q->hi, q->refine);
    fail_msg("%s: root %d, family %s round %d seed %u", what, i, q->family, q->round, SEED);
}

/* The sign of p just before root i. */
static int sign_before(const known *k, int i) {
    int sign = mpz_sgn(k->p->c[k->p->n]);
    for (; i < k->count; i++)
        if (k->root[i]->multiplicity % 2) sign = -sign;
    return sign;
}

/* The sign of f, a polynomial in u, at N 2^-r. */
static int sign_at(const algsurf_zpoly *f, const algsurf_limb *N, int width, int r) {
    mpq_t x, v, c;
    mpq_inits(x, v, c, NULL);
    known_of_limbs(x, N, width, -r);
    for (int k = f->degree; k >= 0; k--) {
        exact_limbs(mpq_numref(c), algsurf_zpoly_at(f, k), f->width);
        mpq_mul(v, v, x), mpq_add(v, v, c);
    }
    int sign = mpq_sgn(v);
    mpq_clears(x, v, c, NULL);
    return sign;
}

/* The place holds root i and no other. */
static void judge_place(const query *q, const algsurf_exact_root *r, int i) {
    const algsurf_exact_place *place = &r->place;
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    known_of_limbs(a, place->a, place->width, q->unit - place->r);
    if (!place->b) {
        if (known_compare(q->k->root[i], a) != 0) failed(q, "a point that is not the root", i);
    } else {
        known_of_limbs(b, place->b, place->width, q->unit - place->r);
        for (int j = 0; j < q->k->count; j++) {
            int inside = known_compare(q->k->root[j], a) > 0 && known_compare(q->k->root[j], b) < 0;
            if (inside != (i == j)) failed(q, "the roots in the place", i);
        }
        int at_a = sign_at(place->of, place->a, place->width, place->r),
            at_b = sign_at(place->of, place->b, place->width, place->r);
        if (at_a * at_b >= 0) failed(q, "signs at the ends of the place", i);
    }
    mpq_clears(a, b, NULL);
}

static void judge_root(const query *q, const algsurf_exact_root *r, int i) {
    const known_root *truth = q->k->root[i];
    int at_lo = known_compare_double(truth, r->lo), at_hi = known_compare_double(truth, r->hi);
    if (!(r->lo <= r->hi) || at_lo < 0 || at_hi > 0) {
        fprintf(stderr, "[%a, %a]\n", r->lo, r->hi);
        failed(q, "enclosure", i);
    }
    if (r->multiplicity != truth->multiplicity) failed(q, "multiplicity", i);
    if (r->sign_before != sign_before(q->k, i)) failed(q, "sign before", i);
    judge_place(q, r, i);
    if (!q->refine) return;
    if (r->lo == r->hi ? at_lo != 0 : at_lo == 0 || at_hi == 0 || nextafter(r->lo, HUGE_VAL) != r->hi)
        failed(q, "neighbours", i);
    if ((r->t != r->lo && r->t != r->hi) || !isfinite(r->t)) failed(q, "t", i);
    if ((r->t == 0 && signbit(r->t)) || (r->lo == 0 && signbit(r->lo)) || (r->hi == 0 && signbit(r->hi)))
        failed(q, "a zero below zero", i);
}

static void judge_once(const query *q) {
    algsurf_memory m;
    algsurf_exact_walk walk;
    algsurf_exact_root r;
    algsurf_observer observer = {.size = sizeof observer};
    const algsurf_i_watch watch = {.observer = &observer};
    algsurf_zpoly p = known_in_unit(q->k->p, q->unit);
    int i = 0, found;
    for (int w = 0; w < STACK_WORDS; w++) stack[w] = 0xdeadbeefdeadbeefu + (uint64_t)w;
    algsurf_memory_begin(&m, stack, (size_t)random_int(&(uint64_t){(uint64_t)q->round}, STACK_WORDS), LIMIT);
    if (!algsurf_exact_begin(&walk, &m, &p, q->unit, q->lo, q->hi, q->refine, q->refine ? &watch : NULL))
        failed(q, "begin", 0);
    while (i < q->k->count && known_compare_double(q->k->root[i], q->lo) < 0) i++;
    for (; (found = algsurf_exact_next(&walk, &r)) == ALGSURF_EXACT_ROOT; i++) {
        if (i >= q->k->count || known_compare_double(q->k->root[i], q->hi) > 0)
            failed(q, "a root too many", i);
        judge_root(q, &r, i);
    }
    if (found != ALGSURF_EXACT_END) failed(q, "no memory", i);
    if (i < q->k->count && known_compare_double(q->k->root[i], q->hi) <= 0) failed(q, "a root is missing", i);
    counted = observer.cells;
    algsurf_exact_end(&walk);
    if (m.at != stack || m.allocated != 0) failed(q, "memory not given back", i);
    free(p.c);
}

/* Returns how many roots are in [lo,hi]. */
static int judge(const known *k, int unit, double lo, double hi, const char *family, int round) {
    int inside = 0;
    for (int refine = 0; refine < 2; refine++) judge_once(&(query){k, unit, refine, lo, hi, family, round});
    for (int i = 0; i < k->count; i++)
        inside += known_compare_double(k->root[i], lo) >= 0 && known_compare_double(k->root[i], hi) <= 0;
    return inside;
}

static int judge_line(const known *k, int unit, const char *family, int round) {
    return judge(k, unit, -HUGE_VAL, HUGE_VAL, family, round);
}

/* ---- random numbers ---- */

/* Rational, mostly not dyadic, of size up to 2. */
static void random_rational(uint64_t *seed, mpq_t x) {
    long denominator = 3 + 2 * random_int(seed, 500);
    mpq_set_si(x, (long)random_int(seed, (int)(4 * denominator)) - 2 * denominator,
               (unsigned long)denominator);
    mpq_canonicalize(x);
}

/* A multiple of 2^-bits, of size up to 2. */
static void random_dyadic(uint64_t *seed, mpq_t x, int bits) {
    mpq_set_si(x, (long)random_int(seed, 4 << bits) - (2 << bits), 1ul << bits);
    mpq_canonicalize(x);
}

static void power_of_two(mpq_t x, int exponent) {
    mpq_set_ui(x, 1, 1);
    known_shift(x, x, exponent);
}

/* A double next to x, or x itself, or within some ulps. */
static double double_near(uint64_t *seed, const mpq_t x) {
    double d = mpq_get_d(x);
    for (int steps = random_int(seed, 4); steps > 0; steps--)
        d = nextafter(d, random_bits(seed) & 1 ? HUGE_VAL : -HUGE_VAL);
    return d;
}

/* An interval with ends at, near or apart from the roots; one in eight has only one point. */
static void random_interval(uint64_t *seed, const known *k, double *lo, double *hi) {
    double end[2];
    for (int i = 0; i < 2; i++) {
        end[i] = ldexp(random_unit(seed), 1 + random_int(seed, 4) - random_int(seed, 8));
        if (k->count && random_int(seed, 3) == 0)
            end[i] = double_near(seed, k->root[random_int(seed, k->count)]->base);
    }
    if (random_int(seed, 8) == 0) end[1] = end[0];
    if (random_int(seed, 8) == 0) end[0] = -HUGE_VAL;
    if (random_int(seed, 8) == 0) end[1] = HUGE_VAL;
    *lo = fmin(end[0], end[1]), *hi = fmax(end[0], end[1]);
}

/* A factor of a random kind. */
static void add_some(uint64_t *seed, known *k, int multiplicity) {
    int kind = random_int(seed, 10);
    if (kind < 3) {
        random_rational(seed, k->x);
        known_add(k, k->x, multiplicity);
    } else if (kind < 7) {
        random_dyadic(seed, k->x, random_int(seed, 7));
        known_add(k, k->x, multiplicity);
    } else {
        random_rational(seed, k->x);
        int below = -1 - random_int(seed, 3), bits = 2 * random_int(seed, 6); /* in this order */
        mpq_set_si(k->y, kind < 9 ? 2 : below, 1ul << bits);
        mpq_canonicalize(k->y);
        known_add_pair(k, k->x, k->y, multiplicity);
    }
}

/* ---- families ---- */

TEST(test_products) {
    uint64_t seed = SEED;
    known *k = known_new();
    int inside = 0, multiple = 0, none = 0, ends = 0;
    for (int i = 0; i < 2500; i++) {
        known_clear(k);
        for (int factors = 1 + random_int(&seed, 5); factors > 0 && k->p->n < 16; factors--)
            add_some(&seed, k, random_int(&seed, 3) ? 1 : 1 + random_int(&seed, 8));
        double lo, hi;
        random_interval(&seed, k, &lo, &hi);
        int found = judge(k, random_int(&seed, 120) - 60, lo, hi, "products", i);
        inside += found, none += found == 0;
        for (int j = 0; j < k->count; j++) {
            multiple += k->root[j]->multiplicity > 1;
            ends += known_compare_double(k->root[j], lo) == 0 || known_compare_double(k->root[j], hi) == 0;
        }
    }
    printf("products: %d roots, %d of them multiple, %d intervals without, %d ends\n", inside, multiple, none,
           ends);
    assert_true(inside > 2000 && multiple > 1500 && none > 300 && ends > 100);
}

/* Two roots 2^-bits apart at a rational place, or sqrt(2) 2^(1-bits), or a pair of complex ones as close. */
static void add_gap(uint64_t *seed, known *k, int bits) {
    int kind = random_int(seed, 3);
    random_rational(seed, k->x);
    if (kind == 0) {
        known_add(k, k->x, 1);
        power_of_two(k->y, -bits);
        mpq_add(k->x, k->x, k->y);
        known_add(k, k->x, 1);
    } else {
        power_of_two(k->y, 1 - 2 * bits);
        if (kind == 2) mpq_neg(k->y, k->y);
        known_add_pair(k, k->x, k->y, 1);
    }
}

TEST(test_gaps) {
    uint64_t seed = SEED + 1;
    known *k = known_new();
    int found = 0;
    for (int i = 0; i < 400; i++) {
        known_clear(k);
        add_gap(&seed, k, 1 + random_int(&seed, 300));
        if (i % 3 == 0) add_gap(&seed, k, 1 + random_int(&seed, 60));
        for (int others = random_int(&seed, 7); others > 0; others--) add_some(&seed, k, 1);
        double lo = -1 - fabs(random_unit(&seed)),
               hi = i % 2 || !k->count ? 1.5 : mpq_get_d(k->root[0]->base);
        found += i % 5 ? judge(k, -4, fmin(lo, hi), hi, "gaps", i) : judge_line(k, 0, "gaps", i);
    }
    for (int i = 0; i < 12; i++) {
        known_clear(k);
        add_gap(&seed, k, i % 4 == 0 ? 2000 : 1000);
        for (int others = i; others > 0; others--) add_some(&seed, k, 1);
        found += judge_line(k, i, "wide gaps", i);
        assert_true(counted > 0 &&
                    counted < 500 + 60 * (size_t)i); /* zooms: halvings alone would take 2000 */
    }
    assert_true(found > 800);
}

/* Gaps in higher degrees, which discs about all roots part: simple roots and multiple ones, intervals that
 * end among them, the root 0. */
TEST(test_gaps_of_many) {
    uint64_t seed = SEED + 9;
    known *k = known_new();
    int found = 0;
    for (int i = 0; i < 24; i++) {
        int multiplicity = 1 + (i % 4 == 3);
        known_clear(k);
        add_gap(&seed, k, 50 + random_int(&seed, 250));
        if (i % 2) add_gap(&seed, k, 50 + random_int(&seed, 100));
        while (k->p->n < 34 * multiplicity) add_some(&seed, k, multiplicity);
        if (i % 5 == 0) mpq_set_ui(k->x, 0, 1), known_add(k, k->x, multiplicity);
        double hi = i % 3 || !k->count ? 1.5 : mpq_get_d(k->root[k->count / 2]->base);
        found +=
            i % 2 ? judge(k, -4, fmin(-1, hi), hi, "gaps of many", i) : judge_line(k, 0, "gaps of many", i);
    }
    assert_true(found > 300);
}

/* Clusters: several roots within 2^-bits, simple ones or with multiplicities. */
TEST(test_clusters) {
    uint64_t seed = SEED + 2;
    known *k = known_new();
    for (int i = 0; i < 150; i++) {
        int bits = 20 + random_int(&seed, 120), roots = 2 + random_int(&seed, 4);
        known_clear(k);
        random_rational(&seed, k->x);
        power_of_two(k->y, -bits);
        for (int j = 0; j < roots; j++) {
            random_rational(&seed, k->z);
            mpq_mul(k->z, k->z, k->y);
            mpq_add(k->z, k->z, k->x);
            known_add(k, k->z, i % 3 ? 1 : 1 + random_int(&seed, 3));
        }
        add_some(&seed, k, 1);
        judge_line(k, 0, "clusters", i);
        double at = mpq_get_d(k->x);
        judge(k, -10, at - 0x1p-12, at + 0x1p-13, "clusters, short", i);
    }
}

/* A root with two complex ones as near to it as the next doubles: cells between neighbours. */
TEST(test_near_doubles) {
    uint64_t seed = SEED + 8;
    known *k = known_new();
    for (int i = 0; i < 1500; i++) {
        known_clear(k);
        random_rational(&seed, k->x);
        if (mpq_sgn(k->x) == 0) continue;
        known_add(k, k->x, 1);
        power_of_two(k->z, -46 - random_int(&seed, 10));
        random_rational(&seed, k->y);
        mpq_mul(k->y, k->y, k->z), mpq_add(k->x, k->x, k->y);
        mpq_mul(k->y, k->z, k->z), mpq_neg(k->y, k->y);
        known_add_pair(k, k->x, k->y, 1);
        double at = mpq_get_d(k->x);
        judge(k, 0, i % 2 ? -HUGE_VAL : at - fabs(at) * 0x1p-40, i % 2 ? HUGE_VAL : at + fabs(at) * 0x1p-38,
              "near", i);
    }
}

/* The piece of an interval has it inside, whatever the sizes of its ends, and is on its side of 0. */
TEST(test_piece) {
    uint64_t seed = SEED + 9;
    mpq_t x, y;
    mpq_inits(x, y, NULL);
    for (int i = 0; i < 20000; i++) {
        double a = ldexp(random_unit(&seed), random_int(&seed, 2098) - 1074),
               b = i % 3 ? ldexp(random_unit(&seed), random_int(&seed, 2098) - 1074) : nextafter(a, 1);
        if (i % 100 == 0) a = -DBL_MAX;
        if (i % 100 == 1) b = DBL_MAX;
        double lo = fmin(a, b), hi = fmax(a, b);
        algsurf_exact_piece piece = algsurf_exact_piece_of(lo, hi);
        mpq_set_si(x, (long)piece.at, 1), known_shift(x, x, piece.unit);
        mpq_set_d(y, lo);
        int inside = mpq_cmp(x, y) <= 0;
        mpq_set_si(x, (long)piece.at + (1L << piece.length), 1), known_shift(x, x, piece.unit);
        mpq_set_d(y, hi);
        int across = (lo > 0 && piece.at < 0) || (hi < 0 && mpq_sgn(x) > 0);
        if (!inside || mpq_cmp(x, y) <= 0 || piece.length > 5 || across)
            fail_msg("piece of [%a, %a]", lo, hi);
    }
    mpq_clears(x, y, NULL);
}

/* Roots at ends, at places where cells and pieces are cut, at powers of two and at 0. */
TEST(test_cuts) {
    uint64_t seed = SEED + 3;
    known *k = known_new();
    int found = 0;
    for (int i = 0; i < 800; i++) {
        known_clear(k);
        for (int j = 1 + random_int(&seed, 5); j > 0; j--) {
            int kind = random_int(&seed, 4);
            random_dyadic(&seed, k->x, kind == 0 ? 0 : kind == 1 ? 2 : 5);
            if (kind == 3) {
                power_of_two(k->x, random_int(&seed, 60) - 30);
                if (random_bits(&seed) & 1) mpq_neg(k->x, k->x);
            }
            if (random_int(&seed, 6) == 0) mpq_set_ui(k->x, 0, 1);
            known_add(k, k->x, 1 + random_int(&seed, 3) / 2 * (1 + random_int(&seed, 3)));
        }
        if (i % 3 == 0) add_gap(&seed, k, 5 + random_int(&seed, 20));
        double lo = i % 4 == 0   ? -1
                    : i % 4 == 1 ? 0
                                 : -HUGE_VAL,
               hi = i % 4 == 0   ? 1
                    : i % 4 == 1 ? 0.75
                                 : HUGE_VAL;
        if (i % 8 == 3) lo = hi = mpq_get_d(k->root[0]->base);
        found += judge(k, random_int(&seed, 9) - 4, lo, hi, "cuts", i);
    }
    assert_true(found > 1000);
}

/* Roots over and beyond the whole range of doubles, subnormal, and intervals of every size. */
TEST(test_scales) {
    uint64_t seed = SEED + 4;
    known *k = known_new();
    int huge = 0, tiny = 0;
    for (int i = 0; i < 250; i++) {
        known_clear(k);
        int roots = 1 + random_int(&seed, 4), range = i % 3 ? 1100 : 1500;
        for (int j = 0; j < roots; j++) {
            int shift = random_int(&seed, 2 * range) - range;
            if (i % 5 == 0) shift = random_int(&seed, 8) - 1076;
            if (i % 5 == 1) shift = 1020 + random_int(&seed, 6);
            if (random_int(&seed, 3))
                random_rational(&seed, k->x);
            else
                random_dyadic(&seed, k->x, 3);
            known_shift(k->x, k->x, shift);
            known_add(k, k->x, 1 + (i % 7 == 0));
            mpq_abs(k->x, k->x);
            mpq_set_d(k->y, DBL_MAX), huge += mpq_cmp(k->x, k->y) > 0;
            mpq_set_d(k->y, 0x1p-1074), tiny += mpq_cmp(k->x, k->y) < 0 && mpq_sgn(k->x) != 0;
        }
        int unit = random_int(&seed, 400) - 200;
        judge_line(k, unit, "scales", i);
        double lo = ldexp(random_unit(&seed), random_int(&seed, 2098) - 1074),
               hi = ldexp(random_unit(&seed), random_int(&seed, 2098) - 1074);
        judge(k, unit, fmin(lo, hi), fmax(lo, hi), "scales, finite", i);
        judge(k, unit, -DBL_MAX, DBL_MAX, "scales, all doubles", i);
        double at = mpq_get_d(k->root[0]->base);
        if (isfinite(at)) judge(k, unit, at, nextafter(at, HUGE_VAL), "scales, neighbours", i);
    }
    assert_often(huge > 30 && tiny > 60);
}

/* Tiny intervals far from 0 that hold roots closer than that. */
TEST(test_far) {
    uint64_t seed = SEED + 5;
    known *k = known_new();
    int found = 0;
    for (int i = 0; i < 150; i++) {
        known_clear(k);
        int far = random_int(&seed, 60);
        double at = ldexp(1 + fabs(random_unit(&seed)), far), width = ldexp(at, -10 - random_int(&seed, 42));
        for (int j = 0; j < 3; j++) {
            random_rational(&seed, k->x);
            mpq_set_d(k->y, width), mpq_mul(k->x, k->x, k->y);
            mpq_set_d(k->y, at), mpq_add(k->x, k->x, k->y);
            known_add(k, k->x, 1);
        }
        add_some(&seed, k, 1);
        if (i % 4 == 0) add_gap(&seed, k, 60);
        found += judge(k, i % 2 ? far - 53 : 0, at - width, at + width, "far", i);
        at = -at;
        judge(k, 0, at - width, at + width, "far, other side", i);
    }
    assert_true(found > 100);
}

/* ---- sizes far apart ---- */

/* c = +-2^(eighths k / 8) + d, or d alone for eighths < 0. */
typedef struct far_coefficient {
    int sign, eighths;
    long d;
} far_coefficient;

/* The roots of the cubic or quartic for this k, and the time. */
static double far_roots(const far_coefficient c[5], int k, algsurf_real_root root[4], int *count) {
    algsurf_integer z[5];
    mpz_t value[5];
    int n = 4;
    for (int i = 0; i <= 4; i++) {
        mpz_init(value[i]);
        if (c[i].eighths >= 0) mpz_setbit(value[i], (mp_bitcnt_t)(c[i].eighths * (k / 8)));
        if (c[i].sign < 0) mpz_neg(value[i], value[i]);
        if (c[i].d >= 0) mpz_add_ui(value[i], value[i], (unsigned long)c[i].d);
        if (c[i].d < 0) mpz_sub_ui(value[i], value[i], (unsigned long)-c[i].d);
        z[i] = (algsurf_integer){(const uint64_t *)mpz_limbs_read(value[i]),
                                 mpz_sgn(value[i]) * (int)mpz_size(value[i])};
    }
    while (z[n].length == 0) n--;
    double start = unit_seconds();
    algsurf_status status = algsurf_real_roots_integers(z, n, -HUGE_VAL, HUGE_VAL, root, 4, count);
    double seconds = unit_seconds() - start;
    assert_ok(status);
    for (int i = 0; i <= 4; i++) mpz_clear(value[i]);
    return seconds;
}

/* One coefficient or several with very many bits: the same roots for all k that put them beyond the doubles,
 * and the time grows less than with the square of the bits. */
TEST(test_sizes) {
    static const far_coefficient cases[][5] = {
        {{0, -1, 1}, {-1, 8, 1}, {0, -1, 1}, {0, -1, 1}, {0, -1, 0}}, /* 1 - (2^k - 1) t + t^2 + t^3 */
        {{0, -1, 1}, {-1, 8, 0}, {0, -1, 1}, {0, -1, 0}, {0, -1, 0}}, /* 1 - 2^k t + t^2 */
        {{1, 8, 0}, {0, -1, -1}, {0, -1, 0}, {0, -1, 1}, {0, -1, 0}}, /* 2^k - t + t^3 */
        {{0, -1, -1}, {0, -1, 0}, {0, -1, 0}, {0, -1, 0}, {1, 8, 0}}, /* -1 + 2^k t^4 */
        {{0, -1, 1}, {-1, 8, 1}, {1, 8, 3}, {0, -1, -1}, {0, -1, 0}}, /* roots 2^-k, 1, 2^k */
        {{0, -1, 3}, {-1, 8, -1}, {1, 7, 1}, {-1, 4, 1}, {0, -1, 1}}, /* a root 2^(k/8), and pairs */
        {{0, -1, -2}, {1, 5, 0}, {-1, 8, 0}, {0, -1, 0}, {0, -1, 1}}, /* -2 + .. t - 2^k t^2 + t^4 */
        {{0, -1, -1}, {1, 2, 0}, {-1, 4, 0}, {1, 6, 0}, {-1, 8, 0}},  /* four sizes at equal distances */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        algsurf_real_root few[4], many[4];
        int n, count;
        double time = 0, longer = HUGE_VAL;
        (void)far_roots(cases[i], 1 << 14, few, &n);
        for (int k = 0; k < 3; k++) longer = fmin(longer, far_roots(cases[i], 1 << 18, many, &count));
        for (int k = 0; k < 16; k++) time += far_roots(cases[i], 1 << 14, few, &n); /* as many bits */
        if (longer > 8 * time + 0.05) fail_msg("case %zu: %g s for 16 times the bits, %g", i, longer, time);
        assert_int_equal(n, count);
        for (int k = 0; k < n; k++)
            if (few[k].lo != many[k].lo || few[k].hi != many[k].hi || few[k].sign != many[k].sign)
                fail_msg("case %zu, root %d: [%a, %a] and [%a, %a]", i, k, few[k].lo, few[k].hi, many[k].lo,
                         many[k].hi);
    }
}

/* ---- named polynomials ---- */

static double seconds_of(const known *k, double lo, double hi) {
    double start = unit_seconds();
    judge_once(&(query){k, 0, 1, lo, hi, "timed", 0});
    return unit_seconds() - start;
}

TEST(test_powers) {
    known *k = known_new();
    mpq_set_ui(k->x, 1, 1);
    known_add(k, k->x, 512); /* (t - 1)^512 */
    assert_true(seconds_of(k, -HUGE_VAL, HUGE_VAL) < 20);
    judge(k, 0, 0, 1, "(t-1)^512", 0);
    judge(k, 0, 1, 1, "(t-1)^512", 1);
    judge(k, 0, 0.5, 2.25, "(t-1)^512", 2);
    known_clear(k);
    mpq_set_ui(k->x, 1, 3), mpq_set_ui(k->y, 2, 1);
    known_add_pair(k, k->x, k->y, 24); /* a quadric's 24th power */
    judge_line(k, 0, "quadric", 0);
    mpq_set_ui(k->x, 5, 7);
    known_add(k, k->x, 5);
    judge(k, -3, -2, 1.75, "quadric", 1);
    known_clear(k);
    mpq_set_ui(k->x, 1, 3), mpq_set_si(k->y, -2, 1);
    known_add_pair(k, k->x, k->y, 24); /* no root */
    judge_line(k, 0, "quadric", 2);
    known_clear(k);
    for (int i = 0; i < 6; i++) { /* equal multiplicities and different ones */
        mpq_set_ui(k->x, (unsigned long)(2 * i + 1), 3);
        known_add(k, k->x, i < 3 ? 4 : i);
    }
    judge_line(k, 0, "staircase", 0);
}

TEST(test_wilkinson) {
    known *k = known_new();
    for (int n = 1; n <= 64; n += n < 20 ? 1 : 11) {
        known_clear(k);
        for (int i = 1; i <= n; i++) {
            mpq_set_si(k->x, i, 1);
            known_add(k, k->x, 1);
        }
        judge_line(k, 0, "Wilkinson", n);
        judge(k, 0, 1, n, "Wilkinson", n);
        judge(k, 2, 1.5, n - 0.5 > 1.5 ? n - 0.5 : 2, "Wilkinson", n);
    }
}

/* ---- as many roots as the degree, each shown by a change of sign ---- */

static void judge_all_real(const exact_zpoly *p, int unit, const char *family) {
    algsurf_zpoly q = known_in_unit(p, unit);
    for (int refine = 0; refine < 2; refine++) {
        algsurf_memory m;
        algsurf_exact_walk walk;
        algsurf_exact_root r;
        double last = -HUGE_VAL;
        int count = 0, found;
        algsurf_memory_begin(&m, stack, STACK_WORDS, LIMIT);
        assert_true(algsurf_exact_begin(&walk, &m, &q, unit, -HUGE_VAL, HUGE_VAL, refine, NULL));
        for (; (found = algsurf_exact_next(&walk, &r)) == ALGSURF_EXACT_ROOT; count++) {
            const algsurf_exact_place *at = &r.place;
            if (r.lo < last || r.multiplicity != 1) fail_msg("%s: degree %d root %d", family, p->n, count);
            int before = sign_at(&q, at->a, at->width, at->r);
            int after = at->b ? sign_at(&q, at->b, at->width, at->r) : 0;
            if (at->b ? before * after >= 0 || r.sign_before != before : before != 0)
                fail_msg("%s: degree %d root %d, signs", family, p->n, count);
            if (refine && r.lo != r.hi && nextafter(r.lo, HUGE_VAL) != r.hi)
                fail_msg("%s: degree %d root %d, width", family, p->n, count);
            last = r.hi;
        }
        if (found || count != p->n) fail_msg("%s: degree %d, %d roots", family, p->n, count);
        algsurf_exact_end(&walk);
        assert_true(m.at == stack && m.allocated == 0);
    }
    free(q.c);
}

/* Chebyshev's and Legendre's polynomials by their recurrences. */
TEST(test_orthogonal) {
    for (int legendre = 0; legendre < 2; legendre++) {
        exact_zpoly *before = exact_zpoly_new(), *p = exact_zpoly_new(), *next = exact_zpoly_new();
        exact_zpoly_constant(before, 1);
        p->n = 1, mpz_set_ui(p->c[0], 0), mpz_set_ui(p->c[1], 1);
        for (int n = 1; n <= 96; n++) {
            if (n < 12 || n % 17 == 0 || n == 64 || n == 96)
                judge_all_real(p, n % 3 - 1, legendre ? "Legendre" : "Chebyshev");
            /* p_(n+1) = a t p_n - b p_(n-1), times n + 1 for Legendre's, whose p_n here carries n! */
            long a = legendre ? 2 * n + 1 : 2, b = legendre ? (long)n * n : 1;
            for (int k = 0; k <= n + 1; k++) {
                mpz_set_ui(next->c[k], 0);
                if (k > 0) mpz_addmul_ui(next->c[k], p->c[k - 1], (unsigned long)a);
                if (k < n) mpz_submul_ui(next->c[k], before->c[k], (unsigned long)b);
            }
            next->n = n + 1;
            exact_zpoly_set(before, p), exact_zpoly_set(p, next);
        }
        exact_zpoly_free(before), exact_zpoly_free(p), exact_zpoly_free(next);
    }
}

/* c_i = 2^(-k i^2), alternating or not: for k >= 2 all roots are real and different (Kurtz 1992). */
TEST(test_lacunary) {
    exact_zpoly *p = exact_zpoly_new();
    for (int n = 1; n <= 40; n += n < 8 ? 1 : 8)
        for (int k = 2; k <= 10; k += 4)
            for (int alternate = 0; alternate < 2; alternate++) {
                p->n = n;
                for (int i = 0; i <= n; i++) {
                    mpz_set_ui(p->c[i], 0), mpz_setbit(p->c[i], (mp_bitcnt_t)(k * (n * n - i * i)));
                    if (alternate && i % 2) mpz_neg(p->c[i], p->c[i]);
                }
                judge_all_real(p, k, "lacunary");
            }
    exact_zpoly_free(p);
}

/* ---- against a Sturm chain ---- */

static void judge_doubles(const double *c, int n, int unit, double lo, double hi, const char *family) {
    exact_sturm s = exact_sturm_of_doubles(c, n);
    int truth = exact_count_roots(&s, lo, hi);
    for (int refine = 0; refine < 2; refine++) {
        algsurf_memory m;
        algsurf_exact_walk walk;
        algsurf_exact_root r;
        algsurf_zpoly p;
        int count = 0, found;
        double last = lo;
        algsurf_memory_begin(&m, stack, STACK_WORDS, LIMIT);
        const int least = algsurf_zpoly_least_bit(c, 1, n, unit);
        assert_true(algsurf_zpoly_from_doubles(&m, c, 1, n, unit, least, &p));
        assert_true(algsurf_exact_begin(&walk, &m, &p, unit, lo, hi, refine, NULL));
        for (; (found = algsurf_exact_next(&walk, &r)) == ALGSURF_EXACT_ROOT; count++) {
            int inside = exact_count_roots(&s, r.lo, r.hi), ends = 0;
            if (r.lo < r.hi)
                ends =
                    (isfinite(r.lo) && exact_is_root(&s, r.lo)) + (isfinite(r.hi) && exact_is_root(&s, r.hi));
            /* neighbouring doubles may hold several */
            if (inside < 1 || (inside - ends > 1 && !refine && nextafter(r.lo, HUGE_VAL) != r.hi) ||
                r.lo < last) {
                exact_print_doubles("c", c, n + 1);
                fail_msg("%s: root %d of [%a, %a]: [%a, %a] has %d, refine %d", family, count, lo, hi, r.lo,
                         r.hi, inside, refine);
            }
            last = refine ? r.lo : last;
        }
        if (found != ALGSURF_EXACT_END || count != truth) {
            exact_print_doubles("c", c, n + 1);
            fail_msg("%s: %d roots of %d in [%a, %a], unit %d, refine %d", family, count, truth, lo, hi, unit,
                     refine);
        }
        algsurf_exact_end(&walk);
    }
    exact_sturm_clear(&s);
}

TEST(test_random) {
    uint64_t seed = SEED + 6;
    double c[129];
    for (int i = 0; i < 350; i++) {
        int n = 1 + random_int(&seed, i % 50 ? 12 : 40), range = i % 3 == 0 ? 0 : i % 3 == 1 ? 30 : 1000;
        if (n > 8 && range > 30) n = 8;
        for (int k = 0; k <= n; k++)
            c[k] = ldexp(random_unit(&seed), random_int(&seed, 2 * range + 1) - range);
        for (int k = 0; k < n; k++)
            if (random_int(&seed, 6) == 0) c[k] = 0;
        double lo = ldexp(random_unit(&seed), range / (n + 1)),
               hi = ldexp(random_unit(&seed), range / (n + 1));
        judge_doubles(c, n, random_int(&seed, 40) - 20, -HUGE_VAL, HUGE_VAL, "random");
        judge_doubles(c, n, random_int(&seed, 40) - 20, fmin(lo, hi), fmax(lo, hi), "random, finite");
        judge_doubles(c, n, -4, -1, 1, "random, unit");
    }
    for (int n = 1; n <= 8; n++) /* a term that the others outweigh together, though each is far below it */
        for (int e = -3; e <= 3; e++) {
            for (int k = 1; k <= n; k++) c[k] = -ldexp(0x1p8 - 0x1p-1, -k * (1 + e));
            c[0] = 512;
            judge_doubles(c, n, e, -HUGE_VAL, HUGE_VAL, "outweighed");
            judge_doubles(c, n, 0, -0x1p100, 0x1p100, "outweighed");
            for (int k = 1; k <= n; k++) c[k] = -ldexp(floor(ldexp(1, 8 - k)) - 1 + (k == 8), -k * e);
            c[n + 1] = ldexp(1, -200), c[n + 2] = -1; /* far roots, for pieces */
            judge_doubles(c, n + 2, 0, -HUGE_VAL, HUGE_VAL, "outweighed");
        }
    for (int n = 3; n <= 30; n += 3) { /* Mignotte: x^n - 2 (2^20 x - 1)^2 */
        memset(c, 0, sizeof c);
        c[0] = -2, c[1] = 0x1p22, c[2] = -0x1p41, c[n] += 1;
        judge_doubles(c, n, 0, -HUGE_VAL, HUGE_VAL, "Mignotte");
        judge_doubles(c, n, -2, 0, 1, "Mignotte");
        c[1] = 2 * 2e5, c[2] = -2 * 1e10; /* at 1/100000 */
        judge_doubles(c, n, 0, -HUGE_VAL, HUGE_VAL, "Mignotte, decimal");
    }
}

/* ---- memory ---- */

static int tried; /* limits that were too low */

/* With every limit from 0 on: a right answer or NO_MEMORY, and all is given back. */
static void judge_limits(const known *k, size_t words, size_t step) {
    algsurf_zpoly p = known_in_unit(k->p, 0);
    int refused = 0, done = 0;
    for (size_t limit = 0; !done; limit += step) {
        algsurf_memory m;
        algsurf_exact_walk walk;
        algsurf_exact_root r;
        int count = 0, found = ALGSURF_EXACT_NO_MEMORY, sign;
        algsurf_limb one[2] = {1, 1};
        algsurf_zpoly q = {1, 1, one};
        algsurf_memory_begin(&m, stack, words, limit);
        if (algsurf_exact_begin(&walk, &m, &p, 0, -HUGE_VAL, HUGE_VAL, 1, NULL))
            while ((found = algsurf_exact_next(&walk, &r)) == ALGSURF_EXACT_ROOT) {
                assert_true(known_compare_double(k->root[count], r.lo) >= 0);
                assert_true(known_compare_double(k->root[count], r.hi) <= 0);
                assert_int_equal(r.multiplicity, k->root[count]->multiplicity);
                if (algsurf_exact_sign_at_root(&walk, &r, &q, &sign)) {
                    mpq_t minus_one;
                    mpq_init(minus_one), mpq_set_si(minus_one, -1, 1);
                    assert_int_equal(sign, known_compare(k->root[count], minus_one));
                    mpq_clear(minus_one);
                }
                count++;
            }
        algsurf_exact_end(&walk);
        assert_true(m.at == stack && m.allocated == 0);
        done = found == ALGSURF_EXACT_END;
        refused += !done;
        if (done) assert_int_equal(count, k->count);
    }
    if (words == 0) assert_true(refused > 0);
    tried += refused;
    free(p.c);
}

TEST(test_memory) {
    uint64_t seed = SEED + 7;
    known *k = known_new();
    static const size_t words[] = {0, 1, 50, 300};
    for (int i = 0; i < 24; i++) {
        known_clear(k);
        add_gap(&seed, k, 20 + 10 * i);
        for (int j = 0; j < i % 5; j++) add_some(&seed, k, 1 + (i % 4 == 0));
        if (i % 3 == 0) add_gap(&seed, k, 30);
        judge_limits(k, words[i % 4], i % 2 ? 88 : 504);
    }
    assert_true(tried > 100);
}
