/* isolate.c - the real roots of one polynomial, isolated or refined: the public calls.
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
#include "line.h"

static algsurf_status check_coefficients(algsurf_i_line *line) {
    if (!line->p.c && !line->z) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_interval(line->lo, line->hi);
    if (status != ALGSURF_OK) return status;
    return line->z ? algsurf_zpoly_check(line->z, line->p.degree) : algsurf_i_check_coefficients(&line->p);
}

static ALGSURF_NOINLINE algsurf_status find(algsurf_i_line *line, algsurf_real_root *roots, int capacity,
                                            int *count) {
    algsurf_real_root found[ALGSURF_MAX_POLY_DEGREE];
    int n = 0;
    algsurf_status status = check_coefficients(line);
    if (status == ALGSURF_OK) status = algsurf_i_line_solve(line, found, &n);
    if (status != ALGSURF_OK) return status;
    if (n > capacity) return ALGSURF_E_CAPACITY;
    memcpy(roots, found, (size_t)n * sizeof *roots);
    *count = n;
    return ALGSURF_OK;
}

static algsurf_status refine(algsurf_i_line *line, algsurf_real_root *roots, int capacity, int *count) {
    algsurf_status status;
    if (!roots || !count || capacity < 0) return ALGSURF_E_ARGUMENT;
    ALGSURF_STANDARD(status = find(line, roots, capacity, count));
    return status;
}

algsurf_status algsurf_real_roots(const double *c, int degree, double lo, double hi, algsurf_real_root *roots,
                                  int capacity, int *count) {
    algsurf_i_line line = {.p = {c, NULL, degree}, .lo = lo, .hi = hi, .refined = 1};
    return refine(&line, roots, capacity, count);
}

algsurf_status algsurf_real_roots_integers(const algsurf_integer *c, int degree, double lo, double hi,
                                           algsurf_real_root *roots, int capacity, int *count) {
    algsurf_i_line line = {.p = {NULL, NULL, degree}, .z = c, .lo = lo, .hi = hi, .refined = 1};
    return refine(&line, roots, capacity, count);
}

/* ---- isolated ---- */

/* What is found: roots of an exact polynomial, or brackets of a set.  On the stack, or, beyond the degrees
 * that doubles decide, allocated. */
typedef union place {
    algsurf_real_root root;
    algsurf_bracket bracket;
} place;

typedef struct task {
    algsurf_i_line line;
    void *room;
    int capacity, count; /* there */
    algsurf_bracket *to; /* the caller's, null: none are asked for; room for so many */
    int most;
    int certain; /* how many are roots */
} task;

/* Nothing can be said of a set of polynomials that holds the zero polynomial. */
static int may_vanish(const algsurf_i_coefficients *p) {
    for (int k = 0; k <= p->degree; k++)
        if (fabs(p->c[k]) > p->r[k]) return 0;
    return 1;
}

/* Of the set of polynomials within the radii. */
static algsurf_status solve_set(task *t) {
    const algsurf_i_line *s = &t->line;
    algsurf_bracket *b = t->room;
    int first = s->wanted == ALGSURF_I_FIRST, most = s->p.degree > 0 ? s->p.degree : 1, found = 0;
    if (may_vanish(&s->p)) {
        b[0] = (algsurf_bracket){s->lo, s->hi, ALGSURF_BRACKET_UNDECIDED, 0, most, ALGSURF_UNDECIDED_ZERO};
        t->count = 1;
        return ALGSURF_OK;
    }
    int level = algsurf_i_is_level(&s->p, fmax(fabs(s->lo), fabs(s->hi)));
    if (algsurf_i_walk(&s->p, s->lo, s->hi, level, first ? 1 : t->capacity, b, &t->count, s->watch))
        return ALGSURF_OK;
    double rest = t->count > 0 ? b[t->count - 1].hi : s->lo;
    algsurf_status status =
        algsurf_i_decide_ranges(&s->p, rest, s->hi, b + t->count, t->capacity - t->count, &found, s->watch);
    t->count += found;
    if (first && t->count > 1) t->count = 1;
    return status;
}

static algsurf_bracket bracket_of(const algsurf_real_root *r) {
    int exact = r->lo == r->hi, kind = exact ? ALGSURF_BRACKET_EXACT : ALGSURF_BRACKET_ISOLATED;
    return (algsurf_bracket){r->lo, r->hi, kind, exact ? 0 : r->sign, r->multiplicity, ALGSURF_OK};
}

/* To the caller.  The first undecided reason is the status. */
static algsurf_status give(task *t) {
    const algsurf_bracket *set = t->room;
    const algsurf_real_root *exact = t->room;
    algsurf_status status = ALGSURF_OK;
    t->certain = t->count;
    if (t->to && t->count > t->most) return ALGSURF_E_CAPACITY;
    for (int i = 0; i < t->count && t->line.wanted != ALGSURF_I_NUMBER; i++) {
        algsurf_bracket b = t->line.p.r ? set[i] : bracket_of(exact + i);
        if (t->to) t->to[i] = b;
        t->certain -= b.kind == ALGSURF_BRACKET_UNDECIDED;
        if (status == ALGSURF_OK) status = b.status;
    }
    return status;
}

static ALGSURF_NOINLINE algsurf_status check_and_isolate(task *t) {
    algsurf_i_line *line = &t->line;
    algsurf_status status = check_coefficients(line);
    if (status != ALGSURF_OK) return status;
    int whole = line->lo == -HUGE_VAL && line->hi == HUGE_VAL;
    if (line->wanted == ALGSURF_I_NUMBER && (line->p.r || !whole)) line->wanted = ALGSURF_I_ALL;
    status = line->p.r ? solve_set(t) : algsurf_i_line_solve(line, t->room, &t->count);
    return status == ALGSURF_OK ? give(t) : status;
}

/* Of the roots, or places, that are wanted, those in brackets that are asked for. */
static algsurf_status isolate(task *t, const algsurf_isolate_options *given) {
    algsurf_isolate_options options = {.observer = NULL};
    algsurf_i_watch watch = {.observer = NULL};
    place few[ALGSURF_MAX_DEGREE + 1];
    int degree = t->line.p.degree, many = degree > ALGSURF_MAX_DEGREE && degree <= ALGSURF_MAX_POLY_DEGREE;
    algsurf_status status = given ? algsurf_options_read(&options, sizeof options, given) : ALGSURF_OK;
    if (status == ALGSURF_OK) status = algsurf_i_observer_check(watch.observer = options.observer);
    if (status != ALGSURF_OK) return status;
    if (watch.observer) t->line.watch = &watch;
    t->room = many ? malloc((size_t)degree * sizeof *few) : few;
    t->capacity = degree > 0 ? degree : 1;
    if (!t->room) return ALGSURF_E_NO_MEMORY;
    ALGSURF_STANDARD(status = check_and_isolate(t));
    if (many) free(t->room);
    return status;
}

algsurf_status algsurf_isolate_first(const double *c, const double *r, int degree, double lo, double hi,
                                     const algsurf_isolate_options *options, algsurf_bracket *bracket,
                                     int *found) {
    if (!bracket || !found) return ALGSURF_E_ARGUMENT;
    task t = {.line = {.p = {c, r, degree}, .lo = lo, .hi = hi, .wanted = ALGSURF_I_FIRST}};
    t.to = bracket, t.most = 1;
    algsurf_status status = isolate(&t, options);
    if (status >= 0) *found = t.count;
    return status;
}

algsurf_status algsurf_isolate_all(const double *c, const double *r, int degree, double lo, double hi,
                                   const algsurf_isolate_options *options, algsurf_bracket *brackets,
                                   int capacity, int *count) {
    if (!brackets || !count || capacity < 0) return ALGSURF_E_ARGUMENT;
    task t = {.line = {.p = {c, r, degree}, .lo = lo, .hi = hi, .wanted = ALGSURF_I_ALL}};
    t.to = brackets, t.most = capacity;
    algsurf_status status = isolate(&t, options);
    if (status >= 0) *count = t.count;
    return status;
}

algsurf_status algsurf_count_roots(const double *c, const double *r, int degree, double lo, double hi,
                                   int *count) {
    if (!count) return ALGSURF_E_ARGUMENT;
    task t = {.line = {.p = {c, r, degree}, .lo = lo, .hi = hi, .wanted = ALGSURF_I_NUMBER}};
    algsurf_status status = isolate(&t, NULL);
    if (status >= 0) *count = t.certain;
    return status;
}
