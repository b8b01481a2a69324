/* squares.c - the roots of q(z^2), from those of q, which has half the degree.
 *
 * So are Chebyshev's, Legendre's and Hermite's polynomials, every other one of them but for the root 0, and
 * what becomes of polynomials in r = |z|.  q is squarefree as q(z^2) is.  Square roots of its roots are where
 * the discs of q(z^2) begin, right to 50 bits: which proves nothing, and has only to be near. */
#include "../base/arithmetic.h"
#include "discs.h"

/* p is q(z^2). */
static int halve(algsurf_memory *m, const algsurf_i_integers *p, algsurf_i_integers *q) {
    const algsurf_zpoly *part[2] = {&p->re, &p->im};
    algsurf_zpoly half[2];
    for (int i = 0; i < 2 && part[i]->c; i++) {
        if (!algsurf_zpoly_new(m, p->re.degree / 2, p->re.width, half + i)) return 0;
        for (int k = 0; k <= half[i].degree; k++)
            algsurf_z_copy(algsurf_zpoly_at(half + i, k), p->re.width, algsurf_zpoly_at(part[i], 2 * k),
                           p->re.width);
    }
    return algsurf_i_make_integers(m, half, p->im.c ? half + 1 : NULL, q);
}

/* A square root of a, which is not 0. */
static algsurf_scaled root_of(algsurf_scaled a) {
    const int odd = (int)(a.exponent & 1);
    const double re = odd ? 2 * a.re : a.re, im = odd ? 2 * a.im : a.im;
    const double most = sqrt(0.5 * (sqrt(re * re + im * im) + fabs(re))), least = 0.5 * im / most;
    const int64_t exponent = (a.exponent - odd) / 2;
    return re >= 0 ? scaled_of(most, least, exponent)
                   : scaled_of(fabs(least), im < 0 ? -most : most, exponent);
}

int algsurf_i_is_in_squares(const algsurf_i_integers *p) {
    int n = p->re.degree, k = 1;
    while (k < n && p->bits[k] < 0) k += 2;
    return n % 2 == 0 && k > n;
}

int algsurf_i_discs_separate(algsurf_i_discs *d, algsurf_memory *m, algsurf_i_integers *p, int most,
                             int *open, int *corrections) {
    const int n = p->re.degree;
    if (!algsurf_i_is_in_squares(p))
        return algsurf_i_discs_begin(d, m, p, NULL, corrections) && algsurf_i_discs_run(d, most, open);
    algsurf_i_integers q;
    algsurf_scaled *z = algsurf_i_take(m, (size_t)n * sizeof *z);
    algsurf_memory_mark mark = algsurf_memory_here(m);
    if (!z || !halve(m, p, &q) || !algsurf_i_discs_separate(d, m, &q, most, open, corrections)) return 0;
    for (int i = 0; i < d->n; i++) {
        const algsurf_i_disc *root = d->root + i;
        const algsurf_scaled at = sum(root->z.head, negative(root->step));
        z[2 * i] = root_of(is_zero(at) ? root->z.head : at);
        z[2 * i + 1] = negative(z[2 * i]);
    }
    algsurf_memory_release(m, mark);
    return algsurf_i_discs_begin(d, m, p, z, NULL) && algsurf_i_discs_run(d, most, open);
}
