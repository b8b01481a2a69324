/* extremes_cases.c - see extremes.h: the list of sweeps, and what their makers share. */
#include "extremes.h"

#include <math.h>
#include <stdlib.h>

#include "must.h"
#include "rays.h"

#define VALUES(array) array, sizeof array / sizeof *array

static const double distances[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
static const double scales[] = {1e-100, 1e-80, 1e-60, 1e-40, 1e-20, 1, 1e20, 1e40, 1e60, 1e80, 1e100};
static const double closeness[] = {1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7,
                                   1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1, 1};
static const double degrees[] = {2, 4, 6, 8, 10, 12, 16, 20, 24, 32, 40, 48, 56, 64};
static const double sizes[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
static const double spreads[] = {1, 1e15, 1e30, 1e45, 1e60, 1e75, 1e90, 1e105, 1e120, 1e135, 1e150};
static const double leading[] = {0,     1e-300, 1e-250, 1e-200, 1e-150, 1e-100, 1e-50, 1e-40,
                                 1e-30, 1e-25,  1e-20,  1e-15,  1e-10,  1e-5,   1};

const sweep sweeps[SWEEPS] = {
    {"distance", "A far eye: Tangle, Barth's sextic and decic",
     "distance of the eye from the extent's centre, in radii of the extent", VALUES(distances), 3,
     make_distance},
    {"scale", "Large and small surfaces: sphere, Tangle, Barth's sextic",
     "factor by which the surface is scaled", VALUES(scales), 3, make_scale},
    {"gap", "First two roots close together: a grazed sphere, products of shifted surfaces",
     "distance of the first two roots along the ray (or how far it passes by)", VALUES(closeness), 4,
     make_gap},
    {"degree", "High degrees: Chmutov's surfaces T(x) + T(y) + T(z) + 1 = 0, T(cos a) = cos(n a)", "degree n",
     VALUES(degrees), 1, make_degree},
    {"singular",
     "Near singular points: Whitney's line, cone, Steiner's triple point, a node of Barth's sextic",
     "distance at which the ray passes the singular point", VALUES(closeness), 4, make_singular},
    {"extent", "Large and small extents, up to a million off the origin: quadric, quartic",
     "radius of the extent", VALUES(sizes), 6, make_extent},
    {"spread", "Coefficients of different size: stretched surfaces, sparse sextics of random size",
     "largest coefficient, the smallest being its inverse", VALUES(spreads), 4, make_spread},
    {"leading", "Vanishing leading coefficients: pinched cubic, cusp, Steiner's surface",
     "leading coefficient of P along the ray (0 is shown at 1e-307)", VALUES(leading), 6, make_leading}};

/* ---- surfaces ---- */

static void take_surface(scene *s, algsurf_surface *surface) {
    s->surface = surface;
    s->term_count = algsurf_surface_term_count(surface);
    s->terms = must_allocate(s->term_count, sizeof *s->terms);
    must(algsurf_surface_terms(surface, s->terms), "terms");
}

void set_equation(scene *s, const char *equation) {
    algsurf_surface *surface;
    must(algsurf_surface_from_equation(equation, NULL, 0, &surface, NULL), equation);
    take_surface(s, surface);
}

void set_terms(scene *s, const algsurf_term *terms, size_t count) {
    algsurf_surface *surface;
    must(algsurf_surface_from_terms(terms, count, &surface), "surface");
    take_surface(s, surface);
}

void set_stretched(scene *s, const char *equation, const double stretch[3], double size) {
    scene plain = {0};
    set_equation(&plain, equation);
    for (size_t k = 0; k < plain.term_count; k++) {
        algsurf_term *term = &plain.terms[k];
        double root = pow(stretch[0], -0.5 * term->i) * pow(stretch[1], -0.5 * term->j) *
                      pow(stretch[2], -0.5 * term->k);
        term->a *= root * size * root; /* the factor itself may be beyond the doubles */
    }
    set_terms(s, plain.terms, plain.term_count);
    scene_free(&plain);
}

/* ---- rays ---- */

void random_in_ball(measure_random *random, double x[3]) {
    double square;
    do {
        square = 0;
        for (int k = 0; k < 3; k++) {
            x[k] = measure_uniform(random, -1, 1);
            square += x[k] * x[k];
        }
    } while (square > 1);
}

/* |w|, with neither overflow nor underflow. */
static double length(const double w[3]) { return hypot(hypot(w[0], w[1]), w[2]); }

void random_direction(measure_random *random, double w[3]) {
    do random_in_ball(random, w);
    while (length(w) < 0.1);
    double size = length(w);
    for (int k = 0; k < 3; k++) w[k] /= size;
}

void set_ray(scene *s, size_t i, const double eye[3], const double direction[3]) {
    s->ray[i] =
        (algsurf_ray){{eye[0], eye[1], eye[2]}, {direction[0], direction[1], direction[2]}, 0, INFINITY};
    s->expected[i] = ALGSURF_STATE_UNDECIDED;
}

void set_look(scene *s, size_t i, const double eye[3], const double target[3]) {
    double direction[3], size;
    for (int k = 0; k < 3; k++) direction[k] = target[k] - eye[k];
    size = length(direction);
    for (int k = 0; k < 3; k++) direction[k] /= size;
    set_ray(s, i, eye, direction);
}

/* ---- scenes ---- */

void scene_make(const sweep *from, int point, int variant, size_t count, int seed, scene *s) {
    measure_random random = {((uint64_t)seed << 32) + (uint64_t)(from - sweeps) * 10000 +
                             (uint64_t)point * 100 + (uint64_t)variant};
    *s = (scene){
        .count = count, .ray = must_allocate(count, sizeof *s->ray), .expected = must_allocate(count, 1)};
    from->make(variant, from->values[point], &random, s);
    s->packet = rays_packet(s->ray, count);
}

void scene_free(scene *s) {
    algsurf_surface_free(s->surface);
    free(s->terms);
    free(s->ray);
    rays_packet_free(&s->packet);
    free(s->expected);
}
