/* test_intersect_edges.c - where the surface and the extent's surface all but share a
 * point of the ray: a root within some units in the last place of where the ray enters or leaves the extent.
 *
 * The surface is two planes k x = m, and a factor without roots, so that the roots are rational numbers; the
 * extent is made to end there, up to rounding.  Which roots are in it is decided over the rationals.
 *
 * Breaks caught, each tried: no margin, a negative one, edges not looked at, only the first or only the last
 * looked at, a middle coefficient of the faces wrong, their signs turned, one of the box's left out; doubt
 * told as a hit or passed over where it is to be reported, and the other way round.
 */
#include "intersect_case.h"

#include "rays/exact_ray.h"

#define SEED 71u

enum { ROUNDS = 1500, PLANES = 2 };

typedef struct edge_case {
    intersect_case c;
    algsurf_extent extent;
    mpq_t root[PLANES]; /* in increasing order of t */
    int sign[PLANES];   /* 1: inside the extent, -1: outside, 0: on its surface */
} edge_case;

static _Noreturn void refuse(const edge_case *e, const intersect_answer *a, const char *what, int round) {
    for (int i = 0; i < PLANES; i++) exact_print(e->sign[i] > 0 ? "inside" : "outside", e->root[i]);
    exact_print_doubles("centre", e->extent.centre, 3), exact_print_doubles("size", e->extent.size, 3);
    fprintf(stderr, "seed %u, round %d, extent of kind %d\n", SEED, round, (int)e->extent.kind);
    intersect_fail(what, &e->c, a);
}

/* distance = o_i + t d_i - c_i. */
static void from_centre(mpq_t distance, const edge_case *e, const mpq_t t, int axis) {
    mpq_t q;
    mpq_init(q);
    exact_set(q, e->c.ray.direction[axis]);
    mpq_mul(distance, q, t);
    exact_set(q, e->c.ray.origin[axis]);
    mpq_add(distance, distance, q);
    exact_set(q, e->extent.centre[axis]);
    mpq_sub(distance, distance, q);
    mpq_clear(q);
}

/* square = |X - c|^2, or the square of one axis of it. */
static void squared(mpq_t square, const edge_case *e, const mpq_t t, int axis) {
    mpq_t q;
    mpq_init(q);
    mpq_set_ui(square, 0, 1);
    for (int i = 0; i < 3; i++) {
        if (axis >= 0 && i != axis) continue;
        from_centre(q, e, t, i);
        mpq_mul(q, q, q);
        mpq_add(square, square, q);
    }
    mpq_clear(q);
}

static int sign_at(const edge_case *e, const mpq_t t) {
    int sign = 1, box = e->extent.kind == ALGSURF_EXTENT_BOX;
    mpq_t square, size;
    mpq_inits(square, size, NULL);
    for (int i = 0; i < (box ? 3 : 1); i++) {
        squared(square, e, t, box ? i : -1);
        exact_set(size, e->extent.size[i]);
        mpq_mul(size, size, size);
        int one = mpq_cmp(size, square);
        one = (one > 0) - (one < 0);
        sign = one < sign ? one : sign;
    }
    mpq_clears(square, size, NULL);
    return sign;
}

static double short_number(uint64_t *seed) { return ldexp(floor(64 * random_unit(seed)), -4); }

/* A ray, and planes that it meets at positive t. */
static int make_planes(edge_case *e, uint64_t *seed) {
    char text[200];
    int k[PLANES], m[PLANES];
    mpq_t q;
    for (int i = 0; i < 3; i++) {
        e->c.ray.origin[i] = random_int(seed, 2) ? short_number(seed) : 4 * random_unit(seed);
        e->c.ray.direction[i] = random_int(seed, 5) ? random_unit(seed) : 0;
        e->extent.centre[i] = random_int(seed, 2) ? 0 : short_number(seed);
    }
    if (e->c.ray.direction[0] == 0) e->c.ray.direction[0] = 0.75;
    if (random_int(seed, 4) == 0) /* from far away */
        for (int i = 0; i < 3; i++) e->c.ray.origin[i] -= 1e6 * e->c.ray.direction[i];
    e->c.ray.t_min = 0, e->c.ray.t_max = INFINITY;
    mpq_init(q);
    for (int i = 0; i < PLANES; i++) {
        k[i] = 1 + random_int(seed, 9), m[i] = random_int(seed, 40) - 20;
        mpq_set_si(e->root[i], m[i], (unsigned long)k[i]);
        mpq_canonicalize(e->root[i]);
        exact_set(q, e->c.ray.origin[0]);
        mpq_sub(e->root[i], e->root[i], q);
        exact_set(q, e->c.ray.direction[0]);
        mpq_div(e->root[i], e->root[i], q);
    }
    mpq_clear(q);
    if (mpq_cmp(e->root[0], e->root[1]) > 0) mpq_swap(e->root[0], e->root[1]);
    if (mpq_sgn(e->root[0]) < 0 || mpq_equal(e->root[0], e->root[1])) return 0;
    snprintf(text, sizeof text, "(%d x - (%d)) (%d x - (%d)) (x^2 + y^2 + z^2 + 1)", k[0], m[0], k[1], m[1]);
    intersect_equation(&e->c, text);
    return 1;
}

static double some_ulps_from(double x, uint64_t *seed) {
    for (int step = random_int(seed, 5) - 2; step != 0; step += step > 0 ? -1 : 1)
        x = nextafter(x, step > 0 ? INFINITY : -INFINITY);
    return x;
}

/* Ends at one of the roots. */
static int make_extent(edge_case *e, uint64_t *seed) {
    int box = random_int(seed, 2), axis = box ? random_int(seed, 3) : -1;
    mpq_t square;
    mpq_init(square);
    squared(square, e, e->root[random_int(seed, PLANES)], axis);
    double size = some_ulps_from(sqrt(mpq_get_d(square)), seed);
    mpq_clear(square);
    e->extent.kind = box ? ALGSURF_EXTENT_BOX : ALGSURF_EXTENT_SPHERE;
    for (int i = 0; i < 3; i++) e->extent.size[i] = box ? 1 + 60 * fabs(random_unit(seed)) : 0;
    e->extent.size[box ? axis : 0] = size;
    for (int i = 0; i < PLANES; i++) e->sign[i] = sign_at(e, e->root[i]);
    return size > 0;
}

/* Real space as a part of complex space: the same first hit. */
static void judge_complex(const edge_case *e, int round) {
    const algsurf_complex_space space = {.size = sizeof space};
    intersect_answer a = {.count = 0};
    int first = 0;
    while (first < PLANES && e->sign[first] < 0) first++;
    assert_ok(
        algsurf_intersect_complex(e->c.surface, &e->extent, &e->c.ray, &space, NULL, NULL, &a.first, NULL));
    if (a.first.state != (first < PLANES ? ALGSURF_STATE_HIT : ALGSURF_STATE_MISS))
        refuse(e, &a, "in complex space", round);
    if (first < PLANES && !exact_between(a.first.t_lo, e->root[first], a.first.t_hi))
        refuse(e, &a, "not enclosed in complex space", round);
}

/* The answers, against the oracle's, which must agree with what is known here. */
static void judge(const edge_case *e, int round, int *ties) {
    intersect_answer a;
    int wanted = 0;
    intersect_judge_in(&e->c, &e->extent, NULL, &a);
    for (int i = 0; i < PLANES; i++) {
        if (e->sign[i] < 0) continue;
        if (wanted == a.count) refuse(e, &a, "a root in the extent is missing", round);
        if (!exact_between(a.all[wanted].t_lo, e->root[i], a.all[wanted].t_hi))
            refuse(e, &a, "not enclosed", round);
        wanted++;
    }
    if (wanted < a.count) refuse(e, &a, "a root outside of the extent", round);
    judge_complex(e, round);
    *ties += e->sign[0] == 0 || e->sign[1] == 0;
}

TEST(roots_at_the_edge) {
    uint64_t seed = SEED;
    int rounds = 0, ties = 0, inside = 0;
    static edge_case e;
    mpq_inits(e.root[0], e.root[1], NULL);
    for (int i = 0; i < ROUNDS; i++) {
        if (!make_planes(&e, &seed)) continue;
        if (make_extent(&e, &seed)) {
            judge(&e, i, &ties);
            rounds++, inside += e.sign[0] > 0 || e.sign[1] > 0;
        }
    }
    mpq_clears(e.root[0], e.root[1], NULL);
    if (rounds < ROUNDS / 3 || ties * 5 > rounds || inside * 10 < rounds || inside * 10 > rounds * 9)
        fail_msg("seed %u: %d rounds, %d ties, %d inside", SEED, rounds, ties, inside);
}

/* Extents as large as the largest double, or a little smaller, and planes that the ray meets at their very
 * end: no margin can be added to such a size. */
TEST(largest_extents) {
    uint64_t seed = SEED;
    int hits = 0, misses = 0;
    for (int i = 0; i < 2000; i++) {
        static intersect_case c;
        intersect_answer a;
        int box = random_int(&seed, 2), axis = random_int(&seed, 3), exponents[3] = {0};
        double size = DBL_MAX * (1 - (random_int(&seed, 3) ? 0 : 0x1p-40 * fabs(random_unit(&seed))));
        algsurf_extent extent = {box ? ALGSURF_EXTENT_BOX : ALGSURF_EXTENT_SPHERE, {0}, {size, size, size}};
        double length = 0, large = random_int(&seed, 3) ? 0 : 0x1p1021;
        for (int k = 0; k < 3; k++) {
            c.ray.origin[k] = (large > 0 ? large : 1) * random_unit(&seed);
            c.ray.direction[k] = random_unit(&seed);
            extent.centre[k] = large * random_unit(&seed);
            length = box ? fmax(length, fabs(c.ray.direction[k])) : hypot(length, c.ray.direction[k]);
        }
        double sign = c.ray.direction[axis] < 0 ? -1 : 1, share = fabs(c.ray.direction[axis]) / length;
        double at = 1 + 0x1p-52 * (random_int(&seed, 5) - 2);
        if (large > 0) at = random_unit(&seed);
        exponents[axis] = 1;
        const algsurf_term terms[] = {{exponents[0], exponents[1], exponents[2], 1},
                                      {0, 0, 0, -sign * fmin(share * at, 1) * DBL_MAX}};
        c.ray.t_min = random_int(&seed, 2) ? 0 : -INFINITY, c.ray.t_max = INFINITY;
        assert_true(intersect_terms(&c, terms, 2));
        intersect_judge_in(&c, &extent, NULL, &a);
        hits += a.count > 0, misses += a.count == 0;
    }
    if (hits < 100 || misses < 50) fail_msg("seed %u: %d hits, %d misses", SEED, hits, misses);
}

/* Lines that all but touch the extent, which the surface z = y crosses where they are nearest to its centre.
 */
TEST(grazing_lines) {
    static const struct {
        double height, radius;
        int sphere, box;
    } cases[] = {
        {1, 1, ALGSURF_STATE_HIT,
         ALGSURF_STATE_HIT}, /* touches the sphere at the root; is in a face of the box */
        {0x1.0000000000001p0, 1, ALGSURF_STATE_MISS, ALGSURF_STATE_MISS},
        {0x1.fffffffffffffp-1, 1, ALGSURF_STATE_HIT, ALGSURF_STATE_HIT},
        {1, 0x1.0000000000001p0, ALGSURF_STATE_HIT, ALGSURF_STATE_HIT},
        {1, 0x1.fffffffffffffp-1, ALGSURF_STATE_MISS, ALGSURF_STATE_MISS},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int kind = ALGSURF_EXTENT_SPHERE; kind <= ALGSURF_EXTENT_BOX; kind++) {
            intersect_answer a;
            static intersect_case c;
            const algsurf_extent extent = {
                (int)kind, {0, 0, 0}, {cases[i].radius, cases[i].radius, cases[i].radius}};
            int wanted = kind == ALGSURF_EXTENT_SPHERE ? cases[i].sphere : cases[i].box;
            intersect_equation(&c, "x + x^3");
            c.ray = (algsurf_ray){{-4, 0, cases[i].height}, {1, 0, 0}, 0, INFINITY};
            intersect_judge_in(&c, &extent, NULL, &a);
            if (a.first.state != wanted || a.count != (wanted != ALGSURF_STATE_MISS))
                intersect_fail("grazing", &c, &a);
        }
}

/* Cases that were wrong: a first entry that dissolves while a later one is at an edge; extents near the
 * largest double; a ray in the surface of which one point is in the extent; a chord that is one point; a long
 * box. */
TEST(found_before) {
    const int ball = ALGSURF_EXTENT_SPHERE, box = ALGSURF_EXTENT_BOX;
    const double inf = INFINITY;
    const struct {
        const char *equation;
        algsurf_ray ray;
        algsurf_extent extent;
        int count, multiplicity; /* of the first */
    } cases[] = {
        {"(x^2 - 1)(y - 1)",
         {{1, -1.5, -1.75}, {-0.875, -0.75, -0.625}, 0x1p-300, inf},
         {ball, {0, 0, 0}, {0x1.284e77c9b63e6p+2}},
         0,
         0},
        {"x - 1", {{0, 1, 0}, {1, 0, 0}, -inf, inf}, {ball, {0, 0, 0}, {DBL_MAX}}, 1, 1},
        {"(3x - 1)(3x - 1 - y)", {{0, 0x1p-30, 0}, {1, 0, 0}, 0, inf}, {box, {0, 0, 0}, {1e301, 2, 2}}, 2, 1},
        {"(3x - 1)^2 (3x - 1 - y)", {{0, 0x1p-30, 0}, {1, 0, 0}, 0, 4}, {ball, {0, 0, 0}, {9}}, 2, 2},
        {"x", {{0, 1, 0}, {0, 1, 0}, 0, inf}, {ball, {0, 0, 0}, {1}}, 1, 0},
        {"x", {{0, 1, 0}, {0, 1, 0}, 0, inf}, {box, {0, 0, 0}, {1, 1, 1}}, 1, 0},
        {"x - 1/2", {{0, 0, 0}, {1, 0, 0}, 0.5, 0.5}, {ball, {0, 0, 0}, {0.5}}, 1, 1},
        {"x", {{0, 0, 0}, {1, 0, 0}, 0, inf}, {box, {0, 0, 0}, {1e15, 1, 1}}, 1, 1},
        {"x - 0x1.4e147ae147ae1p-70",
         {{0, 0, 0}, {0x1p1000, 0, 0}, 0, inf},
         {ball, {0, 0, 0}, {0x1.48f5c28f5c28fp-70}},
         0,
         0},
        {"y + 0x1.8b34a28380358p+1023",
         {{0x1.fd470a1b0fdb2p-1, 0x1.464ab478a911p-3, -0x1.f7e7de227d73p-2},
          {-0x1.2987f0be74c9p-4, -0x1.b4f210b67f38p-1, -0x1.65f6355d44a66p-1},
          0,
          inf},
         {ball, {0, 0, 0}, {DBL_MAX}},
         1,
         1},
        {"x^2", {{5, 0, 0}, {0x1p-1074, 0, 0}, -inf, inf}, {ALGSURF_EXTENT_ALL, {0, 0, 0}, {0}}, 1, 2},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        static intersect_case c;
        intersect_answer a;
        intersect_equation(&c, cases[i].equation);
        c.ray = cases[i].ray;
        intersect_judge_in(&c, &cases[i].extent, NULL, &a);
        if (a.count != cases[i].count || a.first.multiplicity != cases[i].multiplicity)
            intersect_fail(cases[i].equation, &c, &a);
    }
}

/* With coefficients that are not exact, edges far from a root do not make it undecided. */
TEST(a_long_box) {
    const algsurf_extent extent = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1e15, 1, 1}};
    static intersect_case c;
    intersect_answer a;
    intersect_equation(&c, "x - 1");
    c.surface = surface_with_error(c.surface, 1e-10);
    c.ray = (algsurf_ray){{0, 0, 0}, {1, 0, 0}, 0, INFINITY};
    intersect_ask(&c, &extent, NULL, &a);
    if (a.first.state != ALGSURF_STATE_HIT || a.count != 1) intersect_fail("a long box", &c, &a);
}

/* Along this ray x = t - 3/2, y is a unit in the last place of t there, z far less: roots at 0, at k y, and z
 * beside each, which only parts of their own tell apart. */
static const algsurf_ray beside = {{-1.5, 0x1p-52, 0x1p-100}, {1, 0, 0}, -INFINITY, INFINITY};

/* A root at 3/2 + k y + hairs z. */
typedef struct hair {
    int k, hairs;
} hair;

static int in_order(const void *left, const void *right) {
    const hair *a = left, *b = right;
    return a->k != b->k ? a->k - b->k : a->hairs - b->hairs;
}

static double step(int k) { return 1.5 + k * 0x1p-52; }

/* Is the root in [lo,hi], t's ends? */
static int hair_between(hair h, double lo, double hi) {
    return (h.hairs < 0 ? lo < step(h.k) : lo <= step(h.k)) &&
           (h.hairs > 0 ? hi > step(h.k) : hi >= step(h.k));
}

/* Each root in [lo,hi] is found once, in its order. */
static void find_hairs(const algsurf_surface *surface, hair *roots, int count, double lo, double hi) {
    algsurf_i_ray_root found[8];
    static const algsurf_i_region everywhere = {NULL, NULL, 0};
    algsurf_ray ray = beside;
    int next = 0, n = 0, side;
    ray.t_min = lo, ray.t_max = hi;
    assert_ok(algsurf_i_exact_roots(surface, &everywhere, &ray,
                                    &(algsurf_i_wanted){ALGSURF_WANT_ALL, .limit = ALGSURF_DEFAULT_MEMORY},
                                    found, &n, &side));
    qsort(roots, (size_t)count, sizeof *roots, in_order);
    for (int i = 0; i < count; i++) {
        if (!hair_between(roots[i], lo, hi)) continue;
        if (next >= n || found[next].multiplicity < 1 ||
            !hair_between(roots[i], found[next].t_lo, found[next].t_hi))
            fail_msg("[%a, %a]: the root at %a + %d z is not number %d of %d", lo, hi, step(roots[i].k),
                     roots[i].hairs, next, n);
        next++;
    }
    if (next != n) fail_msg("[%a, %a]: %d roots, %d found", lo, hi, next, n);
}

/* A place that is set apart ends some doubles before and behind its two roots, and what is beside it begins
 * there.  A root at each double around them, by itself or with two more behind it, before it, or a place
 * further on, which are set apart in their turn; and intervals that begin or end at one of these doubles. */
TEST(ends_of_parts) {
    enum { AROUND = 6 };
    static const hair more[] = {{0, 0}, {0, 1}, {0, -1}, {AROUND, 1}}; /* from that root on; 0: none */
    for (int k = -AROUND; k <= AROUND; k++)
        for (int i = 0; i < 4; i++) {
            char text[200], pair[100] = "";
            static intersect_case c;
            int at = k + more[i].k, side = more[i].hairs, count = side ? 5 : 3;
            hair roots[] = {{0, 1}, {0, 2}, {k, 0}, {at, side}, {at, 2 * side}};
            if (at == 0 && side == 1) continue; /* the same two once more */
            if (side)
                (void)snprintf(pair, sizeof pair, "(x - (%d) y - (%d) z)(x - (%d) y - (%d) z)", at, side, at,
                               2 * side);
            (void)snprintf(text, sizeof text, "(x - z)(x - 2 z)(x - (%d) y) %s", k, pair);
            intersect_equation(&c, text);
            find_hairs(c.surface, roots, count, 1.25, 1.75);
            for (int end = -AROUND; end <= AROUND; end++) {
                find_hairs(c.surface, roots, count, step(end), 1.75);
                find_hairs(c.surface, roots, count, 1.25, step(end));
            }
        }
}

/* ---- the bounded tier, and what becomes of the undecided ---- */

/* Which of the roots the first hit encloses; PLANES: none. */
static int root_of(const edge_case *e, const algsurf_hit *h) {
    int i = 0;
    while (i < PLANES && !exact_between(h->t_lo, e->root[i], h->t_hi)) i++;
    return i;
}

/* What is told of the first hit: a root in the extent, and the first. */
static const char *judge_first(const edge_case *e, const algsurf_hit *h) {
    if (h->state == ALGSURF_STATE_UNDECIDED) return NULL;
    int told = h->state == ALGSURF_STATE_HIT ? root_of(e, h) : PLANES;
    if (h->state == ALGSURF_STATE_HIT && told == PLANES) return "no root is there";
    for (int i = 0; i < told; i++)
        if (e->sign[i] >= 0) return "a root in the extent is missing";
    return told < PLANES && e->sign[told] < 0 ? "a root outside of the extent" : NULL;
}

/* Roots just inside, just outside, and on the extent's surface. */
static void judge_bounded(const edge_case *e, int round, int *undecided) {
    static const int becomes[] = {ALGSURF_STATE_UNDECIDED, ALGSURF_STATE_HIT, ALGSURF_STATE_MISS};
    intersect_answer report = {.count = 0}, a;
    for (int as = ALGSURF_AS_UNDECIDED; as <= ALGSURF_AS_MISS; as++) {
        const algsurf_intersect_options how = {
            .size = sizeof how, .tier = ALGSURF_TIER_BOUNDED, .undecided_as = as};
        intersect_ask(&e->c, &e->extent, &how, &a);
        if (as == ALGSURF_AS_UNDECIDED) report = a;
        const char *wrong = intersect_wrong_packet(&e->c, &e->extent, &how, &a);
        if (!wrong && as == ALGSURF_AS_UNDECIDED) wrong = judge_first(e, &a.first);
        int open = report.first.state == ALGSURF_STATE_UNDECIDED;
        if (a.first.state != (open ? becomes[as] : report.first.state))
            wrong = "what becomes of the undecided";
        open = report.occluded == ALGSURF_STATE_UNDECIDED;
        if ((int)a.occluded != (open ? becomes[as] : (int)report.occluded)) wrong = "occluded, undecided";
        if (wrong) refuse(e, &a, wrong, round);
    }
    *undecided += report.first.state == ALGSURF_STATE_UNDECIDED;
}

TEST(undecided_at_the_edge) {
    uint64_t seed = SEED + 1;
    int undecided = 0, rounds = 0;
    static edge_case e;
    mpq_inits(e.root[0], e.root[1], NULL);
    for (int i = 0; i < ROUNDS; i++) {
        if (!make_planes(&e, &seed)) continue;
        if (make_extent(&e, &seed)) {
            judge_bounded(&e, i, &undecided);
            rounds++;
        }
    }
    mpq_clears(e.root[0], e.root[1], NULL);
    if (undecided * 10 < rounds || undecided == rounds)
        fail_msg("seed %u: %d rounds, %d undecided", SEED, rounds, undecided);
}
