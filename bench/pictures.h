/* pictures.h - one surface as pictures shows it, drawn in different ways, judged, and timed; what is told of
 * that. */
#ifndef PICTURES_H
#define PICTURES_H
#include "catalogue.h"
#include "measure.h"

/* What a picture owes to the reference: the fastest kernel's, one thread, certified tier, standard quality.
 */
typedef enum duty {
    DUTY_PICTURE, /* the same bytes, of its hits too */
    DUTY_HITS,    /* the same bytes of its hits */
    DUTY_MASK,    /* a hit at the same pixels */
    DUTY_OPEN,    /* a hit at the same pixels, but for those that the bounded tier leaves open */
    DUTY_SMOOTH,  /* of n x n samples, n odd: a hit at least at those pixels; it is kept */
    DUTY_EITHER,  /* each pixel as in the reference or as in the picture kept */
    DUTY_EMPTY    /* not this: no hit at all */
} duty;

/* A way to draw. */
typedef struct manner {
    const char *name, *kernel; /* kernel null: the fastest */
    int threads;               /* as algsurf_render_options */
    int tier;
    algsurf_quality quality;
    int method;
    int antialias; /* n x n samples a pixel; 0: one */
    double threshold;
    int lifted; /* the surface plus a constant that leaves no zero inside the extent */
    int once;   /* not repeated */
    duty duty;
} manner;

typedef struct stage stage;

/* The surface in its view, and the reference, drawn.  Ends the program when that cannot be had. */
stage *stage_open(const catalogue_entry *entry, int width, int height);
void stage_close(stage *s);

size_t stage_rays(const stage *s); /* rays through the middle of a pixel that meet the extent */
size_t stage_hits(const stage *s); /* of the reference */

/* Draws.  Returns null, or how the picture fails its duty, a static text. */
const char *stage_draw(stage *s, const manner *m, algsurf_render_stats *stats);

/* ---- what is told ---- */

enum { MAX_KERNELS = 8, MAX_MANNERS = 2 * MAX_KERNELS + 8 };

/* Of a picture's time: PART_ALL is that of the call, on the wall; the others are summed over threads. */
enum { PART_ALL, PART_EXPAND, PART_SOLVE, PART_POINT, PART_SHADOW, PART_SHADE, PARTS };

/* First the kernels, the fastest first, then their floors in the same order, then the others. */
typedef struct plan {
    manner manner[MAX_MANNERS];
    int kernels, count;
} plan;

/* A surface, drawn in all of them. */
typedef struct result {
    const catalogue_entry *entry;
    size_t rays, hits;
    int threads[MAX_MANNERS];
    measure_takes takes[MAX_MANNERS][PARTS];
} result;

typedef struct report {
    const plan *plan;
    const result *results;
    int surfaces, width, height, repeat;
} report;

/* The tables on standard output; into the folder, unless it is null, pictures.csv, pictures_floor.csv,
 * pictures.svg. Ends the program when they cannot be written. */
void report_all(const report *r, int tsv, const char *folder);

#endif
