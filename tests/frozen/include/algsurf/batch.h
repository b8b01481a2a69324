#ifndef ALGSURF_BATCH_H
#define ALGSURF_BATCH_H
#include <stddef.h>
#include "algsurf/allroots.h"
#include "algsurf/isolate.h"
#include "algsurf/poly.h"
#include "algsurf/status.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_batch_options {
    size_t size;
    const char *kernel;
    double relative_tolerance;
} algsurf_batch_options;
typedef struct algsurf_real_batch {
    size_t size;
    size_t count;
    int degree;
    algsurf_table coefficients;
    algsurf_table radii;
    const double *lo, *hi;
    ptrdiff_t interval_step;
} algsurf_real_batch;
typedef enum algsurf_first_root_state {
    ALGSURF_FIRST_ROOT_NONE = 0,
    ALGSURF_FIRST_ROOT_FOUND = 1,
    ALGSURF_FIRST_ROOT_UNDECIDED = 2,
    ALGSURF_FIRST_ROOT_REFUSED = 4
} algsurf_first_root_state;
ALGSURF_API algsurf_status algsurf_first_roots_batch(const algsurf_real_batch *batch,
                                                     const algsurf_batch_options *options,
                                                     unsigned char *state, double *root);
ALGSURF_API algsurf_status algsurf_real_roots_batch(const algsurf_real_batch *batch,
                                                    const algsurf_batch_options *options,
                                                    algsurf_real_root *roots, int *count);
typedef struct algsurf_complex_batch {
    size_t size;
    size_t count;
    int degree;
    algsurf_table re;
    algsurf_table im;
    algsurf_table radii;
} algsurf_complex_batch;
ALGSURF_API algsurf_status algsurf_complex_roots_batch(const algsurf_complex_batch *batch,
                                                       const algsurf_batch_options *options,
                                                       algsurf_complex_root *roots, int *count);
#ifdef __cplusplus
}
#endif
#endif
