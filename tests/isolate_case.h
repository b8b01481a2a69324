/* isolate_case.h - judges what isolate says about one polynomial and one interval.
 *
 * Without radii each root must be decided: the k-th entry is the k-th root by Sturm's chain, with its
 * multiplicity and the sign before it.  The chains of p and of the greatest common divisors of p and p', of
 * that and its derivative, and so on, tell multiplicities: a root of multiplicity m is a root of m of them.
 */
#ifndef ISOLATE_CASE_H
#define ISOLATE_CASE_H
#include "exact_roots.h"

#include "algsurf/isolate.h"
#include "unit.h"

typedef struct isolate_answer {
    algsurf_status status;
    int count;
    algsurf_bracket first; /* what isolate_first says: about the same root as b[0], maybe another bracket */
    algsurf_bracket b[ALGSURF_MAX_POLY_DEGREE + 1];
} isolate_answer;

static inline int isolate_decided(const algsurf_bracket *b) { return b->kind != ALGSURF_BRACKET_UNDECIDED; }

static inline _Noreturn void isolate_fail(const char *what, const double *c, const double *r, int n,
                                          double lo, double hi, const isolate_answer *a) {
    if (c) exact_print_doubles("c", c, n + 1);
    if (r) exact_print_doubles("r", r, n + 1);
    for (int i = 0; i < a->count; i++)
        fprintf(stderr, "  kind %d sign %d multiplicity %d status %d [%a, %a]\n", a->b[i].kind, a->b[i].sign,
                a->b[i].multiplicity, (int)a->b[i].status, a->b[i].lo, a->b[i].hi);
    fail_msg("%s: degree %d on [%a, %a], status %d", what, n, lo, hi, (int)a->status);
    abort();
}

static inline int isolate_same_place(const algsurf_bracket *a, const algsurf_bracket *b) {
    return a->kind == ALGSURF_BRACKET_ISOLATED && b->kind == ALGSURF_BRACKET_ISOLATED && a->lo == b->lo &&
           a->hi == b->hi;
}

/* What the three calls say must agree with each other, be in order and in the interval. */
static inline const char *isolate_form(const double *c, const double *r, int n, double lo, double hi,
                                       isolate_answer *a) {
    int found = -1, roots = -1, decided = 0;
    algsurf_status reason = ALGSURF_OK;
    for (int i = 0; i < a->count; i++) {
        const algsurf_bracket *b = a->b + i;
        int shares = !r && i > 0 && isolate_same_place(b - 1, b);
        if (!(b->lo >= lo && b->hi <= hi && b->lo <= b->hi)) return "out of the interval";
        if (i > 0 && !shares && !(b->lo >= b[-1].hi)) return "out of order";
        if (i > 0 && b[-1].lo == b->hi) return "one point twice";
        if (isolate_decided(b) != (b->status == ALGSURF_OK) || b->status < 0) return "status of an entry";
        if (b->kind == ALGSURF_BRACKET_ISOLATED && !(b->lo < b->hi && b->sign * b->sign == 1))
            return "no bracket";
        if (b->kind == ALGSURF_BRACKET_EXACT && !(b->lo == b->hi)) return "not one point";
        if (b->kind != ALGSURF_BRACKET_ISOLATED && b->sign != 0) return "a sign where there is none";
        if (b->multiplicity < 1) return "an entry without roots";
        if (reason == ALGSURF_OK) reason = b->status;
        decided += isolate_decided(b);
    }
    if (a->status != reason) return "status is not the first reason";
    algsurf_status status = algsurf_isolate_first(c, r, n, lo, hi, NULL, &a->first, &found);
    if (found != (a->count > 0)) return "first and all disagree";
    if (found && status != a->first.status) return "status of the first";
    if (found && memcmp(&a->first, a->b, sizeof a->first) != 0) return "first is not the first of all";
    if (algsurf_count_roots(c, r, n, lo, hi, &roots) != a->status || roots != decided) return "count differs";
    return NULL;
}

/* With radii: are the claims true of s, one of the polynomials, and all its roots in [lo,hi] in the entries?
 */
static inline const char *isolate_truth(const exact_sturm *s, double lo, double hi, const isolate_answer *a) {
    int roots = 0;
    for (int i = 0; i < a->count; i++) {
        const algsurf_bracket *b = a->b + i;
        int inside = exact_count_roots(s, b->lo, b->hi);
        if (b->kind == ALGSURF_BRACKET_ISOLATED && inside != 1) return "not one root in a bracket";
        if (b->kind == ALGSURF_BRACKET_EXACT && inside != 1) return "no root at an exact one";
        if (inside > b->multiplicity) return "more roots than at most";
        int shared = i > 0 && b[-1].hi == b->lo && isfinite(b->lo) && exact_is_root(s, b->lo);
        roots += inside - shared;
    }
    if (roots != exact_count_roots(s, lo, hi)) return "a root outside the entries";
    if (a->count == 0) return NULL;
    const algsurf_bracket *first = &a->first;
    int inside = exact_count_roots(s, first->lo, first->hi), until = exact_count_roots(s, lo, first->hi);
    if (inside != until) return "a root before the first";
    return isolate_decided(first) && inside != 1 ? "not one root in the first" : NULL;
}

/* The sign of p at x, which may be infinite. */
static inline int isolate_sign(const double *c, int n, double x) {
    if (isfinite(x)) return exact_poly_sign(c, n, x);
    while (n > 0 && c[n] == 0) n--;
    return (c[n] > 0) == (x > 0 || n % 2 == 0) ? 1 : -1;
}

/* The signs a bracket tells, for the middle of a set. */
static inline const char *isolate_signs(const double *c, int n, const isolate_answer *a) {
    for (int i = 0; i < a->count; i++) {
        const algsurf_bracket *b = a->b + i;
        if (b->kind != ALGSURF_BRACKET_ISOLATED) continue;
        if (isolate_sign(c, n, b->lo) != b->sign || isolate_sign(c, n, b->hi) != -b->sign)
            return "signs at the ends of a bracket";
    }
    return NULL;
}

/* ---- without radii ---- */

/* Chains of p (number 0) and of the common divisors, until they are constant. */
typedef struct isolate_chains {
    mpz_t *p; /* without leading zeros */
    int degree, count;
    exact_sturm s[ALGSURF_MAX_POLY_DEGREE + 1];
} isolate_chains;

/* p, of degree n > 0, becomes the greatest common divisor of p and p'; returns its degree. */
static inline int isolate_divisor(mpz_t *p, int n) {
    mpz_t *q = exact_polynomials(1, n);
    for (int k = 1; k <= n; k++) mpz_mul_ui(q[k - 1], p[k], (unsigned long)k);
    int m = exact_gcd(p, p, n, q, n - 1);
    for (int k = m + 1; k <= n; k++) mpz_set_ui(p[k], 0);
    exact_free(q, n);
    return m;
}

/* Of p, not zero. */
static inline void isolate_chains_of(mpz_t *p, int n, isolate_chains *chains) {
    mpz_t *q = exact_polynomials(1, n + 1);
    chains->degree = exact_degree(p, n);
    chains->p = exact_polynomials(1, chains->degree + 1);
    for (int k = 0; k <= chains->degree; k++) mpz_set(chains->p[k], p[k]), mpz_set(q[k], p[k]);
    chains->s[0] = exact_sturm_of(q, chains->degree);
    chains->count = 1;
    for (int degree = chains->degree; degree > 0 && (degree = isolate_divisor(q, degree)) > 0;)
        chains->s[chains->count++] = exact_sturm_of(q, degree);
    exact_free(q, n + 1);
}

static inline void isolate_chains_clear(isolate_chains *chains) {
    for (int i = 0; i < chains->count; i++) exact_sturm_clear(chains->s + i);
    exact_free(chains->p, chains->degree + 1);
}

/* Roots in the open interval (lo,hi). */
static inline int isolate_between(const exact_sturm *s, double lo, double hi) {
    int at_lo = isfinite(lo) && exact_is_root(s, lo), at_hi = isfinite(hi) && exact_is_root(s, hi);
    return exact_count_roots(s, lo, hi) - at_lo - at_hi;
}

/* The sign of p just after x: that of the first derivative which does not vanish there. */
static inline int isolate_sign_after(const isolate_chains *chains, double x) {
    int n = chains->degree, sign = 0;
    if (!isfinite(x)) return exact_integers_sign(chains->p, n, x);
    mpz_t *p = exact_polynomials(1, n + 1);
    for (int k = 0; k <= n; k++) mpz_set(p[k], chains->p[k]);
    for (int d = n; d >= 0 && (sign = exact_integers_sign(p, d, x)) == 0; d--)
        for (int k = 1; k <= d; k++) mpz_mul_ui(p[k - 1], p[k], (unsigned long)k);
    exact_free(p, n + 1);
    return sign;
}

/* One root at a double. */
static inline const char *isolate_exact_entry(const isolate_chains *chains, const algsurf_bracket *b) {
    int multiplicity = 0;
    if (!isfinite(b->lo)) return "an exact root at infinity";
    for (int i = 0; i < chains->count; i++) multiplicity += exact_is_root(chains->s + i, b->lo);
    if (multiplicity == 0) return "no root at an exact one";
    return multiplicity != b->multiplicity ? "multiplicity of an exact root" : NULL;
}

/* `count` entries with the same ends: as many roots between these. */
static inline const char *isolate_brackets(const isolate_chains *chains, const algsurf_bracket *b,
                                           int count) {
    int all = 0, sum = 0, sign = isolate_sign_after(chains, b->lo);
    int neighbours = nextafter(b->lo, INFINITY) == b->hi;
    for (int i = 0; i < chains->count; i++) all += isolate_between(chains->s + i, b->lo, b->hi);
    for (int i = 0; i < count; i++) {
        if (b[i].sign != sign) return "sign before a root";
        if (b[i].multiplicity % 2) sign = -sign;
        sum += b[i].multiplicity;
    }
    if (isolate_between(chains->s, b->lo, b->hi) != count) return "not as many roots as brackets";
    if (sum != all) return "multiplicity";
    if (neighbours) return NULL;
    if (count != 1 || b->multiplicity != 1) return "a wide bracket of a root that is multiple, or not alone";
    if (exact_integers_sign(chains->p, chains->degree, b->lo) != b->sign ||
        exact_integers_sign(chains->p, chains->degree, b->hi) != -b->sign)
        return "signs at the ends of a wide bracket";
    return NULL;
}

/* Each root of p in [lo,hi] has its entry. */
static inline const char *isolate_decisions(const isolate_chains *chains, double lo, double hi,
                                            const isolate_answer *a) {
    const char *wrong = NULL;
    for (int i = 0, next; !wrong && i < a->count; i = next) {
        for (next = i + 1; next < a->count && isolate_same_place(a->b + i, a->b + next);) next++;
        switch (a->b[i].kind) {
        case ALGSURF_BRACKET_EXACT:
            wrong = isolate_exact_entry(chains, a->b + i);
            break;
        case ALGSURF_BRACKET_ISOLATED:
            wrong = isolate_brackets(chains, a->b + i, next - i);
            break;
        default:
            wrong = "undecided";
        }
    }
    if (!wrong && exact_count_roots(chains->s, lo, hi) != a->count) wrong = "another number of roots";
    return wrong;
}

/* Real roots, refined, as the entries they are. */
static inline const char *isolate_entries(const algsurf_real_root *roots, int count, isolate_answer *a) {
    a->count = count;
    for (int i = 0; i < count; i++) {
        const algsurf_real_root *t = roots + i;
        int exact = t->lo == t->hi;
        if (!isfinite(t->root) || (t->root != t->lo && t->root != t->hi)) return "value of a root";
        if (!exact && nextafter(t->lo, INFINITY) != t->hi) return "not neighbours";
        if (t->sign * t->sign != 1) return "no sign";
        if (i > 0 && !(t->lo >= t[-1].hi || (t->lo == t[-1].lo && t->hi == t[-1].hi))) return "out of order";
        a->b[i] = (algsurf_bracket){.lo = t->lo,
                                    .hi = t->hi,
                                    .kind = exact ? ALGSURF_BRACKET_EXACT : ALGSURF_BRACKET_ISOLATED,
                                    .sign = t->sign,
                                    .multiplicity = t->multiplicity};
    }
    return NULL;
}

/* The same roots, whichever of their two doubles is the value. */
static inline int isolate_same_roots(const algsurf_real_root *a, const algsurf_real_root *b, int count) {
    int same = 1;
    for (int i = 0; i < count; i++)
        same &= a[i].lo == b[i].lo && a[i].hi == b[i].hi && a[i].multiplicity == b[i].multiplicity &&
                a[i].sign == b[i].sign && (b[i].root == b[i].lo || b[i].root == b[i].hi);
    return same;
}

/* What algsurf_real_roots_integers says, with a leading zero where there is room, and that algsurf_real_roots
 * says the same (c: null, or p times a power of two). */
static inline const char *isolate_real_roots(const isolate_chains *chains, const double *c, double lo,
                                             double hi, isolate_answer *a) {
    static algsurf_integer z[ALGSURF_MAX_POLY_DEGREE + 1];
    static algsurf_real_root roots[ALGSURF_MAX_POLY_DEGREE], same[ALGSURF_MAX_POLY_DEGREE];
    int n = chains->degree, top = n < ALGSURF_MAX_POLY_DEGREE ? n + 1 : n, count = -1, again = -1;
    z[top] = (algsurf_integer){NULL, 0};
    for (int k = 0; k <= n; k++)
        z[k] = (algsurf_integer){mpz_limbs_read(chains->p[k]),
                                 mpz_sgn(chains->p[k]) * (int)mpz_size(chains->p[k])};
    a->status = algsurf_real_roots_integers(z, top, lo, hi, roots, n, &count);
    if (a->status != ALGSURF_OK) return "integers refused";
    if (c && (algsurf_real_roots(c, n, lo, hi, same, n, &again) != ALGSURF_OK || again != count ||
              !isolate_same_roots(roots, same, count)))
        return "other roots from doubles than from integers";
    const char *wrong = isolate_entries(roots, count, a);
    if (!wrong) wrong = isolate_decisions(chains, lo, hi, a);
    for (int i = 0; !wrong && i < count; i++) {
        int before = isolate_sign_after(chains, roots[i].lo) * (roots[i].multiplicity % 2 ? -1 : 1);
        if (roots[i].lo == roots[i].hi && roots[i].sign != before) wrong = "sign before an exact root";
    }
    return wrong;
}

/* What algsurf_real_roots_integers says of p, not zero. */
static inline void isolate_judge_integers(mpz_t *p, int n, double lo, double hi, isolate_answer *a) {
    static isolate_chains chains;
    memset(a, 0, sizeof *a);
    isolate_chains_of(p, n, &chains);
    const char *wrong = isolate_real_roots(&chains, NULL, lo, hi, a);
    isolate_chains_clear(&chains);
    if (!wrong) return;
    for (int k = 0; k <= n; k++) gmp_fprintf(stderr, "p[%d] = %Zd\n", k, p[k]);
    isolate_fail(wrong, NULL, NULL, n, lo, hi, a);
}

/* All of this for exact coefficients, not all zero; the answer is handed out for more questions. */
static inline void isolate_judge(const double *c, int n, double lo, double hi, isolate_answer *a) {
    static isolate_chains chains;
    memset(a, 0, sizeof *a);
    a->count = -1;
    a->status = algsurf_isolate_all(c, NULL, n, lo, hi, NULL, a->b, ALGSURF_MAX_POLY_DEGREE + 1, &a->count);
    if (a->status != ALGSURF_OK || a->count < 0) isolate_fail("refused", c, NULL, n, lo, hi, a);
    const char *wrong = isolate_form(c, NULL, n, lo, hi, a);
    mpz_t *p = exact_polynomials(1, n + 1);
    (void)exact_integers(p, c, n);
    isolate_chains_of(p, n, &chains);
    if (!wrong) wrong = isolate_decisions(&chains, lo, hi, a);
    static isolate_answer refined;
    if (!wrong) wrong = isolate_real_roots(&chains, c, lo, hi, &refined);
    isolate_chains_clear(&chains);
    exact_free(p, n + 1);
    if (wrong) isolate_fail(wrong, c, NULL, n, lo, hi, a);
}

/* Multiplies c, of degree n, by (b x - a); returns n + 1.  Fails unless every step is exact. */
static inline int isolate_times_root(double *c, int n, double a, double b) {
    for (int k = n + 1; k >= 0; k--) {
        double up = k > 0 ? b * c[k - 1] : 0, here = k <= n ? a * c[k] : 0;
        assert_true(fabs(up) < 0x1p52 && fabs(here) < 0x1p52 && up == floor(up) && here == floor(here));
        c[k] = up - here;
    }
    return n + 1;
}

#endif
