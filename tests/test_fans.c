/* test_fans.c - what fans say of shadow rays is what exact arithmetic says of each.
 *
 * Random surfaces of degree 1 to 7, extents (balls and boxes), lights (rectangles, slanted ones, lines,
 * single places) and points: on the surface and lifted a little, as pictures do, or anywhere.
 * - A fan's polynomials, evaluated exactly, differ from P on the segment by what its errors say at most.
 * - Each place of a light that is lit, dark, free or hidden is so for algsurf_occluded.
 * - All kernels say the same.
 * - Pictures in full quality are those of rays alone, to the byte.
 *
 * Breaks tried and caught by places_are_what_is_said: half sides of the light four fifths as large; the ends
 * of the middle segment taken for all, far ones, of a ball or a box; points outside the extent taken to be
 * inside; segments that end before they begin; no gap between ends; with 20000 scenes: third order left out
 * of the rest. Not caught, being far below what else a fan leaves open: the near end of a ball likewise, a
 * ten-thousandth of the weight of errors, no noise, the first sign taken as known.
 *
 *     test_fans [scenes [seed]]
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include <string.h>

#include "algsurf/algsurf.h"
#include "catalogue.h"
#include "exact.h"
#include "exact_ray.h"
#include "picture/impl.h"
#include "simd/kernel.h"

enum { MOST = ALGSURF_MAX_FAN_DEGREE, SIDE = MOST + 1, POINTS = ALGSURF_I_FANS, PLACES = 9 };

static long scene_count = 4000;
static uint64_t first_seed = 20261124;

static double uniform(uint64_t *seed, double lo, double hi) {
    return lo + (hi - lo) * 0.5 * (1 + exact_random_unit(seed));
}

/* A surface, an extent, a light, and points. */
typedef struct test_scene {
    int degree, count;
    algsurf_term terms[SIDE * SIDE];
    algsurf_surface *surface;
    algsurf_extent extent;
    double radius, position[3], edge[2][3];
    double place[3][PLACES], aside[2][PLACES], start[3][POINTS];
    algsurf_i_fan fan;
    algsurf_i_fan_job job;
    double q[SIDE * SIDE * SIDE], basis[SIDE * SIDE], sizes[SIDE * SIDE], along[SIDE * SIDE];
    double solids[POINTS * ALGSURF_I_FAN_SOLID(MOST)];
} test_scene;

static void set_surface(test_scene *s, uint64_t *seed) {
    int n = s->degree;
    s->count = 0;
    for (int i = 0; i <= n; i++)
        for (int j = 0; i + j <= n; j++) {
            int k = exact_random_int(seed, n - i - j + 1);
            double a = uniform(seed, -1, 1) / pow(s->radius, i + j + k);
            s->terms[s->count++] = (algsurf_term){i, j, k, a};
        }
    s->terms[s->count++] = (algsurf_term){0, 0, n, pow(s->radius, -n)};
    assert_int_equal(algsurf_surface_from_terms(s->terms, (size_t)s->count, &s->surface), ALGSURF_OK);
}

static void set_light(test_scene *s, uint64_t *seed) {
    double far = exact_random_int(seed, 3) ? uniform(seed, 1.5, 10) : uniform(seed, 0.2, 1.2), size = 0;
    if (exact_random_int(seed, 12) == 0) far *= 1e6;
    for (int i = 0; i < 3; i++) {
        s->position[i] = s->extent.centre[i] + s->radius * uniform(seed, -far, far);
        size = fmax(size, fabs(s->position[i] - s->extent.centre[i]));
        for (int e = 0; e < 2; e++) s->edge[e][i] = 0;
    }
    int kind = exact_random_int(seed, 4);
    double edge = size * ldexp(1, -exact_random_int(seed, 6) - 1);
    for (int e = 0; e < 2 && kind < 3; e++)
        for (int i = 0; i < 3; i++)
            s->edge[e][i] = kind == 0 && i != e ? 0 : e == 1 && kind == 2 ? 0 : uniform(seed, -edge, edge);
}

/* The corners, the middle, and places between. */
static void set_places(test_scene *s, uint64_t *seed) {
    static const double at[5][2] = {{-0.5, -0.5}, {-0.5, 0.5}, {0.5, -0.5}, {0.5, 0.5}, {0, 0}};
    for (int p = 0; p < PLACES; p++) {
        double u = p < 5 ? at[p][0] : uniform(seed, -0.5, 0.5),
               v = p < 5 ? at[p][1] : uniform(seed, -0.5, 0.5);
        for (int i = 0; i < 3; i++) s->place[i][p] = s->position[i] + u * s->edge[0][i] + v * s->edge[1][i];
    }
}

/* As in pictures: natural units, the shown size, the error of places (picture/shadow.c). */
static void set_fan(test_scene *s) {
    algsurf_i_fan *fan = &s->fan;
    algsurf_i_view *view = &fan->frame.view;
    int unit = s->surface->unit;
    double natural[3], edges[2][3];
    memset(fan, 0, sizeof *fan);
    fan->frame.q = s->q, fan->frame.basis = s->basis, fan->frame.sizes = s->sizes,
    fan->frame.along = s->along;
    for (int i = 0; i < 3; i++) {
        view->centre[i] = ldexp(s->extent.centre[i], -unit);
        natural[i] = ldexp(s->position[i], -unit);
        for (int e = 0; e < 2; e++) edges[e][i] = ldexp(s->edge[e][i], -unit);
    }
    view->size = ldexp(s->radius * (1 + 0x1p-20), -unit);
    double places = 0;
    for (int i = 0; i < 3; i++)
        places = fmax(places, 0x1p-50 * (fabs(natural[i]) + fabs(edges[0][i]) + fabs(edges[1][i])));
    void *memory = malloc(algsurf_i_frame_memory(s->degree));
    algsurf_i_fan_expand(s->surface, natural, edges[0], edges[1], 3 * places, fan, memory);
    free(memory);
    assert_true(fan->usable);
    s->job = (algsurf_i_fan_job){.fan = fan, .unit = ldexp(1, -unit), .extent_kind = s->extent.kind};
    for (int i = 0; i < 3; i++) {
        s->job.light[i] = (natural[i] - view->centre[i]) / view->size;
        s->job.extent_size[i] = ldexp(s->extent.size[i], -unit) / view->size;
    }
    for (int p = 0; p < PLACES; p++)
        for (int k = 0; k < 2; k++) {
            s->aside[k][p] = 0;
            for (int i = 0; i < 3; i++)
                s->aside[k][p] += (ldexp(s->place[i][p], -unit) - natural[i]) / view->size * view->axis[k][i];
        }
}

/* A point where a random line meets the surface, lifted by a millionth; 0 if it does not. */
static int lifted(const test_scene *s, uint64_t *seed, double point[3]) {
    algsurf_ray ray = {.t_min = 0, .t_max = HUGE_VAL};
    algsurf_hit hit;
    double to = 0, size = 0;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = s->extent.centre[i] + s->radius * uniform(seed, -3, 3);
        ray.direction[i] = s->extent.centre[i] + s->radius * uniform(seed, -0.7, 0.7) - ray.origin[i];
    }
    assert_true(algsurf_intersect_first(s->surface, &s->extent, &ray, NULL, &hit) >= 0);
    if (hit.state != ALGSURF_HIT) return 0;
    for (int i = 0; i < 3; i++) to += hit.normal[i] * ray.direction[i], size += fabs(hit.normal[i]);
    for (int i = 0; i < 3; i++)
        point[i] = hit.position[i] + (to > 0 ? -1e-6 : 1e-6) * s->radius * hit.normal[i];
    return size > 0;
}

static void set_points(test_scene *s, uint64_t *seed) {
    for (int p = 0; p < POINTS; p++) {
        double point[3];
        int found = 0;
        for (int turn = 0; turn < 6 && p % 4 && !found; turn++) found = lifted(s, seed, point);
        for (int i = 0; i < 3; i++)
            s->start[i][p] = found ? point[i] : s->extent.centre[i] + s->radius * uniform(seed, -0.6, 0.6);
    }
}

static void set_scene(test_scene *s, uint64_t *seed, int degree) {
    s->degree = degree;
    s->radius = ldexp(uniform(seed, 1, 2), exact_random_int(seed, 9) - 4);
    s->extent = (algsurf_extent){.kind = ALGSURF_EXTENT_SPHERE, .size = {s->radius, 0, 0}};
    set_surface(s, seed);
    if (exact_random_int(seed, 2)) {
        s->extent.kind = ALGSURF_EXTENT_BOX;
        for (int i = 0; i < 3; i++) s->extent.size[i] = s->radius * uniform(seed, 0.2, 0.57);
    }
    for (int i = 0; i < 3; i++) s->extent.centre[i] = ldexp(exact_random_int(seed, 17) - 8, -5) * s->radius;
    for (int i = 0; i < 3; i++) s->extent.centre[i] = (float)s->extent.centre[i];
    set_light(s, seed);
    set_places(s, seed);
    set_points(s, seed);
    set_fan(s);
}

/* What a kernel says of all points: how[p], and state[p][.] of those not known. */
typedef struct answers {
    uint8_t how[POINTS], state[POINTS][PLACES];
    algsurf_i_fan_point fan[POINTS];
} answers;

static void ask(test_scene *s, const algsurf_i_picture_kernel *code, answers *a) {
    const double *const start[3] = {s->start[0], s->start[1], s->start[2]};
    const double *const aside[2] = {s->aside[0], s->aside[1]};
    algsurf_i_fan_point *next = a->fan;
    memset(a, 0, sizeof *a);
    for (int p = 0; p < POINTS; p++) a->fan[p].r = s->solids + p * ALGSURF_I_FAN_SOLID(s->degree);
    code->see_light(&s->job, start, POINTS, a->how, a->fan);
    for (int p = 0; p < POINTS; p++)
        if (a->how[p] == ALGSURF_I_UNKNOWN) code->see_places(&s->job, next++, aside, PLACES, a->state[p]);
}

static algsurf_ray ray_to(const test_scene *s, int p, int place) {
    algsurf_ray ray = {.t_min = 0, .t_max = 1};
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = s->start[i][p];
        ray.direction[i] = s->place[i][place] - s->start[i][p];
    }
    return ray;
}

static void tell_ray(const test_scene *s, const algsurf_ray *ray, long turn) {
    fprintf(stderr, "scene %ld (seed %#llx): degree %d, %s\n", turn, (unsigned long long)first_seed,
            s->degree, s->extent.kind == ALGSURF_EXTENT_BOX ? "box" : "ball");
    exact_print_doubles("origin", ray->origin, 3);
    exact_print_doubles("direction", ray->direction, 3);
}

static struct { long lit, dark, free, hidden, open, aside; } told;

static void check_place(const test_scene *s, const answers *a, int p, int place, long turn) {
    const algsurf_ray ray = ray_to(s, p, place);
    int truth = -1, said = a->how[p] == ALGSURF_I_LIT                ? ALGSURF_MISS
                           : a->how[p] == ALGSURF_I_DARK             ? ALGSURF_HIT
                           : a->state[p][place] == ALGSURF_LANE_MISS ? ALGSURF_MISS
                                                                     : ALGSURF_HIT;
    if (a->how[p] == ALGSURF_I_ASIDE) return;
    if (a->how[p] == ALGSURF_I_UNKNOWN && a->state[p][place] == ALGSURF_LANE_DOUBTFUL) {
        told.open++;
        return;
    }
    assert_true(algsurf_occluded(s->surface, &s->extent, &ray, NULL, &truth) >= 0);
    if (truth != said) {
        tell_ray(s, &ray, turn);
        fprintf(stderr, "point %d, place %d: said %d (of the light %d), is %d\n", p, place, said, a->how[p],
                truth);
    }
    assert_int_equal(truth, said);
    told.lit += a->how[p] == ALGSURF_I_LIT, told.dark += a->how[p] == ALGSURF_I_DARK;
    if (a->how[p] == ALGSURF_I_UNKNOWN) *(said == ALGSURF_MISS ? &told.free : &told.hidden) += 1;
}

static void places_are_what_is_said(void **state) {
    (void)state;
    uint64_t seed = first_seed;
    for (long turn = 0; turn < scene_count; turn++) {
        static test_scene s;
        static answers a, other;
        set_scene(&s, &seed, 1 + (int)(turn % MOST));
        ask(&s, &algsurf_i_picture_baseline, &a);
        for (int i = 0; i < ALGSURF_KERNELS; i++) {
            const algsurf_i_kernel *kernel = algsurf_i_kernel_at(i);
            if (!kernel) continue;
            ask(&s, algsurf_i_picture_kernel_for(kernel), &other);
            assert_memory_equal(a.how, other.how, sizeof a.how);
            assert_memory_equal(a.state, other.state, sizeof a.state);
        }
        for (int p = 0; p < POINTS; p++) {
            told.aside += a.how[p] == ALGSURF_I_ASIDE;
            for (int place = 0; place < PLACES; place++) check_place(&s, &a, p, place, turn);
        }
        algsurf_surface_free(s.surface);
    }
    printf("places: %ld lit, %ld dark with their light; %ld free, %ld hidden one by one; %ld in doubt; %ld "
           "points "
           "aside; 0 wrong\n",
           told.lit, told.dark, told.free, told.hidden, told.open, told.aside);
    assert_true(told.lit > scene_count && told.dark > scene_count && told.free > scene_count &&
                told.hidden > scene_count / 2 &&
                told.open * 20 < told.lit + told.dark + told.free + told.hidden);
}

/* |fan - P| over the fan's error, at part t of its segment to a place. */
static double share_of_error(const test_scene *s, const algsurf_i_fan_point *fan, int p, int place,
                             double t) {
    const algsurf_ray ray = ray_to(s, p, place);
    exact_line line = exact_line_of(s->terms, s->count, s->degree, &ray);
    int n = s->degree;
    const double *r = fan->r;
    mpq_t whole, row, power[3], at[3], w;
    mpq_inits(whole, row, power[0], power[1], power[2], at[0], at[1], at[2], w, NULL);
    exact_set(at[2], t), exact_set(w, fan->part);
    for (int k = 0; k < 2; k++) {
        exact_set(at[k], s->aside[k][place]);
        mpq_mul(at[k], at[k], w), mpq_mul(at[k], at[k], at[2]);
    }
    mpq_set_ui(power[0], 1, 1);
    for (int i = 0; i <= n; i++, mpq_mul(power[0], power[0], at[0])) {
        mpq_set(power[1], power[0]);
        for (int j = 0; i + j <= n; j++, mpq_mul(power[1], power[1], at[1])) {
            mpq_set(power[2], power[1]);
            for (int k = 0; i + j + k <= n; k++, mpq_mul(power[2], power[2], at[2])) {
                exact_set(row, *r++), mpq_mul(row, row, power[2]), mpq_add(whole, whole, row);
            }
        }
    }
    mpq_mul(at[2], at[2], w); /* along the ray */
    mpq_set_ui(row, 0, 1);
    for (int k = n; k >= 0; k--) {
        mpq_mul(row, row, at[2]);
        mpq_set_z(w, line.c[k]), mpq_add(row, row, w);
    }
    long shift = line.shift - s->surface->scale;
    if (shift > 0)
        mpq_div_2exp(row, row, (mp_bitcnt_t)shift);
    else
        mpq_mul_2exp(row, row, (mp_bitcnt_t)-shift);
    mpq_sub(whole, whole, row), mpq_abs(whole, whole);
    double share = mpq_get_d(whole) / fan->error[t > 0];
    mpq_clears(whole, row, power[0], power[1], power[2], at[0], at[1], at[2], w, NULL);
    exact_line_clear(&line);
    return share;
}

static void fans_keep_their_bound(void **state) {
    (void)state;
    uint64_t seed = first_seed;
    double worst[2] = {0, 0};
    long count = 0;
    for (long turn = 0; turn < scene_count; turn++) {
        static test_scene s;
        static answers a;
        set_scene(&s, &seed, 1 + (int)(turn % MOST));
        ask(&s, algsurf_i_picture_kernel_for(algsurf_i_kernel_find(NULL)), &a);
        const algsurf_i_fan_point *fan = a.fan;
        for (int p = 0; p < POINTS; p++) {
            if (a.how[p] != ALGSURF_I_UNKNOWN) continue;
            double t = exact_random_int(&seed, 4) ? uniform(&seed, 0, 1) : exact_random_int(&seed, 2);
            int place = exact_random_int(&seed, PLACES);
            double share = share_of_error(&s, fan++, p, place, t);
            const algsurf_ray ray = ray_to(&s, p, place);
            if (!(share <= 1)) {
                tell_ray(&s, &ray, turn);
                fprintf(stderr, "t %a: %g of the bound\n", t, share);
            }
            assert_true(share <= 1);
            worst[t > 0] = fmax(worst[t > 0], share);
            count++;
        }
        algsurf_surface_free(s.surface);
    }
    printf("fans: %ld points; the worst error is %.3g of its bound at the point, %.3g along the segment\n",
           count, worst[0], worst[1]);
    assert_true(worst[0] > 0x1p-14 && worst[1] > 0x1p-14);
}

/* ---- pictures ---- */

static int no_fans;

const algsurf_i_picture_kernel *__real_algsurf_i_picture_kernel_for(const algsurf_i_kernel *kernel);
const algsurf_i_picture_kernel *__wrap_algsurf_i_picture_kernel_for(const algsurf_i_kernel *kernel);

static void see_nothing(const algsurf_i_fan_job *job, const double *const start[3], int count, uint8_t *how,
                        algsurf_i_fan_point *unknown) {
    (void)job, (void)start, (void)unknown;
    memset(how, ALGSURF_I_ASIDE, (size_t)count);
}

const algsurf_i_picture_kernel *__wrap_algsurf_i_picture_kernel_for(const algsurf_i_kernel *kernel) {
    static algsurf_i_picture_kernel without;
    without = *__real_algsurf_i_picture_kernel_for(kernel);
    without.see_light = see_nothing;
    return no_fans ? &without : __real_algsurf_i_picture_kernel_for(kernel);
}

enum { WIDE = 72, HIGH = 54 };

typedef struct image {
    uint8_t pixels[3 * WIDE * HIGH];
    algsurf_render_stats stats;
} image;

static void draw(const algsurf_scene *scene, int without, image *to) {
    const algsurf_picture picture = {.size = sizeof picture, .pixels = to->pixels};
    const algsurf_render_options size = {.size = sizeof size, .width = WIDE, .height = HIGH, .threads = 1};
    to->stats = (algsurf_render_stats){.size = sizeof to->stats};
    no_fans = without;
    assert_int_equal(algsurf_render(scene, &size, &picture, &to->stats), ALGSURF_OK);
    no_fans = 0;
}

/* The default lights, then some in other places: slanted, inside the extent, lines, seen along their plane.
 */
static void set_lights(algsurf_scene *scene, const catalogue_entry *entry, int which, uint64_t *seed) {
    algsurf_light lights[2];
    if (which == 0) return;
    for (int l = 0; l < 2; l++) {
        double far = which == 2 ? 0.8 : 6, edge = l == 1 && which == 3 ? 0 : 0.3 * far;
        lights[l] = (algsurf_light){.colour = {0.8, 0.7, 0.6}, .samples_u = 5, .samples_v = 1 + 2 * which};
        for (int i = 0; i < 3; i++) {
            double size = entry->extent.size[0];
            lights[l].position[i] = entry->extent.centre[i] + size * uniform(seed, -far, far);
            lights[l].edge_u[i] = size * uniform(seed, -edge, edge);
            lights[l].edge_v[i] = size * uniform(seed, -edge, edge);
        }
    }
    assert_int_equal(algsurf_scene_set_lights(scene, lights, 2), ALGSURF_OK);
}

static void pictures_are_those_of_rays(void **state) {
    static const char *const names[] = {"sphere", "whitney", "steiner", "chair",
                                        "tangle", "boy",     "barth",   "labs"};
    (void)state;
    uint64_t seed = first_seed, rays = 0, left = 0;
    for (int n = 0; n < 8; n++)
        for (int which = 0; which < 4; which++) {
            static image fans, alone, around;
            const catalogue_entry *entry = catalogue_find(names[n]);
            algsurf_surface *surface;
            algsurf_scene *scene;
            algsurf_camera camera;
            assert_int_equal(algsurf_surface_from_equation(entry->equation, NULL, 0, &surface, NULL),
                             ALGSURF_OK);
            assert_int_equal(algsurf_scene_create(surface, &scene), ALGSURF_OK);
            assert_int_equal(algsurf_scene_set_extent(scene, &entry->extent), ALGSURF_OK);
            assert_int_equal(
                algsurf_camera_pinhole(entry->eye, entry->look_at, entry->up, entry->fov, &camera),
                ALGSURF_OK);
            assert_int_equal(algsurf_scene_set_camera(scene, &camera), ALGSURF_OK);
            assert_int_equal(algsurf_scene_set_quality(scene, ALGSURF_QUALITY_FULL), ALGSURF_OK);
            set_lights(scene, entry, which, &seed);
            draw(scene, 0, &fans);
            draw(scene, 1, &alone);
            assert_memory_equal(fans.pixels, alone.pixels, sizeof fans.pixels);
            assert_int_equal(algsurf_scene_set_lights(scene, NULL, 0), ALGSURF_OK);
            draw(scene, 0, &around);
            rays += alone.stats.shadow_rays - around.stats.shadow_rays;
            left += fans.stats.shadow_rays - around.stats.shadow_rays;
            algsurf_scene_free(scene);
            algsurf_surface_free(surface);
        }
    printf("pictures: of %llu rays to lights %llu were shot\n", (unsigned long long)rays,
           (unsigned long long)left);
    assert_true(left * 5 < rays);
}

int main(int argc, char **argv) {
    if (argc > 1) scene_count = atol(argv[1]);
    if (argc > 2) first_seed = strtoull(argv[2], NULL, 0);
    const struct CMUnitTest tests[] = {cmocka_unit_test(fans_keep_their_bound),
                                       cmocka_unit_test(places_are_what_is_said),
                                       cmocka_unit_test(pictures_are_those_of_rays)};
    return cmocka_run_group_tests_name("fans", tests, NULL, NULL);
}
