/* test_render_exact.c - pictures from extreme places, pixel by pixel against exact arithmetic.
 *
 * A view is a surface (named, Chmutov's, random dense of degree up to 20; its coordinates and coefficients
 * scaled), an extent (as shown, a box, a small or a huge part of the surface far from its origin) and a
 * camera (grazing the extent, 1e8 radii away, inside, on a singular point, in planes of symmetry, along the
 * axes, aimed at a silhouette until pixels are rounding errors apart, parallel).  It is drawn in the standard
 * tier; any pixels, and those with a neighbour of the other kind, are compared with the first root of P along
 * the very ray of algsurf_camera_ray, over integers (exact_pixel.h).  Wrong is
 *   - a point where that ray has no root inside the extent, and a miss where it has one, but for roots within
 *     ROOM rounding errors of t at an end of the extent;
 *   - a point that is not the first root: |t - root| > u (T |t| + S |gradient| distance (1 + slopes) +
 *     V n sum |a| |X|^e + (B radius)^2 |d2P/dt2|) / |dP/dt| + R radius, the factors below: what rounding t,
 * the ray and P comes to, and what one Newton step leaves of an error of B. A pixel may be undecided: then
 * algsurf_intersect_first says so of its ray, and there are no more of them than the picture counts.
 *
 * The tests behind the first are places found by reading the bounds, or by long runs of the first.
 *
 * Breaks tried, each caught by test_extreme_views: a sign used within the error radius (radius 0); noise 0.
 *
 *     test_render_exact [views [first [seed]]]     default: views 0 to 249; 30000 take a quarter of an hour
 */
#include "catalogue.h"
#include "exact_pixel.h"
#include "scenes.h"

#define U 0x1p-53
#define ROOM 16
#define T_FACTOR 16
#define S_FACTOR 32
#define V_FACTOR 64
#define R_FACTOR 0x1p-36
#define B_FACTOR 0x1p-29

enum { MOST_PIXELS = 4096, NAMED = 15, CHECKED = 10 };

ARGUMENT(1, int, view_count, 150)
ARGUMENT(2, int, first_view, 0)
ARGUMENT(3, uint64_t, first_seed, 20261121)

typedef struct view {
    int number;
    uint64_t seed;
    char name[64];
    algsurf_surface *surface;
    algsurf_term *terms;
    int term_count, degree;
    algsurf_extent extent;
    algsurf_camera camera;
    double radius; /* of the ball about the extent */
    int width, height, row_begin, row_end, antialias;
    int tier;
    const char *kernel;
} view;

typedef struct drawing {
    double hits[MOST_PIXELS];
    uint8_t bytes[3 * MOST_PIXELS];
    algsurf_render_stats stats;
} drawing;

static struct {
    long views, rays, single, checked, hits, misses, edges, undecided, excused, clustered, wrong;
    double worst; /* error of t by what is allowed */
} seen;

/* ---- surfaces ---- */

static void add_chebyshev(algsurf_term *terms, int *count, int axis, int n) {
    double c[3][ALGSURF_MAX_DEGREE + 1] = {{1}, {0, 1}};
    for (int k = 2; k <= n; k++)
        for (int e = 0; e <= k; e++)
            c[k % 3][e] = 2 * (e > 0 ? c[(k - 1) % 3][e - 1] : 0) - (e <= k - 2 ? c[(k - 2) % 3][e] : 0);
    for (int e = 0; e <= n; e++)
        terms[(*count)++] =
            (algsurf_term){axis == 0 ? e : 0, axis == 1 ? e : 0, axis == 2 ? e : 0, c[n % 3][e]};
}

static double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/* Kostlan's weights: then the number of roots along a line is about the square root of the degree. */
static void add_dense(algsurf_term *terms, int *count, int n, uint64_t *seed) {
    for (int i = 0; i <= n; i++)
        for (int j = 0; i + j <= n; j++)
            for (int k = 0; i + j + k <= n; k++) {
                double ways =
                    factorial(n) / factorial(i) / factorial(j) / factorial(k) / factorial(n - i - j - k);
                terms[(*count)++] = (algsurf_term){i, j, k, sqrt(ways) * random_unit(seed)};
            }
}

/* Coordinates times 2^length, P times 2^value: as far as doubles go. */
static void scale_terms(algsurf_term *terms, int count, int length, int value) {
    int lowest = 0, highest = 0;
    for (int i = 0; i < count; i++) {
        int e, power = terms[i].i + terms[i].j + terms[i].k;
        if (terms[i].a == 0) continue;
        (void)frexp(terms[i].a, &e);
        e -= power * length;
        if (e < lowest) lowest = e;
        if (e > highest) highest = e;
    }
    if (highest + value > 1000 || lowest + value < -960) value = -(highest + lowest) / 2;
    for (int i = 0; i < count; i++)
        terms[i].a = ldexp(terms[i].a, value - (terms[i].i + terms[i].j + terms[i].k) * length);
}

static void set_surface(view *v, const algsurf_term *terms, int count) {
    v->surface = surface_of_terms(terms, (size_t)count);
    v->term_count = (int)algsurf_surface_term_count(v->surface);
    v->degree = algsurf_surface_degree(v->surface);
    v->terms = unit_keep(calloc((size_t)v->term_count, sizeof *v->terms), free);
    assert_ok(algsurf_surface_terms(v->surface, v->terms));
}

static void make_surface(view *v, uint64_t *seed, int *length) {
    static const int degrees[] = {7, 9, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20};
    int kind = v->number % (NAMED + 6), count = 0, n;
    algsurf_term *terms = calloc(2000, sizeof *terms);
    v->extent = (algsurf_extent){.kind = ALGSURF_EXTENT_SPHERE, .size = {kind % 2 ? 1.2 : 2}};
    if (kind < NAMED) {
        const catalogue_entry *entry = catalogue + kind;
        v->extent = entry->extent;
        algsurf_surface *named = surface_of(entry->equation);
        n = entry->degree, count = (int)algsurf_surface_term_count(named);
        assert_ok(algsurf_surface_terms(named, terms));
        (void)snprintf(v->name, sizeof v->name, "%s", entry->name);
    } else if (kind < NAMED + 2) {
        n = kind == NAMED ? 8 : 16;
        for (int axis = 0; axis < 3; axis++) add_chebyshev(terms, &count, axis, n);
        if (random_int(seed, 2)) terms[count++] = (algsurf_term){0, 0, 0, 1};
        (void)snprintf(v->name, sizeof v->name, "chmutov-%d", n);
    } else {
        n = degrees[random_int(seed, kind == NAMED + 5 ? 12 : 4)];
        add_dense(terms, &count, n, seed);
        (void)snprintf(v->name, sizeof v->name, "dense-%d", n);
    }
    *length = random_int(seed, 3) ? 0 : (int)(random_between(seed, -1, 1) * fmin(332, 900.0 / n));
    scale_terms(terms, count, *length, random_int(seed, 3) ? 0 : (int)random_between(seed, -498, 498));
    set_surface(v, terms, count);
    free(terms);
}

/* ---- extents ---- */

/* A point of the surface about `far` from its origin, if one is found. */
static int find_point(const view *v, double far, uint64_t *seed, double point[3]) {
    for (int i = 0; i < 20; i++) {
        algsurf_ray ray = {.t_max = 4 * far};
        for (int k = 0; k < 3; k++) {
            ray.origin[k] = far * random_unit(seed);
            ray.direction[k] = random_unit(seed);
        }
        algsurf_hit hit = first_hit_of(v->surface, NULL, &ray, NULL);
        if (hit.state != ALGSURF_STATE_HIT) continue;
        for (int k = 0; k < 3; k++) point[k] = hit.position[k];
        return 1;
    }
    return 0;
}

static void make_extent(view *v, int length, uint64_t *seed) {
    algsurf_extent *e = &v->extent;
    double unit = ldexp(1, length), far;
    int kind = random_int(seed, 8);
    for (int i = 0; i < 3; i++) e->centre[i] *= unit, e->size[i] *= unit;
    if (kind == 1 || kind == 2) { /* a part of the surface */
        far = kind == 1 ? e->size[0] : e->size[0] * pow(10, random_between(seed, -6, 6));
        if (find_point(v, far, seed, e->centre))
            e->size[0] = far * pow(10, random_between(seed, kind == 1 ? -6 : -3, 0));
    } else if (kind == 3) {
        for (int i = 0; i < 3; i++) e->centre[i] += e->size[0] * random_between(seed, -1, 1);
    } else if (kind == 4) {
        e->size[0] *= pow(10, random_between(seed, -6, 6));
    }
    v->radius = e->size[0];
    if (random_int(seed, 4) == 0) {
        e->kind = ALGSURF_EXTENT_BOX;
        v->radius = 0;
        for (int i = 0; i < 3; i++) {
            e->size[i] = e->size[0] * (i == 0                             ? 1
                                       : random_between(seed, 0, 1) < 0.2 ? 1e-3
                                                                          : random_between(seed, 0.3, 1));
            v->radius += e->size[i] * e->size[i];
        }
        v->radius = sqrt(v->radius);
    }
}

/* ---- cameras ---- */

static void unit_vector(double d[3], int kind, uint64_t *seed) {
    double length = 0;
    int axis = random_int(seed, 3);
    for (int i = 0; i < 3; i++) {
        d[i] = random_unit(seed);
        if (kind == 0) d[i] = i == axis;      /* along an axis */
        if (kind == 1 && i == axis) d[i] = 0; /* in a plane of symmetry */
        if (kind == 2 && i == axis && i > 0) d[i] = d[i - 1];
        length += d[i] * d[i];
    }
    for (int i = 0; i < 3; i++) d[i] /= sqrt(length);
}

static void aim(view *v, const double eye[3], const double at[3], double tangent, uint64_t *seed) {
    double up[3], fov = fmin(170, fmax(1e-5, 2 * atan(tangent) * 57.29577951308232));
    for (int turns = 0; turns < 10; turns++) {
        unit_vector(up, random_int(seed, 2) * 3, seed);
        if (algsurf_camera_pinhole(eye, at, up, fov, &v->camera) == ALGSURF_OK) return;
    }
    fail_msg("view %d: no camera at %a %a %a for %a %a %a, %g degrees", v->number, eye[0], eye[1], eye[2],
             at[0], at[1], at[2], fov);
}

static void aim_parallel(view *v, const double eye[3], const double at[3], double height, uint64_t *seed) {
    double up[3];
    for (int turns = 0; turns < 10; turns++) {
        unit_vector(up, random_int(seed, 2) * 3, seed);
        if (algsurf_camera_orthographic(eye, at, up, height, &v->camera) == ALGSURF_OK) return;
    }
    fail_msg("view %d: no camera", v->number);
}

static void make_picture(view *v, uint64_t *seed) {
    v->width = 1 + random_int(seed, random_int(seed, 2) ? 24 : 200);
    int rows = 1 + random_int(seed, MOST_PIXELS / v->width < 14 ? MOST_PIXELS / v->width : 14);
    v->height = rows + (random_int(seed, 2) ? 0 : v->width);
    v->row_begin = random_int(seed, v->height - rows + 1);
    if (random_int(seed, 2)) v->row_begin = (v->height - rows) / 2;
    v->row_end = v->row_begin + rows;
    v->antialias = random_int(seed, 8) ? 1 : 2;
    v->kernel = algsurf_kernel_name(0);
}

static void make_camera(view *v, uint64_t *seed) {
    static const double distances[] = {1.0001, 1.000002, 1.3, 4, 1e2, 1e4, 1e6, 1e7, 1e8, 0.5, 0, 4};
    double far = distances[random_int(seed, 12)], eye[3], at[3], d[3], aside[3], zoom = 1;
    int centred = random_int(seed, 3) == 0;
    if (random_int(seed, 5) == 0) far = pow(10, random_between(seed, -3, 8));
    if (random_int(seed, 3) == 0) zoom = pow(10, random_between(seed, -7, 0));
    unit_vector(d, random_int(seed, 5), seed);
    unit_vector(aside, random_int(seed, 4), seed);
    double off = centred ? 0 : random_between(seed, 0, 1) * v->radius;
    for (int i = 0; i < 3; i++) {
        eye[i] = v->extent.centre[i] + far * v->radius * d[i];
        at[i] = v->extent.centre[i] + off * aside[i];
        if (far == 0) { /* at the origin, or at a point of the surface, where singular points are */
            eye[i] = zoom < 1 ? v->extent.centre[i] : 0;
            at[i] = eye[i] + v->radius * aside[i];
        }
    }
    double spread = far > 1 ? 1 / sqrt(far * far - 1) : random_between(seed, 0.3, 11);
    double share = (double)v->height / fmax(v->width, v->height); /* the longer side spans the ball */
    if (far > 0 && random_int(seed, 4) == 0) {
        if (far < 1.2 && far > 1 && random_int(seed, 2)) far = 3;
        for (int i = 0; i < 3; i++) at[i] = eye[i] - far * v->radius * d[i] + off * aside[i];
        aim_parallel(v, eye, at, 2.1 * v->radius * zoom * share, seed);
    } else {
        aim(v, eye, at, spread * zoom * share, seed);
    }
}

/* ---- drawing ---- */

static void draw(const view *v, const char *kernel, int row_begin, drawing *out) {
    algsurf_intersect_options how = {.size = sizeof how, .tier = v->tier, .kernel = kernel};
    algsurf_render_options o = {.size = sizeof o,
                                .width = v->width,
                                .height = v->height,
                                .row_begin = row_begin,
                                .row_end = v->row_end,
                                .threads = 1};
    const algsurf_picture planes = {.size = sizeof planes, .pixels = out->bytes, .t = out->hits};
    out->stats.size = sizeof out->stats;
    algsurf_scene *scene = scene_of(v->surface, &v->extent, &v->camera, &how);
    assert_ok(algsurf_scene_set_antialias(scene, v->antialias));
    assert_ok(algsurf_scene_set_lights(scene, NULL, 0));
    assert_ok(algsurf_render(scene, &o, &planes, &out->stats));
}

static algsurf_ray ray_at(const view *v, double x, double y) {
    algsurf_ray ray = pixel_ray(&v->camera, v->width, v->height, x, y);
    return ray;
}

/* ---- what is allowed ---- */

/* Distance from the eye to the far side of the extent. */
static double reach_of(const view *v, const algsurf_ray *ray) {
    double far[3];
    for (int i = 0; i < 3; i++) far[i] = fabs(ray->origin[i] - v->extent.centre[i]);
    return fmax(far[0], fmax(far[1], far[2])) * 1.75 + v->radius;
}

static double allowance(const view *v, const algsurf_ray *ray, double t, long double slope,
                        long double bend) {
    long double size = 0, gradient[3] = {0, 0, 0}, x[3], reach = reach_of(v, ray),
                power[3][ALGSURF_MAX_DEGREE + 1];
    for (int i = 0; i < 3; i++) {
        x[i] = ray->origin[i] + (long double)t * ray->direction[i];
        power[i][0] = 1;
        for (int e = 1; e <= v->degree; e++) power[i][e] = power[i][e - 1] * x[i];
    }
    for (int m = 0; m < v->term_count; m++) {
        const algsurf_term *a = v->terms + m;
        size += fabsl(a->a * power[0][a->i] * power[1][a->j] * power[2][a->k]);
        if (a->i) gradient[0] += a->a * a->i * power[0][a->i - 1] * power[1][a->j] * power[2][a->k];
        if (a->j) gradient[1] += a->a * a->j * power[0][a->i] * power[1][a->j - 1] * power[2][a->k];
        if (a->k) gradient[2] += a->a * a->k * power[0][a->i] * power[1][a->j] * power[2][a->k - 1];
    }
    long double steep = fabsl(gradient[0]) + fabsl(gradient[1]) + fabsl(gradient[2]);
    double slopes = v->camera.kind == ALGSURF_CAMERA_ORTHOGRAPHIC
                        ? 0
                        : v->camera.half_height * (1 + (double)v->width / v->height);
    for (int i = 0; i < 3 && v->camera.kind == ALGSURF_CAMERA_ORTHOGRAPHIC; i++)
        reach += fabs(v->camera.eye[i]);
    long double error = S_FACTOR * U * steep * reach * (1 + slopes) + V_FACTOR * U * v->degree * size;
    long double step = B_FACTOR * v->radius;
    return (double)(error / slope + step * step * bend / slope + T_FACTOR * U * t + R_FACTOR * v->radius);
}

static void complain(const view *v, double x, double y, double t, const algsurf_ray *ray,
                     const exact_answer *answer, const char *what) {
    seen.wrong++;
    fprintf(stderr, "view %d (seed %#llx) %s, degree %d: %s at (%g,%g) of %dx%d, rows %d:%d, antialias %d\n",
            v->number, (unsigned long long)v->seed, v->name, v->degree, what, x, y, v->width, v->height,
            v->row_begin, v->row_end, v->antialias);
    fprintf(stderr, "t = %a = %.17g; exact: %d roots, sure %d, clustered %d", t, t, answer->count,
            answer->sure, answer->clustered);
    for (int i = 0; i < answer->count; i++)
        fprintf(stderr, "; %.17g +- %.3g", answer->t[i],
                allowance(v, ray, answer->t[i], answer->slope[i], answer->bend[i]));
    fprintf(stderr, "\nextent %d, orthographic %d, half height %a\n", v->extent.kind,
            (int)(v->camera.kind == ALGSURF_CAMERA_ORTHOGRAPHIC), v->camera.half_height);
    exact_print_doubles("centre", v->extent.centre, 3), exact_print_doubles("size", v->extent.size, 3);
    exact_print_doubles("eye", v->camera.eye, 3), exact_print_doubles("right", v->camera.right, 3);
    exact_print_doubles("up", v->camera.up, 3), exact_print_doubles("forward", v->camera.forward, 3);
    exact_print_doubles("ray origin", ray->origin, 3),
        exact_print_doubles("ray direction", ray->direction, 3);
    for (int i = 0; i < v->term_count && v->term_count < 60; i++)
        fprintf(stderr, "%s{%d, %d, %d, %a}", i ? ", " : "terms = ", v->terms[i].i, v->terms[i].j,
                v->terms[i].k, v->terms[i].a);
    fprintf(stderr, "\n");
}

/* Compares pixel (x, row) with the exact answers for its samples. */
static void check_pixel(const view *v, const drawing *d, int x, int row, int edge) {
    double t = d->hits[(row - v->row_begin) * v->width + x], nearest = INFINITY;
    int n = v->antialias, met = 0, undecided = 0;
    algsurf_ray ray;
    exact_answer answer;
    for (int k = 0; k < n * n; k++) {
        double sx = x + (k % n + 0.5) / n, sy = row + (k / n + 0.5) / n;
        ray = ray_at(v, sx, sy);
        answer = exact_first_root(v->terms, v->term_count, v->degree, &v->extent, &ray,
                                  ROOM * U * reach_of(v, &ray));
        seen.clustered += answer.clustered;
        algsurf_hit hit = first_hit_of(v->surface, &v->extent, &ray, NULL);
        undecided |= hit.state == ALGSURF_STATE_UNDECIDED;
        for (int i = 0; i < answer.count && !isinf(t); i++) {
            double room = allowance(v, &ray, answer.t[i], answer.slope[i], answer.bend[i]);
            double part = fabs(t - answer.t[i]) / room;
            if (part <= 1 || answer.clustered) met = 1;
            if (part <= 1 && part > seen.worst) seen.worst = part;
            if (i == answer.count - 1 && answer.sure) nearest = fmin(nearest, answer.t[i] + room);
        }
        if (isinf(t) && answer.sure) {
            complain(v, sx, sy, t, &ray, &answer, "a miss for a hit");
            return;
        }
        met |= answer.clustered;
    }
    seen.checked++, seen.edges += edge;
    seen.hits += !isinf(t), seen.misses += isinf(t);
    if (isinf(t) || (met && t <= nearest)) return;
    if (undecided) {
        seen.excused++;
        return;
    }
    complain(v, x + 0.5, row + 0.5, t, &ray, &answer, met ? "not the first root" : "no root here");
}

static int is_edge(const view *v, const double *hits, int i) {
    int x = i % v->width, rows = v->row_end - v->row_begin, y = i / v->width, miss = isinf(hits[i]) != 0;
    return (x > 0 && (isinf(hits[i - 1]) != 0) != miss) ||
           (x < v->width - 1 && (isinf(hits[i + 1]) != 0) != miss) ||
           (y > 0 && (isinf(hits[i - v->width]) != 0) != miss) ||
           (y < rows - 1 && (isinf(hits[i + v->width]) != 0) != miss);
}

static void check_drawing(const view *v, const drawing *d, uint64_t *seed) {
    int count = v->width * (v->row_end - v->row_begin), edges[MOST_PIXELS], edge_count = 0;
    char done[MOST_PIXELS] = {0};
    long excused = seen.excused, wrong = seen.wrong;
    for (int i = 0; i < count; i++)
        if (is_edge(v, d->hits, i)) edges[edge_count++] = i;
    int checks = CHECKED / (1 + (v->degree > 10));
    for (int i = 0; i < 2 * checks && seen.wrong == wrong; i++) {
        int edge = i % 2 && edge_count > 0;
        int at = edge ? edges[random_int(seed, edge_count)] : random_int(seed, count);
        if (!done[at]) check_pixel(v, d, at % v->width, v->row_begin + at / v->width, edge);
        done[at] = 1;
    }
    if (seen.excused - excused > (long)d->stats.undecided) {
        seen.wrong++;
        fprintf(stderr, "view %d: %ld pixels without a root, %ld of them undecided\n", v->number,
                seen.excused - excused, (long)d->stats.undecided);
    }
    seen.views++;
    seen.rays += (long)d->stats.rays, seen.single += (long)d->stats.single_rays;
    seen.undecided += (long)d->stats.undecided;
}

/* The same bits from another kernel, and for a part of the rows. */
static void check_same(const view *v, const drawing *d, uint64_t *seed) {
    static drawing other;
    int kernels = 1, count = v->width * (v->row_end - v->row_begin);
    while (algsurf_kernel_name(kernels)) kernels++;
    int skip = random_int(seed, v->row_end - v->row_begin);
    draw(v, algsurf_kernel_name(random_int(seed, kernels)), v->row_begin + skip, &other);
    int from = skip * v->width;
    if (memcmp(other.hits, d->hits + from, (size_t)(count - from) * sizeof *other.hits) ||
        memcmp(other.bytes, d->bytes + 3 * from, 3 * (size_t)(count - from))) {
        seen.wrong++;
        fprintf(stderr, "view %d: other bits from kernel %s with %d rows less\n", v->number,
                other.stats.kernel, skip);
    }
}

/* ---- aiming at silhouettes ---- */

static int hits_at(const view *v, double x, double y) {
    algsurf_ray ray = ray_at(v, x, y);
    algsurf_hit hit = first_hit_of(v->surface, &v->extent, &ray, NULL);
    return hit.state != ALGSURF_STATE_MISS;
}

/* Turns the camera to where the drawing changes from hit to miss, and narrows its view; 0 if there is no such
 * place. */
static int aim_at_edge(view *v, const drawing *d, uint64_t *seed) {
    int count = v->width * (v->row_end - v->row_begin), start = random_int(seed, count), at = -1;
    for (int i = 0; i < count && at < 0; i++) {
        int k = (start + i) % count;
        if (k % v->width < v->width - 1 && (isinf(d->hits[k]) != 0) != (isinf(d->hits[k + 1]) != 0)) at = k;
    }
    if (at < 0) return 0;
    double left = at % v->width + 0.5, right = left + 1, y = v->row_begin + at / v->width + 0.5, zoom,
           place[3], far = 0;
    int state = hits_at(v, left, y);
    for (int i = 0; i < 45; i++) {
        double middle = 0.5 * (left + right);
        if (hits_at(v, middle, y) == state)
            left = middle;
        else
            right = middle;
    }
    algsurf_ray ray = ray_at(v, left, y);
    for (int i = 0; i < 3; i++) far += ray.direction[i] * (v->extent.centre[i] - ray.origin[i]);
    if (!(far > 0)) far = v->radius;
    for (int i = 0; i < 3; i++) place[i] = ray.origin[i] + far * ray.direction[i];
    zoom = ldexp(v->camera.half_height, -random_int(seed, 44));
    if (v->camera.kind == ALGSURF_CAMERA_ORTHOGRAPHIC) {
        aim_parallel(v, ray.origin, place, 2 * zoom, seed);
    } else {
        aim(v, ray.origin, place, 1, seed);
        v->camera.half_height = zoom; /* below any angle that degrees can tell */
    }
    return 1;
}

TEST(test_extreme_views) {
    static drawing d;
    for (int number = first_view; number < first_view + view_count; number++) {
        view v = {.number = number, .seed = first_seed + 1000003u * (uint64_t)number};
        uint64_t seed = v.seed;
        int length;
        make_surface(&v, &seed, &length);
        make_extent(&v, length, &seed);
        make_picture(&v, &seed);
        make_camera(&v, &seed);
        for (int look = 0; look < 2; look++) {
            draw(&v, v.kernel, v.row_begin, &d);
            check_drawing(&v, &d, &seed);
            check_same(&v, &d, &seed);
            if (look == 0 && !aim_at_edge(&v, &d, &seed)) break;
        }
    }
    printf("%ld views, %ld rays, %ld single, %ld undecided; %ld pixels checked, %ld edges, %ld hits, %ld "
           "misses, "
           "%ld excused, %ld clustered, %ld wrong; t within %.3g of what is allowed\n",
           seen.views, seen.rays, seen.single, seen.undecided, seen.checked, seen.edges, seen.hits,
           seen.misses, seen.excused, seen.clustered, seen.wrong, seen.worst);
    assert_int_equal(seen.wrong, 0);
    if (view_count < 100) return;
    assert_true(seen.edges > seen.checked / 10);
    assert_true(seen.hits > seen.checked / 5 && seen.misses > seen.checked / 5);
    assert_true(seen.excused < seen.checked / 50);
}

/* ---- places where a bound has to hold to the letter ---- */

/* Every pixel of every row of a picture made by hand. */
static void check_all(view *v) {
    static drawing d;
    long before = seen.wrong;
    if (v->row_end == 0) v->row_end = v->height;
    v->antialias = 1;
    v->radius = v->extent.size[0];
    draw(v, NULL, v->row_begin, &d);
    for (int y = v->row_begin; y < v->row_end; y++)
        for (int x = 0; x < v->width && seen.wrong < before + 2; x++) check_pixel(v, &d, x, y, 0);
    assert_int_equal(seen.wrong, before);
}

/* Rays that pass the extent's edge within the noise of a far camera, across a plane through its centre. */
TEST(test_edge_of_a_far_ball) {
    uint64_t seed = 3;
    for (int turn = 0; turn < 16; turn++) {
        const double origin[3] = {0, 0, 0}, up[3] = {0, 0, 1};
        double d[3], eye[3], far = turn < 4 ? 1e7 : 3e8;
        view v = {.number = turn, .name = "plane", .width = 41, .height = 41};
        unit_vector(d, 3, &seed);
        for (int i = 0; i < 3; i++) eye[i] = far * d[i];
        const algsurf_term terms[] = {{1, 0, 0, d[0]}, {0, 1, 0, d[1]}, {0, 0, 1, d[2]}};
        set_surface(&v, terms, 3);
        v.extent = (algsurf_extent){.kind = ALGSURF_EXTENT_SPHERE, .size = {1}};
        assert_ok(algsurf_camera_pinhole(eye, origin, up, 1, &v.camera));
        const double edge[3] = {v.camera.right[0], v.camera.right[1], v.camera.right[2]};
        assert_ok(algsurf_camera_pinhole(eye, edge, up, 1, &v.camera));
        v.camera.half_height = 2e-8 / far;
        check_all(&v);
    }
}

/* Parallel pictures of extents whose inverse squares leave the range of double. */
TEST(test_tiny_and_huge_parallel) {
    static const double radii[] = {1e-100, 1e-150, 1e-155, 1e-160, 1e150, 1e160};
    for (int turn = 0; turn < 6; turn++) {
        double r = radii[turn], a = ldexp(1, -ilogb(r));
        const double eye[3] = {3 * r, r, 2 * r}, origin[3] = {0, 0, 0}, up[3] = {0, 0, 1};
        const algsurf_term terms[] = {
            {2, 0, 0, a}, {0, 2, 0, a}, {0, 0, 2, a}, {0, 0, 0, -0.25 * r * (a * r)}};
        view v = {.number = turn, .name = "sphere", .width = 11, .height = 11};
        set_surface(&v, terms, 4);
        v.extent = (algsurf_extent){.kind = ALGSURF_EXTENT_SPHERE, .size = {r}};
        assert_ok(algsurf_camera_orthographic(eye, origin, up, 2.2 * r, &v.camera));
        check_all(&v);
    }
}

/* Two planes l = +-e, the middle plane l = 0 containing the eye and the view's axis exactly: the ray differs
 * from the axis by a rounding of its direction, in which P is quadratic: the first derivatives are 0. */
TEST(test_noise_of_second_order) {
    for (int far = 4; far <= 24; far += 4) {
        double a = 46281973, b = nearbyint(sqrt(0x1p52 - a * a)), y = 0x1p-26 * a, z = 0x1p-26 * b;
        double distance = ldexp(1, far);
        view v = {.number = far, .name = "planes", .width = 1, .height = 1};
        v.camera = (algsurf_camera){.eye = {0, y * distance, z * distance},
                                    .right = {1, 0, 0},
                                    .up = {0, -z, y},
                                    .forward = {0, -y, -z},
                                    .half_height = 1e-8};
        algsurf_ray ray = pixel_ray(&v.camera, 1, 1, 0.5, 0.5);
        exact_line l; /* b y - a z along the ray */
        const algsurf_term plane[] = {{0, 1, 0, b}, {0, 0, 1, -a}};
        mpq_t slope;
        mpq_init(slope);
        l = exact_line_of(plane, 2, 1, &ray);
        exact_line_coefficient(slope, &l, 1);
        double e = mpq_get_d(slope) * distance;
        mpq_clear(slope), exact_line_clear(&l);
        const algsurf_term terms[] = {
            {0, 2, 0, b * b}, {0, 1, 1, -2 * a * b}, {0, 0, 2, a * a}, {0, 0, 0, -e * e}};
        assert_true(e != 0);
        set_surface(&v, terms, 4);
        v.extent = (algsurf_extent){.kind = ALGSURF_EXTENT_SPHERE, .size = {1}};
        check_all(&v);
    }
}

/* A root between the computed and the true end of the chord, where the box's face is nearly along the rays:
 * the depths searched together must reach beyond the ends by what these may be off. */
TEST(test_root_at_a_slanted_face) {
    const algsurf_term terms[] = {{0, 0, 3, 1}, {1, 0, 1, 1}, {0, 1, 0, 1}};
    view v = {.name = "cusp", .width = 13, .height = 20, .row_begin = 6, .row_end = 13};
    set_surface(&v, terms, 3);
    v.extent = (algsurf_extent){ALGSURF_EXTENT_BOX,
                                {0x1.a0765bc8d7342p1, -0x1.4bf04a412c368p1, 0x1.637018f10035ap-1},
                                {0x1.08a9f16384d7ep-14, 0x1.ae5a5eb16cedap-16, 0x1.d6a1c5517618cp-15}};
    v.camera = (algsurf_camera){.eye = {0x1.a0752631e8115p1, -0x1.4bf0bf39a2b15p1, 0x1.708de26435c3cp0},
                                .right = {1, 0, 0},
                                .up = {0, 0x1.fffffff3e1fd2p-1, 0x1.bd90cc88a5c0fp-15},
                                .forward = {0, 0x1.bd90cc88a5c0fp-15, -0x1.fffffff3e1fd2p-1},
                                .half_height = 0x1.84a2c912dfcedp-50,
                                .kind = ALGSURF_CAMERA_ORTHOGRAPHIC};
    check_all(&v);
}

/* A surface of high degree in an extent that is large beside what happens at its origin. */
TEST(test_depths_in_a_large_ball) {
    const double eye[3] = {73.6, -67.2, 54.4}, origin[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    for (int n = 8; n <= 16; n += 2) {
        static algsurf_term terms[2000];
        uint64_t seed = 5;
        int count = 0;
        view v = {.number = n, .name = "dense", .width = 160, .height = 120, .row_begin = 58, .row_end = 62};
        add_dense(terms, &count, n, &seed);
        set_surface(&v, terms, count);
        v.extent = (algsurf_extent){.kind = ALGSURF_EXTENT_SPHERE, .size = {32}};
        assert_ok(algsurf_camera_pinhole(eye, origin, up, 34, &v.camera));
        check_all(&v);
    }
}

/* ---- extents of any size, in the certified tier ---- */

/* Planes, or a paraboloid, of a size of 2^length; P's own size is about 1 there. */
static void set_wide_surface(view *v, int length, int planes, uint64_t *seed) {
    algsurf_term terms[8];
    int count = 0;
    for (int axis = 0; axis < 3; axis++)
        terms[count++] = (algsurf_term){axis == 0, axis == 1, axis == 2, random_unit(seed)};
    terms[count++] = (algsurf_term){0, 0, 0, 0.4 * random_unit(seed)};
    if (!planes) terms[count++] = (algsurf_term){2, 0, 0, 1}, terms[count++] = (algsurf_term){0, 2, 0, 1};
    for (int i = 0; i < count; i++) {
        int power = terms[i].i + terms[i].j + terms[i].k;
        terms[i].a = ldexp(terms[i].a, (1 - power) * length);
    }
    set_surface(v, terms, count);
}

static void aim_at_wide_extent(view *v, uint64_t *seed) {
    double eye[3], d[3], far = random_int(seed, 3) ? 3 : 0.5;
    const double *at = v->extent.centre;
    unit_vector(d, 3, seed);
    for (int i = 0; i < 3; i++) eye[i] = at[i] + far * v->radius * d[i];
    if (random_int(seed, 2))
        aim_parallel(v, eye, at, 2.1 * v->radius, seed);
    else
        aim(v, eye, at, far > 1 ? 0.35 : 1, seed);
}

/* A pixel against integers, and against a single ray in the same tier; returns 1 if that is undecided.  Of
 * extents so large that sums of t overflow only the state is looked at. */
static int check_certified_pixel(const view *v, const drawing *d, int x, int y) {
    const algsurf_intersect_options how = {.size = sizeof how, .tier = v->tier};
    double t = d->hits[y * v->width + x];
    algsurf_ray ray = ray_at(v, x + 0.5, y + 0.5);
    exact_answer answer =
        exact_first_root(v->terms, v->term_count, v->degree, &v->extent, &ray, ROOM * U * reach_of(v, &ray));
    int met = v->radius > 0x1p1016, state = isinf(t) ? ALGSURF_STATE_MISS : ALGSURF_STATE_HIT;
    algsurf_hit hit = first_hit_of(v->surface, &v->extent, &ray, &how);
    for (int i = 0; i < answer.count; i++) met |= fabs(t - answer.t[i]) <= 0x1p-36 * v->radius + 0x1p-40 * t;
    seen.checked++, seen.hits += state == ALGSURF_STATE_HIT, seen.misses += state == ALGSURF_STATE_MISS;
    if (hit.state == ALGSURF_STATE_UNDECIDED) return 1;
    if (state != hit.state) complain(v, x + 0.5, y + 0.5, t, &ray, &answer, "not what the single ray says");
    if (state == ALGSURF_STATE_MISS && answer.sure) complain(v, x, y, t, &ray, &answer, "a miss for a hit");
    if (state == ALGSURF_STATE_HIT && !met) complain(v, x, y, t, &ray, &answer, "not the first root");
    return 0;
}

/* Extents from 2^-1000 to 2^1020, about the origin or beside it, of surfaces as large, or of a size of 1. */
TEST(test_wide_extents) {
    static const int sizes[] = {-1000, -997, -505, -300, 0, 300, 499, 505, 900, 997, 1005, 1015, 1020};
    enum { SIZES = sizeof sizes / sizeof *sizes, TURNS = 12 };
    static drawing d;
    long wrong = seen.wrong, hits = seen.hits, misses = seen.misses, undecided = 0;
    uint64_t seed = 11;
    for (int turn = 0; turn < SIZES * TURNS; turn++) {
        int size = sizes[turn % SIZES], kind = turn / SIZES, box = kind % 2, aside = kind / 2 % 2;
        view v = {.number = turn, .name = "wide", .width = 14, .height = 10, .row_end = 10, .antialias = 1};
        v.tier = ALGSURF_TIER_CERTIFIED;
        v.extent.kind = box ? ALGSURF_EXTENT_BOX : ALGSURF_EXTENT_SPHERE;
        for (int i = 0; i < 3; i++) {
            v.extent.size[i] = ldexp(1 + 0.2 * i, size);
            v.extent.centre[i] = aside ? ldexp(random_unit(&seed), size) : 0;
        }
        v.radius = (box ? 2.1 : 1) * v.extent.size[0];
        set_wide_surface(&v, kind < 8 ? size : 0, kind % 3 || abs(size) > 500, &seed);
        aim_at_wide_extent(&v, &seed);
        draw(&v, NULL, 0, &d);
        int open = 0;
        for (int i = 0; i < v.width * v.height && seen.wrong < wrong + 3; i++)
            open += check_certified_pixel(&v, &d, i % v.width, i / v.width);
        undecided += open;
        if (open > (int)d.stats.undecided) fail_msg("%d undecided, %d told", open, (int)d.stats.undecided);
    }
    assert_int_equal(seen.wrong, wrong);
    hits = seen.hits - hits, misses = seen.misses - misses;
    if (hits < 2000 || misses < 2000 || undecided * 100 > hits)
        fail_msg("%ld hits, %ld misses, %ld undecided", hits, misses, undecided);
}
