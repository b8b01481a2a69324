/* seed_report.h - what seed measured, as tables on standard output and as files. */
#ifndef SEED_REPORT_H
#define SEED_REPORT_H
#include "seed_decic.h"
#include "seed_figures.h"

enum {
    SEED_SURFACES = 6,
    SEED_DECIC = SEED_SURFACES, /* the decic's place among results: its evaluations are counted too, but
                                   nothing is timed */
    SEED_COUNTED,               /* surfaces whose evaluations are counted */
    SEED_MOST_TIMES = 8
};

typedef struct seed_times {
    double seconds[SEED_MOST_TIMES]; /* sorted */
    size_t count;
} seed_times;

/* A method on a surface. */
typedef struct seed_cost {
    double evaluations; /* a bracket, mean */
    int evaluations_most;
    size_t wrong, wrong_pixels;
    seed_times refine, solve, picture; /* a bracket, a ray, a picture ray by ray (the library's only) */
} seed_cost;

typedef struct seed_result {
    const char *name;
    int degree;
    size_t rays, brackets, undecided;
    double width; /* of the brackets, geometric mean, in half chords */
    seed_cost cost[SEED_METHODS];
    seed_times idle[2];         /* a call with nothing left to refine: of the library, of a rival */
    seed_times isolation, bare; /* a ray; with nothing proved */
    size_t bare_wrong;          /* rays on which that lacks the bracket, or has one that is not there */
    seed_times packets;         /* a picture by the default method in packets */
} seed_result;

void seed_print(const seed_result *results, const seed_census *censuses, const seed_decic *decic);
void seed_write(const seed_result *results, const seed_census *censuses, const seed_decic *decic,
                const char *folder);

#endif
