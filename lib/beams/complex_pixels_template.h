/* complex_pixels_template.h - the pixels of a row in complex space: the polynomial in the depth z, the root
 * that is seen (complex/lanes_template.h), its point.
 *
 * Parameter.  With w = z - near, a ray's parameter is t = L w, L = size |direction|: arguments and order of
 * magnitude are those of w.  Imaginary parts are sum a_k t^k, brought to z by Horner's rule over polynomials;
 * a step of it makes two products, one of them with near L, rounded, and a sum: 4 u of its size, and 2^-900
 * covers what underflows.
 *
 * Error.  The error of a term q_ijk x^i y^j z^k as computed is at most a known share of |q_ijk| x^i y^j |z|^k
 * (surface/view.c), where x, y are bounds for |z| <= 1.  For |z| >= 1 they grow as |z|, i + j + k <= n, and
 * so the error is at most R max(1,|z|)^n, R the row's radius at the pixel.  A pixel's ray differs from the
 * line computed with by a vector that is linear in w.  At z = -1 and z = 1 each part of it is at most the
 * view's noise, and as much again with the rounding of L; so for complex z it is at most 4 noise max(1,|z|):
 * in complex space the view's noise is four times as large.
 *
 * Lanes that the first discs leave undecided go on for as long as that helps.
 *
 * The point is found by one more step on P itself, at the complex point of the ray: as accurate as the step
 * from the root of a rounded polynomial can be.  The normal is that of rays/complex_ray.c. */
#ifndef ALGSURF_COMPLEX_PIXELS_TEMPLATE_H
#define ALGSURF_COMPLEX_PIXELS_TEMPLATE_H
#include "../complex/lanes_template.h"
#include "points_template.h"
#include "sight_template.h"

#define OFF_AXIS 0x1p-10 /* a fraction of a pixel: real roots that become a pair have to leave the axis */
#define MARGIN_OF_ENDS 0x1p-44 /* of the distance from the eye: where a single ray may clip otherwise */
#define EITHER_SIDE 0x1p-30    /* rays/complex_ray.c */

/* Adds the imaginary part for rays of length `scale` a unit of w. */
INLINE void add_imaginary(const algsurf_i_complex_job *job, lanes scale, polynomials *p) {
    lanes size[MOST_ROOTS + 1], shift = -job->row->near * scale, far = absolute(shift);
    for (int i = 0; i <= job->top; i++) size[i] = p->im[i] = all_lanes(0);
    for (int k = job->top; k >= 0; k--) {
        for (int i = job->top - k; i > 0; i--) {
            p->im[i] = shift * p->im[i] + scale * p->im[i - 1];
            size[i] = far * size[i] + scale * size[i - 1] + 0x1p-900;
        }
        p->im[0] = shift * p->im[0] + job->imaginary[k];
        size[0] = far * size[0] + (fabs(job->imaginary[k]) + 0x1p-900);
    }
    for (int i = 0; i <= job->top; i++) p->spread += (4 * job->top + 8) * ROUNDING * size[i];
}

INLINE void set_polynomials(const algsurf_i_complex_job *job, const sight *s, int n, polynomials *p) {
    powers_at(job->row, s->u, p->re, n);
    for (int k = 0; k <= n; k++) p->im[k] = all_lanes(0);
    p->spread = radius_at(job->row, s->u, n);
    p->real = job->top < 0;
    if (!p->real) add_imaginary(job, job->row->view->size * root(s->a * s->a + (1 + s->b * s->b)), p);
}

/* The roots of the row above, moved off the axis; where there are none, cold ones. */
INLINE void warm_up(const algsurf_i_complex_job *job, const polynomials *p, int n, int x, int count,
                    roots *r) {
    for (int i = 0; i < n; i++) {
        r->x[i] = load_some(job->x + i * job->stride + x, count);
        r->y[i] = load_some(job->y + i * job->stride + x, count) + OFF_AXIS;
    }
    mask cold = ~at_most(r->x[0], r->x[0]);
    if (any(cold)) set_start(p, n, cold, r->x, r->y);
}

/* What is left for the next row: NaN where roots were not told apart. */
INLINE void keep_roots(const algsurf_i_complex_job *job, int n, int x, int count, mask found, roots *r) {
    r->x[0] = choose(found, r->x[0], all_lanes(NAN));
    for (int i = 0; i < n; i++) {
        store_some(job->x + i * job->stride + x, r->x[i], count);
        store_some(job->y + i * job->stride + x, r->y[i], count);
    }
}

/* The depths of roots that are seen. */
typedef struct complex_depths {
    mask hit, undecided;
    lanes re, im;
} complex_depths;

/* The lanes that are open, at least one; returns the number of corrections. */
INLINE int solve_open(const algsurf_i_complex_job *job, const sight *s, const chord *c, mask open, int x,
                      int count, int n, complex_depths *d) {
    static const double stops[2] = {NEAR_STOP, FAR_STOP};
    double near = job->row->near;
    const window w = {job->sector, near, c->near - near, c->far - near,
                      2 * c->blur + MARGIN_OF_ENDS * (1 + fabs(near))};
    int corrections = 0;
    polynomials p;
    roots r;
    set_polynomials(job, s, n, &p);
    warm_up(job, &p, n, x, count, &r);
    mask found = no_lane(), hopeless = open & ~at_most(all_lanes(0x1p-300), least_lead(&p, n));
    open &= ~hopeless;
    for (int k = 0; k < 2 && any(open); k++) {
        corrections += iterate(&p, n, open, stops[k], r.x, r.y);
        prove(&p, n, &r);
        seen root = find_seen(&p, n, &r, &w);
        if (any(root.one & open)) settle(&p, n, &root);
        mask now = root.one & open;
        d->re = choose(now, root.x, d->re);
        d->im = choose(now, root.y, d->im);
        d->hit |= now;
        found |= open & ~root.undecided;
        open &= root.undecided;
    }
    d->undecided |= open | hopeless;
    keep_roots(job, n, x, count, found, &r);
    return corrections;
}

/* The pixels from x on, before `end`; returns the number of corrections. */
INLINE int solve_complex_packet(const algsurf_i_complex_job *job, int x, int end, int n) {
    const int count = end - x;
    sight s = sight_at(job->row, smaller(x + numbered(), all_lanes(end - 1)));
    mask open, given = less(numbered(), all_lanes(count));
    chord c = clip(job->row, &s, all_lanes(job->row->near), &open);
    complex_depths d = {no_lane(), c.undecided, all_lanes(0), all_lanes(0)};
    int corrections = 0;
    if (any(open & given))
        corrections = solve_open(job, &s, &c, open & given, x, count, n, &d);
    else
        store_some(job->x + x, all_lanes(NAN), count);
    store_states(d.hit, d.undecided, count, job->state + x);
    store_some(job->re + x, d.re, count);
    store_some(job->im + x, d.im, count);
    return corrections;
}

INLINE uint64_t solve_complex_n(const algsurf_i_complex_job *job, int begin, int end, int n) {
    uint64_t corrections = 0;
    if (n < 1 || n > MOST_ROOTS) __builtin_unreachable();
    for (int x = begin; x < end; x += LANES) corrections += (uint64_t)solve_complex_packet(job, x, end, n);
    return corrections;
}

static uint64_t solve_complex(const algsurf_i_complex_job *job, int begin, int end) {
    uint64_t corrections = 0;
    FOR_DEGREES(DEGREES_OF_ROOTS, job->row->row->degree, corrections = solve_complex_n(job, begin, end, N),
                DEGREES_2_TO_4(corrections = solve_complex_n(job, begin, end, N))
                    FOR_ONE_DEGREE(6, corrections = solve_complex_n(job, begin, end, N)))
    return corrections;
}

/* ---- points ---- */

typedef struct complex_jets {
    complex_lanes v, gradient[3];
} complex_jets;

/* a z + b. */
INLINE complex_lanes times_plus(complex_lanes a, complex_lanes z, complex_lanes b) {
    complex_lanes c = times(a, z);
    return (complex_lanes){c.re + b.re, c.im + b.im};
}

/* As algsurf_i_surface_gradient_complex, and P. */
INLINE complex_jets complex_surface_jets(const algsurf_surface *s, const complex_lanes x[3]) {
    const complex_lanes zero = {all_lanes(0), all_lanes(0)};
    complex_jets p = {zero, {zero, zero, zero}};
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_row *row = s->rows + s->levels[k].first;
        complex_lanes level = zero, level_x = zero, level_y = zero;
        for (int j = s->levels[k].count - 1; j >= 0; j--) {
            const double *c = s->coef + row[j].first;
            complex_lanes r = zero, r_x = zero;
            for (int i = row[j].length - 1; i >= 0; i--) {
                r_x = times_plus(r_x, x[0], r);
                r = times(r, x[0]);
                r.re += c[i];
            }
            level_x = times_plus(level_x, x[1], r_x);
            level_y = times_plus(level_y, x[1], level);
            level = times_plus(level, x[1], r);
        }
        p.gradient[0] = times_plus(p.gradient[0], x[2], level_x);
        p.gradient[1] = times_plus(p.gradient[1], x[2], level_y);
        p.gradient[2] = times_plus(p.gradient[2], x[2], p.v);
        p.v = times_plus(p.v, x[2], level);
    }
    return p;
}

/* Adds i sum a_k t^k, and its derivative. */
INLINE void add_imaginary_value(const algsurf_i_complex_job *job, complex_lanes t, lanes scale,
                                complex_lanes *v, complex_lanes *slope) {
    complex_lanes sum = {all_lanes(0), all_lanes(0)}, d = sum;
    for (int k = job->top; k >= 0; k--) {
        d = times_plus(d, t, sum);
        sum = times(sum, t);
        sum.re += job->imaginary[k];
    }
    v->re -= sum.im, v->im += sum.re;
    slope->re -= d.im * scale, slope->im += d.re * scale;
}

/* Entries from `first` on; tells which of them have their root, and returns whether all have. */
INLINE int find_complex_packet(const algsurf_i_complex_job *job, const algsurf_surface *surface,
                               const row_rays *s, const int *pixel, const double *re, const double *im,
                               uint8_t *sure, const algsurf_i_points *points, int first, int count) {
    packet_rays ray =
        rays_of_packet(s, load_some_integers(pixel + first, count), load_some(re + first, count));
    complex_lanes z = {ray.z, s->size * load_some(im + first, count)}, x[3], slope;
    mask real = at_most(absolute(z.im), all_lanes(0));
    lanes square = dot(ray.along, ray.along), length = root(square), along = all_lanes(1);
    lanes normal[3];
    for (int i = 0; i < 3; i++)
        x[i] = (complex_lanes){ray.foot[i] + z.re * ray.along[i], z.im * ray.along[i]};
    complex_jets p = complex_surface_jets(surface, x);
    slope.re =
        p.gradient[0].re * ray.along[0] + p.gradient[1].re * ray.along[1] + p.gradient[2].re * ray.along[2];
    slope.im =
        p.gradient[0].im * ray.along[0] + p.gradient[1].im * ray.along[1] + p.gradient[2].im * ray.along[2];
    if (job->top >= 0) {
        complex_lanes t = {(z.re - s->near) * length, z.im * length};
        add_imaginary_value(job, t, length, &p.v, &slope);
    }
    complex_lanes step = quotient(p.v, slope);
    mask near = at_most(step.re * step.re + step.im * step.im,
                        all_lanes(FARTHEST_STEP * FARTHEST_STEP * s->size * s->size));
    z.re -= step.re;
    z.im -= step.im;
    lanes front = z.re - s->near, far = root(front * front + z.im * z.im);
    /* far + near without cancellation */
    ray.z = choose(less(all_lanes(0), front), z.re + z.im * z.im / (far + front), far + s->near);
    for (int i = 0; i < 3; i++) {
        normal[i] = quotient(p.gradient[i], slope).re;
        along -= normal[i] * ray.along[i];
    }
    along = choose(real & less(all_lanes(job->top), all_lanes(0)), all_lanes(0), along / square);
    mask inward = less(slope.re, -EITHER_SIDE * root(slope.re * slope.re + slope.im * slope.im));
    for (int i = 0; i < 3; i++) {
        normal[i] += along * ray.along[i];
        normal[i] = choose(inward, -normal[i], normal[i]);
    }
    finish_packet(s, &ray, ray.z, normal, job->looks, points, first, count);
    store_some(points->t + first, far * length * s->unit, count);
    return tell_sure(near, sure, first, count);
}

static int find_complex_points(const algsurf_i_complex_job *job, const algsurf_surface *surface,
                               const int *pixel, const double *re, const double *im, int count, uint8_t *sure,
                               const algsurf_i_points *points) {
    const algsurf_i_point_job row = {.surface = surface, .row = job->row};
    const row_rays s = rays_of_row(&row);
    int all = 1;
    for (int first = 0; first < count; first += LANES)
        all &= find_complex_packet(job, surface, &s, pixel, re, im, sure, points, first, count - first);
    return all;
}

#endif
