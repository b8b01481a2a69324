/* chord_template.h - LANES rays as they are solved, and their chords inside the extent, as planes cut them.
 *
 * Everything is in natural units, and directions are divided by a power of two, so that their largest
 * component is in [1,2): rays and surfaces of any size are alike.  The caller's t is t_unit times ours.
 *
 * Scaling of t.  A t_min or t_max that underflows is off by 2^-1074, which changes P by less than
 * LOST_BY_UNDERFLOW; one that overflows is beyond all chords.  On the way out underflow moves t_lo and t_hi
 * by 2^-1074, less than 2^-100 h where LEAST_CHORD holds.  Both have room for that: a bracket's ends 2^-52 h,
 * and where signs of P show them, such a move is 2^-70 of the magnitudes there at most, which changes P by
 * far less than the 5 u S that its error has to spare (hits_template.h, narrow).
 *
 * Range.  With reach^n <= 2^280, n <= 64 and fewer than 2^16 terms, P's scheme on magnitudes is below 2^296.
 * An underflow changes a number by 2^-1074, is multiplied by 2^280 and the entries of a change of basis,
 * below 2^12, at most, and there are fewer than 2^22 of them: LOST_BY_UNDERFLOW is more. */
#ifndef ALGSURF_CHORD_TEMPLATE_H
#define ALGSURF_CHORD_TEMPLATE_H
#include "../roots/descartes_template.h"
#include "../simd/lanes.h"
#include "packets.h"

#define LOST_BY_UNDERFLOW 0x1p-550
#define FARTHEST 0x1p100    /* origin, in natural units */
#define LEAST_UNIT 0x1p-800 /* of the caller's t: ours is below 2^141, so no t overflows */
#define MOST_UNIT 0x1p800
#define LEAST_CHORD 0x1p-900   /* half of it, in the caller's t */
#define FARTHEST_ORIGIN 0x1p40 /* in radii of the extent: beyond, double-double is not enough */

/* LANES rays in natural units. */
typedef struct ray_lanes {
    lanes origin[3], direction[3];
    double unit;     /* the natural one in the caller's */
    lanes t_unit;    /* the caller's t where ours is 1, a power of two */
    lanes near, far; /* ends of the chord */
    lanes off;       /* how far another computation may place them */
    mask open, undecided;
} ray_lanes;

/* x + low + t d, rounded once but for a part 2^-100 of the terms. */
INLINE lanes along(lanes x, lanes low, lanes t, lanes d) {
    lanes product_low, sum_low, sum = exact_sum(exact_product(t, d, &product_low), x, &sum_low);
    return sum + (sum_low + (product_low + low));
}

/* Rays that are solved together, and where they are in the job's arrays: side by side, or listed, and then
 * copied. */
typedef struct places {
    int count, listed;
    size_t ray[LANES];
    double copy[8][LANES]; /* origin, direction, t_min, t_max */
} places;

INLINE void set_places(places *w, size_t first, size_t count) {
    w->listed = 0;
    w->count = count < LANES ? (int)count : LANES;
    for (int l = 0; l < LANES; l++) w->ray[l] = first + (size_t)l;
}

INLINE const double *number_of(const double *all, const places *w, int which) {
    return w->listed ? w->copy[which] : all + w->ray[0];
}

/* The coordinates that change along lane l, as bits; by the caller's direction: a component that has
 * underflown since is none that does not change. */
INLINE int changing(const algsurf_i_rays_job *job, const places *w, int l) {
    int which = 0;
    for (int i = 0; i < 3; i++) which |= (number_of(job->rays->direction[i], w, 3 + i)[l] != 0) << i;
    return which;
}

INLINE lanes load_number(const double *all, const places *w, int which) {
    return load_some(number_of(all, w, which), w->count);
}

/* Of the lanes that have a ray, those whose byte is not 0. */
INLINE mask active_lanes(const unsigned char *active, int count) {
    double on[LANES];
    for (int l = 0; l < LANES; l++) on[l] = l < count && (!active || active[l]);
    return less(all_lanes(0), load(on));
}

INLINE void load_rays(const algsurf_i_rays_job *job, const places *w, double scale, ray_lanes *r) {
    for (int i = 0; i < 3; i++) {
        r->origin[i] = scale * load_number(job->rays->origin[i], w, i);
        r->direction[i] = load_number(job->rays->direction[i], w, 3 + i);
    }
    lanes shrink = scale_of(r->direction);
    for (int i = 0; i < 3; i++) r->direction[i] *= shrink;
    r->unit = 1 / scale;
    r->t_unit = shrink * r->unit;
    lanes inverse = (lanes)(0x7fe0000000000000u - (words)r->t_unit);
    mask plain = less(all_lanes(LEAST_UNIT), r->t_unit) & less(r->t_unit, all_lanes(MOST_UNIT));
    plain &= less(largest_size(r->origin), all_lanes(FARTHEST));
    r->near = job->rays->t_min ? inverse * load_number(job->rays->t_min, w, 6) : all_lanes(0);
    r->far = job->rays->t_max ? inverse * load_number(job->rays->t_max, w, 7) : all_lanes(HUGE_VAL);
    r->off = all_lanes(0);
    r->open = active_lanes(job->rays->active && !w->listed ? job->rays->active + w->ray[0] : NULL, w->count);
    r->undecided = r->open & ~plain;
    r->open &= plain;
}

/* Cuts off what is outside of [near, far]. */
INLINE void keep_chord(ray_lanes *r, lanes near, lanes far, lanes off) {
    r->near = larger(near, r->near);
    r->far = smaller(far, r->far);
    r->off = off;
}

/* About the line's point x nearest to the centre, as in ray.c.  The discriminant is off by less than
 * 2^-48 of size; half of that over its root, and 2^-49 of the other terms, is the error of the ends. */
INLINE void clip_to_sphere(ray_lanes *r, const double centre[3], double radius) {
    lanes q[3], low[3], x[3];
    const lanes *d = r->direction;
    for (int i = 0; i < 3; i++) q[i] = exact_sum(r->origin[i], all_lanes(-centre[i]), &low[i]);
    lanes square = dot(d, d), t = -dot(q, d) / square;
    for (int i = 0; i < 3; i++) x[i] = along(q[i], low[i], t, d[i]);
    lanes c[3] = {x[1] * d[2] - x[2] * d[1], x[2] * d[0] - x[0] * d[2], x[0] * d[1] - x[1] * d[0]};
    lanes reach = square * (radius * radius), inside = reach - dot(c, c);
    lanes size = reach + square * dot(x, x);
    mask misses = less(inside, -0x1p-48 * size);
    r->undecided |= r->open & ~less(largest_size(q), all_lanes(FARTHEST_ORIGIN * radius));
    r->open &= ~(misses | r->undecided);
    lanes half = root(larger(inside, all_lanes(0))), b = -dot(x, d); /* 0: then off is infinite */
    lanes off = 0x1p-49 * (absolute(t) + half / square) + 0x1p-47 * size / (half * square);
    keep_chord(r, t + (b - half) / square, t + (b + half) / square, off);
}

INLINE void clip_to_box(ray_lanes *r, const double centre[3], const double size[3]) {
    lanes near = all_lanes(-HUGE_VAL), far = all_lanes(HUGE_VAL), low;
    for (int i = 0; i < 3; i++) {
        lanes q = exact_sum(r->origin[i], all_lanes(-centre[i]), &low), d = r->direction[i];
        lanes one = ((-size[i] - q) - low) / d, two = ((size[i] - q) - low) / d;
        mask parallel = at_most(absolute(d), all_lanes(0));
        mask in = less(absolute(q), all_lanes(size[i] * (1 - 0x1p-50)));
        mask out = less(all_lanes(size[i] * (1 + 0x1p-50)), absolute(q));
        near = choose(parallel, near, larger(near, smaller(one, two)));
        far = choose(parallel, far, smaller(far, larger(one, two)));
        r->undecided |= r->open & parallel & ~(in | out);
        r->open &= ~(parallel & ~in);
    }
    keep_chord(r, near, far, 0x1p-49 * (absolute(near) + absolute(far)));
}

/* Rays that are exactly along a plane: each component of its normal is 0, or the ray's direction's is. */
APART mask along_plane(const algsurf_i_rays_job *job, const places *w, const algsurf_plane *plane) {
    lanes rises = all_lanes(0);
    const int normal = (plane->normal[0] != 0) | (plane->normal[1] != 0) << 1 | (plane->normal[2] != 0) << 2;
    for (int l = 0; l < w->count; l++) rises[l] = (changing(job, w, l) & normal) != 0;
    return at_most(rises, all_lanes(0));
}

/* As rays/planes.c, with components of about 1: o + t d is n.X - c = above + t rise from the plane. */
INLINE void clip_to_plane(const algsurf_i_rays_job *job, const places *w, ray_lanes *r,
                          const algsurf_plane *plane) {
    const double *n = plane->normal;
    lanes above = all_lanes(-plane->offset), rise = all_lanes(0);
    lanes above_error = all_lanes(fabs(plane->offset)), rise_error = all_lanes(0);
    for (int i = 0; i < 3; i++) {
        above += n[i] * r->origin[i];
        rise += n[i] * r->direction[i];
        above_error += absolute(n[i] * r->origin[i]);
        rise_error += absolute(n[i] * r->direction[i]);
    }
    above_error = 0x1p-50 * above_error + LOST_BY_UNDERFLOW;
    rise_error = 0x1p-50 * rise_error + LOST_BY_UNDERFLOW;
    mask steep = less(4 * rise_error, absolute(rise)), up = less(all_lanes(0), rise);
    lanes safe = choose(steep, rise, all_lanes(1)), t = -above / safe;
    lanes off = 2 * (above_error + absolute(t) * rise_error) / absolute(safe) + 0x1p-50 * absolute(t);
    mask cuts_far = steep & up & less(t - off, r->far + r->off);
    mask cuts_near = steep & ~up & less(r->near - r->off, t + off);
    r->far = choose(cuts_far, smaller(r->far, t), r->far);
    r->near = choose(cuts_near, larger(r->near, t), r->near);
    r->off = choose(cuts_far | cuts_near, larger(r->off, off), r->off);
    /* along the plane */
    lanes reach = larger(absolute(r->near), absolute(r->far)) + r->off;
    mask endless = r->open & ~steep & ~less(reach, all_lanes(HUGE_VAL));
    if (any(endless)) reach = choose(endless & along_plane(job, w, plane), all_lanes(0), reach);
    lanes slack = 2 * (above_error + reach * (absolute(rise) + rise_error));
    mask kept = steep | less(above, -slack), lost = ~steep & less(slack, above);
    r->undecided |= r->open & ~(kept | lost);
    r->open &= kept;
}

INLINE void clip_rays(const algsurf_i_rays_job *job, const places *w, ray_lanes *r, double scale) {
    const algsurf_extent *e = job->extent;
    if (e && e->kind != ALGSURF_EXTENT_ALL) {
        double centre[3], size[3];
        for (int i = 0; i < 3; i++) {
            centre[i] = scale * e->centre[i];
            size[i] = scale * e->size[i];
        }
        if (e->kind == ALGSURF_EXTENT_SPHERE)
            clip_to_sphere(r, centre, size[0]);
        else
            clip_to_box(r, centre, size);
    }
    for (int i = 0; i < job->plane_count; i++) clip_to_plane(job, w, r, job->planes + i);
    r->open &= ~less(r->far, r->near - 4 * r->off);
}

/* The chord's points middle + v half, -1 <= v <= 1, at t_c + v h. */
typedef struct chord_line {
    lanes t_c, h, middle[3], half[3];
} chord_line;

#endif
