/* glue_nothing.c - why a picture is empty: the surface has no real point, or none in the extent.
 *
 * Real points are sought in four boxes that cover space and what is infinitely far: in coordinates of which
 * none is above 1, and, with P made homogeneous by a fourth variable, in those three charts in which x, y or
 * z is 1.
 */
#include <stdlib.h>

#include "glue.h"

static int is_empty(const algsurf_surface *surface, const algsurf_extent *extent, algsurf_status *failed) {
    double lo[3], hi[3];
    int empty = 0;
    keep(failed, algsurf_surface_enclose(surface, extent, ALGSURF_PART_ALL, 1.0 / 16, lo, hi, &empty));
    return *failed == ALGSURF_OK && empty;
}

/* Are all terms, among them the constant one, above 0 wherever they are not 0, or all below? */
static int has_one_sign(const algsurf_term *terms, size_t count) {
    int has_constant = 0;
    for (size_t i = 0; i < count; i++) {
        const algsurf_term *t = &terms[i];
        if ((t->i | t->j | t->k) & 1 || (t->a > 0) != (terms[0].a > 0)) return 0;
        has_constant |= t->i + t->j + t->k == 0;
    }
    return has_constant;
}

/* Is the chart in which that one of x, y, z and the fourth variable is 1 empty? */
static int is_empty_chart(const algsurf_term *terms, size_t count, int degree, int chart,
                          algsurf_status *failed) {
    const algsurf_extent unit = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}};
    algsurf_term *seen = malloc((count + 1) * sizeof *seen);
    algsurf_surface *surface = NULL;
    if (!seen) keep(failed, ALGSURF_E_NO_MEMORY);
    for (size_t i = 0; i < count && *failed == ALGSURF_OK; i++) {
        const int last = degree - terms[i].i - terms[i].j - terms[i].k;
        seen[i] = terms[i];
        if (chart == 0) seen[i].i = last;
        if (chart == 1) seen[i].j = last;
        if (chart == 2) seen[i].k = last;
    }
    if (*failed == ALGSURF_OK) keep(failed, algsurf_surface_from_terms(seen, count, &surface));
    const int empty = *failed == ALGSURF_OK && is_empty(surface, &unit, failed);
    algsurf_surface_free(surface);
    free(seen);
    return empty;
}

static int is_nowhere(const algsurf_surface *surface, algsurf_status *failed) {
    const size_t count = algsurf_surface_term_count(surface);
    const int degree = algsurf_surface_degree(surface);
    algsurf_term *terms = malloc((count + 1) * sizeof *terms);
    if (degree % 2 != 0 || !terms) {
        free(terms);
        return 0;
    }
    keep(failed, algsurf_surface_terms(surface, terms));
    int nowhere = has_one_sign(terms, count);
    for (int chart = 0; !nowhere && is_empty_chart(terms, count, degree, chart, failed); chart++)
        nowhere = chart == 3;
    free(terms);
    return nowhere;
}

/* 2: the surface has no real point, its coefficients taken as they are rounded; 1: none in the extent;
 * 0: it may have some. */
EXPORTED(page_nothing) int page_nothing(const algsurf_surface *surface, const page_state *state) {
    const algsurf_extent extent = extent_of(state);
    algsurf_status failed = ALGSURF_OK;
    const int here = is_empty(surface, &extent, &failed), nowhere = here && is_nowhere(surface, &failed);
    return failed < 0 ? (int)failed : here + nowhere;
}
