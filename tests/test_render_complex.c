/* test_render_complex.c - pictures of complex space: against the single rays, against the real renderer,
 * and the same bytes with spatial coherence and without, for any threads and slices.
 *
 * Breaks tried, each caught by the test named:
 *   space not handed on, |t| not in the hits, shadows                            pixel_by_pixel
 *   never warm, a slice's first row begun anew                                   iterations_saved
 *   a row lost in a batch, rows beyond the last one drawn                        same_bytes
 *   an undecided pixel not drawn                                                   border_is_undecided
 *   imaginary parts of the wrong scale, start values from elsewhere              states_of_single_rays
 *   sector of real space too narrow or too wide                                  real_space
 *   rows of roots too short, a null row read                                     odd_surfaces
 *   a refused space kept, null space refused                                     setters
 *   more of a caller's struct written than it has                                older_stats
 */
#include <fenv.h>

#include "catalogue.h"
#include "render_case.h"

#define PI 3.14159265358979323846

static algsurf_complex_space space_of(double delta, const double *imaginary, size_t count) {
    return (algsurf_complex_space){.size = sizeof(algsurf_complex_space),
                                   .sector = {0, delta},
                                   .imaginary = imaginary,
                                   .imaginary_count = count};
}

/* A named surface as the catalogue frames it. */
static algsurf_scene *named(const char *name, algsurf_surface **surface) {
    const catalogue_entry *entry = catalogue_find(name);
    *surface = surface_of(entry->equation);
    algsurf_scene *scene = scene_of(*surface, NULL, NULL, NULL);
    assert_ok(algsurf_scene_set_extent(scene, &entry->extent));
    algsurf_camera camera = pinhole_of(entry->eye, entry->look_at, entry->up, entry->fov);
    assert_ok(algsurf_scene_set_camera(scene, &camera));
    return scene;
}

static algsurf_scene *complex_scene(const char *name, const algsurf_complex_space *space,
                                    algsurf_surface **surface) {
    algsurf_scene *scene = named(name, surface);
    assert_ok(algsurf_scene_set_complex_space(scene, space));
    return scene;
}

static picture *drawn_with(algsurf_scene *scene, algsurf_coherence coherence, int threads) {
    assert_ok(algsurf_scene_set_coherence(scene, coherence));
    return drawn(scene, threads);
}

/* Where a picture's hit is as good as the single ray's: in its interval, but for roundings. */
static int agrees(double t, const algsurf_hit *hit) {
    double slack = 1e-14 * hit->t;
    return t >= hit->t_lo - slack && t <= hit->t_hi + slack;
}

/* Bytes and hits from the public single steps. */
TEST(pixel_by_pixel) {
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    const algsurf_light light = {{5, -4, 6}, {0.9, 0.8, 0.7},    {1, 0, 0}, {0, 1, 0}, 4,
                                 4,          ALGSURF_LIGHT_AREA, {0}};
    const algsurf_complex_space space = space_of(PI / 18, (const double[]){0, 0, 0.05}, 3);
    const catalogue_entry *entry = catalogue_find("tangle");
    algsurf_surface *surface;
    algsurf_scene *scene = complex_scene("tangle", &space, &surface);
    uint64_t hits = 0;
    algsurf_camera camera = pinhole_of(entry->eye, entry->look_at, entry->up, entry->fov);
    assert_ok(algsurf_scene_set_lights(scene, &light, 1));
    assert_ok(algsurf_scene_set_material(scene, &plain));
    assert_ok(algsurf_scene_set_quality(scene, ALGSURF_QUALITY_FULL));
    assert_ok(algsurf_scene_get_lighting(scene, lights, &lighting));
    picture *p = drawn(scene, 2);
    for (int k = 0; k < W * H; k++) {
        double c[3] = {1, 1, 1};
        unsigned char bytes[3];
        algsurf_hit hit;
        algsurf_ray ray = pixel_ray(&camera, W, H, k % W + 0.5, k / W + 0.5);
        assert_ok(algsurf_intersect_complex(surface, &entry->extent, &ray, &space, NULL, NULL, &hit, NULL));
        hits += hit.state == ALGSURF_STATE_HIT;
        if (hit.state != ALGSURF_STATE_MISS)
            assert_ok(algsurf_shade(&lighting, NULL, hit.position, hit.normal, ray.direction, c));
        assert_ok(algsurf_srgb_encode(c, bytes));
        for (int i = 0; i < 3; i++)
            assert_true(abs(p->bytes[k / W * STRIDE + k % W * 3 + i] - bytes[i]) <= 1);
        if (hit.state == ALGSURF_STATE_MISS)
            assert_true(isinf(p->hits[k]));
        else
            assert_true(agrees(p->hits[k], &hit));
    }
    assert_true(p->stats.hits == hits && p->stats.rays == W * H && p->stats.shadow_rays == 0);
    assert_in_range(hits, W * H / 5, W * H * 9 / 10);
}

static void assert_same_states(const catalogue_entry *entry, const algsurf_surface *surface,
                               const algsurf_complex_space *space, const picture *p) {
    uint64_t undecided = 0;
    algsurf_camera camera = pinhole_of(entry->eye, entry->look_at, entry->up, entry->fov);
    for (int k = 0; k < W * H; k++) {
        algsurf_hit hit;
        algsurf_ray ray = pixel_ray(&camera, W, H, k % W + 0.5, k / W + 0.5);
        assert_ok(algsurf_intersect_complex(surface, &entry->extent, &ray, space, NULL, NULL, &hit, NULL));
        undecided += hit.state == ALGSURF_STATE_UNDECIDED;
        assert_true(isinf(p->hits[k]) == (hit.state == ALGSURF_STATE_MISS));
        if (hit.state == ALGSURF_STATE_HIT) assert_true(agrees(p->hits[k], &hit));
    }
    assert_true(undecided == p->stats.undecided);
}

enum { PARTS = 5 };

/* Surfaces, delta, and imaginary parts. */
static const struct {
    const char *name;
    int antialias;
    double delta, imaginary[PARTS];
} shots[] = {{"sphere", 1, 7 * PI / 18, {1}}, {"whitney", 2, PI / 18, {1.5}},
             {"steiner", 1, PI / 36, {0}},    {"tangle", 1, PI / 180, {2}},
             {"boy", 1, PI / 18, {[4] = 10}}, {"barth-decic", 1, 1e-10, {0}}};
enum { SHOTS = sizeof shots / sizeof *shots };

static const int cuts[] = {0, 1, 9, 16, 20, H};

TEST(same_bytes) {
    static const int threads[3] = {1, 2, 5};
    for (int s = 0; s < SHOTS; s++) {
        const algsurf_complex_space space = space_of(shots[s].delta, shots[s].imaginary, PARTS);
        algsurf_surface *surface;
        algsurf_scene *scene = complex_scene(shots[s].name, &space, &surface);
        assert_ok(algsurf_scene_set_antialias(scene, shots[s].antialias));
        picture *one = drawn_with(scene, ALGSURF_COHERENCE_NONE, 1);
        assert_in_range(one->stats.hits * 100 / one->stats.rays, 10, 95);
        assert_true(one->stats.undecided <= one->stats.rays / 200);
        for (int c = ALGSURF_COHERENCE_NONE; c <= ALGSURF_COHERENCE_NEIGHBOURS; c++) {
            picture *other;
            for (int k = 0; k < 3; k++) {
                other = drawn_with(scene, (algsurf_coherence)c, threads[k]);
                assert_same_picture(one, other);
                assert_true(other->stats.rays == one->stats.rays && other->stats.hits == one->stats.hits &&
                            other->stats.undecided == one->stats.undecided);
            }
            other = sliced(scene, cuts);
            assert_same_picture(one, other);
        }
        fesetround(FE_DOWNWARD);
        picture *other = drawn(scene, 2);
        fesetround(FE_TONEAREST);
        assert_same_picture(one, other);
    }
}

/* The roots of the row above save a twentieth of the iterations even in a picture as coarse as this one (in a
 * large one they save more than half), and how many are needed depends neither on the threads nor on slices.
 */
TEST(iterations_saved) {
    for (int s = 0; s < SHOTS; s++) {
        const algsurf_complex_space space = space_of(shots[s].delta, shots[s].imaginary, PARTS);
        algsurf_surface *surface;
        algsurf_scene *scene = complex_scene(shots[s].name, &space, &surface);
        picture *cold = drawn_with(scene, ALGSURF_COHERENCE_NONE, 2);
        picture *warm = drawn_with(scene, ALGSURF_COHERENCE_NEIGHBOURS, 2), *again = drawn(scene, 5);
        assert_true(warm->stats.iterations * 20 < cold->stats.iterations * 19);
        assert_true(warm->stats.iterations >= cold->stats.hits);
        assert_true(warm->stats.iterations == again->stats.iterations);
        picture *slices = sliced(scene, cuts);
        assert_true(warm->stats.iterations == slices->stats.iterations);
        assert_ok(algsurf_scene_set_complex_space(scene, NULL));
        again = drawn(scene, 1);
        assert_true(again->stats.iterations == 0);
    }
}

/* Every named surface by every kernel: the same bytes, and each pixel's state is that of its single ray. */
TEST(states_of_single_rays) {
    static const struct {
        double sigma, delta, imaginary[3];
        int count;
    } spaces[] = {{0, 0.4, {0}, 0},
                  {0, 0.2, {1.5}, 1},
                  {0.3, 1, {0, 0.3}, 2},
                  {0, PI, {0}, 0},
                  {0.1, 0.5, {0, 0, -0.2}, 3}};
    uint64_t alone = 0, rays = 0;
    for (const catalogue_entry *entry = catalogue; entry->name; entry++)
        for (size_t i = 0; i < sizeof spaces / sizeof *spaces; i++) {
            const size_t count = spaces[i].count <= entry->degree + 1 ? (size_t)spaces[i].count : 0;
            algsurf_complex_space space = space_of(spaces[i].delta, spaces[i].imaginary, count);
            space.sector.sigma = spaces[i].sigma;
            algsurf_surface *surface;
            algsurf_scene *scene = complex_scene(entry->name, &space, &surface);
            picture *p = drawn(scene, 1);
            for (int k = 0; algsurf_kernel_name(k); k++) {
                algsurf_intersect_options options = {.size = sizeof options,
                                                     .kernel = algsurf_kernel_name(k)};
                assert_ok(algsurf_scene_set_intersect_options(scene, &options));
                picture *other = drawn(scene, 2);
                assert_same_picture(p, other);
                assert_true(other->stats.single_rays == p->stats.single_rays &&
                            other->stats.iterations == p->stats.iterations);
            }
            assert_same_states(entry, surface, &space, p);
            alone += p->stats.single_rays, rays += p->stats.rays;
        }
    assert_true(alone * 500 < rays);
}

/* sigma = 0, delta = 1e-10 is real space. */
TEST(real_space) {
    static const char *const names[4] = {"sphere", "tangle", "torus", "boy"};
    const algsurf_complex_space space = space_of(1e-10, NULL, 0);
    for (int s = 0; s < 4; s++) {
        algsurf_surface *surface;
        algsurf_scene *scene = named(names[s], &surface);
        picture *real = drawn(scene, 2);
        assert_ok(algsurf_scene_set_complex_space(scene, &space));
        picture *complex = drawn(scene, 2);
        uint64_t differ = 0;
        assert_true(real->stats.hits > W * H / 10);
        for (int k = 0; k < W * H; k++) {
            if (isinf(real->hits[k]) != isinf(complex->hits[k]))
                differ++;
            else if (!isinf(real->hits[k]))
                assert_true(fabs(real->hits[k] - complex->hits[k]) <= 1e-9);
        }
        assert_true(differ <= real->stats.undecided + complex->stats.undecided);
        assert_true(complex->stats.undecided <= W * H / 200);
    }
}

static algsurf_scene *from_above(const algsurf_surface *surface, double height) {
    const double eye[3] = {0, 0, height}, up[3] = {0, 1, 0};
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, 1);
    algsurf_camera camera = parallel_of(eye, origin, up, 2);
    assert_ok(algsurf_scene_set_camera(scene, &camera));
    return scene;
}

/* Every ray has the root 4 + i, and delta is its argument: open for each, however it was started.  With
 * z = 4 - t:  z (z+20) - 1 + (28 - 2t) i = (t - 4 - i)(t - 24 - i). */
TEST(border_is_undecided) {
    algsurf_surface *surface = surface_of("z (z+20) - 1");
    algsurf_scene *scene = from_above(surface, 4);
    const algsurf_complex_space space = space_of(atan2(1, 4), (const double[]){28, -2}, 2);
    assert_ok(algsurf_scene_set_complex_space(scene, &space));
    picture *cold = drawn_with(scene, ALGSURF_COHERENCE_NONE, 1);
    picture *warm = drawn_with(scene, ALGSURF_COHERENCE_NEIGHBOURS, 2);
    assert_true(cold->stats.undecided == W * H && warm->stats.undecided == W * H);
    assert_true(fabs(cold->hits[0] - sqrt(17)) < 1e-12);
    assert_true(cold->stats.single_rays == W * H && warm->stats.single_rays == W * H);
    assert_same_picture(cold, warm);
}

/* (z+1)^3 = x - c, drawn warm and cold; returns how many rays of the warm picture went alone. */
static uint64_t cubic_column(double c) {
    const algsurf_term terms[5] = {{0, 0, 3, 1}, {0, 0, 2, 3}, {0, 0, 1, 3}, {0, 0, 0, 1 + c}, {1, 0, 0, -1}};
    const algsurf_complex_space space = space_of(PI / 4, NULL, 0);
    algsurf_surface *surface = surface_of_terms(terms, 5);
    algsurf_scene *scene = from_above(surface, 4);
    assert_ok(algsurf_scene_set_complex_space(scene, &space));
    picture *cold = drawn_with(scene, ALGSURF_COHERENCE_NONE, 1);
    picture *warm = drawn_with(scene, ALGSURF_COHERENCE_NEIGHBOURS, 1);
    uint64_t alone = warm->stats.single_rays;
    assert_true(cold->stats.hits == W * H);
    assert_same_picture(cold, warm);
    return alone;
}

/* Along the rays of one column the three roots, 3e-5 apart, come as one cluster, certainly in the sector:
 * lanes leave each of its pixels to the single ray. */
TEST(cluster_is_left) {
    const double eye[3] = {0, 0, 4}, up[3] = {0, 1, 0};
    algsurf_camera camera = parallel_of(eye, origin, up, 2);
    algsurf_ray ray = pixel_ray(&camera, W, H, 17.5, 0.5);
    uint64_t clustered = cubic_column(ray.origin[0] - 4e-15), apart = cubic_column(ray.origin[0] - 1e-3);
    assert_true(clustered >= H && apart == 0);
}

/* No roots at all, fewer than the degree along every ray, one multiple root along every ray. */
TEST(odd_surfaces) {
    static const char *const equations[3] = {"1", "x z + 0.3 x^2 + 1", "(z + 1)^2"};
    const algsurf_complex_space space = space_of(PI / 4, NULL, 0);
    for (int s = 0; s < 3; s++) {
        algsurf_surface *surface = surface_of(equations[s]);
        algsurf_scene *scene = from_above(surface, 4);
        assert_ok(algsurf_scene_set_complex_space(scene, &space));
        if (s == 2) assert_ok(algsurf_scene_set_extent(scene, NULL)); /* no rows then */
        picture *cold = drawn_with(scene, ALGSURF_COHERENCE_NONE, 1);
        picture *warm = drawn_with(scene, ALGSURF_COHERENCE_NEIGHBOURS, 2);
        assert_same_picture(cold, warm);
        assert_true(cold->stats.iterations == warm->stats.iterations); /* nothing to start from */
        assert_true(s == 0 ? cold->stats.hits + cold->stats.undecided == 0
                           : cold->stats.hits + cold->stats.undecided > W * H / 4);
    }
}

TEST(setters) {
    double imaginary[ALGSURF_MAX_DEGREE + 1] = {1}, wrong[ALGSURF_MAX_DEGREE + 1] = {1};
    const algsurf_complex_space good = space_of(0.3, imaginary, 1);
    algsurf_complex_space bad;
    algsurf_surface *surface;
    algsurf_scene *scene = named("tangle", &surface);
    picture *real = drawn(scene, 1), *before, *after;
    assert_ok(algsurf_scene_set_complex_space(scene, &good));
    before = drawn(scene, 1);
    assert_true(memcmp(real->bytes, before->bytes, sizeof real->bytes) != 0);
    assert_int_equal(algsurf_scene_set_complex_space(NULL, &good), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_scene_set_complex_space(NULL, NULL), ALGSURF_E_ARGUMENT);
#define REFUSE(change, status)                                                                               \
    (bad = good, (change), assert_int_equal(algsurf_scene_set_complex_space(scene, &bad), ALGSURF_E_##status))
    REFUSE(bad.size = 1, SIZE);
    REFUSE(bad.sector.sigma = -0.1, ARGUMENT);
    REFUSE(bad.sector.delta = -0.1, ARGUMENT);
    REFUSE(bad.sector.delta = 4, ARGUMENT);
    REFUSE((bad.sector.sigma = 2, bad.sector.delta = 1.5), ARGUMENT);
    REFUSE(bad.sector.sigma = NAN, NOT_FINITE);
    REFUSE(bad.sector.delta = INFINITY, NOT_FINITE);
    REFUSE(bad.imaginary = NULL, ARGUMENT);
    REFUSE(bad.imaginary_count = ALGSURF_MAX_DEGREE + 2, ARGUMENT);
    REFUSE(bad.imaginary_count = SIZE_MAX, ARGUMENT);
#define REFUSE_PART(k, value, status)                                                                        \
    wrong[k] = value;                                                                                        \
    REFUSE((bad.imaginary = wrong, bad.imaginary_count = ALGSURF_MAX_DEGREE + 1), status);                   \
    wrong[k] = 0
    REFUSE_PART(4, INFINITY, NOT_FINITE);
    REFUSE_PART(5, 1, ARGUMENT); /* above the degree */
    REFUSE_PART(ALGSURF_MAX_DEGREE, 1, ARGUMENT);
    REFUSE_PART(ALGSURF_MAX_DEGREE, NAN, NOT_FINITE);
    REFUSE_PART(0, NAN, NOT_FINITE);
#undef REFUSE_PART
#undef REFUSE
    assert_int_equal(algsurf_scene_set_coherence(NULL, ALGSURF_COHERENCE_NONE), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_scene_set_coherence(scene, (algsurf_coherence)2), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_scene_set_coherence(scene, (algsurf_coherence)-1), ALGSURF_E_ARGUMENT);
    after = drawn(scene, 1); /* a refused value leaves the scene as it was */
    assert_same_picture(before, after);
    assert_true(after->stats.iterations == before->stats.iterations);
    imaginary[0] = 7; /* it was copied */
    after = drawn(scene, 1);
    assert_same_picture(before, after);
    imaginary[0] = 1;
    for (size_t count = 1; count <= ALGSURF_MAX_DEGREE + 1; count += count < 6 ? 1 : 59) { /* zeros behind */
        double *gone = malloc(count * sizeof *gone);
        assert_non_null(gone);
        memcpy(gone, imaginary, count * sizeof *gone);
        bad = space_of(0.3, gone, count);
        assert_ok(algsurf_scene_set_complex_space(scene, &bad));
        free(gone);
        after = drawn(scene, 1);
        assert_same_picture(before, after);
    }
    bad = good;
    for (bad.size = 0; bad.size < sizeof bad; bad.size++) /* no release had a smaller one */
        assert_int_equal(algsurf_scene_set_complex_space(scene, &bad), ALGSURF_E_SIZE);
    assert_ok(algsurf_scene_set_complex_space(scene, NULL));
    after = drawn(scene, 1);
    assert_same_picture(real, after);
}
