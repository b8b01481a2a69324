#ifndef ALGSURF_ALLROOTS_H
#define ALGSURF_ALLROOTS_H
#include <stddef.h>
#include "algsurf/interval.h"
#include "algsurf/poly.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_complex_root {
    algsurf_cinterval box;
    algsurf_complex root;
    int multiplicity;
    int real;
} algsurf_complex_root;
ALGSURF_API algsurf_status algsurf_complex_roots(const algsurf_complex *c, const double *r, int degree,
                                                 algsurf_complex_root *roots, int *count);
ALGSURF_API algsurf_status algsurf_complex_roots_of_real(const double *c, const double *r, int degree,
                                                         algsurf_complex_root *roots, int *count);
ALGSURF_API algsurf_status algsurf_complex_roots_integers(const algsurf_integer *re,
                                                          const algsurf_integer *im, int degree,
                                                          algsurf_complex_root *roots, int *count);
#define ALGSURF_MAX_ROOT_BITS 1000000
typedef struct algsurf_precise_roots algsurf_precise_roots;
typedef struct algsurf_precise_root {
    algsurf_integer re, im;
    int exponent, radius;
    int multiplicity;
    int real;
} algsurf_precise_root;
ALGSURF_API algsurf_status algsurf_precise_roots_create(const algsurf_integer *re, const algsurf_integer *im,
                                                        int degree, int bits, size_t max_memory,
                                                        algsurf_precise_roots **roots);
ALGSURF_API int algsurf_precise_roots_count(const algsurf_precise_roots *roots);
ALGSURF_API algsurf_status algsurf_precise_roots_get(const algsurf_precise_roots *roots, int i,
                                                     algsurf_precise_root *root);
ALGSURF_API void algsurf_precise_roots_free(algsurf_precise_roots *roots);
typedef struct algsurf_complex_solver algsurf_complex_solver;
typedef struct algsurf_complex_solver_stats {
    size_t size;
    int iterations;
    int retries;
} algsurf_complex_solver_stats;
ALGSURF_API algsurf_status algsurf_complex_solver_create(int max_degree, algsurf_complex_solver **solver);
ALGSURF_API void algsurf_complex_solver_free(algsurf_complex_solver *solver);
ALGSURF_API algsurf_status algsurf_complex_solver_run(algsurf_complex_solver *solver,
                                                      const algsurf_complex *c, const double *r, int degree,
                                                      const algsurf_complex *start,
                                                      algsurf_complex_root *roots, int *count,
                                                      algsurf_complex_solver_stats *stats);
#ifdef __cplusplus
}
#endif
#endif
