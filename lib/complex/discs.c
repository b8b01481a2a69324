/* discs.c - discs that hold all roots of a polynomial: everything here is a proof.
 *
 * Discs (Smith 1970; Gershgorin for diag(z) - W 1^T, whose characteristic polynomial is p / c_n).  For
 * distinct z_1 .. z_n and W_i = p(z_i) / D_i, D_i = c_n prod_{j != i} (z_i - z_j), the discs about z_i with
 * radius n |W_i| cover all roots of p, and a union of k of them that no other touches holds exactly k.
 *
 * Narrower.  p(z_i) = c_n prod_j (z_i - r_j) over all roots, so r_i is exactly z_i - p(z_i) / (c_n prod_{j !=
 * i} (z_i - r_j)).  If r_j is within R_j of z_j, and s = sum_{j != i} R_j / |z_i - z_j| <= 1/2, this differs
 * from W_i by at most |W_i| (1 / prod (1 - R_j / |z_i - z_j|) - 1) <= 2 s |W_i|.  With radii that holds for
 * each polynomial of the set and its W, which is off that of the middle by p's error / D and, for c_n's, by
 * |W| r_n / (|c_n| - r_n).  The members of a group are matched with its roots somehow: no root is farther
 * from its point than twice the discs' radii together.
 *
 * Rounding.  A difference is off by 2^-25 of itself (point.c), the product of n - 1 of them, with the
 * roundings, by n 2^-24, as n <= 1024 keeps (1 + 2^-25)^n below 1 + n 2^-24.5.  All else is off by a few u.
 */
#include "../base/arithmetic.h"
#include <math.h>
#include <stdlib.h>

#include "discs.h"

#define SLACK 0x1p-24    /* relative error of a product, for each factor */
#define UP (1 + 0x1p-40) /* for what is rounded a few hundred times */
#define ENOUGH 0x1p24    /* a value exceeds its error by that */

/* |a|, rounded up. */
static algsurf_scaled size_up(algsurf_scaled a) { return by(size_of(a), UP); }

/* ---- values ---- */

/* Upper bounds of sum_k C(k,j) r_k |z|^(k-j) for j = 0 to `last`: what radii make of Taylor's coefficients.
 */
static void set_spread(const algsurf_i_integers *p, const algsurf_i_point *z, int last,
                       algsurf_scaled *spread) {
    algsurf_scaled far = size_up(z->head);
    for (int j = 0; j <= last; j++) spread[j] = scaled_none();
    for (int k = p->re.degree; k >= 0 && p->radius; k--)
        for (int j = last; j >= 0; j--)
            spread[j] = sum(times(spread[j], far), j > 0 ? spread[j - 1] : p->radius[k]);
    for (int j = 0; j <= last; j++) spread[j] = by(spread[j], UP);
}

/* p(z) is `value`, off by `lost`, for the coefficients in the middle. */
static void set_known(algsurf_i_discs *d, algsurf_i_disc *root, algsurf_scaled value, algsurf_scaled lost) {
    algsurf_scaled spread;
    set_spread(d->p, &root->z, 0, &spread);
    root->stuck = d->p->radius && !less(by(spread, 4), size_up(value));
    root->value = value, root->lost = sum(lost, spread);
    root->known = 1;
}

int algsurf_i_clear_taylor(algsurf_i_discs *d, const algsurf_i_point *z, int last, double clear, int *w,
                           algsurf_scaled *spread) {
    set_spread(d->p, z, last, spread);
    for (;; *w += *w / 2 + 1) {
        if (!algsurf_i_taylor(&d->sums, d->p, z, last, *w)) return 0;
        algsurf_scaled least = by(d->sums.lost, clear);
        if (!less(size_of(algsurf_i_sum_head(d->sums.at)), least) || less(least, spread[0])) return 1;
    }
}

/* ---- discs ---- */

/* For sizes that are not normalised. */
static int is_nearer(algsurf_scaled a, algsurf_scaled b) {
    return a.exponent == b.exponent ? a.re < b.re : less(normal(a), normal(b));
}

/* step = c_n prod (z - z_j), and nearest. */
static int set_products(algsurf_i_discs *d) {
    algsurf_scaled lead = d->p->head[d->n], a;
    for (int i = 0; i < d->n; i++) d->root[i].step = lead, d->root[i].nearest = ALGSURF_I_ENDLESS;
    for (int i = 0; i < d->n; i++)
        for (int j = 0; j < i; j++) {
            algsurf_i_disc *one = d->root + i, *two = d->root + j;
            if (!algsurf_i_gap(d->m, &one->z, &two->z, &a)) return 0;
            algsurf_scaled least = {0.5 * fmax(fabs(a.re), fabs(a.im)), 0, a.exponent};
            if (is_nearer(least, one->nearest)) one->nearest = least;
            if (is_nearer(least, two->nearest)) two->nearest = least;
            scaled_multiply(&one->step, a.re, a.im, a.exponent);
            scaled_multiply(&two->step, -a.re, -a.im, a.exponent);
        }
    for (int i = 0; i < d->n; i++) {
        d->root[i].step = normal(d->root[i].step);
        d->root[i].nearest = normal(d->root[i].nearest);
    }
    return 1;
}

/* How much larger 1/|c_n| may be than at the middle, relatively: r / (|c_n| - r). */
static algsurf_scaled spread_of_lead(const algsurf_i_integers *p) {
    if (!p->radius) return scaled_none();
    const int n = p->re.degree;
    algsurf_scaled r = p->radius[n], least = by(size_of(p->head[n]), 1 - 0x1p-45);
    return by(over(r, by(sum(least, negative(r)), 1 - 0x1p-45)), UP);
}

static int set_discs(algsurf_i_discs *d) {
    const int n = d->n;
    algsurf_scaled lead = spread_of_lead(d->p),
                   loss = by(sum(lead, scaled_of(1, 0, 0)), (1 + n * SLACK) * UP);
    if (!set_products(d)) return 0;
    for (int i = 0; i < n; i++) {
        algsurf_i_disc *root = d->root + i;
        algsurf_scaled product = root->step;
        root->disc = ALGSURF_I_ENDLESS;
        root->step = scaled_none();
        if (is_zero(product)) continue;
        algsurf_scaled unit = over(loss, size_of(product));
        root->step = over(root->value, product);
        root->error = by(sum(times(root->lost, unit), times(size_up(root->step), lead)), UP);
        root->disc = by(times(sum(size_up(root->value), root->lost), unit), n * UP);
    }
    return 1;
}

/* ---- groups ---- */

static int first_of(const algsurf_i_discs *d, int i) {
    while (d->root[i].group != i) i = d->root[i].group;
    return i;
}

static int touch(algsurf_i_discs *d, int i, int j, int *result) {
    algsurf_scaled distance, reach = by(sum(d->root[i].disc, d->root[j].disc), 1 + 0x1p-20);
    if (!difference(d, i, j, &distance)) return 0;
    *result = distance.exponent <= reach.exponent && !less(reach, size_up(distance));
    return 1;
}

static int set_groups(algsurf_i_discs *d) {
    algsurf_scaled most = scaled_none();
    for (int i = 0; i < d->n; i++) most = larger(most, d->root[i].disc);
    for (int i = 0; i < d->n; i++) {
        d->root[i].group = i;
        d->root[i].members = 0;
        if (less(by(sum(d->root[i].disc, most), 1 + 0x1p-20), d->root[i].nearest)) continue;
        for (int j = 0; j < i; j++) {
            int together;
            if (!touch(d, i, j, &together)) return 0;
            if (!together) continue;
            int a = first_of(d, i), b = first_of(d, j);
            d->root[a > b ? a : b].group = a > b ? b : a;
        }
    }
    for (int i = 0; i < d->n; i++) d->root[d->root[i].group = first_of(d, i)].members++;
    return 1;
}

/* s of root i.  First with the largest reach and the least distance for all; then in doubles, where a reach
 * counts as 2^-300 at least, and as 2^600 at most, which exceeds any distance: those are within 2^+-300. */
static int share_of(algsurf_i_discs *d, int i, algsurf_scaled most, algsurf_scaled *share) {
    algsurf_i_disc *root = d->root + i;
    algsurf_scaled far;
    double s = 0;
    *share = by(over(most, root->nearest), d->n * UP);
    if (share->exponent < -24) return 1; /* below what rounding costs */
    for (int j = 0; j < d->n; j++) {
        if (j == i) continue;
        if (!algsurf_i_gap(d->m, &root->z, &d->root[j].z, &far)) return 0;
        const algsurf_scaled *reach = &d->root[d->root[j].group].next;
        int64_t k = reach->exponent - far.exponent;
        k = k < -300 ? -300 : k > 600 ? 600 : k;
        s += reach->re * power_of_two(k) / sqrt(far.re * far.re + far.im * far.im);
    }
    *share = scaled_of(fmin(s, 1), 0, 0);
    *share = by(*share, 1 + d->n * SLACK);
    return 1;
}

/* How far roots that are alone can be from z - step, where it is worth the time: |W| well below |z|. */
static int set_blur(algsurf_i_discs *d) {
    algsurf_scaled most = scaled_none();
    for (int i = 0; i < d->n; i++) d->root[i].next = scaled_none();
    for (int i = 0; i < d->n; i++) {
        algsurf_scaled *reach = &d->root[d->root[i].group].next;
        *reach = sum(*reach, by(d->root[i].disc, 2));
        most = larger(most, *reach);
    }
    for (int i = 0; i < d->n; i++) {
        algsurf_i_disc *root = d->root + i;
        algsurf_scaled share;
        root->blur = ALGSURF_I_ENDLESS;
        if (!is_alone(d, i)) continue;
        if (!root->stuck && root->disc.exponent > root->z.head.exponent - 16) continue;
        if (!share_of(d, i, most, &share)) return 0;
        if (share.exponent >= -1) continue;
        share = sum(by(share, 2), scaled_of(d->n * SLACK, 0, 0));
        root->blur = times(size_up(root->step), by(share, UP));
        root->error = times(root->error, by(sum(share, scaled_of(1, 0, 0)), UP));
    }
    return 1;
}

/* Which points are conjugate; p is there, too. */
static void set_mates(algsurf_i_discs *d) {
    for (int i = 0; i < d->n; i++) d->root[i].mate = -1;
    for (int i = 0; i < d->n && d->p->real; i++)
        for (int j = 0; d->root[i].z.flat[1] != 0 && j < i && d->root[i].mate < 0; j++)
            if (algsurf_i_is_conjugate(&d->root[i].z, &d->root[j].z))
                d->root[i].mate = j, d->root[j].mate = i;
}

/* Values in doubles, for points that are doubles; those that suffice are known then.  The first and the last
 * coefficient are at least 2^-700 (propose.c), so that the sum of sizes S is at least 2^-700 max(1,|z|)^n:
 * beside u^2 S it is nothing that underflows, or that coefficients below 2^-1000 are left out.  33 in place
 * of 32 covers that, and the roundings of the bound. */
static int try_doubles(algsurf_i_discs *d) {
    const algsurf_i_flat *p = &d->p->flat;
    const size_t n = (size_t)d->n;
    algsurf_memory_mark mark = algsurf_memory_here(d->m);
    double *x = algsurf_i_take(d->m, 5 * n * sizeof *x);
    int *who = algsurf_i_take(d->m, n * sizeof *who), count = 0;
    if (!x || !who) return 0;
    double *y = x + n, *re = y + n, *im = re + n, *sum = im + n;
    for (int i = 0; i < d->n; i++) {
        const algsurf_i_disc *root = d->root + i;
        const algsurf_scaled at = root->z.head;
        if (root->known || !root->z.exact || (root->mate >= 0 && root->mate < i)) continue;
        if (llabs(at.exponent - p->unit) > 400) continue;
        x[count] = ldexp(at.re, (int)(at.exponent - p->unit));
        y[count] = ldexp(at.im, (int)(at.exponent - p->unit));
        who[count++] = i;
    }
    algsurf_i_allroots_kernel_for(algsurf_i_kernel_find(NULL))->values(p, x, y, count, re, im, sum);
    for (int k = 0; k < count; k++) {
        algsurf_i_disc *root = d->root + who[k];
        double lost = 33.0 * d->n * (d->n + 2) * 0x1p-106 * sum[k] + 0x1p-52 * (fabs(re[k]) + fabs(im[k]));
        if (!(fmax(fabs(re[k]), fabs(im[k])) >= ENOUGH * lost && sum[k] <= 0x1p900)) continue;
        set_known(d, root, scaled_of(re[k], im[k], p->top), scaled_of(lost, 0, p->top));
    }
    algsurf_memory_release(d->m, mark);
    return 1;
}

static int set_values(algsurf_i_discs *d) {
    set_mates(d);
    if (d->p->flat.exact && !try_doubles(d)) return 0;
    for (int i = 0; i < d->n; i++) {
        algsurf_i_disc *root = d->root + i;
        if (root->known) continue;
        if (root->mate < 0 || root->mate > i) {
            algsurf_scaled spread;
            if (!algsurf_i_clear_taylor(d, &root->z, 0, ENOUGH, &root->width, &spread)) return 0;
            set_known(d, root, algsurf_i_sum_head(d->sums.at), d->sums.lost);
            continue;
        }
        const algsurf_i_disc *mate = d->root + root->mate;
        root->value = mate->value, root->lost = mate->lost, root->width = mate->width;
        root->value.im = -root->value.im;
        root->stuck = mate->stuck, root->known = 1;
    }
    return 1;
}

int algsurf_i_discs_prove(algsurf_i_discs *d) {
    return set_values(d) && set_discs(d) && set_groups(d) && set_blur(d);
}
