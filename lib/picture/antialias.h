/* antialias.h - which pixels get all their samples, by what is seen through the middles of all. */
#ifndef ALGSURF_ANTIALIAS_H
#define ALGSURF_ANTIALIAS_H
#include "line.h"
#include "tally.h"

typedef struct algsurf_i_picture algsurf_i_picture; /* impl.h */
typedef struct algsurf_i_worker algsurf_i_worker;   /* there, too */

/* What is seen through the middles of the pixels of three rows: row y is at y % 3.  Where all pixels get all
 * samples, there is none of it. */
typedef struct algsurf_i_middles {
    int end;                       /* the rows before this one have been drawn */
    algsurf_i_row_planes shown[3]; /* what is asked for, pixels and states in any case */
    algsurf_i_tally counts[3];     /* of the rays through them */
    uint8_t *apart;                /* of each byte of the row in the making: is it far from a neighbour's? */
    uint8_t *wanted;               /* of each pixel of that row */
} algsurf_i_middles;

/* In a selective picture: draws the middles of the row and its neighbours, as far as they are missing, and
 * sets line.wanted. */
algsurf_status algsurf_i_choose_pixels(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                       algsurf_i_tally *tally);

/* The row as the middles of its pixels show it. */
void algsurf_i_copy_middles(const algsurf_i_middles *middles, int row, int width,
                            const algsurf_i_row_planes *planes);

#endif
