/* exact.c - Descartes' rule in exact arithmetic.
 *
 * The signs of a form's coefficients (intersect_form.h) count roots, and de Casteljau's scheme without its
 * halves bisects, exactly.  A cell is found again from the whole interval, so that only one is kept.
 *
 * Bisection ends DEPTH deep.  Where [lo,hi] is long against the place left open then, that place becomes an
 * interval of its own, between doubles, and so does what lies on either side of it.
 *
 * A multiple root is decided only where it is an end of a cell.  Rays that were made to touch mostly do so at
 * numbers of few binary digits: where the simplest one in [lo,hi] is a root, it cuts the interval in two. */
#include "exact.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "form.h"

enum {
    DEPTH = 60,      /* of bisection */
    MOST_PARTS = 99, /* of an interval: 33 places set apart, one in the other, differ by 2^1980 in size */
    GAIN = 12        /* bits by which a place must be shorter than its interval to be worth a new one */
};

typedef struct task {
    const algsurf_ray *ray;
    algsurf_i_ray_form f; /* right holds the cell at hand, left its left half */
    int open_lo;          /* a root at lo is not looked for */
    algsurf_i_want want;
    algsurf_i_exact_root *roots;
    int count;
    int parts;                               /* that the interval has been cut into, or is to be */
    signed char on_face[ALGSURF_MOST_FACES]; /* does its form divide P: 1, 0; -1: not asked yet */
    double place_lo, place_hi; /* what is to be an interval of its own, if place_lo <= place_hi */
} task;

/* A cell [position, position + 1] 2^-depth of [0,1]. */
typedef struct place {
    uint64_t position;
    int depth;
} place;

static uint32_t *entry(const task *t, uint32_t *form, int k) { return algsurf_i_form_entry(&t->f, form, k); }

/* Variations of sign: roots inside, or more by an even number; -1 when all coefficients are 0. */
static int variations(const task *t, uint32_t *form) {
    int last = 0, count = 0, any = 0;
    for (int k = 0; k <= t->f.n; k++) {
        int sign = algsurf_i_integer_sign(entry(t, form, k), t->f.size);
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
        memcpy(entry(t, left, i), right, (size_t)t->f.size * sizeof *left);
        algsurf_i_integer_shift(entry(t, left, i), t->f.size, n - i);
        for (int j = 0; j < n - i; j++)
            algsurf_i_integer_add(entry(t, right, j), entry(t, right, j + 1), t->f.size);
        algsurf_i_integer_shift(entry(t, right, n - i), t->f.size, n - i);
    }
}

static void halve(const task *t) { halve_form(t, t->f.n, t->f.left, t->f.right); }

static void keep_left(const task *t) {
    memcpy(t->f.right, t->f.left, (size_t)(t->f.n + 1) * (size_t)t->f.size * sizeof *t->f.left);
}

static void find_cell(const task *t, place at) {
    memcpy(t->f.right, t->f.p, (size_t)(t->f.n + 1) * (size_t)t->f.size * sizeof *t->f.left);
    for (int bit = at.depth - 1; bit >= 0; bit--) {
        halve(t);
        if (!(at.position >> bit & 1)) keep_left(t);
    }
}

/* Signs of the Bernstein coefficients of a face's form over a cell. */
typedef struct signs {
    int least, most;
    int left, right; /* those at the ends */
} signs;

static signs signs_in_cell(const task *t, int face, place at) {
    int m = t->f.face_degree;
    uint32_t *left = t->f.part, *right = entry(t, t->f.part, m + 1);
    const size_t bytes = (size_t)(m + 1) * (size_t)t->f.size * sizeof *left;
    memcpy(right, algsurf_i_form_face(&t->f, face), bytes);
    for (int bit = at.depth - 1; bit >= 0; bit--) {
        halve_form(t, m, left, right);
        if (!(at.position >> bit & 1)) memcpy(right, left, bytes);
    }
    signs s = {1, -1, 0, 0};
    for (int k = 0; k <= m; k++) {
        int sign = algsurf_i_integer_sign(entry(t, right, k), t->f.size);
        s.least = sign < s.least ? sign : s.least;
        s.most = sign > s.most ? sign : s.most;
        if (k == 0) s.left = sign;
        s.right = sign;
    }
    return s;
}

/* The right end of all is none of a cell's left ends. */
static int sign_at_left(const task *t, int face, place at) {
    if (!(at.position >> at.depth)) return signs_in_cell(t, face, at).left;
    return algsurf_i_integer_sign(entry(t, algsurf_i_form_face(&t->f, face), t->f.face_degree), t->f.size);
}

typedef enum part_of_cell { INNER_POINTS, LEFT_END, ALL_POINTS, THE_ROOT } part_of_cell;

/* Is a root of P, the only one in a cell in which a face's form changes sign, on that face? */
static int is_on_face(task *t, int face) {
    if (t->on_face[face] < 0) t->on_face[face] = (signed char)algsurf_i_face_divides(&t->f, face);
    return t->on_face[face];
}

/* Are these points of a cell in the extent?  1: all, -1: none, 0: some may be. */
static int in_extent(task *t, place at, part_of_cell part) {
    int answer = 1;
    for (int face = 0; face < t->f.faces; face++) {
        if (part == LEFT_END) {
            if (sign_at_left(t, face, at) < 0) return -1;
            continue;
        }
        signs s = signs_in_cell(t, face, at);
        int outer_end = s.left < 0 && s.right < 0;
        if (s.least < 0 && s.most <= 0 && (part != ALL_POINTS || outer_end)) return -1;
        if (s.least >= 0 || (part == THE_ROOT && s.left * s.right < 0 && is_on_face(t, face))) continue;
        answer = 0;
    }
    return answer;
}

static double end_size(double end) { return isinf(end) ? 0 : fabs(end); }

/* t at a position, with a relative error of 2^-90 of what it is added to; infinite where it is beyond the
 * range of double.  In units of 2^64 where the intermediate results could be. */
static algsurf_dd t_at(const task *t, uint64_t position, int depth) {
    const algsurf_i_ray_form *f = &t->f;
    uint64_t whole = (uint64_t)1 << depth;
    algsurf_dd before = algsurf_two_sum(ldexp((double)(position >> 32), 32), (double)(uint32_t)position), at;
    algsurf_dd behind =
        algsurf_two_sum(ldexp((double)((whole - position) >> 32), 32), (double)(uint32_t)(whole - position));
    int up = fmax(end_size(f->lo), end_size(f->hi)) >= 0x1p900 ? 64 : 0;
    double unit = ldexp(1, f->far - up), lo = ldexp(f->lo, -up), hi = ldexp(f->hi, -up);
    if ((position == 0 && isinf(lo)) || (position == whole && isinf(hi)))
        return algsurf_dd_from(position == 0 ? lo : hi);
    if (isinf(hi))
        at = algsurf_dd_add_d(algsurf_dd_scale(algsurf_dd_div(before, behind), unit), lo);
    else if (isinf(lo))
        at = algsurf_dd_add_d(algsurf_dd_scale(algsurf_dd_div(behind, before), -unit), hi);
    else
        at = algsurf_dd_add_d(
            algsurf_dd_mul(algsurf_two_sum(hi, -lo), algsurf_dd_scale(before, ldexp(1, -depth))), lo);
    if (isinf(ldexp(at.hi, up))) return algsurf_dd_from(ldexp(at.hi, up));
    return (algsurf_dd){ldexp(at.hi, up), ldexp(at.lo, up)};
}

/* Moved outward by more than the error of t_at. */
static double outward(const task *t, algsurf_dd at, int side) {
    if (isinf(at.hi)) return side * at.hi > 0 ? at.hi : copysign(DBL_MAX, at.hi);
    double error = 0x1p-85 * fabs(at.hi) + 0x1p-85 * end_size(t->f.lo) + 0x1p-85 * end_size(t->f.hi);
    double moved = nextafter(at.hi + side * error, side * HUGE_VAL);
    return fmin(fmax(nextafter(moved, side * HUGE_VAL), t->f.lo), t->f.hi);
}

/* A cell is as narrow as bisection makes it: is it so much shorter than [lo,hi] that it is worth an interval
 * of its own?  Then it is noted. */
static int set_apart(task *t, place at) {
    double lo = outward(t, t_at(t, at.position, at.depth), -1);
    double hi = outward(t, t_at(t, at.position + 1, at.depth), 1);
    double size = fmax(end_size(t->f.lo), end_size(t->f.hi));
    int gained;
    if (lo == hi || t->parts >= MOST_PARTS) return 0;
    if (isinf(lo) || isinf(hi))
        gained = fmax(end_size(lo), end_size(hi)) >= ldexp(fmax(size, 1), GAIN);
    else
        gained = isinf(t->f.lo) || isinf(t->f.hi) || hi - lo <= ldexp(t->f.hi - t->f.lo, -GAIN);
    if (!gained) return 0;
    t->parts += 3;
    t->place_lo = lo;
    t->place_hi = hi;
    return 1;
}

/* When there is no room the last one grows, and is uncertain. */
static void add_root(task *t, int state, algsurf_status reason, place from, uint64_t length) {
    part_of_cell part = state == ALGSURF_HIT ? THE_ROOT : INNER_POINTS;
    if (length == 0) part = LEFT_END;
    if (reason == ALGSURF_UNDECIDED_ZERO) part = ALL_POINTS;
    int inside = in_extent(t, from, part);
    if (inside < 0) return;
    if (inside == 0 && state == ALGSURF_HIT) {
        state = ALGSURF_UNCERTAIN;
        reason = ALGSURF_UNDECIDED_END;
    }
    algsurf_dd lo = t_at(t, from.position, from.depth), hi = t_at(t, from.position + length, from.depth);
    algsurf_i_exact_root root = {state, reason, outward(t, lo, -1), outward(t, hi, 1),
                                 algsurf_dd_scale(algsurf_dd_add(lo, hi), 0.5)};
    if (isinf(lo.hi)) root.t = hi;
    if (part == ALL_POINTS && !isinf(lo.hi)) root.t = lo; /* each of them is a root, this the first */
    if (isinf(hi.hi)) root.t = lo;
    if (isinf(root.t.hi)) root.t = algsurf_dd_from(copysign(DBL_MAX, root.t.hi));
    if (t->count <= t->f.n) {
        t->roots[t->count++] = root;
        return;
    }
    t->roots[t->f.n].state = ALGSURF_UNCERTAIN;
    t->roots[t->f.n].reason = ALGSURF_UNDECIDED_MULTIPLE;
    t->roots[t->f.n].hi = root.hi;
}

/* Narrows a cell with one root inside, until its ends are neighbours as doubles, and it is known whether the
 * root is in the extent. */
static void add_bracket(task *t, place at) {
    while (at.depth < DEPTH) {
        algsurf_dd lo = t_at(t, at.position, at.depth), hi = t_at(t, at.position + 1, at.depth);
        if (nextafter(lo.hi, HUGE_VAL) >= hi.hi && in_extent(t, at, THE_ROOT) != 0) break;
        halve(t);
        at.depth++;
        at.position *= 2;
        if (variations(t, t->f.left) == 1) {
            keep_left(t);
        } else {
            at.position++;
            if (algsurf_i_integer_sign(t->f.right, t->f.size) != 0) continue;
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
        if (left_end && algsurf_i_integer_sign(t->f.right, t->f.size) == 0 &&
            !(at.position == 0 && (t->open_lo || isinf(t->f.lo))))
            add_root(t, ALGSURF_HIT, ALGSURF_OK, at, 0);
        if (satisfied(t)) return;
        int count = variations(t, t->f.right);
        if (count == 1) add_bracket(t, at);
        if (count > 1 && at.depth == DEPTH && !set_apart(t, at))
            add_root(t, ALGSURF_UNCERTAIN, ALGSURF_UNDECIDED_MULTIPLE, at, 1);
        if (count <= 1 || at.depth == DEPTH) return;
        halve(t);
        at = (place){2 * at.position, at.depth + 1};
        left_end = variations(t, t->f.left) == 0;
        if (left_end) {
            at.position++;
        } else {
            later[(*waiting)++] = (place){at.position + 1, at.depth};
            keep_left(t);
        }
    }
}

/* The multiple of the highest power of two between lo and hi; an end when there is none. */
static double simplest_between(double lo, double hi) {
    if (hi <= 0) return -simplest_between(-hi, -lo);
    if (lo < 0) return 0;
    for (int k = ilogb(hi); k >= ilogb(hi) - 53; k--) {
        double c = ldexp(floor(ldexp(lo, -k)) + 1, k);
        if (c < hi) return c;
    }
    return lo;
}

/* Is there a root at the simplest number inside?  Then that is the place to set apart. */
static int set_simplest_apart(task *t) {
    double lo = t->f.lo, hi = t->f.hi;
    if (isinf(lo) || isinf(hi) || t->parts >= MOST_PARTS) return 0;
    double c = simplest_between(lo, hi);
    if (!(lo < c && c < hi) || algsurf_i_exact_sign(t->f.surface, t->ray, c) != 0) return 0;
    t->parts += 3;
    t->place_lo = t->place_hi = c;
    return 1;
}

static void search(task *t) {
    place later[DEPTH + 1] = {{0, 0}};
    int waiting = 1;
    const uint32_t *end = entry(t, t->f.p, t->f.n);
    if (t->f.lo == t->f.hi) {
        if (!t->open_lo && variations(t, t->f.p) < 0) add_root(t, ALGSURF_HIT, ALGSURF_OK, later[0], 0);
        return;
    }
    if (variations(t, t->f.p) < 0) {
        add_root(t, ALGSURF_UNCERTAIN, ALGSURF_UNDECIDED_ZERO, later[0], 1);
        return;
    }
    if (variations(t, t->f.p) > 1 && set_simplest_apart(t)) return;
    while (waiting > 0 && !satisfied(t)) {
        place at = later[--waiting];
        find_cell(t, at);
        search_cell(t, at, later, &waiting);
    }
    if (!satisfied(t) && !isinf(t->f.hi) && algsurf_i_integer_sign(end, t->f.size) == 0)
        add_root(t, ALGSURF_HIT, ALGSURF_OK, (place){1, 0}, 0);
}

/* [lo,hi], or (lo,hi]; what has been set apart, and what is beside it, each in its turn. */
static int solve_parts(task *t, double lo, double hi, int open_lo) {
    int before = t->count;
    t->f.lo = lo;
    t->f.hi = hi;
    t->open_lo = open_lo;
    forget_place(t);
    if (!algsurf_i_ray_form_make(&t->f, t->ray)) return 0;
    search(t);
    algsurf_i_ray_form_free(&t->f);
    if (!set_a_place_apart(t)) return 1;
    double from = t->place_lo, to = t->place_hi;
    t->count = before;
    forget_place(t);
    if (lo < from && !solve_parts(t, lo, from, open_lo)) return 0;
    if (!satisfied(t) && !solve_parts(t, from, to, lo < from || open_lo)) return 0;
    return satisfied(t) || to >= hi || solve_parts(t, to, hi, 1);
}

int algsurf_i_exact_roots(const algsurf_surface *surface, const algsurf_ray *ray,
                          const algsurf_extent *extent, double lo, double hi, algsurf_i_want want,
                          algsurf_i_exact_root *roots) {
    task t = {.ray = ray, .want = want, .roots = roots};
    memset(t.on_face, -1, sizeof t.on_face);
    t.f.surface = surface;
    t.f.extent = extent;
    t.f.depth = DEPTH;
    return solve_parts(&t, lo, hi, 0) ? t.count : -1;
}
