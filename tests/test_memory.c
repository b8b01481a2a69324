/* test_memory.c - the n-th allocation fails, for every n; and the n-th thread, and the locks.
 *
 * The linker sends the library's malloc, calloc, realloc and free through the functions below
 * (-Wl,--wrap), which count what is alive and make one chosen allocation fail.  Each call must then
 * either return ALGSURF_E_NO_MEMORY with its outputs untouched, or do without and answer as ever;
 * nothing may stay allocated.  Threads and locks are refused in the same way: a picture is drawn by the
 * threads there are, or ALGSURF_E_THREAD returned.  Catches: an unchecked allocation, a leak on a failure
 * path, an output written before the work was done.  (Seen to fail with a check removed and with a free
 * removed.)  A ray that integers decide needs memory only when it is of high degree, or its numbers are of
 * very different sizes; without it the answer is E_NO_MEMORY, never a wrong one.
 */
#define _POSIX_C_SOURCE 200809L /* pthreads */
#include <pthread.h>
#include <errno.h>
#include <stdatomic.h>

#include "algsurf/algsurf.h"
#include "unit.h"

static atomic_long until_failure; /* allocations that still succeed; negative: all do */
static atomic_int failed;         /* was one refused? */
static atomic_long alive;

/* The names are the linker's. */
void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *p, size_t size);
void __real_free(void *p);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *p, size_t size);
void __wrap_free(void *p);

static int refuse(void) {
    long left = atomic_fetch_sub(&until_failure, 1);
    if (left == 0) atomic_store(&failed, 1);
    return left == 0;
}

static void *counted(void *p) {
    if (p) atomic_fetch_add(&alive, 1);
    return p;
}

void *__wrap_malloc(size_t size) { return refuse() ? NULL : counted(__real_malloc(size)); }
void *__wrap_calloc(size_t count, size_t size) {
    return refuse() ? NULL : counted(__real_calloc(count, size));
}
void *__wrap_realloc(void *p, size_t size) {
    if (refuse()) return NULL;
    return p ? __real_realloc(p, size) : counted(__real_realloc(p, size));
}
void __wrap_free(void *p) {
    if (p) atomic_fetch_sub(&alive, 1);
    __real_free(p);
}

/* What the system may refuse beside memory; -1: nothing. */
static int threads_allowed = -1, lock_refused, condition_refused;

int __real_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                          void *data);
int __real_pthread_mutex_init(pthread_mutex_t *mutex, const pthread_mutexattr_t *attributes);
int __real_pthread_cond_init(pthread_cond_t *condition, const pthread_condattr_t *attributes);
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                          void *data);
int __wrap_pthread_mutex_init(pthread_mutex_t *mutex, const pthread_mutexattr_t *attributes);
int __wrap_pthread_cond_init(pthread_cond_t *condition, const pthread_condattr_t *attributes);

int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                          void *data) {
    if (threads_allowed == 0) return EAGAIN;
    if (threads_allowed > 0) threads_allowed--;
    return __real_pthread_create(thread, attributes, run, data);
}
int __wrap_pthread_mutex_init(pthread_mutex_t *mutex, const pthread_mutexattr_t *attributes) {
    return lock_refused ? ENOMEM : __real_pthread_mutex_init(mutex, attributes);
}
int __wrap_pthread_cond_init(pthread_cond_t *condition, const pthread_condattr_t *attributes) {
    return condition_refused ? ENOMEM : __real_pthread_cond_init(condition, attributes);
}

static const char equation[] = "(x^2 + y^2 + z^2 + k)^2 - 2^-2 * 64 (x^2 + y^2)";
static const algsurf_constant constants[] = {{"k", 3.0}};

static algsurf_surface *make_surface(void) {
    algsurf_surface *s = NULL;
    assert_ok(algsurf_surface_from_equation(equation, constants, 1, &s, NULL));
    return s;
}

static void *const untouched = &alive; /* any address the library cannot return */

/* An attempt to make something: it is made, or its pointer is as it was. */
#define MAKES(name, type, release, call)                                                                     \
    static algsurf_status name(void) {                                                                       \
        type *s = untouched;                                                                                 \
        algsurf_status status = call;                                                                        \
        if (status == ALGSURF_OK)                                                                            \
            release(s);                                                                                      \
        else                                                                                                 \
            assert_ptr_equal(s, untouched);                                                                  \
        return status;                                                                                       \
    }

static const algsurf_term terms[] = {{2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 2, 1}, {1, 1, 1, 0.5}, {0, 0, 0, -1}};
MAKES(from_terms, algsurf_surface, algsurf_surface_free, algsurf_surface_from_terms(terms, 5, &s))
static const char defined[] = "w = k x + y; v = w^2; T_4(w) v ww = P_3(z)T_20(x+y+z)";
MAKES(from_definitions, algsurf_surface, algsurf_surface_free,
      algsurf_surface_from_equation(defined, constants, 1, &s, NULL))
MAKES(from_equation, algsurf_surface, algsurf_surface_free,
      algsurf_surface_from_equation(equation, constants, 1, &s, NULL))

/* Polynomials that keep their factors and summands. */
static const char factors[] = "((x+y+z+1)^5 + (x-y+z)^5/3 - x k)(2 (-(x+y-z+1)^5)^2 (y+z)) = k";
MAKES(from_factors, algsurf_surface, algsurf_surface_free,
      algsurf_surface_from_equation(factors, constants, 1, &s, NULL))

static const algsurf_surface *torus; /* made before counting starts */
MAKES(scene, algsurf_scene, algsurf_scene_free, algsurf_scene_create(torus, &s))
MAKES(root_solver, algsurf_complex_solver, algsurf_complex_solver_free,
      algsurf_complex_solver_create(ALGSURF_MAX_POLY_DEGREE, &s))

enum { WIDTH = 48, HEIGHT = 32 };
static algsurf_scene *stage;
static uint8_t reference[HEIGHT][WIDTH * 3];

static algsurf_status draw(uint8_t pixels[HEIGHT][WIDTH * 3]) {
    const algsurf_render_options options = {
        .size = sizeof options, .width = WIDTH, .height = HEIGHT, .threads = 2};
    const algsurf_picture planes = {.size = sizeof planes, .pixels = &pixels[0][0]};
    return algsurf_render(stage, &options, &planes, NULL);
}

static algsurf_status render(void) {
    uint8_t pixels[HEIGHT][WIDTH * 3], before[HEIGHT][WIDTH * 3];
    memset(before, 0xa5, sizeof before);
    memcpy(pixels, before, sizeof pixels);
    algsurf_status status = draw(pixels);
    assert_memory_equal(pixels, status == ALGSURF_OK ? reference : before, sizeof pixels);
    return status;
}

/* A picture of complex space: what it shows, and what it tells of it. */
typedef struct complex_picture {
    uint8_t pixels[HEIGHT][WIDTH * 3];
    double hits[HEIGHT * WIDTH];
    algsurf_render_stats stats;
} complex_picture;

static complex_picture complex_reference;

static algsurf_status draw_complex(complex_picture *p) {
    const algsurf_render_options options = {
        .size = sizeof options, .width = WIDTH, .height = HEIGHT, .threads = 2};
    memset(p, 0xa5, sizeof *p);
    p->stats.size = sizeof p->stats;
    const algsurf_picture planes = {.size = sizeof planes, .pixels = &p->pixels[0][0], .t = p->hits};
    return algsurf_render(stage, &options, &planes, &p->stats);
}

/* Does without nothing: there is a picture, or E_NO_MEMORY and every output as it was. */
static algsurf_status render_complex(void) {
    static complex_picture p, before;
    memset(&before, 0xa5, sizeof before);
    before.stats.size = sizeof before.stats;
    algsurf_status status = draw_complex(&p);
    assert_int_equal(status, atomic_load(&failed) ? ALGSURF_E_NO_MEMORY : ALGSURF_OK);
    if (status != ALGSURF_OK) {
        assert_memory_equal(&p, &before, sizeof p);
        return status;
    }
    assert_memory_equal(p.pixels, complex_reference.pixels, sizeof p.pixels);
    assert_memory_equal(p.hits, complex_reference.hits, sizeof p.hits);
    assert_true(p.stats.hits == complex_reference.stats.hits);
    return status;
}

/* Runs attempt with the first, second, ... allocation refused until none is; the number refused. */
static int refuse_each(algsurf_status (*attempt)(void)) {
    for (int n = 0; n < 100000; n++) {
        atomic_store(&failed, 0);
        atomic_store(&alive, 0);
        atomic_store(&until_failure, n);
        algsurf_status status = attempt();
        atomic_store(&until_failure, -1);
        assert_int_equal(atomic_load(&alive), 0);
        if (!atomic_load(&failed)) {
            assert_ok(status);
            return n;
        }
        if (status != ALGSURF_OK) assert_int_equal(status, ALGSURF_E_NO_MEMORY);
    }
    fail_msg("more allocations than anyone needs");
    return 0;
}

/* ---- rays that integers decide ---- */

/* What such a ray meets is known. */
typedef struct undecided_ray {
    const char *equation;
    algsurf_ray ray;
    algsurf_extent extent;
    int allocates; /* or the stack is enough */
    int count;     /* of roots */
    double root[3];
} undecided_ray;

#define BALL ALGSURF_EXTENT_SPHERE
#define BOX ALGSURF_EXTENT_BOX
#define ABOVE_1 0x1.0000000000001p0
#define BELOW_1 0x1.fffffffffffffp-1

static const undecided_ray undecided_rays[] = {
    /* grazing: just in, just out */
    {"x + x^3", {{-4, 0, 1}, {1, 0, 0}, 0, 9}, {BALL, {0, 0, 0}, {ABOVE_1}}, 0, 1, {4}},
    {"x + x^3", {{-4, 0, 1}, {1, 0, 0}, 0, 9}, {BALL, {0, 0, 0}, {BELOW_1}}, 0, 0, {0}},
    {"(x + 1)(x - 1/2)", {{-4, 0, 0}, {1, 0, 0}, 0, 9}, {BOX, {0, 0, 0}, {BELOW_1, 1, 1}}, 0, 1, {4.5}},
    /* two roots a hair apart, and none */
    {"((x - 1)^2 - y^2)(x - 3)", {{0, 0x1p-90, 0}, {1, 0, 0}, 0, 9}, {BALL, {0, 0, 0}, {2}}, 0, 2, {1, 1}},
    {"(x - 1)^2 + y^2", {{0, 0x1p-90, 0}, {1, 0, 0}, 0, 9}, {BALL, {0, 0, 0}, {2}}, 0, 0, {0}},
    /* roots of very different sizes */
    {"(x - 1)(x - 2)(1 - 1e-200 x)",
     {{0, 0, 0}, {1, 0, 0}, 0, HUGE_VAL},
     {ALGSURF_EXTENT_ALL, {0, 0, 0}, {0}},
     0,
     3,
     {1, 2, 1e200}},
    /* common factors of high degree */
    {"(x^14 + y^14 + z^14 - 1)^2 (x + 99)",
     {{-4, 0.3, 0.1}, {1, 0, 0}, 0, 4},
     {BALL, {0, 0, 0}, {2}},
     1,
     1,
     {3}},
    {"((4x^2 - 1)^2 + z^2)^6 (x - 1)^5",
     {{-0.1, 0.3, 0x1p-200}, {1, 0, 0}, 0, 9},
     {BALL, {0, 0, 0}, {2}},
     1,
     1,
     {1.1}},
};

static const undecided_ray *asked;
static algsurf_surface *asked_surface;

/* OK, or E_NO_MEMORY after a refusal: then nothing has been written. */
static int is_done(algsurf_status status, const void *written, const void *before, size_t size) {
    if (status == ALGSURF_OK) return 1;
    assert_int_equal(status, ALGSURF_E_NO_MEMORY);
    assert_true(atomic_load(&failed));
    if (before) assert_memory_equal(written, before, size);
    return 0;
}

static void judge_hit(const algsurf_hit *hit, int i) {
    assert_int_equal(hit->state, ALGSURF_STATE_HIT);
    assert_true(hit->t_lo <= hit->t && hit->t <= hit->t_hi);
    assert_true(fabs(hit->t - asked->root[i]) <= 1e-6 * asked->root[i]);
}

/* A packet of three: the ray between two that need no memory, and are answered in any case. */
static void ask_packets(void) {
    const algsurf_ray *r = &asked->ray;
    double o[3][3], d[3][3], t_min[3], t_max[3];
    unsigned char state[3] = {9, 9, 9}, occluded[3] = {9, 9, 9};
    algsurf_ray_packet rays = {.size = sizeof rays, .count = 3, .t_min = t_min, .t_max = t_max};
    const algsurf_hit_packet to = {.size = sizeof to, .state = state};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) o[k][i] = i == 1 ? r->origin[k] : 9, d[k][i] = r->direction[k];
        t_min[i] = i == 1 ? r->t_min : 1, t_max[i] = i == 1 ? r->t_max : 2;
    }
    for (int k = 0; k < 3; k++) rays.origin[k] = o[k], rays.direction[k] = d[k];
    int wanted = asked->count ? ALGSURF_STATE_HIT : ALGSURF_STATE_MISS;
    algsurf_status status = algsurf_intersect_packet(asked_surface, &asked->extent, &rays, NULL, &to);
    assert_int_equal(state[1], is_done(status, NULL, NULL, 0) ? wanted : ALGSURF_STATE_UNDECIDED);
    status = algsurf_occluded_packet(asked_surface, &asked->extent, &rays, NULL, occluded);
    assert_int_equal(occluded[1], is_done(status, NULL, NULL, 0) ? wanted : ALGSURF_STATE_UNDECIDED);
    if (asked->extent.kind == ALGSURF_EXTENT_ALL) return;
    for (int i = 0; i < 3; i += 2)
        assert_true(state[i] == ALGSURF_STATE_MISS && occluded[i] == ALGSURF_STATE_MISS);
}

static algsurf_status undecided_intersect(void) {
    algsurf_hit all[32], before[32];
    int occluded = 77;
    int count = 77, untouched_count = 77;
    const algsurf_extent *extent = &asked->extent;
    memset(before, 0xa5, sizeof before), memcpy(all, before, sizeof all);
    algsurf_status status = algsurf_intersect_first(asked_surface, extent, &asked->ray, NULL, all);
    if (is_done(status, all, before, sizeof all)) {
        if (asked->count) judge_hit(all, 0);
        if (!asked->count) assert_int_equal(all[0].state, ALGSURF_STATE_MISS);
    }
    memcpy(all, before, sizeof all);
    status = algsurf_intersect_all(asked_surface, extent, &asked->ray, NULL, all, 32, &count);
    if (is_done(status, all, before, sizeof all)) {
        assert_int_equal(count, asked->count);
        for (int i = 0; i < count; i++) judge_hit(all + i, i);
    } else {
        assert_int_equal(count, untouched_count);
    }
    status = algsurf_occluded(asked_surface, extent, &asked->ray, NULL, &occluded);
    assert_int_equal((int)occluded, !is_done(status, NULL, NULL, 0) ? 77
                                    : asked->count                  ? ALGSURF_STATE_HIT
                                                                    : ALGSURF_STATE_MISS);
    ask_packets();
    return ALGSURF_OK;
}

TEST(test_undecided_rays) {
    for (size_t i = 0; i < sizeof undecided_rays / sizeof *undecided_rays; i++) {
        asked = undecided_rays + i;
        assert_ok(algsurf_surface_from_equation(asked->equation, NULL, 0, &asked_surface, NULL));
        int refused = refuse_each(undecided_intersect);
        if ((refused > 0) != asked->allocates) fail_msg("%s: %d allocations", asked->equation, refused);
        algsurf_surface_free(asked_surface);
    }
}

/* A picture with rays that integers decide: it is drawn, or E_NO_MEMORY. */
enum { SMALL_WIDTH = 8, SMALL_HEIGHT = 4, HALF = SMALL_HEIGHT / 2 };

typedef struct small_picture {
    double hits[SMALL_HEIGHT * SMALL_WIDTH];
    uint8_t pixels[SMALL_HEIGHT][SMALL_WIDTH * 3];
    algsurf_render_stats stats;
} small_picture;

static small_picture small_reference;

static int stop_at(int done, int total, void *row) {
    (void)total;
    return done == *(int *)row;
}

/* With one thread; cancelled after that many rows. */
static algsurf_status draw_rows(small_picture *p, int rows) {
    const algsurf_render_options options = {.size = sizeof options,
                                            .width = SMALL_WIDTH,
                                            .height = SMALL_HEIGHT,
                                            .threads = 1,
                                            .progress = stop_at,
                                            .progress_data = &rows};
    memset(p, 0xa5, sizeof *p);
    p->stats.size = sizeof p->stats;
    const algsurf_picture planes = {.size = sizeof planes, .pixels = &p->pixels[0][0], .t = p->hits};
    return algsurf_render(stage, &options, &planes, &p->stats);
}

static algsurf_status draw_small(small_picture *p) { return draw_rows(p, -1); }

static algsurf_status render_small(void) {
    static small_picture p;
    algsurf_status status = draw_small(&p);
    if (!is_done(status, NULL, NULL, 0)) return status;
    assert_memory_equal(p.hits, small_reference.hits, sizeof p.hits);
    assert_memory_equal(p.pixels, small_reference.pixels, sizeof p.pixels);
    assert_int_equal(p.stats.undecided, 0);
    return status;
}

TEST(test_certified_picture) {
    algsurf_surface *s = NULL;
    const algsurf_extent extent = {BALL, {0, 0, 0}, {1.5}};
    assert_ok(algsurf_surface_from_equation("(x^10 + y^10 + z^10 - 1)^2 (x + 99)", NULL, 0, &s, NULL));
    assert_ok(algsurf_scene_create(s, &stage));
    assert_ok(algsurf_scene_set_extent(stage, &extent));
    assert_ok(draw_small(&small_reference));
    assert_true(small_reference.stats.hits > SMALL_WIDTH * SMALL_HEIGHT / 9);
    int refused = refuse_each(render_small);
    assert_true(refused > 0);
    /* rays that are not decided for want of memory do not keep the others from being drawn */
    const algsurf_intersect_options poor = {.size = sizeof poor, .max_memory = 1};
    static small_picture p;
    assert_ok(algsurf_scene_set_intersect_options(stage, &poor));
    assert_int_equal(draw_small(&p), ALGSURF_E_NO_MEMORY);
    assert_true(p.stats.rays == small_reference.stats.rays && p.stats.undecided > 0 &&
                p.pixels[0][0] != 0xa5);
    /* cancelled meanwhile: that is told, and the rows before are those of the whole picture */
    static small_picture half;
    uint8_t blank[SMALL_HEIGHT - HALF][SMALL_WIDTH * 3];
    memset(blank, 0xa5, sizeof blank);
    assert_int_equal(draw_rows(&half, HALF), ALGSURF_CANCELLED);
    assert_true(half.stats.undecided > 0 && half.stats.undecided < p.stats.undecided);
    assert_memory_equal(half.pixels, p.pixels, HALF * sizeof *p.pixels);
    assert_memory_equal(half.pixels[HALF], blank, sizeof blank);
    algsurf_scene_free(stage);
    algsurf_surface_free(s);
}

TEST(test_surface) {
    assert_true(refuse_each(from_terms) > 0);
    assert_true(refuse_each(from_equation) > 0);
    assert_true(refuse_each(from_definitions) > 0);
    assert_true(refuse_each(from_factors) > 0);
}

TEST(test_root_solver) { assert_true(refuse_each(root_solver) > 0); }

/* x^40 - x^39 + 2^-1000 x^38 underflows at the lower end. */
static algsurf_status refine(void) {
    const double c[41] = {[38] = 0x1p-1000, [39] = -1, [40] = 1};
    algsurf_refined_root root = {.root = 7};
    algsurf_status status = algsurf_refine_poly(c, NULL, 40, 0x1p-990, 2, NULL, &root);
    if (status == ALGSURF_OK)
        assert_true(root.lo == 1 - 0x1p-53 && root.hi == 1);
    else
        assert_true(root.root == 7);
    return status;
}

/* x^40 + x - 1 whose constant is known to 2^-1000. */
static algsurf_status refine_with_radii(void) {
    const double c[41] = {[0] = -1, [1] = 1, [40] = 1}, r[41] = {[0] = 0x1p-1000};
    algsurf_refined_root root = {.root = 7};
    algsurf_status status = algsurf_refine_poly(c, r, 40, 0x1p-990, 2, NULL, &root);
    if (status == ALGSURF_OK)
        assert_true(root.lo < root.hi && root.hi - root.lo < 0x1p-50);
    else
        assert_true(root.root == 7);
    return status;
}

TEST(test_refine) {
    assert_true(refuse_each(refine) > 0);
    assert_true(refuse_each(refine_with_radii) > 0);
}

/* Two roots so close that integers alone part them; watched, too. */
static algsurf_status isolate(const algsurf_isolate_options *options) {
    static const double c[21] = {[0] = -2, [1] = 0x1p115 * 2800, [2] = -0x1p230 * 980000, [20] = 1};
    algsurf_bracket b = {.lo = 7};
    int found = 77;
    algsurf_status status = algsurf_isolate_first(c, NULL, 20, 0, 1, options, &b, &found);
    if (status == ALGSURF_OK)
        assert_true(found == 1 && b.lo > 0 && b.hi < 0x1p-40);
    else
        assert_true(found == 77 && b.lo == 7);
    return status;
}

static algsurf_status isolate_alone(void) { return isolate(NULL); }

static algsurf_status isolate_watched(void) {
    algsurf_observer observer = {.size = sizeof observer};
    const algsurf_isolate_options watched = {.size = sizeof watched, .observer = &observer};
    return isolate(&watched);
}

TEST(test_isolate) {
    int alone = refuse_each(isolate_alone);
    assert_true(alone > 0 && refuse_each(isolate_watched) >= alone);
}

TEST(test_scene_and_render) {
    algsurf_surface *s = make_surface();
    torus = s;
    assert_true(refuse_each(scene) > 0);
    assert_ok(algsurf_scene_create(s, &stage));
    assert_ok(algsurf_scene_set_quality(stage, ALGSURF_QUALITY_FULL));
    assert_ok(draw(reference));
    assert_true(refuse_each(render) > 0);
    algsurf_scene_free(stage);
    algsurf_surface_free(s);
}

/* A root in complex space at the end of the extent: integers tell that it is in there. */
static algsurf_status intersect_complex(void) {
    const algsurf_complex_space space = {.size = sizeof space, .sector = {0, 1e-10}};
    const algsurf_ray ray = {{-3, 0, 0}, {1, 0, 0}, 0, 9};
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    algsurf_hit hit;
    algsurf_complex root;
    const algsurf_status status =
        algsurf_intersect_complex(torus, &ball, &ray, &space, NULL, NULL, &hit, &root);
    if (status == ALGSURF_OK) {
        assert_true(hit.state == ALGSURF_STATE_HIT && fabs(hit.t - 2) < 1e-12);
    } else {
        assert_true(status == ALGSURF_E_NO_MEMORY && hit.state == ALGSURF_STATE_UNDECIDED);
    }
    return status;
}

TEST(test_complex_ray) {
    algsurf_surface *s = NULL;
    assert_ok(algsurf_surface_from_equation("x^48 + y^48 + z^48 = 1", NULL, 0, &s, NULL));
    torus = s;
    assert_true(refuse_each(intersect_complex) > 0);
    algsurf_surface_free(s);
}

TEST(test_complex_space) {
    const double imaginary = 0.5;
    const algsurf_complex_space space = {
        .size = sizeof space, .sector = {0.01, 0.2}, .imaginary = &imaginary, .imaginary_count = 1};
    algsurf_surface *s = make_surface();
    assert_ok(algsurf_scene_create(s, &stage));
    assert_ok(algsurf_scene_set_complex_space(stage, &space));
    assert_ok(draw_complex(&complex_reference));
    assert_in_range(complex_reference.stats.hits, WIDTH * HEIGHT / 10, WIDTH * HEIGHT * 9 / 10);
    for (int c = ALGSURF_COHERENCE_NONE; c <= ALGSURF_COHERENCE_NEIGHBOURS; c++) {
        assert_ok(algsurf_scene_set_coherence(stage, (algsurf_coherence)c));
        assert_true(refuse_each(render_complex) > 0);
    }
    algsurf_scene_free(stage);
    algsurf_surface_free(s);
}

/* 0 to 3 of the helpers that are asked for; without the locks, nothing at all. */
TEST(test_threads) {
    algsurf_surface *s = make_surface();
    uint8_t pixels[HEIGHT][WIDTH * 3], before[HEIGHT][WIDTH * 3];
    algsurf_render_stats stats = {.size = sizeof stats};
    const algsurf_picture planes = {.size = sizeof planes, .pixels = &pixels[0][0]};
    const algsurf_render_options options = {
        .size = sizeof options, .width = WIDTH, .height = HEIGHT, .threads = 4};
    assert_ok(algsurf_scene_create(s, &stage));
    assert_ok(draw(reference));
    for (int allowed = 0; allowed <= 3; allowed++) {
        memset(pixels, 0xa5, sizeof pixels);
        threads_allowed = allowed;
        algsurf_status status = algsurf_render(stage, &options, &planes, &stats);
        threads_allowed = -1;
        assert_ok(status);
        assert_int_equal(stats.threads, allowed + 1);
        assert_memory_equal(pixels, reference, sizeof pixels);
    }
    memset(pixels, 0xa5, sizeof pixels);
    memcpy(before, pixels, sizeof pixels);
    for (int which = 0; which < 2; which++) {
        *(which ? &condition_refused : &lock_refused) = 1;
        atomic_store(&alive, 0);
        algsurf_status status = draw(pixels);
        lock_refused = condition_refused = 0;
        assert_int_equal(status, ALGSURF_E_THREAD);
        assert_int_equal(atomic_load(&alive), 0);
        assert_memory_equal(pixels, before, sizeof pixels);
    }
    algsurf_scene_free(stage);
    algsurf_surface_free(s);
}

int main(void) {
    atomic_store(&until_failure, -1);
    return unit_run("memory");
}
