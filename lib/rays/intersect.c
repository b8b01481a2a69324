/* intersect.c - a single ray's first hit, all of its hits, occluded or not: roots become hits.
 *
 * The first hit, and occlusion, are here for the rays that the packet code leaves alone (packet.c).
 */
#include "algsurf/intersect.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "../base/fpenv.h"
#include "intersect_impl.h"
#include "kernel.h"
#include "../simd/kernel.h"
#include "../base/options.h"
#include "ray_impl.h"
#include "../base/vec.h"

typedef struct query {
    const algsurf_surface *surface;
    algsurf_ray ray; /* clipped to the extent */
    algsurf_i_edges edges;
    int empty; /* nothing of the ray is left */
    algsurf_intersect_options options;
} query;

algsurf_status algsurf_i_intersect_read_options(const algsurf_intersect_options *given,
                                                algsurf_intersect_options *options) {
    static const algsurf_intersect_options defaults = {.size = sizeof defaults};
    if (!algsurf_options_read(options, sizeof *options, given ? given : &defaults)) return ALGSURF_E_ARGUMENT;
    if ((unsigned)options->tier > ALGSURF_TIER_CERTIFIED || (unsigned)options->doubt > ALGSURF_DOUBT_MISS)
        return ALGSURF_E_ARGUMENT;
    if (options->method < ALGSURF_METHOD_DEFAULT || options->method > ALGSURF_METHOD_REGULA_FALSI)
        return ALGSURF_E_ARGUMENT;
    if (options->max_iterations < 0 || !(options->tolerance >= 0) || isinf(options->tolerance))
        return ALGSURF_E_ARGUMENT;
    if (options->kernel) {
        const algsurf_i_kernel *kernel = algsurf_i_kernel_find(options->kernel);
        if (!kernel) return ALGSURF_E_ARGUMENT;
        options->kernel = kernel->name; /* the caller's string need not live on */
    }
    return ALGSURF_OK;
}

/* Checks the arguments and clips the ray; in the standard environment, where subnormals count. */
static algsurf_status prepare(query *q, const algsurf_surface *surface, const algsurf_extent *extent,
                              const algsurf_ray *ray, const algsurf_intersect_options *options) {
    if (!surface) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_ray_check(ray);
    if (status == ALGSURF_OK) status = algsurf_i_extent_check(extent);
    if (status == ALGSURF_OK) status = algsurf_i_intersect_read_options(options, &q->options);
    if (status != ALGSURF_OK) return status;
    q->surface = surface;
    q->edges.extent = NULL;
    q->empty = q->options.tier == ALGSURF_TIER_CERTIFIED
                   ? !algsurf_i_extent_bracket(extent, ray, &q->ray, &q->edges)
                   : !algsurf_i_extent_clip(extent, ray, &q->ray);
    return ALGSURF_OK;
}

static void set_miss(algsurf_hit *hit) {
    *hit = (algsurf_hit){ALGSURF_MISS, ALGSURF_OK, INFINITY, INFINITY, INFINITY, {0, 0, 0}, {0, 0, 0}};
}

static void point_at(const algsurf_i_frame *f, algsurf_dd offset, double x[3]) {
    for (int i = 0; i < 3; i++) x[i] = algsurf_dd_add(f->X[i], algsurf_dd_mul_d(offset, f->V[i])).hi;
}

/* Newton steps on P at the point itself, in natural units: they take out what the expansion over a long
 * chord lost.  One is the rule; more only where the first was large. */
static void polish(const query *q, const algsurf_i_frame *f, algsurf_i_ray_root *root, double x[3]) {
    double gradient[3];
    double lo = ldexp(root->t_lo, f->exponent), hi = ldexp(root->t_hi, f->exponent);
    for (int i = 0; i < 4; i++) {
        double value = algsurf_i_surface_value(q->surface, x, gradient);
        double step = -value / algsurf_dot(gradient, f->V);
        algsurf_dd offset = algsurf_dd_add_d(root->offset, step);
        double s = f->centre + offset.hi;
        if (!(s >= lo && s <= hi)) return;
        root->offset = offset; /* in double-double: t may be far smaller than its distance to the centre */
        point_at(f, root->offset, x);
        if (fabs(step) <= 0x1p-40 * fabs(hi - lo)) return;
    }
}

/* A coordinate of the point at t; what is beyond the largest double is drawn in. */
static double coordinate_at(const query *q, int axis, double t) {
    return fmin(fmax(fma(t, q->ray.direction[axis], q->ray.origin[axis]), -DBL_MAX), DBL_MAX);
}

/* The point at t where the frame has, or may have, overflowed. */
static void point_within_range(const query *q, double t, double x[3], double position[3]) {
    for (int i = 0; i < 3; i++) {
        position[i] = coordinate_at(q, i, t);
        x[i] = ldexp(fma(t, q->ray.direction[i], q->ray.origin[i]), -q->surface->unit);
    }
}

/* A point in natural units as the caller's; a coordinate of which underflow took digits, from t. */
static void set_position(const query *q, const algsurf_i_frame *f, const double x[3], double t,
                         double position[3]) {
    for (int i = 0; i < 3; i++) {
        int lost = q->ray.direction[i] != 0 && fabs(f->V[i]) < 0x1p-900;
        lost |= x[i] != 0 && fabs(x[i]) < 0x1p-900;
        position[i] = lost ? coordinate_at(q, i, t) : ldexp(x[i], q->surface->unit);
    }
}

/* The gradient at a point before x on the ray, `back` away in natural units or, far out, in those of |x|; 0
 * when it is mostly rounding. */
static int gradient_before(const query *q, const algsurf_i_frame *f, const double x[3], double back,
                           double gradient[3]) {
    double before[3], length = back * fmax(1, algsurf_max_abs(x));
    for (int i = 0; i < 3; i++) before[i] = x[i] - length * f->V[i];
    return algsurf_i_surface_clear_gradient(q->surface, before, gradient);
}

/* The gradient at x; 0 when it is mostly rounding, or another than a few roundings of x away. */
static int gradient_at(const query *q, const algsurf_i_frame *f, const double x[3], double gradient[3]) {
    double near[3], size = 0, change = 0;
    if (!gradient_before(q, f, x, 0, gradient)) return 0;
    (void)gradient_before(q, f, x, 0x1p-44, near);
    for (int i = 0; i < 3; i++) {
        size = fmax(size, fabs(gradient[i]));
        change = fmax(change, fabs(near[i] - gradient[i]));
    }
    return change <= 0x1p-8 * size;
}

/* The unit normal at x.  At a singular point, where there is no gradient, it is that of the nearest of some
 * points before it on the ray: where two sheets meet, or one is there twice, the normal seen beside.  0: no
 * point has any. */
static void set_normal(const query *q, const algsurf_i_frame *f, const double x[3], double normal[3]) {
    double gradient[3];
    int found = gradient_at(q, f, x, gradient);
    for (double back = 0x1p-36; !found && back <= 0x1p-8; back *= 16)
        found = gradient_before(q, f, x, back, gradient);
    if (!found || !algsurf_is_finite3(gradient) || !algsurf_unit(gradient, normal))
        normal[0] = normal[1] = normal[2] = 0;
}

static void make_hit(const query *q, const algsurf_i_frame *f, algsurf_i_ray_root *root, algsurf_hit *hit) {
    double x[3];
    point_at(f, root->offset, x);
    if (root->polish) polish(q, f, root, x);
    double t = ldexp(algsurf_dd_add_d(root->offset, f->centre).hi, -f->exponent);
    if (!isfinite(t)) t = 0.5 * root->t_lo + 0.5 * root->t_hi; /* the frame has overflowed */
    t = fmin(fmax(fmin(fmax(t, root->t_lo), root->t_hi), -DBL_MAX), DBL_MAX);
    set_position(q, f, x, t, hit->position);
    if (root->reason == ALGSURF_UNDECIDED_RANGE || !algsurf_is_finite3(hit->position))
        point_within_range(q, t, x, hit->position);
    set_normal(q, f, x, hit->normal);
    hit->state = root->state;
    hit->reason = root->reason;
    hit->t = t;
    hit->t_lo = q->options.tier == ALGSURF_TIER_FAST ? t : root->t_lo;
    hit->t_hi = q->options.tier == ALGSURF_TIER_FAST ? t : root->t_hi;
}

/* The lanes' answer to a checked query: the first hits, at most `most`, or -1 where they have none. */
static int hits_in_lanes(const query *q, const algsurf_extent *extent, const algsurf_ray *ray, int most,
                         algsurf_hit *hits) {
    const algsurf_intersect_options *o = &q->options;
    const double *x = ray->origin, *d = ray->direction;
    const algsurf_i_rays_job job = {.surface = q->surface,
                                    .extent = extent,
                                    .origin = {x, x + 1, x + 2},
                                    .direction = {d, d + 1, d + 2},
                                    .t_min = &ray->t_min,
                                    .t_max = &ray->t_max,
                                    .bounded = o->tier != ALGSURF_TIER_FAST};
    const algsurf_refine_options how = {sizeof how, o->method, o->max_iterations, o->tolerance};
    int chosen = o->method != ALGSURF_METHOD_DEFAULT || o->max_iterations > 0;
    if (!algsurf_i_rays_fit(q->surface, extent)) return -1;
    return algsurf_i_rays_single(&job, chosen ? &how : NULL, most, hits);
}

ALGSURF_NOINLINE algsurf_status algsurf_i_intersect_first(const algsurf_surface *surface,
                                                          const algsurf_extent *extent,
                                                          const algsurf_ray *ray,
                                                          const algsurf_intersect_options *options,
                                                          algsurf_hit *hit) {
    query q;
    algsurf_i_frame frame;
    algsurf_i_ray_root root;
    algsurf_status status = prepare(&q, surface, extent, ray, options);
    if (status != ALGSURF_OK) return status;
    int chosen = q.options.method != ALGSURF_METHOD_DEFAULT || q.options.max_iterations > 0;
    int found = chosen ? hits_in_lanes(&q, extent, ray, 1, hit) : -1; /* else packet.c has tried */
    if (found == 1) return ALGSURF_OK;
    if (found == 0 || q.empty ||
        !algsurf_i_decided_roots(surface, &q.ray, &q.edges, &q.options, ALGSURF_WANT_FIRST, &frame, &root, 1))
        set_miss(hit);
    else
        make_hit(&q, &frame, &root, hit);
    return ALGSURF_OK;
}

static ALGSURF_NOINLINE algsurf_status all(const algsurf_surface *surface, const algsurf_extent *extent,
                                           const algsurf_ray *ray, const algsurf_intersect_options *options,
                                           algsurf_hit *hits, int capacity, int *count) {
    query q;
    algsurf_i_frame frame;
    algsurf_i_ray_root roots[ALGSURF_MAX_DEGREE + 1];
    algsurf_status status = prepare(&q, surface, extent, ray, options);
    if (status != ALGSURF_OK) return status;
    int room = surface->degree > 0 ? surface->degree : 1;
    algsurf_hit found[ALGSURF_MAX_DEGREE];
    int n = hits_in_lanes(&q, extent, ray, room, found);
    if (n > capacity) return ALGSURF_E_ARGUMENT;
    if (n >= 0) {
        memcpy(hits, found, (size_t)n * sizeof *hits);
        *count = n;
        return ALGSURF_OK;
    }
    n = q.empty ? 0
                : algsurf_i_decided_roots(surface, &q.ray, &q.edges, &q.options, ALGSURF_WANT_ALL, &frame,
                                          roots, room);
    if (n > capacity) return ALGSURF_E_ARGUMENT;
    for (int i = 0; i < n; i++) make_hit(&q, &frame, roots + i, hits + i);
    *count = n;
    return ALGSURF_OK;
}

algsurf_status algsurf_intersect_all(const algsurf_surface *surface, const algsurf_extent *extent,
                                     const algsurf_ray *ray, const algsurf_intersect_options *options,
                                     algsurf_hit *hits, int capacity, int *count) {
    if (!hits || !count || capacity < 0) return ALGSURF_E_ARGUMENT;
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = all(surface, extent, ray, options, hits, capacity, count);
    algsurf_fpenv_leave(&saved);
    return status;
}

ALGSURF_NOINLINE algsurf_status algsurf_i_occluded(const algsurf_surface *surface,
                                                   const algsurf_extent *extent, const algsurf_ray *ray,
                                                   const algsurf_intersect_options *options,
                                                   algsurf_hit_state *state) {
    query q;
    algsurf_i_frame frame;
    algsurf_i_ray_root roots[ALGSURF_MAX_DEGREE + 1];
    algsurf_status status = prepare(&q, surface, extent, ray, options);
    if (status != ALGSURF_OK) return status;
    int n = q.empty ? 0
                    : algsurf_i_decided_roots(surface, &q.ray, &q.edges, &q.options, ALGSURF_WANT_ANY, &frame,
                                              roots, ALGSURF_MAX_DEGREE + 1);
    *state = n ? (algsurf_hit_state)roots[0].state : ALGSURF_MISS;
    return ALGSURF_OK;
}
