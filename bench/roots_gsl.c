/* roots_gsl.c - the GNU Scientific Library: closed forms for degrees 2 and 3, else the eigenvalues of the
 * companion matrix by balanced QR. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_poly.h>
#include <math.h>

#include "algsurf/status.h"
#include "roots_others.h"

static int within(const double *x, int count, double *real) { /* they come in increasing order */
    int n = 0;
    for (int i = 0; i < count; i++)
        if (x[i] >= -1 && x[i] <= 1 && !(n > 0 && x[i] == real[n - 1])) real[n++] = x[i];
    return n;
}

int by_gsl_interval(const double *c, int degree, double *real) {
    double x[3];
    other_root roots[ALGSURF_MAX_DEGREE];
    if (degree == 2) return within(x, gsl_poly_solve_quadratic(c[2], c[1], c[0], &x[0], &x[1]), real);
    if (degree == 3)
        return within(x, gsl_poly_solve_cubic(c[2] / c[3], c[1] / c[3], c[0] / c[3], &x[0], &x[1], &x[2]),
                      real);
    return others_in_interval(roots, by_gsl_all(c, NULL, degree, roots), real);
}

double by_gsl_first(const double *c, int degree) {
    double real[ALGSURF_MAX_DEGREE];
    return by_gsl_interval(c, degree, real) > 0 ? real[0] : NAN;
}

int by_gsl_all(const double *re, const double *im, int degree, other_root *roots) {
    static gsl_poly_complex_workspace *workspace;
    static int room;
    double z[2 * ALGSURF_MAX_DEGREE];
    (void)im; /* for real coefficients only */
    gsl_set_error_handler_off();
    if (room != degree) {
        if (workspace) gsl_poly_complex_workspace_free(workspace);
        workspace = gsl_poly_complex_workspace_alloc((size_t)degree + 1);
        room = degree;
    }
    if (!workspace || gsl_poly_complex_solve(re, (size_t)degree + 1, workspace, z) != GSL_SUCCESS) return 0;
    for (int i = 0; i < degree; i++) roots[i] = (other_root){z[2 * i], z[2 * i + 1], NAN};
    return degree;
}
