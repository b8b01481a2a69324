/* prove.c - inclusion discs, groups, boxes: everything here is a proof.
 *
 * Theorem (Smith 1970; Gershgorin for diag(z) - W 1^T, whose characteristic polynomial is p / c_n).  For
 * distinct z_1 .. z_n and W_i = p(z_i) / (c_n prod_{j != i} (z_i - z_j)), the discs about z_i with radius
 * n |W_i| cover all roots of p, and a connected component made of k of them holds exactly k.
 *
 * It holds for the exact numbers z_i = (x + xl) + i (y + yl) kept here; |p(z_i)| <= residual.  Rounding:
 * a difference z_i - z_j is known to 8 u (high parts that nearly cancel subtract exactly, the low ones
 * always), the product of n-1 of them to 20 n u, all else to a few u: the factor (1 + 32 (n + 2) u) covers
 * it.  Squares of differences, their product and the residual have exponents of their own where they are
 * small or large: a subnormal number would not be known to a few u.  Two discs are apart only if the distance
 * less 16 u of it, and so the exact distance, is above the sum of the radii; where that is subnormal, both
 * are multiples of 2^-1074, and rounding of the distance, by half of that, takes it past no such number.
 */
#include "../base/arithmetic.h"
#include <math.h>

#include "impl.h"

/* |z_i - z_j|^2 = result 4^exponent, without overflow or underflow. */
static double distance2(const algsurf_i_roots *p, int i, int j, int *exponent) {
    algsurf_dd lx = algsurf_two_sum(p->xl[i], -p->xl[j]), ly = algsurf_two_sum(p->yl[i], -p->yl[j]);
    double dx = ((p->x[i] - p->x[j]) + lx.hi) + lx.lo, dy = ((p->y[i] - p->y[j]) + ly.hi) + ly.lo;
    double largest = fmax(fabs(dx), fabs(dy));
    *exponent = 0;
    if (!(largest > 0x1p-400 && largest < 0x1p400) && largest > 0 && largest < HUGE_VAL) {
        *exponent = ilogb(largest);
        dx = ldexp(dx, -*exponent);
        dy = ldexp(dy, -*exponent);
    }
    return dx * dx + dy * dy;
}

/* product[i] 2^(exponent/2) *= factor: prod |z_i - z_j|^2, kept from overflow and underflow. */
static void multiply(double *product, int *exponent, double factor, int factor_exponent) {
    int e;
    *product *= factor;
    *exponent += 2 * factor_exponent;
    if ((*product > 0x1p-100 && *product < 0x1p100) || !(*product > 0 && *product < HUGE_VAL)) return;
    (void)frexp(*product, &e);
    e -= e % 2;
    *product = ldexp(*product, -e);
    *exponent += e;
}

/* n |W_i|, rounded up; +inf when two approximations coincide. */
static void set_discs(algsurf_i_roots *p) {
    int n = p->n, *exponent = p->group;
    double *product = p->disc, lead = p->size[n] * (1 - 8 * ALGSURF_U) - p->radius[n];
    for (int i = 0; i < n; i++) {
        product[i] = 1;
        exponent[i] = 0;
        for (int j = 0; j < i; j++) {
            int e;
            double d2 = distance2(p, i, j, &e);
            multiply(product + i, exponent + i, d2, e);
            multiply(product + j, exponent + j, d2, e);
        }
    }
    for (int i = 0; i < n; i++) {
        int bounded = lead > 0 && product[i] > 0 && product[i] < HUGE_VAL;
        int e = p->exponent[i] - p->shift[n] - exponent[i] / 2, own = 0;
        double residual = p->residual[i] < HUGE_VAL ? frexp(p->residual[i], &own) : HUGE_VAL;
        double w = n * residual / (lead * sqrt(product[i])) * (1 + 32 * (n + 2) * ALGSURF_U);
        p->disc[i] = bounded ? ldexp(w, own + e) + 0x1p-1070 : HUGE_VAL;
    }
}

static int root_of(const int *group, int i) {
    while (group[i] != i) i = group[i];
    return i;
}

/* Most discs are so far apart that the high parts show it, whose low ones are at most u of them. */
static int clearly_apart(const algsurf_i_roots *p, int i, int j, double reach) {
    double dx = fabs(p->x[i] - p->x[j]), dy = fabs(p->y[i] - p->y[j]);
    double noise = 0x1p-50 * (fabs(p->x[i]) + fabs(p->x[j]) + fabs(p->y[i]) + fabs(p->y[j]));
    return dx > 2 * (reach + noise) || dy > 2 * (reach + noise);
}

static int discs_touch(const algsurf_i_roots *p, int i, int j) {
    double reach = p->disc[i] + p->disc[j];
    if (clearly_apart(p, i, j, reach)) return 0;
    int e;
    double d = sqrt(distance2(p, i, j, &e));
    return !(ldexp(d * (1 - 16 * ALGSURF_U), e) > reach);
}

int algsurf_i_roots_group(algsurf_i_roots *p) {
    int n = p->n, crowded = 0;
    set_discs(p);
    for (int i = 0; i < n; i++) {
        p->group[i] = i;
        p->done[i] = 1;
        for (int j = 0; j < i; j++) {
            if (!discs_touch(p, i, j)) continue;
            int a = root_of(p->group, i), b = root_of(p->group, j);
            p->group[a > b ? a : b] = a > b ? b : a;
        }
    }
    for (int i = 0; i < n; i++) {
        p->group[i] = root_of(p->group, i);
        if (p->group[i] != i) p->done[i] = p->done[p->group[i]] = 0;
    }
    for (int i = 0; i < n; i++) crowded += !p->done[i];
    return crowded;
}

/* high + low - r rounded down, or + r rounded up (side = +1). */
static double outward(double high, double low, double r, int side) {
    const double outside = side < 0 ? -HUGE_VAL : HUGE_VAL;
    algsurf_dd rest = algsurf_two_sum(low, side * r);
    double t = side * rest.lo > 0 ? nextafter(rest.hi, outside) : rest.hi;
    algsurf_dd total = algsurf_two_sum(high, t);
    return side * total.lo > 0 ? nextafter(total.hi, outside) : total.hi;
}

static algsurf_cinterval disc_box(const algsurf_i_roots *p, int i) {
    double r = p->disc[i];
    return (algsurf_cinterval){{outward(p->x[i], p->xl[i], r, -1), outward(p->x[i], p->xl[i], r, 1)},
                               {outward(p->y[i], p->yl[i], r, -1), outward(p->y[i], p->yl[i], r, 1)}};
}

static algsurf_interval hull(algsurf_interval a, algsurf_interval b) {
    return (algsurf_interval){fmin(a.lo, b.lo), fmax(a.hi, b.hi)};
}

static int meet(algsurf_cinterval a, algsurf_cinterval b) {
    return a.re.lo <= b.re.hi && b.re.lo <= a.re.hi && a.im.lo <= b.im.hi && b.im.lo <= a.im.hi;
}

static algsurf_cinterval mirror(algsurf_cinterval a) {
    return (algsurf_cinterval){a.re, {-a.im.hi, -a.im.lo}};
}

/* Box k joins box j; returns the number of boxes left. */
static int unite(algsurf_complex_root *e, int count, int j, int k) {
    e[j].box = (algsurf_cinterval){hull(e[j].box.re, e[k].box.re), hull(e[j].box.im, e[k].box.im)};
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

/* The boxes of unions of discs may meet where the discs do not. */
int algsurf_i_roots_join(algsurf_complex_root *e, int count, int real) {
    int first, second;
    while (find_pair(e, count, real, &first, &second)) count = unite(e, count, first, second);
    return count;
}

/* For real coefficients the mirror image of a box holds as many roots as the box, and now meets one box only,
 * whose image in turn meets only the first: the roots of either lie in what it shares with the image of the
 * other.  If a box meets its own image, a single root in it is real. */
static void use_symmetry(algsurf_complex_root *e, int count) {
    for (int i = 0; i < count; i++) {
        algsurf_cinterval image = mirror(e[i].box);
        int j = 0;
        while (j < count && !meet(image, e[j].box)) j++;
        if (j < i || j == count) continue;
        algsurf_cinterval *a = &e[i].box, *b = &e[j].box;
        *b = (algsurf_cinterval){{fmax(image.re.lo, b->re.lo), fmin(image.re.hi, b->re.hi)},
                                 {fmax(image.im.lo, b->im.lo), fmin(image.im.hi, b->im.hi)}};
        *a = mirror(*b);
        e[j].root = (algsurf_complex){e[i].root.re, -e[i].root.im};
        if (i != j) continue;
        e[i].root.im = 0;
        e[i].real = e[i].multiplicity == 1;
        if (e[i].real) a->im = (algsurf_interval){0, 0};
    }
}

int algsurf_i_roots_boxes(algsurf_i_roots *p, algsurf_complex_root *boxes) {
    int count = 0;
    for (int i = 0; i < p->n; i++) {
        int at = p->group[i]; /* the first of its group: i itself, or one met before */
        algsurf_cinterval box = disc_box(p, i);
        if (at == i) {
            p->exponent[i] = count; /* from here on: where the group's box is */
            boxes[count++] = (algsurf_complex_root){box, {p->x[i], p->y[i]}, 1, 0};
        } else {
            algsurf_complex_root *e = boxes + p->exponent[at];
            e->box = (algsurf_cinterval){hull(e->box.re, box.re), hull(e->box.im, box.im)};
            e->multiplicity++;
        }
    }
    count = algsurf_i_roots_join(boxes, count, p->real);
    if (p->real) use_symmetry(boxes, count);
    return count;
}
