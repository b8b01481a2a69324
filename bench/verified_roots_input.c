/* verified_roots_input.c - see verified_roots.h.
 *
 * The neighbour is the ray one pixel to the left; its roots are brought to the variable of the
 * ray by way of the distance from the eye, which both measure alike.
 */
#include "verified_roots.h"

#include <math.h>
#include <stdlib.h>

#include "must.h"
#include "rays.h"

enum { WIDTH = 1024, HEIGHT = 768, TRIES = 1000 };

/* A real polynomial keeps start values that are real, or come in conjugate pairs, so for ever; at a
 * silhouette two real roots of the neighbour are a pair of this ray.  So all move off the axis, in half
 * chords. */
static const double OFF_AXIS = 1e-4;

typedef struct view {
    const algsurf_surface *surface;
    const algsurf_extent *extent;
    algsurf_camera camera;
} view;

/* t = middle + half X, t measured from the eye. */
typedef struct chord {
    double middle, half;
} chord;

/* The polynomial along the ray of a pixel; 0 when the ray has no chord or the polynomial no roots. */
static int expand_pixel(const view *v, int x, int y, chord *on, polynomial *p) {
    algsurf_ray ray = rays_ray(&v->camera, WIDTH, HEIGHT, x, y);
    double c[ALGSURF_MAX_DEGREE + 1];
    if (!rays_clip(&ray, v->extent, &ray) || !(ray.t_min < ray.t_max)) return 0;
    on->middle = 0.5 * (ray.t_min + ray.t_max);
    on->half = 0.5 * (ray.t_max - ray.t_min);
    rays_expand(v->surface, &ray, c);
    p->degree = algsurf_surface_degree(v->surface);
    for (int k = 0; k <= p->degree; k++) p->c[k] = (algsurf_complex){c[k], 0};
    while (p->degree > 0 && c[p->degree] == 0) p->degree--;
    return p->degree > 0;
}

static int by_magnitude(const void *left, const void *right) {
    const algsurf_complex *a = left, *b = right;
    double x = hypot(a->re, a->im), y = hypot(b->re, b->im);
    return (x > y) - (x < y);
}

/* Start values for p, on its chord, from the roots of the neighbour on its own, if they are all simple. */
static void start_near(polynomial *p, chord on, const polynomial *neighbour, chord other) {
    algsurf_complex_root root[ALGSURF_MAX_DEGREE];
    int count;
    p->has_near = 0;
    if (neighbour->degree != p->degree ||
        algsurf_complex_roots(neighbour->c, NULL, neighbour->degree, root, &count) != ALGSURF_OK ||
        count != p->degree)
        return;
    double shift = (other.middle - on.middle) / on.half, scale = other.half / on.half;
    for (int i = 0; i < count; i++) {
        p->near[i].re = shift + scale * root[i].root.re;
        p->near[i].im = scale * root[i].root.im + OFF_AXIS;
    }
    qsort(p->near, (size_t)count, sizeof *p->near, by_magnitude);
    p->has_near = 1;
}

/* A whole number in 0..below-1. */
static int pick(measure_random *random, int below) { return (int)(measure_bits(random) % (uint64_t)below); }

static void polynomial_of_ray(const view *v, measure_random *random, polynomial *p) {
    polynomial neighbour;
    chord on, other;
    for (int i = 0; i < TRIES; i++) {
        int x = pick(random, WIDTH), y = pick(random, HEIGHT);
        if (!expand_pixel(v, x, y, &on, p)) continue;
        p->has_near = 0;
        if (expand_pixel(v, x - 1, y, &other, &neighbour)) start_near(p, on, &neighbour, other);
        return;
    }
    cli_fail(CLI_BROKEN, "hardly a ray meets what is shown");
}

void polynomials_of_rays(const catalogue_entry *entry, measure_random *random, polynomial *p, int count) {
    algsurf_surface *surface = rays_surface(entry);
    const view v = {surface, &entry->extent, rays_catalogue_camera(entry)};
    for (int i = 0; i < count; i++) polynomial_of_ray(&v, random, &p[i]);
    algsurf_surface_free(surface);
}

void polynomials_at_random(int degree, measure_random *random, polynomial *p, int count) {
    for (int i = 0; i < count; i++) {
        p[i].degree = degree;
        p[i].has_near = 0;
        for (int k = 0; k <= degree; k++) {
            p[i].c[k].re = measure_uniform(random, -1, 1);
            p[i].c[k].im = measure_uniform(random, -1, 1);
        }
    }
}

/* Coefficients move by up to this much of themselves from a pixel to the next. */
static const double PIXEL = 0x1p-10;

void polynomials_with_neighbours(int degree, measure_random *random, polynomial *p, int count) {
    const chord same = {0, 1};
    polynomials_at_random(degree, random, p, count);
    for (int i = 0; i < count; i++) {
        polynomial neighbour = p[i];
        for (int k = 0; k <= degree; k++) {
            neighbour.c[k].re *= 1 + PIXEL * measure_uniform(random, -1, 1);
            neighbour.c[k].im *= 1 + PIXEL * measure_uniform(random, -1, 1);
        }
        start_near(&p[i], same, &neighbour, same);
    }
}

/* A place in the unit disc, parts multiples of 1/8. */
static algsurf_complex grid_place(measure_random *random) {
    for (;;) {
        algsurf_complex z = {(pick(random, 17) - 8) / 8.0, (pick(random, 17) - 8) / 8.0};
        if (z.re * z.re + z.im * z.im <= 1) return z;
    }
}

/* Different places. */
static void pick_places(measure_random *random, algsurf_complex *z, int count) {
    for (int i = 0; i < count; i++) {
        int fresh = 0;
        while (!fresh) {
            z[i] = grid_place(random);
            fresh = 1;
            for (int j = 0; j < i; j++) fresh &= z[i].re != z[j].re || z[i].im != z[j].im;
        }
    }
}

/* p times X - z.  Exact for the first 12 places of the grid: after m factors coefficients are multiples of
 * 8^-m below 2^m, and 4 m <= 53. */
static void multiply_by(polynomial *p, algsurf_complex z) {
    p->c[p->degree + 1] = p->c[p->degree];
    for (int k = p->degree; k >= 0; k--) {
        algsurf_complex a = p->c[k], below = k > 0 ? p->c[k - 1] : (algsurf_complex){0, 0};
        p->c[k].re = below.re - (a.re * z.re - a.im * z.im);
        p->c[k].im = below.im - (a.re * z.im + a.im * z.re);
    }
    p->degree++;
}

void polynomials_with_cluster(int degree, int cluster, double gap, measure_random *random, polynomial *p,
                              int count) {
    const double turn = 2 * acos(-1) / cluster, radius = gap / (2 * sin(turn / 2));
    algsurf_complex z[ALGSURF_MAX_DEGREE];
    for (int i = 0; i < count; i++) {
        p[i].degree = p[i].has_near = 0;
        p[i].c[0] = (algsurf_complex){1, 0};
        pick_places(random, z, degree - cluster + 1);
        for (int k = 0; k < cluster; k++)
            multiply_by(
                &p[i], (algsurf_complex){z[0].re + radius * cos(k * turn), z[0].im + radius * sin(k * turn)});
        for (int k = 1; k <= degree - cluster; k++) multiply_by(&p[i], z[k]);
    }
}
