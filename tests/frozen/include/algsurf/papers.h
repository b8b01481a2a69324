#ifndef ALGSURF_PAPERS_H
#define ALGSURF_PAPERS_H
#include <stddef.h>
#include "algsurf/interval.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_paper_options {
    size_t size;
    double relative_step;
    int max_steps;
    int max_inflations;
} algsurf_paper_options;
ALGSURF_API algsurf_status algsurf_paper_approximation(const algsurf_complex *p, int degree,
                                                       algsurf_complex start,
                                                       const algsurf_paper_options *options,
                                                       algsurf_complex *z, algsurf_complex *q, int *steps);
ALGSURF_API algsurf_status algsurf_paper_inclusion(const algsurf_complex *p, const double *r, int degree,
                                                   algsurf_complex z, const algsurf_complex *q,
                                                   const algsurf_paper_options *options, algsurf_cinterval *Z,
                                                   algsurf_cinterval *Q, int *unique, int *inflations);
typedef struct algsurf_paper_zero {
    algsurf_cinterval box;
    algsurf_complex root;
    int verified;
    int unique;
    int converged;
    int steps, inflations;
} algsurf_paper_zero;
ALGSURF_API algsurf_status algsurf_paper_zeros(const algsurf_complex *p, const double *r, int degree,
                                               const algsurf_complex *start,
                                               const algsurf_paper_options *options,
                                               algsurf_paper_zero *zeros, int *complete);
#ifdef __cplusplus
}
#endif
#endif
