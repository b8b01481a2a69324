/* test_sizes.c - structs that begin with their own size, when that size was never set.
 *
 * Each call that takes one gets sizes that are too small, one byte above the largest, and what memory may
 * hold by chance: it refuses them, and reads nothing behind what it knows.  Each struct lies before a page
 * that nobody may read, so that a size believed stops the program.
 *
 * Break tried, caught: no largest size. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include <sys/mman.h>
#include <unistd.h>

#include "algsurf/algsurf.h"
#include "unit.h"

static unsigned char *end; /* of readable memory */
static algsurf_surface *surface;
static algsurf_scene *scene;
static algsurf_complex_solver *solver;
static const algsurf_ray ray = {{-2, 0, 0}, {1, 0, 0}, 0, INFINITY};
static const double c[] = {-1, 0, 1};
static const algsurf_complex z[] = {{-1, 0}, {0, 0}, {1, 0}};

/* A call with the struct at p. */
typedef algsurf_status sized_call(void *p);

static algsurf_status first(void *p) {
    algsurf_hit hit;
    return algsurf_intersect_first(surface, NULL, &ray, p, &hit);
}
static algsurf_status all(void *p) {
    algsurf_hit hits[2];
    int count;
    return algsurf_intersect_all(surface, NULL, &ray, p, hits, 2, &count);
}
static algsurf_status occluded(void *p) {
    int answer;
    return algsurf_occluded(surface, NULL, &ray, p, &answer);
}
static algsurf_status rays(void *p) {
    unsigned char state[1];
    const algsurf_hit_packet hits = {.size = sizeof hits, .state = state};
    return algsurf_intersect_packet(surface, NULL, p, NULL, &hits);
}
static algsurf_status hits(void *p) {
    const double one = 1, zero = 0;
    const algsurf_ray_packet packet = {
        .size = sizeof packet, .count = 1, .origin = {&zero, &zero, &zero}, .direction = {&one, &one, &one}};
    return algsurf_intersect_packet(surface, NULL, &packet, NULL, p);
}
static algsurf_status space(void *p) {
    algsurf_hit hit;
    return algsurf_intersect_complex(surface, NULL, &ray, p, NULL, NULL, &hit, NULL);
}
static algsurf_status isolated(void *p) {
    algsurf_bracket b[2];
    int count;
    return algsurf_isolate_all(c, NULL, 2, -2, 2, p, b, 2, &count);
}
static algsurf_status observed(void *p) {
    const algsurf_isolate_options options = {.size = sizeof options, .observer = p};
    return isolated((void *)&options);
}
static algsurf_status refined(void *p) {
    algsurf_refined_root root;
    return algsurf_refine_poly(c, NULL, 2, 0, 2, p, &root);
}
static algsurf_status real_batch(void *p) {
    unsigned char state[1];
    double root[1];
    return algsurf_first_roots_batch(p, NULL, state, root);
}
static algsurf_status batch_options(void *p) {
    const double lo = 0, hi = 2;
    unsigned char state[1];
    double root[1];
    const algsurf_real_batch batch = {
        .size = sizeof batch, .count = 1, .degree = 2, .coefficients = {c, 1, 3}, .lo = &lo, .hi = &hi};
    return algsurf_first_roots_batch(&batch, p, state, root);
}
static algsurf_status complex_batch(void *p) {
    algsurf_complex_root roots[2];
    int count[1];
    return algsurf_complex_roots_batch(p, NULL, roots, count);
}
static algsurf_status zeros(void *p) {
    algsurf_paper_zero zero[2];
    int count;
    return algsurf_paper_zeros(z, NULL, 2, NULL, p, zero, &count);
}
static algsurf_status solver_stats(void *p) {
    algsurf_complex_root roots[2];
    int count;
    return algsurf_complex_solver_run(solver, z, NULL, 2, NULL, roots, &count, p);
}
static algsurf_status material(void *p) { return algsurf_scene_set_material(scene, p); }
static algsurf_status intersect(void *p) { return algsurf_scene_set_intersect_options(scene, p); }
static algsurf_status complex_space(void *p) { return algsurf_scene_set_complex_space(scene, p); }
static algsurf_status scene_lighting(void *p) {
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    return algsurf_scene_get_lighting(scene, lights, p);
}
static algsurf_status shade_lighting(void *p) {
    const double x[3] = {1, 0, 0};
    double colour[3];
    return algsurf_shade_preview(p, x, x, x, colour);
}
static const algsurf_render_options small = {.size = sizeof small, .width = 2, .height = 2};
static unsigned char pixels[12];
static algsurf_status render_options(void *p) {
    const algsurf_picture picture = {.size = sizeof picture, .pixels = pixels};
    return algsurf_render(scene, p, &picture, NULL);
}
static algsurf_status picture(void *p) { return algsurf_render(scene, &small, p, NULL); }
static algsurf_status render_stats(void *p) {
    const algsurf_picture planes = {.size = sizeof planes, .pixels = pixels};
    return algsurf_render(scene, &small, &planes, p);
}

static const struct {
    const char *name;
    sized_call *call;
    size_t size;
} calls[] = {
    {"intersect_first", first, sizeof(algsurf_intersect_options)},
    {"intersect_all", all, sizeof(algsurf_intersect_options)},
    {"occluded", occluded, sizeof(algsurf_intersect_options)},
    {"ray packet", rays, sizeof(algsurf_ray_packet)},
    {"hit packet", hits, sizeof(algsurf_hit_packet)},
    {"complex space", space, sizeof(algsurf_complex_space)},
    {"isolate options", isolated, sizeof(algsurf_isolate_options)},
    {"observer", observed, sizeof(algsurf_observer)},
    {"refine options", refined, sizeof(algsurf_refine_options)},
    {"real batch", real_batch, sizeof(algsurf_real_batch)},
    {"batch options", batch_options, sizeof(algsurf_batch_options)},
    {"complex batch", complex_batch, sizeof(algsurf_complex_batch)},
    {"zero options", zeros, sizeof(algsurf_paper_options)},
    {"solver stats", solver_stats, sizeof(algsurf_complex_solver_stats)},
    {"material", material, sizeof(algsurf_material)},
    {"scene's intersect options", intersect, sizeof(algsurf_intersect_options)},
    {"scene's complex space", complex_space, sizeof(algsurf_complex_space)},
    {"lighting of a scene", scene_lighting, sizeof(algsurf_lighting)},
    {"lighting", shade_lighting, sizeof(algsurf_lighting)},
    {"render options", render_options, sizeof(algsurf_render_options)},
    {"picture", picture, sizeof(algsurf_picture)},
    {"render stats", render_stats, sizeof(algsurf_render_stats)},
};

TEST(sizes_never_set) {
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        const size_t sizes[] = {0,        1,          calls[i].size - 1, 4097, 0x55d0c0de, 0x7fffd5a03f10,
                                1u << 31, (size_t)-1, (size_t)-8};
        for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
            unsigned char *p = end - calls[i].size;
            memset(p, 0, calls[i].size);
            memcpy(p, &sizes[k], sizeof sizes[k]);
            algsurf_status status = calls[i].call(p);
            if (status != ALGSURF_E_SIZE)
                fail_msg("%s, size %zx: %s", calls[i].name, sizes[k], algsurf_status_name(status));
        }
    }
}

/* A newer struct, whose unknown part asks for nothing, is accepted up to the largest size. */
TEST(larger_structs) {
    static unsigned char room[4096];
    const size_t size = sizeof room;
    memset(room, 0, sizeof room);
    memcpy(room, &size, sizeof size);
    assert_ok(first(room));
    assert_ok(refined(room));
    assert_ok(render_stats(room));
    room[4095] = 1;
    memcpy(room, &size, sizeof size);
    assert_int_equal(first(room), ALGSURF_E_SIZE);
}

/* Of a newer struct that receives results only the size is read: what is unknown here becomes 0. */
TEST(larger_results) {
    static unsigned char room[4096];
    sized_call *const results[] = {render_stats, scene_lighting, solver_stats};
    const size_t size = sizeof room;
    for (size_t i = 0; i < sizeof results / sizeof *results; i++) {
        memset(room, 0x5a, sizeof room);
        memcpy(room, &size, sizeof size);
        assert_ok(results[i](room));
        assert_memory_equal(room, &size, sizeof size);
        for (size_t k = 512; k < sizeof room; k++) assert_int_equal(room[k], 0);
    }
}

int main(void) {
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    unsigned char *memory = mmap(NULL, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED || mprotect(memory + page, page, PROT_NONE) != 0) return 1;
    end = memory + page;
    if (algsurf_surface_from_equation("x^2+y^2+z^2=1", NULL, 0, &surface, NULL) != ALGSURF_OK ||
        algsurf_scene_create(surface, &scene) != ALGSURF_OK ||
        algsurf_complex_solver_create(2, &solver) != ALGSURF_OK)
        return 1;
    int failed = unit_run("sizes");
    algsurf_complex_solver_free(solver);
    algsurf_scene_free(scene);
    algsurf_surface_free(surface);
    return failed;
}
