/* expand_exact.c - exact signs along a ray: of P at a point, and of its leading coefficient.
 *
 * Nested Horner scheme over expansions.  For the ends of a ray, for rays of no length and for directions
 * in which the degree drops, where an error bound of any size cannot tell zero from almost zero. */
#include <math.h>

#include "expand_impl.h"

static void scaled(algsurf_i_expansion *x, double a, int unit) {
    algsurf_i_expansion_set(x, ldexp(a, -unit));
    if (ldexp(x->x[0], unit) != a) x->exact = 0;
}

/* Exact sign of the terms of total degree at least `least` at a point. */
static int sign_at(const algsurf_surface *s, const algsurf_i_expansion x[3], int least) {
    algsurf_i_expansion total, level, row;
    if (s->inexact || s->error > 0) return ALGSURF_SIGN_UNKNOWN;
    algsurf_i_expansion_set(&total, 0);
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_level *l = s->levels + k;
        algsurf_i_expansion_set(&level, 0);
        for (int j = l->count - 1; j >= 0; j--) {
            const algsurf_row *r = s->rows + l->first + j;
            algsurf_i_expansion_set(&row, 0);
            for (int i = r->length - 1; i >= 0; i--) {
                algsurf_i_expansion_multiply(&row, x);
                if (i + j + k >= least) algsurf_i_expansion_add_double(&row, s->coef[r->first + (size_t)i]);
            }
            algsurf_i_expansion_multiply(&level, x + 1);
            algsurf_i_expansion_add(&level, &row);
        }
        algsurf_i_expansion_multiply(&total, x + 2);
        algsurf_i_expansion_add(&total, &level);
    }
    return algsurf_i_expansion_sign(&total);
}

int algsurf_i_exact_sign(const algsurf_surface *s, const algsurf_ray *ray, double t) {
    algsurf_i_expansion x[3], d;
    for (int i = 0; i < 3; i++) {
        scaled(x + i, ray->origin[i], s->unit);
        scaled(&d, ray->direction[i], s->unit);
        algsurf_i_expansion_add_product(x + i, d.x[0], t);
        x[i].exact = x[i].exact && d.exact;
    }
    return sign_at(s, x, 0);
}

int algsurf_i_top_vanishes(const algsurf_surface *s, const algsurf_ray *ray) {
    algsurf_i_expansion d[3];
    for (int i = 0; i < 3; i++) algsurf_i_expansion_set(d + i, ray->direction[i]);
    return sign_at(s, d, s->degree) == 0;
}
