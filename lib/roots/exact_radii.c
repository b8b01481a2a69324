/* exact_radii.c - the real roots of a set of polynomials, from the roots of its envelopes.
 *
 * The set: all q with |q_k - p_k| <= radius_k.  At a point u their values are an interval, from the lower
 * envelope p(u) - radius(|u|) to the upper one, p(u) + radius(|u|).  So the points that are roots of members,
 * hidden ones, are those where the lower envelope is not positive and the upper one not negative.  On either
 * side of 0 both are polynomials; the exact walk finds their roots, which are the ends of the hidden ranges,
 * to neighbouring doubles.
 *
 * One root of each member.  Let a hidden range have known signs at both ends, different ones, and no member a
 * double root in it.  Then roots are simple, move continuously with the coefficients, and leave through no
 * end: all members have as many as p.
 *     Over all members, (q(u), u q'(u)) fills a polygon, a sum of segments with the directions (1,k).  At
 * u != 0 a member has a double root if and only if 0 is in it; if 0 is not, the line along one of its edges
 * separates them: for one of the numbers m = 0 .. n, u q' - m q has one sign for all members (for m = 0 these
 * are the derivatives, and at u = 0 they alone tell).  With the coefficients (k - m) q_k that is a set like
 * the first one.  In doubles, m and a bound from the middle of a range serve nearly always.  Where they do
 * not, the range is asked for the hidden points of that set, and these for another m.  Where one m serves
 * throughout, u^-m q is monotone.  So are its parts if several do, in one direction: where they meet, at a
 * double within the range, some member has a root, and its slope shows in both.  Hidden points left over in
 * between end at no such double, and p is asked for the number of its roots. */
#include "../base/arithmetic.h"
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "exact_walk.h"

enum { UNKNOWN = 2, MOST_ROUNDS = 8 };

typedef struct set {
    algsurf_memory *memory;
    algsurf_zpoly p, radius;
    int unit;
} set;

/* Hidden ranges from left to right.  closed: the last one's right end is a hidden point. */
typedef struct ranges {
    algsurf_exact_range *at;
    int count, closed;
} ranges;

static int degree_of(const set *s) { return s->p.degree > s->radius.degree ? s->p.degree : s->radius.degree; }

/* ---- envelopes ---- */

/* The one that holds for u >= 0 or for u <= 0. */
static int make_envelope(const set *s, int above, int upper, algsurf_zpoly *envelope) {
    const algsurf_zpoly *p = &s->p, *radius = &s->radius;
    int bits = algsurf_zpoly_bits(p), more = algsurf_zpoly_bits(radius);
    int w = algsurf_z_width((bits > more ? bits : more) + 2);
    int n = degree_of(s);
    if (!algsurf_zpoly_new(s->memory, n, w, envelope)) return 0;
    for (int k = 0; k <= n; k++) {
        algsurf_limb *c = algsurf_zpoly_at(envelope, k);
        if (k <= p->degree) algsurf_z_copy(c, w, algsurf_zpoly_at(p, k), p->width);
        if (k > radius->degree) continue;
        int minus = upper != (above || k % 2 == 0);
        algsurf_z_join_product(c, w, algsurf_zpoly_at(radius, k), radius->width, 1, 0, minus);
    }
    *envelope = algsurf_zpoly_trimmed(envelope);
    return 1;
}

/* The sign that all members have at t, or UNKNOWN. */
static int sign_at(const set *s, double t, int *sign) {
    algsurf_memory_mark mark = algsurf_memory_here(s->memory);
    algsurf_zpoly envelope;
    int at[2], done = 1;
    for (int i = 0; done && i < 2; i++)
        done = make_envelope(s, t >= 0, i, &envelope) &&
               algsurf_exact_at_double(s->memory, &envelope, s->unit, t, at + i, NULL, NULL);
    algsurf_memory_release(s->memory, mark);
    if (done) *sign = at[0] == at[1] ? at[0] : UNKNOWN;
    return done;
}

int algsurf_exact_radii_sign(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius, int unit,
                             double t, int *sign) {
    const set s = {m, *p, *radius, unit};
    return sign_at(&s, t, sign);
}

/* ---- hidden ranges ---- */

static int take_ranges(algsurf_memory *m, int room, algsurf_exact_range **at) {
    *at = algsurf_i_take(m, (size_t)(room > 0 ? room : 1) * sizeof **at);
    return *at != NULL;
}

/* The roots of f in [lo,hi], one end finite, at neighbouring doubles or at one, each with the sign of f
 * behind it; *sign is that before the first one. */
static int find_roots(const set *s, const algsurf_zpoly *f, double lo, double hi, ranges *roots, int *sign) {
    algsurf_exact_walk walk;
    algsurf_exact_root root;
    roots->count = 0;
    if (!take_ranges(s->memory, f->degree, &roots->at)) return 0;
    algsurf_memory_mark mark = algsurf_memory_here(s->memory);
    int found = ALGSURF_EXACT_END;
    if (f->degree > 0) {
        if (!algsurf_exact_begin(&walk, s->memory, f, s->unit, lo, hi, ALGSURF_EXACT_REFINED, NULL)) return 0;
        while ((found = algsurf_exact_next(&walk, &root)) == ALGSURF_EXACT_ROOT) {
            int after = root.multiplicity % 2 ? -root.sign_before : root.sign_before;
            if (roots->count == 0) *sign = root.sign_before;
            roots->at[roots->count++] = (algsurf_exact_range){root.lo + 0.0, root.hi + 0.0, after};
        }
    }
    algsurf_memory_release(s->memory, mark);
    if (roots->count == 0 &&
        !algsurf_exact_at_double(s->memory, f, s->unit, isfinite(lo) ? lo : hi, sign, NULL, NULL))
        return 0;
    return found == ALGSURF_EXACT_END;
}

/* Appends a range, closed if its ends are hidden points, else two neighbouring doubles: to the last one if
 * these points are hidden in both, or between them. */
static void append(ranges *found, double lo, double hi, int closed) {
    algsurf_exact_range *last = found->at + found->count - 1;
    if (found->count > 0 && (lo < last->hi || (lo == last->hi && (closed || found->closed))))
        last->hi = hi;
    else
        found->at[found->count++] = (algsurf_exact_range){lo, hi, 0};
    found->closed = closed;
}

/* Those in [lo,hi], on one side of 0. */
static int find_on_side(const set *s, int above, double lo, double hi, ranges *found) {
    algsurf_memory_mark mark = algsurf_memory_here(s->memory);
    algsurf_zpoly envelope;
    ranges root[2];
    int sign[2], next[2] = {0, 0}, done = 1;
    for (int i = 0; done && i < 2; i++)
        done = make_envelope(s, above, i, &envelope) && find_roots(s, &envelope, lo, hi, root + i, sign + i);
    while (done) {
        const algsurf_exact_range *r[2] = {root[0].at + next[0], root[1].at + next[1]};
        int left[2] = {next[0] < root[0].count, next[1] < root[1].count};
        int i = left[1] && (!left[0] || r[1]->lo < r[0]->lo || (r[1]->lo == r[0]->lo && r[1]->hi < r[0]->hi));
        double to = left[i] ? r[i]->lo : hi;
        if (sign[0] * sign[1] <= 0 && lo <= to) append(found, lo, to, 1);
        if (!left[i]) break;
        append(found, r[i]->lo, r[i]->hi, r[i]->lo == r[i]->hi);
        lo = r[i]->hi;
        sign[i] = r[i]->sign_lo;
        next[i]++;
    }
    algsurf_memory_release(s->memory, mark);
    return done;
}

/* Those in [lo,hi], in room of their own. */
static int find_hidden(const set *s, double lo, double hi, ranges *found) {
    *found = (ranges){0};
    return take_ranges(s->memory, 4 * degree_of(s) + 4, &found->at) &&
           (lo >= 0 || find_on_side(s, 0, lo, fmin(hi, 0), found)) &&
           (hi < 0 || find_on_side(s, 1, fmax(lo, 0), hi, found));
}

/* ---- double roots ---- */

/* f with its coefficients times k - m, or |k - m|. */
static int times_index(algsurf_memory *memory, const algsurf_zpoly *f, int m, int absolute,
                       algsurf_zpoly *g) {
    int w = algsurf_z_width(algsurf_zpoly_bits(f) + 11);
    if (!algsurf_zpoly_new(memory, f->degree, w, g)) return 0;
    for (int k = 0; k <= f->degree; k++) {
        algsurf_limb factor = (algsurf_limb)abs(k - m);
        algsurf_z_join_product(algsurf_zpoly_at(g, k), w, algsurf_zpoly_at(f, k), f->width, factor, 0,
                               k < m && !absolute);
    }
    return 1;
}

/* Of the doubles in [lo,hi] on one side of 0 the middle one. */
static double middle_of(double lo, double hi) {
    if (lo <= 0 && hi >= 0) return lo + 0.5 * (hi - lo);
    double middle = algsurf_i_between(lo, hi);
    return isinf(middle) ? lo : middle;
}

/* The least exponent above those of all |f_k| T^k, T below 2^exponent, and `top`. */
static int top_of(const algsurf_zpoly *f, int exponent, int top) {
    for (int k = 0; k <= f->degree; k++) {
        int e = algsurf_z_bits(algsurf_zpoly_at(f, k), f->width) + 1 + k * exponent;
        top = e > top ? e : top;
    }
    return top;
}

/* |f_k| T^k in units of 2^top, T = mantissa 2^exponent. */
static void set_terms(const algsurf_zpoly *f, int n, double mantissa, int exponent, int top, double *term) {
    double power = 1;
    for (int k = 0, e = 0; k <= n; k++, power *= mantissa) {
        double c = k > f->degree ? 0 : algsurf_z_to_double(algsurf_zpoly_at(f, k), f->width, &e);
        term[k] = ldexp(fabs(c) * power, e + k * exponent - top);
    }
}

/* The best m at the middle c of [lo,hi], -1 for none, and whether it serves for all of [lo,hi], as doubles
 * show.  There f = u p' - m p is f(c) + (t - c) f'(c) within (hi - lo)^2 times the largest |f''|; so with
 * T = max(|lo|, |hi|) and w = (hi - lo) / T the members' u q' - m q differ from f(c) by
 * w |T f'(c)| + sum |k - m| (radius_k + k^2 w^2 |p_k|) T^k at most.  m = 0 and T q' instead of u q' serve
 * about 0, too.  *m is given where doubles do not tell it.  All terms are in units of 2^top, with relative
 * errors below 2^-42; 2^-1000 covers underflow.  Where no m is found nothing is proved, nor need be. */
static int find_separating(const set *s, const algsurf_zpoly *slope, double lo, double hi, int *m,
                           int *clear) {
    algsurf_memory_mark mark = algsurf_memory_here(s->memory);
    double v[3], far = 1, sum = 0, total = 0, below = 0, best = 0;
    double T = fmax(fabs(lo), fabs(hi)), c = middle_of(lo, hi), x = c / T, w = (hi - lo) / T;
    int n = degree_of(s), about_zero = lo <= 0 && hi >= 0, exponent, e, sign;
    *clear = 0;
    if (about_zero) *m = 0;
    if (isinf(T)) return 1;
    double mantissa = frexp(T, &exponent), power = 1;
    double *radius = algsurf_i_take(s->memory, 3 * (size_t)(n + 1) * sizeof *radius);
    if (!radius) return 0;
    double *size = radius + n + 1, *at = size + n + 1;
    exponent -= s->unit;
    int top = top_of(&s->radius, exponent, top_of(&s->p, exponent, INT_MIN));
    for (int i = 0; i < 3; i++, power *= mantissa) { /* p, T p', T^2 p'' */
        const algsurf_zpoly *f = i == 0 ? &s->p : slope + i - 1;
        if (!algsurf_exact_at_double(s->memory, f, s->unit, c, &sign, v + i, &e)) return 0;
        v[i] = ldexp(v[i] * power, e + i * exponent - top);
    }
    set_terms(&s->radius, n, mantissa, exponent, top, radius);
    set_terms(&s->p, n, mantissa, exponent, top, size);
    for (int k = 0; k <= n; k++, far *= fabs(x)) {
        at[k] = radius[k] * far;
        total += at[k];
        sum += k * at[k];
    }
    for (int i = 0; i <= n && !about_zero; i++) { /* sum: |k - i| at_k */
        double margin = fabs(x * v[1] - i * v[0]) - sum;
        *m = margin > best ? i : i == 0 ? -1 : *m;
        best = fmax(best, margin);
        below += at[i];
        sum += 2 * below - total;
    }
    x = *m == 0 ? 1 : x;
    double tilt = *m == 0 ? v[2] : x * v[2] + (1 - *m) * v[1];
    sum = 0x1p-1000 + w * fabs(tilt);
    for (int k = 0; k <= n; k++) sum += abs(k - *m) * (radius[k] + k * w * (k * w) * size[k]);
    sum += 0x1p-48 * (fabs(v[1]) + *m * fabs(v[0]) + w * (fabs(v[2]) + *m * fabs(v[1])));
    *clear = *m >= 0 && fabs(x * v[1] - *m * v[0]) > sum * (1 + 0x1p-40);
    algsurf_memory_release(s->memory, mark);
    return 1;
}

/* May a member have a double root in [lo,hi]?  *may is set, or it is not; *parts: several m were needed. */
static int ask_for_double(const set *s, const algsurf_zpoly *slope, double lo, double hi, int rounds,
                          int *parts, int *may) {
    algsurf_memory_mark mark = algsurf_memory_here(s->memory);
    set scaled = *s;
    ranges left;
    int m = MOST_ROUNDS - rounds, clear, done = find_separating(s, slope, lo, hi, &m, &clear);
    if (!done || clear) return done;
    if (m < 0 || rounds == 0) return *may = 1;
    if (m == 0)
        done = algsurf_zpoly_derivative(s->memory, &s->radius, &scaled.radius);
    else
        done = times_index(s->memory, &s->p, m, 0, &scaled.p) &&
               times_index(s->memory, &s->radius, m, 1, &scaled.radius);
    if (m == 0) scaled.p = *slope;
    done = done && find_hidden(&scaled, lo, hi, &left);
    for (int i = 0; done && !*may && i < left.count; i++) {
        *parts = 1;
        *may = left.at[i].lo <= 0 && left.at[i].hi >= 0;
        if (!*may) done = ask_for_double(s, slope, left.at[i].lo, left.at[i].hi, rounds - 1, parts, may);
    }
    algsurf_memory_release(s->memory, mark);
    return done;
}

/* Does each member have exactly one root in [lo,hi], with different signs at the ends? */
static int ask_for_one(const set *s, const algsurf_zpoly *slope, double lo, double hi, int *one) {
    algsurf_memory_mark mark = algsurf_memory_here(s->memory);
    int may = 0, parts = 0, sign, done = ask_for_double(s, slope, lo, hi, MOST_ROUNDS, &parts, &may);
    ranges roots;
    *one = !may;
    if (done && parts && !may) {
        done = find_roots(s, &s->p, lo, hi, &roots, &sign);
        *one = done && roots.count == 1;
    }
    algsurf_memory_release(s->memory, mark);
    return done;
}

/* ---- ranges with one root ---- */

/* Moves the end t of a range outwards to a double with a known sign, if it is the next one. */
static int find_known_sign(const set *s, double outwards, double *t, int *sign) {
    if (!sign_at(s, *t, sign)) return 0;
    if (*sign * *sign == 1 || isinf(*t)) return 1;
    *t = nextafter(*t, outwards);
    return sign_at(s, *t, sign);
}

/* The range i of those found in [least,most], if it is shown that each polynomial has one root in it. */
static int decide_range(const set *s, const algsurf_zpoly *slope, const ranges *found, int i, double least,
                        double most) {
    algsurf_exact_range *range = found->at + i;
    double lo = range->lo, hi = range->hi;
    int at_lo, at_hi, one;
    if (!sign_at(s, lo, &at_lo)) return 0;
    if (lo == 0 && hi == 0 && at_lo == 0) return 1; /* this is the root, of all polynomials */
    if (!find_known_sign(s, -DBL_MAX, &lo, &at_lo) || !find_known_sign(s, DBL_MAX, &hi, &at_hi)) return 0;
    if (at_lo * at_hi != -1 || lo < (i > 0 ? range[-1].hi : least) ||
        hi > (i + 1 < found->count ? range[1].lo : most) || (isinf(hi) && lo < DBL_MAX) ||
        (isinf(lo) && hi > -DBL_MAX))
        return 1;
    if (!ask_for_one(s, slope, lo, hi, &one)) return 0;
    if (one) *range = (algsurf_exact_range){lo, hi, at_lo};
    return 1;
}

static int decide_ranges(const set *s, const ranges *found, double lo, double hi) {
    algsurf_zpoly slope[2]; /* and its own */
    int done = algsurf_zpoly_derivative(s->memory, &s->p, slope) &&
               algsurf_zpoly_derivative(s->memory, slope, slope + 1);
    for (int i = 0; done && i < found->count; i++) done = decide_range(s, slope, found, i, lo, hi);
    return done;
}

/* Undecided ranges that touch become one, and what there is no room for. */
static void give(const ranges *all, algsurf_exact_range *found, int capacity, int *count) {
    *count = 0;
    for (int i = 0; i < all->count; i++) {
        const algsurf_exact_range *r = all->at + i;
        algsurf_exact_range *last = found + *count - 1;
        if (*count == capacity || (*count > 0 && !r->sign_lo && !last->sign_lo && r->lo == last->hi))
            *last = (algsurf_exact_range){last->lo, r->hi, 0};
        else
            found[(*count)++] = *r;
    }
}

/* A cell for each range, or an empty one. */
static void tell(const algsurf_i_watch *watch, int degree, double lo, double hi,
                 const algsurf_exact_range *found, int count) {
    algsurf_cell cell = {lo, hi, 0, ALGSURF_ENGINE_INTEGERS, degree, NULL};
    if (count == 0) algsurf_i_tell_cell(watch, &cell);
    for (int i = 0; i < count; i++) {
        cell.lo = found[i].lo, cell.hi = found[i].hi, cell.variations = found[i].sign_lo ? 1 : degree;
        algsurf_i_tell_cell(watch, &cell);
    }
}

int algsurf_exact_radii_isolate(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius,
                                int unit, double lo, double hi, algsurf_exact_range *found, int capacity,
                                int *count, const algsurf_i_watch *watch) {
    algsurf_memory_mark mark = algsurf_memory_here(m);
    const set s = {m, *p, *radius, unit};
    ranges all;
    *count = 0;
    int done = find_hidden(&s, lo + 0.0, hi + 0.0, &all) && decide_ranges(&s, &all, lo + 0.0, hi + 0.0);
    if (done) give(&all, found, capacity, count);
    algsurf_memory_release(m, mark);
    if (done && watch) tell(watch, degree_of(&s), lo, hi, found, *count);
    return done;
}
