/* shade_reference.h - the formula of algsurf/shade.h, in double precision, as it is written there. */
#ifndef SHADE_REFERENCE_H
#define SHADE_REFERENCE_H
#include <math.h>

#include "algsurf/shade.h"
#include "random.h"

static inline double reference_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double reference_within(double low, double x, double high) { return fmin(fmax(x, low), high); }

/* The unit vector from one place to another, however far; 0 if they are one. */
static inline void reference_towards(const double from[3], const double to[3], double unit[3]) {
    double way[3], most = 0;
    for (int i = 0; i < 3; i++) way[i] = to[i] / 2 - from[i] / 2, most = fmax(most, fabs(way[i]));
    for (int i = 0; i < 3; i++) way[i] = most > 0 ? way[i] / most : 0;
    double length = sqrt(reference_dot(way, way));
    for (int i = 0; i < 3; i++) unit[i] = most > 0 ? way[i] / length : 0;
}

static inline double reference_lambert(double x) {
    return x >= 0.25 ? x : x <= -0.25 ? 0 : (x + 0.25) * (x + 0.25);
}

/* S of a light in a channel where it has that colour. */
static inline double reference_highlight(const algsurf_material *m, double colour, double k, double nl,
                                         double nv, double lv) {
    double r = m->roughness * m->roughness, h = 2 + 2 * lv;
    if (!(nl > 0) || !(h > 0)) return 0;
    double g = r * h / (h - (1 - r) * (nl + nv) * (nl + nv));
    return fmin(1, m->specular * colour * k * g * g * fmin(1, 4 * nl));
}

typedef struct reference_point {
    double n[3], v[3], q[3], nv;
    const double *base;
} reference_point;

static inline reference_point reference_look(const algsurf_lighting *lighting, const double point[3],
                                             const double normal[3], const double direction[3]) {
    reference_point p;
    double along = reference_dot(normal, direction);
    int singular = normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
    for (int i = 0; i < 3; i++) {
        p.v[i] = -direction[i];
        p.n[i] = singular ? p.v[i] : along > 0 ? -normal[i] : normal[i];
        p.q[i] = (point[i] - lighting->centre[i]) / lighting->radius;
    }
    p.nv = fmin(1, reference_dot(p.n, p.v));
    p.base = along > 0 ? lighting->material->inside : lighting->material->outside;
    return p;
}

static inline double reference_openness(const algsurf_lighting *lighting, const double *visible,
                                        const reference_point *p) {
    if (visible) return 0.15 + 0.85 * visible[lighting->light_count];
    if (!lighting->bounded) return 1;
    double along = reference_dot(p->q, p->n);
    double d = sqrt(fmax(0, along * along + 1 - reference_dot(p->q, p->q))) - along;
    return 1 - 0.3 * reference_within(0, d, 2);
}

/* c of what light arrives. */
static inline double reference_base(const reference_point *p, int channel, double e) {
    double a = p->base[channel], w = fmin(e, 1);
    double luminance = 0.2126 * p->base[0] + 0.7152 * p->base[1] + 0.0722 * p->base[2];
    if (luminance == 0) return 0;
    return a * w * (1 + (1 - w) * (1 - w) * 0.8 * fmin(a / luminance - 1, 3));
}

static inline double reference_haze(const algsurf_lighting *lighting, const reference_point *p) {
    double z = lighting->bounded ? 0.5 + 0.5 * reference_dot(p->q, lighting->forward) : 0.5;
    z = reference_within(0, z, 1);
    return z * z;
}

/* algsurf_shade of what is checked. */
static inline void reference_shade(const algsurf_lighting *lighting, const double *visible,
                                   const double point[3], const double normal[3], const double direction[3],
                                   double colour[3]) {
    const algsurf_material *m = lighting->material;
    const reference_point p = reference_look(lighting, point, normal, direction);
    double o = reference_openness(lighting, visible, &p), up = reference_dot(p.n, lighting->up);
    double aside = 1 - p.nv, edge = 1 - 0.35 * aside * aside * aside;
    for (int i = 0; i < 3; i++) {
        double lights = 0, left = 1;
        for (size_t l = 0; l < lighting->light_count; l++) {
            const algsurf_light *light = &lighting->lights[l];
            double to[3], k = visible ? 0.15 + 0.85 * visible[l] : 1;
            reference_towards(point, light->position, to);
            double nl = reference_dot(p.n, to);
            lights += light->colour[i] * k * reference_lambert(nl);
            left *= 1 - reference_highlight(m, light->colour[i], k, nl, p.nv, reference_dot(to, p.v));
        }
        double e =
            (m->diffuse * lights + m->ambient * (1 + 0.52 * up) * o + m->fill * p.nv * (0.35 + 0.65 * o)) *
            edge;
        double c = reference_base(&p, i, e);
        c = 1 - (1 - c) * left;
        colour[i] = c + (p.base[i] - c) * m->haze * reference_haze(lighting, &p);
    }
}

/* algsurf_shade_preview likewise. */
static inline void reference_preview(const algsurf_lighting *lighting, const double point[3],
                                     const double normal[3], const double direction[3], double colour[3]) {
    const reference_point p = reference_look(lighting, point, normal, direction);
    double e = 0.20 + 0.66 * p.nv + 0.12 * reference_dot(p.n, lighting->up);
    for (int i = 0; i < 3; i++) {
        double c = reference_base(&p, i, e);
        colour[i] = c + (p.base[i] - c) * 0.3 * reference_haze(lighting, &p);
    }
}

/* Of length 1. */
static inline void random_direction(uint64_t *state, double v[3]) {
    double length;
    do {
        for (int i = 0; i < 3; i++) v[i] = random_unit(state);
        length = sqrt(reference_dot(v, v));
    } while (!(length > 0.1 && length < 1));
    for (int i = 0; i < 3; i++) v[i] /= length;
}

#endif
