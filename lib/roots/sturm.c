/* sturm.c - Sturm's chain where it is short: p = a t^n + r(t), r of low degree d, like Mignotte's
 * polynomials, whose roots lie so close that a walk needs n times as many digits as p has.
 *
 * The chain begins p, p', and t p' - n p, a positive multiple of -(p mod p'), whose coefficients are (k - n)
 * c_k: it has degree d.  Every next one is minus the remainder of the two before it, times a power of the
 * divisor's leading coefficient.  At most d + 3 of them, and the number of variations of their signs falls by
 * one at each distinct root (Sturm 1835), also where roots are multiple. */
#include "../base/arithmetic.h"
#include "sturm.h"

#include <math.h>

#include "../base/eft.h"
#include "decide.h"
#include "exact.h"

enum { MOST_LOW = 3, MOST_CHAIN = MOST_LOW + 3, MOST_BITS = 256 }; /* of p: longer ones grow n times */

/* What r, of coefficients j < k, is to be multiplied by. */
typedef struct divisor {
    const algsurf_zpoly *g;
    algsurf_z_factor lead;
    algsurf_limb *room, *top; /* for one coefficient of r each */
} divisor;

/* r = lead r - r_k u^(k-d) g, without its coefficient k: from `from` limbs of each coefficient in use to w.
 * `live`: which are not 0. */
static void eliminate(const divisor *by, const algsurf_zpoly *r, int k, int from, int w, char *live) {
    int d = by->g->degree;
    algsurf_z_factor top = algsurf_z_factor_of(algsurf_zpoly_at(r, k), from, by->top);
    for (int j = 0; j < k; j++) {
        if (!live[j]) continue;
        algsurf_limb *a = algsurf_zpoly_at(r, j);
        algsurf_z_zero(by->room, w);
        algsurf_z_add_times(by->room, w, a, from, &by->lead, 0);
        algsurf_z_copy(a, w, by->room, w);
    }
    for (int j = 0; j < d; j++) {
        algsurf_z_add_times(algsurf_zpoly_at(r, k - d + j), w, algsurf_zpoly_at(by->g, j), by->g->width, &top,
                            1);
        live[k - d + j] = 1;
    }
}

/* r, a positive multiple of -(f mod g).  A step lengthens coefficients by g's bits and one. */
static int negative_remainder(algsurf_memory *m, const algsurf_zpoly *f, const algsurf_zpoly *g,
                              algsurf_zpoly *r) {
    int n = f->degree, d = g->degree, gw = g->width, step = algsurf_zpoly_bits(g) + 1,
        bits = algsurf_zpoly_bits(f) + 1;
    int used = f->width, w = algsurf_z_width(bits + (n - d + 1) * step);
    char live[ALGSURF_MAX_POLY_DEGREE + 1];
    if (w < used) w = used;
    algsurf_limb *lead = algsurf_memory_take(m, (size_t)gw), *room = algsurf_memory_take(m, 2 * (size_t)w);
    if (!lead || !room || !algsurf_zpoly_copy(m, f, w, r)) return 0;
    const divisor by = {g, algsurf_z_factor_of(algsurf_zpoly_at(g, d), gw, lead), room, room + w};
    for (int k = 0; k <= n; k++) live[k] = algsurf_z_sign(algsurf_zpoly_at(f, k), f->width) != 0;
    for (int k = n; k >= d; k--) {
        bits += step;
        int wide = algsurf_z_width(bits) > used ? algsurf_z_width(bits) : used;
        eliminate(&by, r, k, used, wide, live);
        used = wide;
    }
    r->degree = d - 1;
    for (int k = 0; k < d && !(by.lead.negative && (n - d) % 2 == 0); k++)
        algsurf_z_negate(algsurf_zpoly_at(r, k), w);
    algsurf_zpoly_compact(r);
    return 1;
}

/* (k - n) c_k, in place of c_k. */
static int third_of_chain(algsurf_memory *m, const algsurf_zpoly *p, int low, algsurf_zpoly *g) {
    algsurf_zpoly r = *p;
    r.degree = low;
    if (!algsurf_zpoly_copy(m, &r, algsurf_z_width(algsurf_zpoly_bits(&r) + 12), g)) return 0;
    for (int k = 0; k <= low; k++) {
        algsurf_z_multiply(algsurf_zpoly_at(g, k), g->width, (algsurf_limb)(p->degree - k));
        algsurf_z_negate(algsurf_zpoly_at(g, k), g->width);
    }
    return 1;
}

/* At 0 or an infinity. */
static int sign_at(const algsurf_zpoly *f, double x) {
    int lead = algsurf_z_sign(algsurf_zpoly_at(f, x == 0 ? 0 : f->degree), f->width);
    return x < 0 && f->degree % 2 ? -lead : lead;
}

static int variations(const algsurf_zpoly *chain, int length, double x) {
    int count = 0, last = 0;
    for (int i = 0; i < length; i++) {
        int sign = sign_at(chain + i, x);
        count += sign * last < 0;
        last = sign ? sign : last;
    }
    return count;
}

static int make_chain(algsurf_memory *m, const double *c, int degree, int low, algsurf_zpoly *chain,
                      int *length) {
    if (!algsurf_exact_from_doubles(m, c, degree, 0, chain) ||
        !algsurf_zpoly_derivative(m, chain, chain + 1) || !third_of_chain(m, chain, low, chain + 2))
        return 0;
    for (*length = 3; chain[*length - 1].degree > 0; ++*length)
        if (!negative_remainder(m, chain + *length - 2, chain + *length - 1, chain + *length)) return 0;
    if (chain[*length - 1].degree < 0) --*length;
    return 1;
}

int algsurf_i_count_by_sturm(const double *c, int degree, double lo, double hi, int *count) {
    algsurf_limb block[1024];
    algsurf_memory memory;
    algsurf_zpoly chain[MOST_CHAIN];
    int low = degree - 1, length;
    while (low > 0 && c[low] == 0) low--;
    if (low > MOST_LOW || degree < low + 3) return 0;
    algsurf_memory_begin(&memory, block, sizeof block / sizeof *block, ALGSURF_I_DECIDE_MEMORY);
    algsurf_memory_mark begin = algsurf_memory_here(&memory);
    int done = make_chain(&memory, c, degree, low, chain, &length);
    if (done) *count = variations(chain, length, lo) - variations(chain, length, hi);
    algsurf_memory_release(&memory, begin);
    return done;
}

/* A term rounds six times at most, the sum four times: 10 u of the sum of their sizes, to first order, taken
 * as 32 u. Nothing underflows where coefficients are 0 or within 2^+-200. */
int algsurf_i_count_by_discriminant(const double *c, int degree) {
    double sum = 0, size = 0, term[5] = {0};
    if (degree == 2) {
        term[0] = c[1] * c[1];
        term[1] = -4 * (c[0] * c[2]);
    } else if (degree == 3) {
        double square = c[1] * c[1], outer = c[0] * c[3], inner = c[1] * c[2];
        term[0] = 18 * (outer * inner);
        term[1] = -4 * (c[2] * c[2]) * (c[2] * c[0]);
        term[2] = inner * inner;
        term[3] = -4 * square * (c[1] * c[3]);
        term[4] = -27 * (outer * outer);
    }
    for (int k = 0; k <= degree && k <= 3; k++)
        if (c[k] != 0 && !(fabs(c[k]) > 0x1p-200 && fabs(c[k]) < 0x1p200)) return -1;
    for (int i = 0; i < 5; i++) {
        sum += term[i];
        size += fabs(term[i]);
    }
    if (!(fabs(sum) > 32 * ALGSURF_U * size)) return -1;
    return sum > 0 ? degree : degree - 2;
}
