/* test_render.c - pictures, each pixel against what the single steps or exact geometry give, and the
 * scene's setters; threads, slices and options are in test_render_crew.c.
 *
 * Breaks tried, each caught by the test named:
 *   sample grid off by half a sample, average before clamping, no rounding        pixel_by_pixel
 *   depth measured from the eye; ball of the wrong radius                         preview_depth
 *   no shadows, shadows of what is behind the light, shadow of the point itself   shadows
 *   share of an area light from its middle alone, samples behind the surface      penumbra
 *   undecided drawn as background or counted as a hit                             undecided_is_drawn
 *   default lights behind the surface                                             defaults
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render_case.h"

static const algsurf_material plain = {sizeof plain, {0.9, 0.5, 0.3}, {0.2, 0.4, 0.8}, 0.3, 0.6, 0.4, 20};

/* The hit a sample of the torus scene must have, from the public single steps. */
static algsurf_hit hit_of(const algsurf_surface *surface, double x, double y, algsurf_ray *ray) {
    algsurf_camera camera = camera_at(7, 4, 5, 36);
    algsurf_hit hit;
    assert_int_equal(algsurf_camera_ray(&camera, W, H, x, y, ray), ALGSURF_OK);
    assert_int_equal(algsurf_intersect_first(surface, &ball, ray, NULL, &hit), ALGSURF_OK);
    return hit;
}

/* Bytes and hits of a 3x3 antialiased picture in standard quality, each from the single steps. */
static void pixel_by_pixel(void **state) {
    const algsurf_light lights[2] = {{{5, -4, 6}, {0.9, 0.8, 0.7}, {1, 0, 0}, {0, 1, 0}, 4, 4},
                                     {{6, 9, -2}, {2.5, 0.2, 0.3}, {0, 0, 0}, {0, 0, 0}, 1, 1}};
    const double sky[3] = {0.13, 0.25, 0.6};
    algsurf_surface *surface = torus();
    (void)state;
    for (int n = 1; n <= 3; n += 2) {
        algsurf_scene *scene = scene_of(surface, ALGSURF_QUALITY_STANDARD, n);
        assert_int_equal(algsurf_scene_set_lights(scene, lights, 2), ALGSURF_OK);
        assert_int_equal(algsurf_scene_set_material(scene, &plain), ALGSURF_OK);
        assert_int_equal(algsurf_scene_set_background(scene, sky), ALGSURF_OK);
        picture *p = drawn(scene, 2);
        uint64_t count = 0, otherwise = 0;
        for (int k = 0; k < W * H; k++) {
            double sum[3] = {0, 0, 0}, t = INFINITY;
            for (int s = 0; s < n * n; s++) {
                double c[3] = {sky[0], sky[1], sky[2]};
                algsurf_ray ray;
                algsurf_hit hit = hit_of(surface, k % W + (s % n + 0.5) / n, k / W + (s / n + 0.5) / n, &ray);
                if (hit.state != ALGSURF_MISS)
                    assert_int_equal(
                        algsurf_shade(&plain, lights, 2, NULL, hit.position, hit.normal, ray.direction, c),
                        ALGSURF_OK);
                for (int i = 0; i < 3; i++) sum[i] += c[i] > 1 ? 1 : c[i];
                t = fmin(t, hit.t); /* +inf for a miss */
                count += hit.state == ALGSURF_HIT;
            }
            for (int i = 0; i < 3; i++) { /* packets round otherwise: seldom to the other side of a half */
                int byte = p->bytes[k / W * STRIDE + k % W * 3 + i];
                int expected = (int)floor(255 * (sum[i] / (n * n)) + 0.5);
                assert_in_range(byte, expected - (expected > 0), expected + 1);
                otherwise += byte != expected;
            }
            if (isinf(t))
                assert_true(p->hits[k] == INFINITY);
            else
                assert_true(fabs(p->hits[k] - t) <= 0x1p-44 * t); /* packets round otherwise */
        }
        assert_true(p->stats.rays == (uint64_t)(W * H * n * n) && p->stats.hits == count);
        if (otherwise > 4) fail_msg("%d bytes otherwise", (int)otherwise);
        assert_true(p->stats.shadow_rays == 0 && p->stats.size == sizeof p->stats);
        assert_true(p->stats.undecided < p->stats.rays / 50);
        assert_in_range(count * 100 / p->stats.rays, 15, 70); /* per cent of the picture is surface */
        assert_true(p->stats.solve_s > 0 && p->stats.shade_s + p->stats.point_s > 0 && p->stats.total_s > 0);
        free(p);
        algsurf_scene_free(scene);
    }
    algsurf_surface_free(surface);
}

/* Depth runs from the near to the far end of the extent along the view: a plane across the view at the
 * place `at` in an extent that reaches `reach` both ways, seen from near or far. */
static void check_depth(const algsurf_extent *extent, double reach, double at, double eye_y) {
    algsurf_term plane[2] = {{0, 1, 0, 1}, {0, 0, 0, -at}};
    algsurf_surface *surface;
    algsurf_scene *scene;
    algsurf_camera camera = camera_at(0, eye_y, 0, 0.1 / fabs(eye_y));
    uint8_t pixel[3];
    const algsurf_picture planes = {.size = sizeof planes, .pixels = pixel};
    algsurf_render_options o = {.size = sizeof o, .width = 1, .height = 1};
    assert_int_equal(algsurf_surface_from_terms(plane, 2, &surface), ALGSURF_OK);
    scene = scene_of(surface, ALGSURF_QUALITY_PREVIEW, 1);
    assert_int_equal(algsurf_scene_set_camera(scene, &camera), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_material(scene, &plain), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_extent(scene, extent), ALGSURF_OK);
    assert_int_equal(algsurf_render(scene, &o, &planes, NULL), ALGSURF_OK);
    double depth = 0.5 + 0.5 * (at / reach) * (eye_y < 0 ? 1 : -1), expected[3];
    const double view[3] = {0, eye_y < 0 ? 1 : -1, 0}, gradient[3] = {0, 1, 0};
    assert_int_equal(algsurf_shade_preview(&plain, gradient, view, depth, expected), ALGSURF_OK);
    for (int i = 0; i < 3; i++) assert_true(fabs(pixel[i] - 255 * expected[i]) <= 0.51);
    algsurf_scene_free(scene), algsurf_surface_free(surface);
}

static void preview_depth(void **state) {
    const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 4, 9}};
    const algsurf_extent all = {.kind = ALGSURF_EXTENT_ALL};
    const double fov_radius = 8 * tan(0.1 / 8 * acos(-1) / 360); /* all of space: what fills the picture */
    (void)state;
    for (int k = 0; k < 4; k++) {
        double eye_y = (k % 2 ? -1 : 1) * (k < 2 ? 8 : 1e7);
        check_depth(&ball, 3.2, 1.6, eye_y);
        check_depth(&ball, 3.2, -2.9, eye_y);
        check_depth(&box, 4, 3, eye_y);
        check_depth(&box, 4, -1, eye_y);
        if (k < 2) check_depth(&all, fov_radius, 0.25 * fov_radius, eye_y);
    }
}

/* A ball of radius 0.8 about (0,0,0.5) above the plane z = -1. */
static algsurf_surface *ball_and_plane(void) { return surface_of("(z+1)(x^2+y^2+(z-0.5)^2-0.64)"); }

/* Does the segment from p to q pass the ball, by how much of its radius does it clear it (negative:
 * through it)? */
static double clearance(const double p[3], const double q[3]) {
    double d[3], m[3] = {0 - p[0], 0 - p[1], 0.5 - p[2]}, dd = 0, md = 0, out = 0;
    for (int i = 0; i < 3; i++) d[i] = q[i] - p[i], dd += d[i] * d[i], md += m[i] * d[i];
    double t = fmin(1, fmax(0, md / dd));
    for (int i = 0; i < 3; i++) out += (m[i] - t * d[i]) * (m[i] - t * d[i]);
    return sqrt(out) - 0.8;
}

/* How far q lies above the tangent plane of the ball at p: the ball hides what lies below. */
static double above_ball(const double p[3], const double q[3]) {
    double sum = 0;
    for (int i = 0; i < 3; i++) sum += (p[i] - (i == 2 ? 0.5 : 0)) / 0.8 * (q[i] - p[i]);
    return sum;
}

/* Draws ball and plane in full quality under one light, compares each pixel with the exact geometry, and
 * counts the pixels of the plane in full light, in the dark, between, and those of the lit ball. */
static void check_shadows(const algsurf_light *light, int counts[3], int *ball_pixels) {
    algsurf_surface *surface = ball_and_plane();
    algsurf_scene *scene = scene_of(surface, ALGSURF_QUALITY_FULL, 1);
    picture *p;
    assert_int_equal(algsurf_scene_set_lights(scene, light, 1), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_material(scene, &plain), ALGSURF_OK);
    p = drawn(scene, 2);
    counts[0] = counts[1] = counts[2] = *ball_pixels = 0;
    for (int k = 0; k < W * H; k++) {
        algsurf_ray ray;
        algsurf_hit hit = hit_of(surface, k % W + 0.5, k / W + 0.5, &ray);
        if (hit.state != ALGSURF_HIT) continue;
        int on_plane = fabs(hit.position[2] + 1) < 1e-9, seen = 0, doubtful = 0, samples = 0;
        for (int a = 0; a < light->samples_u; a++)
            for (int b = 0; b < light->samples_v; b++) {
                double q[3];
                assert_int_equal(algsurf_light_sample(light, a, b, q), ALGSURF_OK);
                double clear = on_plane ? clearance(hit.position, q) : above_ball(hit.position, q);
                seen += clear > 0, doubtful += fabs(clear) < 1e-4, samples++;
            }
        if (doubtful) continue;
        double share = (double)seen / samples, c[3];
        assert_int_equal(algsurf_shade(&plain, light, 1, &share, hit.position, hit.normal, ray.direction, c),
                         ALGSURF_OK);
        for (int i = 0; i < 3; i++)
            assert_int_equal(p->bytes[k / W * STRIDE + k % W * 3 + i], (int)(255 * fmin(1, c[i]) + 0.5));
        if (on_plane)
            counts[share == 1 ? 0 : share == 0 ? 1 : 2]++;
        else
            ++*ball_pixels;
    }
    int places = light->samples_u * light->samples_v; /* one alone is decided by fans */
    assert_true((p->stats.shadow_rays > 0 || places == 1) &&
                p->stats.shadow_rays <= p->stats.hits * (uint64_t)places);
    free(p);
    algsurf_scene_free(scene), algsurf_surface_free(surface);
}

static void shadows(void **state) {
    algsurf_light light = {{0.5, -0.5, 5}, {1, 1, 1}, {0, 0, 0}, {0, 0, 0}, 1, 1};
    int counts[3], on_ball;
    (void)state;
    check_shadows(&light, counts, &on_ball);
    assert_true(counts[0] > 200 && counts[1] > 50 && counts[2] == 0 && on_ball > 15);
    light.position[2] = -0.5; /* below the ball, which casts no shadow then; its underside is lit */
    light.position[0] = 1.5;
    check_shadows(&light, counts, &on_ball);
    assert_true(counts[0] > 200 && counts[1] == 0);
}

static void penumbra(void **state) {
    algsurf_light light = {{0.5, -0.5, 3}, {1, 1, 1}, {2, 0, 0}, {0, 2, 0}, 5, 4};
    int counts[3], on_ball;
    (void)state;
    check_shadows(&light, counts, &on_ball);
    assert_true(counts[0] > 100 && counts[2] > 10);
    light.samples_u = 20, light.samples_v = 17; /* more than go into one packet of shadow rays */
    check_shadows(&light, counts, &on_ball);
    assert_true(counts[0] > 100 && counts[2] > 10);
}

/* Every ray touches the double plane y^2 = 0: a hit, or, where doubles are all there is, undecided and drawn.
 */
static void double_plane(int tier) {
    algsurf_surface *surface = surface_of("y^2");
    const algsurf_intersect_options how = {.size = sizeof how, .tier = tier};
    uint64_t all = W * H, open = tier == ALGSURF_TIER_BOUNDED ? all : 0;
    for (int q = ALGSURF_QUALITY_PREVIEW; q <= ALGSURF_QUALITY_FULL; q++) {
        algsurf_scene *scene = scene_of(surface, (algsurf_quality)q, 1);
        algsurf_camera camera = camera_at(0.1, -6, 0.2, 10);
        assert_int_equal(algsurf_scene_set_camera(scene, &camera), ALGSURF_OK);
        assert_int_equal(algsurf_scene_set_intersect(scene, &how), ALGSURF_OK);
        picture *p = drawn(scene, 1);
        assert_true(p->stats.undecided == open && p->stats.hits == all - open && p->stats.rays == all);
        for (int k = 0; k < W * H; k++) {
            algsurf_ray ray;
            assert_int_equal(algsurf_camera_ray(&camera, W, H, k % W + 0.5, k / W + 0.5, &ray), ALGSURF_OK);
            assert_true(open > 0 || fabs(p->hits[k] - 6 / ray.direction[1]) < 1e-12);
            assert_true(p->bytes[k / W * STRIDE + k % W * 3 + 2] < 250); /* the background is white */
        }
        free(p);
        algsurf_scene_free(scene);
    }
    algsurf_surface_free(surface);
}

static void touching_is_drawn(void **state) {
    (void)state;
    double_plane(ALGSURF_TIER_CERTIFIED);
    double_plane(ALGSURF_TIER_BOUNDED);
}

/* From a million radii with a narrow field of view the picture is that of the parallel projection. */
static void far_eye(void **state) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = scene_of(surface, ALGSURF_QUALITY_FULL, 1);
    const double eye[3] = {7, 4, 5};
    double distance = 3.2e6, scale = distance / sqrt(90), differ = 0;
    algsurf_camera parallel,
        far = camera_at(7 * scale, 4 * scale, 5 * scale, 360 / acos(-1) * atan(3 / distance));
    (void)state;
    assert_int_equal(algsurf_camera_orthographic(eye, origin, z_up, 6, &parallel), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_camera(scene, &far), ALGSURF_OK);
    picture *a = drawn(scene, 1);
    assert_int_equal(algsurf_scene_set_camera(scene, &parallel), ALGSURF_OK);
    picture *b = drawn(scene, 1);
    for (int y = 0; y < H; y++)
        for (int i = 0; i < 3 * W; i++)
            differ += abs(a->bytes[y * STRIDE + i] - b->bytes[y * STRIDE + i]) > 1;
    assert_true(a->stats.hits > W * H / 4);
    assert_true(differ < 0.01 * 3 * W * H);
    free(a), free(b);
    algsurf_scene_free(scene), algsurf_surface_free(surface);
}

/* Defaults are usable as they are; removing the lights leaves ambient light. */
static void defaults(void **state) {
    algsurf_surface *surface = surface_of("x^2+y^2+z^2-1");
    algsurf_scene *scene;
    (void)state;
    assert_int_equal(algsurf_scene_create(surface, &scene), ALGSURF_OK);
    picture *p = drawn(scene, 0);
    const uint8_t *centre = p->bytes + H / 2 * STRIDE + W / 2 * 3;
    assert_true(p->bytes[0] == 255 && p->bytes[1] == 255 && p->bytes[2] == 255 && p->hits[0] == INFINITY);
    assert_true(fabs(p->hits[H / 2 * W + W / 2] - (sqrt(31.25) - 1)) < 0.01);
    assert_true(centre[0] > 200 && centre[0] > centre[1] && centre[1] > centre[2]); /* bright and warm */
    assert_int_equal(algsurf_scene_set_lights(scene, NULL, 0), ALGSURF_OK);
    picture *dark = drawn(scene, 0);
    assert_in_range(dark->bytes[H / 2 * STRIDE + W / 2 * 3], 40, 70);
    free(p), free(dark);
    algsurf_scene_free(scene), algsurf_surface_free(surface);
    algsurf_scene_free(NULL);
}

static void bad_scene(void **state) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = scene_of(surface, ALGSURF_QUALITY_STANDARD, 1), *none = NULL;
    algsurf_extent extent = ball;
    algsurf_camera camera = camera_at(7, 4, 5, 36);
    algsurf_material material = plain;
    algsurf_light lights[17];
    algsurf_intersect_options o = {.size = sizeof o};
    double colour[3] = {0, 0, 0};
    picture *before = drawn(scene, 1), *after;
    (void)state;
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
    REFUSED(ARGUMENT, set_lights(scene, lights, -1));
    REFUSED(ARGUMENT, set_lights(scene, lights, 17));
    REFUSED(ARGUMENT, set_background(NULL, colour));
    REFUSED(ARGUMENT, set_thin(NULL, colour));
    REFUSED(ARGUMENT, set_quality(NULL, ALGSURF_QUALITY_FULL));
    REFUSED(ARGUMENT, set_quality(scene, (algsurf_quality)3));
    REFUSED(ARGUMENT, set_antialias(NULL, 1));
    REFUSED(ARGUMENT, set_antialias(scene, 0));
    REFUSED(ARGUMENT, set_antialias(scene, 17));
    REFUSED(ARGUMENT, set_antialias_threshold(NULL, 0.5));
    REFUSED(ARGUMENT, set_antialias_threshold(scene, -0.5));
    REFUSED(ARGUMENT, set_antialias_threshold(scene, NAN));
    REFUSED(ARGUMENT, set_intersect(NULL, &o));
    extent.size[0] = -1;
    REFUSED(ARGUMENT, set_extent(scene, &extent));
    extent.size[0] = INFINITY;
    REFUSED(NOT_FINITE, set_extent(scene, &extent));
    camera.up[0] = 3;
    REFUSED(ARGUMENT, set_camera(scene, &camera));
    camera.up[0] = NAN;
    REFUSED(NOT_FINITE, set_camera(scene, &camera));
    material.diffuse = -1;
    REFUSED(ARGUMENT, set_material(scene, &material));
    material.diffuse = NAN;
    REFUSED(NOT_FINITE, set_material(scene, &material));
    lights[3].samples_u = 0;
    REFUSED(ARGUMENT, set_lights(scene, lights, 4));
    lights[2].position[1] = INFINITY;
    REFUSED(NOT_FINITE, set_lights(scene, lights, 4));
    colour[1] = -0.5;
    REFUSED(ARGUMENT, set_background(scene, colour));
    REFUSED(ARGUMENT, set_thin(scene, colour));
    colour[1] = NAN;
    REFUSED(NOT_FINITE, set_background(scene, colour));
    REFUSED(NOT_FINITE, set_thin(scene, colour));
    o.size = 1;
    REFUSED(ARGUMENT, set_intersect(scene, &o));
    o = (algsurf_intersect_options){.size = sizeof o, .tier = 3};
    REFUSED(ARGUMENT, set_intersect(scene, &o));
    o = (algsurf_intersect_options){.size = sizeof o, .method = 4};
    REFUSED(ARGUMENT, set_intersect(scene, &o));
    o = (algsurf_intersect_options){.size = sizeof o, .max_iterations = -1};
    REFUSED(ARGUMENT, set_intersect(scene, &o));
    o = (algsurf_intersect_options){.size = sizeof o, .absolute_tolerance = NAN};
    REFUSED(ARGUMENT, set_intersect(scene, &o));
    o.absolute_tolerance = -1;
    REFUSED(ARGUMENT, set_intersect(scene, &o));
#undef REFUSED
    after = drawn(scene, 1); /* a refused value leaves the scene as it was */
    assert_same_picture(before, after);
    free(after);
    assert_int_equal(algsurf_scene_set_intersect(scene, NULL), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_extent(scene, NULL), ALGSURF_OK);
    after = drawn(scene, 1); /* the torus lies in the ball: all of space shows the same hits */
    assert_true(after->stats.hits == before->stats.hits);
    free(before), free(after);
    algsurf_scene_free(scene), algsurf_surface_free(surface);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pixel_by_pixel), cmocka_unit_test(preview_depth),     cmocka_unit_test(shadows),
        cmocka_unit_test(penumbra),       cmocka_unit_test(touching_is_drawn), cmocka_unit_test(far_eye),
        cmocka_unit_test(defaults),       cmocka_unit_test(bad_scene),
    };
    return cmocka_run_group_tests_name("render", tests, NULL, NULL);
}
