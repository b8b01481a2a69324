/* intersect.c - a single ray's first hit, all of its hits, occluded or not: roots become hits.
 *
 * A ray alone has the packet code's answers for one lane (one_ray_template.h), and where these are undecided
 * those of integers (exact_ray.c), as have the rays that packets leave undecided (packet.c). */
#include "../base/arithmetic.h"
#include "algsurf/intersect.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "../base/eft.h"
#include "../base/fpenv.h"
#include "exact_ray.h"
#include "intersect_impl.h"
#include "expand_impl.h"
#include "../base/vec.h"

void algsurf_i_set_miss(algsurf_hit *hit, int side) {
    *hit = (algsurf_hit){
        .state = ALGSURF_STATE_MISS, .side = side, .t = INFINITY, .t_lo = INFINITY, .t_hi = INFINITY};
}

/* A step of Newton's method on P at the root's point, where the root is simple: it takes out the rounding of
 * t, which is more than that of coordinates when the origin is far.  Only within the interval of the root. */
static void polish(const algsurf_surface *surface, const algsurf_i_frame *f, const algsurf_i_ray_root *root,
                   double x[3]) {
    double gradient[3], value = algsurf_i_surface_value(surface, x, gradient);
    double step = -value / algsurf_dot(gradient, f->V);
    double width = ldexp(root->t_hi - root->t_lo, f->exponent);
    if (!(fabs(step) <= width)) return;
    for (int i = 0; i < 3; i++) x[i] = algsurf_dd_add(f->X[i], algsurf_two_prod(step, f->V[i])).hi;
}

static void make_hit(const algsurf_i_query *q, const algsurf_ray *ray, const algsurf_i_ray_root *root,
                     algsurf_hit *hit) {
    const algsurf_surface *surface = q->surface;
    const int simple = root->multiplicity == 1;
    algsurf_ray point = *ray;
    algsurf_i_frame f;
    double x[3];
    /* in the caller's units: how far rounding of t puts the point from a root on which no step is taken */
    const double off = simple ? 0 : 0x1p-52 * fabs(root->t) * algsurf_max_abs(ray->direction);
    point.t_min = point.t_max = root->t;
    algsurf_i_frame_of(surface, &point, 0, &f);
    for (int i = 0; i < 3; i++) x[i] = f.X[i].hi;
    if (simple) polish(surface, &f, root, x);
    *hit = (algsurf_hit){.state = ALGSURF_STATE_HIT,
                         .multiplicity = root->multiplicity,
                         .side = root->side,
                         .t = root->t,
                         .t_lo = root->t_lo,
                         .t_hi = root->t_hi};
    algsurf_i_set_position(&f, x, ray, surface->unit, root->t, f.lost || !f.one_piece, hit->position);
    algsurf_i_set_normal(surface, ray, hit->position, off, q->memory_limit, hit->normal);
}

void algsurf_i_set_undecided(const algsurf_ray *ray, double lo, double hi, algsurf_status reason,
                             algsurf_hit *hit) {
    double middle = 0.5 * lo + 0.5 * hi, t = isfinite(middle) ? middle
                                             : isfinite(lo)   ? lo
                                             : isfinite(hi)   ? hi
                                                              : 0;
    *hit = (algsurf_hit){.state = ALGSURF_STATE_UNDECIDED, .reason = reason, .t = t, .t_lo = lo, .t_hi = hi};
    for (int i = 0; i < 3; i++) hit->position[i] = algsurf_i_coordinate_at(ray, i, t);
}

/* One lane's answer: the hits that are wanted, or -1 where they are undecided. */
static int hits_in_lane(const algsurf_i_query *q, const algsurf_ray *ray, algsurf_i_want want,
                        algsurf_hit *hits) {
    if (!q->fits_lanes || (want == ALGSURF_WANT_ANY && q->has_method)) return -1;
    algsurf_i_rays_job job = q->job;
    const double *at = ray->origin, *d = ray->direction;
    const algsurf_ray_packet rays = {.count = 1,
                                     .origin = {at, at + 1, at + 2},
                                     .direction = {d, d + 1, d + 2},
                                     .t_min = &ray->t_min,
                                     .t_max = &ray->t_max};
    job.rays = &rays;
    job.any = want == ALGSURF_WANT_ANY;
    const algsurf_refine_options how = algsurf_i_refinement_of(&q->options);
    int most = want == ALGSURF_WANT_ALL ? q->surface->degree : 1;
    int count = algsurf_i_ray_kernel_for(q->kernel)->all(&job, q->has_method ? &how : NULL, most, hits);
    for (int i = 0; i < count && !job.any; i++)
        if (isnan(hits[i].normal[0]))
            algsurf_i_set_normal(q->surface, ray, hits[i].position, 0, q->memory_limit, hits[i].normal);
    return count;
}

/* What lanes leave undecided, in integers: at most ALGSURF_MAX_DEGREE hits, or one for want FIRST.  Places
 * that are undecided only coefficients with an error have: there FIRST is among all.  If there are none,
 * hits->side is that of the miss. */
static ALGSURF_NOINLINE algsurf_status hits_exact(const algsurf_i_query *q, const algsurf_ray *ray,
                                                  algsurf_i_want want, algsurf_hit *hits, int *count) {
    algsurf_i_ray_root roots[ALGSURF_MAX_DEGREE];
    const algsurf_i_wanted wanted = {want, q->options.side, q->memory_limit, q->options.observer};
    algsurf_status status =
        algsurf_i_exact_roots(q->surface, &q->region, ray, &wanted, roots, count, &hits->side);
    if (status == ALGSURF_OK && q->crossings && *count && !roots[0].reason && !roots[0].multiplicity)
        *count = hits->side = 0;
    for (int i = 0; status == ALGSURF_OK && i < *count; i++)
        if (roots[i].reason == ALGSURF_OK)
            make_hit(q, ray, roots + i, hits + i);
        else
            algsurf_i_set_undecided(ray, roots[i].t_lo, roots[i].t_hi, roots[i].reason, hits + i);
    return status;
}

/* What becomes of undecided places is the caller's choice. */
static void settle_undecided(int as, algsurf_hit *hits, int *count) {
    int kept = 0, side = *count ? 0 : hits->side;
    for (int i = 0; i < *count; i++) {
        int undecided = hits[i].state == ALGSURF_STATE_UNDECIDED;
        if (undecided && as == ALGSURF_AS_MISS) continue;
        hits[kept] = hits[i];
        if (undecided && as == ALGSURF_AS_HIT) hits[kept].state = ALGSURF_STATE_HIT;
        kept++;
    }
    if (!kept) hits->side = side;
    *count = kept;
}

/* The hits of a ray that lanes left undecided. */
static algsurf_status decide(const algsurf_i_query *q, const algsurf_ray *ray, algsurf_i_want want,
                             algsurf_hit *hits, int *count, uint64_t *exact) {
    algsurf_status status = ALGSURF_OK;
    algsurf_i_chord chord;
    if (q->options.tier == ALGSURF_TIER_BOUNDED) { /* one entry, if the ray meets the region */
        *count = algsurf_i_region_chord(&q->region, ray, &chord);
        hits->side = 0;
        if (*count) algsurf_i_set_undecided(ray, chord.lo, chord.hi, ALGSURF_UNDECIDED_MULTIPLE, hits);
    } else {
        if (exact) ++*exact;
        status = hits_exact(q, ray, want, hits, count);
    }
    if (status == ALGSURF_OK) settle_undecided(q->options.undecided_as, hits, count);
    return status;
}

/* The hits of a checked ray, at most ALGSURF_MAX_DEGREE; tried: lanes have left it undecided.  If there are
 * none, hits->side is that of the miss. */
static algsurf_status find(const algsurf_i_query *q, const algsurf_ray *ray, algsurf_i_want want, int tried,
                           algsurf_hit *hits, int *count, uint64_t *exact) {
    algsurf_status status = ALGSURF_OK;
    *count = tried ? -1 : hits_in_lane(q, ray, want, hits);
    if (*count < 0) status = decide(q, ray, want, hits, count, exact);
    for (int i = 0; i < *count && want != ALGSURF_WANT_ANY && status == ALGSURF_OK; i++)
        algsurf_i_hit_of_power(q, hits + i);
    return status;
}

algsurf_status algsurf_i_first_hit(const algsurf_i_query *q, const algsurf_ray *ray, int tried,
                                   algsurf_hit *hit, uint64_t *exact) {
    algsurf_hit found[ALGSURF_MAX_DEGREE];
    int count;
    algsurf_status status = find(q, ray, ALGSURF_WANT_FIRST, tried, found, &count, exact);
    if (status != ALGSURF_OK) return status;
    if (!count) {
        algsurf_i_set_miss(found, found->side);
        algsurf_i_hit_of_power(q, found);
    }
    *hit = found[0];
    return ALGSURF_OK;
}

algsurf_status algsurf_i_occluded(const algsurf_i_query *q, const algsurf_ray *ray, int tried, int *state) {
    algsurf_hit found[ALGSURF_MAX_DEGREE];
    int count;
    algsurf_status status = find(q, ray, ALGSURF_WANT_ANY, tried, found, &count, NULL);
    if (status != ALGSURF_OK) return status;
    *state = count ? ALGSURF_STATE_UNDECIDED : ALGSURF_STATE_MISS;
    for (int i = 0; i < count; i++)
        if (found[i].state == ALGSURF_STATE_HIT) *state = ALGSURF_STATE_HIT;
    return ALGSURF_OK;
}

/* ---- the public calls ---- */

static algsurf_status prepare(algsurf_i_query *q, const algsurf_surface *surface,
                              const algsurf_extent *extent, const algsurf_ray *ray,
                              const algsurf_intersect_options *options) {
    if (!surface) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_ray_check(ray);
    return status == ALGSURF_OK ? algsurf_i_query_read(q, surface, extent, options) : status;
}

ALGSURF_I_ENTRY(algsurf_status, intersect_first,
                (const algsurf_surface *surface, const algsurf_extent *extent, const algsurf_ray *ray,
                 const algsurf_intersect_options *options, algsurf_hit *hit),
                (surface, extent, ray, options, hit)) {
    algsurf_i_query q;
    if (!hit) return ALGSURF_E_ARGUMENT;
    algsurf_status status = prepare(&q, surface, extent, ray, options);
    return status == ALGSURF_OK ? algsurf_i_first_hit(&q, ray, 0, hit, NULL) : status;
}

ALGSURF_I_ENTRY(algsurf_status, intersect_all,
                (const algsurf_surface *surface, const algsurf_extent *extent, const algsurf_ray *ray,
                 const algsurf_intersect_options *options, algsurf_hit *hits, int capacity, int *count),
                (surface, extent, ray, options, hits, capacity, count)) {
    algsurf_i_query q;
    algsurf_hit found[ALGSURF_MAX_DEGREE];
    int n;
    if (!hits || !count || capacity < 0) return ALGSURF_E_ARGUMENT;
    algsurf_status status = prepare(&q, surface, extent, ray, options);
    if (status == ALGSURF_OK) status = find(&q, ray, ALGSURF_WANT_ALL, 0, found, &n, NULL);
    if (status != ALGSURF_OK) return status;
    if (n > capacity) return ALGSURF_E_CAPACITY;
    memcpy(hits, found, (size_t)n * sizeof *hits);
    *count = n;
    return ALGSURF_OK;
}

ALGSURF_I_ENTRY(algsurf_status, occluded,
                (const algsurf_surface *surface, const algsurf_extent *extent, const algsurf_ray *ray,
                 const algsurf_intersect_options *options, int *state),
                (surface, extent, ray, options, state)) {
    algsurf_i_query q;
    if (!state) return ALGSURF_E_ARGUMENT;
    algsurf_status status = prepare(&q, surface, extent, ray, options);
    return status == ALGSURF_OK ? algsurf_i_occluded(&q, ray, 0, state) : status;
}
