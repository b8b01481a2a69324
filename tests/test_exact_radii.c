/* test_exact_radii.c - polynomials known up to radii: what is said of all of them, asked of some, by Sturm
 * chains.
 *
 * Members of the set: both envelopes, the middle, random ones with errors at the ends of their radii and
 * between, and for each decided range those with a root there that are steepest and flattest.  Where no range
 * is, no member has a root; a decided range has one root of each, with the sign before it that was given.
 *
 * Breaks caught, each tried: an envelope without the signs of odd powers, one for both sides, hidden points
 * between two roots left out, ranges not joined at 0 or when there is no room, an end that is a root taken
 * for a known sign, ends of one sign taken for a root, a double root not asked for, also at 0 or with one m
 * only, terms left out of the bound from the middle of a range, m chosen and not proved, outermost pieces
 * left out on one side, an annulus judged by its wrong end or by some of its terms. */
#include "exact_roots.h"
#include "exact_zpolys.h"

#include "roots/exact_walk.h"
#include "unit.h"

#define SEED 20250313u
enum { MOST = 80 };

static uint64_t stack[400];
static long decided, undecided, exact_points, about_zero, beyond, tilted;

typedef struct set {
    exact_zpoly *p, *radius, *member;
    double lo, hi;
    int capacity, round;
    algsurf_exact_range found[MOST];
    int count;
} set;

static void failed(const set *s, const char *what, int i) {
    exact_zpoly_print("p", s->p), exact_zpoly_print("radius", s->radius),
        exact_zpoly_print("member", s->member);
    for (int k = 0; k < s->count; k++)
        fprintf(stderr, "[%a, %a] %d\n", s->found[k].lo, s->found[k].hi, s->found[k].sign_lo);
    fail_msg("%s: range %d in [%a, %a], round %d seed %u", what, i, s->lo, s->hi, s->round, SEED);
}

static void judge_member(const set *s) {
    exact_sturm chain = exact_sturm_of(s->member->c, s->member->n);
    if (s->member->n < 0) {
        exact_sturm_clear(&chain);
        return;
    }
    double from = s->lo;
    int begun = 0;
    for (int i = 0; i <= s->count; i++) {
        double to = i < s->count ? s->found[i].lo : s->hi;
        int roots =
            to > from || (to == from && !begun && i == s->count) ? exact_count_roots(&chain, from, to) : 0;
        if (roots && begun) roots -= exact_is_root(&chain, from);
        if (roots && i < s->count && to > from) roots -= exact_is_root(&chain, to);
        if (roots) failed(s, "a root outside, before", i);
        if (i == s->count) break;
        const algsurf_exact_range *r = s->found + i;
        from = r->hi, begun = 1;
        if (!r->sign_lo) continue;
        int at_lo = exact_integers_sign(s->member->c, s->member->n, r->lo),
            at_hi = exact_integers_sign(s->member->c, s->member->n, r->hi);
        if (exact_count_roots(&chain, r->lo, r->hi) != 1) failed(s, "not one root", i);
        if ((at_lo != r->sign_lo && at_lo != 0) || (at_hi != -r->sign_lo && at_hi != 0))
            failed(s, "signs", i);
    }
    exact_sturm_clear(&chain);
}

/* The member with a root at t, not 0, where its slope is as far from the middle one's as it can be: all
 * errors are at an end of their radii, on one side for k < m and on the other one for k > m, but that of m.
 * Returns 0 if there is none. */
static int tilt(const set *s, double t, int m, int up) {
    exact_zpoly *q = s->member;
    mpz_t odd, power, f, sum;
    int n = s->p->n, inside, e = 52 - ilogb(t) > 0 ? 52 - ilogb(t) : 0; /* t 2^e is an integer */
    mpz_inits(odd, power, f, sum, NULL);
    mpz_set_d(odd, ldexp(t, e));
    q->n = n;
    for (int k = 0; k <= n; k++) { /* the term k, times 2^(e n) */
        mpz_set(q->c[k], s->p->c[k]);
        int add = (k > m) == up;
        if (t < 0 && k % 2) add = !add;
        if (k != m && k <= s->radius->n && add) mpz_add(q->c[k], q->c[k], s->radius->c[k]);
        if (k != m && k <= s->radius->n && !add) mpz_sub(q->c[k], q->c[k], s->radius->c[k]);
        mpz_pow_ui(power, odd, (unsigned)k), mpz_mul_2exp(power, power, (mp_bitcnt_t)(e * (n - k)));
        if (k == m) mpz_set(f, power);
        if (k != m) mpz_addmul(sum, power, q->c[k]);
    }
    mpz_neg(sum, sum); /* c_m f */
    mpz_mul(power, f, s->p->c[m]), mpz_sub(power, power, sum);
    mpz_mul(odd, f, s->radius->c[m]);
    inside = mpz_cmpabs(power, odd) <= 0;
    for (int k = 0; k <= n && inside; k++)
        if (k != m) mpz_mul(q->c[k], q->c[k], f);
    if (inside) mpz_set(q->c[m], sum);
    for (int k = 0; k <= n && mpz_sgn(f) < 0; k++) mpz_neg(q->c[k], q->c[k]);
    mpz_clears(odd, power, f, sum, NULL);
    return inside;
}

static void judge_tilted(const set *s, uint64_t *seed) {
    for (int i = 0; i < s->count; i++) {
        double lo = s->found[i].lo, hi = s->found[i].hi, size = fmax(fabs(lo), fabs(hi));
        if (!s->found[i].sign_lo || !(size < 0x1p60 && size > 0x1p-60)) continue;
        for (int k = 0; k < 4; k++) {
            int m = random_int(seed, s->p->n + 1), up = random_int(seed, 2);
            if (m > s->radius->n || mpz_sgn(s->radius->c[m]) == 0) continue;
            double t = lo + (hi - lo) * fabs(random_unit(seed));
            if (t == 0 || !tilt(s, t, m, up)) continue;
            tilted++;
            exact_zpoly_trim(s->member);
            judge_member(s);
        }
    }
}

static void judge(set *s, uint64_t *seed) {
    algsurf_memory m;
    algsurf_zpoly p = exact_to_zpoly(s->p, 0, 0), radius = exact_to_zpoly(s->radius, 0, 0);
    algsurf_memory_begin(&m, stack, 400, (size_t)1 << 28);
    assert_true(algsurf_exact_radii_isolate(&m, &p, &radius, 0, s->lo, s->hi, s->found, s->capacity,
                                            &s->count, NULL));
    assert_true(m.at == stack && m.allocated == 0 && s->count <= s->capacity);
    for (int i = 0; i < s->count; i++) {
        if (!(s->found[i].lo <= s->found[i].hi) || s->found[i].lo < s->lo || s->found[i].hi > s->hi ||
            (i && s->found[i].lo < s->found[i - 1].hi))
            failed(s, "order", i);
        decided += s->found[i].sign_lo != 0, undecided += s->found[i].sign_lo == 0;
        exact_points += s->found[i].lo == s->found[i].hi;
        about_zero += s->found[i].sign_lo != 0 && s->found[i].lo < 0 && s->found[i].hi > 0;
        beyond += s->found[i].sign_lo != 0 && isinf(s->found[i].lo + s->found[i].hi);
    }
    for (int kind = 0; kind < 9; kind++) {
        s->member->n = s->p->n;
        for (int k = 0; k <= s->p->n; k++) {
            int e = kind < 3 ? kind - 1 : kind == 3 ? (k % 2 ? 1 : -1) : random_int(seed, 3) - 1;
            e = kind < 6 ? 8 * e : random_int(seed, 17) - 8;
            mpz_mul_si(s->member->c[k], s->p->c[k], 8);
            if (e > 0 && k <= s->radius->n) mpz_addmul_ui(s->member->c[k], s->radius->c[k], (unsigned)e);
            if (e < 0 && k <= s->radius->n) mpz_submul_ui(s->member->c[k], s->radius->c[k], (unsigned)-e);
        }
        exact_zpoly_trim(s->member);
        judge_member(s);
    }
    judge_tilted(s, seed);
    free(p.c), free(radius.c);
}

static set *set_new(void) {
    set *s = calloc(1, sizeof *s);
    if (!s) abort();
    s->p = exact_zpoly_new(), s->radius = exact_zpoly_new(), s->member = exact_zpoly_new();
    s->capacity = MOST;
    return s;
}

static void set_free(set *s) {
    exact_zpoly_free(s->p), exact_zpoly_free(s->radius), exact_zpoly_free(s->member);
    free(s);
}

static void random_interval(uint64_t *seed, set *s) {
    double a = ldexp(random_unit(seed), random_int(seed, 8) - 2),
           b = ldexp(random_unit(seed), random_int(seed, 8) - 2);
    if (random_int(seed, 5) == 0) a = 0;
    if (random_int(seed, 5) == 0) a = floor(a);
    if (random_int(seed, 10) == 0) b = a;
    s->lo = fmin(a, b), s->hi = fmax(a, b);
    if (random_int(seed, 5) == 0) s->lo = random_int(seed, 3) ? -HUGE_VAL : -DBL_MAX;
    if (random_int(seed, 5) == 0) s->hi = random_int(seed, 3) ? HUGE_VAL : DBL_MAX;
}

/* Roots of sizes far apart, down to the least doubles and up to beyond the largest. */
static void spread_sizes(uint64_t *seed, set *s) {
    int most = random_int(seed, 3) ? 100 : 3000;
    for (int k = 0; k <= s->p->n; k++) {
        unsigned up = (unsigned)random_int(seed, most);
        mpz_mul_2exp(s->p->c[k], s->p->c[k], up);
        if (k <= s->radius->n) mpz_mul_2exp(s->radius->c[k], s->radius->c[k], up);
    }
}

/* p = product of (q t - a) with few bits, or random; radii of 0, of a few bits, or of as many as p has. */
static void make_set(uint64_t *seed, set *s) {
    int n = 1 + random_int(seed, 8), bits = 60, simple = random_int(seed, 3);
    exact_zpoly_constant(s->p, 1);
    if (simple) {
        for (int i = 0; i < n; i++) {
            s->member->n = 1;
            mpz_set_si(s->member->c[0], random_int(seed, 41) - 20);
            mpz_set_si(s->member->c[1], 1 + random_int(seed, simple == 1 ? 1 : 9));
            exact_zpoly_multiply(s->p, s->p, s->member);
        }
        for (int k = 0; k <= n; k++) mpz_mul_2exp(s->p->c[k], s->p->c[k], 40);
    } else {
        random_zpoly(seed, s->p, n, bits);
    }
    s->radius->n = n - (random_int(seed, 4) == 0);
    int size = 1 + random_int(seed, 60), none = random_int(seed, 5) == 0;
    for (int k = 0; k <= s->radius->n; k++) {
        random_mpz(seed, s->radius->c[k], size);
        mpz_abs(s->radius->c[k], s->radius->c[k]);
        if (none || random_int(seed, 4) == 0) mpz_set_ui(s->radius->c[k], 0);
    }
    if (random_int(seed, 3) == 0) mpz_fdiv_q_2exp(s->p->c[0], s->radius->c[0], 1);
    if (random_int(seed, 4) == 0) mpz_set(s->p->c[s->radius->n], s->radius->c[s->radius->n]);
    if (random_int(seed, 4) == 0) spread_sizes(seed, s);
    exact_zpoly_trim(s->p);
}

TEST(test_sets) {
    uint64_t seed = SEED;
    set *s = set_new();
    for (int i = 0; i < 1500; i++) {
        s->round = i;
        make_set(&seed, s);
        random_interval(&seed, s);
        s->capacity = i % 7 ? MOST : 1 + i % 3;
        judge(s, &seed);
    }
    assert_often(decided > 300 && undecided > 125 && exact_points > 10 && about_zero > 15 && beyond > 0);
    assert_often(tilted > 250);
    set_free(s);
}

/* p' has two roots, and the radius of c_0 hides all between them, or nearly so: members with one root and
 * with three.  Or a line from a small root to a large one that a little t^2 bends back, or not. */
static void make_bent(uint64_t *seed, set *s) {
    long a = random_int(seed, 2001) - 1000, b = a + 1 + random_int(seed, 500);
    int line = random_int(seed, 3) == 0;
    s->p->n = s->radius->n = line ? 2 : 3;
    for (int k = 0; k <= 3; k++) mpz_set_ui(s->p->c[k], 0), mpz_set_ui(s->radius->c[k], 0);
    if (line) { /* -(2^2w - c) + 2^w t + e t^2, 0 <= c < 2^w or so, |e| about 1/4 */
        unsigned w = 4 + (unsigned)random_int(seed, 30);
        mpz_setbit(s->p->c[0], 2 * w), mpz_neg(s->p->c[0], s->p->c[0]);
        mpz_setbit(s->radius->c[0], 2 * w), mpz_sub_ui(s->radius->c[0], s->radius->c[0], 3);
        mpz_setbit(s->p->c[1], w);
        mpz_set_si(s->radius->c[2], 1 + random_int(seed, 16));
        for (int k = 0; k < 2; k++)
            mpz_mul_2exp(s->p->c[k], s->p->c[k], 6), mpz_mul_2exp(s->radius->c[k], s->radius->c[k], 6);
    } else { /* p' = 6 (t - a)(t - b) */
        mpz_set_si(s->p->c[3], 2), mpz_set_si(s->p->c[2], -3 * (a + b)), mpz_set_si(s->p->c[1], 6 * a * b);
        mpz_set_si(s->p->c[0], (a + b) * (a * a + b * b - 4 * a * b) / 2 + random_int(seed, 21) - 10);
        long bend = (b - a) * (b - a) * (b - a) / 2; /* p is so much above 0 at a, and below at b */
        mpz_set_si(s->radius->c[0], bend / 8 * (7 + random_int(seed, 4)) + random_int(seed, 9));
        if (random_int(seed, 2)) mpz_set_si(s->radius->c[random_int(seed, 3) + 1], 1);
    }
    if (random_int(seed, 2)) /* -t for t */
        for (int k = 1; k <= 3; k += 2) mpz_neg(s->p->c[k], s->p->c[k]);
    s->lo = -HUGE_VAL, s->hi = HUGE_VAL;
}

TEST(test_bent) {
    uint64_t seed = SEED + 4;
    set *s = set_new();
    decided = undecided = 0;
    for (int i = 0; i < 800; i++) {
        s->round = i;
        make_bent(&seed, s);
        judge(s, &seed);
    }
    assert_often(decided > 160 && undecided > 160);
    set_free(s);
}

/* What a radius of 1 in the constant makes of a root at t, as doubles have it. */
static double reach_at(const exact_zpoly *p, double t) {
    double slope = 0;
    for (int k = p->n; k > 0; k--) slope = slope * t + k * mpz_get_d(p->c[k]);
    return 1 / fabs(slope);
}

/* Without radii, and with tiny ones, all simple roots are decided, and tight. */
TEST(test_tight) {
    uint64_t seed = SEED + 1;
    set *s = set_new();
    int roots = 0;
    for (int i = 0; i < 100; i++) {
        s->round = i;
        random_zpoly(&seed, s->p, 1 + i % 12, 200);
        exact_zpoly_constant(s->radius, i % 2);
        s->lo = i % 3 ? -1.5 : 0.01, s->hi = 2;
        judge(s, &seed);
        exact_sturm chain = exact_sturm_of(s->p->c, s->p->n);
        int near_zero = i % 2; /* there the radius counts */
        if (!near_zero && s->count != exact_count_roots(&chain, s->lo, s->hi)) failed(s, "count", s->count);
        for (int k = 0; k < s->count; k++) {
            const algsurf_exact_range *r = s->found + k;
            const double reach = near_zero ? 4 * reach_at(s->p, r->lo) : 0;
            if ((r->lo > 0x1p-40 || r->hi < -0x1p-40) &&
                (!r->sign_lo || r->hi - reach > nextafter(nextafter(r->lo, 9), 9)))
                failed(s, "tight", k);
        }
        roots += s->count;
        if (s->count > 1) { /* ends next to the first root and the last one */
            s->lo = s->found[0].hi, s->hi = s->found[s->count - 1].lo;
            judge(s, &seed);
            if (!near_zero && s->count != exact_count_roots(&chain, s->lo, s->hi))
                failed(s, "count between", s->count);
        }
        exact_sturm_clear(&chain);
    }
    assert_often(roots > 60);
    set_free(s);
}

/* A little memory is enough where roots may be of any size. */
TEST(test_little_memory) {
    uint64_t seed = SEED + 3;
    set *s = set_new();
    random_zpoly(&seed, s->p, 12, 60);
    exact_zpoly_constant(s->radius, 1);
    s->radius->n = 12;
    for (int k = 0; k <= 12; k += 12) mpz_set_ui(s->p->c[k], 0), mpz_set_ui(s->radius->c[k], 1);
    algsurf_zpoly p = exact_to_zpoly(s->p, 0, 0), radius = exact_to_zpoly(s->radius, 0, 0);
    algsurf_memory m;
    algsurf_memory_begin(&m, stack, 400, 200000);
    assert_true(
        algsurf_exact_radii_isolate(&m, &p, &radius, 0, -DBL_MAX, DBL_MAX, s->found, MOST, &s->count, NULL));
    free(p.c), free(radius.c);
    set_free(s);
}

TEST(test_memory) {
    uint64_t seed = SEED + 2;
    set *s = set_new();
    random_zpoly(&seed, s->p, 9, 300);
    exact_zpoly_constant(s->radius, 1000);
    algsurf_zpoly p = exact_to_zpoly(s->p, 0, 0), radius = exact_to_zpoly(s->radius, 0, 0);
    int done = 0, refused = 0;
    for (size_t limit = 0; !done; limit += 64, refused += !done) {
        algsurf_memory m;
        algsurf_memory_begin(&m, stack, 10, limit);
        done = algsurf_exact_radii_isolate(&m, &p, &radius, 0, -3, 3, s->found, MOST, &s->count, NULL);
        assert_true(m.at == stack && m.allocated == 0);
    }
    assert_true(refused > 20);
    free(p.c), free(radius.c);
    set_free(s);
}
