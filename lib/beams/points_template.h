/* points_template.h - from the depths of hits to points of the surface: Newton steps along the ray on P
 * itself, seldom more than one, position, normal; and, where colours are asked for, what these depend on.
 *
 * Steps.  The constants below do not decide what is hit: pixels have proved their roots, and on_sheets
 * proves, whatever the steps were, that a sheet's root is within 2^-16 of where the last step began.  They
 * decide how accurate t is: it may be off by what rounding of the ray, of t and of P can cause, and 2^-36 of
 * the radius (algsurf_picture.t).  A step s leaves c s^2 to second order, where c = |P''| / (2 |P'|) along
 * the ray.  Lengths are in the view's unit.  An entry whose last step is too long, or leaves too much, has
 * not found its root: its ray is solved by itself, from numbers of its own.
 * - LAST_STEP is a bound: longer steps are never the last one.  Let M be the sum of the sizes of P's terms
 * for |x|, |y|, |z| <= 1 (surface/view.c).  For slopes up to 1, |P''| <= n (n-1) M, and a step of 2^-26
 * leaves n (n-1) 2^-53 M / |P'| at most.  P's rounding is bounded by 16 (n+1) 2^-53 M and can move the root
 * by that over |P'|: by more, up to degree 17, and by 0.7 times as much in degree 24.
 * - FARTHEST_STEP is a choice.  Let R be the row's radius, which bounds its rounding and noise.  The depth
 *   that a row gives is off by ENOUGH + R / |P'| at most, to first order, or by what tolerance the caller has
 *   set.  So where a step is longer than 2^-16, R / |P'| is about as long, and doubles of the row tell little
 *   of where the root is.
 * - FARTHEST_ON_SHEET is a choice that costs time only.
 * - LEFT_OVER and STEP_BEFORE are choices.  If a step s follows r, then c is about s / r^2, and s leaves s
 *   (s/r)^2.  On a sheet that is to be below 2^-52, since depths begin far off there and t is to be the same
 *   from any of them, but for its last bits.  No step comes before the first one; 2^-20 in its place makes
 *   the first one the last if it is below 2^-30.7, which presumes c < 2^9.  A wrong choice costs time, or
 *   accuracy down to what LAST_STEP ensures.
 * - MOST_ROUNDS is measured, in 30 views of each named surface (test_render_tiles 30 7).  Of 7.6 million
 *   points of rows none took a second step; the first was below 2^-28.  Of 53 million of sheets 73 % took a
 *   second one, 3 % a third, 0.07 % a fourth; 258 points were left to rays of their own. */
#ifndef ALGSURF_POINTS_TEMPLATE_H
#define ALGSURF_POINTS_TEMPLATE_H
#include <string.h>

#include "../simd/lanes.h"
#include "../surface/jets_template.h"
#include "segments.h"

/* Of Newton steps, in the view's unit: see Steps. */
#define FARTHEST_STEP 0x1p-16    /* a longer one is not taken, */
#define FARTHEST_ON_SHEET 0x1p-3 /* on a sheet */
#define LAST_STEP 0x1p-26        /* after a longer one another follows; */
#define LEFT_OVER 0x1p-52        /* also after one that leaves more, if */
#define STEP_BEFORE 0x1p-20      /* this came before the first one on a sheet */
#define MOST_ROUNDS 4

/* The rays of a row, in natural units: X = foot + size u across + z (straight + slope across), where
 * slope = alpha u + beta. */
typedef struct row_rays {
    double foot[3], across[3], straight[3];
    double offset, pixel, u0, du, alpha, beta, size, near, unit;
} row_rays;

static row_rays rays_of_row(const algsurf_i_point_job *job) {
    const algsurf_i_row_job *row = job->row;
    const algsurf_i_view *view = row->view;
    row_rays s = {.offset = row->offset,
                  .pixel = row->pixel,
                  .u0 = row->u0,
                  .du = row->du,
                  .alpha = view->alpha,
                  .beta = view->beta[0],
                  .size = view->size,
                  .near = view->size * row->near,
                  .unit = ldexp(1, job->surface->unit)};
    for (int i = 0; i < 3; i++) {
        s.foot[i] = view->centre[i] + view->size * (row->row->v * view->axis[1][i]);
        s.across[i] = view->axis[0][i];
        s.straight[i] = view->axis[2][i] + row->slope * view->axis[1][i];
    }
    return s;
}

/* A packet of rays: X = foot + z along. */
typedef struct packet_rays {
    lanes foot[3], along[3], z;
} packet_rays;

INLINE packet_rays rays_of_packet(const row_rays *s, lanes pixel, lanes depth) {
    packet_rays r;
    lanes u = s->u0 + s->du * ((pixel + s->offset) * s->pixel);
    r.z = s->size * depth;
    lanes slope = s->alpha * u + s->beta;
    for (int i = 0; i < 3; i++) {
        r.foot[i] = s->foot[i] + s->size * u * s->across[i];
        r.along[i] = s->straight[i] + slope * s->across[i];
    }
    return r;
}

/* Newton's steps from where P and its gradient were taken; 0 where that is no step to the same root: lost. */
INLINE lanes step_to(const packet_rays *r, const jets *p, int w, double farthest, mask *lost) {
    lanes gradient[3] = {p->x[w], p->y[w], p->z[w]}, step = -p->v[w] / dot(gradient, r->along);
    mask near = at_most(absolute(step), all_lanes(farthest));
    *lost = ~near;
    return choose(near, step, all_lanes(0));
}

/* Does a step leave too much to be the last one?  `before`: the one before. */
INLINE mask leaves_much(const row_rays *s, lanes step, lanes before) {
    lanes ratio = step / before;
    return less(all_lanes(LAST_STEP * s->size), absolute(step)) |
           less(all_lanes(LEFT_OVER * s->size), absolute(step * ratio * ratio));
}

/* Is the root of each pixel's sheet within ALGSURF_I_NEAR of z? */
INLINE mask on_sheets(const row_rays *s, const packet_rays *r, lanes value, const algsurf_i_sheets *sheets,
                      int first, int count) {
    lanes z = r->z * (1 / s->size);
    return at_most(absolute(value), load_some(sheets->enough + first, count)) &
           less(load_some(sheets->low + first, count), z) & less(z, load_some(sheets->high + first, count));
}

/* Tells which entries from `first` on have their root; returns whether all have. */
INLINE int tell_sure(mask found, uint8_t *sure, int first, int count) {
    unsigned which = bits(found), all = (1u << (count < LANES ? count : LANES)) - 1;
    for (int l = 0; l < LANES && l < count; l++) sure[first + l] = which >> l & 1;
    return (which & all) == all;
}

/* What colours of points depend on: position, normal, direction along an axis. */
INLINE void store_looks(const algsurf_i_look_frame *frame, int axis, lanes position, lanes normal,
                        lanes direction, const algsurf_i_looks *looks, int first, int count) {
    lanes place = (position - frame->centre[axis]) * frame->per_radius;
    store_some_floats(looks->place[axis] + first, place, count);
    store_some_floats(looks->normal[axis] + first, normal, count);
    store_some_floats(looks->direction[axis] + first, direction, count);
}

/* The points at z, of which what is asked for goes to the entries from `first` on; the gradient becomes the
 * unit normal. */
INLINE void finish_packet(const row_rays *s, const packet_rays *r, lanes z, lanes normal[3],
                          const algsurf_i_look_frame *frame, const algsurf_i_points *points, int first,
                          int count) {
    lanes length = root(dot(r->along, r->along)), inverse = 1 / length;
    make_unit(normal);
    store_some(points->t + first, (z - s->near) * length * s->unit, count);
    for (int i = 0; i < 3; i++) {
        lanes position = (r->foot[i] + z * r->along[i]) * s->unit;
        lanes direction = r->along[i] * inverse;
        if (points->looks.place[i])
            store_looks(frame, i, position, normal[i], direction, &points->looks, first, count);
        if (points->normal[i]) store_some(points->normal[i] + first, normal[i], count);
        if (!points->position[i]) continue;
        store_some(points->position[i] + first, position, count);
        store_some(points->direction[i] + first, direction, count);
    }
}

/* Turns a gradient towards the viewer, for a `front` of 1, or away from it. */
INLINE void turn_to_front(lanes gradient[3], const lanes along[3], int front) {
    mask back = less(all_lanes(0), front * dot(gradient, along));
    for (int i = 0; i < 3; i++) gradient[i] = choose(back, -gradient[i], gradient[i]);
}

/* Entries from `first` on: so many packets, the last one of `count` entries.  Tells which of them have their
 * root, and returns whether all have. */
INLINE int find_packets(const algsurf_i_point_job *job, const row_rays *s, const int *pixel,
                        const double *depth, const algsurf_i_sheets *sheets, uint8_t *sure,
                        const algsurf_i_points *points, int first, int packets, int count) {
    packet_rays r[PAIR];
    lanes at[PAIR][3], step[PAIR], before[PAIR];
    mask much[PAIR];
    jets p;
    int all = 1;
    for (int w = 0; w < packets; w++) {
        int from = first + w * LANES;
        r[w] = rays_of_packet(s, load_some_integers(pixel + from, count), load_some(depth + from, count));
        before[w] = all_lanes(sheets ? STEP_BEFORE * s->size : HUGE_VAL);
    }
    for (int round = 1;; round++) {
        mask more = no_lane();
        for (int w = 0; w < packets; w++)
            for (int i = 0; i < 3; i++) at[w][i] = r[w].foot[i] + r[w].z * r[w].along[i];
        p = surface_jets(job->surface, at, packets);
        for (int w = 0; w < packets; w++) {
            mask lost;
            step[w] = step_to(&r[w], &p, w, s->size * (sheets ? FARTHEST_ON_SHEET : FARTHEST_STEP), &lost);
            much[w] = lost | leaves_much(s, step[w], before[w]);
            more |= much[w];
        }
        if (round == MOST_ROUNDS || !any(more)) break;
        for (int w = 0; w < packets; w++) {
            r[w].z = choose(much[w], r[w].z + step[w], r[w].z);
            if (sheets) before[w] = choose(much[w], step[w], before[w]);
        }
    }
    for (int w = 0; w < packets; w++) {
        const int from = first + w * LANES;
        lanes normal[3] = {p.x[w], p.y[w], p.z[w]};
        if (job->front) turn_to_front(normal, r[w].along, job->front);
        mask found = ~much[w];
        if (sheets) found &= on_sheets(s, &r[w], p.v[w], sheets, from, count);
        all &= tell_sure(found, sure, from, count);
        finish_packet(s, &r[w], r[w].z + step[w], normal, job->looks, points, from, count);
    }
    return all;
}

INLINE int find_all(const algsurf_i_point_job *job, const int *pixel, const double *depth, int count,
                    const algsurf_i_sheets *sheets, uint8_t *sure, const algsurf_i_points *points) {
    const row_rays s = rays_of_row(job);
    int first = 0, all = 1;
    for (; first + PAIR * LANES <= count; first += PAIR * LANES)
        all &= find_packets(job, &s, pixel, depth, sheets, sure, points, first, PAIR, LANES);
    for (; first < count; first += LANES)
        all &= find_packets(job, &s, pixel, depth, sheets, sure, points, first, 1, count - first);
    return all;
}

static int find_points(const algsurf_i_point_job *job, const int *pixel, const double *depth, int count,
                       const algsurf_i_sheets *sheets, uint8_t *sure, const algsurf_i_points *points) {
    return sheets ? find_all(job, pixel, depth, count, sheets, sure, points)
                  : find_all(job, pixel, depth, count, NULL, sure, points);
}

/* Points lifted off the surface, so that rays from them do not meet it where they begin.
 *
 * A millionth of what is shown is invisible, and well above the error of a hit's position, which the second
 * term bounds for far eyes and far extents: position and t are rounded to 2^-53, and 2^-48 leaves room for
 * the root's own error. */
static void lift(const algsurf_i_points *points, int first, int count, double height,
                 algsurf_i_starts *starts) {
    for (int i = 0; i < count; i += LANES) {
        lanes position[3], normal[3], direction[3];
        for (int k = 0; k < 3; k++) {
            position[k] = load_some(points->position[k] + first + i, count - i);
            normal[k] = load_some(points->normal[k] + first + i, count - i);
            direction[k] = load_some(points->direction[k] + first + i, count - i);
        }
        lanes t = load_some(points->t + first + i, count - i);
        lanes up = height + 0x1p-48 * (absolute(t) + largest_size(position));
        mask singular = at_most(largest_size(normal), all_lanes(0));
        mask away = less(all_lanes(0), dot(normal, direction));
        for (int k = 0; k < 3; k++) {
            lanes facing = choose(singular, -direction[k], choose(away, -normal[k], normal[k]));
            store(starts->facing[k] + i, facing);
            store(starts->at[k] + i, position[k] + up * facing);
        }
    }
    starts->count = count;
}

#endif
