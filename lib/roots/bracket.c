/* bracket.c - from a cell of a stretch to a bracket whose ends are doubles.
 *
 * A cell's ends are exact points of its piece, not doubles of the caller's variable.  They are rounded
 * outward, and the signs at the rounded ends computed anew, with certainty: so what a bracket says can
 * be checked by anyone who evaluates the polynomial. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "algsurf/poly.h"
#include "isolate_impl.h"
#include "../poly/exact.h"

int algsurf_i_sign_at(const algsurf_i_coefficients *p, double x) {
    double value, bound, lead = p->c[p->degree], c[ALGSURF_MAX_POLY_DEGREE + 1],
                         r[ALGSURF_MAX_POLY_DEGREE + 1];
    if (isinf(x)) {
        if (p->r && fabs(lead) <= p->r[p->degree]) return ALGSURF_SIGN_UNKNOWN;
        return (lead > 0) == (x > 0 || p->degree % 2 == 0) ? 1 : -1;
    }
    if (x == 0 && (!p->r || p->r[0] == 0 || fabs(p->c[0]) > p->r[0])) return (p->c[0] > 0) - (p->c[0] < 0);
    /* In the unit of x, so that nothing overflows; what the scaling may lose goes into the radii. */
    int unit = x == 0 ? 0 : ilogb(x), common = algsurf_i_common_exponent(p, 0, unit);
    for (int k = 0; k <= p->degree; k++) {
        int shift = k * unit - common;
        c[k] = ldexp(p->c[k], shift);
        r[k] = (p->r ? ldexp(p->r[k], shift) : 0) + (fabs(c[k]) < 0x1p-1000 && p->c[k] != 0 ? 0x1p-1073 : 0);
    }
    algsurf_status status = algsurf_poly_eval_compensated(c, r, p->degree, ldexp(x, -unit), &value, &bound);
    if (status == ALGSURF_OK && fabs(value) > bound) return value > 0 ? 1 : -1;
    return p->r ? ALGSURF_SIGN_UNKNOWN : algsurf_i_poly_exact_sign(p->c, p->degree, x);
}

/* Is an end of a cell that of its stretch, and not one where pieces meet or a piece was split? */
static int is_outermost(const algsurf_i_stretch *s, const algsurf_i_cell *cell, int side) {
    double from = -ALGSURF_CUT, to = ALGSURF_CUT; /* where the piece lies, in units of the stretch */
    if (cell->piece->far && cell->hi.hi > 0)
        to = from, from = -HUGE_VAL;
    else if (cell->piece->far)
        from = to, to = HUGE_VAL;
    return side < 0 ? cell->at_lo && ldexp(s->lo, -s->exponent) >= from
                    : cell->at_hi && ldexp(s->hi, -s->exponent) <= to;
}

/* End of a cell as a double within the stretch, exact where it is that of the stretch.  Elsewhere it is the
 * rounded value, off by less than 1 unit in the last place in a near piece, 2 in a far one, moved outward by
 * `steps` doubles, after more than the error of v. */
static double end_of(const algsurf_i_stretch *s, const algsurf_i_cell *cell, int side, int steps) {
    const algsurf_i_piece *piece = cell->piece;
    int outward = steps > 0 ? side : -side;
    if (is_outermost(s, cell, side)) return side < 0 ? s->lo : s->hi;
    double size = fmax(fabs(piece->lo.hi), fabs(piece->hi.hi));
    double v = (side < 0 ? cell->lo : cell->hi).hi + outward * (0x1p-100 * size + 0x1p-1072);
    double x = ldexp(piece->far ? -1 / v : v, s->exponent);
    for (int i = 0; i < abs(steps); i++) x = nextafter(x, outward * HUGE_VAL);
    return fmin(fmax(x, s->lo), s->hi) + 0.0; /* no -0 */
}

/* -1, 1: all of a cell lies beyond the largest double, on the negative or the positive side. */
static int beyond_range(const algsurf_i_stretch *s, const algsurf_i_cell *cell) {
    return end_of(s, cell, 1, 0) == -HUGE_VAL ? -1 : end_of(s, cell, -1, 0) == HUGE_VAL;
}

/* A double next to the right end of a cell, not beyond it. */
static double right_inside(const algsurf_i_stretch *s, const algsurf_i_cell *cell) {
    return end_of(s, cell, 1, cell->piece->far ? -2 : -1);
}

static int append(algsurf_i_brackets *found, algsurf_bracket b) {
    if (found->count == found->capacity) return 0;
    found->b[found->count++] = b;
    found->loose = 0;
    return 1;
}

static void add_to_most(algsurf_bracket *b, int most, const algsurf_i_coefficients *p) {
    b->most = b->most + most < p->degree ? b->most + most : p->degree;
}

int algsurf_i_add_exact(algsurf_i_brackets *found, const algsurf_i_coefficients *p, double x, int most) {
    algsurf_bracket *last = found->count > 0 ? found->b + found->count - 1 : NULL;
    if (last && last->kind == ALGSURF_ROOT_UNDECIDED && last->hi == x) add_to_most(last, most, p);
    return append(found, (algsurf_bracket){x, x, ALGSURF_ROOT_EXACT, 0, most, ALGSURF_OK});
}

/* The last entry, loose, may hold roots right of x, where those of b are: if so, b takes it in. */
static void take_in_loose(algsurf_i_brackets *found, const algsurf_i_coefficients *p, double x,
                          algsurf_bracket *b) {
    const algsurf_bracket *last = found->b + found->count - 1;
    found->loose = 0;
    if (last->hi <= x) return;
    b->lo = found->above;
    add_to_most(b, last->most, p);
    found->count--;
}

/* Appends an undecided entry for the roots of a cell, all in [b.lo,b.hi]; those of the cell before it are in
 * the last entry. */
static int add_undecided(algsurf_i_brackets *found, const algsurf_i_coefficients *p,
                         const algsurf_i_stretch *s, const algsurf_i_cell *cell, algsurf_bracket b) {
    if (found->loose) take_in_loose(found, p, end_of(s, cell, -1, 2), &b);
    algsurf_bracket *last = found->count > 0 ? found->b + found->count - 1 : NULL;
    if (last && last->hi >= b.lo) {
        if (last->kind == ALGSURF_ROOT_UNDECIDED) {
            last->hi = fmax(last->hi, b.hi);
            add_to_most(last, b.most, p);
            return 1;
        }
        b.lo = last->hi;
        if (last->kind == ALGSURF_ROOT_EXACT) add_to_most(&b, last->most, p);
    }
    return append(found, b);
}

static int add_open_cell(algsurf_i_brackets *found, const algsurf_i_coefficients *p,
                         const algsurf_i_stretch *s, const algsurf_i_cell *cell) {
    algsurf_bracket b = {
        end_of(s, cell, -1, 2),    end_of(s, cell, 1, 2), ALGSURF_ROOT_UNDECIDED, 0, cell->most,
        ALGSURF_UNDECIDED_MULTIPLE};
    if (cell->at_lo || cell->at_hi) b.status = ALGSURF_UNDECIDED_END;
    if (cell->at_lo && cell->at_hi) b.status = ALGSURF_UNDECIDED_ZERO;
    return add_undecided(found, p, s, cell, b);
}

/* In place of an infinite end of a cell with one root: the first power of two beyond the other end where the
 * sign is that of infinity, or else the largest double. */
static double draw_in(const algsurf_i_coefficients *p, double end, double other) {
    double side = end > 0 ? 1 : -1;
    int at_infinity = algsurf_i_sign_at(p, end);
    if (isinf(other)) return side * DBL_MAX;
    for (int e = side * other > 0 ? ilogb(other) + 1 : -1074; e < 1024; e++)
        if (algsurf_i_sign_at(p, ldexp(side, e)) == at_infinity) return ldexp(side, e);
    return side * DBL_MAX;
}

/* Moves *x a few doubles towards `inner` until the sign there is certain, and returns it (or UNKNOWN).
 * `taken`: where *x is a root now, it is another one than that looked for. */
static int move_in(const algsurf_i_coefficients *p, double *x, double inner, int taken) {
    for (int i = 0; i < 5; i++) {
        int sign = algsurf_i_sign_at(p, *x);
        if (sign == 1 || sign == -1 || (sign == 0 && !taken)) return sign;
        if (*x == inner || nextafter(*x, inner) == inner) break;
        *x = nextafter(*x, inner);
        taken = 0;
    }
    return ALGSURF_SIGN_UNKNOWN;
}

/* The sign of p left of the root in a cell.  The local polynomial is p / x^zeros, over x^(degree - zeros) in
 * a far piece. */
static int sign_before(const algsurf_i_coefficients *p, const algsurf_i_stretch *s,
                       const algsurf_i_cell *cell) {
    int negative = cell->piece->far ? cell->hi.hi > 0 : s->hi <= 0;
    int power = cell->piece->far ? p->degree : p->zeros;
    return negative && power % 2 ? -cell->sign : cell->sign;
}

/* The root lies right of lo, next to the end of its cell: an end for its bracket beyond that, up to `outer`.
 * What comes next shows whether another root is in it. */
static int add_loose(algsurf_i_brackets *found, const algsurf_i_coefficients *p, const algsurf_i_stretch *s,
                     int before, double lo, double outer) {
    const double above = lo;
    for (double x = nextafter(lo, HUGE_VAL); x <= outer && !isinf(x); x = nextafter(x, HUGE_VAL)) {
        int sign = algsurf_i_sign_at(p, x);
        if (sign == before) lo = x;
        if (sign == ALGSURF_SIGN_UNKNOWN || sign == before || (sign == 0 && x == s->hi)) continue;
        int added =
            sign == 0 ? algsurf_i_add_exact(found, p, x, p->degree)
                      : append(found, (algsurf_bracket){lo, x, ALGSURF_ROOT_BRACKET, before, 1, ALGSURF_OK});
        found->loose = added;
        found->above = above;
        return added ? 1 : -1;
    }
    return 0;
}

/* Are the ends of a cell doubles of the caller's variable, and in the stretch?  Then the walk knows the signs
 * there, but at 0 where p has a root that the local polynomial has not. */
static int ends_are_doubles(const algsurf_i_coefficients *p, const algsurf_i_stretch *s,
                            const algsurf_i_cell *cell, double *lo, double *hi) {
    *lo = ldexp(cell->lo.hi, s->exponent) + 0.0; /* no -0 */
    *hi = ldexp(cell->hi.hi, s->exponent) + 0.0;
    return cell->exact && *lo >= s->lo && *hi <= s->hi && isfinite(*lo) && isfinite(*hi) &&
           ldexp(*lo, -s->exponent) == cell->lo.hi && ldexp(*hi, -s->exponent) == cell->hi.hi &&
           (p->zeros == 0 || (*lo != 0 && *hi != 0));
}

/* A cell with one root, from the sign b before it to the sign -b behind: lo and hi are doubles where the sign
 * is b and -b.  No root lies between the entry before and the cell; hence -b at x, right of that entry, says
 * that the root is left of x, wherever the cell ends, and b at x, left of the cell's end, that it is right of
 * x. */
static int add_bracket(algsurf_i_brackets *found, const algsurf_i_coefficients *p, const algsurf_i_stretch *s,
                       const algsurf_i_cell *cell) {
    double last = found->count > 0 ? found->b[found->count - 1].hi : -HUGE_VAL;
    double lo, hi, inside = right_inside(s, cell);
    int before = sign_before(p, s, cell), added = 0;
    if (ends_are_doubles(p, s, cell, &lo, &hi) && lo >= last)
        return append(found, (algsurf_bracket){lo, hi, ALGSURF_ROOT_BRACKET, before, 1, ALGSURF_OK});
    lo = fmax(end_of(s, cell, -1, 2), last);
    hi = fmax(inside, lo);
    algsurf_bracket open = {lo, end_of(s, cell, 1, 2),     ALGSURF_ROOT_UNDECIDED, 0,
                            1,  ALGSURF_UNDECIDED_MULTIPLE};
    int beyond = beyond_range(s, cell);
    if (beyond) {
        open.lo = beyond < 0 ? -HUGE_VAL : DBL_MAX;
        open.hi = beyond < 0 ? -DBL_MAX : HUGE_VAL;
        open.status = ALGSURF_UNDECIDED_RANGE;
    }
    if (beyond || (lo == last && last > inside)) return add_undecided(found, p, s, cell, open);
    if (isinf(lo)) lo = draw_in(p, lo, hi);
    if (isinf(hi)) hi = draw_in(p, hi, lo);
    int at_lo = move_in(p, &lo, hi, 1), at_hi = move_in(p, &hi, lo, hi == s->hi || hi == lo);
    if (at_lo == 0 || at_hi == 0) return algsurf_i_add_exact(found, p, at_lo == 0 ? lo : hi, p->degree);
    if (at_lo == before && at_hi == -before)
        return append(found, (algsurf_bracket){lo, hi, ALGSURF_ROOT_BRACKET, before, 1, ALGSURF_OK});
    if (at_hi == before) added = add_loose(found, p, s, before, hi, open.hi);
    if (added != 0) return added > 0;
    if (at_hi == before || at_lo == before) open.lo = at_hi == before ? hi : lo;
    if (at_lo == -before || at_hi == -before) open.hi = at_lo == -before ? lo : hi;
    if (isinf(open.lo) || isinf(open.hi) || fmax(-open.lo, open.hi) < DBL_MIN)
        open.status = ALGSURF_UNDECIDED_RANGE;
    return add_undecided(found, p, s, cell, open);
}

int algsurf_i_add_cell(algsurf_i_brackets *found, const algsurf_i_coefficients *p, const algsurf_i_stretch *s,
                       const algsurf_i_cell *cell) {
    if (cell->kind == ALGSURF_ROOT_EXACT)
        return algsurf_i_add_exact(found, p, cell->at_lo ? s->lo : s->hi, p->degree);
    return cell->kind == ALGSURF_ROOT_BRACKET ? add_bracket(found, p, s, cell)
                                              : add_open_cell(found, p, s, cell);
}
