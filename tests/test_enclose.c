/* test_enclose.c - boxes about surfaces: nothing of a surface is outside of its box.
 *
 * Breaks tried, each caught by the tests named:
 *   no bound on rounding, or a thousandth of it              hits, points, tips
 *   a surface's error left out                               approximate
 *   even terms below 0 counted as 0                          known
 *   odd terms with their sign                                hits, points, tips, known
 *   derivatives without their factor, without their error    tips, known
 *   cells beside the sphere by their middles                 hits
 *   one round                                                points, tips, known
 *   rounding to nearest of the extent's ends, of scaling     ends, diagonals
 *   cells as a middle and half a length                      ends
 */
#include "scenes.h"

static const uint64_t seed = 20250923;

typedef struct box {
    double lo[3], hi[3];
    int empty;
} box;

static box enclosed(const algsurf_surface *surface, const algsurf_extent *extent, algsurf_part part) {
    box b = {.empty = -1};
    assert_ok(algsurf_surface_enclose(surface, extent, part, 1.0 / 16, b.lo, b.hi, &b.empty));
    assert_true(b.empty == 0 || b.empty == 1);
    for (int i = 0; i < 3 && !b.empty; i++) assert_true(b.lo[i] <= b.hi[i]);
    return b;
}

static int holds(const box *b, const double p[3], double slack) {
    int inside = !b->empty;
    for (int i = 0; i < 3; i++) inside &= p[i] >= b->lo[i] - slack && p[i] <= b->hi[i] + slack;
    return inside;
}

/* ---- random surfaces, random rays ---- */

static algsurf_surface *random_surface(uint64_t *state) {
    algsurf_term terms[24];
    int degree = 1 + (int)(random_bits(state) % 12), count = 3 + (int)(random_bits(state) % 20);
    algsurf_surface *surface;
    for (int k = 0; k < count; k++) {
        int left = (int)(random_bits(state) % (unsigned)(degree + 1)),
            i = (int)(random_bits(state) % (unsigned)(left + 1));
        int j = (int)(random_bits(state) % (unsigned)(left - i + 1));
        terms[k] = (algsurf_term){i, j, left - i - j, random_unit(state)};
    }
    return algsurf_surface_from_terms(terms, (size_t)count, &surface) == ALGSURF_OK ? surface : NULL;
}

static algsurf_extent random_extent(uint64_t *state) {
    algsurf_extent e = {.kind = random_bits(state) % 2 ? ALGSURF_EXTENT_SPHERE : ALGSURF_EXTENT_BOX};
    for (int i = 0; i < 3; i++) {
        e.centre[i] = 2 * random_unit(state);
        e.size[i] = 0.1 + 2 * fabs(random_unit(state));
    }
    return e;
}

/* Hits of a ray through a random point of the extent's neighbourhood are in the box; returns how many. */
static int check_ray(const algsurf_surface *surface, const algsurf_extent *extent, const box *b,
                     uint64_t *state) {
    algsurf_ray ray = {.t_min = -INFINITY, .t_max = INFINITY};
    algsurf_hit hits[ALGSURF_MAX_DEGREE];
    int count = 0;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = extent->centre[i] + random_unit(state);
        ray.direction[i] = random_unit(state);
    }
    algsurf_status status =
        algsurf_intersect_all(surface, extent, &ray, NULL, hits, ALGSURF_MAX_DEGREE, &count);
    assert_true(status >= 0);
    for (int k = 0; k < count; k++) {
        if (hits[k].state != ALGSURF_STATE_HIT || holds(b, hits[k].position, 1e-12)) continue;
        fail_msg("seed %llu: a hit at %a %a %a is outside of the box", (unsigned long long)seed,
                 hits[k].position[0], hits[k].position[1], hits[k].position[2]);
    }
    return count;
}

TEST(hits) {
    uint64_t random = seed;
    int found = 0, empty = 0, smaller = 0;
    for (int turn = 0; turn < 100; turn++) {
        algsurf_surface *surface = random_surface(&random);
        if (!surface) continue;
        const algsurf_extent extent = random_extent(&random);
        const box b = enclosed(surface, &extent, ALGSURF_PART_ALL);
        empty += b.empty;
        smaller += !b.empty && b.hi[0] - b.lo[0] < 1.5 * extent.size[0];
        for (int k = 0; k < 40; k++) found += check_ray(surface, &extent, &b, &random);
        algsurf_surface_free(surface);
    }
    assert_true(found > 500 && empty > 2 && smaller > 2);
}

/* ---- points, which rounding may lose ---- */

static double coordinate(uint64_t *state, int bits) {
    return (double)(int64_t)(random_bits(state) >> (64 - bits));
}

/* (x-a)^2 + m (y-b)^2 + (z-c)^2: one point, where all terms cancel. */
static void point_terms(const double p[3], double m, double sign_z, algsurf_term terms[7]) {
    const double w[3] = {1, m, sign_z};
    terms[0] = (algsurf_term){0, 0, 0, w[0] * p[0] * p[0] + w[1] * p[1] * p[1] + w[2] * p[2] * p[2]};
    for (int i = 0; i < 3; i++) {
        terms[1 + i] = (algsurf_term){i == 0, i == 1, i == 2, -2 * w[i] * p[i]};
        terms[4 + i] = (algsurf_term){2 * (i == 0), 2 * (i == 1), 2 * (i == 2), w[i]};
    }
}

static void check_point(const algsurf_surface *surface, const double p[3], algsurf_part part, double most) {
    const algsurf_extent extent = {ALGSURF_EXTENT_BOX, {p[0] + 0.3, p[1] - 0.4, p[2] + 0.1}, {1, 1, 1}};
    const box b = enclosed(surface, &extent, part);
    if (!holds(&b, p, 0)) fail_msg("the point %a %a %a is lost", p[0], p[1], p[2]);
    for (int i = 0; i < 3; i++) assert_true(b.hi[i] - b.lo[i] < most);
}

/* Points with coordinates of 14 bits: squares, and sums of them, are doubles. */
static void check_points(uint64_t random, double sign_z, algsurf_part part, int turns) {
    for (int turn = 0; turn < turns; turn++) {
        double p[3];
        algsurf_term terms[7];
        for (int i = 0; i < 3; i++) p[i] = ldexp(coordinate(&random, 1 + turn % 14), -(turn % 7));
        point_terms(p, 3, sign_z, terms);
        algsurf_surface *surface = surface_of_terms(terms, 7);
        check_point(surface, p, part, 0.5);
    }
}

TEST(points) { check_points(seed + 1, 1, ALGSURF_PART_ALL, 140); }

/* The tips of cones. */
TEST(tips) { check_points(seed + 2, -1, ALGSURF_PART_SINGULAR, 70); }

/* A surface that stands for others has their points in its box. */
TEST(approximate) {
    algsurf_surface *unit = surface_of("x^2 + y^2 + z^2 - 1"), *about;
    const algsurf_extent extent = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {2, 2, 2}};
    about = surface_with_error(unit, 0.125);
    const box b = enclosed(about, &extent, ALGSURF_PART_ALL);
    const double farthest[3] = {sqrt(1.125 / 0.875), 0, 0}, nearest[3] = {0, 0, -farthest[0]};
    assert_true(holds(&b, farthest, 0) && holds(&b, nearest, 0));
}

/* ---- ends, against rationals ---- */

static int below(double a, const mpq_t b) { return exact_between(a, b, HUGE_VAL); }
static int above(double a, const mpq_t b) { return exact_between(-HUGE_VAL, b, a); }

/* centre + side size is in the box, along an axis; the sum is exact. */
static void check_end(const box *b, const algsurf_extent *e, int axis, const char *what) {
    mpq_t lo, hi, size;
    mpq_inits(lo, hi, size, NULL);
    exact_set(size, e->size[e->kind == ALGSURF_EXTENT_BOX ? axis : 0]);
    exact_set(lo, e->centre[axis]), exact_set(hi, e->centre[axis]);
    mpq_sub(lo, lo, size), mpq_add(hi, hi, size);
    if (!below(b->lo[axis], lo) || !above(b->hi[axis], hi))
        fail_msg("%s: %a +- %a along %d, not %a .. %a", what, e->centre[axis], mpq_get_d(size), axis,
                 b->lo[axis], b->hi[axis]);
    mpq_clears(lo, hi, size, NULL);
}

/* The plane a x = b in a box, or through the centre of a sphere: its point of the x axis, if that is in the
 * box, and the extent's ends in y and z. */
static int check_plane(double a, double b, const algsurf_extent *e) {
    const algsurf_term terms[2] = {{1, 0, 0, a}, {0, 0, 0, -b}};
    mpq_t root, off, size;
    mpq_inits(root, off, size, NULL);
    exact_set(root, a), exact_set(off, b), mpq_div(root, off, root);
    exact_set(off, e->centre[0]), mpq_sub(off, root, off), mpq_abs(off, off), exact_set(size, e->size[0]);
    int inside = e->kind == ALGSURF_EXTENT_BOX ? mpq_cmp(off, size) <= 0 : mpq_sgn(off) == 0;
    algsurf_surface *surface = surface_of_terms(terms, b == 0 ? 1 : 2);
    const box found = enclosed(surface, e, ALGSURF_PART_ALL);
    if (inside) {
        char what[200];
        (void)snprintf(what, sizeof what, "seed %llu, %a x = %a, kind %d", (unsigned long long)seed, a, b,
                       e->kind);
        if (found.empty || !below(found.lo[0], root) || !above(found.hi[0], root))
            fail_msg("%s: not in %a .. %a", what, found.lo[0], found.hi[0]);
        check_end(&found, e, 1, what), check_end(&found, e, 2, what);
    }
    mpq_clears(root, off, size, NULL);
    return inside;
}

/* Planes of all sizes, extents down to an ulp of their centre, and to the least and largest doubles. */
TEST(ends) {
    uint64_t random = seed + 3;
    int inside = 0;
    (void)check_plane(10, 9, &(algsurf_extent){ALGSURF_EXTENT_BOX, {1, 1, 1}, {0.1, 0.1, 0.1}});
    (void)check_plane(10, 1e10 - 3, &(algsurf_extent){ALGSURF_EXTENT_BOX, {1e9, 1, 1e17}, {1, 0.1, 0.3}});
    for (int turn = 0; turn < 200; turn++) {
        int scale = random_int(&random, 2080) - 1070, fine = random_int(&random, 60);
        algsurf_extent e = {.kind = turn % 2 ? ALGSURF_EXTENT_SPHERE : ALGSURF_EXTENT_BOX};
        for (int i = 0; i < 3; i++) {
            e.centre[i] = ldexp(random_unit(&random), scale);
            e.size[i] = fmax(0x1p-1074, ldexp(0.1 + fabs(random_unit(&random)), scale - fine));
        }
        double a = turn % 2 ? 1 : 1 + random_int(&random, 99), half = 0.9 * random_unit(&random);
        inside += check_plane(a, turn % 2 ? e.centre[0] : a * (e.centre[0] + half * e.size[0]), &e);
    }
    if (inside < 150) fail_msg("only %d of 200 are inside", inside);
}

/* x = y: each end of the box, where a cell is an ulp long. */
TEST(diagonals) {
    static const double places[] = {1, 1e20, -1e300, 0x1p1023, 1e-300, 0x1p-1070};
    algsurf_surface *surface = surface_of("x = y");
    for (int k = 0; k < 6; k++)
        for (int fine = 0; fine < 60; fine += 3) {
            const double c = places[k], size = fmax(0x1p-1074, ldexp(0.75 * fabs(c), -fine));
            const algsurf_extent e = {ALGSURF_EXTENT_BOX, {c, c, -c}, {size, size, size}};
            const box b = enclosed(surface, &e, ALGSURF_PART_ALL);
            assert_int_equal(b.empty, 0);
            for (int i = 0; i < 3; i++) check_end(&b, &e, i, "x = y");
        }
}

/* ---- boxes that are known ---- */

static void check_known(const char *equation, algsurf_part part, double size, const double lo[3],
                        const double hi[3], double slack) {
    algsurf_surface *surface = surface_of(equation);
    const algsurf_extent extent = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {size, size, size}};
    const box b = enclosed(surface, &extent, part);
    assert_int_equal(b.empty, 0);
    for (int i = 0; i < 3; i++) {
        double room = slack * fmax(hi[0] - lo[0], fmax(hi[1] - lo[1], hi[2] - lo[2])) + 1e-5;
        if (!(b.lo[i] <= lo[i] && b.lo[i] >= lo[i] - room && b.hi[i] >= hi[i] && b.hi[i] <= hi[i] + room))
            fail_msg("%s: %g..%g, not %g..%g", equation, b.lo[i], b.hi[i], lo[i], hi[i]);
    }
}

TEST(known) {
    check_known("(x^2 + 9/4 y^2 + z^2 - 1)^3 = x^2 z^3 + 9/80 y^2 z^3", ALGSURF_PART_ALL, 1.5,
                (double[]){-1.1390, -0.6936, -1}, (double[]){1.1390, 0.6936, 1.2361}, 1.0 / 16);
    check_known("x^2 + y^2 + z^2 = 9", ALGSURF_PART_ALL, 100, (double[]){-3, -3, -3}, (double[]){3, 3, 3},
                0.1);
    check_known("9 = x^2 + y^2 + z^2", ALGSURF_PART_ALL, 100, (double[]){-3, -3, -3}, (double[]){3, 3, 3},
                0.1);
    check_known("(x-50)^2 + y^2 + z^2 = 1", ALGSURF_PART_ALL, 1000, (double[]){49, -1, -1},
                (double[]){51, 1, 1}, 0.1);
    check_known("x^2 + y^2 + z^2 = 1000000", ALGSURF_PART_ALL, 1e5, (double[]){-1e3, -1e3, -1e3},
                (double[]){1e3, 1e3, 1e3}, 0.1);
    check_known("x^4 + y^4 + z^4 = 1", ALGSURF_PART_ALL, 20, (double[]){-1, -1, -1}, (double[]){1, 1, 1},
                0.25);
    check_known("z = x y", ALGSURF_PART_ALL, 3, (double[]){-3, -3, -3}, (double[]){3, 3, 3}, 0);
    check_known("(x-1)^2 + (y-2)^2 - (z-3)^2", ALGSURF_PART_SINGULAR, 10, (double[]){1, 2, 3},
                (double[]){1, 2, 3}, 0.01);
}

TEST(nothing) {
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {10, 0, 0}};
    const char *const equations[] = {"x^2 + y^2 + z^2 + 1", "x^2 + y^2 + z^2 = 130", "z - 11 = 0", "7 = 0"};
    for (int k = 0; k < 4; k++) {
        algsurf_surface *surface = surface_of(equations[k]);
        assert_int_equal(enclosed(surface, &extent, ALGSURF_PART_ALL).empty, 1);
    }
    algsurf_surface *ball = surface_of("x^2 + y^2 + z^2 = 9");
    assert_int_equal(enclosed(ball, &extent, ALGSURF_PART_SINGULAR).empty, 1);
}

TEST(bad_arguments) {
    algsurf_surface *surface = surface_of("x^2 + y^2 + z^2 - 1");
    algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}};
    double lo[3] = {7, 7, 7}, hi[3] = {8, 8, 8};
    int empty = 5;
#define REFUSED(status, ...) assert_int_equal(algsurf_surface_enclose(__VA_ARGS__), ALGSURF_E_##status)
    REFUSED(ARGUMENT, NULL, &extent, 0, 0.1, lo, hi, &empty);
    REFUSED(ARGUMENT, surface, NULL, 0, 0.1, lo, hi, &empty);
    REFUSED(ARGUMENT, surface, &extent, 0, 0.1, NULL, hi, &empty);
    REFUSED(ARGUMENT, surface, &extent, 0, 0.1, lo, NULL, &empty);
    REFUSED(ARGUMENT, surface, &extent, 0, 0.1, lo, hi, NULL);
    REFUSED(ARGUMENT, surface, &extent, 2, 0.1, lo, hi, &empty);
    REFUSED(ARGUMENT, surface, &extent, (algsurf_part)-1, 0.1, lo, hi, &empty);
    REFUSED(ARGUMENT, surface, &extent, 0, 0, lo, hi, &empty);
    REFUSED(ARGUMENT, surface, &extent, 0, 1.5, lo, hi, &empty);
    REFUSED(NOT_FINITE, surface, &extent, 0, NAN, lo, hi, &empty);
    extent.size[0] = 0;
    REFUSED(ARGUMENT, surface, &extent, 0, 0.1, lo, hi, &empty);
    extent.size[0] = INFINITY;
    REFUSED(NOT_FINITE, surface, &extent, 0, 0.1, lo, hi, &empty);
    extent.kind = ALGSURF_EXTENT_ALL;
    REFUSED(ARGUMENT, surface, &extent, 0, 0.1, lo, hi, &empty);
#undef REFUSED
    assert_true(lo[0] == 7 && hi[2] == 8 && empty == 5);
}
