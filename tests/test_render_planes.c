/* test_render_planes.c - what a picture writes besides bytes of red, green and blue: t, normals and state of
 * the nearest sample of each pixel, against the single call for its ray; alpha; planes that are not asked
 * for.
 *
 * Breaks tried, each caught by the test named:
 *   normal turned towards the viewer, not of unit length, of the sample drawn last   one_ray, nearest_sample
 *   t, normal or state left over from the row before where nothing is hit            one_ray
 *   undecided told as a hit, or passed over                                          undecided
 *   the last one of several samples at the same distance                             first_of_equals
 *   alpha of a pixel that shows the background; colour multiplied by alpha           alpha
 *   background mixed into transparent pixels; none drawn as white                    alpha
 *   a plane that depends on which others are there, pixels chosen by other colours   any_planes
 *   shading, or shadow rays, of a picture without pixels                             any_planes
 *   rows that begin at the end of the row before although stride says otherwise      strides
 */
#include "render_case.h"

static const double four = 4;
static const algsurf_complex_space space = {
    .size = sizeof space, .sector = {0, 0.1}, .imaginary = &four, .imaginary_count = 1};

/* Ways to draw: by packets, ray by ray, in complex space, each through a pinhole or in parallel. */
static const struct way {
    const char *name;
    int method;
    int complex, parallel;
} ways[] = {
    {"packets", ALGSURF_METHOD_DEFAULT, 0, 0}, {"parallel packets", ALGSURF_METHOD_DEFAULT, 0, 1},
    {"rays", ALGSURF_METHOD_BRENT, 0, 0},      {"parallel rays", ALGSURF_METHOD_BRENT, 0, 1},
    {"complex", ALGSURF_METHOD_DEFAULT, 1, 0}, {"parallel complex", ALGSURF_METHOD_DEFAULT, 1, 1},
};
enum { WAYS = sizeof ways / sizeof *ways };

static algsurf_camera camera_in(const struct way *way) {
    const double eye[3] = {7, 4, 5};
    algsurf_camera camera = camera_at(7, 4, 5, 36);
    if (way->parallel) assert_ok(algsurf_camera_orthographic(eye, origin, z_up, 6.5, &camera));
    return camera;
}

static algsurf_scene *scene_in(const struct way *way, const algsurf_surface *surface, int n) {
    const algsurf_intersect_options options = {.size = sizeof options, .method = way->method};
    const algsurf_camera camera = camera_in(way);
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, n);
    assert_ok(algsurf_scene_set_camera(scene, &camera));
    assert_ok(algsurf_scene_set_intersect_options(scene, &options));
    assert_ok(algsurf_scene_set_complex_space(scene, way->complex ? &space : NULL));
    return scene;
}

static algsurf_hit hit_at(const struct way *way, const algsurf_surface *surface, double x, double y) {
    const algsurf_camera camera = camera_in(way);
    algsurf_hit hit;
    algsurf_ray ray = pixel_ray(&camera, W, H, x, y);
    algsurf_status status =
        way->complex ? algsurf_intersect_complex(surface, &ball, &ray, &space, NULL, NULL, &hit, NULL)
                     : algsurf_intersect_first(surface, &ball, &ray, NULL, &hit);
    assert_ok(status);
    return hit;
}

/* Does pixel k show that hit?  Packets round otherwise; at the outline a little of t is much of the normal.
 */
static int shows(const picture *p, int k, const algsurf_hit *hit) {
    if (p->states[k] != hit->state) return 0;
    if (hit->state == ALGSURF_STATE_MISS)
        return p->hits[k] == INFINITY && p->normals[3 * k] == 0 && p->normals[3 * k + 1] == 0 &&
               p->normals[3 * k + 2] == 0;
    double away = 0, length = 0;
    for (int i = 0; i < 3; i++) {
        double n = p->normals[3 * k + i];
        length += n * n;
        away = fmax(away, fabs(n - hit->normal[i]));
    }
    return fabs(p->hits[k] - hit->t) <= 1e-9 && away <= 1e-6 && fabs(length - 1) <= 1e-6;
}

TEST(one_ray) {
    algsurf_surface *surface = torus();
    for (const struct way *way = ways; way < ways + WAYS; way++) {
        algsurf_scene *scene = scene_in(way, surface, 1);
        picture *p = drawn(scene, 2);
        int count[3] = {0, 0, 0};
        for (int k = 0; k < W * H; k++) {
            const algsurf_hit hit = hit_at(way, surface, k % W + 0.5, k / W + 0.5);
            if (!shows(p, k, &hit))
                fail_msg("%s, pixel %d,%d: state %d, t %.17g, for %d, %.17g", way->name, k % W, k / W,
                         p->states[k], p->hits[k], hit.state, hit.t);
            count[hit.state]++;
        }
        assert_true(count[ALGSURF_STATE_HIT] > W * H / 8 && count[ALGSURF_STATE_MISS] > W * H / 8);
    }
}

/* 3 x 3 samples: those of the nearest.  Where two are as near as rounding, either may be it. */
TEST(nearest_sample) {
    algsurf_surface *surface = torus();
    for (const struct way *way = ways; way < ways + WAYS; way++) {
        algsurf_scene *scene = scene_in(way, surface, 3);
        picture *p = drawn(scene, 2);
        int first = 0, mixed = 0;
        for (int k = 0; k < W * H; k++) {
            algsurf_hit hits[9], nearest = {.t = INFINITY};
            int shown = 0, misses = 0, at = -1;
            for (int s = 0; s < 9; s++) {
                hits[s] = hit_at(way, surface, k % W + (s % 3 + 0.5) / 3, k / W + (s / 3 + 0.5) / 3);
                misses += hits[s].state == ALGSURF_STATE_MISS;
                if (hits[s].t < nearest.t) nearest = hits[s], at = s;
            }
            for (int s = 0; s < 9; s++) shown |= hits[s].t <= nearest.t + 1e-9 && shows(p, k, &hits[s]);
            if (!shown) fail_msg("%s, pixel %d,%d: not the nearest sample", way->name, k % W, k / W);
            mixed += misses > 0 && misses < 9, first += at == 0;
        }
        assert_true(mixed > 50 && first < W * H / 2);
    }
}

/* Rays touch the double plane y^2 = 0, which doubles leave open. */
TEST(undecided) {
    static const int as[] = {ALGSURF_AS_UNDECIDED, ALGSURF_AS_HIT, ALGSURF_AS_MISS};
    static const int told[] = {ALGSURF_STATE_UNDECIDED, ALGSURF_STATE_HIT, ALGSURF_STATE_MISS};
    algsurf_surface *surface = surface_of("y^2 (x + 99)");
    const algsurf_camera camera = camera_at(0.1, -6, 0.2, 10);
    for (int n = 1; n <= 2; n++)
        for (int d = 0; d < 3; d++) {
            const algsurf_intersect_options how = {
                .size = sizeof how, .tier = ALGSURF_TIER_BOUNDED, .undecided_as = as[d]};
            algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_PREVIEW, n);
            assert_ok(algsurf_scene_set_camera(scene, &camera));
            assert_ok(algsurf_scene_set_intersect_options(scene, &how));
            picture *p = drawn(scene, 1);
            for (int k = 0; k < W * H; k++) {
                algsurf_hit nearest = {.t = INFINITY};
                for (int s = 0; s < n * n; s++) {
                    double x = k % W + (s % n + 0.5) / n, y = k / W + (s / n + 0.5) / n;
                    algsurf_ray ray = pixel_ray(&camera, W, H, x, y);
                    algsurf_hit hit = first_hit_of(surface, &ball, &ray, &how);
                    if (s == 0 || hit.t < nearest.t) nearest = hit;
                }
                assert_int_equal(nearest.state, told[d]);
                assert_int_equal(p->states[k], told[d]);
                assert_true(p->hits[k] == nearest.t); /* solved alone: the same bits */
                for (int i = 0; i < 3; i++) assert_true(p->normals[3 * k + i] == (float)nearest.normal[i]);
            }
        }
}

/* A wedge z = |x|, seen in parallel from above, its edge in the middle of a column of pixels: samples left
 * and right of it are at the same distance, and the first is on the left. */
TEST(first_of_equals) {
    const double eye[3] = {0.0625, 0, 4}, at[3] = {0.0625, 0, 0}, up[3] = {0, 1, 0};
    const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {2, 2, 4}};
    algsurf_surface *surface = surface_of("(z-x)(z+x)");
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, 2);
    algsurf_camera camera = parallel_of(eye, at, up, H * 0.125);
    assert_ok(algsurf_scene_set_camera(scene, &camera));
    assert_ok(algsurf_scene_set_extent(scene, &box));
    picture *p = drawn(scene, 1);
    int seen = 0;
    for (int k = W / 2 - 1; k < W * H; k += W) { /* pixels from x = -0.0625 to 0.0625 */
        if (p->states[k] != ALGSURF_STATE_HIT) continue;
        assert_true(fabs(p->hits[k] - (4 - 0.03125)) <= 1e-9);
        /* on the left the nearer sheet is z = -x: its normal has components x and z of one sign */
        assert_true(p->normals[3 * k] * p->normals[3 * k + 2] > 0);
        seen++;
    }
    assert_true(seen > H / 2);
}

static void draw_pixels(const algsurf_scene *scene, int format, uint8_t *pixels) {
    const algsurf_render_options o = options_for(2);
    const algsurf_picture planes = {.size = sizeof planes, .pixels = pixels, .format = format};
    assert_ok(algsurf_render(scene, &o, &planes, NULL));
}

/* With a background RGBA8 is RGB8 and 255; without one, alpha is the share of samples with a point, which
 * alone make the colour.  RGB8 without a background is that on black. */
TEST(alpha) {
    static uint8_t rgb[W * H][3], rgba[W * H][4], clear[W * H][4], black[W * H][3], none[W * H][3];
    const double dark[3] = {0, 0, 0}, sky[3] = {0.3, 1, 0.8};
    algsurf_surface *surface = torus();
    for (const struct way *way = ways; way < ways + WAYS; way++) {
        algsurf_scene *scene = scene_in(way, surface, 3);
        int part = 0;
        assert_ok(algsurf_scene_set_background(scene, sky));
        draw_pixels(scene, ALGSURF_RGB8, rgb[0]);
        draw_pixels(scene, ALGSURF_RGBA8, rgba[0]);
        assert_ok(algsurf_scene_set_background(scene, dark));
        draw_pixels(scene, ALGSURF_RGB8, black[0]);
        assert_ok(algsurf_scene_set_background(scene, NULL));
        draw_pixels(scene, ALGSURF_RGB8, none[0]);
        draw_pixels(scene, ALGSURF_RGBA8, clear[0]);
        assert_memory_equal(none, black, sizeof none);
        for (int k = 0; k < W * H; k++) {
            int samples = 0;
            for (int s = 0; s < 9; s++)
                samples += hit_at(way, surface, k % W + (s % 3 + 0.5) / 3, k / W + (s / 3 + 0.5) / 3).state !=
                           ALGSURF_STATE_MISS;
            assert_memory_equal(rgba[k], rgb[k], 3);
            assert_int_equal(rgba[k][3], 255);
            assert_int_equal(clear[k][3], (int)floor(255 * (samples / 9.0) + 0.5));
            double light[3];
            unsigned char over_black[3];
            assert_ok(algsurf_srgb_decode(clear[k], light));
            for (int i = 0; i < 3; i++) light[i] *= samples / 9.0;
            assert_ok(algsurf_srgb_encode(light, over_black));
            for (int i = 0; i < 3; i++) { /* twice rounded */
                assert_in_range(black[k][i] + 1, over_black[i], over_black[i] + 2);
                if (samples == 0) assert_int_equal(clear[k][i], 0);
            }
            part += samples > 0 && samples < 9;
        }
        assert_true(part > 50);
        assert_ok(algsurf_scene_set_background(scene, sky)); /* there is one again */
        draw_pixels(scene, ALGSURF_RGBA8, clear[0]);
        assert_memory_equal(clear, rgba, sizeof clear);
    }
}

/* Each choice of planes gets the bytes of a picture with all of them, the others stay as they were; so do
 * those of a transparent picture, with and without a threshold of antialiasing, of any kernel. */
static void check_choices(const algsurf_scene *scene, const picture *whole, int shaded) {
    for (int choice = 0; choice < 32; choice++) {
        picture p, expected;
        const algsurf_render_options o = options_for(2);
        algsurf_picture planes = planes_of(&p, 0);
        blank(&p), blank(&expected);
        if (choice & 1) memcpy(expected.bytes, whole->bytes, sizeof p.bytes);
        if (choice & 2) memcpy(expected.hits, whole->hits, sizeof p.hits);
        if (choice & 4) memcpy(expected.normals, whole->normals, sizeof p.normals);
        if (choice & 8) memcpy(expected.states, whole->states, sizeof p.states);
        if (choice & 16) memcpy(expected.ways, whole->ways, sizeof p.ways);
        if (!(choice & 1)) planes.pixels = NULL, planes.stride = 1, planes.format = 77;
        if (!(choice & 2)) planes.t = NULL;
        if (!(choice & 4)) planes.normals = NULL;
        if (!(choice & 8)) planes.state = NULL;
        if (!(choice & 16)) planes.way = NULL;
        assert_ok(algsurf_render(scene, &o, &planes, &p.stats));
        assert_same_picture(&p, &expected);
        assert_true(p.stats.rays == whole->stats.rays && p.stats.hits == whole->stats.hits);
        if (choice & 1) assert_true(p.stats.shadow_rays == whole->stats.shadow_rays);
        if (!(choice & 1) && !shaded) assert_true(p.stats.shadow_rays == 0 && p.stats.shade_s == 0);
    }
}

TEST(any_planes) {
    static const double dark[3] = {0, 0, 0};
    const algsurf_material soot = {.size = sizeof soot, .roughness = 1};
    algsurf_surface *surface = torus();
    for (int look = 0; look < 3; look++)
        for (int threshold = 0; threshold < 2; threshold++) {
            picture *first = NULL;
            const char *kernel;
            for (int k = 0; (kernel = algsurf_kernel_name(k)) != NULL; k++) {
                const algsurf_intersect_options options = {.size = sizeof options, .kernel = kernel};
                algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_FULL, 3);
                assert_ok(algsurf_scene_set_intersect_options(scene, &options));
                assert_ok(algsurf_scene_set_antialias_threshold(scene, 0.2 * threshold));
                assert_ok(algsurf_scene_set_background(scene, look == 0 ? dark : NULL));
                if (look == 2) assert_ok(algsurf_scene_set_material(scene, &soot));
                picture *whole = drawn(scene, 1);
                check_choices(scene, whole, threshold);
                if (first) assert_same_picture(first, whole);
                if (look == 2 && threshold) /* black on black: its outline is chosen by alpha */
                    assert_true(whole->stats.rays > W * H && whole->stats.rays < 9 * W * H);
                if (!first) first = whole;
            }
        }
}

/* One row may be as far from the next as any object goes, two only half as far.  Catches: a border one off,
 * or of all rows of the picture. */
TEST(far_strides) {
    enum { WHERE = H / 2 };
    static uint8_t bytes[2 * 3 * W], whole[H * 3 * W];
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, 2);
    algsurf_render_options o = options_for(1);
    algsurf_picture planes = {.size = sizeof planes, .pixels = bytes, .format = ALGSURF_RGB8};
    draw_pixels(scene, ALGSURF_RGB8, whole);
    o.row_begin = WHERE;
    for (int rows = 1; rows <= 2; rows++) {
        o.row_end = WHERE + rows;
        planes.stride = (size_t)PTRDIFF_MAX / (size_t)rows + 1;
        assert_int_equal(algsurf_render(scene, &o, &planes, NULL), ALGSURF_E_ARGUMENT);
    }
    o.row_end = WHERE + 1;
    planes.stride = (size_t)PTRDIFF_MAX;
    assert_ok(algsurf_render(scene, &o, &planes, NULL));
    assert_memory_equal(bytes, whole + WHERE * 3 * W, 3 * W);
}

/* Rows of any distance, and without a gap. */
TEST(strides) {
    enum { GAP = 7 };
    static uint8_t tight[H * 4 * W], apart[H * (4 * W + GAP)];
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, 2);
    const algsurf_render_options o = options_for(2);
    for (int format = ALGSURF_RGB8; format <= ALGSURF_RGBA8; format++) {
        size_t row = (size_t)(format == ALGSURF_RGBA8 ? 4 : 3) * W;
        const algsurf_picture planes = {
            .size = sizeof planes, .pixels = apart, .stride = row + GAP, .format = format};
        memset(apart, SENTINEL, sizeof apart);
        draw_pixels(scene, format, tight);
        assert_ok(algsurf_render(scene, &o, &planes, NULL));
        for (size_t y = 0; y < H; y++) {
            const uint8_t *there = apart + y * (row + GAP);
            assert_memory_equal(there, tight + y * row, row);
            for (size_t i = row; i < row + GAP; i++) assert_int_equal(there[i], SENTINEL);
        }
    }
}
