/* test_sides.c - rays that start at a hit: hits of one side, and points beside the surface.
 *
 * Rays start where the library says that a hit is, so in doubles on either side of the surface or on it, or
 * one unit in the last place beside; they go where a path tracer sends them, or graze.  First, all, occluded
 * and packets must say what the oracle for hits says, for hits of any side, of -1 and of 1
 * (intersect_verdict); and doubles alone must decide nearly all of them, if the side is given.
 *
 * Breaks caught, each tried: a start of unknown sign taken for one of the wanted sign without regard to the
 * slope; one variation of signs behind it taken for a root; roots of the wrong side that end the search; a
 * miss's side from the begin of the chord; in company, the signs of a start of unknown sign counted again as
 * if it were known, because another ray of the packet enters a cell; no smaller steps where the first one
 * leads beyond the next sheet.
 *
 *     test_sides [rounds [seed]]     default: 1 and 77
 */
#include "intersect_case.h"

#include "catalogue.h"

ARGUMENT(1, int, rounds, 1)
ARGUMENT(2, uint64_t, first_seed, 77)

static intersect_case c;
static intersect_answer answer;

static struct { int rays, hits, self, left; } tally;

/* A ray towards the surface's middle; returns whether it hits. */
static int first_hit(uint64_t *seed, const algsurf_extent *extent, algsurf_hit *hit) {
    for (int k = 0; k < 3; k++) {
        double aim = random_unit(seed);
        c.ray.direction[k] = random_unit(seed);
        c.ray.origin[k] = aim - 5 * c.ray.direction[k];
    }
    c.ray.t_min = 0, c.ray.t_max = INFINITY;
    assert_ok(algsurf_intersect_first(c.surface, extent, &c.ray, NULL, hit));
    return hit->state == ALGSURF_STATE_HIT && hit->multiplicity == 1;
}

/* The point and a direction into the half space from which the ray came: any, or almost along the surface. */
static void bounce(uint64_t *seed, const algsurf_hit *hit, int kind) {
    double along = 0, *d = c.ray.direction;
    for (int k = 0; k < 3; k++) {
        c.ray.origin[k] = hit->position[k];
        if (kind == 1) c.ray.origin[k] = nextafter(hit->position[k], random_int(seed, 2) ? 9 : -9);
        d[k] = random_unit(seed);
    }
    for (int k = 0; k < 3; k++) along += d[k] * hit->normal[k];
    double turn = kind == 2 ? (1 - ldexp(1, -10 - random_int(seed, 40))) : 2 * (along * hit->side < 0);
    for (int k = 0; k < 3; k++) d[k] -= turn * along * hit->normal[k];
}

/* P at a point, exactly. */
static int sign_at(const double x[3]) {
    algsurf_ray there = {{x[0], x[1], x[2]}, {1, 0, 0}, 0, 1};
    exact_line line = exact_line_of(c.terms, c.count, c.degree, &there);
    int sign = mpz_sgn(line.c[0]);
    exact_line_clear(&line);
    return sign;
}

static void leave(const algsurf_hit *hit) {
    for (int side = -1; side <= 1; side += 2) {
        double start[3], far = 0, size = 0;
        algsurf_status status = algsurf_hit_leave(c.surface, &c.ray, hit, side, start);
        if (status == ALGSURF_NOT_VERIFIED) continue;
        assert_ok(status);
        for (int k = 0; k < 3; k++) {
            far = fmax(far, fabs(start[k] - hit->position[k]));
            size = fmax(size, fabs(hit->position[k]));
        }
        if (sign_at(start) != side || far > ldexp(fmax(size, 4), -19)) {
            exact_print_doubles("position", hit->position, 3), exact_print_doubles("start", start, 3);
            fail_msg("seed %llu: side %d", (unsigned long long)first_seed, side);
        }
        tally.left++;
    }
}

/* Do doubles decide hits of this side? */
static int is_decided(const algsurf_extent *extent, int side) {
    const algsurf_intersect_options how = {.size = sizeof how, .tier = ALGSURF_TIER_BOUNDED, .side = side};
    algsurf_hit hit = first_hit_of(c.surface, extent, &c.ray, &how);
    return hit.state != ALGSURF_STATE_UNDECIDED;
}

/* Rays in company, for hits of that side, as each alone. */
static void judge_company(packet_case *p, const algsurf_extent *extent, int count, int side) {
    const algsurf_intersect_options how = {.size = sizeof how, .side = side};
    assert_ok(packet_ask(p, 0, count, c.surface, extent, &how));
    for (int i = 0; i < count; i++) {
        algsurf_hit hit;
        const char *wrong = packet_wrong(p, i, c.surface, extent, &how, &hit);
        if (!wrong && p->occluded[i] == p->state[i]) continue;
        const algsurf_ray ray = packet_ray(p, i);
        exact_print_doubles("origin", ray.origin, 3), exact_print_doubles("direction", ray.direction, 3);
        fail_msg("seed %llu: side %d: alone %a, in company %a, occluded %d", (unsigned long long)first_seed,
                 side, hit.t, p->t[i], p->occluded[i]);
    }
}

/* Secondary rays of a surface, whose terms are set; most: of how many doubles must decide, if they do not
 * graze.
 */
static void judge_bounces(uint64_t *seed, int rays, const algsurf_extent *extent, double share) {
    int asked = 0, decided = 0;
    memset(&tally, 0, sizeof tally);
    for (int i = 0; i < 20 * rays && tally.rays < rays; i++) {
        algsurf_hit hit;
        if (!first_hit(seed, extent, &hit) || !intersect_unit(hit.normal)) continue;
        leave(&hit);
        bounce(seed, &hit, i % 3);
        intersect_judge_in(&c, extent, NULL, &answer);
        if (i % 3 != 2) asked++, decided += is_decided(extent, hit.side);
        tally.rays++, tally.hits += answer.count > 0;
        tally.self += answer.count > 0 && fabs(answer.first.t) < 1e-10;
    }
    printf("degree %d: %d rays, %d hits, %d of themselves, %d of %d decided by doubles, %d left\n", c.degree,
           tally.rays, tally.hits, tally.self, decided, asked, tally.left);
    assert_true(tally.rays == rays && tally.left >= rays);
    assert_often(tally.self * 4 > rays && decided >= share * asked);
}

TEST(test_catalogue_bounces) {
    static const char *const names[] = {"sphere", "tangle", "torus", "barth-sextic", "boy", "chair"};
    uint64_t seed = first_seed;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {8, 0, 0}};
        const catalogue_entry *entry = catalogue_find(names[i]);
        assert_non_null(entry);
        intersect_equation(&c, entry->equation);
        judge_bounces(&seed, 60 * rounds, i % 2 ? NULL : &ball, 0.9);
    }
}

/* Two sheets 2^-k apart: a point between them, or none where rounding hides the sign there. */
TEST(test_leave_thin_walls) {
    int found = 0, hidden = 0;
    for (int k = 4; k <= 40; k++) {
        const double gap = ldexp(1, -k);
        const algsurf_term walls[] = {{2, 0, 0, 1}, {1, 0, 0, -2 - gap}, {0, 0, 0, 1 + gap}};
        const algsurf_ray ray = {{0, 0.25, 0.5}, {1, 0, 0}, 0, INFINITY};
        double start[3] = {7, 7, 7};
        algsurf_surface *s = surface_of_terms(walls, 3);
        algsurf_hit hit = first_hit_of(s, NULL, &ray, NULL);
        assert_true(hit.state == ALGSURF_STATE_HIT && hit.side == 1);
        algsurf_status status = algsurf_hit_leave(s, &ray, &hit, -1, start);
        if (status == ALGSURF_OK ? !(start[0] > 1 && start[0] < 1 + gap) : start[0] != 7)
            fail_msg("2^-%d: status %d, from %a", k, status, start[0]);
        found += status == ALGSURF_OK, hidden += status == ALGSURF_NOT_VERIFIED;
        assert_ok(algsurf_hit_leave(s, &ray, &hit, 1, start));
        assert_true(start[0] < 1 || start[0] > 1 + gap);
    }
    assert_true(found >= 18 && found + hidden == 37);
}

TEST(test_company) {
    static const char *const names[] = {"tangle", "torus", "barth-sextic", "boy"};
    uint64_t seed = first_seed;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const catalogue_entry *entry = catalogue_find(names[i]);
        assert_non_null(entry);
        intersect_equation(&c, entry->equation);
        for (int packet = 0; packet < 200 * rounds; packet++) {
            static packet_case p;
            algsurf_hit hit;
            int count = 0;
            for (int tries = 0; tries < 1000 && count < 64; tries++) {
                if (!first_hit(&seed, &entry->extent, &hit)) continue;
                bounce(&seed, &hit, tries % 3);
                if (tries % 4 == 0) c.ray.t_max = random_unit(&seed);
                if (tries % 5 == 0) c.ray.t_min = 0.25 * random_unit(&seed);
                packet_put(&p, count++, &c.ray);
            }
            for (int side = -1; side <= 1; side++) judge_company(&p, &entry->extent, count, side);
        }
    }
}
