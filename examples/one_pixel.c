/* one_pixel.c - one pixel's way through the library, with numbers.
 *
 * The surface is the tangle cube, the picture that of `render tangle --eye 7.5,-10,6 --look-at 0,0,0 --fov
 * 30`.  Polynomial and colour are made by the public functions that do it alone; the search for the root is
 * what an observer sees of the call that does all of it.  What is printed here is explained in
 * guide/how-it-works.md.
 *
 *     cc -O2 -I../include one_pixel.c $(find ../lib -name "*.c") -lm -pthread -o one_pixel
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "algsurf/algsurf.h"

enum { WIDTH = 1024, HEIGHT = 768, PIXEL_X = 400, PIXEL_Y = 148, DEGREE = 4 };

static const char EQUATION[] = "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8";
static const algsurf_extent BALL = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3.7, 0, 0}};

/* The numbers below are known to be fine; what fails is a mistake in this program. */
static void check(algsurf_status status) {
    if (status == ALGSURF_OK) return;
    fprintf(stderr, "one_pixel: %s\n", algsurf_status_text(status));
    exit(1);
}

static algsurf_surface *surface_of(const char *equation) {
    algsurf_surface *surface;
    check(algsurf_surface_from_equation(equation, NULL, 0, &surface, NULL));
    return surface;
}

static void print_vector(const char *name, const double v[3]) {
    printf("%-10s (%.10f, %.10f, %.10f)\n", name, v[0], v[1], v[2]);
}

/* ---- pixel -> ray -> chord ---- */

static algsurf_camera make_camera(void) {
    const double eye[3] = {7.5, -10, 6}, look_at[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    algsurf_camera camera;
    check(algsurf_camera_pinhole(eye, look_at, up, 30, &camera));
    return camera;
}

static algsurf_ray ray_through(const algsurf_camera *camera, int x, int y) {
    algsurf_ray ray;
    check(algsurf_camera_ray(camera, WIDTH, HEIGHT, x + 0.5, y + 0.5, &ray));
    return ray;
}

static algsurf_ray chord_of(const algsurf_ray *ray) {
    algsurf_ray chord;
    int meets;
    check(algsurf_ray_clip(ray, &BALL, NULL, 0, &chord, &meets));
    return chord;
}

static void show_ray(const algsurf_ray *ray, const algsurf_ray *chord) {
    printf("[ray]\npixel      (%d, %d) of %d x %d\n", PIXEL_X, PIXEL_Y, WIDTH, HEIGHT);
    print_vector("origin", ray->origin);
    print_vector("direction", ray->direction);
    printf("chord      t from %.10f to %.10f\n", chord->t_min, chord->t_max);
}

/* ---- the polynomial ---- */

/* t = middle + half s, s in [-1,1]: the same line from the middle of the chord. */
typedef struct centred {
    double middle, half;
    double c[DEGREE + 1], r[DEGREE + 1];
} centred;

static centred expand_centred(const algsurf_surface *surface, const algsurf_ray *chord) {
    centred p = {.half = 0.5 * (chord->t_max - chord->t_min)};
    algsurf_ray middle = {.t_min = -1, .t_max = 1};
    p.middle = chord->t_min + p.half;
    for (int i = 0; i < 3; i++) {
        middle.origin[i] = fma(p.middle, chord->direction[i], chord->origin[i]);
        middle.direction[i] = p.half * chord->direction[i];
    }
    check(algsurf_expand_power(surface, &middle, p.c, p.r));
    return p;
}

static void show_polynomial(const algsurf_surface *surface, const algsurf_ray *ray, const centred *p) {
    double c[DEGREE + 1], r[DEGREE + 1];
    check(algsurf_expand_power(surface, ray, c, r));
    printf("\n[polynomial]\nk      p_k about the eye  radius   about the middle  radius\n");
    for (int k = 0; k <= DEGREE; k++)
        printf("%d %21.10f  %.1e  %15.10f  %.1e\n", k, c[k], r[k], p->c[k], p->r[k]);
    algsurf_ray far = *ray;
    for (int i = 0; i < 3; i++) far.origin[i] = fma(-1e4, ray->direction[i], ray->origin[i]);
    check(algsurf_expand_power(surface, &far, c, r));
    printf("p_0 about a point 10000 behind the eye: %.4e, radius %.1e\n", c[0], r[0]);
}

/* ---- isolation and refinement: what algsurf_intersect_first does ---- */

/* Told as the call goes; the surface and the chord are for the numbers beside it. */
typedef struct walk {
    const algsurf_surface *surface;
    const algsurf_ray *chord;
    int cells, points;
} walk;

/* An interval, as fractions of the chord, and its Bernstein coefficients, computed once more. */
static void print_cell(const algsurf_cell *cell, void *data) {
    walk *w = data;
    double b[DEGREE + 1], length = w->chord->t_max - w->chord->t_min;
    algsurf_ray part = *w->chord;
    part.t_min = cell->lo;
    part.t_max = cell->hi;
    check(algsurf_expand_bernstein(w->surface, &part, b, NULL));
    if (w->cells++ == 0)
        printf("\n[isolation]\nfrom     to          b_0      b_1      b_2      b_3      b_4   signs       "
               "variations\n");
    printf("%-8.5f %-7.5f", (cell->lo - w->chord->t_min) / length, (cell->hi - w->chord->t_min) / length);
    for (int j = 0; j <= DEGREE; j++) printf("%9.3f", b[j]);
    printf("   ");
    for (int j = 0; j <= DEGREE; j++) printf("%c ", "-0+?"[cell->signs[j] + 1]);
    printf("  %d%s\n", cell->variations,
           cell->variations == 0   ? ", no root"
           : cell->variations == 1 ? ", one root"
                                   : "");
}

static void print_point(double t, double value, int engine, void *data) {
    walk *w = data;
    (void)engine;
    if (w->points++ == 0) printf("\n[refinement]\n              t              p\n");
    printf("%18.13f  %12.3e\n", t, value);
}

static algsurf_hit show_walk(const algsurf_surface *surface, const algsurf_ray *ray,
                             const algsurf_ray *chord) {
    walk w = {.surface = surface, .chord = chord};
    algsurf_observer observer = {
        .size = sizeof observer, .data = &w, .on_cell = print_cell, .on_point = print_point};
    const algsurf_intersect_options watched = {.size = sizeof watched, .observer = &observer};
    algsurf_hit hit;
    check(algsurf_intersect_first(surface, &BALL, ray, &watched, &hit));
    printf("intervals %d, evaluations %d, decided by %s\n", (int)observer.cells, (int)observer.evaluations,
           observer.engine == ALGSURF_ENGINE_DOUBLES ? "doubles" : "integers");
    return hit;
}

/* ---- hit, colour ---- */

static void show_hit(const algsurf_hit *hit) {
    printf("\n[hit]\nstate      %s\n", hit->state == ALGSURF_STATE_HIT ? "hit" : "other");
    printf("t          %.12f in t + [%.1e, %.1e]\n", hit->t, hit->t_lo - hit->t, hit->t_hi - hit->t);
    print_vector("position", hit->position);
    print_vector("normal", hit->normal);
}

static void show_colour(const algsurf_surface *surface, const algsurf_camera *camera, const algsurf_ray *ray,
                        const algsurf_hit *hit) {
    static uint8_t pixels[3 * WIDTH];
    static double t[WIDTH];
    const algsurf_picture planes = {.size = sizeof planes, .pixels = pixels, .t = t};
    double colour[3];
    algsurf_scene *scene;
    const algsurf_render_options row = {
        .size = sizeof row, .width = WIDTH, .height = HEIGHT, .row_begin = PIXEL_Y, .row_end = PIXEL_Y + 1};
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    unsigned char bytes[3];
    check(algsurf_scene_create(surface, &scene));
    check(algsurf_scene_set_extent(scene, &BALL));
    check(algsurf_scene_set_camera(scene, camera));
    check(algsurf_scene_get_lighting(scene, lights, &lighting));
    check(algsurf_shade(&lighting, NULL, hit->position, hit->normal, ray->direction, colour));
    check(algsurf_srgb_encode(colour, bytes));
    check(algsurf_render(scene, &row, &planes, NULL));
    algsurf_scene_free(scene);
    const uint8_t *pixel = pixels + 3 * PIXEL_X;
    printf("\n[colour]\nred, green, blue   %.4f %.4f %.4f\n", colour[0], colour[1], colour[2]);
    printf("as bytes           %d %d %d\n", bytes[0], bytes[1], bytes[2]);
    printf("algsurf_render     %d %d %d, t = %.10f\n", pixel[0], pixel[1], pixel[2], t[PIXEL_X]);
}

/* ---- undecided signs ---- */

static const char *state_name(int state) {
    return state == ALGSURF_STATE_HIT ? "hit" : state == ALGSURF_STATE_MISS ? "miss" : "undecided";
}

/* Of each root on the ray its multiplicity; how far apart the doubles next to two of them are. */
static void print_multiplicities(const algsurf_surface *surface, const algsurf_ray *ray) {
    algsurf_hit hits[DEGREE];
    int count = 0;
    check(algsurf_intersect_all(surface, NULL, ray, NULL, hits, DEGREE, &count));
    for (int i = 0; i < count; i++) printf(i ? ", %d" : "%d", hits[i].multiplicity);
    if (count > 1) printf(", %.1e apart", hits[1].t - hits[0].t);
    putchar('\n');
}

/* Along these rays the polynomial is (x^2 - 2)^2 - z^2: two roots about z / sqrt(2) apart. */
static void show_undecided(const algsurf_surface *tangle) {
    static const int tiers[] = {ALGSURF_TIER_BOUNDED, ALGSURF_TIER_CERTIFIED};
    static const int powers[] = {10, 40, 80, 0};
    algsurf_surface *sheets = surface_of("(x^2 + y^2 - 2)^2 - z^2");
    printf("\n[undecided]\nz       bounded    certified  roots: multiplicities\n");
    for (int i = 0; i < 4; i++) {
        algsurf_ray ray = {{-3, 0, powers[i] ? ldexp(1, -powers[i]) : 0}, {1, 0, 0}, 0, 3};
        printf(powers[i] ? "2^-%-4d" : "%-7d", powers[i]);
        for (int k = 0; k < 2; k++) {
            const algsurf_intersect_options options = {.size = sizeof options, .tier = tiers[k]};
            algsurf_hit hit;
            check(algsurf_intersect_first(sheets, NULL, &ray, &options, &hit));
            printf(" %-10s", state_name(hit.state));
        }
        putchar(' ');
        print_multiplicities(sheets, &ray);
    }
    algsurf_surface_free(sheets);
    printf("coefficients of the tangle cube: relative rounding error %.1e\n",
           algsurf_surface_rounding(tangle));
}

/* ---- rows ---- */

/* The Bernstein coefficient b_2 of a pixel over the depths -R <= z <= R of the whole frame: the ray is
 * X = u + z (w + u/D), u the point where it meets the plane through the centre, w the view, D the distance.
 */
static double row_coefficient(const algsurf_surface *surface, const algsurf_camera *camera, int x) {
    double distance = 0, b[DEGREE + 1], along = 0;
    algsurf_ray pixel = ray_through(camera, x, PIXEL_Y), line = {.t_min = -3.7, .t_max = 3.7};
    for (int i = 0; i < 3; i++) {
        distance -= camera->eye[i] * camera->forward[i];
        along += pixel.direction[i] * camera->forward[i];
    }
    for (int i = 0; i < 3; i++) {
        line.direction[i] = pixel.direction[i] / along;
        line.origin[i] = camera->eye[i] + distance * line.direction[i];
    }
    check(algsurf_expand_bernstein(surface, &line, b, NULL));
    return b[2];
}

static void show_row(const algsurf_surface *surface, const algsurf_camera *camera) {
    enum { STEP = 60, FIRST = 250 };
    double b[DEGREE + 2];
    printf("\n[row]\npixel     b_2 over the depths of the frame\n");
    for (int i = 0; i <= DEGREE + 1; i++) {
        b[i] = row_coefficient(surface, camera, FIRST + i * STEP);
        printf("%5d  %16.10f\n", FIRST + i * STEP, b[i]);
    }
    double last = 5 * b[4] - 10 * b[3] + 10 * b[2] - 5 * b[1] + b[0]; /* the fifth difference is 0 */
    printf("%5d  %16.10f from the five others\n", FIRST + (DEGREE + 1) * STEP, last);
}

/* ---- packets ---- */

static void show_packet(const algsurf_surface *surface, const algsurf_camera *camera) {
    enum { RAYS = 8 };
    double origin[3][RAYS], direction[3][RAYS], t[RAYS];
    int same = 1;
    unsigned char state[RAYS];
    algsurf_ray_packet rays = {.size = sizeof rays, .count = RAYS};
    const algsurf_hit_packet hits = {.size = sizeof hits, .state = state, .t = t};
    for (int k = 0; k < 3; k++) rays.origin[k] = origin[k], rays.direction[k] = direction[k];
    for (int i = 0; i < RAYS; i++) {
        algsurf_ray ray = ray_through(camera, PIXEL_X - 4 + i, PIXEL_Y);
        for (int k = 0; k < 3; k++) origin[k][i] = ray.origin[k], direction[k][i] = ray.direction[k];
    }
    check(algsurf_intersect_packet(surface, &BALL, &rays, NULL, &hits));
    printf("\n[packet]\npixel  state      t\n");
    for (int i = 0; i < RAYS; i++) {
        algsurf_hit hit;
        algsurf_ray ray = ray_through(camera, PIXEL_X - 4 + i, PIXEL_Y);
        check(algsurf_intersect_first(surface, &BALL, &ray, NULL, &hit));
        printf("%5d  %-9s  %.10f\n", PIXEL_X - 4 + i, state_name(state[i]), t[i]);
        same &= hit.state == state[i] && hit.t == t[i];
    }
    printf("single calls: the same bits: %s\n", same ? "yes" : "no");
}

/* ---- complex space ---- */

static void print_roots(const centred *p, const algsurf_complex_root *roots, int count) {
    for (int i = 0; i < count; i++) {
        double re = p->middle + p->half * roots[i].root.re, im = p->half * roots[i].root.im;
        printf("  %.10f %+.10f i   |t| %.6f%s\n", re, im, hypot(re, im),
               roots[i].real ? "   real, proved" : "");
    }
}

static void show_complex_space(const algsurf_surface *surface, const algsurf_ray *ray, const centred *p) {
    const double degree = 3.14159265358979323846 / 180;
    const double imaginary[1] = {2};
    const algsurf_complex_space space = {
        .size = sizeof space, .sector = {0, 2 * degree}, .imaginary = imaginary, .imaginary_count = 1};
    algsurf_complex_root roots[DEGREE];
    algsurf_complex c[DEGREE + 1], root;
    algsurf_hit hit;
    int count;
    check(algsurf_complex_roots_of_real(p->c, p->r, DEGREE, roots, &count));
    printf("\n[complex space]\nall roots t\n");
    print_roots(p, roots, count);
    for (int k = 0; k <= DEGREE; k++) c[k] = (algsurf_complex){p->c[k], k == 0 ? 2 : 0};
    check(algsurf_complex_roots(c, p->r, DEGREE, roots, &count));
    printf("with 2 i added to p_0\n");
    print_roots(p, roots, count);
    check(algsurf_intersect_complex(surface, &BALL, ray, &space, NULL, NULL, &hit, &root));
    printf("seen with |arg t| <= 2 degrees: %s, |t| = %.10f, arg %.4f degrees\n", state_name(hit.state),
           hit.t, atan2(root.im, root.re) / degree);
}

int main(int argc, char **argv) {
    if (argc > 1) {
        fprintf(stderr, "%s: takes no arguments\n", argv[0]);
        return 2;
    }
    algsurf_surface *surface = surface_of(EQUATION);
    algsurf_camera camera = make_camera();
    algsurf_ray ray = ray_through(&camera, PIXEL_X, PIXEL_Y), chord = chord_of(&ray);
    centred p = expand_centred(surface, &chord);

    show_ray(&ray, &chord);
    show_polynomial(surface, &ray, &p);
    algsurf_hit hit = show_walk(surface, &ray, &chord);
    show_hit(&hit);
    show_colour(surface, &camera, &ray, &hit);
    show_undecided(surface);
    show_row(surface, &camera);
    show_packet(surface, &camera);
    show_complex_space(surface, &ray, &p);
    algsurf_surface_free(surface);
    return 0;
}
