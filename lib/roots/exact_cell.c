/* exact_cell.c - halving in integers.
 *
 * De Casteljau's scheme at 1/2 takes means.  Without the halves it takes sums: after i sums an entry carries
 * the factor 2^i, and a shift by n - i gives all entries of both halves the factor 2^n.  So a halving makes
 * coefficients n bits longer; limbs are added when that is needed, unless a common power of two can be taken
 * out instead.
 *
 * Memory.  Cells lie on the stack in the order in which they wait: the one in work is the last one, its left
 * half goes on top of its right half, and what has no root is given back at once. */
#include "../base/arithmetic.h"
#include "exact_walk.h"

#include <math.h>

/* Room for the cell's numbers in these widths, at the top of the stack. */
static int take_block(algsurf_memory *m, algsurf_exact_cell *cell, int width, int position_width) {
    size_t coefficients = (size_t)(cell->b.degree + 1) * (size_t)width;
    algsurf_limb *block = algsurf_memory_take(m, coefficients + (size_t)position_width);
    if (!block) return 0;
    cell->b.c = block;
    cell->b.width = width;
    cell->position = block + coefficients;
    cell->position_width = position_width;
    return 1;
}

int algsurf_exact_move_cell(algsurf_memory *m, algsurf_exact_cell *cell, int width, int position_width) {
    const algsurf_exact_cell old = *cell;
    if (!take_block(m, cell, width, position_width)) return 0;
    const int up = width >= old.b.width && cell->b.c == old.b.c; /* what lies highest goes first */
    if (up) algsurf_z_copy(cell->position, position_width, old.position, old.position_width);
    for (int i = 0; i <= old.b.degree; i++) {
        int k = up ? old.b.degree - i : i;
        algsurf_z_copy(algsurf_zpoly_at(&cell->b, k), width, algsurf_zpoly_at(&old.b, k), old.b.width);
    }
    if (!up) algsurf_z_copy(cell->position, position_width, old.position, old.position_width);
    return 1;
}

/* The cell in wider coefficients and position.  Its block is the last one taken: it grows where it is, unless
 * it has to move to another block of the stack, where the old numbers stay until they have been copied. */
static int widen_cell(algsurf_memory *m, algsurf_exact_cell *cell, int width, int position_width) {
    if (cell->begin.last == m->last)
        algsurf_memory_release(m, cell->begin);
    else
        cell->begin = algsurf_memory_here(m);
    return algsurf_exact_move_cell(m, cell, width, position_width);
}

void algsurf_exact_strip(algsurf_exact_cell *cell) {
    const algsurf_zpoly *b = &cell->b;
    int zeros = algsurf_zpoly_trailing(b);
    if (zeros > 0 && zeros < ALGSURF_Z_NO_BIT)
        for (int k = 0; k <= b->degree; k++) algsurf_z_shift_down(algsurf_zpoly_at(b, k), b->width, zeros);
    cell->bits = algsurf_zpoly_bits(b);
}

/* Room for coefficients of `bits` more bits and a position of one more. */
static int make_room(algsurf_memory *m, algsurf_exact_cell *cell, int bits) {
    int position_width = algsurf_z_width(cell->depth + cell->fine + 2), width = cell->b.width;
    if (algsurf_z_width(cell->bits + bits + 1) > width) {
        algsurf_exact_strip(cell);
        if (algsurf_z_width(cell->bits + bits + 1) > width) width = algsurf_z_width(cell->bits + bits + 1);
    }
    if (width == cell->b.width && position_width <= cell->position_width) return 1;
    return widen_cell(m, cell, width, position_width + 1);
}

int algsurf_exact_variations(const algsurf_exact_cell *cell) {
    int last = 0, count = 0;
    for (int j = 0; j <= cell->b.degree; j++) {
        int sign = algsurf_exact_sign(cell, j);
        count += sign * last < 0;
        last = sign ? sign : last;
    }
    return count;
}

/* a = from 2^shift. */
static inline void shift_into(algsurf_limb *a, const algsurf_limb *from, int w, int shift) {
    algsurf_limb low = 0;
    if (shift == 0 || shift >= 64) {
        algsurf_z_copy(a, w, from, w);
        algsurf_z_shift_up(a, w, shift);
        return;
    }
    for (int k = 0; k < w; k++) {
        algsurf_limb limb = from[k];
        a[k] = limb << shift | low;
        low = limb >> (64 - shift);
    }
}

/* The two halves of `right`, which becomes the right one. */
static void casteljau(algsurf_limb *left, algsurf_limb *right, int n, int w) {
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

/* position += 2^bit. */
static void step_position(algsurf_exact_cell *cell, int bit) {
    const algsurf_limb one = 1;
    algsurf_z_add_product(cell->position, cell->position_width, &one, 1, (algsurf_limb)1 << (bit & 63),
                          bit / 64);
}

/* The cell becomes its right half, *left its left half, on top of it. */
static int halve(algsurf_memory *m, algsurf_exact_cell *cell, algsurf_exact_cell *left) {
    int n = cell->b.degree;
    if (!make_room(m, cell, n)) return 0;
    *left = *cell;
    left->begin = algsurf_memory_here(m);
    if (!take_block(m, left, cell->b.width, cell->position_width)) return 0;
    casteljau(left->b.c, cell->b.c, n, cell->b.width);
    left->bits = cell->bits += n;
    left->variations = algsurf_exact_variations(left);
    cell->variations = algsurf_exact_variations(cell);
    left->depth = ++cell->depth;
    algsurf_z_shift_up(cell->position, cell->position_width, 1);
    algsurf_z_copy(left->position, left->position_width, cell->position, cell->position_width);
    step_position(cell, cell->fine);
    cell->left_done = 0;
    return 1;
}

/* The left half, on top of the right one and of the same widths, takes its place. */
static void keep_left(algsurf_memory *m, algsurf_exact_cell *cell, const algsurf_exact_cell *left) {
    const algsurf_exact_cell right = *cell;
    memcpy(right.b.c, left->b.c,
           (size_t)(left->position + left->position_width - left->b.c) * sizeof *right.b.c);
    *cell = *left;
    cell->b.c = right.b.c;
    cell->position = right.position;
    cell->begin = right.begin;
    algsurf_memory_release(m, left->begin);
}

int algsurf_exact_cell_place(algsurf_memory *m, const algsurf_exact_cells *cells,
                             const algsurf_exact_cell *cell, algsurf_exact_place *place) {
    const algsurf_limb one = 1;
    const algsurf_exact_piece *piece = &cells->piece;
    int shift = cell->depth + cell->fine, w = algsurf_z_width(shift + piece->length + 64 + 2);
    int up = cell->fine + piece->length;
    algsurf_limb *a = algsurf_memory_take(m, 3 * (size_t)w);
    if (!a) return 0;
    algsurf_limb *b = a + w, *position = b + w;
    algsurf_z_set(a, w, piece->at);
    algsurf_z_shift_up(a, w, shift);
    algsurf_z_copy(position, w, cell->position, cell->position_width);
    algsurf_z_shift_up(position, w, piece->length);
    algsurf_z_add(a, position, w);
    algsurf_z_copy(b, w, a, w);
    algsurf_z_add_product(b, w, &one, 1, (algsurf_limb)1 << (up & 63), up / 64);
    *place = (algsurf_exact_place){NULL, a, b, w, shift - (piece->unit - cells->unit)};
    return 1;
}

void algsurf_exact_cell_doubles(const algsurf_exact_cell *cell, double *b) {
    int most = algsurf_zpoly_bits(&cell->b);
    for (int j = 0; j <= cell->b.degree; j++) {
        int e;
        double d = algsurf_z_to_double(algsurf_zpoly_at(&cell->b, j), cell->b.width, &e);
        b[j] = e < most - 900 ? 0 : ldexp(d, e - most);
    }
}

/* ---- cells of a piece ---- */

/* f(2^shift u), up to a power of two. */
static int times_power(algsurf_memory *m, const algsurf_zpoly *f, int shift, algsurf_zpoly *g) {
    int n = f->degree, up = shift > 0 ? shift : -shift, least = ALGSURF_Z_NO_BIT, most = 0;
    for (int k = 0; k <= n; k++) {
        const algsurf_limb *c = algsurf_zpoly_at(f, k);
        int by = up * (shift > 0 ? k : n - k), low = algsurf_z_trailing(c, f->width);
        if (low == ALGSURF_Z_NO_BIT) continue;
        least = low + by < least ? low + by : least;
        most = algsurf_z_bits(c, f->width) + by > most ? algsurf_z_bits(c, f->width) + by : most;
    }
    int width = algsurf_z_width(most - least + 1);
    if (!algsurf_zpoly_new(m, n, width > f->width ? width : f->width, g)) return 0;
    for (int k = 0; k <= n; k++) {
        algsurf_limb *c = algsurf_zpoly_at(g, k);
        int by = up * (shift > 0 ? k : n - k) - least;
        algsurf_z_copy(c, g->width, algsurf_zpoly_at(f, k), f->width);
        if (by > 0) algsurf_z_shift_up(c, g->width, by);
        if (by < 0) algsurf_z_shift_down(c, g->width, -by);
    }
    return 1;
}

/* f over the piece, in room of its own. */
static int over_piece(algsurf_memory *m, const algsurf_zpoly *f, int unit, const algsurf_exact_piece *piece,
                      algsurf_zpoly *b) {
    algsurf_zpoly local = *f;
    return (piece->unit == unit || times_power(m, f, piece->unit - unit, &local)) &&
           algsurf_zpoly_bernstein(m, &local, piece->at, piece->length, b);
}

enum { TOLD_WORDS = 64 };

int algsurf_exact_tell_cell(const algsurf_exact_cells *cells, const algsurf_exact_cell *cell) {
    algsurf_limb block[TOLD_WORDS];
    algsurf_memory memory; /* of its own: watching leaves the walk's as it is */
    algsurf_exact_place at;
    int n = cell->b.degree;
    signed char signs[ALGSURF_MAX_POLY_DEGREE + 1];
    algsurf_memory_mark begin = algsurf_memory_begin(&memory, block, TOLD_WORDS, ALGSURF_I_DECIDE_MEMORY);
    int done = algsurf_exact_cell_place(&memory, cells, cell, &at);
    for (int j = 0; j <= n; j++) signs[j] = (signed char)algsurf_exact_sign(cell, j);
    if (done) {
        const algsurf_cell told = {.lo = algsurf_z_round_down(at.a, at.width, cells->unit - at.r),
                                   .hi = algsurf_z_round_down(at.b, at.width, cells->unit - at.r),
                                   .variations = cell->variations,
                                   .engine = ALGSURF_ENGINE_INTEGERS,
                                   .degree = n,
                                   .signs = signs};
        algsurf_i_tell_cell(cells->watch, &told);
    }
    algsurf_memory_release(&memory, begin);
    return done;
}

int algsurf_exact_cells_open(algsurf_exact_cells *cells, const algsurf_zpoly *f,
                             const algsurf_exact_piece *piece) {
    algsurf_memory *m = cells->memory;
    algsurf_exact_cell *cell = &cells->cell;
    algsurf_memory_mark begin = algsurf_memory_here(m);
    algsurf_zpoly b;
    if (!over_piece(m, f, cells->unit, piece, &b)) return 0;
    if (begin.last == m->last) algsurf_memory_release(m, begin); /* b moves down */
    algsurf_limb zero = 0;
    *cell =
        (algsurf_exact_cell){.begin = algsurf_memory_here(m), .b = b, .position = &zero, .position_width = 1};
    if (!algsurf_exact_move_cell(m, cell, b.width, 1)) return 0;
    cell->bits = algsurf_zpoly_bits(&cell->b);
    cell->variations = algsurf_exact_variations(cell);
    cells->active = 1;
    cells->piece = *piece;
    return !cells->watch || algsurf_exact_tell_cell(cells, cell);
}

void algsurf_exact_cells_next(algsurf_exact_cells *cells) {
    algsurf_memory_release(cells->memory, cells->cell.begin);
    cells->active = cells->count > 0;
    if (cells->active) cells->cell = cells->waiting[--cells->count];
}

int algsurf_exact_cells_halve(algsurf_exact_cells *cells) {
    algsurf_exact_cell left;
    if (!halve(cells->memory, &cells->cell, &left)) return 0;
    if (cells->watch &&
        (!algsurf_exact_tell_cell(cells, &left) || !algsurf_exact_tell_cell(cells, &cells->cell)))
        return 0;
    int at_right = cells->cell.variations > 0 || algsurf_exact_begins_with_root(&cells->cell);
    int at_left = left.variations > 0;
    if (at_left && at_right) {
        cells->waiting[cells->count++] = cells->cell;
        cells->cell = left;
    } else if (at_left) {
        keep_left(cells->memory, &cells->cell, &left);
    } else {
        algsurf_memory_release(cells->memory, left.begin);
        if (!at_right) algsurf_exact_cells_next(cells);
    }
    return 1;
}
