/* one_ray_template.h - the hits of one ray, all of them or some, in the first of two lanes.
 *
 * The first bracket is that of the packets (packet_template.h), so that its hit has the same bits.  From its
 * end on the walk goes for the next one: with the coefficients that there are, and where
 * these leave it undecided, with those from powers. */
#ifndef ALGSURF_RAYS_ONE_RAY_TEMPLATE_H
#define ALGSURF_RAYS_ONE_RAY_TEMPLATE_H
#include "../roots/refine_impl.h"
#include "along_template.h"
#include "far_template.h"
#include "hits_template.h"

/* One ray on its way. */
typedef struct single_ray {
    const algsurf_i_rays_job *job;
    const algsurf_refine_options *how; /* null: as packets do it */
    ray_lanes ray;
    far_rays ends;
    chord_line line;
    packet k;
    double length, newton; /* of the bracket that the caller's method refines, and the step from its point */
    algsurf_i_watch watch; /* where k says so */
    int from_powers, opened;
} single_ray;

/* x in the bracket's [0,1] as v in the packet's. */
static double in_packet(const single_ray *s, double x) {
    double p = s->k.at.p[0], q = s->k.at.q[0];
    return p + (q - p) * x;
}

/* The point at v in the packet's [0,1], and its t, rounded. */
static lanes point_at(const single_ray *s, double v, lanes x[3]) {
    lanes low, t = exact_sum(s->line.t_c, s->line.h * (2 * v - 1), &low);
    for (int i = 0; i < 3; i++)
        x[i] = along(s->ray.origin[i], low * s->ray.direction[i], t, s->ray.direction[i]);
    return t;
}

/* P itself at x in the bracket's [0,1], and Newton's step from there.  The polynomial along the chord would
 * not do: its rounding, of the whole chord, can move the root by more than the tolerance, on the Barth decic
 * by 5 10^4 times what rounding P at the hit does.  Only at the ends do its values count, whose signs are
 * proved. */
static double bracket_value(double x, void *data) {
    single_ray *s = data;
    lanes at[PAIR][3];
    (void)point_at(s, in_packet(s, x), at[0]);
    jets p = surface_jets(s->job->surface, at, 1);
    const lanes gradient[3] = {p.x[0], p.y[0], p.z[0]};
    double value = p.v[0][0], end = s->k.at.w[x == 0 ? 0 : s->job->surface->node_degree][0];
    s->newton = -value / (dot(gradient, s->ray.direction)[0] * s->length);
    if (x == 0 || x == 1) value = s->k.at.side[0] ? -end : end;
    if (s->k.watch)
        algsurf_i_tell_point(&s->watch, algsurf_i_watched_place(&s->watch, in_packet(s, x)), value, 0,
                             ALGSURF_ENGINE_DOUBLES);
    return value;
}

/* Where the caller's method stops, in the packet's [0,1]. */
static double refine_single(single_ray *s) {
    algsurf_refine_options how = *s->how;
    algsurf_refined_root root = {.root = 0.5};
    s->length = 2 * s->line.h[0] * (s->k.at.q[0] - s->k.at.p[0]);
    how.absolute_tolerance /= s->length * s->ray.t_unit[0];
    (void)algsurf_i_refine_function(bracket_value, s, &s->newton, 0, 1, &how, &root);
    return in_packet(s, root.root);
}

/* The hit at v, where a method has stopped, without a step on P. */
static void hit_as_it_is(const single_ray *s, double v, lanes_hit *hit) {
    lanes x[PAIR][3], normal[3];
    lanes t = point_at(s, v, x[0]);
    jets p = surface_jets(s->job->surface, x, 1);
    normal[0] = p.x[0], normal[1] = p.y[0], normal[2] = p.z[0];
    mask none = unclear(s->job->surface, x[0], normal, all_lanes(0), s->k.hit);
    make_unit(normal);
    hit->t = smaller(larger(t * s->ray.t_unit, hit->t_lo), hit->t_hi);
    for (int i = 0; i < 3; i++)
        hit->position[i] = x[0][i] * s->ray.unit, hit->normal[i] = choose(none, all_lanes(NAN), normal[i]);
}

/* The bracket's hit; 0: it is undecided. */
static int make_hit(single_ray *s, algsurf_hit *to) {
    int wide = s->how && s->how->absolute_tolerance > 0; /* what is asked for is to be seen */
    lanes v;
    lanes_hit hit;
    if (s->how)
        v = all_lanes(refine_single(s));
    else
        refine(&s->k, s->job->surface->node_degree, ROOT_ERROR, &v);
    if (any(s->k.undecided)) return 0;
    find_hits(s->job, &s->ray, s->line.t_c, s->line.h, 2 * v - 1, !wide, 1, &s->k, &hit);
    if (!s->how && any(s->k.undecided)) return 0;
    if (any(s->k.undecided) || wide) {
        s->k.undecided = no_lane();
        hit_as_it_is(s, v[0], &hit);
    }
    to->state = ALGSURF_STATE_HIT;
    to->reason = ALGSURF_OK;
    to->multiplicity = 1;
    to->side = s->k.at.side[0] ? -1 : 1;
    to->t = hit.t[0];
    to->t_lo = hit.t_lo[0];
    to->t_hi = hit.t_hi[0];
    for (int i = 0; i < 3; i++) to->position[i] = hit.position[i][0], to->normal[i] = hit.normal[i][0];
    return 1;
}

static int next_piece(single_ray *s, mask before, mask behind) {
    s->ray.open = go_on(&s->ends, &s->k, before, behind);
    if (any(s->ray.open)) set_piece(&s->ends, &s->ray);
    return any(s->ray.open);
}

/* The first bracket in a piece; returns whether a piece before it comes first. */
static int first_bracket(single_ray *s) {
    int n = s->job->surface->node_degree, own = !s->job->surface->nodes;
    if (n < 1 || n > MOST_DEGREE) __builtin_unreachable();
    s->from_powers = own;
    mask opened = search(s->job, &s->ray, &s->watch, &s->line, &s->k, n), which = opened & s->ends.far;
    if (s->job->any) which &= ~s->k.hit;
    s->opened = any(opened);
    if (!s->opened) return 0;
    if (any(which)) look_about(s->job->surface, &s->line, &s->k, which, n, own, &s->ends);
    mask before = lanes_before(&s->ray, &s->ends, which);
    return any(before) && next_piece(s, before, no_lane());
}

/* The next one. */
static void next_bracket(single_ray *s) {
    int n = s->job->surface->node_degree;
    lanes from = s->k.at.q;
    if (n < 1 || n > MOST_DEGREE) __builtin_unreachable();
    for (int j = 1; !s->from_powers && j <= n; j++) s->k.e[j] = s->k.e[0];
    for (;;) {
        next(&s->k, n, from);
        isolate_known(&s->k, n);
        if (!any(s->k.undecided) || s->from_powers) return;
        s->from_powers = 1;
        coefficients_from_powers(s->job->surface, &s->line, n, s->k.b, s->k.e);
        bound_errors(&s->k, n, 1);
    }
}

static int all_hits(const algsurf_i_rays_job *job, const algsurf_refine_options *how, int most,
                    algsurf_hit *hits) {
    single_ray s; /* a long one, which there is no need to clear */
    int count = 0;
    s.job = job;
    s.how = how;
    double scale = ldexp(1, -job->surface->unit);
    places first;
    set_places(&first, 0, 1);
    load_rays(job, &first, scale, &s.ray);
    clip_rays(job, &first, &s.ray, scale);
    begin_far(job, &first, &s.ray, &s.ends);
    for (;;) {
        if (first_bracket(&s)) continue;
        if (job->any && any(s.k.hit)) return hits->state = ALGSURF_STATE_HIT, 1;
        while (any(s.k.hit & ~s.k.undecided)) {
            if (!make_hit(&s, hits + count)) return -1;
            if (++count == most) return count;
            if (s.k.at.q[0] >= 1) break;
            next_bracket(&s);
        }
        if (any(s.k.undecided)) return -1;
        mask behind = lanes_behind(&s.ray, &s.ends, s.ends.far & s.ray.open);
        if (!any(behind)) {
            if (!count) hits->side = s.opened ? s.k.b[job->surface->node_degree][0] < 0 ? -1 : 1 : 0;
            return count;
        }
        if (!next_piece(&s, no_lane(), behind)) return -1;
    }
}

const algsurf_i_ray_kernel KERNEL(algsurf_i_ray) = {.all = all_hits};

#endif
