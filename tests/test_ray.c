/* test_ray.c - the chord of a ray and a box, the ray's own ends, bad input; spheres are in
 * test_ray_sphere.c.
 *
 * Breaks tried, each caught by the test named:
 *   near and far face not exchanged for d < 0; d = 0 divided by              box_*
 *   `<` for `<=` at a face, at touching ends                                box_faces, ends_kept
 *   t_max of the ray forgotten                                              ends_kept, all_of_space
 */
#include "ray_case.h"

/* The exact slabs. */
static int box_exact(const algsurf_extent *e, const algsurf_ray *r, mpq_t ends[2]) {
    mpq_t q, h, d, t;
    int bounded = 0, meets = 1;
    mpq_inits(q, h, d, t, NULL);
    for (int i = 0; i < 3; i++) {
        exact_set(q, r->origin[i]), exact_set(t, e->centre[i]), mpq_sub(q, q, t);
        exact_set(h, e->size[i]), exact_set(d, r->direction[i]);
        if (mpq_sgn(d) == 0) {
            mpq_abs(q, q);
            if (mpq_cmp(q, h) > 0) meets = 0;
            continue;
        }
        for (int side = 0; side < 2; side++) { /* side 0: the nearer face */
            if ((mpq_sgn(d) > 0) == (side == 0))
                mpq_neg(t, h);
            else
                mpq_set(t, h);
            mpq_sub(t, t, q), mpq_div(t, t, d);
            int tighter = side == 0 ? mpq_cmp(t, ends[0]) > 0 : mpq_cmp(t, ends[1]) < 0;
            if (!bounded || tighter) mpq_set(ends[side], t);
        }
        bounded = 1;
    }
    meets = meets && mpq_cmp(ends[0], ends[1]) <= 0;
    mpq_clears(q, h, d, t, NULL);
    return meets;
}

TEST(box_random) {
    uint64_t seed = 21;
    int met = 0, missed = 0;
    mpq_t ends[2], error, allowed;
    mpq_inits(ends[0], ends[1], error, allowed, NULL);
    for (int k = 0; k < 6000; k++) {
        double scale = pow(10, exact_random_int(&seed, 9));
        algsurf_extent e = {.kind = ALGSURF_EXTENT_BOX};
        algsurf_ray r = {.t_min = -INFINITY, .t_max = INFINITY}, chord;
        int meets, zero = exact_random_int(&seed, 8);
        for (int i = 0; i < 3; i++) {
            e.centre[i] = exact_random_unit(&seed), e.size[i] = 0.5 + fabs(exact_random_unit(&seed));
            double target = e.centre[i] + 1.1 * e.size[i] * exact_random_unit(&seed);
            r.direction[i] = exact_random_unit(&seed);
            if (zero == i || zero == 6 || (zero == i + 3)) r.direction[i] = zero > 2 ? -0.0 : 0.0;
            r.origin[i] = target - scale * r.direction[i];
        }
        if (zero == 6) r.direction[k % 3] = 1e-5;
        assert_ok(algsurf_extent_clip(&e, &r, &chord, &meets));
        int exact = box_exact(&e, &r, ends);
        if (meets != exact) {
            print_case(&e, &r, NULL);
            fail_msg("meets %d, exactly %d", meets, exact);
        }
        met += meets, missed += !meets;
        double got[2] = {chord.t_min, chord.t_max};
        for (int i = 0; i < 2 && meets; i++) { /* relative to the end itself: 3 roundings */
            exact_error(error, got[i], ends[i]);
            mpq_abs(allowed, ends[i]), mpq_div_2exp(allowed, allowed, 51);
            if (mpq_cmp(error, allowed) > 0) {
                print_case(&e, &r, got);
                fail_msg("end %d is off", i);
            }
        }
    }
    assert_in_range(met, 2000, 5500);
    assert_in_range(missed, 300, 4000);
    mpq_clears(ends[0], ends[1], error, allowed, NULL);
}

/* Origins and directions in the faces: they belong to the box. */
TEST(box_faces) {
    algsurf_extent e = {ALGSURF_EXTENT_BOX, {1, 2, 3}, {0.5, 0.25, 0.125}};
    algsurf_ray chord, r = make_ray((double[]){1.5, 2, 3}, (double[]){1, 0, 0}, 0, INFINITY);
    assert_int_equal(clip(&e, &r, &chord), 1); /* on a face, leaving: one point */
    assert_true(chord.t_min == 0 && chord.t_max == 0);
    r.direction[0] = -2;
    assert_int_equal(clip(&e, &r, &chord), 1); /* on a face, entering */
    assert_true(chord.t_min == 0 && chord.t_max == 0.5);
    r = make_ray((double[]){1.5, 2, 0}, (double[]){-0.0, 0.0, 1}, 0, INFINITY);
    assert_int_equal(clip(&e, &r, &chord), 1); /* along a face */
    assert_true(chord.t_min == 2.875 && chord.t_max == 3.125);
    r.origin[0] = 0.5;
    assert_int_equal(clip(&e, &r, &chord), 1); /* along the one opposite */
    r.origin[0] = nextafter(1.5, 2);
    assert_int_equal(clip(&e, &r, &chord), 0); /* beside it */
    r = make_ray((double[]){1.5, 2.25, 0}, (double[]){0, 0, -1}, -INFINITY, INFINITY);
    assert_int_equal(clip(&e, &r, &chord), 1); /* along an edge, backwards */
    assert_true(chord.t_min == -3.125 && chord.t_max == -2.875);
    r = make_ray((double[]){0, 1, 2}, (double[]){0.5, 1.25, 1.125}, 0, INFINITY);
    assert_int_equal(clip(&e, &r, &chord), 1); /* touches a corner: x enters where y and z leave */
    assert_true(chord.t_min == 1 && chord.t_max == 1);
    r.direction[0] = nextafter(0.5, 0);
    assert_int_equal(clip(&e, &r, &chord), 0); /* past it */
    /* Largest numbers: no difference overflows. */
    e = (algsurf_extent){ALGSURF_EXTENT_BOX, {-1.7e308, 0, 0}, {1e308, 1, 1}};
    r = make_ray((double[]){1.7e308, 0, 0}, (double[]){-1e300, 0, 0}, 0, INFINITY);
    assert_int_equal(clip(&e, &r, &chord), 1);
    assert_true(fabs(chord.t_min / 2.4e8 - 1) < 1e-15 && fabs(chord.t_max / 4.4e8 - 1) < 1e-15);
}

/* t_min and t_max stay, bit for bit, when they are the tighter ends; what lies behind is not met. */
TEST(ends_kept) {
    double third = 1.0 / 3;
    algsurf_extent extents[2] = {{ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}},
                                 {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}}};
    for (int k = 0; k < 2; k++) {
        const algsurf_extent *e = &extents[k];
        algsurf_ray chord, r = make_ray((double[]){-4, 0, 0}, (double[]){1, 0, 0}, 3 + third, 4 + third);
        assert_int_equal(clip(e, &r, &chord), 1);
        assert_memory_equal(&chord, &r, sizeof r);
        r.t_min = -INFINITY;
        assert_int_equal(clip(e, &r, &chord), 1);
        assert_true(chord.t_min == 3 && chord.t_max == 4 + third);
        r.t_max = 3;
        assert_int_equal(clip(e, &r, &chord), 1); /* touches: ends belong to the ray */
        assert_true(chord.t_min == 3 && chord.t_max == 3);
        r.t_max = nextafter(3, 0);
        assert_int_equal(clip(e, &r, &chord), 0);
        r.t_min = nextafter(5, 6), r.t_max = INFINITY;
        assert_int_equal(clip(e, &r, &chord), 0); /* the extent is behind t_min */
        r.t_min = 4.5, r.t_max = 4;
        assert_int_equal(clip(e, &r, &chord), 0); /* a ray without points */
        r = make_ray((double[]){-4, 0, 0}, (double[]){1, 0, 0}, 0, INFINITY);
        assert_int_equal(clip(e, &r, &r), 1); /* in place */
        assert_true(r.t_min == 3 && r.t_max == 5 && r.origin[0] == -4);
    }
}

TEST(all_of_space) {
    algsurf_extent all = {.kind = ALGSURF_EXTENT_ALL, .centre = {NAN, 0, 0}};
    algsurf_ray chord, r = make_ray((double[]){1, 2, 3}, (double[]){0, 0, 1}, -INFINITY, INFINITY);
    assert_int_equal(clip(&all, &r, &chord), 1);
    assert_memory_equal(&chord, &r, sizeof r);
    assert_int_equal(clip(NULL, &r, &chord), 1);
    assert_memory_equal(&chord, &r, sizeof r);
    r.t_min = 2, r.t_max = 1;
    assert_int_equal(clip(NULL, &r, &chord), 0);
}

static void refuse(const algsurf_extent *e, const algsurf_ray *r, algsurf_status expected) {
    algsurf_ray chord, before;
    int meets = 77;
    memset(&chord, 0x5a, sizeof chord);
    memset(&before, 0x5a, sizeof before);
    assert_int_equal(algsurf_extent_clip(e, r, &chord, &meets), expected);
    assert_int_equal(meets, 77);
    assert_memory_equal(&chord, &before, sizeof chord);
    if (!r) return;
    assert_int_equal(algsurf_extent_clip(e, r, NULL, &meets), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_extent_clip(e, r, &chord, NULL), ALGSURF_E_ARGUMENT);
    assert_memory_equal(&chord, &before, sizeof chord);
}

TEST(bad_input) {
    const algsurf_extent good = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}};
    const algsurf_ray ray = make_ray((double[]){-4, 0, 0}, (double[]){1, 0, 0}, 0, 10);
    const double bad[3] = {NAN, INFINITY, -INFINITY};
    refuse(&good, NULL, ALGSURF_E_ARGUMENT);
    algsurf_ray r = ray;
    r.direction[0] = -0.0;
    refuse(&good, &r, ALGSURF_E_ARGUMENT);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            algsurf_extent e = good;
            r = ray, r.origin[i] = bad[k];
            refuse(&good, &r, ALGSURF_E_NOT_FINITE);
            r = ray, r.direction[i] = bad[k];
            refuse(&good, &r, ALGSURF_E_NOT_FINITE);
            e.centre[i] = bad[k];
            refuse(&e, &ray, ALGSURF_E_NOT_FINITE);
            e = good, e.size[i] = bad[k];
            refuse(&e, &ray, ALGSURF_E_NOT_FINITE);
            e = good, e.size[i] = k - 1.0; /* -1, 0, and 1, which is allowed */
            if (k < 2) refuse(&e, &ray, ALGSURF_E_ARGUMENT);
        }
    r = ray, r.t_min = NAN;
    refuse(&good, &r, ALGSURF_E_ARGUMENT);
    r = ray, r.t_max = NAN;
    refuse(&good, &r, ALGSURF_E_ARGUMENT);
    algsurf_extent e = good;
    e.kind = 3;
    refuse(&e, &ray, ALGSURF_E_ARGUMENT);
    e = (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {0, 1, 1}};
    refuse(&e, &ray, ALGSURF_E_ARGUMENT);
}

int main(void) { return unit_run("ray"); }
