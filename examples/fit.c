/* fit.c - see fit.h.
 *
 * The extent is that of fit_extent.h.  The camera is placed by what a coarse picture shows, thin things among
 * it where they are drawn: moved sideways until that is in the middle, and along the view until it fills 90
 * per cent of the height or 95 of the width.  It stays out of the extent; to show what is small in there the
 * field of view is narrowed.  What is seen edge-on from the usual side is seen from another one.  What a
 * coarse picture would miss in a given extent is found by a proof first, and aimed at.
 */
#include "fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fit_extent.h"

static const double LONELY = 0.6; /* of the extent: no sheet reaches its end */
static const double AROUND = 1.2; /* about what is seen then */

/* ---- camera ---- */

enum { ROWS = 144, LEAST_ROWS = 24, MOST_COLUMNS = 512, ROUNDS = 8, FEW_ROUNDS = 4, DOT = 6, PROBES = 32 };
enum { THIN_DEGREE = 6 }; /* above it what is thin is looked for only where nothing else is seen */
enum { QUICK = 12 };      /* degree: above it rays take more time, and fewer are asked */
static const double MOST_PROBING = 0x1p22;    /* operations a glance */
static const double HIGH = 0.90, WIDE = 0.95; /* of the picture */
static const double CLOSE = 1.3;              /* radii of the extent, from its centre to the eye */
static const double SMALL = 0.1;              /* of the extent: aimed at */
static const double EDGE_ON = 0.3;            /* a cosine */
static const double PI = 3.14159265358979323846;

static const double any_colour[3] = {1, 1, 1};

/* A coarse picture, as large as the real one seen from farther away. */
typedef struct glance {
    int width, height;
    const algsurf_surface *surface;
    const algsurf_extent *extent;
    algsurf_scene *scene;
    int thin; /* 1: what is thin is looked for where nothing else is */
    unsigned char *state;
    double *t;
    algsurf_status *failed;
} glance;

static glance open_glance(const view_options *options, const algsurf_surface *surface,
                          const algsurf_extent *extent, int thin, algsurf_status *failed) {
    const algsurf_intersect_options doubles = {.size = sizeof doubles, .tier = ALGSURF_TIER_BOUNDED};
    const int degree = algsurf_surface_degree(surface), few = degree > QUICK ? ROWS * QUICK / degree : ROWS;
    const int rows = few > LEAST_ROWS ? few : LEAST_ROWS;
    const double most = (double)MOST_COLUMNS * rows / ROWS;
    glance g = {.height = rows, .surface = surface, .extent = extent, .failed = failed};
    g.width = (int)fmin(most, fmax(1, round((double)rows * options->width / options->height)));
    g.state = malloc((size_t)g.width * (size_t)rows);
    g.t = malloc((size_t)g.width * (size_t)rows * sizeof *g.t);
    if (!g.state || !g.t) fit_demand(failed, ALGSURF_E_NO_MEMORY);
    fit_demand(failed, algsurf_scene_create(surface, &g.scene));
    fit_demand(failed, algsurf_scene_set_extent(g.scene, extent));
    fit_demand(failed, algsurf_scene_set_intersect_options(g.scene, &doubles));
    g.thin = thin && degree > THIN_DEGREE;
    fit_demand(failed, algsurf_scene_set_thin(g.scene, thin && !g.thin ? any_colour : NULL));
    return g;
}

static void close_glance(glance *g) {
    algsurf_scene_free(g->scene);
    free(g->state);
    free(g->t);
}

/* Does P change its sign on the ray, or come so near to zero that doubles cannot tell, at some point of many?
 * Then *t is there. */
static int is_met(const glance *g, const algsurf_ray *ray, double *t) {
    algsurf_ray chord;
    int meets = 0, before = 0;
    fit_demand(g->failed, algsurf_ray_clip(ray, g->extent, NULL, 0, &chord, &meets));
    for (int i = 0; i <= PROBES && meets && *g->failed == ALGSURF_OK; i++) {
        double x[3], value, bound;
        *t = chord.t_min + (chord.t_max - chord.t_min) * i / PROBES;
        for (int k = 0; k < 3; k++) x[k] = ray->origin[k] + *t * ray->direction[k];
        if (algsurf_surface_value(g->surface, x, &value, &bound) != ALGSURF_OK) continue;
        const int sign = value > bound ? 1 : value < -bound ? -1 : 0;
        if (sign == 0 || sign * before < 0) return 1;
        before = sign;
    }
    return 0;
}

/* What doubles have left undecided is met by probes, as far as these are worth their time, or it is not. */
static void probe(const glance *g, const algsurf_camera *camera) {
    const int n = algsurf_surface_degree(g->surface);
    const double work = PROBES * ((double)algsurf_surface_term_count(g->surface) + 2 * n + 100);
    double left = MOST_PROBING;
    for (int i = 0; i < g->width * g->height && *g->failed == ALGSURF_OK && left > 0; i++) {
        algsurf_ray ray;
        if (g->state[i] != ALGSURF_STATE_UNDECIDED) continue;
        fit_demand(g->failed, algsurf_camera_ray(camera, g->width, g->height, i % g->width + 0.5,
                                                 i / g->width + 0.5, &ray));
        g->state[i] = is_met(g, &ray, &g->t[i]) ? ALGSURF_STATE_HIT : ALGSURF_STATE_MISS;
        left -= work;
    }
}

static int look(glance *g, const algsurf_camera *camera, int rectangle[4], int *dot);

/* Only now: it takes time. */
static int look_for_thin(glance *g, const algsurf_camera *camera, int rectangle[4], int *dot) {
    if (!g->thin) return 0;
    g->thin = 0;
    fit_demand(g->failed, algsurf_scene_set_thin(g->scene, any_colour));
    return look(g, camera, rectangle, dot);
}

/* The rectangle about what is seen, in pixels; 0: nothing is.  dot: it is tiny, and no ray meets it. */
static int look(glance *g, const algsurf_camera *camera, int rectangle[4], int *dot) {
    const algsurf_render_options size = {.size = sizeof size, .width = g->width, .height = g->height};
    const algsurf_picture planes = {.size = sizeof planes, .state = g->state, .t = g->t};
    int left = g->width, right = 0, top = g->height, bottom = 0, met = 0;
    fit_demand(g->failed, algsurf_scene_set_camera(g->scene, camera));
    fit_demand(g->failed, algsurf_render(g->scene, &size, &planes, NULL));
    if (*g->failed == ALGSURF_OK) probe(g, camera);
    if (*g->failed != ALGSURF_OK) return 0;
    for (int y = 0; y < g->height; y++)
        for (int x = 0; x < g->width; x++) {
            if (g->state[y * g->width + x] == ALGSURF_STATE_MISS) continue;
            met |= g->state[y * g->width + x] != ALGSURF_STATE_THIN;
            left = x < left ? x : left, right = x + 1 > right ? x + 1 : right;
            top = y < top ? y : top, bottom = y + 1;
        }
    const int found[4] = {left, right, top, bottom};
    memcpy(rectangle, found, sizeof found);
    *dot = !met && right - left <= DOT && bottom - top <= DOT;
    return bottom > 0 || look_for_thin(g, camera, rectangle, dot);
}

/* The distance from the extent's centre of the farthest point that a ray meets. */
static double reach_of(const glance *g, const algsurf_camera *camera, const double centre[3]) {
    double reach = 0;
    for (int i = 0; i < g->width * g->height && *g->failed == ALGSURF_OK; i++) {
        algsurf_ray ray = {.t_max = 0};
        double square = 0;
        if (g->state[i] == ALGSURF_STATE_MISS || g->state[i] == ALGSURF_STATE_THIN) continue;
        fit_demand(g->failed, algsurf_camera_ray(camera, g->width, g->height, i % g->width + 0.5,
                                                 i / g->width + 0.5, &ray));
        for (int k = 0; k < 3; k++) {
            double away = ray.origin[k] + g->t[i] * ray.direction[k] - centre[k];
            square += away * away;
        }
        reach = fmax(reach, sqrt(square));
    }
    return reach;
}

static double length(const double v[3]) { return hypot(hypot(v[0], v[1]), v[2]); }

/* The eye, for a view of that half height at the point looked at, by `back` away from it or, if that is too
 * close to the extent, farther. */
static void set_eye(view *v, const double back[3], double half, double radius) {
    double from_centre[3], distance = length(back);
    for (int i = 0; i < 3; i++) {
        v->eye[i] = v->look_at[i] + back[i];
        from_centre[i] = v->eye[i] - v->extent.centre[i];
    }
    double step = fmax(0, CLOSE * radius - length(from_centre));
    for (int i = 0; i < 3; i++) v->eye[i] += step * back[i] / distance;
    v->fov = 360 / PI * atan(half / (distance + step));
}

/* Looks at what is small in the extent. */
static void aim(view *v, const algsurf_surface *surface, double radius, algsurf_status *failed) {
    const fit_box all = fit_enclose(surface, &v->extent, ALGSURF_PART_ALL, failed);
    double back[3], middle[3], half = all.empty ? 0 : sqrt(3) * fit_half_edge(&all, middle);
    if (!(half > 0 && half < SMALL * radius)) return;
    for (int i = 0; i < 3; i++) {
        back[i] = v->eye[i] - v->look_at[i];
        v->look_at[i] = middle[i];
    }
    set_eye(v, back, half < FIT_POINT * radius ? SMALL * radius : half, radius);
}

/* Moves the view once towards what fills the picture, or has a dot in its middle; 0 when it is there, or
 * nothing is seen. */
static int move(glance *g, view *v, double radius) {
    algsurf_camera camera;
    int seen[4], dot = 0;
    double back[3];
    fit_demand(g->failed, view_make_camera(v, 0, 1, &camera));
    if (*g->failed != ALGSURF_OK || !look(g, &camera, seen, &dot)) return 0;
    for (int i = 0; i < 3; i++) back[i] = v->eye[i] - v->look_at[i];
    double half = camera.half_height * length(back), pixel = 2 * half / g->height;
    double aside = 0.5 * (seen[0] + seen[1] - g->width), down = 0.5 * (seen[2] + seen[3] - g->height);
    double high = (seen[3] - seen[2]) / (HIGH * g->height), wide = (seen[1] - seen[0]) / (WIDE * g->width);
    double times = dot ? 1 : fmax(high, wide);
    for (int i = 0; i < 3; i++) {
        v->look_at[i] += pixel * (aside * camera.right[i] - down * camera.up[i]);
        back[i] *= times;
    }
    set_eye(v, back, times * half, radius);
    return fabs(times - 1) > fmax(0.01, 1.0 / g->height) || fabs(aside) > 1 || fabs(down) > 1;
}

/* All numbers as they will be told; what is up has changed when the view was turned. */
static void round_camera(view *v, int turned) {
    double back[3];
    for (int i = 0; i < 3; i++) back[i] = v->eye[i] - v->look_at[i];
    double distance = length(back), half = distance * tan(v->fov * PI / 360);
    for (int i = 0; i < 3; i++) {
        v->eye[i] = fit_rounded_place(v->eye[i], distance / 10);
        v->look_at[i] = fit_rounded_place(v->look_at[i], fmin(half, distance / 10));
    }
    v->fov = fit_rounded_place(v->fov, v->fov / 10);
    double size = length(v->up);
    for (int i = 0; i < 3 && turned; i++) v->up[i] = fit_rounded_place(v->up[i], size / 100);
}

/* ---- both ---- */

/* How much what is seen faces the eye: the mean of |normal . direction|, 1 if nothing is seen. */
static double facing(const glance *g, const view *v) {
    const size_t count = (size_t)g->width * (size_t)g->height;
    const algsurf_render_options size = {.size = sizeof size, .width = g->width, .height = g->height};
    float *normal = malloc(3 * count * sizeof *normal);
    const algsurf_picture planes = {.size = sizeof planes, .state = g->state, .normals = normal};
    algsurf_camera camera;
    double sum = 0, hits = 0;
    if (!normal) fit_demand(g->failed, ALGSURF_E_NO_MEMORY);
    fit_demand(g->failed, view_make_camera(v, 0, 1, &camera));
    if (*g->failed == ALGSURF_OK) fit_demand(g->failed, algsurf_scene_set_camera(g->scene, &camera));
    if (*g->failed == ALGSURF_OK) fit_demand(g->failed, algsurf_render(g->scene, &size, &planes, NULL));
    for (size_t i = 0; i < count && *g->failed == ALGSURF_OK; i++) {
        if (g->state[i] != ALGSURF_STATE_HIT) continue;
        double along = 0;
        for (size_t k = 0; k < 3; k++) along += normal[3 * i + k] * camera.forward[k];
        sum += fabs(along), hits++;
    }
    free(normal);
    return hits > 0 ? sum / hits : 1;
}

/* What is seen edge-on is looked at from another of four sides. */
static void face(const glance *g, view *v) {
    static const double side[3][2] = {{1, -1}, {-1, -1}, {-1, 1}};
    view usual = *v;
    double best = facing(g, v);
    if (best > EDGE_ON) return;
    for (int i = 0; i < 3; i++) {
        view other = usual;
        for (int k = 0; k < 2; k++)
            other.eye[k] = usual.look_at[k] + side[i][k] * (usual.eye[k] - usual.look_at[k]);
        const double better = facing(g, &other);
        if (better > best) best = better, *v = other;
    }
}

/* Where the camera stands at first. */
static void stand_off(view *v, const view_options *options) {
    view_options with_extent = *options;
    with_extent.extent = (cli_extent){v->extent, 1};
    with_extent.centre.given = 1;
    memcpy(with_extent.centre.x, v->extent.centre, sizeof with_extent.centre.x);
    *v = view_make(&with_extent, NULL);
}

/* Fits the camera; returns how far what is seen reaches from the extent's centre. */
static double fit_camera(view *v, const view_options *options, const algsurf_surface *surface, int thin,
                         algsurf_status *failed) {
    const algsurf_extent *extent = &v->extent;
    double radius = extent->kind == ALGSURF_EXTENT_BOX ? length(extent->size) : extent->size[0], reach = 0;
    glance g = open_glance(options, surface, extent, thin, failed);
    algsurf_camera camera;
    if (options->turn[0] == 0 && options->turn[1] == 0 && algsurf_surface_degree(surface) <= QUICK)
        face(&g, v);
    if (options->extent.given || options->centre.given) aim(v, surface, radius, failed);
    const int rounds = algsurf_surface_degree(surface) > 2 * QUICK ? FEW_ROUNDS : ROUNDS;
    for (int round = 0; round < rounds && *failed == ALGSURF_OK && move(&g, v, radius); round++) {
    }
    fit_demand(failed, view_make_camera(v, 0, 1, &camera));
    if (*failed == ALGSURF_OK) reach = reach_of(&g, &camera, extent->centre);
    close_glance(&g);
    return reach;
}

algsurf_status fit_choose(view *v, const view_options *asked, const algsurf_surface *surface, int extent_only,
                          int thin, fit_choice *choice) {
    view_options usual = *asked; /* what magnifies does so afterwards */
    const view_options *options = &usual;
    algsurf_status failed = ALGSURF_OK;
    usual.fov = usual.zoom = 0;
    *v = view_make(options, NULL);
    int choose_extent = !options->extent.given && !options->centre.given, bounded = 1;
    int choose_camera =
        !options->eye.given && !options->look_at.given && !(options->orthographic > 0) && !extent_only;
    if (choose_extent) {
        v->extent = fit_extent(surface, &bounded, &failed);
        stand_off(v, options);
    }
    double fov = v->fov;
    int turned = options->turn[0] != 0 || options->turn[1] != 0;
    if (choose_camera) {
        double reach = fit_camera(v, options, surface, thin, &failed);
        if (!bounded && reach > 0 && reach < LONELY * v->extent.size[0]) { /* all that goes on are lines */
            v->extent.size[0] = fit_rounded_up(AROUND * reach);
            stand_off(v, options);
            (void)fit_camera(v, options, surface, 0, &failed);
        }
        round_camera(v, turned);
    }
    *choice = (fit_choice){.extent = choose_extent,
                           .camera = choose_camera,
                           .narrowed = v->fov != fov && !(asked->fov > 0),
                           .turned = turned,
                           .bounded = bounded,
                           .fov = v->fov};
    if (asked->fov > 0) v->fov = asked->fov;
    view_zoom(v, asked->zoom);
    return failed;
}
