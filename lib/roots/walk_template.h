/* walk_template.h - Descartes' rule along the line, for one number type.
 *
 * The includer defines NUMBER, UNIT (bound on the relative error of one operation), FLOOR (the
 * narrowest cell), CLUSTERS (1: it takes short ways to and around them), the names WALK, WALK_BEGIN,
 * WALK_NEXT, and the operations num_add, num_mul, num_mul_d, num_from, num_from_dd, num_hi, num_ratio (by an
 * int), num_quotient (of positions).
 *
 * Positions in a piece are whole numbers, 0 .. WHOLE = 2^62: they are exact, and so are differences.
 *
 * Error bounds.  Bernstein coefficients over a cell carry one bound R for all of them:
 *   - from the power basis: b_j is the blossom of q at ends of the piece, hence at most
 *     sum |c_k| m^k in size, m = max(|lo|,|hi|).  A step of the scheme rounds at most 7 times (weight,
 *     end, their product, two products, two sums), so after n steps, to first order, the error is
 *     below 7 n UNIT sum |c_k| m^k; 8 (n+1) UNIT takes in the higher orders.  Radii add sum r_k m^k.
 *   - de Casteljau at ratio r takes convex combinations: R is kept; each level rounds (r known to 4
 *     UNIT) by at most 8 UNIT max|b|, and by 1 UNIT when r = 1/2.
 * A sign is known when |b_j| > R.
 * Underflow: fewer than 2^20 operations lose at most 2^-1074 each, multiplied by factors that are at
 * most 2^64 together (|v| <= ALGSURF_CUT, weights at most 1).
 */
#define UNDERFLOW 0x1p-990
#define WHOLE ((int64_t)1 << 62)

/* Power basis to Bernstein basis over [lo,hi]: Horner's rule for sum c_k (lo (1-v) + hi v)^k in
 * normalised Bernstein form, where the constant c_k has all coefficients c_k. */
static void to_bernstein(const NUMBER *c, int n, algsurf_dd lo, algsurf_dd hi, NUMBER *b) {
    NUMBER a = num_from_dd(lo), z = num_from_dd(hi);
    b[0] = c[n];
    for (int m = 1; m <= n; m++) {
        NUMBER am = num_ratio(a, m), zm = num_ratio(z, m);
        b[m] = num_add(num_mul(num_mul_d(zm, m), b[m - 1]), c[n - m]);
        for (int j = m - 1; j > 0; j--)
            b[j] = num_add(num_add(num_mul(num_mul_d(am, m - j), b[j]), num_mul(num_mul_d(zm, j), b[j - 1])),
                           c[n - m]);
        b[0] = num_add(num_mul(num_mul_d(am, m), b[0]), c[n - m]);
    }
}

static NUMBER lerp(NUMBER a, NUMBER b, NUMBER ra, NUMBER rb) {
    return num_add(num_mul(ra, a), num_mul(rb, b));
}

/* The part of w left of the ratio part / whole, in place. */
static void keep_left(NUMBER *w, int n, int64_t part, int64_t whole) {
    if (2 * part == whole) {
        for (int i = 1; i <= n; i++)
            for (int j = n; j >= i; j--) w[j] = num_mul_d(num_add(w[j - 1], w[j]), 0.5);
        return;
    }
    NUMBER rb = num_quotient(part, whole), ra = num_add(num_from(1), num_mul_d(rb, -1));
    for (int i = 1; i <= n; i++)
        for (int j = n; j >= i; j--) w[j] = lerp(w[j - 1], w[j], ra, rb);
}

/* The part of w right of the position p, in place. */
static void keep_right(NUMBER *w, int n, int64_t p) {
    NUMBER rb = num_quotient(p, WHOLE), ra = num_quotient(WHOLE - p, WHOLE);
    for (int i = 1; i <= n; i++)
        for (int j = 0; j <= n - i; j++) w[j] = lerp(w[j], w[j + 1], ra, rb);
}

static double largest_of(const NUMBER *w, int n) {
    double largest = 0;
    for (int j = 0; j <= n; j++) {
        double a = fabs(num_hi(w[j]));
        largest = a > largest ? a : largest;
    }
    return largest;
}

/* Coefficients over [p,q] of the piece, from those over all of it. */
static void cut(WALK *walk, int64_t p, int64_t q) {
    int n = walk->degree, cuts = (p > 0) + (q < WHOLE);
    for (int j = 0; j <= n; j++) walk->w[j] = walk->b[j];
    if (p > 0) keep_right(walk->w, n, p);
    if (q < WHOLE) keep_left(walk->w, n, q - p, WHOLE - p);
    walk->cell_radius = walk->radius;
    if (walk->bounded) walk->cell_radius += 8 * UNIT * n * cuts * walk->largest;
}

typedef struct signs {
    int most;        /* largest number of variations that the unknown signs allow */
    int unknown;     /* how many are unknown */
    int first, last; /* sign at the ends, 0: unknown, or zero */
} signs;

/* Variations of sign; `zero_first`, `zero_last`: that coefficient is exactly zero and does not count. */
static signs count_signs(const NUMBER *w, int n, double radius, int zero_first, int zero_last) {
    signs s = {0, 0, 0, 0};
    int plus = 0, minus = 0; /* most variations so far, if the last sign is + (-) */
    int any = 0;
    for (int j = zero_first; j <= n - zero_last; j++) {
        double value = num_hi(w[j]);
        int sign = (value > radius) - (value < -radius);
        int to_plus = any && minus + 1 > plus ? minus + 1 : plus;
        int to_minus = any && plus + 1 > minus ? plus + 1 : minus;
        plus = sign >= 0 ? to_plus : -n - 2;
        minus = sign <= 0 ? to_minus : -n - 2;
        s.unknown += sign == 0;
        s.last = sign;
        if (!any) s.first = sign;
        any = 1;
    }
    s.most = plus > minus ? plus : minus;
    if (s.most == 0 && s.unknown > n - zero_first - zero_last) s.most = 1; /* it may vanish, or does */
    if (zero_first) s.first = 0;
    if (zero_last) s.last = 0;
    return s;
}

/* May the polynomial exceed the radius within an eighth of the cell from its right end?  Judged by its first
 * and second derivatives there; a wrong guess costs time, or an undecided cell, and no more. */
static int is_clear_nearby(const NUMBER *w, int n, double radius) {
    double last = num_hi(w[n]), slope = n > 0 ? last - num_hi(w[n - 1]) : 0;
    double bend = n > 1 ? slope - (num_hi(w[n - 1]) - num_hi(w[n - 2])) : 0;
    return fabs(last) + n / 8.0 * fabs(slope) + n * n / 128.0 * fabs(bend) > radius;
}

/* Shrinks the cell [p,q] to its left part; returns the new right end.  The split is moved off the middle when
 * the sign there is unknown, for a root may sit exactly on it, unless it seems to be unknown all around. */
static int64_t split(WALK *walk, int64_t p, int64_t q) {
    static const int sixteenths[] = {8, 7, 9, 6};
    int n = walk->degree;
    int64_t middle = p + (q - p) / 2;
    if (walk->bounded) walk->cell_radius += (2 * middle == p + q ? 1 : 8) * UNIT * n * largest_of(walk->w, n);
    keep_left(walk->w, n, middle - p, q - p);
    if (!is_clear_nearby(walk->w, n, walk->cell_radius)) return middle;
    for (int i = 1; i < 4 && fabs(num_hi(walk->w[n])) <= walk->cell_radius; i++) {
        middle = p + (q - p) / 16 * sixteenths[i];
        cut(walk, p, middle);
    }
    return middle;
}

/* A short way to a cluster of as many roots as the cell [p,q] has variations: Newton's method for a root of
 * that multiplicity, from both ends (Schroeder's; Sagraloff, Mehlhorn, Computing real roots of real
 * polynomials, 2016).  The two agree the better the narrower the cell is against the distance of other roots.
 * Returns a position as far left of both as they are apart, or where signs are known still, if that is
 * further; and *width, three times that.  0: the cell is too wide, or too narrow, for that to gain much. */
static int64_t leap(const WALK *walk, int64_t p, int64_t q, int variations, int64_t *width) {
    const double w0 = num_hi(walk->w[0]), wn = num_hi(walk->w[walk->degree]), m = variations;
    double slope_lo = walk->degree * (num_hi(walk->w[1]) - w0);
    double slope_hi = walk->degree * (wn - num_hi(walk->w[walk->degree - 1]));
    double one = -m * w0 / slope_lo, two = 1 - m * wn / slope_hi, length = (double)(q - p);
    double unclear = pow(8 * walk->cell_radius / fmin(fabs(w0), fabs(wn)), 1 / m);
    double apart = fmax(fmax(fabs(one - two), 0x1p-24), unclear), from = fmin(one, two) - apart;
    if (!(apart < 0x1p-5 && from > 0 && from + 3 * apart < 1) || apart * length < (double)FLOOR) return 0;
    int64_t unit = (int64_t)1 << ilogb(apart * length); /* in which the ends of cells stay short numbers */
    *width = 8 * unit;
    return (p + (int64_t)(from * length)) / unit * unit;
}

/* Tries it.  If nothing is left of it, the walk goes on from there. */
static int leaps(WALK *walk, int64_t p, int64_t q, int variations, int zero_lo) {
    int64_t width = 0, near = leap(walk, p, q, variations, &width);
    if (near <= p) return 0;
    cut(walk, p, near);
    if (count_signs(walk->w, walk->degree, walk->cell_radius, zero_lo, 0).most == 0) {
        walk->position = near;
        walk->stride = width;
        return 1;
    }
    cut(walk, p, q);
    return 0;
}

/* Is the cell [p,q] at the edge of a stretch where signs are unknown, and short against it?  Then it counts
 * as a part of it: closer to its edge there is nothing to be found.  At its left end, where the right ends of
 * this cell and of four that it is the left half, quarter ... of are in it; at its right end, where the last
 * ones are. */
static int is_edge(const WALK *walk, int64_t p, int64_t q, int first, int unknown_ends) {
    return unknown_ends > 4 || (first == 0 && p == walk->unknown_hi && q - p <= (p - walk->unknown_lo) / 16);
}

/* A position as a point of the piece.  *exact becomes 0 unless it is that point, and a double: with a length
 * and a ratio that are doubles their product is exact, and so is the sum of two doubles. */
static algsurf_dd point_at(const algsurf_i_piece *piece, int64_t p, int *exact) {
    algsurf_dd point = p == 0 ? piece->lo : piece->hi, step = {0, 0};
    if (p > 0 && p < WHOLE) {
        algsurf_dd ratio = algsurf_i_dd_from_int(p), length = algsurf_dd_sub(piece->hi, piece->lo);
        step = algsurf_dd_mul(length, algsurf_dd_scale(ratio, 1.0 / WHOLE));
        point = algsurf_dd_add(piece->lo, step);
        *exact &= ratio.lo == 0 && length.lo == 0 && length.hi >= 0x1p-800;
    }
    *exact &= piece->lo.lo == 0 && step.lo == 0 && point.lo == 0;
    return point;
}

static void report(const WALK *walk, algsurf_i_cell *cell, int kind, int64_t p, int64_t q, signs s) {
    const algsurf_i_piece *piece = walk->pieces + walk->index;
    cell->piece = piece;
    cell->kind = kind;
    cell->sign = kind == ALGSURF_ROOT_BRACKET ? s.first : 0;
    cell->most = s.most;
    cell->at_lo = p == 0;
    cell->at_hi = q == WHOLE;
    cell->exact = !piece->far;
    cell->lo = point_at(piece, p, &cell->exact);
    cell->hi = point_at(piece, q, &cell->exact);
    cell->value_lo = num_hi(walk->w[0]);
    cell->value_hi = num_hi(walk->w[walk->degree]);
}

/* Bernstein form and error bound over the piece that comes next. */
static void enter(WALK *walk) {
    const algsurf_i_piece *piece = walk->pieces + walk->index;
    int n = walk->degree;
    double m = fmax(fabs(piece->lo.hi), fabs(piece->hi.hi)), size = 0, radius = 0;
    for (int j = 0; j <= n; j++)
        walk->local[j] = piece->far ? num_mul_d(walk->c[n - j], j % 2 ? -1 : 1) : walk->c[j];
    to_bernstein(walk->local, n, piece->lo, piece->hi, walk->b);
    walk->radius = 0;
    walk->largest = largest_of(walk->b, n);
    if (walk->bounded) {
        for (int j = n; j >= 0; j--) {
            size = size * m + fabs(num_hi(walk->local[j]));
            if (walk->r) radius = radius * m + walk->r[piece->far ? n - j : j];
        }
        walk->radius = (8 * (n + 1) * UNIT * size + radius) * (1 + 4 * (n + 2) * ALGSURF_U) + UNDERFLOW;
    }
    walk->position = 0;
    walk->stride = WHOLE;
    walk->unknown_lo = walk->unknown_hi = -1;
    walk->hi_told = 0;
    walk->active = 1;
}

/* The next cell of the current piece that holds, or may hold, a root. */
static int next_in_piece(WALK *walk, algsurf_i_cell *cell) {
    const algsurf_i_piece *piece = walk->pieces + walk->index;
    const signs none = {1, 0, 0, 0};
    int n = walk->degree, rest = 0; /* splits before the next leap */
    while (walk->position < WHOLE) {
        int64_t p = walk->position, q = walk->stride < WHOLE - p ? p + walk->stride : WHOLE;
        int unknown_ends = 0; /* in a row */
        cut(walk, p, q);
        for (;;) {
            int zero_lo = p == 0 && piece->zero_at_lo, zero_hi = q == WHOLE && piece->zero_at_hi;
            signs s = count_signs(walk->w, n, walk->cell_radius, zero_lo, zero_hi);
            walk->counted++;
            int one = (s.most == 1 || walk->any) && s.first * s.last < 0;
            int give_up = s.unknown > n - zero_lo - zero_hi || q - p <= FLOOR;
            unknown_ends = s.last == 0 ? unknown_ends + 1 : 0;
            if (CLUSTERS && walk->bounded) give_up |= is_edge(walk, p, q, s.first, unknown_ends);
            if (s.most > 0 && !one && !give_up) {
                if (CLUSTERS && s.most > 1 && s.first && s.last && rest-- <= 0) {
                    if (leaps(walk, p, q, s.most, zero_lo)) break;
                    rest = 3;
                }
                q = split(walk, p, q);
                continue;
            }
            walk->position = q;
            walk->stride = q - p < WHOLE / 4 ? 4 * (q - p) : WHOLE;
            if (s.most > 0) {
                report(walk, cell, one ? ALGSURF_ROOT_BRACKET : ALGSURF_ROOT_UNDECIDED, p, q, s);
                if (!one && p != walk->unknown_hi) walk->unknown_lo = p;
                if (!one) walk->unknown_hi = q;
                return 1;
            }
            break;
        }
    }
    if (piece->zero_at_hi && !walk->hi_told) {
        walk->hi_told = 1;
        report(walk, cell, ALGSURF_ROOT_EXACT, WHOLE, WHOLE, none);
        return 1;
    }
    return 0;
}

void WALK_BEGIN(WALK *walk, const NUMBER *c, const double *r, int degree, int bounded,
                const algsurf_i_piece *pieces, int count) {
    walk->degree = degree;
    walk->c = c;
    walk->r = r;
    walk->bounded = bounded;
    walk->pieces = pieces;
    walk->count = count;
    walk->any = 0;
    walk->counted = 0;
    walk->index = 0;
    walk->active = 0;
}

int WALK_NEXT(WALK *walk, algsurf_i_cell *cell) {
    while (walk->index < walk->count) {
        if (!walk->active) {
            const signs none = {1, 0, 0, 0};
            enter(walk);
            if (walk->pieces[walk->index].zero_at_lo) {
                report(walk, cell, ALGSURF_ROOT_EXACT, 0, 0, none);
                return 1;
            }
        }
        if (next_in_piece(walk, cell)) return 1;
        walk->active = 0;
        walk->index++;
    }
    return 0;
}
