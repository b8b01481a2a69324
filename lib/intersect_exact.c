/* intersect_exact.c - Descartes' rule in exact arithmetic.
 *
 * All doubles are integers times powers of two, so on [lo,hi], t = lo (1-s) + hi s, the point (X, w) of the
 * ray, homogeneous, is linear in s, and 2^S times it has integer ends.  P, made homogeneous of its degree n,
 * is then a form of degree n in (1-s, s) with integer coefficients c_k; with an infinite end it is the same
 * with the direction, w = 0, for that end, times 2^m, about the size of the other one.  The numbers
 * k! (n-k)! c_k are n! times its Bernstein coefficients: their signs count roots, and de Casteljau's scheme
 * without its halves bisects, exactly.
 *
 * Bisection ends DEPTH deep.  Where [lo,hi] is long against the place left open then, that place becomes an
 * interval of its own, between doubles, and so does what lies on either side of it.
 *
 * A point is in a sphere where R^2 w^2 - |X - c w|^2 >= 0, in a box where h_i^2 w^2 - (X_i - c_i w)^2 >= 0:
 * quadratic forms, to which the same is done.
 *
 * Size of the integers.  If all ends are below 2^U and coefficients below 2^A, a form's coefficients add up
 * to at most 2^16 2^A 2^((U+1) n), for a surface has fewer than 2^16 terms; n! <= 2^(6n), and each bisection
 * adds n bits.  The extent's forms need no more than one of degree 2 with n! and 2^16 in it.  A cell is found
 * again from the whole interval, so that only one is kept. */
#include "intersect_exact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "eft_integer.h"

enum {
    DEPTH = 60,           /* of bisection */
    MOST_WORDS = 4096,    /* of an integer */
    MOST_EXPONENT = 4300, /* U: what fits in a factor */
    GAIN = 30             /* bits by which a place must be shorter than its interval to be worth a new one */
};

typedef struct linear {
    algsurf_i_factor at[2]; /* at s = 0 and s = 1 */
} linear;

typedef struct task {
    const algsurf_surface *surface;
    double lo, hi;
    int open_lo;           /* a root at lo is not looked for */
    int far;               /* m: where an end is infinite, t is lo + 2^m s/(1-s), or hi - 2^m (1-s)/s */
    int n, size;           /* degree; words of an integer */
    int shift;             /* S; w is 2^S at finite ends */
    int coefficient_shift; /* of the surface's coefficients */
    linear x[3];
    uint32_t *memory, *row, *level, *total, *left, *right, *spare; /* forms; one integer */
    const algsurf_extent *extent;                                  /* null: none */
    uint32_t *inside, *part;                                       /* three forms of degree 2; two */
    algsurf_i_want want;
    algsurf_i_exact_root *roots;
    int count;
    double place_lo, place_hi; /* what is to be an interval of its own, if place_lo <= place_hi */
} task;

/* A cell [position, position + 1] 2^-depth of [0,1]. */
typedef struct place {
    uint64_t position;
    int depth;
} place;

static uint32_t *entry(const task *t, uint32_t *form, int k) { return form + (size_t)k * (size_t)t->size; }

/* ---- the form ---- */

/* form (degree) becomes form x (degree + 1). */
static void times(const task *t, uint32_t *form, int degree, const linear *x) {
    for (int k = degree + 1; k >= 0; k--) {
        algsurf_i_integer_zero(t->spare, t->size);
        if (k <= degree) algsurf_i_integer_add_product(t->spare, entry(t, form, k), &x->at[0], t->size);
        if (k > 0) algsurf_i_integer_add_product(t->spare, entry(t, form, k - 1), &x->at[1], t->size);
        memcpy(entry(t, form, k), t->spare, (size_t)t->size * sizeof *form);
    }
}

static uint64_t binomial(int n, int k) {
    uint64_t b = 1;
    for (int i = 1; i <= k; i++) /* C(64,32) 64 would overflow: b (n-k+i) / i by parts */
        b = b / (uint64_t)i * (uint64_t)(n - k + i) + b % (uint64_t)i * (uint64_t)(n - k + i) / (uint64_t)i;
    return b;
}

/* form += a w^degree. */
static void add_constant(const task *t, uint32_t *form, int degree, double a) {
    algsurf_i_factor f;
    if (a == 0 || (degree > 0 && isinf(t->lo) && isinf(t->hi))) return;
    algsurf_i_factor_of(&f, a, t->coefficient_shift);
    for (int k = isinf(t->lo) ? degree : 0; k <= (isinf(t->hi) ? 0 : degree); k++) {
        uint64_t b = isinf(t->lo) || isinf(t->hi) ? 1 : binomial(degree, k);
        algsurf_i_integer_zero(t->spare, t->size);
        t->spare[0] = (uint32_t)b;
        if (t->size > 1) t->spare[1] = (uint32_t)(b >> 32);
        algsurf_i_integer_shift(t->spare, t->size, t->shift * degree);
        algsurf_i_integer_add_product(entry(t, form, k), t->spare, &f, t->size);
    }
}

static void clear(const task *t, uint32_t *form) { algsurf_i_integer_zero(form, (t->n + 1) * t->size); }

static void add_form(const task *t, uint32_t *to, const uint32_t *from, int degree) {
    for (int k = 0; k <= degree; k++)
        algsurf_i_integer_add(entry(t, to, k), from + (size_t)k * (size_t)t->size, t->size);
}

/* Horner's rule in z, y, x; each of them raises the degree up to n, n - k, n - k - j. */
static void expand(const task *t) {
    const algsurf_surface *s = t->surface;
    clear(t, t->total);
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_level *level = s->levels + k;
        clear(t, t->level);
        for (int j = level->count - 1; j >= 0; j--) {
            const algsurf_row *row = s->rows + level->first + j;
            int degree = t->n - k - j;
            clear(t, t->row);
            for (int i = row->length - 1; i >= 0; i--) {
                if (i < row->length - 1) times(t, t->row, degree - i - 1, &t->x[0]);
                add_constant(t, t->row, degree - i, s->coef[row->first + (size_t)i]);
            }
            if (j < level->count - 1) times(t, t->level, degree - 1, &t->x[1]);
            add_form(t, t->level, t->row, degree);
        }
        if (k < s->level_count - 1) times(t, t->total, t->n - k - 1, &t->x[2]);
        add_form(t, t->total, t->level, t->n - k);
    }
    for (int k = 0; k <= t->n; k++) {
        for (int i = 2; i <= k; i++) algsurf_i_integer_multiply(entry(t, t->total, k), t->size, (uint32_t)i);
        for (int i = 2; i <= t->n - k; i++)
            algsurf_i_integer_multiply(entry(t, t->total, k), t->size, (uint32_t)i);
    }
}

/* ---- the extent ---- */

enum { QUADRATIC = 3 }; /* coefficients */

/* 2^shift (X - c w) at an end. */
static void from_centre(const task *t, int axis, int end, uint32_t *distance) {
    const uint32_t one[ALGSURF_FACTOR_WORDS] = {1};
    algsurf_i_factor f;
    algsurf_i_integer_zero(distance, t->size);
    algsurf_i_integer_zero(t->spare, t->size);
    t->spare[0] = one[0];
    algsurf_i_integer_add_product(distance, t->spare, &t->x[axis].at[end], t->size);
    if (isinf(end ? t->hi : t->lo)) return;
    algsurf_i_factor_of(&f, -t->extent->centre[axis], t->shift - t->surface->unit);
    algsurf_i_integer_add_product(distance, t->spare, &f, t->size);
}

/* form += sign times the square of a linear form with these values at the ends. */
static void add_square(const task *t, uint32_t *form, int sign, uint32_t *const at[2]) {
    algsurf_i_factor f;
    for (int end = 0; end < 2; end++) {
        algsurf_i_factor_from(&f, at[end], t->size < ALGSURF_FACTOR_WORDS ? t->size : ALGSURF_FACTOR_WORDS);
        if (sign < 0) f.negative = !f.negative;
        algsurf_i_integer_add_product(entry(t, form, 2 * end), at[end], &f, t->size);
        if (end == 1) algsurf_i_integer_add_product(entry(t, form, 1), at[0], &f, t->size);
    }
}

/* The Bernstein coefficients of what is not negative in the extent. */
static void set_extent(const task *t) {
    int box = t->extent->kind == ALGSURF_EXTENT_BOX;
    uint32_t *const at[2] = {entry(t, t->part, 0), entry(t, t->part, 1)};
    algsurf_i_integer_zero(t->inside, 3 * QUADRATIC * t->size);
    for (int axis = 0; axis < 3; axis++) {
        uint32_t *form = entry(t, t->inside, box ? QUADRATIC * axis : 0);
        for (int end = 0; end < 2; end++) from_centre(t, axis, end, at[end]);
        add_square(t, form, -1, at);
        if (!box && axis > 0) continue;
        algsurf_i_factor f;
        algsurf_i_factor_of(&f, t->extent->size[axis], t->shift - t->surface->unit);
        for (int end = 0; end < 2; end++) {
            algsurf_i_integer_zero(at[end], t->size);
            if (isinf(end ? t->hi : t->lo)) continue;
            algsurf_i_integer_add_product(at[end], t->spare, &f, t->size);
        }
        add_square(t, form, 1, at);
    }
}

/* ---- its size ---- */

/* The least and the largest exponent among numbers. */
typedef struct span {
    int least, most;
} span;

static void widen(span *s, int least, int most) {
    s->least = least < s->least ? least : s->least;
    s->most = most > s->most ? most : s->most;
}

static void take_number(span *s, double a, int unit) {
    if (a == 0) return;
    widen(s, algsurf_i_last_bit(a) - unit, ilogb(a) + 1 - unit);
}

static void take_product(span *s, double a, double b, int unit) {
    if (a == 0 || b == 0) return;
    widen(s, algsurf_i_last_bit(a) + algsurf_i_last_bit(b) - unit, ilogb(a) + ilogb(b) + 2 - unit);
}

/* 2^shift (origin + t direction) 2^-unit; for t = -inf, inf 2^far times the direction's. */
static void set_end(algsurf_i_factor *end, double origin, double direction, double t, int far, int shift) {
    uint32_t sum[ALGSURF_FACTOR_WORDS] = {0};
    const uint32_t one[ALGSURF_FACTOR_WORDS] = {1};
    algsurf_i_factor f;
    if (isinf(t)) {
        algsurf_i_factor_of(end, t < 0 ? -direction : direction, shift + far);
        return;
    }
    algsurf_i_factor_of(&f, origin, shift);
    algsurf_i_integer_add_product(sum, one, &f, ALGSURF_FACTOR_WORDS);
    if (t != 0 && direction != 0) {
        uint32_t factor[ALGSURF_FACTOR_WORDS] = {0};
        int last = algsurf_i_last_bit(t);
        algsurf_i_factor_of(&f, t, -last);
        algsurf_i_integer_add_product(factor, one, &f, ALGSURF_FACTOR_WORDS);
        algsurf_i_factor_of(&f, direction, shift + last);
        algsurf_i_integer_add_product(sum, factor, &f, ALGSURF_FACTOR_WORDS);
    }
    algsurf_i_factor_from(end, sum, ALGSURF_FACTOR_WORDS);
}

/* Shifts, size and the ray's ends; 0 when there are too many digits. */
static int measure(task *t, const algsurf_ray *ray) {
    const algsurf_surface *s = t->surface;
    span ends = {0, 1}, coefficients = {0, 1};
    for (int i = 0; i < 3; i++) {
        take_number(&ends, ray->origin[i], s->unit);
        take_number(&ends, ray->direction[i], s->unit - t->far);
        if (!isinf(t->lo)) take_product(&ends, ray->direction[i], t->lo, s->unit);
        if (!isinf(t->hi)) take_product(&ends, ray->direction[i], t->hi, s->unit);
        if (!t->extent) continue;
        take_number(&ends, t->extent->centre[i], s->unit);
        take_number(&ends, t->extent->size[t->extent->kind == ALGSURF_EXTENT_BOX ? i : 0], s->unit);
    }
    size_t count = 0;
    for (int k = 0; k < s->level_count; k++)
        for (int j = 0; j < s->levels[k].count; j++) {
            const algsurf_row *row = s->rows + s->levels[k].first + j;
            for (int i = 0; i < row->length; i++, count++)
                take_number(&coefficients, s->coef[row->first + (size_t)i], 0);
        }
    long bits = ends.most - ends.least + 2, most = coefficients.most - coefficients.least + 1;
    if (s->inexact || s->error > 0 || count == 0 || bits > MOST_EXPONENT || most > MOST_EXPONENT) return 0;
    long words = (16 + most + (bits + 1 + 6 + DEPTH) * (t->n < 2 ? 2 : t->n) + 2) / 32 + 1;
    if (words > MOST_WORDS) return 0;
    t->size = (int)words;
    t->shift = -ends.least;
    t->coefficient_shift = -coefficients.least;
    for (int i = 0; i < 3; i++) {
        set_end(&t->x[i].at[0], ray->origin[i], ray->direction[i], t->lo, t->far, t->shift - s->unit);
        set_end(&t->x[i].at[1], ray->origin[i], ray->direction[i], t->hi, t->far, t->shift - s->unit);
    }
    return 1;
}

/* ---- the search ---- */

/* Variations of sign: roots inside, or more by an even number; -1 when all coefficients are 0. */
static int variations(const task *t, uint32_t *form) {
    int last = 0, count = 0, any = 0;
    for (int k = 0; k <= t->n; k++) {
        int sign = algsurf_i_integer_sign(entry(t, form, k), t->size);
        if (sign == 0) continue;
        count += any && sign != last;
        last = sign;
        any = 1;
    }
    return any ? count : -1;
}

/* The cell in `right` becomes its halves, in `left` and `right`, both times 2^n: level i of the scheme is 2^i
 * times too large already. */
static void halve_form(const task *t, int n, uint32_t *left, uint32_t *right) {
    for (int i = 0; i <= n; i++) {
        memcpy(entry(t, left, i), right, (size_t)t->size * sizeof *left);
        algsurf_i_integer_shift(entry(t, left, i), t->size, n - i);
        for (int j = 0; j < n - i; j++)
            algsurf_i_integer_add(entry(t, right, j), entry(t, right, j + 1), t->size);
        algsurf_i_integer_shift(entry(t, right, n - i), t->size, n - i);
    }
}

static void halve(const task *t) { halve_form(t, t->n, t->left, t->right); }

static void keep_left(const task *t) {
    memcpy(t->right, t->left, (size_t)(t->n + 1) * (size_t)t->size * sizeof *t->left);
}

static void find_cell(const task *t, place at) {
    memcpy(t->right, t->total, (size_t)(t->n + 1) * (size_t)t->size * sizeof *t->left);
    for (int bit = at.depth - 1; bit >= 0; bit--) {
        halve(t);
        if (!(at.position >> bit & 1)) keep_left(t);
    }
}

/* The least and the largest sign that a form of the extent's has among its coefficients over a cell, or at
 * its left end. */
static void signs_in_cell(const task *t, const uint32_t *form, place at, int end_only, int sign[2]) {
    uint32_t *left = t->part, *right = entry(t, t->part, QUADRATIC);
    int from = 0, count = end_only ? 1 : QUADRATIC;
    memcpy(right, form, QUADRATIC * (size_t)t->size * sizeof *form);
    if (at.position >> at.depth) from = QUADRATIC - 1; /* the right end of all */
    for (int bit = at.depth - 1; from == 0 && bit >= 0; bit--) {
        halve_form(t, QUADRATIC - 1, left, right);
        if (!(at.position >> bit & 1)) memcpy(right, left, QUADRATIC * (size_t)t->size * sizeof *form);
    }
    sign[0] = 1, sign[1] = -1;
    for (int k = from; k < from + count; k++) {
        int one = algsurf_i_integer_sign(entry(t, right, k), t->size);
        sign[0] = one < sign[0] ? one : sign[0];
        sign[1] = one > sign[1] ? one : sign[1];
    }
}

/* Is a root in a cell, not at its ends, or at the left end of it, in the extent?  1, -1: it is not, 0: both
 * may be. */
static int in_extent(const task *t, place at, int end_only) {
    int answer = 1, forms = !t->extent ? 0 : t->extent->kind == ALGSURF_EXTENT_BOX ? 3 : 1;
    for (int i = 0; i < forms; i++) {
        int sign[2];
        signs_in_cell(t, entry(t, t->inside, QUADRATIC * i), at, end_only, sign);
        if (sign[0] < 0 && sign[1] <= 0) return -1;
        if (sign[0] < 0) answer = 0;
    }
    return answer;
}

/* t at a position, with a relative error of 2^-90 of what it is added to. */
static algsurf_dd t_at(const task *t, uint64_t position, int depth) {
    uint64_t whole = (uint64_t)1 << depth;
    algsurf_dd before = algsurf_two_sum(ldexp((double)(position >> 32), 32), (double)(uint32_t)position);
    algsurf_dd behind =
        algsurf_two_sum(ldexp((double)((whole - position) >> 32), 32), (double)(uint32_t)(whole - position));
    double unit = ldexp(1, t->far);
    if (isinf(t->hi))
        return position == whole
                   ? algsurf_dd_from(t->hi)
                   : algsurf_dd_add_d(algsurf_dd_scale(algsurf_dd_div(before, behind), unit), t->lo);
    if (isinf(t->lo))
        return position == 0
                   ? algsurf_dd_from(t->lo)
                   : algsurf_dd_add_d(algsurf_dd_scale(algsurf_dd_div(behind, before), -unit), t->hi);
    algsurf_dd share = algsurf_dd_scale(before, ldexp(1, -depth));
    return algsurf_dd_add_d(algsurf_dd_mul(algsurf_two_sum(t->hi, -t->lo), share), t->lo);
}

/* Moved outward by more than the error of t_at. */
static double outward(const task *t, algsurf_dd at, int side) {
    double size = fabs(at.hi) + (isinf(t->lo) ? 0 : fabs(t->lo)) + (isinf(t->hi) ? 0 : fabs(t->hi));
    double moved = nextafter(at.hi + side * (0x1p-85 * size), side * HUGE_VAL);
    return fmin(fmax(nextafter(moved, side * HUGE_VAL), t->lo), t->hi);
}

static double end_size(double end) { return isinf(end) ? 0 : fabs(end); }

/* A cell is as narrow as bisection makes it: is it so much shorter than [lo,hi] that it is worth an interval
 * of its own?  Then it is noted. */
static int set_apart(task *t, place at) {
    double lo = outward(t, t_at(t, at.position, at.depth), -1);
    double hi = outward(t, t_at(t, at.position + 1, at.depth), 1);
    double size = fmax(end_size(t->lo), end_size(t->hi));
    int gained;
    if (isinf(lo) || isinf(hi))
        gained = fmax(end_size(lo), end_size(hi)) >= ldexp(fmax(size, 1), GAIN);
    else
        gained = isinf(t->lo) || isinf(t->hi) || hi - lo <= ldexp(t->hi - t->lo, -GAIN);
    if (!gained) return 0;
    t->place_lo = lo;
    t->place_hi = hi;
    return 1;
}

/* When there is no room the last one grows, and is uncertain. */
static void add_root(task *t, int state, algsurf_status reason, place from, uint64_t length) {
    int inside = in_extent(t, from, length == 0);
    if (inside < 0) return;
    if (inside == 0 && state == ALGSURF_HIT) {
        state = ALGSURF_UNCERTAIN;
        reason = ALGSURF_UNDECIDED_END;
    }
    algsurf_dd lo = t_at(t, from.position, from.depth), hi = t_at(t, from.position + length, from.depth);
    algsurf_i_exact_root root = {state, reason, outward(t, lo, -1), outward(t, hi, 1),
                                 algsurf_dd_scale(algsurf_dd_add(lo, hi), 0.5)};
    if (isinf(lo.hi)) root.t = hi;
    if (isinf(hi.hi)) root.t = lo;
    if (t->count <= t->n) {
        t->roots[t->count++] = root;
        return;
    }
    t->roots[t->n].state = ALGSURF_UNCERTAIN;
    t->roots[t->n].reason = ALGSURF_UNDECIDED_MULTIPLE;
    t->roots[t->n].hi = root.hi;
}

/* Narrows a cell with one root inside, until its ends are neighbours as doubles, and it is known whether the
 * root is in the extent. */
static void add_bracket(task *t, place at) {
    while (at.depth < DEPTH) {
        algsurf_dd lo = t_at(t, at.position, at.depth), hi = t_at(t, at.position + 1, at.depth);
        if (nextafter(lo.hi, HUGE_VAL) >= hi.hi && in_extent(t, at, 0) != 0) break;
        halve(t);
        at.depth++;
        at.position *= 2;
        if (variations(t, t->left) == 1) {
            keep_left(t);
        } else {
            at.position++;
            if (algsurf_i_integer_sign(t->right, t->size) != 0) continue;
            add_root(t, ALGSURF_HIT, ALGSURF_OK, at, 0);
            return;
        }
    }
    if (at.depth < DEPTH || !set_apart(t, at)) add_root(t, ALGSURF_HIT, ALGSURF_OK, at, 1);
}

static int set_a_place_apart(const task *t) { return t->place_lo <= t->place_hi; }

static void forget_place(task *t) {
    t->place_lo = 1;
    t->place_hi = 0;
}

static int satisfied(const task *t) {
    if (set_a_place_apart(t)) return 1;
    if (t->count == 0 || t->want == ALGSURF_WANT_ALL) return 0;
    return t->want == ALGSURF_WANT_FIRST || t->roots[t->count - 1].state == ALGSURF_HIT;
}

/* The cell in `right`, from its left end on to where it needs no bisection: right halves that may hold roots
 * too are left to be searched, the nearest last. */
static void search_cell(task *t, place at, place *later, int *waiting) {
    int left_end = 1; /* it has not been looked at */
    for (;;) {
        if (left_end && algsurf_i_integer_sign(t->right, t->size) == 0 &&
            !(at.position == 0 && (t->open_lo || isinf(t->lo))))
            add_root(t, ALGSURF_HIT, ALGSURF_OK, at, 0);
        if (satisfied(t)) return;
        int count = variations(t, t->right);
        if (count == 1) add_bracket(t, at);
        if (count > 1 && at.depth == DEPTH && !set_apart(t, at))
            add_root(t, ALGSURF_UNCERTAIN, ALGSURF_UNDECIDED_MULTIPLE, at, 1);
        if (count <= 1 || at.depth == DEPTH) return;
        halve(t);
        at = (place){2 * at.position, at.depth + 1};
        left_end = variations(t, t->left) == 0;
        if (left_end) {
            at.position++;
        } else {
            later[(*waiting)++] = (place){at.position + 1, at.depth};
            keep_left(t);
        }
    }
}

static void search(task *t) {
    place later[DEPTH + 1] = {{0, 0}};
    int waiting = 1;
    const uint32_t *end = entry(t, t->total, t->n);
    if (variations(t, t->total) < 0) {
        add_root(t, ALGSURF_UNCERTAIN, ALGSURF_UNDECIDED_ZERO, later[0], 1);
        return;
    }
    while (waiting > 0 && !satisfied(t)) {
        place at = later[--waiting];
        find_cell(t, at);
        search_cell(t, at, later, &waiting);
    }
    if (!satisfied(t) && !isinf(t->hi) && t->lo < t->hi && algsurf_i_integer_sign(end, t->size) == 0)
        add_root(t, ALGSURF_HIT, ALGSURF_OK, (place){1, 0}, 0);
}

/* One interval; 0 when there are too many digits, or no memory. */
static int solve(task *t, const algsurf_ray *ray) {
    double size = fmax(end_size(t->lo), end_size(t->hi));
    t->far = (isinf(t->lo) || isinf(t->hi)) && size > 1 ? ilogb(size) : 0;
    forget_place(t);
    if ((isinf(t->lo) && isinf(t->hi)) || !measure(t, ray)) return 0;
    size_t form = (size_t)(t->n + 1) * (size_t)t->size;
    t->memory = malloc((5 * form + (5 * QUADRATIC + 1) * (size_t)t->size) * sizeof *t->memory);
    if (!t->memory) return 0;
    t->row = t->memory;
    t->level = t->row + form;
    t->total = t->level + form;
    t->left = t->total + form;
    t->right = t->left + form;
    t->inside = t->right + form;
    t->part = t->inside + 3 * QUADRATIC * (size_t)t->size;
    t->spare = t->part + 2 * QUADRATIC * (size_t)t->size;
    expand(t);
    if (t->extent) set_extent(t);
    search(t);
    free(t->memory);
    return 1;
}

/* [lo,hi], or (lo,hi]; what has been set apart, and what is beside it, each in its turn. */
static int solve_parts(task *t, const algsurf_ray *ray, double lo, double hi, int open_lo) {
    int before = t->count;
    t->lo = lo;
    t->hi = hi;
    t->open_lo = open_lo;
    if (!solve(t, ray)) return 0;
    if (!set_a_place_apart(t)) return 1;
    double from = t->place_lo, to = t->place_hi;
    t->count = before;
    forget_place(t);
    if (lo < from && !solve_parts(t, ray, lo, from, open_lo)) return 0;
    if (!satisfied(t) && !solve_parts(t, ray, from, to, lo < from || open_lo)) return 0;
    return satisfied(t) || to >= hi || solve_parts(t, ray, to, hi, 1);
}

int algsurf_i_exact_roots(const algsurf_surface *surface, const algsurf_ray *ray,
                          const algsurf_extent *extent, double lo, double hi, algsurf_i_want want,
                          algsurf_i_exact_root *roots) {
    task t = {.surface = surface, .extent = extent, .n = surface->degree, .want = want, .roots = roots};
    return solve_parts(&t, ray, lo, hi, 0) ? t.count : -1;
}
