/* test_render_antialias.c - pictures of which only some pixels get all samples: pixel by pixel one of two
 * pictures without a threshold, of one sample and of n x n, whoever draws them.
 *
 * Breaks tried, each caught by the test named:
 *   right or lower neighbour not looked at, >= for >, one channel left out           one_of_two
 *   rows beyond a slice or a batch not looked at; a row's place in the ring wrong     one_of_two, same_bytes
 *   middle not added for odd n, or added twice                                       one_of_two
 *   its normal taken though another sample is nearer                                 one_of_two
 *   unwanted pixels of a run sampled, or of a row that is left to single rays        counts_as_by_rays
 *   counts of rows that are only looked at                                           same_bytes
 *   roots of pixels that were left out taken for start values                        same_bytes
 *   a row of middles left from before a gap in a worker's rows                       same_bytes
 *   the pixel beyond the row's end read                                              thin_pictures
 *   abandoned rows written                                                           cancel
 *   alpha left out where it is not asked for                                         same_choice
 *   a sheet told without its chords                                                  proofs
 *   one corner not looked at, or its colour; hits of corners not compared            one_of_two
 *   a limit of half the threshold, or of none                                        one_of_two, proofs
 *   colours of corners missing where no bytes are asked for                          same_choice
 */
#include "render_case.h"

/* Ways to draw the torus: by packets, ray by ray, in complex space. */
static const struct way {
    const char *name;
    algsurf_quality quality;
    int method;
    int complex;
    algsurf_coherence coherence;
} ways[] = {
    {"preview", ALGSURF_QUALITY_PREVIEW, ALGSURF_METHOD_DEFAULT, 0, ALGSURF_COHERENCE_NONE},
    {"standard", ALGSURF_QUALITY_STANDARD, ALGSURF_METHOD_DEFAULT, 0, ALGSURF_COHERENCE_NONE},
    {"full", ALGSURF_QUALITY_FULL, ALGSURF_METHOD_DEFAULT, 0, ALGSURF_COHERENCE_NONE},
    {"singly", ALGSURF_QUALITY_STANDARD, ALGSURF_METHOD_BRENT, 0, ALGSURF_COHERENCE_NONE},
    {"complex", ALGSURF_QUALITY_STANDARD, ALGSURF_METHOD_DEFAULT, 1, ALGSURF_COHERENCE_NONE},
    {"coherent", ALGSURF_QUALITY_FULL, ALGSURF_METHOD_DEFAULT, 1, ALGSURF_COHERENCE_NEIGHBOURS},
};
enum { WAYS = sizeof ways / sizeof *ways };

static algsurf_scene *scene_in(const struct way *way, const algsurf_surface *surface) {
    const algsurf_intersect_options options = {.size = sizeof options, .method = way->method};
    const double four = 4;
    const algsurf_complex_space space = {
        .size = sizeof space, .sector = {0, 0.1}, .imaginary = &four, .imaginary_count = 1};
    const double sky[3] = {0.6, 0.1, 0.02};
    algsurf_scene *scene = torus_scene(surface, way->quality, 1);
    assert_ok(algsurf_scene_set_background(scene, sky));
    assert_ok(algsurf_scene_set_intersect_options(scene, &options));
    assert_ok(algsurf_scene_set_complex_space(scene, way->complex ? &space : NULL));
    assert_ok(algsurf_scene_set_coherence(scene, way->coherence));
    return scene;
}

static void set(algsurf_scene *scene, int n, double threshold) {
    assert_ok(algsurf_scene_set_antialias(scene, n));
    assert_ok(algsurf_scene_set_antialias_threshold(scene, threshold));
}

/* Does the pixel (x,y) of a picture of one sample differ by more than the threshold from a neighbour? */
static int stands_out(const uint8_t *bytes, int stride, int width, int height, int x, int y,
                      double threshold) {
    static const int dx[4] = {0, 0, -1, 1}, dy[4] = {-1, 1, 0, 0};
    for (int n = 0; n < 4; n++) {
        int i = x + dx[n], j = y + dy[n];
        if (i < 0 || i >= width || j < 0 || j >= height) continue;
        for (int k = 0; k < 3; k++)
            if (abs(bytes[y * stride + 3 * x + k] - bytes[j * stride + 3 * i + k]) > 255 * threshold)
                return 1;
    }
    return 0;
}

/* Packets round otherwise where a row is solved in parts. */
static int same_hit(double a, double b) {
    return isinf(a) || isinf(b) ? a == b : fabs(a - b) <= 0x1p-44 * fabs(b);
}

static int same_normal(const float *a, const float *b) {
    return fmaxf(fabsf(a[0] - b[0]), fmaxf(fabsf(a[1] - b[1]), fabsf(a[2] - b[2]))) <= 1e-6F;
}

/* The samples of n x n a pixel: a picture with n times more pixels each way. */
typedef struct samples {
    int n, width; /* of its rows */
    double *t;
    uint8_t *bytes;
} samples;

static samples samples_of(algsurf_scene *scene, int n, int width, int height) {
    const algsurf_render_options o = {
        .size = sizeof o, .width = n * width, .height = n * height, .threads = 1};
    const size_t count = (size_t)(n * width * n * height);
    const samples s = {n, n * width, unit_keep(malloc(count * sizeof *s.t), free),
                       unit_keep(malloc(3 * count), free)};
    const algsurf_picture planes = {.size = sizeof planes, .t = s.t, .pixels = s.bytes};
    assert_true(s.t && s.bytes);
    set(scene, 1, 0);
    assert_ok(algsurf_render(scene, &o, &planes, NULL));
    return s;
}

static int sample_at(const samples *s, int x, int y, int k) {
    return (s->n * y + k / s->n) * s->width + s->n * x + k % s->n;
}

/* Do all samples of a pixel hit, or all miss?  Only then may a proof have found no edge in it. */
static int is_of_one_kind(const samples *s, int x, int y) {
    int hits = 0;
    for (int k = 0; k < s->n * s->n; k++) hits += isfinite(s->t[sample_at(s, x, y, k)]);
    return hits == 0 || hits == s->n * s->n;
}

/* Do the corners of a pixel show an edge, by its middle?  1: yes; -1: no; 0: bytes do not tell. */
static int shows_edge(const samples *s, int x, int y, int middle_hits, const uint8_t *middle,
                      double threshold) {
    const int corners[4] = {0, s->n - 1, s->n * (s->n - 1), s->n * s->n - 1};
    const int limit = (int)(255 * threshold / 4);
    double sum[3] = {0, 0, 0};
    uint8_t mean[3];
    int hits = 0, most = 0;
    for (int c = 0; c < 4; c++) {
        const int at = sample_at(s, x, y, corners[c]);
        double colour[3];
        assert_ok(algsurf_srgb_decode(s->bytes + 3 * at, colour));
        hits += isfinite(s->t[at]);
        for (int k = 0; k < 3; k++) sum[k] += colour[k] / 4;
    }
    if (hits != (middle_hits ? 4 : 0)) return 1;
    if (hits == 0) return -1;
    assert_ok(algsurf_srgb_encode(sum, mean));
    for (int k = 0; k < 3; k++) most = abs(mean[k] - middle[k]) > most ? abs(mean[k] - middle[k]) : most;
    return most > limit + 1 ? 1 : most < limit ? -1 : 0;
}

static int shows(const picture *p, const picture *expected, int x, int y) {
    int i = y * W + x;
    return memcmp(p->bytes + y * STRIDE + 3 * x, expected->bytes + y * STRIDE + 3 * x, 3) == 0 &&
           same_hit(p->hits[i], expected->hits[i]) && p->states[i] == expected->states[i] &&
           same_normal(p->normals + 3 * i, expected->normals + 3 * i);
}

/* A pixel that stands out shows all its samples; or its middle alone, if its corners show no edge, or there
 * was a proof.  In full quality the colours of samples are those of their pixel. */
static void check(const struct way *way, const picture *one, const picture *all, const samples *several,
                  const picture *p, double threshold) {
    uint64_t chosen = 0, spared = 0, proved = 0;
    for (int i = 0; i < W * H; i++) {
        int x = i % W, y = i / W, out = stands_out(one->bytes, STRIDE, W, H, x, y, threshold);
        int is_all = shows(p, all, x, y), is_one = shows(p, one, x, y);
        int edge = out ? shows_edge(several, x, y, isfinite(one->hits[i]), one->bytes + y * STRIDE + 3 * x,
                                    threshold)
                       : -1;
        if (out && way->quality == ALGSURF_QUALITY_FULL) edge = 0;
        if (edge < 0   ? !is_one
            : edge > 0 ? !is_all && !(is_one && is_of_one_kind(several, x, y))
                       : !is_all && !is_one)
            fail_msg("%s, n = %d, threshold %g: pixel %d,%d is not that of %s", way->name, several->n,
                     threshold, x, y, edge < 0 ? "one sample" : "n x n samples");
        chosen += out && !is_one;
        spared += out && is_one;
        proved += edge > 0 && is_one;
    }
    for (int i = 0; i < W * H && p->stats.tiles == 0; i++)
        assert_true(p->ways[i] < 4 && (p->stats.single_rays > 0 || p->ways[i] != ALGSURF_WAY_SINGLE));
    assert_in_range(chosen + spared, W * H / 50, W * H * 3 / 4);
    assert_true(way->complex || way->method ? proved < W * H / 20 : chosen > 0);
    uint64_t more = p->stats.rays - W * H, each = (uint64_t)(several->n * several->n);
    assert_true(more >= chosen * each && more <= (chosen + spared) * each);
    assert_true(p->stats.hits > one->stats.hits && p->stats.hits <= one->stats.hits + all->stats.hits);
    assert_true(way->quality != ALGSURF_QUALITY_FULL || way->complex || p->stats.shadow_s > 0);
    for (int y = 0; y < H; y++)
        for (int i = 3 * W; i < STRIDE; i++) assert_int_equal(p->bytes[y * STRIDE + i], SENTINEL);
}

/* 51/255: differences of exactly the threshold are frequent enough to count. */
TEST(one_of_two) {
    static const double thresholds[] = {0.01, 51 / 255., 0.35};
    algsurf_surface *surface = torus();
    for (const struct way *way = ways; way < ways + WAYS; way++) {
        algsurf_scene *scene = scene_in(way, surface);
        picture *one = drawn(scene, 1);
        for (int n = 2; n <= 3; n++) {
            const samples several = samples_of(scene, n, W, H);
            set(scene, n, 0);
            picture *all = drawn(scene, 1);
            for (int k = 0; k < 3; k++) {
                set(scene, n, thresholds[k]);
                picture *p = drawn(scene, 1);
                check(way, one, all, &several, p, thresholds[k]);
            }
        }
    }
}

static void assert_same_counts(const algsurf_render_stats *a, const algsurf_render_stats *b) {
    assert_true(a->rays == b->rays && a->hits == b->hits && a->undecided == b->undecided);
    assert_true(a->shadow_rays == b->shadow_rays && a->single_rays == b->single_rays);
    assert_true(a->iterations == b->iterations);
}

TEST(same_bytes) {
    static const int threads[4] = {2, 3, 7, 256};
    algsurf_surface *surface = torus();
    for (const struct way *way = ways; way < ways + WAYS; way++) {
        algsurf_scene *scene = scene_in(way, surface);
        set(scene, 3, 0.1);
        picture *one = drawn(scene, 1);
        for (int k = 0; k <= 4; k++) {
            picture *other =
                k < 4 ? drawn(scene, threads[k]) : sliced(scene, (const int[]){0, 1, 9, 12, 13, H});
            assert_same_picture(one, other);
            assert_same_counts(&one->stats, &other->stats);
        }
    }
}

/* Threshold 0 is all pixels, 1 none, and one sample is one sample. */
TEST(ends) {
    algsurf_surface *surface = torus();
    for (const struct way *way = ways; way < ways + WAYS; way++) {
        algsurf_scene *scene = scene_in(way, surface);
        picture *one = drawn(scene, 1), *p;
        set(scene, 1, 0.01);
        p = drawn(scene, 2);
        assert_same_picture(one, p);
        assert_same_counts(&one->stats, &p->stats);
        set(scene, 3, 1);
        p = drawn(scene, 2);
        assert_same_picture(one, p);
        assert_true(p->stats.rays == W * H && p->stats.hits == one->stats.hits);
        set(scene, 2, 0);
        p = drawn(scene, 2);
        assert_true(p->stats.rays == 4 * W * H);
    }
}

/* Pictures of one column, one row, one pixel. */
TEST(thin_pictures) {
    static const int sizes[][2] = {{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 40}};
    algsurf_surface *surface = torus();
    algsurf_scene *scene = scene_in(&ways[1], surface);
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        int w = sizes[s][0], h = sizes[s][1], chosen = 0;
        uint8_t *bytes[3];
        algsurf_render_options o = {.size = sizeof o, .width = w, .height = h, .threads = 1};
        for (int k = 0; k < 3; k++) { /* of its exact size: the sanitizer sees what is beyond */
            set(scene, k > 0 ? 4 : 1, k > 1 ? 0.1 : 0);
            bytes[k] = malloc((size_t)(3 * w * h));
            assert_non_null(bytes[k]);
            const algsurf_picture planes = {.size = sizeof planes, .pixels = bytes[k]};
            assert_ok(algsurf_render(scene, &o, &planes, NULL));
        }
        for (int i = 0; i < w * h; i++) {
            int out = stands_out(bytes[0], 3 * w, w, h, i % w, i / w, 0.1);
            if (!out || memcmp(bytes[2] + 3 * i, bytes[1] + 3 * i, 3) != 0) /* or no edge: corners, a proof */
                assert_memory_equal(bytes[2] + 3 * i, bytes[0] + 3 * i, 3);
            chosen += out;
        }
        assert_true(w * h == 1 ? chosen == 0 : s < 3 || chosen > 0);
        for (int k = 0; k < 3; k++) free(bytes[k]);
    }
}

/* No more rays and hits than ray by ray, where nothing is proved of pixels; not many fewer.  Also from
 * inside, so near and wide that packets leave rows to single rays. */
TEST(counts_as_by_rays) {
    const algsurf_camera cameras[2] = {camera_at(7, 4, 5, 36), camera_at(0.5, 0.3, 0.2, 150)};
    algsurf_surface *surface = torus();
    for (int k = 0; k < 2; k++) {
        picture *p[2];
        for (int singly = 0; singly < 2; singly++) {
            algsurf_scene *scene = scene_in(&ways[singly ? 3 : 1], surface);
            assert_ok(algsurf_scene_set_camera(scene, &cameras[k]));
            set(scene, 4, 0.1);
            p[singly] = drawn(scene, 1);
        }
        assert_true(p[0]->stats.rays <= p[1]->stats.rays && p[0]->stats.hits <= p[1]->stats.hits);
        assert_true(p[0]->stats.rays > p[1]->stats.rays / 2);
        assert_true(p[1]->stats.single_rays == p[1]->stats.rays);
        assert_true(k == 0 ? p[0]->stats.single_rays < W * H / 50 : p[0]->stats.single_rays > W * H / 2);
    }
}

/* Alpha counts where it is not asked for, and with 0.99 nothing else here; colours count without bytes. */
TEST(same_choice) {
    static uint8_t pixels[4 * W * H];
    algsurf_surface *surface = torus();
    algsurf_scene *scene = scene_in(&ways[1], surface);
    algsurf_render_options o = options_for(1);
    assert_ok(algsurf_scene_set_background(scene, NULL));
    for (int fine = 0; fine < 2; fine++) {
        uint64_t rays[3];
        set(scene, 2 + fine, fine ? 0.03 : 0.99);
        for (int k = 0; k < 3; k++) {
            algsurf_render_stats stats = {.size = sizeof stats};
            const algsurf_picture planes = {.size = sizeof planes,
                                            .pixels = k < 2 ? pixels : NULL,
                                            .format = k == 1 ? ALGSURF_RGBA8 : ALGSURF_RGB8};
            assert_ok(algsurf_render(scene, &o, &planes, &stats));
            rays[k] = stats.rays;
        }
        assert_true(rays[0] > W * H && rays[1] == rays[0] && rays[2] == rays[0]);
    }
}

/* ---- proofs ---- */

enum { WIDE = 160, HIGH = 120, ACROSS = 4 };

/* A scene whose proofs are attacked. */
enum { LARGE_WIDE = 320, LARGE_HIGH = 240 }; /* where tiles pay */

typedef struct attack {
    const char *equation;
    double radius, eye, threshold;
    int planes;
} attack;

static const algsurf_plane cut = {{1, 0.5, -0.25}, 0.3};

static double t_at(const algsurf_surface *surface, const algsurf_extent *extent, const attack *a,
                   const algsurf_camera *camera, const double place[2]) {
    const algsurf_intersect_options how = {
        .size = sizeof how, .planes = &cut, .plane_count = (size_t)a->planes};
    algsurf_ray ray = pixel_ray(camera, LARGE_WIDE, LARGE_HIGH, place[0], place[1]);
    algsurf_hit hit = first_hit_of(surface, extent, &ray, &how);
    return hit.state == ALGSURF_STATE_HIT ? hit.t : INFINITY;
}

/* What is left of the step in t between two samples after 40 halvings of the way, towards the larger step: on
 * one sheet, nothing. */
static double jump_between(const algsurf_surface *surface, const algsurf_extent *extent, const attack *a,
                           const algsurf_camera *camera, double from[2], double to[2]) {
    double t0 = t_at(surface, extent, a, camera, from), t1 = t_at(surface, extent, a, camera, to);
    for (int i = 0; i < 40 && t0 != t1; i++) {
        const double middle[2] = {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
        const double t = t_at(surface, extent, a, camera, middle);
        int later = fabs(t1 - t) > fabs(t - t0);
        memcpy(later ? from : to, middle, sizeof middle);
        *(later ? &t0 : &t1) = t;
    }
    return t0 == t1 ? 0 : fabs(t1 - t0);
}

/* All samples of pixel x,y miss, or see one sheet. */
static void check_proof(const algsurf_surface *surface, const algsurf_extent *extent, const attack *a,
                        const algsurf_camera *camera, int x, int y) {
    for (int k = 0; k < ACROSS * ACROSS; k++)
        for (int down = 0; down < 2; down++) {
            int i = k % ACROSS, j = k / ACROSS;
            if ((down ? j : i) + 1 == ACROSS) continue;
            double from[2] = {x + (i + 0.5) / ACROSS, y + (j + 0.5) / ACROSS}, to[2] = {from[0], from[1]};
            to[down] += 1.0 / ACROSS;
            if (!(jump_between(surface, extent, a, camera, from, to) < 1e-4 * a->radius))
                fail_msg("%s: pixel %d,%d has an edge between samples", a->equation, x, y);
        }
}

static int attack_scene(const attack *a) {
    static uint8_t bytes[3][3 * LARGE_WIDE * LARGE_HIGH];
    static unsigned char ways_of[LARGE_WIDE * LARGE_HIGH];
    static double t[LARGE_WIDE * LARGE_HIGH]; /* of the middles */
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {a->radius, 0, 0}};
    const algsurf_camera camera = camera_at(0.7 * a->eye, 0.5 * a->eye, 0.4 * a->eye, 40);
    const algsurf_render_options o = {
        .size = sizeof o, .width = LARGE_WIDE, .height = LARGE_HIGH, .threads = 1};
    algsurf_surface *surface = surface_of(a->equation);
    algsurf_scene *scene = scene_in(&ways[1], surface);
    int proved = 0;
    assert_ok(algsurf_scene_set_extent(scene, &extent));
    assert_ok(algsurf_scene_set_camera(scene, &camera));
    assert_ok(algsurf_scene_set_clip(scene, &cut, (size_t)a->planes));
    for (int k = 0; k < 3; k++) {
        const algsurf_picture planes = {
            .size = sizeof planes, .pixels = bytes[k], .way = ways_of, .t = k == 0 ? t : NULL};
        set(scene, k > 0 ? ACROSS : 1, k > 1 ? a->threshold : 0);
        assert_ok(algsurf_render(scene, &o, &planes, NULL));
    }
    const samples several = samples_of(scene, ACROSS, LARGE_WIDE, LARGE_HIGH);
    for (int i = 0; i < LARGE_WIDE * LARGE_HIGH; i++) {
        const int x = i % LARGE_WIDE, y = i / LARGE_WIDE, known = ways_of[i] & 3;
        const uint8_t *middle = bytes[0] + 3 * i;
        if (!stands_out(bytes[0], 3 * LARGE_WIDE, LARGE_WIDE, LARGE_HIGH, x, y, a->threshold)) continue;
        if (known != ALGSURF_WAY_EMPTY && known != ALGSURF_WAY_SHEET) {
            int edge = shows_edge(&several, x, y, isfinite(t[i]), middle, a->threshold);
            if (edge) assert_memory_equal(bytes[2] + 3 * i, edge > 0 ? bytes[1] + 3 * i : middle, 3);
            continue;
        }
        assert_memory_equal(bytes[2] + 3 * i, middle, 3);
        if (proved++ % 8 == 0) check_proof(surface, &extent, a, &camera, x, y);
    }
    printf("%d pixels with one sample by proof\n", proved);
    return proved;
}

/* Pixels that are left with one sample although they stand out, since their tile is empty or a sheet: single
 * rays, which are certain, look for an edge between their samples.  Of the others corners decide. */
TEST(proofs) {
    static const attack attacks[] = {
        {"(x^2+y^2+z^2+3.51)^2 - 16(x^2+y^2)", 3.2, 10, 0.02, 0},
        {"x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8", 3.7, 14, 0.02, 0},
        {"x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8", 2.2, 9, 0.02, 1},
        {"4(2.618x^2-y^2)(2.618y^2-z^2)(2.618z^2-x^2) - 4.236(x^2+y^2+z^2-1)^2", 2, 4, 0.02, 1},
        {"4(2.618x^2-y^2)(2.618y^2-z^2)(2.618z^2-x^2) - 4.236(x^2+y^2+z^2-1)^2", 2, 4, 0.2, 1},
    };
    for (size_t i = 0; i < sizeof attacks / sizeof *attacks; i++)
        if (attack_scene(attacks + i) < 10 && attacks[i].threshold < 0.1)
            fail_msg("%s: hardly a proof", attacks[i].equation);
}

static int stop_at(int done, int total, void *data) {
    (void)total;
    return done >= *(const int *)data;
}

/* Finished rows are as they should be, others untouched; with helpers, some are in the middle of a row. */
TEST(cancel) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = scene_in(&ways[2], surface);
    picture blanked;
    blank(&blanked);
    set(scene, 8, 0.01);
    picture *whole = drawn(scene, 1), p;
    const algsurf_picture planes = planes_of(&p, 0);
    for (int threads = 1; threads <= 3; threads++)
        for (int rows = 1; rows < H; rows += 11) {
            algsurf_render_options o = options_for(threads);
            int done = 0;
            o.progress = stop_at, o.progress_data = &rows;
            blank(&p);
            assert_int_equal(algsurf_render(scene, &o, &planes, &p.stats), ALGSURF_CANCELLED);
            for (int y = 0; y < H; y++) {
                int finished = memcmp(p.bytes + y * STRIDE, blanked.bytes, STRIDE) != 0;
                assert_same_row(&p, finished ? whole : &blanked, y);
                done += finished;
            }
            assert_true(threads == 1 ? done == rows : done >= rows);
            assert_true(p.stats.rays >= (uint64_t)(done * W) && p.stats.rays <= whole->stats.rays);
        }
}

TEST(bad_thresholds) {
    static const double bad[] = {-1, -0x1p-1074, 0x1.0000000000001p0, 255, INFINITY, -INFINITY, NAN};
    algsurf_surface *surface = torus();
    algsurf_scene *scene = scene_in(&ways[1], surface);
    set(scene, 2, 0.2);
    picture *before = drawn(scene, 1);
    assert_int_equal(algsurf_scene_set_antialias_threshold(NULL, 0.5), ALGSURF_E_ARGUMENT);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_int_equal(algsurf_scene_set_antialias_threshold(scene, bad[i]),
                         isfinite(bad[i]) ? ALGSURF_E_ARGUMENT : ALGSURF_E_NOT_FINITE);
    picture *after = drawn(scene, 1);
    assert_same_picture(before, after);
}
