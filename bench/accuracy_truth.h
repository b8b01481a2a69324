/* accuracy_truth.h - rays of a surface's view, and where each of them first meets it, proved. */
#ifndef ACCURACY_TRUTH_H
#define ACCURACY_TRUTH_H
#include "catalogue.h"

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

#endif
