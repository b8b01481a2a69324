/* on_axis.c - the real roots of a squarefree polynomial, from discs about all of its roots.
 *
 * A root alone in its disc is its own conjugate if the mirror image of the disc meets no other disc: its
 * conjugate is in that image, and each root is in its disc.  A disc off the axis has no real root.  Of the
 * others, |y| is at most the radius, so that the image lies within three radii of the point.
 *
 * The interval.  The root is within R of x = z - W, cut to multiples of about 2^-10 R, and the interval about
 * x reaches that far.  It stays within the disc, n |W| >= 3 |W|, and so has no other root, as long as
 * R < 2 |W|: else the root counts as not found. */
#include "../base/arithmetic.h"
#include <string.h>

#include "discs.h"

int algsurf_i_is_real(algsurf_i_discs *d, int i, int *answer) {
    const algsurf_i_disc *root = d->root + i;
    algsurf_scaled far;
    *answer = !less(root->disc, by(root->z.above, 1 - 0x1p-50));
    for (int j = 0; *answer > 0 && j < d->n; j++) {
        if (j == i) continue;
        if (!difference(d, i, j, &far)) return 0;
        algsurf_scaled reach = sum(by(root->disc, 3), d->root[j].disc);
        if (!less(by(reach, 1 + 0x1p-20), size_of(far))) *answer = -1;
    }
    return 1;
}

/* The interval about real root i; *done 0: not known. */
static int set_interval(algsurf_i_discs *d, int i, algsurf_i_root_on_axis *at, int *done) {
    algsurf_i_point x = {.room = 0};
    algsurf_scaled R;
    if (!algsurf_i_centre(d, i, 1, &x, &R)) return 0;
    int exact = is_zero(R);
    *done = exact || less(R, by(size_of(d->root[i].step), 2));
    if (!*done) return 1;
    int64_t low = exact ? x.exponent : R.exponent - 10, up = x.exponent - low > 0 ? x.exponent - low : 0;
    int w = x.w + (int)(up / 64) + 2;
    algsurf_limb *a = algsurf_memory_take(d->m, 2 * (size_t)w);
    if (!a) return 0;
    algsurf_limb *b = a + w;
    algsurf_z_zero(a, 2 * w);
    algsurf_i_add_shifted(a, w, x.x, x.w, x.exponent - low);
    *at = (algsurf_i_root_on_axis){a, exact ? NULL : b, w, (int)-low};
    if (exact) return 1;
    algsurf_z_copy(b, w, a, w);
    algsurf_limb reach = (algsurf_limb)(R.re * 0x1p10) + 1;
    algsurf_z_add_limbs(a, w, 0, reach);
    algsurf_z_add_limbs(b, w, reach, 0);
    return 1;
}

/* f_0 is not 0. */
static int find(algsurf_memory *m, const algsurf_zpoly *f, int most, algsurf_i_root_on_axis *at, int *count) {
    algsurf_i_integers z;
    algsurf_i_discs d;
    int open, corrections = 0, n = f->degree, *order = algsurf_i_take(m, (size_t)n * sizeof *order);
    *count = -1;
    if (!order || !algsurf_i_make_integers(m, f, NULL, &z)) return 0;
    if (!algsurf_i_discs_separate(&d, m, &z, most, &open, &corrections)) return 0;
    int found = 0, done = open == 0;
    for (int i = 0; i < n && done; i++) {
        int real, k = found;
        if (!algsurf_i_is_real(&d, i, &real)) return 0;
        if (real < 0) return 1;
        if (real == 0) continue;
        for (; k > 0; order[k] = order[k - 1], k--) {
            algsurf_scaled a;
            if (!difference(&d, i, order[k - 1], &a)) return 0;
            if (a.re > 0) break;
        }
        order[k] = i;
        found++;
    }
    for (int k = 0; k < found && done; k++)
        if (!set_interval(&d, order[k], at + k, &done)) return 0;
    if (done) *count = found;
    return 1;
}

int algsurf_i_roots_on_axis(algsurf_memory *m, const algsurf_zpoly *f, int most, algsurf_i_root_on_axis *at,
                            int *count) {
    if (algsurf_z_sign(f->c, f->width) != 0) return find(m, f, most, at, count);
    const algsurf_zpoly rest = {f->degree - 1, f->width, algsurf_zpoly_at(f, 1)};
    algsurf_limb *zero = algsurf_memory_take(m, 1);
    if (!zero || !find(m, &rest, most, at, count)) return 0;
    if (*count < 0) return 1;
    int below = 0; /* no interval has 0 inside, or none could be narrow */
    while (below < *count && algsurf_z_negative(at[below].a, at[below].width)) below++;
    memmove(at + below + 1, at + below, (size_t)(*count - below) * sizeof *at);
    *zero = 0;
    at[below] = (algsurf_i_root_on_axis){zero, NULL, 1, 0};
    ++*count;
    return 1;
}
