/* glue.c - what the page asks of the library beyond ../npm/glue.c: pictures as render draws them, the extent
 * and the camera that it chooses, and one ray looked into.
 *
 * Compiled for WebAssembly together with the library and the programs' own fit.c, view.c, render_look.c, so
 * that a state means here what the options mean there.  Each function returns an algsurf_status or, where it
 * says so, a count, which is then negative in its place.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "algsurf/algsurf.h"
#include "fit.h"
#include "render_look.h"

#define EXPORTED(name) __attribute__((export_name(#name)))

/* ---- the state ---- */

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
static const double TRANSPARENT = -2; /* as background */

EXPORTED(page_state_length) int page_state_length(void) { return sizeof(page_state) / sizeof(double); }

static algsurf_extent extent_of(const page_state *state) {
    algsurf_extent extent = {.kind = state->extent_kind == 2 ? ALGSURF_EXTENT_BOX : ALGSURF_EXTENT_SPHERE};
    memcpy(extent.centre, state->centre, sizeof extent.centre);
    memcpy(extent.size, state->size, sizeof extent.size);
    return extent;
}

static algsurf_status camera_of(const page_state *state, algsurf_camera *camera) {
    return algsurf_camera_pinhole(state->eye, state->look_at, state->up, state->fov, camera);
}

static css_colour colour_from(double number) {
    uint32_t rgb = number >= 0 ? (uint32_t)number : 0;
    return (css_colour){{(uint8_t)(rgb >> 16), (uint8_t)(rgb >> 8), (uint8_t)rgb}, number >= 0};
}

static render_look look_of(const page_state *state) {
    return (render_look){.outside = colour_from(state->outside),
                         .inside = colour_from(state->inside),
                         .background = colour_from(state->background),
                         .transparent = state->background == TRANSPARENT,
                         .light = state->light_given != 0 ? LIGHT_ANGLES : LIGHT_DEFAULT,
                         .place = {state->azimuth, state->elevation, 0}};
}

/* The cutting planes; returns how many. */
static size_t planes_of(const page_state *state, algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES]) {
    const size_t count = (size_t)state->plane_count;
    for (size_t i = 0; i < count; i++) {
        memcpy(planes[i].normal, state->planes[i], sizeof planes[i].normal);
        planes[i].offset = state->planes[i][3];
    }
    return count;
}

static algsurf_complex_space space_of(const page_state *state) {
    algsurf_complex_space space = {.size = sizeof space, .sector = {state->sigma, state->delta}};
    memcpy(space.imaginary, state->imaginary, sizeof space.imaginary);
    return space;
}

/* ---- pictures ---- */

static void keep(algsurf_status *failed, algsurf_status status) {
    if (*failed == ALGSURF_OK) *failed = status;
}

static int shows_thin(const page_state *state, int degree) {
    return state->thin == THIN_ASKED || (state->thin == THIN_USUAL && degree <= VIEW_USUALLY_THIN);
}

static void set_colours(const page_state *state, const render_look *look, int degree, algsurf_scene *scene,
                        algsurf_status *failed) {
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    keep(failed, algsurf_scene_lighting(scene, lights, &lighting));
    if (*failed != ALGSURF_OK) return;
    algsurf_material material = *lighting.material;
    render_paint(look, &material);
    keep(failed, algsurf_scene_set_material(scene, &material));
    keep(failed, algsurf_scene_set_thin(scene, shows_thin(state, degree) ? material.outside : NULL));
}

/* A scene as render makes it for the options that say the same as the state; null: there is none.  The
 * surface must outlive it. */
EXPORTED(page_scene)
algsurf_scene *page_scene(const algsurf_surface *surface, const page_state *state, int32_t *status) {
    const algsurf_extent extent = extent_of(state);
    const algsurf_complex_space space = space_of(state);
    const render_look look = look_of(state);
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    const size_t plane_count = planes_of(state, planes);
    algsurf_scene *scene = NULL;
    algsurf_camera camera;
    algsurf_status failed = algsurf_scene_create(surface, &scene);
    keep(&failed, camera_of(state, &camera));
    if (failed == ALGSURF_OK) {
        keep(&failed, algsurf_scene_set_extent(scene, &extent));
        keep(&failed, algsurf_scene_set_clip(scene, planes, plane_count));
        set_colours(state, &look, algsurf_surface_degree(surface), scene, &failed);
        keep(&failed, algsurf_scene_set_antialias_threshold(scene, VIEW_THRESHOLD));
        keep(&failed, algsurf_scene_set_camera(scene, &camera));
        keep(&failed, render_light_scene(&look, &camera, &extent, scene));
        keep(&failed, algsurf_scene_set_complex_space(scene, state->complex_given != 0 ? &space : NULL));
    }
    *status = failed;
    if (failed == ALGSURF_OK) return scene;
    algsurf_scene_free(scene);
    return NULL;
}

/* With `bounded`, doubles alone decide; a ray that they leave undecided is drawn and counted as that.  For a
 * first picture where every ray takes long. */
EXPORTED(page_set_bounded) int page_set_bounded(algsurf_scene *scene, int bounded) {
    const algsurf_intersect_options options = {.size = sizeof options,
                                               .tier = bounded ? ALGSURF_TIER_BOUNDED : ALGSURF_TIER_CERTIFIED};
    return algsurf_scene_set_intersect(scene, &options);
}

/* Draws rows row_begin .. row_end-1 of a picture.
 *   rgba    four bytes a pixel
 *   t       null, or a double a pixel
 *   counts  receives rays, hits, undecided, decided by integers, thin */
EXPORTED(page_render)
int page_render(const algsurf_scene *scene, int width, int height, int row_begin, int row_end, uint8_t *rgba,
                double *t, double counts[5]) {
    const algsurf_render_options options = {.size = sizeof options,
                                            .width = width,
                                            .height = height,
                                            .row_begin = row_begin,
                                            .row_end = row_end,
                                            .threads = 1};
    algsurf_render_stats stats = {.size = sizeof stats};
    const algsurf_picture picture = {.size = sizeof picture, .pixels = rgba, .format = ALGSURF_RGBA8, .t = t};
    algsurf_status status = algsurf_render(scene, &options, &picture, &stats);
    counts[0] = (double)stats.rays;
    counts[1] = (double)stats.hits;
    counts[2] = (double)stats.undecided;
    counts[3] = (double)stats.exact_rays;
    counts[4] = (double)stats.thin;
    return status;
}

/* ---- what is shown, and from where ---- */

/* Extent and camera for the surface, as render chooses them where no option says otherwise.
 *   state   its extent, if it is given, stays
 *   width, height  of the picture
 *   fitted  receives centre, size, eye, point looked at, up (three each), the field of view, and 0 where the
 *           surface goes on outside the extent */
EXPORTED(page_fit)
int page_fit(const algsurf_surface *surface, const page_state *state, int width, int height,
             double fitted[17]) {
    view_options options = {.width = width, .height = height};
    view v;
    fit_choice choice;
    if (state->extent_given != 0) {
        options.extent = (cli_extent){extent_of(state), 1};
        options.centre = (cli_vector){{state->centre[0], state->centre[1], state->centre[2]}, 1};
    }
    algsurf_status status = fit_choose(&v, &options, surface, state->complex_given != 0,
                                       shows_thin(state, algsurf_surface_degree(surface)), &choice);
    if (status != ALGSURF_OK) return status;
    const double *const threes[] = {v.extent.centre, v.extent.size, v.eye, v.look_at, v.up};
    for (int i = 0; i < 5; i++) memcpy(fitted + 3 * i, threes[i], sizeof v.eye);
    fitted[15] = v.fov;
    fitted[16] = choice.bounded;
    return ALGSURF_OK;
}

/* ---- one ray ---- */

/* The half space that a plane keeps leaves t with slope t <= room; both sums have a few roundings. */
static void along(const algsurf_plane *plane, const algsurf_ray *ray, double *slope, double *slope_error,
                  double *room, double *room_error) {
    static const double ROUNDINGS = 8 * DBL_EPSILON;
    *slope = *slope_error = 0;
    *room = plane->offset;
    *room_error = fabs(plane->offset);
    for (int i = 0; i < 3; i++) {
        *slope += plane->normal[i] * ray->direction[i];
        *slope_error += fabs(plane->normal[i] * ray->direction[i]);
        *room -= plane->normal[i] * ray->origin[i];
        *room_error += fabs(plane->normal[i] * ray->origin[i]);
    }
    *slope_error *= ROUNDINGS;
    *room_error *= ROUNDINGS;
}

/* What the planes leave of a chord, rounded outwards: with the planes themselves in the options of a call no
 * point is lost.  Returns 0: nothing. */
static int cut(const algsurf_plane *planes, size_t count, algsurf_ray *chord) {
    for (size_t i = 0; i < count; i++) {
        double slope, slope_error, room, room_error;
        along(&planes[i], chord, &slope, &slope_error, &room, &room_error);
        if (fabs(slope) <= 2 * slope_error) {
            if (room < -room_error && slope == 0 && slope_error == 0) return 0;
            continue; /* as good as parallel */
        }
        const double t = room / slope;
        const double error = (room_error + fabs(t) * slope_error) / (fabs(slope) - slope_error);
        if (slope > 0) chord->t_max = fmin(chord->t_max, t + error);
        if (slope < 0) chord->t_min = fmax(chord->t_min, t - error);
    }
    return chord->t_min <= chord->t_max;
}

/* The ray through a point of a picture, cut to the extent and by the planes: origin, direction, t_min, t_max
 * in eight doubles.  Returns 1; 0: nothing is left, t_min and t_max are those of the ray in the extent. */
EXPORTED(page_ray)
int page_ray(const page_state *state, int width, int height, double x, double y, algsurf_ray *chord) {
    const algsurf_extent extent = extent_of(state);
    algsurf_camera camera;
    int meets = 0;
    algsurf_status status = camera_of(state, &camera);
    keep(&status, status == ALGSURF_OK ? algsurf_camera_ray(&camera, width, height, x, y, chord) : status);
    keep(&status, status == ALGSURF_OK ? algsurf_extent_clip(&extent, chord, chord, &meets) : status);
    if (status < 0) return status;
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    algsurf_ray left = *chord;
    if (!meets || !cut(planes, planes_of(state, planes), &left)) return 0;
    *chord = left;
    return 1;
}

static void tell_hit(const algsurf_hit *hit, double told[12]) {
    told[0] = hit->state;
    told[1] = hit->multiplicity;
    told[2] = hit->side;
    told[3] = hit->t;
    told[4] = hit->t_lo;
    told[5] = hit->t_hi;
    memcpy(told + 6, hit->position, sizeof hit->position);
    memcpy(told + 9, hit->normal, sizeof hit->normal);
}

/* What a ray sees, in complex space if the state says so; root: the root shown, of a real hit t. */
static algsurf_status see(const algsurf_surface *surface, const page_state *state, const algsurf_ray *ray,
                          algsurf_hit *hit, algsurf_complex *root) {
    const algsurf_extent extent = extent_of(state);
    const algsurf_complex_space space = space_of(state);
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    const algsurf_intersect_options options = {
        .size = sizeof options, .planes = planes, .plane_count = planes_of(state, planes)};
    if (state->complex_given != 0)
        return algsurf_intersect_complex(surface, &extent, ray, &space, NULL, NULL, hit, root);
    algsurf_status status = algsurf_intersect_first(surface, &extent, ray, &options, hit);
    if (status >= 0) *root = (algsurf_complex){hit->t, 0};
    return status;
}

/* The hit of a ray.
 *   told  receives state, multiplicity, side, t, t_lo, t_hi, position, normal */
EXPORTED(page_hit)
int page_hit(const algsurf_surface *surface, const page_state *state, const algsurf_ray *ray,
             double told[12]) {
    algsurf_hit hit;
    algsurf_complex root;
    algsurf_status status = see(surface, state, ray, &hit, &root);
    if (status >= 0) tell_hit(&hit, told);
    return status;
}

/* The polynomial along the ray in t: degree + 1 coefficients, and as many radii. */
EXPORTED(page_polynomial)
int page_polynomial(const algsurf_surface *surface, const algsurf_ray *ray, double *c, double *r) {
    return algsurf_expand_power(surface, ray, c, r);
}

/* Its Bernstein coefficients from t_min to t_max. */
EXPORTED(page_hull) int page_hull(const algsurf_surface *surface, const algsurf_ray *chord, double *b) {
    return algsurf_expand_bernstein(surface, chord, b, NULL);
}

/* Numbers that callbacks tell, as many as there is room for. */
typedef struct record {
    double *numbers;
    int count, capacity;
} record;

static void put(record *r, double number) {
    if (r->count < r->capacity) r->numbers[r->count++] = number;
}

static void on_cell(const algsurf_cell *cell, void *data) {
    record *r = data;
    int signs = cell->signs ? cell->degree + 1 : 0;
    if (r->count + 5 + signs > r->capacity) return;
    put(r, cell->lo);
    put(r, cell->hi);
    put(r, cell->variations);
    put(r, cell->engine);
    put(r, signs);
    for (int i = 0; i < signs; i++) put(r, cell->signs[i]);
}

static void on_point(double t, double value, int engine, void *data) {
    record *r = data;
    if (r->count + 3 > r->capacity) return;
    put(r, t);
    put(r, value);
    put(r, engine);
}

/* All hits of the ray, and the cells in which they were isolated.
 *   hits    twelve numbers each, as page_hit tells them; room for 64 of them
 *   cells   of each: lo, hi, variations, engine, number of signs, signs
 *   counts  receives the number of hits, and of numbers in cells */
EXPORTED(page_isolate)
int page_isolate(const algsurf_surface *surface, const page_state *state, const algsurf_ray *ray,
                 double *hits, double *cells, int capacity, double counts[2]) {
    const algsurf_extent extent = extent_of(state);
    record r = {.numbers = cells, .capacity = capacity};
    algsurf_observer observer = {.size = sizeof observer, .on_cell = on_cell, .data = &r};
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    const algsurf_intersect_options options = {.size = sizeof options,
                                               .observer = &observer,
                                               .planes = planes,
                                               .plane_count = planes_of(state, planes)};
    algsurf_hit found[ALGSURF_MAX_DEGREE];
    int count = 0;
    algsurf_status status =
        algsurf_intersect_all(surface, &extent, ray, &options, found, ALGSURF_MAX_DEGREE, &count);
    for (int i = 0; i < count; i++) tell_hit(&found[i], hits + 12 * i);
    counts[0] = count;
    counts[1] = r.count;
    return status;
}

/* The first hit by a method of refinement, and the points at which it evaluates.
 *   points  of each: t, value, engine
 *   counts  receives the number of numbers in points, and of evaluations */
EXPORTED(page_refine)
int page_refine(const algsurf_surface *surface, const page_state *state, const algsurf_ray *ray, int method,
                double told[12], double *points, int capacity, double counts[2]) {
    const algsurf_extent extent = extent_of(state);
    record r = {.numbers = points, .capacity = capacity};
    algsurf_observer observer = {.size = sizeof observer, .on_point = on_point, .data = &r};
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    const algsurf_intersect_options options = {.size = sizeof options,
                                               .method = method,
                                               .observer = &observer,
                                               .planes = planes,
                                               .plane_count = planes_of(state, planes)};
    algsurf_hit hit;
    algsurf_status status = algsurf_intersect_first(surface, &extent, ray, &options, &hit);
    if (status >= 0) tell_hit(&hit, told);
    counts[0] = r.count;
    counts[1] = (double)observer.evaluations;
    return status;
}

/* The surface with the magnitudes of the coefficients; it is to be freed. */
static algsurf_status magnitudes_of(const algsurf_surface *surface, algsurf_surface **magnitudes) {
    const size_t count = algsurf_surface_term_count(surface);
    algsurf_term *terms = malloc((count + 1) * sizeof *terms);
    if (!terms) return ALGSURF_E_NO_MEMORY;
    algsurf_status status = algsurf_surface_terms(surface, terms);
    for (size_t i = 0; i < count; i++) terms[i].a = fabs(terms[i].a);
    keep(&status, algsurf_surface_from_terms(terms, count, magnitudes));
    free(terms);
    return status;
}

/* Adds to the radii what a relative error of 2^-52 in each component of the origin changes: each term of the
 * coefficient of s^k is a product of at most degree - k of these. */
static algsurf_status add_rounding(const algsurf_surface *surface, const algsurf_ray *ray, double *r) {
    const int degree = algsurf_surface_degree(surface);
    double m[ALGSURF_MAX_DEGREE + 1], radii[ALGSURF_MAX_DEGREE + 1];
    algsurf_surface *magnitudes = NULL;
    algsurf_ray positive = *ray;
    for (int i = 0; i < 3; i++) {
        positive.origin[i] = fabs(ray->origin[i]);
        positive.direction[i] = fabs(ray->direction[i]);
    }
    algsurf_status status = magnitudes_of(surface, &magnitudes);
    keep(&status, status == ALGSURF_OK ? algsurf_expand_power(magnitudes, &positive, m, radii) : status);
    algsurf_surface_free(magnitudes);
    if (status != ALGSURF_OK) return status;
    for (int k = 0; k < degree; k++)
        if (m[k] + radii[k] > 0) r[k] += 1.01 * (degree - k) * DBL_EPSILON * (m[k] + radii[k]) + DBL_MIN;
    return ALGSURF_OK;
}

/* Is a b + c, rounded, what fma gives without an error? */
static int exact_sum(double a, double b, double c) {
    const double product = a * b, sum = product + c, part = sum - product;
    return fma(a, b, -product) == 0 && (product - (sum - part)) + (c - part) == 0;
}

/* t = middle + half s: about the middle of the chord, or about the eye for a ray without a bounded chord.
 * half is a power of two. */
typedef struct parameter {
    double middle, half;
} parameter;
static const parameter THE_SAME = {0, 1};

static parameter about_middle(const algsurf_ray *chord) {
    const double length = 0.5 * (chord->t_max - chord->t_min);
    int exponent = 0;
    if (!isfinite(length) || !(length > 0)) return THE_SAME;
    (void)frexp(length, &exponent);
    return (parameter){chord->t_min + length, ldexp(1, exponent)};
}

/* The ray's polynomial in s.  The radii cover that the origin is rounded.  Returns E_RANGE where that cannot
 * be done. */
static algsurf_status in_parameter(const algsurf_surface *surface, const algsurf_ray *chord, parameter s,
                                   double *c, double *r) {
    static const double TINY = 1e-290; /* roundings above it are relative */
    algsurf_ray ray = *chord;
    int exact = 1;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = fma(s.middle, chord->direction[i], chord->origin[i]);
        ray.direction[i] = s.half * chord->direction[i];
        if (ray.direction[i] / s.half != chord->direction[i]) return ALGSURF_E_RANGE;
        if (exact_sum(s.middle, chord->direction[i], chord->origin[i])) continue;
        if (fabs(ray.origin[i]) < TINY) return ALGSURF_E_RANGE;
        exact = 0;
    }
    algsurf_status status = algsurf_expand_power(surface, &ray, c, r);
    return status != ALGSURF_OK || exact ? status : add_rounding(surface, &ray, r);
}

/* All roots s of the polynomial along the ray. */
static algsurf_status real_roots_in(const algsurf_surface *surface, const algsurf_ray *chord, parameter s,
                                    algsurf_complex_root *root, int *count) {
    double c[ALGSURF_MAX_DEGREE + 1], r[ALGSURF_MAX_DEGREE + 1];
    const algsurf_status status = in_parameter(surface, chord, s, c, r);
    if (status != ALGSURF_OK) return status;
    return algsurf_complex_roots_of_real(c, r, algsurf_surface_degree(surface), root, count);
}

/* The same of the polynomial in t with the state's imaginary parts. */
static algsurf_status complex_roots_in(const algsurf_surface *surface, const algsurf_ray *chord,
                                       const page_state *state, algsurf_complex_root *root, int *count) {
    algsurf_complex c[ALGSURF_MAX_DEGREE + 1];
    double p[ALGSURF_MAX_DEGREE + 1], radii[ALGSURF_MAX_DEGREE + 1];
    const int degree = algsurf_surface_degree(surface);
    const algsurf_status status = algsurf_expand_power(surface, chord, p, radii);
    if (status != ALGSURF_OK) return status;
    for (int k = 0; k <= degree; k++) c[k] = (algsurf_complex){p[k], state->imaginary[k]};
    return algsurf_complex_roots(c, radii, degree, root, count);
}

/* middle + half s, rounded in the direction of `to`. */
static double outwards(double middle, double half, double s, double to) {
    return s == 0 ? middle : nextafter(middle + nextafter(half * s, to), to);
}

/* All roots t of the polynomial along the ray, with the state's imaginary parts.  The boxes hold the roots of
 * the exact polynomial along the ray of these doubles.
 *   rows  eight numbers each: root (re, im), box (re lo, re hi, im lo, im hi), multiplicity, real; room for
 * 64 Returns how many. */
EXPORTED(page_complex_roots)
int page_complex_roots(const algsurf_surface *surface, const page_state *state, const algsurf_ray *chord,
                       double *rows) {
    algsurf_complex_root root[ALGSURF_MAX_DEGREE];
    parameter s = THE_SAME;
    int degree = algsurf_surface_degree(surface), count = 0, real = 1;
    algsurf_status status;
    for (int k = 0; k <= degree; k++) real = real && (state->complex_given == 0 || state->imaginary[k] == 0);
    if (real) {
        s = about_middle(chord);
        status = real_roots_in(surface, chord, s, root, &count);
        if (status == ALGSURF_E_RANGE) { /* about the eye nothing is rounded */
            s = THE_SAME;
            status = real_roots_in(surface, chord, s, root, &count);
        }
    } else {
        status = complex_roots_in(surface, chord, state, root, &count);
    }
    for (int i = 0; i < count; i++, rows += 8) {
        const algsurf_complex_root *z = &root[i];
        rows[0] = s.middle + s.half * z->root.re;
        rows[1] = s.half * z->root.im;
        rows[2] = outwards(s.middle, s.half, z->box.re.lo, -INFINITY);
        rows[3] = outwards(s.middle, s.half, z->box.re.hi, INFINITY);
        rows[4] = outwards(0, s.half, z->box.im.lo, -INFINITY);
        rows[5] = outwards(0, s.half, z->box.im.hi, INFINITY);
        rows[6] = z->multiplicity;
        rows[7] = z->real;
    }
    return status < 0 ? (int)status : count;
}

/* The root that complex space shows; real space: the hit.
 *   root  receives its real and imaginary part
 * Returns an algsurf_hit_state. */
EXPORTED(page_chosen)
int page_chosen(const algsurf_surface *surface, const page_state *state, const algsurf_ray *ray,
                double root[2]) {
    algsurf_hit hit;
    algsurf_complex z = {0, 0};
    algsurf_status status = see(surface, state, ray, &hit, &z);
    if (status < 0) return status;
    root[0] = z.re;
    root[1] = z.im;
    return hit.state;
}
