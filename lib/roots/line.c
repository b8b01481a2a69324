/* line.c - the ladder: all complex roots in boxes, doubles, integers.
 *
 * Zeros.  c_0 = 0 is decided as it stands: t^m comes off, and 0 is a root m times.
 *
 * Boxes (complex/boxes_template.h) have all complex roots of low degrees, simple and apart, in less time than
 * a walk along the whole line takes; [lo,hi] keeps those inside.  A root is inside its box, never at its end:
 * ends are farther from the computed root than the proved radius (lower_end rounds outward from more than
 * that).  The box is two ulps wide at most, and the sign at the double inside, if there is one, shows on
 * which side the root is; so then no box reaches beyond lo or hi, which are doubles.  Signs alternate from
 * that at -inf.  Degrees 1 and 2 have formulas instead (low.c).
 *
 * p(t) = q(t^k) becomes q (power.c).  All else is walked: in doubles (walk.c), from where the sizes of
 * coefficients let roots be, then, from the last bracket that was certain, in integers (decide.c).
 *
 * A root is final where its ends are neighbours, or equal.  Each way says why it is: boxes and make_final()
 * halve until no double is between, by exact signs; the settling kernel has two certain signs at neighbours
 * (settle_template.h), as has integers.c; the exact engine ends at neighbours (exact_refine.c). */
#include "../base/arithmetic.h"
#include "line.h"

#include <math.h>

#include "../base/fpenv.h"
#include "../complex/boxes.h"
#include "../poly/value.h"
#include "polys.h"
#include "refine_impl.h"

/* ---- roots that are final ---- */

/* Of two doubles around a root that with less |p|, as the compensated scheme has it; the lower one if they
 * are equal: whichever way the two were found, the same. */
static double nearer(const algsurf_i_coefficients *p, double lo, double hi) {
    if (lo == hi || isinf(lo) || isinf(hi)) return isinf(lo) ? hi : lo;
    return fabs(algsurf_i_compensated(p->c, NULL, p->degree, lo).value) <=
                   fabs(algsurf_i_compensated(p->c, NULL, p->degree, hi).value)
               ? lo
               : hi;
}

/* A root at which p changes its sign, and no other one is in (lo,hi): to neighbours.  0: no memory. */
static int halve(const algsurf_i_coefficients *p, algsurf_real_root *r) {
    double between;
    while ((between = algsurf_i_between(r->lo, r->hi)) < r->hi) {
        int sign = algsurf_i_sign_at(p, between);
        if (sign == ALGSURF_SIGN_UNKNOWN) return 0;
        if (sign != -r->sign) r->lo = between;
        if (sign != r->sign) r->hi = between;
    }
    return 1;
}

/* The same from farther away. */
static int make_final(const algsurf_i_coefficients *p, algsurf_real_root *r) {
    algsurf_refined_root found;
    if (algsurf_i_between(r->lo, r->hi) < r->hi) {
        if (algsurf_i_refine_bracket(p, r->lo, r->hi, &found) != ALGSURF_OK) return 0;
        r->lo = found.lo, r->hi = found.hi;
        if (!halve(p, r)) return 0;
    }
    r->root = nearer(p, r->lo, r->hi);
    return 1;
}

/* ---- doubles, integers ---- */

/* Simple roots in brackets side by side, where nothing can overflow; multiplicity 0: still there. */
static void settle_brackets(const algsurf_i_coefficients *p, algsurf_real_root *roots, int count) {
    double most = ldexp(1, 400 / p->degree), largest = 0;
    for (int k = 0; k <= p->degree; k++) largest = fmax(largest, fabs(p->c[k]));
    int fits = largest <= 0x1p401 && (count == 0 || (roots[0].lo >= -most && roots[count - 1].hi <= most));
    if (fits) algsurf_i_roots_kernel_for(algsurf_i_kernel_find(NULL))->settle(p, roots, count);
    for (int i = 0; i < count && !fits; i++) roots[i].multiplicity = 0;
}

/* Roots in brackets of certain signs, refined; returns how many of them, from the first on. */
static int refine_brackets(const algsurf_i_coefficients *p, algsurf_real_root *roots, int count) {
    settle_brackets(p, roots, count);
    for (int i = 0; i < count; i++) {
        if (!roots[i].multiplicity && !make_final(p, roots + i)) return i;
        roots[i].multiplicity = 1;
    }
    return count;
}

/* What doubles have isolated becomes roots, as asked for; returns how many of them, from the first on. */
static int take_brackets(const algsurf_i_line *line, const algsurf_i_coefficients *p,
                         const algsurf_bracket *b, int count, algsurf_real_root *roots) {
    for (int i = 0; i < count; i++) roots[i] = (algsurf_real_root){b[i].lo, b[i].lo, b[i].hi, 1, b[i].sign};
    if (!line->refined) return count;
    if (!line->z) return refine_brackets(p, roots, count);
    settle_brackets(p, roots, count);
    return algsurf_i_integers_close_in(line, b, count, roots);
}

/* ---- all at once ---- */

static int is_whole(const algsurf_i_line *line) { return isinf(line->lo) && isinf(line->hi); }

/* All of p's real roots, simple, isolated; returns how many, or -1: boxes are faster than a walk where one
 * piece does not hold what is asked for. */
static int all_roots(const algsurf_i_line *line, int level, algsurf_real_root *all) {
    algsurf_complex_root own[ALGSURF_MOST_ROOTS_IN_LANES];
    const algsurf_complex_root *box = line->boxes ? line->boxes : own;
    const double *c = line->p.c;
    int n = line->p.degree, sign = (c[n] > 0) == (n % 2 == 0) ? 1 : -1, count = 0;
    if (n <= 2) return algsurf_i_low_roots(&line->p, all);
    if (level || line->wide || n > ALGSURF_MOST_ROOTS_IN_LANES) return -1;
    if (!line->boxes && !algsurf_i_allroots_kernel_for(algsurf_i_kernel_find(NULL))->one(c, NULL, 1, n, own))
        return -1;
    for (int i = 0; i < n; i++) {
        if (!box[i].real) continue;
        all[count++] = (algsurf_real_root){box[i].root.re, box[i].box.re.lo, box[i].box.re.hi, 1, sign};
        sign = -sign;
    }
    return count;
}

/* Boxes are nearly final; what formulas tell is settled like brackets. */
static int refine_all(const algsurf_i_coefficients *p, algsurf_real_root *roots, int count) {
    if (p->degree <= 2) return refine_brackets(p, roots, count) == count;
    for (int i = 0; i < count; i++) {
        if (!halve(p, roots + i)) return 0;
        roots[i].root = nearer(p, roots[i].lo, roots[i].hi);
    }
    return 1;
}

/* The roots that are asked for; returns 0 where they are not to be had so. */
static ALGSURF_NOINLINE int at_once(const algsurf_i_line *line, int level, algsurf_real_root *roots,
                                    int *count) {
    algsurf_real_root all[ALGSURF_MOST_ROOTS_IN_LANES];
    int n = all_roots(line, level, all), found = 0;
    for (int i = 0; i < n && !(line->wanted == ALGSURF_I_FIRST && found); i++)
        if (algsurf_i_is_inside(&line->p, line->lo, line->hi, all + i)) roots[found++] = all[i];
    if (n < 0 || (line->refined && !refine_all(&line->p, roots, found))) return 0;
    *count = found;
    return 1;
}

/* p: what doubles know.  Returns whether that is all; else *rest is where the rest begins. */
static ALGSURF_NOINLINE int in_doubles(const algsurf_i_line *line, const algsurf_i_coefficients *p, int level,
                                       int most, algsurf_real_root *roots, int *count, double *rest) {
    algsurf_bracket b[ALGSURF_MAX_DEGREE];
    int found = 0, done = algsurf_i_walk(p, line->lo, line->hi, level, most, b, &found, line->watch);
    *count = take_brackets(line, p, b, found, roots);
    if (*count == most || (done && *count == found)) return 1;
    *rest = *count < found ? b[*count].lo : found ? b[found - 1].hi : line->lo;
    return 0;
}

/* p: what doubles know, of a degree they can take; or null. */
static ALGSURF_NOINLINE algsurf_status by_walk(const algsurf_i_line *line, const algsurf_i_coefficients *p,
                                               int level, algsurf_real_root *roots, int *count) {
    const algsurf_i_coefficients *exact = &line->p;
    algsurf_i_line rest = *line;
    int most = line->wanted == ALGSURF_I_FIRST ? 1 : exact->degree, taken = 0;
    int done = p && in_doubles(line, p, level, most, roots, &taken, &rest.lo);
    *count = taken;
    if (!done && exact->c && exact->c[0] != 0) algsurf_i_cut_near(exact, &rest.lo, &rest.hi);
    if (done || rest.lo > rest.hi) return ALGSURF_OK;
    algsurf_status status = algsurf_i_decide(&rest, roots + taken, most - taken, count);
    *count += taken;
    for (int i = taken; line->refined && exact->c && i < *count; i++)
        roots[i].root = nearer(exact, roots[i].lo, roots[i].hi);
    return status;
}

/* To where roots can be; returns whether one piece holds that. */
static int cut(algsurf_i_line *line) {
    algsurf_i_cut_far(&line->p, &line->lo, &line->hi);
    return algsurf_i_is_level(&line->p, fmax(fabs(line->lo), fabs(line->hi)));
}

static ALGSURF_NOINLINE algsurf_status walk_doubles(algsurf_i_line line, int level, algsurf_real_root *roots,
                                                    int *count) {
    const algsurf_i_coefficients *p = &line.p;
    *count = 0;
    if (is_whole(&line)) level = cut(&line);
    if (line.lo > line.hi || (line.lo == line.hi && algsurf_i_sign_at(p, line.lo) != 0)) return ALGSURF_OK;
    return by_walk(&line, p->degree <= ALGSURF_MAX_DEGREE ? p : NULL, level, roots, count);
}

/* ---- powers ---- */

static algsurf_status solve(const algsurf_i_line *line, algsurf_real_root *roots, int *count);

/* By the roots of q, all of them; returns 0 when p itself has to be looked at. */
static ALGSURF_NOINLINE int by_power(const algsurf_i_line *line, algsurf_real_root *roots, int *count) {
    const algsurf_i_coefficients *p = &line->p;
    algsurf_i_power w;
    algsurf_i_watch watch;
    if (!algsurf_i_power_of(p->c, p->degree, &w)) return 0;
    algsurf_i_line inner = *line;
    inner.p.c = w.q;
    inner.p.degree = w.degree;
    inner.boxes = NULL;
    if (inner.wanted == ALGSURF_I_FIRST) inner.wanted = ALGSURF_I_ALL;
    inner.wide = !line->refined && line->wanted != ALGSURF_I_NUMBER;
    algsurf_i_power_interval(&w, line->lo, line->hi, &inner.lo, &inner.hi);
    if (line->watch) {
        watch = *line->watch;
        watch.power = w.step;
        inner.watch = &watch;
    }
    if (solve(&inner, roots, count) != ALGSURF_OK) return 0;
    if (line->wanted == ALGSURF_I_NUMBER) {
        *count *= w.step % 2 ? 1 : 2;
        return 1;
    }
    if (!algsurf_i_power_roots(&w, p, line->lo, line->hi, roots, count)) return 0;
    for (int i = 0; line->refined && i < *count; i++)
        if (!make_final(p, roots + i)) return 0;
    return 1;
}

/* ---- all of it ---- */

/* p_0 and p's leading coefficient are not 0.  Whoever watches sees a walk, and gets the same bits. */
static algsurf_status solve(const algsurf_i_line *line, algsurf_real_root *roots, int *count) {
    const algsurf_i_coefficients *p = &line->p;
    algsurf_i_line part;
    int number = line->wanted == ALGSURF_I_NUMBER, level = 0;
    *count = 0;
    if (p->degree == 0) return ALGSURF_OK;
    if (number && is_whole(line) && (*count = algsurf_i_low_number(p)) >= 0) return ALGSURF_OK;
    if (number && by_power(line, roots, count)) return ALGSURF_OK;
    if (p->degree > 2) level = algsurf_i_is_level(p, fmax(fabs(line->lo), fabs(line->hi)));
    if (p->degree > 2 && !level && !is_whole(line)) {
        part = *line;
        level = cut(&part);
        line = &part;
    }
    if (!line->watch && at_once(line, level, roots, count)) return ALGSURF_OK;
    algsurf_status status =
        !number && by_power(line, roots, count) ? ALGSURF_OK : walk_doubles(*line, level, roots, count);
    if (line->watch && status == ALGSURF_OK) (void)at_once(line, level, roots, count);
    return status;
}

/* Roots of p / t^m become those of p: with 0, and signs of t^m; returns 0 where that will not do. */
static int put_zero(const algsurf_i_line *line, int zeros, algsurf_real_root *roots, int *count) {
    int below = 0, n = *count, inside = line->lo <= 0 && line->hi >= 0;
    if (line->wanted == ALGSURF_I_NUMBER) return ++*count;
    for (int i = 0; i < n; i++) {
        if (!algsurf_i_leave_zero(&line->p, roots + i)) return 0;
        if (roots[i].lo < 0 || roots[i].hi < 0) below = i + 1;
    }
    for (int i = 0; i < below && zeros % 2; i++) roots[i].sign = -roots[i].sign;
    if (!inside) return 1;
    for (int i = n; i > below; i--) roots[i] = roots[i - 1];
    roots[below] = (algsurf_real_root){0, 0, 0, zeros, (line->p.c[0] > 0) == (zeros % 2 == 0) ? 1 : -1};
    ++*count;
    return 1;
}

/* 0 is a root. */
static ALGSURF_NOINLINE algsurf_status solve_with_zero(const algsurf_i_line *line, algsurf_real_root *roots,
                                                       int *count) {
    int zeros = 0;
    algsurf_i_line rest = *line;
    while (line->p.c[zeros] == 0) zeros++;
    rest.p.c += zeros;
    rest.p.degree -= zeros;
    rest.boxes = NULL;
    if (rest.wanted == ALGSURF_I_FIRST) rest.wanted = ALGSURF_I_ALL;
    algsurf_status status = solve(&rest, roots, count);
    if (status != ALGSURF_OK || put_zero(&rest, zeros, roots, count)) return status;
    return by_walk(line, NULL, 0, roots, count);
}

static algsurf_status solve_doubles(const algsurf_i_line *line, algsurf_real_root *roots, int *count) {
    return line->p.c[0] == 0 ? solve_with_zero(line, roots, count) : solve(line, roots, count);
}

/* Integers that doubles hold are doubles; others are known to radii. */
static ALGSURF_NOINLINE algsurf_status solve_integers(const algsurf_i_line *line, algsurf_real_root *roots,
                                                      int *count) {
    double c[ALGSURF_MAX_DEGREE + 1], r[ALGSURF_MAX_DEGREE + 1];
    algsurf_i_coefficients p = {c, r, 0};
    if (!algsurf_i_integers_round(line, c, r, &p.degree)) return by_walk(line, NULL, 0, roots, count);
    (void)algsurf_i_check_coefficients(&p);
    if (p.degree == 0) return ALGSURF_OK;
    int level = algsurf_i_is_level(&p, fmax(fabs(line->lo), fabs(line->hi)));
    if (p.r) return by_walk(line, &p, level, roots, count);
    algsurf_i_line exact = *line;
    exact.p = p, exact.z = NULL;
    return solve_doubles(&exact, roots, count);
}

algsurf_status algsurf_i_line_solve(const algsurf_i_line *line, algsurf_real_root *roots, int *count) {
    *count = 0;
    if (line->lo == HUGE_VAL || line->hi == -HUGE_VAL) return ALGSURF_OK; /* [inf,inf] holds no number */
    algsurf_status status = !line->z ? solve_doubles(line, roots, count) : solve_integers(line, roots, count);
    if (line->wanted == ALGSURF_I_FIRST && *count > 1) *count = 1;
    return status;
}
