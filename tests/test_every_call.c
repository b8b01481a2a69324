/* test_every_call.c - every public function, with special values in each place where it takes a double, in
 * every environment that a host may have set: the answer has the same bits in all of them; control bits and
 * exception flags come back as they were; where all traps are open, none is sprung.
 *
 * check_symbols compares the calls with lib/algsurf.map: a function without one fails.
 *
 * The test moves doubles and never computes with them: what it did itself would raise flags, too.  Special
 * values go through the calls place by place: the first call counts the places (number()), then each place
 * gets each value.  The usual environment's answers come first, as a hash of all that is written.
 *
 * Breaks tried, each caught:
 *   a comparison before the environment is entered: algsurf_scene_set_antialias_threshold,
 *   algsurf_scene_set_intersect_options, algsurf_surface_with_error, algsurf_count_roots;
 *   isfinite() of a caller's double there: algsurf_surface_from_terms, algsurf_surface_from_equation;
 *   a result looked at after it is left: algsurf_surface_value, algsurf_surface_gradient;
 *   a subnormal imaginary part taken for 0 there: algsurf_scene_set_complex_space;
 *   the environment not entered: algsurf_refine_function, algsurf_interval_add (traps; other bits)
 */
#define _POSIX_C_SOURCE 200809L /* sigaction */
#include <signal.h>

#include "algsurf/algsurf.h"
#include "environments.h"
#include "unit.h"

/* ---- the values ---- */

/* Bits: signalling NaNs do not survive on every way from a constant. */
static const uint64_t specials[] = {
    0x7ff8000000000000u, 0xfff8000000000123u, /* quiet NaNs */
    0x7ff0000000000001u, 0xfff4000000000000u, /* signalling */
    0x7ff0000000000000u, 0xfff0000000000000u, /* infinities */
    0x0000000000000001u, 0x8000000000000001u, /* the smallest */
    0x000fffffffffffffu, 0x0004000000000000u, /* subnormal */
    0x0010000000000000u, 0x7fefffffffffffffu, /* the smallest normal number, the largest */
    0xffefffffffffffffu, 0x0000000000000000u, 0x8000000000000000u,
};
enum { SPECIALS = sizeof specials / sizeof *specials };

static struct {
    int place, places; /* which one gets the special value, -1: none; how many there were */
    uint64_t value;
} given;

/* A double that the function under test takes. */
static double number(double usual) {
    uint64_t bits;
    memcpy(&bits, &usual, sizeof bits);
    if (given.places++ == given.place) bits = given.value;
    memcpy(&usual, &bits, sizeof bits);
    return usual;
}

static void numbers(double *to, int count, const double *usual) {
    for (int i = 0; i < count; i++) to[i] = number(usual[i]);
}

/* ---- the answer ---- */

static uint64_t hash;

static void written(const void *data, size_t size) {
    const unsigned char *byte = data;
    for (size_t i = 0; i < size; i++) hash = (hash ^ byte[i]) * 0x100000001b3u;
}

#define WRITTEN(object) written(&(object), sizeof(object))

/* ---- the hosts ---- */

/* Host h < ENVIRONMENTS has that environment, no flag raised and no trap open.  The last two open all traps,
 * with gradual underflow and with flushing (where the processor has traps). */
enum { HOSTS = ENVIRONMENTS + 2 };

static struct {
    int number, kept;
    const char *call;
    unsigned long long entered;
} host;

static unsigned long long host_state(void) {
#if defined(__SSE2__)
    return _mm_getcsr();
#elif defined(__aarch64__)
    unsigned long long control, flags;
    __asm__ volatile("mrs %0, fpcr" : "=r"(control));
    __asm__ volatile("mrs %0, fpsr" : "=r"(flags));
    return control << 32 | flags;
#else
    return (unsigned long long)(unsigned)fegetround() << 32 | (unsigned)fetestexcept(FE_ALL_EXCEPT);
#endif
}

static void host_in(void) {
    environment_set(host.number < ENVIRONMENTS ? host.number : (host.number - ENVIRONMENTS) * 4);
#if defined(__SSE2__)
    if (host.number >= ENVIRONMENTS) _mm_setcsr(_mm_getcsr() & ~0x1f80u);
#endif
    host.entered = host_state();
}

static void host_out(void) {
    host.kept &= host_state() == host.entered;
#if defined(__SSE2__)
    _mm_setcsr(0x1f80u);
#endif
    environment_set(0);
}

#define IN_HOST(call) (host_in(), (call), host_out())
#define STATUS_IN_HOST(call)                                                                                 \
    do {                                                                                                     \
        algsurf_status s;                                                                                    \
        IN_HOST(s = (call));                                                                                 \
        WRITTEN(s);                                                                                          \
    } while (0)

/* ---- what the calls are made of ---- */

static algsurf_surface *made(void) {
    static const algsurf_term usual[] = {
        {2, 0, 0, 1}, {0, 2, 0, 1.25}, {1, 1, 1, 0.5}, {0, 0, 4, 0.75}, {0, 0, 0, -1}};
    algsurf_term terms[5];
    algsurf_surface *surface = NULL;
    memcpy(terms, usual, sizeof terms);
    for (int i = 0; i < 5; i++) terms[i].a = number(usual[i].a);
    if (algsurf_surface_from_terms(terms, 5, &surface) != ALGSURF_OK)
        assert_ok(algsurf_surface_from_terms(usual, 5, &surface));
    return surface;
}

static const double unit[3] = {0.1, 0.2, -0.3};

static algsurf_ray ray_made(void) {
    static const double from[3] = {3, 0.25, 0.125}, to[3] = {-1, 0.0625, 0.03125};
    algsurf_ray ray;
    numbers(ray.origin, 3, from);
    numbers(ray.direction, 3, to);
    ray.t_min = number(0), ray.t_max = number(50);
    return ray;
}

static algsurf_extent extent_made(int kind) {
    static const double size[3] = {2.5, 2, 1.75};
    algsurf_extent extent = {.kind = kind};
    numbers(extent.centre, 3, unit);
    numbers(extent.size, 3, size);
    return extent;
}

static algsurf_complex complex_made(double re, double im) {
    algsurf_complex z;
    z.re = number(re), z.im = number(im);
    return z;
}

static algsurf_interval interval_made(double lo, double hi) {
    algsurf_interval x;
    x.lo = number(lo), x.hi = number(hi);
    return x;
}

static algsurf_cinterval cinterval_made(double re, double im) {
    algsurf_cinterval z;
    z.re = interval_made(re, 2.5), z.im = interval_made(im, 3.5);
    return z;
}

/* Roots -2, 0.5, 1, 3; (x^2 - 2)^2, whose roots integers decide. */
enum { DEGREE = 4 };
static const double quartic[2][DEGREE + 1] = {{-3, 8.5, -4, -2.5, 1}, {4, 0, -4, 0, 1}};
static const double radii[DEGREE + 1] = {0x1p-40, 0, 0x1p-44, 0, 0x1p-50};

typedef struct poly {
    double c[DEGREE + 1], r[DEGREE + 1];
} poly;

static poly poly_made(int which) {
    poly p;
    numbers(p.c, DEGREE + 1, quartic[which]);
    numbers(p.r, DEGREE + 1, radii);
    return p;
}

static void complex_coefficients(algsurf_complex *c) {
    for (int i = 0; i <= DEGREE; i++) c[i] = complex_made(quartic[0][i], i == 2 ? 0.5 : 0);
}

/* ---- the calls ---- */

enum { MOST_CALLS = 256 };
static struct {
    const char *name;
    void (*make)(void);
} calls[MOST_CALLS];
static int call_count;

/* How a function is called, and written what it answers; it enters the list before main begins. */
#define CALL(function)                                                                                       \
    static void call_##function(void);                                                                       \
    __attribute__((constructor)) static void list_##function(void) {                                         \
        calls[call_count].name = #function, calls[call_count++].make = call_##function;                      \
    }                                                                                                        \
    static void call_##function(void)

/* The same with a surface. */
#define ON_SURFACE(function)                                                                                 \
    static void on_##function(algsurf_surface *surface);                                                     \
    CALL(function) {                                                                                         \
        algsurf_surface *surface = made();                                                                   \
        on_##function(surface);                                                                              \
        algsurf_surface_free(surface);                                                                       \
    }                                                                                                        \
    static void on_##function(algsurf_surface *surface)

/* ---- status.h ---- */

CALL(algsurf_status_name) { IN_HOST((void)algsurf_status_name(ALGSURF_OK)); }
CALL(algsurf_status_text) { IN_HOST((void)algsurf_status_text(ALGSURF_OK)); }
CALL(algsurf_version) { IN_HOST((void)algsurf_version()); }
CALL(algsurf_version_number) { IN_HOST((void)algsurf_version_number()); }
CALL(algsurf_self_test) { STATUS_IN_HOST(algsurf_self_test()); }
CALL(algsurf_kernel_name) { IN_HOST((void)algsurf_kernel_name(0)); }

/* ---- surface.h ---- */

static void look_at_surface(algsurf_surface *surface) {
    algsurf_term terms[16] = {{0, 0, 0, 0}};
    size_t count = algsurf_surface_term_count(surface);
    double rounding = algsurf_surface_rounding(surface);
    if (count > 0 && count <= 16) (void)algsurf_surface_terms(surface, terms);
    for (size_t i = 0; i < count && i < 16; i++) WRITTEN(terms[i].a);
    WRITTEN(count), WRITTEN(rounding);
    algsurf_surface_free(surface);
}

CALL(algsurf_surface_from_terms) {
    algsurf_term terms[] = {{2, 0, 0, 0}, {0, 2, 0, 0}, {2, 0, 0, 0}};
    algsurf_surface *surface = NULL;
    for (int i = 0; i < 3; i++) terms[i].a = number(unit[i]);
    STATUS_IN_HOST(algsurf_surface_from_terms(terms, 3, &surface));
    look_at_surface(surface);
}

CALL(algsurf_surface_from_equation) {
    algsurf_constant constants[2] = {{"a", 0}, {"b", 0}};
    algsurf_surface *surface = NULL;
    constants[0].value = number(2.5), constants[1].value = number(0.3);
    STATUS_IN_HOST(algsurf_surface_from_equation("(x^2/b + a y)^2 + 1e-310 sqrt(a^2) z = 1e300 b - 0.1",
                                                 constants, 2, &surface, NULL));
    look_at_surface(surface);
}

CALL(algsurf_surface_with_error) {
    algsurf_surface *surface = made(), *approximate = NULL;
    double error = number(0.125);
    STATUS_IN_HOST(algsurf_surface_with_error(surface, error, &approximate));
    look_at_surface(approximate);
    algsurf_surface_free(surface);
}

CALL(algsurf_surface_free) {
    algsurf_surface *surface = made();
    IN_HOST(algsurf_surface_free(surface));
}

ON_SURFACE(algsurf_surface_degree) {
    int degree;
    IN_HOST(degree = algsurf_surface_degree(surface));
    WRITTEN(degree);
}

ON_SURFACE(algsurf_surface_rounding) {
    double rounding;
    IN_HOST(rounding = algsurf_surface_rounding(surface));
    WRITTEN(rounding);
}

ON_SURFACE(algsurf_surface_term_count) {
    size_t count;
    IN_HOST(count = algsurf_surface_term_count(surface));
    WRITTEN(count);
}

ON_SURFACE(algsurf_surface_terms) {
    algsurf_term terms[5];
    STATUS_IN_HOST(algsurf_surface_terms(surface, terms));
    for (size_t i = 0; i < algsurf_surface_term_count(surface); i++) WRITTEN(terms[i].a);
}

ON_SURFACE(algsurf_surface_value) {
    double point[3], value = 0, bound = 0;
    numbers(point, 3, unit);
    STATUS_IN_HOST(algsurf_surface_value(surface, point, &value, &bound));
    WRITTEN(value), WRITTEN(bound);
}

ON_SURFACE(algsurf_surface_enclose) {
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_SPHERE);
    double lo[3] = {0}, hi[3] = {0}, precision = number(0.5);
    int empty = 1;
    STATUS_IN_HOST(
        algsurf_surface_enclose(surface, &extent, ALGSURF_PART_SINGULAR, precision, lo, hi, &empty));
    WRITTEN(empty), WRITTEN(lo), WRITTEN(hi);
    /* as small as a double can be, precision makes this one search for long */
    STATUS_IN_HOST(algsurf_surface_enclose(surface, &extent, ALGSURF_PART_ALL, 0.5, lo, hi, &empty));
    WRITTEN(empty), WRITTEN(lo), WRITTEN(hi);
}

ON_SURFACE(algsurf_surface_gradient) {
    double point[3], value[2] = {0}, gradient[6] = {0};
    numbers(point, 3, unit);
    STATUS_IN_HOST(algsurf_surface_gradient(surface, point, value, gradient, value + 1, gradient + 3));
    WRITTEN(value), WRITTEN(gradient);
}

/* ---- ray.h, expand.h, camera.h ---- */

CALL(algsurf_ray_clip) {
    for (int kind = ALGSURF_EXTENT_ALL; kind <= ALGSURF_EXTENT_BOX; kind++) {
        algsurf_extent extent = extent_made((int)kind);
        algsurf_ray ray = ray_made(), chord = ray;
        algsurf_plane planes[2] = {{{1, 0.5, 0}, 0.5}, {{-0.25, 0, 1}, 1}};
        int meets = 0;
        for (int k = 0; k < 2; k++) {
            for (int i = 0; i < 3; i++) planes[k].normal[i] = number(planes[k].normal[i]);
            planes[k].offset = number(planes[k].offset);
        }
        STATUS_IN_HOST(algsurf_ray_clip(&ray, &extent, planes, 2, &chord, &meets));
        WRITTEN(chord), WRITTEN(meets);
    }
}

ON_SURFACE(algsurf_expand_power) {
    algsurf_ray ray = ray_made();
    double c[2][5] = {{0}};
    STATUS_IN_HOST(algsurf_expand_power(surface, &ray, c[0], c[1]));
    WRITTEN(c);
}

ON_SURFACE(algsurf_expand_bernstein) {
    algsurf_ray ray = ray_made();
    double c[2][5] = {{0}};
    STATUS_IN_HOST(algsurf_expand_bernstein(surface, &ray, c[0], c[1]));
    WRITTEN(c);
}

static void look_at_camera(const algsurf_camera *camera) {
    written(camera, offsetof(algsurf_camera, kind) + sizeof camera->kind);
    WRITTEN(camera->reserved);
}

static const double eye_usual[3] = {4, 3, 2.5}, up_usual[3] = {0, 0.125, 1};

CALL(algsurf_camera_pinhole) {
    algsurf_camera camera = {.kind = ALGSURF_CAMERA_PINHOLE};
    double eye[3], at[3], up[3], fov;
    numbers(eye, 3, eye_usual), numbers(at, 3, unit), numbers(up, 3, up_usual);
    fov = number(30);
    STATUS_IN_HOST(algsurf_camera_pinhole(eye, at, up, fov, &camera));
    look_at_camera(&camera);
}

CALL(algsurf_camera_orthographic) {
    algsurf_camera camera = {.kind = ALGSURF_CAMERA_PINHOLE};
    double eye[3], at[3], up[3], height;
    numbers(eye, 3, eye_usual), numbers(at, 3, unit), numbers(up, 3, up_usual);
    height = number(30);
    STATUS_IN_HOST(algsurf_camera_orthographic(eye, at, up, height, &camera));
    look_at_camera(&camera);
}

/* A camera whose members a caller has written. */
static algsurf_camera camera_made(void) {
    static const double axes[3][3] = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, eye[3] = {0, -4, 0};
    algsurf_camera camera = {.kind = ALGSURF_CAMERA_PINHOLE};
    numbers(camera.eye, 3, eye), numbers(camera.right, 3, axes[0]);
    numbers(camera.up, 3, axes[1]), numbers(camera.forward, 3, axes[2]);
    camera.half_height = number(0.5), camera.reserved[7] = number(0);
    return camera;
}

CALL(algsurf_camera_ray) {
    algsurf_camera camera = camera_made();
    algsurf_ray ray = {{0}, {0}, 0, 0};
    double x = number(3.5), y = number(2.25);
    STATUS_IN_HOST(algsurf_camera_ray(&camera, 8, 6, x, y, &ray));
    WRITTEN(ray);
}

/* ---- intersect.h ---- */

static algsurf_intersect_options options_made(void) {
    algsurf_intersect_options options = {.size = sizeof options, .max_memory = 1 << 20};
    options.absolute_tolerance = number(0);
    return options;
}

ON_SURFACE(algsurf_intersect_first) {
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_SPHERE);
    algsurf_ray ray = ray_made();
    algsurf_intersect_options options = options_made();
    algsurf_hit hit = {.state = 0};
    STATUS_IN_HOST(algsurf_intersect_first(surface, &extent, &ray, &options, &hit));
    WRITTEN(hit);
}

ON_SURFACE(algsurf_intersect_all) {
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_BOX);
    algsurf_ray ray = ray_made();
    algsurf_intersect_options options = options_made();
    algsurf_hit hits[4] = {{.state = 0}};
    int count = 0;
    STATUS_IN_HOST(algsurf_intersect_all(surface, &extent, &ray, &options, hits, 4, &count));
    WRITTEN(count), written(hits, (size_t)count * sizeof *hits);
}

ON_SURFACE(algsurf_hit_leave) {
    algsurf_ray ray = ray_made();
    algsurf_hit hit = {.state = ALGSURF_STATE_HIT, .position = {1, 2, 3}, .normal = {0, 0, 1}};
    double start[3] = {0, 0, 0};
    STATUS_IN_HOST(algsurf_hit_leave(surface, &ray, &hit, 1, start));
    WRITTEN(start);
}

ON_SURFACE(algsurf_occluded) {
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_SPHERE);
    algsurf_ray ray = ray_made();
    algsurf_intersect_options options = options_made();
    int state = ALGSURF_STATE_MISS;
    STATUS_IN_HOST(algsurf_occluded(surface, &extent, &ray, &options, &state));
    WRITTEN(state);
}

enum { RAYS = 3 };
typedef struct rays {
    double origin[3][RAYS], direction[3][RAYS], t_min[RAYS], t_max[RAYS];
    algsurf_ray_packet packet;
} rays;

static void rays_made(rays *of) {
    of->packet = (algsurf_ray_packet){.size = sizeof of->packet, .count = RAYS};
    for (int i = 0; i < RAYS; i++) {
        algsurf_ray ray = ray_made();
        for (int k = 0; k < 3; k++) memcpy(of->origin[k] + i, ray.origin + k, sizeof(double));
        for (int k = 0; k < 3; k++) memcpy(of->direction[k] + i, ray.direction + k, sizeof(double));
        memcpy(of->t_min + i, &ray.t_min, sizeof(double));
        memcpy(of->t_max + i, &ray.t_max, sizeof(double));
    }
    for (int k = 0; k < 3; k++)
        of->packet.origin[k] = of->origin[k], of->packet.direction[k] = of->direction[k];
    of->packet.t_min = of->t_min, of->packet.t_max = of->t_max;
}

ON_SURFACE(algsurf_intersect_packet) {
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_BOX);
    algsurf_intersect_options options = options_made();
    unsigned char state[RAYS] = {0};
    double t[9][RAYS] = {{0}};
    algsurf_hit_packet hits = {.size = sizeof hits,
                               .state = state,
                               .t = t[0],
                               .t_lo = t[1],
                               .t_hi = t[2],
                               .position = {t[3], t[4], t[5]},
                               .normal = {t[6], t[7], t[8]}};
    rays packet;
    rays_made(&packet);
    STATUS_IN_HOST(algsurf_intersect_packet(surface, &extent, &packet.packet, &options, &hits));
    WRITTEN(state), WRITTEN(t);
}

ON_SURFACE(algsurf_occluded_packet) {
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_SPHERE);
    algsurf_intersect_options options = options_made();
    unsigned char state[RAYS] = {0};
    rays packet;
    rays_made(&packet);
    STATUS_IN_HOST(algsurf_occluded_packet(surface, &extent, &packet.packet, &options, state));
    WRITTEN(state);
}

/* imaginary: room for its imaginary parts. */
static algsurf_complex_space space_made(double imaginary[4]) {
    algsurf_complex_space space = {.size = sizeof space, .imaginary = imaginary, .imaginary_count = 4};
    space.sector.sigma = number(0), space.sector.delta = number(0.25);
    imaginary[0] = number(0.5), imaginary[1] = imaginary[2] = 0, imaginary[3] = number(0);
    return space;
}

ON_SURFACE(algsurf_intersect_complex) {
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_SPHERE);
    algsurf_ray ray = ray_made();
    double imaginary[4];
    algsurf_complex_space space = space_made(imaginary);
    algsurf_complex start[4], roots[4] = {{0, 0}}, root = {0, 0};
    algsurf_hit hit = {.state = 0};
    for (int i = 0; i < 4; i++) start[i] = complex_made(quartic[0][i], 0.5);
    STATUS_IN_HOST(algsurf_intersect_complex(surface, &extent, &ray, &space, start, roots, &hit, &root));
    WRITTEN(hit), WRITTEN(roots), WRITTEN(root);
}

/* ---- poly.h, isolate.h, packet.h, refine.h ---- */

CALL(algsurf_poly_value) {
    poly p = poly_made(0);
    double t = number(0.75), value[2] = {0, 0};
    STATUS_IN_HOST(algsurf_poly_value(p.c, p.r, DEGREE, t, value, value + 1));
    WRITTEN(value);
}

CALL(algsurf_poly_value_compensated) {
    poly p = poly_made(0);
    double t = number(0.75), value[2] = {0, 0};
    STATUS_IN_HOST(algsurf_poly_value_compensated(p.c, p.r, DEGREE, t, value, value + 1));
    WRITTEN(value);
}

CALL(algsurf_poly_to_bernstein) {
    poly p = poly_made(0);
    double lo = number(-0.5), hi = number(0.75), b[2][DEGREE + 1] = {{0}};
    STATUS_IN_HOST(algsurf_poly_to_bernstein(p.c, p.r, DEGREE, lo, hi, b[0], b[1]));
    WRITTEN(b);
}

CALL(algsurf_real_roots) {
    for (int which = 0; which < 2; which++) {
        poly p = poly_made(which);
        double lo = number(-1e3), hi = number(1e3);
        algsurf_real_root roots[DEGREE];
        int count = 0;
        STATUS_IN_HOST(algsurf_real_roots(p.c, DEGREE, lo, hi, roots, DEGREE, &count));
        WRITTEN(count), written(roots, (size_t)count * sizeof *roots);
    }
}

CALL(algsurf_real_root_first) {
    for (int which = 0; which < 2; which++) {
        poly p = poly_made(which);
        double lo = number(-1e3), hi = number(1e3), root = 0;
        int found = 0;
        STATUS_IN_HOST(algsurf_real_root_first(p.c, DEGREE, lo, hi, &root, &found));
        WRITTEN(root);
        WRITTEN(found);
    }
}

CALL(algsurf_real_roots_integers) {
    static const uint64_t limbs[3][2] = {{7, 0}, {3, 9}, {0, 1}};
    const algsurf_integer c[3] = {{limbs[0], 1}, {limbs[1], -2}, {limbs[2], 2}};
    double lo = number(-1e3), hi = number(1e3);
    algsurf_real_root roots[2];
    int count = 0;
    STATUS_IN_HOST(algsurf_real_roots_integers(c, 2, lo, hi, roots, 2, &count));
    WRITTEN(count), written(roots, (size_t)count * sizeof *roots);
}

CALL(algsurf_complex_roots_integers) {
    static const uint64_t limbs[3][2] = {{7, 0}, {3, 9}, {0, 1}};
    const algsurf_integer c[3] = {{limbs[0], 1}, {limbs[1], -2}, {limbs[2], 2}};
    algsurf_complex_root roots[2];
    int count = 0;
    STATUS_IN_HOST(algsurf_complex_roots_integers(c, NULL, 2, roots, &count));
    WRITTEN(count), written(roots, (size_t)count * sizeof *roots);
}

static algsurf_precise_roots *some_precise_roots(void) {
    static const uint64_t limbs[3][2] = {{7, 0}, {3, 9}, {0, 1}};
    const algsurf_integer c[3] = {{limbs[0], 1}, {limbs[1], -2}, {limbs[2], 2}};
    algsurf_precise_roots *roots = NULL;
    (void)algsurf_precise_roots_create(c, NULL, 2, 300, 0, &roots);
    return roots;
}

CALL(algsurf_precise_roots_create) {
    algsurf_precise_roots *roots = NULL;
    IN_HOST(roots = some_precise_roots());
    for (int i = 0; i < algsurf_precise_roots_count(roots); i++) {
        algsurf_precise_root r;
        assert_ok(algsurf_precise_roots_get(roots, i, &r));
        WRITTEN(r.exponent), WRITTEN(r.radius), WRITTEN(r.real);
        written(r.re.limbs, (size_t)abs(r.re.length) * sizeof *r.re.limbs);
        written(r.im.limbs, (size_t)abs(r.im.length) * sizeof *r.im.limbs);
    }
    algsurf_precise_roots_free(roots);
}

CALL(algsurf_precise_roots_count) {
    algsurf_precise_roots *roots = some_precise_roots();
    int count = 0;
    IN_HOST(count = algsurf_precise_roots_count(roots));
    WRITTEN(count);
    algsurf_precise_roots_free(roots);
}

CALL(algsurf_precise_roots_get) {
    algsurf_precise_roots *roots = some_precise_roots();
    algsurf_precise_root r = {.exponent = 0};
    STATUS_IN_HOST(algsurf_precise_roots_get(roots, 1, &r));
    WRITTEN(r.exponent), WRITTEN(r.radius), WRITTEN(r.real);
    algsurf_precise_roots_free(roots);
}

CALL(algsurf_precise_roots_free) {
    algsurf_precise_roots *roots = some_precise_roots();
    IN_HOST(algsurf_precise_roots_free(roots));
}

/* The calls of isolate.h, each without radii and with them. */
#define ISOLATE(call)                                                                                        \
    for (int k = 0; k < 4; k++) {                                                                            \
        poly p = poly_made(k / 2);                                                                           \
        const double *r = k % 2 ? p.r : NULL;                                                                \
        double lo = number(-1e3), hi = number(1e3);                                                          \
        algsurf_bracket brackets[DEGREE] = {0};                                                              \
        algsurf_observer observer = {.size = sizeof observer};                                               \
        const algsurf_isolate_options options = {.size = sizeof options, .observer = &observer};             \
        int count = 0;                                                                                       \
        STATUS_IN_HOST(call);                                                                                \
        (void)options, WRITTEN(count), WRITTEN(observer.cells),                                              \
            written(brackets, (size_t)(written_all * count) * sizeof *brackets);                             \
    }

CALL(algsurf_isolate_first) {
    enum { written_all = 1 };
    ISOLATE(algsurf_isolate_first(p.c, r, DEGREE, lo, hi, &options, brackets, &count))
}

CALL(algsurf_isolate_all) {
    enum { written_all = 1 };
    ISOLATE(algsurf_isolate_all(p.c, r, DEGREE, lo, hi, &options, brackets, DEGREE, &count))
}

CALL(algsurf_count_roots) {
    enum { written_all = 0 };
    ISOLATE(algsurf_count_roots(p.c, r, DEGREE, lo, hi, &count))
}

enum { POLYS = 3 };
typedef struct polys {
    double c[DEGREE + 1][POLYS], r[DEGREE + 1][POLYS], lo[POLYS], hi[POLYS];
    algsurf_real_batch batch;
} polys;

static void polys_made(polys *of, int with_radii) {
    of->batch = (algsurf_real_batch){.size = sizeof of->batch,
                                     .count = POLYS,
                                     .degree = DEGREE,
                                     .coefficients = {of->c[0], POLYS, 1},
                                     .lo = of->lo,
                                     .hi = of->hi,
                                     .interval_step = 1};
    if (with_radii) of->batch.radii = (algsurf_table){of->r[0], POLYS, 1};
    for (int k = 0; k <= DEGREE; k++) {
        for (int i = 0; i < POLYS; i++) of->c[k][i] = number(quartic[i % 2][k]);
        for (int i = 0; i < POLYS; i++) of->r[k][i] = number(radii[k]);
    }
    for (int i = 0; i < POLYS; i++) of->lo[i] = number(-1e3), of->hi[i] = number(1e3);
}

CALL(algsurf_first_roots_batch) {
    algsurf_batch_options options = {.size = sizeof options};
    unsigned char state[POLYS] = {0};
    double root[POLYS] = {0};
    polys of;
    polys_made(&of, 1);
    options.relative_tolerance = number(0);
    STATUS_IN_HOST(algsurf_first_roots_batch(&of.batch, &options, state, root));
    WRITTEN(state), WRITTEN(root);
}

CALL(algsurf_real_roots_batch) {
    algsurf_batch_options options = {.size = sizeof options};
    algsurf_real_root roots[POLYS * DEGREE];
    int count[POLYS] = {0};
    polys of;
    polys_made(&of, 0);
    options.relative_tolerance = number(0);
    STATUS_IN_HOST(algsurf_real_roots_batch(&of.batch, &options, roots, count));
    WRITTEN(count);
    for (int i = 0; i < POLYS; i++)
        if (count[i] > 0) written(roots + i * DEGREE, (size_t)count[i] * sizeof *roots);
}

static void look_at_root(const algsurf_refined_root *root) {
    written(root, offsetof(algsurf_refined_root, converged) + sizeof root->converged);
}

/* A step, by bits: it computes nothing, and it is the host's, in the host's environment. */
static double step_at_two(double x, void *data) {
    uint64_t bits;
    int *elsewhere = data;
    memcpy(&bits, &x, sizeof bits);
    *elsewhere += (host_state() ^ host.entered) != 0;
    return bits >> 63 || bits < 0x4000000000000001u ? -1 : 1;
}

CALL(algsurf_refine_function) {
    algsurf_refine_options options = {.size = sizeof options};
    algsurf_refined_root root = {.converged = 0};
    double lo = number(-1e3), hi = number(1e3);
    int elsewhere = 0;
    options.absolute_tolerance = number(0);
    STATUS_IN_HOST(algsurf_refine_function(step_at_two, &elsewhere, lo, hi, &options, &root));
    look_at_root(&root);
    host.kept &= elsewhere == 0;
}

static void observe(double t, double value, int engine, void *data) {
    uint64_t *seen = data, bits[2];
    memcpy(bits, &t, sizeof t), memcpy(bits + 1, &value, sizeof value);
    *seen = ((*seen ^ bits[0]) * 0x100000001b3u ^ bits[1]) + (uint64_t)engine;
}

CALL(algsurf_refine_poly) {
    for (int which = 0; which < 3; which++) { /* 2: with radii */
        poly p = poly_made(which % 2);
        double lo = number(0.625), hi = number(1.375);
        uint64_t seen = 0;
        algsurf_observer observer = {.size = sizeof observer, .data = &seen, .on_point = observe};
        algsurf_refine_options options = {.size = sizeof options, .observer = &observer};
        algsurf_refined_root root = {.converged = 0};
        options.absolute_tolerance = number(0);
        options.method = which == 1 ? ALGSURF_METHOD_REGULA_FALSI : ALGSURF_METHOD_DEFAULT;
        STATUS_IN_HOST(algsurf_refine_poly(p.c, which == 2 ? p.r : NULL, DEGREE, lo, hi, &options, &root));
        look_at_root(&root);
        WRITTEN(seen);
    }
}

/* ---- allroots.h, papers.h, select.h ---- */

CALL(algsurf_complex_roots) {
    algsurf_complex c[DEGREE + 1];
    double r[DEGREE + 1];
    complex_coefficients(c);
    numbers(r, DEGREE + 1, radii);
    for (int with_radii = 0; with_radii < 2; with_radii++) {
        algsurf_complex_root roots[DEGREE];
        int count = 0;
        STATUS_IN_HOST(algsurf_complex_roots(c, with_radii ? r : NULL, DEGREE, roots, &count));
        WRITTEN(count), written(roots, (size_t)count * sizeof *roots);
    }
}

CALL(algsurf_complex_roots_of_real) {
    for (int k = 0; k < 4; k++) {
        poly p = poly_made(k / 2);
        algsurf_complex_root roots[DEGREE];
        int count = 0;
        STATUS_IN_HOST(algsurf_complex_roots_of_real(p.c, k % 2 ? p.r : NULL, DEGREE, roots, &count));
        WRITTEN(count), written(roots, (size_t)count * sizeof *roots);
    }
}

CALL(algsurf_complex_roots_batch) {
    polys of;
    algsurf_complex_batch batch = {
        .size = sizeof batch, .count = POLYS, .degree = DEGREE, .re = {of.c[0], POLYS, 1}};
    algsurf_complex_root roots[POLYS * DEGREE];
    int count[POLYS] = {0};
    polys_made(&of, 0);
    STATUS_IN_HOST(algsurf_complex_roots_batch(&batch, NULL, roots, count));
    WRITTEN(count);
    for (int i = 0; i < POLYS; i++)
        if (count[i] > 0) written(roots + i * DEGREE, (size_t)count[i] * sizeof *roots);
}

CALL(algsurf_paper_approximation) {
    algsurf_paper_options options = {.size = sizeof options};
    algsurf_complex p[DEGREE + 1], start = complex_made(0, 1), z = {0, 0}, q[DEGREE] = {{0, 0}};
    int steps = 0;
    complex_coefficients(p);
    options.relative_step = number(1e-10);
    STATUS_IN_HOST(algsurf_paper_approximation(p, DEGREE, start, &options, &z, q, &steps));
    WRITTEN(z), WRITTEN(q), WRITTEN(steps);
}

CALL(algsurf_paper_inclusion) {
    static const double quotient[DEGREE] = {6, -14, -6, 1}; /* about */
    algsurf_paper_options options = {.size = sizeof options};
    algsurf_complex p[DEGREE + 1], z = complex_made(-2, 0), q[DEGREE];
    algsurf_cinterval box = {{0, 0}, {0, 0}}, boxes[DEGREE] = {{{0, 0}, {0, 0}}};
    int unique = 0, inflations = 0;
    double r[DEGREE + 1];
    complex_coefficients(p);
    numbers(r, DEGREE + 1, radii);
    for (int i = 0; i < DEGREE; i++) q[i] = complex_made(quotient[i], 0);
    options.relative_step = number(1e-10);
    STATUS_IN_HOST(algsurf_paper_inclusion(p, r, DEGREE, z, q, &options, &box, boxes, &unique, &inflations));
    WRITTEN(box), WRITTEN(boxes), WRITTEN(unique), WRITTEN(inflations);
}

CALL(algsurf_paper_zeros) {
    algsurf_paper_options options = {.size = sizeof options};
    algsurf_complex p[DEGREE + 1], start[DEGREE];
    algsurf_paper_zero zeros[DEGREE] = {{.verified = 0}};
    int complete = 0;
    double r[DEGREE + 1];
    complex_coefficients(p);
    numbers(r, DEGREE + 1, radii);
    for (int i = 0; i < DEGREE; i++) start[i] = complex_made(quartic[0][i], 1);
    options.relative_step = number(1e-10);
    STATUS_IN_HOST(algsurf_paper_zeros(p, r, DEGREE, start, &options, zeros, &complete));
    WRITTEN(complete);
    for (int i = 0; i < DEGREE; i++)
        written(zeros + i, offsetof(algsurf_paper_zero, inflations) + sizeof zeros->inflations);
}

CALL(algsurf_complex_solver_create) {
    algsurf_complex_solver *solver = NULL;
    STATUS_IN_HOST(algsurf_complex_solver_create(8, &solver));
    algsurf_complex_solver_free(solver);
}

CALL(algsurf_complex_solver_free) {
    algsurf_complex_solver *solver = NULL;
    assert_ok(algsurf_complex_solver_create(8, &solver));
    IN_HOST(algsurf_complex_solver_free(solver));
}

CALL(algsurf_complex_solver_run) {
    algsurf_complex_solver *solver = NULL;
    algsurf_complex c[DEGREE + 1], start[DEGREE];
    algsurf_complex_root roots[DEGREE];
    algsurf_complex_solver_stats stats = {.size = sizeof stats};
    int count = 0;
    double r[DEGREE + 1];
    assert_ok(algsurf_complex_solver_create(8, &solver));
    complex_coefficients(c);
    numbers(r, DEGREE + 1, radii);
    for (int i = 0; i < DEGREE; i++) start[i] = complex_made(quartic[0][i], 1);
    STATUS_IN_HOST(algsurf_complex_solver_run(solver, c, r, DEGREE, start, roots, &count, &stats));
    WRITTEN(count), WRITTEN(stats), written(roots, (size_t)count * sizeof *roots);
    algsurf_complex_solver_free(solver);
}

typedef struct choice {
    algsurf_sector sector;
    algsurf_complex_root roots[2];
} choice;

static choice choice_made(void) {
    choice c = {.roots = {{.multiplicity = 1}, {.multiplicity = 1}}};
    c.sector.sigma = number(0.25), c.sector.delta = number(0.5);
    for (int i = 0; i < 2; i++) {
        c.roots[i].box = cinterval_made(i ? 2 : 1.5, i ? 0 : 0.75);
        c.roots[i].root = complex_made(2, 0.75);
    }
    return c;
}

CALL(algsurf_sector_holds) {
    choice c = choice_made();
    int holds = 0;
    STATUS_IN_HOST(algsurf_sector_holds(&c.sector, c.roots, &holds));
    WRITTEN(holds);
}

CALL(algsurf_select) {
    choice c = choice_made();
    double lo = number(0), hi = number(10);
    int selected = ALGSURF_SELECTED_NONE;
    int index = 0;
    STATUS_IN_HOST(algsurf_select(c.roots, 2, &c.sector, lo, hi, &selected, &index));
    WRITTEN(selected), WRITTEN(index);
}

CALL(algsurf_select_of_real) {
    choice c = choice_made();
    double lo = number(0), hi = number(10);
    int selected = ALGSURF_SELECTED_NONE;
    int index = 0;
    STATUS_IN_HOST(algsurf_select_of_real(c.roots, 2, &c.sector, lo, hi, &selected, &index));
    WRITTEN(selected), WRITTEN(index);
}

/* ---- shade.h, render.h ---- */

static algsurf_material material_made(void) {
    static const double outside[3] = {1, 0.75, 0.5}, inside[3] = {0.5, 0.625, 1};
    algsurf_material material = {.size = sizeof material};
    numbers(material.outside, 3, outside), numbers(material.inside, 3, inside);
    material.diffuse = number(0.75), material.ambient = number(0.25), material.fill = number(0.125);
    material.specular = number(0.25), material.roughness = number(0.3), material.haze = number(0.2);
    return material;
}

static algsurf_light light_made(void) {
    static const double place[3] = {4, -5, 6}, white[3] = {1, 1, 1}, u[3] = {1, 0, 0}, v[3] = {0, 1, 0};
    algsurf_light light = {.samples_u = 2, .samples_v = 2};
    numbers(light.position, 3, place), numbers(light.colour, 3, white);
    numbers(light.edge_u, 3, u), numbers(light.edge_v, 3, v);
    light.reserved[7] = number(0);
    return light;
}

CALL(algsurf_light_sample) {
    algsurf_light light = light_made();
    double position[3] = {0};
    STATUS_IN_HOST(algsurf_light_sample(&light, 0, 1, position));
    WRITTEN(position);
}

static algsurf_lighting lighting_made(const algsurf_material *material, const algsurf_light *light) {
    static const double upwards[3] = {0, 1, 0}, forwards[3] = {0, 0, -1}, centre[3] = {0.25, 0, -0.5};
    algsurf_lighting lighting = {
        .size = sizeof lighting, .material = material, .lights = light, .light_count = 1, .bounded = 1};
    numbers(lighting.up, 3, upwards), numbers(lighting.forward, 3, forwards);
    numbers(lighting.centre, 3, centre);
    lighting.radius = number(2);
    return lighting;
}

CALL(algsurf_shade) {
    static const double towards[3] = {0, 0, -1}, out[3] = {0.6, 0, 0.8}, shares[2] = {0.5, 0.25};
    algsurf_material material = material_made();
    algsurf_light light = light_made();
    algsurf_lighting lighting = lighting_made(&material, &light);
    double visible[2], point[3], normal[3], direction[3], colour[3] = {0};
    numbers(visible, 2, shares);
    numbers(point, 3, unit), numbers(normal, 3, out), numbers(direction, 3, towards);
    STATUS_IN_HOST(algsurf_shade(&lighting, visible, point, normal, direction, colour));
    WRITTEN(colour);
    STATUS_IN_HOST(algsurf_shade(&lighting, NULL, point, normal, direction, colour));
    WRITTEN(colour);
}

CALL(algsurf_shade_preview) {
    static const double towards[3] = {0, 0, -1}, out[3] = {0.6, 0, 0.8};
    algsurf_material material = material_made();
    algsurf_light light = light_made();
    algsurf_lighting lighting = lighting_made(&material, &light);
    double point[3], normal[3], direction[3], colour[3] = {0};
    numbers(point, 3, unit), numbers(normal, 3, out), numbers(direction, 3, towards);
    STATUS_IN_HOST(algsurf_shade_preview(&lighting, point, normal, direction, colour));
    WRITTEN(colour);
}

CALL(algsurf_srgb_encode) {
    double colour[3];
    unsigned char bytes[3] = {0};
    numbers(colour, 3, unit);
    STATUS_IN_HOST(algsurf_srgb_encode(colour, bytes));
    WRITTEN(bytes);
}

CALL(algsurf_srgb_decode) {
    static const unsigned char bytes[3] = {1, 77, 254};
    double colour[3] = {0};
    STATUS_IN_HOST(algsurf_srgb_decode(bytes, colour));
    WRITTEN(colour);
}

enum { WIDTH = 4, HEIGHT = 3 };

/* The picture of a scene, drawn in the host's environment or, for what only sets a part of it, in the usual
 * one: it shows what was set. */
static void draw(const algsurf_scene *scene, int in_host) {
    algsurf_render_options options = {.size = sizeof options, .width = WIDTH, .height = HEIGHT, .threads = 1};
    uint8_t pixels[3 * WIDTH * HEIGHT] = {0};
    double hits[WIDTH * HEIGHT] = {0};
    float normals[3 * WIDTH * HEIGHT] = {0};
    unsigned char state[WIDTH * HEIGHT] = {0}, way[WIDTH * HEIGHT] = {0};
    const algsurf_picture picture = {
        .size = sizeof picture, .pixels = pixels, .t = hits, .normals = normals, .state = state, .way = way};
    algsurf_status s;
    if (in_host)
        IN_HOST(s = algsurf_render(scene, &options, &picture, NULL));
    else
        s = algsurf_render(scene, &options, &picture, NULL);
    WRITTEN(s), WRITTEN(pixels), WRITTEN(hits), WRITTEN(normals), WRITTEN(state), WRITTEN(way);
}

typedef struct stage {
    algsurf_surface *surface;
    algsurf_scene *scene;
} stage;

static stage stage_made(void) {
    static const algsurf_term terms[] = {{2, 0, 0, 1}, {0, 2, 0, 1.25}, {0, 0, 2, 1}, {0, 0, 0, -1}};
    static const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2.5, 0, 0}};
    stage of = {NULL, NULL};
    assert_ok(algsurf_surface_from_terms(terms, 4, &of.surface));
    assert_ok(algsurf_scene_create(of.surface, &of.scene));
    assert_ok(algsurf_scene_set_extent(of.scene, &extent));
    return of;
}

static void stage_freed(stage of) {
    algsurf_scene_free(of.scene);
    algsurf_surface_free(of.surface);
}

/* What is not allowed leaves the default. */
CALL(algsurf_render) {
    stage of = stage_made();
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_BOX);
    algsurf_camera camera = camera_made();
    algsurf_material material = material_made();
    algsurf_light light = light_made();
    double imaginary[4];
    algsurf_complex_space space = space_made(imaginary);
    double colour[3];
    numbers(colour, 3, camera.up);
    (void)algsurf_scene_set_extent(of.scene, &extent);
    (void)algsurf_scene_set_camera(of.scene, &camera);
    (void)algsurf_scene_set_material(of.scene, &material);
    (void)algsurf_scene_set_lights(of.scene, &light, 1);
    (void)algsurf_scene_set_background(of.scene, colour);
    (void)algsurf_scene_set_thin(of.scene, colour);
    (void)algsurf_scene_set_antialias(of.scene, 2);
    (void)algsurf_scene_set_antialias_threshold(of.scene, number(0.125));
    (void)algsurf_scene_set_quality(of.scene, ALGSURF_QUALITY_FULL);
    draw(of.scene, 1);
    (void)algsurf_scene_set_complex_space(of.scene, &space);
    draw(of.scene, 1);
    stage_freed(of);
}

ON_SURFACE(algsurf_scene_create) {
    algsurf_scene *scene = NULL;
    STATUS_IN_HOST(algsurf_scene_create(surface, &scene));
    draw(scene, 0);
    algsurf_scene_free(scene);
}

CALL(algsurf_scene_free) {
    stage of = stage_made();
    IN_HOST(algsurf_scene_free(of.scene));
    algsurf_surface_free(of.surface);
}

CALL(algsurf_scene_get_lighting) {
    stage of = stage_made();
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_BOX);
    algsurf_camera camera = camera_made();
    algsurf_light lights[ALGSURF_MAX_LIGHTS] = {{.samples_u = 0}};
    algsurf_lighting lighting = {.size = sizeof lighting};
    (void)algsurf_scene_set_extent(of.scene, &extent);
    (void)algsurf_scene_set_camera(of.scene, &camera);
    STATUS_IN_HOST(algsurf_scene_get_lighting(of.scene, lights, &lighting));
    WRITTEN(lights[0]), WRITTEN(lighting.up), WRITTEN(lighting.centre), WRITTEN(lighting.radius);
    stage_freed(of);
}

/* Sets a part of a scene in the host's environment. */
#define SETS(call)                                                                                           \
    {                                                                                                        \
        stage of = stage_made();                                                                             \
        STATUS_IN_HOST(call);                                                                                \
        draw(of.scene, 0);                                                                                   \
        stage_freed(of);                                                                                     \
    }

CALL(algsurf_scene_set_antialias) { SETS(algsurf_scene_set_antialias(of.scene, 2)); }
CALL(algsurf_scene_set_coherence) { SETS(algsurf_scene_set_coherence(of.scene, ALGSURF_COHERENCE_NONE)); }
CALL(algsurf_scene_set_quality) { SETS(algsurf_scene_set_quality(of.scene, ALGSURF_QUALITY_PREVIEW)); }

CALL(algsurf_scene_set_antialias_threshold) {
    double threshold = number(0.25);
    SETS(algsurf_scene_set_antialias_threshold(of.scene, threshold))
}

CALL(algsurf_scene_set_background) {
    double colour[3];
    numbers(colour, 3, up_usual);
    SETS(algsurf_scene_set_background(of.scene, colour))
}

CALL(algsurf_scene_set_thin) {
    double colour[3];
    numbers(colour, 3, up_usual);
    SETS(algsurf_scene_set_thin(of.scene, colour))
}

CALL(algsurf_scene_set_camera) {
    algsurf_camera camera = camera_made();
    SETS(algsurf_scene_set_camera(of.scene, &camera))
}

CALL(algsurf_scene_set_clip) {
    algsurf_plane plane = {.offset = number(0.25)};
    numbers(plane.normal, 3, up_usual);
    SETS(algsurf_scene_set_clip(of.scene, &plane, 1))
}

CALL(algsurf_scene_set_complex_space) {
    double imaginary[4];
    algsurf_complex_space space = space_made(imaginary);
    SETS(algsurf_scene_set_complex_space(of.scene, &space))
}

CALL(algsurf_scene_set_extent) {
    algsurf_extent extent = extent_made(ALGSURF_EXTENT_BOX);
    SETS(algsurf_scene_set_extent(of.scene, &extent))
}

CALL(algsurf_scene_set_intersect_options) {
    algsurf_intersect_options options = options_made();
    SETS(algsurf_scene_set_intersect_options(of.scene, &options))
}

CALL(algsurf_scene_set_lights) {
    algsurf_light light = light_made();
    SETS(algsurf_scene_set_lights(of.scene, &light, 1))
}

CALL(algsurf_scene_set_material) {
    algsurf_material material = material_made();
    SETS(algsurf_scene_set_material(of.scene, &material))
}

/* ---- interval.h: A and B are operands, R the result ---- */

#define MAKE_I interval_made
#define MAKE_C cinterval_made
#define TYPE_I algsurf_interval
#define TYPE_C algsurf_cinterval
#define TYPE_Z algsurf_complex
#define TYPE_D double
#define TYPE_N int

#define ONE(kind, result, name)                                                                              \
    CALL(name) {                                                                                             \
        TYPE_##kind a = MAKE_##kind(-1.5, 2.25);                                                             \
        TYPE_##result r;                                                                                     \
        IN_HOST(r = name(a));                                                                                \
        WRITTEN(r);                                                                                          \
    }
#define TWO(kind, result, name)                                                                              \
    CALL(name) {                                                                                             \
        TYPE_##kind a = MAKE_##kind(-1.5, 2.25), b = MAKE_##kind(0.1, 3.3);                                  \
        TYPE_##result r;                                                                                     \
        IN_HOST(r = name(a, b));                                                                             \
        WRITTEN(r);                                                                                          \
    }
/* Those that may fail; `arguments` before the result. */
#define MAY_FAIL(kind, result, name, arguments)                                                              \
    CALL(name) {                                                                                             \
        TYPE_##kind a = MAKE_##kind(0.25, 2.25), b = MAKE_##kind(0.1, 3.3);                                  \
        TYPE_##result r;                                                                                     \
        memset(&r, 0, sizeof r);                                                                             \
        (void)b;                                                                                             \
        STATUS_IN_HOST(name(arguments, &r));                                                                 \
        WRITTEN(r);                                                                                          \
    }
#define COMMA ,
#define OF_POLY(kind, name)                                                                                  \
    CALL(name) {                                                                                             \
        TYPE_##kind c[3], x = MAKE_##kind(-0.5, 0.3), r;                                                     \
        for (int i = 0; i < 3; i++) c[i] = MAKE_##kind(unit[i], 1.1);                                        \
        memset(&r, 0, sizeof r);                                                                             \
        STATUS_IN_HOST(name(c, 2, x, &r));                                                                   \
        WRITTEN(r);                                                                                          \
    }

CALL(algsurf_interval_make) {
    double lo = number(-0.1), hi = number(0.3);
    algsurf_interval r = {0, 0};
    STATUS_IN_HOST(algsurf_interval_make(lo, hi, &r));
    WRITTEN(r);
}

CALL(algsurf_interval_contains) {
    algsurf_interval a = interval_made(-1.5, 2.25);
    double x = number(0.5);
    int r;
    IN_HOST(r = algsurf_interval_contains(a, x));
    WRITTEN(r);
}

CALL(algsurf_cinterval_contains) {
    algsurf_cinterval a = cinterval_made(-1.5, 2.25);
    algsurf_complex z = complex_made(0.1, 2.5);
    int r;
    IN_HOST(r = algsurf_cinterval_contains(a, z));
    WRITTEN(r);
}

ONE(I, I, algsurf_interval_abs)
ONE(I, D, algsurf_interval_width)
ONE(I, D, algsurf_interval_mid)
TWO(I, I, algsurf_interval_add)
TWO(I, I, algsurf_interval_sub)
TWO(I, I, algsurf_interval_mul)
TWO(I, I, algsurf_interval_hull)
TWO(I, N, algsurf_interval_interior)
MAY_FAIL(I, I, algsurf_interval_div, a COMMA b)
MAY_FAIL(I, I, algsurf_interval_pow, a COMMA 3)
MAY_FAIL(I, I, algsurf_interval_sqrt, a)
MAY_FAIL(I, I, algsurf_interval_intersect, a COMMA b)
OF_POLY(I, algsurf_interval_poly)

ONE(C, I, algsurf_cinterval_abs)
ONE(C, D, algsurf_cinterval_width)
ONE(C, Z, algsurf_cinterval_mid)
TWO(C, C, algsurf_cinterval_add)
TWO(C, C, algsurf_cinterval_sub)
TWO(C, C, algsurf_cinterval_mul)
TWO(C, C, algsurf_cinterval_hull)
TWO(C, N, algsurf_cinterval_interior)
MAY_FAIL(C, C, algsurf_cinterval_div, a COMMA b)
MAY_FAIL(C, I, algsurf_cinterval_arg, a)
MAY_FAIL(C, C, algsurf_cinterval_intersect, a COMMA b)
OF_POLY(C, algsurf_cinterval_poly)

/* ---- the test ---- */

/* The answer to a call with one special value, in one environment. */
static uint64_t answer(int call, int place, uint64_t value, int in) {
    given.place = place, given.value = value, given.places = 0;
    hash = 0xcbf29ce484222325u;
    host.number = in, host.kept = 1, host.call = calls[call].name;
    calls[call].make();
    return hash;
}

static sigjmp_buf out_of_trap;

static void trapped(int signal) {
    (void)signal;
    siglongjmp(out_of_trap, 1);
}

static int compare(int call, int place, uint64_t value) {
    const uint64_t usual = answer(call, place, value, 0);
    const int usual_kept = host.kept;
    for (int in = 1; in < HOSTS; in++) {
        const char *wrong = NULL;
        if (sigsetjmp(out_of_trap, 1) == 0) {
            uint64_t here = answer(call, place, value, in);
            wrong = here != usual             ? "other bits"
                    : host.kept && usual_kept ? NULL
                                              : "flags or control bits changed";
        } else {
            environment_set(0);
            wrong = "a trap is sprung";
        }
        if (!wrong) continue;
        print_message("%s: %s in environment %d with %#llx in place %d\n", calls[call].name, wrong, in,
                      (unsigned long long)value, place);
        return 1;
    }
    return 0;
}

TEST(same_in_every_environment) {
    const struct sigaction action = {.sa_handler = trapped};
    struct sigaction before;
    int failures = 0;
    assert_int_equal(sigaction(SIGFPE, &action, &before), 0);
    for (int call = 0; call < call_count; call++) {
        (void)answer(call, -1, 0, 0);
        int places = given.places, wrong = compare(call, -1, 0);
        for (int place = 0; place < places && !wrong; place++)
            for (int k = 0; k < SPECIALS && !wrong; k++) wrong = compare(call, place, specials[k]);
        failures += wrong;
    }
    assert_int_equal(sigaction(SIGFPE, &before, NULL), 0);
    assert_int_equal(failures, 0);
}
