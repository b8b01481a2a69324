/* isolate.c - roots of a polynomial in an interval of the line: the public calls.
 *
 * Doubles come first, one polynomial in one lane (single_template.h): moderate degree, and roots not far
 * smaller than the interval, which is cut where no root can be beyond.  What they leave undecided goes to
 * integers (decide.c), or, where coefficients are known to radii only, to integers with envelopes
 * (exact_radii.c): those brackets that the doubles were sure of are kept, so that the first root is the same
 * whether the others are looked for or not.
 */
#include "algsurf/isolate.h"

#include <math.h>
#include <string.h>

#include "../base/fpenv.h"
#include "coefficients.h"
#include "decide.h"
#include "kernel.h"
#include "quadratic.h"

typedef struct task {
    algsurf_i_coefficients p;
    double lo, hi;
    int first_only;
    algsurf_bracket *b;
    int count, capacity;
    int counted; /* intervals whose variations were counted */
} task;

/* An exponent e so that all roots are below 2^e: |t| <= 2 max |c_k / c_n|^(1/(n-k)) (Fujiwara 1916).  |c_k| +
 * r_k is below 2^(i+2), i the exponent of the larger one; |c_n| - r_n, rounded, is at most twice too large.
 * Above 1023 when there is none. */
static int root_bound(const algsurf_i_coefficients *p) {
    int n = p->degree, bound = -1000, radii = p->r != NULL;
    double lead = fabs(p->c[n]) - (radii ? p->r[n] : 0);
    if (!(lead > 0)) return 1024;
    int least = ilogb(lead) - radii;
    for (int k = 0; k < n; k++) {
        double size = radii ? fmax(fabs(p->c[k]), p->r[k]) : fabs(p->c[k]);
        if (!(size > 0)) continue;
        int e = ilogb(size) + 1 + radii - least;
        if (e > (n - k) * bound) bound = e > 0 ? (e + n - k - 1) / (n - k) : -(-e / (n - k));
    }
    return bound + 1;
}

/* [from,to] in a lane, as far as it is asked for; returns 0 when that leaves something undecided. */
static int walk_piece(task *t, double from, double to) {
    int most = (t->first_only ? 1 : t->capacity) - t->count, found = 0;
    double lo = fmax(from, t->lo), hi = fmin(to, t->hi);
    if (lo >= hi || most == 0) return 1;
    if (!(fmax(fabs(lo), fabs(hi)) > 0x1p-900 && hi - lo < 0x1p1000)) return 0;
    algsurf_bracket two[2];
    if (t->p.degree <= 2 && !t->p.r &&
        algsurf_i_quadratic_isolate(t->p.c, t->p.degree, lo, hi, two, &found)) {
        for (int i = 0; i < found && i < most; i++) t->b[t->count++] = two[i];
        t->counted++;
        return 1;
    }
    int done = algsurf_i_roots_single_fastest()(&t->p, lo, hi, most, t->b + t->count, &found, &t->counted);
    t->count += found;
    return done;
}

enum { SPREAD = 24, MOST_PIECES = 16 }; /* binary digits that one piece may lose; on one side of 0 */

/* All of [lo,hi] in a lane: in one piece, or, where roots can be of very different sizes, in pieces of which
 * that about 0 ends at the geometric mean of the roots. */
static int walk_lane(task *t) {
    int n = t->p.degree;
    double size = fmax(fabs(t->lo), fabs(t->hi));
    if (!(t->lo < t->hi) || n == 0 || n > ALGSURF_MAX_DEGREE || t->p.c[0] == 0 || t->p.c[n] == 0) return 0;
    int bound = size < 0x1p900 ? ilogb(size) + 1 : root_bound(&t->p);
    int mean = (ilogb(t->p.c[0]) - ilogb(t->p.c[n])) / n, step = SPREAD > n ? SPREAD / n : 1;
    if (bound > 900 || mean < -900 || bound - mean > MOST_PIECES * step) return 0;
    if ((bound - mean) * n <= SPREAD) return walk_piece(t, -ldexp(1, bound), ldexp(1, bound));
    int done = 1, e = bound;
    for (; done && e > mean + step; e -= step) done = walk_piece(t, -ldexp(1, e), -ldexp(1, e - step));
    done = done && walk_piece(t, -ldexp(1, e), ldexp(1, e));
    for (; done && e < bound; e += step) done = walk_piece(t, ldexp(1, e), ldexp(1, e + step));
    return done;
}

int algsurf_i_isolate_in_lane(const double *c, int degree, double lo, double hi, algsurf_bracket *brackets,
                              int *count) {
    task t = {{c, NULL, degree}, lo, hi, 0, brackets, 0, degree, 0};
    int done = walk_lane(&t);
    *count = t.count;
    return done;
}

/* The interval from where the lane's last bracket ends. */
static double begin_of_rest(const task *t) { return t->count > 0 ? t->b[t->count - 1].hi : t->lo; }

static void add_root(task *t, const algsurf_real_root *root) {
    int exact = root->lo == root->hi;
    t->b[t->count++] = (algsurf_bracket){.lo = root->lo,
                                         .hi = root->hi,
                                         .kind = exact ? ALGSURF_ROOT_EXACT : ALGSURF_ROOT_BRACKET,
                                         .sign = exact ? 0 : root->sign,
                                         .multiplicity = root->multiplicity,
                                         .status = ALGSURF_OK};
}

static algsurf_status walk_integers(task *t) {
    algsurf_real_root roots[ALGSURF_MAX_POLY_DEGREE];
    int found = 0, most = t->first_only ? 1 : t->p.degree;
    algsurf_status status = algsurf_i_decide_roots(t->p.c, t->p.degree, begin_of_rest(t), t->hi,
                                                   t->first_only, roots, most, &found, &t->counted);
    for (int i = 0; i < found && t->count < t->capacity; i++) add_root(t, roots + i);
    return status;
}

static algsurf_status walk_envelopes(task *t) {
    int found = 0;
    algsurf_status status = algsurf_i_decide_ranges(&t->p, begin_of_rest(t), t->hi, t->b + t->count,
                                                    t->capacity - t->count, &found, &t->counted);
    t->count += found;
    if (t->first_only && t->count > 1) t->count = 1;
    return status;
}

static void all_undecided(task *t) {
    int most = t->p.degree > 0 ? t->p.degree : 1;
    t->b[0] = (algsurf_bracket){t->lo, t->hi, ALGSURF_ROOT_UNDECIDED, 0, most, ALGSURF_UNDECIDED_ZERO};
    t->count = 1;
}

/* Nothing can be said of a set of polynomials that holds the zero polynomial. */
static int may_vanish(const algsurf_i_coefficients *p) {
    for (int k = 0; p->r && k <= p->degree; k++)
        if (fabs(p->c[k]) > p->r[k]) return 0;
    return p->r != NULL;
}

static algsurf_status check(const double *c, const double *r, int degree, double lo, double hi) {
    if (!c || degree < 0 || degree > ALGSURF_MAX_POLY_DEGREE || !(lo <= hi)) return ALGSURF_E_ARGUMENT;
    int zero = 1;
    for (int k = 0; k <= degree; k++) {
        if (!isfinite(c[k]) || (r && !isfinite(r[k]))) return ALGSURF_E_NOT_FINITE;
        if (r && r[k] < 0) return ALGSURF_E_ARGUMENT;
        zero = zero && c[k] == 0 && (!r || r[k] == 0);
    }
    return zero ? ALGSURF_E_ZERO : ALGSURF_OK;
}

static int has_radii(const task *t) {
    for (int k = 0; t->p.r && k <= t->p.degree; k++)
        if (t->p.r[k] > 0) return 1;
    return 0;
}

static ALGSURF_NOINLINE algsurf_status check_and_isolate(task *t) {
    algsurf_status status = check(t->p.c, t->p.r, t->p.degree, t->lo, t->hi);
    if (status != ALGSURF_OK) return status;
    if (!has_radii(t)) t->p.r = NULL;
    while (t->p.c[t->p.degree] == 0 && (!t->p.r || t->p.r[t->p.degree] == 0)) t->p.degree--;
    if (may_vanish(&t->p)) {
        all_undecided(t);
        return ALGSURF_OK;
    }
    if (walk_lane(t)) return ALGSURF_OK;
    return t->p.r ? walk_envelopes(t) : walk_integers(t);
}

/* Runs the search into `room` for degree brackets, at least 1; the first undecided reason is the status.
 * `intervals` may be null. */
static algsurf_status run(const double *c, const double *r, int degree, double lo, double hi, int first_only,
                          algsurf_bracket *room, int *count, int *intervals) {
    task t = {{c, r, degree}, lo, hi, first_only, room, 0, degree > 0 ? degree : 1, 0};
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = check_and_isolate(&t);
    algsurf_fpenv_leave(&saved);
    if (status != ALGSURF_OK) return status;
    *count = t.count;
    if (intervals) *intervals = t.counted;
    for (int i = 0; i < t.count; i++)
        if (room[i].status != ALGSURF_OK) return room[i].status;
    return ALGSURF_OK;
}

algsurf_status algsurf_isolate_first_counted(const double *c, const double *r, int degree, double lo,
                                             double hi, algsurf_bracket *bracket, int *found,
                                             int *intervals) {
    algsurf_bracket first[ALGSURF_MAX_POLY_DEGREE];
    int count = 0;
    if (!bracket || !found || !intervals) return ALGSURF_E_ARGUMENT;
    algsurf_status status = run(c, r, degree, lo, hi, 1, first, &count, intervals);
    if (status < 0) return status;
    *found = count;
    if (count) *bracket = first[0];
    return status;
}

algsurf_status algsurf_isolate_first(const double *c, const double *r, int degree, double lo, double hi,
                                     algsurf_bracket *bracket, int *found) {
    int intervals;
    return algsurf_isolate_first_counted(c, r, degree, lo, hi, bracket, found, &intervals);
}

algsurf_status algsurf_isolate_all(const double *c, const double *r, int degree, double lo, double hi,
                                   algsurf_bracket *brackets, int capacity, int *count) {
    algsurf_bracket room[ALGSURF_MAX_POLY_DEGREE + 1];
    int n = 0;
    if (!brackets || !count || capacity < 0) return ALGSURF_E_ARGUMENT;
    algsurf_status status = run(c, r, degree, lo, hi, 0, room, &n, NULL);
    if (status < 0) return status;
    if (n > capacity) return ALGSURF_E_ARGUMENT;
    memcpy(brackets, room, (size_t)n * sizeof *room);
    *count = n;
    return status;
}

algsurf_status algsurf_count_roots(const double *c, const double *r, int degree, double lo, double hi,
                                   int *count) {
    algsurf_bracket room[ALGSURF_MAX_POLY_DEGREE + 1];
    int n = 0, roots = 0;
    if (!count) return ALGSURF_E_ARGUMENT;
    algsurf_status status = run(c, r, degree, lo, hi, 0, room, &n, NULL);
    if (status < 0) return status;
    for (int i = 0; i < n; i++) roots += room[i].kind != ALGSURF_ROOT_UNDECIDED;
    *count = roots;
    return status;
}
