/* walk.c - the real roots of one polynomial in doubles: which parts of an interval a lane looks at, and with
 * what units.
 *
 * Bounds.  On a side of 0 let a_k = c_k (+-1)^k.  p has the sign of a_0 for all 0 < x <= z if
 *     |a_0| > sum |a_k| z^k,  over the k whose a_k has the other sign,
 * since the sum grows with x.  With coefficients in reverse the same shows the sign of a_n for x >= 1/z
 * (Cauchy 1829, terms of one sign left out).  No such k: no root on that side (Descartes).  The sum is made
 * of terms scaled by powers of two so that z is near 1; its roundings, and what underflows, are below 2^-40.
 *
 * Pieces.  In the piece about 0 no term is more than SPREAD digits larger than c_0; further out, pieces are
 * annuli, some of which have no root since one term is larger than all those of the other sign. */
#include "../base/arithmetic.h"
#include "line.h"

#include <float.h>
#include <math.h>

#include "polys.h"

/* ---- where roots can be ---- */

enum { GRID = 16 }; /* bounds are among these, from 2^-2 to below 2^2, times a power of two */

/* No round numbers: cells are halved between bounds, and a root at their ends hides the sign. */
static const double grid[GRID + 1] = {
    0.25 + 0x1p-9,     0.296875 + 0x1p-10, 0.3515625 + 0x1p-12, 0.421875 + 0x1p-10, 0.5 + 0x1p-8,
    0.59375 + 0x1p-9,  0.703125 + 0x1p-11, 0.84375 + 0x1p-9,    1 + 0x1p-7,         1.1875 + 0x1p-8,
    1.40625 + 0x1p-10, 1.6875 + 0x1p-8,    2 + 0x1p-6,          2.375 + 0x1p-7,     2.8125 + 0x1p-9,
    3.375 + 0x1p-7,    4 + 0x1p-5};

/* The bound of |t| on a side of 0: from below or, by the coefficients from the last one on, from above.  No
 * root: infinity or 0. */
static double bound_of(const algsurf_i_coefficients *p, int from_last, int side) {
    int n = p->degree;
    double term[ALGSURF_MAX_POLY_DEGREE + 1], sum[GRID] = {0}, y[GRID];
    const double *first = p->c + (from_last ? n : 0);
    int lead = ilogb(*first), unit = 0, any = 0, i = 0;
    for (int k = 1; k <= n; k++) {
        double a = from_last ? first[-k] : first[k];
        int same = (a > 0) == (*first > 0);
        term[k] = same == (side > 0 || k % 2 == 0) ? 0 : fabs(a);
        if (term[k] == 0) continue;
        int room = lead - ilogb(a), least = room >= 0 ? room / k : -((k - 1 - room) / k);
        unit = !any || least < unit ? least : unit;
        any = 1;
    }
    if (!any) return from_last ? 0 : HUGE_VAL;
    for (int j = 0; j < GRID; j++) y[j] = from_last ? 1 / grid[GRID - j] : grid[j];
    for (int k = n; k > 0; k--) {
        double a = term[k] == 0 ? 0 : ldexp(term[k], k * unit - lead);
        for (int j = 0; j < GRID; j++) sum[j] = (sum[j] + a) * y[j];
    }
    double least = fabs(ldexp(*first, -lead)) * (1 - 0x1p-30);
    while (i + 1 < GRID && sum[i + 1] < least) i++; /* the first will do: 2 (0.26 + 0.26^2 + ..) < 1 */
    if (from_last) return -unit > -1000 ? ldexp(grid[GRID - i], -unit) : 0x1p-990;
    return unit > -1000 ? fmin(ldexp(grid[i], unit), DBL_MAX) : 0;
}

/* Keeps of [lo,hi] what is between near and far on either side of 0. */
static void keep(double *lo, double *hi, const double *near, const double *far) {
    double below[2] = {1, 0}, above[2] = {1, 0};
    if (*lo < 0) below[0] = fmax(*lo, -far[0]), below[1] = fmin(*hi, -near[0]);
    if (*hi > 0) above[0] = fmax(*lo, near[1]), above[1] = fmin(*hi, far[1]);
    *lo = below[0] <= below[1] ? below[0] : above[0];
    *hi = above[0] <= above[1] ? above[1] : below[1];
}

void algsurf_i_cut_far(const algsurf_i_coefficients *p, double *lo, double *hi) {
    double near[2] = {0, 0}, far[2] = {0, 0};
    if (*lo < 0) far[0] = bound_of(p, 1, -1);
    if (*hi > 0) far[1] = bound_of(p, 1, 1);
    keep(lo, hi, near, far);
}

void algsurf_i_cut_near(const algsurf_i_coefficients *p, double *lo, double *hi) {
    double near[2] = {0, 0}, far[2] = {HUGE_VAL, HUGE_VAL};
    if (*lo > 0x1p-6 * *hi || *hi < 0x1p-6 * *lo) return; /* not worth it */
    if (*lo < 0) near[0] = bound_of(p, 0, -1);
    if (*hi > 0) near[1] = bound_of(p, 0, 1);
    keep(lo, hi, near, far);
}

int algsurf_i_leave_zero(const algsurf_i_coefficients *p, algsurf_real_root *root) {
    double lo = root->lo, hi = root->hi;
    if (lo > 0 || hi < 0 || nextafter(lo, hi) == hi) return 1;
    if ((p->c[0] > 0 ? 1 : -1) == root->sign)
        lo = 0;
    else
        hi = 0;
    algsurf_i_cut_near(p, &lo, &hi);
    root->lo = lo, root->hi = hi;
    return lo > 0 || hi < 0;
}

int algsurf_i_is_inside(const algsurf_i_coefficients *p, double lo, double hi, algsurf_real_root *root) {
    const double ends[2] = {lo, hi};
    for (int i = 0; i < 2; i++) {
        if (!(root->lo < ends[i] && ends[i] < root->hi)) continue;
        int sign = algsurf_i_sign_at(p, ends[i]);
        if (sign != -root->sign) root->lo = ends[i];
        if (sign != root->sign) root->hi = ends[i];
    }
    return root->lo >= lo && root->hi <= hi;
}

/* ---- pieces ---- */

typedef struct task {
    const algsurf_i_coefficients *p;
    double lo, hi;
    algsurf_bracket *b;
    int level, count, most;
    const algsurf_i_watch *watch;
} task;

enum { HALVINGS = 3 }; /* of what a lane leaves undecided */

/* [from,to] in a lane, as far as it is asked for; returns 0 when that leaves something undecided.  A part of
 * a piece has smaller bounds of rounding than the piece: what this leaves is tried again by halves. */
static int walk_piece(task *t, double from, double to, int halvings) {
    int most = t->most - t->count, found = 0;
    double lo = fmax(from, t->lo), hi = fmin(to, t->hi);
    if (lo >= hi || most == 0) return 1;
    if (!(fmax(fabs(lo), fabs(hi)) > 0x1p-900 && hi - lo < 0x1p1000)) return 0;
    const algsurf_i_roots_kernel *kernel = algsurf_i_roots_kernel_for(algsurf_i_kernel_find(NULL));
    int done = kernel->single(t->p, lo, hi, most, t->b + t->count, &found, t->watch);
    t->count += found;
    if (done || halvings == 0 || t->p->r) return done;
    double rest = found ? t->b[t->count - 1].hi : lo, middle = 0.5 * rest + 0.5 * hi;
    return walk_piece(t, rest, middle, halvings - 1) && walk_piece(t, middle, hi, halvings - 1);
}

enum { SPREAD = 24, NO_TERM = -(1 << 20) }; /* binary digits that one piece may lose; the exponent of 0 */

/* An end of pieces, a little above 2^e: they are halved, and a root that is a round number hides the sign. */
static double end_of_piece(int e) { return ldexp(1 + 0x1p-5 + 0x1p-11, e); }

/* Is there no root between end_of_piece(a) and end_of_piece(b), on this side of 0, as one term is larger than
 * all those of the other sign together?  |c_k| is at least 2^e[k] and below twice that, and 1.04 <
 * 2^(1/16). */
static int has_no_root(const algsurf_i_coefficients *p, const int *e, int side, int a, int b) {
    int m = 0;
    double others = 0;
    for (int k = 1; k <= p->degree; k++)
        if (2 * e[k] + k * (a + b) > 2 * e[m] + m * (a + b)) m = k;
    for (int k = 0; k <= p->degree; k++) {
        int same = (p->c[k] > 0) == (p->c[m] > 0), d = k - m;
        if (same == (side > 0 || d % 2 == 0)) continue;
        others += ldexp(1, e[k] + 1 - e[m] + d * (d > 0 ? b : a) + (d > 0 ? (d + 15) / 16 : 0));
    }
    return others < 1 - 0x1p-40 && !p->r; /* which takes in the roundings of the sum */
}

static int walk_side(task *t, const int *e, int side, int from, int to) {
    if (has_no_root(t->p, e, side, from, to)) return 1;
    double near = end_of_piece(from), far = end_of_piece(to);
    return side > 0 ? walk_piece(t, near, far, HALVINGS) : walk_piece(t, -far, -near, HALVINGS);
}

int algsurf_i_is_level(const algsurf_i_coefficients *p, double size) {
    double most = fabs(p->c[0]) * (1 << SPREAD), power = 1;
    for (int k = 1; k <= p->degree; k++)
        if (!(fabs(p->c[k]) * (power *= size) <= most)) return 0;
    return size < 0x1p300;
}

/* An exponent e so that all roots are below 2^e; above 1023 where there is none.  |t| <= 2 max |c_k /
 * c_n|^(1/(n-k)) (Fujiwara 1916).  |c_k| + r_k is below 2^(i+2), i the exponent of the larger one; |c_n| -
 * r_n, rounded, is at most twice too large. */
static int root_bound(const algsurf_i_coefficients *p) {
    int n = p->degree, bound = -1000, radii = p->r != NULL;
    double lead = fabs(p->c[n]) - (radii ? p->r[n] : 0);
    if (!(lead > 0)) return 1024;
    int least = ilogb(lead) - radii;
    for (int k = 0; k < n; k++) {
        double size = radii ? fmax(fabs(p->c[k]), p->r[k]) : fabs(p->c[k]);
        if (!(size > 0)) continue;
        int e = ilogb(size) + 1 + radii - least;
        if (e > (n - k) * bound) bound = e > 0 ? (e + n - k - 1) / (n - k) : -(-e / (n - k));
    }
    return bound + 1;
}

/* All of [lo,hi] in a lane: in one piece, or, where roots can be of very different sizes, in pieces. */
static int walk_line(task *t) {
    int n = t->p->degree, e[ALGSURF_MAX_DEGREE + 1];
    double size = fmax(fabs(t->lo), fabs(t->hi));
    if (!(t->lo < t->hi) || n == 0 || n > ALGSURF_MAX_DEGREE || t->p->c[0] == 0 || t->p->c[n] == 0) return 0;
    if (t->level) return walk_piece(t, t->lo, t->hi, HALVINGS);
    int bound = size < 0x1p900 ? ilogb(size) + 1 : root_bound(t->p), inner = bound;
    for (int k = 0; k <= n; k++) {
        e[k] = t->p->c[k] != 0 ? ilogb(t->p->c[k]) : NO_TERM;
        if (k > 0 && SPREAD + e[0] - e[k] < k * inner) inner = (int)floor((SPREAD + e[0] - e[k]) / (double)k);
    }
    if (bound > 900 || inner < -900) return 0;
    int done = 1, step = SPREAD > n ? SPREAD / n : 1;
    for (int i = bound; done && i > inner; i -= step)
        done = walk_side(t, e, -1, i - step > inner ? i - step : inner, i);
    done = done && walk_piece(t, -end_of_piece(inner), end_of_piece(inner), HALVINGS);
    for (int i = inner; done && i < bound; i += step)
        done = walk_side(t, e, 1, i, i + step < bound ? i + step : bound);
    return done;
}

int algsurf_i_walk(const algsurf_i_coefficients *p, double lo, double hi, int level, int most,
                   algsurf_bracket *b, int *count, const algsurf_i_watch *watch) {
    task t = {p, lo, hi, b, level, 0, most, watch};
    int done = walk_line(&t);
    *count = t.count;
    return done;
}
