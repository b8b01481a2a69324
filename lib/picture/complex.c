/* complex.c - one sample in complex space, its roots started from those of its neighbours.
 *
 * Spatial coherence (Sanjuan-Estrada, Casado, Garcia, section 3): neighbouring rays have nearly the same
 * roots, and an iteration that starts there takes fewer steps.  It saves time and must not show.  The
 * value of a simple root does not depend on the start: the approximation is corrected with doubled
 * precision, so that what is rounded to double agrees with the exact root to far more digits than are
 * kept.  What may depend on the start, how wide the box of a cluster is and so what remains uncertain, is
 * found again from the solver's own start values.
 *
 * A real polynomial with start values that are real, or come in conjugate pairs, keeps that symmetry
 * through the whole iteration, but where a ray passes a silhouette two real roots become a pair.
 * So start values are moved off it, all by the same small imaginary step.
 */
#include "../rays/intersect_impl.h"
#include "impl.h"

static const double OFF_AXIS = 1e-4; /* of the radius of what is shown: a fraction of a pixel */

/* Were all roots found, one by one?  What is missing is NaN, and comes last. */
static int all_found(const algsurf_complex *roots, int n) { return isfinite(roots[n - 1].re); }

/* Adds a neighbour's roots to the sums, if it has them. */
static int add_roots(algsurf_complex *sum, const algsurf_complex *roots, int n) {
    if (!all_found(roots, n)) return 0;
    for (int i = 0; i < n; i++) {
        sum[i].re += roots[i].re;
        sum[i].im += roots[i].im;
    }
    return 1;
}

/* Start values for pixel x, branch by branch the averages over its neighbours above left, above, above
 * right and left; returns 0 when none of them has roots. */
static int start_values(const algsurf_i_picture *picture, const algsurf_i_trail *trail, int x, int n,
                        algsurf_complex *start) {
    int count = 0;
    if (n == 0 || picture->scene->coherence == ALGSURF_COHERENCE_NONE) return 0;
    for (int i = 0; i < n; i++) start[i] = (algsurf_complex){0, 0};
    for (int k = x - 1; trail->has_above && k <= x + 1; k++)
        if (k >= 0 && k < picture->width) count += add_roots(start, trail->above + k * n, n);
    if (x > 0) count += add_roots(start, trail->row + (x - 1) * n, n);
    if (count == 0) return 0;
    for (int i = 0; i < n; i++) {
        start[i].re /= count;
        start[i].im = start[i].im / count + OFF_AXIS * picture->radius;
    }
    return 1;
}

void algsurf_i_trail_skip(const algsurf_i_picture *picture, int x, algsurf_i_trail *trail) {
    const int n = algsurf_surface_degree(picture->scene->surface);
    if (picture->scene->complex && n > 0) trail->row[x * n + n - 1].re = NAN; /* not all_found */
}

algsurf_status algsurf_i_render_complex(const algsurf_i_picture *picture, int x, const algsurf_ray *ray,
                                        algsurf_i_trail *trail, algsurf_hit *hit, algsurf_i_tally *tally) {
    const algsurf_scene *scene = picture->scene;
    const int n = algsurf_surface_degree(scene->surface);
    algsurf_complex start[ALGSURF_MAX_DEGREE], *roots = n > 0 ? trail->row + x * n : NULL;
    int warm = start_values(picture, trail, x, n, start), iterations;
    algsurf_status status = algsurf_i_intersect_complex(scene->surface, &scene->extent, ray, &scene->space,
                                                        warm ? start : NULL, roots, hit, NULL, &iterations);
    if (status < 0) return status;
    tally->iterations += (uint64_t)iterations;
    if (!warm || (all_found(roots, n) && hit->state != ALGSURF_UNCERTAIN)) return ALGSURF_OK;
    status = algsurf_i_intersect_complex(scene->surface, &scene->extent, ray, &scene->space, NULL, roots, hit,
                                         NULL, &iterations);
    tally->iterations += (uint64_t)iterations;
    return status;
}
