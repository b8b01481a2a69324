/* expand_d.c - the expansion along a ray in double. */
#include <math.h>

#include "expand_impl.h"

#define NUMBER double
#define UNIT ALGSURF_U

static inline double num_add(double a, double b) { return a + b; }
static inline double num_mul(double a, double b) { return a * b; }
static inline double num_mul_d(double a, double b) { return a * b; }
static inline double num_from(double a) { return a; }

#include "expand_template.h"

void algsurf_i_expand_d(const algsurf_surface *s, const double X[3], const double D[3], double *q,
                        double *r) {
    line_coordinate c[3];
    for (int i = 0; i < 3; i++) c[i] = (line_coordinate){X[i], D[i], fabs(X[i]), fabs(D[i])};
    expand(s, c, q, r);
}
