/* test_render_range.c - the pixels that a row leaves out are misses.
 *
 * Two oracles.  Over rationals: the lines of a row form an exact pencil, or are parallel, and no ray that is
 * left out may meet the ball of radius 1.  In pictures: a surface that all but fills its extent, where every
 * pixel must be what algsurf_intersect_first says of the ray of algsurf_camera_ray.  Both try the places
 * where a range is hard to tell: the eye on the extent's sphere, on a face of its box, on a plane that
 * touches them, or some roundings beside; tiny angles of view; tiny and huge extents; eyes far aside;
 * parallel rays.
 *
 * Breaks tried, each caught by the tests named:
 *   the ends of a quadratic equation in doubles, without proof:
 *       left_out_are_misses, reproduction, pictures_as_by_rays (with 3000 of them)
 *   the ends as they are guessed, without proof: left_out_are_misses
 *   a ball smaller by 2^-20 instead of larger: left_out_are_misses
 *   the line of the next pixel further out as the proof: left_out_are_misses
 *   left taken for right; all pixels, always: ordinary_ranges_are_tight
 *
 *     test_render_range [rows [pictures [seed]]]
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "exact.h"
#include "render_case.h"
#include "picture/impl.h"

static long row_count = 6000, picture_count = 400;
static uint64_t first_seed = 20270117;

static double uniform(uint64_t *seed, double lo, double hi) {
    return lo + (hi - lo) * 0.5 * (1 + exact_random_unit(seed));
}

static int one_of(uint64_t *seed, int n) { return (int)uniform(seed, 0, n) % n; }

static double power_between(uint64_t *seed, double lo, double hi) { return exp2(uniform(seed, lo, hi)); }

/* x, or some roundings beside it. */
static double beside(uint64_t *seed, double x) {
    static const int steps[] = {0, 0, 1, 2, 5, 100};
    double towards = one_of(seed, 2) ? INFINITY : -INFINITY;
    for (int i = steps[one_of(seed, 6)]; i > 0; i--) x = nextafter(x, towards);
    return x;
}

/* Distances of planes that touch the ball, what is larger by the view's 2^-20, or what the proof takes. */
static double touching(uint64_t *seed) {
    const double distances[] = {1, 1 + 0x1p-20, sqrt(1 + 0x1p-14), sqrt(1 + 0x1p-14) * (1 + 0x1p-20)};
    return beside(seed, distances[one_of(seed, 4)]);
}

/* ---- rows over rationals ---- */

enum { MOST_WIDTH = 300 };

/* A row in the view's unit: the rays start at (eye[0], eye[1], eye[2]). */
typedef struct test_row {
    int number, width, orthographic;
    double eye[3], pixel, offset, place; /* place: v = eye[1] + du place */
    algsurf_i_view view;
    algsurf_i_row_form form;
    algsurf_i_row_job job;
} test_row;

/* As place_eye and make_job fill them. */
static void set_row(test_row *r, double per_slope) {
    double du = r->orthographic ? per_slope : -r->eye[2];
    r->view.alpha = r->orthographic ? 0 : -1 / r->eye[2];
    for (int k = 0; k < 2; k++) r->view.beta[k] = r->orthographic ? 0 : r->eye[k] / r->eye[2];
    r->form.v = r->eye[1] + du * r->place;
    r->job = (algsurf_i_row_job){.view = &r->view,
                                 .row = &r->form,
                                 .offset = r->offset,
                                 .pixel = r->pixel,
                                 .u0 = r->eye[0],
                                 .du = du,
                                 .slope = r->view.alpha * r->form.v + r->view.beta[1],
                                 .near = r->eye[2]};
}

/* Does the ray through that pixel meet the ball of radius 1?  |e + t d| = 1, t >= 0. */
static int meets_ball(const test_row *r, int x) {
    mpq_t p, q, w, e[3], d[3], a, b, c;
    mpq_inits(p, q, w, e[0], e[1], e[2], d[0], d[1], d[2], a, b, c, NULL);
    mpq_set_si(p, x, 1), exact_set(w, r->offset), mpq_add(p, p, w);
    exact_set(w, r->pixel), mpq_mul(p, p, w), exact_set(q, r->place);
    for (int i = 0; i < 3; i++) exact_set(e[i], r->eye[i]);
    mpq_set_ui(d[2], 1, 1);
    if (r->orthographic) {
        exact_set(w, r->job.du);
        mpq_mul(p, p, w), mpq_add(e[0], e[0], p), mpq_mul(q, q, w), mpq_add(e[1], e[1], q);
    } else {
        mpq_set(d[0], p), mpq_set(d[1], q);
    }
    mpq_set_si(c, -1, 1);
    for (int i = 0; i < 3; i++) {
        mpq_mul(w, d[i], d[i]), mpq_add(a, a, w);
        mpq_mul(w, e[i], d[i]), mpq_add(b, b, w);
        mpq_mul(w, e[i], e[i]), mpq_add(c, c, w);
    }
    mpq_mul(w, b, b), mpq_mul(a, a, c);
    int meets = mpq_sgn(c) <= 0 || (mpq_sgn(b) < 0 && mpq_cmp(w, a) >= 0);
    mpq_clears(p, q, w, e[0], e[1], e[2], d[0], d[1], d[2], a, b, c, NULL);
    return meets;
}

/* An eye at the ball, on a plane that touches it, far away, inside: or some roundings beside. */
static void random_eye(test_row *r, uint64_t *seed) {
    double far = one_of(seed, 2) ? power_between(seed, -3, 4) : power_between(seed, 0, 26), length = 0;
    for (int i = 0; i < 3; i++) r->eye[i] = exact_random_unit(seed);
    if (one_of(seed, 2)) r->eye[1] = 0;
    for (int i = 0; i < 3; i++) length += r->eye[i] * r->eye[i];
    for (int i = 0; i < 3; i++) r->eye[i] *= far / sqrt(length);
    switch (one_of(seed, 5)) {
    case 0: /* on a plane that touches the ball */
        r->eye[2] = (one_of(seed, 4) ? -1 : 1) * touching(seed);
        if (one_of(seed, 2)) r->eye[1] = 0;
        break;
    case 1: /* on the ball */
        for (int i = 0; i < 3; i++) r->eye[i] = beside(seed, r->eye[i] / far);
        break;
    case 2: /* looking at its middle */
        r->eye[0] = r->eye[1] = 0, r->eye[2] = -beside(seed, 1 + far);
        break;
    case 3: /* looking past it */
        r->eye[0] = (one_of(seed, 2) ? 1 : -1) * touching(seed);
        break;
    default:
        break;
    }
    if (fabs(r->eye[2]) < 0x1p-10) r->eye[2] = -1;
}

/* Pixels about the middle, about the border of the ball, or anywhere. */
static void random_row(test_row *r, uint64_t *seed) {
    r->orthographic = one_of(seed, 4) == 0;
    r->width = 1 + one_of(seed, MOST_WIDTH);
    random_eye(r, seed);
    double per_slope = one_of(seed, 2) ? 1 : power_between(seed, -330, 330);
    double scale = r->orthographic ? per_slope : fabs(r->eye[2]), aim = 0, about = 0;
    if (one_of(seed, 3)) { /* at the ball's middle or border, where that is in front */
        double side = one_of(seed, 3) - 1;
        aim = (side - r->eye[0]) / scale, about = (0.9 * side * exact_random_unit(seed) - r->eye[1]) / scale;
    }
    r->pixel = one_of(seed, 8) ? power_between(seed, -12, 1) / scale : power_between(seed, -990, -20);
    r->offset = aim / r->pixel - r->width * uniform(seed, 0, 1);
    if (one_of(seed, 3) == 0) r->offset = 0.5 - 0.5 * r->width;
    r->place = about + (one_of(seed, 2) ? exact_random_unit(seed) / scale : 0);
    if (r->eye[1] == 0 && one_of(seed, 2)) r->place = 0; /* the row's plane goes through the ball's centre */
    set_row(r, per_slope);
}

/* Is the noise below 2^-22, as picture/view.c demands?  NaN fails. */
static int is_moderate(const test_row *r) {
    double slopes = fabs(r->place) + fmax(fabs(r->offset), fabs(r->offset + r->width)) * r->pixel;
    double distance = fabs(r->eye[2]), offset = fabs(r->eye[0]) + fabs(r->eye[1]), s = slopes;
    if (r->orthographic) return 8 * (offset + 2 * fabs(r->job.du) * s + 2) < 0x1p31;
    return (4 + 20 * s) * (distance + 1) + offset * (8 + 16 / distance) < 0x1p31;
}

static void show_row(const test_row *r, int x, int begin, int end) {
    print_message("seed %llu, row %d: %s, eye %a %a %a, width %d, pixel %a, offset %a, place %a, du %a\n",
                  (unsigned long long)first_seed, r->number, r->orthographic ? "parallel" : "pinhole",
                  r->eye[0], r->eye[1], r->eye[2], r->width, r->pixel, r->offset, r->place, r->job.du);
    print_message("pixel %d meets the ball, range %d to %d\n", x, begin, end);
}

static struct { long rows, lost, out, empty, whole, meeting, pinhole, parallel; } rows;

/* All pixels that are left out, but in the midst of many. */
static void check_row(const test_row *r) {
    int begin, end, meeting = 0;
    algsurf_i_packets_range(&r->job, r->width, &begin, &end);
    assert_true(0 <= begin && begin <= end && end <= r->width);
    for (int x = 0; x < r->width; x++) {
        int inside = begin <= x && x < end, meets = meets_ball(r, x);
        meeting |= meets;
        rows.out += !inside;
        if (inside || !meets) continue;
        if (rows.lost++ < 5) show_row(r, x, begin, end);
    }
    rows.rows++;
    rows.empty += begin == end;
    rows.whole += end - begin == r->width;
    rows.meeting += meeting;
    rows.parallel += r->orthographic;
    rows.pinhole += !r->orthographic;
}

static void left_out_are_misses(void **state) {
    uint64_t seed = first_seed;
    (void)state;
    for (int i = 0; i < row_count; i++) {
        test_row r = {.number = i};
        random_row(&r, &seed);
        if (is_moderate(&r)) check_row(&r);
    }
    print_message("%ld rows: %ld pinhole, %ld parallel; %ld empty, %ld whole, %ld meet the ball; "
                  "%ld pixels left out, %ld lost\n",
                  rows.rows, rows.pinhole, rows.parallel, rows.empty, rows.whole, rows.meeting, rows.out,
                  rows.lost);
    assert_true(rows.lost == 0);
    assert_true(rows.parallel > row_count / 8 && rows.pinhole > row_count / 3);
    assert_true(rows.out > 10 * row_count && rows.meeting > row_count / 5);
}

/* Before a camera that looks at the extent, the range is at most four pixels too long at each end. */
static void ordinary_ranges_are_tight(void **state) {
    (void)state;
    memset(&rows, 0, sizeof rows);
    for (int orthographic = 0; orthographic < 2; orthographic++)
        for (int y = 0; y < 200; y++) {
            test_row r = {.number = y, .width = MOST_WIDTH, .orthographic = orthographic, .eye = {0, 0, -4}};
            int begin, end, first = r.width, last = -1;
            double unit = orthographic ? 1 : 0.25;
            r.pixel = unit * 2.5 / r.width;
            r.offset = 0.5 - 0.5 * r.width;
            r.place = unit * 1.2 * (y - 99.5) / 100;
            set_row(&r, 1);
            check_row(&r);
            algsurf_i_packets_range(&r.job, r.width, &begin, &end);
            for (int x = 0; x < r.width; x++)
                if (meets_ball(&r, x)) first = first < x ? first : x, last = x;
            if (last >= 0)
                assert_true(begin >= first - 4 && end <= last + 5);
            else
                assert_true(end - begin <= 9);
        }
    assert_true(rows.lost == 0);
}

/* ---- pictures against single rays ---- */

typedef struct test_view {
    long number;
    int width, height, antialias;
    algsurf_extent extent;
    algsurf_camera camera;
    algsurf_term terms[4];
} test_view;

static struct { long views, hits, pixels, lost, mixed; } seen;

static void show_view(const test_view *v, int x, int y) {
    const algsurf_camera *c = &v->camera;
    print_message("seed %llu, view %ld, %dx%d, pixel %d,%d: kind %d centre %a %a %a size %a %a %a\n",
                  (unsigned long long)first_seed, v->number, v->width, v->height, x, y, (int)v->extent.kind,
                  v->extent.centre[0], v->extent.centre[1], v->extent.centre[2], v->extent.size[0],
                  v->extent.size[1], v->extent.size[2]);
    print_message("    eye %a %a %a right %a %a %a up %a %a %a forward %a %a %a half_height %a parallel %d\n",
                  c->eye[0], c->eye[1], c->eye[2], c->right[0], c->right[1], c->right[2], c->up[0], c->up[1],
                  c->up[2], c->forward[0], c->forward[1], c->forward[2], c->half_height, c->orthographic);
    for (int i = 0; i < 4; i++)
        print_message("    term %d %d %d %a\n", v->terms[i].i, v->terms[i].j, v->terms[i].k, v->terms[i].a);
}

/* Returns the number of hits of single rays. */
static long compare_with_rays(const test_view *v) {
    size_t count = (size_t)v->width * (size_t)v->height;
    uint8_t *bytes = malloc(3 * count);
    double *hits = malloc(count * sizeof *hits);
    long alone = 0;
    algsurf_surface *surface = NULL;
    algsurf_scene *scene = NULL;
    algsurf_render_options how = {.size = sizeof how, .width = v->width, .height = v->height, .threads = 1};
    assert_true(bytes && hits);
    const algsurf_picture planes = {.size = sizeof planes, .pixels = bytes, .t = hits};
    assert_int_equal(algsurf_surface_from_terms(v->terms, 4, &surface), ALGSURF_OK);
    assert_int_equal(algsurf_scene_create(surface, &scene), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_extent(scene, &v->extent), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_camera(scene, &v->camera), ALGSURF_OK);
    assert_int_equal(algsurf_render(scene, &how, &planes, NULL), ALGSURF_OK);
    for (size_t i = 0; i < count; i++) {
        int x = (int)(i % (size_t)v->width), y = (int)(i / (size_t)v->width);
        algsurf_ray ray;
        algsurf_hit hit;
        assert_int_equal(algsurf_camera_ray(&v->camera, v->width, v->height, x + 0.5, y + 0.5, &ray),
                         ALGSURF_OK);
        assert_int_equal(algsurf_intersect_first(surface, &v->extent, &ray, NULL, &hit), ALGSURF_OK);
        alone += hit.state == ALGSURF_HIT;
        if (hit.state == ALGSURF_UNDECIDED || (hit.state == ALGSURF_HIT) == !isinf(hits[i])) continue;
        if (seen.lost++ < 5) show_view(v, x, y);
    }
    seen.views++;
    seen.hits += alone;
    seen.pixels += (long)count;
    seen.mixed += alone > 0 && alone < (long)count;
    algsurf_scene_free(scene);
    algsurf_surface_free(surface);
    free(bytes), free(hits);
    return alone;
}

/* x^2 + y^2 + z^2 = r2 about the origin, all coordinates scaled. */
static void set_sphere(test_view *v, double r2) {
    for (int i = 0; i < 3; i++)
        v->terms[i] = (algsurf_term){i == 0 ? 2 : 0, i == 1 ? 2 : 0, i == 2 ? 2 : 0, 1};
    v->terms[3] = (algsurf_term){0, 0, 0, -r2};
}

static void reproduction(void **state) {
    const double eye[3] = {3, 0, 0x1.0000100000001p+0}, up[3] = {0, 1, 0};
    const double look[3] = {3, 0, eye[2] - 1};
    test_view v = {
        .number = -1, .width = 1024, .height = 16, .extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}}};
    (void)state;
    set_sphere(&v, 0.81);
    assert_int_equal(algsurf_camera_pinhole(eye, look, up, 6, &v.camera), ALGSURF_OK);
    seen.lost = 0;
    long hits = compare_with_rays(&v);
    print_message("%ld hits, %ld lost\n", hits, seen.lost);
    assert_true(hits == 4698 && seen.lost == 0);
}

/* An axis, or any direction, of length 1. */
static void random_direction(uint64_t *seed, double d[3]) {
    double length = 0;
    int axis = one_of(seed, 6);
    for (int i = 0; i < 3; i++) d[i] = axis < 3 ? (double)(i == axis) : exact_random_unit(seed);
    for (int i = 0; i < 3; i++) length += d[i] * d[i];
    for (int i = 0; i < 3; i++) d[i] *= (one_of(seed, 2) ? 1 : -1) / sqrt(length);
}

/* The eye on the sphere, on the box's face plane, on a plane across the view that touches the ball, in a wide
 * picture, or far aside; or some roundings beside. */
static void place_camera(test_view *v, uint64_t *seed, double radius) {
    double eye[3], look[3], up[3], forward[3], aside[3], along = 0, size = radius * touching(seed);
    double far = size * (one_of(seed, 4) ? uniform(seed, 1, 4) : power_between(seed, 2, 24));
    double fov = one_of(seed, 6) ? uniform(seed, 1, 120) : one_of(seed, 2) ? 1e-290 : 1e-6;
    random_direction(seed, forward), random_direction(seed, aside), random_direction(seed, up);
    int place = one_of(seed, 5), to_centre = one_of(seed, 8) == 0;
    if (place == 1 && one_of(seed, 4)) /* in a plane of symmetry */
        for (int i = 0, k = one_of(seed, 3); i < 3; i++)
            forward[i] = i == k, up[i] = i == (k + 1) % 3, aside[i] = i == (k + 2) % 3;
    for (int i = 0; i < 3; i++) along += aside[i] * forward[i];
    double face = v->extent.kind == ALGSURF_EXTENT_BOX ? v->extent.size[v->number % 3] : size;
    for (int i = 0; i < 3; i++) {
        double across = aside[i] - along * forward[i];
        if (place == 0) eye[i] = beside(seed, size * aside[i]);                   /* on the sphere */
        if (place == 1) eye[i] = beside(seed, -size * forward[i] + far * across); /* plane that touches */
        if (place == 2) eye[i] = i == v->number % 3 ? beside(seed, face) : far * aside[i];
        if (place == 3) eye[i] = far * aside[i];
        if (place == 4) eye[i] = beside(seed, 0.7 * size * aside[i]); /* inside */
        look[i] = eye[i] + size * (to_centre ? -aside[i] : forward[i]);
    }
    if (place == 3 && one_of(seed, 2)) /* at the border of the ball */
        for (int i = 0; i < 3; i++) look[i] = 0.99 * size * up[i];
    if (place == 1) v->width = 300, v->height = 3, fov = uniform(seed, 2, 40);
    int parallel = one_of(seed, 4) == 0;
    double height = radius * (fov < 1 ? 1e-9 : fov / 30);
    while ((parallel ? algsurf_camera_orthographic(eye, look, up, height, &v->camera)
                     : algsurf_camera_pinhole(eye, look, up, fov, &v->camera)) != ALGSURF_OK)
        for (int i = 0; i < 3; i++) up[i] = exact_random_unit(seed); /* it was along the view */
}

static void random_view(test_view *v, uint64_t *seed) {
    static const double sizes[] = {1, 1, 1, 3, 1e-100, 1e100}, shares[] = {0.81, 1 - 0x1p-12, 1 - 0x1p-30};
    double radius = sizes[one_of(seed, 6)];
    v->width = 16 + one_of(seed, 48);
    v->height = 4 + one_of(seed, 5);
    if (one_of(seed, 8) == 0) v->width = 1024, v->height = 2;
    v->extent = (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {radius, 0, 0}};
    set_sphere(v, radius * radius * shares[one_of(seed, 3)]);
    if (one_of(seed, 4) == 0) {
        v->extent.kind = ALGSURF_EXTENT_BOX;
        for (int i = 0; i < 3; i++) v->extent.size[i] = radius * uniform(seed, 0.55, 0.6);
    }
    place_camera(v, seed, radius);
}

static void pictures_as_by_rays(void **state) {
    uint64_t seed = first_seed;
    (void)state;
    memset(&seen, 0, sizeof seen);
    for (long i = 0; i < picture_count; i++) {
        test_view v = {.number = i};
        random_view(&v, &seed);
        (void)compare_with_rays(&v);
    }
    print_message("%ld views, %ld with hits and misses; %ld pixels, %ld hits, %ld lost\n", seen.views,
                  seen.mixed, seen.pixels, seen.hits, seen.lost);
    assert_true(seen.lost == 0);
    assert_true(seen.mixed > picture_count / 4 && seen.hits > 20 * picture_count);
}

int main(int argc, char **argv) {
    if (argc > 1) row_count = strtol(argv[1], NULL, 10);
    if (argc > 2) picture_count = strtol(argv[2], NULL, 10);
    if (argc > 3) first_seed = strtoull(argv[3], NULL, 10);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(left_out_are_misses),
        cmocka_unit_test(ordinary_ranges_are_tight),
        cmocka_unit_test(reproduction),
        cmocka_unit_test(pictures_as_by_rays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
