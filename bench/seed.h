/* seed.h - what the parts of the benchmark seed share. */
#ifndef SEED_H
#define SEED_H
#include "catalogue.h"
#include "measure.h"

/* ---- ways from a bracket to a root: the library's, and rivals that are no part of it ---- */

/* As algsurf_refine_poly without radii, whose arguments a rival takes for granted: a bracket with different
 * signs at its finite ends, and options. */
typedef algsurf_status seed_solver(const double *c, int degree, double lo, double hi,
                                   const algsurf_refine_options *options, algsurf_refined_root *result);

typedef struct seed_method {
    const char *name;
    seed_solver *solve;
    int method;   /* for the library's */
    int library;  /* else a rival */
    int may_fail; /* its stopping rule cannot tell near from slow: its wrong roots are counted */
} seed_method;

enum { SEED_BISECTION, SEED_REGULA_FALSI, SEED_BRENT, SEED_DEFAULT, SEED_OWN, SEED_METHODS = 7 };

/* SEED_OWN of the library, then the rivals. */
extern const seed_method seed_methods[SEED_METHODS];

/* One of them, with a wanted half width and at most so many iterations. */
algsurf_status seed_solve(const seed_method *method, const double *c, int degree, double lo, double hi,
                          double tolerance, int most, algsurf_refined_root *result);

/* Plain false position that does not stop where it only hardly moves: at the limit of iterations, at
 * |p| <= small, or when the bracket is as narrow as is wanted, which as a rule it never is. */
algsurf_status seed_false_position(const double *c, int degree, double lo, double hi, double tolerance,
                                   double small, int most, algsurf_refined_root *result);

/* p, and its derivative if slope is not null. */
double seed_value(const double *c, int degree, double x, double *slope);

/* ---- the rays of a picture as polynomials, the bracket of each one's first root, and that root ---- */

enum { SEED_DEGREE = 10 };

/* A ray through the middle of a pixel that meets the extent; p is the surface along it, in units of half its
 * chord from the chord's middle: in [-1,1]. */
typedef struct seed_ray {
    double c[SEED_DEGREE + 1];
    int pixel;
    int bracketed;       /* 0: no root, a root met exactly, or one undecided; what follows is then not set */
    double lo, hi;       /* isolates the first root: verified */
    double root, radius; /* the first root lies within radius of root: verified */
} seed_ray;

typedef struct seed_view {
    const catalogue_entry *entry;
    int width, height;
    algsurf_surface *surface;
    algsurf_camera camera;
    seed_ray *rays;
    size_t count, bracketed, undecided;
} seed_view;

/* A surface of the catalogue, seen as it says.  Ends the program when that cannot be had. */
void seed_open(seed_view *view, const char *name, int width, int height);
void seed_close(seed_view *view);

/* The part inside the extent of the ray through the middle of a pixel; 0 when there is none. */
int seed_chord(const seed_view *view, int pixel, algsurf_ray *chord);

/* How far from the true root a method's may be that works: its bracket's final width, what is known of the
 * root, and the rounding error of p there. */
double seed_allowed(const seed_view *view, const seed_ray *ray, double tolerance);

/* Of a polynomial's roots in [-1,1], the first: returns 1 and a bracket with different signs at its ends, or
 * 0: none seen.  Rounding is disregarded, and so are roots closer together than some 2^-40. */
int seed_bare_isolate(const double *c, int degree, double *lo, double *hi);

/* ---- whole pictures by each of the library's methods, judged and timed ---- */

/* A view as the library's renderer shows it, and where a proof has the surface. */
typedef struct seed_easel {
    const seed_view *view;
    algsurf_scene *scene;
    uint8_t *pixels;
    double *hits, *truth;
} seed_easel;

void seed_easel_open(seed_easel *easel, const seed_view *view);
void seed_easel_close(seed_easel *easel);

/* Draws with all processors.  Returns the CPU seconds; in packets: as the library does by itself with its
 * default method, else ray by ray.  *wrong: pixels whose hit is not where the surface is, or that have none
 * or one too many; ends the program if the method is one that may not fail. */
double seed_draw(seed_easel *easel, const seed_method *method, double tolerance, int packets, size_t *wrong);

/* ---- the Barth decic where regula falsi gives up: a table, three pictures ---- */

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

/* ---- where simple methods fail, as plots: regula falsi creeps, Newton's method finds another root ---- */

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

/* ---- what was measured ---- */

enum {
    SEED_SURFACES = 6,
    SEED_DECIC = SEED_SURFACES, /* the decic's place among results: its evaluations are counted too, but
                                   nothing is timed */
    SEED_COUNTED                /* surfaces whose evaluations are counted */
};

/* A method on a surface. */
typedef struct seed_cost {
    double evaluations; /* a bracket, mean */
    int evaluations_most;
    size_t wrong, wrong_pixels;
    measure_takes refine, solve, picture; /* a bracket, a ray, a picture ray by ray (the library's only) */
} seed_cost;

typedef struct seed_result {
    const char *name;
    int degree;
    size_t rays, brackets, undecided;
    double width; /* of the brackets, geometric mean, in half chords */
    seed_cost cost[SEED_METHODS];
    measure_takes idle[2];         /* a call with nothing left to refine: of the library, of a rival */
    measure_takes isolation, bare; /* a ray; with nothing proved */
    size_t bare_wrong;             /* rays on which that lacks the bracket, or has one that is not there */
    measure_takes packets;         /* a picture by the default method in packets */
} seed_result;

/* Tables on standard output; files, unless the folder is null. */
void seed_report(const seed_result *results, const seed_census *censuses, const seed_decic *decic,
                 const char *folder);

#endif
