/* test_render.c - pictures, each pixel against what the single steps or exact geometry give, and the
 * scene's setters; threads, slices and options are in test_render_threads.c.
 *
 * Breaks tried, each caught by the test named:
 *   sample grid off, the background counted otherwise                       pixel_by_pixel
 *   a box's ball by one of its sides, haze along another direction          preview_depth
 *   rays start below the surface, places below the tangent plane dark       shadows, penumbra
 *   lights that still shine given up as too low                             shadows
 *   a light's points not about its middle, or those of another light        spread_light, spread_evenly
 *   the lattice of the first sample, or of a point's number, for all        spread_light
 *   directions in half of each quarter, 15 of them, their reach             openness
 *   the default light behind what is shown                                  lighting_of_scenes, defaults
 */
#include "lattice_reference.h"
#include "render_case.h"
#include "shade_reference.h"

static uint8_t byte_of(const picture *p, int pixel, int channel) {
    return p->bytes[pixel / W * STRIDE + pixel % W * 3 + channel];
}

/* The hit a sample of the torus scene must have, from the public single steps. */
static algsurf_hit hit_of(const algsurf_surface *surface, double x, double y, algsurf_ray *ray) {
    algsurf_camera camera = camera_at(7, 4, 5, 36);
    assert_ok(algsurf_camera_ray(&camera, W, H, x, y, ray));
    algsurf_hit hit = first_hit_of(surface, &ball, ray, NULL);
    return hit;
}

/* The colour of a sample of a scene, in standard quality. */
static void add_colour(const algsurf_scene *scene, const algsurf_hit *hit, const algsurf_ray *ray,
                       const double sky[3], double sum[3]) {
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    double c[3] = {sky[0], sky[1], sky[2]};
    assert_ok(algsurf_scene_get_lighting(scene, lights, &lighting));
    if (hit->state != ALGSURF_STATE_MISS)
        assert_ok(algsurf_shade(&lighting, NULL, hit->position, hit->normal, ray->direction, c));
    for (int i = 0; i < 3; i++) sum[i] += c[i];
}

/* The bytes of a sum of colours; how many of the picture's are others: packets round otherwise. */
static int compare_bytes(const picture *p, int pixel, const double sum[3], int samples) {
    unsigned char expected[3];
    double average[3];
    int otherwise = 0;
    for (int i = 0; i < 3; i++) average[i] = sum[i] / samples;
    assert_ok(algsurf_srgb_encode(average, expected));
    for (int i = 0; i < 3; i++) {
        assert_in_range(byte_of(p, pixel, i), expected[i] - (expected[i] > 0), expected[i] + 1);
        otherwise += byte_of(p, pixel, i) != expected[i];
    }
    return otherwise;
}

/* Bytes and hits of pictures in standard quality, each from the single steps: with lights, and with the
 * default one. */
TEST(pixel_by_pixel) {
    const algsurf_light lights[2] = {
        {{5, -4, 6}, {0.9, 0.8, 0.7}, {1, 0, 0}, {0, 1, 0}, 4, 4, ALGSURF_LIGHT_AREA, {0}},
        {{6, 9, -2}, {2.5, 0.2, 0.3}, {0, 0, 0}, {0, 0, 0}, 1, 1, ALGSURF_LIGHT_AREA, {0}}};
    const double sky[3] = {0.13, 0.25, 0.6};
    algsurf_surface *surface = torus();
    for (int n = 1; n <= 3; n++) {
        algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, n);
        if (n != 2) assert_ok(algsurf_scene_set_lights(scene, lights, 2));
        assert_ok(algsurf_scene_set_material(scene, &plain));
        assert_ok(algsurf_scene_set_background(scene, sky));
        picture *p = drawn(scene, 2);
        uint64_t count = 0;
        int otherwise = 0;
        for (int k = 0; k < W * H; k++) {
            double sum[3] = {0, 0, 0}, t = INFINITY;
            for (int s = 0; s < n * n; s++) {
                algsurf_ray ray;
                algsurf_hit hit = hit_of(surface, k % W + (s % n + 0.5) / n, k / W + (s / n + 0.5) / n, &ray);
                add_colour(scene, &hit, &ray, sky, sum);
                t = fmin(t, hit.t); /* +inf for a miss */
                count += hit.state == ALGSURF_STATE_HIT;
            }
            otherwise += compare_bytes(p, k, sum, n * n);
            if (isinf(t))
                assert_true(p->hits[k] == INFINITY);
            else
                assert_true(fabs(p->hits[k] - t) <= 0x1p-44 * t);
        }
        assert_true(p->stats.rays == (uint64_t)(W * H * n * n) && p->stats.hits == count);
        if (otherwise > 4) fail_msg("%d bytes otherwise", otherwise);
        assert_true(p->stats.shadow_rays == 0 && p->stats.size == sizeof p->stats);
        assert_true(p->stats.undecided < p->stats.rays / 50);
        assert_in_range(count * 100 / p->stats.rays, 15, 70); /* per cent of the picture is surface */
        assert_true(p->stats.solve_s > 0 && p->stats.shade_s > 0 && p->stats.total_s > 0);
    }
}

/* Haze grows from the near to the far end of the ball about the extent: a plane across the view at the
 * place `at` in a ball of that radius, seen from near or far. */
static void check_depth(const algsurf_extent *extent, double radius, double at, double eye_y) {
    algsurf_term plane[2] = {{0, 1, 0, 1}, {0, 0, 0, -at}};
    algsurf_scene *scene;
    algsurf_camera camera = camera_at(0, eye_y, 0, 0.1 / fabs(eye_y));
    uint8_t pixel[3];
    const algsurf_picture planes = {.size = sizeof planes, .pixels = pixel};
    algsurf_render_options o = {.size = sizeof o, .width = 1, .height = 1};
    const double view[3] = {0, eye_y < 0 ? 1 : -1, 0}, gradient[3] = {0, 1, 0}, place[3] = {0, at, 0};
    const algsurf_lighting lighting = {.material = &plain,
                                       .up = {0, 0, 1},
                                       .forward = {0, view[1], 0},
                                       .radius = radius,
                                       .bounded = extent->kind != ALGSURF_EXTENT_ALL};
    double colour[3];
    unsigned char expected[3];
    algsurf_surface *surface = surface_of_terms(plane, 2);
    scene = torus_scene(surface, ALGSURF_QUALITY_PREVIEW, 1);
    assert_ok(algsurf_scene_set_camera(scene, &camera));
    assert_ok(algsurf_scene_set_material(scene, &plain));
    assert_ok(algsurf_scene_set_extent(scene, extent));
    assert_ok(algsurf_render(scene, &o, &planes, NULL));
    reference_preview(&lighting, place, gradient, view, colour);
    assert_ok(algsurf_srgb_encode(colour, expected));
    assert_memory_equal(pixel, expected, 3);
}

TEST(preview_depth) {
    const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 4, 9}};
    const algsurf_extent all = {.kind = ALGSURF_EXTENT_ALL};
    for (int k = 0; k < 4; k++) {
        double eye_y = (k % 2 ? -1 : 1) * (k < 2 ? 8 : 1e7);
        check_depth(&ball, 3.2, 1.6, eye_y);
        check_depth(&ball, 3.2, -2.9, eye_y);
        check_depth(&box, sqrt(98), 3, eye_y);
        check_depth(&box, sqrt(98), -1, eye_y);
        if (k < 2) check_depth(&all, 1, 0.01, eye_y);
    }
}

/* By how much the segment from p to q clears the ball, negative: through it; of a point of the ball itself
 * the tangent plane tells. */
static double clears_ball(const double p[3], const double q[3]) {
    double d[3], m[3] = {0 - p[0], 0 - p[1], 0.5 - p[2]}, out = 0;
    for (int i = 0; i < 3; i++) d[i] = q[i] - p[i];
    if (fabs(reference_dot(m, m) - 0.64) < 1e-9) return INFINITY;
    double t = fmin(1, fmax(0, reference_dot(m, d) / reference_dot(d, d)));
    for (int i = 0; i < 3; i++) out += (m[i] - t * d[i]) * (m[i] - t * d[i]);
    return sqrt(out) - 0.8;
}

/* The same for the part in the extent of the plane where coordinate k has that value. */
static double clears_plane(const double p[3], const double q[3], int k, double value) {
    double from = p[k] - value, to = q[k] - value, at[3];
    if (fabs(from) < 1e-9) return INFINITY;
    if ((from > 0) == (to > 0)) return fabs(to);
    for (int i = 0; i < 3; i++) at[i] = p[i] + from / (from - to) * (q[i] - p[i]);
    double outside = sqrt(reference_dot(at, at)) - ball.size[0];
    return outside > 0 ? outside : -fmin(fabs(to), -outside);
}

static double clears_ball_and_plane(const double p[3], const double q[3]) {
    return fmin(clears_ball(p, q), clears_plane(p, q, 2, -1));
}

static double clears_floor(const double p[3], const double q[3]) { return clears_plane(p, q, 2, -1); }

static double clears_corner(const double p[3], const double q[3]) {
    return fmin(clears_plane(p, q, 1, 0), clears_plane(p, q, 2, 0));
}

typedef double clearance(const double p[3], const double q[3]);

/* A point of a picture in full quality, and what it is to see. */
typedef struct seeing {
    clearance *clears;
    const double *at;
    double facing[3];
    int seen, count, undecided; /* of places so far */
} seeing;

static void begin_places(seeing *s) { s->seen = s->count = s->undecided = 0; }

static void look_at(seeing *s, const double place[3]) {
    double way[3], clear = s->clears(s->at, place);
    for (int i = 0; i < 3; i++) way[i] = place[i] - s->at[i];
    double height = reference_dot(way, s->facing);
    s->seen += height <= 0 || clear > 0;
    s->undecided |= fabs(clear) < 1e-3 || (fabs(height) < 1e-4 && clear < 0);
    s->count++;
}

static double share_of(const seeing *s) { return (double)s->seen / s->count; }

static int rounded_up(int all, int samples) { return (all + samples - 1) / samples; }

static void look_at_light(seeing *s, const algsurf_light *light, int number, const algsurf_i_sample *sample) {
    double p[32], q[32], place[3];
    int each = rounded_up(32, sample->count);
    begin_places(s);
    for (int k = 0; k < light->samples_u * light->samples_v; k++) {
        assert_ok(algsurf_light_sample(light, k % light->samples_u, k / light->samples_u, place));
        look_at(s, place);
    }
    if (light->samples_u > 0) return;
    lattice_points(sample, ALGSURF_I_FOR_LIGHT + number, each, p, q);
    for (int k = 0; k < each; k++) {
        for (int i = 0; i < 3; i++)
            place[i] = light->position[i] + (p[k] - 0.5) * light->edge_u[i] + (q[k] - 0.5) * light->edge_v[i];
        look_at(s, place);
    }
}

/* Ends on a ball of half the radius that touches the surface. */
static void look_around(seeing *s, double radius, const algsurf_i_sample *sample) {
    double p[16], q[16], turn = 2 * acos(-1);
    int each = rounded_up(16, sample->count);
    begin_places(s);
    lattice_points(sample, ALGSURF_I_FOR_AMBIENT, each, p, q);
    for (int k = 0; k < each; k++) {
        double z = 1 - 2 * p[k], wide = sqrt(1 - z * z), place[3];
        const double out[3] = {wide * cos(turn * (q[k] - 0.125)), wide * sin(turn * (q[k] - 0.125)), z};
        for (int i = 0; i < 3; i++) place[i] = s->at[i] + radius / 2 * (s->facing[i] + out[i]);
        look_at(s, place);
    }
}

/* What was found of the points of a picture in full quality. */
typedef struct shares {
    int lit, dark, between, pixels; /* of the first light; pixels that were compared */
    int around[17];                 /* that many sixteenths free */
    double light[W * H];            /* shares of the first light, -1: not compared */
    uint64_t most_rays;
} shares;

/* Adds the colour of a sample; returns whether it is beyond doubt. */
static int add_full_colour(const algsurf_lighting *lighting, clearance *clears, const algsurf_hit *hit,
                           const algsurf_ray *ray, const algsurf_i_sample *sample, double sum[3],
                           shares *found) {
    double visible[ALGSURF_MAX_LIGHTS + 1], c[3];
    seeing s = {.clears = clears, .at = hit->position};
    int sure = 1, lights = (int)lighting->light_count;
    double away = reference_dot(hit->normal, ray->direction) > 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) s.facing[i] = away * hit->normal[i];
    for (int l = 0; l < lights; l++) {
        look_at_light(&s, &lighting->lights[l], l, sample);
        visible[l] = share_of(&s);
        sure &= !s.undecided;
        found->most_rays += (uint64_t)s.count;
    }
    look_around(&s, lighting->radius, sample);
    visible[lights] = share_of(&s);
    sure &= !s.undecided;
    found->most_rays += (uint64_t)s.count;
    if (sure) found->around[(int)(16 * visible[lights])]++;
    if (lights > 0) found->light[sample->y * W + sample->x] = visible[0];
    assert_ok(algsurf_shade(lighting, visible, hit->position, hit->normal, ray->direction, c));
    for (int i = 0; i < 3; i++) sum[i] += c[i];
    return sure;
}

/* Draws in full quality, and compares each pixel with exact geometry. */
static void check_full(const char *equation, clearance *clears, const algsurf_material *material,
                       const algsurf_light *lights, int count, int n, shares *found) {
    algsurf_surface *surface = surface_of(equation);
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_FULL, n);
    algsurf_light all[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    int otherwise = 0;
    assert_ok(algsurf_scene_set_lights(scene, lights, (size_t)count));
    assert_ok(algsurf_scene_set_material(scene, material));
    assert_ok(algsurf_scene_get_lighting(scene, all, &lighting));
    picture *p = drawn(scene, 2);
    *found = (shares){0};
    for (int k = 0; k < W * H; k++) {
        double sum[3] = {0, 0, 0};
        int sure = 1, hits = 0;
        found->light[k] = -1;
        for (int s = 0; s < n * n; s++) {
            const algsurf_i_sample sample = {k % W, k / W, s, n * n};
            algsurf_ray ray;
            algsurf_hit hit = hit_of(surface, k % W + (s % n + 0.5) / n, k / W + (s / n + 0.5) / n, &ray);
            hits += hit.state == ALGSURF_STATE_HIT;
            if (hit.state == ALGSURF_STATE_HIT)
                sure &= add_full_colour(&lighting, clears, &hit, &ray, &sample, sum, found);
            else
                for (int i = 0; i < 3; i++) sum[i] += 1; /* the background */
        }
        double light = found->light[k];
        if (hits == 0 || !sure) found->light[k] = -1;
        if (hits == 0 || !sure) continue;
        otherwise += compare_bytes(p, k, sum, n * n);
        found->pixels++;
        found->lit += light == 1, found->dark += light == 0, found->between += light > 0 && light < 1;
    }
    if (otherwise > 4) fail_msg("%d bytes otherwise", otherwise);
    assert_true(p->stats.shadow_rays <= found->most_rays);
}

/* A ball of radius 0.8 about (0,0,0.5) above the plane z = -1. */
static const char ball_and_plane[] = "(z+1)(x^2+y^2+(z-0.5)^2-0.64)";

/* plain, of which only lights are seen. */
static algsurf_material lights_only(void) {
    algsurf_material m = plain;
    m.ambient = m.fill = 0;
    return m;
}

TEST(shadows) {
    algsurf_light light = {{0.5, -0.5, 5}, {1, 1, 1}, {0, 0, 0}, {0, 0, 0}, 1, 1, ALGSURF_LIGHT_AREA, {0}};
    const algsurf_material m = lights_only();
    static shares found;
    check_full(ball_and_plane, clears_ball_and_plane, &m, &light, 1, 1, &found);
    assert_true(found.lit > 200 && found.dark > 40 && found.between == 0);
    light.position[2] = -0.5; /* below the ball, which casts no shadow then; its underside is lit */
    light.position[0] = 1.5;
    check_full(ball_and_plane, clears_ball_and_plane, &m, &light, 1, 1, &found);
    assert_true(found.lit > 200 && found.dark == 0);
    light.position[0] = 3, light.position[2] = -2.5; /* below the plane, which hides it from the ball */
    check_full(ball_and_plane, clears_ball_and_plane, &m, &light, 1, 1, &found);
    assert_true(found.dark > 5 && found.between == 0);
}

TEST(penumbra) {
    algsurf_light light = {{0.5, -0.5, 3}, {1, 1, 1}, {2, 0, 0}, {0, 2, 0}, 5, 4, ALGSURF_LIGHT_AREA, {0}};
    const algsurf_material m = lights_only();
    static shares found;
    for (int n = 1; n <= 2; n++) {
        light.samples_u = 5, light.samples_v = 4;
        check_full(ball_and_plane, clears_ball_and_plane, &m, &light, 1, n, &found);
        assert_true(found.lit > 100 && found.between > 10);
        light.samples_u = 3, light.samples_v = 2; /* fewer than a fan is asked about */
        check_full(ball_and_plane, clears_ball_and_plane, &m, &light, 1, n, &found);
        assert_true(found.lit > 100 && found.between > 10);
    }
    light.samples_u = 20, light.samples_v = 17; /* more than go into one packet of shadow rays */
    check_full(ball_and_plane, clears_ball_and_plane, &m, &light, 1, 1, &found);
    assert_true(found.lit > 100 && found.between > 5);
}

/* A light with points of its own for each pixel, beside another one of all kinds, and all other light. */
TEST(spread_light) {
    const algsurf_light lights[3] = {
        {{0.5, -0.5, 3}, {0.7, 0.7, 0.7}, {2, 0, 0}, {0, 2, 0}, 0, 0, ALGSURF_LIGHT_AREA, {0}},
        {{-2, 3, 4}, {0.1, 0.3, 0.2}, {1, 0, 1}, {0, 1.5, 0}, 0, 0, ALGSURF_LIGHT_AREA, {0}},
        {{3, 3, 4}, {0.2, 0.1, 0}, {1, 0, 0}, {0, 1, 0}, 2, 2, ALGSURF_LIGHT_AREA, {0}}};
    static shares found;
    for (int n = 1; n <= 3; n++) {
        check_full(ball_and_plane, clears_ball_and_plane, &plain, lights, 3, n, &found);
        assert_true(found.pixels > 300 && found.lit > 50 && found.between > 10);
    }
}

/* Its share of 32 points is near that of a fine grid's, on the average nearer. */
TEST(spread_evenly) {
    const algsurf_light light = {{0.5, -0.5, 3},     {1, 1, 1}, {2, 0, 0}, {0, 2, 0}, 0, 0,
                                 ALGSURF_LIGHT_AREA, {0}};
    const algsurf_material m = lights_only();
    algsurf_light fine = light;
    algsurf_surface *surface = surface_of(ball_and_plane);
    static shares found;
    double off = 0, sum = 0;
    int between = 0, alike = 0;
    check_full(ball_and_plane, clears_ball_and_plane, &m, &light, 1, 1, &found);
    fine.samples_u = fine.samples_v = 40;
    for (int k = 0; k < W * H; k++) {
        const algsurf_i_sample sample = {k % W, k / W, 0, 1};
        algsurf_ray ray;
        algsurf_hit hit = hit_of(surface, k % W + 0.5, k / W + 0.5, &ray);
        if (found.light[k] < 0) continue;
        seeing s = {.clears = clears_ball_and_plane, .at = hit.position};
        for (int i = 0; i < 3; i++) s.facing[i] = hit.normal[i];
        look_at_light(&s, &fine, 0, &sample);
        double expected = share_of(&s), error = found.light[k] - expected;
        assert_true(fabs(error) < 0.12);
        if (!(expected > 0 && expected < 1)) continue;
        off += fabs(error), sum += error, between++;
        alike += k > 0 && found.light[k] == found.light[k - 1];
    }
    assert_true(between > 40 && off < 0.03 * between && fabs(sum) < 0.015 * between);
    assert_true(alike < between / 3);
}

/* Light from all around: all of it in the middle of a plane, half of it in the edge between two planes. */
TEST(openness) {
    static shares found;
    check_full("z+1", clears_floor, &plain, NULL, 0, 1, &found);
    assert_true(found.pixels > 300 && found.around[16] == found.pixels);
    for (int n = 1; n <= 3; n++) {
        check_full("yz", clears_corner, &plain, NULL, 0, n, &found);
        assert_true(found.pixels > 300);
        if (n == 1) assert_true(found.around[8] + found.around[9] > 10 && found.around[16] > 100);
        for (int k = 0; k < 6 && n == 1; k++) assert_int_equal(found.around[k], 0);
    }
}

/* What is told of a scene's light: its own, and the default. */
TEST(lighting_of_scenes) {
    const algsurf_light set[2] = {
        {{5, -4, 6}, {0.9, 0.8, 0.7}, {1, 0, 0}, {0, 1, 0}, 4, 4, ALGSURF_LIGHT_AREA, {0}},
        {{6, 9, -2}, {2.5, 0.2, 0.3}, {0, 0, 0}, {0, 0, 0}, 1, 1, ALGSURF_LIGHT_AREA, {0}}};
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_FULL, 1);
    algsurf_camera camera = camera_at(7, 4, 5, 36);
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting l = {.size = sizeof l};
    memset(lights, 0xff, sizeof lights);
    assert_ok(algsurf_scene_set_material(scene, &plain));
    assert_ok(algsurf_scene_get_lighting(scene, lights, &l));
    assert_true(l.size == sizeof l && l.lights == lights && l.light_count == 1 && l.bounded == 1);
    assert_memory_equal(l.material, &plain, sizeof plain);
    assert_memory_equal(l.up, camera.up, sizeof l.up);
    assert_memory_equal(l.forward, camera.forward, sizeof l.forward);
    assert_true(l.radius == 3.2 && l.centre[0] == 0 && l.centre[1] == 0 && l.centre[2] == 0);
    const algsurf_light *light = &lights[0]; /* on the viewer's side, above left, its edges across the way */
    const double *way = light->position;
    assert_true(fabs(sqrt(reference_dot(way, way)) / (16 * 3.2) - 1) < 1e-3);
    assert_true(reference_dot(way, camera.forward) < 0 && reference_dot(way, camera.up) > 0 &&
                reference_dot(way, camera.right) < 0);
    assert_true(fabs(reference_dot(way, light->edge_u)) < 2 && fabs(reference_dot(way, light->edge_v)) < 2);
    assert_true(fabs(reference_dot(light->edge_u, light->edge_v)) < 2);
    assert_true(fabs(sqrt(reference_dot(light->edge_u, light->edge_u)) / (0.45 * 16 * 3.2) - 1) < 2e-3);
    assert_true(fabs(sqrt(reference_dot(light->edge_v, light->edge_v)) / (0.45 * 16 * 3.2) - 1) < 2e-3);
    assert_true(light->samples_u == 0 && light->samples_v == 0 && light->colour[1] == 1);
    assert_ok(algsurf_scene_set_lights(scene, lights, 1)); /* all of its members are set */
    assert_ok(algsurf_scene_set_lights(scene, set, 2));
    assert_ok(algsurf_scene_set_extent(scene, NULL));
    assert_ok(algsurf_scene_get_lighting(scene, lights, &l));
    assert_true(l.light_count == 2 && l.bounded == 0 && l.radius > 0);
    for (int k = 0; k < 2; k++) /* up to what an int leaves open */
        assert_memory_equal(&lights[k], &set[k], offsetof(algsurf_light, kind) + sizeof set[k].kind);
    for (int k = 0; k < 8; k++) assert_true(lights[0].reserved[k] == 0 && lights[1].reserved[k] == 0);
    assert_ok(algsurf_scene_set_lights(scene, NULL, 0));
    assert_ok(algsurf_scene_get_lighting(scene, lights, &l));
    assert_int_equal(l.light_count, 0);
    assert_int_equal(algsurf_scene_get_lighting(NULL, lights, &l), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_scene_get_lighting(scene, NULL, &l), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_scene_get_lighting(scene, lights, NULL), ALGSURF_E_ARGUMENT);
    l.size--;
    assert_int_equal(algsurf_scene_get_lighting(scene, lights, &l), ALGSURF_E_SIZE);
}

/* Every ray touches the double plane y^2 = 0: a hit, or, where doubles are all there is, undecided and drawn.
 */
static void double_plane(int tier) {
    algsurf_surface *surface = surface_of("y^2 (x + 99)");
    const algsurf_intersect_options how = {.size = sizeof how, .tier = tier};
    uint64_t all = W * H, open = tier == ALGSURF_TIER_BOUNDED ? all : 0;
    for (int q = ALGSURF_QUALITY_PREVIEW; q <= ALGSURF_QUALITY_FULL; q++) {
        algsurf_scene *scene = torus_scene(surface, (algsurf_quality)q, 1);
        algsurf_camera camera = camera_at(0.1, -6, 0.2, 10);
        assert_ok(algsurf_scene_set_camera(scene, &camera));
        assert_ok(algsurf_scene_set_intersect_options(scene, &how));
        picture *p = drawn(scene, 1);
        assert_true(p->stats.undecided == open && p->stats.hits == all - open && p->stats.rays == all);
        for (int k = 0; k < W * H; k++) {
            algsurf_ray ray = pixel_ray(&camera, W, H, k % W + 0.5, k / W + 0.5);
            assert_true(open > 0 || fabs(p->hits[k] - 6 / ray.direction[1]) < 1e-12);
            assert_true(p->bytes[k / W * STRIDE + k % W * 3 + 2] < 250); /* the background is white */
        }
    }
}

TEST(touching_is_drawn) {
    double_plane(ALGSURF_TIER_CERTIFIED);
    double_plane(ALGSURF_TIER_BOUNDED);
}

/* From a million radii with a narrow field of view the picture is that of the parallel projection. */
TEST(far_eye) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_FULL, 1);
    const double eye[3] = {7, 4, 5};
    double distance = 3.2e6, scale = distance / sqrt(90), differ = 0;
    algsurf_camera parallel,
        far = camera_at(7 * scale, 4 * scale, 5 * scale, 360 / acos(-1) * atan(3 / distance));
    parallel = parallel_of(eye, origin, z_up, 6);
    assert_ok(algsurf_scene_set_camera(scene, &far));
    picture *a = drawn(scene, 1);
    assert_ok(algsurf_scene_set_camera(scene, &parallel));
    picture *b = drawn(scene, 1);
    for (int y = 0; y < H; y++)
        for (int i = 0; i < 3 * W; i++)
            differ += abs(a->bytes[y * STRIDE + i] - b->bytes[y * STRIDE + i]) > 1;
    assert_true(a->stats.hits > W * H / 4);
    assert_true(differ < 0.01 * 3 * W * H);
}

/* Defaults are usable as they are; removing the lights leaves light from all around. */
TEST(defaults) {
    algsurf_surface *surface = surface_of("x^2+y^2+z^2-1");
    algsurf_scene *scene = scene_of(surface, NULL, NULL, NULL);
    picture *p = drawn(scene, 0);
    const uint8_t *centre = p->bytes + H / 2 * STRIDE + W / 2 * 3;
    assert_true(p->bytes[0] == 255 && p->bytes[1] == 255 && p->bytes[2] == 255 && p->hits[0] == INFINITY);
    assert_true(fabs(p->hits[H / 2 * W + W / 2] - (sqrt(31.25) - 1)) < 0.01);
    assert_true(centre[2] > 200 && centre[2] > centre[1] && centre[1] > centre[0]); /* bright and blue */
    assert_ok(algsurf_scene_set_lights(scene, NULL, 0));
    picture *dark = drawn(scene, 0);
    assert_in_range(dark->bytes[H / 2 * STRIDE + W / 2 * 3 + 2], 100, 190);
    algsurf_scene_free(NULL);
}

TEST(bad_scene) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, 1), *none = NULL;
    algsurf_extent extent = ball;
    algsurf_camera camera = camera_at(7, 4, 5, 36);
    algsurf_material material = plain;
    algsurf_light lights[17];
    algsurf_intersect_options o = {.size = sizeof o};
    double colour[3] = {0, 0, 0};
    picture *before = drawn(scene, 1), *after;
    for (int l = 0; l < 17; l++) lights[l] = (algsurf_light){.samples_u = 1, .samples_v = 1};
#define REFUSED(status, call) assert_int_equal(algsurf_scene_##call, ALGSURF_E_##status)
    REFUSED(ARGUMENT, create(NULL, &none));
    assert_null(none);
    REFUSED(ARGUMENT, create(surface, NULL));
    REFUSED(ARGUMENT, set_extent(NULL, &extent));
    REFUSED(ARGUMENT, set_camera(NULL, &camera));
    REFUSED(ARGUMENT, set_camera(scene, NULL));
    REFUSED(ARGUMENT, set_material(NULL, &material));
    REFUSED(ARGUMENT, set_material(scene, NULL));
    REFUSED(ARGUMENT, set_lights(NULL, lights, 1));
    REFUSED(ARGUMENT, set_lights(scene, NULL, 1));
    REFUSED(ARGUMENT, set_lights(scene, lights, 17));
    REFUSED(ARGUMENT, set_lights(scene, lights, SIZE_MAX));
    REFUSED(ARGUMENT, set_background(NULL, colour));
    REFUSED(ARGUMENT, set_thin(NULL, colour));
    REFUSED(ARGUMENT, set_quality(NULL, ALGSURF_QUALITY_FULL));
    REFUSED(ARGUMENT, set_quality(scene, (algsurf_quality)3));
    REFUSED(ARGUMENT, set_antialias(NULL, 1));
    REFUSED(ARGUMENT, set_antialias(scene, 0));
    REFUSED(ARGUMENT, set_antialias(scene, 17));
    REFUSED(ARGUMENT, set_antialias_threshold(NULL, 0.5));
    REFUSED(ARGUMENT, set_antialias_threshold(scene, -0.5));
    REFUSED(NOT_FINITE, set_antialias_threshold(scene, NAN));
    REFUSED(ARGUMENT, set_intersect_options(NULL, &o));
    extent.size[0] = -1;
    REFUSED(ARGUMENT, set_extent(scene, &extent));
    extent.size[0] = INFINITY;
    REFUSED(NOT_FINITE, set_extent(scene, &extent));
    camera.kind = 2;
    REFUSED(ARGUMENT, set_camera(scene, &camera));
    camera.kind = ALGSURF_CAMERA_PINHOLE, camera.reserved[7] = 1;
    REFUSED(ARGUMENT, set_camera(scene, &camera));
    camera.reserved[7] = 0;
    camera.up[0] = 3;
    REFUSED(ARGUMENT, set_camera(scene, &camera));
    camera.up[0] = NAN;
    REFUSED(NOT_FINITE, set_camera(scene, &camera));
    material.diffuse = -1;
    REFUSED(ARGUMENT, set_material(scene, &material));
    material.diffuse = NAN;
    REFUSED(NOT_FINITE, set_material(scene, &material));
    lights[3].kind = 1;
    REFUSED(ARGUMENT, set_lights(scene, lights, 4));
    lights[3].kind = ALGSURF_LIGHT_AREA, lights[3].reserved[0] = 1;
    REFUSED(ARGUMENT, set_lights(scene, lights, 4));
    lights[3].reserved[0] = 0;
    lights[3].samples_u = 0;
    REFUSED(ARGUMENT, set_lights(scene, lights, 4));
    lights[2].position[1] = INFINITY;
    REFUSED(NOT_FINITE, set_lights(scene, lights, 4));
    colour[1] = -0.5;
    REFUSED(ARGUMENT, set_background(scene, colour));
    REFUSED(ARGUMENT, set_thin(scene, colour));
    colour[1] = 1.001;
    REFUSED(ARGUMENT, set_background(scene, colour));
    REFUSED(ARGUMENT, set_thin(scene, colour));
    colour[1] = NAN;
    REFUSED(NOT_FINITE, set_background(scene, colour));
    REFUSED(NOT_FINITE, set_thin(scene, colour));
    o.size = 1;
    REFUSED(SIZE, set_intersect_options(scene, &o));
    o = (algsurf_intersect_options){.size = sizeof o, .tier = 2};
    REFUSED(ARGUMENT, set_intersect_options(scene, &o));
    o = (algsurf_intersect_options){.size = sizeof o, .method = 4};
    REFUSED(ARGUMENT, set_intersect_options(scene, &o));
    o = (algsurf_intersect_options){.size = sizeof o, .max_iterations = -1};
    REFUSED(ARGUMENT, set_intersect_options(scene, &o));
    o = (algsurf_intersect_options){.size = sizeof o, .absolute_tolerance = NAN};
    REFUSED(NOT_FINITE, set_intersect_options(scene, &o));
    o.absolute_tolerance = -1;
    REFUSED(ARGUMENT, set_intersect_options(scene, &o));
#undef REFUSED
    after = drawn(scene, 1); /* a refused value leaves the scene as it was */
    assert_same_picture(before, after);
    assert_ok(algsurf_scene_set_intersect_options(scene, NULL));
    assert_ok(algsurf_scene_set_extent(scene, NULL));
    after = drawn(scene, 1); /* the torus lies in the ball: all of space shows the same hits */
    assert_true(after->stats.hits == before->stats.hits);
}

/* Across a steep ramp numbers of the row tell little of where its root is: t is that of the pixel's own ray.
 */
TEST(steep_ramps) {
    for (int power = 6; power <= 16; power++)
        for (int zoom = 4; zoom <= 10; zoom++) {
            enum { SIDE = 5 };
            const algsurf_term terms[] = {{0, 0, 2, pow(10, power)}, {0, 1, 0, 1}, {0, 0, 0, -0.1}};
            const algsurf_camera camera = {.eye = {0.5, -3, 0},
                                           .right = {0.8, 0, 0.6},
                                           .up = {-0.6, 0, 0.8},
                                           .forward = {0, 1, 0},
                                           .half_height = pow(10, -zoom),
                                           .kind = ALGSURF_CAMERA_ORTHOGRAPHIC};
            const algsurf_extent unit_ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1}};
            double t[SIDE * SIDE];
            unsigned char states[SIDE * SIDE];
            algsurf_surface *surface = surface_of_terms(terms, 3);
            algsurf_scene *scene = scene_of(surface, NULL, NULL, NULL);
            assert_ok(algsurf_scene_set_extent(scene, &unit_ball));
            assert_ok(algsurf_scene_set_camera(scene, &camera));
            const algsurf_render_options options = {.size = sizeof options, .width = SIDE, .height = SIDE};
            const algsurf_picture planes = {.size = sizeof planes, .t = t, .state = states};
            assert_ok(algsurf_render(scene, &options, &planes, NULL));
            for (int i = 0; i < SIDE * SIDE; i++) {
                algsurf_ray ray = pixel_ray(&camera, SIDE, SIDE, i % SIDE + 0.5, i / SIDE + 0.5);
                algsurf_hit hit = first_hit_of(surface, &unit_ball, &ray, NULL);
                assert_int_equal(states[i], hit.state);
                double slope = 2 * pow(10, power) * fabs(hit.position[2]); /* of t, across the ray */
                if (hit.state == ALGSURF_STATE_HIT && !(fabs(t[i] - hit.t) <= 0x1p-36 + 0x1p-49 * slope))
                    fail_msg("10^%d z^2, half height 10^-%d, pixel %d: t %a, by itself %a", power, zoom, i,
                             t[i], hit.t);
            }
        }
}
