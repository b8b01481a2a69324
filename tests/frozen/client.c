/* client.c - a program of release 1.0, kept: compiled with the headers beside it, linked against the symbols
 * of algsurf.map beside it, and run against the shared library of today (check_frozen).
 *
 * Each struct that starts with its size ends where the readable memory ends, and its padding is filled with
 * ones: a library that reads or writes beyond a caller's size, or puts a new member where released ones had
 * padding, fails here.  The answers checked are exact ones, which no later version may change. */
#define _DEFAULT_SOURCE
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "algsurf/algsurf.h"

static int failures;

#define CHECK(condition)                                                                                     \
    do {                                                                                                     \
        if (condition) break;                                                                                \
        fprintf(stderr, "client.c:%d: %s\n", __LINE__, #condition);                                          \
        failures++;                                                                                          \
    } while (0)

static int near(double a, double b) { return fabs(a - b) <= 1e-6; }

/* The first `size` bytes of a struct, its own size set to that, at the end of the readable memory. */
static void *at_edge(const void *whole, size_t size) {
    size_t page = (size_t)sysconf(_SC_PAGESIZE);
    char *room = mmap(NULL, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED || mprotect(room + page, page, PROT_NONE) != 0) _exit(1);
    char *at = room + page - size;
    memcpy(at, whole, size);
    memcpy(at, &size, sizeof size);
    return at;
}

/* A struct to be filled in member by member; what is not a member stays ones. */
#define BLANK(type, name)                                                                                    \
    type name;                                                                                               \
    memset(&name, 0xff, sizeof name)

static algsurf_surface *sphere(void) {
    algsurf_surface *surface = NULL;
    algsurf_parse_error error = {0, 0, NULL};
    const algsurf_constant r = {"r", 1};
    CHECK(algsurf_surface_from_equation("x^2 + y^2 + z^2 = r^2", &r, 1, &surface, &error) == ALGSURF_OK);
    CHECK(algsurf_surface_degree(surface) == 2 && algsurf_surface_term_count(surface) == 4);
    return surface;
}

static const algsurf_ray along_x = {{-4, 0, 0}, {1, 0, 0}, 0, INFINITY};

static void check_values(const algsurf_surface *s) {
    const algsurf_term terms[] = {{2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 2, 1}, {0, 0, 0, -1}};
    const double point[3] = {2, 0, 0};
    double value = 0, bound = 1;
    algsurf_surface *same = NULL;
    CHECK(strncmp(algsurf_version(), "1.", 2) == 0 && ALGSURF_VERSION_MAJOR == 1);
    CHECK(algsurf_version_number() >= ALGSURF_VERSION && algsurf_version_number() < 20000);
    CHECK(strcmp(algsurf_status_name(ALGSURF_E_SYNTAX), "ALGSURF_E_SYNTAX") == 0);
    CHECK(algsurf_surface_from_terms(terms, 4, &same) == ALGSURF_OK);
    CHECK(algsurf_surface_value(s, point, &value, &bound) == ALGSURF_OK && near(value, 3));
    CHECK(algsurf_surface_value(same, point, &value, &bound) == ALGSURF_OK && near(value, 3));
    algsurf_surface_free(same);
    CHECK(algsurf_interval_contains(algsurf_interval_sub((algsurf_interval){1, 2}, (algsurf_interval){1, 1}),
                                    1));
}

static void check_rays(const algsurf_surface *s) {
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}};
    const algsurf_plane plane = {{1, 0, 0}, 1}; /* through the second hit */
    BLANK(algsurf_intersect_options, o);
    o.tier = ALGSURF_TIER_CERTIFIED, o.method = ALGSURF_METHOD_BRENT, o.max_iterations = 200;
    o.absolute_tolerance = 1e-9, o.kernel = NULL, o.undecided_as = ALGSURF_AS_HIT, o.max_memory = 1 << 20;
    o.observer = NULL, o.planes = &plane, o.plane_count = 1, o.side = 0;
    {
        algsurf_hit hit, hits[2];
        int state = ALGSURF_STATE_MISS;
        int count = 0;
        const algsurf_intersect_options *options = at_edge(&o, sizeof o);
        CHECK(algsurf_intersect_first(s, &extent, &along_x, options, &hit) == ALGSURF_OK);
        CHECK(hit.state == ALGSURF_STATE_HIT && hit.reason == ALGSURF_OK && near(hit.t, 3) &&
              near(hit.normal[0], -1));
        CHECK(hit.multiplicity == 1 && hit.side == 1);
        CHECK(hit.t_lo <= 3 && 3 <= hit.t_hi && near(hit.position[0], -1));
        CHECK(algsurf_intersect_all(s, NULL, &along_x, options, hits, 2, &count) == ALGSURF_OK);
        CHECK(count == 2 && near(hits[0].t, 3) && near(hits[1].t, 5));
        CHECK(algsurf_occluded(s, NULL, &along_x, options, &state) == ALGSURF_OK && state == ALGSURF_STATE_HIT);
    }
}

static void check_packets(const algsurf_surface *s) {
    const double ox[] = {-4, -4}, oy[] = {0, 3}, oz[] = {0, 0}, dx[] = {1, 1}, dy[] = {0, 0}, dz[] = {0, 0};
    const double near_end[] = {0, 0}, far_end[] = {INFINITY, INFINITY};
    const unsigned char active[] = {1, 1};
    unsigned char state[2];
    double t[2], t_lo[2], t_hi[2], position[3][2], normal[3][2];
    int multiplicity[2];
    signed char side[2];
    BLANK(algsurf_ray_packet, rays);
    BLANK(algsurf_hit_packet, hits);
    rays.count = 2, rays.t_min = near_end, rays.t_max = far_end, rays.active = active, rays.step = 1;
    rays.float_t_min = rays.float_t_max = NULL;
    for (int i = 0; i < 3; i++) rays.float_origin[i] = rays.float_direction[i] = NULL;
    rays.origin[0] = ox, rays.origin[1] = oy, rays.origin[2] = oz;
    rays.direction[0] = dx, rays.direction[1] = dy, rays.direction[2] = dz;
    hits.state = state, hits.t = t, hits.t_lo = t_lo, hits.t_hi = t_hi;
    hits.multiplicity = multiplicity, hits.side = side, hits.reason = NULL;
    for (int i = 0; i < 3; i++) hits.position[i] = position[i], hits.normal[i] = normal[i];
    {
        const algsurf_ray_packet *given = at_edge(&rays, sizeof rays);
        memset(state, 9, sizeof state);
        CHECK(algsurf_intersect_packet(
                  s, NULL, given, NULL,
                  &(algsurf_hit_packet){
                      .size = sizeof hits, .state = state, .t = t, .t_lo = t_lo, .t_hi = t_hi}) ==
              ALGSURF_OK);
        CHECK(state[0] == ALGSURF_STATE_HIT && state[1] == ALGSURF_STATE_MISS && near(t[0], 3));
        CHECK(algsurf_occluded_packet(s, NULL, given, NULL, state) == ALGSURF_OK && state[0] == ALGSURF_STATE_HIT);
    }
    rays.size = sizeof rays;
    {
        memset(state, 9, sizeof state);
        memset(normal, 0, sizeof normal), memset(side, 0, sizeof side);
        CHECK(algsurf_intersect_packet(s, NULL, &rays, NULL, at_edge(&hits, sizeof hits)) == ALGSURF_OK);
        CHECK(state[0] == ALGSURF_STATE_HIT && state[1] == ALGSURF_STATE_MISS);
        CHECK(near(normal[0][0], -1));
        CHECK(side[0] == 1);
    }
}

static void check_complex(const algsurf_surface *s) {
    const double none[3] = {0, 0, 0};
    BLANK(algsurf_complex_space, space);
    space.sector = (algsurf_sector){0, 1e-10};
    space.imaginary = none, space.imaginary_count = 3;
    {
        algsurf_hit hit;
        algsurf_complex root;
        CHECK(algsurf_intersect_complex(s, NULL, &along_x, at_edge(&space, sizeof space), NULL, NULL, &hit,
                                        &root) == ALGSURF_OK);
        CHECK(hit.state == ALGSURF_STATE_HIT && near(root.re, 3) && near(root.im, 0));
    }
}

static void check_roots(void) {
    const double c[] = {-2, 0, 1}; /* t^2 - 2 */
    const algsurf_complex p[] = {{-2, 0}, {0, 0}, {1, 0}}, start[] = {{1, 1}, {1, -1}};
    algsurf_complex_root roots[2];
    algsurf_bracket bracket;
    int count = 0, found = 0;
    CHECK(algsurf_complex_roots_of_real(c, NULL, 2, roots, &count) == ALGSURF_OK && count == 2);
    CHECK(roots[0].multiplicity == 1 && roots[0].real == 1 && near(fabs(roots[0].root.re), sqrt(2)));
    BLANK(algsurf_isolate_options, isolate);
    BLANK(algsurf_observer, observer);
    observer.size = sizeof observer, observer.data = NULL, observer.on_cell = NULL, observer.on_point = NULL;
    observer.cells = observer.evaluations = 0, observer.engine = ALGSURF_ENGINE_NONE;
    isolate.observer = at_edge(&observer, sizeof observer);
    CHECK(algsurf_isolate_first(c, NULL, 2, 0, 2, at_edge(&isolate, sizeof isolate), &bracket, &found) ==
              ALGSURF_OK &&
          found == 1);
    CHECK(isolate.observer->cells == 1 && isolate.observer->engine == ALGSURF_ENGINE_DOUBLES);
    CHECK(bracket.lo <= sqrt(2) && sqrt(2) <= bracket.hi && bracket.sign == -1);

    BLANK(algsurf_refine_options, r);
    r.method = ALGSURF_METHOD_BISECTION, r.max_iterations = 100, r.absolute_tolerance = 1e-9;
    r.observer = NULL;
    {
        algsurf_refined_root root;
        CHECK(algsurf_refine_poly(c, NULL, 2, 1, 2, at_edge(&r, sizeof r), &root) == ALGSURF_OK);
        CHECK(near(root.root, sqrt(2)) && root.converged == 1);
    }
    BLANK(algsurf_paper_options, z);
    z.relative_step = 1e-10, z.max_steps = 60, z.max_inflations = 12;
    {
        algsurf_paper_zero zeros[2];
        int complete = 0;
        CHECK(algsurf_paper_zeros(p, NULL, 2, start, at_edge(&z, sizeof z), zeros, &complete) == ALGSURF_OK);
        CHECK(complete == 1 && near(zeros[0].root.re + zeros[1].root.re, 0));
        CHECK(zeros[0].verified == 1 && zeros[1].verified == 1);
    }
}

static void check_many(void) {
    const double c[2][3] = {{-2, 0, 1}, {2, 0, 1}}, lo = 0, hi = 2;
    BLANK(algsurf_real_batch, packet);
    BLANK(algsurf_batch_options, o);
    packet.count = 2, packet.degree = 2, packet.coefficients.at = c[0], packet.coefficients.power = 1;
    packet.coefficients.polynomial = 3, packet.radii.at = NULL, packet.lo = &lo, packet.hi = &hi;
    packet.interval_step = 0;
    o.kernel = NULL, o.relative_tolerance = 0;
    {
        unsigned char state[2];
        double root[2];
        CHECK(algsurf_first_roots_batch(at_edge(&packet, sizeof packet), at_edge(&o, sizeof o), state,
                                        root) == ALGSURF_OK);
        CHECK(state[0] == ALGSURF_FIRST_ROOT_FOUND && near(root[0], sqrt(2)));
        CHECK(state[1] == ALGSURF_FIRST_ROOT_NONE && isinf(root[1]));
    }
}

static int count_rows(int rows_done, int rows_total, void *data) {
    *(int *)data = rows_done;
    return rows_done > rows_total;
}

static void check_picture(const algsurf_surface *s) {
    enum { W = 16, H = 12, MIDDLE = W * H / 2 + W / 2 };
    static unsigned char pixels[3 * W * H], state[W * H], way[W * H];
    static double t[W * H];
    static float normals[3 * W * H];
    const double eye[3] = {0, 0, 4}, look_at[3] = {0, 0, 0}, up[3] = {0, 1, 0}, black[3] = {0, 0, 0};
    const algsurf_extent extent = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {2, 2, 2}};
    const algsurf_material matt = {sizeof matt, {1, 0, 0}, {0, 1, 0}, 0.8, 0.2, 0, 0, 1, 0};
    const algsurf_light light = {{0, 0, 9}, {1, 1, 1}, {1, 0, 0}, {0, 1, 0}, 2, 2, ALGSURF_LIGHT_AREA, {0}};
    const algsurf_plane lower_half = {{0, 0, 1}, 0};
    algsurf_scene *scene = NULL;
    algsurf_camera camera;
    int rows = 0;
    CHECK(algsurf_camera_orthographic(eye, look_at, up, 3, &camera) == ALGSURF_OK);
    CHECK(algsurf_scene_create(s, &scene) == ALGSURF_OK);
    CHECK(algsurf_scene_set_extent(scene, &extent) == ALGSURF_OK);
    CHECK(algsurf_scene_set_camera(scene, &camera) == ALGSURF_OK);
    CHECK(algsurf_scene_set_material(scene, &matt) == ALGSURF_OK);
    CHECK(algsurf_scene_set_lights(scene, &light, 1) == ALGSURF_OK);
    CHECK(algsurf_scene_set_background(scene, black) == ALGSURF_OK);
    CHECK(algsurf_scene_set_quality(scene, ALGSURF_QUALITY_FULL) == ALGSURF_OK);
    BLANK(algsurf_render_options, o);
    BLANK(algsurf_render_stats, stats);
    BLANK(algsurf_picture, planes);
    planes.size = sizeof planes, planes.pixels = pixels, planes.stride = 3 * W, planes.format = ALGSURF_RGB8;
    planes.t = t, planes.normals = normals, planes.state = state, planes.way = way;
    o.width = W, o.height = H, o.row_begin = 0, o.row_end = H, o.threads = 2;
    o.progress = count_rows, o.progress_data = &rows;
    CHECK(algsurf_render(scene, at_edge(&o, sizeof o), at_edge(&planes, sizeof planes), NULL) == ALGSURF_OK);
    CHECK(rows == H);
    o.size = sizeof o;
    {
        algsurf_render_stats *given = at_edge(&stats, sizeof stats);
        CHECK(algsurf_render(scene, &o, &planes, given) == ALGSURF_OK);
        CHECK(given->rays == W * H && given->hits > 32);
    }
    CHECK(pixels[0] == 0 && pixels[3 * MIDDLE] > 100);
    CHECK(state[0] == ALGSURF_STATE_MISS && isinf(t[0]) && normals[2] == 0);
    CHECK(way[0] <= ALGSURF_WAY_SINGLE);
    CHECK(state[MIDDLE] == ALGSURF_STATE_HIT && t[MIDDLE] > 2 && t[MIDDLE] < 4 && normals[3 * MIDDLE + 2] > 0.9F);
    CHECK(algsurf_scene_set_clip(scene, &lower_half, 1) == ALGSURF_OK);
    CHECK(algsurf_render(scene, &o, &planes, NULL) == ALGSURF_OK);
    CHECK(state[MIDDLE] == ALGSURF_STATE_HIT && t[MIDDLE] > 4);
    algsurf_scene_free(scene);
}

/* A grey sphere in light from the eye, which is half of what it shows. */
static void check_colours(const algsurf_surface *s) {
    const double top[3] = {0, 0, 1}, down[3] = {0, 0, -1};
    const algsurf_extent extent = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {2, 2, 2}};
    double c[3], linear[3];
    unsigned char bytes[3];
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_scene *scene = NULL;
    BLANK(algsurf_material, grey);
    BLANK(algsurf_lighting, found);
    for (int i = 0; i < 3; i++) grey.outside[i] = grey.inside[i] = 0.5;
    grey.diffuse = 0, grey.ambient = 0, grey.fill = 0.5, grey.specular = 0, grey.roughness = 1, grey.haze = 0;
    CHECK(algsurf_scene_create(s, &scene) == ALGSURF_OK);
    CHECK(algsurf_scene_set_extent(scene, &extent) == ALGSURF_OK);
    CHECK(algsurf_scene_set_material(scene, at_edge(&grey, sizeof grey)) == ALGSURF_OK);
    CHECK(algsurf_scene_set_lights(scene, NULL, 0) == ALGSURF_OK);
    algsurf_lighting *of = at_edge(&found, sizeof found);
    CHECK(algsurf_scene_get_lighting(scene, lights, of) == ALGSURF_OK);
    CHECK(of->light_count == 0 && of->bounded == 1 && near(of->radius, sqrt(12)) && of->centre[0] == 0);
    BLANK(algsurf_lighting, lighting);
    lighting.material = at_edge(&grey, sizeof grey), lighting.lights = NULL, lighting.light_count = 0;
    lighting.radius = 1, lighting.bounded = 0;
    for (int i = 0; i < 3; i++)
        lighting.up[i] = i == 1, lighting.forward[i] = -(i == 2), lighting.centre[i] = 0;
    CHECK(algsurf_shade(at_edge(&lighting, sizeof lighting), NULL, top, top, down, c) == ALGSURF_OK);
    CHECK(near(c[0], 0.25) && near(c[1], 0.25) && near(c[2], 0.25));
    CHECK(algsurf_shade_preview(at_edge(&lighting, sizeof lighting), top, top, down, c) == ALGSURF_OK);
    CHECK(near(c[0], 0.5 * (0.86 + 0.14 * 0.075)));
    c[0] = 0, c[1] = 0.5, c[2] = 1;
    CHECK(algsurf_srgb_encode(c, bytes) == ALGSURF_OK && bytes[0] == 0 && bytes[1] == 188 && bytes[2] == 255);
    CHECK(algsurf_srgb_decode(bytes, linear) == ALGSURF_OK && fabs(linear[1] - 0.5) < 0.01 && linear[2] == 1);
    algsurf_scene_free(scene);
}

int main(void) {
    algsurf_surface *s = sphere();
    check_values(s);
    check_rays(s);
    check_packets(s);
    check_complex(s);
    check_roots();
    check_many();
    check_picture(s);
    check_colours(s);
    algsurf_surface_free(s);
    if (failures > 0) fprintf(stderr, "%d checks failed\n", failures);
    return failures > 0;
}
