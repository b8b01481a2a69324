/* solve.h - the points of a row, seen through offset (sx,sy) in each wanted pixel: added to the line's. */
#ifndef ALGSURF_SOLVE_H
#define ALGSURF_SOLVE_H
#include "line.h"
#include "tally.h"

typedef struct algsurf_i_picture algsurf_i_picture; /* impl.h */
typedef struct algsurf_i_worker algsurf_i_worker;   /* there, too */

/* In a picture with a view, in real space: by tiles, where there are any, and by forms. */
algsurf_status algsurf_i_solve_row(const algsurf_i_picture *picture, int row, double sx, double sy,
                                   algsurf_i_worker *worker, algsurf_i_tally *tally);

/* The samples of the line's listed pixels that are side by side, sy below the row's upper end; returns
 * whether some are undecided. */
int algsurf_i_solve_listed(const algsurf_i_picture *picture, int row, double sy, algsurf_i_worker *worker,
                           algsurf_i_tally *tally);

/* In complex space: by forms in a picture with a view, else each pixel's own ray. */
algsurf_status algsurf_i_solve_complex_row(const algsurf_i_picture *picture, int row, double sx, double sy,
                                           algsurf_i_worker *worker, algsurf_i_tally *tally);

/* In a picture without a view, in real space: each pixel's own ray. */
algsurf_status algsurf_i_solve_rays(const algsurf_i_picture *picture, int row, double sx, double sy,
                                    algsurf_i_line *line, algsurf_i_tally *tally);

/* The rays of undecided samples, begin <= x < end, y from the top, in real space. */
algsurf_status algsurf_i_solve_undecided(const algsurf_i_picture *picture, double y, double sx, int begin,
                                         int end, algsurf_i_line *line, algsurf_i_tally *tally);

#endif
