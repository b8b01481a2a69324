/* enclose.c - a box about the points of a surface: branch and bound on cells.
 *
 * For each of the six faces of the box cells wait in the order in which they reach out that way (Skelboe
 * 1974). The first one is tried: where P, or with it a derivative, has one sign throughout it holds no point
 * and goes; else it is cut in eight.  When the first one is small nothing reaches out farther.  Then all
 * begins anew in the box that was found, until that no longer helps much: so no search has to go deep.
 *
 * Sign over a cell.  With x = c + h xi, |xi_i| <= 1, P is the sum of a_ijk xi^i eta^j zeta^k; beside a_000 a
 * term with even exponents lies between 0 and a_ijk, any other between +-a_ijk.
 *
 * Rounding.  Let P~(r) be P with magnitudes of coefficients at r = |c| + h.  Each of the three shifts gives a
 * coefficient at most 2n roundings, the powers of h take n + 2 more each, and at most N terms are added: what
 * is computed of the range is off by less than (6n + 3(n + 2) + N) u P~(r) (1 + ...), and 16 n + 2 N + 32
 * covers P~, which is rounded itself (3n + N), and the dots.  Derivatives by xi multiply a_ijk and its error
 * by i <= n.  A surface with an error has so much of P~ more.  What underflows is at most 2^-1074 a step,
 * multiplied by coordinates: below 2^-1000 max(1, r)^n. */
#include "../base/arithmetic.h"
#include "algsurf/enclose.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/eft.h"
#include "../base/fpenv.h"
#include "../surface/impl.h"
#include "ray_impl.h"

#define MOST_ROUNDS 16
#define ENOUGH 0.9           /* of a box's width: a round that leaves more has not helped much */
#define MOST_WORK 0x1p27      /* multiplications of all searches, about */
#define OUTSIDE (1 + 0x1p-40) /* of a radius: rounding of a distance */

typedef struct cell {
    double middle[3], half[3];
} cell;

/* A search, in natural units. */
typedef struct search {
    const algsurf_surface *surface;
    int degree, part;
    int is_sphere;
    double centre[3], radius;
    double *given, *shifted; /* coefficients: x^i y^j z^k at place(k, j) + i */
    double share;            /* bound: rounding of a range in P~ */
    int most_cells;          /* for each face */
    cell *heap;
    int count, room;
} search;

/* ---- the polynomial about the middle of a cell ---- */

/* Of the places with powers z^0 .. z^(k-1), all x and y. */
static size_t level_place(int n, int k) {
    size_t all = (size_t)(n + 1) * (size_t)(n + 2) * (size_t)(n + 3) / 6, left = (size_t)(n - k);
    return all - (left + 1) * (left + 2) * (left + 3) / 6;
}

static size_t place(int n, int k, int j) {
    size_t side = (size_t)(n - k);
    return level_place(n, k) + (size_t)j * (side + 1) - (size_t)j * (size_t)(j > 0 ? j - 1 : 0) / 2;
}

static void spread(const algsurf_surface *s, double *c) {
    for (int k = 0; k < s->level_count; k++)
        for (int j = 0; j < s->levels[k].count; j++) {
            const algsurf_row *row = s->rows + s->levels[k].first + j;
            memcpy(c + place(s->degree, k, j), s->coef + row->first, (size_t)row->length * sizeof *c);
        }
}

/* A polynomial in t of that degree, its coefficients `to` apart from one another, about t = by. */
static void shift(double *c, int degree, double by, const size_t *to) {
    for (int m = 0; m < degree; m++)
        for (int i = degree - 1; i >= m; i--) c[to[i]] += by * c[to[i + 1]];
}

static void shift_all(const search *s, const double middle[3]) {
    int n = s->degree;
    double *a = s->shifted;
    size_t along[ALGSURF_MAX_DEGREE + 1];
    memcpy(a, s->given, level_place(n, n + 1) * sizeof *a);
    for (int i = 0; i <= n; i++) along[i] = (size_t)i;
    for (int k = 0; k <= n && middle[0] != 0; k++)
        for (int j = 0; j <= n - k; j++) shift(a + place(n, k, j), n - k - j, middle[0], along);
    for (int k = 0; k <= n && middle[1] != 0; k++) {
        for (int j = 0; j <= n - k; j++) along[j] = place(n, k, j);
        for (int i = 0; i <= n - k; i++) shift(a + i, n - k - i, middle[1], along);
    }
    for (int j = 0; j <= n && middle[2] != 0; j++) {
        for (int k = 0; k <= n - j; k++) along[k] = place(n, k, j);
        for (int i = 0; i <= n - j; i++) shift(a + i, n - j - i, middle[2], along);
    }
}

/* P~ at r. */
static double magnitude(const search *s, const double r[3]) {
    int n = s->degree;
    double sum = 0;
    for (int k = n; k >= 0; k--) {
        double level = 0;
        for (int j = n - k; j >= 0; j--) {
            const double *c = s->given + place(n, k, j);
            double row = 0;
            for (int i = n - k - j; i >= 0; i--) row = row * r[0] + fabs(c[i]);
            level = level * r[1] + row;
        }
        sum = sum * r[2] + level;
    }
    return sum;
}

/* Between low and high: a sum of terms. */
typedef struct range {
    double low, high;
} range;

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

static int beside_sphere(const search *s, const cell *c) {
    double square = 0;
    for (int i = 0; i < 3; i++) {
        double away = fmax(0, fabs(c->middle[i] - s->centre[i]) - c->half[i]);
        square += away * away;
    }
    return square > s->radius * s->radius * OUTSIDE;
}

/* Is it sure that the cell holds no point? */
static int is_empty(const search *s, const cell *c) {
    double reach[3], largest = 1;
    range of[4];
    if (s->is_sphere && beside_sphere(s, c)) return 1;
    for (int i = 0; i < 3; i++) {
        reach[i] = fabs(c->middle[i]) + c->half[i];
        largest = fmax(largest, reach[i]);
    }
    shift_all(s, c->middle);
    find_ranges(s, c->half, of);
    double error = s->share * magnitude(s, reach) + 0x1p-1000 * pow(largest, s->degree);
    for (int d = 0; d < (s->part == ALGSURF_PART_SINGULAR ? 4 : 1); d++) {
        if (of[d].low > error || of[d].high < -error) return 1;
        error = d == 0 ? error * fmax(1, s->degree) : error;
    }
    return 0;
}

/* ---- cells in the order in which they reach out ---- */

static double reach_out(const cell *c, int axis, int sign) { return sign * c->middle[axis] + c->half[axis]; }

static int push(search *s, const cell *c, int axis, int sign) {
    if (s->count == s->room) {
        int room = 2 * s->room + 64;
        cell *more = realloc(s->heap, (size_t)room * sizeof *more);
        if (!more) return 0;
        s->heap = more;
        s->room = room;
    }
    int at = s->count++;
    double reach = reach_out(c, axis, sign);
    for (; at > 0 && reach_out(&s->heap[(at - 1) / 2], axis, sign) < reach; at = (at - 1) / 2)
        s->heap[at] = s->heap[(at - 1) / 2];
    s->heap[at] = *c;
    return 1;
}

static cell pop(search *s, int axis, int sign) {
    cell top = s->heap[0], last = s->heap[--s->count];
    double reach = reach_out(&last, axis, sign);
    int at = 0;
    for (int child; (child = 2 * at + 1) < s->count; at = child) {
        if (child + 1 < s->count &&
            reach_out(&s->heap[child], axis, sign) < reach_out(&s->heap[child + 1], axis, sign))
            child++;
        if (!(reach < reach_out(&s->heap[child], axis, sign))) break;
        s->heap[at] = s->heap[child];
    }
    s->heap[at] = last;
    return top;
}

/* Those of the eight parts of a cell that may hold a point. */
static int push_parts(search *s, const cell *whole, int axis, int sign) {
    for (int which = 0; which < 8; which++) {
        cell part;
        for (int i = 0; i < 3; i++) {
            part.half[i] = 0.5 * whole->half[i];
            part.middle[i] = whole->middle[i] + (which >> i & 1 ? part.half[i] : -part.half[i]);
        }
        if (!is_empty(s, &part) && !push(s, &part, axis, sign)) return 0;
    }
    return 1;
}

typedef enum outcome { NO_MEMORY, EMPTY, FOUND } outcome;

/* How far what is in the cell reaches out. */
static outcome find_face(search *s, const cell *whole, int axis, int sign, double width, double *face) {
    s->count = 0;
    if (!is_empty(s, whole) && !push(s, whole, axis, sign)) return NO_MEMORY;
    for (int cells = 0; s->count > 0; cells++) {
        cell first = pop(s, axis, sign);
        if (2 * first.half[axis] <= width || cells >= s->most_cells) {
            *face = sign * reach_out(&first, axis, sign);
            return FOUND;
        }
        if (!push_parts(s, &first, axis, sign)) return NO_MEMORY;
    }
    return EMPTY;
}

/* ---- the box ---- */

/* From lo to hi, rounded outward. */
static cell cell_between(const double lo[3], const double hi[3]) {
    cell c;
    for (int i = 0; i < 3; i++) {
        c.middle[i] = 0.5 * lo[i] + 0.5 * hi[i];
        c.half[i] = fmax(hi[i] - c.middle[i], c.middle[i] - lo[i]) * (1 + 0x1p-50);
    }
    return c;
}

/* Pushes in each face once; *helped: some width is much smaller now. */
static outcome push_faces(search *s, double precision, double lo[3], double hi[3], int *helped) {
    const cell whole = cell_between(lo, hi);
    *helped = 0;
    for (int axis = 0; axis < 3; axis++) {
        double width = hi[axis] - lo[axis], face[2] = {lo[axis], hi[axis]};
        for (int side = 0; side < 2; side++) {
            outcome found = find_face(s, &whole, axis, side ? 1 : -1, precision * width, &face[side]);
            if (found != FOUND) return found;
        }
        lo[axis] = fmax(lo[axis], face[0]);
        hi[axis] = fmax(lo[axis], fmin(hi[axis], face[1]));
        *helped |= hi[axis] - lo[axis] < ENOUGH * width;
    }
    return FOUND;
}

static outcome find_box(search *s, double precision, double lo[3], double hi[3]) {
    outcome found = FOUND;
    int helped = 1;
    for (int round = 0; round < MOST_ROUNDS && helped && found == FOUND; round++)
        found = push_faces(s, precision, lo, hi, &helped);
    return found;
}

static int has_good_part(int part) { return part == ALGSURF_PART_ALL || part == ALGSURF_PART_SINGULAR; }

static void set_extent(search *s, const algsurf_extent *extent, double lo[3], double hi[3]) {
    int unit = s->surface->unit;
    s->is_sphere = extent->kind == ALGSURF_EXTENT_SPHERE;
    s->radius = ldexp(extent->size[0], -unit);
    for (int i = 0; i < 3; i++) {
        double half = ldexp(extent->size[s->is_sphere ? 0 : i], -unit);
        s->centre[i] = ldexp(extent->centre[i], -unit);
        lo[i] = s->centre[i] - half;
        hi[i] = s->centre[i] + half;
    }
}

static void set_polynomial(search *s) {
    size_t places = level_place(s->degree, s->degree + 1);
    spread(s->surface, s->given);
    s->share = (16 * s->degree + 2 * (double)places + 32) * ALGSURF_U + s->surface->error;
    s->most_cells = (int)fmax(8, MOST_WORK / (6 * 8 * MOST_ROUNDS * 3.0 * (double)places * (s->degree + 1)));
}

static ALGSURF_NOINLINE algsurf_status enclose(const algsurf_surface *surface, const algsurf_extent *extent,
                                               int part, double precision, double lo[3], double hi[3],
                                               int *empty) {
    double low[3], high[3];
    search s = {.surface = surface, .degree = surface->degree, .part = part};
    algsurf_status status = algsurf_i_extent_check(extent);
    if (status != ALGSURF_OK) return status;
    if (extent->kind == ALGSURF_EXTENT_ALL || !has_good_part(part) || !(precision > 0 && precision <= 1))
        return ALGSURF_E_ARGUMENT;
    size_t places = level_place(s.degree, s.degree + 1);
    s.given = calloc(2 * places, sizeof *s.given);
    if (!s.given) return ALGSURF_E_NO_MEMORY;
    s.shifted = s.given + places;
    set_polynomial(&s);
    set_extent(&s, extent, low, high);
    outcome found = find_box(&s, precision, low, high);
    free(s.given);
    free(s.heap);
    if (found == NO_MEMORY) return ALGSURF_E_NO_MEMORY;
    *empty = found == EMPTY;
    for (int i = 0; i < 3 && !*empty; i++) {
        lo[i] = ldexp(low[i], surface->unit);
        hi[i] = ldexp(high[i], surface->unit);
    }
    return ALGSURF_OK;
}

algsurf_status algsurf_surface_enclose(const algsurf_surface *surface, const algsurf_extent *extent, int part,
                                       double precision, double lo[3], double hi[3], int *empty) {
    if (!surface || !extent || !lo || !hi || !empty) return ALGSURF_E_ARGUMENT;
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = enclose(surface, extent, part, precision, lo, hi, empty);
    algsurf_fpenv_leave(&saved);
    return status;
}
