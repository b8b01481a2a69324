/* test_host_environment.c - a host's floating-point environment, on one thread or on many at once: surfaces,
 * cameras, scenes, pictures, rays and roots made in it are those of the usual one, bit for bit, and the
 * host's control bits and exception flags come back as they were.
 *
 * What test_intersect_options, test_intersect_packet, test_batch, test_expand, test_isolate_radii and
 * test_allroots say of single calls is not repeated.  Breaks tried, each caught by the tests:
 *   the environment, or the flags alone, left to the host in algsurf_render, algsurf_scene_create (flags),
 *   algsurf_camera_pinhole, algsurf_surface_from_equation, algsurf_intersect_complex, algsurf_select
 */
#define _POSIX_C_SOURCE 200809L /* pthreads */
#include <pthread.h>

#include "algsurf/algsurf.h"
#include "environments.h"
#include "unit.h"

enum { W = 24, H = 18, SCENES = 3, RAYS = 9, HOSTS = 2 * ENVIRONMENTS + 1, DEGREE = 5 };

/* Everything the environment decides: control bits, and the flags that have been raised. */
typedef struct host {
    unsigned long long control, flags;
} host;

static host host_now(void) {
#if defined(__SSE2__)
    return (host){(_mm_getcsr() & ~0x3full) | (unsigned long long)environment_x87() << 32,
                  (_mm_getcsr() & 0x3fu) | (unsigned)fetestexcept(FE_ALL_EXCEPT)};
#elif defined(__aarch64__)
    host h;
    __asm__ volatile("mrs %0, fpcr" : "=r"(h.control));
    __asm__ volatile("mrs %0, fpsr" : "=r"(h.flags));
    return h;
#elif defined(__arm__) && defined(__ARM_FP)
    unsigned fpscr;
    __asm__ volatile("vmrs %0, fpscr" : "=r"(fpscr));
    return (host){fpscr & 0x07ff9f00u, fpscr & 0x9fu};
#else
    return (host){(unsigned long long)fegetround(), (unsigned long long)fetestexcept(FE_ALL_EXCEPT)};
#endif
}

/* Host h: an environment without flags, or with all of them raised; the last one traps (x86). */
static host host_enter(int h) {
    environment_set(h % ENVIRONMENTS);
    if (h >= ENVIRONMENTS && h < 2 * ENVIRONMENTS) {
        (void)feraiseexcept(FE_ALL_EXCEPT);
#if defined(__SSE2__)
        _mm_setcsr(_mm_getcsr() | 0x3fu);
    } else if (h == 2 * ENVIRONMENTS) {
        _mm_setcsr(_mm_getcsr() & ~0x680u); /* invalid operation, division by zero, overflow */
#if ENVIRONMENT_X87
        unsigned short word = (unsigned short)(environment_x87() & ~0xdu); /* the same */
        __asm__ volatile("fldcw %0" ::"m"(word));
#endif
#endif
    }
    return host_now();
}

/* Back to the usual environment; 1 if the host's was still there. */
static int host_leave(host entered) {
    host now = host_now();
#if defined(__SSE2__)
    _mm_setcsr(0x1f80u);
#if ENVIRONMENT_X87
    const unsigned short word = 0x37f; /* no traps, which threads would inherit */
    __asm__ volatile("fldcw %0" ::"m"(word));
#endif
#endif
    environment_set(0);
    return now.control == entered.control && now.flags == entered.flags;
}

typedef struct answers {
    int failed; /* the first call that was not OK, counted from 1 */
    uint8_t pixels[SCENES][2][3 * W * H];
    double t[SCENES][2][W * H];
    algsurf_camera camera[SCENES];
    algsurf_hit first, complex;
    unsigned char state[RAYS];
    double packet_t[RAYS], packet_lo[RAYS], packet_hi[RAYS];
    algsurf_complex_root roots[DEGREE];
    int root_count;
    algsurf_status sector_status[2];
    int holds[2], index[2];
    int selected[2];
} answers;

typedef struct shot {
    const char *equation;
    double size, eye[3]; /* radius of the extent, and where it is seen from */
    algsurf_quality quality;
    double imaginary; /* of p_0; 0: real space */
} shot;

/* The tiny one is drawn where squares of lengths are subnormal. */
static const shot shots[SCENES] = {
    {"(x^2+y^2+z^2+3.51)^2 - 16(x^2+y^2)", 3.2, {7, 4, 5}, ALGSURF_QUALITY_FULL, 0},
    {"x^2 + y^2 + z^2 = 1.7e-313", 5e-157, {1e-156, 6e-157, 9e-157}, ALGSURF_QUALITY_STANDARD, 0},
    {"x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8", 3.7, {8, 5, 6}, ALGSURF_QUALITY_STANDARD, 2},
};

/* Made beforehand: nothing but the library computes in a host's environment. */
static double origin[3][RAYS], direction[3][RAYS];

static void make_rays(void) {
    for (int i = 0; i < RAYS; i++) {
        origin[0][i] = -4, origin[1][i] = 0.31 * i - 1.2, origin[2][i] = i == 3 ? 0x1p-1060 : 0.1;
        direction[0][i] = 1, direction[1][i] = 0.01 * i, direction[2][i] = i == 5 ? 0x1p-1070 : -0.03;
    }
}

static void ok(answers *a, int step, algsurf_status status) {
    if (status != ALGSURF_OK && a->failed == 0) a->failed = step;
}

static void draw(answers *a, int i) {
    const shot *s = shots + i;
    const double centre[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {s->size, 0, 0}};
    const algsurf_complex_space space = {sizeof space, {0, 0.05}, &s->imaginary, 1};
    algsurf_surface *surface = NULL;
    algsurf_scene *scene = NULL;
    ok(a, 1, algsurf_surface_from_equation(s->equation, NULL, 0, &surface, NULL));
    ok(a, 2, algsurf_camera_pinhole(s->eye, centre, up, 36, a->camera + i));
    ok(a, 3, algsurf_scene_create(surface, &scene));
    ok(a, 4, algsurf_scene_set_extent(scene, &extent));
    ok(a, 5, algsurf_scene_set_camera(scene, a->camera + i));
    ok(a, 6, algsurf_scene_set_quality(scene, s->quality));
    ok(a, 7, algsurf_scene_set_antialias(scene, 2));
    ok(a, 8, algsurf_scene_set_complex_space(scene, s->imaginary != 0 ? &space : NULL));
    for (int k = 0; k < 2; k++) {
        algsurf_render_options o = {.size = sizeof o, .width = W, .height = H, .threads = k ? 3 : 1};
        const algsurf_picture planes = {.size = sizeof planes, .pixels = a->pixels[i][k], .t = a->t[i][k]};
        ok(a, 9, algsurf_render(scene, &o, &planes, NULL));
    }
    algsurf_scene_free(scene);
    algsurf_surface_free(surface);
}

/* Rays in real space, one of them in complex space too; all roots of a polynomial. */
static void solve(answers *a) {
    const algsurf_ray ray = {{origin[0][3], origin[1][3], origin[2][3]},
                             {direction[0][3], direction[1][3], direction[2][3]},
                             0x1p-1060,
                             100};
    const algsurf_ray_packet rays = {.size = sizeof rays,
                                     .count = RAYS,
                                     .origin = {origin[0], origin[1], origin[2]},
                                     .direction = {direction[0], direction[1], direction[2]}};
    const algsurf_hit_packet hits = {
        .size = sizeof hits, .state = a->state, .t = a->packet_t, .t_lo = a->packet_lo, .t_hi = a->packet_hi};
    const double imaginary[2] = {1, 0x1p-1060};
    const algsurf_complex_space space = {sizeof space, {0, 0.3}, imaginary, 2};
    const double c[DEGREE + 1] = {-0.1, 0.7, 0.3, 0x1p-1060, -2.9, 1};
    algsurf_surface *surface = NULL;
    ok(a, 11, algsurf_surface_from_equation(shots[0].equation, NULL, 0, &surface, NULL));
    ok(a, 12, algsurf_intersect_first(surface, NULL, &ray, NULL, &a->first));
    ok(a, 13, algsurf_intersect_packet(surface, NULL, &rays, NULL, &hits));
    ok(a, 14, algsurf_intersect_complex(surface, NULL, &ray, &space, NULL, NULL, &a->complex, NULL));
    ok(a, 15, algsurf_complex_roots_of_real(c, NULL, DEGREE, a->roots, &a->root_count));
    algsurf_surface_free(surface);
}

/* A sector whose end, rounded upward, would be beyond pi; one that begins a little above the positive axis.
 */
static void choose(answers *a) {
    const algsurf_sector sectors[2] = {{1e-20, 0x1.921fb54442d19p+1}, {1e-310, 0.3}};
    const algsurf_complex_root roots[2] = {{{{1, 1}, {0, 0}}, {1, 0}, 1, 1},
                                           {{{2, 2}, {1e-310, 1}}, {2, 0}, 1, 0}};
    for (int i = 0; i < 2; i++) {
        a->sector_status[i] = algsurf_sector_holds(sectors + i, roots, a->holds + i);
        ok(a, 16, algsurf_select(roots, 2, sectors + i, 0, 10, a->selected + i, a->index + i));
    }
}

static void answer(answers *a) {
    memset(a, 0, sizeof *a);
    for (int i = 0; i < SCENES; i++) draw(a, i);
    solve(a);
    choose(a);
}

/* In the usual environment; pictures that show something, and the same for both numbers of threads. */
static answers *usual(void) {
    answers *a = malloc(sizeof *a);
    assert_non_null(a);
    answer(a);
    assert_int_equal(a->failed, 0);
    for (int i = 0; i < SCENES; i++) {
        int hits = 0;
        for (int k = 0; k < W * H; k++) hits += a->t[i][0][k] < INFINITY;
        assert_in_range(hits, W * H / 8, W * H - 1);
        assert_memory_equal(a->pixels[i][0], a->pixels[i][1], sizeof a->pixels[i][0]);
    }
    assert_int_equal(a->first.state, ALGSURF_STATE_HIT);
    assert_int_equal(a->root_count, DEGREE);
    return a;
}

static void assert_same(const answers *a, const answers *b) {
    assert_int_equal(b->failed, 0);
    assert_memory_equal(a->camera, b->camera, sizeof a->camera);
    assert_memory_equal(a->t, b->t, sizeof a->t);
    assert_memory_equal(a->pixels, b->pixels, sizeof a->pixels);
    assert_memory_equal(a->state, b->state, sizeof a->state);
    assert_memory_equal(a->roots, b->roots, sizeof a->roots);
    assert_memory_equal(&a->complex, &b->complex, sizeof a->complex);
    assert_memory_equal(a, b, sizeof *a);
}

TEST(one_after_the_other) {
    answers *plain = usual(), *other = malloc(sizeof *other);
    assert_non_null(other);
    for (int h = 0; h < HOSTS; h++) {
        host entered = host_enter(h);
        answer(other);
        int kept = host_leave(entered);
        if (!kept || memcmp(plain, other, sizeof *plain) != 0) print_error("host %d:\n", h);
        assert_true(kept);
        assert_same(plain, other);
    }
    free(plain), free(other);
}

typedef struct guest {
    pthread_t thread;
    int host, kept;
    answers answers;
} guest;

static void *visit(void *data) {
    guest *g = data;
    host entered = host_enter(g->host);
    answer(&g->answers);
    g->kept = host_leave(entered);
    return NULL;
}

TEST(all_at_once) {
    answers *plain = usual();
    guest *guests = calloc(HOSTS, sizeof *guests);
    assert_non_null(guests);
    for (int h = 0; h < HOSTS; h++) {
        guests[h].host = h;
        assert_int_equal(pthread_create(&guests[h].thread, NULL, visit, guests + h), 0);
    }
    for (int h = 0; h < HOSTS; h++) assert_int_equal(pthread_join(guests[h].thread, NULL), 0);
    for (int h = 0; h < HOSTS; h++) {
        if (!guests[h].kept) print_error("host %d:\n", h);
        assert_true(guests[h].kept);
        assert_same(plain, &guests[h].answers);
    }
    free(plain), free(guests);
}

int main(void) {
    make_rays();
    return unit_run("host environment");
}
