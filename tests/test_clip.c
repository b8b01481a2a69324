/* test_clip.c - planes that cut what is shown: of rays against rational arithmetic, six of them against a
 * box, of pictures against rays.
 *
 * Rays, planes and surfaces have small numbers, so that roots lie on planes, rays along and in planes, and in
 * the surface, often; or planes are an ulp away from there, or of any size.
 *
 * Breaks caught, each tried: a point on a plane not kept; the sign of a plane's face turned; a ray along a
 * plane always kept, or kept at infinity; what is surely kept, or surely not, without the error of its end;
 * planes left out of shadows' fans, of tiles, of rows, of single rays of complex space.
 */
#include "intersect_case.h"

#include "scenes.h"

#define SEED 20261129u

enum { ROUNDS = 3000, RAYS = PACKET_MOST, WIDTH = 96, HEIGHT = 72 };

static const char *const equations[] = {
    "x = 1",
    "x^2 + y^2 + z^2 = 4",
    "x^2 + y^2 = z^2",
    "(x - 1/2) (y + z) (x + y - 1) = 0",
    "(x + y)^2 = 0",
    "x y z = 0",
    "(x^2 + y^2 + z^2 - 1) (x - y) = 0",
    "x^4 + y^4 + z^4 - 5 (x^2 + y^2 + z^2) + 11.8 = 0",
};

enum { EQUATIONS = sizeof equations / sizeof *equations };

static const char tangle[] = "x^4 + y^4 + z^4 - 5 (x^2 + y^2 + z^2) + 11.8 = 0";

/* ---- single rays ---- */

static void set_direction(double v[3], uint64_t *seed) {
    do {
        for (int i = 0; i < 3; i++) v[i] = random_int(seed, 2) ? random_halves(seed, 2) : 0;
    } while (v[0] == 0 && v[1] == 0 && v[2] == 0);
}

static void set_ray(algsurf_ray *ray, uint64_t *seed) {
    for (int i = 0; i < 3; i++) ray->origin[i] = random_halves(seed, 3);
    set_direction(ray->direction, seed);
    if (random_int(seed, 4) == 0) /* any numbers */
        for (int i = 0; i < 3; i++) ray->direction[i] += random_unit(seed);
    ray->t_min = random_int(seed, 3) ? 0 : -INFINITY;
    ray->t_max = random_int(seed, 3) ? INFINITY : 4 + random_halves(seed, 3);
}

static void set_planes(algsurf_plane *planes, size_t count, uint64_t *seed) {
    for (size_t k = 0; k < count; k++) {
        int scale = random_int(seed, 8) ? 0 : random_int(seed, 600) - 300;
        double offset = random_halves(seed, 3);
        set_direction(planes[k].normal, seed);
        if (random_int(seed, 4) == 0) offset = nextafter(offset, 100 * random_unit(seed));
        planes[k].offset = ldexp(offset, scale);
        for (int i = 0; i < 3; i++) planes[k].normal[i] = ldexp(planes[k].normal[i], scale);
    }
}

/* Through a hit of the uncut surface, or an ulp beside it, as far as doubles can tell. */
static void move_to_hit(algsurf_plane *plane, const algsurf_hit *hit, uint64_t *seed) {
    const double *n = plane->normal, *x = hit->position;
    if (!isfinite(n[0] * x[0] + n[1] * x[1] + n[2] * x[2])) return;
    plane->offset = n[0] * x[0] + n[1] * x[1] + n[2] * x[2];
    if (random_int(seed, 3) == 0) plane->offset = nextafter(plane->offset, random_unit(seed));
}

/* A ball, a box, or null. */
static const algsurf_extent *some_extent(algsurf_extent *extent, uint64_t *seed) {
    int kind = random_int(seed, 3);
    if (kind == ALGSURF_EXTENT_ALL) return NULL;
    extent->kind = kind;
    for (int i = 0; i < 3; i++) {
        extent->centre[i] = random_halves(seed, 1);
        extent->size[i] = 2 + fabs(random_halves(seed, 2));
    }
    return extent;
}

/* Is a hit exactly on one of the planes? */
static int lies_on_plane(const algsurf_hit *hit, const algsurf_intersect_options *o) {
    for (size_t k = 0; k < o->plane_count; k++) {
        const double *n = o->planes[k].normal, *x = hit->position;
        if (n[0] * x[0] + n[1] * x[1] + n[2] * x[2] == o->planes[k].offset) return 1;
    }
    return 0;
}

TEST(hits_are_those_kept) {
    uint64_t seed = SEED;
    int cut = 0, kept = 0, on_plane = 0, in_surface = 0;
    static intersect_case cases[EQUATIONS];
    for (int i = 0; i < EQUATIONS; i++) intersect_equation(&cases[i], equations[i]);
    for (int round = 0; round < ROUNDS; round++) {
        intersect_case *c = &cases[random_int(&seed, EQUATIONS)];
        algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
        algsurf_extent extent;
        int most = random_int(&seed, 4) ? 2 : ALGSURF_MAX_CLIP_PLANES;
        const algsurf_intersect_options whole = {.size = sizeof whole};
        algsurf_intersect_options o = {.size = sizeof o, .planes = planes};
        intersect_answer a, uncut;
        o.plane_count = 1 + (size_t)random_int(&seed, most);
        set_ray(&c->ray, &seed);
        set_planes(planes, o.plane_count, &seed);
        const algsurf_extent *in = some_extent(&extent, &seed);
        intersect_ask(c, in, &whole, &uncut);
        if (uncut.count > 0 && random_int(&seed, 2))
            move_to_hit(&planes[0], &uncut.all[random_int(&seed, uncut.count)], &seed);
        const char *wrong = intersect_verdict(c, in, &o, &a);
        for (size_t k = 0; wrong && k < o.plane_count; k++) {
            exact_print_doubles("normal", planes[k].normal, 3);
            exact_print_doubles("offset", &planes[k].offset, 1);
        }
        if (wrong) {
            fprintf(stderr, "seed %u, round %d, extent of kind %d\n", SEED, round, in ? in->kind : 0);
            intersect_fail(wrong, c, &a);
        }
        cut += a.count<uncut.count, kept += a.count> 0;
        for (int i = 0; i < a.count; i++) {
            on_plane += lies_on_plane(&a.all[i], &o);
            in_surface += a.all[i].multiplicity == 0;
        }
    }
    printf("%d rounds: %d cut, %d with hits, %d hits on planes, %d in the surface\n", ROUNDS, cut, kept,
           on_plane, in_surface);
    assert_true(cut > ROUNDS / 5 && kept > ROUNDS / 8 && on_plane > ROUNDS / 20 && in_surface > ROUNDS / 200);
}

/* ---- packets ---- */

/* Rays from anywhere to about the middle. */
static void set_rays(packet_case *p, uint64_t *seed) {
    for (int i = 0; i < RAYS; i++) {
        algsurf_ray ray = {.t_max = INFINITY};
        for (int k = 0; k < 3; k++) {
            ray.origin[k] = 6 * random_unit(seed);
            ray.direction[k] = 2 * random_unit(seed) - ray.origin[k];
        }
        packet_put(p, i, &ray);
    }
}

TEST(six_planes_are_a_box) {
    static const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0.25, 0, -0.125}, {1.5, 2, 1.75}};
    static packet_case planes_say, box_says, first;
    algsurf_plane planes[6];
    algsurf_surface *surface = surface_of(tangle);
    uint64_t seed = SEED;
    int hits = 0;
    for (int k = 0; k < 6; k++) {
        int side = k % 2 ? 1 : -1;
        planes[k] = (algsurf_plane){{0}, side * box.centre[k / 2] + box.size[k / 2]};
        planes[k].normal[k / 2] = side;
    }
    for (int round = 0; round < 5; round++) {
        set_rays(&box_says, &seed);
        planes_say = box_says;
        for (int k = 0; algsurf_kernel_name(k); k++) {
            algsurf_intersect_options o = {.size = sizeof o, .kernel = algsurf_kernel_name(k)};
            assert_ok(packet_ask(&box_says, 0, RAYS, surface, &box, &o));
            o.planes = planes, o.plane_count = 6;
            assert_ok(packet_ask(&planes_say, 0, RAYS, surface, NULL, &o));
            if (k == 0) first = planes_say;
            assert_memory_equal(&first, &planes_say, sizeof first);
        }
        assert_memory_equal(box_says.state, planes_say.state, sizeof box_says.state);
        assert_memory_equal(box_says.occluded, planes_say.occluded, sizeof box_says.occluded);
        assert_memory_equal(box_says.multiplicity, planes_say.multiplicity, sizeof box_says.multiplicity);
        for (int i = 0; i < RAYS; i++) {
            hits += box_says.state[i] == ALGSURF_STATE_HIT;
            if (box_says.state[i] == ALGSURF_STATE_HIT && !(fabs(box_says.t[i] - planes_say.t[i]) < 1e-13))
                fail_msg("ray %d: t = %a, not %a", i, planes_say.t[i], box_says.t[i]);
        }
    }
    assert_true(hits > RAYS && hits < 4 * RAYS);
}

/* ---- pictures ---- */

typedef struct picture {
    uint8_t bytes[3 * WIDTH * HEIGHT];
    unsigned char states[WIDTH * HEIGHT];
    double t[WIDTH * HEIGHT];
} picture;

static void draw(const algsurf_scene *scene, picture *p) {
    const algsurf_picture planes = {
        .size = sizeof planes, .pixels = p->bytes, .format = ALGSURF_RGB8, .state = p->states, .t = p->t};
    const algsurf_render_options o = {.size = sizeof o, .width = WIDTH, .height = HEIGHT, .threads = 1};
    assert_ok(algsurf_render(scene, &o, &planes, NULL));
}

/* By Brent's method every ray goes by itself, and no fan is asked: what is cut away casts no shadow. */
TEST(shadows_as_by_rays) {
    static const algsurf_intersect_options by_rays = {.size = sizeof by_rays, .method = ALGSURF_METHOD_BRENT};
    static const algsurf_extent extents[] = {{ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3, 0, 0}},
                                             {ALGSURF_EXTENT_BOX, {0, 0, 0}, {2.5, 2, 2.25}}};
    static const algsurf_plane planes[] = {{{0.3, -1, 0.2}, 0.1}, {{0, 0, 1}, 0.75}, {{-1, 0, 0}, 3.5}};
    static picture fans, rays, whole;
    algsurf_surface *surface = surface_of(tangle);
    for (int i = 0; i < 2; i++) {
        algsurf_scene *scene = scene_of(surface, &extents[i], NULL, NULL);
        assert_ok(algsurf_scene_set_quality(scene, ALGSURF_QUALITY_FULL));
        draw(scene, &whole);
        assert_ok(algsurf_scene_set_clip(scene, planes, 3));
        draw(scene, &fans);
        assert_ok(algsurf_scene_set_intersect_options(scene, &by_rays));
        draw(scene, &rays);
        assert_memory_equal(fans.states, rays.states, sizeof fans.states);
        int differ = 0, brighter = 0; /* t is rounded otherwise: a few bytes may differ by one */
        for (int k = 0; k < 3 * WIDTH * HEIGHT; k++) {
            differ += abs(fans.bytes[k] - rays.bytes[k]) > 1;
            brighter += whole.states[k / 3] == ALGSURF_STATE_HIT && whole.t[k / 3] == fans.t[k / 3] &&
                        fans.bytes[k] > whole.bytes[k] + 8;
        }
        assert_int_equal(differ, 0);
        assert_true(brighter > 100);
    }
}

/* The part of a pixel's ray before or behind a plane. */
static algsurf_ray cut_ray(const algsurf_camera *camera, const algsurf_plane *plane, int pixel) {
    algsurf_ray ray = pixel_ray(camera, WIDTH, HEIGHT, pixel % WIDTH + 0.5, pixel / WIDTH + 0.5);
    double above = -plane->offset, rise = 0;
    for (int i = 0; i < 3; i++) {
        above += plane->normal[i] * ray.origin[i];
        rise += plane->normal[i] * ray.direction[i];
    }
    if (rise > 0)
        ray.t_max = fmin(ray.t_max, -above / rise);
    else
        ray.t_min = fmax(ray.t_min, -above / rise);
    return ray;
}

TEST(complex_space_is_cut) {
    static const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {4, 0, 0}};
    static const algsurf_plane plane = {{0.25, 1, -0.5}, 0.125};
    static const double eye[3] = {3, 6, 4}, centre[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    static const algsurf_complex_space space = {.size = sizeof space, .sector = {0, 0.15}};
    static picture cut, whole;
    algsurf_surface *surface = surface_of(tangle);
    int fewer = 0, hits = 0;
    algsurf_camera camera = pinhole_of(eye, centre, up, 45);
    algsurf_scene *scene = scene_of(surface, &ball, NULL, NULL);
    assert_ok(algsurf_scene_set_camera(scene, &camera));
    assert_ok(algsurf_scene_set_complex_space(scene, &space));
    draw(scene, &whole);
    assert_ok(algsurf_scene_set_clip(scene, &plane, 1));
    draw(scene, &cut);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const algsurf_ray ray = cut_ray(&camera, &plane, i);
        algsurf_hit hit = {.state = ALGSURF_STATE_MISS};
        if (ray.t_min <= ray.t_max)
            assert_ok(algsurf_intersect_complex(surface, &ball, &ray, &space, NULL, NULL, &hit, NULL));
        if (hit.state != cut.states[i]) fail_msg("pixel %d: state %d, not %d", i, cut.states[i], hit.state);
        if (hit.state == ALGSURF_STATE_HIT && !(fabs(hit.t - cut.t[i]) < 1e-9))
            fail_msg("pixel %d: t = %a, not %a", i, cut.t[i], hit.t);
        fewer += whole.states[i] == ALGSURF_STATE_HIT && cut.states[i] != ALGSURF_STATE_HIT;
        hits += cut.states[i] == ALGSURF_STATE_HIT;
    }
    assert_true(fewer > 100 && hits > 500);
}

/* x - y <= 5 goes along the ray, and is kept by the part that the other two leave: whichever is given first.
 */
TEST(their_order_plays_no_part) {
    const algsurf_plane planes[3] = {{{1, -1, 0}, 5}, {{1, 0, 0}, 1}, {{-1, 0, 0}, 1}};
    const algsurf_ray ray = {{0, 0, 0}, {1, 1, 0}, -INFINITY, INFINITY};
    const algsurf_surface *surface = surface_of("x^2 + y^2 + z^2 + 1");
    for (int k = 0; k < 3; k++) {
        const algsurf_plane turned[3] = {planes[k], planes[(k + 1) % 3], planes[(k + 2) % 3]};
        const algsurf_intersect_options how = {.size = sizeof how, .planes = turned, .plane_count = 3};
        algsurf_hit hit;
        assert_int_equal(algsurf_intersect_first(surface, NULL, &ray, &how, &hit), ALGSURF_OK);
        assert_int_equal(hit.state, ALGSURF_STATE_MISS);
        assert_int_equal(hit.side, 1);
    }
}

/* ---- arguments ---- */

TEST(bad_planes_are_refused) {
    static const algsurf_plane good[ALGSURF_MAX_CLIP_PLANES + 1] = {{{1, 0, 0}, 0}};
    static const struct {
        algsurf_plane plane;
        algsurf_status status;
    } bad[] = {{{{0, 0, 0}, 1}, ALGSURF_E_ARGUMENT},
               {{{NAN, 1, 0}, 1}, ALGSURF_E_NOT_FINITE},
               {{{1, 0, INFINITY}, 1}, ALGSURF_E_NOT_FINITE},
               {{{1, 0, 0}, NAN}, ALGSURF_E_NOT_FINITE},
               {{{0, 0, 0}, -INFINITY}, ALGSURF_E_NOT_FINITE}};
    const algsurf_ray ray = {{-2, 0, 0}, {1, 0, 0}, 0, INFINITY};
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3, 0, 0}};
    static picture before, after;
    algsurf_intersect_options o = {.size = sizeof o, .plane_count = 1};
    algsurf_surface *surface = surface_of("x^2 + y^2 + z^2 = 1");
    algsurf_hit hit;
    algsurf_scene *scene = scene_of(surface, &ball, NULL, NULL);
    assert_int_equal(algsurf_intersect_first(surface, NULL, &ray, &o, &hit), ALGSURF_E_ARGUMENT);
    o.planes = good, o.plane_count = ALGSURF_MAX_CLIP_PLANES + 1;
    assert_int_equal(algsurf_intersect_first(surface, NULL, &ray, &o, &hit), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_scene_set_clip(scene, good, ALGSURF_MAX_CLIP_PLANES + 1), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_scene_set_clip(scene, NULL, 1), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_scene_set_clip(NULL, good, 1), ALGSURF_E_ARGUMENT);
    o.plane_count = 1;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        o.planes = &bad[i].plane;
        assert_int_equal(algsurf_intersect_first(surface, NULL, &ray, &o, &hit), bad[i].status);
        assert_int_equal(algsurf_scene_set_clip(scene, &bad[i].plane, 1), bad[i].status);
    }
    /* a scene's planes are set by algsurf_scene_set_clip alone, and stay */
    assert_ok(algsurf_scene_set_clip(scene, good, 1));
    draw(scene, &before);
    o.planes = good;
    assert_int_equal(algsurf_scene_set_intersect_options(scene, &o), ALGSURF_E_ARGUMENT);
    assert_ok(algsurf_scene_set_intersect_options(scene, NULL));
    draw(scene, &after);
    assert_memory_equal(before.bytes, after.bytes, sizeof before.bytes);
    assert_ok(algsurf_scene_set_clip(scene, NULL, 0));
    draw(scene, &after);
    assert_memory_not_equal(before.bytes, after.bytes, sizeof before.bytes);
}
