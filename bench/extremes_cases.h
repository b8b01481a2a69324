/* extremes_cases.h - rays and surfaces at the edges of what doubles can say, in sweeps towards each edge.
 *
 * Used by the benchmark `extremes` and by the test of the same name, which judges them with exact arithmetic.
 */
#ifndef EXTREMES_CASES_H
#define EXTREMES_CASES_H
#include "algsurf/algsurf.h"
#include "measure.h"

/* A surface inside an extent, and rays: those of a packet.  The doubles are exact. */
typedef struct scene {
    algsurf_surface *surface;
    algsurf_term *terms;
    size_t term_count;
    algsurf_extent extent;
    size_t count;
    double *origin[3], *direction[3], *t_min, *t_max;
    unsigned char *expected; /* an algsurf_hit_state that is known from how the ray was made; UNDECIDED: it
                                is not */
} scene;

typedef struct sweep {
    const char *name, *title, *quantity; /* quantity: what is swept, and its unit */
    const double *values;
    int points, variants; /* scenes for each value */
    int (*make)(int variant, double value, measure_random *random, scene *s);
} sweep;

enum { SWEEPS = 8 };
extern const sweep sweeps[SWEEPS];

/* The scene of one value and variant, with `count` rays; the same for the same arguments.  Returns 0 when
 * there is no memory.  To be freed in any case. */
int scene_make(const sweep *from, int point, int variant, size_t count, int seed, scene *s);
void scene_free(scene *s);

algsurf_ray scene_ray(const scene *s, size_t i);

#endif
