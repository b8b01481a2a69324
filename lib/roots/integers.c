/* integers.c - integer coefficients in doubles: real roots where their roundings, as radii, leave none open.
 *
 * A bracket then holds one root of each polynomial within the radii, hence of that of the integers, and the
 * signs at its ends are the same for all.  Where the root is, the rounded polynomial tells nearly; from there
 * the integers' signs at doubles, one beside the other, close it in. */
#include "../base/arithmetic.h"
#include <math.h>

#include "line.h"
#include "exact_walk.h"

enum { STACK_WORDS = 1024, MOST_SPREAD = 900, FEW = 4 };

/* z as c 2^common, |c| at most 1, with radii: what has more than 53 bits is off by 2^-52 of itself at most.
 * Returns 0 where exponents differ too much for doubles. */
static int round_all(const algsurf_zpoly *z, double *c, double *r) {
    int e[ALGSURF_MAX_DEGREE + 1], most = -1;
    for (int k = 0; k <= z->degree; k++) {
        c[k] = algsurf_z_to_double(algsurf_zpoly_at(z, k), z->width, e + k);
        most = e[k] > most ? e[k] : most;
    }
    for (int k = 0; k <= z->degree; k++) {
        if (c[k] != 0 && most - e[k] > MOST_SPREAD) return 0;
        c[k] = ldexp(c[k], e[k] - most);
        r[k] = e[k] > 53 ? 0x1p-52 * fabs(c[k]) : 0;
    }
    return 1;
}

/* The root in a bracket, from a guess; returns 0 when it is not near. */
static int close_in(algsurf_memory *m, const algsurf_zpoly *z, const algsurf_bracket *b, double guess,
                    algsurf_real_root *root) {
    double x = guess, before = guess, size[2] = {0, 0};
    int sign, last = 0, e[2] = {0, 0};
    for (int i = 0; i < FEW && b->lo < x && x < b->hi; i++) {
        if (!algsurf_exact_at_double(m, z, 0, x, &sign, &size[0], &e[0])) return 0;
        if (sign == 0) {
            *root = (algsurf_real_root){x, x, x, 1, b->sign};
            return 1;
        }
        if (sign == -last) {
            int nearer = ldexp(fabs(size[0]), e[0] - e[1] > 2 ? 2 : e[0] - e[1]) < fabs(size[1]);
            *root = (algsurf_real_root){nearer ? x : before, fmin(x, before), fmax(x, before), 1, b->sign};
            return 1;
        }
        last = sign, before = x, size[1] = size[0], e[1] = e[0];
        x = nextafter(x, sign == b->sign ? HUGE_VAL : -HUGE_VAL);
    }
    return 0;
}

int algsurf_i_integers_round(const algsurf_i_line *line, double *c, double *r, int *degree) {
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly z;
    algsurf_memory_mark begin = algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    int done = line->p.degree <= ALGSURF_MAX_DEGREE && algsurf_i_take_integers(&memory, line, &z) &&
               round_all(&z, c, r);
    if (done) *degree = z.degree;
    algsurf_memory_release(&memory, begin);
    return done;
}

int algsurf_i_integers_close_in(const algsurf_i_line *line, const algsurf_bracket *b, int count,
                                algsurf_real_root *roots) {
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly z;
    int i = 0;
    algsurf_memory_mark begin = algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    if (algsurf_i_take_integers(&memory, line, &z))
        while (i < count && roots[i].multiplicity && close_in(&memory, &z, b + i, roots[i].root, roots + i))
            i++;
    algsurf_memory_release(&memory, begin);
    return i;
}
