/* test_own_ball.c - what is decided beside the solver for whole surfaces and packets: a ball that is its own
 * extent, and the form that rays of one origin share.
 *
 * Catches (each tried): a surface taken for its own ball though one coefficient is a unit in the last place
 * off, or the centre; one that is not recognised; a ball that is replaced by a larger one though the surface
 * is not its own; an eye made at another point than the rays'. */

#include "packet_case.h"
#include "rays/region.h"
#include "scenes.h"

static const uint64_t SEED = 20261122;

/* a (|X - C|^2 - R^2) for small integers times powers of two: its coefficients are exact. */
typedef struct ball {
    double a, centre[3], radius;
    algsurf_term term[7];
} ball;

static ball random_ball(uint64_t *seed) {
    ball b = {.a = ldexp(1 + random_int(seed, 99), random_int(seed, 40) - 20)};
    int unit = random_int(seed, 60) - 30;
    double square = 0;
    if (random_int(seed, 2)) b.a = -b.a;
    b.radius = ldexp(1 + random_int(seed, 999), unit);
    for (int i = 0; i < 3; i++) {
        b.centre[i] = ldexp(random_int(seed, 2001) - 1000, unit);
        square += b.centre[i] * b.centre[i];
        const int e[3] = {i == 0, i == 1, i == 2};
        b.term[i] = (algsurf_term){2 * e[0], 2 * e[1], 2 * e[2], b.a};
        b.term[3 + i] = (algsurf_term){e[0], e[1], e[2], -2 * b.a * b.centre[i]};
    }
    b.term[6] = (algsurf_term){0, 0, 0, b.a * (square - b.radius * b.radius)};
    return b;
}

/* Is the surface taken for its own ball? */
static int is_ball(const algsurf_surface *s, const algsurf_extent *extent) {
    algsurf_extent wider;
    const algsurf_extent *used = algsurf_i_without_own_ball(s, extent, &wider);
    assert_true(used == extent || (used == &wider && wider.size[0] == 2 * extent->size[0]));
    return used != extent;
}

static int is_own(const ball *b, const algsurf_extent *extent) {
    algsurf_surface *s = surface_of_terms(b->term, 7);
    int own = is_ball(s, extent);
    return own;
}

TEST(test_recognised) {
    uint64_t seed = SEED;
    for (int round = 0; round < 2000; round++) {
        ball b = random_ball(&seed), other = b;
        algsurf_extent extent = {
            ALGSURF_EXTENT_SPHERE, {b.centre[0], b.centre[1], b.centre[2]}, {b.radius, 0, 0}};
        if (!is_own(&b, &extent))
            fail_msg("seed %llu, round %d: not recognised", (unsigned long long)SEED, round);
        int which = random_int(&seed, 7), up = random_int(&seed, 2);
        other.term[which].a = nextafter(b.term[which].a, up ? HUGE_VAL : -HUGE_VAL);
        if (is_own(&other, &extent))
            fail_msg("seed %llu, round %d: term %d, %a for %a, makes no difference", (unsigned long long)SEED,
                     round, which, other.term[which].a, b.term[which].a);
        extent.size[0] = nextafter(b.radius, up ? HUGE_VAL : 0);
        assert_false(is_own(&b, &extent));
        extent.size[0] = b.radius;
        extent.centre[which % 3] = nextafter(b.centre[which % 3], HUGE_VAL);
        assert_false(is_own(&b, &extent));
    }
}

/* What stands beside a ball of the same size keeps its extent. */
TEST(test_others) {
    static const char *const equation[] = {"x^2 + y^2 + z^2 + x y = 1", "x^2 + y^2 = 1",
                                           "x^2 + y^2 - z^2 = 1",       "(x^2 + y^2 + z^2 - 1)^2",
                                           "x^4 + y^4 + z^4 = 1",       "x = 1"};
    const algsurf_extent ball_of_1 = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}},
                         box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}};
    algsurf_surface *s, *known;
    for (size_t i = 0; i < sizeof equation / sizeof *equation; i++) {
        s = surface_of(equation[i]);
        assert_false(is_ball(s, &ball_of_1));
    }
    s = surface_of("x^2 + y^2 + z^2 = 1");
    assert_true(is_ball(s, &ball_of_1));
    assert_false(is_ball(s, &box) || is_ball(s, NULL));
    known = surface_with_error(s, 1e-10);
    assert_false(is_ball(known, &ball_of_1));
}

/* Many rays of one origin that doubles leave undecided, as a packet and each alone: the same bits. */
enum { RAYS = 40 };

TEST(test_shared_origin) {
    static const char *const equation[] = {"(x^2 + 2y^2 + 3z^2 + x y - y z + x - 1)^2",
                                           "(x^3 + y^3 + z^3 + x y z - x + 1/2)^2 (x + y + z + 1)",
                                           "((x + y + z + 1)^4 + (x - y)^3 z - 2)^2"};
    uint64_t seed = SEED + 1;
    int hits = 0, misses = 0;
    for (size_t e = 0; e < sizeof equation / sizeof *equation; e++) {
        static packet_case p;
        algsurf_surface *s = surface_of(equation[e]);
        for (int i = 0; i < RAYS; i++) {
            algsurf_ray ray = {{-3.1, 0.3, 0.6}, {1, 0, 0}, 0, INFINITY};
            for (int k = 1; k < 3; k++) ray.direction[k] = 0.4 * random_unit(&seed);
            packet_put(&p, i, &ray);
        }
        assert_ok(packet_ask(&p, 0, RAYS, s, NULL, NULL));
        for (int i = 0; i < RAYS; i++) {
            algsurf_hit hit;
            const char *wrong = packet_wrong(&p, i, s, NULL, NULL, &hit);
            if (wrong)
                fail_msg("%s: ray %d along (%a, %a, %a): %d at %a alone, %d at %a in the packet", equation[e],
                         i, p.direction[0][i], p.direction[1][i], p.direction[2][i], hit.state, hit.t,
                         p.state[i], p.t[i]);
            hits += hit.state == ALGSURF_STATE_HIT, misses += hit.state == ALGSURF_STATE_MISS;
        }
    }
    assert_true(hits > 20 && misses > 3);
}

/* Along this direction the form of highest degree vanishes, but not that of all coefficients within the
 * error: a root may be anywhere far out. */
TEST(test_vanishing_direction) {
    algsurf_surface *exact, *known;
    const algsurf_ray ray = {{0, 0.5, 0}, {1, 1, 0}, 0, 0x1p60};
    algsurf_hit hits[4];
    int count = 0, beyond = 0;
    exact = surface_of("x^2 - y^2 + z^2 + x = 1");
    known = surface_with_error(exact, 1e-9);
    assert_ok(algsurf_intersect_all(exact, NULL, &ray, NULL, hits, 4, &count));
    assert_int_equal(count, 0); /* p is -5/4 */
    assert_ok(algsurf_intersect_all(known, NULL, &ray, NULL, hits, 4, &count));
    for (int i = 0; i < count; i++) beyond |= hits[i].state == ALGSURF_STATE_UNDECIDED && hits[i].t_hi > 1e4;
    assert_true(beyond);
}
