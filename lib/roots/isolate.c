/* isolate.c - roots of a polynomial in an interval of the line, isolated: the public calls.
 *
 * Exact coefficients: line.c.  Where they are known to radii, doubles come first (walk.c), then integers with
 * envelopes (exact_radii.c) from the last bracket on that the doubles were sure of: so the first root is the
 * same whether the others are looked for or not. */
#include "../base/arithmetic.h"
#include "algsurf/isolate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../base/options.h"
#include "coefficients.h"
#include "decide.h"
#include "line.h"
#include "walk.h"

/* What is found: roots of an exact polynomial, or brackets of a set.  On the stack, or, beyond the degrees
 * that doubles decide, allocated. */
typedef union place {
    algsurf_real_root root;
    algsurf_bracket bracket;
} place;

typedef struct task {
    algsurf_i_coefficients p;
    double lo, hi;
    int wanted;
    const algsurf_i_watch *watch; /* null: nobody looks */
    place few[ALGSURF_MAX_DEGREE + 1];
    void *room;
    algsurf_bracket *b;       /* of a set, else null */
    algsurf_real_root *roots; /* of an exact polynomial, else null */
    int count, capacity;
    algsurf_bracket *to; /* the caller's brackets, null: none are asked for; room for so many */
    int most;
} task;

/* Of the set of polynomials within the radii. */
static algsurf_status solve_set(task *t) {
    int first = t->wanted == ALGSURF_I_FIRST, found = 0;
    int level = algsurf_i_is_level(&t->p, fmax(fabs(t->lo), fabs(t->hi)));
    if (algsurf_i_walk(&t->p, t->lo, t->hi, level, first ? 1 : t->capacity, t->b, &t->count, t->watch))
        return ALGSURF_OK;
    double rest = t->count > 0 ? t->b[t->count - 1].hi : t->lo;
    algsurf_status status = algsurf_i_decide_ranges(&t->p, rest, t->hi, t->b + t->count,
                                                    t->capacity - t->count, &found, t->watch);
    t->count += found;
    if (first && t->count > 1) t->count = 1;
    return status;
}

static algsurf_status solve_exact(task *t) {
    const algsurf_i_line line = {{t->p.c, NULL, t->p.degree}, t->lo, t->hi, t->wanted, 0, t->watch, 0};
    return algsurf_i_line_solve(&line, t->roots = t->room, &t->count);
}

static algsurf_bracket bracket_at(const task *t, int i) {
    if (t->b) return t->b[i];
    const algsurf_real_root *r = t->roots + i;
    int exact = r->lo == r->hi, kind = exact ? ALGSURF_BRACKET_EXACT : ALGSURF_BRACKET_ISOLATED;
    return (algsurf_bracket){r->lo, r->hi, kind, exact ? 0 : r->sign, r->multiplicity, ALGSURF_OK};
}

static void all_undecided(task *t) {
    int most = t->p.degree > 0 ? t->p.degree : 1;
    t->b[0] = (algsurf_bracket){t->lo, t->hi, ALGSURF_BRACKET_UNDECIDED, 0, most, ALGSURF_UNDECIDED_ZERO};
    t->count = 1;
}

/* Nothing can be said of a set of polynomials that holds the zero polynomial. */
static int may_vanish(const algsurf_i_coefficients *p) {
    for (int k = 0; k <= p->degree; k++)
        if (fabs(p->c[k]) > p->r[k]) return 0;
    return 1;
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
    int radii = has_radii(t), whole = t->lo == -HUGE_VAL && t->hi == HUGE_VAL;
    if (t->wanted == ALGSURF_I_NUMBER && (radii || !whole)) t->wanted = ALGSURF_I_ALL;
    if (!radii) return solve_exact(t);
    t->b = t->room;
    while (t->p.c[t->p.degree] == 0 && t->p.r[t->p.degree] == 0) t->p.degree--;
    if (!may_vanish(&t->p)) return solve_set(t);
    all_undecided(t);
    return ALGSURF_OK;
}

/* The first undecided reason is the status. */
static algsurf_status run(task *t) {
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = check_and_isolate(t);
    if (status >= 0 && t->to && t->count > t->most) status = ALGSURF_E_ARGUMENT;
    for (int i = 0; status >= 0 && t->to && i < t->count; i++) t->to[i] = bracket_at(t, i);
    algsurf_fpenv_leave(&saved);
    for (int i = 0; status == ALGSURF_OK && t->b && i < t->count; i++) status = t->b[i].status;
    return status;
}

static int begin(task *t, const double *c, const double *r, int degree, double lo, double hi, int wanted,
                 const algsurf_i_watch *watch, algsurf_bracket *to, int most) {
    int many = degree > ALGSURF_MAX_DEGREE && degree <= ALGSURF_MAX_POLY_DEGREE;
    t->p = (algsurf_i_coefficients){c, r, degree};
    t->lo = lo, t->hi = hi, t->wanted = wanted;
    t->watch = watch && watch->observer ? watch : NULL;
    t->to = to, t->most = most;
    t->b = NULL, t->roots = NULL, t->count = 0, t->capacity = degree > 0 ? degree : 1;
    t->room = many ? malloc((size_t)degree * sizeof *t->few) : t->few;
    return t->room != NULL;
}

static void end(task *t) {
    if (t->room != t->few) free(t->room);
}

static int read_options(const algsurf_isolate_options *given, algsurf_observer **observer) {
    algsurf_isolate_options known;
    *observer = NULL;
    if (!given) return 1;
    if (!algsurf_options_read(&known, sizeof known, given)) return 0;
    *observer = known.observer;
    return algsurf_i_observer_is_good(known.observer);
}

algsurf_status algsurf_isolate_first(const double *c, const double *r, int degree, double lo, double hi,
                                     const algsurf_isolate_options *options, algsurf_bracket *bracket,
                                     int *found) {
    task t;
    algsurf_i_watch watch = {.observer = NULL};
    if (!bracket || !found || !read_options(options, &watch.observer)) return ALGSURF_E_ARGUMENT;
    if (!begin(&t, c, r, degree, lo, hi, ALGSURF_I_FIRST, &watch, bracket, 1)) return ALGSURF_E_NO_MEMORY;
    algsurf_status status = run(&t);
    if (status >= 0) *found = t.count;
    end(&t);
    return status;
}

algsurf_status algsurf_isolate_all(const double *c, const double *r, int degree, double lo, double hi,
                                   const algsurf_isolate_options *options, algsurf_bracket *brackets,
                                   int capacity, int *count) {
    task t;
    algsurf_i_watch watch = {.observer = NULL};
    if (!brackets || !count || capacity < 0 || !read_options(options, &watch.observer))
        return ALGSURF_E_ARGUMENT;
    if (!begin(&t, c, r, degree, lo, hi, ALGSURF_I_ALL, &watch, brackets, capacity))
        return ALGSURF_E_NO_MEMORY;
    algsurf_status status = run(&t);
    if (status >= 0) *count = t.count;
    end(&t);
    return status;
}

/* The roots that are certain. */
algsurf_status algsurf_count_roots(const double *c, const double *r, int degree, double lo, double hi,
                                   int *count) {
    task t;
    int undecided = 0;
    if (!count) return ALGSURF_E_ARGUMENT;
    if (!begin(&t, c, r, degree, lo, hi, ALGSURF_I_NUMBER, NULL, NULL, 0)) return ALGSURF_E_NO_MEMORY;
    algsurf_status status = run(&t);
    for (int i = 0; status >= 0 && t.b && i < t.count; i++)
        undecided += t.b[i].kind == ALGSURF_BRACKET_UNDECIDED;
    if (status >= 0) *count = t.count - undecided;
    end(&t);
    return status;
}
