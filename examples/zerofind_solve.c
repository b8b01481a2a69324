/* zerofind_solve.c - see zerofind_solve.h.
 *
 * The roots are those of algsurf_intersect_all, each with its multiplicity.  Cells and points are what an
 * observer of algsurf_intersect_first is told.
 */
#include "zerofind_solve.h"

#include <string.h>

static void take_cell(const algsurf_cell *cell, void *data) {
    zerofind *z = data;
    if (z->cell_count >= ZEROFIND_MOST_CELLS) return;
    zerofind_cell *c = z->cells + z->cell_count++;
    *c = (zerofind_cell){cell->lo, cell->hi, cell->variations, cell->engine, ""};
    for (int j = 0; cell->signs && j <= cell->degree; j++) c->signs[j] = "-0+?"[cell->signs[j] + 1];
}

static void take_point(double t, double value, int engine, void *data) {
    zerofind *z = data;
    if (z->point_count >= ZEROFIND_MOST_POINTS) return;
    z->points[z->point_count++] = (zerofind_point){.t = t, .value = value, .engine = engine};
}

/* The last cell with one root that holds the first hit. */
static const zerofind_cell *find_bracket(const zerofind *z) {
    double t = z->hits[0].t;
    for (const zerofind_cell *c = z->cells + z->cell_count; c-- > z->cells;)
        if (c->variations == 1 && c->t_lo <= t && t <= c->t_hi) return c;
    return NULL;
}

/* The brackets that signs leave, point by point.  Of a multiple root's polynomial the integers evaluate the
 * squarefree part: the chord's own values are shown instead. */
static void follow_points(zerofind *z) {
    const algsurf_hit *hit = z->hits;
    double lo = z->bracket ? z->bracket->t_lo : hit->t_lo, hi = z->bracket ? z->bracket->t_hi : hit->t_hi;
    for (zerofind_point *p = z->points; p < z->points + z->point_count; p++) {
        double bound;
        p->is_end = z->bracket && (p->t == z->bracket->t_lo || p->t == z->bracket->t_hi);
        if (lo < p->t && p->t < hi) {
            int left = p->value != 0 && (p->value > 0) == (hit->side > 0), right = p->value != 0 && !left;
            lo = right ? lo : p->t;
            hi = left ? hi : p->t;
        }
        p->t_lo = lo;
        p->t_hi = hi;
        if (hit->multiplicity > 1)
            (void)algsurf_poly_value_compensated(z->chord.c, NULL, z->chord.degree, chord_s(&z->chord, p->t),
                                                 &p->value, &bound);
    }
}

algsurf_status zerofind_solve(const algsurf_surface *surface, const algsurf_extent *extent,
                              const algsurf_ray *ray, const chord *on, const algsurf_intersect_options *how,
                              zerofind *result) {
    algsurf_observer observer = {
        .size = sizeof observer, .data = result, .on_cell = take_cell, .on_point = take_point};
    const algsurf_intersect_options all = {
        .size = sizeof all, .planes = how->planes, .plane_count = how->plane_count};
    algsurf_intersect_options options = *how;
    options.observer = &observer;
    algsurf_hit first;
    memset(result, 0, sizeof *result);
    result->chord = *on;
    algsurf_status status = algsurf_intersect_all(surface, extent, ray, &all, result->hits,
                                                  ALGSURF_MAX_DEGREE + 1, &result->count);
    if (status == ALGSURF_OK) status = algsurf_intersect_first(surface, extent, ray, &options, &first);
    if (status != ALGSURF_OK || result->count == 0 || result->hits[0].state != ALGSURF_STATE_HIT)
        return status;
    result->bracket = find_bracket(result);
    follow_points(result);
    return ALGSURF_OK;
}
