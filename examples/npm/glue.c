/* glue.c - the library as algsurf.mjs calls it: numbers and arrays of doubles, no structs.
 *
 * Compiled for WebAssembly together with the library, by examples/npm/build.  What takes only numbers and
 * arrays anyway is exported as it is, by the linker.  Each function returns an algsurf_status or, where it
 * says so, a count, which is then negative in its place.  Memory is the caller's, taken by malloc.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "algsurf/algsurf.h"

#ifndef EXPORTED /* a module that needs some of it names these to the linker */
#define EXPORTED(name) __attribute__((export_name(#name)))
#endif

/* ---- roots ---- */

/* The real roots in [lo,hi]; five doubles each: root, lo, hi, multiplicity, sign.  Returns how many. */
EXPORTED(real_roots) int real_roots(const double *c, int degree, double lo, double hi, double *rows) {
    algsurf_real_root root[ALGSURF_MAX_POLY_DEGREE];
    int count = 0;
    algsurf_status status = algsurf_real_roots(c, degree, lo, hi, root, ALGSURF_MAX_POLY_DEGREE, &count);
    for (int i = 0; i < count; i++, rows += 5) {
        rows[0] = root[i].root;
        rows[1] = root[i].lo;
        rows[2] = root[i].hi;
        rows[3] = root[i].multiplicity;
        rows[4] = root[i].sign;
    }
    return status < 0 ? (int)status : count;
}

/* All roots; eight doubles each: root (re, im), box (re lo, re hi, im lo, im hi), multiplicity, real.
 *   c  degree+1 coefficients: doubles if `real` is 1, else pairs of them
 * Returns how many. */
EXPORTED(complex_roots) int complex_roots(const double *c, int real, int degree, double *rows) {
    algsurf_complex_root root[ALGSURF_MAX_POLY_DEGREE];
    int count = 0;
    algsurf_status status =
        real ? algsurf_complex_roots_of_real(c, NULL, degree, root, &count)
             : algsurf_complex_roots((const algsurf_complex *)c, NULL, degree, root, &count);
    for (int i = 0; i < count; i++, rows += 8) {
        rows[0] = root[i].root.re;
        rows[1] = root[i].root.im;
        rows[2] = root[i].box.re.lo;
        rows[3] = root[i].box.re.hi;
        rows[4] = root[i].box.im.lo;
        rows[5] = root[i].box.im.hi;
        rows[6] = root[i].multiplicity;
        rows[7] = root[i].real;
    }
    return status < 0 ? (int)status : count;
}

/* ---- surfaces ---- */

/* What became of a surface that was to be made. */
typedef struct outcome {
    int32_t status;
    uint32_t offset;     /* in the text, in bytes, */
    const char *message; /* and what is wrong there; null: nothing is said about the text */
    uint32_t length;     /* of what is wrong, in bytes */
} outcome;

/* A surface from an equation, or null.
 *   names, values  `count` constants; each name ends in a zero byte, and the next one follows it */
EXPORTED(surface_from_equation)
algsurf_surface *surface_from_equation(const char *text, const char *names, const double *values,
                                       size_t count, outcome *result) {
    algsurf_constant *constants = calloc(count + 1, sizeof *constants);
    algsurf_parse_error error = {0, 0, NULL};
    algsurf_surface *surface = NULL;
    algsurf_status status = ALGSURF_E_NO_MEMORY;
    if (constants) {
        for (size_t i = 0; i < count; i++, names += strlen(names) + 1)
            constants[i] = (algsurf_constant){names, values[i]};
        status = algsurf_surface_from_equation(text, constants, count, &surface, &error);
    }
    free(constants);
    *result = (outcome){status, (uint32_t)error.offset, error.message, (uint32_t)error.length};
    return surface;
}

/* A surface from its terms, or null: for each its coefficient, and in `exponents` its three exponents. */
EXPORTED(surface_from_terms)
algsurf_surface *surface_from_terms(const double *coefficients, const int32_t *exponents, size_t count,
                                    outcome *result) {
    algsurf_term *terms = calloc(count + 1, sizeof *terms);
    algsurf_surface *surface = NULL;
    algsurf_status status = ALGSURF_E_NO_MEMORY;
    if (terms) {
        for (size_t i = 0; i < count; i++, exponents += 3)
            terms[i] = (algsurf_term){exponents[0], exponents[1], exponents[2], coefficients[i]};
        status = algsurf_surface_from_terms(terms, count, &surface);
    }
    free(terms);
    *result = (outcome){status, 0, NULL, 0};
    return surface;
}

/* ---- rays ---- */

/* An extent: all of space (0), a ball (1) or a box (2); and six doubles, the centre and the size. */
static algsurf_extent extent_of(int kind, const double *places) {
    algsurf_extent extent = {.kind = ALGSURF_EXTENT_ALL};
    if (kind == 1) extent.kind = ALGSURF_EXTENT_SPHERE;
    if (kind == 2) extent.kind = ALGSURF_EXTENT_BOX;
    memcpy(extent.centre, places, sizeof extent.centre);
    memcpy(extent.size, places + 3, sizeof extent.size);
    return extent;
}

/* The first hit of each of `count` rays.
 *   rays  eight arrays of `count` doubles: origin x, y, z, direction x, y, z, t_min, t_max
 *   hits  nine arrays of `count` doubles: t, t_lo, t_hi, position x, y, z, normal x, y, z */
EXPORTED(first_hits)
int first_hits(const algsurf_surface *surface, int kind, const double *places, size_t count,
               const double *rays, double *hits, unsigned char *state, signed char *side, int *multiplicity) {
    const algsurf_extent extent = extent_of(kind, places);
    const algsurf_ray_packet from = {.size = sizeof from,
                                     .count = count,
                                     .origin = {rays, rays + count, rays + 2 * count},
                                     .direction = {rays + 3 * count, rays + 4 * count, rays + 5 * count},
                                     .t_min = rays + 6 * count,
                                     .t_max = rays + 7 * count};
    const algsurf_hit_packet to = {.size = sizeof to,
                                   .state = state,
                                   .t = hits,
                                   .t_lo = hits + count,
                                   .t_hi = hits + 2 * count,
                                   .position = {hits + 3 * count, hits + 4 * count, hits + 5 * count},
                                   .normal = {hits + 6 * count, hits + 7 * count, hits + 8 * count},
                                   .multiplicity = multiplicity,
                                   .side = side};
    return algsurf_intersect_packet(surface, &extent, &from, NULL, &to);
}

/* ---- pictures ---- */

EXPORTED(scene_extent) int scene_extent(algsurf_scene *scene, int kind, const double *places) {
    const algsurf_extent extent = extent_of(kind, places);
    return algsurf_scene_set_extent(scene, &extent);
}

/* view: eye, the point looked at, up; fov_or_height: degrees of a pinhole camera, or an orthographic one's
 * height. */
EXPORTED(scene_camera)
int scene_camera(algsurf_scene *scene, const double *view, int orthographic, double fov_or_height) {
    algsurf_camera camera;
    algsurf_status status =
        orthographic ? algsurf_camera_orthographic(view, view + 3, view + 6, fov_or_height, &camera)
                     : algsurf_camera_pinhole(view, view + 3, view + 6, fov_or_height, &camera);
    return status == ALGSURF_OK ? algsurf_scene_set_camera(scene, &camera) : status;
}

/* material: outside and inside (red, green, blue), diffuse, ambient, fill, specular, roughness, haze; NaN: as
 * it is. */
EXPORTED(scene_material) int scene_material(algsurf_scene *scene, const double *material) {
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    algsurf_status status = algsurf_scene_get_lighting(scene, lights, &lighting);
    if (status != ALGSURF_OK) return status;
    algsurf_material m = *lighting.material;
    double *const numbers[12] = {m.outside,    m.outside + 1, m.outside + 2, m.inside,
                                 m.inside + 1, m.inside + 2,  &m.diffuse,    &m.ambient,
                                 &m.fill,      &m.specular,   &m.roughness,  &m.haze};
    for (int i = 0; i < 12; i++)
        if (!isnan(material[i])) *numbers[i] = material[i];
    return algsurf_scene_set_material(scene, &m);
}

/* imaginary: ALGSURF_MAX_DEGREE + 1 numbers. */
EXPORTED(scene_complex_space)
int scene_complex_space(algsurf_scene *scene, double sigma, double delta, const double *imaginary) {
    const algsurf_complex_space space = {.size = sizeof space,
                                         .sector = {sigma, delta},
                                         .imaginary = imaginary,
                                         .imaginary_count = ALGSURF_MAX_DEGREE + 1};
    return algsurf_scene_set_complex_space(scene, &space);
}

/* Draws rows row_begin .. row_end-1 of a picture.
 *   rgba    four bytes a pixel
 *   t       null, or a double a pixel
 *   counts  receives three: rays, hits, undecided */
EXPORTED(render)
int render(const algsurf_scene *scene, int width, int height, int row_begin, int row_end, uint8_t *rgba,
           double *t, double *counts) {
    const algsurf_render_options options = {.size = sizeof options,
                                            .width = width,
                                            .height = height,
                                            .row_begin = row_begin,
                                            .row_end = row_end,
                                            .threads = 1};
    algsurf_render_stats stats = {.size = sizeof stats};
    const algsurf_picture picture = {.size = sizeof picture, .pixels = rgba, .format = ALGSURF_RGBA8, .t = t};
    algsurf_status status = algsurf_render(scene, &options, &picture, &stats);
    if (status != ALGSURF_OK) return status;
    counts[0] = (double)stats.rays;
    counts[1] = (double)stats.hits;
    counts[2] = (double)stats.undecided;
    return ALGSURF_OK;
}
