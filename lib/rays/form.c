/* form.c - forms along a part of a ray: Horner's rule on integers. */
#include "form.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_WORDS = 4096,   /* of an integer */
    MOST_EXPONENT = 4300 /* U: what fits in a factor */
};

/* form (degree) becomes form x (degree + 1). */
static void times(const algsurf_i_ray_form *f, uint32_t *form, int degree, const algsurf_i_form_linear *x) {
    for (int k = degree + 1; k >= 0; k--) {
        algsurf_i_integer_zero(f->spare, f->size);
        if (k <= degree)
            algsurf_i_integer_add_product(f->spare, algsurf_i_form_entry(f, form, k), &x->at[0], f->size);
        if (k > 0)
            algsurf_i_integer_add_product(f->spare, algsurf_i_form_entry(f, form, k - 1), &x->at[1], f->size);
        memcpy(algsurf_i_form_entry(f, form, k), f->spare, (size_t)f->size * sizeof *form);
    }
}

/* form += a w^degree. */
static void add_constant(const algsurf_i_ray_form *f, uint32_t *form, int degree, double a) {
    algsurf_i_factor factor;
    if (a == 0 || (degree > 0 && isinf(f->lo) && isinf(f->hi))) return;
    algsurf_i_factor_of(&factor, a, f->coefficient_shift);
    for (int k = isinf(f->lo) ? degree : 0; k <= (isinf(f->hi) ? 0 : degree); k++) {
        uint64_t b = isinf(f->lo) || isinf(f->hi) ? 1 : algsurf_i_binomial(degree, k);
        algsurf_i_integer_zero(f->spare, f->size);
        f->spare[0] = (uint32_t)b;
        if (f->size > 1) f->spare[1] = (uint32_t)(b >> 32);
        algsurf_i_integer_shift(f->spare, f->size, f->shift * degree);
        algsurf_i_integer_add_product(algsurf_i_form_entry(f, form, k), f->spare, &factor, f->size);
    }
}

static void clear(const algsurf_i_ray_form *f, uint32_t *form) {
    algsurf_i_integer_zero(form, (f->n + 1) * f->size);
}

static void add_form(const algsurf_i_ray_form *f, uint32_t *to, const uint32_t *from, int degree) {
    for (int k = 0; k <= degree; k++)
        algsurf_i_integer_add(algsurf_i_form_entry(f, to, k), from + (size_t)k * (size_t)f->size, f->size);
}

/* Horner's rule in z, y, x; each of them raises the degree up to n, n - k, n - k - j. */
static void expand(const algsurf_i_ray_form *f) {
    const algsurf_surface *s = f->surface;
    clear(f, f->p);
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_level *level = s->levels + k;
        clear(f, f->level);
        for (int j = level->count - 1; j >= 0; j--) {
            const algsurf_row *row = s->rows + level->first + j;
            int degree = f->n - k - j;
            clear(f, f->row);
            for (int i = row->length - 1; i >= 0; i--) {
                if (i < row->length - 1) times(f, f->row, degree - i - 1, &f->x[0]);
                add_constant(f, f->row, degree - i, s->coef[row->first + (size_t)i]);
            }
            if (j < level->count - 1) times(f, f->level, degree - 1, &f->x[1]);
            add_form(f, f->level, f->row, degree);
        }
        if (k < s->level_count - 1) times(f, f->p, f->n - k - 1, &f->x[2]);
        add_form(f, f->p, f->level, f->n - k);
    }
    for (int k = 0; k <= f->n; k++) {
        for (int i = 2; i <= k; i++)
            algsurf_i_integer_multiply(algsurf_i_form_entry(f, f->p, k), f->size, (uint32_t)i);
        for (int i = 2; i <= f->n - k; i++)
            algsurf_i_integer_multiply(algsurf_i_form_entry(f, f->p, k), f->size, (uint32_t)i);
    }
}

/* ---- the extent ---- */

/* 2^shift (X - c w) at an end. */
static void from_centre(const algsurf_i_ray_form *f, int axis, int end, uint32_t *distance) {
    algsurf_i_factor factor;
    algsurf_i_integer_zero(distance, f->size);
    algsurf_i_integer_zero(f->spare, f->size);
    f->spare[0] = 1;
    algsurf_i_integer_add_product(distance, f->spare, &f->x[axis].at[end], f->size);
    if (isinf(end ? f->hi : f->lo)) return;
    algsurf_i_factor_of(&factor, -f->extent->centre[axis], f->shift - f->surface->unit);
    algsurf_i_integer_add_product(distance, f->spare, &factor, f->size);
}

/* 2^shift size w at an end. */
static void size_at(const algsurf_i_ray_form *f, double size, int end, uint32_t *at) {
    algsurf_i_factor factor;
    algsurf_i_integer_zero(at, f->size);
    if (isinf(end ? f->hi : f->lo)) return;
    algsurf_i_integer_zero(f->spare, f->size);
    f->spare[0] = 1;
    algsurf_i_factor_of(&factor, size, f->shift - f->surface->unit);
    algsurf_i_integer_add_product(at, f->spare, &factor, f->size);
}

/* form += sign times the square of a linear form with these values at the ends. */
static void add_square(const algsurf_i_ray_form *f, uint32_t *form, int sign, uint32_t *const at[2]) {
    algsurf_i_factor factor;
    for (int end = 0; end < 2; end++) {
        algsurf_i_factor_from(&factor, at[end],
                              f->size < ALGSURF_FACTOR_WORDS ? f->size : ALGSURF_FACTOR_WORDS);
        if (sign < 0) factor.negative = !factor.negative;
        algsurf_i_integer_add_product(algsurf_i_form_entry(f, form, 2 * end), at[end], &factor, f->size);
        if (end == 1)
            algsurf_i_integer_add_product(algsurf_i_form_entry(f, form, 1), at[0], &factor, f->size);
    }
}

static void set_sphere(const algsurf_i_ray_form *f) {
    uint32_t *const at[2] = {algsurf_i_form_entry(f, f->part, 0), algsurf_i_form_entry(f, f->part, 1)};
    algsurf_i_integer_zero(f->inside, 3 * f->size);
    for (int axis = 0; axis < 3; axis++) {
        for (int end = 0; end < 2; end++) from_centre(f, axis, end, at[end]);
        add_square(f, f->inside, -1, at);
    }
    for (int end = 0; end < 2; end++) size_at(f, f->extent->size[0], end, at[end]);
    add_square(f, f->inside, 1, at);
}

static void set_box(const algsurf_i_ray_form *f) {
    const algsurf_i_factor minus_one = {1, 1, {1}};
    uint32_t *distance = algsurf_i_form_entry(f, f->part, 0), *size = algsurf_i_form_entry(f, f->part, 1);
    for (int axis = 0; axis < 3; axis++)
        for (int end = 0; end < 2; end++) {
            uint32_t *below = algsurf_i_form_entry(f, algsurf_i_form_face(f, 2 * axis), end);
            uint32_t *above = algsurf_i_form_entry(f, algsurf_i_form_face(f, 2 * axis + 1), end);
            from_centre(f, axis, end, distance);
            size_at(f, f->extent->size[axis], end, size);
            memcpy(below, size, (size_t)f->size * sizeof *size);
            memcpy(above, size, (size_t)f->size * sizeof *size);
            algsurf_i_integer_add(below, distance, f->size);
            algsurf_i_integer_add_product(above, distance, &minus_one, f->size);
        }
}

static void set_extent(algsurf_i_ray_form *f) {
    if (f->extent->kind == ALGSURF_EXTENT_BOX)
        set_box(f);
    else
        set_sphere(f);
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
    algsurf_i_factor factor;
    if (isinf(t)) {
        algsurf_i_factor_of(end, t < 0 ? -direction : direction, shift + far);
        return;
    }
    algsurf_i_factor_of(&factor, origin, shift);
    algsurf_i_integer_add_product(sum, one, &factor, ALGSURF_FACTOR_WORDS);
    if (t != 0 && direction != 0) {
        uint32_t multiple[ALGSURF_FACTOR_WORDS] = {0};
        int last = algsurf_i_last_bit(t);
        algsurf_i_factor_of(&factor, t, -last);
        algsurf_i_integer_add_product(multiple, one, &factor, ALGSURF_FACTOR_WORDS);
        algsurf_i_factor_of(&factor, direction, shift + last);
        algsurf_i_integer_add_product(sum, multiple, &factor, ALGSURF_FACTOR_WORDS);
    }
    algsurf_i_factor_from(end, sum, ALGSURF_FACTOR_WORDS);
}

/* Shifts, size and the ray's ends; 0 when there are too many digits. */
static int measure(algsurf_i_ray_form *f, const algsurf_ray *ray) {
    const algsurf_surface *s = f->surface;
    span ends = {0, 1}, coefficients = {0, 1};
    for (int i = 0; i < 3; i++) {
        take_number(&ends, ray->origin[i], s->unit);
        take_number(&ends, ray->direction[i], s->unit - f->far);
        if (!isinf(f->lo)) take_product(&ends, ray->direction[i], f->lo, s->unit);
        if (!isinf(f->hi)) take_product(&ends, ray->direction[i], f->hi, s->unit);
        if (!f->extent) continue;
        take_number(&ends, f->extent->centre[i], s->unit);
        take_number(&ends, f->extent->size[f->extent->kind == ALGSURF_EXTENT_BOX ? i : 0], s->unit);
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
    long words = (16 + most + (bits + 1 + 6 + f->depth) * (f->n < 2 ? 2 : f->n) + 2) / 32 + 1;
    if (words > MOST_WORDS) return 0;
    f->size = (int)words;
    f->shift = -ends.least;
    f->coefficient_shift = -coefficients.least;
    for (int i = 0; i < 3; i++) {
        set_end(&f->x[i].at[0], ray->origin[i], ray->direction[i], f->lo, f->far, f->shift - s->unit);
        set_end(&f->x[i].at[1], ray->origin[i], ray->direction[i], f->hi, f->far, f->shift - s->unit);
    }
    return 1;
}

static double end_size(double end) { return isinf(end) ? 0 : fabs(end); }

int algsurf_i_ray_form_make(algsurf_i_ray_form *f, const algsurf_ray *ray) {
    double size = fmax(end_size(f->lo), end_size(f->hi));
    f->n = f->surface->degree;
    f->far = (isinf(f->lo) || isinf(f->hi)) && size > 1 ? ilogb(size) : 0;
    if ((isinf(f->lo) && isinf(f->hi)) || !measure(f, ray)) return 0;
    int box = f->extent && f->extent->kind == ALGSURF_EXTENT_BOX;
    f->faces = !f->extent ? 0 : box ? ALGSURF_MOST_FACES : 1;
    f->face_degree = box ? 1 : 2;
    size_t integer = (size_t)f->size, form = (size_t)(f->n + 1) * integer;
    size_t face = (size_t)(f->face_degree + 1) * integer;
    f->memory = malloc((5 * form + (size_t)(f->faces + 2) * face + integer) * sizeof *f->memory);
    if (!f->memory) return 0;
    f->row = f->memory;
    f->level = f->row + form;
    f->p = f->level + form;
    f->left = f->p + form;
    f->right = f->left + form;
    f->inside = f->right + form;
    f->part = f->inside + (size_t)f->faces * face;
    f->spare = f->part + 2 * face;
    expand(f);
    if (f->extent) set_extent(f);
    return 1;
}

void algsurf_i_ray_form_free(algsurf_i_ray_form *f) { free(f->memory); }
