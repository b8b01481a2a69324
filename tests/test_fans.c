/* test_fans.c - what is known of shadow rays is what exact arithmetic says of each.
 *
 * Random surfaces of degree 1 to 10, of 1 to 7 for fans, extents (balls and boxes), lights (rectangles,
 * slanted ones, lines, single places) and points: on the surface and lifted a little, as pictures do, or
 * anywhere.
 * - A fan's polynomials, evaluated exactly, differ from P on the segment by what its errors say at most.
 * - So do the coefficients of single rays, to lights and around.
 * - What is searched of them ends where they leave the extent, within their gaps.
 * - Each place of a light that is lit, dark, free or hidden is so for algsurf_occluded, and so is each ray
 *   around.
 * - All kernels say the same.
 * - Pictures in full quality are those of rays alone, to the byte.
 *
 * Breaks tried, each caught by the test named:
 *   a thousandth of the weight of single rays' errors                              rays_keep_their_bound
 *   inverse binomial coefficients of another degree                                the same, and both below
 *   rays that end before they leave the extent; half sides of the light four fifths as large;
 *   the part behind a cell cut too far on                 rays_are_what_is_said, pictures_are_those_of_rays
 *   all points taken to be inside the extent                                       rays_are_what_is_said
 *   no gap between ends, an eighth of it; a ball's end too near                    rays_end_with_the_extent
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
#include "base/vec.h"
#include "picture/impl.h"
#include "simd/baseline.h"
#undef KERNEL
#define KERNEL(name) name##_here
#include "picture/shadows_template.h"

enum {
    MOST = ALGSURF_MAX_TAYLOR_DEGREE,
    SIDE = MOST + 1,
    POINTS = ALGSURF_I_STARTS,
    PLACES = 9,
    RAYS_AROUND = 16
};

static long scene_count = 8000;
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
    double place[3][PLACES], share[2][PLACES], aside[2][PLACES];
    algsurf_light light;
    algsurf_i_starts starts;
    algsurf_i_fan fan;
    algsurf_i_taylor taylor;
    algsurf_i_shadow_job job, around;
    double forms[2][SIDE * SIDE * SIDE + 3 * SIDE * SIDE];
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
        double u = s->share[0][p] = p < 5 ? at[p][0] : uniform(seed, -0.5, 0.5),
               v = s->share[1][p] = p < 5 ? at[p][1] : uniform(seed, -0.5, 0.5);
        for (int i = 0; i < 3; i++) s->place[i][p] = s->position[i] + u * s->edge[0][i] + v * s->edge[1][i];
    }
}

static void lay_out(double *arrays, int unit, const test_scene *s, algsurf_i_frame_form *frame) {
    frame->q = arrays;
    frame->basis = arrays + SIDE * SIDE * SIDE;
    frame->sizes = frame->basis + SIDE * SIDE;
    frame->along = frame->sizes + SIDE * SIDE;
    for (int i = 0; i < 3; i++) frame->view.centre[i] = ldexp(s->extent.centre[i], -unit);
    frame->view.size = ldexp(s->radius * (1 + 0x1p-20), -unit);
}

/* As in pictures: natural units, the shown size, the error of places (picture/shadow.c). */
static void set_forms(test_scene *s) {
    algsurf_i_fan *fan = &s->fan;
    const algsurf_i_view *view = &fan->frame.view;
    int unit = s->surface->unit;
    double natural[3], edges[2][3];
    memset(fan, 0, sizeof *fan), memset(&s->taylor, 0, sizeof s->taylor);
    lay_out(s->forms[0], unit, s, &fan->frame), lay_out(s->forms[1], unit, s, &s->taylor.frame);
    s->light = (algsurf_light){.samples_u = 1, .samples_v = 1};
    for (int i = 0; i < 3; i++) {
        natural[i] = ldexp(s->light.position[i] = s->position[i], -unit);
        edges[0][i] = ldexp(s->light.edge_u[i] = s->edge[0][i], -unit);
        edges[1][i] = ldexp(s->light.edge_v[i] = s->edge[1][i], -unit);
    }
    double places = 0;
    for (int i = 0; i < 3; i++)
        places = fmax(places, 0x1p-50 * (fabs(natural[i]) + fabs(edges[0][i]) + fabs(edges[1][i])));
    void *memory = malloc(algsurf_i_frame_memory(s->degree));
    if (s->degree <= ALGSURF_MAX_FAN_DEGREE)
        algsurf_i_fan_expand(s->surface, natural, edges[0], edges[1], 3 * places, fan, memory);
    algsurf_i_taylor_expand(s->surface, &s->taylor, memory);
    free(memory);
    assert_true(s->taylor.usable && fan->usable == (s->degree <= ALGSURF_MAX_FAN_DEGREE));
    s->around = (algsurf_i_shadow_job){.taylor = &s->taylor,
                                       .ball = s->radius / 2,
                                       .lattice = ALGSURF_I_LATTICE_STEP * RAYS_AROUND,
                                       .unit = ldexp(1, -unit),
                                       .extent_kind = s->extent.kind};
    for (int i = 0; i < 3; i++) s->around.extent_size[i] = ldexp(s->extent.size[i], -unit) / view->size;
    s->job = s->around;
    s->job.fan = fan->usable ? fan : NULL, s->job.light = &s->light;
    for (int k = 0; k < 2; k++) s->job.place[k] = s->share[k];
    for (int i = 0; i < 3; i++) s->job.to_light[i] = (natural[i] - view->centre[i]) / view->size;
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

/* Points that face the light, or anywhere. */
static void set_points(test_scene *s, uint64_t *seed) {
    s->starts.count = POINTS;
    for (int p = 0; p < POINTS; p++) {
        double point[3], facing[3];
        int found = 0;
        for (int turn = 0; turn < 6 && p % 4 && !found; turn++) found = lifted(s, seed, point);
        for (int i = 0; i < 3; i++) {
            if (!found) point[i] = s->extent.centre[i] + s->radius * uniform(seed, -0.6, 0.6);
            s->starts.at[i][p] = point[i];
            facing[i] = p % 5 ? s->position[i] - point[i] : uniform(seed, -1, 1);
        }
        if (!algsurf_unit(facing, facing)) facing[0] = 1;
        for (int i = 0; i < 3; i++) s->starts.facing[i][p] = facing[i];
        s->starts.number[p] = exact_random_int(seed, 16);
        s->starts.across[p] = exact_random_int(seed, 65536) * 65536.0;
        s->starts.up[p] = exact_random_int(seed, 65536) * 65536.0;
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
    set_forms(s);
}

/* What a kernel says of all points: of the light as a whole, of each ray to it and around. */
typedef struct answers {
    uint8_t how[POINTS], to_light[PLACES][POINTS], around[RAYS_AROUND][POINTS];
} answers;

static void ask_rays(test_scene *s, const algsurf_i_shadow_kernel *code, const algsurf_i_shadow_job *job,
                     int ray, uint8_t *state) {
    static algsurf_i_undecided undecided;
    static algsurf_i_solids solids;
    static const uint8_t how[POINTS] = {ALGSURF_I_UNKNOWN};
    double seen[POINTS] = {0};
    undecided.count = 0;
    for (int p = 0; p < POINTS; p++) s->starts.seen[p] = seen + p;
    code->expand(job, &s->starts, &solids);
    code->see_rays(job, &s->starts, &solids, how, ray, 1, &undecided);
    for (int p = 0; p < POINTS; p++) state[p] = seen[p] > 0 ? ALGSURF_LANE_MISS : ALGSURF_LANE_HIT;
    for (int i = 0; i < undecided.count; i++) {
        assert_int_equal(state[undecided.start[i]], ALGSURF_LANE_HIT);
        state[undecided.start[i]] = ALGSURF_LANE_UNDECIDED;
    }
}

static void ask(test_scene *s, const algsurf_i_shadow_kernel *code, answers *a) {
    memset(a, 0, sizeof *a);
    code->see_light(&s->job, &s->starts, a->how);
    for (int j = 0; j < PLACES; j++) ask_rays(s, code, &s->job, j, a->to_light[j]);
    for (int j = 0; j < RAYS_AROUND; j++) ask_rays(s, code, &s->around, j, a->around[j]);
}

static algsurf_ray ray_to(const test_scene *s, int p, int place) {
    algsurf_ray ray = {.t_min = 0, .t_max = 1};
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = s->starts.at[i][p];
        ray.direction[i] = s->place[i][place] - s->starts.at[i][p];
    }
    return ray;
}

/* Ray j of a point. */
static algsurf_ray ray_of(const test_scene *s, const algsurf_i_shadow_job *job, int p, int j) {
    algsurf_ray ray = {.t_min = 0, .t_max = 1};
    lanes direction[3];
    start_packet start;
    load_starts(&s->starts, p, &start);
    aim(job, &start, j, direction);
    for (int i = 0; i < 3; i++) ray.origin[i] = s->starts.at[i][p], ray.direction[i] = direction[i][0];
    return ray;
}

static double height_of_ray(const test_scene *s, int p, const algsurf_ray *ray) {
    double height = 0;
    for (int i = 0; i < 3; i++) height += ray->direction[i] * s->starts.facing[i][p];
    return height;
}

static void tell_ray(const test_scene *s, const algsurf_ray *ray, long turn) {
    fprintf(stderr, "scene %ld (seed %#llx): degree %d, %s\n", turn, (unsigned long long)first_seed,
            s->degree, s->extent.kind == ALGSURF_EXTENT_BOX ? "box" : "ball");
    exact_print_doubles("origin", ray->origin, 3);
    exact_print_doubles("direction", ray->direction, 3);
}

static struct { long lit, dark, free, hidden, open, around_free, around_hidden; } told;

static void check_ray(const test_scene *s, const algsurf_ray *ray, int said, long turn) {
    int truth = -1;
    assert_true(algsurf_occluded(s->surface, &s->extent, ray, NULL, &truth) >= 0);
    if (truth != said) tell_ray(s, ray, turn);
    assert_int_equal(truth, said);
}

static void check_places(const test_scene *s, const answers *a, int p, long turn) {
    const algsurf_ray middle = ray_to(s, p, 4);
    int faces = height_of_ray(s, p, &middle) > 0;
    for (int j = 0; j < PLACES; j++) {
        const algsurf_ray ray = ray_to(s, p, j);
        int state = a->to_light[j][p], above = height_of_ray(s, p, &ray) > 0;
        if (!above) assert_int_equal(state, ALGSURF_LANE_MISS);
        if (a->how[p] == ALGSURF_I_DARK) assert_true(above);
        if (!above) continue;
        if (a->how[p] == ALGSURF_I_LIT && faces) check_ray(s, &ray, ALGSURF_MISS, turn), told.lit++;
        if (a->how[p] == ALGSURF_I_DARK) check_ray(s, &ray, ALGSURF_HIT, turn), told.dark++;
        told.open += state == ALGSURF_LANE_UNDECIDED;
        if (state == ALGSURF_LANE_UNDECIDED) continue;
        check_ray(s, &ray, state == ALGSURF_LANE_MISS ? ALGSURF_MISS : ALGSURF_HIT, turn);
        *(state == ALGSURF_LANE_MISS ? &told.free : &told.hidden) += 1;
    }
}

static void check_around(const test_scene *s, const answers *a, int p, long turn) {
    for (int j = (int)turn % 4; j < RAYS_AROUND; j += 4) {
        const algsurf_ray ray = ray_of(s, &s->around, p, j);
        int state = a->around[j][p];
        told.open += state == ALGSURF_LANE_UNDECIDED;
        if (state == ALGSURF_LANE_UNDECIDED) continue;
        check_ray(s, &ray, state == ALGSURF_LANE_MISS ? ALGSURF_MISS : ALGSURF_HIT, turn);
        *(state == ALGSURF_LANE_MISS ? &told.around_free : &told.around_hidden) += 1;
    }
}

static void rays_are_what_is_said(void **state) {
    (void)state;
    uint64_t seed = first_seed;
    for (long turn = 0; turn < scene_count; turn++) {
        static test_scene s;
        static answers a, other;
        set_scene(&s, &seed, 1 + (int)(turn % MOST));
        ask(&s, &algsurf_i_shadow_baseline, &a);
        for (int i = 0; i < ALGSURF_KERNELS; i++) {
            const algsurf_i_kernel *kernel = algsurf_i_kernel_at(i);
            if (!kernel) continue;
            ask(&s, algsurf_i_shadow_kernel_for(kernel), &other);
            assert_memory_equal(&a, &other, sizeof a);
        }
        for (int p = 0; p < POINTS; p++) check_places(&s, &a, p, turn), check_around(&s, &a, p, turn);
        algsurf_surface_free(s.surface);
    }
    printf("rays: %ld lit, %ld dark with their light; %ld free, %ld hidden one by one; %ld free, %ld hidden "
           "around; %ld undecided; 0 wrong\n",
           told.lit, told.dark, told.free, told.hidden, told.around_free, told.around_hidden, told.open);
    assert_true(told.lit > scene_count && told.dark > scene_count && told.free > scene_count &&
                told.hidden > scene_count && told.around_free > scene_count &&
                told.around_hidden > scene_count &&
                told.open * 20 < told.free + told.hidden + told.around_free + told.around_hidden);
}

/* A power of two brings the coefficients along a ray to those that the library scales. */
static void scale(mpq_t a, const test_scene *s, const exact_line *line) {
    long shift = line->shift - s->surface->scale;
    if (shift > 0)
        mpq_div_2exp(a, a, (mp_bitcnt_t)shift);
    else
        mpq_mul_2exp(a, a, (mp_bitcnt_t)-shift);
}

/* A point's fan. */
typedef struct test_fan {
    double part, error[2], r[ALGSURF_I_SOLID(MOST)];
} test_fan;

static int fan_of(const test_scene *s, int p, test_fan *f) {
    start_packet start;
    fan_packet g;
    lanes r[ALGSURF_I_SOLID(MOST)], *line[FAN_DEGREE + 1][FAN_DEGREE + 1], error[2];
    load_starts(&s->starts, p, &start);
    begin_fans(&s->job, start.at, less(numbered(), all_lanes(1)), &g);
    expand_solid(&s->fan, &g, r, line, s->degree);
    set_errors(&s->fan, &g, error, s->degree);
    f->part = g.part[0];
    for (int k = 0; k < 2; k++) f->error[k] = error[k][0];
    for (int i = 0; i < ALGSURF_I_SOLID(s->degree); i++) f->r[i] = r[i][0];
    return bits(g.open) & 1;
}

/* |fan - P| over the fan's error, at part t of its segment to a place. */
static double share_of_error(const test_scene *s, const test_fan *fan, int p, int place, double t) {
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
    scale(row, s, &line);
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
        test_fan fan;
        set_scene(&s, &seed, 1 + (int)(turn % ALGSURF_MAX_FAN_DEGREE));
        for (int p = 0; p < POINTS; p += 2) {
            if (!fan_of(&s, p, &fan)) continue;
            double t = exact_random_int(&seed, 4) ? uniform(&seed, 0, 1) : exact_random_int(&seed, 2);
            int place = exact_random_int(&seed, PLACES);
            double share = share_of_error(&s, &fan, p, place, t);
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

/* The coefficients of one ray, as the lanes have them, and which part of it they are for. */
typedef struct test_coefficients {
    double part, gap, error, c[MOST + 1];
    int known;
} test_coefficients;

static void coefficients_of(const test_scene *s, const algsurf_i_shadow_job *job, int p, int j,
                            test_coefficients *t) {
    start_packet start;
    solid_packet solid;
    ray_packet k = {
        .kind = job->light ? TO_LIGHTS : AROUND, .open = less(numbered(), all_lanes(1)), .hit = no_lane()};
    lanes direction[3], c[TAYLOR_DEGREE + 1];
    load_starts(&s->starts, p, &start);
    begin_solids(job, &start, &solid);
    aim(job, &start, j, direction);
    t->part = cut_rays(job, &solid, direction, &k)[0];
    expand_rays_n(&solid, k.d, c, s->degree);
    t->gap = k.gap[0];
    t->error = solid.error[k.kind][0], t->known = bits(solid.known) & 1;
    for (int i = 0; i <= s->degree; i++) t->c[i] = c[i][0];
}

/* The largest |c - b| over their bound, b the exact Bernstein coefficients with the sign of the first one. */
static double share_of_bound(const test_scene *s, const algsurf_ray *ray, const test_coefficients *t) {
    exact_line line = exact_line_of(s->terms, s->count, s->degree, ray);
    int n = s->degree;
    double worst = 0;
    mpq_t b, term, power, w;
    mpz_t choose;
    mpq_inits(b, term, power, w, NULL), mpz_init(choose);
    int side = mpz_sgn(line.c[0]) < 0 ? -1 : 1;
    for (int k = 0; k <= n; k++) {
        mpq_set_ui(b, 0, 1), mpq_set_si(power, side, 1);
        for (int m = 0; m <= k; m++) { /* b_k = sum (k over m) / (n over m) c_m */
            mpq_set_z(term, line.c[m]), mpq_mul(term, term, power);
            mpz_bin_uiui(choose, (unsigned long)k, (unsigned long)m);
            mpq_set_z(w, choose), mpq_mul(term, term, w);
            mpz_bin_uiui(choose, (unsigned long)n, (unsigned long)m);
            mpq_set_z(w, choose), mpq_div(term, term, w);
            mpq_add(b, b, term);
            exact_set(w, t->part), mpq_mul(power, power, w);
        }
        scale(b, s, &line);
        exact_set(w, t->c[k]), mpq_sub(b, b, w), mpq_abs(b, b);
        worst = fmax(worst, mpq_get_d(b) / t->error);
    }
    mpq_clears(b, term, power, w, NULL), mpz_clear(choose);
    exact_line_clear(&line);
    return worst;
}

/* Where P's sign at a point is said to be known: else an error may be twice what P is. */
static void rays_keep_their_bound(void **state) {
    (void)state;
    uint64_t seed = first_seed;
    double worst = 0;
    long count = 0, unknown = 0;
    for (long turn = 0; turn < scene_count; turn++) {
        static test_scene s;
        set_scene(&s, &seed, 1 + (int)(turn % MOST));
        for (int p = 0; p < POINTS; p += 3) {
            const algsurf_i_shadow_job *job = p % 2 ? &s.job : &s.around;
            test_coefficients t;
            int j = exact_random_int(&seed, p % 2 ? PLACES : RAYS_AROUND);
            const algsurf_ray ray = ray_of(&s, job, p, j);
            coefficients_of(&s, job, p, j, &t);
            unknown += !t.known;
            if (!t.known || algsurf_max_abs(ray.direction) == 0) continue;
            double share = share_of_bound(&s, &ray, &t);
            if (!(share <= 1)) {
                tell_ray(&s, &ray, turn);
                fprintf(stderr, "%g of the bound\n", share);
            }
            assert_true(share <= 1);
            worst = fmax(worst, share);
            count++;
        }
        algsurf_surface_free(s.surface);
    }
    printf(
        "single rays: %ld, %ld more from where P's sign is not known; the worst error is %.3g of its bound\n",
        count, unknown, worst);
    assert_true(worst > 0x1p-8 && unknown * 10 < count);
}

/* ---- where rays end ---- */

/* Is the exact point at + t d within the extent? */
static int is_within(const test_scene *s, const algsurf_ray *ray, const mpq_t t) {
    mpq_t x, y, square;
    int inside = 1;
    mpq_inits(x, y, square, NULL);
    for (int i = 0; i < 3; i++) {
        exact_set(x, ray->direction[i]), mpq_mul(x, x, t);
        exact_set(y, ray->origin[i]), mpq_add(x, x, y);
        exact_set(y, s->extent.centre[i]), mpq_sub(x, x, y);
        mpq_abs(y, x), mpq_mul(x, x, x), mpq_add(square, square, x);
        exact_set(x, s->extent.size[i]);
        if (s->extent.kind == ALGSURF_EXTENT_BOX) inside = inside && mpq_cmp(y, x) <= 0;
    }
    exact_set(x, s->radius), mpq_mul(x, x, x);
    if (s->extent.kind == ALGSURF_EXTENT_SPHERE) inside = mpq_cmp(square, x) <= 0;
    mpq_clears(x, y, square, NULL);
    return inside;
}

/* Some points lie a little below the extent's surface. */
static void move_outward(test_scene *s, uint64_t *seed, int p) {
    double size = 0, depth = ldexp(uniform(seed, 1, 2), -exact_random_int(seed, 34));
    for (int i = 0; i < 3; i++) {
        double from_centre = s->starts.at[i][p] - s->extent.centre[i];
        size = s->extent.kind == ALGSURF_EXTENT_BOX ? fmax(size, fabs(from_centre) / s->extent.size[i])
                                                    : hypot(size, from_centre / s->radius);
    }
    for (int i = 0; i < 3 && size > 0; i++)
        s->starts.at[i][p] =
            s->extent.centre[i] + (s->starts.at[i][p] - s->extent.centre[i]) / size * fmax(1 - depth, 0.1);
}

/* What is searched of a ray ends outside the extent, or is all of it; but for `gap` of it, it is inside. */
static void rays_end_with_the_extent(void **state) {
    (void)state;
    uint64_t seed = first_seed;
    long cut = 0, whole = 0, unknown = 0;
    double widest = 0;
    mpq_t t, gap;
    mpq_inits(t, gap, NULL);
    for (long turn = 0; turn < scene_count; turn++) {
        static test_scene s;
        set_scene(&s, &seed, 1 + (int)(turn % 3));
        for (int p = 0; p < POINTS; p += 3) {
            const algsurf_i_shadow_job *job = p % 2 ? &s.job : &s.around;
            test_coefficients c;
            if (exact_random_int(&seed, 2)) move_outward(&s, &seed, p);
            int j = exact_random_int(&seed, p % 2 ? PLACES : RAYS_AROUND);
            const algsurf_ray ray = ray_of(&s, job, p, j);
            coefficients_of(&s, job, p, j, &c);
            if (algsurf_max_abs(ray.direction) == 0) continue;
            exact_set(t, c.part), exact_set(gap, 1 - c.gap);
            int ends = c.part == 1 || !is_within(&s, &ray, t);
            mpq_mul(t, t, gap);
            int begins = c.gap >= 1 || is_within(&s, &ray, t);
            if (!ends || !begins)
                tell_ray(&s, &ray, turn), fprintf(stderr, "part %a, gap %a\n", c.part, c.gap);
            assert_true(ends && begins);
            unknown += c.gap >= 1, cut += c.part < 1, whole += c.part == 1;
            if (c.gap < 1) widest = fmax(widest, c.gap);
        }
        algsurf_surface_free(s.surface);
    }
    mpq_clears(t, gap, NULL);
    printf("ends: %ld rays leave the extent, %ld end inside, %ld are not known to begin inside; gaps up to "
           "%.3g\n",
           cut, whole, unknown, widest);
    assert_true(cut > whole / 4 && whole > cut / 8 && unknown * 2 < cut);
}

/* ---- pictures ---- */

static int nothing_known;

const algsurf_i_shadow_kernel *__real_algsurf_i_shadow_kernel_for(const algsurf_i_kernel *kernel);
const algsurf_i_shadow_kernel *__wrap_algsurf_i_shadow_kernel_for(const algsurf_i_kernel *kernel);

static void see_light_unknown(const algsurf_i_shadow_job *job, const algsurf_i_starts *starts, uint8_t *how) {
    algsurf_i_shadow_job unknown = *job;
    unknown.fan = NULL;
    algsurf_i_shadow_baseline.see_light(&unknown, starts, how);
}

static void see_rays_unknown(const algsurf_i_shadow_job *job, const algsurf_i_starts *starts,
                             const algsurf_i_solids *solids, const uint8_t *how, int from, int rays,
                             algsurf_i_undecided *undecided) {
    (void)solids;
    algsurf_i_shadow_baseline.see_rays(job, starts, NULL, how, from, rays, undecided);
}

const algsurf_i_shadow_kernel *__wrap_algsurf_i_shadow_kernel_for(const algsurf_i_kernel *kernel) {
    static algsurf_i_shadow_kernel without;
    without = *__real_algsurf_i_shadow_kernel_for(kernel);
    without.see_light = see_light_unknown;
    without.see_rays = see_rays_unknown;
    return nothing_known ? &without : __real_algsurf_i_shadow_kernel_for(kernel);
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
    nothing_known = without;
    assert_int_equal(algsurf_render(scene, &size, &picture, &to->stats), ALGSURF_OK);
    nothing_known = 0;
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
    static const char *const names[] = {"sphere", "whitney", "steiner", "chair",  "tangle",
                                        "boy",    "barth",   "labs",    "chmutov"};
    (void)state;
    uint64_t seed = first_seed, rays = 0, left = 0;
    for (int n = 0; n < 9; n++)
        for (int which = 0; which < 4; which++) {
            static image fans, alone;
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
            rays += alone.stats.shadow_rays, left += fans.stats.shadow_rays;
            algsurf_scene_free(scene);
            algsurf_surface_free(surface);
        }
    printf("pictures: of %llu rays %llu were shot\n", (unsigned long long)rays, (unsigned long long)left);
    assert_true(left * 20 < rays);
}

int main(int argc, char **argv) {
    if (argc > 1) scene_count = atol(argv[1]);
    if (argc > 2) first_seed = strtoull(argv[2], NULL, 0);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fans_keep_their_bound), cmocka_unit_test(rays_keep_their_bound),
        cmocka_unit_test(rays_end_with_the_extent), cmocka_unit_test(rays_are_what_is_said),
        cmocka_unit_test(pictures_are_those_of_rays)};
    return cmocka_run_group_tests_name("fans", tests, NULL, NULL);
}
