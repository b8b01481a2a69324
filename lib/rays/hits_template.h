/* hits_template.h - from the roots of LANES polynomials along rays to points, normals and intervals of t. */
#ifndef ALGSURF_HITS_TEMPLATE_H
#define ALGSURF_HITS_TEMPLATE_H
#include "../roots/first_walk_template.h"
#include "../surface/jets_template.h"
#include "chord_template.h"
#include "nodes_template.h"

#define ROOT_ERROR 0x1p-44        /* in chords: the step on P itself is to be the last one */
#define MOST_STEPS 3              /* before the last one; 32, more than there can be, where t cancels */
#define LONGEST_LAST_STEP 0x1p-40 /* in lengths of the bracket, as in intersect.c */

/* What becomes of the lanes' hits, with the caller's t. */
typedef struct lanes_hit {
    lanes t, t_lo, t_hi, position[3], normal[3];
} lanes_hit;

/* How far from a root the rounding of P and of x alone may show one: 3 n + 3 roundings of P and n of x, twice
 * that for the step and its own value. */
INLINE lanes noise_of_step(const algsurf_surface *s, const lanes x[3], lanes slope) {
    const lanes reach[3] = {absolute(x[0]), absolute(x[1]), absolute(x[2])};
    return (8 * s->degree + 16) * 0x1p-53 * surface_magnitude(s, reach) / absolute(slope);
}

/* P's gradient at the points t + low, and a Newton step along the rays on P itself.  Points go there first
 * that are more than `far` from their root; and those of which t cancels, being next to 0, so that rounding
 * of the step is more than that of t; both by more than rounding of P explains. */
INLINE lanes last_step(const algsurf_surface *s, const ray_lanes *r, mask which, lanes *far, lanes *t,
                       lanes *low, lanes x[PAIR][3], lanes gradient[3], const algsurf_i_watch *watch) {
    for (int round = 0;; round++) {
        for (int i = 0; i < 3; i++)
            x[0][i] = along(r->origin[i], *low * r->direction[i], *t, r->direction[i]);
        jets p = surface_jets(s, x, 1);
        if (watch && bits(which) & 1)
            algsurf_i_tell_point(watch, ((*t)[0] + (*low)[0]) * r->t_unit[0], p.v[0][0], 0,
                                 ALGSURF_ENGINE_DOUBLES);
        gradient[0] = p.x[0], gradient[1] = p.y[0], gradient[2] = p.z[0];
        lanes slope = dot(gradient, r->direction), step = -p.v[0] / slope;
        mask again = which & ~at_most(absolute(step), *far);
        mask cancels = which & ~again & less(4 * absolute(*t + (*low + step)), absolute(step));
        if (!any(again | cancels)) return step;
        lanes noise = noise_of_step(s, x[0], slope), sum;
        *far = choose(again, larger(*far, noise), *far);
        again = round < MOST_STEPS ? again & ~at_most(absolute(step), *far) : no_lane();
        again |= cancels & ~at_most(absolute(step), noise);
        if (round == 32 || !any(again)) return step;
        *low = choose(again, *low + step, *low); /* the others will compute the same numbers again */
        sum = exact_sum(*t, *low, low);
        *t = sum;
    }
}

/* The same, for whoever watches: apart from what nobody watches, which then keeps its registers. */
APART void tell_last_step(const algsurf_surface *s, const ray_lanes *r, const packet *k,
                          const lanes far_t_low[3]) {
    lanes x[PAIR][3], gradient[3], far = far_t_low[0], t = far_t_low[1], low = far_t_low[2];
    (void)last_step(s, r, k->hit, &far, &t, &low, x, gradient, k->watch);
}

/* [t_lo,t_hi] around t, narrower than the bracket where the signs of P itself show it.
 *
 * P(X(t)) at a double t is off by at most E: `along` rounds X once, but for 2^-100 (|o| + |t d|), which 2^-30
 * |o| in the magnitudes takes in, as 2^-30 |h d| does the way from x to the ends; each of at most n
 * coordinates in a term brings that rounding and that of its square, the scheme 3 n + 3 more
 * (surface/eval.c): (5 n + 3) u S, taken as (5 n + 8).  The ends are put where |P| is about 3 E, hence where
 * the computed value exceeds E: then its sign is P's, and if it is the one that the bracket has on that side,
 * the root, the only one in the bracket, lies between. */
INLINE void narrow(const algsurf_surface *s, const ray_lanes *r, lanes half, const packet *k,
                   const lanes x[3], lanes slope, lanes_hit *hit) {
    lanes reach[3], end[3][PAIR], p[PAIR];
    for (int i = 0; i < 3; i++)
        reach[i] = absolute(x[i]) + 0x1p-30 * (absolute(r->origin[i]) + absolute(half * r->direction[i]));
    double share = (5 * s->degree + 8) * 0x1p-53 + s->error;
    lanes error = share * surface_magnitude(s, reach) + LOST_BY_UNDERFLOW;
    lanes pad = 3 * error / absolute(slope) + 0x1p-52 * absolute(hit->t),
          t[PAIR] = {hit->t - pad, hit->t + pad};
    for (int m = 0; m < PAIR; m++)
        for (int i = 0; i < 3; i++) {
            end[i][m] = along(r->origin[i], all_lanes(0), t[m], r->direction[i]);
            if (s->stride[i] == 2) end[i][m] *= end[i][m];
        }
    surface_values(s, PAIR, (const lanes *const[]){end[0], end[1], end[2]}, p);
    mask close = less(pad, 0x1p-32 * half); /* so that reach is enough */
    mask before = close & less(error, (lanes)((words)p[0] ^ k->at.side));
    mask behind = close & less((lanes)((words)p[1] ^ k->at.side), -error);
    hit->t_lo = choose(before, larger(hit->t_lo, t[0]), hit->t_lo);
    hit->t_hi = choose(behind, smaller(hit->t_hi, t[1]), hit->t_hi);
}

/* Lanes of which the gradient at x is not known to be that at the hit, a step away, to what ALGSURF_I_CLEAR
 * asks for: their normals are NaN, and found apart (normal.c).
 *
 * With S, P's scheme on magnitudes at |x|, rounding puts S_i off by (4 n + 8) u S_i at most (surface/eval.c),
 * a step along r, |r_j| < 2, by 2 |step| sum_j S_ij.  With L = max(1, |x|) and the sum A of the coefficients'
 * sizes S_i <= n A L^(n-1), and that sum is at most 63 / L times as much.  S is convex: with all coordinates
 * larger by d, S_i <= S / d and sum_j S_ij <= 4 S / d^2.  For d = L / 8 both times the error is below (4 n +
 * 8) u + 128 |step| / L times the bound on S_i. */
APART mask unclear_by_terms(const algsurf_surface *s, const lanes x[3], lanes size, lanes error,
                            lanes gradient) {
    lanes d = 0.125 * size, reach[3] = {absolute(x[0]) + d, absolute(x[1]) + d, absolute(x[2]) + d};
    return ~less(error * surface_magnitude(s, reach), d * gradient);
}

INLINE mask unclear(const algsurf_surface *s, const lanes x[3], const lanes gradient[3], lanes step,
                    mask which) {
    lanes size = larger(all_lanes(1), largest_size(x)), power = all_lanes(s->degree * s->size);
    lanes error = ALGSURF_I_CLEAR * ((4 * s->degree + 8) * 0x1p-53 * size + 128 * absolute(step));
    lanes gradient_size = largest_size(gradient) * size; /* like the error, times L */
    for (int i = 1; i < s->degree; i++) power *= size;
    mask not_yet = which & ~less(power * error, gradient_size);
    return any(not_yet) ? not_yet & unclear_by_terms(s, x, size, error, gradient_size) : not_yet;
}

/* From roots v of the polynomials, -1 <= v <= 1, to hits.  A point is kept as t + low: where the origin is
 * far, the rounding of t alone is too much. */
INLINE void find_hits(const algsurf_i_rays_job *job, const ray_lanes *r, lanes middle, lanes half, lanes v,
                      int ends, int normals, packet *k, lanes_hit *hit) {
    const cell *c = &k->at;
    lanes low, x[PAIR][3], gradient[3], t = exact_sum(middle, half * v, &low);
    lanes far = 2 * LONGEST_LAST_STEP * half * (c->q - c->p);
    if (watch_of(k)) {
        const lanes begin[3] = {far, t, low};
        tell_last_step(job->surface, r, k, begin);
    }
    lanes step = last_step(job->surface, r, k->hit, &far, &t, &low, x, gradient, NULL);
    lanes pad = 0x1p-50 * (absolute(middle) + half);
    hit->t_lo =
        choose(at_most(c->p, all_lanes(0)), r->near, larger(r->near, middle + half * (2 * c->p - 1) - pad));
    hit->t_hi =
        choose(at_most(all_lanes(1), c->q), r->far, smaller(r->far, middle + half * (2 * c->q - 1) + pad));
    hit->t = t + (low + step);
    mask sound = at_most(absolute(step), far);
    sound &= at_most(hit->t_lo - pad, hit->t) & at_most(hit->t, hit->t_hi + pad);
    sound &= less(all_lanes(LEAST_CHORD), half * r->t_unit);
    k->undecided |= k->hit & ~sound;
    k->hit &= sound;
    hit->t = smaller(larger(hit->t, hit->t_lo), hit->t_hi);
    if (ends) narrow(job->surface, r, half, k, x[0], dot(gradient, r->direction), hit);
    hit->t *= r->t_unit;
    hit->t_lo *= r->t_unit;
    hit->t_hi *= r->t_unit;
    mask none = normals ? unclear(job->surface, x[0], gradient, step, k->hit) : no_lane();
    make_unit(gradient);
    for (int i = 0; i < 3; i++) {
        hit->position[i] = (x[0][i] + step * r->direction[i]) * r->unit;
        hit->normal[i] = choose(none, all_lanes(NAN), gradient[i]);
    }
}

#endif
