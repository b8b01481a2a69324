/* ray.c - the chord of a ray in an extent a little larger, and what of it is certainly inside (planes cut it
 * in planes.c).
 *
 * Sphere.  Let q = origin - centre and t_c a double near -(q.d)/(d.d), the parameter of the ray's point
 * nearest to the centre.  With X = q + t_c d the ray is X + s d, t = t_c + s, and
 *     |X + s d|^2 = r^2   <=>   s = (-X.d +- sqrt(D)) / d.d,   D = d.d r^2 - |X x d|^2
 * (Lagrange's identity in place of (X.d)^2 - d.d (|X|^2 - r^2), which would cancel more often).
 *
 * Box: slabs (Kay, Kajiya 1986), (+-h - q)/d.
 *
 * Margins.  The chord is computed twice: in an extent that is larger by m, more than what rounding can do,
 * and in one that is smaller by as much.  m is 2^-43 M, M = |origin_i| + |centre_i| + size along the axis, of
 * a ball the largest; so |q| + r <= 2 M.
 *
 * Between two spheres, r' = r + m, a ray is at least m long:
 *     sqrt(D') - sqrt(D) >= (D' - D) / (|d| (r' + r)),   D' - D = d.d (r' + r) m.
 * X is off by 6 u |q|: q, the product and the sum round once in each coordinate.  For a line that passes
 * within 2 r', where |X| <= 2 r', D' is off by
 *     d.d u (2 |X| (6 |q| + 4 |X|) + 3 |X|^2 + 4 r'^2) <= 100 u d.d r' M < 2^-46 d.d r' M,
 * an eighth of d.d (r' + r) m: 7/8 m are left.  What rounds in X.d, d.d, the root, the quotient and the last
 * sum takes 60 u M of that, below m/16.  So the outer chord holds the ray's part in the extent, and points of
 * it leave that by 9/8 m + 60 u M at most, less than the 2^-42 M that algsurf_ray_clip promises.  No other
 * line has D' >= 0 as computed: p^2 - r'^2 >= 3/4 p^2 for its distance p, which is above 2 m.  The inner
 * chord likewise.
 *
 * In a box q and h - q are off by 2 u M together, far below m.  What underflows in t, or in lengths beside 1,
 * is below the further terms of m.
 *
 * Scaling.  d and the lengths are brought to about 1 by powers of two of their own; lengths are halved first,
 * so that origin - centre cannot overflow.
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

algsurf_status algsurf_i_ray_check(const algsurf_ray *ray) {
    if (!ray) return ALGSURF_E_ARGUMENT;
    if (isnan(ray->t_min) || isnan(ray->t_max)) return ALGSURF_E_NOT_FINITE;
    if (!algsurf_is_finite3(ray->origin) || !algsurf_is_finite3(ray->direction)) return ALGSURF_E_NOT_FINITE;
    return algsurf_max_abs(ray->direction) > 0 ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

double algsurf_i_coordinate_at(const algsurf_ray *ray, int axis, double t) {
    return fmin(fmax(algsurf_multiply_add(t, ray->direction[axis], ray->origin[axis]), -DBL_MAX), DBL_MAX);
}

algsurf_status algsurf_i_extent_check(const algsurf_extent *extent) {
    int sizes;
    if (!extent || extent->kind == ALGSURF_EXTENT_ALL) return ALGSURF_OK;
    if (extent->kind == ALGSURF_EXTENT_SPHERE)
        sizes = 1;
    else if (extent->kind == ALGSURF_EXTENT_BOX)
        sizes = 3;
    else
        return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(extent->centre)) return ALGSURF_E_NOT_FINITE;
    for (int i = 0; i < sizes; i++) {
        if (!isfinite(extent->size[i])) return ALGSURF_E_NOT_FINITE;
        if (!(extent->size[i] > 0)) return ALGSURF_E_ARGUMENT;
    }
    return ALGSURF_OK;
}

static int clip_sphere(const algsurf_extent *extent, const algsurf_ray *ray, double ends[2]) {
    double q[3], d[3], x[3], length = 0.5 * extent->size[0];
    for (int i = 0; i < 3; i++) {
        q[i] = 0.5 * ray->origin[i] - 0.5 * extent->centre[i];
        length = fmax(length, fabs(q[i]));
    }
    int ed = algsurf_scale_exponent(algsurf_max_abs(ray->direction)), eq = algsurf_scale_exponent(length);
    double scale_d = ldexp(1.0, -ed), scale_q = ldexp(1.0, -eq);
    for (int i = 0; i < 3; i++) {
        d[i] = scale_d * ray->direction[i];
        q[i] *= scale_q;
    }
    const double r = scale_q * extent->size[0] * 0.5, dd = algsurf_dot(d, d), t_c = -algsurf_dot(q, d) / dd;
    for (int i = 0; i < 3; i++) x[i] = q[i] + t_c * d[i];
    double c[3] = {x[1] * d[2] - x[2] * d[1], x[2] * d[0] - x[0] * d[2], x[0] * d[1] - x[1] * d[0]};
    double discriminant = dd * r * r - algsurf_dot(c, c);
    if (discriminant < 0) return 0;
    double b = -algsurf_dot(x, d), root = sqrt(discriminant);
    ends[0] = ldexp(t_c + (b - root) / dd, eq - ed + 1);
    ends[1] = ldexp(t_c + (b + root) / dd, eq - ed + 1);
    return 1;
}

static int clip_box(const algsurf_extent *extent, const algsurf_ray *ray, double ends[2]) {
    ends[0] = -INFINITY;
    ends[1] = INFINITY;
    for (int i = 0; i < 3; i++) {
        double d = ray->direction[i], h = 0.25 * extent->size[i];
        double q = 0.25 * ray->origin[i] - 0.25 * extent->centre[i], below = -(q + h), above = h - q;
        if (d == 0) { /* parallel to the faces: inside the slab for ever, or never */
            if (below > 0 || above < 0) return 0;
            continue;
        }
        double near = (d > 0 ? below : above) / d, far = (d > 0 ? above : below) / d;
        ends[0] = fmax(ends[0], 4.0 * near);
        ends[1] = fmin(ends[1], 4.0 * far);
    }
    return 1;
}

/* Where the line of a ray enters and leaves a ball or box; infinite also where that is beyond the largest
 * double.  Returns 0 when it does not meet it, as computed. */
static int clip_line(const algsurf_extent *extent, const algsurf_ray *ray, double ends[2]) {
    return extent->kind == ALGSURF_EXTENT_BOX ? clip_box(extent, ray, ends) : clip_sphere(extent, ray, ends);
}

/* By how much to move the extent's surface along an axis, or the sphere's in all. */
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
    if (!clip_line(&outer, &line, ends)) return 0;
    chord->lo = fmax(ray->t_min, fmin(ends[0] / scale, DBL_MAX));
    chord->hi = fmin(ray->t_max, fmax(ends[1] / scale, -DBL_MAX));
    solid = solid && clip_line(&inner, &line, ends);
    chord->inner_lo = solid ? fmax(ends[0] / scale, -DBL_MAX) : HUGE_VAL;
    chord->inner_hi = solid ? fmin(ends[1] / scale, DBL_MAX) : -HUGE_VAL;
    return algsurf_i_has_points(chord->lo, chord->hi);
}

int algsurf_i_region_chord(const algsurf_i_region *region, const algsurf_ray *ray, algsurf_i_chord *chord) {
    return extent_chord(region->extent, ray, chord) &&
           algsurf_i_planes_cut(region->planes, region->plane_count, ray, chord);
}

ALGSURF_I_ENTRY(algsurf_status, ray_clip,
                (const algsurf_ray *ray, const algsurf_extent *extent, const algsurf_plane *planes,
                 size_t count, algsurf_ray *chord, int *meets),
                (ray, extent, planes, count, chord, meets)) {
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
