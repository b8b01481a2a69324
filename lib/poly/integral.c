/* integral.c - polynomials with integer coefficients: where they come from, sizes, derivative.
 *
 * Widths come first.  Two's complement is arithmetic modulo 2^(64 w): intermediate results may overflow, as
 * long as the final ones fit, so each function of the files integral*.c bounds its results, and chooses w
 * from that. */
#include "../base/arithmetic.h"
#include "value.h"
#include "integral_impl.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static int new_unset(algsurf_memory *m, int degree, int width, algsurf_zpoly *p) {
    size_t words = (size_t)(degree + 1) * (size_t)width;
    *p = (algsurf_zpoly){degree, width, algsurf_memory_take(m, words)};
    return p->c != NULL;
}

int algsurf_zpoly_new(algsurf_memory *m, int degree, int width, algsurf_zpoly *p) {
    if (!new_unset(m, degree, width, p)) return 0;
    memset(p->c, 0, (size_t)(degree + 1) * (size_t)width * sizeof *p->c);
    return 1;
}

int algsurf_zpoly_copy(algsurf_memory *m, const algsurf_zpoly *a, int width, algsurf_zpoly *p) {
    algsurf_zpoly from = *a; /* p may be a */
    if (!new_unset(m, from.degree, width, p)) return 0;
    for (int k = 0; k <= from.degree; k++)
        algsurf_z_copy(algsurf_zpoly_at(p, k), width, algsurf_zpoly_at(&from, k), from.width);
    return 1;
}

algsurf_status algsurf_zpoly_check(const algsurf_integer *c, int degree) {
    int zero = 1;
    algsurf_status status = algsurf_i_check_degree(degree);
    if (status != ALGSURF_OK) return status;
    for (int k = 0; k <= degree; k++) {
        if (c[k].length < -ALGSURF_MAX_LIMBS || c[k].length > ALGSURF_MAX_LIMBS) return ALGSURF_E_ARGUMENT;
        if (c[k].length && !c[k].limbs) return ALGSURF_E_ARGUMENT;
        zero = zero && algsurf_z_length(c[k].limbs, abs(c[k].length)) == 0;
    }
    return zero ? ALGSURF_E_ZERO : ALGSURF_OK;
}

int algsurf_zpoly_from_integers(algsurf_memory *m, const algsurf_integer *c, int degree, algsurf_zpoly *p) {
    int longest = 0;
    for (int k = 0; k <= degree; k++) longest = larger(longest, abs(c[k].length));
    if (!algsurf_zpoly_new(m, degree, longest + 1, p)) return 0;
    for (int k = 0; k <= degree; k++) {
        algsurf_limb *a = algsurf_zpoly_at(p, k);
        if (c[k].length) memcpy(a, c[k].limbs, (size_t)abs(c[k].length) * sizeof *a);
        if (c[k].length < 0) algsurf_z_negate(a, p->width);
    }
    return 1;
}

int algsurf_zpoly_least_bit(const double *c, int step, int degree, int unit) {
    int least = ALGSURF_Z_NO_BIT;
    for (int k = 0, e; k <= degree; k++)
        if (algsurf_z_odd_part(c[k * step], &e)) least = smaller(least, e + k * unit);
    return least;
}

int algsurf_zpoly_from_doubles(algsurf_memory *m, const double *c, int step, int degree, int unit, int least,
                               algsurf_zpoly *p) {
    int most = least;
    for (int k = 0; k <= degree; k++)
        if (c[k * step] != 0) most = larger(most, ilogb(c[k * step]) + 1 + k * unit);
    if (!algsurf_zpoly_new(m, degree, algsurf_z_width(most - least), p)) return 0;
    for (int k = 0; k <= degree; k++)
        algsurf_z_add_double(algsurf_zpoly_at(p, k), p->width, c[k * step], k * unit - least);
    *p = algsurf_zpoly_trimmed(p);
    return 1;
}

/* One limb of all coefficients at a time, from above: mostly the last one decides. */
int algsurf_zpoly_bits(const algsurf_zpoly *p) {
    for (int i = p->width - 1; i >= 0; i--) {
        algsurf_limb any = 0;
        for (int k = 0; k <= p->degree; k++) {
            const algsurf_limb *a = algsurf_zpoly_at(p, k);
            any |= a[i] ^ (0 - (a[p->width - 1] >> 63));
        }
        if (any) return LIMB_BITS * i + algsurf_limb_bits(any);
    }
    return 0;
}

int algsurf_zpoly_trailing(const algsurf_zpoly *p) {
    for (int i = 0; i < p->width; i++) {
        algsurf_limb any = 0;
        for (int k = 0; k <= p->degree; k++) any |= algsurf_zpoly_at(p, k)[i];
        if (any) return LIMB_BITS * i + algsurf_limb_trailing(any);
    }
    return ALGSURF_Z_NO_BIT;
}

/* r = floor(a / 2^bits) in w limbs, w + bits / 64 <= wa; r does not begin after a. */
static void move_down(algsurf_limb *r, int w, const algsurf_limb *a, int wa, int bits) {
    int limbs = bits / LIMB_BITS, rest = bits % LIMB_BITS;
    algsurf_limb beyond = limbs + w < wa ? a[limbs + w] : 0 - (a[wa - 1] >> 63);
    a += limbs;
    if (rest == 0) {
        memmove(r, a, (size_t)w * sizeof *a);
        return;
    }
    for (int i = 0; i < w - 1; i++) r[i] = a[i] >> rest | a[i + 1] << (LIMB_BITS - rest);
    r[w - 1] = a[w - 1] >> rest | beyond << (LIMB_BITS - rest);
}

void algsurf_zpoly_cut(algsurf_zpoly *p, int zeros) {
    if (zeros == ALGSURF_Z_NO_BIT) zeros = 0;
    int bits = algsurf_zpoly_bits(p) - zeros, from = p->width, w = smaller(algsurf_z_width(bits), from);
    if (w == from && zeros == 0) return;
    for (int k = 0; k <= p->degree; k++)
        move_down(p->c + (size_t)k * (size_t)w, w, algsurf_zpoly_at(p, k), from, zeros);
    p->width = w;
}

void algsurf_zpoly_compact(algsurf_zpoly *p) {
    *p = algsurf_zpoly_trimmed(p);
    algsurf_zpoly_cut(p, algsurf_zpoly_trailing(p));
}

int algsurf_zpoly_derivative(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *d) {
    algsurf_zpoly from = *p;
    int n = p->degree, w = algsurf_z_width(algsurf_zpoly_bits(p) + bits_of_int(larger(n, 0)));
    if (!new_unset(m, larger(n - 1, -1), w, d)) return 0;
    for (int k = 1; k <= n; k++) {
        algsurf_z_copy(algsurf_zpoly_at(d, k - 1), w, algsurf_zpoly_at(&from, k), from.width);
        algsurf_z_multiply(algsurf_zpoly_at(d, k - 1), w, (algsurf_limb)k);
    }
    return 1;
}
