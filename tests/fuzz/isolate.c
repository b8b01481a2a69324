/* isolate.c - fuzzes the isolation of real roots: "LO HI FLAGS COEFFICIENT COEFFICIENT ...".
 *
 * FLAGS 1: each coefficient is followed by a radius.  Without radii isolate_case.h judges, by a Sturm chain;
 * with them the claims must hold for polynomials at the ends of the radii.  Sets of polynomials that hold the
 * zero polynomial are left out: anything may be said of them.
 */
#include "isolate_case.h"
#include "fuzz.h"

enum { TOP = 24, MOST_BITS = 30000 };

static isolate_answer answer;

static void judge_members(const double *c, const double *r, int n, double lo, double hi) {
    answer.count = -1;
    answer.status =
        algsurf_isolate_all(c, r, n, lo, hi, NULL, answer.b, ALGSURF_MAX_POLY_DEGREE + 1, &answer.count);
    fuzz_check(answer.status >= 0 && answer.count >= 0);
    const char *wrong = isolate_form(c, r, n, lo, hi, &answer);
    for (int side = -1; !wrong && side <= 1; side++) {
        double member[TOP + 1];
        int zero = 1;
        for (int k = 0; k <= n; k++) {
            double end = c[k] + side * r[k];
            member[k] = side != 0 && r[k] > 0 && isfinite(end) ? nextafter(end, c[k]) : c[k];
            zero = zero && member[k] == 0;
        }
        if (zero) continue;
        exact_sturm s = exact_sturm_of_doubles(member, n);
        wrong = isolate_truth(&s, lo, hi, &answer);
        exact_sturm_clear(&s);
    }
    if (wrong) isolate_fail(wrong, c, r, n, lo, hi, &answer);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_numbers in = fuzz_numbers_of(data, size);
    double lo = fuzz_any(&in), hi = fuzz_any(&in), c[TOP + 1], r[TOP + 1];
    int radii = fuzz_whole(&in, 0, 1), n = -1, may_vanish = 1;
    while (n < TOP && (n < 0 || fuzz_left(&in) > 0)) {
        n++;
        c[n] = fuzz_finite(&in);
        r[n] = radii ? fabs(fuzz_finite(&in)) : 0;
        may_vanish = may_vanish && fabs(c[n]) <= r[n];
    }
    fuzz_loud_judges();
    if (isnan(lo) || isnan(hi) || may_vanish || fuzz_span(c, n + 1) * n > MOST_BITS) return 0;
    if (lo > hi) {
        int found = 77;
        fuzz_check(algsurf_isolate_first(c, NULL, n, lo, hi, NULL, &answer.first, &found) ==
                   ALGSURF_E_ARGUMENT);
        fuzz_check(found == 77);
        double t = lo;
        lo = hi, hi = t;
    }
    if (radii)
        judge_members(c, r, n, lo, hi);
    else
        isolate_judge(c, n, lo, hi, &answer);
    return 0;
}
