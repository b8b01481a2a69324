/* expand_exact.c - the exact sign of P at a point of a ray.
 *
 * Nested Horner scheme over expansions.  For the ends of a ray and for rays of no length, where an
 * error bound of any size cannot tell zero from almost zero. */
#include <math.h>

#include "expand_impl.h"

static void coordinate(algsurf_i_expansion *x, double o, double d, double t, int unit) {
    algsurf_i_expansion_set(x, ldexp(o, -unit));
    if (ldexp(x->x[0], unit) != o) x->exact = 0;
    double scaled = ldexp(d, -unit);
    if (ldexp(scaled, unit) != d) x->exact = 0;
    algsurf_i_expansion_add_product(x, scaled, t);
}

int algsurf_i_exact_sign(const algsurf_surface *s, const algsurf_ray *ray, double t) {
    algsurf_i_expansion x[3], total, level, row;
    if (s->inexact) return ALGSURF_SIGN_UNKNOWN;
    for (int i = 0; i < 3; i++) coordinate(x + i, ray->origin[i], ray->direction[i], t, s->unit);
    algsurf_i_expansion_set(&total, 0);
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_level *l = s->levels + k;
        algsurf_i_expansion_set(&level, 0);
        for (int j = l->count - 1; j >= 0; j--) {
            const algsurf_row *r = s->rows + l->first + j;
            algsurf_i_expansion_set(&row, 0);
            for (int i = r->length - 1; i >= 0; i--) {
                algsurf_i_expansion_multiply(&row, x);
                algsurf_i_expansion_add_double(&row, s->coef[r->first + (size_t)i]);
            }
            algsurf_i_expansion_multiply(&level, x + 1);
            algsurf_i_expansion_add(&level, &row);
        }
        algsurf_i_expansion_multiply(&total, x + 2);
        algsurf_i_expansion_add(&total, &level);
    }
    return algsurf_i_expansion_sign(&total);
}
