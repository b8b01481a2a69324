/* fans_template.h - points that see a whole light, or nothing of it.
 *
 * All segments from a point to a light are a fan (surface/fan.h), searched like a beam (search_template.h).
 * LANES points are done side by side; none of them depends on its neighbours.
 *
 * Ends.  Let l be the length of the rectangle's half diagonal.  Segment and middle segment, at the same part
 * tau of them, are at most tau l apart.  So all segments are outside of a ball of radius R from the greater
 * root of |x + tau d| = R + tau l on, and within it up to that of |x + tau d| = R - tau l; for a box the same
 * holds face by face, and plane by plane.  Searched is what comes before the former, or before the light;
 * that is t = 1.
 *
 * Lit: no segment has a root before.  Dark: each has one before the latter.  P's sign at the point itself
 * must be sure: the first coefficient belongs to all segments. */
#ifndef ALGSURF_FANS_TEMPLATE_H
#define ALGSURF_FANS_TEMPLATE_H
#include "../surface/fan.h"
#include "shadow_kernel.h"
#include "search_template.h"

#define FAN_DEGREE ALGSURF_MAX_FAN_DEGREE
#define END_SLACK 0x1p-30 /* of an extent, relative: far more than the rounding of its ends */

/* From LANES points to one light: in the fan's axes and unit. */
typedef struct fan_packet {
    lanes x[3], d[3], half[2], part; /* the middle segment is x + t d, 0 <= t <= 1: that part of it */
    lanes least;                     /* all segments reach t = least within the extent */
    mask open;
} fan_packet;

/* ---- where segments end ---- */

/* Parts tau of the middle segment: all segments are inside before `least`, outside from `most` on. */
typedef struct fan_ends {
    lanes least, most;
} fan_ends;

/* The greater root of a tau^2 + 2 b tau + c, a > 0. */
INLINE lanes greater_root(lanes a, lanes b, lanes c) {
    return (root(larger(b * b - a * c, all_lanes(0))) - b) / a;
}

INLINE fan_ends ends_in_sphere(double radius, const lanes x[3], const lanes d[3], double reach) {
    double wide = radius * (1 + END_SLACK), narrow = radius * (1 - END_SLACK);
    lanes a = dot(d, d) - reach * reach, b = dot(x, d), square = dot(x, x);
    mask spread = ~less(all_lanes(0), a), outside = ~less(square, all_lanes(narrow * narrow));
    fan_ends e = {.least = greater_root(a, b + narrow * reach, square - narrow * narrow),
                  .most = greater_root(a, b - wide * reach, square - wide * wide)};
    e.least = choose(spread | outside, all_lanes(0), smaller(e.least, all_lanes(narrow / reach)));
    e.most = choose(spread, all_lanes(1), e.most);
    return e;
}

/* x and d in the box's axes.  Across a face all segments move by speed - reach to speed + reach. */
INLINE fan_ends ends_in_box(const double half[3], const lanes x[3], const lanes d[3], double reach) {
    const lanes never = all_lanes(HUGE_VAL);
    fan_ends e = {never, never};
    mask inside = ~no_lane();
    for (int i = 0; i < 3; i++) {
        double wide = half[i] * (1 + END_SLACK), narrow = half[i] * (1 - END_SLACK);
        lanes speed = absolute(d[i]), ahead = choose(less(d[i], all_lanes(0)), -x[i], x[i]);
        mask onward = less(all_lanes(reach), speed), back = less(speed, all_lanes(reach));
        e.most = smaller(e.most, choose(onward, (wide - ahead) / (speed - reach), never));
        e.least = smaller(
            e.least, choose(less(all_lanes(0), speed + reach), (narrow - ahead) / (speed + reach), never));
        e.least = smaller(e.least, choose(back, (narrow + ahead) / (reach - speed), never));
        inside &= less(absolute(x[i]), all_lanes(narrow));
    }
    e.least = choose(inside, e.least, all_lanes(0));
    return e;
}

/* What planes leave of that, x and d in the caller's axes.  A segment that begins beyond a plane may come
 * back through it: nothing is known to be inside then. */
INLINE fan_ends ends_at_planes(const algsurf_i_shadow_job *job, const lanes x[3], const lanes d[3],
                               double reach, fan_ends e) {
    const lanes never = all_lanes(HUGE_VAL);
    for (int i = 0; i < job->plane_count; i++) {
        const algsurf_i_cut_plane *p = job->planes + i;
        const lanes n[3] = {all_lanes(p->normal[0]), all_lanes(p->normal[1]), all_lanes(p->normal[2])};
        double slack = END_SLACK + p->error;
        lanes below = p->offset - dot(n, x), speed = dot(n, d);
        lanes last = choose(less(all_lanes(0), speed + reach), (below - slack) / (speed + reach), never);
        lanes first = choose(less(all_lanes(reach), speed), (below + slack) / (speed - reach), never);
        e.least = choose(less(all_lanes(slack), below), smaller(e.least, last), all_lanes(0));
        e.most = smaller(e.most, first);
    }
    return e;
}

/* |x| + |d| + h of fan.c. */
INLINE lanes size_along(const fan_packet *g, int k) {
    return absolute(g->x[k]) + absolute(g->d[k]) + (k < 2 ? g->half[k] : all_lanes(0));
}

/* The points in the fan's axes; d and half for the part of segments that is searched. */
INLINE void begin_fans(const algsurf_i_shadow_job *job, const lanes at[3], mask open, fan_packet *g) {
    const algsurf_i_fan *fan = job->fan;
    const algsurf_i_view *view = &fan->frame.view;
    double reach = sqrt(fan->half[0] * fan->half[0] + fan->half[1] * fan->half[1]) * (1 + END_SLACK);
    lanes from[3], to[3];
    for (int i = 0; i < 3; i++) {
        from[i] = (job->unit * at[i] - view->centre[i]) * (1 / view->size);
        to[i] = job->to_light[i] - from[i];
    }
    for (int k = 0; k < 3; k++) {
        const lanes axis[3] = {all_lanes(view->axis[k][0]), all_lanes(view->axis[k][1]),
                               all_lanes(view->axis[k][2])};
        g->x[k] = dot(from, axis);
        g->d[k] = fan->light[k] - g->x[k];
    }
    fan_ends e = job->extent_kind == ALGSURF_EXTENT_SPHERE
                     ? ends_in_sphere(job->extent_size[0], g->x, g->d, reach)
                     : ends_in_box(job->extent_size, from, to, reach);
    e = ends_at_planes(job, from, to, reach, e);
    lanes part = g->part = smaller(e.most * (1 + END_SLACK), all_lanes(1));
    g->open = open & less(all_lanes(0), part) &
              less(dot(g->d, g->d), ALGSURF_I_SLANT * ALGSURF_I_SLANT * (g->d[2] * g->d[2]));
    g->least = smaller(e.least / part, all_lanes(1)) * (1 - END_SLACK);
    for (int k = 0; k < 3; k++) {
        g->d[k] *= part;
        if (k < 2) g->half[k] = part * (fan->half[k] * (1 + END_SLACK));
        g->open &= less(absolute(g->x[k]), all_lanes(1.25)) & less(size_along(g, k), all_lanes(4));
    }
}

/* ---- P along them ---- */

/* sum c_k z^k at z = x + t d, as a polynomial in t. */
INLINE void shift_line(lanes *c, int n, lanes x, lanes d) {
    lanes power = d;
    for (int m = 0; m < n; m++)
        for (int k = n - 1; k >= m; k--) c[k] += x * c[k + 1];
    for (int k = 1; k <= n; k++, power *= d) c[k] *= power;
}

/* a += (x + t d) b, of degrees n and n - 1 in t. */
INLINE void add_line(lanes *a, const lanes *b, int n, lanes x, lanes d) {
    lanes carried = all_lanes(0);
    for (int k = 0; k < n; k++) {
        a[k] += x * b[k] + carried;
        carried = d * b[k];
    }
    a[n] += carried;
}

/* Powers of t to Bernstein coefficients; inverse: of binomial ones. */
INLINE void to_bernstein(const double *inverse, lanes *c, int n) {
    for (int k = 1; k < n; k++) c[k] *= inverse[k];
    for (int m = 1; m <= n; m++)
        for (int k = n; k >= m; k--) c[k] += c[k - 1];
}

/* r_ij(t) at line[i][j], of degree n - i - j. */
INLINE void expand_solid(const algsurf_i_fan *fan, const fan_packet *g, lanes *r,
                         lanes *line[FAN_DEGREE + 1][FAN_DEGREE + 1], int n) {
    const double *q = fan->frame.q;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; i + j <= n; j++) {
            line[i][j] = r;
            for (int k = 0; i + j + k <= n; k++) *r++ = all_lanes(q[(i * (n + 1) + j) * (n + 1) + k]);
            shift_line(line[i][j], n - i - j, g->x[2], g->d[2]);
        }
        for (int m = 0; i + m < n; m++)
            for (int j = n - i - 1; j >= m; j--)
                add_line(line[i][j], line[i][j + 1], n - i - j, g->x[1], g->d[1]);
    }
    for (int j = 0; j < n; j++)
        for (int m = 0; j + m < n; m++)
            for (int i = n - j - 1; i >= m; i--)
                add_line(line[i][j], line[i + 1][j], n - i - j, g->x[0], g->d[0]);
}

/* S of fan.c. */
APART lanes size_of(const algsurf_i_frame_form *frame, const lanes x[3], int n) {
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

/* Errors of the coefficients: of the first one, P at the point itself, and of the others. */
INLINE void set_errors(const algsurf_i_fan *fan, const fan_packet *g, lanes error[2], int n) {
    lanes at[3], along[3];
    for (int k = 0; k < 3; k++) {
        at[k] = absolute(g->x[k]) + ALGSURF_I_FAN_APART;
        along[k] = size_along(g, k) + ALGSURF_I_FAN_APART;
    }
    lanes missed = g->part * (3 * fan->missed / ALGSURF_I_FAN_APART);
    error[0] = fan->weight * size_of(&fan->frame, at, n) + fan->least_error;
    error[1] = (fan->weight + missed) * size_of(&fan->frame, along, n) + fan->least_error;
}

/* The terms up to the second order; the third as a radius; higher ones by their sizes for each power of t. */
INLINE void expand_fans_n(const algsurf_i_fan *fan, const fan_packet *g, beam *b, int n) {
    lanes r[ALGSURF_I_SOLID(FAN_DEGREE)], *line[FAN_DEGREE + 1][FAN_DEGREE + 1], error[2],
        across = all_lanes(1);
    expand_solid(fan, g, r, line, n);
    for (int k = 0; k <= n; k++) {
        b->rest[k] = all_lanes(0);
        for (int i = 0; i < LOW_TERMS; i++) b->t[i][k] = all_lanes(0);
    }
    for (int i = 0; i <= n; i++, across *= g->half[0]) {
        lanes factor = across;
        for (int j = 0; i + j <= n; j++, factor *= g->half[1])
            for (int k = 0; i + j + k <= n; k++) {
                lanes term = factor * line[i][j][k];
                if (i + j <= 2)
                    b->t[term_at[i][j]][i + j + k] = term;
                else if (i + j > 3)
                    b->rest[i + j + k] += absolute(term);
            }
    }
    to_bernstein(fan->inverse, b->rest, n);
    for (int i = 0; i < LOW_TERMS; i++) to_bernstein(fan->inverse, b->t[i], n);
    for (int i = 0; i <= 3 && n >= 3; i++) {
        lanes third[FAN_DEGREE + 1], factor = all_lanes(1);
        for (int m = 0; m < 3; m++) factor *= g->half[m < i ? 0 : 1];
        for (int k = 0; k <= n; k++) third[k] = k < 3 ? all_lanes(0) : factor * line[i][3 - i][k - 3];
        to_bernstein(fan->inverse, third, n);
        for (int k = 0; k <= n; k++) b->rest[k] += absolute(third[k]);
    }
    set_errors(fan, g, error, n);
    for (int k = 0; k <= n; k++) b->rest[k] += error[k > 0];
}

/* What is known of the fans: their expansion and the search. */
INLINE void search_fans_n(const algsurf_i_fan *fan, const fan_packet *g, verdict *v, int n) {
    beam b;
    expand_fans_n(fan, g, &b, n);
    *v = search_n(&b, all_lanes(0), g->open, n);
}

APART void search_fans(const algsurf_i_fan *fan, const fan_packet *g, verdict *v, int n) {
    FOR_LOW_DEGREE(n, search_fans_n(fan, g, v, N))
}

/* How much of a light is above points' tangent planes: nothing that arrives, or all? */
typedef struct height_of_light {
    mask nothing, all;
} height_of_light;

#define DIMMEST -0.25 /* cosine at a light's middle: of what is below it, nothing arrives */

INLINE height_of_light height_of(const algsurf_light *light, const lanes at[3], const lanes facing[3]) {
    lanes height = all_lanes(0), square = height, along_u = height, along_v = height, size = height;
    for (int k = 0; k < 3; k++) {
        lanes way = light->position[k] - at[k];
        height += way * facing[k];
        square += way * way;
        along_u += light->edge_u[k] * facing[k];
        along_v += light->edge_v[k] * facing[k];
        size = larger(size, absolute(at[k]) +
                                (fabs(light->position[k]) + fabs(light->edge_u[k]) + fabs(light->edge_v[k])));
    }
    lanes half = 0.5 * (absolute(along_u) + absolute(along_v)), slack = 0x1p-44 * size;
    return (height_of_light){less(height, DIMMEST * 1.001 * root(square)) | less(height, -half - slack),
                             less(half + slack, height)};
}

static void see_light(const algsurf_i_shadow_job *job, const algsurf_i_starts *starts, uint8_t *how) {
    for (int first = 0; first < starts->count; first += LANES) {
        int left = starts->count - first < LANES ? starts->count - first : LANES;
        lanes at[3], facing[3];
        for (int k = 0; k < 3; k++) {
            at[k] = load_some(starts->at[k] + first, left);
            facing[k] = load_some(starts->facing[k] + first, left);
        }
        height_of_light above = height_of(job->light, at, facing);
        unsigned lit = bits(above.nothing), dark = 0;
        if (job->fan) {
            fan_packet g;
            verdict v;
            begin_fans(job, at, less(numbered(), all_lanes(left)) & ~above.nothing, &g);
            if (any(g.open)) {
                search_fans(job->fan, &g, &v, job->fan->frame.degree);
                lit |= bits(v.empty), dark = bits(v.crossed & above.all & less(v.beyond, g.least));
            }
        }
        for (int l = 0; l < left; l++)
            how[first + l] = (uint8_t)(ALGSURF_I_LIT * (lit >> l & 1) + ALGSURF_I_DARK * (dark >> l & 1));
    }
}

#endif
