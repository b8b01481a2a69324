/* extremes_truth.c - see extremes.h.
 *
 * P along the ray in double-double, from its terms, with everything scaled by powers of two beforehand: each
 * coordinate, t, and the terms, so that the largest of each is about 1 and neither overflows nor loses its
 * lower half.
 */
#include "extremes.h"
#include "twofold.h"

#include <limits.h>
#include <math.h>

/* ---- P along a ray ---- */

static int exponent(double x) {
    int e;
    (void)frexp(x, &e);
    return e;
}

/* P, t P'(t) and S at a place, all three times the same power of two. */
typedef struct place {
    twofold p, slope;
    double size;
} place;

/* The powers of one coordinate x = o + t d, and of each the derivative times t. */
typedef struct powers {
    int exponent; /* of the coordinate, which was scaled by it */
    twofold power[ALGSURF_MAX_DEGREE + 1], slope[ALGSURF_MAX_DEGREE + 1];
} powers;

static void set_powers(powers *x, double o, double d, twofold t, int degree) {
    int shift = exponent(t.hi);
    double small = ldexp(t.hi, -shift), rest = ldexp(t.lo, -shift);
    int start = o != 0 ? exponent(o) : INT_MIN, way = d != 0 ? exponent(d) + shift : INT_MIN;
    x->exponent = start > way ? start : way;
    if (x->exponent == INT_MIN) x->exponent = 0;
    double step = ldexp(d, shift - x->exponent);
    twofold along = multiply((twofold){small, rest}, twice(step));
    twofold at = add(twice(ldexp(o, -x->exponent)), along);
    x->power[0] = twice(1);
    x->slope[0] = twice(0);
    for (int n = 1; n <= degree; n++) {
        x->power[n] = multiply(x->power[n - 1], at);
        x->slope[n] = multiply(multiply(twice(n), x->power[n - 1]), along);
    }
}

static int term_exponent(const algsurf_term *a, const powers x[3]) {
    return exponent(a->a) + a->i * x[0].exponent + a->j * x[1].exponent + a->k * x[2].exponent;
}

static place place_at(const scene *s, size_t i, twofold t) {
    powers x[3];
    int degree = algsurf_surface_degree(s->surface), most = -1000000;
    for (int k = 0; k < 3; k++) set_powers(&x[k], s->ray[i].origin[k], s->ray[i].direction[k], t, degree);
    for (const algsurf_term *a = s->terms; a < s->terms + s->term_count; a++)
        if (term_exponent(a, x) > most) most = term_exponent(a, x);
    place at = {{0, 0}, {0, 0}, 0};
    for (const algsurf_term *a = s->terms; a < s->terms + s->term_count; a++) {
        twofold factor = twice(ldexp(a->a, term_exponent(a, x) - most - exponent(a->a)));
        twofold px = x[0].power[a->i], py = x[1].power[a->j], pz = x[2].power[a->k], pxy = multiply(px, py);
        twofold value = multiply(factor, multiply(pxy, pz));
        twofold slope = multiply(add(multiply(x[0].slope[a->i], py), multiply(px, x[1].slope[a->j])), pz);
        at.p = add(at.p, value);
        at.slope = add(at.slope, multiply(factor, add(slope, multiply(pxy, x[2].slope[a->k]))));
        at.size += fabs(value.hi);
    }
    return at;
}

/* ---- the root in an interval ---- */

static double unit_at(const place *at, twofold t) {
    return 0x1p-53 * fabs(t.hi) * (1 + at->size / fabs(at->slope.hi));
}

static int between(twofold t, twofold lo, twofold hi) {
    twofold above = add(t, (twofold){-lo.hi, -lo.lo}), below = add(hi, (twofold){-t.hi, -t.lo});
    return above.hi > 0 && below.hi > 0;
}

typedef struct bracket {
    twofold lo, hi;
    double begin, end; /* P there, times powers of two */
} bracket;

/* Returns whether P has different signs at the ends, or is 0 at one. */
static int set_bracket(bracket *b, const scene *s, size_t i, double lo, double hi) {
    b->lo = twice(lo);
    b->hi = twice(hi);
    b->begin = place_at(s, i, b->lo).p.hi;
    b->end = place_at(s, i, b->hi).p.hi;
    return (b->begin <= 0 && b->end >= 0) || (b->begin >= 0 && b->end <= 0);
}

/* The interval of an answer; a part of it, 8 units on both sides of t, where its end, rounded outward, has
 * passed the next root; more and more of an infinite one. */
static int find_bracket(bracket *b, const scene *s, size_t i, const answers *a, double unit) {
    double t = a->t[i], lo = a->t_lo[i], hi = a->t_hi[i], next = 2 * t;
    if (isfinite(hi))
        return set_bracket(b, s, i, lo, hi) ||
               set_bracket(b, s, i, fmax(lo, t - 8 * unit), fmin(hi, t + 8 * unit));
    while (isfinite(next) && !set_bracket(b, s, i, lo, next)) next *= 2;
    return isfinite(next);
}

/* Newton's method from t, with bisection where it leaves the bracket, to 2^-10 of a unit.  The unit stays
 * infinite where it does not come so far. */
static void polish(const scene *s, size_t i, const answers *a, truth *known) {
    enum { STEPS = 300 };
    bracket b;
    twofold t = twice(a->t[i]);
    place at = place_at(s, i, t);
    double unit = unit_at(&at, t);
    if (a->t_hi[i] - a->t_lo[i] <= 0x1p-6 * unit) { /* t is as good as the root */
        known->unit = unit;
        return;
    }
    if (!find_bracket(&b, s, i, a, unit)) return;
    if (b.begin == 0) t = b.lo;
    if (b.end == 0 && b.begin != 0) t = b.hi;
    for (int k = 0; k < STEPS; k++) {
        at = place_at(s, i, t);
        unit = unit_at(&at, t);
        double step = at.p.hi == 0 ? 0 : -t.hi * (at.p.hi / at.slope.hi);
        if (fabs(step) <= 0x1p-10 * unit) {
            t = add(t, twice(step));
            known->root = t.hi;
            known->rest = t.lo;
            known->unit = unit;
            return;
        }
        if ((at.p.hi > 0) == (b.begin > 0))
            b.lo = t;
        else
            b.hi = t;
        t = add(t, twice(step));
        if (!between(t, b.lo, b.hi)) {
            twofold all = add(b.lo, b.hi);
            t = (twofold){0.5 * all.hi, 0.5 * all.lo};
        }
    }
}

truth scene_truth(const scene *s, size_t i, const answers *certified) {
    truth known = {s->expected[i], certified->t[i], 0, INFINITY};
    if (known.state == ALGSURF_STATE_UNDECIDED) known.state = certified->state[i];
    if (known.state == ALGSURF_STATE_HIT && certified->state[i] == ALGSURF_STATE_HIT)
        polish(s, i, certified, &known);
    return known;
}

/* ---- answers ---- */

const char *const manner_names[MANNERS] = {"bounded", "certified", "packet"};

static int ask_packet(const scene *s, const answers *a) {
    const algsurf_hit_packet hits = {
        .size = sizeof hits, .state = a->state, .t = a->t, .t_lo = a->t_lo, .t_hi = a->t_hi};
    return algsurf_intersect_packet(s->surface, &s->extent, &s->packet, NULL, &hits) == ALGSURF_OK;
}

int scene_ask(const scene *s, manner m, const answers *a) {
    static const int tiers[] = {ALGSURF_TIER_BOUNDED, ALGSURF_TIER_CERTIFIED};
    if (m == MANNER_PACKET) return ask_packet(s, a);
    const algsurf_intersect_options options = {.size = sizeof options, .tier = tiers[m]};
    for (size_t i = 0; i < s->count; i++) {
        algsurf_hit hit;
        if (algsurf_intersect_first(s->surface, &s->extent, &s->ray[i], &options, &hit) != ALGSURF_OK)
            return 0;
        a->state[i] = (unsigned char)hit.state;
        a->t[i] = hit.t;
        a->t_lo[i] = hit.t_lo;
        a->t_hi[i] = hit.t_hi;
    }
    return 1;
}

/* ---- judgement ---- */

/* Is the root before x?  And after it? */
static int is_before(const truth *known, double x) { return (known->root - x) + known->rest < 0; }
static int is_after(const truth *known, double x) { return (known->root - x) + known->rest > 0; }

verdict judge(const truth *known, const answers *a, size_t i) {
    verdict v = {NULL, a->state[i] == ALGSURF_STATE_UNDECIDED, NAN};
    int is_hit = a->state[i] == ALGSURF_STATE_HIT,
        precise = known->state == ALGSURF_STATE_HIT && isfinite(known->unit);
    if (known->state == ALGSURF_STATE_UNDECIDED) return v;
    if (is_hit && known->state == ALGSURF_STATE_MISS) v.wrong = "a hit where there is no root";
    if (a->state[i] == ALGSURF_STATE_MISS && known->state == ALGSURF_STATE_HIT)
        v.wrong = "a miss where there is a root";
    if (precise && v.undecided && is_before(known, a->t_lo[i]))
        v.wrong = "a root before the undecided interval";
    if (!precise || !is_hit) return v;
    v.error = fabs((a->t[i] - known->root) - known->rest) / known->unit;
    if (is_before(known, a->t_lo[i]) || is_after(known, a->t_hi[i])) v.wrong = "not the first root";
    return v;
}
