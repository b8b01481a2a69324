/* zerofind_solve.c - see zerofind_solve.h.
 *
 * Brackets are those of algsurf_intersect_all in its certified tier: where double cannot tell, they are found
 * in better arithmetic.  The first one is handed to algsurf_refine_poly_observed with the chord's polynomial,
 * which is how a single ray is refined.
 */
#include "zerofind_solve.h"

#include <string.h>

static void observe(double s, double value, void *data) {
    zerofind *z = data;
    if (z->point_count >= ZEROFIND_MOST_POINTS) return;
    zerofind_point p = {s, value, s, s};
    const zerofind_point *ends = z->points, *before = z->points + z->point_count - 1;
    if (z->point_count > 0 && value != 0) {
        int left = z->point_count > 1 && (value > 0) == (ends[0].value > 0);
        p.s_lo = left ? s : before->s_lo;
        p.s_hi = left ? before->s_hi : s;
    }
    z->points[z->point_count++] = p;
}

static void refine_first(zerofind *z, algsurf_method method, double tolerance) {
    const algsurf_hit *first = &z->hits[0];
    const chord *on = &z->chord;
    double lo = chord_s(on, first->t_lo), hi = chord_s(on, first->t_hi);
    algsurf_refine_options options = {.size = sizeof options, .method = method};
    algsurf_root root;
    if (first->state != ALGSURF_HIT || !(lo < hi)) return;
    if (algsurf_refine_poly(on->c, on->degree, lo, hi, NULL, &root) < ALGSURF_OK) return;
    z->root = root.root;
    options.tolerance = 0.5 * tolerance / on->half; /* half: the root is an end of its bracket */
    algsurf_status status =
        algsurf_refine_poly_observed(on->c, on->degree, lo, hi, &options, observe, z, &root);
    z->converged = status == ALGSURF_OK;
}

algsurf_status zerofind_solve(const algsurf_surface *surface, const algsurf_extent *extent,
                              const algsurf_ray *ray, const chord *on, algsurf_method method,
                              double tolerance, zerofind *result) {
    memset(result, 0, sizeof *result);
    result->chord = *on;
    algsurf_intersect_options how = {.size = sizeof how, .tier = ALGSURF_TIER_CERTIFIED};
    algsurf_status status = algsurf_intersect_all(surface, extent, ray, &how, result->hits,
                                                  ALGSURF_MAX_DEGREE + 1, &result->count);
    if (status == ALGSURF_OK && result->count > 0) refine_first(result, method, tolerance);
    return status;
}
