/* expansion.c - exact sums and products of doubles. */
#include "expansion.h"

#include <math.h>

#include "eft.h"

void algsurf_i_expansion_set(algsurf_i_expansion *e, double a) {
    e->count = a != 0;
    e->exact = 1;
    e->x[0] = a;
}

void algsurf_i_expansion_add_double(algsurf_i_expansion *e, double a) {
    int kept = 0;
    for (int i = 0; i < e->count; i++) {
        algsurf_dd s = algsurf_two_sum(a, e->x[i]);
        if (s.lo != 0) e->x[kept++] = s.lo;
        a = s.hi;
    }
    if (!isfinite(a) || kept == ALGSURF_EXPANSION_SIZE) e->exact = 0;
    else if (a != 0) e->x[kept++] = a;
    e->count = kept;
}

void algsurf_i_expansion_add(algsurf_i_expansion *e, const algsurf_i_expansion *f) {
    for (int i = 0; i < f->count; i++) algsurf_i_expansion_add_double(e, f->x[i]);
    e->exact = e->exact && f->exact;
}

void algsurf_i_expansion_add_product(algsurf_i_expansion *e, double a, double b) {
    if (a == 0 || b == 0) return;
    algsurf_dd p = algsurf_two_prod(a, b);
    if (!(fabs(p.hi) > 0x1p-960) || !isfinite(p.hi) || !isfinite(p.lo)) e->exact = 0;
    algsurf_i_expansion_add_double(e, p.lo);
    algsurf_i_expansion_add_double(e, p.hi);
}

void algsurf_i_expansion_multiply(algsurf_i_expansion *e, const algsurf_i_expansion *f) {
    algsurf_i_expansion product;
    algsurf_i_expansion_set(&product, 0);
    for (int i = 0; i < e->count; i++)
        for (int j = 0; j < f->count; j++) algsurf_i_expansion_add_product(&product, e->x[i], f->x[j]);
    e->exact = e->exact && f->exact && product.exact;
    e->count = product.count;
    for (int i = 0; i < product.count; i++) e->x[i] = product.x[i];
}

int algsurf_i_expansion_sign(const algsurf_i_expansion *e) {
    if (!e->exact) return ALGSURF_SIGN_UNKNOWN;
    if (e->count == 0) return 0;
    return e->x[e->count - 1] > 0 ? 1 : -1;
}
