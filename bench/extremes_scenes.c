/* extremes_scenes.c - the scenes of each sweep: see extremes.h.
 *
 * Where a ray has to pass something at a small distance, that something is at the origin or in the plane
 * z = 0, because doubles are densest there: the distance then is what it is said to be, although ray and
 * surface are made of doubles.
 */
#include <math.h>
#include <stdlib.h>

#include "catalogue.h"
#include "extremes.h"

#define TURN 6.283185307179586

static void set_sphere(scene *s, double x, double y, double z, double radius) {
    s->extent = (algsurf_extent){ALGSURF_EXTENT_SPHERE, {x, y, z}, {radius, 0, 0}};
}

/* From `far` radii away to a place inside the extent. */
static void look_into(scene *s, double far, measure_random *random) {
    for (size_t i = 0; i < s->count; i++) {
        double eye[3], target[3], radius = s->extent.size[0];
        random_direction(random, eye);
        random_in_ball(random, target);
        for (int k = 0; k < 3; k++) {
            eye[k] = s->extent.centre[k] + far * radius * eye[k];
            target[k] = s->extent.centre[k] + 0.9 * radius * target[k];
        }
        set_look(s, i, eye, target);
    }
}

/* ---- distance, scale ---- */

void make_distance(int variant, double value, measure_random *random, scene *s) {
    static const char *const names[] = {"tangle", "barth-sextic", "barth-decic"};
    const catalogue_entry *entry = catalogue_find(names[variant]);
    s->extent = entry->extent;
    look_into(s, value, random);
    set_equation(s, entry->equation);
}

/* P(X / value), times value^(degree / 2): for the sextic coefficients from 1e-300 to 1e300. */
void make_scale(int variant, double value, measure_random *random, scene *s) {
    static const char *const names[] = {"sphere", "tangle", "barth-sextic"};
    const catalogue_entry *entry = catalogue_find(names[variant]);
    set_sphere(s, 0, 0, 0, entry->extent.size[0] * value);
    look_into(s, 4, random);
    const double stretch[3] = {value, value, value};
    set_stretched(s, entry->equation, stretch, pow(value, entry->degree / 2));
}

/* ---- gap ---- */

/* Rays in planes z = c through the axis x = y = 0.  The ball x^2 + y^2 + z^2 = 2 z is grazed: roots sqrt(2 c
 * - c^2) on both sides of the axis, or for c < 0 as far off the real line.  (x^2 + y^2 - 1)^2 = z^2, alone
 * and with a ball inside, has its first two roots sqrt(1 + c) and sqrt(1 - c) before the axis; (x^2 + y^2 -
 * 1)^2 = -z^2 has none. */
void make_gap(int variant, double value, measure_random *random, scene *s) {
    static const char *const equations[] = {"x^2 + y^2 + z^2 - 2z", "(x^2 + y^2 - 1)^2 - z^2",
                                            "((x^2 + y^2 - 1)^2 - z^2) (x^2 + y^2 + z^2 - 1/4)",
                                            "(x^2 + y^2 - 1)^2 + z^2"};
    double square = value * value / 4;
    double level = variant == 0 ? square / (1 + sqrt(1 - square)) : value * sqrt(1 - square);
    set_sphere(s, 0, 0, 0, 2);
    for (size_t i = 0; i < s->count; i++) {
        double angle = measure_uniform(random, 0, TURN), below = measure_bits(random) & 1 ? -1 : 1;
        double direction[3] = {cos(angle), sin(angle), 0},
               eye[3] = {-3 * direction[0], -3 * direction[1], below * level};
        set_ray(s, i, eye, direction);
        int misses = variant == 3 || (variant == 0 && below < 0);
        s->expected[i] = misses ? ALGSURF_STATE_MISS : ALGSURF_STATE_HIT;
    }
    set_equation(s, equations[variant]);
}

/* ---- degree ---- */

/* The coefficients of Chebyshev's polynomials are doubles up to degree 64 and beyond: exact. */
void make_degree(int variant, double value, measure_random *random, scene *s) {
    enum { MOST = ALGSURF_MAX_DEGREE + 1 };
    double before[MOST] = {0}, t[MOST] = {0}, next[MOST] = {0};
    algsurf_term terms[3 * MOST + 1];
    int n = (int)value;
    size_t count = 0;
    (void)variant;
    before[0] = t[1] = 1;
    for (int k = 2; k <= n; k++) {
        for (int i = 0; i <= k; i++) next[i] = (i > 0 ? 2 * t[i - 1] : 0) - before[i];
        for (int i = 0; i <= k; i++) before[i] = t[i], t[i] = next[i];
    }
    for (int i = 0; i <= n; i += 2) {
        terms[count++] = (algsurf_term){i, 0, 0, t[i]};
        terms[count++] = (algsurf_term){0, i, 0, t[i]};
        terms[count++] = (algsurf_term){0, 0, i, t[i]};
    }
    terms[count++] = (algsurf_term){0, 0, 0, 1};
    s->extent = (algsurf_extent){ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}};
    look_into(s, 4, random);
    set_terms(s, terms, count);
}

/* ---- singular ---- */

/* Two planes of Barth's sextic meet its unit sphere in a node: y = p x, z = p y. */
static void barth_node(double c[3]) {
    double p = (1 + sqrt(5)) / 2;
    c[0] = 1 / sqrt(1 + p * p + p * p * p * p);
    c[1] = p * c[0];
    c[2] = p * c[1];
}

void make_singular(int variant, double value, measure_random *random, scene *s) {
    static const char *const equations[] = {"x^2 z + y^2", "x^2 + y^2 - z^2",
                                            "x^2 y^2 + x^2 z^2 + y^2 z^2 + x y z", NULL};
    const char *equation = equations[variant];
    set_sphere(s, 0, 0, 0, 2.5);
    for (size_t i = 0; i < s->count; i++) {
        double along[3], across[3], eye[3], c[3] = {0, 0, 0}, part = 0, size = 0;
        if (variant == 0) c[2] = measure_uniform(random, -1, 1);
        if (!equation) barth_node(c);
        random_direction(random, along);
        random_direction(random, across);
        for (int k = 0; k < 3; k++) part += along[k] * across[k];
        for (int k = 0; k < 3; k++) across[k] -= part * along[k], size += across[k] * across[k];
        for (int k = 0; k < 3; k++) eye[k] = c[k] + value * across[k] / sqrt(size) - 4 * along[k];
        set_ray(s, i, eye, along);
    }
    set_equation(s, equation ? equation : catalogue_find("barth-sextic")->equation);
}

/* ---- extent ---- */

/* The extent's centre is 2, 1e3 and 1e6 off the axis z, within 0.3 radii of the surface. */
void make_extent(int variant, double value, measure_random *random, scene *s) {
    static const double offsets[] = {2, 1e3, 1e6};
    double angle = measure_uniform(random, 0, TURN), off = offsets[variant % 3];
    double x = off * cos(angle), y = off * sin(angle), z;
    double shift = 0.3 * value * measure_uniform(random, -1, 1);
    if (variant < 3)
        z = sqrt(x * x + y * y - 1);
    else
        z = sqrt(sqrt(x * x * x * x + y * y * y * y - 1));
    set_sphere(s, x, y, z + shift, value);
    if (variant % 2)
        s->extent =
            (algsurf_extent){ALGSURF_EXTENT_BOX, {x, y, z + shift}, {value, 0.9 * value, 0.8 * value}};
    look_into(s, 4, random);
    set_equation(s, variant < 3 ? "x^2 + y^2 - z^2 - 1" : "x^4 + y^4 - z^4 - 1");
}

/* ---- spread ---- */

/* An ellipsoid and a Tangle whose coefficients of x^n and z^n differ by that much. */
static void make_stretched(int variant, double value, measure_random *random, scene *s) {
    const catalogue_entry *entry = catalogue_find(variant == 0 ? "sphere" : "tangle");
    double radius = entry->extent.size[0], f = pow(value, 1.0 / entry->degree);
    const double stretch[3] = {f, 1, 1 / f};
    set_sphere(s, 0, 0, 0, radius);
    look_into(s, 4, random);
    for (int k = 0; k < 3; k++)
        for (size_t i = 0; i < s->count; i++) {
            s->ray[i].origin[k] *= stretch[k];
            s->ray[i].direction[k] *= stretch[k];
        }
    s->extent = (algsurf_extent){ALGSURF_EXTENT_BOX, {0, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < 3; k++) s->extent.size[k] = radius * stretch[k];
    set_stretched(s, entry->equation, stretch, 1);
}

/* Sparse sextics, unbounded; inside a ball. */
static void make_sparse(int variant, double value, measure_random *random, scene *s) {
    algsurf_term terms[12];
    double most = log10(value);
    for (int k = 0; k < 12; k++) {
        int e[3] = {0, 0, 0};
        for (int total = k % 7; total > 0; total--) e[measure_bits(random) % 3]++;
        double sign = measure_bits(random) & 1 ? -1 : 1;
        terms[k] = (algsurf_term){e[0], e[1], e[2], sign * pow(10, measure_uniform(random, -most, most))};
    }
    set_sphere(s, 0, 0, 0, 2);
    look_into(s, 4, random);
    if (variant == 2) s->extent = (algsurf_extent){.kind = ALGSURF_EXTENT_ALL};
    set_terms(s, terms, 12);
}

void make_spread(int variant, double value, measure_random *random, scene *s) {
    (variant < 2 ? make_stretched : make_sparse)(variant, value, random, s);
}

/* ---- leading ---- */

/* Directions near an asymptotic one: of the terms of highest degree, x^2 z, z^3 and x^2 y^2 (z = 0), the
 * value remains.  Inside a ball, and without end: roots come from infinity. */
void make_leading(int variant, double value, measure_random *random, scene *s) {
    static const char *const equations[] = {"x^2 z + y^2 - 1", "z^3 + x z + y",
                                            "x^2 y^2 + x^2 z^2 + y^2 z^2 + x y z"};
    int which = variant % 3;
    double small = which == 0 ? value : which == 1 ? cbrt(value) : sqrt(value);
    if (variant < 3) set_sphere(s, 0, 0, 0, 3);
    for (size_t i = 0; i < s->count; i++) {
        double angle = measure_uniform(random, 0, TURN), sign = measure_bits(random) & 1 ? -1 : 1, eye[3];
        double flat[3] = {cos(angle), sin(angle), sign * small}, steep[3] = {1, sign * small, 0};
        const double *direction = which == 2 ? steep : flat;
        random_in_ball(random, eye);
        for (int k = 0; k < 3; k++) eye[k] -= 3 * direction[k];
        set_ray(s, i, eye, direction);
    }
    set_equation(s, equations[which]);
}
