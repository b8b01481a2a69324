/* exact_cell.c - halving in integers.
 *
 * De Casteljau's scheme at 1/2 takes means.  Without the halves it takes sums: after i sums an entry carries
 * the factor 2^i, and a shift by n - i gives all entries of both halves the factor 2^n.  So a halving makes
 * coefficients n bits longer; limbs are added when that is needed, unless a common power of two can be taken
 * out instead. */
#include "exact_cell.h"

#include <math.h>

static size_t block_size(int degree, int width, int position_width) {
    return (size_t)(degree + 1) * (size_t)width + (size_t)position_width;
}

/* The cell in wider coefficients and position.  Its block is the last one taken: it grows where it is, unless
 * it has to move to another block of the stack, where the old numbers stay until they have been copied. */
static int widen(algsurf_memory *m, algsurf_exact_cell *cell, int width, int position_width) {
    const algsurf_limb *old = cell->b.c, *old_position = cell->position;
    int n = cell->b.degree, old_width = cell->b.width;
    if (cell->begin.last == m->last)
        algsurf_memory_release(m, cell->begin);
    else
        cell->begin = algsurf_memory_here(m);
    algsurf_limb *block = algsurf_memory_take(m, block_size(n, width, position_width));
    if (!block) return 0;
    cell->position = block + (size_t)(n + 1) * (size_t)width;
    algsurf_z_copy(cell->position, position_width, old_position, cell->position_width);
    for (int k = n; k >= 0; k--)
        algsurf_z_copy(block + (size_t)k * (size_t)width, width, old + (size_t)k * (size_t)old_width,
                       old_width);
    cell->b.c = block;
    cell->b.width = width;
    cell->position_width = position_width;
    return 1;
}

static void strip(algsurf_exact_cell *cell) {
    int zeros = algsurf_zpoly_trailing(&cell->b);
    if (zeros > 0 && zeros < ALGSURF_Z_NO_BIT)
        for (int k = 0; k <= cell->b.degree; k++)
            algsurf_z_shift_down(algsurf_zpoly_at(&cell->b, k), cell->b.width, zeros);
    cell->bits = algsurf_zpoly_bits(&cell->b);
}

/* Room for coefficients of `bits` more bits and a position of one more. */
static int make_room(algsurf_memory *m, algsurf_exact_cell *cell, int bits) {
    int position_width = algsurf_z_width(cell->depth + cell->fine + 2), width = cell->b.width;
    if (algsurf_z_width(cell->bits + bits + 1) > width) {
        strip(cell);
        if (algsurf_z_width(cell->bits + bits + 1) > width) width = algsurf_z_width(cell->bits + bits + 1);
    }
    if (width == cell->b.width && position_width <= cell->position_width) return 1;
    return widen(m, cell, width, position_width + 1);
}

int algsurf_exact_cell_whole(algsurf_memory *m, const algsurf_zpoly *f, int64_t at, int length,
                             algsurf_exact_cell *cell) {
    *cell = (algsurf_exact_cell){.begin = algsurf_memory_here(m), .position_width = 1};
    if (!algsurf_zpoly_bernstein(m, f, at, length, &cell->b)) return 0;
    cell->position = algsurf_memory_take(m, 1);
    if (!cell->position) return 0;
    cell->position[0] = 0;
    cell->bits = algsurf_zpoly_bits(&cell->b);
    cell->variations = algsurf_exact_variations(&cell->b);
    return 1;
}

int algsurf_exact_variations(const algsurf_zpoly *b) {
    int last = 0, count = 0;
    for (int j = 0; j <= b->degree; j++) {
        int sign = algsurf_z_sign(algsurf_zpoly_at(b, j), b->width);
        if (sign == 0) continue;
        count += last != 0 && sign != last;
        last = sign;
    }
    return count;
}

/* a = from 2^shift, 0 <= shift < 64. */
static inline void shifted(algsurf_limb *a, const algsurf_limb *from, int w, int shift) {
    algsurf_limb low = 0;
    for (int k = 0; k < w; k++) {
        algsurf_limb limb = from[k];
        a[k] = shift ? limb << shift | low : limb;
        low = shift ? limb >> (64 - shift) : 0;
    }
}

static inline void shift_into(algsurf_limb *a, const algsurf_limb *from, int w, int shift) {
    if (shift < 64) {
        shifted(a, from, w, shift);
    } else {
        algsurf_z_copy(a, w, from, w);
        algsurf_z_shift_up(a, w, shift);
    }
}

/* The two halves of `right`, which becomes the right one. */
static inline __attribute__((always_inline)) void casteljau(algsurf_limb *left, algsurf_limb *right, int n,
                                                            int w) {
    for (int i = 0; i <= n; i++) {
        algsurf_limb *a = right;
        shift_into(left + (size_t)i * (size_t)w, right, w, n - i);
        for (int j = 0; j < n - i; j++, a += w) {
            unsigned char carry = 0;
            for (int k = 0; k < w; k++) a[k] = algsurf_limb_add(a[k], a[w + k], &carry);
        }
        if (i < n) shift_into(a, a, w, n - i);
    }
}

/* With the width known to the compiler the sums are chains without a loop. */
static void halve_block(algsurf_limb *left, algsurf_limb *right, int n, int w) {
    switch (w) {
#define WIDTH(x)                                                                                             \
    case x:                                                                                                  \
        casteljau(left, right, n, x);                                                                        \
        break;
        WIDTH(1)
        WIDTH(2)
        WIDTH(3)
        WIDTH(4)
        WIDTH(5)
        WIDTH(6)
        WIDTH(7)
        WIDTH(8)
        WIDTH(9)
        WIDTH(10)
        WIDTH(11)
        WIDTH(12)
#undef WIDTH
    default:
        casteljau(left, right, n, w);
    }
}

/* position += 2^bit. */
static void step_position(algsurf_exact_cell *cell, int bit) {
    const algsurf_limb one = 1;
    algsurf_z_add_product(cell->position, cell->position_width, &one, 1, (algsurf_limb)1 << (bit & 63),
                          bit / 64);
}

int algsurf_exact_halve(algsurf_memory *m, algsurf_exact_cell *cell, algsurf_exact_cell *left) {
    int n = cell->b.degree;
    if (!make_room(m, cell, n)) return 0;
    *left = *cell;
    left->begin = algsurf_memory_here(m);
    left->b.c = algsurf_memory_take(m, block_size(n, cell->b.width, cell->position_width));
    if (!left->b.c) return 0;
    halve_block(left->b.c, cell->b.c, n, cell->b.width);
    left->bits = cell->bits += n;
    left->variations = algsurf_exact_variations(&left->b);
    cell->variations = algsurf_exact_variations(&cell->b);
    left->depth = ++cell->depth;
    algsurf_z_shift_up(cell->position, cell->position_width, 1);
    left->position = left->b.c + (size_t)(n + 1) * (size_t)cell->b.width;
    algsurf_z_copy(left->position, left->position_width, cell->position, cell->position_width);
    step_position(cell, cell->fine);
    cell->left_done = 0;
    return 1;
}

void algsurf_exact_keep_left(algsurf_memory *m, algsurf_exact_cell *cell, const algsurf_exact_cell *left) {
    algsurf_limb *block = cell->b.c, *position = cell->position;
    algsurf_memory_mark begin = cell->begin;
    size_t coefficients = (size_t)(left->b.degree + 1) * (size_t)left->b.width;
    memcpy(block, left->b.c, coefficients * sizeof *block);
    memcpy(position, left->position, (size_t)left->position_width * sizeof *position);
    *cell = *left;
    cell->b.c = block;
    cell->position = position;
    cell->begin = begin;
    algsurf_memory_release(m, left->begin);
}

void algsurf_exact_cell_doubles(const algsurf_exact_cell *cell, double *b) {
    int most = algsurf_zpoly_bits(&cell->b);
    for (int j = 0; j <= cell->b.degree; j++) {
        int e;
        double d = algsurf_z_to_double(algsurf_zpoly_at(&cell->b, j), cell->b.width, &e);
        b[j] = e < most - 900 ? 0 : ldexp(d, e - most);
    }
}
