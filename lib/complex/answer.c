/* answer.c - boxes of doubles about the roots that discs.c has found, and their order.
 *
 * A root is z - W, off by a radius: sums of integers in units of 2^-30 of the radius or smaller ones, each
 * cut to less than one unit, so that three more in the radius cover them; the ends are rounded by
 * algsurf_z_round_down and _up. */
#include "../base/arithmetic.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "../poly/interval_impl.h"
#include "discs.h"

#define MOST_BITS ALGSURF_I_RANGE_OF_DOUBLES /* of a root */
#define LIMBS (MOST_BITS / 64 + 4)

static int clamped(int64_t e) { return (int)(e < -100000 ? -100000 : e > 100000 ? 100000 : e); }

/* A part of a root, times 2^unit: x, which is that of z, less that of a step, off by the radius. */
static algsurf_interval part(const algsurf_i_point *z, const algsurf_limb *x, algsurf_scaled step,
                             algsurf_scaled radius, int64_t unit, double *value) {
    algsurf_limb a[LIMBS], b[LIMBS], r = 0;
    int exact = radius.re == 0, e;
    int64_t top = larger(larger(z->head, step), radius).exponent;
    int64_t low = exact ? z->exponent : radius.exponent - 30;
    if (low < top - MOST_BITS) low = top - MOST_BITS, exact = 0;
    if (low > top) low = top;
    if (!exact)
        r = 3 + (radius.exponent < low - 1
                     ? 1
                     : (algsurf_limb)ceil(ldexp(radius.re, (int)(radius.exponent - low))));
    const int w = (int)((top - low) / 64) + 4;
    algsurf_z_zero(a, w);
    algsurf_i_add_shifted(a, w, x, z->w, z->exponent - low);
    algsurf_i_add_double(a, w, -step.re, step.exponent - low);
    algsurf_z_copy(b, w, a, w);
    double middle = algsurf_z_to_double(a, w, &e);
    *value = ldexp(middle, clamped(e + low + unit));
    algsurf_z_add_limbs(a, w, 0, r);
    algsurf_z_add_limbs(b, w, r, 0);
    return (algsurf_interval){algsurf_z_round_down(a, w, clamped(low + unit)) + 0.0,
                              algsurf_z_round_up(b, w, clamped(low + unit)) + 0.0};
}

/* The root is within blur + error of z - W, of which the end is cut: less than 2 units from each part. */
int algsurf_i_centre(algsurf_i_discs *d, int i, int on_axis, algsurf_i_point *x, algsurf_scaled *R) {
    const algsurf_i_disc *root = d->root + i;
    *R = by(sum(root->blur, root->error), 1 + 0x1p-40);
    const int exact = is_zero(root->step) && is_zero(*R);
    const int64_t low = exact ? root->z.exponent : R->exponent - 10;
    if (!exact) *R = sum(*R, scaled_of(4, 0, low));
    return algsurf_i_set_point(d->m, x, &root->z, negative(root->step), low, on_axis);
}

/* A number in the box that is finite. */
static double inside(algsurf_interval box, double x) {
    return fmin(fmax(fmin(fmax(x, box.lo), box.hi), -DBL_MAX), DBL_MAX) + 0.0;
}

static algsurf_complex_root box_of(const algsurf_i_discs *d, int i, int64_t unit) {
    const algsurf_i_disc *known = d->root + i;
    const algsurf_i_point *z = &known->z;
    algsurf_scaled step = scaled_none(), radius = known->disc;
    if (is_alone(d, i) && known->blur.exponent < radius.exponent) {
        step = known->step;
        radius = by(sum(known->blur, known->error), 1 + 0x1p-40);
    }
    algsurf_complex_root root = {.multiplicity = known->multiplicity[0]};
    root.box.re = part(z, z->x, step, radius, unit, &root.root.re);
    step.re = step.im;
    root.box.im = part(z, z->y, step, radius, unit, &root.root.im);
    return root;
}

/* The double inside of [lo,hi], if it is one, or 0, or lo = hi. */
static int has_one_inside(algsurf_interval x, double *one) {
    const int has_zero = x.lo < 0 && x.hi > 0;
    *one = x.lo == x.hi ? x.lo : has_zero ? 0 : nextafter(x.lo, HUGE_VAL);
    if (!isfinite(x.lo) || !isfinite(x.hi)) return 0;
    return has_zero || x.lo == x.hi || nextafter(*one, HUGE_VAL) == x.hi;
}

int algsurf_i_double_inside(const algsurf_i_discs *d, int i, algsurf_scaled z[2]) {
    const int64_t unit = larger(d->root[i].z.head, d->root[i].step).exponent;
    algsurf_cinterval box = box_of(d, i, -unit).box;
    double x, y;
    if (d->p->real && box.im.lo <= 0 && box.im.hi >= 0) box.im = (algsurf_interval){0, 0};
    if (box.re.lo == box.re.hi && box.im.lo == box.im.hi) return 0;
    if (!has_one_inside(box.re, &x) || !has_one_inside(box.im, &y)) return 0;
    if ((x != 0 && fabs(x) < 0x1p-1000) || (y != 0 && fabs(y) < 0x1p-1000)) return 0;
    z[0] = scaled_of(x, 0, unit), z[1] = scaled_of(0, y, unit);
    return 1;
}

static double middle(algsurf_interval x) { return inside(x, 0.5 * x.lo + 0.5 * x.hi); }

static int meet(algsurf_cinterval a, algsurf_cinterval b) {
    return algsurf_i_cinterval_valid(algsurf_i_cinterval_meet(a, b));
}

static algsurf_cinterval mirror(algsurf_cinterval a) {
    return (algsurf_cinterval){a.re, algsurf_i_interval_neg(a.im)};
}

/* Box k joins box j; returns the number of boxes left. */
static int unite(algsurf_complex_root *e, int count, int j, int k) {
    e[j].box = algsurf_i_cinterval_hull(e[j].box, e[k].box);
    e[j].root = (algsurf_complex){middle(e[j].box.re), middle(e[j].box.im)};
    e[j].multiplicity += e[k].multiplicity;
    e[j].real = e[j].real && e[k].real;
    e[k] = e[--count];
    return count;
}

/* The first two boxes that have to be one: they meet, or both meet the mirror image of a box. */
static int find_pair(const algsurf_complex_root *e, int count, int real, int *first, int *second) {
    for (int i = 0; i < count; i++) {
        algsurf_cinterval image = mirror(e[i].box);
        int met = -1;
        for (int j = real ? 0 : i + 1; j < count; j++) {
            *first = i, *second = j;
            if (j > i && meet(e[i].box, e[j].box)) return 1;
            if (!real || !meet(image, e[j].box)) continue;
            *first = met;
            if (met >= 0) return 1;
            met = j;
        }
    }
    return 0;
}

/* The boxes of unions of discs may meet where the discs do not, and so may rounded ones. */
static int join(algsurf_complex_root *e, int count, int real) {
    int first, second;
    while (find_pair(e, count, real, &first, &second)) count = unite(e, count, first, second);
    return count;
}

/* For real coefficients the mirror image of a box holds as many roots as the box, and now meets one box only,
 * whose image in turn meets only the first: the roots of either lie in what it shares with the image of the
 * other.  If a box meets its own image, a single root in it is real; `single` is its multiplicity. */
static void use_symmetry(algsurf_complex_root *e, int count, int single) {
    for (int i = 0; i < count; i++) {
        algsurf_cinterval image = mirror(e[i].box);
        int j = 0;
        while (j < count && !meet(image, e[j].box)) j++;
        if (j < i || j == count) continue;
        e[j].box = algsurf_i_cinterval_meet(image, e[j].box);
        e[i].box = mirror(e[j].box);
        e[j].root = (algsurf_complex){e[i].root.re, -e[i].root.im};
        if (i != j) continue;
        e[i].root.im = 0;
        e[i].real = e[i].multiplicity == single;
        if (e[i].real) e[i].box.im = (algsurf_interval){0, 0};
    }
}

static int compare(const void *left, const void *right) {
    const algsurf_complex_root *a = left, *b = right;
    if (a->root.re != b->root.re) return a->root.re < b->root.re ? -1 : 1;
    return (a->root.im > b->root.im) - (a->root.im < b->root.im);
}

/* Boxes of the groups, rounded outward, disjoint; those of a real polynomial are symmetric.  Returns their
 * number. */
static int make_boxes(const algsurf_i_discs *d, int64_t unit, algsurf_complex_root *roots) {
    int count = 0;
    for (int g = 0; g < d->n; g++) {
        const int first = count;
        for (int i = g; i < d->n; i++) {
            if (d->root[i].group != g) continue;
            roots[count++] = box_of(d, i, unit);
            if (i > g) count = unite(roots, count, first, first + 1);
        }
    }
    count = join(roots, count, d->p->real);
    if (d->p->real) use_symmetry(roots, count, (d->root->multiplicity[0] + d->root->multiplicity[1]) / 2);
    int left = 0;
    for (int i = 0; i < count; i++) {
        if (roots[i].multiplicity == 0) continue;
        roots[left] = roots[i];
        roots[left++].root = (algsurf_complex){inside(roots[i].box.re, roots[i].root.re),
                                               inside(roots[i].box.im, roots[i].root.im)};
    }
    return left;
}

/* Roots whose boxes meet are made narrower, for they may differ in their smaller part; or all are.  Boxes of
 * two units are apart where the roots' distance exceeds 2^-48 of their size and a few of the least doubles.
 */
static int press(algsurf_i_discs *d, int64_t unit, int all) {
    int met = all, open, count = 0;
    algsurf_memory_mark mark = algsurf_memory_here(d->m);
    int *close = algsurf_i_take(d->m, (size_t)d->n * sizeof *close);
    algsurf_cinterval *box = algsurf_i_take(d->m, (size_t)d->n * sizeof *box);
    if (!close || !box) return 0;
    for (int i = 0; i < d->n; i++) {
        const algsurf_i_disc *root = d->root + i;
        const algsurf_scaled reach = sum(by(size_of(root->z.head), 0x1p-48), scaled_of(1, 0, -1070 - unit));
        if (is_alone(d, i) && less(root->nearest, reach)) close[count++] = i;
        d->root[i].pressed = (unsigned char)(all && is_alone(d, i));
    }
    for (int i = 0; i < count && !all; i++) {
        box[i] = box_of(d, close[i], unit).box;
        for (int j = 0; j < i; j++)
            if (meet(box[i], box[j])) met = d->root[close[i]].pressed = d->root[close[j]].pressed = 1;
    }
    algsurf_memory_release(d->m, mark);
    return !met || algsurf_i_discs_run(d, ALGSURF_I_MOST_SWEEPS, &open);
}

int algsurf_i_deliver(algsurf_i_discs *d, algsurf_i_answer *a) {
    if (a->precise) return algsurf_i_deliver_precisely(d, a);
    algsurf_complex_root *roots = a->roots + a->count;
    if (!d->p->radius && !press(d, a->unit, a->pressed)) return 0;
    a->factors++;
    a->count += make_boxes(d, a->unit, roots);
    a->moved += d->moved;
    return 1;
}

int algsurf_i_join_boxes(algsurf_complex_root *e, int count, int real) {
    count = join(e, count, real);
    qsort(e, (size_t)count, sizeof *e, compare);
    return count;
}
