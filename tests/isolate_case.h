/* isolate_case.h - judges what isolate says about one polynomial and one interval. */
#ifndef ISOLATE_CASE_H
#define ISOLATE_CASE_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "exact_roots.h"

#include <cmocka.h>

#include "algsurf/isolate.h"

typedef struct isolate_answer {
    algsurf_status status;
    int count;
    algsurf_bracket
        first; /* what isolate_first says, which need not be b[0] but must be about the same root */
    algsurf_bracket b[ALGSURF_MAX_POLY_DEGREE + 1];
} isolate_answer;

static inline int isolate_decided(const algsurf_bracket *b) { return b->kind != ALGSURF_ROOT_UNDECIDED; }

static inline _Noreturn void isolate_fail(const char *what, const double *c, const double *r, int n,
                                          double lo, double hi, const isolate_answer *a) {
    exact_print_doubles("c", c, n + 1);
    if (r) exact_print_doubles("r", r, n + 1);
    for (int i = 0; i < a->count; i++)
        fprintf(stderr, "  kind %d sign %d most %d status %d [%a, %a]\n", a->b[i].kind, a->b[i].sign,
                a->b[i].multiplicity, (int)a->b[i].status, a->b[i].lo, a->b[i].hi);
    fail_msg("%s: degree %d on [%a, %a], status %d", what, n, lo, hi, (int)a->status);
    abort();
}

/* What the three calls say must agree with each other, be in order and in the interval.  (A later root that
 * needs double-double may give the first one another bracket.) */
static inline const char *isolate_form(const double *c, const double *r, int n, double lo, double hi,
                                       isolate_answer *a) {
    int found = -1, roots = -1, decided = 0;
    algsurf_status reason = ALGSURF_OK;
    for (int i = 0; i < a->count; i++) {
        const algsurf_bracket *b = a->b + i;
        double before = i > 0 ? b[-1].hi : lo;
        if (!(b->lo >= before && b->hi <= hi && b->lo <= b->hi)) return "out of order, or of the interval";
        if (isolate_decided(b) != (b->status == ALGSURF_OK) || b->status < 0) return "status of an entry";
        if (b->kind == ALGSURF_ROOT_BRACKET && !(b->lo < b->hi && b->sign * b->sign == 1))
            return "no bracket";
        if (b->kind == ALGSURF_ROOT_EXACT && !(b->lo == b->hi)) return "not one point";
        if (b->kind != ALGSURF_ROOT_BRACKET && b->sign != 0) return "a sign where there is none";
        if (b->multiplicity < 1) return "an entry without roots";
        if (reason == ALGSURF_OK) reason = b->status;
        decided += isolate_decided(b);
    }
    if (a->status != reason) return "status is not the first reason";
    algsurf_status status = algsurf_isolate_first(c, r, n, lo, hi, &a->first, &found);
    if (found != (a->count > 0)) return "first and all disagree";
    if (found && status != a->first.status) return "status of the first";
    if (found && (a->first.kind != a->b[0].kind || a->first.sign != a->b[0].sign))
        return "first is not the first of all";
    if (found && !(a->first.lo <= a->b[0].hi && a->b[0].lo <= a->first.hi)) return "first is elsewhere";
    if (algsurf_count_roots(c, r, n, lo, hi, &roots) != a->status || roots != decided) return "count differs";
    return NULL;
}

/* Are the claims true of the polynomial s, and all its roots in [lo,hi] in the entries? */
static inline const char *isolate_truth(const exact_sturm *s, double lo, double hi, const isolate_answer *a) {
    int roots = 0;
    for (int i = 0; i < a->count; i++) {
        const algsurf_bracket *b = a->b + i;
        int inside = exact_count_roots(s, b->lo, b->hi);
        if (b->kind == ALGSURF_ROOT_BRACKET && inside != 1) return "not one root in a bracket";
        if (b->kind == ALGSURF_ROOT_EXACT && inside != 1) return "no root at an exact one";
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

/* The signs a bracket tells, for the polynomial with exactly these coefficients. */
static inline const char *isolate_signs(const double *c, int n, const isolate_answer *a) {
    for (int i = 0; i < a->count; i++) {
        const algsurf_bracket *b = a->b + i;
        if (b->kind != ALGSURF_ROOT_BRACKET) continue;
        if (isolate_sign(c, n, b->lo) != b->sign || isolate_sign(c, n, b->hi) != -b->sign)
            return "signs at the ends of a bracket";
    }
    return NULL;
}

/* All of this for exact coefficients, not all zero; the answer is handed out for more questions. */
static inline void isolate_judge(const double *c, int n, double lo, double hi, isolate_answer *a) {
    memset(a, 0, sizeof *a);
    a->count = -1;
    a->status = algsurf_isolate_all(c, NULL, n, lo, hi, a->b, ALGSURF_MAX_POLY_DEGREE + 1, &a->count);
    if (a->status < 0 || a->count < 0) isolate_fail("refused", c, NULL, n, lo, hi, a);
    exact_sturm s = exact_sturm_of_doubles(c, n);
    const char *wrong = isolate_form(c, NULL, n, lo, hi, a);
    if (!wrong) wrong = isolate_truth(&s, lo, hi, a);
    if (!wrong) wrong = isolate_signs(c, n, a);
    exact_sturm_clear(&s);
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
