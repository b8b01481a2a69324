/* part.c - brings points to the roots of a polynomial, and roots apart: nothing here has to be proved.
 *
 * Step.  p(x) = c_n prod (x - z_j) (1 + sum W_j / (x - z_j)), by Lagrange's formula: the W_j alone tell the
 * roots, the better the closer the points are to them (the secular equation of Bini and Robol 2014).
 * Ehrlich's and Aberth's method (1967, 1973) goes some steps towards them in doubles, from x_i = z_i on,
 * before p is computed again.  With u = x_i - z_i, g(x) = 1 + sum_{j != i} W_j / (x - z_j), v = u g + W_i and
 * all sums over j != i, p'/p - sum 1 / (x_i - x_j) is (g + u g') / v - sum (x_j - z_j) / ((x_i - z_j) (x_i -
 * x_j)): where u = 0, too.
 *
 * Clusters.  Towards m roots close together this goes on by some bits a sweep only.  Taylor's coefficients
 * about their middle, where that of y^(m-1) is 0, tell how far apart they are (Newton's polygon), however
 * small that is beside the way to all others.  The middle is a simple root of the derivative p^(m-1): each
 * Newton step doubles its digits. */
#include "../base/arithmetic.h"
#include <math.h>
#include <string.h>

#include "discs.h"

#define NARROW_PART 56 /* bits by which blur is below each part of a root, */
#define NARROW 72      /* or below the larger one; of a root whose box meets another: below all doubles */
#define LEAST_BITS 64  /* of a point */
#define PATIENCE 6     /* sweeps after which a group is taken for a cluster */
#define MIDDLE_STEPS 40
#define STEPS_ON_W 4 /* between values of p; 24 bits of W are right */
#define CLEAR 0x1p10 /* a coefficient exceeds its error by that */

static algsurf_scaled part(double x, int64_t exponent) { return scaled_of(fabs(x), 0, exponent); }

/* Lower points that are nearly the conjugates of upper ones become so. */
static void pair(const algsurf_scaled *z, int n, algsurf_scaled *paired) {
    for (int j = 0; j < n; j++) {
        paired[j] = z[j];
        algsurf_scaled least = part(z[j].im, z[j].exponent - 26);
        for (int i = 0; i < n && z[j].im < 0; i++) {
            algsurf_scaled mate = {z[i].re, -z[i].im, z[i].exponent};
            if (z[i].im > 0 && less(size_of(sum(z[j], negative(mate))), least)) paired[j] = mate;
        }
    }
}

int algsurf_i_discs_begin(algsurf_i_discs *d, algsurf_memory *m, algsurf_i_integers *p,
                          const algsurf_scaled *given, int *corrections) {
    const int n = p->re.degree;
    *d = (algsurf_i_discs){.p = p, .m = m, .n = n, .sums = {.m = m, .last = -1}};
    d->root = algsurf_i_take(m, (size_t)n * sizeof *d->root);
    algsurf_scaled *z = algsurf_i_take(m, 2 * (size_t)n * sizeof *z);
    if (!d->root || !z || !algsurf_i_propose(m, p, given, z, corrections, &d->settled)) return 0;
    memset(d->root, 0, (size_t)n * sizeof *d->root);
    if (d->p->real) pair(z, n, z + n), z += n;
    for (int i = 0; i < n; i++) {
        d->root[i].width = 2;
        d->root[i].multiplicity[0] = d->root[i].multiplicity[1] = 1;
        if (!algsurf_i_set_point(m, &d->root[i].z, &algsurf_i_origin, z[i], z[i].exponent - 60, 0)) return 0;
    }
    return 1;
}

/* ---- steps ---- */

/* Whether the box about z - step is as narrow as is asked, and the disc does not keep those of others wide:
 * then no share of discs.c exceeds 1/4. */
static int is_narrow(const algsurf_i_discs *d, int i) {
    const algsurf_i_disc *root = d->root + i;
    algsurf_scaled at = sum(root->z.head, negative(root->step)), blur = root->blur;
    algsurf_scaled x = part(at.re, at.exponent), y = part(at.im, at.exponent), most = larger(x, y);
    if (root->stuck && !less(blur, ALGSURF_I_ENDLESS)) return 1;
    if (!root->stuck && !less(by(root->disc, 8.0 * d->n), root->nearest)) return 0;
    if (d->more > 0) blur = sum(blur, root->error);
    if (is_zero(blur)) return 1;
    const int64_t narrow = root->pressed ? ALGSURF_I_RANGE_OF_DOUBLES : NARROW + d->more;
    blur.exponent += narrow;
    if (!less(most, blur) || d->more > 0) return !less(most, blur);
    blur.exponent += NARROW_PART - narrow;
    int on_axis = d->p->real && !less(root->disc, y);
    return !less(x, blur) && (on_axis || !less(y, blur));
}

/* Moves point i, the digits that are right tripled. */
static int move(algsurf_i_discs *d, int i, algsurf_scaled step) {
    algsurf_i_disc *root = d->root + i;
    int64_t top = larger(root->z.head, step).exponent, bits = 3 * (top - step.exponent) + 20;
    int on_axis = d->p->real && is_alone(d, i) && !less(root->disc, root->z.above);
    d->moved++;
    root->known = 0;
    return algsurf_i_set_point(d->m, &root->z, &root->z, negative(step),
                               top - (bits < LEAST_BITS ? LEAST_BITS : bits), on_axis);
}

/* a in units of 2^unit, or 2^300 of them at most: sums that only steer need no more. */
static algsurf_complex in_units(algsurf_scaled a, int64_t unit) {
    const int64_t k = a.exponent - unit;
    const double scale = k < -600 ? 0 : power_of_two(k < 300 ? k : 300);
    return (algsurf_complex){a.re * scale, a.im * scale};
}

static algsurf_complex quotient(algsurf_complex a, algsurf_complex b) {
    const double unit = 1 / (b.re * b.re + b.im * b.im);
    return (algsurf_complex){(a.re * b.re + a.im * b.im) * unit, (a.im * b.re - a.re * b.im) * unit};
}

/* Makes x_i = z_i - next better; *settled stays where it was good.  Where another point is, or where there is
 * no W, it is a little aside, each point in its own direction. */
static int improve(algsurf_i_discs *d, int i, int *settled) {
    algsurf_i_disc *root = d->root + i;
    const algsurf_scaled u = negative(root->next);
    const int64_t reach = larger(u, root->step).exponent;
    algsurf_complex g = {1, 0}, slope = {0, 0}, turned = {0, 0}; /* slope times -u, `turned` times 2^reach */
    algsurf_scaled size = root->z.head, a;
    double way[2];
    if (is_zero(size)) size = scaled_of(1, 0, -64);
    algsurf_i_aside(i, way);
    const algsurf_scaled aside = scaled_of(way[0], way[1], size.exponent - 10);
    if (!less(root->disc, ALGSURF_I_ENDLESS)) return root->next = aside, 1;
    for (int j = 0; j < d->n; j++) {
        if (j == i) continue;
        const algsurf_i_disc *other = d->root + j;
        if (!algsurf_i_gap(d->m, &root->z, &other->z, &a)) return 0;
        const int64_t unit = a.exponent;
        const algsurf_complex by = in_units(u, unit), way_of_other = in_units(other->next, unit);
        const algsurf_complex old = {a.re + by.re, a.im + by.im}, now = plus(old, way_of_other);
        if ((old.re == 0 && old.im == 0) || (now.re == 0 && now.im == 0)) continue;
        const algsurf_complex share = quotient(in_units(other->step, unit), old);
        g = plus(g, share);
        if (!is_zero(u)) slope = plus(slope, product(share, quotient(by, old)));
        if (is_zero(other->next)) continue;
        const algsurf_scaled one = {1, 0, reach};
        turned = plus(turned, product(quotient(way_of_other, now), quotient(in_units(one, unit), old)));
    }
    const algsurf_complex v = plus(product(in_units(u, reach), g), in_units(root->step, reach));
    const algsurf_complex x = product(v, turned);
    const algsurf_complex below = {g.re - slope.re + x.re, g.im - slope.im + x.im};
    if (!(fabs(below.re) + fabs(below.im) > 0x1p-10 && fabs(v.re) + fabs(v.im) < 0x1p500)) {
        if (is_zero(root->next)) root->next = aside;
        return 1;
    }
    const algsurf_complex way_on = quotient(v, below);
    const algsurf_scaled better = scaled_of(way_on.re, way_on.im, reach);
    *settled = *settled && better.exponent < root->next.exponent - 12;
    root->next = sum(root->next, better);
    if (root->next.exponent > size.exponent + 1) root->next.exponent = size.exponent + 1;
    return 1;
}

/* A step of Newton's method, the digits that are right doubled: for roots by themselves of which doubles know
 * all they can tell.  *done 0: there is none. */
static int sharpen(algsurf_i_discs *d, int i, int *done) {
    algsurf_i_disc *root = d->root + i;
    const algsurf_scaled step = root->step;
    int64_t least = larger(root->z.head, step).exponent - NARROW - d->more - LEAST_BITS,
            low = 2 * step.exponent - root->nearest.exponent - 10;
    if (low < least) low = least;
    *done = d->more > 0 && is_alone(d, i) && !root->stuck && low < step.exponent - LEAST_BITS &&
            less(by(root->disc, 8.0 * d->n), root->nearest);
    if (!*done) return 1;
    const int on_axis = d->p->real && !less(root->disc, root->z.above);
    root->width += (int)((step.exponent - low) / 64) + 1;
    root->known = 0;
    d->moved++;
    if (!algsurf_i_taylor(&d->sums, d->p, &root->z, 1, root->width)) return 0;
    return algsurf_i_subtract_quotient(&d->sums, &root->z, 0, 1, low, on_axis);
}

/* ---- clusters ---- */

/* The mean of a group, in *middle; how far its members are apart at most, and from all others at least: 0
 * where there is no mean. */
static int mean_of(algsurf_i_discs *d, int g, algsurf_i_point *middle, algsurf_scaled *wide,
                   algsurf_scaled *away) {
    algsurf_scaled mean = scaled_none(), a;
    *wide = scaled_none(), *away = ALGSURF_I_ENDLESS;
    for (int i = 0; i < d->n; i++) {
        if (!difference(d, i, g, &a)) return 0;
        algsurf_scaled size = size_of(a);
        if (d->root[i].group == g)
            mean = sum(mean, a), *wide = larger(*wide, size);
        else if (less(size, *away))
            *away = size;
    }
    const algsurf_i_point *z = &d->root[g].z;
    if (is_zero(*wide)) return *away = *wide, 1; /* all at one place */
    int on_axis = d->p->real && !less(*wide, z->above);
    return algsurf_i_set_point(d->m, middle, z, by(mean, 1.0 / d->root[g].members),
                               wide->exponent - LEAST_BITS, on_axis);
}

/* All values of a group are lost in the radii. */
static int is_stuck(const algsurf_i_discs *d, int g) {
    int stuck = 1;
    for (int i = g; i < d->n; i++) stuck = stuck && (d->root[i].group != g || d->root[i].stuck);
    return stuck;
}

/* Puts the m points of a group where the polygon about its middle says, if they are not about there already.
 */
static int place(algsurf_i_discs *d, int g) {
    const int m = d->root[g].members;
    int w = d->root[g].width;
    algsurf_i_point middle = {.room = 0};
    algsurf_scaled wide, away;
    algsurf_scaled *q = algsurf_i_take(d->m, 3 * (size_t)(m + 1) * sizeof *q);
    if (!q || !mean_of(d, g, &middle, &wide, &away)) return 0;
    if (!less(by(wide, 16), away)) return 1;
    algsurf_scaled *spread = q + m + 1, *z = spread + m + 1;
    for (int k = 0; k < MIDDLE_STEPS; k++) {
        if (w < 2 * middle.w + 2) w = 2 * middle.w + 2;
        if (!algsurf_i_clear_taylor(d, &middle, m, CLEAR, &w, spread)) return 0;
        algsurf_i_sum *c = d->sums.at;
        for (int j = 0; j <= m; j++) q[j] = algsurf_i_sum_head(c + j);
        if (is_zero(q[m])) return 1;
        algsurf_scaled shift = over(q[m - 1], by(q[m], m));
        int64_t reach = (sum(size_of(q[0]), spread[0]).exponent - q[m].exponent) / m;
        if (is_zero(shift) || shift.exponent < reach - 4) break;
        int64_t gain = (less(away, ALGSURF_I_ENDLESS) ? away : middle.head).exponent - shift.exponent;
        int64_t low = shift.exponent - LEAST_BITS - (gain > 0 ? gain : 0);
        if (!algsurf_i_subtract_quotient(&d->sums, &middle, m - 1, m, low,
                                         middle.above.re == 0 && d->p->real))
            return 0;
    }
    for (int j = 0; j <= m; j++) q[j] = sum(size_of(q[j]), j < m ? spread[j] : scaled_none());
    if (is_zero(q[0])) return 1;
    int fit;
    if (!algsurf_i_start(d->m, q, m, z, &fit)) return 0;
    if (!d->p->radius && !less(by(size_of(z[m - 1]), 4), wide)) return 1;
    const int stuck = is_stuck(d, g);
    for (int i = 0; i < d->n; i++) {
        algsurf_i_disc *root = d->root + i;
        if (root->group != g) continue;
        root->width = w, root->known = 0, root->done = 1, root->placed = (unsigned char)stuck;
        if (!algsurf_i_set_point(d->m, &root->z, &middle, *z, z->exponent - LEAST_BITS, 0)) return 0;
        z++;
    }
    return 1;
}

/* ---- sweeps ---- */

/* Which roots need a step: those alone that are not narrow, those in a group whose discs are about its
 * largest.  How many these are. */
static int count_open(algsurf_i_discs *d) {
    int open = 0;
    for (int i = 0; i < d->n; i++) d->root[i].next = scaled_none();
    for (int i = 0; i < d->n; i++) {
        algsurf_scaled *most = &d->root[d->root[i].group].next;
        *most = larger(*most, d->root[i].disc);
    }
    for (int i = 0; i < d->n; i++) {
        algsurf_i_disc *root = d->root + i;
        algsurf_scaled disc = root->disc;
        disc.exponent += 10;
        root->done = is_alone(d, i) ? (unsigned char)is_narrow(d, i)
                                    : root->placed || root->stuck || less(disc, d->root[root->group].next);
        open += !root->done;
    }
    return open;
}

/* A group whose discs are as they were for some sweeps, or whose values are all lost in the radii. */
static int is_cluster(algsurf_i_discs *d, int g) {
    algsurf_i_disc *first = d->root + g;
    first->age = first->members > 1 && first->members == first->before ? first->age + 1 : 0;
    first->before = first->members;
    if (first->members < 2 || first->placed) return 0;
    if (first->age < PATIENCE && !is_stuck(d, g)) return 0;
    first->age = -2 * PATIENCE;
    return 1;
}

/* Whether root i is at the conjugate of one that moves, both clear of the axis: it stays there. */
static int follows_mate(const algsurf_i_discs *d, int i) {
    const algsurf_i_disc *root = d->root + i;
    return root->mate >= 0 && root->mate < i && !d->root[root->mate].done && less(root->disc, root->z.above);
}

/* No point has moved. */
static int all_known(const algsurf_i_discs *d) {
    int all = 1;
    for (int i = 0; i < d->n; i++) all = all && d->root[i].known;
    return all;
}

/* Roots next to a double, in each part, go there: they are that double, or at one side of it, by much more
 * than their discs' radii. */
static int snap(algsurf_i_discs *d) {
    algsurf_scaled z[2];
    for (int i = 0; i < d->n; i++) {
        algsurf_i_disc *root = d->root + i;
        if (d->p->radius || root->snapped || !is_alone(d, i) || !algsurf_i_double_inside(d, i, z)) continue;
        const int least = is_zero(z[0]) || (!is_zero(z[1]) && z[1].exponent < z[0].exponent);
        const int64_t low = z[least].exponent - 53;
        root->snapped = 1;
        root->known = 0;
        d->moved++;
        if (!algsurf_i_set_point(d->m, &root->z, &algsurf_i_origin, z[!least], low, 0) ||
            !algsurf_i_set_point(d->m, &root->z, &root->z, z[least], low, 0))
            return 0;
        const int whole = algsurf_i_whole_width(d->p, &root->z); /* as a rule the value is 0 */
        root->width = whole > root->width ? whole : root->width;
    }
    return 1;
}

/* Where open points go. */
static int plan_steps(algsurf_i_discs *d) {
    for (int i = 0; i < d->n; i++) d->root[i].next = scaled_none();
    for (int k = 0, settled = 0; k < STEPS_ON_W && !settled; k++) {
        settled = 1;
        for (int i = 0; i < d->n; i++) {
            algsurf_i_disc *root = d->root + i;
            if (root->done) continue;
            if (!follows_mate(d, i)) {
                if (!improve(d, i, &settled)) return 0;
                continue;
            }
            root->next = d->root[root->mate].next;
            root->next.im = -root->next.im;
        }
    }
    return 1;
}

/* Moves open point i. */
static int take_step(algsurf_i_discs *d, int i) {
    algsurf_i_disc *root = d->root + i;
    int done;
    if (follows_mate(d, i)) {
        root->known = 0;
        return algsurf_i_set_conjugate(d->m, &root->z, &d->root[root->mate].z);
    }
    if (!sharpen(d, i, &done)) return 0;
    return done || is_zero(root->next) || move(d, i, root->next);
}

int algsurf_i_discs_run(algsurf_i_discs *d, int most, int *open) {
    if (!all_known(d) && !algsurf_i_discs_prove(d)) return 0;
    for (int k = 0;; k++) {
        *open = count_open(d);
        if (k >= most && (*open > 0 || d->p->radius)) return 1; /* before points move: discs are of these */
        for (int g = 0; g < d->n; g++)
            if (is_cluster(d, g) && !place(d, g)) return 0;
        if (*open == 0 && all_known(d) && !snap(d)) return 0;
        if (*open == 0 && all_known(d)) return 1;
        if (!plan_steps(d)) return 0;
        for (int j = 0; j < d->n; j++)
            if (!d->root[j].done && !take_step(d, j)) return 0;
        if (!algsurf_i_discs_prove(d)) return 0;
    }
}
