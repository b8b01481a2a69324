/* zerofind_solve.c - see zerofind_solve.h.
 *
 * The roots are those of algsurf_intersect_all, each with its multiplicity.  A bracket of the first one, for
 * algsurf_refine_poly_observed to refine, comes from the chord's polynomial, whose coefficients are doubles
 * with radii: where the roots are closer than those tell, there is none.
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
    const chord *on = &z->chord;
    algsurf_bracket *b = &z->bracket;
    algsurf_refine_options options = {.size = sizeof options, .method = method};
    algsurf_refined_root root;
    int found = 0;
    algsurf_status status = algsurf_isolate_first(on->c, on->r, on->degree, -1, 1, b, &found);
    double s = chord_s(on, z->hits[0].t);
    z->bracketed =
        status == ALGSURF_OK && found && b->kind == ALGSURF_BRACKET_ISOLATED && b->lo <= s && s <= b->hi;
    if (!z->bracketed || algsurf_refine_poly(on->c, on->degree, b->lo, b->hi, NULL, &root) < ALGSURF_OK)
        return;
    z->root = root.root;
    options.tolerance = 0.5 * tolerance / on->half; /* half: the root is an end of its bracket */
    status = algsurf_refine_poly_observed(on->c, on->degree, b->lo, b->hi, &options, observe, z, &root);
    z->converged = status == ALGSURF_OK;
}

algsurf_status zerofind_solve(const algsurf_surface *surface, const algsurf_extent *extent,
                              const algsurf_ray *ray, const chord *on, algsurf_method method,
                              double tolerance, zerofind *result) {
    memset(result, 0, sizeof *result);
    result->chord = *on;
    algsurf_status status = algsurf_intersect_all(surface, extent, ray, NULL, result->hits,
                                                  ALGSURF_MAX_DEGREE + 1, &result->count);
    if (status == ALGSURF_OK && result->count > 0 && result->hits[0].state == ALGSURF_HIT)
        refine_first(result, method, tolerance);
    return status;
}
