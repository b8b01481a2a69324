/* region.c - the chord of a ray in a region a little larger, and what of it is certainly inside.
 *
 * The chord in an extent is computed twice: in one that is larger by more than the clip's error, and in one
 * that is smaller by as much.  Then planes cut both (planes.c).
 *
 * How much is added, with M = |origin_i| + |centre_i| + size, of a ball the largest.  The extent is larger by
 * 2^-43 M.  The clip is off along the ray by less than 2^-47 of the way to the far side, which is below 2 M:
 * together less than the 2^-42 M that algsurf_region_clip promises.  Of planes, see planes.c.
 *
 * Lengths near the largest double are clipped as a 16th of themselves, and t with them: so an extent can
 * always be larger by its margin.  t then underflows by 2^-1070 at most, which is nothing beside such
 * margins. */
#include "../base/arithmetic.h"
#include "region.h"

#include <float.h>
#include <math.h>

#include "../base/fpenv.h"
#include "planes.h"
#include "ray_impl.h"
#include "../base/vec.h"

/* By how much to move the extent's surface along an axis, or the sphere's in all.  An extent larger by d is
 * entered earlier by d / |direction| or more, the sphere's radius and the box's half sizes alike; the clip is
 * off by less than 2^-47 of the distance from the origin to its far side, for a box along each axis by
 * itself, and t by 2^-1074 where it underflows.  d is 2^-43 of that, and more than what underflows. */
static double margin(const algsurf_extent *extent, const algsurf_ray *ray, int axis) {
    double size = extent->size[extent->kind == ALGSURF_EXTENT_BOX ? axis : 0];
    double far = fabs(ray->origin[axis]) + fabs(extent->centre[axis]) + size;
    return 0x1p-43 * far + 0x1p-1060 + 0x1p-1070 * fabs(ray->direction[axis]);
}

/* What the lengths of extent and origin are multiplied by, and both so: 1, or less where they are large. */
static double shrink(algsurf_extent *extent, algsurf_ray *ray) {
    double largest = fmax(algsurf_max_abs(ray->origin), algsurf_max_abs(extent->centre));
    largest = fmax(largest, extent->size[0]);
    if (extent->kind == ALGSURF_EXTENT_BOX) largest = fmax(largest, algsurf_max_abs(extent->size));
    double scale = largest > 0x1p1000 ? 0x1p-4 : 1;
    for (int i = 0; i < 3; i++) {
        extent->size[i] *= scale;
        extent->centre[i] *= scale;
        ray->origin[i] *= scale;
    }
    return scale;
}

static int extent_bracket(const algsurf_extent *extent, const algsurf_ray *ray, algsurf_ray *chord,
                          algsurf_i_edges *edges) {
    *edges = (algsurf_i_edges){0, -HUGE_VAL, HUGE_VAL};
    if (!extent || extent->kind == ALGSURF_EXTENT_ALL) return algsurf_i_extent_clip(extent, ray, chord);
    algsurf_extent outer = *extent;
    algsurf_ray line = *ray;
    const double scale = shrink(&outer, &line);
    algsurf_extent inner = outer;
    int box = extent->kind == ALGSURF_EXTENT_BOX, solid = 1;
    double d[3], ends[2];
    for (int i = 0; i < 3; i++) d[i] = margin(&outer, &line, i);
    if (!box) d[0] = fmax(d[0], fmax(d[1], d[2]));
    for (int i = 0; i < (box ? 3 : 1); i++) {
        outer.size[i] += d[i];
        inner.size[i] -= d[i];
        solid &= inner.size[i] > 0;
    }
    /* What overflowed is between the largest double and infinity. */
    if (!algsurf_i_line_clip(&outer, &line, ends)) return 0;
    *chord = *ray;
    chord->t_min = fmax(ray->t_min, fmin(ends[0] / scale, DBL_MAX));
    chord->t_max = fmin(ray->t_max, fmax(ends[1] / scale, -DBL_MAX));
    if (!algsurf_i_has_points(chord->t_min, chord->t_max)) return 0;
    edges->cut = 1;
    edges->inner_lo = HUGE_VAL;
    edges->inner_hi = -HUGE_VAL;
    if (solid && algsurf_i_line_clip(&inner, &line, ends)) {
        edges->inner_lo = fmax(ends[0] / scale, -DBL_MAX);
        edges->inner_hi = fmin(ends[1] / scale, DBL_MAX);
    }
    return 1;
}

int algsurf_i_region_bracket(const algsurf_i_region *region, const algsurf_ray *ray, algsurf_ray *chord,
                             algsurf_i_edges *edges) {
    if (!extent_bracket(region->extent, ray, chord, edges)) return 0;
    if (region->plane_count == 0) return 1;
    algsurf_i_cut cut = {chord->t_min, chord->t_max, edges->inner_lo, edges->inner_hi};
    if (!algsurf_i_planes_cut(region->planes, region->plane_count, ray, &cut)) return 0;
    chord->t_min = cut.outer_lo;
    chord->t_max = cut.outer_hi;
    *edges = (algsurf_i_edges){1, cut.inner_lo, cut.inner_hi};
    return 1;
}

static ALGSURF_NOINLINE algsurf_status checked_clip(const algsurf_i_region *region, const algsurf_ray *ray,
                                                    algsurf_ray *chord, int *meets) {
    algsurf_ray part;
    algsurf_i_edges edges;
    algsurf_status status = algsurf_i_ray_check(ray);
    if (status == ALGSURF_OK) status = algsurf_i_extent_check(region->extent);
    if (status == ALGSURF_OK) status = algsurf_i_planes_check(region->planes, region->plane_count);
    if (status != ALGSURF_OK) return status;
    *meets = algsurf_i_region_bracket(region, ray, &part, &edges);
    if (*meets) *chord = part;
    return ALGSURF_OK;
}

algsurf_status algsurf_region_clip(const algsurf_extent *extent, const algsurf_plane *planes, size_t count,
                                   const algsurf_ray *ray, algsurf_ray *chord, int *meets) {
    const algsurf_i_region region = {extent, planes, count};
    if (!chord || !meets) return ALGSURF_E_ARGUMENT;
    algsurf_status status;
    ALGSURF_STANDARD(status = checked_clip(&region, ray, chord, meets));
    return status;
}
