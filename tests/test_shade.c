/* test_shade.c - light samples and colours of points, against the formula and values worked out by hand.
 *
 * Breaks tried, each caught by the test named:
 *   normal not turned to the viewer, colours or richness of the sides exchanged       sides
 *   black shadows, openness from the first light's share                              shares
 *   fill without N.V, the edge squared only                                           edge_on, random_points
 *   where soft light ends, how a highlight fades, its shape                           random_points
 *   highlights without a limit                                                        burnt_out
 *   haze by z, none of the unbounded; openness of what is outside                     depth
 *   singular points seen edge-on, or not facing                                       singular_point
 *   far lights kept near by each component, or out of the range of double             distance
 *   haze, a vector's length, the last share, 0 samples one way unchecked              bad_material,
 * bad_shade, bad_lighting a sample beyond the last one bad_samples
 */
#include "exact.h"
#include "shade_reference.h"
#include "unit.h"

static const uint64_t seed = 20261123;
static const algsurf_material material = {.size = sizeof material,
                                          .outside = {0.5, 0.5, 0.5},
                                          .inside = {1, 0, 0},
                                          .diffuse = 0.5,
                                          .ambient = 0.1,
                                          .fill = 0.15,
                                          .specular = 0.4,
                                          .roughness = 0.3,
                                          .haze = 0.4};
static const double point[3] = {1, 2, 3}, up[3] = {0, 0, 1}, down[3] = {0, 0, -1}, sideways[3] = {1, 0, 0};

/* A white point light in the given direction from the point. */
static algsurf_light light_towards(double x, double y, double z) {
    algsurf_light light = {.position = {point[0] + x, point[1] + y, point[2] + z},
                           .colour = {1, 1, 1},
                           .samples_u = 1,
                           .samples_v = 1};
    return light;
}

/* Not bounded, up and away from the viewer level with the point: ambient light and haze are as on the
 * average. */
static algsurf_lighting lighting_of(const algsurf_light *lights, size_t count) {
    return (algsurf_lighting){.size = sizeof(algsurf_lighting),
                              .material = &material,
                              .lights = lights,
                              .light_count = count,
                              .up = {0, 1, 0},
                              .forward = {0, 0, -1},
                              .radius = 2};
}

static void assert_near3(const double got[3], double x, double y, double z, double tolerance) {
    const double expected[3] = {x, y, z};
    for (int i = 0; i < 3; i++)
        if (!(fabs(got[i] - expected[i]) <= tolerance))
            fail_msg("component %d is %.9g, not %.9g", i, got[i], expected[i]);
}

/* What a grey point shows that so much light arrives at, and a highlight. */
static double grey(double light, double highlight) {
    double c = 0.5 * fmin(light, 1);
    c += (1 - c) * highlight;
    return c + (0.5 - c) * 0.4 * 0.25;
}

static void check_grey(const algsurf_lighting *lighting, const double *visible, const double normal[3],
                       const double direction[3], double light, double highlight) {
    double c[3], expected = grey(light, highlight);
    assert_ok(algsurf_shade(lighting, visible, point, normal, direction, c));
    assert_near3(c, expected, expected, expected, 1e-6);
}

/* From straight on N.L = N.V = 1, and the highlight is at its best; from behind there is none; from 60
 * degrees N.L = 1/2, h = 3, and (N.L + N.V)^2 = 9/4. */
TEST(one_light) {
    algsurf_light light = light_towards(0, 0, 7);
    const algsurf_lighting lighting = lighting_of(&light, 1), none = lighting_of(NULL, 0);
    double r = 0.09, g = r * 3 / (3 - (1 - r) * 2.25);
    check_grey(&none, NULL, up, down, 0.25, 0);
    check_grey(&lighting, NULL, up, down, 0.75, 0.4);
    light = light_towards(0, 0, -3);
    check_grey(&lighting, NULL, up, down, 0.25, 0);
    light = light_towards(sqrt(3), 0, 1);
    check_grey(&lighting, NULL, up, down, 0.5, 0.4 * g * g);
    light = light_towards(2, 1, 0); /* in the tangent plane: 1/16 */
    check_grey(&lighting, NULL, up, down, 0.25 + 0.5 / 16, 0);
    light = light_towards(-sqrt(15), 0, -1); /* where all light ends */
    check_grey(&lighting, NULL, up, down, 0.25, 0);
    light = light_towards(0, 0, 0); /* at the point: it comes from nowhere */
    check_grey(&lighting, NULL, up, down, 0.25 + 0.5 / 16, 0);
}

/* Seen edge-on there is no light from the eye, and 0.65 of all the others. */
TEST(edge_on) {
    algsurf_light light = light_towards(0, 0, 2);
    const algsurf_lighting lighting = lighting_of(&light, 1);
    double r = 0.09, g = r * 2 / (2 - (1 - r));
    check_grey(&lighting, NULL, up, sideways, 0.65 * 0.6, 0.4 * g * g);
}

/* The same place lit from the same side looks alike but for its colour, whichever way P grows; the shade of
 * a colour is richer than it. */
TEST(sides) {
    algsurf_light light = light_towards(0, 0, -1);
    const algsurf_lighting lighting = lighting_of(&light, 1);
    double c[3], red = 0.25 * (1 + 0.75 * 0.75 * 2.4), red_lit = 0.75 * (1 + 0.25 * 0.25 * 2.4);
    check_grey(&lighting, NULL, down, up, 0.75, 0.4);
    assert_ok(algsurf_shade(&lighting, NULL, point, up, up, c));
    assert_near3(c, 0.9 * (red_lit + 0.4 * (1 - red_lit)) + 0.1, 0.9 * 0.4, 0.9 * 0.4, 1e-6);
    light = light_towards(0, 0, 1); /* lights the other side only */
    assert_ok(algsurf_shade(&lighting, NULL, point, up, up, c));
    assert_near3(c, 0.9 * red + 0.1, 0, 0, 1e-6);
    check_grey(&lighting, NULL, up, down, 0.75, 0.4);
}

/* No shadow is black: 0.15 of the light is left where there is none, of each light and of what is around. */
TEST(shares) {
    algsurf_light lights[2] = {light_towards(0, 0, 1), light_towards(0, 0, 3)};
    const algsurf_lighting one = lighting_of(lights, 1), two = lighting_of(lights, 2);
    const double all[3] = {1, 1, 1}, dark[3] = {0, 0, 0}, some[3] = {0.5, 1, 0.25}, last[2] = {1, 0};
    double k = 0.15 + 0.85 * 0.5, o = 0.15 + 0.85 * 0.25;
    check_grey(&one, all, up, down, 0.75, 0.4);
    check_grey(&two, NULL, up, down, 1.25, 1 - 0.6 * 0.6);
    check_grey(&two, all, up, down, 1.25, 1 - 0.6 * 0.6);
    check_grey(&one, dark, up, down, 0.15 * 0.6 + 0.15 * (0.35 + 0.65 * 0.15), 0.15 * 0.4);
    check_grey(&one, last, up, down, 0.5 + 0.1 * 0.15 + 0.15 * (0.35 + 0.65 * 0.15), 0.4);
    check_grey(&two, some, up, down, 0.5 * (k + 1) + 0.1 * o + 0.15 * (0.35 + 0.65 * o),
               1 - (1 - 0.4 * k) * 0.6);
}

/* Only the direction of a light counts, from the smallest to the largest distance. */
TEST(distance) {
    static const double distances[] = {1e-30, 1e-9, 1, 1e9, 1e13, 1e20, 1e200, 1.7e308};
    const double zero[3] = {0, 0, 0}, direction[3] = {0.28, 0, -0.96};
    for (size_t k = 0; k < sizeof distances / sizeof distances[0]; k++)
        for (int around = 0; around < 4; around++) {
            algsurf_light light = {.colour = {1, 1, 1}, .samples_u = 1, .samples_v = 1};
            algsurf_lighting lighting = lighting_of(&light, 1);
            double c[3], expected[3], s = distances[k];
            light.position[0] = s * (around & 1 ? 0.4 : -0.4),
            light.position[1] = s * (around & 2 ? 0.2 : 0.6);
            light.position[2] = s * 0.7;
            lighting.radius = s < 1e-12 ? s : 1;
            assert_ok(algsurf_shade(&lighting, NULL, zero, up, direction, c));
            reference_shade(&lighting, NULL, zero, up, direction, expected);
            assert_near3(c, expected[0], expected[1], expected[2], 1e-5);
        }
    algsurf_light light = {.position = {0, 0, 1e-300}, .colour = {1, 1, 1}, .samples_u = 1, .samples_v = 1};
    algsurf_lighting lighting = lighting_of(&light, 1);
    double c[3];
    assert_ok(algsurf_shade(&lighting, NULL, zero, up, down, c)); /* as at the point */
    assert_near3(c, grey(0.25 + 0.5 / 16, 0), c[0], c[0], 1e-6);
    const double lowest[3] = {0, 0, -1.7e308};
    for (int i = 0; i < 3; i++) lighting.centre[i] = lowest[i];
    light.position[2] = 1.7e308;
    assert_ok(algsurf_shade(&lighting, NULL, lowest, up, down, c));
    assert_near3(c, grey(0.75, 0.4), c[0], c[0], 1e-6);
}

/* As if it faced the viewer, from outside. */
TEST(singular_point) {
    const double zero[3] = {0, -0.0, 0}, direction[3] = {0.6, 0, -0.8};
    algsurf_light light = light_towards(-0.6, 0, 0.8);
    const algsurf_lighting lighting = lighting_of(&light, 1);
    check_grey(&lighting, NULL, zero, direction, 0.75, 0.4);
}

/* In the middle of a ball it is a radius to its end; on it, towards the middle, two; the farthest end is
 * half of its base colour where haze is half. */
TEST(depth) {
    algsurf_lighting lighting = lighting_of(NULL, 0);
    const double near[3] = {1, 2, 5}, far[3] = {1, 2, 1}, outside[3] = {1, 2, -97};
    const double fill = 0.35, less = 0.65;
    double c[3], e;
    lighting.bounded = 1;
    for (int i = 0; i < 3; i++) lighting.centre[i] = point[i];
    e = 0.1 * 0.7 + 0.15 * (fill + less * 0.7);
    check_grey(&lighting, NULL, up, down, e, 0);
    assert_ok(algsurf_shade(&lighting, NULL, near, up, down, c));
    assert_near3(c, 0.5 * 0.25, c[0], c[0], 1e-6); /* all open, no haze */
    e = 0.1 * 0.4 + 0.15 * (fill + less * 0.4);
    assert_ok(algsurf_shade(&lighting, NULL, far, up, down, c));
    assert_near3(c, 0.5 * (e + (1 - e) * 0.4), c[0], c[0], 1e-6);
    assert_ok(algsurf_shade(&lighting, NULL, outside, up, down, c));
    assert_near3(c, 0.5 * (e + (1 - e) * 0.4), c[0], c[0], 1e-6);
}

TEST(preview) {
    const algsurf_lighting lighting = lighting_of(NULL, 0);
    double c[3], e = 0.86;
    assert_ok(algsurf_shade_preview(&lighting, point, up, down, c));
    assert_near3(c, 0.5 * (e + (1 - e) * 0.075), c[0], c[0], 1e-6);
    e = 0.20 + 0.12; /* edge-on, looking up */
    const double y_axis[3] = {0, 1, 0};
    assert_ok(algsurf_shade_preview(&lighting, point, y_axis, sideways, c));
    assert_near3(c, 0.5 * (e + (1 - e) * 0.075), c[0], c[0], 1e-6);
    assert_ok(algsurf_shade_preview(&lighting, point, up, up, c));
    assert_true(c[0] > 0.8 && c[1] == 0 && c[2] == 0);
}

static double share(uint64_t *state) { return fabs(random_unit(state)); }

/* All that a colour depends on. */
typedef struct random_case {
    algsurf_material material;
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting;
    double visible[ALGSURF_MAX_LIGHTS + 1], point[3], normal[3], direction[3];
} random_case;

static void random_material(uint64_t *state, double least_roughness, algsurf_material *m) {
    *m = (algsurf_material){.size = sizeof *m,
                            .diffuse = share(state),
                            .ambient = share(state),
                            .fill = share(state),
                            .specular = share(state),
                            .roughness = least_roughness + (1 - least_roughness) * share(state),
                            .haze = share(state)};
    for (int i = 0; i < 3; i++) m->outside[i] = share(state), m->inside[i] = share(state);
    if (random_int(state, 8) == 0) m->inside[random_int(state, 3)] = 0;
    if (random_int(state, 50) == 0) m->outside[0] = m->outside[1] = m->outside[2] = 0;
}

/* Lights at least a tenth of the radius from the point, some straight behind what is seen edge-on; points in
 * the ball, on it and outside. */
static void random_look(uint64_t *state, double least_roughness, random_case *r) {
    double scale = ldexp(1, random_int(state, 40) - 20), far = random_int(state, 2) ? 1 : 3;
    random_material(state, least_roughness, &r->material);
    r->lighting = (algsurf_lighting){.size = sizeof r->lighting,
                                     .material = &r->material,
                                     .lights = r->lights,
                                     .light_count = (size_t)random_int(state, ALGSURF_MAX_LIGHTS + 1),
                                     .radius = scale,
                                     .bounded = random_int(state, 2)};
    random_direction(state, r->lighting.up), random_direction(state, r->lighting.forward);
    random_direction(state, r->normal), random_direction(state, r->direction);
    for (int i = 0; i < 3; i++) {
        r->lighting.centre[i] = scale * random_unit(state);
        r->point[i] = r->lighting.centre[i] + 0.6 * far * scale * random_unit(state);
        if (random_int(state, 30) == 0) r->normal[0] = r->normal[1] = r->normal[2] = 0;
    }
    for (size_t l = 0; l < r->lighting.light_count; l++) {
        double way[3], distance = scale * (0.1 + 16 * share(state) * share(state));
        random_direction(state, way);
        if (random_int(state, 10) == 0) memcpy(way, r->direction, sizeof way);
        r->lights[l] = (algsurf_light){.samples_u = 1, .samples_v = 1};
        for (int i = 0; i < 3; i++) {
            r->lights[l].position[i] = r->point[i] + distance * way[i];
            r->lights[l].colour[i] = share(state);
        }
    }
    for (int l = 0; l <= ALGSURF_MAX_LIGHTS; l++) {
        int kind = random_int(state, 3);
        r->visible[l] = kind < 2 ? kind : share(state);
    }
}

/* Counts differences from the formula above 1e-5; returns the largest. */
static double add_differences(const double got[3], const double expected[3], int *many) {
    double largest = 0;
    for (int i = 0; i < 3; i++) {
        double off = fabs(got[i] - expected[i]);
        if (!(got[i] >= 0 && got[i] <= 1)) fail_msg("%g", got[i]);
        *many += off > 1e-5;
        largest = fmax(largest, off);
    }
    return largest;
}

TEST(random_points) {
    enum { CASES = 100000 };
    uint64_t random = seed;
    double largest = 0;
    int many = 0;
    for (int k = 0; k < CASES; k++) {
        static random_case r;
        double c[3], expected[3];
        random_look(&random, 0.1, &r);
        const double *visible = k % 2 ? r.visible : NULL;
        assert_ok(algsurf_shade(&r.lighting, visible, r.point, r.normal, r.direction, c));
        reference_shade(&r.lighting, visible, r.point, r.normal, r.direction, expected);
        largest = fmax(largest, add_differences(c, expected, &many));
        assert_ok(algsurf_shade_preview(&r.lighting, r.point, r.normal, r.direction, c));
        reference_preview(&r.lighting, r.point, r.normal, r.direction, expected);
        assert_true(add_differences(c, expected, &many) < 1e-6);
    }
    printf("largest difference from the formula: %.2g; above 1e-5: %d of %d\n", largest, many, 6 * CASES);
    if (!(largest <= 5e-5 && many < CASES / 10000)) fail_msg("seed %llu", (unsigned long long)seed);
}

/* However bright the lights and however sharp the highlights. */
TEST(nothing_exceeds_one) {
    uint64_t random = seed + 2;
    int full = 0;
    for (int k = 0; k < 20000; k++) {
        static random_case r;
        double c[3];
        random_look(&random, 0.2, &r);
        r.material.roughness = k % 4 == 0 ? 1e-300 : k % 4 == 1 ? 1e-3 : k % 4 == 2 ? 0.05 : 1;
        r.material.specular = r.material.diffuse = 1;
        for (size_t l = 0; l < r.lighting.light_count; l++)
            for (int i = 0; i < 3; i++) r.lights[l].colour[i] *= 1000;
        assert_ok(algsurf_shade(&r.lighting, NULL, r.point, r.normal, r.direction, c));
        for (int i = 0; i < 3; i++) assert_true(c[i] >= 0 && c[i] <= 1);
        full += c[0] > 0.999;
    }
    assert_true(full > 50);
}

/* Highlights that are full in every channel are white, no more, and no less where there are two. */
TEST(burnt_out) {
    algsurf_material shiny = material;
    algsurf_light lights[2] = {light_towards(0, 0, 1), light_towards(0, 0, 2)};
    double c[3];
    shiny.haze = 0, shiny.specular = 1;
    for (int i = 0; i < 6; i++) lights[i / 3].colour[i % 3] = 1000;
    for (int count = 1; count <= 2; count++) {
        algsurf_lighting lighting = lighting_of(lights, (size_t)count);
        lighting.material = &shiny;
        assert_ok(algsurf_shade(&lighting, NULL, point, up, down, c));
        assert_true(c[0] == 1 && c[1] == 1 && c[2] == 1);
    }
}

TEST(samples) {
    algsurf_light light = {.position = {10, 20, 30},
                           .colour = {1, 1, 1},
                           .edge_u = {8, 0, 0},
                           .edge_v = {0, 4, 2},
                           .samples_u = 5,
                           .samples_v = 3};
    double p[3];
    assert_ok(algsurf_light_sample(&light, 0, 0, p));
    assert_near3(p, 6, 18, 29, 1e-14);
    assert_ok(algsurf_light_sample(&light, 4, 2, p));
    assert_near3(p, 14, 22, 31, 1e-14);
    assert_ok(algsurf_light_sample(&light, 1, 1, p));
    assert_near3(p, 8, 20, 30, 1e-14);
    light.samples_u = 1;
    assert_ok(algsurf_light_sample(&light, 0, 2, p));
    assert_near3(p, 10, 22, 31, 1e-14);
    light.samples_u = 64, light.samples_v = 1;
    assert_ok(algsurf_light_sample(&light, 63, 0, p));
    assert_near3(p, 14, 20, 30, 1e-14);
}

static void refuse_sample(const algsurf_light *light, int a, int b, algsurf_status expected) {
    double p[3] = {7, 8, 9};
    assert_int_equal(algsurf_light_sample(light, a, b, p), expected);
    assert_true(p[0] == 7 && p[1] == 8 && p[2] == 9);
}

TEST(bad_samples) {
    const algsurf_light good = {.colour = {1, 1, 1}, .samples_u = 3, .samples_v = 2};
    const struct { int u, v; } counts[6] = {{0, 2}, {65, 2}, {3, -1}, {3, 65}, {3, 0}, {0, 0}};
    refuse_sample(NULL, 0, 0, ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_light_sample(&good, 0, 0, NULL), ALGSURF_E_ARGUMENT);
    refuse_sample(&good, 3, 0, ALGSURF_E_ARGUMENT);
    refuse_sample(&good, 0, 2, ALGSURF_E_ARGUMENT);
    refuse_sample(&good, -1, 0, ALGSURF_E_ARGUMENT);
    refuse_sample(&good, 0, -1, ALGSURF_E_ARGUMENT);
    for (int k = 0; k < 6; k++) {
        algsurf_light light = good;
        light.samples_u = counts[k].u, light.samples_v = counts[k].v;
        refuse_sample(&light, 0, 0, ALGSURF_E_ARGUMENT);
    }
    for (int i = 0; i < 3; i++) {
        algsurf_light light = good;
        light.position[i] = NAN;
        refuse_sample(&light, 0, 0, ALGSURF_E_NOT_FINITE);
        light = good, light.edge_u[i] = INFINITY;
        refuse_sample(&light, 0, 0, ALGSURF_E_NOT_FINITE);
        light = good, light.edge_v[i] = -INFINITY;
        refuse_sample(&light, 0, 0, ALGSURF_E_NOT_FINITE);
        light = good, light.colour[i] = NAN;
        refuse_sample(&light, 0, 0, ALGSURF_E_NOT_FINITE);
        light = good, light.position[i] = light.edge_u[i] = 0x1.8p1023; /* their sum overflows */
        refuse_sample(&light, 2, 0, ALGSURF_E_NOT_FINITE);
        light = good, light.colour[i] = -0x1p-1074;
        refuse_sample(&light, 0, 0, ALGSURF_E_ARGUMENT);
        light = good, light.colour[i] = 1000.001;
        refuse_sample(&light, 0, 0, ALGSURF_E_ARGUMENT);
    }
    for (int kind = -2; kind <= 2; kind++) {
        algsurf_light light = good;
        light.kind = kind;
        if (kind != ALGSURF_LIGHT_AREA) refuse_sample(&light, 0, 0, ALGSURF_E_ARGUMENT);
    }
    for (int i = 0; i < 8; i++) {
        const double not_zero[] = {1, -0x1p-1074, NAN, INFINITY};
        double p[3];
        algsurf_light light = good;
        light.reserved[i] = -0.0;
        assert_ok(algsurf_light_sample(&light, 0, 0, p));
        for (int k = 0; k < 4; k++) {
            light.reserved[i] = not_zero[k];
            refuse_sample(&light, 0, 0, ALGSURF_E_ARGUMENT);
        }
    }
}

/* algsurf_shade with one argument spoiled. */
static void refuse_shade(const algsurf_lighting *lighting, const double *visible, const double *p,
                         const double *normal, const double *direction, algsurf_status expected) {
    double c[3] = {7, 8, 9};
    assert_int_equal(algsurf_shade(lighting, visible, p, normal, direction, c), expected);
    assert_true(c[0] == 7 && c[1] == 8 && c[2] == 9);
}

/* Both shaders with something of the lighting spoiled. */
static void refuse_lighting(const algsurf_lighting *lighting, algsurf_status expected) {
    double c[3] = {7, 8, 9};
    refuse_shade(lighting, NULL, point, up, down, expected);
    assert_int_equal(algsurf_shade_preview(lighting, point, up, down, c), expected);
    assert_true(c[0] == 7 && c[1] == 8 && c[2] == 9);
}

static void refuse_look(const double *p, const double *normal, const double *direction,
                        algsurf_status expected) {
    const algsurf_lighting lighting = lighting_of(NULL, 0);
    double c[3] = {7, 8, 9};
    refuse_shade(&lighting, NULL, p, normal, direction, expected);
    assert_int_equal(algsurf_shade_preview(&lighting, p, normal, direction, c), expected);
    assert_true(c[0] == 7 && c[1] == 8 && c[2] == 9);
}

TEST(bad_shade) {
    algsurf_light light = light_towards(0, 0, 1);
    const algsurf_lighting good = lighting_of(&light, 1);
    const double nowhere[3] = {0, NAN, 0}, longer[3] = {0, 0, 1.00001}, bad[3] = {-0.1, 1.1, NAN};
    double c[3] = {7, 8, 9};
    refuse_look(NULL, up, down, ALGSURF_E_ARGUMENT);
    refuse_look(point, NULL, down, ALGSURF_E_ARGUMENT);
    refuse_look(point, up, NULL, ALGSURF_E_ARGUMENT);
    refuse_look(nowhere, up, down, ALGSURF_E_NOT_FINITE);
    refuse_look(point, nowhere, down, ALGSURF_E_NOT_FINITE);
    refuse_look(point, up, nowhere, ALGSURF_E_NOT_FINITE);
    refuse_look(point, longer, down, ALGSURF_E_ARGUMENT);
    refuse_look(point, up, longer, ALGSURF_E_ARGUMENT);
    const double zero[3] = {0, 0, 0};
    refuse_look(point, up, zero, ALGSURF_E_ARGUMENT);
    for (int k = 0; k < 3; k++) {
        const double first[2] = {bad[k], 1}, last[2] = {1, bad[k]};
        const algsurf_status why = k < 2 ? ALGSURF_E_ARGUMENT : ALGSURF_E_NOT_FINITE;
        refuse_shade(&good, first, point, up, down, why);
        refuse_shade(&good, last, point, up, down, why);
    }
    assert_int_equal(algsurf_shade(&good, NULL, point, up, down, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_shade_preview(&good, point, up, down, NULL), ALGSURF_E_ARGUMENT);
    assert_ok(algsurf_shade(&good, NULL, point, up, down, c));
}

TEST(bad_lighting) {
    algsurf_light lights[17];
    for (int l = 0; l < 17; l++) lights[l] = light_towards(0, 0, 1);
    const algsurf_lighting good = lighting_of(lights, 2);
    algsurf_lighting l = good;
    refuse_lighting(NULL, ALGSURF_E_ARGUMENT);
    l.size = 4;
    refuse_lighting(&l, ALGSURF_E_SIZE);
    l = good, l.material = NULL;
    refuse_lighting(&l, ALGSURF_E_ARGUMENT);
    l = good, l.lights = NULL;
    refuse_lighting(&l, ALGSURF_E_ARGUMENT);
    l = good, l.light_count = SIZE_MAX;
    refuse_lighting(&l, ALGSURF_E_ARGUMENT);
    l = good, l.light_count = 17;
    refuse_lighting(&l, ALGSURF_E_ARGUMENT);
#if SIZE_MAX > UINT32_MAX
    l.light_count = (size_t)1 << 32; /* 0 as an int */
    refuse_lighting(&l, ALGSURF_E_ARGUMENT);
#endif
    lights[1].kind = 1;
    refuse_lighting(&good, ALGSURF_E_ARGUMENT);
    lights[1].kind = ALGSURF_LIGHT_AREA, lights[1].reserved[0] = NAN;
    refuse_lighting(&good, ALGSURF_E_ARGUMENT);
    lights[1].reserved[0] = 0;
    lights[1].samples_v = 0;
    refuse_lighting(&good, ALGSURF_E_ARGUMENT);
    lights[1].samples_v = 1, lights[1].position[2] = NAN;
    refuse_lighting(&good, ALGSURF_E_NOT_FINITE);
    lights[1].position[2] = 0;
    l = good, l.radius = 0;
    refuse_lighting(&l, ALGSURF_E_ARGUMENT);
    l.radius = -1;
    refuse_lighting(&l, ALGSURF_E_ARGUMENT);
    l.radius = INFINITY;
    refuse_lighting(&l, ALGSURF_E_NOT_FINITE);
    for (int i = 0; i < 3; i++) {
        l = good, l.up[i] = NAN;
        refuse_lighting(&l, ALGSURF_E_NOT_FINITE);
        l = good, l.forward[i] = INFINITY;
        refuse_lighting(&l, ALGSURF_E_NOT_FINITE);
        l = good, l.centre[i] = NAN;
        refuse_lighting(&l, ALGSURF_E_NOT_FINITE);
        l = good, l.up[i] += 0.1;
        refuse_lighting(&l, ALGSURF_E_ARGUMENT);
        l = good, l.forward[i] += 0.1;
        refuse_lighting(&l, ALGSURF_E_ARGUMENT);
    }
}

TEST(bad_material) {
    const size_t doubles = offsetof(algsurf_material, haze) / sizeof(double);
    algsurf_material m;
    algsurf_lighting lighting = lighting_of(NULL, 0);
    lighting.material = &m;
    for (size_t i = 1; i <= doubles; i++) { /* each colour component and weight, roughness and haze */
        m = material;
        double *field = (double *)(void *)((char *)&m + i * sizeof(double));
        *field = -0x1p-1074;
        refuse_lighting(&lighting, ALGSURF_E_ARGUMENT);
        *field = 1.0000001;
        refuse_lighting(&lighting, ALGSURF_E_ARGUMENT);
        *field = NAN;
        refuse_lighting(&lighting, ALGSURF_E_NOT_FINITE);
        *field = INFINITY;
        refuse_lighting(&lighting, ALGSURF_E_NOT_FINITE);
    }
    m = material, m.roughness = 0;
    refuse_lighting(&lighting, ALGSURF_E_ARGUMENT);
    m = material, m.size = 0;
    refuse_lighting(&lighting, ALGSURF_E_SIZE);
}
