/* tiling.h - the tiles of a picture, a band of rows at a time.
 *
 * A tile is searched as one (tiles_template.h): all its rays miss, or each sees the same sheet of the
 * surface, or it is quartered.  The pixels of what is left, leaves, are solved side by side (pixels.c). */
#ifndef ALGSURF_TILING_H
#define ALGSURF_TILING_H
#include "../beams/rows.h"
#include "line.h"
#include "tally.h"

typedef struct algsurf_i_picture algsurf_i_picture;   /* impl.h */
typedef struct algsurf_i_worker algsurf_i_worker;     /* there, too */
typedef struct algsurf_i_geometry algsurf_i_geometry; /* geometry.h */

#define ALGSURF_I_TILES 16 /* pixels: the sides of the largest tiles, and rows of a band */

/* The tiles of a band of rows. */
typedef struct algsurf_i_band {
    int number;     /* its rows begin at number ALGSURF_I_TILES; -1: none yet */
    int begin, end; /* pixels of a row that have tiles: those whose rays are within the bounds of forms; */
    int whole;      /* 1: all others miss */
    int searched;   /* 1: what follows is there */
    algsurf_i_tile_counts counts;
    int *cell; /* as in algsurf_i_tile_job */
    algsurf_i_tile *tiles;
} algsurf_i_band;

/* A picture's bands, as a worker gets to them, and its memory for making them. */
typedef struct algsurf_i_tiling {
    algsurf_i_band band[2]; /* band b is at b % 2 */
    algsurf_i_beam_row beam;
    double *square; /* (degree+1)^2 */
    int *at;        /* of two levels of tiles that are to be searched: */
    double *from;   /* as in algsurf_i_tile_job */
    /* of a row in the making: the sheets of the line's entries, */
    double *low, *high, *enough;
    int runs_row, runs, *run; /* in a row of leaves: the pixels where each run begins and ends */
    double *list_low;         /* of the line's list: their rays have no root before; */
    /* and the pixels that are solved side by side, in the order of the row */
    int pixels, *pixel;
    double *pixel_low, *pixel_depth;
    uint8_t *pixel_state;
    algsurf_i_dips dips; /* of these; */
    double *thin;        /* depths of what is thin */
} algsurf_i_tiling;

/* Is this a picture for tiles, as far as one can tell beforehand? */
int algsurf_i_tiles_pay(const algsurf_i_picture *picture, const algsurf_i_geometry *geometry);

/* The tiles of the band that the row lies in; null: there are none, or, if they are to tell of `all` its
 * pixels, they do not. */
const algsurf_i_band *algsurf_i_band_of(const algsurf_i_picture *picture, int row, int all,
                                        algsurf_i_tiling *tiling);

/* Counts the band that the row lies in, if it is the first row of it that is drawn. */
void algsurf_i_count_tiles(const algsurf_i_picture *picture, int row, const algsurf_i_tiling *tiling,
                           algsurf_i_tally *tally);

#endif
