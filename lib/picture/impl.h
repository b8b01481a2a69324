/* impl.h - a picture in the making: what all its rows share, and what each thread draws with.
 *
 * render.c checks and prepares it, allocate.c gives it memory, threads.c hands out its rows, row.c draws
 * them. */
#ifndef ALGSURF_RENDER_IMPL_H
#define ALGSURF_RENDER_IMPL_H
#include <stdatomic.h>

#include "antialias.h"
#include "complex_rows.h"
#include "../beams/kernels.h"
#include "colours.h"
#include "line.h"
#include "geometry.h"
#include "scene_impl.h"
#include "shadow.h"
#include "tally.h"
#include "tiling.h"

#define ALGSURF_MAX_THREADS 256

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
    const algsurf_i_beams_kernel *code; /* for that kernel */
    const algsurf_i_colour_kernel *shader;
    algsurf_i_geometry *geometry; /* null: every ray by itself */
    int timed;                    /* 1: the caller asks for stats */
    int tiled;                    /* 1: there is a view, and tiles of it */
    int thin;                     /* 1: what is thin is shown: there is a view */
    algsurf_picture planes;
    int channels; /* of a pixel of the pixels plane */
    algsurf_i_colour_job colours;
    uint8_t *curve;  /* of sRGB, SRGB_STEPS entries */
    int selective;   /* 1: only some pixels get all samples */
    atomic_int stop; /* 1: rows in the making are to be abandoned */
} algsurf_i_picture;

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

/* Memory for a picture and its workers, all 0, to be freed; null: there is none. */
void *algsurf_i_allocate(algsurf_i_picture *picture, int threads, algsurf_i_worker **workers);

/* How many processors there are; less than 1 if the system fails to tell. */
long algsurf_i_processors(void);

/* Draws all rows with at most the given number of threads, the caller's among them; there is a worker
 * for each.  threads_used receives how many could be had. */
algsurf_status algsurf_i_render_threads(algsurf_i_picture *picture, const algsurf_render_options *options,
                                        int threads, algsurf_i_worker *workers, algsurf_i_tally *total,
                                        int *threads_used);

/* Draws one row, row_begin <= row < row_end, and adds to the tally.  OK, CANCELLED when stop was set (the
 * row's bytes are untouched then), or what intersect returned. */
algsurf_status algsurf_i_render_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally);

/* One sample a pixel: what is seen through the middles of a row's pixels.  OK, CANCELLED or what intersect
 * returned. */
algsurf_status algsurf_i_render_middles(const algsurf_i_picture *picture, int row,
                                        const algsurf_i_row_planes *planes, algsurf_i_worker *worker,
                                        algsurf_i_tally *tally);

#endif
