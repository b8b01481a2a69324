/* test_ray_sphere.c - the chord of a ray and a sphere, against the exact ends.
 *
 * Breaks tried, each caught by the test named:
 *   an end taken at t_c, or for the other                                   sphere_far
 *   the quadratic about the origin (t_c = 0), or X without its low part      sphere_very_far
 *   no double-double discriminant near a tangency                           sphere_grazing
 *   lengths or directions not scaled                                        sphere_scales
 */
#include <fenv.h>

#include "ray_case.h"

#define PRECISION 9000 /* bits: exponents spread over 2000 are squared twice */

static void init(mpf_t *x, int n) {
    for (int i = 0; i < n; i++) mpf_init2(x[i], PRECISION);
}
static void clear(mpf_t *x, int n) {
    for (int i = 0; i < n; i++) mpf_clear(x[i]);
}

/* sum a_i b_i */
static void dot(mpf_t out, mpf_t *a, mpf_t *b) {
    mpf_t p;
    mpf_init2(p, PRECISION);
    mpf_set_ui(out, 0);
    for (int i = 0; i < 3; i++) mpf_mul(p, a[i], b[i]), mpf_add(out, out, p);
    mpf_clear(p);
}

/* The exact parameters where the line meets the sphere, and what an error of one unit in the last
 * place of the distance to the far side, 2^-53 (|q| + r), is worth in t.  Returns the sign of the
 * discriminant, 0 when it is too small to be asked for. */
static int sphere_exact(const algsurf_extent *e, const algsurf_ray *r, mpf_t t[2], mpf_t unit) {
    mpf_t q[3], d[3], v[6];
    init(q, 3), init(d, 3), init(v, 6);
    for (int i = 0; i < 3; i++) {
        mpf_set_d(q[i], r->origin[i]), mpf_set_d(v[0], e->centre[i]), mpf_sub(q[i], q[i], v[0]);
        mpf_set_d(d[i], r->direction[i]);
    }
    dot(v[0], d, d), dot(v[1], q, d), dot(v[2], q, q);      /* a, b, |q|^2 */
    mpf_set_d(v[3], e->size[0]), mpf_mul(v[4], v[3], v[3]); /* r, r^2 */
    mpf_sqrt(unit, v[2]), mpf_add(unit, unit, v[3]);        /* |q| + r */
    mpf_sqrt(v[5], v[0]), mpf_div(unit, unit, v[5]), mpf_div_2exp(unit, unit, 53);
    mpf_mul(v[5], v[0], v[4]); /* a r^2 */
    mpf_sub(v[2], v[2], v[4]), mpf_mul(v[2], v[2], v[0]), mpf_mul(v[4], v[1], v[1]),
        mpf_sub(v[2], v[4], v[2]);
    mpf_div_2exp(v[5], v[5], 85);
    int sign = mpf_sgn(v[2]);
    mpf_abs(v[4], v[2]);
    if (mpf_cmp(v[4], v[5]) < 0) sign = 0;
    if (sign > 0) {
        mpf_sqrt(v[2], v[2]), mpf_neg(v[1], v[1]);
        mpf_sub(t[0], v[1], v[2]), mpf_div(t[0], t[0], v[0]);
        mpf_add(t[1], v[1], v[2]), mpf_div(t[1], t[1], v[0]);
    }
    clear(q, 3), clear(d, 3), clear(v, 6);
    return sign;
}

/* Compares a clip of the whole line with the exact ends; returns 1 when it met. */
static int check_sphere(const algsurf_extent *e, const algsurf_ray *r, double allowed) {
    algsurf_ray chord;
    int meets = -1;
    mpf_t t[2], unit, error;
    init(t, 2), mpf_init2(unit, PRECISION), mpf_init2(error, PRECISION);
    assert_ok(algsurf_extent_clip(e, r, &chord, &meets));
    int sign = sphere_exact(e, r, t, unit);
    if (sign != 0 && meets != (sign > 0)) {
        print_case(e, r, NULL);
        fail_msg("meets %d, exact sign %d", meets, sign);
    }
    for (int i = 0; i < 2 && sign > 0; i++) {
        double got[2] = {chord.t_min, chord.t_max};
        mpf_set_d(error, got[i]), mpf_sub(error, error, t[i]), mpf_div(error, error, unit);
        if (fabs(mpf_get_d(error)) > allowed) {
            print_case(e, r, got);
            fail_msg("end %d off by %g units", i, mpf_get_d(error));
        }
    }
    clear(t, 2), mpf_clear(unit), mpf_clear(error);
    return meets;
}

/* A ray of the whole line from `distance` radii that passes the centre at `miss` radii. */
static algsurf_ray random_ray(uint64_t *seed, const algsurf_extent *e, double distance, double miss) {
    double w[3], side[3], norm = 0, along = 0, side_norm = 0, r = e->size[0];
    algsurf_ray ray = {.t_min = -INFINITY, .t_max = INFINITY};
    for (int i = 0; i < 3; i++) {
        w[i] = exact_random_unit(seed), side[i] = exact_random_unit(seed);
        norm += w[i] * w[i], along += w[i] * side[i];
    }
    for (int i = 0; i < 3; i++) side[i] -= along / norm * w[i], side_norm += side[i] * side[i];
    for (int i = 0; i < 3; i++) {
        w[i] /= sqrt(norm), side[i] /= sqrt(side_norm);
        ray.origin[i] = e->centre[i] + r * (distance * w[i] + miss * side[i]);
        ray.direction[i] = -w[i] * (1.0 + 0.25 * distance / (1 + distance));
    }
    return ray;
}

TEST(sphere_far) {
    uint64_t seed = 11;
    int met = 0;
    for (int k = 0; k < 900; k++) {
        algsurf_extent e = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1.5, 0, 0}};
        for (int i = 0; i < 3; i++) e.centre[i] = k % 2 ? 10 * exact_random_unit(&seed) : 0;
        algsurf_ray r = random_ray(&seed, &e, pow(10, k % 9), fabs(1.3 * exact_random_unit(&seed)));
        met += check_sphere(&e, &r, 12);
    }
    assert_in_range(met, 500, 800);
}

/* Origins so far away that the sphere is smaller than the spacing of doubles there: hit or miss is still
 * decided for the exact line. */
TEST(sphere_very_far) {
    uint64_t seed = 15;
    int met = 0;
    for (int k = 0; k < 300; k++) {
        algsurf_extent e = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
        algsurf_ray r = {.t_min = -INFINITY, .t_max = INFINITY};
        for (int i = 0; i < 3; i++) {
            e.centre[i] = 1.5 * exact_random_unit(&seed);
            r.direction[i] = exact_random_unit(&seed);
            r.origin[i] = -ldexp(r.direction[i], 20 + k % 60); /* the line goes through 0 exactly */
        }
        met += check_sphere(&e, &r, 12);
    }
    assert_in_range(met, 80, 220);
}

/* Rays that pass at 1 - 2^-k radii: the chord is short, its ends are as good. */
TEST(sphere_grazing) {
    uint64_t seed = 12;
    int met = 0;
    for (int k = 0; k < 900; k++) {
        algsurf_extent e = {ALGSURF_EXTENT_SPHERE, {0.3, -0.2, 0.1}, {1, 0, 0}};
        double gap = ldexp(1, -(k % 50) - 1);
        algsurf_ray r = random_ray(&seed, &e, pow(10, k % 4), k % 8 ? 1 - gap : 1 + gap);
        met += check_sphere(&e, &r, 12);
    }
    assert_in_range(met, 650, 850);
}

TEST(sphere_inside) {
    uint64_t seed = 13;
    for (int k = 0; k < 300; k++) {
        algsurf_extent e = {ALGSURF_EXTENT_SPHERE, {1, 2, 3}, {2, 0, 0}};
        algsurf_ray r = random_ray(&seed, &e, 0.9 * exact_random_unit(&seed), 0.4);
        assert_int_equal(check_sphere(&e, &r, 12), 1);
    }
}

/* The same picture at any scale of lengths and of directions. */
TEST(sphere_scales) {
    uint64_t seed = 14;
    int met = 0;
    for (int k = 0; k < 120; k++) {
        int length = exact_random_int(&seed, 1990) - 995, direction = exact_random_int(&seed, 1990) - 995;
        algsurf_extent e = {ALGSURF_EXTENT_SPHERE, {0.5, -0.25, 0.125}, {1, 0, 0}};
        algsurf_ray r = random_ray(&seed, &e, 5, fabs(1.2 * exact_random_unit(&seed)));
        e.size[0] = ldexp(e.size[0], length);
        for (int i = 0; i < 3; i++) {
            e.centre[i] = ldexp(e.centre[i], length), r.origin[i] = ldexp(r.origin[i], length);
            r.direction[i] = ldexp(r.direction[i], direction);
        }
        if (abs(length - direction) > 1000) continue; /* t itself leaves the range of double */
        met += check_sphere(&e, &r, 12);
    }
    assert_in_range(met, 40, 120);
}

TEST(sphere_ends_of_range) {
    algsurf_ray chord;
    int meets;
    /* From 1e300 straight at a unit sphere: both ends are 1e300. */
    algsurf_extent e = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    algsurf_ray r = make_ray((double[]){1e300, 0, 0}, (double[]){-1, 0, 0}, 0, INFINITY);
    assert_ok(algsurf_extent_clip(&e, &r, &chord, &meets));
    assert_int_equal(meets, 1);
    assert_true(chord.t_min == 1e300 && chord.t_max == 1e300);
    /* The largest sphere, opposite largest centre; and the smallest of all. */
    e = (algsurf_extent){ALGSURF_EXTENT_SPHERE, {-1.7e308, 0, 0}, {1e308, 0, 0}};
    r = make_ray((double[]){1.7e308, 0, 0}, (double[]){-1e300, 0, 0}, 0, INFINITY);
    assert_ok(algsurf_extent_clip(&e, &r, &chord, &meets));
    assert_int_equal(meets, 1);
    assert_true(fabs(chord.t_min / 2.4e8 - 1) < 1e-15 && fabs(chord.t_max / 4.4e8 - 1) < 1e-15);
    e = (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {0x1p-1074, 0, 0}};
    r = make_ray((double[]){0x1p-1072, 0, 0}, (double[]){-0x1p-1074, 0, 0}, 0, INFINITY);
    assert_ok(algsurf_extent_clip(&e, &r, &chord, &meets));
    assert_int_equal(meets, 1);
    assert_true(chord.t_min == 3 && chord.t_max == 5);
    /* t would be about 1e600: no double lies on the chord. */
    e = (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    r = make_ray((double[]){1e300, 0, 0}, (double[]){-1e-300, 0, 0}, -INFINITY, INFINITY);
    assert_ok(algsurf_extent_clip(&e, &r, &chord, &meets));
    assert_int_equal(meets, 0);
}

/* The answer does not depend on the caller's rounding mode, which survives. */
TEST(rounding_modes) {
    static const int modes[3] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    uint64_t seed = 31;
    for (int k = 0; k < 200; k++) {
        algsurf_extent e = {ALGSURF_EXTENT_SPHERE, {0.1, 0.2, 0.3}, {1, 1, 1}};
        if (k % 2) e.kind = ALGSURF_EXTENT_BOX;
        algsurf_ray chord, other, r = random_ray(&seed, &e, 1e4, 0.9 * exact_random_unit(&seed));
        if (!clip(&e, &r, &chord)) continue;
        for (int m = 0; m < 3; m++) {
            int meets;
            fesetround(modes[m]);
            algsurf_status status = algsurf_extent_clip(&e, &r, &other, &meets);
            int mode = fegetround();
            fesetround(FE_TONEAREST);
            assert_ok(status);
            assert_int_equal(mode, modes[m]);
            assert_memory_equal(&chord, &other, sizeof chord);
        }
    }
}

int main(void) { return unit_run("ray: sphere"); }
