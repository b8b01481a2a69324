/* accuracy.h - what the parts of the benchmark accuracy share. */
#ifndef ACCURACY_H
#define ACCURACY_H
#include "catalogue.h"
#include "measure.h"

/* ---- rays of a surface's view, and where each of them first meets it, proved ---- */

typedef struct truth {
    int state;      /* an algsurf_hit_state: what the certified tier says */
    int left_open;  /* doubles do not decide this ray: the bounded tier is undecided */
    double lo, hi;  /* encloses the first root, which no other precedes */
    double t, rest; /* t + rest is the root: |t + rest - exact| <= error, proved here */
    double error;   /* infinite if it could not be proved: the error of t is then not told */
} truth;

/* A surface in its view of the catalogue, and rays through the middle of pixels, row by row, those that meet
 * the extent, of some of the picture's rows. */
typedef struct view {
    const catalogue_entry *entry;
    algsurf_surface *surface;
    algsurf_term *terms;
    size_t term_count;
    algsurf_camera camera;
    int width, height;
    size_t all_rays;          /* of the whole picture, those that meet the extent */
    size_t count;             /* of rays here */
    size_t *pixel;            /* of each, row times width plus column */
    algsurf_ray *ray, *chord; /* the whole ray, and what of it is inside the extent */
    truth *truth;
    size_t hits, open, unproved; /* hits; undecided ones; hits with an infinite error */
    double worst;                /* the largest finite error */
} view;

/* Takes the rays of `rows` rows, evenly spread, 1 <= rows <= height.  Ends the program with one line when
 * that cannot be had, and when an answer of the certified tier is contradicted by the sign of P. */
view *view_open(const catalogue_entry *entry, int width, int height, int rows);
void view_close(view *v);

/* |P| at t on ray i, in units of 2^-53 sum |a x^i y^j z^k| over the terms of P: rounding its coefficients
 * gives as much. */
double view_noise(const view *v, size_t i, double t);

/* ---- the rays of a view answered with one setting: timed, and judged by the truth ---- */

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

extern const char *const way_names[3], *const method_names[4], *const tier_names[2];

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

/* ---- what was found out ---- */

enum { TOLERANCES = 16, METHODS = 4, TIERS = 2, LINES = METHODS * TIERS + 2 * TIERS };

/* Falling; the last is 0: all that a double can tell. */
extern const double accuracy_tolerances[TOLERANCES];

/* A way, method and tier, with every tolerance. */
typedef struct line {
    setting setting; /* its tolerance plays no part */
    verdict verdict[TOLERANCES];
    measure_takes takes[TOLERANCES]; /* of a ray */
    int settled;                     /* index as ways_settled tells; -1: not looked for */
} line;

typedef struct record {
    const catalogue_entry *entry;
    size_t rays, hits, open;
    double worst; /* error of the reference */
    line line[LINES];
} record;

void report_table(const record *r);
void report_advice(const record *records, int count);

/* accuracy.csv of all, accuracy_NAME.svg of each, unless the folder is null. */
void report_files(const record *records, int count, const char *folder);

/* ---- what a picture's tier costs and gives, by resolution and distance of the camera ---- */

enum { SIZES = 6 };

/* A size of picture from a distance, in radii of the extent. */
typedef struct picture_size {
    int width, height;
    double distance;
} picture_size;

typedef struct picture_record {
    const catalogue_entry *entry;
    int sizes;
    const picture_size *size;
    measure_takes takes[SIZES][TIERS]; /* CPU time of the picture */
} picture_record;

/* Draws the surface, fewer sizes if quick.  Ends the program when that cannot be had, and when the bounded
 * tier shows something else than the certified one where it decides. */
void pictures_run(const catalogue_entry *entry, int quick, int repeat, picture_record *r);

/* A table of each; accuracy_pictures.csv and accuracy_pictures.svg of all, unless the folder is null. */
void pictures_report(const picture_record *records, int count, const char *folder);

#endif
