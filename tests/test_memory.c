/* test_memory.c - the n-th allocation fails, for every n; and the n-th thread, and the locks.
 *
 * The linker sends the library's malloc, calloc, realloc and free through the functions below
 * (-Wl,--wrap), which count what is alive and make one chosen allocation fail.  Each call must then
 * either return ALGSURF_E_NO_MEMORY with its outputs untouched, or do without and answer as ever;
 * nothing may stay allocated.  Threads and locks are refused in the same way: a picture is drawn by the
 * threads there are, or ALGSURF_E_THREAD returned.  Catches: an unchecked allocation, a leak on a failure
 * path, an output written before the work was done.  (Seen to fail with a check removed and with a free
 * removed.)  Exact arithmetic, which the certified tier does without, leaves rays uncertain then, never
 * wrong.  (Seen to fail with such a ray left out, told as a hit, and with one of its parts left out.)
 */
#define _POSIX_C_SOURCE 200809L /* pthreads */
#include <pthread.h>
#include <errno.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "algsurf/algsurf.h"
#include "rays/exact.h"

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
    assert_int_equal(algsurf_surface_from_equation(equation, constants, 1, &s, NULL), ALGSURF_OK);
    return s;
}

static void *const untouched = &alive; /* any address the library cannot return */

static algsurf_status from_terms(void) {
    const algsurf_term terms[] = {{2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 2, 1}, {1, 1, 1, 0.5}, {0, 0, 0, -1}};
    algsurf_surface *s = untouched;
    algsurf_status status = algsurf_surface_from_terms(terms, sizeof terms / sizeof *terms, &s);
    if (status == ALGSURF_OK)
        algsurf_surface_free(s);
    else
        assert_ptr_equal(s, untouched);
    return status;
}

static algsurf_status from_equation(void) {
    algsurf_surface *s = untouched;
    algsurf_status status = algsurf_surface_from_equation(equation, constants, 1, &s, NULL);
    if (status == ALGSURF_OK)
        algsurf_surface_free(s);
    else
        assert_ptr_equal(s, untouched);
    return status;
}

static const algsurf_surface *torus; /* made before counting starts */

static algsurf_status scene(void) {
    algsurf_scene *s = untouched;
    algsurf_status status = algsurf_scene_create(torus, &s);
    if (status == ALGSURF_OK)
        algsurf_scene_free(s);
    else
        assert_ptr_equal(s, untouched);
    return status;
}

static algsurf_status root_solver(void) {
    algsurf_root_solver *s = untouched;
    algsurf_status status = algsurf_root_solver_create(ALGSURF_MAX_POLY_DEGREE, &s);
    if (status == ALGSURF_OK)
        algsurf_root_solver_free(s);
    else
        assert_ptr_equal(s, untouched);
    return status;
}

enum { WIDTH = 48, HEIGHT = 32 };
static algsurf_scene *stage;
static uint8_t reference[HEIGHT][WIDTH * 3];

static algsurf_status draw(uint8_t pixels[HEIGHT][WIDTH * 3]) {
    const algsurf_render_options options = {
        .size = sizeof options, .width = WIDTH, .height = HEIGHT, .threads = 2};
    return algsurf_render(stage, &options, &pixels[0][0], sizeof pixels[0], NULL, NULL);
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
    return algsurf_render(stage, &options, &p->pixels[0][0], sizeof p->pixels[0], p->hits, &p->stats);
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
            assert_int_equal(status, ALGSURF_OK);
            return n;
        }
        if (status != ALGSURF_OK) assert_int_equal(status, ALGSURF_E_NO_MEMORY);
    }
    fail_msg("more allocations than anyone needs");
    return 0;
}

/* ---- exact arithmetic without memory ---- */

/* Rays of which double-double cannot say what they meet; what they do meet is known. */
typedef struct doubtful_ray {
    const char *equation;
    algsurf_ray ray;
    algsurf_extent extent;
    int count; /* of roots, all of them hits */
    double root[3];
} doubtful_ray;

#define BALL ALGSURF_EXTENT_SPHERE
#define BOX ALGSURF_EXTENT_BOX
#define ABOVE_1 0x1.0000000000001p0
#define BELOW_1 0x1.fffffffffffffp-1

static const doubtful_ray doubtful_rays[] = {
    {"x + x^3",
     {{-4, 0, 1}, {1, 0, 0}, 0, 9},
     {BALL, {0, 0, 0}, {ABOVE_1}},
     1,
     {4}}, /* grazing: just in, just out */
    {"x + x^3", {{-4, 0, 1}, {1, 0, 0}, 0, 9}, {BALL, {0, 0, 0}, {BELOW_1}}, 0, {0}},
    {"x + x^3", {{-4, 0, ABOVE_1}, {1, 0, 0}, 0, 9}, {BOX, {0, 0, 0}, {9, 9, 1}}, 0, {0}},
    {"x^2 + y^2 - 1", {{-4, 0, 0}, {1, 0, 0}, 0, 9}, {BALL, {0, 0, 0}, {ABOVE_1}}, 2, {3, 5}},
    {"x^2 + y^2 - 1", {{-4, 0, 0}, {1, 0, 0}, 0, 9}, {BALL, {0, 0, 0}, {BELOW_1}}, 0, {0}},
    {"(x + 1)(x - 3)", {{-4, 0, 0}, {1, 0, 0}, 0, 9}, {BOX, {0, 0, 0}, {BELOW_1, 1, 1}}, 0, {0}},
    {"(x + 1)(x - 1/2)", {{-4, 0, 0}, {1, 0, 0}, 0, 9}, {BOX, {0, 0, 0}, {BELOW_1, 1, 1}}, 1, {4.5}},
    /* two roots a hair apart, not at an edge; and roots of which exact arithmetic makes parts */
    {"((x - 1)^2 - y^2)(x - 3)", {{0, 0x1p-90, 0}, {1, 0, 0}, 0, 9}, {BALL, {0, 0, 0}, {2}}, 2, {1, 1}},
    {"(x - 1)^2 + y^2", {{0, 0x1p-90, 0}, {1, 0, 0}, 0, 9}, {BALL, {0, 0, 0}, {2}}, 0, {0}},
    {"(x - 1)(x - 2)(1 - 1e-200 x)",
     {{0, 0, 0}, {1, 0, 0}, 0, HUGE_VAL},
     {0, {0, 0, 0}, {0}},
     3,
     {1, 2, 1e200}},
};

static const doubtful_ray *asked;
static algsurf_surface *asked_surface;
static algsurf_doubt asked_doubt;
static int uncertain_answers;

/* A state told of a ray with a root or without one: right, or uncertain for want of memory. */
static void judge_state(int state, algsurf_status reason) {
    int wanted = asked->count > 0 ? ALGSURF_HIT : ALGSURF_MISS;
    int doubt = state == ALGSURF_UNCERTAIN || reason > 0;
    uncertain_answers += doubt;
    if (doubt || (asked_doubt == ALGSURF_DOUBT_MISS && state == ALGSURF_MISS)) {
        assert_true(state == wanted || atomic_load(&failed));
        assert_true(asked_doubt == ALGSURF_DOUBT_REPORT || state != ALGSURF_UNCERTAIN);
    } else {
        assert_int_equal(state, wanted);
    }
}

static int any_root_between(double lo, double hi) {
    int any = 0;
    for (int k = 0; k < asked->count; k++) any |= lo <= asked->root[k] && asked->root[k] <= hi;
    return any;
}

/* Every root is in an entry, and every sure entry has one. */
static void judge_entries(const algsurf_hit *hits, int count) {
    int covered = 0, sure = 0;
    for (int k = 0; k < asked->count; k++) {
        int in = 0;
        for (int i = 0; i < count; i++)
            in |= hits[i].t_lo <= asked->root[k] && asked->root[k] <= hits[i].t_hi;
        covered += in;
    }
    for (int i = 0; i < count; i++) {
        sure += hits[i].reason == ALGSURF_OK;
        assert_true(hits[i].reason != ALGSURF_OK || any_root_between(hits[i].t_lo, hits[i].t_hi));
    }
    assert_true(sure <= asked->count);
    if (!atomic_load(&failed)) assert_int_equal(sure, asked->count);
    if (asked_doubt != ALGSURF_DOUBT_MISS || !atomic_load(&failed)) assert_int_equal(covered, asked->count);
}

static algsurf_status doubtful_intersect(void) {
    const algsurf_intersect_options how = {
        .size = sizeof how, .tier = ALGSURF_TIER_CERTIFIED, .doubt = asked_doubt};
    const algsurf_ray *ray = &asked->ray;
    const algsurf_ray_packet one = {.size = sizeof one,
                                    .count = 1,
                                    .origin = {ray->origin, ray->origin + 1, ray->origin + 2},
                                    .direction = {ray->direction, ray->direction + 1, ray->direction + 2},
                                    .t_min = &ray->t_min,
                                    .t_max = &ray->t_max};
    algsurf_hit hit, all[8];
    algsurf_hit_state occluded;
    unsigned char state;
    double t_lo, t_hi;
    const algsurf_hit_packet to = {.size = sizeof to, .state = &state, .t_lo = &t_lo, .t_hi = &t_hi};
    const algsurf_extent *extent = &asked->extent;
    int count;
    assert_int_equal(algsurf_intersect_first(asked_surface, extent, ray, &how, &hit), ALGSURF_OK);
    judge_state(hit.state, hit.reason);
    if (hit.state == ALGSURF_HIT && hit.reason == ALGSURF_OK) /* MISS passes over the first, if in doubt */
        assert_true(asked_doubt == ALGSURF_DOUBT_MISS
                        ? any_root_between(hit.t_lo, hit.t_hi)
                        : hit.t_lo <= asked->root[0] && asked->root[0] <= hit.t_hi);
    assert_int_equal(algsurf_intersect_all(asked_surface, extent, ray, &how, all, 8, &count), ALGSURF_OK);
    judge_entries(all, count);
    assert_int_equal(algsurf_occluded(asked_surface, extent, ray, &how, &occluded), ALGSURF_OK);
    if (asked_doubt != ALGSURF_DOUBT_HIT) judge_state((int)occluded, ALGSURF_OK);
    assert_int_equal(algsurf_intersect_packet(asked_surface, extent, &one, &how, &to), ALGSURF_OK);
    if (asked_doubt != ALGSURF_DOUBT_HIT) judge_state(state, ALGSURF_OK);
    if (asked_doubt == ALGSURF_DOUBT_REPORT && state == ALGSURF_HIT)
        assert_true(t_lo <= asked->root[0] && asked->root[0] <= t_hi);
    assert_int_equal(algsurf_occluded_packet(asked_surface, extent, &one, &how, &state), ALGSURF_OK);
    if (asked_doubt != ALGSURF_DOUBT_HIT) judge_state(state, ALGSURF_OK);
    return ALGSURF_OK;
}

/* No answer needs memory, and none is wrong without it. */
static void test_doubtful_rays(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof doubtful_rays / sizeof *doubtful_rays; i++) {
        asked = doubtful_rays + i;
        assert_int_equal(algsurf_surface_from_equation(asked->equation, NULL, 0, &asked_surface, NULL),
                         ALGSURF_OK);
        for (int doubt = ALGSURF_DOUBT_REPORT; doubt <= ALGSURF_DOUBT_MISS; doubt++) {
            asked_doubt = (algsurf_doubt)doubt;
            uncertain_answers = 0;
            assert_true(refuse_each(doubtful_intersect) > 1);
            assert_true(uncertain_answers > 0 || doubt == ALGSURF_DOUBT_MISS);
        }
        algsurf_surface_free(asked_surface);
    }
}

/* A root beside two that need an interval of their own: one allocation for all, and one for each of three
 * parts, none of which may be missing. */
static algsurf_status roots_in_parts(void) {
    const algsurf_ray ray = {{-1.5, 0x1p-52, 0x1p-100}, {1, 0, 0}, 1.25, 1.75};
    algsurf_i_exact_root roots[5];
    int n = algsurf_i_exact_roots(asked_surface, &ray, NULL, 1.25, 1.75, ALGSURF_WANT_ALL, roots);
    assert_int_equal(n, atomic_load(&failed) ? -1 : 4);
    return ALGSURF_OK;
}

static void test_roots_in_parts(void **state) {
    (void)state;
    assert_int_equal(
        algsurf_surface_from_equation("(x + 9y)(x - z)(x - 2z)(x - 9y)", NULL, 0, &asked_surface, NULL),
        ALGSURF_OK);
    assert_int_equal(refuse_each(roots_in_parts), 4);
    algsurf_surface_free(asked_surface);
}

/* A picture of a ball in an extent larger by a rounding error: every hit is at an edge. */
typedef struct ball_picture {
    double hits[(HEIGHT / 3) * (WIDTH / 3)];
    uint8_t pixels[HEIGHT / 3][WIDTH / 3 * 3];
    algsurf_render_stats stats;
} ball_picture;

static ball_picture ball_reference;

static algsurf_status draw_ball(ball_picture *p) {
    const algsurf_render_options options = {
        .size = sizeof options, .width = WIDTH / 3, .height = HEIGHT / 3, .threads = 1};
    memset(p, 0xa5, sizeof *p);
    p->stats.size = sizeof p->stats;
    return algsurf_render(stage, &options, &p->pixels[0][0], sizeof p->pixels[0], p->hits, &p->stats);
}

static algsurf_status render_ball(void) {
    static ball_picture p, before;
    uint64_t others = 0;
    memset(&before, 0xa5, sizeof before);
    before.stats.size = sizeof before.stats;
    algsurf_status status = draw_ball(&p);
    if (status != ALGSURF_OK) {
        assert_memory_equal(&p, &before, sizeof p);
        return status;
    }
    for (size_t i = 0; i < sizeof p.hits / sizeof *p.hits; i++)
        others += memcmp(p.hits + i, ball_reference.hits + i, sizeof *p.hits) != 0;
    assert_true(others <= p.stats.uncertain - ball_reference.stats.uncertain);
    assert_true(p.stats.uncertain <= ball_reference.stats.uncertain + (uint64_t)atomic_load(&failed));
    return status;
}

static void test_certified_picture(void **state) {
    algsurf_surface *s = NULL;
    const algsurf_intersect_options how = {.size = sizeof how, .tier = ALGSURF_TIER_CERTIFIED};
    const algsurf_extent extent = {BALL, {0, 0, 0}, {ABOVE_1}};
    (void)state;
    assert_int_equal(algsurf_surface_from_equation("x^2 + y^2 + z^2 - 1", NULL, 0, &s, NULL), ALGSURF_OK);
    assert_int_equal(algsurf_scene_create(s, &stage), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_intersect(stage, &how), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_extent(stage, &extent), ALGSURF_OK);
    assert_int_equal(draw_ball(&ball_reference), ALGSURF_OK);
    assert_true(ball_reference.stats.hits > WIDTH * HEIGHT / 90);
    int refused = refuse_each(render_ball);
    assert_true((uint64_t)refused > ball_reference.stats.hits); /* exact arithmetic at each of them */
    algsurf_scene_free(stage);
    algsurf_surface_free(s);
}

static void test_surface(void **state) {
    (void)state;
    assert_true(refuse_each(from_terms) > 0);
    assert_true(refuse_each(from_equation) > 0);
}

static void test_root_solver(void **state) {
    (void)state;
    assert_true(refuse_each(root_solver) > 0);
}

static void test_scene_and_render(void **state) {
    (void)state;
    algsurf_surface *s = make_surface();
    torus = s;
    assert_true(refuse_each(scene) > 0);
    assert_int_equal(algsurf_scene_create(s, &stage), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_quality(stage, ALGSURF_QUALITY_FULL), ALGSURF_OK);
    assert_int_equal(draw(reference), ALGSURF_OK);
    assert_true(refuse_each(render) > 0);
    algsurf_scene_free(stage);
    algsurf_surface_free(s);
}

static void test_complex_space(void **state) {
    algsurf_complex_space space = {.size = sizeof space, .sector = {0.01, 0.2}, .imaginary = {[0] = 0.5}};
    algsurf_surface *s = make_surface();
    (void)state;
    assert_int_equal(algsurf_scene_create(s, &stage), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_complex_space(stage, &space), ALGSURF_OK);
    assert_int_equal(draw_complex(&complex_reference), ALGSURF_OK);
    assert_in_range(complex_reference.stats.hits, WIDTH * HEIGHT / 10, WIDTH * HEIGHT * 9 / 10);
    for (int c = ALGSURF_COHERENCE_NONE; c <= ALGSURF_COHERENCE_NEIGHBOURS; c++) {
        assert_int_equal(algsurf_scene_set_coherence(stage, (algsurf_coherence)c), ALGSURF_OK);
        assert_true(refuse_each(render_complex) > 0);
    }
    algsurf_scene_free(stage);
    algsurf_surface_free(s);
}

/* 0 to 3 of the helpers that are asked for; without the locks, nothing at all. */
static void test_threads(void **state) {
    algsurf_surface *s = make_surface();
    uint8_t pixels[HEIGHT][WIDTH * 3], before[HEIGHT][WIDTH * 3];
    algsurf_render_stats stats = {.size = sizeof stats};
    const algsurf_render_options options = {
        .size = sizeof options, .width = WIDTH, .height = HEIGHT, .threads = 4};
    (void)state;
    assert_int_equal(algsurf_scene_create(s, &stage), ALGSURF_OK);
    assert_int_equal(draw(reference), ALGSURF_OK);
    for (int allowed = 0; allowed <= 3; allowed++) {
        memset(pixels, 0xa5, sizeof pixels);
        threads_allowed = allowed;
        algsurf_status status =
            algsurf_render(stage, &options, &pixels[0][0], sizeof pixels[0], NULL, &stats);
        threads_allowed = -1;
        assert_int_equal(status, ALGSURF_OK);
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
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_surface),          cmocka_unit_test(test_root_solver),
        cmocka_unit_test(test_scene_and_render), cmocka_unit_test(test_threads),
        cmocka_unit_test(test_complex_space),    cmocka_unit_test(test_doubtful_rays),
        cmocka_unit_test(test_roots_in_parts),   cmocka_unit_test(test_certified_picture)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
