/* expand_dd.c - the expansion along a ray in double-double. */
#include <math.h>

#include "expand_impl.h"

#define NUMBER algsurf_dd
#define UNIT ALGSURF_DD_U

static inline algsurf_dd num_add(algsurf_dd a, algsurf_dd b) { return algsurf_dd_add(a, b); }
static inline algsurf_dd num_mul(algsurf_dd a, algsurf_dd b) { return algsurf_dd_mul(a, b); }
static inline algsurf_dd num_mul_d(algsurf_dd a, double b) { return algsurf_dd_mul_d(a, b); }
static inline algsurf_dd num_from(double a) { return algsurf_dd_from(a); }

#include "expand_template.h"

void algsurf_i_expand_dd(const algsurf_surface *s, const algsurf_dd X[3], const double D[3], algsurf_dd *q,
                         double *r) {
    line_coordinate c[3];
    for (int i = 0; i < 3; i++) c[i] = (line_coordinate){X[i], D[i], fabs(X[i].hi), fabs(D[i])};
    expand(s, c, q, r);
}
