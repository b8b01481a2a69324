/* isolate.c - roots of a polynomial in an interval of the line: the public calls.
 *
 * Doubles come first, one polynomial in one lane (single_template.h): moderate degree, and roots not far
 * smaller than the interval, which is cut where no root can be beyond.  What they leave undecided goes to
 * integers (decide.c), or, where coefficients are known to radii only, to integers with envelopes
 * (exact_radii.c): those brackets that the doubles were sure of are kept, so that the first root is the same
 * whether the others are looked for or not.  Before all that a polynomial t^m q(t^k) becomes q (power.c).
 */
#include "../base/arithmetic.h"
#include "algsurf/isolate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../base/options.h"
#include "coefficients.h"
#include "decide.h"
#include "kernel.h"
#include "power.h"
#include "quadratic.h"
#include "quarters.h"
#include "sturm.h"

/* NUMBER: without brackets, where these are not needed: on the whole line, without radii. */
enum { ALL, FIRST, NUMBER };

typedef struct task {
    algsurf_i_coefficients p;
    double lo, hi;
    int wanted;
    algsurf_bracket *b;
    int count, capacity;
    int halvings;                 /* of what a lane leaves undecided */
    const algsurf_i_watch *watch; /* null: nobody looks */
} task;

/* Degrees 1 and 2, without radii; returns 0 where signs are not known. */
static int walk_quadratic(task *t, double lo, double hi) {
    algsurf_bracket two[2];
    int found;
    if (t->p.degree < 1 || t->p.degree > 2 || t->p.r || !(lo < hi) ||
        !algsurf_i_quadratic_isolate(t->p.c, t->p.degree, lo, hi, two, &found))
        return 0;
    if (t->watch) {
        const algsurf_cell cell = {lo, hi, found, ALGSURF_ENGINE_DOUBLES, t->p.degree, NULL};
        algsurf_i_tell_cell(t->watch, &cell);
    }
    if (t->wanted == FIRST && found > 1) found = 1;
    for (int i = 0; i < found; i++) t->b[t->count++] = two[i];
    return 1;
}

/* [from,to] in a lane, as far as it is asked for; returns 0 when that leaves something undecided.  A part of
 * a piece has smaller bounds of rounding than the piece: what this leaves is tried again by halves. */
static int walk_piece(task *t, double from, double to, int halvings) {
    int most = (t->wanted == FIRST ? 1 : t->capacity) - t->count, found = 0;
    double lo = fmax(from, t->lo), hi = fmin(to, t->hi);
    if (lo >= hi || most == 0) return 1;
    if (!(fmax(fabs(lo), fabs(hi)) > 0x1p-900 && hi - lo < 0x1p1000)) return 0;
    if (walk_quadratic(t, lo, hi)) return 1;
    int done = algsurf_i_roots_single_fastest()(&t->p, lo, hi, most, t->b + t->count, &found, t->watch);
    t->count += found;
    if (done || halvings == 0 || t->p.r) return done;
    double rest = found ? t->b[t->count - 1].hi : lo, middle = 0.5 * rest + 0.5 * hi;
    return walk_piece(t, rest, middle, halvings - 1) && walk_piece(t, middle, hi, halvings - 1);
}

enum { SPREAD = 24, NO_TERM = -(1 << 20) }; /* binary digits that one piece may lose; the exponent of 0 */

/* An end of pieces, a little above 2^e: they are halved, and a root that is a round number hides the sign. */
static double end_of_piece(int e) { return ldexp(1 + 0x1p-5 + 0x1p-11, e); }

/* Is there no root between end_of_piece(a) and end_of_piece(b), on this side of 0, as one term is larger than
 * all those of the other sign together?  |c_k| is at least 2^e[k] and below twice that, and 1.04 <
 * 2^(1/16). */
static int has_no_root(const algsurf_i_coefficients *p, const int *e, int side, int a, int b) {
    int m = 0;
    double others = 0;
    for (int k = 1; k <= p->degree; k++)
        if (2 * e[k] + k * (a + b) > 2 * e[m] + m * (a + b)) m = k;
    for (int k = 0; k <= p->degree; k++) {
        int same = (p->c[k] > 0) == (p->c[m] > 0), d = k - m;
        if (same == (side > 0 || d % 2 == 0)) continue;
        others += ldexp(1, e[k] + 1 - e[m] + d * (d > 0 ? b : a) + (d > 0 ? (d + 15) / 16 : 0));
    }
    return others < 1 - 0x1p-40 && !p->r; /* which takes in the roundings of the sum */
}

static int walk_side(task *t, const int *e, int side, int from, int to) {
    if (has_no_root(&t->p, e, side, from, to)) return 1;
    double near = end_of_piece(from), far = end_of_piece(to);
    return side > 0 ? walk_piece(t, near, far, t->halvings) : walk_piece(t, -far, -near, t->halvings);
}

/* Is no term more than SPREAD digits larger than c_0 for |t| <= size?  One piece will do then. */
static int is_level(const algsurf_i_coefficients *p, double size) {
    double most = fabs(p->c[0]) * (1 << SPREAD), power = 1;
    for (int k = 1; k <= p->degree; k++)
        if (!(fabs(p->c[k]) * (power *= size) <= most)) return 0;
    return size < 0x1p300;
}

/* All of [lo,hi] in a lane: in one piece, or, where roots can be of very different sizes, in pieces, of which
 * in that about 0 no term is more than SPREAD digits larger than c_0. */
static int walk_lane(task *t) {
    int n = t->p.degree, e[ALGSURF_MAX_DEGREE + 1];
    double size = fmax(fabs(t->lo), fabs(t->hi));
    if (!(t->lo < t->hi) || n == 0 || n > ALGSURF_MAX_DEGREE || t->p.c[0] == 0 || t->p.c[n] == 0) return 0;
    if (is_level(&t->p, size)) return walk_piece(t, t->lo, t->hi, t->halvings);
    int bound = size < 0x1p900 ? ilogb(size) + 1 : algsurf_i_root_bound(&t->p), inner = bound;
    for (int k = 0; k <= n; k++) {
        e[k] = t->p.c[k] != 0 ? ilogb(t->p.c[k]) : NO_TERM;
        if (k > 0 && SPREAD + e[0] - e[k] < k * inner) inner = (int)floor((SPREAD + e[0] - e[k]) / (double)k);
    }
    if (bound > 900 || inner < -900) return 0;
    int done = 1, step = SPREAD > n ? SPREAD / n : 1;
    for (int i = bound; done && i > inner; i -= step)
        done = walk_side(t, e, -1, i - step > inner ? i - step : inner, i);
    done = done && walk_piece(t, -end_of_piece(inner), end_of_piece(inner), t->halvings);
    for (int i = inner; done && i < bound; i += step)
        done = walk_side(t, e, 1, i, i + step < bound ? i + step : bound);
    return done;
}

/* The interval from where the lane's last bracket ends. */
static double begin_of_rest(const task *t) { return t->count > 0 ? t->b[t->count - 1].hi : t->lo; }

static algsurf_status walk_integers(task *t, double lo, double hi) {
    int found = 0, most = (t->wanted == FIRST ? 1 : t->capacity) - t->count;
    algsurf_status status =
        algsurf_i_decide_brackets(t->p.c, t->p.degree, lo, hi, t->b + t->count, most, &found, t->watch);
    t->count += found;
    return status;
}

/* A part in a lane, patiently, then in integers. */
static algsurf_status walk_part(task *t, double lo, double hi) {
    task part = *t;
    part.lo = lo;
    part.hi = hi;
    part.halvings = ALGSURF_I_HALVINGS;
    int done = t->halvings < ALGSURF_I_HALVINGS && walk_lane(&part);
    t->count = part.count;
    return done ? ALGSURF_OK : walk_integers(t, t->count > 0 ? fmax(lo, t->b[t->count - 1].hi) : lo, hi);
}

static algsurf_status walk_parts(task *t) {
    algsurf_i_part parts[ALGSURF_I_PARTS];
    algsurf_status status = ALGSURF_OK;
    int count = algsurf_i_parts_of(&t->p, begin_of_rest(t), t->hi, parts, t->watch);
    for (int i = 0; status == ALGSURF_OK && i < count && !(t->wanted == FIRST && t->count); i++) {
        const algsurf_i_part *k = parts + i;
        if (k->sign)
            t->b[t->count++] =
                (algsurf_bracket){k->lo, k->hi, ALGSURF_BRACKET_ISOLATED, k->sign, 1, ALGSURF_OK};
        else
            status = walk_part(t, k->lo, k->hi);
    }
    return status;
}

/* Descartes' rule on one side of 0: as many roots, or fewer by an even number. */
static int variations(const algsurf_i_coefficients *p, int side) {
    int count = 0, last = 0;
    for (int k = 0; k <= p->degree; k++) {
        int sign = p->c[k] == 0 ? 0 : (p->c[k] > 0) == (side > 0 || k % 2 == 0) ? 1 : -1;
        count += sign * last < 0;
        last = sign ? sign : last;
    }
    return count;
}

/* Sides of 0 with at most as many variations are left out of [lo,hi], unless one piece will do for both;
 * returns how many roots they have. */
static int leave_sides(task *t, int most) {
    if (is_level(&t->p, fmax(fabs(t->lo), fabs(t->hi)))) return 0;
    int below = t->lo < 0 ? variations(&t->p, -1) : most + 1;
    int above = t->hi > 0 ? variations(&t->p, 1) : most + 1;
    if (below <= most) t->lo = 0;
    if (above <= most) t->hi = 0;
    return (below <= most ? below : 0) + (above <= most ? above : 0);
}

static int is_empty(const task *t) { return t->lo > t->hi || (t->lo == 0 && t->hi == 0 && t->p.c[0] != 0); }

/* Changes the ends, too. */
static algsurf_status walk_itself(task *t) {
    int left = leave_sides(t, t->wanted == NUMBER), done = is_empty(t);
    t->halvings = algsurf_i_halvings_at_first(t->p.degree);
    if (t->wanted == NUMBER && !done && t->p.c[0] != 0)
        done = algsurf_i_count_by_sturm(t->p.c, t->p.degree, t->lo, t->hi, &t->count);
    algsurf_status status = done || walk_lane(t) ? ALGSURF_OK : walk_parts(t);
    t->count += left;
    return status;
}

/* By the roots of q, all of them; returns 0 when p itself has to be looked at. */
static int walk_power(task *t, const algsurf_i_power *w) {
    task q = *t;
    q.p.c = w->q;
    q.p.degree = q.capacity = w->degree;
    if (q.wanted == FIRST) q.wanted = ALL;
    algsurf_i_power_interval(w, t->lo, t->hi, &q.lo, &q.hi);
    algsurf_i_watch watch;
    if (t->watch) {
        watch = *t->watch;
        watch.power = w->step;
        q.watch = &watch;
    }
    if (w->degree > 0 && walk_itself(&q) != ALGSURF_OK) return 0;
    t->count = q.count;
    if (t->wanted == NUMBER)
        t->count = (w->step % 2 ? 1 : 2) * q.count + (w->zeros > 0);
    else if (!algsurf_i_power_roots(w, t->p.c, t->lo, t->hi, t->b, &t->count))
        return t->count = 0;
    if (t->wanted == FIRST && t->count > 1) t->count = 1;
    return 1;
}

static int walk_level_quadratic(task *t) {
    return t->p.degree <= 2 && is_level(&t->p, fmax(fabs(t->lo), fabs(t->hi))) &&
           walk_quadratic(t, t->lo, t->hi);
}

static algsurf_status walk(task *t) {
    algsurf_i_power w;
    if (t->wanted == NUMBER && (t->count = algsurf_i_count_by_discriminant(t->p.c, t->p.degree)) >= 0)
        return ALGSURF_OK;
    t->count = 0;
    if (walk_level_quadratic(t)) return ALGSURF_OK;
    if (algsurf_i_power_of(t->p.c, t->p.degree, &w) && walk_power(t, &w)) return ALGSURF_OK;
    return walk_itself(t);
}

int algsurf_i_isolate_in_lane(const algsurf_i_coefficients *p, double *lo, double *hi, int first_only,
                              int halvings, algsurf_bracket *brackets, int *count) {
    task t = {*p, *lo, *hi, first_only ? FIRST : ALL, brackets, 0, p->degree, halvings, NULL};
    int done = walk_level_quadratic(&t);
    if (!done) (void)leave_sides(&t, 0);
    done = done || is_empty(&t) || walk_lane(&t);
    *lo = t.lo, *hi = t.hi;
    *count = t.count;
    return done;
}

static algsurf_status walk_envelopes(task *t) {
    int found = 0;
    algsurf_status status = algsurf_i_decide_ranges(&t->p, begin_of_rest(t), t->hi, t->b + t->count,
                                                    t->capacity - t->count, &found, t->watch);
    t->count += found;
    if (t->wanted == FIRST && t->count > 1) t->count = 1;
    return status;
}

static void all_undecided(task *t) {
    int most = t->p.degree > 0 ? t->p.degree : 1;
    t->b[0] = (algsurf_bracket){t->lo, t->hi, ALGSURF_BRACKET_UNDECIDED, 0, most, ALGSURF_UNDECIDED_ZERO};
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
    if (t->wanted == NUMBER && (t->p.r || t->lo != -HUGE_VAL || t->hi != HUGE_VAL)) t->wanted = ALL;
    while (t->p.c[t->p.degree] == 0 && (!t->p.r || t->p.r[t->p.degree] == 0)) t->p.degree--;
    if (may_vanish(&t->p)) {
        all_undecided(t);
        return ALGSURF_OK;
    }
    if (!t->p.r) return walk(t);
    return walk_lane(t) ? ALGSURF_OK : walk_envelopes(t);
}

/* The roots that are certain. */
static int number_of(const task *t) {
    int number = 0;
    if (t->wanted == NUMBER) return t->count;
    for (int i = 0; i < t->count; i++) number += t->b[i].kind != ALGSURF_BRACKET_UNDECIDED;
    return number;
}

/* Runs the search into `room` for degree brackets, at least 1; the first undecided reason is the status. */
static algsurf_status run(const double *c, const double *r, int degree, double lo, double hi, int wanted,
                          algsurf_observer *observer, algsurf_bracket *room, int *count) {
    const algsurf_i_watch watch = {.observer = observer};
    task t = {{c, r, degree}, lo, hi, wanted, room, 0, degree > 0 ? degree : 1, 0, observer ? &watch : NULL};
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = check_and_isolate(&t);
    algsurf_fpenv_leave(&saved);
    if (status != ALGSURF_OK) return status;
    *count = wanted == NUMBER ? number_of(&t) : t.count;
    if (t.wanted == NUMBER) return ALGSURF_OK;
    for (int i = 0; i < t.count; i++)
        if (room[i].kind == ALGSURF_BRACKET_EXACT) room[i].sign = 0;
    for (int i = 0; i < t.count; i++)
        if (room[i].status != ALGSURF_OK) return room[i].status;
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

/* Brackets on the stack, or, beyond the degrees that doubles decide, allocated. */
typedef struct room {
    algsurf_bracket few[ALGSURF_MAX_DEGREE + 1], *b;
} room;

static int make_room(room *r, int degree) {
    int many = degree > ALGSURF_MAX_DEGREE && degree <= ALGSURF_MAX_POLY_DEGREE;
    r->b = many ? malloc((size_t)degree * sizeof *r->b) : r->few;
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
    algsurf_status status = run(c, r, degree, lo, hi, FIRST, observer, all.b, &count);
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
    algsurf_status status = run(c, r, degree, lo, hi, ALL, observer, all.b, &n);
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
    algsurf_status status = run(c, r, degree, lo, hi, NUMBER, NULL, all.b, count);
    free_room(&all);
    return status;
}
