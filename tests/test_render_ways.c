/* test_render_ways.c - how each pixel of a picture was decided, and what was counted: the plane of ways
 * against the states, the counts against the plane, and both by slices and threads.
 *
 * Breaks tried, each caught by the test named:
 *   an empty tile told with the side of its quarters, or of the one it is a quarter of   tiles
 *   a sheet told where Newton's method gave up, a leaf told as a sheet                   counts
 *   tiles beyond the picture's right edge counted, or those quartered counted as empty   counts
 *   a band counted by each of its rows, by no slice that begins inside it, or by each
 *   worker that draws its middles                                                        slices
 *   the way of the sample drawn last; of pixels that get one sample, none                samples
 *   single rays all counted as exact, or those of the bounded tier                       exact
 */
#include "catalogue.h"
#include "scenes.h"

enum { WIDTH = 347, HEIGHT = 331, LARGEST = 16, SMALLEST = 4, KIND = 3 };

typedef struct drawn {
    unsigned char ways[HEIGHT * WIDTH], states[HEIGHT * WIDTH];
    algsurf_render_stats stats;
} drawn;

static algsurf_camera camera_of(const algsurf_extent *extent) {
    const double eye[3] = {2.2 * extent->size[0], -3.3 * extent->size[0], 1.1 * extent->size[0]},
                 up[3] = {0, 0, 1};
    algsurf_camera camera = pinhole_of(eye, extent->centre, up, 32);
    return camera;
}

static algsurf_scene *scene_about(const algsurf_surface *surface, const algsurf_extent *extent,
                                  const algsurf_intersect_options *how) {
    const algsurf_camera camera = camera_of(extent);
    return scene_of(surface, extent, &camera, how);
}

/* Rows from `begin` to end - 1 of d. */
static void draw(const algsurf_scene *scene, int begin, int end, int threads, drawn *d) {
    const algsurf_picture planes = {.size = sizeof planes,
                                    .way = d->ways + (size_t)begin * WIDTH,
                                    .state = d->states + (size_t)begin * WIDTH};
    const algsurf_render_options o = {.size = sizeof o,
                                      .width = WIDTH,
                                      .height = HEIGHT,
                                      .row_begin = begin,
                                      .row_end = end,
                                      .threads = threads};
    d->stats.size = sizeof d->stats;
    assert_ok(algsurf_render(scene, &o, &planes, &d->stats));
}

static int side_of(const drawn *d, int x, int y) { return d->ways[y * WIDTH + x] & ~KIND; }

/* How many pixels were decided so, in tiles of that side; -1: of any. */
static uint64_t count(const drawn *d, algsurf_way way, int side) {
    uint64_t n = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        n += (d->ways[i] & KIND) == (int)way && (side < 0 || (d->ways[i] & ~KIND) == side);
    return n;
}

/* The scenes drawn here: one without singular points, one with double lines. */
static void for_each_scene(void (*check)(const algsurf_scene *scene, const algsurf_surface *surface,
                                         const algsurf_extent *extent)) {
    static const char *const names[] = {"torus", "steiner"};
    for (int i = 0; i < 2; i++) {
        const catalogue_entry *entry = catalogue_find(names[i]);
        algsurf_surface *surface = surface_of(entry->equation);
        algsurf_scene *scene = scene_about(surface, &entry->extent, NULL);
        check(scene, surface, &entry->extent);
    }
}

/* ---- the plane ---- */

/* All pixels of a tile have its side, and all of an empty one are empty. */
static void check_tile_of(const drawn *d, int x, int y) {
    int side = side_of(d, x, y), i = y * WIDTH + x, first = (y - y % side) * WIDTH + x - x % side;
    int empty = (d->ways[i] & KIND) == ALGSURF_WAY_EMPTY, sheet = (d->ways[i] & KIND) == ALGSURF_WAY_SHEET;
    assert_true(side == 16 || side == 8 || side == 4);
    assert_int_equal(d->ways[first] & ~KIND, side);
    assert_int_equal((d->ways[first] & KIND) == ALGSURF_WAY_EMPTY, empty);
    if (empty) assert_int_equal(d->states[i], ALGSURF_STATE_MISS);
    if (sheet) assert_int_equal(d->states[i], ALGSURF_STATE_HIT);
}

static void check_tiles(const algsurf_scene *scene, const algsurf_surface *surface,
                        const algsurf_extent *extent) {
    static drawn d;
    (void)surface, (void)extent;
    draw(scene, 0, HEIGHT, 1, &d);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) check_tile_of(&d, x, y);
    for (int side = SMALLEST; side <= LARGEST; side *= 2)
        assert_true(count(&d, ALGSURF_WAY_EMPTY, side) > 500 && count(&d, ALGSURF_WAY_SHEET, side) > 500);
    assert_true(count(&d, ALGSURF_WAY_ROW, SMALLEST) > 500);
}

TEST(tiles) { for_each_scene(check_tiles); }

/* ---- the counts ---- */

/* Tiles by their first pixels: those that were searched at a size, and what the smallest, or the decided,
 * are. A sheet's tile shows the sheet somewhere. */
static void count_tiles(const drawn *d, uint64_t *searched, uint64_t *empty, uint64_t *sheets) {
    *searched = *empty = *sheets = 0;
    for (int side = SMALLEST; side <= LARGEST; side *= 2)
        for (int y = 0; y < HEIGHT; y += side)
            for (int x = 0; x < WIDTH; x += side) {
                int some = 0;
                *searched += side_of(d, x, y) <= side;
                if (side_of(d, x, y) != side) continue;
                for (int j = y; j < y + side && j < HEIGHT; j++)
                    for (int i = x; i < x + side && i < WIDTH; i++)
                        some |= (d->ways[j * WIDTH + i] & KIND) == ALGSURF_WAY_SHEET;
                *sheets += some != 0;
                *empty += (d->ways[y * WIDTH + x] & KIND) == ALGSURF_WAY_EMPTY;
            }
}

static void check_counts(const algsurf_scene *scene, const algsurf_surface *surface,
                         const algsurf_extent *extent) {
    static drawn d;
    uint64_t searched, empty, sheets, quartered = 0;
    (void)surface, (void)extent;
    draw(scene, 0, HEIGHT, 1, &d);
    count_tiles(&d, &searched, &empty, &sheets);
    for (int side = 2 * SMALLEST; side <= LARGEST; side *= 2)
        for (int y = 0; y < HEIGHT; y += side)
            for (int x = 0; x < WIDTH; x += side) quartered += side_of(&d, x, y) < side;
    /* the largest tiles are not searched where all rays stay clear of what is shown */
    assert_true(d.stats.tiles <= searched && d.stats.tiles > searched / 2);
    assert_int_equal(empty - d.stats.empty_tiles, searched - d.stats.tiles);
    assert_int_equal(d.stats.sheet_tiles, sheets);
    assert_int_equal(d.stats.leaf_tiles, searched - quartered - empty - sheets);
    assert_int_equal(d.stats.empty_rays, count(&d, ALGSURF_WAY_EMPTY, -1));
    assert_int_equal(d.stats.sheet_rays, count(&d, ALGSURF_WAY_SHEET, -1));
    assert_int_equal(d.stats.single_rays, count(&d, ALGSURF_WAY_SINGLE, -1));
}

TEST(counts) { for_each_scene(check_counts); }

/* ---- slices, threads, samples ---- */

static void add_counts(uint64_t sum[8], const algsurf_render_stats *s) {
    const uint64_t more[8] = {s->tiles,      s->empty_tiles, s->sheet_tiles, s->leaf_tiles,
                              s->empty_rays, s->sheet_rays,  s->single_rays, s->exact_rays};
    for (int i = 0; i < 8; i++) sum[i] += more[i];
}

/* Cut between two bands, and inside one: then its tiles count twice. */
static void check_slices(const algsurf_scene *scene, const algsurf_surface *surface,
                         const algsurf_extent *extent) {
    static drawn whole, parts;
    static const int cut_at[] = {160, 173};
    (void)surface, (void)extent;
    draw(scene, 0, HEIGHT, 1, &whole);
    for (int c = 0; c < 2; c++) {
        uint64_t sum[8] = {0}, all[8] = {0};
        draw(scene, 0, cut_at[c], 1, &parts), add_counts(sum, &parts.stats);
        draw(scene, cut_at[c], HEIGHT, 2, &parts), add_counts(sum, &parts.stats);
        assert_memory_equal(parts.ways, whole.ways, sizeof whole.ways);
        add_counts(all, &whole.stats);
        if (c == 1) {
            uint64_t again[8] = {0};
            draw(scene, 160, 176, 1, &parts), add_counts(again, &parts.stats);
            assert_true(again[0] > 0);
            for (int i = 0; i < 4; i++) all[i] += again[i];
        }
        assert_memory_equal(sum, all, sizeof sum);
    }
}

static void check_threads(const algsurf_scene *scene) {
    static drawn one, more;
    uint64_t a[8] = {0}, b[8] = {0};
    draw(scene, 0, HEIGHT, 1, &one), add_counts(a, &one.stats);
    draw(scene, 0, HEIGHT, 3, &more), add_counts(b, &more.stats);
    assert_memory_equal(a, b, sizeof a);
    assert_memory_equal(one.ways, more.ways, sizeof one.ways);
}

TEST(slices) {
    const catalogue_entry *entry = catalogue_find("torus");
    algsurf_surface *surface = surface_of(entry->equation);
    algsurf_scene *scene = scene_about(surface, &entry->extent, NULL);
    for_each_scene(check_slices);
    for (int way = 0; way < 3; way++) {
        assert_ok(algsurf_scene_set_antialias(scene, way ? 3 : 1));
        assert_ok(algsurf_scene_set_antialias_threshold(scene, way == 2 ? 0.05 : 0));
        check_threads(scene);
    }
}

/* The middle is one of 3 x 3 samples; chosen pixels get all of them. */
TEST(samples) {
    static drawn one, some, all, none;
    const catalogue_entry *entry = catalogue_find("steiner");
    algsurf_surface *surface = surface_of(entry->equation);
    algsurf_scene *scene = scene_about(surface, &entry->extent, NULL);
    int raised = 0, kept = 0;
    draw(scene, 0, HEIGHT, 1, &one);
    assert_ok(algsurf_scene_set_antialias(scene, 3));
    draw(scene, 0, HEIGHT, 1, &all);
    assert_ok(algsurf_scene_set_antialias_threshold(scene, 0.1));
    draw(scene, 0, HEIGHT, 1, &some);
    assert_ok(algsurf_scene_set_antialias_threshold(scene, 1));
    draw(scene, 0, HEIGHT, 1, &none);
    assert_memory_equal(none.ways, one.ways, sizeof one.ways);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        assert_int_equal(all.ways[i] & ~KIND, one.ways[i] & ~KIND);
        assert_true(one.ways[i] <= some.ways[i] && some.ways[i] <= all.ways[i]);
        assert_true(some.ways[i] == one.ways[i] || some.ways[i] == all.ways[i]);
        raised += all.ways[i] > one.ways[i];
        kept += all.ways[i] > some.ways[i];
    }
    assert_true(raised > kept && kept > 0);
    assert_int_equal(all.stats.tiles, one.stats.tiles);
    assert_int_equal(all.stats.empty_rays, 9 * one.stats.empty_rays);
}

/* ---- rays ---- */

/* Whom an observer of the ray through a pixel's middle sees decide. */
static int engine_of(const algsurf_surface *surface, const algsurf_extent *extent, int x, int y) {
    const algsurf_camera camera = camera_of(extent);
    algsurf_observer observer = {.size = sizeof observer};
    const algsurf_intersect_options how = {.size = sizeof how, .observer = &observer};
    algsurf_ray ray = pixel_ray(&camera, WIDTH, HEIGHT, x + 0.5, y + 0.5);
    (void)first_hit_of(surface, extent, &ray, &how);
    return observer.engine;
}

/* In a band of rows through the middle. */
enum { FIRST_ROW = 128, END_ROW = 192 };
static drawn band;

static void check_exact(const algsurf_scene *scene, const algsurf_surface *surface,
                        const algsurf_extent *extent) {
    uint64_t integers = 0;
    draw(scene, FIRST_ROW, END_ROW, 1, &band);
    for (int i = FIRST_ROW * WIDTH; i < END_ROW * WIDTH; i++)
        if ((band.ways[i] & KIND) == ALGSURF_WAY_SINGLE)
            integers += engine_of(surface, extent, i % WIDTH, i / WIDTH) == ALGSURF_ENGINE_INTEGERS;
    assert_int_equal(band.stats.exact_rays, integers);
}

/* Every ray that meets a double sphere is for integers. */
TEST(exact) {
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1.5, 0, 0}};
    const algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};
    algsurf_surface *surface = surface_of("(x^2 + y^2 + z^2 - 1)^2 (x + 99)");
    algsurf_scene *scene = scene_about(surface, &ball, NULL), *other = scene_about(surface, &ball, &bounded);
    for_each_scene(check_exact);
    check_exact(scene, surface, &ball);
    assert_true(band.stats.exact_rays >= band.stats.hits && band.stats.hits > 1000);
    draw(other, FIRST_ROW, END_ROW, 1, &band);
    assert_int_equal(band.stats.exact_rays, 0);
    assert_true(band.stats.single_rays > 1000);
}

/* Pictures that are not drawn by tiles: ray by ray, by rows, in complex space. */
TEST(without_tiles) {
    static drawn d;
    const catalogue_entry *torus = catalogue_find("torus"), *decic = catalogue_find("barth-decic");
    const algsurf_intersect_options by_rays = {.size = sizeof by_rays, .method = ALGSURF_METHOD_BRENT};
    const algsurf_complex_space space = {.size = sizeof space, .sector = {0, 0.1}};
    algsurf_surface *surface = surface_of(torus->equation), *high = surface_of(decic->equation);
    algsurf_scene *scene = scene_about(surface, &torus->extent, &by_rays);
    draw(scene, 0, HEIGHT, 2, &d);
    assert_int_equal(count(&d, ALGSURF_WAY_SINGLE, 0), WIDTH * HEIGHT);
    assert_int_equal(d.stats.tiles, 0);
    assert_ok(algsurf_scene_set_complex_space(scene, &space));
    draw(scene, 0, HEIGHT, 2, &d);
    assert_int_equal(count(&d, ALGSURF_WAY_SINGLE, 0), d.stats.single_rays);
    assert_int_equal(count(&d, ALGSURF_WAY_ROW, 0), WIDTH * HEIGHT - d.stats.single_rays);
    scene = scene_about(high, &decic->extent, NULL);
    draw(scene, 0, HEIGHT, 2, &d);
    assert_int_equal(count(&d, ALGSURF_WAY_SINGLE, 0), d.stats.single_rays);
    assert_int_equal(count(&d, ALGSURF_WAY_ROW, 0), WIDTH * HEIGHT - d.stats.single_rays);
    assert_int_equal(d.stats.tiles + d.stats.empty_rays + d.stats.sheet_rays, 0);
}
