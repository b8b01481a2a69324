/* peers_gsl.c - the GNU Scientific Library: closed forms for degrees 2 and 3, else the eigenvalues of the
 * companion matrix by balanced QR; Brent's method on a bracket.
 */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_poly.h>
#include <gsl/gsl_roots.h>
#include <math.h>

#include "algsurf/status.h"
#include "peers_solver.h"

static double least_of(const double *x, int count) {
    for (int i = 0; i < count; i++) /* they come in increasing order */
        if (x[i] >= -1 && x[i] <= 1) return x[i];
    return NAN;
}

double peer_gsl_first(const double *c, int degree) {
    double x[3];
    peer_root roots[ALGSURF_MAX_DEGREE];
    if (degree == 2) return least_of(x, gsl_poly_solve_quadratic(c[2], c[1], c[0], &x[0], &x[1]));
    if (degree == 3)
        return least_of(x, gsl_poly_solve_cubic(c[2] / c[3], c[1] / c[3], c[0] / c[3], &x[0], &x[1], &x[2]));
    return peer_least(roots, peer_gsl_all(c, NULL, degree, roots));
}

int peer_gsl_all(const double *re, const double *im, int degree, peer_root *roots) {
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
    for (int i = 0; i < degree; i++) roots[i] = (peer_root){z[2 * i], z[2 * i + 1], NAN};
    return degree;
}

typedef struct polynomial {
    const double *c;
    int degree;
} polynomial;

static double value(double x, void *data) {
    const polynomial *p = data;
    return gsl_poly_eval(p->c, p->degree + 1, x);
}

double peer_gsl_brent(const double *c, int degree, double lo, double hi, double tolerance) {
    static gsl_root_fsolver *solver;
    polynomial p = {c, degree};
    gsl_function f = {value, &p};
    gsl_set_error_handler_off();
    if (!solver) solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    if (!solver || gsl_root_fsolver_set(solver, &f, lo, hi) != GSL_SUCCESS) return NAN;
    for (int i = 0; i < 1000 && gsl_root_fsolver_iterate(solver) == GSL_SUCCESS; i++)
        if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver),
                                   2 * tolerance, 0) == GSL_SUCCESS)
            break;
    return gsl_root_fsolver_root(solver);
}
