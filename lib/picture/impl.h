/* impl.h - the pieces of render: a picture, its rows, the pool of threads that draws them.
 *
 *     render.c           checks the arguments, reports
 *     allocate.c         the memory of a picture and its threads
 *     threads.c          hands rows to threads, calls progress, cancels
 *     processors.c       how many threads the system can run at once
 *     row.c              one row: samples -> hits -> colours -> planes
 *     antialias.c        which of its pixels get all samples, and what the others show
 *     cells.c            tiles as small as samples
 *     view.c             camera and extent in the units of packets
 *     pixel_range.c      the pixels of a row that may meet the extent
 *     tiles.c            which tiles of pixels are empty, which see one sheet of the surface
 *     tiled.c            the hits of a row by its tiles
 *     thin_row.c         the pixels of a row beside whose rays there is something thin
 *     thin.c             is there something thin beside a ray: boxes about it, halved (thin_box.c: one box)
 *     packets.c          the hits of a row by packets
 *     complex.c          complex space: the roots of a row, started from those of the row above
 *     shadow.c           which share of a light reaches a point
 *     lattice.c          the points of a light, and the directions, that are looked at
 *     shadow_rays.c      single rays of shadows, by packets
 */
#ifndef ALGSURF_RENDER_IMPL_H
#define ALGSURF_RENDER_IMPL_H
#include <stdatomic.h>
#include <stdint.h>
#include <string.h>

#include "kernel.h"
#include "lattice.h"
#include "scene_impl.h"
#include "shadow_kernel.h"
#include "srgb.h"

#define ALGSURF_MAX_THREADS 256

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
    const uint8_t *wanted; /* of each pixel: 1, it is to be sampled; null: all are */
    int wanted_count;
    int *list;      /* the wanted pixels of the row, from the left; */
    int begin, end; /* pixels of the row that are looked at now: begin .. end-1, */
    int listed;     /* of the list wanted_count from this one on */
    int dense;      /* so many samples of a pixel are among the row's, one or all that are side by side */
    int across;     /* samples of a pixel that are side by side; */
    int sample;     /* the row's samples are this one of across x across, row by row, and those that follow */
    int count;      /* points: hits and undecided ones */
    int *pixel;     /* of each point its sample of the row; in no particular order */
    algsurf_i_points points;
    const algsurf_i_colour_job *colours; /* null: none are asked for */
    float *colour;                       /* 3 for each point; */
    uint32_t *bytes; /* or, as_bytes, where each is a pixel of its own: red + 256 green + 65536 blue */
    int as_bytes;
    double *visible;                    /* light_count + 1 for each point, in full quality */
    struct algsurf_i_shadow_rays *rays; /* in full quality, in the making */
    double *depth;                      /* of each entry: where packets found it */
    double *imaginary;                  /* in complex space, the depth's imaginary part; else null */
    uint8_t *state; /* of each sample: an ALGSURF_LANE; of one solved alone, its algsurf_hit_state */
    uint8_t *way;   /* of each sample: as algsurf_picture.way; null: it is not asked for */
    algsurf_i_shown shown;
} algsurf_i_line;

#define ALGSURF_I_MOST_ACROSS 16 /* samples of a pixel */

#define ALGSURF_I_TILES 16 /* pixels: the sides of the largest tiles, and rows of a band */

/* Tiles that were searched, and what they were found to be; the others were quartered. */
typedef struct algsurf_i_tile_counts {
    uint64_t all, empty, sheets, leaves;
} algsurf_i_tile_counts;

/* The tiles of a band of rows. */
typedef struct algsurf_i_band {
    int number;     /* its rows begin at number ALGSURF_I_TILES; -1: none yet */
    int begin, end; /* pixels of a row that have tiles: those whose rays are within the bounds of forms */
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
    void *thin;     /* algsurf_i_thin_memory() bytes, where what is thin is drawn */
    int *at;        /* of two levels of tiles that are to be searched: */
    double *from;   /* as in algsurf_i_tile_job */
    double *to;
    /* of a row in the making: the sheets of the line's entries, */
    double *low, *high, *enough;
    uint8_t *sure;
    int runs_row, runs, *run; /* in a row of leaves: the pixels where each run begins and ends */
    /* of those that get all their samples, between which depths each ray's first root is; */
    double *pixel_low, *pixel_high;
    /* and the pixels of leaves */
    int leaves, *leaf;
    double *leaf_low, *leaf_high, *leaf_depth;
    uint8_t *leaf_state;
} algsurf_i_tiling;

/* What packets need to know of a picture. */
typedef struct algsurf_i_packets {
    algsurf_i_frame_form frame;
    int orthographic;
    double origin[2], per_slope, pixel; /* u = origin[0] + per_slope (x - width/2) pixel; v likewise */
    double near;                        /* depth of the eye */
    double extent_size[3], tolerance;   /* in the view's unit */
    /* the planes that cut something off, in the axes of the view and in those of the caller */
    algsurf_i_cut_plane view_planes[ALGSURF_MAX_CLIP_PLANES], planes[ALGSURF_MAX_CLIP_PLANES];
    int plane_count;
    double *beams;            /* in a tiled picture: algsurf_i_beam_expand's g */
    algsurf_i_fan *fans;      /* where shadows are drawn: of each light; or null */
    algsurf_i_taylor *taylor; /* there: for single rays; or null */
    /* complex space: as in algsurf_i_complex_job */
    algsurf_i_sector_edges sector;
    double imaginary[ALGSURF_MAX_DEGREE + 1];
    int top;
} algsurf_i_packets;

/* The samples of a picture's lights, where shadows are drawn: those of light l from first[l] to first[l+1]-1;
 * none of a light whose points differ from pixel to pixel. */
typedef struct algsurf_i_samples {
    double *place[2]; /* in the light's edges from its middle */
    int first[ALGSURF_MAX_LIGHTS + 1];
} algsurf_i_samples;

/* The roots of the pixels solved last, in complex space (algsurf_i_complex_job). */
typedef struct algsurf_i_predictor {
    double *x, *y;
    int row; /* whose they are; -1: of no use */
} algsurf_i_predictor;

#define ALGSURF_I_BAND                                                                                       \
    16 /* rows: one in so many begins without roots from above; they are drawn together                      \
        */

/* What is counted and timed: the fields of algsurf_render_stats that add up. */
typedef struct algsurf_i_tally {
    uint64_t rays, hits, undecided, shadow_rays, iterations, single_rays, thin;
    uint64_t empty_rays, sheet_rays, exact_rays;
    algsurf_i_tile_counts tiles;
    uint64_t without_memory; /* packets of rays of which some could not be decided for want of memory */
    double expand_s, solve_s, point_s, shade_s, shadow_s;
} algsurf_i_tally;

/* Where a row of pixels goes: what is null is not asked for. */
typedef struct algsurf_i_row_planes {
    uint8_t *pixels;
    int channels;
    double *t;
    float *normals;
    uint8_t *state, *way;
} algsurf_i_row_planes;

/* What is seen through the middles of the pixels of three rows: row y is at y % 3.  Where all pixels get all
 * samples, there is none of it. */
typedef struct algsurf_i_middles {
    int end;                       /* the rows before this one have been drawn */
    algsurf_i_row_planes shown[3]; /* what is asked for, pixels and states in any case */
    algsurf_i_tally counts[3];     /* of the rays through them */
    uint8_t *apart;                /* of each byte of the row in the making: is it far from a neighbour's? */
    uint8_t *wanted;               /* of each pixel of that row */
} algsurf_i_middles;

/* What one thread draws with, and where it is. */
typedef struct algsurf_i_worker {
    algsurf_i_line line;
    algsurf_i_row_form form; /* of the row in the making */
    algsurf_i_tiling tiling;
    algsurf_i_predictor predictor;
    algsurf_i_middles middles;
    int row, row_end; /* what is left of the rows it has taken */
    algsurf_i_tally tally;
} algsurf_i_worker;

/* What all rows of a picture share; only stop ever changes. */
typedef struct algsurf_i_picture {
    const algsurf_scene *scene;
    int width, height, row_begin, row_end;
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting;
    int light_count; /* of lighting */
    int shadows;     /* 1: light_samples is there, and shadows are drawn */
    algsurf_i_samples light_samples;
    const algsurf_i_kernel *kernel;
    const algsurf_i_picture_kernel *code; /* for that kernel */
    const algsurf_i_colour_kernel *shader;
    algsurf_i_packets *packets; /* null: every ray by itself */
    int timed;                  /* 1: the caller asks for stats */
    int tiled;                  /* 1: there are packets, and tiles of them */
    int thin;                   /* 1: what is thin is shown: there are packets, and tiles to find it */
    algsurf_picture planes;
    int channels; /* of a pixel of the pixels plane */
    algsurf_i_colour_job colours;
    uint8_t *curve;  /* of sRGB, SRGB_STEPS entries */
    int selective;   /* 1: only some pixels get all samples */
    atomic_int stop; /* 1: rows in the making are to be abandoned */
} algsurf_i_picture;

/* Draws one row, row_begin <= row < row_end, and adds to the tally.  OK, CANCELLED when stop was set (the
 * row's bytes are untouched then), or what intersect returned. */
algsurf_status algsurf_i_render_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally);

/* One sample a pixel: what is seen through the middles of a row's pixels.  OK, CANCELLED or what intersect
 * returned. */
algsurf_status algsurf_i_render_middles(const algsurf_i_picture *picture, int row,
                                        const algsurf_i_row_planes *planes, algsurf_i_worker *worker,
                                        algsurf_i_tally *tally);

/* Where sample x of the line's row is, in pixels from the left, if it is `offset` in its pixel; dense samples
 * have their own. */
static inline double algsurf_i_place_of(const algsurf_i_line *line, int x, double offset) {
    return line->dense > 1 ? (x + 0.5) / line->dense : x + offset;
}

/* No sample has been drawn yet. */
static inline void algsurf_i_begin_shown(const algsurf_i_shown *shown, int width) {
    memset(shown->samples, 0, (size_t)width * sizeof *shown->samples);
    if (shown->way) memset(shown->way, 0, (size_t)width);
}

/* Is t less than that of each sample of pixel x so far? */
static inline int algsurf_i_is_nearest(const algsurf_i_shown *shown, int x, double t) {
    return shown->samples[x] == 0 || t < shown->nearest[x];
}

/* Adds a sample to pixel x: its t; its colour is for the caller to add to the sum, which the first one sets
 * to 0. */
static inline void algsurf_i_add_sample(const algsurf_i_shown *shown, int x, double t) {
    int first = shown->samples[x]++ == 0;
    for (int k = 0; k < 3 && first; k++) shown->sum[3 * x + k] = 0;
    shown->nearest[x] = first || t < shown->nearest[x] ? t : shown->nearest[x];
}

/* The byte of 0 <= light <= 1. */
static inline uint8_t algsurf_i_byte_of(const uint8_t curve[SRGB_STEPS], double light) {
    return curve[algsurf_i_srgb_step((float)light)];
}

/* In a selective picture: draws the middles of the row and its neighbours, as far as they are missing, and
 * sets line.wanted. */
algsurf_status algsurf_i_choose_pixels(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                       algsurf_i_tally *tally);

/* The row as the middles of its pixels show it. */
void algsurf_i_copy_middles(const algsurf_i_middles *middles, int row, int width,
                            const algsurf_i_row_planes *planes);

/* The line's points from `first` on, as kernels are to find them. */
algsurf_i_points algsurf_i_points_to_find(const algsurf_i_picture *picture, const algsurf_i_line *line,
                                          int first);

/* Fills a picture's packets, but for the frame's arrays; 0 if this scene is not one for them. */
int algsurf_i_packets_geometry(const algsurf_i_picture *picture, algsurf_i_packets *packets);

/* The pixels of a row whose rays may meet what is shown: begin <= x < end; all others surely miss it. */
void algsurf_i_packets_range(const algsurf_i_row_job *job, int width, int *begin, int *end);

/* The row's form and job, through offset sx in each pixel, y from the top; and the pixels whose rays may meet
 * what is shown.  0: there are none, or they reach beyond the bounds of forms. */
int algsurf_i_begin_row(const algsurf_i_picture *picture, double y, double sx, algsurf_i_row_form *form,
                        algsurf_i_row_job *job, int *begin, int *end);

/* What the jobs of all rows have in common; the offset is that of the pixels' left edges. */
algsurf_i_row_job algsurf_i_any_row(const algsurf_i_picture *picture);

/* The row's job, without its form's coefficients. */
void algsurf_i_make_row(const algsurf_i_picture *picture, double y, double sx, algsurf_i_row_form *form,
                        algsurf_i_row_job *job);

/* Are there forms for tiles as small as pixels, and all rays of a row within their bounds? */
int algsurf_i_has_cells(const algsurf_i_picture *picture, double y);

/* The pixels between two heights, counted from the top, whose rays are within the bounds of forms, and so are
 * those of `margin` pixels beside them, and of one above and below. */
void algsurf_i_range_within_bounds(const algsurf_i_picture *picture, double top, double bottom, int margin,
                                   int *begin, int *end);

/* Is this a picture for tiles, as far as one can tell beforehand? */
int algsurf_i_tiles_pay(const algsurf_i_picture *picture, const algsurf_i_packets *packets);

/* The tiles of the band that the row lies in; null: there are none, or, if they are to be of `all` its
 * pixels, not of all. */
const algsurf_i_band *algsurf_i_band_of(const algsurf_i_picture *picture, int row, int all,
                                        algsurf_i_tiling *tiling);

/* Counts the band that the row lies in, if it is the first row of it that is drawn. */
void algsurf_i_count_tiles(const algsurf_i_picture *picture, int row, const algsurf_i_tiling *tiling,
                           algsurf_i_tally *tally);

/* As algsurf_i_render_packets, for a row of a band that has tiles. */
algsurf_status algsurf_i_render_tiled(const algsurf_i_picture *picture, const algsurf_i_band *band, int row,
                                      double sx, double sy, algsurf_i_worker *worker, algsurf_i_tally *tally);

/* The samples of the line's listed pixels that are side by side, sy below the row's upper end: adds those
 * found to the line's points; returns whether some are undecided. */
int algsurf_i_render_listed(const algsurf_i_picture *picture, int row, double sy, algsurf_i_worker *worker,
                            algsurf_i_tally *tally);

/* Adds to the line, whose points have their colours, what is thin beside the pixels' rays. */
void algsurf_i_add_thin(const algsurf_i_picture *picture, int row, double sx, double sy,
                        algsurf_i_worker *worker, algsurf_i_tally *tally);

/* The rays of undecided samples, begin <= x < end, as packets: their points go to the line. */
algsurf_status algsurf_i_solve_undecided(const algsurf_i_picture *picture, double y, double sx, int begin,
                                         int end, algsurf_i_line *line, algsurf_i_tally *tally);

/* The points of a row seen through offset (sx,sy) in each pixel. */
algsurf_status algsurf_i_render_packets(const algsurf_i_picture *picture, int row, double sx, double sy,
                                        algsurf_i_worker *worker, algsurf_i_tally *tally);

/* The same where there is no frame: each pixel's own ray. */
algsurf_status algsurf_i_render_rays(const algsurf_i_picture *picture, int row, double sx, double sy,
                                     algsurf_i_line *line, algsurf_i_tally *tally);

/* Appends a single ray's hit at pixel x to the line's points, if it is one, sets its state and way, and
 * counts it. */
void algsurf_i_line_add(algsurf_i_line *line, int x, const algsurf_ray *ray, const algsurf_hit *hit,
                        algsurf_i_tally *tally);

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
algsurf_status algsurf_i_complex_doubtful(const algsurf_i_picture *picture, double y, double sx, int begin,
                                          int end, algsurf_i_line *line, algsurf_i_tally *tally);

/* Sets light_samples.first; then light_samples.place, for which there is room. */
void algsurf_i_count_samples(algsurf_i_picture *picture);
void algsurf_i_place_samples(algsurf_i_picture *picture);

/* What is known of shadow rays for all rows; memory as for algsurf_i_frame_expand. */
void algsurf_i_make_shadows(const algsurf_i_picture *picture, void *memory);

/* line->visible of a row's points: the share of each light's points that nothing hides, 1 where that adds
 * nothing to the colour whatever the share, and that of free directions.  The rays shot are added to the
 * tally. */
algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, int row, algsurf_i_line *line,
                                        algsurf_i_tally *tally);

/* Memory for a picture and its workers, all 0, to be freed; null: there is none. */
void *algsurf_i_allocate(algsurf_i_picture *picture, int threads, algsurf_i_worker **workers);

/* How many processors there are; less than 1 if the system fails to tell. */
long algsurf_i_processors(void);

/* Draws all rows with at most the given number of threads, the caller's among them; there is a worker
 * for each.  threads_used receives how many could be had. */
algsurf_status algsurf_i_render_threads(algsurf_i_picture *picture, const algsurf_render_options *options,
                                        int threads, algsurf_i_worker *workers, algsurf_i_tally *total,
                                        int *threads_used);

void algsurf_i_tally_add(algsurf_i_tally *total, const algsurf_i_tally *more);

/* Seconds since some moment in the past; never goes back.  0 if nobody asks for the picture's times. */
double algsurf_i_render_clock(const algsurf_i_picture *picture);

#endif
