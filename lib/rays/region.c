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

/* As algsurf_i_region_chord, without planes. */
static int extent_chord(const algsurf_extent *extent, const algsurf_ray *ray, algsurf_i_chord *chord) {
    *chord = (algsurf_i_chord){ray->t_min, ray->t_max, -HUGE_VAL, HUGE_VAL};
    if (!extent || extent->kind == ALGSURF_EXTENT_ALL) return algsurf_i_has_points(chord->lo, chord->hi);
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
    chord->lo = fmax(ray->t_min, fmin(ends[0] / scale, DBL_MAX));
    chord->hi = fmin(ray->t_max, fmax(ends[1] / scale, -DBL_MAX));
    solid = solid && algsurf_i_line_clip(&inner, &line, ends);
    chord->inner_lo = solid ? fmax(ends[0] / scale, -DBL_MAX) : HUGE_VAL;
    chord->inner_hi = solid ? fmin(ends[1] / scale, DBL_MAX) : -HUGE_VAL;
    return algsurf_i_has_points(chord->lo, chord->hi);
}

int algsurf_i_region_chord(const algsurf_i_region *region, const algsurf_ray *ray, algsurf_i_chord *chord) {
    return extent_chord(region->extent, ray, chord) &&
           algsurf_i_planes_cut(region->planes, region->plane_count, ray, chord);
}

static algsurf_status clip(const algsurf_extent *extent, const algsurf_plane *planes, size_t count,
                           const algsurf_ray *ray, algsurf_ray *chord, int *meets) {
    const algsurf_i_region region = {extent, planes, count};
    algsurf_i_chord part;
    if (!chord || !meets) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_ray_check(ray);
    if (status == ALGSURF_OK) status = algsurf_i_extent_check(extent);
    if (status == ALGSURF_OK) status = algsurf_i_planes_check(planes, count);
    if (status != ALGSURF_OK) return status;
    *meets = algsurf_i_region_chord(&region, ray, &part);
    if (!*meets) return ALGSURF_OK;
    *chord = *ray;
    chord->t_min = part.lo;
    chord->t_max = part.hi;
    return ALGSURF_OK;
}

ALGSURF_I_PUBLIC(algsurf_status, region_clip, clip,
                 (const algsurf_extent *extent, const algsurf_plane *planes, size_t count,
                  const algsurf_ray *ray, algsurf_ray *chord, int *meets),
                 (extent, planes, count, ray, chord, meets))
