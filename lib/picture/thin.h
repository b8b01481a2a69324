/* thin.h - what is thin beside the rays of a row (thin_template.h tells how it is found). */
#ifndef ALGSURF_PICTURE_THIN_H
#define ALGSURF_PICTURE_THIN_H
#include "../beams/rows.h"
#include "tally.h"
#include "tiling.h"

typedef struct algsurf_i_picture algsurf_i_picture; /* impl.h */
typedef struct algsurf_i_worker algsurf_i_worker;   /* there, too */

/* Sets how small and how large things are for which thin ones are looked for. */
void algsurf_i_prepare_thin(algsurf_i_geometry *geometry, int across);

/* Adds to the line, whose points have their colours, what is thin beside the pixels' rays. */
void algsurf_i_add_thin(const algsurf_i_picture *picture, int row, double sx, double sy,
                        algsurf_i_worker *worker, algsurf_i_tally *tally);

#endif
