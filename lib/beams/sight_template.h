/* sight_template.h - the lines of sight of a row's pixels: the chord inside the extent, as planes cut it, and
 * how much the coefficients along them are off.
 *
 * Ends of chords.  An end is computed for a line of sight: for u, v and the slopes a, b as they are rounded.
 * It stands for the end on the pixel's ray.  So it has two errors: rounding, and the view's noise N, by which
 * points of the ray and of the line differ at most in each of x, y, z.  Both are less than the chord's blur,
 * which is made of
 *     e = 2^-44 + 4 N,  divided by the sine where the line meets the extent or a plane at a slant.
 * What is shown has |X| <= 1; |u| + |a| < 4 and |v| + |b| < 4 (geometry.c); N < 2^-22 (view.c).
 * Hence |(u,v)| < 5.7, s = 1 + a^2 + b^2 < 33, and the root of s is below 5.75.  Roundings are counted in
 * 2^-53, to first order: 2^-44 has 512 of them.  Beside the end of a ray's chord, sqrt(3) N away, there is a
 * point of the line; N of that is in depth.
 * - Sphere, r <= 1.  The ends are z = (-along -+ half) / s with half^2 = inside = r^2 s - q, where q is the
 *   square of the cross product of (u,v,0) and (a,b,1), and at most about s where there is a chord.
 *   Roundings: r^2 s has 7, of which two are r's and three are those of s; q has 5, and 2 |across| (|ub| +
 *   |va|) <= 2 s^(3/2) more; the difference has one.  These 15 s^(3/2) move z by 15 s^(3/2) / (2 half s); all
 *   others of z, where |z| <= 1, come to 12.  Axes are orthonormal to 2^-48, which moves |X|^2 by 96
 *   roundings and z by 48 / half.  As half <= sqrt(s), the sum is below 68 s / half.  Noise moves |X|^2 by
 *   3.5 N and inside by 3.5 N s, and half^2 > 16 N s (see Edge): so z moves by 1.9 N / half, and by N in
 *   depth: by less than 2.9 N s / half.  Blur is e s / half.
 * - Edge.  Noise and rounding move inside by less than e s.  Therefore a ray has no point in the ball if
 *   inside < -4 e s, and surely has a chord if inside > 4 e s.  Between these bounds, and ON_EDGE s more, it
 *   is undecided; the chord computed then may be too long, but is too short by less than blur.
 * - Box.  A coordinate about the centre is at + z d.  Roundings: at has 2 of 5.7, d has 3 of 5.75, h and the
 *   difference have 8 together, the quotient has 6: below 44 / |d| where |z| <= 1.  Noise: sqrt(3) N / |d| +
 *   N.  Blur is the larger of e and e / |d|.  A quotient with |z| > 1 is no end of a chord.  It is off by
 *   2^-27 |z| at most, so that it stays beyond the ends, but for blur.
 * - Along a face, where |d| <= PARALLEL, the coordinate is within PARALLEL + e of `at`.  As e / 2 < PARALLEL,
 *   that is less than 3 PARALLEL.
 * - Plane.  Only those with |offset| < 11.5 can cut where |z| <= 1.  Roundings: above and rise have 3 of
 *   their terms, the quotient has one: below 76 / |rise|.  Noise is as for a box, and the plane's own error
 *   is added to e.  A plane that counts as one that cuts nothing off, cuts off less than e.  Along the plane,
 *   where |rise| <= PARALLEL, `above` moves by PARALLEL + e at most.
 * - The depth of the eye is off by N.
 * In tiles r is up to 7; what that adds is taken in by 4 blur and a slack of 2^-22 (tiles_template.h).  Ends
 * are compared with rationals by tests/test_chords.c: their error is at most 0.11 blur in pictures, and 0.01
 * blur for lines without noise. */
#ifndef ALGSURF_SIGHT_TEMPLATE_H
#define ALGSURF_SIGHT_TEMPLATE_H
#include "rows.h"
#define MOST_DEGREE ALGSURF_MAX_VIEW_DEGREE
#include "../roots/first_walk_template.h"
#include "../simd/lanes.h"

/* Choices: larger ones leave more rays to be solved alone. */
#define ON_EDGE 0x1p-26  /* of inside / s, so that blur <= 2^13 e s^(1/2); in a box, of a chord's length */
#define PARALLEL 0x1p-20 /* of the part of a direction across a face or plane; e / 2 at least: see Along */
#define ENOUGH 0x1p-30   /* of a root's error, before Newton steps on P itself (points_template.h) */

/* Lines of sight: across u, v at depth 0, with slopes a, b. */
typedef struct sight {
    lanes u, a, v, b;
} sight;

/* Depths where the chord begins and ends, and their error. */
typedef struct chord {
    lanes near, far, blur;
    mask undecided;
} chord;

INLINE chord chord_in_sphere(const algsurf_i_row_job *job, const sight *s, double e) {
    chord c;
    double r = job->extent_size[0];
    lanes size = s->a * s->a + (1 + s->b * s->b), along = s->u * s->a + s->v * s->b;
    lanes across = s->u * s->b - s->v * s->a;
    lanes inside = r * r * size - (s->u * s->u + (s->v * s->v + across * across));
    lanes edge = (ON_EDGE + 4 * e) * size, half = root(larger(inside, edge));
    lanes inverse = 1 / (size * half), over_size = inverse * half;
    c.near = (-along - half) * over_size;
    c.far = (half - along) * over_size;
    c.blur = e * (size * size) * inverse;
    c.undecided = at_most(absolute(inside), edge);
    c.far = choose(less(inside, -edge), c.near - 1, c.far); /* surely none: see Edge */
    return c;
}

/* All of space: without faces. */
INLINE chord chord_in_box(const algsurf_i_row_job *job, const sight *s, double e) {
    const double(*axis)[3] = job->view->axis;
    chord c = {all_lanes(-1), all_lanes(1), all_lanes(e), less(s->u, s->u)};
    for (int k = 0; k < (job->extent->kind == ALGSURF_EXTENT_ALL ? 0 : 3); k++) {
        lanes at = s->u * axis[0][k] + s->v * axis[1][k], h = all_lanes(job->extent_size[k]);
        lanes d = s->a * axis[0][k] + (s->b * axis[1][k] + axis[2][k]);
        mask along = at_most(absolute(d), all_lanes(PARALLEL));
        lanes safe = choose(along, all_lanes(1), d), one = (-h - at) / safe, two = (h - at) / safe;
        lanes room = h - absolute(at); /* the line's coordinate moves by less than 3 PARALLEL */
        c.near = choose(along, c.near, larger(c.near, smaller(one, two)));
        c.far = choose(along, c.far, smaller(c.far, larger(one, two)));
        c.far = choose(along & less(room, all_lanes(-4 * PARALLEL)), c.near - 1, c.far);
        c.undecided |= along & at_most(absolute(room), all_lanes(4 * PARALLEL));
        c.blur = choose(along, c.blur, larger(c.blur, e / absolute(safe)));
    }
    c.undecided |= at_most(absolute(c.far - c.near), all_lanes(ON_EDGE));
    return c;
}

/* What a plane keeps of chords.  Where it surely cuts nothing off, it leaves their error as it is. */
INLINE void clip_to_plane(const algsurf_i_row_job *job, const algsurf_i_cut_plane *plane, const sight *s,
                          double e, chord *c) {
    const double *n = plane->normal;
    lanes above = n[0] * s->u + (n[1] * s->v - (plane->offset + job->plane_room));
    lanes rise = n[0] * s->a + (n[1] * s->b + n[2]), room = all_lanes(4 * (PARALLEL + e));
    mask along = at_most(absolute(rise), all_lanes(PARALLEL)), up = less(all_lanes(0), rise);
    lanes safe = choose(along, all_lanes(1), rise), z = -above / safe, blur = e / absolute(safe);
    mask at_far = ~along & up & less(z - blur, c->far + c->blur);
    mask at_near = ~along & ~up & less(c->near - c->blur, z + blur);
    c->far = choose(at_far, smaller(c->far, z), c->far);
    c->near = choose(at_near, larger(c->near, z), c->near);
    c->blur = choose(at_far | at_near, larger(c->blur, blur), c->blur);
    c->far = choose(along & less(room, above), c->near - 1, c->far);
    c->undecided |= along & at_most(absolute(above), room);
}

/* The part of each line of sight that is shown, as far as it is known. */
INLINE chord chord_of(const algsurf_i_row_job *job, const sight *s) {
    const double e = 0x1p-44 + 4 * job->view->noise;
    const int ball = job->extent->kind == ALGSURF_EXTENT_SPHERE;
    chord c = ball ? chord_in_sphere(job, s, e) : chord_in_box(job, s, e);
    for (int i = 0; i < job->plane_count; i++)
        clip_to_plane(job, job->planes + i, s, e + job->planes[i].error, &c);
    return c;
}

/* The same from depth `near` on, and the lanes where there is one.  With each end off by blur, one is surely
 * there, or none, where 2 blur are exceeded; 8 are taken, and 2^-38, as ends become multiples of 2^-40. */
INLINE chord clip(const algsurf_i_row_job *job, const sight *s, lanes near, mask *open) {
    chord c = chord_of(job, s);
    c.near = larger(c.near, near);
    lanes slack = 8 * c.blur + 0x1p-38;
    c.undecided |= at_most(absolute(c.far - c.near), slack);
    c.undecided &= less(c.near - slack, c.far);
    *open = less(c.near, c.far) & ~c.undecided;
    return c;
}

INLINE sight sight_at(const algsurf_i_row_job *job, lanes pixel) {
    lanes u = job->u0 + job->du * ((pixel + job->offset) * job->pixel);
    return (sight){u, job->view->alpha * u + job->view->beta[0], all_lanes(job->row->v),
                   all_lanes(job->slope)};
}

/* The states of so many lanes, at most. */
INLINE void store_states(mask hit, mask undecided, int count, uint8_t *state) {
    const unsigned hits = bits(hit), left = bits(undecided);
    for (int l = 0; l < LANES && l < count; l++)
        state[l] = (uint8_t)(ALGSURF_LANE_HIT * (hits >> l & 1) + ALGSURF_LANE_UNDECIDED * (left >> l & 1));
}

/* P along lines of sight at u, in powers of depth. */
INLINE void powers_at(const algsurf_i_row_job *job, lanes u, lanes *c, int n) {
    for (int k = 0; k <= n; k++) {
        const double *row = job->row->c + k * job->row->stride;
        c[k] = all_lanes(row[n]);
        for (int m = n - 1; m >= 0; m--) c[k] = c[k] * u + row[m];
    }
}

/* What they are off by at most, taken together, for |z| <= 1. */
INLINE lanes radius_at(const algsurf_i_row_job *job, lanes u, int n) {
    lanes radius = all_lanes(0), x = absolute(u) + absolute(job->view->alpha * u);
    x += fabs(job->view->beta[0]) + job->view->noise;
    for (int i = n; i >= 0; i--) radius = radius * x + job->row->radius[i];
    return radius;
}

#endif
