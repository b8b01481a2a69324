/* accuracy_ways.h - the rays of a view answered with one setting: timed, and judged by the truth. */
#ifndef ACCURACY_WAYS_H
#define ACCURACY_WAYS_H
#include "accuracy_truth.h"

typedef enum way {
    WAY_SINGLE, /* algsurf_intersect_first, ray by ray */
    WAY_PACKET, /* algsurf_intersect_packet, all rays in one call */
    WAY_PICTURE /* algsurf_render, the whole picture on one thread */
} way;

typedef struct setting {
    way way;
    int method;
    int tier;
    double tolerance;
} setting;

const char *way_name(way w);
const char *method_name(int method);
const char *tier_name(int tier);

/* A view, and room for its answers. */
typedef struct ways ways;
ways *ways_open(const view *v);
void ways_close(ways *w);

/* Answers the rays; seconds for each: CPU time, of a picture the wall time of its intersections, positions
 * and normals. */
double ways_run(ways *w, const setting *s);

typedef struct verdict {
    size_t hits;             /* of the rays that hit, those judged and told to */
    double usual, largest;   /* |t - exact| of these: 99.9 % do not exceed `usual`; 0 if there are none */
    size_t wrong, undecided; /* another state than the truth, or t off by more than is stated; undecided */
    size_t first_wrong;      /* the pixel of the first wrong one */
    const char *breach;      /* null, or what of it contradicts a promise of the setting, a static text */
    size_t at;               /* the pixel of the breach */
} verdict;

/* Of the answers of the last run.  Stated for t: the tolerance, rounding of t and with a tolerance of
 * the chord, for pictures 2^-36 of the extent's radius, and what a few rounding errors of P at the hit can
 * move the root.  A breach is a wrong state, an interval without the root or without t, an undecided interval
 * that begins behind the root; and t off by more than is stated, for all methods but regula falsi, which
 * promises nothing. */
verdict ways_judge(ways *w, const setting *s);

/* The largest of the tolerances, falling numbers, from which on the bytes of the setting's picture, standard
 * quality, are those of the last one; its index.  (The setting's own tolerance plays no part.) */
int ways_settled(ways *w, const setting *s, const double *tolerances, int count);

#endif
