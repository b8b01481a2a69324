/* test_render_threads.c - the same bytes whoever draws them; progress, cancelling, options.
 *
 * Breaks tried, each caught by the test named:
 *   rows skipped, a buffer shared by two threads, colours summed over rows        same_bytes
 *   abandoned rows written, cancel ignored, progress called after it              cancel
 *   progress without the last call, or from another thread                        progress_calls
 *   more of a caller's struct written than it has                                 sized_structs
 * That no allocation may fail unnoticed is the business of test_memory.
 */
#define _POSIX_C_SOURCE 200809L /* nanosleep */
#include <fenv.h>
#include <pthread.h>

#include "render_case.h"

/* Threads, slices and the caller's rounding mode change nothing; the gap after each row stays as it was. */
TEST(same_bytes) {
    static const int threads[4] = {2, 3, 7, 256};
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_FULL, 2);
    picture *one = drawn(scene, 1), *other;
    assert_int_equal(one->stats.threads, 1);
    for (int y = 0; y < H; y++)
        for (int i = 3 * W; i < STRIDE; i++) assert_int_equal(one->bytes[y * STRIDE + i], SENTINEL);
    for (int k = 0; k < 4; k++) {
        other = drawn(scene, threads[k]);
        assert_same_picture(one, other);
        assert_in_range(other->stats.threads, 1, threads[k] < H ? threads[k] : H);
        assert_true(other->stats.rays == one->stats.rays && other->stats.hits == one->stats.hits);
        assert_true(other->stats.shadow_rays == one->stats.shadow_rays);
    }
    other = sliced(scene, (const int[]){0, 1, 9, 20, H});
    assert_same_picture(one, other);
    assert_true(other->stats.rays == one->stats.rays && other->stats.hits == one->stats.hits);
    assert_true(other->stats.shadow_rays == one->stats.shadow_rays);
    fesetround(FE_UPWARD);
    other = drawn(scene, 3);
    int mode = fegetround();
    fesetround(FE_TONEAREST);
    assert_int_equal(mode, FE_UPWARD);
    assert_same_picture(one, other);
}

typedef struct calls {
    pthread_t caller;
    int count, last, limit, wrong;
    long sleep_ns; /* keeps the caller from drawing: the others do it */
} calls;

static int on_progress(int done, int total, void *data) {
    calls *c = data;
    c->wrong += total != H || done < c->last || done > total || !pthread_equal(pthread_self(), c->caller);
    c->last = done;
    if (c->sleep_ns) nanosleep(&(struct timespec){0, c->sleep_ns}, NULL);
    return ++c->count == c->limit;
}

TEST(progress_calls) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, 2);
    picture p;
    for (int threads = 1; threads <= 4; threads++) {
        calls c = {.caller = pthread_self(), .sleep_ns = threads > 1 ? 30000000 : 0};
        algsurf_render_options o = options_for(threads);
        o.progress = on_progress, o.progress_data = &c;
        blank(&p);
        render(scene, &o, &p);
        assert_int_equal(c.wrong, 0);
        assert_int_equal(c.last, H);
        if (threads == 1) assert_int_equal(c.count, H);
    }
}

/* A cancelled picture: each row is as it should be or untouched.  Rows take long enough here for the
 * others to be in the middle of one when the caller cancels. */
TEST(cancel) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_FULL, 3);
    picture *whole = drawn(scene, 1), p;
    picture blanked;
    const algsurf_picture planes = planes_of(&p, H / 2);
    blank(&blanked);
    for (int threads = 1; threads <= 3; threads++) {
        calls c = {.caller = pthread_self(), .limit = threads == 1 ? 2 : 1};
        algsurf_render_options o = options_for(threads);
        int done = 0;
        o.progress = on_progress, o.progress_data = &c;
        o.row_begin = H / 2, o.row_end = H; /* the surface begins at once */
        blank(&p);
        assert_int_equal(algsurf_render(scene, &o, &planes, &p.stats), ALGSURF_CANCELLED);
        assert_int_equal(c.count, c.limit); /* not called again */
        for (int y = 0; y < H; y++) {
            int finished = memcmp(p.bytes + y * STRIDE, whole->bytes + y * STRIDE, 3 * W) == 0;
            assert_same_row(&p, finished ? whole : &blanked, y);
            done += finished;
        }
        assert_true(threads == 1 ? done == 2 : done >= 1);
        assert_true(p.stats.rays >= (uint64_t)(done * W * 9) && p.stats.rays <= whole->stats.rays);
    }
}

static void refuse(const algsurf_scene *scene, const algsurf_render_options *o, algsurf_status expected) {
    picture p, before;
    const algsurf_picture planes = planes_of(&p, 0);
    blank(&p), blank(&before);
    assert_int_equal(algsurf_render(scene, o, &planes, &p.stats), expected);
    assert_memory_equal(&p, &before, sizeof p);
}

TEST(bad_planes) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, 1);
    const algsurf_render_options o = options_for(1);
    picture p, before;
    const algsurf_picture good = planes_of(&p, 0);
    algsurf_picture bad;
    blank(&p), blank(&before);
    assert_int_equal(algsurf_render(scene, &o, NULL, &p.stats), ALGSURF_E_ARGUMENT);
#define REFUSE(change)                                                                                       \
    (bad = good, (change), assert_int_equal(algsurf_render(scene, &o, &bad, &p.stats), ALGSURF_E_ARGUMENT))
    for (bad = good, bad.size = 0; bad.size < sizeof bad; bad.size++) /* none of any release */
        assert_int_equal(algsurf_render(scene, &o, &bad, &p.stats), ALGSURF_E_SIZE);
    REFUSE(bad.stride = 1);
    REFUSE(bad.stride = 3 * W - 1);
    REFUSE((bad.stride = 4 * W - 1, bad.format = ALGSURF_RGBA8));
    REFUSE(bad.stride = SIZE_MAX);
    REFUSE(bad.stride = (size_t)PTRDIFF_MAX / H + 1);
    REFUSE(bad.format = -1);
    REFUSE(bad.format = ALGSURF_RGBA8 + 1);
#undef REFUSE
    assert_memory_equal(&p, &before, sizeof p);
}

TEST(bad_options) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, 1);
    const algsurf_render_options good = options_for(1);
    algsurf_render_options o = good;
    picture p;
    const algsurf_picture planes = planes_of(&p, 0);
    refuse(NULL, &good, ALGSURF_E_ARGUMENT);
    refuse(scene, NULL, ALGSURF_E_ARGUMENT);
#define REFUSE(change) (o = good, (change), refuse(scene, &o, ALGSURF_E_ARGUMENT))
    for (o.size = 0; o.size < sizeof o; o.size++) /* none of any release */
        refuse(scene, &o, ALGSURF_E_SIZE);
    REFUSE(o.width = 0);
    REFUSE(o.width = 65536);
    REFUSE(o.height = -1);
    REFUSE(o.height = 65536);
    REFUSE(o.row_begin = -1);
    REFUSE((o.row_begin = 3, o.row_end = 3));
    REFUSE(o.row_begin = 3); /* row_end = 0 means "all" only when both are 0 */
    REFUSE(o.row_end = H + 1);
    REFUSE(o.row_end = -1);
    REFUSE(o.threads = -1);
    REFUSE(o.threads = 257);
#undef REFUSE
    blank(&p);
    for (p.stats.size = 0; p.stats.size < sizeof p.stats; p.stats.size++)
        assert_int_equal(algsurf_render(scene, &good, &planes, &p.stats), ALGSURF_E_SIZE);
    assert_int_equal(p.bytes[0], SENTINEL);
    algsurf_camera huge = camera_at(7, 4, 5, 36);
    huge.kind = ALGSURF_CAMERA_ORTHOGRAPHIC, huge.half_height = 1.7e308;
    assert_ok(algsurf_scene_set_camera(scene, &huge));
    refuse(scene, &good, ALGSURF_E_NOT_FINITE);
}

/* Structs of newer callers. */
TEST(sized_structs) {
    algsurf_surface *surface = torus();
    algsurf_scene *scene = torus_scene(surface, ALGSURF_QUALITY_STANDARD, 1);
    picture *whole = drawn(scene, 1), p;
    struct {
        algsurf_render_options o;
        double more;
    } newer = {.o = options_for(1)};
    struct {
        algsurf_render_stats s;
        double more;
    } stats = {.more = 7};
    struct {
        algsurf_picture p;
        double more;
    } planes = {.p = planes_of(&p, 0)};
    newer.o.size = sizeof newer, stats.s.size = sizeof stats, planes.p.size = sizeof planes;
    blank(&p);
    assert_ok(algsurf_render(scene, &newer.o, &planes.p, &stats.s));
    assert_same_picture(whole, &p);
    assert_true(stats.s.rays == W * H && stats.more == 0 && stats.s.size == sizeof stats);
    planes.more = 1;
    assert_int_equal(algsurf_render(scene, &newer.o, &planes.p, NULL), ALGSURF_E_SIZE);
    planes.more = 0, newer.more = 1;
    assert_int_equal(algsurf_render(scene, &newer.o, &planes.p, NULL), ALGSURF_E_SIZE);
}
