/* complex_rows.h - complex space: a row starts from the roots of the row above. */
#ifndef ALGSURF_PICTURE_COMPLEX_ROWS_H
#define ALGSURF_PICTURE_COMPLEX_ROWS_H
#include "../beams/rows.h"
#include "line.h"
#include "geometry.h"
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

/* What kernels need to know of complex space, but for the sector. */
void algsurf_i_complex_prepare(const algsurf_scene *scene, algsurf_i_geometry *geometry);

#endif
