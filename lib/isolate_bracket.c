/* isolate_bracket.c - from a cell of a stretch to a bracket whose ends are doubles.
 *
 * A cell's ends are exact points of its piece, not doubles of the caller's variable.  They are rounded
 * outward, and the signs at the rounded ends computed anew, with certainty: so what a bracket says can
 * be checked by anyone who evaluates the polynomial. */
#include <math.h>
#include <stdlib.h>

#include "algsurf/poly.h"
#include "isolate_impl.h"
#include "poly_exact.h"

int algsurf_i_sign_at(const algsurf_i_coefficients *p, double x) {
    double value, bound, lead = p->c[p->degree], c[ALGSURF_MAX_POLY_DEGREE + 1],
                         r[ALGSURF_MAX_POLY_DEGREE + 1];
    if (isinf(x)) {
        if (p->r && fabs(lead) <= p->r[p->degree]) return ALGSURF_SIGN_UNKNOWN;
        return (lead > 0) == (x > 0 || p->degree % 2 == 0) ? 1 : -1;
    }
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

/* End of a cell as a double, `steps` units in the last place outward of its rounded value, within the
 * stretch. */
static double end_of(const algsurf_i_stretch *s, const algsurf_i_cell *cell, int side, int steps) {
    double v = (side < 0 ? cell->lo : cell->hi).hi, outside = side < 0 ? -HUGE_VAL : HUGE_VAL;
    if (cell->piece->far && v == 0) return side < 0 ? s->lo : s->hi;
    double x = ldexp(cell->piece->far ? -1 / v : v, s->exponent);
    for (int i = 0; i < abs(steps); i++) x = nextafter(x, steps > 0 ? outside : -outside);
    return fmin(fmax(x, s->lo), s->hi);
}

static int append(algsurf_i_brackets *found, algsurf_bracket b) {
    if (found->count == found->capacity) return 0;
    found->b[found->count++] = b;
    return 1;
}

int algsurf_i_add_exact(algsurf_i_brackets *found, double x, int most) {
    algsurf_bracket *last = found->count > 0 ? found->b + found->count - 1 : NULL;
    if (last && last->hi >= x && last->lo < x) last->hi = nextafter(x, -HUGE_VAL); /* entries are disjoint */
    return append(found, (algsurf_bracket){x, x, ALGSURF_ROOT_EXACT, 0, most, ALGSURF_OK});
}

static int add_undecided(algsurf_i_brackets *found, const algsurf_i_coefficients *p,
                         const algsurf_i_stretch *s, const algsurf_i_cell *cell) {
    algsurf_bracket b = {
        end_of(s, cell, -1, 2),    end_of(s, cell, 1, 2), ALGSURF_ROOT_UNDECIDED, 0, cell->most,
        ALGSURF_UNDECIDED_MULTIPLE};
    algsurf_bracket *last = found->count > 0 ? found->b + found->count - 1 : NULL;
    if (cell->at_lo || cell->at_hi) b.status = ALGSURF_UNDECIDED_END;
    if (cell->at_lo && cell->at_hi) b.status = ALGSURF_UNDECIDED_ZERO;
    if (last && last->hi >= b.lo) {
        if (last->kind == ALGSURF_ROOT_UNDECIDED) {
            last->hi = b.hi;
            last->most = last->most + b.most < p->degree ? last->most + b.most : p->degree;
            return 1;
        }
        b.lo = nextafter(last->hi, HUGE_VAL);
        if (b.lo > b.hi) b.hi = b.lo;
    }
    return append(found, b);
}

/* An infinite end of a cell with one root is drawn in: to the first power of two beyond the other end where
 * the sign is that of infinity.  Returns 0 when there is no such double. */
static int draw_in(const algsurf_i_coefficients *p, double *end, double other) {
    double side = *end > 0 ? 1 : -1;
    int at_infinity = algsurf_i_sign_at(p, *end);
    if (isinf(other)) return 0;
    for (int e = side * other > 0 ? ilogb(other) + 1 : -1074; e < 1024; e++)
        if (algsurf_i_sign_at(p, ldexp(side, e)) == at_infinity) {
            *end = ldexp(side, e);
            return 1;
        }
    return 0;
}

/* The root in (lo,hi) when one end is itself another root, exactly: halving until that end is off.
 * `known` is the sign at the other end.  Bounded by the number of doubles' bits. */
static int leave_zero(const algsurf_i_coefficients *p, double *lo, double *hi, int zero_lo, int known) {
    for (int i = 0; i < 2200; i++) {
        double middle = 0.5 * *lo + 0.5 * *hi;
        int sign = middle > *lo && middle < *hi ? algsurf_i_sign_at(p, middle) : ALGSURF_SIGN_UNKNOWN;
        if (sign == ALGSURF_SIGN_UNKNOWN) return 0;
        if (sign == 0) {
            *lo = *hi = middle;
            return 1;
        }
        double *other = zero_lo ? hi : lo, *zero = zero_lo ? lo : hi;
        if (sign == known) {
            *other = middle;
        } else {
            *zero = middle;
            return 1;
        }
    }
    return 0;
}

/* A double between lo and hi that is the root exactly, when they are a few units apart. */
static int exact_between(const algsurf_i_coefficients *p, double lo, double hi, double *root) {
    for (int i = 0; i < 8 && lo <= hi; i++, lo = nextafter(lo, HUGE_VAL))
        if (algsurf_i_sign_at(p, lo) == 0) {
            *root = lo;
            return 1;
        }
    return 0;
}

int algsurf_i_add_cell(algsurf_i_brackets *found, const algsurf_i_coefficients *p, const algsurf_i_stretch *s,
                       const algsurf_i_cell *cell) {
    double before = found->count > 0 ? found->b[found->count - 1].hi : -HUGE_VAL, root;
    if (cell->kind == ALGSURF_ROOT_EXACT)
        return algsurf_i_add_exact(found, cell->at_lo ? s->lo : s->hi, p->degree);
    if (cell->kind == ALGSURF_ROOT_UNDECIDED) return add_undecided(found, p, s, cell);
    for (int steps = 2; steps >= -1; steps--) {
        double lo = fmax(end_of(s, cell, -1, steps), before), hi = end_of(s, cell, 1, steps);
        if ((isinf(lo) && !draw_in(p, &lo, hi)) || (isinf(hi) && !draw_in(p, &hi, lo))) break;
        int at_lo = algsurf_i_sign_at(p, lo), at_hi = algsurf_i_sign_at(p, hi);
        if (at_lo == 0 && (at_hi == 1 || at_hi == -1) && leave_zero(p, &lo, &hi, 1, at_hi))
            at_lo = lo < hi ? -at_hi : 0;
        else if (at_hi == 0 && (at_lo == 1 || at_lo == -1) && leave_zero(p, &lo, &hi, 0, at_lo))
            at_hi = lo < hi ? -at_lo : 0;
        if (lo == hi) return algsurf_i_add_exact(found, lo, p->degree);
        if (at_lo * at_hi == -1)
            return append(found, (algsurf_bracket){lo, hi, ALGSURF_ROOT_BRACKET, at_lo, 1, ALGSURF_OK});
    }
    if (exact_between(p, fmax(end_of(s, cell, -1, 2), before), end_of(s, cell, 1, 2), &root))
        return algsurf_i_add_exact(found, root, p->degree);
    return add_undecided(found, p, s, cell);
}
