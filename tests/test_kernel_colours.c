/* test_kernel_colours.c - the colours of points by every kernel, against algsurf_shade.
 *
 * Breaks tried, each caught by the test named:
 *   normal not turned to the viewer, colours of the sides exchanged, a zero
 *   normal lit otherwise; a light's share forgotten, of another entry or light;
 *   an odd shininess as the even one below, a fraction cut off                 random_points
 *   light vectors squared without scaling                                      distance
 *   a highlight above 1 where the half-way vector is rounding                  backlight
 *   entries behind the last one written; lanes that depend on neighbours       same_bits
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include <string.h>

#include "algsurf/shade.h"
#include "exact.h"
#include "picture/kernel.h"
#include "base/vec.h"

enum { MOST = 200, SPARE = 8, LIGHTS = 4 };
static const uint64_t seed = 20240612;
static const char *const kernel_names[3] = {"baseline", "avx2", "avx512"};

/* Points: position, normal, direction; t plays no part. */
typedef struct batch {
    double at[10][MOST];
    double visible[MOST * LIGHTS];
} batch;

typedef struct colours {
    double rgb[3 * MOST + SPARE];
} colours;

static const algsurf_material material = {.size = sizeof material,
                                          .outside = {0.8, 0.4, 0.2},
                                          .inside = {0.1, 0.3, 0.6},
                                          .ambient = 0.25,
                                          .diffuse = 0.5,
                                          .specular = 2,
                                          .shininess = 8};

static algsurf_light white_light(double x, double y, double z) {
    return (algsurf_light){.position = {x, y, z}, .colour = {1, 1, 1}, .samples_u = 1, .samples_v = 1};
}

static void run(const algsurf_i_kernel *kernel, const algsurf_i_colour_job *job, batch *b, int first,
                int count, int with_visible, double *rgb) {
    algsurf_i_points points;
    points.t = b->at[0] + first;
    for (int i = 0; i < 3; i++) {
        points.position[i] = b->at[1 + i] + first;
        points.normal[i] = b->at[4 + i] + first;
        points.direction[i] = b->at[7 + i] + first;
    }
    algsurf_i_picture_kernel_for(kernel)->colours(
        job, &points, count, with_visible ? b->visible + first * job->light_count : NULL, rgb);
}

static void get(const batch *b, int entry, int first, double v[3]) {
    for (int i = 0; i < 3; i++) v[i] = b->at[first + i][entry];
}

static void put(batch *b, int entry, int first, const double v[3]) {
    for (int i = 0; i < 3; i++) b->at[first + i][entry] = v[i];
}

static void random_direction(uint64_t *state, double v[3]) {
    do
        for (int i = 0; i < 3; i++) v[i] = exact_random_unit(state);
    while (!(algsurf_dot(v, v) > 0.01) || !algsurf_unit(v, v));
}

/* Is some light so close to the tangent plane that rounding decides whether it is seen? */
static int on_edge(const algsurf_i_colour_job *job, const double point[3], const double normal[3]) {
    for (int l = 0; l < job->light_count; l++) {
        double way[3];
        for (int i = 0; i < 3; i++) way[i] = job->lights[l].position[i] - point[i];
        if (fabs(algsurf_dot(way, normal)) < 1e-9 * algsurf_length(way)) return 1;
    }
    return 0;
}

/* One normal in eight is 0, one share in three 0, one in three 1. */
static void random_batch(batch *b, const algsurf_i_colour_job *job, uint64_t *state) {
    for (int e = 0; e < MOST; e++) {
        double point[3], normal[3], direction[3];
        do {
            random_direction(state, normal), random_direction(state, direction);
            for (int i = 0; i < 3; i++) point[i] = exact_random_unit(state);
            if (e % 8 == 3) normal[0] = normal[1] = normal[2] = 0;
        } while (on_edge(job, point, e % 8 == 3 ? direction : normal));
        put(b, e, 1, point), put(b, e, 4, normal), put(b, e, 7, direction);
    }
    for (int i = 0; i < MOST * LIGHTS; i++) {
        int kind = exact_random_int(state, 3);
        b->visible[i] = kind < 2 ? kind : fabs(exact_random_unit(state));
    }
}

/* Every kernel, every entry. */
static void check_batch(const algsurf_i_colour_job *job, batch *b, int with_visible) {
    static colours got;
    double tolerance = 1e-14 * (8 + job->material->shininess);
    for (int k = 0; k < 3; k++) {
        const algsurf_i_kernel *kernel = algsurf_i_kernel_find(kernel_names[k]);
        if (!kernel) continue;
        run(kernel, job, b, 0, MOST, with_visible, got.rgb);
        for (int e = 0; e < MOST; e++) {
            double point[3], normal[3], direction[3], expected[3];
            get(b, e, 1, point), get(b, e, 4, normal), get(b, e, 7, direction);
            assert_int_equal(algsurf_shade(job->material, job->lights, job->light_count,
                                           with_visible ? b->visible + e * job->light_count : NULL, point,
                                           normal, direction, expected),
                             ALGSURF_OK);
            for (int i = 0; i < 3; i++) {
                if (fabs(got.rgb[3 * e + i] - expected[i]) <= tolerance) continue;
                exact_print_doubles("point", point, 3), exact_print_doubles("normal", normal, 3);
                exact_print_doubles("direction", direction, 3), exact_print_doubles("expected", expected, 3);
                exact_print_doubles("got", got.rgb + 3 * e, 3);
                fail_msg("seed %llu, %s, entry %d, shininess %g", (unsigned long long)seed, kernel->name, e,
                         job->material->shininess);
            }
        }
    }
}

static void random_lights(algsurf_light *lights, uint64_t *state) {
    for (int l = 0; l < LIGHTS; l++) {
        lights[l] = white_light(4 * exact_random_unit(state), 4 * exact_random_unit(state),
                                4 * exact_random_unit(state));
        for (int i = 0; i < 3; i++) lights[l].colour[i] = fabs(exact_random_unit(state));
    }
}

static void random_points(void **state) {
    static const double shininess[] = {1,    2,    3,   7,    8,      30,   31,   100,
                                       1023, 1024, 0.5, 30.5, 1024.5, 1e-3, 2000, 1e6};
    static batch b;
    uint64_t random = seed;
    (void)state;
    for (size_t k = 0; k < sizeof shininess / sizeof shininess[0]; k++)
        for (int count = 0; count <= LIGHTS; count++) {
            algsurf_material m = material;
            algsurf_light lights[LIGHTS];
            const algsurf_i_colour_job job = {&m, lights, count};
            m.shininess = shininess[k];
            random_lights(lights, &random);
            random_batch(&b, &job, &random);
            check_batch(&job, &b, 0);
            check_batch(&job, &b, 1);
        }
}

/* Only the direction of a light counts; one at the point itself has none. */
static void distance(void **state) {
    static const double distances[] = {1e-300, 1e-200, 1e-9, 1, 1e160, 1e300, 1.7e308};
    const double far[3] = {-1.7e308, -1.7e308, -1.7e308}, up[3] = {0, 0, 1}, down[3] = {0, 0, -1};
    const double origin[3] = {0, 0, 0};
    static batch b;
    algsurf_light light;
    const algsurf_i_colour_job job = {&material, &light, 1};
    (void)state;
    for (int e = 0; e < MOST; e++) put(&b, e, 1, origin), put(&b, e, 4, up), put(&b, e, 7, down);
    for (size_t k = 0; k < sizeof distances / sizeof distances[0]; k++) {
        light = white_light(distances[k] * sqrt(0.75), 0, distances[k] * 0.5);
        check_batch(&job, &b, 0);
    }
    light = white_light(0, 0, 0);
    check_batch(&job, &b, 0);
    light = white_light(1.7e308, 1.7e308, 1.7e308);
    for (int e = 0; e < MOST; e++) put(&b, e, 1, far);
    check_batch(&job, &b, 0);
}

/* A light straight behind a point seen edge-on: the half-way vector is all rounding, the highlight no more
 * than a highlight. */
static void backlight(void **state) {
    static batch b;
    static colours got;
    uint64_t random = seed + 1;
    int lit = 0;
    (void)state;
    for (int turn = 0; turn < 100; turn++) {
        algsurf_light light = white_light(0, 0, 0);
        const algsurf_i_colour_job job = {&material, &light, 1};
        double direction[3], side[3], normal[3], point[3];
        random_direction(&random, direction);
        for (int e = 0; e < MOST; e++) {
            random_direction(&random, side);
            double along = algsurf_dot(side, direction), far = 1 + fabs(exact_random_unit(&random));
            for (int i = 0; i < 3; i++) normal[i] = side[i] - along * direction[i];
            for (int i = 0; i < 3; i++) point[i] = -far * direction[i];
            (void)algsurf_unit(normal, normal);
            put(&b, e, 1, point), put(&b, e, 4, normal), put(&b, e, 7, direction);
        }
        for (int k = 0; k < 3; k++) {
            const algsurf_i_kernel *kernel = algsurf_i_kernel_find(kernel_names[k]);
            if (!kernel) continue;
            run(kernel, &job, &b, 0, MOST, 0, got.rgb);
            for (int i = 0; i < 3 * MOST; i++) {
                assert_true(got.rgb[i] >= 0 &&
                            got.rgb[i] <= 0.8 * material.ambient + material.specular + 1e-9);
                lit += got.rgb[i] > 0.3;
            }
        }
    }
    assert_true(lit > 0);
}

/* Any number of entries, by any kernel: the bits of each entry alone; nothing behind them touched. */
static void same_bits(void **state) {
    static const double shininess[3] = {30, 31, 12.75};
    static batch b;
    static colours alone, got;
    uint64_t random = seed + 2;
    (void)state;
    for (int turn = 0; turn < 12; turn++) {
        algsurf_material m = material;
        algsurf_light lights[LIGHTS];
        const algsurf_i_colour_job job = {&m, lights, 1 + turn % LIGHTS};
        m.shininess = shininess[turn % 3];
        random_lights(lights, &random);
        random_batch(&b, &job, &random);
        memset(&alone, 0xa5, sizeof alone);
        for (int count = 0; count <= MOST; count++) {
            if (count > 0)
                run(algsurf_i_kernel_find("baseline"), &job, &b, count - 1, 1, turn % 2,
                    alone.rgb + 3 * (count - 1));
            for (int k = 0; k < 3 && (count <= 17 || count % 61 == 0 || count == MOST); k++) {
                const algsurf_i_kernel *kernel = algsurf_i_kernel_find(kernel_names[k]);
                if (!kernel) continue;
                memset(&got, 0xa5, sizeof got);
                run(kernel, &job, &b, 0, count, turn % 2, got.rgb);
                assert_memory_equal(&got, &alone, sizeof got);
            }
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_points), cmocka_unit_test(distance),
                                       cmocka_unit_test(backlight), cmocka_unit_test(same_bits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
