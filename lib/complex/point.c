/* point.c - points of the complex plane as integers, and their differences. */
#include "../base/arithmetic.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "discs.h"

#define MOST_BITS ((int64_t)1 << 26) /* of a point: more is no memory */

static const algsurf_limb no_limb = 0;
const algsurf_i_point algsurf_i_origin = {.x = (algsurf_limb *)&no_limb,
                                          .y = (algsurf_limb *)&no_limb,
                                          .w = 1,
                                          .head = {.exponent = ALGSURF_SCALED_NONE}};

/* Room for `limbs` in each part of a point, what is in it lost. */
static int make_room(algsurf_memory *m, algsurf_i_point *z, int limbs) {
    int room = limbs + limbs / 2 + 1;
    algsurf_limb *x = algsurf_memory_take(m, 2 * (size_t)room);
    if (!x) return 0;
    z->x = x, z->y = x + room, z->room = room;
    return 1;
}

/* Cuts zeros at the end, and limbs too many. */
static void trim(algsurf_i_point *z) {
    int a = algsurf_z_trailing(z->x, z->w), b = algsurf_z_trailing(z->y, z->w), zeros = a < b ? a : b;
    if (zeros == ALGSURF_Z_NO_BIT) zeros = 0, z->exponent = 0;
    algsurf_z_shift_down(z->x, z->w, zeros);
    algsurf_z_shift_down(z->y, z->w, zeros);
    z->exponent += zeros;
    a = algsurf_z_bits(z->x, z->w), b = algsurf_z_bits(z->y, z->w);
    z->w = algsurf_z_width(a > b ? a : b);
}

/* z = next, in its own memory if that suffices. */
static void keep(algsurf_memory *m, algsurf_memory_mark mark, algsurf_i_point *z, algsurf_i_point *next) {
    trim(next);
    next->head = algsurf_i_head(next->x, next->y, next->w, next->exponent);
    next->above = algsurf_i_head(next->y, NULL, next->w, next->exponent);
    next->above.re = fabs(next->above.re);
    const algsurf_scaled head = next->head;
    next->exact = algsurf_i_head_is_exact(next->x, next->y, next->w);
    double unit = llabs(head.exponent) < 250 ? power_of_two(head.exponent) : NAN;
    if (is_zero(head)) unit = 1;
    next->flat[0] = head.re * unit, next->flat[1] = head.im * unit;
    next->reach = fmax(fabs(next->flat[0]), fabs(next->flat[1]));
    if (z->room >= next->w) {
        memcpy(z->x, next->x, (size_t)next->w * sizeof *z->x);
        memcpy(z->y, next->y, (size_t)next->w * sizeof *z->y);
        next->x = z->x, next->y = z->y, next->room = z->room;
        algsurf_memory_release(m, mark);
    }
    *z = *next;
}

int algsurf_i_set_point(algsurf_memory *m, algsurf_i_point *z, const algsurf_i_point *from,
                        algsurf_scaled way, int64_t low, int on_axis) {
    int64_t top = larger(from->head, way).exponent + 2;
    if (top - low > MOST_BITS) return 0;
    int w = top > low ? algsurf_z_width((int)(top - low) + 2) : 1;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_i_point next = {.w = w, .exponent = low};
    if (!make_room(m, &next, w)) return 0;
    algsurf_z_zero(next.x, w);
    algsurf_z_zero(next.y, w);
    algsurf_i_add_shifted(next.x, w, from->x, from->w, from->exponent - low);
    algsurf_i_add_double(next.x, w, way.re, way.exponent - low);
    if (!on_axis) {
        algsurf_i_add_shifted(next.y, w, from->y, from->w, from->exponent - low);
        algsurf_i_add_double(next.y, w, way.im, way.exponent - low);
    }
    keep(m, mark, z, &next);
    return 1;
}

int algsurf_i_set_conjugate(algsurf_memory *m, algsurf_i_point *z, const algsurf_i_point *from) {
    int w = from->w + 1;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_i_point next = {.w = w, .exponent = from->exponent};
    if (!make_room(m, &next, w)) return 0;
    algsurf_z_copy(next.x, w, from->x, from->w);
    algsurf_z_copy(next.y, w, from->y, from->w);
    algsurf_z_negate(next.y, w);
    keep(m, mark, z, &next);
    return 1;
}

/* a -= (x + iy) b 2^shift. */
static void subtract_product(algsurf_i_sum *a, const algsurf_i_sum *b, int64_t x, int64_t y, int64_t shift,
                             algsurf_limb *room) {
    const int w = b->w + 1;
    const algsurf_limb *part[2] = {b->re, b->im};
    const int64_t by[2] = {x, y};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            int minus = (by[j] < 0) != !(i && j);
            algsurf_z_zero(room, w);
            algsurf_z_join_product(room, w, part[i], b->w, (algsurf_limb)llabs(by[j]), 0, minus);
            algsurf_i_add_shifted(i == j ? a->re : a->im, a->w, room, w, shift);
        }
}

/* A sum with as many limbs more below, in its sums' room for a rest, with `after` limbs behind it. */
static int lengthen(algsurf_i_sums *s, const algsurf_i_sum *a, int more, int after, algsurf_i_sum *longer) {
    const int w = a->w + more;
    const size_t limbs = 2 * (size_t)w + (size_t)after;
    if (limbs > s->rest_limbs) {
        s->rest_limbs = limbs + limbs / 2;
        s->rest = algsurf_memory_take(s->m, s->rest_limbs);
    }
    if (!s->rest) return 0;
    *longer = (algsurf_i_sum){.re = s->rest, .im = s->rest + w, .w = w, .exponent = a->exponent - 64 * more};
    algsurf_z_zero(longer->re, 2 * w);
    algsurf_z_copy(longer->re + more, a->w, a->re, a->w);
    algsurf_z_copy(longer->im + more, a->w, a->im, a->w);
    return 1;
}

/* Chunks of the quotient by doubles, what is left by integers, until that is no less.  The last chunk's last
 * bit times that of the divisor is not below the last one of what is left. */
int algsurf_i_subtract_quotient(algsurf_i_sums *s, algsurf_i_point *z, int j, int factor, int64_t low,
                                int on_axis) {
    const algsurf_i_sum *a = s->at + j, *b = a + 1;
    const algsurf_scaled divisor = by(algsurf_i_sum_head(b), factor);
    const int64_t more = (a->exponent - low + 50 - b->exponent) / 64 + 1;
    algsurf_i_sum rest;
    if (more > MOST_BITS || !lengthen(s, a, more > 0 ? (int)more : 0, b->w + 1, &rest)) return 0;
    for (int64_t before = INT64_MAX;;) {
        algsurf_scaled way = over(algsurf_i_sum_head(&rest), divisor);
        if (way.exponent < low || way.exponent >= before) return 1;
        int64_t x = (int64_t)(way.re * 0x1p50), y = (int64_t)(way.im * 0x1p50);
        before = way.exponent;
        way.re = -(double)x * 0x1p-50, way.im = -(double)y * 0x1p-50;
        if (!algsurf_i_set_point(s->m, z, z, way, low, on_axis)) return 0;
        subtract_product(&rest, b, factor * x, factor * y, before - 50 + b->exponent - rest.exponent,
                         rest.im + rest.w);
    }
}

int algsurf_i_is_conjugate(const algsurf_i_point *a, const algsurf_i_point *b) {
    if (a->head.re != b->head.re || a->head.im != -b->head.im || a->exponent != b->exponent || a->w != b->w)
        return 0;
    unsigned char carry = 0;
    for (int i = 0; i < a->w; i++)
        if (a->x[i] != b->x[i] || algsurf_limb_add(a->y[i], b->y[i], &carry) != 0) return 0;
    return 1;
}

int algsurf_i_exact_difference(algsurf_memory *m, const algsurf_i_point *a, const algsurf_i_point *b,
                               algsurf_scaled *result) {
    int64_t low = a->exponent < b->exponent ? a->exponent : b->exponent;
    int64_t up = (a->exponent > b->exponent ? a->exponent : b->exponent) - low;
    if (up > MOST_BITS) return 0;
    int w = (a->w > b->w ? a->w : b->w) + (int)(up / 64) + 2;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_limb *x = algsurf_memory_take(m, 2 * (size_t)w);
    if (!x) return 0;
    algsurf_limb *y = x + w;
    algsurf_z_zero(x, 2 * w);
    algsurf_i_add_shifted(x, w, b->x, b->w, b->exponent - low);
    algsurf_i_add_shifted(y, w, b->y, b->w, b->exponent - low);
    algsurf_z_negate(x, w);
    algsurf_z_negate(y, w);
    algsurf_i_add_shifted(x, w, a->x, a->w, a->exponent - low);
    algsurf_i_add_shifted(y, w, a->y, a->w, a->exponent - low);
    *result = algsurf_i_head(x, y, w, low);
    algsurf_memory_release(m, mark);
    return 1;
}
