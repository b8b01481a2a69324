/* test_endless_scenes.c - pictures of scenes without an extent: each pixel shows what the single ray through
 * it hits, wherever that is, and few rays have to be solved by themselves.
 *
 * Breaks caught, each tried: the proof of what is before the view's depths left out, or of what is behind
 * them; empty tiles without it; pixels that begin where a tile's cells end of which nothing is proved; tiles
 * cut by planes; and, with a view of 0.02 to 0.7 times the surface's size, sheets without a proof of what is
 * before.
 */
#include "render_case.h"

#define SEED 41u

static const char *const equations[] = {
    "x^2+y^2+z^2-1",
    "x^2 z + y^2",
    "z^3+x z+y",
    "(x^2+y^2+z^2+5.44)^2 - 25(x^2+y^2)",
    "x^2 y^2+x^2 z^2+y^2 z^2+x y z",
    "(x^2+9y^2/4+z^2-1)^3 - x^2 z^3 - 9 y^2 z^3/80",
    "4(2.6x^2-y^2)(2.6y^2-z^2)(2.6z^2-x^2)-4.2(x^2+y^2+z^2-1)^2",
    "(x^2+y^2+z^2-1)((x-40)^2+(y+10)^2+(z-5)^2-400)",
    "(x^2+y^2-z^2-1)(z-90)(z+70)",
    "x + 2 y - 3 z - 1/3",
    "x^14+y^14+z^14-1",
    "(x^8+y^8+z^8-1)(x-3000)",
};

enum { EQUATIONS = sizeof equations / sizeof *equations };

static void fail_pixel(const char *what, int e, const algsurf_camera *camera, int x, int y, double t,
                       const algsurf_hit *hit) {
    exact_print_doubles("eye", camera->eye, 3), exact_print_doubles("forward", camera->forward, 3);
    exact_print_doubles("right", camera->right, 3), exact_print_doubles("up", camera->up, 3);
    exact_print_doubles("half height", &camera->half_height, 1);
    fail_msg("seed %u: %s, %s: pixel %d,%d t %a, by itself state %d t %a", SEED, what, equations[e], x, y, t,
             hit->state, hit->t);
}

/* What the ray by itself hits. */
static void judge(const algsurf_surface *surface, int e, const algsurf_camera *camera,
                  const algsurf_intersect_options *options, const picture *p) {
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const double t = p->hits[y * W + x];
            algsurf_ray ray = pixel_ray(camera, W, H, x + 0.5, y + 0.5);
            algsurf_hit hit = first_hit_of(surface, NULL, &ray, options);
            if (p->states[y * W + x] != hit.state) fail_pixel("another state", e, camera, x, y, t, &hit);
            if (hit.state != ALGSURF_STATE_HIT) continue;
            double slant = fabs(hit.normal[0] * ray.direction[0] + hit.normal[1] * ray.direction[1] +
                                hit.normal[2] * ray.direction[2]);
            double room = fmin(1e-8 / slant, 1e-5);
            if (!(fabs(t - hit.t) <= room * (1 + fabs(hit.t))))
                fail_pixel("another t", e, camera, x, y, t, &hit);
        }
}

/* Near, far, inside and looking past; some parallel, some along an axis. */
static algsurf_camera random_camera(uint64_t *seed, int number) {
    static const double away[] = {6, 2.5, 40, 0.4, 1e4, 15};
    double eye[3], at[3], forward[3], far = away[number % 6], length = 0;
    algsurf_camera camera;
    for (int i = 0; i < 3; i++) forward[i] = random_unit(seed), length += forward[i] * forward[i];
    if (number % 5 == 4) forward[0] = forward[1] = 0, forward[2] = length = 1;
    for (int i = 0; i < 3; i++) {
        at[i] = (number % 4 == 3 ? 4 : 0.5) * random_unit(seed);
        eye[i] = at[i] - far * forward[i] / sqrt(length);
    }
    const double up[3] = {0.1, 1, 0.2};
    if (number % 5 > 2)
        camera = parallel_of(eye, at, up, number % 2 ? 1.5 : 6);
    else
        camera = pinhole_of(eye, at, up, far > 1e3 ? 0.02 : number % 2 ? 60 : 25);
    return camera;
}

TEST(pixels_show_what_their_rays_hit) {
    uint64_t seed = SEED;
    for (int e = 0; e < EQUATIONS; e++) {
        algsurf_surface *surface = surface_of(equations[e]);
        for (int number = 0; number < 24; number++) {
            const algsurf_camera camera = random_camera(&seed, number);
            const algsurf_plane plane = {{random_unit(&seed), random_unit(&seed), 1}, 0.3};
            algsurf_intersect_options options = {.size = sizeof options};
            algsurf_scene *scene = scene_of(surface, NULL, &camera, NULL);
            if (number % 3 == 2) {
                assert_ok(algsurf_scene_set_clip(scene, &plane, 1));
                options.planes = &plane, options.plane_count = 1;
            }
            picture *p = drawn(scene, 1);
            judge(surface, e, &camera, &options, p);
        }
    }
}

/* A sheet far in front of what is near the origin, or far behind it, hides it or shows beside it. */
TEST(what_is_far_is_seen) {
    static const double places[] = {50, 300, -3000, 1e5}, away[] = {20, 1000, 9000};
    for (int i = 0; i < 24; i++) {
        const int n = i % 6 < 3 ? 8 : 10;
        char text[64];
        (void)snprintf(text, sizeof text, "(x^%d+y^%d+z^%d-1)(x-%g)", n, n, n, places[i / 6]);
        algsurf_surface *surface = surface_of(text);
        const double far = away[i % 3], fov = i % 4 ? 20 : 120;
        const algsurf_camera camera = camera_at(far, far / 20, far / 30, fov / far);
        const algsurf_intersect_options options = {.size = sizeof options};
        algsurf_scene *scene = scene_of(surface, NULL, &camera, NULL);
        picture *p = drawn(scene, 1);
        judge(surface, EQUATIONS - 1, &camera, &options, p);
    }
}

/* By slices, threads and kernels; antialiased, at edges only. */
TEST(the_same_bytes_by_all_ways) {
    for (int e = 0; e < EQUATIONS; e += 3) {
        algsurf_surface *surface = surface_of(equations[e]);
        const algsurf_camera camera = camera_at(5, 4, 3, 40);
        algsurf_intersect_options how = {.size = sizeof how};
        algsurf_scene *scene = scene_of(surface, NULL, &camera, NULL);
        assert_ok(algsurf_scene_set_antialias(scene, 3));
        assert_ok(algsurf_scene_set_antialias_threshold(scene, 0.05));
        picture *all = drawn(scene, 1), *threads = drawn(scene, 3);
        assert_same_picture(all, threads);
        blank(threads);
        for (int row = 0; row < H; row += 5) {
            algsurf_render_options o = options_for(1);
            o.row_begin = row, o.row_end = row + 5 < H ? row + 5 : H;
            render(scene, &o, threads);
        }
        for (int row = 0; row < H; row++) assert_same_row(all, threads, row);
        for (int k = 0; (how.kernel = algsurf_kernel_name(k)); k++) {
            assert_ok(algsurf_scene_set_intersect_options(scene, &how));
            picture *other = drawn(scene, 1);
            assert_same_picture(all, other);
        }
    }
}

/* Rays by themselves, of all: none where what there is is near. */
TEST(few_rays_go_by_themselves) {
    static const int share[EQUATIONS] = {[0] = 30, [1] = 8, [3] = 30, [4] = 8, [5] = 30, [6] = 8};
    for (int e = 0; e < EQUATIONS; e++) {
        if (share[e] == 0) continue;
        algsurf_surface *surface = surface_of(equations[e]);
        const algsurf_camera camera = camera_at(5, 4, 3, 40);
        algsurf_scene *scene = scene_of(surface, NULL, &camera, NULL);
        picture *p = drawn(scene, 1);
        if (p->stats.single_rays * (uint64_t)share[e] > W * H)
            fail_msg("%s: %d rays by themselves", equations[e], (int)p->stats.single_rays);
    }
}
