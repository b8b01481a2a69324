/* ranges.c - the polynomials along a ray of all surfaces within an error, as one with radii.
 *
 * A coefficient a is known to error |a|.  Along X + u D, in integers, p_k is then known to the coefficient of
 * u^k of the form of the terms error |a|, along |X| + u |D|: all of its summands are the magnitudes of those
 * of p_k. Both forms get the same power of two, and exact_radii.c finds where the set has roots.  What lies
 * within the rounding of the chord's ends is undecided: it may be inside the region or not.  An end that is
 * infinite has no rounding: roots beyond the largest double count like all others. */
#include "../base/arithmetic.h"
#include "ranges.h"

#include <math.h>
#include <stdlib.h>

#include "../roots/exact_radii.h"
#include "../surface/exact_form.h"
#include "exact_ray.h"
#include "region.h"

enum { STACK_WORDS = 2048 };

/* The terms as error |a|, rounded up; to be freed. */
static algsurf_term *magnitudes(const algsurf_surface *s) {
    algsurf_term *terms = malloc(s->term_count * sizeof *terms);
    for (size_t m = 0; terms && m < s->term_count; m++) {
        terms[m] = s->terms[m];
        terms[m].a = nextafter(s->error * fabs(terms[m].a), HUGE_VAL);
    }
    return terms;
}

/* p 2^(to - from), to >= from, in room of its own. */
static int scaled(algsurf_memory *m, const algsurf_zpoly *p, int up, algsurf_zpoly *q) {
    if (p->degree < 0 || up == 0) {
        *q = *p;
        return 1;
    }
    if (!algsurf_zpoly_copy(m, p, algsurf_z_width(algsurf_zpoly_bits(p) + up), q)) return 0;
    for (int k = 0; k <= q->degree; k++) algsurf_z_shift_up(algsurf_zpoly_at(q, k), q->width, up);
    return 1;
}

/* p and its radii in one unit. */
static int make_forms(algsurf_memory *m, const algsurf_surface *s, const algsurf_term *spread,
                      const algsurf_ray *ray, int unit, algsurf_zpoly *p, algsurf_zpoly *radius) {
    algsurf_surface wide = *s;
    double o[3], d[3];
    int scale, radius_scale;
    for (int i = 0; i < 3; i++) {
        o[i] = fabs(ray->origin[i]);
        d[i] = fabs(ray->direction[i]);
    }
    wide.terms = (algsurf_term *)spread;
    if (!algsurf_i_exact_form(m, s, ray->origin, ray->direction, unit, p, &scale) ||
        !algsurf_i_exact_form(m, &wide, o, d, unit, radius, &radius_scale))
        return 0;
    if (p->degree < 0) scale = radius_scale;
    int common = scale > radius_scale ? scale : radius_scale;
    return scaled(m, p, common - scale, p) && scaled(m, radius, common - radius_scale, radius);
}

static algsurf_status isolate(algsurf_memory *m, const algsurf_surface *s, const algsurf_term *spread,
                              const algsurf_ray *ray, const algsurf_ray *chord, const algsurf_i_edges *edges,
                              algsurf_observer *observer, algsurf_i_ray_range *ranges, int *count) {
    const algsurf_i_watch watch = {.observer = observer};
    double lo = chord->t_min, hi = chord->t_max;
    int unit = algsurf_i_exact_unit(s, ray, lo, hi), found = 0;
    algsurf_zpoly p, radius;
    algsurf_exact_range range[ALGSURF_MAX_DEGREE];
    if (!make_forms(m, s, spread, ray, unit, &p, &radius) ||
        !algsurf_exact_radii_isolate(m, &p, &radius, unit, lo, hi, range, ALGSURF_MAX_DEGREE, &found,
                                     observer ? &watch : NULL))
        return ALGSURF_E_NO_MEMORY;
    for (int i = 0; i < found; i++) {
        int inside = !edges->cut || (range[i].lo >= edges->inner_lo && range[i].hi <= edges->inner_hi);
        int at_end = (isfinite(lo) && range[i].lo <= lo) || (isfinite(hi) && range[i].hi >= hi);
        algsurf_status reason = lo == hi            ? ALGSURF_UNDECIDED_ZERO
                                : !inside || at_end ? ALGSURF_UNDECIDED_END
                                                    : ALGSURF_UNDECIDED_MULTIPLE;
        ranges[i] = (algsurf_i_ray_range){range[i].lo, range[i].hi, inside ? range[i].sign_lo : 0, reason};
    }
    *count = found;
    return ALGSURF_OK;
}

algsurf_status algsurf_i_exact_ranges(const algsurf_surface *surface, const algsurf_i_region *region,
                                      const algsurf_ray *ray, size_t limit, algsurf_observer *observer,
                                      algsurf_i_ray_range ranges[ALGSURF_MAX_DEGREE], int *count) {
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_ray chord;
    algsurf_i_edges edges;
    *count = 0;
    if (!algsurf_i_region_bracket(region, ray, &chord, &edges)) return ALGSURF_OK;
    algsurf_term *spread = magnitudes(surface);
    if (!spread) return ALGSURF_E_NO_MEMORY;
    algsurf_memory_begin(&memory, block, STACK_WORDS, limit);
    algsurf_memory_mark begin = algsurf_memory_here(&memory);
    algsurf_status status = isolate(&memory, surface, spread, ray, &chord, &edges, observer, ranges, count);
    algsurf_memory_release(&memory, begin);
    free(spread);
    return status;
}
