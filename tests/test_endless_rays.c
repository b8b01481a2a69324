/* test_endless_rays.c - rays without ends, with far ones, and without an extent, against exact arithmetic:
 * they are answered like all others, and doubles alone decide nearly all of them.
 *
 * Breaks caught, each tried: a sign of a difference taken on one side of the piece only, or without its
 * error; the pieces before the innermost one not searched, or in the wrong order; a ray's own begin or end
 * not looked at; P's degree in place of that along the ray; rays that wait for their next piece answered in
 * another's place; a ray along a plane told by rounded slopes.
 */
#include "intersect_case.h"

#define SEED 97u

static intersect_case c;
static intersect_answer answer;

static const char *const equations[] = {
    "x^2+y^2+z^2-1",
    "x^2 z + y^2",
    "z^3+x z+y",
    "(x^2+y^2+z^2+5.44)^2 - 25(x^2+y^2)",
    "x^2 y^2+x^2 z^2+y^2 z^2+x y z",
    "(x^2+9y^2/4+z^2-1)^3 - x^2 z^3 - 9 y^2 z^3/80",
    "4(2.6x^2-y^2)(2.6y^2-z^2)(2.6z^2-x^2)-4.2(x^2+y^2+z^2-1)^2",
    "x^5+y^5+z^5-(x+y+z)^5/8 + x^2 y z - x + z/2 - 1/5",
    "x + 2 y - 3 z - 1/3",
    "((x-30)^2+(y+40)^2+z^2+5.44)^2 - 25((x-30)^2+(y+40)^2)",
    "x^14+y^14+z^14-1",
};

enum { EQUATIONS = sizeof equations / sizeof *equations };

/* Ends of all kinds, most of them none. */
static void set_ends(uint64_t *seed) {
    static const double ends[][2] = {{0, INFINITY},         {-INFINITY, INFINITY}, {-INFINITY, 0},
                                     {0x1p-1074, DBL_MAX},  {-1e6, 1e6},           {-0.3, INFINITY},
                                     {-INFINITY, 0x1.8p10}, {1e4, INFINITY}};
    const double *e = ends[random_int(seed, 3) ? random_int(seed, 3) : random_int(seed, 8)];
    c.ray.t_min = e[0], c.ray.t_max = e[1];
}

/* Rays near the surface and from far away, towards it and past it, directions of all lengths. */
static void set_ray(uint64_t *seed) {
    double far = random_int(seed, 2) ? 4 : ldexp(1, random_int(seed, 30));
    double length = random_int(seed, 4) ? 1 : ldexp(1, random_int(seed, 200) - 100);
    for (int i = 0; i < 3; i++) c.ray.direction[i] = random_unit(seed);
    for (int i = 0; i < 3; i++) {
        c.ray.origin[i] = 1.5 * random_unit(seed) - far * c.ray.direction[i];
        c.ray.direction[i] *= length;
    }
    set_ends(seed);
}

/* Small whole numbers: degrees that drop, lines in the surface, roots that touch. */
static void set_short_ray(uint64_t *seed) {
    do {
        for (int i = 0; i < 3; i++) c.ray.direction[i] = random_int(seed, 5) - 2;
    } while (c.ray.direction[0] == 0 && c.ray.direction[1] == 0 && c.ray.direction[2] == 0);
    for (int i = 0; i < 3; i++) c.ray.origin[i] = 0.25 * (random_int(seed, 17) - 8);
    set_ends(seed);
}

/* Certified against integers; by doubles alone, what is said is true.  Returns whether it is decided. */
static int judge(const algsurf_intersect_options *planes) {
    algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};
    intersect_answer exact;
    intersect_judge(&c, planes, &exact);
    if (planes) bounded.planes = planes->planes, bounded.plane_count = planes->plane_count;
    intersect_ask(&c, NULL, &bounded, &answer);
    if (answer.first.state == ALGSURF_STATE_UNDECIDED) return 0;
    if (answer.first.state != exact.first.state || answer.first.side != exact.first.side)
        intersect_fail("doubles alone say something else", &c, &answer);
    return 1;
}

TEST(random_rays) {
    uint64_t seed = SEED;
    for (int e = 0; e < EQUATIONS; e++) {
        int decided = 0, rounds = 150;
        intersect_equation(&c, equations[e]);
        for (int i = 0; i < rounds; i++) {
            set_ray(&seed);
            decided += judge(NULL);
        }
        if (!random_salt && decided < rounds * 9 / 10)
            fail_msg("seed %u, %s: only %d of %d decided", SEED, equations[e], decided, rounds);
    }
}

TEST(short_rays) {
    uint64_t seed = SEED;
    int decided = 0;
    for (int e = 0; e < EQUATIONS; e++) {
        intersect_equation(&c, equations[e]);
        for (int i = 0; i < 150; i++) {
            set_short_ray(&seed);
            decided += judge(NULL);
        }
    }
    if (!random_salt && decided < EQUATIONS * 150 / 2) fail_msg("seed %u: only %d decided", SEED, decided);
}

/* Surfaces, and rays with them, as large and as small as doubles allow. */
TEST(scales) {
    uint64_t seed = SEED;
    int decided = 0, rounds = 0;
    for (int e = 0; e < 5; e++)
        for (int scale = -240; scale <= 240; scale += 60) {
            algsurf_term terms[INTERSECT_TERMS];
            intersect_equation(&c, equations[e]);
            memcpy(terms, c.terms, (size_t)c.count * sizeof *terms);
            for (int i = 0; i < c.count; i++)
                terms[i].a =
                    ldexp(terms[i].a, -scale * (terms[i].i + terms[i].j + terms[i].k - c.degree / 2));
            assert_true(intersect_terms(&c, terms, c.count));
            for (int i = 0; i < 8; i++, rounds++) {
                set_ray(&seed);
                for (int k = 0; k < 3; k++)
                    c.ray.origin[k] = ldexp(c.ray.origin[k], scale),
                    c.ray.direction[k] = ldexp(c.ray.direction[k], scale);
                decided += judge(NULL);
            }
        }
    if (!random_salt && decided < rounds * 97 / 100)
        fail_msg("seed %u: only %d of %d decided", SEED, decided, rounds);
}

/* Directions 2^-k from one along which the degree drops: a root at about 2^k. */
TEST(nearly_asymptotic) {
    uint64_t seed = SEED;
    int decided = 0, rounds = 0;
    for (int e = 1; e <= 2; e++) {
        intersect_equation(&c, equations[e]);
        for (int k = 0; k <= 70; k++)
            for (int i = 0; i < 4; i++, rounds++) {
                set_ray(&seed);
                if (e == 1) c.ray.direction[random_int(&seed, 2) * 2] = ldexp(random_unit(&seed), -k);
                if (e == 2) c.ray.direction[2] = ldexp(random_unit(&seed), -k);
                decided += judge(NULL);
            }
    }
    if (!random_salt && decided < rounds * 2 / 5)
        fail_msg("seed %u: only %d of %d decided", SEED, decided, rounds);
}

/* Planes that cut rays without ends, and some that rays are along: on either side, or in the plane. */
TEST(planes) {
    uint64_t seed = SEED;
    int decided = 0, rounds = 0;
    for (int e = 0; e < 5; e++) {
        intersect_equation(&c, equations[e]);
        for (int i = 0; i < 100; i++, rounds++) {
            algsurf_plane plane[2] = {{{0}, 0}, {{0}, 0}};
            const algsurf_intersect_options o = {
                .size = sizeof o, .planes = plane, .plane_count = (size_t)(1 + random_int(&seed, 2))};
            int axis = random_int(&seed, 3);
            set_ray(&seed);
            for (int k = 0; k < 2; k++) {
                for (int j = 0; j < 3; j++) plane[k].normal[j] = random_unit(&seed);
                plane[k].offset = 0.7 * random_unit(&seed);
            }
            if (random_int(&seed, 2)) { /* along the first one */
                for (int j = 0; j < 3; j++) plane[0].normal[j] = j == axis;
                c.ray.direction[axis] = random_int(&seed, 4) ? 0 : ldexp(1, -1074);
                c.ray.origin[axis] = random_int(&seed, 8) ? c.ray.origin[axis] : plane[0].offset;
            }
            decided += judge(&o);
        }
    }
    if (!random_salt && decided < rounds * 4 / 5)
        fail_msg("seed %u: only %d of %d decided", SEED, decided, rounds);
}

/* Many rays together, by every kernel: each has the answer that it has alone. */
TEST(packets) {
    enum { RAYS = 203 };
    static packet_case p = {.masked = 1};
    uint64_t seed = SEED;
    algsurf_intersect_options o = {.size = sizeof o};
    for (int e = 0; e < EQUATIONS; e++) {
        intersect_equation(&c, equations[e]);
        for (int i = 0; i < RAYS; i++) {
            set_ray(&seed);
            packet_put(&p, i, &c.ray);
            p.active[i] = random_int(&seed, 9) > 0;
        }
        for (int kernel = 0; (o.kernel = algsurf_kernel_name(kernel)) != NULL; kernel++) {
            memset(p.state, 77, sizeof p.state), memset(p.occluded, 77, sizeof p.occluded);
            assert_ok(packet_ask(&p, 0, RAYS, c.surface, NULL, &o));
            for (int i = 0; i < RAYS; i++) {
                algsurf_hit h;
                const char *wrong = p.active[i] ? packet_wrong(&p, i, c.surface, NULL, NULL, &h) : NULL;
                assert_true(p.active[i] || (p.state[i] == 77 && p.occluded[i] == 77));
                if (!wrong && (!p.active[i] || p.occluded[i] == p.state[i])) continue;
                answer = (intersect_answer){.first = h, .occluded = p.occluded[i]};
                c.ray = packet_ray(&p, i);
                fprintf(stderr, "seed %u, %s, ray %d: state %d, t %a\n", SEED, o.kernel, i, p.state[i],
                        p.t[i]);
                intersect_fail("a packet says something else", &c, &answer);
            }
        }
    }
}
