/* glue.h - a state of the page as engine.js writes it into the memory of WebAssembly.
 *
 * The functions that engine.js calls are in
 *     glue_picture.c  pictures as render draws them, and the extent and the camera that it chooses
 *     glue_ray.c      one ray: its chord, its polynomial, its hits and the search for them
 *     glue_roots.c    all complex roots of the polynomial along a ray
 *     glue_nothing.c  why nothing is seen
 *     glue_mesh.c     triangles, as the program mesh makes them
 * Each returns an algsurf_status or, where it says so, a count, which is then negative in its place.
 *
 * They are compiled for WebAssembly together with the library, ../npm/glue.c and the programs' own fit.c,
 * view.c, axes.c, render_look.c and mesh_*.c, so that a state means here what the options mean there.
 */
#ifndef PAGE_GLUE_H
#define PAGE_GLUE_H

#include <string.h>

#include "algsurf/algsurf.h"

#define EXPORTED(name) __attribute__((export_name(#name)))

enum { THIN_USUAL = -1, THIN_NONE = 0, THIN_ASKED = 1 };

/* What engine.js writes, numbers only.  Colours are 0xrrggbb; below 0: not given. */
typedef struct page_state {
    double extent_given; /* 0: it is to be chosen */
    double extent_kind, centre[3], size[3];
    double eye[3], look_at[3], up[3], fov;
    double outside, inside, background;
    double light_given, azimuth, elevation;
    double thin;
    double plane_count, planes[ALGSURF_MAX_CLIP_PLANES][4];
    double complex_given, sigma, delta, imaginary[ALGSURF_MAX_DEGREE + 1];
} page_state;

static inline algsurf_extent extent_of(const page_state *state) {
    algsurf_extent extent = {.kind = state->extent_kind == 2 ? ALGSURF_EXTENT_BOX : ALGSURF_EXTENT_SPHERE};
    memcpy(extent.centre, state->centre, sizeof extent.centre);
    memcpy(extent.size, state->size, sizeof extent.size);
    return extent;
}

static inline algsurf_status camera_of(const page_state *state, algsurf_camera *camera) {
    return algsurf_camera_pinhole(state->eye, state->look_at, state->up, state->fov, camera);
}

/* The cutting planes; returns how many. */
static inline size_t planes_of(const page_state *state, algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES]) {
    const size_t count = (size_t)state->plane_count;
    for (size_t i = 0; i < count; i++) {
        memcpy(planes[i].normal, state->planes[i], sizeof planes[i].normal);
        planes[i].offset = state->planes[i][3];
    }
    return count;
}

/* It points into the state. */
static inline algsurf_complex_space space_of(const page_state *state) {
    return (algsurf_complex_space){.size = sizeof(algsurf_complex_space),
                                   .sector = {state->sigma, state->delta},
                                   .imaginary = state->imaginary,
                                   .imaginary_count = ALGSURF_MAX_DEGREE + 1};
}

/* The first failure is kept. */
static inline void keep(algsurf_status *failed, algsurf_status status) {
    if (*failed == ALGSURF_OK) *failed = status;
}

#endif
