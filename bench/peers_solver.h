/* peers_solver.h - other people's root finders behind three signatures.  One file for each package; only
 * those that are installed are compiled (see bench/peers).
 *
 * Coefficients come lowest degree first, degree <= ALGSURF_MAX_DEGREE, the leading one is not 0.
 */
#ifndef PEERS_SOLVER_H
#define PEERS_SOLVER_H
#ifdef __cplusplus
extern "C" {
#endif

typedef struct peer_root {
    double re, im;
    double radius; /* of a disc that the solver says holds the root; NaN: it says nothing */
} peer_root;

/* The least real root in [-1,1]; NaN: none. */
typedef double peer_first(const double *c, int degree);

/* The root in [lo,hi], the signs at its ends being opposite, to half of an interval of 2 tolerance. */
typedef double peer_refine(const double *c, int degree, double lo, double hi, double tolerance);

/* All roots, by multiplicity; returns how many came.  im null: the coefficients are real. */
typedef int peer_all(const double *re, const double *im, int degree, peer_root *roots);

peer_first peer_gsl_first, peer_arb_first, peer_pari_first;
peer_refine peer_gsl_brent, peer_toms748;
peer_all peer_gsl_all, peer_arb_all, peer_mpsolve_isolate, peer_mpsolve_approximate, peer_pari_all;

/* The least root in [-1,1] among all roots: those count as real whose imaginary part is exactly 0. */
double peer_least(const peer_root *roots, int count);

#ifdef __cplusplus
}
#endif
#endif
