/* colours_template.h - the colours of points: the formula of shade.c for LANES points.
 *
 * With s the way to the light and d the viewing direction, the light falls in at the cosine n.s / |s|, and
 * h = s - |s| d is half-way between light and viewer.  Where n.s > 0, both parts of n.h = n.s + |s| (-n.d)
 * have the same sign, and the highlight is the power shininess / 2 of (n.h)^2 / h.h: no root of h.h, and for
 * a whole shininess no logarithm. */
#ifndef ALGSURF_COLOURS_TEMPLATE_H
#define ALGSURF_COLOURS_TEMPLATE_H
#include "../simd/lanes.h"
#include "kernel.h"
#include "../base/elementary.h"

#define MOST_SQUARED 1024 /* shininess: its power by squaring is off by some shininess u */

/* The power shininess / 2 of 0 <= square <= 1. */
INLINE lanes highlight(lanes square, double shininess) {
    lanes power = all_lanes(1);
    if (!(shininess <= MOST_SQUARED && shininess == (int)shininess)) {
        for (int l = 0; l < LANES; l++)
            power[l] = square[l] > 0 ? (scalar)algsurf_i_pow(square[l], 0.5 * shininess) : 0;
        return power;
    }
    int n = (int)shininess;
    if (n & 1) power = root(square);
    for (n >>= 1; n > 0; n >>= 1) {
        if (n & 1) power *= square;
        square *= square;
    }
    return power;
}

#define PACKETS 8 /* coloured together, step by step: a step's latency is hidden by the other packets */

/* A packet of points on its way to its colours. */
typedef struct canvas {
    lanes position[3], direction[3];
    lanes normal[3], against; /* turned towards the viewer: against = -normal.direction >= 0 */
    lanes base[3], colour[3];
    lanes cosine, square; /* of the light at hand: n.s / |s| and (n.h)^2 / h.h, 0 where n.s <= 0 */
} canvas;

/* Entries first .. first+count-1, at most LANES. */
INLINE void load_canvas(const algsurf_i_points *points, int first, int count, canvas *c) {
    for (int i = 0; i < 3; i++) {
        c->position[i] = load_some(points->position[i] + first, count);
        c->normal[i] = load_some(points->normal[i] + first, count);
        c->direction[i] = load_some(points->direction[i] + first, count);
    }
}

/* From position, normal, direction: normal turned, base colour, ambient light. */
INLINE void begin_canvas(const algsurf_material *material, canvas *c) {
    lanes size = absolute(c->normal[0]) + absolute(c->normal[1]) + absolute(c->normal[2]);
    mask singular = at_most(size, all_lanes(0));
    lanes along = dot(c->normal, c->direction);
    mask inside = less(all_lanes(0), along);
    for (int i = 0; i < 3; i++) {
        lanes facing = choose(inside, -c->normal[i], c->normal[i]);
        c->normal[i] = choose(singular, -c->direction[i], facing);
        c->base[i] = choose(inside, all_lanes(material->inside[i]), all_lanes(material->outside[i]));
        c->colour[i] = c->base[i] * all_lanes(material->ambient);
    }
    c->against = choose(singular, all_lanes(1), absolute(along));
}

/* a / b and c / d; of floats by one division, which is what a colour costs most of. */
INLINE void divide_both(lanes a, lanes b, lanes c, lanes d, lanes *first, lanes *second) {
#if defined(SINGLE)
    lanes inverse = 1 / (b * d);
    *first = a * d * inverse;
    *second = c * b * inverse;
#else
    *first = a / b;
    *second = c / d;
#endif
}

/* Sets cosine and square. */
INLINE void aim(const algsurf_light *light, canvas *c) {
    lanes s[3], h[3];
    for (int i = 0; i < 3; i++)
        s[i] = all_lanes(0.25 * light->position[i]) - 0.25 * c->position[i]; /* cannot overflow */
    lanes scale = scale_of(s);
    for (int i = 0; i < 3; i++) s[i] *= scale;
    lanes length = root(dot(s, s)), towards = dot(c->normal, s);
    mask lit = less(all_lanes(0), towards);
    for (int i = 0; i < 3; i++) h[i] = s[i] - length * c->direction[i];
    lanes half_way = towards + length * c->against, cosine, square;
    divide_both(towards, length, half_way * half_way, dot(h, h), &cosine, &square);
    c->cosine = choose(lit, cosine, all_lanes(0));
    c->square = choose(lit, smaller(square, all_lanes(1)), all_lanes(0)); /* 1 instead of NaN */
}

/* Adds the light, of which a share reaches each point. */
INLINE void add_light(const algsurf_material *material, const algsurf_light *light, lanes share, canvas *c) {
    lanes diffuse = share * all_lanes(material->diffuse) * c->cosine;
    lanes specular = share * all_lanes(material->specular) * highlight(c->square, material->shininess);
    for (int i = 0; i < 3; i++)
        c->colour[i] += all_lanes(light->colour[i]) * (diffuse * c->base[i] + specular);
}

/* visible[light] of each entry, 1 for null. */
INLINE lanes share_of(const double *visible, int light_count, int light, int count) {
    lanes share = all_lanes(1);
    if (visible)
        for (int l = 0; l < LANES && l < count; l++) share[l] = (scalar)visible[l * light_count + light];
    return share;
}

INLINE void store_colours(const canvas *c, int count, double *colour) {
    for (int l = 0; l < LANES && l < count; l++)
        for (int i = 0; i < 3; i++) colour[3 * l + i] = c->colour[i][l];
}

/* As one number each. */
INLINE void store_bytes(const canvas *c, int count, uint32_t *bytes) {
    integers all = {0};
    for (int i = 2; i >= 0; i--) {
        lanes shown = smaller(larger(c->colour[i], all_lanes(0)), all_lanes(1));
        all = all << 8 | __builtin_convertvector(255 * shown + 0.5, integers);
    }
    for (int l = 0; l < LANES && l < count; l++) bytes[l] = (uint32_t)all[l];
}

static void find_colours(const algsurf_i_colour_job *job, const algsurf_i_points *points, int count,
                         const double *visible, double *colour) {
    const algsurf_material material = *job->material;
    canvas c[PACKETS];
    for (int first = 0; first < count; first += PACKETS * LANES) {
        int left = count - first, packets = left < PACKETS * LANES ? (left + LANES - 1) / LANES : PACKETS;
        const double *shares = visible ? visible + (size_t)first * (size_t)job->light_count : NULL;
        for (int k = 0; k < packets; k++) {
            load_canvas(points, first + k * LANES, left - k * LANES, &c[k]);
            begin_canvas(&material, &c[k]);
        }
        for (int l = 0; l < job->light_count; l++) {
            for (int k = 0; k < packets; k++) aim(&job->lights[l], &c[k]);
            for (int k = 0; k < packets; k++) {
                const double *own = shares ? shares + k * LANES * job->light_count : NULL;
                lanes share = share_of(own, job->light_count, l, left - k * LANES);
                add_light(&material, &job->lights[l], share, &c[k]);
            }
        }
        for (int k = 0; k < packets; k++)
            if (colour)
                store_colours(&c[k], left - k * LANES, colour + 3 * (first + k * LANES));
            else
                store_bytes(&c[k], left - k * LANES, points->bytes + first + k * LANES);
    }
}

#endif
