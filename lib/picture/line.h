/* line.h - a row in the making: the points that are seen through its pixels, what the pixels show, and the
 * tiles that they are in.
 *
 * A pass adds one sample of each pixel, or several that lie side by side: its points are found, coloured and
 * added to what the pixels show. */
#ifndef ALGSURF_LINE_H
#define ALGSURF_LINE_H
#include <stdint.h>
#include <string.h>

#include "algsurf/intersect.h"
#include "algsurf/render.h"
#include "colours.h"

/* What is counted and timed while rows are drawn: by each thread, then added up. */
typedef struct algsurf_i_tally {
    algsurf_render_stats stats; /* of it what adds up */
    uint64_t without_memory;    /* packets of rays of which some could not be decided for want of memory */
} algsurf_i_tally;

void algsurf_i_tally_add(algsurf_i_tally *total, const algsurf_i_tally *more);

/* What the pixels of a row show, over the samples drawn so far. */
typedef struct algsurf_i_shown {
    uint16_t *samples; /* of each pixel: how many of its samples show a point; 0: the others mean nothing */
    double *sum;       /* 3 for each pixel: the colours of those, if colours are asked for */
    double *nearest;   /* their smallest t */
    double *normal;    /* 3 for each pixel: the normal there, or null: it is not asked for */
    uint8_t *state;    /* the int there, or null likewise */
    uint8_t *way;      /* the largest algsurf_picture.way of all samples, or null likewise */
} algsurf_i_shown;

/* The points of a row that are seen through one sample of its pixels, or through several that lie side by
 * side, and what the pixels show.  Samples of a row are counted from its left end: sample i is in pixel i /
 * dense. */
typedef struct algsurf_i_line {
    const uint8_t *wanted; /* of each pixel: 1, it is to be sampled; 2, and something thin may be seen through
                              it; 0, it is not; null: all are, and may */
    int wanted_count;
    int *list;      /* the wanted pixels of the row, from the left; */
    int begin, end; /* pixels of the row that are looked at now: begin .. end-1, */
    int listed;     /* of the list wanted_count from this one on */
    int dense;      /* so many samples of a pixel are among the row's, one or all that are side by side */
    int across;     /* samples of a pixel that are side by side; */
    int sample;     /* the row's samples are this one of across x across, row by row, and those that follow */
    int thin;       /* 1: what is thin beside them is looked for */
    int count;      /* points: hits and undecided ones */
    int *pixel;     /* of each point its sample of the row; in no particular order */
    algsurf_i_points points;
    const algsurf_i_colour_job *colours; /* null: none are asked for */
    float *colour;                       /* 3 for each point; */
    uint32_t *bytes; /* or, where each is a pixel of its own, across = 1: red + 256 green + 65536 blue */
    double *visible; /* light_count + 1 for each point, in full quality */
    struct algsurf_i_shadow_rays *rays; /* likewise, in the making: shadow.c */
    double *depth;                      /* of each entry: where kernels found it */
    uint8_t *sure;                      /* of each entry: kernels have found its point */
    double *imaginary;                  /* in complex space, the depth's imaginary part; else null */
    uint8_t *state; /* of each sample: an ALGSURF_LANE; of one solved alone, its algsurf_hit_state */
    uint8_t *way;   /* of each sample: as algsurf_picture.way; null: it is not asked for */
    algsurf_i_shown shown;
} algsurf_i_line;

#define ALGSURF_I_MOST_ACROSS 16 /* samples of a pixel */

/* Bytes of a pixel, where bytes are asked for. */
static inline int algsurf_i_channels(const algsurf_picture *planes) {
    return planes->format == ALGSURF_RGBA8 ? 4 : 3;
}

/* The states of the row's samples, one a pixel, before it is solved: those wanted miss, or are undecided. */
static inline void algsurf_i_begin_states(const algsurf_i_line *line, int misses) {
    memset(line->state + line->begin, misses ? ALGSURF_LANE_MISS : ALGSURF_LANE_UNDECIDED,
           (size_t)(line->end - line->begin));
    for (int x = line->begin; line->wanted && !misses && x < line->end; x++)
        if (!line->wanted[x]) line->state[x] = ALGSURF_LANE_MISS;
}

/* What is seen through the middles of the pixels of three rows: row y is at y % 3.  Where all pixels get all
 * samples, there is none of it. */
typedef struct algsurf_i_middles {
    int end;                   /* the rows before this one have been drawn */
    algsurf_picture shown[3];  /* what is asked for, pixels and states in any case */
    algsurf_i_tally counts[3]; /* of the rays through them */
    uint8_t *apart;            /* of each byte of the row in the making: is it far from a neighbour's? */
    uint8_t *wanted;           /* of each pixel of that row */
} algsurf_i_middles;

/* The roots of the pixels solved last, in complex space (algsurf_i_complex_job). */
typedef struct algsurf_i_predictor {
    double *x, *y;
    int row; /* whose they are; -1: of no use */
} algsurf_i_predictor;

/* Rows: in complex space one in so many begins without roots from above; those up to the next one are drawn
 * together. */
#define ALGSURF_I_BAND 16

/* ---- tiles, a band of rows at a time ----
 *
 * A tile is searched as one (tiles_template.h): all its rays miss, or each sees the same sheet of the
 * surface, or it is quartered.  The pixels of what is left, leaves, are solved side by side (pixels.c). */

#define ALGSURF_I_TILES 16 /* pixels: the sides of the largest tiles, and rows of a band */

/* The tiles of a band of rows. */
typedef struct algsurf_i_band {
    int number;     /* its rows begin at number ALGSURF_I_TILES; -1: none yet */
    int begin, end; /* pixels of a row that have tiles: those whose rays are within the bounds of forms; */
    int whole;      /* 1: all others miss, and what follows is there */
    algsurf_i_tally counts;
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
    double *list_low; /* of the line's list: their rays have no root before; */
    /* and the pixels that are solved side by side, in the order of the row */
    int pixels, *pixel;
    double *pixel_low, *pixel_depth;
    uint8_t *pixel_state;
    algsurf_i_dips dips;   /* of these; */
    double *thin;          /* depths of what is thin, */
    double *thin_along[3]; /* and directions of lines */
} algsurf_i_tiling;

#endif
