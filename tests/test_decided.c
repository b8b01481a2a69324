/* test_decided.c - every ray is decided: families of rays at which doubles, whatever their bounds, fail.
 *
 * Each family generates rays; first, all, occluded and the packet calls must agree, leave nothing undecided,
 * and say what the oracle for hits (exact_hits.h) says: how many roots, where, of which multiplicity, and
 * from which side.  Each demands a minimum of what it is made for, so that it cannot become empty.
 *
 * Breaks caught, each tried: a root on the extent's surface left out, a multiplicity from the squarefree part
 * alone, a side without regard to it, a packet's multiplicity not written, an overflown end of the extent
 * taken for one without end.
 *
 *     test_decided [rounds [seed]]     default: 1 and 59
 */

#include "intersect_case.h"

#include "catalogue.h"

ARGUMENT(1, int, rounds, 1)
ARGUMENT(2, uint64_t, first_seed, 59)

static intersect_case c;
static intersect_answer answer;

static struct {
    const char *family;
    uint64_t seed;
    int rays, hits, misses, multiple, in_surface;
} tally;

static uint64_t begin(const char *family) {
    memset(&tally, 0, sizeof tally);
    tally.family = family, tally.seed = first_seed;
    return first_seed;
}

/* At least so many of each. */
static void end(int rays, int hits, int misses, int multiple, int in_surface) {
    printf("%s: %d rays, %d hits, %d misses, %d multiple, %d in the surface\n", tally.family, tally.rays,
           tally.hits, tally.misses, tally.multiple, tally.in_surface);
    if (random_salt) return;
    if (tally.rays < rays || tally.hits < hits || tally.misses < misses || tally.multiple < multiple ||
        tally.in_surface < in_surface)
        fail_msg("%s, seed %llu: too few", tally.family, (unsigned long long)tally.seed);
}

static void print_case(const algsurf_extent *e) {
    fprintf(stderr, "%s, seed %llu, ray %d, extent of kind %d\n", tally.family,
            (unsigned long long)tally.seed, tally.rays, e ? (int)e->kind : 0);
    if (e) exact_print_doubles("centre", e->centre, 3), exact_print_doubles("size", e->size, 3);
}

static void decide(const algsurf_extent *extent) {
    const char *wrong = intersect_verdict(&c, extent, NULL, &answer);
    if (wrong) {
        print_case(extent);
        intersect_fail(wrong, &c, &answer);
    }
    tally.rays++, tally.hits += answer.count > 0, tally.misses += answer.count == 0;
    for (int i = 0; i < answer.count; i++) {
        tally.multiple += answer.all[i].multiplicity > 1;
        tally.in_surface += answer.all[i].multiplicity == 0;
    }
}

static void set_equation(const char *text) { intersect_equation(&c, text); }

static int whole(uint64_t *seed, int most) { return random_int(seed, 2 * most + 1) - most; }

/* Through a point with whole coordinates, which is at t = passed/steps; all numbers are whole. */
static void ray_through(uint64_t *seed, const int point[3], const int d[3], int passed, int steps) {
    for (int i = 0; i < 3; i++) {
        c.ray.origin[i] = point[i] - passed * d[i];
        c.ray.direction[i] = steps * d[i];
    }
    c.ray.t_min = random_int(seed, 3) ? 0 : -9;
    c.ray.t_max = random_int(seed, 2) ? INFINITY : 9;
}

static void random_direction(uint64_t *seed, int d[3]) {
    do
        for (int i = 0; i < 3; i++) d[i] = whole(seed, 4);
    while (d[0] == 0 && d[1] == 0 && d[2] == 0);
}

/* ---- multiple roots ---- */

/* Planes and spheres to powers, and what is beside them; t of the touch is a fraction. */
TEST(test_powers) {
    static const char *const beside[] = {"", "(x + y - 7)", "(x^2 + y^2 + z^2 + 1)", "(z - x + 2)^2",
                                         "(x^2 - 2 z^2 + y - 1)"};
    uint64_t seed = begin("powers");
    for (int i = 0; i < 150 * rounds; i++) {
        char text[200];
        int point[3], d[3], n = whole(&seed, 3), across[3], steps = 1 + random_int(&seed, 11);
        for (int k = 0; k < 3; k++) point[k] = whole(&seed, 3);
        random_direction(&seed, d);
        for (int k = 0; k < 3; k++) /* at right angles to the point */
            across[k] = point[(k + 1) % 3] * d[(k + 2) % 3] - point[(k + 2) % 3] * d[(k + 1) % 3];
        int square = point[0] * point[0] + point[1] * point[1] + point[2] * point[2];
        int flat = i % 3 == 0 || (across[0] == 0 && across[1] == 0 && across[2] == 0), m = 1 + i % 4;
        if (flat)
            (void)snprintf(text, sizeof text, "(2 x - 3 y + z - (%d))^%d %s",
                           2 * point[0] - 3 * point[1] + point[2], m, beside[i % 5]);
        else
            (void)snprintf(text, sizeof text, "(x^2 + y^2 + z^2 - %d)^%d %s", square, m, beside[i % 5]);
        set_equation(text);
        ray_through(&seed, point, flat ? d : across, n, steps);
        decide(NULL);
    }
    end(150, 100, 1, 80, 0);
}

/* Multiple roots at irrational places: whole quadratic forms to powers along any whole ray. */
TEST(test_conjugates) {
    static const char *const equations[] = {"(x^2 - 2 y^2)^2",
                                            "(x^2 - 2 y^2)^3 (x + y)",
                                            "(x^2 + y^2 + z^2 - 7)^2",
                                            "(x^2 + y^2 + z^2 - 7)^4 (x - 2 z)^2",
                                            "(x^4 - 5 x^2 + y^4 - 5 y^2 + z^4 - 5 z^2 + 12)^2",
                                            "(x^3 - 2 y^3 + z - 1)^3 (x^2 - 3)^2"};
    uint64_t seed = begin("conjugates");
    for (int i = 0; i < 120 * rounds; i++) {
        int point[3], d[3];
        for (int k = 0; k < 3; k++) point[k] = whole(&seed, 2);
        random_direction(&seed, d);
        set_equation(equations[i % 6]);
        ray_through(&seed, point, d, 1 + random_int(&seed, 3), 1 + random_int(&seed, 6));
        decide(NULL);
    }
    end(120, 60, 5, 80, 0);
}

/* ---- roots 2^-k apart, or not there by as much ---- */

TEST(test_gaps) {
    static const char *const equations[] = {"(3 x - 1)^2 - y^2",
                                            "(3 x - 1)^2 + y^2",
                                            "(x^2 - 2)^2 - y^2",
                                            "(x^2 - 2)^2 + y^2",
                                            "((3 x - 1)^2 - y^2)(5 x - 2)(x^2 + 1)",
                                            "((7 x - 2)^3 - y^3)(x - 3)",
                                            "((x^3 - x - 1)^2 - y^2) x",
                                            "(11 x - 3)^4 - y^4",
                                            "((3 x - 1)^2 - y^2)^2"};
    uint64_t seed = begin("gaps");
    for (int k = 1; k <= 300; k += 1 + random_int(&seed, 5)) {
        set_equation(equations[random_int(&seed, 9)]);
        for (int i = 0; i < rounds; i++) {
            int shift = random_int(&seed, 3);
            c.ray = (algsurf_ray){{-shift, ldexp(1, -k), 0}, {1 + random_int(&seed, 3), 0, 0}, 0, 9};
            if (random_int(&seed, 4) == 0) c.ray.t_max = INFINITY;
            decide(NULL);
        }
    }
    end(80, 50, 10, 5, 0);
}

/* ---- roots on the extent's surface ---- */

/* Lines that meet a ball of radius 5 about the origin in whole points: where y^2 + z^2 is 9, 16 or 25. */
static void ball_case(uint64_t *seed, double off, char *text, size_t size) {
    static const int heights[][2] = {{3, 4}, {4, 3}, {5, 0}, {0, 5}};
    const int *h = heights[random_int(seed, 4)];
    int steps = 1 + random_int(seed, 7), power = 1 + random_int(seed, 3);
    int end_x = random_int(seed, 2) ? h[1] : -h[1];
    c.ray = (algsurf_ray){{-9, h[0], off}, {steps, 0, 0}, 0, INFINITY};
    (void)snprintf(text, size, "(x - (%d) %s z)^%d %s", end_x, random_int(seed, 2) ? "+" : "-", power,
                   random_int(seed, 2) ? "(x + 1/2)" : "(x^2 + y^2 + 1)");
}

/* Faces of a box about (1,2,3) with half sizes (3,2,1). */
static void box_case(uint64_t *seed, double off, char *text, size_t size) {
    static const int face[] = {4, -2};
    int steps = 1 + random_int(seed, 7), power = 1 + random_int(seed, 3);
    c.ray = (algsurf_ray){{-7, whole(seed, 1) + 1, 4 - off}, {3 * steps, 0, 0}, 0, INFINITY};
    if (random_int(seed, 2)) c.ray.direction[1] = 0.25 * steps * random_int(seed, 2);
    (void)snprintf(text, size, "(x - (%d) %s (z - 4))^%d %s", face[random_int(seed, 2)],
                   random_int(seed, 2) ? "+" : "-", power,
                   random_int(seed, 2) ? "(x + 1/2)" : "(x^2 + y^2 + 1)");
}

TEST(test_extents) {
    static const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {5, 0, 0}};
    static const algsurf_extent box = {ALGSURF_EXTENT_BOX, {1, 2, 3}, {3, 2, 1}};
    uint64_t seed = begin("extents");
    for (int i = 0; i < 300 * rounds; i++) {
        char text[200];
        double off = i % 3 ? ldexp(1, -1 - random_int(&seed, 200)) : 0;
        if (i % 2)
            box_case(&seed, off, text, sizeof text);
        else
            ball_case(&seed, off, text, sizeof text);
        set_equation(text);
        decide(i % 2 ? &box : &ball);
    }
    end(300, 150, 30, 60, 0);
}

/* The surface is its extent's: every root counts. */
TEST(test_own_extent) {
    static const char *const equations[] = {"x^2 + y^2 + z^2 - 1", "(x^2 + y^2 + z^2 - 1)(3 x - 1)",
                                            "(x^2 + y^2 + z^2 - 1)^2 (x - y)",
                                            "(x^2 + y^2 + z^2 - 1)(x^2 + y^2 + z^2 - 1 - 2^-40)"};
    static const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    static const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}};
    uint64_t seed = begin("own extent");
    for (int i = 0; i < 200 * rounds; i++) {
        set_equation(equations[i % 4]);
        for (int k = 0; k < 3; k++) {
            c.ray.direction[k] = random_unit(&seed);
            c.ray.origin[k] = 0.9 * random_unit(&seed) - 4 * c.ray.direction[k];
        }
        if (i % 5 == 0) c.ray = (algsurf_ray){{-3, 1, 0}, {1, 0, 0}, 0, 0}; /* touches the ball */
        c.ray.t_min = 0, c.ray.t_max = INFINITY;
        decide(i % 3 ? &ball : &box);
    }
    end(200, 140, 5, 40, 0);
}

/* ---- double lines, triple points, nodes ---- */

/* Rays through a point of the surface, with whole numbers. */
static void through(uint64_t *seed, const char *equation, const int point[3], const algsurf_extent *extent,
                    int count) {
    set_equation(equation);
    for (int i = 0; i < count; i++) {
        int d[3];
        random_direction(seed, d);
        ray_through(seed, point, d, 1 + random_int(seed, 4), 1 + random_int(seed, 6));
        decide(i % 2 ? extent : NULL);
    }
}

TEST(test_singular) {
    static const char *const names[] = {"whitney", "steiner", "boy"};
    static const int whitney[][3] = {{0, 0, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, -2}};
    static const int steiner[][3] = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, 2}};
    static const int boy[][3] = {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}};
    uint64_t seed = begin("singular");
    for (int name = 0; name < 3; name++) {
        const catalogue_entry *entry = catalogue_find(names[name]);
        const int(*points)[3] = name == 0 ? whitney : name == 1 ? steiner : boy;
        for (int k = 0; k < 4; k++)
            through(&seed, entry->equation, points[k], &entry->extent, (name == 2 ? 12 : 30) * rounds);
    }
    end(280, 200, 1, 120, 3);
}

/* Barth's sextic with the coefficients that doubles have: almost nodes. */
TEST(test_nodes) {
    const double g = (1 + sqrt(5)) / 2;
    const double nodes[][3] = {{1, 1, 1},
                               {0, 1 / g, g},
                               {1 / g, g, 0},
                               {g, 0, 1 / g},
                               {-1, 1, -1},
                               {1, 0, 0},
                               {g / 2, 0.5, (g + 1) / 2 - 0.5 * g},
                               {0.5 * g * g, 0.5, 0.5 * g}};
    const catalogue_entry *entry = catalogue_find("barth-sextic");
    uint64_t seed = begin("nodes");
    set_equation(entry->equation);
    for (int i = 0; i < 160 * rounds; i++) {
        const double *node = nodes[i % 8];
        for (int k = 0; k < 3; k++) {
            c.ray.direction[k] = random_unit(&seed);
            c.ray.origin[k] = node[k] - 3 * c.ray.direction[k];
        }
        c.ray.t_min = 0, c.ray.t_max = INFINITY;
        decide(i % 2 ? &entry->extent : NULL);
    }
    end(160, 100, 1, 0, 0);
}

/* ---- rays in the surface ---- */

TEST(test_rays_within) {
    static const struct {
        const char *equation;
        double origin[3], direction[3];
    } rows[] = {{"z", {1, 2, 0}, {3, -1, 0}},
                {"(2 x - 3 y + z - 4)^2", {1, -1, -1}, {3, 1, -3}},
                {"(x - y)(x + y)(z - 1)", {-3, -3, 5}, {1, 1, 0.1}},
                {"x^2 + y^2 - 25", {3, -4, 7}, {0, 0, -0.3}},
                {"(x^2 + y^2 - 25)^3 (z - 1)", {3, 4, 7}, {0, 0, -1}},
                {"x y - z", {3, 0, 0}, {0, 0.1, 0.30000000000000004}}, /* 3 * 0.1 is that, or just not */
                {"x y - z", {3, -2, -6}, {0, 7, 21}},
                {"x^2 + y^2 - z^2 - 1", {1, -3, -3}, {0, 3, 3}},
                {"x^3 - 3 x y^2 - z^3 + z y^2 + 2 y^2 z", {-5, 0, -5}, {1, 0, 1}}};
    static const algsurf_extent extents[] = {{ALGSURF_EXTENT_ALL, {0, 0, 0}, {0, 0, 0}},
                                             {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {6, 0, 0}},
                                             {ALGSURF_EXTENT_BOX, {1, 1, 1}, {4, 3, 5}},
                                             {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {5, 0, 0}}};
    static const double ends[][2] = {{0, INFINITY}, {-INFINITY, INFINITY}, {-INFINITY, 0}, {0.5, 40}, {3, 3}};
    (void)begin("rays within");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        set_equation(rows[i].equation);
        for (int k = 0; k < 20; k++) {
            for (int axis = 0; axis < 3; axis++) {
                c.ray.origin[axis] = rows[i].origin[axis];
                c.ray.direction[axis] = rows[i].direction[axis];
            }
            c.ray.t_min = ends[k % 5][0], c.ray.t_max = ends[k % 5][1];
            decide(extents + k / 5);
        }
    }
    end(180, 80, 20, 0, 80);
}

/* ---- degrees, exponents ---- */

/* Sums of powers of few terms, along whole rays. */
TEST(test_degrees) {
    uint64_t seed = begin("degrees");
    for (int n = 1; n <= ALGSURF_MAX_DEGREE; n++) {
        algsurf_term terms[] = {{n, 0, 0, 1},
                                {0, n, 0, 3},
                                {0, 0, n, -2},
                                {n / 2, (n - 1) / 2, 0, 5},
                                {0, 0, 0, whole(&seed, 9)}};
        assert_true(intersect_terms(&c, terms, 5));
        for (int i = 0; i < (n < 24 ? 2 : 1) * rounds; i++) {
            int d[3], point[3];
            for (int k = 0; k < 3; k++) point[k] = whole(&seed, 1);
            random_direction(&seed, d);
            ray_through(&seed, point, d, 1, 1 + random_int(&seed, 3));
            decide(NULL);
        }
    }
    end(85, 40, 6, 0, 0);
}

static double any_double(uint64_t *seed, int i) { return i % 7 == 0 ? 0 : random_wide(seed, -1074, 1023); }

TEST(test_exponents) {
    uint64_t seed = begin("exponents");
    for (int i = 0; i < 150 * rounds; i++) {
        algsurf_term terms[6];
        int n = 1 + random_int(&seed, 5), count = 2 + random_int(&seed, 5);
        for (int k = 0; k < count; k++) {
            int e[3] = {0, 0, 0};
            for (int total = random_int(&seed, n + 1); total > 0; total--) e[random_int(&seed, 3)]++;
            terms[k] = (algsurf_term){e[0], e[1], e[2], random_wide(&seed, -1074, 1023)};
        }
        if (!intersect_terms(&c, terms, count)) continue;
        const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {fabs(any_double(&seed, 1)), 0, 0}};
        for (int k = 0; k < 3; k++) {
            c.ray.origin[k] = any_double(&seed, random_int(&seed, 14));
            c.ray.direction[k] = any_double(&seed, random_int(&seed, 14));
        }
        if (c.ray.direction[0] == 0 && c.ray.direction[1] == 0) c.ray.direction[2] = 0x1p-1074;
        c.ray.t_min = random_int(&seed, 2) ? -INFINITY : 0, c.ray.t_max = INFINITY;
        decide(i % 3 ? NULL : &ball);
    }
    end(120, 30, 30, 0, 0);
}

/* An origin that is nothing in the surface's unit, which is huge, and from which t leads to 0 exactly. */
TEST(test_small_origin) {
    (void)begin("small origin");
    const algsurf_term terms[] = {
        {3, 1, 1, 0x1p-899}, {0, 0, 1, -0x1p531}, {1, 3, 0, 0x1p488}, {0, 0, 0, -0x1p-303}};
    for (int sign = -1; sign <= 1; sign += 2) {
        assert_true(intersect_terms(&c, terms, 4));
        c.ray = (algsurf_ray){{-0x1p-1060, 0, sign * 0x1p-239}, {0, 0, 0x1p-1074}, -INFINITY, INFINITY};
        decide(NULL);
        assert_true(answer.count == 1 && answer.first.position[2] == 0);
    }
    end(2, 2, 0, 0, 0);
}

/* Where a ray meets its extent beyond the largest double, in t: roots there, and none. */
TEST(test_beyond_doubles) {
    static const struct {
        const char *equation;
        algsurf_ray ray;
        double size;
        int count;
    } rows[] = {
        {"z - 1", {{0, 0, 0x1p570}, {0, 0, 0x1p-1074}, -INFINITY, INFINITY}, 0x1p344, 1},
        {"z - 1", {{0, 0, -0x1p570}, {0, 0, 0x1p-1074}, 0, INFINITY}, 0x1p344, 1},
        {"z - 0x1p500", {{0, 0, -0x1p570}, {0, 0, 0x1p-1074}, 0, INFINITY}, 0x1p344, 0},
        {"z - 1", {{0, 0, 0x1p570}, {0, 0, 0x1p-1074}, 0, INFINITY}, 0x1p344, 0},
        {"(z - 0x1p300)(z - 1)", {{0, 0, 0}, {0, 0, 0x1p-1000}, 0, INFINITY}, 0x1p200, 1},
        {"(z + 0x1p300)(z - 1)", {{0, 0, 0}, {0, 0, 0x1p-1000}, -INFINITY, INFINITY}, 0x1p200, 1},
        {"(z - 0x1p200)^2", {{0, 0, 0}, {0, 0, 0x1p-1000}, 0, INFINITY}, 0x1p200, 1},
    };
    (void)begin("beyond doubles");
    for (size_t i = 0; i < sizeof rows / sizeof *rows * 2; i++) {
        double size = rows[i / 2].size;
        const algsurf_extent extent = {
            i % 2 ? ALGSURF_EXTENT_BOX : ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {size, size, size}};
        set_equation(rows[i / 2].equation);
        c.ray = rows[i / 2].ray;
        decide(&extent);
        assert_int_equal(answer.count, rows[i / 2].count);
    }
    end(14, 10, 4, 2, 0);
}

/* ---- the unit sphere in itself ---- */

/* Does the line meet the unit sphere?  (o.d)^2 >= d.d (o.o - 1), over the integers. */
static int meets_sphere(const double o[3], const double d[3]) {
    mpq_t od, dd, oo, x, y;
    mpq_inits(od, dd, oo, x, y, NULL);
    mpq_set_si(oo, -1, 1);
    for (int i = 0; i < 3; i++) {
        exact_set(x, o[i]), exact_set(y, d[i]);
        mpq_t q;
        mpq_init(q);
        mpq_mul(q, x, y), mpq_add(od, od, q);
        mpq_mul(q, x, x), mpq_add(oo, oo, q);
        mpq_mul(q, y, y), mpq_add(dd, dd, q);
        mpq_clear(q);
    }
    mpq_mul(od, od, od), mpq_mul(dd, dd, oo);
    int meets = mpq_cmp(od, dd) >= 0;
    mpq_clears(od, dd, oo, x, y, NULL);
    return meets;
}

/* A picture's rays: all hits survive. */
TEST(test_picture_of_itself) {
    enum { SIDE = 300 };
    static packet_case p;
    static const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    const double eye[3] = {1.7, -2.3, 1.1}, at[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    int hits = 0;
    algsurf_camera camera = pinhole_of(eye, at, up, 42);
    set_equation("x^2 + y^2 + z^2 - 1");
    for (int row = 0; row < SIDE; row++) {
        for (int x = 0; x < SIDE; x++) {
            algsurf_ray ray = pixel_ray(&camera, SIDE, SIDE, x + 0.5, row + 0.5);
            packet_put(&p, x, &ray);
        }
        assert_ok(packet_ask(&p, 0, SIDE, c.surface, &ball, NULL));
        for (int x = 0; x < SIDE; x++) {
            const algsurf_ray ray = packet_ray(&p, x);
            int wanted = meets_sphere(ray.origin, ray.direction) ? ALGSURF_STATE_HIT : ALGSURF_STATE_MISS;
            hits += wanted == ALGSURF_STATE_HIT;
            if (p.state[x] == wanted && p.occluded[x] == wanted) continue;
            exact_print_doubles("origin, direction", ray.origin, 6);
            fail_msg("row %d, column %d: state %d, occluded %d", row, x, p.state[x], p.occluded[x]);
        }
    }
    assert_in_range(hits, SIDE * SIDE / 3, SIDE * SIDE * 9 / 10);
}

/* ---- what took too long ---- */

TEST(test_far_exponents) {
    const algsurf_term terms[] = {
        {52, 0, 2, 0x1p512}, {7, 48, 0, 0x1p53}, {50, 9, 0, 0x0.012688b70e62bp-1022}};
    assert_true(intersect_terms(&c, terms, 3));
    c.ray = (algsurf_ray){{0x1p-1000, 0x1p-1, 0x1.fffffffffffffp+0},
                          {-0x1.a888cefc9fcf2p+1, -0x1.11775b13a6689p-16, 0x1p-1000},
                          0,
                          8};
    double begun = unit_seconds();
    algsurf_hit hit = first_hit_of(c.surface, NULL, &c.ray, NULL);
    double taken = unit_seconds() - begun;
    printf("far exponents: %.2f s, state %d, multiplicity %d at %a\n", taken, hit.state, hit.multiplicity,
           hit.t);
    /* x^7 divides P; x is 0 at t = 2^-1000 / 3.3.. */
    assert_int_equal(hit.state, ALGSURF_STATE_HIT);
    assert_int_equal(hit.multiplicity, 7);
    assert_true(fabs(hit.t / (0x1p-1000 / 0x1.a888cefc9fcf2p+1) - 1) < 0x1p-50);
    assert_true(taken < 5);
}

/* (x^2 + y^2 + z^2 - 1)^power; 0 if a coefficient is not a double. */
static int power_of_sphere(int power) {
    static algsurf_term terms[INTERSECT_TERMS * 4];
    int count = 0, exact = 1;
    mpz_t ways, factor;
    mpz_inits(ways, factor, NULL);
    for (int i = 0; i <= power; i++)
        for (int j = 0; i + j <= power; j++)
            for (int k = 0; i + j + k <= power; k++) {
                int left = power - i - j - k;
                mpz_bin_uiui(ways, (unsigned long)power, (unsigned long)i);
                mpz_bin_uiui(factor, (unsigned long)(power - i), (unsigned long)j);
                mpz_mul(ways, ways, factor);
                mpz_bin_uiui(factor, (unsigned long)(power - i - j), (unsigned long)k);
                mpz_mul(ways, ways, factor);
                double a = mpz_get_d(ways);
                exact &= mpz_cmp_d(ways, a) == 0;
                terms[count++] = (algsurf_term){2 * i, 2 * j, 2 * k, left % 2 ? -a : a};
            }
    mpz_clears(ways, factor, NULL);
    c.surface = surface_of_terms(terms, (size_t)count);
    return exact;
}

TEST(test_powers_of_a_sphere) {
    static const struct {
        int power, rays;
        double most; /* seconds a ray, generously */
    } rows[] = {{8, 100, 5e-3}, {12, 50, 2e-2}, {16, 25, 5e-2}, {24, 12, 1e-1}};
    uint64_t seed = begin("powers of a sphere");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        int exact = power_of_sphere(rows[i].power), hits = 0;
        double taken = 0;
        assert_true(exact);
        for (int k = 0; k < rows[i].rays; k++) {
            for (int axis = 0; axis < 3; axis++) {
                c.ray.direction[axis] = random_unit(&seed);
                c.ray.origin[axis] = 1.2 * random_unit(&seed) - 4 * c.ray.direction[axis];
            }
            c.ray.t_min = -INFINITY, c.ray.t_max = INFINITY;
            double begun = unit_seconds();
            algsurf_hit hit = first_hit_of(c.surface, NULL, &c.ray, NULL);
            taken += unit_seconds() - begun;
            int meets = meets_sphere(c.ray.origin, c.ray.direction);
            int right = meets ? hit.multiplicity == rows[i].power && hit.side == 1 : hit.multiplicity == 0;
            if (!right || hit.state != (meets ? ALGSURF_STATE_HIT : ALGSURF_STATE_MISS)) {
                exact_print_doubles("origin", c.ray.origin, 3);
                exact_print_doubles("direction", c.ray.direction, 3);
                fail_msg("seed %llu, power %d: state %d, multiplicity %d, side %d",
                         (unsigned long long)first_seed, rows[i].power, hit.state, hit.multiplicity,
                         hit.side);
            }
            hits += hit.state == ALGSURF_STATE_HIT;
        }
        taken /= rows[i].rays;
        printf("power %d: %d hits of %d, %.3f ms a ray\n", rows[i].power, hits, rows[i].rays, 1e3 * taken);
        assert_true(hits * 9 > rows[i].rays && hits < rows[i].rays);
        if (taken > rows[i].most) fail_msg("power %d: %g s a ray", rows[i].power, taken);
    }
}

/* ---- memory ---- */

TEST(test_limit_of_memory) {
    algsurf_intersect_options options = {.size = sizeof options, .max_memory = 1};
    algsurf_hit hits[24], before[24];
    int occluded = 77;
    int count = 77;
    set_equation("(x^10 + y^10 + z^10 - 1)^2 (x + 99)");
    c.ray = (algsurf_ray){{-3, 0.3, 0.2}, {1, 0x1p-40, 0}, 0, 9};
    memset(before, 0xa5, sizeof before), memcpy(hits, before, sizeof hits);
    assert_int_equal(algsurf_intersect_first(c.surface, NULL, &c.ray, &options, hits), ALGSURF_E_NO_MEMORY);
    assert_int_equal(algsurf_intersect_all(c.surface, NULL, &c.ray, &options, hits, 24, &count),
                     ALGSURF_E_NO_MEMORY);
    assert_int_equal(algsurf_occluded(c.surface, NULL, &c.ray, &options, &occluded), ALGSURF_E_NO_MEMORY);
    assert_memory_equal(hits, before, sizeof hits);
    assert_true(count == 77 && (int)occluded == 77);
    /* a packet: the rays beside are answered */
    const algsurf_ray other = {{-3, 9, 0}, {1, 0, 0}, 0, INFINITY};
    static packet_case p;
    for (int i = 0; i < 3; i++) packet_put(&p, i, i == 1 ? &c.ray : &other);
    const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {2, 2, 2}};
    assert_int_equal(packet_ask(&p, 0, 3, c.surface, &box, &options), ALGSURF_E_NO_MEMORY);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(p.state[i], i == 1 ? ALGSURF_STATE_UNDECIDED : ALGSURF_STATE_MISS);
        assert_int_equal(p.occluded[i], i == 1 ? ALGSURF_STATE_UNDECIDED : ALGSURF_STATE_MISS);
    }
    options.max_memory = (size_t)1 << 24;
    assert_ok(packet_ask(&p, 0, 3, c.surface, &box, &options));
    assert_int_equal(p.state[1], ALGSURF_STATE_HIT);
    begin("limit of memory");
    set_equation("(x^10 + y^10 + z^10 - 1)^2 (x + 99)");
    decide(NULL);
    end(1, 1, 0, 2, 0);
}
