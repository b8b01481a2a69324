/* enclose.c - a box about the points of a surface: branch and bound on cells.
 *
 * For each of the six faces of the box cells wait in the order in which they reach out that way (Skelboe
 * 1974). The first one is tried: where P, or with it a derivative, has one sign throughout it holds no point
 * and goes; else it is cut in eight.  When the first one is small nothing reaches out farther.  Each face is
 * looked for with cells small against the box; then all begins anew in the box that was found, and when that
 * no longer helps much, with smaller cells: so no search has to go deep.
 *
 * Cells are from lo to hi, doubles: parts share the double at which they are cut, wherever that is, and cover
 * the cell.  What can no longer be cut is the face.  Scaling of the extent, its ends, and scaling of the
 * result are rounded outward.
 *
 * Sign over a cell.  The points c + h xi, |xi_i| <= 1, c a double in the cell and h, rounded up, at least its
 * distance to both ends, cover it.  P is the sum of a_ijk xi^i eta^j zeta^k; beside a_000 a term with even
 * exponents lies between 0 and a_ijk, any other between +-a_ijk.
 *
 * Rounding.  Let P~(r) be P with magnitudes of coefficients at r = |c| + h.  Each of the three shifts gives a
 * coefficient at most 2n roundings, the powers of h take n + 2 more each, and at most N terms are added: what
 * is computed of the range is off by less than (6n + 3(n + 2) + N) u P~(r) (1 + ...), and 16 n + 2 N + 32
 * covers P~, which is rounded itself (3n + N), and the dots.  Derivatives by xi multiply a_ijk and its error
 * by i <= n.  A surface with an error has so much of P~ more.
 *
 * First, and beyond degree MOST_SHIFTED alone, each term a x^i y^j z^k by itself: it lies between a times the
 * ends of the product of the three powers' ranges, and P between the sums.  A term takes at most n + 4
 * roundings, the sum N: less than above.  A derivative by x is taken times |x|'s bound r, since
 * r |i a r^(i-1)| <= n |a| r^i: its error is at most n times P's, as above.
 *
 * Underflow and overflow.  Let L = max(1, r), n <= 64, N < 2^16; coefficients are at most 1.  A shifted one
 * of total degree d is at most 2^80 L^(n-d).  What underflows is off by 2^-1075: in a shift (fewer than 2^24
 * times) it counts L^n times at most, in a power of h (n times for each place) 2^80 L^n times: together less
 * than 2^-960 L^n.  L^n <= 2^900 is asked for: then nothing overflows. */
#include "../base/arithmetic.h"
#include "algsurf/enclose.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/eft.h"
#include "../base/fpenv.h"
#include "../base/options.h"
#include "../poly/interval_round.h"
#include "../surface/impl.h"
#include "region.h"

#define MOST_ROUNDS 16
#define ENOUGH 0.9            /* of a box's width: a round that leaves more has not helped much */
#define MOST_WORK 0x1p27      /* multiplications of all searches, about, */
#define SHARE 0.125           /* of which one face may take so much of what is left */
#define MOST_SHIFTED 16       /* degree: beyond it a cell's terms do alone */
#define CELL_ITSELF 512       /* multiplications in the time that a cell takes, whatever the degree */
#define FINEST 0.25           /* of the precision: a cell's size when coarser rounds no longer help */
#define OUTSIDE (1 + 0x1p-40) /* of a radius: rounding of a distance */

typedef struct cell {
    double lo[3], hi[3];
} cell;

/* A search, in natural units. */
typedef struct search {
    const algsurf_surface *surface;
    int degree;
    algsurf_part part;
    int is_sphere;
    double centre[3], radius;
    double *given, *shifted;   /* coefficients: x^i y^j z^k at place(k, j) + i */
    double share;              /* bound: rounding of a range in P~ */
    double left;               /* work that may still be done */
    double by_terms, by_shift; /* work for a cell */
    int axis, sign;            /* of the face that is looked for */
    cell *heap;                /* those that reach out farthest that way first */
    int count, room;
} search;

/* ---- the polynomial about the middle of a cell ---- */

/* Where x^0 y^j z^k stands; places of degrees above n are not used. */
static size_t place(int n, int k, int j) {
    return ((size_t)k * (size_t)(n + 1) + (size_t)j) * (size_t)(n + 1);
}

static void spread(const algsurf_surface *s, double *c) {
    for (int k = 0; k < s->level_count; k++)
        for (int j = 0; j < s->levels[k].count; j++) {
            const algsurf_row *row = s->rows + s->levels[k].first + j;
            memcpy(c + place(s->degree, k, j), s->coef + row->first, (size_t)row->length * sizeof *c);
        }
}

/* A polynomial in x of that degree about x = by. */
static void shift(double *c, int degree, double by) {
    for (int m = 0; m < degree; m++)
        for (int i = degree - 1; i >= m; i--) c[i] += by * c[i + 1];
}

/* One in x and t about t = by: powers of x are side by side, those of t `step` apart. */
static void shift_rows(double *c, int degree, double by, size_t step) {
    for (int m = 0; m < degree; m++)
        for (int i = degree - 1; i >= m; i--) {
            double *row = c + (size_t)i * step;
            for (int j = 0; j < degree - i; j++) row[j] += by * row[step + (size_t)j];
        }
}

static void shift_all(const search *s, const double middle[3]) {
    const int n = s->degree;
    double *a = s->shifted;
    memcpy(a, s->given, place(n, n + 1, 0) * sizeof *a);
    for (int k = 0; k <= n && middle[0] != 0; k++)
        for (int j = 0; j <= n - k; j++) shift(a + place(n, k, j), n - k - j, middle[0]);
    for (int k = 0; k <= n && middle[1] != 0; k++)
        shift_rows(a + place(n, k, 0), n - k, middle[1], place(n, 0, 1));
    for (int j = 0; j <= n && middle[2] != 0; j++)
        shift_rows(a + place(n, 0, j), n - j, middle[2], place(n, 1, 0));
}

/* Between low and high: a sum of terms. */
typedef struct range {
    double low, high;
} range;

/* ---- term by term ---- */

static range between(double a, double b) { return a < b ? (range){a, b} : (range){b, a}; }

static range product(range a, range b) {
    const range l = between(a.low * b.low, a.low * b.high), h = between(a.high * b.low, a.high * b.high);
    return (range){l.low < h.low ? l.low : h.low, l.high > h.high ? l.high : h.high};
}

/* t^k for lo <= t <= hi, k = 0 .. n. */
static void set_powers(double lo, double hi, int n, range *power) {
    const double least = lo > 0 ? lo : hi < 0 ? -hi : 0, most = fmax(-lo, hi);
    double low = 1, high = 1, from = 1, to = 1;
    for (int k = 0; k <= n; k++) {
        power[k] = k % 2 ? (range){from, to} : (range){low, high};
        low *= least, high *= most, from *= lo, to *= hi;
    }
}

/* P over a cell, or its derivative by coordinate d of 0 to 2: each term by itself. */
static range sum_of_ranges(const algsurf_surface *s, range power[3][ALGSURF_MAX_DEGREE + 1], int d) {
    const int dx = d == 0, dy = d == 1, dz = d == 2;
    range sum = {0, 0};
    for (int k = dz; k < s->level_count; k++)
        for (int j = dy; j < s->levels[k].count; j++) {
            const algsurf_row *row = s->rows + s->levels[k].first + j;
            const range beside = product(power[1][j - dy], power[2][k - dz]);
            for (int i = dx; i < row->length; i++) {
                const double a = s->coef[row->first + (size_t)i] * (dx ? i : dy ? j : dz ? k : 1);
                if (a == 0) continue;
                const range term = product(beside, power[0][i - dx]);
                sum.low += a * (a > 0 ? term.low : term.high);
                sum.high += a * (a > 0 ? term.high : term.low);
            }
        }
    return sum;
}

/* Does a sum of ranges show that the cell holds no point?  Derivatives times the size of their coordinate. */
static int is_empty_by_terms(const search *s, const cell *c, const double reach[3], double error) {
    range power[3][ALGSURF_MAX_DEGREE + 1];
    for (int i = 0; i < 3; i++) set_powers(c->lo[i], c->hi[i], s->degree, power[i]);
    for (int d = -1; d < (s->part == ALGSURF_PART_SINGULAR ? 3 : 0); d++) {
        const range of = sum_of_ranges(s->surface, power, d);
        const double size = d < 0 ? 1 : reach[d], off = d < 0 ? error : error * s->degree;
        if (size * of.low > off || size * of.high < -off) return 1;
    }
    return 0;
}

/* ---- about the middle ---- */

static void add_term(range *r, double a, int i, int j, int k) {
    int even = !((i | j | k) & 1), constant = (i | j | k) == 0;
    r->low += constant || !even || a < 0 ? (even ? a : -fabs(a)) : 0;
    r->high += constant || !even || a > 0 ? (even ? a : fabs(a)) : 0;
}

/* P over a cell, and its derivatives by the cell's coordinates. */
static void find_ranges(const search *s, const double half[3], range of[4]) {
    int n = s->degree;
    double z = 1;
    memset(of, 0, 4 * sizeof *of);
    for (int k = 0; k <= n; k++, z *= half[2]) {
        double y = z;
        for (int j = 0; j <= n - k; j++, y *= half[1]) {
            const double *c = s->shifted + place(n, k, j);
            double x = y;
            for (int i = 0; i <= n - k - j; i++, x *= half[0]) {
                double a = c[i] * x;
                add_term(&of[0], a, i, j, k);
                if (s->part != ALGSURF_PART_SINGULAR) continue;
                if (i > 0) add_term(&of[1], i * a, i - 1, j, k);
                if (j > 0) add_term(&of[2], j * a, i, j - 1, k);
                if (k > 0) add_term(&of[3], k * a, i, j, k - 1);
            }
        }
    }
}

/* The centre is off by what underflows. */
static int beside_sphere(const search *s, const cell *c) {
    double square = 0;
    for (int i = 0; i < 3; i++) {
        double away = fmax(c->lo[i] - s->centre[i], s->centre[i] - c->hi[i]) - 0x1p-1073;
        square += away > 0 ? away / s->radius * (away / s->radius) : 0;
    }
    return square > OUTSIDE;
}

static double middle_of(const cell *c, int i) {
    return fmin(fmax(0.5 * c->lo[i] + 0.5 * c->hi[i], c->lo[i]), c->hi[i]);
}

/* Is it sure that the cell holds no point? */
static int is_empty(search *s, const cell *c) {
    double middle[3], half[3], reach[3], largest = 1, lost = 0x1p-960;
    range of[4];
    s->left -= s->by_terms;
    if (s->is_sphere && beside_sphere(s, c)) return 1;
    for (int i = 0; i < 3; i++) {
        middle[i] = middle_of(c, i);
        half[i] = fmax(c->hi[i] - middle[i], middle[i] - c->lo[i]) * (1 + 0x1p-50);
        reach[i] = fabs(middle[i]) + half[i];
        largest = fmax(largest, reach[i]);
    }
    for (int i = 0; i < s->degree; i++) lost *= largest;
    if (!(lost < 0x1p-60)) return 0;
    double error = s->share * algsurf_i_surface_magnitude(s->surface, reach) + lost;
    if (is_empty_by_terms(s, c, reach, error)) return 1;
    if (s->degree > MOST_SHIFTED) return 0;
    s->left -= s->by_shift;
    shift_all(s, middle);
    find_ranges(s, half, of);
    for (int d = 0; d < (s->part == ALGSURF_PART_SINGULAR ? 4 : 1); d++) {
        if (of[d].low > error || of[d].high < -error) return 1;
        error = d == 0 ? error * fmax(1, s->degree) : error;
    }
    return 0;
}

/* ---- cells in the order in which they reach out ---- */

static double reach_out(const search *s, const cell *c) {
    return s->sign > 0 ? c->hi[s->axis] : -c->lo[s->axis];
}

static int push(search *s, const cell *c) {
    if (s->count == s->room) {
        int room = 2 * s->room + 64;
        cell *more = realloc(s->heap, (size_t)room * sizeof *more);
        if (!more) return 0;
        s->heap = more;
        s->room = room;
    }
    int at = s->count++;
    double reach = reach_out(s, c);
    for (; at > 0 && reach_out(s, &s->heap[(at - 1) / 2]) < reach; at = (at - 1) / 2)
        s->heap[at] = s->heap[(at - 1) / 2];
    s->heap[at] = *c;
    return 1;
}

static cell pop(search *s) {
    cell top = s->heap[0], last = s->heap[--s->count];
    double reach = reach_out(s, &last);
    int at = 0;
    for (int child; (child = 2 * at + 1) < s->count; at = child) {
        const cell *two = &s->heap[child];
        if (child + 1 < s->count && reach_out(s, two) < reach_out(s, two + 1)) child++;
        if (!(reach < reach_out(s, &s->heap[child]))) break;
        s->heap[at] = s->heap[child];
    }
    s->heap[at] = last;
    return top;
}

/* Those of the eight parts of a cell that may hold a point. */
static int push_parts(search *s, const cell *whole) {
    for (int which = 0; which < 8; which++) {
        cell part = *whole;
        for (int i = 0; i < 3; i++) *(which >> i & 1 ? &part.lo[i] : &part.hi[i]) = middle_of(whole, i);
        if (!is_empty(s, &part) && !push(s, &part)) return 0;
    }
    return 1;
}

typedef enum outcome { NO_MEMORY, EMPTY, FOUND } outcome;

/* How far what is in the box reaches out. */
static outcome find_face(search *s, const cell *box, double precision, double most, double *face) {
    const int axis = s->axis;
    double width = precision * (box->hi[axis] - box->lo[axis]), stop = s->left - most;
    s->count = 0;
    if (!is_empty(s, box) && !push(s, box)) return NO_MEMORY;
    while (s->count > 0) {
        cell first = pop(s);
        double lo = first.lo[axis], hi = first.hi[axis], middle = middle_of(&first, axis);
        if (hi - lo <= width || middle == lo || middle == hi || s->left < stop) {
            *face = s->sign > 0 ? hi : lo;
            return FOUND;
        }
        if (!push_parts(s, &first)) return NO_MEMORY;
    }
    return EMPTY;
}

/* ---- the box ---- */

static outcome find_box(search *s, double precision, cell *box) {
    double share = precision;
    for (int round = 0; round < MOST_ROUNDS && share >= FINEST * precision; round++) {
        const cell before = *box; /* for all faces, as the budget: what is symmetric gets a symmetric box */
        const double most = SHARE * s->left;
        int helped = 0;
        for (s->axis = 0; s->axis < 3; s->axis++)
            for (s->sign = -1; s->sign <= 1; s->sign += 2) {
                double *face = s->sign > 0 ? &box->hi[s->axis] : &box->lo[s->axis];
                outcome found = find_face(s, &before, share, most, face);
                if (found != FOUND) return found;
            }
        for (int i = 0; i < 3; i++) {
            if (box->lo[i] > box->hi[i]) return EMPTY; /* by two faces */
            helped |= box->hi[i] - box->lo[i] < ENOUGH * (before.hi[i] - before.lo[i]);
        }
        if (!helped) share *= 0.5;
    }
    return FOUND;
}

/* The extent's box in natural units. */
static void set_extent(search *s, const algsurf_extent *extent, cell *box) {
    int unit = s->surface->unit;
    s->is_sphere = extent->kind == ALGSURF_EXTENT_SPHERE;
    s->radius = algsurf_i_scale_up(extent->size[0], -unit);
    for (int i = 0; i < 3; i++) {
        double size = algsurf_i_scale_up(extent->size[s->is_sphere ? 0 : i], -unit);
        s->centre[i] = ldexp(extent->centre[i], -unit);
        box->lo[i] = algsurf_i_add_down(algsurf_i_scale_down(extent->centre[i], -unit), -size);
        box->hi[i] = algsurf_i_add_up(algsurf_i_scale_up(extent->centre[i], -unit), size);
    }
}

static void set_polynomial(search *s) {
    double n = s->degree, places = (n + 1) * (n + 2) * (n + 3) / 6;
    spread(s->surface, s->given);
    s->share = (16 * n + 2 * places + 32) * ALGSURF_U + s->surface->error;
    s->left = MOST_WORK;
    s->by_terms = CELL_ITSELF + 16 * n + (n > MOST_SHIFTED ? 64 : 16) * (double)s->surface->term_count;
    s->by_shift = 3 * places * (n + 1);
}

ALGSURF_I_ENTRY(algsurf_status, surface_enclose,
                (const algsurf_surface *surface, const algsurf_extent *extent, algsurf_part part,
                 double precision, double lo[3], double hi[3], int *empty),
                (surface, extent, part, precision, lo, hi, empty)) {
    cell box;
    if (!surface || !extent || !lo || !hi || !empty) return ALGSURF_E_ARGUMENT;
    search s = {.surface = algsurf_i_surface_solved(surface), .part = part};
    s.degree = s.surface->degree;
    if (surface->root) s.part = ALGSURF_PART_ALL; /* all points of c Q^k are singular */
    algsurf_status status = algsurf_i_extent_check(extent);
    if (status != ALGSURF_OK) return status;
    if (extent->kind == ALGSURF_EXTENT_ALL) return ALGSURF_E_ARGUMENT;
    if (part != ALGSURF_PART_ALL && part != ALGSURF_PART_SINGULAR) return ALGSURF_E_ARGUMENT;
    status = algsurf_i_check_number(precision, precision > 0 && precision <= 1);
    if (status != ALGSURF_OK) return status;
    size_t places = place(s.degree, s.degree + 1, 0);
    s.given = calloc(2 * places, sizeof *s.given);
    if (!s.given) return ALGSURF_E_NO_MEMORY;
    s.shifted = s.given + places;
    set_polynomial(&s);
    set_extent(&s, extent, &box);
    outcome found = find_box(&s, precision, &box);
    free(s.given);
    free(s.heap);
    if (found == NO_MEMORY) return ALGSURF_E_NO_MEMORY;
    *empty = found == EMPTY;
    for (int i = 0; i < 3 && !*empty; i++) {
        lo[i] = algsurf_i_scale_down(box.lo[i], s.surface->unit);
        hi[i] = algsurf_i_scale_up(box.hi[i], s.surface->unit);
    }
    return ALGSURF_OK;
}
