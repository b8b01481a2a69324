/* test_intersect_packet.c - packets of rays against the engine that computes with integers, and against exact
 * arithmetic.
 *
 * Breaks caught, each tried: the rounding of the values or of the chord's ends left out of the bounds, the
 * bound of the ends without that of the extent, an end that is not looked at, an undecided lane told as a
 * miss, the middle of a far chord without double-double, no step on P itself, a lane that depends on its
 * neighbours, a mask or a count not looked at, rays not checked, a kernel that undecided everything, an
 * environment left as the caller's, a single call with other bits than a packet.
 */
#define PACKET_MOST 33
#include "intersect_case.h"

#include "catalogue.h"
#include "environments.h"
#include "rays/exact_ray.h"
#include "rays/packets.h"
#include "scenes.h"

#define SEED 47u
enum { MOST = PACKET_MOST };

static packet_case p, q;
static const algsurf_surface *surface;

/* Both calls for rays first .. first+count-1. */
static int ask(packet_case *c, int first, int count, const algsurf_extent *extent,
               const algsurf_intersect_options *options) {
    return packet_ask(c, first, count, surface, extent, options);
}

static _Noreturn void packet_fail(const char *what, const packet_case *c, int i, const algsurf_hit *single) {
    algsurf_ray ray = packet_ray(c, i);
    exact_print_doubles("origin", ray.origin, 3), exact_print_doubles("direction", ray.direction, 3);
    fprintf(stderr, "t in [%a, %a]\n", ray.t_min, ray.t_max);
    fprintf(stderr, "packet: state %d side %d at %a in [%a, %a], occluded %d\n", c->state[i], c->side[i],
            c->t[i], c->t_lo[i], c->t_hi[i], c->occluded[i]);
    if (single)
        fprintf(stderr, "single: state %d side %d at %a in [%a, %a]\n", single->state, single->side,
                single->t, single->t_lo, single->t_hi);
    fail_msg("seed %u: %s: ray %d", SEED, what, i);
    abort();
}

typedef struct tally {
    int rays, hits, misses, multiple, normals;
} tally;

static tally tallied;

/* What the rounding of P, and of a point far from the origin of the ray, can do to t. */
static double t_bound(const algsurf_ray *ray, const algsurf_hit *hit) {
    double value, gradient[3], bound, slope = 0, size = fabs(hit->t), longest = 0;
    if (algsurf_surface_gradient(surface, hit->position, &value, gradient, &bound, NULL) != ALGSURF_OK)
        return INFINITY;
    for (int k = 0; k < 3; k++) longest = fmax(longest, fabs(ray->direction[k]));
    for (int k = 0; k < 3; k++) slope += gradient[k] * (ray->direction[k] / longest);
    for (int k = 0; k < 3; k++) size = fmax(size, fabs(ray->origin[k]) / longest);
    return slope == 0 ? INFINITY : 4 * bound / fabs(slope) / longest + 0x1p-50 * size + 0x1p-1074;
}

/* The normal is the gradient's direction, where the gradient is not mostly cancelled. */
static void judge_normal(const packet_case *c, int i, const algsurf_hit *hit) {
    double value, gradient[3], bound[3], size = 0, cancelled = 0, difference = 0;
    if (algsurf_surface_gradient(surface, hit->position, &value, gradient, NULL, bound) != ALGSURF_OK) return;
    for (int k = 0; k < 3; k++) size += gradient[k] * gradient[k], cancelled = fmax(cancelled, bound[k]);
    size = sqrt(size);
    if (!(size > 1e10 * cancelled && size < INFINITY)) return;
    for (int k = 0; k < 3; k++) difference = fmax(difference, fabs(hit->normal[k] - gradient[k] / size));
    if (!(difference < 1e-6)) packet_fail("normal", c, i, NULL);
    tallied.normals++;
}

/* What integers say of a ray. */
static algsurf_hit exact_hit(const algsurf_ray *ray, const algsurf_extent *extent) {
    const algsurf_i_region region = {extent, NULL, 0};
    algsurf_i_ray_root root;
    int count = 0;
    algsurf_hit hit = {.state = ALGSURF_STATE_MISS, .t = INFINITY, .t_lo = INFINITY, .t_hi = INFINITY};
    assert_ok(algsurf_i_exact_roots(surface, &region, ray,
                                    &(algsurf_i_wanted){ALGSURF_WANT_FIRST, .limit = ALGSURF_DEFAULT_MEMORY},
                                    &root, &count, &hit.side));
    if (count == 0) return hit;
    hit = (algsurf_hit){.state = ALGSURF_STATE_HIT,
                        .multiplicity = root.multiplicity,
                        .side = root.side,
                        .t = root.t,
                        .t_lo = root.t_lo,
                        .t_hi = root.t_hi};
    for (int k = 0; k < 3; k++) hit.position[k] = fma(root.t, ray->direction[k], ray->origin[k]);
    return hit;
}

/* Ray i of a packet that was asked, beside what integers say. */
static void judge(const packet_case *c, int i, const algsurf_extent *extent,
                  const algsurf_intersect_options *options) {
    algsurf_ray ray = packet_ray(c, i);
    algsurf_hit single = exact_hit(&ray, extent), hit = packet_hit(c, i);
    algsurf_hit alone;
    const char *wrong = packet_wrong(c, i, surface, extent, options, &alone);
    if (wrong) packet_fail(wrong, c, i, &alone);
    if (hit.state != single.state) packet_fail("state", c, i, &single);
    if (c->occluded[i] != single.state) packet_fail("occluded", c, i, &single);
    if (hit.multiplicity != single.multiplicity) packet_fail("multiplicity", c, i, &single);
    if (hit.side != single.side) packet_fail("side", c, i, &single);
    tallied.rays++, tallied.hits += hit.state == ALGSURF_STATE_HIT;
    tallied.misses += hit.state == ALGSURF_STATE_MISS, tallied.multiple += hit.multiplicity > 1;
    if (hit.state != ALGSURF_STATE_HIT) {
        if (memcmp(&hit, &single, sizeof hit) != 0) packet_fail("a miss with numbers", c, i, &single);
        return;
    }
    if (!(hit.t_lo <= hit.t && hit.t <= hit.t_hi)) packet_fail("t outside of its interval", c, i, &single);
    if (!(hit.t_lo <= single.t_hi && single.t_lo <= hit.t_hi)) packet_fail("intervals apart", c, i, &single);
    double bound = hit.multiplicity == 1 ? t_bound(&ray, &hit) : 0x1p-52 * fabs(hit.t) + 0x1p-1074;
    if (!(fabs(hit.t - single.t) <= bound)) packet_fail("t", c, i, &single);
    for (int k = 0; k < 3; k++) {
        double reach = bound * fabs(ray.direction[k]) + 0x1p-50 * fabs(hit.position[k]);
        reach += 0x1p-50 * (fabs(ray.origin[k]) + fabs(hit.t * ray.direction[k]));
        if (bound < INFINITY && !(fabs(hit.position[k] - single.position[k]) <= reach))
            packet_fail("position", c, i, &single);
    }
    judge_normal(c, i, &hit);
}

/* The first `count` rays by every kernel: the same bits, and what integers say. */
static void judge_all(int count, const algsurf_extent *extent) {
    for (int k = 0; algsurf_kernel_name(k); k++) {
        const algsurf_intersect_options options = {.size = sizeof options, .kernel = algsurf_kernel_name(k)};
        packet_case *c = k ? &q : &p;
        if (k) q = p, memset(q.state, 9, (size_t)count), memset(q.t, 9, (size_t)count * sizeof *q.t);
        assert_ok(ask(c, 0, count, extent, &options));
        for (int i = 0; k == 0 && i < count; i++) judge(c, i, extent, &options);
        if (k && memcmp(&p, &q, sizeof p) != 0) fail_msg("seed %u: %s differs", SEED, options.kernel);
    }
}

enum kind { OUTSIDE, INSIDE, FAR, LENGTHS, AXIS, ON_SURFACE, ENDS, PARTS, GRAZING, KINDS };

static double size_of(const algsurf_extent *e) { return e->size[0]; }

/* Towards a point of the extent's middle, from a distance in its sizes. */
static algsurf_ray ray_from(uint64_t *seed, const algsurf_extent *e, double distance) {
    algsurf_ray ray = {.t_min = 0, .t_max = INFINITY};
    double size = size_of(e), eye[3], length = 0;
    for (int k = 0; k < 3; k++) eye[k] = random_unit(seed), length += eye[k] * eye[k];
    for (int k = 0; k < 3; k++) {
        ray.origin[k] = e->centre[k] + distance * size * eye[k] / sqrt(length);
        ray.direction[k] = e->centre[k] + 0.7 * size * random_unit(seed) - ray.origin[k];
    }
    return ray;
}

/* A hit, to aim at; 0 if that ray has none. */
static int find_hit(uint64_t *seed, const algsurf_extent *e, double distance, algsurf_ray *ray,
                    algsurf_hit *hit) {
    *ray = ray_from(seed, e, distance);
    assert_ok(algsurf_intersect_first(surface, e, ray, NULL, hit));
    return hit->state == ALGSURF_STATE_HIT;
}

/* Past the hit at a distance, across its normal, from `back` lengths of the direction away. */
static algsurf_ray tangent_at(uint64_t *seed, const algsurf_hit *hit, double distance, double back) {
    algsurf_ray ray = {.t_min = back - 1, .t_max = back + 3};
    double a[3];
    for (int k = 0; k < 3; k++) a[k] = random_unit(seed);
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        ray.direction[k] = a[i] * hit->normal[j] - a[j] * hit->normal[i];
        ray.origin[k] = hit->position[k] + distance * hit->normal[k] - back * ray.direction[k];
    }
    return ray;
}

static algsurf_ray make_ray(uint64_t *seed, const algsurf_extent *e, enum kind kind) {
    algsurf_ray ray = ray_from(seed, e,
                               kind == INSIDE  ? 0.5 * fabs(random_unit(seed))
                               : kind == FAR   ? pow(10, 1 + random_int(seed, 6))
                               : kind == PARTS ? 1.5
                                               : 4);
    algsurf_hit hit;
    if (kind == LENGTHS) {
        int k = random_int(seed, 81) - 40;
        for (int i = 0; i < 3; i++) ray.direction[i] = ldexp(ray.direction[i], k);
    } else if (kind == AXIS) {
        int axis = random_int(seed, 3);
        for (int i = 0; i < 3; i++) {
            if (i != axis) ray.origin[i] += ray.direction[i];
            if (i != axis) ray.direction[i] = random_int(seed, 2) ? 0 : -0.0;
        }
    } else if (kind == ON_SURFACE && find_hit(seed, e, 4, &ray, &hit)) {
        for (int i = 0; i < 3; i++) {
            ray.origin[i] = hit.position[i] + (random_int(seed, 2) ? 1e-9 * hit.normal[i] : 0);
            ray.direction[i] = random_unit(seed);
        }
    } else if (kind == ENDS && find_hit(seed, e, random_int(seed, 2) ? 4 : 1e6, &ray, &hit)) {
        double t = nextafter(hit.t, random_unit(seed));
        if (random_int(seed, 2))
            ray.t_max = random_int(seed, 2) ? t : hit.t;
        else
            ray.t_min = random_int(seed, 2) ? t : hit.t;
    } else if (kind == PARTS) {
        ray.t_min = random_unit(seed) * 2;
        ray.t_max = random_int(seed, 9) ? ray.t_min + random_unit(seed) : ray.t_min;
    } else if (kind == GRAZING && find_hit(seed, e, 4, &ray, &hit)) {
        double side = random_int(seed, 2) ? 1 : -1, back = random_int(seed, 2) ? 1 : 1e6;
        double distance = ldexp(size_of(e), -random_int(seed, back > 1 ? 45 : 60));
        ray = tangent_at(seed, &hit, side * distance, back);
    }
    return ray;
}

/* Rays of one kind with one entry of the catalogue, in its ball, in a box, or in all of space. */
static void judge_kind(uint64_t *seed, const catalogue_entry *entry, enum kind kind) {
    const algsurf_extent *ball = &entry->extent;
    double s = size_of(ball);
    const algsurf_extent box = {
        ALGSURF_EXTENT_BOX, {ball->centre[0], ball->centre[1], ball->centre[2]}, {0.5 * s, 0.6 * s, 0.7 * s}};
    const algsurf_extent *const extents[] = {ball, &box, NULL};
    for (int e = 0; e < 3; e++) {
        for (int i = 0; i < MOST; i++) {
            algsurf_ray ray = make_ray(seed, ball, kind);
            double ends[2] = {0, 0}, d = 0;
            for (int k = 0; k < 3; k++) d = fmax(d, fabs(ray.direction[k]));
            for (int k = 0; k < 3; k++) ends[1] = fmax(ends[1], fabs(ray.origin[k] - ball->centre[k]) / d);
            if (!extents[e] && i % 8) { /* no extent: finite, but for some */
                ray.t_min = fmax(ray.t_min, ends[1] - 3 * s / d);
                ray.t_max = fmin(ray.t_max, ends[1] + 3 * s / d);
            }
            packet_put(&p, i, &ray);
        }
        judge_all(MOST, extents[e]);
    }
}

TEST(test_catalogue) {
    uint64_t seed = SEED;
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        surface = surface_of(entry->equation);
        tallied = (tally){0};
        for (int kind = 0; kind < KINDS; kind++)
            for (int round = 0; round < 4; round++) judge_kind(&seed, entry, (enum kind)kind);
        if (!random_salt && (tallied.hits * 4 < tallied.rays || tallied.misses * 20 < tallied.rays ||
                             tallied.normals * 4 < tallied.hits * 3))
            fail_msg("%s: %d rays, %d hits, %d misses, %d normals", entry->name, tallied.rays, tallied.hits,
                     tallied.misses, tallied.normals);
    }
}

/* Surfaces whose terms cancel: their values are small against the rounding of the terms. */
TEST(test_cancellation) {
    static const char *const equations[] = {
        "(x-9)^2 + (y-300)^2 + (z-2)^2 - 1",
        "(x-20)^4 - 5(x-20)^2 + (y-20)^4 - 5(y-20)^2 + (z+20)^4 - 5(z+20)^2 + 11.8",
        "4(2.618(x-3)^2 - (y-4)^2)(2.618(y-4)^2 - z^2)(2.618z^2 - (x-3)^2) - 4.236((x-3)^2+(y-4)^2+z^2-1)^2",
    };
    static const double centres[][3] = {{9, 300, 2}, {20, 20, -20}, {3, 4, 0}};
    uint64_t seed = SEED;
    tallied = (tally){0};
    for (int i = 0; i < 3; i++) {
        surface = surface_of(equations[i]);
        const algsurf_extent ball = {
            ALGSURF_EXTENT_SPHERE, {centres[i][0], centres[i][1], centres[i][2]}, {3, 0, 0}};
        for (int round = 0; round < 60; round++) {
            for (int j = 0; j < MOST; j++) {
                algsurf_ray ray = make_ray(&seed, &ball, round % 4 ? GRAZING : ENDS);
                packet_put(&p, j, &ray);
            }
            judge_all(MOST, &ball);
        }
    }
    assert_true(tallied.hits > 1000 && tallied.misses > 1000);
}

/* A ball through the hit which the ray leaves there at a slope of about 2^-k. */
static algsurf_extent ball_through(uint64_t *seed, const algsurf_ray *ray, const algsurf_hit *hit, int k) {
    algsurf_extent e = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {0, 0, 0}};
    double a[3], along = 0, square = 0, size = 0;
    for (int i = 0; i < 3; i++) a[i] = random_unit(seed);
    for (int i = 0; i < 3; i++) {
        along += a[i] * ray->direction[i];
        square += ray->direction[i] * ray->direction[i];
    }
    for (int i = 0; i < 3; i++) {
        e.centre[i] =
            hit->position[i] + a[i] - (along / square + ldexp(1, -k) / sqrt(square)) * ray->direction[i];
        size += pow(hit->position[i] - e.centre[i], 2);
    }
    e.size[0] = sqrt(size);
    return e;
}

/* The extent ends where the surface is hit, to the last digits. */
TEST(test_hits_on_the_extent) {
    const catalogue_entry *entry = catalogue_find("tangle");
    uint64_t seed = SEED;
    surface = surface_of(entry->equation);
    tallied = (tally){0};
    for (int round = 0; round < 750; round++) {
        algsurf_ray ray;
        algsurf_hit hit;
        int axis = random_int(&seed, 3), box = round % 2;
        if (!find_hit(&seed, &entry->extent, round % 3 ? 2 : 1e5, &ray, &hit)) continue;
        algsurf_extent e = ball_through(&seed, &ray, &hit, random_int(&seed, 30));
        if (box) {
            e = (algsurf_extent){ALGSURF_EXTENT_BOX, {0.1, -0.2, 0.3}, {4, 4, 4}};
            e.size[axis] = fabs(hit.position[axis] - e.centre[axis]);
        }
        double *size = &e.size[box ? axis : 0];
        *size = nextafter(nextafter(nextafter(*size, 0), 0), 0);
        for (int i = 0; i < 7; i++) { /* seven neighbouring sizes */
            packet_put(&p, 0, &ray);
            judge_all(1, &e);
            *size = nextafter(*size, 9);
        }
    }
    assert_true(tallied.hits > 1000 && tallied.misses > 1000);
}

/* Exactly tangent, exactly at the ends, along double lines. */
TEST(test_undecided_rays) {
    static const struct {
        const char *equation;
        algsurf_ray ray;
    } odd[] = {
        {"x^2 + y^2 + z^2 - 1", {{-4, 1, 0}, {1, 0, 0}, 0, 9}},
        {"x^2 + y^2 + z^2 - 1", {{-4, 0, 0}, {1, 0, 0}, 0, 3}},
        {"x^2 + y^2 + z^2 - 1", {{-4, 0, 0}, {1, 0, 0}, 3, 9}},
        {"x^2 + y^2 + z^2 - 1", {{-4, 0, 0}, {1, 0, 0}, 5, 5}},
        {"x^2 + y^2 + z^2 - 1", {{-4, 0, 0}, {1, 0, 0}, 3.5, 4.5}},
        {"x^2 z + y^2", {{0, 0, -2}, {0, 0, 1}, 0, 4}},
        {"x^2 z + y^2", {{-1, 0, 1}, {1, 0, 0}, 0, 4}},
        {"x^2y^2 + x^2z^2 + y^2z^2 + x y z", {{-3, 0, 0}, {1, 0, 0}, 0, 9}},
        {"x^2y^2 + x^2z^2 + y^2z^2 + x y z", {{-3, -3, 0}, {1, 1, 0}, 0, 9}},
        {"(x^2 + y^2 + z^2 - 1)^2", {{-4, 0.1, 0}, {1, 0, 0}, 0, 9}},
        {"x - 1", {{0, 0, 0}, {0, 1, 0}, 0, 9}},
        {"x - 1", {{1, 0, 0}, {0, 1, 0}, 0, 9}},
        {"x - 1", {{0, 0, 0}, {1, 1, 0}, 0, INFINITY}},
        {"x - 1", {{0, 0, 0}, {1, 1, 0}, -INFINITY, INFINITY}},
        {"x y z", {{1, 1, 1}, {-1, -1, -1}, 0, 3}},
        {"7", {{1, 1, 1}, {-1, -1, -1}, 0, 3}},
    };
    const algsurf_extent wide = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {64, 0, 0}};
    tallied = (tally){0};
    for (size_t i = 0; i < sizeof odd / sizeof odd[0]; i++) {
        surface = surface_of(odd[i].equation);
        packet_put(&p, 0, &odd[i].ray);
        judge_all(1, NULL);
        judge_all(1, &wide);
    }
    assert_true(tallied.multiple >= 8 && tallied.hits > 20);
}

static intersect_case c;

/* Ray i of the packet, with the packet's answers in place of a single call's, judged by a Sturm chain. */
static int judge_exactly(int i, double *error) {
    intersect_answer answer;
    c.ray = packet_ray(&p, i);
    exact_line line = exact_line_of(c.terms, c.count, c.degree, &c.ray);
    exact_sturm s = exact_sturm_of(line.c, c.degree);
    if (s.count > 0) {
        intersect_ask(&c, NULL, NULL, &answer);
        algsurf_hit hit = packet_hit(&p, i);
        if (hit.state != answer.first.state) intersect_fail("state", &c, &answer);
        hit.reason = answer.first.reason;
        answer.first = hit;
        answer.occluded = (int)p.occluded[i];
        const char *wrong = intersect_form(&c, &hit);
        if (!wrong) wrong = intersect_truth(&c, &s, &answer);
        if (!wrong) wrong = intersect_agree(&answer);
        if (wrong) intersect_fail(wrong, &c, &answer);
        *error = hit.state == ALGSURF_STATE_HIT ? intersect_error(&c, &line, &s, &hit, NULL) : 0;
        if (*error > 1000) intersect_fail("far from the root", &c, &answer);
    }
    exact_sturm_clear(&s), exact_line_clear(&line);
    return s.count > 0;
}

TEST(test_exact) {
    uint64_t seed = SEED;
    int judged = 0, hits = 0, precise = 0;
    for (int round = 0; round < 36; round++) {
        if (!intersect_random(&c, &seed, 1 + round % 12, 0)) continue;
        surface = c.surface;
        for (int i = 0; i < MOST; i++) {
            algsurf_ray ray = {.t_min = 0};
            double eye = random_int(&seed, 3) ? 4 : 0;
            for (int k = 0; k < 3; k++) {
                ray.direction[k] = random_int(&seed, 8) ? random_unit(&seed) : 0;
                ray.origin[k] = random_unit(&seed) - eye * ray.direction[k];
            }
            if (ray.direction[0] == 0 && ray.direction[1] == 0) ray.direction[2] = 1;
            ray.t_min = random_int(&seed, 3) ? 0 : -1;
            ray.t_max = random_int(&seed, 8) ? eye + 4 : 1e4;
            packet_put(&p, i, &ray);
        }
        assert_ok(ask(&p, 0, MOST, NULL, NULL));
        for (int i = 0; i < MOST; i++) {
            double error = 0;
            if (!judge_exactly(i, &error)) continue;
            judged++, hits += p.state[i] == ALGSURF_STATE_HIT;
            precise += p.state[i] == ALGSURF_STATE_HIT && error < 8;
        }
    }
    if (judged < 900 || hits * 5 < judged || precise * 100 < hits * 99)
        fail_msg("seed %u: %d rays, %d hits, %d precise", SEED, judged, hits, precise);
}

/* All terms of a degree, their sizes such that P is about the same in all directions (Kostlan). */
static algsurf_surface *dense_surface(uint64_t *seed, int n) {
    static algsurf_term terms[50000];
    int count = 0;
    for (int i = 0; i <= n; i++)
        for (int j = 0; i + j <= n; j++)
            for (int k = 0; i + j + k <= n; k++) {
                double ways =
                    lgamma(n + 1) - lgamma(i + 1) - lgamma(j + 1) - lgamma(k + 1) - lgamma(n - i - j - k + 1);
                terms[count++] = (algsurf_term){i, j, k, random_unit(seed) * exp(0.5 * ways)};
            }
    return surface_of_terms(terms, (size_t)count);
}

/* Undecided ones among some rays, by the kernel itself. */
static int undecided(const algsurf_extent *extent, int any) {
    const algsurf_ray_packet rays = {.count = MOST,
                                     .origin = {p.origin[0], p.origin[1], p.origin[2]},
                                     .direction = {p.direction[0], p.direction[1], p.direction[2]},
                                     .t_min = p.t_min,
                                     .t_max = p.t_max};
    const algsurf_i_rays_job job = {.surface = surface, .extent = extent, .rays = &rays, .any = any};
    algsurf_hit_packet hits = {.state = q.state, .t = q.t};
    int count = 0;
    algsurf_i_rays_kernel_for(algsurf_i_kernel_find(NULL))->solve(&job, &hits);
    for (int i = 0; i < MOST; i++) count += q.state[i] == ALGSURF_LANE_UNDECIDED;
    return count;
}

/* Every degree, those without packet code among them; how many rays the packet code decides is counted. */
TEST(test_degrees) {
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1.2, 0, 0}};
    const int degrees[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 33, 64};
    uint64_t seed = SEED;
    for (size_t d = 0; d < sizeof degrees / sizeof degrees[0]; d++) {
        int n = degrees[d], left = 0, rays = 0;
        surface = dense_surface(&seed, n);
        for (int round = 0; round < (n > 20 ? 1 : 12); round++) {
            for (int i = 0; i < MOST; i++) {
                algsurf_ray ray = ray_from(&seed, &ball, 4);
                packet_put(&p, i, &ray);
            }
            if (round < 2) judge_all(n > 20 ? 5 : MOST, &ball);
            if (n <= 20) left += undecided(&ball, 0) + undecided(&ball, 1), rays += 2 * MOST;
        }
        /* the bounds grow with the degree; 8 % for 20 were measured */
        if (left * 100 > rays * (n < 15 ? 1 : 20)) fail_msg("degree %d: %d of %d undecided", n, left, rays);
    }
}

TEST(test_catalogue_is_decided) {
    uint64_t seed = SEED;
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        int left = 0, rays = 0;
        surface = surface_of(entry->equation);
        for (int round = 0; round < 60; round++) {
            for (int i = 0; i < MOST; i++) {
                algsurf_ray ray = ray_from(&seed, &entry->extent, round % 2 ? 4 : 1e5);
                packet_put(&p, i, &ray);
            }
            left += undecided(&entry->extent, 0), rays += MOST;
        }
        if (left * 100 > rays) fail_msg("%s: %d of %d undecided", entry->name, left, rays);
    }
}

static const algsurf_surface *barth(void) { return surface_of(catalogue_find("barth")->equation); }

static void fill(uint64_t *seed, const algsurf_extent *extent) {
    memset(&p, 0x5a, sizeof p);
    p.masked = p.sideless = 0;
    for (int i = 0; i < MOST; i++) {
        algsurf_ray ray = make_ray(seed, extent, i % 5 ? OUTSIDE : GRAZING);
        packet_put(&p, i, &ray);
        p.active[i] = random_int(seed, 3) ? (unsigned char)(1 + random_int(seed, 255)) : 0;
    }
}

/* Any count, any mask, any split: the same bits, and not a byte of the others touched. */
TEST(test_counts_masks_splits) {
    const algsurf_extent *extent = &catalogue_find("barth")->extent;
    surface = barth();
    uint64_t seed = SEED;
    fill(&seed, extent);
    packet_case untouched = p, whole = p, single = p;
    assert_ok(ask(&whole, 0, MOST, extent, NULL));
    for (int i = 0; i < MOST; i++) assert_ok(ask(&single, i, 1, extent, NULL));
    assert_memory_equal(&whole, &single, sizeof whole);
    for (int count = 0; count <= MOST; count++)
        for (int masked = 0; masked < 2; masked++) {
            packet_case got = untouched, wanted = untouched;
            got.masked = wanted.masked = masked;
            for (int i = 0; i < count; i++) {
                if (masked && !wanted.active[i]) continue;
                wanted.state[i] = whole.state[i], wanted.occluded[i] = whole.occluded[i];
                wanted.t[i] = whole.t[i], wanted.t_lo[i] = whole.t_lo[i], wanted.t_hi[i] = whole.t_hi[i];
                for (int k = 0; k < 3; k++) {
                    wanted.position[k][i] = whole.position[k][i];
                    wanted.normal[k][i] = whole.normal[k][i];
                }
                wanted.multiplicity[i] = whole.multiplicity[i], wanted.side[i] = whole.side[i];
                wanted.reason[i] = whole.reason[i];
            }
            if (masked) /* what is not active may be anything */
                for (int i = 0; i < count; i++)
                    if (!got.active[i])
                        got.origin[0][i] = wanted.origin[0][i] = i % 2 ? INFINITY : NAN,
                        got.direction[1][i] = wanted.direction[1][i] = 0;
            assert_ok(ask(&got, 0, count, extent, NULL));
            if (memcmp(&got, &wanted, sizeof got) != 0)
                fail_msg("seed %u: count %d, masked %d", SEED, count, masked);
        }
}

/* Every array but state may be missing; t_min and t_max then are 0 and infinity. */
TEST(test_missing_arrays) {
    const algsurf_extent *extent = &catalogue_find("barth")->extent;
    surface = barth();
    uint64_t seed = SEED;
    fill(&seed, extent);
    packet_case untouched = p, whole = p;
    for (int i = 0; i < MOST; i++) whole.t_min[i] = 0, whole.t_max[i] = INFINITY;
    assert_ok(ask(&whole, 0, MOST, extent, NULL));
    algsurf_ray_packet rays = {.size = sizeof rays, .count = MOST};
    for (int k = 0; k < 3; k++) rays.origin[k] = p.origin[k], rays.direction[k] = p.direction[k];
    for (int given = 0; given < 10; given++) { /* the one result asked for; 9: none */
        packet_case got = untouched;
        double *const results[] = {got.t,           got.t_lo,        got.t_hi,
                                   got.position[0], got.position[1], got.position[2],
                                   got.normal[0],   got.normal[1],   got.normal[2]};
        double *const wanted[] = {whole.t,           whole.t_lo,        whole.t_hi,
                                  whole.position[0], whole.position[1], whole.position[2],
                                  whole.normal[0],   whole.normal[1],   whole.normal[2]};
        algsurf_hit_packet hits = {.size = sizeof hits, .state = got.state};
        double **const members[] = {&hits.t,           &hits.t_lo,        &hits.t_hi,
                                    &hits.position[0], &hits.position[1], &hits.position[2],
                                    &hits.normal[0],   &hits.normal[1],   &hits.normal[2]};
        if (given < 9) *members[given] = results[given];
        assert_ok(algsurf_intersect_packet(surface, extent, &rays, NULL, &hits));
        assert_memory_equal(got.state, whole.state, sizeof got.state);
        for (int i = 0; i < 9; i++)
            assert_memory_equal(results[i], i == given ? wanted[i] : untouched.t, sizeof untouched.t);
    }
}

/* Refused by both calls, nothing written. */
static void refuse(algsurf_status expected, const algsurf_extent *extent,
                   const algsurf_intersect_options *options) {
    packet_case before = p;
    assert_int_equal(ask(&p, 0, MOST, extent, options), expected);
    assert_memory_equal(&p, &before, sizeof p);
}

/* A bad ray is refused by itself, as by the single call; all others have the bits that they have without it.
 */
static void refuse_ray(algsurf_status expected, int bad, const packet_case *answered,
                       const algsurf_extent *extent) {
    const packet_case asked = p;
    packet_case wanted = *answered;
    algsurf_ray ray = packet_ray(&p, bad);
    algsurf_hit hit;
    assert_int_equal(algsurf_intersect_first(surface, extent, &ray, NULL, &hit), expected);
    assert_int_equal(ask(&p, 0, MOST, extent, NULL), expected);
    memcpy(wanted.origin, asked.origin, sizeof p.origin);
    memcpy(wanted.direction, asked.direction, sizeof p.direction);
    memcpy(wanted.t_min, asked.t_min, sizeof p.t_min), memcpy(wanted.t_max, asked.t_max, sizeof p.t_max);
    wanted.state[bad] = wanted.occluded[bad] = ALGSURF_STATE_REFUSED;
    wanted.reason[bad] = (signed char)expected;
    wanted.t[bad] = wanted.t_lo[bad] = wanted.t_hi[bad] = INFINITY;
    wanted.multiplicity[bad] = wanted.side[bad] = 0;
    for (int k = 0; k < 3; k++) wanted.position[k][bad] = wanted.normal[k][bad] = 0;
    assert_memory_equal(&p, &wanted, sizeof p);
}

TEST(test_bad_rays) {
    const algsurf_extent *extent = &catalogue_find("barth")->extent;
    surface = barth();
    uint64_t seed = SEED;
    fill(&seed, extent);
    const packet_case good = p;
    static packet_case answered;
    assert_ok(ask(&p, 0, MOST, extent, NULL));
    answered = p;
    for (int i = 0; i < MOST; i += 15) {
        p = good, p.origin[1][i] = NAN, refuse_ray(ALGSURF_E_NOT_FINITE, i, &answered, extent);
        p = good, p.direction[2][i] = INFINITY, refuse_ray(ALGSURF_E_NOT_FINITE, i, &answered, extent);
        p = good, p.t_min[i] = NAN, refuse_ray(ALGSURF_E_NOT_FINITE, i, &answered, extent);
        p = good, p.t_max[i] = NAN, refuse_ray(ALGSURF_E_NOT_FINITE, i, &answered, extent);
        p = good, p.direction[0][i] = p.direction[1][i] = p.direction[2][i] = 0;
        refuse_ray(ALGSURF_E_ARGUMENT, i, &answered, extent);
    }
    /* the first one counts, of those that are active */
    p = good, p.direction[0][20] = p.direction[1][20] = p.direction[2][20] = 0, p.origin[0][21] = NAN;
    assert_int_equal(ask(&p, 0, MOST, extent, NULL), ALGSURF_E_ARGUMENT);
    assert_true(p.reason[20] == ALGSURF_E_ARGUMENT && p.reason[21] == ALGSURF_E_NOT_FINITE);
    p.masked = 1, p.active[20] = 0, p.active[21] = 1;
    assert_int_equal(ask(&p, 0, MOST, extent, NULL), ALGSURF_E_NOT_FINITE);
}

/* Arrays of structs, of doubles and of floats, have the bits of arrays of doubles. */
TEST(test_layouts) {
    typedef struct in_doubles {
        double origin[3], t_min, direction[3], t_max;
        int id;
    } in_doubles;
    typedef struct in_floats {
        float origin[3], t_min, direction[3], t_max, other;
    } in_floats;
    static in_doubles a[MOST];
    static in_floats f[MOST];
    static packet_case got;
    const algsurf_extent *extent = &catalogue_find("barth")->extent;
    surface = barth();
    uint64_t seed = SEED;
    fill(&seed, extent);
    for (int i = 0; i < MOST; i++)
        for (int k = 0; k < 3; k++) {
            f[i].origin[k] = (float)p.origin[k][i], f[i].direction[k] = (float)p.direction[k][i];
            f[i].t_min = (float)p.t_min[i], f[i].t_max = (float)p.t_max[i], f[i].other = NAN;
            a[i].origin[k] = p.origin[k][i] = f[i].origin[k];
            a[i].direction[k] = p.direction[k][i] = f[i].direction[k];
            a[i].t_min = p.t_min[i] = f[i].t_min, a[i].t_max = p.t_max[i] = f[i].t_max, a[i].id = -1;
        }
    for (int floats = 0; floats < 2; floats++) {
        got = p;
        algsurf_hit_packet hits = {.size = sizeof hits, .state = got.state, .t = got.t, .t_hi = got.t_hi};
        algsurf_ray_packet rays = {.size = sizeof rays, .count = MOST};
        rays.step = (ptrdiff_t)(floats ? sizeof *f / sizeof(float) : sizeof *a / sizeof(double));
        for (int k = 0; k < 3; k++) {
            hits.normal[k] = got.normal[k];
            if (floats)
                rays.float_origin[k] = f->origin + k, rays.float_direction[k] = f->direction + k;
            else
                rays.origin[k] = a->origin + k, rays.direction[k] = a->direction + k;
        }
        if (floats)
            rays.float_t_min = &f->t_min, rays.float_t_max = &f->t_max;
        else
            rays.t_min = &a->t_min, rays.t_max = &a->t_max;
        assert_ok(algsurf_intersect_packet(surface, extent, &rays, NULL, &hits));
        assert_ok(algsurf_occluded_packet(surface, extent, &rays, NULL, got.occluded));
        assert_ok(ask(&p, 0, MOST, extent, NULL));
        assert_memory_equal(got.state, p.state, sizeof p.state);
        assert_memory_equal(got.occluded, p.occluded, sizeof p.occluded);
        assert_memory_equal(got.t, p.t, sizeof p.t);
        assert_memory_equal(got.t_hi, p.t_hi, sizeof p.t_hi);
        assert_memory_equal(got.normal, p.normal, sizeof p.normal);
        /* backwards; and not both kinds at once */
        const double *doubles = p.t_min;
        rays.step = -rays.step;
        for (int k = 0; k < 3; k++)
            if (floats)
                rays.float_origin[k] = f[MOST - 1].origin + k,
                rays.float_direction[k] = f[MOST - 1].direction + k;
            else
                rays.origin[k] = a[MOST - 1].origin + k, rays.direction[k] = a[MOST - 1].direction + k;
        if (floats)
            rays.float_t_min = &f[MOST - 1].t_min, rays.float_t_max = &f[MOST - 1].t_max;
        else
            rays.t_min = &a[MOST - 1].t_min, rays.t_max = &a[MOST - 1].t_max;
        assert_ok(algsurf_intersect_packet(surface, extent, &rays, NULL, &hits));
        for (int i = 0; i < MOST; i++) assert_memory_equal(got.t + i, p.t + MOST - 1 - i, sizeof *p.t);
        if (floats)
            rays.t_min = doubles;
        else
            rays.float_direction[2] = f->direction;
        assert_int_equal(algsurf_intersect_packet(surface, extent, &rays, NULL, &hits), ALGSURF_E_ARGUMENT);
    }
}

TEST(test_errors) {
    const algsurf_extent *extent = &catalogue_find("barth")->extent;
    surface = barth();
    uint64_t seed = SEED;
    algsurf_extent bad = *extent;
    algsurf_intersect_options options = {.size = sizeof options};
    fill(&seed, extent);
    bad.size[0] = 0, refuse(ALGSURF_E_ARGUMENT, &bad, NULL);
    options.kernel = "avx1024", refuse(ALGSURF_E_ARGUMENT, extent, &options);
    options.kernel = "", refuse(ALGSURF_E_ARGUMENT, extent, &options);
    options.kernel = NULL, options.absolute_tolerance = -1, refuse(ALGSURF_E_ARGUMENT, extent, &options);

    algsurf_ray_packet rays = {.size = sizeof rays, .count = 1};
    for (int k = 0; k < 3; k++) rays.origin[k] = p.origin[k], rays.direction[k] = p.direction[k];
    algsurf_hit_packet hits = {.size = sizeof hits, .state = p.state};
    assert_int_equal(algsurf_intersect_packet(NULL, NULL, &rays, NULL, &hits), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_packet(surface, NULL, NULL, NULL, &hits), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_packet(surface, NULL, &rays, NULL, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_occluded_packet(surface, NULL, &rays, NULL, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_occluded_packet(surface, NULL, NULL, NULL, p.state), ALGSURF_E_ARGUMENT);
    hits.state = NULL;
    assert_int_equal(algsurf_intersect_packet(surface, NULL, &rays, NULL, &hits), ALGSURF_E_ARGUMENT);
    hits.state = p.state, rays.origin[2] = NULL;
    assert_int_equal(algsurf_intersect_packet(surface, NULL, &rays, NULL, &hits), ALGSURF_E_ARGUMENT);
    rays.origin[2] = p.origin[2];
    for (rays.size = 0; rays.size < sizeof rays; rays.size++) /* no release had a smaller one */
        assert_int_equal(algsurf_intersect_packet(surface, NULL, &rays, NULL, &hits), ALGSURF_E_SIZE);
    for (hits.size = 0; hits.size < sizeof hits; hits.size++)
        assert_int_equal(algsurf_intersect_packet(surface, NULL, &rays, NULL, &hits), ALGSURF_E_SIZE);
    const algsurf_ray_packet none = {.size = sizeof none};
    const algsurf_hit_packet nowhere = {.size = sizeof nowhere};
    assert_ok(algsurf_intersect_packet(surface, extent, &none, NULL, &nowhere));
    assert_ok(algsurf_occluded_packet(surface, extent, &none, NULL, NULL));
}

TEST(test_kernel_names) {
    const algsurf_ray ray = {{0, 0, -4}, {0, 0, 1}, 0, 9};
    surface = barth();
    algsurf_intersect_options options = {.size = sizeof options};
    algsurf_hit hit;
    int occluded;
    int count = 0, room;
    while (algsurf_kernel_name(count)) {
        char name[16];
        snprintf(name, sizeof name, "%s", algsurf_kernel_name(count++));
        options.kernel = name;
        assert_ok(algsurf_intersect_first(surface, NULL, &ray, &options, &hit));
    }
    assert_true(count >= 1 && count <= 3);
    assert_string_equal(algsurf_kernel_name(count - 1), "baseline");
    assert_null(algsurf_kernel_name(-1));
    options.kernel = "sse9";
    assert_int_equal(algsurf_intersect_first(surface, NULL, &ray, &options, &hit), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_all(surface, NULL, &ray, &options, &hit, 1, &room),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_occluded(surface, NULL, &ray, &options, &occluded), ALGSURF_E_ARGUMENT);
}

/* Other methods, limits and tolerances: the bits of single calls, or as near as asked. */
TEST(test_options) {
    const algsurf_extent *extent = &catalogue_find("barth")->extent;
    surface = barth();
    uint64_t seed = SEED;
    fill(&seed, extent);
    for (int method = ALGSURF_METHOD_DEFAULT; method <= ALGSURF_METHOD_REGULA_FALSI; method++) {
        algsurf_intersect_options options = {.size = sizeof options, .method = method};
        options.max_iterations = method == ALGSURF_METHOD_DEFAULT ? 100 : 0;
        options.absolute_tolerance = 1e-4;
        assert_ok(ask(&p, 0, MOST, extent, &options));
        for (int i = 0; i < MOST; i++) {
            algsurf_hit single;
            assert_null(packet_wrong(&p, i, surface, extent, &options, &single));
        }
    }
    algsurf_intersect_options options = {.size = sizeof options, .absolute_tolerance = 1e-4};
    assert_ok(ask(&p, 0, MOST, extent, &options));
    for (int i = 0; i < MOST; i++) {
        algsurf_ray ray = packet_ray(&p, i);
        algsurf_hit exact = first_hit_of(surface, extent, &ray, NULL);
        assert_int_equal(p.state[i], exact.state);
        if (p.state[i] == ALGSURF_STATE_HIT) assert_true(fabs(p.t[i] - exact.t) <= 1e-4);
    }
}

/* The same scene larger or smaller, up to sizes that packets leave to single calls. */
TEST(test_scales) {
    uint64_t seed = SEED;
    algsurf_term terms[INTERSECT_TERMS];
    tallied = (tally){0};
    for (int k = -280; k <= 280; k += 35) {
        intersect_equation(&c, "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8");
        memcpy(terms, c.terms, sizeof terms);
        int count = c.count;
        for (int i = 0; i < count; i++)
            terms[i].a = ldexp(terms[i].a, (4 - terms[i].i - terms[i].j - terms[i].k) * k - 2 * k);
        assert_true(intersect_terms(&c, terms, count));
        surface = c.surface;
        const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, ldexp(0.1, k)}, {ldexp(3.7, k), 0, 0}};
        const algsurf_extent box = {
            ALGSURF_EXTENT_BOX, {0, ldexp(0.1, k), 0}, {ldexp(2, k), ldexp(2.5, k), ldexp(3, k)}};
        for (int round = 0; round < 4; round++) {
            for (int i = 0; i < MOST; i++) {
                algsurf_ray ray = ray_from(&seed, &ball, 4);
                int length = round == 3 ? random_int(&seed, 1200) - 600 : 0;
                for (int j = 0; j < 3; j++) ray.direction[j] = ldexp(ray.direction[j], length);
                packet_put(&p, i, &ray);
            }
            judge_all(MOST, round % 2 ? &ball : &box);
        }
    }
    assert_true(tallied.hits * 2 > tallied.rays);
}

/* Directions 2^k times as long, in the bounded tier: t is 2^-k times as large, all else has the same bits. */
TEST(test_lengths) {
    const int lengths[] = {-700, -300, -101, 101, 300, 700};
    const algsurf_intersect_options options = {.size = sizeof options, .tier = ALGSURF_TIER_BOUNDED};
    uint64_t seed = SEED;
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        surface = surface_of(entry->equation);
        for (int k = 0; k < 6; k++) {
            for (int i = 0; i < MOST; i++) {
                algsurf_ray ray = make_ray(&seed, &entry->extent, i % 3 ? OUTSIDE : PARTS);
                packet_put(&p, i, &ray);
            }
            q = p;
            for (int i = 0; i < MOST; i++) {
                for (int j = 0; j < 3; j++) q.direction[j][i] = ldexp(p.direction[j][i], lengths[k]);
                q.t_min[i] = ldexp(p.t_min[i], -lengths[k]), q.t_max[i] = ldexp(p.t_max[i], -lengths[k]);
            }
            assert_ok(ask(&p, 0, MOST, &entry->extent, &options));
            assert_ok(ask(&q, 0, MOST, &entry->extent, &options));
            for (int i = 0; i < MOST; i++) {
                algsurf_hit plain = packet_hit(&p, i), scaled = packet_hit(&q, i);
                scaled.t = ldexp(scaled.t, lengths[k]);
                scaled.t_lo = ldexp(scaled.t_lo, lengths[k]), scaled.t_hi = ldexp(scaled.t_hi, lengths[k]);
                if (plain.state != ALGSURF_STATE_UNDECIDED && memcmp(&plain, &scaled, sizeof plain) != 0)
                    packet_fail("another length", &q, i, &plain);
            }
        }
    }
}

/* Directions, and ends, that underflow or overflow where t is measured in the surface's unit. */
TEST(test_out_of_range) {
    const double ends[] = {0, 0x1p-1074, 0x1p-1022, 0x1p-900, 0x1p900, DBL_MAX, INFINITY};
    const double lengths[] = {0x1p-1070, 0x1p-1023, 0x1p-1020, 1, 0x1p1021, 0x1p1023};
    enum { ENDS_COUNT = sizeof ends / sizeof ends[0], LENGTHS_COUNT = sizeof lengths / sizeof lengths[0] };
    uint64_t seed = SEED;
    tallied = (tally){0};
    for (int k = -800; k <= 800; k += 400) {
        double size = ldexp(1.2, k / 2);
        const algsurf_extent extents[] = {{ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {size, 0, 0}},
                                          {ALGSURF_EXTENT_BOX, {0, 0, 0}, {size, size, size}}};
        const algsurf_term terms[] = {{2, 0, 0, 1}, {0, 2, 0, 1}, {0, 1, 1, 1}, {0, 0, 0, -ldexp(1, k)}};
        surface = surface_of_terms(terms, 4);
        for (int i = 0; i < ENDS_COUNT * ENDS_COUNT; i++) {
            for (int j = 0; j < LENGTHS_COUNT; j++) {
                algsurf_ray ray = ray_from(&seed, extents, i % 3 ? 4 : 0.5);
                double longest = 0;
                for (int l = 0; l < 3; l++) longest = fmax(longest, fabs(ray.direction[l]));
                for (int l = 0; l < 3; l++) ray.direction[l] = ray.direction[l] / longest * lengths[j];
                ray.t_min = (i + j) % 2 ? ends[i / ENDS_COUNT] : -ends[i / ENDS_COUNT];
                ray.t_max = ends[i % ENDS_COUNT];
                packet_put(&p, j, &ray);
            }
            judge_all(LENGTHS_COUNT, &extents[i % 2]);
        }
    }
    assert_true(tallied.hits > 100 && tallied.misses > 100);
}

/* t is subnormal, and not a double: it is between two. */
TEST(test_subnormal) {
    const algsurf_term terms[] = {{1, 0, 0, 1}, {0, 1, 1, 1}};
    const algsurf_ray ray = {{0x1p-240, 0, 0}, {-3 * 0x1p788, 0, 0}, 0, 0x1p-1028};
    algsurf_surface *s = surface_of_terms(terms, 2);
    algsurf_hit hit = first_hit_of(s, NULL, &ray, NULL);
    assert_int_equal(hit.state, ALGSURF_STATE_HIT);
    assert_true(0 < hit.t_lo && hit.t_lo < hit.t_hi);
}

/* Extents far larger or smaller than the surface, and far away. */
TEST(test_odd_extents) {
    surface = barth();
    const double sizes[] = {0x1p-1000, 0x1p-500, 0x1p-120, 0x1p-40, 0x1p-20,
                            0x1p20,    0x1p40,   0x1p120,  0x1p500, 0x1p1000};
    uint64_t seed = SEED;
    for (int i = 0; i < 10; i++)
        for (int kind = 0; kind < 4; kind++) {
            algsurf_extent e = {kind % 2 ? ALGSURF_EXTENT_BOX : ALGSURF_EXTENT_SPHERE,
                                {0, 0, kind < 2 ? 1 : sizes[i]}, /* a point of the surface near it */
                                {sizes[i], sizes[i], 3 * sizes[i]}};
            for (int j = 0; j < MOST; j++) {
                algsurf_ray ray = ray_from(&seed, &e, j % 2 ? 4 : 0.5);
                packet_put(&p, j, &ray);
            }
            judge_all(MOST, &e);
        }
}

static algsurf_intersect_options by_kernel = {.size = sizeof by_kernel};

static void ask_again(void *answers) {
    q = p;
    memcpy(answers, &(int){ask(&q, 0, MOST, &catalogue_find("barth")->extent, &by_kernel)}, sizeof(int));
    memcpy((char *)answers + sizeof(int), &q, sizeof q);
}

TEST(test_environments) {
    uint64_t seed = SEED;
    surface = barth();
    fill(&seed, &catalogue_find("barth")->extent);
    for (int k = 0; (by_kernel.kernel = algsurf_kernel_name(k)); k++)
        environments_agree(ask_again, sizeof(int) + sizeof q);
}
