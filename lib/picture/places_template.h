/* places_template.h - which places of a light the point of a fan sees (fans_template.h).
 *
 * LANES places are done side by side: the polynomial along each segment comes from those of the fan.  What is
 * asked is whether it changes its sign within the extent, not where.  So a segment is done as soon as P
 * surely has the other sign somewhere, or the cells from its point to where it leaves the extent have no
 * variation of sign.
 *
 * Ends.  A segment leaves the extent between (1 - gap) end and end.  What is found at t counts for some place
 * within the extent if P is beyond zero by more than it can change by within gap: |dP/dt| <= 2 n max|b|.
 *
 * Errors: those of the fan, and 8 n u max|b| for each of two cuts at a turn (descartes_template.h). */
#ifndef ALGSURF_PLACES_TEMPLATE_H
#define ALGSURF_PLACES_TEMPLATE_H
#include "fans_template.h"

#define SHORTEST_END 0x1p-60 /* of a segment that begins outside and stays there */
#define PLACE_TURNS 6        /* cells of a segment, besides the first */

/* P along LANES segments of a fan, as powers of t; `r` ends behind the fan's polynomials. */
INLINE void expand_places_n(const double *r, const lanes aside[2], lanes *c, int n) {
    for (int k = 0; k <= n; k++) c[k] = all_lanes(0);
    for (int i = n; i >= 0; i--) {
        lanes level[FAN_DEGREE + 1];
        for (int k = 0; k <= n; k++) level[k] = all_lanes(0);
        for (int j = n - i; j >= 0; j--) {
            r -= n - i - j + 1;
            for (int k = n - i - j; k > 0; k--) level[k] = r[k] + aside[1] * level[k - 1];
            level[0] = all_lanes(r[0]);
        }
        for (int k = n - i; k > 0; k--) c[k] = level[k] + aside[0] * c[k - 1];
        c[0] = level[0];
    }
}

/* LANES segments.  They leave the extent at t = end, or before by a share `gap` of it at most. */
typedef struct place_packet {
    lanes aside[2], end, gap, error;
    mask open, hit; /* those to be decided; those with a root */
} place_packet;

/* What is known to have no root is closed, what is known to have one is closed and a hit. */
INLINE void judge_places_n(const algsurf_i_fan *fan, const double *r, place_packet *k, int n) {
    lanes whole[FAN_DEGREE + 1], power = k->end, error = k->error;
    cell c = {.p = all_lanes(0), .q = all_lanes(1)};
    expand_places_n(r, k->aside, c.w, n);
    for (int m = 1; m <= n; m++, power *= k->end) c.w[m] *= power;
    to_bernstein(fan, c.w, n);
    (void)take_sign(c.w, n, ~no_lane());
    lanes largest = error;
    for (int m = 0; m <= n; m++) {
        whole[m] = c.w[m];
        largest = larger(largest, absolute(c.w[m]));
    }
    const lanes cut_error = 16 * n * 0x1p-53 * largest, gap = 2 * n * largest * k->gap;
    mask unknown = k->open & ~less(error, c.w[0]);
    k->open &= ~unknown;
    for (int turn = 0;; turn++) {
        mask none = k->open & count_signs(c.w, &error, n, 0).none;
        mask crossed = k->open & less(error + gap, -c.w[n]);
        k->hit |= crossed;
        k->open &= ~(crossed | (none & at_most(all_lanes(1), c.q)));
        if (turn == PLACE_TURNS || !any(k->open)) break;
        mask again = k->open & none, on = k->open & ~none;
        lanes left[FAN_DEGREE + 1];
        error += cut_error;
        if (any(on)) {
            lanes at = split_point(&c, n, turn), right[FAN_DEGREE + 1];
            for (int m = 0; m <= n; m++) right[m] = c.w[m];
            split(right, left, n, at - c.p, c.q - at);
            mask go_right = on & count_signs(left, &error, n, 0).none, go_left = on & ~go_right;
            for (int m = 0; m <= n; m++)
                c.w[m] = choose(go_right, right[m], choose(go_left, left[m], c.w[m]));
            c.p = choose(go_right, at, c.p);
            c.q = choose(go_left, at, c.q);
        }
        if (any(again)) {
            lanes from = choose(again, c.q, all_lanes(0)), rest[FAN_DEGREE + 1];
            for (int m = 0; m <= n; m++) rest[m] = whole[m];
            split_shares(rest, left, n, from, 1 - from);
            for (int m = 0; m <= n; m++) c.w[m] = choose(again, rest[m], c.w[m]);
            c.p = choose(again, c.q, c.p);
            c.q = choose(again, all_lanes(1), c.q);
        }
    }
    k->open |= unknown;
}

APART void judge_places(const algsurf_i_fan *fan, const double *r, place_packet *k,
                        int n){FOR_LOW_DEGREE(n, judge_places_n(fan, r, k, N))}

/* Where segments leave the extent, between these. */
INLINE fan_ends ends_of_places(const algsurf_i_fan_job *job, const lanes x[3], const lanes d[3]) {
    const algsurf_i_view *view = &job->fan->frame.view;
    lanes from[3], along[3];
    int is_ball = job->extent_kind == ALGSURF_EXTENT_SPHERE;
    if (is_ball && job->plane_count == 0) return ends_in_sphere(job->extent_size[0], x, d, 0);
    for (int i = 0; i < 3; i++) {
        from[i] = view->axis[0][i] * x[0] + view->axis[1][i] * x[1] + view->axis[2][i] * x[2];
        along[i] = view->axis[0][i] * d[0] + view->axis[1][i] * d[1] + view->axis[2][i] * d[2];
    }
    fan_ends e = is_ball ? ends_in_sphere(job->extent_size[0], x, d, 0)
                         : ends_in_box(job->extent_size, from, along, 0);
    return ends_at_planes(job, from, along, 0, e);
}

/* Of places from the fan's middle, in its axes. */
static void see_places(const algsurf_i_fan_job *job, const algsurf_i_fan_point *point,
                       const double *const aside[2], int count, uint8_t *state) {
    int n = job->fan->frame.degree;
    const double *r = point->r + ALGSURF_I_FAN_SOLID(n);
    for (int first = 0; first < count; first += LANES) {
        int left = count - first < LANES ? count - first : LANES;
        place_packet k = {
            .open = less(numbered(), all_lanes(left)), .hit = no_lane(), .error = all_lanes(point->error[1])};
        lanes x[3], d[3];
        for (int i = 0; i < 3; i++) {
            x[i] = all_lanes(point->x[i]);
            d[i] = all_lanes(point->d[i]);
            if (i < 2) d[i] += k.aside[i] = point->part * load_some(aside[i] + first, left);
        }
        fan_ends e = ends_of_places(job, x, d);
        k.end = larger(smaller(e.most * (1 + END_SLACK), all_lanes(1)), all_lanes(SHORTEST_END));
        k.gap = choose(less(k.end, e.least), all_lanes(0), 1 - e.least / k.end + END_SLACK);
        judge_places(job->fan, r, &k, n);
        unsigned hits = bits(k.hit), doubts = bits(k.open);
        for (int l = 0; l < left; l++)
            state[first + l] =
                (uint8_t)(ALGSURF_LANE_HIT * (hits >> l & 1) + ALGSURF_LANE_DOUBTFUL * (doubts >> l & 1));
    }
}

#endif
