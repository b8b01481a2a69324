/* exact_refine.c - from a cell with one root to its place, and to the doubles next to it.
 *
 * The place is the cell, without an end that is a root of its own.  Refined, it shrinks to two doubles next
 * to each other (or to one that is the root): values of f at doubles are exact in sign and close in size, so
 * that Newton's step in double and secants come within an ulp in some four evaluations; a step is made a
 * little longer than computed, over the root, to close the bracket; and where steps do not halve the bracket,
 * counted in doubles, it is bisected. */
#include "../base/arithmetic.h"
#include <float.h>
#include <math.h>
#include <string.h>

#include "exact_walk.h"

int algsurf_exact_at_double(algsurf_memory *m, const algsurf_zpoly *f, int unit, double t, int *sign,
                            double *value, int *exponent) {
    int e, n = f->degree;
    if (isinf(t)) {
        *sign = n < 0 ? 0 : algsurf_z_sign(algsurf_zpoly_at(f, n), f->width);
        if (t < 0 && n % 2) *sign = -*sign;
        return 1;
    }
    algsurf_limb odd = algsurf_z_odd_part(t, &e), N = t < 0 ? 0 - odd : odd;
    return algsurf_zpoly_sign_at(m, f, &N, 1, odd ? unit - e : 0, sign, value, exponent);
}

static uint64_t doubles_between(double lo, double hi) {
    return (uint64_t)algsurf_i_number_of(hi) - (uint64_t)algsurf_i_number_of(lo);
}
static double next_up(double x) { return nextafter(x, HUGE_VAL); }
static double next_down(double x) { return nextafter(x, -HUGE_VAL); }

/* f at a double, as sign and size. */
typedef struct sample {
    double t, value;
    int exponent, sign;
} sample;

static int sample_at(algsurf_exact_walk *walk, const algsurf_zpoly *f, double t, sample *s) {
    s->t = t;
    if (!algsurf_exact_at_double(walk->memory, f, walk->unit, t, &s->sign, &s->value, &s->exponent)) return 0;
    if (walk->cells.watch)
        algsurf_i_tell_point(walk->cells.watch, t, s->value, s->exponent, ALGSURF_ENGINE_INTEGERS);
    return 1;
}

/* Value a over value b. */
static double ratio(const sample *a, const sample *b) {
    int e = a->exponent - b->exponent;
    return b->value == 0 ? 0 : ldexp(a->value / b->value, e < -3000 ? -3000 : e > 3000 ? 3000 : e);
}

/* Newton's method on the cell's coefficients in double: where in [0,1] the root is. */
static double place_in_cell(const algsurf_exact_cell *cell, int before) {
    double b[ALGSURF_MAX_POLY_DEGREE + 1], t[ALGSURF_MAX_POLY_DEGREE + 1], lo = 0, hi = 1;
    int n = cell->b.degree;
    algsurf_exact_cell_doubles(cell, b);
    double x = b[0] == b[n] ? 0.5 : b[0] / (b[0] - b[n]);
    for (int round = 0; round < 12; round++) {
        memcpy(t, b, sizeof *t * (size_t)(n + 1));
        for (int i = n; i > 1; i--)
            for (int j = 0; j < i; j++) t[j] += x * (t[j + 1] - t[j]);
        double value = t[0] + x * (t[1] - t[0]), next = x - value / (n * (t[1] - t[0]));
        if (before > 0 ? value > 0 : value < 0)
            lo = x;
        else
            hi = x;
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        double step = fabs(next - x);
        x = next;
        if (step < 0x1p-40) break;
    }
    return x;
}

/* The root as a double, roughly; NaN or out of range where the cell is. */
static double first_guess(const algsurf_exact_walk *walk) {
    const algsurf_exact_cell *cell = &walk->cells.cell;
    int e;
    double position = algsurf_z_to_double(cell->position, cell->position_width, &e);
    double begin = ldexp(position, e - cell->depth - cell->fine);
    double x = begin + ldexp(place_in_cell(cell, walk->before), -cell->depth);
    const algsurf_exact_piece *piece = &walk->cells.piece;
    return ldexp((double)piece->at + ldexp(x, piece->length), piece->unit);
}

/* A step of the secant through the last point and another one, and over the root. */
static double next_point(const sample *last, const sample *other, int before, int round) {
    double step = -(last->t - other->t) / (1 - ratio(other, last));
    double ulp = next_up(fabs(last->t)) - fabs(last->t), z = last->t + step;
    if (fabs(step) < 64 * ulp || round > 2) {
        double over = fmax(ulp, fabs(step) * 0x1p-6) * (fabs(step) < 0.25 * ulp ? 1 : 0.75);
        z += last->sign == before ? over : -over;
    }
    return z;
}

/* Shrinks [lo, hi], doubles at which f has different signs, to neighbours; or to one point where f is zero.
 */
static int close_in(algsurf_exact_walk *walk, const algsurf_zpoly *f, double guess, sample *lo, sample *hi) {
    sample last = *lo, previous = *hi;
    int before = lo->sign, slow = 0;
    double x = guess > lo->t && guess < hi->t ? guess : next_point(&last, &previous, before, 0);
    for (int round = 0; doubles_between(lo->t, hi->t) > 1; round++) {
        uint64_t width = doubles_between(lo->t, hi->t);
        if (slow >= 3 || isnan(x)) {
            x = algsurf_i_double_of(algsurf_i_number_of(lo->t) + (int64_t)(width / 2));
            slow = 0;
        }
        if (!(x > lo->t)) x = next_up(lo->t);
        if (!(x < hi->t)) x = next_down(hi->t);
        previous = last;
        if (!sample_at(walk, f, x + 0.0, &last)) return 0;
        if (last.sign == 0) {
            *lo = *hi = last;
            return 1;
        }
        if (last.sign == before)
            *lo = last;
        else
            *hi = last;
        slow = doubles_between(lo->t, hi->t) > width / 2 ? slow + 1 : 0;
        if (previous.t == last.t) previous = last.sign == before ? *hi : *lo;
        x = next_point(&last, &previous, before, round);
    }
    return 1;
}

/* Two neighbouring doubles as a place, or one that is the root. */
static int set_doubles(algsurf_exact_walk *walk, double lo, double hi, algsurf_exact_place *place) {
    int e = 0;
    algsurf_limb *N = algsurf_memory_take(walk->memory, 4);
    if (!N) return 0;
    if (lo < hi)
        e = ilogb(hi - lo);
    else
        (void)algsurf_z_odd_part(lo, &e);
    algsurf_z_zero(N, 4);
    algsurf_z_add_double(N, 2, lo, -e);
    algsurf_z_add_double(N + 2, 2, hi, -e);
    *place = (algsurf_exact_place){place->of, N, lo < hi ? N + 2 : NULL, 2, walk->unit - e};
    return 1;
}

int algsurf_exact_signs(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_exact_place *place,
                        int *at_a, int *at_b) {
    const int w = place->width, r = place->r;
    if (at_b) *at_b = 0;
    return algsurf_zpoly_sign_at(m, p, place->a, w, r, at_a, NULL, NULL) &&
           (!at_b || !place->b || algsurf_zpoly_sign_at(m, p, place->b, w, r, at_b, NULL, NULL));
}

/* 2a, a + b and 2b over twice the denominator. */
int algsurf_exact_halve(algsurf_memory *m, algsurf_exact_place *place, int before) {
    int of_a = algsurf_z_bits(place->a, place->width), of_b = algsurf_z_bits(place->b, place->width), sign;
    int w = algsurf_z_width((of_a > of_b ? of_a : of_b) + 2);
    algsurf_limb *a = algsurf_memory_take(m, 3 * (size_t)w);
    if (!a) return 0;
    algsurf_limb *b = a + w, *middle = b + w;
    algsurf_z_copy(a, w, place->a, place->width);
    algsurf_z_copy(b, w, place->b, place->width);
    algsurf_z_copy(middle, w, a, w);
    algsurf_z_add(middle, b, w);
    algsurf_z_shift_up(a, w, 1);
    algsurf_z_shift_up(b, w, 1);
    *place = (algsurf_exact_place){place->of, a, b, w, place->r + 1};
    if (!algsurf_zpoly_sign_at(m, place->of, middle, w, place->r, &sign, NULL, NULL)) return 0;
    if (sign == before || sign == 0) place->a = middle;
    if (sign != before) place->b = sign == 0 ? NULL : middle;
    return 1;
}

/* Halves the place until neither end is a root: `before` is the sign just right of a. */
static int part_from_ends(algsurf_memory *m, algsurf_exact_place *place, int before) {
    for (int at_a, at_b; place->b;) {
        if (!algsurf_exact_signs(m, place->of, place, &at_a, &at_b)) return 0;
        if (at_a && at_b) return 1;
        if (!algsurf_exact_halve(m, place, before)) return 0;
    }
    return 1;
}

void algsurf_exact_set_hull(const algsurf_exact_walk *walk, algsurf_exact_root *root) {
    const algsurf_exact_place *place = &root->place;
    const algsurf_limb *b = place->b ? place->b : place->a;
    root->lo = algsurf_z_round_down(place->a, place->width, walk->unit - place->r);
    root->hi = algsurf_z_round_up(b, place->width, walk->unit - place->r);
    root->t = fmax(root->lo, -DBL_MAX) == root->lo ? root->lo : root->hi;
}

int algsurf_exact_to_doubles(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    algsurf_exact_place *place = &root->place;
    const algsurf_zpoly *f = place->of;
    int e = walk->unit - place->r, before = walk->before;
    sample lo, hi;
    if (doubles_between(root->lo, root->hi) <= 1) return 1; /* no double is inside */
    double first = algsurf_z_round_up(place->a, place->width, e),
           last = algsurf_z_round_down(place->b, place->width, e);
    if (!sample_at(walk, f, first, &lo) || !sample_at(walk, f, last, &hi)) return 0;
    if (lo.sign != 0 && lo.sign != before) {
        hi = lo;
        lo.t = root->lo;
    } else if (hi.sign == before) {
        lo = hi;
        hi.t = root->hi;
    } else if (lo.sign == 0) {
        hi = lo;
    } else if (hi.sign == 0) {
        lo = hi;
    } else if (!close_in(walk, f, walk->listed ? NAN : first_guess(walk), &lo, &hi)) {
        return 0;
    }
    int outside = lo.t < first || hi.t > last; /* the place reaches less far than the doubles */
    root->lo = lo.t + 0.0;
    root->hi = hi.t + 0.0;
    root->t = outside                      ? (lo.t < first ? root->hi : root->lo)
              : fabs(ratio(&lo, &hi)) <= 1 ? root->lo
                                           : root->hi;
    return outside || set_doubles(walk, root->lo, root->hi, place);
}

/* Is the place, whose hull is set, what the walk was asked for? */
static int is_enough(const algsurf_exact_walk *walk, const algsurf_exact_root *root) {
    const algsurf_exact_place *place = &root->place;
    int e = walk->unit - place->r, w = place->width;
    if (!place->b || walk->refine == ALGSURF_EXACT_ISOLATED) return 1;
    return walk->refine == ALGSURF_EXACT_BRACKETS && walk->parts == 0 &&
           algsurf_z_round_up(place->a, w, e) == root->lo && algsurf_z_round_down(place->b, w, e) == root->hi;
}

int algsurf_exact_refine_place(algsurf_exact_walk *walk, algsurf_exact_root *root) {
    if (!walk->parts) root->multiplicity = 1, root->sign_before = walk->before;
    algsurf_exact_set_hull(walk, root);
    return is_enough(walk, root) || algsurf_exact_to_doubles(walk, root);
}

int algsurf_exact_refine_cell(algsurf_exact_walk *walk, const algsurf_zpoly *f, algsurf_exact_root *root) {
    int before = 0;
    const algsurf_exact_cell *cell = &walk->cells.cell;
    for (int j = 0; before == 0; j++) before = algsurf_exact_sign(cell, j);
    if (!algsurf_exact_cell_place(walk->memory, &walk->cells, cell, &root->place)) return 0;
    walk->before = before;
    root->place.of = f;
    int apart = algsurf_exact_sign(cell, 0) && algsurf_exact_sign(cell, cell->b.degree);
    if (!apart && !part_from_ends(walk->memory, &root->place, before)) return 0;
    return algsurf_exact_refine_place(walk, root);
}
