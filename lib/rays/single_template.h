/* single_template.h - the hits of one ray, all of them or some, in the first of two lanes.
 *
 * The first bracket is that of the packets (packet_template.h), so that its hit has the same bits.  From its
 * end on the walk goes for the next one: with the coefficients that there are, and where
 * these leave it undecided, with those from powers. */
#ifndef ALGSURF_RAYS_SINGLE_TEMPLATE_H
#define ALGSURF_RAYS_SINGLE_TEMPLATE_H
#include "packet_template.h"

/* One ray on its way. */
typedef struct single_ray {
    const algsurf_i_rays_job *job;
    const algsurf_refine_options *how; /* null: as packets do it */
    ray_lanes ray;
    chord_line line;
    lanes middle, half;
    packet k;
    algsurf_i_watch watch; /* where k says so */
    int from_powers;
} single_ray;

/* The bracket's polynomial at x in [0,1]. */
static double bracket_value(double x, void *data) {
    const single_ray *s = data;
    double b[ALGSURF_MAX_DEGREE + 1];
    int n = s->job->surface->node_degree;
    for (int j = 0; j <= n; j++) b[j] = s->k.at.w[j][0];
    for (int i = 1; i <= n; i++)
        for (int j = 0; j <= n - i; j++) b[j] = (1 - x) * b[j] + x * b[j + 1];
    return b[0];
}

/* A point of that, to whoever watches. */
static void tell_bracket_point(double x, double value, int engine, void *data) {
    const single_ray *s = data;
    double p = s->k.at.p[0], q = s->k.at.q[0];
    algsurf_i_tell_point(&s->watch, algsurf_i_watched_place(&s->watch, p + (q - p) * x),
                         s->k.at.side[0] ? -value : value, 0, engine);
}

/* Its coefficients of x^k: differences of those that there are, times binomials. */
static void bracket_powers(const single_ray *s, double *c) {
    int n = s->job->surface->node_degree;
    double binomial = 1;
    for (int j = 0; j <= n; j++) c[j] = s->k.at.w[j][0];
    for (int i = 1; i <= n; i++)
        for (int j = n; j >= i; j--) c[j] -= c[j - 1];
    for (int k = 1; k <= n; k++) {
        binomial = binomial * (n - k + 1) / k;
        c[k] *= binomial;
    }
}

/* The root in the bracket by the caller's method, in the packet's [0,1]. */
static double refine_single(const single_ray *s) {
    double width = s->k.at.q[0] - s->k.at.p[0], c[ALGSURF_MAX_DEGREE + 1];
    algsurf_refine_options how = *s->how;
    algsurf_refined_root root = {.root = 0.5};
    algsurf_observer told = {.size = sizeof told, .data = (void *)s, .on_point = tell_bracket_point};
    how.observer = s->k.watch ? &told : NULL;
    how.absolute_tolerance /= (2 * s->half[0] * s->ray.t_unit[0] * width);
    bracket_powers(s, c);
    if (how.method != ALGSURF_METHOD_DEFAULT ||
        algsurf_refine_poly(c, NULL, s->job->surface->node_degree, 0, 1, &how, &root) < 0)
        (void)algsurf_refine_function(bracket_value, (void *)s, 0, 1, &how, &root);
    return s->k.at.p[0] + width * root.root;
}

/* The hit where a method has stopped too far from the root for the last step. */
static void hit_as_it_is(single_ray *s, lanes v, lanes_hit *hit) {
    lanes x[PAIR][3], low, normal[3];
    lanes t = exact_sum(s->middle, s->half * v, &low);
    for (int i = 0; i < 3; i++)
        x[0][i] = along(s->ray.origin[i], low * s->ray.direction[i], t, s->ray.direction[i]);
    jets p = surface_jets(s->job->surface, x, 1);
    normal[0] = p.x[0], normal[1] = p.y[0], normal[2] = p.z[0];
    make_unit(normal);
    hit->t = smaller(larger(t * s->ray.t_unit, hit->t_lo), hit->t_hi);
    for (int i = 0; i < 3; i++) hit->position[i] = x[0][i] * s->ray.unit, hit->normal[i] = normal[i];
}

/* The bracket's hit; 0: it is undecided. */
static int make_hit(single_ray *s, algsurf_hit *to) {
    const guess nowhere = {.known = no_lane()};
    int wide = s->how && s->how->absolute_tolerance > 0; /* what is asked for is to be seen */
    lanes v;
    lanes_hit hit;
    if (s->how)
        v = all_lanes(refine_single(s));
    else
        refine(&s->k, s->job->surface->node_degree, &nowhere, ROOT_ERROR, &v);
    if (any(s->k.doubtful)) return 0;
    find_hits(s->job, &s->ray, s->middle, s->half, 2 * v - 1, s->job->bounded && !wide, &s->k, &hit);
    if (!s->how && any(s->k.doubtful)) return 0;
    if (any(s->k.doubtful) || wide) {
        s->k.doubtful = no_lane();
        hit_as_it_is(s, 2 * v - 1, &hit);
    }
    to->state = ALGSURF_HIT;
    to->reason = ALGSURF_OK;
    to->multiplicity = 1;
    to->side = s->k.at.side[0] ? -1 : 1;
    to->t = hit.t[0];
    to->t_lo = s->job->bounded ? hit.t_lo[0] : to->t;
    to->t_hi = s->job->bounded ? hit.t_hi[0] : to->t;
    for (int i = 0; i < 3; i++) to->position[i] = hit.position[i][0], to->normal[i] = hit.normal[i][0];
    return 1;
}

/* The first bracket, as solve_rays_n finds it. */
static void first_bracket(single_ray *s) {
    int n = s->job->surface->node_degree;
    if (!s->job->surface->nodes) {
        s->from_powers = 1;
        decide_from_powers(s->job, &s->line, &s->k, n);
        return;
    }
    FOR_DEGREE(n, decide_from_nodes(s->job, &s->line, &s->k, N, N < MOST_NODES ? N + 1 : BLOCK_OF_NODES))
    for (int j = 1; j <= n; j++) s->k.e[j] = s->k.e[0];
}

/* The next one. */
static void next_bracket(single_ray *s) {
    int n = s->job->surface->node_degree;
    lanes from = s->k.at.q;
    for (;;) {
        next(&s->k, n, from);
        isolate_known_often(&s->k, n);
        if (!any(s->k.doubtful) || s->from_powers) return;
        s->from_powers = 1;
        coefficients_from_powers(s->job->surface, &s->line, n, s->k.b, s->k.e);
        bound_errors(&s->k, n, 1, 1);
    }
}

static int all_hits(const algsurf_i_rays_job *job, const algsurf_refine_options *how, int most,
                    algsurf_hit *hits) {
    single_ray s = {.job = job, .how = how};
    int count = 0;
    double scale = ldexp(1, -job->surface->unit);
    double reach =
        job->bounded || !job->surface->nodes ? job->surface->most_reach : job->surface->clear_reach;
    s.ray = load_rays(job, 0, 1, scale);
    clip_rays(job, &s.ray, scale);
    s.middle = 0.5 * s.ray.near + 0.5 * s.ray.far;
    s.half = 0.5 * s.ray.far - 0.5 * s.ray.near;
    s.k.watch = watch_chord(job, &s.ray, &s.watch);
    s.k.open = s.ray.open;
    s.k.doubtful = s.ray.doubtful;
    s.k.hit = no_lane();
    if (any(s.k.open)) set_chords(&s.ray, s.middle, s.half, reach, &s.line, &s.k);
    if (any(s.k.open)) first_bracket(&s);
    for (;;) {
        if (any(s.k.doubtful)) return -1;
        if (!any(s.k.hit)) return count;
        if (!make_hit(&s, hits + count)) return -1;
        if (++count == most || s.k.at.q[0] >= 1) return count;
        next_bracket(&s);
    }
}

const algsurf_i_ray_kernel KERNEL(algsurf_i_ray) = {.first = solve_rays, .all = all_hits};

#endif
