/* test_kernel_colours.c - the colours of points by every kernel: the same bits, those of algsurf_shade, and
 * their bytes.
 *
 * Breaks tried, each caught by the test named:
 *   entries behind the last one written; shares of another entry       same_bits, public_functions
 *   bytes cut off instead of rounded; points beyond all bounds          public_functions
 */
#include "base/vec.h"
#include "exact.h"
#include "beams/kernels.h"
#include "picture/colours.h"
#include "shade_reference.h"
#include "unit.h"

enum { MOST = 200, SPARE = 8, LIGHTS = 4 };
static const uint64_t seed = 20240612;
static const char *const kernel_names[3] = {"baseline", "avx2", "avx512"};

/* Points, and what kernels know of them. */
typedef struct batch {
    double point[MOST][3], normal[MOST][3], direction[MOST][3], visible[MOST * (LIGHTS + 1)];
    float looks[9][MOST];
} batch;

typedef struct colours {
    float rgb[3 * MOST + SPARE];
    uint32_t bytes[MOST + SPARE];
} colours;

static const algsurf_material material = {.size = sizeof material,
                                          .outside = {0.8, 0.4, 0.2},
                                          .inside = {0.1, 0.3, 0.6},
                                          .diffuse = 0.6,
                                          .ambient = 0.15,
                                          .fill = 0.12,
                                          .specular = 0.4,
                                          .roughness = 0.25,
                                          .haze = 0.3};

static algsurf_i_looks looks_of(batch *b, int first) {
    algsurf_i_looks looks;
    for (int i = 0; i < 3; i++) {
        looks.place[i] = b->looks[i] + first;
        looks.normal[i] = b->looks[3 + i] + first;
        looks.direction[i] = b->looks[6 + i] + first;
    }
    return looks;
}

static void run(const char *name, const algsurf_i_colour_job *job, batch *b, int first, int count,
                int with_visible, float *rgb, uint32_t *bytes) {
    const algsurf_i_looks looks = looks_of(b, first);
    const double *visible = with_visible ? b->visible + first * (job->light_count + 1) : NULL;
    algsurf_i_colour_kernel_for(algsurf_i_kernel_find(name))
        ->colours(job, &looks, count, visible, rgb, bytes);
}

/* One normal in eight is 0, one share in three 0, one in three 1; one point in sixteen is far outside. */
static void random_batch(batch *b, const algsurf_i_colour_job *job, uint64_t *state) {
    const algsurf_i_looks looks = looks_of(b, 0);
    for (int e = 0; e < MOST; e++) {
        random_direction(state, b->normal[e]), random_direction(state, b->direction[e]);
        for (int i = 0; i < 3; i++) {
            b->point[e][i] = (e % 16 == 7 ? 1e13 : 1) * random_unit(state);
            if (e % 8 == 3) b->normal[e][i] = 0;
        }
        algsurf_i_set_look(&job->frame, b->point[e], b->normal[e], b->direction[e], e, &looks);
    }
    for (int i = 0; i < MOST * (LIGHTS + 1); i++) {
        int kind = random_int(state, 3);
        b->visible[i] = kind < 2 ? kind : fabs(random_unit(state));
    }
}

/* What is asked for in one turn. */
typedef struct turn {
    algsurf_material material;
    algsurf_light lights[LIGHTS];
    algsurf_lighting lighting;
    algsurf_i_colour_job job;
    int preview, with_visible;
    uint8_t curve[SRGB_STEPS];
    batch b;
} turn;

static void random_turn(int number, uint64_t *state, turn *t) {
    static const double roughness[] = {0.25, 1, 0.1, 1e-3};
    t->material = material;
    t->material.roughness = roughness[number / 8 % 4];
    t->preview = number % 8 == 5, t->with_visible = number % 2 == 0;
    t->lighting = (algsurf_lighting){.size = sizeof t->lighting,
                                     .material = &t->material,
                                     .lights = t->lights,
                                     .light_count = (size_t)(number % (LIGHTS + 1)),
                                     .radius = 1 + fabs(random_unit(state)),
                                     .bounded = number / 3 % 2};
    random_direction(state, t->lighting.up), random_direction(state, t->lighting.forward);
    for (int l = 0; l < LIGHTS; l++) {
        t->lights[l] = (algsurf_light){.samples_u = 1, .samples_v = 1};
        for (int i = 0; i < 3; i++) {
            t->lights[l].position[i] = 4 * random_unit(state);
            t->lights[l].colour[i] = fabs(random_unit(state));
        }
    }
    algsurf_i_colour_prepare(&t->lighting, t->preview, &t->job);
    algsurf_i_srgb_curve(t->curve);
    t->job.curve = t->curve;
    random_batch(&t->b, &t->job, state);
}

static void public_colour(const turn *t, int e, double colour[3]) {
    const batch *b = &t->b;
    const double *visible = t->with_visible ? b->visible + e * (t->job.light_count + 1) : NULL;
    assert_ok(t->preview
                  ? algsurf_shade_preview(&t->lighting, b->point[e], b->normal[e], b->direction[e], colour)
                  : algsurf_shade(&t->lighting, visible, b->point[e], b->normal[e], b->direction[e], colour));
}

/* Every kernel gives the bits of algsurf_shade, and its bytes. */
TEST(public_functions) {
    static turn t;
    static colours got;
    uint64_t random = seed;
    for (int number = 0; number < 160; number++) {
        random_turn(number, &random, &t);
        if (t.preview) t.with_visible = 0;
        for (int k = 0; k < 3; k++) {
            if (!algsurf_i_kernel_find(kernel_names[k])) continue;
            run(kernel_names[k], &t.job, &t.b, 0, MOST, t.with_visible, got.rgb, NULL);
            run(kernel_names[k], &t.job, &t.b, 0, MOST, t.with_visible, NULL, got.bytes);
            for (int e = 0; e < MOST; e++) {
                double colour[3];
                unsigned char bytes[3];
                public_colour(&t, e, colour);
                assert_ok(algsurf_srgb_encode(colour, bytes));
                for (int i = 0; i < 3; i++)
                    if (got.rgb[3 * e + i] != (float)colour[i] || (got.bytes[e] >> 8 * i & 255) != bytes[i])
                        fail_msg("turn %d, %s, entry %d: %.9g, not %.9g", number, kernel_names[k], e,
                                 (double)got.rgb[3 * e + i], colour[i]);
                assert_true(got.bytes[e] >> 24 == 0);
            }
        }
    }
}

/* Of what is near the surface shown: as the formula has it. */
TEST(formula) {
    static turn t;
    static colours got;
    uint64_t random = seed + 1;
    for (int number = 0; number < 24; number++) {
        random_turn(number, &random, &t);
        if (t.preview) continue;
        run("baseline", &t.job, &t.b, 0, MOST, t.with_visible, got.rgb, NULL);
        for (int e = 0; e < MOST; e++) {
            double expected[3];
            if (e % 16 == 7) continue;
            const double *visible = t.with_visible ? t.b.visible + e * (t.job.light_count + 1) : NULL;
            reference_shade(&t.lighting, visible, t.b.point[e], t.b.normal[e], t.b.direction[e], expected);
            for (int i = 0; i < 3; i++)
                if (!(fabs((double)got.rgb[3 * e + i] - expected[i]) <= 5e-5))
                    fail_msg("turn %d, entry %d: %.9g, not %.9g", number, e, (double)got.rgb[3 * e + i],
                             expected[i]);
        }
    }
}

/* A light straight behind a point seen edge-on: the half-way vector is all rounding, the highlight no more
 * than a highlight; and so it is for lights and points beyond all bounds. */
TEST(extremes) {
    static turn t;
    static colours got;
    uint64_t random = seed + 2;
    for (int number = 0; number < 100; number++) {
        const algsurf_i_looks looks = looks_of(&t.b, 0);
        random_turn(number, &random, &t);
        for (int e = 0; e < MOST; e++) {
            double *direction = t.b.direction[e], *normal = t.b.normal[e];
            for (int i = 0; i < 3; i++) t.b.point[e][i] = t.lights[0].position[i] - (1 + e) * direction[i];
            double along = algsurf_dot(normal, direction), far = e % 3 ? 1 : 1e300;
            for (int i = 0; i < 3; i++) normal[i] -= along * direction[i], t.b.point[e][i] *= far;
            (void)algsurf_unit(normal, normal);
            algsurf_i_set_look(&t.job.frame, t.b.point[e], normal, direction, e, &looks);
        }
        for (int k = 0; k < 3; k++) {
            if (!algsurf_i_kernel_find(kernel_names[k])) continue;
            run(kernel_names[k], &t.job, &t.b, 0, MOST, t.with_visible, got.rgb, NULL);
            for (int i = 0; i < 3 * MOST; i++) assert_true(got.rgb[i] >= 0 && got.rgb[i] <= 1);
        }
    }
}

/* Any number of entries, by any kernel: the bits of each entry alone; nothing behind them touched. */
TEST(same_bits) {
    static turn t;
    static colours alone, got;
    uint64_t random = seed + 3;
    for (int number = 0; number < 16; number++) {
        random_turn(number, &random, &t);
        memset(&alone, 0xa5, sizeof alone);
        for (int count = 0; count <= MOST; count++) {
            if (count > 0) {
                run("baseline", &t.job, &t.b, count - 1, 1, t.with_visible, alone.rgb + 3 * (count - 1),
                    NULL);
                run("baseline", &t.job, &t.b, count - 1, 1, t.with_visible, NULL, alone.bytes + count - 1);
            }
            for (int k = 0; k < 3 && (count <= 33 || count % 61 == 0 || count == MOST); k++) {
                if (!algsurf_i_kernel_find(kernel_names[k])) continue;
                memset(&got, 0xa5, sizeof got);
                run(kernel_names[k], &t.job, &t.b, 0, count, t.with_visible, got.rgb, NULL);
                run(kernel_names[k], &t.job, &t.b, 0, count, t.with_visible, NULL, got.bytes);
                assert_memory_equal(&got, &alone, sizeof got);
            }
        }
    }
}
