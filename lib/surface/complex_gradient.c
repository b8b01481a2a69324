/* complex_gradient.c - the gradient at a complex point: Horner's scheme, differentiated, on complex numbers.
 */
#include "../base/arithmetic.h"
#include "impl.h"

typedef algsurf_i_complex complex_t;

static complex_t times_plus(complex_t a, complex_t x, complex_t b) {
    return (complex_t){a.re * x.re - a.im * x.im + b.re, a.re * x.im + a.im * x.re + b.im};
}

void algsurf_i_surface_gradient_complex(const algsurf_surface *s, const complex_t x[3],
                                        complex_t gradient[3]) {
    const complex_t zero = {0, 0};
    complex_t v = zero, vx = zero, vy = zero, vz = zero;
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_row *row = s->rows + s->levels[k].first;
        complex_t level = zero, level_x = zero, level_y = zero;
        for (int j = s->levels[k].count - 1; j >= 0; j--) {
            const double *c = s->coef + row[j].first;
            complex_t r = zero, r_x = zero;
            for (int i = row[j].length - 1; i >= 0; i--) {
                r_x = times_plus(r_x, x[0], r);
                r = times_plus(r, x[0], (complex_t){c[i], 0});
            }
            level_x = times_plus(level_x, x[1], r_x);
            level_y = times_plus(level_y, x[1], level);
            level = times_plus(level, x[1], r);
        }
        vx = times_plus(vx, x[2], level_x);
        vy = times_plus(vy, x[2], level_y);
        vz = times_plus(vz, x[2], v);
        v = times_plus(v, x[2], level);
    }
    gradient[0] = vx;
    gradient[1] = vy;
    gradient[2] = vz;
}
