/* packet_template.h - rays in any order, LANES at once: the chord inside the extent, the polynomial along it,
 * its first root (roots/packet_template.h), the point there.
 *
 * Everything is in natural units, but t is the caller's.  The chord [near, far] has the middle t_c and half
 * the length h, both doubles; its points are X(v) = (o + t_c d) + v (h d), -1 <= v <= 1, where the middle
 * M = o + t_c d comes from double-double: a far origin costs no digits.
 *
 * Two ways lead to Bernstein coefficients.  Up to ALGSURF_MAX_NODE_DEGREE P is evaluated at the surface's
 * nodes v_i, and a matrix turns the values into coefficients (surface/nodes.c), which share one error radius.
 * Lanes that this leaves undecided, and all lanes of higher degrees, take powers of v (powers_template.h) and
 * a radius for each coefficient (roots/descartes_template.h): the nodes' matrix amplifies rounding by a
 * factor that doubles with each degree, powers do not.
 *
 * Error of the coefficients from nodes.  Take all magnitudes at reach = |M| + |h d| and let S be P's scheme
 * on them.  M, h d, v_i h d and the sum are rounded: 3 roundings to each of at most n coordinates in a term,
 * beside the 3n + 3 of surface/eval.c for a coordinate with one, so a value is off by (5n+3) u S.  The matrix
 * has relative errors (3n+4) u, the product with it n + 2 roundings; its row sums are at most the surface's
 * amplification A.  Together (9n+9) u A S; the bound used is (10n+20) u A S, for higher orders and the
 * rounding of S; coefficients with an error e of their own add e A S.  The fast tier computes no bound from
 * nodes, and leaves alone chords so long that this one could matter, by their reach (surface/nodes.c).
 *
 * Rounding of M.  It is within u |M| and 2^-100 (|o| + |t_c d|) of the point.  As blur is below 2^-16, |t_c|
 * is below 2^36 h, so the latter is less than 2^-63 (|M| + |h d|).
 *
 * Range.  With reach^n <= 2^280, n <= 64 and fewer than 2^16 terms, S is below 2^296.  An underflow changes a
 * number by 2^-1074, is multiplied by 2^280 and the matrix's entries, below 2^12, at most, and there are
 * fewer than 2^22 of them: UNDERFLOW is more.
 *
 * Error of the ends.  The computed chord is within `off` of the exact one, t_c - h and t_c + h within
 * u (|t_c| + h) of the computed one.  The sum goes to packet.blur: where p keeps its sign that far about both
 * ends, both chords have the same roots. */
#ifndef ALGSURF_RAYS_PACKET_TEMPLATE_H
#define ALGSURF_RAYS_PACKET_TEMPLATE_H
#include "../roots/packet_template.h"
#include "../simd/lanes.h"
#include "../surface/jets_template.h"
#include "kernel.h"

#define UNDERFLOW 0x1p-550
#include "powers_template.h"

#define LEAST_SIZE 0x1p-100 /* of directions: what underflows in them then is far below UNDERFLOW */
#define MOST_SIZE 0x1p100
#define FARTHEST_ORIGIN 0x1p40    /* in radii of the extent: beyond, double-double is not enough */
#define MOST_BLUR 0x1p-16         /* above, the bound on p' holds no more */
#define ROOT_ERROR 0x1p-44        /* in chords: the step on P itself is to be the last one */
#define BLOCK_OF_NODES 7          /* evaluated together, in degrees without code of their own */
#define MOST_NODES 14             /* a multiple of it, above ALGSURF_MAX_NODE_DEGREE */
#define MOST_STEPS 3              /* before the last one */
#define LONGEST_LAST_STEP 0x1p-40 /* in lengths of the bracket, as in intersect.c */

/* LANES rays in natural units. */
typedef struct ray_lanes {
    lanes origin[3], direction[3];
    lanes near, far; /* ends of the chord */
    lanes off;       /* how far another computation may place them */
    mask open, doubtful;
} ray_lanes;

/* x + low + t d, rounded once but for a part 2^-100 of the terms. */
INLINE lanes along(lanes x, lanes low, lanes t, lanes d) {
    lanes product_low, sum_low, sum = exact_sum(exact_product(t, d, &product_low), x, &sum_low);
    return sum + (sum_low + (product_low + low));
}

INLINE lanes largest_of(const lanes v[3]) {
    return larger(larger(absolute(v[0]), absolute(v[1])), absolute(v[2]));
}

/* Of the lanes that have a ray, those whose byte is not 0. */
INLINE mask active_lanes(const unsigned char *active, int count) {
    double on[LANES];
    for (int l = 0; l < LANES; l++) on[l] = l < count && (!active || active[l]);
    return less(all_lanes(0), load(on));
}

INLINE ray_lanes load_rays(const algsurf_i_rays_job *job, size_t at, int count, double scale) {
    ray_lanes r;
    for (int i = 0; i < 3; i++) {
        r.origin[i] = scale * load_some(job->origin[i] + at, count);
        r.direction[i] = scale * load_some(job->direction[i] + at, count);
    }
    r.near = job->t_min ? load_some(job->t_min + at, count) : all_lanes(0);
    r.far = job->t_max ? load_some(job->t_max + at, count) : all_lanes(HUGE_VAL);
    r.off = all_lanes(0);
    lanes size = largest_of(r.direction), most = all_lanes(MOST_SIZE);
    mask plain = less(all_lanes(LEAST_SIZE), size) & less(size, most) & less(largest_of(r.origin), most);
    r.open = active_lanes(job->active ? job->active + at : NULL, count);
    r.doubtful = r.open & ~plain;
    r.open &= plain;
    return r;
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
    r->doubtful |= r->open & ~less(largest_of(q), all_lanes(FARTHEST_ORIGIN * radius));
    r->open &= ~(misses | r->doubtful);
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
        r->doubtful |= r->open & parallel & ~(in | out);
        r->open &= ~(parallel & ~in);
    }
    keep_chord(r, near, far, 0x1p-49 * (absolute(near) + absolute(far)));
}

INLINE void clip_rays(const algsurf_i_rays_job *job, ray_lanes *r, double scale) {
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
    r->open &= ~less(r->far, r->near - 4 * r->off);
}

/* P at `block` points at once: x[0], x[1], x[2] and their coordinates, or the squares of these. */
INLINE void surface_values(const algsurf_surface *s, int block, const lanes *const x[3], lanes *p) {
    lanes level[MOST_NODES], row[MOST_NODES];
    for (int m = 0; m < block; m++) p[m] = all_lanes(0);
    for (int k = s->level_count - 1; k >= 0; k -= s->stride[2]) {
        const algsurf_row *rows = s->rows + s->levels[k].first;
        for (int m = 0; m < block; m++) level[m] = all_lanes(0);
        for (int j = s->levels[k].count - 1; j >= 0; j -= s->stride[1]) {
            const double *c = s->coef + rows[j].first;
            int i = rows[j].length - 1;
            for (int m = 0; m < block; m++) row[m] = all_lanes(i >= 0 ? c[i] : 0);
            for (i -= s->stride[0]; i >= 0; i -= s->stride[0])
                for (int m = 0; m < block; m++) row[m] = row[m] * x[0][m] + c[i];
            for (int m = 0; m < block; m++) level[m] = level[m] * x[1][m] + row[m];
        }
        for (int m = 0; m < block; m++) p[m] = p[m] * x[2][m] + level[m];
    }
}

/* The same scheme on magnitudes at one point. */
INLINE lanes surface_magnitude(const algsurf_surface *s, const lanes x[3]) {
    lanes p = all_lanes(0);
    for (int k = s->level_count - 1; k >= 0; k -= s->stride[2]) {
        const algsurf_row *rows = s->rows + s->levels[k].first;
        lanes level = all_lanes(0);
        for (int j = s->levels[k].count - 1; j >= 0; j -= s->stride[1]) {
            const double *c = s->coef + rows[j].first;
            lanes row = all_lanes(0);
            for (int i = rows[j].length - 1; i >= 0; i -= s->stride[0]) row = row * x[0] + fabs(c[i]);
            level = level * x[1] + row;
        }
        p = p * x[2] + level;
    }
    return p;
}

/* b, from the chord's middle and half of it as a vector. */
INLINE void coefficients_from_nodes(const algsurf_surface *s, const lanes middle[3], const lanes half[3],
                                    lanes *b, int n, int block) {
    lanes x[3][MOST_NODES], p[MOST_NODES];
    for (int i = 0; i < 3; i++) {
        for (int m = 0; m <= n; m++) {
            x[i][m] = middle[i] + s->nodes[m] * half[i];
            if (s->stride[i] == 2) x[i][m] *= x[i][m];
        }
        for (int m = n + 1; m % block; m++) x[i][m] = x[i][n];
    }
    for (int m = 0; m <= n; m += block)
        surface_values(s, block, (const lanes *const[]){x[0] + m, x[1] + m, x[2] + m}, p + m);
    for (int j = 0; j <= n; j++) {
        const double *w = s->to_bernstein + j;
        lanes sum = w[0] * p[0];
        for (int m = 1; m <= n; m++) sum += w[m * ALGSURF_NODE_STRIDE] * p[m];
        b[j] = sum;
    }
}

#define VECTORS ((ALGSURF_NODE_STRIDE + LANES - 1) / LANES)

/* The same for one chord, nodes and then coefficients side by side. */
INLINE void coefficients_of_one_n(const algsurf_surface *s, const double middle[3], const double half[3],
                                  double *b, int vectors) {
    lanes x[3][VECTORS], p[VECTORS], sum[VECTORS];
    double value[VECTORS * LANES];
    int n = s->node_degree;
    if (n >= vectors * LANES) __builtin_unreachable();
    for (int i = 0; i < 3; i++)
        for (int v = 0; v < vectors; v++) {
            x[i][v] = middle[i] + load(s->nodes + v * LANES) * half[i];
            if (s->stride[i] == 2) x[i][v] *= x[i][v];
        }
    surface_values(s, vectors, (const lanes *const[]){x[0], x[1], x[2]}, p);
    for (int v = 0; v < vectors; v++) {
        store(value + v * LANES, p[v]);
        sum[v] = load(s->to_bernstein + v * LANES) * value[0];
    }
    for (int m = 1; m <= n; m++)
        for (int v = 0; v < vectors; v++)
            sum[v] += load(s->to_bernstein + m * ALGSURF_NODE_STRIDE + v * LANES) * value[m];
    for (int v = 0; v < vectors; v++) store(b + v * LANES, sum[v]);
}

/* b has room for ALGSURF_NODE_STRIDE. */
APART void coefficients_of_one(const algsurf_surface *s, const double middle[3], const double half[3],
                               double *b) {
    int vectors = s->node_degree / LANES + 1;
    if (vectors == 1)
        coefficients_of_one_n(s, middle, half, b, 1);
    else if (vectors == 2)
        coefficients_of_one_n(s, middle, half, b, 2);
    else
        coefficients_of_one_n(s, middle, half, b, VECTORS < 4 ? VECTORS : 4);
}

INLINE void set_coefficients_of_one(const algsurf_i_rays_job *job, const chord_line *line, packet *k, int n) {
    double middle[3], half[3], b[ALGSURF_NODE_STRIDE];
    for (int i = 0; i < 3; i++) middle[i] = line->middle[i][0], half[i] = line->half[i][0];
    job->of_one(job->surface, middle, half, b);
    for (int j = 0; j <= n; j++) k->b[j] = all_lanes(b[j]);
}

/* b from nodes, and one radius for all of them. */
INLINE void set_coefficients(const algsurf_i_rays_job *job, const chord_line *line, packet *k, int n,
                             int block) {
    const algsurf_surface *s = job->surface;
    lanes x[3];
    if (LANES == 2 && job->of_one)
        set_coefficients_of_one(job, line, k, n);
    else
        coefficients_from_nodes(s, line->middle, line->half, k->b, n, block);
    k->e[0] = all_lanes(0);
    if (!job->bounded) return;
    for (int i = 0; i < 3; i++) {
        lanes reach = absolute(line->middle[i]) + absolute(line->half[i]);
        x[i] = s->stride[i] == 2 ? reach * reach : reach;
    }
    double factor = (10 * n + 20) * 0x1p-53 + s->error;
    k->e[0] = factor * s->amplification * surface_magnitude(s, x) + UNDERFLOW;
}

/* The chords of open lanes, which [0,1] stands for; those that are too long or too blurred are undecided. */
INLINE void set_chords(const ray_lanes *r, lanes middle, lanes half, double most_reach, chord_line *line,
                       packet *k) {
    lanes reach[3];
    for (int i = 0; i < 3; i++) {
        line->middle[i] = along(r->origin[i], all_lanes(0), middle, r->direction[i]);
        line->half[i] = half * r->direction[i];
        reach[i] = absolute(line->middle[i]) + absolute(line->half[i]);
    }
    k->blur = (r->off + 0x1p-52 * (absolute(middle) + half)) / absolute(half);
    k->doubtful |= k->open & ~less(largest_of(reach), all_lanes(most_reach));
    k->doubtful |= k->open & ~less(k->blur, all_lanes(MOST_BLUR));
    k->open &= ~k->doubtful;
    k->start = all_lanes(-1); /* all of [0,1] is searched, and solve_chords looks at its ends */
    k->stop = all_lanes(2);
}

/* What p changes by within blur of an end where the last coefficients are b, then next, known to e, next_e.
 * There p' = n sum B_j(x) (b_(j+1) - b_j) with |x| <= blur < 2^-16: the first B is below 1 + 2^-10 and the
 * others together below 2 n blur. */
INLINE lanes change_at_end(const packet *k, int n, lanes b, lanes next, lanes e, lanes next_e) {
    lanes slope = absolute(next - b) + (e + next_e) + 4 * n * k->blur * k->largest;
    return (1 + 0x1p-9) * n * k->blur * slope;
}

/* The first roots of open lanes; for `any` a change of sign from end to end is enough.  Undecided are those
 * whose sign at an end of the chord is not known. */
INLINE void solve_chords(const algsurf_i_rays_job *job, packet *k, int n, int own) {
    const lanes *b = k->b, *e = k->e;
    int bounded = own || job->bounded;
    cell *c = &k->at;
    begin(k, n, own);
    bound_errors(k, n, own, bounded);
    lanes near = e[0], far = radius_of(e, n, own);
    if (bounded) {
        near += change_at_end(k, n, b[0], b[1], e[0], radius_of(e, 1, own));
        far += change_at_end(k, n, b[n], b[n - 1], far, radius_of(e, n - 1, own));
    }
    leave_undecided(k, ~(less(near, absolute(b[0])) & less(far, absolute(b[n]))));
    k->open &= ~k->s.none;
    if (job->any) {
        k->hit = k->open & negative((words)c->w[n]);
        k->open &= ~k->hit;
    }
    if (!any(k->open)) return;
    if (own)
        isolate_known(k, n);
    else
        isolate(k, n, NULL);
}

/* By powers, with a radius for each coefficient. */
APART void decide_from_powers(const algsurf_i_rays_job *job, const chord_line *line, packet *k, int n) {
    if (n < 1 || n > ALGSURF_MAX_DEGREE) __builtin_unreachable();
    coefficients_from_powers(job->surface, line, n, k->b, k->e);
    solve_chords(job, k, n, 1);
}

/* Lanes that nodes and one radius for all coefficients left undecided. */
APART void decide_again(const algsurf_i_rays_job *job, const chord_line *line, packet *k, mask which, int n) {
    packet again;
    again.open = which;
    again.doubtful = no_lane();
    again.start = k->start;
    again.stop = k->stop;
    again.blur = k->blur;
    decide_from_powers(job, line, &again, n);
    k->doubtful = (k->doubtful & ~which) | again.doubtful;
    close(k, n, again.hit, &again.at);
}

INLINE void decide_from_nodes(const algsurf_i_rays_job *job, const chord_line *line, packet *k, int n,
                              int block) {
    mask opened = k->open;
    set_coefficients(job, line, k, n, block);
    solve_chords(job, k, n, 0);
    mask again = opened & k->doubtful;
    if (job->bounded && any(again)) decide_again(job, line, k, again, n);
}

INLINE void store_lanes(double *p, lanes a, unsigned which) {
    if (!p) return;
    if (which == (1u << LANES) - 1) {
        store(p, a);
    } else {
        for (int l = 0; l < LANES; l++)
            if (which >> l & 1) p[l] = a[l];
    }
}

/* What becomes of the lanes' hits. */
typedef struct lanes_hit {
    lanes t, t_lo, t_hi, position[3], normal[3];
} lanes_hit;

/* How far from a root the rounding of P and of x alone may show one: 3 n + 3 roundings of P and n of x, twice
 * that for the step and its own value. */
INLINE lanes noise_of_step(const algsurf_surface *s, const lanes x[3], lanes slope) {
    lanes reach[3];
    for (int i = 0; i < 3; i++) reach[i] = absolute(s->stride[i] == 2 ? x[i] * x[i] : x[i]);
    return (8 * s->degree + 16) * 0x1p-53 * surface_magnitude(s, reach) / absolute(slope);
}

/* P's gradient at the points t + low, and a Newton step along the rays on P itself.  Points that are more
 * than `far` from their root, and more than rounding explains, go there first. */
INLINE lanes last_step(const algsurf_surface *s, const ray_lanes *r, mask which, lanes *far, lanes t,
                       lanes *low, lanes x[PAIR][3], lanes gradient[3]) {
    for (int round = 0;; round++) {
        for (int i = 0; i < 3; i++) x[0][i] = along(r->origin[i], *low * r->direction[i], t, r->direction[i]);
        jets p = surface_jets(s, x, 1);
        gradient[0] = p.x[0], gradient[1] = p.y[0], gradient[2] = p.z[0];
        lanes slope = dot(gradient, r->direction), step = -p.v[0] / slope;
        mask again = which & ~at_most(absolute(step), *far);
        if (!any(again)) return step;
        *far = choose(again, larger(*far, noise_of_step(s, x[0], slope)), *far);
        again &= ~at_most(absolute(step), *far);
        if (round == MOST_STEPS || !any(again)) return step;
        *low = choose(again, *low + step, *low); /* the others will compute the same numbers again */
    }
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
    for (int i = 0; i < 3; i++) {
        reach[i] = absolute(x[i]) + 0x1p-30 * (absolute(r->origin[i]) + absolute(half * r->direction[i]));
        if (s->stride[i] == 2) reach[i] *= reach[i];
    }
    double share = (5 * s->degree + 8) * 0x1p-53 + s->error;
    lanes error = share * surface_magnitude(s, reach) + UNDERFLOW;
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

/* From roots v of the polynomials, -1 <= v <= 1, to hits.  A point is kept as t + low: where the origin is
 * far, the rounding of t alone is too much. */
INLINE void find_hits(const algsurf_i_rays_job *job, const ray_lanes *r, lanes middle, lanes half, lanes v,
                      int ends, packet *k, lanes_hit *hit) {
    const cell *c = &k->at;
    lanes low, x[PAIR][3], gradient[3], t = exact_sum(middle, half * v, &low);
    lanes far = 2 * LONGEST_LAST_STEP * half * (c->q - c->p);
    lanes step = last_step(job->surface, r, k->hit, &far, t, &low, x, gradient);
    lanes pad = 0x1p-50 * (absolute(middle) + half), unit = all_lanes(ldexp(1, job->surface->unit));
    hit->t_lo =
        choose(at_most(c->p, all_lanes(0)), r->near, larger(r->near, middle + half * (2 * c->p - 1) - pad));
    hit->t_hi =
        choose(at_most(all_lanes(1), c->q), r->far, smaller(r->far, middle + half * (2 * c->q - 1) + pad));
    hit->t = t + (low + step);
    mask sound = at_most(absolute(step), far);
    sound &= at_most(hit->t_lo - pad, hit->t) & at_most(hit->t, hit->t_hi + pad);
    k->doubtful |= k->hit & ~sound;
    k->hit &= sound;
    hit->t = smaller(larger(hit->t, hit->t_lo), hit->t_hi);
    if (ends) narrow(job->surface, r, half, k, x[0], dot(gradient, r->direction), hit);
    make_unit(gradient);
    for (int i = 0; i < 3; i++) {
        hit->position[i] = (x[0][i] + step * r->direction[i]) * unit;
        hit->normal[i] = gradient[i];
    }
}

INLINE void store_hits(const algsurf_i_rays_job *job, const packet *k, const lanes_hit *hit,
                       const algsurf_i_rays_hits *to, size_t at, unsigned which) {
    lanes none = all_lanes(HUGE_VAL);
    lanes t = choose(k->hit, hit->t, none);
    store_lanes(to->t ? to->t + at : NULL, t, which);
    store_lanes(to->t_lo ? to->t_lo + at : NULL, job->bounded ? choose(k->hit, hit->t_lo, none) : t, which);
    store_lanes(to->t_hi ? to->t_hi + at : NULL, job->bounded ? choose(k->hit, hit->t_hi, none) : t, which);
    for (int i = 0; i < 3; i++) {
        lanes position = choose(k->hit, hit->position[i], all_lanes(0));
        lanes normal = choose(k->hit, hit->normal[i], all_lanes(0));
        store_lanes(to->position[i] ? to->position[i] + at : NULL, position, which);
        store_lanes(to->normal[i] ? to->normal[i] + at : NULL, normal, which);
    }
}

INLINE void solve_rays_n(const algsurf_i_rays_job *job, size_t count, const algsurf_i_rays_hits *hits, int n,
                         int block) {
    if (n < 1 || n > (block ? ALGSURF_MAX_NODE_DEGREE : ALGSURF_MAX_DEGREE)) __builtin_unreachable();
    const guess nowhere = {.known = no_lane()};
    double scale = ldexp(1, -job->surface->unit);
    double reach = job->bounded || !block ? job->surface->most_reach : job->surface->clear_reach;
    for (size_t at = 0; at < count; at += LANES) {
        packet k;
        lanes_hit hit = {.t = all_lanes(0)};
        int left = count - at < LANES ? (int)(count - at) : LANES;
        ray_lanes r = load_rays(job, at, left, scale);
        unsigned which = bits(r.open | r.doubtful);
        if (!which) continue;
        clip_rays(job, &r, scale);
        lanes middle = 0.5 * r.near + 0.5 * r.far, half = 0.5 * r.far - 0.5 * r.near;
        k.open = r.open;
        k.doubtful = r.doubtful;
        k.hit = no_lane();
        if (any(k.open)) {
            chord_line line;
            set_chords(&r, middle, half, reach, &line, &k);
            if (block)
                decide_from_nodes(job, &line, &k, n, block);
            else
                decide_from_powers(job, &line, &k, n);
            if (!job->any && any(k.hit)) {
                lanes v;
                refine(&k, n, &nowhere, ROOT_ERROR, &v);
                find_hits(job, &r, middle, half, 2 * v - 1, job->bounded && (hits->t_lo || hits->t_hi), &k,
                          &hit);
            }
        }
        unsigned found = bits(k.hit), doubts = bits(k.doubtful);
        for (int l = 0; l < left; l++)
            if (which >> l & 1)
                hits->state[at + (size_t)l] = (uint8_t)(ALGSURF_LANE_HIT * (found >> l & 1) +
                                                        ALGSURF_LANE_DOUBTFUL * (doubts >> l & 1));
        unsigned below = bits(negative(k.at.side));
        for (int l = 0; hits->side && l < left; l++)
            if (which >> l & found >> l & 1) hits->side[at + (size_t)l] = below >> l & 1 ? -1 : 1;
        if (!job->any) store_hits(job, &k, &hit, hits, at, which);
    }
}

APART void solve_rays(const algsurf_i_rays_job *job, size_t count, const algsurf_i_rays_hits *hits) {
    int n = job->surface->node_degree;
    if (!job->surface->nodes) {
        solve_rays_n(job, count, hits, n, 0);
        return;
    }
    switch (INSTRUMENTED ? 0 : n) {
    case 2:
        solve_rays_n(job, count, hits, 2, 3);
        break;
    case 3:
        solve_rays_n(job, count, hits, 3, 4);
        break;
    case 4:
        solve_rays_n(job, count, hits, 4, 5);
        break;
    case 6:
        solve_rays_n(job, count, hits, 6, 7);
        break;
    case 8:
        solve_rays_n(job, count, hits, 8, 9);
        break;
    case 10:
        solve_rays_n(job, count, hits, 10, 11);
        break;
    default:
        solve_rays_n(job, count, hits, n, BLOCK_OF_NODES);
    }
}

#endif
