/* certified.c - the roots along a ray, for every tier: what the certified tier does about doubt,
 * and what the caller wants done with the rest.
 *
 * Doubtful places are decided by exact arithmetic.  Places that share a point, for their ends are rounded
 * outward, are decided together, so that no root is found twice.  So are, in this tier, roots that may lie on
 * either side of the extent's surface: the chord is a little longer than the exact one, and if P does not
 * keep its sign on what is too much, the extent takes part in exact arithmetic. */
#include <math.h>

#include "exact.h"
#include "../base/vec.h"

typedef struct answer {
    const algsurf_surface *surface;
    const algsurf_ray *ray;
    const algsurf_i_edges *edges; /* null: no root is close to them */
    const algsurf_intersect_options *options;
    algsurf_i_want want;
    const algsurf_i_frame *frame;
    algsurf_i_ray_root *roots;
    int count, capacity;
} answer;

static int uncertain_among(const algsurf_i_ray_root *roots, int count) {
    for (int i = 0; i < count; i++)
        if (roots[i].state == ALGSURF_UNCERTAIN) return 1;
    return 0;
}

static int satisfied(const answer *a) {
    if (a->count == 0 || a->want == ALGSURF_WANT_ALL) return 0;
    return a->want == ALGSURF_WANT_FIRST || a->roots[0].state == ALGSURF_HIT;
}

/* WANT_ANY keeps one entry, a hit if there is one; else, when there is no room, the last entry grows. */
static void append(answer *a, algsurf_i_ray_root root) {
    if (root.state == ALGSURF_UNCERTAIN && a->options->doubt == ALGSURF_DOUBT_MISS) return;
    if (a->options->doubt == ALGSURF_DOUBT_HIT) root.state = ALGSURF_HIT;
    if (a->want == ALGSURF_WANT_ANY && a->count > 0) {
        if (root.state == ALGSURF_HIT) a->roots[0] = root;
    } else if (a->count < a->capacity) {
        a->roots[a->count++] = root;
    } else {
        algsurf_i_ray_root *last = a->roots + a->count - 1;
        last->state = ALGSURF_UNCERTAIN;
        last->reason = ALGSURF_UNDECIDED_MULTIPLE;
        last->t_hi = root.t_hi;
    }
}

static void append_exact(answer *a, const algsurf_i_exact_root *exact) {
    algsurf_dd s = {ldexp(exact->t.hi, a->frame->exponent), ldexp(exact->t.lo, a->frame->exponent)};
    append(a, (algsurf_i_ray_root){exact->state, exact->reason, 0, algsurf_dd_add_d(s, -a->frame->centre),
                                   exact->lo, exact->hi});
}

/* Entries that overlap, at least one of them uncertain: one entry for all, if exact arithmetic is no help. */
static void decide(answer *a, const algsurf_i_ray_root *group, int count) {
    algsurf_i_exact_root exact[ALGSURF_MAX_DEGREE + 1];
    algsurf_i_ray_root all = group[0];
    for (int i = 1; i < count; i++) {
        double end = fmax(all.t_hi, group[i].t_hi);
        if (all.state == ALGSURF_HIT) all = group[i];
        all.t_hi = end;
    }
    all.t_lo = group[0].t_lo;
    const algsurf_extent *extent = a->edges ? a->edges->extent : NULL;
    algsurf_i_want want = a->options->doubt == ALGSURF_DOUBT_MISS ? ALGSURF_WANT_ALL : a->want;
    int found = algsurf_i_exact_roots(a->surface, a->ray, extent, all.t_lo, all.t_hi, want, exact);
    if (all.state == ALGSURF_HIT) {
        all.state = ALGSURF_UNCERTAIN;
        all.reason = ALGSURF_UNDECIDED_END;
    }
    if (found < 0) append(a, all);
    for (int i = 0; i < found && !satisfied(a); i++) append_exact(a, exact + i);
}

static int touches_edges(const algsurf_i_edges *edges, double lo, double hi) {
    return edges && edges->extent && !(lo >= edges->inner_lo && hi <= edges->inner_hi);
}

/* Is P of one sign for all lo <= t <= hi, which are close together?  In double, at the point between them. */
static int keeps_sign_d(const algsurf_surface *s, const algsurf_ray *ray, double lo, double hi) {
    double x[3], reach[3], middle = 0.5 * lo + 0.5 * hi, half = 0.5 * (hi - lo) + 0x1p-51 * fabs(middle);
    for (int i = 0; i < 3; i++) {
        double at = fma(middle, ray->direction[i], ray->origin[i]);
        x[i] = ldexp(at, -s->unit);
        reach[i] = ldexp(half * fabs(ray->direction[i]), -s->unit) + 0x1p-1000;
        if (at != 0 && !(fabs(x[i]) >= 0x1p-1022)) return 0; /* a part of it underflowed */
    }
    return algsurf_is_finite3(x) && algsurf_is_finite3(reach) &&
           algsurf_i_surface_sign_near(s, x, reach) != 0;
}

/* In double-double: along the chord P is q_0 and at most the sum of the other |q_k|. */
static int keeps_sign_dd(const algsurf_surface *s, const algsurf_ray *ray, double lo, double hi) {
    algsurf_ray chord = *ray;
    algsurf_i_frame f;
    algsurf_dd q[ALGSURF_MAX_DEGREE + 1];
    double r[ALGSURF_MAX_DEGREE + 1];
    chord.t_min = lo;
    chord.t_max = hi;
    algsurf_i_frame_of(s, &chord, 1, &f);
    algsurf_i_expand_dd(s, f.X, f.D, q, r);
    double rest = r[0];
    for (int k = 1; k <= s->degree; k++) rest += fabs(q[k].hi) + r[k];
    return !f.lost && fabs(q[0].hi) > (1 + 0x1p-40) * rest;
}

static int keeps_sign(const algsurf_surface *s, const algsurf_ray *ray, double lo, double hi) {
    return keeps_sign_d(s, ray, lo, hi) || keeps_sign_dd(s, ray, lo, hi);
}

/* May one of the roots, or places, be outside of the extent? */
static int any_at_edges(const algsurf_surface *surface, const algsurf_ray *ray, const algsurf_i_edges *edges,
                        const algsurf_i_ray_root *roots, int count) {
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    for (int i = 0; i < count; i++) {
        lo = fmin(lo, roots[i].t_lo);
        hi = fmax(hi, roots[i].t_hi);
    }
    if (count == 0 || !touches_edges(edges, lo, hi)) return 0;
    if (edges->inner_lo > edges->inner_hi) return 1;
    return (lo < edges->inner_lo && !keeps_sign(surface, ray, ray->t_min, edges->inner_lo)) ||
           (hi > edges->inner_hi && !keeps_sign(surface, ray, edges->inner_hi, ray->t_max));
}

static void decide_all(answer *a, const algsurf_i_ray_root *found, int count) {
    for (int i = 0, next; i < count && !satisfied(a); i = next) {
        double end = found[i].t_hi;
        for (next = i + 1; next < count && found[next].t_lo <= end; next++) end = fmax(end, found[next].t_hi);
        if (a->options->tier == ALGSURF_TIER_CERTIFIED &&
            (uncertain_among(found + i, next - i) || touches_edges(a->edges, found[i].t_lo, end)))
            decide(a, found + i, next - i);
        else
            for (int k = i; k < next && !satisfied(a); k++) append(a, found[k]);
    }
}

int algsurf_i_decided_roots(const algsurf_surface *surface, const algsurf_ray *ray,
                            const algsurf_i_edges *edges, const algsurf_intersect_options *options,
                            algsurf_i_want want, algsurf_i_frame *frame, algsurf_i_ray_root *roots,
                            int capacity) {
    algsurf_i_ray_root found[ALGSURF_MAX_DEGREE + 1];
    int count = algsurf_i_ray_roots(surface, ray, options, want, frame, roots, capacity);
    int looked_at = want == ALGSURF_WANT_ALL ? count : count > 0;
    if (options->tier != ALGSURF_TIER_CERTIFIED && options->doubt == ALGSURF_DOUBT_REPORT) return count;
    if (!uncertain_among(roots, looked_at) && !any_at_edges(surface, ray, edges, roots, looked_at))
        return count;
    int room = surface->degree > 0 ? surface->degree : 1;
    count = algsurf_i_ray_roots(surface, ray, options, ALGSURF_WANT_ALL, frame, found, room);
    if (!any_at_edges(surface, ray, edges, found, count)) edges = NULL; /* what looked first may dissolve */
    answer a = {surface, ray, edges, options, want, frame, roots, 0, capacity};
    decide_all(&a, found, count);
    return a.count;
}
