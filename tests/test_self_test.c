/* test_self_test.c - algsurf_self_test finds this build sound, in any environment of the caller's, and finds
 * fault with each operation that rounds as it should not, and with each kernel that gives other bits.
 *
 * Wrong operations are handed to the function that judges them.  Wrong kernels come in by the linker
 * (-Wl,--wrap), which replaces the tables of the rooms: each entry in turn does what it should and then
 * changes a last bit, in kernels other than the plain one. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "algsurf/algsurf.h"
#include "base/fpenv.h"
#include "base/rounding.h"
#include "complex/boxes.h"
#include "environments.h"
#include "beams/kernels.h"
#include "picture/colours.h"
#include "rays/packets.h"
#include "roots/polys.h"
#include "simd/operations.h"
#include "unit.h"

/* ---- operations ---- */

static double upward(double x) { return nextafter(x, HUGE_VAL); }
static double flushed(double x) { return fabs(x) < DBL_MIN ? 0 : x; }

static double sum_up(double a, double b) { return a + b == a ? upward(a) : a + b; }
static double sum_down(double a, double b) { return b > 0 && (a + b) - a > b ? a : a + b; }
static double sum_flushed(double a, double b) { return flushed(a + b); }
static double sum_of_flushed(double a, double b) { return flushed(a) + flushed(b); }
static double sum_twice_rounded(double a, double b) { return a + (double)(float)b; }
static double product_flushed(double a, double b) { return flushed(a * b); }
static double product_of_flushed(double a, double b) { return flushed(a) * flushed(b); }
static double quotient_by_reciprocal(double a, double b) { return a * (1 / b); }
static double quotient_flushed(double a, double b) { return flushed(a / b); }
static double root_approximate(double a) { return (double)sqrtf((float)a); }
static double root_of_flushed(double a) { return sqrt(flushed(a)); }
static double contracted(double a, double b, double c) { return fma(a, b, c); }
static double apart(double a, double b, double c) {
    volatile double product = a * b;
    return product + c;
}
static algsurf_dd sum_without_rest(double a, double b) { return algsurf_dd_from(a + b); }
static algsurf_dd product_without_rest(double a, double b) { return algsurf_dd_from(a * b); }
static algsurf_dd product_with_half_a_rest(double a, double b) {
    algsurf_dd p = algsurf_two_prod(a, b);
    return (algsurf_dd){p.hi, 0.5 * p.lo};
}

#define WRONG(member, function)                                                                              \
    {                                                                                                        \
        algsurf_i_operations o = algsurf_i_operations_plain;                                                 \
        o.member = function;                                                                                 \
        if (algsurf_i_rounds(&o)) fail_msg("%s passes as a %s", #function, #member);                         \
    }

TEST(wrong_operations_are_found) {
    assert_true(algsurf_i_rounds(&algsurf_i_operations_plain));
    WRONG(sum, sum_up)
    WRONG(sum, sum_down)
    WRONG(sum, sum_flushed)
    WRONG(sum, sum_of_flushed)
    WRONG(sum, sum_twice_rounded)
    WRONG(product, product_flushed)
    WRONG(product, product_of_flushed)
    WRONG(quotient, quotient_by_reciprocal)
    WRONG(quotient, quotient_flushed)
    WRONG(root, root_approximate)
    WRONG(root, root_of_flushed)
    WRONG(product_and_sum, contracted)
    WRONG(fused, apart)
    WRONG(two_sum, sum_without_rest)
    WRONG(two_product, product_without_rest)
    WRONG(two_product, product_with_half_a_rest)
}

/* The operations of each kernel, in the environment that is set: the usual one alone will do. */
TEST(wrong_environments_are_found) {
    for (int e = 0; e < ENVIRONMENTS; e++) {
        const algsurf_i_kernel *kernel;
        environment_set(e);
        int usual = environment_flushes(1) || fegetround() != FE_TONEAREST ? 0 : 1;
        int plain = algsurf_i_rounds(&algsurf_i_operations_plain), lanes = 0, kernels = 0;
        for (; (kernel = algsurf_i_kernel_at(kernels)); kernels++)
            lanes += algsurf_i_rounds(algsurf_i_operations_of(kernel));
        environment_set(0);
        if (plain != usual || lanes != usual * kernels) fail_msg("environment %d: %d, %d", e, plain, lanes);
    }
}

/* ---- kernels ---- */

enum part {
    NONE,
    FIRST_ROOTS,
    ALL_ROOTS,
    COMPLEX_ROOTS,
    ONE_COMPLEX,
    HITS,
    STATES,
    ONE_RAY,
    PIXELS,
    TILES,
    SHEETS,
    POINTS,
    COLOURS,
    STARTS,
    SHADOW_RAYS,
    COMPLEX_ROW,
    COMPLEX_POINTS,
    PARTS
};

static enum part broken;

static double other(double x) { return nextafter(x, 0); }

#define TABLE(name)                                                                                          \
    const algsurf_i_##name##_kernel *__real_algsurf_i_##name##_kernel_for(const algsurf_i_kernel *kernel);   \
    const algsurf_i_##name##_kernel *__wrap_algsurf_i_##name##_kernel_for(const algsurf_i_kernel *kernel);   \
    static const algsurf_i_##name##_kernel *real_##name;                                                     \
    static algsurf_i_##name##_kernel wrong_##name;                                                           \
    const algsurf_i_##name##_kernel *__wrap_algsurf_i_##name##_kernel_for(const algsurf_i_kernel *kernel) {  \
        const algsurf_i_##name##_kernel *found = __real_algsurf_i_##name##_kernel_for(kernel);               \
        if (kernel->index == ALGSURF_BASELINE) return found;                                                 \
        real_##name = found;                                                                                 \
        wrong_##name = *found;                                                                               \
        break_##name();                                                                                      \
        return &wrong_##name;                                                                                \
    }

static void break_roots(void);
TABLE(roots)

static int wrong_first(const algsurf_i_polys_job *job) {
    int undecided = real_roots->solve(job);
    for (size_t i = 0; i < job->p.count; i++) job->root[i] = other(job->root[i]);
    return undecided;
}

static void wrong_all(const algsurf_i_polys_job *job) {
    real_roots->solve_all(job);
    for (size_t i = 0; i < job->p.count; i++) {
        algsurf_real_root *first = job->roots + i * (size_t)job->p.degree;
        if (job->found[i] > 0) first->root = other(first->root);
    }
}

static void break_roots(void) {
    if (broken == FIRST_ROOTS) wrong_roots.solve = wrong_first;
    if (broken == ALL_ROOTS) wrong_roots.solve_all = wrong_all;
}

static void break_allroots(void);
TABLE(allroots)

static int wrong_one(const double *re, const double *im, int stride, int n, algsurf_complex_root *roots) {
    int solved = real_allroots->one(re, im, stride, n, roots);
    roots[0].root.re = other(roots[0].root.re);
    return solved;
}

static void wrong_many(const algsurf_table *re, const algsurf_table *im, int n, size_t count,
                       algsurf_complex_root *roots, int *found) {
    real_allroots->many(re, im, n, count, roots, found);
    for (size_t i = 0; i < count; i++) roots[i * (size_t)n].box.re.lo = other(roots[i * (size_t)n].box.re.lo);
}

static void break_allroots(void) {
    if (broken == COMPLEX_ROOTS) wrong_allroots.many = wrong_many;
    if (broken == ONE_COMPLEX) wrong_allroots.one = wrong_one;
}

static void break_rays(void);
TABLE(rays)

static void wrong_solve(const algsurf_i_rays_job *job, const algsurf_hit_packet *hits) {
    real_rays->solve(job, hits);
    for (size_t i = 0; i < job->rays->count; i++) {
        if (job->any)
            hits->state[i] = broken == STATES ? ALGSURF_LANE_HIT : hits->state[i];
        else if (broken == HITS && hits->state[i] == ALGSURF_LANE_HIT)
            hits->t[i] = other(hits->t[i]);
    }
}

static void break_rays(void) {
    if (broken == HITS || broken == STATES) wrong_rays.solve = wrong_solve;
}

static void break_ray(void);
TABLE(ray)

static int wrong_ray_all(const algsurf_i_rays_job *job, const algsurf_refine_options *how, int most,
                         algsurf_hit *hits) {
    int count = real_ray->all(job, how, most, hits);
    for (int i = 0; i < count && !job->any; i++) hits[i].t = other(hits[i].t);
    return count;
}

static void break_ray(void) {
    if (broken == ONE_RAY) wrong_ray.all = wrong_ray_all;
}

static void break_beams(void);
TABLE(beams)

static void wrong_pixels(const algsurf_i_row_job *job, const algsurf_i_pixels *pixels, double *depth,
                         uint8_t *state, algsurf_i_dips *dips) {
    real_beams->solve_pixels(job, pixels, depth, state, dips);
    for (int i = 0; i < pixels->count; i++)
        if (state[i] == ALGSURF_LANE_HIT) state[i] = ALGSURF_LANE_MISS;
}

static void wrong_tiles(algsurf_i_tile_job *job) {
    int before = job->tile_count;
    real_beams->search_tiles(job);
    for (int i = before; i < job->tile_count; i++) job->tiles[i].enough = 0, job->tiles[i].low = 1;
}

static int wrong_points(const algsurf_i_point_job *job, const int *pixel, const double *depth, int count,
                        const algsurf_i_sheets *sheets, uint8_t *sure, const algsurf_i_points *points) {
    int all = real_beams->points(job, pixel, depth, count, sheets, sure, points);
    for (int i = 0; i < count && !sheets == (broken == POINTS); i++) points->t[i] = other(points->t[i]);
    return all;
}

static uint64_t wrong_complex(const algsurf_i_complex_job *job, int begin, int end) {
    uint64_t corrections = real_beams->solve_complex(job, begin, end);
    for (int x = begin; x < end; x++)
        if (job->state[x] == ALGSURF_LANE_HIT) job->state[x] = ALGSURF_LANE_MISS;
    return corrections;
}

static int wrong_complex_points(const algsurf_i_complex_job *job, const algsurf_surface *surface,
                                const int *pixel, const double *re, const double *im, int count,
                                uint8_t *sure, const algsurf_i_points *points) {
    int all = real_beams->complex_points(job, surface, pixel, re, im, count, sure, points);
    for (int i = 0; i < count; i++) points->t[i] = other(points->t[i]);
    return all;
}

static void wrong_starts(const algsurf_i_points *points, int first, int count, double height,
                         algsurf_i_starts *starts) {
    real_beams->lift(points, first, count, height, starts);
    for (int i = 0; i < count; i++) starts->facing[2][i] = -starts->facing[2][i];
}

static void wrong_shadow_rays(const algsurf_i_shadow_job *job, const algsurf_i_starts *starts,
                              const algsurf_i_solids *solids, int from, int rays,
                              algsurf_i_undecided *undecided) {
    real_beams->see_rays(job, starts, solids, from, rays, undecided);
    for (int i = 0; i < starts->count; i++) *starts->seen[i] *= 0.5;
}

static void break_beams(void) {
    if (broken == PIXELS) wrong_beams.solve_pixels = wrong_pixels;
    if (broken == TILES) wrong_beams.search_tiles = wrong_tiles;
    if (broken == SHEETS || broken == POINTS) wrong_beams.points = wrong_points;
    if (broken == COMPLEX_ROW) wrong_beams.solve_complex = wrong_complex;
    if (broken == COMPLEX_POINTS) wrong_beams.complex_points = wrong_complex_points;
    if (broken == STARTS) wrong_beams.lift = wrong_starts;
    if (broken == SHADOW_RAYS) wrong_beams.see_rays = wrong_shadow_rays;
}

static void break_colour(void);
TABLE(colour)

static void wrong_colours(const algsurf_i_colour_job *job, const algsurf_i_looks *looks, int count,
                          const double *visible, float *colour, uint32_t *bytes) {
    real_colour->colours(job, looks, count, visible, colour, bytes);
    for (int i = 0; colour && i < 3 * count; i++) colour[i] *= 0.98f;
    for (int i = 0; bytes && i < count; i++) bytes[i] ^= 8;
}

static void break_colour(void) {
    if (broken == COLOURS) wrong_colour.colours = wrong_colours;
}

TEST(wrong_kernels_are_found) {
    if (!algsurf_kernel_name(1)) skip(); /* the plain kernel is the only one */
    for (int part = NONE + 1; part < PARTS; part++) {
        broken = (enum part)part;
        algsurf_status status = algsurf_self_test();
        broken = NONE;
        if (status != ALGSURF_E_BUILD) fail_msg("part %d: %s", part, algsurf_status_name(status));
    }
}

/* ---- this build ---- */

static double seconds(void) {
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

TEST(this_build_is_sound) {
    double best = HUGE_VAL;
    for (int e = 0; e < 3 * ENVIRONMENTS; e++) {
        double begin = seconds();
        environment_set(e % ENVIRONMENTS);
        algsurf_status status = algsurf_self_test();
        int kept = environment_unset(e % ENVIRONMENTS);
        best = fmin(best, seconds() - begin);
        assert_ok(status);
        assert_true(kept);
    }
    print_message("%.0f microseconds\n", 1e6 * best);
}
