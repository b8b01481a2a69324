/* row_template.h - the pixels of a row: the chord inside the extent, as planes cut it, coefficients by
 * Horner's rule in u, and the first root (roots/packet_template.h).
 *
 * Pixels come in segments.  Their chords have a range of depth in common, and Bernstein coefficients over it
 * are made once a segment, as polynomials in u: they have fewer variations of sign than those over all
 * depths, so that most rays that miss show it at once.
 *
 * Ends of chords.  An end is computed for a line of sight: for u, v and the slopes a, b as they are rounded.
 * It stands for the end on the pixel's ray.  So it has two errors: rounding, and the view's noise N, by which
 * points of the ray and of the line differ at most in each of x, y, z.  Both are less than the chord's blur,
 * which is made of
 *     e = 2^-44 + 4 N,  divided by the sine where the line meets the extent or a plane at a slant.
 * What is shown has |X| <= 1; |u| + |a| < 4 and |v| + |b| < 4 (packets.c); N < 2^-22 (view.c).
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
#ifndef ALGSURF_ROW_TEMPLATE_H
#define ALGSURF_ROW_TEMPLATE_H
#include "kernel.h"
#define MOST_DEGREE ALGSURF_MAX_VIEW_DEGREE
#include "../roots/packet_template.h"
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
    lanes inside = all_lanes(r * r) * size - (s->u * s->u + (s->v * s->v + across * across));
    lanes edge = all_lanes(ON_EDGE + 4 * e) * size, half = root(larger(inside, edge));
    lanes inverse = 1 / (size * half), over_size = inverse * half;
    c.near = (-along - half) * over_size;
    c.far = (half - along) * over_size;
    c.blur = all_lanes(e) * (size * size) * inverse;
    c.undecided = at_most(absolute(inside), edge);
    c.far = choose(less(inside, -edge), c.near - 1, c.far); /* surely none: see Edge */
    return c;
}

INLINE chord chord_in_box(const algsurf_i_row_job *job, const sight *s, double e) {
    const double(*axis)[3] = job->view->axis;
    chord c = {all_lanes(-1), all_lanes(1), all_lanes(e), less(s->u, s->u)};
    for (int k = 0; k < 3; k++) {
        lanes at = s->u * all_lanes(axis[0][k]) + s->v * all_lanes(axis[1][k]),
              h = all_lanes(job->extent_size[k]);
        lanes d = s->a * all_lanes(axis[0][k]) + (s->b * all_lanes(axis[1][k]) + all_lanes(axis[2][k]));
        mask along = at_most(absolute(d), all_lanes(PARALLEL));
        lanes safe = choose(along, all_lanes(1), d), one = (-h - at) / safe, two = (h - at) / safe;
        lanes room = h - absolute(at); /* the line's coordinate moves by less than 3 PARALLEL */
        c.near = choose(along, c.near, larger(c.near, smaller(one, two)));
        c.far = choose(along, c.far, smaller(c.far, larger(one, two)));
        c.far = choose(along & less(room, all_lanes(-4 * PARALLEL)), c.near - 1, c.far);
        c.undecided |= along & at_most(absolute(room), all_lanes(4 * PARALLEL));
        c.blur = choose(along, c.blur, larger(c.blur, all_lanes(e) / absolute(safe)));
    }
    c.undecided |= at_most(absolute(c.far - c.near), all_lanes(ON_EDGE));
    return c;
}

/* What a plane keeps of chords.  Where it surely cuts nothing off, it leaves their error as it is. */
INLINE void clip_to_plane(const algsurf_i_row_job *job, const algsurf_i_cut_plane *plane, const sight *s,
                          double e, chord *c) {
    const lanes n[3] = {all_lanes(plane->normal[0]), all_lanes(plane->normal[1]),
                        all_lanes(plane->normal[2])};
    lanes above = n[0] * s->u + (n[1] * s->v - all_lanes(plane->offset + job->plane_room));
    lanes rise = n[0] * s->a + (n[1] * s->b + n[2]), room = all_lanes(4 * (PARALLEL + e));
    mask along = at_most(absolute(rise), all_lanes(PARALLEL)), up = less(all_lanes(0), rise);
    lanes safe = choose(along, all_lanes(1), rise), z = -above / safe, blur = all_lanes(e) / absolute(safe);
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
    double e = 0x1p-44 + 4 * job->view->noise;
    chord c =
        job->extent->kind == ALGSURF_EXTENT_SPHERE ? chord_in_sphere(job, s, e) : chord_in_box(job, s, e);
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

#define BLOCK 8    /* pixels that share a guess, whatever the number of lanes */
#define SEGMENT 64 /* pixels that share a range of depth */

/* A range of depth, z = lo + length tau, and the Bernstein coefficients b_j = sum_m b[j ALGSURF_ROW_STRIDE +
 * m] u^m. */
typedef struct segment {
    double lo, length;
    sight sights[SEGMENT / LANES];
    chord chords[SEGMENT / LANES];
    mask open[SEGMENT / LANES];
    scalar b[(ALGSURF_MAX_VIEW_DEGREE + 1) * ALGSURF_ROW_STRIDE];
} segment;

/* Taylor shift to the middle, scaling, change of basis; for LANES powers of u at a time. */
INLINE void expand_segment(const algsurf_i_row_job *job, segment *s, int n) {
    double half = 0.5 * s->length, middle = s->lo + half;
    for (int m = 0; m <= n; m += LANES) {
        lanes c[ALGSURF_MAX_VIEW_DEGREE + 1], power = all_lanes(1);
        for (int k = 0; k <= n; k++) c[k] = load(job->row->c + k * job->row->stride + m);
        for (int i = 0; i < n; i++)
            for (int k = n - 1; k >= i; k--) c[k] += all_lanes(middle) * c[k + 1];
        for (int k = 1; k <= n; k++) {
            power *= all_lanes(half);
            c[k] *= power;
        }
        for (int j = 0; j <= n; j++) {
            lanes b = c[0];
            for (int k = 1; k <= n; k++) b += all_lanes(job->basis[j * (n + 1) + k]) * c[k];
            __builtin_memcpy(s->b + j * ALGSURF_ROW_STRIDE + m, &b, sizeof b);
        }
    }
}

/* The LANES of them from i on; the last one is repeated behind the end. */
INLINE lanes pixels_from(const algsurf_i_pixels *p, int i) {
    return smaller(all_lanes(p->first + i) + numbered(), all_lanes(p->first + p->count - 1));
}

INLINE sight sight_at(const algsurf_i_row_job *job, lanes pixel) {
    lanes place = (pixel + all_lanes(job->offset)) * all_lanes(job->pixel);
    lanes u = all_lanes(job->u0) + all_lanes(job->du) * place;
    return (sight){.u = u,
                   .a = all_lanes(job->view->alpha) * u + all_lanes(job->view->beta[0]),
                   .v = all_lanes(job->row->v),
                   .b = all_lanes(job->slope)};
}

/* Lines of sight of pixels from i on, chords and their range; returns 0 when there are no chords. */
INLINE int begin_segment(const algsurf_i_row_job *job, const algsurf_i_pixels *p, int first, segment *s) {
    lanes lo = all_lanes(1), hi = all_lanes(-1);
    for (int i = 0; i < SEGMENT / LANES && first + i * LANES < p->count; i++) {
        sight *at = s->sights + i;
        *at = sight_at(job, pixels_from(p, first + i * LANES));
        s->chords[i] = clip(job, at, all_lanes(job->near), s->open + i);
        lanes blur = 2 * s->chords[i].blur;
        lo = choose(s->open[i], smaller(lo, s->chords[i].near - blur), lo);
        hi = choose(s->open[i], larger(hi, s->chords[i].far + blur), hi);
    }
    double least = 1, most = -1;
    for (int l = 0; l < LANES; l++) {
        least = lo[l] < least ? lo[l] : least;
        most = hi[l] > most ? hi[l] : most;
    }
    s->lo = least < -1 ? -1 : least;
    s->length = (most > 1 ? 1 : most) - s->lo;
    return least < most;
}

/* What the coefficients of rays at u are off by at most. */
INLINE lanes radius_at(const algsurf_i_row_job *job, lanes u, int n) {
    lanes x = absolute(u) + absolute(all_lanes(job->view->alpha) * u) +
              all_lanes(fabs(job->view->beta[0]) + job->view->noise);
    lanes radius = all_lanes(0);
    for (int i = n; i >= 0; i--) radius = radius * x + all_lanes(job->row->radius[i]);
    return radius;
}

INLINE void coefficients(const algsurf_i_row_job *job, const segment *s, lanes u, packet *k, int n) {
    for (int j = 0; j <= n; j++) {
        const scalar *c = s->b + j * ALGSURF_ROW_STRIDE;
        lanes sum = all_lanes(c[n]);
        for (int m = n - 1; m >= 0; m--) sum = sum * u + all_lanes(c[m]);
        k->b[j] = sum;
    }
    k->e[0] = radius_at(job, u, n);
}

/* What of the segment's range is the chord. */
INLINE void search_chord(const segment *s, const chord *c, packet *k) {
    lanes scale = all_lanes(1 / s->length), lo = all_lanes(s->lo), blur = c->blur * scale + 0x1p-50;
    k->start = larger(floor40((c->near - lo) * scale - blur), all_lanes(0));
    k->stop = smaller(-floor40(-(c->far - lo) * scale - blur), all_lanes(1));
    k->blur = 2 * blur + 0x1p-39;
}

/* What the pixels before tell: the depths of the last three of a block, if all were hit, and the depths at
 * which the last one was cut to show that it has none. */
typedef struct predictor {
    double last, step, bend;
    int known;
    cuts empty;
} predictor;

INLINE void set_predictor(predictor *t, const double *depth, const uint8_t *state, int end) {
    const double *d = depth + end - 3;
    const uint8_t *s = state + end - 3;
    t->known = (s[0] & s[1] & s[2]) == ALGSURF_LANE_HIT;
    if (!t->known) return;
    t->last = d[2];
    t->step = d[2] - d[1];
    t->bend = d[2] - 2 * d[1] + d[0];
}

/* A parabola through them, for the pixels that come next, wrong by its next difference: taken to be some
 * bends at most. */
INLINE guess guess_from(const predictor *t, const segment *s, int ahead) {
    guess g;
    lanes far = all_lanes(ahead + 1) + numbered(), scale = all_lanes(1 / s->length);
    lanes bend = all_lanes(t->bend), last = all_lanes(t->last);
    g.near = (last + far * all_lanes(t->step) + 0.5 * far * (far + 1) * bend - all_lanes(s->lo)) * scale;
    g.reach = all_lanes(0x1p-6 + 32 * fabs(t->bend)) * scale;
    g.known = less(all_lanes(0), all_lanes(t->known));
    return g;
}

/* The places of cuts between depth and the range of a segment. */
INLINE void cuts_in_segment(const segment *s, const cuts *depths, cuts *c) {
    c->count = 0;
    for (int i = 0; i < depths->count && i < MOST_CUTS; i++) {
        lanes at = floor40(all_lanes((depths->at[i] - s->lo) / s->length));
        if (at[0] > CLOSE_TO_END && at[0] < 1 - CLOSE_TO_END) c->at[c->count++] = at[0];
    }
}

/* What was found of so many lanes, at most. */
INLINE void store_solved(const packet *k, lanes z, int count, double *depth, uint8_t *state) {
    unsigned hits = bits(k->hit), undecided = bits(k->undecided);
    for (int l = 0; l < LANES && l < count; l++) {
        state[l] =
            (uint8_t)(ALGSURF_LANE_HIT * (hits >> l & 1) + ALGSURF_LANE_UNDECIDED * (undecided >> l & 1));
    }
    for (int l = 0; hits && l < LANES && l < count; l++) depth[l] = z[l];
}

/* The pixels from number x on, packet i of the segment; the cuts of its last pixel go to cut. */
INLINE void solve_packet(const algsurf_i_row_job *job, const segment *s, int i, const predictor *t, int x,
                         int end, double *depth, uint8_t *state, cuts *cut, int n) {
    double tolerance = (job->tolerance > ENOUGH ? job->tolerance : ENOUGH) / s->length;
    lanes z = all_lanes(0);
    packet k;
    k.watch = NULL;
    k.open = s->open[i];
    k.undecided = s->chords[i].undecided;
    k.hit = no_lane();
    cut->count = 0;
    if (any(k.open)) {
        coefficients(job, s, s->sights[i].u, &k, n);
        begin(&k, n, 0);
        leave_undecided(&k, ~ends_known(k.b, k.e, n, 0, all_lanes(0)));
        k.open &= ~k.s.none;
    }
    int last_open = bits(k.open) >> (LANES - 1) & 1;
    if (any(k.open)) {
        guess g = guess_from(t, s, i * LANES % BLOCK);
        search_chord(s, s->chords + i, &k);
        bound_errors(&k, n, 0);
        if (t->known) {
            follow(&k, n, &g);
        } else if (t->empty.count > 0 && t->empty.count <= MOST_CUTS) {
            cuts_in_segment(s, &t->empty, cut);
            reuse_cuts(&k, n, cut);
        }
        if (any(k.open)) isolate(&k, n, cut);
        if (any(k.hit)) {
            refine(&k, n, &g, tolerance, &z);
            z = all_lanes(s->lo) + all_lanes(s->length) * z;
        }
        for (int j = 0; j < cut->count && j < MOST_CUTS; j++) cut->at[j] = s->lo + s->length * cut->at[j];
    }
    if (!last_open) cut->count = 0;
    store_solved(&k, z, end - x, depth + x, state + x);
}

INLINE void solve_row_n(const algsurf_i_row_job *job, const algsurf_i_pixels *p, double *depth,
                        uint8_t *state, int n) {
    if (n < 1) __builtin_unreachable();
    predictor t = {0};
    for (int first = 0; first < p->count; first += SEGMENT) {
        segment s;
        cuts cut = {0};
        int stop = first + SEGMENT < p->count ? first + SEGMENT : p->count;
        if (begin_segment(job, p, first, &s)) {
            expand_segment(job, &s, n);
        } else {
            s.length = 1;
        }
        for (int i = 0; first + i * LANES < stop; i++) {
            int at = first + i * LANES;
            solve_packet(job, &s, i, &t, at, stop, depth, state, &cut, n);
            if ((i + 1) * LANES % BLOCK > 0 || at + LANES > stop) continue; /* a short block */
            set_predictor(&t, depth, state, at + LANES);
            t.empty = cut;
        }
    }
}

static void solve_row(const algsurf_i_row_job *job, const algsurf_i_pixels *pixels, double *depth,
                      uint8_t *state) {
    FOR_DEGREE(job->row->degree, solve_row_n(job, pixels, depth, state, N))
}

#endif
