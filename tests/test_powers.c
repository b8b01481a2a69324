/* test_powers.c - surfaces P = c Q^k: which are found, and rays that ask Q in their stead.
 *
 * Rays: the oracle for hits judges first, all, occluded (intersect_judge_in); normals and sides must be those
 * of P itself, which the calls still ask where somebody watches; packets must have the bits of single calls.
 *
 * Breaks caught, each tried: no proof that Q^k is P; normals of even powers as Q's; the option `side` as if
 * it were Q's; packets that do not ask for sides; a ray in the surface that has a hit of one side.
 *
 *     test_powers [rounds [seed]]     default: 1 and 34
 */
#include "intersect_case.h"

#include "catalogue.h"
#include "surface/impl.h"

ARGUMENT(1, int, rounds, 1)
ARGUMENT(2, uint64_t, first_seed, 34)

static intersect_case c;
static intersect_answer answer;

/* c times the k-th power, or count 0 where a coefficient is no double. */
enum { MOST = 9000 };
typedef struct terms {
    algsurf_term of[MOST];
    int count;
} terms;
static terms root, power, product;

/* place[i][j][k]: where the term of x^i y^j z^k may stand. */
static void add_term(terms *to, const algsurf_term *t) {
    static int place[65][65][65];
    int *at = &place[t->i][t->j][t->k];
    algsurf_term *old = to->of + *at;
    if (*at < to->count && old->i == t->i && old->j == t->j && old->k == t->k) {
        old->a += t->a;
    } else if (to->count < MOST) {
        *at = to->count;
        to->of[to->count++] = *t;
    }
}

static void make_power(int k, double by) {
    power.count = 1;
    power.of[0] = (algsurf_term){0, 0, 0, by};
    for (; k > 0 && power.count; k--) {
        product.count = 0;
        for (int i = 0; i < power.count; i++)
            for (int j = 0; j < root.count; j++) {
                const algsurf_term *a = power.of + i, *b = root.of + j;
                add_term(&product, &(algsurf_term){a->i + b->i, a->j + b->j, a->k + b->k, a->a * b->a});
            }
        power = product;
        if (product.count == MOST) power.count = 0;
        for (int i = 0; i < product.count; i++)
            if (fabs(product.of[i].a) >= 0x1p53) power.count = 0; /* sums below have been exact */
    }
}

static void random_root(uint64_t *seed, int degree, int size) {
    root.count = 0;
    for (int n = 2 + random_int(seed, 5), i = 0; i < n; i++) {
        int e[3] = {0, 0, 0}, total = i == 0 ? degree : random_int(seed, degree + 1);
        while (total-- > 0) e[random_int(seed, 3)]++;
        add_term(&root, &(algsurf_term){e[0], e[1], e[2], 1 + random_int(seed, size)});
        if (random_int(seed, 2)) root.of[root.count - 1].a *= -1;
    }
    int kept = 0;
    for (int i = 0; i < root.count; i++)
        if (root.of[i].a != 0) root.of[kept++] = root.of[i];
    root.count = kept;
}

static int same_as_root(const algsurf_surface *q) {
    algsurf_surface *mine;
    assert_ok(algsurf_surface_from_terms(root.of, (size_t)root.count, &mine));
    int same = q->term_count == mine->term_count;
    for (size_t t = 0; same && t < mine->term_count; t++) {
        const algsurf_term *a = mine->terms + t, *b = q->terms + t;
        same = a->i == b->i && a->j == b->j && a->k == b->k &&
               a->a * q->terms[0].a == b->a * mine->terms[0].a; /* up to a number */
    }
    algsurf_surface_free(mine);
    return same;
}

TEST(test_found) {
    uint64_t seed = first_seed;
    int found = 0, nudged = 0;
    algsurf_surface *made;
    for (int round = 0; round < 2000 * rounds; round++) {
        const int degree = 1 + random_int(&seed, 6), k = 2 + random_int(&seed, 64 / degree - 1);
        const double by = ldexp(random_int(&seed, 2) ? 3 : -1, random_int(&seed, 40) - 20);
        random_root(&seed, degree, round % 3 ? 3 : 1000);
        make_power(k, 1);
        if (!power.count || !root.count || algsurf_surface_from_terms(root.of, (size_t)root.count, &made))
            continue;
        const int is_constant = algsurf_surface_degree(made) == 0;
        algsurf_surface_free(made);
        if (is_constant) continue;
        int exact = 1;
        for (int i = 0; i < power.count; i++) {
            double a = power.of[i].a;
            power.of[i].a *= by;
            exact &= fma(a, by, -power.of[i].a) == 0;
        }
        assert_ok(algsurf_surface_from_terms(power.of, (size_t)power.count, &made));
        const algsurf_surface *q = made->root;
        if (exact && !(q && made->power % k == 0 && (made->power > k || same_as_root(q))))
            fail_msg("seed %llu, round %d: power %d of degree %d", (unsigned long long)first_seed, round, k,
                     degree);
        found += exact;
        algsurf_surface_free(made);
        algsurf_term *one = power.of + random_int(&seed, power.count);
        one->a = nextafter(one->a, random_int(&seed, 2) ? INFINITY : -INFINITY);
        assert_ok(algsurf_surface_from_terms(power.of, (size_t)power.count, &made));
        if (power.count > 1 && made->root) /* (one term alone has any coefficient) */
            fail_msg("seed %llu, round %d: no power", (unsigned long long)first_seed, round);
        nudged++;
        algsurf_surface_free(made);
    }
    printf("%d powers found, %d that are none\n", found, nudged);
    assert_true(found > 300 * rounds && nudged > 300 * rounds);
}

/* Numbers at the ends of the range of doubles, whole powers of letters, and what only looks like a power. */
TEST(test_borders) {
    const struct {
        algsurf_term of[4];
        int power;
    } cases[] = {
        {{{64, 0, 0, 1}}, 64},
        {{{0, 0, 2, DBL_MAX}}, 2},
        {{{0, 0, 2, 0x1p-1074}, {0, 1, 1, -0x1p-1073}, {0, 2, 0, 0x1p-1074}}, 2},
        {{{2, 0, 0, 0x1p500}, {1, 0, 0, 0x1p501}, {0, 0, 0, 0x1p500}}, 2},
        {{{2, 0, 0, 0x1p52}, {1, 0, 0, 0x1p27}, {0, 0, 0, 1}}, 2},
        {{{2, 0, 0, 0x1p104}, {1, 0, 0, -0x1p53}, {0, 0, 0, 1}}, 2},
        {{{2, 0, 0, 0x1p600}, {0, 0, 0, 0x1p-600}}, 0},
        {{{2, 0, 0, 1}, {0, 2, 0, 1}}, 0},
        {{{2, 0, 0, 1}, {1, 0, 0, 2}, {0, 0, 0, 4}}, 0},
        {{{2, 0, 0, 1}, {1, 0, 0, 2}, {0, 0, 0, 1 + 0x1p-52}}, 0},
        {{{4, 0, 0, 1}, {2, 0, 0, -2}, {0, 0, 0, 1}}, 2},
        {{{2, 0, 0, 2}, {1, 0, 0, 4}, {0, 0, 0, 2}}, 2},
        {{{0, 0, 0, 4}}, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        algsurf_surface *s;
        assert_ok(algsurf_surface_from_terms(cases[i].of, 4, &s));
        if (s->power != cases[i].power) fail_msg("case %zu: power %d", i, s->power);
        algsurf_surface *loose = NULL;
        assert_ok(algsurf_surface_with_error(s, 0x1p-53, &loose));
        assert_null(loose->root); /* stands for what is no power, too */
        algsurf_surface_free(loose);
        algsurf_surface_free(s);
    }
}

static void nobody_cares(double t, double value, int engine, void *data) {
    (void)t, (void)value, (void)engine, (void)data;
}

/* The call that asks P itself: it is watched. */
static void judge_against_itself(const algsurf_extent *extent, int side) {
    algsurf_observer watch = {.size = sizeof watch, .on_point = nobody_cares};
    const algsurf_intersect_options how = {.size = sizeof how, .side = side};
    const algsurf_intersect_options watched = {.size = sizeof watched, .side = side, .observer = &watch};
    algsurf_hit hits[ALGSURF_MAX_DEGREE], itself[ALGSURF_MAX_DEGREE], first;
    int count, its_count;
    assert_ok(algsurf_intersect_all(c.surface, extent, &c.ray, &how, hits, ALGSURF_MAX_DEGREE, &count));
    assert_ok(algsurf_intersect_first(c.surface, extent, &c.ray, &how, &first));
    assert_ok(
        algsurf_intersect_all(c.surface, extent, &c.ray, &watched, itself, ALGSURF_MAX_DEGREE, &its_count));
    int same = count == its_count && (count == 0) == (first.state == ALGSURF_STATE_MISS);
    for (int i = 0; same && i < count; i++) {
        double along = 0, facing = 0;
        for (int k = 0; k < 3; k++) {
            along += hits[i].normal[k] * itself[i].normal[k];
            facing += hits[i].normal[k] * c.ray.direction[k];
        }
        same = hits[i].multiplicity == itself[i].multiplicity && hits[i].side == itself[i].side &&
               fabs(hits[i].t - itself[i].t) <= 1e-6 * (1 + fabs(itself[i].t));
        if (hits[i].multiplicity == 0) continue;                 /* a ray in the surface */
        if (i > 0 && hits[i].t - hits[i - 1].t < 1e-6) continue; /* what is shortly before it? */
        /* P's own gradient, beside the hit by rounding, may be that of either side where the power is even */
        same &= fabs(along) > 0.99 && (hits[i].multiplicity % 2 || facing * hits[i].side < 1e-6);
    }
    if (same) return;
    answer.first = first, answer.count = count;
    memcpy(answer.all, hits, sizeof hits);
    for (int i = 0; i < its_count; i++)
        fprintf(stderr, "itself: multiplicity %d side %d at %a\n", itself[i].multiplicity, itself[i].side,
                itself[i].t);
    fprintf(stderr, "seed %llu, side %d\n", (unsigned long long)first_seed, side);
    intersect_fail("not as P itself", &c, &answer);
}

/* A packet of one ray that does not ask for sides (those that do: intersect_judge_in). */
static void judge_packet(const algsurf_extent *extent, int side) {
    const algsurf_intersect_options how = {.size = sizeof how, .side = side};
    static packet_case p = {.sideless = 1};
    algsurf_hit hit;
    packet_put(&p, 0, &c.ray);
    assert_ok(packet_ask(&p, 0, 1, c.surface, extent, &how));
    const char *wrong = packet_wrong(&p, 0, c.surface, extent, &how, &hit);
    if (!wrong) return;
    answer.first = hit, answer.count = 0;
    fprintf(stderr, "seed %llu, side %d\n", (unsigned long long)first_seed, side);
    intersect_fail(wrong, &c, &answer);
}

static void judge_rays(uint64_t *seed, int count, const algsurf_extent *extent) {
    int hits = 0;
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            double aim = i == 0 ? 0 : i % 4 ? random_unit(seed) : random_int(seed, 3) - 1;
            c.ray.direction[k] = i % 5 ? random_unit(seed) : k == (i + 1) % 3;
            c.ray.origin[k] = aim - 3 * c.ray.direction[k];
        }
        c.ray.t_min = i % 7 ? 0 : -INFINITY, c.ray.t_max = i % 11 ? INFINITY : 3;
        intersect_judge_in(&c, extent, NULL, &answer);
        hits += answer.count;
        for (int side = -1; side <= 1; side++) {
            if (i % 4 == 0) judge_against_itself(extent, side);
            judge_packet(extent, side);
        }
    }
    printf("degree %d: %d rays, %d hits\n", c.degree, count, hits);
    assert_true(hits > 0);
}

TEST(test_rays) {
    static const char *const equations[] = {"(x^2+y^2+z^2-1)^2",
                                            "-3 (x^2+y^2+z^2-1)^3",
                                            "-(x^2+y^2-z^2)^2",
                                            "(x^2+2y^2-z)^4",
                                            "(x y z - 1/8)^3",
                                            "5 (x+y+z)^6",
                                            "((x^2+y^2+z^2+3)^2-16(x^2+y^2))^2 ",
                                            "-7 x^5",
                                            "(x^4+y^4+z^4-1)^2",
                                            "(x^2+y^2+z^2-1)^12",
                                            "-(x^2 z + x y^2 - z^3/2)^2"};
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}};
    uint64_t seed = first_seed;
    for (size_t i = 0; i < sizeof equations / sizeof *equations; i++) {
        intersect_equation(&c, equations[i]);
        assert_non_null(c.surface->root);
        judge_rays(&seed, (c.degree > 12 ? 12 : 60) * rounds, i % 3 ? &ball : NULL);
    }
}

/* A point beside a hit: P has its sign there, and Q's root is far enough. */
TEST(test_leave) {
    uint64_t seed = first_seed;
    int left = 0;
    for (int k = 2; k <= 12; k++)
        for (int by = -1; by <= 1; by += 2) {
            char text[64];
            snprintf(text, sizeof text, "%d (x^2+y^2+z^2-1)^%d", by, k);
            intersect_equation(&c, text);
            for (int i = 0; i < 30; i++) {
                algsurf_hit hit, again;
                double start[3], square = -1;
                for (int a = 0; a < 3; a++) {
                    c.ray.origin[a] = i % 2 ? 0 : 2 * (a == i % 3);
                    c.ray.direction[a] = random_unit(&seed) - c.ray.origin[a];
                }
                c.ray.t_min = 0, c.ray.t_max = INFINITY;
                assert_ok(algsurf_intersect_first(c.surface, NULL, &c.ray, NULL, &hit));
                if (hit.state != ALGSURF_STATE_HIT || !intersect_unit(hit.normal)) continue;
                for (int side = -1; side <= 1; side += 2) {
                    algsurf_status status = algsurf_hit_leave(c.surface, &c.ray, &hit, side, start);
                    assert_int_equal(status == ALGSURF_OK, k % 2 || side == by);
                    if (status != ALGSURF_OK) continue;
                    square = -1;
                    for (int a = 0; a < 3; a++) square += start[a] * start[a];
                    assert_true(fabs(square) > 1e-16 && fabs(square) < 1e-5);
                    assert_true(k % 2 ? square * by * side > 0 : (square > 0) == (i % 2 == 0));
                    algsurf_ray away = {{start[0], start[1], start[2]}, {0, 0, 0}, 0, INFINITY};
                    for (int a = 0; a < 3; a++) away.direction[a] = square > 0 ? start[a] : -start[a];
                    assert_ok(algsurf_intersect_first(c.surface, NULL, &away, NULL, &again));
                    assert_true(square > 0 ? again.state == ALGSURF_STATE_MISS : again.t > 1.5);
                    left++;
                }
            }
        }
    assert_true(left > 300);
}
