/* seed_figures.h - where simple methods fail, as plots: regula falsi that creeps, Newton's method that finds
 * another root. */
#ifndef SEED_FIGURES_H
#define SEED_FIGURES_H
#include "seed_rays.h"

enum { SEED_STEPS = 50 };

/* Newton's method without a bracket, from the middle of the bracket. */
typedef struct seed_newton {
    seed_ray ray;
    int degree;
    double x[SEED_STEPS + 1];
    int count; /* of points */
} seed_newton;

typedef struct seed_census {
    size_t roots, other, lost; /* it ends at another root; it has not settled after SEED_STEPS */
    seed_newton example;       /* it strays far, but not off the chord; count 0: none is like that */
} seed_census;

void seed_newton_census(const seed_view *view, seed_census *census);

/* The curve and the points on it. */
void seed_plot_newton(const seed_newton *newton, const char *surface, const char *folder, const char *name);

/* The curve, the points of regula falsi on it, and how fast each of the methods gets near the root. */
void seed_plot_creep(const seed_ray *ray, int degree, const char *surface, const char *folder,
                     const char *name);

#endif
