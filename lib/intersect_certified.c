/* intersect_certified.c - the roots along a ray, for every tier: what the certified tier does about doubt,
 * and what the caller wants done with the rest.
 *
 * Doubtful places are decided by exact arithmetic.  Places that share a point, for their ends are rounded
 * outward, are decided together, so that no root is found twice. */
#include <math.h>

#include "intersect_exact.h"

typedef struct answer {
    const algsurf_surface *surface;
    const algsurf_ray *ray;
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
    int found = algsurf_i_exact_roots(a->surface, a->ray, all.t_lo, all.t_hi, a->want, exact);
    if (found < 0) append(a, all);
    for (int i = 0; i < found && !satisfied(a); i++) append_exact(a, exact + i);
}

static void decide_all(answer *a, const algsurf_i_ray_root *found, int count) {
    for (int i = 0, next; i < count && !satisfied(a); i = next) {
        double end = found[i].t_hi;
        for (next = i + 1; next < count && found[next].t_lo <= end; next++) end = fmax(end, found[next].t_hi);
        if (a->options->tier == ALGSURF_TIER_CERTIFIED && uncertain_among(found + i, next - i))
            decide(a, found + i, next - i);
        else
            for (int k = i; k < next && !satisfied(a); k++) append(a, found[k]);
    }
}

int algsurf_i_decided_roots(const algsurf_surface *surface, const algsurf_ray *ray,
                            const algsurf_intersect_options *options, algsurf_i_want want,
                            algsurf_i_frame *frame, algsurf_i_ray_root *roots, int capacity) {
    algsurf_i_ray_root found[ALGSURF_MAX_DEGREE + 1];
    int count = algsurf_i_ray_roots(surface, ray, options, want, frame, roots, capacity);
    int looked_at = want == ALGSURF_WANT_ALL ? count : count > 0;
    if ((options->tier != ALGSURF_TIER_CERTIFIED && options->doubt == ALGSURF_DOUBT_REPORT) ||
        !uncertain_among(roots, looked_at))
        return count;
    answer a = {surface, ray, options, want, frame, roots, 0, capacity};
    int room = surface->degree > 0 ? surface->degree : 1;
    count = algsurf_i_ray_roots(surface, ray, options, ALGSURF_WANT_ALL, frame, found, room);
    decide_all(&a, found, count);
    return a.count;
}
