/* select.c - three-valued choice of the least root in a sector.
 *
 * Both ranges of arguments, sigma .. sigma + delta and its conjugate, are one range of |arg|: a box is
 * folded onto the upper half plane and its argument compared.  A candidate is chosen if it certainly
 * counts and no other that may count can be smaller.
 *
 * Conjugates.  The roots of a real polynomial, each with its multiplicity, are symmetric about the real axis.
 * If one box is the mirror image of another and both hold no roots but their own, the roots of either are
 * the conjugates of the other's.  (Boxes that were moved and rounded since, all in the same way, may have
 * come to overlap.  Roots whose boxes now mirror each other by chance then have conjugates in the same two
 * boxes: a third and a fourth candidate with the same magnitudes, which compete.)  A box that meets the axis
 * is nobody's mirror image but its own. */
#include "../base/arithmetic.h"
#include <math.h>

#include "edges.h"
#include "../base/fpenv.h"
#include "../poly/interval_round.h"
#include "../base/elementary.h"
#include "../base/options.h"

#define PI_BELOW 0x1.921fb54442d18p+1 /* the doubles around pi; the lower one is nearest */
#define PI_ABOVE 0x1.921fb54442d19p+1

static algsurf_status check(const algsurf_sector *s) {
    if (!s) return ALGSURF_E_ARGUMENT;
    if (!isfinite(s->sigma) || !isfinite(s->delta)) return ALGSURF_E_NOT_FINITE;
    return s->sigma >= 0 && s->delta >= 0 && s->sigma + s->delta <= PI_ABOVE ? ALGSURF_OK
                                                                             : ALGSURF_E_ARGUMENT;
}

/* The largest double in the sector: a double is beyond sigma + delta if and only if it is above this one. */
static double end_of(const algsurf_sector *s) {
    return s->sigma + s->delta >= PI_BELOW ? HUGE_VAL : algsurf_i_add_down(s->sigma, s->delta);
}

/* The unit vector at an angle: proposed by elementary.c, proved by its argument as an interval. */
static int direction(double angle, double unit[2]) {
    algsurf_interval arg;
    algsurf_i_circle(angle, unit);
    const algsurf_cinterval point = {{unit[0], unit[0]}, {unit[1], unit[1]}};
    return algsurf_cinterval_arg(point, &arg) == ALGSURF_OK && arg.lo >= angle - 0x1p-47 &&
           arg.hi <= angle + 0x1p-47 && fabs(unit[0] * unit[0] + unit[1] * unit[1] - 1) <= 0x1p-48;
}

int algsurf_i_sector_edges_of(const algsurf_sector *s, algsurf_i_sector_edges *edges) {
    double end = end_of(s);
    *edges = (algsurf_i_sector_edges){{1, 0}, {-1, 0}, s->sigma == 0, end == HUGE_VAL};
    return direction(s->sigma, edges->begin) && (edges->to_pi || direction(end, edges->end));
}

/* The box with the imaginary part's magnitude. */
static algsurf_cinterval fold(algsurf_cinterval box) {
    return (algsurf_cinterval){box.re, algsurf_interval_abs(box.im)};
}

static int in_sector(const algsurf_sector *s, const algsurf_complex_root *root) {
    const algsurf_cinterval box = fold(root->box);
    const double end = end_of(s);
    algsurf_interval arg;
    if (box.im.hi == 0 && box.re.lo >= 0) return s->sigma == 0;
    if (box.im.hi == 0 && box.re.hi < 0) return end == HUGE_VAL;
    if (algsurf_cinterval_arg(box, &arg) != ALGSURF_OK) return 2;
    if (arg.hi < s->sigma || arg.lo > end) return 0;
    return arg.lo >= s->sigma && arg.hi <= end ? 1 : 2;
}

ALGSURF_I_ENTRY(algsurf_status, sector_holds,
                (const algsurf_sector *sector, const algsurf_complex_root *root, int *holds),
                (sector, root, holds)) {
    if (!root || !holds) return ALGSURF_E_ARGUMENT;
    algsurf_status status = check(sector);
    if (status == ALGSURF_OK) *holds = in_sector(sector, root);
    return status;
}

/* Magnitudes in [lo,hi]: 1 certainly, 0 certainly not, 2 undecided. */
static int in_range(algsurf_interval magnitude, double lo, double hi) {
    if (magnitude.hi < lo || magnitude.lo > hi) return 0;
    return magnitude.lo >= lo && magnitude.hi <= hi ? 1 : 2;
}

typedef struct candidate {
    int index, certain;
    algsurf_interval magnitude;
} candidate;

/* Mirror images of each other, off the axis. */
static int mirrored(const algsurf_cinterval *a, const algsurf_cinterval *b) {
    return (a->im.lo > 0 || a->im.hi < 0) && a->re.lo == b->re.lo && a->re.hi == b->re.hi &&
           a->im.lo == -b->im.hi && a->im.hi == -b->im.lo;
}

/* `real`: the roots are those of a real polynomial. */
static algsurf_status choose_one(const algsurf_complex_root *roots, int count, int real,
                                 const algsurf_sector *sector, double lo, double hi, int *selected,
                                 int *index) {
    candidate best = {-1, 0, {0, 0}};
    if (count < 0 || (count > 0 && !roots) || !selected || !index) return ALGSURF_E_ARGUMENT;
    algsurf_status status = check(sector);
    if (status == ALGSURF_OK) status = algsurf_i_check_interval(lo, hi);
    if (status != ALGSURF_OK) return status;
    if (lo < 0) return ALGSURF_E_ARGUMENT;
    for (int i = 0; i < count; i++) {
        algsurf_interval magnitude = algsurf_cinterval_abs(roots[i].box);
        int counts = in_range(magnitude, lo, hi);
        if (!counts || (best.index >= 0 && magnitude.lo >= best.magnitude.hi)) continue;
        int holds = in_sector(sector, roots + i);
        if (!holds) continue;
        candidate c = {i, counts == 1 && holds == 1, magnitude};
        int twin = real && best.index >= 0 && mirrored(&roots[i].box, &roots[best.index].box);
        if (best.index < 0 || magnitude.hi <= best.magnitude.lo)
            best = c;
        else if (!twin) { /* they overlap: which is the least stays open */
            c.certain = 0;
            best.certain = 0;
            if (magnitude.lo < best.magnitude.lo) best = c;
        }
    }
    if (best.index >= 0) *index = best.index;
    *selected = best.index < 0 ? ALGSURF_SELECTED_NONE
                : best.certain ? ALGSURF_SELECTED_ONE
                               : ALGSURF_SELECTED_UNDECIDED;
    return ALGSURF_OK;
}

#define PUBLIC_CHOICE(name, real)                                                                            \
    ALGSURF_I_ENTRY(algsurf_status, name,                                                                    \
                    (const algsurf_complex_root *roots, int count, const algsurf_sector *sector, double lo,  \
                     double hi, int *selected, int *index),                                                  \
                    (roots, count, sector, lo, hi, selected, index)) {                                       \
        return choose_one(roots, count, real, sector, lo, hi, selected, index);                              \
    }
PUBLIC_CHOICE(select, 0)
PUBLIC_CHOICE(select_of_real, 1)
