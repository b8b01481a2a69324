/* isolate.c - roots of a polynomial in an interval of the line: the public calls.
 *
 * A finite interval, up to degree 64, is walked by a lane, in double (single_template.h).  If that leaves a
 * cell undecided, or sizes differ too much, every stretch of the interval is walked in its own unit; if a
 * cell still stays undecided, all of them once more in double-double; if then an end of the interval is in
 * doubt and the coefficients are exact, the sign there is computed exactly, and the walk repeated knowing
 * that the end is a root. */
#include "algsurf/isolate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/fpenv.h"
#include "isolate_impl.h"
#include "kernel.h"

typedef struct task {
    algsurf_i_coefficients p;
    double lo, hi;
    int first_only;
    int zero_at_lo, zero_at_hi; /* ends, not 0, that are known to be roots */
    algsurf_i_brackets found;
    int kept;    /* of them are certain: [lo,hi] begins after them */
    int counted; /* intervals, in all walks */
} task;

/* Coefficients above the zeros in units of 2^exponent, scaled so that the largest is about 1. */
static void scale(const algsurf_i_coefficients *p, int exponent, double *q, double *r) {
    int common = algsurf_i_common_exponent(p, p->zeros, exponent);
    for (int k = p->zeros; k <= p->degree; k++) {
        q[k - p->zeros] = ldexp(p->c[k], k * exponent - common);
        r[k - p->zeros] = p->r ? ldexp(p->r[k], k * exponent - common) : 0;
    }
}

/* An end of a stretch in its unit; where that is no double, the next one outward: no root gets lost. */
static double end_in_unit(double x, int exponent, double outside) {
    double v = ldexp(x, -exponent);
    return isnormal(v) || ldexp(v, exponent) == x ? v : nextafter(v, outside);
}

static int pieces_of(const task *t, const algsurf_i_stretch *s, algsurf_i_piece *pieces) {
    double lo = end_in_unit(s->lo, s->exponent, -HUGE_VAL), hi = end_in_unit(s->hi, s->exponent, HUGE_VAL);
    int count = algsurf_i_cut_line(algsurf_dd_from(lo), algsurf_dd_from(hi), pieces);
    if (count > 0 && t->zero_at_lo) pieces[0].zero_at_lo = t->lo == ldexp(lo, s->exponent);
    if (count > 0 && t->zero_at_hi) pieces[count - 1].zero_at_hi = t->hi == ldexp(hi, s->exponent);
    return count;
}

/* After an entry: is the search for a first root over?  An undecided entry may still grow, a loose one has to
 * be followed by another. */
static int finished(const task *t) {
    const algsurf_i_brackets *f = &t->found;
    if (!t->first_only || f->count == 0) return 0;
    return f->count > 1 || (f->b[0].kind != ALGSURF_ROOT_UNDECIDED && !f->loose);
}

/* One stretch in double; returns 0 when a cell stayed undecided. */
static int walk_d(task *t, const algsurf_i_stretch *s) {
    int decided = 1;
    double q[ALGSURF_MAX_POLY_DEGREE + 1], r[ALGSURF_MAX_POLY_DEGREE + 1];
    algsurf_i_walk_d walk;
    algsurf_i_piece pieces[3];
    algsurf_i_cell cell;
    scale(&t->p, s->exponent, q, r);
    algsurf_i_walk_begin_d(&walk, q, r, t->p.degree - t->p.zeros, 1, pieces, pieces_of(t, s, pieces));
    while (decided && !finished(t) && algsurf_i_walk_next_d(&walk, &cell))
        decided = cell.kind == ALGSURF_ROOT_BRACKET && algsurf_i_add_cell(&t->found, &t->p, s, &cell);
    t->counted += walk.counted;
    return decided;
}

/* One stretch in double-double; returns 0 when there was no room for another entry. */
static int walk_dd(task *t, const algsurf_i_stretch *s) {
    double q[ALGSURF_MAX_POLY_DEGREE + 1], r[ALGSURF_MAX_POLY_DEGREE + 1];
    algsurf_dd wide[ALGSURF_MAX_POLY_DEGREE + 1];
    algsurf_i_walk_dd walk;
    algsurf_i_piece pieces[3];
    algsurf_i_cell cell;
    int n = t->p.degree - t->p.zeros, fits = 1;
    scale(&t->p, s->exponent, q, r);
    for (int k = 0; k <= n; k++) wide[k] = algsurf_dd_from(q[k]);
    algsurf_i_walk_begin_dd(&walk, wide, r, n, 1, pieces, pieces_of(t, s, pieces));
    while (fits && !finished(t) && algsurf_i_walk_next_dd(&walk, &cell))
        fits = algsurf_i_add_cell(&t->found, &t->p, s, &cell);
    t->counted += walk.counted;
    return fits;
}

/* All stretches, the root at 0 in its place; returns 0 as walk_d does. */
static int walk(task *t, int (*one)(task *, const algsurf_i_stretch *)) {
    algsurf_i_stretch s[ALGSURF_MOST_STRETCHES];
    int constant = t->p.degree == t->p.zeros; /* but for x^zeros; it does not vanish, see may_vanish */
    int count = constant ? 0 : algsurf_i_stretches(&t->p, t->lo, t->hi, s);
    int zero_due = t->p.zeros > 0 && t->lo <= 0 && t->hi >= 0;
    t->found.count = t->kept;
    t->found.loose = 0;
    for (int i = 0; i < count && !finished(t); i++) {
        if (zero_due && s[i].lo >= 0) {
            zero_due = 0;
            if (!algsurf_i_add_exact(&t->found, &t->p, 0, t->p.zeros)) return 0;
            if (finished(t)) return 1;
        }
        if (!one(t, s + i)) return 0;
    }
    return finished(t) || !zero_due || algsurf_i_add_exact(&t->found, &t->p, 0, t->p.zeros);
}

enum {
    MODERATE = 400, /* binary orders of magnitude that a coefficient may be from 1 */
    LONGER = 8      /* and by which the interval may be longer than the roots are large, on average */
};

/* Coefficients in units of 2^exponent, if that keeps them moderate, and the roots not too close to 0. */
static int moderate(const algsurf_i_coefficients *p, int exponent, double *q, double *r) {
    const double unit = ldexp(1, exponent);
    double power = 1, largest = 0;
    if (abs(exponent) * p->degree > 2 * MODERATE) return 0;
    for (int k = 0; k <= p->degree; k++, power *= unit) {
        q[k] = p->c[k] * power;
        r[k] = p->r ? p->r[k] * power : 0;
        largest = fabs(q[k]) > largest ? fabs(q[k]) : largest;
        if (!(r[k] < ldexp(1, MODERATE))) return 0;
    }
    return largest > ldexp(1, -MODERATE) && largest < ldexp(1, MODERATE) &&
           fabs(q[0]) >= ldexp(largest, -LONGER * p->degree);
}

/* What has been found up to where a cell stayed undecided is kept, so that the first root is the same whether
 * the others are looked for or not. */
static void keep_brackets(task *t) {
    int count = t->found.count - t->found.loose;
    while (t->kept < count && t->found.b[t->kept].kind == ALGSURF_ROOT_BRACKET) t->kept++;
    if (t->kept > 0) t->lo = t->found.b[t->kept - 1].hi;
}

/* All of [lo,hi] in double, as one piece in units of its larger end, for degrees that are no lane's; returns
 * 0 when that is no way to find out: numbers far from 1, a root at 0 known beforehand, or a cell that stays
 * undecided. */
static int walk_whole(task *t) {
    double q[ALGSURF_MAX_POLY_DEGREE + 1], r[ALGSURF_MAX_POLY_DEGREE + 1];
    int decided = 1, exponent;
    algsurf_i_stretch s = {t->lo, t->hi, 0};
    algsurf_i_walk_d walk;
    algsurf_i_cell cell;
    if (t->p.zeros > 0 || t->p.degree <= ALGSURF_MAX_DEGREE || isinf(t->lo) || isinf(t->hi)) return 0;
    if (frexp(fmax(fabs(t->lo), fabs(t->hi)), &exponent) == 0.5) exponent--;
    s.exponent = exponent;
    if (!moderate(&t->p, exponent, q, r)) return 0;
    const algsurf_i_piece piece = {0, algsurf_dd_from(ldexp(t->lo, -exponent)),
                                   algsurf_dd_from(ldexp(t->hi, -exponent)), 0, 0};
    if (ldexp(piece.lo.hi, exponent) != t->lo || ldexp(piece.hi.hi, exponent) != t->hi) return 0;
    algsurf_i_walk_begin_d(&walk, q, t->p.r ? r : NULL, t->p.degree, 1, &piece, 1);
    while (decided && !finished(t) && algsurf_i_walk_next_d(&walk, &cell))
        decided = cell.kind == ALGSURF_ROOT_BRACKET && algsurf_i_add_cell(&t->found, &t->p, &s, &cell) &&
                  t->found.b[t->found.count - 1].kind == ALGSURF_ROOT_BRACKET;
    t->counted += walk.counted;
    if (!decided) keep_brackets(t);
    return decided;
}

/* Is there a root that is far smaller than the interval, so that it wants an interval of its own? */
static int small_root(const task *t) {
    double largest = 0, most = fmax(fabs(t->lo), fabs(t->hi)), power = 1;
    if (t->lo > 0 || t->hi < 0) return 0;
    for (int k = 0; k <= t->p.degree; k++, power *= most) largest = fmax(largest, fabs(t->p.c[k]) * power);
    return !(fabs(t->p.c[0]) >= ldexp(largest, -LONGER * t->p.degree));
}

/* [lo,hi] in a lane; returns 0 when that leaves something undecided. */
static int walk_lane(task *t) {
    int most = t->first_only ? 1 : t->found.capacity;
    if (t->p.degree == 0 || t->p.degree > ALGSURF_MAX_DEGREE || small_root(t)) return 0;
    if (!(fmax(fabs(t->lo), fabs(t->hi)) > 0x1p-900 && t->hi - t->lo < 0x1p1000)) return 0;
    int decided = algsurf_i_roots_single(&t->p, t->lo, t->hi, most, t->found.b, &t->found.count, &t->counted);
    if (!decided) keep_brackets(t);
    return decided;
}

/* Undecided at an end of the interval: is that end exactly a root? */
static int end_is_root(const task *t, double x) {
    if (t->p.r || x == 0 || isinf(x)) return 0;
    for (int i = 0; i < t->found.count; i++) {
        const algsurf_bracket *b = t->found.b + i;
        if (b->kind == ALGSURF_ROOT_UNDECIDED && b->lo <= x && x <= b->hi)
            return algsurf_i_sign_at(&t->p, x) == 0;
    }
    return 0;
}

static void all_undecided(task *t) {
    int most = t->p.degree > 0 ? t->p.degree : 1;
    t->found.b[0] = (algsurf_bracket){t->lo, t->hi, ALGSURF_ROOT_UNDECIDED, 0, most, ALGSURF_UNDECIDED_ZERO};
    t->found.count = 1;
}

static void single_point(task *t) {
    int sign = isinf(t->lo) ? 1 : algsurf_i_sign_at(&t->p, t->lo);
    t->found.count = 0;
    if (sign == 0)
        (void)algsurf_i_add_exact(&t->found, &t->p, t->lo, t->p.degree);
    else if (sign == ALGSURF_SIGN_UNKNOWN)
        all_undecided(t);
}

/* More entries than the degree: the last one takes in all the rest. */
static void cover_rest(task *t) {
    algsurf_bracket *last = t->found.b + t->found.count - 1;
    double lo = t->found.loose ? t->found.above : last->lo;
    *last = (algsurf_bracket){
        lo, t->hi,       ALGSURF_ROOT_UNDECIDED,
        0,  t->p.degree, last->status != ALGSURF_OK ? last->status : ALGSURF_UNDECIDED_MULTIPLE};
}

static void isolate(task *t) {
    if (t->lo == t->hi) {
        single_point(t);
        return;
    }
    if (walk_lane(t) || walk_whole(t) || walk(t, walk_d)) return;
    int fits = walk(t, walk_dd);
    t->zero_at_lo = end_is_root(t, t->lo);
    t->zero_at_hi = end_is_root(t, t->hi);
    if (t->zero_at_lo || t->zero_at_hi) fits = walk(t, walk_dd);
    if (!fits && !t->first_only) cover_rest(t);
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

/* Nothing can be said of a set of polynomials that holds the zero polynomial. */
static int may_vanish(const algsurf_i_coefficients *p) {
    for (int k = 0; p->r && k <= p->degree; k++)
        if (fabs(p->c[k]) > p->r[k]) return 0;
    return p->r != NULL;
}

static int exact_zero(const double *c, const double *r, int k) { return c[k] == 0 && (!r || r[k] == 0); }

static ALGSURF_NOINLINE algsurf_status check_and_isolate(task *t) {
    algsurf_status status = check(t->p.c, t->p.r, t->p.degree, t->lo, t->hi);
    if (status != ALGSURF_OK) return status;
    while (exact_zero(t->p.c, t->p.r, t->p.degree)) t->p.degree--;
    while (exact_zero(t->p.c, t->p.r, t->p.zeros)) t->p.zeros++;
    if (may_vanish(&t->p))
        all_undecided(t);
    else
        isolate(t);
    if (t->first_only && t->found.count > 1) t->found.count = 1;
    return ALGSURF_OK;
}

/* Runs the search into `room` for degree brackets, at least 1, or for 2 where one is wanted; the first
 * undecided reason is the status.  `intervals` may be null. */
static algsurf_status run(const double *c, const double *r, int degree, double lo, double hi, int first_only,
                          algsurf_bracket *room, int *count, int *intervals) {
    int capacity = first_only ? 2 : degree > 0 ? degree : 1;
    task t = {{c, r, degree, 0}, lo, hi, first_only, 0, 0, {room, 0, capacity, 0, 0}, 0, 0};
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = check_and_isolate(&t);
    algsurf_fpenv_leave(&saved);
    if (status != ALGSURF_OK) return status;
    *count = t.found.count;
    if (intervals) *intervals = t.counted;
    for (int i = 0; i < t.found.count; i++)
        if (room[i].status != ALGSURF_OK) return room[i].status;
    return ALGSURF_OK;
}

algsurf_status algsurf_isolate_first_counted(const double *c, const double *r, int degree, double lo,
                                             double hi, algsurf_bracket *bracket, int *found,
                                             int *intervals) {
    algsurf_bracket first[2];
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
