/* colours_template.h - the colours of points, LANES floats at a time: the formula of algsurf/shade.h.
 *
 * No square of what is computed here leaves the range of a float: places are kept within 2^40 radii.  A light
 * at the point itself comes from nowhere: the root's argument is never 0. */
#ifndef ALGSURF_COLOURS_TEMPLATE_H
#define ALGSURF_COLOURS_TEMPLATE_H
#include "../simd/lanes.h"
#include "colours.h"

#define FARTHEST_PLACE 0x1p40
#define NEAREST_SQUARED 0x1p-100
#define LEAST_HALF 0x1p-20 /* h: of a light behind the surface, whose highlight is not seen */

/* Points on their way to their colours. */
typedef struct canvas {
    lanes place[3], normal[3], direction[3]; /* the normal is turned towards the viewer */
    mask inside;
    lanes facing;             /* nv */
    lanes light[3], plain[3]; /* E; what highlights leave */
} canvas;

INLINE lanes between(lanes low, lanes x, lanes high) { return smaller(larger(x, low), high); }

/* Entries first .. first+count-1, at most LANES. */
INLINE void load_canvas(const algsurf_i_looks *looks, int first, int count, canvas *c) {
    for (int i = 0; i < 3; i++) {
        lanes place = load_some_floats(looks->place[i] + first, count);
        c->place[i] = between(all_lanes(-FARTHEST_PLACE), place, all_lanes(FARTHEST_PLACE));
        c->normal[i] = load_some_floats(looks->normal[i] + first, count);
        c->direction[i] = load_some_floats(looks->direction[i] + first, count);
    }
    lanes size = absolute(c->normal[0]) + absolute(c->normal[1]) + absolute(c->normal[2]);
    mask singular = at_most(size, all_lanes(0));
    lanes along = dot(c->normal, c->direction);
    c->inside = less(all_lanes(0), along);
    for (int i = 0; i < 3; i++) {
        lanes turned = choose(c->inside, -c->normal[i], c->normal[i]);
        c->normal[i] = choose(singular, -c->direction[i], turned);
    }
    c->facing = choose(singular, all_lanes(1), smaller(absolute(along), all_lanes(1)));
}

/* The product with a vector that is the same for all. */
INLINE lanes dot_with(const lanes a[3], const double b[3]) {
    return a[0] * all_lanes(b[0]) + a[1] * all_lanes(b[1]) + a[2] * all_lanes(b[2]);
}

/* What is left of light where a share of it arrives. */
INLINE lanes softened(lanes share) { return all_lanes(0.15) + all_lanes(0.85) * share; }

/* O without rays: how far away the end of the ball is along the normal. */
INLINE lanes openness(const canvas *c) {
    lanes along = dot(c->place, c->normal), square = along * along + 1 - dot(c->place, c->place);
    lanes way = root(larger(square, all_lanes(0))) - along;
    return 1 - all_lanes(0.3) * between(all_lanes(0), way, all_lanes(2));
}

/* The light from all around and from the eye. */
INLINE void begin_light(const algsurf_i_colour_job *job, const lanes *open, canvas *c) {
    const algsurf_material *m = &job->material;
    lanes up = dot_with(c->normal, job->up), light;
    if (job->preview) {
        light = all_lanes(0.20) + all_lanes(0.66) * c->facing + all_lanes(0.12) * up;
    } else {
        lanes o = open ? softened(*open) : job->bounded ? openness(c) : all_lanes(1);
        light = all_lanes(m->ambient) * (1 + all_lanes(0.52) * up) * o +
                all_lanes(m->fill) * c->facing * (all_lanes(0.35) + all_lanes(0.65) * o);
    }
    for (int i = 0; i < 3; i++) {
        c->light[i] = light;
        c->plain[i] = all_lanes(1);
    }
}

/* Lambert's law, with a soft end. */
INLINE lanes lambert(lanes cosine) {
    lanes above = larger(cosine, all_lanes(-0.25)) + all_lanes(0.25);
    return choose(less(cosine, all_lanes(0.25)), above * above, cosine);
}

/* A light, of which a share reaches each point; null: all of it. */
INLINE void add_light(const algsurf_i_colour_job *job, int l, const lanes *share, canvas *c) {
    const algsurf_material *m = &job->material;
    const double r = m->roughness * m->roughness;
    lanes s[3], sum[3]; /* L + V: what h and nl + nv are of, also where they are small */
    for (int i = 0; i < 3; i++) s[i] = all_lanes(job->light[l][i]) - c->place[i];
    lanes inverse = 1 / root(dot(s, s) + all_lanes(NEAREST_SQUARED)), cosine = dot(c->normal, s) * inverse;
    for (int i = 0; i < 3; i++) sum[i] = s[i] * inverse - c->direction[i];
    lanes half = larger(dot(sum, sum), all_lanes(LEAST_HALF));
    lanes across = dot(c->normal, sum), narrow = all_lanes(r) * half;
    lanes g = narrow / larger(half - all_lanes(1 - r) * (across * across), narrow);
    lanes k = share ? softened(*share) : all_lanes(1);
    lanes diffuse = all_lanes(m->diffuse) * lambert(cosine) * k;
    lanes above = between(all_lanes(0), 4 * cosine, all_lanes(1));
    lanes specular = all_lanes(m->specular) * (g * g) * (above * k);
    for (int i = 0; i < 3; i++) {
        lanes colour = all_lanes(job->light_colour[l][i]);
        c->light[i] += colour * diffuse;
        c->plain[i] *= 1 - smaller(colour * specular, all_lanes(1));
    }
}

/* All light is there: the colour. */
INLINE void finish_canvas(const algsurf_i_colour_job *job, const canvas *c, lanes colour[3]) {
    const algsurf_material *m = &job->material;
    lanes aside = 1 - c->facing, edge = 1 - all_lanes(0.35) * (aside * aside * aside), depth = all_lanes(0.5);
    if (job->bounded)
        depth = between(all_lanes(0), all_lanes(0.5) + all_lanes(0.5) * dot_with(c->place, job->forward),
                        all_lanes(1));
    lanes haze = all_lanes(job->preview ? 0.3 : m->haze) * (depth * depth);
    for (int i = 0; i < 3; i++) {
        lanes base = choose(c->inside, all_lanes(m->inside[i]), all_lanes(m->outside[i]));
        lanes richer = choose(c->inside, all_lanes(job->richer[1][i]), all_lanes(job->richer[0][i]));
        lanes w = between(all_lanes(0), job->preview ? c->light[i] : c->light[i] * edge, all_lanes(1));
        lanes left = 1 - w, shaded = base * w * (1 + left * left * richer);
        lanes lit = 1 - (1 - shaded) * c->plain[i];
        colour[i] = between(all_lanes(0), lit + haze * (base - lit), all_lanes(1));
    }
}

/* visible[which] of each entry. */
INLINE lanes share_of(const double *visible, int shares, int which, int count) {
    lanes share = all_lanes(0);
    for (int l = 0; l < LANES && l < count; l++) share[l] = (scalar)visible[l * shares + which];
    return share;
}

INLINE void store_colours(const lanes shown[3], int count, float *colour) {
    for (int l = 0; l < LANES && l < count; l++)
        for (int i = 0; i < 3; i++) colour[3 * l + i] = shown[i][l];
}

INLINE void store_bytes(const lanes shown[3], const uint8_t *curve, int count, uint32_t *bytes) {
    integers step[3];
    for (int i = 0; i < 3; i++)
        step[i] = __builtin_convertvector((SRGB_STEPS - 1) * shown[i] + all_lanes(0.5), integers);
    for (int l = 0; l < LANES && l < count; l++)
        bytes[l] = curve[step[0][l]] | (uint32_t)curve[step[1][l]] << 8 | (uint32_t)curve[step[2][l]] << 16;
}

static void find_colours(const algsurf_i_colour_job *job, const algsurf_i_looks *looks, int count,
                         const double *visible, float *colour, uint32_t *bytes) {
    const int lights = job->light_count, shares = lights + 1;
    for (int first = 0; first < count; first += LANES) {
        const int left = count - first;
        const double *own = visible ? visible + (size_t)first * (size_t)shares : NULL;
        canvas c;
        lanes share, shown[3];
        load_canvas(looks, first, left, &c);
        if (own) share = share_of(own, shares, lights, left);
        begin_light(job, own ? &share : NULL, &c);
        for (int l = 0; l < lights; l++) {
            if (own) share = share_of(own, shares, l, left);
            add_light(job, l, own ? &share : NULL, &c);
        }
        finish_canvas(job, &c, shown);
        if (colour)
            store_colours(shown, left, colour + 3 * first);
        else
            store_bytes(shown, job->curve, left, bytes + first);
    }
}

/* Written so that compilers do many at a time. */
static void mark_bytes(const uint8_t *bytes, const uint8_t *others, int count, int limit, uint8_t *marks) {
    for (int i = 0; i < count; i++) {
        uint8_t high = bytes[i] > others[i] ? bytes[i] : others[i];
        uint8_t low = bytes[i] > others[i] ? others[i] : bytes[i];
        marks[i] |= (uint8_t)(high - low) > limit;
    }
}

const algsurf_i_colour_kernel KERNEL(algsurf_i_colour) = {.colours = find_colours, .mark_bytes = mark_bytes};

#endif
