/* intersect_case.h - judges what intersect says about a surface, which the test's end releases, and a ray. */
#ifndef INTERSECT_CASE_H
#define INTERSECT_CASE_H
#include "exact_hits.h"
#include "packet_case.h"
#include "scenes.h"

#include "algsurf/camera.h"
#include "algsurf/intersect.h"
#include "../lib/surface/impl.h"
#include "unit.h"

enum { INTERSECT_TERMS = 2200 };

typedef struct intersect_case {
    algsurf_surface *surface;
    algsurf_term terms[INTERSECT_TERMS];
    int count, degree;
    int is_power; /* 1: doubles may decide multiple roots, too */
    algsurf_ray ray;
} intersect_case;

typedef struct intersect_answer {
    algsurf_hit first, all[ALGSURF_MAX_DEGREE + 1];
    int count;
    int occluded;
} intersect_answer;

/* From terms, or from an equation; the terms are those the library keeps. */
static inline void intersect_surface(intersect_case *c, algsurf_surface *surface) {
    c->surface = surface_kept(surface), c->is_power = surface->root != NULL;
    c->count = (int)algsurf_surface_term_count(surface), c->degree = algsurf_surface_degree(surface);
    assert_ok(algsurf_surface_terms(surface, c->terms));
}

static inline int intersect_terms(intersect_case *c, const algsurf_term *terms, int count) {
    algsurf_surface *surface = NULL;
    if (algsurf_surface_from_terms(terms, (size_t)count, &surface) != ALGSURF_OK) return 0;
    intersect_surface(c, surface);
    return 1;
}

/* Of degree n at most, from some terms, the coefficients whole numbers or not. */
static inline int intersect_random(intersect_case *c, uint64_t *seed, int n, int small) {
    algsurf_term terms[24];
    int count = 2 + random_int(seed, 20);
    for (int i = 0; i < count; i++) {
        int e[3] = {0, 0, 0}, total = i == 0 ? n : random_int(seed, n + 1);
        while (total-- > 0) e[random_int(seed, 3)]++;
        double a = small ? random_int(seed, 9) - 4 : random_wide(seed, -2, 2);
        terms[i] = (algsurf_term){e[0], e[1], e[2], a};
    }
    return intersect_terms(c, terms, count);
}

static inline void intersect_equation(intersect_case *c, const char *text) {
    algsurf_surface *surface = NULL;
    assert_ok(algsurf_surface_from_equation(text, NULL, 0, &surface, NULL));
    intersect_surface(c, surface);
}

static inline _Noreturn void intersect_fail(const char *what, const intersect_case *c,
                                            const intersect_answer *a) {
    for (int i = 0; i < c->count; i++)
        fprintf(stderr, "{%d, %d, %d, %a}, ", c->terms[i].i, c->terms[i].j, c->terms[i].k, c->terms[i].a);
    fprintf(stderr, "\n");
    exact_print_doubles("origin", c->ray.origin, 3), exact_print_doubles("direction", c->ray.direction, 3);
    for (int i = -1; i < a->count; i++) {
        const algsurf_hit *h = i < 0 ? &a->first : a->all + i;
        fprintf(stderr, "%s: state %d reason %d multiplicity %d side %d at %a in [%a, %a]\n",
                i < 0 ? "first" : "all", h->state, (int)h->reason, h->multiplicity, h->side, h->t, h->t_lo,
                h->t_hi);
    }
    fail_msg("%s: degree %d, t in [%a, %a], occluded %d", what, c->degree, c->ray.t_min, c->ray.t_max,
             (int)a->occluded);
    abort();
}

static inline void intersect_ask(const intersect_case *c, const algsurf_extent *extent,
                                 const algsurf_intersect_options *options, intersect_answer *a) {
    memset(a, 0, sizeof *a);
    assert_ok(algsurf_intersect_first(c->surface, extent, &c->ray, options, &a->first));
    assert_ok(algsurf_intersect_all(c->surface, extent, &c->ray, options, a->all, ALGSURF_MAX_DEGREE + 1,
                                    &a->count));
    assert_ok(algsurf_occluded(c->surface, extent, &c->ray, options, &a->occluded));
}

static inline int intersect_unit(const double n[3]) {
    return fabs(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1) < 1e-14;
}

/* One hit by itself: its numbers are finite where they must be, in order, and tell the same place. */
static inline const char *intersect_form(const intersect_case *c, const algsurf_hit *h) {
    if (h->state == ALGSURF_STATE_MISS) {
        int empty = h->t == INFINITY && h->t_lo == INFINITY && h->t_hi == INFINITY && h->reason == ALGSURF_OK;
        empty = empty && h->multiplicity == 0;
        for (int i = 0; i < 3; i++) empty = empty && h->position[i] == 0 && h->normal[i] == 0;
        return empty ? NULL : "a miss with numbers";
    }
    if ((h->state == ALGSURF_STATE_HIT) != (h->reason == ALGSURF_OK)) return "reason";
    if (h->state == ALGSURF_STATE_UNDECIDED && h->reason < 0) return "reason";
    if (!(h->t_lo <= h->t && h->t <= h->t_hi)) return "t outside of its interval";
    if (c->is_power == 0 && h->multiplicity > 1 && h->t_hi > nextafter(h->t_lo, INFINITY))
        return "a wide interval";
    if (!(c->ray.t_min <= h->t_lo && h->t_hi <= c->ray.t_max)) return "outside of the ray";
    int singular = h->normal[0] == 0 && h->normal[1] == 0 && h->normal[2] == 0;
    if (!singular && !intersect_unit(h->normal)) return "normal is not of unit length";
    /* (beyond the largest double the position may be that of the root itself) */
    int beyond = h->state == ALGSURF_STATE_HIT && (isinf(h->t_lo) || isinf(h->t_hi));
    for (int i = 0; i < 3 && isfinite(h->t) && !beyond; i++) {
        double x = fma(h->t, c->ray.direction[i], c->ray.origin[i]);
        double size = fabs(c->ray.origin[i]) + fabs(h->t * c->ray.direction[i]);
        if (h->t_hi <= nextafter(h->t_lo, INFINITY)) /* of the root itself, which is between two doubles */
            size += 0x1p50 * (h->t_hi - h->t_lo) * fabs(c->ray.direction[i]);
        double far =
            fmax(fabs(h->t_lo), fabs(h->t_hi)) * fabs(c->ray.direction[i]); /* offsets are doubled doubles */
        if (!(fabs(h->position[i] - x) <= 0x1p-50 * size + (isfinite(far) ? 0x1p-90 * (far + 1) : 0x1p-90)))
            return "position is not origin + t direction";
    }
    return NULL;
}

/* The exact roots against the intervals of the hits: every hit isolates one, and all roots are in them. */
static inline const char *intersect_truth(const intersect_case *c, const exact_sturm *s,
                                          const intersect_answer *a) {
    double lo = c->ray.t_min, hi = c->ray.t_max;
    int outside = exact_count_roots(s, lo, hi), total = outside;
    for (int i = 0; i < a->count; i++) {
        const algsurf_hit *h = a->all + i;
        int inside = exact_count_roots(s, h->t_lo, h->t_hi);
        if (h->state == ALGSURF_STATE_HIT && inside < 1) return "a hit without a root";
        if (i > 0 && !(h[-1].t <= h->t && h[-1].t_lo <= h->t_lo && h[-1].t_hi <= h->t_hi))
            return "hits out of order";
        outside -= inside;
    }
    if (outside > 0) return "a root outside of the hits"; /* below 0: intervals overlap by their rounding */
    const algsurf_hit *f = &a->first;
    if (f->state == ALGSURF_STATE_MISS && total > 0) return "a first miss where there is a root";
    if (a->occluded == ALGSURF_STATE_MISS && total > 0) return "not occluded where there is a root";
    if (f->state == ALGSURF_STATE_HIT && exact_count_roots(s, f->t_lo, f->t_hi) < 1)
        return "a first hit without a root";
    if (f->state != ALGSURF_STATE_MISS &&
        exact_count_roots(s, lo, f->t_lo) > exact_count_roots(s, f->t_lo, f->t_lo) &&
        exact_count_roots(s, lo, nextafter(f->t_lo, -INFINITY)) > 0)
        return "a root before the first hit";
    double before = f->t - 0x1p-49 * fabs(f->t); /* from there to t no double tells roots apart */
    if (f->state == ALGSURF_STATE_HIT && exact_count_roots(s, lo, f->t_hi) != 1 && before >= lo &&
        exact_count_roots(s, lo, before) > 0 && exact_count_roots(s, lo, f->t) > 1)
        return "the first hit is a later root";
    if (a->occluded == ALGSURF_STATE_HIT && total == 0) return "occluded by nothing";
    return NULL;
}

/* Three calls, one truth. */
static inline const char *intersect_agree(const intersect_answer *a) {
    if ((a->count == 0) != (a->first.state == ALGSURF_STATE_MISS)) return "first and all disagree";
    int any = 0;
    for (int i = 0; i < a->count; i++) any = any || a->all[i].state == ALGSURF_STATE_HIT;
    if (a->count > 0 && a->first.state != a->all[0].state) return "first is not the first of all";
    if (a->count > 0 && !(a->first.t_lo <= a->all[0].t_hi && a->all[0].t_lo <= a->first.t_hi))
        return "first is elsewhere";
    if (a->first.state == ALGSURF_STATE_UNDECIDED &&
        (a->first.t_lo != a->all[0].t_lo || a->first.t_hi != a->all[0].t_hi))
        return "first is undecided elsewhere than all";
    int wanted = a->count == 0 ? ALGSURF_STATE_MISS : any ? ALGSURF_STATE_HIT : ALGSURF_STATE_UNDECIDED;
    /* an odd number of hits that cannot be told apart is a hit for occluded alone */
    return a->occluded == wanted || (wanted == ALGSURF_STATE_UNDECIDED && a->occluded == ALGSURF_STATE_HIT)
               ? NULL
               : "occluded disagrees";
}

/* |t - exact root| in units of what rounding P's input at the hit can do, u S(X)/|p'(t)|, for a hit that
 * isolates its root.  width: null, or receives t_hi - t_lo in the same units. */
static inline double intersect_error(const intersect_case *c, exact_line *line, const exact_sturm *s,
                                     const algsurf_hit *h, double *width) {
    double lo = h->t_lo, hi = h->t_hi, reach = fabs(h->t) * 0.5 + 1e-3;
    lo = fmax(lo, h->t - reach), hi = fmin(hi, h->t + reach);
    if (exact_count_roots(s, lo, hi) != 1) return exact_count_roots(s, h->t_lo, h->t_hi) == 1 ? 1e300 : 0;
    double root = exact_root(s, lo, hi, 0), slope = 0, size = 0;
    mpq_t q;
    mpq_init(q);
    for (int k = line->degree; k >= 1; k--) {
        exact_line_coefficient(q, line, k);
        slope = slope * root + k * mpq_get_d(q);
    }
    exact_line magnitudes = exact_magnitudes_of(c->terms, c->count, c->degree, &c->ray);
    for (int k = line->degree; k >= 0; k--) {
        exact_line_coefficient(q, &magnitudes, k);
        size = size * fabs(root) + mpq_get_d(q);
    }
    exact_line_clear(&magnitudes);
    mpq_clear(q);
    double unit = 0x1p-53 * (size / fabs(slope) + fabs(root)) + 0x1p-90;
    if (width) *width = (h->t_hi - h->t_lo) / unit;
    return fabs(h->t - root) / unit;
}

/* ---- what is decided, against the oracle ---- */

/* A hit against the i-th root. */
static inline const char *intersect_wrong_hit(const exact_hits *h, int i, const algsurf_hit *hit) {
    const exact_place *place = h->place + i;
    if (hit->state != ALGSURF_STATE_HIT || hit->reason != ALGSURF_OK) return "a root is no hit";
    if (hit->multiplicity != place->multiplicity) return "multiplicity";
    if (hit->side != place->side) return "side";
    if (!(hit->t_lo <= hit->t && hit->t <= hit->t_hi && isfinite(hit->t))) return "t outside of its interval";
    if (exact_compare(h, i, hit->t_lo) > 0 || exact_compare(h, i, hit->t_hi) < 0) return "not enclosed";
    return NULL;
}

/* A ray in the surface that has no begin, and no extent: a hit at the largest negative number. */
static inline const char *intersect_wrong_infinite(const intersect_answer *a) {
    const algsurf_hit *hit = &a->first;
    if (a->count != 1 || a->occluded != ALGSURF_STATE_HIT) return "not one hit";
    if (hit->state != ALGSURF_STATE_HIT || hit->multiplicity != 0 || hit->side != 0) return "no hit";
    return hit->t == -DBL_MAX && hit->t_lo == (double)-INFINITY ? NULL : "t of a hit at infinity";
}

/* First, all and occluded against the oracle: everything is decided, and right. */
static inline const char *intersect_wrong(const exact_hits *h, const intersect_answer *a) {
    if (h->infinite) return intersect_wrong_infinite(a);
    const char *wrong = a->count != h->count ? "number of hits" : NULL;
    for (int i = 0; !wrong && i < h->count; i++) wrong = intersect_wrong_hit(h, i, a->all + i);
    if (wrong) return wrong;
    if (a->first.state != (h->count ? ALGSURF_STATE_HIT : ALGSURF_STATE_MISS)) return "first";
    if (a->occluded != (h->count ? ALGSURF_STATE_HIT : ALGSURF_STATE_MISS)) return "occluded";
    if (h->count) return intersect_wrong_hit(h, 0, &a->first);
    if (h->in_surface) return a->first.side == 0 ? NULL : "side of a ray in the surface";
    if (a->first.side == 0) return h->is_short ? NULL : "a miss without side";
    return h->end_sign == EXACT_NOT_KNOWN || a->first.side == h->end_sign ? NULL : "side of a miss";
}

/* The calls for packets say the same bits as the single ones. */
static inline const char *intersect_wrong_packet(const intersect_case *c, const algsurf_extent *extent,
                                                 const algsurf_intersect_options *options,
                                                 const intersect_answer *a) {
    static packet_case p;
    algsurf_hit hit, first = a->first;
    packet_put(&p, 0, &c->ray);
    if (packet_ask(&p, 0, 1, c->surface, extent, options) != ALGSURF_OK) return "packet";
    hit = packet_hit(&p, 0);
    first.reason = ALGSURF_OK;
    return memcmp(&hit, &first, sizeof hit) == 0 && p.occluded[0] == a->occluded
               ? NULL
               : "a packet says something else";
}

/* The same calls, told to count hits of one side only. */
static inline const char *intersect_wrong_side(const intersect_case *c, const algsurf_extent *extent,
                                               const algsurf_intersect_options *options, int side,
                                               const exact_hits *h) {
    static intersect_answer a;
    algsurf_intersect_options one = {.size = sizeof one};
    exact_hits left = *h;
    if (options) one = *options;
    one.side = side;
    left.count = 0;
    left.infinite = 0;
    for (int i = 0; i < h->count; i++)
        if (h->place[i].side == side) left.place[left.count++] = h->place[i];
    intersect_ask(c, extent, &one, &a);
    const char *wrong = intersect_wrong(&left, &a);
    return wrong ? wrong : intersect_wrong_packet(c, extent, &one, &a);
}

/* Everything that must be true of one ray in an extent (null: all of space); null if it is. */
static inline const char *intersect_verdict(const intersect_case *c, const algsurf_extent *extent,
                                            const algsurf_intersect_options *options, intersect_answer *a) {
    intersect_ask(c, extent, options, a);
    const char *wrong = intersect_wrong_packet(c, extent, options, a);
    if (options && options->tier == ALGSURF_TIER_BOUNDED) {
        exact_sturm s = exact_sturm_along(c->terms, c->count, c->degree, &c->ray);
        if (!wrong && !extent && s.count > 0) wrong = intersect_truth(c, &s, a);
        exact_sturm_clear(&s);
    } else if (!wrong) {
        exact_hits *h = exact_hits_of(c->terms, c->count, c->degree, extent, options ? options->planes : NULL,
                                      options ? options->plane_count : 0, &c->ray);
        wrong = intersect_wrong(h, a);
        for (int side = -1; !wrong && side <= 1; side += 2)
            wrong = intersect_wrong_side(c, extent, options, side, h);
        exact_hits_clear(h);
    }
    if (!wrong) wrong = intersect_form(c, &a->first);
    for (int i = 0; !wrong && i < a->count; i++) wrong = intersect_form(c, a->all + i);
    return wrong;
}

static inline void intersect_judge_in(const intersect_case *c, const algsurf_extent *extent,
                                      const algsurf_intersect_options *options, intersect_answer *a) {
    const char *wrong = intersect_verdict(c, extent, options, a);
    if (extent && wrong) {
        fprintf(stderr, "extent of kind %d\n", (int)extent->kind);
        exact_print_doubles("centre", extent->centre, 3), exact_print_doubles("size", extent->size, 3);
    }
    if (wrong) intersect_fail(wrong, c, a);
}

static inline void intersect_judge(const intersect_case *c, const algsurf_intersect_options *options,
                                   intersect_answer *a) {
    intersect_judge_in(c, NULL, options, a);
}

#endif
