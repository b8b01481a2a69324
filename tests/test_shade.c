/* test_shade.c - light samples and the formulas of shading, against values worked out by hand.
 *
 * Breaks tried, each caught by the test named:
 *   normal not turned to the viewer, colours of the sides exchanged        sides
 *   highlight where N.L <= 0, highlight without the light's share          highlight, shares
 *   ambient multiplied by the share, ambient added once a light            shares
 *   light vector not normalised; overflow of far or near lights            distance
 *   sample grid from 0 to 1 instead of -1/2 to 1/2; u and v exchanged      samples
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include <fenv.h>
#include <math.h>
#include <string.h>

#include "algsurf/shade.h"

static const algsurf_material material = {.size = sizeof material,
                                          .outside = {0.8, 0.4, 0.2},
                                          .inside = {0.1, 0.3, 0.6},
                                          .ambient = 0.25,
                                          .diffuse = 0.5,
                                          .specular = 2,
                                          .shininess = 8};
static const double point[3] = {1, 2, 3}, up[3] = {0, 0, 1}, down[3] = {0, 0, -1};

/* A white point light in the given direction from the point. */
static algsurf_light light_towards(double x, double y, double z) {
    algsurf_light light = {.position = {point[0] + x, point[1] + y, point[2] + z},
                           .colour = {1, 1, 1},
                           .samples_u = 1,
                           .samples_v = 1};
    return light;
}

static void assert_near3(const double got[3], double x, double y, double z) {
    const double expected[3] = {x, y, z};
    for (int i = 0; i < 3; i++)
        if (!(fabs(got[i] - expected[i]) <= 1e-14 * (1 + fabs(expected[i]))))
            fail_msg("component %d is %.17g, not %.17g", i, got[i], expected[i]);
}

static void shade(const algsurf_light *lights, int count, const double *visible, const double normal[3],
                  const double direction[3], double colour[3]) {
    assert_int_equal(algsurf_shade(&material, lights, count, visible, point, normal, direction, colour),
                     ALGSURF_OK);
}

static void ambient_only(void **state) {
    double c[3];
    (void)state;
    shade(NULL, 0, NULL, up, down, c);
    assert_near3(c, 0.2, 0.1, 0.05);
}

/* Light from the viewer's own place, straight on: N.L = N.H = 1. */
static void head_on(void **state) {
    algsurf_light light = light_towards(0, 0, 7);
    double c[3];
    (void)state;
    light.colour[1] = 0.5, light.colour[2] = 0;
    shade(&light, 1, NULL, up, down, c);
    assert_near3(c, 0.2 + 0.4 + 2, 0.1 + 0.5 * (0.2 + 2), 0.05);
}

/* L at 60 degrees in the xz-plane, the viewer overhead: N.L = 1/2, N.H = cos 30. */
static void slanted(void **state) {
    algsurf_light light = light_towards(sqrt(3), 0, 1);
    double c[3], highlight = 2 * pow(0.75, 4); /* cos^8 30 */
    (void)state;
    shade(&light, 1, NULL, up, down, c);
    assert_near3(c, 0.2 + 0.2 + highlight, 0.1 + 0.1 + highlight, 0.05 + 0.05 + highlight);
}

/* The same place lit from the same side looks alike but for its colour, whichever way P grows. */
static void sides(void **state) {
    algsurf_light light = light_towards(sqrt(3), 0, 1), below = light_towards(0, 0, -1);
    double c[3], highlight = 2 * pow(0.75, 4);
    (void)state;
    shade(&light, 1, NULL, down, down, c); /* the normal points away: inside is seen */
    assert_near3(c, 0.025 + 0.025 + highlight, 0.075 + 0.075 + highlight, 0.15 + 0.15 + highlight);
    shade(&below, 1, NULL, down, down, c); /* lights the other side only */
    assert_near3(c, 0.025, 0.075, 0.15);
    shade(&below, 1, NULL, down, up, c);
    assert_near3(c, 0.2 + 0.4 + 2, 0.1 + 0.2 + 2, 0.05 + 0.1 + 2);
}

/* No highlight on a face turned from the light, though N.H > 0 there. */
static void highlight(void **state) {
    algsurf_light light = light_towards(1, 0, -0.1);
    const double sideways[3] = {0, 0, -1};
    double c[3];
    (void)state;
    shade(&light, 1, NULL, up, sideways, c);
    assert_near3(c, 0.2, 0.1, 0.05);
    light = light_towards(1, 0, 0); /* exactly in the tangent plane */
    shade(&light, 1, NULL, up, sideways, c);
    assert_near3(c, 0.2, 0.1, 0.05);
}

static void shares(void **state) {
    algsurf_light lights[3] = {light_towards(0, 0, 1), light_towards(0, 0, 2), light_towards(0, 0, 3)};
    const double visible[3] = {0.25, 0, 1};
    double c[3];
    (void)state;
    shade(lights, 3, visible, up, down, c);
    assert_near3(c, 0.2 + 1.25 * 2.4, 0.1 + 1.25 * 2.2, 0.05 + 1.25 * 2.1);
    shade(lights, 3, NULL, up, down, c);
    assert_near3(c, 0.2 + 3 * 2.4, 0.1 + 3 * 2.2, 0.05 + 3 * 2.1);
}

/* Only the direction of a light counts, from the smallest to the largest distance; a light at the
 * point itself has none. */
static void distance(void **state) {
    const double zero[3] = {0, 0, 0}, distances[5] = {1e-300, 1e-9, 1, 1e200, 1.7e308};
    double c[3], bright = 2 * pow(0.75, 4);
    (void)state;
    for (int k = 0; k < 5; k++) {
        algsurf_light light = {.colour = {1, 1, 1}, .samples_u = 1, .samples_v = 1};
        light.position[0] = distances[k] * sqrt(0.75), light.position[2] = distances[k] * 0.5;
        assert_int_equal(algsurf_shade(&material, &light, 1, NULL, zero, up, down, c), ALGSURF_OK);
        assert_near3(c, 0.4 + bright, 0.2 + bright, 0.1 + bright);
    }
    algsurf_light light = {.colour = {1, 1, 1}, .samples_u = 1, .samples_v = 1};
    assert_int_equal(algsurf_shade(&material, &light, 1, NULL, zero, up, down, c), ALGSURF_OK);
    assert_near3(c, 0.2, 0.1, 0.05);
    const double lowest[3] = {0, 0, -1.7e308};
    light.position[2] = 1.7e308;
    assert_int_equal(algsurf_shade(&material, &light, 1, NULL, lowest, up, down, c), ALGSURF_OK);
    assert_near3(c, 0.2 + 0.4 + 2, 0.1 + 0.2 + 2, 0.05 + 0.1 + 2);
}

static void singular_point(void **state) {
    const double zero[3] = {0, -0.0, 0}, direction[3] = {0.6, 0, -0.8};
    algsurf_light light = light_towards(-0.6, 0, 0.8);
    double c[3];
    (void)state;
    shade(&light, 1, NULL, zero, direction, c);
    assert_near3(c, 0.2 + 0.4 + 2, 0.1 + 0.2 + 2, 0.05 + 0.1 + 2);
}

static void preview(void **state) {
    double near[3], middle[3], far[3];
    (void)state;
    assert_int_equal(algsurf_shade_preview(&material, up, down, 0, near), ALGSURF_OK);
    assert_int_equal(algsurf_shade_preview(&material, up, down, 0.5, middle), ALGSURF_OK);
    assert_int_equal(algsurf_shade_preview(&material, up, down, 1, far), ALGSURF_OK);
    assert_near3(near, 0.8, 0.4, 0.2);
    assert_near3(middle, 0.65 * 0.8, 0.65 * 0.4, 0.65 * 0.2);
    assert_near3(far, 0.3 * 0.8, 0.3 * 0.4, 0.3 * 0.2);
    assert_int_equal(algsurf_shade_preview(&material, up, up, 0, near), ALGSURF_OK);
    assert_near3(near, 0.1, 0.3, 0.6);
}

static void samples(void **state) {
    algsurf_light light = {.position = {10, 20, 30},
                           .colour = {1, 1, 1},
                           .edge_u = {8, 0, 0},
                           .edge_v = {0, 4, 2},
                           .samples_u = 5,
                           .samples_v = 3};
    double p[3];
    (void)state;
    assert_int_equal(algsurf_light_sample(&light, 0, 0, p), ALGSURF_OK);
    assert_near3(p, 6, 18, 29);
    assert_int_equal(algsurf_light_sample(&light, 4, 2, p), ALGSURF_OK);
    assert_near3(p, 14, 22, 31);
    assert_int_equal(algsurf_light_sample(&light, 1, 1, p), ALGSURF_OK);
    assert_near3(p, 8, 20, 30);
    light.samples_u = 1;
    assert_int_equal(algsurf_light_sample(&light, 0, 2, p), ALGSURF_OK);
    assert_near3(p, 10, 22, 31);
    light.samples_u = 64, light.samples_v = 1;
    assert_int_equal(algsurf_light_sample(&light, 63, 0, p), ALGSURF_OK);
    assert_near3(p, 14, 20, 30);
}

static void refuse_sample(const algsurf_light *light, int a, int b, algsurf_status expected) {
    double p[3] = {7, 8, 9};
    assert_int_equal(algsurf_light_sample(light, a, b, p), expected);
    assert_true(p[0] == 7 && p[1] == 8 && p[2] == 9);
}

static void bad_samples(void **state) {
    const algsurf_light good = {.colour = {1, 1, 1}, .samples_u = 3, .samples_v = 2};
    const struct { int u, v; } counts[4] = {{0, 2}, {65, 2}, {3, -1}, {3, 65}};
    (void)state;
    refuse_sample(NULL, 0, 0, ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_light_sample(&good, 0, 0, NULL), ALGSURF_E_ARGUMENT);
    refuse_sample(&good, 3, 0, ALGSURF_E_ARGUMENT);
    refuse_sample(&good, 0, 2, ALGSURF_E_ARGUMENT);
    refuse_sample(&good, -1, 0, ALGSURF_E_ARGUMENT);
    refuse_sample(&good, 0, -1, ALGSURF_E_ARGUMENT);
    for (int k = 0; k < 4; k++) {
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
        light = good, light.colour[i] = -0x1p-1074;
        refuse_sample(&light, 0, 0, ALGSURF_E_ARGUMENT);
    }
}

/* Both shaders with one argument spoiled. */
static void refuse_shade(const algsurf_material *m, const algsurf_light *lights, int count,
                         const double *visible, const double *p, const double *normal,
                         const double *direction, algsurf_status expected) {
    double c[3] = {7, 8, 9};
    assert_int_equal(algsurf_shade(m, lights, count, visible, p, normal, direction, c), expected);
    assert_true(c[0] == 7 && c[1] == 8 && c[2] == 9);
}

static void refuse_material(const algsurf_material *m, algsurf_status expected) {
    double c[3] = {7, 8, 9};
    refuse_shade(m, NULL, 0, NULL, point, up, down, expected);
    assert_int_equal(algsurf_shade_preview(m, up, down, 0.5, c), expected);
    assert_true(c[0] == 7 && c[1] == 8 && c[2] == 9);
}

static void bad_shade(void **state) {
    algsurf_light light = light_towards(0, 0, 1);
    const double nowhere[3] = {0, NAN, 0}, low = -0.1, high = 1.1, not_a_number = NAN;
    double c[3] = {7, 8, 9};
    (void)state;
    refuse_shade(NULL, &light, 1, NULL, point, up, down, ALGSURF_E_ARGUMENT);
    refuse_shade(&material, NULL, 1, NULL, point, up, down, ALGSURF_E_ARGUMENT);
    refuse_shade(&material, &light, -1, NULL, point, up, down, ALGSURF_E_ARGUMENT);
    refuse_shade(&material, &light, 1, &low, point, up, down, ALGSURF_E_ARGUMENT);
    refuse_shade(&material, &light, 1, &high, point, up, down, ALGSURF_E_ARGUMENT);
    refuse_shade(&material, &light, 1, &not_a_number, point, up, down, ALGSURF_E_ARGUMENT);
    refuse_shade(&material, &light, 1, NULL, NULL, up, down, ALGSURF_E_ARGUMENT);
    refuse_shade(&material, &light, 1, NULL, point, NULL, down, ALGSURF_E_ARGUMENT);
    refuse_shade(&material, &light, 1, NULL, point, up, NULL, ALGSURF_E_ARGUMENT);
    refuse_shade(&material, &light, 1, NULL, nowhere, up, down, ALGSURF_E_NOT_FINITE);
    refuse_shade(&material, &light, 1, NULL, point, nowhere, down, ALGSURF_E_NOT_FINITE);
    refuse_shade(&material, &light, 1, NULL, point, up, nowhere, ALGSURF_E_NOT_FINITE);
    light.samples_v = 0;
    refuse_shade(&material, &light, 1, NULL, point, up, down, ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_shade(&material, NULL, 0, NULL, point, up, down, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_shade_preview(&material, up, down, 0, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_shade_preview(&material, NULL, down, 0, c), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_shade_preview(&material, up, NULL, 0, c), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_shade_preview(&material, up, nowhere, 0, c), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_shade_preview(&material, up, down, low, c), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_shade_preview(&material, up, down, high, c), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_shade_preview(&material, up, down, NAN, c), ALGSURF_E_ARGUMENT);
    assert_true(c[0] == 7 && c[1] == 8 && c[2] == 9);
}

static void bad_material(void **state) {
    const size_t doubles = offsetof(algsurf_material, shininess) / sizeof(double);
    (void)state;
    refuse_material(NULL, ALGSURF_E_ARGUMENT);
    for (size_t i = 1; i <= doubles; i++) { /* each colour component and weight, and the shininess */
        algsurf_material m = material;
        double *field = (double *)(void *)((char *)&m + i * sizeof(double));
        *field = -1;
        refuse_material(&m, ALGSURF_E_ARGUMENT);
        *field = NAN;
        refuse_material(&m, ALGSURF_E_NOT_FINITE);
        *field = INFINITY;
        refuse_material(&m, ALGSURF_E_NOT_FINITE);
    }
    algsurf_material m = material;
    m.shininess = 0;
    refuse_material(&m, ALGSURF_E_ARGUMENT);
}

static void rounding_modes(void **state) {
    static const int modes[4] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    const double normal[3] = {0.48, 0.6, 0.64}, direction[3] = {-0.6, 0, -0.8};
    algsurf_light light = light_towards(1.1, 2.2, 3.3);
    double c[4][3];
    (void)state;
    for (int m = 0; m < 4; m++) {
        fesetround(modes[m]);
        algsurf_status status = algsurf_shade(&material, &light, 1, NULL, point, normal, direction, c[m]);
        int mode = fegetround();
        fesetround(FE_TONEAREST);
        assert_int_equal(status, ALGSURF_OK);
        assert_int_equal(mode, modes[m]);
        assert_memory_equal(c[m], c[0], sizeof c[0]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ambient_only), cmocka_unit_test(head_on),        cmocka_unit_test(slanted),
        cmocka_unit_test(sides),        cmocka_unit_test(highlight),      cmocka_unit_test(shares),
        cmocka_unit_test(distance),     cmocka_unit_test(singular_point), cmocka_unit_test(preview),
        cmocka_unit_test(samples),      cmocka_unit_test(bad_samples),    cmocka_unit_test(bad_shade),
        cmocka_unit_test(bad_material), cmocka_unit_test(rounding_modes),
    };
    return cmocka_run_group_tests_name("shade", tests, NULL, NULL);
}
