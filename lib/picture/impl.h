/* impl.h - a picture in the making: what all its rows share, a row and its tiles, what each thread draws
 * with, and the steps of a row. */
#ifndef ALGSURF_RENDER_IMPL_H
#define ALGSURF_RENDER_IMPL_H
#include <stdatomic.h>
#include <stdint.h>
#include <string.h>

#include "../base/threads.h"
#include "../beams/kernels.h"
#include "../beams/segments.h"
#include "colours.h"
#include "scene_impl.h"

#define ALGSURF_MAX_THREADS 256

/* What kernels need to know of a picture whose rays share a view (scene_view.c). */
typedef struct algsurf_i_geometry {
    algsurf_i_frame_form frame;
    algsurf_i_row_job rays; /* what the jobs of all rows have in common, through the pixels' left edges */
    double v0;              /* of the picture's middle, as rays.u0 */
    int orthographic;
    /* the planes that cut something off, in the axes of the view and in those of the caller */
    algsurf_i_cut_plane view_planes[ALGSURF_MAX_CLIP_PLANES], planes[ALGSURF_MAX_CLIP_PLANES];
    double thin_bends[ALGSURF_MAX_VIEW_DEGREE + 1]; /* as in algsurf_i_row_job */
    double *beams;                                  /* in a tiled picture: algsurf_i_beam_expand's g */
    algsurf_i_taylor taylor;                        /* where shadows are drawn */
    /* complex space: as in algsurf_i_complex_job */
    algsurf_i_sector_edges sector;
    double imaginary[ALGSURF_MAX_DEGREE + 1];
    int top;
} algsurf_i_geometry;

/* What all rows of a picture share; only stop ever changes. */
typedef struct algsurf_i_picture {
    const algsurf_scene *scene;
    int width, height, row_begin, row_end;
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting;
    int shadows;                            /* 1: they are drawn, and what follows is there */
    double *samples[ALGSURF_MAX_LIGHTS][2]; /* in a light's edges from its middle; none of a light whose
                                               points differ from pixel to pixel */
    const algsurf_i_kernel *kernel;
    const algsurf_i_beams_kernel *code; /* for that kernel */
    const algsurf_i_colour_kernel *shader;
    algsurf_i_geometry *geometry; /* null: every ray by itself */
    int timed;                    /* 1: the caller asks for stats */
    int tiled;                    /* 1: there is a view, and tiles of it */
    int thin;                     /* 1: what is thin is shown: there is a view */
    algsurf_picture planes;
    algsurf_i_colour_job colours, thin_colours;
    uint8_t *curve;  /* of sRGB, SRGB_STEPS entries */
    int selective;   /* 1: only some pixels get all samples */
    atomic_int stop; /* 1: rows in the making are to be abandoned */
} algsurf_i_picture;

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

/* A row in the making.  A pass adds one sample of each pixel, or several that lie side by side: its points
 * are found, coloured and added to what the pixels show.  Samples of a row are counted from its left end:
 * sample i is in pixel i / dense. */
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
    int corners;    /* of these are looked at now: 1, those in a corner of the pixel; 0, the others */
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

/* Sample k of across x across is looked at now. */
static inline int algsurf_i_is_in_pass(const algsurf_i_line *line, int k) {
    const int last = line->across - 1, x = k % line->across, y = k / line->across;
    return line->corners == ((x == 0 || x == last) && (y == 0 || y == last));
}

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

#define ALGSURF_I_BAND 16 /* rows of complex space that are drawn together */

/* ---- tiles, a band of rows at a time ---- */

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

/* A band's cells (algsurf_i_tile_job) in a row of them, and the first one of those that a row is in. */
static inline int algsurf_i_cells_across(const algsurf_i_picture *picture) {
    return (picture->width + ALGSURF_I_LEAF - 1) / ALGSURF_I_LEAF;
}
static inline int algsurf_i_first_cell(const algsurf_i_picture *picture, int row) {
    return row % ALGSURF_I_TILES / ALGSURF_I_LEAF * algsurf_i_cells_across(picture);
}

/* What one thread draws with, and where it is. */
typedef struct algsurf_i_worker {
    const algsurf_i_picture *picture;
    algsurf_i_line line;
    algsurf_i_row_form form; /* of the row in the making */
    algsurf_i_tiling tiling;
    algsurf_i_predictor predictor;
    algsurf_i_middles middles;
    int row, row_end; /* what is left of the rows it has taken */
    algsurf_i_tally all;
    algsurf_i_tally *tally;   /* where it counts: all, or what may not count */
    double lap;               /* the clock when it was last read, for `all` */
    struct thread_pool *pool; /* threads.c */
    pthread_t thread;
} algsurf_i_worker;

/* Seconds since some moment in the past; never goes back.  0 if nobody asks for the picture's times. */
double algsurf_i_render_clock(const algsurf_i_picture *picture);

/* Adds the time since the clock was read last. */
static inline void algsurf_i_lap(algsurf_i_worker *worker, double *seconds) {
    double now = algsurf_i_render_clock(worker->picture);
    *seconds += now - worker->lap;
    worker->lap = now;
}

static inline int algsurf_i_stopped(const algsurf_i_picture *picture) {
    return atomic_load_explicit(&picture->stop, memory_order_relaxed);
}

/* ---- before the first row ---- */

/* Fills a picture's geometry, but for the frame's arrays; 0 if this scene is not one for them. */
int algsurf_i_find_geometry(const algsurf_i_picture *picture, algsurf_i_geometry *geometry);

/* Sets how small and how large things are for which thin ones are looked for. */
void algsurf_i_prepare_thin(algsurf_i_geometry *geometry);

/* Is this a picture for tiles, as far as one can tell beforehand? */
int algsurf_i_tiles_pay(const algsurf_i_picture *picture, const algsurf_i_geometry *geometry);

/* Sets the samples of lights, for which there is room. */
void algsurf_i_place_samples(algsurf_i_picture *picture);

/* What is known of shadow rays for all rows; memory as for algsurf_i_frame_expand. */
void algsurf_i_make_shadows(const algsurf_i_picture *picture, void *memory);
size_t algsurf_i_shadow_memory(void); /* of line.rays */

/* Memory for a picture and its workers, all 0, to be freed; null: there is none. */
void *algsurf_i_allocate(algsurf_i_picture *picture, int threads, algsurf_i_worker **workers);

/* How many threads to draw with: as many as there are processors, if nobody tells; never more than rows. */
int algsurf_i_thread_count(const algsurf_render_options *options);

/* Draws all rows with at most the given number of threads, the caller's among them; there is a worker
 * for each.  total->stats.threads receives how many could be had. */
algsurf_status algsurf_i_render_threads(algsurf_i_picture *picture, const algsurf_render_options *options,
                                        int threads, algsurf_i_worker *workers, algsurf_i_tally *total);

/* ---- the steps of a row, which count in worker->tally.  OK, CANCELLED, or a light is not finite ---- */

/* Draws one row, row_begin <= row < row_end.  When cancelled, the row's bytes are untouched. */
algsurf_status algsurf_i_render_row(algsurf_i_worker *worker, int row);

/* One sample a pixel: what is seen through the middles of a row's pixels. */
algsurf_status algsurf_i_render_middles(algsurf_i_worker *worker, int row, const algsurf_picture *planes);

/* In a selective picture: draws the middles of the row and its neighbours, as far as they are missing, and
 * sets line.wanted. */
algsurf_status algsurf_i_choose_pixels(algsurf_i_worker *worker, int row);

/* Of these, by what their corners show, those that are to get all samples. */
void algsurf_i_keep_apart(algsurf_i_worker *worker, int row);

/* The job of the row y from the top, through offset sx in each pixel, or through all of `dense` > 1 samples
 * side by side; without its form's coefficients. */
void algsurf_i_make_row(const algsurf_i_picture *picture, double y, double sx, int dense,
                        algsurf_i_row_form *form, algsurf_i_row_job *job);

/* The pixels begin <= x < end, multiples of `step`, all of whose rays between two heights, counted in pixels
 * from the top, are within the bounds of forms; the last `step` pixels may reach beyond the picture.  Returns
 * 1 if the rays of all others surely miss what is shown. */
int algsurf_i_pixels_within_bounds(const algsurf_i_picture *picture, double top, double bottom, int step,
                                   int *begin, int *end);

/* The tiles of the band that the row lies in; null: there are none that tell of all its pixels. */
const algsurf_i_band *algsurf_i_band_of(algsurf_i_worker *worker, int row);

/* Counts the band that the row lies in, if it is the first row of it that is drawn. */
void algsurf_i_count_tiles(algsurf_i_worker *worker, int row);

/* In a picture with a view: the points of a row, seen through offset (sx,sy) in each wanted pixel, are added
 * to the line's; in real space by tiles, where there are any, and by forms.  Return whether some are
 * undecided. */
int algsurf_i_solve_row(algsurf_i_worker *worker, int row, double sx, double sy);
int algsurf_i_solve_complex_row(algsurf_i_worker *worker, int row, double sx, double sy);

/* The same of the samples of the line's listed pixels that are side by side, those in the pass, sy below the
 * row's upper end. */
int algsurf_i_solve_listed(algsurf_i_worker *worker, int row, double sy);

/* The rays of undecided samples, begin <= x < end, y from the top. */
algsurf_status algsurf_i_solve_undecided(algsurf_i_worker *worker, double y, double sx, int begin, int end);

/* The line's points from `first` on, as kernels are to find them; and those that were not found, as line.sure
 * tells, leave the line: their samples are undecided. */
algsurf_i_points algsurf_i_points_to_find(const algsurf_i_worker *worker, int first);
void algsurf_i_drop_unsure(algsurf_i_line *line, int first);

/* line.visible of a row's points: the share of each light's points that nothing hides, 1 where that adds
 * nothing to the colour whatever the share, and that of free directions. */
algsurf_status algsurf_i_render_shadows(algsurf_i_worker *worker, int row);

/* Adds to the line, whose points have their colours, what is thin beside the pixels' rays (thin_template.h
 * tells how it is found). */
void algsurf_i_add_thin(algsurf_i_worker *worker, int row, double sx, double sy);

#endif
