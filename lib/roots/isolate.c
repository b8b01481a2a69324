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

/* Room for a polynomial's roots: on the stack, or, beyond the degrees that doubles decide, allocated. */
typedef struct room {
    algsurf_bracket few[ALGSURF_MAX_DEGREE + 1], *b;
    algsurf_real_root few_roots[ALGSURF_MAX_DEGREE + 1], *roots;
} room;

typedef struct task {
    algsurf_i_coefficients p;
    double lo, hi;
    int wanted;
    const algsurf_i_watch *watch; /* null: nobody looks */
    algsurf_bracket *b;
    int count, capacity;
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

static algsurf_status solve_exact(task *t, algsurf_real_root *roots) {
    const algsurf_i_line line = {{t->p.c, NULL, t->p.degree}, t->lo, t->hi, t->wanted, 0, t->watch, 0};
    algsurf_status status = algsurf_i_line_solve(&line, roots, &t->count);
    for (int i = 0; i < t->count && t->wanted != ALGSURF_I_NUMBER; i++) {
        const algsurf_real_root *r = roots + i;
        int exact = r->lo == r->hi;
        t->b[i] = (algsurf_bracket){r->lo,
                                    r->hi,
                                    exact ? ALGSURF_BRACKET_EXACT : ALGSURF_BRACKET_ISOLATED,
                                    exact ? 0 : r->sign,
                                    r->multiplicity,
                                    ALGSURF_OK};
    }
    return status;
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

static ALGSURF_NOINLINE algsurf_status check_and_isolate(task *t, algsurf_real_root *roots) {
    algsurf_status status = check(t->p.c, t->p.r, t->p.degree, t->lo, t->hi);
    if (status != ALGSURF_OK) return status;
    int radii = has_radii(t), whole = t->lo == -HUGE_VAL && t->hi == HUGE_VAL;
    if (t->wanted == ALGSURF_I_NUMBER && (radii || !whole)) t->wanted = ALGSURF_I_ALL;
    if (!radii) return solve_exact(t, roots);
    while (t->p.c[t->p.degree] == 0 && t->p.r[t->p.degree] == 0) t->p.degree--;
    if (!may_vanish(&t->p)) return solve_set(t);
    all_undecided(t);
    return ALGSURF_OK;
}

/* The roots that are certain. */
static int number_of(const task *t) {
    int number = 0;
    if (t->wanted == ALGSURF_I_NUMBER) return t->count;
    for (int i = 0; i < t->count; i++) number += t->b[i].kind != ALGSURF_BRACKET_UNDECIDED;
    return number;
}

/* Runs the search into `all`; the first undecided reason is the status. */
static algsurf_status run(const double *c, const double *r, int degree, double lo, double hi, int wanted,
                          algsurf_observer *observer, room *all, int *count) {
    const algsurf_i_watch watch = {.observer = observer};
    task t = {{c, r, degree}, lo, hi, wanted, observer ? &watch : NULL, all->b, 0, degree > 0 ? degree : 1};
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = check_and_isolate(&t, all->roots);
    algsurf_fpenv_leave(&saved);
    if (status != ALGSURF_OK) return status;
    *count = wanted == ALGSURF_I_NUMBER ? number_of(&t) : t.count;
    if (t.wanted == ALGSURF_I_NUMBER) return ALGSURF_OK;
    for (int i = 0; i < t.count; i++)
        if (t.b[i].status != ALGSURF_OK) return t.b[i].status;
    return ALGSURF_OK;
}

static int read_options(const algsurf_isolate_options *given, algsurf_observer **observer) {
    algsurf_isolate_options known;
    *observer = NULL;
    if (!given) return 1;
    if (!algsurf_options_read(&known, sizeof known, given)) return 0;
    *observer = known.observer;
    return algsurf_i_observer_is_good(known.observer);
}

static int make_room(room *r, int degree) {
    r->b = r->few, r->roots = r->few_roots;
    if (degree <= ALGSURF_MAX_DEGREE || degree > ALGSURF_MAX_POLY_DEGREE) return 1;
    r->b = malloc((size_t)degree * (sizeof *r->b + sizeof *r->roots));
    r->roots = (algsurf_real_root *)(void *)(r->b + degree);
    return r->b != NULL;
}

static void free_room(room *r) {
    if (r->b != r->few) free(r->b);
}

algsurf_status algsurf_isolate_first(const double *c, const double *r, int degree, double lo, double hi,
                                     const algsurf_isolate_options *options, algsurf_bracket *bracket,
                                     int *found) {
    room all;
    algsurf_observer *observer;
    int count = 0;
    if (!bracket || !found || !read_options(options, &observer)) return ALGSURF_E_ARGUMENT;
    if (!make_room(&all, degree)) return ALGSURF_E_NO_MEMORY;
    algsurf_status status = run(c, r, degree, lo, hi, ALGSURF_I_FIRST, observer, &all, &count);
    if (status >= 0) *found = count;
    if (status >= 0 && count) *bracket = all.b[0];
    free_room(&all);
    return status;
}

algsurf_status algsurf_isolate_all(const double *c, const double *r, int degree, double lo, double hi,
                                   const algsurf_isolate_options *options, algsurf_bracket *brackets,
                                   int capacity, int *count) {
    room all;
    algsurf_observer *observer;
    int n = 0;
    if (!brackets || !count || capacity < 0 || !read_options(options, &observer)) return ALGSURF_E_ARGUMENT;
    if (!make_room(&all, degree)) return ALGSURF_E_NO_MEMORY;
    algsurf_status status = run(c, r, degree, lo, hi, ALGSURF_I_ALL, observer, &all, &n);
    if (status >= 0 && n > capacity) status = ALGSURF_E_ARGUMENT;
    if (status >= 0) {
        memcpy(brackets, all.b, (size_t)n * sizeof *brackets);
        *count = n;
    }
    free_room(&all);
    return status;
}

algsurf_status algsurf_count_roots(const double *c, const double *r, int degree, double lo, double hi,
                                   int *count) {
    room all;
    if (!count) return ALGSURF_E_ARGUMENT;
    if (!make_room(&all, degree)) return ALGSURF_E_NO_MEMORY;
    algsurf_status status = run(c, r, degree, lo, hi, ALGSURF_I_NUMBER, NULL, &all, count);
    free_room(&all);
    return status;
}
