/* test_extremes.c - the scenes of the benchmark `extremes`, every answer judged by exact arithmetic: no hit
 * or miss is wrong in the tiers bounded and certified and in packets, and none undecided but in the bounded
 * one, the interval of a hit encloses the first root and none but that, t is within a few units
 * (extremes.h) of it; and what the benchmark, which has double-double only, takes for the truth is
 * true.
 *
 * Inside an extent the roots come from Descartes' rule and bisection over integers (exact_pixel.h); along
 * rays without end, where they may be hundreds of orders apart, from a Sturm chain.  A root closer to an end
 * of the extent than ROOM rounding errors of t may count or not: such rays are passed over.
 *
 * Breaks caught, each tried: error bounds left out, of single rays and of packets; the final Newton steps
 * left out; ends of exact intervals moved inward; a left half with one root passed over; double-double in the
 * benchmark without its lower half; a ray on the wrong side of what it grazes.
 *
 *     test_extremes [rays [seed]]     rays of a scene; default: 3 and 1
 */
#include "exact_pixel.h"
#include "extremes.h"
#include "unit.h"

enum { ROOM = 16, BITS = 2400 };

static const double end_error = 0x1p-50; /* of t_lo, t_hi, which are rounded outward: relative */

ARGUMENT(1, int, rays, 3)
ARGUMENT(2, int, seed, 1)

/* ---- the truth ---- */

typedef struct exact_truth {
    int known;   /* 0: a root is too close to an end of the extent */
    truth first; /* its unit is set for a hit */
    double next; /* the second root, or the double below; infinite: there is none */
} exact_truth;

static void roots_inside(const scene *s, const algsurf_ray *ray, const exact_line *line, exact_truth *found) {
    mpf_t in, out;
    mpf_init2(in, PIXEL_BITS), mpf_init2(out, PIXEL_BITS);
    if (exact_inside(&s->extent, ray, in, out)) {
        double room = ROOM * 0x1p-53 * fabs(mpf_get_d(out));
        exact_answer a = exact_first_roots(line, &s->extent, ray, room, 2);
        for (int i = 0; i < a.count && i < 2; i++) found->known &= a.is_sure[i] && !a.clustered;
        if (a.count > 0) found->first = (truth){ALGSURF_STATE_HIT, a.t[0], a.rest[0], 0};
        if (a.count > 1) found->next = a.t[1];
    }
    mpf_clears(in, out, NULL);
}

/* The k-th root > 0 of all, k = 0, 1, ..: first its power of two. */
static double far_root(const exact_sturm *chain, int k) {
    int low = -1074, high = 1023;
    while (low < high) {
        int middle = (int)floor(0.5 * (low + high));
        if (exact_count_roots(chain, 0, ldexp(1, middle)) > k)
            high = middle;
        else
            low = middle + 1;
    }
    double from = ldexp(1, low - 1);
    return exact_root(chain, from, ldexp(1, low), k - exact_count_roots(chain, 0, from));
}

/* One step of Newton's method from the double below the root. */
static double exact_rest(const exact_line *line, double root) {
    mpq_t t, p, slope, c;
    mpq_inits(t, p, slope, c, NULL);
    exact_set(t, root);
    for (int k = line->degree; k >= 0; k--) {
        mpq_mul(slope, slope, t), mpq_add(slope, slope, p);
        exact_line_coefficient(c, line, k);
        mpq_mul(p, p, t), mpq_add(p, p, c);
    }
    if (mpq_sgn(slope) != 0) mpq_div(p, p, slope);
    double rest = -mpq_get_d(p);
    mpq_clears(t, p, slope, c, NULL);
    return rest;
}

static void roots_without_end(const exact_line *line, exact_truth *found) {
    exact_sturm chain = exact_sturm_of(line->c, line->degree);
    int count = exact_count_roots(&chain, 0, INFINITY);
    if (count > 0) {
        double root = far_root(&chain, 0);
        found->first = (truth){ALGSURF_STATE_HIT, root, exact_rest(line, root), 0};
        if (count > 1) found->next = far_root(&chain, 1);
    }
    exact_sturm_clear(&chain);
}

/* u (S / |P'(t)| + |t|) at the root, from the definition. */
static double exact_unit(const scene *s, const algsurf_ray *ray, const exact_line *line, const truth *at) {
    mpf_t t, x[3], power, size, slope, c;
    mpq_t q;
    mpq_init(q);
    mpf_init2(t, BITS), mpf_init2(power, BITS), mpf_init2(size, BITS), mpf_init2(slope, BITS);
    mpf_init2(c, BITS);
    mpf_set_d(t, at->root), mpf_set_d(c, at->rest), mpf_add(t, t, c);
    for (int k = 0; k < 3; k++) {
        mpf_init2(x[k], BITS);
        mpf_set_d(x[k], ray->direction[k]), mpf_mul(x[k], x[k], t);
        mpf_set_d(c, ray->origin[k]), mpf_add(x[k], x[k], c), mpf_abs(x[k], x[k]);
    }
    for (const algsurf_term *term = s->terms; term < s->terms + s->term_count; term++) {
        const int e[3] = {term->i, term->j, term->k};
        mpf_set_d(c, fabs(term->a));
        for (int k = 0; k < 3; k++) mpf_pow_ui(power, x[k], (unsigned long)e[k]), mpf_mul(c, c, power);
        mpf_add(size, size, c);
    }
    for (int k = line->degree; k >= 1; k--) {
        exact_line_coefficient(q, line, k);
        mpf_set_q(c, q), mpf_mul_ui(c, c, (unsigned long)k), mpf_mul(slope, slope, t),
            mpf_add(slope, slope, c);
    }
    if (mpf_sgn(slope) != 0) mpf_div(size, size, slope), mpf_abs(size, size);
    double unit = 0x1p-53 * (mpf_get_d(size) + fabs(at->root));
    if (mpf_sgn(slope) == 0) unit = INFINITY;
    mpf_clears(t, x[0], x[1], x[2], power, size, slope, c, NULL), mpq_clear(q);
    return unit;
}

static exact_truth find_exact(const scene *s, size_t i) {
    exact_truth found = {1, {ALGSURF_STATE_MISS, 0, 0, 0}, INFINITY};
    algsurf_ray ray = s->ray[i];
    exact_line line = exact_line_of(s->terms, (int)s->term_count, algsurf_surface_degree(s->surface), &ray);
    if (s->extent.kind == ALGSURF_EXTENT_ALL)
        roots_without_end(&line, &found);
    else
        roots_inside(s, &ray, &line, &found);
    if (found.first.state == ALGSURF_STATE_HIT) found.first.unit = exact_unit(s, &ray, &line, &found.first);
    exact_line_clear(&line);
    return found;
}

/* ---- judgement ---- */

typedef struct tally {
    int asked, judged, hits, unmeasured, undecided[MANNERS];
} tally;

typedef struct stage {
    const sweep *sweep;
    int point, variant;
    scene scene;
    answers answers[MANNERS];
} stage;

static _Noreturn void refuse(const stage *at, size_t i, const char *who, const char *what, double number) {
    const scene *s = &at->scene;
    algsurf_ray ray = s->ray[i];
    for (size_t k = 0; k < s->term_count; k++)
        fprintf(stderr, "{%d, %d, %d, %a}, ", s->terms[k].i, s->terms[k].j, s->terms[k].k, s->terms[k].a);
    fprintf(stderr, "\nextent %d\n", (int)s->extent.kind);
    exact_print_doubles("centre", s->extent.centre, 3), exact_print_doubles("size", s->extent.size, 3);
    exact_print_doubles("origin", ray.origin, 3), exact_print_doubles("direction", ray.direction, 3);
    for (int m = 0; m < MANNERS; m++)
        fprintf(stderr, "%s: state %d at %a in [%a, %a]\n", manner_names[m], at->answers[m].state[i],
                at->answers[m].t[i], at->answers[m].t_lo[i], at->answers[m].t_hi[i]);
    fail_msg("seed %d, %s %g, scene %d, ray %zu of %d, %s: %s (%g)", seed, at->sweep->name,
             at->sweep->values[at->point], at->variant, i, rays, who, what, number);
    abort();
}

/* Answers of one ray in one manner. */
static void judge_answer(const stage *at, size_t i, const exact_truth *exact, manner m, int most_error,
                         tally *t) {
    const answers *a = &at->answers[m];
    verdict v = judge(&exact->first, a, i);
    t->undecided[m] += v.undecided;
    if (v.wrong) refuse(at, i, manner_names[m], v.wrong, exact->first.root);
    if (a->state[i] != ALGSURF_STATE_HIT) return;
    if (exact->next < a->t_hi[i] * (1 - end_error) && nextafter(exact->first.root, INFINITY) < exact->next)
        refuse(at, i, manner_names[m], "the interval holds the second root too", exact->next);
    if (v.error > most_error) refuse(at, i, manner_names[m], "far from the root", v.error);
}

/* What the benchmark believes. */
static void judge_belief(const stage *at, size_t i, const exact_truth *exact, tally *t) {
    truth believed = scene_truth(&at->scene, i, &at->answers[MANNER_CERTIFIED]);
    const truth *first = &exact->first;
    if (at->scene.expected[i] != ALGSURF_STATE_UNDECIDED && at->scene.expected[i] != first->state)
        refuse(at, i, "scene", "not what was expected", first->root);
    if (believed.state == ALGSURF_STATE_UNDECIDED) return;
    if (believed.state != first->state) refuse(at, i, "benchmark", "believes another state", first->root);
    if (believed.state != ALGSURF_STATE_HIT || at->answers[MANNER_CERTIFIED].state[i] != ALGSURF_STATE_HIT)
        return;
    double off = fabs((believed.root - first->root) + (believed.rest - first->rest)) / first->unit;
    t->unmeasured += !(off < 0.1) || !(fabs(believed.unit / first->unit - 1) < 0.1);
}

static void judge_scene(stage *at, int most_error, tally *t) {
    for (int m = 0; m < MANNERS; m++) assert_true(scene_ask(&at->scene, (manner)m, &at->answers[m]));
    for (size_t i = 0; i < at->scene.count; i++) {
        exact_truth exact = find_exact(&at->scene, i);
        t->asked++;
        if (!exact.known) continue;
        t->judged++, t->hits += exact.first.state == ALGSURF_STATE_HIT;
        for (int m = 0; m < MANNERS; m++) judge_answer(at, i, &exact, (manner)m, most_error, t);
        judge_belief(at, i, &exact, t);
    }
}

/* ---- the sweeps ---- */

/* Percent that may be undecided in the bounded tier, and that must hit; units of error. */
typedef struct limits {
    int bounded, hits, error;
} limits;

static void judge_sweep(int which, limits most) {
    stage at = {.sweep = &sweeps[which]};
    tally t = {0};
    for (int m = 0; m < MANNERS; m++) {
        size_t count = (size_t)rays;
        at.answers[m] = (answers){calloc(count, 1), calloc(count, sizeof(double)),
                                  calloc(count, sizeof(double)), calloc(count, sizeof(double))};
    }
    for (at.point = 0; at.point < at.sweep->points; at.point++)
        for (at.variant = 0; at.variant < at.sweep->variants; at.variant++) {
            scene_make(at.sweep, at.point, at.variant, (size_t)rays, seed, &at.scene);
            judge_scene(&at, most.error, &t);
            scene_free(&at.scene);
        }
    for (int m = 0; m < MANNERS; m++)
        free(at.answers[m].state), free(at.answers[m].t), free(at.answers[m].t_lo), free(at.answers[m].t_hi);
    printf("%s: %d rays, %d judged, %d hits, undecided: %d bounded, %d certified, %d packet\n",
           at.sweep->name, t.asked, t.judged, t.hits, t.undecided[MANNER_BOUNDED],
           t.undecided[MANNER_CERTIFIED], t.undecided[MANNER_PACKET]);
    if (t.judged * 100 < t.asked * 98 || t.hits * 100 < t.asked * most.hits || t.unmeasured * 100 > t.asked ||
        t.undecided[MANNER_BOUNDED] * 100 > t.asked * most.bounded || t.undecided[MANNER_PACKET] > 0 ||
        t.undecided[MANNER_CERTIFIED] > 0)
        fail_msg("%s, seed %d: too many, or too few", at.sweep->name, seed);
}

TEST(test_distance) { judge_sweep(0, (limits){0, 40, 8}); }

TEST(test_scale) { judge_sweep(1, (limits){0, 40, 8}); }

TEST(test_gap) { judge_sweep(2, (limits){57, 40, 8}); }

TEST(test_degree) { judge_sweep(3, (limits){34, 50, 8}); }

TEST(test_singular) { judge_sweep(4, (limits){42, 40, 8}); }

TEST(test_extent) { judge_sweep(5, (limits){1, 40, 8}); }

TEST(test_spread) { judge_sweep(6, (limits){75, 20, 100}); }

TEST(test_leading) { judge_sweep(7, (limits){50, 40, 8}); }
