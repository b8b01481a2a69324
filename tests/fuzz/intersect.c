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

static void ask(packet_case *p, int count, const algsurf_extent *extent, const char *kernel) {
    const algsurf_intersect_options options = {.size = sizeof options, .kernel = kernel};
    fuzz_check(packet_ask(p, 0, count, c.surface, extent, &options) == ALGSURF_OK);
}

/* The ray, as first of a packet with its like: backwards, moved, cut, and along the axes. */
static void ask_packets(packet_case *p, const algsurf_extent *extent) {
    static packet_case other;
    algsurf_ray ray = c.ray;
    packet_put(p, 0, &c.ray);
    for (int k = 0; k < 3; k++) ray.direction[k] = -ray.direction[k];
    packet_put(p, 1, &ray);
    ray = c.ray, ray.origin[0] = ray.origin[0] / 2 + 0.125;
    packet_put(p, 2, &ray);
    ray = c.ray, ray.t_max = ray.t_min;
    packet_put(p, 3, &ray);
    packet_put(p, 4, &(algsurf_ray){{0.25, 0.5, -3}, {0, 0, 1}, 0, INFINITY});
    other = *p;
    ask(p, LANES, extent, NULL);
    ask(&other, 1, extent, NULL);
    const algsurf_hit among = packet_hit(p, 0), alone = packet_hit(&other, 0);
    fuzz_check(memcmp(&among, &alone, sizeof alone) == 0 && p->occluded[0] == other.occluded[0]);
    const char *kernel;
    for (int i = 0; (kernel = algsurf_kernel_name(i)); i++) {
        ask(&other, LANES, extent, kernel);
        fuzz_check(memcmp(p, &other, sizeof other) == 0);
    }
}

static void check_lanes(const packet_case *p, const algsurf_extent *extent) {
    const algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};
    for (int i = 0; i < LANES; i++) {
        algsurf_ray ray = packet_ray(p, i);
        algsurf_hit hit;
        int occluded;
        fuzz_check(packet_wrong(p, i, c.surface, extent, NULL, &hit) == NULL);
        fuzz_check(hit.state != ALGSURF_STATE_UNDECIDED && p->occluded[i] == hit.state);
        fuzz_check(algsurf_intersect_first(c.surface, extent, &ray, &bounded, &hit) == ALGSURF_OK);
        fuzz_check(algsurf_occluded(c.surface, extent, &ray, &bounded, &occluded) == ALGSURF_OK);
        fuzz_check(hit.state == ALGSURF_STATE_UNDECIDED || hit.state == p->state[i]);
        fuzz_check(occluded == ALGSURF_STATE_UNDECIDED || occluded == p->occluded[i]);
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
    static packet_case p;
    ask_packets(&p, extent);
    check_lanes(&p, extent);
    for (int i = 0; i < LANES; i++) {
        c.ray = packet_ray(&p, i);
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
    unit_release();
    return 0;
}
