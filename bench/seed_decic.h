/* seed_decic.h - the Barth decic where regula falsi gives up: a table, three pictures. */
#ifndef SEED_DECIC_H
#define SEED_DECIC_H
#include "seed_rays.h"

enum { SEED_DECIC_ROWS = 4 };

/* Counts are of roots; errors are in half chords. */
typedef struct seed_decic_row {
    const char *method, *stop;
    double evaluations;                /* mean */
    size_t at_limit;                   /* the limit of iterations was reached */
    size_t off, wrong, visible, roots; /* off by more than the tolerance, ten of it, a pixel's width */
    double largest;                    /* error */
} seed_decic_row;

typedef struct seed_decic {
    seed_view view;
    seed_decic_row row[SEED_DECIC_ROWS];
    const seed_ray *slow; /* a ray on which plain regula falsi creeps: an example */
    double merit;         /* of that example */
} seed_decic;

/* Solves all rays of the picture, and draws it into the folder unless that is null.  Ends the program when
 * Brent's method misses a root. */
void seed_decic_run(seed_decic *decic, int width, int height, const char *folder);

#endif
