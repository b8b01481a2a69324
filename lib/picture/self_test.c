/* self_test.c - does this build round as the proofs need, and do its kernels agree?
 *
 * Two questions.  Operations: those that the rooms share (base/rounding.h), as compiled without and with each
 * instruction set that runs here.  Answers: a few polynomials, rays and pixels by each kernel, chosen so that
 * each part of its code is used: packets that are full and one that is not, roots, no roots, roots close
 * together, both shapes of extent, a cutting plane, tiles, normals, shadows, colours in floats, complex
 * space. Their bits must be those of "baseline", and so must those of single calls, which have code of their
 * own.  A library without pictures (ALGSURF_NO_PICTURES) draws none here.
 *
 * It stands in the highest room since it asks all of them, by the functions that a user calls. */
#include "../base/arithmetic.h"
#include "algsurf/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "algsurf/allroots.h"
#include "algsurf/batch.h"
#include "algsurf/intersect.h"
#include "algsurf/isolate.h"
#include "algsurf/render.h"
#include "algsurf/surface.h"
#include "../base/fpenv.h"
#include "../simd/operations.h"

/* 9 of each: one more than the widest packet has. */
enum { COUNT = 9, DEGREE = 6, WIDTH = 9, ROWS = 2, PICTURES = 4, HIGH = 600, MIDDLE = 299, OUTLINE = 514 };

typedef struct problem {
    double c[DEGREE + 1][COUNT], im[DEGREE + 1][COUNT], lo[COUNT], hi[COUNT];
    double origin[3][COUNT], direction[3][COUNT];
    algsurf_surface *surface;
} problem;

typedef struct answers {
    double first[COUNT];
    algsurf_real_root real[COUNT * DEGREE];
    algsurf_complex_root complex[2][COUNT * DEGREE];
    int count[3][COUNT];
    double t[3][COUNT], position[3][COUNT], normal[3][COUNT];
    unsigned char state[2][COUNT], occluded[2][COUNT];
    uint8_t pixels[PICTURES][ROWS * WIDTH * 3];
    double hits[PICTURES][ROWS * WIDTH];
    float normals[PICTURES][3 * ROWS * WIDTH];
    unsigned char states[PICTURES][ROWS * WIDTH];
} answers;

/* ---- the problem ---- */

/* Number i is (t^2 - 2) (t - s)^2 + i/8 times the product of (t - (s + j) / 4), j = 1 .. 4, s = i / 16 - 1/4:
 * from a double root to four roots of their own. */
static void make_polynomials(problem *p) {
    for (int i = 0; i < COUNT; i++) {
        double s = 0.0625 * i - 0.25, four[5] = {1, 0, 0, 0, 0};
        for (int j = 1; j <= 4; j++) {
            for (int k = j; k >= 0; k--) four[k] = (k > 0 ? four[k - 1] : 0) - 0.25 * (s + j) * four[k];
        }
        for (int k = 0; k <= DEGREE; k++) {
            p->c[k][i] = k <= 4 ? 0.125 * i * four[k] : 0.015625 * (k - 5);
            p->im[k][i] = 0.125 * (i - k);
        }
        p->c[0][i] -= 2 * s * s, p->c[1][i] += 4 * s, p->c[2][i] += s * s - 2, p->c[3][i] -= 2 * s;
        p->c[4][i] += 1;
        p->lo[i] = -0.5 - 0.125 * i, p->hi[i] = 1.5;
    }
}

/* Past Tangle, some of them in vain, one of them along an axis. */
static void make_rays(problem *p) {
    for (int i = 0; i < COUNT; i++) {
        p->origin[0][i] = -4, p->origin[1][i] = 0.625 * i - 1.5, p->origin[2][i] = 0.125;
        p->direction[0][i] = 1, p->direction[1][i] = i == 2 ? 0 : -0.03125 * i;
        p->direction[2][i] = i == 2 ? 0 : 0.0625 * i - 0.25;
    }
}

static algsurf_status make_surface(problem *p) { /* Tangle */
    static const algsurf_term terms[] = {{4, 0, 0, 1},  {0, 4, 0, 1},  {0, 0, 4, 1},   {2, 0, 0, -5},
                                         {0, 2, 0, -5}, {0, 0, 2, -5}, {0, 0, 0, 11.8}};
    return algsurf_surface_from_terms(terms, sizeof terms / sizeof *terms, &p->surface);
}

/* ---- its answers, by a kernel ---- */

static algsurf_status solve_polynomials(const problem *p, const char *kernel, answers *a) {
    const algsurf_table c = {p->c[0], COUNT, 1}, im = {p->im[0], COUNT, 1};
    const algsurf_real_batch real = {.size = sizeof real,
                                     .count = COUNT,
                                     .degree = DEGREE,
                                     .coefficients = c,
                                     .lo = p->lo,
                                     .hi = p->hi,
                                     .interval_step = 1};
    const algsurf_batch_options how = {.size = sizeof how, .kernel = kernel};
    algsurf_complex_batch complex = {.size = sizeof complex, .count = COUNT, .degree = DEGREE, .re = c};
    algsurf_status status = algsurf_first_roots_batch(&real, &how, a->state[0], a->first);
    if (status == ALGSURF_OK) status = algsurf_real_roots_batch(&real, &how, a->real, a->count[0]);
    for (int which = 0; which < 2 && status == ALGSURF_OK; which++) {
        if (which) complex.im = im;
        status = algsurf_complex_roots_batch(&complex, &how, a->complex[which], a->count[1 + which]);
    }
    return status;
}

static const algsurf_plane cut = {{1, 0.25, -0.5}, 0.75}; /* some of what is seen goes, some stays */

static const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {2.5, 2, 2.25}};

static algsurf_status solve_rays(const problem *p, const char *kernel, answers *a) {
    const algsurf_ray_packet rays = {.size = sizeof rays,
                                     .count = COUNT,
                                     .origin = {p->origin[0], p->origin[1], p->origin[2]},
                                     .direction = {p->direction[0], p->direction[1], p->direction[2]}};
    const algsurf_hit_packet hits = {.size = sizeof hits,
                                     .state = a->state[1],
                                     .t = a->t[0],
                                     .t_lo = a->t[1],
                                     .t_hi = a->t[2],
                                     .position = {a->position[0], a->position[1], a->position[2]},
                                     .normal = {a->normal[0], a->normal[1], a->normal[2]}};
    const algsurf_intersect_options how = {
        .size = sizeof how, .planes = &cut, .plane_count = 1, .kernel = kernel};
    algsurf_status status = algsurf_intersect_packet(p->surface, &box, &rays, &how, &hits);
    if (status == ALGSURF_OK) status = algsurf_occluded_packet(p->surface, NULL, &rays, &how, a->occluded[0]);
    if (status == ALGSURF_OK) status = algsurf_occluded_packet(p->surface, &box, &rays, &how, a->occluded[1]);
    return status;
}

#ifndef ALGSURF_NO_PICTURES
/* The surface, lit by a square. */
static algsurf_status make_scene(const problem *p, algsurf_scene **scene) {
    static const algsurf_light light = {{6, -4, 5}, {1, 1, 1}, {0.5, 0, 0},        {0, 0.5, 0},
                                        5,          3,         ALGSURF_LIGHT_AREA, {0}};
    static const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3, 0, 0}};
    static const double eye[3] = {8, 5, 6}, at[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    algsurf_camera camera;
    algsurf_status status = algsurf_scene_create(p->surface, scene);
    if (status == ALGSURF_OK) status = algsurf_scene_set_extent(*scene, &ball);
    if (status == ALGSURF_OK) status = algsurf_camera_pinhole(eye, at, up, 12, &camera);
    if (status == ALGSURF_OK) status = algsurf_scene_set_camera(*scene, &camera);
    if (status == ALGSURF_OK) status = algsurf_scene_set_lights(*scene, &light, 1);
    return status;
}

/* How a picture is drawn. */
typedef struct manner {
    int rows, begin; /* of the whole picture, of many rows there are tiles; the first one drawn */
    algsurf_quality quality;
    int complex;
    size_t planes;
} manner;

static algsurf_status set_manner(algsurf_scene *scene, const char *kernel, const manner *m) {
    static const double imaginary = 2;
    static const algsurf_complex_space space = {sizeof space, {0, 0.0625}, &imaginary, 1};
    const algsurf_intersect_options how = {.size = sizeof how, .kernel = kernel};
    algsurf_status status = algsurf_scene_set_intersect_options(scene, &how);
    if (status == ALGSURF_OK) status = algsurf_scene_set_clip(scene, &cut, m->planes);
    if (status == ALGSURF_OK) status = algsurf_scene_set_quality(scene, m->quality);
    if (status == ALGSURF_OK) status = algsurf_scene_set_complex_space(scene, m->complex ? &space : NULL);
    return status;
}

/* Some rows of a picture in each manner: of all the rows there are, where there are sheets, where there are
 * leaves, too. */
static algsurf_status draw(const problem *p, const char *kernel, answers *a) {
    static const manner manners[PICTURES] = {
        {ROWS, 0, ALGSURF_QUALITY_FULL, 0, 1},
        {HIGH, MIDDLE, ALGSURF_QUALITY_FULL, 0, 1},
        {HIGH, OUTLINE, ALGSURF_QUALITY_STANDARD, 0, 0},
        {ROWS, 0, ALGSURF_QUALITY_STANDARD, 1, 1},
    };
    algsurf_scene *scene = NULL;
    algsurf_status status = make_scene(p, &scene);
    for (int which = 0; which < PICTURES && status == ALGSURF_OK; which++) {
        const manner *m = &manners[which];
        const algsurf_render_options size = {.size = sizeof size,
                                             .width = WIDTH,
                                             .height = m->rows,
                                             .row_begin = m->begin,
                                             .row_end = m->begin + ROWS,
                                             .threads = 1};
        const algsurf_picture picture = {.size = sizeof picture,
                                         .pixels = a->pixels[which],
                                         .t = a->hits[which],
                                         .normals = a->normals[which],
                                         .state = a->states[which]};
        status = set_manner(scene, kernel, m);
        if (status == ALGSURF_OK) status = algsurf_render(scene, &size, &picture, NULL);
    }
    algsurf_scene_free(scene);
    return status;
}
#endif

static algsurf_status answer(const problem *p, const char *kernel, answers *a) {
    memset(a, 0, sizeof *a);
    algsurf_status status = solve_polynomials(p, kernel, a);
    if (status == ALGSURF_OK) status = solve_rays(p, kernel, a);
#ifndef ALGSURF_NO_PICTURES
    if (status == ALGSURF_OK) status = draw(p, kernel, a);
#endif
    return status;
}

/* ---- single calls ---- */

static int same_roots(const problem *p, int i, const answers *a) {
    double c[DEGREE + 1];
    algsurf_real_root real[DEGREE];
    algsurf_complex_root complex[DEGREE];
    int count = 0, complex_count = 0;
    for (int k = 0; k <= DEGREE; k++) c[k] = p->c[k][i];
    return algsurf_real_roots(c, DEGREE, p->lo[i], p->hi[i], real, DEGREE, &count) == ALGSURF_OK &&
           algsurf_complex_roots_of_real(c, NULL, DEGREE, complex, &complex_count) == ALGSURF_OK &&
           count == a->count[0][i] && complex_count == a->count[1][i] &&
           memcmp(real, a->real + i * DEGREE, (size_t)count * sizeof *real) == 0 &&
           memcmp(complex, a->complex[0] + i * DEGREE, (size_t)complex_count * sizeof *complex) == 0;
}

static int same_ray(const problem *p, int i, const answers *a) {
    algsurf_ray ray = {.t_max = HUGE_VAL};
    const algsurf_intersect_options how = {.size = sizeof how, .planes = &cut, .plane_count = 1};
    algsurf_hit hit;
    for (int k = 0; k < 3; k++) ray.origin[k] = p->origin[k][i], ray.direction[k] = p->direction[k][i];
    return algsurf_intersect_first(p->surface, &box, &ray, &how, &hit) == ALGSURF_OK &&
           hit.state == a->state[1][i] && memcmp(&hit.t, &a->t[0][i], sizeof hit.t) == 0 &&
           memcmp(&hit.normal[0], &a->normal[0][i], sizeof hit.normal[0]) == 0;
}

/* ---- all of it ---- */

static int all_round(void) {
    const algsurf_i_kernel *kernel;
    int sound = algsurf_i_rounds(&algsurf_i_operations_plain);
    for (int i = 0; (kernel = algsurf_i_kernel_at(i)); i++)
        sound = sound && algsurf_i_rounds(algsurf_i_operations_of(kernel));
    return sound;
}

/* plain, other: room for answers. */
static algsurf_status all_agree(const problem *p, answers *plain, answers *other) {
    const algsurf_i_kernel *kernel;
    algsurf_status status = answer(p, "baseline", plain);
    int same = 1;
    for (int i = 0; status == ALGSURF_OK && (kernel = algsurf_i_kernel_at(i)); i++) {
        status = answer(p, kernel->name, other);
        same = same && memcmp(plain, other, sizeof *plain) == 0;
    }
    for (int i = 0; same && i < COUNT; i++) same = same_roots(p, i, plain) && same_ray(p, i, plain);
    return status != ALGSURF_OK || same ? status : ALGSURF_E_BUILD;
}

ALGSURF_I_ENTRY(algsurf_status, self_test, (void), ()) {
    problem p = {.surface = NULL};
    if (!all_round()) return ALGSURF_E_BUILD;
    answers *room = malloc(2 * sizeof *room);
    make_polynomials(&p);
    make_rays(&p);
    algsurf_status status = room ? make_surface(&p) : ALGSURF_E_NO_MEMORY;
    if (status == ALGSURF_OK) status = all_agree(&p, room, room + 1);
    free(room);
    algsurf_surface_free(p.surface);
    return status;
}
