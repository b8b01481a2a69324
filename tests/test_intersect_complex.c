/* test_intersect_complex.c - the first hit in complex space.
 *
 * The sphere with an imaginary part m in p_0 has roots in closed form, t = -b +- sqrt(b^2 - c - i m).
 * Catches: magnitude or argument taken from the re-centred parameter instead of from the eye, a wrong
 * power of the scale in the imaginary part, a normal that is not that of the surface shown, answers
 * that depend on start values, what underflow takes from an imaginary part or an end of the ray forgotten. */
#include "scenes.h"

static const double pi = 3.141592653589793;

static algsurf_complex_space space_of(double sigma, double delta) {
    return (algsurf_complex_space){.size = sizeof(algsurf_complex_space), .sector = {sigma, delta}};
}

static algsurf_ray ray_towards(const double eye[3], const double target[3]) {
    algsurf_ray ray = {{eye[0], eye[1], eye[2]}, {0, 0, 0}, 0, HUGE_VAL};
    double length = 0;
    for (int i = 0; i < 3; i++) length += (target[i] - eye[i]) * (target[i] - eye[i]);
    for (int i = 0; i < 3; i++) ray.direction[i] = (target[i] - eye[i]) / sqrt(length);
    return ray;
}

static algsurf_hit hit_of(const algsurf_surface *s, const algsurf_ray *ray,
                          const algsurf_complex_space *space) {
    algsurf_hit hit;
    assert_ok(algsurf_intersect_complex(s, NULL, ray, space, NULL, NULL, &hit, NULL));
    return hit;
}

/* Real space is sigma = 0 and a small delta: the same hits as the real branch. */
TEST(test_real_space) {
    const char *equations[] = {"x^2+y^2+z^2=1", "x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8", "x^2 z+y^2",
                               "(x^2+y^2+z^2+5.44)^2 = 25 (x^2+y^2)"};
    const algsurf_complex_space space = space_of(0, 1e-10);
    uint64_t seed = 7;
    int hits = 0;
    for (int e = 0; e < 4; e++) {
        algsurf_surface *s = surface_of(equations[e]);
        for (int i = 0; i < 300; i++) {
            const double eye[3] = {6, 5, 4};
            double target[3];
            for (int k = 0; k < 3; k++) target[k] = 2 * random_unit(&seed);
            algsurf_ray ray = ray_towards(eye, target);
            algsurf_hit real, complex = hit_of(s, &ray, &space);
            assert_ok(algsurf_intersect_first(s, NULL, &ray, NULL, &real));
            if (complex.state == ALGSURF_STATE_UNDECIDED || real.state == ALGSURF_STATE_UNDECIDED) continue;
            assert_int_equal(complex.state, real.state);
            if (real.state != ALGSURF_STATE_HIT) continue;
            hits++;
            assert_true(fabs(complex.t - real.t) <= 1e-9 * real.t);
            for (int k = 0; k < 3; k++) assert_true(fabs(complex.normal[k] - real.normal[k]) < 1e-6);
        }
    }
    assert_true(hits > 300);
}

/* Closed form for the unit sphere: t^2 + 2 b t + c + i m = 0, unit direction. */
static double sphere_magnitude(const algsurf_ray *ray, double m, double delta) {
    double b = 0, c = -1, best = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        b += ray->origin[i] * ray->direction[i];
        c += ray->origin[i] * ray->origin[i];
    }
    double re = b * b - c, size = hypot(re, m), p = sqrt(0.5 * (size + fabs(re))), q = fabs(m) / (2 * p);
    double sr = re >= 0 ? p : q, si = re >= 0 ? q : p;
    if (m > 0) si = -si;
    for (int sign = -1; sign <= 1; sign += 2) {
        double tr = -b + sign * sr, ti = sign * si;
        if (fabs(atan2(ti, tr)) <= delta) best = fmin(best, hypot(tr, ti));
    }
    return best;
}

TEST(test_complex_sphere) {
    algsurf_surface *s = surface_of("x^2+y^2+z^2=1");
    uint64_t seed = 11;
    int seen = 0, lost = 0;
    for (int i = 0; i < 2000; i++) {
        const double eye[3] = {2, 1.5, -1}, m = i % 2 ? 0.3 : -0.8,
                     delta = 0.02 + 0.2 * fabs(random_unit(&seed));
        double target[3];
        for (int k = 0; k < 3; k++) target[k] = random_unit(&seed);
        algsurf_ray ray = ray_towards(eye, target);
        algsurf_complex_space space = space_of(0, delta);
        space.imaginary = &m, space.imaginary_count = 1;
        algsurf_hit hit = hit_of(s, &ray, &space);
        double expected = sphere_magnitude(&ray, m, delta);
        if (hit.state == ALGSURF_STATE_UNDECIDED) continue;
        assert_int_equal(hit.state, isinf(expected) ? ALGSURF_STATE_MISS : ALGSURF_STATE_HIT);
        if (hit.state == ALGSURF_STATE_HIT) {
            assert_true(fabs(hit.t - expected) < 1e-12);
            assert_true(hit.t_lo <= hit.t && hit.t <= hit.t_hi && hit.t_hi - hit.t_lo < 1e-10);
            for (int k = 0; k < 3; k++)
                assert_true(fabs(hit.position[k] - (ray.origin[k] + hit.t * ray.direction[k])) < 1e-12);
        }
        *(hit.state == ALGSURF_STATE_HIT ? &seen : &lost) += 1;
    }
    assert_true(seen > 500 && lost > 100);
}

/* The normal is orthogonal to how the shown point moves when the direction turns. */
TEST(test_normal) {
    algsurf_surface *s = surface_of("x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8");
    algsurf_complex_space space = space_of(0, pi / 6);
    uint64_t seed = 5;
    int checked = 0;
    space.imaginary = (const double[]){2, -0.1}, space.imaginary_count = 2;
    for (int i = 0; i < 300; i++) {
        const double eye[3] = {6, 5, 4}, h = 1e-5;
        double target[3], turn[3], along = 0;
        for (int k = 0; k < 3; k++) {
            target[k] = 2 * random_unit(&seed);
            turn[k] = random_unit(&seed);
        }
        algsurf_ray ray = ray_towards(eye, target), left = ray, right = ray;
        for (int k = 0; k < 3; k++) along += turn[k] * ray.direction[k];
        for (int k = 0; k < 3; k++) {
            turn[k] -= along * ray.direction[k];
            left.direction[k] -= h * turn[k];
            right.direction[k] += h * turn[k];
        }
        algsurf_hit middle = hit_of(s, &ray, &space), a = hit_of(s, &left, &space),
                    b = hit_of(s, &right, &space);
        if (middle.state != ALGSURF_STATE_HIT || a.state != ALGSURF_STATE_HIT || b.state != ALGSURF_STATE_HIT)
            continue;
        if (fabs(a.t - b.t) > 1e-2) continue;  /* another sheet */
        double move = 0, length = 0, bend = 0; /* where it is large, beside double roots, the rest is, too */
        for (int k = 0; k < 3; k++) {
            bend += fabs(a.position[k] - 2 * middle.position[k] + b.position[k]);
            move += middle.normal[k] * (b.position[k] - a.position[k]);
            length += (b.position[k] - a.position[k]) * (b.position[k] - a.position[k]);
        }
        assert_true(fabs(move) <= 1e-3 * sqrt(length) + bend);
        assert_often(bend < 0.1 * sqrt(length));
        checked++;
    }
    assert_true(checked > 50);
}

/* Start values change the time, not the answer. */
TEST(test_start_values) {
    algsurf_surface *s = surface_of("x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8");
    algsurf_complex_space space = space_of(0, pi / 10);
    algsurf_complex roots[4], again[4];
    algsurf_hit cold, warm;
    const double eye[3] = {6, 5, 4};
    uint64_t seed = 3;
    space.imaginary = (const double[]){1}, space.imaginary_count = 1;
    for (int i = 0; i < 500; i++) {
        double target[3];
        for (int k = 0; k < 3; k++) target[k] = 2 * random_unit(&seed);
        algsurf_ray ray = ray_towards(eye, target);
        assert_ok(algsurf_intersect_complex(s, NULL, &ray, &space, NULL, roots, &cold, NULL));
        for (int k = 0; k < 4; k++) roots[k].re *= 1.01, roots[k].im *= 0.97;
        assert_ok(algsurf_intersect_complex(s, NULL, &ray, &space, roots, again, &warm, NULL));
        assert_int_equal(cold.state, warm.state);
        if (cold.state != ALGSURF_STATE_HIT) continue;
        assert_memory_equal(&cold.t, &warm.t, sizeof cold.t);
        assert_memory_equal(cold.normal, warm.normal, sizeof cold.normal);
    }
}

/* They may come in the array that the roots go to.  With an error the roots' last bits tell them apart. */
TEST(test_start_in_place) {
    algsurf_surface *exact = surface_of("x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8"), *s;
    const algsurf_complex_space space = space_of(0, pi / 10);
    const double eye[3] = {6, 5, 4}, target[3] = {0.1, 0.2, 0.3};
    const algsurf_ray ray = ray_towards(eye, target);
    algsurf_complex cold[4], warm[4], in_place[4];
    algsurf_hit hit;
    s = surface_with_error(exact, 1e-2);
    assert_ok(algsurf_intersect_complex(s, NULL, &ray, &space, NULL, cold, &hit, NULL));
    for (int k = 0; k < 4; k++) in_place[k] = (algsurf_complex){1.01 * cold[k].re, 0.97 * cold[k].im};
    assert_ok(algsurf_intersect_complex(s, NULL, &ray, &space, in_place, warm, &hit, NULL));
    assert_ok(algsurf_intersect_complex(s, NULL, &ray, &space, in_place, in_place, &hit, NULL));
    assert_memory_not_equal(warm, cold, sizeof warm);
    assert_memory_equal(warm, in_place, sizeof warm);
}

TEST(test_far_eye) {
    algsurf_surface *s = surface_of("x^2+y^2+z^2=1");
    const algsurf_complex_space space = space_of(0, 1e-10);
    const double eye[3] = {6e5, 5e5, 4e5}, target[3] = {0.1, 0.2, 0.3};
    algsurf_ray ray = ray_towards(eye, target);
    algsurf_hit real, hit = hit_of(s, &ray, &space);
    assert_ok(algsurf_intersect_first(s, NULL, &ray, NULL, &real));
    assert_int_equal(hit.state, ALGSURF_STATE_HIT);
    assert_true(fabs(hit.t - real.t) <= 4e-16 * real.t);
    for (int k = 0; k < 3; k++) assert_true(fabs(hit.position[k] - real.position[k]) < 1e-12);
}

/* A ray in the surface, one beyond the range of double, one that touches: undecided, and why; without a root
 * to show there is none in root, and the hit is where the ray begins. */
TEST(test_undecided) {
    static const struct {
        const char *equation;
        algsurf_ray ray;
        algsurf_status reason;
        double t;
    } cases[] = {
        {"x y - z", {{-5, 0, 0}, {1, 0, 0}, 2, 10}, ALGSURF_UNDECIDED_ZERO, 2},
        {"x^2+y^2+z^2=1", {{1e300, 0.5, -5}, {1, 1e300, 1}, 3, HUGE_VAL}, ALGSURF_UNDECIDED_RANGE, 3},
        {"x^2+y^2+z^2=1", {{1, 0, -5}, {0, 0, 1}, 0, 10}, ALGSURF_UNDECIDED_MULTIPLE, 5},
    };
    const algsurf_complex_space space = space_of(0, 1e-10);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        algsurf_surface *s = surface_of(cases[i].equation);
        const algsurf_ray *ray = &cases[i].ray;
        algsurf_complex root = {0, 0};
        algsurf_hit hit;
        assert_ok(algsurf_intersect_complex(s, NULL, ray, &space, NULL, NULL, &hit, &root));
        assert_int_equal(hit.state, ALGSURF_STATE_UNDECIDED);
        assert_int_equal(hit.reason, cases[i].reason);
        assert_true(hit.t_lo <= hit.t && hit.t <= hit.t_hi && fabs(hit.t - cases[i].t) < 1e-6);
        int shown = cases[i].reason == ALGSURF_UNDECIDED_MULTIPLE;
        assert_int_equal(isnan(root.re), !shown);
        if (!shown) {
            assert_true(hit.t_lo == ray->t_min && hit.t_hi == ray->t_max);
            for (int k = 0; k < 3; k++)
                assert_true(hit.position[k] == ray->origin[k] + hit.t * ray->direction[k]);
        }
    }
}

/* Positions beyond the range of double, of hits and of what is undecided, are clamped to it, and t is finite.
 * Catches: positions from t without the clamp, or of a frame that has overflowed; a t that has. */
TEST(test_beyond_range) {
    static const struct {
        const char *equation;
        algsurf_ray ray;
        int state;
    } cases[] = {
        {"x^2+y^2+z^2=1", {{1.7e308, 0, 0.25}, {1, 1, 0}, 1e308, HUGE_VAL}, ALGSURF_STATE_UNDECIDED},
        {"y^2 - 1e-300 x", {{0.5, 0, 0.25}, {1000, 1, 0}, 1e308, HUGE_VAL}, ALGSURF_STATE_UNDECIDED},
        {"y^2 - 1e-300 x", {{0.5, 0, 0.25}, {1e200, 1, 0}, 1, HUGE_VAL}, ALGSURF_STATE_MISS},
        {"y^2 - 1e-300 x", {{0.5, 0, 0.25}, {1e200, 1, 0}, 0, HUGE_VAL}, ALGSURF_STATE_HIT},
    };
    const algsurf_complex_space space = space_of(0, 1);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        algsurf_surface *s = surface_of(cases[i].equation);
        algsurf_hit hit;
        assert_ok(algsurf_intersect_complex(s, NULL, &cases[i].ray, &space, NULL, NULL, &hit, NULL));
        assert_int_equal(hit.state, cases[i].state);
        assert_true(isfinite(hit.t) == (hit.state != ALGSURF_STATE_MISS) && hit.t_lo <= hit.t &&
                    hit.t <= hit.t_hi);
        for (int k = 0; k < 3; k++) assert_true(isfinite(hit.position[k]));
    }
}

/* Coordinates that are nothing in the surface's unit are those of the ray. */
TEST(test_small_coordinates) {
    static const algsurf_ray rays[] = {{{0, 0x1p-255, -0x1p-66}, {0x1p392, 0x1p-71, 0}, 0, HUGE_VAL},
                                       {{-12, 4, 0.25}, {-0x1p-819, 0x1p-478, -0x1p1015}, 0, HUGE_VAL}};
    static const algsurf_term planes[][2] = {{{1, 0, 0, -0x1p-401}, {0, 0, 0, 0x1p848}},
                                             {{0, 0, 1, 0x1p-457}, {0, 0, 0, 0x1p927}}};
    const algsurf_complex_space space = space_of(0, 1e-10);
    for (int i = 0; i < 2; i++) {
        algsurf_surface *s = surface_of_terms(planes[i], 2);
        algsurf_hit hit = hit_of(s, rays + i, &space);
        assert_int_equal(hit.state, ALGSURF_STATE_HIT);
        for (int k = 0; k < 3; k++) {
            const double x = fma(hit.t, rays[i].direction[k], rays[i].origin[k]);
            assert_true(fabs(hit.position[k] - x) <= 0x1p-50 * fabs(x));
        }
    }
}

/* p(t) = a (x + d t) + i (m + k t) up to t_max: a plane seen along its normal, from -x before it. */
typedef struct plane {
    double a, x, d, t_max, m, k;
} plane;

/* The state of the root in the sector {0, delta}; checks that its magnitude is enclosed. */
static int state_of(const plane *p, double delta, const mpq_t size) {
    const algsurf_term terms[] = {{1, 0, 0, p->a}};
    const algsurf_ray ray = {{p->x, 0, 0}, {p->d, 0, 0}, 0, p->t_max};
    algsurf_complex_space space = space_of(0, delta);
    space.imaginary = (const double[]){p->m, p->k}, space.imaginary_count = 2;
    algsurf_surface *s = surface_of_terms(terms, 1);
    algsurf_hit hit = hit_of(s, &ray, &space);
    if (hit.state != ALGSURF_STATE_MISS && !exact_between(hit.t_lo, size, hit.t_hi)) {
        exact_print("|t|", size);
        fail_msg("a %a, x %a, d %a, t_max %a, m %a, k %a: |t| not in [%a, %a]", p->a, p->x, p->d, p->t_max,
                 p->m, p->k, hit.t_lo, hit.t_hi);
    }
    return (int)hit.state;
}

/* Imaginary parts down to the smallest double: their roots are not real, however near.  From x = 0, where
 * t = -i m/(a d), and from before the plane, also with the middle of the ray on it. */
TEST(test_small_imaginary) {
    static const double from[][3] = {
        {0, 1, INFINITY}, {0, 0x1p50, INFINITY}, {-3, 1, INFINITY}, {-0x3p-10, 1, 0x6p-10}};
    static const double factors[] = {1, 1.25, 1.75}, parts[] = {1, -1, 3, -7};
    int seen[4][3] = {{0}}, all[3] = {0}; /* in a sector without the root; in one with it */
    mpq_t size, a;
    mpq_inits(size, a, NULL);
    for (int e = -1074; e <= -900; e += e < -1050 ? 1 : 10)
        for (int i = 0; i < 4 * 3 * 4 * 10; i++) {
            const double *place = from[i / 120];
            double part = ldexp(parts[i % 4], e), factor = ldexp(factors[i / 4 % 3], i / 12 % 10 - 3);
            int on = place[0] == 0;
            exact_set(size, on ? fabs(part) : -place[0]), exact_set(a, factor * place[1]);
            if (on) mpq_div(size, size, a); /* else but for a factor of 1 - 1e-541 or nearer to 1 */
            for (int k = 0; k < (on ? 1 : 2); k++) {
                const plane p = {factor, place[0], place[1], place[2], k ? 0 : part, k ? part : 0};
                int without = state_of(&p, on ? 1e-10 : 0, size), with = state_of(&p, pi, size);
                if (without == ALGSURF_STATE_HIT || with == ALGSURF_STATE_MISS)
                    fail_msg("a %a, x %a, d %a, t_max %a, m %a, k %a: %d without the root, %d with it", p.a,
                             p.x, p.d, p.t_max, p.m, p.k, (int)without, (int)with);
                seen[i / 120][without]++, all[with]++;
            }
        }
    mpq_clears(size, a, NULL);
    assert_true(seen[0][ALGSURF_STATE_MISS] > 4000 && seen[1][ALGSURF_STATE_MISS] > 4000);
    assert_true(seen[2][ALGSURF_STATE_MISS] > 8000 && seen[3][ALGSURF_STATE_MISS] > 7000);
    assert_true(all[ALGSURF_STATE_HIT] > 25000);
}

/* The root 0 is before t_min, even where t_min is 0 in the surface's unit. */
TEST(test_small_t_min) {
    algsurf_surface *s = surface_of("x^2 + 1024 x");
    const algsurf_complex_space space = space_of(0, 1);
    algsurf_ray ray = {{0, 0, 0}, {1, 0, 0}, 0, HUGE_VAL};
    assert_int_equal(hit_of(s, &ray, &space).state, ALGSURF_STATE_HIT);
    ray.t_min = 0x1p-1074;
    assert_true(hit_of(s, &ray, &space).state != ALGSURF_STATE_HIT);
    ray.t_min = 0x1p-1000;
    assert_int_equal(hit_of(s, &ray, &space).state, ALGSURF_STATE_MISS);
}

/* Roots of nearly the same magnitude, x^2 + 2^-k x - 1 from 0, seen in all directions. */
TEST(test_rivals) {
    int decided = 0;
    for (int k = 1; k <= 200; k++) {
        const algsurf_term terms[] = {{2, 0, 0, 1}, {1, 0, 0, ldexp(1, -k)}, {0, 0, 0, -1}};
        const algsurf_ray ray = {{0, 0, 0}, {1, 0, 0}, 0, HUGE_VAL};
        const algsurf_complex_space space = space_of(0, pi);
        algsurf_complex root;
        algsurf_hit hit;
        algsurf_surface *s = surface_of_terms(terms, 3);
        assert_ok(algsurf_intersect_complex(s, NULL, &ray, &space, NULL, NULL, &hit, &root));
        if (hit.state == ALGSURF_STATE_UNDECIDED) continue;
        decided++;
        if (hit.state != ALGSURF_STATE_HIT || root.re < 0)
            fail_msg("k = %d: %d, root %a", k, hit.state, root.re);
    }
    assert_true(decided > 40);
}

/* Of the roots 3 + i and 3 - i, moved by an imaginary part m t, the first becomes the smaller; without one
 * they are conjugates, and the hit is decided. */
TEST(test_conjugates) {
    const algsurf_ray ray = {{0, 0, 0}, {1, 0, 0}, 0, HUGE_VAL};
    algsurf_surface *s = surface_of("x^2 - 6 x + 10");
    algsurf_complex_space space = space_of(0, 0.5);
    algsurf_complex root;
    algsurf_hit hit = hit_of(s, &ray, &space);
    assert_int_equal(hit.state, ALGSURF_STATE_HIT);
    int decided = 0;
    for (int k = 4; k <= 1074; k++) {
        space.imaginary = (const double[]){0, ldexp(k % 2 ? 1 : -1, -k)}, space.imaginary_count = 2;
        assert_ok(algsurf_intersect_complex(s, NULL, &ray, &space, NULL, NULL, &hit, &root));
        if (hit.state == ALGSURF_STATE_UNDECIDED) continue;
        decided++;
        if (hit.state != ALGSURF_STATE_HIT || (root.im > 0) != (k % 2))
            fail_msg("k = %d: state %d, root %a + i %a", k, hit.state, root.re, root.im);
    }
    assert_true(decided > 30);
}

/* The root is 2^-107 outside of the ball; nearer to it than doubles place the chord's end. */
TEST(test_edge_of_the_extent) {
    static const algsurf_ray ray = {{-8192, 0x1.b399999d00ccdp-22, 0}, {1, 0, 0}, 0, HUGE_VAL};
    static const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    const algsurf_term terms[] = {{1, 0, 0, 1}, {0, 0, 0, -0x1.ffffffffffd1bp-1}};
    const algsurf_complex_space space = space_of(0, 0);
    algsurf_hit hit;
    algsurf_surface *s = surface_of_terms(terms, 2);
    assert_ok(algsurf_intersect_complex(s, &ball, &ray, &space, NULL, NULL, &hit, NULL));
    assert_int_equal(hit.state, ALGSURF_STATE_MISS);
}

/* As many numbers are read as are there, and zeros, of either sign, change nothing; nor does it matter how
 * many zeros there are. */
TEST(test_counts) {
    algsurf_surface *s = surface_of("x^2+y^2+z^2=1");
    const double eye[3] = {2, 1.5, -1}, target[3] = {0.3, -0.2, 0.4};
    const algsurf_ray ray = ray_towards(eye, target);
    algsurf_complex_space space = space_of(0, pi / 4);
    const algsurf_hit real = hit_of(s, &ray, &space);
    double imaginary[ALGSURF_MAX_DEGREE + 1];
    for (int k = 0; k <= ALGSURF_MAX_DEGREE; k++) imaginary[k] = k % 2 ? 0 : -0.0;
    for (int first = 0; first < 2; first++) { /* without and with an imaginary part of p_0 */
        algsurf_hit one = real;
        if (first) {
            imaginary[0] = 0.3;
            space.imaginary = imaginary, space.imaginary_count = 1;
            one = hit_of(s, &ray, &space);
            assert_true(one.state == ALGSURF_STATE_HIT && one.t != real.t);
        }
        for (int count = 1; count <= ALGSURF_MAX_DEGREE + 1; count++) {
            double *exact = malloc((size_t)count * sizeof *exact); /* sanitizers see what is read beyond it */
            assert_non_null(exact);
            memcpy(exact, imaginary, (size_t)count * sizeof *exact);
            space.imaginary = exact, space.imaginary_count = (size_t)count;
            const algsurf_hit hit = hit_of(s, &ray, &space);
            assert_memory_equal(&hit, &one, sizeof hit);
            free(exact);
        }
        imaginary[1] = NAN; /* behind the last one */
        space.imaginary = imaginary, space.imaginary_count = (size_t)first;
        const algsurf_hit hit = hit_of(s, &ray, &space);
        assert_memory_equal(&hit, &one, sizeof hit);
        imaginary[1] = 0;
    }
}

TEST(test_bad_arguments) {
    algsurf_surface *s = surface_of("x^2+y^2+z^2=1");
    const algsurf_ray ray = {{-4, 0, 0}, {1, 0, 0}, 0, HUGE_VAL}, bad_ray = {{NAN, 0, 0}, {1, 0, 0}, 0, 1};
    const algsurf_extent bad_extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {-1, 0, 0}};
    algsurf_complex_space good = space_of(0, 1), bad;
    algsurf_hit hit, before;
    memset(&hit, 0x5a, sizeof hit);
    before = hit;
    assert_int_equal(algsurf_intersect_complex(NULL, NULL, &ray, &good, NULL, NULL, &hit, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_complex(s, NULL, NULL, &good, NULL, NULL, &hit, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, NULL, NULL, NULL, &hit, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, &good, NULL, NULL, NULL, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_complex(s, NULL, &bad_ray, &good, NULL, NULL, &hit, NULL),
                     ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_intersect_complex(s, &bad_extent, &ray, &good, NULL, NULL, &hit, NULL),
                     ALGSURF_E_ARGUMENT);
    bad = space_of(-1, 1);
    assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, &bad, NULL, NULL, &hit, NULL),
                     ALGSURF_E_ARGUMENT);
    bad = space_of(0, 4);
    assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, &bad, NULL, NULL, &hit, NULL),
                     ALGSURF_E_ARGUMENT);
    double imaginary[ALGSURF_MAX_DEGREE + 2] = {0};
    bad = good, bad.imaginary_count = 1; /* of none */
    assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, &bad, NULL, NULL, &hit, NULL),
                     ALGSURF_E_ARGUMENT);
    bad.imaginary = imaginary, bad.imaginary_count = ALGSURF_MAX_DEGREE + 2;
    assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, &bad, NULL, NULL, &hit, NULL),
                     ALGSURF_E_ARGUMENT);
    bad.imaginary_count = SIZE_MAX;
    assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, &bad, NULL, NULL, &hit, NULL),
                     ALGSURF_E_ARGUMENT);
    for (int k = 0; k <= ALGSURF_MAX_DEGREE; k++) {
        bad.imaginary_count = (size_t)k + 1;
        imaginary[k] = k % 2 ? NAN : -INFINITY;
        assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, &bad, NULL, NULL, &hit, NULL),
                         ALGSURF_E_NOT_FINITE);
        imaginary[k] = k % 2 ? 0x1p-1074 : -1;
        if (k > 2) /* above the degree */
            assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, &bad, NULL, NULL, &hit, NULL),
                             ALGSURF_E_ARGUMENT);
        imaginary[k] = 0;
    }
    bad = good;
    bad.size = 1;
    assert_int_equal(algsurf_intersect_complex(s, NULL, &ray, &bad, NULL, NULL, &hit, NULL), ALGSURF_E_SIZE);
    assert_memory_equal(&hit, &before, sizeof hit);
}
