/* complex_impl.h - complex space: a row starts from the roots of the row above. */
#ifndef ALGSURF_COMPLEX_IMPL_H
#define ALGSURF_COMPLEX_IMPL_H
#include "kernel.h"
#include "line.h"
#include "packets.h"
#include "scene_impl.h"
#include "tally.h"

typedef struct algsurf_i_picture algsurf_i_picture; /* impl.h */
typedef struct algsurf_i_worker algsurf_i_worker;   /* there, too */

/* The roots of the pixels solved last, in complex space (algsurf_i_complex_job). */
typedef struct algsurf_i_predictor {
    double *x, *y;
    int row; /* whose they are; -1: of no use */
} algsurf_i_predictor;

/* Rows: one in so many begins without roots from above; those up to the next one are drawn together. */
#define ALGSURF_I_BAND 16

/* What packets need to know of complex space, but for the sector. */
void algsurf_i_complex_prepare(const algsurf_scene *scene, algsurf_i_packets *packets);

algsurf_i_complex_job algsurf_i_complex_job_of(const algsurf_i_picture *picture, const algsurf_i_row_job *row,
                                               algsurf_i_worker *worker);

/* Before a pass over a row: the predictor holds what it is to start from.  After it: the pixels from begin to
 * end have been solved. */
void algsurf_i_complex_begin_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker);
void algsurf_i_complex_end_row(const algsurf_i_picture *picture, int row, int begin, int end,
                               algsurf_i_worker *worker);

/* The undecided pixels of a row in complex space, ray by ray: their points go to the line. */
algsurf_status algsurf_i_complex_solve_undecided(const algsurf_i_picture *picture, double y, double sx,
                                                 int begin, int end, algsurf_i_line *line,
                                                 algsurf_i_tally *tally);

#endif
