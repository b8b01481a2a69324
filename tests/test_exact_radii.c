/* test_exact_radii.c - polynomials known up to radii: what is said of all of them, asked of some, by Sturm
 * chains.
 *
 * Members of the set: both envelopes, the middle, and random ones with errors at the ends of their radii and
 * between.  Where no range is, no member has a root; a decided range has one root of each, with the sign
 * before it that was given.
 *
 * Breaks caught, each tried: cells with more than one variation taken for one root, unknown signs in the
 * chains left out, roots at left ends forgotten, a reflection without signs, one envelope for both, roots
 * beyond the ends not dropped, ranges not joined at 0 or when there is no room, a bracket's end a double too
 * far in, a halving without its last shift, derivatives with roots or ends of one sign taken for a root,
 * innermost or outermost pieces left out, an annulus judged by its wrong end or by some of its terms. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include "exact_roots.h"
#include "exact_zpolys.h"

#include "roots/exact_radii.h"

#include <cmocka.h>

#define SEED 20250313u
enum { MOST = 80 };

static uint64_t stack[400];
static long decided, undecided, exact_points, about_zero, beyond;

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
            int e = kind < 3 ? kind - 1 : kind == 3 ? (k % 2 ? 1 : -1) : exact_random_int(seed, 3) - 1;
            e = kind < 6 ? 8 * e : exact_random_int(seed, 17) - 8;
            mpz_mul_si(s->member->c[k], s->p->c[k], 8);
            if (e > 0 && k <= s->radius->n) mpz_addmul_ui(s->member->c[k], s->radius->c[k], (unsigned)e);
            if (e < 0 && k <= s->radius->n) mpz_submul_ui(s->member->c[k], s->radius->c[k], (unsigned)-e);
        }
        exact_zpoly_trim(s->member);
        judge_member(s);
    }
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
    double a = ldexp(exact_random_unit(seed), exact_random_int(seed, 8) - 2),
           b = ldexp(exact_random_unit(seed), exact_random_int(seed, 8) - 2);
    if (exact_random_int(seed, 5) == 0) a = 0;
    if (exact_random_int(seed, 5) == 0) a = floor(a);
    if (exact_random_int(seed, 10) == 0) b = a;
    s->lo = fmin(a, b), s->hi = fmax(a, b);
    if (exact_random_int(seed, 5) == 0) s->lo = exact_random_int(seed, 3) ? -HUGE_VAL : -DBL_MAX;
    if (exact_random_int(seed, 5) == 0) s->hi = exact_random_int(seed, 3) ? HUGE_VAL : DBL_MAX;
}

/* Roots of sizes far apart, down to the least doubles and up to beyond the largest. */
static void spread_sizes(uint64_t *seed, set *s) {
    int most = exact_random_int(seed, 3) ? 100 : 3000;
    for (int k = 0; k <= s->p->n; k++) {
        unsigned up = (unsigned)exact_random_int(seed, most);
        mpz_mul_2exp(s->p->c[k], s->p->c[k], up);
        if (k <= s->radius->n) mpz_mul_2exp(s->radius->c[k], s->radius->c[k], up);
    }
}

/* p = product of (q t - a) with few bits, or random; radii of 0, of a few bits, or of as many as p has. */
static void make_set(uint64_t *seed, set *s) {
    int n = 1 + exact_random_int(seed, 8), bits = 60, simple = exact_random_int(seed, 3);
    exact_zpoly_constant(s->p, 1);
    if (simple) {
        for (int i = 0; i < n; i++) {
            s->member->n = 1;
            mpz_set_si(s->member->c[0], exact_random_int(seed, 41) - 20);
            mpz_set_si(s->member->c[1], 1 + exact_random_int(seed, simple == 1 ? 1 : 9));
            exact_zpoly_multiply(s->p, s->p, s->member);
        }
        for (int k = 0; k <= n; k++) mpz_mul_2exp(s->p->c[k], s->p->c[k], 40);
    } else {
        exact_random_zpoly(seed, s->p, n, bits);
    }
    s->radius->n = n - (exact_random_int(seed, 4) == 0);
    int size = 1 + exact_random_int(seed, 60), none = exact_random_int(seed, 5) == 0;
    for (int k = 0; k <= s->radius->n; k++) {
        exact_random_mpz(seed, s->radius->c[k], size);
        mpz_abs(s->radius->c[k], s->radius->c[k]);
        if (none || exact_random_int(seed, 4) == 0) mpz_set_ui(s->radius->c[k], 0);
    }
    if (exact_random_int(seed, 3) == 0) mpz_fdiv_q_2exp(s->p->c[0], s->radius->c[0], 1);
    if (exact_random_int(seed, 4) == 0) mpz_set(s->p->c[s->radius->n], s->radius->c[s->radius->n]);
    if (exact_random_int(seed, 4) == 0) spread_sizes(seed, s);
    exact_zpoly_trim(s->p);
}

static void test_sets(void **state) {
    (void)state;
    uint64_t seed = SEED;
    set *s = set_new();
    for (int i = 0; i < 3000; i++) {
        s->round = i;
        make_set(&seed, s);
        random_interval(&seed, s);
        s->capacity = i % 7 ? MOST : 1 + i % 3;
        judge(s, &seed);
    }
    assert_true(decided > 600 && undecided > 250 && exact_points > 20 && about_zero > 30 && beyond > 2);
    set_free(s);
}

/* Without radii, and with tiny ones, all simple roots are decided, and tight. */
static void test_tight(void **state) {
    (void)state;
    uint64_t seed = SEED + 1;
    set *s = set_new();
    int roots = 0;
    for (int i = 0; i < 200; i++) {
        s->round = i;
        exact_random_zpoly(&seed, s->p, 1 + i % 12, 200);
        exact_zpoly_constant(s->radius, i % 2);
        s->lo = i % 3 ? -1.5 : 0.01, s->hi = 2;
        judge(s, &seed);
        exact_sturm chain = exact_sturm_of(s->p->c, s->p->n);
        int near_zero = i % 2; /* there the radius counts */
        if (!near_zero && s->count != exact_count_roots(&chain, s->lo, s->hi)) failed(s, "count", s->count);
        for (int k = 0; k < s->count; k++)
            if ((s->found[k].lo > 0x1p-40 || s->found[k].hi < -0x1p-40) &&
                (!s->found[k].sign_lo || s->found[k].hi > nextafter(nextafter(s->found[k].lo, 9), 9)))
                failed(s, "tight", k);
        roots += s->count;
        if (s->count > 1) { /* ends next to the first root and the last one */
            s->lo = s->found[0].hi, s->hi = s->found[s->count - 1].lo;
            judge(s, &seed);
            if (!near_zero && s->count != exact_count_roots(&chain, s->lo, s->hi))
                failed(s, "count between", s->count);
        }
        exact_sturm_clear(&chain);
    }
    assert_true(roots > 120);
    set_free(s);
}

/* A little memory is enough where roots may be of any size. */
static void test_little_memory(void **state) {
    (void)state;
    uint64_t seed = SEED + 3;
    set *s = set_new();
    exact_random_zpoly(&seed, s->p, 12, 60);
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

static void test_memory(void **state) {
    (void)state;
    uint64_t seed = SEED + 2;
    set *s = set_new();
    exact_random_zpoly(&seed, s->p, 9, 300);
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_sets), cmocka_unit_test(test_tight),
                                       cmocka_unit_test(test_memory), cmocka_unit_test(test_little_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
