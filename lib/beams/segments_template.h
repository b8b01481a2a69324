/* segments_template.h - which rays from points of the surface meet it: those of lights' places, and those
 * around a point.
 *
 * LANES points are done side by side, one ray of each after the other: P's Taylor expansion about them
 * (surface/taylor.h) is made once, the polynomial along each ray comes from it.  What is asked is whether it
 * changes its sign within the extent, not where.  So a ray is done as soon as P surely has the other sign
 * somewhere, or the cells from its point to where it leaves the extent have no variation of sign.
 *
 * Ends.  A ray leaves the extent between (1 - gap) and 1 times what is searched of it.  What is found at t
 * counts if P is beyond zero by more than it can change by within gap: |dP/dt| <= 2 n max|b|.
 * In a ball about 0 a ray x + tau d ends at tau = (D - b) / a, with a = |d|^2, b = x d, c = R^2 - |x|^2 and
 * D^2 = b^2 + a c.  The ends for a narrow and a wide R differ by the difference of their R^2 over the sum of
 * their D, at most by w / D, with w that difference and the wide D: w / (D (D - b) / a) of the end.  If b <=
 * 0, D (D - b) >= D^2 >= a c; if not, D - b = a c / (D + b) >= a c / (2 D).  So gap = 2 w / c will do for all
 * rays from x.
 *
 * Errors: those of taylor.c, and 8 n u max|b| for each of two cuts at a turn (descartes_template.h). */
#ifndef ALGSURF_SEGMENTS_TEMPLATE_H
#define ALGSURF_SEGMENTS_TEMPLATE_H
#include "../poly/triangle_template.h"
#include "../roots/first_walk_template.h"
#include "ends_template.h"
#include "lattice_template.h"

#define TAYLOR_DEGREE ALGSURF_MAX_TAYLOR_DEGREE
#define SHORTEST_END 0x1p-60 /* of a ray that begins outside and stays there */
#define SEGMENT_TURNS 6      /* cells of a ray, besides the first */

#define FOR_RAY_DEGREE(n, statement)                                                                         \
    FOR_DEGREES(COMMON_DEGREES, n, statement,                                                                \
                DEGREES_2_TO_4(statement) FOR_ONE_DEGREE(5, statement) FOR_ONE_DEGREE(6, statement)          \
                    FOR_ONE_DEGREE(7, statement) FOR_ONE_DEGREE(8, statement) FOR_ONE_DEGREE(9, statement)   \
                        FOR_ONE_DEGREE(10, statement))

/* ---- points ---- */

enum { TO_LIGHTS, AROUND, KINDS }; /* of rays */

/* P about LANES points: r_ijk over (n over i + j + k), in the order of i, then j, then k, with the sign that
 * makes r_000 positive.  error: of Bernstein coefficients of its rays, which are no larger than `size`, by
 * their kind. */
typedef struct solid_packet {
    lanes x[3], error[KINDS], size[KINDS], r[ALGSURF_I_SOLID(TAYLOR_DEGREE)];
    lanes room, gap;    /* of a ball: the square of its wide radius, less |x|^2; of all rays */
    mask known, inside; /* P's sign at x is; x is within the extent */
} solid_packet;

/* a += x b, b of degree n - 1. */
INLINE void add_row(lanes *a, const lanes *b, int n, lanes x) {
    for (int k = 0; k < n; k++) a[k] += x * b[k];
}

/* S of taylor.c. */
APART lanes size_about(const algsurf_i_frame_form *frame, const lanes x[3], int n) {
    lanes whole = all_lanes(0);
    for (int i = n; i >= 0; i--) {
        lanes level = all_lanes(0);
        for (int j = n - i; j >= 0; j--) {
            lanes row = all_lanes(0);
            for (int k = n - i - j; k >= 0; k--)
                row = row * x[2] + fabs(frame->q[(i * (n + 1) + j) * (n + 1) + k]);
            level = level * x[1] + row;
        }
        whole = whole * x[0] + level;
    }
    return whole;
}

/* span: bounds |d_k| of rays, by their kind. */
INLINE void expand_solids_n(const algsurf_i_taylor *taylor, lanes span[KINDS][3], solid_packet *s, int n) {
    lanes *row[TAYLOR_DEGREE + 1][TAYLOR_DEGREE + 1], *r = s->r, at[3];
    for (int i = 0; i <= n; i++) {
        for (int j = 0; i + j <= n; j++) {
            row[i][j] = r;
            for (int k = 0; i + j + k <= n; k++)
                *r++ = all_lanes(taylor->frame.q[(i * (n + 1) + j) * (n + 1) + k]);
            shift_levels(row[i][j], n - i - j, s->x[2], n - i - j);
        }
        for (int m = 0; i + m < n; m++)
            for (int j = n - i - 1; j >= m; j--) add_row(row[i][j], row[i][j + 1], n - i - j, s->x[1]);
    }
    for (int j = 0; j < n; j++)
        for (int m = 0; j + m < n; m++)
            for (int i = n - j - 1; i >= m; i--) add_row(row[i][j], row[i + 1][j], n - i - j, s->x[0]);
    for (int k = 0; k < 3; k++) at[k] = absolute(s->x[k]);
    for (int kind = 0; kind < KINDS; kind++) {
        for (int k = 0; k < 3; k++) span[kind][k] += at[k];
        s->size[kind] = size_about(&taylor->frame, span[kind], n);
        s->error[kind] = taylor->weight * s->size[kind] + taylor->least_error;
    }
    s->known =
        less(taylor->weight * size_about(&taylor->frame, at, n) + taylor->least_error, absolute(s->r[0]));
    const lanes sign = choose(less(s->r[0], all_lanes(0)), all_lanes(-1), all_lanes(1));
    r = s->r;
    for (int i = 0; i <= n; i++)
        for (int j = 0; i + j <= n; j++)
            for (int k = 0; i + j + k <= n; k++) *r++ *= taylor->inverse[i + j + k] * sign;
}

APART void expand_solids(const algsurf_i_taylor *taylor, lanes span[KINDS][3], solid_packet *s, int n) {
    FOR_RAY_DEGREE(n, expand_solids_n(taylor, span, s, N))
}

/* ---- rays ---- */

/* One ray of each point.  Searched is x + t d, 0 <= t <= 1; within the extent are those up to t = 1 - gap,
 * and none beyond. */
typedef struct ray_packet {
    int kind;
    lanes d[3], gap;
    mask open, hit; /* those to be decided; those with a root */
} ray_packet;

/* P along them: Bernstein coefficients. */
INLINE void expand_rays_n(const solid_packet *s, const lanes d[3], lanes *c, int n) {
    const lanes *r = s->r + ALGSURF_I_SOLID(n);
    lanes power[TAYLOR_DEGREE + 1], level[TAYLOR_DEGREE + 1];
    power[1] = d[2];
    UNROLLED
    for (int k = 2; k <= TAYLOR_DEGREE; k++) power[k] = power[k - 1] * d[2];
    UNROLLED
    for (int i = n; i >= 0; i--) {
        UNROLLED
        for (int j = n - i; j >= 0; j--) {
            r -= n - i - j + 1;
            UNROLLED
            for (int k = n - i - j; k > 0; k--) level[k] = r[k] * power[k] + d[1] * level[k - 1];
            level[0] = r[0];
        }
        UNROLLED
        for (int k = n - i; k > 0; k--) c[k] = level[k] + d[0] * c[k - 1];
        c[0] = level[0];
    }
    UNROLLED
    for (int m = 1; m <= n; m++) {
        UNROLLED
        for (int k = n; k >= m; k--) c[k] += c[k - 1];
    }
}

/* No coefficient behind the first may be negative. */
INLINE mask all_positive(const lanes *w, lanes error, int n) {
    lanes least = w[1];
    for (int m = 2; m <= n; m++) least = smaller(least, w[m]);
    return at_most(error, least);
}

/* A cell of each ray that is open, error: of its coefficients.  What is known to have no root is closed, what
 * is known to have one is closed and a hit.  Returns the cells without a root. */
INLINE mask close_rays(const cell *c, lanes error, ray_packet *k, int n) {
    mask none = k->open & all_positive(c->w, error, n);
    mask crossed = k->open & less(error + k->gap, -c->w[n]);
    k->hit |= crossed;
    k->open &= ~(crossed | (none & at_most(all_lanes(1), c->q)));
    return none;
}

/* Where `on`: the left part of the cell, or, if that has no root, the right one. */
INLINE void halve_cell(cell *c, lanes error, mask on, int turn, int n) {
    lanes at = split_point(c, n, turn), left[TAYLOR_DEGREE + 1], right[TAYLOR_DEGREE + 1];
    for (int m = 0; m <= n; m++) right[m] = c->w[m];
    split(right, left, n, at - c->p, c->q - at);
    mask go_right = on & all_positive(left, error, n), go_left = on & ~go_right;
    for (int m = 0; m <= n; m++) c->w[m] = choose(go_right, right[m], choose(go_left, left[m], c->w[m]));
    c->p = choose(go_right, at, c->p);
    c->q = choose(go_left, at, c->q);
}

/* Where `again`: what is behind the cell. */
INLINE void cut_rest(cell *c, const lanes *whole, mask again, int n) {
    lanes from = choose(again, c->q, all_lanes(0)), left[TAYLOR_DEGREE + 1], rest[TAYLOR_DEGREE + 1];
    for (int m = 0; m <= n; m++) rest[m] = whole[m];
    split_shares(rest, left, n, from, 1 - from);
    for (int m = 0; m <= n; m++) c->w[m] = choose(again, rest[m], c->w[m]);
    c->p = choose(again, c->q, c->p);
    c->q = choose(again, all_lanes(1), c->q);
}

INLINE void judge_rays_n(const solid_packet *s, ray_packet *k, int n) {
    lanes whole[TAYLOR_DEGREE + 1], error = s->error[k->kind], gap = k->gap, largest = error;
    cell c;
    c.p = all_lanes(0), c.q = all_lanes(1);
    expand_rays_n(s, k->d, c.w, n);
    /* What P can change by within it; at first a larger bound, which costs less. */
    k->gap = 2 * n * s->size[k->kind] * gap;
    mask none = close_rays(&c, error, k, n);
    if (!any(k->open)) return;
    for (int m = 0; m <= n; m++) {
        whole[m] = c.w[m];
        largest = larger(largest, absolute(c.w[m]));
    }
    k->gap = 2 * n * largest * gap;
    for (int turn = 0; turn < SEGMENT_TURNS && any(k->open); turn++) {
        mask again = k->open & none, on = k->open & ~none;
        error += 16 * n * 0x1p-53 * largest;
        if (any(on)) halve_cell(&c, error, on, turn, n);
        if (any(again)) cut_rest(&c, whole, again, n);
        none = close_rays(&c, error, k, n);
    }
}

APART void judge_rays(const solid_packet *s, ray_packet *k, int n){FOR_RAY_DEGREE(n, judge_rays_n(s, k, N))}

/* Points surely within a ball or box. */
INLINE mask within(const algsurf_i_shadow_job *job, const lanes x[3]) {
    mask inside = ~no_lane();
    double narrow = job->extent_size[0] * (1 - END_SLACK);
    if (job->extent_kind == ALGSURF_EXTENT_SPHERE) return less(dot(x, x), all_lanes(narrow * narrow));
    for (int k = 0; k < 3; k++)
        inside &= less(absolute(x[k]), all_lanes(job->extent_size[k] * (1 - END_SLACK)));
    return inside;
}

/* What all rays from points in a ball have in common. */
INLINE void measure_ball(double radius, solid_packet *s) {
    double wide = radius * (1 + END_SLACK), narrow = radius * (1 - END_SLACK);
    s->room = wide * wide - dot(s->x, s->x);
    s->gap = choose(s->inside, 8 * END_SLACK + 2 * (wide * wide - narrow * narrow) / s->room, all_lanes(1));
}

INLINE ray_ends ends_in_ball(const solid_packet *s, const lanes d[3]) {
    lanes a = dot(d, d), b = dot(s->x, d);
    lanes most = (root(larger(b * b + a * s->room, all_lanes(0))) - b) / a;
    return (ray_ends){most * (1 - s->gap), most};
}

/* Rays from x with these directions, in the caller's unit, up to where they leave the extent. */
INLINE void cut_rays(const algsurf_i_shadow_job *job, const solid_packet *s, const lanes direction[3],
                     ray_packet *k) {
    const double unit = job->unit / job->taylor->frame.view.size;
    lanes end[3], part = all_lanes(1), gap;
    for (int i = 0; i < 3; i++) {
        k->d[i] = direction[i] * unit;
        end[i] = s->x[i] + k->d[i];
    }
    k->gap = all_lanes(0);
    if (job->plane_count == 0 && !any(k->open & ~(s->inside & within(job, end)))) return;
    const int ball = job->extent_kind == ALGSURF_EXTENT_SPHERE;
    ray_ends e = ball ? ends_in_ball(s, k->d) : ends_in_box(job->extent_size, s->x, k->d);
    e = ends_at_planes(job, s->x, k->d, e);
    part = larger(smaller(e.most * (1 + END_SLACK), part), all_lanes(SHORTEST_END));
    gap = ball && job->plane_count == 0 ? s->gap : 1 - e.least / part + END_SLACK;
    k->gap = choose(less(part, e.least), all_lanes(0), gap);
    for (int i = 0; i < 3; i++) k->d[i] *= part;
}

INLINE void judge(const algsurf_i_shadow_job *job, const solid_packet *s, const lanes direction[3],
                  ray_packet *k) {
    cut_rays(job, s, direction, k);
    mask known = s->known;
    for (int i = 0; i < 3; i++) known &= less(absolute(s->x[i] + k->d[i]), all_lanes(ALGSURF_I_TAYLOR_REACH));
    mask unknown = k->open & ~known;
    k->open &= known;
    if (any(k->open)) judge_rays(s, k, job->taylor->frame.degree);
    k->open |= unknown;
}

/* ---- where they go ---- */

/* LANES of the starts. */
typedef struct start_packet {
    lanes at[3], facing[3], number, across, up;
} start_packet;

INLINE void load_starts(const algsurf_i_starts *starts, int first, start_packet *p) {
    const int count = starts->count - first;
    for (int k = 0; k < 3; k++) {
        p->at[k] = load_some(starts->at[k] + first, count);
        p->facing[k] = load_some(starts->facing[k] + first, count);
    }
    p->number = load_some(starts->number + first, count);
    p->across = load_some(starts->across + first, count);
    p->up = load_some(starts->up + first, count);
}

/* A point of the unit circle at a share of its way round from -45 degrees, within 2e-5: with t about the
 * tangent of half the angle from the middle of its quarter, which is at 0, 90, 180 or 270 degrees. */
INLINE void find_point_of_circle(lanes share, lanes point[2]) {
    const lanes zero = all_lanes(0), one = all_lanes(1);
    lanes quarters = 4 * share;
    mask past_one = at_most(one, quarters), past_two = at_most(all_lanes(2), quarters),
         past_three = at_most(all_lanes(3), quarters), odd = past_one & (~past_two | past_three);
    lanes quarter = choose(past_one, one, zero) + choose(past_two, one, zero) + choose(past_three, one, zero);
    lanes f = 2 * (quarters - quarter) - 1, square = f * f;
    lanes t = f * (0.3926991 + square * (0.0201862 + 0.0013285 * square)), d = 1 / (1 + t * t);
    lanes across = (1 - t * t) * d, up = 2 * t * d;
    lanes first = choose(odd, -up, across), second = choose(odd, across, up);
    point[0] = choose(past_two, -first, first);
    point[1] = choose(past_two, -second, second);
}

/* Directions of ray j of each start. */
INLINE void aim(const algsurf_i_shadow_job *job, const start_packet *p, int j, lanes direction[3]) {
    const double *const *light = job->light;
    lanes u, v;
    if (job->place[0]) {
        u = all_lanes(job->place[0][j]), v = all_lanes(job->place[1][j]);
    } else {
        find_lattice_points(p->number + ALGSURF_I_LATTICE_STEP * j, p->across, p->up, job->lattice, &u, &v);
    }
    if (light[0]) {
        for (int k = 0; k < 3; k++)
            direction[k] = (light[0][k] + u * light[1][k] + v * light[2][k]) - p->at[k];
        return;
    }
    lanes z = -2 * u, wide = root(1 - z * z), circle[2];
    find_point_of_circle(v + 0.5, circle);
    const lanes on_ball[3] = {wide * circle[0], wide * circle[1], z};
    for (int k = 0; k < 3; k++) direction[k] = job->ball * (p->facing[k] + on_ball[k]);
}

/* The points about which P is expanded, with bounds on what d can be. */
INLINE void begin_solids(const algsurf_i_shadow_job *job, const start_packet *p, solid_packet *s) {
    const algsurf_i_view *view = &job->taylor->frame.view;
    double unit = job->unit / view->size;
    lanes span[KINDS][3];
    for (int k = 0; k < 3; k++) {
        s->x[k] = (job->unit * p->at[k] - view->centre[k]) * (1 / view->size);
        span[TO_LIGHTS][k] = absolute(s->x[k]) + ALGSURF_I_TAYLOR_REACH;
        span[AROUND][k] = (job->ball * unit * (1 + 0x1p-20)) * (1 + absolute(p->facing[k]));
    }
    expand_solids(job->taylor, span, s, job->taylor->frame.degree);
    s->inside = within(job, s->x);
    if (job->extent_kind == ALGSURF_EXTENT_SPHERE) measure_ball(job->extent_size[0], s);
    for (int k = 0; k < 3; k++) s->known &= less(absolute(s->x[k]), all_lanes(ALGSURF_I_TAYLOR_REACH));
}

static void expand(const algsurf_i_shadow_job *job, const algsurf_i_starts *starts,
                   algsurf_i_solids *solids) {
    solid_packet *s = (solid_packet *)(void *)solids->packets;
    _Static_assert(sizeof(solid_packet) * (ALGSURF_I_STARTS / LANES) <= sizeof solids->packets,
                   "room for all");
    for (int first = 0; first < starts->count; first += LANES) {
        start_packet p;
        load_starts(starts, first, &p);
        begin_solids(job, &p, s + first / LANES);
    }
}

static void see_rays(const algsurf_i_shadow_job *job, const algsurf_i_starts *starts,
                     const algsurf_i_solids *solids, int from, int rays, algsurf_i_undecided *to) {
    const solid_packet *s = solids ? (const solid_packet *)(const void *)solids->packets : NULL;
    for (int first = 0; first < starts->count; first += LANES) {
        lanes arrived = all_lanes(0);
        mask asked = less(numbered(), all_lanes(starts->count - first));
        start_packet p;
        load_starts(starts, first, &p);
        for (int j = from; j < from + rays; j++) {
            lanes direction[3];
            aim(job, &p, j, direction);
            ray_packet k = {.kind = job->light[0] ? TO_LIGHTS : AROUND,
                            .open = asked & less(all_lanes(0), dot(direction, p.facing)),
                            .hit = no_lane()};
            if (s) judge(job, s + first / LANES, direction, &k);
            arrived += choose(k.open | k.hit, all_lanes(0), all_lanes(1));
            const unsigned undecided = bits(k.open);
            for (int l = 0; undecided >> l && l < LANES; l++) {
                if (!(undecided >> l & 1)) continue;
                for (int i = 0; i < 3; i++) to->direction[i][to->count] = direction[i][l];
                to->start[to->count++] = first + l;
            }
        }
        for (int l = 0; l < LANES && first + l < starts->count; l++) *starts->seen[first + l] += arrived[l];
    }
}

#endif
