/* glue_ray.c - one ray of a picture: its chord in the extent, its polynomial, its hits and the search for
 * them. */
#include "glue.h"

/* ---- the chord ---- */

/* The ray through a point of a picture, cut to the extent and by the planes: origin, direction, t_min, t_max
 * in eight doubles.  Returns 1; 0: nothing is left, t_min and t_max are those of the ray in the extent. */
EXPORTED(page_ray)
int page_ray(const page_state *state, int width, int height, double x, double y, algsurf_ray *chord) {
    const algsurf_extent extent = extent_of(state);
    algsurf_camera camera;
    int meets = 0;
    algsurf_status status = camera_of(state, &camera);
    keep(&status, status == ALGSURF_OK ? algsurf_camera_ray(&camera, width, height, x, y, chord) : status);
    keep(&status, status == ALGSURF_OK ? algsurf_ray_clip(chord, &extent, NULL, 0, chord, &meets) : status);
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    if (status == ALGSURF_OK && meets)
        keep(&status, algsurf_ray_clip(chord, &extent, planes, planes_of(state, planes), chord, &meets));
    return status < 0 ? status : meets;
}

/* ---- what the ray sees ---- */

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

/* ---- the polynomial ---- */

/* The polynomial along the ray in t: degree + 1 coefficients, and as many radii. */
EXPORTED(page_polynomial)
int page_polynomial(const algsurf_surface *surface, const algsurf_ray *ray, double *c, double *r) {
    return algsurf_expand_power(surface, ray, c, r);
}

/* Its Bernstein coefficients from t_min to t_max. */
EXPORTED(page_hull) int page_hull(const algsurf_surface *surface, const algsurf_ray *chord, double *b) {
    return algsurf_expand_bernstein(surface, chord, b, NULL);
}

/* ---- the search for hits ---- */

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
