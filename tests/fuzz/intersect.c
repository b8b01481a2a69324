/* intersect.c - fuzzes rays: "OX OY OZ DX DY DZ T_MIN T_MAX", "KIND CX CY CZ SX SY SZ", then terms "I J K A".
 *
 * KIND: 0 no extent, 1 a ball, 2 a box.  Packets must say what single calls say, to the bit, of the ray alone
 * and among others, with every kernel; and where the numbers are short enough for the oracle, all calls must
 * say what it says: every ray is decided.  The bounded tier must not contradict the certified one.
 */
#include "intersect_case.h"
#include "fuzz.h"

enum { MOST_TERMS = 24, TOP = 8, MOST_DEGREE = 12, MOST_BITS = 9000, LANES = 5 };

static intersect_case c;
static intersect_answer answer;

/* Answers side by side, and the rays they are about. */
typedef struct packet {
    double origin[3][LANES], direction[3][LANES], t_min[LANES], t_max[LANES];
    unsigned char state[LANES], occluded[LANES];
    double t[LANES], t_lo[LANES], t_hi[LANES], position[3][LANES], normal[3][LANES];
    int multiplicity[LANES];
    signed char side[LANES];
} packet;

static void put(packet *p, int i, const algsurf_ray *ray) {
    for (int k = 0; k < 3; k++) p->origin[k][i] = ray->origin[k], p->direction[k][i] = ray->direction[k];
    p->t_min[i] = ray->t_min, p->t_max[i] = ray->t_max;
}

static void ask(packet *p, size_t count, const algsurf_extent *extent, const char *kernel) {
    const algsurf_intersect_options options = {.size = sizeof options, .kernel = kernel};
    algsurf_ray_packet rays = {.size = sizeof rays, .count = count, .t_min = p->t_min, .t_max = p->t_max};
    algsurf_hit_packet hits = {
        .size = sizeof hits, .state = p->state, .t = p->t, .t_lo = p->t_lo, .t_hi = p->t_hi};
    hits.multiplicity = p->multiplicity, hits.side = p->side;
    for (int k = 0; k < 3; k++) {
        rays.origin[k] = p->origin[k], rays.direction[k] = p->direction[k];
        hits.position[k] = p->position[k], hits.normal[k] = p->normal[k];
    }
    fuzz_check(algsurf_intersect_packet(c.surface, extent, &rays, &options, &hits) == ALGSURF_OK);
    fuzz_check(algsurf_occluded_packet(c.surface, extent, &rays, &options, p->occluded) == ALGSURF_OK);
}

static void check_bits(const packet *a, const packet *b, size_t i) {
    fuzz_check(a->state[i] == b->state[i] && a->occluded[i] == b->occluded[i]);
    fuzz_check(a->multiplicity[i] == b->multiplicity[i] && a->side[i] == b->side[i]);
    fuzz_check(memcmp(&a->t[i], &b->t[i], sizeof a->t[i]) == 0);
    fuzz_check(memcmp(&a->t_lo[i], &b->t_lo[i], sizeof a->t[i]) == 0);
    fuzz_check(memcmp(&a->t_hi[i], &b->t_hi[i], sizeof a->t[i]) == 0);
    for (int k = 0; k < 3; k++) {
        fuzz_check(memcmp(&a->position[k][i], &b->position[k][i], sizeof a->t[i]) == 0);
        fuzz_check(memcmp(&a->normal[k][i], &b->normal[k][i], sizeof a->t[i]) == 0);
    }
}

/* The ray, as first of a packet with its like: backwards, moved, cut, and along the axes. */
static void ask_packets(packet *p, const algsurf_extent *extent) {
    static packet other;
    algsurf_ray ray = c.ray;
    put(p, 0, &c.ray);
    for (int k = 0; k < 3; k++) ray.direction[k] = -ray.direction[k];
    put(p, 1, &ray);
    ray = c.ray, ray.origin[0] = ray.origin[0] / 2 + 0.125;
    put(p, 2, &ray);
    ray = c.ray, ray.t_max = ray.t_min;
    put(p, 3, &ray);
    put(p, 4, &(algsurf_ray){{0.25, 0.5, -3}, {0, 0, 1}, 0, INFINITY});
    other = *p;
    ask(p, LANES, extent, NULL);
    ask(&other, 1, extent, NULL);
    check_bits(p, &other, 0);
    const char *kernel;
    for (int i = 0; (kernel = algsurf_kernel_name(i)); i++) {
        ask(&other, LANES, extent, kernel);
        for (size_t lane = 0; lane < LANES; lane++) check_bits(p, &other, lane);
    }
}

static algsurf_ray ray_of(const packet *p, int i) {
    algsurf_ray ray = {.t_min = p->t_min[i], .t_max = p->t_max[i]};
    for (int k = 0; k < 3; k++) ray.origin[k] = p->origin[k][i], ray.direction[k] = p->direction[k][i];
    return ray;
}

/* The single calls about lane i's ray. */
static void ask_single(const packet *p, int i, const algsurf_extent *extent, int tier, algsurf_hit *hit,
                       int *occluded) {
    const algsurf_intersect_options options = {.size = sizeof options, .tier = tier};
    algsurf_ray ray = ray_of(p, i);
    fuzz_check(algsurf_intersect_first(c.surface, extent, &ray, &options, hit) == ALGSURF_OK);
    fuzz_check(algsurf_occluded(c.surface, extent, &ray, &options, occluded) == ALGSURF_OK);
}

static void check_lanes(const packet *p, const algsurf_extent *extent) {
    for (int i = 0; i < LANES; i++) {
        algsurf_hit hit;
        int occluded;
        packet one = *p;
        ask_single(p, i, extent, ALGSURF_TIER_CERTIFIED, &hit, &occluded);
        one.state[i] = (unsigned char)hit.state, one.occluded[i] = (unsigned char)occluded;
        one.multiplicity[i] = hit.multiplicity, one.side[i] = (signed char)hit.side;
        one.t[i] = hit.t, one.t_lo[i] = hit.t_lo, one.t_hi[i] = hit.t_hi;
        for (int k = 0; k < 3; k++) one.position[k][i] = hit.position[k], one.normal[k][i] = hit.normal[k];
        check_bits(p, &one, (size_t)i);
        fuzz_check(hit.state != ALGSURF_STATE_UNDECIDED && (int)occluded == hit.state);
        ask_single(p, i, extent, ALGSURF_TIER_BOUNDED, &hit, &occluded);
        fuzz_check(hit.state == ALGSURF_STATE_UNDECIDED || hit.state == p->state[i]);
        fuzz_check(occluded == ALGSURF_STATE_UNDECIDED || (int)occluded == p->occluded[i]);
    }
}

/* A hit has no position to compare where t is so large that numbers overflow, or has lost digits to
 * underflow. */
static const char *form(const algsurf_hit *h) {
    double reach = fmax(fabs(h->t_lo), fabs(h->t_hi));
    int underflow = reach > 0 && fabs(h->t) < 0x1p-960;
    for (int k = 0; k < 3; k++)
        if (h->state != ALGSURF_STATE_MISS && (underflow || !isfinite(reach * c.ray.direction[k])))
            return NULL;
    return intersect_form(&c, h);
}

/* Everything about one ray, against the oracle. */
static void judge_exactly(const algsurf_extent *extent) {
    intersect_ask(&c, extent, NULL, &answer);
    exact_hits *h = exact_hits_of(c.terms, c.count, c.degree, extent, NULL, 0, &c.ray);
    const char *wrong = intersect_wrong(h, &answer);
    exact_hits_clear(h);
    if (!wrong) wrong = intersect_wrong_packet(&c, extent, NULL, &answer);
    if (!wrong) wrong = form(&answer.first);
    for (int i = 0; !wrong && i < answer.count; i++) wrong = form(answer.all + i);
    if (wrong) intersect_fail(wrong, &c, &answer);
}

/* How long the integers of the exact ray get. */
static int is_short(void) {
    double x[6 + MOST_TERMS] = {0};
    for (int k = 0; k < 3; k++) x[k] = c.ray.origin[k], x[3 + k] = c.ray.direction[k];
    int ray = fuzz_span(x, 6);
    for (int i = 0; i < c.count; i++) x[i] = c.terms[i].a;
    return c.degree <= TOP && (ray + 53) * c.degree + fuzz_span(x, c.count) < MOST_BITS;
}

static void judge(const algsurf_extent *extent) {
    static packet p;
    ask_packets(&p, extent);
    check_lanes(&p, extent);
    for (int i = 0; i < LANES; i++) {
        c.ray = ray_of(&p, i);
        if (is_short()) judge_exactly(extent);
    }
}

static int read_surface(fuzz_numbers *in) {
    algsurf_term terms[MOST_TERMS];
    int count = 0;
    for (; count < MOST_TERMS && fuzz_left(in) > 0; count++) {
        int i = fuzz_whole(in, 0, MOST_DEGREE), j = fuzz_whole(in, 0, MOST_DEGREE - i);
        int k = fuzz_whole(in, 0, MOST_DEGREE - i - j);
        terms[count] = (algsurf_term){i, j, k, fuzz_finite(in)};
    }
    return count > 0 && intersect_terms(&c, terms, count);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_numbers in = fuzz_numbers_of(data, size);
    algsurf_extent extent;
    for (int k = 0; k < 3; k++) c.ray.origin[k] = fuzz_finite(&in);
    for (int k = 0; k < 3; k++) c.ray.direction[k] = fuzz_finite(&in);
    c.ray.t_min = fuzz_any(&in), c.ray.t_max = fuzz_any(&in);
    extent.kind = fuzz_whole(&in, 0, 2);
    for (int k = 0; k < 3; k++) extent.centre[k] = fuzz_finite(&in);
    for (int k = 0; k < 3; k++) {
        double s = fabs(fuzz_finite(&in));
        extent.size[k] = s > 0 ? s : 1;
    }
    const double *d = c.ray.direction;
    fuzz_loud_judges();
    if (isnan(c.ray.t_min) || isnan(c.ray.t_max) || (d[0] == 0 && d[1] == 0 && d[2] == 0)) return 0;
    if (!read_surface(&in)) return 0;
    judge(extent.kind == ALGSURF_EXTENT_ALL ? NULL : &extent);
    algsurf_surface_free(c.surface);
    return 0;
}
