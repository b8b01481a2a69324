/* test_intersect.c - rays whose answers are known: ends, extents, far and odd rays, rays within the surface,
 * the largest degrees.
 *
 * Breaks caught, each tried: the exact test of an end left out, an extent ignored, a frame about a far
 * origin, a position in the surface's unit instead of the caller's, positions and gradients that overflowed,
 * a direction that underflowed, a normal made of rounding or of the wrong side of a singular point.
 */
#include "intersect_case.h"

static intersect_case c;
static intersect_answer answer;

static void set_ray(double ox, double oy, double oz, double dx, double dy, double dz, double t_min,
                    double t_max) {
    c.ray = (algsurf_ray){{ox, oy, oz}, {dx, dy, dz}, t_min, t_max};
}

/* The ray set, judged; all hits are certain and near the given t (relative to 1). */
static void expect(int count, const double *t) {
    intersect_judge(&c, NULL, &answer);
    if (answer.count != count) intersect_fail("number of hits", &c, &answer);
    for (int i = 0; i < count; i++)
        if (answer.all[i].state != ALGSURF_STATE_HIT ||
            !(fabs(answer.all[i].t - t[i]) <= 4e-16 * fmax(1, fabs(t[i]))))
            intersect_fail("t", &c, &answer);
}

static void with(const char *equation) { intersect_equation(&c, equation); }

TEST(test_closed_ends) {
    const double both[] = {1, 3};
    with("x^2 + y^2 + z^2 - 1");
    set_ray(0, 0, -2, 0, 0, 1, 1, 3), expect(2, both);
    set_ray(0, 0, -2, 0, 0, 1, 0, 3), expect(2, both);
    set_ray(0, 0, -2, 0, 0, 1, 1, 1e6), expect(2, both);
    set_ray(0, 0, -2, 0, 0, 1, 1, 1), expect(1, both);
    set_ray(0, 0, -2, 0, 0, 1, 3, 3), expect(1, both + 1);
    set_ray(0, 0, -2, 0, 0, 1, 2, 2), expect(0, NULL);
    set_ray(0, 0, -2, 0, 0, 1, nextafter(1, 2), nextafter(3, 2)), expect(0, NULL);
    set_ray(0, 0, -2, 0, 0, 1, 0, nextafter(1, 0)), expect(0, NULL);
    set_ray(0, 0, -2, 0, 0, 1, 3, 1), expect(0, NULL);
    set_ray(0, 0, -2, 0, 0, 1, INFINITY, INFINITY), expect(0, NULL);
    set_ray(0, 0, -2, 0, 0, 1, nextafter(3, 4), INFINITY), expect(0, NULL);
    set_ray(0, 0, -2, 0, 0, 1, -INFINITY, INFINITY), expect(2, both);
    set_ray(0, 0, 2, 0, 0, 1, -INFINITY, 0), expect(2, (const double[]){-3, -1});
    set_ray(0, 0, 2, 0, 0, 1, -2, 7), expect(1, (const double[]){-1});
}

TEST(test_eye_inside_and_on) {
    with("x^2 + y^2 + z^2 - 1");
    set_ray(0, 0, 0, 0, 1, 0, 0, INFINITY), expect(1, (const double[]){1});
    set_ray(0.5, 0, 0, -1, 0, 0, 0, 9), expect(1, (const double[]){1.5});
    set_ray(1, 0, 0, -1, 0, 0, 0, INFINITY), expect(2, (const double[]){0, 2});
    set_ray(1, 0, 0, 1, 0, 0, 0, INFINITY), expect(1, (const double[]){0});
    set_ray(0.6, 0, -0.8, -0.5, 0, 1, 0, INFINITY); /* 0.6^2 + 0.8^2 is not 1 in doubles */
    intersect_judge(&c, NULL, &answer);
    with("x*y + y*z + 3 z"); /* through the origin */
    set_ray(-1, 0, -1, 1, 0, 1, -5, 5), expect(1, (const double[]){1});
    set_ray(0, 0, 0, 1, 1, 1, 0, INFINITY), expect(1, (const double[]){0});
    set_ray(0, 0, 0, 1, 1, 1, 0x1p-60, INFINITY), expect(0, NULL);
}

TEST(test_directions_of_any_length) {
    with("x^2 + y^2 + z^2 - 1");
    for (int k = -1000; k <= 1000; k += 125) {
        double unit = ldexp(1, -k);
        set_ray(0, 0.25, -2, 0, 0, ldexp(1, k), 0, INFINITY);
        intersect_judge(&c, NULL, &answer);
        assert_int_equal(answer.count, 2);
        double half = sqrt(1 - 0.0625);
        assert_true(fabs(answer.all[0].t / unit - (2 - half)) < 1e-15 &&
                    fabs(answer.all[1].t / unit - (2 + half)) < 1e-15);
        assert_true(fabs(answer.all[0].normal[1] - 0.25) < 1e-15 &&
                    fabs(answer.all[0].normal[2] + half) < 1e-15);
    }
}

TEST(test_far_eye) {
    with("x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8");
    set_ray(0.75, 0.5, -4, 0.125, 0, 1, 0, INFINITY);
    intersect_judge(&c, NULL, &answer);
    algsurf_hit near_hit = answer.first;
    assert_int_equal(near_hit.state, ALGSURF_STATE_HIT);
    for (int k = 10; k <= 26; k += 4) { /* the same line, exactly, from 2^k further away */
        double back = ldexp(1, k);
        set_ray(0.75 - 0.125 * back, 0.5, -4 - back, 0.125, 0, 1, 0, INFINITY);
        intersect_judge(&c, NULL, &answer);
        assert_int_equal(answer.first.state, ALGSURF_STATE_HIT);
        for (int i = 0; i < 3; i++) {
            assert_true(fabs(answer.first.position[i] - near_hit.position[i]) < 1e-14);
            assert_true(fabs(answer.first.normal[i] - near_hit.normal[i]) < 1e-13);
        }
        assert_true(fabs(answer.first.t - back - near_hit.t) <= 0x1p-52 * back);
    }
}

/* The same scene larger by 2^k: the same bits of t. */
TEST(test_scales) {
    algsurf_term terms[INTERSECT_TERMS];
    double t = 0;
    for (int k = -160; k <= 160; k += 40) {
        with("x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8");
        for (int i = 0; i < c.count; i++) {
            terms[i] = c.terms[i];
            terms[i].a = ldexp(terms[i].a, (4 - terms[i].i - terms[i].j - terms[i].k) * k);
        }
        int count = c.count;
        assert_true(intersect_terms(&c, terms, count));
        double u = ldexp(1, k);
        set_ray(0.75 * u, 0.5 * u, -4 * u, 0.125 * u, 0, u, 0, 10);
        intersect_judge(&c, NULL, &answer);
        assert_int_equal(answer.first.state, ALGSURF_STATE_HIT);
        if (k > -160) assert_true(answer.first.t == t);
        t = answer.first.t;
    }
}

TEST(test_normals) {
    with("x^3 + 2 y^2 z - x z + 0.25");
    for (int i = 0; i < 20; i++) {
        set_ray(0.1 * i - 1, 0.3, -2, 0.01 * i, 0.02, 1, 0, 5);
        intersect_judge(&c, NULL, &answer);
        for (int k = 0; k < answer.count; k++) {
            const algsurf_hit *h = answer.all + k;
            double g[3], value, size;
            assert_ok(algsurf_surface_gradient(c.surface, h->position, &value, g, NULL, NULL));
            size = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
            for (int j = 0; j < 3; j++) assert_true(fabs(h->normal[j] - g[j] / size) < 1e-12);
        }
    }
}

/* Towards and past singular points: the normal is that of P shortly before. */
TEST(test_singular_normals) {
    const struct {
        const char *equation;
        algsurf_ray ray;
        double normal[3];
    } rows[] = {
        {"(x^2 + y^2 + z^2 - 1)^2", {{-2, 0.5, 0}, {1, 0, 0}, 0, INFINITY}, {-0.8660254037844386, 0.5, 0}},
        {"(x^2 + y^2 + z^2 - 1)^2", {{-2e6, 0.6, 0}, {1, 0, 0}, 0, INFINITY}, {-0.8, 0.6, 0}},
        {"(x^2 + y^2 + z^2 - 0x1p40)^2", {{-0x1p22, 0, 0}, {1, 0, 0}, 0, INFINITY}, {-1, 0, 0}},
        {"(x - 0x1p40)^2 (x - 3)", {{4, 0, 0}, {1, 1, 0}, 0, INFINITY}, {-1, 0, 0}},
        {"x^2 - y^2 z", {{-2, 0, 0.5}, {1, 0, 0}, 0, INFINITY}, {-1, 0, 0}}, /* Whitney's handle */
        {"x^2 + y^2 - z^2", {{-1, 0, 0}, {1, 0, 0}, 0, INFINITY}, {-1, 0, 0}},
        {"x^2 + y^2 - z^2", {{0, 0, -3}, {0, 0, 2}, 0, INFINITY}, {0, 0, 1}},
        {"(x + y) (x - y)",
         {{-3, 0, 1}, {1, 0, 0}, 0, INFINITY},
         {-1, 0, 0}}, /* two planes, where they meet */
        {"x^2 + y^2 + z^2 - 1", {{-2, 1, 0}, {1, 0, 0}, 0, INFINITY}, {0, 1, 0}}, /* no singular point */
        {"z^2", {{-2, 1, 0}, {1, 0, 0}, 0, 5}, {0, 0, 0}},                        /* no normal anywhere */
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        with(rows[i].equation);
        c.ray = rows[i].ray;
        intersect_judge(&c, NULL, &answer);
        const algsurf_hit *hit = &answer.first;
        assert_int_equal(hit->state, ALGSURF_STATE_HIT);
        for (int a = 0; a < 3; a++)
            if (!(fabs(hit->normal[a] - rows[i].normal[a]) < 1e-5)) intersect_fail("normal", &c, &answer);
    }
}

/* With an extent: the roots in it, and none outside. */
TEST(test_extents) {
    const algsurf_extent extents[] = {
        {ALGSURF_EXTENT_ALL, {0, 0, 0}, {0, 0, 0}},      {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}},
        {ALGSURF_EXTENT_SPHERE, {0.5, 0, 1}, {1, 0, 0}}, {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}},
        {ALGSURF_EXTENT_BOX, {0, 0, 3}, {1, 2, 1.5}},    {ALGSURF_EXTENT_SPHERE, {9, 9, 9}, {1, 0, 0}},
    };
    with("x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8");
    int kept = 0, cut = 0;
    for (size_t e = 0; e < sizeof extents / sizeof extents[0]; e++)
        for (int i = 0; i < 60; i++) {
            set_ray(0.05 * i - 1.5, 0.6, -7, 0.03, 0.1, 1, 0, INFINITY);
            intersect_judge(&c, NULL, &answer);
            int whole = answer.count;
            intersect_judge_in(&c, extents + e, NULL, &answer);
            kept += answer.count, cut += whole - answer.count;
        }
    assert_true(kept > 50 && cut > 50);
}

/* Every point of the ray is one of the surface: one hit, where the ray begins. */
TEST(test_rays_within) {
    static const struct {
        const char *equation;
        algsurf_ray ray;
    } within[] = {
        {"x^2 z + y^2", {{0, 0, -2}, {0, 0, 1}, 0, 4}},
        {"x^2 z + y^2", {{0, 0, -2}, {0, 0, 1}, 0, INFINITY}},
        {"x^2 z + y^2", {{0, 0, -2}, {0, 0, 3}, -INFINITY, INFINITY}},
        {"x^2y^2 + x^2z^2 + y^2z^2 + x y z", {{-3, 0, 0}, {1, 0, 0}, 0, 9}},
        {"x^2y^2 + x^2z^2 + y^2z^2 + x y z", {{0, 0.7, 0}, {0, 0.1, 0}, -4, 9}},
    };
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    for (size_t i = 0; i < sizeof within / sizeof within[0]; i++) {
        with(within[i].equation);
        c.ray = within[i].ray;
        intersect_judge(&c, NULL, &answer);
        assert_int_equal(answer.count, 1);
        assert_int_equal(answer.first.multiplicity, 0);
        assert_true(answer.first.t == fmax(c.ray.t_min, -DBL_MAX));
        intersect_judge_in(&c, &ball, NULL, &answer);
        assert_true(answer.count == 1 && answer.first.multiplicity == 0);
    }
}

/* The hits' multiplicity and t, from an eye at distance 2 that looks along z. */
static void touch(double x, double y, int count, int multiplicity, double t) {
    set_ray(x, y, -2, 0, 0, 1, 0, 4);
    intersect_judge(&c, NULL, &answer);
    if (answer.count != count || (count && answer.first.multiplicity != multiplicity) ||
        (count && !(fabs(answer.first.t - t) < 1e-7)))
        intersect_fail("touch", &c, &answer);
}

/* Across a double line, and past a sphere: in, by a rounding error out, and in. */
TEST(test_touching) {
    with("x^2y^2 + x^2z^2 + y^2z^2 + x y z");
    touch(0, 0.125, 1, 2, 2);
    with("x^2 + y^2 + z^2 - 1");
    touch(0, 1, 1, 2, 2);
    touch(0, nextafter(1, 2), 0, 0, 0);
    touch(0, nextafter(1, 0), 2, 1, 2);
}

/* A ray in a plane: one hit, where the ray begins. */
TEST(test_in_a_plane) {
    static const double ends[3][2] = {{0, 2}, {0.5, INFINITY}, {-INFINITY, INFINITY}};
    with("y");
    for (int i = 0; i < 3; i++) {
        set_ray(0, 0, 0, 1, 0, 0, ends[i][0], ends[i][1]);
        intersect_judge(&c, NULL, &answer);
        const algsurf_hit *h = answer.all;
        assert_true(answer.count == 1 && h->multiplicity == 0 && h->t == fmax(ends[i][0], -DBL_MAX));
    }
}

/* Numbers at the ends of the range: positions and normals are finite, and calls agree. */
TEST(test_ends_of_the_range) {
    static const struct {
        const char *equation;
        algsurf_ray ray;
        int state;
        double position[3];
    } cases[] = {
        /* y at the hit is larger than its square's root may be, or than a double; P overflows, and its
           gradient */
        {"y - 1e300", {{-4, 0, 0}, {1, 1e300, 0}, 1, 1}, ALGSURF_STATE_HIT, {-3, 1e300, 0}},
        {"y^2", {{-4, 0, 0}, {1, 1e300, 0}, 1, 1}, ALGSURF_STATE_MISS, {0, 0, 0}},
        {"y^2", {{-4, 0, 0}, {1, -1e300, 0}, 1e200, 1e200}, ALGSURF_STATE_MISS, {0, 0, 0}},
        {"z", {{-4, 0, 0}, {1, -1e300, 0}, 1e200, 1e200}, ALGSURF_STATE_HIT, {1e200, -DBL_MAX, 0}},
        {"2z^4 + x^3 y^2", {{1e300, 12, 0}, {1, 0, 0}, 0, 1}, ALGSURF_STATE_MISS, {0, 0, 0}},
        {"2z^4 + x^3 y^2", {{1e300, 12, 0}, {1, -12, 0}, 0, 1}, ALGSURF_STATE_HIT, {1e300, 0, 0}},
        /* the root is beyond the largest double */
        {"y", {{0, 1, 0}, {0, 0x1p-1074, 0}, -INFINITY, INFINITY}, ALGSURF_STATE_HIT, {0, 0, 0}},
        /* an end is the root, and the rest of the ray is below every bound of double */
        {"2y", {{-4, 0, 0}, {22, 10, 1}, 0, 0x1p-1074}, ALGSURF_STATE_HIT, {-4, 0, 0}},
        {"2y", {{-4, 0, 0}, {22, 10, 1}, -0x1p-1074, 0}, ALGSURF_STATE_HIT, {-4, 0, 0}},
        {"y - 1e-313", {{-4, 0, 0}, {1, 1, 1}, 1e-313, 3e-313}, ALGSURF_STATE_HIT, {-4, 1e-313, 1e-313}},
    };
    const size_t beyond = 6; /* number of that case */
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        with(cases[i].equation);
        c.ray = cases[i].ray;
        intersect_judge(&c, NULL, &answer);
        if (answer.first.state != cases[i].state) intersect_fail("state", &c, &answer);
        for (int k = 0; k < 3; k++)
            if (!(fabs(answer.first.position[k] - cases[i].position[k]) <=
                  1e-15 * fabs(cases[i].position[k]) + (i == beyond ? 0x1p-90 : 0x1p-1074)))
                intersect_fail("position", &c, &answer);
    }
    with("x^2 + y^2 + z^2 - 1"); /* both roots beyond the largest double */
    set_ray(8, 0, 0, 0x1p-1074, 0, 0, -INFINITY, INFINITY);
    intersect_judge(&c, NULL, &answer);
    assert_int_equal(answer.count, 2);
    with("y z^3"); /* a direction with a component that underflows next to the largest, over a long way */
    set_ray(1e300, 0, -1e-300, 3, -1e300, 1e-300, 1e-5, nextafter(1, 2));
    intersect_judge(&c, NULL, &answer);
    set_ray(1e300, 0, -1e-300, 3, -1e300, 1e-300, 1, 1);
    intersect_judge(&c, NULL, &answer);
    with("y"); /* far more than the chord */
    set_ray(1, 80, 3, 1e300, 1e21, 0.1, -1, 600);
    intersect_judge(&c, NULL, &answer);
}

TEST(test_degrees) {
    with("5");
    set_ray(0, 0, -2, 0, 0, 1, 0, INFINITY), expect(0, NULL);
    with("x - 2y + 3z - 1");
    set_ray(0, 0, 0, 0.5, 0, 0, 0, INFINITY), expect(1, (const double[]){2});
    with("x^64 + y^64 + z^64 - 1");
    set_ray(0, 0, -2, 0, 0, 1, 0, INFINITY), expect(2, (const double[]){1, 3});
    set_ray(0.5, -0.25, -1, 0, 0, 1, 0, INFINITY);
    intersect_judge(&c, NULL, &answer);
    assert_int_equal(answer.count, 2);
    set_ray(-3, 0.25, -3.125, 1, 0.015625, 1, 0, 10);
    intersect_judge(&c, NULL, &answer);
}

/* Chmutov's surface of degree 16, T_16(x) + T_16(y) + T_16(z) + 1, whose coefficients reach 2^17. */
TEST(test_chmutov) {
    const double t16[] = {1, -128, 2688, -21504, 84480, -180224, 212992, -131072, 32768};
    algsurf_term terms[28];
    int count = 0, hits = 0, undecided = 0;
    for (int k = 0; k <= 8; k++) {
        terms[count++] = (algsurf_term){2 * k, 0, 0, t16[k]};
        terms[count++] = (algsurf_term){0, 2 * k, 0, t16[k]};
        terms[count++] = (algsurf_term){0, 0, 2 * k, t16[k]};
    }
    terms[count++] = (algsurf_term){0, 0, 0, 1};
    assert_true(intersect_terms(&c, terms, count));
    uint64_t seed = 3;
    for (int i = 0; i < 150; i++) {
        double x = ldexp(floor(ldexp(random_unit(&seed), 20)), -20),
               y = ldexp(floor(ldexp(random_unit(&seed), 20)), -20);
        set_ray(x, y, -4, 0.125 * y, 0.0625 * x, 1, 2.5, 5.5);
        intersect_judge(&c, NULL, &answer);
        for (int k = 0; k < answer.count; k++) {
            hits += answer.all[k].state == ALGSURF_STATE_HIT,
                undecided += answer.all[k].state != ALGSURF_STATE_HIT;
        }
    }
    assert_true(hits > 500 && undecided == 0);
}
